#!/usr/bin/env python3
"""transcript.py -- runs the commands of a transcript and compares what they say.

    tests/transcript.py [--bless] FILE...

In a FILE of tests/transcripts a line "  $ COMMAND" is run by bash, with lines
"  > ..." that go on with it; the other indented lines are what it said: its
standard output, then its standard error after "! ", then its exit code in
brackets, unless it is 0; how far it was after seconds is left out. What is not indented is for people. Each file has a
folder of its own, with `facts` and `docs` beside it; `sanggwan` is the program.

Numbers with a point are as they stand there but for 1e-9 of them, as sines may
differ from machine to machine; all else is so to the letter. --bless writes
what is said now: read the difference before it is kept. With FIRST=1 in the
environment the first difference of a file ends it.
"""
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SANGGWAN = os.path.realpath(
    os.environ.get("SANGGWAN", os.path.join(ROOT, os.environ.get("B", "build"), "sanggwan")))
SECONDS = 120
PROGRESS = re.compile(r"\S+: \w+: (\d+ ?(s|초)$|[\d,]+ (of|/) [\d,]+, )")
BRACKET = re.compile(r" *([\]}])|([\[{,:]) *")  # Prologs differ in JSON's blanks
PROLOG = re.compile(r"\(SWI-Prolog [\d.]+\)")
NUMBER = re.compile(r"[-+]?\d+\.\d+(?:[eE][-+]?\d+)?")


def parts_of(text):
    """Of a transcript: [lines], or [lines of a command, lines it said]."""
    parts = [[[]]]
    for line in text.split("\n"):
        part = parts[-1]
        if line.startswith("  $ "):
            parts.append([[line], []])
        elif len(part) == 1:
            part[0].append(line)
        elif line.startswith("  > ") and not part[1]:
            part[0].append(line)
        elif line.startswith("  ") or not line:
            part[1].append(line)
        else:
            parts.append([[line]])
    for part, behind in zip(parts, parts[1:] + [[[]]]):
        while len(part) == 2 and part[1] and not part[1][-1]:
            part[1].pop()          # empty lines before what is for people
            behind[0].insert(0, "")
    return parts


def lines_of(text):
    return text.removesuffix("\n").split("\n") if text else []


def said_by(command, folder, environment):
    try:
        done = subprocess.run(["bash", "-c", command], cwd=folder,
                              env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return ["  [more than %d s]" % SECONDS]
    out, errors = (bytes.decode("utf-8", "backslashreplace")
                   for bytes in (done.stdout, done.stderr))
    lines = ["  " + line for line in lines_of(out)]
    lines += ["  ! " + line for line in lines_of(errors)
              if not PROGRESS.match(line)]
    if done.returncode:
        lines.append("  [%d]" % done.returncode)
    lines = [PROLOG.sub("(SWI-Prolog)", line.replace(folder, "FOLDER")).rstrip()
             for line in lines]
    while lines and not lines[-1]:
        lines.pop()
    return lines


def same(line, other):
    line, other = (BRACKET.sub(r"\1\2", text) for text in (line, other))
    if line == other:
        return True
    if NUMBER.split(line) != NUMBER.split(other):
        return False
    pairs = zip(NUMBER.findall(line), NUMBER.findall(other))
    return all(abs(float(a) - float(b)) <=
               1e-9 * max(abs(float(a)), abs(float(b))) + 1e-12
               for a, b in pairs)


def difference(wanted, said):
    for i in range(max(len(wanted), len(said))):
        a = wanted[i] if i < len(wanted) else None
        b = said[i] if i < len(said) else None
        if a is None or b is None or not same(a, b):
            return a, b
    return None


def run(file, bless):
    environment = dict(os.environ, LC_ALL="C", LANG="C", TZ="UTC", PAGER="cat",
                       PATH=os.path.dirname(SANGGWAN) + ":" + os.environ["PATH"])
    for name in ("LC_MESSAGES", "LANGUAGE"):
        environment.pop(name, None)
    with open(file, encoding="utf-8") as text:
        parts = parts_of(text.read())
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        for name in ("facts", "docs", "tests"):
            os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
        for part in parts:
            if len(part) == 1:
                continue
            command = "\n".join(line[4:] for line in part[0] if line)
            said = said_by(command, folder, environment)
            differ = difference(part[1], said)
            if bless:
                part[1] = said
            elif differ:
                failed += 1
                print("%s: $ %s\n  was: %s\n  is:  %s" % ((file, command) + differ))
                if os.environ.get("FIRST"):
                    break
            passed += bless or not differ
    if bless:
        with open(file, "w", encoding="utf-8") as text:
            text.write("\n".join(line for part in parts
                                 for lines in part for line in lines))
    return passed, failed


def main():
    arguments = sys.argv[1:]
    bless = "--bless" in arguments
    counts = [run(file, bless) for file in arguments if file != "--bless"]
    passed, failed = map(sum, zip(*counts))
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
