"""models_test.py PROGRAM FOLDER: models of all kinds in the page, in a real
Chromium, in both languages: what is glued, what other programs wrote, formulas,
sheets that are rolled; and what is not as it should be."""
# covers: model, document, front, guard
import json
import os
import shutil
import sys
import time

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)),
                os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../cli")]
from browser import Browser  # noqa: E402
from front import Front  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
check = Checks()
models = os.path.join(folder, "models")
os.mkdir(models)
for name in ("figures/glue_face.pl", "fittings/tee.pl", "family.pl",
             "two_rooms.pl"):
    shutil.copy(os.path.join("facts", name), models)
shutil.copy("facts/cube.pl", os.path.join(models, "CUBE.PL"))
# The vertex that all faces of a corner but one have is not quite on the last.
with open(os.path.join(models, "house.city.json"), "w") as out:
    json.dump({"type": "CityJSON", "version": "2.0", "transform": {
        "scale": [0.001] * 3, "translate": [0] * 3}, "vertices": [
            [0, 0, 0], [4000, 0, 0], [4000, 3000, 0], [0, 3000, 0],
            [0, 0, 2500], [4000, 0, 2500], [4000, 3000, 2500],
            [0, 3000, 2509]], "CityObjects": {"house": {
                "type": "Building", "geometry": [{
                    "type": "Solid", "lod": "1", "boundaries": [[
                        [[3, 2, 1, 0]], [[4, 5, 6, 7]], [[0, 1, 5, 4]],
                        [[1, 2, 6, 5]], [[2, 3, 7, 6]], [[3, 0, 4, 7]]]]}]}}},
              out)
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
ROWS = "[...document.querySelectorAll('.tree .what')].map(e => e.textContent)"
SIZES = "[...document.querySelectorAll('.number span')].map(e => e.textContent)"
FIELD = "document.querySelector('.number input[type=number]')"
PLACE = """
  const { picture } = studio.ports.ports[0];
  const { points } = picture.shown.strokes.find((s) => s.whole);
  const { x, y } = new DOMPoint((points[0] + points[2]) / 2, (points[1] + points[3]) / 2)
    .matrixTransform(picture.svg.getScreenCTM());
  return [x, y];"""


def opened(name):
    browser.script("return studio.opened(arguments[0]).then(() => 1)", name)
    return browser.wait(
        "studio.ready && studio.file === arguments[0] && studio.ports.ports"
        ".slice(0, 1).every(p => !p.busy && p.element.dataset.rev === "
        "document.getElementById('ports').dataset.rev) && "
        "document.querySelector('.tree .row')", name)


def folded_up():
    browser.script("studio.ports.ports[0].turnTo('folded')")
    return browser.wait("Boolean(studio.ports.ports[0].folding?.faces) && "
                        "!studio.ports.ports[0].busy && document"
                        ".querySelector('.mine .sides')")


for language in ("en", "ko"):
    front = Front(program, models, "glue_face.pl", (), env)
    browser = Browser(1440, 900, language)

    def called(word, axis=""):
        korean = {"glue": "접합 연산", "box": "상자", "size": "크기"}
        own = korean[word] + axis + " " if language == "ko" else ""
        return own + word + axis

    def told(text, good, shown=None):
        check.check(language + ": " + text, good,
                    shown if shown is not None else browser.log())

    try:
        browser.open(front.address)
        told("all kinds are offered", browser.wait("studio.ready") and
             browser.script("return studio.models") == sorted(
                 os.listdir(models)))

        # What is glued hangs in the glue, and has its pattern, and sizes.
        told("glued", opened("glue_face.pl") and
             browser.script("return " + ROWS) == [
                 called("glue"), called("box"), called("box")],
             browser.script("return " + ROWS))
        browser.script("document.querySelectorAll('.tree .row')[1].click()")
        told("axes of a size", browser.wait(SIZES + ".length > 0") and
             browser.script("return " + SIZES) == [
                 called("size", " " + axis) for axis in "xyz"])
        browser.script("studio.ports.ports[0].turnTo('unfold')")
        told("the pattern of the glue, and of nothing else", browser.wait(
            "!studio.ports.ports[0].busy && studio.ports.ports[0].picture"
            ".shown.strokes.some(s => s.segment === 3)") and browser.script(
                "return document.querySelector('.port .tools select').hidden"))
        told("folded up", folded_up())
        browser.script("studio.ports.ports[0].turnTo('iso')")

        # What other programs wrote, and what is wrong with it.
        told("a city", opened("house.city.json") and
             browser.script("return studio.segments.length") == 1)
        warning = {"en": "not flat", "ko": "평평하지 않습니다"}[language]
        told("what is not flat is told", browser.wait(
            "!document.getElementById('banner').hidden && document"
            ".getElementById('banner').textContent.includes(arguments[0])",
            warning), browser.script(
                "return document.getElementById('banner').textContent"))
        told("another model has no warning", opened("family.pl") and
             browser.wait("document.getElementById('banner').hidden"))

        # A formula is the text's; a parameter has a slider.
        browser.script("document.querySelectorAll('.tree .row')[0].click()")
        told("no sizes within formulas", browser.wait(
            "document.querySelectorAll('.form h3').length === 2") and
             browser.script("return " + SIZES) == ["pipe", "branch", "lean",
                                                   "facets"],
             browser.script("return " + SIZES))

        # A rolled sheet stays flat, and says so.
        rolled = {"en": "rolled", "ko": "말아서"}[language]
        told("a fitting", opened("tee.pl") and folded_up())
        told("is rolled", browser.wait(
            "studio.ports.ports[0].remark.textContent.includes(arguments[0])",
            rolled), browser.script(
                "return studio.ports.ports[0].remark.textContent"))
        browser.script("studio.ports.ports[0].turnTo('unfold')")
        told("its pattern", browser.wait(
            "!studio.ports.ports[0].busy && studio.ports.ports[0].picture"
            ".shown && studio.ports.ports[0].picture.shown.strokes.some(s => "
            "s.whole)"))
        place = browser.script(PLACE)
        browser.pointer(tuple(place), "down", "up")
        told("a line of it is of the segment", browser.wait(
            "/^s[12]$/.test(document.querySelector('.chip strong')"
            ".textContent) && !document.querySelector('.why .bad')"),
            browser.script("return document.querySelector('.why')"
                           ".textContent"))
        browser.script("studio.ports.ports[0].turnTo('iso')")

        # A number that cannot be stays what it was; what was said of it goes.
        browser.script("document.querySelectorAll('.tree .row')[0].click()")
        for wrong in ("-5", ""):
            browser.wait(FIELD + "?.value === '168.3'")
            browser.script("const f = %s; f.value = arguments[0]; "
                           "f.dispatchEvent(new Event('change'))" % FIELD,
                           wrong)
            told("no number: " + wrong, browser.wait(
                FIELD + ".value === '168.3'"))
        told("told", browser.wait(
            "!document.getElementById('banner').hidden"))
        browser.script("const f = %s; f.value = '170'; "
                       "f.dispatchEvent(new Event('change'))" % FIELD)
        told("and not for ever", browser.wait(
            FIELD + ".value === '170' && document.getElementById('banner')"
            ".hidden"))

        # A picture says what it leaves out.
        opened("two_rooms.pl")
        browser.script("studio.ports.ports[0].turnTo('shaded')")
        told("what is not in a picture", browser.wait(
            "studio.ports.ports[0].more.textContent === '⚠' && !studio.ports"
            ".ports[0].more.hidden && studio.ports.ports[0].whole.length > 20")
             )
        browser.script("studio.ports.ports[0].turnTo('iso')")

        # An ending in capitals.
        told("capitals", opened("CUBE.PL") and browser.script(
            "return studio.isText"))
        browser.script("studio.wire.ask('text', { body: 'segment(1, solid, "
                       "box(size(1, 2, 3))).' }).then(({ head }) => "
                       "studio.edited(head))")
        told("can be changed", browser.wait(
            "JSON.stringify(studio.tree.model).includes('box')"))

        # What takes long can be stopped.
        browser.script("studio.asking.set('between(1, 1000000000, X), X < 0')"
                       "; studio.asking.ask()")
        told("what takes long can be stopped", browser.wait(
            "!studio.bar.stop.hidden && /\\d s$/.test(studio.bar.stop"
            ".textContent) && document.getElementById('state').textContent"
            " === arguments[0]",
            {"en": "working …", "ko": "계산 중 …"}[language], seconds=4))
        began = time.time()
        browser.script("studio.bar.stop.click()")
        told("stopped", browser.wait("Boolean(document.querySelector('.ask "
                                     ".bad'))") and
             time.time() - began < 3, time.time() - began)
        told("and goes on", browser.wait("studio.bar.stop.hidden") and
             browser.script("studio.asking.set('segment(S, _, _)'); "
                            "studio.asking.ask()") is None and
             browser.wait("document.querySelectorAll('.answers tbody tr')"
                          ".length === 1"))

        # A slow pattern that nobody waits for any more is stopped, alone: what
        # was asked before it is done.
        done = browser.script('''const ask = (...words) => studio.wire.ask(
          ...words).then(() => "done", ({ message }) => message);
          return Promise.all([
            ask("ask", { goal: "between(1, 3000000, X), X < 0" }),
            ask("text", { body: "segment(1, solid, box(size(1, 2, 4)))." }),
            ask("unfold", { segment: 1 }), ask("tree")])''')
        told("a pattern is stopped, no change", done == [
            "done", "done", "interrupted", "done"] and browser.script(
            "return studio.wire.ask('text').then(({ body }) => new "
            "TextDecoder().decode(body))") ==
            "segment(1, solid, box(size(1, 2, 4))).", done)
        told("nothing went wrong", browser.log() == [], browser.log())
    finally:
        browser.end()
        front.end()
        shutil.rmtree(env["XDG_STATE_HOME"], ignore_errors=True)
check.finish()
