:- module(sg_point_text,
          [ point_texts/4               % +Drawn, +Lights, +Points, -Placed
          ]).
:- use_module('../kernel', [shapes_add/2, shapes_free/3, shapes_open/2]).
:- use_module(lettering, [lettering_width/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Numbers beside points, where there is room for them.

A number stands away from the points near its own, and in this order of what
can be had: beside its point with nothing under it; beside it over light lines;
farther off, with a light line to it; the same over other lines, but never over
another number. All is in thousandths of the sheet, y down, integers.
*/

:- set_prolog_flag(optimise, true).

%   Capitals are so high; so much is free round a number; so large is the circle
%   at a point.

text_height(2000).
clear(300).
circle_radius(500).

%   How far from its point a number may be: beside it, or with a line to it.

beside(900).
beside(1500).
beside(2200).

farther(3500).
farther(5000).
farther(7000).
farther(9500).
farther(12500).
farther(16000).
farther(20000).

%!  point_texts(+Drawn, +Lights, +Points, -Placed) is det.
%
%   Placed is a list of placed(Text, Line) in the order of Points, a list of
%   point(View, X-Y, String): Text as in sheet.pl, Line is [] or the two points
%   of a line to it. Drawn are shapes that are seen well, Lights such that a
%   number may stand on if it must: lists of two to eight points X-Y in order.

point_texts(Drawn, Lights, Points, Placed) :-
    shapes_open(5000, All),
    shapes_open(5000, Seen),
    shapes_open(5000, Taken),
    shapes_open(5000, Texts),
    Shapes = shapes(All, Seen, Taken, Texts),
    forall(member(Shape, Lights), shapes_add(All, Shape)),
    forall(member(Shape, Drawn), ( shapes_add(All, Shape),
                                   shapes_add(Seen, Shape) )),
    forall(member(point(_,P,_), Points), circle_taken(P, Shapes)),
    maplist(text_placed(Shapes, Points), Points, Placed).

circle_taken(X-Y, Shapes) :-
    circle_radius(R),
    box_shape(box(X-R,Y-R,X+R,Y+R), Shape),
    taken(Shape, Shapes).

taken(Shape, shapes(All,Seen,Taken,_)) :-
    shapes_add(All, Shape),
    shapes_add(Seen, Shape),
    shapes_add(Taken, Shape).

box_shape(box(Left0,Top0,Right0,Bottom0),
          [Left-Top,Right-Top,Right-Bottom,Left-Bottom]) :-
    Left is Left0,
    Top is Top0,
    Right is Right0,
    Bottom is Bottom0.

text_placed(Shapes, Points, point(View,P,String), placed(Text,Line)) :-
    text_height(Height),
    lettering_width(String, Height, Width0),
    Width is ceiling(Width0),
    findall(Q, ( member(point(View,Q,_), Points), Q \== P ), Others),
    ways(P, Others, Ways),
    (   place(Ways, P, Width, Others, Shapes, Box0, Line0)
    ->  Box = Box0,
        Line = Line0
    ;   beside(Off),
        Ways = [Way|_],
        way_box(Way, P, Off, Width, Box),
        Line = []
    ),
    !,
    box_clear(Box, Shape),
    text_taken(Shape, Shapes),
    (   Line = [_,_]
    ->  text_taken(Line, Shapes)
    ;   true
    ),
    Box = box(Left,_,Right,Bottom),
    Middle is (Left+Right)//2,
    Text = text(Middle,Bottom,Height,middle,String).

text_taken(Shape, Shapes) :-
    taken(Shape, Shapes),
    Shapes = shapes(_, _, _, Texts),
    shapes_add(Texts, Shape).

%   ways(P, Others, Ways): steps to the right and down, -1 to 1, those first
%   that lead away from Others, near ones above all.

ways(P, Others, Ways) :-
    foldl(pushed(P), Others, 0.0-0.0, U-V),
    findall(Rank-way(I,J),
            ( way(I, J),
              Rank is -round(1.0e9*(I*U + J*V)/sqrt(I*I + J*J)) ),
            Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Ways).

way(I, J) :-
    member(J, [-1.0,-0.5,0.0,0.5,1.0]),
    member(I, [1.0,-1.0,0.5,-0.5,0.0]),
    max(abs(I), abs(J)) =:= 1.

pushed(X-Y, XO-YO, U0-V0, U-V) :-
    DX is X-XO,
    DY is Y-YO,
    Length is sqrt(DX*DX + DY*DY) + 1.0,
    U is U0 + DX/Length**3*1.0e3,
    V is V0 + DY/Length**3*1.0e3.

%   place(Ways, P, Width, Others, Shapes, Box, Line) is nondet: best first.

place(Ways, P, Width, Others, shapes(All,Seen,_,_), Box, []) :-
    member(Free, [All,Seen]),
    beside(Off),
    member(Way, Ways),
    way_box(Way, P, Off, Width, Box),
    box_free(Box, Free),
    off_box(P, Box, Own),
    \+ ( member(Other, Others), off_box(Other, Box, Off1), Off1 < 2*Own ).
place(Ways, P, Width, Others, shapes(_,Seen,Taken,Texts), Box, [P,To]) :-
    member(Free, [Seen,Taken]),
    farther(Off),
    member(Way, Ways),
    way_box(Way, P, Off, Width, Box),
    box_free(Box, Free),
    line_end(P, Box, To),
    shapes_free(Texts, [P,To], 1.0),
    \+ ( member(Other, Others), is_passed(Other, P, To) ).
place(Ways, P, Width, _, shapes(_,_,Taken,_), Box, [P,To]) :-
    farther(Off),
    member(Way, Ways),
    way_box(Way, P, Off, Width, Box),
    box_free(Box, Taken),
    line_end(P, Box, To).

%   is_passed(Q, A, B): Q is hardly off the line from A to B.

is_passed(X-Y, XA-YA, XB-YB) :-
    circle_radius(R),
    DX is XB-XA,
    DY is YB-YA,
    Square is DX*DX + DY*DY,
    T is max(0.0, min(1.0, ((X-XA)*DX + (Y-YA)*DY)/Square)),
    (XA+T*DX-X)**2 + (YA+T*DY-Y)**2 < (R/2)**2.

way_box(way(I,J), X-Y, Off0, Width, box(Left,Top,Right,Bottom)) :-
    text_height(Height),
    (   abs(I*J) =:= 1
    ->  Off is Off0*7//10
    ;   Off = Off0
    ),
    Left is X + round(I*(Off + Width//2)) - Width//2,
    Right is Left+Width,
    Top is Y + round(J*(Off + Height//2)) - Height//2,
    Bottom is Top+Height.

box_clear(box(Left,Top,Right,Bottom), Shape) :-
    clear(Clear),
    box_shape(box(Left-Clear,Top-Clear,Right+Clear,Bottom+Clear), Shape).

box_free(Box, Shapes) :-
    box_clear(Box, Shape),
    shapes_free(Shapes, Shape, 1.0).

%   nearest(P, Box, Q): Q is the point of Box nearest to P.

nearest(X-Y, box(Left,Top,Right,Bottom), XN-YN) :-
    XN is max(Left, min(Right, X)),
    YN is max(Top, min(Bottom, Y)).

off_box(P, Box, Off) :-
    P = X-Y,
    nearest(P, Box, XN-YN),
    Off is (X-XN)**2 + (Y-YN)**2.

%   line_end(P, Box, End): a line from P ends there, almost at Box.

line_end(P, Box, XT-YT) :-
    P = X-Y,
    nearest(P, Box, XN-YN),
    DX is XN-X,
    DY is YN-Y,
    clear(Clear),
    Part is 1 - (Clear+5)/sqrt(DX*DX + DY*DY),
    XT is X + round(Part*DX),
    YT is Y + round(Part*DY).
