# cells_files.sh -- regions in files of other programs: meshed by TetGen and
# Gmsh, and read again, each region has its volume.
# covers: cells_file, cells_face, cells_city
. "$(dirname "$0")/../check.sh"

here=$(cd "$(dirname "$0")" && pwd)
has() { command -v "$1" >/dev/null; }

if ! has python3; then
  skip "cells in files" "python3 is wanted"
  check_report
  exit
fi

cells() { "$SANGGWAN" cells -q "$@"; }
volumes() { python3 "$here/cells_files.py" "$@"; }

report() { # MODEL REPORT
  cells "$1" --json -o "$2.poly" -o "$2.geo" -o "$2.off" -o "$2.obj" \
    -o "$2.stl" >"$2.json"
}

again() { # FILE.off REPORT
  cells "$1" --json >"$2.again" && volumes "$2.json" report "$2.again"
}

tetgen_meshes() { # NAME
  (cd "$TMP" && tetgen -pAQ "$1.poly" >"$1.log" 2>&1 &&
    volumes "$1.json" tetgen "$1.1.node" "$1.1.ele")
}

gmsh_meshes() { # NAME
  (cd "$TMP" && gmsh -3 -format msh2 -o "$1.msh" "$1.geo" >"$1.log" 2>&1 &&
    volumes "$1.json" gmsh "$1.msh")
}

# A closed room, whose inside is no cell; a wall of six boxes round it.
cat >"$TMP/room.pl" <<'EOF'
segment(1, solid, at([translate(0,0,-1)], box(size(5,5,1)))).
segment(2, solid, at([translate(0,0,3)], box(size(5,5,1)))).
segment(3, solid, at([translate(-2,0,0)], box(size(1,5,3)))).
segment(4, solid, at([translate(2,0,0)], box(size(1,5,3)))).
segment(5, solid, at([translate(0,-2,0)], box(size(3,1,3)))).
segment(6, solid, at([translate(0,2,0)], box(size(3,1,3)))).
segment(7, cells, glue([1,2,3,4,5,6])).
EOF

# A box with a box, a sheet and a wire in it, one on it; a hole and its plug.
cat >"$TMP/inner.pl" <<'EOF'
segment(1, solid, box(size(4,4,4))).
segment(2, solid, at([translate(0,0,1)], box(size(1,1,1)))).
segment(3, solid, at([translate(0,0,4)], box(size(1,1,1)))).
segment(4, curve, line(from(-1.5,0.2,0.7), to(-1.5,0.3,3.1))).
segment(5, solid, difference([at([translate(9,0,0)], box(size(3,3,1))),
                              at([translate(9,0,-1)], box(size(1,1,3)))])).
segment(6, solid, at([translate(9,0,0)], box(size(1,1,1)))).
segment(7, surface, at([translate(1.2,1.2,2)], rectangle(size(1,1)))).
segment(8, cells, glue([1,2,3,4,5,6,7])).
EOF

# A box on another one, a corner of it on an edge: a hole touches its border.
cat >"$TMP/touching.pl" <<'EOF'
segment(1, solid, box(size(4,4,1))).
segment(2, solid, at([translate(0,0,1)],
                     prism(outline([[2,0],[1,1],[0,0],[1,-1]]), height(1)))).
segment(3, cells, glue([1,2])).
EOF

for name in materials vertex crossing face mixed; do
  cp "facts/figures/glue_$name.pl" "$TMP/$name.pl"
done

# A box whose top is not flat, as measured ones are: its triangles are written.
cat >"$TMP/bent.pl" <<'EOF'
segment(1, solid, bent).
v(1, 1, 0, 0, 0). v(1, 2, 2, 0, 0). v(1, 3, 2, 2, 0). v(1, 4, 0, 2, 0).
v(1, 5, 0, 0, 1). v(1, 6, 2, 0, 1). v(1, 7, 2, 2, 1.2). v(1, 8, 0, 2, 1).
e(1, 1, 1, 4, 1). e(1, 2, 4, 3, 1). e(1, 3, 3, 2, 1). e(1, 4, 2, 1, 1).
e(1, 5, 5, 6, 1). e(1, 6, 6, 7, 1). e(1, 7, 7, 8, 1). e(1, 8, 8, 5, 1).
e(1, 9, 1, 2, 1). e(1, 10, 2, 6, 1). e(1, 11, 6, 5, 1). e(1, 12, 5, 1, 1).
e(1, 13, 2, 3, 1). e(1, 14, 3, 7, 1). e(1, 15, 7, 6, 1). e(1, 16, 6, 2, 1).
e(1, 17, 3, 4, 1). e(1, 18, 4, 8, 1). e(1, 19, 8, 7, 1). e(1, 20, 7, 3, 1).
e(1, 21, 4, 1, 1). e(1, 22, 1, 5, 1). e(1, 23, 5, 8, 1). e(1, 24, 8, 4, 1).
p(1, 1, [1, 2, 3, 4]). p(1, 2, [5, 6, 7, 8]). p(1, 3, [9, 10, 11, 12]).
p(1, 4, [13, 14, 15, 16]). p(1, 5, [17, 18, 19, 20]).
p(1, 6, [21, 22, 23, 24]).
EOF

for name in materials vertex crossing face mixed room inner touching bent; do
  check "$name: written" report "$TMP/$name.pl" "$TMP/$name"
  check "$name: OFF read again" again "$TMP/$name.off" "$TMP/$name"
  if has tetgen; then
    check "$name: TetGen" tetgen_meshes "$name"
  else
    skip "$name: TetGen" "tetgen is not installed"
  fi
  if has gmsh; then
    check "$name: Gmsh" gmsh_meshes "$name"
  else
    skip "$name: Gmsh" "gmsh is not installed"
  fi
done

# CityJSON is right by another program, which sees each fault planted here.
city() { python3 "$here/city_checker.py" "$@"; }
for name in materials vertex crossing face mixed room inner touching bent; do
  check "$name: CityJSON written" \
    cells "$TMP/$name.pl" -o "$TMP/$name.city.json"
  check "$name: CityJSON is right" city "$TMP/$name.city.json" \
    "$TMP/$name.json"
done
planted() { # PYTHON: what it does to `city`, or to `solid`, its first member
  python3 -c '
import json, sys
city = json.load(open(sys.argv[1]))
solid = city["CityObjects"]["segment_7_part_1"]["geometry"][0]["boundaries"][0]
exec(sys.argv[2])
json.dump(city, open(sys.argv[3], "w"))' "$TMP/room.city.json" "$1" \
    "$TMP/planted.city.json" &&
    ! city "$TMP/planted.city.json" "$TMP/room.json" >/dev/null
}
while read -r fault; do
  check "planted: $fault" planted "$fault"
done <<'EOF'
solid[0][0][0][0] = 99
solid[0][0][0].reverse()
solid[0][0][0][1] = solid[0][0][0][0]
solid[0].pop()
solid.append([])
for rings in solid[0]: rings[0].reverse()
del city["CityObjects"]["segment_7_part_1"]["geometry"][0]["boundaries"][1]
city["vertices"][0] = city["vertices"][1]
city["vertices"].append([7, 7, 7])
city["vertices"][0][2] += 1
city["vertices"][0][0] = 0.5
city["transform"]["scale"][1] = 2.0
city["version"] = "3.0"
city["CityObjects"]["segment_7_part_1"]["type"] = "House"
del city["CityObjects"]["segment_7_part_1"]["geometry"][0]["lod"]
EOF

# CityJSON: the parts are glued again.
city_again() { # NAME
  cells "$TMP/$1.pl" -o "$TMP/$1.city.json" >"$TMP/$1.report" &&
    "$SANGGWAN" glue -q --json "$TMP/$1.city.json" >"$TMP/$1.again" &&
    volumes "$TMP/$1.json" report "$TMP/$1.again"
}
for name in materials vertex crossing face mixed room inner touching bent; do
  check "$name: CityJSON glued again" city_again "$name"
done

# Cells as STL: solids of their own, as many as there are cells; the hole
# in OBJ has the outside on both ends.
parts() { # NAME COUNT
  "$SANGGWAN" check -q --json "$TMP/$1.stl" | python3 -c '
import json, sys
kinds = [s["kind"] for s in json.load(sys.stdin)["segments"]]
sys.exit(kinds.count("solid") != int(sys.argv[1]))' "$2"
}
check "STL: five cells" parts crossing 5
check "STL: four cells" parts materials 4
check "OBJ: groups by sides" grep -qx "g sides_1_2" "$TMP/face.obj"
check "OBJ: wires" grep -qx "g wires" "$TMP/materials.obj"

check_report
