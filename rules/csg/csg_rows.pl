:- module(sg_csg_rows,
          [ copy_segments/3,            % +Ss, +Matrix, +S
            copied_by_rule/3,           % +Ss, +Matrix, +S
            drop_boundary/1,            % +S
            drop_pictures/1,            % +S
            drop_views/1,               % +S
            was_cut/1,                  % +S
            segment_box/2               % +S, -Box
          ]).
:- use_module(csg_matrix, [matrix_scale/2, matrix_sign/2]).
:- use_module('../kernel',
              [ solid_take/2, solid_move/3, solid_write/2, solid_close/1,
                node_origins/2
              ]).
:- use_module(leaf, [were_cut/2, leaves_restored/1]).
:- use_module(source, [source_kept/3]).
:- use_module('../store',
              [ v/5, e/5, p/3, leaf_v/5, leaf_e/5, leaf_p/3, origin/3, line/9,
                assert_fact/1, retractall_facts/1
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [is_set/1, member/2, reverse/2]).
/** <module> Rows of segments that evaluation copies and drops.
*/

%!  copy_segments(+Ss:list, +Matrix, +S) is det.
%
%   Give segment S, which has no rows, those of the segments Ss, moved by Matrix
%   (three rows of four floats), with from_v/4 and from_p/5; polygons that have
%   no triangles may be left out. What a penetration cut is copied as it was
%   before. If Matrix mirrors, polygons turn round, so that outside stays
%   outside. Inexact: places are rounded. S is as coarse as the coarsest of Ss
%   (source.pl).

copy_segments(Ss, Matrix, S) :-
    segments_copied(Ss, Matrix, S),
    matrix_scale(Matrix, Scale),
    source_kept(Ss, Scale, S).

segments_copied(Ss, Matrix, S) :-
    (   is_set(Ss),
        \+ ( member(S0, Ss), was_changed(S0) ),
        solid_take(Ss, Solid)
    ->  call_cleanup(( solid_move(Solid, Matrix, Again)
                     ->  solid_write(Solid, S),
                         triangulated_again(S, Again)
                     ;   copied_by_rule(Ss, Matrix, S)
                     ),
                     solid_close(Solid))
    ;   copied_by_rule(Ss, Matrix, S)
    ).

triangulated_again(_, []) :-
    !.
triangulated_again(S, Ps) :-
    forall(member(P, Ps), retractall_facts(t(S, P, _, _, _, _))),
    complete_segments([S]).

%!  copied_by_rule(+Ss:list, +Matrix, +S) is det.
%
%   What copy_segments/3 does, row by row.

copied_by_rule(Ss, Matrix, S) :-
    forall(member(S0, Ss), copy_segment(S0, Matrix, S)),
    complete_segments([S]).

%   copy_segment(S0, Matrix, S): numbered on from what S has.

copy_segment(S0, Matrix, S) :-
    greatest(V, v(S, V, _, _, _), DV),
    greatest(E, e(S, E, _, _, _), DE),
    greatest(P, p(S, P, _), DP),
    matrix_sign(Matrix, Sign),
    forall(uncut_vertex(S0, V0, Point0),
           vertex_copied(S0, V0, Point0, Matrix, DV, S)),
    forall(uncut_edge(S0, E0, V1, V2, Et),
           edge_copied(Sign, E0, V1, V2, Et, DV, DE, S)),
    forall(uncut_polygon(S0, P0, Es),
           polygon_copied(Sign, S0, P0, Es, DE, DP, S)).

:- meta_predicate greatest(?, 0, -).

greatest(N, Goal, Greatest) :-
    (   aggregate_all(max(N), Goal, Greatest0)
    ->  Greatest = Greatest0
    ;   Greatest = 0
    ).

uncut_vertex(S, V, point(X, Y, Z)) :-
    (   once(origin(S, v(_), _))
    ->  v(S, V, X1, Y1, Z1),
        (   leaf_v(S, V, X, Y, Z)
        ->  true
        ;   \+ cut_made(S, V),
            X-Y-Z = X1-Y1-Z1
        )
    ;   v(S, V, X, Y, Z)
    ).

%   cut_made(S, V): V has an origin and no edge of the leaves ends there.

cut_made(S, V) :-
    origin(S, v(V), _),
    \+ ( uncut_edge(S, _, V1, V2, _),
         ( V == V1 ; V == V2 ) ).

uncut_edge(S, E, V1, V2, Et) :-
    leaf_e(S, E, V1, V2, Et).
uncut_edge(S, E, V1, V2, Et) :-
    e(S, E, V1, V2, Et),
    \+ leaf_e(S, E, _, _, _),
    \+ origin(S, e(E), _).

uncut_polygon(S, P, Es) :-
    p(S, P, Es0),
    (   leaf_p(S, P, Es1)
    ->  Es = Es1
    ;   Es = Es0
    ).

vertex_copied(S0, V0, Point0, Matrix, DV, S) :-
    V is V0+DV,
    moved_point(Matrix, Point0, X, Y, Z),
    assert_fact(v(S, V, X, Y, Z)),
    assert_fact(from_v(S, V, S0, V0)).

moved_point([A,B,C], point(X0, Y0, Z0), X, Y, Z) :-
    row_times(A, X0, Y0, Z0, X),
    row_times(B, X0, Y0, Z0, Y),
    row_times(C, X0, Y0, Z0, Z).

row_times([A,B,C,D], X, Y, Z, W) :-
    W is A*X + B*Y + C*Z + D + 0.0.

edge_copied(Sign, E0, V1, V2, Et, DV, DE, S) :-
    E is E0+DE,
    A is V1+DV,
    B is V2+DV,
    (   Sign < 0
    ->  assert_fact(e(S, E, B, A, Et))
    ;   assert_fact(e(S, E, A, B, Et))
    ).

polygon_copied(Sign, S0, P0, Es0, DE, DP, S) :-
    P is P0+DP,
    maplist(plus(DE), Es0, Es1),
    (   Sign < 0
    ->  reverse(Es1, Es)
    ;   Es = Es1
    ),
    assert_fact(p(S, P, Es)),
    assert_fact(from_p(S, P, S0, P0, 1)).

%!  drop_boundary(+S) is det.
%
%   Take away all rows of segment S but segment/3 and what says that it is a
%   node or a helper. What it cut, or was cut by, is as before the cuts.

drop_boundary(S) :-
    (   was_cut(S)
    ->  findall(S1-S2, ( were_cut(S1, S2), ( S1 == S ; S2 == S ) ), Pairs0),
        sort(Pairs0, Pairs),
        leaves_restored(Pairs)
    ;   true
    ),
    drop_pictures(S),
    retractall_facts(line(_, S, _, _, _, _, _, _, _)),
    retractall_facts(line(_, _, _, _, _, S, _, _, _)),
    retractall_facts(from_v(S, _, _, _)),
    retractall_facts(from_p(S, _, _, _, _)),
    retractall_facts(leaf_t(S, _, _, _, _, _)),
    retractall_facts(leaf_p(S, _, _)),
    retractall_facts(leaf_e(S, _, _, _, _)),
    retractall_facts(leaf_v(S, _, _, _, _)),
    retractall_facts(t(S, _, _, _, _, _)),
    retractall_facts(plane(S, _, _, _, _, _)),
    retractall_facts(p(S, _, _)),
    retractall_facts(e(S, _, _, _, _)),
    retractall_facts(v(S, _, _, _, _)),
    node_origins(S, Origins),
    retractall_facts(origin(S, _, _)),
    forall(member(Item-Origin, Origins),
           assert_fact(origin(S, Item, Origin))).

%!  drop_pictures(+S) is det.
%
%   Take away the rows of segment S that were made from its boundary, as it was:
%   pictures, joints and regions.

drop_pictures(S) :-
    drop_views(S),
    retractall_facts(sides(S, _, _, _)),
    retractall_facts(lies_in(S, _, _)),
    retractall_facts(from_r(S, _, _, _)),
    retractall_facts(region(S, _, _)).

%!  drop_views(+S) is det.
%
%   The same, but regions stay.

drop_views(S) :-
    retractall_facts(drawn(_, S, _, _, _, _, _)),
    retractall_facts(joint(S, _, _, _, _, _)),
    retractall_facts(piece(S, _, _)),
    retractall_facts(contour(S, _, _, _, _, _, _, _, _, _, _, _, _)),
    retractall_facts(surface_facing(S, _, _, _, _, _)),
    retractall_facts(screen(S, _, _, _, _)).

was_changed(S) :-
    (   was_cut(S)
    ->  true
    ;   leaf_v(S, _, _, _, _)
    ->  true
    ).

%!  was_cut(+S) is semidet.
%
%   True when a penetration cut segment S, or ran along its edges: then it may
%   have lines though its rows are as they were.

was_cut(S) :-
    leaf_p(S, _, _),
    !.
was_cut(S) :-
    leaf_e(S, _, _, _, _),
    !.
was_cut(S) :-
    line(_, S, _, _, _, _, _, _, _),
    !.
was_cut(S) :-
    line(_, _, _, _, _, S, _, _, _),
    !.

%!  segment_box(+S, -Box) is semidet.
%
%   Box is box(X1, Y1, Z1, X2, Y2, Z2) round the vertices of segment S. Fails if
%   it has none.

segment_box(S, box(X1, Y1, Z1, X2, Y2, Z2)) :-
    aggregate_all(r(min(X), min(Y), min(Z), max(X), max(Y), max(Z)),
                  v(S, _, X, Y, Z),
                  r(X1, Y1, Z1, X2, Y2, Z2)),
    number(X1),
    X1 =< X2.
