:- module(sg_oracle_bezier_grid,
          [ grid_points/4               % +Controls, +N, -Points, -Turned
          ]).
:- use_module(library(apply), [maplist/3]).
/** <module> The points of a bicubic Bezier patch in N by N cells, in rationals.

c_kernels/model/bezier_grid.c is the kernel.

@see bezier.pl
*/

%!  grid_points(+Controls, +N, -Points, -Turned) is det.
%
%   As bezier_grid/4. A point of the surface is found as Casteljau does: between
%   points of lines, again and again.

grid_points(Controls, N, Points, Turned) :-
    maplist(rational_number, Controls, Exact),
    rows_of_four(Exact, Rows),
    findall(P,
            ( between(0, N, J), between(0, N, I),
              place(Rows, I, J, N, P) ),
            Places),
    maplist(rounded, Places, Points),
    Table =.. [places|Places],
    findall(Turn,
            ( between(1, N, J), between(1, N, I),
              turned(Table, I, J, N, Turn) ),
            Turned).

rational_number(X, Q) :-
    Q is rational(X).

rows_of_four([], []).
rows_of_four([A,B,C,D,E,F,G,H,I,J,K,L|Rest],
             [[p(A,B,C),p(D,E,F),p(G,H,I),p(J,K,L)]|Rows]) :-
    rows_of_four(Rest, Rows).

place(Rows, I, J, N, P) :-
    U is I rdiv N,
    V is J rdiv N,
    maplist(on_curve(U), Rows, Ends),
    on_curve(V, Ends, P).

on_curve(_, [P], P) :-
    !.
on_curve(T, Points, P) :-
    between_neighbours(Points, T, Next),
    on_curve(T, Next, P).

between_neighbours([_], _, []) :-
    !.
between_neighbours([P,Q|Points], T, [R|Rest]) :-
    P = p(X1,Y1,Z1),
    Q = p(X2,Y2,Z2),
    X is X1 + T*(X2-X1),
    Y is Y1 + T*(Y2-Y1),
    Z is Z1 + T*(Z2-Z1),
    R = p(X,Y,Z),
    between_neighbours([Q|Points], T, Rest).

%   Half-way between two doubles, below 0, float/1 of SWI-Prolog 9.0 takes the
%   odd one.

rounded(p(X0,Y0,Z0), p(X,Y,Z)) :-
    X is sign(X0)*float(abs(X0)) + 0.0,
    Y is sign(Y0)*float(abs(Y0)) + 0.0,
    Z is sign(Z0)*float(abs(Z0)) + 0.0.

turned(Table, I, J, N, Turn) :-
    A is (J-1)*(N+1) + I,
    square_between(Table, A, A+N+2, Square1),
    square_between(Table, A+1, A+N+1, Square2),
    (   Square1 > Square2
    ->  Turn = 1
    ;   Turn = 0
    ).

square_between(Table, From, To0, Square) :-
    F is From,
    To is To0,
    arg(F, Table, p(X1,Y1,Z1)),
    arg(To, Table, p(X2,Y2,Z2)),
    Square is (X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2.
