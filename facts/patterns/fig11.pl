% Figure 11: an oblique cylinder on an ellipse.
%
%     sanggwan unfold facts/patterns/fig11.pl -o fig11.svg
%
% Source: H.-C. Chae and I.-S. Chung, Constructing the Development of Solids by
%         Personal Computer, KSME Journal, 1989, Fig. 11; sizes chosen.
% Units:  millimetres, right-handed; polygons counter-clockwise from outside.

segment(1, solid, cylinder(radius(30.0, 18.0), height(60), shift(25, 0),
                           facets(32))).

view(300, 62, 0).
