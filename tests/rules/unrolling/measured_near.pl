/* What is measured is what a closed form says. */
:- module(measured_near,
          [ near/2,                     % +X, +Y
            near/3,                     % +X, +Y, +Off
            lengths/2,                  % +Rows, -Lengths
            same_lengths/2              % +Rows, +Exact
          ]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).

%!  near(+X, +Y) is semidet.
%!  near(+X, +Y, +Off) is semidet.
%
%   X is off by at most Off (1e-9) of 1+|Y|; else both are printed.

near(X, Y) :-
    near(X, Y, 1.0e-9).

near(X, Y, Off) :-
    (   abs(X-Y) =< Off*(1.0+abs(Y))
    ->  true
    ;   print_message(error, format('~w is not ~w', [X,Y])),
        fail
    ).

%!  same_lengths(+Rows, +Exact) is semidet.
%
%   Rows of a table of true lengths have the lengths Exact, from whatever seam
%   on: the first one is there twice.

same_lengths(Rows, Exact0) :-
    lengths(Rows, [_|Lengths0]),
    Exact0 = [_|Exact1],
    msort(Lengths0, Lengths),
    msort(Exact1, Exact),
    maplist(near, Lengths, Exact).

%!  lengths(+Rows, -Lengths) is det.
%
%   Lengths of the generators of a table of true lengths, in its order.

lengths(Rows, Lengths) :-
    findall(Length, member(row(_, _, _, _, _, Length, _, _, _), Rows),
            Lengths).
