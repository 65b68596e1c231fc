:- module(sg_shifted,
          [ shifted/3,                  % +Shift, +Fact, -Row
            own_numbers/3               % +What, +Location, +Shift
          ]).
:- use_module('../csg/csg_term', [is_node_term/1, map_operands/3]).
:- use_module(library(apply), [maplist/3]).
/** <module> Facts of a file with the numbers that they have in the world.

The segments and lines of a file come after those that are there: Shift is
shift(DS, DL), what is added to the numbers of its segments and of its lines.
*/

%!  shifted(+Shift, +Fact, -Row) is det.
%
%   Row is Fact with the world's numbers.

shifted(shift(0, 0), Fact, Row) :-
    !,
    Row = Fact.
shifted(shift(DS, DL), line(L0, S1, P1, A1, B1, S2, P2, A2, B2), Row) :-
    !,
    Row = line(L, T1, P1, A1, B1, T2, P2, A2, B2),
    L is L0+DL,
    T1 is S1+DS,
    T2 is S2+DS.
shifted(shift(DS, DL), origin(S0, Item0, Origin0), origin(S, Item, Origin)) :-
    !,
    S is S0+DS,
    (   Item0 == s(S0)
    ->  Item = s(S)
    ;   Item = Item0
    ),
    origin_shifted(Origin0, DS, DL, Origin).
shifted(shift(DS, _), from_v(S0, V, T0, W), from_v(S, V, T, W)) :-
    !,
    S is S0+DS,
    T is T0+DS.
shifted(shift(DS, _), from_p(S0, P, T0, Q, Sense), from_p(S, P, T, Q, Sense)) :-
    !,
    S is S0+DS,
    T is T0+DS.
shifted(shift(DS, _), from_r(S0, R, T0, Q), from_r(S, R, T, Q)) :-
    !,
    S is S0+DS,
    T is T0+DS.
shifted(shift(DS, _), gluing(S0, Wish0), gluing(S, Wish)) :-
    !,
    S is S0+DS,
    (   wish_shifted(Wish0, DS, Wish)
    ->  true
    ;   Wish = Wish0
    ).
shifted(shift(DS, _), segment(S0, Kind, Term0), Row) :-
    is_node_term(Term0),
    !,
    Row = segment(S, Kind, Term),
    S is S0+DS,
    operand_shifted(DS, Term0, Term).
shifted(shift(DS, _), segment(S0, Kind, Term0), Row) :-
    made_of(Term0, DS, Term),
    !,
    Row = segment(S, Kind, Term),
    S is S0+DS.
shifted(shift(DS, _), Fact, Row) :-
    segment_relation(Fact),
    !,
    Fact =.. [Name, S0|Rest],
    S is S0+DS,
    Row =.. [Name, S|Rest].
shifted(_, Fact, Fact).

segment_relation(Fact) :-
    functor(Fact, Name, Arity),
    \+ memberchk(Name/Arity, [ view/3, projection/1, title_block/2, param/2,
                              param_about/2, light/2, question/2 ]).

%   made_of(Term0, DS, Term): Term0 names the segments that another was made of.

made_of(development(S0), DS, development(S)) :-
    integer(S0),
    S is S0+DS.
made_of(trimmed(S0, Side, Others0), DS, trimmed(S, Side, Others)) :-
    integer(S0),
    is_list(Others0),
    S is S0+DS,
    Less is -DS,
    part_less(Less, Others0, Others).

%   wish_shifted(Wish0, DS, Wish) is semidet: with the numbers of its operands.

wish_shifted(apart(S1, S2), DS, Wish) :-
    Less is -DS,
    maplist(part_less(Less), [S1,S2], Operands),
    Wish =.. [apart|Operands].
wish_shifted(apart(Place0), DS, apart(Place)) :-
    part_shifted(DS, Place0, Place).
wish_shifted(glued(Place1, Place2), DS, Wish) :-
    maplist(part_shifted(DS), [Place1,Place2], Places),
    Wish =.. [glued|Places].
wish_shifted(dissolve(Name1, Name2), DS, Wish) :-
    maplist(region_shifted(DS), [Name1,Name2], Names),
    Wish =.. [dissolve|Names].

region_shifted(DS, Name0, Name) :-
    (   compound(Name0),
        compound_name_arguments(Name0, region, [Operands0|K]),
        is_list(Operands0)
    ->  Less is -DS,
        part_less(Less, Operands0, Operands),
        compound_name_arguments(Name, region, [Operands|K])
    ;   Name = Name0
    ).

%   operand_shifted(DS, Operand0, Operand): one that is no good stays, and is
%   found later.

operand_shifted(DS, Operand0, Operand) :-
    (   integer(Operand0)
    ->  Operand is Operand0+DS
    ;   is_node_term(Operand0),
        map_operands(operand_shifted(DS), Operand0, Operand1)
    ->  Operand = Operand1
    ;   Operand = Operand0
    ).

origin_shifted(line(L0), _, DL, line(L)) :-
    integer(L0),
    !,
    L is L0+DL.
origin_shifted(v(S0, V), DS, _, v(S, V)) :-
    integer(S0),
    !,
    S is S0+DS.
origin_shifted(Origin0, DS, _, Origin) :-
    compound(Origin0),
    compound_name_arguments(Origin0, Name, Parts0),
    memberchk(Name, [lpi, ll, tpi]),
    !,
    maplist(part_shifted(DS), Parts0, Parts),
    compound_name_arguments(Origin, Name, Parts).
origin_shifted(Origin, _, _, Origin).

part_shifted(DS, S0-Part, S-Part) :-
    integer(S0),
    !,
    S is S0+DS.
part_shifted(_, Part, Part).


                /*******************************
                *            FAULTS            *
                *******************************/

%!  own_numbers(+What, +Location, +Shift) is det.
%
%   Always raises What, a fault of a file, with the file's segment number, not
%   the world's.
%
%   @error error(model_error(What1), Location)

own_numbers(What0, Location, shift(DS, _)) :-
    (   segment_place(What0, N),
        arg(N, What0, Old),
        less(Old, DS, New)
    ->  duplicate_term(What0, What),
        setarg(N, What, New)
    ;   What = What0
    ),
    throw(error(model_error(What), Location)).

segment_place(missing(_, _, _), 2).
segment_place(twice(_, _), 2).
segment_place(polygon(_, _, _), 1).
segment_place(chain(_, _), 1).
segment_place(no_vertices(_, _), 1).
segment_place(no_edges(_), 1).
segment_place(csg(_), 1).

less([S0|Key], DS, [S|Key]) :-
    integer(S0),
    !,
    S is S0-DS.
less(S0, DS, S) :-
    integer(S0),
    !,
    S is S0-DS.
less(too_many(S0, Count), DS, too_many(S, Count)) :-
    !,
    S is S0-DS.
less(Fault0, DS, Fault) :-
    compound(Fault0),
    compound_name_arguments(Fault0, Name, Parts0),
    memberchk(Name, [missing, cycle, curve, surface]),
    maplist(part_less(DS), Parts0, Parts),
    compound_name_arguments(Fault, Name, Parts).

part_less(DS, Part0, Part) :-
    (   integer(Part0)
    ->  Part is Part0-DS
    ;   is_list(Part0)
    ->  maplist(part_less(DS), Part0, Part)
    ;   Part = Part0
    ).
