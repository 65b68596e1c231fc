:- module(sg_sheet_en,
          [ sheet_en//1,                % +What
            sheet_tiny_en//3            % +N, +M, +How
          ]).
:- use_module(message_parts,
              [meant_en//1, size_that_fits/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
/** <module> What is wrong with what was asked of a sheet, in English.

sheet_ko.pl has the same heads in Korean.
*/

%!  sheet_en(+What)// is det.
%
%   The message for usage_error(sheet(What)).

sheet_en(paper(Text, Names)) -->
    { atomic_list_concat(Names, ' ', All) },
    [ '--sheet ~w: there is no such paper'-[Text], nl,
      '  Take one of ~w, perhaps with -portrait or -landscape.'-[All] ].
sheet_en(view(Text, Names)) -->
    { atomic_list_concat(Names, ' ', All) },
    [ '--views: no view is called ~w'-[Text], nl,
      '  There are: ~w.'-[All] ].
sheet_en(no_view(Text, Near, Names)) -->
    { atomic_list_concat(Names, ', ', All) },
    [ '--view ~w: there is no such view'-[Text] ],
    meant_en(Near),
    [ nl, '  Write ~w, or degrees, such as 30,60.'-[All] ].
sheet_en(view_twice(Name)) -->
    [ '--views: the view ~w is there twice'-[Name] ].
sheet_en(scale(Text)) -->
    [ '--scale ~w is no scale'-[Text], nl,
      '  Write 1:2 for half the size, 5:1 for five times, or fit.' ].
sheet_en(too_large(N:M, Paper, Fitting, Papers)) -->
    [ 'at ~w:~w the views do not fit on ~w'-[N, M, Paper], nl ],
    fitting_en(Fitting, Papers).
sheet_en(size(W-H, Width-Height)) -->
    { maplist(short, [Width,Height], Needed),
      append([W,H], Needed, Numbers),
      size_that_fits(Width, Height, Size) },
    [ 'a sheet of ~w x ~w mm is too small at this scale: \c
       the picture has ~w x ~w mm'-Numbers, nl,
      '  --size ~w is enough; without --size it is as large as needed.'-
          [Size] ].
sheet_en(no_room(Paper)) -->
    [ 'the views do not fit on ~w at any scale down to 1:10^9'-[Paper], nl,
      '  Take a larger --sheet, fewer --views and --section, or \c
       --scale fit.' ].
sheet_en(many_sections(Most)) -->
    [ 'a sheet has ~w sections at most, a letter for each'-[Most] ].
sheet_en(section(Text)) -->
    [ '--section ~w is no plane'-[Text], nl,
      '  Write x=5, y=5 or z=5; x, y or z alone to cut through the middle; \c
       or A,B,C,D', nl,
      '  for the plane A*X + B*Y + C*Z + D = 0, seen from where that is \c
       above 0.' ].
sheet_en(section_past(Text, none)) -->
    [ '--section ~w: there is nothing to cut'-[Text] ].
sheet_en(section_past(Text, box(X1,Y1,Z1,X2,Y2,Z2))) -->
    { maplist(short, [X1,X2,Y1,Y2,Z1,Z2], Numbers) },
    [ '--section ~w goes past the model'-[Text], nl,
      '  It has x from ~w to ~w, y from ~w to ~w, z from ~w to ~w.'-Numbers ].
sheet_en(no_direction(Name, Text)) -->
    [ '~w ~w: that is no direction to look in'-[Name, Text], nl,
      '  The eye has to be elsewhere than what it looks at.' ].

%!  sheet_tiny_en(+N, +M, +How)// is det.
%
%   The message for sheet_tiny(N:M, How): How is `fit`, what is done instead, or
%   `as_asked`.

sheet_tiny_en(N, M, fit) -->
    [ 'at ~w:~w, the largest of the usual scales, nothing could be seen: \c
       the model is drawn as large as there is room'-[N, M] ].
sheet_tiny_en(N, M, as_asked) -->
    [ 'at ~w:~w the views are smaller than a tenth of a millimetre'-[N, M] ].

fitting_en(N:M, []) -->
    [ '  --scale ~w:~w does fit.'-[N, M] ].
fitting_en(N:M, [Paper]) -->
    [ '  --scale ~w:~w does fit, or take --sheet ~w.'-[N, M, Paper] ].

short(Number, Text) :-
    format(atom(Text), '~4g', [Number]).
