:- module(sg_true_spike,
          [ spikes_cut/3,               % +Facets0, +Shape, -Facets
            lies_on/5                   % +Shape, +Other, +A, +B, +C
          ]).
:- use_module('../near', [is_on_surface/2]).
:- use_module('../kernel', [surfaces_meet/4]).
:- use_module(true_shape, [edge_curve/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists), [member/2, select/3]).
/** <module> True lines that run back on themselves.

Where the other segment ends, the line on its surface has a corner. The points
of the true line before it lie farther along than those of the facets' line, and
may lie past the corner: then the line runs past it and back on itself, a
*spike*. Its tip is left out.
*/

%!  spikes_cut(+Facets0, +Shape, -Facets) is det.
%
%   Facets are Facets0, where no line of the surface and another one runs there
%   and back: of two half-edges on one such line, from A to B and from B to C,
%   of which one lies on the other, only that from A to C is left.

spikes_cut(Facets0, Shape, Facets) :-
    maplist(facet_cut(Shape), Facets0, Facets).

facet_cut(Shape, Facet0, Facet) :-
    Facet0 = facet(P, T1, T2, Halves0),
    (   spike(Shape, Halves0, Halves)
    ->  facet_cut(Shape, facet(P, T1, T2, Halves), Facet)
    ;   Facet = Facet0
    ).

spike(Shape, Halves0, Halves) :-
    member(half(A, B, Label1), Halves0),
    member(half(B, C, Label2), Halves0),
    A \== C,
    turns_back(Shape, A, B, C),         % first: it is cheap, and seldom so
    half_curve(Shape, A, B, meets(Other)),
    half_curve(Shape, B, C, meets(Other)),
    (   lies_on(Shape, Other, A, B, C)
    ->  Label = Label1
    ;   lies_on(Shape, Other, C, B, A),
        Label = Label2
    ),
    !,
    select(half(A, B, _), Halves0, Halves1),
    select(half(B, C, _), Halves1, Halves2),
    Halves = [half(A, C, Label)|Halves2].

half_curve(Shape, A, B, Curve) :-
    msort([A,B], [K1,K2]),
    edge_curve(Shape, K1, K2, Curve).

turns_back(Shape, A, B, C) :-
    key_point(Shape, A, PA),
    key_point(Shape, B, PB),
    key_point(Shape, C, PC),
    along(PB, PA, PC, Along),
    Along > 0.0.

%!  lies_on(+Shape, +Other, +A, +B, +C) is semidet.
%
%   Key C is on the line of the surface and Other between A and B, or that line
%   drawn on beyond B: where a plane through C goes across it.

lies_on(Shape, Other, A, B, C) :-
    Shape = shape(Surface, Reach, _),
    key_point(Shape, A, PA),
    key_point(Shape, B, PB),
    key_point(Shape, C, PC),
    along(PB, PA, PC, Along),
    along(PB, PA, PA, Whole),
    Along < Whole,
    PA = point(X1,Y1,Z1),
    PB = point(X2,Y2,Z2),
    PC = point(X3,Y3,Z3),
    NX is X1-X2,
    NY is Y1-Y2,
    NZ is Z1-Z2,
    D is -(NX*X3 + NY*Y3 + NZ*Z3),
    F is Along/Whole,
    X is X2 + F*NX,
    Y is Y2 + F*NY,
    Z is Z2 + F*NZ,
    surfaces_meet([Surface,Other,plane(NX,NY,NZ,D)], Reach, point(X,Y,Z),
                  point(X4,Y4,Z4)),
    Off is sqrt((X4-X3)**2 + (Y4-Y3)**2 + (Z4-Z3)**2),
    is_on_surface(Off, Reach).

key_point(shape(_, _, Nodes), k(Id, _), Point) :-
    get_assoc(Id, Nodes, node(_, _, Point, _)).

%   along(O, P, Q, Along): (P-O) times (Q-O).

along(point(X0,Y0,Z0), point(X1,Y1,Z1), point(X2,Y2,Z2), Along) :-
    Along is (X1-X0)*(X2-X0) + (Y1-Y0)*(Y2-Y0) + (Z1-Z0)*(Z2-Z0).
