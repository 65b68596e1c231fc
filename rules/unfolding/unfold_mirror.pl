:- module(sg_unfold_mirror,
          [ mirrored_pattern/2,         % +D, -M
            is_mirrored/1               % +D
          ]).
:- use_module('../store',
              [ origin/3, assert_fact/1, facts_transaction/1, fresh_id/3 ]).
:- use_module(unfold, [pattern_row/2]).
:- use_module(library(lists), [member/2]).
/** <module> The other hand of a pattern.

Parts that stand left and right are made once each way. The mirror image of a
pattern folds up to the mirror image of its solid: it is seen from outside, and
what folds down still does.
*/

%!  mirrored_pattern(+D, -M) is det.
%
%   M is a new pattern, of the same segment: the mirror image of pattern D, in
%   which all has the number that it has in D. One transaction.

mirrored_pattern(D, M) :-
    fresh_id(segment, 0, M),
    findall(Row, pattern_row(D, Row), Rows),
    facts_transaction(
        ( forall(( member(Row, Rows), mirrored_row(D, Row, M, New) ),
                 assert_fact(New)),
          assert_fact(origin(M, s(M), mirrored(D))) )).

mirrored_row(_, segment(_, Kind, Term), M, segment(M, Kind, Term)).
mirrored_row(_, v(_, V, X0, Y, Z), M, v(M, V, X, Y, Z)) :-
    X is 0.0-X0.
mirrored_row(D, e(_, E, A, B, Et), M, e(M, E, A1, B1, Et)) :-
    (   origin(D, e(E), generator(_, _, _, _, _))
    ->  A1 = A,                         % from what it begins at
        B1 = B
    ;   A1 = B,
        B1 = A
    ).
mirrored_row(_, p(_, P, Es), M, p(M, P, Es)).
mirrored_row(_, plane(_, P, Nx, Ny, Nz, C), M, % z = 0
             plane(M, P, Nx, Ny, Nz, C)).
mirrored_row(_, t(_, P, T, A, B, C), M, t(M, P, T, A, C, B)).
mirrored_row(D, origin(_, Item, Origin), M, origin(M, Item, Origin)) :-
    Item \== node(D),
    Item \== s(D).
mirrored_row(_, from_v(_, V, S, W), M, from_v(M, V, S, W)).
mirrored_row(_, from_p(_, P, S, Q, Sense), M, from_p(M, P, S, Q, Sense)).
mirrored_row(_, piece(_, P, K), M, piece(M, P, K)).
mirrored_row(_, joint(_, J, E1, E2, Kind, Angle), M,
             joint(M, J, E1, E2, Kind, Angle)).

%!  is_mirrored(+D) is semidet.
%
%   True when D is what mirrored_pattern/2 has made.

is_mirrored(D) :-
    once(origin(D, s(D), mirrored(_))).
