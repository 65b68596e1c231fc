:- module(sg_true_divide,
          [ facet_divided/7,            % +Facet, +T, +Sense, +N, -Parts,
                                        % +Shape0, -Shape
            crossing_near/7,            % +Key1, +Key2, +T, +H, -Key, +Shape0,
                                        % -Shape
            facet_index/2,              % +Facets, -Index
            generator_spans/5           % +Index, +T, +Sense, +Shape, -Spans
          ]).
:- use_module('../near',
              [same_angle/2, between_angles/3, less_part/2, off_sign/2]).
:- use_module('../kernel', [surface_place/4, surfaces_meet/4]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module(true_part_loop, [facet_parted/3]).
:- use_module(true_pipe, [pipe_crossing/5]).
:- use_module(true_shape, [edge_curve/4, key_place/4]).
:- use_module(true_surface, [generator_plane/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [append/2, append/3, member/2, selectchk/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Facets divided along a generator.

The seam may be anywhere, half a pattern ends in the middle, and generators may
be others than the edges of facets. Where a generator goes through a facet, it
crosses its half-edges: upwards along it one comes in over those that run one
way, and out over those that run the other way. A vertex on the generator
counts as lying on its right; so each crossing is one, whatever touches it.
*/

%!  facet_divided(+Facet, +T, +Sense, +N, -Parts, +Shape0, -Shape) is det.
%
%   Parts are those of Facet on both sides of the generator at T, which is
%   strictly between its own: facet(P/1, T1, T, _) and facet(P/2, T, T2, _), or,
%   where a hole parts one of these, several (facet_parted/3).
%   Their new half-edges are labelled cut(N+I) and -cut(N+I). Sense is 1 if
%   facets run counter-clockwise with T to the right and H up, else -1.

facet_divided(facet(P, T1, T2, Halves), T, Sense, N, Parts, Shape0, Shape) :-
    crossed(Halves, T, Left0, Right0, Crossings0, Shape0, Shape),
    in_order(Crossings0, Sense, Crossings),
    spans(Crossings, Sense, Spans),
    cut_halves(Spans, Sense, N, CutLeft, CutRight),
    append(Left0, CutLeft, Left),
    append(Right0, CutRight, Right),
    maplist(facet_parted(Shape),
            [facet(P/1, T1, T, Left),facet(P/2, T, T2, Right)], Lists),
    append(Lists, Parts).

%   crossed(Halves, T, Left, Right, Crossings, Shape0, Shape): a crossing is
%   crossing(H, Way, Key), Way 1 where a half-edge goes to the right.

crossed([], _, [], [], [], Shape, Shape).
crossed([Half|Halves], T, Left, Right, Crossings, Shape0, Shape) :-
    Half = half(K1, K2, Label),
    key_side(Shape0, K1, T, Side1),
    key_side(Shape0, K2, T, Side2),
    (   Side1 == left,
        Side2 == left
    ->  Left = [Half|Left1],
        Right = Right1,
        Crossings = Crossings1,
        Shape1 = Shape0
    ;   Side1 \== left,
        Side2 \== left
    ->  Left = Left1,
        Right = [Half|Right1],
        Crossings = Crossings1,
        Shape1 = Shape0
    ;   Side1 == left
    ->  crossing_key(K1, K2, Side2, T, Key, H, Shape0, Shape1),
        Crossings = [crossing(H, 1, Key)|Crossings1],
        Left = [half(K1, Key, Label)|Left1],
        rest_half(Side2, Key, K2, Label, Right, Right1)
    ;   crossing_key(K2, K1, Side1, T, Key, H, Shape0, Shape1),
        Crossings = [crossing(H, -1, Key)|Crossings1],
        Left = [half(Key, K2, Label)|Left1],
        rest_half(Side1, K1, Key, Label, Right, Right1)
    ),
    crossed(Halves, T, Left1, Right1, Crossings1, Shape1, Shape).

%   What is on the right of a half-edge that ends on the generator is nothing.

rest_half(on, _, _, _, Right, Right).
rest_half(right, A, B, Label, [half(A, B, Label)|Right], Right).

key_side(shape(_, _, Nodes), Key, T, Side) :-
    key_place(Nodes, Key, T1, _),
    (   T1 == any
    ->  Side = on
    ;   off_sign(T1-T, Sign),
        sign_side(Sign, Side)
    ).

sign_side(-1, left).
sign_side(0,  on).
sign_side(1,  right).

%   crossing_key(K1, K2, Side2, T, Key, H, ...): K1 is on the left.

crossing_key(_, K2, on, _, K2, H, Shape, Shape) :-
    !,
    Shape = shape(_, _, Nodes),
    key_place(Nodes, K2, _, H).
crossing_key(K1, K2, right, T, k(Id, 0), H, Shape0, Shape) :-
    Shape0 = shape(Surface, Reach, Nodes0),
    msort([K1,K2], Ends),
    Id = crossing(Ends, T),
    (   get_assoc(Id, Nodes0, node(_, H, _, _))
    ->  Shape = Shape0
    ;   edge_curve(Shape0, K1, K2, Curve),
        crossing_node(Shape0, Curve, K1, K2, T, Node),
        Node = node(_, H, _, _),
        put_assoc(Id, Nodes0, Node, Nodes),
        Shape = shape(Surface, Reach, Nodes)
    ).

crossing_node(Shape, Curve, K1, K2, T, node(T, H, Point, Surfaces)) :-
    Shape = shape(Surface, Reach, Nodes),
    between_keys(Nodes, K1, K2, T, H0, Point0, Surfaces),
    (   Curve = meets(Other),
        generator_plane(Surface, T, Plane),
        surfaces_meet([Surface,Other,Plane], Reach, Point0, Point)
    ->  surface_place(Surface, Point, _, H)
    ;   Curve = meets(Other),
        pipe_crossing(Surface, Other, T, H0, H)
    ->  surface_point(Surface, T, H, Point)
    ;   Point = Point0,
        H = H0
    ).

%!  crossing_near(+Key1, +Key2, +T, +H0, -Key, +Shape0, -Shape) is det.
%
%   Key is the point near H0 where the edge between the keys, a line of the
%   surface and another one, crosses the generator at T.

crossing_near(K1, K2, T, H0, k(Id, 0), Shape0, Shape) :-
    Shape0 = shape(Surface, Reach, Nodes0),
    edge_curve(Shape0, K1, K2, meets(Other)),
    surface_point(Surface, T, H0, Point0),
    generator_plane(Surface, T, Plane),
    (   surfaces_meet([Surface,Other,Plane], Reach, Point0, Point)
    ->  surface_place(Surface, Point, _, H)
    ;   Point = Point0,
        H = H0
    ),
    Id = crossing([K1,K2], T, H),
    put_assoc(Id, Nodes0, node(T, H, Point, [Other]), Nodes),
    Shape = shape(Surface, Reach, Nodes).

between_keys(Nodes, K1, K2, T, H, Point, Surfaces) :-
    K1 = k(A, _),
    K2 = k(B, _),
    key_place(Nodes, K1, T1, H1),
    key_place(Nodes, K2, T2, H2),
    F is (T-T1)/(T2-T1),
    H is H1 + F*(H2-H1),
    get_assoc(A, Nodes, node(_, _, point(X1,Y1,Z1), Surfaces1)),
    get_assoc(B, Nodes, node(_, _, point(X2,Y2,Z2), Surfaces2)),
    X is X1 + F*(X2-X1),
    Y is Y1 + F*(Y2-Y1),
    Z is Z1 + F*(Z2-Z1),
    Point = point(X,Y,Z),
    findall(Met,
            ( member(Met, Surfaces1), memberchk(Met, Surfaces2) ),
            Surfaces).

%   in_order(Crossings0, Sense, Crossings): upwards. Of those in one place that
%   comes first which goes in, if the generator is outside there, or out.

in_order(Crossings0, Sense, Crossings) :-
    sort(1, @=<, Crossings0, Sorted),
    in_turns(Sorted, Sense, 0, Crossings).

in_turns([], _, _, []).
in_turns([Next|Crossings0], Sense, Depth0, [Crossing|Crossings]) :-
    (   Depth0 < 1
    ->  Way = Sense
    ;   Way is -Sense
    ),
    Next = crossing(H, _, _),
    (   Crossing = crossing(H, Way, _),
        selectchk(Crossing, [Next|Crossings0], Crossings1)
    ->  true
    ;   Crossing = Next,
        Crossings1 = Crossings0
    ),
    Crossing = crossing(_, Gone, _),
    Depth is Depth0 + Sense*Gone,
    in_turns(Crossings1, Sense, Depth, Crossings).

%   spans(Crossings, Sense, Spans): Span is Key1-Key2, upwards, within the
%   facet.

spans(Crossings, Sense, Spans) :-
    spans_(Crossings, Sense, 0, none, Spans).

spans_([], _, _, _, []).
spans_([crossing(_, Way, Key)|Crossings], Sense, Depth0, From, Spans) :-
    (   Depth0 =:= 1,
        From \== Key
    ->  Spans = [From-Key|Rest]
    ;   Spans = Rest
    ),
    Depth is Depth0 + Sense*Way,
    spans_(Crossings, Sense, Depth, Key, Rest).

cut_halves([], _, _, [], []).
cut_halves([A-B|Spans], Sense, N, [Left|Lefts], [Right|Rights]) :-
    (   Sense =:= 1
    ->  Left = half(A, B, cut(N)),
        Right = half(B, A, -cut(N))
    ;   Left = half(B, A, cut(N)),
        Right = half(A, B, -cut(N))
    ),
    N1 is N+1,
    cut_halves(Spans, Sense, N1, Lefts, Rights).

%!  facet_index(+Facets, -Index) is det.
%
%   Index finds the facets at a generator: an assoc from whole degrees.

facet_index(Facets, Index) :-
    findall(Degree-Facet,
            ( member(Facet, Facets),
              Facet = facet(_, T1, T2, _),
              First is floor(T1-1.0e-3),
              Last is floor(T2+1.0e-3),
              between(First, Last, Degree) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Index).

%!  generator_spans(+Index, +T, +Sense, +Shape, -Spans) is det.
%
%   Spans is the list of H1-H2, ascending, where the generator at T lies on
%   facets; at a border between facets where it is an edge of one of them.

generator_spans(Index, T, Sense, Shape, Spans) :-
    Degree is floor(T),
    findall(Span,
            ( get_assoc(Degree, Index, Facets),
              member(Facet, Facets),
              facet_span(Facet, T, Sense, Shape, Span) ),
            Spans0),
    sort(Spans0, Spans1),
    joined_spans(Spans1, Spans).

facet_span(facet(_, T1, T2, Halves), T, Sense, Shape, H1-H2) :-
    Shape = shape(_, _, Nodes),
    (   between_angles(T1, T, T2)
    ->  crossed(Halves, T, _, _, Crossings0, Shape, _),
        in_order(Crossings0, Sense, Crossings),
        span_heights(Crossings, Sense, 0, none, Pairs),
        member(H1-H2, Pairs)
    ;   member(Own, [T1,T2]),
        same_angle(T, Own)
    ->  member(half(K1, K2, _), Halves),
        on_generator(Nodes, Own, K1, A),
        on_generator(Nodes, Own, K2, B),
        A =\= B,
        H1 is min(A, B),
        H2 is max(A, B)
    ).

on_generator(Nodes, T, Key, H) :-
    key_place(Nodes, Key, T1, H),
    (   T1 == any
    ->  true
    ;   same_angle(T, T1)
    ).

span_heights([], _, _, _, []).
span_heights([crossing(H, Way, _)|Crossings], Sense, Depth0, From, Pairs) :-
    (   Depth0 =:= 1,
        From < H
    ->  Pairs = [From-H|Rest]
    ;   Pairs = Rest
    ),
    Depth is Depth0 + Sense*Way,
    span_heights(Crossings, Sense, Depth, H, Rest).

%   joined_spans(Spans0, Spans): those that touch are one.

joined_spans([], []).
joined_spans([A-B,C-D|Spans0], Spans) :-
    \+ less_part(B, C),
    !,
    E is max(B, D),
    joined_spans([A-E|Spans0], Spans).
joined_spans([Span|Spans0], [Span|Spans]) :-
    joined_spans(Spans0, Spans).
