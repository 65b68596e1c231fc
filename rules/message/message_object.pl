:- module(sg_message_object,
          [ message_object/3,           % +Kind, +Term, -Object
            error_object/3,             % +Status, +Objects, -Error
            objects_heard/2,            % :Goal, -Objects
            files_untold/1,             % :Goal
            message_said/2              % +Kind, +Term
          ]).
:- use_module(spoken, [loading_place/2, spoken_lines/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists), [last/2, member/2]).
:- use_module(library(solution_sequences), [offset/2]).
/** <module> Messages as objects, for programs: what JSON holds of them.

A program tells messages apart by their code, and shows people their words in
the language that these want, whatever the language of the process is.
*/

:- meta_predicate objects_heard(0, -), files_untold(0).

%!  message_object(+Kind, +Term, -Object) is det.
%
%   Object is a dict of the message Term of this Kind (`error`, `warning` or
%   `informational`), with the keys
%
%     - kind: "error", "warning" or "notice"
%     - code: what it is, as names of its term with dots between them, such as
%       "model_error.cannot_read"; it does not change with the language
%     - words: _{en:Text, ko:Text}, what is wrong and what to do, on lines
%     - file, line, column: where, or null; lines and columns count from 1
%
%   What is no message of ours has the words that the program prints of it.

message_object(Kind, Term, Object) :-
    placed(Term, Bare, File, Line, Column),
    kind_word(Kind, KindWord),
    code_of(Term, Code),
    words(en, Kind, Bare, En),
    words(ko, Kind, Bare, Ko),
    Object = _{ kind:KindWord, code:Code, words:_{en:En, ko:Ko},
                file:File, line:Line, column:Column }.

kind_word(Kind, Word) :-
    (   Kind == informational
    ->  Word = "notice"
    ;   atom_string(Kind, Word)
    ).

%   placed(Term, Bare, File, Line, Column): Bare has no place.

placed(Term, error(Fault, _), File, Line, Column) :-
    nonvar(Term),
    Term = error(Fault, Context),
    nonvar(Context),
    Context = location(File0, Line0, Column0),
    !,
    format(string(File), "~w", [File0]),
    known_number(Line0, Line),
    known_number(Column0, Column).
placed(Term, Term, File, Line, null) :-
    loading_place(File0, Line),
    !,
    atom_string(File0, File).
placed(Term, Term, null, null, null).

known_number(0, null) :-
    !.
known_number(N, N).

%   code_of(Term, Code)

code_of(Term, Code) :-
    (   nonvar(Term),
        named_in(Term, Names)
    ->  true
    ;   Names = [message]
    ),
    atomic_list_concat(Names, '.', Code0),
    atom_string(Code0, Code).

named_in(error(Formal, _), Names) :-
    !,
    (   callable(Formal)
    ->  Formal =.. [Name|Arguments],
        Names = [Name|Rest],
        (   memberchk(Name, [ model_error,geometry_error,usage_error,
                               frame_error,request_error ]),
            Arguments = [What],
            callable(What)
        ->  functor(What, Inner, _),
            Rest = [Inner]
        ;   Rest = []
        )
    ;   Names = [error]
    ).
named_in(sanggwan(What), [Name]) :-
    !,
    callable(What),
    functor(What, Name, _).
named_in(sanggwan_interrupt(_), [interrupted]) :-
    !.
named_in(Term, [Name]) :-
    callable(Term),
    functor(Term, Name, _).

%   words(Language, Kind, Term, Text): as people read it in that Language.

words(Language, Kind, Term, Text) :-
    current_prolog_flag(message_language, Old),
    setup_call_cleanup(
        set_prolog_flag(message_language, Language),
        worded(Kind, Term, Text),
        set_prolog_flag(message_language, Old)).

worded(Kind, Term, Text) :-
    (   catch(translated(Kind, Term, Lines), error(_, _), fail)
    ->  with_output_to(string(Text0),
                       ( current_output(Out),
                         print_message_lines(Out, '', Lines) )),
        split_string(Text0, "", " \n", [Text])
    ;   format(string(Text), "~W",
               [Term, [quoted(true), max_depth(12)]])
    ).

translated(Kind, Term, Lines) :-
    '$messages':translate_message(Term, Lines0, []),
    spoken_lines(Kind, Term, Lines0, Lines).

%!  objects_heard(:Goal, -Objects:list) is semidet.
%
%   Call Goal once; Objects are those of the messages that were said meanwhile
%   in this thread, in their order. They are there also if Goal binds nothing.
%   One that goes on outside of this one hears them too.

objects_heard(Goal, Objects) :-
    aggregate_all(count, heard(_), Count),
    setup_call_cleanup(
        asserta(hearing, Hearing),
        ( once(Goal),
          findall(Object, offset(Count, heard(Object)), Objects)
        ),
        ( erase(Hearing),
          (   hearing
          ->  true
          ;   retractall(heard(_))
          )
        )).

% hearing: of this thread; heard(Object): what was said since. untold: not that
% files were written.
:- thread_local hearing/0, heard/1, untold/0.

%!  error_object(+Status, +Objects, -Error) is det.
%
%   Error is null, or, if Status is not 0, that of the messages Objects which
%   ended the work: the last error.

error_object(Status, Objects, Error) :-
    (   Status =\= 0,
        findall(Object, ( member(Object, Objects), Object.kind == "error" ),
                Errors),
        last(Errors, Error0)
    ->  Error = Error0
    ;   Error = null
    ).

%!  files_untold(:Goal) is semidet.
%
%   Call Goal once. That a file was written, objects_heard/2 does not hear: who
%   knows the files already need not wait for words about them.

files_untold(Goal) :-
    setup_call_cleanup(
        asserta(untold, Untold),
        once(Goal),
        erase(Untold)).

%!  message_said(+Kind, +Term) is det.
%
%   The message Term was said to people: objects_heard/2 hears it too, if it is
%   not about progress.

message_said(Kind, Term) :-
    (   hearing,
        \+ ( untold,
             subsumes_term(sanggwan(wrote(_)), Term) ),
        \+ subsumes_term(sanggwan(progress(_, _)), Term),
        \+ subsumes_term(sanggwan(progress(_, _, _, _, _)), Term)
    ->  message_object(Kind, Term, Object),
        assertz(heard(Object))
    ;   true
    ).
