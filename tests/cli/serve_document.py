"""serve_document.py PROGRAM FOLDER: the document of a session: pictures and
explanations are those of the command line, questions have limits, changes go
into the text and into the journal, and kill -9 loses nothing."""
# covers: document_content, document_journal, question_part
import glob
import hashlib
import json
import os
import random
import re
import shutil
import struct
import subprocess
import sys
import threading
import time

from session import Checks, Session

program, work = sys.argv[1:3]
checks = Checks()
check = checks.check
environment = {k: v for k, v in os.environ.items()
               if k not in ("LC_ALL", "LC_MESSAGES")}
environment.update(LANG="C", XDG_STATE_HOME=work + "/state")


def alone(*argv, body=b""):
    p = subprocess.run([program, *argv], input=body, capture_output=True,
                       env=environment)
    return p.returncode, p.stdout, p.stderr


def session():
    return Session(program, env=environment)


def code(head):
    return (head.get("error") or {}).get("code", "")


def read(file):
    with open(file, "rb") as f:
        return f.read()


# ---- without a document ----

s = session()
for do, keys in (("view", {}), ("ask", {"goal": "true"}), ("undo", {}),
                 ("text", {}), ("save", {}), ("edit", {"set": {}}),
                 ("explain", {"item": "line(1)"}),
                 ("export", {"argv": ["draw", "-o", "a.svg"]})):
    head, _ = s.ask(do, **keys)
    check("no document: " + do, code(head) == "request_error.no_document",
          head)
head, _ = s.ask("open")
check("open what", code(head) == "request_error.bad_key", head)
head, _ = s.ask("open", file="no_such_file.pl")
check("open: missing", code(head) == "model_error.cannot_read", head)
bad = work + "/bad.pl"
with open(bad, "w") as f:
    f.write("v(1,1,0,0,0).\nv(1,2,zero,0,0).\n")
head, _ = s.ask("open", file=bad)
check("open: bad", code(head) == "model_error.value" and
      (head["error"]["file"], head["error"]["line"]) == (bad, 2), head)
check("revision 0", head["rev"] == 0, head)

# ---- pictures are those of draw ----

for file in ("facts/figures/fig13.pl", "facts/pipe_tee.pl",
             "facts/two_cubes.pl", "facts/smooth.pl"):
    head, _ = s.ask("open", file=file)
    check("open " + file, head.get("do") == "open" and
          [one["segment"] for one in head["segments"]] ==
          sorted({one["segment"] for one in head["segments"]}) != [], head)
    for form in ("svg", "json"):
        for keys, options in (({}, []),
                              ({"view": "isometric"}, ["--view", "isometric"]),
                              ({"view": [30, 60], "hidden": "removed"},
                               ["--view", "30,60", "--hidden", "removed"])):
            # Twice: the first one leaves nothing behind.
            for again in (1, 2):
                head, octets = s.ask("view", format=form, **keys)
                wanted = alone("draw", file, "-o", "-", "--format", form,
                               *options)
                check("%s %s %s" % (file, form, keys), octets == wanted[1],
                      (head, len(octets), len(wanted[1])))
for keys in ({"view": 1}, {"view": [1]}, {"format": "stl"}, {"hidden": "x"},
             {"size": [1]}, {"port": 1}, {"segments": 1}, {"crease": -1}):
    head, _ = s.ask("view", **keys)
    check("view %s" % keys, code(head) == "request_error.bad_key", head)
head, _ = s.ask("view", view="sideways")
check("no such view", code(head) != "", head)
head, octets = s.ask("view")
check("still a view", octets.startswith(b"<?xml"), head)

# A newer view of the same port replaces an older one that waits.
s.send({"id": "busy", "do": "ask", "goal": "sleep(0.5)", "owner": True})
for i in range(20):
    s.send({"id": i, "do": "view", "port": "a", "view": [i, 60]})
    s.send({"id": 100 + i, "do": "view", "port": "b", "view": [i, 60]})
replies = [s.reply()[0] for i in range(41)]
done = [head["id"] for head in replies if "kind" in head]
replaced = [head["id"] for head in replies if head.get("replaced")]
check("the newest view is done", 19 in done and 119 in done, done)
check("older ones are replaced", len(replaced) >= 30 and
      len(done) + len(replaced) == 40, (done, replaced))

# ---- questions ----

s.ask("open", file="facts/two_cubes.pl")
head, _ = s.ask("ask", goal="line(L, S1, _, _, _, S2, _, _, _)")
check("lines are there", head["names"] == ["L", "S1", "S2"] and
      len(head["answers"]) > 3 and head["left"] == 0, head)
head, _ = s.ask("ask", goal="between(1, 120, X)")
first = head
got = list(head["answers"])
asked = s.number
while head["left"]:
    check("parts of 50", len(head["answers"]) == 50, head)
    head, _ = s.ask("next", of=asked)
    got += head["answers"]
check("all answers", got == [[i] for i in range(1, 121)], got)
head, _ = s.ask("next", of=asked)
check("no more", code(head) == "request_error.no_answers_left", head)
head, _ = s.ask("next")
check("of what", code(head) == "request_error.bad_key", head)
head, _ = s.ask("ask", goal="between(1, 20000, X)")
check("10,000 at most", head["cut"] is True and head["left"] == 9950, head)
head, _ = s.ask("ask", goal="fail")
check("no answer", head["answers"] == [] and head["cut"] is False, head)
head, _ = s.ask("ask", goal="X = f(Y, 'a b'), Z = \"t\", W = [1, 2.5], N = ab")
check("values", head["answers"] == [["f(A,'a b')", "A", "t", [1, 2.5], "ab"]]
      or head["answers"][0][0].startswith("f("), head)
head, octets = s.ask("ask", goal="write(printed)", owner=True)
check("what it prints", octets == b"printed", (head, octets))
head, _ = s.ask("ask", goal="assertz(a(1)), a(X)")
head, _ = s.ask("ask", goal="a(X)")
check("what others assert is gone", code(head) == "existence_error", head)
for goal in ("shell(ls)", "evaluate", "assertz(user:a)", "open(a, write, _)",
             "penetrate", "facts_undo", "X = 1, call(shell, ls)",
             "retract_fact(v(1,1,_,_,_))", "halt", "set_limit(depth, 1)",
             "assertz(sg_session:a)", "thread_self(X), thread_signal(X, halt)"):
    head, _ = s.ask("ask", goal=goal)
    check("may not: " + goal, code(head) != "", head)
# What library(sandbox) follows, and calls all the same: another module, a file, the
# words of a message.
here = os.path.join(work, "was_here")
with open(os.path.join(work, "evil.pl"), "w") as out:
    out.write(":- open('%s', append, S), close(S).\n" % here)
touch = "open('%s', append, S), close(S)" % here
words = "format('~@', [(%s)])" % touch
for goal, wanted in [
        ("print_message(error, %s)" % words, "request_error.unsafe_goal"),
        ("maplist(print_message, [error], [%s])" % words,
         "request_error.unsafe_goal"),
        ("message_to_string(%s, T)" % words, "request_error.unsafe_goal"),
        ("throw(%s)" % words, "request_error.thrown"),
        ("throw(error(%s, _))" % words, "request_error.thrown"),
        ("throw(error(type_error(a, b), context(c/1, %s)))" % words,
         "request_error.thrown"),
        ("X = [0'~, 0'@], throw(format(X, [(%s)]))" % touch,
         "request_error.thrown"),
        ("throw('~0@'-[(%s)])" % touch, "request_error.thrown")] + [
            (goal, "request_error.unsafe_goal") for goal in (
                "use_module(evil)", "use_module('evil.pl')",
                "call(use_module, evil)", "load_files(evil, [])",
                "sg_document:trial_committed(\"may_cut(_, _) :- %s.\")" % touch,
                "sg_document:trial_left", "sg_document:assertz(tried_(\"x\"))",
                "sandbox:assertz(safe_primitive(system:shell(_)))",
                "@(assertz(tried_(\"x\")), sg_document)",
                "X =.. [:, sg_document, trial_left], X = Y",
                "'$set_source_module'(_, sg_document)",
                "facts_snapshot(sg_document:trial_left)")]:
    head, _ = s.ask("ask", goal=goal)
    check("may not: " + goal, code(head) == wanted, head)
    check("did not: " + goal, not os.path.exists(here))
for goal in ("throw(error(type_error(integer, a), _))", "throw(mine)"):
    check("told: " + goal, code(s.ask("ask", goal=goal)[0]) in
          ("type_error", "mine"), head)
check("no rules are tried", s.ask("rules")[0]["tried"] is False)
for goal, wanted in (("X = ", "usage_error.bad_goal"),
                     ("X is foo+1", "type_error"),
                     ("no_such_predicate(1)", "existence_error"),
                     ("repeat, fail", "request_error.too_long"),
                     ("numlist(1, 100000000, L), length(L, N)", "")):
    began = time.time()
    head, _ = s.ask("ask", goal=goal)
    check("ends: " + goal, code(head).startswith(wanted) and code(head) != "",
          head)
    check("within its time: " + goal, time.time() - began < 20)
head, _ = s.ask("ask", goal="length(L, 2)")
check("after it", head["answers"] != [], head)
head, _ = s.ask("ask", goal="retract_fact(v(1,1,_,_,_)), \\+ v(1,1,_,_,_)",
                owner=True)
check("the owner may", head.get("owner") is True or code(head) != "", head)
head, _ = s.ask("ask", goal="aggregate_all(count, v(_,_,_,_,_), N)")
check("but in a snapshot", head["answers"][0][0] > 16, head)
s.send({"id": 1, "do": "ask", "goal": "repeat, fail"})
time.sleep(0.3)
began = time.time()
s.send({"id": 2, "do": "stop"})
head, _ = s.reply()
check("a question is stopped", code(head) == "interrupted" and
      time.time() - began < 1, head)
s.reply()

# ---- explanations and exports are those of the command line ----

for item, options in (("line(1)", []), ("vertex(1, 9)", []),
                      ("line(99)", []), ("hidden(1, 7)", ["--view", "iso"])):
    head, octets = s.ask("explain", item=item, options=options)
    wanted = alone("explain", "facts/two_cubes.pl", item, *options)
    check("explain " + item, (head["status"], octets) ==
          (wanted[0], wanted[1] + wanted[2]), head)
head, _ = s.ask("explain")
check("explain what", code(head) == "request_error.bad_key", head)
head, _ = s.ask("export", argv=["draw", "-o", work + "/a.pdf"])
alone("draw", "facts/two_cubes.pl", "-o", work + "/b.pdf")
check("export", head["files"] == [work + "/a.pdf"] and
      read(work + "/a.pdf") == read(work + "/b.pdf"), head)
head, octets = s.ask("export", argv=["unfold"])
check("unfold", head["status"] == alone("unfold", "facts/two_cubes.pl")[0],
      head)
head, _ = s.ask("export", argv=[])
check("export what", code(head) == "request_error.bad_key", head)

# ---- changes ----

model = work + "/m.pl"
TEXT = """% A cone and a cylinder: 상관.
segment(1, solid, cone(radius(57.15), height( -1 + 96))). % stays
segment(2, solid, named(pipe, at([translate(-60, 0, 30), rotate(y, 90)],
    cylinder(radius(20), /* here */ height(120.0), facets(24))))).
"""
TEXT = TEXT.replace("height( -1 + 96)", "height(95)")
with open(model, "w") as f:
    f.write(TEXT)
head, _ = s.ask("open", file=model)
base = head["rev"]
check("changed: open", len(head["segments"]) >= 2, head)
before = s.ask("view")[1]
head, _ = s.ask("edit", at=base, set={"segment": 2, "path": [2, 2, 1, 1],
                                      "value": 22.5})
check("edit", head["rev"] == base + 1 and head["was"] == 20, head)
_, octets = s.ask("text")
changed = TEXT.replace("radius(20)", "radius(22.5)")
check("one number differs", octets.decode() == changed, octets)
after = s.ask("view")[1]
check("another picture", after != before)
check("that of the text", after == alone("draw", "-", "-o", "-", "--format",
                                         "svg", body=changed.encode())[1])
head, octets = s.ask("export", argv=["check"])
check("export of what was changed",
      octets == alone("check", "-", body=changed.encode())[1], octets)
for keys, wanted in (
        ({"at": base, "set": {"segment": 1, "path": [1, 1], "value": 1}},
         "other_revision"),
        ({"set": {"segment": 9, "path": [1, 1], "value": 1}}, "edit"),
        ({"set": {"segment": 1, "path": [1, 7], "value": 1}}, "edit"),
        ({"set": {"segment": 1, "path": [1], "value": 1}}, "edit"),
        ({"set": {"segment": 1, "path": "a", "value": 1}}, "bad_key"),
        ({"set": {"segment": 1, "path": [1, 1], "value": "x"}}, "bad_key"),
        ({"set": {"param": "d", "value": 1}}, "edit"),
        ({}, "bad_key")):
    head, _ = s.ask("edit", **keys)
    check("refused %s" % keys, code(head) == "request_error." + wanted, head)
head, _ = s.ask("edit", set={"segment": 1, "path": [1, 1], "value": -5})
check("no such cone", code(head).startswith("model_error.") and
      head["error"]["file"] == model and head["error"]["line"] == 2, head)
head, _ = s.ask("text", b"segment(1, solid, \xff).")
check("no text", code(head) == "frame_error.not_utf8", head)
head, _ = s.ask("text", b"segment(1, solid, oops(1)).")
check("no model", code(head).startswith("model_error."), head)
check("nothing has changed", s.ask("text")[1].decode() == changed and
      s.ask("view")[1] == after)
check("not as it is saved", s.ask("tree")[0]["saved"] is False)
head, _ = s.ask("undo")
check("undo", s.ask("view")[1] == before and head["rev"] == base + 2, head)
check("as it is saved", s.ask("tree")[0]["saved"] is True)
head, _ = s.ask("redo")
check("redo", s.ask("view")[1] == after, head)
head, _ = s.ask("redo")
check("no redo", code(head) == "request_error.nothing_to", head)
head, _ = s.ask("text", TEXT.replace("95", "90").encode(), at=head["rev"])
check("another text", "error" not in head, head)
for i in range(2):
    head, _ = s.ask("undo")
check("undone", s.ask("text")[1].decode() == TEXT)
head, _ = s.ask("undo")
check("no undo", code(head) == "request_error.nothing_to", head)
head, _ = s.ask("redo")
head, _ = s.ask("save")
check("saved", head.get("file") == model and read(model).decode() == changed,
      head)
head, _ = s.ask("undo")
check("undo behind save", s.ask("text")[1].decode() == TEXT and
      s.ask("tree")[0]["saved"] is False, head)
with open(model, "a") as f:
    f.write("% another hand\n")
head, _ = s.ask("save")
check("changed outside", code(head) == "request_error.file_changed", head)
head, _ = s.ask("save", file=work + "/other.pl")
check("saved as", read(work + "/other.pl").decode() == TEXT, head)
head, _ = s.ask("save", file=work + "/other.txt")
check("only .pl", code(head) == "request_error.bad_key", head)
alone("convert", "facts/cube.pl", "-o", work + "/cube.stl")
head, _ = s.ask("open", file=work + "/cube.stl")
check("a mesh", "error" not in head, head)
check("its picture", s.ask("view")[1] ==
      alone("draw", work + "/cube.stl", "-o", "-", "--format", "svg")[1])
for do, body in (("undo", b""), ("text", b""), ("text", b"x"), ("save", b"")):
    head, _ = s.ask(do, body)
    check("no text to " + do, code(head) == "request_error.no_text", head)
check("end", s.end() == (0, b""))

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

# ---- many revisions take no more memory than some ----

s = session()
s.ask("open", file="facts/figures/fig13.pl")


def resident():
    with open("/proc/%d/status" % s.process.pid) as f:
        return next(int(l.split()[1]) for l in f if l.startswith("VmRSS"))


said = []
for n in range(1000):
    head, _ = s.ask("edit", set={"segment": 1, "path": [2, 1, 1],
                                 "value": 1 + n % 100 / 100})
    if n % 3 == 0:
        s.ask("view", format="strokes")
    if n >= 400:                  # as many are kept as have room
        said.append(resident())
before, after = sorted(said[:100])[50], sorted(said[-100:])[50]
check("memory is flat", after < before * 1.1, said[::50])
check("end", s.end() == (0, b""))

# ---- what is undone was kept, 50 steps back, but no more than has room ----


def processor():
    with open("/proc/%d/stat" % s.process.pid) as f:
        return sum(map(int, f.read().rsplit(")", 1)[1].split()[11:13]))


def changed(model, segment, path, steps, back):
    """What edits with pictures took of the processor, and undoing some."""
    s.ask("open", file=model)
    times = [processor()]
    for n in range(steps):
        s.ask("edit", set={"segment": segment, "path": path,
                           "value": 0.75 + n / 1000})
        s.ask("view", format="strokes")
    times.append(processor())
    for n in range(back):
        head, _ = s.ask("undo")
        check("undo", "error" not in head, head)
        s.ask("view", format="strokes")
    return times[1] - times[0], processor() - times[1]


s = session()
forth, back = changed("facts/pipe_tee.pl", 2, [1, 1], 50, 50)
check("50 undos of the pipe tee make nothing anew", back < forth / 3,
      (forth, back))
check("end", s.end() == (0, b""))
s = session()
large = work + "/large.pl"
with open(large, "w") as f:
    f.write("segment(1, solid, sphere(radius(1), facets(160))).\n")
changed(large, 1, [1, 1], 60, 0)
check("worlds are kept as far as there is room", resident() < 550000,
      resident())
check("end", s.end() == (0, b""))
checks.finish()
