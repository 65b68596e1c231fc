:- module(sg_style,
          [ line_style/4,               % +Visibility, +Role, +Segment, -Style
            paper_style/1,              % -Colour
            line_type/3,                % ?Type, +Width, -Runs
            layer_name/1,               % +Layer
            sheet_role/1,               % ?Role
            style_role/1                % ?Role
          ]).
:- use_module('../decision', [decision/2]).
:- use_module('../picture/role', [role_rank/2]).
:- use_module(pattern_look, [pattern_look/5]).
:- use_module(library(apply), [maplist/3]).
/** <module> How lines look.

A style is what a writer has to know of a line, whatever the format:

    style(Width, Colour, Dashes, Pen, Layer)

  - Width: millimetres
  - Colour: rgb(R,G,B), bytes; one of the names in colour.pl; or
    colour(Screen, Print), one for screens and one for paper
  - Dashes: `solid`, a line type of line_type/3, or lengths in millimetres of
    a dash, a gap, a dash, a gap, ...
  - Pen: the pen of a plotter, 1 to 255
  - Layer: of a CAD file, at most 31 letters, digits, `_`, `-` and `$`

or `none` if such lines are not drawn. A rule file replaces line_style/4 and
paper_style/1 for one world; a style file (style_file.pl) changes properties of
what they say.

@see ISO 128-2 for line types and widths
*/

:- decision(line_style/4, "How lines of a visibility, role and segment look").

%!  line_style(+Visibility, +Role, +Segment, -Style) is semidet.
%
%   True when lines of Visibility and Role that belong to Segment have this
%   Style; Segment is 0 for what belongs to the sheet, see sheet_role/1. A
%   decision; where a rule file has no answer, this one holds.

line_style(visible, Role, _, style(Width,Colour,Dashes,Pen,Layer)) :-
    pattern_look(Role, Width, Colour, Dashes, Pen),
    !,
    upcase_atom(Role, Layer).
line_style(Visibility, Role, _, style(Width,Colour,Dashes,Pen,Layer)) :-
    line_width(Visibility, Role, Width),
    line_colour(Role, Colour),
    line_dashes(Visibility, Role, Dashes),
    line_pen(Visibility, Role, Pen),
    line_layer(Visibility, Role, Layer).

%   Widths of ISO 128-2, their ratio 1 to 2. A penetration line is what the
%   drawing is about, so it is wider.

line_width(Visibility, Role, Width) :-
    (   width(Visibility, Role, Width0)
    ->  Width = Width0
    ;   once(width(Visibility, any, Width))
    ).

width(visible, penetration, 0.7).
width(visible, smooth,      0.25).
width(visible, mesh,        0.25).
width(visible, frame,       0.7).
width(visible, cutting_end, 0.7).
width(visible, symbol,      0.35).
width(visible, text,        0.7).     % at most, see ink.pl
width(visible, field,       0.25).
width(visible, hatching,    0.25).
width(visible, shading,     0.25).
width(visible, cutting,     0.25).
width(visible, axis,        0.25).
width(visible, centre_line, 0.25).
width(visible, construction, 0.13).
width(visible, any,         0.5).
width(hidden,  penetration, 0.35).
width(hidden,  smooth,      0.18).
width(hidden,  mesh,        0.18).
width(hidden,  any,         0.25).

line_colour(Role, Colour) :-
    (   Role == penetration
    ->  Colour = colour(rgb(170,0,0), black)
    ;   Role == construction
    ->  Colour = rgb(110,110,110)
    ;   Colour = black
    ).

line_dashes(hidden, _, hidden).
line_dashes(visible, Role, Dashes) :-
    (   Role == centre_line
    ->  Dashes = chain
    ;   Dashes = solid
    ).

line_pen(hidden, _, Pen) =>
    Pen = 2.
line_pen(visible, penetration, Pen) =>
    Pen = 3.
line_pen(visible, _, Pen) =>
    Pen = 1.

line_layer(Visibility, Role, Layer) :-
    (   sheet_role(Role)
    ->  Name = Role
    ;   atomic_list_concat([Visibility,Role], '_', Name)
    ),
    upcase_atom(Name, Layer).

%!  style_role(?Role) is nondet.
%
%   True when a style file may say how lines of Role look: those of pictures, of
%   sheets and of patterns.

style_role(Role) :-
    role_rank(Role, _).
style_role(Role) :-
    sheet_role(Role).
style_role(Role) :-
    pattern_look(Role, _, _, _, _).

%!  sheet_role(?Role) is nondet.
%
%   True when lines of Role are no lines of the model but of the sheet
%   (sheet.pl), all of them `visible`; `text` is the role of texts.

sheet_role(frame).
sheet_role(field).
sheet_role(hatching).
sheet_role(shading).
sheet_role(cutting).
sheet_role(cutting_end).
sheet_role(arrow).
sheet_role(symbol).
sheet_role(axis).
sheet_role(centre_line).
sheet_role(construction).
sheet_role(text).

:- decision(paper_style/1, "The colour of the paper").

%!  paper_style(-Colour) is det.
%
%   True when the sheet has this Colour, as in a style. A decision.

paper_style(white).

%!  line_type(?Type, +Width, -Runs) is nondet.
%
%   True when Type is a line type of ISO 128-2, and Runs are its dashes and
%   gaps for a line of Width, in the same unit. `hidden` has the dashes that
%   plotters had for hidden lines, 3 mm and 0.9 mm whatever the width.

line_type(Type, Width, Runs) :-
    type_runs(Type, Runs0),
    maplist(times(Width), Runs0, Runs).
line_type(hidden, _, [3.0,0.9]).

times(Width, N, Run) :-
    Run is N*Width.

%   In widths of the line.

type_runs(dashed,             [12,3]).
type_runs(dashed_spaced,      [12,18]).
type_runs(chain,              [24,3,0.5,3]).
type_runs(chain_double,       [24,3,0.5,3,0.5,3]).
type_runs(chain_triple,       [24,3,0.5,3,0.5,3,0.5,3]).
type_runs(dotted,             [0.5,3]).
type_runs(chain_dashed,       [24,3,6,3]).
type_runs(dashed_dotted,      [12,3,0.5,3]).

%!  layer_name(+Layer) is semidet.
%
%   True when Layer is an atom that DXF R12 takes as the name of a layer.

layer_name(Layer) :-
    atom(Layer),
    atom_length(Layer, N),
    N > 0,
    N =< 31,
    forall(sub_atom(Layer, _, 1, _, Char), layer_char(Char)).

layer_char(Char) :-
    char_code(Char, Code),
    Code < 128,
    (   char_type(Char, alnum)
    ;   memberchk(Char, ['_','-','$'])
    ),
    !.
