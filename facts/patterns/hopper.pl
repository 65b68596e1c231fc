% A hopper: a shell on a cone, open at both ends.
%
%     sanggwan unfold facts/patterns/hopper.pl -o hopper.svg
%
% docs/rules.md says where its seams go, and how to have them elsewhere.
%
% Source: made up.
% Units:  millimetres, right-handed; the front looks along y.

segment(1, solid, named(hopper, turning(outline([[0,0], [10,0], [40,50],
                                                 [40,110], [0,110]]),
                                        facets(24)))).
unfolding(1, removed([ring(1), ring(4)])).

view(300, 62, 0).
