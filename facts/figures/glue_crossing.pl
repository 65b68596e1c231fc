% Two pyramids with one apex that go through each other: where one plane fails
% to say how they lie. What crosses is cut first.
%
% Source: S.-H. Park, A Study on Geometrical Glue Operation between Non-manifold
%         Models, 1996, Fig. 5; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, solid, polyhedron(points([[0, 0, 0], [10, -1, -10], [10, 1, -10],
                                     [10, 1, 10], [10, -1, 10]]),
                             faces([[1, 3, 2], [1, 4, 3], [1, 5, 4], [1, 2, 5],
                                    [2, 3, 4, 5]]))).
segment(2, solid, polyhedron(points([[0, 0, 0], [10, -10, -1], [10, 10, -1],
                                     [10, 10, 1], [10, -10, 1]]),
                             faces([[1, 3, 2], [1, 4, 3], [1, 5, 4], [1, 2, 5],
                                    [2, 3, 4, 5]]))).
segment(3, cells, glue([1, 2])).

view(30, 70, 0).
