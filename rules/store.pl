:- module(sg_store,
          [ v/5,                      % ?S, ?V, ?X, ?Y, ?Z
            e/5,                      % ?S, ?E, ?V1, ?V2, ?Et
            p/3,                      % ?S, ?P, ?Es
            plane/6,                  % ?S, ?P, ?Nx, ?Ny, ?Nz, ?D
            t/6,                      % ?S, ?P, ?T, ?V1, ?V2, ?V3
            segment/3,                % ?S, ?Kind, ?Name
            origin/3,                 % ?S, ?Item, ?Origin
            line/9,                   % ?L, ?S1, ?P1, ?A1, ?B1, ?S2, ?P2, ?A2, ?B2
            view/3,                   % ?Theta, ?Phi, ?Rho
            projection/1,             % ?Kind
            screen/5,                 % ?S, ?V, ?Xs, ?Ys, ?Zs
            drawn/7,                  % ?D, ?S, ?E, ?From, ?To, ?Visibility, ?Role
            assert_fact/1,            % +Fact
            assert_fact/2,            % +Fact, -Row
            retract_fact/1,           % ?Fact
            retractall_facts/1,       % ?Fact
            edge_polygon/3,           % ?S, ?E, ?P
            vertex_triangle/3,        % ?S, ?V, ?T
            fact_row/2,               % ?Fact, ?Row
            row_value/4,              % +Relation, +Row, +Position, ?Value
            retract_row/2,            % +Relation, +Row
            facts_transaction/1,      % :Goal
            facts_snapshot/1,         % :Goal
            facts_undo/0,
            facts_redo/0,
            facts_undo_limit/1,       % +Steps
            new_world/1,              % -World
            in_world/2,               % +World, :Goal
            current_world/1,          % -World
            set_world/1,              % +World
            fresh_id/3,               % +Relation, +S, -Id
            relation/3,               % ?Name, ?Arity, ?Doc
            relation_column/5,        % ?Relation, ?Position, ?Column, ?Type,
                                      % ?Refers
            relation_key/2,           % ?Relation, -Positions
            column_doc/3,             % ?Relation, ?Position, ?Doc
            column_domain/3,          % ?Relation, ?Position, -Values
            facts_statistics/2        % ?Relation, -Statistics
          ]).

:- if(\+ predicate_property(sg_store:v(_,_,_,_,_), foreign)).
:- use_foreign_library(foreign(sanggwan)).
:- endif.

/** <module> The fact engine: relations, worlds, transactions.

The doors to engine/: every foreign predicate of the store is exported and
documented here. The relations themselves are listed, with their columns, in
engine/relations.def.

@see [PL] section 2; ARCHITECTURE.md
*/

:- meta_predicate
    facts_transaction(0),
    facts_snapshot(0),
    in_world(+, 0).

%!  edge_polygon(?S, ?E, ?P) is nondet.
%
%   True when edge E is in polygon P of segment S. Given S and E it is found
%   by an index; P in row order.

edge_polygon(S, E, P) :-
    integer(S),
    integer(E),
    !,
    '$edge_polygon'(S, E, P).
edge_polygon(S, E, P) :-
    p(S, P, Es),
    member(E, Es).

%!  vertex_triangle(?S, ?V, ?T) is nondet.
%
%   True when V is a corner of triangle T of segment S. Given S and V it is
%   found by an index; T in row order.

vertex_triangle(S, V, T) :-
    integer(S),
    integer(V),
    !,
    '$vertex_triangle'(S, V, T).
vertex_triangle(S, V, T) :-
    t(S, _, T, V1, V2, V3),
    sort([V1,V2,V3], Vs),
    member(V, Vs).

%!  facts_transaction(:Goal) is semidet.
%
%   Runs Goal once. Its changes stay when it succeeds; when it fails, raises
%   an exception or is interrupted, the world is as it was. Transactions
%   nest; the outermost one that changed anything is one step for
%   facts_undo/0. Other threads see none of its changes before it ends.

facts_transaction(Goal) :-
    setup_call_cleanup(
        '$begin'(World, Depth),
        (   call(Goal)
        ->  '$commit'(World, Depth)
        ),
        '$end'(World, Depth)).

%!  facts_snapshot(:Goal) is semidet.
%
%   Runs Goal once and takes its changes back, also when it succeeds.

facts_snapshot(Goal) :-
    setup_call_cleanup(
        '$begin'(World, Depth),
        once(Goal),
        '$end'(World, Depth)).

%!  in_world(+World, :Goal) is semidet.
%
%   Runs Goal once with World as the current world of this thread.

in_world(World, Goal) :-
    '$world'(Old),
    setup_call_cleanup(
        set_world(World),
        once(Goal),
        '$set_world'(Old)).

%!  relation(?Name, ?Arity, ?Doc) is nondet.
%
%   True when Name/Arity is a relation of the schema.

relation(Name, Arity, Doc) :-
    relation_number(_, Name, Arity, _, Doc).

relation_number(Number, Name, Arity, Key, Doc) :-
    between(0, inf, Number),
    (   '$relation'(Number, Name0, Arity0, Key0, Doc0)
    ->  Name = Name0,
        Arity = Arity0,
        Key = Key0,
        Doc = Doc0
    ;   !,
        fail
    ).

%!  relation_column(?Relation, ?Position, ?Column, ?Type, ?Refers) is nondet.
%
%   True when the column at Position (from 0, as in engine/relations.def) is
%   called Column; Type is one of int, float, list, atom, term; its ids must
%   be rows of the relation Refers, in the same segment (none: they need not).

relation_column(Relation, Position, Column, Type, Refers) :-
    column(Relation, Position, Column, Type, Refers, _, _).

%!  column_doc(?Relation, ?Position, ?Doc:string) is nondet.
%
%   True when Doc says what the column holds.

column_doc(Relation, Position, Doc) :-
    column(Relation, Position, _, _, _, _, Doc).

%!  column_domain(?Relation, ?Position, -Values:list) is nondet.
%
%   True when the column holds one of Values only.

column_domain(Relation, Position, Values) :-
    column(Relation, Position, _, _, _, Words, _),
    Words \== "",
    split_string(Words, " ", " ", Strings),
    maplist(domain_value, Strings, Values).

domain_value(String, Value) :-
    term_string(Value, String).

%!  relation_key(?Relation, -Positions:list(integer)) is nondet.
%
%   True when the columns at Positions together name a row of Relation: no two
%   rows have the same. Positions is never empty.

relation_key(Relation, Positions) :-
    relation_number(_, Relation, Arity, Mask, _),
    Mask > 0,
    Last is Arity-1,
    findall(Position,
            (   between(0, Last, Position),
                Mask /\ (1<<Position) =\= 0
            ),
            Positions).

column(Relation, Position, Column, Type, Refers, Domain, Doc) :-
    relation_number(Number, Relation, Arity, _, _),
    Last is Arity-1,
    between(0, Last, Position),
    '$column'(Number, Position, Column, Type, Refers, Domain, Doc).

%!  facts_statistics(?Relation, -Statistics:dict) is nondet.
%
%   Statistics is a dict with the rows, slots, bytes and index_bytes of a
%   relation, how many versions of the world are held, and how often the
%   relation was scanned and looked up by an index.

facts_statistics(Relation,
                 _{rows:Rows, slots:Slots, bytes:Bytes,
                   index_bytes:IndexBytes, versions:Versions,
                   scans:Scans, lookups:Lookups}) :-
    relation(Relation, _, _),
    '$statistics'(Relation, Rows, Slots, Bytes, IndexBytes, Versions,
                  Scans, Lookups).
