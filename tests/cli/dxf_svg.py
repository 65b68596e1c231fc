"""dxf_svg.py -- a DXF file of lines, read by ezdxf, as an SVG.

    python3 dxf_svg.py FILE.dxf WIDTH HEIGHT >FILE.svg

The sheet is WIDTH x HEIGHT. Lines are as wide as the drawings say by their
layer: visible ones 0.5, hidden ones 0.25, penetration lines wider.
"""
import sys

import ezdxf

name, width, height = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
drawing = ezdxf.readfile(name)
audit = drawing.audit()
assert not audit.errors and not audit.fixes, audit.errors + audit.fixes
print(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}mm" '
      f'height="{height}mm" viewBox="0 0 {width} {height}">')
print('<rect width="100%" height="100%" fill="#fff"/>')
for line in drawing.modelspace().query('POLYLINE LINE'):
    if line.dxftype() == 'LINE':
        points = [line.dxf.start, line.dxf.end]
    else:
        points = [vertex.dxf.location for vertex in line.vertices]
        if line.is_closed:
            points.append(points[0])
    layer = line.dxf.layer
    thick = (0.7 if 'PENETRATION' in layer or layer == 'FRAME' else 0.5)
    if layer in ('FIELD', 'HATCHING', 'SHADING'):
        thick = 0.25
    if layer.startswith('HIDDEN'):
        thick /= 2
    print(f'<polyline fill="none" stroke="#000" stroke-width="{thick}" '
          'points="' + ' '.join(f'{p.x:.3f},{height - p.y:.3f}'
                                for p in points) + '"/>')
print('</svg>')
