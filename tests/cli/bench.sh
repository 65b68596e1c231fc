# bench.sh -- the programs of bench/ run, on little: what they print is not looked
# at as a measure here. With TEST_ALL on more, and with the peers.
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
check "joined parts" output '^ +100 .* 658' env LARGEST=100 \
  swipl -p foreign="$B" bench/joined_parts.pl
check "serve" output '^ *undo, picture' bench/serve 1
check "visitors" output '^pipe_tee +[1-9]' bench/visitors 2 1
check "batch" output '1000 . looked through' env LOOKED=1000 bench/batch 5
check "mesh picture" output '^4 ' bench/mesh_picture 20
check "unfold" output '^sphere_1k' env NO_BLENDER=1 ROUNDS=1 \
  bench/unfold sphere_1k
check "run" output '^## faces' bench/run -n 1 faces

# beside NAME REGEX COMMAND...: as check, of what needs something that is not
# everywhere, and says so.
beside() {
  check "$1" output "^skipped|$2" "${@:3}"
  ! grep -q '^skipped' "$TMP/output" ||
    skip "$1" "$(sed -n 's/^skipped: //p' "$TMP/output")"
}
export NO_PEERS=1
beside "curves" '^cyl2 +sanggwan' bench/curves cyl2 1
beside "booleans" '^1e5: 3 of 3' env CASES=cube2 bench/booleans degenerate scales
beside "booleans of files" '^sanggwan .*good=yes' env FILES_CASE=sph1k ROUNDS=1 \
  LIMIT=10 bench/booleans files
beside "booleans of many" '^20 spheres apart.*good=yes' env SPHERES=20 \
  bench/booleans many
beside "render" '^a_box' bench/render 64x48 a_box
beside "render difference" '^a_box' bench/render_difference.py 64x36 a_box
beside "openscad" '^example001' bench/openscad example001
beside "opening" '^pipe_tee' bench/opening 1
if [ -n "${TEST_ALL:-}" ]; then
  unset NO_PEERS
  beside "many jobs" '1000000 . looked through' bench/batch 20
  beside "developments" '^model' env NO_BLENDER=1 ROUNDS=1 bench/unfold
  beside "curves and peers" '^cyl2 +sanggwan' bench/curves cyl2 1
  beside "booleans and peers" '.' bench/booleans degenerate
  beside "a tree" 'one leaf moved' env MOVES=3 bench/booleans tree
  beside "scenes" '^e_mix' bench/render 64x48
  beside "differences" '^e_mix' bench/render_difference.py 64x36
  beside "a large mesh" '^4 ' bench/mesh_picture
fi

# Each file of bench/ is run here, or is a part of one that is.
parts() {
  local file name left=0
  for file in bench/*; do
    name=${file##*/}
    grep -Eq "bench/$name( |\$|\\\\)" tests/cli/bench.sh ||
      grep -lqF "$name" $(find bench -type f ! -name "$name") ||
      grep -Eqr "^:- use_module\(.*${name%.pl}\)" bench ||
      { echo "not run: $file"; left=1; }
  done
  return $left
}
check "none is left out" parts
check_report
