# precision.sh -- what a tolerance moves is said, and with --strict refused.
. "$(dirname "$0")/harness.bash"

cat >"$work/step.pl" <<'MODEL'
segment(1, solid, union([box(size(4,4,4)),
    at([translate(1,1,4)], box(size(2,2,0.005)))])).
MODEL
cat >"$work/wall.pl" <<'MODEL'
segment(1, solid, at([translate(1000000.5,0,0)], difference([box(size(10,10,10)),
    at([translate(0,0,0.25)], box(size(9.5,9.5,20)))]))).
MODEL

run eval "$work/wall.pl" --strict
check "a wall far away" status_is 0
check "has its volume" has "volume 120.062" "$work/out"
check "without a word" silent err

run eval "$work/step.pl" --tolerance 0.01
check "a step lower than the tolerance" status_is 0
check "is a warning" has "sanggwan: warning: made one face: 0.005 off it"
check "with the place" has "near 0 0 4 (segment"

run eval "$work/step.pl" --tolerance 0.01 --strict -o "$work/step.off"
check "refused" status_is 4
check "by the program's name" has "sanggwan: made one face: 0.005 off it"
check "nothing is written" absent "$work/step.off"

cat >"$work/gap.pl" <<'MODEL'
segment(1, solid, box(size(1,1,1))).
segment(2, solid, at([translate(1.0005,0,0)], box(size(1,1,1)))).
MODEL
run union "$work/gap.pl" --tolerance 0.001 -o "$work/gap.off"
check "a gap that a tolerance closes" status_is 0
check "is a warning, too" has \
  "warning: made to touch: a gap of 0.0005, which rounding does not explain"
check "with its place" has "near 0.5 0.5 0 (segments 1 and 2)"
run union "$work/gap.pl" --tolerance 0.001 --strict -o "$work/no_gap.off"
check "it is refused" status_is 4
check "and not written" absent "$work/no_gap.off"
run union "$work/gap.pl" --strict -o "$work/gap.off"
check "left open it needs no word" status_is 0

# A glue that is written keeps the tolerance that it was asked for.
run glue "$work/gap.pl" -q --tolerance 0.001 -o "$work/glued.pl"
check "a glue that closes a gap" has "1 part, 3 regions" "$work/out"
check "has its tolerance in its file" has "gluing(3, tolerance(0.001))." \
  "$work/glued.pl"
run cells "$work/glued.pl" -q
check "read again it is closed" has "1 part, 3 regions" "$work/out"
run check "$work/glued.pl"
check "for check, too" has "12 vertices, 20 edges, 11 polygons" "$work/out"
run glue "$work/glued.pl" -q -o "$work/again.pl"
check "in a glue of it, too" has "1 part, 3 regions" "$work/out"
run cells "$work/again.pl" -q
check "and in the file of that" has "1 part, 3 regions" "$work/out"
run glue "$work/glued.pl" -q --tolerance 0
check "unless another one is given" has "2 parts, 3 regions" "$work/out"
run unglue "$work/glued.pl" -o "$work/parts.pl"
check "what is taken apart has none" hasnt tolerance "$work/parts.pl"
sed 's/tolerance(0.001)/tolerance(-1)/' "$work/glued.pl" >"$work/less.pl"
run cells "$work/less.pl"
check "one below 0 is refused" status_is 4
check "with its place" has "less.pl:"
run glue "$work/gap.pl" -q -o "$work/open.pl"
check "without it nothing is kept" hasnt tolerance "$work/open.pl"

run eval "$work/step.pl" --strict -o "$work/step.off"
check "without it all is done" status_is 0
check "a file says what it holds" has "# precision 0" "$work/step.off"

finish
