:- module(sg_shading_circle,
          [ circle_surface/2            % +Term, -Surface
          ]).
:- use_module('../csg/known_surface', [plain_surface/2]).
:- use_module('../primitive/primitive', [primitive_parts/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [append/3, last/2, member/2]).
/** <module> Turnings whose outline is a divided circle: they are smooth as the
sphere or the torus is, inside of which they lie. So are the spheres of
OpenSCAD, which have no poles.
*/

%   So many corners a turn, or sides of half a turn, bend by 30 degrees, which
%   is no crease.

most_bend(12).
most_bend_of_half(6).

%   A place on a circle is so near to it, in parts of its radius.

on_circle(1.0e-9).

%!  circle_surface(+Term, -Surface) is semidet.
%
%   True when the primitive Term, placed, is a turning that says `smooth(true)`,
%   and Surface, as of plain_surface/2, is that of the sphere or the torus on
%   which all its corners lie.

circle_surface(Term, Surface) :-
    round_term(Term, Round),
    primitive_parts(Round, _, [_-Surface0]),
    once(plain_surface(Surface0, Surface)).

round_term(at(Steps,Term), at(Steps,Round)) :-
    round_term(Term, Round).
round_term(named(_,Term), Round) :-
    round_term(Term, Round).
round_term(Term, at([translate(0,0,Z)],Round)) :-
    compound(Term),
    compound_name_arguments(Term, turning, Arguments),
    memberchk(smooth(true), Arguments),
    memberchk(outline(Outline), Arguments),
    \+ memberchk(holes(_), Arguments),
    (   memberchk(angle(Angle), Arguments)
    ->  Angle =:= 360
    ;   true
    ),
    (   memberchk(facets(N), Arguments)
    ->  most_bend(Least),
        N >= Least
    ;   true
    ),
    round_outline(Outline, Z, Round).

%   round_outline(Outline, Z, Round): of half a circle about [0, Z], from pole
%   to pole or from cap to cap; or of a whole one.

round_outline(Outline, Z, sphere(radius(R))) :-
    Outline = [[X1,Low]|Outline1],
    append(Corners, [[X2,High]], Outline1),
    X1 =:= 0,
    X2 =:= 0,
    length(Corners, N),
    most_bend_of_half(Least),
    N >= Least,
    Z is (Low+High)/2.0,
    Corners = [[X,Y]|_],
    R is sqrt(X*X + (Y-Z)*(Y-Z)),
    all_on_circle(Corners, 0, Z, R),
    last(Corners, Corner),
    is_end(Low, [X,Y], Z, R),
    is_end(High, Corner, Z, R).
round_outline(Outline, Z, torus(radius(A),tube(R))) :-
    length(Outline, N),
    most_bend(Least),
    N >= Least,
    foldl(corner_added, Outline, 0-0, SumX-SumZ),
    A is SumX/float(N),
    Z is SumZ/float(N),
    Outline = [[X,Y]|_],
    R is sqrt((X-A)*(X-A) + (Y-Z)*(Y-Z)),
    A > R,
    all_on_circle(Outline, A, Z, R).

corner_added([X,Z], SumX0-SumZ0, SumX-SumZ) :-
    SumX is SumX0+X,
    SumZ is SumZ0+Z.

all_on_circle(Corners, A, Z, R) :-
    on_circle(Part),
    Most is Part*R,
    \+ ( member([X,Y], Corners),
         abs(sqrt((X-A)*(X-A) + (Y-Z)*(Y-Z)) - R) > Most ).

%   is_end(Y, Corner, Z, R): on the axis at Y there is a pole, or a cap that
%   ends in Corner.

is_end(Y, [_,CapY], Z, R) :-
    on_circle(Part),
    (   abs(Y-CapY) =< Part*R
    ->  true
    ;   abs(abs(Y-Z)-R) =< Part*R
    ).
