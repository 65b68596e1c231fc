:- module(test_pipeline_fuzz, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(command/check)).
:- use_module(rules(kernel), [census/1]).
:- use_module(rules(command/lines_out)).
:- use_module(rules(model/mesh)).
:- use_module(rules(model/model)).
:- use_module(rules(model/model_writer)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(command/report)).
:- use_module(rules(polygon/polygon_list)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/soup')).

/* The whole way of the data on random soups (soup.pl): load, complete,
penetrate, chain, write, check. Whatever the model, there is a result in which
nothing was lost, or a clear refusal and the world as before.

The cases are numbered; a failure names its number. From the environment:
PIPELINE_FUZZ=COUNT and PIPELINE_FUZZ_FROM=FIRST run others than those below,
PIPELINE_FUZZ_SAY=1 names each case before it begins, for those that end the
process. tests/fuzz runs many. */

setting(Name, Default, Value) :-
    (   getenv(Name, Text),
        atom_number(Text, Value0)
    ->  Value = Value0
    ;   Value = Default
    ).

%   Warnings about bad polygons are what these models are for.

:- dynamic silent/0.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(_), Kind, _) :-
    memberchk(Kind, [warning, informational]),
    test_pipeline_fuzz:silent.

%   wrong(+Seed, -Why) is semidet: what is wrong with the result of case Seed.

wrong(Seed, Why) :-
    soup(Seed, Soup),
    new_world(World),
    catch(( in_world(World, pipeline(Seed, Soup, Why0))
          ->  true
          ;   Why0 = failed
          ),
          Error, Why0 = raised(Error)),
    Why0 \== fine,
    Why = Why0.

pipeline(Seed, Soup, Why) :-
    Route is Seed mod 4,
    (   \+ allowed(entered(Route, Soup), load)
    ->  (   v(_, _, _, _, _)
        ->  Why = half_loaded
        ;   Why = fine
        )
    ;   penetrated(Why)
    ).

%   allowed(+Goal, +What) is semidet: fails if Goal is refused in a way that
%   What may be; other errors go on.

allowed(Goal, What) :-
    catch(Goal, error(Formal, _), refusal(What, Formal)),
    var(Formal).

refusal(load, model_error(_)).
refusal(load, domain_error(coordinate, _)).
refusal(penetrate, geometry_error(_)).

%   The routes: a model file, an OBJ file, facts one by one.

entered(0, Soup) :-
    !,
    soup_facts(Soup, Facts),
    in_file(pl, forall(member(Fact, Facts), format("~q.~n", [Fact]))).
entered(1, Soup) :-
    !,
    soup_obj(Soup, Text),
    in_file(obj, write(Text)).
entered(_, Soup) :-
    facts_transaction(( maplist(piece_asserted, Soup), complete_segments )).

:- meta_predicate in_file(+, 0).

in_file(Ending, Goal) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(Ending), encoding(utf8)]),
        ( with_output_to(string(Text), Goal),
          write(Out, Text),
          close(Out),
          load_model(File)
        ),
        delete_file(File)).

piece_asserted(piece(S, Kind, Points, Faces, Chain)) :-
    assert_fact(segment(S, Kind, soup)),
    forall(nth1(V, Points, p(X,Y,Z)), assert_fact(v(S, V, X, Y, Z))),
    foldl(face_asserted(S), Faces, 1-1, _),
    forall(nextto(A, B, Chain),
           ( fresh_id(e, S, E), assert_fact(e(S, E, A, B, 1)) )).

face_asserted(S, Face, P-E0, P1-E) :-
    vertex_list_edges(Face, Edges),
    foldl(edge_asserted(S), Edges, Es, E0, E),
    assert_fact(p(S, P, Es)),
    P1 is P+1.

edge_asserted(S, A-B, E, E, E1) :-
    assert_fact(e(S, E, A, B, 1)),
    E1 is E+1.

penetrated(Why) :-
    model_text(Before),
    open_polygons(Open),
    (   allowed(penetrate, penetrate)
    ->  (   result_fault(Open, Why0)
        ->  Why = Why0
        ;   Why = fine
        )
    ;   model_text(After),
        (   After == Before
        ->  Why = fine
        ;   Why = changed_though_refused
        )
    ).

model_text(Text) :-
    with_output_to(string(Text), write_model_to(current_output)).

open_polygons(N) :-
    census(Parts),
    aggregate_all(sum(Count),
                  ( member(part(_, _, _, _, _, _, _, Defects), Parts),
                    member(open_polygon-Count, Defects) ),
                  N).

%   result_fault(+Open, -Fault): of what penetrate/0 left, by which there were
%   Open open polygons before. A second call does or refuses its work too.

result_fault(Open, open_polygons(Open, After)) :-
    open_polygons(After),
    After =\= Open.
result_fault(_, chains(Pieces, InChains)) :-
    aggregate_all(count, line(_, _, _, _, _, _, _, _, _), Pieces),
    chains(Chains),
    aggregate_all(sum(N),
                  ( member(chain(_, _, _, Lines), Chains), length(Lines, N) ),
                  InChains),
    Pieces =\= InChains.
result_fault(_, dangling(Fact)) :-
    e(S, E, V1, V2, Et),
    \+ ( v(S, V1, _, _, _), v(S, V2, _, _, _) ),
    Fact = e(S, E, V1, V2, Et).
result_fault(_, Fault) :-
    written(Fault).
result_fault(_, again) :-
    allowed(penetrate, penetrate),
    fail.

%   Everything that can be written is written, and the report is made.

written(Fault) :-
    member(Format, [pl, csv, obj, svg]),
    \+ with_output_to(string(_),
                      write_lines_to(current_output, Format, [])),
    Fault = not_written(Format).
written(no_report) :-
    \+ ( check_report(Report),
         with_output_to(string(_),
                        ( print_report(text, Report),
                          print_report(json, Report) )) ).

:- begin_tests(pipeline_fuzz, [setup(asserta(test_pipeline_fuzz:silent)),
                               cleanup(retractall(test_pipeline_fuzz:silent))]).

% Cases that were wrong once.

test(were_wrong, Wrong == []) :-
    findall(Seed-Why,
            ( member(Seed, [46, 1033, 2838, 7409, 228517, 406326, 428994]),
              wrong(Seed, Why)
            ),
            Wrong).
% Found by tests/fuzz: what crashed, hung or came out wrong once.
test(found, [forall(member(Seed, [20048585])), fail]) :-
    wrong(Seed, _).
test(soups) :-
    setting('PIPELINE_FUZZ', 800, Count),
    setting('PIPELINE_FUZZ_FROM', 1, From),
    setting('PIPELINE_FUZZ_SAY', 0, Say),
    To is From+Count-1,
    findall(Seed-Why,
            ( between(From, To, Seed),
              ( Say == 1 -> format(user_error, "case ~d~n", [Seed]) ; true ),
              wrong(Seed, Why),
              format(user_error, "case ~d: ~q~n", [Seed, Why]) ),
            Wrong),
    Wrong == [].

:- end_tests(pipeline_fuzz).
