:- module(sg_csg_term,
          [ operation_form/2,           % ?Name, -Form
            misshapen/2,                % @Term, -Form
            operation_names/1,          % -Names
            near_operands/2,            % @Term, -Near
            is_node_term/1,             % @Term
            node_parts/4,               % +Term, -Operation, -Operands, -Steps
            plain_name/2,               % +Term, -Name
            map_operands/3,             % :Map, +Term0, -Term
            check_node_term/1,          % +Term
            csg_error/1                 % +What
          ]).
:- use_module('../primitive/primitive',
              [is_primitive/1, primitive/1, primitive_form/2]).
:- use_module('../primitive/primitive_argument',
              [finite_number/2, primitive_error/2]).
:- use_module('../primitive/placing', [step_motion/2]).
:- use_module('../spelling', [near_words/3]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> The terms of a CSG tree.

A node is a segment whose term, in the third place of segment/3, is

    union(Operands)             what is in any of them
    intersection(Operands)      what is in all of them
    difference(Operands)        what is in the first and in no other
    join(Operands)              their shells side by side, nothing cut
    glue(Operands)              all of them, what coincides once (glue.pl)
    split(Operand, By, Side)    the part of Operand on one Side of By
    at(Steps, Node)             placed (placing.pl)
    named(Name, Node)           with a name for rules

An operand is the number of a segment, a primitive, or such a term. By is
plane(A, B, C, D), with the Side `below` (A*X + B*Y + C*Z + D < 0) or `above`;
or a solid operand, with the Side `inside` or `outside`; or an open surface,
with the Side `below` (behind it) or `above`. In at/2 and named/2 a Node
may be the number of a segment too: that segment once more, placed.

Errors are model_error(csg(What)), What being

    no_list(Name, Operands)  no_operands(Name)  unknown(Operand)
    side(Side, Sides)        plane(By)
    missing(S, Child)        cycle(Path)
    curve(S, Child)          surface(S, Child, Name)
    cells(S, Child, Name)    placed(S)
    too_many(S, Leaves)      no_front(S)                not_through(S)

and those of primitives.
*/

:- meta_predicate map_operands(2, +, -).

%!  operation_form(?Name, -Form) is nondet.
%
%   Form is an atom that says how the operation Name is written.

operation_form(union, 'union([Operand, ...])').
operation_form(intersection, 'intersection([Operand, ...])').
operation_form(difference, 'difference([Operand, ...])').
operation_form(join, 'join([Operand, ...])').
operation_form(glue, 'glue([Operand, ...])').
operation_form(split, 'split(Operand, plane(A, B, C, D), below), or above; \c
                       split(Operand, Operand, inside), or outside').

%!  misshapen(@Term, -Form) is semidet.
%
%   True when Term has the name of an operation, but not its arguments, which
%   are as Form says; or is the mere name of a primitive.

misshapen(Term, Form) :-
    callable(Term),
    \+ is_node_term(Term),
    functor(Term, Name, _),
    (   operation_form(Name, Form)
    ->  true
    ;   atom(Term),
        primitive_form(Name, Form)
    ).

%!  operation_names(-Names) is det.
%
%   Names is an atom that lists the operations, for messages.

operation_names(Names) :-
    findall(Name, operation_form(Name, _), All),
    atomic_list_concat(All, ', ', Names).

%!  near_operands(@Term, -Near) is det.
%
%   Near are the names of operations and primitives that the one of Term may
%   be meant for.

near_operands(Term, Near) :-
    (   callable(Term)
    ->  functor(Term, Name, _),
        findall(Known, operand_word(Known), Words),
        near_words(Name, Words, Near)
    ;   Near = []
    ).

operand_word(Name) :-
    operation_form(Name, _).
operand_word(Name) :-
    primitive(Name).

%!  is_node_term(@Term) is semidet.
%
%   True when Term looks like a node: an operation, or such, or the number of a
%   segment, in at/2 or named/2. Its operands may still be wrong.

is_node_term(Term) :-
    compound(Term),
    (   wrapped(Term, Inner)
    ->  (   integer(Inner)
        ->  true
        ;   is_node_term(Inner)
        )
    ;   compound_name_arity(Term, Name, Arity),
        operation_arity(Name, Arity)
    ).

wrapped(at(_, Inner), Inner).
wrapped(named(_, Inner), Inner).

operation_arity(split, 3) :-
    !.
operation_arity(Name, 1) :-
    operation_form(Name, _).

%!  node_parts(+Term, -Operation, -Operands, -Steps) is det.
%
%   Term, a node, is Operation of Operands, in order, placed by Steps (inner
%   ones first). Operation is `union`, `intersection`, `difference`, `join`,
%   `same` (the operand once more), split(plane(A, B, C, D), Side) with one
%   operand, or split(Side) with two.

node_parts(at(Steps2, Node), Operation, Operands, Steps) :-
    !,
    node_parts(Node, Operation, Operands, Steps1),
    append(Steps1, Steps2, Steps).
node_parts(named(_, Node), Operation, Operands, Steps) :-
    !,
    node_parts(Node, Operation, Operands, Steps).
node_parts(split(Operand, By, Side), Operation, Operands, Steps) :-
    !,
    Steps = [],
    (   By = plane(_, _, _, _)
    ->  Operation = split(By, Side),
        Operands = [Operand]
    ;   Operation = split(Side),
        Operands = [Operand, By]
    ).
node_parts(Operand, Operation, Operands, Steps) :-
    integer(Operand),
    !,
    Operation = same,
    Operands = [Operand],
    Steps = [].
node_parts(Term, Operation, Operands, []) :-
    compound_name_arguments(Term, Operation, [Operands]).

%!  plain_name(+Term, -Name) is det.
%
%   Name is what the result of the node Term is called: the outermost name in
%   it, else its operation, else `placed`.

plain_name(named(Name0, _), Name) :-
    !,
    Name = Name0.
plain_name(at(_, Inner), Name) :-
    !,
    plain_name(Inner, Name).
plain_name(Term, Name) :-
    (   integer(Term)
    ->  Name = placed
    ;   functor(Term, Name, _)
    ).

%!  map_operands(:Map, +Term0, -Term) is det.
%
%   Term is the node Term0 with every operand X0 replaced by X, where
%   call(Map, X0, X). Not those within operands.

map_operands(Map, at(Steps, Node0), at(Steps, Node)) :-
    !,
    map_operands(Map, Node0, Node).
map_operands(Map, named(Name, Node0), named(Name, Node)) :-
    !,
    map_operands(Map, Node0, Node).
map_operands(Map, split(Operand0, By0, Side), split(Operand, By, Side)) :-
    !,
    call(Map, Operand0, Operand),
    (   By0 = plane(_, _, _, _)
    ->  By = By0
    ;   call(Map, By0, By)
    ).
map_operands(Map, Operand0, Operand) :-
    integer(Operand0),
    !,
    call(Map, Operand0, Operand).
map_operands(Map, Term0, Term) :-
    compound_name_arguments(Term0, Name, [Operands0]),
    maplist(Map, Operands0, Operands),
    compound_name_arguments(Term, Name, [Operands]).


                /*******************************
                *             FORM             *
                *******************************/

%!  check_node_term(+Term) is det.
%
%   Raise the first fault in the form of the node Term, operands included. That
%   of primitives is seen when they are made.
%
%   @error model_error(csg(What)), model_error(primitive(What, Step))

check_node_term(at(Steps, Node)) :-
    !,
    (   is_list(Steps)
    ->  maplist(check_step, Steps)
    ;   primitive_error(no_list(Steps), at(Steps, Node))
    ),
    check_node_term(Node).
check_node_term(named(_, Node)) :-
    !,
    check_node_term(Node).
check_node_term(split(Operand, By, Side)) :-
    !,
    check_operand(Operand),
    check_split(By, Side).
check_node_term(S) :-
    integer(S),
    !,
    check_operand(S).
check_node_term(Term) :-
    compound_name_arguments(Term, Name, [Operands]),
    (   \+ is_list(Operands)
    ->  csg_error(no_list(Name, Operands))
    ;   Operands == []
    ->  csg_error(no_operands(Name))
    ;   maplist(check_operand, Operands)
    ).

check_step(Step) :-
    (   step_motion(Step, _)
    ->  true
    ;   primitive_error(no_step(Step), Step)
    ).

check_operand(Operand) :-
    (   is_node_term(Operand)
    ->  check_node_term(Operand)
    ;   integer(Operand),
        Operand > 0
    ->  true
    ;   is_primitive(Operand),
        \+ hidden_unknown(Operand, _)
    ->  true
    ;   hidden_unknown(Operand, Unknown)
    ->  csg_error(unknown(Unknown))
    ;   csg_error(unknown(Operand))
    ).

%   hidden_unknown(Operand, Unknown): in at/2 or named/2 is what is none.

hidden_unknown(Operand, Unknown) :-
    wrapped(Operand, Inner),
    (   is_primitive(Inner)
    ->  hidden_unknown(Inner, Unknown)
    ;   Unknown = Inner
    ).

check_split(By, Side) :-
    (   By = plane(A, B, C, D)
    ->  check_plane([A, B, C, D], By),
        check_side(Side, [below, above])
    ;   check_operand(By),
        check_side(Side, [inside, outside, below, above])
    ).

check_plane(Numbers, By) :-
    (   maplist(finite_number, Numbers, [A, B, C, _]),
        member(N, [A, B, C]),
        N =\= 0
    ->  true
    ;   csg_error(plane(By))
    ).

check_side(Side, Sides) :-
    (   memberchk(Side, Sides)
    ->  true
    ;   csg_error(side(Side, Sides))
    ).

%!  csg_error(+What) is failure.
%
%   Raise model_error(csg(What)).

csg_error(What) :-
    throw(error(model_error(csg(What)), _)).
