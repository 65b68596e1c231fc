:- module(sg_regions,
          [ regions_made/2,             % +S, -Report
            regions_found/2,            % +S, -Report
            regions_report/2,           % +S, -Report
            law_fault/3,                % +Report, -Fault, -Count
            region_neighbour/4          % ?S, ?R1, ?R2, ?P
          ]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module(glue_choice, [stays_parted/1]).
:- use_module('../kernel',
              [ regions_open/3, regions_told/4, regions_close/1,
                regions_counted/2, regions_listed/2, regions_neighbours/2,
                regions_items/3, regions_written/1, segment_welded/2
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(vertex_zone, [zones_told/2]).
:- use_module('../store',
              [ segment/3, sides/4, lies_in/3, assert_fact/1,
                retractall_facts/1, facts_transaction/1 ]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(error), [existence_error/2, must_be/2]).
:- use_module(library(lists), [member/2]).

/** <module> Regions of space between faces (NG-1).

The faces of a segment, turned any way and with any number at an edge, divide
space. The regions are found by one pass in C (c_kernels/gluing/regions.h):
round an edge what is after a page is before the next one; where parts touch in
a vertex alone, or not at all, exact signs say which of them is inside what.

Of every model that is right two laws hold, with V vertices, E edges, F faces,
L connected parts of their borders, C parts, R regions, S shells of genus G in
all:

    V - E + 2F - L = S - G        S = C + R - 1
*/

%!  regions_made(+S, -Report) is det.
%
%   Write region/3, sides/4 and lies_in/3 of segment S, instead of those that
%   are there; Report is as regions_report/2 has it. Vertices of S in one place
%   become one, so that faces meet there; of flat faces with one border, turned
%   any way, the first stays, with a warning; and a surface becomes a segment of
%   kind `cells`. What lies_in/3 says of a vertex inside a polygon stays. One
%   transaction.
%
%   @error existence_error(segment, S);
%          geometry_error(open_polygon(S, P)),
%          geometry_error(wrong_triangles(S, P)): P is no face

regions_made(S, Report) :-
    facts_transaction(sg_regions:regions_made_now(S, Report)).

%!  regions_found(+S, -Report) is det.
%
%   As regions_made/2, of a segment that has no regions yet, in which what lies
%   in one place is there once; Report has `counts` alone. Call it in a
%   transaction.

regions_found(S, _{counts:Counts}) :-
    with_regions(S, sg_regions:regions_kept(S, counts_of(Counts))).

regions_made_now(S, Report) :-
    segment_there(S),
    retractall_facts(sides(S, _, _, _)),
    retractall_facts(from_r(S, _, _, _)),
    retractall_facts(region(S, _, _)),
    retractall_facts(lies_in(S, _, r(_))),
    complete_segments([S]),
    (   stays_parted(S)
    ->  Doubles = 0
    ;   segment_welded(S, Doubles)
    ),
    (   Doubles =:= 0
    ->  true
    ;   print_message(warning,
                      sanggwan(operand(repaired(duplicate, Doubles), S)))
    ),
    (   segment(S, surface, Name)
    ->  retractall_facts(segment(S, _, _)),
        assert_fact(segment(S, cells, Name))
    ;   true
    ),
    with_regions(S, sg_regions:regions_kept(S, report_of(Report))).

segment_there(S) :-
    must_be(integer, S),
    (   segment(S, _, _)
    ->  true
    ;   existence_error(segment, S)
    ).

:- meta_predicate regions_kept(+, 1, +).

regions_kept(S, Asked, Regions) :-
    regions_written(Regions),
    regions_items(Regions, Wires, Lone),
    forall(member(E-R, Wires), assert_fact(lies_in(S, e(E), r(R)))),
    forall(member(V-R, Lone), assert_fact(lies_in(S, v(V), r(R)))),
    call(Asked, Regions).

:- meta_predicate with_regions(+, 1).

with_regions(S, Goal) :-
    findall(V-P, lies_in(S, v(V), p(P)), Loops),
    (   decision_is_default(disk_relation/3)
    ->  Open = regions_open(S, Loops, Regions)
    ;   zones_told(S, Meetings),
        Open = regions_told(S, Loops, Meetings, Regions)
    ),
    setup_call_cleanup(Open, call(Goal, Regions), regions_close(Regions)).

%!  regions_report(+S, -Report) is det.
%
%   Report is a dict of what the faces of segment S, as they are, make of
%   space: `counts`, `regions` and `neighbours`.
%
%     - counts
%       vertices, edges, faces, loops, parts, regions, shells, genus; twisted:
%       shells that no surface is; dropped: polygons without area; doubtful:
%       parts that lie on faces of others
%     - regions
%       dicts of region, role, faces, shells, genus, wires, vertices (lone),
%       volume and area, of all sides; volume is null if there is none
%     - neighbours
%       dicts of regions ([R1,R2]), faces and area: what they have in common
%
%   @error as regions_made/2

regions_report(S, Report) :-
    segment_there(S),
    with_regions(S, sg_regions:report_of(Report)).

report_of(_{counts:Counts, regions:List, neighbours:Neighbours}, Regions) :-
    counts_of(Counts, Regions),
    regions_listed(Regions, List0),
    numbered(List0, 1, List),
    regions_neighbours(Regions, Neighbours0),
    maplist(neighbours_dict, Neighbours0, Neighbours).

counts_of(_{ vertices:V, edges:E, faces:F, loops:L, parts:C, regions:R,
             shells:Shells, genus:G, twisted:Twisted, dropped:Dropped,
             doubtful:Doubtful }, Regions) :-
    regions_counted(Regions,
                    counts(V, E, F, L, C, R, Shells, G, Twisted, Dropped,
                           Doubtful)).

numbered([], _, []).
numbered([region(Role, F, S, G, W, L, Volume0, Area)|List0], R,
         [ _{ region:R, role:Role, faces:F, shells:S, genus:G, wires:W,
              vertices:L, volume:Volume, area:Area }
         | List]) :-
    (   Role == outside
    ->  Volume = null
    ;   Volume = Volume0
    ),
    R1 is R+1,
    numbered(List0, R1, List).

neighbours_dict(neighbours(R1, R2, Faces, Area),
                _{regions:[R1,R2], faces:Faces, area:Area}).

%!  law_fault(+Report, -Fault, -Count) is nondet.
%
%   True when a Report of regions_report/2 has Count of Fault:
%
%     - broken_law: one of the two laws does not hold, or a shell is no surface
%     - unsure_part: a part lies on a face of another, and is not joined to it

law_fault(Report, broken_law, N) :-
    findall(Law, broken_law(Report.counts, Law), Laws),
    length(Laws, N0),
    N is N0 + Report.counts.twisted,
    N > 0.
law_fault(Report, unsure_part, N) :-
    N = Report.counts.doubtful,
    N > 0.

broken_law(Counts, euler) :-
    Counts.vertices - Counts.edges + 2*Counts.faces - Counts.loops =\=
        Counts.shells - Counts.genus.
broken_law(Counts, parts) :-
    Counts.shells =\= Counts.parts + Counts.regions - 1.

%!  region_neighbour(?S, ?R1, ?R2, ?P) is nondet.
%
%   True when polygon P of segment S lies between the regions R1 and R2, which
%   are different. Needs regions_made/2. In the order of sides/4, of each
%   polygon from below first.

region_neighbour(S, R1, R2, P) :-
    (   var(P),
        integer(R1)
    ->  (   sides(S, P, R1, R2)
        ;   sides(S, P, R2, R1)
        )
    ;   var(P),
        integer(R2)
    ->  (   sides(S, P, R1, R2)
        ;   sides(S, P, R2, R1)
        )
    ;   sides(S, P, Below, Above),
        (   R1 = Below,
            R2 = Above
        ;   R1 = Above,
            R2 = Below
        )
    ),
    R1 \== R2.
