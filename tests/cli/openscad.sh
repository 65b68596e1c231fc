# openscad.sh -- .csg files of OpenSCAD: from the command line, and the examples
# of Debian's openscad package, where it is installed.
. "$(dirname "$0")/../check.sh"

cat >"$TMP/bracket.csg" <<'CSG'
difference() {
	cube(size = [20, 10, 10], center = true);
	multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 2], [0, 0, 0, 1]]) {
		cube(size = [16, 20, 10], center = true);
	}
	%sphere($fn = 0, $fa = 12, $fs = 2, r = 99);
}
CSG
total() { # total FILE: the volume of all of a model, in which there is no fault
  "$SANGGWAN" check -q --json "$1" | python3 -c 'import json, sys
report = json.load(sys.stdin)
assert report["faults"] == 0, report["total"]
print(sum(segment["volume"] for segment in report["segments"]))'
}
near() { # near A B TOLERANCE, relative
  awk -v a="$1" -v b="$2" -v t="$3" \
    'BEGIN { d = a - b; if (d < 0) d = -d; exit !(b > 0 && d <= t * b) }'
}

check "a bracket" near "$(total "$TMP/bracket.csg")" 720 1e-12
check "to STL" "$SANGGWAN" eval -q "$TMP/bracket.csg" -o "$TMP/bracket.stl"
check "its volume" near "$(total "$TMP/bracket.stl")" 720 1e-6
check "drawn" "$SANGGWAN" draw -q "$TMP/bracket.csg" -o "$TMP/bracket.svg"
check "with its lines" output 'class="visible' cat "$TMP/bracket.svg"
# Coarse cylinders and spheres, combined: round, as in a world that knows their
# leaves.
cat >"$TMP/round.csg" <<'CSG'
difference() {
	union() {
		cylinder($fn = 12, h = 20, r1 = 8, r2 = 8, center = false);
		multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,20],[0,0,0,1]]) {
			sphere($fn = 12, r = 8);
		}
	}
	multmatrix([[1,0,0,0],[0,0,-1,15],[0,1,0,8],[0,0,0,1]]) {
		cylinder($fn = 10, h = 30, r1 = 4, r2 = 4, center = false);
	}
}
CSG
drawn_twice() {
  "$SANGGWAN" query -q "$TMP/round.csg" "draw('$TMP/world.svg')" &&
    "$SANGGWAN" draw -q "$TMP/round.csg" -o "$TMP/round.svg" &&
    cmp "$TMP/world.svg" "$TMP/round.svg"
}
creases() { grep -c 'class="[a-z]* crease' "$TMP/round.svg"; }
check "a root drawn alone" drawn_twice
check "creases at its rims only" output '^2$' creases
from_stdin() { "$SANGGWAN" check -q --from csg - <"$TMP/bracket.csg"; }
check "from standard input" output '10 polygons' from_stdin
check "its name" output '^segment 1: solid bracket' \
  "$SANGGWAN" check -q "$TMP/bracket.csg"

printf 'cube(size = [1, 1, 1]);\n  text(text = "A");\n' >"$TMP/text.csg"
check "text is not read" complains 3 'text.csg:2:3: .*text is not read' \
  "$SANGGWAN" check "$TMP/text.csg"
check "nor in Korean" complains 3 'text.csg:2:3: .*읽지 않습니다' \
  "$SANGGWAN" check --lang ko "$TMP/text.csg"
printf 'x = 3;\ncube(x);\n' >"$TMP/scad.csg"
check "no .csg file" complains 3 'scad.csg:1:3: here stands =' \
  "$SANGGWAN" eval "$TMP/scad.csg" -o "$TMP/no.stl"
check "nothing is written" [ ! -e "$TMP/no.stl" ]
printf 'polyhedron(points = [[0,0,0],[1,0,0],[0,1,0]], faces = [[0,1,2]]);' \
  >"$TMP/open.csg"
check "an open polyhedron" complains 3 'open.csg:1:1: .*open' \
  "$SANGGWAN" check "$TMP/open.csg"

# example NAME VOLUME: what OpenSCAD 2021.01 makes of its .csg file has this
# volume. bench/openscad has both sides, and example024, which takes longer.
examples=/usr/share/openscad/examples
example() {
  openscad -o "$TMP/$1.csg" "$(find "$examples" -name "$1.scad")" </dev/null \
    >/dev/null 2>&1
  check "$1" near "$(total "$TMP/$1.csg")" "$2" 2e-5
}
refused() { # refused NAME REGEX: named, with its place
  openscad -o "$TMP/$1.csg" "$(find "$examples" -name "$1.scad")" </dev/null \
    >/dev/null 2>&1
  check "$1 is refused" complains 3 "$1\\.csg:[0-9]+:[0-9]+: .*$2" \
    "$SANGGWAN" check -q "$TMP/$1.csg"
}
if [ ! -d "$examples" ]; then
  skip "the examples of OpenSCAD" "no $examples"
elif ! openscad --version 2>&1 | grep -q 2021.01; then
  skip "the examples of OpenSCAD" "their volumes are those of version 2021.01"
else
  example CSG 7773.40893
  example CSG-modules 3346.90649
  example assert 12375.9952
  example candleStand 5208.31761
  example example001 18241.571
  example example002 12241.7321
  example example003 23750
  example example004 2284.38544
  example example005 2233950.24
  example example011 666.666667
  example example014 5936.76483
  example example017 167575.828
  example example018 2573423.23
  example example019 90407.0997
  example example020 915860.378
  example example022 45145.3991
  if [ -d /usr/share/openscad/libraries/MCAD ]; then
    example example023 4790.01194
  else
    echo 'skipped: example023, for the library MCAD of OpenSCAD is not there'
  fi
  example functions 426.498489
  example linear_extrude 12653.9849
  example logo 18686.2167
  refused GEB offset
  refused LetterBlock text
  refused animation hull
  refused example010 surface
  refused example012 import
  refused projection projection
  refused list_comprehensions 'the model is flat'
fi
check_report
