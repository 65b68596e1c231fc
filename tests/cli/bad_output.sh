#!/bin/bash
# bad_output.sh -- missing folders, full disks, interrupted runs.
# covers: progress
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
mkdir "$work/to"

run draw facts/cube.pl -o "$work/none/a.svg"
check 'no folder' status_is 2
check 'no folder: message' has "there is no folder $work/none"
check 'no folder: not made' absent "$work/none"
run convert facts/cube.pl -o "$work/to"/a.pl/b.pl
check 'folder below nothing' status_is 2

"$sanggwan" repl <<<"draw('$work/none/a.svg')." >"$work/out" 2>"$work/err"
check 'no folder, from a goal' has "there is no folder $work/none"

# An output that fails leaves the old file as it was.
echo old >"$work/to/a.svg"
run draw facts/no_such.pl -o "$work/to/a.svg"
check 'old file stays' is "$(cat "$work/to/a.svg")" old
check 'nothing beside it' holds "$work/to" a.svg

"$sanggwan" convert facts/cube.pl -o - >/dev/full 2>"$work/err"
status=$?
check 'full standard output' status_is 2
check 'full standard output: message' has 'No space left'
check 'full standard output: once' is "$(grep -c 'No space left' "$work/err")" 1
"$sanggwan" --help >&- 2>"$work/err"
status=$?
check 'closed standard output' status_is 2
check 'closed standard output: message' has 'cannot be written'

# A reader that ends early has no report, but the files are there.
while read -r file verb; do
  # shellcheck disable=SC2086
  "$sanggwan" $verb -o "$work/to/$file" 2>"$work/err" | true
  status=${PIPESTATUS[0]}
  check "nobody reads the report: $verb" status_is 141
  check "nobody reads the report: $file" [ -s "$work/to/$file" ]
done <<'VERBS'
early.svg unfold facts/patterns/saddle.pl --true
early.json unfold facts/patterns/saddle.pl --json
early.pl glue facts/cube.pl facts/pipe_tee.pl
early2.pl glue facts/cube.pl facts/pipe_tee.pl --json
early.stl union facts/two_cubes.pl --json
early.csv penetrate facts/two_cubes.pl --json
early.dot cells facts/two_rooms.pl
VERBS
rm "$work/to"/early*

run draw facts/cube.pl -o /proc/a.svg
check 'folder that takes nothing' status_is 2
check 'folder that takes nothing: message' \
  has '/proc/a.svg: the result may not be written there'

# A file that may not be written is not replaced; root may write all.
if [ "$(id -u)" = 0 ]; then
  chmod 755 "$work"
  chmod 777 "$work/to"
  as_nobody=(setpriv --reuid 65534 --regid 65534 --clear-groups)
else
  as_nobody=()
fi
cp "$B/sanggwan" facts/cube.pl "$work"
if "${as_nobody[@]}" "$work/sanggwan" --version >/dev/null 2>&1; then
  chmod 444 "$work/to/a.svg"
  "${as_nobody[@]}" "$work/sanggwan" draw "$work/cube.pl" -o "$work/to/a.svg" \
    >"$work/out" 2>"$work/err"
  status=$?
  check 'read-only file' status_is 2
  check 'read-only file: message' \
    has 'to/a.svg: the result may not be written there'
  check 'read-only file: as it was' is "$(cat "$work/to/a.svg")" old
  chmod 644 "$work/to/a.svg"
else
  skip 'no way to run as another user'
fi
rm -f "$work/sanggwan" "$work/cube.pl"

# A full disk: a tiny one, where the machine lets us mount it.
if mkdir "$work/disk" && mount -t tmpfs -o size=4k none "$work/disk" \
  2>/dev/null; then
  run draw facts/figures/fig13.pl -o "$work/disk/a.svg"
  check 'full disk' status_is 2
  check 'full disk: message' has 'a.svg'
  check 'full disk: nothing left' holds "$work/disk"
  umount "$work/disk"
else
  skip 'no right to mount a small disk'
fi

# Interrupted in a goal, in a load: well after the program catches SIGINT, which a
# busy machine lets it do late.
catches_interrupts() {
  (($((0x$(sed -n 's/^SigCgt:[[:space:]]*//p' "/proc/$1/status"))) & 2))
}
interrupted() {
  local name=$1
  shift
  "$sanggwan" "$@" >"$work/out" 2>"$work/err" &
  local pid=$!
  for _ in {1..200}; do
    catches_interrupts $pid && break
    sleep 0.05
  done
  sleep 0.7
  kill -INT $pid 2>/dev/null
  wait $pid
  status=$?
  check "$name: exit code" status_is 130
  check "$name: message" has 'interrupted'
}
set -m # else a background job ignores SIGINT
interrupted 'interrupted query' query facts/cube.pl 'repeat, fail'
if [ "$passed" -gt 0 ]; then
  # Quoted: such facts are read one by one.
  awk 'BEGIN { for (i = 1; i <= 700000; i++)
                 printf "\047v\047(1,%d,%d,0.5,0.25).\n", i, i }' >"$work/big.pl"
  interrupted 'interrupted load' convert "$work/big.pl" -o "$work/to/b.pl"
  check 'interrupted load: nothing left' holds "$work/to" a.svg
fi
# While it waits for a model that does not come: a pipe that stays open.
mkfifo "$work/pipe"
exec 8<>"$work/pipe"
interrupted 'interrupted wait' check - <"$work/pipe"
exec 8>&-

# Nothing runs over two seconds silently; -q is silent.
"$sanggwan" query facts/cube.pl 'sleep(2.4)' >"$work/out" 2>"$work/err"
check 'progress' has '2 s'
"$sanggwan" query -q facts/cube.pl 'sleep(2.4)' >"$work/out" 2>"$work/err"
check 'no progress' silent err
finish
