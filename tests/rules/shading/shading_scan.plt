/* span/7: what the kernel says of each line, as rows; files of it. */
:- module(test_shading_scan, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(library(time)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shading_scan)).
:- use_module(rules(store)).
:- use_module(shaded_model).

model("segment(4, solid, box(size(3,3,3))).
       segment(7, solid, at([translate(1,1,1)], sphere(radius(1.5),
                                                        facets(48)))).
       segment(9, solid, difference([4,7])). view(45, 60, 0).").

options([size(60-50), window(b(-4.0,-3.0,4.0,4.0))]).

rows(Rows) :-
    findall(span(Y,K,X1,X2,R,S,F), span(Y,K,X1,X2,R,S,F), Rows).

:- begin_tests(shading_scan).

test(rows_are_spans, Wrong-Some == []-true) :-
    model(Text),
    options(Options),
    in_model(Text,
             ( shaded_scene_of(Options, Scene),
               scan([smooth(2)|Options]),
               findall(Y-K,
                       ( between(0, 49, Y), between(0, 1, K),
                         Line is Y + (K+0.5)/2,
                         line_spans(Scene, Line, Spans0),
                         maplist(of_segment, Spans0, Spans),
                         findall(span(X1,X2,R,S,F),
                                 span(Y,K,X1,X2,R,S,F), Rows),
                         Rows \== Spans ),
                       Wrong),
               aggregate_all(count, span(_,_,_,_,_,7,_), N) )),
    (   N > 20
    ->  Some = true
    ;   Some = N
    ).

%   Leaves have numbers, rows their segments.
of_segment(span(X1,X2,R,1,F), span(X1,X2,R,4,F)).
of_segment(span(X1,X2,R,2,F), span(X1,X2,R,7,F)).

test(replaced_and_undone, N1-N2-N3 == N-0-N) :-
    model(Text),
    options(Options),
    in_model(Text,
             ( scan(Options),
               rows(Rows1),
               scan(Options),
               rows(Rows2),
               Rows1 == Rows2,
               length(Rows1, N),
               N > 100,
               length(Rows2, N1),
               catch(facts_transaction(
                         ( retractall_facts(segment(_,_,_)),
                           scan(Options),
                           aggregate_all(count, span(_,_,_,_,_,_,_), N2),
                           throw(back(N2)) )),
                     back(N2), true),
               aggregate_all(count, span(_,_,_,_,_,_,_), N3) )).
% On a busy machine the alarm may come when all is done.
test(stopped, true(( Stopped == false ; N == 0 ))) :-
    in_model("segment(1, solid, sphere(radius(2), facets(48))).
              view(300, 60, 0).",
             ( catch(( call_with_time_limit(0.02,
                           scan([size(4000-4000),smooth(16)])),
                       Stopped = false ),
                     time_limit_exceeded, Stopped = true),
               aggregate_all(count, span(_,_,_,_,_,_,_), N) )).
test(see_through, Parts == [1,1,1,1]) :-
    in_model("segment(1, solid, box(size(2,2,2))). look(1, opacity(0.5)).
              segment(2, solid, at([translate(0,0,-3)], box(size(2,2,2)))).
              look(2, opacity(0.5)). view(270, 0, 0).",
             ( scan([size(30-30),smooth(1)]),
               findall(1, span(15,0,_,_,_,_,_), Parts) )).
test(not_asked, error(instantiation_error)) :-
    scan(_).
test(no_options, error(type_error(list,7))) :-
    scan(7).

:- end_tests(shading_scan).
