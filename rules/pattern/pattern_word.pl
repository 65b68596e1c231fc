:- module(sg_pattern_word,
          [ word_lines/2,               % +Word, -Lines
            word_text/6                 % +Height, +Role, +S, +Word, +Strokes,
                                        % -Text
          ]).
:- use_module('../sheet/lettering', [lettering/2]).
:- use_module(library(apply), [maplist/3]).
/** <module> Words on the sheets of a pattern.

    word(At, Way, High, Anchor, String)

is String with capitals High millimetres high: At, X-Y, is on its baseline, at
its Anchor (`start` or `middle`), and Way, U-V, is a unit vector to its right.
Words are drawn, as strokes of a pen; a format that has texts of its own (DXF)
takes word_text/6 of them instead.
*/

:- set_prolog_flag(optimise, true).

%!  word_lines(+Word, -Lines) is det.
%
%   Lines are the letters of Word, lists of points.

word_lines(word(X0-Y0,U-V,High0,Anchor,String), Lines) :-
    High is round(High0*1000),
    lettering(text(0,0,High,Anchor,String), Lines0),
    maplist(maplist_point(X0, Y0, U, V), Lines0, Lines).

maplist_point(X0, Y0, U, V, Points0, Points) :-
    maplist(letter_point(X0, Y0, U, V), Points0, Points).

letter_point(X0, Y0, U, V, A-B, X-Y) :-
    X is X0 + (A*U + B*V)/1000,
    Y is Y0 + (A*V - B*U)/1000.

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
