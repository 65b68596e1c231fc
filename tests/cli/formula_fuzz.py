"""Random formulas over parameters against an evaluator of their own.

    formula_fuzz.py PROGRAM FOLDER CASES SEED

CASES formulas are parameters of model files, 500 to a file, each over those
before it; their values by the program have to be those of this evaluator, to
the last bit: doubles, powers by fractions, sines of an angle that was reduced
as a fraction. Formulas without a value go one by one, and the fault has to be
the right one. Prints "N formulas, M faults", or what differs, and fails.
"""
import math
import random
import re
import struct
import subprocess
import sys
from fractions import Fraction


class Fault(Exception):
    pass


DIVISION = "divides by zero"
NOT_REAL = "is no real number"
TOO_LARGE = "is too large"
POWER = "the exponent should be whole"


def finite(x):
    if math.isnan(x):
        raise Fault(NOT_REAL)
    if math.isinf(x):
        raise Fault(TOO_LARGE)
    return x + 0.0


def sine_cosine(degrees):
    """Of multiples of 2**-48; the angle is reduced exactly."""
    turn = Fraction(degrees)
    quarter = math.floor(turn / 90)
    rest = turn - 90 * quarter

    def first(angle):
        if angle > 45:
            sine, cosine = first(90 - angle)
            return cosine, sine
        radians = float(angle) * math.pi / 180.0
        return (rounded(math.sin(radians), 48), rounded(math.cos(radians), 48))

    sine, cosine = first(rest)
    for _ in range(quarter % 4):
        sine, cosine = cosine, 0.0 - sine
    return sine + 0.0, cosine + 0.0


def rounded(x, bits):
    scaled = Fraction(x) * 2**bits
    whole = math.floor(abs(scaled) + Fraction(1, 2))
    return float(Fraction(whole if scaled >= 0 else -whole, 2**bits))


def as_double(x):
    try:
        return float(x)
    except OverflowError:
        raise Fault(TOO_LARGE) from None


def divided(a, b):
    if b == 0:
        raise Fault(DIVISION)
    return a / b


def power(a, n):
    if n == 0.5:
        return root(a)
    if n != int(n) or abs(n) > 1000:
        raise Fault(POWER)
    if n == 0:
        return 1.0
    if a == 0:
        if n < 0:
            raise Fault(DIVISION)
        return 0.0
    return as_double(Fraction(a) ** int(n))


def root(a):
    if a < 0:
        raise Fault(NOT_REAL)
    return math.sqrt(a)


def degrees(radians):
    return rounded(radians * 180.0 / math.pi, 40)


def of_one(function):
    def inverse(a):
        if abs(a) > 1:
            raise Fault(NOT_REAL)
        return degrees(function(a))
    return inverse


def tangent(a):
    return divided(*sine_cosine(a))


def atan2(a, b):
    if a == 0 and b == 0:
        raise Fault(NOT_REAL)
    return degrees(math.atan2(a, b))


def nearest(a):
    return rounded(a, 0)


TWO = {"+": lambda a, b: a + b, "-": lambda a, b: a - b,
       "*": lambda a, b: a * b, "/": divided, "**": power}
FUNCTIONS = {"min": min, "max": max, "atan2": atan2}
ONE = {"sqrt": root, "abs": abs, "floor": lambda a: float(math.floor(a)),
       "ceiling": lambda a: float(math.ceil(a)), "round": nearest,
       "sin": lambda a: sine_cosine(a)[0], "cos": lambda a: sine_cosine(a)[1],
       "tan": tangent, "asin": of_one(math.asin), "acos": of_one(math.acos),
       "atan": lambda a: degrees(math.atan(a)), "-": lambda a: 0.0 - a}


def number(draw):
    kind = draw.random()
    if kind < 0.4:
        return str(draw.randint(-20, 400))
    if kind < 0.8:
        return repr(round(draw.uniform(-500, 500), draw.randint(0, 6)) + 0.0)
    if kind < 0.9:
        return draw.choice(["0", "1", "2", "30", "45", "90", "0.5", "360"])
    x = draw.uniform(1, 10) * 10.0 ** draw.randint(-30, 30)
    return repr(x) if "e" not in repr(x) else re.sub(
        r"^(-?\d+)e", r"\1.0e", repr(x))


def formula(draw, depth, known):
    """A text and its value, or the Fault that it has."""
    kind = draw.random()
    if depth == 0 or kind < 0.15:
        if known and draw.random() < 0.4:
            name = draw.choice(list(known))
            return f"param({name})", known[name]
        if draw.random() < 0.05:
            return "pi", math.pi
        text = number(draw)
        return (f"({text})" if text[0] == "-" else text), float(text) + 0.0
    if kind < 0.6:
        name = draw.choice(list(TWO))
        a, x = formula(draw, depth - 1, known)
        if name == "**":
            b = draw.choice(["2", "3", "0.5", "(-1)", "(-2)", "0", "7", "2.0",
                             "1.5", "200"])
            y = float(b.strip("()"))
        else:
            b, y = formula(draw, depth - 1, known)
        return f"({a}) {name} ({b})", applied(TWO[name], x, y)
    if kind < 0.7:
        name = draw.choice(list(FUNCTIONS))
        a, x = formula(draw, depth - 1, known)
        b, y = formula(draw, depth - 1, known)
        return f"{name}({a}, {b})", applied(FUNCTIONS[name], x, y)
    name = draw.choice(list(ONE))
    a, x = formula(draw, depth - 1, known)
    return f"{name}({a})", applied(ONE[name], x)


def applied(function, *values):
    for value in values:
        if isinstance(value, Fault):
            return value
    try:
        return finite(function(*values))
    except OverflowError:
        return Fault(TOO_LARGE)
    except Fault as fault:
        return fault


def asked(program, folder, facts, goal):
    path = f"{folder}/m.pl"
    with open(path, "w", encoding="utf-8") as file:
        file.write(facts + "v(1,1,0,0,0). curve(1,[1]).\n")
    return subprocess.run([program, "query", path, goal, "--format", "csv"],
                          capture_output=True, text=True, check=False)


def differing(program, folder, known):
    facts = "".join(f"param({n}, {t}).\n" for n, (t, _) in known.items())
    run = asked(program, folder, facts, "param(Name, Value)")
    got = dict(line.split(",") for line in run.stdout.splitlines()[1:])
    for name, (text, value) in known.items():
        if name not in got or bits(float(got[name])) != bits(value):
            yield f"{text}: {got.get(name)}, wanted {value!r} {run.stderr}"


def bits(x):
    return struct.pack(">d", x + 0.0)


def main():
    program, folder, cases, seed = sys.argv[1:]
    draw = random.Random(int(seed))
    faults = 0
    wrong = []
    known = {}
    for n in range(int(cases)):
        values = {name: v for name, (_, v) in list(known.items())[-20:]}
        text, value = formula(draw, draw.randint(1, 5), values)
        if isinstance(value, Fault):
            faults += 1
            if faults % 10 == 1:
                text, value = formula(draw, draw.randint(1, 4), {})
                if isinstance(value, Fault):
                    run = asked(program, folder, f"param(a, {text}).\n", "true")
                    if run.returncode != 3 or str(value) not in run.stderr:
                        wrong.append(f"{text}: wanted {value}: {run.stderr}")
            continue
        known[f"p{n}"] = (text, value)
        if len(known) == 500:
            wrong += differing(program, folder, known)
            known = {}
    wrong += differing(program, folder, known) if known else []
    for line in wrong[:10]:
        print(line)
    print(f"{int(cases)} formulas, {faults} faults, {len(wrong)} wrong")
    sys.exit(1 if wrong else 0)


main()
