% Many shells of one segment on one edge or one polygon, and many equal ones:
% penetrate/2 with shown(true) leaves out what a picture does not show, and the
% picture is that without it, line for line.
:- module(test_crowded_picture, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(store)).
:- use_module(tests('rules/shells')).
:- use_module(tests('rules/sample')).

%   drawn_lines(+Options, -Lines): what is drawn, by places: edges that cuts
%   made have other numbers where there are fewer.

drawn_lines(Options, Lines) :-
    penetrate(all, [themselves(true)|Options]),
    set_view(300, 60, 0),
    picture([lines(all)]),
    findall(line(A, B, From, To, Visibility, Role),
            ( drawn(_, S, E, From, To, Visibility, Role),
              e(S, E, V1, V2, _),
              seen(S, V1, A),
              seen(S, V2, B) ),
            Lines0),
    msort(Lines0, Lines).

seen(S, V, p(X,Y,Z)) :-
    screen(S, V, X, Y, Z).

same_picture(Shells, Rows, Fewer) :-
    one_segment(Shells,
                ( facts_snapshot(( drawn_lines([], Lines),
                                   row_counts(All) )),
                  facts_snapshot(( drawn_lines([shown(true)], Shown),
                                   row_counts(Some) )) )),
    Rows = All-Some,
    All = rows(_, Lines1),
    Some = rows(_, Lines2),
    (   Lines2 < Lines1
    ->  Fewer = true
    ;   Fewer = false
    ),
    Lines == Shown.

row_counts(rows(Vertices, Lines)) :-
    findall(V, v(_, V, _, _, _), Vs),
    length(Vs, Vertices),
    findall(L, line(L, _, _, _, _, _, _, _, _), Ls),
    length(Ls, Lines).

%   A wedge of prism(...) on the z axis; some reach farther up and down, so that
%   the edges on the axis differ.

wedge(N, I, Low, High, at([translate(0,0,Low)],
                          prism(outline([[0,0],[X1,Y1],[X2,Y2]]),
                                height(H)))) :-
    H is High-Low,
    A1 is 2*pi*I/N,
    A2 is 2*pi*(I+0.6)/N,
    X1 is cos(A1), Y1 is sin(A1),
    X2 is cos(A2), Y2 is sin(A2).

wedges(N, Shells) :-
    findall(Shell, ( between(1, N, I), wedge(N, I, 0, 1, Shell) ), Shells).

random_wedges(N, Shells) :-
    findall(Shell,
            ( between(1, N, I),
              random_member(Low-High, [0-1,0-1,0-1,0-2,-1-1]),
              wedge(N, I, Low, High, Shell) ),
            Shells).

random_box(at([translate(X,Y,Z)], box(size(A,B,C)))) :-
    maplist([N]>>random_between(1, 3, N), [A,B,C]),
    maplist([N]>>( random_between(-2, 2, M), N is M/2 ), [X,Y,Z]).

% Boxes, each so often; in any order.
random_copies(Shells) :-
    random_between(1, 3, N),
    findall(Box,
            ( between(1, N, _), random_box(One), random_between(1, 5, Copies),
              between(1, Copies, _), Box = One ),
            Shells0),
    random_permutation(Shells0, Shells).

% Cones on one polygon, each in the next higher one.
cones(N, Shells) :-
    findall(cone(radius(1), height(H), facets(4)),
            ( between(1, N, I), H is 1+I/8 ), Shells).

random_cone(at([translate(0,0,Z)|Steps],
               cone(radius(1), top(Top), height(H), facets(4)))) :-
    random_member(Z, [0,0,0,1]),
    random_member(Steps, [[],[],[mirror(z)],[rotate(z,90)]]),
    random_member(Top, [0,0.5,1]),
    random_between(1, 6, H).

:- begin_tests(crowded_picture).

test(few_wedges, Fewer == false) :-
    wedges(8, Shells),
    same_picture(Shells, _, Fewer).
test(wedges, Fewer == true) :-
    wedges(20, Shells),
    same_picture(Shells, _, Fewer).
test(one_box, [true(N-M == 32-16)]) :-
    Box = box(size(1,2,3)),
    same_picture([Box,Box,Box,Box], rows(N, _)-rows(M, _), _).
test(wedges_and_boxes, [ forall(numbered(5, 12, Seed)),
                         true(Fewer == true) ]) :-
    set_random(seed(Seed)),
    random_between(30, 45, N),
    random_wedges(N, Wedges),
    random_box(Box1),
    random_box(Box2),
    random_permutation([Box1,Box2|Wedges], Shells),
    same_picture(Shells, _, Fewer).
%   A polygon that many have in common is cut by a few of them.
test(one_polygon, true) :-
    cones(24, Some),
    same_picture(Some, _-rows(_, Lines1), true),
    cones(48, More),
    same_picture(More, _-rows(_, Lines2), true),
    Lines2 < 2.5*Lines1.
test(one_polygon_of_random_cones, forall(numbered(5, 12, Seed))) :-
    set_random(seed(Seed)),
    random_between(18, 30, N),
    length(Shells, N),
    maplist(random_cone, Shells),
    same_picture(Shells, _, _).
test(copies, [forall(numbered(10, 25, Seed))]) :-
    set_random(seed(Seed)),
    random_copies(Shells),
    same_picture(Shells, _, _).

:- end_tests(crowded_picture).
