% Figure 10: two pyramids. The second lies on its side and goes through the
% first with its apex.
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer,
%         KSME Journal 12(1), 1988, Fig. 10; sizes chosen for this file.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, pyramid(base(2, 2), height(2.5))).
segment(2, solid, at([rotate(z, 45), rotate(y, 90), translate(-1.6, 0.1, 0.8)],
                     pyramid(base(1, 1), height(3.2)))).

view(292, 66, 20).
projection(parallel).
