/* A board with a ring, a bar and a ball let into it, flush with its top but for
   the ball (docs/rules.md). Millimetres, right-handed, faces counter-clockwise
   from outside. */

segment(1, solid, named(board, union([2,3,4,5]))).
segment(2, solid, box(size(120, 80, 12))).
segment(3, solid, named(inlay, at([translate(-20,0,8)],
                                  hollow_cylinder(radius(28), inner(20),
                                                  height(4))))).
segment(4, solid, named(inlay, at([translate(18,0,8)], box(size(60,10,4))))).
segment(5, solid, at([translate(-20,0,12)], sphere(radius(12)))).
look(2, colour(rgb(176,128,80))).
look(3, colour(rgb(250,220,140))).
look(4, colour(rgb(90,50,30))).
look(5, colour(rgb(190,196,204))).
