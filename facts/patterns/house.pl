% A house of cardboard: the floor in the middle, the roof in one piece.
%
% Source: made up.
% Units:  millimetres, right-handed; z is up.

segment(1, solid,
        named(house,
              polyhedron(points([[0, 0, 0], [80, 0, 0], [80, 60, 0],
                                 [0, 60, 0], [0, 0, 40], [80, 0, 40],
                                 [80, 60, 40], [0, 60, 40],
                                 [0, 30, 65], [80, 30, 65]]),
                         faces([[1, 4, 3, 2],           % floor
                                [1, 2, 6, 5],           % walls
                                [2, 3, 7, 10, 6],
                                [3, 4, 8, 7],
                                [4, 1, 5, 9, 8],
                                [5, 6, 10, 9],          % roof
                                [7, 8, 9, 10]])))).

unfolding(1, root(1)).
unfolding(1, keep(1-2)).
unfolding(1, keep(1-3)).
unfolding(1, keep(1-4)).
unfolding(1, keep(1-5)).
unfolding(1, keep(6-7)).

view(300, 62, 0).
