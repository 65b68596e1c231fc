:- module(sg_cutaway,
          [ cutaway/5,                  % +Text, +Lines, :Named, +Options,
                                        % -Cutaway
            cutaway_drawing/5           % +Text, +Eye, +Options, +Lines,
                                        % -Drawing
          ]).
:- use_module('../picture/picture_cut', [pieces_cut/1, sewn_cut/1]).
:- use_module('../picture/section', [model_box/1, section_plane/3]).
:- use_module('../picture/sew', [borders_sewn/1]).
:- use_module('../picture/view',
              [current_view/4, project_world/0, set_projection/1]).
:- use_module(seen_stroke, [region_millimetres/3, seen_strokes/5]).
:- use_module(sheet, [sheet_place/5]).
:- use_module(sheet_marks, [hatching/2]).
:- use_module(sheet_plan, []).
:- use_module(sheet_view, [section_seen/6, view_seen/4]).
:- use_module('../store', [screen/5]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [exclude/3, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3]).
:- use_module(library(option), [option/2]).
/** <module> A cutaway: the model cut open, seen from anywhere.

The picture stays where it is when the plane is moved, for its place is that of
the whole model.
*/

:- meta_predicate cutaway(+, +, 2, +, -).

%!  cutaway(+Text, +Lines, :Named, +Options, -Cutaway) is semidet.
%
%   Cutaway is cutaway(Sheet, Place, Strokes, Cut, Left): what the eye of the
%   current world sees in parallel projection when all above the plane of Text,
%   see section_plane/3, is taken away. Segments are roots that have not cut
%   each other. Cut is cut(Plane, Axis, Box), Box that of the model. Left is
%   what is left: `part`, `whole` or `nothing`. Lines and Named are those of
%   section_seen/6; Named is not called where all is left. Options are those of
%   picture/1, penetrate/2 and sheet_drawing/3. The world is changed. Fails if
%   Text is no plane or there is no model.

cutaway(Text, Lines, Named, Options,
        cutaway(Sheet,Place,Strokes,cut(Plane,Axis,Box),Left)) :-
    borders_sewn(_),
    model_box(Box),
    section_plane(Text, Plane, Axis),
    set_projection(parallel),
    screen_box(ScreenBox),
    sheet_place(ScreenBox, 210-148, Options, Sheet, Place),
    current_view(Theta, Phi, _, _),
    (   section_seen(view(section,Theta,Phi,section(Plane,none,Text)), Lines,
                     pieces_cut(Options), Named, Options, Seen0)
    ->  Left = part,
        Seen = Seen0
    ;   below(Plane, Box)
    ->  Left = whole,
        sewn_cut(Options),
        view_seen(view(section,Theta,Phi,pictorial), Lines, Options, Seen)
    ;   Left = nothing,
        Seen = seen(none,[],[],[])
    ),
    seen_drawn(Sheet, Place, Options, Seen, Strokes).

%!  cutaway_drawing(+Text, +Eye:list, +Options, +Lines, -Drawing) is det.
%
%   Drawing (sheet.pl) is the cutaway that the others say, after the goals of
%   Eye were called; its edges have the numbers of what is left. The world is
%   changed.

cutaway_drawing(Text, Eye, Options, Lines,
                drawing(Sheet,[view('',Strokes,[])])) :-
    maplist(call, Eye),
    (   cutaway(Text, Lines, maplist(sg_sheet_plan:as_left), Options,
                cutaway(Sheet,_,Strokes,_,_))
    ->  true
    ;   sheet_place(box(0,0,0,0), 210-148, Options, Sheet, _),
        Strokes = []                    % all segments are empty
    ),
    (   Strokes == []
    ->  print_message(informational, sanggwan(nothing_drawn))
    ;   true
    ).

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

%   below(Plane, Box): no corner of Box is above Plane, which does not cut it.

below(plane(A,B,C,D), box(X1,Y1,Z1,X2,Y2,Z2)) :-
    A*(X1+X2) + B*(Y1+Y2) + C*(Z1+Z2) + 2*D =< 0.

seen_drawn(sheet(_,_,PerUnit), Place, Options, Seen0, Strokes) :-
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
