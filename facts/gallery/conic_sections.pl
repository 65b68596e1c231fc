% A cone three times, and the planes that cut it in an ellipse, a parabola and a
% hyperbola.
%
% Source: every text book; the slope of the cone is 2 to 1.
% Units:  model units, right-handed; z is up.

segment(1, solid, cone(radius(3), height(6), facets(144))).
segment(2, solid, named(first, at([translate(-5.6, -5.6, 0)], 1))).
segment(3, solid, named(second, at([], 1))).
segment(4, solid, named(third, at([translate(5.6, 5.6, 0)], 1))).

segment(5, surface, named(ellipse, at([rotate(y, 25),
                                       translate(-5.6, -5.6, 3)],
                                      rectangle(size(5.4, 4.4))))).
segment(6, surface, named(parabola, at([rotate(y, 63.43494882292201),
                                        translate(1.2, 0, 1.9)],
                                       rectangle(size(5.4, 6.6))))).
segment(7, surface, named(hyperbola, at([rotate(y, 90),
                                         translate(6.6, 5.6, 2.2)],
                                        rectangle(size(5.4, 6.6))))).

view(315, 66, 0).
