"""serve_long.py PROGRAM FOLDER: a document that is changed a thousand times, and what
it keeps to undo that."""
from serving import check, checks, resident, session, work

# ---- many revisions take no more memory than some ----

s = session()
s.ask("open", file="facts/figures/fig13.pl")
said = []
for n in range(1000):
    head, _ = s.ask("edit", set={"segment": 1, "path": [2, 1, 1],
                                 "value": 1 + n % 100 / 100})
    if n % 3 == 0:
        s.ask("view", format="strokes")
    if n >= 400:                  # as many are kept as have room
        said.append(resident(s))
before, after = sorted(said[:100])[50], sorted(said[-100:])[50]
check("memory is flat", after < before * 1.1, said[::50])
check("end", s.end() == (0, b""))

# ---- what is undone was kept, 50 steps back, but no more than has room ----


def processor():
    with open("/proc/%d/stat" % s.process.pid) as f:
        return sum(map(int, f.read().rsplit(")", 1)[1].split()[11:13]))


def changed(model, segment, path, steps, back):
    """What edits with pictures took of the processor, and undoing some."""
    s.ask("open", file=model)
    times = [processor()]
    for n in range(steps):
        s.ask("edit", set={"segment": segment, "path": path,
                           "value": 0.75 + n / 1000})
        s.ask("view", format="strokes")
    times.append(processor())
    for n in range(back):
        head, _ = s.ask("undo")
        check("undo", "error" not in head, head)
        s.ask("view", format="strokes")
    return times[1] - times[0], processor() - times[1]


s = session()
forth, back = changed("facts/pipe_tee.pl", 2, [1, 1], 50, 50)
check("50 undos of the pipe tee make nothing anew", back < forth / 3,
      (forth, back))
check("end", s.end() == (0, b""))
s = session()
large = work + "/large.pl"
with open(large, "w") as f:
    f.write("segment(1, solid, sphere(radius(1), facets(160))).\n")
changed(large, 1, [1, 1], 60, 0)
check("worlds are kept as far as there is room", resident(s) < 550000,
      resident(s))
check("end", s.end() == (0, b""))
checks.finish()
