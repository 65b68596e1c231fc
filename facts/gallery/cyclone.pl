% A cyclone of sheet metal: barrel, cone, dust pipe, outlet, and an inlet that
% touches the barrel.
%
% Source: made up.
% Units:  millimetres, right-handed; z is up.

segment(1, solid, named(barrel, cylinder(radius(150), height(260),
                                         facets(96)))).
segment(2, solid, named(cone, at([mirror(z)],
                                 cone(radius(150), top(45), height(330),
                                      facets(96))))).
segment(3, solid, named(dust_pipe, at([translate(0, 0, -420)],
                                      cylinder(radius(45), height(90),
                                               facets(96))))).
segment(4, solid, named(inlet, at([translate(-160, 110, 115)],
                                  box(size(320, 80, 130))))).
segment(5, solid, named(outlet, at([translate(0, 0, 120)],
                                   cylinder(radius(70), height(230),
                                            facets(96))))).
segment(6, solid, named(cyclone, union([1, 2, 3, 4, 5]))).

view(300, 66, 0).
