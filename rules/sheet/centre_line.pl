:- module(sg_centre_line,
          [ centre_lines/3              % +Axes, +Ss, -Lines
          ]).
:- use_module('../csg/known_surface', [known_surfaces/1]).
:- use_module('../kernel', [round_extents/3]).
:- use_module('../near', [is_on_surface/2, is_rounding/2, tolerance/2]).
:- use_module('../vector', [dot_product/3, scaled/3, vector_sum/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/3]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, member/2, nth1/3, sum_list/2 ]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Centre lines: the axes of what is round, as ISO 128 has them.

A cylinder, cone, turned surface, sphere or torus has a centre line if it goes
at least half round: the rounded corner of a plate has none, and a torus, the
bend of a pipe, has one in any case. Along the axis it is a line, seen end on a
cross. Of one torus it is also the circle of its centre, or the arc. Holes of
one size that stand in even steps on a circle share that circle, the pitch
circle, and each has a line towards its centre instead of a cross.

What lies in one line is one line.
*/

:- set_prolog_flag(optimise, true).

%!  centre_lines(+Axes, +Ss, -Lines:list) is det.
%
%   Lines has centre(Points, End) of each centre line of the segments Ss, in the
%   coordinates of a parallel picture: End is `ring` if it closes, else `joint`,
%   and it is to go on a little at both ends. Axes, axes(Right, Up, Away), are
%   as of view_axes/4 (sheet_view.pl).

centre_lines(Axes, Ss, Lines) :-
    known_surfaces(Known),
    round_extents(Known, Ss, Extents),
    findall(Item,
            ( member(Extent, Extents), seen_item(Axes, Extent, Item) ),
            Items),
    seen_lines(Items, Lines).

%   seen_item(Axes, Extent, Item) is nondet: line(P,Q), straight;
%   circle(C,RX,RY), what is seen end on, its centre and how far it reaches;
%   curve(Points,End).

seen_item(Axes, Extent, line(P,Q)) :-
    Extent = extent(_, surface(Kind,_,_,_), Low, High, _, Turn),
    Kind \== sphere,
    half_round(Turn),
    on_axis(Axes, Extent, Low, P),
    on_axis(Axes, Extent, High, Q),
    \+ in_one_place(Axes, Extent, P, Q).
seen_item(Axes, Extent, circle(C,RX,RY)) :-
    Extent = extent(_, surface(sphere,Frame,_,_), _, _, _, Turn),
    half_round(Turn),
    frame(Frame, _, U, V, W),
    on_axis(Axes, Extent, 0.0, C),
    reach(Axes, [U,V,W], 1.0, RX, RY).
seen_item(Axes, Extent, circle(C,RX,RY)) :-
    Extent = extent(_, surface(Kind,Frame,A,_), Low, High, _, Turn),
    Kind \== sphere,
    half_round(Turn),
    frame(Frame, _, U, V, _),
    is_across(Axes, U),
    is_across(Axes, V),
    on_axis(Axes, Extent, High, C),
    on_axis(Axes, Extent, Low, D),
    in_one_place(Axes, Extent, C, D),
    (   Kind == torus
    ->  Factor is 1.0+A
    ;   Factor is max(1.0-Low+Low*A, 1.0-High+High*A)
    ),
    reach(Axes, [U,V], Factor, RX, RY).
seen_item(Axes, Extent, Item) :-
    Extent = extent(_, surface(torus,Frame,A,_), _, _, Begin, Turn),
    frame(Frame, C, U, V, _),
    (   seen_edge_on(Axes, U, V, Along)
    ->  Item = line(P1,P2),
        (   Turn >= 360
        ->  Factor is 1.0+A,            % as far as the torus
            ends_of_circle(Axes, C, U, V, Factor, Along, P1, P2)
        ;   arc(Axes, C, U, V, Begin, Turn, Points),
            ends_along(Points, Along, P1, P2)
        )
    ;   Item = curve(Points,End),
        arc(Axes, C, U, V, Begin, Turn, Points),
        (   Turn >= 360
        ->  End = ring
        ;   End = joint
        )
    ).

%   To the degree, as extents are.

half_round(Turn) :-
    Turn >= 179.

arc(Axes, C, U, V, Begin, Turn, Points) :-
    steps(Turn, N),
    findall(P,
            ( between(0, N, I),
              Angle is (Begin + Turn*I/N)*pi/180,
              place(C, [U-cos(Angle),V-sin(Angle)], Place),
              projected(Axes, Place, P) ),
            Points).

%   Pieces of three degrees.

steps(Turn, N) :-
    N is max(1, round(Turn/3)).

frame([X,Y,Z,UX,UY,UZ,VX,VY,VZ,WX,WY,WZ], p(X,Y,Z), p(UX,UY,UZ), p(VX,VY,VZ),
      p(WX,WY,WZ)).

on_axis(Axes, extent(_, surface(_,Frame,_,_), _, _, _, _), H, P) :-
    frame(Frame, C, _, _, W),
    place(C, [W-H], Place),
    projected(Axes, Place, P).

%   place(C, Parts, Place): Parts are vectors and how much of each.

place(C, Parts, Place) :-
    foldl(part_added, Parts, C, Place).

part_added(Vector-Part0, Place0, Place) :-
    Part is Part0,
    scaled(Part, Vector, Step),
    vector_sum(Place0, Step, Place).

projected(axes([A1,A2,A3],[B1,B2,B3],_), Place, X-Y) :-
    dot_product(p(A1,A2,A3), Place, X),
    dot_product(p(B1,B2,B3), Place, Y).

is_across(axes(_,_,[C1,C2,C3]), Vector) :-
    dot_product(p(C1,C2,C3), Vector, Depth),
    dot_product(Vector, Vector, Square),
    is_rounding(Depth, sqrt(Square)).

%   in_one_place(Axes, Extent, P, Q): seen from there, by the size of what is
%   round.

in_one_place(Axes, extent(_, surface(_,Frame,_,_), _, _, _, _), X1-Y1,
             X2-Y2) :-
    frame(Frame, _, U, V, W),
    reach(Axes, [U,V,W], 1.0, RX, RY),
    is_on_surface(abs(X1-X2) + abs(Y1-Y2), RX+RY).

%   reach(Axes, Radii, Factor, RX, RY): how far across and up the ellipse, or
%   the ellipsoid, of these conjugate radii reaches, times Factor.

reach(Axes, Radii, Factor, RX, RY) :-
    maplist(projected(Axes), Radii, Seen),
    aggregate_all(sum(X*X), member(X-_, Seen), XX),
    aggregate_all(sum(Y*Y), member(_-Y, Seen), YY),
    RX is Factor*sqrt(XX),
    RY is Factor*sqrt(YY).

%   seen_edge_on(Axes, U, V, Along): all vectors of the plane of U and V are
%   seen along one line.

seen_edge_on(Axes, U, V, DX-DY) :-
    projected(Axes, U, UX-UY),
    projected(Axes, V, VX-VY),
    is_rounding(UX*VY-UY*VX, UX*UX+UY*UY+VX*VX+VY*VY),
    (   UX*UX+UY*UY >= VX*VX+VY*VY
    ->  DX = UX, DY = UY
    ;   DX = VX, DY = VY
    ).

ends_along(Points, DX-DY, P, Q) :-
    findall(At-(X-Y), ( member(X-Y, Points), At is X*DX+Y*DY ), Keyed0),
    keysort(Keyed0, Keyed),
    Keyed = [_-P|_],
    last(Keyed, _-Q).

%   ends_of_circle(Axes, C, U, V, Factor, Along, P, Q): of one that is seen as a
%   line, made larger by Factor.

ends_of_circle(Axes, C, U, V, Factor, DX-DY, XP-YP, XQ-YQ) :-
    projected(Axes, C, X-Y),
    reach(Axes, [U,V], Factor, RX, RY),
    Part is sqrt((RX*RX+RY*RY)/(DX*DX+DY*DY)),
    XP is X-Part*DX, YP is Y-Part*DY,
    XQ is X+Part*DX, YQ is Y+Part*DY.


                /*******************************
                *         FROM ABOVE           *
                *******************************/

seen_lines(Items, Lines) :-
    findall(line(P,Q), member(line(P,Q), Items), Straight0),
    findall(centre(Points,End), member(curve(Points,End), Items), Curves),
    findall(circle(C,RX,RY), member(circle(C,RX,RY), Items), Circles),
    outermost(Circles, Outer),
    pitch_circles(Outer, Pitches, Alone),
    findall(line(P,Q), ( member(Circle, Alone), cross(Circle, P, Q) ), Crosses),
    findall(line(P,Q),
            ( member(Pitch, Pitches), pitch_line(Pitch, P, Q) ),
            Radial),
    append([Straight0,Crosses,Radial], Straight1),
    united(Straight1, Straight),
    findall(centre([P,Q],joint), member(line(P,Q), Straight), Own),
    findall(centre(Points,ring),
            ( member(Pitch, Pitches), pitch_ring(Pitch, Points) ),
            Rings),
    append([Own,Curves,Rings], Lines).

cross(circle(X-Y,RX,RY), P, Q) :-
    (   X1 is X-RX,
        X2 is X+RX,
        P = X1-Y,
        Q = X2-Y
    ;   Y1 is Y-RY,
        Y2 is Y+RY,
        P = X-Y1,
        Q = X-Y2
    ).

%   outermost(Circles, Outer): the largest of those with one centre.

outermost(Circles, Outer) :-
    findall(X-circle(X-Y,RX,RY), member(circle(X-Y,RX,RY), Circles), Keyed),
    circles_size(Circles, Size),
    clusters(Keyed, Size, Columns),
    findall(Largest,
            ( member(Column, Columns),
              findall(Y-circle(X-Y,RX,RY), member(circle(X-Y,RX,RY), Column),
                      Keyed1),
              clusters(Keyed1, Size, Places),
              member(Place, Places),
              largest(Place, Largest) ),
            Outer).

circles_size(Circles, Size) :-
    aggregate_all(max(Own), ( member(circle(_,RX,RY), Circles), Own is RX+RY ),
                  Size),
    !.
circles_size(_, 1.0).

largest([Circle|Circles], Largest) :-
    foldl(larger, Circles, Circle, Largest).

larger(circle(C1,X1,Y1), circle(C0,X0,Y0), Larger) :-
    (   X1+Y1 > X0+Y0
    ->  Larger = circle(C1,X1,Y1)
    ;   Larger = circle(C0,X0,Y0)
    ).

%   clusters(Keyed, Size, Groups): values whose keys, numbers, follow each other
%   by no more than rounding of what is Size large.

clusters(Keyed0, Size, Groups) :-
    keysort(Keyed0, Keyed),
    tolerance(paper, Near),
    Most is Near*Size,
    grouped(Keyed, Most, Groups).

grouped([], _, []).
grouped([Key-Value|Keyed], Most, [[Value|Values]|Groups]) :-
    taken(Keyed, Key, Most, Values, Rest),
    grouped(Rest, Most, Groups).

taken([Key-Value|Keyed], Last, Most, [Value|Values], Rest) :-
    Key-Last =< Most,
    !,
    taken(Keyed, Key, Most, Values, Rest).
taken(Rest, _, _, [], Rest).


                /*******************************
                *         PITCH CIRCLES        *
                *******************************/

%   pitch_circles(Circles, Pitches, Alone): pitch(C,D,Members), circles at the
%   distance D from C in even steps; Alone are on none.

pitch_circles(Circles, Pitches, Alone) :-
    findall(R-Circle,
            ( member(Circle, Circles),
              Circle = circle(_,R,RY),
              is_on_surface(R-RY, R) ),
            Keyed),
    circles_size(Circles, Size),
    clusters(Keyed, Size, Groups),
    foldl(pitches_of(Circles), Groups, [], Pitches),
    findall(Circle,
            ( member(Circle, Circles),
              \+ ( member(pitch(_,_,Members), Pitches),
                   memberchk(Circle, Members) ) ),
            Alone).

pitches_of(Circles, Group, Pitches0, Pitches) :-
    (   Group = [_,_,_|_]
    ->  middle(Group, Middle),
        findall(C, ( member(circle(C,_,_), Circles),
                     \+ memberchk(circle(C,_,_), Group) ), Others),
        foldl(pitches_about, [Middle|Others], Group-Pitches0, _-Pitches)
    ;   Pitches = Pitches0
    ).

middle(Group, X-Y) :-
    length(Group, N),
    findall(X1, member(circle(X1-_,_,_), Group), Xs),
    findall(Y1, member(circle(_-Y1,_,_), Group), Ys),
    sum_list(Xs, SumX),
    sum_list(Ys, SumY),
    X is SumX/N,
    Y is SumY/N.

pitches_about(C, Left0-Pitches0, Left-Pitches) :-
    findall(D-Circle, ( member(Circle, Left0), distance(C, Circle, D) ), Keyed),
    aggregate_all(max(D), member(D-_, Keyed), Size),
    !,
    clusters(Keyed, Size, Rings),
    findall(pitch(C,D,Ring),
            ( member(Ring, Rings),
              Ring = [First,_,_|_],
              distance(C, First, D),
              First = circle(_,R,_),
              D > R,
              in_even_steps(C, Ring) ),
            Own),
    append(Pitches0, Own, Pitches),
    exclude(on_one_of(Own), Left0, Left).
pitches_about(_, Left-Pitches, Left-Pitches).

on_one_of(Pitches, Circle) :-
    member(pitch(_,_,Members), Pitches),
    memberchk(Circle, Members),
    !.

distance(X0-Y0, circle(X-Y,_,_), D) :-
    D is sqrt((X-X0)**2 + (Y-Y0)**2).

in_even_steps(X0-Y0, Ring) :-
    findall(Angle,
            ( member(circle(X-Y,_,_), Ring), Angle is atan2(Y-Y0, X-X0) ),
            Angles0),
    msort(Angles0, Angles),
    length(Angles, N),
    Angles = [First|_],
    \+ ( nth1(I, Angles, Angle),
         Off is Angle-First-(I-1)*2*pi/N,
         \+ is_on_surface(Off, 1.0) ).

pitch_line(pitch(X0-Y0,D,Members), P, Q) :-
    member(circle(X-Y,R,_), Members),
    U is (X-X0)/D,
    V is (Y-Y0)/D,
    XP is X-R*U, YP is Y-R*V,
    XQ is X+R*U, YQ is Y+R*V,
    P = XP-YP,
    Q = XQ-YQ.

pitch_ring(pitch(X0-Y0,D,[circle(X1-Y1,_,_)|_]), Points) :-
    Start is atan2(Y1-Y0, X1-X0),
    steps(360, N),
    findall(X-Y,
            ( between(0, N, I),
              Angle is Start + 2*pi*(I mod N)/N,
              X is X0+D*cos(Angle),
              Y is Y0+D*sin(Angle) ),
            Points).


                /*******************************
                *           ONE LINE           *
                *******************************/

%   united(Lines0, Lines): those on one line that overlap or touch are one.

united(Lines0, Lines) :-
    findall(X-Y, ( member(line(P,Q), Lines0), ( P = X-Y ; Q = X-Y ) ), Points),
    (   Points = [O|_]
    ->  aggregate_all(max(D), ( member(P, Points), distance(O, circle(P,_,_), D)
                              ), Size),
        findall(Angle-run(O,Angle,P,Q),
                ( member(line(P,Q), Lines0), line_angle(P, Q, Angle) ),
                Keyed),
        clusters(Keyed, 1.0, Directions),
        findall(Line,
                ( member(Direction, Directions),
                  in_direction(Direction, Size, Line) ),
                Lines)
    ;   Lines = []
    ).

%   line_angle(P, Q, Angle): more than -pi/2, and no more than pi/2.

line_angle(X1-Y1, X2-Y2, Angle) :-
    DX is X2-X1,
    DY is Y2-Y1,
    (   is_rounding(DX, abs(DY))
    ->  Angle is pi/2
    ;   Angle is atan(DY/DX)
    ).

in_direction(Direction, Size, line(P,Q)) :-
    Direction = [run(O,Angle,_,_)|_],
    U is cos(Angle),
    V is sin(Angle),
    findall(Off-span(From,To,Off),
            ( member(run(_,_,A,B), Direction),
              along(O, U, V, A, AtA, Off),
              along(O, U, V, B, AtB, _),
              From is min(AtA, AtB),
              To is max(AtA, AtB) ),
            Keyed),
    clusters(Keyed, Size, Parallels),
    member(Parallel, Parallels),
    findall(From-Span, ( member(Span, Parallel), arg(1, Span, From) ), Spans0),
    keysort(Spans0, Spans1),
    pairs_values(Spans1, [span(F,T,Off)|Spans]),
    tolerance(paper, Near),
    Gap is Near*Size,
    spans_united(Spans, F, T, Gap, From, To),
    back(O, U, V, From, Off, P),
    back(O, U, V, To, Off, Q).

along(XO-YO, U, V, X-Y, At, Off) :-
    At is (X-XO)*U + (Y-YO)*V,
    Off is (Y-YO)*U - (X-XO)*V.

back(XO-YO, U, V, At, Off, X-Y) :-
    X is XO + At*U - Off*V,
    Y is YO + At*V + Off*U.

%   spans_united(Spans, F0, T0, Gap, From, To) is nondet: each stretch.

spans_united([span(F,T,_)|Spans], F0, T0, Gap, From, To) :-
    F =< T0+Gap,
    !,
    T1 is max(T, T0),
    spans_united(Spans, F0, T1, Gap, From, To).
spans_united(_, From, To, _, From, To).
spans_united([span(F,T,_)|Spans], _, _, Gap, From, To) :-
    spans_united(Spans, F, T, Gap, From, To).
