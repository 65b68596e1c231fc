:- module(sg_true_parallel,
          [ parallel_made/4,            % +Term, +By, +Inmost, -S1
            regular_level/5             % +Cone, +Ts, +By, +Inmost, -Level
          ]).
:- use_module('../kernel', [surface_place/4]).
:- use_module('../primitive/primitive_rows', [add_shape/5]).
:- use_module('../primitive/parallel_surface',
              [parallel_before/5, parallel_generator/4]).
:- use_module('../primitive/primitive', [primitive_faces/3, primitive_shape/4]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../store', [assert_fact/1]).
:- use_module(true_surface, [offset_surface/3]).
:- use_module('../vector', [angle_between/3, difference/3, dot_product/3]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, member/2, min_list/2, nth1/3,
                same_length/2
              ]).
:- use_module(library(pairs), [pairs_keys/2, pairs_values/2]).
/** <module> The other side of a plate of any cylinder or cone.

What lies everywhere at one distance from an oblique or elliptic cylinder or
cone is no such surface (parallel_surface.pl), and no primitive. Its facets lie
between the same generators, moved, and end in the planes of base and top. A
moved cone has no apex: outward its generators pass each other by, inward they
meet before they reach one. There it ends in a small flat face: outward in the
plane of the apex, inward, and where sides hang over, where generators begin to
meet; also those of the layer that is unrolled.

Such a segment S1 is called parallel(By, Term), and has (placed_surface.pl
reads it)

    origin(S1, face(P), What)                    as face_of/3
    origin(S1, part(Part), Surface)    as smooth_surface/3
*/

%!  parallel_made(+Term, +By, +Inmost, -S1) is semidet.
%
%   S1 is a new segment, what lies By outside the primitive Term, whose round
%   faces are all cylinders or cones (model units; negative: within). Of a
%   pointed cone it ends before generators meet in the layer that is Inmost
%   outside Term. Fails if there is no such thing.

parallel_made(Term, By, Inmost, S1) :-
    primitive_faces(Term, Whats0, Surfaces0),
    maplist(parallel_surface(By), Surfaces0, Surfaces),
    primitive_shape(Term, Kind, Points0, Chains0),
    corner_parts(Whats0, Chains0, Parts),
    same_length(Points0, Parts),
    length(Points0, Count),
    apex(Count, Parts, Surfaces0, Apex),
    maplist(corner_place(Surfaces0), Points0, Parts, Places),
    tip_level(Apex, Surfaces0, Places, By-Inmost, Level),
    moved_points(Apex, Places, Surfaces, Level, Points),
    maplist(faces_moved(Apex, Count, Surfaces), Whats0, Chains0, Lists),
    append(Lists, Faces0),
    tip_face(Apex, Count, Chains0, Tip),
    append(Faces0, Tip, Faces),
    nothing_turned(Chains0, Apex, Points0, Points),
    pairs_keys(Faces, Whats),
    pairs_values(Faces, Chains),
    add_shape(Kind, parallel(By, Term), Points, Chains, S1),
    forall(nth1(P, Whats, What), assert_fact(origin(S1, face(P), What))),
    forall(member(Part-Surface, Surfaces),
           assert_fact(origin(S1, part(Part), Surface))).

parallel_surface(By, Part-Surface0, Part-Surface) :-
    functor(Surface0, Kind, _),
    memberchk(Kind, [cylinder,cone]),
    (   Surface0 \= cone(_, _, _, _, 0.0),
        offset_surface(Surface0, By, Surface)
    ->  true
    ;   Surface = parallel(Surface0, By)
    ).


                /*******************************
                *            CORNERS           *
                *******************************/

%   corner_parts(Whats, Chains, Parts): the curved part that each vertex is on,
%   which is one.

corner_parts(Whats, Chains, Parts) :-
    findall(V-Part,
            ( nth1(I, Whats, curved(Part, _)),
              nth1(I, Chains, Chain),
              member(V, Chain) ),
            Pairs0),
    sort(Pairs0, Pairs),
    pairs_keys(Pairs, Vs),
    sort(Vs, Distinct),
    same_length(Pairs, Distinct),
    pairs_values(Pairs, Parts).

%   apex(Count, Parts, Surfaces, Apex): the vertex that is that
%   of a pointed cone, the last of Count; or `none`.

apex(Count, Parts, Surfaces, Apex) :-
    (   nth1(Count, Parts, Part),
        memberchk(Part-cone(_, _, _, _, K), Surfaces),
        K =:= 0.0
    ->  Apex = Count
    ;   Apex = none
    ).

%   corner_place(Surfaces, Point, Part, Place): Part-T-H, H 0.0 or 1.0.

corner_place(Surfaces, Point, Part, Part-T-H) :-
    memberchk(Part-Surface, Surfaces),
    surface_place(Surface, Point, T, H0),
    H is float(round(H0)).

%   tip_level(Apex, Surfaces, Places, By-Inmost, Level): where the moved cone
%   ends.

tip_level(none, _, _, _, none) :-
    !.
tip_level(_, [_-Surface], Places, By-Inmost, Level) :-
    findall(T, member(_-T-0.0, Places), Ts),
    regular_level(Surface, Ts, By, Inmost, Level),
    Level > 0.0.

%!  regular_level(+Cone, +Ts, +By, +Inmost, -Level) is det.
%
%   Up to H = Level of what lies By outside Cone, which gets narrower, its
%   generators at Ts (degrees) do not yet meet, neither there nor in the layer
%   that is Inmost outside Cone; 1.0 if they do not at all.

regular_level(Surface, Ts, By, Inmost, Level) :-
    findall(H,
            ( member(T, Ts), regular_up_to(Surface, By-Inmost, T, H) ),
            Hs),
    min_list([1.0|Hs], Level).

%   regular_up_to(Surface, By-Inmost, T, H): in the layer Inmost the generator
%   at T and its neighbours do not yet meet at H of what is By outside. The
%   radius of curvature grows with the distance from the apex; beyond it, where
%   the outside of an overhanging side comes, it is less than 0. With Inmost it
%   must be more than 0, by a twentieth of how far is gone.

regular_up_to(Surface, By-Inmost, T, H) :-
    Before is T-0.01,
    After is T+0.01,
    parallel_generator(Surface, Before, Along1, Normal1),
    parallel_generator(Surface, After, Along2, Normal2),
    angle_between(Along1, Along2, Angle),
    angle_between(Normal1, Normal2, Turning),
    parallel_generator(Surface, T, Along, _),
    dot_product(Along, Along, Square),
    Surface = cone(_, _, _, _, K),
    Apex is 1.0/(1.0-K),
    Way is 0.05*max(abs(By), abs(Inmost)) - Inmost,
    H0 is Apex - Way*Turning/(Angle*sqrt(Square)),
    parallel_before(Surface, By, T, 0.0, Less),
    H is H0-Less.

moved_points(none, Places, Surfaces, _, Points) :-
    !,
    maplist(moved_point(Surfaces), Places, Points).
moved_points(_, Places, Surfaces, Level, Points) :-
    append(Base, [_], Places),
    maplist(moved_point(Surfaces), Base, Low),
    maplist(at_level(Level), Base, Tip),
    maplist(moved_point(Surfaces), Tip, High),
    append(Low, High, Points).

at_level(Level, Part-T-_, Part-T-Level).

moved_point(Surfaces, Part-T-H, Point) :-
    memberchk(Part-Surface, Surfaces),
    surface_point(Surface, T, H, Point).


                /*******************************
                *             FACES            *
                *******************************/

%   faces_moved(Apex, Count, Surfaces, What, Chain, Faces): of What-Chain. Sides
%   of a moved cone are not flat: two triangles each. That of V at the tip is
%   V + Count - 1.

faces_moved(Apex, Count, _, What, Chain, Faces) :-
    Apex \== none,
    What = curved(_, _),
    !,
    base_edge(Chain, Apex, A, B),
    C is B+Count-1,
    D is A+Count-1,
    Faces = [What-[A,B,C],What-[A,C,D]].
faces_moved(_, _, Surfaces, What, Chain, Faces) :-
    (   What = curved(Part, _),
        memberchk(Part-parallel(cone(_, _, _, _, _), _), Surfaces),
        Chain = [A,B,C,D]
    ->  Faces = [What-[A,B,C],What-[A,C,D]]
    ;   Faces = [What-Chain]
    ).

base_edge(Chain, Apex, A, B) :-
    append(Front, [Apex|Back], Chain),
    append(Back, Front, [A,B]),
    !.

tip_face(none, _, _, []) :-
    !.
tip_face(Apex, Count, Chains, [top-Ring]) :-
    findall(A-B, ( member(Chain, Chains), length(Chain, 3),
                   memberchk(Apex, Chain), base_edge(Chain, Apex, A, B) ),
            Edges),
    Edges = [First-_|_],
    list_to_assoc(Edges, Next),
    ring(First, First, Next, Vs),
    Step is Count-1,
    maplist(plus(Step), Vs, Ring).

ring(V, First, Next, [V|Vs]) :-
    get_assoc(V, Next, W),
    (   W =:= First
    ->  Vs = []
    ;   ring(W, First, Next, Vs)
    ).

%   nothing_turned(Chains, Apex, Points0, Points): no edge turned round.

nothing_turned(Chains, Apex, Points0, Points) :-
    Table0 =.. [points|Points0],
    Table =.. [points|Points],
    forall(( member(Chain, Chains),
             last(Chain, Last),
             append(_, [A,B|_], [Last|Chain]),
             A > 0, B > 0,
             A \== Apex, B \== Apex ),
           ( way(Table0, A, B, Way0),
             way(Table, A, B, Way),
             dot_product(Way0, Way, Along),
             Along > 0.0 )).

way(Table, A, B, Way) :-
    arg(A, Table, point(X1,Y1,Z1)),
    arg(B, Table, point(X2,Y2,Z2)),
    difference(p(X2,Y2,Z2), p(X1,Y1,Z1), Way).
