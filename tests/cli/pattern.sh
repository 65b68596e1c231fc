# pattern.sh -- patterns on paper, opened by other programs.
# covers: fold_file
. "$(dirname "$0")/harness.bash"
cd "$here"

cat >"$work/model.pl" <<'END'
segment(1, solid, sphere(radius(50), facets(24), bands(12))).
segment(2, solid, box(size(60, 40, 30))).
segment(3, solid, cylinder(radius(20), height(60), facets(24), shift(30, 0))).
END
swipl -q -p foreign="$B" tests/cli/pattern_files.pl -- "$work" \
  >"$work/out" 2>"$work/err" </dev/null
status=$?
err=$(cat "$work/err")
check "written" status_is 0
for format in svg pdf eps ps png json dxf hpgl pl fold; do
  check "$format: something" [ -s "$work/box.$format" ]
done
check "what was written is said" has "$work/sphere-1.svg" "$work/out"
check "as many as are said" has "$work/sphere-2.svg" "$work/out"
check "that it was divided" has 'larger than the page'

for name in box sphere-1 pipe; do
  check "$name.svg opened" rsvg-convert "$work/$name.svg" -o "$work/x.png"
done
check "the true size" has 'width="210mm" height="297mm"' "$work/box.svg"
check "cut" has 'class="visible cut"' "$work/box.svg"
check "an edge and its joint" grep -q 'data-edge="[0-9 ]*" data-joint="[0-9 ]*"' \
  "$work/box.svg"
check "the check bar" has 'class="visible bar"' "$work/box.svg"
check "generators" has 'class="visible generator"' "$work/pipe.svg"
check "the table" has 'class="visible table"' "$work/pipe.svg"
check "facts" has 'fold_down' "$work/box.pl"
check "json" python3 -c 'import json, sys
roles = {line["role"] for line in json.load(open(sys.argv[1]))["lines"]}
assert {"cut", "fold_down", "number", "bar"} <= roles, roles' "$work/box.json"

pages() { pdfinfo "$work/$1" 2>"$work/null" | grep -q "^Pages: *$2\$"; }
if command -v pdfinfo >"$work/null"; then
  sheets=$(ls "$work" | grep -c '^sphere-.*svg$')
  check "one page" pages box.pdf 1
  check "a page for each sheet" pages sphere.pdf "$sheets"
  check "A4" eval "pdfinfo '$work/sphere.pdf' | grep -q '595.* x 841'"
  check "many tiles" eval "! pages tiled.pdf 1"
  for name in box sphere tiled all; do
    check "$name.pdf drawn" pdftoppm -r 20 "$work/$name.pdf" "$work/page"
  done
else
  skip "pdfinfo is not here"
fi

if command -v hp2xx >"$work/null"; then
  check "HPGL drawn" eval \
    "hp2xx -q -m eps -f '$work/x.eps' '$work/box.hpgl' >'$work/null' 2>&1"
else
  skip "hp2xx is not here"
fi
# Pens in the order of cutting: what is cut comes last.
check "the knife is last" eval \
  "grep -o 'SP[0-9]*' '$work/box.hpgl' | grep -v SP0 | tail -2 | grep -q SP1"

cat >"$work/dxf.py" <<'END'
import ezdxf, sys
drawing = ezdxf.readfile(sys.argv[1])
audit = drawing.audit()
assert not audit.errors and not audit.fixes, audit.errors + audit.fixes
lines = drawing.modelspace().query('POLYLINE LINE TEXT')
layers = {line.dxf.layer for line in lines}
assert {'CUT', 'FOLD_DOWN', 'NUMBER'} <= layers, layers
texts = drawing.modelspace().query('TEXT')
assert bool(texts) == (len(sys.argv) == 2)
assert 'CUT' not in {text.dxf.layer for text in texts}
cut = [line for line in lines if line.dxf.layer == 'CUT']
assert len(cut) == 1 and cut[0].is_closed
END
if /usr/bin/python3 -c 'import ezdxf' 2>"$work/null"; then
  check "ezdxf reads it" /usr/bin/python3 "$work/dxf.py" "$work/box.dxf"
  check "ezdxf: dashes as lines" /usr/bin/python3 "$work/dxf.py" \
    "$work/cutter.dxf" drawn
  cat >"$work/laser.pl" <<'END'
line(any, any, any, [none]).
line(any, cut, any, [shown, colour(red), layer('LASER')]).
END
  "$sanggwan" unfold -q facts/patterns/saddle.pl --trim outside --true \
    --generators 24 --style "$work/laser.pl" -o "$work/laser.dxf" >"$work/out"
  "$sanggwan" unfold -q facts/patterns/saddle.pl --trim outside --true \
    --generators 24 -o "$work/lengths.dxf" >"$work/out"
  "$sanggwan" unfold -q facts/patterns/saddle.pl --trim outside --true \
    --generators 24 --no-lengths -o "$work/bare.dxf" >"$work/out"
  cat >"$work/roles.py" <<'END'
import ezdxf, sys
laser, lengths, bare = (list(ezdxf.readfile(name).modelspace())
                        for name in sys.argv[1:])
assert {line.dxf.layer for line in laser} == {'LASER'}
table = [line for line in lengths if line.dxf.layer == 'TABLE']
texts = [text.dxf.text for text in table if text.dxftype() == 'TEXT']
assert len(texts) > 400 and '24' in texts
assert not [line for line in bare if line.dxf.layer == 'TABLE']
turned = [line for line in lengths if line.dxf.layer == 'GENERATOR_NUMBER'
          and line.dxftype() == 'TEXT' and line.dxf.rotation]
assert turned
END
  check "ezdxf: roles by a style, tables left out" /usr/bin/python3 \
    "$work/roles.py" "$work/laser.dxf" "$work/lengths.dxf" "$work/bare.dxf"
else
  skip "python3-ezdxf is not here"
fi

check "FOLD: a box" python3 tests/cli/fold_check.py "$work/box.fold" 6 1
# From inside: mirrored, valleys for mountains.
# The Euler number is that of the pieces less their holes: fig12 has two rings.
for model in patterns/house:1 patterns/fig12:0 cube:1 hollow_block:-1; do
  for side in outside inside; do
    option=$([ $side = inside ] && echo --inside)
    "$sanggwan" unfold -q $option --only 1 "facts/${model%:*}.pl" \
      -o "$work/x.fold" \
      >"$work/out" 2>"$work/err" </dev/null
    faces=$(python3 -c 'import json, sys
print(len(json.load(open(sys.argv[1]))["faces_vertices"]))' "$work/x.fold")
    check "FOLD: $model from $side" \
      python3 tests/cli/fold_check.py "$work/x.fold" "$faces" "${model#*:}"
  done
done
mountains() { grep -o '"M"' "$1" | wc -l; }
valleys() { grep -o '"V"' "$1" | wc -l; }
"$sanggwan" unfold -q facts/patterns/house.pl -o "$work/out.fold" >"$work/out"
"$sanggwan" unfold -q --inside facts/patterns/house.pl -o "$work/in.fold" \
  >"$work/out"
check "FOLD: mountains are valleys from inside" eval \
  '[ $(mountains "$work/out.fold") -gt 0 ] && \
   [ $(mountains "$work/out.fold") = $(valleys "$work/in.fold") ]'
check "FOLD: a sphere" python3 tests/cli/fold_check.py "$work/sphere.fold" 288 1
finish
