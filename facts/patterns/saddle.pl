% A branch pipe on a header, askew and off its axis: for
%
%     sanggwan unfold facts/patterns/saddle.pl --trim outside -o saddle.svg
%
% the saddle end of the branch and the hole of the header. Pipes are drawn as
% bars; their ends are left out of the patterns.
%
% Source: made up.
% Units:  millimetres, right-handed; the header lies along x.

segment(1, solid, named(header, at([rotate(y, 90), translate(-130, 0, 0)],
                                   cylinder(radius(57), height(260),
                                            facets(48))))).
segment(2, solid, named(branch, at([rotate(y, 35), translate(0, 14, 0)],
                                   cylinder(radius(38), height(170),
                                            facets(48))))).

% The header is welded opposite the hole.
unfolding(1, removed([base, top])).
unfolding(1, cut(curved(side, [352.5-360]) - curved(side, [0-7.5]))).
unfolding(2, removed([base, top])).

view(300, 62, 0).
