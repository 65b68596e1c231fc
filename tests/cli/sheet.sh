# sheet.sh -- `sanggwan draw` makes sheets that other programs open, at their
# true size, and says what is wrong in a line or three.
# covers: eye, cutaway
. "$(dirname "$0")/harness.bash"
cd "$here"

sheet() { run draw -q "$@"; }

# papered FILE W H: an SVG of that size in millimetres.
papered() { grep -q "width=\"$2mm\" height=\"$3mm\"" "$1"; }
# opened FILE: rsvg-convert makes a picture of it.
opened() { rsvg-convert -w 800 "$1" -o "$work/x.png"; }
fails() { [ "$status" = "$1" ] && has "$2"; }

sheet facts/cube.pl --sheet A3 -o "$work/a.svg"
check "a sheet" status_is 0
check "its size" papered "$work/a.svg" 420 297
check "opened" opened "$work/a.svg"
sheet facts/cube.pl --sheet a4-landscape --views front -o "$work/a.svg"
check "landscape" papered "$work/a.svg" 297 210
sheet facts/cube.pl --views front,top -o "$work/a.svg"
check "A3 if nothing is said" papered "$work/a.svg" 420 297
sheet facts/cube.pl --scale 20:1 --view front -o "$work/a.svg"
check "a scale without a sheet" papered "$work/a.svg" 40 40
sheet facts/cube.pl --scale 1:2 --unit m --view front -o "$work/a.svg"
check "a unit" papered "$work/a.svg" 520 520

for format in svg pdf eps ps png json dxf hpgl pl; do
  sheet facts/bracket.pl --section y --language ko -o "$work/s.$format"
  check "$format" status_is 0
  check "$format: something" [ -s "$work/s.$format" ]
done
check "Korean in the SVG" has 축받이 "$work/s.svg"
check "Korean in the JSON" has 축받이 "$work/s.json"
check "the scale in it" has '>1:2<' "$work/s.svg"
if command -v pdfinfo >"$work/null"; then
  check "PDF of A3" \
    eval "pdfinfo '$work/s.pdf' | grep -q 'Page size: *1190.5.* x 841.8'"
else
  skip "pdfinfo is not here"
fi

sheet facts/two_cubes.pl --direction 1,2,-1 -o "$work/d.svg"
check "a direction" status_is 0
sheet facts/two_cubes.pl --direction 2,4,-2 -o "$work/e.svg"
check "of any length" cmp "$work/d.svg" "$work/e.svg"
sheet facts/two_cubes.pl --eye 4,-5,3 --target 1,1,1 -o "$work/d.svg"
sheet facts/two_cubes.pl --direction=-3,6,-2 -o "$work/e.svg"
check "an eye" cmp "$work/d.svg" "$work/e.svg"
sheet facts/two_cubes.pl --direction 0,1,0 -o "$work/d.svg"
sheet facts/two_cubes.pl --view front -o "$work/e.svg"
check "the front" cmp "$work/d.svg" "$work/e.svg"
sheet facts/two_cubes.pl --direction 0,0,-1 -o "$work/d.svg"
sheet facts/two_cubes.pl --view top -o "$work/e.svg"
check "from above" cmp "$work/d.svg" "$work/e.svg"
sheet facts/two_cubes.pl --eye 4,-5,3 --projection central -o "$work/d.svg"
check "a central eye" status_is 0
sheet facts/two_cubes.pl --eye 1,0.5,0.5 --projection central -o "$work/d.svg"
check "an eye in the model" status_is 4

sheet facts/cube.pl --sheet A4 --scale 200:1 -o "$work/none.svg"
check "too large" fails 2 '--scale 50:1 does fit, or take --sheet A1.'
check "no file" absent "$work/none.svg"
sheet facts/cube.pl --scale 50:1 --size 20x20 -o "$work/none.svg"
check "too large for a size" fails 2 'a sheet of 20 x 20 mm is too small'
sheet facts/cube.pl --sheet B7 -o "$work/none.svg"
check "no paper" fails 2 'A4 A3 A2 A1 A0'
sheet facts/cube.pl --views front,side -o "$work/none.svg"
check "no view" fails 2 'dimetric'
sheet facts/cube.pl --section x=3 -o "$work/none.svg"
check "past the model" fails 2 'x from 0 to 1'
sheet facts/cube.pl --section q -o "$work/none.svg"
check "no plane" fails 2 'x=5, y=5 or z=5'
sheet facts/cube.pl --scale big -o "$work/none.svg"
check "no scale" fails 2 '1:2 for half the size'
sheet facts/cube.pl --sheet A3 --size 10x10 -o "$work/none.svg"
check "sheet and size" fails 2 'do not go together'
sheet facts/cube.pl --title-block "$work/gone.pl" -o "$work/none.svg"
check "no title block" fails 3 'there is no such file'
echo 'v(1, 1, 0, 0, 0).' >"$work/v.pl"
sheet facts/cube.pl --title-block "$work/v.pl" -o "$work/none.svg"
check "no title" fails 3 'v.pl:1:1: a file for the title block has no v facts'
echo 'title_block(nmae, "x").' >"$work/v.pl"
sheet facts/cube.pl --title-block "$work/v.pl" -o "$work/none.svg"
check "no item" fails 3 'Item of title_block is nmae'
sheet facts/cube.pl --lang ko --sheet B7 -o "$work/none.svg"
check "in Korean" fails 2 '그런 용지는 없습니다'
check "still no file" absent "$work/none.svg"

echo 'title_block(name, "One & <two>").' >"$work/v.pl"
sheet facts/cube.pl --title-block "$work/v.pl" -o "$work/a.svg"
check "text is escaped" has 'One &amp; &lt;two&gt;' "$work/a.svg"
check "and opened" opened "$work/a.svg"

cp facts/bracket.pl "$work/m.pl"
run convert "$work/m.pl" -o "$work/n.pl"
check "title blocks are written" has "title_block(material, 'GC200')" \
  "$work/n.pl"

# A cutaway that is seen squarely has the lines of the section on a sheet; the model
# before and behind the plane has all or nothing.
if command -v python3 >"$work/null"; then
  for model in facts/bracket.pl facts/pipe_tee.pl facts/figures/glue_materials.pl; do
    sheet "$model" --section y --views back --no-frame -o "$work/cut.json"
    check "a section" status_is 0
    run draw -q "$model" --cutaway y --view front --hidden removed -o "$work/away.json"
    check "a cutaway" status_is 0
    check "the same lines: $model" python3 - "$work/cut.json" "$work/away.json" <<'END'
import json, sys
def lines(file, view):
    return sorted([one["visibility"], one["role"], one["segment"], one["edges"]]
                  for one in json.load(open(file))["lines"]
                  if one.get("view", view) == view
                  and one["role"] not in ("hatching", "centre_line"))
cut, away = lines(sys.argv[1], "A"), lines(sys.argv[2], "")
assert len(cut) > 4 and any(one[1] == "section" for one in cut), len(cut)
assert cut == away, [one for one in cut if one not in away][:3]
END
  done
fi
run draw -q facts/bracket.pl --cutaway z=1e6 --view 300,60 -o "$work/all.svg"
run draw -q facts/bracket.pl --view 300,60 -o "$work/whole.svg"
check "behind the plane: the model" cmp "$work/all.svg" "$work/whole.svg"
run draw facts/bracket.pl --cutaway z=-1e6 -o "$work/no.svg"
check "before the plane: nothing" has 'nothing to draw'
for other in '--sheet A4' '--section x' '--points 3' '--projection central' \
  '--shade lambert' '--explode 1' --centre-lines --no-frame; do
  # shellcheck disable=SC2086
  run draw facts/bracket.pl --cutaway y $other -o "$work/none.svg"
  check "a cutaway and $other" fails 2 'do not go together'
done
for plane in q y= x=a 0,0,0,1 1,2,3; do
  run draw facts/bracket.pl --cutaway "$plane" -o "$work/none.svg"
  check "no plane: $plane" fails 2 'x=5, y=5, z=5, x, y, z or A,B,C,D'
done
run draw -q facts/bracket.pl --up y --cutaway y=5 --view iso -o "$work/up.json"
run draw -q facts/bracket.pl --up y --cutaway 0,-1,0,5 --view iso -o "$work/too.json"
check "turned up first; a plane by four numbers" cmp "$work/up.json" "$work/too.json"

finish
