:- module(sg_bend,
          [ pattern_bent/2,             % +D, +Options
            bend_deduction/3,           % +Degrees, +Options, -Deduction
            doubly_curved/3,            % +D, ?P, -Kind
            named_segment/2             % +D, -S
          ]).
:- use_module('../near', [is_bend/1, is_rounding/2]).
:- use_module(bend_corner,
              [ corner_place/5, edge_inward/4, list_to_first/2,
                model_segment/2, of_one_surface/3, polygon_corners/4,
                polygon_of_edge/3
              ]).
:- use_module(corner_relief, [corners_relieved/4, outline_crossings/2]).
:- use_module(flat_faces, [flat_faces_united/1]).
:- use_module('../csg/placed_surface', [facet_surface/3]).
:- use_module('../store',
              [ e/5, from_v/4, joint/6, origin/3, p/3,
                segment/3, t/6, v/5, assert_fact/1, facts_transaction/1,
                fresh_id/3, retract_fact/1, retractall_facts/1
              ]).
:- use_module('../polygon/triangulation', [pattern_completed/1]).
:- use_module('../solid/trimmed', [part_named/2]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc),
              [ empty_assoc/1, gen_assoc/3, get_assoc/3, list_to_assoc/2,
                put_assoc/4
              ]).
:- use_module(library(error), [domain_error/2, must_be/2]).
:- use_module(library(lists), [append/3, member/2, subtract/3]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Folded plates: what bends take off a pattern.

A face of a model ends at a fold; that of a bent plate ends where the bend
begins, and the bend has a length of its own, that of its neutral layer. With A
the angle by which the plate turns, in radians, T its thickness, R the radius
inside the bend and K the K-factor (the neutral layer is K*T from the inside),

    bend allowance   BA = A * (R + K*T)
    setback          SB = tan(A/2) * (R + S)
    bend deduction   BD = 2*SB - BA

S is how far the surface that is drawn is from the inside of the bend: T if it
is outside, T/2 in the middle, 0 inside. A pattern seen from outside of the
solid has what is drawn as `size(outside)` outside of its mountain folds, but
inside of its valley folds. BD may be negative.

Each face loses BD/2 at each of its bends, so the middle of the bend, which is
where the bend line is marked, is the edge that the two faces share. The other
edges of a face stay on their lines; a corner between two bends is taken off on
both sides. Faces keep their polygons and edges; a corner at which faces come
apart gets one vertex for each. Where a hole goes over a fold, its border ends
where it comes out of what the face loses: edges of which nothing is left there
are left out.

@see the textbook forms, as in DIN 6935 and Machinery's Handbook
*/

%!  bend_deduction(+Degrees, +Options, -Deduction) is det.
%
%   Deduction is BD of a fold of Degrees, positive a mountain and negative a
%   valley as in joint/6. Options are those of pattern_bent/2.

bend_deduction(Degrees, Options, Deduction) :-
    plate(Options, T, Size, K, R),
    drawn_at(Size, Degrees, T, K, S),
    A is abs(Degrees)*pi/180.0,
    Deduction is 2.0*tan(A/2.0)*(R + S) - A*(R + K*T).

plate(Options, T, Size, K, R) :-
    option(thickness(T), Options, 0.0),
    not_negative(thickness, T),
    option(size(Size), Options, middle),
    must_be(oneof([inside,middle,outside,neutral]), Size),
    option(k_factor(K), Options, 0.44),
    must_be(between(0.0, 1.0), K),
    option(bend_radius(R), Options, T),
    not_negative(bend_radius, R).

not_negative(What, Number) :-
    must_be(number, Number),
    (   Number >= 0
    ->  true
    ;   domain_error(What, Number)
    ).

drawn_at(middle, _, T, _, S) :-
    S is T/2.0.
drawn_at(neutral, _, T, K, S) :-
    S is K*T.
drawn_at(outside, Degrees, T, _, S) :-
    (   Degrees > 0
    ->  S = T
    ;   S = 0.0
    ).
drawn_at(inside, Degrees, T, _, S) :-
    (   Degrees > 0
    ->  S = 0.0
    ;   S = T
    ).

%!  pattern_bent(+D, +Options) is det.
%
%   Pattern D, flat faces joined by folds, becomes that of a plate. Where folds
%   are no is_bend/1, what they join becomes one polygon. Nothing changes
%   without a thickness. One transaction. Options:
%
%     - thickness(T)
%     - size(Which)
%       `inside`, `middle` (default) or `outside`: the surface of the plate that
%       the model is; `neutral`: the layer that keeps its length. Of an open
%       sheet whose bends all go one way, outside is the outer side of these,
%       whichever side it shows.
%     - bend_radius(R)
%       Inside each bend; default T.
%     - k_factor(K)
%       Default 0.44.
%     - relief(Which)
%       `square` (default), `round` or `none`: what is cut out of corners where
%       two bends meet, see corner_relief/3.
%
%   Where two faces meet in a seam at an angle, both end where the inner sides
%   of their plates meet. Pieces keep their places; they may come nearer to
%   each other by what bends add. Generators of a true development go with the
%   edge or the polygon they lie on.
%
%   @error geometry_error(true(bend(S, P1, P2, Degrees))): the plate of segment
%   S would turn by 170 degrees or more
%   @error geometry_error(true(bent_facet(S, P, Kind, Width))): nor of P, which
%   is a facet of a `sphere` or a `torus`
%   @error geometry_error(true(bend_too_wide(S, P, Width))): of polygon P
%   nothing is left
%   @error geometry_error(true(no_relief(S, P, Wide))): as corners_relieved/4
%   @error geometry_error(true(bent_over(S, P))): what is left of polygon P
%   crosses itself

pattern_bent(D, Options) :-
    plate(Options, T, _, _, _),
    (   T =:= 0
    ->  true
    ;   facts_transaction(sg_bend:bent(D, Options))
    ).

bent(D, Options0) :-
    flat_faces_united(D),
    seen_from(D, Options0, Options),
    findall(bend(E1, E2, P1, P2, Half),
            fold_half(D, Options, E1, E2, P1, P2, Half),
            Bends),
    findall(E-Back, seam_back(D, Options, E, Back), Seams),
    edge_offsets(Bends, Seams, Offsets),
    polygon_shifts(D, Bends, Shifts),
    findall(P, p(D, P, _), Ps),
    empty_assoc(Known),
    foldl(polygon_bent(D, Offsets, Shifts), Ps, corners(Known, []),
          corners(Places, Changes)),
    generator_moves(D, Changes, Places, Shifts, Moves),
    changes_written(Changes, Places, D),
    maplist(generator_moved(D), Moves),
    plate(Options, T, _, K, R),
    option(relief(Relief), Options, square),
    must_be(oneof([square,round,none]), Relief),
    named_segment(D, S),
    Layer is K*T,
    corners_relieved(D, S, plate(R, Layer), Relief),
    (   p(D, P, _),
        \+ t(D, P, _, _, _, _)
    ->  throw(error(geometry_error(true(bent_over(S, P))), _))
    ;   true
    ),
    outline_crossings(D, Count),
    (   Count =:= 0
    ->  true
    ;   print_message(warning, sanggwan(unfold(outline_crosses(S, Count))))
    ).

%   seen_from(D, Options0, Options): the other side of the plate is the outside
%   of an open sheet that only has valley folds.

seen_from(D, Options0, Options) :-
    model_segment(D, S),
    (   segment(S, surface, _),
        joint(D, _, _, _, fold, _),
        \+ ( joint(D, _, _, _, fold, Degrees),
             Degrees > 0.0,
             is_bend(Degrees)
           ),
        option(size(Size), Options0),
        other_side(Size, Other)
    ->  Options = [size(Other)|Options0]
    ;   Options = Options0
    ).

other_side(inside, outside).
other_side(outside, inside).

%   fold_half(D, Options, E1, E2, P1, P2, Half): of all folds; Half is 0.0 where
%   the plate stays flat.

fold_half(D, Options, E1, E2, P1, P2, Half) :-
    joint(D, _, E1, E2, fold, Degrees),
    polygon_of_edge(D, E1, P1),
    polygon_of_edge(D, E2, P2),
    (   \+ is_bend(Degrees)
    ->  Half = 0.0
    ;   abs(Degrees) >= 170.0
    ->  named_segment(D, S),
        throw(error(geometry_error(true(bend(S, P1, P2, Degrees))), _))
    ;   bend_deduction(Degrees, Options, Deduction),
        Half is Deduction/2.0
    ).

%!  named_segment(+D, -S) is det.
%
%   What a user calls the segment of pattern D, in messages.

named_segment(D, S) :-
    model_segment(D, T),
    part_named(T, S).

edge_offsets(Bends, Seams, Offsets) :-
    findall(E-Half,
            ( member(bend(E1, E2, _, _, Half), Bends),
              Half =\= 0.0,
              ( E = E1 ; E = E2 ) ),
            Pairs0),
    append(Pairs0, Seams, Pairs),
    list_to_first(Pairs, Offsets).

%   seam_back(D, Options, E, Back): two plates that meet at an angle do so by
%   the edges of their inner sides: so neither is in the other, and there is a
%   groove for the weld. What is drawn outside of these ends by Back before
%   the edge E. Plates that turn by 170 degrees or more lie on each other;
%   between facets of one smooth surface there is no corner.

seam_back(D, Options, E, Back) :-
    plate(Options, T, Size, K, _),
    joint(D, _, E1, E2, seam, Degrees),
    abs(Degrees) < 170.0,
    \+ of_one_surface(D, E1, E2),
    drawn_at(Size, Degrees, T, K, S),
    Back is S*tan(abs(Degrees)*pi/360.0),
    Back > 0.0,
    ( E = E1 ; E = E2 ).

%   polygon_shifts(D, Bends, Shifts): an assoc from polygons to X-Y, by what
%   they are moved: the smallest of a piece stays.

polygon_shifts(D, Bends, Shifts) :-
    findall(P-fold(E, Q, Half),
            ( member(bend(E1, E2, P1, P2, Half), Bends),
              (   P-E-Q = P1-E1-P2
              ;   P-E-Q = P2-E2-P1
              ) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Neighbours),
    findall(P, p(D, P, _), Ps0),
    sort(Ps0, Ps),
    empty_assoc(Shifts0),
    foldl(piece_shifted(D, Neighbours), Ps, Shifts0, Shifts).

piece_shifted(D, Neighbours, P, Shifts0, Shifts) :-
    (   get_assoc(P, Shifts0, _)
    ->  Shifts = Shifts0
    ;   put_assoc(P, Shifts0, 0.0-0.0, Shifts1),
        shifted_from([P], D, Neighbours, Shifts1, Shifts)
    ).

shifted_from([], _, _, Shifts, Shifts).
shifted_from([P|Ps0], D, Neighbours, Shifts0, Shifts) :-
    (   get_assoc(P, Neighbours, Folds)
    ->  get_assoc(P, Shifts0, Shift),
        foldl(neighbour_shifted(D, Shift), Folds, Ps0-Shifts0, Ps-Shifts1)
    ;   Ps = Ps0,
        Shifts1 = Shifts0
    ),
    shifted_from(Ps, D, Neighbours, Shifts1, Shifts).

%   A neighbour comes nearer by both halves.

neighbour_shifted(D, X0-Y0, fold(E, Q, Half), Ps-Shifts0, Ps1-Shifts) :-
    (   get_assoc(Q, Shifts0, _)
    ->  Ps1 = Ps,
        Shifts = Shifts0
    ;   edge_inward(D, E, NX, NY),
        X is X0 + 2.0*Half*NX,
        Y is Y0 + 2.0*Half*NY,
        put_assoc(Q, Shifts0, X-Y, Shifts),
        Ps1 = [Q|Ps]
    ).

                /*******************************
                *            CORNERS           *
                *******************************/

%   polygon_bent(D, Offsets, Shifts, P, ...): corners(Known, Changes): Known is
%   an assoc from vertices to the places they have already, place(X, Y, W);
%   Changes is a list of change(P, Map), Map from old to new vertices.

polygon_bent(D, Offsets, Shifts, P, corners(Known0, Changes),
             corners(Known, [change(P, Map)|Changes])) :-
    p(D, P, Es),
    !,
    get_assoc(P, Shifts, Shift),
    polygon_corners(D, Offsets, Es, Corners),
    foldl(corner_moved(D, Offsets, Shift), Corners, Known0-[], Known-Pairs0),
    sort(1, @<, Pairs0, Pairs1),
    list_to_assoc(Pairs1, Map),
    sides_kept(D, P, Corners, Offsets).

corner_moved(D, Offsets, SX-SY, Corner, Known0-Pairs0, Known-Pairs) :-
    Corner = corner(V, _, _, Vs),
    corner_place(D, Offsets, Corner, X1, Y1),
    X is X1 + SX,
    Y is Y1 + SY,
    vertex_at(D, V, X, Y, Known0, Known, W),
    findall(V1-W, member(V1, Vs), Here),
    append(Here, Pairs0, Pairs).

%   vertex_at(D, V, X, Y, Known0, Known, W): W is what vertex V is there: itself
%   for the first polygon, and for others if they have it in the same place.

vertex_at(D, V, X, Y, Known0, Known, W) :-
    (   get_assoc(V, Known0, Places)
    ->  (   member(place(X1, Y1, W1), Places),
            is_rounding(max(abs(X-X1), abs(Y-Y1)), 1.0 + abs(X) + abs(Y))
        ->  W = W1,
            Known = Known0
        ;   fresh_id(v, D, W),
            append(Places, [place(X, Y, W)], More),
            put_assoc(V, Known0, More, Known)
        )
    ;   W = V,
        put_assoc(V, Known0, [place(X, Y, V)], Known)
    ).

%   sides_kept(D, P, Corners, Offsets): no side turns round: if it has a length,
%   it is longer than what is taken off at its two ends.

sides_kept(D, P, Corners, Offsets) :-
    findall(E-place(X, Y),
            ( member(Corner, Corners),
              Corner = corner(_, E, _, _),
              corner_place(D, Offsets, Corner, X, Y) ),
            Ends0),
    list_to_first(Ends0, Ends),
    (   member(Corner, Corners),
        Corner = corner(_, _, E, _),
        corner_place(D, Offsets, Corner, X1, Y1),
        get_assoc(E, Ends, place(X2, Y2)),
        side_length(D, E, Length),
        Length > 0.0,
        edge_inward(D, E, NX, NY),
        Left is NY*(X2-X1) - NX*(Y2-Y1),
        Left =< 0.0
    ->  Off is Length-Left,
        named_segment(D, S),
        (   doubly_curved(D, P, Kind)
        ->  What = bent_facet(S, P, Kind, Off)
        ;   What = bend_too_wide(S, P, Off)
        ),
        throw(error(geometry_error(true(What)), _))
    ;   true
    ).

%!  doubly_curved(+D, ?P, -Kind) is nondet.
%
%   True when polygon P of pattern D is a facet of a surface of this Kind,
%   `sphere`, `torus` or `bezier`, that no plate can have by bending.

doubly_curved(D, P, Kind) :-
    model_segment(D, S),
    p(D, P, _),
    facet_surface(S, P, Surface),
    functor(Surface, Kind, _),
    memberchk(Kind, [sphere,torus,bezier]).

side_length(D, E, Length) :-
    once(e(D, E, A, B, _)),
    once(v(D, A, AX, AY, _)),
    once(v(D, B, BX, BY, _)),
    Length is sqrt((BX-AX)**2 + (BY-AY)**2).


                /*******************************
                *             ROWS             *
                *******************************/

%   changes_written(Changes, Known, D): the rows of D after the corners moved. A
%   vertex that is at a corner of another one is none any more.

changes_written(Changes, Known, D) :-
    forall(gen_assoc(V, Known, Places),
           vertex_rewritten(D, V, Places)),
    forall(member(change(P, Map), Changes),
           polygon_rewritten(D, P, Map)),
    forall(( member(change(_, Map), Changes),
             gen_assoc(V, Map, _),
             \+ get_assoc(V, Known, _) ),
           ( retractall_facts(v(D, V, _, _, _)),
             retractall_facts(from_v(D, V, _, _)) )),
    pattern_completed(D).

polygon_rewritten(D, P, Map) :-
    p(D, P, Es),
    !,
    forall(( member(E, Es),
             e(D, E, A0, B0, Et),
             get_assoc(A0, Map, A),
             get_assoc(B0, Map, B),
             A-B \== A0-B0 ),
           ( retract_fact(e(D, E, A0, B0, Et)),
             assert_fact(e(D, E, A, B, Et)) )),
    findall(E, ( member(E, Es), once(e(D, E, V, V, _)) ), Gone),
    (   Gone == []
    ->  findall(T, t(D, P, T, _, _, _), Ts),
        forall(member(T, Ts), triangle_rewritten(D, P, T, Map))
    ;   edges_left_out(D, P, Es, Gone)
    ).

%   edges_left_out(D, P, Es, Gone): polygon P, of the edges Es, has those that
%   are Gone no more, and is divided anew.

edges_left_out(D, P, Es0, Gone) :-
    subtract(Es0, Gone, Es),
    retractall_facts(p(D, P, Es0)),
    assert_fact(p(D, P, Es)),
    forall(member(E, Gone),
           ( retractall_facts(e(D, E, _, _, _)),
             retractall_facts(origin(D, e(E), _)) )),
    retractall_facts(t(D, P, _, _, _, _)),
    retractall_facts(plane(D, P, _, _, _, _)).

triangle_rewritten(D, P, T, Map) :-
    t(D, P, T, A0, B0, C0),
    maplist(mapped(Map), [A0,B0,C0], [A,B,C]),
    (   [A,B,C] == [A0,B0,C0]
    ->  true
    ;   retract_fact(t(D, P, T, A0, B0, C0)),
        assert_fact(t(D, P, T, A, B, C))
    ),
    !.

mapped(Map, V, W) :-
    (   get_assoc(V, Map, W)
    ->  true
    ;   W = V
    ).

vertex_rewritten(D, V, Places) :-
    forall(member(place(X, Y, W), Places),
           (   W == V
           ->  once(( v(D, V, X0, Y0, Z0),
                      retract_fact(v(D, V, X0, Y0, Z0)) )),
               assert_fact(v(D, V, X, Y, 0.0))
           ;   assert_fact(v(D, W, X, Y, 0.0)),
               forall(from_v(D, V, S, V0), assert_fact(from_v(D, W, S, V0)))
           )).


                /*******************************
                *          GENERATORS          *
                *******************************/

%   generator_moves(D, Changes, Known, Shifts, Moves): a move is move(V, X, Y):
%   the end V of a generator goes to X, Y. One that runs along an edge goes
%   where the edge goes, any other with its polygon.

generator_moves(D, Changes, Known, Shifts, Moves) :-
    findall(A-B,
            ( origin(D, e(E), generator(_, _, _, _, _)), e(D, E, A, B, _) ),
            Generators),
    (   Generators == []
    ->  Moves = []
    ;   edge_moves(D, Changes, Known, Edges),
        findall(Move,
                ( member(A-B, Generators),
                  end_moves(D, A, B, Edges, Shifts, Two),
                  member(Move, Two) ),
                Moves)
    ).

%   edge_moves(D, Changes, Known, Edges): an assoc from the places of the ends
%   of each edge, rounded, to the places where they go.

edge_moves(D, Changes, Known, Edges) :-
    findall((P1-P2)-(Q1-Q2),
            ( member(change(P, Map), Changes),
              p(D, P, Es),
              member(E, Es),
              e(D, E, A, B, _),
              end_move(D, A, Map, Known, P1, Q1),
              end_move(D, B, Map, Known, P2, Q2) ),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Edges).

end_move(D, V, Map, Known, Place, X-Y) :-
    rounded_place(D, V, Place),
    get_assoc(V, Map, W),
    get_assoc(V, Known, Places),
    memberchk(place(X, Y, W), Places).

rounded_place(D, V, X-Y) :-
    v(D, V, X0, Y0, _),
    !,
    X is round(X0*1.0e6),
    Y is round(Y0*1.0e6).

end_moves(D, A, B, Edges, Shifts,
          [move(A, X1, Y1),move(B, X2, Y2)]) :-
    rounded_place(D, A, P1),
    rounded_place(D, B, P2),
    (   get_assoc(P1-P2, Edges, (X1-Y1)-(X2-Y2))
    ->  true
    ;   get_assoc(P2-P1, Edges, (X2-Y2)-(X1-Y1))
    ->  true
    ;   v(D, A, XA, YA, _),
        v(D, B, XB, YB, _),
        X is (XA+XB)/2.0,
        Y is (YA+YB)/2.0,
        polygon_at(D, X, Y, P),
        get_assoc(P, Shifts, SX-SY)
    ->  X1 is XA+SX,
        Y1 is YA+SY,
        X2 is XB+SX,
        Y2 is YB+SY
    ;   v(D, A, X1, Y1, _),
        v(D, B, X2, Y2, _)
    ),
    !.

polygon_at(D, X, Y, P) :-
    t(D, P, _, A, B, C),
    left_of(D, A, B, X, Y),
    left_of(D, B, C, X, Y),
    left_of(D, C, A, X, Y),
    !.

left_of(D, A, B, X, Y) :-
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    (X2-X1)*(Y-Y1) - (Y2-Y1)*(X-X1) >= 0.0.

generator_moved(D, move(V, X, Y)) :-
    once(v(D, V, X0, Y0, Z0)),
    retract_fact(v(D, V, X0, Y0, Z0)),
    assert_fact(v(D, V, X, Y, 0.0)).
