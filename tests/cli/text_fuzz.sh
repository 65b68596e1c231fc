# Texts of every reader, and what pictures are told, changed at random
# (text_fuzz.py). TEXT_FUZZ=N asks for N
# cases, TEXT_FUZZ_SEED for others.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 1
cases=${TEXT_FUZZ:-60}
mkdir "$work/f"
python3 tests/cli/text_fuzz.py "$sanggwan" "$work/f" "$cases" \
  "${TEXT_FUZZ_SEED:-16}" >"$work/out" 2>"$work/err"
status=$? err=$(cat "$work/err")
head -c 6000 "$work/out"
check ended status_is 0
check no-fault silent out
printf 'counted: %d changed texts, %s\n' "$cases" "$(tail -n 1 "$work/err")"
python3 tests/cli/text_fuzz.py "$sanggwan" "$work/f" "$cases" \
  "${TEXT_FUZZ_SEED:-19}" pictures >"$work/out" 2>"$work/err"
status=$? err=$(cat "$work/err")
head -c 6000 "$work/out"
check pictures-ended status_is 0
check pictures-no-fault silent out
printf 'counted: %d pictures, %s\n' "$cases" "$(tail -n 1 "$work/err")"
finish
