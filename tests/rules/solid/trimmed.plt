:- module(test_trimmed, []).
:- use_module(library(plunit)).
:- use_module(rules(sanggwan), except([area/2])).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(solid/closing)).

% Parts that go through each other, each trimmed by the others: what stays
% outside and inside together is the part, and its border is the line.

with_parts(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               call(Goal) )).

area(S, Area) :-
    aggregate_all(sum(A),
                  ( t(S, _, _, A1, B1, C1), corners(S, A1, B1, C1, A) ),
                  Area).

corners(S, V1, V2, V3, Area) :-
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    v(S, V3, X3, Y3, Z3),
    X is (Y2-Y1)*(Z3-Z1) - (Z2-Z1)*(Y3-Y1),
    Y is (Z2-Z1)*(X3-X1) - (X2-X1)*(Z3-Z1),
    Z is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1),
    Area is sqrt(X*X + Y*Y + Z*Z)/2.

border_edges(S, Edges) :-
    findall(V1-V2,
            ( e(S, _, V1, V2, _), \+ e(S, _, V2, V1, _) ),
            Edges).

equal_areas(A, B) :-
    abs(A-B) =< 1.0e-9*max(A, B).

pipe(R, H, N, cylinder(radius(R), height(H), facets(N))).

crossing([A, B]) :-                     % DV-9
    pipe(2, 10, 40, Pipe),
    A = at([translate(0, 0, -5)], Pipe),
    B = at([translate(0, 0, -5), rotate(y, 90)], Pipe).

saddle([A, B]) :-                       % oblique, off the axis
    pipe(3, 12, 40, A),
    pipe(2, 8, 24, Branch),
    B = at([rotate(x, 60), translate(0.5, 0, 6)], Branch).

block([box(size(4, 4, 4)), at([translate(1, 1, 1)], box(size(4, 4, 4)))]).

three([A, B, C]) :-
    crossing([A, B]),
    pipe(1, 10, 16, Pipe),
    C = at([translate(0, 0, -5), rotate(x, 90)], Pipe).

scene(crossing, Terms) :- crossing(Terms).
scene(saddle, Terms) :- saddle(Terms).
scene(block, Terms) :- block(Terms).
scene(three, Terms) :- three(Terms).

both_sides :-
    findall(S, segment(S, _, _), Ss),
    forall(member(S, Ss), both_sides(Ss, S)).

both_sides(Ss, S) :-
    subtract(Ss, [S], Others),
    trimmed(S, Others, outside, T1),
    trimmed(S, Others, inside, T2),
    area(S, A),
    area(T1, A1),
    area(T2, A2),
    A12 is A1+A2,
    equal_areas(A, A12),
    same_line(T1, T2).

% The border of the one is that of the other, turned round.
same_line(T1, T2) :-
    places(T1, forwards, Line1),
    places(T2, backwards, Line2),
    Line1 == Line2.

places(T, Way, Line) :-
    border_edges(T, Edges),
    findall(From-To,
            ( member(V1-V2, Edges),
              place(T, V1, P1),
              place(T, V2, P2),
              (   Way == forwards
              ->  From-To = P1-P2
              ;   From-To = P2-P1
              ) ),
            Line0),
    sort(Line0, Line).

place(T, V, at(X, Y, Z)) :-
    v(T, V, X, Y, Z).

% Each polygon is a piece of the one it names, in the same plane.
pieces_of(S, T) :-
    forall(p(T, P, _),
           ( findall(P0, from_p(T, P, S, P0, 1), [P0]),
             plane(S, P0, Nx, Ny, Nz, _),
             plane(T, P, Mx, My, Mz, _),
             abs(Nx*Mx + Ny*My + Nz*Mz - 1) < 1.0e-9 )).

rows(Rows) :-
    findall(p(S, P, Es), ( member(S, [1,2]), p(S, P, Es) ), Rows).

% A pipe without its ends.
open_pipe(S) :-
    retractall_facts(t(S, 1, _, _, _, _)),
    retractall_facts(t(S, 2, _, _, _, _)),
    retractall_facts(plane(S, 1, _, _, _, _)),
    retractall_facts(plane(S, 2, _, _, _, _)),
    p(S, 1, Es1),
    p(S, 2, Es2),
    retractall_facts(p(S, 1, _)),
    retractall_facts(p(S, 2, _)),
    append(Es1, Es2, Es),
    forall(member(E, Es), retractall_facts(e(S, E, _, _, _))),
    segment(S, _, Name),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, surface, Name)).

without_faces(S, Ps) :-
    forall(member(P, Ps),
           ( p(S, P, Es),
             retractall_facts(t(S, P, _, _, _, _)),
             retractall_facts(plane(S, P, _, _, _, _)),
             retractall_facts(p(S, P, _)),
             forall(member(E, Es), retractall_facts(e(S, E, _, _, _))) )),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, surface, open)).

tmp_rules(Text, File) :-
    tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
    format(Out, '~s~n', [Text]),
    close(Out).

:- begin_tests(trimmed).

test(both_sides, forall(scene(_, Terms))) :-
    with_parts(Terms, both_sides).
test(pieces, forall(scene(_, Terms))) :-
    with_parts(Terms, ( trimmed(1, [2], outside, T), pieces_of(1, T) )).
test(term, Kind-Term == surface-trimmed(2, outside, [1])) :-
    saddle(Terms),
    with_parts(Terms, ( trimmed(2, [1], outside, T), segment(T, Kind, Term) )).
test(from, S == 2) :-
    saddle(Terms),
    with_parts(Terms, ( trimmed(2, [1], outside, T), trimmed_from(T, S) )).
test(world_stays, Before == After) :-
    saddle(Terms),
    with_parts(Terms,
               ( rows(Before), trimmed(2, [1], outside, _), rows(After) )).

% The header has one hole, of as many edges as the end of the branch.
test(saddle_and_hole, N1 == N2) :-
    saddle(Terms),
    with_parts(Terms,
               ( trimmed(1, [2], outside, T1), border_edges(T1, E1),
                 trimmed(2, [1], outside, T2), border_edges(T2, E2) )),
    length(E1, N1),
    length(E2, N2).
test(boxes, A == 69.0) :-               % 6*16 less three times 3*3
    block(Terms),
    with_parts(Terms, ( trimmed(1, [2], outside, T), area(T, A) )).

% What a face lies on: of two that look the same way the first keeps it, of two
% that look at each other none.
flush([box(size(2, 2, 2)), at([translate(1, 0, 0)], box(size(2, 2, 2)))]).
stacked([box(size(2, 2, 2)), at([translate(0, 0, 2)], box(size(2, 2, 2)))]).
standing([ box(size(4, 4, 1)),
           at([translate(0, 0, 1)], cylinder(radius(1), height(2),
                                             facets(12))) ]).

test(flush, A == 32.0) :-               % as the union has
    flush(Terms),
    with_parts(Terms, ( trimmed(1, [2], outside, T1), area(T1, A1),
                        trimmed(2, [1], outside, T2), area(T2, A2) )),
    A0 is A1+A2,
    A is float(round(A0*1.0e6))/1.0e6.
test(stacked, A == 20.0) :-
    stacked(Terms),
    with_parts(Terms, ( trimmed(1, [2], outside, T), area(T, A) )).
test(standing_base_goes, []) :-
    standing(Terms),
    with_parts(Terms, ( trimmed(2, [1], outside, T),
                        \+ from_p(T, _, 2, 1, _),
                        from_p(T, _, 2, 2, _) )).

% Open pipes.
test(open_pipes) :-
    saddle(Terms),
    with_parts(Terms,
               ( open_pipe(1), open_pipe(2),
                 trimmed(2, [1], outside, T2),
                 trimmed(2, [1], inside, T3),
                 area(2, A), area(T2, A2), area(T3, A3),
                 A23 is A2+A3,
                 equal_areas(A, A23),
                 pieces_of(2, T2) )).
test(open_stays_open, Kind == surface) :-
    saddle(Terms),
    with_parts(Terms, ( open_pipe(1), trimmed(2, [1], outside, _),
                        segment(1, Kind, _) )).
test(same_as_closed, A == B) :-
    saddle(Terms),
    with_parts(Terms, ( trimmed(2, [1], outside, T), area(T, A) )),
    with_parts(Terms, ( open_pipe(1), trimmed(2, [1], outside, T4),
                        area(T4, B) )).

% What there is nothing to trim of.
test(apart, T == 1) :-
    with_parts([ box(size(1, 1, 1)),
                 at([translate(5, 0, 0)], box(size(1, 1, 1))) ],
               trimmed(1, [2], outside, T)).
test(nothing_left,
     error(geometry_error(trim(nothing_left(1, outside))))) :-
    with_parts([ box(size(1, 1, 1)),
                 at([translate(0, 0, -1)], box(size(3, 3, 3))) ],
               trimmed(1, [2], outside, _)).
test(curve, error(geometry_error(trim(kind(2, curve))))) :-
    with_parts([ box(size(1, 1, 1)), line(from(0, 0, 0), to(1, 1, 1)) ],
               trimmed(1, [2], outside, _)).
test(no_segment, error(existence_error(segment, 7))) :-
    with_parts([ box(size(1, 1, 1)) ], trimmed(1, [7], outside, _)).
test(no_side, error(type_error(_, within))) :-
    with_parts([ box(size(1, 1, 1)) ], trimmed(1, [], within, _)).

% A border that is not flat: of a box without two faces that meet.
test(not_flat, error(geometry_error(trim(open(2, _, _))))) :-
    block(Terms),
    with_parts(Terms, ( without_faces(2, [1,3]),
                        trimmed(1, [2], outside, _) )).

test(decision, A == 27.0) :-            % the wrong way round
    block(Terms),
    with_parts(Terms,
               ( tmp_rules("stays_trimmed(S, Os, outside, C) :- \c
                            default(stays_trimmed(S, Os, inside, C)).", File),
                 use_rules(File),
                 trimmed(1, [2], outside, T),
                 area(T, A),
                 delete_file(File) )).

:- end_tests(trimmed).
