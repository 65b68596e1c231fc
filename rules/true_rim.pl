:- module(sg_true_rim,
          [ rims_rounded/3              % +D, +S, +Options
          ]).
:- use_module(placed_surface,
              [placed_face/3, placed_polygon/4, placed_surface/3]).
:- use_module(primitive_face, [surface_point/4]).
:- use_module(kernel, [roll_curves/5, surface_place/4]).
:- use_module(store,
              [ e/5, edge_polygon/3, from_p/5, joint/6, p/3, plane/6, v/5,
                assert_fact/1, facts_transaction/1, fresh_id/3,
                retractall_facts/1
              ]).
:- use_module(triangulation, [complete_segments/1]).
:- use_module(true_surface, [meeting_surfaces/3]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(assoc), [get_assoc/3]).
:- autoload(library(lists), [append/2, append/3, member/2, reverse/2]).
:- autoload(library(option), [option/3]).
/** <module> Flat ends of what is rolled, and holes in what is flat.

Facets end in chords. In a pattern of the flat faces that close a cylinder or a
cone, the edges that were rims become arcs, so that they fit what is unrolled;
and a hole that a pipe leaves in a flat face has the true curve.
*/

%!  rims_rounded(+D, +S, +Options) is det.
%
%   In pattern D of segment S, a border edge of a flat polygon that was an edge
%   of a facet, on its rim, becomes a polyline along that of the true surface;
%   so does one where the polygon was cut by a curved surface of another
%   segment. The edges it is divided into have origin(D, e(New), e(E)). One
%   transaction. Option: chord(Tolerance), 1.0e-4 of the size of the surface by
%   default.

rims_rounded(D, S, Options) :-
    facts_transaction(sg_true_rim:rounded(D, S, Options)).

rounded(D, S, Options) :-
    meeting_tables(D, S, Meets),
    findall(P-Arcs,
            ( p(D, P, Es),
              findall(arc(E, Points),
                      ( member(E, Es),
                        border_edge(D, E),
                        (   rim_arc(D, S, P, E, Options, Points)
                        ->  true
                        ;   line_arc(D, S, P, E, Meets, Options, Points)
                        ) ),
                      Arcs),
              Arcs \== [] ),
            Changes),
    (   Changes == []
    ->  true
    ;   forall(member(P-Arcs, Changes), polygon_rounded(D, P, Arcs)),
        complete_segments([D])
    ).

border_edge(D, E) :-
    \+ joint(D, _, E, _, _, _),
    \+ joint(D, _, _, E, _, _).

%   rim_arc(D, S, P, E, Options, Points): edge E of flat polygon P is a rim;
%   Points, X-Y, are those of the arc between its ends in D.

rim_arc(D, S, P, E, Options, Points) :-
    e(S, E, A, B, _),
    e(S, Twin, B, A, _),
    once(edge_polygon(S, Twin, Q)),
    facet_surface(S, Q, Surface),
    \+ facet_surface(S, P, _),
    rim_place(S, A, Surface, TA, H),
    rim_place(S, B, Surface, TB0, H),
    TB is TB0 + 360.0*round((TA-TB0)/360.0),
    arc_count(Surface, TA, TB, H, Options, N),
    N > 1,
    e(D, E, WA, WB, _),
    frame(S, P, A, B, D, WA, WB, Frame),
    Last is N-1,
    findall(Point,
            ( between(1, Last, I),
              T is TA + (TB-TA)*I/N,
              surface_point(Surface, T, H, Place),
              in_frame(Frame, Place, Point) ),
            Points).

%   meeting_tables(D, S, Meets): Leaf-Table of meeting_surfaces/3 for the leaves
%   that the polygons of D are of.

meeting_tables(D, S, Meets) :-
    findall(Leaf, ( p(D, P, _), polygon_leaf(S, P, Leaf) ), Leaves0),
    sort(Leaves0, Leaves),
    findall(Leaf-Table,
            ( member(Leaf, Leaves), meeting_surfaces(S, Leaf, Table) ),
            Meets).

polygon_leaf(S, P, Leaf) :-
    (   from_p(S, P, _, _, _)
    ->  once(placed_polygon(S, P, Leaf, _))
    ;   Leaf = S
    ).

%   line_arc(D, S, P, E, Meets, Options, Points): edge E of flat polygon P is
%   where a curved surface cut it.

line_arc(D, S, P, E, Meets, Options, Points) :-
    \+ facet_surface(S, P, _),
    polygon_leaf(S, P, Leaf),
    memberchk(Leaf-Table, Meets),
    e(S, E, A, B, _),
    get_assoc(A, Table, met(Surfaces1, _)),
    get_assoc(B, Table, met(Surfaces2, _)),
    member(Surface, Surfaces1),
    Surface \= plane(_, _, _, _),
    memberchk(Surface, Surfaces2),
    e(D, E, WA, WB, _),
    frame(S, P, A, B, D, WA, WB, Frame),
    curve_between(S, P, Surface, A, B, Frame, Options, Places),
    Places \== [],
    !,
    maplist(laid_in(Frame), Places, Points).

%   curve_between(S, P, Surface, A, B, Frame, Options, Places): unrolled in the
%   plane of P as a fan, from A along B.

curve_between(S, P, Surface, A, B, Frame, Options, Places) :-
    Frame = frame(PA, [UX,UY,UZ], [VX,VY,VZ], _, _),
    vertex_point(S, A, PA),
    vertex_point(S, B, PB),
    once(plane(S, P, NX, NY, NZ, N)),
    Fan = fan(PA, vector(UX,UY,UZ), vector(VX,VY,VZ), 1.0),
    chord_wanted(Surface, Options, Chord),
    arc_reach(PA, PB, Reach),
    roll_curves(roll(Fan, 0.0, 0.0), Reach, Chord,
                [curve(0.0, [plane(NX,NY,NZ,N),Surface], PA, PB)], [Places]).

vertex_point(S, V, point(X,Y,Z)) :-
    v(S, V, X, Y, Z),
    !.

arc_reach(point(X1,Y1,Z1), point(X2,Y2,Z2), Reach) :-
    Reach is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

laid_in(frame(_, _, _, X1-Y1, CX-CY), place(_, _, U, V), X-Y) :-
    X is X1 + U*CX - V*CY,
    Y is Y1 + U*CY + V*CX.

facet_surface(S, P, Surface) :-
    (   from_p(S, P, _, _, _)
    ->  once(placed_polygon(S, P, Leaf, P0))
    ;   Leaf-P0 = S-P
    ),
    placed_face(Leaf, P0, curved(Part, [_])),
    placed_surface(Leaf, Part, Surface),
    functor(Surface, Kind, _),
    memberchk(Kind, [cylinder, cone, ruled]),
    !.

rim_place(S, V, Surface, T, H) :-
    v(S, V, X, Y, Z),
    surface_place(Surface, point(X,Y,Z), T, H0),
    member(H, [0.0,1.0]),
    abs(H-H0) < 1.0e-9,
    surface_point(Surface, T, H, point(X1,Y1,Z1)),
    Off is abs(X-X1) + abs(Y-Y1) + abs(Z-Z1),
    Off < 1.0e-9*(1.0 + abs(X) + abs(Y) + abs(Z)),
    !.

%   arc_count(Surface, T1, T2, H, Options, N): N equal chords are near enough.

arc_count(Surface, T1, T2, H, Options, N) :-
    chord_wanted(Surface, Options, Chord),
    Middle is (T1+T2)/2.0,
    surface_point(Surface, T1, H, point(X1,Y1,Z1)),
    surface_point(Surface, T2, H, point(X2,Y2,Z2)),
    surface_point(Surface, Middle, H, point(X,Y,Z)),
    Off is sqrt((X-(X1+X2)/2)**2 + (Y-(Y1+Y2)/2)**2 + (Z-(Z1+Z2)/2)**2),
    N is max(1, ceiling(sqrt(Off/Chord))).

%   chord_wanted(Surface, Options, Chord)

chord_wanted(Surface, Options, Chord) :-
    arg(2, Surface, vector(A, B, C)),
    Usual is 1.0e-4*2.0*sqrt(A*A + B*B + C*C),
    option(chord(Chord0), Options, Usual),
    Chord is max(Chord0, Usual*1.0e-3).

%   frame(S, P, A, B, D, WA, WB, Frame): P of S, at A-B, is laid at WA-WB of D.

frame(S, P, A, B, D, WA, WB,
      frame(point(XA,YA,ZA), Along, Left, X1-Y1, CX-CY)) :-
    v(S, A, XA, YA, ZA),
    v(S, B, XB, YB, ZB),
    DX is XB-XA,
    DY is YB-YA,
    DZ is ZB-ZA,
    Length is sqrt(DX*DX + DY*DY + DZ*DZ),
    AX is DX/Length,
    AY is DY/Length,
    AZ is DZ/Length,
    Along = [AX,AY,AZ],
    once(plane(S, P, NX, NY, NZ, _)),
    LX is NY*AZ - NZ*AY,
    LY is NZ*AX - NX*AZ,
    LZ is NX*AY - NY*AX,
    Left = [LX,LY,LZ],
    v(D, WA, X1, Y1, _),
    v(D, WB, X2, Y2, _),
    Flat is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    CX is (X2-X1)/Flat,
    CY is (Y2-Y1)/Flat.

in_frame(frame(point(XA,YA,ZA), [AX,AY,AZ], [LX,LY,LZ], X1-Y1, CX-CY),
         point(X0,Y0,Z0), X-Y) :-
    U is (X0-XA)*AX + (Y0-YA)*AY + (Z0-ZA)*AZ,
    V is (X0-XA)*LX + (Y0-YA)*LY + (Z0-ZA)*LZ,
    X is X1 + U*CX - V*CY,
    Y is Y1 + U*CY + V*CX.


                /*******************************
                *             ROWS             *
                *******************************/

polygon_rounded(D, P, Arcs) :-
    once(p(D, P, Es0)),
    maplist(edge_divided(D, Arcs), Es0, Lists),
    append(Lists, Es),
    retractall_facts(t(D, P, _, _, _, _)),
    retractall_facts(plane(D, P, _, _, _, _)),
    retractall_facts(p(D, P, Es0)),
    assert_fact(p(D, P, Es)),
    forall(member(arc(E, _), Arcs), retractall_facts(e(D, E, _, _, _))).

edge_divided(D, Arcs, E, Es) :-
    (   member(arc(E, Points), Arcs)
    ->  e(D, E, A, B, Et),
        findall(W,
                ( member(X-Y, Points),
                  fresh_id(v, D, W),
                  assert_fact(v(D, W, X, Y, 0.0)) ),
                Ws0),
        append(Ws0, [B], Ws),
        foldl(piece_written(D, E, Et), Ws, A-[], _-Es1),
        reverse(Es1, Es)
    ;   Es = [E]
    ).

piece_written(D, E, Et, W, V-Es, W-[New|Es]) :-
    fresh_id(e, D, New),
    assert_fact(e(D, New, V, W, Et)),
    assert_fact(origin(D, e(New), e(E))).
