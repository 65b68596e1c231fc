:- encoding(utf8).
:- module(test_operand, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(command/check)).
:- use_module(rules(model/integrity)).
:- use_module(rules(kernel)).
:- use_module(rules(solid/operand)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/shells')).
:- use_module(tests('rules/sample')).

/* What makes a segment unfit for a Boolean, what does not, and what `check`
   says of it. */

faults(Shells, Faults) :-
    one_segment(Shells, operand_faults(1, Faults)).

box(A, B, C, X, Y, Z, at([translate(X,Y,Z)], box(size(A,B,C)))).

%   turned(+P): polygon P of segment 1 is turned round.

turned(P) :-
    p(1, P, Es),
    facts_transaction(
        forall(( member(E, Es), e(1, E, A, B, T) ),
               ( retractall_facts(e(1, E, _, _, _)),
                 assert_fact(e(1, E, B, A, T)) ))),
    retractall_facts(t(1, P, _, _, _, _)),
    retractall_facts(plane(1, P, _, _, _, _)),
    complete_segments.

all_turned :-
    findall(P, p(1, P, _), Ps),
    maplist(turned, Ps).

dropped(P) :-
    p(1, P, Es),
    retractall_facts(t(1, P, _, _, _, _)),
    retractall_facts(plane(1, P, _, _, _, _)),
    retractall_facts(p(1, P, _)),
    forall(member(E, Es), retractall_facts(e(1, E, _, _, _))).

defects(Defects) :-
    findall(D, model_defect(D), Defects).

:- begin_tests(operand).

test(fit, F == []) :-
    faults([box(size(1,2,3))], F).
test(shells_are_no_faults, Fs == [[],[],[],[],[]]) :-
    box(2,2,2, 1,1,1, Crossing),
    box(2,2,2, 2,2,0, Edge),
    box(2,2,2, 0,0,2, Lying),
    box(1,1,1, 0,0,0.5, Nested),
    findall(F,
            ( member(B, [Crossing,Edge,Lying,Nested,box(size(2,2,2))]),
              faults([box(size(2,2,2)),B], F) ),
            Fs).
test(no_faces, F == [no_faces]) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, empty)), operand_faults(1, F) )).
test(no_segment, throws(error(existence_error(segment, 9), _))) :-
    faults_of_nothing.

faults_of_nothing :-
    new_world(World),
    in_world(World, operand_faults(9, _)).

test(open, F == 4) :-
    one_segment([box(size(1,1,1))],
                ( dropped(1),
                  operand_faults(1, [open_edges(F, Edges)]) )),
    length(Edges, 4),
    forall(member(edge(V1, V2, [_,_,_], [_,_,_], 1), Edges), V1 < V2).
test(open_named, N-M == 5-6) :-
    one_segment([box(size(1,1,1))],
                ( dropped(1), dropped(6),
                  operand_faults(1, [open_edges(M, Edges)]) )),
    length(Edges, N0),
    N is min(5, N0).
test(turned_polygon, N == 4) :-
    one_segment([box(size(1,1,1))],
                ( turned(2),
                  operand_faults(1, [unbalanced_edges(N, Edges)]) )),
    forall(member(edge(_, _, _, _, 2), Edges), true).
test(both, Names == [open_edges,unbalanced_edges]) :-
    one_segment([box(size(1,1,1))],
                ( dropped(1), turned(6),
                  operand_faults(1, Faults) )),
    findall(Name, ( member(F, Faults), functor(F, Name, _) ), Names).
test(zero_volume, F == [zero_volume]) :-
    one_segment([box(size(1,1,1))],
                ( findall(X-Y-Z-V, v(1, V, X, Y, Z), Vs),
                  facts_transaction(
                      forall(member(X-Y-_-V, Vs),
                             ( retractall_facts(v(1, V, _, _, _)),
                               assert_fact(v(1, V, X, Y, 0.0)) ))),
                  operand_faults(1, F) )).
test(volumes_that_cancel, F == []) :-
    box(1,1,1, 3,0,0, B),
    one_segment([box(size(1,1,1)), B],
                ( numlist(7, 12, Ps),
                  maplist(turned, Ps),
                  operand_faults(1, F) )).
test(inside_out, F == []) :-
    one_segment([box(size(1,1,1))], ( all_turned, operand_faults(1, F) )).
test(kept_until_it_changes, F-G-H == []-4-[]) :-
    one_segment([box(size(1,1,1))],
                ( operand_faults(1, F),
                  facts_snapshot(( dropped(1),
                                   operand_faults(1, [open_edges(G,_)]) )),
                  operand_faults(1, H) )).
test(checked, throws(error(geometry_error(operand(1, [open_edges(4, _)])), _)))
        :-
    one_segment([box(size(1,1,1))], ( dropped(1), checked_operand(1) )).

%   What is seen from the middle, all of it, does not go through itself.

test(star, Stars == [true,true,true,false,false,false]) :-
    box(2,2,2, 1,1,1, Crossing),
    box(1,1,1, 0,0,0.5, Nested),
    findall(Star,
            ( member(Shells, [[box(size(1,2,3))],
                              [sphere(radius(2), facets(20))],
                              [at([rotate(x,33)], cone(radius(1), height(3)))],
                              [torus(radius(3), tube(1))],
                              [box(size(2,2,2)),Crossing],
                              [box(size(2,2,2)),Nested]]),
              one_segment(Shells,
                          segment_operand(1, operand(_,_,_,_,_,Star))) ),
            Stars).
test(star_needs_one_sheet, Star == false) :-
    one_segment([sphere(radius(2), facets(20)), sphere(radius(1), facets(20))],
                segment_operand(1, operand(_,_,true,_,_,Star))).

%   Random polygons turned or dropped: as the edges say when they are counted.

test(as_counted, Bad == []) :-
    findall(Seed, ( numbered(20, 60, Seed), \+ as_counted(Seed) ), Bad).

as_counted(Seed) :-
    set_random(seed(Seed)),
    one_segment([cylinder(radius(1), height(2), facets(7)),
                 at([translate(2,1,1)], box(size(2,2,2)))],
                ( findall(P, p(1, P, _), Ps),
                  forall(member(P, Ps), spoiled(P)),
                  counted(Open, Unbalanced),
                  operand_faults(1, Faults) )),
    findall(N, member(open_edges(N, _), Faults), Opens),
    findall(N, member(unbalanced_edges(N, _), Faults), Unbalanceds),
    listed(Open, Opens),
    listed(Unbalanced, Unbalanceds).

listed(0, []) :-
    !.
listed(N, [N]).

spoiled(P) :-
    random_between(1, 12, N),
    (   N =:= 1
    ->  dropped(P)
    ;   N =:= 2
    ->  turned(P)
    ;   true
    ).

counted(Open, Unbalanced) :-
    findall(A-B, e(1, _, A, B, _), Edges),
    findall(Low-High,
            ( member(A-B, Edges), Low is min(A,B), High is max(A,B) ), Pairs0),
    sort(Pairs0, Pairs),
    aggregate_all(count,
                  ( member(A-B, Pairs), sides(A, B, Edges, N, M), N+M =:= 1 ),
                  Open),
    aggregate_all(count,
                  ( member(A-B, Pairs), sides(A, B, Edges, N, M), N+M > 1,
                    N =\= M ),
                  Unbalanced).

sides(A, B, Edges, N, M) :-
    aggregate_all(count, member(A-B, Edges), N),
    aggregate_all(count, member(B-A, Edges), M).

/* - - - what check says - - - */

test(touching_edge, Ds == [touching_edge]) :-
    %  Two boxes that share an edge, vertices and all.
    box(1,1,1, 1,1,0, B),
    one_segment([box(size(1,1,1)), B],
                ( welded, operand_faults(1, []), defects(Ds0) )),
    findall(Name, ( member(D, Ds0), functor(D, Name, _),
                    Name \== pinched_vertex ), Ds).

test(nested, Ds == [nested_shell(1, 7, 1), nested_shell(1, 13, 2)]) :-
    box(2,2,2, 0,0,0.5, B),
    box(1,1,1, 0,0,1, C),
    one_segment([box(size(3,3,3)), B, C],
                ( findall(D, ( D = nested_shell(_, _, _), model_defect(D) ),
                          Ds) )).
test(hollow, Depths-Turned == [0,1]-[]) :-
    box(1,1,1, 0,0,0.5, B),
    one_segment([box(size(2,2,2)), B],
                ( numlist(7, 12, Ps),
                  maplist(turned, Ps),
                  depths(Depths),
                  findall(P, model_defect(turned_shell(1, P)), Turned) )).
test(turned_shell, Ps == [7]) :-
    box(1,1,1, 5,0,0, B),
    one_segment([box(size(2,2,2)), B],
                ( numlist(7, 12, Turned),
                  maplist(turned, Turned),
                  findall(P, model_defect(turned_shell(1, P)), Ps) )).

depths(Depths) :-
    check_report(Report),
    Report.segments = [Segment],
    findall(Depth, ( member(Shell, Segment.shells), Depth = Shell.depth ),
            Depths).

/* - - - messages - - - */

test(message) :-
    Edge = edge(1, 2, [0.0,0.0,0.0], [1.5,0.0,0.0], 1),
    Faults = [open_edges(1, [Edge]),zero_volume],
    phrase(prolog:message(error(geometry_error(operand(7, Faults)), _)), Lines),
    with_output_to(string(Text),
                   print_message_lines(current_output, '', Lines)),
    forall(member(Part, ["segment 7", "1-2 from (", "1.5", "no volume"]),
           once(sub_string(Text, _, _, _, Part))).

:- end_tests(operand).
