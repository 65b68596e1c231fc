#!/bin/bash
# polls.sh -- no kernel works long without asking whether it is to stop: what a
# signal waits for. Counted in processor time, whatever else the machine does.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
case $(ldd "$sanggwan") in
*san.so*)
  echo 'skipped: polls: a sanitizer is slow'
  finish
  ;;
esac

# Balls of 4 N (N - 1) triangles, and one of a million, a ragged star of 50 N
# corners and a round polygon of 1,000 N, 2 N spheres in each other, 15 N boxes
# side by side.
awk -v n=200 'function at(n, i, j) {
  return i == 0 ? 1 : i == n ? (n - 1) * 2 * n + 2 : (i - 1) * 2*n + j % (2*n) + 2
}
function ball(n, x, file) {
  for (i = 0; i <= n; i++) for (j = 0; j < (i % n ? 2 * n : 1); j++)
    printf "v %.15f %.15f %.15f\n", x + sin(pi*i/n) * cos(pi*j/n), \
      sin(pi*i/n) * sin(pi*j/n), cos(pi*i/n) > file
  for (i = 0; i < n; i++) for (j = 0; j < 2 * n; j++) {
    if (i < n - 1)
      print "f", at(n, i, j), at(n, i+1, j), at(n, i+1, j+1) > file
    if (i > 0)
      print "f", at(n, i, j), at(n, i+1, j+1), at(n, i, j+1) > file
  }
}
BEGIN { pi = 3.14159265358979
  ball(n, 0, "'"$work"'/ball0.obj")
  ball(n, 0.7, "'"$work"'/ball1.obj")
  ball(500, 0, "'"$work"'/million.obj")
  ball(60, 0, "'"$work"'/small.obj")
  file = "'"$work"'/star.off"
  m = 50 * n
  print "OFF\n" m, 1, 0 > file
  for (i = 0; i < m; i++) {
    r = 0.2 + (i * 0.6180339887) % 1
    printf "%.15f %.15f 0\n", r * cos(2*pi*i/m), r * sin(2*pi*i/m) > file
  }
  printf "%d", m > file
  for (i = 0; i < m; i++) printf " %d", i > file
  print "" > file
  file = "'"$work"'/round.off"
  m = 1000 * n
  print "OFF\n" m, 1, 0 > file
  for (i = 0; i < m; i++)
    printf "%.15f %.15f 0\n", cos(2*pi*i/m), sin(2*pi*i/m) > file
  printf "%d", m > file
  for (i = 0; i < m; i++) printf " %d", i > file
  print "" > file
  file = "'"$work"'/nested.pl"
  for (i = 1; i <= 2 * n; i++)
    printf "segment(%d, solid, sphere(radius(%g), facets(12))).\n",
      i, 1 + 0.01 * i > file
  file = "'"$work"'/boxes.pl"
  for (i = 1; i <= 15 * n; i++)
    printf "segment(%d, solid, at([translate(%d,%d,0)], box(size(1,1,1)))).\n",
      i, i % 40, int(i / 40) > file
}'

most=0
# asks NAME ARGUMENT...: at least every 140 ms of its processor time.
asks() {
  local name=$1 took
  shift
  UNASKED=$work/unasked LD_PRELOAD=$B/tests/unasked.so \
    "$sanggwan" "$@" >"$work/out" 2>"$work/err" </dev/null
  status=$?
  check "$name: done" status_is 0
  took=$(head -n 1 "$work/unasked")
  [ "$took" -lt 140 ] || sed -n 2,12p "$work/unasked"
  check "$name: asks" test "$took" -lt 140
  [ "$took" -le "$most" ] || most=$took
}
asks check check "$work/ball0.obj"
asks million check "$work/million.obj"
asks 'million, drawn' draw -q "$work/million.obj" -o "$work/a.svg"
asks star check "$work/star.off"
asks round check "$work/round.off"
asks nested draw -q "$work/nested.pl" -o "$work/a.svg"
asks boxes draw -q "$work/boxes.pl" -o "$work/a.svg"
asks glue glue -q "$work/boxes.pl" -o "$work/a.pl"
asks penetrate penetrate -q "$work/ball0.obj" "$work/ball1.obj" -o "$work/a.pl"
asks union union -q "$work/ball0.obj" "$work/ball1.obj" -o "$work/a.off"
asks render render -q "$work/ball0.obj" -o "$work/a.png"
asks split split -q "$work/ball0.obj" --plane 0,0,1,-0.1 -o "$work/a.stl"
asks unfold unfold -q "$work/small.obj" -o "$work/a.svg"
asks query query -q "$work/ball0.obj" \
  'aggregate_all(count, (t(1,_,_,A,B,_), e(1,_,B,A,_)), N)'
asks facts convert -q "$work/a.pl" -o "$work/a.stl"
asks convert convert -q "$work/ball0.obj" -o "$work/a.pl"
printf 'counted: the longest of 16 commands without a question took %d ms\n' \
  "$most"
finish
