% Figure 13: two equal cylinders whose axes, x and z, meet at right angles. The
% penetration lines lie on the planes |x| = |z|.
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer,
%         KSME Journal 12(1), 1988, Fig. 13; sizes chosen for this file.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, at([translate(0, 0, -2)],
                     cylinder(radius(1), height(4), facets(40)))).
segment(2, solid, at([translate(0, 0, -2), rotate(y, 90)],
                     cylinder(radius(1), height(4), facets(40)))).

view(312, 68, 20).
projection(parallel).
