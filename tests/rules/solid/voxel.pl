:- module(sg_test_voxel,
          [ expression_holds/2,         % +Expression, :In
            voxel_result/4              % +Expression, +Leaves, +Size, -Result
          ]).
/** <module> Booleans of solids made of unit cubes, by counting cubes.

A leaf is a list of block(X0,Y0,Z0,X1,Y1,Z1) of integers from 0 to Size; an
expression is the number of a leaf or union(L), intersection(L), difference(L)
of expressions. Nothing here is rounded, and nothing is shared with the rules:
the faces, edges and vertices of the result come from the squares between a
cube inside and one outside.
*/

:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(library(pairs)).

:- meta_predicate expression_holds(+, 1).

%!  expression_holds(+Expression, :In) is semidet.
%
%   True when Expression holds where call(In, Leaf) says which leaves do.

expression_holds(Leaf, In) :-
    integer(Leaf),
    !,
    call(In, Leaf).
expression_holds(union(Es), In) :-
    member(E, Es),
    expression_holds(E, In),
    !.
expression_holds(intersection(Es), In) :-
    forall(member(E, Es), expression_holds(E, In)).
expression_holds(difference([E|Es]), In) :-
    expression_holds(E, In),
    \+ expression_holds(union(Es), In).

%!  voxel_result(+Expression, +Leaves, +Size, -Result) is det.
%
%   Result is result(Volume, Area, Faces, Vertices, Edges): a face is connected
%   over edges of two squares of one plane that look one way; an edge goes on
%   through a place where nothing but its own line is.

voxel_result(Expression, Leaves, Size, result(Volume,Area,Faces,Vs,Es)) :-
    findall(c(X,Y,Z),
            ( cell(Size, X, Y, Z),
              expression_holds(Expression, leaf_has(Leaves, X, Y, Z)) ),
            Cells),
    length(Cells, Volume),
    list_to_ord_set(Cells, Inside),
    findall(Square, square(Inside, Square), Squares),
    length(Squares, Area),
    edges_squares(Squares, EdgesSquares),
    faces(Squares, EdgesSquares, Faces),
    exclude(within_face, EdgesSquares, Real),
    pairs_keys(Real, Edges),
    length(Edges, Units),
    ends(Edges, PlacesEdges),
    length(PlacesEdges, Places),
    aggregate_all(count, ( member(_-Ends, PlacesEdges), passed(Ends) ), Passed),
    Vs is Places-Passed,
    Es is Units-Passed.

cell(Size, X, Y, Z) :-
    Last is Size-1,
    between(0, Last, X),
    between(0, Last, Y),
    between(0, Last, Z).

leaf_has(Leaves, X, Y, Z, Leaf) :-
    nth1(Leaf, Leaves, Blocks),
    member(block(X0,Y0,Z0,X1,Y1,Z1), Blocks),
    X >= X0, X < X1,
    Y >= Y0, Y < Y1,
    Z >= Z0, Z < Z1,
    !.

%   square(+Inside, -Square): square(Axis, Sense, Corner): between Corner and
%   the opposite corner one further on the other axes.

square(Inside, square(Axis,Sense,At)) :-
    member(Cell, Inside),
    neighbour(Axis, Sense, Cell, Other),
    \+ memberchk(Other, Inside),
    (   Sense =:= 1
    ->  At = Other
    ;   At = Cell
    ).

neighbour(1, D, c(X0,Y,Z), c(X,Y,Z)) :- member(D, [-1,1]), X is X0+D.
neighbour(2, D, c(X,Y0,Z), c(X,Y,Z)) :- member(D, [-1,1]), Y is Y0+D.
neighbour(3, D, c(X,Y,Z0), c(X,Y,Z)) :- member(D, [-1,1]), Z is Z0+D.

next(1, c(X0,Y,Z), c(X,Y,Z)) :- X is X0+1.
next(2, c(X,Y0,Z), c(X,Y,Z)) :- Y is Y0+1.
next(3, c(X,Y,Z0), c(X,Y,Z)) :- Z is Z0+1.

others(1, 2, 3).
others(2, 1, 3).
others(3, 1, 2).

%   square_edge(+Square, -Edge): edge(Along, From).

square_edge(square(Axis,_,At), edge(Along,From)) :-
    others(Axis, A, B),
    (   Along = A, Other = B
    ;   Along = B, Other = A
    ),
    (   From = At
    ;   next(Other, At, From)
    ).

edges_squares(Squares, EdgesSquares) :-
    findall(Edge-Square,
            ( member(Square, Squares), square_edge(Square, Edge) ),
            Pairs),
    keysort(Pairs, Sorted),
    group_pairs_by_key(Sorted, EdgesSquares).

within_face(_-[square(Axis,Sense,_),square(Axis,Sense,_)]).

%   faces(+Squares, +EdgesSquares, -N): squares that are connected.

faces(Squares, EdgesSquares, N) :-
    findall(S-T,
            ( member(E, EdgesSquares), within_face(E), E = _-[A,B],
              ( S = A, T = B ; S = B, T = A ) ),
            Pairs),
    keysort(Pairs, Sorted),
    group_pairs_by_key(Sorted, Grouped),
    list_to_assoc(Grouped, Next),
    list_to_ord_set(Squares, Set),
    count_faces(Set, Next, 0, N).

count_faces([], _, N, N) :-
    !.
count_faces(Set0, Next, N0, N) :-
    Set0 = [Square|_],
    reached([Square], Next, [Square], Face),
    ord_subtract(Set0, Face, Set),
    N1 is N0+1,
    count_faces(Set, Next, N1, N).

reached([], _, Face, Face).
reached([Square|Rest], Next, Face0, Face) :-
    (   get_assoc(Square, Next, Others)
    ->  list_to_ord_set(Others, Set),
        ord_subtract(Set, Face0, New)
    ;   New = []
    ),
    ord_union(Face0, New, Face1),
    append(New, Rest, Todo),
    reached(Todo, Next, Face1, Face).

%   ends(+Edges, -PlacesEdges): at each place on which axes its edges are.

ends(Edges, PlacesEdges) :-
    findall(Place-Along,
            ( member(edge(Along,From), Edges),
              ( Place = From ; next(Along, From, Place) ) ),
            Pairs),
    keysort(Pairs, Sorted),
    group_pairs_by_key(Sorted, PlacesEdges).

passed([Along,Along]).
