:- module(test_pattern_face, []).
:- use_module(library(plunit)).
:- use_module(rules(pattern/pattern_face)).

/* Faces of texts: made once, wherever a place has them. */

square(X, [X-0,X1-0,X1-10,X-10]) :-
    X1 is X+10.

:- begin_tests(pattern_face).

test(shared, Faces == [same,same,other]) :-
    square(0, A),
    square(20, B),
    text_faces([ want(r,1,"a",[2],end_of(0-0,1-0,[A])),
                 want(r,1,"b",[2],first_of([ along(0-0,1-0),
                                             over_lines(within_any([A])) ])),
                 want(r,1,"c",[2],over_folds(within([B]))) ], Faced),
    Faced = [ want(_,_,_,_,end_of(_,_,Face1)),
              want(_,_,_,_,first_of([ along(_,_),
                                      over_lines(within_any(Face2)) ])),
              want(_,_,_,_,over_folds(within(Face3))) ],
    findall(Is,
            ( member(Face, [Face1,Face2,Face3]),
              ( Face == Face1 -> Is = same ; Is = other ) ),
            Faces).
test(points, Points == [5-5,10-0]) :-
    square(0, A),
    text_faces([want(r,1,"a",[2],middle_of([],[A]))],
               [want(_,_,_,_,middle_of(_,Face))]),
    include(face_point(Face), [5-5,10-0,10.001-0,-1-5], Points).
test(middle_and_way, Middle-Along == (10.0-2.5)-true) :-
    text_faces([want(r,1,"a",[2],within([[0-0,20-0,20-5,0-5]]))],
               [want(_,_,_,_,within(face(_,[Middle|_],U-V)))]),
    ( U =:= 1, V =:= 0 -> Along = true ; Along = false ).
test(no_side, Way == 1.0-0.0) :-
    text_faces([want(r,1,"a",[2],within([]))],
               [want(_,_,_,_,within(face(_,[],Way)))]).
test(upright, Way == 1.0-0.0) :-
    upright_way(-1.0, -0.0, Way0),
    Way0 = U-V,
    V0 is V+0.0,
    Way = U-V0.
test(first, Firsts == [[a,b],[a],[]]) :-
    findall(First, ( member(N-L, [2-[a,b,c],2-[a],0-[a]]),
                     first_of(N, L, First) ), Firsts).

:- end_tests(pattern_face).
