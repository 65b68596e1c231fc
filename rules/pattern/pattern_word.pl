:- module(sg_pattern_word,
          [ word_lines/3,               % +Height, +Word, -Lines
            word_lines/4,               % +Height, +Move, +Word, -Lines
            word_text/6                 % +Height, +Role, +S, +Word, +Strokes,
                                        % -Text
          ]).
:- use_module('../kernel', [laid_letters/8]).
:- use_module('../sheet/lettering', [text_glyphs/4]).
/** <module> Words on the sheets of a pattern.

    word(At, Way, High, Anchor, String)

is String with capitals High millimetres high: At, X-Y, is on its baseline, at
its Anchor (`start` or `middle`), and Way, U-V, is a unit vector to its right.
Words are drawn, as strokes of a pen; a format that has texts of its own (DXF)
takes word_text/6 of them instead.
*/

:- set_prolog_flag(optimise, true).

%!  word_lines(+Height, +Word, -Lines) is det.
%!  word_lines(+Height, +Move, +Word, -Lines) is det.
%
%   Lines are the letters of Word on a sheet of Height mm: lists of points, in
%   thousandths of a millimetre, y down. They are moved by Move, of
%   laid_letters/8.

word_lines(Height, Word, Lines) :-
    word_lines(Height, move(1, 0, 0, 0, 0, 0), Word, Lines).

word_lines(Height, Move, word(At,Way,High0,Anchor,String), Lines) :-
    High is round(High0*1000),
    text_glyphs(text(0,0,High,Anchor,String), Glyphs, Start, Scale),
    laid_letters(Glyphs, Start, Scale, At, Way, Move, Height, Lines).

%!  word_text(+Height, +Role, +S, +Word, +Strokes, -Text) is det.
%
%   Text is Word, of Role and S, on a sheet of Height mm, as views of a drawing
%   have it (ink.pl): word(Role,S,Angle,text(X,Y,High,Anchor,String),Strokes),
%   Angle in thousandths of a degree, counter-clockwise. Strokes are its
%   letters.

word_text(Height, Role, S, word(X0-Y0,U-V,High0,Anchor,String), Strokes,
          word(Role,S,Angle,text(X,Y,High,Anchor,String),Strokes)) :-
    X is round(X0*1000),
    Y is round((Height-Y0)*1000),
    High is round(High0*1000),
    Angle is round(atan2(V, U)*180000/pi) mod 360000.
