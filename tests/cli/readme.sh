# readme.sh -- what README.md shows works as it stands there.
. "$(dirname "$0")/../check.sh"

cp -r README.md facts "$TMP"
ln -s "$B/sanggwan" "$TMP/sanggwan"
cd "$TMP" || exit 1

# Its command lines, one after the other.
lines=$(sed -n 's/^    \(\.\/sanggwan .*\)/\1/p' README.md)
check "there are commands" test "$(wc -l <<<"$lines")" -ge 5
while read -r line; do
  check "$line" bash -c "$line </dev/null"
done <<<"$lines"
while read -r file; do
  check "$file is there" test -s "$file"
done < <(grep -o -- '-o [^ ]*' <<<"$lines" | cut -c4-)

# Its session: every question has an answer.
model=$(sed -n 's/^    \$ \.\/sanggwan repl //p' README.md)
sed -n 's/^    ?- //p' README.md >goals
check "there are ten questions" test "$(wc -l <goals)" = 10
timeout -s KILL 120 ./sanggwan repl "$model" <goals >answers 2>errors
check "the session ends" test $? = 0
check "without an error" test ! -s errors
check "help was given" grep -q '^line(L, ' answers
check "exact coordinates" grep -Eq '[0-9]r[0-9]' answers
check_report
