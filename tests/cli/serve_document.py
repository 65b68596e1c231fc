"""serve_document.py PROGRAM FOLDER: the document of a session: pictures and
explanations are those of the command line, questions have limits, and changes go
into the text."""
# covers: document_content, question_part
import os
import time

from serving import (TEXT, alone, check, checks, code, model, read, session,
                     work)

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
checks.finish()
