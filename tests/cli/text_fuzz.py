"""Texts of every reader, changed at random: whatever is in a file, the program
ends by itself, soon, with a status of its own and in words of its own.

    text_fuzz.py PROGRAM FOLDER CASES SEED [pictures]

(`pictures`: only looks, lights and what else a shaded picture is told)
prints a line for each case that is not so; tests/cli/text_fuzz.sh counts."""
import glob
import os
import random
import re
import subprocess
import sys

program, folder, cases, seed = (sys.argv[1], sys.argv[2], int(sys.argv[3]),
                                int(sys.argv[4]))
pictures = sys.argv[5:] == ['pictures']
chance = random.Random(seed)

facts = [open(name, 'rb').read() for name in sorted(glob.glob('facts/*.pl') +
         glob.glob('facts/figures/*.pl')) if os.path.getsize(name) < 4000]
csg = [b'group(){multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]])'
       b'{cube(size=[1,2,3],center=true);}difference(){sphere($fn=8,$fa=12,'
       b'$fs=2,r=2);cylinder($fn=6,$fa=12,$fs=2,h=3,r1=1,r2=0.5,'
       b'center=false);}}\n',
       b'linear_extrude(height=2,twist=20,slices=3,scale=[1,2],$fn=0,$fa=12,'
       b'$fs=2){polygon(points=[[0,0],[3,0],[0,3]],paths=undef,convexity=1);}\n'
       b'rotate_extrude(angle=270,$fn=5){square(size=[1,1],center=false);}\n'
       b'polyhedron(points=[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],faces=[[0,1,2],'
       b'[0,3,1],[0,2,3],[1,3,2]],convexity=1);\n']
styles = [b"line(any, crease, any, [width(0.5), colour(red)]).\n"
          b"line(hidden, any, 1, [dashes([2,1]), layer('a b'), pen(3)]).\n"
          b"paper(white).\n"]
looks = [b'look(2, colour(rgb(200, 60, 50))).\nlook(2, opacity(0.3)).\n'
         b'look(1, shine(0.4, 30)).\nlook(3, face(curved(side), '
         b'colour(blue))).\nlight(1, picture(-5, 6, 8)).\n'
         b'light(1, strength(0.75)).\nlight(0, strength(0.25)).\n',
         b'look(1, colour(grey)).\nlook(2, face(top, opacity(0.5))).\n'
         b'light(1, direction(0, 0, -1)).\nlight(2, picture(1, 0, 0)).\n'
         b'look(3, shine(1, 1)).\n']
titles = [b'title_block(name, "a box").\ntitle_block(scale, \'1:2\').\n'
          b'title_block(number, 12).\n']
goals = [b"v(1, V, X, Y, Z), X > 0.5", b"segment(S, K, N) ; p(1, P, [A|_])",
         b"findall(V, v(1,V,_,_,_), Vs), length(Vs, N)"]
words = [b'nan', b'inf', b'1.0Inf', b'-', b'0', b'1e308', b'99999999999',
         b'[]', b'[', b'(', b')', b']', b'{', b'}', b"'", b'"', b'\\', b'\0',
         b'\xff', b',', b'.', b'. ', b'/*', b'%', b'_', b'X', b'union(',
         b'at([],', b'0.0000001', b'-0.0', b'1r3', b'undef', b'$fn=3',
         b'solid', b'surface', b'curve', b'\x1b[2J', b'\xe2\x80\xae',
         b'[' * 3000, b'- ' * 3000, b'9' * 5000, b"'" + b'n' * 70000,
         b"0'", b'$fn=1e9', b'facets(1000000)', b':- ', b'->', b'\r']
numbers = [b'0', b'-1', b'1', b'2', b'7', b'1.0e-300', b'1.0e89',
           b'0.3333333333333333', b'1000000', b'2147483648', b'1.0e308']


def changed(text):
    text = bytearray(text)
    for _ in range(chance.randint(1, 3)):
        kind = chance.randint(0, 5)
        at = chance.randrange(len(text) + 1)
        to = min(len(text), at + chance.randint(1, 40))
        if kind == 0 and text:
            text[at % len(text)] = chance.randrange(256)
        elif kind == 1:
            del text[at:to]
        elif kind == 2:
            text[at:at] = chance.choice(words)
        elif kind == 3:
            text[at:at] = text[at:to]
        elif kind == 4:
            found = list(re.finditer(rb'-?\d+(\.\d+)?', bytes(text)))
            if found:
                one = chance.choice(found)
                text[one.start():one.end()] = chance.choice(numbers)
        elif chance.random() < 0.3:
            text = text[:at]
    return bytes(text)


def command():
    """Arguments, and the file that is changed (a goal is none)."""
    kind = chance.randrange(6)
    name = os.path.join(folder, 'a.' + ('csg' if kind == 2 else 'pl'))
    if kind == 5:
        goal = changed(chance.choice(goals)).replace(b'\0', b'')
        return ['query', 'facts/cube.pl', goal, '--limit', '20'], name, goal
    text = changed(chance.choice([facts, facts, csg, styles, titles][kind]))
    with open(name, 'wb') as out:
        out.write(text)
    picture = os.path.join(folder, 'a.svg')
    return [['check', name], ['draw', name, '-o', picture], ['eval', name],
            ['draw', 'facts/cube.pl', '--style', name, '-o', picture],
            ['draw', 'facts/cube.pl', '--sheet', 'A4', '--title-block', name,
             '-o', picture]][kind], name, text


hostile = ['nan', 'inf', '-inf', '1.0Inf', '-1', '0', '-0.0', '1e308', '1e-308',
           '1e400', '9' * 400, '', ' ', 'x', "'", '(', 'a,b', '1,2', '1,2,3',
           '0,0,0', '1,2,3,4', '0,0,0,1', 'inf,0,0', 'nan,1,1', '1e308,1e308,1',
           '1e-320,0,0', 'none', 'red', 'rgb(1,2,300)', 'x=1', 'y=1e300', 'z',
           '2=0.5', '2=nan', '2=-1', '99', 'front', '0x0', '1x1', '7x5', '3x9x2',
           '1x999999999', '4194305x1', '-3x4', '1.5x2', 'cel=0', 'cel=3',
           'cel=1e9', 'zebra=-1', 'zebra=2', 'gooch', 'xray', 'hatch', 'flat',
           'facets', 'true', 'leaf', 'root', 'central', 'parallel', '16', '3',
           '2147483648', '99999999999999999999', '\x1b[2J', '\u202e']
told = {'--eye': '3,-4,5', '--view': 'front', '--projection': 'central',
        '--look-at': '0,0,1', '--window': '-1,-1,1,1', '--smooth': '16',
        '--shade': 'cel=3', '--surface': 'facets', '--section': 'z',
        '--see-through': '1=0.4', '--colours': 'leaf', '--light': '1,2,3',
        '--background': 'none', '--palette': '16', '--dpi': '90', '--up': 'y',
        '--size': '31x17', '--scan-line': '3'}


def option():
    name = chance.choice(list(told))
    value = told[name]
    if chance.random() < 0.5:
        value = chance.choice(hostile)
    elif chance.random() < 0.2:
        value += chance.choice([',', 'x', '=', '1', '']) + chance.choice(hostile)
    if name == '--scan-line' and value.isdigit():
        value += '=' + os.path.join(folder, 'line.svg')
    return name + '=' + value


def picture():
    """As command(), of render: a file of looks that is changed, or options."""
    name, out = os.path.join(folder, 'a.pl'), os.path.join(folder, 'a.png')
    if os.path.exists(out):
        os.remove(out)
    model = chance.choice(['facts/figures/csg05.pl', 'facts/smooth.pl',
                           'facts/pipe_tee.pl'])
    arguments = ['render', model, '-o', out, '--size=24x16']
    if chance.random() < 0.5:
        text = changed(chance.choice(looks))
        with open(name, 'wb') as file:
            file.write(text)
        return arguments + ['--look', name], name, text
    options = [option() for _ in range(chance.randint(1, 3))]
    return arguments + options, name, ' '.join(options).encode()


def picture_faults(status, said, arguments):
    """A picture, or an error that says where."""
    out = arguments[3]
    if status == 0:
        with open(out, 'rb') as file:
            good = file.read(8) == b'\x89PNG\r\n\x1a\n'
        return [] if good else ['no picture']
    faults = ['a picture all the same'] if os.path.exists(out) else []
    places = [place for told in arguments[5:] for place in told.split('=')]
    if not (re.search('sanggwan: segment [0-9]+ ', said) or
            any(place and os.path.basename(place) in said for place in places)):
        faults.append('no place')
    return faults


raw = re.compile(r'Unknown procedure|[Ss]tack limit|I/O error|Domain error|'
                 r'Type error|unexpectedly failed|Arguments are not|'
                 r'sg_[a-z_]+:|No permission to')
control = re.compile('[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e'
                     '\u2066-\u2069]')


sanitized = 'ASAN_OPTIONS' in os.environ  # slower, and maps terabytes


def limited():
    import resource
    seconds = 60 if sanitized else 5
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    if not sanitized:
        resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))


statuses = {}
for case in range(cases):
    arguments, name, text = picture() if pictures else command()
    try:
        done = subprocess.run([program] + arguments, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=60, preexec_fn=limited)
        status, said = done.returncode, done.stderr.decode('utf8', 'replace')
    except subprocess.TimeoutExpired:
        status, said = 'endless', ''
    statuses[status] = statuses.get(status, 0) + 1
    faults = []
    if status not in (0, 1, 2, 3, 4):
        faults.append('status %s' % status)
    if raw.search(said):
        faults.append('words of Prolog')
    if control.search(said):
        faults.append('control characters')
    if pictures and status in (0, 1, 2, 3, 4):
        faults += picture_faults(status, said, arguments)
    if len(said) > 8000:
        faults.append('%d characters' % len(said))
    if faults:
        keep = os.path.join(folder, 'case%d' % case)
        with open(keep, 'wb') as out:
            out.write(text)
        print('case %d of seed %d: %s: %s: %r: %r' %
              (case, seed, ', '.join(faults), arguments[0], text[-300:],
               said[-300:]))
print('statuses: %s' % sorted(statuses.items(), key=str), file=sys.stderr)
