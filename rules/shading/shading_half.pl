:- module(sg_shading_half,
          [ half_leaf/3                 % +Plane, +Box, -Half
          ]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [append/2, nth1/3, select/3]).
/** <module> A half-space as a leaf of a shaded picture.

It is what is below the plane in a box a little larger than what it cuts. So it
is in front of the eye where that is, and only its plane is ever seen.
*/

%!  half_leaf(+Plane, +Box, -Half) is det.
%
%   Half is flat(Points, [], Polygons) for what is below Plane = plane(A,B,C,D)
%   in and round Box = box(X1,Y1,Z1,X2,Y2,Z2), its face 1 in the plane; or `all`
%   or `none`, if the plane passes at a distance.

half_leaf(plane(A0,B0,C0,D0), Box0, Half) :-
    maplist(float_of, [A0,B0,C0,D0], Plane),
    larger_box(Box0, Box),
    findall(P, corner(Box, P), Corners),
    maplist(height(Plane), Corners, Heights),
    (   maplist(=<(0.0), Heights)
    ->  Half = none
    ;   maplist(>(0.0), Heights)
    ->  Half = all
    ;   findall(Face, box_face(Face), Faces),
        cut_faces(Faces, Corners, Heights, Kept, Cap),
        indexed([Cap|Kept], Half)
    ).

float_of(X, F) :-
    F is float(X).

larger_box(box(X1,Y1,Z1,X2,Y2,Z2), box(X3,Y3,Z3,X4,Y4,Z4)) :-
    Most is max(X2-X1, max(Y2-Y1, Z2-Z1)) / 64.0 + 1.0e-300,
    X3 is X1-Most, Y3 is Y1-Most, Z3 is Z1-Most,
    X4 is X2+Most, Y4 is Y2+Most, Z4 is Z2+Most.

corner(box(X1,Y1,Z1,X2,Y2,Z2), point(X,Y,Z)) :-
    member_of(Z1, Z2, Z),
    member_of(Y1, Y2, Y),
    member_of(X1, X2, X).

member_of(A, _, A).
member_of(_, B, B).

%   box_face(Face): corners counter-clockwise from outside, as corner/2 numbers
%   them: 1 + (x) + 2*(y) + 4*(z).

box_face([1,3,4,2]).
box_face([5,6,8,7]).
box_face([1,2,6,5]).
box_face([3,7,8,4]).
box_face([1,5,7,3]).
box_face([2,4,8,6]).

height([A,B,C,D], point(X,Y,Z), Height) :-
    Height is A*X + B*Y + C*Z + D.

%   cut_faces(Faces, Corners, Heights, Kept, Cap): Kept are loops of points, Cap
%   the loop that closes them.

cut_faces(Faces, Corners, Heights, Kept, Cap) :-
    foldl(cut_face(Corners, Heights), Faces, []-[], Kept-Sides),
    Sides = [From-To|Rest],
    loop_of(Rest, From, To, Cap).

cut_face(Corners, Heights, Face, Kept0-Sides0, Kept-Sides) :-
    Face = [First|_],
    walked(Face, First, Corners, Heights, Points, Ends),
    (   Points == []
    ->  Kept = Kept0
    ;   Kept = [Points|Kept0]
    ),
    (   Ends = [leave(P),enter(Q)]
    ->  Sides = [Q-P|Sides0]            % the cap runs the other way
    ;   Ends = [enter(Q),leave(P)]
    ->  Sides = [Q-P|Sides0]
    ;   Sides = Sides0
    ).

%   walked(Face, First, Corners, Heights, Points, Ends): round what is below.

walked([I|Is], First, Corners, Heights, Points, Ends) :-
    (   Is = [J|_]
    ->  true
    ;   J = First
    ),
    nth1(I, Corners, P),
    nth1(I, Heights, H),
    nth1(J, Corners, Q),
    nth1(J, Heights, G),
    (   H < 0.0
    ->  Points = [P|Points1]
    ;   Points = Points1
    ),
    (   H < 0.0, G >= 0.0
    ->  between(P, H, Q, G, R),
        Points1 = [R|Points2],
        Ends = [leave(R)|Ends1]
    ;   H >= 0.0, G < 0.0
    ->  between(Q, G, P, H, R),
        Points1 = [R|Points2],
        Ends = [enter(R)|Ends1]
    ;   Points2 = Points1,
        Ends1 = Ends
    ),
    (   Is == []
    ->  Points2 = [],
        Ends1 = []
    ;   walked(Is, First, Corners, Heights, Points2, Ends1)
    ).

%   between(P, H, Q, G, R): R is in the plane, P below it.

between(point(X1,Y1,Z1), H, point(X2,Y2,Z2), G, point(X,Y,Z)) :-
    Part is H/(H-G),
    X is X1 + Part*(X2-X1),
    Y is Y1 + Part*(Y2-Y1),
    Z is Z1 + Part*(Z2-Z1).

loop_of(Sides, First, At, [At|Loop]) :-
    (   select(At-Next, Sides, Rest),
        Next \== First
    ->  loop_of(Rest, First, Next, Loop)
    ;   Loop = [First]
    ).

%   indexed(Loops, Half): with places of their points, each once.

indexed(Loops, flat(Points,[],Polygons)) :-
    append(Loops, All),
    sort(All, Points),
    foldl(polygon_of(Points), Loops, 1-[], _-Polygons).

polygon_of(Points, Loop, F-Polygons, G-[polygon(F,0,[Is])|Polygons]) :-
    maplist(place_in(Points), Loop, Is),
    G is F+1.

place_in(Points, P, I) :-
    once(nth1(I, Points, P)).
