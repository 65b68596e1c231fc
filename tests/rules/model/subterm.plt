:- encoding(utf8).
:- module(test_subterm, []).
% covers: subterm4pl, vertex_list_rows
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(kernel)).
:- use_module(rules(plain), [cut_term/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/polygon_list)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

/* What the glue finds in terms, against the same in Prolog, of random terms;
   and lists of vertices against polygon_list.pl.
*/

random_part(0, Part) :-
    !,
    random_member(Part, [a,pi,[],1,-7,2.5,0,123456789012345678901,"text",_,
                         1r3,b]).
random_part(N, Part) :-
    N1 is N-1,
    random_between(0, 4, Arity),
    length(Parts, Arity),
    maplist(random_part(N1), Parts),
    random_member(Kind, [list,open,compound,compound,leaf]),
    (   Kind == list
    ->  Part = Parts
    ;   Kind == open
    ->  random_part(0, End),
        append(Parts, End, Part)
    ;   Kind == compound
    ->  random_member(Name, [f,g,pi,a]),
        compound_name_arguments(Part, Name, Parts)
    ;   random_part(0, Part)
    ).

slow_has(Term, Parts) :-
    sub_term_of(Term, Part),
    (   atom(Part)
    ->  Wanted = Part
    ;   compound(Part),
        compound_name_arity(Part, Name, Arity),
        Wanted = Name/Arity
    ),
    compound_name_arguments(Parts, _, List),
    memberchk(Wanted, List),
    !.

sub_term_of(Term, Term).
sub_term_of(Term, Part) :-
    compound(Term),
    compound_name_arguments(Term, _, Arguments),
    member(Argument, Arguments),
    sub_term_of(Argument, Part).

slow_plain(Term, _) :-
    ( atom(Term) ; Term == [] ; integer(Term) ),
    !.
slow_plain(Term, _) :-
    float(Term),
    !.
slow_plain(Term, Depth) :-
    compound(Term),
    Depth > 0,
    Depth1 is Depth-1,
    (   is_list(Term)
    ->  Arguments = Term
    ;   compound_name_arguments(Term, _, Arguments)
    ),
    forall(member(Argument, Arguments), slow_plain(Argument, Depth1)).

same(A, B) :-
    (   call(A)
    ->  call(B)
    ;   \+ call(B)
    ).

slow_fault(Vs, Fault) :-
    (   vertex_list_edges(Vs, Edges)
    ->  (   member(V-_, Edges),
            V > 6
        ->  Fault = missing(V)
        ;   polygon_fault(Edges, Fault)
        )
    ;   Fault = list
    ).

slow_chain(Vs, Fault) :-
    (   member(V, Vs),
        \+ between(1, 6, V)
    ->  Fault = missing(V)
    ;   append(_, [V,V|_], Vs)
    ->  Fault = chain(V)
    ).

random_vertex(Least, Most, V) :-
    random_between(Least, Most, V0),
    (   V0 =:= 0
    ->  V = 1
    ;   V = V0
    ).

compared(Vs) :-
    forall(member(Slow/Quick, [ slow_fault/vertex_list_fault,
                                slow_chain/chain_fault ]),
           (   findall(F, once(call(Slow, Vs, F)), Wanted),
               findall(F, call(Quick, 1, Vs, F), Found),
               assertion(Found == Wanted)
           )).

:- begin_tests(subterm).

test('has_part, plain_value as in Prolog') :-
    set_random(seed(23)),
    forall(between(1, 4000, _),
           ( random_between(0, 4, Deep),
             random_part(Deep, Term),
             random_member(Parts,
                           [p(f/2), p(a), p([]), p(pi,g/0,f/1), p(b,a/3)]),
             random_between(0, 5, Depth),
             (   same(has_part(Term, Parts), slow_has(Term, Parts)),
                 same(plain_value(Term, Depth), slow_plain(Term, Depth))
             ->  true
             ;   assertion(wrong(Term, Parts, Depth))
             ) )).
test('A long list, and one without an end, in time',
     [setup(numlist(1, 300_000, List)), true(T < 2.0)]) :-
    append(List, end, Open),
    statistics(cputime, T0),
    plain_value(List, 1),
    \+ plain_value(Open, 128),
    \+ has_part(List, p(f/1)),
    has_part(Open, p(end)),
    \+ has_part(Open, p(f/1)),
    statistics(cputime, T1),
    T is T1-T0.
test('As deep as there is memory') :-
    numlist(1, 300_000, List),
    foldl([_,T,f(T,1)]>>true, List, pi, Deep),
    has_part(Deep, p(pi)),
    \+ plain_value(Deep, 1000),
    plain_value(Deep, 300_000).
test('In itself: has_part', error(type_error(acyclic_term, _))) :-
    X = [a|X],
    has_part(X, p(b)).
test('In itself: plain_value', error(type_error(acyclic_term, _))) :-
    X = f(X),
    plain_value(X, 10).
test('No numbers of double that are none') :-
    Infinite is inf,
    Nan is nan,
    \+ plain_value([Infinite], 3),
    \+ plain_value(f(Nan), 3),
    \+ plain_value(_{a: 1}, 3).
test('Parts that are none', error(type_error(part, 7))) :-
    has_part(f(x), p(7)).
test('Who catches an error has its list, unless that is very long') :-
    numlist(1, 5000, Long),
    cut_term(value(p, list, Long, steps), Cut),
    Cut == value(p, list, Long, steps),
    numlist(1, 200_000, Longer),
    cut_term(value(p, list, Longer, steps), value(p, list, Some, steps)),
    length(Some, N),
    N < 1000,
    last(Some, ...).
test(id_list) :-
    id_list([], 1),
    id_list([1,2147483647], 1),
    id_list([-1,1,-2147483647], -0x7fffffff),
    forall(member(Bad, [[0],[-1],[a],[1.0],[2147483648],[1|_],[1|2],x,_,
                        [123456789012345678901]]),
           \+ id_list(Bad, 1)).
test('Lists of vertices as in Prolog') :-
    set_random(seed(5)),
    in_new_world(( forall(between(1, 6, V), assert_fact(v(1, V, V, 0, 0))),
                   assert_fact(segment(1, solid, a)),
                   forall(between(1, 6000, _),
                          ( random_between(1, 9, N),
                            length(Vs, N),
                            random_member(Least, [1,1,-6]),
                            random_member(Most, [6,6,6,6,7]),
                            maplist(random_vertex(Least, Most), Vs),
                            compared(Vs) )) )).

:- end_tests(subterm).
