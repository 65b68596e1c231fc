:- module(sg_test_source_box,
          [ source/1,                   % ?Source
            box_text/3,                 % +Format, +Box, -Text
            box_loaded/3,               % +Source, +Box, -S
            box_written/4,              % +Box, +Ending, +Binary, -File
            file_loaded/2,              % +File, -S
            box_of/2,                   % +S, -Box
            box_volume/2,               % +Box, -Volume
            common_box/3,               % +Box1, +Box2, -Box
            expected_grain/3,           % +Source, +Box, -Grain
            may_touch/3,                % +Boxes, +Grains, -T
            rounded/2,                  % +Boxes, -R
            told/4                      % +Apart, +Boxes, +T, +Said
          ]).
/** <module> Boxes that come from somewhere, and what docs/precision.md says of
their numbers, by arithmetic.

A box is Low-High, two lists of three coordinates.
*/

:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(debug), [assertion/1]).
:- use_module(library(lists)).
:- use_module(rules(model/mesh)).
:- use_module(rules(model/model)).
:- use_module(rules(store)).

/* - - - boxes in files - - - */

box_corners([X1,Y1,Z1]-[X2,Y2,Z2], Corners) :-
    findall([X,Y,Z],
            ( member(X, [X1,X2]), member(Y, [Y1,Y2]), member(Z, [Z1,Z2]) ),
            Corners).

box_face([0,1,3,2]).
box_face([4,6,7,5]).
box_face([0,4,5,1]).
box_face([2,3,7,6]).
box_face([0,2,6,4]).
box_face([1,5,7,3]).

%!  box_text(Format, Box, Text): as OFF, a number as Format of format/2 says.

box_text(Format, Box, Text) :-
    box_corners(Box, Corners),
    with_output_to(string(Text),
                   ( write('OFF\n8 6 0\n'),
                     forall(member(Corner, Corners),
                            ( forall(member(X, Corner),
                                     ( format(Format, [X]), write(' ') )),
                              nl )),
                     forall(box_face(Face),
                            ( atomic_list_concat([4|Face], ' ', Line),
                              writeln(Line) )) )).

%!  source(Source): where a box may come from.

source(primitive).
source(model).
source(text(17)).
source(text(9)).
source(places(6)).
source(mesh(stl, true)).
source(mesh(stl, false)).
source(mesh(ply, true)).
source(mesh(ply, false)).
source(mesh(obj, false)).

box_loaded(primitive, Low-High, S) :-
    !,
    maplist(less, High, Low, Size0),
    Size =.. [size|Size0],
    Step =.. [translate|Low],
    fresh_id(segment, 0, S),
    assert_fact(segment(S, solid, at([Step], box(Size)))).
box_loaded(model, Box, S) :-
    !,
    box_written(Box, pl, false, File),
    file_loaded(File, S).
box_loaded(text(Digits), Box, S) :-
    !,
    Places is Digits-1,
    format(atom(Format), '~~~de', [Places]),
    text_loaded(Format, Box, S).
box_loaded(places(Places), Box, S) :-
    !,
    format(atom(Format), '~~~df', [Places]),
    text_loaded(Format, Box, S).
box_loaded(mesh(Ending, Binary), Box, S) :-
    box_written(Box, Ending, Binary, File),
    file_loaded(File, S).

text_loaded(Format, Box, S) :-
    box_text(Format, Box, Text),
    tmp_file_stream(File, Stream, [extension(off)]),
    write(Stream, Text),
    close(Stream),
    file_loaded(File, S).

file_loaded(File, S) :-
    call_cleanup(load_model(File, [evaluate(false)]), delete_file(File)),
    aggregate_all(max(N), segment(N, _, _), S).

%!  box_written(Box, Ending, Binary, File): as the engine writes doubles.

box_written(Box, Ending, Binary, File) :-
    new_world(World),
    in_world(World,
             ( text_loaded('~16e', Box, 1),
               retractall_facts(origin(1, _, _)),
               tmp_file_stream(File, Stream, [extension(Ending)]),
               close(Stream),
               (   Ending == pl
               ->  save_model(File)
               ;   write_mesh(File, [1], [binary(Binary)])
               ) )).

/* - - - arithmetic - - - */

%!  expected_grain(Source, Box, Grain): Box as it was read.

expected_grain(mesh(stl, true), Box, Grain) :-
    !,
    farthest(Box, Farthest),
    (   power_of_two(Farthest)
    ->  Grain is Farthest*2.0** -23
    ;   power_above(Farthest, Power),
        Grain is Power*2.0** -24
    ).
expected_grain(text(9), Low-High, Grain) :-
    !,
    farthest(Low-High, Farthest),
    Unit is 10.0**(floor(log10(Farthest)+1.0e-12)-8),
    believed(Unit, Low-High, Grain).
expected_grain(places(6), Low-High, Grain) :-
    !,
    farthest(Low-High, Farthest),
    Digits is floor(log10(max(Farthest, 1.0e-6))+1.0e-12)+1+6,
    (   Digits > 15
    ->  Grain = 0
    ;   believed(1.0e-6, Low-High, Grain)
    ).
expected_grain(_, _, 0).

believed(Unit, Low-High, Grain) :-
    maplist(less, High, Low, Sides),
    max_list(Sides, Size),
    (   Size >= 1.0e5*Unit
    ->  Grain = Unit
    ;   Grain = 0
    ).

farthest(Low-High, Farthest) :-
    append(Low, High, Xs),
    aggregate_all(max(F), ( member(X, Xs), F is abs(X) ), Farthest).

power_above(X, Power) :-
    Exponent is floor(log(X)/log(2))-1,
    Power0 is 2.0**Exponent,
    doubled_to(X, Power0, Power).

doubled_to(X, Power, Power) :-
    X =< Power,
    !.
doubled_to(X, Power0, Power) :-
    Power1 is 2*Power0,
    doubled_to(X, Power1, Power).

power_of_two(X) :-
    power_above(X, Power),
    Power =:= X.

%!  may_touch(Boxes, Grains, T): nothing farther apart than T may.

may_touch(Boxes, Grains, T) :-
    maplist(farthest, Boxes, Far),
    max_list(Far, Farthest),
    max_list(Grains, Grain),
    power_above(Farthest, Power),
    T is max(Power*2.0** -44, 0.875*Grain)*(1+1.0e-9).

%!  rounded(Boxes, R): doubles may be rounded by R.

rounded(Boxes, R) :-
    maplist(farthest, Boxes, Far),
    max_list(Far, Farthest),
    power_above(Farthest, Power),
    R is Power*2.0** -48.

%!  told(Apart, Boxes, T, Said): what is Apart was made one place. Beyond what
%   doubles are rounded by it is told, beyond what the sources explain warned
%   of. T is of may_touch/3.

told(Apart, Boxes, T, Said) :-
    rounded(Boxes, R),
    (   Apart =< R
    ->  true
    ;   T > 16.5*R
    ->  assertion(Said \== [])
    ;   assertion(( member(Word, Said), tight_word(Word) ))
    ).

tight_word(tight(_,_,_,_,_,_)).
tight_word(flattened(_,_,_,_,_)).

box_of(S, [X1,Y1,Z1]-[X2,Y2,Z2]) :-
    aggregate_all(r(min(X), min(Y), min(Z), max(X), max(Y), max(Z)),
                  v(S, _, X, Y, Z), r(X1,Y1,Z1, X2,Y2,Z2)).

box_volume(Low-High, Volume) :-
    foldl(times_side, Low, High, 1, Volume).

times_side(A, B, V0, V) :-
    V is V0*max(0, rational(B)-rational(A)).

less(A, B, C) :-
    C is A-B.

greater_of(A, B, C) :-
    C is max(A, B).

less_of(A, B, C) :-
    C is min(A, B).

common_box(Low1-High1, Low2-High2, Low-High) :-
    maplist(greater_of, Low1, Low2, Low),
    maplist(less_of, High1, High2, High).
