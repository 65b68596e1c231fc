% A bent wire that goes through a roof: a curve is a segment with edges and no
% polygons, here as a chain of vertices. The roof is an open surface of two
% polygons that share the ridge.
%
% Units:  model units, right-handed.

segment(1, surface, roof).

v(1, 1, -2, -1, 0).
v(1, 2,  2, -1, 0).
v(1, 3,  2,  0, 1).
v(1, 4, -2,  0, 1).
v(1, 5,  2,  1, 0).
v(1, 6, -2,  1, 0).

p(1, 1, [1, 2, 3, 4]).
p(1, 2, [4, 3, 5, 6]).

segment(2, curve, wire).

v(2, 1, -1.5, -1, 1).
v(2, 2, -0.5, -0.5, 0.1).
v(2, 3,  0.5, 0.2, 0.3).
v(2, 4,  1.0, 0.4, 1.2).
v(2, 5,  1.2, 0.6, -0.2).

curve(2, [1, 2, 3, 4, 5]).

view(300, 55, 20).
