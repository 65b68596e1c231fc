:- module(sg_problem_point,
          [ numbered_points/3,          % +Branch, +N, -Points
            branch_generators/3         % +Branch, +N, -Generators
          ]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../kernel', [surface_place/4, surfaces_meet/4]).
:- use_module('../near', [before_angle/2, is_on_surface/2, is_rounding/2]).
:- use_module('../penetration/chain', [chains/1]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../store', [line/9, origin/3, segment/3, v/5]).
:- use_module('../unrolling/true_surface',
              [generator_plane/3, polygon_surface/3]).
:- use_module('../vector', [angle_between/3, difference/3, dot_product/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [append/3, last/2, member/2, nth1/3, reverse/2]).
/** <module> The points of a penetration line that a pupil is to find.

Of a round branch: where its generators, in equal steps, meet the others. The
points are those of the true surfaces, not of their facets. Where the branch has
no generators: the corners of the line.
*/

%!  branch_generators(+Branch, +N, -Generators:list) is det.
%
%   Generators are generator(I, T, From, To), N in equal steps, T in degrees,
%   with their ends p(X,Y,Z); none if segment Branch is not a cylinder or cone.

branch_generators(Branch, N, Generators) :-
    (   branch_surface(Branch, Surface)
    ->  findall(generator(I, T, From, To),
                ( between(1, N, I),
                  T is (I-1)*360.0/N,
                  surface_point(Surface, T, 0.0, point(X1,Y1,Z1)),
                  surface_point(Surface, T, 1.0, point(X2,Y2,Z2)),
                  From = p(X1,Y1,Z1),
                  To = p(X2,Y2,Z2) ),
                Generators)
    ;   Generators = []
    ).

branch_surface(Branch, Surface) :-
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
    findall(point(I, 0, none, p(X,Y,Z)),
            ( nth1(I, Vs, V), v(Branch, V, X, Y, Z) ),
            Points).
numbered_points(Branch, N, Points) :-
    chains(Chains),
    findall(place(T, P, Loop),
            ( nth1(Loop, Chains, chain(S1, S2, Kind, Steps)),
              ( S1 == Branch ; S2 == Branch ),
              chain_places(Branch, N, Kind, Steps, Places),
              member(place(T, P), Places) ),
            Found0),
    each_once(Found0, Found),
    findall(point(I, Loop, T, P), nth1(I, Found, place(T, P, Loop)), Points).

chain_places(Branch, N, _, Steps, Places) :-
    branch_surface(Branch, Surface),
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

%   step_ends(Branch, Step, P, Q, Other): from P to Q along the line, in Other,
%   a polygon S-P of the other segment.

step_ends(Branch, Step, P, Q, Other) :-
    L is abs(Step),
    line(L, S1, P1, A1, B1, S2, P2, A2, B2),
    (   S1 == Branch
    ->  ends(S1, A1, B1, From, To),
        Other = S2-P2
    ;   ends(S2, A2, B2, From, To),
        Other = S1-P1
    ),
    (   Step > 0
    ->  P-Q = From-To
    ;   P-Q = To-From
    ).

ends(S, A, B, p(X1,Y1,Z1), p(X2,Y2,Z2)) :-
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    !.

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
