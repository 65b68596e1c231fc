% Figure 2 of K.-H. Park and C.-M. Kyung, Design and Display of Solids Using
% CSG and Boundary Representation, 1989: how a polygon is divided. (a) Two
% segments of intersection, each with an end inside, wait in its list; (b) a
% third one links them, from border to border; (c) so there are two polygons,
% here moved apart. Sizes are chosen. Millimetres, z up, right-handed.
segment(1, surface, rectangle(size(44,30))).
segment(2, surface, at([rotate(x,90), translate(-16,5,0)],
                       rectangle(size(20,16)))).
segment(3, surface, at([rotate(x,90), translate(16,-5,0)],
                       rectangle(size(20,16)))).

segment(4, surface, at([translate(66,0,0)], rectangle(size(44,30)))).
segment(5, surface, at([translate(66,0,0)],
    sheet(points([[-26,5,-8],[-6,5,-8],[6,-5,-8],[26,-5,-8],
                  [-26,5,8],[-6,5,8],[6,-5,8],[26,-5,8]]),
          faces([[1,2,6,5],[2,3,7,6],[3,4,8,7]])))).

segment(6, surface, at([translate(132,4,0)],
    sheet(points([[-22,15,0],[-22,5,0],[-6,5,0],[6,-5,0],[22,-5,0],
                  [22,15,0]]),
          faces([[1,2,3,4,5,6]])))).
segment(7, surface, at([translate(132,-4,0)],
    sheet(points([[-22,5,0],[-22,-15,0],[22,-15,0],[22,-5,0],[6,-5,0],
                  [-6,5,0]]),
          faces([[1,2,3,4,5,6]])))).
look(1, colour(rgb(170,190,210))).
look(4, colour(rgb(170,190,210))).
look(6, colour(rgb(170,190,210))).
look(7, colour(rgb(130,170,110))).
look(2, colour(rgb(220,140,60))).
look(3, colour(rgb(220,140,60))).
look(5, colour(rgb(220,140,60))).
view(280, 38, 0).
