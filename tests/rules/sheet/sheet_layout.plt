:- module(test_sheet_layout, []).
:- use_module(library(plunit)).
:- use_module(rules(sheet/sheet_layout)).
:- use_module(rules(sheet/sheet_paper)).
:- use_module(rules(sheet/sheet_view),
              [view_cell/4, view_named/2, section_view/5]).
:- use_module(rules(sheet/sheet_frame), [frame/5]).
:- use_module(tests('rules/sample')).

% Views of a box of the size X, Y, Z.
sights(X, Y, Z, Names, Sights) :-
    maplist(sight(X, Y, Z), Names, Sights).

sight(X, Y, Z, Name, sight(Name,Cell,Box,pads(0,0,0,0))) :-
    view_named(Name, View),
    view_cell(View, third, [], Cell),
    memberchk(Name-Box, [ front-box(0,0,X,Z), back-box(-X,0,0,Z),
                          right-box(0,0,Y,Z), left-box(-Y,0,0,Z),
                          top-box(0,0,X,Y), bottom-box(0,-Y,X,0),
                          isometric-box(-X,-X,Y,Z) ]),
    !.

rectangle(Sights, Scale, place(Name,X,Y,Left,Top), rect(A,B,C,D)) :-
    memberchk(sight(Name,_,box(X1,Y1,X2,Y2),pads(PL,PA,PR,PB)), Sights),
    A is Left+(X1-X)*Scale-PL,
    C is Left+(X2-X)*Scale+PR,
    B is Top+(Y-Y2)*Scale-PA,
    D is Top+(Y-Y1)*Scale+PB.

overlap(rect(A1,B1,A2,B2), rect(C1,D1,C2,D2)) :-
    A1 < C2-1.0e-9,
    C1 < A2-1.0e-9,
    B1 < D2-1.0e-9,
    D1 < B2-1.0e-9.

% All in the room, apart from each other and from what is taken.
sound(Sights, room(rect(X1,Y1,X2,Y2),Taken), Scale, Places) :-
    maplist(rectangle(Sights, Scale), Places, Rectangles),
    length(Sights, N),
    length(Rectangles, N),
    forall(member(rect(A,B,C,D), Rectangles),
           ( A >= X1-1.0e-9, C =< X2+1.0e-9, B >= Y1-1.0e-9,
             D =< Y2+1.0e-9 )),
    append(Taken, Rectangles, All),
    \+ ( select(R1, All, Others), member(R1, Rectangles),
         member(R2, Others), overlap(R1, R2) ).

room(Paper, Room) :-
    paper(Paper, W, H),
    frame(W, H, [language-en,angle-third], _, Room).

names([[front], [front,top], [front,top,right], [front,top,right,isometric],
       [isometric], [top,bottom,front,left,right,back,isometric],
       [right,left], [back,isometric]]).

:- begin_tests(sheet_layout).

test(random, [forall(numbered(50, 150, Seed))]) :-
    set_random(seed(Seed)),
    names(All),
    random_member(Names, All),
    random_member(Paper, [a4,a3,a2,'a4-landscape','a3-portrait',a0]),
    maplist(random_between(5, 200), [X,Y,Z]),
    sights(X, Y, Z, Names, Sights0),
    maplist(padded, Sights0, Sights),
    room(Paper, Room),
    forall(( member(N:M, [2:1,1:1,1:2,1:5]), Scale is N/M,
             layout(Sights, Room, Scale, Places) ),
           sound(Sights, Room, Scale, Places)).

padded(sight(N,C,B,_), sight(N,C,B,pads(L,A,R,D))) :-
    maplist(random_between(0, 12), [L,A,R,D]).

test(aligned) :-
    sights(60, 40, 30, [front,top,right,bottom,left,back], Sights),
    room(a2, Room),
    layout(Sights, Room, 1.0, Places),
    forall(member(Name, [top,bottom]),
           ( memberchk(place(front,X,_,Left,_), Places),
             memberchk(place(Name,X,_,Left,_), Places) )),
    forall(member(Name, [left,right,back]),
           ( memberchk(place(front,_,Y,_,Top), Places),
             memberchk(place(Name,_,Y,_,Top), Places) )).
test(third_angle) :-
    sights(60, 40, 30, [front,top,right], Sights),
    room(a3, Room),
    layout(Sights, Room, 1.0, Places),
    memberchk(place(front,_,_,FrontX,FrontY), Places),
    memberchk(place(top,_,_,_,TopY), Places),
    memberchk(place(right,_,_,RightX,_), Places),
    TopY < FrontY,
    RightX > FrontX.
test(too_large, fail) :-
    sights(60, 40, 30, [front,top,right], Sights),
    room(a4, Room),
    layout(Sights, Room, 10.0, _).
test(grows) :-                          % what fits fits on larger paper
    sights(60, 40, 30, [front,top,right,isometric], Sights),
    room(a3, Room),
    room(a2, Large),
    layout(Sights, Room, 1.0, _),
    layout(Sights, Large, 1.0, _).

%   To the millimetre: two views need a gap of 12 between them, a free one 9
%   round what is there, and what just fits does.

test(gap, [ forall(member(Width-Lefts, [52-[0.0,32.0],58-[3.0,35.0],
                                        160-[40.0,100.0],400-[156.0,224.0]])),
            true(Is =@= Lefts) ]) :-
    layout([ sight(a,at(0,0),box(0,0,20,10),pads(0,0,0,0)),
             sight(b,at(1,0),box(5,0,25,10),pads(0,0,0,0)) ],
           room(rect(0,0,Width,10),[]), 1.0, Places),
    findall(Left, ( member(place(_,_,_,Left0,_), Places), Left is Left0+0.0 ),
            Is).
%   Where that is taken, they stand elsewhere, or nearer to each other.

test(taken, [ forall(member(Xs-Lefts, [ []-[40.0,100.0], [42]-[0.0,60.0],
                                        [50]-[24.0,84.0],
                                        [10,42]-[80.0,140.0],
                                        [10,42,150]-[47.0,93.0],
                                        [10,42,48,150]-[54.0,86.0] ])),
              true(Is =@= Lefts) ]) :-
    findall(rect(X,0,X1,10), ( member(X, Xs), X1 is X+1 ), Taken),
    layout([ sight(a,at(0,0),box(0,0,20,10),pads(0,0,0,0)),
             sight(b,at(1,0),box(5,0,25,10),pads(0,0,0,0)) ],
           room(rect(0,0,160,10),Taken), 1.0, Places),
    findall(Left, ( member(place(_,_,_,Left0,_), Places), Left is Left0+0.0 ),
            Is).
test(no_gap, [fail]) :-
    layout([ sight(a,at(0,0),box(0,0,20,10),pads(0,0,0,0)),
             sight(b,at(1,0),box(5,0,25,10),pads(0,0,0,0)) ],
           room(rect(0,0,51.999,10),[]), 1.0, _).
test(free, [ forall(member(Width-Height, [29-10,30-10,29-12])),
             true([Left,Top] == [At,Middle]) ]) :-
    Whole is 20+Width,
    At is (Whole+9)/2.0,
    Middle is (Height-10)/2.0,
    layout([ sight(b,free,box(5,-3,25,7),pads(0,0,0,0)) ],
           room(rect(0,0,Whole,Height),[rect(0,0,20,Height)]), 1.0,
           [place(b,5,7,Left,Top)]).
test(free_does_not_fit, [ forall(member(W-H, [48.999-10,49-9.999])), fail ]) :-
    layout([ sight(b,free,box(5,-3,25,7),pads(0,0,0,0)) ],
           room(rect(0,0,W,H),[rect(0,0,20,H)]), 1.0, _).
test(cells, [forall(member(Name-First-Third,
                    [ front-at(0,0)-at(0,0), right-at(-1,0)-at(1,0),
                      left-at(1,0)-at(-1,0), top-at(0,1)-at(0,-1),
                      bottom-at(0,-1)-at(0,1), back-at(2,0)-at(2,0),
                      isometric-free-free ]))]) :-
    view_named(Name, View),
    view_cell(View, first, [], First),
    view_cell(View, third, [], Third),
    !.
test(section_cells, [forall(member(Axis-Angle-Taken-Cell,
                    [ x-third-[]-at(1,0), x-third-[at(1,0)]-at(2,0),
                      x-first-[at(-1,0)]-at(-2,0), z-third-[]-at(0,-1),
                      z-first-[at(0,1)]-at(0,2), y-third-[]-at(0,0),
                      y-third-[at(0,0),at(1,0)]-at(2,0),
                      y-first-[at(0,0)]-at(-1,0), none-third-[]-free ]))]) :-
    section_view('A', plane(1,2,3,4), Axis, '', View),
    view_cell(View, Angle, Taken, Cell),
    !.

test(paper, [forall(member(Text-W-H, [ 'A4'-210-297, a4-210-297,
                                       'A4-landscape'-297-210, 'A3'-420-297,
                                       'a3-Portrait'-297-420, 'A0'-1189-841
                                     ]))]) :-
    paper(Text, W, H).
test(no_paper, [forall(member(Text, ['A5', 'A', '', 'A3-sideways', 'A3-',
                                     'A3-portrait-portrait', '420x297'])),
                fail]) :-
    paper(Text, _, _).
test(scales, true(Scales == [10:1,5:1,2:1,1:1,1:2,1:5,1:10,1:20])) :-
    findall(S, standard_scale(S), All),
    append(_, [10:1|Rest], All),
    !,
    length(Scales, 8),
    append(Scales, _, [10:1|Rest]).
test(scales_fall) :-
    findall(F, ( standard_scale(S), scale_factor(S, F) ), Fs),
    sort(0, @>, Fs, Fs).

% The frame leaves 20 mm on the left and 10 elsewhere; all marks are on paper.
% The symbol of the angle: a cone 7 mm long, from 3.5 to 7 high, and 11 mm
% beside it, right for the first, left for the third angle, two circles.
test(frame, forall(( member(Angle-Way, [first-1,third-(-1)]),
                     member(W-H, [420.0-297.0,297.0-210.0]) ))) :-
    frame(W, H, [language-en,angle-Angle,scale-"1:1",paper-"A3"], Marks, Room),
    X2 is W-10,
    Y2 is H-10,
    member(line(frame,Outer), Marks),
    box_of(Outer, box(U1,V1,U2,V2)),
    maplist(as_near, [U1,V1,U2,V2], [20.0,10.0,X2,Y2]),
    forall(( member(line(_,Ps), Marks), member(X-Y, Ps) ),
           ( X >= 0, X =< W, Y >= 0, Y =< H )),
    findall(Box, ( member(line(symbol,Ps), Marks), box_of(Ps, Box) ),
            [box(A1,B1,A2,B2),box(C1,D1,C2,D2),box(E1,F1,E2,F2)]),
    Long is A2-A1, High is B2-B1, Large is D2-D1, Small is F2-F1,
    maplist(as_near, [Long,High,Large,Small], [7.0,7.0,7.0,3.5]),
    Apart is Way*((C1+C2)-(A1+A2))/2,
    Same is (E1+E2)-(C1+C2),
    Level is (D1+D2)-(B1+B2),
    maplist(as_near, [Apart,Same,Level], [11.0,0.0,0.0]),
    Room = room(rect(R1,S1,R2,S2),[rect(T1,T2,X2,Y2)]),
    T3 is X2-186, T4 is Y2-42, R3 is X2-6, S3 is Y2-6,
    maplist(as_near, [R1,S1,R2,S2,T1,T2], [26.0,16.0,R3,S3,T3,T4]),
    !.

box_of(Ps, box(X1,Y1,X2,Y2)) :-
    pairs_keys_values(Ps, Xs, Ys),
    maplist(min_list, [Xs,Ys], [X1,Y1]),
    maplist(max_list, [Xs,Ys], [X2,Y2]).

as_near(A, B) :-
    abs(A-B) < 1.0e-6.

:- end_tests(sheet_layout).
