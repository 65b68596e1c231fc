# explain.sh -- `sanggwan explain`: what it prints, and its exit codes.
. "$(dirname "$0")/../check.sh"

cubes=facts/two_cubes.pl
explain() { "$SANGGWAN" explain -q "$@"; }

check "a line" output 'line 1: polygon 4 of segment 1 .box. meets polygon 1' \
  explain $cubes 'line(1)'
check "which edge pierces which face" output \
  'edge 1-2 of segment 2 pierces polygon 4 of segment 1' \
  explain $cubes 'line(1)'
check "from which pieces" output 'merged from 2 cuts of triangles' \
  explain $cubes 'line(1)'
check "every line" output 'line 6: ' explain $cubes 'line(L)'
check "a vertex" output 'made by 1-2 of segment 2 through triangle' \
  explain $cubes 'vertex(1, 9)'
check "a divided edge" output 'it was divided' explain $cubes 'edge(1, 15)'
check "a pair without a line" output 'no line: their boxes are apart' \
  explain $cubes 'pair(1-1, 2-2)'
check "a line of the picture" output \
  'polygon 2 of segment 2 .box. hides it from 0 to 0.472377' \
  explain $cubes 'hidden(s1e28)'
check "from another side" output \
  'to 0.545455, where it crosses edge 8 of segment 2' \
  explain $cubes 'hidden(1, 28)' --view iso
check "alone it is visible" output 'no other face that could hide it' \
  explain $cubes 'why_not(hidden(1, 7))' --segment 1
flat=$TMP/flat.pl
"$SANGGWAN" unfold -q facts/cube.pl --cut 1-3 -o "$flat" >/dev/null
check "a seam of a pattern in a file" output \
  'edge 3 of segment 1 .cube. is a seam' explain "$flat" 'seam(3)'
check "of a trimmed part" output 'of segment 3 is a seam' \
  explain facts/patterns/saddle.pl --trim outside 'seam(2, _)'
check "of a round one" output '1/side is unrolled as the round surface' \
  explain facts/patterns/saddle.pl --trim outside --true 'seam(_)'
check "a seam" output 'edge 2 of segment 1 .cube. is a seam 1 long' \
  explain facts/cube.pl 'seam(2)'
check "what it would cost" output 'cut at edge 1 instead, the seam' \
  explain facts/cube.pl 'seam(2)'
check "an edge cut by an option" output 'it was to be cut' \
  explain $cubes 'seam(2, 1)' --cut 1
check "of one segment only" complains 2 'Say which one with --only' \
  explain $cubes 'seam(1)' --cut 1
check "a fold, in Korean" output '접는 선이다' \
  explain facts/cube.pl 'fold(1)' --lang ko
check "a piece of a pattern" output 'is one piece, of 6 polygons' \
  explain facts/cube.pl 'pattern(1, 1)'
check "no such line" complains 1 'data-edge' \
  "$SANGGWAN" explain $cubes 'hidden(1, 99)'
check "Korean" output '선 1: ' explain $cubes 'line(1)' --lang ko
check "JSON" eval \
  "explain $cubes 'line(1)' --json | python3 -m json.tool >/dev/null"
check "nothing to explain" complains 1 'Ask for line' \
  "$SANGGWAN" explain $cubes 'line(99)'
check "no item" complains 2 'ITEM is missing' explain $cubes
check "no model" complains 2 'MODEL is missing' explain 'line(1)'
check "no term" complains 2 'no goal' explain $cubes 'line('
check "in the repl" output 'line 1: ' \
  eval "echo 'penetrate, explain(line(1)).' | '$SANGGWAN' repl -q $cubes"

check_report
