% Figure 5 of K.-H. Park and C.-M. Kyung, Design and Display of Solids Using CSG
% and Boundary Representation, 1989: A = B - C. Of C those faces are seen in A
% that were its back: they look towards the eye. Sizes are chosen. Millimetres,
% z up; right-handed, faces counter-clockwise from outside.
segment(1, solid, named(b, box(size(80,50,30)))).
segment(2, solid, named(c, at([rotate(z,20), translate(12,-28,-5)],
                              box(size(36,40,50))))).
segment(3, solid, named(a, difference([1,2]))).
look(1, colour(rgb(170,190,210))).
look(2, colour(rgb(220,140,60))).
view(285, 65, 0).
