# csg.sh -- trees and the verbs of solids: union, intersection, difference,
# split, eval; what is wrong with a tree is said at its place in the file.
# covers: solid_verbs
. "$(dirname "$0")/../check.sh"

sanggwan() { "$SANGGWAN" "$@"; }
cat >"$TMP/cube.pl" <<'MODEL'
segment(1, solid, box(size(2, 2, 2))).
MODEL
cat >"$TMP/moved.pl" <<'MODEL'
segment(1, solid, at([translate(1, 0, 0)], box(size(2, 2, 2)))).
MODEL
cat >"$TMP/tree.pl" <<'MODEL'
segment(1, solid, box(size(2, 2, 2))).
segment(2, solid, named(stairs, difference([1, at([translate(1, 0, 1)], 1)]))).
MODEL
cube=$TMP/cube.pl moved=$TMP/moved.pl tree=$TMP/tree.pl

# The verbs, with closed forms: cubes of side 2 that share half.
check "union" output '^union: .*volume 12$' sanggwan union $cube $moved
check "intersection" output '^intersection: .*volume 4$' \
  sanggwan intersection $cube $moved
check "difference" output '^difference: .*volume 4$' \
  sanggwan difference $cube $moved
check "difference with itself is empty" complains 0 \
  'warning: .*\(difference\) is empty' sanggwan difference $cube $cube
check "which --strict does not take" complains 1 'strict' \
  sanggwan difference $cube $cube --strict
check "four operands" output 'volume 12$' \
  sanggwan union $cube $moved $tree $moved
check "eval" output '^stairs: 8 polygons, 12 vertices, 18 edges.* volume 6$' \
  sanggwan eval $tree
check "eval as JSON" eval "sanggwan eval $tree --json |
  python3 -c 'import json,sys; d, = json.load(sys.stdin)
assert d[\"volume\"] == 6 and d[\"faces\"] == 8 and d[\"name\"] == \"stairs\"'"
check "Korean" output '다각형 8개, 꼭짓점 12개.*부피 6$' \
  sanggwan eval $tree --lang ko
check "split by a plane" output 'volume 1$' \
  sanggwan split $cube --plane 0,0,1,-0.25
check "the parts have names" output '^above: .*volume 7$' \
  sanggwan split $cube --plane 0,0,1,-0.25
check "also in a file" eval "sanggwan split -q $cube --plane 1,0,0,0 -o - \
  --format obj | grep '^o ' | tr '\n' ' ' | grep -x 'o below o above '"
check "the other part" output 'volume 7$' \
  sanggwan split $cube --plane 0,0,1,-0.25 --side above
check "one part alone" eval \
  "[ \$(sanggwan split $cube --plane 0,0,1,-1 --side above | wc -l) = 1 ]"
check "split by a solid" output 'volume 4$' \
  sanggwan split $cube --by $moved --side inside

cat >"$TMP/sheet.pl" <<'MODEL'
segment(1, surface, at([translate(0, 0, 0.5)], rectangle(size(3, 3)))).
MODEL
check "split by a surface" output 'volume 2$' \
  sanggwan split $cube --by "$TMP/sheet.pl"
check "above it" output 'volume 6$' \
  sanggwan split $cube --by "$TMP/sheet.pl" --side above
check "has no inside" complains 2 'none of below, above' \
  sanggwan split $cube --by "$TMP/sheet.pl" --side inside
sed 's/3, 3/3, 1/' "$TMP/sheet.pl" >"$TMP/short.pl"
check "and must go through" complains 3 'short.pl: .*does not go all the way' \
  sanggwan split $cube --by "$TMP/short.pl"

# What float32 has no room for is not called empty.
echo 'segment(1, solid, union([at([translate(1.0e9,0,0)], box(size(1,1,1)))])).' \
  >"$TMP/far.pl"
check "too thin for float32" complains 0 'far.stl: .*thinner than the rounding' \
  sanggwan eval "$TMP/far.pl" -o "$TMP/far.stl"
check "not for doubles" complains 0 'wrote .*far.off' \
  sanggwan eval "$TMP/far.pl" -o "$TMP/far.off"

# Files out, read back.
for format in stl off obj ply pl; do
  check "$format" sanggwan eval -q $tree -o "$TMP/out.$format"
  check "$format is a sound solid" output 'volume +6$' \
    sanggwan check "$TMP/out.$format"
done
check "again to standard output" eval "sanggwan eval -q $tree --format off \
  -o - | cmp - '$TMP/out.off'"
check "an empty solid is a file without faces" complains 0 \
  'warning: .*empty.off: the solid is empty' \
  sanggwan difference $cube $cube -o "$TMP/empty.off"
check "really" output '^0 0 0$' cat "$TMP/empty.off"
check "the result is one operand of the next" output 'volume 8$' \
  sanggwan union "$TMP/out.stl" $cube
check "several segments of a file are one operand" output 'volume 12$' \
  eval "sanggwan split -q $cube --plane 1,0,0,0 -o '$TMP/halves.obj' &&
        '$SANGGWAN' union '$TMP/halves.obj' $moved"

for ending in stl off ply; do
  check "each part of a split is a file: $ending" output 'volume  *2$' \
    eval "sanggwan split -q $cube --plane 0,0,1,-0.5 -o '$TMP/part.$ending' &&
          [ ! -e '$TMP/part.$ending' ] &&
          '$SANGGWAN' check '$TMP/part-below.$ending'"
  check "also the other one: $ending" output 'volume  *6$' \
    sanggwan check "$TMP/part-above.$ending"
  check "one side is the file: $ending" output 'volume  *6$' \
    eval "sanggwan split -q $cube --plane 0,0,1,-0.5 --side above \
            -o '$TMP/one.$ending' && '$SANGGWAN' check '$TMP/one.$ending'"
done
check "standard output has both parts" output '^16 12 0$' \
  sanggwan split -q $cube --plane 0,0,1,-0.5 --format off -o -

cat >"$TMP/bored.csg" <<'MODEL'
difference() {
  cube(size = [4, 4, 1], center = false);
  multmatrix([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, -1], [0, 0, 0, 1]]) {
    cube(size = [2, 2, 3], center = false);
  }
}
MODEL
check "a tree of OpenSCAD" output '^bored: 10 polygons, 16 vert.*volume 12$' \
  sanggwan eval "$TMP/bored.csg"
check "its faults are named with the file" complains 3 'bad.csg' eval \
  "echo 'hull() { cube(size = 1); }' >'$TMP/bad.csg';
   sanggwan eval '$TMP/bad.csg'"
check "from standard input" output 'volume 12$' \
  eval "sanggwan eval --from csg - <'$TMP/bored.csg'"

# Other verbs look at roots.
check "check sees the root alone" eval \
  "[ \$(sanggwan check $tree | grep -c '^segment') = 1 ]"
check "draw" output '"segment":2' sanggwan draw -q $tree --format json -o -
check "and the root alone" eval \
  "! sanggwan draw -q $tree --format json -o - | grep -q '\"segment\":1,'"
check "convert keeps a tree" output '^segment\(2, solid, named\(stairs, diff' \
  sanggwan convert $tree -o -
check "convert to a mesh evaluates it" output 'volume +6$' \
  eval "sanggwan convert -q $tree -o '$TMP/converted.obj' &&
        sanggwan check '$TMP/converted.obj'"
check "query sees all" output '^3 +same +\[1\]' \
  sanggwan query $tree 'node(N, Operation, Children, _)'
check "--stats" eval "sanggwan eval $tree --stats 2>&1 >'$TMP/summary' |
  python3 -c 'import json,sys; d = json.load(sys.stdin)[\"csg\"]
assert d == {\"evaluated\": 1, \"around\": 0, \"reused\": 0, \"pieces\":
  {\"leaves\": 2, \"arrangements\": 1, \"made\": 2, \"found\": 0}}, d'"

# What is wrong, with its place. The line after that says what to do.
wrong() {
  local regex=$1
  shift
  { printf 'segment(1, solid, box(size(1, 1, 1))).\n'
    printf 'segment(8, surface, rectangle(size(1, 1))).\n'
    printf 'segment(9, curve, line(from(0, 0, 0), to(1, 1, 1))).\n'
    printf '%s\n' "$@"; } >"$TMP/wrong.pl"
  for language in en ko; do
    complains 3 '^  ' sanggwan eval "$TMP/wrong.pl" --lang $language \
      -o "$TMP/wrong.stl" && [ ! -e "$TMP/wrong.stl" ] || return 1
  done
  complains 3 "^$TMP/wrong.pl:[0-9]+:[0-9]+: $regex" \
    sanggwan eval "$TMP/wrong.pl"
}
check "unknown operation" wrong 'segment 2 .*unoin\(\[1\]\) is no primitive' \
  'segment(2, solid, unoin([1])).'
check "meant operation" complains 3 '^  Did you mean union\?$' \
  sanggwan eval "$TMP/wrong.pl"
check "unknown operand" wrong 'foo\(2\) is no operand' \
  'segment(2, solid, union([1, foo(2)])).'
check "unknown placed operand" wrong 'foo is no operand' \
  'segment(2, solid, union([1, at([scale(2)], foo)])).'
check "unknown step" wrong 'shift\(1\) is no step' \
  'segment(2, solid, union([1, at([shift(1)], 1)])).'
check "no operands" wrong 'difference has no operands' \
  'segment(2, solid, difference([])).'
check "no list" wrong 'the operands of union should be a list, not 1' \
  'segment(2, solid, union(1)).'
check "missing child" wrong 'segment 2 has the operand 7, and there is no' \
  'segment(2, solid, union([1, 7])).'
check "a cycle" wrong 'a segment is its own operand: 2 -> 3 -> 2' \
  'segment(2, solid, union([1, 3])).' 'segment(3, solid, union([2, 1])).'
check "itself" wrong 'a segment is its own operand: 2 -> 2' \
  'segment(2, solid, union([1, 2])).'
check "absurdly many leaves" wrong 'segment 28 would be made of 131,072' \
  "$(for i in $(seq 12 31); do
       echo "segment($i, solid, union([$((i == 12 ? 1 : i - 1)), \
         at([translate($i, 0, 0)], $((i == 12 ? 1 : i - 1)))]))."
     done)"
check "a curve" wrong 'operand 9 of segment 2 is no solid but a curve' \
  'segment(2, solid, union([1, 9])).'
check "an open surface" wrong 'operand 8 of segment 2 is an open surface: int' \
  'segment(2, solid, intersection([1, 8])).'
check "no plane" wrong 'plane\(0,0,0,1\) is no plane' \
  'segment(2, solid, split(1, plane(0, 0, 0, 1), below)).'
check "no side of a plane" wrong 'a solid is split on the side below or above here, not left' \
  'segment(2, solid, split(1, plane(0, 0, 1, 1), left)).'
check "no side of a solid" wrong 'a solid .* inside or outside here, not below' \
  'segment(2, solid, split(1, 1, below)).'
check "a wrong primitive" wrong 'radius\(0\) should be' \
  'segment(2, solid, union([1, sphere(radius(0))])).'
echo 'segment(2, solid, union([7])).' >"$TMP/missing.pl"
check "in the second file, by its own numbers" complains 3 \
  "^$TMP/missing.pl:1:19: segment 2 has the operand 7" \
  sanggwan union $tree "$TMP/missing.pl"
cat >"$TMP/flat.pl" <<'MODEL'
v(1, 1, 0, 0, 0). v(1, 2, 1, 0, 0). v(1, 3, 0, 1, 0).
p(1, 1, [1, 2, 3]). p(1, 2, [1, 3, 2]).
MODEL
check "no volume" complains 4 "^$TMP/flat.pl: segment 2 cannot be an operand" \
  sanggwan union $cube "$TMP/flat.pl"
cat >"$TMP/open.pl" <<'MODEL'
v(1, 1, 0, 0, 0). v(1, 2, 1, 0, 0). v(1, 3, 0, 1, 0). v(1, 4, 0, 0, 1).
p(1, 1, [1, 3, 2]). p(1, 2, [1, 2, 4]). p(1, 3, [2, 3, 4]).
segment(1, solid, roof).
MODEL
check "an open solid is refused, its edges named" complains 4 \
  '(1-3|3-4|4-1|3-1|4-3|1-4) from' \
  sanggwan union $cube "$TMP/open.pl" -o "$TMP/no.stl"
check "no file then" test ! -e "$TMP/no.stl"
cat >"$TMP/open.off" <<'MESH'
OFF
4 3 0
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
MESH
check "so is an open mesh, by its file" complains 4 \
  "^$TMP/open.off: segment 2 cannot be an operand" \
  sanggwan difference $cube "$TMP/open.off"
check "its edges named" complains 4 '1-3 from .*, faces: 1' \
  sanggwan split "$TMP/open.off" --plane 0,0,1,-.5
check "united it is a surface, with a warning" complains 0 \
  'segment 2 \(open\) is taken for a surface' \
  sanggwan union $cube "$TMP/open.off"
check "a surface that is meant needs none" eval \
  "! sanggwan union $cube $TMP/sheet.pl 2>&1 >/dev/null | grep ."
cat >"$TMP/soup.off" <<'MESH'
OFF
12 4 0
0 0 0
0 1 0
1 0 0
0 0 0
1 0 0
0 0 1
1 0 0
0 1 0
0 0 1
0 1 0
0 0 0
0 0 1
3 0 1 2
3 3 4 5
3 6 7 8
3 9 10 11
MESH
check "--repair makes a solid of one whose faces share nothing" \
  output 'volume 0.166667$' sanggwan intersection --repair $cube "$TMP/soup.off"
echo 'segment(1, solid, union(box(size(1,1,1)), box(size(2,1,1)))).' \
  >"$TMP/shape.pl"
check "operands without brackets" complains 3 \
  'should look like union\(\[Operand, \.\.\.\]\)' sanggwan eval "$TMP/shape.pl"
echo 'segment(1, solid, difference([box(size(1,1,1)), box(size(2,2,2))])).' \
  >"$TMP/nothing.pl"
check "an empty node is named by check" complains 0 'is empty: nothing is left' \
  sanggwan check "$TMP/nothing.pl"
check "and when it is drawn" complains 0 'is empty: nothing is left' \
  sanggwan draw "$TMP/nothing.pl" -o "$TMP/nothing.svg"
check "one operand" complains 2 'difference needs two models' \
  sanggwan difference $cube
check "no plane given" complains 2 'option --plane or --by is missing' \
  sanggwan split $cube
check "both given" complains 2 'do not go together' \
  sanggwan split $cube --plane 0,0,1,0 --by $moved
check "a side of the other" complains 2 'none of below, above' \
  sanggwan split $cube --plane 0,0,1,0 --side inside
check "a plane that is none" complains 2 'should look like A,B,C,D' \
  sanggwan split $cube --plane 0,0,1
check "or has no normal" complains 2 'option --plane: 0,0,0,1 is no plane' \
  sanggwan split $cube --plane 0,0,0,1
check "a plane as people write it" output '^below: .*volume 1$' \
  sanggwan split $cube --plane 0,0,1,-.25
check "not as Prolog does" complains 2 'should look like A,B,C,D' \
  sanggwan split $cube --plane 0,0,1,0x1
check "nor a tolerance" complains 2 '1.0Inf is no number from 0 on' \
  sanggwan union $cube $moved --tolerance 1.0Inf
check "an ending that is none" complains 2 'the ending decides' \
  sanggwan union $cube $moved -o "$TMP/x.svg"

check_report
