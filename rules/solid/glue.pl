:- module(sg_glue,
          [ glued_boundary/4,           % +Operands, +S, +Options, -Report
            unglue/1,                   % +S
            glue_report/2,              % +S, -Report
            glue_misses/2               % +S, -Misses
          ]).
:- use_module(arrangement,
              [ with_arrangement/3, components/2, arranged_solid/3,
                contact_vertices/2
              ]).
:- use_module(boolean, [boolean_tolerance/3]).
:- use_module(contact_origin, [contact_origins/2]).
:- use_module('../csg/csg', [glue_operands/2, node/4]).
:- use_module('../csg/csg_record', [drop_record/1]).
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
              [ near_segments_of/3, segment_meetings/3, solid_close/1,
                solid_coincident_faces/3, solid_write_cells/3
              ]).
:- use_module('../limits', [limit_value/2]).
:- use_module(operand, [operand_faults/2]).
:- use_module('../penetration/resolve', [tolerance_reach/2]).
:- use_module('../polygon/triangulation', [new_segments_complete/0]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, from_p/5, from_r/4, from_v/4, sides/4,
                region/3, lies_in/3, assert_fact/1, retractall_facts/1,
                facts_transaction/1
              ]).
:- use_module(library(apply),
              [ convlist/3, foldl/4, include/3, maplist/2, maplist/3,
                partition/4
              ]).
:- use_module(library(assoc),
              [ get_assoc/3, list_to_assoc/2, ord_list_to_assoc/2,
                put_assoc/4
              ]).
:- use_module(library(error), [existence_error/2, type_error/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/2]).
:- use_module(library(ordsets), [ord_subtract/3, ord_symdiff/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_keys_values/3]).
/** <module> Glue: operands in one model, each thing once (NG-1 to NG-7).

The operands are arranged as those of a Boolean are; but everything stays. Faces
that lie on each other become one, which has the sources of all (from_p/5).
Neighbours in one plane become one face only where no third face is at their
edge, and where they come from the same operands; edges and vertices of others
in the middle of a face stay there. Then the regions of space are found, and
what operands each of them is inside.

The operands keep their rows, so nothing is needed to take them apart again.
*/

%!  glued_boundary(+Operands:list, +S, +Options:list, -Report) is det.
%
%   The rows of segment S, which has none, become the solids, surfaces and
%   curves Operands glued, with region/3, sides/4, lies_in/3 and from_r/4;
%   Report is as regions_report/2 has it. Both laws hold. Call it in a
%   transaction. Options: those of with_arrangement/3.
%
%   @error as boolean/3; of choice_parted/1
%   @error geometry_error(glue_law(S, Faults)): a law does not hold
%   @error geometry_error(wrong_triangles(S, P)): of wires_written/3
%   @error geometry_error(glue_meets(S, P1, P2, X, Y, Z)): two of its polygons
%          meet there and share nothing

glued_boundary(Operands, S, Options0, Report) :-
    new_segments_complete,
    partition(is_curve, Operands, Curves, Others),
    boolean_tolerance(Operands, Options0, Options),
    option(tolerance(Tolerance), Options),
    tolerance_reach(Tolerance, Reach),
    faces_glued(Others, S, Options, Reach),
    stage(rules, wires_written(S, Curves, Reach)),
    source_kept(Operands, 1, S),
    stage(regions, regions_found(S, Report0)),
    lawful(S, Report0),
    contents_written(S, Operands),
    (   choice_made(S)
    ->  stage(rules, chosen(S, Operands, Report))
    ;   Report = Report0
    ).

%   chosen(S, Operands, Report): not all of S is to be glued.

chosen(S, Operands, Report) :-
    choice_parted(S),
    catch(regions_again(S, Report1), error(Fault, Context),
          throw_apart(Fault, Context)),
    twins_turned(S),
    contents_written(S, Operands),
    (   choice_dissolved(S, Insides)
    ->  list_to_assoc(Insides, Known),
        forall(region(S, R, Role), content_written(S, R, Role, Known)),
        regions_report(S, Report)
    ;   Report = Report1
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
    pieces(Operands, Solids, Reach, Options, Solid, Contacts, How),
    call_cleanup(
        ( stage(faces, faces_merged(Solid,
                                    [ origins(separate),cells(true)
                                    | Options
                                    ])),
          stage(write, solid_write_cells(Solid, S, Loops))
        ),
        solid_close(Solid)),
    contact_origins(S, Contacts),
    forall(member(V-P, Loops), assert_fact(lies_in(S, v(V), p(P)))),
    (   How == whole
    ->  true
    ;   stage(join, points_in_faces(S))
    ).

%   pieces(Operands, Solids, Reach, Options, Solid, Contacts, How): How is `cut`
%   or, if there was nothing to cut, `whole`.

pieces(Operands0, Solids, Reach, _, Solid, [], whole) :-
    sort(Operands0, Operands),
    whole_pieces(Operands, Solids, Reach, Solid),
    !.
pieces(Operands, Solids, Reach, Options, Solid, Contacts, cut) :-
    maplist(closed_operand, Solids),
    with_arrangement(Operands, Options,
                     sg_glue:everything(Solids, Solid0, Contacts)),
    (   catch(solid_coincident_faces(Solid0, Reach, _), Error,
              ( solid_close(Solid0), throw(Error) ))
    ->  Solid = Solid0
    ).

solids_among(Operands, Solids) :-
    include(is_solid, Operands, Solids0),
    sort(Solids0, Solids).

is_solid(S) :-
    segment(S, solid, _),
    !.

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

%   points_in_faces(S): where a vertex lies in the middle of a face exactly
%   nothing was cut. Nothing else meets that has no vertex or edge in common.

points_in_faces(S) :-
    limit_value(facets, Most),
    segment_meetings(S, Most, Segments),
    forall(( member(self(S, _, Meetings), Segments),
             member(Meeting, Meetings) ),
           point_in_face(S, Meeting)).

point_in_face(S, meeting(self_touching, P1, P2, X, Y, Z)) :-
    (   P = P1,
        Q = P2
    ;   P = P2,
        Q = P1
    ),
    corner_at(S, Q, X, Y, Z, V),
    !,
    (   lies_in(S, v(V), p(P))
    ->  true
    ;   assert_fact(lies_in(S, v(V), p(P)))
    ).
point_in_face(S, meeting(_, P1, P2, X, Y, Z)) :-
    throw(error(geometry_error(glue_meets(S, P1, P2, X, Y, Z)), _)).

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
    retractall_facts(segment(S, _, _)).


                /*******************************
                *           CONTENTS           *
                *******************************/

%   contents_written(S, Operands): write from_r/4 of the regions of S: which of
%   the solids among Operands each is inside. The outside is inside none; who
%   crosses a face goes in or out of the solids that it is a part of. A bounded
%   region inside of none is a `void`.

contents_written(S, Operands) :-
    solids_among(Operands, Solids0),
    set_assoc(Solids0, Solids),
    findall(R-Step, crossing(S, Solids, R, Step), Steps0),
    keysort(Steps0, Steps1),
    group_pairs_by_key(Steps1, Steps),
    list_to_assoc(Steps, Around),
    once(region(S, Outside, outside)),
    list_to_assoc([Outside-[]], Known0),
    spread([Outside], Around, Known0, Known),
    findall(R-Role, region(S, R, Role), Regions),
    forall(member(R-Role, Regions), content_written(S, R, Role, Known)).

%   crossing(S, Solids, R, to(R1, Through)): a polygon lies between R and R1;
%   Through are those of Solids that it bounds, in order. One of each two
%   regions is enough.

crossing(S, Solids, R, to(R1, Through)) :-
    findall((Below-Above)-P,
            ( sides(S, P, Below, Above), Below \== Above ), Pairs0),
    sort(1, @<, Pairs0, Pairs),
    member((Below-Above)-P, Pairs),
    findall(S0-Sense,
            ( from_p(S, P, S0, _, Sense), get_assoc(S0, Solids, _) ), Senses0),
    sort(Senses0, Senses),
    through(Senses, Through),
    (   R-R1 = Below-Above
    ;   R-R1 = Above-Below
    ).

%   through(Senses, Through): where a solid lies on itself one goes out of it
%   and in again.

through([], []).
through([S-_,S-_|Senses], Through) :-
    !,
    through(Senses, Through).
through([S-_|Senses], [S|Through]) :-
    through(Senses, Through).

spread([], _, Known, Known).
spread([R|Rs], Around, Known0, Known) :-
    get_assoc(R, Known0, Inside),
    (   get_assoc(R, Around, Steps)
    ->  foldl(step(Inside), Steps, Rs-Known0, Rs1-Known1)
    ;   Rs1 = Rs,
        Known1 = Known0
    ),
    spread(Rs1, Around, Known1, Known).

step(Inside0, to(R, Through), Rs-Known0, Rs1-Known) :-
    (   get_assoc(R, Known0, _)
    ->  Rs1 = Rs,
        Known = Known0
    ;   ord_symdiff(Inside0, Through, Inside),
        put_assoc(R, Known0, Inside, Known),
        Rs1 = [R|Rs]
    ).

content_written(S, R, Role, Known) :-
    (   get_assoc(R, Known, Inside)
    ->  true
    ;   Inside = []
    ),
    forall(member(S0, Inside), assert_fact(from_r(S, R, S0, 1))),
    (   Role == cell,
        Inside == []
    ->  retractall_facts(region(S, R, _)),
        assert_fact(region(S, R, void))
    ;   true
    ).
