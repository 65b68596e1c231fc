/* Parts of a workshop nested on sheets: none on another, and close together. */
:- module(test_pattern_nest, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(pattern/pattern_nest)).
:- use_module(rules(pattern/pattern_outline), [loop_area/2]).
:- use_module(tests('rules/pattern/cut_checked')).

% Parts of several forms, from a generator with a fixed start.
parts(Seed, N, Least, Most, Parts) :-
    set_random(seed(Seed)),
    findall(I-Loops,
            ( between(1, N, I),
              random(U),
              Size is Least+(Most-Least)*U,
              Kind is I mod 5,
              part(Kind, Size, Loops) ),
            Parts).

part(0, S, [Loop]) :-
    R is S/2,
    circle(R, 32, 1, Loop).
part(1, S, [Outer,Inner]) :-
    R is S/2,
    circle(R, 32, 1, Outer),
    R2 is 0.7*R,
    circle(R2, 32, -1, Inner).
part(2, S, [[0.0-0.0,S-0.0,S-H,0.0-H]]) :-
    H is 0.6*S.
part(3, S, [[0.0-0.0,S-0.0,S-T,T-T,T-S,0.0-S]]) :-
    T is 0.25*S.
part(4, S, [[0.0-0.0,S-0.0,0.0-H]]) :-
    H is 0.7*S.

circle(R, N, Way, Loop) :-
    findall(X-Y,
            ( between(1, N, I),
              A is Way*2*pi*I/N,
              X is R*cos(A),
              Y is R*sin(A) ),
            Loop).

% Drawings, one for each sheet, of what is cut.
sheets(Parts, Places, W-H, Drawings) :-
    findall(I, member(_-place(I,_,_,_), Places), Is0),
    sort(Is0, Is),
    WM is round(W*1000),
    HM is round(H*1000),
    findall(drawing(sheet(WM,HM,1),Views),
            ( member(I, Is),
              findall(view(Name,Strokes,[]),
                      ( member(Name-place(I,Degrees,DX,DY), Places),
                        memberchk(Name-Loops, Parts),
                        findall(stroke(visible,cut,1,[],Points,ring,ring),
                                ( member([P|Ps], Loops),
                                  append([P|Ps], [P], Round),
                                  maplist(placed(Degrees, DX, DY), Round,
                                          Points) ),
                                Strokes) ),
                      Views) ),
            Drawings).

placed(Degrees, DX, DY, X0-Y0, X-Y) :-
    A is Degrees*pi/180,
    X is round(1000*(X0*cos(A)-Y0*sin(A)+DX)),
    Y is round(1000*(X0*sin(A)+Y0*cos(A)+DY)).

area(Parts, Area) :-
    findall(A, ( member(_-Loops, Parts), member(Loop, Loops),
                 loop_area(Loop, A) ), As),
    sum_list(As, Area).

% A part in the hole of another is right; cut_fault/2 calls it inside.
fault(Drawings, Fault) :-
    member(Drawing, Drawings),
    cut_fault(Drawing, Fault),
    Fault \= inside(_, _).


:- begin_tests(pattern_nest).

test(no_overlap, [ forall(member(N-Least-Most,
                                 [ 3-50-300, 12-40-200, 40-20-120 ])) ]) :-
    parts(N, N, Least, Most, Parts),
    nested(Parts, room(600,400,3), nested(Size,Places)),
    sheets(Parts, Places, Size, Drawings),
    assertion(\+ fault(Drawings, _)),
    assertion(\+ member(_-place(0,_,_,_), Places)).
test(roll_no_overlap, [ forall(member(N, [2,7,20])) ]) :-
    parts(N, N, 30, 150, Parts),
    nested(Parts, roll(3), nested(Size,Places)),
    sheets(Parts, Places, Size, Drawings),
    assertion(\+ fault(Drawings, _)),
    assertion(length(Drawings, 1)).
test(close_together, [ true(Share > 0.62) ]) :-
    parts(1, 80, 100, 500, Parts),
    nested(Parts, room(2000,1000,5), nested(_,Places)),
    area(Parts, Area),
    findall(I, member(_-place(I,_,_,_), Places), Is),
    max_list(Is, Sheets),
    Share is Area/(Sheets*2000*1000.0).
% A disc that a ring has room for is put into it if the sheet is full else.
test(in_a_hole, [ true(Sheets == [1,1]) ]) :-
    circle(100, 48, 1, Outer),
    circle(80, 48, -1, Inner),
    circle(60, 48, 1, Disc),
    nested([ring-[Outer,Inner],disc-[Disc]], room(220,220,3),
           nested(_,Places)),
    findall(I, member(_-place(I,_,_,_), Places), Sheets).
test(tables_are_read, [ forall(member(W-H, [500-300,300-500])) ]) :-
    parts(5, 10, 40, 200, Parts),
    nested([table(2,0)-[[0.0-0.0,200.0-0.0,200.0-90.0,0.0-90.0]]|Parts],
           room(W,H,3), nested(_,[_-place(_,Degrees,_,_)|_])),
    assertion(memberchk(Degrees, [0.0,90.0])).
% What fits on paper has a place there: also what fits only if it is turned by
% little, and has hardly a smaller box then.
test(fits_and_is_placed, [ forall(between(0, 24, I)), nondet ]) :-
    Turn is I/8*pi/180,
    findall(W, ( between(0, 20, K), W is 184 + K*0.4 ), Ws),
    forall(member(W, Ws),
           ( findall(X-Y,
                     ( member(X0-Y0, [ 20-0,W-30,W-200,160-230,0-230,0-30 ]),
                       X is X0*cos(Turn) - Y0*sin(Turn),
                       Y is X0*sin(Turn) + Y0*cos(Turn) ),
                     Loop),
             (   fits_on(Loop, room(190,277,3))
             ->  nested([one-[Loop]], room(190,277,3), nested(_,Places)),
                 Places = [_-place(Sheet,_,_,_)],
                 assertion(Sheet =:= 1)
             ;   true
             ) )).
% The whole of a page is used: by what has room there, but not in squares.
test(as_large_as_the_page, Sheets == [2,1,3]) :-
    Parts = [a-[[0.0-0.0,190.0-0.0,190.0-277.0,0.0-277.0]],
             b-[[0.0-0.0,100.0-0.0,100.0-50.0,0.0-50.0]],
             c-[[5.0-5.0,282.0-5.0,282.0-194.9,5.0-194.9]]],
    nested(Parts, room(190,277,3), nested(_,Places)),
    findall(I, member(_-place(I,_,_,_), Places), Sheets),
    forall(( nth1(N, Parts, Name-[Loop]),
             nth1(N, Places, Name-place(_,Degrees,DX,DY)),
             member(X0-Y0, Loop) ),
           ( X is X0*cos(Degrees*pi/180) - Y0*sin(Degrees*pi/180) + DX,
             Y is X0*sin(Degrees*pi/180) + Y0*cos(Degrees*pi/180) + DY,
             assertion(( X > -1.0e-6, X < 190.000001,
                         Y > -1.0e-6, Y < 277.000001 )) )).
test(larger_than_the_page) :-
    Loop = [0.0-0.0,190.01-0.0,190.01-277.0,0.0-277.0],
    \+ fits_on(Loop, room(190,277,3)),
    nested([a-[Loop]], room(190,277,3), nested(_,[a-place(Sheet,_,_,_)])),
    assertion(Sheet =:= 0).
test(same_again) :-
    parts(9, 25, 20, 150, Parts),
    nested(Parts, room(500,400,3), A),
    nested(Parts, room(500,400,3), B),
    assertion(A == B).

:- end_tests(pattern_nest).
