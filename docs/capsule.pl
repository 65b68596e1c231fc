% A cylinder with a ball at one end, tangent to it (docs/rules.md). Millimetres,
% right-handed, faces counter-clockwise from outside.

segment(1, solid, union([cylinder(radius(10), height(30)),
                         at([translate(0,0,30)], sphere(radius(10)))])).
