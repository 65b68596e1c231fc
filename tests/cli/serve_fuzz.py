"""serve_fuzz.py PROGRAM FOLDER FRAMES SEED: random requests, and frames with
random octets in them: each gets one reply, and the session lives on."""
import json
import os
import random
import shutil
import struct
import sys
import threading

from session import Checks, Session

program, work = sys.argv[1:3]
frames, seed = int(sys.argv[3]), int(sys.argv[4])
checks = Checks()
check = checks.check
environment = dict(os.environ, LANG="C", TMPDIR=work)
draw = random.Random(seed)
MODEL = work + "/m.pl"
# It works in a folder of its own: a journal may be asked for anywhere.
shutil.copytree("facts", work + "/facts")
os.chdir(work)
with open("facts/two_cubes.pl", "rb") as f:
    TEXT = f.read()
with open(MODEL, "wb") as f:
    f.write(TEXT)

DO = ("hello", "run", "stop", "open", "edit", "undo", "redo", "text", "view",
      "ask", "next", "explain", "export", "help", "complete", "select",
      "unfold", "fold", "cut", "rules", "save", "fly", "", None, 7)
KEYS = ("argv", "cwd", "lang", "memory_mb", "cpu_s", "file", "journal",
        "replay", "view", "format", "port", "size", "segments", "goal",
        "owner", "of", "item", "options", "set", "at", "id", "do", "progress",
        "names", "text", "segment", "edge", "keep", "sheet", "try", "scale",
        "projection", "up")
VALUES = (None, True, False, 0, 1, -1, 1.5, 1e300, 2 ** 70, "", "x", "en",
          "ko", "\0", "\u202e\uffff", "상관", [], [1], ["check"],
          ["check", "facts/cube.pl"], ["draw", "facts/cube.pl"], {}, {"a": 1},
          [[[[]]]], MODEL, "facts/cube.pl", "/", "line(1)", "v(1,V,X,Y,Z)",
          "X = f(X)", "a :- b", "'", "isometric", [30, 60], "svg",
          {"segment": 1, "path": [1, 1], "value": 2},
          {"segment": 1, "path": [3, 1], "value": -1}, ["s1e7", "l1", "s2"],
          "strokes", "base-side(3)", "line/9", "central")
USUAL = {"argv": ["check", "facts/cube.pl"], "file": MODEL, "goal": "v(1,V,X,Y,Z)",
         "item": "line(1)", "of": 1, "view": "isometric",
         "set": {"segment": 1, "path": [1, 1], "value": 2},
         "names": ["s1e7"], "text": "li", "segment": 1, "edge": 3}


def request():
    head = dict(USUAL) if draw.random() < 0.6 else {}
    for _ in range(draw.randrange(4)):
        head[draw.choice(KEYS)] = draw.choice(VALUES)
    head["id"] = draw.choice((1, 2, "a", None, 1.5, []))
    head["do"] = draw.choice(DO)
    head.pop("cpu_s" if draw.random() < 0.9 else "x", None)
    head.pop("memory_mb", None)
    if "force" in head or head.get("owner") is True:
        head["owner"] = False
    return json.dumps(head).encode()


def octets():
    """A frame of the length that it says."""
    head = request()
    body = draw.choice((b"", b"", b"x", b"\xff\0", TEXT))
    kind = draw.randrange(6)
    if kind == 0 and head:
        at = draw.randrange(len(head))
        head = head[:at] + bytes([draw.randrange(256)]) + head[at + 1:]
    elif kind == 1:
        head = head[:draw.randrange(len(head) + 1)]
    elif kind == 2:
        head = bytes(draw.randrange(256) for _ in range(draw.randrange(40)))
    h = len(head)
    if kind == 3:
        h = draw.choice((0, h + 1, 2 ** 31, 2 ** 32 - 1))
    return struct.pack(">II", 4 + len(head) + len(body), h) + head + body


def fed(session, some):
    try:
        for frame in some:
            session.octets(frame)
    except OSError:
        pass


sent = 0
lives = 0
while sent < frames:
    some = [octets() for _ in range(min(500, frames - sent))]
    session = Session(program, env=environment)
    lives += 1
    feeder = threading.Thread(target=fed, args=(session, some))
    feeder.start()
    for i, frame in enumerate(some):
        head, _ = session.reply()
        while head and "progress" in head:
            head, _ = session.reply()
        sent += 1
        if head is None:
            check("a reply to %r" % frame[:300], False,
                  (session.process.wait(), session.process.stderr.read()))
            break
        good = "rev" in head and ("do" in head or "error" in head)
        if not good or i % 50 == 0:
            check("a good reply", good, head)
        if head.get("last"):
            break
    else:
        feeder.join()
        head, _ = session.ask("hello")
        check("it lives on", head and head.get("do") == "hello", head)
    session.kill()
    feeder.join()
    with open(MODEL, "wb") as f:
        f.write(TEXT)
print("%d frames, %d sessions, seed %d" % (sent, lives, seed))
checks.finish()
