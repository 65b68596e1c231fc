:- module(sg_sheet_view,
          [ view_named/2,               % +Name, -View
            view_towards/3,             % +Direction, +Name, -View
            section_view/5,             % +Letter, +Plane, +Axis, +Text, -View
            view_seen/4,                % +View, +Lines, +Picture, -Seen
            section_seen/6,             % +View, +Lines, :Cut, :Named,
                                        % +Picture, -Seen
            view_cell/4,                % +View, +Angle, +Taken, -Cell
            view_centres/3,             % +View, +Picture, -Centres
            view_axes/4,                % +View, -Right, -Up, -Away
            seen_box/2                  % +Seen, -Box
          ]).
:- use_module('../csg/csg_roots', [with_operand_lines/2]).
:- use_module('../picture/hidden_lines', [picture/1]).
:- use_module('../picture/section_curve', [section_on_surfaces/2]).
:- use_module('../picture/section',
              [ cut_away/2, section_lines/3, section_edges/3,
                section_region/5
              ]).
:- use_module(centre_line, [centre_lines/3]).
:- use_module(sheet, [picture_parts/1]).
:- use_module('../store', [e/5, screen/5, segment/3, facts_snapshot/1]).
:- use_module('../picture/view',
              [ named_view/3, set_view/3, set_projection/1, eye_point/4 ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists),
              [append/3, member/2, memberchk/2, nextto/3, reverse/2, select/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
:- use_module(library(yall), [(>>)/4]).
/** <module> The views of a sheet, and what is seen in them.

    view(Name, Theta, Phi, Kind)
    Kind    side, one of the six; pictorial; or section(Plane, Axis, Text)
    seen(View, Parts, Regions, Centres)
    region(Of, Edges)   the cut face of segment Of: directed edges A-B; S-K of
                        a cell of segment S, where K is not a neighbour's
    centre(Points, End) a centre line, as of centre_lines/3

Parts are as in stroke.pl, points X-Y in the coordinates of the picture. A view
is made in a snapshot: the world is as it was afterwards.
*/

%!  view_named(?Name, -View) is nondet.
%
%   View is the one that view.pl calls Name.

view_named(Name, view(Name,Theta,Phi,Kind)) :-
    named_view(Name, Theta, Phi),
    (   memberchk(Name, [front,top,right,left,back,bottom])
    ->  Kind = side
    ;   Kind = pictorial
    ).

%!  view_towards(+Direction, +Name, -View) is semidet.
%
%   View, called Name, looks along Direction, d(X,Y,Z), which is not zero.
%   Straight up and down it has x to the right, as the top view.

view_towards(d(X,Y,Z), Name, view(Name,Theta,Phi,pictorial)) :-
    Level is sqrt(float(X*X+Y*Y)),
    max(Level, abs(Z)) > 0,
    (   Level =:= 0
    ->  Theta = 270.0
    ;   Theta is atan2(-Y,-X)*180/pi
    ),
    Phi is atan2(Level,-Z)*180/pi.

%!  section_view(+Letter, +Plane, +Axis, +Text, -View) is det.
%
%   View looks at Plane squarely, from above it; see section_plane/3. Text is
%   what the user wrote.

section_view(Letter, Plane, Axis, Text,
             view(Letter,Theta,Phi,section(Plane,Axis,Text))) :-
    Plane = plane(A,B,C,_),
    (   axis_side(Axis, Side)
    ->  named_view(Side, Theta, Phi)
    ;   maplist([N0,N]>>(N is -N0), [A,B,C], [X,Y,Z]),
        view_towards(d(X,Y,Z), Letter, view(_,Theta,Phi,_))
    ).

axis_side(x, right).
axis_side(y, front).
axis_side(z, top).

%!  view_axes(+View, -Right, -Up, -Away) is det.
%
%   What the unit vectors of the model are in the picture: lists of three.

view_axes(view(_,Theta,Phi,_), [A1,A2,A3], [B1,B2,B3], [C1,C2,C3]) :-
    eye_point(Theta, Phi, p(1.0,0.0,0.0), p(A1,B1,C1)),
    eye_point(Theta, Phi, p(0.0,1.0,0.0), p(A2,B2,C2)),
    eye_point(Theta, Phi, p(0.0,0.0,1.0), p(A3,B3,C3)).


                /*******************************
                *         WHERE IT GOES        *
                *******************************/

%!  view_cell(+View, +Angle, +Taken, -Cell) is det.
%
%   Cell is where View stands beside the front view, at(0,0): in a first-angle
%   drawing (Angle is `first`) what is seen from the right stands on the left,
%   in a third-angle drawing on the right. A section stands as the view from
%   that side, or beyond the cells that are Taken. Others are `free`.

view_cell(view(Name,_,_,side), Angle, _, Cell) :-
    !,
    side_cell(Name, Angle, Cell).
view_cell(view(_,_,_,section(_,Axis,_)), Angle, Taken, Cell) :-
    axis_side(Axis, Side),
    !,
    side_cell(Side, Angle, Cell0),
    beyond(Cell0, Angle, Taken, Cell).
view_cell(_, _, _, free).

side_cell(front,  _,     at(0,0)).
side_cell(back,   _,     at(2,0)).
side_cell(right,  third, at(1,0)).
side_cell(right,  first, at(-1,0)).
side_cell(left,   third, at(-1,0)).
side_cell(left,   first, at(1,0)).
side_cell(top,    third, at(0,-1)).
side_cell(top,    first, at(0,1)).
side_cell(bottom, third, at(0,1)).
side_cell(bottom, first, at(0,-1)).

beyond(Cell0, Angle, Taken, Cell) :-
    (   memberchk(Cell0, Taken)
    ->  farther(Cell0, Angle, Cell1),
        beyond(Cell1, Angle, Taken, Cell)
    ;   Cell = Cell0
    ).

farther(at(X0,Y0), Angle, at(X,Y)) :-
    (   Y0 =:= 0
    ->  Y = 0,
        (   ( X0 < 0 ; X0 =:= 0, Angle == first )
        ->  X is X0-1
        ;   X is X0+1
        )
    ;   X = X0,
        Y is Y0+sign(Y0)
    ).


                /*******************************
                *         WHAT IS SEEN         *
                *******************************/

:- meta_predicate section_seen(+, +, 0, 2, +, -).

%!  view_seen(+View, +Lines, +Picture, -Seen) is det.
%
%   Seen is what View, which is no section, shows of the current world, whose
%   segments are roots that have cut each other. Lines are those of operands
%   (csg_roots.pl), Picture options for picture/1.

view_seen(View, Lines, Picture, Seen) :-
    facts_snapshot(sg_sheet_view:seen(View, Lines, Picture, Seen)).

:- public seen/4, seen_cut/6.

seen(View, Lines, Picture, seen(View,Parts,[],Centres)) :-
    pictured(View, Lines, Picture, Parts),
    view_centres(View, Picture, Centres).

%!  section_seen(+View, +Lines, :Cut, :Named, +Picture, -Seen) is semidet.
%
%   The same of a section, of a world whose segments have not cut each other:
%   Cut does that, after what is above the plane was taken away. Then
%   call(Named, Parts0, Parts) tells which numbers edges have: Parts0 have N-E,
%   edge E of what is left, segment N. Fails if the plane goes past the model.

section_seen(View, Lines, Cut, Named, Picture, Seen) :-
    facts_snapshot(sg_sheet_view:seen_cut(View, Lines, Cut, Named, Picture,
                                          Seen)).

seen_cut(View, Lines0, Cut, Named, Picture0,
         seen(View,Parts,Regions,Centres)) :-
    View = view(_, Theta, Phi, section(Plane,_,_)),
    cut_away(Plane, Section),
    call(Cut),
    section_lines(Section, Lines0, Lines),
    section_on_surfaces(Section, Curves),
    pieces_of_segments(Section, Picture0, Picture),
    pictured(View, Lines, Picture, Parts0),
    findall(N-Edges, section_edges(Section, N, Edges), InPlane),
    Bent = bent(Theta, Phi, Curves),
    findall(Part,
            ( member(Part0, Parts0),
              bent_part(Bent, Part0, Part1),
              section_part(Section, InPlane, Part1, Part) ),
            Parts1),
    call(Named, Parts1, Parts),
    findall(Region, seen_region(Section, Picture0, Bent, Region), Regions),
    view_centres(View, Picture, Centres).

%!  view_centres(+View, +Picture, -Centres:list) is det.
%
%   Centres are the centre lines of the current world in View: none in a
%   pictorial view, and none where Picture shows facets as those of a
%   polyhedron, or penetration lines alone.

view_centres(View, Picture, Centres) :-
    (   (   View = view(_, _, _, pictorial)
        ;   member(Lines, [all,penetration]),
            memberchk(lines(Lines), Picture)
        )
    ->  Centres = []
    ;   findall(S, ( segment(S, _, _), drawn_segment(Picture, S) ), Ss0),
        sort(Ss0, Ss),
        view_axes(View, Right, Up, Away),
        centre_lines(axes(Right,Up,Away), Ss, Centres)
    ).

pictured(view(_,Theta,Phi,_), Lines, Picture, Parts) :-
    set_view(Theta, Phi, 0),
    set_projection(parallel),
    with_operand_lines(Lines, picture(Picture)),
    picture_parts(Parts).

%   pieces_of_segments(Section, Picture0, Picture): segments(Ss) of what is left
%   of them.

pieces_of_segments(section(_,Pieces), Picture0, Picture) :-
    (   select(segments(Ss), Picture0, Others)
    ->  findall(N, ( member(S, Ss), member(piece(S,N,_,_), Pieces) ), Ns),
        Picture = [segments(Ns)|Others]
    ;   Picture = Picture0
    ).

drawn_segment(Picture, S) :-
    (   memberchk(segments(Ss), Picture)
    ->  memberchk(S, Ss)
    ;   true
    ).

%   section_part(Section, InPlane, Part0, Part): with the number that its
%   segment has in the model, and its role.

section_part(section(_,Pieces), InPlane, part(V,Role0,N,E,F,T,A,B),
             part(V,Role,S,N-E,F,T,A,B)) :-
    memberchk(piece(S,N,_,_), Pieces),
    (   memberchk(N-Edges, InPlane),
        ord_memberchk(E, Edges)
    ->  Role = section
    ;   Role = Role0
    ).

%   bent_part(Bent, Part0, Part) is nondet: Part is Part0, or, where that stands
%   for a curve, a piece of it. The pieces do not quite meet along the edge:
%   they are no parts of one straight line.

bent_part(Bent, Part0, Part) :-
    Part0 = part(Visibility, Role, N, E, 0.0, 1.0, A, B),
    e(N, E, V1, V2, _),
    curve_between(Bent, N, V1, V2, Points),
    !,
    append([A|Points], [B], All),
    length(Points, Bends),
    Part = part(Visibility, Role, N, E, From, To, C, D),
    nextto_nth0(All, K, C, D),
    From is K/(Bends+1.0),
    To is From + 0.99/(Bends+1.0).
bent_part(_, Part, Part).

nextto_nth0(List, K, A, B) :-
    append(Before, [A,B|_], List),
    length(Before, K).

%   curve_between(Bent, N, V1, V2, Points) is semidet: X-Y, in the picture.

curve_between(bent(Theta,Phi,Curves), N, V1, V2, Points) :-
    (   get_assoc(edge(N,V1,V2), Curves, Places)
    ->  true
    ;   get_assoc(edge(N,V2,V1), Curves, Places0),
        reverse(Places0, Places)
    ),
    maplist(seen_place(Theta, Phi), Places, Points).

seen_place(Theta, Phi, Place, X-Y) :-
    eye_point(Theta, Phi, Place, p(X,Y,_)).

%   seen_region(Section, Picture, Bent, Region): Region is region(Of, Edges).

seen_region(Section, Picture, Bent, region(Of,Edges)) :-
    section_region(Section, S, Cell, N, Pairs),
    drawn_segment(Picture, S),
    (   Cell =:= 0
    ->  Of = S
    ;   Of = S-Cell
    ),
    findall(A-B,
            ( member(V1-V2, Pairs),
              screen(N, V1, X1, Y1, _),
              screen(N, V2, X2, Y2, _),
              (   curve_between(Bent, N, V1, V2, Points)
              ->  append([X1-Y1|Points], [X2-Y2], All),
                  nextto(A, B, All)
              ;   A-B = (X1-Y1)-(X2-Y2)
              )
            ),
            Edges).

%!  seen_box(+Seen, -Box) is semidet.
%
%   Box is box(X1,Y1,X2,Y2) round the parts. Fails if there are none.

seen_box(seen(_,[Part|Parts],_,_), Box) :-
    Part = part(_, _, _, _, _, _, X-Y, _),
    foldl(boxed, [Part|Parts], box(X,Y,X,Y), Box).

boxed(part(_,_,_,_,_,_,XA-YA,XB-YB), box(X1,Y1,X2,Y2), box(X3,Y3,X4,Y4)) :-
    X3 is min(X1, min(XA,XB)),
    Y3 is min(Y1, min(YA,YB)),
    X4 is max(X2, max(XA,XB)),
    Y4 is max(Y2, max(YA,YB)).
