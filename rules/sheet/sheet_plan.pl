:- module(sg_sheet_plan,
          [ views_drawing/5,            % +Request, +Lines, :Cuts, -Drawing,
                                        % -Placed
            seen_drawing/3              % +Request, +Seens, -Drawing
          ]).
:- use_module(eye, [eye_view/3]).
:- use_module('../bisection', [bisection/5]).
:- use_module('../picture/section', [model_box/1, section_plane/3]).
:- use_module(seen_stroke,
              [placed_point/3, region_millimetres/3, seen_strokes/5]).
:- use_module('../csg/csg_roots', [with_operand_lines/2]).
:- use_module('../picture/operand_line', [crossing_lines/2]).
:- use_module(line_point, [line_points/2, points_seen/4]).
:- use_module(sheet_construction,
              [ centre_views/6, construction_view/7, item_place/5,
                view_interrupted/3
              ]).
:- use_module(sheet_frame, [frame/5, bare_room/3]).
:- use_module(sheet_layout, [layout/4]).
:- use_module(sheet_marks,
              [ plane_marks/6, interrupted/2, label_marks/4, marks_pads/4,
                hatching/2
              ]).
:- use_module(sheet_paper,
              [ paper_name/3, paper_size/3, standard_scale/1, scale_factor/2 ]).
:- use_module(sheet_view,
              [ section_seen/6, section_view/5, view_seen/4, view_cell/4,
                seen_box/2 ]).
:- use_module(lettering, [lettering_width/3]).
:- use_module('../store', [facts_snapshot/1]).
:- use_module(library(apply),
              [convlist/3, exclude/3, foldl/4, maplist/3, partition/4]).
:- use_module(library(lists),
              [ append/2, append/3, max_list/2, member/2, memberchk/2,
                min_list/2, nth1/3
              ]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [pairs_values/2]).
:- use_module(library(yall), [(>>)/3, (>>)/4]).
/** <module> A sheet of several views, from the model to a drawing.

What is asked for is a list:

  - paper(Width,Height): millimetres
  - views(Views): of sheet_view.pl, not sections; or eye(Eye,Target), eye.pl
  - sections(Texts): where to cut, see section_plane/3
  - angle(Angle): `first` or `third`
  - scale(Scale): N:M; `standard`, the largest one with which everything fits;
    or `fit`, as large as there is room
  - unit(U): millimetres of a unit of the model
  - frame(Bool): frame and title block
  - facts(Facts): for sheet_frame.pl
  - hidden(How): as for write_drawing/2; `usual` leaves hidden lines out of
    sections and pictorial views
  - picture(Options): for picture/1
  - points(Most): number points of penetration lines, see line_points/2
*/

:- meta_predicate views_drawing(+, +, :, -, -).

%!  views_drawing(+Request, +Lines, :Cuts, -Drawing, -Placed) is det.
%
%   Drawing (sheet.pl) shows the current world, whose segments are roots, as
%   Request says. Lines are operand_lines/1. Cuts is cuts(First,Again), goals
%   that cut the segments by each other: First for the model, Again for what is
%   left of it in a section. The world stays as it is. Placed has
%   placed(View, Place) of the pictorial views, Place as of placed_part/3.
%
%   @error usage_error(sheet(What)): section(Text), section_past(Text,Box),
%   many_sections(Most), too_large(Scale,Paper,Fitting,Papers), no_room(Paper)

views_drawing(Request, Lines, Module:cuts(First,Again), Drawing, Placed) :-
    option(views(Views0), Request),
    maplist(standing, Views0, Views),
    option(sections(Texts), Request),
    option(picture(Picture), Request),
    sections(Texts, Sections),
    maplist(cut_seen(Lines, Module:Again, Picture), Sections, SeenCut),
    facts_snapshot(( call(Module:First),
                     maplist(whole_seen(Lines, Picture), Views, SeenWhole),
                     request_points(Request, Lines, Points) )),
    append(SeenWhole, SeenCut, All),
    option(hidden(Hidden), Request),
    maplist(shown(Hidden), All, Shown),
    boxed_views(Shown, Boxed),
    warned_if_empty(Boxed),
    maplist(view_points(Hidden, Points), Shown, Dots),
    append(Dots, Items),
    sheet_laid([construction(Items)|Request], Sections, Boxed, Drawing, Placed).

%   request_points(Request, Lines, Points): those that are to have numbers, of
%   the penetration lines and of the Lines of operands.

request_points(Request, Lines, Points) :-
    (   option(points(Most), Request)
    ->  crossing_lines(Lines, Crossing),
        with_operand_lines(Crossing, line_points(Most, Points))
    ;   Points = []
    ).

%!  seen_drawing(+Request, +Seens, -Drawing) is det.
%
%   Drawing shows Seens, seen(View, Parts, [], Centres) as of view_seen/4, as
%   Request says, and what Request has besides
%
%     - construction(Items)
%     Light lines, Name being that of a view and P = X-Y a point of its picture:
%     line(Name, [P, ...]); between(Name1, P, Name2, Q), from view to view;
%     dot(Name, P, Text), a small circle with Text where there is room near it.
%     - question(Texts)
%     Lines of text in the lower left corner.
%     - blank(Names)
%     Views of which there is a frame, and nothing in it.
%
%   @error as views_drawing/5

seen_drawing(Request, Seens, Drawing) :-
    option(hidden(Hidden), Request),
    maplist(shown(Hidden), Seens, Shown),
    boxed_views(Shown, Boxed),
    warned_if_empty(Boxed),
    sheet_laid(Request, [], Boxed, Drawing, _).

whole_seen(Lines, Picture, View, Seen) :-
    view_seen(View, Lines, Picture, Seen).

standing(View0, View) :-
    (   View0 = eye(Eye, Target)
    ->  eye_view(Eye, Target, View)
    ;   View = View0
    ).

warned_if_empty(Boxed) :-
    (   Boxed == []
    ->  print_message(informational, sanggwan(nothing_drawn))
    ;   true
    ).

%   sections(Texts, Sections): views A, B, ..., a letter for each.

section_letters('ABCDEFGHJKLMNPQRSTUVWXYZ').

sections(Texts, Sections) :-
    section_letters(Letters),
    atom_length(Letters, Most),
    (   length(Texts, N),
        N > Most
    ->  sheet_error(many_sections(Most))
    ;   true
    ),
    findall(Section,
            ( nth1(I, Texts, Text), section_of(I, Text, Section) ),
            Sections).

section_of(I, Text, Section) :-
    (   section_plane(Text, Plane, Axis)
    ->  section_letters(Letters),
        B is I-1,
        sub_atom(Letters, B, 1, _, Letter),
        section_view(Letter, Plane, Axis, Text, Section)
    ;   sheet_error(section(Text))
    ).

cut_seen(Lines, Again, Picture, View, Seen) :-
    (   section_seen(View, Lines, Again, maplist(sg_sheet_plan:as_left),
                     Picture, Seen0)
    ->  Seen = Seen0
    ;   View = view(_, _, _, section(_,_,Text)),
        (   model_box(Box)
        ->  true
        ;   Box = none
        ),
        sheet_error(section_past(Text, Box))
    ).

:- public as_left/2.

%   as_left(Part0, Part): the number of its edge in what is left.

as_left(part(V,Role,S,_-E,F,T,A,B), part(V,Role,S,E,F,T,A,B)).

sheet_error(What) :-
    throw(error(usage_error(sheet(What)), _)).

%   shown(Hidden, Seen0, Seen): without the hidden lines that are not to be
%   drawn.

shown(Hidden, seen(View,Parts0,Regions,Centres),
      seen(View,Parts,Regions,Centres)) :-
    View = view(_, _, _, Kind),
    (   leaves_hidden_out(Hidden, Kind)
    ->  exclude(hidden_part, Parts0, Parts)
    ;   Parts = Parts0
    ).

leaves_hidden_out(removed, _).
leaves_hidden_out(usual, Kind) :-
    Kind \== side.

view_points(Hidden, Points, Seen, Dots) :-
    Seen = seen(view(_,_,_,Kind), _, _, _),
    (   leaves_hidden_out(Hidden, Kind)
    ->  How = removed
    ;   How = Hidden
    ),
    points_seen(How, Points, Seen, Dots).

hidden_part(part(hidden,_,_,_,_,_,_,_)).

%   boxed_views(Seen, Boxed): Seen-Box of those in which there is something.

boxed_views(All, Boxed) :-
    convlist([Seen,Seen-Box]>>seen_box(Seen, Box), All, Boxed).


                /*******************************
                *            LAYOUT            *
                *******************************/

%   sheet_laid(Request, Sections, Boxed, Drawing, Placed)

sheet_laid(Request, Sections, Boxed, Drawing, Placed) :-
    option(paper(Width,Height), Request),
    option(angle(Angle), Request),
    option(unit(Unit), Request),
    celled(Boxed, Angle, Celled),
    marking(Sections, Celled, Marking),
    sheet_room(Request, Width, Height, "", _, Room),
    option(scale(Wanted), Request),
    chosen_scale(Wanted, Request, layout_of(Celled,Marking,Unit), Room, Scale,
                 Places),
    scale_text(Scale, ScaleText),
    sheet_room(Request, Width, Height, ScaleText, FrameMarks, Room),
    scale_value(Scale, Factor),
    PerUnit is Factor*Unit,
    findall(Region, ( member(cell(seen(_,_,Regions,_),_,_), Celled),
                      member(Region0, Regions),
                      region_millimetres(PerUnit, Region0, Region) ),
            AllRegions),
    hatching(AllRegions, Hatching),
    option(blank(Blank), Request, []),
    maplist(view_drawn(PerUnit, Hatching, Marking, Places, Blank), Celled,
            Views),
    findall(placed(View,Place),
            ( member(cell(seen(View,_,_,_),_,_), Celled),
              View = view(Name,_,_,pictorial),
              view_place(Name, PerUnit, Places, Place) ),
            Placed),
    frame_view(FrameMarks, Frame),
    question_view(Request, Room, Question),
    centre_views(Celled, Marking, Blank, PerUnit, Places, Centres0),
    append([Views,Frame,Question], Drawn),
    construction_view(Request, PerUnit, Places, Centres0, Drawn, Construction,
                      Numbers),
    maplist(view_interrupted(Numbers), Centres0, Centres),
    append([Construction,Centres,Views,Frame,Question], AllViews),
    W is round(Width*1000),
    H is round(Height*1000),
    Drawing = drawing(sheet(W,H,PerUnit), AllViews).

sheet_room(Request, Width, Height, ScaleText, Marks, Room) :-
    (   option(frame(true), Request)
    ->  option(facts(Facts), Request),
        option(angle(Angle), Request),
        paper_name(Width, Height, Paper),
        atom_string(Paper, PaperText),
        frame(Width, Height,
              [scale-ScaleText,paper-PaperText,angle-Angle|Facts],
              Marks, Room0)
    ;   Marks = [],
        bare_room(Width, Height, Room0)
    ),
    question_room(Request, Height, Room0, Room).

%   question_room(Request, Height, Room0, Room): no view comes where the
%   question stands, in the lower left corner, or above the title block if that
%   is as wide as the paper.

question_room(Request, Height, room(Rectangle,Taken),
              room(Rectangle,[rect(20,Top,Right,Bottom)|Taken])) :-
    question_lines(Request, Lines),
    !,
    findall(Width,
            ( member(Line, Lines),
              text_to_string(Line, String),
              lettering_width(String, 3.5, Width) ),
            Widths),
    max_list(Widths, Widest),
    length(Lines, N),
    Right is 27+Widest,
    Lowest is Height-10,
    foldl(bottom_above(Right), Taken, Lowest, Bottom),
    Top is Bottom - 6*N - 8.
question_room(_, _, Room, Room).

%   bottom_above(Right, Taken, Bottom0, Bottom): up to Right nothing of the
%   rectangle Taken is above Bottom; y runs down.

bottom_above(Right, rect(X1,Y1,_,Y2), Bottom0, Bottom) :-
    (   X1 < Right,
        Y2 > Bottom0-10
    ->  Bottom is min(Bottom0, Y1)
    ;   Bottom = Bottom0
    ).

question_lines(Request, Lines) :-
    option(question(Lines), Request),
    Lines = [_|_].

%   celled(Boxed, Angle, Celled): cell(Seen,Box,Cell) of each; the six sides
%   choose first.

celled(Boxed, Angle, Celled) :-
    partition([seen(view(_,_,_,side),_,_,_)-_]>>true, Boxed, Sides, Others),
    foldl(cell_taken(Angle), Sides, []-Celled, Taken-Rest),
    foldl(cell_taken(Angle), Others, Taken-Rest, _-[]).

cell_taken(Angle, Seen-Box, Taken-[cell(Seen,Box,Cell)|Rest],
           [Cell|Taken]-Rest) :-
    Seen = seen(View, _, _, _),
    view_cell(View, Angle, Taken, Cell).

%   marking(Sections, Celled, Marking): in which view the plane of each section
%   is shown, Section-Name: the first that sees it edge-on.

marking(Sections, Celled, Marking) :-
    findall(Section-Name,
            ( member(Section, Sections),
              once(( member(cell(Seen,Box,_), Celled),
                     Seen = seen(View, _, _, _),
                     View = view(Name, _, _, Kind),
                     Kind \== pictorial,
                     View \== Section,
                     handy_scale(Box, Scale),
                     plane_marks(View, Section, Box, Scale, [], _) ))
            ),
            Marking).

%   handy_scale(Box, Scale): with which Box is 100 mm large.

handy_scale(box(X1,Y1,X2,Y2), Scale) :-
    Scale is 100/max(1.0e-90, max(X2-X1, Y2-Y1)).

%   view_marks(Marking, Cell, PerUnit, Marks): what is written round a view.

view_marks(Marking, cell(seen(View,_,_,_),Box,_), PerUnit, Marks) :-
    View = view(Name, _, _, Kind),
    findall(Section, member(Section-Name, Marking), Sections),
    foldl(plane_marked(View, Box, PerUnit), Sections, [], Marked),
    interrupted(Marked, Marks0),
    (   Kind = section(_, _, _)
    ->  marks_pads(Marks0, Box, PerUnit, pads(_,Above,_,_)),
        label_marks(Name, Box, Above, PerUnit, Label),
        append(Marks0, Label, Marks)
    ;   Marks = Marks0
    ).

plane_marked(View, Box, PerUnit, Section, Marks0, Marks) :-
    plane_marks(View, Section, Box, PerUnit, Marks0, Own),
    append(Marks0, Own, Marks).

label_marks(Name, box(X1,Y1,X2,Y2), Above, PerUnit, Label) :-
    Y is Y2 + Above/PerUnit,
    label_marks(Name, box(X1,Y1,X2,Y), PerUnit, Label).

sight(Marking, PerUnit, Celled, sight(Name,Cell,Box,Pads)) :-
    Celled = cell(seen(view(Name,_,_,_),_,_,_), Box, Cell),
    view_marks(Marking, Celled, PerUnit, Marks),
    marks_pads(Marks, Box, PerUnit, Pads).


                /*******************************
                *            SCALE             *
                *******************************/

%   chosen_scale(Wanted, Request, Layout, Room, Scale, Places)

chosen_scale(standard, Request, Layout, Room, Scale, Places) :-
    !,
    (   standard_scale(Scale0),
        scale_value(Scale0, Factor),
        laid_out(Layout, Room, Factor, Places0)
    ->  (   is_tiny(Layout, Factor)
        ->  print_message(warning, sanggwan(sheet_tiny(Scale0,fit))),
            chosen_scale(fit, Request, Layout, Room, Scale, Places)
        ;   Scale = Scale0,
            Places = Places0
        )
    ;   request_paper(Request, Paper),
        sheet_error(no_room(Paper))
    ).
chosen_scale(fit, Request, Layout, Room, factor(Scale), Places) :-
    !,
    (   likely_factor(Layout, Low),
        laid_out(Layout, Room, Low, _)
    ->  High is Low*2.5,
        bisection(24, fits(Layout, Room), Low, High, Scale),
        once(laid_out(Layout, Room, Scale, Places))
    ;   request_paper(Request, Paper),
        sheet_error(no_room(Paper))
    ).
chosen_scale(Scale, Request, Layout, Room, Scale, Places) :-
    scale_value(Scale, Factor),
    (   laid_out(Layout, Room, Factor, Places0)
    ->  Places = Places0,
        (   is_tiny(Layout, Factor)
        ->  print_message(warning, sanggwan(sheet_tiny(Scale,as_asked)))
        ;   true
        )
    ;   chosen_scale(standard, Request, Layout, Room, Fitting, _),
        request_paper(Request, Paper),
        larger_papers(Request, Layout, Factor, Papers),
        sheet_error(too_large(Scale, Paper, Fitting, Papers))
    ).

%   likely_factor(Layout, Factor): the standard scales, and for a model that is
%   too large or too small for them those with which its views are 0.5 mm to 2 m
%   large.

likely_factor(Layout, Factor) :-
    standard_scale(Scale),
    scale_value(Scale, Factor),
    \+ is_tiny(Layout, Factor).
likely_factor(layout_of(Celled,_,Unit), Factor) :-
    findall(Scale,
            ( member(cell(_,Box,_), Celled), handy_scale(Box, Scale) ),
            Scales),
    min_list(Scales, Handy),
    between(0, 12, Halvings),
    Factor is 20*Handy/Unit/2**Halvings.

%   is_tiny(Layout, Factor): no view is a tenth of a millimetre large, so there
%   is nothing to be seen.

is_tiny(layout_of(Celled,_,Unit), Factor) :-
    Celled \== [],
    PerUnit is Factor*Unit,
    \+ ( member(cell(_,box(X1,Y1,X2,Y2),_), Celled),
         max(X2-X1, Y2-Y1)*PerUnit >= 0.1 ).

scale_value(factor(Factor), Factor) :-
    !.
scale_value(Scale, Factor) :-
    scale_factor(Scale, Factor).

laid_out(layout_of(Celled,Marking,Unit), Room, Factor, Places) :-
    PerUnit is Factor*Unit,
    \+ ( member(cell(_,Box,_), Celled), larger_than_room(Box, PerUnit, Room) ),
    maplist(sight(Marking, PerUnit), Celled, Sights0),
    in_rows(Sights0, Sights),
    layout(Sights, Room, PerUnit, Places),
    !.

%   in_rows(Sights0, Sights): as they stand; or, where more than three stand in
%   line beside the front view, in rows (or columns) of fewer, beyond all
%   others.

in_rows(Sights, Sights).
in_rows(Sights0, Sights) :-
    findall(Way, ( member(sight(_,at(X,Y),_,_), Sights0),
                   ( Way is abs(X) ; Way is abs(Y) ) ),
            Ways),
    max_list(Ways, Longest),
    member(Most, [6,5,4,3]),
    Most < Longest,
    findall(X, ( member(sight(_,at(X,_),_,_), Sights0), X =< Most ), Xs),
    findall(Y, ( member(sight(_,at(_,Y),_,_), Sights0), Y =< Most ), Ys),
    max_list(Xs, Right),
    max_list(Ys, Below),
    maplist(folded(Most, Right, Below), Sights0, Sights).

folded(Most, Right, Below, sight(Name,Cell0,Box,Pads),
       sight(Name,Cell,Box,Pads)) :-
    (   Cell0 = at(X0,0),
        abs(X0) > Most
    ->  folded_step(X0, Most, X, Row),
        Y is Below+Row,
        Cell = at(X,Y)
    ;   Cell0 = at(0,Y0),
        abs(Y0) > Most
    ->  folded_step(Y0, Most, Y, Column),
        X is Right+Column,
        Cell = at(X,Y)
    ;   Cell = Cell0
    ).

folded_step(N0, Most, N, Row) :-
    Steps is abs(N0)-1,
    N is sign(N0)*(Steps mod Most + 1),
    Row is Steps//Most.

larger_than_room(box(X1,Y1,X2,Y2), PerUnit, room(rect(A,B,C,D),_)) :-
    (   (X2-X1)*PerUnit > C-A
    ;   (Y2-Y1)*PerUnit > D-B
    ),
    !.

fits(Layout, Room, Scale) :-
    once(laid_out(Layout, Room, Scale, _)).

request_paper(Request, Paper) :-
    option(paper(Width,Height), Request),
    paper_name(Width, Height, Paper).

%   larger_papers(Request, Layout, Factor, Papers): the smallest on which it
%   fits, in a list; none if even A0 is too small.

larger_papers(Request, Layout, Factor, Papers) :-
    option(paper(Width,Height), Request),
    (   paper_size(Name, Long, Short),
        Long > max(Width, Height),
        (   Width >= Height
        ->  W = Long, H = Short
        ;   W = Short, H = Long
        ),
        sheet_room(Request, W, H, "", _, Room),
        laid_out(Layout, Room, Factor, _)
    ->  Papers = [Name]
    ;   Papers = []
    ).

scale_text(N:M, Text) :-
    !,
    format(string(Text), '~w:~w', [N, M]).
scale_text(factor(Factor), Text) :-
    (   Factor >= 1
    ->  format(string(Text), '~4g:1', [Factor])
    ;   M is 1/Factor,
        format(string(Text), '1:~4g', [M])
    ).


                /*******************************
                *           DRAWING            *
                *******************************/

view_drawn(PerUnit, _, _, Places, Blank, cell(seen(View,_,_,_),Box,_),
           view(Name,[Stroke],[])) :-
    View = view(Name, _, _, _),
    memberchk(Name, Blank),
    !,
    Box = box(X1,Y1,X2,Y2),
    item_place(Name, X1-Y1, PerUnit, Places, Left0-Bottom0),
    item_place(Name, X2-Y2, PerUnit, Places, Right0-Top0),
    blank_margin(Margin),
    Left is Left0-Margin,
    Top is Top0-Margin,
    Right is Right0+Margin,
    Bottom is Bottom0+Margin,
    Stroke = stroke(visible,field,0,[],
                    [Left-Top,Right-Top,Right-Bottom,Left-Bottom,Left-Top],
                    ring,ring).
view_drawn(PerUnit, Hatching, Marking, Places, _, Celled,
           view(Name,Strokes,Texts)) :-
    Celled = cell(Seen, _, _),
    Seen = seen(view(Name,_,_,_), _, _, _),
    view_place(Name, PerUnit, Places, Place),
    Place = place(_,X,Y,Left1,Top1),
    seen_strokes(Place, Hatching, Seen, Own, Hatched),
    view_marks(Marking, Celled, PerUnit, Marks),
    marks_drawn(place(1000,X*PerUnit,Y*PerUnit,Left1,Top1), Marks, Lines,
                Texts),
    append([Hatched, Own, Lines], Strokes).

%   view_place(Name, PerUnit, Places, Place): Place as of placed_part/3.

view_place(Name, PerUnit, Places, place(Scale,X,Y,Left,Top)) :-
    memberchk(place(Name,X,Y,Left0,Top0), Places),
    Scale is PerUnit*1000,
    Left is Left0*1000,
    Top is Top0*1000.

%   marks_drawn(Place, Marks, Strokes, Texts): strokes of one role together.

marks_drawn(Place, Marks, Strokes, Texts) :-
    findall(Role-Stroke,
            ( member(line(Role,Points), Marks),
              line_stroke(Place, Role, Points, Stroke)
            ),
            Keyed0),
    keysort(Keyed0, Keyed),
    pairs_values(Keyed, Strokes),
    findall(Text, ( member(Mark, Marks), mark_text(Place, Mark, Text) ),
            Texts).

line_stroke(Place, Role, Points0,
            stroke(visible,Role,0,[],Points,End,End)) :-
    maplist(placed_point(Place), Points0, Points),
    Points = [First|_],
    (   append(_, [Last], Points),
        Last == First
    ->  End = ring
    ;   End = joint
    ).

mark_text(Place, text(X,Y,High,Text), Mark) :-
    mark_text(Place, text(X,Y,High,middle,Text), Mark).
mark_text(Place, text(X,Y,High0,Anchor,Text0), text(A,B,High,Anchor,Text)) :-
    placed_point(Place, X-Y, A-B),
    High is round(High0*1000),
    text_to_string(Text0, Text).

blank_margin(4000).

%   question_view(Request, Room, Views): where question_room/4 has made room.

question_view(Request, room(_, Taken), Views) :-
    (   question_lines(Request, Lines)
    ->  Taken = [rect(_,_,_,Bottom)|_],
        length(Lines, N),
        findall(text(25000,Y,3500,start,String),
                ( nth1(I, Lines, Line),
                  Y is round((Bottom-5)*1000) - (N-I)*6000,
                  text_to_string(Line, String) ),
                Texts),
        Views = [view(question,[],Texts)]
    ;   Views = []
    ).

%   frame_view(Marks, Views): y runs down in its marks.

frame_view([], []) :-
    !.
frame_view(Marks0, [view(frame,Strokes,Texts)]) :-
    maplist(upturned, Marks0, Marks),
    marks_drawn(place(1000,0,0,0,0), Marks, Strokes, Texts).

upturned(line(Role,Points0), line(Role,Points)) :-
    maplist([X-Y0,X-Y]>>(Y is -Y0), Points0, Points).
upturned(text(X,Y0,High,Anchor,Text), text(X,Y,High,Anchor,Text)) :-
    Y is -Y0.
