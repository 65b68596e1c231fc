/* Lines where other faces begin, also behind what is see-through. */
% covers: shaded_picture
:- module(test_face_edges, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(kernel)).
:- use_module(shaded_model).

:- begin_tests(face_edges).

% A piece of a torus, behind which on some lines another piece of it would be if
% it were there: no line is in its face.
test(no_line_in_a_face, Black == []) :-
    in_model("segment(1, solid, intersection([torus(radius(3),tube(1)),
                  at([translate(-0.6,-9,-9)], box(size(1.2,18,18)))])).
              view(270, 80, 0).",
             shaded_dots([size(60-100),window(b(-0.3,-1,0.3,0)),edges(true),
                          smooth(1)], Dots)),
    findall(Column-Row,
            ( member(Column, [10,30,50]),
              between(1, 98, Row),
              I is Row*60+Column+1,
              arg(I, Dots, rgb(R,G,B)),
              R+G+B < 60 ),
            Black).

%   A pane of glass before a block, from the front; the right side of the block
%   is in the middle of column 60.
pane("segment(1, solid, at([translate(0,-3,0.2)], box(size(3.4,0.2,3.4)))).
      segment(2, solid, at([translate(0,0,1)], box(size(2,2,2)))).
      look(1, opacity(0.5)). look(2, colour(red)). view(270, 90, 0).").

pane_dots(Options, Dots) :-
    pane(Text),
    in_model(Text, shaded_dots([size(80-80),window(b(-2.025,0,1.975,4)),
                                smooth(1),shade(flat)|Options], Dots)).

%   Parts are of the light that Columns of row 30, from 0, have without lines.
parts_of_light(Columns, Parts) :-
    pane_dots([], Without),
    pane_dots([edges(true)], With),
    findall(Part,
            ( member(Column, Columns),
              light_at(Without, Column, L0),
              light_at(With, Column, L1),
              Part is float(L1/L0) ),
            Parts).

light_at(Dots, Column, Light) :-
    I is 30*80+Column+1,
    arg(I, Dots, rgb(R,_,_)),
    srgb_light(R, Light).

% Half of the light goes on behind each of the two sides of the pane.
test(behind_glass, true(abs(Part-0.75) < 0.01)) :-
    parts_of_light([60], [Part]).
test(of_glass, Parts == [0.0]) :-
    parts_of_light([6], Parts).
test(in_glass, Parts == [1.0,1.0,1.0]) :-
    parts_of_light([22,40,65], Parts).

% Light that hardly comes through changes no line: those of what is opaque.
test(nearly_opaque, true(Most =< 2)) :-
    ring_levels(1, Levels1),
    ring_levels(0.9999, Levels2),
    foldl(most_apart, Levels1, Levels2, 0, Most).

ring_levels(Opacity, Levels) :-
    format(string(Text),
           "segment(1, solid, difference([box(size(4,4,2)), 2])).
            segment(2, solid, cylinder(radius(1), height(8), facets(48))).
            segment(3, solid, at([translate(0,0,2)],
                                 torus(radius(1.5),tube(0.3)))).
            view(300, 65, 0). look(3, opacity(~w)).", [Opacity]),
    in_model(Text, shaded_bytes([size(200-150),edges(true),smooth(1)], Bytes)),
    string_codes(Bytes, Levels).

most_apart(A, B, Most0, Most) :-
    Most is max(Most0, abs(A-B)).

:- end_tests(face_edges).
