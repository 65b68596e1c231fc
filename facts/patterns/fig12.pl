% Figure 12: a hollow cylinder. In the paper its pattern lies on itself; here a
% new piece begins where it would.
%
%     sanggwan unfold facts/patterns/fig12.pl -o fig12.svg
%
% Source: H.-C. Chae and I.-S. Chung, Constructing the Development of Solids by
%         Personal Computer, KSME Journal, 1989, Fig. 12; sizes chosen.
% Units:  millimetres, right-handed; polygons counter-clockwise from outside.

segment(1, solid, hollow_cylinder(radius(30), inner(18), height(50),
                                  facets(24))).

view(300, 62, 0).
