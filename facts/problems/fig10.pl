% A pyramid through a pyramid. Source: figure 10 of the paper named in
% collection.pl; sizes made up, millimetres.
param(a, 40).
segment(1, solid, pyramid(base(80, 80), height(100))).
segment(2, solid, at([rotate(z, 45), rotate(y, 90), translate(-64, 4, 32)],
                     pyramid(base(param(a), param(a)), height(128)))).
