:- encoding(utf8).
:- module(sg_sheet_words,
          [ sheet_word/3,               % ?Item, ?Language, -Word
            pupil_word/3                % +Field, +Language, -Word
          ]).
/** <module> What the fields of a title block are called.
*/

%!  sheet_word(?Item, ?Language, -Word) is nondet.
%
%   Word, a string, stands above the field for Item in a drawing in Language.

sheet_word(drawn_by,   en, "Drawn by").
sheet_word(drawn_by,   ko, "제도").
sheet_word(checked_by, en, "Checked by").
sheet_word(checked_by, ko, "검도").
sheet_word(date,       en, "Date").
sheet_word(date,       ko, "작성일").
sheet_word(material,   en, "Material").
sheet_word(material,   ko, "재질").
sheet_word(company,    en, "Company").
sheet_word(company,    ko, "회사(소속)").
sheet_word(name,       en, "Name").
sheet_word(name,       ko, "도명").
sheet_word(number,     en, "Drawing number").
sheet_word(number,     ko, "도면 번호").
sheet_word(scale,      en, "Scale").
sheet_word(scale,      ko, "척도").
sheet_word(angle,      en, "Projection").
sheet_word(angle,      ko, "투상법").
sheet_word(paper,      en, "Size").
sheet_word(paper,      ko, "용지").
sheet_word(revision,   en, "Revision").
sheet_word(revision,   ko, "개정 기호").
sheet_word(sheet,      en, "Sheet").
sheet_word(sheet,      ko, "장 번호").

%!  pupil_word(+Field, +Language, -Word) is det.
%
%   Word, a string, stands above a Field that a pupil fills in.

pupil_word(Field, Language, Word) :-
    (   pupil(Field, Language, Word0)
    ->  Word = Word0
    ;   atom_string(Field, Word)
    ).

pupil(class,  en, "Class").
pupil(class,  ko, "반").
pupil(name,   en, "Pupil").
pupil(name,   ko, "이름").
pupil(number, en, "Number in class").
pupil(number, ko, "번호").
pupil(date,   en, "Date").
pupil(date,   ko, "날짜").
