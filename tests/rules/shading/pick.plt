/* What is at a dot: against what is known of a box and a ball, and each dot
   asked alone against all at once. */
:- module(test_pick, []).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(decision)).
:- use_module(rules(shading/pick)).
:- use_module(shaded_model).

%   From above, 10 dots to a unit, the origin between the dots 39 and 40.
options([size(80-80), window(b(-4.0,-4.0,4.0,4.0))]).

plate("segment(1, solid, box(size(6,4,1))).
       segment(2, solid, at([translate(0,0,3)], sphere(radius(1.5)))).
       look(2, opacity(0.25)). view(270, 0, 0).").

picked(Pixel, Picked) :-
    plate(Text),
    options(Options),
    in_model(Text, findall(P, pick(Pixel, Options, P), Picked)).

:- begin_tests(pick).

test(box, [R,S,Face,Share] == [1,1,top,1.0]) :-
    picked(pixel(12,25), [picked(R,S,Face,Share,point(X,Y,Z))]),
    assertion(( abs(X+2.75) < 1.0e-9, abs(Y-1.45) < 1.0e-9,
                abs(Z-1) < 1.0e-9 )).
%   A quarter of the light is of the front of the ball, a quarter of the rest of
%   its back.
test(glass, Seen == [2-0.25,2-0.1875,1-0.5625]) :-
    picked(pixel(44,37), Picked),
    findall(S-Share, member(picked(S,S,_,Share,_), Picked), Seen),
    Picked = [picked(_,_,_,_,Front),picked(_,_,_,_,Back),picked(_,_,_,_,Top)],
    assertion(( on_ball(Front), on_ball(Back) )),
    Front = point(X,Y,Z1),
    Back = point(_,_,Z2),
    Top = point(_,_,Z3),
    assertion(( abs(X-0.45) < 1.0e-9, abs(Y-0.25) < 1.0e-9,
                Z1 > 3, Z2 < 3, abs(Z3-1) < 1.0e-9 )).
test(beside, Picked == []) :-
    picked(pixel(5,40), Picked).
test(outside, Picked == []-[]-[]) :-
    picked(pixel(80,40), Picked1),
    picked(pixel(40,-1), Picked2),
    picked(pixel(40,80), Picked3),
    Picked = Picked1-Picked2-Picked3.

%   Middles of dots in 6 x 4 units, and in a circle of radius 1.5.
test(dots, Tops-Balls == 2400-Inside) :-
    plate(Text),
    options(Options),
    in_model(Text,
             ( aggregate_all(count, pick(_, Options, picked(1,_,top,_,_)),
                             Tops),
               aggregate_all(count,
                             ( pick(_, Options, picked(2,_,_,_,point(_,_,Z))),
                               Z > 3 ),
                             Balls) )),
    aggregate_all(count,
                  ( between(0, 79, X), between(0, 79, Y),
                    (X-39.5)**2 + (Y-39.5)**2 < 225 ),
                  Inside).
test(all_is_each, All == Each) :-
    plate(Text),
    Options = [size(23-17)],
    in_model(Text,
             ( findall(Pixel-Picked, pick(Pixel, Options, Picked), All),
               findall(pixel(X,Y)-Picked,
                       ( between(0, 16, Y), between(0, 22, X),
                         pick(pixel(X,Y), Options, Picked) ),
                       Each) )),
    assertion(All = [_,_|_]).
test(a_column, Xs == [40]) :-
    plate(Text),
    options(Options),
    in_model(Text, findall(X, ( pick(pixel(40,_), Options, _), X = 40 ), Xs0)),
    assertion(length(Xs0, 100)),        % 40, and twice 30 of the ball
    sort(Xs0, Xs).
test(by_rule, Seen == 1-2) :-
    Text = "segment(1, solid, box(size(4,4,1))).
            segment(2, solid, box(size(2,2,1))).
            segment(3, solid, union([1,2])). view(270, 0, 0).",
    options(Options),
    in_model(Text,
             ( pick(pixel(40,40), Options, picked(3,S1,top,_,_)),
               setup_call_cleanup(
                   ( tmp_file_stream(File, Out, [encoding(utf8),
                                                 extension(pl)]),
                     write(Out, "owner(_, [_,Owner|_], Owner)."),
                     close(Out) ),
                   use_rules(File),
                   delete_file(File)),
               pick(pixel(40,40), Options, picked(3,S2,top,_,_)) )),
    Seen = S1-S2.
test(nothing_in_the_window, Picked == []) :-
    plate(Text),
    in_model(Text,
             findall(P, pick(_, [size(9-9),window(b(50.0,50.0,51.0,51.0))], P),
                     Picked)).
test(no_number, error(type_error(integer, a))) :-
    picked(pixel(a,1), _).
test(no_options, error(type_error(list, some))) :-
    plate(Text),
    in_model(Text, pick(_, some, _)).

on_ball(point(X,Y,Z)) :-
    abs(sqrt(X**2 + Y**2 + (Z-3)**2) - 1.5) < 1.0e-9.

:- end_tests(pick).
