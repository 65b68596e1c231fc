:- module(sg_help,
          [ help/0,
            help/1,                     % +What
            sanggwan_help/0,
            sanggwan_help/1,            % +What
            callable_summary/3,         % -Name, -Arity, -Summary
            short_answers/0
          ]).
:- use_module('../limits', [term_of_text/3]).
:- use_module('../store', [relation/3, column_doc/3, relation_column/5]).
:- use_module(examples, [example/4]).
:- use_module('../topics', [topic_predicates/3, offered/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(solution_sequences), [distinct/2]).
/** <module> Help, and answers that read back, in Prolog's top level.

The documentation of the rules is written to plain facts when the program is
built (tools/documentation.pl), so that PlDoc stays out of it.
*/

% documented(Module, Name, Arity, Modes, Summary, Text)
:- dynamic documented/6.

:- prolog_load_context(directory, Folder),
   (   member(Place, ['/../documentation.pl', '/../../build/documentation.pl']),
       atom_concat(Folder, Place, File),
       exists_file(File)
   ->  load_files(sg_help:File, [silent(true)])
   ;   true
   ).

%!  short_answers is det.
%
%   Make the top level print answers whole, so that facts read back; only of
%   lists that would fill the screen the first members, and a comment.

short_answers :-
    set_prolog_flag(answer_write_options,
                    [quoted(true), portray(true), max_depth(0),
                     spacing(next_argument)]),
    set_prolog_flag(debugger_write_options,
                    [quoted(true), portray(true), max_depth(20),
                     spacing(next_argument), attributes(portray)]).

:- multifile user:portray/1.

user:portray(List) :-
    is_list(List),
    length(List, Length),
    Length > 200,
    List = [Id|_],
    integer(Id),
    length(First, 20),
    append(First, _, List),
    format("~w /* the first 20 of ~D */", [First, Length]).


                /*******************************
                *             HELP             *
                *******************************/

%!  help is det.
%!  sanggwan_help is det.
%
%   Say where to start, and list the topics. In the program this is help/0; in a
%   Prolog of your own, whose help stays Prolog's, sanggwan_help/0.

help :-
    format("Start here:~n~n"),
    forall(start(Goal, What), format("  ?- ~w~t~44|~w~n", [Goal, What])),
    format("~nTopics, more with help(Topic):~n~n"),
    forall(topic_predicates(Topic, Title, _), help_line(Topic, Title)),
    format("~nhelp(Name) or help(Name/Arity) says all of one predicate.~n").

sanggwan_help :-
    help.

start("load_model('facts/two_cubes.pl').", "read a model file, or a mesh").
start("segment(S, Kind, Name).", "its parts; v/5, e/5, p/3 have their rows").
start("volume(1, V).", "how large one is").
start("penetrate, chain(C, S1, S2, Kind, Ls).", "cut, and the lines of it").
start("explain(line(1)).", "why the first one is there").
start("show.", "a picture in the terminal").
start("draw('two_cubes.svg').", "a drawing in a file").

help_line(PI, Doc) :-
    format("  ~w~t~28|~w~n", [PI, Doc]).

%   help_topic(+Title, +Predicates): each with a line about it.

help_topic(Title, Predicates) :-
    format("~w~n~n", [Title]),
    forall(( member(Name/Arity, Predicates), summary(Name, Arity, Summary) ),
           help_line(Name/Arity, Summary)).

summary(Name, Arity, Summary) :-
    (   relation(Name, Arity, Doc)
    ->  Summary = Doc
    ;   called(Name, Arity, Module),
        documented(Module, Name, Arity, _, Doc, _)
    ->  Summary = Doc
    ;   Summary = ''
    ).

%!  callable_summary(-Name, -Arity, -Summary) is nondet.
%
%   Name/Arity is a predicate that users may call, and Summary a line about it.

callable_summary(Name, Arity, Summary) :-
    called(Name, Arity, _),
    \+ relation(Name, Arity, _),
    summary(Name, Arity, Summary).

%   called(?Name, ?Arity, -Module) is nondet: Module has it, users call it.

called(Name, Arity, Module) :-
    offered(Name/Arity, Facade),
    functor(Head, Name, Arity),
    predicate_property(Facade:Head, imported_from(Module)).

%!  help(+What) is det.
%!  sanggwan_help(+What) is det.
%
%   Show the documentation of What: a topic, or a relation or a predicate as
%   Name/Arity, Name//Arity, a goal or a name alone; text counts as what it
%   says. Of what is Prolog's own, say where its manual has it; on a terminal
%   show the manual, if it is installed. Of a name that nobody knows, say so,
%   with names that are like it. No pager is ever started away from a terminal.
%
%   @error instantiation_error

sanggwan_help(What) :-
    help(What).

help(What) :-
    help_term(What, Term),
    findall(Text, help_text(Term, Text), Texts),
    (   atom(Term),
        topic_predicates(Term, Title, Predicates)
    ->  help_topic(Title, Predicates)
    ;   Texts \== []
    ->  forall(member(Text, Texts), format("~w~n", [Text]))
    ;   findall(PI-Where, prolog_own(Term, PI, Where), Found),
        sort(Found, [Own|More])
    ->  help_of_prolog(Term, [Own|More])
    ;   findall(Name, like(Term, Name), Names0),
        sort(Names0, Names),
        print_message(help, sanggwan(no_help(Term, Names)))
    ).

%   help_term(What, Term): "v/5" and 'v/5' are v/5.

help_term(What, _) :-
    var(What),
    !,
    throw(error(instantiation_error, context(help/1, _))).
help_term(What, Term) :-
    ( string(What) ; atom(What) ),
    !,
    (   catch(term_of_text(What, Term0, []), error(syntax_error(_), _), fail),
        nonvar(Term0),
        named(Term0, _, _)
    ->  Term = Term0
    ;   atom_string(Term, What)
    ).
help_term(What, What).

help_text(What, Text) :-
    named(What, Name, Arity),
    relation(Name, Arity, Doc),
    relation_text(Name, Arity, Doc, Text).
help_text(What, Text) :-
    named(What, Name, Arity),
    distinct(Name/Arity-Module,
             ( called(Name, Arity, Module)
             ; \+ called(Name, Arity, _),
               documented(Module, Name, Arity, _, _, _)
             )),
    documented(Module, Name, Arity, Modes, _, Body),
    \+ relation(Name, Arity, _),
    example_text(Name/Arity, Example),
    format(string(Text), "~w~n~w~w", [Modes, Body, Example]).

%   example_text(+PI, -Text): its example, or nothing.

example_text(PI, Text) :-
    (   example(PI, Model, Goal, Answer)
    ->  (   Model == none
        ->  Load = ""
        ;   format(string(Load), "    ?- load_model(~q).~n", [Model])
        ),
        format(string(Text), "~n~n~w    ?- ~w~n    ~w.", [Load, Goal, Answer])
    ;   Text = ""
    ).

named(What, Name, Arity) :-
    nonvar(What),
    named_(What, Name, Arity),
    atom(Name),
    ( var(Arity) -> true ; integer(Arity) ).

named_(Name/Arity, Name, Arity) :-
    !.
named_(Name//Arity0, Name, Arity) :-
    !,
    (   integer(Arity0)
    ->  Arity is Arity0 + 2
    ;   true
    ).
named_(Head, Name, Arity) :-
    compound(Head),
    !,
    functor(Head, Name, Arity).
named_(Name, Name, _).

%   prolog_own(What, PI, Where) is nondet: PI is built in or of a library.

prolog_own(What, Name/Arity, system) :-
    named(What, Name, Arity),
    current_predicate(system:Name/Arity),
    functor(Head, Name, Arity),
    \+ predicate_property(system:Head, imported_from(_)).
prolog_own(What, Name/Arity, library(Library)) :-
    named(What, Name, Arity),
    '$in_library'(Name, Arity, Path),
    file_base_name(Path, Library).

help_of_prolog(What, Found) :-
    (   on_terminal,
        manual_loaded(Manual),
        member(PI-_, Found),
        in_manual(Manual, PI)
    ->  prolog_help:help(What)
    ;   forall(member(PI-Where, Found),
               print_message(help, sanggwan(prolog_help(PI, Where))))
    ).

on_terminal :-
    stream_property(user_input, tty(true)),
    stream_property(user_output, tty(true)).

%   manual_loaded(Manual): Manual is the module that knows Prolog's manual,
%   which is large and here only from now on. An interrupt waits: SWI-Prolog
%   9.0.4 may lose a library that is half loaded.

manual_loaded(prolog_manual_index) :-
    sig_atomic(load_files([library(help), library(pldoc/man_index)],
                          [if(not_loaded), imports([]), silent(true)])).

in_manual(Manual, PI) :-
    catch(Manual:man_object_property(PI, id(_)), error(_, _), fail).

%   like(What, Name) is nondet: Name is documented and much like What.

like(What, Name) :-
    ( named(What, Word, _) -> true ),
    (   documented(_, Name, _, _, _, _)
    ;   relation(Name, _, _)
    ),
    (   dwim_match(Word, Name)
    ;   atom_length(Word, Length),
        Length > 2,
        sub_atom(Name, _, _, _, Word)
    ).

relation_text(Name, Arity, Doc, Text) :-
    findall(Column, relation_column(Name, _, Column, _, _), Columns),
    findall(Line,
            ( relation_column(Name, Position, Column, Type, _),
              column_doc(Name, Position, ColumnDoc),
              format(string(Line), "    ~w~t~16|~w~t~24|~w",
                     [Column, Type, ColumnDoc])
            ),
            Lines),
    length(Columns, Arity),
    atomic_list_concat(Columns, ', ', Arguments),
    atomic_list_concat(Lines, '\n', Body),
    findall(Hint, quicker(Name/Arity, Hint), Hints),
    atomic_list_concat(Hints, Quicker),
    format(string(Text), "~w(~w): ~w~n~n~w~w",
           [Name, Arguments, Doc, Body, Quicker]).

%   quicker(PI, Hint): what answers at once the question that people ask PI for
%   by walking through all of its rows.

quicker(p/3, "\n\nWhich polygon has edge E: edge_polygon(S, E, P), at once.\n\c
Walking through p/3 with memberchk/2 looks at every list.").
quicker(e/5, "\n\nWhich edge runs from V1 to V2: e(S, E, V1, V2, _), with \c
both bound, at once.\nWhich polygon has it: edge_polygon(S, E, P).").
