:- module(sg_help,
          [ help/0,
            help/1,                     % +What
            short_answers/0
          ]).
:- use_module(store, [relation/3, column_doc/3, relation_column/5]).
:- autoload(library(lists), [append/3, member/2]).
/** <module> Help, and answers that read back, in Prolog's top level.

The documentation of the rules is written to plain facts when the program is
built (tools/documentation.pl), so that PlDoc stays out of it.
*/

% documented(Module, Name, Arity, Modes, Summary, Text)
:- dynamic documented/6.

:- prolog_load_context(directory, Rules),
   (   member(Place, ['/documentation.pl', '/../build/documentation.pl']),
       atom_concat(Rules, Place, File),
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
%
%   List the relations and predicates, with a line about each.

help :-
    format("help(Name) or help(Name/Arity) tells more. The relations:~n"),
    forall(relation(Name, Arity, Doc),
           help_line(Name/Arity, Doc)),
    forall(setof(PI-Summary, public(Module, PI, Summary), Pairs),
           ( format("~n~w~n", [Module]),
             forall(member(PI-Summary, Pairs), help_line(PI, Summary))
           )).

help_line(PI, Doc) :-
    format("  ~w~t~28|~w~n", [PI, Doc]).

%   public(?Module, -PI, -Summary) is nondet: documented, and visible to users.

public(Module, Name/Arity, Summary) :-
    documented(Module, Name, Arity, _, Summary, _),
    functor(Head, Name, Arity),
    predicate_property(user:Head, imported_from(Module)),
    Module \== sg_store.
public(sg_store, Name/Arity, Summary) :-
    documented(sg_store, Name, Arity, _, Summary, _),
    \+ relation(Name, Arity, _).

%!  help(+What) is semidet.
%
%   Show the documentation of What: a relation, a predicate, Name/Arity or a
%   name
%   alone. What Sanggwan does not document is looked up in Prolog's own manual.

help(What) :-
    findall(Text, help_text(What, Text), Texts),
    (   Texts \== []
    ->  forall(member(Text, Texts), format("~w~n", [Text]))
    ;   prolog_help:help(What)
    ).

help_text(What, Text) :-
    named(What, Name, Arity),
    relation(Name, Arity, Doc),
    relation_text(Name, Arity, Doc, Text).
help_text(What, Text) :-
    named(What, Name, Arity),
    documented(_, Name, Arity, Modes, _, Body),
    \+ relation(Name, Arity, _),
    format(string(Text), "~w~n~w", [Modes, Body]).

named(Name/Arity, Name, Arity) :-
    !.
named(Name, Name, _).

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
    format(string(Text), "~w(~w): ~w~n~n~w", [Name, Arguments, Doc, Body]).
