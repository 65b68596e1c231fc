% Figure 15: two equal cylinders of 40 facets that cross at right angles, each
% laid out without its part inside the other.
%
%     sanggwan unfold facts/patterns/fig15.pl --trim outside -o fig15.svg
%
% Source: H.-C. Chae and I.-S. Chung, Constructing the Development of Solids by
%         Personal Computer, KSME Journal, 1989, Fig. 15; sizes chosen.
% Units:  millimetres, right-handed; polygons counter-clockwise from outside.

segment(1, solid, named(upright, at([translate(0, 0, -60)],
                     cylinder(radius(25), height(120), facets(40))))).
segment(2, solid, named(lying, at([translate(0, 0, -60), rotate(y, 90)],
                     cylinder(radius(25), height(120), facets(40))))).

view(312, 68, 0).
