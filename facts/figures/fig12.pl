% Figure 12: a cylinder through a cone.
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer,
%         KSME Journal 12(1), 1988, Fig. 12 (12b: the lines on the cone);
%         sizes chosen for this file.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, cone(radius(1), height(2.6), facets(40))).
segment(2, solid, at([rotate(y, 90), translate(-1.5, 0.1, 0.75)],
                     cylinder(radius(0.4), height(3), facets(40)))).

view(300, 68, 20).
projection(parallel).
