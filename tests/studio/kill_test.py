"""kill_test.py PROGRAM FOLDER [SEED [KILLS]]: a page changes a model; the session,
the front or the page is killed at random moments. Nothing that was answered is
lost, and nothing is there that was not asked."""
# covers: front, visitor
import os
import random
import signal
import sys
import threading
import time

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)),
                os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../cli")]
from front import Front  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
kills = int(sys.argv[4]) if len(sys.argv) > 4 else 18
dice = random.Random(seed)
checks = Checks()
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
with open(os.path.join(folder, "box.pl"), "w") as out:
    out.write("param(a, 1000).\nsegment(1, solid, box(size(param(a), 1, 1))).\n")


def opened():
    page = front.page()
    head, _ = page.ask("open", file="box.pl")
    checks.check("opened again", "error" not in head, head)
    return page


def killed(who):
    """It happens in a thread, while the page changes the model."""
    time.sleep(dice.random() * 0.25)
    try:
        if who == "session":
            for session in front.sessions():
                os.kill(session, signal.SIGKILL)
        elif who == "front":
            front.process.kill()
        else:
            page.close()
    except OSError:
        pass


front = Front(program, folder, "box.pl", (), env)
page = opened()
value = answered = 1000
for i in range(kills):
    who = ("session", "front", "page")[i % 3]
    thread = threading.Thread(target=killed, args=(who,))
    thread.start()
    try:
        while True:
            value += 1
            head, _ = page.ask("edit", set={"param": "a", "value": value})
            if "error" in head:
                break
            answered = value
            if not thread.is_alive() and who == "page":
                break
    except (OSError, EOFError, ValueError):
        pass
    thread.join()
    page.close()
    if who == "front":
        front.process.wait()
        front.process.stdout.close()
        front.process.stderr.close()
        front = Front(program, folder, "box.pl", (), env)
    page = opened()
    text = page.ask("text")[1].decode()
    there = int(text.split("(a, ")[1].split(")")[0])
    checks.check("%s killed: answered %d, asked %d, there %d" % (
        who, answered, value, there), answered <= there <= value)
    value = answered = there
print("    %d changes, %d kills, seed %d" % (value - 1000, kills, seed))
page.close()
front.end(signal.SIGKILL)
checks.finish()
