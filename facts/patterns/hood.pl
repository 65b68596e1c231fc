% A hood of sheet metal, open below, with a corner cut off and a hole in one
% side: it is not its own mirror image.
%
% Source: made up.
% Units:  millimetres, right-handed; z is up.
%
%     sanggwan unfold facts/patterns/hood.pl --mirror -o both_hands.dxf
%     sanggwan unfold facts/patterns/hood.pl --kerf 0.2 -o laser.dxf

segment(1, solid,
        prism(outline([[0,0],[80,0],[80,35],[55,60],[0,60]]), height(30))).
segment(2, solid, at([rotate(x, 90), translate(25, 20, 15)],
                     cylinder(radius(8), height(40), facets(48)))).
segment(3, solid, named(hood, difference([1,2]))).

% Of the hole only its rim is wanted.
unfolding(3, removed([1/base, 2/base, 2/side])).
