:- module(sg_shading_leaf,
          [ known_leaf/4,               % +S, +Term, +Matrix, -Leaf
            last_matrix/4,              % +S, +Term, -Matrix, -Leaf
            term_leaf/4,                % +Term, -Parts, -Shape, -Faces
            bent_faces/2,               % +Term, -Bent
            chain_loops/2,              % +Chain, -Loops
            rows_leaf/4                 % +S, +Matrix, -Parts, -Faces
          ]).
:- use_module('../csg/csg_matrix', [identity_matrix/1, rounded_matrix/2]).
:- use_module('../csg/known_surface',
              [plain_surface/2, stands_for/2, term_surfaces/3]).
:- use_module('../kernel', [fill_triangles/3, shape_write/4]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../primitive/primitive_facets', [finer_primitive/3]).
:- use_module('../primitive/primitive',
              [ primitive_faces/3, primitive_name/2, primitive_parts/3,
                primitive_shape/4
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../store',
              [assert_fact/1, facts_transaction/1, segment/3, t/6]).
:- use_module(shading_bend, [bent_polygons/5]).
:- use_module(shading_circle, [circle_surface/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2, nth1/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> The leaves of a shaded picture, from terms and from rows.

A part is flat(Points, Surfaces, Polygons), round(Pieces), ring(Frame, K,
Face) or net(Patches), see kernel/shading.pl. Spheres, hemispheres, eggs,
cylinders and cones are round, also hollow ones: what their terms say
(known_surface.pl), if they have enough facets to stand for it; tori are
rings, Bezier nets nets. What else is curved (turnings, mitred pipes,
transitions) has facets, with the normals of the surfaces for which they
stand, and as many as a picture needs. All others are flat: a facet is seen
as a facet.
*/

%!  known_leaf(+S, +Term, +Matrix, -Leaf) is det.
%
%   Leaf is leaf(Placed, Parts, Shape, Faces) of the primitive Term, or `rows`,
%   of segment S, 0: of none, placed by Matrix: Placed is the placed term, or
%   `rows`, the others are as of term_leaf/4 and rows_leaf/4. What was said of a
%   segment last time is kept, for most of a model that is edited stays as it
%   is.

:- thread_local last_leaf/3.            % S, Term-Matrix, Leaf

known_leaf(S, Term, Matrix, Leaf) :-
    (   S > 0,
        Term \== rows,
        last_leaf(S, Last, Leaf0),
        Last == Term-Matrix
    ->  Leaf = Leaf0
    ;   placed_leaf(S, Term, Matrix, Placed, Parts, Shape, Faces),
        Leaf = leaf(Placed,Parts,Shape,Faces),
        (   S > 0,
            Term \== rows
        ->  retractall(last_leaf(S, _, _)),
            assertz(last_leaf(S, Term-Matrix, Leaf))
        ;   true
        )
    ).

%!  last_matrix(+S, +Term, -Matrix, -Leaf) is semidet.
%
%   Leaf is what known_leaf/4 said last of segment S, if that was of Term and a
%   Matrix.

last_matrix(S, Term, Matrix, Leaf) :-
    last_leaf(S, Last-Matrix, Leaf),
    Last == Term.

placed_leaf(S, rows, Matrix, rows, Parts, Shape, Faces) :-
    !,
    rounded_matrix(Matrix, Rounded),
    rows_leaf(S, Rounded, Parts, Faces),
    Shape = leaf.
placed_leaf(_, Term, Matrix, Placed, Parts, Shape, Faces) :-
    identity_matrix(Identity),
    (   Matrix == Identity
    ->  Placed = Term
    ;   rounded_matrix(Matrix, Rounded),
        Placed = at([matrix(Rounded)], Term)
    ),
    term_leaf(Placed, Parts, Shape, Faces).

%!  term_leaf(+Term, -Parts, -Shape, -Faces) is det.
%
%   True when the primitive Term, placed, is made of Parts. Shape is `leaf` of
%   one part, `without`: of two, the first without the second. Faces are F-What,
%   What as in face_of/3, with curved(Part) for a smooth surface. Faces that are
%   not flat (bent_faces/2) are their triangles.
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
term_leaf(Term, [flat(Points,[],Polygons)], leaf, Faces) :-
    may_be_bent(Term),
    term_triangles(Term, Points, Triangles, [_|_]),
    !,
    primitive_faces(Term, Whats, _),
    findall(F-What, nth1(F, Whats, What), Faces),
    findall(polygon(F,0,[[A,B,C]]), member(F-[A,B,C], Triangles), Polygons).
term_leaf(Term, [net(Patches)], leaf, Faces) :-
    primitive_name(Term, bezier),
    !,
    primitive_parts(Term, _, Named),
    findall(patch(Controls,F)-(F-curved(Part)),
            ( nth1(F, Named, Part-Surface),
              plain_surface(Surface, surface(bezier,Controls,_,_)) ),
            Pairs),
    pairs_keys_values(Pairs, Patches, Faces).
term_leaf(Term0, [flat(Points,Surfaces,Polygons)], leaf, Faces) :-
    (   finer(Term0, Finer)
    ->  Term = Finer
    ;   Term = Term0
    ),
    primitive_shape(Term, _, Points, Chains),
    primitive_faces(Term, Whats, _),
    term_surfaces(Term, Surfaces0, Runs),
    maplist(chain_loops, Chains, Loops),
    face_polygons(Whats, Loops, face(1,0,none), 1, Runs, Polygons0, Faces),
    primitive_parts(Term, Parts, _),
    (   circle_surface(Term0, Surface)
    ->  Surfaces = [Surface],
        maplist(stands_for_it, Polygons0, Polygons)
    ;   Surfaces0 == [],
        memberchk(part(_,divided), Parts)
    ->  bent_polygons(Parts, Points, Polygons0, Polygons, Surfaces)
    ;   Polygons = Polygons0,
        Surfaces = Surfaces0
    ).

stands_for_it(polygon(F,_,Loops), polygon(F,1,Loops)).

%   finer(Term0, Term): what is curved in Term0 has more facets in Term.

finer(Term0, Term) :-
    widest_facet(Term0, Turn),
    finer_primitive(Term0, Turn, Term).

%   widest_facet(Term, Turn): of those that stand for a surface with normals.

widest_facet(Term, Turn) :-
    primitive_parts(Term, Parts, Named),
    aggregate_all(max(Turn0),
                  ( member(part(_,curved(Part,Turn0)), Parts),
                    memberchk(Part-Surface, Named),
                    stands_for(Turn0, Surface),
                    plain_surface(Surface, surface(Kind,_,_,_)),
                    memberchk(Kind, [tapered,turned]) ),
                  Turn).

%   face_polygons(Whats, Loops, Face, P, Runs, Polygons, Faces): polygons from
%   P on. Those of one surface are one face: Face is face(F, K, Part), the next
%   number, and what the last polygon was.

face_polygons([], [], _, _, _, [], []).
face_polygons([What|Whats], [Loops|Rest], face(F0,K0,Part0), P, Runs0,
              [polygon(F,K,Loops)|Polygons], Faces) :-
    run_at(Runs0, P, K, Runs),
    (   K > 0,
        What = curved(Part,_)
    ->  Name = curved(Part)
    ;   Part = none,
        Name = What
    ),
    (   K > 0,
        K =:= K0,
        Part == Part0
    ->  F is F0-1,
        Next = F0,
        Faces = Faces1
    ;   F = F0,
        Next is F0+1,
        Faces = [F-Name|Faces1]
    ),
    Q is P+1,
    face_polygons(Whats, Rest, face(Next,K,Part), Q, Runs, Polygons, Faces1).

%   run_at(Runs0, P, K, Runs): polygon P stands for surface K, 0: for itself;
%   Runs do not end before it.

run_at([run(_,Last,_)|Runs0], P, K, Runs) :-
    Last < P,
    !,
    run_at(Runs0, P, K, Runs).
run_at(Runs, P, K, Runs) :-
    (   Runs = [run(First,_,K0)|_],
        First =< P,
        K0 > 0
    ->  K = K0
    ;   K = 0
    ).

%!  bent_faces(+Term, -Bent) is semidet.
%
%   True when faces of the primitive Term are not flat: Bent is bent(Count, P,
%   Distance), how many, which is the worst, and by how much.

bent_faces(Term, bent(Count,P,Off)) :-
    may_be_bent(Term),
    term_triangles(Term, _, _, Bent),
    last(Bent, Off-P),
    length(Bent, Count).

%   may_be_bent(Term): its points say whether its faces are flat.

may_be_bent(Term) :-
    primitive_name(Term, polyhedron).

%   term_triangles(Term, Points, Triangles, Bent): Triangles are P-[A,B,C],
%   places of Points; Bent are Off-P, the worst last. The rows of a segment that
%   has them are taken back.

term_triangles(Term, Points, Triangles, Bent) :-
    primitive_shape(Term, Kind, Points, Chains),
    (   aggregate_all(max(S0), segment(S0, _, _), Last)
    ->  S is Last+1
    ;   S = 1
    ),
    catch(facts_transaction(
              ( assert_fact(segment(S, Kind, Term)),
                shape_write(S, Points, Chains, true),
                limit_value(contacts, Most),
                fill_triangles([S], Most, Faults),
                findall(P-[A,B,C], t(S, P, _, A, B, C), Triangles),
                throw(sg_triangles(Triangles,Faults)) )),
          sg_triangles(Triangles,Faults), true),
    findall(Off-P, member(fault(S,P,not_flat(Off)), Faults), Bent0),
    msort(Bent0, Bent).

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

%!  chain_loops(+Chain:list, -Loops:list) is det.
%
%   Loops are those of a vertex list (polygon_list.pl): a jump begins a hole,
%   and loops close where there is one.

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
