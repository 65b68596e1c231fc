:- module(test_penetration, []).
% covers: bodies
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(time)).
:- use_module(rules(decision)).
:- use_module(rules(store)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(kernel),
              [ cut_set_open/2, cut_set_close/1, cut_candidate/3, cut_side/4,
                cut_find/1, cut_seal/1
              ]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests(rules/penetration_fault), [faults/1, penetration_fault/1]).
:- use_module(tests('oracle/cut')).

/* Penetration lines: closed forms, contacts of every kind, and what must hold
   of every model afterwards, on seeded random solids on a coarse grid, where
   most contacts are degenerate. */

%   penetrated(+Primitives, :Goal): Goal holds in a new world with these
%   primitives, penetrated.

:- meta_predicate penetrated(+, 0).

penetrated(Primitives, Goal) :-
    new_world(World),
    in_world(World,
             ( penetrated_here(Primitives), Goal )).

penetrated_here(Primitives) :-
    forall(member(Primitive, Primitives), add_primitive(Primitive, _)),
    complete_segments,
    penetrate.

%   with_rules(+Text, :Goal): in a new world that follows the rules in Text.

:- meta_predicate with_rules(+, 0).

with_rules(Text, Goal) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
        write(Out, Text), close(Out)),
    new_world(World),
    in_world(World, ( use_rules(File), Goal )),
    delete_file(File).

box(A, B, C, X, Y, Z, at([translate(X,Y,Z)], box(size(A,B,C)))).

shape(Shape) :-
    chains(Chains),
    findall(Kind-Length,
            ( member(chain(_, _, Kind, Lines), Chains),
              chain_length(Lines, Length0),
              Length is round(Length0*1.0e6)/1.0e6
            ),
            Shape0),
    msort(Shape0, Shape).

solids(Primitives, Shape-Faults) :-
    penetrated(Primitives, ( shape(Shape), faults(Faults) )).

:- begin_tests(penetration).

test(apart, R == []-[]) :-
    box(2,2,2, 9,0,0, B),
    solids([box(size(2,2,2)), B], R).
test(corner_in, R == [closed-6.0]-[]) :-
    box(2,2,2, 1,1,1, B),
    solids([box(size(2,2,2)), B], R).
test(bar_through, R == [closed-4.0,closed-4.0]-[]) :-
    box(1,1,4, 0,0,-1, B),
    solids([box(size(2,2,2)), B], R).
test(inside, R == []-[]) :-
    box(1,1,1, 0,0,0.5, B),
    solids([box(size(2,2,2)), B], R).

% Contacts.
test(standing_on, R == [closed-4.0]-[]) :-
    box(1,1,1, 0,0,2, B),
    solids([box(size(2,2,2)), B], R).
test(standing_in_the_corner, R == [closed-4.0]-[]) :-
    box(1,1,1, 0.5,0.5,2, B),
    solids([box(size(2,2,2)), B], R).
test(hanging_over, R == [closed-6.0]-[]) :-
    box(2,2,2, 1,0,2, B),
    solids([box(size(2,2,2)), B], R).
test(shared_face, R == [closed-8.0]-[]) :-
    box(2,2,2, 2,0,0, B),
    solids([box(size(2,2,2)), B], R).
test(shared_edge, R == [open-2.0]-[]) :-
    box(2,2,2, 2,2,0, B),
    solids([box(size(2,2,2)), B], R).
test(part_of_an_edge, R == [open-1.0]-[]) :-
    box(2,2,2, 2,2,1, B),
    solids([box(size(2,2,2)), B], R).
test(shared_vertex, R == [point-0.0]-[]) :-
    box(2,2,2, 2,2,2, B),
    solids([box(size(2,2,2)), B], R).
% Contacts in a point alone: an edge is split where it is touched, a face gets
% a vertex that is named by its origin and nothing else.
test(vertex_on_vertex, R == at([point-0.0]-[], [], 0)) :-
    tip_at(1, 1, R).
test(vertex_on_edge, R == at([point-0.0]-[], [1-v], 4)) :-
    tip_at(0, 1, R).
test(vertex_on_face, R == at([point-0.0]-[], [1-v], 0)) :-
    tip_at(0.25, 0.125, R).
test(edge_on_edge, R == at([point-0.0]-[], [1-ll,2-ll], 4)) :-
    new_world(World),
    in_world(World,
             ( triangle(1, [(-1)-0-0, 1-0-0, 0-0-(-1)]),
               triangle(2, [0-(-1)-0, 0-1-0, 0-0-1]),
               complete_segments,
               penetrate,
               touching(R) )).

% Contacts of several pairs in one place, and of one pair in several.
test(contacts, Ks == [1-2-point,1-3-point,1-4-point,2-3-point]) :-
    Tip = at([rotate(x,180)], pyramid(base(1,1), height(1))),
    penetrated([at([translate(0,0,-2)], rectangle(size(4,4))),
                at([translate(-1,0,-1)], Tip),
                at([translate(-1,0,-3)], pyramid(base(1,1), height(1))),
                at([translate(1,0,-1)], Tip)],
               ( chains(Cs),
                 findall(S1-S2-K, member(chain(S1,S2,K,_), Cs), Ks),
                 faults([]) )).

% The chains before anything enters know them too.
test(contact_chain,
     Chains == [chain(1, 2, point, [point(0.25,0.125,2.0,v(2,5))], [2-2])]) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(2,2,2)), _),
               add_primitive(at([rotate(x,180),translate(0.25,0.125,3)],
                                pyramid(base(1,1), height(1))), _),
               complete_segments,
               penetration_chains(Chains) )).

%   tip_at(+X, +Y, -At): a pyramid stands on its tip on a box of 2, at X, Y.

tip_at(X, Y, At) :-
    Tip = at([rotate(x,180),translate(X,Y,3)], pyramid(base(1,1), height(1))),
    penetrated([box(size(2,2,2)), Tip], touching(At)).

%   touching(-At): the chains and faults, the origins of vertices, and how many
%   edges have them.

touching(at(Shape-Faults, Origins, Edges)) :-
    shape(Shape),
    faults(Faults),
    findall(S-Made, ( origin(S, v(_), O), functor(O, Made, _) ), Origins0),
    msort(Origins0, Origins),
    aggregate_all(count,
                  ( origin(S, v(V), _), ( e(S,_,V,_,_) ; e(S,_,_,V,_) ) ),
                  Edges).

test(edge_on_face, Faults == []) :-
    Prism = at([rotate(y,45),translate(0,0,2+sqrt(2))], box(size(2,1,2))),
    catch(solids([box(size(2,2,2)), Prism], _-Faults), _, Faults = []).
test(identical, S-F == 24.0-[]) :-
    penetrated([box(size(2,2,2)), box(size(2,2,2))],
               ( aggregate_all(sum(L),
                               ( line(N,_,_,_,_,_,_,_,_),
                                 chain_length([N], L) ), S),
                 faults(F) )).

% Surfaces.
test(square_on_square, R == [closed-4.0]-[]) :-
    box_free(1, 1, 0, 0, 0, Small),
    solids([rectangle(size(2,2)), Small], R).
test(squares_overlap, F == []) :-
    box_free(2, 2, 1, 1, 0, Other),
    solids([rectangle(size(2,2)), Other], _-F).
test(squares_cross, R == [open-2.0]-[]) :-
    solids([rectangle(size(2,2)),
            at([rotate(x,90)], rectangle(size(2,2)))], R).
test(square_touches_edge, F == []) :-
    solids([rectangle(size(2,2)),
            at([rotate(x,90),translate(0,1,1)], rectangle(size(2,2)))],
           _-F).
% Four squares as in figure 9; three of them meet in one point, which is not
% on a chord: a vertex in all three, made by three planes.
test(squares_meet_in_a_point, F-(V-T) == []-(3-3)) :-
    penetrated([rectangle(size(2,2)),
                at([rotate(x,90),translate(0,0.25,0.1)],
                   rectangle(size(2,2))),
                at([rotate(y,90),translate(-0.125,0,0.1)],
                   rectangle(size(2,2)))],
               ( faults(F),
                 aggregate_all(count, v(_,_,-0.125,0.25,0.0), V),
                 aggregate_all(count, origin(_,v(_),tpi(_,_,_)), T) )).
test(four_squares, F-Ls == []-[]) :-
    penetrated([rectangle(size(2, 2)),
                at([rotate(x, 90), translate(0, 0.25, 0.1)],
                   rectangle(size(2, 2))),
                at([rotate(y, 90), translate(-0.25, 0, 0.1)],
                   rectangle(size(2, 2))),
                at([rotate(x, 35), rotate(z, 25), translate(0.2, -0.1, 0.2)],
                   rectangle(size(2, 2)))],
               ( faults(F),
                 findall(S1-S2,
                         ( member(S1-S2, [1-2,1-3,1-4,2-3,2-4,3-4]),
                           \+ line(_,S1,_,_,_,S2,_,_,_) ), Ls) )).

box_free(A, B, X, Y, Z, at([translate(X,Y,Z)], rectangle(size(A,B)))).

test(again_changes_nothing, Before == After) :-
    box(2,2,2, 1,1,1, B),
    penetrated([box(size(2,2,2)), B],
               ( findall(x(L,A,C), line(L,_,_,A,C,_,_,_,_), Before),
                 penetrate,
                 findall(x(L,A,C), line(L,_,_,A,C,_,_,_,_), After) )).

% A polygon whose hole touches its outer loop in the middle of an edge.
test(touching_hole, F-Ls == []-[closed]) :-
    new_world(World),
    in_world(World,
             ( hollow,
               add_primitive(at([translate(1.5,1,-1)], box(size(0.5,0.5,2))),
                             _),
               complete_segments,
               penetrate,
               chains(Cs),
               findall(K, member(chain(_,_,K,_), Cs), Ls),
               findall(X, ( penetration_fault(X), X \= area(_,_,_,_) ), F) )).

hollow :-
    assert_fact(segment(1, surface, hollow)),
    forall(nth1(V, [0-0, 2-0, 2-2, 0-2, 1-0, 0.5-1, 1-1.25], X-Y),
           ( Xf is float(X), Yf is float(Y),
             assert_fact(v(1, V, Xf, Yf, 0.0)) )),
    forall(nth1(E, [1-2,2-3,3-4,4-1,5-6,6-7,7-5], A-B),
           assert_fact(e(1, E, A, B, 1))),
    assert_fact(p(1, 1, [1,2,3,4,5,6,7])).

% One operation: one step back, and nothing when it is stopped.
test(undone, After == Before) :-
    box(2,2,2, 1,1,1, B),
    new_world(World),
    in_world(World,
             ( facts_transaction(
                   ( add_primitive(box(size(2,2,2)), _),
                     add_primitive(B, _),
                     complete_segments )),
               everything(Before),
               penetrate,
               everything(Between),
               facts_undo,
               everything(After) )),
    Between \== Before.
test(stopped, After == Before) :-
    Pipe = cylinder(radius(1), height(4), facets(3000)),
    new_world(World),
    in_world(World,
             ( add_primitive(Pipe, _),
               add_primitive(at([rotate(x,90),translate(0.1,2,2)], Pipe), _),
               complete_segments,
               everything(Before),
               catch(call_with_time_limit(0.1, penetrate),
                     time_limit_exceeded, true),
               everything(After) )).

everything(All) :-
    findall(S-V, v(S, V, _, _, _), Vs),
    findall(e(S, E, A, B), e(S, E, A, B, _), Es),
    findall(p(S, P, Ps), p(S, P, Ps), Ps0),
    findall(t(S, P, A, B, C), t(S, P, _, A, B, C), Ts),
    findall(S-I, origin(S, I, _), Os),
    findall(L, line(L, _, _, _, _, _, _, _, _), Ls),
    All0 = [Vs, Es, Ps0, Ts, Os, Ls],
    maplist(msort, All0, All).

% Doors and errors.
test(triangle_cut, Cuts == [cut(crossing, edge(1,2)-edge(1,2),
                                edge(2,3)-face(1))]) :-
    new_world(World),
    in_world(World,
             ( triangle(1, [0-(-1)-(-1), 0-1-1, 0-1-(-1)]),
               triangle(2, [(-1)-0-0, 1-0-0, 0-5-0]),
               findall(cut(K, A, B), triangle_cut(1-1, 2-1, K, A, B), Cuts0)
             )),
    maplist(by_features, Cuts0, Cuts).
test(no_triangle_cut, fail) :-
    new_world(World),
    in_world(World,
             ( triangle(1, [0-0-0, 1-0-0, 0-1-0]),
               triangle(2, [0-0-9, 1-0-9, 0-1-9]),
               triangle_cut(1-1, 2-1, _, _, _) )).
test(no_set, error(type_error(cut_set, foo))) :-
    cut_seal(foo).
test(closed_set, error(existence_error(cut_set, _))) :-
    new_world(World),
    in_world(World, ( cut_set_open([], Set), cut_set_close(Set),
                      cut_seal(Set) )).
% A set that is closed while another thread looks for cuts is freed behind that
% call.
test(closed_meanwhile,
     [condition(current_prolog_flag(threads, true)), Bad == []]) :-
    new_world(World),
    in_world(World,
             ( Cylinder = cylinder(radius(1), height(4), facets(800)),
               add_primitive(Cylinder, _),
               add_primitive(at([rotate(x, 90)], Cylinder), _),
               complete_segments,
               findall(Status, ( between(1, 20, I),
                                 found_meanwhile(I, Status) ), All) )),
    findall(Status, ( member(Status, All), \+ may_end(Status) ), Bad).
test(no_pairs, error(type_error(pair, 1))) :-
    new_world(World),
    in_world(World, cut_set_open([1], _)).
test(no_options, error(type_error(list, 2))) :-
    new_world(World),
    in_world(World, penetrate([1-2], 2)).
test(no_list, error(type_error(list, x))) :-
    new_world(World),
    in_world(World, cut_set_open(x, _)).
test(unknown_triangle, error(existence_error(cut_triangle, 0))) :-
    new_world(World),
    in_world(World, ( cut_set_open([], Set), cut_side(Set, 0, 0, _) )).
test(empty_world, true) :-
    new_world(World),
    in_world(World, penetrate).
test(no_candidates, fail) :-
    new_world(World),
    in_world(World, ( cut_set_open([1-2], Set), cut_candidate(Set, _, _) )).

found_meanwhile(I, Status) :-
    cut_set_open([1-2], Set),
    thread_create(cut_find(Set), Thread),
    Pause is I*0.0002,
    sleep(Pause),
    cut_set_close(Set),
    thread_join(Thread, Status).

may_end(true).
may_end(exception(error(existence_error(cut_set, _), _))).

triangle(S, Points) :-
    assert_fact(segment(S, surface, triangle)),
    forall(nth1(V, Points, X0-Y0-Z0),
           ( X is float(X0), Y is float(Y0), Z is float(Z0),
             assert_fact(v(S, V, X, Y, Z)) )),
    forall(nth1(E, [1-2,2-3,3-1], A-B), assert_fact(e(S, E, A, B, 1))),
    assert_fact(p(S, 1, [1,2,3])),
    assert_fact(t(S, 1, 1, 1, 2, 3)).

by_features(cut(K, A, B), cut(K, C, D)) :-
    msort([A,B], [C,D]).

% Decisions.
test(nothing_is_merged, F-More == []-true) :-
    box(1,1,1, 0.25,0,2, B),
    with_rules("merge_line(_, _) :- fail.",
               ( penetrated_here([box(size(2,2,2)), B]),
                 aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N),
                 faults(F) )),
    (   N > 4
    ->  More = true
    ;   More = N
    ).
test(these_do_not_cut, Pairs == [1-3,2-3]) :-
    with_rules("may_cut(S1, S2) :- S1-S2 \\== 1-2.",
               ( penetrated_here([rectangle(size(2,2)),
                                  at([rotate(x,90)], rectangle(size(2,2))),
                                  at([rotate(y,90)], rectangle(size(2,2)))]),
                 findall(S1-S2, line(_,S1,_,_,_,S2,_,_,_), Pairs0) )),
    sort(Pairs0, Pairs).

% Curves (PL-7): a line through a cone is cut where it goes in and out.
test(line_through_cone, N-Os-Ls == 3-2-0) :-
    penetrated([cone(radius(2), height(2), facets(4)),
                line(from(-3, 0.5, 1), to(3, 0.25, 1))],
               ( aggregate_all(count, e(2,_,_,_,1), N),
                 aggregate_all(count, origin(2,v(_),lpi(_,_)), Os),
                 aggregate_all(count, line(_,_,_,_,_,_,_,_,_), Ls) )).
test(line_through_edges, N-F == 3-[]) :-
    penetrated([box(size(2,2,2)), line(from(-3,-3,1), to(3,3,1))],
               ( aggregate_all(count, e(2,_,_,_,1), N), faults(F) )).
test(line_in_a_face, N == 3) :-
    penetrated([box(size(2,2,2)), line(from(-3,0.5,2), to(3,0.25,2))],
               aggregate_all(count, e(2,_,_,_,1), N)).
test(line_beside, N == 1) :-
    penetrated([box(size(2,2,2)), line(from(-3,3,1), to(3,3,1))],
               aggregate_all(count, e(2,_,_,_,1), N)).
test(line_cut_once, N == 3) :-
    penetrated([box(size(2,2,2)), line(from(-3,0.3,0.7), to(3,0.1,0.9))],
               ( penetrate, aggregate_all(count, e(2,_,_,_,1), N) )).

test(equal_cylinders, F-Bad == []-0) :-
    penetrated([at([translate(0,0,-2)],
                   cylinder(radius(1), height(4), facets(24))),
                at([translate(0,0,-2),rotate(x,90)],
                   cylinder(radius(1), height(4), facets(24)))],
               ( faults(F),
                 aggregate_all(count,
                               ( line(_,S,_,A,_,_,_,_,_),
                                 v(S,A,_,Y,Z),
                                 abs(abs(Y)-abs(Z)) > 1.0e-12 ),
                               Bad) )).

% Seeded random solids on a coarse grid: most contacts are degenerate.
test(random_solids, Bad == []) :-
    findall(Seed-Fs,
            ( between(1, 120, Seed),
              random_solids(Seed, Ps),
              catch(solids(Ps, _-Fs), E, Fs = [E]),
              Fs \== [] ),
            Bad).

% The order of the segments, and where the model stands, do not matter.
test(swapped, Bad == []) :-
    findall(Seed-(A-B),
            ( between(1, 40, Seed),
              random_solids(Seed, [P1,P2|_]),
              solids([P1,P2], A-_),
              solids([P2,P1], B-_),
              A \== B ),
            Bad).
test(rotated, Bad == []) :-
    findall(Seed-(A-B),
            ( between(1, 40, Seed),
              random_solids(Seed, Ps),
              solids(Ps, A-_),
              maplist(turned, Ps, Qs),
              solids(Qs, B-_),
              A \== B ),
            Bad).

turned(P, at([rotate(x,90),rotate(z,90)], P)).

random_solids(Seed, Ps) :-
    set_random(seed(Seed)),
    N is 2 + Seed mod 3,
    findall(P, ( between(1, N, _), random_solid(P) ), Ps).

random_solid(at([translate(X,Y,Z)|Turns], Shape)) :-
    findall(K, ( between(1, 3, _), random_between(0, 3, K0), K is K0/2.0 ),
            [X,Y,Z]),
    random_member(Turns, [[], [], [rotate(x,90)], [rotate(y,180)]]),
    random_between(1, 3, A),
    random_between(1, 3, B),
    random_between(1, 3, C),
    random_member(Shape,
                  [ box(size(A,B,C)), box(size(A,B,C)), box(size(A,A,B)),
                    pyramid(base(A,B), height(C)),
                    cylinder(radius(A), height(B), facets(4)),
                    cone(radius(A), height(C), facets(4)),
                    rectangle(size(A,B))
                  ]).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(tight(_, _, _, 0.125, 0.125, _)), warning, _).

%   A tolerance up to a sixteenth of the smallest of what is asked for makes a
%   gap touch; with a larger one nothing would be left of a part.

box_row(Sizes, Gap) :-
    foldl(box_added(Gap), Sizes, 0, _),
    complete_segments.

box_added(Gap, Size, X0, X) :-
    X is X0 + Size + Gap,
    At is X0 + Size/2,
    add_primitive(at([translate(At,0,0)], box(size(Size,Size,4))), _).

:- meta_predicate in_box_row(+, +, 0).

in_box_row(Sizes, Gap, Goal) :-
    new_world(World),
    in_world(World, ( box_row(Sizes, Gap), Goal )).

test(tolerance, true(Lines > 0)) :-
    in_box_row([4,4], 0.125,
               ( penetrate(all, [tolerance(0.25)]), lines(Lines) )).
test(large_tolerance, error(geometry_error(tolerance(0.26, 0.25)))) :-
    in_box_row([4,4], 0.125, penetrate(all, [tolerance(0.26)])).
test(large_tolerance_chains, error(geometry_error(tolerance(0.26, 0.25)))) :-
    in_box_row([4,4], 0.125, penetration_chains(all, [tolerance(0.26)], _)).
test(small_part, error(geometry_error(tolerance(0.5, 0.25)))) :-
    in_box_row([16,16,4], 0.125, penetrate(all, [tolerance(0.5)])).
test(small_part_elsewhere, true(Lines > 0)) :-
    in_box_row([16,16,4], 0.125,
               ( penetrate([1-2], [tolerance(0.5)]), lines(Lines) )).
test(negative_tolerance, error(domain_error(not_less_than_zero, -1))) :-
    in_box_row([4,4], 0.125, penetrate(all, [tolerance(-1)])).

lines(N) :-
    aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N).

:- end_tests(penetration).
