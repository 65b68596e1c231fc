% Segment 1 is a ghost: chain lines, thin and grey, its hidden lines left out.
%
%     sanggwan draw MODEL --style facts/styles/ghost.pl -o fig13.pdf

line(visible, any, 1, [width(0.25), colour(grey), dashes(chain_double),
                       layer('GHOST')]).
line(hidden, any, 1, [none]).
line(visible, penetration, any, [shown, colour(red), width(0.5),
                                 dashes(solid)]).
line(hidden, penetration, any, [shown, colour(red), dashes(dashed)]).
