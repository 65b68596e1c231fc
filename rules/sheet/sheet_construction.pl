:- module(sg_sheet_construction,
          [ centre_views/6,             % +Celled, +Marking, +Blank, +PerUnit,
                                        % +Places, -Views
            centres_added/4,            % +Centres, +Place, +Drawing0, -Drawing
            construction_view/7,        % +Request, +PerUnit, +Places, +Centres,
                                        % +Drawn, -Views, -Texts
            view_interrupted/3,         % +Texts, +View0, -View
            item_place/5                % +Name, +P, +PerUnit, +Places, -Point
          ]).
:- use_module('../near', [is_on_surface/2]).
:- use_module(lettering, [lettering_width/3]).
:- use_module(point_text, [point_texts/4]).
:- use_module(sheet_marks, [plane_line/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2, reverse/2]).
:- use_module(library(option), [option/2]).
/** <module> Construction lines and centre lines on a sheet.

The items are those of seen_drawing/3 (sheet_plan.pl). Views and strokes are as
in sheet.pl, thousandths of a millimetre, y down; Places are those of
sheet_layout.pl, PerUnit millimetres of a unit of the picture.
*/

%!  centre_views(+Celled, +Marking, +Blank, +PerUnit, +Places, -Views) is det.
%
%   Views has the centre lines of the views Celled, cell(Seen, Box, Cell), but
%   not of those called one of Blank; it is [] if there are none. One that lies
%   where its view shows the plane of a section, as Marking has it
%   (sheet_plan.pl), is not drawn: both are chain lines.

centre_views(Celled, Marking, Blank, PerUnit, Places, Views) :-
    findall(stroke(visible,centre_line,0,[],Points,End,End),
            ( member(cell(seen(View,_,_,Centres),_,_), Celled),
              View = view(Name, _, _, _),
              \+ memberchk(Name, Blank),
              member(centre(Points0,End), Centres),
              \+ ( member(Section-Name, Marking),
                   in_plane(View, Section, Points0) ),
              maplist(view_place(Name, PerUnit, Places), Points0, Points1),
              centre_points(End, Points1, Points) ),
            Strokes),
    (   Strokes == []
    ->  Views = []
    ;   Views = [view(centre_lines,Strokes,[])]
    ).

%!  centres_added(+Centres, +Place, +Drawing0, -Drawing) is det.
%
%   Drawing is Drawing0, a picture laid on a sheet by Place (placed_part/3),
%   with Centres, centre(Points, End) in the picture's own coordinates, under
%   it.

centres_added(Centres, place(Scale,X0,Y0,Left,Top), drawing(Sheet,Views0),
              drawing(Sheet,Views)) :-
    findall(stroke(visible,centre_line,0,[],Points,End,End),
            ( member(centre(Points0,End), Centres),
              findall(X-Y,
                      ( member(U-V, Points0),
                        X is round((U-X0)*Scale + Left),
                        Y is round((Y0-V)*Scale + Top) ),
                      Points1),
              centre_points(End, Points1, Points) ),
            Strokes),
    (   Strokes == []
    ->  Views = Views0
    ;   Views = [view(centre_lines,Strokes,[])|Views0]
    ).

in_plane(View, Section, [X1-Y1,X2-Y2]) :-
    plane_line(View, Section, line(U,V,At)),
    Size is abs(X2-X1) + abs(Y2-Y1),
    is_on_surface(U*X1+V*Y1+At, Size),
    is_on_surface(U*X2+V*Y2+At, Size).

in_plane(View, Section, [X1-Y1,X2-Y2]) :-
    plane_line(View, Section, line(U,V,At)),
    Size is abs(X2-X1) + abs(Y2-Y1),
    is_on_surface(U*X1+V*Y1+At, Size),
    is_on_surface(U*X2+V*Y2+At, Size).

view_place(Name, PerUnit, Places, P, Point) :-
    item_place(Name, P, PerUnit, Places, Point).

centre_points(ring, Points, Points).
centre_points(joint, Points0, Points) :-
    longer_there(Points0, Points1),
    reverse(Points1, Points2),
    longer_there(Points2, Points3),
    reverse(Points3, Points).

longer_there([X1-Y1,X2-Y2|Points], [X-Y,X2-Y2|Points]) :-
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    Length > 0,
    centre_beyond(Far),
    X is round(X1 - Far*(X2-X1)/Length),
    Y is round(Y1 - Far*(Y2-Y1)/Length).

%   Thousandths of a millimetre.

centre_beyond(3000).

%!  construction_view(+Request, +PerUnit, +Places, +Centres, +Drawn, -Views,
%!                    -Texts) is det.
%
%   Views has the construction lines of Request, or is []. Centres and Drawn are
%   the other views of the sheet: Texts, those beside points, stand where there
%   is room.

construction_view(Request, PerUnit, Places, Centres, Drawn, Views,
                  Texts) :-
    (   option(construction(Items), Request),
        Items = [_|_]
    ->  findall(Stroke,
                ( member(Item, Items),
                  item_stroke(Item, PerUnit, Places, Stroke) ),
                Strokes0),
        findall(point(Name,Point,String),
                ( member(dot(Name,P,Word), Items),
                  item_place(Name, P, PerUnit, Places, Point),
                  atom_string(Word, String) ),
                Points),
        drawn_shapes(Drawn, Shapes),
        stroke_shapes(Strokes0, Lights1),
        drawn_shapes(Centres, Lights2),
        append(Lights1, Lights2, Lights),
        point_texts(Shapes, Lights, Points, Placed),
        findall(Text, member(placed(Text,_), Placed), Texts),
        findall(Stroke,
                ( member(placed(_,Line), Placed),
                  Line = [_,_],
                  light_stroke(Line, joint, Stroke) ),
                Strokes1),
        append(Strokes0, Strokes1, Strokes),
        view_interrupted(Texts, view(construction,Strokes,Texts), View),
        Views = [View]
    ;   Views = [],
        Texts = []
    ).

%!  view_interrupted(+Texts, +View0, -View) is det.
%
%   In View the straight lines of View0, light ones, leave room for Texts, which
%   may stand on them.

view_interrupted(Texts, view(Name,Strokes0,Own), view(Name,Strokes,Own)) :-
    findall(rect(X1,Y1,X2,Y2),
            ( member(Text, Texts),
              text_shape(Text, [Left-Top,_,Right-Bottom,_]),
              X1 is Left-300,
              Y1 is Top-300,
              X2 is Right+300,
              Y2 is Bottom+300 ),
            Rectangles),
    findall(Stroke,
            ( member(Stroke0, Strokes0),
              stroke_interrupted(Rectangles, Stroke0, Stroke) ),
            Strokes).

%   stroke_interrupted(Rectangles, Stroke0, Stroke) is nondet: what is left of a
%   straight Stroke0; others stay.

stroke_interrupted(Rectangles, Stroke0, Stroke) :-
    Stroke0 = stroke(Visibility,Role,S,Edges,[A,B],_,_),
    !,
    findall(From-To,
            ( member(Rectangle, Rectangles),
              covered(Rectangle, A, B, From, To) ),
            Covered0),
    (   Covered0 == []
    ->  Stroke = Stroke0
    ;   sort(Covered0, Covered),
        free_part(Covered, 0.0, From, To),
        part_point(A, B, From, P),
        part_point(A, B, To, Q),
        P \== Q,
        Stroke = stroke(Visibility,Role,S,Edges,[P,Q],joint,joint)
    ).
stroke_interrupted(Rectangles, stroke(Visibility,Role,S,Edges,Points,End,_),
                   Stroke) :-
    runs(Points, Rectangles, Runs),
    (   Runs = [Points]
    ->  Stroke = stroke(Visibility,Role,S,Edges,Points,End,End)
    ;   member(Run, Runs),
        stroke_interrupted(Rectangles,
                           stroke(Visibility,Role,S,Edges,Run,joint,joint),
                           Stroke)
    ).

%   runs(Points, Rectangles, Runs): the points of a line in runs: pieces that
%   are covered in part stand alone.

runs([P|Points], Rectangles, Runs) :-
    runs(Points, [P], Rectangles, Runs).

runs([], Run0, _, [Run]) :-
    reverse(Run0, Run).
runs([Q|Points], [P|Run0], Rectangles, Runs) :-
    (   member(Rectangle, Rectangles),
        covered(Rectangle, P, Q, _, _)
    ->  reverse([P|Run0], Run),
        (   Run0 == []
        ->  Runs = [[P,Q]|Runs1]
        ;   Runs = [Run,[P,Q]|Runs1]
        ),
        (   Points == []
        ->  Runs1 = []
        ;   runs(Points, [Q], Rectangles, Runs1)
        )
    ;   runs(Points, [Q,P|Run0], Rectangles, Runs)
    ).

%   covered(Rectangle, A, B, From, To): from the part From to the part To of the
%   way from A to B.

covered(rect(X1,Y1,X2,Y2), XA-YA, XB-YB, From, To) :-
    slab(XA, XB, X1, X2, F1, T1),
    slab(YA, YB, Y1, Y2, F2, T2),
    From is max(0.0, max(F1, F2)),
    To is min(1.0, min(T1, T2)),
    From < To.

slab(A, B, Low, High, From, To) :-
    (   A =:= B
    ->  A > Low,
        A < High,
        From = 0.0,
        To = 1.0
    ;   F is (Low-A)/float(B-A),
        T is (High-A)/float(B-A),
        From is min(F, T),
        To is max(F, T)
    ).

free_part([], Done, Done, 1.0) :-
    Done < 1.0.
free_part([From-_|_], Done, Done, From) :-
    From > Done.
free_part([_-To|Covered], Done0, From1, To1) :-
    Done is max(Done0, To),
    free_part(Covered, Done, From1, To1).

part_point(XA-YA, XB-YB, Part, X-Y) :-
    X is XA + round(Part*(XB-XA)),
    Y is YA + round(Part*(YB-YA)).

%   drawn_shapes(Views, Shapes): for point_texts/4.

drawn_shapes(Views, Shapes) :-
    findall(Shape,
            ( member(view(_,Strokes,Texts), Views),
              (   stroke_shapes(Strokes, Shapes0),
                  member(Shape, Shapes0)
              ;   member(Text, Texts),
                  text_shape(Text, Shape)
              ) ),
            Shapes).

stroke_shapes(Strokes, Shapes) :-
    findall([A,B],
            ( member(stroke(_,_,_,_,Points,_,_), Strokes),
              append(_, [A,B|_], Points),
              A \== B ),
            Shapes).

text_shape(text(X,Y,Height,Anchor,String),
           [Left-Top,Right-Top,Right-Y,Left-Y]) :-
    lettering_width(String, Height, Width),
    Width > 0,
    (   Anchor == start
    ->  Left = X
    ;   Anchor == middle
    ->  Left is X - Width/2
    ;   Left is X-Width
    ),
    Right is Left+Width,
    Top is Y-Height.

item_stroke(line(Name,Points0), PerUnit, Places, Stroke) :-
    findall(Point,
            ( member(P, Points0),
              item_place(Name, P, PerUnit, Places, Point) ),
            Points),
    light_stroke(Points, joint, Stroke).
item_stroke(between(Name1,P0,Name2,Q0), PerUnit, Places, Stroke) :-
    item_place(Name1, P0, PerUnit, Places, P),
    item_place(Name2, Q0, PerUnit, Places, Q),
    light_stroke([P,Q], joint, Stroke).
item_stroke(dot(Name,P0,_), PerUnit, Places, Stroke) :-
    item_place(Name, P0, PerUnit, Places, X-Y),
    findall(X1-Y1,
            ( between(0, 8, I),
              Angle is I*pi/4,
              X1 is X + round(500*cos(Angle)),
              Y1 is Y + round(500*sin(Angle)) ),
            Points),
    light_stroke(Points, ring, Stroke).

%!  item_place(+Name, +P, +PerUnit, +Places, -Point) is det.
%
%   Point of the sheet is where P, X-Y, of the picture of view Name stands.

item_place(Name, X0-Y0, PerUnit, Places, X-Y) :-
    memberchk(place(Name,XO,YO,Left,Top), Places),
    Scale is PerUnit*1000,
    X is round((X0-XO)*Scale + Left*1000),
    Y is round((YO-Y0)*Scale + Top*1000).

light_stroke(Points, End,
             stroke(visible,construction,0,[],Points,End,End)) :-
    Points = [First|_],
    \+ forall(member(Point, Points), Point == First).

