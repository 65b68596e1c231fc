"""serve.py PROGRAM FOLDER: verbs as jobs of a session do what the command line
does, and a session survives all that is sent to it."""
# covers: job, message_object, process_state, stop
import os
import random
import signal
import struct
import subprocess
import sys
import time

from session import Checks, Session

program, work = sys.argv[1:3]
checks = Checks()
check = checks.check
environment = {k: v for k, v in os.environ.items()
               if k not in ("LC_ALL", "LC_MESSAGES")}
environment["LANG"] = "C"


def alone(argv, body=b"", **more):
    p = subprocess.run([program, *argv], input=body, capture_output=True,
                       env=dict(environment, **more))
    return p.returncode, p.stdout, p.stderr


def session():
    return Session(program, env=environment)


# ---- what a request may be ----

s = session()
head, _ = s.ask("hello")
check("hello", head["protocol"] == 1 and "run" in head["offered"], head)
check("pid", head["pid"] == s.process.pid, head)
head, _ = s.ask("runn")
check("unknown", head["error"]["code"] == "request_error.unknown_do", head)
check("what is meant", "run" in head["error"]["words"]["en"], head)
check("no status", "status" not in head, head)
head, _ = s.ask("run")
check("no argv", head["error"]["code"] == "request_error.bad_key", head)
head, _ = s.ask("run", argv=["check", 1])
check("argv of numbers", head["error"]["code"] == "request_error.bad_key",
      head)
head, _ = s.ask("run", argv=["check", "a\0b"])
check("argv with 0", head["error"]["code"] == "request_error.bad_key", head)
head, _ = s.ask("run", argv=["check"], cwd="/nowhere/at/all")
check("no folder", head["error"]["code"] == "request_error.no_folder", head)
head, _ = s.ask("run", argv=["check"], memory_mb=-1)
check("memory", head["error"]["code"] == "request_error.bad_key", head)
# Less than the process has is refused; else it could not even reply.
for megabytes in (1, 5, 20, 35):
    head, _ = s.ask("run", argv=["check", "facts/cube.pl"],
                    memory_mb=megabytes)
    check("too little memory", head["error"]["code"]
          == "request_error.bad_key" and "already" in
          head["error"]["words"]["en"], head)
head, _ = s.ask("run", argv=["check"], lang="de")
check("language", head["error"]["code"] == "request_error.bad_key", head)
for verb in ("serve", "repl"):
    status, out, err, head = s.run("--lang", "en", verb, "--stdio")
    check(verb + " refused",
          status == 2 and out == b"", head)
for octets in (struct.pack(">I", 0), struct.pack(">II", 3, 0)[:7],
               struct.pack(">II", 4, 9), struct.pack(">II", 8, 4) + b"{},,"):
    s.octets(octets)
    head, _ = s.reply()
    check("no frame", head["id"] is None and
          head["error"]["code"].startswith("frame_error."), head)
s.octets(struct.pack(">I", 2000000) + b"x" * 2000000)
head, _ = s.reply()
check("too large", head["error"]["code"] == "frame_error.too_large", head)
status, out, err, head = s.run("--version")
check("still there", status == 0 and out.startswith(b"sanggwan"), out)
check("nothing on its own standard error", s.end() == (0, b""))

# A truncated frame, then the end.
s = session()
s.octets(b"\0\0\1\0\0")
s.process.stdin.close()
head, _ = s.reply()
check("truncated", head["error"]["code"] == "frame_error.truncated", head)
check("its exit code", s.process.wait() == 0)

# ---- messages are objects in both languages ----

s = session()
status, out, err, head = s.run("check", "no_such_file.pl")
error = head["error"]
check("error", status == 3 and error["code"] == "model_error.cannot_read"
      and error["file"] == "no_such_file.pl", head)
check("words", "no such file" in error["words"]["en"]
      and "파일" in error["words"]["ko"], head)
with open(work + "/bad.pl", "w") as f:
    f.write("v(1,1,0,0,0).\nv(1,2,zero,0,0).\n")
status, out, err, head = s.run("check", work + "/bad.pl")
check("place", (head["error"]["line"], head["error"]["column"]) == (2, 7),
      head)
check("no place in the words", "bad.pl" not in head["error"]["words"]["en"],
      head)
status, out, err, head = s.run("draw", "facts/cube.pl", "-o",
                               work + "/a.svg", "-o", work + "/b.pdf")
check("files", head["files"] == [work + "/a.svg", work + "/b.pdf"], head)
check("notices", [m["code"] for m in head["messages"]] == ["wrote"] * 2
      and head["error"] is None, head)
status, out, err, head = s.run("check", "facts/cube.pl", lang="ko")
check("Korean", "세그먼트".encode() in out, out)
status, out, err, head = s.run("check", "facts/cube.pl")
check("English again", b"segment 1" in out, out)
status, out, err, head = s.run("check", "cube.pl", cwd="facts")
check("in a folder", status == 0, head)
status, out, err, head = s.run("check", "facts/cube.pl")
check("and back", status == 0, head)
with open("facts/cube.pl", "rb") as f:
    status, out, err, head = s.run("check", "-", body=f.read())
check("standard input", status == 0 and b"segment 1" in out, out)
status, out, err, head = s.run("check", "-")
check("an empty one", status == 3, head)
# What programs write that a goal starts gets into no frame.
status, out, err, head = s.run("query", "facts/cube.pl",
                               "shell('echo stray')")
check("a child's output", status == 0 and out == b"yes\n", out)
status, out, err, head = s.run("query", "facts/cube.pl",
                               "forall(between(1,3000000,_),write(abcdef))")
check("printed too much", status == 4 and head["error"]["code"]
      == "request_error.printed", head)
status, out, err, head = s.run("query", "facts/cube.pl",
                               "numlist(1,60000000,L),length(L,N)",
                               memory_mb=300)
check("memory limit", status == 4 and "memory" in
      head["error"]["words"]["en"], head)
status, out, err, head = s.run("check", "facts/cube.pl")
check("after it", status == 0, head)


def limits(process):
    """The limits of a process on memory and on the processor."""
    with open("/proc/%d/limits" % process.pid, encoding="ascii") as lines:
        return [line.split()[3] for line in lines
                if line.startswith(("Max cpu time", "Max data size"))]


# What was limited for one verb is not limited afterwards.
before = limits(s.process)
for argv in (["check", "facts/cube.pl"], ["check", "nowhere.pl"]):
    s.run(*argv, memory_mb=400, cpu_s=50)
    check("limits are put back", limits(s.process) == before, before)
check("stray on standard error", s.end() == (0, b"stray\n"))

s = session()
s.send({"id": 1, "do": "run", "cpu_s": 1,
        "argv": ["query", "facts/cube.pl", "repeat,fail"]})
began = time.time()
head, _ = s.reply()
status = s.process.wait()
# The reply may still come, and then the process ends by itself or by the signal.
check("processor limit", (head is None or head["status"] == 143) and
      status in (0, 143, 128 + signal.SIGXCPU, -signal.SIGXCPU) and
      time.time() - began < 20, (status, head))
s.kill()

# ---- stop ----

s = session()
for goal in ("repeat,fail", "sleep(30)", "catch((repeat,fail),_,fail)"):
    s.send({"id": 1, "do": "run", "argv": ["query", "facts/cube.pl", goal]})
    s.send({"id": 2, "do": "run", "argv": ["check", "facts/cube.pl"]})
    time.sleep(0.3)
    began = time.time()
    s.send({"id": 3, "do": "stop"})
    first, _ = s.reply()
    took = time.time() - began
    second, _ = s.reply()
    third, _ = s.reply()
    check("stopped " + goal, first["id"] == 1 and
          (first.get("status") in (130, 1) or
           first["error"]["code"] == "interrupted"), first)
    check("soon " + goal, took < 1, took)
    check("what waits", second["id"] == 2 and
          second["error"]["code"] == "interrupted", second)
    check("stop itself", third == {"id": 3, "rev": 0, "do": "stop"}, third)
# A stop that names its request ends that one only: before it begins, while it
# is under way, and not when it is done.
SLOW = {"do": "run", "argv": ["query", "facts/cube.pl", "repeat,fail"]}
QUICK = {"do": "run", "argv": ["query", "facts/cube.pl", "sleep(0.5)"]}
for sent, named, stopped in (
        ([{"id": 1, **QUICK}, {"id": "b", **SLOW}, {"id": 3, **QUICK}], "b",
         ["b"]),
        ([{"id": 1, **SLOW}, {"id": 2, **QUICK}], 1, [1]),
        ([{"id": 1, **QUICK}], 2, []), ([{"id": 1, **QUICK}], "1", []),
        ([QUICK], None, []), ([{"id": 1, **QUICK}], [1], [])):
    for one in sent:
        s.send(one)
    time.sleep(0.2)
    s.send({"id": 9, "do": "stop", "of": named})
    s.send({"id": named, **QUICK} if stopped else {"id": 10, **QUICK})
    replies = [s.reply()[0] for _ in range(len(sent) + 2)]
    told = [one["id"] for one in replies[:len(sent)] if one.get("status") != 0]
    check("stop of %s" % named, told == stopped, replies)
    wrong = replies[-2].get("error", {}).get("code")
    check("of an id", replies[-2]["id"] == 9 and wrong == (
        None if isinstance(named, (int, str)) else "request_error.bad_key"),
        replies)
    check("what came after it", replies[-1]["status"] == 0, replies)
status, out, err, head = s.run("check", "facts/cube.pl")
check("after stops", status == 0, head)
check("end", s.end() == (0, b""))

# ---- the end of the input ----

s = session()
for i in range(5):
    s.send({"id": i, "do": "run", "argv": ["check", "facts/cube.pl"]})
s.process.stdin.close()
ids = [s.reply()[0]["id"] for i in range(5)]
check("what was asked is done", ids == list(range(5)), ids)
check("then it ends", s.process.wait() == 0)
# Nobody asks, nobody reads: what is under way ends too.
s = session()
s.ask("hello")
s.send({"id": 1, "do": "run",
        "argv": ["query", "facts/cube.pl", "repeat,fail"]})
time.sleep(0.2)
began = time.time()
s.process.stdin.close()
s.process.stdout.close()
check("an orphan ends", s.process.wait(timeout=20) is not None)
check("soon", time.time() - began < 5, time.time() - began)

# ---- users' code ----

# What the program keeps of a model is none.
for model in ("facts/cube.pl", "facts/pipe_tee.pl", "facts/figures/fig13.pl",
              "facts/pipes.pl", "facts/family.pl", "facts/smooth.pl"):
    s = session()
    status, out, err, head = s.run("query", model, "segment(_, _, _)")
    check("kept: " + model, status == 0 and "last" not in head, head)
    s.kill()
s = session()
for goal in ("assertz(foo(1)), op(700, xfx, ===>), nb_setval(k, 1), "
             "set_prolog_flag(double_quotes, atom), flag(z, _, 4)",
             "consult(user:[]), asserta((bar(X) :- foo(X)))",
             "working_directory(_, '/')", "set_output(user_error)",
             "open('/dev/null', write, _)", "setenv('LANG', ko)"):
    status, out, err, head = s.run("query", "facts/cube.pl", goal)
    check("put back: " + goal, status == 0 and "last" not in head, head)
for goal in ("foo(X)", "X = (a ===> b)", "nb_getval(k, X)",
             "X = \"a\", string(X)", "flag(z, X, X)", "bar(X)",
             "working_directory(X, X)", "nothing"):
    argv = ["query", "facts/cube.pl", goal]
    here = s.run(*argv)
    check("as alone: " + goal, here[:3] == alone(argv), here)
status, out, err, head = s.run("query", "facts/cube.pl",
                               "thread_create(sleep(100), _)")
check("cannot be put back", head.get("last") is True, head)
check("so it ends", s.process.wait(timeout=20) == 0)
s.kill()

checks.finish()
