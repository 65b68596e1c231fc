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
    patterns, vertices, edges, loops, joints = [], {}, {}, {}, {}
    with open(name, encoding="utf-8") as file:
        rows = [row.groups() for row in map(ROW.match, map(str.strip, file))
                if row]
    for kind, of, rest in rows:
        cells = rest.split(", ")
        if kind == "segment" and cells[0] == "pattern":
            patterns.append(of)
        elif kind == "v":
            place = [float(x) for x in cells[1:3]]
            vertices.setdefault(of, {})[cells[0]] = place
        elif kind == "e":
            edges.setdefault(of, {})[cells[0]] = cells[1:3]
        elif kind == "p":
            loops.setdefault(of, []).append(re.split(
                ", -", rest[rest.index("[")+1:-1]))  # a hole begins with -V
        elif kind == "joint":
            joints.setdefault(of, []).append(cells[1:])
    for of in patterns:
        at, sides = vertices[of], edges.get(of)
        if not sides:  # they are those of the polygons, in order
            rings = [ring.split(", ") for loop in loops[of] for ring in loop]
            sides = [side for ring in rings
                     for side in zip(ring, ring[1:] + ring[:1])]
            sides = {str(i): side for i, side in enumerate(sides, 1)}
        length = {e: math.dist(at[a], at[b]) for e, (a, b) in sides.items()}
        print("  pattern %s: %d faces; %d vertices, x %#.10g, y %#.10g, "
              "xy %#.10g; %d edges, %#.10g long" %
              (of, len(loops[of]), len(at),
               sum(abs(x) for x, _ in at.values()),
               sum(abs(y) for _, y in at.values()),
               sum(abs(x*y) for x, y in at.values()),
               len(length), sum(length.values())))
        kinds = {}
        for e, _, kind, angle in joints.get(of, []):
            added(kinds, kind, [1, length[e], abs(float(angle))])
        for kind in sorted(kinds):
            print("    %s: %d, %#.10g long, %#.10g degrees" %
                  (kind, *kinds[kind]))


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
