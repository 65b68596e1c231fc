"""browser_test.py PROGRAM FOLDER: the page of the studio in a real Chromium, in
English and in Korean: what people do, and what they see then."""
import json
import os
import re
import socket
import struct
import subprocess
import sys
import threading
import time

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)),
                os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../cli")]
from browser import Browser  # noqa: E402
from front import Front  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
checks = Checks()
check = checks.check
MODEL = open("facts/figures/fig13.pl").read()
CONTROL, ENTER, ESCAPE, LEFT = "\ue009", "\ue007", "\ue00c", "\ue012"
DOWN, UP, RIGHT = "\ue015", "\ue013", "\ue014"

# The lines that a port shows, as one text.
LINES = ("[...document.querySelectorAll('.port')[%d].querySelectorAll('.lines "
         "path')].map(p => p.getAttribute('d')).join('|')")
LAYER = "document.querySelectorAll('.port')[%d].querySelector('.%s')" \
        ".getAttribute('d')"
# Where a point of the line NAME is on the screen, in port 0.
POINT = """
  const picture = studio.ports.ports[0].picture;
  const [, s, e] = /s(\\d+)e(\\d+)/.exec(arguments[0]);
  for (const stroke of picture.shown.strokes) {
    const at = stroke.edges.indexOf(Number(e));
    if (stroke.segment === Number(s) && at >= 0) {
      const p = stroke.points, i = 2 * at;
      const {x, y} = new DOMPoint((p[i] + p[i + 2]) / 2, (p[i + 1] + p[i + 3]) / 2)
        .matrixTransform(picture.svg.getScreenCTM());
      return [x, y];
    }
  }"""


def cli(*arguments):
    return subprocess.run([program, *arguments], cwd=models, env=env,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          check=False).stdout


# Each corner of each face, folded up as far as it goes, and where the file of the
# pattern says it is in the model: how far they are apart at most.
FOLDED = """
  const folding = studio.ports.ports[0].folding;
  const apart = (faces, there) => Math.max(...faces.flatMap((face, f) => face.map((p, i) =>
    Math.hypot(...p.map((n, k) => n - there(folding.faces[f][i])[k])))));
  return [apart(folding.corners(1), (v) => folding.space[v]), apart(folding.corners(0), (v) => folding.flat[v]),
    apart(folding.corners(0.5), (v) => folding.space[v])];"""


def shown(port=0):
    return browser.wait(
        "!studio.ports.ports[%d].busy && !studio.ports.ports[%d].canvas"
        ".classList.contains('empty')" % (port, port))


def turned_to(kind):
    browser.script("studio.ports.ports[0].turnTo(arguments[0])", kind)
    check("%s is shown" % kind, shown(), browser.log())


def kinds(language):
    """Sections, shaded pictures, sheets and pens, patterns that are folded up:
    by the controls of the port."""
    said = {"en": "pens, ", "ko": "펜 "}[language]
    slider = "document.querySelectorAll('.port')[0].querySelector" \
             "('.tools input[type=range]')"
    pull = "const s = %s; s.value = arguments[0]; s.dispatchEvent(new " \
           "Event('input'))" % slider

    # A plane is pulled through the model; names stay those of the model.
    turned_to("section")
    check(language + ": from end to end", browser.script(
        "const s = %s; return [s.min, s.max, Number(s.value)]" % slider)
        == ["-1", "1", 0])
    browser.script(pull, 0.25)
    check(language + ": the plane is pulled", browser.wait(
        "studio.ports.ports[0].remark.textContent === 'y = 0.25'"))
    angles = browser.script("return studio.ports.ports[0].angles")
    head = front_page.ask("view", format="strokes", view=angles,
                          section="y=0.25", size=[100, 80],
                          hidden="removed")[0]
    roles = browser.script("return studio.ports.ports[0].picture.shown.looks."
                           "map(([, role]) => role)")
    check(language + ": cut faces are hatched", "hatching" in roles and
          "section" in roles and sorted(roles) ==
          sorted(role for _, role in head["looks"]), roles)

    # The shaded picture is what render makes; a click says why.
    turned_to("shaded")
    check(language + ": a shaded picture", browser.wait(
        "studio.ports.ports[0].picture.image.getAttribute('width') > 100 && "
        "studio.ports.ports[0].picture.image.hasAttribute('href')"))
    browser.script("studio.ports.ports[0].canvas.focus()")
    box = browser.script("const r = document.querySelector('.canvas')."
                         "getBoundingClientRect(); return [r.x, r.y, r.width, "
                         "r.height]")
    browser.pointer((box[0] + box[2] / 2, box[1] + box[3] / 2), "down", "up")
    check(language + ": why a dot has its colour", browser.wait(
        "/^pixel\\(/.test(document.querySelector('.chip strong').textContent)"
        " && document.querySelector('.why pre:not(.bad)')"))
    words = browser.script("return studio.ports.ports[0].words")
    item = browser.script("return document.querySelector('.chip strong')"
                          ".textContent")
    check(language + ": as explain says", browser.script(
        "return document.querySelector('.why pre').textContent").split() ==
        cli("explain", "tee.pl", item, *words, "--lang",
            language).decode().split(), (item, words))

    # A sheet, and the way of the pens.
    turned_to("sheet")
    head, _ = front_page.ask("sheet", options=["--sheet", "A3", "--language",
                                               language])
    check(language + ": a sheet", browser.wait(
        "studio.ports.ports[0].picture.shown.strokes.length === arguments[0]",
        head["strokes"]))
    browser.script("document.querySelectorAll('.port')[0].querySelector"
                   "('.tick input').click()")
    check(language + ": the way of the pens", browser.wait(
        "studio.ports.ports[0].remark.textContent.includes(arguments[0])",
        said))
    drawn = "document.querySelectorAll('.port')[0].querySelectorAll" \
            "('.lines .pen')"
    whole = browser.script("return [...%s].map(p => p.getAttribute('d')"
                           ".length)" % drawn)
    browser.script(pull, 0.5)
    half = browser.script("return [...%s].map(p => p.getAttribute('d')"
                          ".length)" % drawn)
    check(language + ": as far as the slider says", sum(whole) > sum(half) >
          sum(whole) / 4, (whole, half))

    sheet_of_the_menu(language)

    # The pattern of one segment, chosen by the keyboard.
    turned_to("unfold")
    of = "JSON.stringify([...new Set(studio.ports.ports[0].picture.shown" \
         ".strokes.map(s => s.segment))].filter(Boolean).sort())"
    check(language + ": patterns of all", browser.wait(of + " === '[1,2]'"))
    browser.script("document.querySelector('.port .tools select').focus()")
    for one in ("1", "2"):
        browser.keys("\ue015")
        check(language + ": the pattern of " + one, browser.wait(
            of + " === '[" + one + "]'") and browser.script(
                "return document.activeElement.value") == one)
    head, _ = front_page.ask("unfold", segment=2)
    check(language + ": as unfold of it", browser.script(
        "return studio.ports.ports[0].picture.shown.strokes.length")
        == head["strokes"])
    browser.script("studio.light('chosen', ['s2'])")
    check(language + ": a segment is lit without its folds", browser.script("""
      const { picture } = studio.ports.ports[0], { strokes, looks } = picture.shown;
      const own = strokes.filter((s) => s.segment === 2), folds = own.filter((s) => looks[s.look][1].startsWith("fold_"));
      const lit = picture.layers.chosen.getAttribute("d").split("M").length - 1;
      return folds.length > 0 && lit === own.length - folds.length;"""))
    turned_to("folded")
    browser.wait("studio.ports.ports[0].folding.faces")
    check(language + ": folded up, the same one", browser.script(
        "return document.querySelector('.port .tools select').value") == "2")
    browser.script("studio.ports.ports[0].set('segment', '')")

    # A pattern, folded up: at the end it is the model.
    turned_to("folded")
    browser.wait("studio.ports.ports[0].folding.faces")
    ends = browser.script(FOLDED)
    check(language + ": folded up it is the model", ends[0] < 1e-9 and
          ends[1] < 1e-9 and ends[2] > 0.1, ends)
    before = browser.script("return document.querySelector('.mine')"
                            ".innerHTML")
    browser.script(pull, 1)
    check(language + ": the slider folds", browser.script(
        "return document.querySelector('.mine').innerHTML") != before)
    check(language + ": both faces at a fold have one name for it",
          browser.script("""
      const { lines } = studio.ports.ports[0].folding, names = lines.filter(({ folds }) => folds).map(({ name }) => name);
      return names.length > 20 && names.every((name) => names.filter((one) => one === name).length === 2)
        && lines.some(({ name, segment, edge, folds }) => folds && name === `s${segment}e${edge}`);"""))
    browser.script("studio.light('lit', ['s1e50'])")
    check(language + ": lit in space too", browser.script(
        "return document.querySelector('.mine .lit').getAttribute('d')"))
    turned_to("apart")
    browser.script("studio.ports.enlarge(studio.ports.ports[0])")
    check(language + ": a port alone", browser.script(
        "return [...document.querySelectorAll('.port')].filter(p => "
        "getComputedStyle(p).display !== 'none').length") == 1)
    browser.script("studio.ports.enlarge(studio.ports.ports[0])")
    turned_to("iso")
    browser.script("studio.light('chosen', ['s1'])")
    check(language + ": a segment is lit where it is seen", browser.script("""
      const { picture } = studio.ports.ports[0], { strokes, looks } = picture.shown;
      const own = strokes.filter((s) => s.segment === 1), hidden = own.filter((s) => looks[s.look][0] === "hidden");
      const lit = picture.layers.chosen.getAttribute("d").split("M").length - 1;
      return hidden.length > 0 && lit === own.length - hidden.length;"""))
    browser.script("studio.light('chosen', [])")


# A seam of the pattern in port 1 that port 0 does not draw: its name, where it is on
# the screen, and how often it stands in the pattern.
SEAM = """
  const [space, flat] = studio.ports.ports.map(({ picture }) => picture);
  const of = (s) => [...s.edges].map((e) => `s${s.segment}e${e}`);
  const cuts = flat.shown.strokes.filter((s) => s.closed && flat.shown.looks[s.look][1] === "cut");
  const all = cuts.flatMap(of);
  for (const s of cuts) for (const [i, name] of of(s).entries()) {
    if (space.draws(name)) continue;
    const p = s.points, j = (2 * i + 2) % p.length;
    const {x, y} = new DOMPoint((p[2 * i] + p[j]) / 2, (p[2 * i + 1] + p[j + 1]) / 2)
      .matrixTransform(flat.svg.getScreenCTM());
    return [name, x, y, all.filter((one) => one === name).length];
  }"""
NUMBERS = "(%s || '').split(/[ML ]+/).filter(Boolean).map(Number)"


def seams(language):
    """What is pointed at in a pattern is seen in space, drawn there or not."""
    browser.wait("!studio.ports.ports[1].busy && studio.ports.ports[1].picture"
                 ".shown && !studio.ports.ports[0].busy")
    name, x, y, times = browser.script(SEAM)
    check(language + ": both sides of a seam have one name", times == 2, name)
    browser.pointer((x, y))
    check(language + ": both sides are lit", browser.wait(
        "(%s || '').split('M').length === 3" % (LAYER % (1, "hover"))))
    lit = browser.wait("%s.length === 4 && %s" % (
        (NUMBERS % (LAYER % (0, "hover")),) * 2))
    browser.pointer("down", "up")
    check(language + ": chosen, it stays lit in space", lit and browser.wait(
        "JSON.stringify(%s.slice(0, 4)) === arguments[0]" % (
            NUMBERS % (LAYER % (0, "chosen"))),
        json.dumps(lit, separators=(",", ":"))), lit)
    browser.script("studio.looks.lines = 'all'; studio.looked()")
    drawn = browser.wait("""studio.ports.ports[0].picture.draws(arguments[0]) &&
      [...studio.ports.ports[0].picture.shown.strokes.find((s) => s.edges.length === 1 &&
        `s${s.segment}e${s.edges[0]}` === arguments[0]).points]""", name)
    there = lit and drawn and min(
        max(abs(a - b) for a, b in zip(lit, ends))
        for ends in (drawn, drawn[2:] + drawn[:2]))
    check(language + ": where its line would be", there is not None and
          there <= 1, (lit, drawn))
    browser.script("delete studio.looks.lines; studio.looked()")

    # Within a piece: all of its joints.
    browser.wait("!studio.ports.ports[0].busy && !studio.ports.ports[0]"
                 ".picture.draws(arguments[0])", name)
    middle = browser.script("""
      const { picture } = studio.ports.ports[1];
      const { points } = picture.shown.strokes.find((s) => s.closed);
      const r = picture.svg.getBoundingClientRect();
      for (let x = r.x; x < r.right; x += 3) for (let y = r.y; y < r.bottom; y += 3) {
        if (!picture.near(x, y) && picture.pieceAt(x, y).length) return [x, y];
      }""")
    if middle:
        browser.pointer(middle)
    check(language + ": all joints of a piece", middle and browser.wait("""
      (() => {
        const [space, flat] = studio.ports.ports.map(({ picture }) => picture);
        const names = new Set(flat.pieceAt(...arguments[0]));
        return names.size > 20 && JSON.stringify([...names].sort()) === JSON.stringify([...flat.lit.hover].sort()) &&
          space.layers.hover.getAttribute("d").split("M").length > 20;
      })()""", middle), middle)
    # Another picture comes meanwhile.
    browser.script("studio.ports.ports[1].draw()")
    browser.wait("!studio.ports.ports[1].busy")
    browser.pointer((5, 5))
    check(language + ": pointed at no more", browser.wait(
        "!%s && !%s" % (LAYER % (0, "hover"), LAYER % (1, "hover"))))
    browser.script("studio.chosen([])")


def kept_questions(language):
    """The question in the box is kept with the model; it is asked again by its
    name, found by Ctrl-K, and taken away."""
    text = front_page.ask("text")[1].decode()
    browser.click(".ask [data-word=save_question]")
    browser.keys(ENTER)
    fact = "question(hides, 'hides(S1, S2), S1 \\\\== S2').\n"
    check(language + ": a question is kept", browser.wait(
        "document.querySelector('.saved button')") and
        front_page.ask("text")[1].decode() == text + fact,
        front_page.ask("text")[1])
    browser.script("studio.asking.clear(); studio.asking.set('')")
    browser.click(".saved button")
    check(language + ": and asked again", browser.wait(
        "studio.ports.ports[0].picture.lit.lit.size > 0 && "
        "document.getElementById('goal').value.startsWith('hides(')"))
    browser.script("studio.asking.clear(); studio.asking.set('')")
    browser.chord(CONTROL, "k")
    browser.wait("document.querySelector('dialog.find')")
    browser.keys("hides", ".find input")
    browser.wait("[...document.querySelectorAll('.find li')].some(li => "
                 "li.textContent.includes('S1'))")
    browser.keys(ENTER)
    check(language + ": and found", browser.wait(
        "studio.ports.ports[0].picture.lit.lit.size > 0"))
    browser.click(".saved button:nth-child(2)")
    check(language + ": and taken away", browser.wait(
        "document.querySelector('.saved').hidden") and
        front_page.ask("text")[1].decode() == text,
        front_page.ask("text")[1])


# What a port asked for, and what it shows: strokes as lists.
ASKED = """
  const port = studio.ports.ports[0];
  const { strokes, looks, place } = port.picture.shown;
  return { view: port.angles, place, strokes: strokes.map(({ look, segment, edges, points }) =>
    [...looks[look], segment, [...edges], [...points]]) };"""


def as_drawn(language, what):
    """The picture of port 0 has the lines of `draw`, one by one, and where they
    are, but for the scale and the place of the sheet, within its rounding."""
    shown = browser.script(ASKED)
    drawn = json.loads(cli("draw", "tee.pl", "--format", "json", "-o", "-",
                           "--view", "%r,%r" % tuple(shown["view"])))
    lines = [[line["visibility"], line["role"], line["segment"],
              line["edges"]] for line in drawn["lines"]]
    check("%s: %s: the lines of draw" % (language, what), lines and
          sorted(lines) == sorted(one[:4] for one in shown["strokes"]),
          (len(lines), len(shown["strokes"])))
    by_name = {json.dumps(name): [n for point in line["points"] for n in point]
               for name, line in zip(lines, drawn["lines"])}
    pairs = [(a, b) for one in shown["strokes"] if json.dumps(one[:4]) in by_name
             for a, b in zip(one[4], by_name[json.dumps(one[:4])])]
    factor = shown["place"][0] / drawn["scale"]
    off = [[a - factor * b for a, b in pairs[axis::2]] for axis in (0, 1)]
    check("%s: %s: where draw has them" % (language, what), pairs and max(
        max(of_axis) - min(of_axis) for of_axis in off) < 1 + factor / 1000 + 0.01,
        [max(of_axis) - min(of_axis) for of_axis in off])


def sheet_of_the_menu(language):
    """What the menu Sheet says, the port shows and its export has."""
    browser.script("studio.ports.ports[0].canvas.focus()")
    rows = ["[aria-label] + * button"]
    for group, row in ((1, "A4-landscape"), (3, "y"), (4, "1:2"), (5, "cm"),
                       (2, None), (6, None)):
        browser.click("#menu_sheets")
        rows.append(browser.wait("""((group, row) => {
          const items = [...document.querySelectorAll("#menu_sheets + .menu:not([hidden]) > [role=group]")][group]
            ?.querySelectorAll("button");
          const item = items && (row ? [...items].find((e) => e.textContent === row) : items[items.length - 1]);
          item?.click();
          return item && item.textContent;
        })(arguments[0], arguments[1])""", group, row))
    check(language + ": the sheet that the menu says", browser.wait(
        "!studio.ports.ports[0].busy && studio.ports.ports[0].kind === 'sheet'"
        " && studio.ports.ports[0].picture.shown.sheet[0] === 297000"), rows)
    browser.script("""
      const { click } = HTMLAnchorElement.prototype;
      HTMLAnchorElement.prototype.click = function () {
        HTMLAnchorElement.prototype.click = click;
        fetch(this.href).then((answer) => answer.text()).then((text) => { window.fetched = text; });
      };
      window.fetched = null;
      studio.export("drawing", "svg");""")
    got = browser.wait("window.fetched")
    wanted = cli("draw", "-q", "tee.pl", "--sheet", "A4-landscape", "--views",
                 "front,top,right", "--section", "y", "--scale", "1:2",
                 "--unit", "cm", "--angle", "first", "--language", language,
                 "--format", "svg", "-o", "-").decode()
    check(language + ": its export has the bytes of draw", got == wanted and
          wanted, ((got or "")[:300], wanted[:300]))
    # The title block is of the text.
    browser.click("#menu_sheets")
    browser.wait("document.querySelector('#menu_sheets + .menu:not([hidden])')")
    browser.click("#menu_sheets + .menu > :last-child button:last-child")
    browser.wait("studio.pane === 'text' && document.activeElement === "
                 "studio.text.field")
    browser.keys("Bogen")
    check(language + ": a title block", browser.wait(
        "studio.text.field.value.endsWith('title_block(name, \"Bogen\").\\n') "
        "&& !studio.text.dirty && studio.ports.ports[0].rev === studio.rev"))
    browser.script("return studio.change('undo').then(() => 1)")
    browser.script("studio.leftTo('tree'); studio.ports.ports[0].settings = "
                   "{ views: ['front'], cuts: [] }")
    browser.wait("studio.saved")


def cut_seam(language):
    """A fold that is cut by the page: its pattern is that of `unfold --cut`."""
    with open(os.path.join(models, "box.pl"), "w") as out:
        out.write("segment(1, solid, box(size(3, 2, 1))).\n")
    browser.script("return studio.opened('box.pl').then(() => 1)")
    browser.script("studio.ports.ports[1].turnTo('unfold')")
    found = browser.wait("""studio.file === "box.pl" && (() => {
      const { picture, element } = studio.ports.ports[1];
      const fold = element.dataset.rev === String(studio.rev) && picture.shown?.strokes.find((s) => picture.shown.looks[s.look][1] === "fold_down");
      if (!fold) return null;
      const p = fold.points, { x, y } = new DOMPoint((p[0] + p[2]) / 2, (p[1] + p[3]) / 2)
        .matrixTransform(picture.svg.getScreenCTM());
      return [fold.edges[0], x, y];
    })()""")
    check(language + ": a fold", found, browser.log())
    edge, x, y = found
    browser.pointer((x, y), "down", "up")
    browser.wait("document.querySelector('.why [data-word=cut]')")
    browser.click(".why [data-word=cut]")
    check(language + ": cut", browser.wait(
        "!studio.saved && !studio.ports.ports[1].busy && studio.ports.ports[1]"
        ".element.dataset.rev === String(studio.rev)"))
    browser.script("""
      const { click } = HTMLAnchorElement.prototype;
      HTMLAnchorElement.prototype.click = function () {
        HTMLAnchorElement.prototype.click = click;
        fetch(this.href).then((answer) => answer.text()).then((text) => { window.fetched = text; });
      };
      window.fetched = null;
      studio.export("pattern", "svg");""")
    got = browser.wait("window.fetched")
    wanted = cli("unfold", "-q", "box.pl", "--cut", str(edge), "--format",
                 "svg", "-o", "-").decode()
    plain = cli("unfold", "-q", "box.pl", "--format", "svg", "-o", "-").decode()
    check(language + ": the bytes of unfold --cut", got == wanted != plain and
          wanted, (edge, (got or "")[:300], wanted[:300]))
    head, body = front_page.ask("unfold")
    body = body[8 * sum(one["halves"] for one in head["patterns"]):]
    check(language + ": and the port shows it", browser.script(
        "return studio.ports.ports[1].picture.shown.strokes.map((s) => "
        "[...s.points])") == strokes_of(body))
    browser.script("studio.chosen([]); return studio.opened('tee.pl')"
                   ".then(() => 1)")
    browser.wait("studio.file === 'tee.pl' && studio.ports.ports.every((p) => "
                 "!p.busy && p.picture.shown)")
    os.remove(os.path.join(models, "box.pl"))


def without_line_end(language):
    """A title block for a text whose last line has no end."""
    with open(os.path.join(models, "plain.pl"), "w") as out:
        out.write("segment(1, solid, box(size(3, 2, 1))).")
    browser.script("return studio.opened('plain.pl').then(() => "
                   "studio.titleBlock()).then(() => 1)")
    check(language + ": a title block behind a line without an end",
          browser.wait("studio.text.field.value === 'segment(1, solid, "
                       "box(size(3, 2, 1))).\\ntitle_block(name, \"plain\").\\n'"
                       " && !studio.text.dirty"), browser.log())
    browser.script("return studio.change('undo').then(() => studio.opened("
                   "'tee.pl')).then(() => studio.leftTo('tree')).then(() => 1)")
    browser.wait("studio.file === 'tee.pl' && studio.ports.ports.every((p) => "
                 "!p.busy && p.picture.shown)")
    os.remove(os.path.join(models, "plain.pl"))


def first_keys():
    """A key of ours that is the first one is not the browser's too; a file is
    sent again."""
    check("the first key", browser.script("""
      const table = studio.table;
      const ours = (key, more) => {
        studio.table = undefined;
        return !document.body.dispatchEvent(new KeyboardEvent("keydown",
          { key, bubbles: true, cancelable: true, ...more }));
      };
      const found = [ours("F6"), ours("k", { ctrlKey: true }), ours("q")];
      studio.table = table;
      return found;""") == [True, True, False])
    browser.wait("document.querySelector('dialog[open]')")
    browser.script("document.querySelector('dialog[open]').close()")
    check("one file twice", browser.script("""
      const { file } = studio.bar, sent = [], { upload } = studio;
      studio.upload = (one) => sent.push(one.name);
      for (let i = 0; i < 2; i++) {
        const data = new DataTransfer();
        data.items.add(new File(["segment(1, solid, box(size(1,1,1)))."], "one.pl"));
        file.files = data.files;
        file.dispatchEvent(new Event("change"));
      }
      delete studio.upload;
      return [sent, file.value];""") == [["one.pl", "one.pl"], ""])


def strokes_of(body):
    """The points of each stroke (docs/protocol.md)."""
    numbers = struct.unpack("<%di" % (len(body) // 4), body)
    points, i = [], 0
    while i < len(numbers):
        edges, count = numbers[i + 3:i + 5]
        points.append(list(numbers[i + 5 + edges:i + 5 + edges + 2 * count]))
        i += 5 + edges + 2 * count
    return points


RULES = "may_cut(_, _) :- fail.\nedge_role(_, _, _, _, crease).\n"
# The lines of a layer of port N, each with the end first that is less.
PIECES = """
  const ends = (p) => p.map((n) => Math.round(n)).join(" ");
  const piece = (a, b) => [ends(a), ends(b)].sort().join(" ");
  const lines = (d) => (d || "").split("M").filter(Boolean).map((one) => {
    const n = one.split(/[L ]+/).filter(Boolean).map(Number);
    return piece(n.slice(0, 2), n.slice(2, 4));
  }).sort();
  const of = ({ strokes }, names) => strokes.flatMap(({ segment, edges, points }) => [...edges].flatMap((e, i) =>
    (names.includes(`s${segment}e${e}`) ? [piece([...points.slice(2 * i, 2 * i + 2)], [...points.slice(2 * i + 2, 2 * i + 4)])] : []))).sort();
"""


def line_names(*arguments):
    """The names of the lines that `draw` draws."""
    drawn = json.loads(cli("draw", *arguments, "--format", "json", "-o", "-"))
    return {"s%de%d" % (line["segment"], edge)
            for line in drawn["lines"] for edge in line["edges"]}


def tried_lines(language, written):
    """Lines that came are green, those that went red: those by which two
    drawings of the command line differ. Also in a port that never drew the model
    by the rules of before, as those of a phone that are not shown."""
    with open(os.path.join(models, "tried.pl"), "w") as out:
        out.write(RULES)
    with open(os.path.join(models, "now.pl"), "w") as out:
        out.write(front_page.ask("text")[1].decode())
    before = line_names("now.pl")
    after = line_names("now.pl", "--quiet", "--rules", "tried.pl")
    for name in ("now.pl", "tried.pl"):
        os.remove(os.path.join(models, name))
    came, went = sorted(after - before), sorted(before - after)
    browser.script("studio.ports.ports[0].turnTo('iso'); studio.ports.ports[2]"
                   ".turnTo('back')")
    browser.wait("studio.ports.ports.every((p) => !p.busy) && studio.ports"
                 ".ports[2].picture.shown")
    browser.script("window.seen = studio.ports.ports[0].picture.shown; "
                   "window.back = studio.ports.ports[2].picture.shown; "
                   "studio.ports.ports[2].turnTo('right')")
    browser.script(written, RULES)
    check(language + ": lines that a rule changes", browser.wait(
        "studio.rules.wrong.hidden && studio.rules.counts.textContent"))
    check(language + ": green are those that came", came and browser.wait(
        "JSON.stringify([...studio.ports.ports[0].picture.lit.came].sort()) "
        "=== arguments[0]", json.dumps(came, separators=(",", ":"))), came)
    check(language + ": red are those that went", went and browser.wait(
        "(() => {" + PIECES + """
          const red = lines(studio.ports.ports[0].picture.layers.gone.getAttribute("d"));
          return red.length && JSON.stringify(red) === JSON.stringify(of(window.seen, arguments[0]));
        })()""", went), went)
    browser.script("studio.ports.ports[2].turnTo('back')")
    check(language + ": red also where the model is drawn only now",
          browser.wait("(() => {" + PIECES + """
          const red = lines(studio.ports.ports[2].picture.layers.gone.getAttribute("d"));
          return red.length && JSON.stringify(red) === JSON.stringify(of(window.back, arguments[0]));
        })()""", went), browser.script(
            "return studio.ports.ports[2].picture.layers.gone.getAttribute('d')"))
    browser.script("studio.ports.ports[2].turnTo('top'); studio.ports.ports[0]"
                   ".turnTo('iso')")


def file_changed(language):
    """Another program writes the file: one step; or whoever looks chooses."""
    path = os.path.join(models, "tee.pl")
    for _ in range(9):
        front_page.ask("save", force=True)
        browser.wait("studio.saved")
        text = front_page.ask("text")[1].decode()
        if open(path).read() == text:
            break
    with open(path, "w") as out:
        out.write(text.replace("radius(1)", "radius(0.95)", 1))
    check(language + ": what another program wrote", browser.wait(
        "JSON.stringify(studio.tree.model).includes('0.95')"), browser.log())
    browser.script("studio.change('undo')")
    for _ in range(200):
        if front_page.ask("text")[1].decode() == text:
            break
        time.sleep(0.02)
    check(language + ": one undo takes it back",
          front_page.ask("text")[1].decode() == text)
    browser.wait("!studio.saved")
    with open(path, "w") as out:
        out.write(text + "% theirs\n")
    check(language + ": asked, if both changed", browser.wait(
        "document.querySelectorAll('#banner button').length === 4"),
        browser.script("return document.getElementById('banner')"
                       ".textContent"))
    browser.script("document.querySelectorAll('#banner button')[1].click()")
    check(language + ": both texts side by side", browser.wait(
        "[...document.querySelectorAll('dialog[open] .other')].map(s => "
        "s.textContent).join('').includes('% theirs')"))
    browser.script("document.querySelector('dialog .main').click()")
    for _ in range(200):
        if front_page.ask("text")[1].decode().endswith("% theirs\n"):
            break
        time.sleep(0.02)
    check(language + ": taken", front_page.ask("text")[1].decode().endswith(
        "% theirs\n"))
    sent = os.path.join(models, "..", "sent %s.pl" % language)
    with open(sent, "w") as out:
        out.write("segment(1, solid, box(size(1, 2, 3))).\n")
    browser.keys(os.path.realpath(sent), "#bar input[type=file]")
    check(language + ": a file of the reader", browser.wait(
        "studio.segments.length === 1 && studio.file === arguments[0]",
        os.path.basename(sent)), browser.log())
    browser.script("studio.opened('tee.pl', null, { replay: false })")
    browser.wait("studio.file === 'tee.pl' && studio.segments.length > 1")
    browser.wait("document.getElementById('banner').hidden")
    with open(path, "w") as out:
        out.write(MODEL)
    for _ in range(200):
        if front_page.ask("text")[1].decode() == MODEL:
            break
        time.sleep(0.02)


# Where the keyboard goes by Tab: of each place its tag, what it is called, and
# whether one sees that it is there.
PLACE = """
  const e = document.activeElement, style = getComputedStyle(e);
  const outlined = e.matches("[role=treeitem]") ? getComputedStyle(e.firstElementChild) : style;
  const label = e.getAttribute("aria-label") || (e.labels && e.labels[0] && e.labels[0].textContent) || e.textContent;
  return [e.tagName, e.className + " " + e.id, label.trim(), outlined.outlineStyle !== "none"];"""


def by_keyboard():
    browser.open("about:blank")
    browser.open(front.address)
    browser.wait("studio.ready && studio.ports.ports[0].picture.shown")
    places = []
    for _ in range(60):
        browser.chord("\ue004")
        place = browser.script(PLACE)
        if place[0] == "BODY":
            break
        places.append(place)
    check("Tab goes through the page", len(places) > 20 and all(
        any(part in " ".join(place[:2]) for place in places)
        for part in ("canvas", "goal", "SELECT", "large")), places)
    check("each place has a name", all(place[2] for place in places),
          [place for place in places if not place[2]])
    check("one sees where the keyboard is", all(place[3] for place in places),
          [place for place in places if not place[3]])
    browser.script("studio.ports.ports[0].canvas.focus()")
    browser.keys(ENTER)
    check("lines are walked, and said", browser.wait(
        "document.getElementById('spoken').textContent.includes('s1e')"))
    browser.keys(ENTER)
    check("Enter asks why", browser.wait("document.querySelector('.why pre')"))
    browser.keys(ESCAPE)
    browser.keys("/")
    check("/ goes to the question", browser.script(
        "return document.activeElement.id") == "goal")
    menubar()


def menubar():
    """The menus, by the keyboard alone, as WAI-ARIA has a menubar."""
    said = {"en": ["s", "s", "bb", "bottom7", "dashed", "edges of the shape"],
            "ko": ["ㅇ", "ㄷ", "ㅈㅈㅈ", "저면도7", "파선", "형상의 모서리"]}[
                browser.script("return document.documentElement.lang")]
    focused = "return [document.activeElement.id, document.activeElement." \
              "textContent, document.activeElement.closest('.menu') !== null]"
    expanded = "return [...document.querySelectorAll('#menus [aria-expanded=" \
               "true]')].map(e => e.id)"
    browser.script("studio.ports.ports[2].canvas.focus()")
    browser.script("document.querySelector('#menu_file').focus()")
    stops = browser.script("return [...document.querySelectorAll('#menus "
                           "button')].filter(e => e.tabIndex === 0).length")
    check("Tab stops once in the bar", stops == 1, stops)
    browser.keys(RIGHT + RIGHT)
    # The menus come when the keyboard does.
    check("an arrow goes to the next menu", browser.wait(
        "document.activeElement.id === 'menu_solid'"), browser.script(focused))
    browser.keys(LEFT + LEFT + LEFT)
    check("and around the end", browser.script(
        "return document.activeElement.dataset.label") == "help")
    browser.keys("\ue011")
    check("Home is the first", browser.script(focused)[0] == "menu_file")
    browser.keys(said[0])
    check("a letter goes there", browser.script(focused)[0] == "menu_solid")
    browser.keys(said[1])
    check("and to the next one", browser.script(focused)[0] == "menu_sheets")
    browser.keys("\ue011" + DOWN)
    browser.wait("document.activeElement.closest('.menu')")
    check("down opens it, at the first row", browser.script(focused)[1:] ==
          [browser.script("return studio.models[0]"), True] and browser.script(expanded) == ["menu_file"],
          browser.script(focused))
    browser.keys(UP)
    check("up goes around", browser.script(focused)[1] == "html")
    check("what has the keyboard there stands out", browser.script("""
      const { outlineColor } = getComputedStyle(document.activeElement);
      return outlineColor !== "rgb(255, 255, 255)";"""))
    browser.keys(RIGHT)
    check("an arrow opens the menu beside it", browser.script(expanded) ==
          ["menu_menu"] and browser.script(focused)[2])
    chosen = browser.script("""
      return [...document.activeElement.closest(".menu").querySelectorAll("[role=menuitemradio][aria-checked=true]")]
        .map((e) => e.firstChild.textContent);""")
    check("what is so is told", chosen[1:] == [*said[4:], "z", "5"], chosen)
    browser.keys(ESCAPE)
    check("Escape closes it", browser.script(expanded) == [] and
          browser.script(focused)[0] == "menu_menu")
    browser.keys(UP)
    check("up opens it at its end", browser.script(focused)[2])
    browser.keys("\ue011" + said[2])
    check("letters go to the rows", browser.script(focused)[1] == said[3],
          browser.script(focused))
    browser.keys(ENTER)
    check("Enter does it, in the port used last", browser.script(expanded) == []
          and browser.script("return [studio.ports.ports[2].kind, studio.ports"
                             ".ports[2].canvas === document.activeElement]")
          == ["bottom", True])
    browser.script("studio.ports.ports[2].turnTo('top')")
    rows = browser.script("""
      studio.bar.made.open(document.getElementById("menu_menu"));
      const seen = [...document.querySelectorAll("#menus .menu:not([hidden]) [role^=menuitem]")]
        .every((e) => e.closest("[role=menu]").getAttribute("aria-labelledby") === "menu_menu");
      document.activeElement.blur();
      studio.bar.made.open(null);
      return seen;""")
    check("rows are of their menu", rows)
    # One table: what has a key says it in the menu, in the help, and it works.
    browser.keys("?")
    told = browser.wait("[...document.querySelectorAll('.help kbd')].map(e => "
                        "e.textContent)") or []
    check("the help has the keys", {"Ctrl+S", "Ctrl+Z", "Ctrl+K", "F6", "T",
                                    "X", "/", "?", "1", "7"} <= set(told), told)
    browser.keys(ESCAPE)
    browser.keys("x")
    check("a key of the table", browser.wait("studio.pane === 'text'"))
    browser.keys("t")
    browser.wait("studio.pane === 'tree'")
    browser.script("document.activeElement.blur()")


def screens():
    """320 px, forced colours, reduced motion."""
    browser.emulate("setDeviceMetricsOverride", width=320, height=640,
                    deviceScaleFactor=1, mobile=True)
    for pane in ("ports", "left", "asking"):
        browser.script("studio.paneTo(arguments[0])", pane)
        check("320 px: " + pane, browser.wait(
            "document.documentElement.scrollWidth <= 320 && [...document."
            "querySelectorAll('#bar button, .tabs button, #panes button')]."
            "filter(e => e.offsetParent).every(e => e.getBoundingClientRect()"
            ".right <= 321)"))
    # What became of the model while another pane was shown.
    front_page.ask("edit", set={"segment": 1, "path": [2, 2, 1], "value": 5})
    check("320 px: the model of now", browser.wait(
        "studio.rev === arguments[0]", front_page.ask("tree")[0]["rev"]))
    browser.script("studio.paneTo('ports')")
    check("320 px: the port follows when it is shown", browser.wait(
        "[...document.querySelectorAll('.port')].filter((p) => p.offsetParent)"
        ".every((p) => p.dataset.rev === String(studio.rev))", seconds=20))
    front_page.ask("undo")
    browser.emulate("clearDeviceMetricsOverride")
    browser.media(forced_colors="active")
    colours = browser.script("""
      const of = (css) => getComputedStyle(document.querySelector(css)).stroke;
      const probe = document.body.appendChild(document.createElement("i"));
      probe.style.color = "CanvasText";
      const found = [getComputedStyle(probe).color, of(".lines path"), of(".canvas .chosen"), of(".canvas .lit")];
      probe.remove();
      return found;""")
    check("forced colours", colours[0] == colours[1] and
          len(set(colours[1:])) == 3, colours)
    browser.media(prefers_reduced_motion="reduce")
    check("reduced motion", browser.script("""
      document.querySelector(".port").classList.add("late");
      const style = getComputedStyle(document.querySelector(".late figcaption"), "::after");
      const still = style.animationName === "none" &&
        parseFloat(getComputedStyle(document.querySelector(".canvas svg")).transitionDuration) === 0;
      document.querySelector(".port").classList.remove("late");
      return still;"""))
    browser.media()


class Proxy(threading.Thread):
    """A reverse proxy: /folder/x at its own port is /x there."""

    def __init__(self, port):
        super().__init__(daemon=True)
        self.there = port
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.port = self.listening.getsockname()[1]

    def run(self):
        while True:
            page, _ = self.listening.accept()
            threading.Thread(target=self.one, args=(page,),
                             daemon=True).start()

    def one(self, page):
        head = b""
        while b"\r\n\r\n" not in head:
            octets = page.recv(65536)
            if not octets:
                return
            head += octets
        head = head.replace(b" /folder/", b" /", 1)
        if b"Upgrade: websocket" not in head:
            head = head.replace(b"Connection: keep-alive",
                                b"Connection: close")
        try:
            other = socket.create_connection(("127.0.0.1", self.there))
        except OSError:
            page.close()
            return
        other.sendall(head)
        threading.Thread(target=self.copied, args=(page, other),
                         daemon=True).start()
        self.copied(other, page)

    @staticmethod
    def copied(one, other):
        try:
            while True:
                octets = one.recv(65536)
                if not octets:
                    break
                other.sendall(octets)
            other.shutdown(socket.SHUT_WR)
        except OSError:
            pass


def behind_a_proxy():
    free = socket.create_server(("127.0.0.1", 0))
    port = free.getsockname()[1]
    free.close()
    proxy = Proxy(port)
    proxy.start()
    own = os.path.join(folder, "behind")
    os.makedirs(own)
    with open(os.path.join(own, "tee.pl"), "w") as out:
        out.write(MODEL)
    room = Front(program, own, "tee.pl", (
        "--behind", "http://127.0.0.1:%d/folder/" % proxy.port),
        dict(env, XDG_STATE_HOME=own), port)
    browser.open("about:blank")
    browser.open(room.address)
    check("behind a proxy", browser.wait(
        "studio.ready && studio.ports.ports[0].picture.shown"),
        (room.address, browser.log()))
    room.process.kill()
    room.process.communicate()
    browser.log()


def as_a_file(language, words):
    """The page as a file works from the disk, and asks nobody."""
    browser.script("document.getElementById('goal').value = 'segment(S, K, _)'")
    browser.keys(ENTER, "#goal")
    browser.wait("studio.asking.goal === 'segment(S, K, _)' && studio.asking"
                 ".answered.goal === studio.asking.goal")
    browser.script("""
      window.kept = ""; studio.ports.ports[0].turnTo("iso");
      studio.page().then((text) => { window.kept = text; },
                         (error) => { window.kept = "error: " + error; })""")
    page = browser.wait("window.kept", seconds=120)
    path = os.path.join(models, "tee.html")
    with open(path, "w", encoding="utf-8") as out:
        out.write(page or "")
    pattern = front_page.ask("unfold")[0]["strokes"]
    iso = front_page.ask("view", format="strokes", view=[
        315, 54.735610317245346], size=[160, 120], margin=8)[1]
    browser.log()
    browser.open("file://" + path)
    check(language + ": a page from a file", browser.wait(
        "studio.ready && studio.ports.ports.every(p => p.picture.shown)"),
        (page or "")[:99])
    check(language + ": the exact view", browser.script("""
      const { points } = studio.ports.ports[0].picture.shown.strokes[0];
      return [...points]""") == list(struct.unpack_from(
          "<%di" % (2 * struct.unpack_from("<i", iso, 16)[0]), iso,
          20 + 4 * struct.unpack_from("<i", iso, 12)[0])))
    check(language + ": the pattern", browser.script(
        "return studio.ports.ports[1].picture.shown.strokes.length")
        == pattern)
    browser.script("studio.chosen(['s1e50'], studio.ports.ports[0])")
    why = browser.wait("document.querySelector('.why pre') && "
                       "document.querySelector('.why pre').textContent")
    text = cli("explain", "tee.pl", "hidden(1,50)", "--view", "iso", "--lang",
               language).decode()
    check(language + ": why, from a file", (why or "").split() ==
          text.split(), (why, text))
    browser.script("document.getElementById('goal').value = 'segment(S, K, _)'")
    browser.keys(ENTER, "#goal")
    check(language + ": what was answered", browser.wait(
        "document.querySelector('.ask .remark').textContent === arguments[0]",
        words["answers"]))
    browser.script("studio.ports.ports[0].turnTo('folded')")
    check(language + ": folded from a file", browser.wait(
        "studio.ports.ports[0].folding && studio.ports.ports[0].folding.faces"))
    browser.chord(CONTROL, "k")
    check(language + ": found, in a file", browser.wait(
        "document.querySelector('dialog.find li')"))
    browser.keys(ESCAPE)
    check(language + ": nothing is changed there", browser.script(
        "return [...document.querySelectorAll('.wishes, [data-word=save_question]')]"
        ".every(e => getComputedStyle(e).display === 'none') && !document."
        "querySelector('#menu_file, #menus [data-label=undo]')"))
    check(language + ": its sizes are there to read", browser.script("""
      studio.tree.choose(1, '/1', 0);
      const boxes = [...document.querySelectorAll('.form input[type=number]')];
      return boxes.length > 0 && boxes.every(e => e.readOnly && e.offsetWidth > 20 && e.value !== '')
        && [...document.querySelectorAll('.form input[type=range]')].every(e => !e.offsetWidth)"""))
    check(language + ": nobody is asked", browser.log() == [] and
          browser.script("return performance.getEntriesByType('resource')"
                         ".filter(e => !e.name.startsWith('blob:')).length")
          == 0, browser.log())
    browser.open(front.address)
    browser.wait("studio.ready && studio.ports.ports[0].picture.shown")


def flows(language):
    words = {"en": {"why": "Why", "answers": "2 answers",
                    "visible": "visible from", "saved": "saved",
                    "changed": "not saved"},
             "ko": {"why": "이유", "answers": "답 2개", "visible": "보인다",
                    "saved": "저장됨", "changed": "저장 안 됨"}
             }[language]

    # Open: the page is painted, with what `draw` draws. Who opens it again has
    # kept its files; each port asks for its picture once.
    for again in (False, True):
        browser.open("about:blank")
        browser.open(front.address)
        drawn = browser.wait("studio.ready && studio.ports.ports.every(p => "
                             "p.kind === 'unfold' || p.picture.shown)")
        check(language + ": drawn", drawn, browser.log())
        files = browser.script("""
          return performance.getEntriesByType("resource").filter((e) => e.deliveryType !== undefined)
            .map((e) => [new URL(e.name).pathname, e.transferSize]);""")
        check(language + ": its files, again: %s" % again, len(files) > 12
              and all(name.count("/") == 2 for name, _ in files) and
              all((size == 0) == again for _, size in files), files)
    time.sleep(0.2)
    check(language + ": one view for each port", browser.script(
        "return studio.wire.number") <= 1 + 5 + 2, browser.script(
            "return studio.wire.number"))
    check(language + ": its words", browser.wait(
        "document.querySelector('.why h2').textContent === arguments[0]",
        words["why"]))
    check(language + ": nothing without words", browser.script(
        "return [...document.querySelectorAll('[data-word]')].every(e => "
        "e.textContent)"))
    head = front_page.ask("view", format="strokes", view="front",
                          size=[100, 80])[0]
    check(language + ": as many strokes as the session has",
          browser.script("return studio.ports.ports.find(p => p.kind === "
                         "'front').picture.counts()[0]") == head["strokes"])

    as_drawn(language, "the first picture")

    # Turn it, by the mouse and by keys; the picture at rest is the exact one.
    before = browser.script("return " + LINES % 0)
    box = browser.script("const r = document.querySelector('.canvas')."
                         "getBoundingClientRect(); return [r.x, r.y, r.width, "
                         "r.height]")
    corner = (box[0] + 20, box[1] + box[3] - 20)
    browser.pointer(corner, "down", (corner[0] + 60, corner[1] - 40),
                    (corner[0] + 120, corner[1] - 90), "up")
    check(language + ": it turns", browser.wait(
        LINES % 0 + " !== arguments[0]", before))
    browser.keys(LEFT)
    time.sleep(0.4)
    theta, phi = browser.script("return studio.ports.ports[0].angles")
    count = browser.script("return studio.ports.ports[0].picture.counts()")
    head = front_page.ask("view", format="strokes", view=[theta, phi],
                          size=[100, 80])[0]
    check(language + ": the exact picture at rest",
          count[0] == head["strokes"], (count, head["strokes"]))
    browser.wait("!studio.ports.ports[0].busy")
    as_drawn(language, "at rest")

    # Click a line: why.
    x, y = browser.script(POINT, "s1e50")
    browser.pointer((x, y), "down", "up")
    why = browser.wait("document.querySelector('.why pre') && "
                       "document.querySelector('.why pre').textContent")
    name = browser.script("return document.querySelector('.chip strong')"
                          ".textContent")
    segment, edge = re.match(r"s(\d+)e(\d+)$", name).groups()
    text = cli("explain", "tee.pl", "hidden(%s,%s)" % (segment, edge),
               "--view", "%f,%f" % (theta, phi), "--lang", language).decode()
    check(language + ": why, as explain says", text.strip() and
          (why or "").split() == text.split(), (why, text))
    check(language + ": the line is lit", browser.script("return " + LAYER %
                                                         (0, "chosen")))

    seams(language)
    cut_seam(language)
    without_line_end(language)
    first_keys()

    # A question: its answers are lit in every port.
    browser.script("document.getElementById('goal').value = arguments[0]",
                   "e(1, E, _, _, 1), E < 3")
    browser.keys(ENTER, "#goal")
    check(language + ": answers", browser.wait(
        "document.querySelector('.ask .remark').textContent === arguments[0]",
        words["answers"]))
    check(language + ": lit in every port, drawn there or not", browser.wait(
        "studio.ports.ports.every(({picture, kind}) => kind === 'unfold' || "
        "picture.layers.lit.getAttribute('d'))"))
    lit = browser.script("return [...studio.ports.ports[0].picture.lit.lit]")
    check(language + ": these and no others", sorted(lit) == ["s1e1", "s1e2"],
          lit)
    browser.script("document.getElementById('goal').value = arguments[0]",
                   "hides(S1, S2), S1 \\== S2")
    browser.keys(ENTER, "#goal")
    view = browser.script("return studio.ports.ports[0].angles")
    head, _ = front_page.ask("ask", goal="hides(S1, S2), S1 \\== S2",
                             view=view)
    check(language + ": what hides what", head["answers"] and browser.wait(
        "JSON.stringify([...studio.ports.ports[0].picture.lit.lit].sort()) "
        "=== arguments[0]", json.dumps(sorted(
            {name for shown in head["shows"] for name in shown}),
            separators=(",", ":"))), head)
    check(language + ": lit in every port that draws them", browser.wait("""
      studio.ports.ports[0].picture.layers.lit.getAttribute("d") &&
      studio.ports.ports.every(({picture, kind}) => kind === "unfold" || picture.layers.lit.getAttribute("d") ||
        ![...picture.lit.lit].some((name) => picture.draws(name)))"""))
    kept_questions(language)
    browser.script("document.getElementById('goal').value = 'shell(ls)'")
    browser.keys(ENTER, "#goal")
    check(language + ": a refused question is said", browser.wait(
        "document.querySelector('.ask .bad')"))

    # A slider, then undo; the file has one number more or less.
    text = front_page.ask("text")[1].decode()
    browser.script("document.querySelector('.tree [role=treeitem]').click()")
    browser.wait("document.querySelector('.form input[aria-label*=radius]')")
    before = browser.script("return " + LINES % 0)
    browser.script("""
      const slider = document.querySelector('.form input[aria-label*=radius]');
      slider.dispatchEvent(new Event('pointerdown'));
      for (const value of [0.7, 0.8, 0.85, 0.9]) {
        slider.value = value; slider.dispatchEvent(new Event('input'));
      }
      slider.dispatchEvent(new Event('change'));""")
    check(language + ": the slider's last value is shown", browser.wait(
        "!studio.tree.sets.length && " + LINES % 0 + " !== arguments[0]",
        before))
    changed = front_page.ask("text")[1].decode()
    check(language + ": one number is another", changed ==
          text.replace("radius(1)", "radius(0.9)", 1), changed)
    state = "document.getElementById('state').textContent === arguments[0]"
    check(language + ": it is not saved", browser.wait(state, words["changed"]))
    browser.script("document.activeElement.blur()")
    browser.chord(CONTROL, "z")
    for _ in range(200):
        if front_page.ask("text")[1].decode() == text:
            break
        time.sleep(0.02)
    check(language + ": one undo takes the whole drag back",
          front_page.ask("text")[1].decode() == text)
    check(language + ": then it is as it was saved", browser.wait(
        state, words["saved"]))
    front_page.ask("edit", set={"segment": 1, "path": [2, 2, 1], "value": 3})
    browser.wait(state, words["changed"])
    front_page.ask("save")
    check(language + ": saved by another window", browser.wait(
        state, words["saved"]))
    front_page.ask("undo")
    front_page.ask("save")
    for i in range(50):
        front_page.ask("edit", set={"segment": 1, "path": [2, 2, 1],
                                    "value": 2 + i / 50})
    check(language + ": other windows are followed", browser.wait(
        "studio.rev === arguments[0]", front_page.ask("tree")[0]["rev"]))
    browser.script("for (let i = 0; i < 50; i++) studio.change('undo')")
    revision = None
    for _ in range(500):
        head, body = front_page.ask("text")
        if body.decode() == text:
            revision = head["rev"]
            break
        time.sleep(0.02)
    check(language + ": undo, 50 times", revision)
    check(language + ": all ports show one revision", browser.wait(
        "[...document.querySelectorAll('.port')].filter(p => !p.classList."
        "contains('flat')).every(p => Number(p.dataset.rev) === arguments[0])",
        revision))

    # The text; what is wrong with it stands beside it.
    browser.script("document.querySelector('.tabs [data-word=text]').click()")
    check(language + ": the text", browser.wait(
        "studio.text.field.value === arguments[0]", text))
    typed = "studio.text.field.value = arguments[0]; " \
            "studio.text.field.dispatchEvent(new Event('input'))"
    check(language + ": its colours stand behind it", browser.script("""
      const { field, colours } = studio.text, style = (e) => getComputedStyle(e);
      const same = (key) => style(field)[key] === style(colours)[key];
      const [a, b] = [field, colours].map((e) => e.getBoundingClientRect());
      return colours.textContent === field.value + "\\n" && a.x === b.x && a.y === b.y &&
        ["fontFamily", "fontSize", "lineHeight", "paddingLeft", "paddingTop", "tabSize", "borderLeftWidth"].every(same) &&
        colours.querySelectorAll(".figure").length > 5;"""))
    browser.script(typed, text + "% 한글 'x\nsegment(3, solid, 'a b', \"c\", X, 1.5e-3" + "\n" * 90)
    check(language + ": each kind in its own", browser.script("""
      const { field, colours } = studio.text;
      field.scrollTop = 400;
      field.dispatchEvent(new Event("scroll"));
      return [...colours.querySelectorAll("span")].slice(-6).map((e) => e.className + " " + e.textContent)
        .concat(String(colours.scrollTop === field.scrollTop && field.scrollTop === 400));""") == [
        "comment % 한글 'x", "figure 3", "quoted 'a b'", 'quoted "c"', "variable X",
        "figure 1.5e-3", "true"], browser.script("""
      return [...studio.text.colours.querySelectorAll("span")].slice(-6).map((e) => e.className + " " + e.textContent)"""))
    browser.script(typed, text + "segment(3, ")
    check(language + ": a mistake is said", browser.wait(
        "!studio.text.wrong.hidden && studio.text.wrong.textContent"))
    browser.script(typed, text.replace("facets(40)", "facets(12)"))
    check(language + ": the text is followed", browser.wait(
        "studio.text.wrong.hidden && !studio.text.dirty"))
    browser.script("studio.change('undo')")

    # A rule: the lines that came and went.
    browser.script("document.querySelector('.tabs [data-word=rules]')"
                   ".click()")
    browser.wait("document.querySelector('.decisions li')")
    written = typed.replace("studio.text", "studio.rules")
    # What is typed stays, also if an answer comes then.
    browser.script("studio.rules.refresh();" + written,
                   "line_role(_, _, outline).\n")
    check(language + ": what is wrong with a rule", browser.wait(
        "!studio.rules.wrong.hidden && studio.rules.wrong.textContent"))
    tried_lines(language, written)
    browser.script("studio.rules.end(false)")
    browser.script("document.querySelector('.tabs [data-word=tree]').click()")
    browser.wait("document.getElementById('banner').hidden")

    kinds(language)
    file_changed(language)

    if language == "ko":
        as_a_file(language, words)

    # The session is killed; nothing that was done is lost.
    front_page.ask("edit", set={"segment": 1, "path": [2, 2, 1], "value": 3})
    text = front_page.ask("text")[1]
    os.kill(front.sessions()[0], 9)
    browser.wait("studio.ports.ports[0].busy === false")
    check(language + ": killed, and there again", browser.wait(
        "!document.getElementById('banner').hidden"))
    for _ in range(400):
        head, body = front_page.ask("text")
        if "error" not in head:
            break
        time.sleep(0.03)
    check(language + ": nothing is lost", body == text, head)
    complaints = [line for line in browser.log() if "favicon" not in line]
    check(language + ": the browser has no complaints", complaints == [],
          complaints)


def a_class(language):
    """A pupil answers a problem; the teacher sees it."""
    room = Front(program, os.path.join(here, "facts/problems"), None,
                 ("--problems", "collection.pl"), env)
    joined = room.process.stdout.readline().decode().strip()
    said = {"en": ("Too small.", "Right."), "ko": ("너무 작습니다.", "맞습니다.")}
    try:
        browser.open("about:blank")
        browser.open(joined)
        browser.wait("document.querySelector('#left input[list=pupils]')")
        browser.keys("Kim" + ENTER, "#left input[list=pupils]")
        check(language + ": a problem", browser.wait(
            "studio.problems.reply && studio.ports.ports[0].picture.shown"),
            browser.log())
        browser.script("studio.problems.pose('fig10')")
        browser.wait("studio.problems.at === 'fig10' && !studio.ports"
                     ".ports[0].busy")
        answer = "document.querySelectorAll('.task input')[%d].value = %s"
        for loops, length, i in (("'0'", "'1'", 0), ("'2'", "'114,9'", 1)):
            browser.script("; ".join((answer % (0, loops),
                                      answer % (1, length))))
            browser.click(".task button.main")
            check(language + ": " + said[language][i], browser.wait(
                "[...document.querySelectorAll('.task .field p')].every(p => "
                "p.textContent.startsWith(arguments[0]))",
                said[language][i]), browser.log())
        check(language + ": the answer, explained", browser.wait(
            "studio.ports.ports[0].picture.shown.looks.some(([, role]) => "
            "role === 'construction')") and "√" in browser.script(
                "return document.querySelectorAll('.task .field p')[1]"
                ".textContent"))
        browser.script("sessionStorage.clear()")
        browser.open("about:blank")
        browser.open(room.address)
        check(language + ": the teacher's table", browser.wait(
            "document.querySelector('.book tbody td[title]') && document"
            ".querySelector('.book tbody td[title]').textContent === '✓ 2'"))
        check(language + ": no complaints of a class", browser.log() == [])
    finally:
        room.process.kill()
        room.process.communicate()


here = os.getcwd()
for language in ("en", "ko"):
    models = os.path.join(folder, language)
    os.makedirs(models)
    with open(os.path.join(models, "tee.pl"), "w") as out:
        out.write(MODEL)
    env = dict(os.environ, XDG_STATE_HOME=os.path.join(models, "state"))
    front = Front(program, models, "tee.pl", (), env)
    front_page = front.page()
    browser = Browser(1440, 900, language)
    try:
        flows(language)
        menubar()
        if language == "en":
            browser.script("document.querySelector('#bar [data-word=language]'"
                           ").click()")
            check("switched live", browser.wait(
                "document.querySelector('.why h2').textContent === '이유'"))
            browser.size(500, 700)
            check("a small screen has one pane", browser.wait(
                "[...document.querySelectorAll('main > *')].filter(e => "
                "getComputedStyle(e).display !== 'none').length === 1"))
            check("nothing is wider than it", browser.script(
                "return document.documentElement.scrollWidth <= innerWidth"))
        browser.size(1440, 900)
        if language == "en":
            by_keyboard()
            screens()
            behind_a_proxy()
        a_class(language)
        browser.open(front.address)
        browser.wait("studio.ready")
        front.process.kill()
        check(language + ": the front is gone: said", browser.wait(
            "!document.getElementById('banner').hidden"))
    finally:
        browser.end()
        front_page.close()
        front.process.kill()
        front.process.communicate()
checks.finish()
