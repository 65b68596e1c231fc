:- module(sg_plain,
          [ plain_text/2,               % +Text, -Plain
            plain_term/2,               % +Term, -Plain
            cut_term/2,                 % +Term, -Cut
            plain_lines/3,              % +Kind, +Lines, -Plain
            shown_text/2,               % +Text, -Shown
            plain_json/2                % +Out, :Goal
          ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(terms), [term_size/2]).
/** <module> What comes from files, as it may be shown to people.

Names in files may hold what moves the cursor, sets a title or turns writing
round; terms may be deep or long. Wherever people read them each character that
is not seen is seen: as its picture, U+2400 and on, or as U+FFFD; and what is
deep or long is cut. Formats that have escapes escape these characters.
plain_code/2 alone decides which they are.
*/

:- meta_predicate plain_json(+, 0).

%!  plain_text(+Text, -Plain:string) is det.
%
%   Plain is Text, an atom or a string, with pictures for control characters,
%   and U+FFFD for those that change the direction or the lines of what follows.

plain_text(Text, Plain) :-
    atom_codes(Text, Codes0),
    maplist(plain_code, Codes0, Codes),
    string_codes(Plain, Codes).

plain_code(Code0, Code) :-
    (   Code0 < 0x20
    ->  Code is 0x2400+Code0
    ;   Code0 < 0x7f
    ->  Code = Code0
    ;   hidden_code(Code0)
    ->  (   Code0 =:= 0x7f
        ->  Code = 0x2421
        ;   Code = 0xfffd
        )
    ;   Code = Code0
    ).

hidden_code(Code) :-
    Code =< 0x9f,
    !.
hidden_code(Code) :-
    hidden_range(From, To),
    Code >= From,
    Code =< To,
    !.

%   What is not seen but changes how the rest is, except the two joiners, which
%   scripts need.

hidden_range(0x61c, 0x61c).
hidden_range(0x200b, 0x200b).
hidden_range(0x200e, 0x200f).
hidden_range(0x2028, 0x202e).
hidden_range(0x2060, 0x206f).
hidden_range(0xd800, 0xdfff).
hidden_range(0xfeff, 0xfeff).
hidden_range(0xfff9, 0xfffb).
hidden_range(0xe0000, 0xe007f).

%!  shown_text(+Text, -Shown) is det.
%
%   Shown is Text, or on a terminal plain_text/2 of it.

shown_text(Text, Shown) :-
    (   stream_property(current_output, tty(true))
    ->  plain_text(Text, Shown)
    ;   Shown = Text
    ).

%!  plain_json(+Out, :Goal) is det.
%
%   Call Goal once, which prints JSON to the current output: it goes to stream
%   Out with escapes (`\u202e`) for what is not seen, and for what Out has no
%   characters for. What is outside of its texts, line ends too, is seen.

plain_json(Out, Goal) :-
    with_output_to(string(Text), Goal),
    stream_property(Out, encoding(Encoding)),
    (   memberchk(Encoding, [utf8, unicode_be, unicode_le, wchar_t])
    ->  Last = 0x10ffff
    ;   Last = 0x7e
    ),
    string_codes(Text, Codes),
    (   escaped_at(Codes, Last)
    ->  foldl(json_code(Last), Codes, Escaped, []),
        format(Out, "~s", [Escaped])
    ;   write(Out, Text)
    ).

escaped_at([Code|Codes], Last) :-
    (   Code < 0x7f
    ->  escaped_at(Codes, Last)
    ;   Code =< Last,
        plain_code(Code, Code)
    ->  escaped_at(Codes, Last)
    ;   true
    ).

json_code(Last, Code, Codes, Rest) :-
    (   Code < 0x7f
    ->  Codes = [Code|Rest]
    ;   Code =< Last,
        plain_code(Code, Code)
    ->  Codes = [Code|Rest]
    ;   Code < 0x10000
    ->  format(codes(Codes, Rest), "\\u~|~`0t~16r~4+", [Code])
    ;   High is 0xd800 + ((Code-0x10000) >> 10),
        Low is 0xdc00 + ((Code-0x10000) /\ 0x3ff),
        format(codes(Codes, Rest), "\\u~16r\\u~16r", [High,Low])
    ).

%!  plain_term(+Term, -Plain) is det.
%
%   Plain is Term with texts as in plain_text/2. It is written in 2000
%   characters at most: what is deep or wide is `...` there, and of a long text
%   or number both ends are shown.

plain_term(Term, Plain) :-
    shown_of_term(Most),
    plain_term(Term, Most, Plain, 2000, _),
    write_length(Plain, _, [quoted(true),max_length(2000)]),
    !.

%   shown_of_term(Most): Most is most(Depth, Elements, Characters). The first
%   shows what people write, the last one of no term too much.

shown_of_term(most(12, 100, 500)).
shown_of_term(most(6, 20, 80)).
shown_of_term(most(3, 6, 40)).

%   plain_term(Term, Most, Plain, N0, N) is semidet: Plain has N0-N values, each
%   of a character at least. Fails if they are more than N0: a term that shares
%   its parts, or has itself as one, may have more of them than can be counted.

plain_term(Term, Most, Plain, N0, N) :-
    (   compound(Term),
        \+ Most = most(0, _, _)
    ->  plain_compound(Term, Most, Plain, N0, N)
    ;   N0 > 0,
        N is N0-1,
        plain_leaf(Term, Most, Plain)
    ).

plain_leaf(Term, most(_, _, Characters), Plain) :-
    ( atom(Term) ; string(Term) ; rational(Term) ),
    !,
    short_text(Term, Characters, Short),
    plain_kind(Term, Short, Plain).
plain_leaf(Term, _, Plain) :-
    (   compound(Term)
    ->  Plain = ...
    ;   Plain = Term
    ).

plain_compound(Term, most(Depth, Elements, Characters), Plain, N0, N) :-
    Depth1 is Depth-1,
    Most = most(Depth1, Elements, Characters),
    (   Term = [_|_]
    ->  plain_list(Term, Elements, Most, Plain, N0, N)
    ;   compound_name_arguments(Term, Name0, Arguments0),
        plain_term(Name0, Most, Name, N0, N1),
        plain_list(Arguments0, Elements, Most, Arguments, N1, N),
        compound_name_arguments(Plain, Name, Arguments)
    ).

plain_list(List0, Left, Most, List, N0, N) :-
    (   nonvar(List0),
        List0 = [Term0|Terms0]
    ->  (   Left =:= 0
        ->  List = [...],
            N = N0
        ;   List = [Term|Terms],
            plain_term(Term0, Most, Term, N0, N1),
            Left1 is Left-1,
            plain_list(Terms0, Left1, Most, Terms, N1, N)
        )
    ;   List0 == []
    ->  List = [],
        N = N0
    ;   plain_term(List0, Most, List, N0, N)
    ).

%   short_text(Value, Most, Short): Short is Value, or the text of its ends, if
%   that of Value has more than Most characters.

short_text(Value, Most, Short) :-
    (   write_length(Value, _, [max_length(Most)])
    ->  Short = Value
    ;   After is Most//4,
        Before is Most-After-3,
        format(string(Text), "~w", [Value]),
        sub_string(Text, 0, Before, _, First),
        sub_string(Text, _, After, 0, Last),
        format(string(Short), "~w...~w", [First,Last])
    ).

%   plain_kind(Value, Short, Plain): Value, if that is what is shown; else a
%   string of a string, and an atom of all others.

plain_kind(Value, Short, Plain) :-
    plain_text(Short, Text),
    (   atom_string(Value, Text)
    ->  Plain = Value
    ;   string(Value)
    ->  Plain = Text
    ;   atom_string(Plain, Text)
    ).

%!  cut_term(+Term, -Cut) is det.
%
%   Cut is Term, for who catches the error that has it. If Term is large, more
%   than 100,000 words of memory, most of the elements of its long lists are
%   left out: some more stay than plain_term/2 shows, and `...` stands for the
%   others. An error that is raised is copied several times.

cut_term(Term, Cut) :-
    (   term_size(Term, Size),
        Size > 100_000
    ->  left_of_term(Most),
        cut_lists(Term, Cut, Most, _)
    ;   Cut = Term
    ).

%   cut_lists(Term, Cut, N0, N): Cut has N0-N compounds that are no lists, and
%   elements of lists.

cut_lists(Term, Cut, N0, N) :-
    (   \+ compound(Term)
    ->  Cut = Term,
        N = N0
    ;   N0 =< 0
    ->  Cut = ...,
        N = N0
    ;   Term = [_|_]
    ->  left_of_list(Most),
        cut_list(Term, Most, Cut, N0, N)
    ;   compound_name_arguments(Term, Name, Arguments0),
        left_of_list(Most),
        N1 is N0-1,
        cut_list(Arguments0, Most, Arguments, N1, N),
        compound_name_arguments(Cut, Name, Arguments)
    ).

left_of_list(200).
left_of_term(100_000).

cut_list(List, Left, Cut, N0, N) :-
    (   nonvar(List),
        List = [Term0|Terms0]
    ->  (   Left > 0,
            N0 > 0
        ->  Cut = [Term|Terms],
            N1 is N0-1,
            cut_lists(Term0, Term, N1, N2),
            Left1 is Left-1,
            cut_list(Terms0, Left1, Terms, N2, N)
        ;   Cut = [...],
            N = N0
        )
    ;   List == []
    ->  Cut = [],
        N = N0
    ;   cut_lists(List, Cut, N0, N)
    ).

%!  plain_lines(+Kind, +Lines, -Plain) is det.
%
%   Plain are the Lines of a message, as print_message_lines/3 prints them, with
%   plain values. What a message of the kind `help` says is not cut.

plain_lines(help, Lines, Lines) :-
    !.
plain_lines(_, Lines0, Lines) :-
    maplist(plain_or_same, Lines0, Lines).

plain_or_same(Element0, Element) :-
    (   plain_element(Element0, Element1)
    ->  Element = Element1
    ;   Element = Element0
    ).

plain_element(Element, _) :-
    var(Element),
    !,
    fail.
plain_element(Format-Values0, Format-Values) :-
    plain_values(Values0, Values).
plain_element(ansi(How, Format, Values0), ansi(How, Format, Values)) :-
    plain_values(Values0, Values).

%   Each value of its own, so none is lost.

plain_values(Values0, Values) :-
    (   is_list(Values0)
    ->  maplist(plain_value, Values0, Values)
    ;   plain_value(Values0, Values)
    ).

%   Variables have no names of the machine: they are _, or A, B where a value
%   has one more than once.

plain_value(Term, Plain) :-
    plain_term(Term, Plain0),
    copy_term(Plain0, Plain, _),
    numbervars(Plain, 0, _, [singletons(true)]).
