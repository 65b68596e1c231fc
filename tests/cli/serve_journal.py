"""serve_journal.py PROGRAM FOLDER: changes go into the journal, and kill -9, a full
disk or a damaged file loses nothing that was told."""
# covers: document_journal
import glob
import hashlib
import json
import os
import random
import re
import shutil
import struct
import threading
import time

from serving import (TEXT, check, checks, code, environment, model, program,
                     read, session, work)
from session import Session

# ---- the journal: killed at random, nothing that was told is lost ----

draw = random.Random(int(os.environ.get("SERVE_SEED", "1")))
with open(model, "w") as f:
    f.write(TEXT)
kills = int(os.environ.get("SERVE_KILLS", "12"))
text = maybe = TEXT
seen, going_back, wishing, rounds = {TEXT}, False, False, 0


def no_wishes(of):
    return [line for line in of.split("\n")
            if line and not line.startswith("unfolding(")]


for kill in range(kills):
    s = session()
    head, _ = s.ask("open", file=model, journal=True, owner=True)
    check("replayed", "error" not in head, head)
    got = s.ask("text")[1].decode()
    # What was told is there. One more step may be, which was not told.
    check("killed %d: the text" % kill, got in (text, maybe) or
          going_back and got in seen or
          wishing and no_wishes(got) == no_wishes(text), (got, text, maybe))
    text = maybe = got
    timer = threading.Timer(draw.uniform(0, 0.6), s.process.kill)
    timer.start()
    try:
        while True:
            value = draw.randint(10, 25)
            do, keys = draw.choice(
                [("edit", {"set": {"segment": 2, "path": [2, 2, 1, 1],
                                   "value": value}})] * 4 +
                [("cut", {"segment": 1, "edge": value,
                          "keep": draw.choice((True, False))})] * 2 +
                [("rules", {"owner": True, "try": True})] +
                [("undo", {}), ("redo", {}), ("save", {})])
            going_back = do in ("undo", "redo")
            wishing = do == "cut"
            if do == "edit":
                at = text.index("cylinder(radius(") + len("cylinder(radius(")
                maybe = text[:at] + str(value) + text[text.index(")", at):]
            head, _ = s.ask(do, **keys)
            if head is None:
                break
            if do == "rules":
                # The same picture by other means: kept, it is in the journal.
                check("tried", "error" not in head, head)
                head, _ = s.ask("rules", keep=True, owner=True)
                if head is None:
                    break
            if "error" in head:
                check("only what cannot be", code(head) in
                      ("request_error.nothing_to", "model_error.unfold"), head)
                going_back = wishing = False
                continue
            rounds += 1
            if do == "edit":
                text = maybe
            elif going_back or wishing:
                head, octets = s.ask("text")
                if head is None:
                    break
                text = maybe = octets.decode()
            going_back = wishing = False
            seen.add(text)
    except (OSError, ValueError, struct.error, TypeError):
        pass  # half a reply
    timer.cancel()
    s.kill()
print("%d changes, %d kills" % (rounds, kills))

# Who opens again what is open finds it as it is, also what went before.
with open(model, "w") as f:
    f.write(TEXT)
s = session()
keys = {"file": model, "journal": work + "/again.journal"}
first, _ = s.ask("open", **keys)
s.ask("edit", set={"segment": 1, "path": [1, 1], "value": 0.5})
edited = s.ask("text")[1]
lines = read(work + "/again.journal")
head, _ = s.ask("open", **keys)
check("opened again", head["rev"] == first["rev"] + 1 and
      head["replayed"] == 1 and s.ask("text")[1] == edited and
      read(work + "/again.journal") == lines, head)
os.remove(work + "/again.journal")
head, _ = s.ask("open", **keys)
check("its journal is gone: begun anew", head["rev"] == first["rev"] + 2 and
      head["replayed"] == 0 and s.ask("text")[1].decode() == TEXT, head)
with open(model, "a") as f:
    f.write("% another hand\n")
head, _ = s.ask("open", **keys)
check("its file is another: read anew", head["rev"] == first["rev"] + 3 and
      s.ask("text")[1] == read(model), head)
with open(model, "w") as f:
    f.write(TEXT.replace("radius(20)", "radius(2,5)"))
for again in (1, 2):
    head, _ = s.ask("open", **keys)
    check("what loading warned of, %d" % again, [m["code"] for m in
          head.get("messages", [])] == ["comma"], head)
head, _ = s.ask("edit", set={"segment": 1, "path": [1, 1], "value": 0.5})
head, _ = s.ask("undo")
check("and after undo", [m["code"] for m in head.get("messages", [])]
      == ["comma"], head)
s.kill()
with open(model, "w") as f:
    f.write(TEXT)

# A line that is not complete, and a journal of another text.
journal = work + "/a.journal"
with open(model, "w") as f:
    f.write(TEXT)
s = session()
s.ask("open", file=model, journal=journal)
for value in (30, 31):
    s.ask("edit", set={"segment": 1, "path": [1, 1], "value": value})
s.kill()
with open(journal, "a") as f:
    f.write('{"do":"edit","from":1')
s = session()
head, _ = s.ask("open", file=model, journal=journal)
check("two steps", head["replayed"] == 2 and
      "radius(31)" in s.ask("text")[1].decode(), head)
s.ask("undo")
check("undo behind a replay", "radius(30)" in s.ask("text")[1].decode())
s.kill()
# A line that lacks its newline alone was told to nobody either: the disk was
# full behind the brace.
s = session()
s.ask("open", file=model, journal=journal)
told = s.ask("text")[1]
s.ask("edit", set={"segment": 1, "path": [1, 1], "value": 32})
s.kill()
with open(journal, "rb+") as f:
    f.truncate(os.path.getsize(journal) - 1)
os.remove(journal + ".end")     # as when nobody was told
s = session()
head, _ = s.ask("open", file=model, journal=journal)
check("what lacks its newline", s.ask("text")[1] == told and
      not head["messages"], head)
# Changes that were told are missing at the end: the ones before are done, and
# that is said once.
told = s.ask("text")[1]
for value in (33, 34, 35):
    s.ask("edit", set={"segment": 1, "path": [1, 1], "value": value})
s.kill()
whole, end = read(journal), read(journal + ".end")
for missing in (1, 2, 3, 0.5):
    lines = whole.splitlines(True)
    cut = (b"".join(lines[:-missing]) if missing >= 1 else
           whole[:-len(lines[-1]) // 2])
    for path, content in ((journal, cut), (journal + ".end", end)):
        with open(path, "wb") as f:
            f.write(content)
    kept = len(glob.glob(journal + ".damaged-*"))
    s = session()
    head, _ = s.ask("open", file=model, journal=journal)
    check("told and missing: %g" % missing, [m["code"] for m in
          head["messages"]] == ["request_error.journal_damaged"] and
          read("%s.damaged-%d" % (journal, kept + 1)) == cut and
          head["replayed"] == 3 + int(3 - missing), head)
    s.kill()
    s = session()
    head, _ = s.ask("open", file=model, journal=journal)
    check("said once", head["messages"] == [], head)
    s.ask("text")
    s.kill()
# An end of another text, or one that is damaged, says nothing.
for strange in (end[:-20], end.replace(b'octets":', b'octets":9'), b"", b"7\n"):
    with open(journal + ".end", "wb") as f:
        f.write(strange)
    s = session()
    head, _ = s.ask("open", file=model, journal=journal)
    check("a strange end", head["messages"] == [], (strange, head))
    s.kill()
with open(journal, "wb") as f:
    f.write(b"".join(whole.splitlines(True)[:-3]))
os.remove(journal + ".end")
# The file is gone: what was changed is there still, and can be saved.
os.remove(model)
s = session()
head, _ = s.ask("open", file=model, journal=journal)
check("no file, but changes", head.get("replayed") == 3 and
      s.ask("text")[1] == told and s.ask("tree")[0]["saved"] is False, head)
head, _ = s.ask("open", file=model, journal=work + "/none.journal")
check("no file, no changes", code(head) == "model_error.cannot_read", head)
head, _ = s.ask("save")
check("saved, it is there", "error" not in head and read(model) == told, head)
s.kill()
with open(model, "w") as f:
    f.write(TEXT)
s = session()
head, _ = s.ask("open", file=model, journal=journal, replay=False)
for value in (30, 31):
    s.ask("edit", set={"segment": 1, "path": [1, 1], "value": value})
s.kill()
with open(model, "a") as f:
    f.write("% changed\n")
s = session()
head, _ = s.ask("open", file=model, journal=journal)
check("another text", code(head) == "request_error.journal_of_another", head)
head, _ = s.ask("open", file=model, journal=journal, replay=False)
check("without it", head.get("replayed") == 0, head)
head, _ = s.ask("open", file=model, journal=7)
check("which journal", code(head) == "request_error.bad_key", head)
head, _ = s.ask("open", file=model, journal=model)
check("a model is no journal", code(head) == "request_error.no_journal" and
      read(model).startswith(b"%"), head)

# A change is on the disk before it is told, and so is the name of its journal.
if shutil.which("strace"):
    s.kill()
    traced, calls = work + "/traced", work + "/calls"
    with open(traced, "w") as f:
        f.write('#!/bin/bash\nunset SANGGWAN_SYNC\nexec strace -f -y -o %s -e '
                'trace=write,writev,fsync,rename,renameat,renameat2 %s "$@"\n'
                % (calls, program))
    os.chmod(traced, 0o755)
    s = Session(traced, env=environment)
    s.ask("open", file=model, journal=work + "/traced.journal", replay=False)
    for value in (41, 42):
        s.ask("edit", set={"segment": 1, "path": [1, 1], "value": value})
    s.ask("undo")
    s.end()
    waits, replies, renamed, synced = False, [], False, False
    for line in read(calls).decode().split("\n"):
        if re.search(r"write\w*\(\d+<[^>]*traced\.journal(\.new)?>", line):
            waits = True
        elif re.search(r"fsync\(\d+<[^>]*traced\.journal", line):
            waits = False
        elif re.search(r"rename\w*\(.*traced\.journal", line):
            renamed = True
        elif renamed and "fsync(" in line and "<%s>" % work in line:
            synced = True
        elif re.search(r"write\w*\(\d+<pipe:", line):
            replies.append(waits)
    check("on the disk before it is told", len(replies) >= 4 and
          not any(replies), replies)
    check("the journal's name is on the disk", synced, read(calls)[-3000:])
    s = session()

# Who waited for a long journal does not wait again: it is the same, and short.
with open(model, "w") as f:
    f.write(TEXT)
edit = {"do": "edit", "from": TEXT.index("radius(") + 7, "with": 7,
        "to": TEXT.index(")", TEXT.index("radius("))}
with open(journal, "w") as f:
    f.write(json.dumps({"journal": 1, "file": model, "text": TEXT, "digest":
                        hashlib.sha256(TEXT.encode()).hexdigest()}) + "\n")
    for i in range(12000):
        edit["with"] = 1000 + i % 8000 if i else 1000
        f.write(json.dumps(edit) + "\n")
        edit["to"] = edit["from"] + 4
s.kill()
s = session()
before = time.time()
head, _ = s.ask("open", file=model, journal=journal)
took = time.time() - before
check("a long journal", head.get("replayed") == 12000 and
      b"radius(4999)" in s.ask("text")[1], head)
lines = read(journal).count(b"\n")
check("a checkpoint", lines == 2 or lines == 12001 and took < 8,
      (lines, took))
s.ask("undo")
s.ask("edit", set={"segment": 1, "path": [1, 1], "value": 70})
s.kill()
s = session()
head, _ = s.ask("open", file=model, journal=journal)
check("what came behind it", head.get("replayed") == 12002 and
      b"radius(70)" in s.ask("text")[1], head)
for _ in range(999):
    head, _ = s.ask("undo")
check("a thousand steps back", "error" not in head and
      b"radius(4000)" in s.ask("text")[1], s.ask("text")[1])

# Changes after which the text does not load: neither file alone is wrong.
with open(journal, "w") as f:
    f.write(json.dumps({"journal": 1, "file": model, "text": TEXT, "digest":
                        hashlib.sha256(TEXT.encode()).hexdigest()}) + "\n")
    f.write(json.dumps({"do": "text", "text": TEXT + "fly(1).\n"}) + "\n")
os.remove(journal + ".end")
head, _ = s.ask("open", file=model)
head, _ = s.ask("open", file=model, journal=journal)
check("what does not load has two files",
      code(head) == "model_error.unknown_relation" and
      head["error"]["file"] == "%s + %s" % (model, journal) and
      head["error"]["line"] == TEXT.count("\n") + 1, head)
os.remove(journal)

# A full disk: the change is refused, and all that follow, until it is opened
# again.
head, _ = s.ask("open", file=model, journal=journal)
os.symlink("/dev/full", work + "/full.journal.new")
before = s.ask("text")[1]
head, _ = s.ask("open", file=model, journal=work + "/full.journal")
check("no journal can be begun", "error" in head, head)
check("the document is as before", s.ask("text")[1] == before)
check("end", s.end() == (0, b""))
small = work + "/small"
with open(small, "w") as f:
    f.write('#!/bin/bash\nulimit -f 3; exec "%s" "$@"\n' % program)
os.chmod(small, 0o755)
s = Session(small, env=environment)
head, _ = s.ask("open", file=model, journal=journal, replay=False)
change = {"segment": 1, "path": [1, 1], "value": 33}
done, told = 0, s.ask("text")[1]
while done < 200:
    change["value"] = done + 20
    head, _ = s.ask("edit", set=change)
    if "error" in head:
        break
    done, told = done + 1, s.ask("text")[1]
check("the journal is full", 20 < done < 200, done)
check("what is not in it is not done", s.ask("text")[1] == told, head)
head, _ = s.ask("edit", set=change)
check("and no change", "error" in head and s.ask("text")[1] == told, head)
s.kill()
s = session()
head, _ = s.ask("open", file=model, journal=journal)
check("what was told is there", s.ask("text")[1] == told and
      head["replayed"] == done, head)
check("end", s.end() == (0, b""))
checks.finish()
