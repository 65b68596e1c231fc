/* Rules for facts/pipes.pl: pipes lie in their brackets and do not cut them.

       sanggwan draw facts/pipes.pl --rules docs/pipes_rules.pl -o pipes.svg

   See docs/rules.md.
*/

% Which segments cut each other: what did so before, but no pipe and bracket.

may_cut(S1, S2) :-
    \+ lies_in(S1, S2),
    \+ lies_in(S2, S1),
    default(may_cut(S1, S2)).

lies_in(Pipe, Bracket) :-
    segment(Pipe, _, named(pipe(_), _)),
    segment(Bracket, _, named(bracket(_), _)).
