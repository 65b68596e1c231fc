:- module(sg_lettering,
          [ lettering/2,                % +Text, -Lines
            text_glyphs/4,              % +Text, -Glyphs, -Start, -Scale
            lettering_width/3,          % +String, +Height, -Width
            lettering_reach/3           % +String, -Width, -Drop
          ]).
:- use_module(hangul, [syllable/3]).
:- use_module(letter, [letter/3]).
:- use_module('../kernel', [letter_lines/5]).
:- use_module(library(lists), [max_list/2, member/2]).
/** <module> Lettering: texts as lines of a pen.

Where a format has no texts of its own (a plotter, a cutter), or only with
fonts that have to come along (PDF), texts are drawn: letters of a single stroke
(letter.pl), Korean too (hangul.pl). So they look the same everywhere. A
character that is not known is drawn as a box.
*/

:- set_prolog_flag(optimise, true).

%!  lettering(+Text, -Lines) is det.
%
%   Lines are the letters of Text, text(X,Y,Height,Anchor,String), see
%   sheet.pl: lists of points, X-Y, integers in its unit, y DOWN.

lettering(Text, Lines) :-
    Text = text(_, Y, _, _, _),
    text_glyphs(Text, Glyphs, Start, Scale),
    letter_lines(Glyphs, Start, Y, Scale, Lines).

%!  text_glyphs(+Text, -Glyphs, -Start, -Scale) is det.
%
%   Glyphs, Start and Scale are those of letter_lines/5 for Text.

text_glyphs(text(X,_,Height,Anchor,String), Glyphs, Start, Scale) :-
    Scale is Height/6,
    placed(String, Glyphs, Width),
    start(Anchor, X, Width*Scale, Start).

start(start, X, _, X).
start(middle, X, Width, Start) :-
    Start is X - Width/2.
start(end, X, Width, Start) :-
    Start is X - Width.

%!  lettering_width(+String, +Height, -Width) is det.
%
%   Width is how wide String is when its capitals are Height high.

lettering_width(String, Height, Width) :-
    placed(String, _, Width0),
    Width is Width0*Height/6.

%!  lettering_reach(+String, -Width, -Drop) is det.
%
%   How wide String is, and how far it reaches below the line that capitals
%   stand on, with the tail of a p or the end of a bracket, when these are 6
%   high.

lettering_reach(String, Width, Drop) :-
    placed(String, Glyphs, Width),
    findall(Y, ( member(_-Strokes, Glyphs), stroke_depth(Strokes, Y) ), Ys),
    max_list([0|Ys], Drop).

stroke_depth(Strokes, Depth) :-
    member(Stroke, Strokes),
    member(Point, Stroke),
    ( Point = _-Y ; Point = c(_,Y) ),
    Depth is -Y.

%   placed(String, Glyphs, Width): Glyphs are At-Strokes; between letters there
%   is a quarter of the height of a capital.

placed(String, Glyphs, Width) :-
    string_codes(String, Codes),
    placed_codes(Codes, 0, Glyphs, Width).

placed_codes([], _, [], 0).
placed_codes([Code|Codes], At, [At-Strokes|Glyphs], Width) :-
    glyph(Code, Own, Strokes),
    (   Codes == []
    ->  Glyphs = [],
        Width is At+Own
    ;   Next is At+Own+1.5,
        placed_codes(Codes, Next, Glyphs, Width)
    ).

glyph(Code, Width, Strokes) :-
    (   letter(Code, Width0, Strokes0)
    ->  Width = Width0,
        Strokes = Strokes0
    ;   syllable(Code, Width0, Strokes0)
    ->  Width = Width0,
        Strokes = Strokes0
    ;   Width = 4,
        Strokes = [[0-0,0-6,4-6,4-0,0-0]]
    ).
