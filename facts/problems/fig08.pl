% A straight line through a cone. Source: figure 8 of the paper named in
% collection.pl; sizes made up, millimetres.
param(h, 80).
segment(1, solid, cone(radius(40), height(param(h)), facets(96))).
segment(2, curve, line(from(-56, -20, 14), to(56, 12, 38))).
