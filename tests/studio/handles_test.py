"""handles_test.py PROGRAM FOLDER: the dots of a picture that pull sizes and
placements, and Ctrl-K, in a real browser, in English and in Korean."""
import os
import re
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
os.makedirs(models)
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
MODEL = """% A bolt in a plate; comments stay.
segment(1, solid, at([rotate(z, 90), translate(1, 2, 0.5)],
                     box(size(2, 3, 1)))).
segment(2, solid, cylinder(radius(0.5), height(4), facets(24))).
segment(3, solid, named(pair, union([at([rotate(x, 90), translate(8, 0, 0)], 4),
                                     5]))).
segment(4, solid, cylinder(radius(1), height(2), facets(12))).
segment(5, solid, at([translate(8, 5, 0)], sphere(radius(1)))).
"""
with open(os.path.join(models, "plate.pl"), "w") as out:
    out.write(MODEL)
CONTROL, ENTER, ESCAPE, DOWN, UP, RIGHT = (
    "\ue009", "\ue007", "\ue00c", "\ue015", "\ue013", "\ue014")

# Pulls the knob NAME of port 0 by so many units of the picture along its axis.
PULL = """
  const [name, units, steps] = arguments, port = studio.ports.ports[0];
  const knob = () => [...port.knobs.querySelectorAll('.knob')].find((k) => k.dataset.name === name);
  const one = studio.handles.list.find((k) => k.name === name);
  const [t, p] = port.angles.map((n) => n * Math.PI / 180);
  const right = [-Math.sin(t), Math.cos(t), 0];
  const up = [-Math.cos(p) * Math.cos(t), -Math.cos(p) * Math.sin(t), Math.sin(p)];
  const of = (v) => v[0] * one.axis[0] + v[1] * one.axis[1] + v[2] * one.axis[2];
  const size = port.picture.shown.place[0] * port.picture.svg.getScreenCTM().a;
  const [x, y] = [100, 100], [dx, dy] = [of(right) * size * units, -of(up) * size * units];
  const at = (type, n, on) => on.dispatchEvent(new PointerEvent(type, {bubbles: true, pointerId: 1,
    clientX: x + dx * n, clientY: y + dy * n}));
  at('pointerdown', 0, knob());
  for (let i = 1; i <= steps; i++) at('pointermove', i / steps, window);
  at('pointerup', 1, window);"""
QUIET = "!studio.tree.sets.length && studio.ports.ports.every((p) => !p.busy)"
KNOBS = "[...studio.ports.ports[0].knobs.querySelectorAll('.knob')]" \
        ".map((k) => k.dataset.name)"


def text():
    return browser.script("""return studio.wire.ask('text').then(({body}) =>
      new TextDecoder().decode(body))""")


def choose(segment, names):
    browser.script("studio.tree.choose(arguments[0], '/' + arguments[0], 0)",
                   segment)
    check("knobs of %d" % segment, browser.wait(
        "%s.sort().join() === arguments[0]" % KNOBS, ",".join(sorted(names))),
          browser.script("return " + KNOBS))
    browser.wait(QUIET)


def pulled(segment, name, units, before, after, near=0.03):
    """One number of the text is another one, about as far as the dot was pulled;
    one undo takes all of it back."""
    was = text()
    browser.script(PULL, name, units, 5)
    browser.wait(QUIET)
    browser.wait("studio.ports.ports[0].element.dataset.rev == studio.rev")
    now = text()
    match = re.fullmatch(re.escape(was).replace(
        re.escape(before), re.escape(before.split("@")[0]), 1), was)
    parts = was.split(before)
    check("%s is there" % before, len(parts) == 2 and match, was)
    left, right = after.split("#")
    found = re.fullmatch(re.escape(parts[0] + left) + r"(-?[\d.]+)" +
                         re.escape(right + parts[1]), now)
    check("%d: %s pulled" % (segment, name), found, now)
    if found:
        number = float(re.search(r"-?[\d.]+", before[len(left):]).group())
        check("%d: %s as far as it was pulled" % (segment, name), abs(
            float(found.group(1)) - number - units) < near, found.group(1))
    browser.script("return studio.change('undo')")
    browser.wait(QUIET)
    check("%d: %s: one undo" % (segment, name), text() == was, text())


def found(typed, *wanted):
    """What Ctrl-K lists for these letters; it is left open."""
    browser.wait("!document.querySelector('dialog')")
    browser.chord(CONTROL, "k")
    check("it is open", browser.wait(
        "document.querySelector('dialog.find[open] input') === "
        "document.activeElement"))
    browser.keys(typed, "dialog.find input")
    for word in wanted:
        check("found: " + word, browser.wait(
            "[...document.querySelectorAll('.find li')].some((li) => "
            "li.textContent.includes(arguments[0]))", word), typed)


for language in ("en", "ko"):
    said = {"en": {"undo": "Undo", "view": "View: front", "svg": "svg",
                   "hidden": "Hidden lines", "text": "Text"},
            "ko": {"undo": "실행 취소", "view": "보기: 정면도", "svg": "svg",
                   "hidden": "숨은선", "text": "텍스트"}}[language]
    front = Front(program, models, "plate.pl", env=env)
    browser = Browser(language=language)
    browser.open(front.address)
    check("opened " + language, browser.wait(
        "studio.ports.ports[0].picture.shown", seconds=60), browser.log())
    choose(1, ["size x", "size y", "size z", "translate x", "translate y",
               "translate z"])
    if os.environ.get("PICTURES"):
        browser.picture(os.path.join(os.environ["PICTURES"],
                                     "handles-%s.png" % language))
    pulled(1, "translate x", 1.5, "translate(1, 2", "translate(#, 2")
    pulled(1, "size z", 0.75, "size(2, 3, 1)", "size(2, 3, #)")
    pulled(1, "size x", 1, "size(2, 3", "size(#, 3")
    choose(2, ["radius", "height"])
    pulled(2, "height", -1, "height(4)", "height(#)")
    pulled(2, "radius", 0.25, "radius(0.5)", "radius(#)")
    choose(4, ["radius", "height"])         # where the tree puts it
    pulled(4, "height", 0.5, "height(2), facets(12)", "height(#), facets(12)")
    axis = browser.script("return studio.handles.list.find((one) => one.name "
                          "=== 'height')")
    check("turned with its operand", all(abs(a - b) < 1e-9 for a, b in zip(
        axis["axis"], [0, -1, 0])) and all(abs(a - b) < 1e-9 for a, b in zip(
            axis["at"], [8, -2, 0])), axis)
    choose(5, ["radius", "translate x", "translate y", "translate z"])
    browser.script("studio.tree.choose(3, '/3', 0)")
    check("no knobs of a union", browser.wait("%s.length === 0" % KNOBS))
    # By the keyboard.
    choose(2, ["radius", "height"])
    browser.script("[...studio.ports.ports[0].knobs.querySelectorAll('.knob')]"
                   ".find((k) => k.dataset.name === 'height').focus()")
    browser.keys(UP)
    browser.wait("studio.handles.list.find((one) => one.name === 'height')"
                 "?.value === 4.1")
    browser.wait(QUIET)
    browser.keys(DOWN + DOWN)
    check("by the arrow keys", browser.wait(
        "studio.handles.list.find((one) => one.name === 'height')?.value "
        "=== 3.9"), text())
    browser.wait(QUIET)
    browser.wait("document.activeElement.getAttribute('aria-valuenow') == 3.9")
    knob = browser.script("const k = document.activeElement; return "
                          "[k.dataset.name, k.getAttribute('role'), "
                          "k.getAttribute('aria-valuenow')]")
    check("a slider that stays where it is", knob == ["height", "slider",
                                                      "3.9"], knob)
    # However slow the program answers, each key counts, and each number.
    browser.script("""const { wire } = studio, heard = wire.heard.bind(wire);
      wire.heard = (data) => setTimeout(() => heard(data), 150);""")
    for i in range(12):
        browser.keys(UP)
        time.sleep(0.02 + 0.05 * (i % 4))
    browser.wait(QUIET)
    check("each key counts", "height(5.1)" in text(), text())
    check("the dot is where it is", browser.wait(
        "document.activeElement.getAttribute('aria-valuenow') == 5.1"))
    browser.keys(DOWN * 3)
    browser.script("[...studio.ports.ports[0].knobs.querySelectorAll('.knob')]"
                   ".find((k) => k.dataset.name === 'radius').focus()")
    browser.keys(UP * 2)
    browser.chord(CONTROL, "z")
    browser.wait(QUIET)
    check("each number counts, and undo has its place", browser.wait(
        "!studio.queued") and re.search(
            r"radius\(0.51?\), height\(4.8\)", text()), text())
    browser.script("document.querySelector('.form input[type=range]')"
                   ".focus()")
    was = float(re.search(r"radius\((0.5\d*)\), height", text()).group(1))
    for i in range(8):
        browser.keys(RIGHT)
        time.sleep(0.02 + 0.05 * (i % 3))
    browser.wait(QUIET)
    check("the keys of a slider count", "radius(%g), height" % (
        was + 0.008) in text(), (was, text()))
    check("a slider keeps the keyboard", browser.script(
        "return document.activeElement === document.querySelector("
        "'.form input[type=range]')"))
    browser.script("delete studio.wire.heard")
    # Nor is lost what is done while the program does not hear.
    browser.script("[...studio.ports.ports[0].knobs.querySelectorAll('.knob')]"
                   ".find((k) => k.dataset.name === 'height').focus()")
    was = float(re.search(r"height\((4.\d*)\), facets\(24", text()).group(1))
    browser.script("""studio.wire.wait = 1500; studio.wire.socket.close();
      for (let i = 0; i < 3; i++) document.activeElement.dispatchEvent(
        new KeyboardEvent('keydown', {key: 'ArrowUp', bubbles: true}));""")
    check("it waits for the program", browser.wait(QUIET) and
          "height(%g), facets(24" % (was + 0.3) in text(), (was, text()))
    browser.script("[...studio.ports.ports[0].knobs.querySelectorAll('.knob')]"
                   ".find((k) => k.dataset.name === 'height').focus()")
    # Ctrl-K.
    found(said["undo"].lower(), said["undo"])
    browser.keys(ENTER)
    check("closed", browser.wait("!document.querySelector('dialog')"))
    check("done", browser.wait("studio.rev && !studio.line?.then ? true : "
                               "studio.line.then(() => true)"))
    browser.wait("studio.handles.list.find((one) => one.name === 'height')"
                 "?.value !== 3.9")
    check("undone by it", "height(3.9)" not in text(), text())
    found(said["view"], said["view"])
    browser.keys(ENTER)
    check("another view", browser.wait(
        "studio.ports.ports.some((p) => p.kind === 'front' && "
        "p === studio.ports.ports[0])"))
    found("drawn", "drawn/7")
    if os.environ.get("PICTURES"):
        browser.picture(os.path.join(os.environ["PICTURES"],
                                     "find-%s.png" % language))
    browser.wait("""(() => { const li = [...document.querySelectorAll('.find li')]
      .find((li) => li.textContent.startsWith('drawn/7')); li?.click();
      return li; })()""")
    check("a predicate", browser.script(
        "return document.getElementById('goal').value") == "drawn(")
    found("s2e7", "s2e7")
    browser.keys(ENTER)
    check("a name is chosen", browser.wait("studio.names?.[0] === 's2e7'"))
    found("pair", "s3 ")
    browser.keys(ENTER)
    check("a segment", browser.wait("studio.tree.segment === 3"))
    found("zzzz")
    check("nothing", browser.script(
        "return document.querySelectorAll('.find li').length") == 0)
    browser.keys(ENTER)
    found(said["hidden"], said["hidden"])
    first = browser.script("return document.querySelector('.find "
                           "[aria-selected=true]').textContent")
    browser.keys(DOWN)
    second = browser.script("return document.querySelector('.find "
                            "[aria-selected=true]').textContent")
    check("from one to the next", first != second and said["hidden"] in second)
    browser.keys(ESCAPE)
    check("left", browser.wait("!document.querySelector('dialog')"))
    # One to six ports, and the two monitors as two windows.
    for count in (1, 2, 3, 4, 6, 5):
        browser.click("#menu_menu")
        browser.wait("document.querySelector('#menus .menu:not([hidden])')")
        browser.script("""[...document.querySelectorAll('.menu:not([hidden]) .named button')]
          .find((e) => e.textContent === String(arguments[0])).click()""", count)
        check("%d ports" % count, browser.wait(
            "studio.ports.ports.length === arguments[0] && studio.ports.ports"
            ".filter(({slow}) => !slow).every((p) => p.picture.shown)", count,
            seconds=30))
        room = browser.script("""const r = [...document.querySelectorAll('.port')]
          .map((p) => p.getBoundingClientRect()), all = document.getElementById('ports').getBoundingClientRect();
          const over = r.some((a, i) => r.some((b, j) => i < j && a.x < b.right - 1 && b.x < a.right - 1 &&
            a.y < b.bottom - 1 && b.y < a.bottom - 1));
          return [over, r.reduce((sum, a) => sum + a.width * a.height, 0) / (all.width * all.height)]""")
        check("%d ports fill their half" % count, room[0] is False and
              room[1] > 0.94, room)
    first = browser.ask("GET", "/window")
    browser.click("#menu_menu")
    browser.wait("document.querySelector('#menus .menu:not([hidden])')")
    browser.click(".menu:not([hidden]) > :last-child button")
    second = [one for one in browser.ask("GET", "/window/handles")
              if one != first]
    check("another window", len(second) == 1)
    check("the ports went", browser.wait(
        "document.getElementById('ports').offsetParent === null && "
        "document.getElementById('asking').offsetParent"))
    browser.ask("POST", "/window", {"handle": second[0]})
    check("are there", browser.wait(
        "studio.ports?.ports[0].picture.shown && document.getElementById("
        "'left').offsetParent === null", seconds=40))
    browser.script("studio.chosen(['s1e3'])")
    if os.environ.get("PICTURES"):
        browser.picture(os.path.join(os.environ["PICTURES"], "half-ports-%s"
                                     ".png" % language))
    browser.ask("POST", "/window", {"handle": first})
    check("what is chosen there is told here", browser.wait(
        "document.querySelector('.why').textContent.includes('s1e3')"),
        browser.script("return document.querySelector('.why').textContent"))
    if os.environ.get("PICTURES"):
        browser.picture(os.path.join(os.environ["PICTURES"], "half-left-%s"
                                     ".png" % language))
    # That window is closed; then the other half is in a window of its own.
    browser.ask("POST", "/window", {"handle": second[0]})
    browser.ask("DELETE", "/window")
    browser.ask("POST", "/window", {"handle": first})
    check("both halves are here again", browser.wait(
        "document.getElementById('ports').offsetParent && document.getElementById"
        "('left').offsetParent && studio.ports.ports[0].picture.shown"))
    browser.click("#menu_menu")
    browser.wait("document.querySelector('#menus .menu:not([hidden])')")
    browser.click(".menu:not([hidden]) > :last-child button:last-child")
    second = [one for one in browser.ask("GET", "/window/handles")
              if one != first]
    check("the tree went", len(second) == 1 and browser.wait(
        "document.getElementById('left').offsetParent === null && "
        "document.getElementById('ports').offsetParent"))
    browser.ask("POST", "/window", {"handle": second[0]})
    check("is there", browser.wait(
        "studio.tree?.byNumber && studio.ready && document.getElementById("
        "'ports').offsetParent === null && document.getElementById('left')"
        ".offsetParent", seconds=40))
    browser.ask("POST", "/window", {"handle": first})
    browser.script("studio.chosen(['s2e3'], studio.ports.ports[0]); "
                   "studio.askAbout('s2e3')")
    browser.ask("POST", "/window", {"handle": second[0]})
    check("it says why, and has the goal", browser.wait(
        "document.querySelector('.why').textContent.includes('s2e3') && "
        "document.getElementById('goal').value.startsWith('e(2, 3')"),
        browser.script("return document.querySelector('.why').textContent"))
    browser.script("studio.tree.choose(2, '/2', 0)")
    browser.click("#menu_menu")
    browser.wait("document.querySelector('#menus .menu:not([hidden])')")
    browser.keys("\ue011" + DOWN + ENTER)
    if os.environ.get("PICTURES"):
        browser.picture(os.path.join(os.environ["PICTURES"], "half-tree-%s"
                                     ".png" % language))
    browser.ask("POST", "/window", {"handle": first})
    check("its menus are done where the ports are", browser.wait(
        "studio.ports.focused().kind === 'front'"),
        browser.script("return studio.ports.focused().kind"))
    check("what is chosen in its tree is lit, with dots", browser.wait(
        "studio.ports.ports.some(({ picture }) => picture.layers.chosen"
        ".getAttribute('d').length > 8) && studio.handles.list.length"))
    browser.script("document.querySelector('[data-word=language]').click()")
    browser.ask("POST", "/window", {"handle": second[0]})
    check("one language in both", browser.wait(
        "document.documentElement.lang !== arguments[0]", language))
    browser.script("document.querySelector('[data-word=language]').click()")
    browser.ask("DELETE", "/window")
    browser.ask("POST", "/window", {"handle": first})
    check("and again here", browser.wait(
        "document.getElementById('left').offsetParent && "
        "document.documentElement.lang === arguments[0]", language))
    log = [line for line in browser.log() if "favicon" not in line]
    check("nothing is wrong", log == [], log)
    browser.end()
    front.end()
    for name in os.listdir(os.path.join(folder, "state", "sanggwan")):
        path = os.path.join(folder, "state", "sanggwan", name)
        if os.path.isfile(path):
            os.remove(path)
checks.finish()
