% A cylinder through a cone. Source: figure 12 of the paper named in
% collection.pl; sizes made up, millimetres.
param(r, 16).
segment(1, solid, cone(radius(45), height(110), facets(96))).
segment(2, solid, at([rotate(y, 90), translate(-62, 0, 32)],
                     cylinder(radius(param(r)), height(124), facets(96)))).
unfolding(1, removed(base)).
unfolding(2, removed([base, top])).
