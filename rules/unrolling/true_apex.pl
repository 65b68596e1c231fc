:- module(sg_true_apex,
          [ apex_opened/5               % +Facets0, +Layer, -Facets, +Shape0,
                                        % -Shape
          ]).
:- use_module(true_border, [level_kept/5]).
:- use_module(true_parallel, [regular_level/5]).
:- use_module(true_shape, [key_place/4]).
:- use_module(library(apply), [foldl/5, foldl/6]).
:- use_module(library(assoc), [get_assoc/3, put_assoc/4]).
:- use_module(library(lists), [append/2, member/2]).
/** <module> The tip of a cone in a layer that is not drawn.

All generators of a pointed cone end in its apex; in a layer outside of it each
goes along its own normal, and they end beside each other: the pattern ends in a
small ring. In a layer within they meet before that, as those of a cone with a
top narrower than its plate is thick may do, and pass each other by: it ends a
little before they meet, on a line of one height. Either way the apex, a key
that is on all generators, becomes a point of each of them.
*/

%!  apex_opened(+Facets0, +Layer, -Facets, +Shape0, -Shape) is det.
%
%   Facets are Facets0 of Shape0 (true_shape.pl), which are to be unrolled Layer
%   outside their surface (model units), without an apex, and up to where their
%   generators meet: they are as they were if those of a layer do not.

apex_opened(Facets0, Layer, Facets, Shape0, Shape) :-
    Shape0 = shape(Surface, _, _),
    (   Layer =\= 0.0,
        narrowing_cone(Surface, Cone, By)
    ->  findall(T, member(facet(_, T, _, _), Facets0), Ts),
        Inmost is By+Layer,
        regular_level(Cone, Ts, By, Inmost, Level),
        cut_off(Level, Facets0, Facets, Shape0, Shape)
    ;   Facets = Facets0,
        Shape = Shape0
    ).

%   narrowing_cone(Surface, Cone, By): Surface is By outside Cone. A pointed one
%   that was moved has ended already (true_parallel.pl).

narrowing_cone(cone(C, U, V, W, K), cone(C, U, V, W, K), 0.0) :-
    K < 1.0.
narrowing_cone(parallel(Cone, By), Cone, By) :-
    Cone = cone(_, _, _, _, K),
    K < 1.0,
    K =\= 0.0.

%   cut_off(Level, Facets0, Facets, Shape0, Shape): at the height H = Level; 1.0
%   is the end, and the apex if the cone has one.

cut_off(Level, Facets0, Facets, Shape0, Shape) :-
    (   Level < 1.0
    ->  foldl(level_kept(Level), Facets0, Lists, Shape0, Shape),
        append(Lists, Facets)
    ;   foldl(facet_opened, Facets0, Facets, Shape0, Shape)
    ).

%   A facet goes to the apex along one generator, and comes back along another:
%   between their ends it gets a half-edge.

facet_opened(facet(P, T1, T2, Halves0), facet(P, T1, T2, Halves), Shape0,
             Shape) :-
    foldl(half_opened(Halves0), Halves0, Lists, Shape0, Shape),
    append(Lists, Halves).

half_opened(Halves, half(A, B, Label), Opened, Shape0, Shape) :-
    (   is_apex(Shape0, B)
    ->  generator_end(A, B, EndA, Shape0, Shape1),
        Opened = [half(A, EndA, Label)|Across],
        (   member(half(B, C, _), Halves),
            generator_end(C, B, EndC, Shape1, Shape),
            EndC \== EndA
        ->  Across = [half(EndA, EndC, tip)]
        ;   Across = [],
            Shape = Shape1
        )
    ;   is_apex(Shape0, A)
    ->  generator_end(B, A, EndB, Shape0, Shape),
        Opened = [half(EndB, B, Label)]
    ;   Opened = [half(A, B, Label)],
        Shape = Shape0
    ).

is_apex(shape(_, _, Nodes), Key) :-
    key_place(Nodes, Key, any, _).

%   generator_end(Key, Apex, End, Shape0, Shape): End is the end, at Apex, of
%   the generator through Key.

generator_end(k(Below, Turn), k(V, apex), k(Id, Turn), Shape0, Shape) :-
    Shape0 = shape(Surface, Reach, Nodes0),
    get_assoc(Below, Nodes0, node(T, _, _, _)),
    Id = end(V, T),
    (   get_assoc(Id, Nodes0, _)
    ->  Shape = Shape0
    ;   get_assoc(V, Nodes0, node(_, H, Point, _)),
        put_assoc(Id, Nodes0, node(T, H, Point, []), Nodes),
        Shape = shape(Surface, Reach, Nodes)
    ).
