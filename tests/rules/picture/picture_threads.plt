% Pictures in several threads: what is kept with a world is made and used by
% all of them, in one world or in several.
:- module(test_picture_threads, []).
:- use_module(library(plunit)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(kernel), [scene_edge/5, scene_open/7]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

:- begin_tests(picture_threads,
               [condition(current_prolog_flag(threads, true))]).

% By turns over which bend an edge is a crease: what is smooth is made anew.
test(one_world, Faults == []) :-
    in_new_world(( model(12),
                   findall(Crease-Lines,
                           ( member(Crease, [5.0,30.0,60.0]),
                             seen_lines(Crease, Lines) ),
                           Wanted),
                   current_world(World),
                   in_threads([World,World,World], seen_often(Wanted),
                              Faults) )).
test(two_worlds, Faults == []) :-
    in_new_world(( model(9), current_world(World1), picture([]),
                   drawing(Wanted1),
                   in_new_world(( model(10), current_world(World2),
                                  picture([]), drawing(Wanted2),
                                  in_threads([World1,World2],
                                             drawn_often([Wanted1,Wanted2]),
                                             Faults) )) )).
% Each draws for itself and takes it back; they take turns.
test(drawn_in_one_world, Faults == []) :-
    in_new_world(( model(9), current_world(World), picture([]),
                   drawing(Wanted),
                   in_threads([World,World], drawn_often([Wanted]), Faults) )).

model(N) :-
    add_primitive(sphere(radius(1), facets(N)), S1),
    add_primitive(torus(radius(1), tube(0.4), facets(N)), S2),
    complete_segments([S1,S2]),
    set_view(300, 60, 0).

drawing(Lines) :-
    findall(d(S,E,From,To,V,Role), drawn(_,S,E,From,To,V,Role), Lines).

seen_lines(Crease, Lines) :-
    facts_snapshot(( picture([]),
                     scene_open(all, 1.0, 1.0e-9, smooth(Crease, []), every, [],
                                Scene),
                     findall(S-E-Look, scene_edge(Scene, S, E, _, Look),
                             Lines) )).

% What a thread found wrong, one answer of all.
seen_often(Wanted, Faults) :-
    findall(Crease,
            ( between(1, 20, _),
              member(Crease-Lines, Wanted),
              \+ seen_lines(Crease, Lines) ),
            Faults).

drawn_often(Wanted, Faults) :-
    findall(wrong,
            ( between(1, 20, _),
              facts_snapshot(( picture([]), drawing(Lines) )),
              \+ memberchk(Lines, Wanted) ),
            Faults).

in_threads(Worlds, Goal, Faults) :-
    message_queue_create(Queue),
    findall(Id,
            ( member(World, Worlds),
              thread_create(in_world(World, ( call(Goal, Found),
                                              thread_send_message(Queue,
                                                                  Found) )),
                            Id) ),
            Ids),
    maplist(thread_join, Ids, Ends),
    findall(Fault,
            ( member(End, Ends), End \== true, Fault = End
            ; found(Queue, Found), member(Fault, Found) ),
            Faults),
    message_queue_destroy(Queue).

found(Queue, Found) :-
    thread_get_message(Queue, Found, [timeout(0)]),
    (   true
    ;   found(Queue, Found)
    ).

:- end_tests(picture_threads).
