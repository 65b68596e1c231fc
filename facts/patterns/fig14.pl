% Figure 14: a sphere whose edges along the equator are the longer ones, so it
% comes apart in gores.
%
%     sanggwan unfold facts/patterns/fig14.pl -o fig14.svg
%
% Source: H.-C. Chae and I.-S. Chung, Constructing the Development of Solids by
%         Personal Computer, KSME Journal, 1989, Fig. 14; sizes and facets
%         chosen.
% Units:  millimetres, right-handed; polygons counter-clockwise from outside.

segment(1, solid, sphere(radius(40), facets(12), bands(16))).

view(300, 62, 0).
