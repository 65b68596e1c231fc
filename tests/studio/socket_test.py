"""socket_test.py PROGRAM FOLDER: the studio at a Unix socket, behind a proxy."""
# covers: front_socket
import os
import signal
import socket
import stat
import subprocess
import sys

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)),
                os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../cli")]
from front import Front, Refused  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
checks = Checks()
check = checks.check
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
models = os.path.join(folder, "models")
os.makedirs(models)
with open(os.path.join(models, "cube.pl"), "w") as out:
    out.write("segment(1, solid, box(size(1, 1, 1))).\n")
path = os.path.join(folder, "socket")
BEHIND = ("--behind", "https://h.example/sanggwan")


def started(*more):
    return Front(program, models, "cube.pl", BEHIND + more, env, path=path)


def refused(*arguments):
    """status, standard error"""
    done = subprocess.run(
        [program, "serve", "cube.pl", "--no-open", *arguments], cwd=models,
        env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
        timeout=20)
    return done.returncode, done.stdout, done.stderr


front = started()
check("the address of the proxy is printed", front.address.startswith(
    "https://h.example/sanggwan/#"), front.address)
mode = os.stat(path).st_mode
check("a socket of user and group", stat.S_ISSOCK(mode) and
      stat.S_IMODE(mode) == 0o660, oct(mode))
for host, status in (("h.example", 200), ("H.EXAMPLE:443", 200),
                     ("localhost", 400), ("127.0.0.1", 400), (path, 400),
                     ("none", 400), ("evil.example", 400)):
    check("host " + host, front.get("/", headers={"Host": host})[0] == status)
for origin in ("http://localhost", "http://h.example", "null", None):
    try:
        front.socket(Host="h.example", Origin=origin)
        check("origin %s" % origin, False)
    except Refused as error:
        check("origin %s" % origin, error.args[0] == 403, error.args)
page = front.socket(Host="h.example", Origin="https://h.example")
page.say({"id": 0, "do": "hello", "token": front.token})
check("not the owner", page.hear()[0]["owner"] is False)
check("it is opened", "error" not in page.ask("open", file="cube.pl")[0])
head, _ = page.ask("view", port="p1", format="strokes")
check("it is drawn", head.get("strokes", 0) > 0,
      head)
page.ask("edit", set={"segment": 1, "path": [1, 1], "value": 2})
status, out, error = refused(*BEHIND, "--socket", path)
check("taken", status == 2 and out == b"" and b"another program listens at"
      in error, error)
check("it goes on", front.get("/", headers={"Host": "h.example"})[0] == 200)
page.close()
front.process.kill()
front.process.communicate()
check("killed, its socket is left", os.path.exists(path))
front = started("--class")
front.process.stdout.readline()
page = front.socket(Host="h.example", Origin="https://h.example")
page.say({"id": 0, "do": "hello", "token": front.token})
page.hear()
page.ask("open", file="cube.pl")
check("what was done is kept", b"size(2, 1, 1)" in page.ask("text")[1])
page.close()
status, _, error = front.end(signal.SIGTERM)
check("ended, it is gone", not os.path.lexists(path), (status, error))
check("said where", path.encode() in error, error)

# As systemd does it: the socket is open already, and is passed.
PASSED = """
import os, socket, sys
listening = [socket.socket(socket.AF_UNIX) for _ in range(int(sys.argv[1]))]
for i, one in enumerate(listening):
    if sys.argv[2] != "none":
        one.bind(sys.argv[2] + ("" if i == 0 else str(i)))
        one.listen(8)
held = [os.dup(one.fileno()) for one in listening]
held = [os.dup2(fd, 60 + i) for i, fd in enumerate(held)]
for i, fd in enumerate(held):
    os.dup2(fd, 3 + i)
os.closerange(3 + len(held), 80)
pid = os.getpid() + int(sys.argv[3])
os.environ.update(LISTEN_PID=str(pid), LISTEN_FDS=sys.argv[1])
os.execv(sys.argv[4], sys.argv[4:])
"""


def passed(count, at, more, *arguments):
    return [sys.executable, "-c", PASSED, str(count), at, str(more), program,
            "serve", "cube.pl", "--no-open", *arguments]


given = os.path.join(folder, "given")
running = subprocess.Popen(
    passed(1, given, 0, *BEHIND, "--socket", given), cwd=models, env=env,
    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
front = Front.__new__(Front)
front.process, front.path, front.host, front.port = (
    running, given, "h.example", 80)
front.token = running.stdout.readline().decode().strip().split("/#")[1]
check("a socket that was passed", front.get("/", headers={
    "Host": "h.example"})[0] == 200)
page = front.socket(Host="h.example", Origin="https://h.example")
page.say({"id": 0, "do": "hello", "token": front.token})
page.hear()
page.ask("open", file="cube.pl")
check("a session at it", page.ask("view", format="strokes")[0]["strokes"] > 0)
inherited = [os.readlink("/proc/%d/fd/%s" % (session, fd))
             for session in front.sessions()
             for fd in os.listdir("/proc/%d/fd" % session)]
check("sessions have no socket", inherited != [] and not any(
    name.startswith("socket:") for name in inherited), inherited)
check("nor hear of one", all(
    b"LISTEN_" not in open("/proc/%d/environ" % session, "rb").read()
    for session in front.sessions()))
page.close()
status, _, error = front.end(signal.SIGTERM)
check("ended, it stays", stat.S_ISSOCK(os.stat(given).st_mode), error)
os.unlink(given)
for name, arguments, said in (
        ("another path", passed(1, given, 0, *BEHIND, "--socket", path),
         b"listens at " + given.encode()),
        ("no --socket", passed(1, given, 0), b"Say --socket"),
        ("two", passed(2, given, 0, *BEHIND, "--socket", given), b"LISTEN_FDS"),
        ("that does not listen", passed(1, "none", 0, *BEHIND, "--socket",
                                        given), b"LISTEN_FDS")):
    done = subprocess.run(arguments, cwd=models, env=env, timeout=20,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, check=False)
    check("passed: " + name, done.returncode == 2 and done.stdout == b"" and
          said in done.stderr, (done.returncode, done.stderr))
    for at in (given, given + "1"):
        if os.path.lexists(at):
            os.unlink(at)
running = subprocess.Popen(
    passed(1, given, 1, *BEHIND, "--socket", given + "2"), cwd=models, env=env,
    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
running.stdout.readline()
check("for another process", stat.S_ISSOCK(os.stat(given + "2").st_mode))
running.send_signal(signal.SIGTERM)
running.communicate(timeout=20)

own = os.path.join(folder, "own")
with open(own, "w") as out:
    out.write("mine")
for name, arguments, said in (
        ("a file", [*BEHIND, "--socket", own], b"no socket can be made"),
        ("no folder", [*BEHIND, "--socket", folder + "/no/socket"],
         b"no socket can be made"),
        ("a folder", [*BEHIND, "--socket", folder], b"no socket can be made"),
        ("too long", [*BEHIND, "--socket", "x" * 200],
         b"no socket can be made"),
        ("no proxy", ["--socket", path], b"Add --behind"),
        ("a port", [*BEHIND, "--socket", path, "--port", "7000"],
         b"leave --port"),
        ("an address", [*BEHIND, "--socket", path, "--host", "0.0.0.0"],
         b"leave --port")):
    status, out, error = refused(*arguments)
    check("refused: " + name, status == 2 and out == b"" and said in error,
          (status, error))
with open(own) as file:
    check("a file is left alone", file.read() == "mine")
check("a folder is left alone", os.path.isdir(folder))
check("no socket is left", not os.path.lexists(path))
client = socket.socket(socket.AF_UNIX)
try:
    client.connect(path)
    check("nobody listens", False)
except OSError:
    check("nobody listens", True)
checks.finish()
