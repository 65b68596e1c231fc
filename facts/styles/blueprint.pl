% A blueprint: white lines on blue paper, thin ones paler.
%
%     sanggwan draw MODEL --style facts/styles/blueprint.pl -o fig13.svg

paper(rgb(24,62,120)).

line(any, any, any, [colour(rgb(240,245,255))]).
line(hidden, any, any, [colour(rgb(150,178,220)), dashes(dashed)]).
line(visible, smooth, any, [colour(rgb(150,178,220))]).
line(any, penetration, any, [colour(rgb(255,214,120))]).
