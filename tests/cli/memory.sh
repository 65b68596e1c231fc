# memory.sh -- memory that runs out at any request of ours: no signal, no hang,
# status 4 with a message, no file, nothing held, and what comes next is right.
. "$(dirname "$0")/../check.sh"

random=6
[ -z "${TEST_ALL:-}" ] || random=300
mkdir "$TMP/out"

# tried SAY: the status; the log is $TMP/log.
tried() {
  env LD_PRELOAD="$B/tests/failing_malloc.so" timeout 1000 swipl \
    -p foreign="$B" tests/memory/out_of_memory.pl -- "$TMP/out" $random "$1" \
    >"$TMP/log" 2>&1
}
if tried 0; then
  grep '^counted: ' "$TMP/log"
else
  # One that ends the process is the last that is named.
  grep -q ' failed$' "$TMP/log" || tried 1
  grep -v '^case' "$TMP/log"
  grep '^case' "$TMP/log" | tail -n 1
fi
check "every case is right" grep -q '^[0-9]* passed, 0 failed$' "$TMP/log"

# The program itself.
for n in 3 30 300 3000; do
  check "the program ends at request $n" complains 4 'memory' \
    env LD_PRELOAD="$B/tests/failing_malloc.so" FAILING_REQUEST=$n \
    "$SANGGWAN" draw facts/figures/fig13.pl -o "$TMP/out/a.svg"
done
check "nothing is left" eval '[ -z "$(ls -A "$TMP/out")" ]'
check_report
