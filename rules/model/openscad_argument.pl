:- module(sg_openscad_argument,
          [ openscad_argument/4,        % +Node, +Name, +Type, -Value
            openscad_argument/5,        % +Node, +Name, +Type, +Default, -Value
            openscad_knows/2,           % +Node, +Names
            openscad_fragments/3,       % +Node, +Radius, -N
            openscad_error/2            % +What, +Place
          ]).
:- use_module('../limits', [within_limit/3]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> The arguments of a node of an OpenSCAD .csg file.

Errors:

    missing(Name, Argument)
    argument(Name, Argument, Value, Type)      a value that is no Type
    unknown_argument(Name, Argument, Names)    Names are those that are known

Types: number, positive (above 0), flag, size2, size3 (a number or a list of
them), points2, points3, paths, faces, matrix, factors, count.
*/

%!  openscad_argument(+Node, +Name, +Type, -Value) is det.
%
%   Value is the argument Name of Node, or, if Name is N, the N-th one that has
%   no name.
%
%   @error missing, argument, see above

openscad_argument(Node, Name, Type, Value) :-
    openscad_argument(Node, Name, Type, none, Value),
    (   Value == none
    ->  Node = node(_, NodeName, _, _, Place),
        openscad_error(missing(NodeName, Name), Place)
    ;   true
    ).

%!  openscad_argument(+Node, +Name, +Type, +Default, -Value) is det.
%
%   The same, with Default if there is none or it is `undef`.
%
%   @error argument, see above

openscad_argument(node(_, NodeName, Arguments, _, Place), Name, Type, Default,
                  Value) :-
    (   memberchk(Name-Given, Arguments),
        Given \== undef
    ->  (   typed(Type, Given, Value0)
        ->  Value = Value0
        ;   openscad_error(argument(NodeName, Name, Given, Type), Place)
        )
    ;   Value = Default
    ).

%!  openscad_knows(+Node, +Names) is det.
%
%   @error unknown_argument, if Node has an argument that is not in Names

openscad_knows(node(_, NodeName, Arguments, _, Place), Names) :-
    (   member(Name-Value, Arguments),
        Value \== undef,
        \+ memberchk(Name, Names)
    ->  openscad_error(unknown_argument(NodeName, Name, Names), Place)
    ;   true
    ).

%   typed(Type, Given, Value)

typed(number, Number, Number) :-
    number(Number).
typed(count, Number, Count) :-
    number(Number),
    Count is truncate(Number).
typed(flag, Given, Flag) :-
    memberchk(Given-Flag, [true-true, false-false]).
typed(size2, Given, Size) :-
    size(2, Given, Size).
typed(size3, Given, Size) :-
    size(3, Given, Size).
typed(factors, Given, [X, Y]) :-
    size(2, Given, [X, Y]),
    X >= 0,
    Y >= 0.
typed(points2, Points, Points) :-
    is_list(Points),
    maplist(is_point(2), Points).
typed(points3, Points, Points) :-
    is_list(Points),
    maplist(is_point(3), Points).
typed(faces, Faces, Faces) :-
    is_list(Faces),
    maplist(is_face, Faces).
typed(matrix, Rows0, [R1, R2, R3]) :-
    is_list(Rows0),
    maplist(is_point(4), Rows0),
    (   Rows0 = [R1, R2, R3]
    ->  true
    ;   Rows0 = [Q1, Q2, Q3, [A, B, C, W]],
        A =:= 0,
        B =:= 0,
        C =:= 0,
        W =\= 0,
        maplist(divided(W), [Q1, Q2, Q3], [R1, R2, R3])
    ).

size(N, Given, Size) :-
    (   number(Given)
    ->  length(Size, N),
        maplist(=(Given), Size)
    ;   is_point(N, Given),
        Size = Given
    ).

is_point(N, Point) :-
    is_list(Point),
    length(Point, N),
    maplist(number, Point).

is_face(Face) :-
    is_list(Face),
    maplist(is_index, Face).

is_index(Index) :-
    integer(Index),
    Index >= 0.

divided(W, Row0, Row) :-
    (   W =:= 1
    ->  Row = Row0
    ;   maplist(quotient(W), Row0, Row)
    ).

quotient(W, X, Y) :-
    Y is X/float(W).

%!  openscad_fragments(+Node, +Radius, -N) is det.
%
%   N is how many facets OpenSCAD gives a full turn of Radius, by the $fn, $fa
%   and $fs of Node.
%
%   Source: OpenSCAD User Manual, Other Language Features, $fa, $fs and $fn.

openscad_fragments(Node, Radius, N) :-
    node_fineness(Node, Count, Angle, Size),
    (   ( Radius < 2.0** -20 ; Count == many )
    ->  N = 3
    ;   Count > 0
    ->  N is max(3, truncate(Count))
    ;   ByAngle is 360.0/Angle,
        BySize is Radius*2.0*pi/Size,
        N is ceiling(max(5.0, min(ByAngle, BySize)))
    ),
    arg(5, Node, Place),
    within_limit(facets, N, Place).

node_fineness(Node, Count, Angle, Size) :-
    Node = node(_, _, Arguments, _, _),
    (   memberchk('$fn'-inf, Arguments)
    ->  Count = many
    ;   openscad_argument(Node, '$fn', number, 0, Count)
    ),
    openscad_argument(Node, '$fa', number, 12, Angle0),
    openscad_argument(Node, '$fs', number, 2, Size0),
    Angle is max(0.01, Angle0),
    Size is max(0.01, Size0).

%!  openscad_error(+What, +Place) is failure.
%
%   Raise model_error(openscad(What)) at Place.

openscad_error(What, Place) :-
    throw(error(model_error(openscad(What)), Place)).
