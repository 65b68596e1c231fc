/* Writes the documentation of the rules as plain facts, for help/1:

       swipl -p foreign=build tools/documentation.pl -- build/documentation.pl

   documented(Module, Name, Arity, Modes, Summary, Text). PlDoc itself stays out
   of the program: it would add 40 ms to its start.
*/
:- module(sg_documentation, []).
:- use_module(library(pldoc)).
:- doc_collect(true).
:- use_module(library(pldoc/doc_process), [doc_comment/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).

:- prolog_load_context(directory, Tools),
   atom_concat(Tools, '/../rules/sanggwan.pl', Facade),
   load_files(user:Facade, [silent(true)]).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [File|_]),
    findall(Fact, documented(Fact), Facts0),
    sort(Facts0, Facts),
    setup_call_cleanup(
        open(File, write, Out, [encoding(utf8)]),
        ( format(Out, ":- encoding(utf8).~n", []),
          format(Out, "% Made by tools/documentation.pl.~n", []),
          forall(member(Fact, Facts), format(Out, "~q.~n", [Fact]))
        ),
        close(Out)).

documented(documented(Module, Name, Arity, Modes, Summary, Text)) :-
    doc_comment(Object, _, Summary, Comment),
    documents(Object, Module:Described),
    sub_atom(Module, 0, _, _, sg_),
    name_arity(Described, Name, Arity),
    module_property(Module, exports(Exports)),
    memberchk(Name/Arity, Exports),
    comment_parts(Comment, Modes, Text).

documents(Objects, Object) :-
    is_list(Objects),
    !,
    member(Object, Objects).
documents(Object, Object).

name_arity(Name/Arity, Name, Arity).
name_arity(Name//Arity0, Name, Arity) :-
    Arity is Arity0 + 2.

%   The lines that begin with %! are the modes, what follows is the text.

comment_parts(Comment, Modes, Text) :-
    split_string(Comment, "\n", " \t", Lines),
    mode_lines(Lines, ModeLines, Rest0),
    maplist(without_percent, Rest0, Rest),
    atomic_list_concat(ModeLines, '\n', Modes),
    atomic_list_concat(Rest, '\n', Text).

mode_lines([Line|Lines], [Mode|Modes], Rest) :-
    string_concat("%!", Mode0, Line),
    !,
    split_string(Mode0, "", " \t", [Mode]),
    mode_lines(Lines, Modes, Rest).
mode_lines(Rest, [], Rest).

without_percent(Line, Text) :-
    string_concat("%", Text, Line),
    !.
without_percent(Line, Line).
