/* Patterns by hand, in the form that development.pl makes them. */
:- module(test_pattern_case,
          [ cube_pattern/1,             % +Side
            plate_pattern/2,            % +Width, +Height
            strip_pattern/3,            % +Count, +Width, +Height
            pattern_from_faces/1        % +Faces
          ]).
:- use_module(library(lists)).
:- use_module(rules(store)).

%!  pattern_from_faces(+Faces) is det.
%
%   Pattern 2 of solid 1: Faces are face(P, Vs, Points, K), Vs vertices of the
%   solid, Points where they come to lie, in piece K. Edges whose ends are the
%   same other way round are partners; they are a fold if they lie on each
%   other. Edge I of polygon P is P*100+I.

pattern_from_faces(Faces) :-
    facts_transaction(test_pattern_case:pattern_facts(Faces)).

pattern_facts(Faces) :-
    assert_fact(segment(2, pattern, development(1))),
    findall(K-(X-Y), ( member(face(_,_,Ps,K), Faces), member(X-Y, Ps) ), Ws0),
    sort(Ws0, Ws),
    forall(nth1(W, Ws, _-(X-Y)),
           ( FX is float(X), FY is float(Y),
             assert_fact(v(2,W,FX,FY,0.0)) )),
    forall(member(Face, Faces), face_facts(Face, Ws)),
    findall(side(E,K,A-B,P-Q), face_side(Faces, E, K, A-B, P-Q), Sides),
    findall(pair(E1,E2,Kind),
            ( member(side(E1,K1,A-B,P1-Q1), Sides),
              member(side(E2,K2,B-A,P2-Q2), Sides),
              E1 < E2,
              (   K1 == K2, P1 == Q2, Q1 == P2
              ->  Kind = fold
              ;   Kind = seam
              )
            ),
            Pairs),
    forall(nth1(J, Pairs, pair(E1,E2,Kind)),
           assert_fact(joint(2,J,E1,E2,Kind,90.0))).

face_facts(face(P,Vs,Ps,K), Ws) :-
    findall(W, ( member(Point, Ps), nth1(W, Ws, K-Point) ), Own),
    forall(( nth1(I, Own, W), nth1(I, Vs, V), \+ from_v(2,W,1,V) ),
           assert_fact(from_v(2,W,1,V))),
    length(Own, N),
    findall(E, ( between(1, N, I), E is P*100+I ), Es),
    forall(nth1(I, Es, E),
           ( nth1(I, Own, A), J is I mod N + 1, nth1(J, Own, B),
             assert_fact(e(2,E,A,B,1)) )),
    assert_fact(p(2,P,Es)),
    assert_fact(plane(2,P,0.0,0.0,1.0,0.0)),
    assert_fact(piece(2,P,K)),
    Own = [A|Rest],
    forall(( append(Before, [B,C|_], Rest), length(Before, L) ),
           ( T is P*100+L+1, assert_fact(t(2,P,T,A,B,C)) )).

face_side(Faces, E, K, A-B, P-Q) :-
    member(face(F,Vs,Ps,K), Faces),
    length(Vs, N),
    nth1(I, Vs, A),
    J is I mod N + 1,
    nth1(J, Vs, B),
    nth1(I, Ps, P),
    nth1(J, Ps, Q),
    E is F*100+I.

%!  cube_pattern(+Side) is det.
%
%   The cross: 6 faces, 5 folds, 7 seams. Vertices as in facts/cube.pl.

cube_pattern(A) :-
    B is 2*A, C is 3*A, D is 4*A, M is -A,
    pattern_from_faces(
        [ face(1, [4,3,2,1], [0-M,A-M,A-0,0-0], 1),
          face(2, [5,6,7,8], [0-A,A-A,A-B,0-B], 1),
          face(3, [1,2,6,5], [0-0,A-0,A-A,0-A], 1),
          face(4, [2,3,7,6], [A-0,B-0,B-A,A-A], 1),
          face(5, [3,4,8,7], [B-0,C-0,C-A,B-A], 1),
          face(6, [4,1,5,8], [C-0,D-0,D-A,C-A], 1)
        ]).

%!  plate_pattern(+Width, +Height) is det.
%
%   A single face.

plate_pattern(W, H) :-
    pattern_from_faces([face(1, [1,2,3,4], [0-0,W-0,W-H,0-H], 1)]).

%!  strip_pattern(+Count, +Width, +Height) is det.
%
%   Count faces side by side, each Width wide, the first and the last joined by
%   a seam: a prism without ends.

strip_pattern(N, W, H) :-
    findall(face(I,[A,B,C,D],[X1-0,X2-0,X2-H,X1-H],1),
            ( between(1, N, I),
              A = I, B is I mod N + 1, C is B+N, D is A+N,
              X1 is (I-1)*W, X2 is I*W
            ),
            Faces),
    pattern_from_faces(Faces).
