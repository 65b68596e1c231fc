#!/usr/bin/env python3
"""measured.py -- what `sanggwan unfold` lays out, in a few figures.

    tests/measured.py [-r] ARGUMENT...

Of each sheet: of each kind of line how many there are, how long they are in
all, and the sums of their places and edges, in thousandths of a millimetre.
With -r of each flat pattern instead: its vertices and edges, and the sums of
their places and lengths; of each kind of joint the lengths and angles. So a
transcript holds many layouts, and notices what is laid elsewhere.
"""
import json
import math
import os
import re
import subprocess
import sys
import tempfile

ROW = re.compile(r"^(segment|v|e|p|joint)\((\d+), *(.*)\)\.$")


def added(sums, key, numbers):
    old = sums.setdefault(key, [0] * len(numbers))
    sums[key] = [a + b for a, b in zip(old, numbers)]


def sheet_measured(name):
    with open(name, encoding="utf-8") as file:
        sheet = json.load(file)
    print("  %s: %g x %g, 1:%#.10g" % (os.path.basename(name), sheet["width"],
                                     sheet["height"], 1/sheet["scale"]))
    kinds = {}
    for line in sheet["lines"]:
        points = [[round(1000*c) for c in p] for p in line["points"]]
        added(kinds, line["role"],
              [1, sum(map(math.dist, points, points[1:])),
               sum(p[0] for p in points), sum(p[1] for p in points),
               sum(line["edges"])])
    for role in sorted(kinds):
        print("    %s: %d, %d long, x %d, y %d, edges %d" %
              (role, *map(round, kinds[role])))


def rows_measured(name):
    vertices, edges, joints, faces, patterns = {}, {}, {}, {}, []
    with open(name, encoding="utf-8") as file:
        for line in file:
            row = ROW.match(line.strip())
            if not row:
                continue
            kind, of, rest = row.groups()
            cells = rest.split(", ") if ", " in rest else rest.split(",")
            if kind == "segment" and cells[0] == "pattern":
                patterns.append(of)
            elif kind == "v":
                vertices[of, cells[0]] = tuple(map(float, cells[1:3]))
            elif kind == "e":
                edges[of, cells[0]] = cells[1:3]
            elif kind == "p":
                faces[of] = faces.get(of, 0) + 1
            elif kind == "joint":
                joints[of, cells[0]] = cells[1:]
    for of in patterns:
        own = [p for (d, _), p in vertices.items() if d == of]
        length = {e: math.dist(vertices[of, a], vertices[of, b])
                  for (d, e), (a, b) in edges.items() if d == of}
        print("  pattern %s: %d faces; %d vertices, x %#.10g, y %#.10g, xy %#.10g; "
              "%d edges, %#.10g long" %
              (of, faces.get(of, 0), len(own), sum(abs(x) for x, _ in own),
               sum(abs(y) for _, y in own), sum(abs(x*y) for x, y in own),
               len(length), sum(length.values())))
        kinds = {}
        for (d, _), (e, _, kind, angle) in joints.items():
            if d == of:
                added(kinds, kind, [1, length[e], abs(float(angle))])
        for kind in sorted(kinds):
            print("    %s: %d, %#.10g long, %#.10g degrees" % (kind, *kinds[kind]))


def main():
    words = sys.argv[1:]
    rows = words[0] == "-r"
    words = words[rows:]
    print(" ".join(words))
    sys.stdout.flush()
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "pl" if rows else "json")
        done = subprocess.run(["sanggwan", "unfold", "-q", *words, "-o",
                               out + "." + os.path.basename(out)],
                              stdout=subprocess.DEVNULL)
        for name in sorted(os.listdir(folder)):
            (rows_measured if rows else sheet_measured)(
                os.path.join(folder, name))
    return done.returncode


sys.exit(main())
