% Winding stairs round a newel, seen from where somebody stands.
%
% Source: made up.
% Units:  metres, right-handed; z is up.

segment(1, solid, cylinder(radius(0.18), height(3.6), facets(48))).
segment(2, solid, prism(outline([[0,-0.09], [1.15,-0.28], [1.15,0.28],
                                 [0,0.09]]), height(0.07))).
segment(3, solid, named(four, join([2,
    at([rotate(z, 25), translate(0, 0, 0.19)], 2),
    at([rotate(z, 50), translate(0, 0, 0.38)], 2),
    at([rotate(z, 75), translate(0, 0, 0.57)], 2)]))).
segment(4, solid, named(stairs, union([1,
    at([translate(0, 0, 0.12)], 3),
    at([rotate(z, 100), translate(0, 0, 0.88)], 3),
    at([rotate(z, 200), translate(0, 0, 1.64)], 3),
    at([rotate(z, 300), translate(0, 0, 2.40)], 3)]))).
