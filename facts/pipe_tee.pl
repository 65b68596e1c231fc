% A pipe tee with three flanges, each with six bolt holes: a CSG tree. Nodes are
% segments whose term is an operation; an operand is the number of a segment, a
% primitive, an operation, or one of these placed by at/2. The segment that is
% no operand, 10, is the model.
%
% Source: made up.
% Units:  model units, right-handed.

segment(1, solid, cylinder(radius(1), height(6), facets(48))).        % pipe
segment(2, solid, cylinder(radius(0.75), height(7), facets(48))).     % bore
segment(3, solid, cylinder(radius(0.15), height(1), facets(16))).     % bolt
segment(4, solid, at([translate(1.35, 0, -0.5)], 3)).

% The flange, in place at the end of the branch.
segment(5, solid, named(bolts, union([4, at([rotate(z, 60)], 4),
                                      at([rotate(z, 120)], 4),
                                      at([rotate(z, 180)], 4),
                                      at([rotate(z, 240)], 4),
                                      at([rotate(z, 300)], 4)]))).
segment(6, solid,
        named(flange,
              at([translate(0, 0, 2.7)],
                 difference([cylinder(radius(1.7), height(0.3), facets(64)),
                             5])))).

% Run and branch: outside and inside.
segment(7, solid, at([translate(0, 0, -3), rotate(y, 90)], 1)).
segment(8, solid,
        named(outside,
              union([7, cylinder(radius(1), height(2.9), facets(48)), 6,
                     at([rotate(y, 90)], 6), at([rotate(y, -90)], 6)]))).
segment(9, solid,
        named(inside, union([at([translate(0, 0, -3.5), rotate(y, 90)], 2),
                             2]))).
segment(10, solid, named(tee, difference([8, 9]))).

view(300, 62, 0).
