:- encoding(utf8).
:- module(test_messages, []).
% covers: command_en, command_ko, csg_en, csg_ko, mesh_en, mesh_ko
% covers: model_en, model_ko, openscad_en, openscad_ko, operand_en
% covers: operand_ko, pattern_en, pattern_ko, primitive_en, primitive_ko
% covers: prolog_en, prolog_ko, sheet_ko, style_en, style_ko, true_en
% covers: true_ko, written_en, written_ko, session_en, session_ko, language
% covers: batch_en, batch_ko, parameter_en, parameter_ko
:- use_module(library(plunit)).
:- use_module(rules(message/messages)).
:- use_module(rules(message/messages_ko)).
:- use_module(tests(rules/message_text), [message_text/3]).

% A table of messages in English and the one in Korean: NAME_en, NAME_ko.
table(English/Arity, Korean/Arity) :-
    current_predicate(sg_messages:English/Arity),
    atom_concat(Name, '_en', English),
    atom_concat(Name, '_ko', Korean).
table(english/3, korean/3).

% The heads of the clauses of a table, without text or list of text; variables
% numbered.
heads(Module, Name/Arity, Heads) :-
    findall(Terms,
            ( functor(Head, Name, Arity),
              catch(clause(Module:Head, _), error(_, _), fail),
              Head =.. [_|Arguments],
              telling(Arguments, Terms),
              numbervars(Terms, 0, _) ),
            Heads0),
    sort(Heads0, Heads).

telling([What, _], [What]) :-
    !.
telling(Arguments, Terms) :-
    append(Terms, [_, _], Arguments).

% A topic has its messages in two files, NAME_en.pl and NAME_ko.pl.
topic(Name) :-
    current_module(English),
    atom_concat(Name, '_en', English),
    atom_concat(sg_, _, Name).

topic_heads(Topic, Suffix, Heads) :-
    atom_concat(Topic, Suffix, Module),
    findall(Table-Of,
            ( current_predicate(Module:Name/Arity),
              atom_concat(Table, Suffix, Name),
              functor(Head, Name, Arity),
              \+ predicate_property(Module:Head, imported_from(_)),
              heads(Module, Name/Arity, Of) ),
            Heads0),
    sort(Heads0, Heads).

:- begin_tests(messages).

test(both_languages, forall(table(English, Korean))) :-
    heads(sg_messages, English, Heads),
    heads(sg_messages_ko, Korean, HeadsKo),
    subtract(Heads, HeadsKo, OnlyEnglish),
    subtract(HeadsKo, Heads, OnlyKorean),
    OnlyEnglish-OnlyKorean == []-[].
test(both_languages_of_a_topic, [forall(topic(Topic)), true(Ko == En)]) :-
    topic_heads(Topic, '_en', En),
    topic_heads(Topic, '_ko', Ko).
test(all_topics, true(N >= 12)) :-
    aggregate_all(count, topic(_), N).
test(no_other_korean,
     forall(( current_predicate(sg_messages_ko:Korean/Arity),
              atom_concat(_, '_ko', Korean) ))) :-
    table(_, Korean/Arity),
    !.
test(something_there, forall(table(English, _))) :-
    heads(sg_messages, English, [_|_]).
test(all_tables, true(N >= 10)) :-
    aggregate_all(count, table(_, _), N).

test(place, Text == "a.pl:2:7: segment 1 has no vertex 9\n\c
                     \x20 Add it, or correct the number.") :-
    message_text(en,
                 error(model_error(missing(v, 1, 9)), location('a.pl', 2, 7)),
                 Text).
test(no_place) :-
    message_text(en, error(model_error(empty), location('a.pl', 0, 0)), Text),
    sub_string(Text, 0, _, _, "a.pl: the model is empty").
test(korean) :-
    message_text(ko, error(model_error(empty), location('a.pl', 0, 0)), Text),
    sub_string(Text, 0, _, _, "a.pl: 모델이 비어").
test(korean_of_korea) :-
    message_text(ko_KR, sanggwan(interrupted), "중단되었습니다").
test(unknown_language) :-
    message_text(fr, sanggwan(interrupted), "interrupted").
test(plurals, forall(member(N-Part, [1-"has 1 edge,", 2-"has 2 edges,"]))) :-
    message_text(en, error(model_error(polygon(1, 1, edges(N))), _), Text),
    once(sub_string(Text, _, _, _, Part)).
test(unknown_procedure) :-
    message_text(ko, error(existence_error(procedure, foo/1), foo/1), Text),
    sub_string(Text, 0, _, _, "foo/1: 없는 술어입니다").
test(stack, forall(member(Language, [en, ko]))) :-
    message_text(Language,
                 error(resource_error(private_table_space), stack_overflow),
                 Text),
    \+ sub_string(Text, _, _, _, "private_table").
test(own_words, Text == "assert_fact/1: this is no coordinate: 1") :-
    message_text(en, error(domain_error(coordinate, 1),
                           context(sg_store:assert_fact/1, _)), Text).

%   What comes from files moves no cursor and fills no screen.

test(control_characters, Codes == []) :-
    message_text(en,
                 error(model_error(no_fact('a\e]0;x\a\n\u202e\u0085\x7f\')),
                       location('\e[2J.pl', 1, 1)), Text),
    split_string(Text, "\n", "", [First|_]),
    once(sub_string(First, _, _, _, "␛[2J.pl:1:1: ")),
    string_codes(Text, All),
    findall(Code, ( member(Code, All), Code \== 0'\n,
                    ( Code < 0x20 ; Code >= 0x7f, Code =< 0x9f
                    ; Code =:= 0x202e ) ), Codes).
test(deep_and_long, true(Length < 4000)) :-
    numlist(1, 100000, List),
    foldl(inner, List, [], Deep),
    message_text(en, error(model_error(no_fact(f(List, Deep))),
                           location('a.pl', 1, 1)), Text1),
    atomic_list_concat(List, Long),
    message_text(en, error(model_error(no_fact(Long)),
                           location('a.pl', 1, 1)), Text2),
    string_length(Text1, Length1),
    string_length(Text2, Length2),
    Length is max(Length1, Length2).
test(cyclic_twice, true(Length < 4000)) :-
    Term = [Term|Term],
    message_text(en, error(type_error(tree, Term), _), Text),
    string_length(Text, Length).
test(cyclic, true(Length < 4000)) :-
    Term = f(Term, [a|Term]),
    message_text(en, error(type_error(tree, Term), _), Text),
    string_length(Text, Length).

inner(N, Term, [N,Term]).
test(unknown_procedure_en) :-
    message_text(en, error(existence_error(procedure, foo/1), foo/1), Text),
    once(sub_string(Text, _, _, _, "foo/1")).
test(unknown_list_en) :-
    message_text(en, error(existence_error(procedure, sg_host:[]/3), _), Text),
    once(sub_string(Text, _, _, _, "there is no predicate []/3")).
test(other_errors) :-
    message_text(ko, error(type_error(integer, a), _), Text),
    once(sub_string(Text, _, _, _, "integer")).

:- end_tests(messages).
