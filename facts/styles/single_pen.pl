% A plotter with one pen, 0.3 mm: everything is drawn with it, penetration lines
% too, and only dashes tell what is hidden.
%
%     sanggwan draw MODEL --style facts/styles/single_pen.pl -o fig13.hpgl

line(any, any, any, [width(0.3), colour(black), pen(1)]).
line(hidden, any, any, [dashes([2.0, 1.2])]).
line(hidden, smooth, any, [none]).
