% A solid of boxes, cylinders, a cone and spheres: a block with a bored boss
% on a cone, four pins with balls, a cross bore and a notch. Like the solid of
% figures 7 and 8 of K.-H. Park and C.-M. Kyung, Design and Display of Solids
% Using CSG and Boundary Representation, 1989; the paper does not give its
% sizes. Units: cm; z is up.
segment(1, solid, named(block, union([
    difference([
        union([
            box(size(8,5,1)),
            at([translate(0,0,1)],
               cone(radius(2.2), top(1.5), height(1), facets(96))),
            at([translate(0,0,2)],
               cylinder(radius(1.5), height(1.6), facets(96)))
        ]),
        at([translate(0,0,-1)],
           cylinder(radius(0.9), height(6), facets(96))),
        at([rotate(y,90),translate(-5,0,2.8)],
           cylinder(radius(0.45), height(10), facets(48))),
        at([translate(0,-2.5,-0.5)], box(size(2.4,1.2,1)))
    ]),
    at([translate(3.1,1.7,1)], 2),
    at([translate(-3.1,1.7,1)], 2),
    at([translate(-3.1,-1.7,1)], 2),
    at([translate(3.1,-1.7,1)], 2)
]))).
segment(2, solid, named(pin, union([
    cylinder(radius(0.35), height(1.2), facets(48)),
    at([translate(0,0,1.3)], sphere(radius(0.55), facets(48), bands(24)))
]))).
look(1, colour(rgb(170,190,210))).
view(300, 60, 0).
