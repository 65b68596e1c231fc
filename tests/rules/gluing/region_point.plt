/* A point inside each region: told by exact rays that know nothing of how it
   was found. */
:- module(test_region_point, []).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(yall)).
:- use_module(rules(gluing/region_point)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(model/model)).
:- use_module(rules(store)).
:- use_module(face_soup).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   inside(S, R, Point): a ray from Point along a direction that meets no edge
%   goes through the border of R an odd number of times. Rationals.

inside(S, R, p(X,Y,Z)) :-
    maplist([N,Q]>>(Q is rational(N)), [X,Y,Z], Point),
    Way = [1r7, 3r11, 13r17],
    aggregate_all(count, crossed(S, R, Point, Way), N),
    N mod 2 =:= 1.

crossed(S, R, Point, Way) :-
    ( sides(S, P, R, Other) ; sides(S, P, Other, R) ),
    Other =\= R,
    t(S, P, _, V1, V2, V3),
    maplist(corner(S, Point), [V1,V2,V3], [A,B,C]),
    det(Way, A, B, D1),
    det(Way, B, C, D2),
    det(Way, C, A, D3),
    sign(D1) =:= sign(D2),
    sign(D2) =:= sign(D3),
    D1 =\= 0,
    det(A, B, C, Volume),
    sign(Volume) =:= sign(D1).

corner(S, [X0,Y0,Z0], V, [X,Y,Z]) :-
    once(v(S, V, X1, Y1, Z1)),
    X is rational(X1)-X0,
    Y is rational(Y1)-Y0,
    Z is rational(Z1)-Z0.

det([A,B,C], [D,E,F], [G,H,I], Det) :-
    Det is A*(E*I-F*H)-B*(D*I-F*G)+C*(D*H-E*G).

all_inside(S, N) :-
    findall(R, ( region(S, R, Role), memberchk(Role, [cell,void]) ), Rs),
    forall(member(R, Rs),
           ( region_point(S, R, Point),
             forall(region(S, R1, Role1),
                    (   ( R1 == R ; Role1 == outside )
                    ->  true
                    ;   \+ inside(S, R1, Point)
                    )),
             inside(S, R, Point) )),
    length(Rs, N).

:- begin_tests(region_point).

test(figures, [ forall(member(File-Wanted, [face-2,vertex-3,crossing-5,
                                            materials-4,mixed-4])),
                true(N == Wanted) ]) :-
    atomic_list_concat(['facts/figures/glue_',File,'.pl'], Path),
    in_new_world(( load_model(Path),
                   once(( segment(S, cells, _), region(S, _, _) )),
                   all_inside(S, N) )).
test(room, true(N == 27)) :-
    findall([X,Y,Z], ( member(X, [0,1,2]), member(Y, [0,1,2]),
                       member(Z, [0,1,2]) ), Lows),
    cubes_faces(Lows, Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _),
                   all_inside(1, N) )).

%   Nothing is inside the outside, or of what bounds nothing.

test(outside, fail) :-
    cube_faces([0,0,0], Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _),
                   region(1, R, outside), region_point(1, R, _) )).

:- end_tests(region_point).
