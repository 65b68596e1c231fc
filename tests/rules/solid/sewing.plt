:- module(test_sewing, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(kernel), [cut_candidate/3, segment_sewn/2]).
:- use_module(rules(model/mesh), [read_mesh/2]).
:- use_module(rules(penetration/penetration), [leaf_lines/4]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case'), [measured/2, result/2]).
:- use_module(tests('rules/checked'), [write_off/3]).
:- use_module(tests('rules/sample'), [few/3,numbered/3]).
:- use_module(tests('rules/solid/grown'), [grown/4, shells_solid/3]).

/* Shells of one file that touch exactly: what they are sewn into goes round
   the same, needs no cut where they only touch, and equal polygons are cut
   once. */

%   read(+Points, +Faces, :Goal): in a new world, as segment 1.

:- meta_predicate read(+, +, 0).

read(Points, Faces, Goal) :-
    tmp_file_stream(File, Stream, [extension(off)]),
    close(Stream),
    new_world(World),
    call_cleanup(
        in_world(World,
                 ( write_off(File, Points, Faces),
                   read_mesh(File, [1]),
                   complete_segments,
                   Goal )),
        delete_file(File)).

family(Family, N, Goal) :-
    once(grown(Family, N, Shells, _)),
    shells_solid(Shells, Points, Faces),
    read(Points, Faces, Goal).

%   sixfold(+Weights, -Six): six times the volume of segment 1 as rationals.

sixfold(Weights, Six) :-
    aggregate_all(sum(D),
                  ( t(1, P, _, A, B, C),
                    maplist(place, [A,B,C], [X,Y,Z]),
                    determinant(X, Y, Z, D0),
                    (   memberchk(P-W, Weights)
                    ->  D is W*D0
                    ;   D = D0
                    ) ),
                  Six).

place(V, p(X,Y,Z)) :-
    v(1, V, X0, Y0, Z0),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

determinant(p(A,B,C), p(D,E,F), p(G,H,I), S) :-
    S is A*(E*I-F*H) - B*(D*I-F*G) + C*(D*H-E*G).

%   defects(-Defects): what no segment may be, once it is sewn.

defects(Defects) :-
    findall(Defect, defect(Defect), Defects0),
    sort(Defects0, Defects).

defect(two_in_one_place(X,Y,Z)) :-
    findall(p(X,Y,Z)-V, ( t(1, _, _, A, B, C), member(V, [A,B,C]),
                          v(1, V, X, Y, Z) ), Places0),
    sort(Places0, Places),
    append(_, [p(X,Y,Z)-_,p(X,Y,Z)-_|_], Places).
defect(same(P, Q)) :-
    p(1, P, _),
    outline(P, Outline),
    p(1, Q, _),
    P < Q,
    outline(Q, Outline),
    setof(T, triangle(P, T), Ts),
    setof(T, triangle(Q, T), Ts).
defect(edge_of_none(E)) :-
    e(1, E, _, _, _),
    \+ ( p(1, _, Es), memberchk(E, Es) ).
defect(triangle_of_none(T)) :-
    t(1, P, T, _, _, _),
    \+ p(1, P, _).

outline(P, Outline) :-
    p(1, P, Es),
    findall(A-B, ( member(E, Es), e(1, E, V, W, _), msort([V,W], [A,B]) ),
            Outline0),
    msort(Outline0, Outline).

triangle(P, T) :-
    t(1, P, _, A, B, C),
    msort([A,B,C], T).

%   found(+Family, +N, -Found): how many polygons lines run in, how many pairs
%   of triangles are looked at, and the weights.

found(Family, N, found(Polygons, Pairs, Weights)) :-
    family(Family, N,
           facts_snapshot(
               test_sewing:( leaf_lines([1-1], [1], own(0.0),
                                        test_sewing:counted(Polygons, Pairs,
                                                            Weights)) ))).

counted(Polygons, Pairs, Weights, Set, List, Weights) :-
    length(List, Polygons),
    aggregate_all(count, cut_candidate(Set, _, _), Pairs).

/* - - - boxes on a grid - - - */

%   random_boxes(+Seed, -Boxes): box(X0,Y0,Z0,X1,Y1,Z1)-Way, some again and
%   again, some turned inside out.

random_boxes(Seed, [Box-1|Boxes]) :-
    set_random(seed(Seed)),
    random_between(1, 6, N),
    random_box(Box),
    length(Boxes, N),
    foldl(next_box, Boxes, [Box], _).

next_box(Box-Way, Known, [Box|Known]) :-
    (   maybe(0.5)
    ->  random_member(Box, Known)
    ;   random_box(Box)
    ),
    (   maybe(0.2)
    ->  Way = -1
    ;   Way = 1
    ).

random_box(box(X0,Y0,Z0,X1,Y1,Z1)) :-
    maplist([A,B]>>( random_between(0, 2, A), random_between(1, 2, L),
                     B is A+L ),
            [X0,Y0,Z0], [X1,Y1,Z1]).

%   boxes_mesh(+Boxes, -Points, -Faces): faces begin anywhere and come in any
%   order.

boxes_mesh(Boxes, Points, Faces) :-
    foldl(box_shell, Boxes, Shells, 0, _),
    pairs_keys_values(Shells, Lists, FaceLists),
    append(Lists, Points),
    append(FaceLists, Faces0),
    random_permutation(Faces0, Faces).

box_shell(box(X0,Y0,Z0,X1,Y1,Z1)-Way, Points-Faces, From, To) :-
    To is From+8,
    findall(p(X,Y,Z),
            ( member(Z, [Z0,Z1]), member(Y, [Y0,Y1]), member(X, [X0,X1]) ),
            Points),
    maplist(box_face(From, Way),
            [[1,3,4,2], [5,6,8,7], [1,2,6,5], [3,7,8,4], [1,5,7,3],
             [2,4,8,6]],
            Faces).

box_face(From, Way, Face0, Face) :-
    random_between(0, 3, K),
    length(Front, K),
    append(Front, Back, Face0),
    append(Back, Front, Face1),
    (   Way < 0
    ->  reverse(Face1, Face2)
    ;   Face2 = Face1
    ),
    maplist(plus(From), Face2, Face).

%   cubes(+Boxes, -Cubes): how many unit cubes they go round at least once.

cubes(Boxes, Cubes) :-
    aggregate_all(count,
                  ( between(0, 4, X), between(0, 4, Y), between(0, 4, Z),
                    aggregate_all(sum(Way),
                                  ( member(Box-Way, Boxes),
                                    has(Box, X, Y, Z) ),
                                  Turns),
                    Turns >= 1 ),
                  Cubes).

has(box(X0,Y0,Z0,X1,Y1,Z1), X, Y, Z) :-
    X0 =< X, X < X1, Y0 =< Y, Y < Y1, Z0 =< Z, Z < Z1.

%   wrong(+Seed, -What): of the union of random boxes in one file.

wrong(Seed, What) :-
    random_boxes(Seed, Boxes),
    boxes_mesh(Boxes, Points, Faces),
    cubes(Boxes, Cubes),
    read(Points, Faces, ( sixfold([], Six),
                          Six > 0,
                          result(union([1]), S),
                          measured([S], [Measures]) )),
    (   What = volume(Measures.volume, Cubes),
        abs(Measures.volume-Cubes) > 1.0e-9
    ;   member(Key, [closed,good]),
        get_dict(Key, Measures, no),
        What = not(Key)
    ).

:- begin_tests(sewing).

test(identical, Weights-Left == [1-7,2-7,3-7,4-7,5-7,6-7]-6) :-
    family(identical, 7,
           facts_snapshot(( segment_sewn(1, Weights),
                            aggregate_all(count, p(1, _, _), Left),
                            defects([]) ))).
test(stack, Weights-Left == []-22) :-
    family(stack, 5,
           facts_snapshot(( segment_sewn(1, Weights),
                            aggregate_all(count, p(1, _, _), Left),
                            defects([]) ))).
test(as_it_was, Before == After) :-
    family(identical, 3,
           ( findall(T, ( t(1, A, B, C, D, E), T = t(A,B,C,D,E) ), Before),
             facts_snapshot(segment_sewn(1, _)),
             findall(T, ( t(1, A, B, C, D, E), T = t(A,B,C,D,E) ), After) )).
test(nothing_to_sew, [forall(member(Family, [apart,row,comb,needles])),
                      fail]) :-
    family(Family, 20, facts_snapshot(segment_sewn(1, _))).
test(goes_round, [forall(numbered(20, 60, Seed)), all(_ == [])]) :-
    random_boxes(Seed, Boxes),
    boxes_mesh(Boxes, Points, Faces),
    read(Points, Faces,
         ( sixfold([], Six0),
           facts_snapshot(( ( segment_sewn(1, Weights)
                            ->  true
                            ;   Weights = []
                            ),
                            sixfold(Weights, Six),
                            defects(Defects) )) )),
    \+ ( Six0 =:= Six, Defects == [] ).
%   Shells that only touch need no cut, and neighbours alone are looked at.
test(no_cuts, [forall(member(Family, [wedges,identical,stack])),
               Polygons == 0]) :-
    found(Family, 20, found(Polygons, _, _)).
%   n log n: 2.3 times as many for twice as many.
test(pairs, [forall(member(Family, [identical,stack,wedges])),
             true(N2 =< 2.3*N1)]) :-
    found(Family, 100, found(_, N1, _)),
    found(Family, 200, found(_, N2, _)).
test(united, [forall(( few(40, 400, N), between(1, N, Seed) )),
              all(What == [])]) :-
    wrong(Seed, What).

:- end_tests(sewing).
