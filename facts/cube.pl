% A cube, as the paper types solids in: vertices, and polygons as vertex lists,
% counter-clockwise seen from outside.
%
% Units:  model units, right-handed.

segment(1, solid, cube).

v(1, 1, 0, 0, 0).
v(1, 2, 1, 0, 0).
v(1, 3, 1, 1, 0).
v(1, 4, 0, 1, 0).
v(1, 5, 0, 0, 1).
v(1, 6, 1, 0, 1).
v(1, 7, 1, 1, 1).
v(1, 8, 0, 1, 1).

p(1, 1, [4, 3, 2, 1]).
p(1, 2, [5, 6, 7, 8]).
p(1, 3, [1, 2, 6, 5]).
p(1, 4, [2, 3, 7, 6]).
p(1, 5, [3, 4, 8, 7]).
p(1, 6, [4, 1, 5, 8]).
