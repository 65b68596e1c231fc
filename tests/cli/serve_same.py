"""serve_same.py PROGRAM FOLDER SECONDS SEED: verbs in random order in one
session print and write the same octets as each in a process of its own."""
import os
import random
import re
import subprocess
import sys
import time

from session import Checks, Session

program, work = sys.argv[1:3]
seconds, seed = float(sys.argv[3]), int(sys.argv[4])
checks = Checks()
environment = {k: v for k, v in os.environ.items()
               if k not in ("LC_ALL", "LC_MESSAGES")}
environment["LANG"] = "C"
PROGRESS = re.compile(rb"(?m)^sanggwan: \w+: \d+ s\n")
BAD = work + "/bad.pl"
with open(BAD, "w") as f:
    f.write("segment(1, solid, cone(radius(-1), height(1))).\n")
NESTED = work + "/nested.pl"
with open(NESTED, "w") as f:
    f.write("segment(1, solid, %s).\n" % ("f(" * 150 + "a" + ")" * 150))

PIPE = work + "/pipe.pl"
with open(PIPE, "w") as f:
    f.write("param(d, 2).\n"
            "segment(1, solid, cylinder(radius(param(d)/2), height(5))).\n")

COMMANDS = """
check facts/cube.pl
check --json facts/pipe_tee.pl
check --lang ko facts/two_cubes.pl facts/cube.pl
check no_such_file.pl
check facts/cube.pl --set d=1
draw PIPE --set d=3 -o OUT.svg
draw PIPE -o OUT.svg
check BAD
check NESTED
check NESTED --limits depth=300
check facts/cube.pl --limits depth=1
draw facts/figures/fig13.pl -o OUT.svg
draw facts/figures/fig13.pl -o OUT.pdf --view 30,60 --hidden removed
draw facts/figures/fig12.pl --view front -o - --format dxf
draw facts/two_cubes.pl --sheet A4 --views front,top -o OUT.svg -q
draw facts/two_cubes.pl -o OUT.svg --rules docs/glass_rules.pl
draw facts/two_cubes.pl -o OUT.json --rules docs/back_rules.pl --lang ko
draw facts/two_cubes.pl -o OUT.json
draw facts/two_cubes.pl -o OUT.svg --rules BAD
draw facts/two_cubes.pl -o OUT.xyz
draw facts/two_cubes.pl -o /no/such/folder/x.svg
draw facts/smooth.pl -o OUT.png --size 200x150
penetrate facts/two_cubes.pl --json
penetrate facts/two_cubes.pl --format csv --exact
penetrate facts/figures/fig13.pl -o OUT.csv -o OUT.svg
convert facts/cube.pl -o OUT.stl -o OUT.off
convert facts/pipe_tee.pl -o - --format obj
union facts/cube.pl facts/pipe_tee.pl -o OUT.off
difference facts/cube.pl facts/two_cubes.pl
eval facts/pipe_tee.pl -o OUT.ply
eval facts/pipe_tee.pl -o OUT.stl --strict
unfold facts/cube.pl -o OUT.svg
unfold facts/patterns/fig09.pl -o OUT.pdf --json
unfold facts/pipe_tee.pl
query facts/cube.pl v(1,V,X,Y,Z)
query --json facts/cube.pl segment(Some,Kind,Name)
query --json facts/two_cubes.pl penetrate,line(Line,S1,P1,A,B,S2,P2,C,D)
query facts/cube.pl assertz(here(1)),here(X)
query facts/cube.pl here(X)
query facts/cube.pl set_prolog_flag(double_quotes,atom)
query facts/cube.pl X="text",string(X)
query facts/cube.pl set_limit(depth,5)
query facts/cube.pl limit_value(depth,X)
query facts/cube.pl op(200,xfy,**>),X=(a**>b)
query facts/cube.pl X=(a**>b)
query facts/cube.pl print_message(warning,format(once,[]))
query --lang ko facts/cube.pl nothing_like(it)
query facts/cube.pl throw(ball)
query --strict facts/cube.pl print_message(warning,format(once,[]))
query facts/two_cubes.pl use_rules('docs/glass_rules.pl'),rule_file(F),file_base_name(F,B),F=B
query facts/two_cubes.pl rule_file(F)
query facts/cube.pl use_module(library(clpfd)),X=1
query facts/cube.pl gensym(a,X)
query facts/cube.pl dcg_translate_rule((a-->b),X)
query facts/cube.pl current_op(P,xfx,#=)
explain facts/two_cubes.pl line(1)
explain --json facts/two_cubes.pl vertex(1,9)
explain --lang ko facts/two_cubes.pl hidden(1,7) --view iso
explain facts/two_cubes.pl line(99)
split facts/cube.pl --plane 0,0,1,-0.5 -o OUT.obj
--version
--help
draw --help
dram x
draw
--lang ko --help
""".strip().split("\n")


def words(line, out):
    line = line.replace("OUT", out)
    return [word.replace("BAD", BAD).replace("NESTED", NESTED)
            .replace("PIPE", PIPE)
            for word in line.split(" ")]


def written(folder):
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), "rb") as f:
            found[name] = f.read()
        os.unlink(os.path.join(folder, name))
    return found


out = work + "/out"
os.mkdir(out)
alone = {}


def wanted(line):
    if line not in alone:
        done = subprocess.run([program, *words(line, out + "/x")],
                              capture_output=True, env=environment)
        alone[line] = (done.returncode, done.stdout,
                       PROGRESS.sub(b"", done.stderr), written(out))
    return alone[line]


draw = random.Random(seed)
end = time.time() + seconds
runs = ended = 0
session = Session(program, env=environment)
order = []
lines = draw.sample(COMMANDS, len(COMMANDS))
while time.time() < end or lines:
    line = lines.pop() if lines else draw.choice(COMMANDS)
    expected = wanted(line)
    status, printed, error, head = session.run(*words(line, out + "/x"))
    got = (status, printed, PROGRESS.sub(b"", error), written(out))
    runs += 1
    order.append(line)
    checks.check("%s, behind %s" % (line, order[-6:-1]), got == expected,
                 [(a, b) for a, b in zip(got, expected) if a != b])
    if head.get("last"):
        session.process.wait()
        session.kill()
        session = Session(program, env=environment)
        order = []
        ended += 1
status, error = session.end()
checks.check("its end", status == 0 and error == b"", (status, error))
print("%d runs, seed %d, %d sessions replaced" % (runs, seed, ended))
checks.finish()
