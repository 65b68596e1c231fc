"""Whether a CityJSON 2.0 file is right, by what the standard says alone.

    city_checker.py FILE.city.json [REPORT.json]

Keys and values of the root and the objects; each vertex once, three integers,
and used; boundaries nested as their type wants, with numbers of vertices that
are there; rings that do not turn back and are flat, holes that run against
their outer ring; semantics and materials as many as there are surfaces; shells
of solids closed, outer ones turned out and cavities turned in, all exact. Two
members of a composite solid run against each other where they share a face.
With the report of `cells --json`: solids have the volumes of its cells.
Prints what is wrong, and exits 1 if something is.
"""
import collections
from fractions import Fraction
import json
import sys

# How deep rings are nested in boundaries.
DEPTH = {"MultiPoint": 0, "MultiLineString": 1, "MultiSurface": 2,
         "CompositeSurface": 2, "Solid": 3, "MultiSolid": 4,
         "CompositeSolid": 4}
LEVELS = {"MultiSurface": 1, "CompositeSurface": 1, "Solid": 2,
          "MultiSolid": 3, "CompositeSolid": 3}
OBJECTS = {"Bridge", "BridgePart", "BridgeInstallation",
           "BridgeConstructiveElement", "BridgeRoom", "BridgeFurniture",
           "Building", "BuildingPart", "BuildingInstallation",
           "BuildingConstructiveElement", "BuildingFurniture",
           "BuildingStorey", "BuildingRoom", "BuildingUnit",
           "CityFurniture", "CityObjectGroup", "GenericCityObject",
           "LandUse", "OtherConstruction", "PlantCover",
           "SolitaryVegetationObject", "TINRelief", "WaterBody", "Road",
           "Railway", "Waterway", "TransportSquare", "Tunnel", "TunnelPart",
           "TunnelInstallation", "TunnelConstructiveElement",
           "TunnelHollowSpace", "TunnelFurniture"}
ROOT = {"type", "version", "transform", "CityObjects", "vertices", "metadata",
        "appearance", "geometry-templates", "extensions"}

wrong = []


def say(where, what):
    wrong.append(f"{where}: {what}")


def is_index(value):
    return isinstance(value, int) and not isinstance(value, bool)


# ---- vectors of rationals ----

def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def area_vector(points):
    """Twice the area, where the ring looks."""
    total = (0, 0, 0)
    for a, b in zip(points, points[1:] + points[:1]):
        total = tuple(x + y for x, y in
                      zip(total, cross(minus(a, points[0]),
                                       minus(b, points[0]))))
    return total


# ---- the root ----

def root_checked(city):
    for key in city:
        if key not in ROOT and not key.startswith("+"):
            say("/", f"unknown key {key}")
    if city.get("type") != "CityJSON" or city.get("version") != "2.0":
        say("/", "no CityJSON 2.0")
    transform = city.get("transform", {})
    if set(transform) != {"scale", "translate"}:
        say("/transform", "scale and translate are wanted")
    for key, numbers in transform.items():
        if len(numbers) != 3 or any(isinstance(n, (bool, str))
                                    for n in numbers):
            say(f"/transform/{key}", "three numbers are wanted")
    if any(n <= 0 for n in transform.get("scale", [])):
        say("/transform/scale", "not positive")


def vertices_read(city):
    for i, vertex in enumerate(city["vertices"]):
        if len(vertex) != 3 or not all(is_index(n) for n in vertex):
            say(f"/vertices/{i}", "three integers are wanted")
            return None
    if len(set(map(tuple, city["vertices"]))) != len(city["vertices"]):
        say("/vertices", "one is there twice")
    scale, move = ([Fraction(n) for n in city["transform"][key]]
                   for key in ("scale", "translate"))
    return [tuple(n * s + t for n, s, t in zip(vertex, scale, move))
            for vertex in city["vertices"]]


# ---- boundaries ----

def indices(boundaries, depth, where, most):
    """All numbers of vertices, if they are nested so deep."""
    if not isinstance(boundaries, list):
        say(where, "a list is wanted")
        return
    for i, part in enumerate(boundaries):
        here = f"{where}/{i}"
        if depth > 0:
            if part == []:
                say(here, "empty")
            yield from indices(part, depth - 1, here, most)
        elif not is_index(part):
            say(here, "a number of a vertex is wanted")
        elif not 0 <= part < most:
            say(here, f"there is no vertex {part}")
        else:
            yield part


def surfaces_of(boundaries, levels):
    if levels == 1:
        yield from boundaries
    else:
        for part in boundaries:
            yield from surfaces_of(part, levels - 1)


def surface_checked(rings, at, where):
    normals = []
    for ring in rings:
        if len(ring) < 3 or len(set(ring)) != len(ring):
            say(where, f"ring {ring} is too short, or has a vertex twice")
        normals.append(area_vector([at[i] for i in ring]))
    outer = normals[0]
    if outer == (0, 0, 0):
        say(where, "no area")
        return
    for normal in normals[1:]:
        if dot(normal, outer) >= 0:
            say(where, "a hole runs as its outer ring does")
    used = [at[i] for ring in rings for i in ring]
    size = max(abs(x) for point in used for x in point)
    for point in used:
        off = dot(minus(point, used[0]), outer)
        if off * off > dot(outer, outer) * (size / 10**9) ** 2:
            say(where, "not flat")


def signed_volume(shell, at):
    origin = at[shell[0][0][0]]
    return sum(dot(minus(at[ring[0]], origin),
                   area_vector([at[i] for i in ring]))
               for rings in shell for ring in rings) / 6


def shell_checked(shell, inner, at, where):
    edges = collections.Counter()
    for rings in shell:
        for ring in rings:
            for a, b in zip(ring, ring[1:] + ring[:1]):
                edges[a, b] += 1
    if any(edges[a, b] != edges[b, a] for a, b in list(edges)):
        say(where, "the shell is open")
    volume = signed_volume(shell, at)
    if (volume > 0) == inner or volume == 0:
        say(where, f"volume {float(volume)}: turned round")
    return volume


def solid_checked(shells, at, where):
    return sum(shell_checked(shell, k > 0, at, f"{where}/{k}")
               for k, shell in enumerate(shells))


def ring_key(ring):
    at = ring.index(min(ring))
    return tuple(ring[at:] + ring[:at])


def members_checked(solids, where):
    """A face of two members runs one way in one, the other in the other."""
    seen = collections.Counter(
        ring_key(rings[0])
        for shells in solids for shell in shells for rings in shell)
    if any(n > 1 for n in seen.values()):
        say(where, "two members have a face on one side")
    if len(solids) > 1 and not any(
            ring_key(list(reversed(key))) in seen for key in seen):
        say(where, "no members share a face")


# ---- objects ----

def shape(values, levels):
    return len(values) if levels == 1 else [shape(part, levels - 1)
                                            for part in values]


def values_checked(geometry, where):
    levels = LEVELS.get(geometry["type"])
    told = [geometry["semantics"]] if "semantics" in geometry else []
    told += [theme for theme in geometry.get("material", {}).values()
             if "values" in theme]
    for theme in told:
        if levels and shape(theme["values"], levels) != shape(
                geometry["boundaries"], levels):
            say(where, "values and boundaries differ in shape")


def geometry_checked(geometry, at, where):
    kind, boundaries = geometry.get("type"), geometry.get("boundaries")
    if kind not in DEPTH or not isinstance(geometry.get("lod"), str):
        say(where, "a type and a lod are wanted")
        return set(), []
    before = len(wrong)
    used = set(indices(boundaries, DEPTH[kind], where, len(at)))
    if len(wrong) > before:
        return used, []
    values_checked(geometry, where)
    if kind == "MultiLineString" and any(len(set(line)) != len(line) or
                                         len(line) < 2 for line in boundaries):
        say(where, "a line has a vertex twice, or one alone")
    if kind in LEVELS:
        for rings in surfaces_of(boundaries, LEVELS[kind]):
            surface_checked(rings, at, where)
    if kind == "CompositeSolid":
        members_checked(boundaries, where)
    solids = ([boundaries] if kind == "Solid" else
              boundaries if DEPTH[kind] == 4 else [])
    return used, [solid_checked(solid, at, f"{where}/{k}")
                  for k, solid in enumerate(solids)]


def objects_checked(city, at):
    used, volumes = set(), []
    for name, item in city["CityObjects"].items():
        kind = item.get("type", "")
        if kind not in OBJECTS and not kind.startswith("+"):
            say(name, f"there is no {kind}")
        for k, geometry in enumerate(item.get("geometry", [])):
            now, more = geometry_checked(geometry, at, f"{name}/{k}")
            used |= now
            volumes += more
    if used != set(range(len(at))):
        say("/vertices", f"{len(at) - len(used)} are not used")
    return volumes


def told_volumes(path):
    with open(path, encoding="utf-8") as text:
        report = json.load(text)
    return [region["volume"]
            for segment in (report if isinstance(report, list) else [report])
            for region in segment["regions"] if region["role"] == "cell"]


def main():
    with open(sys.argv[1], encoding="utf-8") as text:
        city = json.load(text)
    root_checked(city)
    at = vertices_read(city)
    volumes = objects_checked(city, at) if at is not None else []
    if len(sys.argv) > 2:
        told = sorted(told_volumes(sys.argv[2]))
        if len(told) != len(volumes) or any(
                abs(a - b) > 1e-6 * abs(b) for a, b in
                zip(sorted(map(float, volumes)), told)):
            say("/", f"volumes {sorted(map(float, volumes))}, not {told}")
    for line in wrong:
        print(line)
    sys.exit(bool(wrong))


main()
