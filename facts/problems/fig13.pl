% Two equal cylinders at right angles. Source: figure 13 of the paper named in
% collection.pl; sizes made up, millimetres.
param(r, 28).
segment(1, solid, at([translate(0, 0, -60)],
                     cylinder(radius(param(r)), height(120), facets(96)))).
segment(2, solid, at([translate(0, 0, -60), rotate(y, 90)],
                     cylinder(radius(param(r)), height(120), facets(96)))).
unfolding(1, removed([base, top])).
unfolding(2, removed([base, top])).
