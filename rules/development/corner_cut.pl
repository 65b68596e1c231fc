:- module(sg_corner_cut,
          [ corner_cut/5,               % +D, +Bends, +Wished, +Corner, -Cut
            corner_relief/3,            % +Corner, +Wished, -Relief
            crossing/5,                 % +A, +B, +C, +D, -X
            place/3                     % +D, +V, -Place
          ]).
:- use_module('../decision', [decision/2]).
:- use_module('../near', [is_rounding/2, is_straight/2, less_part/2]).
:- use_module('../store', [e/5, v/5]).
:- use_module(bend_corner, [edge_inward/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists),
              [append/2, append/3, max_list/2, member/2, reverse/2]).
/** <module> What is cut out of a plate where two bends meet in a corner.

A bend takes as much plate as its allowance, half of it on each side of the bend
line. Where two flanges of one face meet in a seam, as in the corners of a tray,
their bends would cross, and the plate would tear. So the corner is cut out, as
corner_relief/3 decides. Let C be where the bend lines meet, and Q the point of
the face that is half an allowance away from both:

    square   each bend ends at right angles to its line, beside Q; its flange is
             cut off there, as deep as half the allowance
    round    a circle about C through Q
    none     nothing

What is cut off reaches a tenth farther than where the ends of the two flanges
would cross, if that is more. Where more than two bends end side by side, as at
the apex of a pyramid, both are a circle about the middle, a tenth wider than to
the farthest Q. Where nothing is cut out and flanges would cross, they are
parted along the straight line from there to C. So the outline of a bent plate
does not cross itself in its corners.
*/

:- decision(corner_relief/3, "What is cut out where two bends meet").

%!  corner_relief(+Corner, +Wished, -Relief) is det.
%
%   Relief, `square`, `round` or `none`, is what is cut out of Corner, a term
%   corner(D, P, Degrees1, Degrees2): of polygon P in pattern D, between bends
%   that turn by so many degrees, positive a mountain. Wished is what the option
%   relief(Wished) of pattern_bent/2 says.
%
%   By default as wished, but `none` beside a bend by less than 10 degrees, as
%   those between the facets of what is rounded by bending.

corner_relief(corner(_, _, Degrees1, Degrees2), Wished, Relief) :-
    (   min(abs(Degrees1), abs(Degrees2)) < 10.0
    ->  Relief = none
    ;   Relief = Wished
    ).

%!  corner_cut(+D, +Bends, +Wished, +Corner, -Cut) is semidet.
%
%   Cut is what is cut out of Corner of pattern D, as bent_corner/3 of
%   corner_relief.pl has it: Wants-Cuts, Wants `relief`, or `none` if nobody
%   wants one. Cuts are no_room(P, Wide), or cut(P, E1, E2, Places, V): in
%   polygon P the edge E1 ends and E2 begins otherwise, and what leads from one
%   to the other goes through Places, at(X-Y) or vertex(V); before it was vertex
%   V. Bends is an assoc from edges to bend(F, Wide, Degrees): F the other side,
%   Wide half an allowance.

corner_cut(D, Bends, Wished, corner(Faces, flange(P1, G1, F1),
                                    flange(P2, G2, F2), Kind), Wants-Cuts) :-
    once(e(D, G1, H1, K1, _)),
    once(e(D, G2, K2, H2, _)),
    maplist(place(D), [H1,K1,K2,H2], [H1At,K1At,K2At,H2At]),
    maplist(face_corner(D), Faces, Corners),
    append([[H1At,K1At],Corners,[K2At,H2At]], Way),
    findall(X, way_crosses(Way, X), Crossing),
    maplist(face_zone(D, Bends), Faces, Zones),
    maplist(face_relief(D, Bends, Kind, Wished), Faces, Reliefs),
    (   memberchk(none, Reliefs)
    ->  Wants = none
    ;   Wants = relief
    ),
    Flange1 = flange(P1, G1, F1, K1, K1At, H1At),
    Flange2 = flange(P2, G2, F2, K2, K2At, H2At),
    (   Faces = [Face],
        Zones = [Zone],
        Reliefs = [Relief]
    ->  relief_cut(Relief, Zone, Crossing, Face, Flange1, Flange2, Cuts)
    ;   tip_cut(D, Kind-Reliefs, Zones, Crossing, Faces, Flange1, Flange2,
                Cuts)
    ).

%   way_crosses(Way, X) is nondet: the way through the places round a corner
%   crosses itself at X.

way_crosses(Way, X) :-
    append(_, [A,B|Rest], Way),
    append(_, [C,D|_], Rest),
    crossing(A, B, C, D, X).

%   face_zone(D, Bends, Face, Zone): zone(Frame1-Back1-W1, Frame2-Back2-W2):
%   what is near the corner is measured from where each of the two bend lines
%   ends: back along it, and how far out of the face. W is half an allowance;
%   Q is as far Back along the line.

face_zone(D, Bends, face(_, In, Out, C),
          zone(frame(At, -NY1, NX1, -NX1, -NY1)-Back1-W1,
               frame(At, NY2, -NX2, -NX2, -NY2)-Back2-W2)) :-
    place(D, C, At),
    edge_inward(D, In, NX1, NY1),
    edge_inward(D, Out, NX2, NY2),
    get_assoc(In, Bends, bend(_, W1, _)),
    get_assoc(Out, Bends, bend(_, W2, _)),
    Sine is NX1*NY2 - NY1*NX2,
    (   Sine > 0.0,
        \+ is_straight(Sine, 1.0)
    ->  Cosine is NX1*NX2 + NY1*NY2,
        Back1 is max(0.0, (W2 - W1*Cosine)/Sine),
        Back2 is max(0.0, (W1 - W2*Cosine)/Sine)
    ;   Back1 = none,
        Back2 = none
    ).

%   face_relief(D, Bends, Kind, Wished, Face, Relief): `none` in a corner that
%   is not convex.

face_relief(D, Bends, Kind, Wished, Face, Relief) :-
    Face = face(P, In, Out, _),
    (   Kind == seam,
        face_zone(D, Bends, Face, zone(_-Back-_, _)),
        Back \== none
    ->  get_assoc(In, Bends, bend(_, _, Degrees1)),
        get_assoc(Out, Bends, bend(_, _, Degrees2)),
        corner_relief(corner(D, P, Degrees1, Degrees2), Wished, Relief)
    ;   Relief = none
    ).

%!  place(+D, +V, -Place) is det.
%
%   Place is X-Y, where vertex V of pattern D is.

place(D, V, X-Y) :-
    once(v(D, V, X, Y, _)).

%   in_frame(Frame, Place, Along, Out), placed(Frame, Along, Out, Place)

in_frame(frame(X0-Y0, UX, UY, NX, NY), X-Y, Along, Out) :-
    Along is (X-X0)*UX + (Y-Y0)*UY,
    Out is (X-X0)*NX + (Y-Y0)*NY.

placed(frame(X0-Y0, UX, UY, NX, NY), Along, Out, X-Y) :-
    X is X0 + Along*UX + Out*NX,
    Y is Y0 + Along*UY + Out*NY.

%!  crossing(+A, +B, +C, +D, -X) is semidet.
%
%   The straight pieces A-B and C-D cross at X, between their ends.

crossing(XA-YA, XB-YB, XC-YC, XD-YD, X-Y) :-
    DX1 is XB-XA, DY1 is YB-YA,
    DX2 is XD-XC, DY2 is YD-YC,
    Cross is DX1*DY2 - DY1*DX2,
    Square is (DX1*DX1 + DY1*DY1)*(DX2*DX2 + DY2*DY2),
    \+ is_straight(Cross, Square),
    T is ((XC-XA)*DY2 - (YC-YA)*DX2)/Cross,
    U is ((XC-XA)*DY1 - (YC-YA)*DX1)/Cross,
    between_parts(T),
    between_parts(U),
    X is XA + T*DX1,
    Y is YA + T*DY1.

between_parts(T) :-
    less_part(0.0, T),
    less_part(T, 1.0).

%   relief_cut(Relief, Zone, Crossing, Face, Flange1, Flange2, Cuts) is semidet.

relief_cut(none, zone(Frame1-_-_, Frame2-_-_), [X], Face, Flange1, Flange2,
           Cuts) :-
    Face = face(_, _, _, C),
    Flange1 = flange(P1, G1, F1, K1, K1At, _),
    Flange2 = flange(P2, G2, F2, K2, K2At, _),
    in_frame(Frame1, K1At, Along1, _),
    in_frame(Frame2, K2At, Along2, _),
    (   Along1 < 0.0,
        Along2 < 0.0
    ->  Cuts = [ cut(P1, G1, F1, [at(X),vertex(C)], K1),
                 cut(P2, F2, G2, [vertex(C),at(X)], K2) ]
    ;   Frame1 = frame(At, _, _, _, _),
        findall(Far, ( member(Place, [X,K1At,K2At]), apart(At, Place, Far) ),
                Fars),
        max_list(Fars, R0),
        R is 1.1*R0,
        round_cut(R, Frame1, Frame2, Face, Flange1, Flange2, Cuts)
    ).
relief_cut(none, zone(Frame1-_-_, Frame2-_-_), [], face(_, _, _, C),
           Flange1, Flange2, Cuts) :-
    nub_cut(Frame1, C, Flange1, Places1),
    nub_cut(Frame2, C, Flange2, Places2),
    turned_round(Places1, Places3),
    flange_cuts(Flange1, Places3, Flange2, Places2, Cuts).
relief_cut(square, zone(Frame1-Back1-W1, Frame2-Back2-W2), Crossing,
           face(P, In, Out, C), Flange1, Flange2, [Face|Flanges]) :-
    In1 is -W1,
    In2 is -W2,
    placed(Frame1, Back1, 0.0, A1),
    placed(Frame1, Back1, In1, M1),
    placed(Frame2, Back2, In2, M2),
    placed(Frame2, Back2, 0.0, A2),
    apart(M1, M2, Far),
    (   is_rounding(Far, 1.0 + Back1 + Back2 + W1 + W2)
    ->  Ms = [at(M1)]
    ;   Ms = [at(M1),at(M2)]
    ),
    append([[at(A1)], Ms, [at(A2)]], Places),
    Face = cut(P, In, Out, Places, C),
    flange_square(Frame1, Back1, W1, Crossing, Flange1, Places1),
    flange_square(Frame2, Back2, W2, Crossing, Flange2, Places3),
    turned_round(Places3, Places2),
    flange_cuts(Flange1, Places1, Flange2, Places2, Flanges).
relief_cut(round, zone(Frame1-Back1-W1, Frame2-_-_), Crossing, Face, Flange1,
           Flange2, Cuts) :-
    Frame1 = frame(At, _, _, _, _),
    Flange1 = flange(_, _, _, _, K1At, _),
    Flange2 = flange(_, _, _, _, K2At, _),
    Q is sqrt(Back1*Back1 + W1*W1),
    findall(Far, ( member(X, Crossing), apart(At, X, Far0), Far is 1.1*Far0 ),
            Fars0),
    beyond(Frame1, K1At, Fars1),
    beyond(Frame2, K2At, Fars2),
    append([[Q], Fars0, Fars1, Fars2], Fars),
    max_list(Fars, R),
    round_cut(R, Frame1, Frame2, Face, Flange1, Flange2, Cuts).

round_cut(R, Frame1, Frame2, face(P, In, Out, C), Flange1, Flange2,
          [cut(P, In, Out, Arc, C)|Flanges]) :-
    Frame1 = frame(At, _, _, _, _),
    placed(Frame1, R, 0.0, A1),
    placed(Frame2, R, 0.0, A2),
    arc(At, A1, A2, Arc),
    flange_arc(first, At-R, A1, Flange1, Places1),
    flange_arc(second, At-R, A2, Flange2, Places2),
    flange_cuts(Flange1, Places1, Flange2, Places2, Flanges).

%   tip_cut(D, Kind-Reliefs, Zones, Crossing, Faces, Flange1, Flange2, Cuts)
%   is semidet: where several faces meet, as at the apex of a pyramid, a
%   circle through the farthest Q is cut out; if no relief is wanted, only one
%   that has all that may lie on each other.

tip_cut(D, Kind-Reliefs, Zones, Crossing, Faces, Flange1, Flange2, Cuts) :-
    maplist(face_corner(D), Faces, Corners),
    mean_place(Corners, At),
    Flange1 = flange(P1, G1, F1, K1, K1At, _),
    Flange2 = flange(P2, G2, F2, K2, K2At, _),
    (   memberchk(none, Reliefs)
    ->  once(( Kind == seam ; Crossing = [_|_] )),
        Wide = []
    ;   maplist(zone_q, Zones, Wide)
    ),
    append([[K1At,K2At], Corners, Crossing, Wide], Within),
    findall(Far, ( member(X, Within), apart(At, X, Far) ), Fars),
    max_list(Fars, R0),
    R is 1.1*R0,
    \+ is_rounding(R, 1.0),
    findall(Cut,
            ( member(face(P, In, Out, C), Faces),
              leaves(D, At-R, In, end, A),
              leaves(D, At-R, Out, start, B),
              tip_arc(P, In, Out, C, At-R, A, B, Cut) ),
            Cuts0),
    leaves(D, At-R, G1, end, A1),
    leaves(D, At-R, F1, start, B1),
    tip_arc(P1, G1, F1, K1, At-R, A1, B1, Cut1),
    leaves(D, At-R, F2, end, A2),
    leaves(D, At-R, G2, start, B2),
    tip_arc(P2, F2, G2, K2, At-R, A2, B2, Cut2),
    append(Cuts0, [Cut1,Cut2], Cuts).

face_corner(D, face(_, _, _, C), At) :-
    place(D, C, At).

mean_place(Places, X-Y) :-
    aggregate_all(r(count, sum(X1), sum(Y1)), member(X1-Y1, Places),
                  r(N, XN, YN)),
    X is XN/N,
    Y is YN/N.

zone_q(zone(Frame-Back-W, _), Q) :-
    Out is -W,
    placed(Frame, Back, Out, Q).

%   leaves(D, C-R, E, Which, Place): where edge E, coming from its start or its
%   end, leaves the circle about C.

leaves(D, Circle, E, Which, Place) :-
    once(e(D, E, V, W, _)),
    place(D, V, VAt),
    place(D, W, WAt),
    (   Which == start
    ->  circle_left(Circle, VAt, WAt, Place)
    ;   circle_left(Circle, WAt, VAt, Place)
    ).

tip_arc(P, _, _, _, _-R, A, B, Cut) :-
    ( A == inside ; B == inside ),
    !,
    Cut = no_room(P, R).
tip_arc(P, E1, E2, V, C-_, A, B, cut(P, E1, E2, Arc, V)) :-
    arc(C, A, B, Arc).

%   nub_cut(Frame, C, Flange, Places): what of a flange is before its bend
%   line, and would lie on the other flange, is cut off at right angles to
%   that.

nub_cut(Frame, C, flange(_, _, _, _, K, H), Places) :-
    in_frame(Frame, K, AlongK, OutK),
    in_frame(Frame, H, AlongH, OutH),
    (   AlongK < 0.0,
        \+ is_rounding(AlongK, AlongH),
        AlongH > 0.0
    ->  Out is OutK - AlongK*(OutH - OutK)/(AlongH - AlongK),
        at_place(Frame, 0.0-Out, Place),
        Places = [vertex(C),Place]
    ;   Places = []
    ).

%   flange_cuts(Flange1, Places1, Flange2, Places2, Cuts): Places are those of a
%   cut in the order of the way round, or [] if there is none, or no_room(Wide).

flange_cuts(flange(P1, G1, F1, K1, _, _), Places1,
            flange(P2, G2, F2, K2, _, _), Places2, Cuts) :-
    flange_cut(Places1, P1, G1, F1, K1, Cuts1),
    flange_cut(Places2, P2, F2, G2, K2, Cuts2),
    append(Cuts1, Cuts2, Cuts).

flange_cut([], _, _, _, _, []) :-
    !.
flange_cut(no_room(Wide), P, _, _, _, [no_room(P, Wide)]) :-
    !.
flange_cut(Places, P, E1, E2, K, [cut(P, E1, E2, Places, K)]).

apart(X0-Y0, X-Y, Far) :-
    Far is sqrt((X-X0)**2 + (Y-Y0)**2).

%   beyond(Frame, K, Fars): how far from C is the end K of a flange that begins
%   before the bend line does.

beyond(Frame, K, Fars) :-
    in_frame(Frame, K, Along, _),
    (   Along < 0.0
    ->  Far is -Along,
        Fars = [Far]
    ;   Fars = []
    ).

%   flange_square(Frame, Back, W, Crossing, Flange, Places): what leads from the
%   end of the flange to its bend line.

flange_square(Frame, Back, W, Crossing, flange(_, _, _, _, K, H), Places) :-
    findall(Out, ( member(X, Crossing), in_frame(Frame, X, _, Out0),
                   Out is 1.1*Out0 ),
            Outs),
    max_list([W|Outs], Deep),
    in_frame(Frame, K, AlongK, OutK),
    in_frame(Frame, H, AlongH, OutH),
    (   AlongK >= Back
    ->  Places = []
    ;   OutH > Deep,
        T is (Deep - OutK)/(OutH - OutK),
        Along is AlongK + T*(AlongH - AlongK),
        Along < Back
    ->  maplist(at_place(Frame), [Along-Deep,Back-Deep,Back-0.0], Places)
    ;   AlongH > Back
    ->  T is (Back - AlongK)/(AlongH - AlongK),
        Out is OutK + T*(OutH - OutK),
        maplist(at_place(Frame), [Back-Out,Back-0.0], Places)
    ;   Places = no_room(Back)
    ).

at_place(Frame, Along-Out, at(Place)) :-
    placed(Frame, Along, Out, Place).

turned_round(Places0, Places) :-
    (   is_list(Places0)
    ->  reverse(Places0, Places)
    ;   Places = Places0
    ).

%   flange_arc(Which, C-R, A, Flange, Places): of the first flange from where
%   its end leaves the circle about C to A on the bend line; of the second
%   back.

flange_arc(Which, C-R, A, flange(_, _, _, _, K, H), Places) :-
    apart(C, K, Far),
    (   Far >= R
    ->  Places = []
    ;   circle_left(C-R, K, H, G)
    ->  (   G == inside
        ->  Places = no_room(R)
        ;   Which == first
        ->  arc(C, G, A, Places)
        ;   arc(C, A, G, Places)
        )
    ).

%   circle_left(C-R, K, H, Place): on the way from K to H; K if that is not in
%   the circle, and `inside` if H is.

circle_left(C-R, K, H, Place) :-
    apart(C, K, FarK),
    apart(C, H, FarH),
    (   FarK >= R
    ->  Place = K
    ;   FarH =< R
    ->  Place = inside
    ;   C = X0-Y0,
        K = XK-YK,
        H = XH-YH,
        DX is XH-XK,
        DY is YH-YK,
        A is DX*DX + DY*DY,
        B is (XK-X0)*DX + (YK-Y0)*DY,
        T is (sqrt(B*B - A*(FarK*FarK - R*R)) - B)/A,
        X is XK + T*DX,
        Y is YK + T*DY,
        Place = X-Y
    ).

%   arc(C, A, B, Places): clockwise about C from A to B, in steps of 5 degrees
%   at most.

arc(X0-Y0, A, B, [at(A)|Places]) :-
    A = XA-YA,
    B = XB-YB,
    Cross is (XA-X0)*(YB-Y0) - (YA-Y0)*(XB-X0),
    Dot is (XA-X0)*(XB-X0) + (YA-Y0)*(YB-Y0),
    Turn0 is atan2(-Cross, Dot),
    (   Turn0 < 0.0
    ->  Turn is Turn0 + 2.0*pi
    ;   Turn = Turn0
    ),
    N is max(1, ceiling(Turn*36.0/pi)),
    Last is N-1,
    findall(at(X-Y),
            ( between(1, Last, I),
              Angle is I*Turn/N,
              X is X0 + (XA-X0)*cos(Angle) + (YA-Y0)*sin(Angle),
              Y is Y0 - (XA-X0)*sin(Angle) + (YA-Y0)*cos(Angle) ),
            Places0),
    append(Places0, [at(B)], Places).
