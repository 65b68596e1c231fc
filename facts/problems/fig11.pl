% A cone through a cone. Source: figure 11 of the paper named in collection.pl;
% sizes made up, millimetres.
param(r, 26).
segment(1, solid, cone(radius(45), height(105), facets(96))).
segment(2, solid, at([rotate(y, 90), translate(-64, 0, 34)],
                     cone(radius(param(r)), height(140), facets(96)))).
unfolding(2, removed(base)).
