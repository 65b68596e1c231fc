"""serve_studio.py PROGRAM FOLDER: what a studio asks of a session: strokes,
selections, patterns, wishes, questions, rules that are tried, words, progress."""
# covers: complete, line_change, pen_plan, picture_cut, port_cut, seen_stroke,
# covers: decision_ko, operand_edge, section_name, select, verb_session, world_state
from collections import Counter
import json
import math
import struct
import time

from serving import alone, check, checks, code, session, work


def refused(name, wanted, said, do, body=b"", /, **keys):
    head, _ = s.ask(do, body, **keys)
    check(name, code(head) == wanted and said in head["error"]["words"]["en"]
          and head["error"]["words"]["ko"] and head["rev"] == rev(), head)


def rev():
    return s.ask("hello")[0]["rev"]


def strokes(head, octets):
    """(look, segment, start, end, edges, points) of each."""
    words = struct.unpack("<%di" % (len(octets) // 4), octets)
    at, found = 0, []
    while at < len(words):
        look, segment, ends, edges, points = words[at:at + 5]
        at += 5
        found.append((tuple(head["looks"][look]), segment, ends % 4, ends // 4,
                      words[at:at + edges],
                      tuple(zip(words[at + edges:at + edges + 2 * points:2],
                                words[at + edges + 1:at + edges + 2 * points:2]
                                ))))
        at += edges + 2 * points
    return found


s = session()

# ---- without a document ----

for do, keys in (("select", {"names": ["s1"]}), ("unfold", {}), ("fold", {}),
                 ("cut", {"segment": 1, "edge": 1}), ("rules", {})):
    head, _ = s.ask(do, **keys)
    check("no document: " + do, code(head) == "request_error.no_document",
          head)

# ---- hello, help, complete ----

head, _ = s.ask("hello")
check("version", "sanggwan " + head["version"] in
      alone("--version")[1].decode(), head)
offered = head["offered"]
head, _ = s.ask("help")
check("help says all", [r["do"] for r in head["requests"]] == offered and
      all(r["words"]["en"] and r["words"]["ko"] != r["words"]["en"]
          for r in head["requests"]), head)
with open("docs/protocol.md", encoding="utf-8") as f:
    protocol = f.read()
for do in offered:
    check("documented: " + do, ("`%s`" % do) in protocol or
          ('"do":"%s"' % do) in protocol or ("### " + do) in protocol)
head, octets = s.ask("help", of="line/9")
check("help of a word", b"line(L, S1, P1" in octets, octets)
refused("help of what", "request_error.bad_key", '"of"', "help", of=1)
head, _ = s.ask("complete", text="lin")
check("complete", {"line/9", "line"} <= {w["word"] for w in head["words"]},
      head)
english = [(w["word"], w["doc"]) for letter in "abcdefghijklmnopqrstuvwxyz"
           for more in ["", *"aeioulrhtsndc_"]
           for w in s.ask("complete", text=letter + more)[0]["words"]
           if w["doc"] and w["doc"] == w["ko"] and (
               w["kind"] not in ("primitive", "segment", "parameter") or
               ", or " in w["doc"])]
check("each word in Korean", english == [], english)
head, _ = s.ask("complete", text="dorw")
check("meant", "draw/1" in [w["word"] for w in head["words"]] or
      head["words"] == [], head)
head, _ = s.ask("complete", text="")
check("50 words", len(head["words"]) == 50 and head["left"] > 50, head)
refused("complete what", "request_error.bad_key", '"text"', "complete")
s.send({"id": [1], "do": "hello"})
head, _ = s.reply()
check("an id is no list", code(head) == "request_error.bad_key" and
      head["id"] is None, head)

# ---- strokes are those of the drawing ----

for file in ("facts/figures/fig13.pl", "facts/pipe_tee.pl",
             "facts/two_cubes.pl", "facts/smooth.pl"):
    s.ask("open", file=file)
    for keys, options in (({}, []),
                          ({"view": [30, 60], "hidden": "removed"},
                           ["--view", "30,60", "--hidden", "removed"]),
                          ({"view": "front", "up": "y", "size": [100, 80]},
                           ["--view", "front", "--up", "y",
                            "--size", "100x80"])):
        head, octets = s.ask("view", format="strokes", **keys)
        drawn = json.loads(alone("draw", file, "-o", "-", "--format", "json",
                                 *options)[1])
        got = strokes(head, octets)
        check("as many strokes: " + file, len(got) == head["strokes"] > 0,
              head)
        # Names stay when the model is turned, so they may be others there.
        wanted = [(tuple(tuple(round(c * 1000) for c in p)
                         for p in line["points"]),
                   "up" in keys or tuple(line["edges"]))
                  for line in drawn["lines"]]
        check("strokes of %s %s" % (file, keys),
              [(points, "up" in keys or edges)
               for _, _, _, _, edges, points in got] == wanted,
              (got[:2], wanted[:2]))
refused("no such view", "request_error.bad_key", "isometric", "view",
        view="nowhere")
refused("meant", "request_error.bad_key", "Did you mean front", "view",
        view="frunt")
refused("no such segment", "request_error.bad_key", "no segment 77", "view",
        segments=[77])
refused("scale", "request_error.bad_key", "above 0", "view", scale=0)

# ---- what hides what ----

s.ask("open", file="facts/figures/fig13.pl")
GOAL = "hides(S1, S2), S1 \\== S2"
head, _ = s.ask("ask", goal=GOAL, view=[20, 60])
check("what hides what", head.get("names") == ["S1", "S2"] and
      head["answers"] == [[1, 2], [2, 1]], head)
drawn, octets = s.ask("view", view=[20, 60], format="strokes")
hidden = {"s%de%d" % (segment, edge) for look, segment, _, _, edges, _ in
          strokes(drawn, octets) if look[0] == "hidden" for edge in edges}
lit = [set(names) for names in head["shows"]]
check("lit are its hidden lines", lit[0] and lit[1] and
      lit[0] | lit[1] <= hidden and
      all(name.startswith("s2e") for name in lit[0]) and
      all(name.startswith("s1e") for name in lit[1]), (lit, hidden))
both, _ = s.ask("ask", goal="hides(S1, S2)", view=[20, 60])
check("all that is hidden is hidden by something",
      {n for names in both["shows"] for n in names} == hidden, both)
head, _ = s.ask("ask", goal="aggregate_all(count, drawn(_,_,_,_,_,_,_), N)",
                view="front")
check("of the picture that is asked of", head["answers"][0][0] > 5, head)
head, _ = s.ask("ask", goal="hidden_by(2, E, 1, T, F, To)", view=[20, 60])
check("names of predicates", head["shows"] and
      head["shows"][0][0].startswith("s2e"), head)
check("nothing is left of it", s.ask(
    "ask", goal="drawn(_,_,_,_,_,_,_)", view=[20, 60])[0]["answers"] and
    s.ask("ask", goal="v(S, V, X, Y, Z), V < 3")[0]["answers"])
refused("no picture of that view", "request_error.bad_key", "isometric", "ask",
        goal=GOAL, view="nowhere")

# ---- cut open, taken apart, on a sheet, shaded ----

s.ask("open", file="facts/figures/fig13.pl")
eye = {"format": "strokes", "view": [20, 60], "size": [120, 90],
       "hidden": "removed", "margin": 9}
whole = s.ask("view", **eye)
past, octets = s.ask("view", section="z=9", **eye)
check("a plane above all cuts nothing off", strokes(past, octets) ==
      strokes(*whole) and past["place"] == whole[0]["place"], past)
past, octets = s.ask("view", section="z=-9", **eye)
check("a plane below all leaves nothing", past["strokes"] == 0 and
      past["place"] == whole[0]["place"], past)
places = set()
for at in (-0.5, 0.25, 0.5):
    head, octets = s.ask("view", section="y=%s" % at, **eye)
    got = strokes(head, octets)
    places.add(tuple(head["place"]))
    check("a section at y = %s" % at, head["section"] == {
        "axis": "y", "at": at, "low": -1.0, "high": 1.0} and
        {"section", "hatching"} <= {look[1] for look, *_ in got} and
        {segment for _, segment, *_ in got} == {1, 2}, head)
check("pulled, it stays where it is", places == {tuple(whole[0]["place"])},
      places)
front = dict(eye, view="front", hidden="shown")
head, octets = s.ask("view", section="y=0.25", **front)
drawn = json.loads(alone("draw", "facts/figures/fig13.pl", "--section",
                         "y=0.25", "--views", "top", "--hidden", "shown", "-o",
                         "-", "--format", "json")[1])


def shape(lines):
    """How many edges have each role: what is drawn, not where."""
    return Counter(role for role, edges in lines for _ in edges)


wanted = shape((line["role"], line["edges"]) for line in drawn["lines"]
               if line.get("view") == "A")
check("the lines of the section of a sheet",
      shape((look[1], edges) for look, _, _, _, edges, _ in
            strokes(head, octets)) == wanted and wanted, wanted)
check("the document is as it was", s.ask("view", **eye)[1] == whole[1])


def section_names(file, at, up="z"):
    """How many lines of a section at x = AT have the name of an edge, or of a
    face, and how many have none; and those that are not where their name is."""
    s.ask("open", file=file)
    head, octets = s.ask("view", section="x=%s" % at, up=up, **eye)
    t, p = (math.radians(angle) for angle in eye["view"])
    scale, x, y, left, top = head["place"]
    counts, wrong = [0, 0, 0], []
    for look, segment, _, _, edges, points in strokes(head, octets):
        letter = "p" if look[1] == "section" else "e"
        for k, edge in enumerate(edges):
            if edge == 0:
                counts[2] += 1
                continue
            counts[letter == "p"] += 1
            told = s.ask("select", names=["s%d%s%d" % (segment, letter, edge)],
                         keep=False)[0]
            ends = told["ends"]
            there = [v for name in ends for v in ends[name]
                     if letter == "p" or name == told["selected"][0]["name"]]
            if up == "y":
                there = [(a, -c, b) for a, b, c in there]
            drawn = [(left + (b * math.cos(t) - a * math.sin(t) - x) * scale,
                      top - (c * math.sin(p) - y - math.cos(p) * (
                          a * math.cos(t) + b * math.sin(t))) * scale)
                     for a, b, c in there]
            seen = [points[k], points[(k + 1) % len(points)]]
            if letter == "e":
                (ax, ay), (bx, by) = drawn
                far = max(abs((bx - ax) * (py - ay) - (by - ay) * (px - ax)) /
                          max(1, ((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5)
                          for px, py in seen)
            else:           # the plane cuts the face there, which is flat
                far = max(max(min(us) - p[i], p[i] - max(us))
                          for i in (0, 1) for us in [[d[i] for d in drawn]]
                          for p in seen)
                if not min(v[0] for v in there) <= at <= max(
                        v[0] for v in there):
                    far = 1e9
            if far > 1.5:
                wrong.append((look, segment, edge, far))
    return counts, wrong


for file, at, up, edges, faces, none in (
        ("facts/two_cubes.pl", 0.5, "z", 8, 8, 0),
        ("facts/two_cubes.pl", 0.5, "y", 8, 8, 0),
        ("facts/figures/fig13.pl", 0.3, "z", 12, 40, 0),
        ("facts/pipe_tee.pl", 0.2, "y", 100, 60, 0),
        ("facts/two_rooms.pl", 5.5, "z", 4, 4, 0)):
    (edged, faced, bare), wrong = section_names(file, at, up)
    check("lines of a section are named: %s, %s up" % (file, up), not wrong and
          edged >= edges and faced >= faces and bare <= none,
          (edged, faced, bare, wrong[:5]))
s.ask("open", file="facts/figures/fig13.pl")
refused("no plane", "request_error.bad_key", "a plane", "view",
        section="q", **eye)
refused("a plane of text", "request_error.bad_key", "a plane", "view",
        section=5, **eye)
refused("a section as strokes alone", "request_error.bad_key", "strokes",
        "view", section="y", format="svg")
refused("one of two", "request_error.bad_key", "not both", "view",
        section="y", explode=1, format="strokes")
refused("how far apart", "request_error.bad_key", "from 0 to 100", "view",
        explode=-1, format="strokes")

for options in ([], ["--sheet", "A4", "--views", "front,iso", "--section",
                     "y", "--shade", "hatch"]):
    head, octets = s.ask("sheet", options=options)
    drawn = json.loads(alone("draw", "facts/figures/fig13.pl",
                             *(options or ["--sheet", "A3"]), "-o", "-",
                             "--format", "json")[1])
    check("a sheet %s" % options,
          sorted(points for _, _, _, _, _, points in strokes(head, octets)) ==
          sorted(tuple(tuple(round(c * 1000) for c in p)
                       for p in line["points"]) for line in drawn["lines"]) and
          len(head["texts"]) == len(drawn["texts"]), head)
    pens, octets = s.ask("sheet", options=options, pens=True)
    plotted = alone("draw", "facts/figures/fig13.pl",
                    *(options or ["--sheet", "A3"]), "-o", "-",
                    "--format", "hpgl")[1].decode()
    got = strokes(pens, octets)
    high = pens["sheet"][1]
    path, down = [], None
    for word in plotted.replace("\n", "").split(";"):
        numbers = [int(n) for n in word[2:].split(",")] \
            if word[:2] in ("PU", "PD") and word[2:] else []
        if word[:2] == "PD":
            path += [down] + list(zip(numbers[::2], numbers[1::2]))
        if numbers:
            down = tuple(numbers[-2:])
    # HPGL leaves out what is shorter than its unit, and points that are one.
    ours, lines = [], 0
    for _, _, _, _, _, points in got:
        at = [((2 * x + 25) // 50, (2 * (high - y) + 25) // 50)
              for x, y in points]
        moved = at[:1] + [b for a, b in zip(at, at[1:]) if a != b]
        if len(moved) > 1:
            ours += moved
            lines += 1
        elif len(set(points)) == 1:
            ours += moved + moved
            lines += 1
    check("the way of the pens %s" % options, ours == path and
          sum(pen["strokes"] for pen in pens["pens"]) == len(got) and
          0 < lines == plotted.count("PD"), (ours[:9], path[:9]))
refused("no paper", "usage_error.sheet", "B9", "sheet",
        options=["--sheet", "B9"])
refused("no file", "usage_error.no_files_taken", "x.pl", "sheet",
        options=["x.pl"])
refused("pens", "request_error.bad_key", "true or false", "sheet", pens=1)
for options in (["--size", "200x150"],
                ["--size", "200x150", "--view", "20,60", "--section", "y=0.25",
                 "--shade", "gooch", "--colours", "leaf"]):
    head, octets = s.ask("shaded", options=options)
    check("shaded %s" % options, octets == alone(
        "render", "facts/figures/fig13.pl", *options, "-o", "-", "--format",
        "png")[1] and octets[:4] == b"\x89PNG" and head["ms"] > 0, head)
refused("no size", "usage_error.bad_value", "--size", "shaded",
        options=["--size", "0x1"])
refused("no file", "usage_error.no_files_taken", "x.pl", "shaded",
        options=["x.pl"])
check("the document is as it was", s.ask("view", **eye)[1] == whole[1])

glued = work + "/glued.pl"
with open(glued, "wb") as f:
    f.write(alone("glue", "facts/two_cubes.pl", "-o", "-", "--format", "pl")
            [1])
s.ask("open", file=glued)
head, octets = s.ask("view", explode=0, format="strokes", view="iso")
still = strokes(head, octets)
head, octets = s.ask("view", explode=1, format="strokes", view="iso",
                     scale=20)
cells = {n for n, _ in head["parts"]}
check("cells apart", len(cells) > 1 and
      len({o for _, o in head["parts"]}) == 1 and {segment for _, segment, *_ in strokes(head, octets)} <= cells and
      len(strokes(head, octets)) > len(still) / 2, head)
drawn = json.loads(alone("draw", glued, "--explode", "1", "--view", "iso",
                         "-o", "-", "--format", "json")[1])
check("as draw --explode", len(drawn["lines"]) == len(strokes(head, octets)),
      len(drawn["lines"]))

# ---- select ----

s.ask("open", file="facts/two_cubes.pl")
head, octets = s.ask("view", format="strokes")
edge = next(e for _, _, _, _, edges, _ in strokes(head, octets)
            for e in edges)
head, _ = s.ask("select", names=["s1e%d" % edge, "s1", "s2p1", "s2v3", "l1"])
kinds = [item["kind"] for item in head["selected"]]
check("select", kinds == ["edge", "segment", "polygon", "vertex", "line"] and
      head["gone"] == [], head)
for item in head["selected"]:
    answers, _ = s.ask("ask", goal=item["goal"])
    check("its goal: " + item["goal"], len(answers["answers"]) > 0, answers)
    if item["kind"] != "segment":
        other, _ = s.ask("select", names=item["shows"])
        check("what it shows is there", code(other) == "" and
              item["shows"] != [], other)
    for why in item["explain"]:
        told, octets = s.ask("explain", item=why)
        check("explained: " + why, told["status"] in (0, 1) and octets != b"",
              told)
s.ask("select", names=["s1", "s2v3"])
head, _ = s.ask("select")
check("kept", [i["name"] for i in head["selected"]] == ["s1", "s2v3"], head)
head, _ = s.ask("select", names=["l1"], keep=False)
check("told", [i["name"] for i in head["selected"]] == ["l1"], head)
head, _ = s.ask("select")
check("and not kept", [i["name"] for i in head["selected"]] == ["s1", "s2v3"],
      head)
s.ask("select", names=["l1"], keep=True)
head, _ = s.ask("select")
check("the last", [i["name"] for i in head["selected"]] == ["l1"], head)
tee = session()
tee.ask("open", file="facts/pipe_tee.pl")
head, octets = tee.ask("view", format="strokes")
drawn = {"s%de%d" % (of, e) for _, of, _, _, edges, _ in strokes(head, octets)
         for e in edges if e > 0}
lit = {}
check("a face that an operand made is explained", [
    one["explain"] for one in tee.ask("select", names=["s10p5"])[0]["selected"]
    ] == [["piece(10,5)"]])
for name in ("s2", "s9", "s17", "s8", "s10"):
    head, _ = tee.ask("select", names=[name])
    lit[name] = set(head["selected"][0]["shows"]) & drawn
    check("ends are of what has no line", head["ends"] == {}, head["ends"])
    again, _ = tee.ask("select")
    check("kept: " + name, again["gone"] == [] and again["selected"] ==
          head["selected"], again)
bore = {"s10e" + line.strip() for line in alone(    # it may take more than 5 s
    "query", "facts/pipe_tee.pl", "operand_edge(10, E, 2)")[1].decode().split(
        "\n")}
check("an operand shows what it made", lit["s2"] == lit["s9"] and
      len(lit["s2"]) > 100 and bore & drawn == lit["s2"],
      (len(bore & drawn), len(lit["s2"])))
check("another one shows other edges", lit["s17"] < lit["s8"] and
      len(lit["s17"] & lit["s2"]) < len(lit["s17"]) / 2 and
      lit["s8"] | lit["s2"] >= {d for d in drawn})
check("a root is drawn itself", lit["s10"] == set())
tee.end()
for names in ("s1", [1], ["x"], ["s0"], ["s1e"], ["s1q1"], ["s01"], [["s1"]],
              ["s1e99999999999"]):
    refused("names %s" % names, "request_error.bad_key", "list of names",
            "select", names=names)
refused("nothing called so", "request_error.no_name", "s9e1", "select",
        names=["s9e1"])
for language, said in (("en", "there is no predicate segmnt/3"),
                       ("ko", "segmnt/3: 없는 술어입니다")):
    head, _ = s.ask("ask", goal="segmnt(S, K, N)")
    check("no such predicate, " + language,
          head["error"]["words"][language].startswith(said) and
          "segment/3" in head["error"]["words"][language], head)

# ---- patterns ----

head, halves, octets = s.laid("unfold", segment=1)
got = strokes(head, octets)
check("unfold", head["sheets"] == 1 and len(got) == head["strokes"] > 0 and
      [[p["of"], p["segment"], p["edges"]] for p in head["patterns"]] ==
      [["development(1)", 1, True]], head)
wanted = json.loads(alone("unfold", "facts/two_cubes.pl", "--only", "1", "-o",
                          "-", "--format", "json")[1])
check("as the verb", [points for _, _, _, _, _, points in got] ==
      [tuple(tuple(round(c * 1000) for c in p) for p in line["points"])
       for line in wanted["lines"]], wanted["lines"][:2])
head, again, octets = s.laid("fold", segment=1)
check("fold", again == halves and octets == alone("unfold", "facts/two_cubes.pl", "--only", "1",
                              "-o", "-", "--format", "fold")[1] and
      b"file_spec" in octets, octets[:300])
refused("no sheet", "request_error.bad_key", "from 1 to 1", "unfold", sheet=2)
refused("segment of a pattern", "request_error.bad_key", "number", "unfold",
        segment="1")
refused("no segment", "usage_error.unfold", "9", "unfold", segment=9)
refused("no option", "usage_error.unknown_option", "--nothing", "unfold",
        options=["--nothing"])
refused("no file", "usage_error.no_files_taken", "x.pl", "fold",
        options=["x.pl"])
refused("options", "request_error.bad_key", "options", "fold", options=[1])

# ---- wishes ----

model = work + "/m.pl"
TEXT = """% Two parts: 상관.
segment(1, solid, box(size(3, 4, 5))). % no end of line"""
with open(model, "w", encoding="utf-8") as f:
    f.write(TEXT)
s.ask("open", file=model, journal=True)
head, _ = s.ask("ask", goal="e(1, E, V1, V2, _)")
ends = {e: (a, b) for e, a, b in head["answers"]}
pairs = {e: min(f for f, back in ends.items() if back == (b, a))
         for e, (a, b) in ends.items()}
check("halves", s.laid("unfold")[1] ==
      {2: {e: f for e, f in pairs.items() if f < e}} and len(ends) == 24, ends)
wide = model.replace(".pl", "-wide.pl")
with open(wide, "w") as f:
    f.write("segment(1, solid, cylinder(radius(1), height(2), facets(80))).\n")
s.ask("open", file=wide)
head, _ = s.ask("ask", goal="aggregate_all(sum(E * 1000 + F), ( "
                "e(1, E, A, B, _), e(1, F, B, A, _), F < E ), N)")
halves = list(s.laid("unfold")[1].values())[0]
check("halves beyond an octet", max(halves) > 256 and head["answers"] == [
    [sum(e * 1000 + f for e, f in halves.items())]], head)
s.ask("open", file=model, journal=True)
head, _ = s.ask("cut", segment=1, edge=1)
check("cut", head["wish"] == "unfolding(1, cut(1))", head)
check("it stands in the text", s.ask("text")[1].decode() ==
      TEXT + "\nunfolding(1, cut(1)).\n")
head, _ = s.ask("cut", segment=1, edge="base-side(2)", keep=True)
check("by its name", head["wish"] == "unfolding(1, keep(base-side(2)))", head)
text = s.ask("text")[1].decode()
head, _, octets = s.laid("unfold")
check("as the verb", [points for _, _, _, _, _, points in
                      strokes(head, octets)] ==
      [tuple(tuple(round(c * 1000) for c in p) for p in line["points"])
       for line in json.loads(alone("unfold", "-", "-o", "-", "--format",
                                    "json", body=text.encode())[1])["lines"]])
head, _ = s.ask("cut", segment=1, edge=1, keep=True)
check("the other way", "keep(1)" in s.ask("text")[1].decode() and
      "cut(1)" not in s.ask("text")[1].decode(), head)
head, _ = s.ask("cut", segment=1, edge=1, keep=None)
check("no wish", s.ask("text")[1].decode() ==
      TEXT + "\nunfolding(1, keep(base-side(2))).\n", s.ask("text")[1])
for i in range(2):
    s.ask("undo")
check("undone", s.ask("text")[1].decode() == text)
other = 0
for i in range(1, 13):
    head, _ = s.ask("cut", segment=1, edge=i)
    if code(head) == "":
        other += s.laid("unfold")[2] != octets
        s.ask("undo")
check("patterns have it", other > 0, other)
check("as it was", s.ask("text")[1].decode() == text)
refused("no such edge", "model_error.unfold", "99", "cut", segment=1, edge=99)
refused("no such segment", "request_error.bad_key", "no segment 5", "cut",
        segment=5, edge=1)
refused("no edge", "request_error.bad_key", '"edge"', "cut", segment=1)
refused("keep", "request_error.bad_key", '"keep"', "cut", segment=1, edge=1,
        keep="x")
refused("no name", "request_error.edit", "no name of an edge", "cut",
        segment=1, edge="(")
refused("none to take away", "request_error.edit", "does not say", "cut",
        segment=1, edge=3, keep=None)
s.kill()
s = session()
head, _ = s.ask("open", file=model, journal=True)
check("replayed", head["replayed"] > 20 and
      s.ask("text")[1].decode() == text, head)

# ---- questions are kept with the model ----

before = s.ask("text")[1].decode()
GOAL = "hides(S1, S2), S1 \\== S2"
head, _ = s.ask("question", name=" what  hides ", goal=GOAL)
check("a question", head["question"] ==
      "question('what hides', 'hides(S1, S2), S1 \\\\== S2')", head)
s.ask("question", name="몇 줄", goal="line(L, _, _, _, _, _, _, _, _)")
check("in the text", s.ask("text")[1].decode() == before +
      head["question"] + ".\nquestion('몇 줄', "
      "'line(L, _, _, _, _, _, _, _, _)').\n", s.ask("text")[1])
head, _ = s.ask("tree")
check("listed", head["questions"] == [
    {"name": "what hides", "goal": GOAL},
    {"name": "몇 줄", "goal": "line(L, _, _, _, _, _, _, _, _)"}], head)
head, _ = s.ask("ask", goal="question('what hides', G)")
check("the model has it", head["answers"] == [[GOAL]], head)
s.ask("question", name="what hides", goal="v(1, V, X, Y, Z)")
check("another goal, in its place", s.ask("tree")[0]["questions"][0] ==
      {"name": "what hides", "goal": "v(1, V, X, Y, Z)"})
s.ask("undo")
check("undone", s.ask("tree")[0]["questions"][0]["goal"] == GOAL)
s.kill()
s = session()
s.ask("open", file=model, journal=True)
check("not lost", len(s.ask("tree")[0]["questions"]) == 2)
s.ask("question", name="what hides", goal=None)
head, _ = s.ask("question", name="몇 줄", goal=None)
check("taken away", head["question"] == "" and
      s.ask("text")[1].decode() == before, s.ask("text")[1])
refused("no such question", "request_error.edit", "no question x", "question",
        name="x", goal=None)
refused("no goal", "usage_error.bad_goal", "line(L", "question", name="x",
        goal="line(L")
refused("no text of a goal", "request_error.bad_key", '"goal"', "question",
        name="x")
refused("no name", "request_error.bad_key", '"name"', "question", name=" ",
        goal="true")

# ---- a model that is turned takes no more room ----

turned = session()
turned.ask("open", file="facts/pipe_tee.pl")


def room():
    """MB of the session's own."""
    with open("/proc/%d/status" % turned.process.pid) as f:
        return next(int(line.split()[1]) for line in f
                    if line.startswith("RssAnon")) / 1024


rooms = []
for i in range(240):
    if i in (40, 239):
        rooms.append(room())
    head, _ = turned.ask("view", format="strokes", size=[160, 120],
                         view=[7.3 * i % 360, 30 + 3.1 * i % 60])
check("views leave nothing behind", "error" not in head and
      rooms[1] < rooms[0] + 25, rooms)
turned.kill()

# ---- rules are tried ----

RULES = b"""% Creases of the second cube are no lines.
edge_role(2, E, Look, Crease, Role) :-
    default(edge_role(2, E, Look, Crease, Role0)),
    (   Role0 == crease
    ->  Role = smooth
    ;   Role = Role0
    ).
edge_role(1, E, Look, Crease, Role) :-
    default(edge_role(1, E, Look, Crease, Role0)),
    (   Role0 == crease
    ->  Role = border
    ;   Role = Role0
    ).
"""
s.ask("open", file="facts/two_cubes.pl", journal=True)
plain = s.ask("view", format="json")[1]
begun = rev()
head, octets = s.ask("rules")
check("decisions", octets == b"" and head["tried"] is False and
      len(head["decisions"]) > 10 and
      all(d["by"] == "default" and d["words"]["en"] != d["words"]["ko"]
          for d in head["decisions"]), head)
missing = alone("query", "facts/cube.pl",
                "sg_decision:decision(D, _, _, _), \\+ sg_decision_ko:ko(D, _)")
check("each decision has its Korean", missing[0] == 1 and missing[1] == b"",
      missing)
refused("not the owner", "request_error.owner_alone", "owner", "rules", RULES)
refused("nothing to keep", "request_error.nothing_tried", "Try", "rules",
        keep=True, owner=True)
refused("nothing to discard", "request_error.nothing_tried", "Try", "rules",
        keep=False)
refused("keep what", "request_error.bad_key", "true or false", "rules",
        keep=1)
refused("no rules", "model_error.rules", "", "rules", b"a :- .", owner=True)
refused("no decision", "model_error.rules", "edge_rule", "rules",
        b"edge_rule(1, 2).", owner=True)
refused("no text", "frame_error.not_utf8", "UTF-8", "rules", b"\xff",
        owner=True)
check("still as it was", s.ask("view", format="json")[1] == plain)
with open(work + "/r.pl", "wb") as f:
    f.write(RULES)


def names(drawing):
    return {(n["segment"], e) for n in json.loads(drawing)["lines"]
            for e in n["edges"]}


head, _ = s.ask("rules", RULES, owner=True)
wanted = alone("draw", "facts/two_cubes.pl", "--rules", work + "/r.pl", "-o",
               "-", "--format", "json")[1]
check("tried", head["tried"] is True and head["rev"] == begun + 1, head)
check("went", set(head["went"]) == {"s%de%d" % n for n in
                                    names(plain) - names(wanted)} and
      len(head["went"]) == head["count"]["went"] > 0 and
      all(n.startswith("s2") for n in head["went"]), head)
check("came", head["came"] == [] == list(names(wanted) - names(plain)), head)
check("changed", len(head["changed"]) == head["count"]["changed"] > 0 and
      all(n.startswith("s1") for n in head["changed"]), head)
check("the picture follows them", s.ask("view", format="json")[1] == wanted)
check("the picture of before", s.ask("view", format="json", before=True)[1]
      == plain)
head, octets = s.ask("rules")
check("told", octets == RULES and head["tried"] is True and
      "rules" in [d["by"] for d in head["decisions"]], head)
head, octets = s.ask("explain", item="line(1)")
check("explained by them", head["status"] == 0, head)
head, _ = s.ask("rules", keep=False)
check("discarded", head["tried"] is False and
      s.ask("view", format="json")[1] == plain, head)
s.ask("rules", RULES, owner=True)
head, _ = s.ask("rules", keep=True, owner=True)
check("kept", code(head) == "" and
      s.ask("view", format="json")[1] == wanted, head)
check("no trial any more", s.ask("rules")[0]["tried"] is False)
check("export follows them", s.ask("export", argv=[
    "draw", "-o", "-", "--format", "json"])[1].startswith(wanted[:200]))
s.ask("undo")
check("undo", s.ask("view", format="json")[1] == plain)
s.ask("redo")
check("redo", s.ask("view", format="json")[1] == wanted)
s.kill()
s = session()
refused("a journal with rules", "request_error.owner_alone", "owner", "open",
        file="facts/two_cubes.pl", journal=True)
head, _ = s.ask("open", file="facts/two_cubes.pl", journal=True, owner=True)
check("replayed", head["replayed"] == 3 and
      s.ask("view", format="json")[1] == wanted, head)
head, _ = s.ask("rules", owner=True, **{"try": True})
check("none are tried", head["count"]["came"] > 0 and
      s.ask("view", format="json")[1] == plain, head)
s.ask("rules", keep=True, owner=True)
check("none", s.ask("rules")[1] == b"" and
      s.ask("view", format="json")[1] == plain)
s.ask("undo")
s.ask("save", file=work + "/two.pl")
s.kill()
s = session()
head, _ = s.ask("open", file=work + "/two.pl", journal=True, owner=True)
check("rules survive a save", s.ask("view", format="json")[1] == wanted, head)

# ---- progress ----

began = time.time()
s.send({"id": "slow", "do": "ask", "goal": "sleep(0.9)", "owner": True,
        "progress": True})
frames = []
while not frames or "progress" in frames[-1]:
    frames.append(s.reply()[0])
check("progress", 2 <= len(frames) - 1 <= 5 and
      all(f["id"] == "slow" and f["progress"]["seconds"] >= 0.19
          for f in frames[:-1]), frames)
s.send({"id": 1, "do": "ask", "goal": "sleep(0.5)", "owner": True})
check("only if it is wanted", "progress" not in s.reply()[0])

# ---- states: pictures and answers in any order are what they are alone ----

s.ask("open", file="facts/pipe_tee.pl")
first = s.ask("view", format="json")[1]
lines = s.ask("ask", goal="aggregate_all(count, v(_,_,_,_,_), N)")[0]["answers"]
for i in range(3):
    check("the same answer", s.ask(
        "ask", goal="aggregate_all(count, v(_,_,_,_,_), N)")[0]["answers"] ==
        lines)
    s.ask("ask", goal="retract_fact(segment(10, _, _), [cascade(true)])",
          owner=True)
    s.ask("unfold", segment=10)
    check("the same picture", s.ask("view", format="json")[1] == first)
s.send({"id": 1, "do": "open", "file": "facts/pipe_tee.pl"})
for i in range(8):
    s.send({"id": 2, "do": "view", "format": "json"})
    time.sleep(0.01 * i)
    s.send({"id": 3, "do": "stop"})
replies = [s.reply()[0] for i in range(17)]
check("after stops", s.ask("view", format="json")[1] == first, replies)
check("end", s.end() == (0, b""))

# ---- the same file once more, when a picture was made ----

s = session()
for file in ("facts/cube.pl", "facts/two_cubes.pl"):
    s.ask("open", file=file)
    first = s.ask("view", format="json")[1]
    s.ask("sheet")
    head, _ = s.ask("open", file=file)
    check("once more: " + file, code(head) == "" and
          s.ask("view", format="json")[1] == first, head)
    check("no mark: " + file,
          s.ask("ask", goal="param(N, V)")[0]["answers"] == [])
check("end", s.end() == (0, b""))

# ---- seconds of the processor ----

s = session()
head, _ = s.ask("hello", cpu_s=1)
check("a limit", code(head) == "", head)
refused("no limit", "request_error.bad_key", "cpu_s", "hello", cpu_s=0)
s.ask("open", file="facts/cube.pl")
for _ in range(3):
    head, _ = s.ask("ask", goal="between(1, 800000, X), X < 0")
    check("each request has it anew", head and "answers" in head, head)
head, _ = s.ask("run", argv=["query", "facts/cube.pl",
                             "between(1, inf, X), X < 0"])
check("more of it ends the session", code(head) == "interrupted" and
      s.reply() == (None, None) and s.process.wait() == 152, head)
checks.finish()
