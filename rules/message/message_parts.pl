:- encoding(utf8).
:- module(sg_message_parts,
          [ located//1,                 % +Context
            endless_goal/2,             % +Context, -Goal
            counted//3,                 % +N, +One, +Many
            dots_that_fit/5,            % +W, +H, -Wide, -High, -By
            size_that_fits/3,           % +Width, +Height, -Size
            near_predicates/3,          % +What, -PI, -Near
            number_fault/3,             % ?What, -English, -Korean
            meant_en//1,                % +Near
            meant_ko//1,                % +Near
            shown_count/2,              % +Count, -Shown
            shown_names/2,              % +Names, -Text
            shown_value/2,              % +Value, -Shown
            shown_number/3,             % +Decimals, +Number, -Text
            syntax_words//1,            % +What
            loading_fault//2,           % :Words, +Formal
            loading_warnings/2,         % +Term, -Whats
            manual_page//1              % +PI
          ]).
:- use_module(library(apply), [convlist/3, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(uri), [uri_encoded/3]).
:- use_module('../sheet/sheet_paper', [paper_size/3]).
:- use_module('../topics', [offered/2]).
:- use_module('../spelling', [near_words/3]).
:- meta_predicate loading_fault(4, +, ?, ?).
/** <module> Parts of messages that are the same in every language, or have none
of their own.
*/

%!  located(?Context)// is det.
%
%   The place of an error in a file, as compilers write it, so that editors
%   jump; nothing if its Context is no location(File, Line, Column). A Line or
%   Column of 0 is not known.

located(Context) -->
    { nonvar(Context),
      Context = location(File, Line, Column)
    },
    !,
    place(File, Line, Column).
located(_) -->
    [].

place(File, Line, _) -->
    { Line =:= 0 },
    !,
    [ '~w: '-[File] ].
place(File, Line, Column) -->
    { Column =:= 0 },
    !,
    [ '~w:~d: '-[File, Line] ].
place(File, Line, Column) -->
    [ '~w:~d:~d: '-[File, Line, Column] ].

%!  endless_goal(+Context, -Goal) is semidet.
%
%   True when Context is that of stacks that overflowed because Goal calls
%   itself without end.

endless_goal(Context, Goal) :-
    is_dict(Context, stack_overflow),
    get_dict(cycle, Context, [frame(_, Goal0, _)|_]),
    strip_module(Goal0, _, Goal).

%!  counted(+N, +One, +Many)// is det.
%
%   1 edge, 2 edges.

counted(N, One, Many) -->
    { N =:= 1 -> Word = One ; Word = Many },
    [ '~D ~w'-[N, Word] ].

%!  meant_en(+Near)// is det.
%!  meant_ko(+Near)// is det.
%
%   Which words may be meant by another one, near_words/3; nothing if none.

meant_en([]) -->
    !,
    [].
meant_en(Near) -->
    { maplist(near_text, Near, Atoms),
      atomic_list_concat(Atoms, ' or ', Words)
    },
    [ nl, '  Did you mean ~w?'-[Words] ].

meant_ko([]) -->
    !,
    [].
meant_ko(Near) -->
    { maplist(near_text, Near, Atoms),
      atomic_list_concat(Atoms, ', ', Words)
    },
    [ nl, '  비슷한 것: ~w'-[Words] ].

near_text(Near, Text) :-
    format(atom(Text), '~w', [Near]).

%!  near_predicates(+What, -PI, -Near:list) is det.
%
%   PI is the predicate that What, a goal or an indicator, calls, without the
%   module in which the program asked it. Near are what users may call,
%   Name/Arity, with a name near to that of PI, near_words/3.

near_predicates(What, PI, Near) :-
    strip_module(What, Module, Plain),
    (   Plain = Word/Arity
    ->  true
    ;   functor(Plain, Word, Arity)
    ),
    (   sub_atom(Module, 0, _, _, sg_)
    ->  PI = Word/Arity
    ;   PI = Module:Word/Arity
    ),
    near_names(Word, Near).

near_names(Word, Near) :-
    Word \== [],
    findall(Name, offered(Name/_, _), Names0),
    sort(Names0, Names),
    near_words(Word, Names, Words),
    findall(Name/Arity,
            ( member(Name, Words), offered(Name/Arity, _) ),
            Near0),
    sort(Near0, Near),
    !.
near_names(_, []).

%!  number_fault(?What, -English, -Korean) is semidet.
%
%   What, an evaluation error of Prolog, in words.

number_fault(zero_divisor,    'division by zero',     '0으로 나눌 수 없습니다').
number_fault(undefined,       'no value is defined',  '값이 정해져 있지 않습니다').
number_fault(float_overflow,  'the number is too large', '수가 너무 큽니다').
number_fault(float_underflow, 'the number is too small', '수가 너무 작습니다').

%!  dots_that_fit(+W, +H, -Wide, -High, -By) is semidet.
%
%   Wide and High are the largest numbers of dots in the proportions of W and H
%   that a picture can have; By is how many times W and H are more, rounded up.

dots_that_fit(W, H, Wide, High, By) :-
    number(W),
    number(H),
    W >= 1,
    H >= 1,
    By0 is max(max(W, H)/16384, sqrt(W*H/67108864)),
    By0 > 1,
    By is ceiling(By0*10)/10.0,
    Wide is max(1, floor(W/By)),
    High is max(1, floor(H/By)).

%!  size_that_fits(+Width, +Height, -Size) is det.
%
%   Size, as --size has it, is the smallest of the usual papers that holds a
%   picture of Width x Height millimetres, or that size itself.

size_that_fits(Width, Height, Size) :-
    (   paper_size(_, Long, Short),
        (   Width >= Height
        ->  W-H = Long-Short
        ;   W-H = Short-Long
        ),
        Width =< W,
        Height =< H
    ->  true
    ;   W is ceiling(Width),
        H is ceiling(Height)
    ),
    format(atom(Size), '~wx~w', [W, H]).

%!  shown_number(+Decimals, +Number, -Text) is det.
%
%   Text is Number with so many Decimals; from a million on, with six digits.

shown_number(Decimals, Number, Text) :-
    (   abs(Number) < 1.0e6
    ->  format(atom(Text), "~*f", [Decimals,Number])
    ;   format(atom(Text), "~6g", [Number])
    ).

%!  shown_value(+Value, -Shown) is det.
%
%   Shown is what a message prints of Value: a variable, which has no name that
%   anybody gave it, as _; what is nested deep as dots.

shown_value(Value, Shown) :-
    (   var(Value)
    ->  Shown = '_'
    ;   copy_term(Value, Copy, _),
        term_variables(Copy, Variables),
        maplist(=('$VAR'('_')), Variables),
        format(atom(Shown), "~W",
               [Copy,[quoted(true),numbervars(true),max_depth(12)]])
    ).

%!  shown_count(+Count, -Shown) is det.
%
%   A whole number or a float as text; of one that nobody reads, its size.

shown_count(Count, Shown) :-
    (   integer(Count),
        Count < 10**15
    ->  format(string(Shown), "~D", [Count])
    ;   catch(Float is float(Count), error(_, _), fail)
    ->  format(string(Shown), "~3g", [Float])
    ;   Digits is msb(Count)*3//10,
        format(string(Shown), "10^~D", [Digits])
    ).

%!  syntax_words(+What)// is det.
%
%   What is wrong with a text that Prolog cannot read, in Prolog's words.

syntax_words(float_overflow) -->
    !,
    [ 'the number is too large' ].
syntax_words(What) -->
    { plain_syntax(What, Words) },
    !,
    [ '~w'-[Words] ].
syntax_words(What) -->
    '$messages':syntax_error(What),
    !.
syntax_words(What) -->
    [ '~w'-[What] ].

%   plain_syntax(What, Words): where Prolog has a word of its own only.

plain_syntax(illegal_character, 'Illegal character').
plain_syntax(colon_expected, 'Key:Value expected between { and }').
plain_syntax(key_expected, 'Key expected between { and }').
plain_syntax(duplicate_key(_), 'A key stands twice between { and }').
plain_syntax(comma_or_close_expected, 'Comma or } expected').

%!  loading_fault(:Words, +Formal)// is det.
%
%   What is said of an error in a rule file; Words is prolog_en or prolog_ko.

loading_fault(_, syntax_error(What)) -->
    !,
    syntax_words(What).
loading_fault(_, thrown(Ball)) -->
    '$messages':prolog_message(Ball),
    !.
loading_fault(Words, Formal) -->
    call(Words, Formal, _),
    !.
loading_fault(_, Formal) -->
    '$messages':translate_message(error(Formal, _)).

%!  loading_warnings(+Term, -Whats) is semidet.
%
%   Whats are what the message Term of Prolog warns of while a rule file is
%   loaded: once(Names) and often(Names), variables; branch(Name), one that only
%   some branches know; always_same(Compared), apart(PI),
%   failed(Directive).

loading_warnings(singletons(_, Names), [once(Shown)]) :-
    atomic_list_concat(Names, ', ', Shown).
loading_warnings(multitons(_, Names), [often(Shown)]) :-
    atomic_list_concat(Names, ', ', Shown).
loading_warnings(discontiguous(PI0, _), [apart(PI)]) :-
    strip_module(PI0, _, PI).
loading_warnings(goal_failed(directive, Goal0), [failed(Goal)]) :-
    strip_module(Goal0, _, Goal).
loading_warnings(compiler_warnings(_, Warnings), Whats) :-
    (   prolog_load_context(variable_names, Names)
    ->  true
    ;   Names = []
    ),
    convlist(compiler_warning(Names), Warnings, Whats).

%   Of variables that have no name, nothing is said.

compiler_warning(Names, Warning, What) :-
    compiler_warning(Warning, What0),
    term_variables(What0, Variables),
    \+ ( member(V, Variables),
         \+ ( member(_=V1, Names),
              V1 == V ) ),
    copy_term(What0-Names, What-Bindings),
    named_alike(Bindings).

compiler_warning(Warning, What) :-
    Warning =.. [Kind|Arguments],
    (   memberchk(Kind, [unbalanced_var,branch_singleton,negation_singleton])
    ->  Arguments = [V],
        What = branch(V)
    ;   Kind == multiton
    ->  Arguments = [V],
        What = often(V)
    ;   Kind == always
    ->  Arguments = [_, Name, Argument],
        Test =.. [Name, Argument],
        What = always_same(Test)
    ;   Arguments = [A, B],
        What = always_same(A-B)
    ).

named_alike([]).
named_alike([Name=Name|Bindings]) :-
    !,
    named_alike(Bindings).
named_alike([_|Bindings]) :-
    named_alike(Bindings).

%!  manual_page(+PI)// is det.
%
%   Where Prolog's manual has PI.

manual_page(Name/Arity) -->
    { format(atom(Text), '~w/~d', [Name, Arity]),
      uri_encoded(query_value, Text, Encoded)
    },
    [ '  https://www.swi-prolog.org/pldoc/man?predicate=~w'-[Encoded] ].

%!  shown_names(+Names, -Text) is det.
%
%   Text is the first ten of Names, with commas between them, and dots for the
%   rest.

shown_names(Names, Text) :-
    (   length(First, 10),
        append(First, [_|_], Names)
    ->  append(First, [...], Shown)
    ;   Shown = Names
    ),
    atomic_list_concat(Shown, ', ', Text).
