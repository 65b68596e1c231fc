"""class_fuzz.py PROGRAM FOLDER: what pupils of a class may send, at random: each
request has one reply in words of ours, nobody gets at more than a pupil may, and
the class goes on. Then its book is changed at random: the class begins with what
is whole in it, says that something is not, once, and keeps it as it was. CLASS_REQUESTS, CLASS_BOOKS and
CLASS_SEED say how many, and which."""
# covers: visitor_answer, guard
import glob
import json
import os
import random
import re
import select
import shutil
import signal
import sys

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)),
                os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../cli")]
from front import Front  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
requests = int(os.environ.get("CLASS_REQUESTS", 300))
books = int(os.environ.get("CLASS_BOOKS", 12))
seed = int(os.environ.get("CLASS_SEED", 1))
checks = Checks()
check = checks.check
draw = random.Random(seed)
env = dict(os.environ, LANG="C", XDG_STATE_HOME=os.path.join(folder, "state"))
models = os.path.join(folder, "models")
os.makedirs(models)
for name in ("fig10.pl", "fig12.pl"):
    shutil.copy(os.path.join("facts/problems", name), models)
FILE = os.path.join(models, "set.pl")
with open(FILE, "w") as out:
    out.write("""problem(fig12, 'fig12.pl',
        [ given([front, top]), ask(draw(penetration)), ask(count(loops)) ]).
problem(more, 'fig10.pl', [ given([front, top, right]), ask(count(loops)),
                            ask(measure(edge(1, 1, 5), mm, 0.1)) ]).
variant(more, a in [36, 40], seed(7)).
sheet('A3', [fig12, more], []).
pupils(['Kim', 'Lee']).
""")
with open(FILE, "rb") as text:
    SET = text.read()
DO = ("hello", "join", "class", "problems", "problem", "open", "view", "ask",
      "next", "text", "edit", "rules", "save", "export", "run", "stop",
      "upload", "models", "show", "tree", "complete", "explain", "undo", "fly",
      "", None, 7, [])
KEYS = ("name", "problem", "number", "answers", "show", "lang", "file", "pupil",
        "turn", "token", "owner", "argv", "goal", "journal", "replay", "keep",
        "try", "format", "port", "options", "set", "cpu_s", "id", "event")
VALUES = (None, True, False, 0, 1, -1, 1.5, 1e300, 2 ** 70, "", "x", "Kim",
          " \u00a0", "a\0b", "\x1b[2J", "\u202e", "상관", "x" * 60, "x" * 61,
          "n" * 100000, [], [1], ["1"], ["1", "2 mm"], ["9" * 9000], [None],
          [["1"]], {}, {"a": 1}, [[[[]]]], "fig12", "more", "fig12.pl", FILE,
          "/etc/passwd", "../set.pl", "a" * 32, ["draw", "fig12.pl"],
          "shell(ls)", "v(1,V,X,Y,Z)", "ko", "strokes", "journal")
USUAL = {"problem": "fig12", "answers": ["1"], "name": "Lee", "lang": "ko"}
RAW = re.compile(r"Unknown procedure|tack limit|I/O error|Type error|"
                 r"Domain error|sg_[a-z_]+:|\$[a-z_]+'|fault of the program|"
                 r"[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]")


class Stall(Exception):
    pass


def stalled(*_):
    raise Stall


signal.signal(signal.SIGALRM, stalled)


def started():
    signal.alarm(60)
    front = Front(program, models, None, ("--problems", FILE), env)
    front.code = front.process.stdout.readline().decode().strip().split(
        "/#")[1]
    signal.alarm(0)
    return front


def pupil(front, secret):
    page = front.socket()
    page.say({"id": 0, "do": "hello", "token": front.code, "pupil": secret})
    page.hello = page.hear()[0]
    return page


def head_of(number):
    head = dict(USUAL) if draw.random() < 0.5 else {}
    for _ in range(draw.randrange(4)):
        head[draw.choice(KEYS)] = draw.choice(VALUES)
    head["do"] = draw.choice(DO) if draw.random() < 0.6 else draw.choice(
        ("join", "problem", "problem", "problems"))
    head["id"] = number
    return head


def damaged(octets):
    at = draw.randrange(len(octets))
    return draw.choice((octets[:at], octets[:at] + bytes([draw.randrange(256)])
                        + octets[at + 1:], b"", b"[]", b"7", b"{}", b"\xff",
                        b"[" * 5000, os.urandom(30)))


def wrong(head, sent):
    """What is wrong with the reply to what was sent."""
    if not ("do" in head or head.get("error")):
        return "no good reply"
    error = head.get("error") or {}
    plain = " ".join(error.get("words", {}).values())
    if RAW.search(plain):
        return "raw words"
    if len(plain) > 20000:
        return "long words"
    if not error and sent["do"] in ("class", "run", "rules", "show"):
        return "a pupil may not"
    if not error and sent["do"] == "open":
        return "a model with the answers"
    return None


def row_is_good(row):
    return (isinstance(row["name"], str) and 0 < len(row["name"]) <= 60 and
            row["name"].isprintable() and all(
                isinstance(one["problem"], str) and
                isinstance(one["number"], int) and
                isinstance(one["tries"], int) and one["tries"] > 0 and
                isinstance(one["answers"], list) and one["shown"] in
                (True, False) and all(right in (True, False)
                                      for right in one["right"])
                for one in row["done"]))


front = started()
teacher = front.page()
pupils = {}
outcomes = {}
lost = 0
for case in range(requests):
    secret = draw.choice(("a" * 32, "b" * 32, "c" * 32))
    if secret not in pupils:
        pupils[secret] = pupil(front, secret)
        if draw.random() < 0.7:
            pupils[secret].ask("join", name="Kim")
    page = pupils[secret]
    sent = head_of(1000000 + case)
    if case % 50 == 0:
        teacher.say({"do": "alive"})    # as a page says each 25 s
    signal.alarm(60)
    try:
        if draw.random() < 0.1:
            octets = damaged(json.dumps(sent).encode())
            page.frame(draw.choice((1, 1, 1, 2, 9)), octets)
            head = page.ask("hello", token=front.code, pupil=secret)[0]
            sent = {"do": "hello"}
        else:
            page.say(sent)
            head = page.hear()[0]
            while not isinstance(head, int) and (
                    head.get("id") != sent["id"] or "progress" in head):
                head = page.hear()[0]
        if isinstance(head, int):
            raise EOFError
        fault = wrong(head, sent)
        of = (head.get("error") or {}).get("code", "done")
        outcomes[of] = outcomes.get(of, 0) + 1
    except (EOFError, OSError):
        fault = None                # the page was sent away
        lost += 1
        del pupils[secret]
    except Stall:
        fault = "no reply"
        del pupils[secret]
    signal.alarm(0)
    if fault:
        check("request %d of seed %d: %s: %s" % (case, seed, fault, sent),
              False, head)
with open(FILE, "rb") as text:
    check("the problems are as they were", text.read() == SET)
kim = pupil(front, "d" * 32)
check("the class goes on", kim.ask("join", name="Park")[0].get("name") == "Park"
      and kim.ask("problem", problem="fig12", answers=["1"])[0].get("checked"))
check("most have a reply", lost < requests // 4, lost)
rows = teacher.ask("class")[0]["pupils"]
check("the table", rows and all(row_is_good(row) for row in rows), rows)
check("nobody else is in it", len(rows) <= 4, rows)
for page in list(pupils.values()) + [kim, teacher]:
    page.close()
status, _, _ = front.end(signal.SIGTERM)
check("it ends", status == 143, status)
(BOOK,) = [os.path.join(at, name) for at, _, names in
           os.walk(env["XDG_STATE_HOME"]) for name in names
           if name.endswith(".answers")]
with open(BOOK, "rb") as text:
    WHOLE = text.read()


def changed(case):
    """A book with other octets, and how many of its lines are whole."""
    if case % 3 == 0:
        # Another one for the last newline; zero ends a line, too.
        end = draw.choice([b for b in range(1, 256) if b != 10])
        return WHOLE[:-1] + bytes([end]), sum(
            1 for line in WHOLE.split(b"\n") if line) - 1
    lines = WHOLE.split(b"\n")[:-1]
    kept = list(lines)
    for _ in range(draw.choice((1, 1, 2, 5))):
        at = draw.randrange(len(kept))
        kind = draw.randrange(4)
        if not kept[at]:
            continue
        if kind < 2:
            i = draw.randrange(len(kept[at]))
            octet = draw.choice([b for b in range(256) if b != kept[at][i]])
            kept[at] = kept[at][:i] + bytes([octet]) + kept[at][i + 1:]
        elif kind == 2:
            kept[at] = kept[at][:draw.randrange(len(kept[at]))]
        else:
            kept[at] = json.dumps(draw.choice(
                [{"pupil": p, "name": n, "turn": t} for p, n, t in (
                    ("0", "a\0b", 1), (1, "x", 2), ("0", "", 1))] +
                [{"pupil": "0", "problem": "fig12", "number": n, "answers": a,
                  "right": r, "shown": s} for n, a, r, s in (
                      (1.5, [], [], True), (1, 7, [True], True),
                      (1, ["1"], [1], False), (1, ["1"], [True], 3))] +
                [[], 7, {}])).encode()
    return b"\n".join(kept) + b"\n", sum(
        1 for line in lines if line and line in kept)


def told(front):
    """What it has said on standard error so far."""
    said = b""
    while select.select([front.process.stderr], [], [], 0)[0]:
        octets = os.read(front.process.stderr.fileno(), 65536)
        if not octets:
            break
        said += octets
    return said


for case in range(books):
    text, whole = changed(case)
    with open(BOOK, "wb") as out:
        out.write(text)
    try:
        front = started()
    except (Stall, IndexError, ValueError) as error:
        check("book %d of seed %d: it begins" % (case, seed), False, error)
        continue
    teacher = front.page()
    rows = teacher.ask("class")[0]["pupils"]
    check("book %d of seed %d: the table" % (case, seed),
          all(row_is_good(row) for row in rows), rows)
    kim = pupil(front, "d" * 32)
    check("book %d of seed %d: a pupil" % (case, seed),
          "error" not in kim.ask("join", name="Park")[0])
    said = told(front)
    check("book %d of seed %d: that it is damaged" % (case, seed),
          b"book of the class" in said or whole == sum(
              1 for line in WHOLE.split(b"\n") if line), (said, whole))
    teacher.close()
    kim.close()
    front.end(signal.SIGTERM)
    kept = glob.glob(BOOK + ".damaged-*")
    check("book %d of seed %d: as it was" % (case, seed), whole == sum(
        1 for line in WHOLE.split(b"\n") if line) or [
            open(path, "rb").read() for path in kept] == [text], kept)
    for path in kept:
        os.remove(path)
    front = started()
    teacher = front.page()
    again = teacher.ask("class")[0]["pupils"]
    said = told(front)
    check("book %d of seed %d: said once" % (case, seed),
          b"book of the class" not in said and
          [row for row in again if row["name"] != "Park"] ==
          [row for row in rows if row["name"] != "Park"], (said, again))
    teacher.close()
    front.end(signal.SIGTERM)
print("counted: %d requests of pupils, %d books, seed %d, %s" % (
    requests, books, seed, sorted(outcomes.items())))
checks.finish()
