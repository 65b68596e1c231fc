/* Polygons that are far from flat: their triangles end where they end, or there
   are none and that is told. */
:- module(test_bent, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

face([4,3,2,1]).
face([5,6,7,8]).
face([1,2,6,5]).
face([2,3,7,6]).
face([3,4,8,7]).
face([4,1,5,8]).

%   bent(+Seed): a cube with two corners somewhere on a small grid, so that
%   edges often are seen end on, and sides lie on each other.

bent(Seed) :-
    set_random(seed(Seed)),
    findall(p(X,Y,Z),
            member(X-Y-Z, [0-0-0,2-0-0,2-2-0,0-2-0,0-0-2,2-0-2,2-2-2,0-2-2]),
            Corners0),
    moved(Corners0, Corners1),
    moved(Corners1, Corners),
    findall(Face, face(Face), Faces),
    raw(Corners, Faces).

%   raw(+Corners, +Faces): segment 1, without planes and triangles.

raw(Corners, Faces) :-
    assert_fact(segment(1, solid, bent)),
    forall(nth1(V, Corners, p(X,Y,Z)), assert_fact(v(1, V, X, Y, Z))),
    forall(nth1(P, Faces, Face), raw_face(P, Face)).

raw_face(P, Face) :-
    length(Face, N),
    last(Face, Last),
    append([Last], Face, Ring),
    findall(E, ( nth0(I, Face, _), E is (P-1)*N + I + 1 ), Es),
    forall(( nth1(I, Face, B), nth1(I, Ring, A), nth1(I, Es, E) ),
           assert_fact(e(1, E, A, B, 1))),
    assert_fact(p(1, P, Es)).

moved(Corners0, Corners) :-
    random_between(1, 8, At),
    length(Before, At),
    append(Before, After, Corners0),
    append(Rest, [_], Before),
    random_between(-2, 4, X),
    random_between(-2, 4, Y),
    random_between(-2, 4, Z),
    append(Rest, [p(X,Y,Z)|After], Corners).

%   open_polygon(-P): its triangles do not end where it ends.

open_polygon(P) :-
    p(1, P, Es),
    is_bent(P, Es),
    findall(A-B, ( member(E, Es), e(1, E, A, B, _) ), Edges0),
    findall(A-B, ( t(1, P, _, X, Y, Z),
                   member(A-B, [X-Y,Y-Z,Z-X]) ), Sides0),
    Sides0 \== [],
    exclude(has_twin(Sides0), Sides0, Sides),
    msort(Edges0, Edges),
    msort(Sides, Sorted),
    Edges \== Sorted.

%   A flat one may have a spike, whose triangle has no area.

is_bent(P, Es) :-
    plane(1, P, Nx, Ny, Nz, D),
    member(E, Es),
    e(1, E, A, _, _),
    v(1, A, X, Y, Z),
    abs(Nx*X + Ny*Y + Nz*Z + D) > 0.001,
    !.

has_twin(Sides, A-B) :-
    memberchk(B-A, Sides).

:- dynamic user:message_hook/3.
:- multifile user:message_hook/3.

% That they are not flat, or invalid, is told.
user:message_hook(sanggwan(_), warning, _).

%   wall(+X): segment 2, a square at X that all is within.

wall(X) :-
    assert_fact(segment(2, surface, wall)),
    forall(nth1(V, [-20-(-20),20-(-20),20-20,-20-20], Y-Z),
           assert_fact(v(2, V, X, Y, Z))),
    forall(nth1(E, [1-2,2-3,3-4,4-1], A-B), assert_fact(e(2, E, A, B, 1))),
    assert_fact(p(2, 1, [1,2,3,4])).

%   one_quadrangle(+Seed): segment 1, between corners on a small grid.

one_quadrangle(Seed) :-
    set_random(seed(Seed)),
    findall(p(X,Y,Z),
            ( between(1, 4, _),
              random_between(0, 5, X),
              random_between(0, 5, Y),
              random_between(0, 5, Z) ),
            Corners),
    raw(Corners, [[1,2,3,4]]).

%   area(-Area): of the triangles of segment 1.

area(Area) :-
    aggregate_all(sum(A), ( t(1, _, _, V1, V2, V3), area(V1, V2, V3, A) ),
                  Area).

area(V1, V2, V3, Area) :-
    maplist(at, [V1,V2,V3], [p(X1,Y1,Z1),p(X2,Y2,Z2),p(X3,Y3,Z3)]),
    UX is X2-X1, UY is Y2-Y1, UZ is Z2-Z1,
    WX is X3-X1, WY is Y3-Y1, WZ is Z3-Z1,
    Area is 0.5*sqrt((UY*WZ-UZ*WY)**2 + (UZ*WX-UX*WZ)**2 + (UX*WY-UY*WX)**2).

at(V, p(X,Y,Z)) :-
    v(1, V, X, Y, Z).

:- begin_tests(bent).

test(corner_through_the_cube, Count == 12) :-
    in_new_world(( raw([p(0,0,0),p(1,0,0),p(1,1,0),p(0,1,0),
                        p(0,0,1),p(1,0,1),p(-1,-1,-1),p(0,1,1)],
                       [[4,3,2,1],[5,6,7,8],[1,2,6,5],[2,3,7,6],
                        [3,4,8,7],[4,1,5,8]]),
                   complete_segments,
                   aggregate_all(count, t(1,_,_,_,_,_), Count) )).
% A quadrangle whose triangles fold over, so that it crosses itself however it
% is seen: of a scanned mesh, and of random corners (none may be without
% triangles).
test(folded_over, Count-Open == 2-[]) :-
    in_new_world(( raw([p(0.611284,3.807737,-0.279498),
                        p(0.612870,3.805971,-0.277361),
                        p(0.611001,3.808752,-0.279421),
                        p(0.611179,3.808971,-0.278874)], [[1,2,3,4]]),
                   complete_segments,
                   aggregate_all(count, t(1,_,_,_,_,_), Count),
                   findall(P, open_polygon(P), Open) )).
test(no_quadrangle_is_left_out, Missing == []) :-
    findall(Seed-P,
            ( between(1, 300, Seed),
              in_new_world(( bent(Seed), complete_segments,
                             findall(Q, ( p(1, Q, Es), is_bent(Q, Es),
                                          \+ t(1, Q, _, _, _, _) ),
                                     Qs) )),
              member(P, Qs) ),
            Missing).
% No line could be put into one as a whole: its triangles are polygons then.
test(folded_over_is_cut, Polygons-Lines == 2-2) :-
    in_new_world(( raw([p(0,0,0),p(10,2,1),p(8,0,2),p(1,6,0.5)], [[1,2,3,4]]),
                   wall(4),
                   complete_segments,
                   penetrate,
                   aggregate_all(count, p(1,_,_), Polygons),
                   aggregate_all(count, line(_,1,_,_,_,_,_,_,_), Lines) )).
test(any_quadrangle_is_cut, Wrong == []) :-
    findall(Seed-(Before-After),
            ( between(1, 300, Seed),
              in_new_world(( one_quadrangle(Seed), wall(2.5),
                             complete_segments,
                             area(Before), penetrate, area(After) )),
              abs(Before-After) > 1.0e-9 ),
            Wrong),
    format("counted: 300 quadrangles in space, cut by a plane~n").
test(any, Open == []) :-
    findall(Seed-P,
            ( between(1, 300, Seed),
              in_new_world(( bent(Seed), complete_segments,
                             findall(Q, open_polygon(Q), Qs) )),
              member(P, Qs) ),
            Open),
    format("counted: 300 bent cubes~n").

:- end_tests(bent).
