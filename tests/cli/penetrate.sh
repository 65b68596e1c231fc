# penetrate.sh -- `sanggwan penetrate`: every format as other programs read it.
# covers: verb_output
. "$(dirname "$0")/../check.sh"

cubes=facts/two_cubes.pl
wall=facts/figures/fig13.pl
penetrate() { "$SANGGWAN" penetrate -q "$@"; }
same() { cmp "$1" "$2"; }

for format in pl obj csv tsv txt svg dxf; do
  check "$format" penetrate $wall -o "$TMP/a.$format"
  check "$format again" penetrate $wall -o "$TMP/b.$format"
  check "$format: same bytes" same "$TMP/a.$format" "$TMP/b.$format"
  check "$format to standard output" \
    eval "penetrate $wall --format $format -o - >'$TMP/c.$format'"
  check "$format: and there" same "$TMP/a.$format" "$TMP/c.$format"
done
check "any locale" env LC_ALL=ko_KR.UTF-8 "$SANGGWAN" penetrate -q $wall \
  -o "$TMP/e.csv"
check "any locale: same bytes" same "$TMP/a.csv" "$TMP/e.csv"

# Each row has as many cells as the head, a length that never shrinks within
# its chain, and a point that is where the other columns say.
cat >"$TMP/table.py" <<'PYTHON'
import csv, sys
from fractions import Fraction
rows = list(csv.DictReader(open(sys.argv[1])))
exact = list(csv.DictReader(open(sys.argv[2])))
assert len(rows) == len(exact) == 7 and all(None not in row for row in rows)
for before, row in zip(rows, rows[1:]):
    assert float(row['length']) > float(before['length'])
for row, fraction in zip(rows, exact):
    for axis in 'xyz':
        assert float(Fraction(fraction[axis])) == float(row[axis])
assert [r['point'] for r in rows] == [str(i + 1) for i in range(7)]
assert rows[0]['v1'] == rows[-1]['v1'] and rows[0]['kind'] == 'closed'
assert {r['contact'] for r in rows} == {'edge-face'}
PYTHON
check "a table" penetrate $cubes -o "$TMP/t.csv"
check "an exact table" penetrate $cubes --exact -o "$TMP/x.csv"
check "both agree" python3 "$TMP/table.py" "$TMP/t.csv" "$TMP/x.csv"
check "in words" output 'edge 3-7 of segment 1 pierces polygon 1 of segment 2' \
  penetrate $cubes --format txt
check "in Korean" output '닫힘, 조각 6개' penetrate $cubes --format txt --lang ko
check "exact is for tables" complains 2 'exact is for tables' \
  penetrate $cubes --exact -o "$TMP/x.obj"

# A spike whose tip stands in a floor: one point, in every format.
cat >"$TMP/tip.pl" <<'MODEL'
segment(1, surface, floor).
v(1, 1, 0, 0, 0). v(1, 2, 4, 0, 0). v(1, 3, 4, 4, 0). v(1, 4, 0, 4, 0).
p(1, 1, [1, 2, 3, 4]).
segment(2, solid, at([rotate(x, 180), translate(1, 1, 2)],
                     pyramid(base(1, 1), height(2)))).
MODEL
tip() { penetrate "$TMP/tip.pl" --format "$1"; }
check "a point: pl" output '^curve\(1, \[1\]\)' tip pl
check "a point: obj" output '^p 1$' tip obj
check "a point: csv" output '^1,point,1,2,1,.*,vertex-face,face 1,vertex 5$' \
  tip csv
check "a point: txt" output 'vertex 5 of segment 2 lies inside polygon 1' tip txt
check "a point: svg" output 'id="chain-1"' tip svg
check "a point: dxf" output '^PENETRATION_POINT' tip dxf
check "a point is explained" output 'touches polygon 2 of segment 2' \
  "$SANGGWAN" explain -q "$TMP/tip.pl" 'line(1)'

if /usr/bin/python3 -c 'import ezdxf' 2>/dev/null; then
  cat >"$TMP/dxf.py" <<'PYTHON'
import ezdxf, sys
drawing = ezdxf.readfile(sys.argv[1])
audit = drawing.audit()
lines = list(drawing.modelspace())
assert not audit.errors and not audit.fixes, audit.errors + audit.fixes
assert len(lines) == 1 and lines[0].dxftype() == 'POLYLINE'
line = lines[0]
assert line.is_3d_polyline and line.is_closed and len(line.vertices) == 6
assert line.dxf.layer == 'PENETRATION_CLOSED'
assert [tag.value for tag in line.get_xdata('SANGGWAN')] == [1, 1, 2]
points = sorted(tuple(v.dxf.location) for v in line.vertices)
assert points[-1] == (1.0, 1.0, 0.6), points
assert drawing.header['$EXTMAX'] == (1.0, 1.0, 2.0)
PYTHON
  cat >"$TMP/point.py" <<'PYTHON'
import ezdxf, sys
drawing = ezdxf.readfile(sys.argv[1])
point, = drawing.modelspace()
assert not drawing.audit().errors
assert point.dxftype() == 'POINT' and tuple(point.dxf.location) == (1, 1, 0)
PYTHON
  check "dxf of a tip" penetrate "$TMP/tip.pl" -o "$TMP/tip.dxf"
  check "ezdxf reads the point" /usr/bin/python3 "$TMP/point.py" "$TMP/tip.dxf"
  check "dxf of cubes" penetrate $cubes -o "$TMP/cubes.dxf"
  check "ezdxf reads it" /usr/bin/python3 "$TMP/dxf.py" "$TMP/cubes.dxf"
else
  skip "ezdxf" "python3-ezdxf is not installed"
fi

check_report
