/* Rules for facts/pipes.pl: the brackets are of glass, and drawn thin.

       sanggwan draw facts/pipes.pl --rules docs/pipes_rules.pl \
           --rules docs/glass_rules.pl -o glass.svg

   See docs/rules.md.
*/

% Which segments hide whose lines: what did so before, but no glass.

may_hide(S, S2) :-
    \+ glass(S),
    default(may_hide(S, S2)).

% How lines look: those of glass are half as wide, and blue.

line_style(Visibility, Role, S, style(Width, blue, Dashes, Pen, Layer)) :-
    glass(S),
    default(line_style(Visibility, Role, S,
                       style(Width0, _, Dashes, Pen, Layer))),
    Width is Width0/2.

glass(S) :-
    segment(S, _, named(bracket(_), _)).
