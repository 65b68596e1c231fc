% Borromean rings: three ellipses, no two of them linked, and yet they do not
% come apart.
%
% Source: a classic.
% Units:  model units, right-handed.

segment(1, solid, at([scale(1.6, 0.95, 1)],
                     torus(radius(3), tube(0.35), facets(120), sides(32)))).
segment(2, solid, at([rotate(axis(1, 1, 1), 120)], 1)).
segment(3, solid, at([rotate(axis(1, 1, 1), 240)], 1)).
segment(4, solid, at([], 1)).

view(300, 58, 0).
