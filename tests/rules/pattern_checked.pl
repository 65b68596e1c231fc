:- module(sg_test_pattern_checked,
          [ patterns_checked/2,         % :Write, -Results
            patterns_checked/3,         % +Options, :Write, -Results
            write_pattern/4,            % +Out, +Name, +D, +Told
            write_line/2,               % +Out, +Line
            bad_pattern/3               % +Result, +Precision, -Fault
          ]).
/** <module> The independent checker of patterns, from Prolog.

The program is tests/pattern_checker, which shares nothing with the engine;
pattern.h there has the lines of its file.
*/

:- use_module(library(apply)).
:- use_module(library(dcg/basics)).
:- use_module(library(lists)).
:- use_module(library(option)).
:- use_module(library(process)).
:- use_module(library(pure_input)).
:- use_module(rules(store)).

:- meta_predicate
    patterns_checked(1, -),
    patterns_checked(+, 1, -).

%!  patterns_checked(:Write, -Results) is det.
%!  patterns_checked(+Options, :Write, -Results) is det.
%
%   Results is what the checker says of each pattern that call(Write, Out)
%   writes: dicts with its keys and `name`. Options are arguments: '-v'.
%
%   @error process_error(pattern_checker, Status) if it cannot read them.

patterns_checked(Write, Results) :-
    patterns_checked([], Write, Results).

patterns_checked(Options, Write, Results) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(txt), encoding(utf8)]),
        ( call(Write, Out),
          close(Out),
          file_checked(Options, File, Results) ),
        ( close(Out, [force(true)]),
          delete_file(File) )).

file_checked(Options, File, Results) :-
    absolute_file_name(foreign('tests/pattern_checker'), Program,
                       [access(execute)]),
    append(Options, [File], Arguments),
    setup_call_cleanup(
        process_create(Program, Arguments,
                       [ stdout(pipe(Out)), stderr(std), process(Id) ]),
        phrase_from_stream(results(Results), Out),
        ( close(Out),
          process_wait(Id, Status) )),
    (   Status == exit(0)
    ->  true
    ;   throw(error(process_error(pattern_checker, Status), _))
    ).

results([Result|Results]) -->
    string_without(`:\n `, Name),
    ": ",
    !,
    words(Pairs),
    "\n",
    { atom_codes(NameAtom, Name),
      dict_pairs(Result, pattern, [name-NameAtom|Pairs])
    },
    results(Results).
results(Results) -->
    "  ",
    !,
    string_without(`\n`, Codes),
    "\n",
    { format(user_error, "~s~n", [Codes]) },
    results(Results).
results([]) -->
    eos.

words([Key-Value|Words]) -->
    string_without(`=\n`, Codes),
    "=",
    string_without(` \n`, ValueCodes),
    { atom_codes(Key, Codes),
      value(ValueCodes, Value)
    },
    (   " "
    ->  words(Words)
    ;   { Words = [] }
    ).

value(`inf`, Value) :-
    !,
    Value is inf.
value(Codes, Value) :-
    atom_codes(Atom, Codes),
    (   atom_number(Atom, Number)
    ->  Value = Number
    ;   Value = Atom
    ).

%!  bad_pattern(+Result, +Precision, -Fault) is nondet.
%
%   Fault is what is wrong by Result, if all must be exact to Precision of the
%   model. Of a polygon that is not quite flat corners are off by as much.

bad_pattern(Result, _, not_exact) :-
    Result.exact \== yes.
bad_pattern(Result, Precision, Key-Value) :-
    member(Key, [fold,shape,angle]),
    Value = Result.get(Key),
    \+ Value =< Precision + 2*Result.bend.
bad_pattern(Result, Precision, Key-Value) :-
    member(Key, [area,total]),
    Value = Result.get(Key),
    \+ Value =< Precision.

                /*******************************
                *       WHAT IT IS TOLD        *
                *******************************/

%!  write_pattern(+Out, +Name, +D, +Told) is det.
%
%   Write the pattern D of the current world, and what it was made of. Name is
%   an atom without spaces; Told are options: removed(Ps), polygons that were
%   left out; reported(Seam, Pieces), what was said of it; tabs(Tabs), terms
%   tab(E, [X-Y, ...]); spread(Step), piece K is moved by K*Step first.

write_pattern(Out, Name, D, Told) :-
    once(from_v(D, _, S, _)),
    write_solid(Out, S),
    option(removed(Removed), Told, []),
    forall(member(P, Removed), write_line(Out, removed(P))),
    option(spread(Step), Told, 0),
    write_flat(Out, D, S, Step),
    option(tabs(Tabs), Told, []),
    forall(member(tab(E, Corners0), Tabs),
           ( edge_polygon(D, E, P),
             maplist(moved(D, P, Step), Corners0, Corners),
             write_line(Out, 'T'(E,Corners)) )),
    forall(member(reported(Seam,Pieces), Told),
           write_line(Out, reported(Seam,Pieces))),
    write_line(Out, end(Name)).

write_solid(Out, S) :-
    forall(v(S, V, X, Y, Z), write_line(Out, v(V,X,Y,Z))),
    forall(e(S, E, A, B, 1), write_line(Out, e(E,A,B))),
    forall(p(S, P, Es0),
           ( include(is_real(S), Es0, Es),
             write_line(Out, p(P,Es)) )),
    forall(t(S, P, _, A, B, C), write_line(Out, t(P,A,B,C))).

is_real(S, E) :-
    e(S, E, _, _, 1).

write_flat(Out, D, S, Step) :-
    forall(( v(D, W, X0, Y0, _), from_v(D, W, S, V) ),
           ( spread(D, W, Step, X0-Y0, X-Y),
             write_line(Out, 'V'(W,X,Y,V)) )),
    forall(e(D, E, A, B, 1),
           ( edge_before(D, S, E, E0),
             write_line(Out, 'E'(E,A,B,E0)) )),
    forall(p(D, P, Es0),
           ( include(is_real(D), Es0, Es),
             polygon_before(D, S, P, P0),
             piece(D, P, K),
             write_line(Out, 'P'(P,P0,K,Es)) )),
    forall(joint(D, _, E1, E2, Kind, Angle),
           write_line(Out, 'J'(E1,E2,Kind,Angle))).

%   spread(D, W, Step, At0, At): the place of vertex W.

spread(_, _, 0, At, At) :-
    !.
spread(D, W, Step, At0, At) :-
    once(( e(D, E, W, _, 1), edge_polygon(D, E, P) )),
    moved(D, P, Step, At0, At).

moved(D, P, Step, X0-Y, X-Y) :-
    once(piece(D, P, K)),
    X is X0+K*Step.

%   edge_before(D, S, E, E0): E was E0, or a part of it; 0: it is new.

edge_before(D, S, E, E0) :-
    (   origin(D, e(E), e(Root))
    ->  E0 = Root
    ;   e(S, E, _, _, 1)
    ->  E0 = E
    ;   E0 = 0
    ).

polygon_before(D, S, P, P0) :-
    (   from_p(D, P, S, Root, _)
    ->  P0 = Root
    ;   P0 = P
    ).

%!  write_line(+Out, +Line) is det.
%
%   Write a line of the checker's file: name and arguments of the term Line,
%   with the members of lists, X-Y being two.

write_line(Out, Line) :-
    Line =.. [Word|Arguments],
    write(Out, Word),
    maplist(write_argument(Out), Arguments),
    nl(Out).

write_argument(Out, Argument) :-
    is_list(Argument),
    !,
    maplist(write_argument(Out), Argument).
write_argument(Out, X-Y) :-
    !,
    write_argument(Out, X),
    write_argument(Out, Y).
write_argument(Out, Argument) :-
    put_char(Out, ' '),
    write(Out, Argument).
