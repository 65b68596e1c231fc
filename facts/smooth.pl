% Smooth bodies, whose outlines run inside their triangles.
%
% Units: none in particular. Right-handed, z up.

% A torus: its outline has four cusps.
segment(1, solid, torus(radius(2), tube(0.8), facets(64), sides(40))).

% The same, cut open.
segment(2, solid, difference([
    at([translate(6.5, 0, 0)],
       torus(radius(2), tube(0.8), facets(64), sides(40))),
    at([translate(9, -2.5, -1)], box(size(5, 5, 2)))])).

% A ball with a bore, and one on a rod.
segment(3, solid, difference([
    at([translate(0, 7, 0)], sphere(radius(1.8), facets(56))),
    at([translate(0, 7, -3)], cylinder(radius(0.7), height(6), facets(48)))])).
segment(4, solid, union([
    at([translate(4.5, 7, 0)], sphere(radius(1.5), facets(56))),
    at([translate(4.5, 7, -2.2)], cylinder(radius(0.5), height(4.4),
                                           facets(40)))])).

% A vase, turned.
segment(5, solid, at([translate(9, 7, -2)],
    turning(outline([[0, 0], [0.9, 0], [1.2, 0.35], [1.42, 0.8], [1.5, 1.3],
                     [1.42, 1.8], [1.2, 2.25], [0.92, 2.65], [0.7, 3],
                     [0.6, 3.35], [0.66, 3.7], [0.85, 4], [0, 4]]),
            facets(56), smooth(true)))).
