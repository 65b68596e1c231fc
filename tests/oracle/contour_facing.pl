:- module(sg_oracle_contour_facing,
          [ side_facing/3               % +Context, +Side, -Facing
          ]).
:- use_module(contour_adjacent,
              [ beside_piece/4, is_point/2, triangle_facing/3,
                triangle_kind/4
              ]).
:- use_module(contour_side, [corner_g/4, side_zero/3, to_eye/3]).
:- use_module(smooth_sheet,
              [ smooth_side/3, cut_side/3, across_side/3, convex_side/2,
                curved_triangle/2, coarse_triangle/2, side_bulges/2,
                corner_fan/3,
                fan_normal/3, fan_unit/3, corner_vertex/3, corner_place/3,
                next_corner/2
              ]).
:- use_module('../../rules/store', [screen/5, segment/3]).
:- use_module('../../rules/vector', [difference/3, dot_product/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists), [member/2, sum_list/2]).
/** <module> Lines that a smooth surface turns otherwise than its triangles.

Lines on a smooth surface (creases, penetration lines, borders) are turned to
the eye, or from it, as the surface is, not as the triangles are that stand for
it. Where both say the same of a side nothing is told of it, nor where a smooth
surface would bulge at its triangle, which is of no known surface. Else it has a
*facing*, which says what the surface hides of the line: the part under whose
surface the eye is (g < 0),

  - of a solid, if the other face goes down from the line, only where the eye is
    under that, too, for there it is inside; if that goes up, all of the line if
    the eye is under that everywhere;
  - of an open surface only if its triangle runs from the line towards the eye,
    and the other face, if it goes down, has the eye under it.

The rest is not hidden by what is beside it, found as for a piece of an outline.
So what is seen of a line ends where the outline does.

If the surface bends towards the line of sight (the half with g < 0 is nearer),
the back of an open one is what is seen, and over and under change places; a
solid hides the line on both sides of the outline with its triangles, and
nothing is told of it.

The fused kernel is c_kernels/picture/contour_facing.c.

@see contour.pl
*/

:- set_prolog_flag(optimise, true).

%!  side_facing(+Context, +Side, -Facing) is semidet.
%
%   Facing is facing(T, I, From, To, Ts), the row of surface_facing/6 that
%   Side, T-I, has. Context is of contour.pl.

side_facing(Context, T-I, facing(T,I,From,To,Ts)) :-
    Context = context(S, Sheets, _, _, _),
    triangle_kind(Context, 1, T, mixed),
    line_runs(S, Sheets, T-I),
    stands_for_surface(Sheets, T-I),
    surface_sense(Context, T, Sense),
    \+ ( Sense < 0, is_solid(S) ),
    under_surface(Context, T-I, Sense, Surface),
    under_triangle(S, T, Sense, Triangle),
    Surface \== Triangle,
    hidden_part(Context, T-I, Sense, Surface, From-To),
    beside_seen(Context, T-I, Sense, From-To, Ts).

line_runs(S, Sheets, Side) :-
    (   smooth_side(Sheets, Side, _)
    ->  cut_side(S, Sheets, Side)
    ;   true
    ).

%   Triangle T stands for a smooth surface along side T-I.

stands_for_surface(Sheets, T-I) :-
    curved_triangle(Sheets, T),
    \+ coarse_triangle(Sheets, T),
    \+ ( member(J, [1,2,3]), side_bulges(Sheets, T-J) ),
    next_corner(T-I, Next),
    has_normal(Sheets, T-I),
    has_normal(Sheets, Next).

has_normal(Sheets, Corner) :-
    corner_fan(Sheets, Corner, Fan),
    fan_normal(Sheets, Fan, _).

is_solid(S) :-
    segment(S, solid, _).

/* - - - under what the eye is: From-To, counted as in contour/13 - - - */

under_surface(Context, Side, Sense, Part) :-
    next_corner(Side, Next),
    corner_under(Context, Side, Sense, V, Under),
    corner_under(Context, Next, Sense, W, Under2),
    (   Under == Under2
    ->  whole_part(Under, Part)
    ;   side_zero(Context, Side, Zero),
        (   ( V < W -> Low = Under ; Low = Under2 ),
            Low == true
        ->  Part = 0.0-Zero
        ;   Part = Zero-1.0
        )
    ).

corner_under(context(_,Sheets,_,Gs,_), Corner, Sense, V, Under) :-
    corner_vertex(Sheets, Corner, V),
    corner_g(Sheets, Gs, Corner, G),
    (   Sense*G < 0.0
    ->  Under = true
    ;   Under = false
    ).

whole_part(true,  0.0-1.0).
whole_part(false, 0.0-0.0).

under_triangle(S, T, Sense, Part) :-
    triangle_facing(S, T, Facing),
    (   Sense*Facing > 0
    ->  whole_part(false, Part)
    ;   whole_part(true, Part)
    ).

under(Context, T-I, Sense, Part) :-
    Context = context(S, Sheets, _, _, _),
    (   stands_for_surface(Sheets, T-I)
    ->  under_surface(Context, T-I, Sense, Part)
    ;   under_triangle(S, T, Sense, Part)
    ).

/* - - - what is hidden of a side that the eye is under in a part - - - */

hidden_part(Context, Side, Sense, Surface, Hidden) :-
    Context = context(S, Sheets, Eye, _, _),
    (   is_solid(S),
        across_side(Sheets, Side, Across)
    ->  hidden_of_solid(Context, Side, Across, Surface, Hidden)
    ;   \+ runs_to_eye(Sheets, Eye, Side)
    ->  whole_part(false, Hidden)
    ;   across_side(Sheets, Side, Across),
        goes_down(Sheets, Side, Sense)
    ->  under(Context, Across, Sense, Other),
        common(Surface, Other, Hidden)
    ;   Hidden = Surface
    ).

%   If the other face goes up, and its triangle is not turned away, or only in a
%   part, it has a facing of its own, or hides nothing.

hidden_of_solid(Context, Side, T2-I2, Surface, Hidden) :-
    Context = context(S, Sheets, _, _, _),
    under(Context, T2-I2, 1, Other),
    (   convex_side(Sheets, Side)
    ->  common(Surface, Other, Hidden)
    ;   Other == 0.0-1.0,
        triangle_facing(S, T2, Facing),
        Facing < 0
    ->  Hidden = Other
    ;   Hidden = Surface
    ).

goes_down(Sheets, Side, Sense) :-
    (   convex_side(Sheets, Side)
    ->  Sense > 0
    ;   Sense < 0
    ).

common(A-B, C-D, Part) :-
    From is max(A, C),
    To is min(B, D),
    (   From < To
    ->  Part = From-To
    ;   whole_part(false, Part)
    ).

/* - - - the surface about a side - - - */

%   surface_sense(Context, T, Sense): 1 if the half of the surface with positive
%   g is nearer, -1 if the other is; of a piece across T, or by how g grows
%   across the picture (times twice the area of T there, negative if T is turned
%   away), against the way the surface looks. 1 at an apex, and where T is too
%   thin to tell.

surface_sense(Context, T, Sense) :-
    Context = context(S, Sheets, eye(_,_,_,Right,Up), Gs, Found),
    (   get_assoc(T, Found, across(_, Sense0))
    ->  Sense = Sense0
    ;   member(I, [1,2,3]),
        \+ has_normal(Sheets, T-I)
    ->  Sense = 1
    ;   normals_along(Sheets, T, Right, X),
        normals_along(Sheets, T, Up, Y),
        findall(Term, grown(S, Sheets, Gs, T, X-Y, Term), Terms),
        sum_list(Terms, Sum),
        aggregate_all(sum(abs(Term)), member(Term, Terms), Size),
        (   Sum > 0.01*Size
        ->  Sense = -1
        ;   Sense = 1
        )
    ).

grown(S, Sheets, Gs, T, X-Y, Term) :-
    member(I, [1,2,3]),
    corner_g(Sheets, Gs, T-I, G),
    next_corner(T-I, Next),
    next_corner(Next, Last),
    corner_seen(S, Sheets, Next, XP, YP),
    corner_seen(S, Sheets, Last, XQ, YQ),
    Term is G*((YP-YQ)*X - (XP-XQ)*Y).

normals_along(Sheets, T, Axis, Sum) :-
    aggregate_all(sum(Along),
                  ( member(I, [1,2,3]), corner_fan(Sheets, T-I, Fan),
                    fan_unit(Sheets, Fan, Normal),
                    dot_product(Normal, Axis, Along) ),
                  Sum).

corner_seen(S, Sheets, Corner, X, Y) :-
    corner_vertex(Sheets, Corner, V),
    screen(S, V, X, Y, _).

%   The triangle runs from its side towards the eye.

runs_to_eye(Sheets, Eye, Side) :-
    next_corner(Side, Next),
    next_corner(Next, Last),
    corner_place(Sheets, Side, P),
    corner_place(Sheets, Next, Q),
    corner_place(Sheets, Last, Apex),
    difference(Q, P, Along),
    difference(Apex, P, In),
    P = p(X,Y,Z),
    Along = p(U,V,W),
    MX is X + U/2.0,
    MY is Y + V/2.0,
    MZ is Z + W/2.0,
    to_eye(Eye, p(MX,MY,MZ), Direction),
    dot_product(In, Direction, InEye),
    dot_product(Along, Along, Square),
    dot_product(In, Along, InAlong),
    dot_product(Along, Direction, AlongEye),
    InEye*Square > InAlong*AlongEye.

/* - - - what does not hide the rest - - - */

%   beside_seen(Context, Side, Sense, Hidden, Ts): Ts, sorted, are beside what
%   is not hidden; if that is in two parts, beside all of it.

beside_seen(Context, T-I, Sense, From-To, Ts) :-
    (   From =:= 0.0
    ->  F1 = To,
        F2 = 1.0
    ;   To =:= 1.0
    ->  F1 = 0.0,
        F2 = From
    ;   F1 = 0.0,
        F2 = 1.0
    ),
    Piece = piece(T, I, F1, I, F2, 1.0, _),
    (   is_point(Context, Piece)
    ->  Ts = []
    ;   beside_piece(Context, Piece, Sense, Ts)
    ).
