% Two cubes, one pushed into a corner of the other.
%
% Units:  model units, right-handed.

segment(1, solid, box(size(2, 2, 2))).
segment(2, solid, at([translate(1.1, 0.7, 0.6)], box(size(2, 2, 2)))).

view(300, 60, 20).
