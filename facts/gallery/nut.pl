% A hexagon nut. The cones that round its corners meet its sides in hyperbolas:
% every drawing class has to find them.
%
% Source: proportions of a nut M20.
% Units:  millimetres, right-handed.

segment(1, solid, at([translate(0, 0, -8)],
                     cylinder(radius(17.32), height(16), facets(6)))).
segment(2, solid, at([translate(0, 0, -8)],
                     cone(radius(41.96), height(24.227), facets(192)))).
segment(3, solid, at([translate(0, 0, -9)],
                     cylinder(radius(8.75), height(18), facets(96)))).
segment(4, solid, at([translate(0, 0, 6.7)],
                     cone(radius(8.75), top(10.4), height(1.65), facets(96)))).
segment(5, solid,
        named(nut,
              difference([intersection([1, 2, at([mirror(z)], 2)]),
                          3, 4, at([mirror(z)], 4)]))).

view(285, 60, 0).
