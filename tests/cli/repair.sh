# repair.sh -- operands that a Boolean refuses, and --repair.
. "$(dirname "$0")/../check.sh"

sanggwan() { "$SANGGWAN" "$@"; }
# A cube whose faces have vertices of their own.
cat >"$TMP/soup.pl" <<'MODEL'
segment(1, solid, soup).
v(1,1,0,0,0). v(1,2,0,2,0). v(1,3,2,2,0). v(1,4,2,0,0).
v(1,5,0,0,2). v(1,6,2,0,2). v(1,7,2,2,2). v(1,8,0,2,2).
v(1,9,0,0,0). v(1,10,2,0,0). v(1,11,2,0,2). v(1,12,0,0,2).
v(1,13,2,0,0). v(1,14,2,2,0). v(1,15,2,2,2). v(1,16,2,0,2).
v(1,17,2,2,0). v(1,18,0,2,0). v(1,19,0,2,2). v(1,20,2,2,2).
v(1,21,0,2,0). v(1,22,0,0,0). v(1,23,0,0,2). v(1,24,0,2,2).
p(1,1,[1,2,3,4]). p(1,2,[5,6,7,8]). p(1,3,[9,10,11,12]).
p(1,4,[13,14,15,16]). p(1,5,[17,18,19,20]). p(1,6,[21,22,23,24]).
MODEL
# One that is open, and one whose polygons all look inward.
grep -v 'p(1,4' "$TMP/soup.pl" >"$TMP/open.pl"
printf 'p(1,5,[17,18,19,20]). p(1,6,[21,22,23,24]).\n' >>"$TMP/open.pl"
cat >"$TMP/inward.pl" <<'MODEL'
segment(1, solid, inward).
v(1,1,0,0,0). v(1,2,2,0,0). v(1,3,0,2,0). v(1,4,0,0,2).
p(1,1,[1,2,3]). p(1,2,[1,4,2]). p(1,3,[2,4,3]). p(1,4,[1,3,4]).
MODEL
cat >"$TMP/cube.pl" <<'MODEL'
segment(1, solid, at([translate(5, 0, 0)], box(size(2, 2, 2)))).
MODEL
soup=$TMP/soup.pl open=$TMP/open.pl inward=$TMP/inward.pl cube=$TMP/cube.pl

check "faces that share no vertex are refused" complains 4 \
  '24 edge.*one side only' sanggwan union $soup $cube
check "with their edges" complains 4 \
  '1-2 from \(0.*, 0.*, 0.*\) to \(0.*, 2.*, 0.*\), faces: 1' \
  sanggwan union $soup $cube
check "--repair welds them" output 'volume 16$' \
  sanggwan union --repair $soup $cube
check "and says so" complains 0 '16 vertex.*welded' \
  sanggwan union --repair $soup $cube
check "a hole is not filled" complains 4 'edge.*one side only' \
  sanggwan union --repair $open $cube
check "inside out is warned of" complains 0 'inside out, so nothing is inside' \
  sanggwan union $inward $cube
check "--repair turns it" output 'volume 9\.33333$' \
  sanggwan union --repair $inward $cube

check_report
