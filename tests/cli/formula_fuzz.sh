# Random formulas have the values that another evaluator computes
# (formula_fuzz.py). FORMULA_FUZZ=N asks for N, FORMULA_FUZZ_SEED for others.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 1
mkdir "$work/f"
python3 tests/cli/formula_fuzz.py "$sanggwan" "$work/f" \
  "${FORMULA_FUZZ:-2000}" "${FORMULA_FUZZ_SEED:-18}" >"$work/out" 2>"$work/err"
status=$? err=$(cat "$work/err")
head -c 6000 "$work/out"
check ended status_is 0
check something has ' formulas, ' "$work/out"
finish
