:- module(sg_port_cut,
          [ cut_picture/4               % +Cut, +Options, -Picture, -Names
          ]).
:- use_module('../csg/csg_roots',
              [operand_lines/1, roots_alone/0, with_operand_lines/2]).
:- use_module('../gluing/exploded', [cells_exploded/1]).
:- use_module('../picture/hidden_lines', [picture/1]).
:- use_module('../picture/picture_cut', [pieces_cut/1, sewn_cut/1]).
:- use_module('../picture/section', [model_box/1, section_plane/3]).
:- use_module('../picture/sew', [borders_sewn/1]).
:- use_module('../picture/view',
              [ current_view/4, project_world/0, set_projection/1, turn_up/1 ]).
:- use_module('../sheet/seen_stroke', [region_millimetres/3, seen_strokes/5]).
:- use_module('../sheet/sheet', [sheet_place/5, sheet_strokes/5]).
:- use_module('../sheet/sheet_marks', [hatching/2]).
:- use_module('../sheet/sheet_view', [section_seen/6, view_seen/4]).
:- use_module('../store', [screen/5, segment/3]).
:- use_module(section_name, [parts_named/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [exclude/3, maplist/3]).
:- use_module(library(lists), [append/3, memberchk/2]).
:- use_module(library(option), [option/2, select_option/4]).
/** <module> A port that shows the model cut open, or taken apart.

The plane of a section may be looked at from anywhere, and pulled: the picture
stays where it is, for its place is that of the whole model.
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
    ;   sewn_cut_all
    ),
    findall([N,S],
            ( segment(N, _, region(S, _)), \+ memberchk(N, Before) ),
            Parts),
    with_operand_lines(Lines, picture(Options)),
    sheet_strokes(210-148, Options, Sheet, Place, Strokes).
cut_picture(section(Text), Lines, Options,
            cut(Sheet, Place, Strokes, _{ section:About }), Names) :-
    borders_sewn(_),
    (   model_box(Box),
        section_plane(Text, Plane, Axis)
    ->  true
    ;   throw(error(request_error(bad_key(section, section)), _))
    ),
    section_about(Plane, Axis, Box, About),
    set_projection(parallel),
    screen_box(ScreenBox),
    sheet_place(ScreenBox, 210-148, Options, Sheet, Place),
    (   seen(Plane, Text, Box, Lines, Options, Seen, Names)
    ->  section_drawn(Sheet, Place, Options, Seen, Strokes)
    ;   Strokes = [],
        Names = same
    ).

sewn_cut_all :-
    borders_sewn(_),
    sewn_cut([]).

%   section_about(Plane, Axis, Box, About): where the plane is, and how far it
%   may be pulled.

section_about(plane(_,_,_,D), Axis, box(X1,Y1,Z1,X2,Y2,Z2),
              _{ axis:Axis, at:At, low:Low, high:High }) :-
    memberchk(Axis-Low-High-Sign, [x-X1-X2-(-1), y-Y1-Y2-1, z-Z1-Z2-(-1)]),
    !,
    At is Sign*D.
section_about(_, _, _, _{ axis:null }).

%   screen_box(Box): of all that the eye sees of the whole model.

screen_box(box(X,Y,HalfW,HalfH)) :-
    project_world,
    aggregate_all(r(min(U), max(U), min(V), max(V)),
                  screen(_, _, U, V, _),
                  r(X1, X2, Y1, Y2)),
    X is (X1+X2)/2,
    Y is (Y1+Y2)/2,
    HalfW is (X2-X1)/2,
    HalfH is (Y2-Y1)/2.

%   seen(Plane, Text, Box, Lines, Options, Seen, Names): fails if all is above
%   the plane; if all is below, Seen is the whole model.

seen(Plane, Text, Box, Lines, Options, Seen, Names) :-
    current_view(Theta, Phi, _, _),
    (   section_seen(view(section,Theta,Phi,section(Plane,none,Text)), Lines,
                     pieces_cut([]), parts_named(Names0), Options, Seen0)
    ->  Seen = Seen0,
        Names = Names0
    ;   below(Plane, Box),
        sewn_cut([]),
        view_seen(view(section,Theta,Phi,pictorial), Lines, Options, Seen),
        Names = same
    ).

%   below(Plane, Box): no corner of Box is above Plane, which does not cut it.

below(plane(A,B,C,D), box(X1,Y1,Z1,X2,Y2,Z2)) :-
    A*(X1+X2) + B*(Y1+Y2) + C*(Z1+Z2) + 2*D =< 0.

section_drawn(sheet(_,_,PerUnit), Place, Options, Seen0, Strokes) :-
    Seen0 = seen(View, Parts0, Regions, Centres),
    (   option(hidden(removed), Options)
    ->  exclude(hidden_part, Parts0, Parts)
    ;   Parts = Parts0
    ),
    maplist(region_millimetres(PerUnit), Regions, Sized),
    hatching(Sized, Hatching),
    seen_strokes(Place, Hatching, seen(View,Parts,Regions,Centres), Own,
                 Hatched),
    append(Hatched, Own, Strokes).

hidden_part(part(hidden,_,_,_,_,_,_,_)).
