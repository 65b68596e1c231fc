"""states_test.py PROGRAM FOLDER: what the page says is so now: of the model that is
open, of its revision, and of the program; in a real Chromium."""
# covers: studio_words, document
import json
import math
import os
import re
import shutil
import subprocess
import sys
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
models = os.path.join(folder, "models")
os.mkdir(models)
for name in ("pipe_tee.pl", "figures/fig13.pl", "figures/glue_face.pl"):
    shutil.copy(os.path.join("facts", name), models)
with open(os.path.join(models, "drilled.pl"), "w") as file:
    file.write("""segment(1, solid, box(size(4, 4, 2))).
segment(2, solid, difference([1, cylinder(radius(1), height(9), facets(12))])).
view(300, 60, 0).
""")
TEE = os.path.join(models, "pipe_tee.pl")
with open(TEE) as file:
    TEXT = file.read()
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
ENTER, CONTROL, UP, DOWN, ESCAPE = (
    "\ue007", "\ue009", "\ue013", "\ue015", "\ue00c")
QUIET = "studio.ready && studio.ports.ports.every(p => !p.busy && " \
        "!p.canvas.classList.contains('empty'))"
ROW = "[...document.querySelectorAll('.tree .row')].find(r => " \
      "r.querySelector('b').textContent === arguments[0])"
RADIUS = "document.querySelector('.form input[type=number][aria-label*=radius]')"
WHY = "document.querySelector('.why pre')?.textContent || ''"
STATE = "document.getElementById('state').textContent"
BANNER = "document.getElementById('banner')"
TYPED = "const e = studio.%s; e.field.value = arguments[0]; " \
        "e.field.dispatchEvent(new Event('input'))"


# How far what the first port shades is from the lines of the same view, on each
# side, in dots of the screen.
SHADES = """
  const done = arguments[arguments.length - 1];
  const { picture } = studio.ports.ports[0], { image, shown, svg } = picture;
  const seen = new Image();
  seen.src = image.getAttribute("href");
  seen.decode().then(() => {
    const [wide, high] = [seen.naturalWidth, seen.naturalHeight];
    const one = Object.assign(document.createElement("canvas"), { width: wide, height: high }).getContext("2d");
    one.drawImage(seen, 0, 0);
    const { data } = one.getImageData(0, 0, wide, high), box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let y = 0, i = 3; y < high; y++) for (let x = 0; x < wide; x++, i += 4) if (data[i] > 127) {
      [x, y, x + 1, y + 1].forEach((n, k) => { box[k] = Math[k < 2 ? "min" : "max"](box[k], n); });
    }
    const [x, y, width, height] = ["x", "y", "width", "height"].map((name) => Number(image.getAttribute(name)));
    const lines = picture.around(shown.strokes), dot = svg.getScreenCTM().a;
    done(lines.map((n, k) => (n - (k % 2 ? y + box[k] * height / high : x + box[k] * width / wide)) * dot));
  }, (error) => done([String(error)]));"""


def shades():
    """Whether the lines of the first port lie on what it shades."""
    browser.wait(PAINTED)
    off = browser.ask("POST", "/execute/async", {"script": SHADES, "args": []})
    return all(isinstance(n, (int, float)) and abs(n) < 1.6 for n in off), off


PAINTED = """(({ kind, busy, picture: { image, shown } }) => kind === 'shaded' && !busy && shown
  && image.hasAttribute('href'))(studio.ports.ports[0])"""


def opened(name):
    browser.script("return studio.opened(arguments[0]).then(() => 1)", name)
    check(name + " is open", browser.wait(QUIET + " && studio.file === "
                                          "arguments[0]", name))


def asked(goal):
    browser.script("document.getElementById('goal').value = arguments[0]; "
                   "document.querySelector('.ask').requestSubmit()", goal)


def count(text):
    return browser.wait("document.querySelector('.ask .remark').textContent "
                        "=== arguments[0]", text)


def menus():
    """A menu that is closed says so, however it was closed."""
    expanded = "[...document.querySelectorAll('[aria-expanded][aria-haspopup]" \
               "')].filter(e => e.getAttribute('aria-expanded') === 'true')" \
               ".map(e => e.dataset.word)"
    for word in ("file", "menu", "rules"):
        browser.click("#bar [data-word=%s]" % word)
        check("one menu is open: " + word,
              browser.wait("String(%s) === arguments[0]" % expanded, word))
    browser.click(".tabs [data-word=tree]")
    check("no menu is open", browser.script("return " + expanded) == [])


def sizes():
    """A segment that another one places is reached in the tree. Undo that goes
    too far leaves what it undid in all panes."""
    for row in ("8", "7", "1"):
        browser.script(ROW.join(("return (", ").click()")), row)
    check("what is placed is reached", browser.wait(RADIUS + "?.value === '1'"))
    browser.script("studio.tree.drag = 1; studio.tree.set({ segment: 1, path: "
                   "[1, 1] }, 1.25)")
    check("its size is changed", browser.wait(RADIUS + ".value === '1.25' && "
                                              "!studio.tree.sets.length"))
    browser.script("for (let i = 0; i < 5; i++) studio.change('undo')")
    check("undone in the form too", browser.wait(
        "studio.tree.valueOf({ segment: 1, path: [1, 1] }) === 1 && " + RADIUS +
        ".value === '1'"))
    check("that no more is left is said", browser.wait(
        "!%s.hidden && %s.textContent.includes('no change is left')" %
        (BANNER, BANNER)))


def operand():
    """What is chosen in the tree and not drawn itself is lit by the edges that
    it made, in every port, also when they have other numbers."""
    lit = """studio.ports.ports.filter(({ kind }) => kind !== 'shaded')
      .map(({ picture }) => picture.layers.chosen.getAttribute('d').length)"""
    browser.script("studio.tree.choose(2, '/10/9/2', 0)")
    check("an operand is lit in every port", browser.wait(
        lit + ".every(n => n > 20)"), browser.script("return " + lit))
    bore = browser.script("return " + lit)
    whole = browser.script("""
      studio.light("chosen", ["s10"]);
      return """ + lit)
    check("and not all of the model", all(0 < a < b / 2 for a, b in zip(
        bore[2:], whole[2:])), (bore, whole))
    browser.script("studio.tree.choose(17, '/10/8/17', 0)")
    check("another one is lit", browser.wait(
        lit + ".every(n => n > 20) && %s.join() !== arguments[0]" % lit,
        ",".join(map(str, bore))))
    branch = browser.script("return [...studio.ports.ports[0].picture.lit"
                            ".chosen].length")
    browser.script("studio.tree.drag = 2; studio.tree.set({ segment: 8, path: "
                   "[2, 1, 2, 3, 1] }, 24)")
    check("and after a change", browser.wait(
        "!studio.tree.sets.length && %s && [...studio.ports.ports[0].picture"
        ".lit.chosen].length < arguments[0] - 50" % QUIET, branch))
    browser.script("studio.change('undo')")
    check("as before", browser.wait(
        QUIET + " && [...studio.ports.ports[0].picture.lit.chosen].length "
        "=== arguments[0]", branch))
    # A cylinder that stands in the term of segment 8 is no row of its own.
    row = "document.querySelector('.tree [data-key=\"/10/8/cylinder1\"]')"
    browser.script("studio.tree.choose(8, '/10/8', 1); studio.tree.open.add("
                   "'/10/8'); studio.tree.draw(); %s.click()" % row)
    check("an operand without a number is lit as that which it is",
          browser.wait("[...studio.ports.ports[0].picture.lit.chosen].length "
                       "=== arguments[0]", branch), branch)
    check("it is the one that is chosen", browser.script(
        "return [...document.querySelectorAll('.tree [aria-selected=true]')]"
        ".map(e => e.dataset.key)") == ["/10/8/cylinder1"])
    browser.script("studio.ports.ports[0].turnTo('section')")
    check("a section shows it too", browser.wait(
        QUIET + " && studio.ports.ports[0].picture.layers.chosen.getAttribute("
        "'d').length > 20"))
    shaded()
    shaded_by_hand()
    browser.script("studio.ports.ports[0].turnTo('iso')")
    several()
    browser.script("studio.ports.ports[0].turnTo('iso'); studio.chosen([])")
    check("nothing is lit", browser.wait(lit + ".every(n => n === 0)"))


def shaded():
    """A shaded picture lights the same lines where they are, in any projection,
    and is drawn again when it is looked at closer."""
    path = "return studio.ports.ports[0].picture.layers.chosen.getAttribute('d')"
    words = "return studio.ports.ports[0].words.find(w => w.startsWith(" \
            "'--window=')).slice(9).split(',').map(Number)"
    drawn = []
    for projection in ("parallel", "central"):
        for up in ("z", "y"):
            browser.script("Object.assign(studio.looks, { projection: "
                           "arguments[0], up: arguments[1] }); studio.looked(); "
                           "studio.ports.ports[0].turnTo('iso')", projection, up)
            browser.wait(QUIET)
            drawn.append(browser.script(path))
            browser.script("studio.ports.ports[0].turnTo('shaded')")
            good, off = shades()
            check("%s, %s up: shaded where the lines are" % (projection, up),
                  good, off)
            check("%s, %s up: what an operand made is lit there" % (
                projection, up), browser.script(path) == drawn[-1] != "")
    check("these are four pictures", len(set(drawn)) == 4)
    browser.script("studio.looks = {}; studio.looked()")
    shades()
    left, low, right, high = browser.script(words)
    browser.script("""
      const port = studio.ports.ports[0], { x, y, width, height } = port.canvas.getBoundingClientRect();
      port.closer(0.5, x + width / 4, y + height / 2);""")
    check("looked at closer it is drawn again", browser.wait("""
      (([l, b, r, t]) => Math.abs(r - l - arguments[0]) < 1e-6 && Math.abs(t - b - arguments[1]) < 1e-6 &&
        Math.abs(l - arguments[2]) < 1e-6)((() => { %s })())""" % words, (right - left) / 2,
        (high - low) / 2, left + (right - left) / 8), (left, low, right, high,
                                                       browser.script(words)))
    check("and lies where it is looked at", browser.wait(PAINTED + """ && (({ picture }) =>
      ["x", "y", "width", "height"].every((name, i) => Math.abs(picture.image.getAttribute(name) - picture.inSight()[i]) < 1))
      (studio.ports.ports[0])"""))


def shaded_by_hand():
    """In a shaded picture sizes are pulled, lines walked and asked for, as in one
    of lines."""
    knobs = "return [...studio.ports.ports[0].knobs.querySelectorAll('.knob')]" \
            ".map(e => e.getAttribute('d'))"
    seen = []
    for kind in ("iso", "shaded"):
        browser.script("studio.ports.ports[0].turnTo(arguments[0]); "
                       "studio.tree.choose(2, '/10/9/2', 0)", kind)
        browser.wait(QUIET + " && studio.handles.list.length && studio.ports"
                     ".ports[0].knobs.querySelector('.knob')")
        seen.append(browser.script(knobs))
    check("dots of a shaded picture are where they are without", seen[0] ==
          seen[1] != [], seen)
    radius = "studio.tree.valueOf({ segment: 2, path: [1, 1] })"
    was = browser.script("return " + radius)
    browser.script("studio.ports.ports[0].knobs.querySelector('[data-name="
                   "radius]').focus()")
    browser.keys(UP)
    check("and pull", browser.wait("%s > arguments[0] && !studio.tree.sets"
                                   ".length && %s" % (radius, QUIET), was))
    browser.script("return studio.change('undo').then(() => 1)")
    browser.wait(QUIET)
    browser.script("studio.ports.ports[0].canvas.focus()")
    spoken = "document.getElementById('spoken').textContent"
    browser.keys(ENTER)
    first = browser.wait("/s10e/.test(%s) && %s" % (spoken, spoken))
    browser.keys(DOWN)
    check("its lines are walked", browser.wait(
        "%s !== arguments[0] && studio.ports.ports[0].picture.layers.hover"
        ".getAttribute('d')" % spoken, first))
    # Another picture comes meanwhile: the walk begins anew.
    browser.script("studio.ports.ports[0].refresh()")
    browser.wait(QUIET)
    browser.keys(ENTER)
    check("after another picture too", browser.wait(
        "%s === arguments[0]" % spoken, first))
    browser.keys(ENTER)
    check("and asked for", browser.wait(
        "/s10e/.test(document.querySelector('.why .chip strong').textContent)"))
    x, y, name = browser.script("""
      const port = studio.ports.ports[0], box = port.canvas.getBoundingClientRect();
      for (let x = box.x + 20; x < box.right; x += 3) for (let y = box.y + 20; y < box.bottom; y += 3) {
        const found = port.near({ clientX: x, clientY: y }, 3);
        if (found && document.elementFromPoint(x, y).closest(".canvas") === port.canvas) return [x, y, found.name];
      }""")
    browser.pointer((x, y), "down", "up", "down", "up")
    check("a double click asks for its goal", browser.wait(
        "document.getElementById('goal').value.startsWith(arguments[0])",
        "e(%s, %s" % tuple(re.findall("[0-9]+", name))),
        (name, browser.script("return document.getElementById('goal').value")))
    # A port that is not on the screen is asked for nothing.
    check("nor does it end what is asked of a port that went", browser.script("""
      const port = studio.ports.ports[0];
      port.element.hidden = true;
      try {
        const { picture } = port;
        port.closer(0.5, 10, 10);
        port.pan(5, 5);
        return picture.pieceAt(10, 10).length === 0 && picture.near(10, 10) === null;
      } finally {
        port.element.hidden = false;
      }"""))
    # An image that is not shown any more is let go.
    browser.script("""
      window.let_go = [];
      window.made = [];
      const { createObjectURL, revokeObjectURL } = URL;
      URL.createObjectURL = (blob) => { const it = createObjectURL.call(URL, blob); window.made.push(it); return it; };
      URL.revokeObjectURL = (it) => { window.let_go.push(it); revokeObjectURL.call(URL, it); };""")
    browser.script("""
      const { picture } = studio.ports.ports[0], png = atob("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mNk+A8AAQUBAScY42YAAAAASUVORK5CYII=");
      const body = () => Uint8Array.from(png, (c) => c.charCodeAt(0)).buffer;
      return Promise.all([picture.paint(body()), picture.paint(body()), picture.paint(body())]).then(() => 1);""")
    check("and an image that another one came before", browser.script(
        "return window.made.length === 3 && window.made.slice(0, 2).every(one "
        "=> window.let_go.includes(one)) && !window.let_go.includes(window"
        ".made[2])"))
    browser.script("studio.asking.set(''); document.activeElement.blur()")


def several():
    """With Ctrl one more line is chosen, and one less."""
    browser.script("studio.chosen([])")
    browser.wait(QUIET)
    points = browser.script("""
      const port = studio.ports.ports[0], box = port.canvas.getBoundingClientRect(), found = new Map();
      for (let x = box.x + 20; x < box.right; x += 3) for (let y = box.y + 20; y < box.bottom; y += 3) {
        const name = port.near({ clientX: x, clientY: y }, 2)?.name;
        if (name && document.elementFromPoint(x, y).closest(".canvas") === port.canvas) found.set(name, [x, y, name]);
      }
      return [...found.values()].slice(0, 2);""")
    for many, (x, y, name) in enumerate([*points, points[0]]):
        browser.script("""
          const at = { bubbles: true, pointerId: 1, clientX: arguments[0], clientY: arguments[1], ctrlKey: arguments[2] };
          const { canvas } = studio.ports.ports[0];
          canvas.setPointerCapture = () => {};
          canvas.dispatchEvent(new PointerEvent("pointerdown", at));
          canvas.dispatchEvent(new PointerEvent("pointerup", at));""", x, y, many > 0)
        wanted = [[points[0][2]], [one[2] for one in points[:2]], [points[1][2]]]
        check("chosen: %d" % many, browser.script(
            "return studio.names") == wanted[many] and browser.wait(
                "String([...document.querySelectorAll('.why .chip strong')]"
                ".map(e => e.textContent)) === arguments[0]",
                ",".join(wanted[many])), wanted[many])
    browser.script("delete studio.ports.ports[0].canvas.setPointerCapture; "
                   "studio.chosen([]); studio.ports.ports[0].canvas.focus()")
    browser.keys(ENTER + ENTER)
    browser.wait("studio.names.length === 1")
    browser.keys(DOWN)
    browser.chord(CONTROL, ENTER)
    check("and by the keyboard", browser.wait(
        "new Set(studio.names).size === 2"))
    browser.keys(ESCAPE)
    browser.script("document.activeElement.blur(); studio.chosen([])")


def korean():
    """In Korean what the tree and the form say has its term, and the model's
    word beside it; names that the model gives stay."""
    browser.script("""studio.tree.choose(2, '/10/9/2', 0);
      document.querySelector('[data-word=language]').click()""")
    said = "[...document.querySelectorAll('%s')].map(e => e.textContent)"
    labels = browser.wait("studio.handles.list.length && (s => s.some(t => t "
                          ".startsWith('반지름')) && s)(%s)" %
                          said % ".form .number span")
    check("sizes in Korean", labels == [
        "반지름 radius", "높이 height", "작은 면 수 facets"], labels)
    rows = browser.script("return " + said % ".tree .what")
    check("kinds in Korean", "원기둥 cylinder" in rows and "inside" in rows, rows)
    heard = browser.wait("""(all => all.every(a => a.startsWith('반지름')) && all)(
      ['.form input', '.knob'].map(s => document.querySelector(s)
        ?.getAttribute('aria-label') || ''))""")
    check("and for who hears it", heard == ["반지름 (radius)"] * 2, heard)
    browser.script("document.querySelector('[data-word=language]').click()")
    check("in English by the word alone", browser.wait(
        "(%s)[0] === 'radius' && !document.querySelector('.tree small')" %
        said % ".form .number span"))
    browser.script("studio.tree.choose(10, '/10', 0); studio.chosen([])")


def reasons():
    """Why follows the model; of another one nothing is left."""
    browser.script("studio.ports.ports[0].turnTo('unfold')")
    browser.wait(QUIET)
    name = browser.script("""
      const { strokes, looks } = studio.ports.ports[0].picture.shown;
      const { segment, edges } = strokes.find((s) => s.edges.length && looks[s.look][1].startsWith('fold_'));
      const name = `s${segment}e${edges[0]}`;
      studio.chosen([name], studio.ports.ports[0], 'fold_up');
      return name;""")
    check("a fold is explained", browser.wait(WHY + ".includes(' is a fold ')"))
    browser.click(".why [data-word=cut]")
    check("cut, it is explained as a seam", browser.wait(
        WHY + ".includes(' is a seam ')"), name)
    asked("segment(S, solid, T), S < 3")
    check("answers", count("2 answers"))
    browser.script("return studio.leftTo('text')")
    browser.script(TYPED % "text", TEXT.replace("segment(2, solid, cyl",
                                                "segment(22, solid, cyl")
                   .replace("-3.5), rotate(y, 90)], 2)", "-3.5), rotate(y, 90)]"
                            ", 22)").replace("2]))).", "22]))).", 1))
    check("after a change they are asked again", count("1 answer"),
          browser.script("return studio.text.wrong.textContent"))
    browser.script("studio.change('undo'); studio.leftTo('tree')")
    check("and after undo", count("2 answers"))
    asked("between(1, 20000, X)")
    check("that answers are left out is said", count("the first 10000 answers"))
    asked("e(1, E, _, _, 77)")
    check("none are said in the table too", count("no answers") and
          browser.script("return document.querySelector('.answers')"
                         ".textContent") != "")
    browser.script("studio.tree.choose(1, '/1', 0); studio.chosen(['s10e1'], "
                   "studio.ports.ports[0])")
    browser.wait(WHY)
    opened("fig13.pl")
    check("another model: nothing is chosen, asked or explained",
          browser.script("return [studio.names.length, " + WHY + ", document"
                         ".querySelector('.answers').textContent, studio.tree"
                         ".segment ?? 0, studio.handles?.list.length ?? 0]") ==
          [0, "", "", 0, 0])
    browser.script("studio.looks.lines = 'all'; studio.looked(); studio.chosen("
                   "['s1e50'], studio.ports.ports[0])")
    check("explained as it is drawn", browser.wait(WHY) and "not drawn" not in
          browser.script("return " + WHY))
    browser.script("studio.looks.lines = 'feature'; studio.looked()")
    check("and as it is drawn now", browser.wait(
        WHY + ".includes('not drawn')"), browser.script("return " + WHY))
    check("what is chosen lies above what is pointed at", browser.script("""
      const { layers } = studio.ports.ports[0].picture;
      return Boolean(layers.hover.compareDocumentPosition(layers.chosen) & Node.DOCUMENT_POSITION_FOLLOWING);"""))


def rules():
    """Keep keeps what stands there; what is wrong is never kept."""
    browser.click(".tabs [data-word=rules]")
    browser.wait("document.querySelector('.decisions li')")
    browser.script(TYPED % "rules", "edge_rolle(_, _, _, _, outline).")
    check("a mistake", browser.wait("!studio.rules.wrong.hidden"))
    browser.click(".editor:not([hidden]) [data-word=discard]")
    check("what was never right is discarded", browser.wait(
        "studio.rules.field.value === '' && studio.rules.wrong.hidden"))
    browser.script("studio.ports.ports[0].turnTo('iso')")
    browser.script(TYPED % "rules", "edge_role(_, _, _, _, crease).")
    check("lines that changed their role", browser.wait(
        "document.querySelector('.counts .changed')?.textContent.match(/^[1-9]/)"
        " && studio.ports.ports[0].picture.layers.changed.getAttribute('d')"),
        browser.script("return [studio.rules.counts.textContent, studio.rules"
                       ".wrong.textContent]"))
    revision = browser.script("return studio.rev")
    browser.script(TYPED % "rules", "edge_role(_, _, _, _, crease")
    browser.wait("!studio.rules.wrong.hidden")
    check("counts are of what was tried", browser.script(
        "return studio.rules.counts.textContent") == "")
    browser.script("return studio.rules.end(true)")
    check("a mistake is not kept", browser.script(
        "return [studio.rev, studio.rules.wrong.hidden]") == [revision, False])
    browser.script("return studio.rules.end(false)")
    browser.click(".tabs [data-word=tree]")


def pictures():
    """A picture that is not there says why; none of before stands there. A bar of
    lengths is shown whole, or not."""
    opened("glue_face.pl")
    browser.script("studio.ports.ports[1].turnTo('unfold')")
    check("a warning is there to be read", browser.wait(
        "!studio.ports.ports[1].more.hidden"))
    browser.script("studio.ports.ports[1].more.click()")
    check("all of it", browser.script(
        "const { note, whole } = studio.ports.ports[1]; return !note.hidden && "
        "note.textContent === whole && whole.length > 40"))
    check("the bar is shown whole or not", browser.script("""
      return studio.ports.ports.filter(({ kind }) => kind === 'unfold').every(({ picture }) => {
        const { strokes, looks } = picture.shown, [left, , wide] = picture.box;
        const bar = strokes.filter(({ look }) => looks[look][1] === 'bar');
        const [from, , to] = picture.around(bar);
        return picture.svg.classList.contains('bare') ? getComputedStyle(picture.lines.querySelector('.bar')).display === 'none'
          : from >= left && to <= left + wide; });"""))
    browser.script("studio.ports.ports[0].turnTo('iso')")
    browser.wait(QUIET)
    browser.script("""
      const port = studio.ports.ports[0], was = studio.wire.ask;
      studio.wire.ask = (request, keys) => (request === 'view' && keys.port === port.name
        ? Promise.reject(Object.assign(new Error('x'), { head: { error: { words: { en: 'no such picture', ko: '' } } } }))
        : was.call(studio.wire, request, keys));
      window.was = was; port.turnTo('front');""")
    check("no picture: why", browser.wait(
        "studio.ports.ports[0].note.textContent === 'no such picture' && "
        "!studio.ports.ports[0].note.hidden"))
    check("nor that of before", browser.script(
        "return document.querySelectorAll('.port')[0].querySelectorAll("
        "'.lines path').length") == 0)
    browser.script("studio.wire.ask = window.was; studio.ports.ports[0]"
                   ".turnTo('iso')")
    browser.wait(QUIET)
    check("gone with the next one", browser.script(
        "return studio.ports.ports[0].note.hidden"))
    check("folded up, the port is filled", browser.script("""
      const port = studio.ports.ports[0];
      port.turnTo('folded'); return 1;""") and browser.wait(
          "studio.ports.ports[0].folding?.lines") and all(
              browser.script("""
      const { folding, canvas } = studio.ports.ports[0];
      folding.fold(arguments[0]);
      const all = folding.lines.flatMap(({ from, to }) => [from, to]);
      const wide = (k) => Math.max(...all.map((p) => p[k])) - Math.min(...all.map((p) => p[k]));
      return Math.max(wide(0) / canvas.clientWidth, wide(1) / canvas.clientHeight);""",
                             part) > 0.8 for part in (0, 0.5, 1)))


# Texts that are seen and have less than 4.5:1 to what is behind them (WCAG 2.2, 1.4.3).
FAINT = r"""
  const rgb = (c) => (c.match(/[\d.]+/g) || []).map(Number);
  const lum = (c) => { const [r, g, b] = c.map((n) => { n /= 255; return n <= .04045 ? n / 12.92 : ((n + .055) / 1.055) ** 2.4; }); return .2126 * r + .7152 * g + .0722 * b; };
  const over = (a, alpha, b) => a.slice(0, 3).map((n, i) => n * alpha + b[i] * (1 - alpha));
  const ground = (e) => { let c = [255, 255, 255]; const chain = []; for (let x = e; x; x = x.parentElement) chain.unshift(x);
    for (const x of chain) { const b = rgb(getComputedStyle(x).backgroundColor); const a = b.length > 3 ? b[3] : 1; if (b.length) c = over(b, a, c); } return c; };
  return [...document.querySelectorAll("body *")].filter((e) => e.offsetParent && [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim()) && !e.closest("[aria-disabled], :disabled, .paper, .unseen")).map((e) => {
    let fade = 1; for (let x = e; x; x = x.parentElement) fade *= Number(getComputedStyle(x).opacity);
    const under = ground(e), text = rgb(getComputedStyle(e).color);
    const [a, b] = [lum(over(text, (text[3] ?? 1) * fade, under)), lum(under)].sort((p, q) => q - p);
    return [(a + .05) / (b + .05), e.className || e.tagName, e.textContent.trim().slice(0, 20)];
  }).filter(([c]) => c < 4.5);"""


def contrast():
    """By day and by night; and at 200 % the page is as wide as its window."""
    for scheme in ("light", "dark"):
        browser.media(prefers_color_scheme=scheme)
        browser.script("studio.tree.choose(9, '/10/9', 2); studio.asking.set("
                       "'p(10, P, _)'); studio.asking.ask(); studio.chosen(["
                       "'s10e21'], studio.ports.ports[0])")
        browser.wait(QUIET + " && document.querySelector('.why pre') && "
                     "document.querySelector('.answers td')")
        for menu in (None, "menu", "sheets", "rules"):
            if menu:
                browser.click("#menu_" + menu)
                browser.wait("document.querySelector('#menu_%s + .menu:not("
                             "[hidden])')" % menu)
            faint = browser.script(FAINT)
            check("%s, %s: texts stand out" % (scheme, menu), faint == [], faint)
        browser.script("document.activeElement.blur()")
    browser.media()
    for width, height in ((720, 450), (960, 540)):
        browser.emulate("setDeviceMetricsOverride", width=width, height=height,
                        deviceScaleFactor=2, mobile=False)
        check("200 %%: %d" % width, browser.wait(
            "document.documentElement.scrollWidth <= innerWidth && [...document"
            ".querySelectorAll('#bar button')].filter(e => e.offsetParent)"
            ".every(e => e.getBoundingClientRect().right <= innerWidth + 1)"))
    browser.emulate("clearDeviceMetricsOverride")
    browser.script("studio.asking.set(''); studio.asking.clear(); "
                   "studio.chosen([])")
    browser.wait(QUIET)


def forced_colours():
    """What is chosen is seen in the colours of the reader too."""
    opened("fig13.pl")
    browser.media(forced_colors="active")
    browser.script("studio.tree.choose(1, '/1', 0); studio.ports.ports[0]"
                   ".turnTo('folded')")
    check("folded", browser.wait("studio.ports.ports[0].folding?.lines"))
    seen = browser.script("""
      const of = (css) => getComputedStyle(document.querySelector(css));
      const probe = document.body.appendChild(document.createElement("i"));
      probe.style.cssText = "forced-color-adjust: none; color: Highlight";
      const { color } = getComputedStyle(probe);
      probe.remove();
      return [color, of(".tree [aria-selected=true] > .row").backgroundColor, of(".mine .chosen").stroke];""")
    check("the colour of what is chosen", len(set(seen)) == 1, seen)
    browser.media()
    browser.script("studio.ports.ports[0].turnTo('iso')")
    browser.wait(QUIET)


def lengths(lines):
    """How long the lines of each look are together."""
    out = {}
    for *key, points in lines:
        pairs = list(zip(points[::2], points[1::2]))
        out[tuple(key)] = out.get(tuple(key), 0) + sum(
            math.dist(a, b) for a, b in zip(pairs, pairs[1:]))
    return out


def exports():
    """A drawing is exported as it is seen."""
    browser.script("""
      window.argv = [];
      const was = studio.wire.ask;
      studio.wire.ask = (request, keys) => {
        if (request === 'export') window.argv.push(keys.argv.join(' '));
        return was.call(studio.wire, request, keys);
      };
      window.was = was;""")
    told = []
    for looks, kind, more in (
            ("{}", "front", ""), ("{ hidden: 'removed', lines: 'all' }", "front", ""),
            ("{ projection: 'central' }", "iso", ""),
            ("{}", "apart", "studio.ports.ports[0].factor = 0.5; "),
            ("{ projection: 'central', lines: 'all' }", "section",
             "studio.ports.ports[0].angles = [300, 60]; studio.ports.ports[0]"
             ".at = 0.25; ")):
        browser.script("studio.looks = %s; studio.ports.ports[0].turnTo('%s'); "
                       "%sstudio.looked()" % (looks, kind, more))
        browser.wait(QUIET)
        browser.script("document.activeElement.blur(); window.argv = []; "
                       "studio.export('drawing', 'svg')")
        told.append(browser.wait("window.argv[0]"))
    eye = "--view 315.0000,54.7356"
    check("exported as it is seen", told == [
        "draw --view front",
        "draw --view front --hidden removed --lines all",
        "draw %s --projection central" % eye,
        "draw %s --explode 0.5 --hidden removed" % eye,
        "draw --view 300.0000,60.0000 --cutaway y=0.25 --hidden removed "
        "--lines all"], told)
    drawn = json.loads(subprocess.run(
        [program, *told[-1].split(), "fig13.pl", "--format", "json", "-o", "-",
         "-q"], cwd=models, stdout=subprocess.PIPE, check=True).stdout)
    # Where strokes end and whose they are depends on names, hatching on the scale.
    shown, scale = browser.script("""
      const { strokes, looks, place } = studio.ports.ports[0].picture.shown;
      return [strokes.map(({ look, points }) => [...looks[look], [...points]]), place[0]];""")
    seen = lengths((*key, points) for *key, points in shown)
    file = lengths((line["visibility"], line["role"],
                    [n for point in line["points"] for n in point])
                   for line in drawn["lines"])
    check("a section as it is seen", len(seen) > 4 and seen.keys() == file.keys()
          and all(abs(seen[key] / scale * drawn["scale"] / file[key] - 1) < 1e-3
                  for key in seen if key[1] != "hatching"), (seen, file))
    check("no export was refused", browser.script(
        "return %s.hidden" % BANNER))
    browser.script("studio.looks = {}; studio.wire.ask = window.was; "
                   "studio.ports.ports[0].turnTo('iso'); studio.looked()")


def files():
    """What another program wrote is told; what cannot be taken was not."""
    opened("pipe_tee.pl")
    browser.script("return studio.save({ force: true }).then(() => 1)")
    check("saved", browser.wait(STATE + " === 'saved'"))
    with open(TEE, "w") as out:
        out.write(TEXT.replace("radius(1.7)", "radius(1.9)"))
    check("a file that was taken is told", browser.wait(
        "!%s.hidden && %s.textContent.includes('its text was taken')" %
        (BANNER, BANNER)))
    with open(TEE, "w") as out:
        out.write("% nothing\n")
    check("a file that cannot be taken is told", browser.wait(
        BANNER + ".textContent.includes('the model is empty')"))
    check("and the model is not the file's", browser.wait(
        STATE + " === 'not saved'"), browser.script("return " + STATE))
    with open(TEE, "w") as out:
        out.write(TEXT)


def on_a_phone():
    """What takes long moves nothing: else patterns are asked without end."""
    browser.emulate("setDeviceMetricsOverride", width=390, height=844,
                    deviceScaleFactor=2, mobile=True)
    browser.wait("innerWidth === 390")
    high = "document.getElementById('bar').offsetHeight"
    browser.script("clearInterval(studio.watch)")
    sizes = browser.script("""
      const high = () => document.getElementById('bar').offsetHeight, was = high();
      studio.bar.stop.textContent = 'Stop · 88 s';
      studio.bar.stop.hidden = false;
      studio.state();
      return [was, high()];""")
    check("the bar is as high as before", sizes[0] == sizes[1], sizes)
    browser.script("studio.bar.stop.hidden = true; studio.state()")
    check("nor does it move", browser.script("return " + high) == sizes[0])
    browser.script("studio.paneTo('ports'); studio.chosen(['s10e1'], studio"
                   ".ports.ports[0])")
    tab = "document.querySelector('#panes [data-to=asking]').dataset.news"
    check("a phone says where the reason is", browser.wait(
        tab + " === 's10e1'"))
    browser.script("studio.paneTo('asking')")
    check("until it is read", browser.script("return %s === undefined" % tab))
    browser.script("studio.paneTo('ports')")
    browser.emulate("clearDeviceMetricsOverride")


def from_a_file():
    """A page that is a file lights what an operand made, also one without a
    number. What is refused while it is made is refused there too, and no more."""
    opened("drilled.pl")
    page = browser.script("""
      const was = studio.wire.ask, refused = [];
      studio.wire.ask = (request, keys = {}) => {
        const wanted = request + (keys.goal || keys.item || keys.pens || "");
        if (!/^(asknode\\(1,|explainedge|sheettrue|rules)/.test(wanted)) return was.call(studio.wire, request, keys);
        refused.push(wanted);
        return Promise.reject(Object.assign(new Error("refused"), { head: { error: { words: { en: "x", ko: "x" } } } }));
      };
      return studio.page().finally(() => { studio.wire.ask = was; window.refused = refused; });""")
    refused = browser.script("return window.refused")
    check("a file is made though some is refused", "<!doctype" in (page or "")
          and {"sheettrue", "rules", "asknode(1, _, Operands, _)"} <= set(
              refused), refused)
    path = os.path.join(models, "drilled.html")
    with open(path, "w", encoding="utf-8") as out:
        out.write(page)
    browser.open("file://" + path)
    browser.wait("studio.ready && studio.ports.ports[0].picture.shown")
    lit = "[...studio.ports.ports[0].picture.lit.chosen].length"
    browser.script("studio.tree.choose(1, '/2/1', 0)")
    check("an operand is lit in a file", browser.wait(lit + " > 10"))
    many = browser.script("return " + lit)
    browser.script("document.querySelector('.tree [data-key=\"/2/cylinder1\"]"
                   "').click()")
    check("and one without a number", browser.wait(
        "%s > 10 && %s !== arguments[0]" % (lit, lit), many), many)
    check("drawn too", browser.script("return studio.ports.ports[0].picture"
                                      ".layers.chosen.getAttribute('d').length")
          > 20)
    browser.script("studio.ports.ports[0].turnTo('shaded')")
    good, off = shades()
    check("shaded in a file, where its lines are", good, off)
    check("it lights the operand too", browser.script(
        "return studio.ports.ports[0].picture.layers.chosen.getAttribute('d')"
        ".length") > 20)
    browser.open(front.address)
    browser.wait(QUIET)


def ended():
    """A program that does not answer is told soon, and it is not `saved`."""
    browser.wait(QUIET)
    front.process.kill()
    check("the program is gone", browser.wait("!%s.hidden && %s.textContent"
                                              ".includes('does not answer')" %
                                              (BANNER, BANNER), seconds=1.6))
    check("nothing is saved", browser.wait(STATE + " === 'connecting …'"))


front = Front(program, models, "pipe_tee.pl", (), env)
browser = Browser(1440, 900, "en")
try:
    browser.open(front.address)
    check("open", browser.wait(QUIET), browser.log())
    menus()
    sizes()
    operand()
    korean()
    contrast()
    reasons()
    rules()
    pictures()
    forced_colours()
    exports()
    files()
    on_a_phone()
    from_a_file()
    check("no complaints", browser.log() == [])
    ended()
finally:
    browser.end()
    front.process.kill()
    front.process.communicate()
checks.finish()
