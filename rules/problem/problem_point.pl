:- module(sg_problem_point,
          [ numbered_points/3,          % +Branch, +N, -Points
            branch_generators/3,        % +Branch, +N, -Generators
            generator/4,                % +Surface, +T, -From, -To
            round_side/2                % +S, -Surface
          ]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../kernel', [surface_place/4, surfaces_meet/4]).
:- use_module('../near', [before_angle/2, is_on_surface/2, is_rounding/2]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../store', [e/5, edge_polygon/3, origin/3, segment/3, v/5]).
:- use_module('../unrolling/true_surface',
              [generator_plane/3, polygon_surface/3]).
:- use_module('../vector',
              [ angle_between/3, cross_product/3, difference/3, dot_product/3,
                unit/2
              ]).
:- use_module(problem_loop, [step_ends/5, whole_chains/1]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, last/2, member/2, nth1/3, reverse/2]).
/** <module> The points of a penetration line that a pupil is to find.

Of a round branch: where its generators, in equal steps, meet the others. The
points are those of the true surfaces, not of their facets. Where the branch has
no generators: the corners of the line; of a curve, where it goes through.
*/

%!  branch_generators(+Branch, +N, -Generators:list) is det.
%
%   Generators are generator(I, T, From, To), N in equal steps, T in degrees,
%   with their ends p(X,Y,Z); none if segment Branch is not a cylinder or cone.

branch_generators(Branch, N, Generators) :-
    (   round_side(Branch, Surface)
    ->  findall(generator(I, T, From, To),
                ( between(1, N, I),
                  T is (I-1)*360.0/N,
                  generator(Surface, T, From, To) ),
                Generators)
    ;   Generators = []
    ).

%!  generator(+Surface, +T, -From, -To) is det.
%
%   That of Surface at T degrees runs From its base To its top, p(X,Y,Z).

generator(Surface, T, p(X1,Y1,Z1), p(X2,Y2,Z2)) :-
    surface_point(Surface, T, 0.0, point(X1,Y1,Z1)),
    surface_point(Surface, T, 1.0, point(X2,Y2,Z2)).

%!  round_side(+S, -Surface) is semidet.
%
%   Surface is that of segment S, a cylinder or a cone.

round_side(Branch, Surface) :-
    placed_surface(Branch, side, Surface),
    functor(Surface, Kind, _),
    memberchk(Kind, [cylinder,cone]),
    !.

%!  numbered_points(+Branch, +N, -Points:list) is det.
%
%   Points are point(I, Loop, T, p(X,Y,Z)), numbered from 1 in the order of the
%   lines: where the N generators of segment Branch meet others, T in degrees,
%   or the corners of the lines, T being `none`. Of a curve: where it goes
%   through others, Loop being 0. The segments have been cut.

numbered_points(Branch, _, Points) :-
    segment(Branch, curve, _),
    !,
    findall(V,
            ( origin(Branch, v(V), _), v(Branch, V, _, _, _) ),
            Vs0),
    sort(Vs0, Vs),
    findall(point(I, 0, none, P),
            ( nth1(I, Vs, V), once(pierced(Branch, V, P)) ),
            Points).
numbered_points(Branch, N, Points) :-
    whole_chains(Chains),
    findall(place(T, P, Loop),
            ( nth1(Loop, Chains, chain(S1, S2, Kind, Steps)),
              ( S1 == Branch ; S2 == Branch ),
              chain_places(Branch, N, Kind, Steps, Places),
              member(place(T, P), Places) ),
            Found0),
    each_once(Found0, Found),
    findall(point(I, Loop, T, P), nth1(I, Found, place(T, P, Loop)), Points).

%   pierced(Curve, V, P): vertex V, which a cut made, lies on a facet; P is
%   where the straight piece of Curve that V is on goes through the true
%   surface.

pierced(Curve, V, P) :-
    v(Curve, V, X, Y, Z),
    origin(Curve, v(V), Origin),
    pierced_polygon(Origin, Curve, S, Polygon),
    polygon_surface(S, Polygon, Surface),
    ( e(Curve, _, V, W, _) ; e(Curve, _, W, V, _) ),
    v(Curve, W, X1, Y1, Z1),
    difference(p(X1,Y1,Z1), p(X,Y,Z), Along),
    dot_product(Along, Along, Square),
    Square > 0.0,
    across(Along, Across),
    cross_product(Along, Across, Third),
    maplist(plane_at(p(X,Y,Z)), [Across,Third], Planes),
    Reach is sqrt(Square),
    surfaces_meet([Surface|Planes], Reach, point(X,Y,Z), point(X2,Y2,Z2)),
    P = p(X2,Y2,Z2).
pierced(Curve, V, p(X,Y,Z)) :-
    v(Curve, V, X, Y, Z).

%   pierced_polygon(Origin, Curve, S, P): corners of its triangle tell which.

pierced_polygon(Origin, Curve, S, P) :-
    Origin =.. [_|Places],
    member(S-Corners, Places),
    S \== Curve,
    Corners = (A,B,C),
    corner_polygon(S, A, P),
    once(corner_polygon(S, B, P)),
    once(corner_polygon(S, C, P)).

corner_polygon(S, V, P) :-
    e(S, E, V, _, _),
    edge_polygon(S, E, P).

across(p(X,Y,Z), Across) :-
    (   abs(X) =< min(abs(Y), abs(Z))
    ->  Axis = p(1.0,0.0,0.0)
    ;   abs(Y) =< abs(Z)
    ->  Axis = p(0.0,1.0,0.0)
    ;   Axis = p(0.0,0.0,1.0)
    ),
    cross_product(p(X,Y,Z), Axis, Across).

plane_at(P, Normal0, plane(A,B,C,D)) :-
    unit(Normal0, Normal),
    Normal = p(A,B,C),
    dot_product(Normal, P, Dot),
    D is -Dot.

chain_places(Branch, N, _, Steps, Places) :-
    round_side(Branch, Surface),
    !,
    findall(Place,
            ( member(Step, Steps),
              step_places(Branch, Surface, N, Step, Ordered),
              member(Place, Ordered) ),
            Places).
chain_places(Branch, _, Kind, Steps, Places) :-
    findall(P, ( member(Step, Steps), step_ends(Branch, Step, P, _, _) ), Ps0),
    (   Kind == closed
    ->  last(Ps0, Last),
        Ps0 = [First|_],
        append([Last|Ps0], [First], Ps)
    ;   Ps0 = [First|_],
        last(Steps, Step),
        step_ends(Branch, Step, _, End, _),
        append([First|Ps0], [End,End], Ps)
    ),
    findall(place(none, Q),
            ( append(_, [P,Q,R|_], Ps), turns(P, Q, R) ),
            Places).

turns(P, Q, R) :-
    difference(Q, P, U),
    difference(R, Q, V),
    dot_product(U, U, UU),
    dot_product(V, V, VV),
    (   ( UU =:= 0.0 ; VV =:= 0.0 )
    ->  true
    ;   angle_between(U, V, Angle),
        Angle > 0.02
    ).

%   step_places(Branch, Surface, N, Step, Places): where the true line goes over
%   generators between the ends of this piece.

step_places(Branch, Surface, N, Step, Places) :-
    step_ends(Branch, Step, P, Q, S-Polygon),
    P = p(X1,Y1,Z1),
    Q = p(X2,Y2,Z2),
    surface_place(Surface, point(X1,Y1,Z1), T1, _),
    surface_place(Surface, point(X2,Y2,Z2), T20, _),
    T2 is T20 + 360.0*round((T1-T20)/360.0),
    polygon_surface(S, Polygon, Other),
    difference(Q, P, PQ),
    dot_product(PQ, PQ, Square),
    Reach is 4.0*sqrt(Square),
    Low is min(T1, T2),
    High is max(T1, T2),
    Unit is 360.0/N,
    First is floor(Low/Unit),
    Last is ceiling(High/Unit),
    findall(place(T, p(X,Y,Z)),
            ( between(First, Last, K),
              At is K*Unit,
              \+ before_angle(At, Low),
              \+ before_angle(High, At),
              part_way(T1, T2, At, F),
              X0 is X1 + F*(X2-X1),
              Y0 is Y1 + F*(Y2-Y1),
              Z0 is Z1 + F*(Z2-Z1),
              generator_plane(Surface, At, Plane),
              surfaces_meet([Surface,Other,Plane], Reach, point(X0,Y0,Z0),
                            point(X,Y,Z)),
              T is (K mod N)*Unit ),
            Places0),
    (   T1 =< T2
    ->  Places = Places0
    ;   reverse(Places0, Places)
    ).

part_way(T1, T2, At, F) :-
    (   is_rounding(T2-T1, 1.0)
    ->  F = 0.5
    ;   F is max(0.0, min(1.0, (At-T1)/(T2-T1)))
    ).

%   each_once(Places0, Places): the end of one piece begins the next, and lines
%   may have a point in common.

each_once(Places0, Places) :-
    foldl(added_once, Places0, [], Reversed),
    reverse(Reversed, Places).

added_once(Place, Seen, Places) :-
    Place = place(T, P, _),
    (   member(place(T, Q, _), Seen),
        difference(P, Q, Off),
        dot_product(Off, Off, Square),
        dot_product(P, P, Size),
        is_on_surface(sqrt(Square), 1.0+sqrt(Size))
    ->  Places = Seen
    ;   Places = [Place|Seen]
    ).
