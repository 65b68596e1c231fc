:- module(test_contour_same,
          [ same_as_rule/2              % +S, +Crease
          ]).
:- use_module(tests('oracle/contour'), [contour_pieces/3, surface_facings/3]).
:- use_module(rules(store), [contour/13, surface_facing/6]).
/** <module> The pieces of contour/13 against their rule, for tests.
*/

%!  same_as_rule(+S, +Crease) is semidet.
%
%   True when the pieces that segment S has in contour/13, the kernel's, are
%   those that the rule says, and its facings in surface_facing/6, too.

same_as_rule(S, Crease) :-
    contour_pieces(S, Crease, Rule),
    findall(piece(T,I1,F1,I2,F2,Seen,Ts)-[X1,Y1,X2,Y2],
            ( contour(S, _, T, I1, F1, I2, F2, Seen, Ts0, X1, Y1, X2, Y2),
              msort(Ts0, Ts) ),
            Kernel0),
    sort(Kernel0, Kernel),
    length(Rule, N),
    length(Kernel, N),
    maplist(same_piece, Rule, Kernel),
    same_facings(S, Crease).

same_facings(S, Crease) :-
    surface_facings(S, Crease, Rule),
    findall(facing(T,I,From,To,Ts),
            ( surface_facing(S, T, I, From, To, Ts0), msort(Ts0, Ts) ),
            Kernel0),
    sort(Kernel0, Kernel),
    length(Rule, N),
    length(Kernel, N),
    maplist(same_facing, Rule, Kernel).

same_facing(facing(T,I,From,To,Ts), facing(T,I,From2,To2,Ts)) :-
    close_to(From, From2),
    close_to(To, To2).

same_piece(piece(T,I1,F1,I2,F2,Seen,Ts)-[X1,Y1,X2,Y2],
           piece(T,J1,G1,J2,G2,Seen,Ts)-[U1,V1,U2,V2]) :-
    (   I1-I2 == J1-J2
    ->  maplist(close_to, [F1,F2,X1,Y1,X2,Y2], [G1,G2,U1,V1,U2,V2])
    ;   I1-I2 == J2-J1,
        maplist(close_to, [F1,F2,X1,Y1,X2,Y2], [G2,G1,U2,V2,U1,V1])
    ).

close_to(A, B) :-
    abs(A-B) < 1.0e-9.
