"""Volumes of regions, as a mesh has them, against the report of `cells --json`.

    cells_files.py REPORT.json tetgen MESH.node MESH.ele
    cells_files.py REPORT.json gmsh MESH.msh
    cells_files.py REPORT.json report OTHER.json

Exits 0 if each cell of the report has its volume, and nothing else has one.
"""
import collections
import json
import sys


def tetrahedron(a, b, c, d):
    u, v, w = ([p[i] - a[i] for i in range(3)] for p in (b, c, d))
    return abs(u[0] * (v[1] * w[2] - v[2] * w[1])
               - u[1] * (v[0] * w[2] - v[2] * w[0])
               + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


def rows(path):
    with open(path, encoding="utf-8") as lines:
        return [line.split() for line in lines
                if line.strip() and not line.startswith("#")]


def added(nodes, elements):
    volumes = collections.Counter()
    for region, corners in elements:
        volumes[region] += tetrahedron(*(nodes[corner] for corner in corners))
    return volumes


def of_tetgen(node, ele):
    nodes = {row[0]: [float(x) for x in row[1:4]] for row in rows(node)[1:]}
    return added(nodes, ((int(row[5]), row[1:5]) for row in rows(ele)[1:]))


def of_gmsh(msh):
    lines = rows(msh)
    at = next(i for i, row in enumerate(lines) if row == ["$Nodes"]) + 2
    many = int(lines[at - 1][0])
    nodes = {row[0]: [float(x) for x in row[1:4]]
             for row in lines[at:at + many]}
    at = next(i for i, row in enumerate(lines) if row == ["$Elements"]) + 2
    many = int(lines[at - 1][0])
    return added(nodes, ((int(row[3]), row[-4:])
                         for row in lines[at:at + many] if row[1] == "4"))


def of_report(path, roles):
    volumes = collections.Counter()
    number = 0
    with open(path, encoding="utf-8") as text:
        report = json.load(text)
        for segment in report if isinstance(report, list) else [report]:
            for region in segment["regions"]:
                if region["role"] in ("cell", "void"):
                    number += 1
                    if region["role"] in roles:
                        volumes[number] = region["volume"]
    return volumes


def main():
    wanted = of_report(sys.argv[1], ("cell",))
    kind, files = sys.argv[2], sys.argv[3:]
    if kind == "tetgen":
        found = of_tetgen(*files)
    elif kind == "gmsh":
        found = of_gmsh(*files)
    else:                               # a soup does not know what is void
        wanted = of_report(sys.argv[1], ("cell", "void"))
        found = of_report(files[0], ("cell", "void"))
        wanted = collections.Counter(dict(enumerate(sorted(wanted.values()))))
        found = collections.Counter(dict(enumerate(sorted(found.values()))))
    good = set(wanted) == set(found) and all(
        abs(wanted[r] - found[r]) <= 1e-9 * max(1, wanted[r]) for r in wanted)
    if not good:
        print("wanted", dict(wanted), "found", dict(found))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
