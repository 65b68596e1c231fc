:- module(sg_glue,
          [ glued_boundary/3,           % +Operands, +S, +Options
            unglue/1,                   % +S
            glue_report/2,              % +S, -Report
            glue_misses/2               % +S, -Misses
          ]).
:- use_module(arrangement,
              [ with_arrangement/3, components/2, arranged_solid/3,
                contact_vertices/2
              ]).
:- use_module(boolean, [boolean_tolerance/3]).
:- use_module('../csg/csg', [glue_operands/2, node/4]).
:- use_module('../csg/csg_record', [drop_record/1, segments_of_kind/3]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../csg/source', [source_kept/3]).
:- use_module(faces, [faces_merged/2]).
:- use_module(glue_parted,
              [choice_dissolved/2, choice_parted/1, twins_turned/1]).
:- use_module(glue_whole, [whole_pieces/4]).
:- use_module(glue_wire, [wires_written/3]).
:- use_module('../gluing/cells_edit', [regions_again/2]).
:- use_module('../gluing/gap', [gap_reach/2, near_misses/3]).
:- use_module('../gluing/glue_choice', [choice_made/1]).
:- use_module('../gluing/regions',
              [regions_found/2, regions_report/2, law_fault/3]).
:- use_module('../kernel',
              [ contact_origins/2, contents_written/4, leaf_copies/3,
                near_segments_of/3,
                segment_meetings/3, solid_close/1, solid_coincident_faces/3,
                solid_write_cells/3
              ]).
:- use_module('../limits', [limit_value/2]).
:- use_module(operand, [operand_faults/2, segment_thickness/2]).
:- use_module('../penetration/resolve',
              [held_said/1, holding_said/2, tolerance_reach/2]).
:- use_module('../polygon/triangulation', [new_segments_complete/0]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, from_p/5, from_r/4, from_v/4,
                region/3, lies_in/3, assert_fact/1, retractall_facts/1,
                facts_transaction/1
              ]).
:- use_module(library(apply),
              [convlist/3, exclude/3, maplist/2, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, ord_list_to_assoc/2]).
:- use_module(library(error), [existence_error/2, type_error/2]).
:- use_module(library(lists), [append/3, list_to_set/2, member/2]).
:- use_module(library(option), [option/2]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).
:- use_module(library(pairs),
              [group_pairs_by_key/2, pairs_keys/2, pairs_keys_values/3]).
/** <module> Glue: operands in one model, each thing once (NG-1 to NG-7).

The operands are arranged as those of a Boolean are; but everything stays. Faces
that lie on each other become one, which has the sources of all (from_p/5).
Neighbours in one plane become one face only where no third face is at their
edge, and where they come from the same operands; edges and vertices of others
in the middle of a face stay there. Then the regions of space are found, and
what operands each of them is inside.

The operands keep their rows, so nothing is needed to take them apart again.
*/

%!  glued_boundary(+Operands:list, +S, +Options:list) is det.
%
%   The rows of segment S, which has none, become the solids, surfaces and
%   curves Operands glued, with region/3, sides/4, lies_in/3 and from_r/4. Both
%   laws hold. Call it in a transaction. Options: those of with_arrangement/3.
%
%   @error as boolean/3; of choice_parted/1
%   @error geometry_error(glue_law(S, Faults)): a law does not hold
%   @error geometry_error(wrong_triangles(S, P)): of wires_written/3
%   @error geometry_error(glue_meets(S, P1, P2, X, Y, Z)): two of its polygons
%          meet there and share nothing
%   @error geometry_error(thin_operand(S, Thick, Reach, X, Y, Z)): one of both,
%          and S, round there, is about as thin as what is made one place

glued_boundary(Operands, S, Options0) :-
    new_segments_complete,
    segments_of_kind(curve, Operands, Curves),
    (   Curves == []
    ->  Others = Operands
    ;   exclude(is_curve, Operands, Others)
    ),
    boolean_tolerance(Operands, Options0, Options),
    option(tolerance(Tolerance), Options),
    tolerance_reach(Tolerance, Reach),
    catch(lawfully_glued(Operands, Others, Curves, S, Options, Reach),
          error(geometry_error(Fault), Context),
          blamed(Fault, Context, Others, Reach)),
    (   choice_made(S)
    ->  stage(rules, chosen(S, Operands))
    ;   true
    ).

lawfully_glued(Operands, Others, Curves, S, Options, Reach) :-
    faces_glued(Others, S, Options, Reach),
    stage(rules, wires_written(S, Curves, Reach)),
    source_kept(Operands, 1, S),
    stage(regions, regions_found(S, Report)),
    lawful(S, Report),
    contents_found(S, Operands).

%   blamed(Fault, Context, Operands, Reach): where a law breaks, an operand that
%   is about as thin as what is made one place is why.

blamed(Fault, _, Operands, Reach) :-
    functor(Fault, Name, _),
    memberchk(Name, [glue_law,glue_meets]),
    member(S, Operands),
    segment(S, solid, _),
    segment_thickness(S, Thick),
    Thick =< 4*Reach,
    !,
    once(v(S, _, X, Y, Z)),
    throw(error(geometry_error(thin_operand(S, Thick, Reach, X, Y, Z)), _)).
blamed(Fault, Context, _, _) :-
    throw(error(geometry_error(Fault), Context)).

%   chosen(S, Operands): not all of S is to be glued.

chosen(S, Operands) :-
    choice_parted(S),
    catch(regions_again(S, _), error(Fault, Context),
          throw_apart(Fault, Context)),
    twins_turned(S),
    contents_found(S, Operands),
    (   choice_dissolved(S, Insides)
    ->  forall(member(R-Inside, Insides), content_written(S, R, Inside))
    ;   true
    ).

is_curve(S) :-
    segment(S, curve, _),
    !.

throw_apart(Fault, Context) :-
    (   Fault = geometry_error(glue_law(S, Faults)),
        memberchk(unsure_part-_, Faults)
    ->  throw(error(geometry_error(part_glue(no_side(S))), Context))
    ;   throw(error(Fault, Context))
    ).

faces_glued([], _, _, _) :-
    !.
faces_glued(Operands, S, Options, Reach) :-
    solids_among(Operands, Solids),
    faces_glued(Operands, Solids, S, Options, Reach, []).

%   Parts of operands in nearly one plane may meet others as one face that they
%   do not meet as they are: then these stay Apart, and all is done once more.

%   What a round moves is said when it is known to be the last.

faces_glued(Operands, Solids, S, Options, Reach, Apart) :-
    holding_said(sg_glue:round_made(Operands, Solids, S, Options, Reach, Apart,
                                    How),
                 Held),
    (   How == whole
    ->  held_said(Held)
    ;   How = cut(Copies),
        stage(join, points_in_faces(S, Meetings)),
        (   Meetings == []
        ->  held_said(Held),
            copies_named(S, Copies)
        ;   merged_parts(S, Meetings, Pairs),
            ord_union(Apart, Pairs, More),
            More \== Apart
        ->  drop_boundary(S),
            faces_glued(Operands, Solids, S, Options, Reach, More)
        ;   Meetings = [meeting(_, P1, P2, X, Y, Z)|_],
            throw(error(geometry_error(glue_meets(S, P1, P2, X, Y, Z)), _))
        )
    ).

round_made(Operands, Solids, S, Options, Reach, Apart, How) :-
    pieces(Operands, Solids, Reach, Options, Solid, Contacts, How),
    call_cleanup(
        ( stage(faces, faces_merged(Solid,
                                    [ origins(separate),cells(true),
                                      apart(Apart)
                                    | Options
                                    ])),
          stage(write, solid_write_cells(Solid, S, Loops))
        ),
        solid_close(Solid)),
    contact_origins(S, Contacts),
    list_to_set(Loops, Once),
    forall(member(V-P, Once), assert_fact(lies_in(S, v(V), p(P)))).

%   merged_parts(S, Meetings, Pairs): what became one in the polygons of
%   Meetings, pairs as of solid_neighbours/3.

merged_parts(S, Meetings, Pairs) :-
    findall(part(S0, P1, Sense1)-part(S0, P2, Sense2),
            ( member(meeting(_, P, Q, _, _, _), Meetings),
              member(Of, [P,Q]),
              from_p(S, Of, S0, P1, Sense1),
              from_p(S, Of, S0, P2, Sense2),
              P1 < P2 ),
            Pairs0),
    sort(Pairs0, Pairs).

%   pieces(Operands, Solids, Reach, Options, Solid, Contacts, How): How is
%   cut(Copies), where of operands that are equal (leaf_copies/3) the first one
%   was cut alone, or, if there was nothing to cut, `whole`.

pieces(Operands0, Solids, Reach, _, Solid, [], whole) :-
    sort(Operands0, Operands),
    whole_pieces(Operands, Solids, Reach, Solid),
    !.
pieces(Operands0, Solids, Reach, Options, Solid, Contacts, cut(Copies)) :-
    maplist(closed_operand, Solids),
    sort(Operands0, Operands1),
    leaf_copies(Operands1, 1, Copies),
    pairs_keys(Copies, Gone),
    ord_subtract(Operands1, Gone, Operands),
    with_arrangement(Operands, Options,
                     sg_glue:everything(Solids, Solid0, Contacts)),
    (   catch(solid_coincident_faces(Solid0, Reach, _), Error,
              ( solid_close(Solid0), throw(Error) ))
    ->  Solid = Solid0
    ).

%   copies_named(S, Copies): the polygons of S that come from a first operand
%   come from those that are equal to it, too.

copies_named(_, []) :-
    !.
copies_named(S, Copies) :-
    findall(from_p(S, P, S0, P0, Sense), from_p(S, P, S0, P0, Sense), Known),
    findall(First-Row,
            ( member(Row, Known), Row = from_p(_, _, First, _, _) ), Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    ord_list_to_assoc(Groups, RowsOf),
    findall(from_p(S, P, Copy, P0, Sense),
            ( member(Copy-First, Copies),
              get_assoc(First, RowsOf, Rows),
              polygon_copies(First, Copy, CopyOf),
              member(from_p(_, P, _, P1, Sense), Rows),
              get_assoc(P1, CopyOf, P0) ),
            New),
    append(Known, New, All0),
    sort(All0, All),
    retractall_facts(from_p(S, _, _, _, _)),
    maplist(assert_fact, All).

polygon_copies(First, Copy, CopyOf) :-
    maplist(polygons, [First,Copy], [Ps,CopiesOf]),
    pairs_keys_values(Pairs, Ps, CopiesOf),
    ord_list_to_assoc(Pairs, CopyOf).

polygons(S, Ps) :-
    findall(P, p(S, P, _), Ps0),
    sort(Ps0, Ps).

solids_among(Operands, Solids) :-
    segments_of_kind(solid, Operands, Solids0),
    sort(Solids0, Solids).

%   set_assoc(Set, Assoc): a solid of a thousand is found at once.

set_assoc(Set, Assoc) :-
    pairs_keys_values(Pairs, Set, Set),
    ord_list_to_assoc(Pairs, Assoc).

%   closed_operand(S): whether it is inside out does not matter.

closed_operand(S) :-
    operand_faults(S, Faults),
    (   Faults == []
    ->  true
    ;   throw(error(geometry_error(operand(S, Faults)), _))
    ).

lawful(S, Report) :-
    findall(Fault-N, law_fault(Report, Fault, N), Faults),
    (   Faults == []
    ->  true
    ;   throw(error(geometry_error(glue_law(S, Faults)), _))
    ).

%   points_in_faces(S, Meetings): where a vertex lies in the middle of a face
%   exactly nothing was cut. Meetings are all others of its polygons that have
%   no vertex or edge in common: there should be none.

points_in_faces(S, Meetings) :-
    limit_value(facets, Most),
    segment_meetings(S, Most, Segments),
    findall(Meeting, ( member(self(S, _, All), Segments),
                       member(Meeting, All) ), Found),
    exclude(point_in_face(S), Found, Meetings).

point_in_face(S, meeting(self_touching, P1, P2, X, Y, Z)) :-
    (   P = P1,
        Q = P2
    ;   P = P2,
        Q = P1
    ),
    corner_at(S, Q, X, Y, Z, V),
    !,
    (   lies_in(S, v(V), Face)
    ->  Face == p(P)                    % in two faces it is no mere point
    ;   assert_fact(lies_in(S, v(V), p(P)))
    ).

corner_at(S, Q, X, Y, Z, V) :-
    p(S, Q, Es),
    member(E, Es),
    e(S, E, V, _, _),
    v(S, V, X, Y, Z),
    !.

%   everything(+Solids, -Solid, -Contacts, +Arrangement): all components that
%   have an area; of a solid that goes through itself only what bounds it.

everything(Solids, Solid, Contacts, Arrangement) :-
    contact_vertices(Arrangement, Contacts),
    components(Arrangement, Components),
    set_assoc(Solids, Known),
    convlist(stays_glued(Known), Components, Senses),
    stage(pieces, arranged_solid(Arrangement, Senses, Solid)).

stays_glued(Solids, component(C, S, _, _, Sides, Which), C-1) :-
    Which \== unknown,
    (   get_assoc(S, Solids, _)
    ->  memberchk(side(S, Below, Above), Sides),
        sign(Below) =\= sign(Above)
    ;   true
    ).

%!  glue_misses(+S, -Misses:list) is det.
%
%   Misses, as of near_misses/3, are where operands of the glue S come near each
%   other (gap_reach/2) and have nothing in common.

glue_misses(S, Misses) :-
    (   gap_reach(S, Reach)
    ->  glue_operands(S, Operands0),
        sort(Operands0, Operands),
        near_segments_of(Reach, Operands, Groups),
        findall(S1-S2,
                ( member(S1-Others, Groups), member(S2, Others), S1 < S2 ),
                Near0),
        sort(Near0, Near),
        findall(Pair, ( Near \== [], contact(S, Pair) ), Contacts0),
        sort(Contacts0, Contacts),
        ord_subtract(Near, Contacts, Pairs),
        near_misses(Pairs, Reach, Misses)
    ;   Misses = []
    ).

%   contact(S, S1-S2) is nondet: faces or wires of both operands are at one
%   vertex of S.

contact(S, S1-S2) :-
    findall(V-S0, vertex_operand(S, V, S0), Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    member(_-Ss, Groups),
    member(S1, Ss),
    member(S2, Ss),
    S1 < S2.

vertex_operand(S, V, S0) :-
    from_v(S, V, S0, _).
vertex_operand(S, V, S0) :-
    from_p(S, P, S0, _, _),
    (   p(S, P, Es),
        member(E, Es),
        e(S, E, V, _, _)
    ;   lies_in(S, v(V), p(P))
    ).

%!  glue_report(+S, -Report) is det.
%
%   Report is that of regions_report/2, of the boundary of glue S; each of its
%   regions has `inside`, the list of the operands that it is inside.

glue_report(S, Report) :-
    regions_report(S, Report0),
    maplist(region_inside(S), Report0.regions, Regions),
    Report = Report0.put(regions, Regions).

region_inside(S, Region0, Region) :-
    findall(S0, from_r(S, Region0.region, S0, _), Inside),
    region(S, Region0.region, Role),
    Region = Region0.put(_{inside:Inside, role:Role}).

%!  unglue(+S) is det.
%
%   Take the glue S away, a node: its operands are what they were, and roots
%   again if they are operands of nothing else. One transaction.
%
%   @error existence_error(segment, S); type_error(glue, S)

unglue(S) :-
    (   segment(S, _, _)
    ->  true
    ;   existence_error(segment, S)
    ),
    (   node(S, glue, _, _)
    ->  facts_transaction(sg_glue:unglued(S))
    ;   type_error(glue, S)
    ).

unglued(S) :-
    drop_record(S),
    drop_boundary(S),
    retractall_facts(gluing(S, _)),
    retractall_facts(segment(S, _, _)).


                /*******************************
                *           CONTENTS           *
                *******************************/

%   contents_found(S, Operands): write from_r/4 of the regions of S: which of
%   the solids among Operands each is inside. A bounded one inside none is a
%   `void`. Each polygon has a solid that it is made of on one side alone: else
%   there is an error.

contents_found(S, Operands) :-
    solids_among(Operands, Solids),
    contents_written(S, Solids, Nothing, Wrong),
    (   Wrong =:= 0
    ->  true
    ;   throw(error(geometry_error(glue_law(S, [wrong_side-Wrong])), _))
    ),
    forall(( member(R, Nothing), region(S, R, cell) ), is_void(S, R)).

is_void(S, R) :-
    retractall_facts(region(S, R, _)),
    assert_fact(region(S, R, void)).

content_written(S, R, Inside) :-
    forall(member(S0, Inside), assert_fact(from_r(S, R, S0, 1))),
    (   Inside == [],
        region(S, R, cell)
    ->  is_void(S, R)
    ;   true
    ).
