:- module(test_fold, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(exact), [vertex_exact/5]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

/* A polygon that is not flat is used as its triangles, also where it is cut:
   every new triangle lies in one of those that were there, and together they
   are as large. */

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), _, _).

%   crown(+S, +N, +Shift): segment S is a prism of N sides, whose bottom is flat
%   and whose upper corners are anywhere near where they should be.

crown(S, N, [DX,DY,DZ]) :-
    assert_fact(segment(S, solid, crown)),
    forall(between(1, N, I),
           ( A is 2*pi*I/N,
             random(-0.3, 0.3, JX),
             random(-0.3, 0.3, JY),
             random(-0.5, 0.5, JZ),
             X is 2*cos(A)+DX,
             Y is 2*sin(A)+DY,
             X1 is X+JX,
             Y1 is Y+JY,
             Z1 is 2+DZ+JZ,
             V1 is N+I,
             assert_fact(v(S, I, X, Y, DZ)),
             assert_fact(v(S, V1, X1, Y1, Z1)) )),
    numlist(1, N, Bottom0),
    reverse(Bottom0, Bottom),
    From is N+1,
    To is 2*N,
    numlist(From, To, Top),
    findall([I,J,J1,I1], ( between(1, N, I), J is I mod N + 1,
                           J1 is J+N, I1 is I+N ),
            Sides),
    foldl(polygon(S), [Bottom,Top|Sides], 1-1, _).

polygon(S, Vs, P-E0, P1-E) :-
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    foldl(edge(S), Vs, Nexts, E0, E),
    Last is E-1,
    numlist(E0, Last, Es),
    assert_fact(p(S, P, Es)),
    P1 is P+1.

edge(S, V1, V2, E, E1) :-
    assert_fact(e(S, E, V1, V2, 1)),
    E1 is E+1.

%   crowns(+Seed): two or three that go through each other.

crowns(Seed) :-
    set_random(seed(Seed)),
    Count is 2 + Seed mod 2,
    forall(between(1, Count, S),
           ( random_between(3, 7, N),
             random(-1.0, 1.0, X),
             random(-1.0, 1.0, Y),
             random(-1.0, 1.0, Z),
             crown(S, N, [X,Y,Z]) )),
    complete_segments.

%   on_a_triangle(+S, +P, +Corners): they lie in the plane of a leaf triangle of
%   the polygon, exactly.

on_a_triangle(S, P, Corners) :-
    (   leaf_t(S, P, _, A, B, C)
    *-> true
    ;   t(S, P, _, A, B, C)
    ),
    maplist(place(S), [A,B,C], Plane),
    \+ ( member(Corner, Corners), \+ in_plane(Plane, Corner) ),
    !.

place(S, V, p(X,Y,Z)) :-
    once(vertex_exact(S, V, X, Y, Z)).

in_plane([A,B,C], D) :-
    difference(B, A, U),
    difference(C, A, V),
    difference(D, A, W),
    cross(U, V, N),
    dot(N, W, 0).

difference(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    X is X1-X2,
    Y is Y1-Y2,
    Z is Z1-Z2.

cross(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    X is Y1*Z2-Z1*Y2,
    Y is Z1*X2-X1*Z2,
    Z is X1*Y2-Y1*X2.

dot(p(X1,Y1,Z1), p(X2,Y2,Z2), Dot) :-
    Dot is X1*X2+Y1*Y2+Z1*Z2.

%   off_surface(-Faults): triangles that lie in none of those that were.

off_surface(Faults) :-
    findall(S-P-T,
            ( t(S, P, T, A, B, C),
              maplist(place(S), [A,B,C], Corners),
              \+ on_a_triangle(S, P, Corners) ),
            Faults).

areas(Areas) :-
    findall(S-P-Area,
            aggregate(sum(A), triangle_area(S, P, A), Area),
            Areas).

triangle_area(S, P, A) :-
    t(S, P, _, V1, V2, V3),
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    v(S, V3, X3, Y3, Z3),
    difference(p(X2,Y2,Z2), p(X1,Y1,Z1), U),
    difference(p(X3,Y3,Z3), p(X1,Y1,Z1), V),
    cross(U, V, N),
    dot(N, N, Square),
    A is sqrt(Square)/2.

same_area(S-P-Area1, S-P-Area2) :-
    abs(Area1-Area2) < 1.0e-12*Area1.

volume(S, Volume) :-
    aggregate_all(sum(V),
                  ( t(S, _, _, V1, V2, V3),
                    v(S, V1, X1, Y1, Z1),
                    v(S, V2, X2, Y2, Z2),
                    v(S, V3, X3, Y3, Z3),
                    cross(p(X2,Y2,Z2), p(X3,Y3,Z3), N),
                    dot(p(X1,Y1,Z1), N, D),
                    V is D/6 ),
                  Volume).

rows(Rows) :-
    findall(Row, ( member(Row, [ v(_,_,_,_,_), e(_,_,_,_,_), p(_,_,_),
                                 t(_,_,_,_,_,_), origin(_,_,_),
                                 line(_,_,_,_,_,_,_,_,_) ]),
                   call(Row) ),
            Rows).

written_by_rule(Set, Works) :-
    maplist(sg_cut_rows:write_polygon_by_rule(Set), Works).

written_by(Seed, Write, Rows) :-
    in_new_world(( crowns(Seed),
                   findall(A-B, ( segment(A, _, _), segment(B, _, _), A < B ),
                           Pairs),
                   facts_transaction(
                       sg_penetration:with_cut_set(Pairs, 0.0,
                                                   arranged(Write))),
                   rows(Rows) )).

:- begin_tests(fold).

test(same_surface, [ forall(between(1, 40, Seed)),
                     true(Faults-Off == []-[]) ]) :-
    in_new_world(( crowns(Seed),
                   areas(Before),
                   penetrate,
                   once(line(_, _, _, _, _, _, _, _, _)),
                   areas(After),
                   off_surface(Faults),
                   ( maplist(same_area, Before, After)
                   ->  Off = []
                   ;   Off = Before-After
                   ) )).
test(kernel_writes, [ forall(between(1, 30, Seed)), true(Kernel == Rule) ]) :-
    written_by(Seed, write_polygons, Kernel),
    written_by(Seed, test_fold:written_by_rule, Rule).
test(cut_again, [ forall(between(1, 10, I)), true(Twice == Once) ]) :-
    Seed is 2*I+1,                      % of three
    in_new_world(( crowns(Seed),
                   penetrate,
                   areas(Once0),
                   maplist(rounded, Once0, Once) )),
    in_new_world(( crowns(Seed),
                   penetrate([1-2], []),
                   penetrate([1-3,2-3], []),
                   off_surface([]),
                   areas(Twice0),
                   maplist(rounded, Twice0, Twice) )).
test(volumes, [ forall(between(1, 20, I)), true(Off < 1.0e-12) ]) :-
    Seed is 2*I,                        % of two
    in_new_world(( crowns(Seed),
                   volume(1, A),
                   volume(2, B),
                   assert_fact(segment(3, solid, union([1,2]))),
                   assert_fact(segment(4, solid, intersection([1,2]))),
                   assert_fact(segment(5, solid, difference([1,2]))),
                   evaluate,
                   maplist(volume, [3,4,5], [Union,Common,Rest]),
                   Off is max(abs(A+B-Union-Common), abs(A-Common-Rest))/A )).

rounded(S-P-Area, S-P-Rounded) :-
    Rounded is round(Area*1.0e9).

% A bent square, and a plane through the chord between its two triangles: the
% line is an edge of the polygon there. Across the chord it is two pieces.

bent_square :-
    assert_fact(segment(1, surface, bent)),
    forall(nth1(V, [p(0,0,0),p(2,0,0),p(2,2,1),p(0,2,0)], p(X,Y,Z)),
           ( maplist(float_of, [X,Y,Z], [X1,Y1,Z1]),
             assert_fact(v(1, V, X1, Y1, Z1)) )),
    polygon(1, [1,2,3,4], 1-1, _),
    complete_segments,
    findall(A-B, fold_side(A, B), [_,_]).

fold_side(A, B) :-
    t(1, 1, T1, _, _, _),
    triangle_side(T1, A, B),
    t(1, 1, T2, _, _, _),
    triangle_side(T2, B, A).

triangle_side(T, A, B) :-
    t(1, _, T, V1, V2, V3),
    member(A-B, [V1-V2,V2-V3,V3-V1]).

float_of(X, Y) :-
    Y is float(X).

plane_through(P1, P2) :-
    P1 = p(X1,Y1),
    P2 = p(X2,Y2),
    assert_fact(segment(2, surface, plane)),
    forall(nth1(V, [X1-Y1-(-1),X2-Y2-(-1),X2-Y2-3,X1-Y1-3], X-Y-Z),
           ( maplist(float_of, [X,Y,Z], [XF,YF,ZF]),
             assert_fact(v(2, V, XF, YF, ZF)) )),
    polygon(2, [1,2,3,4], 1-1, _),
    complete_segments.

test(along, true(Lines-Ends == 1-[A-B,B-A])) :-
    in_new_world(( bent_square,
                   once(( fold_side(A, B), A < B )),
                   v(1, A, XA, YA, _),
                   v(1, B, XB, YB, _),
                   X1 is 2*XA-XB, Y1 is 2*YA-YB,
                   X2 is 2*XB-XA, Y2 is 2*YB-YA,
                   plane_through(p(X1,Y1), p(X2,Y2)),
                   penetrate,
                   aggregate_all(count, line(_,_,_,_,_,_,_,_,_), Lines),
                   p(1, 1, Es),
                   findall(V1-V2, ( member(E, Es), e(1, E, V1, V2, 1),
                                    origin(1, e(E), line(_)) ),
                           Ends0),
                   sort(Ends0, Ends),
                   off_surface([]) )).
test(across, true(Lines-Triangles == 2-4)) :-
    in_new_world(( bent_square,
                   once(( fold_side(A, B), A < B )),
                   v(1, A, XA, YA, _),
                   v(1, B, XB, YB, _),
                   X1 is 1+2*(YB-YA), Y1 is 1-2*(XB-XA),
                   X2 is 1-2*(YB-YA), Y2 is 1+2*(XB-XA),
                   plane_through(p(X1,Y1), p(X2,Y2)),
                   penetrate,
                   aggregate_all(count, line(_,_,_,_,_,_,_,_,_), Lines),
                   aggregate_all(count, t(1,_,_,_,_,_), Triangles),
                   forall(( p(1, 1, Es), member(E, Es) ),
                          ( e(1, E, _, _, Et), Et =:= 1 )),
                   off_surface([]) )).

:- end_tests(fold).
