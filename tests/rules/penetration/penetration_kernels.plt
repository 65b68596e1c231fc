:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(store)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(kernel),
              [ cut_set_open/2, cut_set_close/1, cut_find/1, cut_seal/1,
                cut_polygons/2, cut_joints/3, cut_merge_near/3,
                cut_entering/4, cut_enter_free/4,
                cut_queue/2, cut_enter_queued/2, cut_work/4,
                work_edge/6, work_close/1
              ]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('oracle/cut')).
:- use_module(tests('oracle/near_joints')).

/* The fused kernels of a penetration against their rules: seeded random solids
   on a coarse grid, where most contacts are degenerate, and in between. */

%   with_solids(+Seed, :Goal): Goal holds in a new world with the solids of
%   this seed: of an even one on the grid.

:- meta_predicate with_solids(+, 0).

with_solids(Seed, Goal) :-
    set_random(seed(Seed)),
    N is 2 + Seed mod 3,
    findall(P, ( between(1, N, _), random_solid(Seed, P) ), Ps),
    new_world(World),
    in_world(World,
             ( forall(member(P, Ps), add_primitive(P, _)),
               complete_segments,
               Goal )).

random_solid(Seed, at([Turn, translate(X,Y,Z)], Shape)) :-
    (   Seed mod 2 =:= 0
    ->  findall(K, ( between(1, 3, _), random_between(0, 3, K0), K is K0/2.0 ),
                [X,Y,Z]),
        random_member(Turn, [rotate(z,0), rotate(x,90), rotate(y,180)])
    ;   findall(K, ( between(1, 3, _), random(0.0, 1.5, K) ), [X,Y,Z]),
        random(0.0, 360.0, Angle),
        random_member(Axis, [x,y,z]),
        Turn = rotate(Axis, Angle)
    ),
    findall(I, ( between(1, 3, _), random_between(1, 3, I) ), [A,B,C]),
    random_member(Shape,
                  [ box(size(A,B,C)), pyramid(base(A,B), height(C)),
                    cylinder(radius(A), height(B), facets(4)),
                    cylinder(radius(A), height(B), facets(7)),
                    cone(radius(A), height(C), facets(5)),
                    rectangle(size(A,B))
                  ]).

segment_pairs(Pairs) :-
    findall(S1-S2, ( segment(S1, _, _), segment(S2, _, _), S1 < S2 ), Pairs).

%   found(:Join, -Pieces): the pieces that enter polygons after this join.

:- meta_predicate found(1, -).

found(Join, Pieces) :-
    segment_pairs(Pairs),
    setup_call_cleanup(
        cut_set_open(Pairs, Set),
        ( call(Join, Set),
          cut_seal(Set),
          cut_polygons(Set, Polygons),
          findall(S-P-Ks, ( member(S-P, Polygons),
                            cut_entering(Set, S, P, Ks) ), Pieces)
        ),
        cut_set_close(Set)).

%   entered(-Different, -Free): the polygons in which the kernel enters other
%   edges than the rule, and how many it enters at all. What the rule divides
%   is known to the polygons after it, so all are entered by rule too.

entered(Different, Free) :-
    segment_pairs(Pairs),
    setup_call_cleanup(
        cut_set_open(Pairs, Set),
        ( cut_find(Set),
          cut_seal(Set),
          cut_polygons(Set, Polygons),
          foldl(entered_alike(Set), Polygons, []-0, Different-Free)
        ),
        cut_set_close(Set)).

entered_alike(Set, S-P, Different-Free0, Different1-Free) :-
    work_edges(Set, S-P, cut_enter_free(Set, S, P), Kernel),
    work_edges(Set, S-P, sg_entering:enter_by_rule(Set, S, P), Rule),
    (   Kernel == none
    ->  Different1 = Different,
        Free = Free0
    ;   Free is Free0+1,
        (   Kernel == Rule
        ->  Different1 = Different
        ;   Different1 = [S-P|Different]
        )
    ).

:- meta_predicate work_edges(+, +, 1, -).

work_edges(Set, S-P, Enter, Edges) :-
    cut_work(Set, S, P, Work),
    findall(E, work_row(Work, E), Before),
    (   call(Enter, Work)
    ->  findall(E, work_row(Work, E), Edges)
    ;   findall(E, work_row(Work, E), After),
        After == Before,
        Edges = none
    ),
    work_close(Work).

work_row(Work, V1-V2-Et-Label) :-
    work_edge(Work, _, V1, V2, Et, Label).

%   entered_at_once(-How): `alike` if the polygons that are entered many at a
%   time are those that are entered one by one, up to the first that is not
%   free, with the same edges.

entered_at_once(How) :-
    segment_pairs(Pairs),
    setup_call_cleanup(
        cut_set_open(Pairs, Set),
        ( cut_find(Set),
          cut_seal(Set),
          cut_polygons(Set, Polygons),
          cut_queue(Set, Polygons),
          cut_enter_queued(Set, Works),
          (   same_works(Works, Polygons, Set)
          ->  length(Works, N),
              How = alike(N)
          ;   How = different
          ),
          forall(member(Work, Works), work_close(Work))
        ),
        cut_set_close(Set)).

same_works([Work|Works], [S-P|Polygons], Set) :-
    findall(E, work_row(Work, E), Edges),
    work_edges(Set, S-P, cut_enter_free(Set, S, P), Alone),
    Edges == Alone,
    same_works(Works, Polygons, Set).
same_works([], Rest, Set) :-
    (   Rest = [S-P|_]
    ->  work_edges(Set, S-P, cut_enter_free(Set, S, P), none)
    ;   true
    ).

%   merged_near(+Seed, :Merge, -Edges, -N): the edges of the polygons of turned
%   spheres when N of their nearly straight joints were merged so.

:- meta_predicate merged_near(+, 3, -, -).

merged_near(Seed, Merge, Edges, N) :-
    set_random(seed(Seed)),
    new_world(World),
    in_world(World,
             ( forall(between(1, 3, I), add_sphere(I)),
               complete_segments,
               segment_pairs(Pairs),
               setup_call_cleanup(
                   cut_set_open(Pairs, Set),
                   merged_in(Set, Merge, Edges, N),
                   cut_set_close(Set)) )).

add_sphere(I) :-
    random(0.0, 360.0, Angle),
    random(0.0, 0.3, Y),
    X is 0.7*I,
    add_primitive(at([rotate(axis(1,2,3), Angle), translate(X,Y,0)],
                     sphere(radius(0.6), facets(12), bands(6))), _).

merged_in(Set, Merge, Edges, N) :-
    cut_find(Set),
    cut_seal(Set),
    cut_polygons(Set, Polygons),
    sg_entering:enter_all(Set, Polygons, Works),
    cut_joints(Set, near, Joints),
    call(Merge, Set, Joints, Works),
    cut_joints(Set, near, Left),
    maplist(length, [Joints,Left], [N0,N1]),
    N is N0-N1,
    findall(S-P-Es,
            ( member(work(S, P, Work), Works),
              findall(E, work_row(Work, E), Es) ),
            Edges),
    maplist(sg_entering:close_work, Works).

written_by_rule(Set, Works) :-
    maplist(sg_cut_rows:write_polygon_by_rule(Set), Works).

%   written_by(+Write, -Rows): all that is in the world after this.

written_by(Write, Rows) :-
    segment_pairs(Pairs),
    facts_transaction(
        sg_penetration:with_cut_set(Pairs, 0.0, arranged(Write))),
    findall(Row, ( member(Row, [ v(_, _, _, _, _), e(_, _, _, _, _),
                                 p(_, _, _), t(_, _, _, _, _, _),
                                 origin(_, _, _),
                                 line(_, _, _, _, _, _, _, _, _) ]),
                   call(Row) ),
            Rows).

%   line_shape(-Shape): the chains of line/9 as penetration_chains/1 has them.

line_shape(Shape) :-
    chains(Chains),
    maplist(chain_shape, Chains, Shape).

chain_shape(chain(S1, S2, Kind, Lines), chain(S1, S2, Kind, Points, Ps)) :-
    chain_vertices(Lines, S1, Vs),
    findall(point(X,Y,Z),
            ( member(V, Vs), v(S1, V, X, Y, Z) ), Points),
    findall(P1-P2,
            ( member(Step, Lines),
              L is abs(Step),
              line(L, _, P1, _, _, _, P2, _, _) ), Ps).

without_origins(chain(S1, S2, Kind, Points0, Ps),
                chain(S1, S2, Kind, Points, Ps)) :-
    findall(point(X,Y,Z), member(point(X,Y,Z,_), Points0), Points).

:- begin_tests(penetration_kernels).

test(join, Bad == []) :-
    findall(Seed,
            ( between(1, 200, Seed),
              with_solids(Seed, found(cut_find, Kernel)),
              with_solids(Seed,
                          found(find_cuts_by_rule, Rule)),
              Kernel \== Rule ),
            Bad).

% Entering what meets nothing: the same edges in the same order; most polygons
% of solids in general position are of that sort.
test(enter, Bad-true == []-Enough) :-
    findall(Seed-Different-Free,
            ( between(1, 200, Seed),
              with_solids(Seed, entered(Different, Free)) ),
            All),
    findall(Seed, ( member(Seed-Different-_, All), Different \== [] ), Bad),
    findall(Free, member(_-_-Free, All), Frees),
    sum_list(Frees, Sum),
    (   Sum > 1000
    ->  Enough = true
    ;   Enough = Sum
    ).

test(enter_many, Bad-true == []-Enough) :-
    findall(Seed-How,
            ( between(1, 200, Seed), with_solids(Seed, entered_at_once(How)) ),
            All),
    findall(Seed, member(Seed-different, All), Bad),
    findall(N, member(_-alike(N), All), Ns),
    sum_list(Ns, Sum),
    (   Sum > 300
    ->  Enough = true
    ;   Enough = Sum
    ).

% Joints that are nearly straight: the kernel and the rule leave the same edges.
test(near_joints, Bad-true == []-Enough) :-
    findall(Seed-Kernel-Rule-N,
            ( between(1, 20, Seed),
              merged_near(Seed, cut_merge_near, Kernel, N),
              merged_near(Seed, merge_near_by_rule, Rule, N)
            ),
            All),
    findall(Seed, ( member(Seed-Kernel-Rule-_, All), Kernel \== Rule ), Bad),
    findall(N, member(_-_-_-N, All), Ns),
    sum_list(Ns, Sum),
    (   Sum > 100
    ->  Enough = true
    ;   Enough = Sum
    ).

% Writing a polygon by the kernel, and by the rule: the same rows, in order.
test(write, Bad == []) :-
    findall(Seed,
            ( between(1, 150, Seed),
              with_solids(Seed, written_by(write_polygons, Kernel)),
              with_solids(Seed,
                          written_by(user:written_by_rule, Rule)),
              Kernel \== Rule ),
            Bad).

% Two segments: nothing that enters polygons changes the lines found before.
test(chains_before_and_after, Bad == []) :-
    findall(Seed,
            ( between(1, 66, N),
              Seed is 3*N,
              with_solids(Seed,
                          ( penetration_chains(Chains0),
                            maplist(without_origins, Chains0, Chains),
                            penetrate,
                            line_shape(Shape) )),
              Chains \== Shape ),
            Bad).

% Asking changes nothing; every point has an origin that names its segments.
test(chain_of_a_corner, Kinds-N == [closed]-6) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(2,2,2)), _),
               add_primitive(at([translate(1,1.25,0.75)], box(size(2,2,2))), _),
               complete_segments,
               penetration_chains(Chains),
               \+ line(_, _, _, _, _, _, _, _, _) )),
    findall(K, member(chain(1, 2, K, _, _), Chains), Kinds),
    Chains = [chain(_, _, _, Points, Polygons)],
    length(Polygons, N),
    Points = [First|_],
    last(Points, First),
    forall(member(point(_,_,_,Origin), Points),
           ( Origin =.. [How,S1-_,S2-_], memberchk(How, [lpi,ll]),
             S1 \== S2 )).

% Equal cylinders: four arcs of 20 pieces from branch point to branch point,
% however they are turned; spheres: one closed line.
test(arcs, Shapes == [Arcs,Arcs,Arcs]) :-
    Arcs = [open-20,open-20,open-20,open-20],
    Pipe = cylinder(radius(1), height(4), facets(40)),
    findall(Shape,
            ( member(Turns, [ [], [rotate(x,40),rotate(z,23)],
                              [rotate(y,77),rotate(x,-3)] ]),
              chain_lengths([ at([translate(0,0,-2)|Turns], Pipe),
                              at([translate(0,0,-2),rotate(x,90)|Turns], Pipe)
                            ], Shape) ),
            Shapes).
test(loop, Kinds == [closed]) :-
    Bar = cylinder(radius(1), height(4), facets(40)),
    chain_lengths([ at([translate(0,0,-2)], Bar),
                    at([rotate(x,85),translate(0.3,0.2,1.1)], Bar) ], Shape),
    findall(Kind, member(Kind-_, Shape), Kinds).

chain_lengths(Primitives, Shape) :-
    new_world(World),
    in_world(World,
             ( forall(member(P, Primitives), add_primitive(P, _)),
               complete_segments,
               penetration_chains(Chains) )),
    findall(Kind-N,
            ( member(chain(_, _, Kind, Points, Ps), Chains),
              length(Ps, N),
              length(Points, M),
              M =:= N+1 ),
            Shape).

:- end_tests(penetration_kernels).
