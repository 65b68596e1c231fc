:- module(sg_parameter,
          [ settings_of/2,              % +Options, -Settings
            settings_met/2,             % +Settings, +Names
            file_parameters/3,          % +Items, +Settings, -Parameters
            parameter_value/3           % +Parameters, ?Name, -Value
          ]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../formula',
              [ formula_parameter/2, formula_value/3, has_formula/1,
                is_formula/1 ]).
:- use_module('../limits', [term_of_text/3, text_beyond/5]).
:- use_module('../spelling', [near_words/3]).
:- use_module(model_text, [model_float/2, place_error/2, place_error/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc),
              [ assoc_to_keys/2, empty_assoc/1, gen_assoc/3, get_assoc/3,
                list_to_assoc/2, put_assoc/4
              ]).
:- use_module(library(error), [must_be/2, type_error/2]).
:- use_module(library(lists), [append/3, list_to_set/2, member/2, reverse/2]).
:- use_module(library(option), [option/3]).
/** <module> The parameters of a model file, and what sets them.

`param(Name, Default)`, Default a number or a formula (formula.pl), makes Name a
parameter of the file. A setting takes the place of a default.
*/

%!  settings_of(+Options, -Settings) is det.
%
%   Settings are the pairs Name-Value that Options ask for: set(Texts), as on
%   the command line, each `NAME=VALUE`, VALUE a number or a formula of numbers;
%   parameters(List), each Name=Value.
%
%   @error usage_error(parameter(What)): setting(Text, Why), Why one of form,
%   comma(Point), unit(Unit), number, formula(What, Formula), limit(Name, Most);
%   set_twice(Name).
%   type_error(float, Value)

settings_of(Options, Settings) :-
    option(set(Texts), Options, []),
    maplist(text_setting, Texts, Settings1),
    option(parameters(Given), Options, []),
    must_be(list, Given),
    maplist(given_setting, Given, Settings2),
    append(Settings1, Settings2, Settings),
    set_once(Settings).

text_setting(Text, Name-Value) :-
    (   sub_atom(Text, Before, 1, _, =),
        Before > 0
    ->  sub_atom(Text, 0, Before, _, Name0),
        Start is Before+1,
        sub_string(Text, Start, _, 0, Number),
        split_string(Name0, "", " ", [NameText]),
        atom_string(Name, NameText)
    ;   setting_error(Text, form)
    ),
    (   text_beyond(facts, Number, Limit, _, _)
    ->  setting_error(Text, Limit)
    ;   decimal_number(Number, Value),
        model_float(Value, _)
    ->  true
    ;   comma_meant(Number, Point)
    ->  setting_error(Text, comma(Point))
    ;   number_formula(Number, Formula)
    ->  catch(formula_value(Formula, no_parameter, Value),
              error(model_error(What), _), setting_error(Text, What))
    ;   unit_meant(Number, Unit)
    ->  setting_error(Text, unit(Unit))
    ;   setting_error(Text, number)
    ).

no_parameter(_, _) :-
    fail.

%   number_formula(Text, Formula): Text is of numbers as people write them, and
%   what stands between them.

number_formula(Text, Formula) :-
    string_codes(Text, Codes),
    \+ ( append(_, [Digit,Next|_], Codes),
         code_type(Digit, digit),
         code_type(Next, csymf),
         \+ memberchk(Next, `eE`) ),
    \+ ( member(Code, Codes),
         \+ code_type(Code, csym),
         \+ memberchk(Code, ` ()+-*/^.,`) ),
    catch(term_of_text(Text, Formula, []), error(syntax_error(_), _), fail),
    ground(Formula),
    is_formula(Formula).

setting_error(Text, What) :-
    throw(error(usage_error(parameter(setting(Text, What))), _)).

%   comma_meant(Text, Point): Text is no number and no formula of numbers; but
%   Point, with points for the commas between digits, is one.

comma_meant(Text, Point) :-
    string_codes(Text, Codes),
    points_for_commas(Codes, Codes1),
    Codes1 \== Codes,
    \+ is_value(Text),
    split_string(Codes1, "", " ", [Trimmed]),
    is_value(Trimmed),
    atom_string(Point, Trimmed).

is_value(Text) :-
    decimal_number(Text, _),
    !.
is_value(Text) :-
    number_formula(Text, Formula),
    catch(formula_value(Formula, no_parameter, _), error(_, _), fail).

%   points_for_commas(Codes0, Codes): of each comma between two digits.

points_for_commas([A,0',,B|Codes0], [A,0'.|Codes]) :-
    code_type(A, digit),
    code_type(B, digit),
    !,
    points_for_commas([B|Codes0], Codes).
points_for_commas([Code|Codes0], [Code|Codes]) :-
    !,
    points_for_commas(Codes0, Codes).
points_for_commas([], []).

%   unit_meant(Text, Unit): Text is a number with letters or a sign behind it.

unit_meant(Text, Unit) :-
    split_string(Text, "", " ", [Trimmed]),
    string_chars(Trimmed, Chars),
    reverse(Chars, Backwards),
    unit_chars(Backwards, [], UnitChars, Rest),
    UnitChars = [_|_],
    reverse(Rest, Digits),
    string_chars(Number, Digits),
    decimal_number(Number, _),
    atom_chars(Unit, UnitChars).

unit_chars([Char|Chars], Unit0, Unit, Rest) :-
    (   char_type(Char, alpha)
    ;   memberchk(Char, ['%','"','\'','\u00B0'])
    ),
    !,
    unit_chars(Chars, [Char|Unit0], Unit, Rest).
unit_chars(Rest, Unit, Unit, Rest).

given_setting(Setting, Name-Value) :-
    (   nonvar(Setting),
        Setting = (Name = Value)
    ->  must_be(atom, Name),
        (   model_float(Value, _)
        ->  true
        ;   type_error(float, Value)
        )
    ;   type_error(setting, Setting)
    ).

set_once(Settings) :-
    (   append(_, [Name-_|Rest], Settings),
        member(Name-_, Rest)
    ->  throw(error(usage_error(parameter(set_twice(Name))), _))
    ;   true
    ).

%!  settings_met(+Settings, +Names) is det.
%
%   Every one of Settings is of a parameter among Names.
%
%   @error usage_error(parameter(unset(Name, Near, Names)))

settings_met(Settings, Names) :-
    (   member(Name-_, Settings),
        \+ memberchk(Name, Names)
    ->  list_to_set(Names, Known),      % several models may have the same
        near_words(Name, Known, Near),
        throw(error(usage_error(parameter(unset(Name, Near, Known))), _))
    ;   true
    ).


                /*******************************
                *             FILES            *
                *******************************/

%!  file_parameters(+Items, +Settings, -Parameters) is det.
%
%   Items are given(Name, Written, Place) of the param/2 facts of a file.
%   Parameters are parameter(Name, Written, Value) of them, each after those
%   that its formula needs, as Settings have it: of a parameter that is set,
%   Written is its value.
%
%   @error model_error(What) at a Place: twice(param, [Name]),
%   formula(What, Formula), parameter(cycle(Names))

file_parameters(Items0, Settings, Parameters) :-
    named_once(Items0),
    maplist(set_item(Settings), Items0, Items),
    maplist(named_item, Items, Pairs),
    list_to_assoc(Pairs, Index),
    empty_assoc(None),
    foldl(parameter_known([], Index), Items, known([], None),
          known(Known, _)),
    reverse(Known, Parameters).

named_item(Item, Name-Item) :-
    Item = given(Name, _, _).

named_once(Items) :-
    empty_assoc(None),
    foldl(new_name, Items, None, _).

new_name(given(Name, _, Place), Seen0, Seen) :-
    (   get_assoc(Name, Seen0, _)
    ->  place_error(Place, twice(param, [Name]))
    ;   put_assoc(Name, Seen0, true, Seen)
    ).

set_item(Settings, given(Name, Written0, Place),
         given(Name, Written, Place)) :-
    (   memberchk(Name-Value, Settings)
    ->  Written = Value
    ;   Written = Written0
    ).

%   parameter_known(Path, Index, Item, Known0, Known): Known has Item, and what
%   its formula needs: known(Parameters, Values), the last one first, and values
%   by names. Index has Items by names. Path are the names that wait for Item,
%   the nearest first.

parameter_known(_, _, given(Name, _, _), Known, Known) :-
    arg(2, Known, Values),
    get_assoc(Name, Values, _),
    !.
parameter_known(Path, _, given(Name, _, Place), _, _) :-
    memberchk(Name, Path),
    append(Before, [Name|_], Path),
    !,
    reverse([Name|Before], Round),
    place_error(Place, 2, parameter(cycle([Name|Round]))).
parameter_known(Path, Index, given(Name, Written, Place), Known0,
                known([parameter(Name, Written, Value)|Parameters], Values)) :-
    (   has_formula(Written)
    ->  findall(Item,
                ( formula_parameter(Written, Other),
                  get_assoc(Other, Index, Item) ),
                Needed),
        none_unknown(Written, Index, Place),
        foldl(parameter_known([Name|Path], Index), Needed, Known0,
              known(Parameters, Values0)),
        catch(formula_value(Written, value_in(Values0), Value),
              error(model_error(What), _), place_error(Place, 2, What))
    ;   Value = Written,
        Known0 = known(Parameters, Values0)
    ),
    put_assoc(Name, Values0, Value, Values).

value_in(Values, Name, Value) :-
    (   atom(Name)
    ->  get_assoc(Name, Values, Value)
    ;   gen_assoc(Name, Values, Value)
    ).

%   none_unknown(Written, Index, Place): all of Index may be meant, not only
%   those that are known by now.

none_unknown(Written, Index, Place) :-
    (   formula_parameter(Written, Name),
        \+ get_assoc(Name, Index, _)
    ->  assoc_to_keys(Index, Others),
        near_words(Name, Others, Near),
        place_error(Place, 2, formula(unknown(Name, Near), Written))
    ;   true
    ).

%!  parameter_value(+Parameters, ?Name, -Value) is nondet.
%
%   Value is that of the parameter Name of Parameters, as file_parameters/3
%   gives them.

parameter_value(Parameters, Name, Value) :-
    member(parameter(Name, _, Value), Parameters).
