"""dark.py -- is the same drawn in two pictures?

    python3 dark.py [--crop] TOLERANCE A B

A and B are PGM (raw), or PNG without line filters. Every dark dot of A must
have a dot that is not white in B, no farther than TOLERANCE dots, and the other
way round. With --crop both are cut to what is dark first, for programs that
move drawings. Prints how many dots have none; exits 1 if more than one in a
thousand.

A row of dots is a number, a bit for each: shifting and joining numbers makes
all dots wider at once.
"""
import struct
import sys
import zlib

DARK, FAINT = 128, 230


def rows_of_pgm(data):
    fields, at = [], 2
    while len(fields) < 3:
        while data[at:at + 1].isspace():
            at += 1
        if data[at:at + 1] == b'#':
            at = data.index(b'\n', at)
            continue
        end = at
        while not data[end:end + 1].isspace():
            end += 1
        fields.append(int(data[at:end]))
        at = end
    width, height, _ = fields
    at += 1
    return [data[at + y * width:at + (y + 1) * width] for y in range(height)]


def chunks(data):
    at = 8
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def light(red, green, blue):
    return (299 * red + 587 * green + 114 * blue) // 1000


def rows_of_png(data):
    parts = dict(chunks(data))
    width, height, bits, kind = struct.unpack('>IIBB', parts[b'IHDR'][:10])
    raw = zlib.decompress(parts[b'IDAT'])
    stride = 1 + (width * bits * (3 if kind == 2 else 1) + 7) // 8
    lines = [raw[y * stride:(y + 1) * stride] for y in range(height)]
    assert all(line[0] == 0 for line in lines), 'a filter'
    if kind == 2:
        return [bytes(light(*dot) for dot in
                      zip(line[1::3], line[2::3], line[3::3]))
                for line in lines]
    palette = parts[b'PLTE']
    grey = [light(*palette[i:i + 3]) for i in range(0, len(palette), 3)]
    each = 8 // bits
    rows = []
    for line in lines:
        dots = bytearray()
        for byte in line[1:]:
            for place in range(each):
                shift = 8 - bits * (place + 1)
                dots.append(grey[min(byte >> shift & (1 << bits) - 1,
                                     len(grey) - 1)])
        rows.append(bytes(dots[:width]))
    return rows


def rows_of(name):
    data = open(name, 'rb').read()
    return rows_of_png(data) if data[:4] == b'\x89PNG' else rows_of_pgm(data)


def below(rows, limit):
    table = bytes(48 + (level < limit) for level in range(256))
    return [int(row.translate(table) or b'0', 2) for row in rows]


def cropped(rows):
    dark = below(rows, DARK)
    lines = [y for y, bits in enumerate(dark) if bits]
    columns = 0
    for bits in dark:
        columns |= bits
    width = len(rows[0])
    left = width - columns.bit_length()
    right = width - (columns & -columns).bit_length() + 1
    return [row[left:right] for row in rows[lines[0]:lines[-1] + 1]]


def wider(bits, reach):
    out = bits
    for step in range(1, reach + 1):
        out |= bits << step | bits >> step
    return out


def alone(rows, others, reach):
    """How many dark dots of rows have none of others near; how many dark."""
    dark = below(rows, DARK)
    faint = [wider(bits, reach) for bits in below(others, FAINT)]
    count = 0
    for y, bits in enumerate(dark):
        near = 0
        for other in faint[max(0, y - reach):y + reach + 1]:
            near |= other
        count += bin(bits & ~near).count('1')
    return count, sum(bin(bits).count('1') for bits in dark)


def same_width(a, b):
    """Rounding may give one picture a row or a column more."""
    width = min(len(a[0]), len(b[0]))
    height = min(len(a), len(b))
    assert max(len(a[0]), len(b[0])) - width < 4, (len(a[0]), len(b[0]))
    assert max(len(a), len(b)) - height < 4, (len(a), len(b))
    return ([row[:width] for row in a[:height]],
            [row[:width] for row in b[:height]])


def main(words):
    crop = words[0] == '--crop'
    reach, *names = words[crop:]
    a, b = map(rows_of, names)
    if crop:
        a, b = cropped(a), cropped(b)
    a, b = same_width(a, b)
    worst = 0
    for one, two in ((a, b), (b, a)):
        count, dark = alone(one, two, int(reach))
        print(count, 'of', dark, 'dark dots have none near')
        worst = max(worst, count / max(1, dark), dark == 0)
    sys.exit(worst > 0.001)


main(sys.argv[1:])
