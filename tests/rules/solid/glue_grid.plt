/* Random cubes, squares and edges of a grid, each an operand, against a count
   of the cells of the grid: a flood fill that shares nothing with the engine.
   And the figures of the paper, turned.
   covers: glue */
:- module(test_glue_grid, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(model/model)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   Places of the doubled grid, [X,Y,Z]: an odd coordinate is the inside of a
%   step, an even one its end. So a cube has three odd ones, a vertex none.

size(2).

cell(Odd, Cell) :-
    size(N),
    Most is 2*N,
    findall(C, between(0, Most, C), Cs),
    Cell = [X,Y,Z],
    member(X, Cs),
    member(Y, Cs),
    member(Z, Cs),
    odd(Cell, Odd).

odd(Cell, Odd) :-
    aggregate_all(count, ( member(C, Cell), C mod 2 =:= 1 ), Odd).

%   closure(Cell, Face) is nondet: Cell and all that bounds it.

closure([], []).
closure([C|Cell], [F|Face]) :-
    (   F = C
    ;   C mod 2 =:= 1,
        ( F is C-1 ; F is C+1 )
    ),
    closure(Cell, Face).

%   complex(Chosen, Cells): what is there; cubes are not, but their borders.

complex(Chosen, Cells) :-
    findall(Face,
            ( member(Cell, Chosen), closure(Cell, Face), odd(Face, Odd),
              Odd < 3 ),
            Cells0),
    sort(Cells0, Cells).

counted(Chosen, c(V,E,F,F,C,R,S,G)) :-
    complex(Chosen, Cells),
    maplist(number_of(Cells), [0,1,2], [V,E,F]),
    pieces(Cells, C),
    findall(Cell, free_cell(Cells, Cell), Free),
    pieces(Free, R),
    S is C+R-1,
    G is S-(V-E+F).

number_of(Cells, Odd, N) :-
    aggregate_all(count, ( member(Cell, Cells), odd(Cell, Odd) ), N).

%   free_cell(Cells, Cell): in or round the grid, and not of Cells.

free_cell(Cells, [X,Y,Z]) :-
    size(N),
    Most is 2*N+1,
    between(-1, Most, X),
    between(-1, Most, Y),
    between(-1, Most, Z),
    \+ memberchk([X,Y,Z], Cells).

%   pieces(Cells, N): sets that hang together by steps along an axis.

pieces([], 0).
pieces([Cell|Cells0], N) :-
    flooded([Cell], Cells0, Cells),
    pieces(Cells, N0),
    N is N0+1.

flooded([], Cells, Cells).
flooded([Cell|Front], Cells0, Cells) :-
    findall(Near, ( beside(Cell, Near), memberchk(Near, Cells0) ), Nears),
    subtract(Cells0, Nears, Cells1),
    append(Nears, Front, Front1),
    flooded(Front1, Cells1, Cells).

beside(Cell, Near) :-
    nth0(I, Cell, C, Others),
    ( C1 is C-1 ; C1 is C+1 ),
    nth0(I, Near, C1, Others).

%   part(Cell, Part): of glue_model.pl.

part([X,Y,Z], box(1, [X1,Y1,Z1])) :-
    odd([X,Y,Z], 3),
    !,
    X1 is X/2.0,
    Y1 is Y/2.0,
    Z1 is (Z-1)/2.0.
part(Cell, Part) :-
    findall(Corner,
            ( closure(Cell, Face), odd(Face, 0),
              maplist([C,H]>>(H is C/2.0), Face, Corner) ),
            Corners0),
    sort(Corners0, Corners),
    (   Corners = [A,B,C,D]
    ->  Part = square([A,B,D,C])
    ;   Corners = [A,B],
        Part = wire(A, B)
    ).

:- begin_tests(glue_grid).

test(grid, [ forall(( between(1, 24, Seed), member(Turned, [false,true]) )),
             Counts == Wanted ]) :-
    set_random(seed(Seed)),
    findall(Cell, ( member(Odd, [1,2,3]), cell(Odd, Cell) ), All),
    random_permutation(All, Mixed),
    random_between(1, 12, N),
    length(Chosen, N),
    append(Chosen, _, Mixed),
    counted(Chosen, Wanted),
    maplist(part, Chosen, Parts),
    (   Turned == true
    ->  turned(Seed, Steps)
    ;   Steps = []
    ),
    glue_counts(Parts, Steps, Counts).

%   Figures 1 to 8 with all their operands turned.

test(figures, [ forall(( figure(Name, Wanted), member(Seed, [0,1,2]) )),
                Counts == Wanted ]) :-
    atomic_list_concat(['facts/figures/glue_',Name,'.pl'], File),
    turned_steps(Seed, Steps),
    in_new_world(( load_model(File, [evaluate(false)]),
                   figure_turned(Steps, S),
                   evaluate(S),
                   glue_report(S, Report) )),
    report_counts(Report, Counts).

figure_turned(Steps, S) :-
    findall(N-Kind-Term, segment(N, Kind, Term), Segments),
    once(( member(S-cells-Glue, Segments), glue_term(Glue, Ss) )),
    forall(( member(N-Kind-Term, Segments), memberchk(N, Ss) ),
           ( retractall_facts(segment(N, _, _)),
             assert_fact(segment(N, Kind, at(Steps, Term))) )).

glue_term(glue(Ss), Ss).
glue_term(named(_, Term), Ss) :-
    glue_term(Term, Ss).

figure(materials, c(58,91,38,38,1,5,5,0)).
figure(vertex, c(14,25,15,15,1,4,4,0)).
figure(crossing, c(13,28,21,21,1,6,6,0)).
figure(edge, c(14,18,5,5,1,1,1,0)).
figure(face, c(18,28,13,13,1,3,3,0)).
figure(mixed, c(24,38,21,23,1,5,5,0)).

%   Figure 1 with one sheet through all of it, without the line and with it.

test(figure1, [ forall(( member(Terms-Wanted,
                                [ []-c(52,82,36,37,1,5,5,0),
                                  [line(from(0,0,-1), to(0,0,3))]
                                  -c(58,91,38,38,1,5,5,0) ]),
                         member(Seed, [0,1,2]) )),
                Counts == Wanted ]) :-
    turned_steps(Seed, Steps),
    All = [ cylinder(radius(1), height(2), facets(12)),
            hollow_cylinder(radius(1.5), inner(1), height(2), facets(12)),
            at([rotate(x,90),translate(0,0,1)], rectangle(size(4,3)))
          | Terms ],
    length(All, N),
    numlist(1, N, Ss),
    S is N+1,
    in_new_world(( forall(nth1(I, All, Term),
                          assert_fact(segment(I, solid,
                                              at(Steps, named(part, Term))))),
                   assert_fact(segment(S, cells, glue(Ss))),
                   evaluate(S),
                   glue_report(S, Report) )),
    report_counts(Report, Counts).

turned_steps(0, []) :-
    !.
turned_steps(Seed, Steps) :-
    turned(Seed, Steps).

%   Glue, unglue, undo, redo.

test(undo_redo, [R0,G0] == [R1,G1]) :-
    in_new_world(( forall(member(S-Part, [1-box(1,[0,0,0]),2-box(1,[1,0,0])]),
                          part_made([], S, Part)),
                   facts_transaction(( assert_fact(segment(3, cells,
                                                           glue([1,2]))),
                                       evaluate(3) )),
                   rows(G0),
                   unglue(3), rows(R0),
                   facts_undo, rows(G1),
                   facts_redo, rows(R1) )).

rows(Rows) :-
    findall(v(A,B,C,D,E), v(A,B,C,D,E), Vs),
    findall(e(A,B,C,D,E), e(A,B,C,D,E), Es),
    findall(p(A,B,C), p(A,B,C), Ps),
    findall(s(A,B,C,D), sides(A,B,C,D), Ss),
    append([Vs,Es,Ps,Ss], Rows).

:- end_tests(glue_grid).
