# fittings.sh -- the files of docs/fittings.md: each by its command, with sizes of
# an order, and what ezdxf reads in its DXF: every outline is closed.
. "$(dirname "$0")/../check.sh"

sanggwan() { "$SANGGWAN" "$@"; }
fittings=$(dirname "$0")/../../facts/fittings

cat >"$TMP/closed.py" <<'PYTHON'
import sys
import ezdxf
drawing = ezdxf.readfile(sys.argv[1])
width = float(sys.argv[2])
cuts = [e for e in drawing.modelspace() if e.dxf.layer == 'CUT']
assert cuts and all(e.dxftype() == 'POLYLINE' and e.is_closed for e in cuts)
points = [[v.dxf.location for v in e.vertices] for e in cuts]
assert any(abs((a - b).magnitude - width) < 0.002
           for loop in points for a in loop for b in loop), width
PYTHON

# A fitting, how far two corners of its outlines are apart, and settings.
fitting() {
  name=$1 width=$2
  shift 2
  check "$name" status 0 sanggwan unfold -q "$fittings/$name.pl" "$@" \
    -o "$TMP/$name.dxf" -o "$TMP/$name.svg"
  if /usr/bin/python3 -c 'import ezdxf' 2>/dev/null; then
    check "$name: ezdxf reads closed outlines" \
      /usr/bin/python3 "$TMP/closed.py" "$TMP/$name.dxf" "$width"
  fi
}

# pi * (168.3 - 5) and such widths, the seam of a cone, a side of a duct, the
# middle of a side of a hopper.
fitting elbow 513.0221 --set d=168.3 --set r=252 --set t=5
fitting tee 509.8805 --set b=60.3 --set angle=45
fitting wye 346.5177 --set angle=90
fitting offset 346.5177 --set x=200 --set h=300
fitting reducer 142.5798 --set seam=90
fitting square_to_round 298 --set d=180
fitting hopper 436.6062 --set t=3
fitting cyclone 464.9557

check "a size that cannot be" complains 3 \
  'piece 1 has an axis of .*; its mitres need more than' \
  sanggwan unfold -q "$fittings/elbow.pl" --set r=50
check "a plate that leaves no room" complains 4 \
  'a plate 60 thick .* it must be less than 57.15 thick' \
  sanggwan unfold -q "$fittings/elbow.pl" --set t=60
check "a branch within its header" complains 0 'nothing is left of segment 2' \
  sanggwan unfold "$fittings/tee.pl" --set height=50
check "a name that no parameter has" status 2 \
  sanggwan unfold -q "$fittings/elbow.pl" --set radius=50
check "an option counts before the file" output 'sheet  *359.084 x' \
  sanggwan unfold -q "$fittings/elbow.pl" --size middle

check_report
