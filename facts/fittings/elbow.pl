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
