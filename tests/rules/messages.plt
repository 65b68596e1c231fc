:- encoding(utf8).
:- module(test_messages, []).
:- use_module(library(plunit)).
:- use_module(rules(messages)).
:- use_module(rules(messages_ko)).

% The tables that must have the same heads in both languages.
table(english, korean).
table(fault_en, fault_ko).
table(usage_en, usage_ko).
table(notice_en, notice_ko).
table(expected_en, expected_ko).
table(polygon_en, polygon_ko).
table(mesh_en, mesh_ko).
table(drawing_en, drawing_ko).

% The first argument of every clause of a table, variables numbered.
heads(Module, Name, Heads) :-
    findall(Term,
            ( functor(Head, Name, 3),
              clause(Module:Head, _),
              arg(1, Head, Term),
              numbervars(Term, 0, _) ),
            Heads0),
    msort(Heads0, Heads).

text(Language, Term, Text) :-
    current_prolog_flag(message_language, Old),
    setup_call_cleanup(
        set_prolog_flag(message_language, Language),
        phrase('$messages':translate_message(Term), Lines),
        set_prolog_flag(message_language, Old)),
    with_output_to(string(Text0),
                   print_message_lines(current_output, '', Lines)),
    string_concat(Text, "\n", Text0).

:- begin_tests(messages).

test(both_languages, forall(table(English, Korean))) :-
    heads(sg_messages, English, Heads),
    heads(sg_messages_ko, Korean, HeadsKo),
    subtract(Heads, HeadsKo, OnlyEnglish),
    subtract(HeadsKo, Heads, OnlyKorean),
    OnlyEnglish == [],
    OnlyKorean == [].
test(something_there, forall(table(English, _))) :-
    heads(sg_messages, English, [_|_]).
test(primitives_in_both) :-
    heads(sg_messages, primitive_en, _),
    findall(W, clause(sg_messages:primitive_en(W, _, _, _), _), A),
    findall(W, clause(sg_messages_ko:primitive_ko(W, _, _, _), _), B),
    A =@= B.

test(place, Text == "a.pl:2:7: segment 1 has no vertex 9\n  Add it, or correct the number.") :-
    text(en, error(model_error(missing(v, 1, 9)), location('a.pl', 2, 7)),
         Text).
test(no_place) :-
    text(en, error(model_error(empty), location('a.pl', 0, 0)), Text),
    sub_string(Text, 0, _, _, "a.pl: the model is empty").
test(korean) :-
    text(ko, error(model_error(empty), location('a.pl', 0, 0)), Text),
    sub_string(Text, 0, _, _, "a.pl: 모델이 비어").
test(korean_of_korea) :-
    text(ko_KR, sanggwan(interrupted), "중단되었습니다").
test(unknown_language) :-
    text(fr, sanggwan(interrupted), "interrupted").
test(other_errors) :-
    text(ko, error(type_error(integer, a), _), Text),
    once(sub_string(Text, _, _, _, "integer")).

:- end_tests(messages).
