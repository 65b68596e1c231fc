% Everything in one model: a cylinder and a ring round it of another material, a
% sheet through both, and a line. The sheet is given in two parts, which end at
% the line. Cells of two materials, laminar faces, wires.
%
% Source: S.-H. Park, A Study on Geometrical Glue Operation between Non-manifold
%         Models, 1996, Fig. 1; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, solid, cylinder(radius(1), height(2), facets(12))).
segment(2, solid,
        hollow_cylinder(radius(1.5), inner(1), height(2), facets(12))).
segment(3, surface, at([translate(-1, 0, 0), rotate(x, 90), translate(0, 0, 1)],
                       rectangle(size(2, 3)))).
segment(4, surface, at([translate(1, 0, 0), rotate(x, 90), translate(0, 0, 1)],
                       rectangle(size(2, 3)))).
segment(5, curve, line(from(0, 0, -1), to(0, 0, 3))).
segment(6, cells, glue([1, 2, 3, 4, 5])).

view(300, 60, 0).
