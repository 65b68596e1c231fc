:- module(sg_oracle_view,
          [ turned_by_rule/2,           % +Axes, +Origin
            turned_point/4,             % +Axes, +Origin, +Place0, -Place
            screen_point/3,             % +View, +EyePoint, -ScreenPoint
            in_one_place/3,             % +Close, +Points0, -Points
            screen_plane/5              % +S, +T, -A, -B, -D
          ]).
:- use_module('../../rules/store',
              [ screen/5, t/6, v/5, leaf_v/5, plane/6, assert_fact/1,
                retractall_facts/1, facts_transaction/1
              ]).
:- use_module(library(apply),
              [foldl/4, foldl/5, foldl/6, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/3, member/2, nth1/3]).
/** <module> The rules of views (rules/picture/view.pl): where points go, and
where they are seen.
*/

:- set_prolog_flag(optimise, true).

%!  turned_by_rule(+Axes:list, +Origin:list) is det.
%
%   What the kernel turn_points/2 does: all rows of the current world that have
%   a point, or a plane, are turned. One transaction.

turned_by_rule(Axes, Origin) :-
    findall(New, ( placed_row(Old, Place0, New, Place), Old,
                   turned_point(Axes, Origin, Place0, Place) ),
            Rows),
    facts_transaction(
        ( retractall_facts(v(_,_,_,_,_)),
          retractall_facts(leaf_v(_,_,_,_,_)),
          retractall_facts(plane(_,_,_,_,_,_)),
          maplist(assert_fact, Rows) )).

%   placed_row(Old, Place0, New, Place): rows that have a point, or a plane.

placed_row(v(S,V,X0,Y0,Z0), [X0,Y0,Z0], v(S,V,X,Y,Z), [X,Y,Z]).
placed_row(leaf_v(S,V,X0,Y0,Z0), [X0,Y0,Z0], leaf_v(S,V,X,Y,Z), [X,Y,Z]).
placed_row(plane(S,P,X0,Y0,Z0,D0), plane([X0,Y0,Z0],D0),
           plane(S,P,X,Y,Z,D), plane([X,Y,Z],D)).

%!  turned_point(+Axes, +Origin, +Place0, -Place) is det.
%
%   Place is to where Place0 goes, a point [X,Y,Z] or plane(Normal, D), when
%   Origin becomes the origin and then the axes become others: the number N of
%   Axes means the N-th before, -N the same the other way.

turned_point(Axes, Origin, plane(Normal0,D0), plane(Normal,D)) :-
    !,
    maplist(taken_from(Normal0), Axes, Normal),
    foldl(product_added, Normal0, Origin, D0, D).
turned_point(Axes, Origin, Point0, Point) :-
    maplist(less, Point0, Origin, Point1),
    maplist(taken_from(Point1), Axes, Point).

taken_from(Point, Axis, X) :-
    N is abs(Axis),
    nth1(N, Point, X0),
    X is sign(Axis)*X0 + 0.0.

less(X0, Origin, X) :-
    X is X0-Origin.

product_added(A, B, D0, D) :-
    D is D0 + A*B.

%!  screen_point(+View, +EyePoint, -ScreenPoint) is det.
%
%   PL-11: from the eye's coordinates to the picture's. View is `parallel`
%   (PL-11 a) or central(Rho, D, F) (PL-11 b, with S = 1), where D and F are the
%   smallest and largest Ze of the model; if they are equal every depth is 0.

screen_point(parallel, Point, Point).
screen_point(central(Rho,D,F), p(Xe,Ye,Ze0), p(Xs,Ys,Zs)) :-
    Ze is Ze0+Rho,
    W is Ze/D,
    Xs is Xe/W,
    Ys is Ye/W,
    (   F-D =< F*2.0** -40
    ->  Zs = 0.0
    ;   Zs is (Ze/D-1)/(1-D/F)/W
    ).

%!  in_one_place(+Close, +Points0, -Points) is det.
%
%   Points are Points0, p(X,Y) of the picture in their order, each moved to the
%   first before it that was not moved itself and is not farther than Close.

in_one_place(Close, Points0, Points) :-
    foldl(placed(Close), Points0, Points, [], _).

placed(Close, Point, Place, Places, Places) :-
    member(Place, Places),
    near(Close, Point, Place),
    !.
placed(_, Point, Point, Places0, Places) :-
    append(Places0, [Point], Places).

near(Close, p(X0,Y0), p(X,Y)) :-
    (X-X0)*(X-X0) + (Y-Y0)*(Y-Y0) =< Close*Close.

%!  screen_plane(+S, +T, -A, -B, -D) is semidet.
%
%   PL-12: True when A*Xs + B*Ys + Zs + D = 0 is the plane of triangle T in the
%   picture. Fails for a triangle seen edge-on.

screen_plane(S, T, A, B, D) :-
    t(S, _, T, V1, V2, V3),
    screen(S, V1, X1, Y1, Z1),
    screen(S, V2, X2, Y2, Z2),
    screen(S, V3, X3, Y3, Z3),
    Det is (X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1),
    Det =\= 0.0,
    A is ((Y2-Y1)*(Z3-Z1) - (Y3-Y1)*(Z2-Z1)) / Det,
    B is ((X3-X1)*(Z2-Z1) - (X2-X1)*(Z3-Z1)) / Det,
    D is -(A*X1 + B*Y1 + Z1).
