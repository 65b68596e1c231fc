:- module(sg_shading_leaf,
          [ term_leaf/4,                % +Term, -Parts, -Shape, -Faces
            rows_leaf/4                 % +S, +Matrix, -Parts, -Faces
          ]).
:- use_module('../csg/known_surface', [plain_surface/2, stands_for/2]).
:- use_module('../primitive/primitive',
              [ primitive_faces/3, primitive_name/2, primitive_parts/3,
                primitive_shape/4
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../store', [t/6]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2]).
/** <module> The leaves of a shaded picture, from terms and from rows.

A part is flat(Points, Polygons) or round(Pieces), see kernel/shading.pl.
Spheres, hemispheres, eggs, cylinders and cones are round, also hollow ones:
what their terms say (known_surface.pl), if they have enough facets to stand
for it. All others are flat: a facet is seen as a facet.
*/

%!  term_leaf(+Term, -Parts, -Shape, -Faces) is det.
%
%   True when the primitive Term, placed, is made of Parts. Shape is `leaf` of
%   one part, `without`: of two, the first without the second. Faces are F-What,
%   What as in face_of/3, with curved(Part) for a smooth surface.
%
%   @error as primitive_shape/4

term_leaf(Term, Parts, Shape, Faces) :-
    primitive_name(Term, Name),
    round_name(Name),
    primitive_parts(Term, Runs, Surfaces),
    maplist(known_surface_of(Runs), Surfaces, Known),
    round_leaf(Name, Known, Parts0, Shape0, Faces0),
    !,
    Parts = Parts0,
    Shape = Shape0,
    Faces = Faces0.
term_leaf(Term, [flat(Points,Polygons)], leaf, Faces) :-
    primitive_shape(Term, _, Points, Chains),
    primitive_faces(Term, Whats, _),
    polygons_of(Chains, Whats, 1, Polygons, Faces).

round_name(sphere).
round_name(hemisphere).
round_name(egg).
round_name(cylinder).
round_name(hollow_cylinder).
round_name(cone).
round_name(torus).

%   known_surface_of(Runs, Part-Surface, Part-Known): fails if its facets stand
%   for themselves.

known_surface_of(Runs, Part-Surface, Part-Known) :-
    forall(member(part(_, curved(Part,Turn)), Runs),
           stands_for(Turn, Surface)),
    once(plain_surface(Surface, Known)).

polygons_of([], [], _, [], []).
polygons_of([Chain|Chains], [What|Whats], F, [polygon(F,Loops)|Polygons],
            [F-What|Faces]) :-
    chain_loops(Chain, Loops),
    G is F+1,
    polygons_of(Chains, Whats, G, Polygons, Faces).

%   chain_loops(Chain, Loops): a vertex list (polygon_list.pl): a jump begins a
%   hole, and loops close where there is one.

chain_loops(Chain, Loops) :-
    (   append(First, [Jump|Rest], Chain),
        Jump < 0
    ->  open_loop(First, Loop),
        V is -Jump,
        Loops = [Loop|Loops1],
        chain_loops([V|Rest], Loops1)
    ;   open_loop(Chain, Loop),
        Loops = [Loop]
    ).

open_loop([V|Vs], Loop) :-
    (   append(Inner, [V], Vs)
    ->  Loop = [V|Inner]
    ;   Loop = [V|Vs]
    ).

%   round_leaf(Name, Known, Parts, Shape, Faces)

round_leaf(sphere, [Part-Surface], [round([Piece])], leaf, [1-curved(Part)]) :-
    piece(Surface, 0.0-(-1), 0.0-(-1), 1, Piece).
round_leaf(hemisphere, [Part-Surface], [round([Piece])], leaf,
           [1-base,2-curved(Part)]) :-
    piece(Surface, 0.0-1, 1.0-(-1), 2, Piece).
round_leaf(egg, [Lower-Surface1,Upper-Surface2], [round([Piece1,Piece2])], leaf,
           [1-curved(Lower),2-curved(Upper)]) :-
    piece(Surface1, -1.0-(-1), 0.0-0, 1, Piece1),
    piece(Surface2, 0.0-0, 1.0-(-1), 2, Piece2).
round_leaf(cylinder, [Part-Surface], [round([Piece])], leaf,
           [1-base,2-top,3-curved(Part)]) :-
    piece(Surface, 0.0-1, 1.0-2, 3, Piece).
round_leaf(cone, [Part-Surface], [round([Piece])], leaf,
           [1-base,2-top,3-curved(Part)]) :-
    piece(Surface, 0.0-1, 1.0-2, 3, Piece).
round_leaf(hollow_cylinder, Known, [round([Piece1]),round([Piece2])], without,
           [1-base,2-top,3-curved(outer),4-curved(inner)]) :-
    memberchk(outer-Surface1, Known),
    memberchk(inner-Surface2, Known),
    piece(Surface1, 0.0-1, 1.0-2, 3, Piece1),
    piece(Surface2, 0.0-1, 1.0-2, 4, Piece2).

round_leaf(torus, [Part-surface(torus,Frame,K,_)], [ring(Frame,K,1)], leaf,
           [1-curved(Part)]).

%   piece(Surface, Low-LowFace, High-HighFace, Face, Piece): of a quadric alone.

piece(surface(Kind,Frame,A,B), Low-LowFace, High-HighFace, Face,
      piece(Kind,Frame,A,Low,LowFace,High,HighFace,Face)) :-
    (   Kind == sphere
    ->  true
    ;   Kind == tapered,
        abs(A-B) =< 2.0** -40
    ).

%!  rows_leaf(+S, +Matrix, -Parts, -Faces) is det.
%
%   The rows of segment S, placed by Matrix, three rows of four numbers. Faces
%   is []: face F is polygon F. A segment without triangles gets them.

rows_leaf(S, Matrix, [rows(S,Map)], []) :-
    (   t(S, _, _, _, _, _)
    ->  true
    ;   complete_segments([S])
    ),
    append(Matrix, Map).
