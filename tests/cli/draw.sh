# draw.sh -- `sanggwan draw`: every format as other programs read it.
# covers: picture_options
. "$(dirname "$0")/../check.sh"

figure=facts/figures/fig13.pl
draw() { "$SANGGWAN" draw -q "$@"; }

# same A B: the same bytes.
same() { cmp "$1" "$2"; }

# leaves FILE...: the folder has these files only, nothing half-written.
leaves() {
  local folder=$1
  shift
  [ "$(ls -A "$folder")" = "$(printf '%s\n' "$@")" ] || {
    ls -A "$folder"
    return 1
  }
}

# ink FILE: a PNG that is neither blank nor black.
ink() {
  rsvg-convert -w 400 "$1" -o "$TMP/ink.png" &&
    [ "$(wc -c <"$TMP/ink.png")" -gt 3000 ]
}

for format in svg pdf eps ps png json dxf hpgl pl; do
  check "$format" draw $figure -o "$TMP/a.$format"
  check "$format again" draw $figure -o "$TMP/b.$format"
  check "$format: same bytes" same "$TMP/a.$format" "$TMP/b.$format"
  check "$format to standard output" \
    eval "draw $figure --format $format -o - >'$TMP/c.$format'"
  check "$format: and there" same "$TMP/a.$format" "$TMP/c.$format"
done
check "several at once" draw $figure -o "$TMP/d.svg" -o "$TMP/d.json"
check "any locale" env LC_ALL=ko_KR.UTF-8 "$SANGGWAN" draw -q $figure \
  -o "$TMP/e.svg"
check "any locale: same bytes" same "$TMP/a.svg" "$TMP/e.svg"

# With y up, a turned model looks as the one it was turned from.
mkdir "$TMP/z_up" "$TMP/y_up"
check "as OBJ" "$SANGGWAN" convert -q facts/hollow_block.pl \
  -o "$TMP/z_up/m.obj"
awk '$1 == "v" { print "v", $2, $4, 0 - $3; next } { print }' \
  "$TMP/z_up/m.obj" >"$TMP/y_up/m.obj"
for look in '' '--view top' '--sheet A4' '--views front,right --section x'; do
  check "z up: $look" draw "$TMP/z_up/m.obj" $look -o "$TMP/z_up/m.svg"
  check "y up: $look" draw "$TMP/y_up/m.obj" --up y $look -o "$TMP/y_up/m.svg"
  check "the same: $look" same "$TMP/z_up/m.svg" "$TMP/y_up/m.svg"
done
check "y up, said by nobody" eval \
  '! { draw "$TMP/y_up/m.obj" -o "$TMP/y_up/m.svg" &&
       draw "$TMP/z_up/m.obj" -o "$TMP/z_up/m.svg" &&
       cmp -s "$TMP/z_up/m.svg" "$TMP/y_up/m.svg"; }'

check "svg is XML" python3 -c \
  "import sys, xml.dom.minidom as x; x.parse('$TMP/a.svg')"
check "json is JSON" python3 -m json.tool "$TMP/a.json"
if command -v rsvg-convert >/dev/null; then
  check "rsvg-convert draws it" ink "$TMP/a.svg"
else
  skip "rsvg-convert" "not installed"
fi
if /usr/bin/python3 -c 'import ezdxf' 2>/dev/null; then
  cat >"$TMP/dxf.py" <<'PYTHON'
import ezdxf, ezdxf.units, sys
drawing = ezdxf.readfile(sys.argv[1])
audit = drawing.audit()
lines = list(drawing.modelspace())
assert not audit.errors and not audit.fixes, audit.errors + audit.fixes
assert {line.dxftype() for line in lines} == {'POLYLINE', 'LINE'}
layers = {line.dxf.layer for line in lines}
assert 'VISIBLE_OUTLINE' in layers and 'HIDDEN_OUTLINE' in layers, layers
assert drawing.layers.get('HIDDEN_OUTLINE').dxf.linetype == 'HIDDEN'
first = lines[0] if lines[0].dxftype() == 'LINE' else lines[0].vertices[0]
assert first.get_xdata('SANGGWAN')[0] == (1071, 1)
assert drawing.units == ezdxf.units.MM
PYTHON
  check "ezdxf reads it" /usr/bin/python3 "$TMP/dxf.py" "$TMP/a.dxf"
else
  skip "ezdxf" "python3-ezdxf is not installed"
fi
if command -v hp2xx >/dev/null; then
  check "hp2xx plots it" \
    eval "hp2xx -q -m eps -f '$TMP/a.eps' '$TMP/a.hpgl' && [ -s '$TMP/a.eps' ]"
else
  skip "hp2xx" "not installed"
fi

# What is said of a style file is said before any work.
printf 'line(visible, crease, any, [width(0)]).\n' >"$TMP/style.pl"
check "style with a fault" complains 3 "style.pl:1:28: width\(0\) is no" \
  draw $figure --style "$TMP/style.pl" -o "$TMP/never.svg"
check "no style file" complains 3 "no such file" \
  draw $figure --style "$TMP/none.pl" -o "$TMP/never.svg"
check "nothing drawn then" test ! -e "$TMP/never.svg"
check "style" output 'stroke:#f0f5ff' \
  draw $figure --style facts/styles/blueprint.pl -o -
check "hpgl: dashes are lines" eval \
  "! draw $figure -o - --format hpgl | grep -q LT"
check "hpgl: line types" output '^LT3,[0-9.]+;$' \
  draw $figure --dashes type --format hpgl -o -
check "hpgl: one pen" eval "[ \$(draw $figure --format hpgl -o - \
  --style facts/styles/single_pen.pl | grep -c 'SP[1-9]') = 1 ]"
check "wrong dashes" complains 2 dashes draw $figure --dashes dotted -o -
cp $figure "$TMP/model.pl"
check "a picture does not replace its model" complains 2 "is the model" \
  draw "$TMP/model.pl" -o "$TMP/model.pl"
check "the model is there" same $figure "$TMP/model.pl"
check "size" output 'width="100mm" height="70mm" viewBox="0 0 100 70"' \
  draw $figure --size 100x70 -o -
check "size in dots" \
  eval "draw $figure --png dots --size 123x45 -o '$TMP/s.png' &&
        python3 -c \"
import struct
print(struct.unpack('>II', open('$TMP/s.png', 'rb').read(24)[16:]) == (123, 45)
      or 1 / 0)\""
check "size in dots to the inch" \
  eval "draw $figure --size 127x63.5 --dpi 20 -o '$TMP/s.png' &&
        python3 -c \"
import struct
print(struct.unpack('>II', open('$TMP/s.png', 'rb').read(24)[16:]) == (100, 50)
      or 1 / 0)\""
check "a size that is none" complains 2 'size' draw $figure --size 12 -o -
check "too many dots" complains 2 '16384' \
  draw $figure --size 99999x99999 -o "$TMP/big.png"
check "no such folder" complains 2 'no/such' draw $figure -o /no/such/a.svg
check "unknown ending" complains 2 'svg' draw $figure -o "$TMP/a.gif"
check "no file left" test ! -e "$TMP/big.png"

mkdir "$TMP/disk"
if mount -t tmpfs -o size=4k tiny "$TMP/disk" 2>/dev/null; then
  check "full disk" complains 2 'the disk is full' \
    draw facts/figures/fig13.pl -o "$TMP/disk/a.svg"
  check "full disk: nothing left" leaves "$TMP/disk"
  umount "$TMP/disk"
else
  skip "full disk" "cannot mount one here"
fi

# says_so ARGUMENT...: that nothing can be seen.
says_so() {
  "$SANGGWAN" draw "$@" -o "$TMP/nothing.svg" 2>&1 |
    grep -q '^sanggwan: there is nothing to draw$'
}
echo 'segment(1, curve, line(from(0, 0, 0), to(0, 0, 5))).' >"$TMP/line.pl"
check "a line seen end-on: a notice" says_so "$TMP/line.pl" --view top
check "seen from elsewhere: none" eval "! says_so '$TMP/line.pl'"

echo 'line(any, any, pipe, [none]). line(any, any, 1, [pen(2)]).' \
  >"$TMP/style.pl"
check "a style for no segment: a notice" eval \
  '"$SANGGWAN" draw facts/cube.pl --style "$TMP/style.pl" -o "$TMP/a.svg" 2>&1 |
     grep -c "lines of segment" | grep -qx 1'

# Centre lines in a picture without a sheet: none unless asked for. The axis of
# the one pipe lies in the picture, the other's is upright, and eight holes of
# each flange are seen from the side.
"$SANGGWAN" draw facts/pipe_tee.pl --view front -o "$TMP/plain.svg" 2>/dev/null
"$SANGGWAN" draw facts/pipe_tee.pl --view front --centre-lines \
  -o "$TMP/axes.svg" -o "$TMP/axes.dxf" 2>/dev/null
check "no centre lines" eval "! grep -q 'centre_line' '$TMP/plain.svg'"
check "centre lines" eval \
  "grep -c 'class=\"visible centre_line' '$TMP/axes.svg' | grep -qx 14"
check "centre lines in DXF" eval \
  "grep -A1 '^ *6$' '$TMP/axes.dxf' | grep -q '^CENTER_'"
check "centre lines, turned up" eval \
  '"$SANGGWAN" draw facts/bracket.pl --up y --centre-lines -o "$TMP/b.svg" &&
     grep -q "class=\"visible centre_line" "$TMP/b.svg"'
check "centre lines, central" complains 2 'do not go together' \
  draw facts/bracket.pl --centre-lines --projection central -o "$TMP/a.svg"

check_report
