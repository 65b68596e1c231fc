/* Random boxes and sheets with whole coordinates, that cross, touch and lie in
   each other, against a flood of the cubes between: which regions there are,
   what each is inside, and its volume. The flood shares nothing with the
   engine.
   covers: region_content */
:- module(test_glue_flood, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(solid/glue)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).
:- use_module(tests(rules/sample), [numbered/3]).

%   Coordinates are 0 to most. A box is box(Low, High), a sheet flat(Axis, At,
%   Low, High), both in the two other axes.

most(4).

random_part(Part) :-
    (   maybe(0.45)
    ->  maplist(random_span, Spans, [_,_,_]),
        pairs_keys_values(Spans, Low, High),
        Part = box(Low, High)
    ;   most(Most),
        random_between(0, 2, Axis),
        random_between(0, Most, At),
        maplist(random_span, Spans, [_,_]),
        pairs_keys_values(Spans, Low, High),
        Part = flat(Axis, At, Low, High)
    ).

random_span(Low-High, _) :-
    most(Most),
    Last is Most-1,
    random_between(0, Last, Low),
    Next is Low+1,
    random_between(Next, Most, High).

%   made(Part, Made): as glue_model.pl has it.

made(box([X,Y,Z], [X1,Y1,Z1]), size([A,B,C], [MX,MY,Z])) :-
    A is X1-X,
    B is Y1-Y,
    C is Z1-Z,
    MX is (X+X1)/2,
    MY is (Y+Y1)/2.
made(flat(Axis, At, [A,B], [A1,B1]), square(Points)) :-
    findall(Point,
            ( member(P-Q, [A-B,A1-B,A1-B1,A-B1]),
              nth0(Axis, Point, At, [P,Q]) ),
            Points).

%   cubes(Cubes): where the first corner of each is; one layer is outside.

cubes(Cubes) :-
    most(Most),
    findall([X,Y,Z],
            ( between(-1, Most, X), between(-1, Most, Y),
              between(-1, Most, Z) ),
            Cubes).

inside(Cube, box(Low, High)) :-
    maplist([C,L,H]>>( L =< C, C < H ), Cube, Low, High).

insides(Parts, Cube, Ss) :-
    findall(S, ( nth1(S, Parts, Part), inside(Cube, Part) ), Ss).

%   step(Parts, From, To) is nondet: nothing lies between these cubes.

step(Parts, From, To) :-
    nth0(Axis, From, C, Others),
    member(D, [-1,1]),
    C1 is C+D,
    nth0(Axis, To, C1, Others),
    insides(Parts, From, Ss),
    insides(Parts, To, Ss),
    At is max(C, C1),
    \+ ( member(flat(Axis, At, Low, High), Parts),
         maplist([O,L,H]>>( L =< O, O < H ), Others, Low, High) ).

regions(_, [], []).
regions(Parts, [Cube|Cubes0], [Ss-Volume|Regions]) :-
    flooded(Parts, [Cube], Cubes0, Cubes, 0, Volume),
    insides(Parts, Cube, Ss),
    regions(Parts, Cubes, Regions).

flooded(_, [], Cubes, Cubes, Volume, Volume).
flooded(Parts, [Cube|Front], Cubes0, Cubes, Volume0, Volume) :-
    findall(To, ( step(Parts, Cube, To), memberchk(To, Cubes0) ), Tos),
    subtract(Cubes0, Tos, Cubes1),
    append(Tos, Front, Front1),
    Volume1 is Volume0+1,
    flooded(Parts, Front1, Cubes1, Cubes, Volume1, Volume).

%   wanted(Parts, Regions): of the bounded ones. The first cube is outside.

wanted(Parts, Regions) :-
    cubes(Cubes),
    regions(Parts, Cubes, [_|Bounded]),
    msort(Bounded, Regions).

found(Parts, Steps, Regions) :-
    maplist(made, Parts, Made),
    in_new_world(( glue_made(Made, Steps, S),
                   glue_report(S, Report) )),
    findall(Inside-Volume,
            ( member(Region, Report.regions),
              Region.role \== outside,
              Inside = Region.inside,
              Volume is round(Region.volume*1000)/1000 ),
            Regions0),
    msort(Regions0, Regions).

:- begin_tests(glue_flood).

test(flood, Different == []) :-
    findall(Seed-Turned,
            ( numbered(40, 400, Seed),
              set_random(seed(Seed)),
              random_between(2, 6, N),
              length(Parts, N),
              maplist(random_part, Parts),
              wanted(Parts, Wanted),
              member(Turned, [false,true]),
              (   Turned == true
              ->  turned(Seed, Steps)
              ;   Steps = []
              ),
              found(Parts, Steps, Found),
              Found \== Wanted ),
            Different).

%   A sheet that ends in a box, and goes through one side of it, or through
%   three, is parted there.

test(ends_inside, [ forall(ends_inside(Flat, Regions)), Found == Regions ]) :-
    found([box([0,0,0], [4,4,4]),Flat], [], Found).

ends_inside(flat(2, 2, [1,2], [3,6]), [[1]-64]).
ends_inside(flat(0, 2, [2,-1], [6,6]), [[1]-64]).
ends_inside(flat(0, 2, [-1,-1], [6,6]), [[1]-32,[1]-32]).

:- end_tests(glue_flood).
