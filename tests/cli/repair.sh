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

# Boxes and tetrahedra with corners on halves round (OFFSET, OFFSET, OFFSET), so
# far away that no tolerance tells what goes through what: N of them.
tangle() { # tangle SEED N OFFSET
  awk -v seed="$1" -v n="$2" -v offset="$3" '
    function random(m) { # 0 .. m - 1
      seed = (seed * 16807) % 2147483647
      return int(seed / 2147483647 * m)
    }
    function corner(x, y, z) {
      v = v sprintf("%.17g %.17g %.17g\n", offset + x, offset + y, offset + z)
      vs++
    }
    function face(a, b, c) {
      f = f sprintf("3 %d %d %d\n", first + a, first + b, first + c)
      fs++
    }
    function box(    x, y, z, i) {
      x = random(9) / 2; y = random(9) / 2; z = random(9) / 2
      a = 1 + random(3); b = 1 + random(3); c = 1 + random(3)
      for (i = 0; i < 8; i++)
        corner(x + (i % 2) * a, y + int(i / 2) % 2 * b, z + int(i / 4) * c)
      split("0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5", q, " ")
      for (i = 1; i <= 24; i += 4) {
        face(q[i], q[i + 1], q[i + 2])
        face(q[i], q[i + 2], q[i + 3])
      }
    }
    function tetrahedron(    x, y, z) {
      x = random(9) / 2; y = random(9) / 2; z = random(9) / 2
      corner(x, y, z)
      corner(x + 1 + random(5) / 2, y + random(3) / 2, z)
      corner(x, y + 1 + random(5) / 2, z + random(3) / 2)
      corner(x + random(3) / 2, y, z + 2 + random(5) / 2)
      face(0, 2, 1); face(0, 3, 2); face(0, 1, 3); face(1, 2, 3)
    }
    BEGIN {
      for (k = 0; k < n; k++) {
        first = vs + 0
        if (random(2)) box(); else tetrahedron()
      }
      printf "OFF\n%d %d 0\n%s%s", vs, fs, v, f
    }'
}

# What --repair writes is clean in the numbers of the file, or there is no file
# and the message says what remains.
repaired() { # repaired MODEL OUTPUT
  local status
  sanggwan union --repair "$1" -o "$2"
  status=$?
  case $status in
  0) "$B/tests/solid_checker" "$2" ;;
  4) [ ! -e "$2" ] ;;
  *) false ;;
  esac
}

for seed in 1 2 3 4 5 6 7 8 9 10; do
  tangle $seed $((seed + 1)) 35184372088832 >"$TMP/far.off" # 2^45
  check "tangle $seed, far away" repaired "$TMP/far.off" "$TMP/far$seed-out.off"
  tangle $seed $((seed + 1)) 1048576 >"$TMP/far.off" # halves of a float32
  check "tangle $seed, rounded" repaired "$TMP/far.off" "$TMP/far$seed.stl"
done
check "most of them are written" test "$(ls "$TMP"/far*-out.off "$TMP"/far*.stl | wc -l)" -ge 16

# A mesh with a face without area: every pass finds it, and it is said once.
{
  printf 'OFF\n9 14 0\n'
  printf '%s %s %s\n' 0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 0.5 0 0
  printf '3 %s %s %s\n' 0 2 1 0 3 2 4 5 6 4 6 7 0 8 5 8 1 5 0 1 8 0 5 4 \
    1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7
} >"$TMP/sliver.off"
once() { # once REGEX COMMAND...: of the lines of stderr one matches.
  local regex=$1
  shift
  "$@" 2>"$TMP/errors" >"$TMP/output"
  [ "$(grep -Ec -- "$regex" "$TMP/errors")" = 1 ] || { cat "$TMP/errors"; false; }
}
check "no area is said once" once 'without area in segment 1' \
  sanggwan union --repair "$TMP/sliver.off" -o "$TMP/sliver-out.off"
check "of each operand" once 'without area in segment 2' \
  sanggwan union --repair "$TMP/sliver.off" "$TMP/sliver.off" -o "$TMP/sliver-out.off"

check_report
