/* Seams at the back: of edges that are equally long those in front are joined
   first. The seam is as short as before; y grows to the back.
*/

join_order(S, E, key(Rank,Length,Back,Rest)) :-
    default(join_order(S, E, Rest)),
    Rest = key(Rank,Length,_,_,_),
    e(S, E, A, B, _),
    v(S, A, _, Ya, _),
    v(S, B, _, Yb, _),
    Back is Ya+Yb.
