:- module(sg_sheet,
          [ sheet_drawing/3,            % +Default, +Options, -Drawing
            sheet_strokes/5,            % +Default, +Options, -Sheet, -Place,
                                        % -Strokes
            sheet_place/5,              % +Box, +Default, +Options, -Sheet,
                                        % -Place
            scaled_drawing/3,           % +Factor, +Drawing, -Scaled
            picture_parts/1,            % -Parts
            placed_part/3               % +Place, +Part0, -Part
          ]).
:- use_module('../near', [longer/2]).
:- use_module('../picture/contour', [line_ends/4]).
:- use_module('../kernel', [drawn_box/1, drawn_strokes/6]).
:- use_module('../store', [contour/13, drawn/7]).
:- use_module(stroke, [all_strokes/2, picture_looks/1]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/3]).
:- use_module(library(error), [domain_error/2, must_be/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The sheet: the picture laid on paper.

A sheet is sheet(Width,Height,Scale): integers, thousandths of its unit (a
millimetre, or a dot of a raster), x to the right and y DOWN from the upper
left corner; Scale is how many units a unit of the picture is. Everything
after this is integer: numbers print the same everywhere, and -0 does not
exist.

What writers write is a *drawing*, which does not know the world:

    drawing(Sheet, Views)
    view(Name, Strokes, Texts)

Views in painting order. Name is an atom, '' if there is one view alone.
Strokes are as stroke.pl says, one or many; those that show no edge (frames,
hatching) have no Edges, and segment 0 if they show no segment either. Their
roles are

  - `frame`: round the sheet and the title block; centring marks
  - `field`: lines between the fields of the title block and of the frame
  - `hatching`: of the faces of a section
  - `shading`: strokes where solids are dark
  - `cutting`, `cutting_end`, `arrow`: the line of a cutting plane, its thick
    ends and corners, its arrows
  - `symbol`, `axis`: the symbol of the projection method and its axes
  - `construction`: light lines of an answer, from view to view
  - `centre_line`: the axes of what is round

The dashes of such lines are drawn already, but for centre lines. A text is

    text(X, Y, Height, Anchor, Text)

Text, a string, is Height high (capitals, in thousandths), with the start, the
middle or the end of its baseline at X,Y: Anchor is `start`, `middle` or `end`.
*/

:- set_prolog_flag(optimise, true).

%!  sheet_drawing(+Default, +Options, -Drawing) is det.
%
%   Drawing is what drawn/7 holds as one view, or what Options name with
%   drawing(Drawing). The picture fills the sheet, its aspect kept; a picture
%   without extent is a point in the middle, an empty one has no strokes. Other
%   options:
%
%     - size(Size): `W-H`, or text like `210x148`; otherwise Default, W-H
%     - margin(M): free all round; a tenth of the shorter side if not given
%     - scale(S): S units of the sheet for one of the picture, not to fit; the
%       sheet is as large as the picture needs, unless there is a size
%     - hidden(H): `dashed`, `shown` (drawn, not dashed) or `removed`
%
%   @error domain_error(sheet_size, Size), domain_error(hidden_lines, H),
%   usage_error(sheet(size(Size, Needed))): at that scale it is too small

sheet_drawing(Default, Options, Drawing) :-
    (   option(drawing(Drawing0), Options)
    ->  Drawing = Drawing0
    ;   Drawing = drawing(Sheet, [view('', Strokes, [])]),
        sheet_strokes(Default, Options, Sheet, _, Strokes)
    ).

%!  scaled_drawing(+Factor, +Drawing, -Scaled) is det.
%
%   Scaled is Drawing in another unit: Factor of it are one of Drawing's.

scaled_drawing(Factor, drawing(sheet(W0,H0,Scale0),Views0),
               drawing(sheet(W,H,Scale),Views)) :-
    maplist(scaled(Factor), [W0,H0], [W,H]),
    Scale is Scale0*Factor,
    maplist(scaled_view(Factor), Views0, Views).

scaled_view(Factor, view(Name,Strokes0,Texts0), view(Name,Strokes,Texts)) :-
    all_strokes(Strokes0, Singles),
    maplist(scaled_stroke(Factor), Singles, Strokes),
    maplist(scaled_text(Factor), Texts0, Texts).

scaled_stroke(Factor, stroke(Visibility,Role,S,Es,Points0,Start,End),
              stroke(Visibility,Role,S,Es,Points,Start,End)) :-
    maplist(scaled_point(Factor), Points0, Points).

scaled_text(Factor, text(X0,Y0,Height0,Anchor,Text),
            text(X,Y,Height,Anchor,Text)) :-
    maplist(scaled(Factor), [X0,Y0,Height0], [X,Y,Height]).

scaled_point(Factor, X0-Y0, X-Y) :-
    scaled(Factor, X0, X),
    scaled(Factor, Y0, Y).

scaled(Factor, X0, X) :-
    X is round(X0*Factor).

%!  sheet_strokes(+Default, +Options, -Sheet, -Place, -Strokes) is det.
%
%   The Sheet and the Strokes of what drawn/7 holds, as sheet_drawing/3 lays
%   them out; Place as of placed_part/3. The kernels drawn_box/1 and
%   drawn_strokes/5 do for edges what the rule does for all parts, which as
%   terms would need much room.

sheet_strokes(Default, Options, Sheet, Place, Strokes) :-
    hidden_option(Options, Hidden),
    findall(Part, contour_part(Part), Contours),
    whole_box(Contours, Box),
    sheet_place(Box, Default, Options, Sheet, Place),
    placed_parts(Hidden, Place, Contours, Placed),
    (   Hidden == removed
    ->  Removed = hidden
    ;   Removed = none
    ),
    picture_looks(Looks),
    drawn_strokes(Place, Removed, Looks, Placed, Chains, Runs),
    maplist(run_strokes(Chains), Runs, Strokes).

run_strokes(Chains, run(Visibility,Role,S,From,To),
            strokes(Visibility,Role,S,Chains,From,To)).

placed_parts(Hidden, Place, Parts, Placed) :-
    (   Hidden == removed
    ->  exclude(hidden_part, Parts, Kept)
    ;   Kept = Parts
    ),
    maplist(placed_part(Place), Kept, Placed).

%   contour_part(-Part): one that is no edge.

contour_part(Part) :-
    contour(S, K, _, _, _, _, _, _, _, _, _, _, _),
    E is -K,
    drawn_part(S, E, Part).

%!  picture_parts(-Parts) is det.
%
%   Parts are the parts (stroke.pl) that drawn/7 of the current world has,
%   their ends in the picture's own coordinates.

picture_parts(Parts) :-
    findall(Part, drawn_part(_, _, Part), Parts).

hidden_option(Options, Hidden) :-
    option(hidden(Hidden), Options, dashed),
    (   memberchk(Hidden, [dashed,removed,shown])
    ->  true
    ;   domain_error(hidden_lines, Hidden)
    ).

hidden_part(part(hidden,_,_,_,_,_,_,_)).

drawn_part(S, E, part(Visibility,Role,S,E,From,To,XA-YA,XB-YB)) :-
    drawn(_, S, E, From, To, Visibility, Role),
    line_ends(S, E, X1-Y1, X2-Y2),
    between_ends(From, X1, X2, XA),
    between_ends(From, Y1, Y2, YA),
    between_ends(To, X1, X2, XB),
    between_ends(To, Y1, Y2, YB).

%   Exact at both ends.

between_ends(At, A, B, X) :-
    (   At =:= 1.0
    ->  X = B
    ;   X is A + At*(B-A)
    ).

%   box(MiddleX,MiddleY,HalfWidth,HalfHeight) of all parts, shown or not: the
%   same model has the same scale however its hidden lines are drawn. Halves,
%   so that nothing overflows.

parts_box([], box(0.0,0.0,0.0,0.0)).
parts_box([Part|Parts], Box) :-
    Part = part(_, _, _, _, _, _, X0-Y0, _),
    foldl(boxed, [Part|Parts], b(X0,Y0,X0,Y0), Box0),
    halved(Box0, Box).

%   whole_box(Contours, Box): of the edges, and of other parts.

whole_box(Contours, Box) :-
    (   drawn_box(Box0)
    ->  foldl(boxed, Contours, Box0, Box1),
        halved(Box1, Box)
    ;   parts_box(Contours, Box)
    ).

halved(b(XLow,YLow,XHigh,YHigh), box(X,Y,HalfW,HalfH)) :-
    HalfW is XHigh/2 - XLow/2,
    HalfH is YHigh/2 - YLow/2,
    X is XLow + HalfW,
    Y is YLow + HalfH.

boxed(part(_,_,_,_,_,_,XA-YA,XB-YB), b(X0,Y0,X1,Y1), b(X2,Y2,X3,Y3)) :-
    X2 is min(X0, min(XA,XB)),
    Y2 is min(Y0, min(YA,YB)),
    X3 is max(X1, max(XA,XB)),
    Y3 is max(Y1, max(YA,YB)).

%!  sheet_place(+Box, +Default, +Options, -Sheet, -Place) is det.
%
%   Place, as of placed_part/3, is where sheet_drawing/3 with these Default and
%   Options lays a picture with this Box on the Sheet: Box is
%   box(MiddleX,MiddleY,HalfWidth,HalfHeight).

sheet_place(Box, Default, Options, sheet(Width,Height,Scale),
          place(PerUnit,X,Y,Left,Top)) :-
    Box = box(X, Y, _, _),
    sheet_size(Box, Default, Options, W, H, Scale),
    Width is round(W*1000),
    Height is round(H*1000),
    Left is W*500,
    Top is H*500,
    PerUnit is Scale*1000.

sheet_size(box(_,_,HalfW,HalfH), Default, Options, W, H, Scale) :-
    (   option(scale(Scale0), Options)
    ->  must_be(number, Scale0),
        (   Scale0 > 0
        ->  true
        ;   domain_error(positive_scale, Scale0)
        ),
        Scale is float(Scale0),
        option(margin(Margin), Options, 10),
        FitW is 2*(HalfW*Scale+Margin),
        FitH is 2*(HalfH*Scale+Margin),
        size_option(Options, FitW-FitH, W, H),
        large_enough(W-H, 2*HalfW*Scale, 2*HalfH*Scale)
    ;   size_option(Options, Default, W, H),
        margin_option(Options, W, H, Margin),
        fit(HalfW, W, Margin, ScaleW),
        fit(HalfH, H, Margin, ScaleH),
        smaller(ScaleW, ScaleH, Scale)
    ).

large_enough(W-H, Width0, Height0) :-
    Width is Width0,
    Height is Height0,
    (   \+ longer(max(Width/W, Height/H), 1)
    ->  true
    ;   throw(error(usage_error(sheet(size(W-H, Width-Height))), _))
    ).

margin_option(Options, W, H, Margin) :-
    Most is min(W,H)/10,
    option(margin(Wanted), Options, Most),
    must_be(number, Wanted),
    Margin is max(0, min(Wanted, min(W,H)/2.5)).

%   The scale that makes Half fill half the side, `any` without extent.

fit(Half, Side, Margin, Scale) :-
    (   Half < 1.0e-290
    ->  Scale = any
    ;   Scale is (Side/2-Margin)/Half
    ).

smaller(any, any, 1.0) :-
    !.
smaller(any, Scale, Scale) :-
    !.
smaller(Scale, any, Scale) :-
    !.
smaller(A, B, Scale) :-
    Scale is min(A, B).

size_option(Options, Default, W, H) :-
    option(size(Size), Options, Default),
    (   size_sides(Size, W, H),
        min(W,H) >= 0.001,
        max(W,H) =< 100 000
    ->  true
    ;   domain_error(sheet_size, Size)
    ).

size_sides(W-H, W, H) :-
    !,
    number(W),
    number(H).
size_sides(Text, W, H) :-
    ( atom(Text) ; string(Text) ),
    !,
    split_string(Text, "x", " ", [TextW,TextH]),
    catch(number_string(W, TextW), error(syntax_error(_), _), fail),
    catch(number_string(H, TextH), error(syntax_error(_), _), fail).

%!  placed_part(+Place, +Part0, -Part) is det.
%
%   Part is Part0 with its ends on the sheet. Place is place(Scale,X,Y,Left,
%   Top), in thousandths: the point X,Y of the picture comes to Left,Top.

placed_part(place(Scale,X0,Y0,Left,Top), part(Vis,Role,S,E,F,T,XA-YA,XB-YB),
            part(Vis,Role,S,E,F,T,A1-A2,B1-B2)) :-
    A1 is round((XA-X0)*Scale + Left),
    A2 is round((Y0-YA)*Scale + Top),
    B1 is round((XB-X0)*Scale + Left),
    B2 is round((Y0-YB)*Scale + Top).
