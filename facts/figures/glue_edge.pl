% Edge glue, in part: three pages on an edge and two on another one, which have
% the middle in common.
%
% Source: S.-H. Park, A Study on Geometrical Glue Operation between Non-manifold
%         Models, 1996, Fig. 6; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, surface, sheet(points([[0,0,0],[0,0,3],[2,0,0],[2,0,3]]),
                        faces([[1,3,4,2]]))).
segment(2, surface, sheet(points([[0,0,0],[0,0,3],[1,2,0],[1,2,3]]),
                        faces([[1,3,4,2]]))).
segment(3, surface, sheet(points([[0,0,0],[0,0,3],[-1,2,0],[-1,2,3]]),
                        faces([[1,3,4,2]]))).
segment(4, surface, sheet(points([[0,0,1],[0,0,4],[-2,-1,1],[-2,-1,4]]),
                        faces([[1,3,4,2]]))).
segment(5, surface, sheet(points([[0,0,1],[0,0,4],[1,-2,1],[1,-2,4]]),
                        faces([[1,3,4,2]]))).
segment(6, cells, glue([1, 2, 3, 4, 5])).

view(300, 60, 0).
