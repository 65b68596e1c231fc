:- module(sg_true_border,
          [ rims_kept/4,                % +Facets0, -Facets, +Shape0, -Shape
            level_kept/5                % +Level, +Facet0, -Facets, +Shape0,
                                        % -Shape
          ]).
:- use_module('../near', [off_sign/2]).
:- use_module('../kernel', [surface_place/4, surfaces_meet/4]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module(true_shape, [edge_curve/4, key_place/4]).
:- use_module(true_surface, [level_plane/3]).
:- use_module(true_tip, [tips_cancelled/2]).
:- use_module(library(apply), [foldl/5, foldl/6]).
:- use_module(library(assoc), [get_assoc/3, put_assoc/4]).
:- use_module(library(lists), [append/2, member/2, min_list/2, select/3]).
/** <module> True lines that go past a rim.

A pipe ends at its rims. Where the line of the true surfaces goes past one and
that of the facets does not, as where a branch that hangs over its header begins
at the header's axis, a facet would have a part beyond the rim, the wrong way
round. It is taken off: what runs beyond the rim goes along it instead, and what
is there twice, once each way, vanishes.
*/

%!  rims_kept(+Facets0, -Facets, +Shape0, -Shape) is det.
%
%   Facets are Facets0 without what is beyond the rims, H < 0 and H > 1; those
%   of which nothing is left are not among them.

rims_kept(Facets0, Facets, Shape0, Shape) :-
    foldl(facet_kept, Facets0, Lists, Shape0, Shape),
    append(Lists, Facets).

facet_kept(Facet0, Facets, Shape0, Shape) :-
    level_kept(0.0, Facet0, Facets1, Shape0, Shape1),
    (   Facets1 = [Facet1]
    ->  level_kept(1.0, Facet1, Facets, Shape1, Shape)
    ;   Facets = [],
        Shape = Shape1
    ).

%!  level_kept(+Level, +Facet0, -Facets, +Shape0, -Shape) is det.
%
%   Facets is what is left of Facet0, one or none, without what is beyond Level:
%   below it if that is 0.0, else above it.

level_kept(Level, Facet0, Facets, Shape0, Shape) :-
    Facet0 = facet(P, T1, T2, Halves0),
    (   member(half(Key, _, _), Halves0),
        side(Shape0, Level, Key, beyond)
    ->  foldl(half_parted(Level), Halves0, Lists, Shape0, Shape),
        append(Lists, Parts),
        without_beyond(Parts, Shape, Level, Halves1),
        tips_cancelled(Halves1, Halves),
        (   Halves == []
        ->  Facets = []
        ;   Facets = [facet(P, T1, T2, Halves)]
        )
    ;   Facets = [Facet0],
        Shape = Shape0
    ).

%   side(Shape, Level, Key, Side): `beyond`, `on` or `within`.

side(shape(_, _, Nodes), Level, Key, Side) :-
    key_place(Nodes, Key, _, H),
    (   Level =:= 0.0
    ->  Off is H
    ;   Off is Level-H
    ),
    off_sign(Off, Sign),
    sign_side(Sign, Side).

sign_side(-1, beyond).
sign_side(0,  on).
sign_side(1,  within).

%   half_parted(Level, Half, Parts, Shape0, Shape): in two if it goes through
%   the rim.

half_parted(Level, half(A, B, Label), Parts, Shape0, Shape) :-
    side(Shape0, Level, A, SideA),
    side(Shape0, Level, B, SideB),
    (   ( SideA-SideB == beyond-within ; SideA-SideB == within-beyond )
    ->  rim_key(Level, A, B, Key, Shape0, Shape),
        Parts = [half(A, Key, Label),half(Key, B, Label)]
    ;   Parts = [half(A, B, Label)],
        Shape = Shape0
    ).

%   rim_key(Level, A, B, Key, Shape0, Shape): where the edge meets the rim; the
%   same point in both facets of a generator, however often these were carried
%   round.

rim_key(Level, A, B, k(Id, Turn), Shape0, Shape) :-
    Shape0 = shape(Surface, Reach, Nodes0),
    turned_once(A, B, Turn, A1, B1),
    msort([A1,B1], Ends),
    Id = rim(Ends, Level),
    (   get_assoc(Id, Nodes0, _)
    ->  Shape = Shape0
    ;   rim_place(Shape0, Level, Ends, T, Point, Surfaces),
        put_assoc(Id, Nodes0, node(T, Level, Point, Surfaces), Nodes),
        Shape = shape(Surface, Reach, Nodes)
    ).

%   turned_once(A, B, Turn, A1, B1): A and B carried back by Turn, so that the
%   one of them that is no apex is where it is first.

turned_once(k(A, TurnA), k(B, TurnB), Turn, k(A, TurnA1), k(B, TurnB1)) :-
    findall(Turn1, ( member(Turn1, [TurnA,TurnB]), Turn1 \== apex ), Turns),
    min_list(Turns, Turn),
    turned_back(TurnA, Turn, TurnA1),
    turned_back(TurnB, Turn, TurnB1).

turned_back(Turn0, By, Turn) :-
    (   Turn0 == apex
    ->  Turn = apex
    ;   Turn is Turn0-By
    ).

rim_place(Shape, Level, [A,B], T, Point, Surfaces) :-
    Shape = shape(Surface, Reach, Nodes),
    key_place(Nodes, A, TA, HA),
    key_place(Nodes, B, TB, HB),
    (   TA == any
    ->  T0 = TB
    ;   TB == any
    ->  T0 = TA
    ;   T0 is TA + (TB-TA)*(Level-HA)/(HB-HA)
    ),
    surface_point(Surface, T0, Level, Point0),
    (   edge_curve(Shape, A, B, meets(Other)),
        level_plane(Surface, Level, Plane),
        surfaces_meet([Surface,Other,Plane], Reach, Point0, Point1)
    ->  Point = Point1,
        Surfaces = [Other],
        surface_place(Surface, Point, T1, _),
        T is T1 + 360.0*round((T0-T1)/360.0)
    ;   Point = Point0,
        Surfaces = [],
        T = T0
    ).

%   without_beyond(Parts, Shape, Level, Halves): a chain of parts beyond the
%   rim, from one point of it to another, becomes one half-edge along it.

without_beyond(Parts, Shape, Level, Halves) :-
    (   select(Half, Parts, Rest0),
        Half = half(A, B, _),
        side(Shape, Level, A, on),
        side(Shape, Level, B, beyond)
    ->  chain_end(B, Shape, Level, Rest0, Rest, End),
        (   End == A
        ->  Halves1 = Rest
        ;   Halves1 = [half(A, End, tip)|Rest]
        ),
        without_beyond(Halves1, Shape, Level, Halves)
    ;   findall(Half,
                ( member(Half, Parts),
                  Half = half(A, _, _),
                  \+ side(Shape, Level, A, beyond) ),
                Halves)
    ).

chain_end(A, Shape, Level, Parts, Rest, End) :-
    select(half(A, B, _), Parts, Rest0),
    !,
    (   side(Shape, Level, B, beyond)
    ->  chain_end(B, Shape, Level, Rest0, Rest, End)
    ;   Rest = Rest0,
        End = B
    ).
