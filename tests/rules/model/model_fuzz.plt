:- encoding(utf8).
:- module(test_model_fuzz, []).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(rules(store)).
:- use_module(rules(model/model_file)).

/* The reader of model files on damaged files: whatever stands in one, it is
read, or refused with its place, and then the world is as it was. The seed is
printed with a failure; MODEL_FUZZ=N makes N files a model (default 150). */

fuzz_seed(1988).

rounds(N) :-
    (   getenv('MODEL_FUZZ', Text)
    ->  atom_number(Text, N)
    ;   N = 150
    ).

seed_file(File) :-
    member(Name, [cube, hollow_block, wire_and_roof, 'figures/fig08',
                  'figures/fig09', 'figures/fig13']),
    atomic_list_concat(['facts/', Name, '.pl'], File).

% What to throw in: what is special to the reader, and what is not.
splinter(Text) :-
    random_member(Text,
        [ ".", ",", "(", ")", "[", "]", "-", "'", "\"", "0'", "|", "{}", "%",
          "/*", "*/", ":-", "?-", "1e999", "nan", "1.0Inf", "1.5NaN", "1r3",
          "0x10", "99999999999999999999", "-1", "0", "X", "_", "a", "v", "p(",
          " . ", "\n", "\t", "\x0\", "\x7f\", "형", "segment(", "at([",
          "box(size(0,0,0))", "end_of_file.", ":- halt.", "v(1,1,1,1,1)." ]).

damaged(Codes0, Codes) :-
    random_between(1, 4, Times),
    damaged(Times, Codes0, Codes).

damaged(0, Codes, Codes) :-
    !.
damaged(Times, Codes0, Codes) :-
    length(Codes0, Length),
    random_between(0, Length, At),
    length(Before, At),
    append(Before, After, Codes0),
    random_between(0, 2, How),
    damage(How, Before, After, Codes1),
    Times1 is Times-1,
    damaged(Times1, Codes1, Codes).

damage(0, Before, _, Before).                   % cut short
damage(1, Before, After0, Codes) :-             % a piece left out
    random_between(0, 12, Drop),
    (   length(Piece, Drop),
        append(Piece, After, After0)
    ->  true
    ;   After = []
    ),
    append(Before, After, Codes).
damage(2, Before, After, Codes) :-              % a splinter put in
    splinter(Text),
    string_codes(Text, Piece),
    append([Before, Piece, After], Codes).

% read_or_refused(+Codes, -Answer): Answer is `read`, refused(Location) or, for
% anything else, wrong(What).
read_or_refused(Codes, Answer) :-
    new_world(World),
    in_world(World, read_in_world(Codes, Answer)).

read_in_world(Codes, Answer) :-
    assert_fact(segment(99, curve, before)),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
        ( format(Out, "~s", [Codes]),
          close(Out),
          catch(( read_model(File), Answer0 = read ), Error,
                Answer0 = raised(Error))
        ),
        delete_file(File)),
    answer(Answer0, Answer).

answer(read, read).
answer(raised(error(model_error(_), location(_, Line, _))), Answer) :-
    !,
    (   integer(Line),
        findall(S, segment(S, _, _), [99]),
        \+ v(_, _, _, _, _),
        \+ e(_, _, _, _, _)
    ->  Answer = refused(Line)
    ;   Answer = wrong(half_loaded)
    ).
answer(raised(Error), wrong(Error)).

:- begin_tests(model_fuzz).

test(damaged_files, [forall(seed_file(File)), nondet]) :-
    fuzz_seed(Seed),
    set_random(seed(Seed)),
    read_file_to_codes(File, Codes, [encoding(utf8)]),
    rounds(Rounds),
    forall(between(1, Rounds, Round),
           ( damaged(Codes, Bad),
             read_or_refused(Bad, Answer),
             (   Answer = wrong(What)
             ->  format(user_error, "~w, seed ~w, file ~w: ~q~n~s~n",
                        [File, Seed, Round, What, Bad]),
                 fail
             ;   true
             ) )).

test(both_happen, [true, nondet]) :-
    set_random(seed(1)),
    read_file_to_codes('facts/cube.pl', Codes, [encoding(utf8)]),
    findall(Kind,
            ( between(1, 100, _),
              damaged(Codes, Bad),
              read_or_refused(Bad, Answer),
              functor(Answer, Kind, _) ),
            Kinds),
    memberchk(read, Kinds),
    memberchk(refused, Kinds).

:- end_tests(model_fuzz).
