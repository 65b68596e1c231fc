# bench.sh -- programs of bench/ run, on little: what they print is not looked at
# as a measure here. Those that take long, or need peers, with TEST_ALL only.
. "$(dirname "$0")/../check.sh"

export B
check "facts" output '^e/5 by start vertex' bench/facts 2000
check "penetration" output '^[0-9]+ lines in [0-9]+ polygons' \
  bench/penetration 60
check "triangulation" output '^polygon +vertices' bench/triangulation 50
check "startup" output '^draw figure 13 to SVG' bench/startup 1
check "load" output 'triangles: read' bench/load 2000
check "scale" output '^1,056' bench/scale 500
check "growth" output ' B  n.-*[0-9]' env RUNS=1 bench/growth apexes
check "faces" output '^cube, all threads' bench/faces 1
check "gluing" output '^1000 ' bench/gluing 3
check "nesting" output '^50 ' bench/nesting 50
"$SANGGWAN" convert -q facts/cube.pl -o "$TMP/cube.obj"
check "hidden lines" output '^cube +feature' env NO_OCCT=1 ROUNDS=1 \
  VIEWED="$TMP/cube.obj" bench/hidden_lines "$TMP/cube.obj"
check "redraw" output 'a second' swipl -p foreign="$B" bench/redraw.pl -- 64x48
printf 'a\n\n`bench/run x`\n\n    old 1\n\n    old 2\n\ntext\n' >"$TMP/doc.md"
printf 'new 3\n\nnew 4\n' >"$TMP/x"
check "document" bench/document "$TMP/doc.md" x="$TMP/x"
check "what was printed is in it" diff "$TMP/doc.md" - <<'END'
a

`bench/run x`

    new 3

    new 4

text
END
check "no such block" eval "! bench/document $TMP/doc.md y=$TMP/x 2>/dev/null"
if [ -n "${TEST_ALL:-}" ]; then
  check "batch" output '1000000 . looked through' bench/batch 20
  check "serve" output '^undo, picture' bench/serve 1
  check "unfold" output '^model' env NO_BLENDER=1 ROUNDS=1 bench/unfold
  check "curves" output '.' bench/curves cyl2 1
  check "booleans" output '.' bench/booleans degenerate
  check "render" output '.' bench/render 64x48
  check "render difference" output '.' bench/render_difference.py 64x36
  check "mesh picture" output '^4 ' bench/mesh_picture
fi
check_report
