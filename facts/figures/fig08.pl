% Figure 8: a cone and a straight line that goes through it.
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer,
%         KSME Journal 12(1), 1988, Fig. 8; sizes chosen for this file.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, cone(radius(1), height(2), facets(40))).
segment(2, curve, line(from(-1.4, -0.5, 0.35), to(1.4, 0.3, 0.95))).

view(300, 68, 20).
projection(parallel).
