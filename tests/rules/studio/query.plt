:- encoding(utf8).
:- module(test_query, []).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(rules(studio/query)).

foo(_, _, _).

%   reading_of(Around, N, Steps): of a goal with N variables.

reading_of(Around, N, Steps) :-
    findall(V, ( between(1, N, I), format(atom(V), "V~d", [I]) ), Vs),
    atomic_list_concat(Vs, ', ', Text),
    format(string(Goal), Around, [Text]),
    statistics(inferences, Before),
    read_goal(Goal, _, _),
    statistics(inferences, After),
    Steps is After-Before.

row(1, a, "text").
row(2.5, 'B c', [1,2]).
row(-3, 'x,"y"', f(_)).

printed(Text, Options, Output) :-
    read_goal(Text, Goal, Bindings),
    with_output_to(string(Output),
                   ignore(query(test_query:Goal,
                                [bindings(Bindings)|Options]))).

:- begin_tests(query).

test(table, T == "  A  B\n  1  a\n2.5  'B c'\n -3  'x,\"y\"'\n") :-
    printed("row(A,B,_C)", [], T).
test(csv, T == "A,B\n1,a\n2.5,B c\n-3,\"x,\"\"y\"\"\"\n") :-
    printed("row(A,B,_C)", [format(csv)], T).
test(json, A =@= [_{'A':1}, _{'A':2.5}, _{'A': -3}]) :-
    printed("row(A,_,_)", [format(json)], T),
    atom_json_dict(T, A, []).
test(json_text, A =@= [_{'B':"B c", 'C':[1,2]}]) :-
    printed("row(2.5,B,C)", [format(json)], T),
    atom_json_dict(T, A, [value_string_as_atom(true)]).
test(json_none, A == []) :-
    printed("row(7,_,_)", [format(json)], T),
    atom_json_dict(T, A, []).
test(prolog, Goals =@= [row(1,a,"text"), row(2.5,'B c',[1,2]),
                        row(-3,'x,"y"',f('$VAR'(0)))]) :-
    printed("row(A,B,C)", [format(prolog)], T),
    open_string(T, S),
    findall(G, ( repeat, read_term(S, G, [var_prefix(false)]),
                 ( G == end_of_file -> !, fail ; true ) ), Goals0),
    maplist([G0,G1]>>( G0 = row(A,B,f(V)), var(V)
                     -> G1 = row(A,B,f('$VAR'(0))) ; G1 = G0 ),
            Goals0, Goals).
% Unbound variables are A, B, ... of each answer, the same one twice alike.
test(variables_csv, T == "A,B\n\"f(A,B,A)\",A\ng(A),B\n") :-
    printed("member(A-B, [f(_X,_Y,_X)-_X, g(_)-_])", [format(csv)], T).
test(variables_table, T == "B       A\nf(A,B)  A\n") :-
    printed("B = f(A,_)", [], T).
test(variables_prolog, T == "foo(A, B, A).\n") :-
    printed("foo(A,B,A)", [format(prolog)], T).
test(limit, T == "A\n1\n") :-
    printed("row(A,_,_)", [format(csv), limit(1)], T).
test(yes, T == "yes\n") :-
    printed("row(1,_,_)", [], T).
test(nothing, T == "") :-
    printed("row(7,_,_)", [], T).
test(no_answer, fail) :-
    read_goal("row(7,_,_)", G, B),
    query(test_query:G, [bindings(B)]).
% Twice as many variables take twice as long, not four times.
test(many_variables) :-
    forall(member(Around, ["X = f(~w)","findall(x, f(~w), X)",
                           "bagof(x, f(~w), X)"]),
           ( reading_of(Around, 2000, Few),
             reading_of(Around, 16000, Many),
             assertion(Many < 20*Few) )).
test(order_of_text, Names == ['B', 'A']) :-
    read_goal("foo(B,A,B,_X,_)", _, Bindings),
    pairs_keys(Bindings, Names).
% What no answer binds is not shown; what also stands elsewhere is.
test(answered, [ forall(member(Text-Names,
        [ "setof(P, L^p(1,P,L), Ps)"-['Ps'],
          "bagof(P-L, p(S,P,L), Ps)"-['S','Ps'],
          "findall(X, v(1,X,_,_,_), L), Y = 3"-['L','Y'],
          "X = 1, findall(X, p(1,X,_), L)"-['X','L'],
          "\\+ v(S,V,_,_,_)"-[], "forall(p(S,P,_), P > 0), A = 1"-['A'],
          "( A = 1 ; findall(B, member(B, [1]), C) )"-['A','C'],
          "aggregate_all(count, v(S,_,_,_,_), N)"-['N'],
          "setof(P, G, Ps)"-['G','Ps'], "X^foo(X,Y)"-['X','Y'] ])),
                 Shown == Names ]) :-
    read_goal(Text, _, Bindings),
    pairs_keys(Bindings, Shown).
test(one_goal, [ forall(member(Text, ["X = 1. fail.", "X = 1. fail",
                                      "a. foo(", "a.\n\nb."])),
                 error(usage_error(bad_goal(Text, after_full_stop))) ]) :-
    read_goal(Text, _, _).
test(one_goal_with_remark, forall(member(Text, ["a. % b.", "a. /* b. */ ", "a",
                                                "a % b", "X = 'a. b.'"]))) :-
    read_goal(Text, _, _).
test(syntax, error(usage_error(bad_goal(_, _)))) :-
    read_goal("foo(", _, _).
test(no_goal, error(usage_error(bad_goal(_, not_callable)))) :-
    read_goal("5", _, _).

:- end_tests(query).
