/* Bent plates: rules/development/bend.pl. */
% covers: bend_corner
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(development/bend)).
:- use_module(rules(development/development)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).

:- begin_tests(bend).

:- meta_predicate bent(+, +, -, 0).

%   bent(Term, Options, D, Goal): Goal in a world where D is its bent pattern.

bent(Term, Options, D, Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(Term, S),
               complete_segments,
               develop(S, [], D),
               pattern_bent(D, Options),
               Goal )).

size(D, Width, Height) :-
    findall(X, v(D, _, X, _, _), Xs),
    findall(Y, v(D, _, _, Y, _), Ys),
    max_list(Xs, X1),
    min_list(Xs, X0),
    max_list(Ys, Y1),
    min_list(Ys, Y0),
    Width is X1-X0,
    Height is Y1-Y0.

area(D, Area) :-
    aggregate_all(sum(Part), triangle_area(D, Part), Area).

triangle_area(D, Area) :-
    t(D, _, _, A, B, C),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

near(X, Y) :-
    abs(X-Y) =< 1.0e-9*(1+abs(Y)).

%   Sheets 100 wide, of legs; outside is where their normals look.

l_bracket(sheet(points([[0,0,40],[0,100,40],[0,0,0],[0,100,0],[60,0,0],
                        [60,100,0]]),
                faces([[1,2,4,3],[3,4,6,5]]))).
channel(sheet(points([[0,0,30],[0,100,30],[0,0,0],[0,100,0],[60,0,0],
                      [60,100,0],[60,0,30],[60,100,30]]),
              faces([[1,2,4,3],[3,4,6,5],[5,6,8,7]]))).
%   The same turned inside out: valley folds.
tray(sheet(points([[0,0,30],[0,100,30],[0,0,0],[0,100,0],[60,0,0],
                   [60,100,0],[60,0,30],[60,100,30]]),
           faces([[3,4,2,1],[5,6,4,3],[7,8,6,5]]))).

deduction(R, T, K, Out, BD) :-
    BD is 2*(R+Out) - pi/2*(R+K*T).

test(edge_without_length, true((near(Width, Width1), near(Area, Area1)))) :-
    l_bracket(sheet(points(Points), faces([Face,[A,B|More]]))),
    nth1(B, Points, Place),
    append(Points, [Place], Points1),
    length(Points1, N),
    bent(sheet(points(Points), faces([Face,[A,B|More]])), [thickness(2)], D,
         ( size(D, Width, _), area(D, Area) )),
    bent(sheet(points(Points1), faces([Face,[A,B,N|More]])), [thickness(2)],
         D1, ( size(D1, Width1, _), area(D1, Area1) )).
test(l_bracket_by_its_outside, true(near(Width, 100-BD))) :-
    l_bracket(Term),
    deduction(3, 2, 0.44, 2, BD),
    bent(Term, [thickness(2),size(outside),bend_radius(3),k_factor(0.44)], D,
         size(D, Width, _)).
test(l_bracket_by_its_inside, true(near(Width, 100-BD))) :-
    l_bracket(Term),
    deduction(3, 2, 0.44, 0, BD),
    bent(Term, [thickness(2),size(inside),bend_radius(3),k_factor(0.44)], D,
         size(D, Width, _)).
%   Legs without their bends, and the arc of the neutral layer.
test(l_bracket_by_hand, true(near(Width, 35+55+pi/2*(3+0.5*2)))) :-
    l_bracket(Term),
    bent(Term, [thickness(2),size(outside),bend_radius(3),k_factor(0.5)], D,
         size(D, Width, _)).
test(channel, true((near(Width, 120-2*BD), near(Height, 100)))) :-
    channel(Term),
    deduction(3, 2, 0.44, 2, BD),
    bent(Term, [thickness(2),size(outside),bend_radius(3),k_factor(0.44)], D,
         size(D, Width, Height)).
%   A sheet that is bent one way only is as large whichever side it shows.
test(tray, [ forall(member(Size-Out, [outside-2,middle-1,inside-0])),
             true(near(Width, 120-2*BD)) ]) :-
    tray(Term),
    deduction(3, 2, 0.44, Out, BD),
    bent(Term, [thickness(2),size(Size),bend_radius(3),k_factor(0.44)], D,
         size(D, Width, _)).
%   What is inside of mountain folds is outside of valley folds.
test(bent_both_ways, true(near(Width, 130-BD1-BD2))) :-
    deduction(3, 2, 0.44, 2, BD1),
    deduction(3, 2, 0.44, 0, BD2),
    bent(sheet(points([[0,0,40],[0,100,40],[0,0,0],[0,100,0],[60,0,0],
                       [60,100,0],[60,0,-30],[60,100,-30]]),
               faces([[1,2,4,3],[3,4,6,5],[5,6,8,7]])),
         [thickness(2),size(outside),bend_radius(3),k_factor(0.44)], D,
         size(D, Width, _)).
test(neutral, true(near(Width, 100-BD))) :-
    l_bracket(Term),
    deduction(3, 2, 0.4, 0.8, BD),
    bent(Term, [thickness(2),size(neutral),bend_radius(3),k_factor(0.4)], D,
         size(D, Width, _)).
%   The bend line is in the middle of the bend.
test(bend_line, true(near(Off, 60-BD))) :-
    channel(Term),
    deduction(3, 2, 0.44, 2, BD),
    bent(Term, [thickness(2),size(outside),bend_radius(3),k_factor(0.44)], D,
         ( findall(E-X, ( joint(D, _, E, _, fold, _), edge_line(D, E, X) ),
                   [_-X1,_-X2]),
           Off is abs(X1-X2) )).

%   Of two parallel folds the places across.
edge_line(D, E, Place) :-
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    (   abs(X1-X2) < 1.0e-6
    ->  Place = X1
    ;   abs(Y1-Y2) < 1.0e-6,
        Place = Y1
    ).

test(folds_share_their_ends) :-
    channel(Term),
    bent(Term, [thickness(2),size(outside)], D,
         forall(joint(D, _, E1, E2, fold, _),
                ( e(D, E1, A, B, _), e(D, E2, B, A, _) ))).
test(without_thickness, true(Width-Height == 120.0-100.0)) :-
    channel(Term),
    bent(Term, [bend_radius(3)], D, size(D, Width, Height)).

%   A box of plate: each face loses half a deduction at each bend it has, and
%   the thickness at each seam; and faces still do not overlap.
test(box, true(near(Area, Whole))) :-
    Options = [thickness(1),size(outside),bend_radius(1),relief(none)],
    bend_deduction(90, Options, BD),
    bent(box(size(100,60,40)), Options, D,
         ( area(D, Area),
           findall(Part, ( p(D, P, _), face_left(D, P, BD, Part) ), Parts),
           sum_list(Parts, Whole),
           forall(triangle_area(D, A), A > 0) )).

%   face_left(D, P, BD, Area): of a box; sides with bends are taken off.
face_left(D, P, BD, Area) :-
    p(1, P, Es),
    member(E1, Es),
    e(1, E1, A, B, _),
    member(E2, Es),
    e(1, E2, B, C, _),
    !,
    space(A, B, L1),
    space(B, C, L2),
    member(E3, Es),
    e(1, E3, C, F, _),
    member(E4, Es),
    e(1, E4, F, A, _),
    !,
    bends(D, [E1,E3], N1),
    bends(D, [E2,E4], N2),
    Area is (L1 - N2*BD/2 - (2-N2))*(L2 - N1*BD/2 - (2-N1)).

space(A, B, Length) :-
    v(1, A, X1, Y1, Z1),
    v(1, B, X2, Y2, Z2),
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

bends(D, Es, N) :-
    aggregate_all(count,
                  ( member(E, Es),
                    ( joint(D, _, E, _, fold, _) ; joint(D, _, _, E, fold, _) )
                  ),
                  N).

test(too_sharp, error(geometry_error(true(bend(1, _, _, _))), _)) :-
    bent(sheet(points([[0,0,0],[10,0,0],[10,9,0],[0,9,0],[0,9,0.1],
                       [10,9,0.1],[10,0,0.5],[0,0,0.5]]),
               faces([[1,2,3,4],[4,3,7,8]])),
         [thickness(1)], _, true).
%   A leg whose end is slanted at the fold, in short steps: what is left beside
%   the bend is cut off there. Steps shorter than that had been refused.
test(short_edges_at_a_fold, true(near(Area, 10000-58*2-2*2/2-200*H+H*H/2))) :-
    deduction(3, 2, 0.44, 2, BD),
    H is BD/2,
    bent(sheet(points([[0,0,40],[0,100,40],[0,0,0],[0,100,0],[60,2,0],
                       [60,100,0],[2,2,0],[1,1,0],[0.4,0.4,0],[0.2,0.2,0]]),
               faces([[1,2,4,3],[3,4,6,5,7,8,9,10]])),
         [thickness(2),size(outside),bend_radius(3),k_factor(0.44)], D,
         ( area(D, Area),
           forall(( p(D, _, Es), member(E, Es) ),
                  ( e(D, E, A, B, _), v(D, A, _, _, _), v(D, B, _, _, _) )),
           aggregate_all(count, v(D, _, _, _, _), Count) )),
    Count =:= 8.
test(facet_of_a_sphere,
     error(geometry_error(true(bent_facet(1, _, sphere, _))), _)) :-
    bent(sphere(radius(10),facets(12)), [thickness(3),bend_radius(1000)], _,
         true).
test(too_narrow, error(geometry_error(true(bend_too_wide(1, _, _))), _)) :-
    bent(box(size(10,10,1)), [thickness(1),size(outside),bend_radius(5)], _,
         true).
test(layer_outside, error(_, _)) :-
    bend_deduction(90, [thickness(1),k_factor(1.5)], _).
test(negative, error(domain_error(thickness, -1), _)) :-
    bend_deduction(90, [thickness(-1)], _).

:- end_tests(bend).
