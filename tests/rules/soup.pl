:- module(sg_test_soup,
          [ soup/2,                     % +Seed, -Soup
            soup_facts/2,               % +Soup, -Facts
            soup_obj/2                  % +Soup, -Text
          ]).
/** <module> Random soups: models as bad as they come, small and seeded.

A soup is a list of piece(S, Kind, Points, Faces, Chain): Points a list of
p(X,Y,Z), Faces lists of corners counted from 1 (in a box with a hole with a
minus sign for the jump), Chain the corners of a curve. Nothing is promised:
soups are open, non-manifold, flat, doubled, touch themselves, and their
coordinates go from denormals to 1e300, sometimes in one triangle.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).

%!  soup(+Seed:integer, -Soup:list) is det.
%
%   The same Seed gives the same Soup.

soup(Seed, Soup) :-
    set_random(seed(Seed)),
    style(Style),
    pick([1-1, 6-2, 2-3, 1-4], N),
    findall(S, between(1, N, S), Ss),
    foldl(piece(Style), Ss, [], Reversed),
    reverse(Reversed, Soup).

%   pick(+Weighted, -Value): one of the Weight-Value.

pick(Weighted, Value) :-
    foldl([W-_,A,B]>>(B is A+W), Weighted, 0, Sum),
    Ticket is random(Sum),
    picked(Weighted, Ticket, Value).

picked([Weight-Value0|Rest], Ticket, Value) :-
    (   Ticket < Weight
    ->  Value = Value0
    ;   Ticket1 is Ticket-Weight,
        picked(Rest, Ticket1, Value)
    ).

one_of(List, Member) :-
    length(List, N),
    I is random(N),
    nth0(I, List, Member).

/* - - - coordinates - - - */

%   A style is how the coordinates of a whole soup are drawn.

style(Style) :-
    pick([6-grid(2), 3-grid(4), 3-tenths, 3-real, 2-near, 2-wild, 1-scale,
          1-extreme, 1-beyond], Style0),
    (   Style0 == scale
    ->  Exponent is random(390)-300,
        Scale is 10.0**Exponent,
        Style = scaled(Scale)
    ;   Style = Style0
    ).

coordinate(grid(N), X) :-
    X is float(random(2*N+1)-N).
coordinate(tenths, X) :-
    X is (random(21)-10)/10.0.
coordinate(real, X) :-
    X is 2.0*random_float-1.0.
coordinate(near, X) :-
    X0 is float(random(5)-2),
    nudged(X0, X).
coordinate(wild, X) :-
    X is (random(7)-3)*10.0**(random(33)-16).
coordinate(scaled(Scale), X) :-
    X is (random(5)-2)*Scale.
coordinate(extreme, X) :-
    one_of([0.0, -0.0, 1.0, -1.0, 2.0, 5.0e-324, -5.0e-324, 2.0e-308, 1.0e-300,
            -3.0e-300, 1.0e-154, 1.0e90, -1.0e90, 3.0e89, 1.0e-90, 1.0e16,
            0.1], X).
coordinate(beyond, X) :-
    one_of([0.0, 1.0, -1.0, 2.0, 1.0e-300, 1.0e90, -1.0e91, 1.0e154, 1.0e300,
            -8.0e307], X).

%   A few units in the last place off, or not.

nudged(X0, X) :-
    N is random(7),
    (   N =:= 0
    ->  X is nexttoward(X0, 9)
    ;   N =:= 1
    ->  X is nexttoward(X0, -9)
    ;   N =:= 2
    ->  X is X0+1.0e-12
    ;   X = X0
    ).

point(Style, p(X,Y,Z)) :-
    coordinate(Style, X),
    coordinate(Style, Y),
    coordinate(Style, Z).

points(N, Style, Points) :-
    length(Points, N),
    maplist(point(Style), Points).

/* - - - pieces - - - */

piece(Style, S, Before, [piece(S, Kind, Points, Faces, Chain)|Before]) :-
    (   Before \== [],
        random(5) =:= 0
    ->  Shape = copy
    ;   pick([5-soup, 3-tetrahedron, 3-box, 2-flat, 1-hollow, 2-curve, 2-fan,
              1-needles],
             Shape)
    ),
    shape(Shape, Style, Before, Kind, Points0, Faces0, Chain),
    doubled(Faces0, Faces),
    isolated(Style, Points0, Points).

doubled(Faces0, Faces) :-
    (   Faces0 \== [],
        random(6) =:= 0
    ->  one_of(Faces0, Face),
        append(Faces0, [Face], Faces)
    ;   Faces = Faces0
    ).

isolated(Style, Points0, Points) :-
    (   random(8) =:= 0
    ->  point(Style, P),
        append(Points0, [P], Points)
    ;   Points = Points0
    ).

shape(soup, Style, _, surface, Points, Faces, []) :-
    N is 3+random(5),
    points(N, Style, Points),
    M is 1+random(6),
    length(Faces, M),
    maplist(any_face(N), Faces).
shape(tetrahedron, Style, _, Kind, Points, Faces, []) :-
    pick([3-solid, 1-surface], Kind),
    points(4, Style, Points),
    Faces = [[1,3,2], [1,2,4], [2,3,4], [3,1,4]].
shape(box, Style, _, Kind, Points, Faces, []) :-
    pick([3-solid, 1-surface], Kind),
    box_points(Style, Points),
    Faces0 = [[1,4,3,2], [5,6,7,8], [1,2,6,5], [2,3,7,6], [3,4,8,7], [4,1,5,8]],
    (   random(4) =:= 0
    ->  one_of(Faces0, Face),
        delete(Faces0, Face, Faces)
    ;   Faces = Faces0
    ).
shape(flat, Style, _, surface, Points, Faces, []) :-
    N is 4+random(6),
    plane_map(Style, Map),
    length(Points, N),
    maplist(flat_point(Map), Points),
    numlist(1, N, Face),
    (   random(3) =:= 0
    ->  M is 3+random(5),
        length(Face2, M),
        maplist(corner(N), Face2),
        Faces = [Face,Face2]
    ;   Faces = [Face]
    ).
shape(hollow, Style, _, surface, Points, [[1,2,3,4,1,-5,6,7,8,5]], []) :-
    plane_map(Style, Map),
    maplist(mapped(Map), [-2-(-2), 2-(-2), 2-2, -2-2], Outer),
    length(Inner, 4),
    maplist(flat_point(Map), Inner),
    append(Outer, Inner, Points).
shape(curve, Style, _, curve, Points, [], Chain) :-
    N is 2+random(4),
    points(N, Style, Points),
    numlist(1, N, Chain0),
    (   random(3) =:= 0
    ->  append(Chain0, [1], Chain)
    ;   Chain = Chain0
    ).
shape(fan, Style, _, surface, Points, Faces, []) :-
    N is 4+random(5),
    points(N, Style, Points),
    findall([1,A,B], ( between(3, N, B), A is B-1 ), Faces).
shape(needles, Style, _, surface, Points, Faces, []) :-
    points(2, Style, [A,B]),
    length(Near, 3),
    maplist(near_line(A, B), Near),
    append([A,B], Near, Points),
    Faces = [[1,2,3], [1,4,2], [3,4,5], [5,2,1]].
shape(copy, Style, Before, Kind, Points, Faces, Chain) :-
    one_of(Before, piece(_, Kind, Points0, Faces0, Chain)),
    pick([3-same, 2-nudge, 2-some, 1-turned], How),
    copied(How, Style, Points0, Points),
    (   How == turned
    ->  maplist(reverse_face, Faces0, Faces)
    ;   Faces = Faces0
    ).

reverse_face(Face, Turned) :-
    (   member(V, Face),
        V < 0
    ->  Turned = Face
    ;   reverse(Face, Turned)
    ).

copied(same, _, Points, Points).
copied(turned, _, Points, Points).
copied(nudge, _, Points0, Points) :-
    maplist(nudge_point, Points0, Points).
copied(some, Style, Points0, Points) :-
    maplist(some_new(Style), Points0, Points).

nudge_point(p(X0,Y0,Z0), p(X,Y,Z)) :-
    nudged(X0, X),
    nudged(Y0, Y),
    nudged(Z0, Z).

some_new(Style, P0, P) :-
    (   random(3) =:= 0
    ->  point(Style, P)
    ;   P = P0
    ).

any_face(N, Face) :-
    pick([8-3, 3-4, 1-5], M),
    length(Face, M),
    maplist(corner(N), Face).

corner(N, V) :-
    V is 1+random(N).

box_points(Style, Points) :-
    point(Style, p(X1,Y1,Z1)),
    point(Style, p(X2,Y2,Z2)),
    Points = [p(X1,Y1,Z1), p(X2,Y1,Z1), p(X2,Y2,Z1), p(X1,Y2,Z1),
              p(X1,Y1,Z2), p(X2,Y1,Z2), p(X2,Y2,Z2), p(X1,Y2,Z2)].

%   A plane in space, and points of a small grid in it.

plane_map(Style, map(O, U, W)) :-
    point(Style, O),
    (   random(2) =:= 0
    ->  U = p(1.0,0.0,0.0),
        W = p(0.0,1.0,0.0)
    ;   point(Style, U),
        point(Style, W)
    ).

flat_point(Map, P) :-
    A is random(5)-2,
    B is random(5)-2,
    mapped(Map, A-B, P).

mapped(map(p(X0,Y0,Z0), p(X1,Y1,Z1), p(X2,Y2,Z2)), A-B, p(X,Y,Z)) :-
    bounded(X0+A*X1+B*X2, X),
    bounded(Y0+A*Y1+B*Y2, Y),
    bounded(Z0+A*Z1+B*Z2, Z).

bounded(Expression, X) :-
    catch(X is Expression, error(evaluation_error(_), _), X = 1.0e300).

near_line(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    T is random(9)/8.0,
    near_value(X1, X2, T, X),
    near_value(Y1, Y2, T, Y),
    near_value(Z1, Z2, T, Z).

near_value(A, B, T, X) :-
    bounded(A+T*(B-A), X0),
    nudged(X0, X).

/* - - - as facts, as a mesh - - - */

%!  soup_facts(+Soup, -Facts) is det.
%
%   Facts of a model file: segment/3, v/5, p/3 with vertex lists, curve/2.

soup_facts(Soup, Facts) :-
    maplist(piece_facts, Soup, Lists),
    append(Lists, Facts).

piece_facts(piece(S, Kind, Points, Faces, Chain), Facts) :-
    findall(v(S,V,X,Y,Z), nth1(V, Points, p(X,Y,Z)), Vs),
    findall(p(S,P,Face), nth1(P, Faces, Face), Ps),
    (   Chain == []
    ->  Cs = []
    ;   Cs = [curve(S, Chain)]
    ),
    append([[segment(S, Kind, soup)], Vs, Ps, Cs], Facts).

%!  soup_obj(+Soup, -Text:string) is det.
%
%   The same as an OBJ file, without holes.

soup_obj(Soup, Text) :-
    with_output_to(string(Text), foldl(obj_piece, Soup, 0, _)).

obj_piece(piece(S, _, Points, Faces, Chain), Base0, Base) :-
    format("o piece~d~n", [S]),
    forall(member(p(X,Y,Z), Points), format("v ~w ~w ~w~n", [X,Y,Z])),
    forall(( member(Face, Faces), \+ ( member(V, Face), V < 0 ) ),
           obj_element(f, Base0, Face)),
    (   Chain == []
    ->  true
    ;   obj_element(l, Base0, Chain)
    ),
    length(Points, N),
    Base is Base0+N.

obj_element(Letter, Base, Vs) :-
    write(Letter),
    forall(member(V, Vs), ( N is Base+V, format(" ~d", [N]) )),
    nl.
