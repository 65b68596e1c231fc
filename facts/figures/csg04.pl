% Figure 4 of K.-H. Park and C.-M. Kyung, Design and Display of Solids Using
% CSG and Boundary Representation, 1989: (a) two polygons A and B in one plane,
% counter-clockwise, (b) their union, (c) what they have in common, (d) A
% without B. They are plates, 2 mm thick. Sizes are chosen. Millimetres, z up,
% right-handed, faces counter-clockwise from outside.
segment(1, solid, named(a, prism(outline([[0,0],[40,0],[40,30],[0,30]]),
                                 height(2)))).
segment(2, solid, named(b, prism(outline([[24,-8],[56,6],[48,40],[30,22],
                                          [16,40]]), height(2)))).
segment(3, solid, at([translate(76,0,0)], union([1,2]))).
segment(4, solid, at([translate(152,0,0)], intersection([1,2]))).
segment(5, solid, at([translate(212,0,0)], difference([1,2]))).
segment(6, solid, union([1])).
segment(7, solid, union([2])).
look(1, colour(rgb(170,190,210))).
look(2, colour(rgb(220,140,60))).
view(270, 0, 0).
