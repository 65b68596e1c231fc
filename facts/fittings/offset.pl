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

param_about(d, [ min(1),
                 text(en, 'outside diameter'),
                 text(ko, '바깥지름') ]).
param_about(x, [ min(1),
                 text(en, 'how far the axes are apart'),
                 text(ko, '두 축 사이의 거리') ]).
param_about(h, [ min(1),
                 text(en, 'in what height'),
                 text(ko, '어긋나는 높이') ]).
param_about(ends, [ min(param(d)/2*tan(atan2(param(x), param(h))/2)),
                    text(en, 'length of the axis before and after'),
                    text(ko, '앞뒤 축의 길이') ]).
param_about(t, [ min(0),
                 text(en, 'thickness of the plate'),
                 text(ko, '판의 두께') ]).
param_about(seam, [ min(-360), max(360),
                    text(en, 'seam, degrees'),
                    text(ko, '솔기, 도') ]).

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
