% Figure 13: a sphere whose edges along the meridians are the longer ones, so it
% comes apart in bands.
%
%     sanggwan unfold facts/patterns/fig13.pl -o fig13.svg
%
% Source: H.-C. Chae and I.-S. Chung, Constructing the Development of Solids by
%         Personal Computer, KSME Journal, 1989, Fig. 13; sizes and facets
%         chosen.
% Units:  millimetres, right-handed; polygons counter-clockwise from outside.

segment(1, solid, sphere(radius(40), facets(24), bands(8))).

view(300, 62, 0).
