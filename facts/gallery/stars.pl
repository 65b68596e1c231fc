% Star bodies for paper models: two tetrahedra (Kepler's stella octangula), and
% a cube with an octahedron. Nothing is united: the lines where the faces go
% through one another are the folds.
%
% Source: a classic.
% Units:  model units, right-handed.

segment(1, solid, polyhedron(points([[1,1,1], [1,-1,-1], [-1,1,-1],
                                     [-1,-1,1]]),
                             faces([[1,2,3], [1,3,4], [1,4,2], [2,4,3]]))).
segment(2, solid, polyhedron(points([[-1,-1,-1], [-1,1,1], [1,-1,1],
                                     [1,1,-1]]),
                             faces([[1,3,2], [1,4,3], [1,2,4], [2,3,4]]))).
segment(3, solid, at([translate(4.2, 0, -1)], box(size(2, 2, 2)))).
segment(4, solid, polyhedron(points([[6.2,0,0], [4.2,2,0], [2.2,0,0],
                                     [4.2,-2,0], [4.2,0,2], [4.2,0,-2]]),
                             faces([[1,2,5], [2,3,5], [3,4,5], [4,1,5],
                                    [2,1,6], [3,2,6], [4,3,6], [1,4,6]]))).

view(285, 68, 0).
