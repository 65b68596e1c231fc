"""class_test.py PROGRAM FOLDER: a class with problems: thirty pupils, whose
answers are checked and kept, and a teacher who sees them."""
# covers: visitor_answer, ask_problem
import json
import os
import shutil
import signal
import subprocess
import sys
import time

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)),
                os.path.join(os.path.dirname(os.path.abspath(__file__)),
                             "../cli")]
from front import Front  # noqa: E402
from session import Checks  # noqa: E402

program, folder = sys.argv[1:3]
checks = Checks()
check = checks.check
env = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
models = os.path.join(folder, "models")
os.makedirs(models)
for name in ("fig10.pl", "fig12.pl"):
    shutil.copy(os.path.join("facts/problems", name), models)
FILE = os.path.join(models, "set.pl")
with open(FILE, "w") as out:
    out.write("""
problem(fig10, 'fig10.pl',
        [ given([front, top, right]), ask(draw(penetration)),
          ask(count(loops)), ask(measure(edge(1, 1, 5), mm, 0.1)) ]).
variant(fig10, a in [36, 40, 44], seed(7)).
problem(fig12, 'fig12.pl',
        [ given([front, top]), ask(draw(penetration)), ask(count(loops)) ]).
sheet('A3', [fig10, fig12], []).
pupils(['Kim', 'Lee', 'Park']).
""")

def keys():
    """{"fig10-1": key}, from the command line."""
    sheets = os.path.join(folder, "sheets")
    subprocess.run([program, "problems", "-q", FILE, "-o", sheets],
                   check=True)
    found = {}
    for file in os.listdir(sheets):
        if file.endswith("-key.json"):
            with open(os.path.join(sheets, file)) as key:
                found[file[:-len("-key.json")]] = json.load(key)
    with open(os.path.join(sheets, "pupils.csv")) as file:
        dealt = [line.strip().split(",") for line in file][1:]
    return found, dealt


def started():
    front = Front(program, models, None, ("--problems", FILE), env)
    front.code = front.process.stdout.readline().decode().strip().split(
        "/#")[1]
    return front


def pupil(secret):
    page = front.socket()
    page.say({"id": 0, "do": "hello", "token": front.code, "pupil": secret})
    page.hello = page.hear()[0]
    return page


def code(head):
    return head.get("error", {}).get("code")


def texts(key):
    return [str(key["loops"])] + ["%.2f mm" % one["value"]
                                  for one in key["measures"]]


key, dealt = keys()
front = started()
teacher = front.page()
check("the teacher", teacher.hello["class"] == {"teacher": True, "name": None}
      and teacher.hello["file"] is None, teacher.hello)
kim = pupil("a" * 32)
check("a pupil", kim.hello["class"] == {"teacher": False, "name": None},
      kim.hello)
head, _ = kim.ask("problem", problem="fig10")
check("a name first", code(head) == "request_error.not_in_class", head)
head, _ = kim.ask("problems")
check("the problems", head.get("problems") == [
    {"problem": "fig10", "variants": 3}, {"problem": "fig12", "variants": 1}]
    and head["pupils"] == ["Kim", "Lee", "Park"], head)
for name in ("", "   ", "x" * 61, "a\x01b", 7, None, ["Kim"]):
    check("no name: %s" % name, code(kim.ask("join", name=name)[0])
          == "request_error.bad_key")
check("who joins", kim.ask("join", name=" Kim ")[0].get("name") == "Kim")
check("the teacher hears", teacher.hear()[0] == {"event": "class"})

# The question is the sheet of the verb `problems`; it says nothing of the answer.
head, body = kim.ask("problem", problem="fig10", lang="ko")
number = dict(zip(("fig10", "fig12"), dealt[0][1:]))
check("as pupils.csv says", head.get("called") == number["fig10"], head)
check("a question", head.get("shows") == "question" and len(body) > 1000
      and len(head["fields"]) == 2 and "checked" not in head, head)
check("in both languages", all(one["words"]["en"] != one["words"]["ko"]
                               for one in head["fields"]))
mine = texts(key[number["fig10"]])
said = json.dumps(head)
check("nothing is given away", "%.1f" % key[number["fig10"]]["measures"][0]
      ["value"] not in said, said)
other = [one for one in key if one.startswith("fig10") and
         one != number["fig10"]][0]
head, _ = kim.ask("problem", problem="fig10", number=int(other[-1]),
                  file="/etc/passwd", pupil="Lee", turn=2)
check("the own variant alone", head.get("called") == number["fig10"], head)
for keys_, wanted in ((dict(problem="none"), "request_error.bad_key"),
                      (dict(problem=7), "request_error.bad_key"),
                      (dict(problem="fig10", answers=["1"]),
                       "request_error.bad_key"),
                      (dict(problem="fig10", answers="12"),
                       "request_error.bad_key"),
                      (dict(problem="fig10", show=1),
                       "request_error.bad_key"),
                      (dict(problem="fig10", lang="fr"),
                       "request_error.bad_key")):
    check("refused: %s" % keys_, code(kim.ask("problem", **keys_)[0])
          == wanted)
check("models of the class have the answers", [
    code(kim.ask("open", file=name)[0]) for name in
    ("fig10.pl", "./fig12.pl", os.path.join(models, "fig10.pl"))] ==
    ["request_error.answers_inside"] * 3 and kim.hello["models"] == [] and
    "fig10.pl" in teacher.hello["models"], kim.hello)
check("not for pupils", code(kim.ask("class")[0])
      == "request_error.owner_alone")

# Wrong, half right, right.
head, _ = kim.ask("problem", problem="fig10", answers=["77", "0"])
check("wrong", [(one["right"], one["said"], one["why"], one["value"])
                for one in head["checked"]] ==
      [(False, "more", None, None), (False, "less", None, None)]
      and head["shows"] == "question", head)
head, _ = kim.ask("problem", problem="fig10", answers=[mine[0], "x"])
check("half right", [one["said"] for one in head["checked"]] ==
      ["right", "no_number"] and head["checked"][0]["why"]["ko"], head)
head, body = kim.ask("problem", problem="fig10", answers=mine)
check("right", all(one["right"] for one in head["checked"]) and
      head["shows"] == "answer" and len(body) > 1000, head)
check("explained", "√" in head["checked"][1]["why"]["en"], head)
head, _ = kim.ask("problem", problem="fig12", show=True, answers=["0"])
check("shown", head["shows"] == "answer" and head["checked"][0]["why"], head)
while True:
    head, _ = teacher.ask("class")
    row = head["pupils"][0]
    if len(row["done"]) == 2:
        break
check("the table", row["name"] == "Kim" and {
    one["problem"]: (one["tries"], one["right"], one["shown"])
    for one in row["done"]} == {"fig10": (3, [True, True], False),
                                "fig12": (1, [False], True)}, row)
head, _ = kim.ask("problem", problem="fig10", answers=["1", "1"])
head, _ = teacher.ask("class")
check("what was right stays right", [
    one["right"] for one in head["pupils"][0]["done"]
    if one["problem"] == "fig10"] == [[True, True]], head)
head, body = teacher.ask("problem", problem="fig10", number=2, show=True)
check("the teacher sees any answer", head.get("called") == "fig10-2" and
      head["shows"] == "answer", head)
check("and is not in the table", len(teacher.ask("class")[0]["pupils"]) == 1)

# Thirty, two of whom answer while the front is killed.
many = [pupil("%032x" % (i + 1)) for i in range(30)]
for i, one in enumerate(many):
    one.ask("join", name="pupil %d" % i)
right = wrong = 0
for i, one in enumerate(many):
    head, _ = one.ask("problem", problem="fig12")
    answers = texts(key[head["called"]])[:1] if i % 2 else ["9"]
    head, _ = one.ask("problem", problem="fig12", answers=answers)
    right += head["checked"][0]["right"]
check("a class of 30", right == 15, right)
for one in many[:2]:
    one.say({"id": 7000, "do": "problem", "problem": "fig10",
             "answers": ["1", "1"]})
told = [one.hear()[0] for one in many[:1]]
front.process.kill()
front.process.wait()
for one in many + [kim, teacher]:
    one.close()
front.process.stdout.close()
front.process.stderr.close()
book = [os.path.join(at, name) for at, _, names in
        os.walk(os.path.join(folder, "state")) for name in names
        if name.endswith(".answers")]
check("one book", len(book) == 1, book)
with open(book[0]) as file:
    text = file.read()
check("no secret is in it", "a" * 32 not in text and "%032x" % 1 not in text)
with open(book[0], "a") as out:
    out.write('{"pupil":"0", "name":')  # as a power failure leaves it
with open(book[0], "rb") as file:
    half = file.read()
front = started()
teacher = front.page()
with open(book[0]) as file:
    check("the half line is gone", file.read() == text)
with open(book[0] + ".damaged-1", "rb") as file:
    check("and kept", file.read() == half)
rows = teacher.ask("class")[0]["pupils"]
by_name = {row["name"]: row["done"] for row in rows}
check("all are there again", len(rows) == 31 and all(
    by_name["pupil %d" % i][0]["right"] == [bool(i % 2)]
    for i in range(30)), rows)
check("what was told is kept", told[0].get("checked") and any(
    one["problem"] == "fig10" for one in by_name["pupil 0"]), by_name)
kim = pupil("a" * 32)
check("a pupil is known again", kim.hello["class"]["name"] == "Kim")
time.sleep(0.1)
kim.close()
teacher.close()
front.end(signal.SIGINT)
with open(book[0], "a") as out:
    out.write("\n")
front = started()
front.page().close()
check("an emptied line is noticed", os.path.exists(book[0] + ".damaged-2"))
front.end(signal.SIGINT)
done = subprocess.run([program, "serve", "--no-open", "--problems",
                       os.path.join(models, "fig10.pl")],
                      stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                      check=False, timeout=20, env=env)
check("no file of problems", done.returncode == 3 and done.stdout == b"" and
      b"fig10.pl" in done.stderr, done)
checks.finish()
