"""limit_test.py PROGRAM FOLDER: line 10 of what guards the studio: how much a
visitor may use, and that no message names a folder of this machine. And what a
teacher shows to all."""
# covers: visitor, visitor_path, process_limit
import glob
import http.client
import json
import math
import os
import subprocess
import sys
import time

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)),
                os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../cli")]
from front import Front, Refused  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
checks = Checks()
check = checks.check
state = os.path.join(folder, "state")
env = dict(os.environ, XDG_STATE_HOME=state)
models = os.path.join(folder, "models")
os.makedirs(models)
CUBE = "segment(1, solid, box(size(1, 1, 1))).\n"
with open(os.path.join(models, "cube.pl"), "w") as out:
    out.write(CUBE)


def started(*arguments):
    front = Front(program, models, "cube.pl", ("--class", *arguments), env)
    front.code = front.process.stdout.readline().decode().strip().split(
        "/#")[1]
    return front


def pupil(secret):
    page = front.socket()
    page.say({"id": 0, "do": "hello", "token": front.code, "pupil": secret})
    page.hello = page.hear()[0]
    return page


def code(reply):
    return (reply[0].get("error") or {}).get("code")


def limit(session, name):
    with open("/proc/%d/limits" % session) as file:
        line = next(line for line in file if line.startswith(name))
    return line[len("Max realtime timeout      "):].split()[0]


def used(session):
    with open("/proc/%d/stat" % session) as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


# What the system holds a session to, whatever it does.
front = started()
page = front.page()
page.ask("open", file="cube.pl")
session = front.sessions()[0]
page.ask("tree")
seconds = int(limit(session, "Max cpu time"))
check("90 seconds of the processor for a request",
      89 <= seconds - math.floor(used(session)) <= 92, seconds)
check("1 GB", limit(session, "Max data size") == "1000000000")

# Who wants all of it: the others are answered meanwhile, and stop is heard.
greedy = pupil("f" * 32)
greedy.ask("open", file="cube.pl")
HARD = "".join("segment(%d, solid, at([translate(%d.13,%d.17,0.1)], "
               "sphere(radius(9), facets(96)))).\n" % (i + 2, i % 7, i // 7)
               for i in range(40))
greedy.say({"id": 70, "do": "text", "body": CUBE + HARD + "segment(90, solid, union(["
            + ",".join(str(i + 2) for i in range(40)) + "])).\n"})
time.sleep(1)
began = time.time()
check("others are answered", "error" not in page.ask("view", format="strokes")[0]
      and time.time() - began < 5, time.time() - began)
greedy.say({"id": 71, "do": "stop"})
heard = {}
while 71 not in heard:
    head, _ = greedy.hear()
    heard[head.get("id")] = head
check("and stop is heard", heard[70].get("error", {}).get("code")
      == "interrupted", heard)
check("the model is as it was", greedy.ask("text")[1].decode() == CUBE)

# A stop that names its request: what was asked before it is done.
greedy.say({"id": 72, "do": "ask", "goal": "between(1, 3000000, X), X < 0"})
greedy.say({"id": 73, "do": "text", "body": CUBE.replace("1", "2", 1)})
greedy.say({"id": 74, "do": "unfold"})
greedy.say({"id": 75, "do": "stop", "of": 74})
greedy.say({"id": 76, "do": "stop", "of": 1000})
heard = {}
while 76 not in heard:
    head, _ = greedy.hear()
    heard[head.get("id")] = head
check("it alone is stopped", [n for n in heard if "error" in heard[n]] == [74]
      and sorted(heard) == [72, 73, 74, 75, 76] and heard[74]["error"]["code"]
      == "interrupted", heard)
check("no change is lost", greedy.ask("text")[1].decode() != CUBE)
greedy.ask("undo")
deep = greedy.ask("ask", goal="numlist(1, 30000000, L), length(L, N)")
check("memory", "error" in deep[0] and greedy.ask("text")[1].decode() == CUBE,
      deep[0])
greedy.close()

# No more than 40 sessions; who has one keeps it.
time.sleep(0.1)
for i in range(38):
    one = pupil("%032x" % i)
    check("a session for %d" % i, "error" not in one.ask("open",
                                                         file="cube.pl")[0])
    one.close()
check("40 sessions", len(front.sessions()) == 40, len(front.sessions()))
last = pupil("e" * 32)
head, _ = last.ask("open", file="cube.pl")
check("and no more", code((head, 0)) == "request_error.too_many_sessions" and
      len(front.sessions()) == 40, head)
check("those who are there go on", "error" not in page.ask("tree")[0] and
      "error" not in pupil("%032x" % 7).ask("tree")[0])

# ---- no message names a folder of this machine ----

def untold(name, reply, wanted):
    said = json.dumps(reply[0]) + repr(reply[1])
    check("%s: %s" % (name, wanted), code(reply) == wanted, reply[0])
    check(name + ": no path", folder not in said and "/tmp" not in said, said)


def send(page, name, text):
    ticket = page.ask("upload", name=name)[0]["ticket"]
    connection = http.client.HTTPConnection("127.0.0.1", front.port)
    place = "%s:%d" % (front.host, front.port)
    connection.request("POST", "/up/" + ticket, text, {
        "Host": place, "Origin": "http://" + place})
    connection.getresponse().read()
    connection.close()


front.end()
front = started()
for page, journals in ((front.page(), ""), (pupil("a" * 32), "class/")):
    untold("missing", page.ask("open", file="none.pl"),
           "model_error.cannot_read")
    send(page, "bad.pl", b"segment(1, solid, box(size(0, 1, 1))).\nx(")
    untold("sent, bad", page.ask("open", file="bad.pl", upload=True),
           "model_error.syntax")
    send(page, "good.pl", CUBE.encode())
    head, _ = page.ask("open", file="good.pl", upload=True)
    check("sent: its name", head.get("file") == "good.pl", head)
    untold("sent, explained", page.ask("explain", item="segment(1)"), None)
    page.ask("open", file="cube.pl")
    ends = glob.glob("%s/sanggwan/%scube.pl-*.end" % (state, journals))
    journal = max(ends, key=os.path.getmtime).removesuffix(".end")
    page.ask("open", file="good.pl", upload=True)
    with open(journal, "w") as out:
        out.write("mine\n")
    untold("no journal", page.ask("open", file="cube.pl"),
           "request_error.no_journal")
    os.remove(journal)
    os.makedirs(journal + ".new")
    reply = page.ask("open", file="cube.pl")
    untold("not written", reply, code(reply))
    check("it is an error", code(reply) is not None, reply[0])
    os.rmdir(journal + ".new")

# ---- whose frames it may stand in ----

def policy():
    return front.get("/")[1]["Content-Security-Policy"]


check("no frames", policy().endswith("; frame-ancestors 'none'"), policy())
for origin in ("h.example", "https://", "https://a b", "https://a;b", "*",
               "https://h.example/x", "https://h.example:x", "https://*.a",
               "https://h.example\r\nX: y", "https://\u0435.example"):
    done = subprocess.run([program, "serve", "cube.pl", "--no-open", "--embed",
                           origin], cwd=models, env=env, check=False,
                          capture_output=True, timeout=20)
    check("embed %r" % origin, done.returncode == 2 and b"--embed" in
          done.stderr and done.stdout == b"", done)
front.end()
front = started("--embed", "https://H.example:8443/")
check("frames of one origin", policy().endswith(
    "; frame-ancestors https://h.example:8443") and policy().startswith(
        "default-src 'none'; script-src 'self'"), policy())
check("it opens no socket for that", front.page().hello["owner"] is True)
try:
    front.socket(Origin="https://h.example:8443")
    check("no socket of that page", False)
except Refused as error:
    check("no socket of that page", error.args == (403,), error.args)

# ---- shown to all ----

teacher, ann, ben = front.page(), pupil("a" * 32), pupil("b" * 32)
check("who may show", (teacher.hello["shows"], ann.hello["shows"])
      == ("all", None), (teacher.hello, ann.hello))
teacher.ask("open", file="cube.pl")
ben.ask("open", file="cube.pl")
kept = ben.ask("text")[1]
check("nothing yet", "kind" not in ann.ask("shown")[0])
mine = teacher.ask("view", format="strokes", view=[30, 60], shown=True)
check("all hear of it", ann.hear()[0] == ben.hear()[0]
      == {"event": "shown", "shown": True})
theirs = ann.ask("shown")
check("all see it", theirs[1] == mine[1] and theirs[0]["kind"] == "strokes"
      and "rev" not in theirs[0] and theirs[0]["sheet"] == mine[0]["sheet"],
      theirs[0])
for angle in range(20):
    mine = teacher.ask("view", format="strokes", view=[angle, 60], shown=True)
check("who does not ask is told once", ben.ask("shown")[1] == mine[1] and
      ben.events == [], ben.events)
ann.ask("view", format="strokes", view=[1, 1], shown=True)
check("a pupil shows nothing", teacher.ask("tree")[0].get("do") == "tree" and
      ann.ask("shown")[1] == mine[1])
check("nor ends it", code(ann.ask("show")) == "request_error.owner_alone" and
      ann.ask("shown")[1] == mine[1])
late = pupil("c" * 32)
check("who comes later sees it", late.hello["shows"] == "seen" and
      late.ask("shown")[1] == mine[1], late.hello)
check("it changes nothing of theirs", ben.ask("text")[1] == kept)
teacher.ask("view", format="strokes", view=[2, 2])
check("other pictures are the teacher's", ben.ask("shown")[1] == mine[1])
ben.events.clear()
teacher.ask("show")
check("no more", ben.hear()[0] == {"event": "shown", "shown": False} and
      "kind" not in ben.ask("shown")[0] and
      pupil("d" * 32).hello["shows"] is None)
front.end()
checks.finish()
