/* A tree that is edited and evaluated again has the boundary that it would have
   if it were evaluated for the first time, but for the ids.

   EVALUATED_CASES=N tries N times as many trees.
*/
:- module(test_evaluated_again, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(library(time)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(penetration/penetration), [penetrate/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/solid/fresh_tree')).
:- use_module(tests('rules/random_solid')).
:- use_module(tests('rules/sample')).

/* - - - random trees - - - */

%   The root 100 is over the nodes 101 and 102 over leaves 1, 2, ..., and over
%   103, leaf 1 once more.

random_tree(Kind, Segments) :-
    random_between(4, 7, N),
    numlist(1, N, Leaves),
    findall(segment(S, solid, Term),
            ( member(S, Leaves), random_leaf(Kind, Term) ),
            Primitives),
    Half is N//2,
    length(First, Half),
    append(First, Second, Leaves),
    append(Primitives,
           [ segment(101, solid, union(First)),
             segment(102, solid, union(Second)),
             segment(103, solid, at([translate(1,0,0)], 1)),
             segment(100, solid, difference([101,102,103]))
           ],
           Segments).

random_leaf(blocks, Primitive) :-
    random_blocks(_, Primitive).
random_leaf(anywhere, Primitive) :-
    random_placed(Primitive).
random_leaf(placed, Primitive) :-
    random_member(Kind, [blocks,anywhere]),
    random_leaf(Kind, Primitive).

/* - - - edits - - - */

leaf(S) :-
    findall(S1, ( segment(S1, _, _), S1 < 90 ), Ss),
    random_member(S, Ss).

edit(shape, Kind) :-
    leaf(S),
    random_leaf(Kind, Term),
    replaced(S, Term).
edit(placement, _) :-
    leaf(S),
    segment(S, _, Term0),
    !,
    random_between(-4, 4, I),
    X is I/2,
    replaced(S, at([translate(X,0,0)], Term0)).
edit(placed_again, _) :-
    random_between(-4, 4, I),
    Y is I/4,
    replaced(103, at([translate(0,Y,0.5)], 1)).
edit(added, Kind) :-
    aggregate_all(max(S), ( segment(S, _, _), S < 90 ), Last),
    S is Last+1,
    random_leaf(Kind, Term),
    tree_world([segment(S, solid, Term)], Other),
    in_world(Other, findall(Fact, row(S, Fact), Facts)),
    assert_fact(segment(S, solid, Term)),
    maplist(assert_fact, Facts),
    random_member(N, [101,102]),
    operation(N, Operation, Children),
    replaced_node(N, Operation, [S|Children]).
edit(removed, _) :-
    random_member(N, [101,102]),
    operation(N, Operation, Children),
    (   Children = [_,_|_]
    ->  random_select(_, Children, Rest),
        replaced_node(N, Operation, Rest)
    ;   true
    ).
edit(resized, _) :-
    leaf(S),
    segment(S, _, Term0),
    !,
    random_member(X, [0.5,1.25,2]),
    replaced(S, at([scale(X,1,1)], Term0)).
edit(turned, _) :-
    random_member(N, [101,102]),
    segment(N, _, Node),
    !,
    replaced(N, at([rotate(z,90)], Node)).
edit(twice, _) :-                       % node 101 once more, elsewhere
    random_between(-4, 4, I),
    Z is I/2,
    replaced(99, at([translate(0.5,0,Z)], 101)),
    replaced_node(100, union, [101,102,103,99]).
edit(operation, _) :-
    random_member(N, [100,101,102]),
    operation(N, _, Children),
    random_member(Operation, [union,intersection,difference]),
    replaced_node(N, Operation, Children).

%   operation(N, Operation, Children): of a node, placed or not.

operation(N, Operation, Children) :-
    segment(N, _, Node0),
    !,
    unplaced(Node0, Node),
    Node =.. [Operation, Children].

unplaced(Node0, Node) :-
    (   Node0 = at(_, Node1)
    ->  unplaced(Node1, Node)
    ;   Node = Node0
    ).

replaced_node(N, Operation, Children) :-
    Term =.. [Operation, Children],
    replaced(N, Term).

row(S, v(S, V, X, Y, Z)) :-
    v(S, V, X, Y, Z).
row(S, e(S, E, A, B, Et)) :-
    e(S, E, A, B, Et).
row(S, p(S, P, Es)) :-
    p(S, P, Es).
row(S, plane(S, P, A, B, C, D)) :-
    plane(S, P, A, B, C, D).
row(S, t(S, P, T, A, B, C)) :-
    t(S, P, T, A, B, C).

%   differs(Seed, Kind, Steps, Done) is semidet: after the edits Done, the last
%   one first, the boundary is another one than in a fresh world.

differs(Seed, Kind, Steps, Done) :-
    set_random(seed(Seed)),
    random_tree(Kind, Segments),
    tree_world(Segments, World),
    in_world(World,
             ( evaluate(100),
               edited(Steps, Kind, [], Done)
             )).

edited(Steps, Kind, Done0, Done) :-
    Steps > 0,
    edits(Kind, Edits),
    random_member(Edit0, Edits),
    done(Edit0, Kind, Done0, Edit),
    Done1 = [Edit|Done0],
    (   is_as_fresh(Kind)
    ->  Steps1 is Steps-1,
        edited(Steps1, Kind, Done1, Done)
    ;   Done = Done1
    ).

%   Where nodes are placed the copies of leaves that this takes have other
%   numbers than in a fresh world, and where faces coincide the one of the least
%   number stays, with its diagonals: then only the places of vertices are the
%   same.

edits(Kind, [ shape, placement, placed_again, added, removed, operation,
              resized, undone, undone_and_redone
            | More ]) :-
    (   Kind == placed
    ->  More = [turned,twice]
    ;   More = []
    ).

%   done(Edit0, Kind, Done, Edit): Edit is Edit0, if there is something to undo.

done(Edit0, Kind, Done, Edit) :-
    (   is_undo(Edit0)
    ->  (   Done = [A,B|_],
            \+ is_undo(A),
            \+ is_undo(B)
        ->  Edit = Edit0,
            undone(Edit)
        ;   done(operation, Kind, Done, Edit)
        )
    ;   Edit = Edit0,
        facts_transaction(test_evaluated_again:once(edit(Edit, Kind)))
    ).

is_undo(undone).
is_undo(undone_and_redone).

undone(undone) :-
    facts_undo,
    facts_undo.
undone(undone_and_redone) :-
    facts_undo,
    facts_undo,
    facts_redo.

is_as_fresh(Kind) :-
    catch(evaluate(100), Error0, true),
    fresh(Other),
    in_world(Other, ( catch(evaluate(100), Error, true),
                      boundary(100, Expected),
                      file_of(100, File) )),
    (   nonvar(Error0)
    ->  same_error(Error0, Error)
    ;   var(Error),
        boundary(100, Boundary),
        (   Kind == placed
        ->  same_places(Boundary, Expected)
        ;   Boundary == Expected,
            file_of(100, File)
        )
    ).

same_error(Error0, Error) :-
    nonvar(Error),
    Error0 = error(Formal0, _),
    Error = error(Formal, _),
    functor(Formal0, Kind, N),
    functor(Formal, Kind, N),
    memberchk(Kind, [geometry_error,model_error]).

same_places(boundary(Vertices1, Polygons1), boundary(Vertices2, Polygons2)) :-
    maplist(arg(1), Vertices1, Places),
    maplist(arg(1), Vertices2, Places),
    same_length(Polygons1, Polygons2).

%   seeds(N, Seeds): of as many trees as are wanted.

seeds(N, Seeds) :-
    (   getenv('EVALUATED_CASES', Text),
        atom_number(Text, Times)
    ->  Last is N*Times
    ;   Last = N
    ),
    numlist(1, Last, Seeds).

faults(Kind, N, Steps, Faults) :-
    seeds(N, Seeds),
    findall(Seed-Done,
            ( member(Seed, Seeds), differs(Seed, Kind, Steps, Done) ),
            Faults).

/* - - - rows that stay, and rows that are missing - - - */

three_boxes(World) :-
    tree_world([ segment(1, solid, box(size(1,1,1))),
                 segment(2, solid, at([translate(0.5,0.25,0.25)],
                                      box(size(1,1,1)))),
                 segment(3, solid, at([translate(5,0,0)], box(size(1,1,1)))),
                 segment(100, solid, union([1,2,3]))
               ],
               World).

%   few_change(Stays, Changed): box 3 moves, so what comes from the others stays
%   as it is, with its ids.

few_change(Stays, Changed) :-
    three_boxes(World),
    in_world(World,
             ( evaluate(100),
               rows_of(1, Rows1), rows_of(3, Rows3),
               replaced(3, at([translate(5,0,0.5)], box(size(1,1,1)))),
               evaluate(100),
               rows_of(1, Again1), rows_of(3, Again3)
             )),
    truth(Rows1 == Again1, Stays),
    truth(Rows3 \== Again3, Changed).

truth(Goal, Truth) :-
    (   Goal
    ->  Truth = true
    ;   Truth = false
    ).

%   rows_of(S0, Rows): those of the result that come from S0, as they are
%   numbered.

rows_of(S0, Rows) :-
    findall(P-Es-Triangles-Vertices,
            ( from_p(100, P, S0, _, _),
              p(100, P, Es),
              findall(t(T, A, B, C), t(100, P, T, A, B, C), Triangles),
              findall(V-v(X, Y, Z),
                      ( member(t(_, A, B, C), Triangles),
                        member(V, [A,B,C]),
                        v(100, V, X, Y, Z) ),
                      Vertices)
            ),
            Rows).

%   Of rows that no stamp tells of.

retract_all_of_one_polygon :-
    once(from_p(100, P, 1, _, _)),
    retractall_facts(plane(100, P, _, _, _, _)),
    once(from_p(100, Other, 2, _, _)),
    retractall_facts(from_p(100, Other, _, _, _)),
    once(origin(100, v(V), _)),
    retractall_facts(origin(100, v(V), _)).

/* - - - lines, and evaluations that are stopped - - - */

%   lines_left(Lines): of a boundary that a penetration did not change (it only
%   touches 4) and that is then evaluated again.

lines_left(Lines) :-
    three_boxes(World),
    in_world(World,
             ( evaluate(100),
               add_primitive(at([translate(5,0,1)], box(size(1,1,1))), S),
               complete_segments,
               segment_stamp(100, Stamp),
               penetrate([100-S], []),
               segment_stamp(100, Stamp),
               on_line(_),
               !,
               replaced(3, at([translate(5,0,-3)], box(size(1,1,1)))),
               evaluate(100),
               findall(L, on_line(L), Lines)
             )).

on_line(L) :-
    line(L, 100, _, _, _, _, _, _, _).
on_line(L) :-
    line(L, _, _, _, _, 100, _, _, _).

%   stopped_anywhere(Seed, Stopped): an evaluation is stopped Stopped times, the
%   later the more often it was; each time all facts are as they were. Then it
%   is as of a fresh world. Another one is stopped by the clock, as often as it
%   is not too quick for that.

stopped_anywhere(Seed, Stopped) :-
    set_random(seed(Seed)),
    random_tree(anywhere, Segments),
    tree_world(Segments, World),
    in_world(World,
             ( evaluate(100),
               stopped_after_edit(inferences, 300, Stopped),
               stopped_after_edit(seconds, 0.002, _)
             )).

stopped_after_edit(By, Limit, Stopped) :-
    facts_transaction(test_evaluated_again:once(edit(shape, anywhere))),
    facts(Facts),
    stopped(By, Limit, Facts, 0, Stopped),
    is_as_fresh(anywhere).

stopped(By, Limit, Facts, N0, N) :-
    (   ends_within(By, Limit, evaluate(100))
    ->  N = N0
    ;   facts(Now),
        Now == Facts,
        More is Limit*1.2,
        N1 is N0+1,
        stopped(By, More, Facts, N1, N)
    ).

ends_within(inferences, Limit, Goal) :-
    Most is round(Limit),
    call_with_inference_limit(Goal, Most, End),
    End \== inference_limit_exceeded.
ends_within(seconds, Limit, Goal) :-
    catch(call_with_time_limit(Limit, Goal), time_limit_exceeded, fail).

facts(Facts) :-
    findall(Fact, fact(Fact), Facts0),
    msort(Facts0, Facts).

fact(segment(S, Kind, Term)) :-
    segment(S, Kind, Term).
fact(Fact) :-
    segment(S, _, _),
    row(S, Fact).
fact(origin(S, Item, Origin)) :-
    origin(S, Item, Origin).
fact(from_v(S, V, S0, V0)) :-
    from_v(S, V, S0, V0).
fact(from_p(S, P, S0, P0, Sense)) :-
    from_p(S, P, S0, P0, Sense).

/* - - - memory - - - */

%   grown(Bytes): by how much 36 evaluations make the process larger, each of a
%   row of spheres one of which was moved, when each was moved three times: it
%   has grown before, as the last two pieces of each are kept. Its boundary has
%   5,000 triangles, with TEST_ALL=1 20,000.

grown(Bytes) :-
    numlist(1, 12, Leaves),
    findall(segment(S, solid, Sphere),
            ( member(S, Leaves), sphere_at(S, 0, Sphere) ),
            Spheres),
    append(Spheres, [segment(100, solid, union(Leaves))], Segments),
    tree_world(Segments, World),
    in_world(World,
             ( facts_undo_limit(2),
               forall(between(1, 36, I), sphere_moved(I)),
               resident(Bytes0),
               forall(between(37, 72, I), sphere_moved(I)),
               resident(Bytes1)
             )),
    Bytes is Bytes1-Bytes0.

sphere_at(S, By, at([translate(X,By,0)],
                    sphere(radius(1), facets(Facets), bands(Bands)))) :-
    few(24, 48, Facets),
    Bands is Facets//2,
    X is S*1.5.

sphere_moved(I) :-
    S is 1 + I mod 12,
    By is I/64,
    sphere_at(S, By, Sphere),
    replaced(S, Sphere),
    evaluate(100).

resident(Bytes) :-
    setup_call_cleanup(open('/proc/self/statm', read, Stream),
                       read_term_from_line(Stream, Pages),
                       close(Stream)),
    Bytes is Pages*4096.

read_term_from_line(Stream, Pages) :-
    read_line_to_string(Stream, Line),
    split_string(Line, " ", "", [_,Text|_]),
    number_string(Pages, Text).

%   Memory is not given back at once where every access is watched.

watched :-
    getenv('LD_PRELOAD', Text),
    sub_atom(Text, _, _, _, san),
    !.
watched :-
    \+ exists_file('/proc/self/statm').

:- begin_tests(evaluated_again).

test(memory, [condition(\+ watched), true(Grown < Most)]) :-
    few(2_000_000, 4_000_000, Most),
    grown(Grown).
test(few_rows_change, [Stays,Changed] == [true,true]) :-
    few_change(Stays, Changed).
test(missing_rows_return, Boundary == Expected) :-
    three_boxes(World),
    in_world(World,
             ( evaluate(100),
               retract_all_of_one_polygon,
               replaced(3, at([translate(5,0,0.5)], box(size(1,1,1)))),
               evaluate(100),
               boundary(100, Boundary),
               fresh(Other)
             )),
    in_world(Other, ( evaluate(100), boundary(100, Expected) )).

%   The box in the middle of a row of three begins at another corner: where
%   faces and vertices are stays as it was; which of its faces they come from
%   does not.

test(other_sources, Boundary == Expected) :-
    tree_world([ segment(1, solid, box(size(1,1,1))),
                 segment(2, solid, prism(outline([[0.5,-0.5],[1.5,-0.5],
                                                  [1.5,0.5],[0.5,0.5]]),
                                         height(1))),
                 segment(3, solid, at([translate(2,0,0)], box(size(1,1,1)))),
                 segment(100, solid, union([1,2,3]))
               ],
               World),
    in_world(World,
             ( evaluate(100),
               replaced(2, prism(outline([[1.5,-0.5],[1.5,0.5],
                                         [0.5,0.5],[0.5,-0.5]]),
                                 height(1))),
               evaluate(100),
               boundary(100, Boundary),
               fresh(Other)
             )),
    in_world(Other, ( evaluate(100), boundary(100, Expected) )).
test(no_old_lines, Lines == []) :-
    lines_left(Lines).
test(stopped, [condition(current_prolog_flag(threads, true)), nondet]) :-
    few(2, 4, Seeds),
    forall(between(1, Seeds, Seed),
           ( stopped_anywhere(Seed, Stopped), Stopped > 9 )).

test(on_a_grid, Faults == []) :-
    faults(blocks, 6, 6, Faults).
test(anywhere, Faults == []) :-
    few(2, 4, Seeds),
    faults(anywhere, Seeds, 6, Faults).
test(placed, Faults == []) :-
    few(2, 4, Seeds),
    faults(placed, Seeds, 6, Faults).

:- end_tests(evaluated_again).
