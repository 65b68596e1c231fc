% From a rectangular duct to a round pipe. It is welded in the middle of a side.
%
%     sanggwan unfold facts/fittings/square_to_round.pl --set d=250 -o duct.pdf
%
% Units: millimetres, right-handed; z is up. Sizes are outside.

param(a, 300).                  % the duct along x
param(b, 200).                  % the duct along y
param(d, 160).                  % diameter of the pipe
param(h, 150).                  % height
param(x, 0).                    % how far the pipe is moved to +x
param(y, 0).                    % how far the pipe is moved to +y
param(t, 2).                    % thickness of the plate

param_about(a, [ min(1),
                 text(en, 'the duct along x'),
                 text(ko, '덕트의 x 방향 너비') ]).
param_about(b, [ min(1),
                 text(en, 'the duct along y'),
                 text(ko, '덕트의 y 방향 너비') ]).
param_about(d, [ min(1),
                 text(en, 'diameter of the pipe'),
                 text(ko, '관의 지름') ]).
param_about(h, [ min(1),
                 text(en, 'height'),
                 text(ko, '높이') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of the plate'),
                 text(ko, '판의 두께') ]).

segment(1, solid,
        named(square_to_round,
              transition(base(rectangle(param(a), param(b))),
                         top(circle(param(d)/2)), height(param(h)),
                         shift(param(x), param(y)), facets(96)))).

unfolding(1, removed([base, top])).
unfolding(1, true_lengths).
unfolding(1, thickness(param(t))).
unfolding(1, size(outside)).
unfolding(1, generators(16)).

view(300, 62, 0).
