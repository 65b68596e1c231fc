"""kill_browser_test.py PROGRAM FOLDER [SEED [KILLS]]: a page in a real Chromium
changes a model; the browser is killed at random moments, and another one opens
the page. Nothing that the page heard of is lost."""
# covers: front, visitor, journal
import os
import random
import signal
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
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
kills = int(sys.argv[4]) if len(sys.argv) > 4 else (
    30 if os.environ.get("TEST_ALL") else 4)
dice = random.Random(seed)
checks = Checks()
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
with open(os.path.join(folder, "box.pl"), "w") as out:
    out.write("param(a, 1000).\nsegment(1, solid, box(size(param(a), 1, 1))).\n")
EDIT = """return studio.wire.ask("edit", { set: { param: "a", value: arguments[0] } })
  .then(({ head }) => head.rev);"""


def killed(browser):
    time.sleep(dice.random() * 0.8)
    for pid in subprocess.run(["pgrep", "-P", str(browser.driver.pid)],
                              stdout=subprocess.PIPE, text=True,
                              check=False).stdout.split():
        os.kill(int(pid), signal.SIGKILL)


front = Front(program, folder, "box.pl", (), env)
value = answered = 1000
for i in range(kills):
    browser = Browser()
    browser.open(front.address)
    checks.check("it opens", browser.wait("studio.ready"), browser.log())
    text = browser.script("return studio.wire.ask('text').then(({ body }) => "
                          "new TextDecoder().decode(body))")
    there = int(text.split("(a, ")[1].split(")")[0])
    checks.check("answered %d, asked %d, there %d" % (answered, value, there),
                 answered <= there <= value)
    checks.check("the page shows it", browser.wait(
        "studio.ports.ports[0].picture.shown && !studio.ports.ports[0].busy"))
    value = answered = there
    thread = threading.Thread(target=killed, args=(browser,))
    thread.start()
    try:
        while True:
            value += 1
            browser.script(EDIT, value)
            answered = value
    except (RuntimeError, OSError, ValueError):
        pass
    thread.join()
    browser.driver.kill()
    browser.driver.wait()
    browser.driver.stdout.close()
page = front.page()
page.ask("open", file="box.pl")
there = int(page.ask("text")[1].decode().split("(a, ")[1].split(")")[0])
checks.check("at last: answered %d, asked %d, there %d" % (
    answered, value, there), answered <= there <= value)
checks.check("something was changed", there > 1000 + kills, there)
print("    %d changes, %d browsers killed, seed %d" % (there - 1000, kills, seed))
page.close()
front.end(signal.SIGKILL)
checks.finish()
