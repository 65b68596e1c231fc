% A sphere as a polyhedron whose longer edges lie along the meridians. Source:
% figure 13 of the second paper named in collection.pl; sizes made up,
% millimetres.
param(r, 30).
segment(1, solid, sphere(radius(param(r)), facets(24), bands(8))).
