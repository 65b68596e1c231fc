:- module(test_loose_end,
          [ loose_end/3,                % +Sheet, +Most, -End
            short_gap/3                 % +Sheet, +Most, -Gap
          ]).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(rules(picture/contour), [line_ends/4]).
:- use_module(rules(store)).
/** <module> Lines of a picture that end where nothing is, for tests.

What is seen of an edge ends at a corner or where something comes before it:
there, in either case, another line is seen. Only an outline may end in nothing,
where it turns back.

Lengths are told in millimetres of a sheet on which the longer side of the
picture is Sheet.
*/

%!  loose_end(+Sheet, +Most, -End) is nondet.
%
%   End, end(S,E,Role,Off), is an end of a visible part of edge E of segment S
%   such that no other visible line comes nearer to it than Off, more than Most.

loose_end(Sheet, Most, end(S,E,Role,Off)) :-
    visible_parts(Sheet, Parts),
    end_counts(Parts, Counts),
    member(part(S,E,P,Q), Parts),
    E > 0,
    member(Place, [P,Q]),
    rounded(Place, Key),
    get_assoc(Key, Counts, 1),
    aggregate_all(min(D), ( member(part(S2,E2,P2,Q2), Parts),
                            S-E \== S2-E2,
                            distance(Place, P2, Q2, D) ),
                  Off),
    Off > Most,
    once(drawn(_, S, E, _, _, visible, Role)).

%   Parts are part(S, E, P, Q), X-Y in millimetres.

visible_parts(Sheet, Parts) :-
    millimetre(Sheet, Unit),
    findall(part(S,E,P,Q), drawn_part(visible, Unit, S, E, P, Q), Parts).

drawn_part(Visibility, Unit, S, E, P, Q) :-
    drawn(_, S, E, From, To, Visibility, _),
    once(line_ends(S, E, Start, End)),
    maplist(place_on(Start, End, Unit), [From,To], [P,Q]).

place_on(X1-Y1, X2-Y2, Unit, At, X-Y) :-
    X is (X1+At*(X2-X1))*Unit,
    Y is (Y1+At*(Y2-Y1))*Unit.

millimetre(Sheet, Unit) :-
    aggregate_all(r(min(X), max(X), min(Y), max(Y)),
                  ( drawn(_, S, E, _, _, _, _), once(line_ends(S, E, A, B)),
                    member(X-Y, [A,B]) ),
                  r(X1,X2,Y1,Y2)),
    Unit is Sheet/max(X2-X1, Y2-Y1).

end_counts(Parts, Counts) :-
    findall(Key, ( member(part(_,_,P,Q), Parts), member(End, [P,Q]),
                   rounded(End, Key) ),
            Keys0),
    msort(Keys0, Keys),
    clumped_keys(Keys, Pairs),
    list_to_assoc(Pairs, Counts).

clumped_keys([], []).
clumped_keys([Key|Keys0], [Key-N|Pairs]) :-
    counted(Keys0, Key, 1, N, Keys),
    clumped_keys(Keys, Pairs).

counted([Key|Keys0], Key, N0, N, Keys) :-
    !,
    N1 is N0+1,
    counted(Keys0, Key, N1, N, Keys).
counted(Keys, _, N, N, Keys).

rounded(X-Y, I-J) :-
    I is round(X*1.0e4),
    J is round(Y*1.0e4).

distance(X-Y, X1-Y1, X2-Y2, D) :-
    U is X2-X1,
    V is Y2-Y1,
    Square is U*U + V*V,
    (   Square > 0.0
    ->  T is max(0.0, min(1.0, ((X-X1)*U + (Y-Y1)*V)/Square))
    ;   T = 0.0
    ),
    D is sqrt((X1+T*U-X)**2 + (Y1+T*V-Y)**2).

%!  short_gap(+Sheet, +Most, -Gap) is nondet.
%
%   Gap, gap(Edges,Length), is a run of hidden parts of Edges, S-E, each of
%   which begins where the one before it ends, shorter than Most together,
%   between visible parts. Runs both ways are told.

short_gap(Sheet, Most, gap(Ids,Length)) :-
    millimetre(Sheet, Unit),
    findall(Visibility-part(S,E,P,Q),
            ( member(Visibility, [visible,hidden]),
              drawn_part(Visibility, Unit, S, E, P, Q), E > 0 ),
            All),
    findall(Key-(Visibility-Part),
            ( member(Visibility-Part, All), Part = part(_,_,P,Q),
              member(End, [P,Q]), rounded(End, Key) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, At),
    member(hidden-Part, All),
    begins(At, Part, Start),
    run(At, Most, Part, Start, [Part], 0.0, Run, Length),
    findall(S-E, member(part(S,E,_,_), Run), Ids).

%   Where exactly one other line of them meets it, a visible one.
begins(At, Part, Start) :-
    Part = part(_,_,P,Q),
    member(Start, [P,Q]),
    others(At, Start, Part, [visible-_]).

others(At, Place, Part, Others) :-
    rounded(Place, Key),
    get_assoc(Key, At, All),
    findall(X, ( member(X, All), X \== hidden-Part ), Others).

run(At, Most, Part, Start, Run0, L0, Run, Length) :-
    Part = part(_,_,P,Q),
    ( P == Start -> End = Q ; End = P ),
    P = X1-Y1,
    Q = X2-Y2,
    L is L0 + sqrt((X2-X1)**2 + (Y2-Y1)**2),
    L < Most,
    others(At, End, Part, [Other]),
    (   Other = visible-_
    ->  Run = Run0,
        Length = L
    ;   Other = hidden-Next,
        \+ memberchk(Next, Run0),
        Next = part(_,_,A,B),
        rounded(End, Key),
        ( rounded(A, Key) -> From = A ; From = B ),
        run(At, Most, Next, From, [Next|Run0], L, Run, Length)
    ).
