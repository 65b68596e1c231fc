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
finish
