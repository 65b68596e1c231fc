:- module(sg_point_table,
          [ write_point_table/4         % +Format, +Out, +Chains, +Options
          ]).
:- use_module('../penetration/chain', [chain_length/2]).
:- use_module('../penetration/contact', [line_end/4, contact_kind/3]).
:- use_module('../exact', [vertex_exact/5]).
:- use_module('../explanation/explain',
              [statement_text/2, contact_statement/3]).
:- use_module('../message/explain_words', [exact_text/3]).
:- use_module('../studio/query', [print_table/2]).
:- use_module('../store', [v/5, line/9]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, last/2, nth1/3]).
:- use_module(library(option), [option/2]).

/** <module> The points of penetration lines, as a table.

One row for each point of each chain, in the order of the chain; of a closed
one the first comes again as the last, with the whole length. `.csv` and `.tsv`
have the columns

    chain kind s1 s2 point v1 v2 x y z length p1 p2 contact place1 place2

v1 and v2 being the point's vertices, p1 and p2 the polygons of the piece that
begins there (at the last point: that ends there), `contact` the pair of
features that touch and place1 and place2 what these are in either segment.
`.txt` is for people: a block for each chain, with what touches in words.
*/

%!  write_point_table(+Format, +Out, +Chains:list, +Options) is det.
%
%   Write the points of Chains, as chains/1 of chain.pl has them, as Format
%   (`csv`, `tsv`, `txt`) to stream Out. With exact(true) in Options coordinates
%   are fractions, not decimal numbers: those of the points before rounding.

write_point_table(txt, Out, Chains, Options) :-
    !,
    with_output(Out, print_chains(Chains, Options)).
write_point_table(Format, Out, Chains, Options) :-
    separator(Format, Separator),
    columns(Columns),
    write_row(Out, Separator, Columns),
    forall(nth1(C, Chains, Chain),
           write_chain(Out, Separator, C, Chain, Options)).

columns([chain, kind, s1, s2, point, v1, v2, x, y, z, length, p1, p2, contact,
         place1, place2]).

separator(csv, ',').
separator(tsv, '\t').

write_chain(Out, Separator, C, Chain, Options) :-
    Chain = chain(S1, S2, Kind, _),
    chain_rows(Chain, Rows),
    forall(nth1(I, Rows, row(Seat1, Seat2, Polygons, Length)),
           ( Seat1 = seat(_, V1, Place1),
             Seat2 = seat(_, V2, Place2),
             Polygons = P1-P2,
             contact_kind(Place1, Place2, Contact),
             coordinates(Options, Seat1, [X,Y,Z]),
             maplist(place_text, [Place1,Place2], [Text1,Text2]),
             write_row(Out, Separator,
                       [C, Kind, S1, S2, I, V1, V2, X, Y, Z, Length, P1, P2,
                        Contact, Text1, Text2]) )).

write_row(Out, Separator, Values) :-
    atomic_list_concat(Values, Separator, Line),
    format(Out, "~w~n", [Line]).

place_text(vertex(V), Text) :-
    format(atom(Text), 'vertex ~d', [V]).
place_text(edge(V1, V2), Text) :-
    format(atom(Text), 'edge ~d-~d', [V1, V2]).
place_text(face(P, _), Text) :-
    format(atom(Text), 'face ~d', [P]).

coordinates(Options, seat(S,V,_), Texts) :-
    option(exact(true), Options),
    !,
    once(vertex_exact(S, V, X, Y, Z)),
    maplist(exact_word, [X,Y,Z], Texts).
coordinates(_, seat(S,V,_), [X,Y,Z]) :-
    once(v(S, V, X, Y, Z)).

exact_word(X, Text) :-
    exact_text(X, _, Text).

/* - - - rows - - - */

%   chain_rows(+Chain, -Rows): row(Seat1, Seat2, P1-P2, Length) of each point,
%   Length what was run so far.

chain_rows(chain(_, _, Kind, Lines), Rows) :-
    Lines = [First|_],
    maplist(step_row(start), Lines, Starts),
    (   Kind == point
    ->  Ends = Starts
    ;   last(Lines, Last),
        step_row(end, Last, End),
        append(Starts, [End], Ends)
    ),
    step_row(start, First, row(seat(S,V,_), _, _)),
    place(S, V, Point),
    foldl(measured, Ends, Rows-Point-0.0, []-_-_).

measured(row(Seat1, Seat2, Polygons),
         [row(Seat1, Seat2, Polygons, Length)|Rows]-Point0-Length0,
         Rows-Point-Length) :-
    Seat1 = seat(S, V, _),
    place(S, V, Point),
    Point0 = p(X0,Y0,Z0),
    Point = p(X,Y,Z),
    Length is Length0 + sqrt((X-X0)**2 + (Y-Y0)**2 + (Z-Z0)**2).

place(S, V, p(X,Y,Z)) :-
    once(v(S, V, X, Y, Z)).

%   step_row(+Which, +Step, -Row): the start or the end of a walk along a line,
%   backward if Step is below zero.

step_row(Which, Step, row(Seat1, Seat2, P1-P2)) :-
    L is abs(Step),
    line(L, _, P1, _, _, _, P2, _, _),
    (   Step > 0
    ->  End = Which
    ;   other_end(Which, End)
    ),
    line_end(L, End, Seat1, Seat2),
    !.

other_end(start, end).
other_end(end, start).

/* - - - for people - - - */

:- meta_predicate with_output(+, 0).

with_output(Out, Goal) :-
    current_output(Old),
    setup_call_cleanup(
        set_output(Out),
        once(Goal),
        set_output(Old)).

print_chains(Chains, Options) :-
    forall(nth1(C, Chains, Chain), print_chain(C, Chain, Options)).

print_chain(C, Chain, Options) :-
    Chain = chain(S1, S2, Kind, Lines),
    (   C > 1
    ->  nl
    ;   true
    ),
    length(Lines, N),
    chain_length(Lines, Length),
    statement_text(chain_head(C, Kind, S1, S2, N, Length), Head),
    format("~w~n", [Head]),
    chain_rows(Chain, Rows0),
    findall([I,V1,V2,X,Y,Z,'$text'(Words)],
            ( nth1(I, Rows0, row(Seat1, Seat2, _, _)),
              printed_row(Options, Seat1, Seat2, [V1,V2,X,Y,Z,Words]) ),
            Rows),
    print_table([point, v1, v2, x, y, z, contact], Rows).

printed_row(Options, Seat1, Seat2, [V1,V2,X,Y,Z,Words]) :-
    Seat1 = seat(_, V1, _),
    Seat2 = seat(_, V2, _),
    coordinates(Options, Seat1, Coordinates),
    maplist(readable, Coordinates, [X,Y,Z]),
    contact_statement(Seat1, Seat2, Statement),
    statement_text(Statement, Words).

%   To 15 digits, so that 0.1+0.2 is 0.3.

readable(Value, Number) :-
    float(Value),
    !,
    format(atom(Text), '~15g', [Value]),
    atom_number(Text, Number).
readable(Value, Value).
