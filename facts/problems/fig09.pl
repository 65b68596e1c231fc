% Two squares that go through each other, one of them upright. Source: figure 9
% of the paper named in collection.pl; sizes made up, millimetres.
param(a, 35).
segment(1, surface, at([rotate(x, 20)], rectangle(size(80, 80)))).
segment(2, surface, at([rotate(x, 90), rotate(z, param(a)), translate(6, 4, 8)],
                       rectangle(size(80, 70)))).
