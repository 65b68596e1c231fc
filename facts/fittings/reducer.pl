% A reducer from one diameter to another; eccentric, if e is not 0: with e =
% (d-d2)/2 one side stands upright.
%
%     sanggwan unfold facts/fittings/reducer.pl --set d2=88.9 -o reducer.pdf
%
% Units: millimetres, right-handed; z is up.

param(d, 168.3).                % outside diameter at the base
param(d2, 114.3).               % outside diameter at the top
param(h, 140).                  % height
param(e, 0).                    % how far the top is moved to +x
param(t, 4).                    % thickness of the plate
param(seam, 0).                 % degrees: 0 is the side to +x

param_about(d, [ min(1),
                 text(en, 'outside diameter at the base'),
                 text(ko, '아래 바깥지름') ]).
param_about(d2, [ min(1),
                  text(en, 'outside diameter at the top'),
                  text(ko, '위 바깥지름') ]).
param_about(h, [ min(1),
                 text(en, 'height'),
                 text(ko, '높이') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of the plate'),
                 text(ko, '판의 두께') ]).
param_about(seam, [ min(-360), max(360),
                    text(en, 'seam, degrees'),
                    text(ko, '솔기, 도') ]).

segment(1, solid,
        named(reducer, cone(radius(param(d)/2), top(param(d2)/2),
                            height(param(h)), shift(param(e), 0),
                            facets(96)))).

unfolding(1, removed([base, top])).
unfolding(1, true_lengths).
unfolding(1, thickness(param(t))).
unfolding(1, size(outside)).
unfolding(1, seam(param(seam))).
unfolding(1, generators(24)).

view(300, 62, 0).
