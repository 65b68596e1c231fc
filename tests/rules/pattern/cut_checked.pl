/* An independent look at sheets that are to be cut: nothing of it is shared
   with the rules. All in integers, so exact. */
:- module(test_cut_checked,
          [ cut_fault/2                 % +Drawing, -Fault
          ]).
:- use_module(library(lists)).
:- use_module(library(apply)).

%!  cut_fault(+Drawing, -Fault) is nondet.
%
%   Something is wrong with what a drawing cuts: crossing(View1,View2), lines
%   that go through each other; inside(View1,View2), a piece within another;
%   twice(A,B), a line, or a part of one, that is drawn twice; off(View), beyond
%   the sheet.

cut_fault(drawing(_,Views), crossing(V1,V2)) :-
    sides(Views, Sides0),
    predsort([O,side(_,X1,A,B),side(_,X2,C,D)]>>compare(O,X1-A-B,X2-C-D),
             Sides0, Sides),
    append(_, [side(V1,_,A,B)|Rest], Sides),
    right_end(A, B, Right),
    near(Rest, Right, side(V2,_,C,D)),
    crosses(A, B, C, D).
cut_fault(drawing(_,Views), twice(A,B)) :-
    findall(Key, ( member(view(_,Strokes,_), Views),
                   member(stroke(_,Role,_,_,Points,_,_), Strokes),
                   memberchk(Role, [cut,fold_up,fold_down,penetration_line]),
                   append(_, [A,B|_], Points),
                   msort([A,B], Key) ),
            Keys0),
    msort(Keys0, Keys),
    append(_, [[A,B],[A,B]|_], Keys).
cut_fault(drawing(_,Views), twice(A,B)) :-
    sides(Views, Sides0),
    sort(2, @=<, Sides0, Sides),
    append(_, [side(_,_,A,B)|Rest], Sides),
    right_end(A, B, Right),
    near(Rest, Right, side(_,_,C,D)),
    lies_along(A, B, C, D).
cut_fault(drawing(_,Views), inside(V1,V2)) :-
    member(view(V1,Strokes1,_), Views),
    member(view(V2,Strokes2,_), Views),
    V1 \== V2,
    once(member(stroke(_,cut,_,_,[X-Y|_],_,_), Strokes1)),
    findall(P-Q, ( member(stroke(_,cut,_,_,Points,_,_), Strokes2),
                   append(_, [P,Q|_], Points) ),
            Edges),
    include(above(X-Y), Edges, Crossed),
    length(Crossed, N),
    N mod 2 =:= 1.
cut_fault(drawing(sheet(W,H,_),Views), off(View)) :-
    member(view(View,Strokes,_), Views),
    member(stroke(_,_,_,_,Points,_,_), Strokes),
    member(X-Y, Points),
    ( X < 0 ; Y < 0 ; X > W ; Y > H ),
    !.

sides(Views, Sides) :-
    findall(side(View,X,A,B),
            ( member(view(View,Strokes,_), Views),
              member(stroke(_,cut,_,_,Points,_,_), Strokes),
              append(_, [A,B|_], Points),
              A = XA-_,
              B = XB-_,
              X is min(XA,XB)
            ),
            Sides).

right_end(XA-_, XB-_, Right) :-
    Right is max(XA, XB).

near([Side|Sides], Right, Near) :-
    Side = side(_, X, _, _),
    X =< Right,
    ( Near = Side ; near(Sides, Right, Near) ).

%   Both ends of C-D are within two thousandths of a millimetre of the line
%   through A-B, and over 20 thousandths of it lie along A-B.

lies_along(A, B, C, D) :-
    A = XA-YA,
    B = XB-YB,
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Length > 20,
    maplist(beside_line(A, B, Length), [C,D], [S,T]),
    Over is min(Length, max(S, T)) - max(0, min(S, T)),
    Over > 20.

beside_line(XA-YA, XB-YB, Length, X-Y, Along) :-
    abs((XB-XA)*(Y-YA) - (YB-YA)*(X-XA)) =< 2*Length,
    Along is ((XB-XA)*(X-XA) + (YB-YA)*(Y-YA))/Length.

turn(XA-YA, XB-YB, XC-YC, Sign) :-
    Sign is sign((XB-XA)*(YC-YA) - (YB-YA)*(XC-XA)).

%   Properly: ends that touch do not cross. One unit, a thousandth of a
%   millimetre, may be rounding.

crosses(A, B, C, D) :-
    turn(A, B, C, S1), turn(A, B, D, S2), S1*S2 < 0,
    turn(C, D, A, S3), turn(C, D, B, S4), S3*S4 < 0,
    deep(A, B, C), deep(A, B, D), deep(C, D, A), deep(C, D, B).

deep(XA-YA, XB-YB, XC-YC) :-
    Area is abs((XB-XA)*(YC-YA) - (YB-YA)*(XC-XA)),
    Area*Area > 9*((XB-XA)**2 + (YB-YA)**2).

above(X-Y, (XA-YA)-(XB-YB)) :-
    (   XA =< X, XB > X
    ->  S = 1
    ;   XB =< X, XA > X
    ->  S = -1
    ),
    S*((XB-XA)*(Y-YA) - (YB-YA)*(X-XA)) > 0.
