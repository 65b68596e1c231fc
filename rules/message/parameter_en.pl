:- module(sg_parameter_en,
          [ parameter_en//1             % +What
          ]).
:- use_module(message_parts, [meant_en//1, shown_value/2]).
/** <module> What is wrong with parameters and formulas, in English.

parameter_ko.pl has the same heads in Korean.
*/

%!  parameter_en(+What)// is det.
%
%   The message for a fault of the parameters of a model, or of what sets them.

parameter_en(formula(What, Formula)) -->
    formula_en(What, Formula).
parameter_en(cycle(Names)) -->
    { atomic_list_concat(Names, ', ', Text) },
    [ 'parameters need each other, in a circle: ~w'-[Text], nl,
      '  Give one of them a number.' ].
parameter_en(renamed(File, Name, New)) -->
    [ 'the parameter ~w of ~w is called ~w here, as another model has one \c
       too'-[Name, File, New] ].
parameter_en(unset(Name, Near, Names)) -->
    (   { Names == [] }
    ->  [ '--set ~w: the model has no parameters'-[Name], nl,
          '  Write param(~w, Default). in its file, and param(~w) where the \c
           number stands.'-[Name, Name] ]
    ;   { atomic_list_concat(Names, ', ', All) },
        [ '--set ~w: no model has a parameter ~w'-[Name, Name] ],
        meant_en(Near),
        [ nl, '  There are ~w.'-[All] ]
    ).
parameter_en(set_twice(Name)) -->
    [ 'the parameter ~w is set twice'-[Name], nl,
      '  Give it one value.' ].
parameter_en(setting(Text, What)) -->
    { What \= limit(_, _) },
    [ '--set ~w: '-[Text] ],
    setting_en(What).
parameter_en(unused(Name)) -->
    [ '--set ~w: nothing in the model is made from the parameter ~w'-
      [Name, Name], nl,
      '  Write param(~w) where the number stands.'-[Name] ].
parameter_en(range(Name, Value, Least, Most)) -->
    [ 'the parameter ~w is ~w, out of its range: '-[Name, Value] ],
    range_en(Least, Most).
parameter_en(about(What)) -->
    about_en(What).
parameter_en(decimal_comma(Call, Name, Point)) -->
    [ '~w(~w, ...) has two numbers; is a comma meant as the decimal \c
       point?'-[Call, Name], nl,
      '  Write ~w(~w, ~w).'-[Call, Name, Point] ].

range_en(none, Most) -->
    !,
    [ '~w at most'-[Most] ].
range_en(Least, none) -->
    !,
    [ '~w at least'-[Least] ].
range_en(Least, Most) -->
    [ '~w to ~w'-[Least, Most] ].

about_en(no_parameter(Name, Near)) -->
    [ 'param_about(~w, ...): the file has no parameter ~w'-[Name, Name] ],
    meant_en(Near),
    [ nl, '  Write param(~w, Default). in the same file.'-[Name] ].
about_en(list(Items)) -->
    { shown_value(Items, Shown) },
    [ '~p is no list of what is said of a parameter'-[Shown], nl ],
    about_en(items).
about_en(item(Item)) -->
    { shown_value(Item, Shown) },
    [ '~p is nothing that can be said of a parameter'-[Shown], nl ],
    about_en(items).
about_en(item_twice(Item)) -->
    [ '~p: that is said before'-[Item], nl,
      '  Say it once.' ].
about_en(order(Least, Most)) -->
    [ 'from ~w to ~w there is nothing between'-[Least, Most], nl,
      '  The least value is min(...), the largest max(...).' ].

about_en(items) -->
    [ '  Such as [min(20), max(200), step(0.5), text(en, \'diameter\')]; the \c
       step is above 0, languages are en and ko.' ].

formula_en(unknown(Name, Near), _) -->
    [ 'there is no parameter ~w'-[Name] ],
    meant_en(Near),
    [ nl, '  Write param(~w, Default). in the same file.'-[Name] ].
formula_en(no_number(Item), Formula) -->
    { shown_value(Item, Shown) },
    [ '~p is no number, in ~p'-[Shown, Formula], nl ],
    (   { atom(Item), Item \== [] }
    ->  [ '  A parameter is written param(~w).'-[Item] ]
    ;   [ '  Write numbers, param(Name), pi and the functions of formulas.' ]
    ).
formula_en(no_function(Name, Arity, Near), Formula) -->
    [ 'formulas have no function ~w/~d, as in ~p'-[Name, Arity, Formula] ],
    meant_en(Near),
    [ nl,
      '  They have + - * / ** sqrt abs min max floor ceiling round sin cos \c
       tan asin acos atan atan2 (degrees).' ].
formula_en(division_by_zero, Formula) -->
    [ '~p divides by zero'-[Formula], nl,
      '  Check the values of the parameters.' ].
formula_en(not_real, Formula) -->
    [ '~p is no real number'-[Formula], nl,
      '  A root is of what is not below 0; asin and acos are of -1 to 1.' ].
formula_en(too_large, Formula) -->
    [ '~p is too large'-[Formula], nl,
      '  Check the values of the parameters.' ].
formula_en(power, Formula) -->
    [ '~p: the exponent should be whole, from -1000 to 1000, or 0.5'-
      [Formula], nl,
      '  A square root is sqrt(X).' ].

setting_en(form) -->
    [ 'it should look like NAME=VALUE', nl,
      '  Such as --set d=114.3.' ].
setting_en(comma(Point)) -->
    [ 'the decimal point is a point', nl,
      '  Write ~w.'-[Point] ].
setting_en(unit(Unit)) -->
    [ 'a parameter is a number without a unit (~w)'-[Unit], nl,
      '  Lengths are in units of the model, angles in degrees.' ].
setting_en(formula(unknown(Name, _), _)) -->
    !,
    [ 'param(~w) is no number; a parameter is set to a number'-[Name], nl,
      '  Write numbers, such as 114.3 or 6.625*25.4.' ].
setting_en(formula(What, Formula)) -->
    formula_en(What, Formula).
setting_en(number) -->
    [ 'the value is no number', nl,
      '  Write digits, such as 114.3, -2.5e-3 or 6.625*25.4.' ].
