:- module(sg_true_resized,
          [ term_enlarged/3,            % +Term, +By, -Enlarged
            transition_resized/3,       % +Term, +By, -Resized
            transition_parts_as/3,      % +Term, +Term0, -Term1
            outline_area/2              % +Corners, -Area
          ]).
:- use_module('../primitive/primitive', [primitive_faces/3]).
:- use_module('../primitive/primitive_pipe', [is_mitred/1]).
:- use_module(true_surface, [offset_surface/3]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/5]).
:- use_module(library(lists),
              [append/3, last/2, member/2, same_length/2, select/3]).
/** <module> Primitives whose other sides are primitives too.

What lies everywhere at one distance from a right circular cylinder or cone, a
sphere or a round torus is such a one, and so are pipes that meet in mitres; a
transition is measured by its outlines. Others: true_parallel.pl, true_flat.pl.
*/

%!  term_enlarged(+Term, +By, -Enlarged) is semidet.
%
%   Enlarged is the primitive Term, as placed By larger all round (model units;
%   smaller if negative). Fails if that is no primitive.

term_enlarged(Term, By, Enlarged) :-
    (   By =:= 0
    ->  Enlarged = Term
    ;   transition_resized(Term, By, Enlarged)
    ->  true
    ;   is_mitred(Term)
    ->  primitive_faces(Term, _, [_-Surface|_]),
        offset_surface(Surface, By, Offset),
        term_resized(Term, Surface, Offset, Enlarged)
    ;   primitive_faces(Term, _, [_-Surface]),
        offset_surface(Surface, By, Offset),
        term_resized(Term, Surface, Offset, Enlarged)
    ).

%   term_resized(Term0, Surface, Offset, Term): only sizes change; so the
%   numbers of vertices, edges and polygons are the same.

term_resized(at(Steps, Term0), Surface, Offset, at(Steps, Term)) :-
    !,
    term_resized(Term0, Surface, Offset, Term).
term_resized(named(Name, Term0), Surface, Offset, named(Name, Term)) :-
    !,
    term_resized(Term0, Surface, Offset, Term).
term_resized(Term0, Surface, Offset, Term) :-
    Term0 =.. [Name|Arguments0],
    arg(2, Surface, vector(A, B, C)),
    arg(2, Offset, vector(A1, B1, C1)),
    F is sqrt((A1*A1 + B1*B1 + C1*C1)/(A*A + B*B + C*C)),
    arguments_resized(Name, F, Offset, Arguments0, Arguments),
    Term =.. [Name|Arguments].

arguments_resized(cylinder, F, _, Arguments0, Arguments) :-
    enlarged(radius, F, _, Arguments0, Arguments).
arguments_resized(Name, F, _, Arguments0, Arguments) :-
    memberchk(Name, [elbow,mitred_pipe,wye]),
    enlarged(diameter, F, _, Arguments0, Arguments).
arguments_resized(Name, F, _, Arguments0, Arguments) :-
    memberchk(Name, [sphere,hemisphere]),
    enlarged(radius, F, _, Arguments0, Arguments).
arguments_resized(torus, _, torus(_, _, _, _, K), Arguments0,
                  [tube(Tube)|Arguments]) :-
    select(tube(_), Arguments0, Arguments),
    member(radius(R), Arguments),
    Tube is R*K.
arguments_resized(cone, F, cone(_, _, _, _, K), Arguments0, Arguments) :-
    enlarged(radius, F, R, Arguments0, Arguments1),
    (   select(top(_), Arguments1, Arguments2)
    ->  true
    ;   Arguments2 = Arguments1
    ),
    (   K >= 0.0
    ->  Top is R*K,
        Arguments = [top(Top)|Arguments2]
    ;   Up is 1.0/(1.0-K),
        enlarged(height, Up, _, Arguments2, Arguments)
    ).

enlarged(Name, F, Size, Arguments0, [Argument|Arguments]) :-
    Argument0 =.. [Name,Size0],
    select(Argument0, Arguments0, Arguments),
    Size is Size0*F,
    Argument =.. [Name,Size].


                /*******************************
                *         TRANSITIONS          *
                *******************************/

%!  transition_resized(+Term, +By, -Resized) is semidet.
%
%   Resized is Term, a transition, with outlines By larger all round (smaller if
%   negative), each in its plane. Fails if it is none, or nothing is left.

transition_resized(at(Steps, Term0), By, at(Steps, Term)) :-
    transition_resized(Term0, By, Term).
transition_resized(named(Name, Term0), By, named(Name, Term)) :-
    transition_resized(Term0, By, Term).
transition_resized(Term0, By, Term) :-
    Term0 =.. [Name|Arguments0],
    memberchk(Name, [transition,open_transition]),
    maplist(argument_resized(By), Arguments0, Arguments),
    Term =.. [Name|Arguments].

%!  transition_parts_as(+Term, +Term0, -Term1) is det.
%
%   Term1 is Term0, which is Term, a transition, resized, of the same parts.

transition_parts_as(at(_, Term), at(Steps, Term0), at(Steps, Term1)) :-
    !,
    transition_parts_as(Term, Term0, Term1).
transition_parts_as(named(_, Term), named(Name, Term0), named(Name, Term1)) :-
    !,
    transition_parts_as(Term, Term0, Term1).
transition_parts_as(Term, Term0, Term1) :-
    Term =.. [_|Arguments],
    memberchk(base(Base), Arguments),
    memberchk(top(Top), Arguments),
    Term0 =.. [Name|Arguments0],
    Term1 =.. [Name,as(Base, Top)|Arguments0].

argument_resized(By, base(Outline0), base(Outline)) :-
    !,
    outline_resized(Outline0, By, Outline).
argument_resized(By, top(Outline0), top(Outline)) :-
    !,
    outline_resized(Outline0, By, Outline).
argument_resized(_, Argument, Argument).

outline_resized(circle(R0), By, circle(R)) :-
    larger(R0, By, R).
outline_resized(ellipse(A0, B0), By, ellipse(A, B)) :-
    larger(A0, By, A),
    larger(B0, By, B).
outline_resized(rectangle(A0, B0), By, rectangle(A, B)) :-
    larger(A0, 2.0*By, A),
    larger(B0, 2.0*By, B).
outline_resized(rectangle(A0, B0, R0), By, rectangle(A, B, R)) :-
    larger(A0, 2.0*By, A),
    larger(B0, 2.0*By, B),
    larger(R0, By, R).
outline_resized(polygon(Corners0), By, polygon(Corners)) :-
    polygon_resized(Corners0, By, Corners).

larger(Size0, By, Size) :-
    Size is Size0+By,
    Size > 0.0.

%   polygon_resized(Corners0, By, Corners): where its edges meet when they are
%   moved outward; none may turn round.

polygon_resized(Corners0, By0, Corners) :-
    outline_area(Corners0, Area),
    By is By0*sign(Area),
    last(Corners0, Last),
    Corners0 = [First|_],
    append([Last|Corners0], [First], Round),
    findall([X,Y],
            ( append(_, [P,Q,R|_], Round),
              corner_resized(P, Q, R, By, X, Y) ),
            Corners),
    same_length(Corners0, Corners),
    edges_kept(Corners0, Corners).

%!  outline_area(+Corners, -Area) is det.
%
%   Area is that within Corners, [X,Y] each; negative if they run clockwise.

outline_area(Corners, Area) :-
    last(Corners, Last),
    foldl(trapezoid, Corners, Last-0, _-Twice),
    Area is Twice/2.0.

trapezoid([X,Y], [X0,Y0]-Area0, [X,Y]-Area) :-
    Area is Area0 + X0*Y - X*Y0.

corner_resized([X1,Y1], [X2,Y2], [X3,Y3], By, X, Y) :-
    UX is X2-X1,
    UY is Y2-Y1,
    WX is X3-X2,
    WY is Y3-Y2,
    U is sqrt(UX*UX + UY*UY),
    W is sqrt(WX*WX + WY*WY),
    Cross is UX*WY - UY*WX,
    Cross =\= 0,
    X is X2 + By*(UX*W - WX*U)/Cross,
    Y is Y2 + By*(UY*W - WY*U)/Cross.

edges_kept([P0|Rest0], [P|Rest]) :-
    append(Rest0, [P0], Nexts0),
    append(Rest, [P], Nexts),
    maplist(edge_kept, [P0|Rest0], Nexts0, [P|Rest], Nexts).

edge_kept([X1,Y1], [X2,Y2], [X3,Y3], [X4,Y4]) :-
    (X4-X3)*(X2-X1) + (Y4-Y3)*(Y2-Y1) > 0.

