:- module(sg_mutants_rules,
          [ rule_site/4,                % +File, -Start, -End, -New
            other_number/2              % +Number, -Other
          ]).
/* Where a rule may be changed, for mutants.pl. */

rule_site(File, Start, End, New) :-
    setup_call_cleanup(
        open(File, read, In, [encoding(utf8)]),
        findall(F-T-N,
                ( clause_of(In, Term, Position),
                  clause_site(Term, Position, F, T, N)
                ),
                Sites),
        close(In)),
    member(Start-End-New, Sites).

clause_of(In, Term, Position) :-
    repeat,
    read_term(In, Term, [ subterm_positions(Position),
                          module(sg_mutants_rules) ]),
    (   Term == end_of_file
    ->  !,
        fail
    ;   Term = (:- Directive)
    ->  operators(Directive),
        fail
    ;   true
    ).

operators(op(P,T,N)) :-
    !,
    op(P, T, N).
operators(module(_,Exports)) :-
    forall(member(op(P,T,N), Exports), op(P, T, N)).

clause_site((Head :- Body), term_position(_,_,_,_,[P,Q]), F, T, New) :-
    !,
    (   constant_site(Head, P, F, T, New)
    ;   goal_site(Body, Q, F, T, New)
    ).
clause_site((Head --> Body), term_position(_,_,_,_,[P,Q]), F, T, New) :-
    !,
    (   constant_site(Head, P, F, T, New)
    ;   dcg_site(Body, Q, F, T, New)
    ).
clause_site(Head, _, _, _, _) :-
    compound(Head),
    arg(_, Head, Language),
    nonvar(Language),
    memberchk(Language, [en,ko]),
    !,
    fail.
clause_site(Head, P, F, T, New) :-
    constant_site(Head, P, F, T, New).
clause_site(_, P, F, T, ":- true") :-
    arg(1, P, F),
    arg(2, P, T).

dcg_site(Body, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    dcg_site(Body, P, F, T, New).
dcg_site({Goal}, brace_term_position(_,_,P), F, T, New) :-
    !,
    goal_site(Goal, P, F, T, New).
dcg_site(Body, term_position(_,_,_,_,Ps), F, T, New) :-
    control(Body, Goals, Kinds),
    !,
    nth1(I, Goals, Goal),
    nth1(I, Ps, P),
    nth1(I, Kinds, _),
    dcg_site(Goal, P, F, T, New).
dcg_site(!, F-T, F, T, "[]") :-
    !.
dcg_site(Body, P, F, T, New) :-
    constant_site(Body, P, F, T, New).
dcg_site(Body, P, F, T, "[]") :-
    callable(Body),
    \+ is_list(Body),
    arg(1, P, F),
    arg(2, P, T).

%   goal_site(+Goal, +Position, -Start, -End, -New) is nondet.

goal_site(Goal, _, _, _, _) :-
    var(Goal),
    !,
    fail.
goal_site(Goal, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    goal_site(Goal, P, F, T, New).
goal_site(Goal, term_position(_,_,_,_,Ps), F, T, New) :-
    control(Goal, Goals, Kinds),
    !,
    nth1(I, Goals, Inner),
    nth1(I, Ps, P),
    nth1(I, Kinds, Kind),
    (   goal_site(Inner, P, F, T, New)
    ;   Kind == condition,
        \+ control(Inner, _, _),
        arg(1, P, F),
        arg(2, P, T),
        New = negated
    ).
goal_site(\+ _, term_position(_,_,F,T,[_]), F, T, " ").
goal_site(\+ Goal, term_position(_,_,_,_,[P]), F, T, New) :-
    !,
    goal_site(Goal, P, F, T, New).
goal_site(!, F-T, F, T, "true") :-
    !.
goal_site(true, _, _, _, _) :-
    !,
    fail.
goal_site(fail, _, _, _, _) :-
    !,
    fail.
goal_site(_, P, F, T, "true") :-
    arg(1, P, F),
    arg(2, P, T).
goal_site(Goal, term_position(_,_,_,_,Ps), F, T, New) :-
    meta(Goal, Places),
    member(I, Places),
    nth1(I, Ps, P),
    arg(I, Goal, Inner),
    goal_site(Inner, P, F, T, New).
goal_site(Goal, term_position(_,_,F,T,[_,_]), F, T, New) :-
    functor(Goal, Name, 2),
    neighbours(Name, News),
    member(New, News).
goal_site(Goal, term_position(_,_,_,_,Ps), F, T, New) :-
    arithmetic(Goal),
    member(I, [1,2]),
    arg(I, Goal, Expression),
    nth1(I, Ps, P),
    expression_site(Expression, P, F, T, New).
goal_site(Goal, P, F, T, New) :-
    \+ meta(Goal, _),
    constant_site(Goal, P, F, T, New).

control((A,B), [A,B], [goal,goal]).
control((A;B), [A,B], [branch,branch]).
control((A->B), [A,B], [condition,goal]).
control((A*->B), [A,B], [condition,goal]).

meta(findall(_,_,_), [2]).
meta(findall(_,_,_,_), [2]).
meta(aggregate_all(_,_,_), [2]).
meta(forall(_,_), [1,2]).
meta(once(_), [1]).
meta(ignore(_), [1]).
meta(catch(_,_,_), [1,3]).
meta(setup_call_cleanup(_,_,_), [1,2,3]).
meta(call_cleanup(_,_), [1,2]).
meta(facts_transaction(_), [1]).

neighbours(<, ["=<", ">"]).
neighbours(=<, ["<", ">="]).
neighbours(>, [">=", "<"]).
neighbours(>=, [">", "=<"]).
neighbours(=:=, ["=\\="]).
neighbours(=\=, ["=:="]).
neighbours(==, ["\\=="]).
neighbours(\==, ["=="]).
neighbours(\=, ["="]).
neighbours(@<, ["@=<", "@>"]).
neighbours(@>, ["@>=", "@<"]).
neighbours(@=<, ["@<", "@>="]).
neighbours(@>=, ["@>", "@=<"]).

arithmetic(Goal) :-
    functor(Goal, Name, 2),
    memberchk(Name, [is,<,=<,>,>=,=:=,=\=]).

%   expression_site(+Expression, +Position, -Start, -End, -New) is nondet.

expression_site(E, _, _, _, _) :-
    var(E),
    !,
    fail.
expression_site(E, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    expression_site(E, P, F, T, New).
expression_site(E, term_position(_,_,F,T,_), F, T, New) :-
    functor(E, Name, Arity),
    operator(Name, Arity, New).
expression_site(E, term_position(_,_,_,_,Ps), F, T, New) :-
    nth1(I, Ps, P),
    arg(I, E, Inner),
    expression_site(Inner, P, F, T, New).

operator(+, 2, "-").
operator(-, 2, "+").
operator(*, 2, "/").
operator(/, 2, "*").
operator(//, 2, "*").
operator(min, 2, "max").
operator(max, 2, "min").
operator(-, 1, "+").
operator(abs, 1, "+").
operator(floor, 1, "ceiling").
operator(ceiling, 1, "floor").
operator(sin, 1, "cos").
operator(cos, 1, "sin").

%   constant_site(+Term, +Position, -Start, -End, -New) is nondet.

constant_site(Term, _, _, _, _) :-
    var(Term),
    !,
    fail.
constant_site(Number, F-T, F, T, New) :-
    number(Number),
    !,
    other_number(Number, New).
constant_site(Term, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    constant_site(Term, P, F, T, New).
constant_site(Term, term_position(_,_,_,_,Ps), F, T, New) :-
    nth1(I, Ps, P),
    arg(I, Term, Inner),
    constant_site(Inner, P, F, T, New).
constant_site({Term}, brace_term_position(_,_,P), F, T, New) :-
    constant_site(Term, P, F, T, New).
constant_site(List, list_position(_,_,Ps,_), F, T, New) :-
    nth1(I, Ps, P),
    item(I, List, Item),
    constant_site(Item, P, F, T, New).

item(1, [X|_], X) :-
    !.
item(I, [_|Xs], X) :-
    I1 is I - 1,
    item(I1, Xs, X).

other_number(N, New) :-
    integer(N),
    !,
    (   N =:= 0
    ->  Others = [1]
    ;   Up is N + 1,
        Down is N - 1,
        Others = [Up,Down]
    ),
    member(New, Others).
other_number(N, New) :-
    float(N),
    (   N =:= 0.0
    ->  Others = [1.0]
    ;   catch(Double is N*2, _, Double = 1.0),
        Others = [0.0,Double]
    ),
    member(New, Others).
