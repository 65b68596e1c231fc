/* Shaded pictures in one process, processor seconds of all threads:

       swipl -p foreign=build bench/redraw.pl [-- WIDTHxHEIGHT]

   A plate with 732 holes and 133 pins, each with a ball: 999 leaves. The first
   picture, and those after a ball has moved, each one in turn, and back. Then
   60 pictures of 640x400 dots of ten leaves, each from another side.
*/
:- use_module('../rules/picture/view').
:- use_module('../rules/shading/kept_picture').
:- use_module('../rules/store').
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Argv),
    (   Argv = [Text]
    ->  true
    ;   Text = '1920x1080'
    ),
    atomic_list_concat(Numbers, x, Text),
    maplist(atom_number, Numbers, [Width,Height]),
    new_world(World),
    in_world(World, redrawn(Width-Height)),
    new_world(World2),
    in_world(World2, turned).

timed(Goal, Seconds) :-
    statistics(process_cputime, T0),
    call(Goal),
    statistics(process_cputime, T1),
    Seconds is T1-T0.

redrawn(Size) :-
    plate,
    Options = [size(Size)],
    timed(world_picture(Options, _), First),
    findall(S, ( segment(S, _, at(_, sphere(_,_,_))), S mod 5 =:= 0 ), Balls),
    maplist(moved_seconds(Options), Balls, Lists),
    append(Lists, Seconds),
    sum_list(Seconds, Sum),
    length(Seconds, N),
    Mean is Sum/N,
    Ratio is Mean/First,
    aggregate_all(count, segment(_,_,_), Count),
    Leaves is Count-1,
    Size = W-H,
    format("~d leaves, ~dx~d: first ~3f s, a ball moved ~4f s (~d), ~3f~n",
           [Leaves,W,H,First,Mean,N,Ratio]).

moved_seconds(Options, S, [Seconds1,Seconds2]) :-
    segment(S, solid, Old),
    !,
    Old = at([translate(X,Y,Z)], Ball),
    X1 is X+0.3,
    replaced(S, at([translate(X1,Y,Z)], Ball)),
    timed(world_picture(Options, _), Seconds1),
    replaced(S, Old),
    timed(world_picture(Options, _), Seconds2).

replaced(S, Term) :-
    facts_transaction(( retractall_facts(segment(S, _, _)),
                        assert_fact(segment(S, solid, Term)) )).

plate :-
    forall(( between(0, 864, I), leaf(I, S, Term) ),
           assert_fact(segment(S, solid, Term))),
    assert_fact(segment(4000, solid,
                        at([translate(14.5,15,0)], box(size(29,30,0.5))))),
    findall(S, ( segment(S, _, _), S > 1000, S < 2000 ), Holes),
    findall(S, ( segment(S, _, _), S > 2000, S < 4000 ), Pins),
    assert_fact(segment(1, solid,
                        union([difference([4000|Holes])|Pins]))),
    set_view(300, 60, 0).

leaf(I, S, Term) :-
    X is I mod 29 + 0.5,
    Y is I//29 + 0.5,
    (   (I mod 13) mod 6 =:= 5
    ->  (   S is 2001+I,
            Term = at([translate(X,Y,0.25)],
                      cylinder(radius(0.25),height(1),facets(96)))
        ;   S is 3001+I,
            Term = at([translate(X,Y,1.2)],
                      sphere(radius(0.35),facets(96),bands(48)))
        )
    ;   S is 1001+I,
        R is 0.15 + 0.04*(I mod 5),
        Term = at([translate(X,Y,-1)],
                  cylinder(radius(R),height(2),facets(96)))
    ).

turned :-
    assert_fact(segment(1, solid, box(size(4,4,4)))),
    forall(member(S-Term,
                  [ 2-at([translate(0,0,-1)], cylinder(radius(1.2),height(6))),
                    3-at([rotate(x,90),translate(0,3,2)],
                         cylinder(radius(1.2),height(6))),
                    4-at([rotate(y,90),translate(-3,0,2)],
                         cylinder(radius(1.2),height(6))),
                    5-at([translate(2,2,4)], sphere(radius(1))),
                    6-at([translate(-2,2,4)], sphere(radius(1))),
                    7-at([translate(2,-2,4)], cone(radius(1),height(2))),
                    8-at([translate(-2,-2,4)], cone(radius(1),height(2))),
                    9-at([translate(0,0,-1)], box(size(6,6,1))),
                    10-at([translate(3,3,-2)], sphere(radius(1.5))) ]),
           assert_fact(segment(S, solid, Term))),
    assert_fact(segment(11, solid,
                        union([difference([1,2,3,4]),5,6,7,8,
                               difference([9,10])]))),
    timed(forall(between(1, 60, I), picture(I)), Seconds),
    Rate is 60/Seconds,
    format("10 leaves, 640x400: 60 pictures ~2f s, ~0f a second~n",
           [Seconds,Rate]).

picture(I) :-
    Theta is 6*I,
    set_view(Theta, 60, 0),
    world_picture([size(640-400)], _).
