:- module(test_edges_of_terms, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/role), [look_part/3]).
:- use_module(rules(kernel), [scene_edge/5]).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(primitive/primitive_face),
              [face_of/3, smooth_surface/3, surface_point/4]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(csg/csg), [root_segment/1]).
:- use_module(tests('oracle/known_surface'), [polygon_face/3]).
:- use_module(rules(csg/csg_roots), [roots_alone/0]).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(model/model), [load_model/1, save_model/1]).
:- use_module(tests('rules/contour_same'), [same_as_rule/2]).
:- use_module(rules(store)).
:- use_module(rules(vector),
              [angle_between/3, cross_product/3, difference/3,
               vector_sum/3]).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

% Edges that the terms tell: between what face_of/3 names differently an edge is
% drawn, however flat, unless both are tangent there; inside a curved face none
% is a crease. What they are is worked out here from face_of/3, the corners, and
% differences of surface_point/4.

% random_term(Term): shallow more often than not.

random_term(Term) :-
    findall(Kind, clause(term_of(Kind, _), _), Kinds0),
    sort(Kinds0, Kinds),
    random_member(Kind, Kinds),
    once(term_of(Kind, Inner)),
    (   maybe(0.5)
    ->  Term = Inner
    ;   maplist(random(-2.0, 2.0), [X,Y,Z,A,B,C]),
        maplist(factor, [F,G,H]),
        random(0.0, 360.0, Turn),
        Term = at([scale(F,G,H), rotate(axis(X,Y,Z), Turn),
                   translate(A,B,C)], Inner)
    ).

factor(F) :-
    random(0.5, 2.0, F0),
    ( maybe(0.3) -> F is -F0 ; F = F0 ).

% height(H): from 0.00002 to 2.

height(H) :-
    random(-4.7, 0.3, E),
    H is 10**E.

facets(N) :-
    random_between(3, 40, N).

fine(N) :-
    random_between(9, 40, N).

term_of(box, box(size(A,B,H))) :-
    maplist(random(0.5, 2.0), [A,B]),
    height(H).
term_of(pyramid, pyramid(base(A,B), height(H), shift(X,Y))) :-
    maplist(random(0.5, 2.0), [A,B]),
    maplist(random(-0.5, 0.5), [X,Y]),
    height(H).
term_of(pyramid_on, pyramid(outline(Outline), height(H))) :-
    star(Outline),
    height(H).
term_of(prism, prism(outline(Outline), height(H))) :-
    star(Outline),
    height(H).
term_of(frustum, prism(outline(Outline), height(H), scale(F))) :-
    star(Outline),
    height(H),
    random(0.1, 2.0, F).
term_of(twisted, prism(outline(Outline), height(H), twist(T), slices(N))) :-
    star(Outline),
    random(0.5, 2.0, H),
    random(-60.0, 60.0, T),
    random_between(8, 20, N).
term_of(ridge, prism(outline([[-1,-1],[1,-1],[1,1],[-1,1]]), height(H),
                     scale(F,G))) :-
    height(H),
    random_member(F-G, [1-0,0-1,0.5-2]).
term_of(cylinder, cylinder(radius(A,B), height(H), facets(N), shift(X,Y))) :-
    maplist(random(0.5, 2.0), [A,B]),
    maplist(random(-0.5, 0.5), [X,Y]),
    height(H),
    facets(N).
term_of(hollow, hollow_cylinder(radius(2), inner(1), height(H), facets(N))) :-
    height(H),
    fine(N).
term_of(cone, cone(radius(A,B), height(H), facets(N), shift(X,Y))) :-
    maplist(random(0.5, 2.0), [A,B]),
    maplist(random(-0.5, 0.5), [X,Y]),
    height(H),
    facets(N).
term_of(frustum_of_cone, cone(radius(A), top(B), height(H), facets(N))) :-
    maplist(random(0.5, 2.0), [A,B]),
    height(H),
    facets(N).
term_of(to_round, cone(radius(2,1), top(0.5,0.7), height(H), facets(N))) :-
    height(H),
    fine(N).
term_of(sphere, sphere(radius(A,B,C), facets(N), bands(M))) :-
    maplist(random(0.5, 2.0), [A,B,C]),
    facets(N),
    random_between(2, 20, M).
term_of(egg, egg(radius(A), up(B), down(C), facets(N))) :-
    maplist(random(0.5, 2.0), [A,B,C]),
    fine(N).
term_of(hemisphere, hemisphere(radius(A,B,C), facets(N))) :-
    maplist(random(0.5, 2.0), [A,B]),
    height(C),
    fine(N).
term_of(torus, torus(radius(2), tube(R), facets(N), sides(M))) :-
    random(0.2, 1.5, R),
    facets(N),
    random_between(3, 20, M).
term_of(turning, turning(outline(Outline), angle(Angle), facets(N))) :-
    steps(Outline),
    random_member(Angle, [360,360,250,90]),
    fine(N).
term_of(transition, transition(base(Base), top(Top), height(H), facets(N),
                               turn(Turn))) :-
    plate(Base),
    plate(Top),
    random(0.0, 90.0, Turn),
    random(0.2, 3.0, H),
    N0 = 8,
    random_between(3, 8, Times),
    N is N0*Times.
term_of(polyhedron, polyhedron(points([[1,0,0],[0,1,0],[-1,0,0],[0,-1,0],
                                       [X,Y,H],[0,0,D]]),
                               faces([[1,2,5],[2,3,5],[3,4,5],[4,1,5],
                                      [2,1,6],[3,2,6],[4,3,6],[1,4,6]]))) :-
    maplist(random(-0.2, 0.2), [X,Y]),
    height(H),
    height(D0),
    D is -D0.

% star(Outline): round the origin, counter-clockwise, no corner straight.

star(Outline) :-
    random_between(3, 24, N),
    findall([X,Y],
            ( between(1, N, I),
              random(0.8, 1.2, R0),
              ( N =< 4 -> R = 1.0 ; R = R0 ),
              X is R*cos(2*pi*I/N),
              Y is R*sin(2*pi*I/N) ),
            Outline).

% steps(Outline): of a turning, from the axis out and back up, in small steps.

steps([[0.0,0.0]|Outline]) :-
    random_between(2, 5, N),
    findall(R-D, ( between(1, N, _), random(0.2, 0.5, R), height(D) ), Steps),
    foldl(stepped, Steps, [], Back, 0.0-0.0, R-_),
    reverse(Back, Out),
    append(Out, [[R,1.0],[0.0,1.2]], Outline).

stepped(R1-D, Back, [[R,Z]|Back], R0-_, R-Z) :-
    R is R0+R1,
    Z is min(0.9, D).

plate(circle(R)) :-
    maybe(0.3),
    !,
    random(0.5, 1.5, R).
plate(rectangle(A,B)) :-
    maybe(0.5),
    !,
    maplist(random(0.5, 2.0), [A,B]).
plate(rectangle(A,B,0.2)) :-
    maplist(random(0.5, 2.0), [A,B]).

/* - - - what is expected - - - */

% named(S, P, Name): facets that are too wide are faces.

named(S, P, Name) :-
    face_of(S, P, What),
    !,
    (   What = curved(Part, Ranges),
        smooth_surface(S, Part, Surface),
        \+ wide(Ranges, Surface)
    ->  Name = smooth(Part)
    ;   What = curved(_, _)
    ->  Name = facet(P)
    ;   Name = What
    ).

wide(Ranges, Surface) :-
    functor(Surface, Kind, _),
    member(From-To, Ranges),
    (   memberchk(Kind, [cylinder,cone,ruled])
    ->  abs(To-From) >= 45-1.0e-5
    ;   abs(To-From) >= 90-1.0e-5
    ).

% expected(S, E, P, Q, What): what edge E between polygons P and Q is: `edge`,
% `none`, or `unsure` (nearly tangent, or only as fine as the facets).

expected(S, E, P, Q, What) :-
    named(S, P, Name1),
    named(S, Q, Name2),
    (   Name1 == Name2
    ->  (   Name1 = smooth(_)
        ->  What = none
        ;   What = unsure
        )
    ;   ( Name1 = smooth(cone(_)) ; Name2 = smooth(cone(_)) ),
        \+ memberchk(base, [Name1,Name2]),
        \+ memberchk(top, [Name1,Name2])
    ->  What = unsure
    ;   findall(Degrees,
                ( edge_end(S, E, V),
                  look(S, P, Name1, V, N1),
                  look(S, Q, Name2, V, N2),
                  angle_between(N1, N2, Angle),
                  Degrees is min(Angle, pi-Angle)*180/pi ),
                Bends),
        ( Bends == [] -> What = unsure
        ; max_list(Bends, Bend),
          ( Bend > 1.0e-4 -> What = edge
          ; Bend < 1.0e-6 -> What = none
          ; What = unsure )
        )
    ).

edge_end(S, E, V) :-
    e(S, E, V1, V2, _),
    member(V, [V1,V2]).

% look(S, P, Name, V, Normal): of the surface there, or of the polygon; the sign
% is not known.

look(S, P, smooth(Part), V, Normal) :-
    !,
    face_of(S, P, curved(Part, Ranges)),
    smooth_surface(S, Part, Surface),
    v(S, V, X, Y, Z),
    findall(D-(T-H),
            ( parameters(Ranges, T, H),
              surface_point(Surface, T, H, point(X1,Y1,Z1)),
              D is (X1-X)**2 + (Y1-Y)**2 + (Z1-Z)**2 ),
            Near0),
    msort(Near0, [Least-(T-H)|_]),
    Least < 1.0e-12,
    ( Ranges = [_] -> DH = 1.0e-4 ; DH = 1.0e-2 ),
    maplist(moved_point(Surface, T, H),
            [1.0e-2-0,-1.0e-2-0,0-DH,0-(-DH)], [A1,A0,B1,B0]),
    difference(A1, A0, A),
    difference(B1, B0, B),
    cross_product(A, B, Normal),
    Normal = p(NX,NY,NZ),
    NX*NX + NY*NY + NZ*NZ > 1.0e-22.
look(S, P, _, _, Normal) :-
    p(S, P, Es),
    findall(A-B, ( member(E, Es), e(S, E, V1, V2, _), place(S, V1, A),
                   place(S, V2, B) ), Sides),
    foldl(newell, Sides, p(0.0,0.0,0.0), Normal).

parameters([T1-T2], T, H) :-
    member(T, [T1,T2]),
    member(H, [0.0,1.0]).
parameters([T1-T2,S1-S2], T, H) :-
    member(T, [T1,T2]),
    member(H, [S1,S2]).

moved_point(Surface, T0, H0, DT-DH, p(X,Y,Z)) :-
    T is T0+DT,
    H is H0+DH,
    surface_point(Surface, T, H, point(X,Y,Z)).

place(S, V, p(X,Y,Z)) :-
    v(S, V, X, Y, Z).

newell(A-B, Sum0, Sum) :-
    cross_product(A, B, C),
    vector_sum(Sum0, C, Sum).

/* - - - what is drawn - - - */

% edge_of_two(S, E, P, Q): a line and its polygons.

edge_of_two(S, E, P, Q) :-
    e(S, E, V1, V2, 1),
    e(S, Twin, V2, V1, _),
    E < Twin,
    edge_polygon(S, E, P),
    edge_polygon(S, Twin, Q).

%   wrong(S, Wrong): an edge that is drawn as something else or not at all, or
%   what is drawn as a crease and is none. What lies behind itself or near an
%   outline is not drawn with lines(all) either.

wrong(S, Wrong) :-
    picture([lines(all)]),
    findall(E-edge(P,Q,What),
            ( edge_of_two(S, E, P, Q), expected(S, E, P, Q, What) ),
            Edges),
    (   smooth_surface(S, _, Surface),
        functor(Surface, Kind, _),
        memberchk(Kind, [sphere,torus])
    ->  Outlines = inside           % of facets: rims end where these begin
    ;   Outlines = none
    ),
    findall(E-(To-From)-Role, drawn(_, S, E, From, To, _, Role), All),
    picture([]),
    findall(E-(To-From)-Role, drawn(_, S, E, From, To, _, Role), Feature),
    member(E-Edge, Edges),
    wrong_edge(Edge, E, All, Feature, Wrong),
    \+ ( Outlines == inside, Wrong = missing(_, _, _) ).

wrong_edge(edge(P,Q,edge), E, All, _, role(E,P,Q,Role)) :-
    member(E-_-Role, All),
    \+ memberchk(Role, [crease,outline]),
    !.
wrong_edge(edge(P,Q,edge), E, All, Feature, missing(E,P,Q)) :-
    drawn_length(E, All, Length0),
    drawn_length(E, Feature, Length),
    Length < Length0 - 1.0e-9.
wrong_edge(edge(P,Q,none), E, _, Feature, crease(E,P,Q)) :-
    memberchk(E-_-crease, Feature).

drawn_length(E, Drawn, Sum) :-
    findall(L, ( member(E-(To-From)-_, Drawn), L is To-From ), Ls),
    sum_list(Ls, Sum).

random_seen(Theta, Phi) :-
    random(0.0, 360.0, Theta),
    random(5.0, 80.0, Phi).

cases(N) :-
    (   getenv('EDGE_CASES', Text)
    ->  atom_number(Text, N)
    ;   N = 60
    ).

case(I) :-
    cases(N),
    between(1, N, I).

pictured_wrong(I, Wrong) :-
    Seed is 20261122+I,
    set_random(seed(Seed)),
    random_term(Term),
    random_seen(Theta, Phi),
    in_new_world(( set_view(Theta, Phi, 0),
                   catch(add_primitive(Term, S),
                         error(model_error(primitive(_, _)), _), fail),
                   complete_segments([S]),
                   findall(Term-W, wrong(S, W), Wrong) )),
    !.
pictured_wrong(_, []).

:- begin_tests(edges_of_terms).

test(random, [ forall(case(I)), Wrong == [] ]) :-
    pictured_wrong(I, Wrong).

:- end_tests(edges_of_terms).

% What becomes of a flat pyramid: its four ridges are drawn.

flat(H, Pyramid) :-
    Pyramid = pyramid(base(4,4), height(H)).
flat(H, at([rotate(x,20), scale(1,-2,1), translate(1,2,3)],
           pyramid(base(4,4), height(H)))).
flat(H, at([rotate(x,20), translate(1,2,3)],
           difference([pyramid(base(4,4), height(H)),
                       at([translate(0,0,-1)], box(size(1,1,Deep)))]))) :-
    Deep is 1+H*0.4.
flat(H, join([box(size(1,1,1)), at([translate(5,0,0)],
                                   pyramid(base(4,4), height(H)))])).
flat(H, at([mirror(x)],
           join([box(size(1,1,1)), at([translate(5,0,0)],
                                      pyramid(base(4,4), height(H)))]))).
flat(H, union([at([translate(0,0,-1)], box(size(4,4,1))),
               pyramid(base(4,4), height(H))])).

low(H) :-
    between(1, 9, I),
    H is 10.0**(-I).

ridges(S, Vertex, Count) :-
    aggregate_all(count,
                  ( e(S, E, V1, V2, 1),
                    ( V1 == Vertex ; V2 == Vertex ),
                    drawn(_, S, E, 0.0, 1.0, visible, crease) ),
                  Count).

% in_tree(Term, Goal): Goal with the solid of Term in the world.

in_tree(Term, Goal) :-
    in_new_world(( (   is_tree(Term)
                   ->  assert_fact(segment(1, solid, Term)),
                       evaluate
                   ;   add_primitive(Term, S),
                       complete_segments([S])
                   ),
                   Goal )).

is_tree(at(_, Term)) :-
    is_tree(Term).
is_tree(Term) :-
    functor(Term, Name, 1),
    memberchk(Name, [union,join,difference]).

%   apex(S, V): the vertex that four ridges come to: of an apex of four edges.

apex(S, V) :-
    root_segment(S),
    v(S, V, _, _, _),
    aggregate_all(count, e(S, _, V, _, 1), 4),
    !.

from_above(Goal) :-
    set_view(30, 20, 0),
    picture([]),
    call(Goal).

%   inner_crease(S): a crease between polygons of one named face.

inner_crease(S) :-
    drawn(_, S, E, _, _, _, crease),
    once(e(S, E, A, B, _)),
    findall(Id,
            ( ( e(S, F, A, B, _) ; e(S, F, B, A, _) ),
              edge_polygon(S, F, P),
              polygon_face(S, P, Id)
            ),
            [Id1,Id2]),
    Id1 == Id2.

%   rising_line(S, X, Y): from X, Y of the base a drawn line goes up that is
%   drawn whatever the eye.

rising_line(S, X, Y) :-
    drawn(_, S, E, _, _, _, Role),
    memberchk(Role, [crease,outline]),
    e(S, E, A, B, _),
    (   v(S, A, X, Y, 0.0), v(S, B, _, _, Z)
    ;   v(S, B, X, Y, 0.0), v(S, A, _, _, Z)
    ),
    Z > 0.0.

% Pyramids that are lower than the tolerance are told.

:- multifile user:message_hook/3.

user:message_hook(sanggwan(tight(_,_,_,_,_,_)), warning, _).

:- begin_tests(flat_pyramids).

test(drawn, [ forall(( low(H), flat(H, Term) )), Count == 4 ]) :-
    in_tree(Term, from_above(( apex(S, V), ridges(S, V, Count) ))).
test(alone, [ forall(flat(0.5, Term)), Count == 4 ]) :-
    in_tree(Term, ( roots_alone,
                    from_above(( apex(S, V), ridges(S, V, Count) )) )).
test(read_back, [ forall(flat(0.5, Term)), Count == 4 ]) :-
    tmp_file_stream(File, Out, [extension(pl)]),
    close(Out),
    call_cleanup(
        ( in_tree(Term, save_model(File)),
          in_new_world(( load_model(File), evaluate,
                         from_above(( apex(S, V),
                                      ridges(S, V, Count) )) )) ),
        delete_file(File)).
test(kernel, [ forall(( member(H, [0.5,1.0e-4,1.0e-8,1.0e-13]),
                        flat(H, Term) )), nondet ]) :-
    in_tree(Term, from_above(( root_segment(S), same_as_rule(S, 30) ))).

%   A wall of a prism that turns is one face, however much its triangles bend.

test(twisted_walls, [ forall(member(Slices, [2,3,5,8])), Count == 0 ]) :-
    in_tree(prism(outline([[0,0],[4,0],[4,4],[0,4]]), height(4), twist(60),
                  slices(Slices)),
            from_above(( root_segment(S),
                         aggregate_all(count, inner_crease(S), Count) ))).

%   Walls on one line are one, also where the outline begins in the middle of
%   the line, and so are those of a hole; but a corner parts two.

test(straight_walls,
     [ forall(( member(Slices, [2,3,5,8]), member(Scale, [1,0.5]) )),
       Feet == [0.0-0.0,0.0-4.0,1.0-1.0,1.0-3.0,3.0-1.0,3.0-3.0,4.0-0.0,
                4.0-4.0]
     ]) :-
    in_tree(prism(outline([[2,0],[3,0],[4,0],[4,4],[0,4],[0,1.3],[0,0],[1,0]]),
                  holes([[[1,1],[1,2],[1,3],[3,3],[3,1],[2,1]]]),
                  height(4), twist(53.7), scale(Scale), slices(Slices)),
            from_above(( root_segment(S),
                         findall(X-Y, rising_line(S, X, Y), Feet0) ))),
    sort(Feet0, Feet).

:- end_tests(flat_pyramids).

% However low a thing is, what its term names apart is drawn apart.
% drawn_apart(H, Term, N): N edges rise or turn inside its outline.

drawn_apart(H, pyramid(base(4,4), height(H)), 4).
drawn_apart(H, prism(outline([[-2,-2],[2,-2],[2,2],[-2,2]]), height(H),
                     scale(0.5)), 8).
drawn_apart(H, cone(radius(2), top(1), height(H), facets(24)), 24).
drawn_apart(H, turning(outline([[0,0],[2,0],[1.5,H],[1,H],[0,H2]]),
                       facets(24)), 48) :-
    H2 is 2*H.
drawn_apart(H, transition(base(rectangle(4,4)), top(rectangle(2,2)),
                          height(H), facets(24)), 8).
drawn_apart(H, sheet(points([[0,0,0],[2,0,0],[2,2,H],[0,2,0]]),
                     faces([[1,2,3],[1,3,4]])), 1).

% What is flat stays without a line, however it is turned: in_one_plane(Term).

in_one_plane(sheet(points([[0,0,0],[1,0,0],[2,0,0],[2,1,0],[1,1,0],[0,1,0]]),
                   faces([[1,2,5,6],[2,3,4,5]]))).
in_one_plane(sheet(points([[0.1,0,0.03],[1.1,0,0.33],[2.1,0,0.63],
                           [2.1,0.7,1.33],[1.1,0.7,1.03],[0.1,0.7,0.73]]),
                   faces([[1,2,5,6],[2,3,5],[3,4,5]]))).
in_one_plane(pyramid(outline([[-2,-2],[0.1,-2],[2,-2],[2,0.3],[2,2],[-2,2]]),
                     height(1))).
in_one_plane(prism(outline([[-2,-2],[0.1,-2],[2,-2],[2,0.3],[2,2],[-2,2]]),
                   height(1), scale(0.3))).
in_one_plane(union([box(size(1,1,1)),
                    at([translate(1,0,0)], box(size(1,1,1)))])).
in_one_plane(join([box(size(1,1,1)),
                   at([translate(1,0,0)], box(size(1,1,1)))])).
in_one_plane(polyhedron(points([[0,0,0],[0.7,0,0],[1.9,0,0],
                                [0,1.1,0],[0.7,1.1,0],[1.9,1.1,0],
                                [0,0,0.3],[0.7,0,0.3],[1.9,0,0.3],
                                [0,1.1,0.3],[0.7,1.1,0.3],[1.9,1.1,0.3]]),
                        faces([[2,1,4,5],[3,2,5,6],[7,8,11,10],[8,9,12,11],
                               [1,2,8,7],[2,3,9,8],[3,6,12,9],[6,5,11,12],
                               [5,4,10,11],[4,1,7,10]]))).

% turned(Term, Far, Turned): as it is, and turned at random and moved so far.

turned(Term, 0, Term).
turned(Term0, Far, Term) :-
    member(Far, [1,10,100,1000]),
    set_random(seed(Far)),
    maplist(random(-1.0, 1.0), [X,Y,Z]),
    random(0.0, 360.0, Turn),
    Term = at([rotate(axis(X,Y,Z), Turn), translate(Far,X,Far)], Term0).

% edges_below(Degrees, Count): the edges of the terms that bend by less.

edges_below(Degrees, Count) :-
    root_segment(S),
    open_scene(Scene, []),
    aggregate_all(count,
                  ( scene_edge(Scene, S, _, _, Look),
                    look_part(edge, Look, true),
                    look_part(bend, Look, Bend),
                    Bend < Degrees ),
                  Count).

% Sides and bases bend by a right angle or more. A place a thousand away is as
% fine as 2^-44 of that.

:- begin_tests(low_and_flat).

test(apart, [ forall(( low(H), drawn_apart(H, Term0, Count0),
                       turned(Term0, Far, Term), Far < H*1.0e11 )),
              Count == Count0 ]) :-
    in_tree(Term, from_above(edges_below(60, Count))).
test(limit, [ forall(member(H-Expected, [1.0e-12-4,1.0e-13-0])),
              Count == Expected ]) :-
    in_tree(pyramid(base(4,4), height(H)),
            from_above(edges_below(60, Count))).
test(one_plane, [ forall(( in_one_plane(Term0), turned(Term0, _, Term) )),
                  Count == 0 ]) :-
    in_tree(Term, from_above(edges_below(1, Count))).

:- end_tests(low_and_flat).
