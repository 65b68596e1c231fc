% A plotter with a carousel of eight pens, one for each role. The widths are
% those of the pens, the colours what is in them.
%
%     sanggwan draw MODEL --style facts/styles/eight_pens.pl -o drawing.hpgl

line(visible, any, any, [pen(1), width(0.5), colour(black)]).
line(visible, outline, any, [pen(2), width(0.7)]).
line(hidden, any, any, [pen(3), width(0.25), colour(grey)]).
line(visible, penetration, any, [pen(4), width(0.7), colour(red)]).
line(hidden, penetration, any, [pen(5), width(0.35), colour(red)]).
line(any, smooth, any, [pen(6), width(0.25), colour(blue)]).
line(any, mesh, any, [pen(6), width(0.25), colour(blue)]).
line(any, curve, any, [pen(7), width(0.5), colour(green)]).
line(visible, hatching, any, [pen(6), width(0.25), colour(blue)]).
line(visible, text, any, [pen(8), width(0.35), colour(black)]).
line(visible, field, any, [pen(8), width(0.35)]).
line(visible, frame, any, [pen(2), width(0.7)]).
line(visible, cutting, any, [pen(6), width(0.25), colour(blue)]).
line(visible, axis, any, [pen(6), width(0.25), colour(blue)]).
line(visible, symbol, any, [pen(8), width(0.35)]).
