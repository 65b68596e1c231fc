"""fold_check.py -- a FOLD file, looked at by somebody else's JSON reader.

    python3 fold_check.py FILE.fold FACES EULER

Its numbers fit each other; each edge has the same length flat and folded, each
face too; folds are as sharp as their angles say, and valleys are where the
normals of the folded faces point into each other; the Euler number is
EULER, 1 for each piece less 1 for each hole.
"""
import json
import math
import sys

with open(sys.argv[1]) as file:
    fold = json.load(file)
faces, euler = int(sys.argv[2]), int(sys.argv[3])
flat = [(x, y, 0.0) for x, y in fold["vertices_coords"]]
edges = fold["edges_vertices"]
assert fold["file_spec"] >= 1.1 and fold["file_creator"] == "Sanggwan"
assert fold["frame_classes"] == ["creasePattern"]
assert len(fold["faces_vertices"]) == faces, len(fold["faces_vertices"])
for name in ("edges_assignment", "edges_foldAngle", "sanggwan:edges_edge"):
    assert len(fold[name]) == len(edges), name
assert len({tuple(sorted(edge)) for edge in edges}) == len(edges)
known = {tuple(sorted(edge)): i for i, edge in enumerate(edges)}
sides = {}
for f, face in enumerate(fold["faces_vertices"]):
    area = sum(flat[a][0] * flat[b][1] - flat[b][0] * flat[a][1]
               for a, b in zip(face, face[1:] + face[:1]))
    assert area > 0, face
    for a, b in zip(face, face[1:] + face[:1]):
        sides.setdefault(known[tuple(sorted((a, b)))], []).append(f)
for i, assignment in enumerate(fold["edges_assignment"]):
    assert assignment in "BMVFJ"
    assert len(sides[i]) == (1 if assignment == "B" else 2), i
assert len(flat) - len(edges) + faces == euler
attributes = fold["frame_attributes"]
assert ("joins" in attributes) == ("J" in fold["edges_assignment"])

frame, = fold["file_frames"]
assert frame["frame_classes"] == ["foldedForm"] and frame["frame_inherit"]
folded = frame["vertices_coords"]
size = max(max(map(abs, p)) for p in folded)


def normal(face):
    a, b, c = (folded[v] for v in face[:3])
    u = [b[k] - a[k] for k in range(3)]
    v = [c[k] - a[k] for k in range(3)]
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
         u[0] * v[1] - u[1] * v[0]]
    return [x / math.hypot(*n) for x in n]


for i, (a, b) in enumerate(edges):
    there, here = math.dist(flat[a], flat[b]), math.dist(folded[a], folded[b])
    assert abs(there - here) < 1e-9 * size, (a, b, there, here)
    angle = fold["edges_foldAngle"][i]
    if fold["edges_assignment"][i] in "MV":
        one, two = (normal(fold["faces_vertices"][f]) for f in sides[i])
        bend = math.degrees(math.acos(max(-1.0, min(1.0, sum(
            x * y for x, y in zip(one, two))))))
        assert abs(abs(angle) - bend) < 1e-4, (angle, bend)
        assert (angle > 0) == (fold["edges_assignment"][i] == "V")
        if 1 < bend < 179:
            other = fold["faces_vertices"][sides[i][1]]
            above = sum(one[k] * (folded[v][k] - folded[a][k])
                        for v in other for k in range(3))
            assert (above > 0) == (angle > 0), (i, above, angle)
    else:
        assert angle == 0
