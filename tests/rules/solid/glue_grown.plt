/* A glue whose operands came, went or changed has the rows of the glue of those
   that are, whether only what is near changed or all was made anew.
   covers: cell_added, cell_added_read_rows, cell_added_rows, glue_left
   covers: cell_added_write_rows, region_content, region_content_rows
   covers: regions_joined_rows */
:- module(test_glue_grown, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue), [unglue/1]).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   at_once(Terms, Rows), one_by_one(Terms, Rows, Around): Rows are those of
%   the glue, Around says how often only what was near changed.

glue(99).

at_once(Terms, Rows) :-
    in_new_world(( forall(nth1(S, Terms, Term), operand(S, Term)),
                   length(Terms, N),
                   glued(N),
                   rows(Rows) )).

one_by_one([Term|Terms], Rows, Around) :-
    csg_statistics_reset,
    in_new_world(( operand(1, Term),
                   glued(1),
                   foldl(one_more, Terms, 1, _),
                   rows(Rows) )),
    csg_statistics(Statistics),
    Around = Statistics.around.

one_more(Term, N0, N) :-
    N is N0+1,
    operand(N, Term),
    glued(N).

operand(S, Term0) :-
    (   Term0 = sheet(Term)
    ->  assert_fact(segment(S, surface, Term))
    ;   assert_fact(segment(S, solid, Term0))
    ).

glued(N) :-
    glue(S),
    numlist(1, N, Ss),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, cells, glue(Ss))),
    evaluate(S).

rows(Rows) :-
    glue(S),
    findall(Row, ( row(S, Row), Row \= origin(_, node(_), _) ), Rows0),
    msort(Rows0, Rows).

row(S, Row) :-
    member(Name/Arity,
           [ v/5, e/5, p/3, plane/6, t/6, from_v/4, from_p/5, from_r/4,
             region/3, sides/4, lies_in/3, origin/3, segment/3 ]),
    functor(Row, Name, Arity),
    arg(1, Row, S),
    call(sg_store:Row).

cube(Steps, X-Y-Z, at([translate(X,Y,Z)|Steps], box(size(1,1,1)))).

cubes(N, Steps, Terms) :-
    Most is N-1,
    findall(Term,
            ( between(0, Most, X), between(0, Most, Y), between(0, Most, Z),
              cube(Steps, X-Y-Z, Term) ),
            Terms).

:- begin_tests(glue_grown).

test(rows, [ forall(grown(_, Terms, Around)), Rows-N == AtOnce-Around ]) :-
    one_by_one(Terms, Rows, N),
    at_once(Terms, AtOnce).

%   grown(What, Terms, Around): of the others more than what is near changes.

grown(cubes, Terms, 6) :-
    cubes(2, [], Terms).
grown(turned, Terms, 6) :-
    cubes(2, [rotate(axis(1,2,3),17.3)], Terms).
grown(hole_filled, Terms, 23) :-
    cubes(3, [], Terms0),
    nth1(14, Terms0, Middle, Terms1),
    append(Terms1, [Middle], Terms).
grown(apart, [A,B,C], 1) :-
    maplist(cube([]), [0-0-0,5-0-0,0-5-0], [A,B,C]).
grown(inside, [box(size(9,9,9)),B], 0) :-
    cube([], 1-1-1, B).
grown(round, [B,box(size(9,9,9))], 0) :-
    cube([], 1-1-1, B).
grown(doubled, [A,A], 1) :-
    cube([], 0-0-0, A).
grown(half_a_face, [A,B], 0) :-
    maplist(cube([]), [0-0-0,1-0.5-0], [A,B]).
grown(crossing, [A,B], 0) :-
    maplist(cube([]), [0-0-0,0.5-0.5-0.5], [A,B]).
grown(edge, [A,B], 1) :-
    maplist(cube([]), [8-8-8,9-9-8], [A,B]).
grown(vertex, [A,B], 1) :-
    maplist(cube([]), [8-8-8,9-9-9], [A,B]).
grown(tolerance, [A,B], 0) :-
    maplist(cube([]), [0-0-0,1-1-0], [A,B]).
grown(ring_closed, Terms, 7) :-
    findall(Cube,
            ( member(X-Y, [0-0,1-0,2-0,2-1,2-2,1-2,0-2,0-1]),
              X1 is X+8, cube([], X1-Y-0, Cube) ),
            Terms).

%   The same with a tolerance of its own, which stays.

test(own_tolerance, Rows-N == AtOnce-7) :-
    cubes(2, [], Terms),
    csg_statistics_reset,
    in_new_world(( own_tolerance,
                   append([First], Others, Terms),
                   operand(1, First),
                   glued(1),
                   foldl(one_more, Others, 1, _),
                   rows(Rows) )),
    csg_statistics(Statistics),
    N = Statistics.around,
    in_new_world(( own_tolerance,
                   forall(nth1(S, Terms, Term), operand(S, Term)),
                   glued(8),
                   rows(AtOnce) )).

own_tolerance :-
    glue(S),
    assert_fact(gluing(S, tolerance(0.01))).

test(permuted, Different-Few == []-false) :-
    cubes(3, [], Terms),
    findall(Seed-N,
            ( between(1, 5, Seed), set_random(seed(Seed)),
              random_permutation(Terms, Some),
              one_by_one(Some, Rows, N0), at_once(Some, AtOnce),
              (   Rows == AtOnce -> N = N0 ; N = different ) ),
            Pairs),
    findall(Seed, member(Seed-different, Pairs), Different),
    aggregate_all(min(N), member(_-N, Pairs), Least),
    (   number(Least), Least > 15 -> Few = false ; Few = Least ).

%   Operands come, go and change: but for ids, and the numbers of regions that
%   follow from these, the rows are those of the glue made at once.

test(steps, [ forall(steps(_, Steps, Around)), Found == same-Around ]) :-
    steps_compared(Steps, Found).
test(last, Rows-Around == AtOnce-3) :-
    cubes(2, [], Terms),
    append(Five, [_,A,B], Terms),
    !,
    append(Five, [A,B], Now),
    in_new_world(( forall(nth1(S, Terms, Term), operand(S, Term)),
                   glued(8),
                   csg_statistics_reset,
                   forall(member(N, [7,6]), glued(N)),
                   forall(nth1(I, [A,B], Term),
                          ( S is I+5,
                            retractall_facts(segment(S, _, _)),
                            operand(S, Term) )),
                   glued(7),
                   csg_statistics(Statistics),
                   rows(Rows) )),
    Around = Statistics.around,
    at_once(Now, AtOnce).
%   Where an operand goes, its polygons that others have keep their numbers, and
%   so do the regions round it.

test(numbers_stay, Now == Before) :-
    cubes(3, [], Terms),
    numlist(1, 27, Ss),
    selectchk(14, Ss, Others),
    in_new_world(( maplist(operand, Ss, Terms),
                   glued_of(Ss),
                   findall(P-Above, ( from_p(99, P, 14, _, _),
                                      cell_beyond(P, 14, Above) ), Before),
                   glued_of(Others),
                   findall(P-Above, ( member(P-_, Before),
                                      from_p(99, P, N, _, _),
                                      cell_beyond(P, -1, Above),
                                      from_r(99, Above, N, 1) ), Now) )).
%   An operand of which a vertex was moved, in its rows.

test(edited, Rows-Around == AtOnce-1) :-
    edited(true, Rows, Around),
    edited(unglue(99), AtOnce, 0).
test(random, Different-Enough == []-true) :-
    findall(What-N,
            ( between(1, 15, Seed),
              random_steps(Seed, Steps),
              steps_compared(Steps, What-N) ),
            Found),
    findall(What, ( member(What-_, Found), What \== same ), Different),
    aggregate_all(sum(N), member(_-N, Found), Around),
    (   Around > 40
    ->  Enough = true
    ;   Enough = Around
    ).

:- end_tests(glue_grown).

%   cell_beyond(P, S, R): R is a region beside polygon P, of another operand
%   than S.

cell_beyond(P, S, R) :-
    sides(99, P, R1, R2),
    member(R, [R1,R2]),
    once(( from_r(99, R, S1, _), S1 =\= S )).

%   edited(Before, Rows, Around): of cubes, after a vertex was moved and
%   call(Before).

edited(Before, Rows, Around) :-
    cubes(2, [], Terms),
    numlist(1, 8, Ss),
    in_new_world(( maplist(operand, Ss, Terms),
                   glued_of(Ss),
                   once(( v(5, V, X, Y, Z), X > 1, Y < 0, Z =:= 0 )),
                   X1 is X+0.25,
                   facts_transaction(( retractall_facts(v(5, V, _, _, _)),
                                       assert_fact(v(5, V, X1, Y, Z)) )),
                   call(Before),
                   csg_statistics_reset,
                   glued_of(Ss),
                   csg_statistics(Statistics),
                   canonical_rows(Rows) )),
    Around = Statistics.around.

%   steps(What, Steps, Around): add(S, Term), also of one that is there, or
%   gone(S). At first the glue is of segments 1 and 2, far from all.

steps(middle_goes, Steps, 1) :-
    cubes(3, [], Terms),
    all_at_once(Terms, Steps, [gone(16)]).
steps(corner_goes, Steps, 1) :-
    cubes(2, [], Terms),
    all_at_once(Terms, Steps, [gone(3)]).
steps(middle_moves, Steps, 2) :-
    cubes(3, [rotate(axis(1,2,3),17.3)], Terms),
    nth1(14, Terms, Middle),
    nth1(2, Terms, Other),
    all_at_once(Terms, Steps, [add(16, Other),add(16, Middle)]).
steps(moves, Steps, 1) :-
    cubes(2, [], Terms),
    cube([], 2-0-0, Beside),
    all_at_once(Terms, Steps, [add(3, Beside)]).
steps(of_two, [all([add(3, A),add(4, A)]),gone(3)], 1) :-
    cube([], 0-0-0, A).
steps(inside_goes, [all([add(3, box(size(9,9,9))),add(4, B)]),gone(4)], 1) :-
    cube([], 1-1-1, B).
steps(round_goes, [all([add(3, box(size(9,9,9))),add(4, B)]),gone(3)], 1) :-
    cube([], 1-1-1, B).
steps(half_a_face, [all([add(3, A),add(4, B)]),gone(4)], 0) :-
    maplist(cube([]), [0-0-0,1-0.5-0], [A,B]).
steps(half_an_edge, [all([add(3, A),add(4, B)]),gone(4)], 0) :-
    maplist(cube([]), [0-0-0,1-1-0.5], [A,B]).
steps(parts_of_a_plane, [all([add(3, Prism),add(4, B)]),gone(4)], 0) :-
    halved_prism(Prism),
    cube([], 0-1-0, B).
steps(parts_of_a_line, [all([add(3, Prism),add(4, B)]),gone(4)], 0) :-
    halved_prism(Prism),
    cube([], 0-1-1, B).
steps(on_a_plate, [all([add(3, box(size(9,9,1))),add(4, B)]),gone(4)], 0) :-
    cube([], 0-0-1, B).
steps(crossing, [all([add(3, A),add(4, B)]),gone(4)], 0) :-
    maplist(cube([]), [0-0-0,0.5-0.5-0.5], [A,B]).
steps(sheet_between, [all([add(3, A),add(4, sheet(Sheet)),add(5, B)]),gone(3),
                      gone(4)], 2) :-
    Sheet = at([translate(0,0,1)], rectangle(size(1,1))),
    maplist(cube([]), [0-0-0,0-0-1], [A,B]).
steps(sheet_in_two, [all([add(3, box(size(2,1,1))),
                          add(4, sheet(Sheet))]),gone(4)], 0) :-
    Sheet = at([rotate(y,90),translate(-0.5,0,0)], rectangle(size(1,1))).
steps(sheets_apart, [all([add(3, A),add(4, sheet(Sheet))]),gone(4)], 1) :-
    Sheet = at([translate(0,0,9)], rectangle(size(1,1))),
    cube([], 0-0-0, A).
steps(cut_elsewhere, [ all([add(3, A),add(4, Across),add(5, sheet(Sheet)),
                            add(6, B)]),
                       add(7, C),gone(6),add(6, D),gone(4)], 3) :-
    maplist(cube([]), [0-0-0,0.3-0.4-0.6,6-0-0,7-0-0,7-1-0],
            [A,Across,B,C,D]),
    Sheet = at([rotate(x,90),translate(0,0,1)], rectangle(size(1,3))).
steps(cut_beside, [all([add(3, A),add(4, Across)]),add(5, B)], 0) :-
    maplist(cube([]), [0-0-0,0.3-0.4-0.6,-1-0-0], [A,Across,B]).
steps(several, Steps, 1) :-
    cubes(3, [], Terms),
    all_at_once(Terms, Steps, [ several([gone(16),gone(5),gone(20)]) ]).

%   halved_prism(Prism): two of its sides lie in two parts in one plane.

halved_prism(prism(outline([[-0.5,-0.5],[0.5,-0.5],[1.5,-0.5],[1.5,0.5],
                            [0.5,0.5],[-0.5,0.5]]),
                   height(1))).

all_at_once(Terms, [all(Adds)|Steps], Steps) :-
    findall(add(S, Term), ( nth1(I, Terms, Term), S is I+2 ), Adds).

%   steps_compared(Steps, What-Around): What is `same`, or the first step after
%   which the rows differ.

steps_compared(Steps, What-Around) :-
    maplist(cube([]), [100-0-0,-100-0-0], [A,B]),
    in_new_world(( operand(1, A),
                   operand(2, B),
                   glued_of([1,2]),
                   steps_done(Steps, 1, [1-A,2-B], 0, What, Around) )).

steps_done([], _, _, Around, same, Around).
steps_done([Step|Steps], I, Operands0, Around0, What, Around) :-
    csg_statistics_reset,
    step_done(Step, Operands0, Operands),
    pairs_keys_values(Operands, Ss, Terms),
    glued_of(Ss),
    csg_statistics(Statistics),
    Around1 is Around0+Statistics.around,
    canonical_rows(Rows),
    numbers_right(Right),
    in_new_world(( maplist(operand, Ss, Terms),
                   glued_of(Ss),
                   canonical_rows(AtOnce) )),
    (   Rows \== AtOnce
    ->  What = rows(I, Step),
        Around = Around1
    ;   Right == false
    ->  What = numbers(I, Step),
        Around = Around1
    ;   I1 is I+1,
        steps_done(Steps, I1, Operands, Around1, What, Around)
    ).

step_done(all(Steps), Operands0, Operands) :-
    foldl(step_done, Steps, Operands0, Operands).
step_done(several(Steps), Operands0, Operands) :-
    foldl(step_done, Steps, Operands0, Operands).
step_done(gone(S), Operands0, Operands) :-
    retractall_facts(segment(S, _, _)),
    selectchk(S-_, Operands0, Operands).
step_done(add(S, Term), Operands0, Operands) :-
    (   selectchk(S-_, Operands0, Operands1)
    ->  retractall_facts(segment(S, _, _))
    ;   Operands1 = Operands0
    ),
    operand(S, Term),
    sort([S-Term|Operands1], Operands).

glued_of(Ss) :-
    glue(S),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, cells, glue(Ss))),
    evaluate(S).

%   canonical_rows(Rows): a vertex is where it is, a polygon its edges, a region
%   what bounds it.

canonical_rows(rows(Polygons, Regions, Vertices, Others)) :-
    glue(S),
    findall(polygon(Edges, Triangles, Planes, Sources),
            polygon_row(S, Edges, Triangles, Planes, Sources), Polygons0),
    msort(Polygons0, Polygons),
    findall(region(Role, Insides, Faces), region_row(S, Role, Insides, Faces),
            Regions0),
    msort(Regions0, Regions),
    findall(vertex(Place, Sources),
            ( vertex_place(S, V, Place),
              findall(S0-V0, from_v(S, V, S0, V0), Sources) ),
            Vertices0),
    msort(Vertices0, Vertices),
    findall(Other,
            ( member(Row, [lies_in(S,_,_),segment(S,_,_),origin(S,_,_)]),
              call(sg_store:Row),
              Row \= origin(_, node(_), _),
              placed_row(Row, Other) ),
            Others0),
    msort(Others0, Others).

placed_row(origin(S,v(V),Origin), origin(Place,Origin)) :-
    !,
    vertex_place(S, V, Place).
placed_row(Row, Row).

vertex_place(S, V, p(X,Y,Z)) :-
    v(S, V, X, Y, Z).

polygon_row(S, Edges, Triangles, Planes, Sources) :-
    p(S, P, _),
    polygon_edges(S, P, Edges),
    findall(Triangle,
            ( t(S, P, _, A, B, C),
              maplist(vertex_place(S), [A,B,C], [PA,PB,PC]),
              msort([t(PA,PB,PC),t(PB,PC,PA),t(PC,PA,PB)], [Triangle|_]) ),
            Triangles0),
    msort(Triangles0, Triangles),
    findall(plane(X,Y,Z,D), plane(S, P, X, Y, Z, D), Planes),
    findall(from(S0,P0,Sense), from_p(S, P, S0, P0, Sense), Sources0),
    msort(Sources0, Sources).

polygon_edges(S, P, Edges) :-
    p(S, P, Es),
    findall(edge(PV,PW,Et),
            ( member(E, Es), e(S, E, V, W, Et),
              maplist(vertex_place(S), [V,W], [PV,PW]) ),
            Edges0),
    msort(Edges0, Edges).

region_row(S, Role, Insides, Faces) :-
    region(S, R, Role),
    findall(S0-R0, from_r(S, R, S0, R0), Insides0),
    msort(Insides0, Insides),
    findall(Side-Edges,
            ( (   sides(S, P, R, _), Side = below
              ;   sides(S, P, _, R), Side = above
              ),
              polygon_edges(S, P, Edges) ),
            Faces0),
    msort(Faces0, Faces).

%   numbers_right(Right): regions have the numbers that they get when they are
%   found again.

numbers_right(Right) :-
    glue(S),
    findall(P-Below-Above, sides(S, P, Below, Above), Sides),
    facts_snapshot(( regions_made(S, _),
                     findall(P-Below-Above, sides(S, P, Below, Above),
                             Again) )),
    msort(Sides, Sorted),
    msort(Again, SortedAgain),
    (   Sorted == SortedAgain -> Right = true ; Right = false ).

%   random_steps(Seed, Steps): cubes of a grid, and some that fit less; beside
%   it cubes that go through each other.

random_steps(Seed, Steps) :-
    set_random(seed(Seed)),
    cubes(2, [], Terms),
    (   Seed mod 3 =:= 0
    ->  Adds = [all([])]
    ;   all_at_once(Terms, Adds, [])
    ),
    findall(Step, ( between(1, 10, _), random_step(Step) ), Tries),
    foldl(possible_step, Tries, Adds-[], _-Rest),
    reverse(Rest, Later),
    append(Adds, Later, Steps).

random_step(Step) :-
    random_between(3, 12, S),
    random_between(0, 3, Kind),
    (   Kind =:= 0
    ->  Step = gone(S)
    ;   maybe(0.2)
    ->  maplist(random_between(0, 3), [X,Y,Z]),
        X1 is 10+X/2.0,
        Y1 is Y/2.0,
        Z1 is Z/2.0,
        Step = add(S, at([translate(X1,Y1,Z1)], box(size(1,1,1))))
    ;   maplist(random_between(0, 2), [X,Y,Z]),
        (   maybe(0.95)
        ->  Size = 1
        ;   Size = 2
        ),
        Step = add(S, at([translate(X,Y,Z)], box(size(Size,Size,Size))))
    ).

%   possible_step(Step, Before-Later0, Before-Later): only what is there goes.

possible_step(gone(S), Before-Later, Before-Next) :-
    !,
    (   append(Later, Before, All),
        member(Step, All),
        ( Step = gone(S)
        ; Step = add(S, _)
        ; Step = all(Adds), memberchk(add(S, _), Adds)
        )
    ->  (   Step = gone(S)
        ->  Next = Later
        ;   Next = [gone(S)|Later]
        )
    ;   Next = Later
    ).
possible_step(Step, Before-Later, Before-[Step|Later]).

