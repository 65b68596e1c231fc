% An L of two boxes, flush on three sides (docs/rules.md). Millimetres,
% right-handed, faces counter-clockwise from outside.

segment(1, solid, box(size(40, 20, 10))).
segment(2, solid, at([translate(-15, 0, 10)], box(size(10, 20, 30)))).
segment(3, solid, union([1, 2])).
