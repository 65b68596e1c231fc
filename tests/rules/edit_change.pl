:- module(sg_test_edit_change,
          [ change/1                    % -Wrong
          ]).
/** <module> Random edits as no user would make them, inside transactions and
outside, with questions between them.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(sanggwan)).
:- use_module(rules(rows)).
:- use_module(rules(spans)).
:- use_module(rules(topology)).
:- use_module(rules(store), [column_domain/3]).  % not for users
:- use_module(tests('rules/edit_attempt')).
:- use_module(tests('rules/edit_question')).
:- use_module(tests('rules/edit_value')).

%!  change(-Wrong:list) is det.

change(Wrong) :-
    one_of([ bare, bare, bare, transaction, transaction, transaction, nested,
             undone, asked, asked, snapshot, cascade, undo, redo ],
           Kind),
    changed(Kind, Wrong).

changed(bare, Wrong) :-
    edit(Edit),
    attempt(Edit, Wrong).
changed(transaction, Wrong) :-
    edits(Edits),
    attempt(facts_transaction(maplist(tried, Edits)), Wrong).
changed(nested, Wrong) :-
    edits(Edits1),
    edits(Edits2),
    one_of([true, fail], End),
    attempt(facts_transaction(
                ( maplist(tried, Edits1),
                  ignore(facts_transaction(( maplist(tried, Edits2), End ))) )),
            Wrong).
changed(undone, Wrong) :-
    edits(Edits),
    attempt(facts_transaction(( maplist(tried, Edits), fail )), Wrong).
changed(asked, Wrong) :-
    edits(Edits),
    asked(Question),
    one_of([true, fail], End),
    attempt(facts_transaction(( maplist(tried, Edits), tried(Question), End )),
            Wrong).
changed(snapshot, Wrong) :-
    edits(Edits),
    asked(Question),
    attempt(facts_snapshot(( maplist(tried, Edits), tried(Question) )), Wrong).
changed(cascade, Wrong) :-
    edits(Edits),
    attempt(facts_transaction(maplist(tried, Edits), [cascade(true)]), Wrong).
changed(undo, Wrong) :-
    attempt(facts_undo, Wrong).
changed(redo, Wrong) :-
    attempt(facts_redo, Wrong).

edits(Edits) :-
    random_between(1, 4, N),
    findall(Edit, ( between(1, N, _), edit(Edit) ), Edits).

edit(Edit) :-
    one_of([ retract, retract, retract, retract_all, of_segment, all, add, add,
             replace, replace, copy ],
           Kind),
    relation_at_hand(Name, Arity),
    functor(Fact, Name, Arity),
    edit(Kind, Fact, Edit),
    !.
edit(true).

%   Mostly the rows that a user writes.

relation_at_hand(Name, Arity) :-
    (   maybe(0.6)
    ->  one_of([v/5, e/5, p/3, segment/3], Name/Arity)
    ;   findall(N/A,
                ( relation(N, A, _), functor(F, N, A), \+ \+ call(F) ),
                All),
        one_of(All, Name/Arity)
    ).

edit(retract, Fact, Edit) :-
    row(Fact),
    one_of([ retract_fact(Fact), retract_fact(Fact), retractall_facts(Fact),
             retract_fact(Fact, [cascade(true)]) ],
           Edit).
edit(retract_all, Fact, forall(retract_fact(Fact), true)) :-
    same_relation(Fact, Row),
    row(Row),
    arg(1, Row, S),
    arg(1, Fact, S).
edit(of_segment, Fact, retractall_facts(Fact)) :-
    maybe(0.5),
    same_relation(Fact, Row),
    row(Row),
    arg(1, Row, S),
    arg(1, Fact, S).
edit(all, Fact, retractall_facts(Fact)) :-
    maybe(0.1).
edit(add, Fact, assert_fact(Fact)) :-
    plausible(Fact).
edit(replace, Fact, ( retract_fact(Fact), assert_fact(New) )) :-
    row(Fact),
    altered(Fact, New).
edit(copy, Fact, assert_fact(New)) :-
    row(Fact),
    altered(Fact, New).

same_relation(Fact, Row) :-
    functor(Fact, Name, Arity),
    functor(Row, Name, Arity).

%   row(Fact): Fact becomes a row of its relation.

row(Fact) :-
    findall(Fact, limited(Fact), Rows),
    one_of(Rows, Fact).

limited(Fact) :-
    functor(Fact, Name, Arity),
    functor(Any, Name, Arity),
    (   random(5) =\= 0
    ->  Any = Fact,
        call_few(Any)
    ;   call(Any),
        Any = Fact
    ).

call_few(Goal) :-
    State = count(0),
    call(Goal),
    arg(1, State, N0),
    N is N0+1,
    nb_setarg(1, State, N),
    ( N >= 40 -> ! ; true ).

%   altered(Fact, New): one or two of its values are others.

altered(Fact, New) :-
    Fact =.. [Name|Values],
    length(Values, Arity),
    I is random(Arity),
    J is random(Arity),
    findall(Value,
            ( nth0(K, Values, Old),
              (   ( K =:= I ; K =:= J )
              ->  value(Name, K, Value)
              ;   Value = Old
              ) ),
            News),
    New =.. [Name|News].

plausible(Fact) :-
    Fact =.. [Name|Values],
    length(Values, Arity),
    Last is Arity-1,
    findall(Value, ( between(0, Last, K), value(Name, K, Value) ), Values).

value(Name, K, Value) :-
    (   column_domain(Name, K, Domain),
        maybe(0.95)
    ->  one_of(Domain, Value)
    ;   relation_column(Name, K, _, Type, _),
        typed(Type, Value)
    ).
