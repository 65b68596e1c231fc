:- encoding(utf8).
:- module(sg_true_words,
          [ column_word/3               % ?Column, ?Language, -Word
          ]).
/** <module> What the columns of a table of true lengths are called.
*/

%!  column_word(?Column, ?Language, -Word) is nondet.
%
%   Word, an atom, stands above Column of a table in Language, before its unit.

column_word(number,    en, number).
column_word(number,    ko, '번호').
column_word(parameter, en, parameter).
column_word(parameter, ko, '매개각').
column_word(arc,       en, arc).
column_word(arc,       ko, '호').
column_word(angle,     en, angle).
column_word(angle,     ko, '꼭지각').
column_word(from,      en, from).
column_word(from,      ko, '아래 끝').
column_word(to,        en, to).
column_word(to,        ko, '위 끝').
column_word(apex_from, en, 'apex to from').
column_word(apex_from, ko, '꼭짓점에서 아래 끝').
column_word(apex_to,   en, 'apex to to').
column_word(apex_to,   ko, '꼭짓점에서 위 끝').
column_word(length,    en, length).
column_word(length,    ko, '실제 길이').
column_word(step_from, en, 'step from').
column_word(step_from, ko, '아래 간격').
column_word(step_to,   en, 'step to').
column_word(step_to,   ko, '위 간격').
column_word(diagonal,  en, diagonal).
column_word(diagonal,  ko, '대각선').
column_word(degrees,   en, degrees).
column_word(degrees,   ko, '도').
