% The three cycles of what is no manifold: what hangs together round a vertex,
% a cube, another one and a wire; three pages round an edge; and the two loops
% of a face with a hole.
%
% Source: S.-H. Park, A Study on Geometrical Glue Operation between Non-manifold
%         Models, 1996, Fig. 2; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, solid, box(size(1, 1, 1))).
segment(2, solid, at([translate(1, 1, 1)], box(size(1, 1, 1)))).
segment(3, curve, line(from(0.5, 0.5, 1), to(-0.2, 1.1, 2))).
segment(4, surface, sheet(points([[4,0,0],[4,0,2],[5.2,0,0],[5.2,0,2]]),
                        faces([[1,3,4,2]]))).
segment(5, surface, sheet(points([[4,0,0],[4,0,2],[3.6,1.1,0],[3.6,1.1,2]]),
                        faces([[1,3,4,2]]))).
segment(6, surface, sheet(points([[4,0,0],[4,0,2],[3.4,-1,0],[3.4,-1,2]]),
                        faces([[1,3,4,2]]))).
segment(7, solid, at([translate(8, 0, 0)],
    prism(outline([[-1.2,-1.2], [1.2,-1.2], [1.2,1.2], [-1.2,1.2]]),
          holes([[[-0.5,-0.5], [0.5,-0.5], [0.5,0.5], [-0.5,0.5]]]),
          height(0.4)))).
segment(8, cells, glue([1, 2, 3, 4, 5, 6, 7])).

view(300, 60, 0).
