/* Bezier patches in cells, against rationals: rules/primitive/bezier.pl and
   c_kernels/model/bezier_grid.c. */
% covers: bezier_grid, bezier_grid_rows

:- use_module('../../../rules/kernel', [bezier_grid/4]).
:- use_module('../../../rules/primitive/primitive', [primitive_shape/4]).
:- use_module('../../oracle/bezier_grid', [grid_points/4]).

:- begin_tests(bezier).

%   some_controls(Case, Controls): of whole numbers, many alike; of any size; of
%   a few bits that are far apart; all 0 but one.

some_controls(Case, Controls) :-
    set_random(seed(Case)),
    length(Controls, 48),
    Kind is Case mod 4,
    maplist(some_number(Kind), Controls).

some_number(0, X) :-
    random_between(-3, 3, N),
    X is float(N).
some_number(1, X) :-
    random(Part),
    random_between(-300, 300, E),
    X is (Part-0.5)*2.0**E.
some_number(2, X) :-
    random(Part),
    X is Part - 0.5.
some_number(3, X) :-
    random_between(0, 20, N),
    (   N =:= 0
    ->  X = 4.9e-324
    ;   X = 0.0
    ).

test(as_rationals, [ forall(( between(1, 24, Case),
                              member(N, [1,2,3,7,10]) )),
                     Found == Points-Turned ]) :-
    some_controls(Case, Controls),
    bezier_grid(Controls, N, FoundPoints, FoundTurned),
    Found = FoundPoints-FoundTurned,
    grid_points(Controls, N, Points, Turned).

%   Cells of a square have diagonals that are equal, and all are cut alike.

test(equal_diagonals, Turns == [0]) :-
    findall(X,
            ( between(0, 3, V), between(0, 3, U),
              member(X0, [U,V,0]),
              X is X0/3.0 ),
            Controls0),
    maplist([X,Y]>>(Y is X*3.0), Controls0, Controls),
    bezier_grid(Controls, 10, _, Turned),
    sort(Turned, Turns).

test(finest, Ends == [p(0.0,0.0,0.0),p(3.0,3.0,0.0)]) :-
    findall(X,
            ( between(0, 3, V), between(0, 3, U),
              member(X0, [U,V,0]),
              X is float(X0) ),
            Controls),
    bezier_grid(Controls, 1000, [First|Points], _),
    last(Points, Last),
    Ends = [First,Last].

test(too_fine, error(domain_error(facets, 1001))) :-
    length(Controls, 48),
    maplist(=(1.0), Controls),
    bezier_grid(Controls, 1001, _, _).
test(no_patch, error(domain_error(patch, [1.0]))) :-
    bezier_grid([1.0], 1, _, _).

%   A border of two patches, the other way in one, is the same vertices.

test(a_border, Count == 231) :-
    findall([X,Y,Z],
            ( between(0, 6, Y0), between(0, 3, X0),
              X is X0/7.0,
              Y is Y0/3.0,
              Z is X*Y - Y*Y/3.0 ),
            Points),
    numlist(1, 16, First),
    numlist(13, 28, Second0),
    reverse(Second0, Second),
    primitive_shape(bezier(points(Points), patches([First,Second])), surface,
                    Vertices, _),
    length(Vertices, Count).

:- end_tests(bezier).
