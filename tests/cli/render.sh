#!/bin/bash
# render.sh -- shaded pictures as a user makes them: same bytes whatever the
# machine does, files whole or not there, other programs open them.
# covers: usage_render, verbs_render
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
shade() { run render -q "$@"; }

shade facts/pipe_tee.pl --size 320x200 -o "$work/a.png" -o "$work/a.ppm"
check "a picture" status_is 0
check "says nothing" silent err
if command -v python3 >"$work/null"; then
  # The dots of the PNG, which has no filter but none, left and above.
  check "PNG and PPM have the same dots" python3 - "$work/a.png" "$work/a.ppm" <<'END'
import struct, sys, zlib
png = open(sys.argv[1], "rb").read()
ppm = open(sys.argv[2], "rb").read()
at, data, kinds = 8, b"", []
while at < len(png):
    n, = struct.unpack(">I", png[at:at+4])
    kind, body = png[at+4:at+8], png[at+8:at+8+n]
    assert zlib.crc32(kind + body) == struct.unpack(">I", png[at+8+n:at+12+n])[0]
    kinds.append(kind)
    if kind == b"IHDR": w, h, bits, colour = struct.unpack(">IIBB", body[:10])
    if kind == b"IDAT": data += body
    at += 12 + n
assert (w, h, bits, colour) == (320, 200, 8, 2) and kinds[1] == b"sRGB"
assert set(kinds) == {b"IHDR", b"sRGB", b"IDAT", b"IEND"}
raw, row, dots, above = zlib.decompress(data), 3 * w, b"", bytes(3 * w)
for y in range(h):
    kind, line = raw[y*(row+1)], bytearray(raw[y*(row+1)+1:(y+1)*(row+1)])
    for i in range(row):
        line[i] = (line[i] + (line[i-3] if kind == 1 and i > 2 else
                              above[i] if kind == 2 else 0)) % 256
    above = bytes(line); dots += above
assert ppm == b"P6\n320 200\n255\n" + dots
assert len(set(dots)) > 50
END
else
  skip "python3 is not here"
fi
if command -v rsvg-convert >"$work/null"; then
  printf '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">
<image href="a.png" width="9" height="9"/></svg>' >"$work/a.svg"
  check "another program opens it" rsvg-convert "$work/a.svg" -o "$work/b.png"
fi

if command -v taskset >"$work/null"; then
  taskset -c 0 "$sanggwan" render -q facts/pipe_tee.pl --size 320x200 \
    -o "$work/one.png" </dev/null
  check "the same bytes on one processor" cmp "$work/a.png" "$work/one.png"
fi
shade facts/pipe_tee.pl --size 320x200 -o - --format png
check "to standard output" cmp "$work/out" "$work/a.png"

# A model in other units is the same picture.
sized() {
  printf 'segment(1, solid, difference([box(size(%s,%s,%s)),
    at([translate(0,0,-%s)], cylinder(radius(%s), height(%s), facets(48)))])).
    view(300,50,0).\n' "$@" >"$work/m.pl"
  shade "$work/m.pl" --size 200x150 -o "$work/m$1.ppm"
}
sized 4 3 2 1 1 8
check "a hole" status_is 0
sized 4e-8 3e-8 2e-8 1e-8 1e-8 8e-8
check "at 1e-8" status_is 0
sized 4e6 3e6 2e6 1e6 1e6 8e6
check "at 1e6" status_is 0
# apart A B MOST: dots that differ by more than a step.
apart() {
  [ "$(cmp -l "$1" "$2" | awk '{a = strtonum("0" $2) - strtonum("0" $3)
    if (a > 1 || a < -1) n++} END {print n + 0}')" -le "$3" ]
}
if awk 'BEGIN { exit strtonum("010") != 8 }' 2>"$work/null"; then
  check "small is the same picture" apart "$work/m4.ppm" "$work/m4e-8.ppm" 9
  check "large is the same picture" apart "$work/m4.ppm" "$work/m4e6.ppm" 9
fi

# Windows of a picture are its parts.
shade facts/pipe_tee.pl --window=-20,-15,20,15 --size 160x120 -o "$work/w.ppm"
shade facts/pipe_tee.pl --window=-20,0,0,15 --size 80x60 -o "$work/q.ppm"
check "a part" python3 - "$work/w.ppm" "$work/q.ppm" <<'END'
import sys
def dots(f):
    head, size, most, body = open(f, "rb").read().split(b"\n", 3)
    return body
w, q = dots(sys.argv[1]), dots(sys.argv[2])
rows = b"".join(w[y*480:y*480+240] for y in range(60))
far = sum(abs(a - b) > 1 for a, b in zip(rows, q))
assert len(rows) == len(q) and far < 30 and len(set(q)) > 20, far
END

# In perspective a window may be measured anywhere: the top of the cube is 9 from an
# eye that is 10 above its bottom.
seen() { # seen NAME WINDOW OPTION...
  shade facts/cube.pl --size 60x60 --view 270,0,10 --window="$2" "${@:3}" \
    -o "$work/$1.ppm"
}
for same in '-2,-1,2,3 -2,-1,2,3,9' '-4,-2,4,6 -2,-1,2,3,4.5'; do
  seen near "${same% *}" --projection central
  seen far "${same#* }" --projection central
  check "a window at a distance: $same" cmp "$work/near.ppm" "$work/far.ppm"
done
seen near -2,-1,2,3
check "that is another one" test ! "$(cmp "$work/near.ppm" "$work/far.ppm")" = ''
seen far -2,-1,2,3,4.5
check "parallel, no distance counts" cmp "$work/near.ppm" "$work/far.ppm"

# Looks and lights change dots; the model's own are there without an option.
cp facts/pipe_tee.pl "$work/l.pl"
echo 'look(10, colour(red)). light(1, picture(5,2,3)).' >>"$work/l.pl"
echo 'look(10, colour(red)). light(1, picture(5,2,3)).' >"$work/f.pl"
shade "$work/l.pl" --size 320x200 -o "$work/l.png"
check "looks of a model" status_is 0
check "are seen" eval "! cmp -s '$work/l.png' '$work/a.png'"
shade facts/pipe_tee.pl --look "$work/f.pl" --size 320x200 -o "$work/f.png"
check "looks of a file" cmp "$work/l.png" "$work/f.png"
shade facts/pipe_tee.pl --look "$work/f.pl" --size 320x200 -o "$work/f.png" \
  --light=-5,6,8
check "a light as it would be" status_is 0
shade facts/pipe_tee.pl --size 320x200 -o "$work/g.png" --light=-5,6,8
check "is the usual one" cmp "$work/g.png" "$work/a.png"

# What is interrupted leaves no file, when soever in the time that all takes.
mkdir "$work/to" "$work/all"
large() { # large FOLDER [PREFIX...]
  "${@:2}" "$sanggwan" render facts/pipe_tee.pl --smooth 16 --size 4000x4000 \
    -o "$1/x.png" >"$work/out" 2>&1 </dev/null
}
several() {
  "${@:2}" "$sanggwan" render facts/pipe_tee.pl --size 4000x4000 \
    --buffer depth="$1/x.pfm" --buffer id="$1/x.csv" --spans "$1/s.csv" \
    -o "$1/x.pl" >"$work/out" 2>&1 </dev/null
}
for what in large several; do
  begin=${EPOCHREALTIME/./}
  "$what" "$work/all"
  all=$((${EPOCHREALTIME/./} - begin)) # microseconds
  for percent in 5 30 60; do
    after=$(printf '%d.%06d' $((all * percent / 100000000)) \
      $((all * percent / 100 % 1000000)))
    "$what" "$work/to" timeout -s INT "$after"
    check "$what, interrupted after $percent %" holds "$work/to"
  done
done
check "not interrupted, all are there" holds "$work/all" s.csv x.csv x.pfm x.pl \
  x.png
shade facts/pipe_tee.pl -o "$work/nowhere/x.png"
check "no folder" status_is 2
shade facts/two_cubes.pl nothing.pl -o "$work/to/x.png"
check "no model" status_is 3
check "no file" holds "$work/to"
finish
