:- module(sg_primitive_argument,
          [ given_values/4,             % +Given, +Wanted, +Term, -Values
            finite_number/2,            % +Value, -Float
            given/3,                    % +Given, +Name, -Value
            given_one/3,                % +Given, +Names, -NameValue
            given_facets/4,             % +Given, +Radius, +Degrees, -N
            vertices_within/2,          % +Count, +Given
            primitive_error/2           % +What, +Term
          ]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../angle', [chord_facets/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2, same_length/2]).
/** <module> The named arguments of primitives, checked.

The table of primitives (primitive.pl) lists for each what it takes:

    argument(Name, Forms, Default)

Forms are the possible lists of types of its numbers; Default is `needed`,
`none`, or a list of values. argument_number/4 has the types. A maker gets

    given(Term, Stretch, Values)

Values has Name-Numbers for every argument of the table (`none` if it is left
out and has no default); Stretch is the greatest factor of the placing.
*/

default_facets(40).
most_facets(1_000_000).

%!  given_values(+Given, +Wanted, +Term, -Values) is det.
%
%   Values are the values of the arguments Given (those of Term) where Wanted
%   are the rows of the table.
%
%   @error model_error(primitive(What, Term)): unknown_argument(A),
%   missing(Name), twice(Name), wrong_argument(A, Types),
%   wrong_item(Name, N, Item, Type)

given_values(Given, Wanted, Term, Values) :-
    maplist(known_argument(Wanted, Term), Given, Named),
    no_argument_twice(Named, Term),
    maplist(argument_value(Named, Term), Wanted, Values).

known_argument(Wanted, Term, Argument, Name-Numbers) :-
    (   compound(Argument),
        compound_name_arguments(Argument, Name, Values),
        member(argument(Name, Forms, _), Wanted)
    ->  fitting_form(Forms, Values, Types),
        (   same_length(Types, Values)
        ->  true
        ;   primitive_error(wrong_argument(Argument, Types), Term)
        ),
        (   numbers_of(Types, Values, name(Name, Term), Numbers)
        ->  true
        ;   primitive_error(wrong_argument(Argument, Types), Term)
        )
    ;   primitive_error(unknown_argument(Argument), Term)
    ).

fitting_form(Forms, Values, Types) :-
    (   member(Types, Forms),
        same_length(Types, Values)
    ->  true
    ;   Forms = [Types|_]
    ).

no_argument_twice(Named, Term) :-
    (   append(_, [Name-_|Rest], Named),
        member(Name-_, Rest)
    ->  primitive_error(twice(Name), Term)
    ;   true
    ).

argument_value(Named, Term, argument(Name, _, Default), Name-Numbers) :-
    (   member(Name-Given, Named)
    ->  Numbers = Given
    ;   Default == needed
    ->  primitive_error(missing(Name), Term)
    ;   Numbers = Default
    ).

numbers_of([], [], _, []).
numbers_of([Type|Types], [Value|Values], Where, [Number|Numbers]) :-
    argument_number(Type, Value, Where, Number),
    numbers_of(Types, Values, Where, Numbers).

argument_number(facets, N, _, N) :-
    integer(N),
    N >= 3,
    most_facets(Most),
    N =< Most.
argument_number(count, N, _, N) :-
    integer(N),
    N >= 1,
    most_facets(Most),
    N =< Most.
argument_number(length, Value, _, Number) :-
    finite_number(Value, Number),
    Number > 0.0.
argument_number(radius, Value, _, Number) :-
    finite_number(Value, Number),
    Number >= 0.0.
argument_number(factor, Value, _, Number) :-
    finite_number(Value, Number),
    Number >= 0.0.
argument_number(number, Value, _, Number) :-
    finite_number(Value, Number).
argument_number(turn, Value, _, Number) :-
    finite_number(Value, Number),
    Number > 0.0,
    Number =< 360.0.
argument_number(flag, Value, _, Value) :-
    ( Value == true ; Value == false ),
    !.
argument_number(points2, List, Where, Points) :-
    items(List, point2, Where, Points).
argument_number(points3, List, Where, Points) :-
    items(List, point3, Where, Points).
argument_number(loops2, List, Where, Loops) :-
    items(List, points2, Where, Loops).
argument_number(outline, Value, _, Outline) :-
    nonvar(Value),
    outline_argument(Value, Outline).
argument_number(faces, List, Where, Faces) :-
    items(List, face, Where, Faces).

%   outline_argument(Value, Outline): Outline is what a user wrote, of floats;
%   fails if it is no outline.

outline_argument(circle(R0), circle(R)) :-
    lengths([R0], [R]).
outline_argument(ellipse(A0, B0), ellipse(A, B)) :-
    lengths([A0,B0], [A,B]).
outline_argument(rectangle(A0, B0), rectangle(A, B)) :-
    lengths([A0,B0], [A,B]).
outline_argument(rectangle(A0, B0, R0), rectangle(A, B, R)) :-
    lengths([A0,B0,R0], [A,B,R]).
outline_argument(polygon(Points0), polygon(Points)) :-
    is_list(Points0),
    maplist(corner_argument, Points0, Points).

lengths(Values, Lengths) :-
    maplist(finite_number, Values, Lengths),
    \+ ( member(Length, Lengths), Length =< 0.0 ).

corner_argument(Corner, X-Y) :-
    nonvar(Corner),
    Corner = [X0,Y0],
    finite_number(X0, X),
    finite_number(Y0, Y).

%   items(List, Type, Where, Items): the first that is wrong is named.

items(List, Type, Where, Items) :-
    is_list(List),
    nth_items(List, 1, Type, Where, Items).

nth_items([], _, _, _, []).
nth_items([Value|Values], N, Type, Where, [Item|Items]) :-
    (   item(Type, Value, Item0)
    ->  Item = Item0
    ;   Where = name(Name, Term),
        primitive_error(wrong_item(Name, N, Value, Type), Term)
    ),
    N1 is N+1,
    nth_items(Values, N1, Type, Where, Items).

item(point2, [X0, Y0], X-Y) :-
    finite_number(X0, X),
    finite_number(Y0, Y).
item(point3, [X0, Y0, Z0], point(X, Y, Z)) :-
    finite_number(X0, X),
    finite_number(Y0, Y),
    finite_number(Z0, Z).
item(points2, List, Points) :-
    is_list(List),
    maplist(item(point2), List, Points).
item(face, List, List) :-
    is_list(List),
    List = [_|_],
    maplist(vertex_number, List, _).

vertex_number(V, V) :-
    integer(V),
    V =\= 0.

%!  finite_number(+Value, -Float) is semidet.
%
%   Float is Value as in a column of coordinates: an integer or a finite
%   float, never a rational, never -0.0.

finite_number(Value, Float) :-
    integer(Value),
    !,
    catch(Float is float(Value), error(evaluation_error(_), _), fail).
finite_number(Value, Float) :-
    float(Value),
    float_class(Value, Class),
    finite_class(Class),
    Float is Value + 0.0.

finite_class(zero).
finite_class(normal).
finite_class(subnormal).

%!  given(+Given, +Name, -Value) is det.
%
%   Value is what the maker got for the argument Name: a list, or `none`.

given(given(_, _, Values), Name, Value) :-
    memberchk(Name-Value, Values).

%!  given_one(+Given, +Names, -NameValue) is det.
%
%   NameValue is Name-Value of the one argument of Names that was given.
%
%   @error missing(Name) with the first of Names; both(Name1, Name2)

given_one(Given, Names, NameValue) :-
    Given = given(Term, _, _),
    findall(Name-Value,
            ( member(Name, Names), given(Given, Name, Value),
              Value \== none ),
            Found),
    (   Found = [NameValue]
    ->  true
    ;   Found = [Name1-_, Name2-_|_]
    ->  primitive_error(both(Name1, Name2), Term)
    ;   Names = [Name|_],
        primitive_error(missing(Name), Term)
    ).

%!  given_facets(+Given, +Radius, +Degrees, -N) is det.
%
%   N is the number of facets of an arc of Radius and so many Degrees: by
%   facets(N), by tolerance(T) as it is after placing, or 40 a full turn.
%   Each is less than half a turn.
%
%   @error both(facets, tolerance), few_facets(N, Least), too_many(N)

given_facets(Given, Radius, Degrees, N) :-
    Given = given(Term, Stretch, _),
    given(Given, facets, Facets),
    given(Given, tolerance, Tolerance),
    most_facets(Most),
    Least is floor(rational(Degrees) rdiv 180) + 1,
    (   Facets = [N0]
    ->  (   Tolerance == none
        ->  N = N0
        ;   primitive_error(both(facets, tolerance), Term)
        )
    ;   Tolerance = [T0]
    ->  T is T0/Stretch,
        chord_facets(Radius, T, Degrees, N)
    ;   default_facets(Default),
        N is max(Least, ceiling(Default*rational(Degrees)/360))
    ),
    (   N < Least
    ->  primitive_error(few_facets(N, Least), Term)
    ;   N > Most
    ->  primitive_error(too_many(N), Term)
    ;   true
    ).

%!  vertices_within(+Count, +Given) is det.
%
%   Called before any vertices are made.
%
%   @error too_many_vertices(Count, Most)

vertices_within(Count, given(Term, _, _)) :-
    limit_value(facets, Most),
    (   Count =< Most
    ->  true
    ;   primitive_error(too_many_vertices(Count, Most), Term)
    ).

%!  primitive_error(+What, +Term) is failure.
%
%   Raise model_error(primitive(What, Term)).

primitive_error(What, Term) :-
    throw(error(model_error(primitive(What, Term)), _)).
