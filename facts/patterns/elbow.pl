% A bend of four parts, each to be cut from sheet:
%
%     sanggwan unfold facts/patterns/elbow.pl --trim outside -o elbow.svg
%
% Where parts meet, faces look at each other: trimming takes both away, so the
% patterns are open there. The ends of the bend are left out.
%
% Source: made up; facts/gallery/elbow.pl as one solid.
% Units:  millimetres, right-handed; the bend is about the y axis, 150 from it.

% A gore between two joints 30 degrees apart, its middle on the x axis.
segment(1, solid, at([translate(150, 0, -100)],
                     cylinder(radius(50), height(200), facets(32)))).
segment(2, solid,
        split(split(1, plane(-0.25881904510252074, 0, 0.9659258262890683, 0),
                    below),
              plane(0.25881904510252074, 0, 0.9659258262890683, 0), above)).

% Half a gore, and the pipe that goes on from it.
segment(3, solid,
        split(at([translate(150, 0, -140)],
                 cylinder(radius(50), height(240), facets(32))),
              plane(-0.25881904510252074, 0, 0.9659258262890683, 0), below)).

segment(4, solid, named(start, at([], 3))).
segment(5, solid, named(gore_1, at([rotate(y, -30)], 2))).
segment(6, solid, named(gore_2, at([rotate(y, -60)], 2))).
segment(7, solid, named(end, at([mirror(z), rotate(y, -90)], 3))).

unfolding(4, removed(1)).
unfolding(7, removed(1)).

view(330, 70, 0).
