% An upright cylinder and a lying one that is as large: half a tee. Source:
% figure 15 of the second paper named in collection.pl; sizes made up,
% millimetres.
param(r, 25).
segment(1, solid, at([rotate(y, 90), translate(-60, 0, 0)],
                     cylinder(radius(param(r)), height(120), facets(96)))).
segment(2, solid, cylinder(radius(param(r)), height(75), facets(96))).
unfolding(1, removed([base, top])).
unfolding(2, removed([base, top])).
