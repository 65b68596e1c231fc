% An elbow of several pieces (segments, gores) of round pipe.
%
%     sanggwan unfold facts/fittings/elbow.pl --set d=168.3 --set r=252 \
%         -o elbow.pdf
%
% Units: millimetres, right-handed; it rises along z and bends to +x.

param(d, 114.3).                % outside diameter
param(r, 171.45).               % radius of the centre line
param(pieces, 4).               % with the two ends
param(angle, 90).               % degrees
param(ends, 0).                 % straight length before and after the bend
param(t, 4).                    % thickness of the plate
param(seam, 0).                 % degrees: 0 at the throat, 180 at the heel

param_about(d, [ min(1),
                 text(en, 'outside diameter'),
                 text(ko, '바깥지름') ]).
param_about(r, [ min(param(d)/2),
                 text(en, 'radius of the centre line'),
                 text(ko, '중심선의 반지름') ]).
param_about(pieces, [ min(2), max(60), step(1),
                      text(en, 'pieces, with the two ends'),
                      text(ko, '양 끝을 넣은 조각 수') ]).
param_about(angle, [ min(1), max(180),
                     text(en, 'angle of the bend, degrees'),
                     text(ko, '구부러지는 각도, 도') ]).
param_about(ends, [ min(0),
                    text(en, 'straight length before and after the bend'),
                    text(ko, '굽음 앞뒤의 곧은 길이') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of the plate'),
                 text(ko, '판의 두께') ]).
param_about(seam, [ min(-360), max(360),
                    text(en, 'seam, degrees: 0 at the throat'),
                    text(ko, '솔기, 도: 0은 안쪽(목)') ]).

segment(1, solid,
        named(elbow, elbow(diameter(param(d)), radius(param(r)),
                           pieces(param(pieces)), angle(param(angle)),
                           ends(param(ends)), facets(96)))).

unfolding(1, removed([base, top])).
unfolding(1, true_lengths).
unfolding(1, thickness(param(t))).
unfolding(1, size(outside)).
unfolding(1, seam(param(seam))).
unfolding(1, generators(24)).

view(330, 70, 0).
