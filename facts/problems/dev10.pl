% An oblique cone. Source: figure 10 of the second paper named in collection.pl;
% sizes made up, millimetres.
param(e, 25).
segment(1, solid, cone(radius(30), height(60), shift(param(e), 0),
                       facets(96))).
unfolding(1, removed(base)).
