:- encoding(utf8).
:- module(sg_spoken,
          [ spoken_lines/4,             % +Kind, +Term, +Lines, -Spoken
            silent_warning/2,           % +Term, +Lines
            loading_place/2             % -File, -Line
          ]).
:- use_module('../about', [about/1]).
:- use_module('../language', [language/1]).
:- use_module(messages, [english//1]).
:- use_module(messages_ko, []).
:- use_module(message_parts, [loading_warnings/2]).
:- use_module(library(lists), [append/3]).
:- use_module('../plain', [plain_lines/3]).
:- use_module(particle, [lines_joined/2]).
:- use_module(prolog_en, [prolog_en//2]).
:- use_module(prolog_ko, [prolog_ko//2]).
/** <module> Messages as the program says them and as a host gets them.

Errors of Prolog itself are said in our words, in the language of people, and
whatever comes from files is shown plain (plain.pl).
*/

%!  spoken_lines(+Kind, +Term, +Lines, -Spoken) is det.
%
%   Spoken are the lines of the message Term of this Kind, whose Lines are those
%   that Prolog would print.

spoken_lines(Kind, Term, Lines0, Lines) :-
    (   prologs_own(Term, Formal, Context),
        own_words(Formal, Context, Lines1)
    ->  true
    ;   Kind == warning,
        nonvar(Term),
        loading_warnings(Term, Whats)
    ->  warning_lines(Whats, Lines1)
    ;   Lines1 = Lines0
    ),
    about_lines(Kind, Lines1, Lines2),
    plain_lines(Kind, Lines2, Lines).

%!  silent_warning(+Term, +Lines) is semidet.
%
%   spoken_lines/4 says nothing of the warning Term, whose Lines are those that
%   Prolog would print.

silent_warning(Term, Lines) :-
    (   nonvar(Term),
        loading_warnings(Term, Whats)
    ->  Whats == []
    ;   Lines == []
    ).

%!  loading_place(-File, -Line) is semidet.
%
%   A file of rules is being loaded, and the clause that was read last begins
%   there. A model that was read has no such place: source_location/2 has that
%   of its last fact, whatever the message is about.

loading_place(File, Line) :-
    prolog_load_context(stream, _),
    source_location(File, Line).

%   about_lines(Kind, Lines0, Lines): after what it is about (about.pl).

%   A goal of a script may fail, but its errors have a place too.

about_lines(Kind, Lines0, Lines) :-
    (   Lines0 = [_|_],
        about(Name),
        memberchk(Kind, [warning,informational,error]),
        about_words(Name, Kind, Words)
    ->  Lines = [Words|Lines0]
    ;   Lines = Lines0
    ).

about_words(line(N), _, Format-[N]) :-
    !,
    (   language(ko)
    ->  Format = '~d행: '
    ;   Format = 'line ~d: '
    ).
about_words(Name, Kind, '~w: '-[Name]) :-
    Kind \== error.

prologs_own(Term, Formal, Context) :-
    nonvar(Term),
    Term = error(Formal, Context),
    nonvar(Formal),
    \+ phrase(english(Term), _, _).

%   warning_lines(Whats, Lines): nothing is said of nothing.

warning_lines([], []).
warning_lines([What|Whats], Lines) :-
    own_words(warning(What), _, Lines0),
    (   Whats == []
    ->  Lines = Lines0
    ;   warning_lines(Whats, Lines1),
        append(Lines0, [nl|Lines1], Lines)
    ).

own_words(Formal, Context, Lines) :-
    language(Language),
    (   Language == ko
    ->  phrase(prolog_ko(Formal, Context), Lines1),
        lines_joined(Lines1, Lines0)
    ;   phrase(prolog_en(Formal, Context), Lines0)
    ),
    called_in(Context, Lines, Lines0).

%   called_in(Context)//: which predicate raised it, if a user can call that.

called_in(Context) -->
    { nonvar(Context),
      Context = context(PI0, _),
      nonvar(PI0),
      strip_module(PI0, Module, PI),
      nonvar(PI),
      PI = Name/Arity,
      atom(Name),
      \+ sub_atom(Name, 0, _, _, '$'),
      \+ sub_atom(Module, 0, _, _, '$')
    },
    !,
    [ '~q/~w: '-[Name, Arity] ].
called_in(_) -->
    [].
