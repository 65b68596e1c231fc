"""journal_fuzz.py PROGRAM FOLDER CASES SEED: journals of a document, damaged at
random, are opened: each gets one reply in words of ours within a second of
processor; the file of the model stays as it is; what a damaged journal held is
still somewhere; and the session lives on. Of a journal as the program writes it
one octet is changed, a line moved, or its end is missing: that is told, wherever
it is."""
import glob
import hashlib
import json
import os
import random
import re
import shutil
import signal
import sys

from session import Checks, Session

program, work = sys.argv[1:3]
cases, seed = int(sys.argv[3]), int(sys.argv[4])
checks = Checks()
draw = random.Random(seed)
with open("facts/family.pl", "rb") as f:
    TEXT = f.read()
os.chdir(work)
MODEL, JOURNAL = work + "/m.pl", work + "/m.journal"
END = JOURNAL + ".end"
with open(MODEL, "wb") as f:
    f.write(TEXT)
environment = dict(os.environ, LANG="C", TMPDIR=work)
TICKS = os.sysconf("SC_CLK_TCK")
RAW = re.compile(r"Unknown procedure|tack limit|I/O error|Type error|"
                 r"Domain error|sg_[a-z_]+:|\$[a-z_]+'|No permission to|"
                 r"unexpectedly|this should be|fault of the program|"
                 r"[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]")
VALUES = (None, True, 0, -1, 1.5, 1e300, 1e-320, 2 ** 70, "", "x", "\0",
          "\x1b[2J", "\u202e", [], [[]], [1], {}, {"a": 1}, "undo", "edit",
          "text", "save", "rules", "redo", "checkpoint", "v(1,1,0,0,0).",
          "a :- b.", "[" * 3000, "f(" * 50000, 10 ** 400, "9" * 100000,
          {"segment": 1, "path": [1, 1], "value": 2}, "param(w)")
# Lines of journals of other models, or of nobody.
STRANGE = ({"do": "edit", "from": 90000, "to": 90001, "with": 3},
           {"do": "edit", "from": 5, "to": 2, "with": "x"},
           {"do": "edit", "set": {"param": "pipe", "value": 70}},
           {"do": "undo"}, {"do": "redo"}, {"do": "fly"}, [], 7, "text",
           {"do": "text", "text": "v(1, 1, 0, 0, 0).\n"},
           {"do": "rules", "rules": "a :- b."},
           {"journal": 1, "file": "b.pl", "digest": "d", "text": "b."})
PIECES = (b"[", b'{"a":', b"9", b"-", b"\n", b"\0", b"\xff", b"\x1b[2J", b'"',
          b"\\u0000", b"\\ud800", b"1e", b"\\")


class Stall(Exception):
    pass


def stalled(*_):
    raise Stall


signal.signal(signal.SIGALRM, stalled)


def cpu(session):
    with open("/proc/%d/stat" % session.process.pid) as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def recorded():
    """The lines of a journal with changes of every kind."""
    session = Session(program, cwd=work, env=environment)
    head, _ = session.ask("open", file=MODEL, journal=JOURNAL)
    checks.check("a document", head and head.get("do") == "open", head)
    for do, body, keys in (
            ("text", TEXT + b"\n% more\n", {}), ("undo", b"", {}),
            ("redo", b"", {}),
            ("edit", b"", {"set": {"param": "pipe", "value": 120}}),
            ("edit", b"", {"set": {"param": "branch", "value": 70.5}})):
        head, _ = session.ask(do, body, **keys)
        checks.check("a change", head.get("do") == do, head)
    session.kill()
    with open(JOURNAL, "rb") as journal:
        whole = journal.read()
    with open(END, "rb") as file:
        end = file.read()
    rows = [json.loads(line[:-17]) for line in whole.splitlines()]
    rows[0]["journal"] = 1          # a journal without sums
    return rows, whole, end


def changed(whole):
    """Another octet somewhere, a line somewhere else, or less of it."""
    lines = whole.splitlines(True)
    kind = draw.randrange(10)
    if kind == 0:
        at, other = draw.sample(range(1, len(lines)), 2)
        lines[at], lines[other] = lines[other], lines[at]
    elif kind == 1:
        at = draw.randrange(1, len(lines))
        lines.insert(draw.randrange(1, len(lines)), lines[at])
    elif kind == 2:
        del lines[draw.randrange(1, len(lines))]
    elif kind == 8:
        del lines[draw.randrange(1, len(lines)):]
    elif kind == 9:
        return whole[:draw.randrange(len(lines[0]), len(whole))]
    if kind < 3 or kind == 8:
        return b"".join(lines)
    # The lines of changes are short: more often there.
    at = draw.randrange(len(lines[0]) if draw.random() < 0.5 else 0,
                        len(whole))
    if draw.random() < 0.3:         # a digit is another digit
        while not whole[at:at + 1].isdigit():
            at = draw.randrange(len(whole))
        octet = draw.choice([b for b in b"0123456789" if b != whole[at]])
    else:
        octet = draw.choice([b for b in range(256) if b != whole[at]])
    return whole[:at] + bytes([octet]) + whole[at + 1:]


def silent(session, text, keys):
    """Opens it; what is wrong: nobody is told of a change."""
    outcome, wrong = opened(session, text, keys, end)
    return wrong or (None if outcome != "open" else "a change is not noticed")


def checkpoint():
    return {"do": "checkpoint", "changes": 3, "text": TEXT.decode(),
            "rules": "", "past": 1,
            "steps": [{"from": 0, "to": 0, "with": "% a\n"},
                      {"from": 0, "to": 4, "with": "% b\n"}]}


def other_value(row):
    """The same with another value somewhere."""
    if isinstance(row, dict) and row and draw.random() < 0.85:
        key = draw.choice(list(row))
        row = dict(row)
        if draw.random() < 0.15:
            del row[key]
        else:
            row[key] = other_value(row[key])
        return row
    if isinstance(row, list) and row and draw.random() < 0.7:
        row = list(row)
        at = draw.randrange(len(row))
        row[at] = other_value(row[at])
        return row
    return draw.choice(VALUES)


def damaged(rows):
    rows = list(rows)
    if draw.random() < 0.3:
        rows.insert(1, checkpoint())
    if draw.random() < 0.15:
        rows.insert(draw.randrange(1, len(rows)),
                    {"do": "save", "digest": hashlib.sha256(TEXT).hexdigest()})
    for _ in range(draw.randint(0, 3)):
        at = draw.randrange(0 if draw.random() < 0.1 else 1, len(rows))
        kind = draw.randrange(7)
        if kind < 3:
            rows[at] = other_value(rows[at])
        elif kind == 3:
            rows.insert(at, rows[draw.randrange(1, len(rows))])
        elif kind == 4:
            rows.insert(at, draw.choice(STRANGE))
        elif kind == 5:
            other = draw.randrange(1, len(rows))
            rows[at], rows[other] = rows[other], rows[at]
        elif len(rows) > 2:
            del rows[at]
    text = b"".join(json.dumps(row).encode() + b"\n" for row in rows)
    if draw.random() < 0.4:
        at = draw.randrange(len(text))
        piece = draw.choice(PIECES)
        text = draw.choice((text[:at],
                            text[:at] + piece + text[at + 1:],
                            text[:at] + text[at + draw.randrange(200):],
                            text[:at] + piece * draw.choice((2, 2000, 200000))
                            + text[at:]))
    return text


def changes(text):
    """How many changes the lines tell, or None if there was a save."""
    n = 0
    for line in text.split(b"\n")[1:-1]:
        try:
            row = json.loads(line)
        except ValueError:
            return None             # Prolog reads some of these
        if not isinstance(row, dict) or "digest" in row:
            return None
        more = row.get("changes", 1)
        n += more if row.get("do") == "checkpoint" else 1
    return n


def fault(head, text, keys, kept, seconds):
    said = json.dumps(head, ensure_ascii=False)
    plain = "".join(str(message.get("words"))
                    for message in head.get("messages", [])
                    + [head[k] for k in ("error",) if k in head])
    with open(MODEL, "rb") as f:
        if f.read() != TEXT:
            return "the model is another one"
    if "rev" not in head or ("do" in head) == ("error" in head):
        return "no good reply"
    if RAW.search(plain.replace("\\n", " ")):
        return "raw words"
    if seconds > 1:
        return "a stall, %.1f s" % seconds
    if len(said) > 20000:
        return "a long reply"
    with open(JOURNAL, "rb") as journal:
        now = journal.read()
    if "error" in head:
        return None if now == text and not kept else "the journal is changed"
    codes = [message["code"] for message in head["messages"]]
    if "request_error.journal_damaged" in codes:
        if len(kept) != 1:
            return "the damaged journal is gone"
        with open(kept[0], "rb") as journal:
            return None if journal.read() == text else "kept is another one"
    told = changes(text)
    if keys.get("replay") is not False and told not in (None, head["replayed"]):
        return "changes left out in silence: %s of %s" % (head["replayed"],
                                                          told)
    return None


def opened(session, text, keys, end=None):
    """The reply to `open`, what is wrong with it, and what came of it."""
    with open(JOURNAL, "wb") as journal:
        journal.write(text)
    if end is not None:
        with open(END, "wb") as file:
            file.write(end)
    elif os.path.exists(END):
        os.remove(END)
    before = cpu(session)
    signal.alarm(60)
    head, _ = session.ask("open", file=MODEL, journal=JOURNAL, **keys)
    signal.alarm(0)
    if head is None:
        return "", "no reply"
    kept = glob.glob(JOURNAL + ".damaged-*")
    wrong = fault(head, text, keys, kept, cpu(session) - before)
    for path in kept:
        os.remove(path)
    outcome = head["error"]["code"] if "error" in head else (
        "damaged" if kept else "open")
    if not wrong and outcome in ("open", "damaged"):
        seen, octets = session.ask("text")
        again, _ = session.ask("undo")
        if "do" not in seen or not ("do" in again or "error" in again):
            wrong = "no sound session"
    return outcome, wrong


rows, whole, end = recorded()
session = Session(program, cwd=work, env=environment)
outcomes = {}
for case in range(cases):
    text = damaged(rows)
    keys = draw.choice(({}, {}, {}, {"owner": True}, {"replay": "journal"},
                        {"replay": "journal", "owner": True},
                        {"replay": False}))
    # Another file in between: one that is open already stays as it is.
    session.ask("open", file=MODEL)
    try:
        outcome, wrong = opened(session, text, keys)
    except Stall:
        outcome, wrong = "", "no end"
    outcomes[outcome] = outcomes.get(outcome, 0) + 1
    if wrong:
        with open("%s/case-%d" % (work, case), "wb") as kept:
            kept.write(text)
        checks.check("journal %d of seed %d, %s: %s" % (case, seed, keys, wrong),
                     False, text[-300:])
    if not outcome:
        session.kill()
        session = Session(program, cwd=work, env=environment)
for case in range(cases):
    text = changed(whole)
    session.ask("open", file=MODEL)
    wrong = None if text == whole else silent(session, text, draw.choice(
        ({}, {"replay": "journal"})))
    if wrong:
        with open("%s/sum-%d" % (work, case), "wb") as kept:
            kept.write(text)
        checks.check("changed journal %d of seed %d: %s" % (case, seed, wrong),
                     False, text[-300:])
for octet in (0, 11, 138, 195, 240, 255):
    session.ask("open", file=MODEL)
    wrong = silent(session, whole[:-1] + bytes([octet]), {})
    checks.check("%d for the last newline" % octet, not wrong, wrong)
signal.alarm(0)
head, _ = session.ask("hello")
checks.check("it lives on", head and head.get("do") == "hello", head)
session.kill()
for wanted in ("open", "damaged"):
    checks.check("some are %s" % wanted, outcomes.get(wanted, 0) > 0, outcomes)
print("counted: %d journals, and as many with a change, seed %d, %s" % (
    cases, seed, sorted(outcomes.items())))
checks.finish()
