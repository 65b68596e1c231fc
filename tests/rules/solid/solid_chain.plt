:- encoding(utf8).
:- module(test_solid_chain, []).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(command/check)).
:- use_module(rules(model/model)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(model/solid_file)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/checked')).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('rules/random_shape')).
:- use_module(tests('rules/sample')).

/* Chains through files: 40 operations, with TEST_ALL=1 200, each on the written
result of the one before. Every file is closed and does not go through itself:
write_solid/2 says so, or does not write it; at some steps also the engine that
reads it, and the checker that shares nothing with it.

With CHAINS=all there are more chains, of finer shapes, in all formats, some far
from the origin, and every step is looked at: about 15 minutes. */

%   chain(?Ending, -Seed, -Facets, -Away, -Looks): shapes whose circles have
%   Facets corners, near (Away,Away,Away); every so many steps the file is
%   looked at.

chain(stl, 11, 9, 0, 10).
chain(off, 12, 9, 0, 10).
chain(Ending, Seed, Facets, Away, 1) :-
    getenv('CHAINS', all),
    more(Ending, Seed, Facets, Away).

more(stl, 11, 24, 0).
more(stl, 12, 24, 0).
more(stl, 13, 24, 0).
more(off, 11, 24, 0).
more(off, 12, 24, 0).
more(obj, 13, 24, 0).
more(ply, 14, 24, 0).
more(stl, 14, 24, 100).
more(off, 12, 24, 100).
more(stl, 12, 9, 1000).
more(off, 12, 24, 1000).

operations(N) :-
    few(40, 200, N).

chained(Ending, Seed, Facets, Away, Looks) :-
    set_random(seed(Seed)),
    operations(N),
    setup_call_cleanup(
        ( tmp_file_stream(File, Stream, [extension(Ending)]),
          close(Stream)
        ),
        ( begun(File, Away),
          forall(between(1, N, I), step(File, I, Facets, Away, Looks))
        ),
        delete_file(File)).

begun(File, Away) :-
    in_new_world(( add_primitive(at([translate(Away,Away,Away)],
                                    box(size(1,1,1))), S),
                   complete_segments,
                   write_solid(File, S) )).

step(File, I, Facets, Away, Looks) :-
    (   I mod 3 =:= 0
    ->  Operation = difference
    ;   Operation = union
    ),
    random_shape(Facets, 0, Shape),
    Steps = [scale(0.4), translate(Away,Away,Away)],
    Expression =.. [Operation,[1,2]],
    in_new_world(( load_model(File),
                   add_primitive(at(Steps, Shape), 2),
                   complete_segments,
                   boolean(Expression, 100),
                   write_solid(File, 100) )),
    (   I mod Looks =\= 0
    ->  true
    ;   no_faults(File),
        good(File)
    ->  true
    ;   format("step ~d~n", [I]),
        fail
    ).

no_faults(File) :-
    in_new_world(( load_model(File),
                   check_report(Report) )),
    report_faults(Report, 0).

good(File) :-
    file_name_extension(_, Ending, File),
    \+ memberchk(Ending, [stl,off]),    % the checker reads no others
    !.
good(File) :-
    checked([File], [Result]),
    (   Result.good == yes
    ->  true
    ;   format("~p~n", [Result]),
        fail
    ).

:- begin_tests(solid_chain).

test(chain, forall(chain(Ending, Seed, Facets, Away, Looks))) :-
    chained(Ending, Seed, Facets, Away, Looks).

:- end_tests(solid_chain).
