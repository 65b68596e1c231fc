% What three equal cylinders at right angles have in common: a solid of twelve
% faces, known to Archimedes and to Zu Chongzhi.
%
% Source: a classic.
% Units:  model units, right-handed.

segment(1, solid, at([translate(0, 0, -2)],
                     cylinder(radius(1), height(4), facets(96)))).
segment(2, solid, named(common, intersection([1, at([rotate(x, 90)], 1),
                                              at([rotate(y, 90)], 1)]))).

view(300, 62, 0).
