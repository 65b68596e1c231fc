:- module(sg_language,
          [ language/1                  % ?Language
          ]).
/** <module> The language that people are spoken to in.

Messages go through prolog:message//2, which has its own ways. This is for the
text that the program prints as its result: usage and reports.
*/

%!  language(?Language) is semidet.
%
%   Language is `ko` when the flag message_language says Korean, else `en`.

language(Language) :-
    current_prolog_flag(message_language, Flag),
    (   sub_atom(Flag, 0, _, _, ko)
    ->  Language0 = ko
    ;   Language0 = en
    ),
    Language = Language0.
