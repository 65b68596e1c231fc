:- module(sg_pattern_en,
          [ pattern_en//1,              % +What
            pattern_fault_en//1,        % +What
            some_numbers/2              % +Numbers, -Text
          ]).
:- use_module('../pattern/pattern_scale', [scale_text/2]).
:- use_module(library(lists), [append/3]).
/** <module> What happened on the way to a pattern on paper, in English.

pattern_ko.pl has the same heads in Korean (tests/rules/message/messages.plt).
*/

%!  pattern_en(+What)// is det.
%
%   The notice sanggwan(pattern(What)).

pattern_en(divided(Before, After)) -->
    [ 'pieces larger than the page are divided: of ~D in all there are now \c
       ~D'-[Before, After], nl,
      '  With --tile they stay whole, over pages to be stuck together.' ].
pattern_en(opened(Before, After)) -->
    [ 'pieces are parted so that slits have room for tabs: of ~D in all there \c
       are now ~D'-[Before, After] ].
pattern_en(opened_by_itself(Before, After)) -->
    pattern_en(opened(Before, After)),
    [ nl, '  With --no-open-slits they stay whole; much of the seam has no \c
           tab then.' ].
pattern_en(without_tab(D, N, Share, _, Seam, Es)) -->
    { memberchk(Seam, [lap,lock]) },
    !,
    [ 'pattern ~d: seams without an allowance: ~D (~3g % of the length of \c
       all); there is no room for it'-[D, N, Share] ],
    without_tab_en(Es).
pattern_en(without_tab(D, N, Share, Whys, Help, Es)) -->
    [ 'pattern ~d: seams without a tab: ~D (~3g % of the length of all); \c
       neither side has room for one'-[D, N, Share], nl, '  ' ],
    whys_en(Whys),
    without_tab_en(Es),
    without_tab_help_en(Help).
pattern_en(too_large(N)) -->
    [ '~D pieces with their tabs are larger than the page; each has a sheet, \c
       and goes beyond it'-[N], nl,
      '  Take a larger --page or narrower --tabs.' ].
pattern_en(scale(Scale)) -->
    { scale_text(Scale, Text) },
    [ 'the scale is ~w'-[Text] ].
pattern_en(yield(Share, Sheets)) -->
    { Percent is 100*Share },
    [ 'the pieces take ~1f % of the sheets (~D)'-[Percent, Sheets] ].
pattern_en(no_room(Role, N)) -->
    { role_en(Role, Words) },
    [ '~w left out: ~D; there is no room for letters that can be read'
      -[Words, N] ].

whys_en([Why-N|Whys]) -->
    { why_en(Why, Words) },
    [ '~w: ~D'-[Words, N] ],
    (   { Whys == [] }
    ->  []
    ;   [ ', ' ],
        whys_en(Whys)
    ).

why_en(short, 'too short').
why_en(slit, 'in slits that are too narrow').
why_en(taken, 'beside other tabs').

without_tab_en([]) -->
    !.
without_tab_en(Es) -->
    { some_numbers(Es, Text) },
    [ nl, '  Edges: ~w'-[Text] ].

without_tab_help_en(none) -->
    [].
without_tab_help_en(open_slits) -->
    [ nl, '  With --open-slits pieces are parted until slits have room.' ].

role_en(number, 'partner numbers').
role_en(face_name, 'names').
role_en(angle, 'bend angles').
role_en(generator_number, 'numbers of generators').
role_en(table, 'tables of true lengths').
role_en(bends, 'tables of bends').

%!  some_numbers(+Numbers, -Text) is det.
%
%   Text lists Numbers, of many the first twenty, and how many more there are.

some_numbers(Numbers, Text) :-
    (   length(First, 20),
        append(First, [_,_|_], Numbers)
    ->  length(Numbers, N),
        More is N-20,
        atomic_list_concat(First, ', ', Text0),
        format(atom(Text), '~w, ... (+~D)', [Text0,More])
    ;   atomic_list_concat(Numbers, ', ', Text)
    ).

%!  pattern_fault_en(+What)// is det.
%
%   The message for usage_error(pattern(What)).

pattern_fault_en(paper(Page, Names)) -->
    { atomic_list_concat(Names, ' ', All) },
    [ '--page ~w: there is no such paper'-[Page], nl,
      '  Take one of ~w letter, perhaps with -portrait or -landscape, or WxH \c
       in mm, from 50 to 20000.'-[All] ].
pattern_fault_en(scale(Text)) -->
    [ '--scale ~w is no scale'-[Text], nl,
      '  Write 1:2 for half the size, 5:1 for five times.' ].
pattern_fault_en(no_height) -->
    [ '--height: what is unfolded has no height'-[], nl,
      '  Give --scale, --pages or --fit.' ].
pattern_fault_en(no_scale) -->
    [ '--pages: at no scale the pattern fits on so few pages'-[], nl,
      '  Give more --pages, a larger --page or narrower --tabs.' ].
pattern_fault_en(kerf(Kerf, Piece)) -->
    [ '--kerf ~w is wider than a slot, a hole or a tab of piece ~w'
      -[Kerf, Piece], nl,
      '  Take a narrower cut, or a larger --scale.' ].
pattern_fault_en(margin(Margin, W-H)) -->
    [ '--margin ~w leaves no room on a page of ~w x ~w mm'-[Margin, W, H], nl,
      '  Take a smaller margin or a larger --page.' ].
pattern_fault_en(pages(Count, Most)) -->
    [ 'the pattern would take ~D pages; ~D are the most'-[Count, Most], nl,
      '  Take a smaller --scale or a larger --page.' ].
pattern_fault_en(large(Size, Most)) -->
    [ 'the pattern would be ~4g mm large; ~4g mm are the most'-[Size, Most], nl,
      '  Take a smaller --scale, such as 1:1000; are the units of the model \c
         right?' ].
pattern_fault_en(wide(Option, Width, Most, W-H)) -->
    [ '~w ~w: pieces have to be divided to fit on pages with room for \c
       ~1f x ~1f mm, and this leaves too little of it'
      -[Option, Width, W, H], nl,
      '  Take at most ~w, or a larger --page.'-[Most] ].
pattern_fault_en(overlap(Overlap, Most)) -->
    [ '--overlap ~w is more than half a page has room for'-[Overlap], nl,
      '  Take at most ~w, or a larger --page.'-[Most] ].
