:- module(sg_drawing_shading,
          [ shading_taken/3,            % +Roots, +Matrix, -Shading
            shaded_view/5,              % +Shading, +Shade, +Place, +Away,
                                        % -Shaded
            shading_strokes/2,          % +Shaded, -Strokes
            page_images/4,              % +Options, +Sheet, +Paper, -Images
            shading_images/5            % +Shadeds, +Sheet, +Dots, +Background,
                                        % -Images
          ]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../kernel', [image_strokes/7, view_range/5]).
:- use_module('../picture/view', [current_view/4]).
:- use_module('../shading/group_owner', [owners_asked/2]).
:- use_module('../shading/shaded_picture',
              [looks_for_kernel/3, picture_image/5]).
:- use_module('../shading/shading_scene',
              [ scene_handle/2, shaded_box/3, shaded_model/3, shaded_scene/5,
                without_picture/2 ]).
:- use_module('../shading/surface_look', [scene_looks/4]).
:- use_module('../store',
              [ assert_fact/1, facts_snapshot/1, retractall_facts/1, segment/3
              ]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2, reverse/2]).
:- use_module(library(option), [option/3]).
/** <module> Shading under the lines of a drawing.

What is shaded are the trees of the roots (rules/shading/), in the frame of the
lines: either dots, or, for a pen, strokes where it is dark: scan lines in three
directions, each for tones of its own.

    shading(Model, Looks, Leaves, Segments)
                                        taken before operands are put aside
    shaded(Model, Eye, Place, KernelLooks, Leaves, Segments)
                                        of one view; Place as of placed_part/3

Segments are the facts segment/3 as they were then, for rules that are asked
while it is shaded; [] if there are none.
*/

%   Between strokes, in thousandths of a millimetre; how many of these are a dot
%   of the scene; and which direction is for what is darker than which tone.

stroke_spacing(1200).
thousandths_of_dot(100).

stroke_way(45, 0.75).
stroke_way(135, 0.5).
stroke_way(0, 0.3).

way_parts(0, 1.0, 0.0).
way_parts(45, H, H) :-
    H is sqrt(0.5).
way_parts(135, G, H) :-
    H is sqrt(0.5),
    G is -H.

%!  shading_taken(+Roots, +Matrix, -Shading) is det.
%
%   Shading is what is shown of the solids Roots, placed by Matrix, and how it
%   looks, whatever becomes of their operands.
%
%   @error as of shaded_model/3

shading_taken(Roots, Matrix, shading(Model,Looks,Leaves,Segments)) :-
    shaded_model(Roots, Matrix, Model),
    without_picture(Model, Scene),
    scene_looks(Scene, root, Looks, Leaves),
    (   decision_is_default(owner/3)
    ->  Segments = []
    ;   findall(segment(S,Kind,Term), segment(S, Kind, Term), Segments)
    ).

%   with_segments(Segments, :Goal): Goal, once, with these as they were.

:- meta_predicate with_segments(+, 0).

with_segments([], Goal) :-
    !,
    once(Goal).
with_segments(Segments, Goal) :-
    facts_snapshot(( maplist(segment_back, Segments), Goal )).

segment_back(Segment) :-
    Segment = segment(S,_,_),
    (   call(Segment)
    ->  true
    ;   retractall_facts(segment(S,_,_)),
        assert_fact(Segment)
    ).

%!  shaded_view(+Shading, +Shade, +Place, +Away, -Shaded) is det.
%
%   Shaded is Shading in the view of the current world, on a sheet by Place. The
%   world has been moved from Away, [X,Y,Z], to the origin.

shaded_view(shading(Model,Looks,Leaves,Segments), Shade0, Place, Away,
            shaded(Model,at(Eye,Away),Place,KernelLooks,Leaves,Segments)) :-
    current_view(Theta, Phi, Rho, Kind),
    (   Kind == central
    ->  view_range(Theta, Phi, Near, _, _),
        Nearest is Near+Rho             % of the lines
    ;   Nearest = 1.0
    ),
    Eye = eye(Theta,Phi,Rho,Kind,Nearest),
    (   Shade0 == hatch
    ->  Shade = lambert
    ;   Shade = Shade0
    ),
    looks_for_kernel(Looks, [shade(Shade)], KernelLooks).

                /*******************************
                *            STROKES           *
                *******************************/

%!  shading_strokes(+Shaded, -Strokes) is det.
%
%   Strokes (stroke.pl) of role `shading` are for a pen: there to and fro, way
%   after way.

shading_strokes(Shaded, Strokes) :-
    findall(Own,
            ( stroke_way(Degrees, Tone),
              way_strokes(Shaded, Degrees, Tone, Own) ),
            All),
    append(All, Strokes).

way_strokes(shaded(Model,Eye,Place,Looks,Leaves,Segments), Degrees, Tone,
            Strokes) :-
    way_parts(Degrees, Cos, Sin),
    Turned = rolled(Eye,Cos,Sin),
    shaded_box(Model, Turned, b(X1,Y1,X2,Y2)),
    !,
    Place = place(PerUnit,_,_,_,_),
    thousandths_of_dot(Dot),
    stroke_spacing(Spacing),
    Scale is PerUnit/Dot,
    Apart is Spacing/Dot,
    Step is Spacing/PerUnit,
    Top is ceiling(Y2/Step)*Step,       % lines of all views go on in each other
    Width is max(1, ceiling((X2-X1)*Scale)),
    Height is max(1, ceiling((Top-Y1)*Scale)),
    shaded_scene(Model, Turned, place(Scale,X1,Top), Width-Height, Scene),
    scene_handle(Scene, Handle),
    with_segments(Segments,
                  owners_asked(Scene,
                               image_strokes(Handle, Tone, Looks, Leaves, Apart,
                                             Apart, Lines))),
    sheet_strokes(Lines, none, right,
                  at(Place,Cos,Sin,X1,Top,Scale), Strokes).
way_strokes(_, _, _, []).

%   sheet_strokes(Lines, Y, Way, At, Strokes): each line the other way round
%   than the one before it.

sheet_strokes([], _, _, _, []).
sheet_strokes(Lines, _, Way, At, Strokes) :-
    Lines = [stroke(Y,_,_)|_],
    one_line(Lines, Y, Own0, Rest),
    (   Way == right
    ->  Own = Own0,
        Next = left
    ;   reverse(Own0, Own),
        Next = right
    ),
    findall(Stroke, ( member(Line, Own), sheet_stroke(At, Way, Line, Stroke) ),
            Here),
    append(Here, Strokes1, Strokes),
    sheet_strokes(Rest, Y, Next, At, Strokes1).

one_line([Line|Lines], Y, [Line|Own], Rest) :-
    Line = stroke(Y,_,_),
    !,
    one_line(Lines, Y, Own, Rest).
one_line(Rest, _, [], Rest).

sheet_stroke(At, Way, stroke(Y,X1,X2),
             stroke(visible,shading,0,[],[From,To],joint,joint)) :-
    sheet_point(At, X1, Y, A),
    sheet_point(At, X2, Y, B),
    A \== B,
    (   Way == right
    ->  From-To = A-B
    ;   From-To = B-A
    ).

sheet_point(at(place(PerUnit,X0,Y0,Left,Top),Cos,Sin,XL,YT,Scale), X, Y, A-B) :-
    X1 is XL + X/Scale,
    Y1 is YT - Y/Scale,
    A is round((Cos*X1 - Sin*Y1 - X0)*PerUnit + Left),
    B is round((Y0 - Sin*X1 - Cos*Y1)*PerUnit + Top).


                /*******************************
                *             DOTS             *
                *******************************/

%!  shading_images(+Shadeds, +Sheet, +Dots, +Background, -Images) is det.
%
%   Images are image(X, Y, W, H, Image), in thousandths of a millimetre from the
%   upper left corner of the Sheet (sheet.pl): each of Shadeds, as far as it
%   lies on the sheet, Dots to a millimetre. Background is a colour, or `none`:
%   clear.

shading_images(Shadeds, Sheet, Dots, Background, Images) :-
    findall(Image,
            ( member(Shaded, Shadeds),
              shading_image(Shaded, Sheet, Dots, Background, Image) ),
            Images).

%!  page_images(+Options, +Sheet, +Paper, -Images) is det.
%
%   Images are those of a page of PDF or PostScript: Options as for
%   write_drawing/2, Paper the colour of the Sheet. In whole
%   thousandths.

page_images(Options, Sheet, Paper, Images) :-
    option(shading(Shadeds), Options, []),
    option(dots(Dots), Options, 8),
    shading_images(Shadeds, Sheet, Dots, Paper, Images0),
    maplist(numbers_texts, Images0, Images).

numbers_texts(image(X0,Y0,W0,H0,Image), image(X,Y,W,H,Image)) :-
    maplist(whole, [X0,Y0,W0,H0], [X,Y,W,H]).

whole(X, N) :-
    N is round(X).

%   Whole dots of the sheet, so that pictures of one sheet have one grid.

shading_image(shaded(Model,Eye,Place,Looks,Leaves,Segments),
              sheet(Wide,High,_), Dots, Background, image(X,Y,W,H,Image)) :-
    shaded_box(Model, Eye, b(X1,Y1,X2,Y2)),
    Place = place(PerUnit,X0,Y0,Left,Top),
    A is max(0, floor(((X1-X0)*PerUnit + Left)*Dots/1000)),
    B is max(0, floor(((Y0-Y2)*PerUnit + Top)*Dots/1000)),
    C is min(ceiling(Wide*Dots/1000),
             ceiling(((X2-X0)*PerUnit + Left)*Dots/1000)),
    D is min(ceiling(High*Dots/1000),
             ceiling(((Y0-Y1)*PerUnit + Top)*Dots/1000)),
    Width is C-A,
    Height is D-B,
    Width > 0,
    Height > 0,
    X is A*1000/Dots,
    Y is B*1000/Dots,
    W is Width*1000/Dots,
    H is Height*1000/Dots,
    Scale is PerUnit*Dots/1000,
    XL is X0 + (X-Left)/PerUnit,
    YT is Y0 + (Top-Y)/PerUnit,
    shaded_scene(Model, Eye, place(Scale,XL,YT), Width-Height, Scene),
    with_segments(Segments,
                  picture_image(Scene, Looks, Leaves, [background(Background)],
                                Image)).
