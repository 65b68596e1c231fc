"""lines_test.py PROGRAM FOLDER: the lines of pictures in a real Chromium: the first
picture is the golden one (written anew if BLESS is in the environment), which line
is pointed at, where edges without a line are, whose names they have, and what is
said of them."""
# covers: about_ko, complete, port
import os
import shutil
import sys

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.join(here, "../cli")]
from browser import Browser  # noqa: E402
from front import Front  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
checks = Checks()
check = checks.check
models = os.path.join(folder, "models")
os.mkdir(models)
for name in ("pipe_tee.pl", "figures/fig13.pl"):
    shutil.copy(os.path.join("facts", name), models)
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
GOLDEN = os.path.join(here, "first_picture.txt")
CONTROL = "\ue009"
QUIET = "studio.ready && studio.ports.ports.every(p => !p.element.offsetParent" \
        " || (!p.busy && p.rev === studio.rev && " \
        "!p.canvas.classList.contains('empty')))"
# The first port has this size, whatever is written above it.
SIZED = """
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(".port:first-child .canvas { flex: none; width: 640px; height: 480px; }");
  document.adoptedStyleSheets = [sheet];"""
# The strokes of the first picture, a line each.
STROKES = """
  const { strokes, looks, sheet } = studio.ports.ports[0].picture.shown;
  return [sheet.join(" "), ...strokes.map(({ look, segment, closed, edges, points }) =>
    [...looks[look], segment, closed ? "closed" : "open", [...edges].join(","), [...points].join(" ")].join(" | "))]
    .join("\\n") + "\\n";"""
# Random pictures: what is found by looking at all pieces of all lines, and by the
# page; and the slowest half of what it takes where there are very many.
FOUND = """
  const done = arguments[arguments.length - 1];
  import(new URL("picture.js", document.querySelector("link[rel=stylesheet]").href)).then(({ Picture }) => {
    let seed = 7;
    const random = (n) => { seed = (seed * 16807) % 2147483647; return seed % n; };
    const box = document.createElement("div");
    box.id = "found_here";
    document.body.append(box);
    const near = ({ strokes, looks }, x, y, within) => {
      let best = null, least = within ** 2;
      for (const stroke of strokes.filter((one) => one.edges.length || one.whole)) {
        const { points, edges, closed } = stroke, n = points.length / 2;
        for (let i = 0; i < (closed ? n : n - 1); i++) {
          const [ax, ay] = [points[2 * i], points[2 * i + 1]], j = (i + 1) % n;
          const [dx, dy] = [points[2 * j] - ax, points[2 * j + 1] - ay];
          const along = dx * dx + dy * dy;
          const t = along ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / along)) : 0;
          const far = ((ax + t * dx - x) ** 2 + (ay + t * dy - y) ** 2) * (looks[stroke.look][0] === "hidden" ? 4 : 1);
          if (far < least) [best, least] = [{ stroke, edge: edges.length >= n - 1 ? edges[i] : edges[0] }, far];
        }
      }
      return best;
    };
    const made = (count, most, far) => {
      const strokes = [];
      for (let i = 0; i < count; i++) {
        const n = 2 + random(most), points = new Int32Array(2 * n);
        let [x, y] = [random(300000), random(200000)];
        for (let k = 0; k < n; k++) {
          points.set([x, y], 2 * k);
          [x, y] = random(3) ? [x + random(far) - far / 2, y + random(far) - far / 2] : random(2) ? [x, y + random(far)] : [x + random(far), y];
        }
        const closed = n > 2 && random(3) === 0, pieces = closed ? n : n - 1;
        strokes.push({ look: i % 3, segment: 1 + random(5), closed, points, whole: false,
          edges: Int32Array.from({ length: random(9) ? Math.max(1, pieces) : random(2) }, () => random(90) - 20) });
      }
      const picture = new Picture();
      box.replaceChildren(picture.svg);
      picture.show({ strokes, looks: [["visible", "edge"], ["hidden", "edge"], ["visible", "cut"]],
        sheet: [300000, 200000], place: null, texts: [] });
      return picture;
    };
    const wrong = [];
    let hits = 0;
    for (const [count, most, far] of [[0, 1, 1], [1, 2, 9000], [1, 40, 90000], [7, 3, 300000], [300, 12, 20000], [3000, 4, 3000], [400, 3, 12]]) {
      const picture = made(count, most, far);
      picture.svg.setAttribute("viewBox", "0 0 300000 200000");
      const matrix = picture.svg.getScreenCTM();
      for (let i = 0; i < 60; i++) {
        const [sx, sy] = [random(640) - 20, random(440) - 20], within = [9, 22][i % 2];
        const { x, y } = new DOMPoint(sx, sy).matrixTransform(matrix.inverse());
        const [one, other] = [near(picture.shown, x, y, within / matrix.a), picture.near(sx, sy, within)];
        hits += one ? 1 : 0;
        if (one?.stroke !== other?.stroke || one?.edge !== other?.edge) wrong.push([count, sx, sy]);
      }
    }
    const many = made(100000, 2, 4000);
    many.near(1, 1);
    const times = Array.from({ length: 101 }, () => {
      const since = performance.now();
      many.near(random(600), random(400));
      return performance.now() - since;
    }).sort((a, b) => a - b);
    box.remove();
    done({ wrong, hits, half: times[50] });
  }, (error) => done(String(error)));"""
# Of edges that are drawn, which part of their ends is where the page takes them to
# be, within 2/1000 mm (the others are not drawn to their ends); and how many.
ENDS = """
  const done = arguments[arguments.length - 1];
  const { picture } = studio.ports.ports[0];
  const at = new Map();
  for (const { segment, edges, points } of picture.shown.strokes) {
    for (const edge of edges) {
      const name = `s${segment}e${edge}`;
      if (edge > 0) at.set(name, [...at.get(name) ?? [], ...points]);
    }
  }
  const names = [...at.keys()].filter((_, i) => i % 5 === 0).slice(0, 200);
  studio.wire.ask("select", { names, keep: false }).then(({ head }) => {
    const far = names.flatMap((name) => head.ends[name].map((end) => {
      const [x, y] = picture.space.where(end), points = at.get(name);
      return Math.min(...points.map((n, i) => (i % 2 ? Infinity : Math.hypot(n - x, points[i + 1] - y))));
    }));
    done([far.filter((n) => n < 2).length / far.length, far.length]);
  }, (error) => done(String(error)));"""


def ask(text, *given):
    """A script that hears when it is done."""
    return browser.ask("POST", "/execute/async",
                       {"script": text, "args": list(given)})


def first_picture():
    browser.tool("Page.addScriptToEvaluateOnNewDocument", source=SIZED)
    browser.open(front.address)
    check("opened", browser.wait(QUIET), browser.log())
    text = browser.script(STROKES)
    if "BLESS" in os.environ:
        with open(GOLDEN, "w") as out:
            out.write(text)
    with open(GOLDEN) as golden:
        check("the first picture", text == golden.read(), text[:300])


def pointed_at():
    found = ask(FOUND)
    check("the nearest line", found["wrong"] == [] and found["hits"] > 60,
          found)
    check("of 100,000 lines in 2 ms", found["half"] < 2, found)


def without_a_line():
    """Edges are lit where their lines would be, however the model is seen."""
    for projection in ("parallel", "central"):
        for up in ("z", "y", "x"):
            browser.script("Object.assign(studio.looks, { projection: "
                           "arguments[0], up: arguments[1], lines: 'all' }); "
                           "studio.looked()", projection, up)
            for kind in ("iso", "front", "top", "left"):
                browser.script("studio.ports.ports[0].turnTo(arguments[0])",
                               kind)
                browser.wait("!studio.ports.ports[0].busy && "
                             "studio.ports.ports[0].kind === arguments[0]",
                             kind)
                part, count = ask(ENDS)
                check("%s, %s up, %s: where edges are" % (projection, up, kind),
                      part > 0.7 and count > 40, (part, count))
    browser.script("studio.looks = {}; studio.looked(); "
                   "studio.ports.ports[0].turnTo('iso')")
    browser.wait(QUIET)


def sections():
    """A line of a section says which face of the model the plane cuts there, or
    which edge of the model it is; both are lit wherever they are."""
    browser.script("studio.ports.ports[0].turnTo('section')")
    browser.wait(QUIET)
    points = browser.script("""
      const port = studio.ports.ports[0], { strokes, looks } = port.picture.shown;
      const matrix = port.picture.svg.getScreenCTM(), found = {};
      for (const { look, letter, edges, points } of strokes) {
        if (looks[look][1] === "hatching" || !edges[0]) continue;
        const { x, y } = new DOMPoint((points[0] + points[2]) / 2, (points[1] + points[3]) / 2).matrixTransform(matrix);
        if (port.near({ clientX: x, clientY: y }).name.includes(letter)) found[letter] = [x, y];
      }
      return [found.p, found.e];""")
    for (x, y), name, said in zip(points, ("s[12]p[0-9]+", "s[12]e[0-9]+"), (
            "Here the plane y = 0 cuts this face.", "edge [0-9]+ of segment")):
        browser.pointer((x, y), "down", "up")
        check("what a line of a section is: " + name, browser.wait(
            "new RegExp('^' + arguments[0] + '$').test(document.querySelector("
            "'.why .chip strong').textContent) && new RegExp(arguments[1]).test"
            "(document.querySelector('.why').textContent)", name, said),
            browser.script("return document.querySelector('.why').textContent"))
        check("it is lit in every port", browser.wait("""
          studio.ports.ports.every(({ kind, picture }) => ["unfold", "sheet", "shaded"].includes(kind)
            || picture.layers.chosen.getAttribute("d").length > 8)"""))
        check("and asked for by a double click", browser.script(
            "return studio.askAbout(studio.names[0]).then(() => "
            "document.querySelector('#goal').value)").startswith(
                "p(" if "p" in name else "e("))
    # What was cut away is lit in the other ports alone.
    gone = browser.script("""
      const names = Array.from({ length: 60 }, (_, i) => `s1e${i + 1}`);
      return studio.wire.ask("select", { names, keep: false }).then(({ head }) =>
        names.find((name) => head.ends[name].every(([, y]) => y < -0.5)));""")
    browser.script("studio.chosen([arguments[0]])", gone)
    lit = "studio.ports.ports.map(({ picture }) => picture.layers.chosen" \
          ".getAttribute('d').length)"
    check("an edge that is cut away is not lit", browser.wait(
        "((lit) => lit[0] === 0 && lit[1] > 8)(%s)" % lit),
        (gone, browser.script("return " + lit)))
    browser.script("studio.ports.ports[0].turnTo('iso')")
    browser.wait(QUIET)


def no_such_file():
    """What was open is open still, and says so."""
    browser.script("return studio.opened('nothing.pl').then(() => 1)")
    check("not there", browser.wait(
        "!document.getElementById('banner').hidden") and browser.wait(QUIET))
    check("it is the other one", browser.script(
        "return [studio.file, document.getElementById('file').textContent, "
        "document.title.split(' ')[0]]") == ["fig13.pl"] * 3)
    check("and is shown", browser.script(
        "return studio.ports.ports.every(p => p.picture.shown)"))
    browser.script("document.querySelector('#banner button').click()")


def on_a_phone():
    """Each port has room, whatever their number; the answers take what they need."""
    browser.script("studio.ports.enlarge(studio.ports.ports[0])")
    for count in range(1, 7):
        browser.script("""
          studio.ports.many(arguments[0]);
          if (studio.ports.one) studio.ports.enlarge(studio.ports.one);""", count)
        browser.wait(QUIET)
        room = browser.script("""
          return studio.ports.ports.map(({ element }) => {
            const { x, y, right, bottom } = element.getBoundingClientRect();
            return [x, y, right, bottom];
          });""")
        check("room for %d" % count, all(
            right - x > 150 and bottom - y > 150 for x, y, right, bottom in room)
            and sum((right - x + 6) * (bottom - y + 6)
                    for x, y, right, bottom in room) > 0.97 * 380 * 716, room)
    browser.script("studio.paneTo('asking')")
    high = browser.script("return [...document.querySelectorAll('#asking .panel')"
                          "].map((panel) => panel.clientHeight)")
    check("reasons have the rest", high[0] < 150 and high[1] > 500, high)


PATTERN = "studio.ports.ports.find((p) => p.kind === 'unfold')"
NEAR = """
  const port = %s, box = port.canvas.getBoundingClientRect();
  for (let x = box.x; x < box.right; x += 4) for (let y = box.y; y < box.bottom; y += 4) {
    const found = port.near({ clientX: x, clientY: y });
    if (found) return [found.name, x, y];
  }
  return null;""" % PATTERN


def names_of_now():
    """A picture of the model before has no names that can be clicked."""
    found = browser.script(NEAR)
    check("an edge of the pattern", found)
    # Another model: its ports are bare at once.
    seen = browser.script("""
      const done = studio.opened("pipe_tee.pl"), names = [];
      for (const port of studio.ports.ports) names.push(port.picture.shown);
      return done.then(() => [names, %s.picture.shown]);""" % PATTERN)
    check("nothing of the model before", seen == [[None] * 5, None], seen)
    browser.wait(QUIET)
    check("an edge of the new one", browser.script(NEAR))
    # The same model, changed: its pattern has names again when it is drawn.
    browser.script("""
      window.met = null;
      const near = () => { %s };
      studio.wire.addEventListener("revision", () => {});
      studio.change("edit", { set: { segment: 2, path: [1, 1], value: 0.7 } }).then(() => { window.met = [near()]; });
      """ % NEAR)
    check("none while it is of before", browser.wait("window.met") == [None],
          browser.script("return window.met"))
    check("and again", browser.wait(QUIET) and browser.script(NEAR))


def two_windows():
    """Of one document: the ports of both are drawn, and what is open is so in both."""
    first = browser.ask("GET", "/window")
    second = browser.ask("POST", "/window/new", {"type": "window"})["handle"]
    browser.ask("POST", "/window", {"handle": second})
    browser.open(front.address)
    check("another window", browser.wait(QUIET))
    browser.script("for (let i = 0; i < 12; i++) studio.ports.ports[0].turn(9, 0)")
    browser.ask("POST", "/window", {"handle": first})
    browser.script("for (let i = 0; i < 12; i++) studio.ports.ports[0].turn(-9, 0)")
    seen = []
    for window, file in ((first, "fig13.pl"), (second, "pipe_tee.pl")):
        browser.ask("POST", "/window", {"handle": window})
        browser.script("return studio.opened(arguments[0]).then(() => 1)", file)
        for one in (first, second):
            browser.ask("POST", "/window", {"handle": one})
            browser.wait("studio.file === arguments[0] && " + QUIET, file)
            seen.append(browser.script("""
              return [document.getElementById("file").textContent, studio.rev,
                studio.ports.ports[0].rev, // turned as each window likes
                ...studio.ports.ports.slice(1).map(({ rev, picture }) => [rev, picture.shown.strokes.length])];"""))
    check("both show the one, then the other", seen[0] == seen[1] != seen[2] and
          seen[2] == seen[3] and seen[0][0] == "fig13.pl", seen)
    browser.ask("DELETE", "/window")
    browser.ask("POST", "/window", {"handle": first})


def too_much():
    """More than a request may have is said, and ends nothing."""
    browser.script("studio.asking.set('x'.repeat(1100000)); studio.asking.ask()")
    check("too much", browser.wait(
        "document.querySelector('.answers .bad')?.textContent.length > 20") and
        browser.script("return studio.wire.open && !studio.wire.waiting.size"))
    browser.script("studio.asking.set(''); studio.asking.clear()")


def long_lines():
    """What goes on in the next line stands further in."""
    browser.script("studio.chosen(['s10e21'], studio.ports.ports[0])")
    browser.wait("document.querySelector('.why .step')")
    lines = browser.script("""
      studio.why.element.style.width = "12em"; // whatever the font
      return [...document.querySelectorAll(".why .step")].map((line) => {
        const range = document.createRange();
        const spaces = /^ */.exec(line.textContent)[0].length;
        range.selectNodeContents(line);
        if (line.firstChild.nodeType === 3) range.setStart(line.firstChild, Math.min(spaces, line.firstChild.length));
        const rows = new Map();
        for (const { x, y, width } of range.getClientRects()) if (width > 1) rows.set(Math.round(y / 8), Math.min(x, rows.get(Math.round(y / 8)) ?? x));
        return [...rows.values()];
      }).filter((rows) => rows.length > 1);""")
    check("long lines are hung", lines and all(
        x > rows[0] + 4 for rows in lines for x in rows[1:]), lines[:3])
    browser.script("studio.why.element.style.width = ''")


def found_words(language):
    browser.chord(CONTROL, "k")
    browser.wait("document.querySelector('.find input')")
    for typed, wanted in (("hid", "hidden_by/6"), ("may", "may_hide/2"),
                          ("con", "cone"), ("li", "line/9")):
        browser.script("const e = document.querySelector('.find input'); "
                       "e.value = arguments[0]; e.dispatchEvent(new "
                       "Event('input'))", typed)
        told = browser.wait("""[...document.querySelectorAll('.find li')].some(li => li.textContent
          .startsWith(arguments[0])) && [...document.querySelectorAll('.find li span')].map(e => e.textContent)""",
                            wanted) or []
        foreign = [text for text in told if ("(" not in text or ", or " in text)
                   and (language == "ko") != any("가" <= c <= "힣"
                                                 for c in text)]
        check("%s: %s: said in the language of the page" % (language, typed),
              foreign == [] and told, (foreign, told[:3]))
    browser.keys("\ue00c")


for language in ("en", "ko"):
    front = Front(program, models, "fig13.pl", (), env)
    browser = Browser(1440, 900, language)
    try:
        if language == "en":
            first_picture()
            pointed_at()
            without_a_line()
            sections()
            no_such_file()
            names_of_now()
            two_windows()
            too_much()
        else:
            browser.open(front.address)
            browser.wait(QUIET)
            browser.script("return studio.opened('pipe_tee.pl').then(() => 1)")
            browser.wait(QUIET)
        long_lines()
        found_words(language)
        complaints = browser.log()
        check("no complaint", complaints == [], complaints)
    finally:
        browser.end()
        front.end()
front = Front(program, models, "fig13.pl", (), env)
browser = Browser(390, 844, "en", mobile=True)
try:
    browser.open(front.address)
    browser.wait(QUIET)
    on_a_phone()
finally:
    browser.end()
    front.end()
checks.finish()
