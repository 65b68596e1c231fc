#!/usr/bin/env python3
"""snapshot_draw.py -- draws the commands of tests/snapshots at random.

    tests/snapshot_draw.py models SEED >tests/snapshots/models.txt
    tests/snapshot_draw.py KIND N SEED >>tests/snapshots/KIND.txt

N commands of a KIND (a verb, or what has several): models, options with values
and files, each at random. Those that take long are left out, and most that end
in an error. Their digests are dashes: tests/snapshot.py --bless writes them.
"""
import json
import os
import random
import re
import shlex
import sys
import tempfile

import snapshot

SLOW = 0.5                     # seconds; a command that takes longer is left out


class Draw(random.Random):
    """What is drawn is often round, as what people write is."""

    def size(self, low, high):
        return self.choice([
            lambda: round(self.uniform(low, high)),
            lambda: round(2 * self.uniform(low, high)) / 2,
            lambda: round(self.uniform(low, high), 2)])() or low

    def place(self, by):
        return self.choice([0, 0, self.randint(-by, by),
                            round(self.uniform(-by, by), 1)])

    def some(self, low, high, of):
        return self.sample(of, self.randint(low, min(high, len(of))))

    def vector(self):
        while True:
            found = [self.choice([-2, -1, 0, 1, 2, 0.5]) for _ in range(3)]
            if any(found):
                return found


# --- models ------------------------------------------------------------------

def term(name, *arguments):
    return "%s(%s)" % (name, ", ".join(str(one) for one in arguments))


def outline(draw, corners, radius):
    """A polygon seen from its middle, so it does not cross itself."""
    from math import cos, pi, sin
    turn, points = draw.random(), []
    for i in range(corners):
        angle, far = 2 * pi * (i + turn) / corners, radius * draw.uniform(0.45, 1)
        points.append([round(far * cos(angle), 2), round(far * sin(angle), 2)])
    return points


def box_outline(width, depth):
    return [[0, 0], [width, 0], [width, depth], [0, depth]]


def primitive(draw):
    """A solid about 1 to 6 long, and whether it is round."""
    s = draw.size
    few = draw.choice([[], [], ["facets(%d)" % draw.choice([6, 8, 12, 16, 24])]])
    shift = draw.choice([[], [], [term("shift", s(0.2, 1.5), draw.place(1))]])

    def turned():
        inner, outer = s(0.5, 1.5), s(2, 3)
        return term("turning", term("outline", [
            [inner, 0], [outer, 0], [outer, s(1, 3)], [inner, s(1, 3)]]), *few,
            *draw.choice([[], ["angle(%d)" % draw.choice([90, 180, 200, 270])]]))

    def holed():
        width, depth = s(3, 6), s(3, 6)
        hole = [[x + 1, y + 1] for x, y in box_outline(width / 3, depth / 3)]
        return term("prism", term("outline", box_outline(width, depth)),
                    term("holes", [hole]), term("height", s(1, 4)), *shift)

    return draw.choice([
        lambda: term("box", term("size", s(2, 6), s(2, 6), s(2, 6))),
        lambda: term("box", term("size", s(2, 6), s(2, 6), s(2, 6))),
        lambda: term("cylinder", term("radius", s(0.5, 3)), term("height", s(2, 7)),
                     *shift, *few),
        lambda: term("cylinder", term("radius", s(0.5, 3)), term("height", s(2, 7)),
                     *few),
        lambda: term("cylinder", term("radius", s(1, 3), s(1, 2)),
                     term("height", s(2, 6)), *few),
        lambda: term("cone", term("radius", s(1, 3)), term("height", s(2, 6)),
                     *shift, *few),
        lambda: term("cone", term("radius", s(2, 3)), term("top", s(0.5, 1.5)),
                     term("height", s(2, 6)), *shift, *few),
        lambda: term("pyramid", term("base", s(2, 6), s(2, 6)),
                     term("height", s(1, 5)), *shift),
        lambda: term("prism", term("outline", outline(draw, draw.randint(3, 8), 3)),
                     term("height", s(1, 5)), *shift),
        holed,
        lambda: term("hollow_cylinder", term("radius", s(2, 3)),
                     term("inner", s(0.5, 1.5)), term("height", s(2, 5)), *few),
        lambda: term("sphere", term("radius", s(1, 3)), *few),
        lambda: term("hemisphere", term("radius", s(1, 3)), *few),
        lambda: term("egg", term("radius", s(1, 2)), term("up", s(1, 3)),
                     term("down", s(1, 2)), "facets(16)"),
        lambda: term("torus", term("radius", s(2, 3)), term("tube", s(0.5, 1)),
                     "facets(16)", "sides(8)"),
        turned,
        lambda: term("transition", term("base", term("rectangle", s(2, 5), s(2, 5))),
                     term("top", term("circle", s(0.5, 2))), term("height", s(2, 5)),
                     *shift),
        lambda: term("elbow", term("diameter", s(1, 2)), term("radius", s(2, 3)),
                     term("pieces", draw.randint(2, 5)),
                     term("angle", draw.choice([45, 60, 90]))),
        lambda: term("wye", term("diameter", s(1, 2)), "angle(70)",
                     term("stem", s(2, 3)), term("legs", s(2, 4)))])()


def moved(draw, what):
    moves = []
    if draw.random() < 0.5:
        moves.append(draw.choice([
            lambda: term("rotate", draw.choice("xyz"), draw.choice(
                [90, 90, 45, 30, -90, 180, 37])),
            lambda: term("rotate", term("axis", *draw.vector()), draw.choice(
                [30, 90, 120])),
            lambda: term("mirror", draw.choice("xyz")),
            lambda: term("scale", draw.choice([1, 2, 0.5]), 1, draw.choice(
                [1, 1.5]))])())
    if draw.random() < 0.7:
        moves.append(term("translate", *(draw.place(3) for _ in range(3))))
    return "at([%s], %s)" % (", ".join(moves), what) if moves else what


def solid(draw):
    return moved(draw, primitive(draw))


def scene(draw):
    """Segments that may meet, the last of them perhaps of the others."""
    lines, count = [], draw.choice([1, 2, 2, 2, 3, 3, 4])
    words = draw.sample(["pipe", "block", "cap", "branch", "lid"], count)
    for i in range(count):
        what = solid(draw)
        if draw.random() < 0.4:
            what = term("named", words[i], what)
        lines.append("segment(%d, solid, %s)." % (i + 1, what))
    if count > 1 and draw.random() < 0.4:
        lines.append("segment(%d, solid, %s([%s]))." % (
            count + 1, draw.choice(["union", "intersection", "difference",
                                    "difference"]),
            ", ".join(str(i + 1) for i in range(count))))
    if draw.random() < 0.3:
        lines.append("view(%d, %d, 0)." % (draw.choice([0, 30, 300, 270, 45]),
                                           draw.choice([0, 30, 45, 60, 90])))
    if draw.random() < 0.15:
        lines.append("look(1, colour(%s))." % draw.choice(
            ["red", "rgb(30,90,160)", "green"]))
    if draw.random() < 0.2:
        lines.append("unfolding(1, %s)." % draw.choice(
            ["removed([base])", "true_lengths", "trim(outside)", "thickness(0.1)"]))
    return "\n".join(lines) + "\n"


def surfaces(draw):
    """Sheets, wires and solids of rows, whose faces may be open or wrong."""
    s, lines = draw.size, []
    lines.append("segment(1, surface, %s)." % moved(draw, draw.choice([
        lambda: "rectangle(size(%s, %s))" % (s(3, 6), s(3, 6)),
        lambda: "circle(radius(%s))" % s(1, 3),
        lambda: "sheet(points([[-3,-2,0], [0,-2,%s], [3,-2,0], [3,2,0], [0,2,1], "
                "[-3,2,0]]), faces([[1,2,5,6], [2,3,4,5]]))" % s(0.5, 2),
        lambda: "open_transition(base(circle(%s)), top(rectangle(2, 1, 0.2)), "
                "height(%s))" % (s(1, 3), s(2, 4))])()))
    lines.append("segment(2, solid, %s)." % solid(draw))
    if draw.random() < 0.5:
        lines.append("segment(3, curve, line(from(%s, %s, -3), to(%s, %s, 4)))." % (
            draw.place(2), draw.place(2), draw.place(2), draw.place(2)))
    return "\n".join(lines) + "\n"


def glued(draw):
    """Boxes that have faces, edges or corners in common, and what glues them."""
    places = draw.sample([(0, 0, 0), (3, 0, 0), (3, 2, 0), (0, 2, 0), (0, 0, 2),
                          (3, 0, 2), (1, 1, 2), (1.5, 0, 2)], draw.randint(2, 4))
    lines = ["segment(%d, solid, at([translate(%s, %s, %s)], box(size(3, 2, 2))))."
             % ((i + 1,) + place) for i, place in enumerate(places)]
    if draw.random() < 0.3:
        lines.append("segment(9, solid, %s)." % solid(draw))
    every = [str(i + 1) for i in range(len(places))]
    lines.append("segment(10, cells, glue([%s]))." % ", ".join(every))
    return "\n".join(lines) + "\n"


def mesh(draw):
    """OFF: a box of corners that stand nearly anywhere, and with a fault."""
    points = [[x + draw.uniform(-0.3, 0.3) if draw.random() < 0.3 else x
               for x in (a, b, c)] for a in (0, 3) for b in (0, 2) for c in (0, 2)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4],
             [1, 5, 7, 3]]
    triangles = []
    for a, b, c, d in faces:
        triangles += [[a, b, c], [a, c, d]]
    fault = draw.choice(["none", "hole", "turned", "twice", "loose", "flat",
                         "split", "inside out", "wide"])
    if fault == "hole":
        triangles.pop(draw.randrange(12))
    elif fault == "turned":
        triangles[draw.randrange(12)].reverse()
    elif fault == "twice":
        triangles.append(list(draw.choice(triangles)))
    elif fault == "loose":
        points.append([9, 9, 9])
    elif fault == "flat":
        triangles.append([0, 1, 1])
    elif fault == "split":
        points.append(list(points[0]))
        triangles = [[8 if k == 0 and i % 2 else k for k in triangle]
                     for i, triangle in enumerate(triangles)]
    elif fault == "inside out":
        triangles = [triangle[::-1] for triangle in triangles]
    elif fault == "wide":
        triangles = faces
    return "OFF\n%d %d 0\n%s\n%s\n" % (
        len(points), len(triangles),
        "\n".join(" ".join("%.9g" % x for x in point) for point in points),
        "\n".join("%d %s" % (len(face), " ".join(map(str, face)))
                  for face in triangles))


def problem(draw, i):
    """A problem about a scene."""
    asked = draw.some(1, 3, [
        "ask(draw(penetration))", "ask(count(loops))", "ask(develop(1))",
        "ask(develop(2))", "ask(measure(area(1), mm2, 1))",
        "ask(measure(volume(1), cm3, 0.1))", "ask(measure(edge(1, 1, 2), mm, 0.1))",
        "ask(measure(shortest_generator(2), mm, 0.1))"])
    more = draw.some(0, 2, ["planes(z)", "planes(straight)", "planes(y, 5)",
                            "generators(8)", "edges(all)", "branch(1)",
                            "blank(right)",
                            "part(1, en, 'body')"])
    given = draw.choice(["front, top", "front, top, right", "top, left", "back"])
    return ("problem(a, 's%02d.pl', [ given([%s]), %s ]).\n" % (
        i, given, ", ".join(asked + more)) + draw.choice(
            ["sheet('A3', [a], []).\n", "sheet('A3', [a], [ angle(third) ]).\n",
             "sheet('A4', [a], [ angle(first) ]).\npupils(['Kim', 'Lee']).\n"]))


def far(draw):
    """Solids with thin walls and gaps, far away: what a file cannot hold."""
    thin = draw.choice([0.01, 0.001, 0.0001, 0.00003, 2 ** -12, 2 ** -16])
    where = draw.choice([0, 100, 1000.5, 10000.25, 100000.1])
    turn = draw.choice(["rotate(z, 0)", "rotate(z, 30)", "rotate(axis(1, 2, 3), 40)"])
    wall = draw.choice([
        "difference([box(size(4, 4, 4)), box(size(%.9g, %.9g, 9))])" % (
            4 - 2 * thin, 4 - 2 * thin),
        "union([box(size(4, 4, 4)), at([translate(%.9g, 0, 0)], box(size(4, 3, 4)))])"
        % (4 + thin),
        "difference([cylinder(radius(3), height(2), facets(24)), "
        "at([translate(%.9g, 0, -1)], cylinder(radius(%.9g), height(4), facets(24)))])"
        % (thin, 3 - 2 * thin),
        "union([sphere(radius(2), facets(12)), at([translate(0, 0, %.9g)], "
        "sphere(radius(2), facets(12)))])" % thin,
        "box(size(4, 4, %.9g))" % thin])
    return "segment(1, solid, at([%s, translate(%s, %s, 0)], %s)).\n" % (
        turn, where, -where, wall) + draw.choice(
            ["", "segment(2, solid, at([translate(%s, %s, 1)], %s)).\n" % (
                where, -where, primitive(draw))])


def openscad(draw, depth=3):
    """A .csg file, as OpenSCAD writes them."""
    s, facets = draw.size, "$fn = %d, $fa = 12, $fs = 2" % draw.choice([0, 6, 12, 16])

    def flat():
        return draw.choice([
            "square(size = [%s, %s], center = %s);" % (
                s(1, 4), s(1, 4), draw.choice(["true", "false"])),
            "circle(%s, r = %s);" % (facets, s(1, 3)),
            "polygon(points = %s, paths = undef, convexity = 1);" % outline(
                draw, draw.randint(3, 7), 3)])

    def node(depth):
        if depth == 0 or draw.random() < 0.3:
            return draw.choice([
                "cube(size = [%s, %s, %s], center = %s);" % (
                    s(1, 5), s(1, 5), s(1, 5), draw.choice(["true", "false"])),
                "sphere(%s, r = %s);" % (facets, s(1, 3)),
                "cylinder(%s, h = %s, r1 = %s, r2 = %s, center = %s);" % (
                    facets, s(1, 5), s(1, 3), draw.choice([0, 1, 2]),
                    draw.choice(["true", "false"])),
                "linear_extrude(height = %s, center = false, convexity = 1, "
                "scale = [1, 1], %s) { %s }" % (s(1, 4), facets, flat()),
                "rotate_extrude(angle = %d, convexity = 2, %s) { multmatrix([[1, 0, 0,"
                " 4], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { %s } }" % (
                    draw.choice([360, 180, 90]), facets, flat())])
        inner = " ".join(node(depth - 1) for _ in range(draw.randint(1, 3)))
        return draw.choice([
            "group() { %s }", "union() { %s }", "difference() { %s }",
            "intersection() { %s }", "hull() { %s }", "render(convexity = 2) { %s }",
            "color([1, 0.5, 0, 1]) { %s }",
            "multmatrix([[1, 0, 0, PX], [0, 1, 0, PY], [0, 0, 1, PZ], [0, 0, 0, 1]]) "
            "{ %s }", "multmatrix([[0, -1, 0, PX], [1, 0, 0, 0], [0, 0, 1, PZ], "
            "[0, 0, 0, 1]]) { %s }"]).replace("%s", inner)

    text = node(depth) + "\n"
    return re.sub("P[XYZ]", lambda _: str(draw.place(3)), text)


def written_mesh(draw, ending):
    """A mesh with a fault, in another format."""
    lines = mesh(draw).split("\n")
    count, faces = (int(n) for n in lines[1].split()[:2])
    points, rows = lines[2:2 + count], [
        [int(n) for n in row.split()[1:]] for row in lines[2 + count:2 + count + faces]]
    if ending == "obj":
        return "\n".join(["# a mesh", "o part"] + ["v " + p for p in points] + [
            "f " + " ".join(draw.choice(["%d", "%d//1"]) % (n + 1) for n in row)
            for row in rows]) + "\n"
    if ending == "ply":
        return ("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\n"
                "property float y\nproperty float z\nelement face %d\n"
                "property list uchar int vertex_indices\nend_header\n" % (
                    count, faces) + "\n".join(points + [
                        " ".join(map(str, [len(row), *row])) for row in rows]) + "\n")
    return "solid part\n" + "".join(
        "facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n" % "".join(
            "vertex %s\n" % points[n] for n in (row[0], row[i], row[i + 1]))
        for row in rows for i in range(1, len(row) - 1)) + "endsolid part\n"


def city(draw):
    """CityJSON: houses side by side, one of them perhaps open below."""
    points, objects = [], {}
    for i in range(draw.randint(1, 3)):
        x, wide, high, at = 4 * i, draw.choice([3, 4]), draw.size(2, 5), len(points)
        points += [[x + a, b, c] for c in (0, high) for a, b in (
            (0, 0), (wide, 0), (wide, 3), (0, 3))]
        shell = [[[0, 3, 2, 1]], [[4, 5, 6, 7]], [[0, 1, 5, 4]], [[1, 2, 6, 5]],
                 [[2, 3, 7, 6]], [[3, 0, 4, 7]]]
        if draw.random() < 0.3:
            shell = shell[1:]
        shell = [[[n + at for n in ring] for ring in face] for face in shell]
        kind, boundaries = draw.choice([("Solid", [shell]), ("MultiSurface", shell)])
        objects["house-%d" % i] = {"type": "Building", "geometry": [
            {"type": kind, "lod": draw.choice(["1", "2"]), "boundaries": boundaries}]}
    return json.dumps({"type": "CityJSON", "version": "1.1", "transform": {
        "scale": [1, 1, 1], "translate": [draw.choice([0, 1000.5]), 0, 0]},
        "CityObjects": objects, "vertices": points}) + "\n"


def parameters(draw):
    """A model with parameters, and with rows."""
    formula = draw.choice(["param(a)*2", "sqrt(param(a))", "max(param(a), 3)",
                           "param(a)/2+param(b)", "abs(param(b)-5)",
                           "param(a)*sin(param(c))+2", "hypot(param(a), param(b))"])
    return ("param(a, %s).\nparam(b, %s).\nparam(c, %s).\nparam(d, %s).\n"
            "param_about(a, [ min(1), max(9), text(en, 'length') ]).\n"
            "segment(1, solid, box(size(param(a), param(b), param(d)))).\n"
            "segment(2, solid, at([rotate(z, param(c)), translate(1, 1, param(a)/4)],"
            " cylinder(radius(param(b)/3), height(param(d)), facets(12)))).\n"
            "segment(3, surface, sheet).\n"
            "v(3, 1, -2, 0, 1). v(3, 2, 6, 0, 1). v(3, 3, 6, 3, param(d)). "
            "v(3, 4, -2, 3, param(d)).\np(3, 1, [1, 2, 3, 4]).\n" % (
                draw.size(2, 5), draw.size(2, 5), draw.choice([0, 30, 45, 90]), formula))


def models(seed):
    draw = Draw(seed)
    made = {}
    for i in range(60):
        made["s%02d.pl" % i] = scene(draw)
    for i in range(8):
        made["w%d.pl" % i] = surfaces(draw)
    for i in range(8):
        made["g%d.pl" % i] = glued(draw)
    for i in range(16):
        made["m%02d.off" % i] = mesh(draw)
    for i in range(30):
        made["q%02d.pl" % i] = problem(draw, i)
    made["family.pl"] = (
        "param(r, 2).\nparam(h, param(r)*3).\nparam_about(r, [min(1), max(4)]).\n"
        "segment(1, solid, cylinder(radius(param(r)), height(param(h)), "
        "facets(16))).\nsegment(2, solid, at([rotate(y, 90), translate(0, 0, "
        "param(h)/2)], cylinder(radius(param(r)/2), height(5), facets(12)))).\n")
    made["look.pl"] = ("look(1, colour(rgb(200, 90, 40))).\nlook(2, opacity(0.4))."
                       "\nlight(1, direction(1, 2, 3)).\n")
    more = Draw(seed + 1)              # what came later; the others stay the same
    for i in range(24):
        made["f%02d.pl" % i] = far(more)
    for i in range(30):
        made["c%02d.csg" % i] = openscad(more)
    for i in range(12):
        made["r%02d.%s" % (i, ["obj", "ply", "stl"][i % 3])] = written_mesh(
            more, ["obj", "ply", "stl"][i % 3])
    for i in range(6):
        made["j%d.json" % i] = city(more)
    for i in range(12):
        made["p%02d.pl" % i] = parameters(more)
    made["block.pl"] = ('title_block(name, "Bracket").\n'
                        'title_block(drawn_by, "A. Fitter").\n')
    return made


def print_models(seed):
    print("# Models of the commands beside this file (tests/snapshot_draw.py).")
    for name, text in models(seed).items():
        print("== %s\n%s" % (name, text), end="")


# --- commands ----------------------------------------------------------------

FACTS = [os.path.join("facts", folder, name)
         for folder in ("", "figures", "fittings", "patterns", "gallery")
         for name in sorted(os.listdir(os.path.join(snapshot.ROOT, "facts", folder)))
         if name.endswith(".pl") and name not in ("batch.pl", "primitives.pl")]
SOLIDS = ["s%02d.pl" % i for i in range(60)]
SHEETS = ["w%d.pl" % i for i in range(8)]
GLUED = ["g%d.pl" % i for i in range(8)]
FAR = ["f%02d.pl" % i for i in range(24)]
SCAD = ["c%02d.csg" % i for i in range(30)]
READ = ["r%02d.%s" % (i, ["obj", "ply", "stl"][i % 3]) for i in range(12)]
CITIES = ["j%d.json" % i for i in range(6)]
PARAMETERS = ["p%02d.pl" % i for i in range(12)]
PROBLEMS = ["q%02d.pl" % i for i in range(30)]
MESHES = ["m%02d.off" % i for i in range(16)]


def a_model(draw, *kinds):
    return draw.choice(draw.choice(kinds or (SOLIDS, SOLIDS, FACTS)))


def sized(low, high):
    return lambda draw: str(draw.size(low, high))


def one(*words):
    return lambda draw: draw.choice(words)


def vector(draw):
    return ",".join(map(str, draw.vector()))


def plane(draw):
    return "%s,%s" % (vector(draw), draw.place(3))


def cut(draw):
    return draw.choice([lambda: draw.choice("xyz"), lambda: "%s=%s" % (
        draw.choice("xyz"), draw.place(2)), lambda: plane(draw)])()


def view(draw):
    return draw.choice([
        "front", "back", "left", "right", "top", "bottom", "isometric", "dimetric",
        "trimetric", "300,60", "45,30", "10,80,40", "210,100", "300,60,25"])


NUMBER = one("1", "2", "3")
SHADE = one("lambert", "gooch", "cel=3", "zebra=6", "flat", "xray")
LOOKING = [("view", view)] * 3 + [
    ("direction", vector), ("eye", lambda d: ",".join(
        str(d.choice([-1, 1]) * d.randint(6, 20)) for _ in range(3))),
    ("up", one("x", "y", "z")), ("projection", one("parallel", "central")),
    ("segment", NUMBER)]
COMMON = [("lang", one("ko")), ("strict", None), ("quiet", None),
          ("limits", one("facets=200", "nodes=300", "digits=12"))]
PICTURE = LOOKING + [("lines", one("feature", "all", "penetration")),
                     ("crease", one("0", "10", "40", "60", "90"))]
STYLE = ("style", one("facts/styles/blueprint.pl", "facts/styles/eight_pens.pl",
                      "facts/styles/ghost.pl", "facts/styles/single_pen.pl"))
DASHES = ("dashes", one("auto", "geometry", "type"))
UNIT = ("unit", one("mm", "cm", "m", "inch"))
SCALE = ("scale", one("1:1", "5:1", "10:1", "1:2", "fit"))
TOLERANCE = ("tolerance", one("0", "0.001", "0.1"))
RULES = ("rules", one("docs/line_rules.pl", "docs/back_rules.pl",
                      "docs/pieces_rules.pl", "docs/faces_rules.pl",
                      "docs/weld_rules.pl", "docs/tangent_rules.pl"))
OPTIONS = {
    "draw": PICTURE + [
        ("hidden", one("dashed", "removed", "shown")), ("cutaway", cut), SCALE,
        UNIT, STYLE, DASHES, ("shade", SHADE), ("shade", one("hatch")),
        ("size", one("100x80", "200x150", "300x100")), ("points", one("3", "8", "all")),
        ("centre-lines", None), ("min-line", one("0.5", "5")), TOLERANCE,
        ("dpi", one("50", "72")), ("explode", one("0.5", "1")), RULES],
    "sheet": [
        ("sheet", one("A4", "A3", "A2", "A3-portrait", "A4-landscape")),
        ("views", one("front,top", "front,top,right", "isometric", "front,left,right",
                      "front,top,right,isometric", "top,isometric", "back,bottom")),
        ("angle", one("first", "third")), ("section", cut), ("section", cut),
        ("title-block", one("block.pl")), ("language", one("en", "ko")),
        ("no-frame", None), SCALE, UNIT, STYLE, DASHES, ("points", one("4", "all")),
        ("hidden", one("dashed", "removed", "shown")), ("lines", one("all", "penetration")),
        ("crease", one("10", "50")), ("shade", one("hatch", "cel=3")), RULES],
    "unfold": [
        ("only", one("1", "2", "1,2", "pipe", "block")), ("cells", None),
        ("trim", one("outside", "inside")), ("no-lines", None),
        ("faces", one("12", "20", "60")), ("root", one("1", "2", "top", "base")),
        ("cut", one("1", "3,4", "1-2")), ("keep", one("1", "2,5")),
        ("order", one("1,2", "2,3,4")), ("remove", one("base", "top", "base,top", "1")),
        ("minimize", one("seam", "pieces", "longest", "area")),
        ("effort", one("0", "1")), ("thickness", one("0.1", "0.2", "0.5")),
        ("size", one("inside", "middle", "outside")), ("kfactor", one("0.3", "0.5")),
        ("bend-radius", one("0", "0.2", "0.4")), ("relief", one("square", "round", "none")),
        ("material", one("steel", "copper", "zinc")), ("bends", None), TOLERANCE, SCALE,
        UNIT, ("height", one("60", "100")), ("up", one("x", "y", "z")),
        ("pages", one("1", "2", "4")), ("fit", None),
        ("page", one("A4", "A3-landscape", "letter", "120x90")), ("tile", None),
        ("overlap", one("5", "15")), ("margin", one("0", "5", "20")), ("gap", one("0", "8")),
        ("kerf", one("0.1", "0.3")), ("tabs", one("0.3", "1", "5")),
        ("tab-sides", one("one", "both", "alternate")), ("lap", one("0.3", "2")),
        ("lock-seam", one("0.2", "1")), ("open-slits", None), ("no-open-slits", None),
        ("no-numbers", None), ("names", one("numbers", "words", "pieces")),
        ("angles", None), ("fold-threshold", one("0", "20", "60")), ("inside", None),
        ("mirror", None), ("grid", one("1", "5")), STYLE, DASHES, ("json", None), RULES],
    "render": LOOKING + [
        ("size", one("160x120", "200x100", "97x60")), ("window", one("-2,-2,2,2", "0,0,3,2")),
        ("smooth", one("1", "2", "4")), ("shade", SHADE), ("edges", None),
        ("shadows", None), ("surface", one("true", "facets")),
        ("colours", one("root", "leaf")), ("look", one("look.pl")), ("light", vector),
        ("see-through", one("1", "2=0.5", "1=0.1")), ("section", cut),
        ("background", one("black", "200,220,255", "none")), ("palette", one("4", "16")),
        ("buffer", one("depth=out/d.pfm", "normal=out/n.pfm", "tone=out/t.pgm",
                       "id=out/i.csv")),
        ("spans", one("out/spans.csv")), ("scan-line", one("30=out/y.svg", "55=out/y.pl")),
        ("dpi", one("72"))],
    "penetrate": [("exact", None), TOLERANCE, ("json", None), RULES],
    "solids": [TOLERANCE, ("repair", None), ("json", None)],
    "cells": [("neighbours", None), ("json", None)],
    "glue": [("only", one("vertices", "edges", "faces")), ("dry-run", None), TOLERANCE,
             ("repair", None), ("neighbours", None), ("json", None)],
    "check": [("json", None)],
}
TRUE = [("seam", one("0", "90", "45", "180")), ("generators", one("8", "12", "16")),
        ("half", None), ("gores", one("6", "8")), ("zones", one("4", "5")),
        ("chord", one("0.01", "0.1")), ("table", one("out/t.csv")),
        ("no-lengths", None), ("set-in", None), ("other-thickness", one("0.1", "0.3"))]
ENDINGS = {
    "draw": ["svg"] * 4 + ["pdf", "eps", "ps", "png", "dxf", "hpgl", "json", "pl"],
    "sheet": ["svg"] * 3 + ["pdf", "dxf", "hpgl", "json", "pl"],
    "unfold": ["svg"] * 4 + ["pdf", "eps", "dxf", "hpgl", "json", "fold", "pl", "obj",
                             "off"],
    "render": ["png", "ppm", "pl"],
    "penetrate": ["pl", "obj", "dxf", "svg", "csv", "tsv", "txt"],
    "solids": ["pl", "stl", "off", "obj", "ply"],
    "cells": ["pl", "csv", "dot", "poly", "geo", "obj", "off", "stl", "json"],
    "glue": ["pl"],
}
NEEDS = {                      # what says nothing alone
    "overlap": {"tile": None}, "tab-sides": {"tabs": "1"}, "up": {"height": "80"},
    "kfactor": {"thickness": "0.2"}, "bend-radius": {"thickness": "0.2"},
    "relief": {"thickness": "0.2"}, "material": {"thickness": "0.2"},
    "bends": {"thickness": "0.2"}, "size": {"thickness": "0.2"},
    "open-slits": {"tabs": "1"}, "no-open-slits": {"tabs": "1"},
    "set-in": {"trim": "outside", "thickness": "0.2"},
    "other-thickness": {"trim": "outside", "thickness": "0.2"}}
MOST = {"penetrate": 2, "solids": 2, "cells": 2, "glue": 3, "check": 1}


def options(draw, kind, table=None, most=None):
    chosen = {}
    table = table or OPTIONS[kind]
    for name, value in draw.some(0, most or MOST.get(kind, 5), table):
        chosen[name] = value(draw) if value else None
    if draw.random() < 0.12:
        name, value = draw.choice(COMMON)
        chosen[name] = value(draw) if value else None
    for name in list(chosen):
        if kind in ("unfold", "unroll") and draw.random() < 0.95:
            chosen = {**NEEDS.get(name, {}), **chosen}
    return [word for name, value in chosen.items()
            for word in (["--" + name] if value is None else ["--" + name, value])]


def outputs(draw, kind):
    return [word for ending in draw.some(1, 2, sorted(set(ENDINGS[kind]))
                                         if draw.random() < 0.3
                                         else [draw.choice(ENDINGS[kind])])
            for word in ("-o", "out/a." + ending)]


def command(draw, kind):
    if kind == "draw":
        return ["draw", a_model(draw, SOLIDS, SOLIDS, FACTS, SHEETS, GLUED, MESHES),
                *options(draw, kind), *outputs(draw, kind)]
    if kind == "sheet":
        return ["draw", a_model(draw, SOLIDS, SOLIDS, FACTS, SHEETS),
                *options(draw, kind), "--sheet", "A3", *outputs(draw, kind)]
    if kind == "unfold":
        return ["unfold", a_model(draw, SOLIDS, SOLIDS, FACTS, FACTS, SHEETS, GLUED),
                *options(draw, kind), *outputs(draw, kind)]
    if kind == "unroll":
        more = options(draw, "unfold", most=3) if draw.random() < 0.6 else []
        return ["unfold", a_model(draw, SOLIDS, FACTS), "--true",
                *options(draw, kind, TRUE), *more, *outputs(draw, "unfold")]
    if kind == "render":
        return ["render", a_model(draw, SOLIDS, SOLIDS, FACTS, SHEETS),
                *options(draw, kind), "--size", "120x90", *outputs(draw, kind)]
    if kind == "penetrate":
        return ["penetrate", *(a_model(draw, SOLIDS, SOLIDS, SOLIDS, FACTS, SHEETS, MESHES)
                               for _ in range(draw.choice([1, 1, 2]))),
                *options(draw, kind), *outputs(draw, kind)]
    if kind == "solids":
        verb = draw.choice(["union", "intersection", "difference", "eval", "split",
                            "split", "convert"])
        count = {"eval": 1, "split": 1, "convert": 1}.get(verb, draw.choice([2, 2, 3]))
        words = [verb, *(a_model(draw, SOLIDS, SOLIDS, MESHES, FACTS)
                         for _ in range(count))]
        if verb == "split":
            words += draw.choice([
                lambda: ["--plane", plane(draw)],
                lambda: ["--by", a_model(draw, SOLIDS, SHEETS)]])()
            if draw.random() < 0.4:
                words += ["--side", draw.choice(["below", "above", "inside", "outside"])]
        chosen = options(draw, kind) if verb != "convert" else draw.choice(
            [[], ["--faces", draw.choice(["8", "20", "40"])]])
        return words + chosen + (outputs(draw, kind)
                                 if verb == "convert" or draw.random() < 0.7 else [])
    if kind == "cells":
        return ["cells", a_model(draw, GLUED, GLUED, SOLIDS, SHEETS),
                *options(draw, kind),
                *(outputs(draw, kind) if draw.random() < 0.7 else [])]
    if kind == "glue":
        return ["glue", a_model(draw, GLUED, SOLIDS, MESHES, SHEETS),
                a_model(draw, SOLIDS, GLUED, MESHES), *options(draw, kind),
                *(outputs(draw, kind) if draw.random() < 0.8 else [])]
    if kind == "check":
        return ["check", a_model(draw, SOLIDS, SHEETS, GLUED, MESHES, MESHES, FACTS),
                *options(draw, kind)]
    if kind == "query":
        return query(draw)
    if kind == "explain":
        return explanation(draw)
    if kind == "written":
        verb = draw.choice(["convert", "eval", "union", "difference", "intersection",
                            "check"])
        words = [verb, a_model(draw, FAR)]
        if verb in ("union", "difference", "intersection"):
            words.append(a_model(draw, FAR, FAR, SOLIDS))
        if verb == "check":
            return words + options(draw, "check")
        return words + [word for ending in draw.some(1, 2, ENDINGS["solids"] + ["stl"])
                        for word in ("-o", "out/a%d.%s" % (draw.randint(1, 9), ending))
                        ] + ([] if verb == "convert" else options(draw, "solids"))
    if kind == "read":
        model = a_model(draw, SCAD, SCAD, READ, CITIES, PARAMETERS)
        words = draw.choice([
            lambda: ["check", model, *options(draw, "check")],
            lambda: ["eval", model, *options(draw, "solids"),
                     *draw.choice([[], ["-o", "out/a.off"], ["-o", "out/a.pl"]])],
            lambda: ["convert", model, "-o", "out/a." + draw.choice(
                ENDINGS["solids"])],
            lambda: ["draw", model, *options(draw, "draw", None, 2), "-o", "out/a.svg"],
            lambda: ["unfold", model, *options(draw, "unfold", None, 2), "-o",
                     "out/a.svg"],
            lambda: ["penetrate", model, "-o", "out/a.csv"],
            lambda: ["query", model, "segment(S, K, T)"],
            lambda: ["explain", model, "param(_)"]])()
        if model in PARAMETERS:
            words += draw.choice([[], ["--set", "a=%s" % draw.size(1, 9)], [
                "--set", "b=param(a)/2", "--set", "c=%d" % draw.choice([10, 60])]])
        if model in CITIES:
            words += draw.choice([[], ["--close"], ["--lod", draw.choice("12")]])
        return words
    if kind == "session":
        return session(draw)
    if kind == "problems":
        return ["problems", a_model(draw, PROBLEMS), "-o", "out/sheets", *(
            draw.choice([[], ["--language", "ko"], ["--angle", "first"],
                         ["--format", draw.choice(["pdf", "dxf", "hpgl"])]]))]
    raise SystemExit("no kind " + kind)


RELATIONS = {
    "contour": 13, "drawn": 7, "e": 5, "from_p": 5, "from_r": 4, "from_v": 4,
    "joint": 6, "leaf_e": 5, "leaf_p": 3, "leaf_t": 6, "leaf_v": 5, "lies_in": 3,
    "line": 9, "origin": 3, "p": 3, "plane": 6, "region": 3, "screen": 5,
    "segment": 3, "sides": 4, "span": 7, "surface_facing": 6, "t": 6, "v": 5}
GOALS = [
    "{S}, chain(C, S1, S2, K, L)", "{S}, model_defect(D)", "{S}, root_segment(R)",
    "{S}, volume(1, X)", "{S}, area(1, X)", "{S}, winding(1, [0.25, 0.5, 0.75], W)",
    "{S}, inside(1, [0.25, 0.5, 0.75])", "{S}, face_of(1, P, What)",
    "{S}, smooth_surface(1, P, X)", "{S}, vertex_exact(1, V, X, Y, Z)",
    "{S}, touches(A, B)", "{S}, explain(line(1))", "{S}, edge_role(1, E, A, B, C)",
    "develop(1, [], D), joint(D, J, E, F, K, A)", "develop(1, [], D), piece(D, P, K)",
    "develop(1, [], D), development_measures(D, M)",
    "true_development(1, P, [], D), segment(D, A, B)",
    "{S}, bounds(1, B)", "shading_scene([], S), scene_leaf(S, L)",
    "pick(pixel(60, 45), [size(120-90)], X)", "segment(S, K, X)",
    "penetrate, penetration_chains(C)", "region(A, B, C, D, E)",
    "radial_cycle(10, A, B, P)", "disk(10, V, A, B)", "loop_cycle(10, P, K, V)"]
SETUPS = ["true", "penetrate", "evaluate", "picture", "evaluate, picture",
          "penetrate, picture"]


def query(draw):
    model = a_model(draw, SOLIDS, SOLIDS, GLUED, SHEETS, FACTS, MESHES)
    setup = draw.choice(SETUPS)
    if draw.random() < 0.6:
        name, arity = draw.choice(sorted(RELATIONS.items()))
        goal = "%s, %s(%s)" % (setup, name, ", ".join("ABCDEFGHIJKLM"[:arity]))
    else:
        goal = draw.choice(GOALS).replace("{S}", setup)
    return ["query", model, goal, "--limit", str(draw.choice([20, 200])),
            *draw.choice([[], ["--format", "csv"], ["--json"],
                          ["--format", "prolog"]])]


ITEMS = [
    "line({N})", "line(_)", "pair({A}, {B})", "pair({A}-{N}, {B}-{N})",
    "vertex({A}, {N})", "edge({A}, {N})", "hidden({A}, {N})", "hidden({A}, _)",
    "why_not(hidden({A}, {N}))", "seam(_)", "seam({N})", "fold({N})", "fold(_)",
    "piece({A}, {N})", "piece({A}, _)", "pattern(_, _)", "pattern({A}, {N})",
    "segment({A})", "pixel({P}, {N})", "why_not(seen({A}))", "region({A}, {N})",
    "glued(10, v({N}))", "glued(10, e({N}))", "glued(10, p({N}))",
    "why_not(glued({A}-p({N}), {B}-p({N})))", "param(_)", "colour({A})"]


def explanation(draw):
    item = re.sub(r"{(\w)}", lambda m: str(
        draw.randint(1, 9) if m[1] == "N" else draw.randint(20, 90) if m[1] == "P"
        else draw.randint(1, 3)), draw.choice(ITEMS))
    words = ["explain", a_model(draw, SOLIDS, SOLIDS, FACTS, GLUED), item]
    if item.startswith(("hidden", "why_not(hidden")):
        words += options(draw, "draw", PICTURE, 2)
    elif item.startswith(("seam", "fold", "piece", "pattern")):
        words += draw.choice([[], ["--cut", "1"], ["--root", "2"], ["--true"],
                              ["--trim", "outside"], ["--minimize", "pieces"]])
    elif item.startswith(("pixel", "why_not(seen")):
        words += ["--size", "120x90", *options(draw, "draw", LOOKING, 1)]
    if draw.random() < 0.3:
        words.append("--json")
    if draw.random() < 0.2:
        words += ["--lang", "ko"]
    return words


def seen_as(draw):
    keys = {}
    for key, value in draw.some(0, 2, [
            ("view", lambda: draw.choice(["front", "top", "isometric", [300, 60],
                                          [20, 70, 10]])),
            ("projection", lambda: draw.choice(["parallel", "central"])),
            ("lines", lambda: draw.choice(["feature", "all", "penetration"])),
            ("hidden", lambda: draw.choice(["dashed", "removed", "shown"])),
            ("up", lambda: draw.choice("xyz")), ("crease", lambda: 50),
            ("size", lambda: [100, 80]), ("segments", lambda: [1])]):
        keys[key] = value()
    return keys


def request(draw):
    n, s = draw.randint(1, 12), draw.randint(1, 3)
    names = ["s%de%d" % (s, n), "s%d" % s, "s%dp%d" % (s, n % 6 + 1), "l%d" % n,
             "s%dv%d" % (s, n)]
    rules = ["line_segment(_, S2, S2).\n", "line_segment(S1, _, S1).\n", "crease(90).\n"]
    made = draw.choice([
        lambda: {"do": "view", **seen_as(draw)},
        lambda: {"do": "view", "format": draw.choice(
            ["strokes", "strokes", "mesh", "json", "dxf"]), **seen_as(draw)},
        lambda: {"do": "view", "format": "strokes", "section": cut(draw)},
        lambda: {"do": "view", "format": "strokes", "explode": 0.5},
        lambda: {"do": "select", "names": draw.some(1, 3, names), **draw.choice(
            [{}, {"keep": False}])},
        lambda: {"do": "select"},
        lambda: {"do": "sheet", "options": options(draw, "sheet"), **draw.choice(
            [{}, {"pens": True}])},
        lambda: {"do": "shaded", "options": ["--size", "90x70",
                                             *options(draw, "render")]},
        lambda: {"do": "unfold", "options": options(draw, "unfold"), **draw.choice(
            [{}, {"segment": s}, {"sheet": 2}])},
        lambda: {"do": "fold", "options": options(draw, "unfold")},
        lambda: {"do": "ask", "goal": query(draw)[2], **draw.choice(
            [{}, seen_as(draw)])},
        lambda: {"do": "ask", "goal": draw.choice(
            ["drawn(A, B, C, D, E, F, G)", "hides(A, B)", "line(A, 1, B, C, D, E, F, G, H)",
             "e(S, E, A, B, T)", "hidden_by(A, B, C, D, E, F)"])},
        lambda: {"do": "explain", "item": explanation(draw)[2]},
        lambda: {"do": "export", "argv": ["draw", *options(draw, "draw"), "-o",
                                          "out/x.svg"]},
        lambda: {"do": "export", "argv": [draw.choice(["check", "penetrate", "cells",
                                                       "eval"])]},
        lambda: {"do": "edit", "set": {"segment": s, "path": draw.choice(
            [[1, 1], [2, 1], [1], [2, 1, 1], [1, 1, 1], [1, 2]]),
            "value": draw.size(1, 4)}},
        lambda: {"do": "edit", "set": {"param": "r", "value": draw.size(1, 4)}},
        lambda: {"do": "cut", "segment": s, "edge": n, **draw.choice(
            [{}, {}, {"keep": True}, {"keep": None}])},
        lambda: {"do": "question", "name": draw.choice(["one", "two"]),
                 "goal": draw.choice(["hides(S1, S2)", "line(_,A,_,_,_,B,_,_,_)",
                                      None])},
        lambda: {"do": "text"},
        lambda: {"do": "text", "body": scene(draw)},
        lambda: {"do": "tree"}, lambda: {"do": "undo"}, lambda: {"do": "undo"},
        lambda: {"do": "redo"}, lambda: {"do": "reload", "look": True},
        lambda: {"do": "save", "file": "out/saved.pl"},
        lambda: {"do": "rules"},
        lambda: {"do": "rules", "try": True, "owner": True,
                 "body": draw.choice(rules), **seen_as(draw)},
        lambda: {"do": "rules", "keep": draw.choice([True, False]), "owner": True},
        lambda: {"do": "complete", "text": draw.choice(
            ["lin", "cyl", "seg", "s", "hid", "rad", "pip"])},
        lambda: {"do": "help", "of": draw.choice(
            ["line/9", "segment", "penetrate", "cylinder", "foo", "draw"])}])()
    return made


def session(draw):
    requests = [request(draw) for _ in range(draw.randint(4, 9))]
    model = draw.choice([a_model(draw), a_model(draw), "family.pl",
                         a_model(draw, SHEETS, GLUED)])
    return ["session", model, json.dumps(requests)]


def main():
    kind, *numbers = sys.argv[1:]
    if kind == "models":
        print_models(int(numbers[0]))
        return
    count, draw = int(numbers[0]), Draw(kind + numbers[1])
    snapshot.SECONDS = 8 * SLOW
    folder = tempfile.TemporaryDirectory()
    program = snapshot.Program(folder.name, snapshot.models_of(
        os.path.join(snapshot.ROOT, "tests/snapshots/x")))
    known = set()
    while len(known) < count:
        words = shlex.join(command(draw, kind))
        status, _ = program.made(words)
        if program.cpu < SLOW and (
                status in ("0", "answered") or draw.random() < 0.2):
            if words not in known:
                print("-------- - " + words, flush=True)
            known.add(words)
    program.end()


main()
