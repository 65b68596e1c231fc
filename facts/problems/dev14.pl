% A sphere as a polyhedron whose longer edges lie along the parallels. Source:
% figure 14 of the second paper named in collection.pl; sizes made up,
% millimetres.
param(r, 30).
segment(1, solid, sphere(radius(param(r)), facets(12), bands(16))).
