:- encoding(utf8).
:- module(sg_plate_words,
          [ plate_column/3,             % ?Column, ?Language, -Word
            direction_word/3,           % +Language, +Direction, -Word
            material_word/3,            % +Language, +Material, -Word
            bends_title/2               % +Language, -Title
          ]).
/** <module> What the tables and the report of a pattern in plate are worded in.
*/

%!  plate_column(?Column, ?Language, -Word) is nondet.
%
%   Word stands above Column of a table of bends, or of what a plate weighs.

plate_column(bend, en, bend).
plate_column(angle, en, angle).
plate_column(direction, en, direction).
plate_column(radius, en, 'radius (mm)').
plate_column(length, en, 'length (mm)').
plate_column(thickness, en, 'thickness (mm)').
plate_column(weight, en, 'weight (kg)').
plate_column(material, en, material).
plate_column(bend, ko, '굽힘').
plate_column(angle, ko, '각도').
plate_column(direction, ko, '방향').
plate_column(radius, ko, '반지름 (mm)').
plate_column(length, ko, '길이 (mm)').
plate_column(thickness, ko, '두께 (mm)').
plate_column(weight, ko, '무게 (kg)').
plate_column(material, ko, '재료').

%!  direction_word(+Language, +Direction, -Word) is semidet.
%
%   Word says Direction, `up` or `down`.

direction_word(en, Word, Word).
direction_word(ko, down, '아래').
direction_word(ko, up, '위').

%!  material_word(+Language, +Material, -Word) is semidet.
%
%   Word says Material, as of material/2 (pattern_plate.pl).

material_word(en, Name, Name).
material_word(ko, Name, Word) :-
    material_ko(Name, Word).

material_ko(steel,     '강').
material_ko(stainless, '스테인리스강').
material_ko(aluminium, '알루미늄').
material_ko(copper,    '구리').
material_ko(brass,     '황동').
material_ko(zinc,      '아연').
material_ko(titanium,  '티타늄').

%!  bends_title(+Language, -Title:string) is semidet.
%
%   Title stands over a table of bends that has no name.

bends_title(en, "bends").
bends_title(ko, "굽힘표").
