/* What is glued without a cut is what the arrangement makes, but for ids. And
   what is to be cut is cut.
   covers: whole_contacts */
:- module(test_glue_whole, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(prolog_wrap)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(gluing/cycle)).
:- use_module(rules(store)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

% What is 1.0e-12 off is made to touch, and told.

:- multifile user:message_hook/3.

user:message_hook(sanggwan(tight(_,_,_,_,_,_)), warning, _).
user:message_hook(sanggwan(flattened(_,_,_,_,_)), warning, _).

%   made(Parts, Steps, How, Rows): what is glued; How says whether it was cut.

:- dynamic cut/0.

made(Parts, Steps, How, Rows) :-
    retractall(cut),
    setup_call_cleanup(
        wrap_predicate(sg_arrangement:with_arrangement(_, _, _), seen, Call,
                       ( assertz(test_glue_whole:cut), Call )),
        in_new_world(( glue_made(Parts, Steps, S), rows(S, Rows) )),
        unwrap_predicate(sg_arrangement:with_arrangement/3, seen)),
    (   cut
    ->  How = cut
    ;   How = whole
    ).

arranged(Parts, Steps, Rows) :-
    setup_call_cleanup(
        wrap_predicate(sg_glue_whole:whole_pieces(_, _, _, _), off, _, fail),
        made(Parts, Steps, cut, Rows),
        unwrap_predicate(sg_glue_whole:whole_pieces/4, off)).

%   rows(S, Rows): faces, edges and vertices by their places.

rows(S, rows(Faces, Vertices, Regions)) :-
    findall(Face, face(S, Face), Faces0),
    msort(Faces0, Faces),
    findall(At-From,
            ( v(S, V, X, Y, Z), At = [X,Y,Z],
              findall(S0, from_v(S, V, S0, _), From) ),
            Vertices0),
    msort(Vertices0, Vertices),
    findall(Role-In, ( region(S, R, Role), inside(S, R, In) ), Regions0),
    msort(Regions0, Regions).

face(S, face(Loops, Froms, Below, Above)) :-
    p(S, P, _),
    findall(Loop, ( loop_cycle(S, P, _, Vs), placed(S, Vs, Loop) ), Loops0),
    msort(Loops0, Loops),
    findall(S0-P0-Sense, from_p(S, P, S0, P0, Sense), Froms0),
    msort(Froms0, Froms),
    sides(S, P, R1, R2),
    inside(S, R1, Below),
    inside(S, R2, Above).

inside(S, R, In) :-
    findall(S0, from_r(S, R, S0, _), In).

%   placed(S, Vs, Loop): from its lowest place on.

placed(S, Vs, Loop) :-
    maplist(place(S), Vs, Places),
    min_member(Least, Places),
    append(Before, [Least|After], Places),
    !,
    append([Least|After], Before, Loop).

place(S, V, [X,Y,Z]) :-
    once(v(S, V, X, Y, Z)).

:- begin_tests(glue_whole).

test(same, [ forall(whole(Name)), Rows == Arranged ]) :-
    once(model(Name, Parts, _)),
    made(Parts, [], whole, Rows),
    arranged(Parts, [], Arranged).

whole(two(apart)).
whole(two(vertex)).
whole(two(edge)).
whole(two(face)).
whole(two(nested)).
whole(cubes(2)).
whole(cubes(3)).
whole(nested(5)).
whole(six_pyramids).
whole(closed_book(7)).
whole(tetrahedra(1)).
whole(tetrahedra(2)).
whole(book(8)).
whole(moebius).
whole(against).
whole(doubled).

test(is_cut, forall(cut(Name))) :-
    once(model(Name, Parts, _)),
    made(Parts, [], cut, _).

cut(two(half_edge)).
cut(two(crossing)).
cut(on_plate).
cut(fig6).
cut(fig7).
cut(fig8(edge)).
cut(fig8(face)).
cut(fig8(ridge)).
cut(flush_sheet).
cut(large_sheet).

%   Tetrahedra with corners on a coarse grid, some a hair beside it: where
%   nothing was cut, cutting would have made the same.

test(random, Whole-Different == true-[]) :-
    numlist(1, 300, Seeds),
    convlist(random_case, Seeds, Cases),
    length(Cases, N),
    (   N > 20
    ->  Whole = true
    ;   Whole = N
    ),
    findall(Seed, member(Seed-different, Cases), Different).

random_case(Seed, Seed-Same) :-
    set_random(seed(Seed)),
    length(Parts, 2),
    maplist(random_tetrahedron, Parts),
    catch(made(Parts, [], whole, Rows), error(geometry_error(_), _), fail),
    arranged(Parts, [], Arranged),
    (   Rows == Arranged
    ->  Same = same
    ;   Same = different
    ).

random_tetrahedron(tetrahedron(Points)) :-
    repeat,
    length(Points, 4),
    maplist(random_point, Points),
    Points = [[X,Y,Z]|Others],
    maplist({X,Y,Z}/[[A,B,C],[P,Q,R]]>>( P is A-X, Q is B-Y, R is C-Z ),
            Others, [[A1,A2,A3],[B1,B2,B3],[C1,C2,C3]]),
    Volume is A1*(B2*C3-B3*C2)-A2*(B1*C3-B3*C1)+A3*(B1*C2-B2*C1),
    abs(Volume) > 0.5,
    !.

random_point(Point) :-
    length(Point, 3),
    maplist(random_coordinate, Point).

random_coordinate(X) :-
    random_between(0, 2, N),
    random_between(0, 9, Beside),
    (   Beside =:= 0
    ->  X is N+1.0e-12
    ;   X is float(N)
    ).

:- end_tests(glue_whole).
