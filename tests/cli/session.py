"""A session for tests: Session(program).ask({...}, body) -> (head, body)."""
import json
import os
import struct
import subprocess


class Session:
    def __init__(self, program, cwd=None, env=None, arguments=()):
        self.process = subprocess.Popen(
            [program, "serve", "--stdio", *arguments], cwd=cwd, env=env,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE)
        self.number = 0

    def octets(self, octets):
        self.process.stdin.write(octets)
        self.process.stdin.flush()

    def send(self, head, body=b""):
        if isinstance(head, dict):
            head = json.dumps(head).encode()
        self.octets(struct.pack(">II", 4 + len(head) + len(body), len(head))
                    + head + body)

    def reply(self):
        """(head, body); (None, None) at the end."""
        sizes = self.process.stdout.read(8)
        if not sizes:
            return None, None
        n, h = struct.unpack(">II", sizes)
        octets = self.process.stdout.read(n - 4)
        return json.loads(octets[:h]), octets[h:]

    def ask(self, do, body=b"", **keys):
        self.number += 1
        self.send(dict(keys, id=self.number, do=do), body)
        while True:
            head, octets = self.reply()
            if head is None or "progress" not in head:
                return head, octets

    def laid(self, do, **keys):
        """head, {pattern: {edge: its other half}}, what is behind them in the
        body; of unfold and fold."""
        head, octets = self.ask(do, **keys)
        halves, at = {}, 0
        for one in head["patterns"]:
            n = one["halves"]
            pairs = struct.iter_unpack("<2i", octets[at:at + 8 * n])
            halves[one["pattern"]] = dict(pairs)
            at += 8 * n
        return head, halves, octets[at:]

    def run(self, *argv, body=b"", **keys):
        """status, standard output, standard error, head"""
        head, octets = self.ask("run", body, argv=list(argv), **keys)
        n = head["stdout"]
        return head["status"], octets[:n], octets[n:], head

    def end(self):
        """What is left on standard error, and the exit status."""
        self.process.stdin.close()
        rest = self.process.stdout.read()
        error = self.process.stderr.read()
        status = self.process.wait()
        self.process.stdout.close()
        self.process.stderr.close()
        assert rest == b"", rest
        return status, error

    def kill(self):
        self.process.kill()
        self.process.wait()
        for stream in (self.process.stdin, self.process.stdout,
                       self.process.stderr):
            try:
                stream.close()
            except OSError:
                pass


class Checks:
    """Counts tests, and prints those that fail."""

    def __init__(self):
        self.passed = self.failed = 0

    def check(self, name, good, shown=None):
        if good:
            self.passed += 1
        else:
            self.failed += 1
            print("FAILED:", name, "" if shown is None else repr(shown)[:600])

    def finish(self):
        print("%d passed, %d failed" % (self.passed, self.failed), flush=True)
        os._exit(1 if self.failed else 0)
