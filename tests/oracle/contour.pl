:- module(sg_oracle_contour,
          [ contour_pieces/3,           % +S, +Crease, -Pieces
            surface_facings/3          % +S, +Crease, -Facings
          ]).
:- use_module(contour_adjacent,
              [ beside_piece/4, is_point/2, end_rise/4, piece_place/5,
                triangle_facing/3
              ]).
:- use_module(contour_side,
              [current_eye/1, corner_g/4, side_zero/3, towards_eye/4]).
:- use_module(contour_facing, [side_facing/3]).
:- use_module(smooth_sheet,
              [ smooth_sheets/3, smooth_side/3, across_side/3,
                convex_side/2, coarse_triangle/2, curved_triangle/2,
                side_bulges/2, fold_side/2, corner_fan/3, fan_normal/3,
                fan_unit/3, corner_vertex/3, next_corner/2
              ]).
:- use_module('../../rules/store', [screen/5, segment/3, t/6]).
:- use_module('../../rules/vector', [dot_product/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(assoc), [empty_assoc/1, list_to_assoc/2]).
:- use_module(library(lists), [member/2, memberchk/2]).
/** <module> The rule of outlines of smooth surfaces, inside their triangles.

The side of a vertex that a surface turns to the eye is told by g = normal .
direction to the eye, with the normal of the vertex's fan (smooth_sheet.pl).
Along the sides of a curved sheet's triangles g runs linearly, and the outline
goes through its zeros: across a triangle whose corners differ runs one piece.
Zero counts as turned to the eye, so that pieces are connected whatever lies
where.

A side is a chord: at its zero the surface is above it, by a part of the square
of its length that no two sides share, and where the outline runs towards the
eye that would be all one sees of it: hooks. So in the picture a piece begins
and ends on the surface (side_rise/3), but not beside a line that runs through
the sheet, for outline and line meet on the side. Where the sheet ends at a line
in a facet, the surface is above its end, too.

A piece is straight, the surface is not: it may leave a corner of its triangle
outside in the picture that lies on the surface. Then the outline goes by way of
that. What hides lines beside a piece is said in contour_hiding.pl.

A piece that reaches the end of its sheet (a crease, a border, a penetration
line) ends there, at the zero of the side, and what is seen of the line does
too (contour_facing.pl).
Where a smooth surface would bulge at its triangle, which
is of no known surface, it goes to that end of the side at which the triangles
themselves turn from the eye: there the line is outermost in the picture. At an
apex, which has no normal, a piece ends in it.

Of the surface beside an outline one half is nearer the eye. If g is positive
there, the surface bends away from the line of sight; if not, it comes between
the outline and the eye, and hides it, if it is the surface of a solid. Which it
is changes at a cusp: there the picture of the outline turns back. So it is the
picture that tells: a piece has the half with positive g on its left, seen from
outside, and the normal is seen across it, on its right where that half is the
nearer one. Hence what is not hidden never turns back. Which triangles lie
beside a piece and therefore never hide it is said in contour_adjacent.pl.

The outline of a coarse sheet runs along the sides of its triangles, between one
that is turned to the eye and one that is not: that of the smooth surface would
lie visibly inside what is seen of it, and triangles would hide it. So does that
of a polygon that is not flat, where its triangles fold.

What is seen of a sheet that is drawn as smooth ends where its triangles turn
from the eye, too. As a rule a piece runs near; where it is hidden, or the
surface is coarser than it bends, it may not. So such a side stands in for the
outline: it is drawn where no other line is near (hidden_lines.pl).

Sheets that are not curved, cylinders and cones for example, are folded along
straight lines: their outlines are edges, as role.pl finds them. The
kernel c_kernels/picture/contour.c does all this at once.

@see Hertzmann & Zorin 2000, Illustrating smooth surfaces, section 3.
*/

:- set_prolog_flag(optimise, true).

%!  contour_pieces(+S, +Crease, -Pieces) is det.
%
%   Pieces, sorted, are piece(T, I1, F1, I2, F2, Seen, Ts)-Rises for pieces of
%   contour/13 that segment S has in the picture of screen/5: the rule that
%   find_contours/2 follows. Rises, [X1,Y1,X2,Y2], lead from the sides to the
%   surface. Slow.

contour_pieces(S, Crease, Pieces) :-
    contour_context(S, Crease, Context, Acrosses),
    findall(Piece-Rises,
            ( (   member(_-across(Across,Sense), Acrosses),
                  outermost(Context, Across, Piece),
                  \+ is_point(Context, Piece), besides(Context, Piece, Sense)
              ;   piece_along(Context, Piece),
                  \+ is_point(Context, Piece)
              ),
              piece_rises(Context, Piece, Rises)
            ),
            Pieces0),
    sort(Pieces0, Pieces).

piece_rises(Context, piece(T,I1,F1,I2,F2,_,_), [X1,Y1,X2,Y2]) :-
    end_rise(Context, T-I1, F1, X1-Y1),
    end_rise(Context, T-I2, F2, X2-Y2).

%   outermost(Context, Across, Piece): Piece is Across as it is or, if
%   that leaves a corner outside, each of the two that go by way of it.

outermost(Context, Across, Piece) :-
    Across = piece(T, I1, F1, I2, F2, Seen, _),
    arg(2, Context, Sheets),
    (   leaves_outside(Context, Across, Corner)
    ->  (   corner_on_side(Sheets, T-I2, Corner, F),
            Piece = piece(T, I1, F1, I2, F, Seen, _)
        ;   corner_on_side(Sheets, T-I1, Corner, F),
            Piece = piece(T, I1, F, I2, F2, Seen, _)
        )
    ;   Piece = Across
    ).

%   In the picture a piece on the surface leaves the corner that it parts from
%   the others outside: on its right, for the surface is seen on its left,
%   whichever half is the nearer one; and with the ends more than a right angle
%   apart.

leaves_outside(Context, Piece, Corner) :-
    Piece = piece(T, I1, F1, I2, F2, _, _),
    piece_rises(Context, Piece, Rises),
    once(( member(Rise, Rises), Rise =\= 0.0 )),
    parted_corner(T, I1, I2, Corner),
    Context = context(S, Sheets, _, _, _),
    corner_vertex(Sheets, Corner, V),
    screen(S, V, X, Y, _),
    piece_place(Context, T, I1, F1, X1-Y1),
    piece_place(Context, T, I2, F2, X2-Y2),
    Apart is (X1-X)*(X2-X) + (Y1-Y)*(Y2-Y),
    Apart < 0.0,
    (X1-X)*(Y2-Y) - (Y1-Y)*(X2-X) < 1.0e-9*Apart.

parted_corner(T, I1, I2, Corner) :-
    (   next_corner(T-I2, T-I1)
    ->  Corner = T-I1
    ;   Corner = T-I2
    ).

%!  surface_facings(+S, +Crease, -Facings) is det.
%
%   Facings, sorted, are facing(T, I, From, To, Ts) for the rows of
%   surface_facing/6 of segment S in the picture of screen/5. The rule that
%   find_contours/2 follows. Slow.

surface_facings(S, Crease, Facings) :-
    contour_context(S, Crease, Context, _),
    Context = context(_, Sheets, _, _, _),
    findall(Facing,
            ( curved_triangle(Sheets, T), member(I, [1,2,3]),
              side_facing(Context, T-I, Facing) ),
            Facings0),
    sort(Facings0, Facings).

%   contour_context(S, Crease, Context, Acrosses): Context is context(S, Sheets,
%   Eye, Gs, Found), how the segment lies to the eye: its sheets, the g of their
%   fans, and the pieces across triangles, T -> across(Piece, Sense), which
%   Acrosses lists.

contour_context(S, Crease, Context, Acrosses) :-
    smooth_sheets(S, Crease, Sheets),
    current_eye(Eye),
    findall(T, curved_triangle(Sheets, T), Ts),
    fan_values(towards_eye(Sheets, Eye), Sheets, Ts, Gs),
    empty_assoc(None),
    findall(T-Across,
            ( member(T, Ts), \+ coarse_triangle(Sheets, T),
              piece_across(context(S,Sheets,Eye,Gs,None), T, Across) ),
            Acrosses),
    list_to_assoc(Acrosses, Found),
    Context = context(S, Sheets, Eye, Gs, Found).

%   piece_along(Context, Piece): a side between a triangle that is turned to the
%   eye and one that is not, which is an outline.

piece_along(Context, piece(T,I,0.0,I,1.0,Seen,Ts)) :-
    Context = context(S, Sheets, _, _, _),
    t(S, _, T, _, _, _),
    member(I, [1,2,3]),
    across_side(Sheets, T-I, T2-I2),
    T-I @< T2-I2,
    triangle_facing(S, T, Facing),
    triangle_facing(S, T2, Facing2),
    once(( Facing > 0, Facing2 =< 0 ; Facing =< 0, Facing2 > 0 )),
    is_outline(Context, T-I, Seen),
    sort([T,T2], Ts).

%   Of a coarse sheet every smooth side, of others the folds of polygons; of one
%   that is drawn as smooth what stands in.

is_outline(Context, T-I, Seen) :-
    Context = context(_, Sheets, _, _, _),
    (   \+ curved_triangle(Sheets, T)
    ->  Seen = visible,
        fold_side(Sheets, T-I)
    ;   coarse_triangle(Sheets, T)
    ->  Seen = visible,
        smooth_side(Sheets, T-I, _)
    ;   Seen = substitute,
        substitute_outline(Context, T-I)
    ).

%   Where a smooth surface would bulge at one of the two triangles. Of a solid
%   only where the surface bends down, for else its own triangles hide it.

substitute_outline(Context, T-I) :-
    Context = context(S, Sheets, _, _, _),
    smooth_side(Sheets, T-I, T2-_),
    (   is_solid(S)
    ->  convex_side(Sheets, T-I)
    ;   true
    ),
    once(( member(Bulging, [T,T2]), member(J, [1,2,3]),
           side_bulges(Sheets, Bulging-J) )).

%   What its own surface hides has nothing beside it.

besides(Context, Piece, Sense) :-
    Piece = piece(_,_,_,_,_,Seen,Ts),
    (   Seen \== hidden
    ->  beside_piece(Context, Piece, Sense, Ts)
    ;   Ts = []
    ).

%   Values: Fan -> the value that Goal gives for each fan of triangles Ts.

:- meta_predicate fan_values(2, +, +, -).

fan_values(Goal, Sheets, Ts, Values) :-
    findall(Fan, ( member(T, Ts), member(I, [1,2,3]),
                   corner_fan(Sheets, T-I, Fan) ),
            Fans0),
    sort(Fans0, Fans),
    findall(Fan-Value, ( member(Fan, Fans), call(Goal, Fan, Value) ), Pairs),
    list_to_assoc(Pairs, Values).

%   piece_across(Context, T, across(Piece, Sense)): Piece has what is turned to
%   the eye on its left, seen from outside. Sense is 1 if that half of the
%   surface beside it is the nearer one, -1 if the other is. What lies beside it
%   is left open.

piece_across(Context, T, across(Piece,Sense)) :-
    Piece = piece(T, I1, F1, I2, F2, Seen, _),
    findall(End, piece_end(Context, T, End), Ends0),
    (   Ends0 = [_,_]
    ->  Ends = Ends0
    ;   Ends0 = [end(Sign,_,_)],
        apex_end(Context, T, I, F),
        Other is -Sign,
        Ends = [end(Other,I,F)|Ends0]
    ),
    memberchk(end(1,I1,F1), Ends),
    memberchk(end(-1,I2,F2), Ends),
    sense(Context, Piece, Sense),
    Context = context(S, _, _, _, _),
    (   ( Sense =:= 1 ; \+ is_solid(S) )
    ->  Seen = visible
    ;   Seen = hidden
    ).

%   The line of sight is a tangent, so the normal is seen across the piece: on
%   its right, if the half that is turned to the eye is the nearer one.

sense(Context, piece(T,I1,F1,I2,F2,_,_), Sense) :-
    Context = context(_, Sheets, eye(_,_,_,Right,Up), _, _),
    findall(X-Y,
            ( member(I, [1,2,3]), corner_fan(Sheets, T-I, Fan),
              fan_unit(Sheets, Fan, Normal),
              dot_product(Normal, Right, X), dot_product(Normal, Up, Y) ),
            Normals),
    foldl(added, Normals, 0.0-0.0, X-Y),
    piece_place(Context, T, I1, F1, X1-Y1),
    piece_place(Context, T, I2, F2, X2-Y2),
    (   (X2-X1)*Y - (Y2-Y1)*X > 0.0
    ->  Sense = -1
    ;   Sense = 1
    ).

added(X1-Y1, X0-Y0, X-Y) :-
    X is X0+X1,
    Y is Y0+Y1.

%   end(Sign,I,F): on a side whose corners differ; Sign is that of the first.

piece_end(Context, T, end(Sign,I,F)) :-
    Context = context(_, Sheets, _, Gs, _),
    member(I0, [1,2,3]),
    next_corner(T-I0, T-J0),
    corner_g(Sheets, Gs, T-I0, G),
    corner_g(Sheets, Gs, T-J0, H),
    sign_of(G, Sign),
    sign_of(H, Other),
    Sign =\= Other,
    (   ends_at_corner(Sheets, T-I0)
    ->  outermost(Context, T, I0-Sign, J0-Other, I),
        corner_on_side(Sheets, T-I, F)
    ;   I = I0,
        side_zero(Context, T-I0, F)
    ).

%   Where the sheet ends and a smooth surface would bulge.

ends_at_corner(Sheets, T-I) :-
    \+ smooth_side(Sheets, T-I, _),
    member(J, [1,2,3]),
    side_bulges(Sheets, T-J),
    !.

%   The corner that is turned the other way than its triangle.

outermost(context(S,_,_,_,_), T, I1-Sign1, I2-_, I) :-
    triangle_facing(S, T, Facing),
    (   Facing < 0
    ->  Wanted = 1
    ;   Wanted = -1
    ),
    (   Sign1 =:= Wanted
    ->  I = I1
    ;   I = I2
    ).

sign_of(G, Sign) :-
    (   G >= 0.0
    ->  Sign = 1
    ;   Sign = -1
    ).

apex_end(context(_,Sheets,_,_,_), T, I, F) :-
    last_apex(Sheets, T, I),
    corner_on_side(Sheets, T-I, F).

last_apex(Sheets, T, I) :-
    member(I, [3,2,1]),
    corner_fan(Sheets, T-I, Fan),
    \+ fan_normal(Sheets, Fan, _),
    !.

%   Side I begins at corner I.

corner_on_side(Sheets, Corner, F) :-
    corner_on_side(Sheets, Corner, Corner, F).

%   corner_on_side(Sheets, Side, Corner, F): F is 0 at Corner, an end of Side,
%   if its vertex is the smaller one, else 1.

corner_on_side(Sheets, Side, Corner, F) :-
    next_corner(Side, Next),
    (   Corner == Side
    ->  Other = Next
    ;   Other = Side
    ),
    corner_vertex(Sheets, Corner, V),
    corner_vertex(Sheets, Other, W),
    (   V < W
    ->  F = 0.0
    ;   F = 1.0
    ).

%   A solid with a border, or inside out, is none.

is_solid(S) :-
    segment(S, solid, _).
