% Three pipes and the two brackets that carry them. Pipe 3 joins the other two:
% where pipes meet they are to be cut. What a rule file can say about the rest
% is in docs/rules.md.
%
% Source: made for this file.
% Units:  model units, right-handed; polygons counter-clockwise from outside.

segment(1, solid, named(pipe(1),
    at([rotate(y, 90), translate(-4, -1.5, 2)],
       cylinder(radius(0.7), height(8), facets(32))))).
segment(2, solid, named(pipe(2),
    at([rotate(y, 90), translate(-4, 1.5, 2)],
       cylinder(radius(0.7), height(8), facets(32))))).
segment(3, solid, named(pipe(3),
    at([rotate(x, -90), translate(0, -1.5, 2)],
       cylinder(radius(0.5), height(3), facets(32))))).
segment(4, solid, named(bracket(1),
    at([translate(-2.5, 0, 0)], box(size(0.5, 5.6, 2.5))))).
segment(5, solid, named(bracket(2),
    at([translate(2.5, 0, 0)], box(size(0.5, 5.6, 2.5))))).

view(310, 60, 0).
