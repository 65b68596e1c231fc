/* Several outputs of one program as one, with the median of each number:

       swipl bench/median.pl -- FILE...

   The lines are those of the first file; each number in them is the middle one
   of the numbers at the same place. A line whose words are not the same in all
   files stays as it is in the first.
*/
:- use_module(library(apply)).
:- use_module(library(dcg/basics)).
:- use_module(library(lists)).
:- use_module(library(pure_input)).
:- use_module(library(yall)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Files),
    maplist(file_lines, Files, [First|Others]),
    foldl(print_line, First, Others, _).

%   A line is a list of text(Codes) and number(Value, Codes), the codes with
%   the blanks before the number, so that columns stay.

file_lines(File, Lines) :-
    phrase_from_file(lines(Lines), File).

lines([Line|Lines]) -->
    string_without(`\n`, Codes),
    "\n",
    !,
    { phrase(tokens(Line), Codes) },
    lines(Lines).
lines([]) -->
    remainder(_).

tokens([number(Value, Codes)|Tokens]) -->
    blanks_of(Blanks),
    digits_of(Digits),
    !,
    { exclude(==(0',), Digits, Plain),
      number_codes(Value, Plain),
      append(Blanks, Digits, Codes)
    },
    tokens(Tokens).
tokens([text(Codes)|Tokens]) -->
    blanks_of(Blanks),
    nonblank(Code),
    nonblanks(Codes0),
    !,
    { append(Blanks, [Code|Codes0], Codes) },
    tokens(Tokens).
tokens([]) -->
    remainder(_).

blanks_of([0'\s|Blanks]) -->
    " ",
    !,
    blanks_of(Blanks).
blanks_of([]) --> [].

%   A number stands alone: 12, 1,042,322, 0.035; not 2 in v/5 or sph2_1k.

digits_of([Digit|Digits]) -->
    digit(Digit),
    more_digits(Digits),
    end_of_word.

more_digits([Code|Digits]) -->
    [Code],
    { memberchk(Code, `0123456789.`) ; Code == 0', },
    !,
    more_digits(Digits).
more_digits([]) --> [].

end_of_word, " " --> " ", !.
end_of_word --> eos.

%   print_line(+Line, +Others0, -Others): Others0 are the other files' lines
%   from here on.

print_line(Line, Others0, Others) :-
    maplist(next_line, Others0, Same, Others),
    (   maplist(same_words(Line), Same)
    ->  transposed([Line|Same], Places),
        maplist(print_middle, Places)
    ;   maplist(print_first, Line)
    ),
    nl.

next_line([], [], []).
next_line([Line|Lines], Line, Lines).

same_words(Line1, Line2) :-
    maplist(same_word, Line1, Line2).

same_word(text(Codes), text(Codes)).
same_word(number(_, _), number(_, _)).

transposed([[]|_], []) :-
    !.
transposed(Lines, [Place|Places]) :-
    maplist([[Token|Tokens],Token,Tokens]>>true, Lines, Place, Rest),
    transposed(Rest, Places).

print_middle([text(Codes)|_]) :-
    !,
    format("~s", [Codes]).
print_middle(Numbers) :-
    Numbers = [number(_, Codes0)|_],
    length(Codes0, Width),
    sort(1, @=<, Numbers, Sorted),
    length(Sorted, Length),
    Middle is Length//2,
    nth0(Middle, Sorted, number(_, Codes)),
    phrase((blanks_of(_), remainder(Digits)), Codes),
    line_position(current_output, From),
    To is From+Width,
    format("~t~s~*|", [Digits, To]).

print_first(text(Codes)) :-
    format("~s", [Codes]).
print_first(number(_, Codes)) :-
    format("~s", [Codes]).
