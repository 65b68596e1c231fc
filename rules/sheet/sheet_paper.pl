:- module(sg_sheet_paper,
          [ paper/3,                    % +Text, -Width, -Height
            paper_name/3,               % +Width, +Height, -Name
            paper_size/3,               % ?Name, ?Long, ?Short
            standard_scale/1,           % ?Scale
            scale_factor/2,             % +Scale, -Factor
            unit_millimetres/2          % ?Unit, ?Millimetres
          ]).
:- use_module(library(lists), [member/2]).
/** <module> Paper: sizes of sheets, and scales.

Sizes are those of ISO 216, in millimetres; scales are those of ISO 5455: 1, 2
and 5 times a power of ten.
*/

%!  paper_size(?Name, ?Long, ?Short) is nondet.
%
%   The sizes that have a name, smallest first; the sides in millimetres.

paper_size('A4',  297, 210).
paper_size('A3',  420, 297).
paper_size('A2',  594, 420).
paper_size('A1',  841, 594).
paper_size('A0', 1189, 841).

%!  paper(+Text, -Width, -Height) is semidet.
%
%   Text, in capitals or not, names a sheet of Width x Height millimetres: a
%   size, perhaps with `-landscape` or `-portrait`. Without it an A4 stands
%   upright, others lie.

paper(Text, Width, Height) :-
    upcase_atom(Text, Upper),
    atomic_list_concat([Size|Way], -, Upper),
    paper_size(Size, Long, Short),
    way(Way, Size, Lying),
    (   Lying == true
    ->  Width = Long,
        Height = Short
    ;   Width = Short,
        Height = Long
    ).

way(['LANDSCAPE'], _, true).
way(['PORTRAIT'], _, false).
way([], Size, Lying) :-
    (   Size == 'A4'
    ->  Lying = false
    ;   Lying = true
    ).

%!  paper_name(+Width, +Height, -Name) is det.
%
%   Name is the size of such a sheet, or `210x148` if it has none.

paper_name(Width, Height, Name) :-
    Long is max(Width, Height),
    Short is min(Width, Height),
    (   paper_size(Name0, L, S),
        L =:= Long,
        S =:= Short
    ->  Name = Name0
    ;   format(atom(Name), '~wx~w', [Width, Height])
    ).

%!  standard_scale(?Scale) is nondet.
%
%   Scale, N:M, is one of the standard ones, largest first: 5:1, 2:1, 1:1, 1:2,
%   1:5 and so on, from 10^9:1 to 1:10^9.

standard_scale(N:1) :-
    between(1, 9, I),
    Power is 10**(9-I),
    member(Digit, [10,5,2]),
    N is Digit*Power.
standard_scale(1:1).
standard_scale(1:M) :-
    between(0, 8, I),
    Power is 10**I,
    member(Digit, [2,5,10]),
    M is Digit*Power.

%!  scale_factor(+Scale, -Factor) is det.
%
%   Factor is what Scale, N:M, multiplies lengths by.

scale_factor(N:M, Factor) :-
    Factor is N/float(M).

%!  unit_millimetres(?Unit, ?Millimetres) is nondet.
%
%   The units that a model can be in.

unit_millimetres(mm,      1.0).
unit_millimetres(cm,     10.0).
unit_millimetres(m,    1000.0).
unit_millimetres(inch,   25.4).
