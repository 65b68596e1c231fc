% Figure 10: an oblique cone.
%
%     sanggwan unfold facts/patterns/fig10.pl -o fig10.svg
%
% Source: H.-C. Chae and I.-S. Chung, Constructing the Development of Solids by
%         Personal Computer, KSME Journal, 1989, Fig. 10; sizes chosen.
% Units:  millimetres, right-handed; polygons counter-clockwise from outside.

segment(1, solid, cone(radius(30), height(60), shift(25, 0), facets(32))).

view(300, 62, 0).
