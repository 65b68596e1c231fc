"""matrix_test.py PROGRAM FOLDER: what people do in the page, in a real Chromium,
in both languages and on three screens: 1440 x 900, 1920 x 1080, a phone. A sample
of the six unless TEST_ALL is set. FOLDER has a picture of each step."""
# covers: studio_words, front, visitor
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
SCREENS = {"1440": (1440, 900), "1920": (1920, 1080), "phone": (390, 844)}
CASES = [(language, screen) for language in ("en", "ko") for screen in SCREENS]
if not os.environ.get("TEST_ALL"):
    CASES = [("en", "phone"), ("ko", "1920")]
ENTER, RIGHT, F6 = "\ue007", "\ue014", "\ue036"

# Buttons, choices and inputs that are seen, and where; whose text is cut off; who
# stands on whom.
SEEN = """
  const inside = (e) => { const r = e.getBoundingClientRect();
    return { name: (e.id || e.dataset.word || e.dataset.label || e.className || e.tagName) + "",
      text: e.textContent.trim(), x: r.x, y: r.y, right: r.right, bottom: r.bottom,
      cut: e.tagName === "BUTTON" && (e.scrollWidth > e.clientWidth + 1 || e.scrollHeight > e.clientHeight + 2) }; };
  const on = (e) => { const r = e.getBoundingClientRect();
    const at = document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2);
    return r.width > 0 && r.bottom > 0 && r.y < innerHeight && getComputedStyle(e).visibility !== "hidden" &&
      !(at && (e.contains(at) || at.contains(e))) && !e.closest(".task, .problems, .book, .tree, .panel, .lines, .why"); };
  const all = [...document.querySelectorAll("button, select, h2")].filter((e) => e.offsetParent);
  const { clientWidth } = document.documentElement;
  return { wide: document.documentElement.scrollWidth - innerWidth,
    out: all.concat([...document.querySelectorAll(".menu :is(p, label)")].filter((e) => e.offsetParent)).map(inside)
      .filter((e) => e.x < 0 || e.right > clientWidth + 1),
    cut: all.map(inside).filter((e) => e.cut), under: all.filter(on).map(inside) };"""
# Keys of a port, two that stand on one another.
APART = """
  const keys = [...studio.ports.ports[arguments[0]].element.querySelectorAll("figcaption :is(select, input, button)")]
    .filter((e) => e.offsetParent).map((e) => [e.className || e.getAttribute("aria-label"), e.getBoundingClientRect()]);
  return keys.flatMap(([one, a], i) => keys.slice(i + 1).filter(([, b]) =>
    Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1)
    .map(([other]) => [one, other]));"""
# Texts that are seen, of the page and not of a model.
TEXTS = """
  return [...document.querySelectorAll("#bar button, .tabs button, #panes button, h2, figcaption option, figcaption button, .menu button, .menu label, label, .quiet, .decisions li")]
    .filter((e) => e.offsetParent || e.tagName === "OPTION").map((e) => e.textContent.trim());"""
# In Korean these stay as they are; so do segments: 1 pyramid.
LATIN = re.compile(r"^(|[\W\d_]*|English|.*\.(pl|csg|stl|off|obj|ply)|[A-Za-z0-9_, .()-]*"
                   r"(radius|height|facets|size|cylinder|box|param|named|at|rotate|"
                   r"translate)[A-Za-z0-9_, .()-]*|A\d(-\w+)?|[xyz]|PDF|SVG|DXF|HPGL|"
                   r"PNG|EPS|JSON|STL|OBJ|OFF|PLY|FOLD|HTML|pdf|svg|dxf|hpgl|png|"
                   r"eps|json|stl|obj|off|ply|fold|html|pl|fig\d+(-\d+)?|Kim|[a-z]{1,2}|"
                   r"\d+ [a-z_]+)$")


def step(name, good=True, shown=None):
    """What was to be seen is; nothing is cut off, covered, or in the other
    language."""
    case = "%s %s: %s" % (language, screen, name)
    checks.check(case, good, shown if shown is not None else browser.log())
    seen = browser.script(SEEN)
    checks.check(case + ": as wide as the screen", seen["wide"] <= 0, seen)
    checks.check(case + ": nothing is outside", seen["out"] == [], seen["out"])
    checks.check(case + ": nothing is cut off", seen["cut"] == [], seen["cut"])
    checks.check(case + ": nothing is covered", seen["under"] == [] or
                 name.startswith("menu "), seen["under"])
    if language == "ko":
        other = [text for text in browser.script(TEXTS)
                 if not re.search("[가-힣]", text) and not LATIN.match(text)]
        checks.check(case + ": in Korean", other == [], other)
    browser.picture(os.path.join(folder, "%s-%s-%s.png" % (
        language, screen, re.sub(r"\W+", "-", name))))


def idle(port=0):
    return browser.wait("!studio.ports.ports[%d].busy && studio.ports.ports"
                        "[%d].picture.shown" % (port, port))


def until(goal):
    end = time.time() + 10
    while not goal():
        if time.time() > end:
            return False
        time.sleep(0.05)
    return True


def pane(name):
    if screen == "phone":
        browser.script("studio.paneTo(arguments[0])", name)


def kind(name):
    pane("ports")
    browser.script("studio.ports.ports[0].turnTo(arguments[0])", name)
    return browser.wait(
        "!studio.ports.ports[0].busy && !studio.ports.ports[0].canvas"
        ".classList.contains('empty')")


def one_port():
    """A phone shows one port, and steps to the others."""
    seen = "return studio.ports.ports.filter((port) => port.element." \
           "offsetParent).map((port) => port.name)"
    press = "document.querySelector('.alone .%s').click()"
    step("one port", browser.script(seen) == ["p0"])
    browser.script(press % "steps button:last-child")
    step("the next port", browser.script(seen) == ["p1"] and browser.script(
        "return studio.ports.focused().name") == "p1")
    browser.keys(F6)
    step("and the next by its key", browser.wait(
        "String((() => { %s })()) === 'p2'" % seen))
    for _ in range(3):
        browser.script(press % "steps button:first-child")
    step("and back, around the end", browser.script(seen) == ["p4"])
    browser.script(press % "large[data-label=larger]")
    step("all ports", len(browser.script(seen)) == 5 and idle(1))
    for port, shown in ((4, "all"), (0, "one")):
        if shown == "one":
            browser.script("studio.ports.enlarge(studio.ports.ports[0])")
        for one in ("section", "sheet", "folded"):
            browser.script("studio.ports.ports[arguments[0]].turnTo("
                           "arguments[1])", port, one)
            browser.wait("!studio.ports.ports[%d].busy" % port)
            step("%s of %s: keys stand beside one another" % (one, shown),
                 browser.script(APART, port) == [])
    browser.script("studio.ports.ports[4].turnTo('right'); "
                   "studio.ports.ports[0].turnTo('iso')")
    idle()


def flows():
    browser.open(front.address)
    step("opened", browser.wait("studio.ready") and idle())
    if screen == "phone":
        one_port()
    x, y, wide, high = browser.script(
        "const r = document.querySelector('.canvas').getBoundingClientRect();"
        " return [r.x, r.y, r.width, r.height]")
    angles = browser.script("return studio.ports.ports[0].angles")
    browser.pointer((x + 9, y + high - 9), "down", (x + 90, y + high - 30), "up")
    step("turned", idle() and browser.script(
        "return studio.ports.ports[0].angles") != angles)
    browser.script("studio.chosen(['s1e7'], studio.ports.ports[0], null)")
    pane("asking")
    step("why", browser.wait("document.querySelector('.why pre:not(.bad)')"))
    browser.script("document.querySelector('#asking input, #asking textarea')"
                   ".value = ''")
    browser.keys("hides(S1, S2), S1 \\== S2" + ENTER,
                 "#asking input, #asking textarea")
    step("asked", browser.wait(
        "document.querySelectorAll('.canvas .lit[d]').length && studio.asking"
        ".element.querySelector('td, li')"))
    pane("left")
    browser.script("studio.leftTo('tree')")
    browser.script("document.querySelector('#left [role=treeitem] button, #left "
                   ".tree button, #left [role=treeitem]').click()")
    text = page.ask("text")[1]
    slider = "#left input[type=range][aria-label*=radius]"
    there = browser.wait("document.querySelector('%s')" % slider)
    browser.keys(RIGHT, slider)
    step("a size", there and until(lambda: page.ask("text")[1] != text))
    browser.script("studio.change('undo')")
    step("undone", until(lambda: page.ask("text")[1] == text))
    browser.script("studio.leftTo('rules')")
    step("rules", browser.wait("studio.rules.element.querySelector('textarea')"))
    browser.script("studio.leftTo('text')")
    step("text", browser.wait("studio.text.element.querySelector('textarea')"
                              ".value.length > 40"))
    for name in ("section", "shaded", "sheet", "unfold", "folded"):
        step(name, kind(name))
    kind("iso")
    for menu in ("file", "menu", "solid", "unfolding", "sheets", "rules"):
        browser.click("#menu_" + menu)
        step("menu " + menu, browser.wait(
            "document.querySelector('#menu_%s + .menu:not([hidden])')" % menu))
        browser.click("#menu_" + menu)
    complaints = [line for line in browser.log() if "favicon" not in line]
    checks.check("%s %s: no complaints" % (language, screen),
                 complaints == [], complaints)


def a_class():
    """A teacher shows a picture to all; a pupil sees it, and answers again."""
    room = Front(program, os.path.join(here, "facts/problems"), "fig10.pl",
                 ("--problems", "collection.pl"), env)
    joined = room.process.stdout.readline().decode().strip()
    teacher = room.page()
    try:
        browser.open("about:blank")
        browser.open(joined)
        browser.wait("document.querySelector('#left input[list=pupils]')")
        browser.keys("Kim" + ENTER, "#left input[list=pupils]")
        pane("ports")
        browser.script("studio.problems.pose('fig10')")
        step("a problem", browser.wait(
            "studio.problems.reply && studio.ports.ports[0].picture.shown"))
        before = browser.script("return studio.ports.ports[0].kind")
        teacher.ask("open", file="fig10.pl")
        head, _ = teacher.ask("view", format="strokes", view=[40, 60],
                              size=[120, 90], shown=True)
        step("shown by the teacher", browser.wait(
            "studio.ports.ports[0].kind === 'taught' && studio.ports.ports[0]"
            ".picture.shown.strokes.length === arguments[0]", head["strokes"]))
        teacher.ask("show")
        step("and no more", browser.wait("studio.ports.ports[0].kind === "
                                         "arguments[0]", before))
        pane("left")
        for key in ("show_answer", "show_noted"):
            browser.script("studio.problems.task.querySelector('[data-word=%s]"
                           "').click()" % key)
        step("the answer, and not only that it is there", browser.wait(
            "studio.problems.reply.head.shows === 'answer' && "
            "studio.ports.ports[0].element.offsetParent"))
        browser.script("sessionStorage.clear()")
        browser.open("about:blank")
        browser.open(room.address)
        browser.wait("studio.ready")
        pane("ports")
        pupil = room.socket()
        pupil.say({"id": 0, "do": "hello", "token": joined.split("#")[1],
                   "pupil": "a" * 32})
        pupil.hear()
        idle()
        browser.script("document.querySelector('.port [data-word=show_all]')"
                       ".click()")
        checks.check("%s %s: a pupil hears of it" % (language, screen),
                     pupil.hear()[0] == {"event": "shown", "shown": True} and
                     pupil.ask("shown")[0].get("kind") == "strokes")
        step("the teacher", browser.script(
            "return document.querySelector('.port [data-word=show_all]')"
            ".getAttribute('aria-pressed') === 'true'"))
        browser.script("document.querySelector('.port [data-word=show_all]')"
                       ".click()")
        heard = pupil.hear()[0]
        while heard == {"event": "shown", "shown": True}:  # the port drew it anew
            heard = pupil.hear()[0]
        checks.check("%s %s: and that it ends" % (language, screen),
                     heard == {"event": "shown", "shown": False}, heard)
        pupil.close()
        checks.check("%s %s: no complaints of a class" % (language, screen),
                     browser.log() == [])
    finally:
        teacher.close()
        room.process.kill()
        room.process.communicate()


here = os.getcwd()
for language, screen in CASES:
    models = os.path.join(folder, language + screen)
    os.makedirs(models)
    with open(os.path.join(models, "tee.pl"), "w") as out:
        out.write(open("facts/figures/fig13.pl").read())
    env = dict(os.environ, XDG_STATE_HOME=os.path.join(models, "state"))
    front = Front(program, models, "tee.pl", (), env)
    page = front.page()
    browser = Browser(*SCREENS[screen], language, mobile=screen == "phone")
    try:
        flows()
        a_class()
    finally:
        browser.end()
        page.close()
        front.process.kill()
        front.process.communicate()
checks.finish()
