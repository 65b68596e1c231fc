"""front_test.py PROGRAM FOLDER: the front of the studio and its guard, as pages
and as those who attack them see it."""
# covers: front, guard, visitor, page_file, model_tree, answer_name
import gzip
import http.client
import json
import os
import re
import signal
import socket
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
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
models = os.path.join(folder, "models")
os.makedirs(os.path.join(models, "inner"))
MODEL = """% two cylinders
param(r, 1).
segment(1, solid, at([translate(0, 0, -2)], cylinder(radius(param(r)), height(4),
                                                     facets(12)))).
segment(2, solid, at([translate(0, 0, -2), rotate(y, 90)],
                     named(pipe, cylinder(radius(0.8), height(4),
                                          facets(12))))).
"""
with open(os.path.join(models, "tee.pl"), "w") as out:
    out.write(MODEL)
with open(os.path.join(folder, "secret.pl"), "w") as out:
    out.write(MODEL)
os.symlink("../secret.pl", os.path.join(models, "link.pl"))
os.symlink("..", os.path.join(models, "up"))


def started(*arguments, model="tee.pl"):
    return Front(program, models, model, arguments, env)


def refused(name, status, **headers):
    try:
        front.socket(**headers)
        check(name, False, "opened")
    except Refused as error:
        check(name, error.args[0] == status, error.args)


def code(reply):
    return reply[0].get("error", {}).get("code", reply[0])


front = started()
place = "127.0.0.1:%d" % front.port

# The page, and what every reply says. What it fetches later, if it is wanted at
# all, does not count.
status, headers, page = front.get("/")
check("the page", status == 200 and b"main.js" in page)
total, later = 0, set()
for name in os.listdir("web"):
    with open(os.path.join("web", name)) as file:
        later |= set(re.findall(r'import\("\./([a-z]+\.js)"\)', file.read()))
# A browser keeps what stands in the folder that the page names; by their names
# alone files are asked for anew.
kept = re.search(rb'src="([0-9a-f]{16})/main.js"', page).group(1).decode()
check("the page is asked for anew", headers["Cache-Control"] == "no-cache")
check("what it names is kept", not re.search(
    rb'(?:href|src)="(?!%s/)' % kept.encode(), page), page)
for name in sorted(os.listdir("web")):
    path = "/" if name == "index.html" else "/" + name
    with open(os.path.join("web", name), "rb") as file:
        octets = file.read()
    status, headers, got = front.get(path)
    if name == "index.html":
        octets = octets.replace(b'="./', b'="%s/' % kept.encode())
    check("carried: " + name, status == 200 and got == octets
          and headers["Cache-Control"] == "no-cache", headers)
    status, headers, got = front.get("/" + kept + "/" + name)
    check("kept: " + name, status == 404 if name == "index.html" else
          status == 200 and got == octets and
          headers["Cache-Control"] == "max-age=31536000, immutable", headers)
    check("not elsewhere: " + name,
          front.get("/%s/%s" % ("0" * 16, name))[0] == 404)
    total += 0 if name in later else len(octets)
words = json.loads(front.get("/words.json")[2])
total += len(front.get("/words.json")[2])
check("the page is small", total < 150_000, total)
check("words in both languages", len(words) > 60 and all(
    len(pair) == 2 and all(pair) for pair in words.values()))

# A browser has six connections, which stay open for a while: nobody waits for
# one that another browser does not use any more.


def asked_by_many():
    """Seconds until each of 20 connections has been answered once."""
    since, open_ones = time.time(), []
    for _ in range(20):
        one = http.client.HTTPConnection("127.0.0.1", front.port, timeout=20)
        one.request("GET", "/icon.svg", headers={"Host": place})
        one.getresponse().read()
        open_ones.append(one)
    took = time.time() - since
    for one in open_ones:
        one.close()
    return took


took = [asked_by_many() for _ in range(3)]
check("connections that stay open hold up nobody", min(took) < 0.4, took)

# In the gzip format for who takes it: then all of it is small.
sent = 0
for path in ["/", "/words.json"] + sorted(
        "/" + name for name in os.listdir("web") if name != "index.html"):
    plain = front.get(path)[2]
    for given, packed in (("gzip, deflate, br", True), ("br, gzip;q=0.5", True),
                          ("deflate", False), ("gzip;q=0", False)):
        status, headers, octets = front.get(
            path, headers={"Accept-Encoding": given})
        check("packed: %s: %s" % (path, given),
              status == 200 and headers["Vary"] == "Accept-Encoding"
              and (headers.get("Content-Encoding") == "gzip") == packed
              and (gzip.decompress(octets) if packed else octets) == plain,
              headers)
        sent += len(octets) if given.startswith("gzip, ") else 0
check("all of the page is small", sent < 83_000, sent)
for path in ("/", "/main.js", "/nothing", "/x/none", "/../rules/about.pl",
             "/%2e%2e/README.md", "/studio.css/", "//etc/passwd"):
    status, headers, octets = front.get(path)
    check("policy of " + path,
          "default-src 'none'" in headers.get("Content-Security-Policy", "")
          and "frame-ancestors 'none'" in headers["Content-Security-Policy"]
          and "unsafe" not in headers["Content-Security-Policy"]
          and headers.get("X-Content-Type-Options") == "nosniff"
          and headers.get("Cross-Origin-Resource-Policy") == "same-origin"
          and headers.get("Cross-Origin-Opener-Policy") == "same-origin",
          headers)
    check("there or not: " + path,
          (status == 200) == (path in ("/", "/main.js")), status)
for whole in ("http://evil.example/", "http://127.0.0.1:%d/" % front.port,
              "evil.example"):
    check("a path alone: " + whole, front.get(whole)[0] == 400)
check("no cookie", not any("Set-Cookie" in front.get(path)[1]
                           for path in ("/", "/main.js")))
for method in ("POST", "PUT", "DELETE", "OPTIONS"):
    check("no " + method, front.get("/", method)[0] == 405)
with_markup = [name for name in os.listdir("web") if name.endswith(".js")
               and any(word in open(os.path.join("web", name)).read()
                       for word in ("innerHTML", "outerHTML", "eval(",
                                    "insertAdjacentHTML", "document.write",
                                    "new Function"))]
check("no markup from texts", with_markup == [], with_markup)

# 1. It listens on loopback alone.
listening = subprocess.run(["sh", "-c", "cat /proc/net/tcp"],
                           stdout=subprocess.PIPE, check=True).stdout.decode()
bound = [line.split()[1] for line in listening.splitlines()[1:]
         if line.split()[1].endswith(":%04X" % front.port)
         and line.split()[3] == "0A"]
check("loopback alone", bound == ["0100007F:%04X" % front.port], bound)

# 2. Host.
for host in ("evil.example", "evil.example:%d" % front.port,
             "127.0.0.1.evil.example:%d" % front.port, "127.0.0.1",
             "127.0.0.1:1", "127.0.0.1:%d.evil.example" % front.port,
             "127.0.0.1:%d:%d" % (front.port, front.port), "",
             "[::1]:%d" % front.port, "0x7f000001:%d" % front.port,
             "2130706433:%d" % front.port, "127.0.0.2:%d" % front.port,
             "localhost.:%d" % front.port, "%s@evil.example" % place):
    status, _, octets = front.get("/", headers={"Host": host})
    check("host " + host, status == 400 and b"main.js" not in octets, status)
    refused("host of a socket " + host, 400, Host=host,
            Origin="http://" + host)
check("localhost", front.get(
    "/", headers={"Host": "localhost:%d" % front.port})[0] == 200)

# 3. Origin.
for origin in (None, "null", "http://evil.example", "https://" + place,
               "http://127.0.0.1", "http://127.0.0.1:%d" % (front.port + 1),
               "http://127.0.0.1.evil.example:%d" % front.port,
               "http://%s.evil.example" % place, "file://", "",
               "http://evil.example@" + place, "http://%s/" % place):
    refused("origin %s" % origin, 403, Origin=origin)
check("a socket alone", front.get("/ws", headers={"Origin": "http://" + place}
                                  )[0] == 400)

# 4. The secret.
for token in ("", front.token[:-1], front.token + "0", "0" * 32, None, 7,
              front.token.upper() + " "):
    page = front.socket()
    page.say({"id": 0, "do": "hello", "token": token})
    check("secret %s" % token, page.hear()[0] == 1008)
page = front.socket()
page.say({"id": 1, "do": "open", "file": "tee.pl"})
check("hello comes first", page.hear()[0] == 1008)
check("no session but that of the model without the secret",
      len(front.sessions()) == 1, front.sessions())
check("the secret has 128 bits", len(front.token) == 32)
check("the secret is in no reply", not any(
    front.token.encode() in front.get(path)[2]
    for path in ("/", "/main.js", "/words.json")))

# What a page does.
page = front.page()
check("hello", page.hello["file"] == "tee.pl" and page.hello["rev"] == 1
      and page.hello["models"] == ["link.pl", "tee.pl"], page.hello)
head, _ = page.ask("open", file="tee.pl")
check("open", len(head.get("segments", [])) == 2, head)
head, body = page.ask("view", format="strokes", view="front", size=[90, 60])
check("view", head.get("kind") == "strokes" and len(body) > 400, head)
head, _ = page.ask("ask", goal="segment(S, solid, _)")
check("answers have names", head.get("shows") == [["s1"], ["s2"]], head)
head, _ = page.ask("ask", goal="line(L, 1, _, A, B, _, _, _, _), e(1, E, A, B, _)")
check("lines have names", head["answers"] and all(
    "l%d" % row[head["names"].index("L")] in shown
    and "s1e%d" % row[head["names"].index("E")] in shown
    for row, shown in zip(head["answers"], head["shows"])), head)
head, _ = page.ask("ask", goal="between(1, 2, S), e(S, E, _, _, _)")
check("many answers", len(head["answers"]) == 50 and head["left"] > 0, head)
asked = page.number
head, _ = page.ask("next", of=asked)
check("the next answers", len(head.get("answers", [])) > 0
      and head["shows"][0][0].startswith("s"), head)
head, _ = page.ask("tree")
check("the tree", [one["segment"] for one in head["segments"]] == [1, 2]
      and head["params"] == [{"param": "r", "value": 1, "about": {}}]
      and head["segments"][1]["term"]["name"] == "at"
      and head["forms"]["cylinder"]["radius"] == ["length", "length"], head)
head, _ = page.ask("edit", set={"segment": 2, "path": [2, 2, 1, 1],
                                "value": 0.5})
check("edit", head.get("was") == 0.8, head)
other = front.page()
check("another window sees the same document", other.hello["rev"]
      == head["rev"], other.hello)
# So it is however soon the window is opened: who has the reply finds the revision.
late = []
for value in range(20):
    head, _ = page.ask("edit", set={"segment": 2, "path": [2, 2, 1, 1],
                                    "value": 0.3 + value / 100})
    late.append(front.page().hello["rev"] - head["rev"])
    other.hear()
check("the newest one, always", late == [0] * 20, late)
for _ in range(20):
    page.ask("undo")
    other.hear()
revision = page.ask("undo")[0]["rev"]
event, _ = other.hear()
check("it hears of changes", event == {"event": "revision", "rev": revision},
      event)
check("a session for both", len(front.sessions()) == 1)
check("opened already: as it is", other.ask("open", file="tee.pl")[0]["rev"]
      == revision and page.ask("tree")[0]["rev"] == revision
      and page.events == [], page.events)
head, body = page.ask("text")
check("undo", body.decode() == MODEL)
head, _ = page.ask("text", body=MODEL.replace("0.8", "0.7") + "% 한글\n")
check("text", "error" not in head, head)
check("text, as sent", page.ask("text")[1].decode().endswith("% 한글\n"))

# 6. Frames.
page = front.page()
page.ask("open", file="tee.pl")
long = json.dumps({"id": 5, "do": "ask", "goal": "x" * 1_048_500}).encode()
page.frame(1, long + b" " * (1_048_577 - len(long)))
check("too long", page.hear()[0] == 1009)
page = front.page()
page.frame(1, json.dumps({"id": 1, "do": "ask", "goal": "true" + " " * 900_000
                          }).encode())
check("long enough", page.hear()[0].get("answers") == [[]])
page.frame(2, b"\0\1\2")
check("no octets", page.hear()[0] == 1003)
page = front.page()
page.frame(1, b"[" * 100_000)
check("no JSON", code(page.hear()) == "frame_error.not_json")
page.frame(1, b"\xff\xfe{}")
check("no UTF-8", code(page.hear()).startswith("frame_error"))
page.frame(9, b"hello")
opcode, octets = page.message()
check("ping", (opcode, octets) == (10, b"hello"), (opcode, octets))
# In pieces a message is one; library(http) cannot read a ping between them, which no
# browser sends: then the socket ends, and no other one.
text = json.dumps({"id": 1, "do": "tree"}).encode()
page.frame(1, text[:9], final=False)
page.frame(0, text[9:])
check("in pieces", page.hear()[0].get("segments"))
page.frame(1, text[:9], final=False)
page.frame(9, b"hello")
page.frame(0, text[9:])
try:
    check("a ping between pieces", page.hear()[0].get("segments"))
except (OSError, EOFError):
    check("a ping between pieces ends one socket", True)
page.close()
page = front.page()
page.frame(1, b" ", final=False)
try:
    for _ in range(20):
        page.frame(0, b" " * 60_000, final=False)
    ended = page.hear()[0] == 1009
except (OSError, EOFError):
    ended = True
check("too long, in pieces without end", ended)
page.close()
for claimed in (2 ** 63 + 5, 2 ** 62, 2 ** 40):
    page = front.page()
    try:
        page.frame(1, b"x" * 2_000_000, claimed=claimed)
        ended = page.hear()[0] == 1009
    except (OSError, EOFError):
        ended = True
    check("a length that is none: %d" % claimed, ended)
    page.close()
page = front.socket()
page.socket.sendall(b"\x81\x05hello")
time.sleep(0.1)
check("alive after all that", front.page().ask("open", file="tee.pl")[0].get(
    "segments"))

# 7. Questions, and what is no request of a page.
page = front.page()
page.ask("open", file="tee.pl")
for goal in ("shell('touch %s/hacked')" % folder, "halt",
             "open('/etc/passwd', read, S)",
             "consult('/tmp/x.pl')", "process_create(path(ls), [], [])",
             "sg_store:retract_fact(segment(1, solid, _))",
             "use_module(library(process)), process_create(path(ls), [], [])",
             "use_module('/tmp/x.pl')", "thread_create(true, _)",
             "setenv(a, b)", "load_files('x')", "read_term(X, [])",
             "http_open('http://127.0.0.1', S, [])", "tcp_socket(S)",
             "@(shell(ls), user)", "call(shell, ls)", "G = shell(ls), G",
             "catch(halt, _, true)", "findall(X, halt, X)", "x:halt",
             "getenv('HOME', X)"):
    answer = page.ask("ask", goal=goal, owner=True)
    check("goal " + goal, "error" in answer[0], answer[0])
head, _ = page.ask("ask", goal="between(1, inf, X), X < 0")
check("a goal without end", code((head, 0)).startswith("request_error.too_long"
                                                       ), head)
head, _ = page.ask("ask", goal="numlist(1, 100000000, L)")
check("a goal without bounds", "error" in head, head)
check("nothing was touched", not os.path.exists(folder + "/hacked"))
for request in ("run", "hello", "batch", "", "quit", 7, None):
    answer = page.ask(request, argv=["check", "/etc/passwd"])
    check("no request: %s" % request,
          code(answer) == "request_error.not_offered", answer[0])
for item in ("line(1), shell(ls)", "consult(x)"):
    page.ask("explain", item=item)
head, _ = page.ask("explain", item="line(1)", options=["--rules=x.pl"])
check("no rules for explain", code((head, 0)) == "request_error.bad_key", head)

# 8. Rules are the owner's; 9. files.
for name in ("../secret.pl", "link.pl", "up/secret.pl", "/etc/passwd",
             os.path.join(folder, "secret.pl"), "inner/../../secret.pl",
             "tee.pl\0.pl", "http://127.0.0.1/tee.pl", "inner", ".", "",
             "~/secret.pl", "$HOME/secret.pl", "tee.txt", 7, None):
    answer = page.ask("open", file=name)
    check("file %s" % name, code(answer) in (
        "request_error.outside", "request_error.bad_key",
        "model_error.cannot_read"), answer[0])
    answer = page.ask("save", file=name, force=True)
    check("saved as %s" % name, name is None or "error" in answer[0],
          answer[0])
check("the secret file is as it was",
      open(os.path.join(folder, "secret.pl")).read() == MODEL)
for argv in (["draw", "link.pl"], ["draw", "tee.pl"],
             ["draw", "--json", "tee"], ["draw", "--view", "front", "tee.pl"],
             ["draw", "--view=front", "front"], ["draw", "--view", "tee.pl"],
             ["draw", "-o", "x.svg"], ["draw", "--rules=x.pl"],
             ["query", "halt"], ["draw", "--style", "x.pl"],
             ["draw", "--output=x.svg"], ["repl"], ["serve"], ["draw", "--"],
             ["draw", "../secret.pl"], ["draw", "-ox.svg"], ["run"], [], "x",
             ["draw", "--view", "front", "-o/tmp/x.svg"],
             ["convert", "--repair", "x"], ["draw", 7]):
    answer = page.ask("export", argv=argv, name="x.svg")
    check("export %s" % (argv,), code(answer) == "request_error.bad_key",
          answer[0])
for name in ("../x.svg", "/tmp/x.svg", "x", ".x.svg", "-x.svg", "x\0.svg",
             "x.sh", "a/b.svg", "x" * 200 + ".svg", "x\n.svg", 7, None):
    answer = page.ask("export", argv=["draw"], name=name)
    check("download %s" % name, code(answer) == "request_error.bad_key",
          answer[0])
# Files that a page sends.
for name in ("../x.pl", "/tmp/x.pl", "x", ".x.pl", "x.sh", "a/b.pl", "-x.pl",
             "x\0.pl", "x" * 200 + ".pl", "x\n.pl", 7, None):
    answer = page.ask("upload", name=name)
    check("sent as %s" % name, code(answer) == "request_error.bad_key",
          answer[0])
for name in ("x.csg", "x.json", "x.stl", "x.off", "x.obj", "x.PLY", "X.PL"):
    check("sent as %s" % name, "ticket" in page.ask("upload", name=name)[0])


def sent(ticket, octets, headers=None):
    given = {"Origin": "http://" + place, "Content-Length": str(len(octets))}
    given.update(headers or {})
    return front.get("/up/" + ticket, "POST", given, octets)[0]


ticket = page.ask("upload", name="sent.pl")[0].get("ticket", "")
check("sent by another page", sent(ticket, MODEL.encode(), {
    "Origin": "http://evil.example"}) == 403)
check("without a ticket", sent("0" * 32, MODEL.encode()) == 404)
check("sent", sent(ticket, MODEL.encode()) == 200)
check("once", sent(ticket, b"other") == 404)
ticket = page.ask("upload", name="large.pl")[0]["ticket"]
check("too large", sent(ticket, b"", {"Content-Length": "20000001"}) == 413)
ticket = page.ask("upload", name="chunks.pl")[0]["ticket"]
check("a length that is not said", sent(ticket, b"0\r\n\r\n", {
    "Transfer-Encoding": "chunked"}) in (400, 411))
head, _ = page.ask("open", file="sent.pl", upload=True)
check("opened", len(head.get("segments", [])) == 2, head)
check("kept for the next page", front.page().hello["uploads"] == ["sent.pl"],
      front.page().hello)
for name in ("../secret.pl", "/etc/passwd", "tee.pl", "large.pl"):
    check("no other file: " + name, "error" in page.ask(
        "open", file=name, upload=True)[0])
for i in range(19):
    sent(page.ask("upload", name="m%d.pl" % i)[0]["ticket"], b"% none\n")
check("no more than 20", code(page.ask("upload", name="m.pl"))
      == "request_error.too_many_uploads")
check("but another text", "ticket" in page.ask("upload", name="m1.pl")[0])
page.ask("open", file="tee.pl", replay=False)
head, _ = page.ask("export", argv=["draw", "--view", "front"],
                   name="그림.svg")
drawn = subprocess.run([program, "draw", "-q", "--view", "front", "tee.pl",
                        "-o", "-"], cwd=models, stdout=subprocess.PIPE,
                       check=True).stdout
status, headers, octets = front.get("/x/" + head.get("ticket", "none"))
check("export: the bytes of the command line",
      status == 200 and octets == drawn, (head, status))
check("export: no page of ours", headers.get("Content-Type")
      == "application/octet-stream"
      and headers["Content-Disposition"].startswith("attachment"), headers)
check("export: once", front.get("/x/" + head["ticket"])[0] == 404)

# 10. Limits.
session = front.sessions()[0]
with open("/proc/%d/limits" % session) as file:
    limit = [line for line in file if line.startswith("Max data")][0].split()
check("memory of a session", limit[3] == "1000000000", limit)
page.say({"id": 900, "do": "ask", "goal": "between(1, inf, X), X < 0"})
for i in range(70):
    page.say({"id": 1000 + i, "do": "tree"})
refusals = 0
for _ in range(71):
    head, _ = page.hear()
    refusals += code((head, 0)) == "request_error.too_many"
check("no more than 64 wait", refusals == 7, refusals)
pages = []
try:
    for _ in range(60):
        pages.append(front.page())
    check("no more than 40 pages", False)
except Refused as error:
    check("no more than 40 pages", error.args == (503,), error.args)
for one in pages:
    one.close()

# Nothing that was answered is lost.
page = front.page()
page.ask("open", file="tee.pl", replay=False)
for i in range(12):
    value = 0.5 + i / 100
    head, _ = page.ask("edit", set={"segment": 2, "path": [2, 2, 1, 1],
                                    "value": value})
    check("edit %d" % i, "error" not in head, head)
    if i % 4 == 3:
        os.kill(front.sessions()[0], signal.SIGKILL)
        while page.hear()[0] != {"event": "restarted"}:
            pass
        head, _ = page.ask("open", file="tee.pl")
        check("replayed %d" % i, head.get("replayed") == i + 1, head)
        check("kept %d" % i, "radius(%s)" % value in
              page.ask("text")[1].decode())
page.say({"id": 5000, "do": "ask", "goal": "between(1, inf, X), X < 0"})
time.sleep(0.2)
os.kill(front.sessions()[0], signal.SIGKILL)
heard = []
while not heard or heard[-1] != {"event": "restarted"}:
    heard.append(page.hear()[0])
check("who waits is told", any(one.get("id") == 5000 and
      one["error"]["code"] == "request_error.session_ended" for one in heard),
      heard)
front.process.kill()
front.process.wait()
front.process.stdout.close()
front.process.stderr.close()
again = started()
page = again.page()
head, _ = page.ask("open", file="tee.pl")
check("the front was killed", head.get("replayed") == 12, head)
check("another secret", again.token != front.token)
check("save", page.ask("save")[0].get("file"))
check("saved", "radius(0.61)" in open(os.path.join(models, "tee.pl")).read())
with open(os.path.join(models, "tee.pl"), "a") as out:
    out.write("% another program\n")
head, _ = page.hear()
check("a file that another program writes", head == {"event": "file"}, head)
check("is not written over", code(page.ask("save"))
      == "request_error.file_changed")
head, body = page.ask("reload", look=True)
check("its text may be looked at", body.decode().endswith("other program\n")
      and not page.ask("text")[1].decode().endswith("other program\n"), head)
head, _ = page.ask("edit", set={"segment": 2, "path": [2, 2, 1, 1],
                                "value": 0.62})
head, _ = page.ask("reload")
check("taken, as one step", "error" not in head and
      page.ask("text")[1].decode().endswith("other program\n"), head)
page.ask("undo")
check("which undo takes back", "radius(0.62)" in page.ask("text")[1].decode())
page.ask("redo")
text = page.ask("text")[1]
again.process.kill()
again.process.wait()
page.close()
again.process.stdout.close()
again.process.stderr.close()
again = started()
page = again.page()
head, _ = page.ask("open", file="tee.pl")
check("and no kill", "error" not in head and page.ask("text")[1] == text,
      head)
check("no path of this machine is told", folder not in json.dumps(head) and
      folder not in json.dumps(page.ask("open", file="none.pl")[0]) and
      folder not in json.dumps(page.ask("text", body="x(")[0]), head)
page.ask("edit", set={"segment": 2, "path": [2, 2, 1, 1], "value": 0.63})
mine = page.ask("text")[1]
with open(os.path.join(models, "tee.pl"), "a") as out:
    out.write("% a third\n")
os.kill(again.sessions()[0], signal.SIGKILL)
while page.hear()[0] != {"event": "restarted"}:
    pass
check("two who wrote, and a kill", code(page.ask("open", file="tee.pl"))
      == "request_error.journal_of_another")
head, _ = page.ask("open", file="tee.pl", replay="journal")
check("what was changed here is there", "error" not in head and
      page.ask("text")[1] == mine, head)
check("the file is not written over", code(page.ask("save"))
      == "request_error.file_changed")
check("what is there may be taken", "error" not in page.ask("reload")[0] and
      page.ask("text")[1].decode().endswith("% a third\n"))
page.events.clear()
page.ask("edit", set={"segment": 2, "path": [2, 2, 1, 1], "value": 0.62})
page.ask("save")
time.sleep(1.3)
check("what the page saved is no news", not any(
    one.get("event") == "file" for one in page.events), page.events)
page.close()
time.sleep(0.05)
status, _, error = again.end()
check("interrupted", (status, error) == (130, b"sanggwan: interrupted\n"),
      (status, error))

# Another address than loopback.
done = subprocess.run([program, "serve", "tee.pl", "--no-open", "--host",
                       "0.0.0.0"], cwd=models, stdout=subprocess.PIPE,
                      stderr=subprocess.PIPE, check=False, timeout=20)
check("not without --class", done.returncode == 2 and done.stdout == b"" and
      b"Add --class" in done.stderr, done)
front = started("--host", "0.0.0.0", "--class", "--port", str(again.port))
joined = front.process.stdout.readline().decode().strip()
check("what is opened is said", front.address.startswith("http://localhost:"),
      front.address)
front.host = "127.0.0.1"
page = front.page()
check("not the owner", page.hello["owner"] is False, page.hello)
page.ask("open", file="tee.pl")
check("no rules of others", code(page.ask(
    "rules", **{"try": True, "body": "x.", "owner": True}))
    == "request_error.owner_alone")
check("a name of others", front.get(
    "/", headers={"Host": "evil.example:%d" % front.port})[0] == 400)
check("an address", front.get(
    "/", headers={"Host": "10.1.2.3:%d" % front.port})[0] == 200)
page.close()

# Behind a proxy: its address too, and no other.
free = socket.socket()
free.bind(("127.0.0.1", 0))
number = free.getsockname()[1]
free.close()
for url in ("h.example", "ftp://h.example/", "https://", "https://a b/",
            "https://h.example:x/", "https://u@h.example/", "javascript:x"):
    done = subprocess.run([program, "serve", "--no-open", "--behind", url],
                          cwd=models, stdout=subprocess.PIPE, check=False,
                          stderr=subprocess.PIPE, timeout=20)
    check("behind %s" % url, done.returncode == 2 and b"--behind" in
          done.stderr, done)
own, front = front, Front(program, models, "tee.pl", (
    "--behind", "https://h.example/sanggwan"), env, number)
check("the address of the proxy is printed", front.address.startswith(
    "https://h.example/sanggwan/#"), front.address)
for host, status in (("h.example", 200), ("127.0.0.1:%d" % number, 200),
                     ("H.EXAMPLE", 200), ("evil.example", 400),
                     ("h.example.evil.example", 400), ("xh.example", 400),
                     ("h.example:81", 400)):
    check("behind: host " + host, front.get("/", headers={"Host": host})[0]
          == status)
page = front.socket(Host="h.example", Origin="https://h.example")
page.say({"id": 0, "do": "hello", "token": front.token})
check("behind: not the owner", page.hear()[0]["owner"] is False)
for origin in ("http://h.example", "https://evil.example",
               "https://h.example:444", "https://h.example.evil.example",
               "null", None):
    refused("behind: origin %s" % origin, 403, Host="h.example",
            Origin=origin)
page.close()
time.sleep(0.05)
_, _, error = front.end()
check("behind: said", b"h.example" in error and b"127.0.0.1" in error, error)
front = own

# A class: each pupil has a world; nobody but the owner writes a file.
class_code = joined.split("/#")[1]
check("a code for pupils", joined.startswith("http://localhost:") and
      len(class_code) == 10 and class_code not in front.token, joined)


def pupil(secret, code=class_code):
    page = front.socket()
    page.say({"id": 0, "do": "hello", "token": code, "pupil": secret})
    page.hello = page.hear()[0]
    return page


for secret in (None, "", "0" * 31, "g" * 32, "owner", 7, "\u0660" * 32):
    check("no pupil: %s" % secret, pupil(secret).hello == 1008)
check("a code that is none", pupil("0" * 32, class_code[:-1] + "g").hello
      == 1008)
before = open(os.path.join(models, "tee.pl")).read()
ann, ben = pupil("a" * 32), pupil("b" * 32)
check("pupils are no owners", ann.hello["owner"] is False, ann.hello)
for one in (ann, ben):
    check("a pupil opens", "error" not in one.ask("open", file="tee.pl")[0])
check("a session each", len(front.sessions()) == 3, front.sessions())
ann.ask("edit", set={"segment": 2, "path": [2, 2, 1, 1], "value": 0.33})
ann_text, ben_text = ann.ask("text")[1], ben.ask("text")[1]
check("a world each", b"radius(0.33)" in ann_text and
      ben_text.decode() == before, ben_text)
for request, keys in (("save", {}), ("save", {"file": "x.pl"}),
                      ("save", {"force": True})):
    check("pupils save nothing", code(ann.ask(request, **keys))
          == "request_error.owner_alone")
check("no rules of pupils", code(ann.ask(
    "rules", **{"try": True, "body": "x.", "owner": True}))
    == "request_error.owner_alone")
check("no file elsewhere", code(ann.ask("open", file="../secret.pl"))
      == "request_error.outside")
check("the file is as it was",
      open(os.path.join(models, "tee.pl")).read() == before)
ann.close()
for one in front.sessions():
    os.kill(one, signal.SIGKILL)
time.sleep(0.3)
ann = pupil("a" * 32)
head, _ = ann.ask("open", file="tee.pl")
check("what a pupil did is kept", ann.ask("text")[1] == ann_text, head)
many = [pupil("%032x" % (i + 1)) for i in range(30)]
good = [one.ask("open", file="tee.pl")[0] for one in many]
check("a class of 30", len(front.sessions()) >= 31 and
      all("error" not in head for head in good), len(front.sessions()))
for one in many + [ann, ben]:
    one.close()
time.sleep(0.05)
_, _, error = front.end()
check("it is a warning", b"nothing is encrypted" in error, error)
for arguments, said in ((["--port", str(again.port)], b"listens at port"),
                        (["--host", "192.0.2.7", "--class"], b"no address"),
                        (["tee.pl"], b"one more")):
    holder = socket.socket()
    holder.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    for _ in range(40):
        try:
            holder.bind(("127.0.0.1", again.port))
            break
        except OSError:
            time.sleep(0.05)
    holder.listen()
    done = subprocess.run([program, "serve", "tee.pl", "--no-open",
                           *arguments], cwd=models, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, check=False, timeout=20)
    holder.close()
    check("said: %s" % said, done.returncode == 2 and said in done.stderr,
          (done.returncode, done.stderr))

# A page that was left keeps its connections; who comes next need not wait.
front = started()
begin, left = time.time(), []
for _ in range(12):
    left.append(front.connected())
    left[-1].sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1:%d\r\n"
                     b"Connection: keep-alive\r\n\r\n" % front.port)
    check("the page", left[-1].recv(65536).startswith(b"HTTP/1.1 200"))
check("connections that are left hold nobody up", time.time() - begin < 4,
      time.time() - begin)
for one in left:
    one.close()
front.end()
checks.finish()
