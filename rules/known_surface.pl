:- module(sg_known_surface,
          [ known_surfaces/1,           % -Known
            segment_surfaces/3,         % +S, -Surfaces, -Runs
            polygon_surface/4,          % +S, +P, -Id, -Surface
            surface_normal/4            % +Surface, +Point, +Facet, -Normal
          ]).
:- use_module(csg_matrix, [identity_matrix/1, rounded_matrix/2]).
:- use_module(csg_record, [recorded/2]).
:- use_module(placing, [step_motion/2]).
:- use_module(primitive,
              [ is_primitive/1, moved_surfaces/3, primitive/1,
                primitive_parts/3
              ]).
:- use_module(smooth_vector,
              [ cross_product/3, difference/3, dot_product/3, scaled/3 ]).
:- use_module(store, [segment/3, from_p/5]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(lists), [append/3, member/2, nth1/3]).
:- autoload(library(pairs), [pairs_keys/2]).
/** <module> Which smooth surfaces the polygons of a world stand for.

A polygon that a primitive made is a facet of a surface that its term tells
(primitive_face.pl), and stays one when it is cut, placed, or becomes a part of
a solid (from_p/5). What the surface looks like counts in a drawing, not how
finely it was divided: facets of one surface are no creases, and a vertex has
the surface's normal.

Facets that are too wide stand for themselves: a cylinder, cone or turning of
fewer than nine facets to the full turn is a prism or a pyramid, such as a nut;
of spheres and tori facets of a quarter turn or more. What is made of segments
that are edited by hand keeps the surfaces of its terms; the kernel takes no
normal that leans more than 78 degrees from the facet's.

c_kernels/known_surface.c and known_surface4pl.c are the fused kernel.
*/

%!  known_surfaces(-Known:list) is det.
%
%   Known are known(S, Surfaces, Runs), as of segment_surfaces/3, of all
%   segments that it knows of, in the order of S: for the kernel.

known_surfaces(Known) :-
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss),
    findall(known(S,Surfaces,Runs),
            ( member(S, Ss), segment_surfaces(S, Surfaces, Runs) ),
            Known).

%!  segment_surfaces(+S, -Surfaces:list, -Runs:list) is semidet.
%
%   True when segment S has its polygons from a primitive, or from one that was
%   placed. The polygons P1 to P2 of a run(P1, P2, K) are facets of the K-th of
%   Surfaces, those in no run of none. Surfaces are
%
%       surface(Kind, [X,Y,Z, UX,UY,UZ, VX,VY,VZ, WX,WY,WZ], A, B)
%
%   by smooth_surface/3: a centre, three vectors and, with x, y, h along these,
%   Kind `tapered`: (x/(1-h+h*A))^2 + (y/(1-h+h*B))^2 = 1, `sphere`: x^2 + y^2 +
%   h^2 = 1, `torus`: (sqrt(x^2+y^2)-1)^2 + h^2 = A^2, or `free`.
%
%   Fails if the polygons are those of other segments, by from_p/5.

segment_surfaces(S, Surfaces, Runs) :-
    (   moved_join(S, Children, Motion)
    ->  foldl(child_surfaces(S, Motion), Children, []-[], Surfaces-Runs)
    ;   own_parts(S, Parts, Named),
        surfaces_and_runs(Parts, Named, Surfaces, Runs)
    ).

surfaces_and_runs(Parts, Named, Surfaces, Runs) :-
    surface_runs(Parts, 1, Named, Runs),
    findall(Surface, ( member(_-Term, Named), plain_surface(Term, Surface) ),
            Surfaces).

%   moved_join(S, Children, Motion): S is a join that was moved as a whole.

moved_join(S, Children, Motion) :-
    recorded(S, What),
    arg(1, What, join(Stamps, Matrix)),
    identity_matrix(Identity),
    rounded_matrix(Identity, Rounded),
    Matrix \== Rounded,
    pairs_keys(Stamps, Children0),
    sort(Children0, Children),
    step_motion(matrix(Matrix), Motion).

%   child_surfaces(S, Motion, Child, Found0, Found): Found, Surfaces-Runs, has
%   those of Child, a primitive, moved as it came into S. Of what was combined
%   and then moved so the surfaces are not followed.

child_surfaces(S, Motion, Child, Surfaces0-Runs0, Surfaces-Runs) :-
    (   own_parts(Child, Parts, Named0)
    ->  moved_surfaces([Motion], Named0, Named),
        surfaces_and_runs(Parts, Named, Own, OwnRuns),
        foldl(part_polygons, Parts, 0, Count),
        length(Surfaces0, Before),
        findall(run(P1,P2,K),
                ( came_in(S, Child, Count, Shift),
                  member(run(Q1,Q2,I), OwnRuns),
                  P1 is Q1+Shift,
                  P2 is Q2+Shift,
                  K is I+Before ),
                More),
        append(Surfaces0, Own, Surfaces),
        append(Runs0, More, Runs1),
        sort(Runs1, Runs)
    ;   Surfaces = Surfaces0,
        Runs = Runs0
    ).

part_polygons(part(N, _), Count0, Count) :-
    Count is Count0+N.

%   came_in(S, Child, Count, Shift): polygon P of Child, of Count, is P+Shift of
%   S, wherever Child came in whole.

came_in(S, Child, Count, Shift) :-
    from_p(S, P, Child, 1, _),
    Shift is P-1,
    Last is Count+Shift,
    once(from_p(S, Last, Child, Count, _)).

own_parts(S, Parts, Named) :-
    segment(S, _, Term),
    (   primitive_term(Term)
    ->  catch(primitive_parts(Term, Parts, Named),
              error(model_error(_), _), fail)
    ;   recorded(S, What),
        arg(1, What, From)
    ->  copied_parts(From, Parts, Named)
    ).

copied_parts(placed(Leaf-_, Matrix), Parts, Named) :-
    own_parts(Leaf, Parts, Named0),
    step_motion(matrix(Matrix), Motion),
    moved_surfaces([Motion], Named0, Named).

primitive_term(Term) :-
    is_primitive(Term),
    inner_term(Term, Inner),
    compound(Inner),
    compound_name_arity(Inner, Name, _),
    primitive(Name).

inner_term(Term, Inner) :-
    (   ( Term = at(_, Term1) ; Term = named(_, Term1) )
    ->  inner_term(Term1, Inner)
    ;   Inner = Term
    ).

surface_runs([], _, _, []).
surface_runs([part(N,What)|Parts], P0, Named, Runs) :-
    P1 is P0+N,
    (   What = curved(Part, Turn),
        once(nth1(K, Named, Part-Surface)),
        stands_for(Turn, Surface)
    ->  Last is P1-1,
        Runs = [run(P0,Last,K)|Rest]
    ;   Runs = Rest
    ),
    surface_runs(Parts, P1, Named, Rest).

%   stands_for(Turn, Surface): a facet of so many degrees stands for it. No
%   facet of a Bezier patch does: how far a patch bends within a facet is not
%   known, so only the crease angle tells what its edges are.

stands_for(Turn, Surface) :-
    functor(Surface, Name, _),
    widest(Name, Widest),
    Turn < Widest.

widest(cylinder, 45.0).
widest(cone,     45.0).
widest(ruled,    45.0).
widest(sphere,   90.0).
widest(torus,    90.0).

plain_surface(cylinder(C,U,V,W), surface(tapered,Frame,1.0,1.0)) :-
    frame(C, U, V, W, Frame).
plain_surface(cone(C,U,V,W,K0), surface(tapered,Frame,K,K)) :-
    K is float(K0),
    frame(C, U, V, W, Frame).
plain_surface(ruled(C,U,V,W,U2,V2), Surface) :-
    frame(C, U, V, W, Frame),
    part_of(U2, U, A),
    part_of(V2, V, B),
    Surface = surface(tapered,Frame,A,B).
plain_surface(sphere(C,U,V,W), surface(sphere,Frame,0.0,0.0)) :-
    frame(C, U, V, W, Frame).
plain_surface(torus(C,U,V,W,K0), surface(torus,Frame,K,0.0)) :-
    K is float(K0),
    frame(C, U, V, W, Frame).
plain_surface(bezier(_), surface(free,Frame,0.0,0.0)) :-
    frame(point(0.0,0.0,0.0), vector(0.0,0.0,0.0), vector(0.0,0.0,0.0),
          vector(0.0,0.0,0.0), Frame).

frame(point(X,Y,Z), vector(UX,UY,UZ), vector(VX,VY,VZ), vector(WX,WY,WZ),
      [X,Y,Z,UX,UY,UZ,VX,VY,VZ,WX,WY,WZ]).

%   Vector2 is Part times Vector.

part_of(vector(X2,Y2,Z2), vector(X,Y,Z), Part) :-
    Part is (X2*X + Y2*Y + Z2*Z)/(X*X + Y*Y + Z*Z).

%!  polygon_surface(+S, +P, -Id, -Surface) is semidet.
%
%   True when polygon P of segment S is a facet of Surface, the K-th of segment
%   S0 by segment_surfaces/3; Id is S0-K. Of what was combined the first part of
%   P counts.

polygon_surface(S, P, Id, Surface) :-
    (   segment_surfaces(S, Surfaces, Runs)
    ->  member(run(P1,P2,K), Runs),
        P >= P1,
        P =< P2,
        !,
        nth1(K, Surfaces, Surface),
        Id = S-K
    ;   once(from_p(S, P, S0, P0, _)),
        polygon_surface(S0, P0, Id, Surface)
    ).

%!  surface_normal(+Surface, +Point, +Facet, -Normal) is semidet.
%
%   Normal is the unit normal of Surface at Point, on it or near it, on the side
%   of Facet, the normal of a facet there. Points and vectors are p(X,Y,Z).
%   Fails where there is none, or where it is more than 78 degrees from Facet.
%
%   With [U V W] the matrix of the frame, the gradient of what is zero on the
%   surface is mapped by the transpose of its inverse.

surface_normal(surface(Kind,Frame,A,B), Point, Facet, Normal) :-
    Kind \== free,
    Frame = [CX,CY,CZ,UX,UY,UZ,VX,VY,VZ,WX,WY,WZ],
    U = p(UX,UY,UZ),
    V = p(VX,VY,VZ),
    W = p(WX,WY,WZ),
    cross_product(V, W, RowU),
    cross_product(W, U, RowV),
    cross_product(U, V, RowW),
    dot_product(U, RowU, Volume),
    Volume =\= 0.0,
    difference(Point, p(CX,CY,CZ), From),
    maplist(coordinate(From, Volume), [RowU,RowV,RowW], Local),
    gradient(Kind, A, B, Local, [GX,GY,GZ]),
    scaled(GX, RowU, p(X1,Y1,Z1)),
    scaled(GY, RowV, p(X2,Y2,Z2)),
    scaled(GZ, RowW, p(X3,Y3,Z3)),
    X is X1+X2+X3,
    Y is Y1+Y2+Y3,
    Z is Z1+Z2+Z3,
    on_side(p(X,Y,Z), Facet, Normal).

coordinate(From, Volume, Row, Coordinate) :-
    dot_product(From, Row, Product),
    Coordinate is Product/Volume.

gradient(tapered, A, B, [X,Y,H], [GX,GY,GH]) :-
    RA is 1.0-H+H*A,
    RB is 1.0-H+H*B,
    RA >= 1.0e-9,
    RB >= 1.0e-9,
    U is X/RA,
    V is Y/RB,
    Radius is sqrt(U*U + V*V),
    Radius >= 1.0e-9,
    GX is Radius*U/RA,
    GY is Radius*V/RB,
    GH is -(U*U*(A-1.0)/RA + V*V*(B-1.0)/RB).
gradient(sphere, _, _, Local, Local).
gradient(torus, _, _, [X,Y,H], [GX,GY,H]) :-
    Radius is sqrt(X*X + Y*Y),
    Radius >= 1.0e-9,
    GX is (Radius-1.0)*X/Radius,
    GY is (Radius-1.0)*Y/Radius.

on_side(Gradient, Facet, Normal) :-
    dot_product(Gradient, Gradient, Square),
    dot_product(Facet, Facet, FacetSquare),
    dot_product(Gradient, Facet, Lean),
    abs(Lean) > 0.2*sqrt(Square*FacetSquare),
    Factor is copysign(1.0/sqrt(Square), Lean),
    scaled(Factor, Gradient, Normal).
