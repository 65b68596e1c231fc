% A branch pipe that meets a header askew and off its axis: the line along which
% a fitter cuts the saddle. Both are solid bars, as pattern makers draw pipes.
%
% Source: made up.
% Units:  millimetres, right-handed; the header lies along x.

segment(1, solid, named(header, at([rotate(y, 90), translate(-130, 0, 0)],
                                   cylinder(radius(57), height(260),
                                            facets(96))))).
segment(2, solid, named(branch, at([rotate(y, 35), translate(0, 14, 0)],
                                   cylinder(radius(38), height(170),
                                            facets(96))))).

view(300, 62, 0).
