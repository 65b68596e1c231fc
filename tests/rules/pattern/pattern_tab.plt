/* Forms of a tab, and what is trimmed of them to the room that there is. */
:- module(test_pattern_tab, []).
% covers: pattern_trim
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(pattern/pattern_outline), [loop_area/2]).
:- use_module(rules(pattern/pattern_tab)).
:- use_module(rules(pattern/pattern_trim)).

forms(Width, Length, Forms) :-
    findall(Tab-Area, tab_shape(Width, Length, Tab, Area), Forms).

corners(tab(In1,Run1,In2,Run2,Deep), Length, [A-0,B-Deep,C-Deep,D-0]) :-
    A is In1,
    B is A+Run1,
    D is Length-In2,
    C is D-Run2.

%   roof(Name, X, H): how much room there is above X.

roof(flat, _, 3.0).
roof(up, X, H) :-
    H is 1.0 + 0.3*X.
roof(down, X, H) :-
    H is 4.0 - 0.3*X.
roof(steep, X, H) :-
    H is 0.5 + 0.9*X.
roof(notch, X, H) :-
    (   X > 6.0,
        X < 7.0
    ->  H = 0.0
    ;   H = 4.0
    ).

%   under(Roof, Tab): each of its points.

under(Roof, Tab) :-
    forall(( between(0, 200, I),
             X is I/20,
             height(Tab, X, Deep) ),
           ( roof(Roof, X, H), Deep =< H + 1.0e-9 )).

height(Tab, X, Deep) :-
    append(_, [A-D,B-E|_], Tab),
    A < B,
    X >= A,
    X =< B,
    Deep is D + (E-D)*(X-A)/(B-A).

trimmed(Roof, Deep, Tab, Area) :-
    trimmed_tab(within(0.0,10.0,1,1,Deep), 1.0, test_pattern_tab:under(Roof),
                Tab),
    loop_area(Tab, Area0),
    Area is abs(Area0).

:- begin_tests(pattern_tab).

% The area is that within the corners.
test(area, forall(member(Width-Length, [4-100,6-20,2-9,9-7]))) :-
    forms(Width, Length, Forms),
    Forms = [_|_],
    forall(member(Tab-Area, Forms),
           ( corners(Tab, Length, Corners),
             loop_area(Corners, Area0),
             abs(abs(Area0)-Area) < 1.0e-9 )).
% Three depths, ends of five kinds, and whether they stand back.
test(all_forms, Forms == Wanted) :-
    findall([D,S1,S2,I1,I2],
            ( tab_shape(4, 100, tab(In1,Run1,In2,Run2,Deep), _),
              D is round(100*Deep),
              S1 is round(10*Run1/Deep),
              S2 is round(10*Run2/Deep),
              I1 is round(In1),
              I2 is round(In2) ),
            Forms0),
    sort(Forms0, Forms),
    findall([D,S1,S2,I1,I2],
            ( member(D, [220,300,400]),
              member(S1-S2, [10-10,10-35,18-18,35-10,35-35]),
              member(I1, [0,15]),
              member(I2, [0,15]) ),
            Wanted0),
    sort(Wanted0, Wanted).
% At least a third of the width deep, twice that long, a tenth flat on top.
test(least, Counts == [7-0,23-4,32-7,100-15]) :-
    findall(Length-Count,
            ( member(Length0, [0.7,2.3,3.2,10.0]),
              Length is round(10*Length0),
              aggregate_all(count, tab_shape(1.0, Length0,
                                             tab(0.0,_,0.0,_,_), _),
                            Count) ),
            Counts).
test(least_tab, Leasts == [1.0,1.0,0.5]) :-
    findall(Least, ( member(W, [9.0,3.0,1.5]), least_tab(W, Least) ), Leasts).
test(deepest, Deeps == [5,4.5,0.0]) :-
    findall(Deep,
            ( member(Lengths, [[3,20],[3,10],[]]),
              findall(side(0,1,a-(0-0),b-(L-0),seam(J,9.0,1)),
                      nth1(J, Lengths, L), Sides),
              deepest_tab(5, [piece(name(1,1,0),[],Sides)], Deep) ),
            Deeps).

% What is trimmed lies below the roof, and a knife has room: of 3, halved some
% times from the depth, it takes about nine tenths. What leans the other way is
% as large.
test(trimmed, [ forall(member(Roof-Deep-Wanted,
                              [ flat-5.0-1931, flat-2.0-1600, up-9.0-1253,
                                down-9.0-1253, steep-4.0-1446, notch-4.0-800
                              ])),
                true(Area == Wanted) ]) :-
    trimmed(Roof, Deep, Tab, Area0),
    under(Roof, Tab),
    Area is round(100*Area0).
% No room is no tab; nor is what is less deep than the least.
test(no_room, [ forall(member(From-Least, [6.0-1.0,0.0-3.5])), fail ]) :-
    To is From + 1.0 + 9.0*sign(Least-1.0),
    (   From > 0
    ->  Roof = notch
    ;   Roof = flat
    ),
    trimmed_tab(within(From,To,1,1,5.0), Least, test_pattern_tab:under(Roof),
                _).

:- end_tests(pattern_tab).
