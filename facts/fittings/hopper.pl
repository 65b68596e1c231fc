% A hopper of one plate: from a rectangular opening down to a smaller one. It is
% welded in the middle of a side and bent at the corners.
%
%     sanggwan unfold facts/fittings/hopper.pl --set a=800 --set h=500 \
%         -o hopper.pdf
%
% Units: millimetres, right-handed; z is up. Sizes are outside.

param(a, 600).                  % the opening along x
param(b, 500).                  % the opening along y
param(c, 200).                  % the outlet along x
param(d, 150).                  % the outlet along y
param(h, 400).                  % height
param(x, 0).                    % how far the opening is moved to +x
param(t, 2).                    % thickness of the plate
param(r, 2).                    % radius inside the bends

param_about(a, [ min(1),
                 text(en, 'the opening along x'),
                 text(ko, '입구의 x 방향 너비') ]).
param_about(b, [ min(1),
                 text(en, 'the opening along y'),
                 text(ko, '입구의 y 방향 너비') ]).
param_about(c, [ min(1),
                 text(en, 'the outlet along x'),
                 text(ko, '출구의 x 방향 너비') ]).
param_about(d, [ min(1),
                 text(en, 'the outlet along y'),
                 text(ko, '출구의 y 방향 너비') ]).
param_about(h, [ min(1),
                 text(en, 'height'),
                 text(ko, '높이') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of the plate'),
                 text(ko, '판의 두께') ]).
param_about(r, [ min(0),
                 text(en, 'radius inside the bends'),
                 text(ko, '굽힘 안쪽 반지름') ]).

segment(1, solid,
        named(hopper, transition(base(rectangle(param(c), param(d))),
                                 top(rectangle(param(a), param(b))),
                                 height(param(h)), shift(param(x), 0)))).

unfolding(1, removed([base, top])).
unfolding(1, true_lengths).
unfolding(1, thickness(param(t))).
unfolding(1, bend_radius(param(r))).
unfolding(1, size(outside)).

view(300, 62, 0).
