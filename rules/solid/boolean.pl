:- module(sg_boolean,
          [ boolean/2,                  % +Expression, +S
            boolean/3,                  % +Expression, +S, +Options
            stays/3,                    % +Expression, +Component, -Sense
            senses_by_rule/3,           % +Arrangement, +Expression, -Senses
            expression_leaves/2,        % +Expression, -Leaves
            select_boundary/3,          % +Arrangement, +Expression, -Solid
            boolean_tolerance/3         % +Leaves, +Options0, -Options
          ]).
:- use_module(arrangement,
              [ with_arrangement/3, components/2, arranged_solid/3,
                default_senses/4, contact_vertices/2, pieces_numbers/2,
                pieces_changed/3, pieces_dropped/0, leaves_around/3,
                part_of_arrangement/3
              ]).
:- use_module('../csg/csg_record', [not_kept/2, segments_of_kind/3]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module(faces, [faces_merged/2, region_faces_merged/3]).
:- use_module('../kernel',
              [ contact_origins/2, leaf_copies/3, solid_close/1,
                solid_is_closed/1, solid_region/3, solid_write/2,
                solid_write_over/2, solid_write_region/3,
                region_leaves/2, region_close/1, segments_tolerance/3
              ]).
:- use_module(operand, [checked_operand/1]).
:- use_module('../polygon/triangulation', [new_segments_complete/0]).
:- use_module('../penetration/penetration', [touching/3]).
:- use_module('../penetration/resolve',
              [held_said/1, holding_said/2, tolerance_reach/2]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../csg/source', [source_kept/3]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [v/5, segment/3, assert_fact/1, facts_transaction/1]).
:- use_module(library(apply), [convlist/3, maplist/2, maplist/3]).
:- use_module(library(error),
              [ domain_error/2, existence_error/2, instantiation_error/1,
                type_error/2
              ]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [list_to_set/2, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> Union, intersection, difference: what stays of the pieces.

An expression is the number of a segment, or union(Es), intersection(Es) or
difference(Es) of a list of expressions (the first without all the others). A
piece stays if just one of its two sides is inside: so the rule is the same for
any number of operands, for hollows and for shells in each other, and a face
that two operands have in common stays or goes by how it looks in each.

@see [CB] rows CB-1 to CB-4
*/

%!  boolean(+Expression, +S) is det.
%!  boolean(+Expression, +S, +Options:list) is det.
%
%   The boundary of Expression becomes the rows of segment S; a solid of that
%   number is made if there is none. One transaction; the operands stay as they
%   are. Options: those of with_arrangement/3 and of
%   faces_merged/2, and
%
%     - faces(pieces)
%     Coplanar neighbours are left as they are (CB-5).
%
%     - tolerance(Tolerance)
%     Default: as segments_tolerance/3 sees the operands.
%     - over(Bool)
%     Rows that S has are those of an earlier boundary: what of them is the same
%     stays, with its ids. Default: `false`, S must have none.
%     - earlier(Pieces)
%     With over(true): that boundary was of this Expression too, with these
%     options, made from these Pieces.
%     - pieces(-Pieces)
%     Pieces are those of this one, of(Copies, Numbers): of all leaves but
%     Copies (leaf_copies/3) the pieces_numbers/2. `unknown` if more than pieces
%     decided what it is: a rule file, or what was tried because the result were
%     open else.
%     - made(-How)
%     How is `around`: only around what had changed since the earlier one; or
%     `whole`.
%
%   @error existence_error(segment, S1): an operand is not there
%   @error geometry_error(operand(S1, Faults)): the result would be open, and so
%          is operand S1
%   @error geometry_error(tolerance(T, Most)): T is more than a sixteenth of the
%          smallest operand
%   @error geometry_error(result_open): no way was found to a closed result
%   @error geometry_error(polygon_edge(S1, P, V1, V2)): with its lines, polygon
%          P cannot be triangulated

boolean(Expression, S) :-
    boolean(Expression, S, []).

boolean(Expression0, S, Options0) :-
    new_segments_complete,
    expression_leaves(Expression0, Leaves0),
    copies_replaced(Expression0, Leaves0, Expression, Leaves, Copies),
    boolean_tolerance(Leaves, Options0, Options),
    (   made_around_changes(Expression, Leaves, Copies, S, Options, Numbers)
    ->  How = around
    ;   How = whole,
        made(Expression, Leaves, Options, Solid, Contacts, Numbers),
        setup_call_cleanup(
            true,
            facts_transaction(sg_boolean:written(Solid, S, Expression0,
                                                 Contacts, Options)),
            solid_close(Solid))
    ),
    source_kept(Leaves, 1, S),
    (   Numbers == unknown
    ->  Pieces = unknown
    ;   Pieces = of(Copies, Numbers)
    ),
    option(pieces(Pieces), Options0, _),
    option(made(How), Options0, _).

%   copies_replaced(+Expression0, +Leaves0, -Expression, -Leaves, -Copies):
%   a leaf that is another one once more has the same inside, and nothing of it
%   stays but what is there already. Of many such the first stands for all but a
%   few, which stay so that what they touch is named as ever. A decision of the
%   user's is asked of each.

copies_replaced(Expression0, Leaves0, Expression, Leaves, Copies) :-
    decision_is_default(stays/3),
    leaf_copies(Leaves0, 8, Copies),
    Copies = [_|_],
    !,
    list_to_assoc(Copies, FirstOf),
    replaced(FirstOf, Expression0, Expression),
    pairs_keys(Copies, Gone),
    ord_subtract(Leaves0, Gone, Leaves).
copies_replaced(Expression, Leaves, Expression, Leaves, []).

replaced(FirstOf, S, First) :-
    integer(S),
    !,
    (   get_assoc(S, FirstOf, First0)
    ->  First = First0
    ;   First = S
    ).
replaced(FirstOf, difference([E0|Es0]), difference([E|Es])) :-
    !,
    replaced(FirstOf, E0, E),
    all_replaced(FirstOf, Es0, Es).
replaced(FirstOf, Expression0, Expression) :-
    Expression0 =.. [Operation,Es0],
    all_replaced(FirstOf, Es0, Es),
    Expression =.. [Operation,Es].

%   all_replaced(FirstOf, Es0, Es): each once.

all_replaced(FirstOf, Es0, Es) :-
    maplist(replaced(FirstOf), Es0, Es1),
    list_to_set(Es1, Es).

%!  boolean_tolerance(+Leaves:list, +Options0:list, -Options:list) is det.
%
%   Options have tolerance(Tolerance): the one of Options0, or what Leaves say,
%   not what else is in the world; and of merging, what the result does, where
%   an operand is far larger.
%
%   @error geometry_error(tolerance(T, Most)), as boolean/3

boolean_tolerance(Leaves, Options0, Options) :-
    (   option(tolerance(_), Options0)
    ->  touching(Options0, Leaves, _),
        Options = Options0
    ;   segments_tolerance(Leaves, Tolerance, _),
        Options = [tolerance(own(Tolerance))|Options0]
    ).

%   made(+Expression, +Leaves, +Options, -Solid, -Contacts, -Numbers): it must
%   be closed if its operands are. If sheets of one operand nearly lie on each
%   other, touching may open the result; then nothing is made to touch. Merging
%   of faces opens nothing: of a vertex or an edge that goes, all faces have it
%   or none (face_merge.h).

made(Expression, Leaves, Options, Solid, Contacts, Numbers) :-
    attempt(Options, Attempt, What),
    holding_said(selected_solid(Expression, Leaves, Attempt, Solid0, Contacts0,
                                Numbers0),
                 Held),
    (   is_open(Leaves, Solid0)
    ->  solid_close(Solid0),
        not_said(Held),
        maplist(checked_operand, Leaves),
        fail
    ;   What == first
    ->  true
    ;   print_message(warning, sanggwan(opened))
    ),
    !,
    catch(held_said(Held), Error,
          ( solid_close(Solid0),
            not_said(Held),
            throw(Error)
          )),
    Solid = Solid0,
    Contacts = Contacts0,
    (   What == first,
        decision_is_default(stays/3),
        decision_is_default(merge_faces/2)
    ->  Numbers = Numbers0
    ;   Numbers = unknown
    ).
made(_, _, _, _, _, _) :-
    throw(error(geometry_error(result_open), _)).

%   not_said(Held): whoever needs the pieces again makes them, and says it.

not_said([]).
not_said([_|_]) :-
    pieces_dropped.

attempt(Options, Options, first).
attempt(Options, [tolerance(0)|Options], apart) :-
    option(tolerance(Tolerance), Options),
    tolerance_reach(Tolerance, Reach),
    Reach > 0.

selected_solid(Expression, Leaves, Options, Solid, Contacts, Numbers) :-
    with_arrangement(Leaves, Options,
                     sg_boolean:selected(Expression, Solid, Contacts, Numbers)),
    catch(merged(Solid, Options),
          Error,
          ( solid_close(Solid),
            throw(Error)
          )).

selected(Expression, Solid, Contacts, Numbers, Arrangement) :-
    contact_vertices(Arrangement, Contacts),
    pieces_numbers(Arrangement, Numbers),
    select_boundary(Arrangement, Expression, Solid).

%   A decision of the user's may open what it likes.

is_open(Leaves, Solid) :-
    decision_is_default(stays/3),
    \+ solid_is_closed(Solid),
    \+ ( member(S, Leaves),
         is_surface(S)
       ).

merged(Solid, Options) :-
    (   option(faces(pieces), Options)
    ->  true
    ;   stage(faces, faces_merged(Solid, Options))
    ).

written(Solid, S, Expression, Contacts, Options) :-
    (   segment(S, _, _)
    ->  true
    ;   assert_fact(segment(S, solid, Expression))
    ),
    stage(write, ( rows_written(Solid, S, Options),
                   contact_origins(S, Contacts)
                 )).

rows_written(Solid, S, Options) :-
    (   option(over(true), Options)
    ->  (   solid_write_over(Solid, S)
        ->  true
        ;   drop_boundary(S),
            solid_write(Solid, S)
        )
    ;   solid_write(Solid, S)
    ).


                /*******************************
                *    AROUND WHAT HAS CHANGED   *
                *******************************/

%   made_around_changes(+Expression, +Leaves, +Copies, +S, +Options, -Numbers)
%   is semidet: the boundary is made anew where leaves have other pieces than it
%   was made from, and near these. There faces do not depend on what is
%   farther away: they are chosen and merged together with their neighbours,
%   which stay as they are. Fails where that cannot be said, or is not worth
%   it.

made_around_changes(Expression, Leaves, Copies, S, Options, Numbers) :-
    option(earlier(of(Copies0, Earlier)), Options),
    Copies0 == Copies,
    decision_is_default(stays/3),
    decision_is_default(merge_faces/2),
    segments_of_kind(surface, Leaves, []),
    with_arrangement(Leaves, Options,
                     sg_boolean:selected_around(Expression, Leaves, S, Earlier,
                                                Region, Solid, Contacts,
                                                Numbers)),
    call_cleanup(
        ( stage(faces, region_faces_merged(Solid, Region, Options)),
          facts_transaction(sg_boolean:written_around(Solid, S, Region,
                                                      Contacts))
        ),
        ( solid_close(Solid),
          region_close(Region)
        )),
    !.

selected_around(Expression, Leaves, S, Earlier, Region, Solid, Contacts,
                Numbers, Arrangement) :-
    pieces_changed(Arrangement, Earlier, Changed),
    leaves_around(Arrangement, Changed, Around),
    are_few(Around, Leaves),
    contact_vertices(Arrangement, Contacts),
    pieces_numbers(Arrangement, Numbers),
    stage(write, solid_region(S, Around, Region)),
    (   catch(selected_region(Region, Expression, Leaves, Solid, Arrangement),
              Error,
              ( region_close(Region),
                throw(Error)
              ))
    ->  true
    ;   region_close(Region),
        fail
    ).

%   The faces of the region, and those near them.

selected_region(Region, Expression, Leaves, Solid, Arrangement) :-
    region_leaves(Region, Inner),
    leaves_around(Arrangement, Inner, Looked),
    are_few(Looked, Leaves),
    part_of_arrangement(Arrangement, Looked, Part),
    select_boundary(Part, Expression, Solid).

%   are_few(+Some, +Leaves): no more than half of them.

are_few(Some, Leaves) :-
    length(Some, N),
    length(Leaves, All),
    2*N =< All.

written_around(Solid, S, Region, Contacts) :-
    stage(write, ( solid_write_region(Solid, S, Region),
                   contact_origins(S, Contacts)
                 )).

%!  select_boundary(+Arrangement, +Expression, -Solid) is det.
%
%   Solid is a handle of the boundary of Expression, from an open arrangement
%   that has all its leaves.

select_boundary(Arrangement, Expression, Solid) :-
    stage(rules, senses(Arrangement, Expression, Senses)),
    stage(pieces, arranged_solid(Arrangement, Senses, Solid)).

senses(Arrangement, Expression, Senses) :-
    decision_is_default(stays/3),
    !,
    expression_leaves(Expression, Leaves),
    segments_of_kind(surface, Leaves, Open),
    default_senses(Arrangement, Expression, Open, Senses).
senses(Arrangement, Expression, Senses) :-
    senses_by_rule(Arrangement, Expression, Senses).

%!  senses_by_rule(+Arrangement, +Expression, -Senses:list) is det.
%
%   Senses are C-Sense of the components for which stays/3 holds.

senses_by_rule(Arrangement, Expression, Senses) :-
    components(Arrangement, Components),
    convlist(kept(Expression), Components, Senses).

kept(Expression, Component, C-Sense) :-
    Component = component(C, _, _, _, _, _),
    stays(Expression, Component, Sense).

is_surface(S) :-
    segment(S, surface, _),
    !.

:- decision(stays/3, "Which pieces of solids stay in a result (CB-4)").

%!  stays(+Expression, +Component, -Sense) is semidet.
%
%   Decision: a component of an arrangement (arrangement_components/2) stays in
%   the boundary of Expression, as it is (Sense 1) or turned over (-1). The
%   default: if just one of its sides is inside, and no other piece in its place
%   stays for it. A surface has no inside; of one, what is outside of everything
%   else stays (CB-2).

stays(Expression, component(_, S, _, _, Sides, only), Sense) :-
    inside(below, Sides, Expression, Below),
    inside(above, Sides, Expression, Above),
    (   is_surface(S)
    ->  once(leaf_of(Expression, S)),
        Below-Above == false-false,
        Sense = 1
    ;   boundary(Below, Above, Sense)
    ).

boundary(true, false, 1).
boundary(false, true, -1).

inside(Where, Sides, Expression, Inside) :-
    findall(S, goes_round(Where, Sides, S), Ss),
    (   holds(Expression, Ss)
    ->  Inside = true
    ;   Inside = false
    ).

goes_round(below, Sides, S) :-
    member(side(S, Below, _), Sides),
    Below > 0.
goes_round(above, Sides, S) :-
    member(side(S, _, Above), Sides),
    Above > 0.

%   holds(+Expression, +Ss): it is true of a point that is inside just Ss.

holds(S, Ss) :-
    integer(S),
    memberchk(S, Ss).
holds(union(Es), Ss) :-
    member(E, Es),
    holds(E, Ss),
    !.
holds(intersection(Es), Ss) :-
    \+ ( member(E, Es),
         \+ holds(E, Ss)
       ).
holds(difference([First|Others]), Ss) :-
    holds(First, Ss),
    \+ holds(union(Others), Ss).

%!  expression_leaves(+Expression, -Leaves:list) is det.
%
%   Leaves are the segments of Expression, each once, in order.
%
%   @error existence_error(segment, S)

expression_leaves(Expression, Leaves) :-
    findall(S, leaf_of(Expression, S), Leaves0),
    sort(Leaves0, Leaves),
    not_kept(Leaves, Others),
    maplist(is_there, Others).

leaf_of(Expression, _) :-
    var(Expression),
    !,
    instantiation_error(Expression).
leaf_of(Leaf, S) :-
    integer(Leaf),
    !,
    S = Leaf.
leaf_of(Expression, S) :-
    compound(Expression),
    Expression =.. [Operation, Es],
    operation(Operation),
    !,
    (   is_list(Es),
        Es = [_|_]
    ->  member(E, Es),
        leaf_of(E, S)
    ;   domain_error(operands, Es)
    ).
leaf_of(Expression, _) :-
    type_error(expression, Expression).

operation(union).
operation(intersection).
operation(difference).

is_there(S) :-
    (   segment(S, _, _)
    ->  true
    ;   v(S, _, _, _, _)
    ->  true
    ;   existence_error(segment, S)
    ).
