/* Writes the man page, from the tables that --help prints:

       swipl tools/manual.pl -- VERSION build/sanggwan.1

   What every verb has in common is below; verbs, options and examples are in
   rules/command/usage.pl.
*/
:- module(sg_manual, []).
:- use_module('../rules/command/usage',
              [verb/4, verb_options/2, common_option/1, example/2]).
:- use_module(library(lists), [member/2]).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Version, File]),
    setup_call_cleanup(
        open(File, write, Out, [encoding(utf8)]),
        with_output_to_stream(Out, page(Version)),
        close(Out)).

with_output_to_stream(Out, Goal) :-
    current_output(Old),
    setup_call_cleanup(set_output(Out), Goal, set_output(Old)).

page(Version) :-
    format(".\\\" Made by tools/manual.pl.~n"),
    format(".TH SANGGWAN 1 \"\" \"sanggwan ~w\" \"User Commands\"~n",
           [Version]),
    head,
    section('VERBS'),
    forall(verb(Verb, Arguments, Summary, _),
           verb_paragraphs(Verb, Arguments, Summary)),
    section('OPTIONS OF EVERY VERB'),
    forall(common_option(Option), option_paragraph(Option)),
    tail,
    section('EXAMPLES'),
    forall(( verb(Verb, _, _, _), example(Verb, Command) ),
           ( format(".PP~n.nf~n    "), text(Command), format("~n.fi~n") )),
    see_also.

head :-
    section('NAME'),
    line('sanggwan - penetration lines, hidden lines, and models as relations'),
    section('SYNOPSIS'),
    format(".B sanggwan~n.I VERB~n[\\fIOPTION\\fR...] [\\fIMODEL\\fR...]~n"),
    format(".br~n.B sanggwan~n[\\fIVERB\\fR] \\fB\\-\\-help\\fR~n"),
    format(".br~n.B sanggwan \\-\\-version~n"),
    section('DESCRIPTION'),
    line('Computes where curves, surfaces and solids penetrate each other, \c
draws them with hidden lines, and keeps the whole model as relations that can \c
be queried in Prolog. A MODEL is a file of Prolog facts (.pl) or a mesh (.stl \c
.off .obj .ply); several stand side by side. A model is data: it is read, \c
never run.'),
    paragraph('Data goes to standard output, messages to standard error. As a \c
MODEL, - is standard input; after -o it is standard output. -- ends the \c
options. The ending of -o FILE picks the format. A file is written beside its \c
place and renamed when it is complete, so that never half of one is left.').

verb_paragraphs(Verb, Arguments, Summary) :-
    format(".SS \"~w ", [Verb]),
    text(Arguments),
    format("\"~n"),
    line(Summary),
    forall(( verb_options(Verb, Options),
             member(Option, Options),
             \+ common_option(Option) ),
           option_paragraph(Option)).

option_paragraph(option(Name, Short, _, Meta, Help)) :-
    format(".TP~n"),
    (   Short == ''
    ->  true
    ;   format("\\fB\\-~w\\fR, ", [Short])
    ),
    format("\\fB\\-\\-~w\\fR", [Name]),
    (   Meta == ''
    ->  true
    ;   format("=\\fI~w\\fR", [Meta])
    ),
    nl,
    line(Help).

tail :-
    section('EXIT STATUS'),
    forall(exit_status(Status, Meaning), tagged(Status, Meaning)),
    section('FILES'),
    forall(file(File, What), tagged(File, What)),
    section('ENVIRONMENT'),
    forall(environment(Variable, What), tagged(Variable, What)).

exit_status('0', 'Done; also when the segments do not meet.').
exit_status('1', 'The answer is no: a check failed, a goal has no answer; \c
with --strict also a warning.').
exit_status('2', 'Wrong usage, an output that cannot be written, or an error \c
in a goal.').
exit_status('3', 'The input is unreadable or invalid. The message begins with \c
FILE:LINE:COLUMN and says what to do.').
exit_status('4', 'The geometry cannot be done; the message has the reason.').
exit_status('130', 'Interrupted (143: terminated); the output files are as \c
they were.').

file('share/doc/sanggwan',
     'Model files, drawings and the command line described; the paper\'s \c
figures as models in facts/.').
file('share/swi-prolog/pack/sanggwan',
     'The Prolog library: use_module(library(sanggwan)) in swipl.').
file('include/sanggwan.h, lib/pkgconfig/sanggwan.pc',
     'From C: pkg-config --cflags --libs sanggwan.').

environment('LC_ALL, LC_MESSAGES, LANG',
            'The language of the messages, English or Korean; --lang goes \c
before them.').

see_also :-
    section('SEE ALSO'),
    format(".BR swipl (1)~n").

section(Title) :-
    format(".SH \"~w\"~n", [Title]).

paragraph(Text) :-
    format(".PP~n"),
    line(Text).

tagged(Tag, Text) :-
    format(".TP~n.B "),
    line(Tag),
    line(Text).

%   line(+Text): a line of roff that says just Text.

line(Text) :-
    text(Text),
    nl.

text(Text) :-
    atom_chars(Text, Chars),
    (   Chars = [First|_],
        memberchk(First, ['.', '\''])
    ->  format("\\&")
    ;   true
    ),
    forall(member(Char, Chars),
           ( roff(Char, Roff) -> format("~w", [Roff]) ; put_char(Char) )).

roff(-, '\\-').
roff(\, '\\e').
roff('\'', '\\(aq').
