:- module(sg_oracle_contour_beside,
          [ beside_piece/4,             % +Context, +Piece, +Sense, -Ts
            is_point/2,                 % +Context, +Piece
            end_rise/4,                 % +Context, +Side, +F, -Rise
            piece_place/5,              % +Context, +T, +I, +F, -Place
            triangle_kind/4,            % +Context, +Sense, +T, -Kind
            triangle_facing/3           % +S, +T, -Facing
          ]).
:- use_module(contour_side, [side_rise/3]).
:- use_module('../../rules/picture/contour', [side_place/5]).
:- use_module(smooth_sheet,
              [ smooth_side/3, across_side/3, convex_side/2, curved_triangle/2,
                corner_fan/3, corner_vertex/3, next_corner/2,
                fan_unit/3
              ]).
:- use_module('../../rules/vector', [dot_product/3]).
:- use_module('../../rules/store', [screen/5, t/6]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists), [append/3, member/2, memberchk/2, sum_list/2]).
/** <module> Which triangles lie beside a piece of an outline.

To a smooth surface the line of sight is a tangent at its outline; to its
triangles it is none, and those next to a piece may lie before it. Which these
are is a walk from the piece's triangle, over the strip of the picture that the
piece sweeps across its direction. It goes on to a neighbour

  - across a smooth side, or one at which the neighbour lies below,
  - unless the neighbour is turned from the eye, with all its corners, or has a
    piece whose other half is the nearer one,
  - from a triangle that is turned to the eye, with all its corners, only where
    that side lies outside the piece or touches it; from others wherever the
    side lies in the strip.

Seen from the other side, where the half that is turned from the eye is the
nearer one, towards and away change places.

@see contour.pl
*/

:- set_prolog_flag(optimise, true).

%!  beside_piece(+Context, +Piece, +Sense, -Ts) is det.
%
%   Ts, sorted, are the triangles beside Piece. Context, of contour.pl, says how
%   the segment lies to the eye; Sense is 1 if the half of the surface beside
%   Piece that is turned to the eye is the nearer one, else -1.

beside_piece(Context, Piece, Sense, Ts) :-
    piece_strip(Context, Piece, Sense, Strip),
    arg(1, Piece, T),
    walk([T], Context, Strip, [T], Ts0),
    msort(Ts0, Ts).

walk([], _, _, Seen, Seen).
walk([T|Ts], Context, Strip, Seen0, Seen) :-
    findall(T2,
            ( member(I, [1,2,3]), goes_on(Context, Strip, T-I, T2),
              \+ memberchk(T2, Seen0) ),
            Found0),
    sort(Found0, Found),
    append(Found, Seen0, Seen1),
    append(Ts, Found, Next),
    walk(Next, Context, Strip, Seen1, Seen).

goes_on(Context, Strip, T-I, T2) :-
    Context = context(_, Sheets, _, _, _),
    Strip = strip(_, _, _, _, Sense),
    across_side(Sheets, T-I, T2-_),
    (   smooth_side(Sheets, T-I, _)
    ->  true
    ;   below(Sheets, T-I, Sense)
    ),
    triangle_kind(Context, Sense, T2, Kind2),
    Kind2 \== away,
    \+ ( piece_sense(Context, T2, Sense2), Sense2*Sense < 0 ),
    side_outmost(Context, Strip, T-I, Outmost, Same),
    (   triangle_kind(Context, Sense, T, towards)
    ->  Outmost > -Same
    ;   true
    ).

below(Sheets, Side, Sense) :-
    (   convex_side(Sheets, Side)
    ->  Sense > 0
    ;   Sense < 0
    ).

piece_sense(context(_,_,_,_,Found), T, Sense) :-
    get_assoc(T, Found, across(_, Sense)).

/* - - - how triangles lie to the eye - - - */

%!  triangle_kind(+Context, +Sense, +T, -Kind) is det.
%
%   Kind is `towards`, `away` or `mixed`: how triangle T and its corners lie to
%   the eye, seen from the side of the surface that Sense says.

triangle_kind(Context, Sense, T, Kind) :-
    Context = context(S, Sheets, _, Gs, _),
    triangle_facing(S, T, Facing),
    findall(Sign, corner_sign(Sheets, Gs, T, Sign), Signs),
    (   Facing > 0,
        \+ memberchk(-1, Signs)
    ->  Own = towards
    ;   Facing < 0,
        \+ memberchk(1, Signs)
    ->  Own = away
    ;   Own = mixed
    ),
    seen_from(Sense, Own, Kind).

seen_from(Sense, Own, Kind) :-
    (   Sense < 0
    ->  turned_over(Own, Kind)
    ;   Kind = Own
    ).

turned_over(towards, away).
turned_over(away, towards).
turned_over(mixed, mixed).

corner_sign(Sheets, Gs, T, Sign) :-
    curved_triangle(Sheets, T),
    member(I, [1,2,3]),
    corner_fan(Sheets, T-I, Fan),
    get_assoc(Fan, Gs, G),
    (   G >= 0.0
    ->  Sign = 1
    ;   Sign = -1
    ).

%!  triangle_facing(+S, +T, -Facing) is det.
%
%   Facing is 1 if triangle T is turned to the eye in the picture, -1 if it is
%   turned from it, 0 if it is seen edge-on.

triangle_facing(S, T, Facing) :-
    t(S, _, T, A, B, C),
    screen(S, A, X1, Y1, Z1),
    screen(S, B, X2, Y2, Z2),
    screen(S, C, X3, Y3, Z3),
    X is (Y2-Y1)*(Z3-Z1) - (Z2-Z1)*(Y3-Y1),
    Y is (Z2-Z1)*(X3-X1) - (X2-X1)*(Z3-Z1),
    Z is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1),
    Edge is 1.0e-9*sqrt(X*X + Y*Y + Z*Z),
    (   Z > Edge
    ->  Facing = 1
    ;   Z < -Edge
    ->  Facing = -1
    ;   Facing = 0
    ).

/* - - - the strip - - - */

%   strip(From, Along, Outward, Length, Sense): From, X-Y, is where the piece
%   starts, Along points to its end, Outward the way the surface looks.

piece_strip(Context, piece(T,I1,F1,I2,F2,_,_), Sense,
            strip(X1-Y1,AX-AY,OX-OY,Length,Sense)) :-
    Context = context(_, Sheets, Eye, _, _),
    piece_place(Context, T, I1, F1, Start),
    piece_place(Context, T, I2, F2, End),
    Start = X1-Y1,
    End = X2-Y2,
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    AX is (X2-X1)/Length,
    AY is (Y2-Y1)/Length,
    findall(Lean, ( member(I, [1,2,3]),
                    normal_lean(Sheets, Eye, T-I, -AY, AX, Lean) ),
            Leans),
    sum_list(Leans, Sum),
    (   Sum*Sense >= 0.0
    ->  OX is -AY,
        OY is AX
    ;   OX is AY,
        OY is -AX
    ).

normal_lean(Sheets, eye(_,_,_,Right,Up), Corner, X, Y, Lean) :-
    corner_fan(Sheets, Corner, Fan),
    fan_unit(Sheets, Fan, Normal),
    dot_product(Normal, Right, NX),
    dot_product(Normal, Up, NY),
    Lean is X*NX + Y*NY.

%   How far out a side comes in the strip; fails if it is not in it.

side_outmost(context(S,Sheets,_,_,_), strip(From,Along,Outward,Length,_),
             Corner, Outmost, Same) :-
    next_corner(Corner, Next),
    maplist(strip_place(S, Sheets, From, Along, Outward), [Corner,Next],
            [U1-H1, U2-H2]),
    Same is 1.0e-9*Length,
    Least is -Same,
    Most is Length+Same,
    max(U1, U2) >= Least,
    min(U1, U2) =< Most,
    height_within(U1-H1, U2-H2, Least, Most, HA),
    height_within(U2-H2, U1-H1, Least, Most, HB),
    Outmost is max(HA, HB).

height_within(U1-H1, U2-H2, Least, Most, H) :-
    U is min(max(U1, Least), Most),
    (   U =:= U1
    ->  H = H1
    ;   H is H1 + (U-U1)/(U2-U1)*(H2-H1)
    ).

strip_place(S, Sheets, X0-Y0, AX-AY, OX-OY, Corner, U-H) :-
    corner_vertex(Sheets, Corner, V),
    screen(S, V, X, Y, _),
    U is (X-X0)*AX + (Y-Y0)*AY,
    H is (X-X0)*OX + (Y-Y0)*OY.

%!  is_point(+Context, +Piece) is semidet.
%
%   True when Piece begins and ends in one place of the picture.

is_point(Context, piece(T,I1,F1,I2,F2,_,_)) :-
    piece_place(Context, T, I1, F1, Place1),
    piece_place(Context, T, I2, F2, Place2),
    Place1 == Place2.

%!  piece_place(+Context, +T, +I, +F, -Place) is det.
%
%   Place, X-Y of the picture, is where a piece across triangle T, or along its
%   side I, begins or ends, at F of that side: on the smooth surface, if F is
%   within the side (side_rise/3).

piece_place(Context, T, I, F, X-Y) :-
    arg(1, Context, S),
    t(S, _, T, A, B, C),
    side_place(S, t(A,B,C,A), I, F, X0-Y0),
    end_rise(Context, T-I, F, DX-DY),
    X is X0+DX,
    Y is Y0+DY.

%!  end_rise(+Context, +Side, +F, -Rise) is det.
%
%   Rise is that of a piece that begins or ends at F of Side: none at its ends.

end_rise(Context, Side, F, Rise) :-
    (   ( F =:= 0.0 ; F =:= 1.0 )
    ->  Rise = 0.0-0.0
    ;   side_rise(Context, Side, Rise)
    ).
