#!/usr/bin/env python3
"""snapshot.py -- runs many commands and compares all that they make with digests.

    tests/snapshot.py [--bless] [--keep FOLDER] FILE...

A line of a FILE in tests/snapshots is DIGEST STATUS ARGUMENTS: what `sanggwan`
ends with when it has the ARGUMENTS, and a digest of its standard output, its
standard error and the files it makes, all of them. ARGUMENTS that begin with
"session MODEL" are requests, and the digest is of the replies. Lines of # are for
people. Each command has a folder of its own with the models of models.txt
("== NAME", then its text), `facts` and `docs` in it. The commands were drawn at
random (snapshot_draw.py): they take each option, in company of others. One
session does all of a file, so that none has to start a process.

In texts, numbers are rounded to 8 digits, as sines may differ from machine to
machine; of a PNG the dots count, not how they are compressed. The digest of a
command that differs says no more than that: --keep writes what it made into a
FOLDER, so do it with the program as it was, and compare the two. --bless writes
the digests of now; do it when the difference is wanted.
"""
import hashlib
import json
import os
import re
import shlex
import shutil
import sys
import tempfile
import threading
import zlib

sys.path.insert(1, os.path.join(os.path.dirname(os.path.abspath(__file__)), "cli"))
from session import Session
from transcript import BRACKET, PROGRESS, PROLOG, ROOT, SANGGWAN

SECONDS = 120                  # a request that takes longer ends the session
DIFFERS = ("seconds", "cpu", "rss_kb", "pid", "ms", "version")
TIME = re.compile(r"[\d.]+ (microseconds|마이크로초)")
NUMBER = re.compile(rb"[-+]?\d+\.\d+(?:[eE][-+]?\d+)?")


def rounded(match):
    value = float(match.group())
    return b"%.8g" % (0.0 if abs(value) < 1e-9 else value)


def dots(png):
    """What a PNG shows: its chunks, those of the picture expanded."""
    at, other, packed = 8, [], b""
    while at < len(png):
        length = int.from_bytes(png[at:at + 4], "big")
        kind, data = png[at + 4:at + 8], png[at + 8:at + 8 + length]
        if kind == b"IDAT":
            packed += data
        else:
            other.append(kind + data)
        at += 12 + length
    return b"".join(other) + zlib.decompress(packed)


def plain(data):
    """What is compared of a file."""
    if data.startswith(b"\x89PNG"):
        return dots(data)
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        return data
    if text.startswith(("{", "[")):
        data = BRACKET.sub(r"\1\2", text).encode()
    return NUMBER.sub(rounded, data)


def files_of(folder):
    for where, inner, names in os.walk(folder):
        inner.sort()
        for name in sorted(names):
            path = os.path.join(where, name)
            with open(path, "rb") as file:
                yield os.path.relpath(path, folder), file.read()


def said(text, folder):
    """Standard error, without times and what depends on the machine."""
    lines = text.decode("utf-8", "backslashreplace").replace(folder, "FOLDER")
    lines = TIME.sub(r"T \1", lines)
    return PROLOG.sub("(SWI-Prolog)", "\n".join(
        line for line in lines.split("\n") if not PROGRESS.match(line))).encode()


class Program:
    """One session (docs/protocol.md), which does the commands of a file."""

    def __init__(self, folder, models):
        self.folder, self.session = os.path.realpath(folder), None
        self.here = dict(os.environ, LC_ALL="C", LANG="C", TZ="UTC")
        for name in ("LC_MESSAGES", "LANGUAGE"):
            self.here.pop(name, None)
        for name in ("facts", "docs"):
            os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
        for name, text in models.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)

    def asked(self, do, body=b"", **keys):
        self.session = self.session or Session(SANGGWAN, self.folder, self.here)
        watch = threading.Timer(SECONDS, self.session.process.kill)
        watch.start()
        head, octets = self.session.ask(do, body, **keys)
        watch.cancel()
        if head is None or head.get("last"):
            self.end()
        self.cpu = head.get("cpu", 0) if head else SECONDS
        for key in DIFFERS:
            head and head.pop(key, None)
        return head, octets

    def end(self):
        if self.session:
            self.session.process.kill()
            self.session.process.communicate()
        self.session = None

    def verb(self, *arguments):
        """[(what, octets)], beginning with the status, of a verb."""
        head, octets = self.asked("run", argv=arguments)
        if head is None:
            return [("status", b"died")]
        n = head["stdout"]
        return [("status", b"%d" % head["status"]), ("stdout", octets[:n]),
                ("stderr", said(octets[n:], self.folder))]

    def requests(self, model, requests):
        """The same of requests about a model."""
        parts = [("status", b"answered")]
        for keys in [{"do": "open", "file": model}, *json.loads(requests)]:
            head, octets = self.asked(keys.pop("do"), keys.pop("body", "").encode(),
                                      **keys)
            if head is None:
                return [("status", b"died")]
            head.pop("id")
            parts.append(("head", said(json.dumps(head).encode(), self.folder)))
            parts.append(("body", octets))
        return parts

    def made(self, arguments, keep=None):
        """The status of a command, and the digest of what it makes."""
        out = os.path.join(self.folder, "out")
        shutil.rmtree(out, ignore_errors=True)
        os.mkdir(out)
        words = shlex.split(arguments)
        parts = (self.requests(*words[1:]) if words[0] == "session"
                 else self.verb(*words))
        digest = hashlib.sha256()
        for i, (name, data) in enumerate([*parts, *files_of(out)]):
            seen = plain(data)
            digest.update(b"%s %d\n" % (name.encode(), len(seen)) + seen)
            if keep:
                place = os.path.join(keep, "%d-%s" % (i, name))
                os.makedirs(os.path.dirname(place), exist_ok=True)
                with open(place, "wb") as file:
                    file.write(data)
        return parts[0][1].decode(), digest.hexdigest()[:8]


def models_of(file):
    """Of models.txt beside it: name -> text."""
    models, text = {}, None
    with open(os.path.join(os.path.dirname(file), "models.txt"),
              encoding="utf-8") as lines:
        for line in lines:
            if line.startswith("== "):
                text = models.setdefault(line[3:].strip(), [])
            elif text is not None:
                text.append(line)
    return {name: "".join(lines) for name, lines in models.items()}


def run(file, bless, keep):
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder, models_of(file))
        try:
            return compared(program, file, bless, keep)
        finally:
            program.end()


def compared(program, file, bless, keep):
    with open(file, encoding="utf-8") as text:
        lines = text.read().splitlines()
    name = os.path.basename(file).removesuffix(".txt")
    passed = failed = 0
    for i, line in enumerate(lines):
        if not line or line.startswith("#"):
            continue
        digest, status, arguments = line.split(" ", 2)
        now_status, now_digest = program.made(
            arguments, keep and os.path.join(keep, "%s-%d" % (name, i + 1)))
        if bless:
            lines[i] = "%s %s %s" % (now_digest, now_status, arguments)
        elif (digest, status) != (now_digest, now_status):
            failed += 1
            print("%s:%d: makes something else: sanggwan %s\n"
                  "  was: %s, status %s\n  is:  %s, status %s" % (
                      file, i + 1, arguments, digest, status, now_digest,
                      now_status))
            if os.environ.get("FIRST"):
                break
            continue
        passed += 1
    if bless:
        with open(file, "w", encoding="utf-8") as text:
            text.write("\n".join(lines) + "\n")
    return passed, failed


def main():
    arguments = sys.argv[1:]
    keep = None
    if "--keep" in arguments:
        at = arguments.index("--keep")
        keep = arguments[at + 1]
        del arguments[at:at + 2]
    bless = "--bless" in arguments
    files = [file for file in arguments
             if file != "--bless" and not file.endswith("models.txt")]
    counts = [run(file, bless, keep) for file in files]
    print("%d passed, %d failed" % tuple(map(sum, zip(*counts))))
    return 1 if any(failed for _, failed in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
