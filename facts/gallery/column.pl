% Twisted columns: a star prism that turns and grows thin, on a base.
%
% Source: made up.
% Units:  model units, right-handed; z is up.

segment(1, solid, at([translate(0, 0, 0.6)],
                     prism(outline([[2,0], [1.3,0.54], [1.41,1.41],
                                    [0.54,1.3], [0,2], [-0.54,1.3],
                                    [-1.41,1.41], [-1.3,0.54], [-2,0],
                                    [-1.3,-0.54], [-1.41,-1.41],
                                    [-0.54,-1.3], [0,-2], [0.54,-1.3],
                                    [1.41,-1.41], [1.3,-0.54]]),
                           height(8), twist(120), scale(0.55), slices(64)))).
segment(2, solid, cylinder(radius(2.4), height(0.6), facets(8))).
segment(3, solid, at([translate(0, 0, 8.6)],
                     sphere(radius(1.1), facets(48), bands(24)))).
segment(4, solid, named(column, union([1, 2, 3]))).

view(300, 70, 0).
