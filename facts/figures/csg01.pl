% Figure 1 of K.-H. Park and C.-M. Kyung, Design and Display of Solids Using
% CSG and Boundary Representation, 1989: how the segment of intersection of two
% polygons may lie in the first of them. (a) Both ends are on its border, which
% divides it; (b) both are inside; (c) one is on the border, one inside. Sizes
% are chosen. Millimetres, z up, right-handed.
segment(1, surface, rectangle(size(40,30))).
segment(2, surface, at([rotate(x,90)], rectangle(size(52,26)))).
segment(3, surface, at([translate(64,0,0)], rectangle(size(40,30)))).
segment(4, surface, at([rotate(x,90), translate(64,0,0)],
                       rectangle(size(20,26)))).
segment(5, surface, at([translate(128,0,0)], rectangle(size(40,30)))).
segment(6, surface, at([rotate(x,90), translate(112,0,0)],
                       rectangle(size(32,26)))).
look(1, colour(rgb(170,190,210))).
look(3, colour(rgb(170,190,210))).
look(5, colour(rgb(170,190,210))).
look(2, colour(rgb(220,140,60))).
look(4, colour(rgb(220,140,60))).
look(6, colour(rgb(220,140,60))).
view(290, 60, 0).
