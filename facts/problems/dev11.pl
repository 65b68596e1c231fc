% An oblique cylinder on an ellipse. Source: figure 11 of the second paper named
% in collection.pl; sizes made up, millimetres.
param(e, 25).
segment(1, solid, cylinder(radius(30.0, 18.0), height(60), shift(param(e), 0),
                           facets(96))).
unfolding(1, removed([base, top])).
