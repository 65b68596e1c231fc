#!/usr/bin/env python3
"""render_difference.py [WIDTHxHEIGHT [SCENE...]] -- how far shaded pictures of scenes of
../shared/peers/render are from those of POV-Ray 3.7: the same camera, lights and
colours; POV-Ray with 16 rays a dot or more, without jitter. The mean and the most
of |difference| of all bytes, and the part of the dots of which a byte differs by
more than 2 levels; in percent."""
import importlib.util
import math
import os
import shutil
import subprocess
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..')
PEERS = os.path.join(ROOT, '../shared/peers/render/scenes.py')
WORK = os.path.join(ROOT, os.environ.get('B', 'build'), 'bench/render')


def model(scenes, tree, facts):
    """The term of a tree; each leaf is a segment with its colour."""
    if isinstance(tree[1], list):
        parts = ','.join(model(scenes, t, facts) for t in tree[1])
        return f'{tree[0]}([{parts}])'
    s = len(facts) + 2
    facts.append(f'segment({s}, solid, {scenes.pl_tree(tree)}).\n'
                 f'look({s}, colour(rgb{tree[1]})).\n')
    return str(s)


def window(scenes, centre, width, size):
    eye, right, up = scenes.camera()
    x = sum(a * b for a, b in zip(centre, right))
    y = sum(a * b for a, b in zip(centre, up))
    height = width * size[1] / size[0]
    return ','.join(repr(v) for v in (x - width / 2, y - height / 2,
                                      x + width / 2, y + height / 2))


def dots(name, size):
    """The last bytes of a PPM, whatever its head has."""
    with open(name, 'rb') as file:
        return file.read()[-3 * size[0] * size[1]:]


def difference(scenes, name, size):
    tree, centre, width = scenes.SCENES[name]
    facts, at = [], os.path.join(WORK, name + '_difference')
    term = model(scenes, tree, facts)
    with open(at + '.pl', 'w') as out:
        out.write(f'segment(1, solid, {term}).\n' + ''.join(facts) +
                  'view(300, 60, 0).\n')
    with open(at + '.pov', 'w') as out:
        out.write(scenes.pov(name).replace('pigment { rgb', 'pigment { srgb'))
    subprocess.run([os.path.join(ROOT, 'sanggwan'), 'render', '-q', at + '.pl',
                    '--size', '%dx%d' % size, '--smooth', '16',
                    '--window=' + window(scenes, centre, width, size), '-o',
                    at + '.ppm'], check=True)
    subprocess.run(['povray', '+I' + at + '.pov', '-D', '+W%d' % size[0],
                    '+H%d' % size[1], '+AM1', '+A0.0', '+R4', '-J', '+FP',
                    '+O' + at + '_pov.ppm'], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    ours, theirs = dots(at + '.ppm', size), dots(at + '_pov.ppm', size)
    apart = [abs(a - b) for a, b in zip(ours, theirs)]
    other = sum(max(apart[i:i + 3]) > 2 for i in range(0, len(apart), 3))
    print('%-14s %8.3f %8.1f %8.3f' % (
        name, sum(apart) / len(apart) / 2.55, max(apart) / 2.55,
        300 * other / len(apart)), flush=True)


def main():
    if not os.path.exists(PEERS):
        return print('skipped: no ../shared/peers')
    if not shutil.which('povray'):
        return print('skipped: no povray (apt-get install povray)')
    size = sys.argv[1] if len(sys.argv) > 1 else '640x360'
    size = tuple(int(n) for n in size.split('x'))
    spec = importlib.util.spec_from_file_location('scenes', PEERS)
    scenes = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(scenes)
    os.makedirs(WORK, exist_ok=True)
    print('%-14s %8s %8s %8s' % ('scene', 'mean', 'most', 'dots'))
    for name in sorted(sys.argv[2:] or scenes.SCENES):
        difference(scenes, name, size)


main()
