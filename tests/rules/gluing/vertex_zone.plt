/* The zones at vertices: what the rule says of each two disks, and what the
   kernel says of all at once; and what comes of a rule that is wrong. */
:- module(test_vertex_zone, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(decision)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(gluing/vertex_zone)).
:- use_module(rules(kernel)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(store)).
:- use_module(tests(rules/gluing/face_soup)).
:- use_module(tests(rules/gluing/turned_soup)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).
:- use_module(tests(rules/sample), [few/3]).

%   both(Faces, Wires, Kernel, Rule): the counts of a soup, and how its shells
%   are.

both(Faces, Wires, Kernel, Rule) :-
    in_new_world(( made_soup(Faces, Wires),
                   complete_segments([1]),
                   regions_open(1, [], Open),
                   said(Open, Kernel0),
                   zones_told(1, Meetings),
                   regions_told(1, [], Meetings, Told),
                   said(Told, Rule0),
                   Kernel-Rule = Kernel0-Rule0 )).

said(Regions, Counts-List) :-
    regions_counted(Regions, Counts),
    regions_listed(Regions, List),
    regions_close(Regions).

grid_low([X,Y,Z]) :-
    between(0, 1, X),
    between(0, 1, Y),
    between(0, 1, Z).

%   A set of the eight cubes round a vertex.

octants(Set, Lows) :-
    findall(Low, grid_low(Low), All),
    findall(Low, ( nth0(I, All, Low), Set /\ (1<<I) =\= 0 ), Lows).

pyramid(Points, Faces) :-
    Points = [First|Rest],
    append(Rest, [First], Next),
    maplist(side, Points, Next, Faces).

side(A, B, [[[0,0,0],A,B]]).

figure4(Faces, [[[0,0,0],[0,0,-3]]]) :-
    maplist(pyramid, [ [[-4,-1,-1],[-4,1,-1],[-4,1,1],[-4,-1,1]],
                       [[-1,-1,3],[-1,1,3],[1,1,3],[1,-1,3]],
                       [[-4,-4,6],[-4,4,6],[4,4,6],[4,-4,6]] ], Lists),
    append([ [ [[[-4,-1,-1],[-4,-1,1],[-4,1,1],[-4,1,-1]]],
               [[[-1,-1,3],[1,-1,3],[1,1,3],[-1,1,3]]],
               [[[-4,-4,6],[4,-4,6],[4,4,6],[-4,4,6]]] ]
           | Lists ], Faces).

rule_file(Text, Goal) :-
    tmp_file_stream(File, Stream, [encoding(utf8),extension(pl)]),
    format(Stream, "~w.~n", [Text]),
    close(Stream),
    setup_call_cleanup(use_rules(File), Goal, no_rules(File)).

:- meta_predicate rule_file(+, 0).

:- begin_tests(vertex_zone).

test(octants, Wrong == []) :-
    set_random(seed(3)),
    few(5, 1, Each),
    findall(Set,
            ( between(1, 255, Set), Set mod Each =:= 0,
              octants(Set, Lows),
              cubes_faces(Lows, Faces0),
              turned_faces(Faces0, Faces),
              both(Faces, [], Kernel, Rule),
              Kernel \== Rule ),
            Wrong).
test(figure4, Kernel == Rule) :-
    figure4(Faces, Wires),
    both(Faces, Wires, Kernel, Rule).

%   A pyramid that stands in the middle of a face: a point loop.

test(point_loop, Same == true) :-
    pyramid([[-1,-1,3],[-1,1,3],[1,1,3],[1,-1,3]], Faces),
    Plate = [[[-4,-4,0],[4,-4,0],[4,4,0],[-4,4,0]]],
    in_new_world(( made_soup([Plate|Faces], []),
                   vertex_at([0,0,0], V),
                   assert_fact(lies_in(1, v(V), p(1))),
                   complete_segments([1]),
                   regions_open(1, [V-1], Open),
                   said(Open, Kernel),
                   zones_told(1, Meetings),
                   regions_told(1, [V-1], Meetings, Told),
                   said(Told, Rule) )),
    (   Kernel == Rule,
        Meetings = [_]
    ->  Same = true
    ;   Same = Kernel-Rule
    ).

%   With a rule of one's own that is wrong the laws do not hold: of disks whose
%   faces look out. made_soup/2 turns each third face; they are turned before.

looking_out(Faces0, Faces) :-
    findall(Face,
            ( nth1(I, Faces0, Face0),
              (   I mod 3 =:= 0
              ->  maplist(reverse, Face0, Face)
              ;   Face = Face0
              ) ),
            Faces).

test(wrong_rule, Faults = [broken_law-_]) :-
    figure4(Faces0, Wires),
    looking_out(Faces0, Faces),
    in_new_world(( made_soup(Faces, Wires),
                   rule_file("disk_relation(_, _, disjoint)",
                             regions_made(1, Report)) )),
    findall(Fault-N, law_fault(Report, Fault, N), Faults).
test(rule_that_crosses,
     error(geometry_error(part_glue(disks_cross(1, _, 1, 2))))) :-
    figure4(Faces, Wires),
    in_new_world(( made_soup(Faces, Wires),
                   rule_file("disk_relation(_, _, cross)",
                             regions_made(1, _)) )).
test(no_relation, error(type_error(oneof(_), aside))) :-
    figure4(Faces, Wires),
    in_new_world(( made_soup(Faces, Wires),
                   rule_file("disk_relation(_, _, aside)",
                             regions_made(1, _)) )).

:- end_tests(vertex_zone).
