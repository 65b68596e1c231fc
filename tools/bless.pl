/* Writes the golden drawings anew (`make bless`).

       swipl -p foreign=build tools/bless.pl

   Prints those that changed: look at them before you commit them.
*/
:- module(sg_bless, []).
:- use_module(library(readutil)).

:- multifile user:file_search_path/2.

:- prolog_load_context(directory, Tools),
   file_directory_name(Tools, Root),
   working_directory(_, Root),
   asserta(user:file_search_path(sanggwan, Root)),
   asserta(user:file_search_path(rules, sanggwan(rules))).
:- use_module('../tests/golden/goldens').

:- initialization(main, main).

main :-
    findall(Name, golden(Name, _), Names),
    foldl(blessed, Names, 0, Failed),
    forall(left_over(File),
           ( delete_file(File),
             format("gone     ~w~n", [File])
           )),
    (   Failed =:= 0
    ->  true
    ;   halt(1)
    ).

blessed(Name, Failed0, Failed) :-
    golden_file(Name, File),
    old_text(File, Old),
    (   golden_drawn(Name, File)
    ->  Failed = Failed0,
        old_text(File, New),
        compare_texts(Old, New, Word),
        format("~w~t~9|~w~n", [Word, File])
    ;   Failed is Failed0+1,
        format(user_error, "failed   ~w~n", [File])
    ).

old_text(File, Text) :-
    (   exists_file(File)
    ->  read_file_to_string(File, Text, [encoding(utf8)])
    ;   Text = none
    ).

compare_texts(Old, New, Word) :-
    (   Old == New
    ->  Word = same
    ;   Old == none
    ->  Word = new
    ;   Word = changed
    ).
