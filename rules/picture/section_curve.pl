:- module(sg_section_curve,
          [ section_on_surfaces/2       % +Section, -Curves
          ]).
:- use_module(section, [section_region/5]).
:- use_module('../csg/known_surface', [facets_of/2]).
:- use_module('../kernel', [surfaces_meet/4]).
:- use_module('../near', [is_rounding/2]).
:- use_module('../store',
              [ v/5, e/5, edge_polygon/3, assert_fact/1,
                facts_transaction/1, retractall_facts/1
              ]).
:- use_module(library(apply), [foldl/5, maplist/2, maplist/3, maplist/4]).
:- use_module(library(assoc), [list_to_assoc/2]).
:- use_module(library(lists), [max_list/2, member/2, nth1/3, sum_list/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Sections of spheres and tori on their true curves.

A plane cuts facets in chords that begin and end beside the true curve; where
it touches a torus from inside, that is a zigzag. Here the ends of these
chords go to the curve, and what is drawn of a chord follows it. All of them lie
in the plane of the section, in front of what else is seen there, so nothing
else changes.
*/

%!  section_on_surfaces(+Section, -Curves) is det.
%
%   In the current world, of which cut_away/2 left Section, vertices of caps
%   that lie on facets of one sphere or torus move to where the plane meets
%   that, if it does within the length of a side of the cap. Where the plane
%   touches a torus, the curve crosses itself: there they move to that point.
%   One transaction. Curves is an assoc: edge(N,V1,V2) of a cap of what is left,
%   segment N, has the Points p(X,Y,Z) of the curve between its ends, as many as
%   show that it bends.

section_on_surfaces(Section, Curves) :-
    facts_transaction(sg_section_curve:on_surfaces(Section, Curves)).

on_surfaces(Section, Curves) :-
    Section = section(Plane0, _),
    Plane0 =.. [_|Numbers0],
    maplist(as_float, Numbers0, Numbers),
    findall(N, section_region(Section, _, _, N, _), Ns0),
    sort(Ns0, Ns),
    facets_of(Ns, Facets),
    Plane =.. [plane|Numbers],
    findall(Borders,
            ( section_region(Section, _, _, N, Edges),
              round_borders(Facets, N, Edges, Borders) ),
            Regions),
    maplist(region_moved(Plane), Regions),
    findall(edge(N,V1,V2)-Points,
            ( member(borders(N,Borders), Regions),
              borders_lengths(N, Borders, Lengths),
              sum_list(Lengths, Round),
              member(border(V1,V2,Surface), Borders),
              Surface \== none,
              curve_points(N, V1-V2, Surface-Plane, Round, Points) ),
            Pairs),
    list_to_assoc(Pairs, Curves).

%   round_borders(Facets, N, Edges, Borders) is semidet: borders(N, Bs), each
%   border(V1, V2, Surface) as of edge_surface/6, if one may be round.

round_borders(Facets, N, Edges, borders(N,Borders)) :-
    memberchk(known(N, Surfaces, Runs), Facets),
    once(( member(surface(Kind, _, _, _), Surfaces), round_kind(Kind) )),
    findall(border(V1,V2,Surface),
            ( member(V1-V2, Edges),
              edge_surface(N, V1, V2, Surfaces, Runs, Surface) ),
            Borders).

borders_lengths(N, Borders, Lengths) :-
    findall(Length,
            ( member(border(V1,V2,_), Borders), apart(N, V1, V2, Length) ),
            Lengths).

region_moved(Plane, borders(N,Borders)) :-
    findall(V-Surface,
            ( member(border(V1,V2,Surface), Borders),
              ( V = V1 ; V = V2 ) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    borders_lengths(N, Borders, Lengths),
    max_list(Lengths, Reach),
    findall(V-Point,
            ( member(V-[Round], Groups),
              Round \== none,
              place(N, V, At),
              curve_corner(Round, Plane, Reach, At, Point) ),
            Moves),
    maplist(moved(N), Moves).

%   curve_corner(Round, Plane, Reach, At, Point) is semidet: where the corner At
%   of a cap goes.

curve_corner(Round, Plane, Reach, At, Point) :-
    (   touch_point(Round, Plane, Point),
        distance(At, Point, Off),
        Off < Reach/4
    ->  true
    ;   surfaces_meet([Round,Plane], Reach, At, Point)
    ).

%   touch_point(Torus, Plane, Point) is nondet: Plane is tangent to Torus in
%   Point, and not all round.

touch_point(torus(point(X,Y,Z), U, V, W, K), plane(A,B,C,D), Point) :-
    maplist(along(A-B-C), [U,V,W], [P,Q,R]),
    Level is sqrt(P*P + Q*Q),
    Steep is sqrt(P*P + Q*Q + R*R),
    \+ is_rounding(Level, Steep),
    Off is A*X + B*Y + C*Z + D,
    member(Side, [1,-1]),
    member(Out, [1,-1]),
    Far is 1 + Out*Side*K*Level/Steep,
    X1 is Far*Side*P/Level,
    Y1 is Far*Side*Q/Level,
    Z1 is Out*K*R/Steep,
    is_rounding(Off + P*X1 + Q*Y1 + R*Z1, Steep),
    foldl(farther, [U,V,W], [X1,Y1,Z1], point(X,Y,Z), Point).

along(A-B-C, vector(X,Y,Z), Along) :-
    Along is A*X + B*Y + C*Z.

farther(vector(X,Y,Z), By, point(X0,Y0,Z0), point(X1,Y1,Z1)) :-
    X1 is X0 + By*X,
    Y1 is Y0 + By*Y,
    Z1 is Z0 + By*Z.

%   curve_points(N, V1-V2, Surfaces, Round, Points) is semidet: with these
%   points the pieces are off the curve by a 50,000th of Round, how long the
%   border is. Fails if there are none.

curve_points(N, V1-V2, Surfaces, Round, Points) :-
    Off is Round/50000,
    maplist(place(N), [V1,V2], [A,B]),
    followed(8, Surfaces, Off, A, B, Points, []),
    Points \== [].

%   followed(Halvings, Surfaces, Off, A, B)//: the curve between A and B, where
%   it runs along the chord. The middle of a chord may lie on a curve that is
%   bent on both sides of it.

followed(Halvings, Surfaces, Off, A, B) -->
    (   { Halvings > 0,
          chord_point(Surfaces, A, B, 0.5, Point, Rise),
          (   Rise > Off
          ->  true
          ;   chord_point(Surfaces, A, B, 0.25, _, Quarter),
              Quarter > Off
          )
        }
    ->  { Halvings1 is Halvings-1,
          Point = point(X,Y,Z)
        },
        followed(Halvings1, Surfaces, Off, A, Point),
        [p(X,Y,Z)],
        followed(Halvings1, Surfaces, Off, Point, B)
    ;   []
    ).

%   chord_point(Surfaces, A, B, At, Point, Rise) is semidet: beside that part of
%   the chord, square to it, is Point of the curve, so far off. Where the curve
%   crosses itself, facets may cut off its corner.

chord_point(Round-Plane, A, B, At, Point, Rise) :-
    A = point(X1,Y1,Z1),
    B = point(X2,Y2,Z2),
    maplist(part_way(At), [X1,Y1,Z1], [X2,Y2,Z2], [X,Y,Z]),
    Place = point(X,Y,Z),
    distance(A, B, Length),
    (   surfaces_meet([Round,Plane], Length, Place, Point)
    ;   touch_point(Round, Plane, Point)
    ),
    distance(Place, Point, Rise),
    Rise < 0.8*Length,
    Point = point(X3,Y3,Z3),
    Along is (X3-X)*(X2-X1) + (Y3-Y)*(Y2-Y1) + (Z3-Z)*(Z2-Z1),
    abs(Along) < Length*Length/8,
    !.

part_way(At, A, B, X) :-
    X is A + At*(B-A).

place(N, V, point(X,Y,Z)) :-
    once(v(N, V, X, Y, Z)).

distance(point(X1,Y1,Z1), point(X2,Y2,Z2), Length) :-
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

as_float(N, X) :-
    X is float(N).

round_kind(sphere).
round_kind(torus).

%   edge_surface(N, V1, V2, Surfaces, Runs, Surface): what is beyond the border
%   V1-V2 of a cap, or `none` if that is neither a sphere nor a torus.

edge_surface(N, V1, V2, Surfaces, Runs, Surface) :-
    (   e(N, Twin, V2, V1, _),
        edge_polygon(N, Twin, Q),
        member(run(P1, P2, K), Runs),
        Q >= P1,
        Q =< P2,
        K > 0,
        nth1(K, Surfaces, Known),
        round_surface(Known, Surface0)
    ->  Surface = Surface0
    ;   Surface = none
    ).

round_surface(surface(Kind, Numbers, K, _), Surface) :-
    round_kind(Kind),
    Numbers = [X,Y,Z, UX,UY,UZ, VX,VY,VZ, WX,WY,WZ],
    Frame = [point(X,Y,Z),vector(UX,UY,UZ),vector(VX,VY,VZ),vector(WX,WY,WZ)],
    (   Kind == torus
    ->  Frame = [C,U,V,W],
        Surface = torus(C, U, V, W, K)
    ;   Surface =.. [Kind|Frame]
    ).

apart(N, V1, V2, Length) :-
    maplist(place(N), [V1,V2], [A,B]),
    distance(A, B, Length).

moved(N, V-point(X,Y,Z)) :-
    retractall_facts(v(N, V, _, _, _)),
    assert_fact(v(N, V, X, Y, Z)).
