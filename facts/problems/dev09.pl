% A box. Source: figure 9 of the second paper named in collection.pl; sizes made
% up, millimetres.
param(h, 30).
segment(1, solid, box(size(60, 40, param(h)))).
