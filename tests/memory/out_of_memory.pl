/* Memory that runs out in the middle of a verb.

       LD_PRELOAD=build/tests/failing_malloc.so swipl -p foreign=build \
           tests/memory/out_of_memory.pl -- FOLDER RANDOM SAY [VERB...]

   Each verb runs once to count the requests for memory that our library makes;
   then again and again, and the n-th of them fails: n is 1, 2, 4, 8 ..., and
   RANDOM others; with and without those after it. The verb ends with status 4
   and says that there is no memory, or it can do without; nothing but whole
   files is in FOLDER; nothing stays held; and the verb that runs next, with
   all the memory, gives what it gave at first. SAY is 1: each case is named
   before it begins. The last line counts the cases.
*/
:- module(sg_out_of_memory, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(counted,
              [sanggwan/2, request_fails/2, requests/2, requests_of/1]).

:- initialization(main, main).

%   verb(?Verb, -Arguments, -Output): ten verbs, over small models; Output is
%   the ending of a file to be written, or none.

verb(check, [check,'facts/two_cubes.pl'], none).
verb(convert, [convert,'facts/hollow_block.pl'], stl).
verb(penetrate, [penetrate,'facts/figures/fig13.pl'], csv).
verb(draw, [draw,'facts/figures/fig13.pl'], svg).
verb(sheet, [draw,'facts/two_cubes.pl','--sheet','A4','--section',y], pdf).
verb(union, [union,'facts/two_cubes.pl'], off).
verb(eval, [eval,'facts/pipe_tee.pl'], stl).
verb(unfold, [unfold,'facts/patterns/house.pl'], svg).
verb(split, [split,'facts/hollow_block.pl','--plane','0,0,1,-0.5'], obj).
verb(query, [query,'facts/two_cubes.pl','penetrate, line(L,A,P,U,V,B,Q,X,Y)'], none).
verb(explain, [explain,'facts/two_cubes.pl','line(1)'], none).

:- dynamic said/1, wrong_case/1.
:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

%   Before the program's own, which prints.

:- initialization(asserta((user:message_hook(Term, Kind, _) :-
                               sg_out_of_memory:heard(Kind, Term)))).

heard(error, Term) :-
    assertz(said(Term)).
heard(warning, _).
heard(informational, _).

main :-
    current_prolog_flag(argv, [Folder,Random0,Say|Verbs0]),
    atom_number(Random0, Random),
    (   Verbs0 == []
    ->  findall(Verb, verb(Verb, _, _), Verbs)
    ;   Verbs = Verbs0
    ),
    requests_of('sanggwan.so'),
    foldl(tried(Folder, Random, Say), Verbs, 0, Cases),
    aggregate_all(count, wrong_case(_), Wrong),
    format("counted: ~d cases of memory that runs out~n", [Cases]),
    Right is Cases-Wrong,
    format("~d passed, ~d failed~n", [Right,Wrong]),
    (   Wrong =:= 0
    ->  halt
    ;   halt(1)
    ).

tried(Folder, Random, Say, Verb, Cases0, Cases) :-
    run(Verb, Folder, 0, false, Status-Output, _, _),    % what is kept is made
    run(Verb, Folder, 0, false, Status-Output, Requests, _),
    (   Status =:= 0
    ->  true
    ;   wrong(Verb, 0, false, status(Status))
    ),
    numbers(Requests, Random, Ns),
    forall(( member(N, Ns), member(After, [false,true]) ),
           case(Verb, Folder, N, After, Say, Output)),
    length(Ns, Count),
    Cases is Cases0 + 2*Count.

numbers(Most, Random, Ns) :-
    findall(N, ( between(0, 40, I), N is 1<<I, N =< Most ), Powers),
    set_random(seed(16)),
    findall(N, ( between(1, Random, _), random_between(1, Most, N) ), Others),
    append(Powers, Others, Ns0),
    sort(Ns0, Ns).

case(Verb, Folder, N, After, Say, Output) :-
    (   Say == '1'
    ->  format("case ~w ~w ~w~n", [Verb,N,After]),
        flush_output
    ;   true
    ),
    run(Verb, Folder, N, After, Result, _, Why),
    (   judged(Result, Output, Why, Fault)
    ->  wrong(Verb, N, After, Fault)
    ;   true
    ),
    run(Verb, Folder, 0, false, Again, _, _),
    (   Again == 0-Output
    ->  true
    ;   wrong(Verb, N, After, then(Again))
    ),
    held_after(Verb, Folder, N, After, Held1),
    held_after(Verb, Folder, N, After, Held2),
    held_after(Verb, Folder, N, After, Held3),
    (   Held1 < Held2,
        Held2 < Held3
    ->  wrong(Verb, N, After, held([Held1,Held2,Held3]))
    ;   true
    ).

%   held_after(Verb, Folder, N, After, Held): how many blocks our library holds
%   when the case has run once more and what Prolog held of it is collected.

held_after(Verb, Folder, N, After, Held) :-
    run(Verb, Folder, N, After, _, _, _),
    garbage_collect,
    garbage_collect_atoms,
    requests(_, Held).

%   judged(Result, Output, Errors, Fault) is semidet: what is wrong with it.

judged(0-Output, Output, [], _) :-
    !,
    fail.
judged(4-none(_), _, Errors, Fault) :-
    !,
    \+ memberchk(error(resource_error(memory), _), Errors),
    Fault = said(Errors).
judged(Status-Output, _, Errors, ended(Status, Output, Errors)).

wrong(Verb, N, After, Fault) :-
    assertz(wrong_case(Verb-N-After)),
    print_message_lines(user_output, '',
                        [ 'FAILED: ~w, request ~w (all after: ~w): ~p'-
                          [Verb,N,After,Fault], nl ]).

%   run(Verb, Folder, N, After, Status-Output, Requests, Errors)

run(Verb, Folder, N, After, Status-Output, Requests, Errors) :-
    verb(Verb, Words, Ending),
    retractall(said(_)),
    (   Ending == none
    ->  All = Words
    ;   file_name_extension(out, Ending, Name),
        directory_file_path(Folder, Name, File),
        append(Words, ['-o',File], All)
    ),
    request_fails(N, After),
    with_output_to(string(Text), sanggwan(All, Status)),
    requests(Requests, _),
    request_fails(0, false),
    findall(Error, said(Error), Errors),
    contents(Folder, Files),
    (   Status =:= 0
    ->  Output = some(Text, Files)
    ;   Files == []
    ->  Output = none(Text)
    ;   Output = left(Files)
    ).

contents(Folder, Contents) :-
    directory_files(Folder, Names0),
    msort(Names0, Names),
    findall(Name-Hash,
            ( member(Name, Names),
              \+ memberchk(Name, ['.','..']),
              directory_file_path(Folder, Name, File),
              read_file_to_string(File, Text, [encoding(octet)]),
              variant_sha1(Text, Hash),
              delete_file(File) ),
            Contents).
