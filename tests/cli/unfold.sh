# unfold.sh -- patterns: what is printed and written, wishes in the model and as
# options, trimming, and what is wrong said at its place.
# covers: pattern_trim, unfold_names, unfold_options, unfold_output
# covers: verbs_unfold
. "$(dirname "$0")/../check.sh"

sanggwan() { "$SANGGWAN" "$@"; }
facts=$(dirname "$0")/../../facts
cat >"$TMP/box.pl" <<'MODEL'
segment(1, solid, named(case, box(size(2, 3, 4)))).
MODEL
box=$TMP/box.pl saddle=$facts/patterns/saddle.pl

# Names of faces in results of CSG trees.
cat >"$TMP/tree.pl" <<'MODEL'
segment(1, solid, named(can, cylinder(radius(2), height(5), facets(8)))).
segment(2, solid, at([translate(0,0,3)], named(bar, box(size(4, 1, 1))))).
segment(3, solid, union([1,2])).
MODEL
check "a face of a leaf is the root" status 0 \
  sanggwan unfold -q "$TMP/tree.pl" --root can/top
check "one that several leaves have" complains 2 \
  'top is not one polygon: polygon 2 .can/top., polygon' \
  sanggwan unfold -q "$TMP/tree.pl" --root top
check "one that no leaf has" complains 2 'there is no polygon can/lid' \
  sanggwan unfold -q "$TMP/tree.pl" --root can/lid

cat >"$TMP/copies.pl" <<'MODEL'
segment(1, solid, named(can, cylinder(radius(2), height(5), facets(16)))).
segment(2, solid, at([rotate(y,40),translate(0,0,4)], box(size(9, 9, 3)))).
segment(3, solid, at([rotate(x,30),translate(9,0,0)], difference([1,2]))).
MODEL
check "what a tree has cut and placed is unrolled" output \
  'area *48.6062 of 76.0644, without 3 polygons' \
  sanggwan unfold -q "$TMP/copies.pl" --true
check "its seam is explained" output 'is unrolled as the round surface it is' \
  sanggwan explain -q "$TMP/copies.pl" --true 'seam(_)'

# The report.
check "one piece" output '^segment 1: case, 6 polygons in 1 piece$' \
  sanggwan unfold "$box"
check "area of the solid" output '^  area  *52 of 52$' sanggwan unfold "$box"
check "the seam and its bound" output 'seam  *18 .at least 18., the longest' \
  sanggwan unfold "$box"
check "as JSON" eval "sanggwan unfold $box --json |
  python3 -c 'import json,sys; d, = json.load(sys.stdin)
assert d[\"polygons\"] == 6 and d[\"pieces\"] == 1 and d[\"area\"] == 52
assert d[\"name\"] == \"case\" and d[\"removed\"] == 0
assert abs(d[\"seam\"] - 18) < 1e-9 and abs(d[\"bound\"] - 18) < 1e-9'"
check "in Korean" output '다각형 6개, 조각 1개$' sanggwan unfold "$box" --lang ko
check "timings" eval \
  "sanggwan unfold -q $box --timings 2>&1 >/dev/null | grep -q '\"develop\":'"
check "timings of what is unrolled" eval \
  "sanggwan unfold -q facts/patterns/saddle.pl --true --timings 2>&1 >/dev/null |
  grep -q '\"develop\":0[.]0*[1-9]'"
check "a mesh" eval "sanggwan eval -q $box -o $TMP/box.stl &&
  sanggwan unfold -q $TMP/box.stl | grep -q 'area  *52 of 52'"
check "several models" eval "[ \$(sanggwan unfold -q $box $box --no-lines |
  grep -c '^segment') = 2 ]"

# Wishes as options.
check "removed" output 'area  *40 of 52, without 2 polygons' \
  sanggwan unfold "$box" --remove base,top
check "cut all round" output 'in 2 pieces' \
  sanggwan unfold "$box" --cut base-side
check "by number" output 'in 2 pieces' \
  sanggwan unfold "$box" --cut 1-3,1-4 --cut '1-5, 1-6'
check "kept" output 'in 1 piece' \
  sanggwan unfold "$box" --keep 'base-side' --root base
check "an order" output 'in 1 piece' \
  sanggwan unfold "$box" --order 'side(1),base,side(3)'
check "cut and keep" complains 2 'edge .* is to be cut and to be kept' \
  sanggwan unfold "$box" --cut base-3 --keep '1-side(1)'
check "its faces by name" complains 2 'polygon 1 .base. and polygon 3 .side.1..' \
  sanggwan unfold "$box" --cut base-3 --keep '1-side(1)'
check "no such polygon" complains 2 'There are 1 - 6 .base, top, side.1..4..' \
  sanggwan unfold "$box" --root lid
check "no such edge" complains 2 'base and top have no edge in common' \
  sanggwan unfold "$box" --cut base-top
check "an order that is not connected" complains 2 \
  'polygon 2 .top. has no edge in common with one before it' \
  sanggwan unfold "$box" --order base,top
cat >"$TMP/two.pl" <<'MODEL'
segment(1, solid, named(pipe, cylinder(radius(2), height(5)))).
segment(2, solid, box(size(1, 1, 1))).
MODEL
check "removed of each" test 2 = \
  "$(sanggwan unfold "$TMP/two.pl" --remove base,top | grep -c 'without 2 poly')"
check "what one has" output 'without 1 polygon' \
  sanggwan unfold "$TMP/two.pl" --remove 'side(3)'
check "what none has" complains 2 'there is no polygon lid' \
  sanggwan unfold "$TMP/two.pl" --remove base,lid
check "by number, of several" complains 2 'Say which one with --only' \
  sanggwan unfold "$TMP/two.pl" --remove 1
check "the root removed" complains 2 'the root, polygon 1 .base., is to be' \
  sanggwan unfold "$box" --root base --remove base
check "a ring" complains 2 'closes a ring' \
  sanggwan unfold "$box" --keep '1-3,3-4,1-4'
check "no term" complains 2 'cannot be read' \
  sanggwan unfold "$box" --cut 'base('
check "no objective" complains 2 'none of seam' \
  sanggwan unfold "$box" --minimize cost
check "in Korean, too" complains 2 '함께 가진 모서리가 없습니다' \
  sanggwan unfold "$box" --cut base-top --lang ko
check "of which segment" complains 2 'Say which one with --only' \
  sanggwan unfold "$box" "$box" --root 1
check "this one" output '^segment 2: case' \
  sanggwan unfold "$box" "$box" --root 1 --only 2
check "by name" eval "[ \$(sanggwan unfold -q $saddle --only branch |
  grep -c '^segment') = 1 ]"
check "no such segment" complains 2 'no segment lid, only 1' \
  sanggwan unfold "$box" --only lid

# Wishes in the model; a fault is said at its place.
{ cat "$box"; echo 'unfolding(1, removed([base, top])).'; } >"$TMP/sides.pl"
check "removed by a fact" output 'without 2 polygons' \
  sanggwan unfold "$TMP/sides.pl"
{ cat "$box"; echo; echo 'unfolding(1, cut(base-lid)).'; } >"$TMP/lid.pl"
check "place of a fault" complains 3 'lid.pl:3:14: .*there is no polygon lid' \
  sanggwan unfold "$TMP/lid.pl"
{ cat "$box"
  echo 'unfolding(1, root(base)).'
  echo 'segment(2, solid, sphere(radius(1))).'
  echo 'unfolding(2, root(base)).'
  echo 'segment(3, solid, box(size(1, 1, 1))).'
  echo 'unfolding(3, root(base)).'; } >"$TMP/three.pl"
check "place of the segment that has it" complains 3 'three.pl:4:14: segment 2' \
  sanggwan unfold "$TMP/three.pl"
{ cat "$box"; echo 'unfolding(1, fold(3)).'; } >"$TMP/fold.pl"
check "no wish" complains 3 'fold.pl:2:14: .*it is no wish' \
  sanggwan unfold "$TMP/fold.pl"
{ cat "$box"; echo 'unfolding(1, cut(top)).'; } >"$TMP/top.pl"
check "form of a wish" complains 3 'should look like cut.Edge.' \
  sanggwan unfold "$TMP/top.pl"
{ cat "$box"; echo 'unfolding(5, root(1)).'; } >"$TMP/five.pl"
check "of no segment" complains 3 'five.pl:2:14: .*no such segment' \
  sanggwan unfold "$TMP/five.pl"

# Trimmed by each other.
check "saddle and hole" eval "[ \$(sanggwan unfold -q $saddle --trim outside |
  grep -c 'in 1 piece') = 2 ]"
check "inside" eval "[ \$(sanggwan unfold -q $saddle --trim inside |
  grep -c '^segment') = 2 ]"
check "nothing left" complains 4 'all of it is outside the others' \
  sanggwan unfold "$box" --trim inside
cat >"$TMP/inner.pl" <<'MODEL'
segment(1, solid, box(size(4, 4, 4))).
segment(2, solid, named(core, at([translate(0, 0, 1)], box(size(1, 1, 1))))).
segment(3, solid, at([translate(2, 0, 1)], box(size(2, 2, 2)))).
MODEL
check "of one nothing is left, of others there is" eval \
  "sanggwan unfold $TMP/inner.pl --trim outside 2>&1 |
  grep -c '^segment\|warning: nothing is left of segment 2' | grep -qx 3"
check "nothing left of the only one" complains 4 'nothing is left of segment 2' \
  sanggwan unfold "$TMP/inner.pl" --trim outside --only core
check "trimmed by one" output 'area  *6 of 6' \
  sanggwan unfold "$TMP/inner.pl" --trim outside --only core --by 3
check "by what is there" complains 2 'no segment 7' \
  sanggwan unfold "$TMP/inner.pl" --trim outside --by 7
check "by, without trimming" complains 2 'Give --trim as well' \
  sanggwan unfold "$TMP/inner.pl" --by 3
check "alone" eval "sanggwan unfold $box --trim outside 2>&1 |
  grep -q 'meets no other'"
check "the bend" eval "[ \$(sanggwan unfold -q $facts/patterns/elbow.pl \
  --trim outside | grep -c 'in 1 piece') = 4 ]"
check "the transition" output '44 polygons in 1 piece' \
  sanggwan unfold "$facts/patterns/transition.pl"
check "the house" output '7 polygons in 1 piece' \
  sanggwan unfold "$facts/patterns/house.pl"

# Not trimmed: the patterns have the lines.
check "lines" eval "sanggwan unfold -q $saddle -o $TMP/lines.pl >/dev/null &&
  grep -q '^joint(.*, line, ' $TMP/lines.pl"
check "no lines" eval "sanggwan unfold -q $saddle --no-lines -o - \
  --format pl | { ! grep -q '^joint(.*, line, '; }"

# Facts, read back; flat meshes.
sanggwan unfold -q "$saddle" --trim outside -o "$TMP/flat.pl" >"$TMP/out"
check "what was trimmed and its patterns" eval \
  "[ \$(grep -c '^segment' $TMP/flat.pl) = 4 ]"
check "read back" eval "sanggwan convert -q $TMP/flat.pl -o $TMP/again.pl &&
  cmp $TMP/flat.pl $TMP/again.pl"
check "edges of the pattern are those of what was unfolded" status 0 \
  sanggwan query "$TMP/flat.pl" \
  'forall((segment(D, pattern, development(S)), e(D, E, _, _, _)),
          once(e(S, E, _, _, _)))'
check "a flat mesh" eval "sanggwan unfold -q $box -o $TMP/flat.off >/dev/null &&
  [ \$(head -c 3 $TMP/flat.off) = OFF ] &&
  awk 'NR > 2 && NF == 3 && \$3 != 0 { exit 1 }' $TMP/flat.off"

# True patterns.
pipe=$TMP/pipe.pl
echo 'segment(1, solid, named(pipe, cylinder(radius(50), height(200),
  facets(24)))).' >"$pipe"
check "as wide as it is round" output 'sheet  *314.159 x 200' \
  sanggwan unfold "$pipe" --true --remove base,top
check "a chord each without" output 'sheet  *313.263 x 200' \
  sanggwan unfold "$pipe" --remove base,top
check "its ends as well" eval "[ \$(sanggwan unfold $pipe --true |
  grep -c '^segment') = 2 ]"
check "a table" eval "sanggwan unfold -q $pipe --true --generators 12 \
  --remove base,top --table $TMP/pipe.csv >/dev/null &&
  [ \$(wc -l <$TMP/pipe.csv) = 14 ]"
# What facets are of is found once for a segment: without that 50,000 questions.
asked=$(sanggwan unfold -q "$saddle" --trim outside --true --stats \
  -o "$TMP/asked.svg" 2>&1 >/dev/null |
  sed -n 's/.*"segment": {[^}]*"lookups":\([0-9]*\).*/\1/p')
check "segments are asked for a few times" test "${asked:-9999}" -lt 1000

check "two tables" eval "sanggwan unfold -q $saddle --trim outside --true \
  --table $TMP/s.csv >/dev/null && [ -s $TMP/s-1.csv ] && [ -s $TMP/s-2.csv ]"
check "half of it is all of it" output 'without 24 polygons' \
  sanggwan unfold "$pipe" --true --half
check "what is round can be removed" eval "[ \$(sanggwan unfold $pipe --true \
  --remove side | grep -c '^segment') = 1 ]"
check "wishes for what is flat" output 'in 2 pieces' \
  sanggwan unfold "$box" --true --cut base-side
check "the root of what is flat" eval "sanggwan unfold -q $box --true --root top \
  --cut top-side -o - --format pl 2>/dev/null | grep -q '^piece(2, 2, 1)'"
check "round and flat are not joined" complains 0 '24 edge.* could not be kept' \
  sanggwan unfold "$pipe" --true --keep base-side
check "the seam where it is wished" output 'seam  *260,' \
  sanggwan unfold "$saddle" --trim outside --true --only header
check "or as an option says" output 'seam  *260,' \
  sanggwan unfold "$saddle" --trim outside --true --only header --seam 30
check "no angle" complains 2 'should look like DEGREES' \
  sanggwan unfold "$pipe" --true --seam x
check "only of true patterns" complains 2 'Give --true as well' \
  sanggwan unfold "$pipe" --seam 30
check "a plate that is set on" output '238.761 x 136.531' \
  sanggwan unfold "$saddle" --trim outside --true --only branch --thickness 4
echo 'segment(1, surface, sheet(points([[0,0,0],[60,0,0],[60,50,0],[0,50,0],
  [0,0,40],[0,50,40]]), faces([[4,3,2,1],[6,4,1,5]]))).' >"$TMP/angle.pl"
check "the area of a plate is that before it is bent" output \
  'area  *4804.73 of 5000' sanggwan unfold "$TMP/angle.pl" --thickness 2 \
  --size outside --kfactor 0.44 --bend-radius 3
check "corners are cut out" output 'area  *43.5405 of' \
  sanggwan unfold "$box" --remove top --keep base-side --thickness 0.1
check "a folded plate" output 'sheet  *9.[0-9]* x 7' \
  sanggwan unfold "$box" --thickness 0.1

# Drawings.
check "a drawing" eval "sanggwan unfold -q $saddle --trim outside \
  -o $TMP/saddle.svg >/dev/null && grep -q 'visible cut' $TMP/saddle.svg"
check "every format" eval "sanggwan unfold -q $box \
  $(for f in svg pdf eps ps png dxf hpgl json fold; do
    printf ' -o %s/box.%s' "$TMP" $f; done) >/dev/null &&
  [ \$(ls $TMP/box.{svg,pdf,eps,ps,png,dxf,hpgl,json,fold} | wc -l) = 9 ]"
check "on standard output" eval "sanggwan unfold -q $box -o - --format svg |
  grep -q '<svg'"
check "to scale" eval "sanggwan unfold -q $box --scale 10:1 -o - --format svg |
  grep -q 'data-scale=.10.'"
check "nothing else is on standard output" eval \
  "[ \"\$(sanggwan unfold $box -o - --format svg 2>/dev/null |
    head -c 5)\" = '<?xml' ]"
check "nor beside a table" eval "[ \"\$(sanggwan unfold $pipe --true \
  --table - 2>/dev/null | head -1 | cut -d, -f1)\" = number ]"
check "no scale" complains 2 'scale fit is no scale' \
  sanggwan unfold "$box" --scale fit -o "$TMP/box.svg"
check "several sheets" eval "sanggwan unfold $box --scale 100:1 --page A4 \
  -o $TMP/many.svg 2>&1 >/dev/null | grep -q 'wrote .*many-2.svg'"
check "laid on sheets once for all drawings" eval "[ \$(sanggwan unfold $box \
  --scale 100:1 --page A4 -o $TMP/once.pdf -o $TMP/once.svg -o $TMP/once.fold \
  2>&1 >/dev/null | grep -c 'larger than the page') -eq 1 ]"
check "as for one" cmp "$TMP/once-2.svg" "$TMP/many-2.svg"
check "not on standard output" complains 2 'standard output takes one' \
  sanggwan unfold "$box" --scale 100:1 --page A4 -o - --format svg
check "tabs" eval "[ \$(sanggwan unfold -q $box --scale 10:1 --tabs 5 -o - \
  --format svg | wc -c) -gt \
  \$(sanggwan unfold -q $box --scale 10:1 -o - --format svg | wc -c) ]"
check "too many dots" complains 2 'cannot have .* dots' \
  sanggwan unfold "$box" --dpi 1000000 -o "$TMP/box.png"
check "a page that is none" complains 2 'A44' \
  sanggwan unfold "$box" --page A44 -o "$TMP/box.svg"

sed 's/24/60/' "$pipe" >"$TMP/fine.pl"
check "a table is no larger than its page" eval \
  "sanggwan unfold $TMP/fine.pl --true --page A4 -o $TMP/fine.svg 2>&1 |
  { ! grep -q 'goes beyond\|left out'; } && grep -q visible.table $TMP/fine*.svg"
check "which paper there is" complains 2 "A4 A3 A2 A1 A0 letter" \
  sanggwan unfold "$box" --page A9
check "no room" complains 2 'Take a smaller margin' \
  sanggwan unfold "$box" --page A4 --margin 120 -o "$TMP/box.svg"
check "tiles lie on each other" complains 2 'Take at most 95' \
  sanggwan unfold "$box" --tile --overlap 300 -o "$TMP/box.svg"

# Options that say nothing alone, or too much; numbers that are none.
alone() {
  check "$1 needs $2" complains 2 "Give $2 as well" \
    sanggwan unfold "$box" "${@:3}"
}
alone --by --trim --by 1
alone --half --true --half
alone --generators --true --generators 12
alone --chord --true --chord 1
alone --table --true --table "$TMP/alone.csv"
alone --set-in --trim --true --set-in
alone --other-thickness --thickness --true --trim outside --other-thickness 1
alone --kfactor --thickness --kfactor 0.4
alone --bend-radius --thickness --bend-radius 1
alone --size --thickness --size inside
alone --overlap --tile --overlap 5
check "lines or trimmed" complains 2 'do not go together' \
  sanggwan unfold "$box" --lines --trim outside
check "not half is whole" status 0 sanggwan unfold "$box" --no-half
check "a layer in the plate" complains 2 'from 0 to 1' \
  sanggwan unfold "$box" --thickness 0.1 --kfactor 7
check "so many generators" complains 2 'no whole number from 2' \
  sanggwan unfold "$pipe" --true --generators 2.5
check "some chord" complains 2 'no number above 0' \
  sanggwan unfold "$pipe" --true --chord 0
check "no grid so fine" complains 2 'no number from 0.5' \
  sanggwan unfold "$box" --grid 1e-9 -o "$TMP/box.svg"
check "no generators, no table" complains 0 'no pattern has generators' \
  sanggwan unfold "$box" --true --table "$TMP/none.csv"
check "no folder for a table" complains 2 'no folder' \
  sanggwan unfold "$pipe" --true --table "$TMP/none/t.csv"
check "no table over the model" complains 2 'the ending decides' \
  sanggwan unfold "$pipe" --true --table "$pipe"
check "names of segments" complains 2 'Segments are numbers or names' \
  sanggwan unfold "$box" --only 'a b'
check "a name with a capital" complains 2 "no segment 'Lid'" \
  sanggwan unfold "$box" --only Lid

# What cannot be unfolded.
echo 'segment(1, curve, line(from(0,0,0), to(1,1,1))).' >"$TMP/line.pl"
check "a curve alone" complains 4 'nothing to unfold' \
  sanggwan unfold "$TMP/line.pl"
check "a curve by name" complains 4 'is a curve' \
  sanggwan unfold "$box" "$TMP/line.pl" --only 2
check "no ending" complains 2 'the ending decides' \
  sanggwan unfold "$box" -o "$TMP/box.xyz"
check "not over the model" complains 2 . \
  sanggwan unfold "$box" -o "$box"

check_report
