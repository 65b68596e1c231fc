:- module(sg_test_mesh_pair,
          [ mesh_pair/4,                % +Source, -Name, -First, -Second
            placed_pair/3,              % +Seed, -Name, -Operands
            pair_outcome/3              % +First, +Second, -Outcome
          ]).
/** <module> Booleans of meshes of others, two at a time.

An operand is file(File), or mesh(Points, Triangles) with points p(X,Y,Z).
*/

:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(kernel), [model_tolerance/1]).
:- use_module(rules(model/mesh)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/boolean_case')).
:- use_module(tests('rules/checked')).

/* - - - pairs - - - */

%!  mesh_pair(+Source, -Name, -First, -Second) is nondet.
%
%   The files of ../shared/data that go together: Source is mcut or booleans;
%   or mcut_all: every two of mcut.

mesh_pair(mcut, Name, file(First), file(Second)) :-
    expand_file_name('../shared/data/mcut/src-mesh*.off', Files),
    member(First, Files),
    atomic_list_concat([Begin,End], 'src-mesh', First),
    atomic_list_concat([Begin,End], 'cut-mesh', Second),
    file_base_name(First, Name).
mesh_pair(booleans, Name, file(First), file(Second)) :-
    expand_file_name('../shared/data/booleans/*_left.obj', Files),
    member(First, Files),
    atom_concat(Begin, '_left.obj', First),
    atom_concat(Begin, '_right.obj', Second),
    file_base_name(Begin, Name).
mesh_pair(mcut_all, First0-Second0, file(First), file(Second)) :-
    expand_file_name('../shared/data/mcut/*-mesh0[0-5]*.off', Files),
    member(First, Files),
    member(Second, Files),
    First @< Second,
    maplist(file_base_name, [First,Second], [First0,Second0]).

%!  placed_pair(+Seed, -Name, -Operands) is semidet.
%
%   Two solids of ../shared/data/meshes, the second placed so that coordinates
%   are shared: a vertex of it on one of the first, both flush on a side of
%   their boxes, the same solid shifted along one of its edges or turned by a
%   quarter, or a box whose sides go through vertices of the first.

placed_pair(Seed, Name-How, [mesh(Points1,Triangles1),
                             mesh(Points,Triangles2)]) :-
    set_random(seed(Seed)),
    solid_file(File1),
    solid_file(File2),
    random_member(How, [vertex,flush,shifted,quarter,box]),
    mesh_rows(File1, Points1, Triangles1),
    maplist(file_base_name, [File1,File2], Names),
    Name = Names,
    (   memberchk(How, [shifted,quarter])
    ->  mesh(Points2, Triangles2) = mesh(Points1, Triangles1)
    ;   How == box
    ->  box_between(Points1, Points2, Triangles2)
    ;   mesh_rows(File2, Points2, Triangles2)
    ),
    moved(How, Points1, Triangles1, Points2, Points).

solid_file(File) :-
    random_member(Name, ['thingi10k-472042.stl','thingi10k-65004.stl',
                         'thingi10k-88566.stl','cow.obj']),
    atom_concat('../shared/data/meshes/', Name, File),
    exists_file(File).

mesh_rows(File, Points, Triangles) :-
    new_world(World),
    in_world(World,
             ( read_mesh(File, _),
               complete_segments,
               findall(V-p(X,Y,Z), v(1, V, X, Y, Z), Rows),
               findall(V-I, nth1(I, Rows, V-_), Numbered),
               list_to_assoc(Numbered, Numbers),
               findall(P, member(_-P, Rows), Points),
               findall([A,B,C],
                       ( t(1, _, _, A0, B0, C0),
                         maplist(number_of(Numbers), [A0,B0,C0], [A,B,C]) ),
                       Triangles) )).

number_of(Numbers, V, I) :-
    get_assoc(V, Numbers, I).

moved(vertex, Points1, _, Points2, Points) :-
    random_member(P1, Points1),
    random_member(P2, Points2),
    shifted(Points2, P2, P1, Points).
moved(flush, Points1, _, Points2, Points) :-
    random_member(Axis, [1,2,3]),
    random_member(P1, Points1),
    random_member(P2, Points2),
    shifted(Points2, P2, P1, Points3),
    side(min, Axis, Points1, From),
    side(max, Axis, Points3, To),
    By is From-To,
    maplist(shifted_along(Axis, By), Points3, Points4),
    snapped(Axis, From, Points4, Points).
moved(shifted, Points1, Triangles1, Points2, Points) :-
    random_member([A,B,_], Triangles1),
    nth1(A, Points1, P1),
    nth1(B, Points1, P2),
    shifted(Points2, P1, P2, Points).
moved(quarter, Points1, _, Points2, Points) :-
    maplist(turned, Points2, Points3),
    random_member(P1, Points1),
    random_member(P2, Points3),
    shifted(Points3, P2, P1, Points).
moved(box, _, _, Points, Points).

shifted(Points0, p(X0,Y0,Z0), p(X1,Y1,Z1), Points) :-
    Dx is X1-X0, Dy is Y1-Y0, Dz is Z1-Z0,
    maplist(by(Dx, Dy, Dz), Points0, Points).

by(Dx, Dy, Dz, p(X0,Y0,Z0), p(X,Y,Z)) :-
    X is X0+Dx, Y is Y0+Dy, Z is Z0+Dz.

turned(p(X,Y0,Z), p(X,Y,Y0)) :-
    Y is -Z.

side(Which, Axis, Points, Value) :-
    findall(C, ( member(P, Points), arg(Axis, P, C) ), Cs),
    (   Which == min
    ->  min_list(Cs, Value)
    ;   max_list(Cs, Value)
    ).

shifted_along(Axis, By, P0, P) :-
    arg(Axis, P0, C0),
    C is C0+By,
    duplicate_term(P0, P),
    nb_setarg(Axis, P, C).

%   What the shift left beside the side by rounding goes on it.

snapped(Axis, To, Points0, Points) :-
    maplist(snapped_point(Axis, To), Points0, Points).

snapped_point(Axis, To, P0, P) :-
    arg(Axis, P0, C0),
    (   abs(C0-To) < 1.0e-9*max(1, abs(To))
    ->  duplicate_term(P0, P),
        nb_setarg(Axis, P, To)
    ;   P = P0
    ).

%   A box between two vertices, far enough apart on each axis.

box_between(Points1, Points, Triangles) :-
    repeat,
    random_member(p(Xa,Ya,Za), Points1),
    random_member(p(Xb,Yb,Zb), Points1),
    Xa =\= Xb, Ya =\= Yb, Za =\= Zb,
    !,
    maplist(low_high, [Xa-Xb,Ya-Yb,Za-Zb], [X0-X1,Y0-Y1,Z0-Z1]),
    Points = [ p(X0,Y0,Z0), p(X1,Y0,Z0), p(X0,Y1,Z0), p(X1,Y1,Z0),
               p(X0,Y0,Z1), p(X1,Y0,Z1), p(X0,Y1,Z1), p(X1,Y1,Z1) ],
    Triangles = [ [1,3,4],[1,4,2],[5,6,8],[5,8,7],[1,2,6],[1,6,5],
                  [3,7,8],[3,8,4],[1,5,7],[1,7,3],[2,4,8],[2,8,6] ].

low_high(A-B, Low-High) :-
    Low is min(A, B),
    High is max(A, B).

/* - - - outcomes - - - */

%!  pair_outcome(+First, +Second, -Outcome) is det.
%
%   Outcome is outcome(Closed, Results, Faults): whether both operands bound a
%   solid, of each operation Operation-made(Seconds, Measures) or
%   Operation-refused(Error), and what is wrong: a refusal of two solids, a
%   result that is none, a law that does not hold.

pair_outcome(First, Second, outcome(Closed, Results, Faults)) :-
    new_world(World),
    in_world(World,
             ( entered(First),
               entered(Second),
               complete_segments,
               findall(Operation-Result, operation_result(Operation, Result),
                       Results),
               measured([1,2], [A,B]),
               solids(A, B, Closed),
               slack(A, B, Slack),
               findall(F, pair_fault(Closed, A, B, Slack, Results, F), Faults)
             )).

entered(file(File)) :-
    read_mesh(File, _).
entered(mesh(Points, Triangles)) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Stream, [extension(off)]), close(Stream) ),
        ( write_off(File, Points, Triangles), read_mesh(File, _) ),
        delete_file(File)).

solids(A, B, Closed) :-
    (   A.good == yes,
        B.good == yes
    ->  Closed = solids
    ;   A.closed == yes,
        B.closed == yes
    ->  Closed = closed
    ;   Closed = open
    ).

operation_result(Operation, Result) :-
    member(Operation, [union,intersection,difference]),
    Expression =.. [Operation,[1,2]],
    get_time(T0),
    catch(( node_made(Expression, S), Made = true ), Error, Made = false),
    get_time(T),
    (   Made == true
    ->  Seconds is T-T0,
        measured([S], [Measure]),
        Result = made(Seconds, Measure)
    ;   Result = refused(Error)
    ).

%   node_made(Expression, S): S is a node, and evaluated, which checks operands.

node_made(Expression, S) :-
    fresh_id(segment, 0, S),
    assert_fact(segment(S, solid, Expression)),
    catch(evaluate(S), Error, true),
    (   var(Error)
    ->  true
    ;   retract_fact(segment(S, _, _)),
        throw(Error)
    ).

%   Ten tolerances of volume.

slack(A, B, Slack) :-
    model_tolerance(Tolerance),
    Slack is 10*Tolerance*(A.area+B.area).

pair_fault(solids, _, _, _, Results, Operation-Error) :-
    member(Operation-refused(Error), Results).
pair_fault(open, _, _, _, Results, Operation-not_refused) :-
    member(Operation-made(_, Measure), Results),
    Measure.good \== yes,
    Operation \== union.
pair_fault(Closed, _, _, _, Results, Operation-not_good(Measure)) :-
    Closed \== open,
    member(Operation-made(_, Measure), Results),
    Measure.good \== yes.
pair_fault(solids, A, B, Slack, Results, law(Name, Error)) :-
    volumes(Results, U, I, D),
    (   Name = sum,
        Error is A.volume+B.volume-U-I
    ;   Name = difference,
        Error is A.volume-I-D
    ),
    abs(Error) > Slack.

volumes(Results, U, I, D) :-
    maplist(volume(Results), [union,intersection,difference], [U,I,D]).

volume(Results, Operation, Volume) :-
    memberchk(Operation-made(_, Measure), Results),
    Volume = Measure.volume.
