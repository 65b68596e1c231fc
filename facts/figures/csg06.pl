% Figure 6 of K.-H. Park and C.-M. Kyung, Design and Display of Solids Using
% CSG and Boundary Representation, 1989: a free-form surface (one Bezier patch)
% and other primitives, united. A patch is open, so a union is all it may be in.
% The paper does not give sizes. Units: cm; z is up, right-handed.
segment(1, surface, bezier(facets(24), points([
    [-4,-3,0.6], [-1.4,-3,2.6], [1.4,-3,2.6], [4,-3,0.6],
    [-4,-1,1.6], [-1.4,-1,4.4], [1.4,-1,4.4], [4,-1,1.6],
    [-4,1,0.2],  [-1.4,1,2.0],  [1.4,1,2.0],  [4,1,0.2],
    [-4,3,0.8],  [-1.4,3,1.2],  [1.4,3,1.2],  [4,3,0.8]]))).
segment(2, solid, at([translate(-1.6,0.4,-1)],
                     cylinder(radius(0.9), height(5), facets(48)))).
segment(3, solid, at([translate(1.8,-0.6,2)],
                     sphere(radius(1.1), facets(48), bands(24)))).
segment(4, solid, at([translate(0,0,-1)], box(size(9,7,0.5)))).
segment(5, surface, named(free_form, union([1,2,3,4]))).
look(1, colour(rgb(170,190,210))).
look(2, colour(rgb(220,140,60))).
look(3, colour(rgb(130,170,110))).
look(4, colour(rgb(200,200,190))).
view(300, 60, 0).
