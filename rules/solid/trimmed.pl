:- module(sg_trimmed,
          [ trimmed/4,                  % +S, +Others, +Side, -T
            trimmed/5,                  % +S, +Others, +Side, +Options, -T
            stays_trimmed/4,            % +S, +Others, +Side, +Component
            trimmed_from/2,             % +T, -S
            part_named/2,               % +T, -S
            part_named/4                % +T, +Part0, -S, -Part
          ]).
:- use_module(arrangement,
              [ with_arrangement/3, components/2, arranged_solid/3,
                contact_vertices/2
              ]).
:- use_module(closing, [closed_by_caps/1]).
:- use_module('../decision', [decision/2]).
:- use_module('../kernel',
              [ contact_origins/2, solid_close/1, solid_is_closed/1,
                solid_write/2
              ]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ origin/3, p/3, segment/3, assert_fact/1, facts_snapshot/1,
                facts_transaction/1, fresh_id/3
              ]).
:- use_module(library(apply), [maplist/2, partition/4]).
:- use_module(library(error), [existence_error/2, must_be/2]).
:- use_module(library(lists), [member/2]).
/** <module> Trimming: the part of a segment outside, or inside, of others.

Before a part is developed, what of it is inside the parts that it goes through
is taken away: a branch pipe ends at the header in a saddle, the header gets a
hole. What stays is chosen of the pieces of an arrangement (arrangement.pl), as
in a Boolean, but of one segment alone: so it is a surface, exact, whose border
is the penetration line. Faces stay apart as they were: each polygon of the
result is a piece of one polygon, or all of it, and names it in from_p/5;
vertices that were there are named by from_v/4, those that the cuts made have
an origin/3.

What is trimmed may be a solid or an open surface, as a pipe without ends. Of
the others it must be known what is inside them: a surface whose borders are
flat is closed by flat faces for that, for the time of the question.

@see [DV] rows DV-9 and PL-10
*/

%!  trimmed(+S, +Others:list, +Side, -T) is det.
%!  trimmed(+S, +Others:list, +Side, +Options:list, -T) is det.
%
%   T is a new segment, trimmed(S, Side, Others): the pieces of segment S that
%   are `outside` of all segments in Others, or `inside` of one at least. If
%   those are all pieces of S, T is S itself. Which pieces: stays_trimmed/4.
%   Options are those of with_arrangement/3, as tolerance(T). One transaction;
%   the segments stay as they are.
%
%   @error existence_error(segment, S1)
%   @error geometry_error(trim(nothing_left(S, Side))): no piece is
%   @error geometry_error(trim(kind(S, Kind))): a curve has no pieces
%   @error geometry_error(trim(open(S1, V1, V2))): of S1, one of Others, nobody
%          can say what is inside: the border that runs from V1 to V2 is not
%          flat

trimmed(S, Others, Side, T) :-
    trimmed(S, Others, Side, [], T).

trimmed(S, Others0, Side, Options, T) :-
    must_be(oneof([outside,inside]), Side),
    sort(Others0, Others),
    maplist(has_faces, [S|Others]),
    facts_snapshot(sg_trimmed:chosen(S, Others, Side, Options, Chosen)),
    (   Chosen == all
    ->  T = S
    ;   Chosen == nothing
    ->  throw(error(geometry_error(trim(nothing_left(S, Side))), _))
    ;   Chosen = solid(Solid, Contacts),
        setup_call_cleanup(
            true,
            facts_transaction(
                sg_trimmed:written(Solid, Contacts,
                                   trimmed(S, Side, Others), T)),
            solid_close(Solid))
    ).

has_faces(S) :-
    (   segment(S, Kind, _)
    ->  (   memberchk(Kind, [solid,surface])
        ->  true
        ;   throw(error(geometry_error(trim(kind(S, Kind))), _))
        )
    ;   existence_error(segment, S)
    ).

%   chosen(+S, +Others, +Side, +Options, -Chosen): `all`, `nothing`, or a handle
%   of what stays, with the vertices of S that were made to touch.

chosen(S, Others, Side, Options, Chosen) :-
    maplist(closed_by_caps, Others),
    with_arrangement([S|Others], Options,
                     sg_trimmed:selected(S, Others, Side, Chosen)).

selected(S, Others, Side, Chosen, Arrangement) :-
    components(Arrangement, All),
    findall(Component,
            ( member(Component, All), arg(2, Component, S) ),
            Own),
    partition(sg_trimmed:stays_trimmed(S, Others, Side), Own, Stay, Go),
    (   Go == []
    ->  Chosen = all
    ;   Stay == []
    ->  Chosen = nothing
    ;   findall(C-1, ( member(Component, Stay), arg(1, Component, C) ), Senses),
        contact_vertices(Arrangement, Contacts),
        stage(pieces, arranged_solid(Arrangement, Senses, Solid)),
        Chosen = solid(Solid, Contacts)
    ).

written(Solid, Contacts, Term, T) :-
    fresh_id(segment, 0, T),
    (   solid_is_closed(Solid)
    ->  Kind = solid
    ;   Kind = surface
    ),
    assert_fact(segment(T, Kind, Term)),
    stage(write, ( solid_write(Solid, T),
                   contact_origins(T, Contacts)
                 )).

:- decision(stays_trimmed/4, "Which pieces of a part stay when it is trimmed").

%!  stays_trimmed(+S, +Others:list, +Side, +Component) is semidet.
%
%   Decision: a component of segment S, component(C, S, P, Point, Sides, Which)
%   as of components/2, stays when S is trimmed to what is on Side of Others.
%   The default is what stays of S in the union of all (`outside`), or in the
%   intersection of S with all others (`inside`): so of faces that lie on each
%   other and look the same way one stays, that of the smallest segment, and
%   of those that look at each other none.

stays_trimmed(_, Others, outside, component(_, _, _, _, Sides, Which)) :-
    \+ ( member(side(Other, _, Above), Sides),
         memberchk(Other, Others),
         Above > 0
       ),
    \+ ( Which == second,
         goes_round_below(Sides, Others)
       ).
stays_trimmed(_, Others, inside, component(_, _, _, _, Sides, Which)) :-
    goes_round_below(Sides, Others),
    (   Which \== second
    ->  true
    ;   member(side(Other, Below, Above), Sides),
        memberchk(Other, Others),
        Below > 0,
        Above > 0
    ->  true
    ).

goes_round_below(Sides, Others) :-
    member(side(Other, Below, _), Sides),
    memberchk(Other, Others),
    Below > 0,
    !.

%!  trimmed_from(+T, -S) is det.
%
%   S is the segment that T was trimmed from, or T itself.

trimmed_from(T, S) :-
    (   segment(T, _, trimmed(S0, _, _)),
        integer(S0),
        p(T, _, _)
    ->  trimmed_from(S0, S)
    ;   S = T
    ).

%!  part_named(+T, -S) is det.
%
%   S is the segment that a user knows: what T was trimmed from, and what that
%   was made another side of the plate of, or T itself. A segment S1 of such a
%   side has origin(S1, node(S1), plate(S)).

part_named(T, S) :-
    trimmed_from(T, S1),
    (   origin(S1, node(S1), plate(S0))
    ->  part_named(S0, S)
    ;   S = S1
    ).

%!  part_named(+T, +Part0, -S, -Part) is det.
%
%   As part_named/2; Part0 of T (true_part/5) is Part of S: its name, or of
%   which segment it is, and its name.

part_named(T, Part0, S, Part) :-
    part_named(T, S),
    (   Part0 = Leaf0/Name
    ->  part_named(Leaf0, Leaf),
        (   Leaf == S
        ->  Part = Name
        ;   Part = Leaf/Name
        )
    ;   Part = Part0
    ).
