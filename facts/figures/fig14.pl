% Figure 14: two cylinders with axes at right angles that do not meet.
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer,
%         KSME Journal 12(1), 1988, Fig. 14 (14b: the lines on one cylinder);
%         sizes chosen for this file.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, at([translate(0, 0, -2)],
                     cylinder(radius(1), height(4), facets(40)))).
segment(2, solid, at([translate(0, 0, -2), rotate(y, 90),
                      translate(0, -0.45, 0)],
                     cylinder(radius(0.75), height(4), facets(40)))).

view(295, 65, 20).
projection(parallel).
