"""frames.py: one session is asked what stands on standard input, a request a
line: a head, or octets as a text of Python, b'...', which need be no frame. A
head may be followed by a tab and its body. Replies are printed without what
differs each time, messages as people read them, in both languages."""
import ast
import json
import struct
import subprocess
import sys

DIFFERS = ("seconds", "cpu", "rss_kb", "pid", "ms", "version")


def octets_of(line):
    if line.startswith("b"):
        parts = [part.partition(" * ") for part in line.split(" + ")]
        return b"".join(ast.literal_eval(octets) * int(times or "1", 0)
                        for octets, _, times in parts)
    head, _, body = line.partition("\t")
    head, body = head.encode(), body.replace("\\n", "\n").encode()
    return struct.pack(">II", 4 + len(head) + len(body), len(head)) + head + body


def print_message(message):
    place = [str(message[key]) for key in ("file", "line", "column")
             if message[key] is not None]
    print("  %s %s %s" % (message["kind"], message["code"], ":".join(place)))
    for language in ("en", "ko"):
        for line in message["words"][language].split("\n"):
            print("    " + line)


def print_reply(head, body):
    messages = head.pop("messages", [])
    error = head.pop("error", None)
    for key in DIFFERS:
        head.pop(key, None)
    print(json.dumps(head, ensure_ascii=False))
    for message in messages + [error] * (error not in messages and
                                         error is not None):
        print_message(message)
    if body:
        print("  %d octets" % len(body))
        for line in body.decode("utf-8", "backslashreplace").split("\n")[:12]:
            print("  | " + line)


def main():
    requests = b"".join(octets_of(line) for line in sys.stdin.read().split("\n")
                        if line)
    done = subprocess.run(["sanggwan", "serve", "--stdio", *sys.argv[1:]],
                          input=requests, stdout=subprocess.PIPE)
    rest = done.stdout
    while rest:
        n, h = struct.unpack(">II", rest[:8])
        print_reply(json.loads(rest[8:8 + h]), rest[8 + h:4 + n])
        rest = rest[4 + n:]
    return done.returncode


sys.exit(main())
