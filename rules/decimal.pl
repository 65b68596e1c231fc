:- module(sg_decimal,
          [ decimal_number/2,           % +Text, -Number
            decimal_comma/4             % @Name, @Whole, @Part, -Point
          ]).
:- use_module(library(apply), [maplist/2]).
/** <module> Numbers as people write them. */

%!  decimal_number(+Text, -Number) is semidet.
%
%   Text is Number as people write it, such as -12.5, .5 or 1e-3; Prolog's other
%   ways (0x1F, 1r3, inf) are none here.

decimal_number(Text, Number) :-
    split_string(Text, "", " ", [Trimmed]),
    string_chars(Trimmed, Chars0),
    maplist(decimal_char, Chars0),
    with_whole_part(Chars0, Chars),
    catch(number_chars(Number, Chars), error(_, _), fail).

decimal_char(Char) :-
    (   char_type(Char, digit)
    ->  true
    ;   memberchk(Char, ['.',e,'E',+,-])
    ).

with_whole_part([Sign,'.'|Chars], [Sign,'0','.'|Chars]) :-
    memberchk(Sign, [+,-]),
    !.
with_whole_part(['.'|Chars], ['0','.'|Chars]) :-
    !.
with_whole_part(Chars, Chars).

%!  decimal_comma(@Name, @Whole, @Part, -Point) is semidet.
%
%   A parameter Name is given Whole,Part, two whole numbers: Point is the number
%   that may be meant.

decimal_comma(Name, Whole, Part, Point) :-
    atom(Name),
    integer(Whole),
    integer(Part),
    Part >= 0,
    atomic_list_concat([Whole,'.',Part], Point).
