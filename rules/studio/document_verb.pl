:- module(sg_document_verb,
          [ of_the_document/6           % :Run, +Before, +After, +Head, -Reply,
                                        % -Octets
          ]).
:- use_module(document, [document_input/2, document_rules/2]).
:- use_module(job, [verb_job/5]).
:- use_module(protocol, [text_octets/2]).
:- use_module(library(apply), [exclude/3, maplist/3]).
:- use_module(library(lists), [append/2]).
/** <module> A verb of the command line, done to the document of a session. */

:- meta_predicate of_the_document(2, +, +, +, -, -).

%!  of_the_document(:Run, +Before, +After, +Head:dict, -Reply:dict, -Octets) is
%!                  det.
%
%   Do the verb of the command line whose words are Before and After the file,
%   with the document as its model, by its rules; else as verb_job/5.

of_the_document(Run, Before, After, Head, Reply, Octets) :-
    document_input(File, Text),
    document_rules(Rules, _),
    setup_call_cleanup(
        rules_file(Rules, RulesFile, Options),
        ( append([Before,Options,[File|After]], Words0),
          maplist(word_text, Words0, Words),
          text_octets(Text, Body),
          verb_job(Run, Head.put(argv, Words), Body, Reply0, Octets),
          without_file(RulesFile, Reply0, Reply)
        ),
        rules_file_gone(RulesFile)).

rules_file("", none, []) :-
    !.
rules_file(Rules, File, ['--rules',File]) :-
    tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
    call_cleanup(format(Out, "~s", [Rules]), close(Out)).

rules_file_gone(none) :-
    !.
rules_file_gone(File) :-
    catch(delete_file(File), error(_, _), true).

%   without_file(File, Reply0, Reply): Reply does not tell that File was read.

without_file(File, Reply0, Reply) :-
    (   del_dict(read, Reply0, Read0, Reply1),
        exclude(==(File), Read0, Read),
        Read0 \== Read
    ->  (   Read == []
        ->  Reply = Reply1
        ;   Reply = Reply1.put(read, Read)
        )
    ;   Reply = Reply0
    ).

word_text(Word, Text) :-
    (   atom(Word)
    ->  atom_string(Word, Text)
    ;   Text = Word
    ).
