:- module(sg_port_cut,
          [ cut_picture/4               % +Cut, +Options, -Picture, -Names
          ]).
:- use_module('../csg/csg_roots',
              [operand_lines/1, roots_alone/0, with_operand_lines/2]).
:- use_module('../gluing/exploded', [cells_exploded/1]).
:- use_module('../picture/hidden_lines', [picture/1]).
:- use_module('../picture/picture_cut', [segments_cut/1]).
:- use_module('../picture/view', [turn_up/1]).
:- use_module('../sheet/cutaway', [cutaway/5]).
:- use_module('../sheet/sheet', [sheet_strokes/5]).
:- use_module('../store', [segment/3]).
:- use_module(section_name, [parts_named/3]).
:- use_module(library(lists), [memberchk/2]).
:- use_module(library(option), [select_option/4]).
/** <module> A port that shows the model cut open, or taken apart.
*/

%!  cut_picture(+Cut, +Options, -Picture, -Names) is det.
%
%   Picture is cut(Sheet, Place, Strokes, About) of the current world, as it was
%   loaded, which may be changed. Cut is section(Text), see section_plane/3, or
%   explode(Factor), see cells_exploded/1. Options are those of picture/1 and
%   sheet_drawing/3, and up(Axis). About is a dict for the reply. The edges of
%   Strokes are those of Names (section_name.pl), which is `same` if they are
%   those of the model.
%
%   @error request_error(bad_key(section, section))

cut_picture(Cut, Options0, Picture, Names) :-
    select_option(up(Axis), Options0, Options, z),
    operand_lines(Lines),
    roots_alone,
    turn_up(Axis),
    cut_picture(Cut, Lines, Options, Picture, Names).

cut_picture(explode(Factor), Lines, Options,
            cut(Sheet, Place, Strokes, _{ parts:Parts }), same) :-
    findall(S, segment(S, _, _), Before),
    (   segment(_, cells, _)
    ->  cells_exploded(Factor)
    ;   segments_cut([])
    ),
    findall([N,S],
            ( segment(N, _, region(S, _)), \+ memberchk(N, Before) ),
            Parts),
    with_operand_lines(Lines, picture(Options)),
    sheet_strokes(210-148, Options, Sheet, Place, Strokes).
cut_picture(section(Text), Lines, Options,
            cut(Sheet, Place, Strokes, _{ section:About }), Names) :-
    (   cutaway(Text, Lines, parts_named(Names0), Options,
                cutaway(Sheet,Place,Strokes,Cut,Left))
    ->  true
    ;   throw(error(request_error(bad_key(section, section)), _))
    ),
    section_about(Cut, About),
    (   Left == part
    ->  Names = Names0
    ;   Names = same
    ).

%   section_about(Cut, About): where the plane is, and how far it may be pulled.

section_about(cut(plane(_,_,_,D),Axis,box(X1,Y1,Z1,X2,Y2,Z2)),
              _{ axis:Axis, at:At, low:Low, high:High }) :-
    memberchk(Axis-Low-High-Sign, [x-X1-X2-(-1), y-Y1-Y2-1, z-Z1-Z2-(-1)]),
    !,
    At is Sign*D.
section_about(_, _{ axis:null }).
