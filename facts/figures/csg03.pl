% Figure 3 of K.-H. Park and C.-M. Kyung, Design and Display of Solids Using
% CSG and Boundary Representation, 1989: (a) two boxes, (b) an L of them in
% which each side is two polygons (by docs/faces_rules.pl), (c) the same with
% one: in one plane they are made one. Sizes are chosen. Millimetres, z up,
% right-handed, faces counter-clockwise from outside.
segment(1, solid, box(size(40,20,10))).
segment(2, solid, at([translate(-15,0,16)], box(size(10,20,30)))).
segment(3, solid, union([at([translate(60,0,0)], 4),
                         at([translate(60,0,0)], 5)])).
segment(4, solid, box(size(40,20,10))).
segment(5, solid, at([translate(-15,0,10)], box(size(10,20,30)))).
view(300, 62, 0).
