"""What the scripts that ask a session share: serving.py PROGRAM FOLDER."""
import os
import subprocess
import sys

from session import Checks, Session

program, work = sys.argv[1:3]
checks = Checks()
check = checks.check
environment = {k: v for k, v in os.environ.items()
               if k not in ("LC_ALL", "LC_MESSAGES")}
environment.update(LANG="C", XDG_STATE_HOME=work + "/state")
model = work + "/m.pl"
TEXT = """% A cone and a cylinder: 상관.
segment(1, solid, cone(radius(57.15), height(95))). % stays
segment(2, solid, named(pipe, at([translate(-60, 0, 30), rotate(y, 90)],
    cylinder(radius(20), /* here */ height(120.0), facets(24))))).
"""


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


def resident(of):
    """The memory of a session, in kB."""
    with open("/proc/%d/status" % of.process.pid) as f:
        return next(int(l.split()[1]) for l in f if l.startswith("VmRSS"))
