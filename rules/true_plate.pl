:- module(sg_true_plate,
          [ plate_layer/2,              % +Options, -Layer
            plate_parts/5,              % +S, +Others, +Options0, -Options,
                                        % -Parts
            transition_resized/3        % +Term, +By, -Resized
          ]).
:- use_module(model_file, [add_primitive/2]).
:- use_module(primitive, [is_primitive/1]).
:- use_module(primitive_face, [smooth_surface/3]).
:- use_module(store, [segment/3, assert_fact/1]).
:- use_module(true_flat, [flat_resized/3]).
:- use_module(true_surface, [offset_surface/3]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/5]).
:- use_module(library(error), [domain_error/2, must_be/2]).
:- use_module(library(lists),
              [ append/3, last/2, max_list/2, member/2, min_list/2,
                same_length/2, select/3
              ]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The plate that a surface is made of: which layer of it is drawn.

What is drawn is one surface; a plate has two, and a layer between them that
keeps its length when the plate is rolled or bent, the *neutral* one. Options:

    thickness(T)         of the plate; without it, it has none
    size(Which)          `inside`, `middle` (default) or `outside`: which of its
                         surfaces is drawn. Inside is where the axis is.
    k_factor(K)          the neutral layer is K*T outside the inside: 0.5

Where parts penetrate, not what is drawn meets, but what touches first. A branch
is *set on* a header: its inside meets the outside of the header, and there the
hole is marked too. Or it is *set in* the wall: its outside meets the inside of
the header. The part with the smaller radius is the branch. Parts of one radius
meet in a mitre: with their middles. Options:

    set_in(true)         set in; by default set on
    role(Role)           S is a `branch`, a `header` or one side of a `mitre`,
                         whatever the radii
    other_thickness(T2)  of the plate of the others: T
*/

%!  plate_layer(+Options, -Layer) is det.
%
%   Layer is how far outside the drawn surface the neutral one is.

plate_layer(Options, Layer) :-
    (   option(layer(Layer), Options)
    ->  true
    ;   plate(Options, T, Inner),
        option(k_factor(K), Options, 0.5),
        must_be(between(0.0, 1.0), K),
        Layer is Inner + float(K)*T
    ).

%   plate(Options, T, Inner): Inner is how far outside what is drawn the inside
%   is.

plate(Options, T, Inner) :-
    option(thickness(T), Options, 0.0),
    size_inner(Options, T, Inner).

size_inner(Options, T, Inner) :-
    must_be(number, T),
    (   T >= 0
    ->  true
    ;   domain_error(not_less_than_zero, T)
    ),
    option(size(Size), Options, middle),
    must_be(oneof([inside,middle,outside]), Size),
    inner(Size, T, Inner).

inner(inside, _, 0.0).
inner(middle, T, Inner) :- Inner is -T/2.0.
inner(outside, T, Inner) :- Inner is -float(T).

%!  plate_parts(+S, +Others, +Options0, -Options, -Parts) is det.
%
%   Parts is S1-Others1: new segments, the primitives S and Others again, but as
%   large as the surfaces in which their plates touch each other; what has flat
%   faces has these moved (flat_resized/3). To be trimmed (trimmed/4) and then
%   developed with Options, which have layer(Layer), and size(Size) for bends,
%   instead of what Options0 say of the plate. Without a thickness they are what
%   was given.
%
%   @error geometry_error(true(no_offset(S))): no surface that is known is
%   everywhere so far from that of S: it is oblique, elliptic, or not curved
%   simply; or where its flat faces meet they would not, being moved

plate_parts(S, Others, Options, Options, S-Others) :-
    plate(Options, T, _),
    T =:= 0,
    !.
plate_parts(S, Others, Options0, Options, S1-Others1) :-
    plate(Options0, T, Inner),
    Outer is Inner + T,
    option(other_thickness(T2), Options0, T),
    size_inner(Options0, T2, OtherInner),
    OtherOuter is OtherInner + T2,
    part_role(Options0, S, Others, Role),
    option(set_in(In), Options0, false),
    must_be(boolean, In),
    touches(Role, In, Side),
    touching_sides(Side, Inner-Outer, OtherInner-OtherOuter, By, OtherBy),
    plate_layer(Options0, Layer0),
    Layer is Layer0 - By,
    Options = [layer(Layer),size(Side)|Options0],
    resized(By, S, S1),
    maplist(resized(OtherBy), Others, Others1).

%   touches(Role, SetIn, Side): with which side its plate touches the others.

touches(branch, false, inside).
touches(branch, true, outside).
touches(header, false, outside).
touches(header, true, inside).
touches(mitre, _, middle).

%   touching_sides(Side, Inner-Outer, OtherInner-OtherOuter, By, OtherBy): how
%   much larger than drawn the sides are that touch.

touching_sides(inside, Inner-_, _-OtherOuter, Inner, OtherOuter).
touching_sides(outside, _-Outer, OtherInner-_, Outer, OtherInner).
touching_sides(middle, Inner-Outer, OtherInner-OtherOuter, By, OtherBy) :-
    By is (Inner+Outer)/2.0,
    OtherBy is (OtherInner+OtherOuter)/2.0.

part_role(Options, S, Others, Role) :-
    (   option(role(Role), Options)
    ->  must_be(oneof([branch,header,mitre]), Role)
    ;   part_width(S, Width),
        maplist(part_width, Others, Widths),
        width_role(Width, Widths, Role)
    ).

width_role(Width, Widths, Role) :-
    (   member(Other, Widths),
        wider(Width, Other)
    ->  Role = header
    ;   Width < inf,
        Widths \== [],
        \+ ( member(Other, Widths), wider(Other, Width) )
    ->  Role = mitre
    ;   Role = branch
    ).

%   wider(A, B): by more than rounding.

wider(A, B) :-
    A > B*(1.0 + 1.0e-9).

%   What has flat faces is as wide as a box or prism is, or wider than any pipe.

part_width(S, Width) :-
    (   segment(S, _, Term),
        transition_width(Term, Width0)
    ->  Width = Width0
    ;   segment(S, _, Term),
        flat_width(Term, Width0)
    ->  Width = Width0
    ;   smooth_surface(S, _, Surface),
        Surface \= bezier(_)
    ->  arg(2, Surface, vector(A, B, C)),
        Width is sqrt(A*A + B*B + C*C)
    ;   Width = inf
    ).

%   resized(By, S, S1): S1 is S, By larger all round, and part_named/2 knows it.

resized(By, S, S1) :-
    (   By =:= 0.0
    ->  S1 = S
    ;   made_larger(By, S, S1),
        assert_fact(origin(S1, node(S1), plate(S)))
    ).

made_larger(By, S, S1) :-
    (   \+ smooth_surface(S, _, _),
        flat_resized(S, By, S1)
    ->  true
    ;   segment(S, _, Term),
        transition_resized(Term, By, Term1)
    ->  add_primitive(Term1, S1)
    ;   segment(S, _, Term),
        is_primitive(Term),
        findall(Surface, smooth_surface(S, _, Surface), [Surface]),
        offset_surface(Surface, By, Offset),
        term_resized(Term, Surface, Offset, Term1)
    ->  add_primitive(Term1, S1)
    ;   throw(error(geometry_error(true(no_offset(S))), _))
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
arguments_resized(sphere, F, _, Arguments0, Arguments) :-
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
    twice_area(Corners0, Area),
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

twice_area(Corners, Area) :-
    last(Corners, Last),
    foldl(trapezoid, Corners, Last-0, _-Area).

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

%   transition_width(Term, Width): half of the wider of its outlines.

transition_width(at(_, Term), Width) :-
    transition_width(Term, Width).
transition_width(named(_, Term), Width) :-
    transition_width(Term, Width).
transition_width(Term, Width) :-
    Term =.. [Name|Arguments],
    memberchk(Name, [transition,open_transition]),
    memberchk(base(Outline1), Arguments),
    memberchk(top(Outline2), Arguments),
    half_width(Outline1, Width1),
    half_width(Outline2, Width2),
    Width is max(Width1, Width2).

half_width(circle(R), R).
half_width(ellipse(A, B), Width) :-
    Width is max(A, B).
half_width(rectangle(A, B), Width) :-
    Width is max(A, B)/2.0.
half_width(rectangle(A, B, _), Width) :-
    Width is max(A, B)/2.0.
half_width(polygon(Corners), Width) :-
    twice_area(Corners, Area),
    Width is sqrt(abs(Area)/2.0)/2.0.

%   flat_width(Term, Width): half of what is neither the longest nor the
%   shortest side of a box round it, as it stands.

flat_width(at(_, Term), Width) :-
    flat_width(Term, Width).
flat_width(named(_, Term), Width) :-
    flat_width(Term, Width).
flat_width(box(size(A, B, C)), Width) :-
    msort([A,B,C], [_,Middle,_]),
    Width is Middle/2.0.
flat_width(Term, Width) :-
    Term =.. [prism|Arguments],
    memberchk(outline(Corners), Arguments),
    memberchk(height(H), Arguments),
    findall(X, member([X,_], Corners), Xs),
    findall(Y, member([_,Y], Corners), Ys),
    extent(Xs, A),
    extent(Ys, B),
    flat_width(box(size(A, B, H)), Width).

extent(Xs, Extent) :-
    min_list(Xs, Least),
    max_list(Xs, Most),
    Extent is Most-Least.
