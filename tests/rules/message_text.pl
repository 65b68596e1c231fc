:- module(test_message_text,
          [ message_text/3              % +Language, +Term, -Text
          ]).

:- use_module(rules(message/spoken), [spoken_lines/4]).
/** <module> What is printed for a message. */

%!  message_text(+Language, +Term, -Text:string) is det.
%
%   Text is the message for Term, an error or a message term, in Language, a
%   locale such as `en` or `ko_KR`.

message_text(Language, Term, Text) :-
    current_prolog_flag(message_language, Old),
    setup_call_cleanup(
        set_prolog_flag(message_language, Language),
        ( phrase('$messages':translate_message(Term), Lines0),
          spoken_lines(error, Term, Lines0, Lines)
        ),
        set_prolog_flag(message_language, Old)),
    with_output_to(string(Text0),
                   print_message_lines(current_output, '', Lines)),
    (   string_concat(Text, "\n", Text0)
    ->  true
    ;   Text = Text0
    ).
