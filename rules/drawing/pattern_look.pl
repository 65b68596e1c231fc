:- module(sg_pattern_look,
          [ pattern_look/5              % ?Role, ?Width, ?Colour, ?Dashes, ?Pen
          ]).
/** <module> How the lines of a pattern look.

These roles are those of lines of patterns alone (pattern_drawing.pl), all of
them `visible`:

  - `cut`: where the sheet is cut
  - `fold_down`, `fold_up`: where it is folded away from the reader, and towards
    the reader (mountains and valleys)
  - `penetration_line`: where another part of the model goes through
  - `generator`: of a true development
  - `mark`: to align parts by, where nothing is cut or folded
  - `number`, `face_name`, `angle`, `generator_number`, `table`: letters, and
    the lines of the table of true lengths
  - `bar`: the check bar and what is written beside it
  - `crop`: crop marks and registration marks of a page
  - `grid`

A pen and a layer for each, so that a plotter or a cutter treats them apart.
*/

%!  pattern_look(?Role, ?Width, ?Colour, ?Dashes, ?Pen) is nondet.
%
%   True when lines of Role look so; the terms are those of a style (style.pl).

pattern_look(cut,              0.35, black, solid, 1).
pattern_look(fold_down,        0.25, colour(blue,black), [3.0,1.2], 2).
pattern_look(fold_up,          0.25, colour(green,black),
             [5.0,1.2,0.5,1.2], 3).
pattern_look(penetration_line, 0.18, red, solid, 4).
pattern_look(mark,             0.18, black, solid, 5).
pattern_look(generator,        0.18, grey, solid, 5).
pattern_look(generator_number, 0.18, grey, solid, 6).
pattern_look(table,            0.18, black, solid, 7).
pattern_look(number,           0.25, black, solid, 6).
pattern_look(face_name,        0.25, grey, solid, 6).
pattern_look(angle,            0.18, grey, solid, 6).
pattern_look(bar,              0.25, black, solid, 7).
pattern_look(crop,             0.18, black, solid, 7).
pattern_look(grid,             0.1,  rgb(190,190,190), solid, 8).
