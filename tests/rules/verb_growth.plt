% What verbs do with models that grow: four times as many take about four times
% as long.
:- module(test_verb_growth, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(command/check)).
:- use_module(rules(model/mesh), [read_mesh/2]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case'), [result/2]).
:- use_module(tests('rules/solid/grown')).

/* For four times as many, a time that grows as n^2 is 16 times as long, one
   that grows as n log n about 5 times. What is far below a second is mostly
   what does not grow. The least of several runs counts, of all threads. */

%   case(Name, N, Most): from N to 4 N the time grows by less than Most.

case(check(base),       400, 8).
case(penetrate(curves), 400, 8).
case(picture(wedges),   800, 10).
case(evaluate(copies),  200, 8).
case(evaluate(glued_copies), 200, 8).

:- meta_predicate least_time(0, -).

grows(Name, N, Ratio) :-
    M is 4*N,
    time_of(Name, N, T1),
    time_of(Name, M, T2),
    Ratio is T2/max(T1, 0.02).

time_of(Name, N, Time) :-
    Name =.. [Verb,Family],
    new_world(World),
    in_world(World,
             ( model(Family, N),
               least_time(facts_snapshot(done(Verb)), Time) )).

least_time(Goal, Time) :-
    findall(T,
            ( between(1, 3, _),
              statistics(process_cputime, T0),
              call(Goal),
              statistics(process_cputime, T1),
              T is T1-T0 ),
            Ts),
    min_list(Ts, Time).

model(curves, N) :-
    !,
    forall(between(1, N, I),
           ( A is 2*pi*I/N, X is cos(A), Y is sin(A),
             add_primitive(line(from(0,0,0), to(X,Y,1)), _) )).
%   One box N times, each a leaf of one tree.
model(copies, N) :-
    !,
    findall(S, ( between(1, N, _), add_primitive(box(size(1,1,1)), S) ), Ss),
    fresh_id(segment, 0, Union),
    assert_fact(segment(Union, solid, union(Ss))),
    complete_segments.
%   The same glued, with one that cuts them.
model(glued_copies, N) :-
    !,
    findall(S, ( between(1, N, _), add_primitive(box(size(1,1,1)), S) ), Ss),
    Askew = at([translate(0.5,0.5,0.5)], box(size(1,1,1))),
    add_primitive(Askew, Other),
    fresh_id(segment, 0, Glue),
    assert_fact(segment(Glue, cells, glue([Other|Ss]))),
    complete_segments.
model(Family, N) :-
    tmp_file_stream(File, Stream, [extension(off)]),
    close(Stream),
    call_cleanup(( grown_file(Family, N, File, _),
                   read_mesh(File, _) ),
                 delete_file(File)),
    complete_segments.

done(check) :-
    check_report(_).
done(penetrate) :-
    penetrate.
done(evaluate) :-
    evaluate.
done(picture) :-
    penetrate(all, [themselves(true),shown(true)]),
    set_view(300, 60, 0),
    picture.

%   inferences_of(N, Inferences): to unite N boxes, each through the next one.

inferences_of(N, Inferences) :-
    new_world(World),
    in_world(World,
             ( findall(S,
                       ( between(1, N, I),
                         X is 0.75*I,
                         Y is 0.25*(I mod 2),
                         add_primitive(at([translate(X,Y,Y)],
                                          box(size(1,1,1))), S) ),
                       Ss),
               complete_segments,
               statistics(inferences, N0),
               result(union(Ss), _),
               statistics(inferences, N1) )),
    Inferences is N1-N0.

:- begin_tests(verb_growth).

test(time, [forall(case(Name, N, Most)), true(Ratio < Most)]) :-
    grows(Name, N, Ratio).
test(inferences, true(N2 < 5*N1)) :-
    inferences_of(200, N1),
    inferences_of(800, N2).

:- end_tests(verb_growth).
