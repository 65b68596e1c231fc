:- module(sg_line_point,
          [ line_points/2,              % +Most, -Points
            points_seen/4,              % +Hidden, +Points, +Seen, -Dots
            points_added/5              % +Hidden, +Points, +Place, +Drawing0,
                                        % -Drawing
          ]).
:- use_module('../penetration/chain', [chain_vertices/3, chains/1]).
:- use_module('../store', [line/9, origin/3, screen/5, segment/3, v/5]).
:- use_module(sheet_construction, [construction_view/7]).
:- use_module(sheet_view, [view_axes/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [append/3, member/2, memberchk/2, nth1/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
:- use_module(library(solution_sequences), [distinct/2]).
/** <module> The numbered points of penetration lines in a drawing.

    point(I, S, V, p(X,Y,Z))    point I is vertex V of segment S

A point has its number and a small circle in all views; where hidden lines are
left out, only if something is drawn of its line there.
*/

%!  line_points(+Most, -Points:list) is det.
%
%   Points are those of the penetration lines line/9 of the current world,
%   numbered from 1 chain by chain: all corners if Most is `all`, else of each
%   chain at most Most corners, evenly along it, ends among them; then those
%   where curves go through. Corners in one place have one number. A notice if
%   there are none.

line_points(Most, Points) :-
    chains(Chains),
    foldl(chain_corners(Most), Chains, []-Corners, Known-Corners1),
    findall(corner(S,V,p(X,Y,Z)),
            ( segment(S, curve, _),
              distinct(V, origin(S, v(V), _)),
              v(S, V, X, Y, Z) ),
            Through),
    foldl(new_corner, Through, Known-Corners1, _-[]),
    findall(point(I,S,V,P), nth1(I, Corners, corner(S,V,P)), Points),
    (   Points == []
    ->  print_message(informational, sanggwan(points_in_vain))
    ;   true
    ).

%   Known are the places that have a corner.

chain_corners(Most, chain(S,_,Kind,Lines), Known0-Corners0, Known-Corners) :-
    line_first(Lines, S, S1),
    chain_vertices(Lines, S1, Vs0),
    (   Kind == closed
    ->  append(Vs, [_], Vs0)
    ;   Vs = Vs0
    ),
    findall(corner(S1,V,p(X,Y,Z)), ( member(V, Vs), v(S1, V, X, Y, Z) ), All),
    chosen(Most, Kind, All, Chosen),
    foldl(new_corner, Chosen, Known0-Corners0, Known-Corners).

%   line_first(Lines, S, S1): S1 is the segment that has vertices along Lines.

line_first([Step|_], S, S1) :-
    L is abs(Step),
    line(L, A, _, _, _, B, _, _, _),
    (   ( S == A ; S == B )
    ->  S1 = S
    ;   S1 = A
    ).

new_corner(Corner, Known0-Corners0, Known-Corners) :-
    Corner = corner(_,_,P),
    (   memberchk(P, Known0)
    ->  Known-Corners = Known0-Corners0
    ;   Known = [P|Known0],
        Corners0 = [Corner|Corners]
    ).

%   chosen(Most, Kind, All, Chosen)

chosen(all, _, All, All) :-
    !.
chosen(Most, _, All, All) :-
    length(All, N),
    N =< Most,
    !.
chosen(Most, Kind, All, Chosen) :-
    way_along(All, Kind, Ways, Length),
    (   Kind == closed
    ->  Step is Length/Most
    ;   Step is Length/max(1, Most-1)
    ),
    Last is Most-1,
    findall(Place,
            ( between(0, Last, I),
              At is I*Step,
              aggregate_all(min(Off,J),
                            ( nth1(J, Ways, Way), Off is abs(Way-At) ),
                            min(_,Place)) ),
            Places0),
    sort(Places0, Places),
    findall(Corner, ( member(J, Places), nth1(J, All, Corner) ), Chosen).

%   way_along(Corners, Kind, Ways, Length): how far each is from the first, and
%   how long the whole is.

way_along([corner(S,V,P)|Corners], Kind, [0.0|Ways], Length) :-
    foldl(farther, Corners, far(P,0.0,Ways), far(Q,Far,[])),
    (   Kind == closed
    ->  farther(corner(S,V,P), far(Q,Far,[Length]), _)
    ;   Length = Far
    ).

farther(corner(_,_,P), far(Q,Far0,[Far|Ways]), far(P,Far,Ways)) :-
    P = p(X1,Y1,Z1),
    Q = p(X2,Y2,Z2),
    Far is Far0 + sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

%!  points_seen(+Hidden, +Points, +Seen, -Dots:list) is det.
%
%   Dots are items of seen_drawing/3 (sheet_plan.pl), dot(Name,X-Y,I), for the
%   Points in Seen, of view_seen/4, none in a section. If Hidden is `removed`,
%   for those at which something is drawn of their line.

points_seen(Hidden, Points, seen(View,Parts,_,_), Dots) :-
    View = view(Name, _, _, Kind),
    (   Kind = section(_, _, _)
    ->  Dots = []
    ;   view_axes(View, [A1,A2,A3], [B1,B2,B3], _),
        findall(Key,
                ( member(part(_,Role,_,_,_,_,P,Q), Parts),
                  memberchk(Role, [penetration,curve]),
                  member(End, [P,Q]),
                  place_key(End, Near),
                  near_key(Near, Key) ),
                Keys0),
        sort(Keys0, Keys),
        findall(dot(Name,XY,I),
                ( member(point(I,_,_,p(X,Y,Z)), Points),
                  U is A1*X + A2*Y + A3*Z,
                  V is B1*X + B2*Y + B3*Z,
                  XY = U-V,
                  (   Hidden == removed
                  ->  place_key(XY, Key),
                      ord_memberchk(Key, Keys)
                  ;   true
                  ) ),
                Dots)
    ).

%   Places of the picture as whole numbers; rounding may have put one beside.

place_key(X-Y, I-J) :-
    I is round(X*1.0e6),
    J is round(Y*1.0e6).

near_key(I0-J0, I-J) :-
    member(DI, [-1,0,1]),
    member(DJ, [-1,0,1]),
    I is I0+DI,
    J is J0+DJ.

%!  points_added(+Hidden, +Points, +Place, +Drawing0, -Drawing) is det.
%
%   Drawing is Drawing0, the picture of the current world laid on a sheet by
%   Place (placed_part/3), with the numbers of Points; Hidden as for
%   points_seen/4.

points_added(Hidden, Points, place(Scale,X,Y,Left,Top), drawing(Sheet,Views0),
             drawing(Sheet,Views)) :-
    findall(P,
            ( member(view(_,Strokes,_), Views0),
              member(stroke(_,Role,_,_,Ps,_,_), Strokes),
              memberchk(Role, [penetration,curve]),
              member(P, Ps) ),
            Drawn0),
    sort(Drawn0, Drawn),
    PerUnit is Scale/1000,
    LeftMm is Left/1000,
    TopMm is Top/1000,
    findall(dot('',U-V,I),
            ( member(point(I,S,N,_), Points),
              screen(S, N, U, V, _),
              (   Hidden == removed
              ->  A is round((U-X)*Scale + Left),
                  B is round((Y-V)*Scale + Top),
                  ord_memberchk(A-B, Drawn)
              ;   true
              ) ),
            Dots),
    construction_view([construction(Dots)], PerUnit,
                      [place('',X,Y,LeftMm,TopMm)], [], Views0, Numbers, _),
    append(Views0, Numbers, Views).
