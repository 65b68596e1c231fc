/* Never across the weld: the edges of the ring where the cone of
   facts/patterns/hopper.pl meets the shell are not joined.
*/

may_join(S, E) :-
    \+ weld(S, E),
    default(may_join(S, E)).

weld(S, E) :-
    e(S, E, A, B, _),
    v(S, A, _, _, 50.0),
    v(S, B, _, _, 50.0).
