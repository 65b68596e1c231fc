"""link_test.py PROGRAM FOLDER: addresses that say what is seen; what is asked by
a double click or a finger that stays; what a reader without sight hears; and the
scale that a port keeps; in a real browser, in English and in Korean."""
import os
import struct
import sys

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
MODEL = """% Two boxes and a rod.
segment(1, solid, box(size(2, 3, 1))).
segment(2, solid, at([translate(0, 0, 1)], box(size(1, 1, 1)))).
segment(3, solid, at([translate(5, 0, 0)], cylinder(radius(0.5), height(4),
                                                    facets(8)))).
"""
with open(os.path.join(models, "plate.pl"), "w") as out:
    out.write(MODEL)
ENTER, RIGHT, LEFT, ESCAPE = "\ue007", "\ue014", "\ue012", "\ue00c"
DRAWN = ("studio.ready && studio.ports.ports.every((p) => p.slow || "
         "p.picture.shown && !p.busy)")
SPOKEN = "document.querySelector('#spoken[aria-live=polite]').textContent"
LABEL = "document.querySelectorAll('.port .canvas[role=img]')[%d]" \
        ".getAttribute('aria-label')"
# A point of a line that is nearer to no other one, in a port.
POINT = """
  const [i] = arguments, port = studio.ports.ports[i], { svg, shown } = port.picture;
  for (const { edges, points, closed } of shown.strokes) {
    if (!edges.length || closed) continue;
    for (const part of [0.5, 0.4, 0.6, 0.3, 0.7]) {
      const { x, y } = new DOMPoint(points[0] + part * (points[2] - points[0]),
        points[1] + part * (points[3] - points[1])).matrixTransform(svg.getScreenCTM());
      const found = port.near({ clientX: x, clientY: y });
      if (found && found.edge === edges[0] && found.role) return [x, y, found.name];
    }
  }"""

def told(*given):
    """The words of the page for a key."""
    return browser.script(
        "return import(new URL('words.js', document.querySelector('script')"
        ".src)).then(({ w }) => w(...arguments[0]))", given)


def goal_of(name):
    return browser.script("return studio.wire.ask('select', {names: "
                          "[arguments[0]]}).then(({head}) => "
                          "head.selected[0].goal)", name)


def asked_at(how):
    """The goal of a line comes into the box, whichever way it was asked for."""
    browser.script("document.getElementById('goal').value = ''")
    x, y, name = browser.script(POINT, 0)
    if how == "double click":
        browser.pointer((x, y), "down", "up", "down", "up")
    else:
        browser.touch(x, y, 0.9)
    check("%s: %s" % (language, how), browser.wait(
        "document.getElementById('goal').value === arguments[0]",
        goal_of(name)), browser.script(
            "return [arguments[0], document.getElementById('goal').value]",
            name))
    check("%s: %s: the keyboard is there" % (language, how), browser.script(
        "return document.activeElement.id") == "goal")


def heard():
    """What is said, and what the ports are called."""
    for i, kind in enumerate(("iso", "top", "front")):
        lines, hidden = browser.script("return studio.ports.ports["
                                       "arguments[0]].picture.counts()", i)
        wanted = told("drawing", told(kind), lines, hidden)
        label = browser.script("return " + LABEL % i)
        check("%s: a text of %s" % (language, kind), label.startswith(wanted)
              and str(lines) in label, (label, wanted))
        # The counts are those of what draw says.
        head, body = page.ask("view", format="strokes", size=[100, 80],
                              view=kind if kind != "iso" else browser.script(
                                  "return studio.ports.ports[0].angles"))
        words = struct.unpack("<%di" % (len(body) // 4), body)
        at, found = 0, []
        while at < len(words):
            found.append(head["looks"][words[at]][0])
            at += 5 + words[at + 3] + 2 * words[at + 4]
        check("%s: %s says what is drawn" % (language, kind), [
            len(found), found.count("hidden")] == [lines, hidden],
              (len(found), found.count("hidden"), lines, hidden))
    # From line to line: each is said, with its look.
    browser.script("studio.ports.ports[0].canvas.focus()")
    names = []
    for key in (ENTER, RIGHT, RIGHT, LEFT):
        browser.keys(key)
        name = browser.script("return studio.ports.ports[0].under.name")
        names.append(name)
        check("%s: %s is said" % (language, name), browser.wait(
            SPOKEN + ".startsWith(arguments[0])", told("line", name)),
              browser.script("return " + SPOKEN))
    check(language + ": there and back", names[1] == names[3] and
          names[0] != names[1], names)
    browser.keys(ENTER)
    check(language + ": why, as a text that is said", browser.wait(
        "document.querySelector('.why [aria-live=polite] pre')?.textContent"
        ".length > 20"))
    browser.keys(ESCAPE)
    browser.script("document.getElementById('goal').value = arguments[0]",
                   "member(X, [1, 2])")
    browser.keys(ENTER, "#goal")
    check(language + ": answers are said", browser.wait(
        SPOKEN + " === arguments[0]", told("answers", 2)),
          browser.script("return " + SPOKEN))
    browser.script("studio.save()")
    check(language + ": saved is said", browser.wait(
        SPOKEN + " === arguments[0]", told("saved")))


def kept_scale():
    """What was looked at closer stays where it is when a size changes."""
    browser.wait("document.getElementById('banner').hidden")
    browser.script("studio.ports.ports[2].canvas.focus()")
    browser.keys("++")
    browser.wait(DRAWN)
    where = """
      const { picture, scale } = studio.ports.ports[2], { place, strokes } = picture.shown;
      const [k, x, y, left, top] = place;
      const o = new DOMPoint(left - x * k, top + y * k).matrixTransform(picture.svg.getScreenCTM());
      return [o.x, o.y, k * picture.svg.getScreenCTM().a];"""
    browser.script("studio.ports.refresh()")
    browser.wait(DRAWN)
    before = browser.script("return (() => {%s})()" % where)
    revision = page.ask("edit", set={"segment": 3, "path": [2, 2, 1],
                                     "value": 9})[0]["rev"]
    check(language + ": of the model of now", browser.wait(
        "Number(studio.ports.ports[2].element.dataset.rev) === arguments[0] && "
        "studio.ports.ports[2].note.hidden && " + DRAWN, revision))
    after = browser.script("return (() => {%s})()" % where)
    check(language + ": the scale is kept", max(
        abs(a - b) for a, b in zip(before, after)) < 0.6, (before, after))
    browser.script("studio.ports.ports[2].canvas.focus()")
    browser.keys("0")
    browser.wait(DRAWN)
    fitted = browser.script("return (() => {%s})()" % where)
    check(language + ": it fits again", fitted[2] < after[2] * 0.8,
          (after, fitted))
    page.ask("undo")
    browser.wait("studio.ports.ports[2].element.dataset.rev == studio.rev && "
                 + DRAWN)


def told_again():
    """Who opens the address sees the same, in another browser too."""
    global browser
    browser.script("studio.ports.ports[0].canvas.focus()")
    browser.keys(LEFT + LEFT + "\ue013")
    browser.script("studio.ports.ports[1].turnTo('back')")
    browser.script("studio.looks.hidden = 'removed'; studio.looked()")
    browser.script("studio.chosen(['s1e3', 's2'])")
    check(language + ": the address says it", browser.wait(
        "location.hash.includes('chosen=s1e3,s2') && location.hash.includes("
        "';back;') && location.hash.includes('hidden=removed') && "
        "location.hash.includes('ports=iso@')"),
          browser.script("return location.hash"))
    browser.wait(DRAWN)
    seen = """return [studio.ports.ports.map((p) => p.link()), studio.looks.hidden,
      studio.names, studio.ports.ports[0].picture.counts()]"""
    address = browser.script("return location.href")
    secret = address.split("#")[1].split("&")[0]
    check(language + ": the secret is there", secret == front.token, address)
    before = browser.script(seen)
    log = browser.log()
    check(language + ": nothing is wrong", log == [], log)
    if os.environ.get("PICTURES"):
        browser.picture(os.path.join(os.environ["PICTURES"],
                                     "link-%s.png" % language))
    # The same window, without the secret: it knows it.
    browser.script("location.hash = location.hash.replace(arguments[0], '')"
                   ".replace(';back;', ';left;')", secret)
    check(language + ": another address, the same window", browser.wait(
        "studio.ports.ports[1].kind === 'left' && studio.names?.[0] === "
        "'s1e3' && " + DRAWN))
    browser.end()
    browser = Browser(language=language)
    browser.open(address.replace(secret, ""))
    check(language + ": nobody is let in by it", browser.wait(
        "!document.getElementById('banner').hidden") and not browser.script(
            "return studio.ready"))
    browser.open("about:blank")
    browser.open(address)
    browser.wait("studio.names?.length === 2 && " + DRAWN)
    after = browser.script(seen)
    check(language + ": the same is seen", after == before, (before, after))
    check(language + ": it is lit", browser.script(
        "return studio.ports.ports[0].picture.layers.chosen.getAttribute('d')"))
    browser.open("about:blank")
    browser.open(front.address + "&ports=nothing@x;front&hidden=7&chosen=zzz")
    check(language + ": what is no such address", browser.wait(DRAWN) and
          browser.script("return studio.ports.ports.map((p) => p.kind)") ==
          ["iso", "front"])


for language in ("en", "ko"):
    front = Front(program, models, "plate.pl", env=env)
    page = front.page()
    page.ask("open", file="plate.pl")
    browser = Browser(language=language)
    browser.open(front.address)
    browser.wait("studio.ready")
    browser.script("studio.ports.make(['iso', 'top', 'front']); "
                   "studio.ports.refresh()")
    check("opened " + language, browser.wait(DRAWN), browser.log())
    check(language + ": each port says what it shows", browser.script(
        "return [...document.querySelectorAll('.port option')].every((one) => "
        "one.textContent)"))
    # A name that was chosen in no picture: why, in the first one.
    browser.script("studio.ports.ports[0].angles = [120, 130]; "
                   "studio.chosen(['s1e3'])")
    head, body = page.ask("explain", item="hidden(1,3)", lang=language,
                          options=["--view", "120,130"])
    check(language + ": why, in the first picture", browser.wait(
        "document.querySelector('.why pre')?.textContent === arguments[0]",
        body[:head["stdout"]].decode().rstrip(), seconds=20),
          browser.script("return document.querySelector('.why pre')"
                         ".textContent"))
    browser.script("studio.ports.ports[0].turnTo('iso'); studio.chosen([])")
    browser.wait(DRAWN)
    asked_at("double click")
    asked_at("long press")
    heard()
    kept_scale()
    told_again()
    browser.end()
    page.close()
    front.end()
checks.finish()
