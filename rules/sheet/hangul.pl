:- encoding(utf8).
:- module(sg_hangul,
          [ syllable/3                  % +Code, -Width, -Strokes
          ]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2, nth0/3]).
/** <module> Hangul in single strokes, syllables put together from letters.

A syllable has a first consonant, a vowel, and perhaps one or two last
consonants. Vowels stand on the right of the first consonant (ㅏ), below it (ㅗ)
or both (ㅘ), the last ones below everything; what is there decides the boxes
that each gets. Letters are drawn in a square from 0 to 1, y UP, and stretched
to their boxes; strokes and points as in letter.pl.

@see The Unicode Standard, 3.12: conjoining jamo behaviour
*/

%!  syllable(+Code, -Width, -Strokes) is semidet.
%
%   True when Code is a syllable of Hangul, Width wide and drawn by Strokes.

syllable(Code, 6, Strokes) :-
    Code >= 0xAC00,
    Code =< 0xD7A3,
    Number is Code-0xAC00,
    FirstNumber is Number//588,
    VowelNumber is Number mod 588 // 28,
    LastNumber is Number mod 28,
    firsts(Firsts),
    nth0(FirstNumber, Firsts, First),
    vowels(Vowels),
    nth0(VowelNumber, Vowels, Below-Beside),
    lasts(Lasts),
    nth0(LastNumber, Lasts, Last),
    kind(Below, B),
    kind(Beside, R),
    kind(Last, L),
    once(boxes(B, R, L, FirstBox, BelowBox, BesideBox, LastBox)),
    row_strokes(First, FirstBox, FirstStrokes),
    vowel_strokes(Below, BelowBox, BelowStrokes),
    vowel_strokes(Beside, BesideBox, BesideStrokes),
    row_strokes(Last, LastBox, LastStrokes),
    append([FirstStrokes,BelowStrokes,BesideStrokes,LastStrokes], Strokes).

kind(none, no) :-
    !.
kind([], no) :-
    !.
kind(_, yes).

%   boxes(Below, Beside, Last, FirstBox, BelowBox, BesideBox, LastBox): is
%   there a vowel below, one beside, a last consonant? A box is
%   box(X0,Y0,X1,Y1).

boxes(no, yes, no, box(0.1,0.6,3.1,5.6), none, box(3.7,-0.5,6.0,6.5), none).
boxes(no, yes, yes, box(0.1,2.9,3.1,6.2), none, box(3.7,2.6,6.0,6.6),
      box(0.9,-0.6,5.6,1.9)).
boxes(yes, no, no, box(1.0,2.9,5.0,6.2), box(0.0,-0.2,6.0,2.3), none, none).
boxes(yes, no, yes, box(1.0,4.3,5.0,6.5), box(0.0,2.3,6.0,3.8), none,
      box(1.0,-0.6,5.0,1.5)).
boxes(yes, yes, no, box(0.3,3.2,3.5,6.2), box(0.0,0.2,4.0,2.6),
      box(4.3,-0.5,6.0,6.5), none).
boxes(yes, yes, yes, box(0.3,4.4,3.5,6.5), box(0.0,2.5,4.0,3.9),
      box(4.3,2.2,6.0,6.6), box(0.9,-0.6,5.6,1.5)).

%   row_strokes(Letters, Box, Strokes): one consonant, or two side by side.

row_strokes([], _, Strokes) =>
    Strokes = [].
row_strokes([Letter], Box, Strokes) =>
    consonant(Letter, Strokes0),
    stretched(Box, Strokes0, Strokes).
row_strokes([A,B], box(X0,Y0,X1,Y1), Strokes) =>
    XA is X0 + 0.43*(X1-X0),
    XB is X0 + 0.57*(X1-X0),
    row_strokes([A], box(X0,Y0,XA,Y1), StrokesA),
    row_strokes([B], box(XB,Y0,X1,Y1), StrokesB),
    append([StrokesA,StrokesB], Strokes).

vowel_strokes(none, _, []) :-
    !.
vowel_strokes(Vowel, Box, Strokes) :-
    vowel(Vowel, Strokes0),
    stretched(Box, Strokes0, Strokes).

stretched(Box, Strokes0, Strokes) :-
    maplist(stretched_stroke(Box), Strokes0, Strokes).

stretched_stroke(Box, Points0, Points) :-
    maplist(stretched_point(Box), Points0, Points).

stretched_point(Box, X0-Y0, Point) =>
    Point = X-Y,
    in_box(Box, X0, Y0, X, Y).
stretched_point(Box, c(X0,Y0), Point) =>
    Point = c(X,Y),
    in_box(Box, X0, Y0, X, Y).

in_box(box(XA,YA,XB,YB), X0, Y0, X, Y) :-
    X is XA + X0*(XB-XA),
    Y is YA + Y0*(YB-YA).

%   The letters of syllables in the order of their numbers.

firsts([ [ㄱ], [ㄱ,ㄱ], [ㄴ], [ㄷ], [ㄷ,ㄷ], [ㄹ], [ㅁ], [ㅂ], [ㅂ,ㅂ], [ㅅ],
         [ㅅ,ㅅ], [ㅇ], [ㅈ], [ㅈ,ㅈ], [ㅊ], [ㅋ], [ㅌ], [ㅍ], [ㅎ] ]).

lasts([ [], [ㄱ], [ㄱ,ㄱ], [ㄱ,ㅅ], [ㄴ], [ㄴ,ㅈ], [ㄴ,ㅎ], [ㄷ], [ㄹ],
        [ㄹ,ㄱ], [ㄹ,ㅁ], [ㄹ,ㅂ], [ㄹ,ㅅ], [ㄹ,ㅌ], [ㄹ,ㅍ], [ㄹ,ㅎ], [ㅁ],
        [ㅂ], [ㅂ,ㅅ], [ㅅ], [ㅅ,ㅅ], [ㅇ], [ㅈ], [ㅊ], [ㅋ], [ㅌ], [ㅍ],
        [ㅎ] ]).

%   Below-Beside.

vowels([ none-ㅏ, none-ㅐ, none-ㅑ, none-ㅒ, none-ㅓ, none-ㅔ, none-ㅕ,
         none-ㅖ, ㅗ-none, ㅗ-ㅏ, ㅗ-ㅐ, ㅗ-ㅣ, ㅛ-none, ㅜ-none, ㅜ-ㅓ, ㅜ-ㅔ,
         ㅜ-ㅣ, ㅠ-none, ㅡ-none, ㅡ-ㅣ, none-ㅣ ]).

consonant(ㄱ, [[0-1,1-1,0.85-0]]).
consonant(ㄴ, [[0-1,0-0,1-0]]).
consonant(ㄷ, [[1-1,0-1,0-0,1-0]]).
consonant(ㄹ, [[0-1,1-1,1-0.5,0-0.5,0-0,1-0]]).
consonant(ㅁ, [[0-0,0-1,1-1,1-0,0-0]]).
consonant(ㅂ, [[0-1,0-0,1-0,1-1],[0-0.5,1-0.5]]).
consonant(ㅅ, [[0.5-1,c(0.45,0.4),0-0],[0.49-0.75,c(0.6,0.35),1-0]]).
consonant(ㅇ, [[0.5-0,c(1,0),1-0.5,c(1,1),0.5-1,c(0,1),0-0.5,c(0,0),0.5-0]]).
consonant(ㅈ, [[0-1,1-1],[0.5-1,c(0.45,0.4),0-0],[0.49-0.75,c(0.6,0.35),1-0]]).
consonant(ㅊ, [[0.3-1,0.7-1],[0-0.75,1-0.75],[0.5-0.75,c(0.45,0.35),0-0],
               [0.49-0.55,c(0.6,0.3),1-0]]).
consonant(ㅋ, [[0-1,1-1,0.85-0],[0-0.5,0.92-0.5]]).
consonant(ㅌ, [[1-1,0-1,0-0,1-0],[0-0.5,1-0.5]]).
consonant(ㅍ, [[0-1,1-1],[0.3-1,0.3-0],[0.7-1,0.7-0],[0-0,1-0]]).
consonant(ㅎ, [[0.3-1,0.7-1],[0-0.76,1-0.76],
               [0.5-0,c(0.85,0),0.85-0.28,c(0.85,0.56),0.5-0.56,c(0.15,0.56),
                0.15-0.28,c(0.15,0),0.5-0]]).

vowel(ㅏ, [[0.35-1,0.35-0],[0.35-0.52,1-0.52]]).
vowel(ㅐ, [[0.25-1,0.25-0],[0.85-1,0.85-0],[0.25-0.52,0.85-0.52]]).
vowel(ㅑ, [[0.35-1,0.35-0],[0.35-0.65,1-0.65],[0.35-0.4,1-0.4]]).
vowel(ㅒ, [[0.25-1,0.25-0],[0.85-1,0.85-0],[0.25-0.65,0.85-0.65],
           [0.25-0.4,0.85-0.4]]).
vowel(ㅓ, [[0.75-1,0.75-0],[0-0.52,0.75-0.52]]).
vowel(ㅔ, [[0.5-1,0.5-0],[0.95-1,0.95-0],[0-0.52,0.5-0.52]]).
vowel(ㅕ, [[0.75-1,0.75-0],[0-0.65,0.75-0.65],[0-0.4,0.75-0.4]]).
vowel(ㅖ, [[0.5-1,0.5-0],[0.95-1,0.95-0],[0-0.65,0.5-0.65],
           [0-0.4,0.5-0.4]]).
vowel(ㅣ, [[0.5-1,0.5-0]]).
vowel(ㅗ, [[0.5-1,0.5-0.2],[0-0.2,1-0.2]]).
vowel(ㅛ, [[0.32-1,0.32-0.2],[0.68-1,0.68-0.2],[0-0.2,1-0.2]]).
vowel(ㅜ, [[0-0.85,1-0.85],[0.5-0.85,0.5-0]]).
vowel(ㅠ, [[0-0.85,1-0.85],[0.32-0.85,0.32-0],[0.68-0.85,0.68-0]]).
vowel(ㅡ, [[0-0.5,1-0.5]]).
