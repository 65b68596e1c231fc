#!/bin/bash
# bad_input.sh -- every wrong input has a clear message and exit code 3, names
# its file and line, and leaves nothing half-written.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
mkdir "$work/in" "$work/to"

# refused NAME ENDING TEXT MESSAGE [PLACE]: a model with TEXT is refused.
refused() {
  local file=$work/in/$1.$2
  printf '%b' "$3" >"$file"
  run draw "$file" -o "$work/to/a.svg"
  check "$1: exit code" status_is 3
  check "$1: message" has "$4"
  check "$1: place" has "$file:${5:-}"
  check "$1: nothing written" holds "$work/to"
  check "$1: nothing on stdout" silent out
}

triangle='v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). p(1,1,[1,2,3]).\n'

refused directive pl "$triangle:- shell('touch $work/to/x')." \
  'a directive in a model file' '2:1: '
refused rule pl "${triangle}v(1,4,X,0,0) :- X is 1." 'a rule in a model' '2:1: '
refused relation pl "${triangle}vertex(1,4)." 'no relation vertex/2' '2:1: '
refused arity pl "${triangle}v(1,4,0,0)." 'has 4 arguments here, it needs 5' \
  '2:1: '
refused type pl "${triangle}v(1,4,zero,0,0)." 'should be a number' '2:7: '
refused nan pl "${triangle}v(1,4,0,1.5NaN,0)." 'a finite number' '2:9: '
refused infinite pl "${triangle}v(1,4,0,0,inf)." 'should be a number' '2:11: '
refused infinity pl "${triangle}v(1,4,0,0,1.0Inf)." 'a finite number' '2:11: '
refused far_apart pl "${triangle}v(1,4,1e300,0,0)." 'other units' '2:7: '
refused missing pl "${triangle}p(1,2,[1,2,9])." 'has no vertex 9' '2:7: '
refused edge pl "${triangle}e(1,1,1,9,1)." 'has no vertex 9' '2:9: '
refused open pl \
  'v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). e(1,1,1,2,1). e(1,2,2,3,1).
e(1,3,1,3,1). p(1,1,[1,2,3]).' 'does not close at vertex' '2:21: '
refused jump pl "${triangle}p(1,2,[1,2,3,1,-2])." 'a jump leads nowhere' '2:7: '
refused twice pl "${triangle}v(1,3,0,0,0)." 'two facts v' '2:1: '
refused origin_twice pl \
  "${triangle}origin(1,v(1),line(2)). origin(1,v(1),line(3))." \
  'two facts origin with the numbers 1, v(1)' '2:'
refused no_leaf_e pl "${triangle}leaf_p(1,1,[1,2,3])." \
  'segment 1 has no leaf_e 1' '2:'
refused empty pl '' 'the model is empty'
refused comment pl '% nothing\n' 'the model is empty'
refused open_comment pl 'v(1, 1, 0, 0, 0).\n/* open\n' 'pl:3: '
refused variable pl 'segment(1, Kind, a).\n' 'Kind of segment is _,'
refused large_id pl 'v(1, 3000000000, 0, 0, 0).\n' '2147483647'
refused truncated pl "${triangle}v(1,4,0," 'ends in the middle of a fact' '2:'
refused quote pl "${triangle}segment(1,solid,'abc).\n" 'quoted text' '2:'
refused text pl 'solid cube.\n' 'no Prolog text' '1:'
refused primitive pl 'segment(1, solid, cone(radius(-1), height(1))).' \
  'should be radius(a length above 0)' '1:19: '
refused nested pl "segment(1,solid,$(printf '[%.0s' {1..20000})$(
  printf ']%.0s' {1..20000}))." 'levels of terms, lists and operators in one another'

# Bytes that are not UTF-8: one warning, in the file that was named.
printf "segment(1, solid, '\xff').\nv(1,1,0,0,'\xff').\n" >"$work/in/bytes.pl"
warned() { is "$(grep -c 'warning: ' "$work/err")" 1; }
run check "$work/in/bytes.pl"
check "bytes: exit code" status_is 3
check "bytes: one warning" warned
check "bytes: names the file" has "$work/in/bytes.pl:1: the file holds bytes"
check "bytes: the fault" has "$work/in/bytes.pl:2:11: Z of v"
"$sanggwan" check - <"$work/in/bytes.pl" >"$work/out" 2>"$work/err"
check "bytes in standard input" warned
check "bytes in standard input: no name of a copy" has '<stdin>:1: the file'

refused stl_empty stl '' 'the file is empty'
refused stl_truncated stl 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0' \
  '' ''
refused stl_word stl 'solid a\n facet normal 0 0 1\n outer loop
 vertex 0 0 zero\n' 'no number' '4:'
refused stl_nan stl 'solid a\n facet normal 0 0 1\n outer loop
 vertex 0 0 nan\n vertex 1 0 0\n vertex 0 1 0\n endloop\n endfacet\nendsolid\n' \
  'finite' '4:'
refused off_truncated off 'OFF\n3 1 0\n0 0 0\n1 0 0\n' '' '5:'
refused off_index off 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' \
  'no vertex 7' '6:'
refused off_inf off 'OFF\n3 1 0\n0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n' 'finite' '3:'
refused obj_index obj 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' 'no vertex 9' '4:'
refused obj_word obj 'v 0 0 x\n' 'no number' '1:'
refused obj_line obj 'v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n' 'nothing stands where' '2:'
refused obj_empty obj '# nothing\n' 'neither a polygon nor a curve'
refused ply_header ply 'ply\nformat ascii 1.0\nelement vertex 3\n' '' ''
refused ply_truncated ply 'ply\nformat ascii 1.0\nelement vertex 3
property float x\nproperty float y\nproperty float z\nelement face 1
property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n' '' ''
refused far_obj obj 'v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\n' '' '2:'

# What STL has no numbers for.
echo 'segment(1, solid, box(size(1e60, 1e60, 1e60))).' >"$work/in/wide.pl"
run eval "$work/in/wide.pl" -o "$work/to/a.stl"
check 'too large for STL: exit code' status_is 4
check 'too large for STL: message' has 'too large for STL'
check 'too large for STL: nothing written' holds "$work/to"

# A binary STL that promises more triangles than it has.
{ printf '%80s' binary; printf '\x10\x00\x00\x00'; head -c 50 /dev/zero; } \
  >"$work/in/short.stl"
run convert "$work/in/short.stl" -o "$work/to/a.off"
check 'binary STL cut off' status_is 3
check 'binary STL: nothing written' holds "$work/to"

run draw "$work/in/no_such.pl" -o "$work/to/a.svg"
check 'missing file' status_is 3
check 'missing file: message' has 'no_such.pl: there is no such file'
run draw "$work/in/no_such.stl" -o "$work/to/a.svg"
check 'missing mesh' status_is 3
check 'missing mesh: message' has 'no_such.stl'
run draw "$work/in" -o "$work/to/a.svg"
check 'a folder' status_is 3
mkdir "$work/in/dir.pl"
run draw "$work/in/dir.pl" -o "$work/to/a.svg"
check 'a folder with an ending' has 'is a folder'
: >"$work/in/a.xyz"
run draw "$work/in/a.xyz" -o "$work/to/a.svg"
check 'unknown format' status_is 3
check 'unknown format: message' has 'format .xyz'
# The second file is bad: nothing of the first is used.
run convert facts/cube.pl "$work/in/missing.pl" -o "$work/to/a.pl"
check 'second of two' status_is 3
check 'nothing written' holds "$work/to"
check 'its own segment numbers' has 'segment 1 has no vertex 9'
# Errors come in the order of the files, whatever the language.
LANG=ko_KR.UTF-8 run draw "$work/in/missing.pl" -o "$work/to/a.svg"
check 'korean' has '꼭짓점 9가 없습니다'

if [ -d "$data/bad" ]; then
  for file in "$data"/bad/*; do
    run check "$file"
    check "$file" status_is 3
    check "$file: message" has "$file:"
    check "$file: stdout" silent out
  done
else
  skip 'no ../shared/data/bad'
fi
finish
