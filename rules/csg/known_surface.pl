:- module(sg_known_surface,
          [ known_surfaces/1,           % -Known
            segment_surfaces/3,         % +S, -Surfaces, -Runs
            term_surfaces/3,            % +Term, -Surfaces, -Runs
            stands_for/2,               % +Turn, +Surface
            plain_surface/2,            % +Surface, -Numbers
            flat_bend/1,                % -Degrees
            facets_of/2,                % +Ss, -Facets
            remember_facets/1,          % +Facets
            remembered_facets/1,        % -Facets
            remember_only/1,            % +Facets
            facets_moved/1,             % +Matrix
            moved_join/2,               % +S, -Matrix
            moved_surface/3             % +Matrix, +Surface0, -Surface
          ]).
:- use_module(csg_matrix, [identity_matrix/1, rounded_matrix/2]).
:- use_module(csg_record, [recorded/2]).
:- use_module('../kernel', [known_facets/3]).
:- use_module('../primitive/primitive',
              [is_primitive/1, primitive/1, primitive_parts/3]).
:- use_module('../store',
              [ segment/3, origin/3, from_p/5, assert_fact/1,
                retractall_facts/1
              ]).
:- use_module(library(apply), [foldl/4, foldl/5, maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2, nth1/3]).
/** <module> Which smooth surfaces the polygons of a world stand for, and which
faces they are.

A polygon that a primitive made is a facet of a surface that its term tells
(primitive_face.pl), and stays one when it is cut, placed, or becomes a part of
a solid (from_p/5), also where that is moved as a whole. What the surface looks
like counts in a drawing, not how finely it was divided: facets of one surface
are no creases, and a vertex has the surface's normal. What stands for no
surface is a face that the term names: base, side(2), face(7). Where two
different surfaces or faces meet and are not tangent is an edge of the model,
however little they bend: by more than the tolerance of the model can turn them
(docs/precision.md).

Facets that are too wide stand for themselves: a cylinder, cone or turning of
fewer than nine facets to the full turn is a prism or a pyramid, such as a nut;
of spheres and tori facets of a quarter turn or more. Where the outline of a
primitive, or its faces, are only a division of a curve (smooth(true)), nothing
is known of its walls, and the surfaces that they turn into go on in each other.
What is made of segments that are edited by hand keeps the surfaces of its
terms; the kernel takes no normal that leans more than 78 degrees from the
facet's.

Where the terms and from_p/5 do not tell it any more, because what was combined
is gone (csg_roots.pl) or all was turned (view.pl), it is remembered.

c_kernels/picture/known_surface.c and known_surface_rows.c are the fused kernel.
*/

%!  known_surfaces(-Known:list) is det.
%
%   What is known of segments themselves, in the order of S, for the kernel:
%
%     - known(S, Surfaces, Runs)      as of segment_surfaces/3
%     - moved(S, Numbers)             a join of others that was moved as a
%                                     whole, by the matrix with these numbers,
%                                     row by row
%
%   Other segments have their polygons from others, by from_p/5.

known_surfaces(Known) :-
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss),
    findall(What, ( member(S, Ss), known_of(S, What) ), Known).

known_of(S, What) :-
    (   segment_surfaces(S, Surfaces, Runs)
    ->  What = known(S,Surfaces,Runs)
    ;   moved_join(S, Matrix),
        append(Matrix, Numbers),
        What = moved(S,Numbers)
    ).

%!  segment_surfaces(+S, -Surfaces:list, -Runs:list) is semidet.
%
%   True when segment S has its polygons from a primitive, or from one that was
%   placed, or when it is remembered whose facets they are (remember_facets/1).
%   The polygons P1 to P2 of a run(P1, P2, K) are facets of the K-th of
%   Surfaces; if K is 0, each of them is a face of its own, and if it is less,
%   all of them are (a part of) face K. Of those in no run nothing is known.
%   Runs ascend. Surfaces are
%
%       surface(Kind, [X,Y,Z, UX,UY,UZ, VX,VY,VZ, WX,WY,WZ], A, B)
%
%   by smooth_surface/3: a centre, three vectors and, with x, y, h along these,
%   Kind `tapered`: (x/(1-h+h*A))^2 + (y/(1-h+h*B))^2 = 1, `sphere`: x^2 + y^2 +
%   h^2 = 1, `torus`: (sqrt(x^2+y^2)-1)^2 + h^2 = A^2, or `free`; of `bezier`
%   the numbers are those of 16 control points. `turned` is
%   as `tapered`, one of several that a divided curve was turned into.
%
%   Fails if the polygons are those of other segments, by from_p/5.

segment_surfaces(S, Surfaces, Runs) :-
    (   origin(S, surfaces, on(Surfaces0,Runs0))
    ->  Surfaces = Surfaces0,
        Runs = Runs0
    ;   primitive_surfaces(S, Surfaces0, Runs0)
    ->  Surfaces = Surfaces0,
        Runs = Runs0
    ;   recorded(S, What),
        arg(1, What, placed(Leaf-_, Matrix)),
        segment_surfaces(Leaf, Surfaces0, Runs),
        maplist(moved_surface(Matrix), Surfaces0, Surfaces)
    ).

primitive_surfaces(S, Surfaces, Runs) :-
    segment(S, _, Term),
    primitive_term(Term),
    \+ from_p(S, _, _, _, _),           % not a part that has kept the name
    catch(term_surfaces(Term, Surfaces, Runs), error(model_error(_), _), fail).

%!  term_surfaces(+Term, -Surfaces:list, -Runs:list) is det.
%
%   The same of the polygons of the primitive Term.
%
%   @error as primitive_shape/4

term_surfaces(Term, Surfaces, Runs) :-
    primitive_parts(Term, Parts, Named),
    surface_runs(Parts, 1, Named, Runs),
    findall(Surface,
            ( member(_-Placed, Named), plain_surface(Placed, Surface) ),
            Surfaces).

%!  moved_join(+S, -Matrix) is semidet.
%
%   True when S is a join that was moved as a whole, by Matrix.

moved_join(S, Matrix) :-
    recorded(S, What),
    arg(1, What, join(_, Matrix)),
    identity_matrix(Identity),
    rounded_matrix(Identity, Rounded),
    Matrix \== Rounded.

%!  moved_surface(+Matrix, +Surface0, -Surface) is det.
%
%   Surface is where Matrix, three rows of four numbers, brings Surface0.

moved_surface(Rows, surface(Kind,Numbers0,A,B), surface(Kind,Numbers,A,B)) :-
    (   Kind == bezier
    ->  moved_points(Numbers0, Rows, Numbers)
    ;   Numbers0 = [X0,Y0,Z0,UX0,UY0,UZ0,VX0,VY0,VZ0,WX0,WY0,WZ0],
        Numbers = [X,Y,Z,UX,UY,UZ,VX,VY,VZ,WX,WY,WZ],
        maplist(row_times([X0,Y0,Z0,1.0]), Rows, [X,Y,Z]),
        maplist(row_times([UX0,UY0,UZ0,0.0]), Rows, [UX,UY,UZ]),
        maplist(row_times([VX0,VY0,VZ0,0.0]), Rows, [VX,VY,VZ]),
        maplist(row_times([WX0,WY0,WZ0,0.0]), Rows, [WX,WY,WZ])
    ).

moved_points([], _, []).
moved_points([X0,Y0,Z0|Numbers0], Rows, [X,Y,Z|Numbers]) :-
    maplist(row_times([X0,Y0,Z0,1.0]), Rows, [X,Y,Z]),
    moved_points(Numbers0, Rows, Numbers).

row_times([X,Y,Z,One], [A,B,C,D], Number) :-
    Number is float(A*X + B*Y + C*Z + D*One) + 0.0.

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
    (   part_number(What, Named, K)
    ->  Last is P1-1,
        Runs = [run(P0,Last,K)|Rest]
    ;   Runs = Rest
    ),
    surface_runs(Parts, P1, Named, Rest).

%   part_number(What, Named, K): K as in a run of the part What.

part_number(flat, _, 0).
part_number(wall(I), _, K) :-
    K is -I.
part_number(curved(Part,Turn), Named, K) :-
    once(nth1(I, Named, Part-Surface)),
    (   stands_for(Turn, Surface)
    ->  K = I
    ;   Surface \= turned(_)
    ->  K = 0
    ).

%!  stands_for(+Turn, +Surface) is semidet.
%
%   True when a facet of so many degrees stands for Surface, as of
%   smooth_surface/3; every facet of a Bezier patch does.

stands_for(Turn, Surface) :-
    (   Surface = turned(Inner)
    ->  true
    ;   Inner = Surface
    ),
    functor(Inner, Name, _),
    widest(Name, Widest),
    Turn < Widest.

widest(cylinder, 45.0).
widest(cone,     45.0).
widest(ruled,    45.0).
widest(sphere,   90.0).
widest(torus,    90.0).
widest(bezier,   inf).

%!  plain_surface(+Surface, -Numbers) is det.
%
%   Numbers is surface(Kind, Frame, A, B), as of segment_surfaces/3, for Surface
%   as of smooth_surface/3.

plain_surface(turned(Inner), surface(turned,Frame,A,B)) :-
    plain_surface(Inner, surface(tapered,Frame,A,B)).
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
plain_surface(bezier(Points), surface(bezier,Numbers,0.0,0.0)) :-
    foldl(coordinates, Points, Numbers, []).
plain_surface(Term, surface(free,Frame,0.0,0.0)) :-
    memberchk(Term, [fan(_,_,_,_),transition(_)]),
    frame(point(0.0,0.0,0.0), vector(0.0,0.0,0.0), vector(0.0,0.0,0.0),
          vector(0.0,0.0,0.0), Frame).

coordinates(point(X0,Y0,Z0), [X,Y,Z|Numbers], Numbers) :-
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0).

frame(point(X,Y,Z), vector(UX,UY,UZ), vector(VX,VY,VZ), vector(WX,WY,WZ),
      [X,Y,Z,UX,UY,UZ,VX,VY,VZ,WX,WY,WZ]).

%   Vector2 is Part times Vector.

part_of(vector(X2,Y2,Z2), vector(X,Y,Z), Part) :-
    Part is (X2*X + Y2*Y + Z2*Z)/(X*X + Y*Y + Z*Z).

%!  flat_bend(-Degrees) is det.
%
%   What bends by no more is flat, if nothing is known of it.

flat_bend(0.01).

                /*******************************
                *         REMEMBERING          *
                *******************************/

%!  facets_of(+Ss:list, -Facets:list) is det.
%
%   Facets has known(S, Surfaces, Runs), by segment_facets/3, of those of the
%   segments Ss of which something is known. Ss ascend.

facets_of([], Facets) :-
    !,
    Facets = [].
facets_of(Ss, Facets) :-
    known_surfaces(Known),
    known_facets(Known, Ss, Facets).

%!  remember_facets(+Facets:list) is det.
%
%   Remember Facets, as of facets_of/2, with the segments: from now on that is
%   what counts, wherever their polygons came from, as long as their rows stay.
%   It is origin(S, surfaces, on(Surfaces, Runs)), and goes into model files.

remember_facets(Facets) :-
    forall(member(known(S,Surfaces,Runs), Facets),
           (   retractall_facts(origin(S, surfaces, _)),
               assert_fact(origin(S, surfaces, on(Surfaces,Runs)))
           )).

%!  remembered_facets(-Facets:list) is det.
%
%   Facets are those that remember_facets/1 was told of, of all segments.

remembered_facets(Facets) :-
    findall(known(S,Surfaces,Runs), origin(S, surfaces, on(Surfaces,Runs)),
            Facets).

%!  remember_only(+Facets:list) is det.
%
%   Forget what remember_facets/1 was told, except for Facets.

remember_only(Facets) :-
    retractall_facts(origin(_, surfaces, _)),
    remember_facets(Facets).

%!  facets_moved(+Matrix) is det.
%
%   The rows of the world were moved by Matrix, three rows of four numbers, so
%   terms do not say any more where surfaces are: that is remembered.

facets_moved(Matrix) :-
    known_surfaces(Known),
    findall(S, ( member(What, Known), arg(1, What, S) ), Ss),
    known_facets(Known, Ss, Facets0),
    maplist(known_moved(Matrix), Facets0, Facets),
    remember_facets(Facets).

known_moved(Matrix, known(S,Surfaces0,Runs), known(S,Surfaces,Runs)) :-
    maplist(moved_surface(Matrix), Surfaces0, Surfaces).
