% Vertex glue: three pyramids with one apex, one of them in another, and a wire.
%
% Source: S.-H. Park, A Study on Geometrical Glue Operation between Non-manifold
%         Models, 1996, Fig. 4; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, solid, polyhedron(points([[0, 0, 0], [-4, -1, -1], [-4, 1, -1],
                                     [-4, 1, 1], [-4, -1, 1]]),
                             faces([[1, 2, 3], [1, 3, 4], [1, 4, 5], [1, 5, 2],
                                    [5, 4, 3, 2]]))).
segment(2, solid, polyhedron(points([[0, 0, 0], [-1, -1, 3], [1, -1, 3],
                                     [1, 1, 3], [-1, 1, 3]]),
                             faces([[1, 3, 2], [1, 4, 3], [1, 5, 4], [1, 2, 5],
                                    [2, 3, 4, 5]]))).
segment(3, solid, polyhedron(points([[0, 0, 0], [-4, -4, 6], [4, -4, 6],
                                     [4, 4, 6], [-4, 4, 6]]),
                             faces([[1, 3, 2], [1, 4, 3], [1, 5, 4], [1, 2, 5],
                                    [2, 3, 4, 5]]))).
segment(4, curve, line(from(0, 0, 0), to(0, 0, -3))).
segment(5, cells, glue([1, 2, 3, 4])).

view(300, 70, 0).
