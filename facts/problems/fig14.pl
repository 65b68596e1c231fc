% Two cylinders whose axes do not meet. Source: figure 14 of the paper named in
% collection.pl; sizes made up, millimetres.
param(e, 14).
segment(1, solid, at([translate(0, 0, -60)],
                     cylinder(radius(36), height(120), facets(96)))).
segment(2, solid, at([translate(0, 0, -60), rotate(y, 90),
                      translate(0, -param(e), 0)],
                     cylinder(radius(24), height(120), facets(96)))).
unfolding(1, removed([base, top])).
unfolding(2, removed([base, top])).
