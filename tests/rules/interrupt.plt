:- module(test_interrupt, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(time)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(command/verbs)).
:- use_module(rules(model/mesh)).
:- use_module(rules(model/model)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).

/* An interrupt ends the whole way of the data soon, wherever it is, and leaves
   the world as it was. What counts is the work done after the signal, in
   seconds of the processor: a busy machine is no fault. INTERRUPT_RINGS=N makes
   spheres of 4*N*N triangles, INTERRUPT_TIMES=N more moments. */

setting(Name, Default, Value) :-
    (   getenv(Name, Text),
        atom_number(Text, Value0)
    ->  Value = Value0
    ;   Value = Default
    ).

%   sphere(+File, +N, +X): an OBJ file of a sphere of N rings of 2N pieces, its
%   middle at X, 0, 0; each ring is 4N triangles.

sphere(File, N, X) :-
    setup_call_cleanup(open(File, write, Out), sphere_written(Out, N, X),
                       close(Out)).

sphere_written(Out, N, X) :-
    Around is 2*N,
    forall(( between(0, N, I), between(1, Around, J) ),
           ( A is pi*I/N, B is 2*pi*J/Around,
             Px is X+sin(A)*cos(B), Py is sin(A)*sin(B), Pz is cos(A),
             format(Out, "v ~15f ~15f ~15f~n", [Px,Py,Pz]) )),
    forall(( between(1, N, I), between(1, Around, J) ),
           ( Low is (I-1)*Around, High is I*Around,
             J1 is J mod Around+1,
             A is Low+J, B is High+J, C is High+J1, D is Low+J1,
             ( I < N -> format(Out, "f ~d ~d ~d~n", [A,B,C]) ; true ),
             ( I > 1 -> format(Out, "f ~d ~d ~d~n", [A,C,D]) ; true ) )).

:- dynamic file/1, signal_at/1, over/0, thrown/0.

make_files :-
    setting('INTERRUPT_RINGS', 40, N),
    forall(member(X, [0, 0.7]),
           ( tmp_file_stream(File, Out, [extension(obj)]),
             close(Out),
             sphere(File, N, X),
             assertz(file(File)) )).

drop_files :-
    forall(retract(file(File)), delete_file(File)).

files(Files) :-
    findall(File, file(File), Files).

rows(Rows) :-
    findall(Relation-N,
            ( relation(Relation, _, _),
              facts_statistics(Relation, Statistics),
              get_dict(rows, Statistics, N) ),
            Rows).

%   interrupted(:Goal, +Seconds, -Took): Goal gets a signal after Seconds; Took
%   is what the processor did from then on; `done` if there was none in time;
%   `lost` if there was, and Goal went on.

:- meta_predicate interrupted(0, +, -).

interrupted(Goal, Seconds, Took) :-
    retractall(over),
    retractall(signal_at(_)),
    retractall(thrown),
    thread_self(Me),
    thread_create(interrupt_after(Me, Seconds), Id),
    catch(( call(Goal), assertz(over), How = done ), interrupt,
          How = stopped),
    statistics(process_cputime, End),
    assertz(over),
    thread_join(Id),
    (   How == stopped
    ->  signal_at(Begin),
        Took is End-Begin
    ;   retract(thrown)
    ->  Took = lost
    ;   Took = done
    ).

interrupt_after(Thread, Seconds) :-
    sleep(Seconds),
    (   over
    ->  true
    ;   statistics(process_cputime, Now),
        assertz(signal_at(Now)),
        thread_signal(Thread, test_interrupt:unless_over)
    ).

unless_over :-
    over,
    !.
unless_over :-
    assertz(thrown),
    throw(interrupt).

%   moment(+Whole, -Seconds): moments over the time that all of it takes.

moment(Whole, Seconds) :-
    setting('INTERRUPT_TIMES', 12, N),
    between(1, N, I),
    Seconds is Whole*I/(N+1).

seconds_of(Goal, Seconds) :-
    get_time(T0),
    call(Goal),
    get_time(T1),
    Seconds is T1-T0.

load_and_penetrate(Files) :-
    load_model(Files),
    penetrate.

late_writing(Ending, File, Seconds, Took) :-
    Goal = facts_snapshot(written(Ending, File)),
    seconds_of(Goal, Whole),
    member(I, [1,2,3,4]),
    Seconds is Whole*I/5,
    interrupted(Goal, Seconds, Took),
    Took \== done,
    ( Took == lost -> true ; Took > 0.2 ).

written(pl, File) :-
    !,
    save_model(File).
written(Ending, File) :-
    (   memberchk(Ending, [stl,off,obj])
    ->  write_mesh(File, [1,2])
    ;   draw(File)
    ).

lines(N) :-
    aggregate_all(count, line(_, _, _, _, _, _, _, _, _), N).

has_threads :-
    current_prolog_flag(threads, true).

:- begin_tests(interrupt, [setup(make_files), cleanup(drop_files),
                           condition(test_interrupt:has_threads)]).

test(loading, Bad == []) :-
    files(Files),
    new_world(World0),
    seconds_of(in_world(World0, load_model(Files)), Whole),
    in_world(World0, rows(Loaded)), % a signal at the very end
    findall(late(Seconds, Took),
            ( moment(Whole, Seconds),
              new_world(World),
              in_world(World, ( rows(Before),
                                interrupted(load_model(Files), Seconds, Took),
                                rows(After) )),
              Took \== done,
              ( Took > 0.2 -> true ; \+ memberchk(After, [Before,Loaded]) ) ),
            Bad).
test(penetrating, Bad-Again == []-yes) :-
    files(Files),
    new_world(World0),
    in_world(World0, ( load_model(Files),
                       seconds_of(penetrate, Whole),
                       lines(Lines) )),
    new_world(World),
    in_world(World,
             ( load_model(Files),
               rows(Before),
               findall(late(Seconds, Took),
                       ( moment(Whole, Seconds),
                         interrupted(facts_snapshot(penetrate), Seconds, Took),
                         rows(After),
                         Took \== done,
                         ( Took > 0.2 -> true ; Before \== After ) ),
                       Bad),
               penetrate,
               lines(Lines1) )),
    (   Lines == Lines1
    ->  Again = yes
    ;   Again = Lines-Lines1
    ).
%   Of a glue nothing is there then: neither its rows nor its regions.

test(gluing, Bad == []) :-
    files(Files),
    new_world(World),
    in_world(World,
             ( load_model(Files),
               assert_fact(segment(3, cells, glue([1,2]))),
               seconds_of(facts_snapshot(evaluate(3)), Whole),
               rows(Before),
               findall(late(Seconds, Took),
                       ( member(I, [1,2,3,4]),
                         Seconds is Whole*I/5,
                         Tolerance is 1.0e-9*(1+Seconds),
                         facts_snapshot(( interrupted(
                                              evaluate(3,
                                                       [tolerance(Tolerance)]),
                                              Seconds, Took),
                                          rows(After) )),
                         Took \== done,
                         (   Took > 0.2
                         ->  true
                         ;   Before \== After,
                             \+ glued(Tolerance, After)
                         ) ),
                       Bad) )).

%   glued(Tolerance, Rows): as the rows are when all of it is done: a signal at
%   the very end.

glued(Tolerance, Rows) :-
    facts_snapshot(( evaluate(3, [tolerance(Tolerance)]),
                     rows(Glued) )),
    Glued == Rows.

%   Each time with another tolerance, so that no piece is kept from the last.

test(combining, Bad-Faces == []-[N]) :-
    files(Files),
    new_world(World),
    in_world(World,
             ( load_model(Files),
               seconds_of(facts_snapshot(boolean(union([1,2]), 3)), Whole),
               rows(Before),
               findall(late(Seconds, Took),
                       ( moment(Whole, Seconds),
                         Tolerance is 1.0e-9*(1+Seconds),
                         interrupted(facts_snapshot(
                                         boolean(union([1,2]), 3,
                                                 [tolerance(Tolerance)])),
                                     Seconds, Took),
                         rows(After),
                         Took \== done,
                         ( Took > 0.2 -> true ; Before \== After ) ),
                       Bad),
               findall(Count,
                       ( member(S, [3,4]),
                         boolean(union([1,2]), S),
                         aggregate_all(count, p(S, _, _), Count) ),
                       Faces0) )),
    sort(Faces0, Faces),
    Faces = [N|_].
%   A writer is at work within one call of Prolog's mostly.

test(writing, Bad == []) :-
    files(Files),
    tmp_file(interrupt, Folder),
    make_directory(Folder),
    new_world(World),
    findall(late(Ending, Seconds, Took),
            ( member(Ending, [pl,stl,off,obj,svg,dxf,json]),
              format(atom(File), '~w/a.~w', [Folder, Ending]),
              in_world(World, ( ( segment(1, _, _)
                                ->  true
                                ;   load_model(Files)
                                ),
                                late_writing(Ending, File, Seconds, Took) ))
            ), Bad),
    delete_directory_and_contents(Folder).
test(time_limit, Rows == Before) :-
    files(Files),
    new_world(World),
    in_world(World,
             ( load_model(Files),
               rows(Before),
               catch(call_with_time_limit(0.01, penetrate),
                     time_limit_exceeded, true),
               rows(Rows) )).

:- end_tests(interrupt).
