% A wye: a stem and two legs of one diameter, whose axes meet in a point.
%
%     sanggwan unfold facts/fittings/wye.pl --set angle=90 -o wye.pdf
%
% Units: millimetres, right-handed; the stem is below, the legs lean to both
% sides.

param(d, 114.3).                % outside diameter
param(angle, 60).               % between the legs, degrees
param(stem, 150).               % length of the stem, from where the axes meet
param(legs, 250).               % length of each leg, from there
param(t, 4).                    % thickness of the plate
param(seam, 90).                % degrees: 0 and 180 where all three meet

param_about(d, [ min(1),
                 text(en, 'outside diameter'),
                 text(ko, '바깥지름') ]).
param_about(angle, [ min(1), max(179),
                     text(en, 'angle between the legs, degrees'),
                     text(ko, '두 가지 사이의 각도, 도') ]).
param_about(stem, [ min(param(d)/2*tan(param(angle)/4)),
                    text(en, 'length of the stem'),
                    text(ko, '줄기의 길이') ]).
param_about(legs, [ min(param(d)/2/tan(param(angle)/2)),
                    text(en, 'length of each leg'),
                    text(ko, '가지의 길이') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of the plate'),
                 text(ko, '판의 두께') ]).
param_about(seam, [ min(-360), max(360),
                    text(en, 'seam, degrees'),
                    text(ko, '솔기, 도') ]).

segment(1, solid,
        named(wye, wye(diameter(param(d)), angle(param(angle)),
                       stem(param(stem)), legs(param(legs)), facets(96)))).

unfolding(1, removed([base, cap])).
unfolding(1, true_lengths).
unfolding(1, thickness(param(t))).
unfolding(1, size(outside)).
unfolding(1, seam(param(seam))).
unfolding(1, generators(24)).

view(330, 70, 0).
