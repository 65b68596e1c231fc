% A branch on a header: a tee, or a lateral if it is not square. The branch is
% set on the header; with as large a branch they meet in a mitre.
%
%     sanggwan unfold facts/fittings/tee.pl --set b=60.3 --set angle=45 \
%         -o tee.pdf
%
% Units: millimetres, right-handed; the header lies along x.

param(d, 168.3).                % outside diameter of the header
param(t, 6).                    % thickness of its plate
param(length, 500).             % of the header
param(b, 114.3).                % outside diameter of the branch
param(tb, 5).                   % thickness of its plate
param(height, 250).             % of the branch, from the axis of the header
param(angle, 90).               % between the axes, degrees
param(offset, 0).               % of the axes from each other, sideways
param(seam, 0).                 % of the branch, degrees: 0 along the header

param_about(d, [ min(1),
                 text(en, 'outside diameter of the header'),
                 text(ko, '주관의 바깥지름') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of its plate'),
                 text(ko, '주관의 두께') ]).
param_about(length, [ min(1),
                      text(en, 'length of the header'),
                      text(ko, '주관의 길이') ]).
param_about(b, [ min(1), max(param(d)),
                 text(en, 'outside diameter of the branch'),
                 text(ko, '지관의 바깥지름') ]).
param_about(tb, [ min(0),
                  text(en, 'thickness of its plate'),
                  text(ko, '지관의 두께') ]).
param_about(height, [ min((param(d)+param(b)*abs(cos(param(angle))))
                          /2/sin(param(angle))),
                      text(en, 'height of the branch from the axis'),
                      text(ko, '축에서 지관 끝까지의 높이') ]).
param_about(angle, [ min(15), max(165),
                     text(en, 'angle between the axes, degrees'),
                     text(ko, '두 축 사이의 각도, 도') ]).
param_about(offset, [ min(-abs(param(d)-param(b))/2),
                      max(abs(param(d)-param(b))/2),
                      text(en, 'of the axes from each other'),
                      text(ko, '두 축의 어긋난 거리') ]).
param_about(seam, [ min(-360), max(360),
                    text(en, 'seam of the branch, degrees'),
                    text(ko, '지관의 솔기, 도') ]).

segment(1, solid,
        named(header, at([rotate(y, 90), translate(-param(length)/2, 0, 0)],
                         cylinder(radius(param(d)/2), height(param(length)),
                                  facets(96))))).
segment(2, solid,
        named(branch, at([rotate(y, 90-param(angle)),
                          translate(0, param(offset), 0)],
                         cylinder(radius(param(b)/2), height(param(height)),
                                  facets(96))))).

% The header is welded opposite the hole.
unfolding(1, removed([base, top])).
unfolding(1, true_lengths).
unfolding(1, trim(outside)).
unfolding(1, thickness(param(t))).
unfolding(1, other_thickness(param(tb))).
unfolding(1, size(outside)).
unfolding(1, seam(0)).
unfolding(1, generators(24)).

unfolding(2, removed([base, top])).
unfolding(2, true_lengths).
unfolding(2, trim(outside)).
unfolding(2, thickness(param(tb))).
unfolding(2, other_thickness(param(t))).
unfolding(2, size(outside)).
unfolding(2, seam(param(seam))).
unfolding(2, generators(24)).

view(300, 62, 0).
