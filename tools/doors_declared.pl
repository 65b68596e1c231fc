/* What rules/kernel/ and c_kernels/doors.def declare: see doors.pl. */
:- module(sg_doors_declared,
          [ read_types/1,             % +File
            type/2,                   % ?Type, ?What
            c_type/2,                 % +Type, -CType
            c_list/2,                 % +Type, -CType
            type_name/2,              % +Type, -Name
            by_value/1,               % +Type
            is_handle/1,              % +Type
            is_nested/2,              % +Types, +Type
            closes/3,                 % +Name, +Arguments, -Type
            enumerator_name/3,        % +Type, +Word, -Name
            row_columns/2,            % +Arguments, -Columns
            topic_doors/2,            % +File, -Topic
            used/3                    % +Doors, +Modes, -Types
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- op(200, fy, ?).
:- op(200, fy, :).

/*******************************
                *         DECLARATIONS         *
                *******************************/

%   type(Type, What), in the order of the file: What is
%   handle(Struct, Free, Close), words(Enum, Header, Words),
%   record(Struct, Header, Name, Fields), dict(Struct, Fields) or
%   either(Struct, Alternatives). Close, Header and Enum are `-` where there is
%   none.

%   by_hand(Topic, Doors)

:- dynamic type/2, by_hand/2.

read_types(File) :-
    read_file_to_terms(File, Terms, []),
    forall(member(Term, Terms), add_type(Term)).

add_type(by_hand(Topic,Doors)) :-
    !,
    assertz(by_hand(Topic, Doors)).
add_type(Term) :-
    type_of_term(Term, Type, What),
    \+ type(Type, _),
    \+ simple(Type, _),
    !,
    assertz(type(Type, What)).
add_type(Term) :-
    fault("doors.def: ~q is no type, or is there twice", [Term]).

type_of_term(handle(Type,Struct,Free), Type, handle(Struct,Free,-)).
type_of_term(handle(Type,Struct,Free,Close), Type, handle(Struct,Free,Close)).
type_of_term(words(Type,Enum,Header,Words), Type, words(Enum,Header,Words)).
type_of_term(record(Type,Term), Type, record(Struct,-,Name,Fields)) :-
    atom_concat(sg_, Type, Struct),
    Term =.. [Name|Fields].
type_of_term(record(Type,Struct,Header,Term), Type,
             record(Struct,Header,Name,Fields)) :-
    Term =.. [Name|Fields].
type_of_term(dict(Type,Fields), Type, dict(Struct,Fields)) :-
    atom_concat(sg_, Type, Struct).
type_of_term(either(Type,Alternatives), Type, either(Struct,Alternatives)) :-
    atom_concat(sg_, Type, Struct).

%   simple(Type, CType)

simple(id,      int32_t).
simple(int,     int32_t).
simple(count,   size_t).
simple(integer, int64_t).
simple(number,  double).
simple(bool,    bool).
simple(symbol,  int32_t).
simple(bytes,   sg_bytes).
simple(exact,   sg_exact).
simple(name,    'const char *').
simple(input,   sg_input).
simple(output,  sg_output).
simple(text_output, sg_output).
simple(text,    sg_input).
simple(set(id), sg_int_list).
simple(sense,   bool).
simple(term,    'const uint32_t *').

is_type(Type) :-
    simple(Type, _),
    !.
is_type(list(Type)) :-
    !,
    is_type(Type).
is_type(Type) :-
    type(Type, _).

%   c_type(Type, CType), by value.

c_type(Type, CType) :-
    simple(Type, CType),
    !.
c_type(list(Type), CType) :-
    !,
    c_list(Type, CType).
c_type(Type, CType) :-
    type(Type, What),
    c_type_of(What, CType).

c_type_of(handle(Struct,_,_), CType) :-
    atom_concat(Struct, ' *', CType).
c_type_of(words(Enum0,_,_), Enum) :-
    (   Enum0 == (-)
    ->  Enum = int
    ;   Enum = Enum0
    ).
c_type_of(record(Struct,_,_,_), Struct).
c_type_of(dict(Struct,_), Struct).
c_type_of(either(Struct,_), Struct).

c_list(id, sg_int_list) :- !.
c_list(int, sg_int_list) :- !.
c_list(symbol, sg_int_list) :- !.
c_list(count, sg_count_list) :- !.
c_list(number, sg_number_list) :- !.
c_list(integer, sg_integer_list) :- !.
c_list(Type, List) :-
    type_name(Type, Name),
    format(atom(List), "sg_~w_list", [Name]).

%   type_name(Type, Name): part of the names of its functions.

type_name(list(Type), Name) :-
    !,
    type_name(Type, Name0),
    atom_concat(list_, Name0, Name).
type_name(set(Type), Name) :-
    !,
    atom_concat(set_, Type, Name).
type_name(Type, Type).

by_value(Type) :-
    memberchk(Type, [ id, int, count, integer, number, bool, symbol, sense,
                      term, name
                    ]),
    !.
by_value(Type) :-
    type(Type, What),
    memberchk(What, [handle(_,_,_), words(_,_,_)]).

is_handle(Type) :-
    type(Type, handle(_,_,_)).

%   is_nested(Types, Type): something of Types is made of Type.

is_nested(Types, Type) :-
    member(Whole, Types),
    part(Whole, Type),
    !.

enumerator_name(Type, Word, Name) :-
    format(atom(Name0), "SG_~w_~w", [Type,Word]),
    upcase_atom(Name0, Name).

%   closes(Name, Arguments, Type): the door closes handles of Type.

closes(Name, [arg(+,_,Type)], Type) :-
    type(Type, handle(_,_,Name)).

%   row_columns(Arguments, Columns): of a nondeterministic door, the arguments
%   that an answer has, as Name:Type.

row_columns(Arguments, Columns) :-
    findall(Name:Type,
            ( member(arg(Mode,Name,Type), Arguments), Mode \== (+) ),
            Columns).

%   topic_doors(File, topic(Name, Doors)): each of the Doors is
%   door(Name, Arguments, Determinism), an argument is arg(Mode, Name, Type).

topic_doors(File, topic(Topic,Doors)) :-
    file_base_name(File, Base),
    file_name_extension(Topic, pl, Base),
    read_file_to_string(File, Text, []),
    split_string(Text, "\n", "", Lines),
    mode_texts(Lines, Texts),
    maplist(text_modes(File), Texts, Modes0),
    append(Modes0, Modes),
    convlist(mode_door(Topic), Modes, Doors).

%   mode_texts(Lines, Texts): modes on lines one after the other are one text.

mode_texts([], []).
mode_texts([Line|Lines], Texts) :-
    (   string_concat("%!", Text, Line)
    ->  more_mode(Lines, Rest, Text, Whole),
        Texts = [Whole|Texts1]
    ;   Rest = Lines,
        Texts = Texts1
    ),
    mode_texts(Rest, Texts1).

more_mode([Line|Lines], Rest, Text0, Text) :-
    string_concat("%!", More, Line),
    !,
    atomics_to_string([Text0,"\n",More], Text1),
    more_mode(Lines, Rest, Text1, Text).
more_mode(Rest, Rest, Text, Text).

text_modes(File, Text, Modes) :-
    setup_call_cleanup(
        open_string(Text, In),
        catch(read_all(In, Modes), Error,
              ( print_message(error, Error),
                fault("~w: no mode: ~w", [File,Text]) )),
        close(In)).

%   The variables of a mode become the C names of its arguments.

read_all(In, Modes) :-
    read_term(In, Mode, [variable_names(Names),module(sg_doors_declared)]),
    (   Mode == end_of_file
    ->  Modes = []
    ;   forall_named(Names),
        Modes = [Mode|Modes1],
        read_all(In, Modes1)
    ).

forall_named([]).
forall_named([Name=Variable|Names]) :-
    downcase_atom(Name, Variable),
    forall_named(Names).

%   Fails for a door by hand.

mode_door(Topic, Mode, door(Name,Arguments,Determinism)) :-
    (   Mode = (Head is Determinism)
    ->  true
    ;   fault("kernel/~w.pl: ~w: how many answers?", [Topic,Mode])
    ),
    functor(Head, Name, Arity),
    \+ is_by_hand(Topic, Name/Arity),
    Head =.. [_|Modes],
    maplist(argument(Topic, Name), Modes, Arguments).

is_by_hand(Topic, Door) :-
    by_hand(Topic, Doors),
    memberchk(Door, Doors),
    !.

argument(Topic, Name, Mode, Argument) :-
    (   typed_argument(Mode, Argument)
    ->  true
    ;   fault("kernel/~w.pl: ~w: ~w is no +X:Type, -X:Type or ?X:Type",
              [Topic,Name,Mode])
    ).

%   +X:Type is read as (+X):Type or +(X:Type), whichever the operators say.

typed_argument(Mode, arg(In,Variable,Type)) :-
    (   Mode =.. [In,Variable:Type]
    ->  true
    ;   Mode = Argument:Type,
        Argument =.. [In,Variable]
    ),
    memberchk(In, [+,-,?]),
    is_type(Type).

fault(Format, Arguments) :-
    format(user_error, "tools/doors.pl: ", []),
    format(user_error, Format, Arguments),
    nl(user_error),
    halt(1).


                /*******************************
                *         TYPES IN USE         *
                *******************************/

%   used(Doors, Modes, Types): the types that arguments of these Modes have, and
%   what these are made of, each after its own parts.

used(Doors, Modes, Types) :-
    findall(Type,
            ( member(door(_,Arguments,_), Doors),
              member(arg(Mode,_,Type), Arguments),
              memberchk(Mode, Modes)
            ),
            Direct),
    foldl(use, Direct, [], Reversed),
    reverse(Reversed, Types).

use(Type, Types, Types) :-
    memberchk(Type, Types),
    !.
use(Type, Types0, [Type|Types]) :-
    findall(Part, part(Type, Part), Parts),
    foldl(use, Parts, Types0, Types).

part(list(Type), Type).
part(Type, Part) :-
    type(Type, record(_,_,_,Fields)),
    member(_:Part, Fields),
    Part \== any.
part(Type, Part) :-
    type(Type, dict(_,Fields)),
    member(_:Part, Fields).
part(Type, Part) :-
    type(Type, either(_,Alternatives)),
    member(Alternative, Alternatives),
    compound(Alternative),
    (   Alternative = _:Part
    ->  true
    ;   Alternative =.. [_|Fields],
        member(_:Part, Fields)
    ).
