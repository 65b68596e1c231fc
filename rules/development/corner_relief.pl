:- module(sg_corner_relief,
          [ corners_relieved/4,         % +D, +S, +Plate, +Wished
            outline_crossings/2         % +D, -Count
          ]).
:- use_module('../near', [is_bend/1, is_rounding/2]).
:- use_module('../polygon/triangulation', [pattern_completed/1]).
:- use_module('../store',
              [ e/5, from_v/4, joint/6, origin/3, p/3,
                piece/3, v/5,
                assert_fact/1, fresh_id/3, retract_fact/1, retractall_facts/1
              ]).
:- use_module(bend_corner,
              [list_to_first/2, of_one_surface/3, polygon_of_edge/3]).
:- use_module(corner_cut, [corner_cut/5, crossing/5, place/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc), [assoc_to_keys/2, get_assoc/3]).
:- use_module(library(lists), [append/3, last/2, member/2]).
/** <module> The corners of a bent plate, cut out.

Which corners of a pattern there are, and what its rows are after corner_cut/5
said what is cut out of each; and whether an outline crosses itself.
*/

%!  corners_relieved(+D, +S, +Plate, +Wished) is det.
%
%   The corners of pattern D, which is bent already, are cut out. S is the
%   segment it is called by. Plate is plate(R, Layer): the radius inside the
%   bends, and how far from there the neutral layer is.
%
%   @error geometry_error(true(no_relief(S, P, Wide))): polygon P has no room
%          for what is cut out of a corner, Wide from where the bend lines
%          meet

corners_relieved(D, S, Plate, Wished) :-
    findall(E-Bend, bend_side(D, Plate, E, Bend), Bends0),
    list_to_first(Bends0, Bends),
    findall(Corner,
            ( bent_corner(D, Bends, Corner0),
              corner_cut(D, Bends, Wished, Corner0, Corner) ),
            Corners),
    (   Corners == []
    ->  true
    ;   findall(Generator, generator_on_bend(D, Bends, Generator),
                Generators),
        foldl(corner_cut_out(D, S), Corners, [], Ps0),
        sort(Ps0, Ps),
        maplist(divided_anew(D), Ps),
        maplist(generator_follows(D), Generators),
        pattern_completed(D)
    ).

%   bend_side(D, Plate, E, Bend): edge E is a side of a bend; bend(F, Wide,
%   Degrees): F is the other side, Wide half the allowance.

bend_side(D, plate(R, Layer), E, bend(F, Wide, Degrees)) :-
    joint(D, _, E1, E2, fold, Degrees),
    is_bend(Degrees),
    Wide is abs(Degrees)*pi/360.0*(R + Layer),
    Wide > 0.0,
    ( E = E1, F = E2 ; E = E2, F = E1 ).

                /*******************************
                *            CORNERS           *
                *******************************/

%   bent_corner(D, Bends, Corner) is nondet: corner(Faces, Flange1, Flange2,
%   Kind): Faces lie side by side round a vertex, face(P, In, Out, C): in
%   polygon P the bend In ends and the bend Out begins at vertex C. Beyond the
%   first In is flange(P1, G1, F1): in P1 the edge G1 ends where the fold F1
%   begins; beyond the last Out flange(P2, G2, F2), whose fold F2 ends where
%   G2 begins. Kind is `seam` if G1 and G2 are sides of seams, and not between
%   facets of one smooth surface; else `border`.

bent_corner(D, Bends, corner(Faces, flange(P1, G1, F1), Flange2, Kind)) :-
    assoc_to_keys(Bends, Ins),
    member(In, Ins),
    get_assoc(In, Bends, bend(F1, _, _)),
    polygon_of_edge(D, F1, P1),
    once(e(D, F1, A, _, _)),
    once(( edge_of(D, P1, G1), e(D, G1, _, A, _) )),
    kind_of_end(D, G1, Kind1),
    polygon_of_edge(D, In, P),
    faces_round(D, Bends, P, In, P1, Faces, Flange2),
    Flange2 = flange(_, G2, _),
    kind_of_end(D, G2, Kind2),
    (   Kind1 == Kind2
    ->  Kind = Kind1
    ;   Kind = border
    ).

%   faces_round(D, Bends, P, In, P1, Faces, Flange): from polygon P on, round
%   where its bend In ends, over bends, as far as an edge that is no fold; not
%   back to P1.

faces_round(D, Bends, P, In, P1, [face(P, In, Out, C)|Faces], Flange) :-
    once(e(D, In, _, C, _)),
    once(( edge_of(D, P, Out), e(D, Out, C, _, _) )),
    get_assoc(Out, Bends, bend(F2, _, _)),
    polygon_of_edge(D, F2, P2),
    P2 \== P1,
    once(e(D, F2, _, B, _)),
    once(( edge_of(D, P2, G2), e(D, G2, B, _, _) )),
    (   kind_of_end(D, G2, _)
    ->  Faces = [],
        Flange = flange(P2, G2, F2)
    ;   faces_round(D, Bends, P2, F2, P1, Faces, Flange)
    ).

edge_of(D, P, E) :-
    once(p(D, P, Es)),
    member(E, Es).

kind_of_end(D, E, Kind) :-
    (   ( joint(D, _, E, F, Kind0, _) ; joint(D, _, F, E, Kind0, _) )
    ->  Kind0 \== fold,
        (   Kind0 == seam,
            \+ of_one_surface(D, E, F)
        ->  Kind = seam
        ;   Kind = border
        )
    ;   Kind = border
    ).

                /*******************************
                *             ROWS             *
                *******************************/

%   corner_cut_out(D, S, Wants-Cuts, Ps0, Ps): if nobody wants a relief, and
%   there is no room for what parts two flanges, they stay as they are.

corner_cut_out(D, S, Wants-Cuts, Ps0, Ps) :-
    (   Wants == none,
        member(Cut, Cuts),
        \+ has_room(D, Cut)
    ->  Ps = Ps0
    ;   foldl(end_cut(D, S), Cuts, Ps0, Ps)
    ).

%   has_room(D, Cut): the edges of Cut are longer than what is cut off.

has_room(D, cut(_, E1, E2, Places, _)) :-
    Places = [First|_],
    last(Places, Last),
    maplist(known_place(D), [First,Last], [X1-Y1,X2-Y2]),
    once(e(D, E1, A1, B1, _)),
    once(e(D, E2, A2, B2, _)),
    maplist(place(D), [A1,B1,A2,B2], [XA1-YA1,XB1-YB1,XA2-YA2,XB2-YB2]),
    (X1-XA1)*(XB1-XA1) + (Y1-YA1)*(YB1-YA1) > 0.0,
    (XB2-X2)*(XB2-XA2) + (YB2-Y2)*(YB2-YA2) > 0.0.

known_place(_, at(Place), Place).
known_place(D, vertex(V), Place) :-
    place(D, V, Place).

%   end_cut(D, S, Cut, Ps0, Ps): Ps are the polygons Ps0 and that of Cut.
%   Where a place is that of an end of the fold on the other side it is the
%   same vertex, so that the fold has no step there.

end_cut(_, S, no_room(P, Wide), _, _) :-
    throw(error(geometry_error(true(no_relief(S, P, Wide))), _)).
end_cut(D, S, cut(P, E1, E2, Places, V), Ps, [P|Ps]) :-
    maplist(place_vertex(D, V, E1-E2), Places, Vs),
    Vs = [First|_],
    last(Vs, Last),
    end_moved(D, S, P, E1, end, First),
    end_moved(D, S, P, E2, start, Last),
    edges_through(Vs, D, Es),
    (   Es == []
    ->  true
    ;   once(p(D, P, Es0)),
        append(Es0, Es, Es1),
        retractall_facts(p(D, P, Es0)),
        assert_fact(p(D, P, Es1))
    ),
    vertex_left(D, V).

place_vertex(_, _, _, vertex(W), W) :-
    !.
place_vertex(D, V, E1-E2, at(X-Y), W) :-
    (   ( E = E1 ; E = E2 ),
        other_side(D, E, F),
        e(D, F, A, B, _),
        ( W = A ; W = B ),
        v(D, W, X1, Y1, _),
        is_rounding(max(abs(X-X1), abs(Y-Y1)), 1.0 + abs(X) + abs(Y))
    ->  true
    ;   fresh_id(v, D, W),
        assert_fact(v(D, W, X, Y, 0.0)),
        forall(from_v(D, V, S, V0), assert_fact(from_v(D, W, S, V0)))
    ).

other_side(D, E, F) :-
    joint(D, _, E, F, fold, _).
other_side(D, E, F) :-
    joint(D, _, F, E, fold, _).

%   end_moved(D, S, P, E, Which, W): edge E ends or begins at W; it goes the
%   same way as before.

end_moved(D, S, P, E, Which, W) :-
    once(e(D, E, A0, B0, Et)),
    (   Which == end
    ->  A = A0, B = W
    ;   A = W, B = B0
    ),
    maplist(place(D), [A0,B0,A,B], [XA0-YA0,XB0-YB0,XA-YA,XB-YB]),
    Length is sqrt((XB0-XA0)**2 + (YB0-YA0)**2),
    Left is ((XB-XA)*(XB0-XA0) + (YB-YA)*(YB0-YA0))/max(Length, 1.0e-300),
    (   Left > 0.0
    ->  true
    ;   Wide is Length-Left,
        throw(error(geometry_error(true(no_relief(S, P, Wide))), _))
    ),
    (   A-B == A0-B0
    ->  true
    ;   retract_fact(e(D, E, A0, B0, Et)),
        assert_fact(e(D, E, A, B, Et))
    ).

edges_through([A,B|Vs], D, [E|Es]) :-
    !,
    fresh_id(e, D, E),
    assert_fact(e(D, E, A, B, 1)),
    edges_through([B|Vs], D, Es).
edges_through(_, _, []).

vertex_left(D, V) :-
    (   ( e(D, _, V, _, _) ; e(D, _, _, V, _) )
    ->  true
    ;   retractall_facts(v(D, V, _, _, _)),
        retractall_facts(from_v(D, V, _, _))
    ).

divided_anew(D, P) :-
    retractall_facts(t(D, P, _, _, _, _)),
    retractall_facts(plane(D, P, _, _, _, _)).

%   generator_on_bend(D, Bends, Generator) is nondet: generator(A, B, E, V,
%   W): a generator from A to B runs along the bend E, from its vertex V to W.

generator_on_bend(D, Bends, generator(A, B, E)) :-
    origin(D, e(G), generator(_, _, _, _, _)),
    e(D, G, A, B, _),
    place(D, A, AtA),
    place(D, B, AtB),
    assoc_to_keys(Bends, Es),
    member(E, Es),
    once(e(D, E, V, W, _)),
    place(D, V, AtV),
    same_place(AtA, AtV),
    place(D, W, AtW),
    same_place(AtB, AtW).

same_place(X1-Y1, X2-Y2) :-
    is_rounding(max(abs(X1-X2), abs(Y1-Y2)), 1.0 + abs(X1) + abs(Y1)).

generator_follows(D, generator(A, B, E)) :-
    once(e(D, E, V, W, _)),
    moved_to(D, A, V),
    moved_to(D, B, W).

moved_to(D, A, V) :-
    place(D, V, X-Y),
    retractall_facts(v(D, A, _, _, _)),
    assert_fact(v(D, A, X, Y, 0.0)).

%!  outline_crossings(+D, -Count) is det.
%
%   Count says how often sides of pattern D that are no folds, and the steps at
%   the ends of folds, cross others of the same piece.

outline_crossings(D, Count) :-
    findall(side(K, X1, X2, A, B),
            ( cut_side(D, K, A, B),
              A = XA-_,
              B = XB-_,
              X1 is min(XA, XB),
              X2 is max(XA, XB) ),
            Sides0),
    msort(Sides0, Sides),
    crossings(Sides, 0, Count).

cut_side(D, K, A, B) :-
    p(D, P, Es),
    piece(D, P, K),
    member(E, Es),
    e(D, E, V, W, 1),
    kind_of_end(D, E, _),
    place(D, V, A),
    place(D, W, B).
cut_side(D, K, A, B) :-
    joint(D, _, E, F, fold, _),
    once(e(D, E, V1, W1, _)),
    once(e(D, F, V2, W2, _)),
    ( V = V1, W = W2 ; V = V2, W = W1 ),
    V \== W,
    place(D, V, A),
    place(D, W, B),
    \+ same_place(A, B),
    polygon_of_edge(D, E, P),
    piece(D, P, K).

crossings([], Count, Count).
crossings([side(K, _, X2, A, B)|Sides], Count0, Count) :-
    aggregate_all(count,
                  ( side_before(Sides, K, X2, C, D),
                    crossing(A, B, C, D, _) ),
                  N),
    Count1 is Count0 + N,
    crossings(Sides, Count1, Count).

side_before([side(K, X1, _, A, B)|Sides], K, X2, C, D) :-
    X1 < X2,
    (   C = A,
        D = B
    ;   side_before(Sides, K, X2, C, D)
    ).
