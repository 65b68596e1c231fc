/* Tables of true lengths on paper of many sizes: every row is there once,
   letters can be read, and there are no more parts than there have to be. */
:- module(test_pattern_table, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(pattern/pattern_table)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(unrolling/true_development)).
:- use_module(rules(unrolling/true_table)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- dynamic world/4.

%   The world, the pattern in it, how many rows its table has and how large it
%   is with letters of 2.5 mm.

made :-
    new_world(World),
    in_world(World,
             ( add_primitive(cone(radius(50), top(20), height(80), facets(48)),
                             1),
               complete_segments,
               true_development(1, side, [generators(48)], D),
               true_length_rows(D, Rows),
               true_length_marks(D, [], _, Size) )),
    length(Rows, N),
    assertz(world(World, D, N, Size)).

%   laid(+Paper, -Whole, -Tables, -N): Tables on Paper of a table of N rows,
%   which is as large as Whole, W-H.

laid(Paper, Whole, Tables, N) :-
    world(World, D, N, Whole),
    in_world(World, pattern_tables([D], [], Paper, Tables)).

%   tables_fault(+Paper, -Fault) is nondet: by arithmetic alone. Rows are twice
%   as high as letters, the row of names is one more in each part.

tables_fault(room(RW,RH,_), Fault) :-
    laid(room(RW,RH,5), W-H, Tables, N),
    findall(W1-H1, member(table(_,_,_,W1-H1), Tables), Sizes),
    length(Sizes, Count),
    (   Count =:= 0
    ->  Wide is max(RW,RH)*0.96,
        Wide >= W*0.5001,               % letters of 1.25 mm and more
        Fault = left_out
    ;   findall(Rows, ( member(Size, Sizes), rows_in(Size, W, Rows) ), Own),
        sum_list(Own, Sum),
        (   Sum =\= N,
            Fault = rows(Sum, N)
        ;   max_list(Own, Longest),
            min_list(Own, Shortest),
            Longest-Shortest > 1,
            Fault = uneven(Own)
        )
    ;   member(W1-H1, Sizes),
        \+ fits(W1, H1, RW, RH),
        Fault = too_large(W1, H1)
    ;   member(W1-_, Sizes),
        W1/W < 0.4999,
        Fault = letters(W1/W)
    ;   Tables = [table(_,0,_,W1-_)],
        W1 < W*0.9999,
        Share is 0.96*max(min(RW/W,RH/H), min(RW/H,RH/W)),
        abs(W1/W-Share) > 1.0e-9,
        Fault = smaller(W1/W, Share)
    ;   Tables = [table(_,0,_,W1-_)],
        W1 < W*0.6999,
        Fault = rather_divided(W1/W)
    ;   Count > 1,
        Share is 0.96*max(min(RW/W,RH/H), min(RW/H,RH/W)),
        Share >= 0.7,
        Fault = rather_whole(Share)
    ;   Count > 1,
        Sizes = [W1-_|_],
        Row is 5.0*W1/W,
        Fewer is ceiling(N/(Count-1))+1,
        High is Row*Fewer,
        fits_long(W1, High, RW, RH),
        Fault = fewer_parts(Count)
    ).

rows_in(W1-H1, W, Rows) :-
    Rows is round(H1/(5.0*W1/W))-1.

fits(W, H, RW, RH) :-
    ( W =< RW, H =< RH ; W =< RH, H =< RW ),
    !.

%   A part lies as its width wants it: 4 % of the room are left.

fits_long(W, H, RW, RH) :-
    ( W =< 0.96*RW*1.000001, H =< 0.96*RH*0.999999
    -> true
    ; W =< 0.96*RH*1.000001, H =< 0.96*RW*0.999999,
      W > 0.96*RW*0.999999
    ).

:- begin_tests(pattern_table, [ setup(made),
                                cleanup(retractall(world(_,_,_,_))) ]).

test(roll, Sizes == [Whole]) :-
    laid(roll(500), Whole, Tables, _),
    findall(Size, member(table(_,0,_,Size), Tables), Sizes).
test(rooms, Faults == []) :-
    findall(W-H-Fault,
            ( member(W, [120,133,135,150,180,200,240,266,277,400]),
              member(H, [20,30,40,77,101,133,190,240,277,400]),
              tables_fault(room(W,H,5), Fault) ),
            Faults).
% A part has one row at least, below the names of the columns.
test(one_row, Counts == [49,0]) :-
    findall(Count,
            ( member(H, [11,10]),
              laid(room(277,H,5), _, Tables, _),
              length(Tables, Count) ),
            Counts).
test(parts_are_numbered, Names == [part(1),part(2),part(3)]) :-
    laid(room(270,110,5), _, Tables, _),
    findall(part(I), member(table(_,I,_,_), Tables), Names).
test(counts, [ nondet, true((memberchk(0, Counts), memberchk(1, Counts),
                      max_list(Counts, Most), Most > 2)) ]) :-
    findall(Count,
            ( member(W-H, [400-400,270-133,20-20,270-60]),
              laid(room(W,H,5), _, Tables, _),
              length(Tables, Count) ),
            Counts).

:- end_tests(pattern_table).
