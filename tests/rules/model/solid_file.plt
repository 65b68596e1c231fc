:- encoding(utf8).
:- module(test_solid_file, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(command/check)).
:- use_module(rules(kernel),
              [boundary_open/7, boundary_counts/2, boundary_close/1]).
:- use_module(rules(model/mesh)).
:- use_module(rules(model/model)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(model/solid_file)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('rules/checked')).
:- use_module(tests('rules/random_shape')).

/* Solids to files: every file is read back by the engine, and by the checker
that shares nothing with it. */

:- meta_predicate with_file(+, -, 0).

with_file(Ending, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Stream, [extension(Ending)]),
          close(Stream)
        ),
        once(Goal),
        delete_file(File)).

%   read_back(+File, -V, -P, -Faults, -Volume): of the first segment.

read_back(File, V, P, Faults, Volume) :-
    in_new_world(( load_model(File), check_report(R) )),
    [S] = R.segments,
    V = S.vertices,
    P = S.polygons,
    Volume = S.volume,
    report_faults(R, Faults).

%   good(+File, +Options): the checker says so; it reads OFF and binary STL.

good(File, Options) :-
    checked(Options, [File], [Result]),
    (   Result.good == yes
    ->  true
    ;   format("~w: ~p~n", [File,Result]),
        fail
    ).

%   joined(+Solids, -S): the boundaries of some prisms or boxes as one segment.

joined(Parts, 1) :-
    foldl(behind, Parts, []-[], Points-Faces),
    polyhedron(1, solid, Points, Faces).

behind(Points1-Faces1, Points0-Faces0, Points-Faces) :-
    length(Points0, N),
    maplist(maplist(plus(N)), Faces1, Moved),
    append(Points0, Points1, Points),
    append(Faces0, Moved, Faces).

box(Low, High, Points-Faces) :-
    box_points(Low, High, Points),
    box_faces(Faces).

scaled(K, Points0-Faces, Points-Faces) :-
    maplist(scaled_point(K), Points0, Points).

scaled_point(K, p(X0,Y0,Z0), p(X,Y,Z)) :-
    X is K*X0,
    Y is K*Y0,
    Z is K*Z0.

inside_out(Points-Faces0, Points-Faces) :-
    maplist(reverse, Faces0, Faces).

mesh_format(stl, []).
mesh_format(stl, [binary(false)]).
mesh_format(off, []).
mesh_format(obj, []).
mesh_format(ply, []).
mesh_format(ply, [binary(true)]).

%   model(?Name, -Parts, -Volume)

model(box, [B], 24) :-
    box(p(0,0,0), p(2,3,4), B).
model(touch_in_a_point, [A,B], 2) :-
    box(p(0,0,0), p(1,1,1), A),
    box(p(1,1,1), p(2,2,2), B).
model(touch_in_an_edge, [A,B], 2) :-
    box(p(0,0,0), p(1,1,1), A),
    box(p(1,1,0), p(2,2,1), B).
model(touch_all_round, [A,B,C], 3) :-
    box(p(0,0,0), p(1,1,1), A),
    box(p(1,1,0), p(2,2,1), B),
    box(p(0,1,1), p(1,2,2), C).
model(shells, [A,C,D], V) :-
    box(p(0,0,0), p(9,9,9), A),
    box(p(1,1,1), p(8,8,8), B),
    inside_out(B, C),
    box(p(2,2,2), p(3,3,3), D),
    V is 729-343+1.
model(small, [C], 6.0e-24) :-
    box(p(0,0,0), p(1,2,3), B),
    scaled(1.0e-8, B, C).
model(large, [C], 6.0e15) :-
    box(p(0,0,0), p(1,2,3), B),
    scaled(1.0e5, B, C).
model(prism, [Points-Faces], _) :-
    prism(17, 1, 2, Points, Faces).
model(small_prism, [C], _) :-
    prism(7, 1, 2, Points, Faces),
    scaled(1.0e-8, Points-Faces, C).
model(large_prism, [C], _) :-
    prism(7, 1, 2, Points, Faces),
    scaled(1.0e5, Points-Faces, C).
% Thinner than float32 can say: in STL one side lies on the other.
model(wedge, [Points-Faces, B], _) :-
    Points = [p(3,0,5), p(4,0,5), p(4,1,5), p(3,1,5),
              p(4,0,5.000000001), p(4,1,5.000000001)],
    Faces = [[1,4,3,2], [1,2,5], [3,4,6], [2,3,6,5], [4,1,5,6]],
    box(p(0,0,0), p(1,1,1), B).
model(needle, [Points-Faces, B], _) :-
    Points = [p(2,0.1,0.1), p(2,0.1000000000001,0.1), p(2,0.1,0.1000000000001),
              p(3,0.1,0.1)],
    Faces = [[1,3,2], [1,2,4], [2,3,4], [3,1,4]],
    box(p(0,0,0), p(1,1,1), B).

:- begin_tests(solid_file).

test(read_back, forall(( model(Name, Parts, Volume),
                         mesh_format(Ending, Options) ))) :-
    with_file(Ending, File,
              ( in_new_world(( joined(Parts, S),
                               write_solid(File, S, Options) )),
                read_back(File, _, _, Faults, V) )),
    ( Faults == 0 -> true ; format("~w ~w~n", [Name,Ending]), fail ),
    (   var(Volume)
    ->  true
    ;   abs(V-Volume) =< 1.0e-6*Volume
    ).
test(checker_stl, forall(model(_, Parts, _))) :-
    with_file(stl, File,
              ( in_new_world(( joined(Parts, S), write_solid(File, S) )),
                good(File, []) )).
test(checker_off, forall(model(_, Parts, _))) :-
    with_file(off, File,
              ( in_new_world(( joined(Parts, S), write_solid(File, S) )),
                good(File, ['-i']) )).
test(polygons_stay, V-P == 34-19) :-
    model(prism, Parts, _),
    with_file(off, File,
              ( in_new_world(( joined(Parts, S), write_solid(File, S) )),
                read_back(File, V, P, _, _) )).
test(copies, V == 16) :-
    model(touch_in_an_edge, Parts, _),
    with_file(off, File,
              ( in_new_world(( joined(Parts, S), write_solid(File, S) )),
                read_back(File, V, _, 0, _) )).
test(shared, V == 14) :-
    model(touch_in_an_edge, Parts, _),
    with_file(ply, File,
              ( in_new_world(( joined(Parts, S),
                               write_solid(File, S, [shared(true)]) )),
                read_back(File, V, _, 0, _) )).
test(model_file_keeps_all, Vs == 16) :-
    model(touch_in_an_edge, Parts, _),
    with_file(pl, File,
              ( in_new_world(( joined(Parts, S), write_solid(File, S) )),
                in_new_world(( load_model(File),
                               aggregate_all(count, v(_,_,_,_,_), Vs) )) )).
test(wedge_goes, T == 12) :-
    model(wedge, Parts, _),
    with_file(stl, File,
              ( in_new_world(( joined(Parts, S), write_solid(File, S) )),
                read_back(File, _, T, 0, _) )).

%   The same bytes in any order.

bytes(Ending, Options, Parts, Bytes) :-
    with_file(Ending, File,
              ( in_new_world(( joined(Parts, S),
                               write_solid(File, S, [name(x)|Options]) )),
                read_file_to_codes(File, Bytes, [type(binary)]) )).

rotated_faces(Points-Faces0, Points-Faces) :-
    random_permutation(Faces0, Faces1),
    maplist(rotated, Faces1, Faces).

rotated(List, Rotated) :-
    length(List, N),
    random_between(1, N, K),
    length(Front, K),
    append(Front, Back, List),
    append(Back, Front, Rotated).

test(any_order, [forall(( model(_, Parts, _), mesh_format(Ending, Options) )),
                 setup(set_random(seed(7)))]) :-
    bytes(Ending, Options, Parts, Bytes),
    forall(between(1, 3, _),
           ( random_permutation(Parts, Parts1),
             maplist(rotated_faces, Parts1, Parts2),
             bytes(Ending, Options, Parts2, Bytes) )).
test(again, true(Bytes1 == Bytes2)) :-
    model(prism, Parts, _),
    bytes(off, [], Parts, Bytes1),
    with_file(off, File,
              ( in_new_world(( joined(Parts, S), write_solid(File, S) )),
                in_new_world(( load_model(File),
                               write_solid(File, 1) )),
                read_file_to_codes(File, Bytes2, [type(binary)]) )).
test(convert_keeps_the_order, true(Xs == [2.0,0.0,0.0,0.0])) :-
    with_file(off, File,
              ( in_new_world(( polyhedron(1, solid,
                                  [p(2,0,0),p(0,0,0),p(0,2,0),p(0,0,2)],
                                  [[1,2,3],[1,3,4],[2,1,4],[3,2,4]]),
                               write_mesh(File, all) )),
                in_new_world(( load_model(File),
                               findall(X, v(1,_,X,_,_), Xs) )) )).
test(canonical_mesh, true(Xs == [0.0,0.0,0.0,2.0])) :-
    with_file(off, File,
              ( in_new_world(( polyhedron(1, solid,
                                  [p(2,0,0),p(0,0,0),p(0,2,0),p(0,0,2)],
                                  [[1,2,3],[1,3,4],[2,1,4],[3,2,4]]),
                               write_mesh(File, all, [canonical(true)]) )),
                in_new_world(( load_model(File),
                               findall(X, v(1,_,X,_,_), Xs) )) )).
test(canonical_segments, N == 2) :-
    with_file(obj, File,
              ( in_new_world(( add_primitive(named(a, box(size(1,1,1))), _),
                               add_primitive(named(b, box(size(2,1,1))), _),
                               write_mesh(File, all, [canonical(true)]) )),
                in_new_world(( load_model(File),
                               aggregate_all(count, segment(_,solid,_), N) ))
              )).

%   Results of Booleans, small and far from the origin, where float32 is coarse:
%   closed and clean in every format.

result(Seed, Away, N, Operation, 100) :-
    set_random(seed(Seed)),
    numlist(1, N, Ss),
    forall(member(_, Ss),
           ( random_shape(24, Away, Term), add_primitive(Term, _) )),
    complete_segments,
    Expression =.. [Operation,Ss],
    boolean(Expression, 100).

sample(Seed, Away, N, Operation) :-
    member(Away, [0, 100, 1000]),
    member(N-Operation, [5-union, 3-difference]),
    member(Seed, [1, 2, 3]).

test(results, forall(sample(Seed, Away, N, Operation))) :-
    with_file(stl, Stl,
              with_file(off, Off,
                        ( in_new_world(( result(Seed, Away, N, Operation, S),
                                         write_solid(Stl, S),
                                         write_solid(Off, S) )),
                          good(Stl, []),
                          good(Off, ['-i']),
                          read_back(Stl, _, _, 0, _),
                          read_back(Off, _, _, 0, _) ))).
test(any_order_of_operands, true(Bytes1 == Bytes2)) :-
    result_bytes([1,2,3,4], Bytes1),
    result_bytes([3,1,4,2], Bytes2).

result_bytes(Order, Bytes) :-
    set_random(seed(5)),
    findall(Term, ( member(_, [1,2,3,4]), random_shape(24, 0, Term) ), Terms),
    with_file(stl, File,
              ( in_new_world(( forall(member(K, Order),
                                      ( nth1(K, Terms, Term),
                                        add_primitive(Term, _) )),
                               complete_segments,
                               boolean(union([1,2,3,4]), 100),
                               write_solid(File, 100, [name(x)]) )),
                read_file_to_codes(File, Bytes, [type(binary)]) )).

%   Rounds: two boxes through each other are united on the way.

test(united_on_the_way, true(abs(V-15) =< 1.0e-9)) :-
    box(p(0,0,0), p(2,2,2), A),
    box(p(1,1,1), p(3,3,3), B),
    output_statistics(Before),
    with_file(off, File,
              ( in_new_world(( joined([A,B], S),
                               write_solid(File, S, [check(all)]) )),
                good(File, ['-i']),
                read_back(File, 20, 12, 0, V) )),
    output_statistics(After),
    After.rounds =:= Before.rounds+1,
    After.solids =:= Before.solids+1.

%   A corner that a cut has put on an edge of a quadrilateral lies beside that
%   edge once it is rounded. No triangle may be as thin as that: these would lie
%   over the face beside the edge, and ask for rounds.

test(corner_on_an_edge, [forall(member(Ending-Slack, [off-0.0,stl-1.0e-6])),
                         true(abs(V-5) =< Slack)]) :-
    output_statistics(Before),
    with_file(Ending, File,
              ( in_new_world(( add_primitive(
                                   polyhedron(points([[0,0,4],[3,0,0],
                                                      [4,4,3],[4,4,1]]),
                                              faces([[1,2,3],[1,4,2],
                                                     [2,4,3],[1,3,4]])), _),
                               add_primitive(
                                   polyhedron(points([[2,3,3],[4,4,3],
                                                      [0,0,4],[2,2,2]]),
                                              faces([[1,3,2],[1,2,4],
                                                     [2,3,4],[1,4,3]])), _),
                               complete_segments,
                               boolean(union([1,2]), 100),
                               write_solid(File, 100) )),
                good(File, []),
                read_back(File, 7, _, 0, V) )),
    output_statistics(After),
    After.rounds =:= Before.rounds.

%   A box with a corner hardly off the planes of its three faces: these stay
%   polygons, unless they have to be flat to the last digit.

test(flat, Faces == [polygons-6,flat-9,triangles-12]) :-
    in_new_world(( polyhedron(1, solid,
                              [p(0,0,0),p(1,0,0),p(1,1,0),p(0,1,0),
                               p(0,0,1),p(1,0,1),p(1.000000000000001,
                               1.000000000000001,1.000000000000001),p(0,1,1)],
                              [[1,4,3,2],[5,6,7,8],[1,2,6,5],[2,3,7,6],
                               [3,4,8,7],[4,1,5,8]]),
                   findall(Form-N,
                           ( member(Form, [polygons,flat,triangles]),
                             faces_of_form(Form, N) ),
                           Faces) )).

faces_of_form(Form, N) :-
    boundary_open([1], [], false, 0.0, Form, true, Boundary),
    boundary_counts(Boundary, counts(N, 0, 0, 0)),
    boundary_close(Boundary).

%   Several solids in one file: each is checked, and united with itself, alone.

test(several, [forall(member(Ending, [off,stl,obj,ply])),
               true(abs(V-16) =< 1.0e-6)]) :-
    box(p(0,0,0), p(2,2,2), A),
    box(p(1,1,1), p(3,3,3), B),
    box(p(5,0,0), p(6,1,1), C-Faces),
    output_statistics(Before),
    with_file(Ending, File,
              ( in_new_world(( joined([A,B], S),
                               polyhedron(2, solid, C, Faces),
                               write_solids(File, [S-both,2-'far off'],
                                            [check(all)]) )),
                in_new_world(( load_model(File), check_report(R) )),
                report_faults(R, 0),
                aggregate_all(sum(Volume),
                              ( member(Part, R.segments),
                                Volume = Part.volume ),
                              V) )),
    output_statistics(After),
    After.rounds =:= Before.rounds+1.
test(one_of_several_open, F == open(3)) :-
    box(p(5,0,0), p(6,1,1), C-Faces),
    in_new_world(( polyhedron(1, solid, C, Faces),
                   polyhedron(2, solid,
                              [p(2,0,0),p(0,0,0),p(0,2,0),p(0,0,2)],
                              [[1,2,3],[1,3,4],[2,1,4]]),
                   catch(write_solids('/tmp/sg_never.off', [1-a,2-b],
                                      [rounds(0)]),
                         error(geometry_error(written(faulty(2, 0, F))), _),
                         true) )),
    \+ exists_file('/tmp/sg_never.off').

%   What cannot be written, and no file then.

test(open, F == open(3)) :-
    in_new_world(( polyhedron(1, solid,
                              [p(2,0,0),p(0,0,0),p(0,2,0),p(0,0,2)],
                              [[1,2,3],[1,3,4],[2,1,4]]),
                   catch(write_solid('/tmp/sg_never.off', 1, [rounds(0)]),
                         error(geometry_error(written(faulty(1, 0, F))), _),
                         true) )),
    \+ exists_file('/tmp/sg_never.off').
test(two_through_each_other, N-K == 6-self_penetration) :-
    box(p(0,0,0), p(2,2,2), A),
    box(p(1,1,1), p(3,3,3), B),
    in_new_world(( joined([A,B], S),
                   catch(write_solid('/tmp/sg_never.off', S,
                                     [rounds(0), check(all)]),
                         error(geometry_error(written(faulty(1, 0,
                                 penetrates(N, meeting(K, _, _, _))))), _),
                         true) )),
    \+ exists_file('/tmp/sg_never.off').
test(no_check) :-
    box(p(0,0,0), p(2,2,2), A),
    box(p(1,1,1), p(3,3,3), B),
    with_file(off, File,
              ( in_new_world(( joined([A,B], S),
                               write_solid(File, S, [check(none)]) )),
                read_back(File, 16, 12, _, _) )).
test(no_segment, error(existence_error(segment, 5))) :-
    in_new_world(write_solid('/tmp/sg_never.off', 5)).
test(bad_ending, error(domain_error(mesh_ending, _))) :-
    in_new_world(( joined_box(S), write_solid('/tmp/sg_never.xyz', S) )).

joined_box(S) :-
    model(box, Parts, _),
    joined(Parts, S).

:- end_tests(solid_file).
