"""rules_fuzz.py PROGRAM FOLDER CASES SEED: rule files of the documentation,
changed at random, are tried in a session, and some by the command line: each is
taken, or refused in words of ours with its place, in the time that it is given;
a rule without an end is stopped; who does not own the model cannot try them;
goals can do no more than before; and the session lives on."""
import glob
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys

from session import Checks, Session

program, work = sys.argv[1:3]
cases, seed = int(sys.argv[3]), int(sys.argv[4])
checks = Checks()
draw = random.Random(seed)
environment = dict(os.environ, LANG="C", TMPDIR=work)
RULES = []
for name in sorted(glob.glob("docs/*_rules.pl")):
    with open(name, encoding="utf8") as text:
        RULES.append(text.read())
shutil.copy("facts/two_cubes.pl", work + "/m.pl")
os.chdir(work)
TICKS = os.sysconf("SC_CLK_TCK")
TOKEN = re.compile(r"%[^\n]*\n|\s+|\w+|'(?:[^'\\\n]|\\.)*'|[^\w\s]")
WORDS = sorted({token for text in RULES for token in TOKEN.findall(text)
                if not token.isspace()})
PIECES = (":- dynamic x/1.\n", ":- module(m, []).\n", ":- initialization(x).\n",
          ":- op(700, xfx, ===>).\n", ":- use_module(library(lists)).\n",
          ":- use_module(none).\n", ":- discontiguous f/1.\n", "x --> y.\n",
          "term_expansion(A, [A, A]).\n", ":- if(true).\n", ":- endif.\n",
          ":- set_prolog_flag(double_quotes, codes).\n", "f(X) => X.\n", "0'",
          '"', "'", "/*", "{", "}", "\\", "`", "X = f(X), ", " fail, ", " !, ",
          " throw(x), ", " repeat, ", " A = A, ", "'\\x0\\'", "\u202e", "\0",
          "\x1b[2J", "1e999", "9" * 3000, "(" * 300, "[" * 3000, "- " * 500,
          "n" * 70000, "may_cut(A, B) :- may_cut(A, B).\n", "_", ".\n", ". ",
          "may_cut(_, _) :- between(1, inf, X), X < 0.\n", "상관(1).\n",
          "may_cut(_, _) :- length(L, 100000000), L = [].\n", "end_of_file.\n",
          "edge_role(_, _, _, X, _) :- X = Y.\n", "default(default(x))",
          ":- multifile user:portray/1.\n", "user:portray(_) :- fail.\n")
RAW = re.compile(r"tack limit|I/O error|sg_[a-z_]+:|\$[a-z_]+'|fault of the "
                 r"program|[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]")
STATUSES = (0, 1, 2, 3, 4)
SECONDS = 3


class Stall(Exception):
    pass


def stalled(*_):
    raise Stall


signal.signal(signal.SIGALRM, stalled)


def changed():
    tokens = TOKEN.findall(draw.choice(RULES))
    if draw.random() < 0.2:
        tokens += TOKEN.findall(draw.choice(RULES))
    for _ in range(draw.choice((1, 1, 2, 3, 8))):
        at, other = draw.randrange(len(tokens)), draw.randrange(len(tokens))
        kind = draw.randrange(8)
        if kind == 0 and len(tokens) > 2:
            del tokens[at]
        elif kind == 1:
            tokens.insert(at, tokens[other])
        elif kind == 2:
            tokens[at], tokens[other] = tokens[other], tokens[at]
        elif kind < 5:
            tokens[at] = draw.choice(WORDS)
        elif kind == 5:
            tokens.insert(at, draw.choice(PIECES))
        elif kind == 6 and tokens[at]:
            i = draw.randrange(len(tokens[at]))
            tokens[at] = (tokens[at][:i] + chr(draw.randrange(1, 300))
                          + tokens[at][i + 1:])
        else:
            tokens[at:at] = tokens[other:other + draw.randrange(40)]
    return "".join(tokens[:draw.randrange(len(tokens))]
                   if draw.random() < 0.05 else tokens)


def cpu(session):
    with open("/proc/%d/stat" % session.process.pid) as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def bad(head):
    """What is wrong with a reply."""
    if head is None:
        return "no reply"
    if "rev" not in head or not ("do" in head or head.get("error")):
        return "no good reply %s" % head
    said = head.get("messages", []) + [head.get("error")] * bool(
        head.get("error"))
    plain = " ".join(str(message["words"][language]) for message in said
                     for language in ("en", "ko"))
    if RAW.search(plain):
        return "raw words: %s" % plain[:400]
    if len(plain) > 20000:
        return "long words"
    return None


def tried(session, text):
    """What came of the rules in `text`, and what is wrong."""
    head, _ = session.ask("rules", text.encode())
    if head and head.get("error", {}).get("code") != (
            "request_error.owner_alone"):
        return "", "anybody may try rules: %s" % head
    before = cpu(session)
    head, _ = session.ask("rules", text.encode(), owner=True, cpu_s=SECONDS)
    wrong = bad(head)
    if wrong:
        return "", wrong
    outcome = head["error"]["code"] if "error" in head else "tried"
    for do, keys in (("view", {"format": "strokes"}), ("explain", {
            "item": "line(1)"}), ("ask", {"goal": "line(1,A,B,C,D,E,F,G,H)"})):
        head, _ = session.ask(do, cpu_s=SECONDS, **keys)
        wrong = bad(head)
        if wrong:
            return "", "%s: %s" % (do, wrong)
    for goal in ("shell('touch escaped')", "open('escaped', write, _)",
                 "may_cut(1, 2), shell('touch escaped')"):
        head, _ = session.ask("ask", goal=goal, cpu_s=SECONDS)
        wrong = bad(head)
        if wrong or "error" not in head or os.path.exists("escaped"):
            return "", "goals can do more: %s" % head
    session.ask("rules", keep=False)
    return outcome, ("%.1f s" % (cpu(session) - before)
                     if cpu(session) - before > 8 * SECONDS else None)


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 2))


def drawn(text):
    """The same of the command line; SIGXCPU ends what has no end."""
    with open("r.pl", "w", encoding="utf8") as out:
        out.write(text)
    done = subprocess.run(
        [program, "draw", "-q", "m.pl", "--rules", "r.pl", "-o", "a.svg"],
        env=environment, stdin=subprocess.DEVNULL, capture_output=True,
        check=False, timeout=300, preexec_fn=limited)
    error = done.stderr.decode("utf8", "replace")
    written = os.path.exists("a.svg")
    if written:
        os.remove("a.svg")
    if done.returncode not in STATUSES + (128 + signal.SIGXCPU,):
        return "status %d: %s" % (done.returncode, error[-400:])
    if written != (done.returncode == 0):
        return "a file is %swritten" % ("" if written else "not ")
    if RAW.search(error.replace("\n", " ")):
        return "raw words: %s" % error[:400]
    return None


def begun():
    session = Session(program, cwd=work, env=environment)
    head, _ = session.ask("open", file="m.pl")
    checks.check("a document", head and head.get("do") == "open", head)
    return session


session = begun()
outcomes = {}
for case in range(cases):
    text = changed()
    signal.alarm(300)
    try:
        outcome, wrong = tried(session, text)
        if not wrong and case % 8 == 0:
            wrong = drawn(text)
    except (Stall, subprocess.TimeoutExpired):
        outcome, wrong = "", "no end"
    except OSError as error:
        outcome, wrong = "", "the session has ended: %s" % error
    signal.alarm(0)
    outcomes[outcome] = outcomes.get(outcome, 0) + 1
    if wrong:
        with open("%s/case-%d" % (work, case), "w", encoding="utf8") as kept:
            kept.write(text)
        checks.check("rules %d of seed %d: %s" % (case, seed, wrong), False)
    if not outcome:
        session.kill()
        session = begun()
head, _ = session.ask("hello")
checks.check("it lives on", head and head.get("do") == "hello", head)
session.kill()
checks.check("some are tried", outcomes.get("tried", 0) > 0, outcomes)
print("counted: %d rule files, seed %d, %s" % (
    cases, seed, sorted(outcomes.items())))
checks.finish()
