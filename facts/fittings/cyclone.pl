% A cyclone: barrel, cone, dust pipe, outlet pipe, and an inlet along the wall
% of the barrel. Its sizes follow from its diameter, in the proportions of
% Stairmand (high efficiency).
%
%     sanggwan unfold facts/fittings/cyclone.pl --set d=500 --page A1 \
%         -o cyclone.pdf
%
% Units: millimetres, right-handed; z is up, the cone begins at 0.

param(d, 300).                  % outside diameter of the barrel
param(t, 2).                    % thickness of the plate
param(barrel, 1.5*param(d)).    % its height
param(cone, 2.5*param(d)).      % height of the cone
param(dust, 0.375*param(d)).    % diameter of the dust pipe
param(outlet, 0.5*param(d)).    % diameter of the outlet pipe
param(depth, 0.5*param(d)).     % of the outlet pipe in the barrel
param(a, 0.5*param(d)).         % height of the inlet
param(b, 0.2*param(d)).         % width of the inlet
param(inlet, param(d)).         % its length, from the axis

param_about(d, [ min(1),
                 text(en, 'outside diameter of the barrel'),
                 text(ko, '몸통의 바깥지름') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of the plate'),
                 text(ko, '판의 두께') ]).
param_about(barrel, [ min(0.1),
                      text(en, 'height of the barrel'),
                      text(ko, '몸통의 높이') ]).
param_about(cone, [ min(0.1),
                    text(en, 'height of the cone'),
                    text(ko, '원뿔의 높이') ]).
param_about(dust, [ min(0.1),
                    text(en, 'diameter of the dust pipe'),
                    text(ko, '먼지관의 지름') ]).
param_about(outlet, [ min(0.1),
                      text(en, 'diameter of the outlet pipe'),
                      text(ko, '배출관의 지름') ]).
param_about(depth, [ min(0.1),
                     text(en, 'depth of the outlet pipe in the barrel'),
                     text(ko, '몸통 안 배출관의 깊이') ]).
param_about(a, [ min(0.1),
                 text(en, 'height of the inlet'),
                 text(ko, '흡입구의 높이') ]).
param_about(b, [ min(0.1),
                 text(en, 'width of the inlet'),
                 text(ko, '흡입구의 너비') ]).
param_about(inlet, [ min(0.1),
                     text(en, 'length of the inlet'),
                     text(ko, '흡입구의 길이') ]).

segment(1, solid, named(barrel, cylinder(radius(param(d)/2),
                                         height(param(barrel)), facets(96)))).
segment(2, solid, named(cone, at([mirror(z)],
                                 cone(radius(param(d)/2), top(param(dust)/2),
                                      height(param(cone)), facets(96))))).
segment(3, solid,
        named(dust_pipe, at([translate(0, 0, -param(cone)-param(dust))],
                            cylinder(radius(param(dust)/2),
                                     height(param(dust)), facets(96))))).
segment(4, solid,
        named(inlet, at([translate(-param(inlet)/2, (param(d)-param(b))/2,
                                   param(barrel)-1.2*param(a))],
                        box(size(param(inlet), param(b), param(a)))))).
segment(5, solid,
        named(outlet, at([translate(0, 0, param(barrel)-param(depth))],
                         cylinder(radius(param(outlet)/2),
                                  height(2*param(depth)), facets(96))))).

unfolding(1, removed([base, top])).
unfolding(1, true_lengths).
unfolding(1, trim(outside)).
unfolding(1, thickness(param(t))).
unfolding(1, size(outside)).
unfolding(1, seam(270)).
unfolding(1, generators(24)).
unfolding(2, removed([base, top])).
unfolding(2, true_lengths).
unfolding(2, thickness(param(t))).
unfolding(2, size(outside)).
unfolding(2, generators(24)).
unfolding(3, removed([base, top])).
unfolding(3, true_lengths).
unfolding(3, generators(12)).
unfolding(3, thickness(param(t))).
unfolding(3, size(outside)).
unfolding(4, removed([side(4), side(2)])).
unfolding(4, true_lengths).
unfolding(4, trim(outside)).
unfolding(4, thickness(param(t))).
unfolding(4, size(outside)).
unfolding(5, removed([base, top])).
unfolding(5, true_lengths).
unfolding(5, generators(12)).
unfolding(5, thickness(param(t))).
unfolding(5, size(outside)).

view(300, 66, 0).
