:- module(sg_arguments,
          [ parsed_arguments/4          % +Specs, +Arguments, -Files, -Options
          ]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../spelling', [near_words/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, member/2, reverse/2]).
:- use_module(library(option), [option/2]).
/** <module> Command-line arguments.

As other programs of today: `--name=value`, `--name value`, `--flag`,
`--no-flag`, `-x value`, `-xvalue`, `-` is a file (standard input), `--` ends
the options, and options may follow files.

A specification is option(Name, Short, Type, Meta, Help): Short a one-letter
atom or `''`; Type one of

    flag              no value
    value             any text, given once
    each              any text, may be repeated: a list, in order
    one_of(Atoms)     one of these words
    number(Low)       a number not below Low
    number(Low,High)  nor above High
    above(Low)        a number above Low
    whole(Low,High)   a whole number, an integer then, from Low to High

`--name` on the command line becomes Name(Value) in Options.
*/

%!  parsed_arguments(+Specs, +Arguments, -Files, -Options) is det.
%
%   True when Arguments, a list of atoms, are Files (atoms) and Options.
%
%   @error usage_error(What): unknown_option(Text, Near), Near those that may be
%   meant, no_value(Text), needs_value(Text, What), option_twice(Text),
%   bad_value(Text, Value, Type)

parsed_arguments(Specs, Arguments, Files, Options) :-
    parsed(Arguments, Specs, Files, Given),
    foldl(gathered, Given, [], Options0),
    reverse(Options0, Options).

usage_error(What) :-
    throw(error(usage_error(What), _)).

parsed([], _, [], []).
parsed(['--'|Files], _, Files, []) :-
    !.
parsed([Argument|Rest], Specs, Files, Given) :-
    (   long_option(Argument, Text, Value)
    ->  find_long(Text, Specs, Spec, Sense),
        taken(Spec, Sense, Text, Value, Rest, Rest1, Given, Given1),
        parsed(Rest1, Specs, Files, Given1)
    ;   short_option(Argument, Letter, Value)
    ->  find_short(Letter, Specs, Spec, Text),
        short_value(Spec, Value, Rest, Value1, Rest0),
        taken(Spec, true, Text, Value1, Rest0, Rest1, Given, Given1),
        parsed(Rest1, Specs, Files, Given1)
    ;   Files = [Argument|Files1],
        parsed(Rest, Specs, Files1, Given)
    ).

%   long_option(Argument, Text, Value): Value is value(V), or none.

long_option(Argument, Text, Value) :-
    sub_atom(Argument, 0, 2, _, --),
    (   sub_atom(Argument, Before, 1, After, =)
    ->  sub_atom(Argument, 0, Before, _, Text),
        sub_atom(Argument, _, After, 0, V),
        Value = value(V)
    ;   Text = Argument,
        Value = none
    ).

short_option(Argument, Letter, Value) :-
    sub_atom(Argument, 0, 1, After, -),
    After > 0,
    sub_atom(Argument, 1, 1, _, Letter),
    \+ ( atom_number(Argument, _) ),
    (   sub_atom(Argument, 2, _, 0, Rest),
        Rest \== ''
    ->  Value = value(Rest)
    ;   Value = none
    ).

%   `-qo x` is -q and -o x.

short_value(option(_, _, flag, _, _), value(More), Rest, none,
            [More1|Rest]) :-
    !,
    atom_concat(-, More, More1).
short_value(_, Value, Rest, Value, Rest).

find_long(Text, Specs, Spec, Sense) :-
    (   spec_named(Text, Specs, Spec)
    ->  Sense = true
    ;   atom_concat('--no-', Name, Text),
        atom_concat('--', Name, Positive),
        spec_named(Positive, Specs, Spec),
        arg(3, Spec, flag)
    ->  Sense = false
    ;   near_options(Text, Specs, Near),
        usage_error(unknown_option(Text, Near))
    ).

%   `--no-gird` may be --no-grid.

near_options(Text, Specs, Near) :-
    findall(Known,
            ( member(option(Name,_,Type,_,_), Specs),
              (   Known = Name
              ;   Type == flag,
                  atom_concat('no-', Name, Known)
              )
            ),
            All),
    atom_concat('--', Word, Text),
    near_words(Word, All, Names),
    maplist(atom_concat('--'), Names, Near).

spec_named(Text, Specs, Spec) :-
    atom_concat('--', Name, Text),
    Spec = option(Name, _, _, _, _),
    memberchk(Spec, Specs).

find_short(Letter, Specs, Spec, Text) :-
    atom_concat(-, Letter, Text),
    (   member(Spec, Specs),
        arg(2, Spec, Letter)
    ->  true
    ;   usage_error(unknown_option(Text, []))
    ).

%   taken(Spec, Sense, Text, Value, Rest, Rest1, Given, Given1): the option
%   with its value, perhaps the next argument, is the first of Given.

taken(option(Name, _, flag, _, _), Sense, Text, Value, Rest, Rest,
      [given(Name, flag, Text, Sense)|Given], Given) :-
    !,
    (   Value == none
    ->  true
    ;   usage_error(no_value(Text))
    ).
taken(option(Name, _, Type, _, _), _, Text, value(V0), Rest, Rest,
      [given(Name, Type, Text, V)|Given], Given) :-
    !,
    typed_value(Type, Text, V0, V).
taken(option(Name, _, Type, _, _), _, Text, none, [V0|Rest], Rest,
      [given(Name, Type, Text, V)|Given], Given) :-
    \+ looks_like_option(V0),
    !,
    typed_value(Type, Text, V0, V).
taken(option(_, _, _, What, _), _, Text, _, _, _, _, _) :-
    usage_error(needs_value(Text, What)).

looks_like_option(Argument) :-
    sub_atom(Argument, 0, 1, _, -),
    sub_atom(Argument, 1, 1, _, Next),
    (   Next == (-)
    ->  true
    ;   char_type(Next, alpha)
    ).

typed_value(one_of(Words), Text, Value, Value) :-
    !,
    (   member(Value, Words)
    ->  true
    ;   usage_error(bad_value(Text, Value, one_of(Words)))
    ).
typed_value(Type, Text, Value0, Value) :-
    number_type(Type),
    !,
    (   decimal_number(Value0, Number),
        number_of_type(Type, Number, Value)
    ->  true
    ;   usage_error(bad_value(Text, Value0, Type))
    ).
typed_value(_, _, Value, Value).

number_type(number(_)).
number_type(number(_, _)).
number_type(above(_)).
number_type(whole(_, _)).

number_of_type(number(Low), Number, Number) :-
    Number >= Low.
number_of_type(number(Low, High), Number, Number) :-
    Number >= Low,
    Number =< High.
number_of_type(above(Low), Number, Number) :-
    Number > Low.
number_of_type(whole(Low, High), Number, Value) :-
    Number >= Low,
    Number =< High,
    Value is truncate(Number),
    Value =:= Number.

%   gathered(Given, Options0, Options): repeated ones into one list.

gathered(given(Name, each, _, V), Options0, Options) :-
    !,
    Old =.. [Name, Vs0],
    (   append(Before, [Old|After], Options0)
    ->  append(Vs0, [V], Vs),
        New =.. [Name, Vs],
        append(Before, [New|After], Options)
    ;   New =.. [Name, [V]],
        Options = [New|Options0]
    ).
gathered(given(Name, Type, Text, V), Options0, [New|Options0]) :-
    New =.. [Name, V],
    Old =.. [Name, _],
    (   Type \== flag,
        member(Old, Options0)
    ->  usage_error(option_twice(Text))
    ;   true
    ).
