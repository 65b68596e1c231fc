:- module(sg_test_laid_flat,
          [ laid_flat/4                 % +Points, +Faces, +Folds, -Lines
          ]).
/** <module> Patterns of small polyhedra, laid out without the engine.

For the test of the checker, which wants right patterns to spoil.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).

%!  laid_flat(+Points, +Faces, +Folds, -Lines) is det.
%
%   Lines are those of tests/pattern_checker/pattern.h, as terms, except for
%   `reported` and `end`. Points are p(X,Y,Z), a face lists its corners,
%   counter-clockwise from outside. Folds are Parent-Child, faces by number;
%   the first parent is laid first, at the origin. root(P,X,Y) among them
%   begins a new piece there. Edges are numbered through the faces.

laid_flat(Points, Faces, Folds, Lines) :-
    foldl(numbered_face, Faces, Numbered, 1-1, _),
    (   Folds = [Root-_|_]
    ->  Steps = [root(Root,0.0,0.0)|Folds]
    ;   Steps = Folds
    ),
    foldl(laid(Numbered, Points), Steps, laid([],[],0,0),
          laid(Places,Joined,_,_)),
    findall(Line, solid_line(Points, Numbered, Line), Lines1),
    findall(Line, flat_line(Numbered, Places, Line), Lines2),
    findall(Line, joint_line(Points, Numbered, Joined, Line), Lines3),
    append([Lines1, Lines2, Lines3], Lines).

%   numbered_face(Corners, face(P, Sides)): a side is side(E, A, B).

numbered_face(Corners, face(P, Sides), P-E0, P1-E) :-
    Corners = [First|Rest],
    append(Rest, [First], Nexts),
    foldl(numbered_side, Corners, Nexts, Sides, E0, E),
    P1 is P+1.

numbered_side(A, B, side(E,A,B), E, E1) :-
    E1 is E+1.

                /*******************************
                *            LAYING            *
                *******************************/

%   laid(.., Step, Laid0, Laid): Laid is laid(Places, Joined, W, K): places
%   are place(P, K, V, W, X-Y), vertex W of the pattern; Joined are edges
%   E1-E2; W and K are the last numbers of a vertex and of a piece.

laid(Numbered, Points, root(P,X0,Y0), laid(Places0,Joined,W0,K0),
     laid(Places,Joined,W,K)) :-
    !,
    K is K0+1,
    memberchk(face(P, Sides), Numbered),
    Sides = [side(_, A, B)|_],
    difference(Points, A, B, D),
    size(D, Length),
    X1 is X0+Length,
    W1 is W0+1,
    W2 is W0+2,
    Known = [ place(P,K,A,W1,X0-Y0), place(P,K,B,W2,X1-Y0) ],
    face_places(Points, face(P, Sides), Known, W2, W, Places0, Places).
laid(Numbered, Points, Parent-Child, laid(Places0,Joined,W0,K),
     laid(Places,[E1-E2|Joined],W,K)) :-
    memberchk(face(Parent, Sides), Numbered),
    memberchk(face(Child, Others), Numbered),
    member(side(E1, A, B), Sides),
    memberchk(side(E2, B, A), Others),
    !,
    memberchk(place(Parent,K1,A,Wa,AtA), Places0),
    memberchk(place(Parent,_,B,Wb,AtB), Places0),
    Known = [ place(Child,K1,A,Wa,AtA), place(Child,K1,B,Wb,AtB) ],
    face_places(Points, face(Child, Others), Known, W0, W, Places0, Places).

%   face_places(Points, Face, Known, ..): the other corners, too.

face_places(Points, face(P, Sides), Known, W0, W, Places0, Places) :-
    Known = [ place(_,K,A,_,Xa-Ya), place(_,_,B,_,Xb-Yb) ],
    difference(Points, A, B, D0),
    size(D0, Length),
    unit(D0, U),
    normal(Points, Sides, N),
    cross(N, U, Left),
    C is (Xb-Xa)/Length,
    S is (Yb-Ya)/Length,
    findall(V-(X-Y),
            ( member(side(_, V, _), Sides),
              V =\= A,
              V =\= B,
              difference(Points, A, V, D),
              dot(D, U, Along),
              dot(D, Left, Off),
              X is Xa+Along*C-Off*S,
              Y is Ya+Along*S+Off*C ),
            New),
    foldl(new_place(P, K), New, Others, W0, W),
    append([Known, Others, Places0], Places).

new_place(P, K, V-At, place(P,K,V,W,At), W0, W) :-
    W is W0+1.

                /*******************************
                *             LINES            *
                *******************************/

solid_line(Points, _, v(V,X,Y,Z)) :-
    nth1(V, Points, p(X0,Y0,Z0)),
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0).
solid_line(_, Numbered, e(E,A,B)) :-
    member(face(_, Sides), Numbered),
    member(side(E, A, B), Sides).
solid_line(_, Numbered, p(P,Es)) :-
    member(face(P, Sides), Numbered),
    findall(E, member(side(E, _, _), Sides), Es).
solid_line(_, Numbered, t(P,A,B,C)) :-
    member(face(P, [side(_, A, _)|Sides]), Numbered),
    append(_, [side(_, B, C),_|_], Sides).

flat_line(_, Places, 'V'(W,X,Y,V)) :-
    findall(W-V, member(place(_,_,V,W,_), Places), Pairs0),
    sort(Pairs0, Pairs),
    member(W-V, Pairs),
    once(member(place(_,_,V,W,X-Y), Places)).
flat_line(Numbered, Places, 'E'(E,Wa,Wb,E)) :-
    laid_face(Numbered, Places, P, _, Sides),
    member(side(E, A, B), Sides),
    memberchk(place(P,_,A,Wa,_), Places),
    memberchk(place(P,_,B,Wb,_), Places).
flat_line(Numbered, Places, 'P'(P,P,K,Es)) :-
    laid_face(Numbered, Places, P, K, Sides),
    findall(E, member(side(E, _, _), Sides), Es).

laid_face(Numbered, Places, P, K, Sides) :-
    member(face(P, Sides), Numbered),
    memberchk(place(P,K,_,_,_), Places).

joint_line(Points, Numbered, Joined, 'J'(E1,E2,Kind,Angle)) :-
    member(face(P1, Sides1), Numbered),
    member(side(E1, A, B), Sides1),
    A < B,
    member(face(P2, Sides2), Numbered),
    P2 =\= P1,
    member(side(E2, B, A), Sides2),
    (   ( memberchk(E1-E2, Joined) ; memberchk(E2-E1, Joined) )
    ->  Kind = fold
    ;   Kind = seam
    ),
    normal(Points, Sides1, N1),
    normal(Points, Sides2, N2),
    difference(Points, A, B, D),
    unit(D, U),
    cross(N1, N2, N),
    dot(N, U, Sine),
    dot(N1, N2, Cosine),
    Angle is atan2(Sine, Cosine)*180/pi.

                /*******************************
                *            VECTORS           *
                *******************************/

difference(Points, A, B, v(X,Y,Z)) :-
    nth1(A, Points, p(Xa,Ya,Za)),
    nth1(B, Points, p(Xb,Yb,Zb)),
    X is Xb-Xa,
    Y is Yb-Ya,
    Z is Zb-Za.

dot(v(A,B,C), v(D,E,F), Product) :-
    Product is A*D+B*E+C*F.

size(V, Size) :-
    dot(V, V, Square),
    Size is sqrt(Square).

cross(v(A,B,C), v(D,E,F), v(X,Y,Z)) :-
    X is B*F-C*E,
    Y is C*D-A*F,
    Z is A*E-B*D.

unit(V, v(X,Y,Z)) :-
    V = v(A,B,C),
    size(V, Size),
    X is A/Size,
    Y is B/Size,
    Z is C/Size.

normal(Points, Sides, N) :-
    Sides = [side(_, O, _)|_],
    foldl(added(Points, O), Sides, v(0,0,0), Sum),
    unit(Sum, N).

added(Points, O, side(_, A, B), v(X0,Y0,Z0), v(X,Y,Z)) :-
    difference(Points, O, A, Va),
    difference(Points, O, B, Vb),
    cross(Va, Vb, v(Xc,Yc,Zc)),
    X is X0+Xc,
    Y is Y0+Yc,
    Z is Z0+Zc.
