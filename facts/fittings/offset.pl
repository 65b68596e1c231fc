% An offset: pipe that goes on beside where it was, by three pieces.
%
%     sanggwan unfold facts/fittings/offset.pl --set x=200 --set h=300 \
%         -o offset.pdf
%
% Units: millimetres, right-handed; it rises along z and goes over to +x.

param(d, 114.3).                % outside diameter
param(x, 150).                  % how far the axes are apart
param(h, 180).                  % in what height that is done
param(ends, 150).               % length of the axis before and after it
param(t, 4).                    % thickness of the plate
param(seam, 0).                 % degrees: 0 is the side to +x

segment(1, solid,
        named(offset, mitred_pipe(diameter(param(d)), facets(96),
                                  through([[0, 0, 0], [0, 0, param(ends)],
                                           [param(x), 0, param(ends)+param(h)],
                                           [param(x), 0,
                                            2*param(ends)+param(h)]])))).

unfolding(1, removed([base, top])).
unfolding(1, true_lengths).
unfolding(1, thickness(param(t))).
unfolding(1, size(outside)).
unfolding(1, seam(param(seam))).
unfolding(1, generators(24)).

view(330, 70, 0).
