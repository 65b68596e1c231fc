:- module(sg_csg_flat,
          [ flat_expression/2,          % +S, -Expression
            flat_leaves/2,              % +Expression, -Leaves
            helpers/1,                  % -Helpers
            is_half/1,                  % +S
            half_surface/2              % +S, -Surface
          ]).
:- use_module('../csg/csg', [node/4, is_helper/1]).
:- use_module(csg_behind, [behind_surface/4]).
:- use_module(csg_half_space, [half_space/3]).
:- use_module('../csg/csg_matrix',
              [ identity_matrix/1, steps_matrix/2, matrix_product/3,
                matrix_plane/3, rounded_matrix/2
              ]).
:- use_module('../csg/csg_record', [record/2, recorded/2, up_to_date/2]).
:- use_module('../csg/csg_rows',
              [copy_segments/3, drop_boundary/1, segment_box/2]).
:- use_module('../csg/csg_term', [csg_error/1, is_node_term/1, node_parts/4]).
:- use_module('../kernel', [kept_leaves/2, other_segments/1]).
:- use_module('../penetration/penetration', [penetration_chains/3]).
:- use_module('../primitive/primitive_rows', [add_primitive/2]).
:- use_module('../store',
              [ v/5, t/6, segment/3, from_p/5, segment_stamp/2, assert_fact/1,
                facts_snapshot/1, fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(apply),
              [ exclude/3, foldl/4, foldl/6, include/3, maplist/3, partition/4
              ]).
:- use_module(library(assoc),
              [ empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4 ]).
:- use_module(library(lists),
              [append/3, list_to_set/2, member/2, nth1/3, reverse/2]).
/** <module> A CSG tree flattened to an expression over leaves.

Placements are multiplied down. A leaf in its own place stands for itself;
placed elsewhere it is an *instance*, a segment of its own, made once for equal
placements: a `same` node of the user, or a helper. A half-space is a helper
too.

An expression is the number of a segment, union(List), intersection(List) or
difference(List). union([]) is nothing, and then the whole expression.
*/

%!  flat_expression(+S, -Expression) is det.
%
%   Expression is what segment S is. Makes the instances that it needs, or makes
%   them anew.

flat_expression(S, Expression) :-
    known_instances(Known),
    identity_matrix(Identity),
    placement(Identity, Place),
    flat(Place, S, Expression, Known, _).

%   placement(Matrix, Place): Place is place(Matrix, Rounded), Rounded being
%   `same` if it moves nothing.

placement(Matrix, place(Matrix, Rounded)) :-
    identity_matrix(Identity),
    maplist(rounded_matrix, [Matrix, Identity], [Rounded0, RoundedIdentity]),
    (   Rounded0 == RoundedIdentity
    ->  Rounded = same
    ;   Rounded = Rounded0
    ).

%   flat(Place, S, Expression, Known0, Known): Known are known_instances/1.

flat(Place0, S, Expression, Known0, Known) :-
    segment(S, _, Term),
    is_node_term(Term),
    !,
    node_parts(Term, Operation, Children, Steps),
    moved_on(Steps, Place0, Place),
    kept_leaves(Children, Kept),
    foldl(flat_child(Place), Children, Kept, Expressions, Known0, Known1),
    arg(1, Place, Matrix),
    combined(Operation, Expressions, Matrix, Expression, Known1, Known).
flat(place(_, Rounded), S, K, Known0, Known) :-
    instance(Rounded, S, K, Known0, Known).

%   Most are leaves that are known, in their own places.

flat_child(Place, S, Kept, Expression, Known0, Known) :-
    (   Kept \== other,
        Place = place(_, same)
    ->  Expression = S,
        Known = Known0
    ;   flat(Place, S, Expression, Known0, Known)
    ).

moved_on([], Place, Place) :-
    !.
moved_on(Steps, place(Matrix0, _), Place) :-
    steps_matrix(Steps, Placement),
    matrix_product(Matrix0, Placement, Matrix),
    placement(Matrix, Place).

%   combined(Operation, Expressions, Matrix, Expression, Known0, Known)

combined(same, [Expression], _, Expression, Known, Known).
combined(union, Es, _, Expression, Known, Known) :-
    united(Es, Expression).
combined(join, Es, _, Expression, Known, Known) :-
    united(Es, Expression).
combined(glue, Es0, _, Expression, Known, Known) :-
    exclude(is_no_solid, Es0, Es),
    united(Es, Expression).
combined(intersection, Es, _, Expression, Known, Known) :-
    common(Es, Expression).
combined(difference, [E|Es], _, Expression, Known, Known) :-
    less(E, Es, Expression).
combined(split(inside), [E1,E2], _, Expression, Known, Known) :-
    common([E1,E2], Expression).
combined(split(outside), [E1,E2], _, Expression, Known, Known) :-
    less(E1, [E2], Expression).
combined(split(Plane0, Side), [E], Matrix, Expression, Known0, Known) :-
    matrix_plane(Matrix, Plane0, Plane),
    flat_leaves(E, Leaves),
    leaves_half(Leaves, Plane, Half),
    half_expression(Half, HalfExpression, Known0, Known),
    half_of(Side, HalfExpression, E, Expression).
combined(split(Side), [E,Surface], _, Expression, Known0, Known) :-
    memberchk(Side, [below,above]),
    flat_leaves(E, Leaves),
    surface_half(Leaves, Surface, Half),
    half_expression(Half, HalfExpression, Known0, Known),
    (   HalfExpression = half(K)
    ->  front_noted(K, Surface)
    ;   true
    ),
    half_of(Side, HalfExpression, E, Expression).

is_no_solid(S) :-
    integer(S),
    segment(S, Kind, _),
    memberchk(Kind, [surface,curve]),
    !.

united(Es0, Expression) :-
    foldl(terms_of(union), Es0, [], Reversed),
    reversed_unique(Reversed, Es),
    Expression = union(Es).

common(Es0, Expression) :-
    (   memberchk(union([]), Es0)
    ->  Expression = union([])
    ;   foldl(terms_of(intersection), Es0, [], Reversed),
        reversed_unique(Reversed, Es),
        (   Es = [E]
        ->  Expression = E
        ;   Expression = intersection(Es)
        )
    ).

less(union([]), _, union([])) :-
    !.
less(E, Es0, Expression) :-
    foldl(terms_of(union), Es0, [], Reversed),
    reversed_unique(Reversed, Es),
    (   Es == []
    ->  Expression = E
    ;   E = difference([E1|Es1])
    ->  append(Es1, Es, Es2),
        Expression = difference([E1|Es2])
    ;   Expression = difference([E|Es])
    ).

%   terms_of(Operation, E, Reversed0, Reversed): unions in a union are one.

terms_of(Operation, E, Reversed0, Reversed) :-
    (   E =.. [Operation, Es]
    ->  foldl(terms_of(Operation), Es, Reversed0, Reversed)
    ;   E == union([])
    ->  Reversed = Reversed0
    ;   Reversed = [E|Reversed0]
    ).

%   reversed_unique(Reversed, Es): in order, each once.

reversed_unique(Reversed, Es) :-
    reverse(Reversed, Es0),
    list_to_set(Es0, Es).

half_of(below, Half, E, Expression) :-
    below(Half, E, Expression).
half_of(above, Half, E, Expression) :-
    above(Half, E, Expression).

below(all, E, E).
below(none, _, union([])).
below(half(K), E, Expression) :-
    common([E,K], Expression).

above(all, _, union([])).
above(none, E, E).
above(half(K), E, Expression) :-
    less(E, [K], Expression).

%!  flat_leaves(+Expression, -Leaves) is det.
%
%   Leaves are the segments in Expression, ascending.

flat_leaves(Expression, Leaves) :-
    leaves(Expression, Leaves0, []),
    sort(Leaves0, Leaves).

leaves(S, [S|Leaves], Leaves) :-
    integer(S),
    !.
leaves(Expression, Leaves0, Leaves) :-
    arg(1, Expression, Es),
    foldl(leaves, Es, Leaves0, Leaves).


                /*******************************
                *           INSTANCES          *
                *******************************/

%   known_instances(Known): an association of Leaf-Rounded with the `same` node
%   or the helper that is Leaf placed by it, and of the terms of half-spaces
%   with the helpers that they are.

known_instances(Known) :-
    may_be_instances(Ss),
    partition(is_helper, Ss, Helpers, Nodes),
    same_keys(Nodes, Pairs, Pairs1),
    findall(Key-K, ( member(K, Helpers), helper_key(K, Key) ), Pairs1),
    sort(1, @<, Pairs, Unique),         % of equal ones the first
    list_to_assoc(Unique, Known).

%!  helpers(-Helpers:list) is det.
%
%   Helpers are the segments that evaluation made (csg.pl).

helpers(Helpers) :-
    may_be_instances(Ss),
    include(is_helper, Ss, Helpers).

%   may_be_instances(Ss): the segments that have terms of instances: nothing but
%   a segment placed, or a polyhedron. In the order of their rows. Most are
%   primitives, whose terms are not looked at.

may_be_instances(Ss) :-
    other_segments(Others),
    include(has_instance_term, Others, Ss).

has_instance_term(S) :-
    segment(S, _, Term),
    instance_term(Term),
    !.

instance_term(polyhedron(_, _)).
instance_term(at(_, Inner)) :-
    instance_term_(Inner).
instance_term(named(_, Inner)) :-
    instance_term_(Inner).

instance_term_(Inner) :-
    (   integer(Inner)
    ->  true
    ;   Inner \= polyhedron(_, _),
        instance_term(Inner)
    ).

%   same_keys(Nodes, Pairs, Pairs1): Pairs has Leaf-Rounded-N for each of Nodes
%   that is a leaf placed, then Pairs1. Each node under them is asked once.

same_keys(Nodes, Pairs, Pairs1) :-
    empty_assoc(Seen0),
    foldl(same_key, Nodes, Pairs-Seen0, Pairs1-_).

same_key(N, Pairs-Seen0, Pairs1-Seen) :-
    (   node(N, same, _, _)
    ->  same_leaf(N, Same, Seen0, Seen),
        (   Same = Leaf-Matrix
        ->  rounded_matrix(Matrix, Rounded),
            Pairs = [Leaf-Rounded-N|Pairs1]
        ;   Pairs = Pairs1
        )
    ;   Pairs = Pairs1,
        Seen = Seen0
    ).

helper_key(K, Key) :-
    recorded(K, helper(From)),
    (   From = placed(Leaf-_, Rounded)
    ->  Key = Leaf-Rounded
    ;   From = half(Key)
    ).

%   same_leaf(S, Same, Seen0, Seen): Same is Leaf-Matrix, what S is, or `none`.
%   Seen has it of all that were asked for.

same_leaf(S, Same, Seen, Seen) :-
    get_assoc(S, Seen, Known),
    !,
    Same = Known.
same_leaf(S, Same, Seen0, Seen) :-
    (   node(S, Operation, Children, Steps)
    ->  same_leaf(Operation, S, Children, Steps, Same, Seen0, Seen1)
    ;   Same = none,
        Seen1 = Seen0
    ),
    put_assoc(S, Seen1, Same, Seen).

same_leaf(leaf, S, _, _, Same, Seen0, Seen) =>
    identity_matrix(Identity),
    Same = S-Identity,
    Seen = Seen0.
same_leaf(same, _, [Child], Steps, Same, Seen0, Seen) =>
    same_leaf(Child, Same0, Seen0, Seen),
    (   Same0 = Leaf-Matrix0
    ->  steps_matrix(Steps, Placement),
        matrix_product(Placement, Matrix0, Matrix),
        Same = Leaf-Matrix
    ;   Same = none
    ).
same_leaf(_, _, _, _, Same, Seen0, Seen) =>
    Same = none,
    Seen = Seen0.

%   instance(Rounded, Leaf, K, Known0, Known): K is Leaf placed by Rounded, with
%   rows that are right.

instance(same, Leaf, K, Known, Known) :-
    !,
    K = Leaf.
instance(Rounded, Leaf, K, Known, Known) :-
    get_assoc(Leaf-Rounded, Known, K0),
    !,
    K = K0,
    placed_from(Leaf, Rounded, From),
    (   up_to_date(K, From)
    ->  true
    ;   is_helper(K)
    ->  instance_rows(Leaf, Rounded, K, helper(From))
    ;   instance_rows(Leaf, Rounded, K, evaluated(From))
    ).
instance(Rounded, Leaf, K, Known0, Known) :-
    placed_from(Leaf, Rounded, From),
    segment(Leaf, Kind, _),
    fresh_id(segment, 0, K),
    assert_fact(segment(K, Kind, at([matrix(Rounded)], Leaf))),
    instance_rows(Leaf, Rounded, K, helper(From)),
    put_assoc(Leaf-Rounded, Known0, K, Known).

placed_from(Leaf, Rounded, placed(Leaf-Stamp, Rounded)) :-
    segment_stamp(Leaf, Stamp).

instance_rows(Leaf, Rounded, K, Record) :-
    drop_boundary(K),
    copy_segments([Leaf], Rounded, K),
    record(K, Record).


                /*******************************
                *          HALF-SPACES         *
                *******************************/

%   leaves_half(Leaves, Plane, Half): for half_expression/4.

leaves_half(Leaves, Plane, Half) :-
    (   leaves_box(Leaves, Box)
    ->  half_space(Plane, Box, Half)
    ;   Half = all
    ).

leaves_box(Leaves, Box) :-
    findall(Box0, ( member(Leaf, Leaves), segment_box(Leaf, Box0) ), Boxes),
    Boxes \== [],
    foldl(box_union, Boxes, none, Box).

%   surface_half(Leaves, Surface, Half): the same for what is behind the segment
%   Surface, which has to go all the way through.

surface_half(Leaves, Surface, Half) :-
    (   leaves_box(Leaves, Box)
    ->  behind_surface(Surface, Box, Half, Skirt),
        (   facts_snapshot(sg_csg_flat:meets(Skirt, Leaves))
        ->  csg_error(not_through(Surface))
        ;   true
        )
    ;   Half = all
    ).

meets(Skirt, Leaves) :-
    add_primitive(Skirt, S),
    complete_segments([S]),
    findall(Leaf-S, member(Leaf, Leaves), Pairs),
    penetration_chains(Pairs, [tolerance(0)], [_|_]).

%   front_noted(K, Surface): the helper K, made by behind_surface/4, has
%   Surface as its front; for provenance.pl.

front_noted(K, Surface) :-
    (   from_p(K, _, _, _, _)
    ->  true
    ;   findall(T-P, t(Surface, P, T, _, _, _), Triangles0),
        keysort(Triangles0, Triangles),
        forall(nth1(I, Triangles, _-P),
               assert_fact(from_p(K, I, Surface, P, 1))),
        findall(V, v(Surface, V, _, _, _), Vs0),
        sort(Vs0, Vs),
        forall(nth1(I, Vs, V), assert_fact(from_v(K, I, Surface, V)))
    ).

%!  is_half(+S) is semidet.
%
%   True when segment S is the helper for a half-space, or for what is behind a
%   surface.

is_half(S) :-
    segment(S, _, polyhedron(_, _)),
    is_helper(S),
    !.

%!  half_surface(+S, -Surface) is semidet.
%
%   S is the helper for what is behind Surface.

half_surface(S, Surface) :-
    from_p(S, 1, Surface, _, _),
    !.

box_union(Box, none, Box) :-
    !.
box_union(box(A1,B1,C1,D1,E1,F1), box(A2,B2,C2,D2,E2,F2),
          box(A,B,C,D,E,F)) :-
    A is min(A1, A2),
    B is min(B1, B2),
    C is min(C1, C2),
    D is max(D1, D2),
    E is max(E1, E2),
    F is max(F1, F2).

%   half_expression(Half, What, Known0, Known): What is `all`, `none` or
%   half(K), K the helper that is the primitive Half.

half_expression(Half, What, Known, Known) :-
    atom(Half),
    !,
    What = Half.
half_expression(Half, half(K), Known0, Known) :-
    (   get_assoc(Half, Known0, K)
    ->  Known = Known0
    ;   add_primitive(Half, K),
        complete_segments([K]),
        record(K, helper(half(Half))),
        put_assoc(Half, Known0, K, Known)
    ).
