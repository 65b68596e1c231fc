:- encoding(utf8).
:- module(sg_parameter_about,
          [ about_checked/5,            % +Name, +Names, +Items, :Known, +Place
            range_of/4,                 % +Name, -Least, -Most, -Step
            about_text/3,               % +Name, ?Language, -Text
            ranges_told/0,
            ranges_told/1,              % +Abouts
            settings_used/1             % +Settings
          ]).
:- use_module(model_text, [model_float/2, place_error/3, world_parameter/2]).
:- use_module('../formula', [formed/3, formula_parameter/2, is_formula/1]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../store', [param/2, param_about/2, formula/2]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> What a model says of its parameters: their ranges, in words.

    param_about(d, [min(20), max(2000), step(0.1), text(en, 'outside diameter'),
                    text(ko, '바깥지름')]).

Each item once, all may be left out. The numbers may be formulas over other
parameters: a branch is no wider than its header, `max(param(d))`. A value out
of its range is told, and used.
*/

:- meta_predicate about_checked(+, +, +, 2, +).

%!  about_checked(+Name, +Names, +Items, :Known, +Place) is det.
%
%   Items may be said of the parameter Name, in a file with the parameters
%   Names, whose values are Known, as in formula_value/3.
%
%   @error model_error(parameter(about(What))) at Place: no_parameter(Name,
%   Near), list(Items), item(Item), item_twice(Item), order(Least, Most); those
%   of formed/3

about_checked(Name, Names, Items, Known, Place) :-
    (   memberchk(Name, Names)
    ->  true
    ;   near_words(Name, Names, Near),
        about_error(Place, 1, no_parameter(Name, Near))
    ),
    (   is_list(Items)
    ->  catch(maplist(item_formed(Known), Items, Formed),
              error(model_error(What), _), place_error(Place, 2, What))
    ;   about_error(Place, 2, list(Items))
    ),
    (   member(Item, Formed),
        Item \== none,
        \+ about_item(Item)
    ->  about_error(Place, 2, item(Item))
    ;   append(Before, [Again|_], Items),
        item_key(Again, Key),
        member(Other, Before),
        item_key(Other, Key)
    ->  about_error(Place, 2, item_twice(Again))
    ;   memberchk(min(Least), Items),
        memberchk(max(Most), Items),
        maplist(number, [Least,Most]),
        Least >= Most
    ->  about_error(Place, 2, order(Least, Most))
    ;   true
    ).

:- meta_predicate item_formed(2, +, -).

%   item_formed(Known, Item0, Item): Item has the value of the formula; it is
%   `none` if that has no value now, as one that divides by zero.

item_formed(Known, Item0, Item) :-
    (   compound(Item0),
        compound_name_arguments(Item0, Name, [Formula]),
        is_formula(Formula)
    ->  catch(( formed(Formula, Known, Value),
                compound_name_arguments(Item, Name, [Value]) ),
              Error,
              without_value(Error, Item))
    ;   Item = Item0
    ).

without_value(error(model_error(formula(What, _)), _), none) :-
    memberchk(What, [division_by_zero,not_real,too_large]),
    !.
without_value(Error, _) :-
    throw(Error).

about_error(Place, Argument, What) :-
    place_error(Place, Argument, parameter(about(What))).

about_item(Item) :-
    compound(Item),
    about_compound(Item).

about_compound(min(Number)) :-
    model_float(Number, _).
about_compound(max(Number)) :-
    model_float(Number, _).
about_compound(step(Number)) :-
    model_float(Number, Float),
    Float > 0.0.
about_compound(text(Language, Text)) :-
    memberchk(Language, [en,ko]),
    (   atom(Text)
    ->  Text \== []
    ;   string(Text)
    ).

item_key(text(Language, _), text(Language)) :-
    !.
item_key(Item, Key) :-
    functor(Item, Key, 1).

%!  range_of(+Name, -Least, -Most, -Step) is det.
%
%   The range of the parameter Name, `none` for what the model does not say.

range_of(Name, Least, Most, Step) :-
    (   param_about(Name, Items)
    ->  true
    ;   Items = []
    ),
    items_range(Items, Least, Most, Step).

items_range(Items0, Least, Most, Step) :-
    maplist(item_now, Items0, Items),
    item_value(min(Least), Items),
    item_value(max(Most), Items),
    item_value(step(Step), Items).

%   item_now(Item0, Item): with the parameters of the world, to nine digits, for
%   who reads it.

item_now(Item0, Item) :-
    catch(item_formed(world_parameter, Item0, Item1), error(model_error(_), _),
          Item1 = none),
    (   compound(Item1),
        Item1 \== Item0
    ->  compound_name_arguments(Item1, Name, [Value0]),
        format(atom(Digits), '~9g', [Value0]),
        atom_number(Digits, Value),
        compound_name_arguments(Item, Name, [Value])
    ;   Item = Item1
    ).

item_value(Item, Items) :-
    (   memberchk(Item, Items)
    ->  true
    ;   arg(1, Item, none)
    ).

%!  about_text(+Name, ?Language, -Text) is nondet.
%
%   What the parameter Name is, in the words of Language.

about_text(Name, Language, Text) :-
    param_about(Name, Items),
    member(text(Language, Text), Items).

%!  ranges_told is det.
%
%   A warning for each parameter of the world whose value is out of its range.

ranges_told :-
    findall(Name-Items, param_about(Name, Items), Abouts),
    ranges_told(Abouts).

%!  ranges_told(+Abouts) is det.
%
%   The same of the parameters in Abouts, a list of Name-Items.

ranges_told(Abouts) :-
    forall(member(Name-Items, Abouts), range_told(Name, Items)).

range_told(Name, Items) :-
    (   param(Name, Value),
        items_range(Items, Least, Most, _),
        (   number(Least),
            Value < Least
        ;   number(Most),
            Value > Most
        )
    ->  print_message(warning,
                      sanggwan(parameter(range(Name, Value, Least, Most))))
    ;   true
    ).

%!  settings_used(+Settings) is det.
%
%   A warning for each of Settings, Name-Value, whose parameter nothing in the
%   world is made from.

settings_used(Settings) :-
    forall(( member(Name-_, Settings),
             param(Name, _),
             \+ is_used(Name) ),
           print_message(warning, sanggwan(parameter(unused(Name))))).

%   is_used(Name): a row is made from it, or from a parameter that needs it.

is_used(Name) :-
    formula(Row, Written),
    Row \= set(_),
    formula_parameter(Written, Name),
    (   Row = param(Other)
    ->  is_used(Other)
    ;   true
    ),
    !.
