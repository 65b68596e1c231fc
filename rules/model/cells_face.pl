:- module(sg_cells_face,
          [ face_border/4,              % +S, +P, -Loops, -Seams
            face_points/3,              % +S, +P, -Vs
            face_shapes/3,              % +S, +P, -Shapes
            face_flat/2,                % +S, +P
            region_shells/3             % +S, +R, -Shells
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module('../store', [v/5, e/5, p/3, t/6, sides/4, lies_in/3]).
:- use_module('../vector',
              [cross_product/3, difference/3, dot_product/3, left_of/4]).
:- use_module('../vocabulary', [edge_loops/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/3, partition/4]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(ordsets), [ord_intersect/2, ord_union/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Faces and shells of regions, as files of other programs want them.

Others have no seams in the middle of a loop, and some no holes: so loops
without seams, seams and points that lie inside are told apart here.
*/

%!  face_border(+S, +P, -Loops:list, -Seams:list) is det.
%
%   Loops are the cycles of vertices round polygon P, the outer one first,
%   without its Seams, which are V1-V2, each once.

face_border(S, P, Loops, Seams) :-
    once(p(S, P, Es)),
    findall(V1-V2, ( member(E, Es), e(S, E, V1, V2, _) ), Edges0),
    sort(Edges0, Set),
    partition(there_and_back(Set), Edges0, Both, Edges),
    findall(V1-V2, ( member(V1-V2, Both), V1 < V2 ), Seams),
    edge_loops(Edges, Loops).

there_and_back(Set, V1-V2) :-
    memberchk(V2-V1, Set).

%!  face_points(+S, +P, -Vs:list) is det.
%
%   Vs are the vertices that lie inside polygon P.

face_points(S, P, Vs) :-
    findall(V, lies_in(S, v(V), p(P)), Vs0),
    sort(Vs0, Vs).

%!  face_shapes(+S, +P, -Shapes:list) is det.
%
%   Polygon P as shape(Vs, Points): one if it is flat, and a loop that goes
%   through no vertex twice, else its triangles. Points are the vertices that
%   lie inside.

face_shapes(S, P, Shapes) :-
    face_points(S, P, Points),
    (   face_flat(S, P),
        face_border(S, P, [Loop], []),
        sort(Loop, Set),
        length(Loop, N),
        length(Set, N)
    ->  Shapes = [shape(Loop, Points)]
    ;   findall([A,B,C], t(S, P, _, A, B, C), Triangles),
        shapes(Triangles, S, Points, Shapes)
    ).

%!  face_flat(+S, +P) is semidet.
%
%   True when the corners of polygon P are in one plane, up to rounding: what
%   was measured, and has few digits, need not be. Others compute with the plane
%   of some of them.

face_flat(S, P) :-
    t(S, P, _, V1, V2, V3),
    !,
    maplist(exact_place(S), [V1,V2,V3], [A,B,C]),
    difference(B, A, U),
    difference(C, A, W),
    cross_product(U, W, N),
    dot_product(N, N, Square),
    dot_product(U, U, UU),
    dot_product(W, W, WW),
    tolerance(rounding, Near),
    Most is Near*sqrt(float(Square))*sqrt(float(max(UU, WW))),
    p(S, P, Es),
    forall(( member(E, Es), e(S, E, V, _, _) ),
           ( exact_place(S, V, Point),
             difference(Point, A, From),
             dot_product(From, N, Off),
             abs(float(Off)) =< Most )).

%   shapes(Triangles, S, Points, Shapes): each point goes to the first triangle
%   that it is in.

shapes([], _, _, []).
shapes([Corners|Triangles], S, Points0, [shape(Corners,Own)|Shapes]) :-
    partition(in_triangle(S, Corners), Points0, Own, Points),
    shapes(Triangles, S, Points, Shapes).

in_triangle(S, Corners, V) :-
    maplist(exact_place(S), Corners, [A,B,C]),
    exact_place(S, V, Point),
    difference(B, A, U),
    difference(C, A, W),
    cross_product(U, W, Normal),
    left_of(Normal, A, B, Point),
    left_of(Normal, B, C, Point),
    left_of(Normal, C, A, Point).

exact_place(S, V, p(X,Y,Z)) :-
    once(v(S, V, X0, Y0, Z0)),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

%!  region_shells(+S, +R, -Shells:list) is det.
%
%   Shells are the faces round region R, use(P, Side), that hang together by
%   vertices: Side is 1 if the normal of P points out of R, -1 if into it. The
%   shell that is the largest along an axis, which is round all others, comes
%   first. Faces with R on both sides are none of them.

region_shells(S, R, Shells) :-
    findall(set(Vs,[use(P,Side)]),
            ( border_use(S, R, P, Side), face_vertices(S, P, Vs) ),
            Sets0),
    foldl(set_added, Sets0, [], Sets),
    findall(Size-Uses,
            ( member(set(Vs,Uses0), Sets),
              size(S, Vs, Size),
              sort(Uses0, Uses) ),
            Sized0),
    sort(1, @>=, Sized0, Sized),
    pairs_values(Sized, Shells).

border_use(S, R, P, 1) :-
    sides(S, P, R, Above),
    Above =\= R.
border_use(S, R, P, -1) :-
    sides(S, P, Below, R),
    Below =\= R.

face_vertices(S, P, Vs) :-
    p(S, P, Es),
    findall(V, ( member(E, Es), e(S, E, V, _, _) ), Vs0),
    face_points(S, P, Points),
    append(Vs0, Points, Vs1),
    sort(Vs1, Vs).

set_added(set(Vs,Uses), Sets0, [set(AllVs,AllUses)|Others]) :-
    partition(meets(Vs), Sets0, Mine, Others),
    foldl(united, Mine, set(Vs,Uses), set(AllVs,AllUses)).

meets(Vs, set(Vs1,_)) :-
    ord_intersect(Vs, Vs1).

united(set(Vs1,Uses1), set(Vs2,Uses2), set(Vs,Uses)) :-
    ord_union(Vs1, Vs2, Vs),
    append(Uses1, Uses2, Uses).

size(S, Vs, Size) :-
    aggregate_all(r(min(X), max(X), min(Y), max(Y), min(Z), max(Z)),
                  ( member(V, Vs), v(S, V, X, Y, Z) ),
                  r(X1, X2, Y1, Y2, Z1, Z2)),
    Size is max(X2-X1, max(Y2-Y1, Z2-Z1)).
