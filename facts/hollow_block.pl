% A block with a square hole from top to bottom. Its top and bottom are hollow
% polygons: a negative number is a jump, the step to it is no edge. The hole
% runs clockwise seen from outside.
%
% Source: the hollow polygon is Fig. 3 of H.-C. Chae, KSME Journal 12(1), 1988.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, hollow_block).

v(1, 1, -2, -2, 0).     % bottom, outside
v(1, 2,  2, -2, 0).
v(1, 3,  2,  2, 0).
v(1, 4, -2,  2, 0).
v(1, 5, -1, -1, 0).     % bottom, hole
v(1, 6,  1, -1, 0).
v(1, 7,  1,  1, 0).
v(1, 8, -1,  1, 0).
v(1, 9, -2, -2, 1).     % top, outside
v(1, 10, 2, -2, 1).
v(1, 11, 2,  2, 1).
v(1, 12, -2, 2, 1).
v(1, 13, -1, -1, 1).    % top, hole
v(1, 14, 1, -1, 1).
v(1, 15, 1,  1, 1).
v(1, 16, -1, 1, 1).

p(1, 1, [4, 3, 2, 1, 4, -5, 6, 7, 8, 5]).
p(1, 2, [9, 10, 11, 12, 9, -13, 16, 15, 14, 13]).
p(1, 3, [1, 2, 10, 9]).
p(1, 4, [2, 3, 11, 10]).
p(1, 5, [3, 4, 12, 11]).
p(1, 6, [4, 1, 9, 12]).
p(1, 7, [6, 5, 13, 14]).
p(1, 8, [7, 6, 14, 15]).
p(1, 9, [8, 7, 15, 16]).
p(1, 10, [5, 8, 16, 13]).

view(300, 60, 20).
