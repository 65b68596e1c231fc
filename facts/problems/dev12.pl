% A hollow cylinder. Source: figure 12 of the second paper named in
% collection.pl; sizes made up, millimetres.
param(r, 18).
segment(1, solid, hollow_cylinder(radius(30), inner(param(r)), height(50),
                                  facets(96))).
