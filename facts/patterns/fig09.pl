% Figure 9: a hexahedron.
%
%     sanggwan unfold facts/patterns/fig09.pl -o fig09.svg
%
% Source: H.-C. Chae and I.-S. Chung, Constructing the Development of Solids by
%         Personal Computer, KSME Journal, 1989, Fig. 9; sizes chosen.
% Units:  millimetres, right-handed; polygons counter-clockwise from outside.

segment(1, solid, box(size(60, 40, 30))).

view(300, 60, 0).
