% Figure 9: four squares that go through one another. They are surfaces: seen
% from both sides, with borders. Three of them stand square to the axes and
% meet in a point; the fourth is turned and cuts them all.
%
% Source: H.-C. Chae, Drawing of Penetrating Lines Using Personal Computer,
%         KSME Journal 12(1), 1988, Fig. 9; sizes chosen for this file.
% Units:  model units, right-handed.

segment(1, surface, rectangle(size(2, 2))).
segment(2, surface, at([rotate(x, 90), translate(0, 0.25, 0.1)],
                       rectangle(size(2, 2)))).
segment(3, surface, at([rotate(y, 90), translate(-0.25, 0, 0.1)],
                       rectangle(size(2, 2)))).
segment(4, surface, at([rotate(x, 35), rotate(z, 25),
                        translate(0.2, -0.1, 0.2)],
                       rectangle(size(2, 2)))).

view(305, 62, 20).
projection(parallel).
