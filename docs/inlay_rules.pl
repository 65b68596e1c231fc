/* Where an inlay is flush with the board it is the inlay that is seen:

       sanggwan render docs/inlay.pl --rules docs/inlay_rules.pl -o inlay.png
*/

:- use_module(library(lists), [last/2, member/2]).

owner(_, Group, S-Face) :-
    findall(S1-Face1, ( member(S1-Face1, Group), inlay(S1) ), Inlays),
    last(Inlays, S-Face).

inlay(S) :-
    segment(S, _, named(inlay, _)).
