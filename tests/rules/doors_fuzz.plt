/* Every door with arguments drawn by their types, some of them wrong, and with
   handles in whatever state they are: each call answers, fails, or raises one
   of the errors that doors have.

   `DOOR_CALLS=N make check-rules T=doors_fuzz` makes N calls.
*/
:- use_module('../../tools/doors_declared').
:- use_module(rules(kernel)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).
:- use_module(tests(rules/sample), [few/3]).

                /*******************************
                *           ARGUMENTS          *
                *******************************/

:- dynamic handle/2, surprise/2.

%   drawn(Type, Argument): mostly of the Type.

drawn(Type, Argument) :-
    (   maybe(0.06)
    ->  wrong(Argument)
    ;   right(Type, Argument)
    ).

wrong(Argument) :-
    Cyclic = [1|Cyclic],
    NaN is nan,
    Infinite is inf,
    random_member(Argument,
                  [ _, a, "text", 0, -1, 1.5, NaN, Infinite, 1r3, 4294967297,
                    99999999999999999999, [], [1|_], Cyclic, f(x), f(_), 1-2,
                    [a], [1,1,1], none, user_input, closed
                  ]).

right(list(Type), List) :-
    !,
    random_between(0, 4, N),
    length(List, N),
    maplist(drawn(Type), List).
right(set(Type), List) :-
    !,
    right(list(Type), List).
right(Type, Argument) :-
    simple(Type, Argument),
    !.
right(Type, Argument) :-
    type(Type, What),
    composed(What, Type, Argument).

simple(id, N) :- random_between(1, 9, N).
simple(int, N) :- random_between(-3, 9, N).
simple(integer, N) :- random_between(-3, 9, N).
simple(count, N) :- random_between(0, 9, N).
simple(number, X) :- random_member(X, [0, 1, 0.5, -2.25, 90, 1.0e-9, 1.0e30]).
simple(exact, X) :- random_member(X, [0, 1r3, 0.5, -2.25, 7]).
simple(bool, B) :- random_member(B, [true,false]).
simple(sense, N) :- random_member(N, [1,-1]).
simple(symbol, A) :- random_member(A, [visible,hidden,outline,crease]).
simple(bytes, "\u0001\u0002\u0003").
simple(name, A) :- random_member(A, ['', name, "text", f(x), '\u00e4']).
simple(text, T) :- random_member(T, ["v(1,2).", "f(((", "'", ""]).
simple(term, T) :- random_member(T, [a, f(1), [1,2], "text", 0.5, 1r3, v(1)]).
simple(input, In) :-
    (   maybe(0.9)
    ->  random_member(Text, [ "", "cube();", "x", "OFF\n1 1 0\n0 0 0\n",
                              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                            ]),
        open_string(Text, In)
    ;   In = user_output
    ).
simple(output, Out) :-
    random_member(Out, [user_input,no_stream]).
simple(text_output, Out) :-
    simple(output, Out).

composed(handle(_,_,_), Type, Handle) :-
    findall(H, handle(Type, H), Handles),
    (   random_member(Handle0, Handles)
    ->  Handle = Handle0
    ;   Handle = none
    ).
composed(words(_,_,Words), _, Word) :-
    random_member(Word, Words).
composed(record(_,_,Name,Fields), _, Term) :-
    maplist(field, Fields, Arguments),
    Term =.. [Name|Arguments].
composed(either(_,Alternatives), _, Term) :-
    random_member(Alternative, Alternatives),
    (   Alternative = _:Type
    ->  drawn(Type, Term)
    ;   Alternative =.. [Name|Fields],
        maplist(field, Fields, Arguments),
        Term =.. [Name|Arguments]
    ).

field(_:Type, Argument) :-
    (   Type == any
    ->  true
    ;   drawn(Type, Argument)
    ).

                /*******************************
                *             CALLS            *
                *******************************/

%   doors(Doors): Module:door(Name, Arguments, Determinism) of all topics.

:- table doors/1.

doors(Doors) :-
    read_types('c_kernels/doors.def'),
    expand_file_name('rules/kernel/*.pl', Files),
    maplist(topic_doors, Files, Topics),
    findall(Module:Door,
            ( member(topic(Topic,OfTopic), Topics),
              atom_concat(sg_kernel_, Topic, Module),
              member(Door, OfTopic)
            ),
            Doors).

%   called(Door): once, with what it answers kept if it is a handle.

called(Module:door(Name,Arguments,_)) :-
    maplist(value, Arguments, Values),
    Goal =.. [Name|Values],
    catch((   Module:Goal
          ->  maplist(kept, Arguments, Values)
          ;   true
          ),
          Error,
          judged(Goal, Error)).

value(arg(Mode,_,Type), Value) :-
    (   ( Mode == (-) ; Mode == (?), maybe )
    ->  true
    ;   drawn(Type, Value)
    ).

kept(arg(Mode,_,Type), Value) :-
    (   Mode == (-),
        is_handle(Type),
        aggregate_all(count, handle(Type, _), N),
        N < 20
    ->  assertz(handle(Type, Value))
    ;   true
    ).

judged(Goal, Error) :-
    (   Error = error(Formal,_),
        nonvar(Formal),
        functor(Formal, Kind, _),
        memberchk(Kind,
                  [ instantiation_error, type_error, domain_error,
                    existence_error, permission_error, representation_error,
                    geometry_error, io_error, resource_error
                  ])
    ->  true
    ;   assertz(surprise(Goal, Error))
    ).

in_a_world(Calls) :-
    forall(member(At, [0,1]),
           add_primitive(at([translate(At,At,At)], box(size(2,2,2))), _)),
    complete_segments,
    doors(Doors),
    forall(between(1, Calls, _),
           ( random_member(Door, Doors),
             facts_snapshot(called(Door))
           )).

%   wrong_word(Module:Door, Type): a Door that gets a word that Type has not.
%   Handles, of which there may be none, are looked at before it, as are other
%   arguments, which may be wrong too.

wrong_word(Module:door(Name,Arguments,_), Type) :-
    nth1(At, Arguments, arg(+,_,Type)),
    type(Type, words(_,_,_)),
    forall(( nth1(Before, Arguments, arg(+,_,Other)), Before < At ),
           \+ is_handle(Other)),
    maplist(right_value, Arguments, Values0),
    nth1(At, Values0, _, Rest),
    nth1(At, Values, no_such_word, Rest),
    Goal =.. [Name|Values],
    catch(ignore(Module:Goal), error(Formal,_), true),
    assertion(nonvar(Formal)),
    Formal == domain_error(Type, no_such_word).

right_value(arg(Mode,_,Type), Value) :-
    (   Mode == (-)
    ->  true
    ;   right(Type, Value)
    ).

:- begin_tests(doors_fuzz,
               [cleanup(( retractall(handle(_,_)),
                          retractall(surprise(_,_)) ))]).

test(calls, Surprises == []) :-
    few(8000, 100000, Few),
    (   getenv('DOOR_CALLS', Text)
    ->  atom_number(Text, N)
    ;   N = Few
    ),
    set_random(seed(17)),
    in_new_world(in_a_world(N)),
    findall(G-E, surprise(G, E), Surprises),
    aggregate_all(count, handle(_,_), Handles),
    assertion(Handles > 10).

test(wrong_words) :-
    doors(Doors),
    in_new_world(findall(Type, ( member(Door, Doors),
                                 wrong_word(Door, Type) ), Types)),
    sort(Types, Sorted),
    assertion(Sorted = [_,_,_,_|_]).

:- end_tests(doors_fuzz).
