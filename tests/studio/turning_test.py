"""turning_test.py PROGRAM FOLDER: a large model is turned by the graphics card
(web/turning.js), here by one that Chromium makes up; at rest the exact picture
is there, in the same place."""
# covers: scene_mesh_rows
import os
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
with open(os.path.join(models, "many.pl"), "w") as out:
    for i in range(64):
        out.write("segment(%d, solid, at([translate(%g, %g, 1000)], cylinder("
                  "radius(0.4), height(%g), facets(64)))).\n" % (
                      i + 1, 500 + i % 8, i // 8, 1 + i * 3 % 5 * 0.4))

# How many dots of the card's picture are as dark as ink, as grey as hidden lines,
# or free.
DOTS = """
  const {turning} = studio.ports.ports[0];
  turning.draw();
  const {gl, canvas} = turning, n = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, n);
  const count = [0, 0, 0];
  for (let i = 0; i < n.length; i += 4) count[n[i + 3] < 250 ? 2 : n[i] < 60 ? 0 : 1] += 1;
  return count;"""
# The box of what is drawn, as parts of the port: by the card, and exactly.
BOXES = """
  const port = studio.ports.ports[0], {turning, picture} = port;
  turning.draw();
  const {gl, canvas} = turning, [w, h] = [canvas.width, canvas.height];
  const n = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, n);
  const box = (points) => points.reduce(([a, b, c, d], [x, y]) =>
    [Math.min(a, x), Math.min(b, y), Math.max(c, x), Math.max(d, y)], [9, 9, -9, -9]);
  const by = [];
  for (let y = 0; y < h; y++) for (let x = 0; x < w; x++) {
    if (n[4 * (y * w + x) + 3] > 100) by.push([(x + .5) / w, 1 - (y + .5) / h]);
  }
  const m = picture.svg.getScreenCTM(), at = port.canvas.getBoundingClientRect(), exact = [];
  for (const {points} of picture.shown.strokes) for (let i = 0; i < points.length; i += 2) {
    const p = new DOMPoint(points[i], points[i + 1]).matrixTransform(m);
    exact.push([(p.x - at.x) / at.width, (p.y - at.y) / at.height]);
  }
  turning.leave();
  return [box(by), box(exact), w, h];"""
REST = "!studio.ports.ports[0].busy && !studio.ports.ports[0].canvas" \
       ".classList.contains('turns')"


def opened(gpu, *arguments):
    browser = Browser(arguments=arguments)
    browser.open(front.address.split("#")[0] + "icon.svg")
    browser.script("localStorage.setItem('ports', '[\"iso\"]')")
    if gpu:
        browser.script("localStorage.setItem('gpu', arguments[0])", gpu)
    browser.open(front.address)
    check("opened", browser.wait("studio.ports.ports[0].picture.shown",
                                 seconds=60), browser.log())
    browser.script("studio.ports.ports[0].canvas.focus()")
    return browser


def turn(browser, times=1, theta=7):
    """As where exact pictures take long, however fast this machine is."""
    browser.script("const port = studio.ports.ports[0]; port.took = 1000; "
                   "for (let i = 0; i < arguments[0]; i++) "
                   "port.turn(arguments[1], 1)", times, theta)


front = Front(program, models, "many.pl", env=env)
SOFT = ("--enable-unsafe-swiftshader", "--use-angle=swiftshader")
browser = opened("any", *SOFT)
check("there is a card", browser.script(
    "return Boolean(document.createElement('canvas').getContext('webgl2'))"))
turn(browser)
browser.wait("Boolean(studio.ports.ports[0].turning)")
turn(browser)
check("its model comes", browser.wait("studio.ports.ports[0].turning.mesh",
                                      seconds=30))
check("all of it", browser.script(
    "const {mesh} = studio.ports.ports[0].turning; return [mesh.at.length, "
    "mesh.corners, mesh.lines]") == [3 * 8192, 3 * 16128, 12288])
check("at rest", browser.wait(REST))
asked = "studio.wire.number"
check("turned by the card, and nothing is asked meanwhile", browser.script(
    """const port = studio.ports.ports[0], {number} = studio.wire;
    port.took = 1000;
    for (let i = 0; i < 20; i++) port.turn(3, 1);
    return port.turning.waiting > 0 && studio.wire.number === number"""))
ink, grey, free = browser.script(DOTS)
check("it is a picture", ink > 2000 and grey > 500 and free > 10 * ink,
      (ink, grey, free))
check("no error", browser.script(
    "return studio.ports.ports[0].turning.gl.getError()") == 0)
if os.environ.get("PICTURES"):
    browser.picture(os.path.join(os.environ["PICTURES"], "turning.png"))
check("at rest it is exact", browser.wait(REST))
if os.environ.get("PICTURES"):
    browser.picture(os.path.join(os.environ["PICTURES"], "turned.png"))
for angles in ([300, 65], [315, 0], [270, 90], [10, 120], [200, 175]):
    browser.script("""const port = studio.ports.ports[0];
      port.angles = arguments[0]; port.scale = null; port.refresh()""", angles)
    browser.wait(REST)
    browser.script("const port = studio.ports.ports[0]; port.scale = "
                   "port.picture.shown.place[0] / 1000")
    card, exact, wide, high = browser.script(BOXES)
    check("no jump: %s" % angles, all(
        abs(a - b) * n < 2.5 for a, b, n in zip(
            card, exact, (wide, high, wide, high))), (card, exact))
# Looked at nearer, it is in the same place too.
browser.script("studio.ports.ports[0].closer(0.5, 700, 400)")
card, exact, wide, high = browser.script(BOXES)
clipped = [max(0, n) for n in exact[:2]] + [min(1, n) for n in exact[2:]]
check("nearer", clipped != exact and all(
    abs(a - b) * n < 3 for a, b, n in zip(
        card, clipped, (wide, high, wide, high))), (card, exact))
browser.script("studio.ports.ports[0].fit()")
browser.wait(REST)

# A change is seen: the model of another revision is not turned.
browser.script("""return studio.change("edit", {set: {segment: 1,
  path: [2, 2, 1], value: 9}})""")
browser.wait(REST)
turn(browser)
check("another model comes", browser.wait(
    "Math.abs(studio.ports.ports[0].turning.mesh?.reach - 6.6) < 1",
    seconds=30), browser.script("return studio.ports.ports[0].turning.mesh"
                                "?.reach"))
browser.wait(REST)

# Without lines that are hidden.
browser.script("studio.looks.hidden = 'removed'")
browser.wait(REST)
_, less, _ = browser.script(DOTS)
check("hidden lines removed", less < grey / 2, (less, grey))
browser.script("delete studio.looks.hidden; studio.ports.ports[0].turning"
               ".leave()")

# The card may go.
browser.script("studio.ports.ports[0].turning.gl.getExtension("
               "'WEBGL_lose_context').loseContext()")
check("the card goes", browser.wait("studio.ports.ports[0].turning.lost"))
before = browser.script("return " + asked)
turn(browser)
check("the program draws then", browser.wait(REST) and browser.script(
    "return " + asked) > before and browser.script(
        "return studio.ports.ports[0].picture.shown.strokes.length") > 100)
log = [line for line in browser.log() if "favicon" not in line
       and "ReadPixels" not in line]
check("nothing is wrong", log == [], log)
browser.end()

# A card that is no faster than the program, or none: exact pictures alone.
for gpu, arguments in ((None, SOFT), ("none", SOFT), (None, ())):
    browser = opened(gpu, *arguments)
    before = browser.script("return " + asked)
    turn(browser, 3)
    check("exact alone: %s" % gpu, browser.wait(REST, seconds=30) and
          browser.script("return !studio.ports.ports[0].turning?.gl && " + asked)
          > before)
    browser.end()
front.end()
checks.finish()
