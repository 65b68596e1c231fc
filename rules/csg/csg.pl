:- module(sg_csg,
          [ node/4,                     % ?N, ?Operation, ?Children, ?Placement
            root_segment/1,             % ?S
            root_segments_after/2,      % +Last, -Roots
            operand_segment/2,          % ?S, ?N
            glue_operands/2,            % +S, -Operands
            glue_tolerance/3,           % +Given, +S, -Tolerance
            tree_tolerance/2,           % +S, -Tolerance
            tolerance_kept/2,           % +S, +Tolerance
            is_node/1,                  % +S
            is_helper/1,                % +S
            written_leaves/2,           % +Term, -Count
            complete_tree/1,            % +Nodes
            complete_tree/2,            % +Nodes, -Incomplete
            complete_leaf/4             % +N, +S, -Kind, -Incomplete
          ]).
:- use_module('../limits', [limit_value/2]).
:- use_module(csg_term,
              [ is_node_term/1, node_parts/4, map_operands/3,
                check_node_term/1
              ]).
:- use_module('../kernel', [id_list/2, kept_leaves/2]).
:- use_module('../primitive/primitive_rows',
              [add_primitive/2, primitive_rows/3, rows_left_out/0]).
:- use_module(csg_record,
              [record/2, recorded/2, up_to_date/2, made_and_kept/2]).
:- use_module(csg_rows, [drop_boundary/1]).
:- use_module(operand_name, [fault_named/2, note_unnumbered/3]).
:- use_module('../primitive/primitive', [is_primitive/1]).
:- use_module('../store',
              [ v/5, p/3, t/6, segment/3, origin/3, gluing/2, assert_fact/1,
                retractall_facts/1, facts_transaction/1, fresh_id/3
              ]).
:- use_module(library(apply), [exclude/3, foldl/4, foldl/5, maplist/4]).
:- use_module(library(assoc), [empty_assoc/1, get_assoc/3, put_assoc/4]).
:- use_module(library(lists),
              [append/3, list_to_set/2, max_list/2, member/2, reverse/2]).
:- use_module(library(ordsets), [ord_memberchk/2, ord_subtract/3]).
/** <module> The CSG tree: nodes, operands, roots.

A segment whose term is an operation (csg_term.pl) is a *node*; its boundary is
its own rows, made by csg_evaluate.pl. Other segments are *leaves*. A segment
may be an operand of several nodes, so the tree is a graph without cycles. What
is no operand is a *root*: the model that is drawn, checked and written.

Helpers are leaves that evaluation makes: a leaf placed elsewhere, a half-space.
They have origin(S, node(S), helper(From)) and are neither roots nor written.

@see row CB-1
*/

%!  node(?N, ?Operation, ?Children, ?Placement) is nondet.
%
%   True when segment N is a node: Operation of Children, a list of segments in
%   order, placed by Placement, a list of steps. Operation is `union`,
%   `intersection`, `difference`, `join`, `glue`, `same` (its child once more),
%   split(plane(A,B,C,D), Side), or split(Side): of the first child by the
%   second. Of a leaf it is `leaf`, without children. An operand that has no
%   number yet (complete_tree/1) is its term.
%
%   @see CB-1

node(N, Operation, Children, Placement) :-
    segment(N, _, Term),
    \+ is_helper(N),
    (   is_node_term(Term)
    ->  node_parts(Term, Operation, Children, Placement)
    ;   Operation = leaf,
        Children = [],
        Placement = []
    ).

%!  glue_operands(+S, -Operands:list) is det.
%
%   Operands are those of the glue S, and of glues among them, each once, in
%   order.

glue_operands(S, Operands) :-
    phrase(glue_operands(S), Operands0),
    (   sort(Operands0, Operands0)      % as it mostly is
    ->  Operands = Operands0
    ;   list_to_set(Operands0, Operands)
    ).

glue_operands(S) -->
    { node(S, glue, Children, _) },
    !,
    { kept_leaves(Children, Kinds) },
    glue_operands_(Children, Kinds).
glue_operands(S) -->
    [S].

glue_operands_([], []) -->
    [].
glue_operands_([S|Ss], [Kind|Kinds]) -->
    (   { Kind == other }
    ->  glue_operands(S)
    ;   [S]
    ),
    glue_operands_(Ss, Kinds).

%!  glue_tolerance(+Given, +S, -Tolerance) is det.
%
%   Tolerance is Given or, if that is `default`, what gluing(S, tolerance(T))
%   says of the glue S, or else the largest that the glues among its operands
%   say; or `default`.
%
%   @error geometry_error(part_glue(wish(S, tolerance(T)))): T is no number, or
%          less than 0

glue_tolerance(default, S, Tolerance) :-
    gluing(_, tolerance(_)),
    !,
    (   gluing(S, tolerance(T))
    ->  tolerance_checked(S, T),
        Tolerance = T
    ;   findall(T, inner_tolerance(S, T), Ts),
        (   max_list(Ts, Most)
        ->  Tolerance = Most
        ;   Tolerance = default
        )
    ).
glue_tolerance(Given, _, Given).

tolerance_checked(S, T) :-
    (   number(T),
        T >= 0
    ->  true
    ;   throw(error(geometry_error(part_glue(wish(S, tolerance(T)))), _))
    ).

inner_tolerance(S, T) :-
    node(S, glue, Children, _),
    member(Child, Children),
    integer(Child),
    glue_tolerance(default, Child, T),
    number(T).

%!  tree_tolerance(+S, -Tolerance) is semidet.
%
%   Tolerance is the largest that glues say (glue_tolerance/3) in the tree under
%   the node S, of another operation.
%
%   @error as glue_tolerance/3

tree_tolerance(S, Tolerance) :-
    once(gluing(_, tolerance(_))),
    findall(T, glue_below(S, T), Ts),
    max_list(Ts, Tolerance).

glue_below(S, T) :-
    node(S, Operation, Children, _),
    (   Operation == glue
    ->  glue_tolerance(default, S, T),
        number(T)
    ;   member(Child, Children),
        integer(Child),
        glue_below(Child, T)
    ).

%!  tolerance_kept(+S, +Tolerance) is det.
%
%   The glue S says that this is its Tolerance, a number.

tolerance_kept(S, Tolerance) :-
    (   gluing(S, tolerance(Tolerance))
    ->  true
    ;   retractall_facts(gluing(S, tolerance(_))),
        assert_fact(gluing(S, tolerance(Tolerance)))
    ).

%!  is_node(+S) is semidet.

is_node(S) :-
    segment(S, _, Term),
    is_node_term(Term),
    !.

%!  is_helper(+S) is semidet.
%
%   True when segment S was made by evaluation alone.

is_helper(S) :-
    origin(S, node(S), helper(_)),
    !.

%!  operand_segment(?S, ?N) is nondet.
%
%   True when segment S is an operand of node N; once for each place.

operand_segment(S, N) :-
    node(N, _, Children, _),
    member(S, Children),
    integer(S).

%!  root_segment(?S) is nondet.
%
%   True when segment S is an operand of no node, and no pattern. Ascending.

root_segment(S) :-
    root_segments_after(0, Roots),
    (   integer(S)
    ->  ord_memberchk(S, Roots)
    ;   member(S, Roots)
    ).

%!  root_segments_after(+Last, -Roots) is det.
%
%   Roots are the segments above Last that are an operand of no node above Last,
%   and no patterns; ascending.

root_segments_after(Last, Roots) :-
    findall(Operand,
            ( segment(N, _, Term),
              N > Last,
              is_node_term(Term),
              \+ is_helper(N),
              node_parts(Term, _, Children, _),
              member(Operand, Children),
              integer(Operand)
            ),
            Operands0),
    sort(Operands0, Operands),
    findall(Root,
            ( segment(Root, Kind, _),
              Root > Last,
              Kind \== pattern
            ),
            All0),
    sort(All0, All),
    ord_subtract(All, Operands, Others),
    exclude(is_helper, Others, Roots).


                /*******************************
                *          COMPLETING          *
                *******************************/

%!  complete_tree(+Nodes) is det.
%!  complete_tree(+Nodes, -Incomplete:list) is det.
%
%   Give every operand under Nodes, a list of segments, that has no number yet
%   a segment of its own, after those that are there, left to right. Nodes get
%   the kind that their operands give them: `solid`, or `surface` if there is
%   one among them. Leaves whose primitive was replaced get its rows. Incomplete
%   are the leaves that have no triangles yet, new ones and others.
%
%   @error error(model_error(What), nodes(Ns)): a fault of the first node of the
%   list Ns, which is an operand of the second, and so on; What as in
%   csg_term.pl, or primitive(What, Term). The world is then as before.

complete_tree(Nodes) :-
    complete_tree(Nodes, _).

complete_tree(Nodes, Incomplete) :-
    facts_transaction(sg_csg:completed_tree(Nodes, Incomplete)).

completed_tree(Nodes, Incomplete) :-
    empty_assoc(Kinds),
    foldl(visit([]), Nodes, seen(Kinds, []), seen(_, Incomplete)).

%!  complete_leaf(+N, +S, -Kind, -Incomplete:list) is semidet.
%
%   As complete_tree/2, of segment S alone, an operand of node N. Kind is its
%   kind. Fails if S is no leaf.

complete_leaf(N, S, Kind, Incomplete) :-
    segment(S, Kind0, Term),
    \+ is_node_term(Term),
    !,
    leaf_completed([N], S, Kind0, Term, Kind, [], Incomplete).

%   visit(Above, N, Seen0, Seen): Seen is seen(Kinds, Incomplete): Kinds has
%   N-(Kind-Count) of all that were visited, Count the number of leaves. Above
%   are the nodes above N, the nearest first.

visit(_, N, Seen0, Seen) :-
    arg(1, Seen0, Kinds),
    get_assoc(N, Kinds, _),
    !,
    Seen = Seen0.
visit(Above, N, _, _) :-
    memberchk(N, Above),
    append(Between, [N|_], Above),
    !,
    reverse([N|Between], Down),
    node_error(Above, csg(cycle([N|Down]))).
visit(Above, N, Seen0, seen(Kinds, Incomplete)) :-
    segment(N, Kind0, Term0),
    !,
    (   is_node_term(Term0)
    ->  visit_node([N|Above], Kind0, Term0, Seen0, seen(Kinds1, Incomplete),
                   Known)
    ;   Seen0 = seen(Kinds1, Incomplete0),
        leaf_completed(Above, N, Kind0, Term0, Kind, Incomplete0, Incomplete),
        Known = Kind-1
    ),
    put_assoc(N, Kinds1, Known, Kinds).
visit([Parent|Above], N, _, _) :-
    node_error([Parent|Above], csg(missing(Parent, N))).

visit_node(Nodes, Kind0, Term0, Seen0, Seen, Kind-Count) :-
    Nodes = [N|_],
    few_operands(Nodes, Term0),
    catch(numbered(N, Kind0, Term0, Term), error(model_error(What), _),
          node_error(Nodes, What)),
    node_parts(Term, Operation, Children, _),
    kept_leaves(Children, Kept),
    foldl(visit_unless_kept(Nodes), Children, Kept, Seen0, Seen),
    arg(1, Seen, Known),
    maplist(child_kind(Known), Children, Kept, Kinds),
    foldl(joined_kind(Nodes, Operation), Children, Kinds, solid-0, Kind-Count),
    right_side(Nodes, Operation, Kinds),
    (   Operation == glue,
        \+ node_parts(Term, _, _, [])
    ->  node_error(Nodes, csg(placed(N)))
    ;   true
    ),
    few_leaves(Nodes, Count),
    (   Kind == Kind0
    ->  true
    ;   replaced_segment(N, Kind, Term)
    ).

%   Leaves that are as they were made, mostly all but one, need no visit.

visit_unless_kept(Nodes, Child, Kept, Seen0, Seen) :-
    (   Kept == other
    ->  visit(Nodes, Child, Seen0, Seen)
    ;   Seen = Seen0
    ).

child_kind(Known, Child, Kept, Kind) :-
    (   Kept == other
    ->  get_assoc(Child, Known, Kind)
    ;   Kind = Kept-1
    ).

%   right_side(Nodes, Operation, Kinds): a solid has an inside, a surface has
%   not.

right_side(Nodes, split(Side), [_,Kind-_]) :-
    !,
    sides_of(Kind, Sides),
    (   memberchk(Side, Sides)
    ->  true
    ;   node_error(Nodes, csg(side(Side, Sides)))
    ).
right_side(_, _, _).

sides_of(solid, [inside,outside]).
sides_of(surface, [below,above]).

few_leaves(Nodes, Count) :-
    limit_value(nodes, Most),
    (   Count =< Most
    ->  true
    ;   Nodes = [N|_],
        node_error(Nodes, csg(too_many(N, Count)))
    ).

%   few_operands(Nodes, Term): the same of what stands in Term, before any of it
%   is made. Helpers are parts of what was looked at already.

few_operands([N|_], _) :-
    is_helper(N),
    !.
few_operands(Nodes, Term) :-
    written_leaves(Term, Count),
    few_leaves(Nodes, Count).

%!  written_leaves(+Term, -Count:integer) is det.
%
%   Count leaves stand in Term, numbers of segments among them.

written_leaves(Term, Count) :-
    term_leaves(Term, 0, Count).

term_leaves(Term, Count0, Count) :-
    (   is_node_term(Term)
    ->  node_parts(Term, _, Operands, _),
        operands_leaves(Operands, Count0, Count)
    ;   Count is Count0+1
    ).

operands_leaves(Operands, Count0, Count) :-
    (   id_list(Operands, 1)
    ->  length(Operands, N),
        Count is Count0+N
    ;   is_list(Operands)
    ->  foldl(term_leaves, Operands, Count0, Count)
    ;   Count = Count0                  % a fault of its own
    ).

%   leaf_completed(Above, N, Kind0, Term, Kind, Incomplete0, Incomplete): a leaf
%   under a node whose term has become another primitive gets the rows of that,
%   and so does one that has no rows. If somebody changed the rows, they count.

leaf_completed([_|_], N, Kind, Term, Kind, Incomplete, Incomplete) :-
    made_and_kept(N, leaf(primitive(Term))),    % also seen by kept_leaves/2
    !.
leaf_completed([_|_], N, Kind0, Term, Kind, Incomplete0, Incomplete) :-
    is_primitive(Term),
    !,
    From = primitive(Term),
    (   rows_left_out
    ->  Kind = Kind0,
        Incomplete = Incomplete0
    ;   rows_wanted(N, From)
    ->  drop_boundary(N),
        primitive_rows(Term, N, Kind),
        replaced_segment(N, Kind, Term),
        Incomplete = [N|Incomplete0]
    ;   Kind = Kind0,
        lacking(N, Incomplete0, Incomplete)
    ),
    (   rows_left_out
    ->  true
    ;   record(N, leaf(From))
    ).
leaf_completed(_, N, Kind, _, Kind, Incomplete0, Incomplete) :-
    lacking(N, Incomplete0, Incomplete).

%   rows_wanted(N, From): leaf N has no rows, or those of another primitive.

rows_wanted(N, From) :-
    recorded(N, leaf(From0)),
    From0 \== From,
    up_to_date(N, From0),
    !.
rows_wanted(N, _) :-
    \+ v(N, 1, _, _, _),
    \+ v(N, _, _, _, _).

%   lacking(N, Incomplete0, Incomplete): with N if it has polygons and no
%   triangles. Number 1, mostly there, needs no search.

lacking(N, Incomplete0, Incomplete) :-
    (   \+ t(N, _, 1, _, _, _),
        \+ t(N, _, _, _, _, _),
        once(( p(N, 1, _) ; p(N, _, _) ))
    ->  Incomplete = [N|Incomplete0]
    ;   Incomplete = Incomplete0
    ).

node_error(Nodes, What0) :-
    fault_named(What0, What),
    throw(error(model_error(What), nodes(Nodes))).

%   numbered(N, Kind, Term0, Term): the term of node N, its operands numbers.

numbered(N, Kind, Term0, Term) :-
    check_node_term(Term0),
    map_operands(operand_number, Term0, Term),
    (   Term == Term0
    ->  true
    ;   replaced_segment(N, Kind, Term),
        node_parts(Term0, _, Operands0, _),
        node_parts(Term, _, Operands, _),
        note_new_operands(Operands0, Operands, N, 1)
    ).

note_new_operands([], [], _, _).
note_new_operands([Operand0|Operands0], [Operand|Operands], N, I) :-
    (   Operand == Operand0
    ->  true
    ;   note_unnumbered(Operand, N, I)
    ),
    I1 is I+1,
    note_new_operands(Operands0, Operands, N, I1).

replaced_segment(N, Kind, Term) :-
    retractall_facts(segment(N, _, _)),
    assert_fact(segment(N, Kind, Term)).

operand_number(Operand, Operand) :-
    integer(Operand),
    !.
operand_number(Operand, S) :-
    is_node_term(Operand),
    !,
    fresh_id(segment, 0, S),
    assert_fact(segment(S, solid, Operand)),
    numbered(S, solid, Operand, _).
operand_number(Operand, S) :-
    add_primitive(Operand, S).

%   joined_kind(Nodes, Operation, Child, ChildKind-ChildCount, Kind0-Count0,
%   Kind-Count): of the first of Nodes, with one more child (CB-2).

joined_kind(Nodes, Operation, Child, ChildKind-ChildCount, Kind0-Count0,
            Kind-Count) :-
    Count is Count0+ChildCount,
    Nodes = [N|_],
    (   Operation == glue
    ->  glued_child(Nodes, Child, ChildKind),
        Kind = cells
    ;   ChildKind == solid
    ->  Kind = Kind0
    ;   ChildKind == cells
    ->  cells_child(Nodes, Operation, Child),
        Kind = Kind0
    ;   ChildKind == surface
    ->  (   memberchk(Operation, [union, join, same])
        ->  Kind = surface
        ;   Operation = split(Side),
            memberchk(Side, [below, above]),
            Count0 > 0,                 % what it is split by
            node(Child, Inner, _, _),
            memberchk(Inner, [leaf, same])
        ->  Kind = Kind0
        ;   functor(Operation, Name, _),
            node_error(Nodes, csg(surface(N, Child, Name)))
        )
    ;   node_error(Nodes, csg(curve(N, Child)))
    ).

%   glued_child(Nodes, Child, Kind): solids, surfaces and curves are glued, and
%   what was glued already.

glued_child([N|Nodes], Child, Kind) :-
    (   memberchk(Kind, [solid,surface,curve])
    ->  true
    ;   node(Child, glue, _, [])
    ->  true
    ;   node_error([N|Nodes], csg(cells(N, Child, glue)))
    ).

%   cells_child(Nodes, Operation, Child): under a Boolean a glue counts as the
%   union of its solids.

cells_child([N|Nodes], Operation, Child) :-
    (   node(Child, glue, _, _),
        \+ memberchk(Operation, [join,same])
    ->  true
    ;   functor(Operation, Name, _),
        node_error([N|Nodes], csg(cells(N, Child, Name)))
    ).
