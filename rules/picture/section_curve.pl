:- module(sg_section_curve,
          [ section_on_surfaces/1       % +Section
          ]).
:- use_module(section, [section_region/5]).
:- use_module('../csg/known_surface', [facets_of/2]).
:- use_module('../kernel', [surfaces_meet/4]).
:- use_module('../store',
              [ v/5, e/5, edge_polygon/3, assert_fact/1,
                facts_transaction/1, retractall_facts/1
              ]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [max_list/2, member/2, nth1/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Sections of spheres and tori on their true curves.

A plane cuts facets in chords that begin and end beside the true curve; where
it touches a torus from inside, that is a zigzag. Here the ends of these
chords go to the curve. All of them lie in the plane of the section, in front
of what else is seen there, so nothing else changes.
*/

%!  section_on_surfaces(+Section) is det.
%
%   In the current world, of which cut_away/2 left Section, vertices of caps
%   that lie on facets of one sphere or torus move to where the plane meets
%   that, if it does within the length of a side of the cap. One transaction.

section_on_surfaces(Section) :-
    facts_transaction(sg_section_curve:moved_to_surfaces(Section)).

moved_to_surfaces(Section) :-
    Section = section(Plane0, _),
    Plane0 =.. [_|Numbers0],
    maplist(as_float, Numbers0, Numbers),
    findall(N, section_region(Section, _, _, N, _), Ns0),
    sort(Ns0, Ns),
    facets_of(Ns, Facets),
    findall(N-Edges,
            section_region(Section, _, _, N, Edges),
            Regions),
    Plane =.. [plane|Numbers],
    maplist(region_moved(Facets, Plane), Regions).

region_moved(Facets, Plane, N-Edges) :-
    (   memberchk(known(N, Surfaces, Runs), Facets),
        member(surface(Kind, _, _, _), Surfaces),
        round_kind(Kind)
    ->  findall(V-Surface,
                ( member(V1-V2, Edges),
                  edge_surface(N, V1, V2, Surfaces, Runs, Surface),
                  ( V = V1 ; V = V2 ) ),
                Pairs0),
        sort(Pairs0, Pairs),
        group_pairs_by_key(Pairs, Groups),
        findall(Length,
                ( member(V1-V2, Edges), apart(N, V1, V2, Length) ),
                Lengths),
        max_list(Lengths, Reach),
        findall(V-Point,
                ( member(V-[Round], Groups),
                  Round \== none,
                  once(v(N, V, X, Y, Z)),
                  surfaces_meet([Round,Plane], Reach, point(X,Y,Z), Point) ),
                Moves),
        maplist(moved(N), Moves)
    ;   true
    ).

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
    once(v(N, V1, X1, Y1, Z1)),
    once(v(N, V2, X2, Y2, Z2)),
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

moved(N, V-point(X,Y,Z)) :-
    retractall_facts(v(N, V, _, _, _)),
    assert_fact(v(N, V, X, Y, Z)).
