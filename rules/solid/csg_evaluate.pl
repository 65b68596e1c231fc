:- module(sg_csg_evaluate,
          [ evaluate/0,
            evaluate/1,                 % +S
            evaluate/2,                 % +Which, +Options
            evaluated/1,                % ?S
            csg_statistics/1,           % -Statistics
            csg_statistics_reset/0
          ]).
:- use_module(arrangement, [pieces_statistics/1]).
:- use_module(boolean, [boolean/3]).
:- use_module('../csg/csg',
              [ node/4, root_segment/1, glue_operands/2, glue_tolerance/3,
                tree_tolerance/2, tolerance_kept/2, is_node/1, complete_tree/1,
                complete_tree/2
              ]).
:- use_module(csg_flat,
              [ flat_expression/2, flat_leaves/2, helpers/1, is_half/1,
                half_surface/2
              ]).
:- use_module('../csg/csg_matrix',
              [identity_matrix/1, steps_matrix/2, rounded_matrix/2]).
:- use_module('../csg/csg_record',
              [ up_to_date/2, record/2, drop_record/1, recorded/2,
                record_pieces/2, recorded_pieces/2, not_kept/2
              ]).
:- use_module('../csg/csg_rows',
              [copy_segments/3, drop_boundary/1, drop_pictures/1, was_cut/1]).
:- use_module('../kernel',
              [segment_meets_itself/1, segments_tolerance/3]).
:- use_module(glue, [glued_boundary/3]).
:- use_module(glue_grown, [glue_grown/2]).
:- use_module(operand, [checked_operand/1, operand_faults/2]).
:- use_module('../csg/operand_name', [fault_named/2]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ segment/3, gluing/2, segment_stamps/2, retractall_facts/1,
                facts_transaction/1, facts_snapshot/1
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(apply), [exclude/3, include/3, maplist/2]).
:- use_module(library(error), [existence_error/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/3]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> Evaluating the CSG tree: the boundaries of nodes.

A node is flattened (csg_flat.pl): placements are multiplied down to the leaves,
what is left is a Boolean expression over segments. boolean/2 makes its boundary
from the leaves, at once and exactly: nothing is rounded between nodes. The
boundary is the node's own rows.

With it is remembered what it was made from: the expression, and the stamps of
the leaves in it (csg_record.pl). While these are the same nothing is done
again. So editing a leaf, or a placement, makes those nodes stale that it is
under, and no others; and undo, which brings back rows and stamps, needs no
evaluation.

A `join` puts the boundaries of its operands side by side. Under another
operation it is their union: the same solid. A `glue` keeps all of them, what
coincides once (glue.pl); under another operation it is the union of its solids.

@see row CB-1; docs/internals/boolean.md
*/

%!  evaluate is det.
%!  evaluate(+S) is det.
%!  evaluate(+Which, +Options:list) is det.
%
%   The boundary of every root, or of the node S, is made anew if it is stale.
%   Which is a segment or `all`. One transaction. A leaf is its own boundary.
%   Option:
%
%     - tolerance(Tolerance)
%       What is nearer than this (model units) is made to touch first. Default:
%       as segments_tolerance/3 sees the leaves of a node; as a glue says itself
%       (glue_tolerance/3); or as a glue in the tree says, if that is more. A
%       glue that is evaluated so keeps it, as gluing(S, tolerance(Tolerance)).
%       Other nodes keep it until something of them changes.
%
%   @error existence_error(segment, S); model_error(What) of csg_term.pl;
%   geometry_error(What) where the geometry cannot be done

evaluate :-
    evaluate(all, []).

evaluate(S) :-
    evaluate(S, []).

evaluate(all, _) :-
    \+ ( segment(S, _, _), is_node(S) ),
    !.
evaluate(Which, Options) :-
    (   Which == all
    ->  findall(S, root_segment(S), Ss)
    ;   segment(Which, _, _)
    ->  Ss = [Which]
    ;   existence_error(segment, Which)
    ),
    option(tolerance(Tolerance), Options, default),
    catch(facts_transaction(sg_csg_evaluate:all_evaluated(Ss, Tolerance)),
          error(model_error(What), nodes(_)),
          throw(error(model_error(What), _))).

all_evaluated(Ss0, Tolerance) :-
    forall(( Tolerance \== default, member(S, Ss0), node(S, glue, _, _) ),
           tolerance_kept(S, Tolerance)),
    exclude(only_grown(Tolerance), Ss0, Ss),
    (   Ss == [],
        Ss0 \== []
    ->  true
    ;   all_made(Ss, Tolerance)
    ).

only_grown(Tolerance0, S) :-
    glue_tolerance(Tolerance0, S, Tolerance),
    glue_grown(S, Tolerance),
    counted(around).

all_made(Ss, Tolerance) :-
    complete_tree(Ss, Incomplete),
    complete_segments(Incomplete),
    catch(maplist(evaluated_node(Tolerance), Ss), error(Fault, Where),
          throw_named(Fault, Where)),
    unused_helpers_dropped.

%   throw_named(Fault0, Where): segments that only the tree has are called by
%   where they stand in it, as long as that is known.

throw_named(Fault0, Where) :-
    (   Fault0 =.. [Kind,What0],
        memberchk(Kind, [model_error,geometry_error])
    ->  fault_named(What0, What),
        Fault =.. [Kind,What]
    ;   Fault = Fault0
    ),
    throw(error(Fault, Where)).

evaluated_node(Tolerance, S) :-
    (   node(S, Operation, Children, _),
        Operation \== leaf
    ->  (   Operation == join
        ->  maplist(evaluated_node(Tolerance), Children)
        ;   Operation == glue
        ->  glue_operands(S, Operands),
            not_kept(Operands, Others),
            maplist(evaluated_node(Tolerance), Others)
        ;   true
        ),
        made_from(S, Tolerance, From),
        (   up_to_date(S, From)
        ->  counted(reused)
        ;   stage(rules, renewed(S, From))
        )
    ;   true
    ).

%   made_from(S, Tolerance, From): what the boundary of node S is to be made
%   from, a term with the stamps of its leaves:
%
%     - join(Stamps, Matrix)                 the shells of other segments
%     - glue(Operands, Tolerance, Wishes)    operands as they are (glue.pl), and
%       what is wanted of them (gluing/2)
%     - placed(Leaf-Stamp, Matrix)           a leaf once more (csg_flat.pl)
%     - of(Expression, Stamps, Tolerance)

made_from(S, _, From) :-
    node(S, join, Children, Steps),
    !,
    steps_matrix(Steps, Matrix0),
    rounded_matrix(Matrix0, Matrix),
    segment_stamps(Children, Stamps),
    From = join(Stamps, Matrix).
made_from(S, Tolerance0, From) :-
    node(S, glue, _, _),
    !,
    glue_tolerance(Tolerance0, S, Tolerance),
    glue_operands(S, Operands),
    findall(Wish, gluing(S, Wish), Wishes),
    From = glue(Operands, Tolerance, Wishes).
made_from(S, Tolerance0, From) :-
    flat_expression(S, Expression),
    (   Expression == S
    ->  recorded(S, evaluated(From))    % an instance: made already
    ;   flat_leaves(Expression, Leaves),
        segment_stamps(Leaves, Stamps),
        coarser(Tolerance0, S, Leaves, Tolerance),
        From = of(Expression, Stamps, Tolerance)
    ).

%   coarser(Tolerance0, S, Leaves, Tolerance): what a glue in the tree says
%   counts for all of it, if it is more than what the Leaves say.

coarser(default, S, Leaves, Tolerance) :-
    tree_tolerance(S, Tolerance),
    not_kept(Leaves, Others),
    exclude(is_half, Others, Real),
    segments_tolerance(Real, Reach, _),
    Tolerance > Reach,
    !.
coarser(Tolerance, _, _, Tolerance).

renewed(S, From) :-
    earlier(S, Earlier),
    drop_record(S),
    made(From, Earlier, S, Pieces, How),
    record(S, evaluated(From)),
    (   Pieces == []
    ->  true
    ;   record_pieces(S, Pieces)
    ),
    counted(How).

%   earlier(S, Earlier): what is known of the boundary that S has:
%
%     - none
%     - from(From)             it is a Boolean's, of operands that were checked
%     - over(From, Pieces)     the same, with the pieces it was made from;
%                              nobody changed it since, and it has no lines

earlier(S, Earlier) :-
    (   recorded(S, evaluated(From)),
        From = of(_, _, _)
    ->  (   up_to_date(S, From),
            \+ was_cut(S),
            recorded_pieces(S, Pieces)
        ->  Earlier = over(From, Pieces)
        ;   Earlier = from(From)
        )
    ;   Earlier = none
    ).

%   made(From, Earlier, S, Pieces, How): a segment alone is copied if it does
%   not go through itself, nothing is nothing. Pieces it was made
%   from, and How, `whole` or `around`: as of boolean/3.

made(join(Stamps, Matrix), _, S, [], whole) :-
    drop_boundary(S),
    pairs_keys(Stamps, Children),
    copy_segments(Children, Matrix, S).
made(glue(Operands, Tolerance, _), _, S, [], whole) :-
    drop_boundary(S),
    sort(Operands, Leaves),
    tolerance_options(Tolerance, Leaves, Options),
    glued_boundary(Operands, S, Options).
made(of(Expression, Stamps, Tolerance), Earlier, S, Pieces, How) :-
    (   integer(Expression),
        \+ meets_itself(Expression)
    ->  drop_boundary(S),
        rounded_identity(Identity),
        copy_segments([Expression], Identity, S),
        Pieces-How = []-whole
    ;   Expression == union([])
    ->  drop_boundary(S),
        Pieces-How = []-whole
    ;   new_leaves(Earlier, Stamps, Leaves),
        exclude(is_surface, Leaves, Solids),
        maplist(checked_operand, Solids),
        pairs_keys(Stamps, Known),
        tolerance_options(Tolerance, Known, Options),
        boolean_made(Earlier, Expression, Tolerance, S,
                     [pieces(Pieces),made(How)|Options])
    ).

%   new_leaves(Earlier, Stamps, Leaves): those that were not checked before.

new_leaves(Earlier, Stamps, Leaves) :-
    (   Earlier == none
    ->  New = Stamps
    ;   arg(1, Earlier, of(_, Known, _)),
        ord_subtract(Stamps, Known, New)
    ),
    pairs_keys(New, Leaves).

boolean_made(over(From, Pieces), Expression, Tolerance, S, Options) :-
    !,
    drop_pictures(S),
    (   From = of(Expression0, _, Tolerance0),
        Expression0-Tolerance0 == Expression-Tolerance
    ->  boolean(Expression, S, [over(true),earlier(Pieces)|Options])
    ;   boolean(Expression, S, [over(true)|Options])
    ).
boolean_made(_, Expression, _, S, Options) :-
    drop_boundary(S),
    boolean(Expression, S, Options).

is_surface(S) :-
    segment(S, surface, _),
    !.

%   A solid that goes through itself is united with itself.

meets_itself(Leaf) :-
    segment(Leaf, solid, _),
    operand_faults(Leaf, []),
    segment_meets_itself(Leaf).

%   tolerance_options(Tolerance, Leaves, Options): a half-space is as large as
%   it has to be and says nothing about the model; a surface that one was made
%   from does.

tolerance_options(default, Leaves, Options) :-
    !,
    not_kept(Leaves, Others),
    include(is_half, Others, Halves),
    (   Halves == []
    ->  Options = []
    ;   ord_subtract(Leaves, Halves, Own),
        findall(Surface, ( member(Half, Halves), half_surface(Half, Surface) ),
                Surfaces),
        append(Own, Surfaces, Real),
        segments_tolerance(Real, Reach, _),
        Options = [tolerance(own(Reach))]
    ).
tolerance_options(Tolerance, _, [tolerance(Tolerance)]).

rounded_identity(Rounded) :-
    identity_matrix(Identity),
    rounded_matrix(Identity, Rounded).

%   Helpers that no boundary was made from are no longer needed.

unused_helpers_dropped :-
    helpers(Helpers0),
    (   Helpers0 == []
    ->  true
    ;   findall(S, ( recorded(_, evaluated(From)), from_segment(From, S) ),
                Used0),
        sort(Used0, Used),
        sort(Helpers0, Helpers),
        ord_subtract(Helpers, Used, Unused),
        maplist(segment_dropped, Unused)
    ).

from_segment(of(_, Stamps, _), S) :-
    member(S-_, Stamps).
from_segment(join(Stamps, _), S) :-
    member(S-_, Stamps).
from_segment(glue(Operands, _, _), S) :-
    member(S, Operands).


segment_dropped(S) :-
    drop_record(S),
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).

%!  evaluated(?S) is nondet.
%
%   True when node S has a boundary, and it is that of its operands as they are
%   now. Ascending.

evaluated(S) :-
    findall(N, ( node(N, Operation, _, _), Operation \== leaf ), Ns0),
    sort(Ns0, Ns),
    member(S, Ns),
    facts_snapshot(sg_csg_evaluate:completed_and_current(S)).

completed_and_current(S) :-
    catch(complete_tree([S]), error(model_error(_), _), fail),
    is_current(S).

is_current(S) :-
    recorded(S, evaluated(From0)),
    (   ( From0 = of(_, _, Tolerance) ; From0 = glue(_, Tolerance, _) )
    ->  true
    ;   Tolerance = default
    ),
    made_from(S, Tolerance, From),
    From == From0,                      % an instance has just been made
    up_to_date(S, From),
    (   node(S, Operation, Children, _),
        memberchk(Operation, [join,glue])
    ->  forall(( member(Child, Children), is_node(Child) ), is_current(Child))
    ;   true
    ).


                /*******************************
                *          STATISTICS          *
                *******************************/

%!  csg_statistics(-Statistics:dict) is det.
%
%   How often in this thread the boundary of a node was `evaluated`, how many of
%   these times only `around` what had changed, and how often it was `reused` as
%   it was, since csg_statistics_reset/0; and `pieces`: pieces_statistics/1.

csg_statistics(_{evaluated:Evaluated, around:Around, reused:Reused,
                 pieces:Pieces}) :-
    count_of(whole, Whole),
    count_of(around, Around),
    Evaluated is Whole+Around,
    count_of(reused, Reused),
    pieces_statistics(Pieces).

%!  csg_statistics_reset is det.

csg_statistics_reset :-
    nb_setval(sg_csg_whole, 0),
    nb_setval(sg_csg_around, 0),
    nb_setval(sg_csg_reused, 0).

counted(What) :-
    count_of(What, N0),
    N is N0+1,
    atom_concat(sg_csg_, What, Key),
    nb_setval(Key, N).

count_of(What, N) :-
    atom_concat(sg_csg_, What, Key),
    (   nb_current(Key, N0)
    ->  N = N0
    ;   N = 0
    ).
