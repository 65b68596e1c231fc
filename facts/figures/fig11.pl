% Figure 11: two cones with axes at right angles.
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer,
%         KSME Journal 12(1), 1988, Fig. 11 (11b: the lines on one cone alone);
%         sizes chosen for this file.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, cone(radius(1), height(2.6), facets(40))).
segment(2, solid, at([rotate(y, 90), translate(-1.5, 0, 0.8)],
                     cone(radius(0.75), height(3.4), facets(40)))).

view(300, 68, 20).
projection(parallel).
