% Two boxes, one on the other, that have a square of 1 in common: face glue.
%
% Source: S.-H. Park, A Study on Geometrical Glue Operation between Non-manifold
%         Models, 1996, Fig. 7; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, solid, box(size(2, 2, 1))).
segment(2, solid, at([translate(1, 1, 1)], box(size(2, 2, 1)))).
segment(3, cells, glue([1, 2])).

view(300, 60, 0).
