/* Dashed lines that cross: each has a dash at the crossing, whatever its ends,
   and all of its way is dashes and gaps of about the length that was asked. */
:- module(test_crossing, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(yall)).
:- use_module(library(plunit)).
:- use_module(rules(drawing/travel)).
:- use_module(rules(sheet/crossing)).
:- use_module(rules(sheet/dash)).
:- use_module(tests('rules/sample')).

hidden(Points, Start, End, stroke(hidden,crease,1,[],Points,Start,End)).

%   random_strokes(Seed, Strokes): lines of two to five points, and rings.

random_strokes(Seed, Strokes) :-
    set_random(seed(Seed)),
    random_between(2, 12, N),
    length(Strokes, N),
    maplist(random_stroke, Strokes).

random_stroke(Stroke) :-
    random_between(2, 5, N),
    length(Points0, N),
    maplist(random_point, Points0),
    random_member(Kind, [line,line,ring]),
    (   Kind == ring,
        N > 2
    ->  Points0 = [First|_],
        append(Points0, [First], Points),
        hidden(Points, ring, ring, Stroke)
    ;   random_member(Start, [joint,cut]),
        random_member(End, [joint,cut]),
        hidden(Points0, Start, End, Stroke)
    ).

random_point(X-Y) :-
    random_between(0, 60000, X),
    random_between(0, 60000, Y).

%   crossed_at(Strokes, K, X-Y): a piece of stroke K crosses another one there,
%   by a way of its own: both lines as equations.

crossed_at(Strokes, K, X-Y) :-
    nth1(K, Strokes, stroke(_,_,_,_,Ps,_,_)),
    nth1(L, Strokes, stroke(_,_,_,_,Qs,_,_)),
    K =\= L,
    nextto(X1-Y1, X2-Y2, Ps),
    nextto(X3-Y3, X4-Y4, Qs),
    A1 is Y2-Y1, B1 is X1-X2, C1 is A1*X1+B1*Y1,
    A2 is Y4-Y3, B2 is X3-X4, C2 is A2*X3+B2*Y3,
    D is A1*B2-A2*B1,
    abs(D) > 0.2*sqrt((A1*A1+B1*B1)*(A2*A2+B2*B2)),
    X is (C1*B2-C2*B1)/D,
    Y is (A1*C2-A2*C1)/D,
    within(X, X1, X2), within(Y, Y1, Y2),
    within(X, X3, X4), within(Y, Y3, Y4).

within(X, A, B) :-
    X >= min(A, B)-1,
    X =< max(A, B)+1.

%   near_dash(Point, Dashes, Most)

near_dash(P, Dashes, Most) :-
    member(Dash, Dashes),
    nextto(A, B, Dash),
    off_piece(P, A, B, Off),
    Off =< Most,
    !.

off_piece(X-Y, X1-Y1, X2-Y2, Off) :-
    DX is X2-X1,
    DY is Y2-Y1,
    Square is DX*DX+DY*DY,
    (   Square =:= 0
    ->  T = 0
    ;   T is max(0, min(1, ((X-X1)*DX+(Y-Y1)*DY)/Square))
    ),
    Off is sqrt((X1+T*DX-X)**2 + (Y1+T*DY-Y)**2).

ends_near(X-Y, Points) :-
    ( Points = [A|_] ; last(Points, A) ),
    A = XA-YA,
    sqrt((X-XA)**2 + (Y-YA)**2) < 2400,
    !.

:- begin_tests(crossing).

test(dash_at_crossing, [forall(numbered(30, 300, Seed)), true]) :-
    random_strokes(Seed, Strokes0),
    strokes_crossed(Strokes0, Strokes),
    same_length(Strokes0, Strokes),
    forall(( crossed_at(Strokes0, K, P),
             nth1(K, Strokes, Stroke),
             Stroke = stroke(_,_,_,_,Points,Start,_),
             ( Start == ring ; \+ ends_near(P, Points) ) ),
           ( stroke_dashes(Stroke, [3000,900], Dashes),
             near_dash(P, Dashes, 15) )).
test(runs_are_the_way, [forall(numbered(30, 300, Seed)), true]) :-
    random_strokes(Seed, Strokes0),
    strokes_crossed(Strokes0, Strokes),
    forall(( member(Stroke, Strokes),
             Stroke = stroke(_,_,_,_,_,Start,crossed(End,_,Length)) ),
           ( stroke_runs(Stroke, [3000,900], Runs, 0),
             sum_list(Runs, Sum),
             length(Runs, N),
             N mod 2 =:= 0,
             Sum > Length-N,
             Sum < Length+900+N,
             Runs = [First|_],
             ( Start == joint -> First > 0 ; true ),
             ( Start == cut -> First =:= 0 ; true ),
             ( End == cut -> Sum < Length+N ; true ) )).
test(both_ways, [forall(numbered(10, 100, Seed)), true]) :-
    random_strokes(Seed, Strokes0),
    strokes_crossed(Strokes0, Strokes),
    travel(30000-30000, short, Strokes, Travel),
    fold_travel([S,[S|Ss],Ss]>>true, Travel, Ordered, []),
    forall(( member(Stroke, Ordered),
             Stroke = stroke(_,_,_,_,Points,Start,_),
             nth1(K, Strokes, stroke(_,_,_,_,Points0,_,_)),
             ( Points0 == Points ; reverse(Points0, Points) ),
             crossed_at(Strokes0, K, P),
             ( Start == ring ; \+ ends_near(P, Points) ) ),
           ( stroke_dashes(Stroke, [3000,900], Dashes),
             near_dash(P, Dashes, 15) )).
test(end_on_a_line, true(Marks-End == [5000.0]-joint)) :-
    hidden([0-0,12000-0], joint, joint, A),
    hidden([5000-0,5000-9000], joint, joint, B),
    strokes_crossed([A,B], [stroke(_,_,_,_,_,_,crossed(End,Marks,_)),_]).
test(alone, true(Strokes == [A,B])) :-
    hidden([0-0,12000-0], joint, joint, A),
    hidden([0-900,12000-900], cut, joint, B),
    strokes_crossed([A,B], Strokes).
test(too_many, true(Strokes == Strokes0)) :-
    findall(Stroke,
            ( between(1, 1001, I),
              X is 40*I,
              hidden([X-0,X-50,X-90,X-120000], joint, joint, Stroke) ),
            Lines),
    hidden([0-60000,120000-60000], joint, joint, Across),
    Strokes0 = [Across|Lines],
    strokes_crossed(Strokes0, Strokes).

:- end_tests(crossing).
