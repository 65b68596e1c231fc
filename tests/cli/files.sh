#!/bin/bash
# files.sh -- several outputs are all there or none, whatever stands in the way;
# what an old file was (mode, names, links) stays; temporary names cannot be
# guessed.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
to=$work/to

# The folder as it was: old files a.svg, b.svg.
anew() {
  rm -rf "$to"
  mkdir "$to"
  echo old >"$to/a.svg"
  echo old >"$to/b.svg"
}
untouched() {
  holds "$to" a.svg b.svg "$@" && [ "$(cat "$to/a.svg")" = old ] &&
    [ "$(cat "$to/b.svg")" = old ]
}

# The third of three refuses.
anew
run draw facts/cube.pl -o "$to/a.svg" -o "$to/b.svg" -o /dev/full --format svg
check 'full third' status_is 2
check 'full third: message' has '/dev/full cannot be written: the disk is full'
check 'full third: none' untouched
check 'full third: not said' hasnt wrote
run draw facts/cube.pl -o "$to/a.svg" -o "$to/b.svg" -o "$to/c.pdf" --lang ko
check 'three' holds "$to" a.svg b.svg c.pdf
check 'three: said, in order' is "$(grep -c 썼습니다 "$work/err")" 3
anew
"$sanggwan" draw facts/cube.pl -o "$to/a.svg" -o "$to/b.svg" --format svg -o - \
  >/dev/full 2>"$work/err"
status=$?
check 'full standard output' status_is 2
check 'full standard output: none' untouched

# Verbs that write many files: one of them is a folder.
anew
mkdir "$to/h-above.stl"
run split facts/cube.pl --plane 0,0,1,-0.5 -o "$to/h.stl"
check 'split into a folder' status_is 2
check 'split into a folder: message' has 'h-above.stl is a folder'
check 'split into a folder: none' untouched h-above.stl
anew
run unfold facts/patterns/house.pl --page A4 --scale 10:1 --tile \
  -o "$to/p.svg"
pages=$(ls "$to" | grep -c '^p-')
check 'tiles' test "$pages" -gt 2
anew
mkdir "$to/p-$pages.svg"
run unfold facts/patterns/house.pl --page A4 --scale 10:1 --tile \
  -o "$to/p.svg"
check 'tiles, the last a folder' status_is 2
check 'tiles, the last a folder: none' untouched "p-$pages.svg"

# A folder, before any work is done.
anew
mkdir "$to/d.svg"
run draw facts/no_such.pl -o "$to/d.svg"
check 'a folder' has 'd.svg is a folder'

# What the old file was.
anew
ln "$to/a.svg" "$to/b2.svg"
ln -s a.svg "$to/link.svg"
chmod 640 "$to/a.svg" "$to/b.svg"
inode=$(stat -c %i "$to/a.svg")
run draw facts/cube.pl -o "$to/link.svg" -o "$to/b.svg"
check 'hard link' is "$(stat -c '%i %h %a' "$to/a.svg")" "$inode 2 640"
check 'hard link: both' cmp -s "$to/b2.svg" "$to/b.svg"
check 'link' test -L "$to/link.svg"
check 'mode' is "$(stat -c %a "$to/b.svg")" 640
(umask 077 && exec "$sanggwan" draw -q facts/cube.pl -o "$to/new.svg")
check 'umask' is "$(stat -c %a "$to/new.svg")" 600

# Names: as long as they can be, in any letters; longer.
anew
long=$(printf '가%.0s' {1..83})xy.svg
run draw facts/cube.pl -o "$to/$long"
check '255 bytes' test -s "$to/$long"
run draw facts/cube.pl -o "$to/x$long"
check '256 bytes' status_is 2
check '256 bytes: message' has 'the name is too long'

# The output is the input.
cp facts/cube.pl "$to/m.pl"
run convert "$to/m.pl" -o "$to/m.stl"
run convert "$to/m.stl" -o "$to/m.stl" -o "$to/m.obj"
check 'output is input' status_is 0
run check "$to/m.stl"
check 'output is input: good' status_is 0

# Devices and pipes.
mkfifo "$to/pipe"
cat "$to/pipe" >"$to/got" &
run draw facts/cube.pl --format svg -o "$to/pipe"
wait
check 'pipe' has '</svg>' "$to/got"
echo before >"$to/log"
"$sanggwan" draw facts/cube.pl --format svg -o /dev/stdout >>"$to/log"
check 'standard output is not emptied' has before "$to/log"
check '/dev/stdout' has '</svg>' "$to/log"

# Links under names that a program could be expected to take.
anew
echo secret >"$work/victim"
for ((i = 0; i < 2000; i++)); do
  ln -s "$work/victim" "$to/.a.svg.$(($$ + i))-0"
  ln -s "$work/victim" "$to/.sanggwan-$(($$ + i))"
done
run draw facts/cube.pl -o "$to/a.svg"
check 'planted links' status_is 0
check 'planted links: not followed' is "$(cat "$work/victim")" secret
check 'planted links: a file' test ! -L "$to/a.svg"
check 'planted links: nothing more' is "$(ls -A "$to" | wc -l)" 4002

# --strict: a verb that has warned writes nothing, to no file and to no pipe.
anew
cd "$work" || exit 2
echo 'segment(1, solid, cylinder(radius(2,1), height(3))).' >warns.pl
echo 'segment(1, solid, at([translate(1,0,1)], box(size(1,1,1)))).' >box.pl
{ sed 's/1/2/' box.pl; cat warns.pl
  echo 'segment(3, cells, glue([1, 2])).'; } >glued.pl
cat >sheets.pl <<'END'
problem(one, 'warns.pl', [given([front, top]), ask(count(loops))]).
sheet('A4', [one], []).
END
echo 'job(one, draw, ["warns.pl"], [output("%.svg")]).' >jobs.pl
strictly() { # VERB ARGUMENT...
  run "$@" --strict
  check "strict $1: refused" test "$status" = 1 -o "$status" = 5
  check "strict $*: nothing" untouched
  check "strict $*: no data" silent out
  check "strict $1: why" has 'so nothing is written'
  run "$@"
  check "not strict $1: done" status_is 0
  anew
}
for verb in 'convert warns.pl -o to/a.stl -o to/b.off' \
  'convert warns.pl -o to/b.pl' 'draw warns.pl -o to/a.svg -o to/b.svg' \
  'draw warns.pl -o - --format pdf' 'draw --each warns.pl -o to/%.svg' \
  'render warns.pl --size 9x9 -o to/a.png' \
  'unfold warns.pl -o to/a.svg --true --table to/b.csv' \
  'penetrate warns.pl box.pl -o to/a.csv' 'eval warns.pl -o to/a.off' \
  'union warns.pl box.pl -o to/a.off' 'intersection warns.pl box.pl -o to/a.pl' \
  'difference warns.pl box.pl -o to/a.stl' \
  'split warns.pl --plane 0,0,1,-1 -o to/s.stl' \
  'glue warns.pl box.pl -o to/a.pl' 'unglue glued.pl -o to/a.pl' \
  'cells glued.pl -o to/a.pl' 'problems sheets.pl -o to'; do
  strictly $verb
done
run batch jobs.pl -o to --strict
check 'strict batch' status_is 5
check 'strict batch: nothing' test ! -e to/one.svg
check 'strict batch: why' has 'job one: 1 warning, and --strict was given'
check 'strict batch: its line' grep -q '"error":{"code":"nothing_written"' \
  "$work/out"
grep -o '"error":.*' "$work/out" >first
run batch jobs.pl -o to --strict
check 'strict batch: again' has 'job one: 1 warning, and --strict was given'
check 'strict batch: the same again' \
  test "$(grep -o '"error":.*' "$work/out")" = "$(cat first)"
run batch jobs.pl -o to
check 'strict batch: kept nothing' test -e to/one.svg
finish
