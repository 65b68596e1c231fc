:- encoding(utf8).
:- module(sg_sheet_ko,
          [ sheet_ko//1,                % +What
            sheet_tiny_ko//3            % +N, +M, +How
          ]).
:- use_module(message_parts, [meant_ko//1, size_that_fits/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
/** <module> What is wrong with what was asked of a sheet, in Korean.

sheet_en.pl has the same heads in English.
*/

%!  sheet_ko(+What)// is det.
%
%   The message for usage_error(sheet(What)).

sheet_ko(paper(Text, Names)) -->
    { atomic_list_concat(Names, ' ', All) },
    [ '--sheet ~w: 그런 용지는 없습니다'-[Text], nl,
      '  ~w 가운데 고르십시오. 뒤에 -portrait(세로)나 -landscape(가로)를 \c
       붙일 수 있습니다.'-[All] ].
sheet_ko(view(Text, Names)) -->
    { atomic_list_concat(Names, ' ', All) },
    [ '--views: 그런 투상도는 없습니다: ~w'-[Text], nl,
      '  있는 것: ~w.'-[All] ].
sheet_ko(no_view(Text, Near, Names)) -->
    { atomic_list_concat(Names, ', ', All) },
    [ '--view ~w: 그런 시점은 없습니다'-[Text] ],
    meant_ko(Near),
    [ nl, '  ~w 가운데 하나, 또는 30,60처럼 각도를 쓰십시오.'-[All] ].
sheet_ko(view_twice(Name)) -->
    [ '--views: ~w 투상도가 두 번 있습니다'-[Name] ].
sheet_ko(scale(Text)) -->
    [ '--scale ~w: 척도가 아닙니다'-[Text], nl,
      '  절반은 1:2, 다섯 배는 5:1, 용지에 맞추려면 fit이라고 쓰십시오.' ].
sheet_ko(too_large(N:M, Paper, Fitting, Papers)) -->
    [ '척도 ~w:~w(으)로는 투상도가 ~w 용지에 다 들어가지 않습니다'-[N, M, Paper], nl ],
    fitting_ko(Fitting, Papers).
sheet_ko(size(W-H, Width-Height)) -->
    { maplist(short, [Width,Height], Needed),
      append([W,H], Needed, Numbers),
      size_that_fits(Width, Height, Size) },
    [ '이 척도로는 ~w x ~w mm 용지가 작습니다. 그림이 ~w x ~w mm입니다'
      -Numbers, nl,
      '  --size ~w 옵션이면 들어갑니다. --size를 빼면 필요한 만큼 큰 \c
       용지가 됩니다.'-[Size] ].
sheet_ko(no_room(Paper)) -->
    [ '1:10^9까지 어떤 척도로도 투상도가 ~w 용지에 다 들어가지 않습니다'-[Paper], nl,
      '  더 큰 --sheet나 더 적은 --views와 --section이나 \c
       --scale fit을 쓰십시오.' ].
sheet_ko(many_sections(Most)) -->
    [ '용지 한 장에 단면은 글자 하나씩, ~w개까지 됩니다'-[Most] ].
sheet_ko(section(Text)) -->
    [ '--section ~w: 평면이 아닙니다'-[Text], nl,
      '  x=5, y=5, z=5, 또는 가운데를 자르려면 x, y, z만, 또는 A,B,C,D를 \c
       쓰십시오.', nl,
      '  A,B,C,D는 평면 A*X + B*Y + C*Z + D = 0이고, 이 값이 0보다 큰 \c
       쪽에서 봅니다.' ].
sheet_ko(section_past(Text, none)) -->
    [ '--section ~w: 자를 것이 없습니다'-[Text] ].
sheet_ko(section_past(Text, box(X1,Y1,Z1,X2,Y2,Z2))) -->
    { maplist(short, [X1,X2,Y1,Y2,Z1,Z2], Numbers) },
    [ '--section ~w: 모델을 지나지 않습니다'-[Text], nl,
      '  모델의 x는 ~w~~~w, y는 ~w~~~w, z는 ~w~~~w입니다.'-Numbers ].
sheet_ko(no_direction(Name, Text)) -->
    [ '~w ~w: 보는 방향이 없습니다'-[Name, Text], nl,
      '  눈은 보는 것과 다른 곳에 있어야 합니다.' ].

%!  sheet_tiny_ko(+N, +M, +How)// is det.
%
%   As sheet_tiny_en//3.

sheet_tiny_ko(N, M, fit) -->
    [ '흔히 쓰는 척도 가운데 가장 큰 ~w:~w(으)로도 보이지 않을 만큼 작아, 자리가 \c
       닿는 대로 크게 그립니다'-[N, M] ].
sheet_tiny_ko(N, M, as_asked) -->
    [ '~w:~w에서는 투상도들이 0.1 mm보다 작습니다'-[N, M] ].

fitting_ko(N:M, []) -->
    [ '  --scale ~w:~w(이)면 들어갑니다.'-[N, M] ].
fitting_ko(N:M, [Paper]) -->
    [ '  --scale ~w:~w(이)면 들어갑니다. 아니면 --sheet ~w 옵션을 쓰십시오.'
      -[N, M, Paper] ].

short(Number, Text) :-
    format(atom(Text), '~4g', [Number]).
