"""Writes files that ask for too much into the folder ARGV[1], each named by the
limit it breaks (tests/cli/hostile.sh)."""
import os
import random
import sys

folder = sys.argv[1]


def write(name, text):
    with open(os.path.join(folder, name), 'wb') as out:
        out.write(text if isinstance(text, bytes) else text.encode())


deep, wide = 100000, 3000000
write('depth.list.pl', 'p(1,1,' + '[' * deep + ']' * deep + ').\n')
write('depth.open.pl', 'p(1,1,' + '[' * wide)
write('depth.term.pl', 'segment(1,solid,' + 'f(' * deep + 'a' + ')' * deep
      + ').\n')
write('depth.small.pl', 'segment(1,solid,' + 'f(' * 2000 + 'a' + ')' * 2000
      + ').\n')
write('depth.prefix.pl', 'v(1,1,' + '- ' * deep + '1,0,0).\n')
write('depth.infix.pl', 'v(1,1,' + '1+' * deep + '1,0,0).\n')
write('depth.comma.pl', 'v(1,1,(' + '1,' * deep + '1),0,0).\n')
write('depth.brace.pl', 'v(1,1,' + '{' * deep + '}' * deep + ',0,0).\n')
write('depth.not.pl', 'a :- ' + '\\+ ' * deep + 'b.\n')
write('depth.body.pl', 'a :- ' + 'b, ' * deep + 'b.\n')
write('depth.tree.pl', 'segment(1,solid,' + 'union([' * deep
      + 'box(size(1,1,1))' + '])' * deep + ').\n')
write('depth.hidden.pl', "v(1,1,0'(,0,0). /* ' */ p(1,1," + '[' * deep)
write('digits.pl', 'v(1,1,' + '9' * 1000000 + ',0,0).\n')
write('digits.radix.pl', "v(1,1,36'" + 'Z' * 1000000 + ',0,0).\n')
write('name.pl', 'segment(1,solid,' + 'a' * 20000000 + ').\n')
write('name.quoted.pl', "segment(1,solid,'" + '\\n' * 5000000 + "').\n")
write('name.string.pl', 'title_block(name,"' + 'x' * 5000000 + '").\n')
write('name.sign.pl', 'v(1,1,' + '+' * 5000000 + ',0,0).\n')
write('facets.pl', 'segment(1,solid,sphere(radius(1),facets(3000),'
      'bands(3000))).\n')

step = 'multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {\n'
write('blocks.csg', step * deep + 'cube(size=[1,1,1],center=false);\n'
      + '}\n' * deep)
write('blocks.open.csg', 'union() {\n' * deep)
write('depth.csg', 'polyhedron(points=[' + '[' * deep + ']' * deep
      + ',faces=[]);\n')
write('depth.small.csg', 'polyhedron(points=[' + '[' * 20000 + ']' * 20000)
write('digits.csg', 'cube(size=[' + '9' * 1000000 + ',1,1],center=false);\n')
write('name.csg', 'a' * 10000000 + '();\n')
write('file.csg', 'cube(size=[1,1,1],center=true);\n' * 520000)
write('name.string.csg', 'text(text="' + 'a' * 1000000 + '",size=10);\n')
write('facets.csg', 'sphere($fn=1000000000,$fa=12,$fs=2,r=10);\n')
write('facets.circle.csg', 'linear_extrude(height=1) '
      '{circle($fn=1e9,$fa=12,$fs=2,r=10);}\n')

write('nodes.leaves.csg', 'cube(size=[1,1,1],center=true);\n' * 125000)
# Far behind its beginning a fact has a fault.
write('far.pl', 'v(1,1,' + ' \n' * 400000 + '/*\xe9*/ a,0,0).\n')
write('far.list.pl', 'v(1,1,[' + '1,' * 2000000 + '1],0,0).\n')
# What stands in a manifest.
write('long.job.pl', "job([%s1], check, ['cube.pl'], []).\n" % ('1,' * 1000000))
write('long.verb.pl', "job(a, [%s1], ['cube.pl'], []).\n" % ('1,' * 1000000))
write('long.set.pl', "job(a, check, ['cube.pl'], [set(r, f(%sx))]).\n"
      % (('a' * 60000 + ',') * 200))
write('dict.pl', "job(V, check, ['cube.pl'], []) @ V in _{a:1}.\n")
write('apart.pl', 'a(1). b(1).\n' * 50000)

# A tree that doubles, and a long chain that does not.
rows = ['segment(1,solid,box(size(1,1,1))).\n']
for i in range(2, 42):
    rows.append('segment(%d,solid,union([%d,at([translate(%d,0,0)],%d)])).\n'
                % (i, i - 1, 2 ** i, i - 1))
write('nodes.pl', ''.join(rows))
rows = ['segment(1,solid,box(size(1,1,1))).\n']
for i in range(2, 2001):
    rows.append('segment(%d,solid,at([translate(1,0,0)],%d)).\n' % (i, i - 1))
write('chain.pl', ''.join(rows))
write('nest.csg', step.replace('0]]', '0]]', 1) * 500
      + 'cube(size=[1,1,1],center=false);\n' + '}\n' * 500)

cube = open('facts/cube.pl').read()
vertices = cube[cube.index('v(1'):]
write('cursor.pl', "segment(1,solid,'\x1b]0;title\x07\x1b[2J\u202e\u2066').\n"
      + vertices)
write('cursor_fault.pl', "v(1,1,'\x1b[2J\n\x1b]0;title\x07\u202e',0,0).\n")
write('cursor.csg', 'cube(size="\x1b[2J");\n')

# Much text, little model: what has * is read, but is no part.
write('large.csg', 'cube(size=[1,1,1],center=true);*group() {\n'
      + ''.join('multmatrix([[1, 0, 0, %d], [0, 1, 0, %r], [0, 0, 1, 0], '
                '[0, 0, 0, 1]]) {\n\tcube(size = [1, 2, 3], center = false);'
                '\n}\n' % (i, i / 7) for i in range(15000)) + '}\n')
write('nodes.flat.pl', 'segment(1,solid,union(['
      + ','.join(['box(size(1,1,1))'] * 105000) + '])).\n')

# One fact of 14 MB: lists that are looked through for many faults.
ones = ','.join(['1'] * 6990000)
write('huge.polygon.pl', 'segment(1,solid,a).\nv(1,1,0,0,0).\np(1,1,[%s]).\n'
      % ones)
write('huge.curve.pl', 'segment(1,solid,a).\nv(1,1,0,0,0).\ncurve(1,[%s]).\n'
      % ones)
write('huge.union.pl', 'segment(1,solid,union([%s])).\n' % ones)
write('name.words.pl', 'segment(1,solid,named([%s],box(size(1,1)))).\n' % ones)
write('huge.terms.pl', 'segment(1,solid,union([%s])).\n'
      % ','.join(['f(a)'] * 1400000))

# Rule files of more clauses than anybody writes, and of a chain of calls.
write('clauses.pl', ''.join('a(%d).\n' % i for i in range(600000)))
write('chain.rules.pl', 'may_cut(A,B) :- p29999(A,B).\np0(_,_).\n'
      + ''.join('p%d(X,Y) :- p%d(X,Y).\n' % (i, i - 1)
                for i in range(1, 30000)))


# Polygons that cross, touch or run over themselves: random corners; few corners,
# many times; edges on one line; a square that is gone round.
def polygon(name, points, ring):
    write(name, 'OFF\n%d 1 0\n' % len(points)
          + ''.join('%r %r 0\n' % p for p in points)
          + '%d %s\n' % (len(ring), ' '.join(map(str, ring))))


random.seed(16)
polygon('tangled.crosses.off',
        [(random.random(), random.random()) for _ in range(200000)],
        range(200000))
few = [(random.randint(0, 99), random.randint(0, 99)) for _ in range(40)]
polygon('tangled.few.off', few,
        [5 * i % 40 + random.randrange(4) for i in range(40000)])
n = 10000
polygon('tangled.line.off', [(i, 0) for i in range(n)] + [(0, 5)],
        [i // 2 if i % 2 else n - 1 - i // 2 for i in range(n)] + [n])
polygon('tangled.round.off', [(0, 0), (1, 0), (1, 1), (0, 1)],
        [i % 4 for i in range(20000)])
