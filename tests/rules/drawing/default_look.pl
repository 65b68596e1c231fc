:- module(default_look,
          [ colour/2,                   % ?Name, ?RGB
            type/2,                     % ?Name, ?Runs
            default_look/8              % ?Visibility, ?Role, and how it looks
          ]).
/* Tables of style.pl, stated a second time, for tests. */

colour(black,   rgb(0,0,0)).
colour(white,   rgb(255,255,255)).
colour(grey,    rgb(128,128,128)).
colour(red,     rgb(170,0,0)).
colour(green,   rgb(0,110,40)).
colour(blue,    rgb(0,60,170)).
colour(cyan,    rgb(0,130,150)).
colour(magenta, rgb(150,0,120)).
colour(yellow,  rgb(250,210,0)).
colour(orange,  rgb(220,110,0)).
colour(brown,   rgb(110,60,20)).

% ISO 128-2, table 1, in widths of the line: a long dash 24, a dash 12, a
% short one 6, a dot half a width, a gap 3, a long one 18.
type(dashed,        [12,3]).
type(dashed_spaced, [12,18]).
type(chain,         [24,3,0.5,3]).
type(chain_double,  [24,3,0.5,3,0.5,3]).
type(chain_triple,  [24,3,0.5,3,0.5,3,0.5,3]).
type(dotted,        [0.5,3]).
type(chain_dashed,  [24,3,6,3]).
type(dashed_dotted, [12,3,0.5,3]).

% Visibility, role: width, colour on the screen and on paper, runs, pen, layer.
default_look(visible, penetration, 700, rgb(170,0,0), rgb(0,0,0), [], 3,
             'VISIBLE_PENETRATION').
default_look(hidden, penetration, 350, rgb(170,0,0), rgb(0,0,0), [3000,900],
             2, 'HIDDEN_PENETRATION').
default_look(visible, outline, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_OUTLINE').
default_look(hidden, outline, 250, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_OUTLINE').
default_look(visible, crease, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_CREASE').
default_look(visible, border, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_BORDER').
default_look(visible, curve, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_CURVE').
default_look(hidden, curve, 250, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_CURVE').
default_look(visible, section, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_SECTION').
default_look(visible, smooth, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_SMOOTH').
default_look(hidden, smooth, 180, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_SMOOTH').
default_look(visible, mesh, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_MESH').
default_look(hidden, mesh, 180, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_MESH').
default_look(visible, frame, 700, rgb(0,0,0), rgb(0,0,0), [], 1, 'FRAME').
default_look(visible, field, 250, rgb(0,0,0), rgb(0,0,0), [], 1, 'FIELD').
default_look(visible, hatching, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'HATCHING').
default_look(visible, cutting, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'CUTTING').
default_look(visible, cutting_end, 700, rgb(0,0,0), rgb(0,0,0), [], 1,
             'CUTTING_END').
default_look(visible, arrow, 500, rgb(0,0,0), rgb(0,0,0), [], 1, 'ARROW').
default_look(visible, symbol, 350, rgb(0,0,0), rgb(0,0,0), [], 1, 'SYMBOL').
default_look(visible, axis, 250, rgb(0,0,0), rgb(0,0,0), [], 1, 'AXIS').
default_look(visible, centre_line, 250, rgb(0,0,0), rgb(0,0,0),
             [6000,750,125,750], 1, 'CENTRE_LINE').
default_look(visible, text, 700, rgb(0,0,0), rgb(0,0,0), [], 1, 'TEXT').
% Of patterns.
default_look(visible, cut, 350, rgb(0,0,0), rgb(0,0,0), [], 1, 'CUT').
default_look(visible, fold_down, 250, rgb(0,60,170), rgb(0,0,0), [3000,1200],
             2, 'FOLD_DOWN').
default_look(visible, fold_up, 250, rgb(0,110,40), rgb(0,0,0),
             [5000,1200,500,1200], 3, 'FOLD_UP').
default_look(visible, penetration_line, 180, rgb(170,0,0), rgb(170,0,0), [],
             4, 'PENETRATION_LINE').
default_look(visible, mark, 180, rgb(0,0,0), rgb(0,0,0), [], 5, 'MARK').
default_look(visible, generator, 180, rgb(128,128,128), rgb(128,128,128), [],
             5, 'GENERATOR').
default_look(visible, generator_number, 180, rgb(128,128,128),
             rgb(128,128,128), [], 6, 'GENERATOR_NUMBER').
default_look(visible, table, 180, rgb(0,0,0), rgb(0,0,0), [], 7, 'TABLE').
default_look(visible, number, 250, rgb(0,0,0), rgb(0,0,0), [], 6, 'NUMBER').
default_look(visible, face_name, 250, rgb(128,128,128), rgb(128,128,128), [],
             6, 'FACE_NAME').
default_look(visible, angle, 180, rgb(128,128,128), rgb(128,128,128), [], 6,
             'ANGLE').
default_look(visible, bar, 250, rgb(0,0,0), rgb(0,0,0), [], 7, 'BAR').
default_look(visible, crop, 180, rgb(0,0,0), rgb(0,0,0), [], 7, 'CROP').
default_look(visible, grid, 100, rgb(190,190,190), rgb(190,190,190), [], 8,
             'GRID').
