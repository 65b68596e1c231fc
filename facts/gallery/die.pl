% A die: a cube rounded by a sphere, its pips taken out by smaller ones.
%
% Source: made up.
% Units:  millimetres, right-handed.

segment(1, solid, at([translate(0, 0, -8)], box(size(16, 16, 16)))).
segment(2, solid, sphere(radius(11.2), facets(72), bands(36))).
segment(3, solid, sphere(radius(1.7), facets(24), bands(12))).

% The pips of one side, as they lie on top.
segment(4, solid, at([translate(0, 0, 8.2)], 3)).
segment(5, solid, union([at([translate(4, 4, 8.2)], 3),
                         at([translate(-4, -4, 8.2)], 3)])).
segment(6, solid, union([5, at([rotate(z, 90)], 5)])).

segment(7, solid,
        named(die,
              difference([intersection([1, 2]),
                          4,
                          at([rotate(x, 90)], 5),
                          union([at([rotate(y, 90)], 4),
                                 at([rotate(y, 90)], 5)]),
                          at([rotate(y, -90)], 6),
                          union([at([rotate(x, -90)], 6),
                                 at([rotate(x, -90)], 4)]),
                          union([at([rotate(x, 180)], 6),
                                 at([translate(4, 0, -8.2)], 3),
                                 at([translate(-4, 0, -8.2)], 3)])]))).

view(300, 62, 0).
