:- encoding(utf8).
:- module(test_model_fuzz, []).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(rules(store)).
:- use_module(rules(model/model_file)).
:- use_module(rules(model/openscad_text)).

/* The readers of model and .csg files on damaged files: whatever stands in one,
it is read, or refused with its place, and then the world is as it was. The seed
is printed with a failure; MODEL_FUZZ=N makes N files a model (default 150). */

fuzz_seed(1988).

rounds(N) :-
    (   getenv('MODEL_FUZZ', Text)
    ->  atom_number(Text, N)
    ;   N = 150
    ).

seed_codes(csg, Name, Codes) :-
    csg_text(Name, Text),
    string_codes(Text, Codes).
seed_codes(pl, File, Codes) :-
    seed_file(File),
    read_file_to_codes(File, Codes, [encoding(utf8)]).

csg_text(solids, "group(){\c
  multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]])\c
  {cube(size=[1,2,3],center=true);}difference(){\c
  sphere($fn=8,$fa=12,$fs=2,r=2);\c
  cylinder($fn=6,$fa=12,$fs=2,h=3,r1=1,r2=0.5,center=false);}}\n").
csg_text(extruded, "\c
  linear_extrude(height=2,twist=20,slices=3,scale=[1,2],$fn=0,\c
  $fa=12,$fs=2){polygon(points=[[0,0],[3,0],[0,3]],paths=undef,convexity=1);}\c
  /* a */ rotate_extrude(angle=270,$fn=5){square(size=[1,1],center=false);}\n\c
  // b\n%text(text=\"c\", size=3);\n").

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
          "box(size(0,0,0))", "end_of_file.", ";", ":- halt.",
          "v(1,1,1,1,1)." ]).

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
read_or_refused(Ending, Codes, Answer) :-
    new_world(World),
    in_world(World, read_in_world(Ending, Codes, Answer)).

read_in_world(Ending, Codes, Answer) :-
    assert_fact(segment(99, curve, before)),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(Ending)]),
        ( format(Out, "~s", [Codes]),
          close(Out),
          catch(( read_file(Ending, File), Answer0 = read ), Error,
                Answer0 = raised(Error))
        ),
        delete_file(File)),
    answer(Answer0, Answer).

read_file(pl, File) :-
    read_model(File, [], _).
read_file(csg, File) :-
    read_csg(File, _).

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

test(damaged_files, [forall(seed_codes(Ending, File, Codes)), nondet]) :-
    fuzz_seed(Seed),
    set_random(seed(Seed)),
    rounds(Rounds),
    forall(between(1, Rounds, Round),
           ( damaged(Codes, Bad),
             read_or_refused(Ending, Bad, Answer),
             (   Answer = wrong(What)
             ->  format(user_error, "~w, seed ~w, file ~w: ~q~n~s~n",
                        [File, Seed, Round, What, Bad]),
                 fail
             ;   true
             ) )).

test(both_happen, [forall(member(Ending-File, [pl-'facts/cube.pl',csg-solids])),
                   nondet]) :-
    set_random(seed(1)),
    seed_codes(Ending, File, Codes),
    findall(Kind,
            ( between(1, 100, _),
              damaged(Codes, Bad),
              read_or_refused(Ending, Bad, Answer),
              functor(Answer, Kind, _) ),
            Kinds),
    memberchk(read, Kinds),
    memberchk(refused, Kinds).

:- end_tests(model_fuzz).
