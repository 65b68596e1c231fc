:- module(sg_answer_name,
          [ shown_names/2               % +Goal, -Names
          ]).
:- use_module('../store', [relation/3, relation_column/5]).
:- use_module(ask_hidden, [hidden_edge/3]).
:- use_module(library(lists), [member/2]).
/** <module> What an answer is about, by the names of lines and parts
(select.pl), so that pictures can light it.
*/

%!  shown_names(+Goal, -Names:list) is det.
%
%   Names are those of the rows that the relations in Goal, which is true, have:
%   e(1, 7, ...) is about s1e7, segment(2, ...) about s2. Each is there once.

shown_names(Goal, Names) :-
    findall(Name, ( inner_goal(Goal, Inner), row_name(Inner, Name) ), Names0),
    sort(Names0, Names).

inner_goal(Goal, _) :-
    var(Goal),
    !,
    fail.
inner_goal(_:Goal, Inner) :-
    !,
    inner_goal(Goal, Inner).
inner_goal(Goal, Inner) :-
    control(Goal, Parts),
    !,
    arg(_, Parts, Part),
    inner_goal(Part, Inner).
inner_goal(Goal, Goal).

control((A,B), both(A,B)).
control((A;B), both(A,B)).
control((A->B), both(A,B)).
control((A*->B), both(A,B)).
control(once(A), one(A)).

row_name(Goal, Name) :-
    about(Goal, Parts),
    member(Part, Parts),
    part_name(Part, Name).
row_name(Goal, Name) :-
    callable(Goal),
    functor(Goal, Relation, Arity),
    relation(Relation, Arity, _),
    (   column(Relation, 'L', Goal, L)
    ->  format(string(Name), "l~d", [L])
    ;   column(Relation, 'S', Goal, S),
        (   part_column(Relation, Letter, Goal, Part)
        ->  format(string(Name), "s~d~w~d", [S,Letter,Part])
        ;   format(string(Name), "s~d", [S])
        )
    ).

%   about(Goal, Parts) is semidet: what Goal, a predicate that is no relation,
%   says something of.

about(Goal, Edges) :-
    nonvar(Goal),
    Goal = hides(S1, S2),
    integer(S1),
    integer(S2),
    !,
    findall(edge(S2,E), hidden_edge(S1, S2, E), Edges0),
    sort(Edges0, Edges).
about(Goal, Parts) :-
    nonvar(Goal),
    about_these(Goal, Parts).

about_these(hidden_by(S, E, _, _, _, _), [edge(S,E)]).
about_these(hidden_by_polygon(S, E, S2, P, _, _), [edge(S,E),polygon(S2,P)]).
about_these(touches(S, S2), [segment(S),segment(S2)]).
about_these(volume(S, _), [segment(S)]).
about_these(area(S, _), [segment(S)]).
about_these(bounding_box(S, _, _), [segment(S)]).

part_name(segment(S), Name) :-
    integer(S),
    format(string(Name), "s~d", [S]).
part_name(edge(S, E), Name) :-
    integer(S),
    integer(E),
    format(string(Name), "s~de~d", [S,E]).
part_name(polygon(S, P), Name) :-
    integer(S),
    integer(P),
    format(string(Name), "s~dp~d", [S,P]).

%   column(Relation, Name, Row, Id): Row has the Id in the column Name.

column(Relation, Name, Row, Id) :-
    relation_column(Relation, Position, Name, int, _),
    Argument is Position+1,
    arg(Argument, Row, Id),
    integer(Id).

part_column(Relation, Letter, Row, Part) :-
    relation_column(Relation, Position, Name, int, _),
    letter(Name, Letter),
    Argument is Position+1,
    arg(Argument, Row, Part),
    integer(Part),
    !.

letter('E', e).
letter('P', p).
letter('V', v).
letter('J', j).
