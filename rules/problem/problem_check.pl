:- module(sg_problem_check,
          [ problem_fields/2,           % +Variant, -Fields
            problem_checked/5           % +Variant, +Given, +Show, -Checked,
                                        % -Answers
          ]).
:- use_module(problem_item, [measure_unit/4]).
:- use_module(problem_text, [task_sentence/4]).
:- use_module(problem_variant, [variant_answered/3]).
:- use_module('../near', [is_rounding/2]).
:- use_module(problem_explanation, [answer_why/5]).
:- use_module(library(apply), [maplist/4]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> What a pupil answered: is it right, and why.

Numbers are checked: how many loops there are, and measures, as near to the
truth as their tolerance says. What is to be drawn is compared by the pupil,
with the answer on its sheet.
*/

%!  problem_fields(+Variant, -Fields:list) is det.
%
%   Fields are the tasks of Variant (problem_variant.pl) that have a number as
%   their answer, in their order: dicts with `words`, in both languages, `unit`,
%   a string or null, and `tolerance`, a number or null.

problem_fields(variant(_,_,Items,asked(_,_,Tasks,_),_,_), Fields) :-
    findall(_{words:_{en:En, ko:Ko}, unit:Unit, tolerance:Tolerance},
            ( member(task(Ask,Letters,Rank), Tasks),
              is_number(Ask, Unit, Tolerance),
              Task = task(Ask,Letters,Rank,none),
              task_sentence(Task, Items, en, En),
              task_sentence(Task, Items, ko, Ko) ),
            Fields).

is_number(ask(count(loops)), null, null).
is_number(ask(measure(_,Unit,Tolerance)), Word, Tolerance) :-
    measure_unit(Unit, _, _, Word).

%!  problem_checked(+Variant, +Given:list, +Show, -Checked:list, -Answers) is
%!                  semidet.
%
%   Checked are dicts, one for each of the fields of Variant: `given`, of Given,
%   strings; `right`, true or false; `said`, which is "right", "more", "less",
%   "no_number", or "none" if nothing was given; and `value` and `why`, texts,
%   if it is right or Show is true, or else null. Answers are those of
%   variant_answered/3. Fails if Given are not as many as the fields.

problem_checked(Variant, Given, Show, Checked, Answers) :-
    variant_answered(Variant, Measures, Answers),
    findall(asked(Ask,True,Near,Answer),
            ( member(task(Ask,_,_,Answer), Answers),
              true_number(Ask, Measures, Answer, True, Near) ),
            Asked),
    maplist(checked(Variant, Show), Asked, Given, Checked).

true_number(ask(count(loops)), _, Count, Count, 0).
true_number(ask(measure(Measure,Unit,Tolerance)), Measures, _, True,
            Tolerance) :-
    memberchk(Measure-Value, Measures),
    measure_unit(Unit, _, Size, _),
    True is Value/Size.

checked(Variant, Show, asked(Ask,True,Near,Answer), Given,
        _{given:Given, right:Right, said:Said, value:Value, why:Why}) :-
    verdict(Given, True, Near, Said),
    ( Said == "right" -> Right = true ; Right = false ),
    (   ( Right == true ; Show == true )
    ->  format(string(Value), "~w", [Answer]),
        answer_why(Variant, Ask, Answer, en, En),
        answer_why(Variant, Ask, Answer, ko, Ko),
        Why = _{en:En, ko:Ko}
    ;   Value = null,
        Why = null
    ).

%   verdict(Given, True, Near, Said): the last digit of what is given may be
%   rounded, so the limit itself is right.

verdict(Given, True, Near, Said) :-
    (   split_string(Given, "", " \t\u00a0", [""])
    ->  Said = "none"
    ;   number_given(Given, Number)
    ->  Off is abs(Number-True),
        (   ( Off =< Near ; is_rounding(Off-Near, 1+abs(True)) )
        ->  Said = "right"
        ;   Number > True
        ->  Said = "more"
        ;   Said = "less"
        )
    ;   Said = "no_number"
    ).

%   number_given(Given, Number): digits, with a point or a comma, and perhaps a
%   word behind.

number_given(Given, Number) :-
    string_length(Given, Length),
    Length =< 40,
    split_string(Given, "", " \t\u00a0", [Text]),
    string_codes(Text, Codes),
    phrase(decimal(Digits), Codes, Rest),
    unit_behind(Rest),
    number_codes(Number, Digits).

unit_behind(Codes) :-
    string_codes(Text, Codes),
    split_string(Text, "", " ", [Word]),
    string_codes(Word, Unit),
    (   Unit = [Code|_]
    ->  ( code_type(Code, alpha) ; Code =:= 0xB0 )
    ;   true
    ),
    !.

decimal([0'-|Ds]) -->
    ( "-" ; "\u2212" ),
    !,
    unsigned(Ds).
decimal(Ds) -->
    ( "+" -> [] ; [] ),
    unsigned(Ds).

unsigned(Ds) -->
    digits(Whole),
    { Whole = [_|_] },
    (   ( "." ; "," ),
        digits(Part),
        { Part = [_|_] }
    ->  { append(Whole, [0'.|Part], Ds) }
    ;   { Ds = Whole }
    ).

digits([D|Ds]) -->
    [D],
    { D >= 0'0, D =< 0'9 },
    !,
    digits(Ds).
digits([]) -->
    [].
