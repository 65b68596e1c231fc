:- module(sg_true_plate,
          [ plate_layer/2,              % +Options, -Layer
            plate_fits/2,               % +S, +Options
            plate_alone/4,              % +S, +Options0, -Options, -S1
            plate_parts/5,              % +S, +Others, +Options0, -Options,
                                        % -Parts
            part_role/4                 % +Options, +S, +Others, -Role
          ]).
:- use_module('../near', [longer/2]).
:- use_module('../csg/placed_surface', [placed_surface/3, placed_term/2]).
:- use_module('../solid/trimmed', [part_named/2]).
:- use_module(true_leaf, [composed_leaves/2]).
:- use_module(true_parts, [parts_made/3]).
:- use_module(true_resized, [outline_area/2]).
:- use_module(true_surface, [offset_surface/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(error), [domain_error/2, must_be/2]).
:- use_module(library(lists), [max_list/2, member/2, min_list/2]).
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

%!  plate_fits(+S, +Options) is det.
%
%   The plate of segment S leaves a hollow: its inside is nearer to what is
%   drawn than the axis is, at both ends, than the middle of a sphere, or of an
%   outline. So it is of each leaf of a CSG tree that is plate.
%
%   @error geometry_error(true(too_thick(S, T, Most))): T is not less than Most

plate_fits(S, Options) :-
    plate(Options, T, Inner),
    Depth is -Inner,
    (   Depth > 0,
        plate_leaf(S, Leaf),
        hollow_depth(Leaf, Inner, Most),
        \+ longer(Most, Depth)
    ->  MostT is T*Most/Depth,
        throw(error(geometry_error(true(too_thick(S, T, MostT))), _))
    ;   true
    ).

plate_leaf(S, Leaf) :-
    (   composed_leaves(S, Leaves)
    ->  member(Leaf, Leaves)
    ;   Leaf = S
    ).

%   hollow_depth(S, Inner, Most) is nondet: the inside of S can be no more than
%   Most within what is drawn; Inner is where it is.

hollow_depth(S, _, Most) :-
    placed_term(S, Term),
    transition_outlines(Term, Outlines),
    !,
    member(Outline, Outlines),
    least_half(Outline, Most).
hollow_depth(S, Inner, Most) :-
    placed_surface(S, _, Surface),
    surface_hollow(Surface, Inner, Most).

%   surface_hollow(Surface, Inner, Most) is semidet. That of a right circular
%   cone is measured at right angles to it; of others it is less than the
%   radius, at the least.

surface_hollow(cylinder(_, U, V, _), _, Most) :-
    least_radius(U, V, Most).
surface_hollow(sphere(_, U, V, W), _, Most) :-
    least_radius(U, V, R1),
    least_radius(V, W, R2),
    Most is min(R1, R2).
surface_hollow(cone(C, U, V, W, K), Inner, Most) :-
    least_radius(U, V, R0),
    (   K > 0.0
    ->  R is R0*min(1.0, K)
    ;   R = R0
    ),
    (   offset_surface(cone(C, U, V, W, K), -Inner, cone(_, U1, V1, _, _))
    ->  least_radius(U1, V1, R1),
        Most is -Inner*R/(R1-R0)
    ;   Most = R
    ).

least_radius(vector(A, B, C), vector(D, E, F), R) :-
    R is sqrt(min(A*A + B*B + C*C, D*D + E*E + F*F)).

least_half(circle(R), R).
least_half(ellipse(A, B), Least) :-
    Least is min(A, B).
least_half(rectangle(A, B), Least) :-
    Least is min(A, B)/2.0.
least_half(rectangle(A, B, _), Least) :-
    Least is min(A, B)/2.0.

%!  plate_parts(+S, +Others, +Options0, -Options, -Parts) is det.
%
%   Parts is S1-Others1: new segments, S and Others again, in fine facets and as
%   large as the surfaces in which their plates touch each other (parts_made/3).
%   To be trimmed (trimmed/4) and then developed with Options, which have
%   layer(Layer), and size(Size) for bends, instead of what Options0 say of the
%   plate. What need not be changed is what was given.
%
%   @error geometry_error(true(no_offset(S))): no surface that is known is
%   everywhere so far from that of S: it is not curved simply; or where its flat
%   faces meet they would not, being moved

plate_parts(S, Others, Options, Options, S1-Others1) :-
    plate(Options, T, _),
    T =:= 0,
    !,
    findall(Part-0.0, member(Part, [S|Others]), Sizes),
    parts_made(Sizes, Options, [S1|Others1]).
plate_parts(S, Others, Options0, Options, S1-Others1) :-
    plate(Options0, T, Inner),
    Outer is Inner + T,
    option(other_thickness(T2), Options0, T),
    size_inner(Options0, T2, OtherInner),
    OtherOuter is OtherInner + T2,
    part_role(Options0, S, Others, Role),
    option(set_in(In), Options0, false),
    must_be(boolean, In),
    mitre_told(Role, In, Options0, S),
    touches(Role, In, Side),
    touching_sides(Side, Inner-Outer, OtherInner-OtherOuter, By, OtherBy),
    plate_layer(Options0, Layer0),
    Layer is Layer0 - By,
    Options = [layer(Layer),size(Side)|Options0],
    findall(Other-OtherBy, member(Other, Others), OtherSizes),
    parts_made([S-By|OtherSizes], [layer(Layer0)|Options0], [S1|Others1]).

%!  plate_alone(+S, +Options0, -Options, -S1) is det.
%
%   As plate_parts/5 of a result of a CSG tree that is not trimmed: its leaves
%   meet by the middles of their plates, and so does a plane that cuts it. What
%   is subtracted is a tool, and cuts where it is drawn.
%
%   @error as plate_parts/5

plate_alone(S, Options0, Options, S1) :-
    plate(Options0, T, Inner),
    By is Inner + T/2.0,
    plate_layer(Options0, Layer0),
    Layer is Layer0 - By,
    Options = [layer(Layer),size(middle)|Options0],
    parts_made([S-By], [layer(Layer0)|Options0], [S1]).

%   mitre_told(Role, SetIn, Options, S): a mitre has no side that is set in, and
%   if parts are drawn by the middles of their plates, the thickness of the
%   other plate says nothing.

mitre_told(mitre, In, Options, S) :-
    !,
    part_named(S, Named),
    forall(mitre_in_vain(In, Options, What),
           ( Told =.. [What,Named],
             print_message(warning, sanggwan(unfold(Told))) )).
mitre_told(_, _, _, _).

mitre_in_vain(true, _, mitre_not_set_in).
mitre_in_vain(_, Options, mitre_by_middles) :-
    option(other_thickness(_), Options),
    option(size(middle), Options, middle).

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

%!  part_role(+Options, +S, +Others, -Role) is det.
%
%   Role is that of S among Others, parts that it meets: `branch`, `header`, or
%   `mitre` if none is wider and none narrower; or what Options say.
%
%   @error type_error if Options have another role

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
    B < inf,
    longer(A, B).

%   What has flat faces is as wide as a box or prism is, or wider than any pipe.

part_width(S, Width) :-
    (   placed_term(S, Term),
        transition_width(Term, Width0)
    ->  Width = Width0
    ;   placed_term(S, Term),
        flat_width(Term, Width0)
    ->  Width = Width0
    ;   placed_surface(S, _, Surface),
        Surface \= bezier(_)
    ->  arg(2, Surface, vector(A, B, C)),
        Width is sqrt(A*A + B*B + C*C)
    ;   composed_width(S, Width0)
    ->  Width = Width0
    ;   Width = inf
    ).

%   composed_width(S, Width): the result of a CSG tree is as wide as the widest
%   of its round leaves whose faces are plate.

composed_width(S, Width) :-
    composed_leaves(S, Leaves),
    findall(Width0,
            ( member(Leaf, Leaves),
              once(placed_surface(Leaf, _, _)),
              part_width(Leaf, Width0) ),
            Widths),
    Widths \== [],
    max_list(Widths, Width).

%   transition_width(Term, Width): half of the wider of its outlines.

transition_width(Term, Width) :-
    transition_outlines(Term, [Outline1,Outline2]),
    half_width(Outline1, Width1),
    half_width(Outline2, Width2),
    Width is max(Width1, Width2).

transition_outlines(at(_, Term), Outlines) :-
    transition_outlines(Term, Outlines).
transition_outlines(named(_, Term), Outlines) :-
    transition_outlines(Term, Outlines).
transition_outlines(Term, [Outline1,Outline2]) :-
    Term =.. [Name|Arguments],
    memberchk(Name, [transition,open_transition]),
    memberchk(base(Outline1), Arguments),
    memberchk(top(Outline2), Arguments).

half_width(circle(R), R).
half_width(ellipse(A, B), Width) :-
    Width is max(A, B).
half_width(rectangle(A, B), Width) :-
    Width is max(A, B)/2.0.
half_width(rectangle(A, B, _), Width) :-
    Width is max(A, B)/2.0.
half_width(polygon(Corners), Width) :-
    outline_area(Corners, Area),
    Width is sqrt(abs(Area))/2.0.

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
