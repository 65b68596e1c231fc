% Mixed glue: a pyramid that stands on the edge of a box with its apex, one in
% the middle of the face, and a roof that stands on its ridge.
%
% Source: S.-H. Park, A Study on Geometrical Glue Operation between Non-manifold
%         Models, 1996, Fig. 8; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, solid, box(size(8, 8, 1))).
segment(2, solid, at([mirror(z), translate(4, 1, 2)],
                     pyramid(base(1, 1), height(1)))).
segment(3, solid, at([mirror(z), translate(2, -2.5, 2)],
                     pyramid(base(1, 1), height(1)))).
segment(4, solid, polyhedron(points([[-3, 0, 1], [0, 0, 1], [-3, -1, 2],
                                     [0, -1, 2], [0, 1, 2], [-3, 1, 2]]),
                             faces([[3, 4, 5, 6], [1, 2, 4, 3], [2, 1, 6, 5],
                                    [1, 3, 6], [2, 5, 4]]))).
segment(5, cells, glue([1, 2, 3, 4])).

view(300, 60, 0).
