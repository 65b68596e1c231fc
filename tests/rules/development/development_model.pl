:- module(sg_test_development_model,
          [ figure_model/2,             % ?Name, -Primitives
            icosphere/2,                % +Steps, -Term
            bound_model/3,              % ?Name, -Term, -Seam
            mesh_file/2                 % ?Name, -File
          ]).
/** <module> Models for tests of developments.
*/

:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).

%!  figure_model(?Name, -Primitives) is nondet.
%
%   The bodies that the 1989 paper develops (DV-9), each alone.

figure_model(hexahedron, [box(size(1, 1, 1))]).
figure_model(oblique_cone,
             [cone(radius(1), height(2), shift(0.8, 0), facets(32))]).
figure_model(oblique_elliptic_cylinder,
             [cylinder(radius(1, 0.6), height(2), shift(0.8, 0),
                       facets(32))]).
figure_model(hollow_cylinder,
             [hollow_cylinder(radius(1), inner(0.6), height(1.6),
                              facets(24))]).
figure_model(sphere, [sphere(radius(1), facets(24), bands(12))]).
figure_model(egg, [egg(radius(0.8), up(1.3), down(0.8), facets(24))]).

%!  bound_model(?Name, -Term, -Seam) is nondet.
%
%   Models with no flat vertex, and the shortest tree along their edges, to two
%   digits: no seam can be shorter.

bound_model(cube, box(size(1, 1, 1)), 7.00).
bound_model(cone24, cone(radius(1), height(2), facets(24)), 8.24).
bound_model(cylinder40, cylinder(radius(1), height(2), facets(40)), 14.24).
bound_model(sphere12x24, Term, 48.74) :-
    globe(24, 12, Term).
bound_model(icosphere1280, Term, 90.94) :-
    icosphere(3, Term).
bound_model(icosphere5120, Term, 183.45) :-
    icosphere(4, Term).

%   globe(Facets, Bands, Term): a sphere of triangles, each quadrangle divided
%   along one diagonal.

globe(Facets, Bands, polyhedron(points([[0,0,-1]|Points]), faces(Faces))) :-
    LastBand is Bands-1,
    LastFacet is Facets-1,
    findall([X,Y,Z],
            ( between(1, LastBand, J),
              T is pi*J/Bands-pi/2,
              between(0, LastFacet, I),
              P is 2*pi*I/Facets,
              X is cos(T)*cos(P),
              Y is cos(T)*sin(P),
              Z is sin(T) ),
            Ring),
    append(Ring, [[0,0,1]], Points),
    Top is Facets*LastBand+2,
    findall(Face,
            ( between(0, LastBand, J),
              between(0, LastFacet, I),
              globe_face(J, I, Facets, Bands, Top, Face) ),
            Faces).

globe_face(0, I, N, _, _, [1,B,A]) :-
    !,
    ring_point(N, 1, I, A),
    ring_point(N, 1, I+1, B).
globe_face(J, I, N, Bands, Top, [A,B,Top]) :-
    J =:= Bands-1,
    !,
    ring_point(N, J, I, A),
    ring_point(N, J, I+1, B).
globe_face(J, I, N, _, _, Face) :-
    ring_point(N, J, I, A),
    ring_point(N, J, I+1, B),
    ring_point(N, J+1, I+1, C),
    ring_point(N, J+1, I, D),
    member(Face, [[A,B,C], [A,C,D]]).

ring_point(N, J, I, Point) :-
    Point is 2+(J-1)*N+I mod N.

%!  icosphere(+Steps, -Term) is det.
%
%   Term is the regular icosahedron, each triangle divided into four, Steps
%   times, with all points moved onto the sphere of radius 1.

icosphere(Steps, polyhedron(points(Points), faces(Faces))) :-
    G is (1+sqrt(5))/2,
    maplist(unit,
            [ [-1,G,0],[1,G,0],[-1,-G,0],[1,-G,0],[0,-1,G],[0,1,G],
              [0,-1,-G],[0,1,-G],[G,0,-1],[G,0,1],[-G,0,-1],[-G,0,1] ],
            Points0),
    Faces0 = [ [0,11,5],[0,5,1],[0,1,7],[0,7,10],[0,10,11],
               [1,5,9],[5,11,4],[11,10,2],[10,7,6],[7,1,8],
               [3,9,4],[3,4,2],[3,2,6],[3,6,8],[3,8,9],
               [4,9,5],[2,4,11],[6,2,10],[8,6,7],[9,8,1] ],
    maplist(maplist(plus(1)), Faces0, Faces1),
    foldl(numbered, Points0, pairs([],1), pairs(Pairs,Next)),
    list_to_assoc(Pairs, Points1),
    icosphere_(Steps, Points1, Next, Faces1, PointsN, Faces),
    assoc_to_values(PointsN, Points).

numbered(Point, pairs(Pairs,N), pairs([N-Point|Pairs],N1)) :-
    N1 is N+1.

unit([X,Y,Z], [U,V,W]) :-
    L is sqrt(X*X+Y*Y+Z*Z),
    U is X/L,
    V is Y/L,
    W is Z/L.

icosphere_(0, Points, _, Faces, Points, Faces) :-
    !.
icosphere_(Steps, Points0, Next0, Faces0, Points, Faces) :-
    empty_assoc(Middles),
    foldl(in_four, Faces0, Parts, made(Points0,Next0,Middles),
          made(Points1,Next1,_)),
    append(Parts, Faces1),
    Steps1 is Steps-1,
    icosphere_(Steps1, Points1, Next1, Faces1, Points, Faces).

in_four([A,B,C], [[A,X,Z],[B,Y,X],[C,Z,Y],[X,Y,Z]]) -->
    middle(A, B, X),
    middle(B, C, Y),
    middle(C, A, Z).

middle(A, B, M, made(Points,Next,Middles), Made) :-
    msort([A,B], [Low,High]),
    (   get_assoc(Low-High, Middles, M)
    ->  Made = made(Points,Next,Middles)
    ;   M = Next,
        get_assoc(A, Points, P),
        get_assoc(B, Points, Q),
        maplist(sum, P, Q, Sum),
        unit(Sum, Unit),
        put_assoc(M, Points, Unit, Points1),
        put_assoc(Low-High, Middles, M, Middles1),
        Next1 is Next+1,
        Made = made(Points1,Next1,Middles1)
    ).

sum(A, B, C) :-
    C is A+B.

%!  mesh_file(?Name, -File) is nondet.
%
%   The meshes of others, where they are.

mesh_file(Name, File) :-
    expand_file_name('../shared/data/meshes/*', Files),
    member(File, Files),
    file_base_name(File, Base),
    file_name_extension(Name, Extension, Base),
    memberchk(Extension, [obj,stl,off,ply]).
