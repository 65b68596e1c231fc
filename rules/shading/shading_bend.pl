:- module(sg_shading_bend,
          [ bent_polygons/5             % +Parts, +Points, +Polygons0,
                                        % -Polygons, -Surfaces
          ]).
:- use_module('../picture/role', [usual_crease/1]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, doubled_area/2,
                scaled/3, unit/2, vector_sum/3 ]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2, nth1/3, same_length/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Normals of what a term says is smooth, divided into facets before.

Of a curve that was divided nothing is known but its corners. There a facet
looks the mean way of all facets of the corner that bend from it by no more than
a crease, and between its corners every way between. The surface of such a facet
is `bent`: the point C of the model, the normal N there, and by how much it
grows along X, Y and Z.
*/

%   What bends by more is a crease, as in drawings: the cosine.

crease_cosine(Cosine) :-
    usual_crease(Degrees),
    Cosine is cos(Degrees*pi/180).

%   Corners where it looks the same way but for this are at the ends of one
%   straight line of the surface.

same_way(0.9999).

%!  bent_polygons(+Parts, +Points, +Polygons0, -Polygons, -Surfaces) is det.
%
%   Polygons are Polygons0, polygon(F, 0, Loops) of the places of Points, of
%   which those that Parts (primitive_parts/3) call `divided` stand for a
%   surface of their own of Surfaces, if it is one that three or four corners
%   tell.

bent_polygons(Parts, Points, Polygons0, Polygons, Surfaces) :-
    compound_name_arguments(Table, points, Points),
    divided_facets(Parts, Polygons0, Table, Facets),
    findall(V-N,
            ( member(facet(Loop,N), Facets), nonvar(N), member(V, Loop) ),
            Normals0),
    keysort(Normals0, Normals1),
    group_pairs_by_key(Normals1, Normals2),
    list_to_assoc(Normals2, Normals),
    bent(Polygons0, Facets, Table, Normals, 1, Polygons, Surfaces).

%   divided_facets(Parts, Polygons, Table, Facets): of each polygon facet(Loop,
%   Normal); the normal of others is left open.

divided_facets([], [], _, []).
divided_facets([part(0,_)|Parts], Polygons, Table, Facets) :-
    !,
    divided_facets(Parts, Polygons, Table, Facets).
divided_facets([part(N0,What)|Parts], [polygon(_,_,Loops)|Polygons], Table,
               [facet(Loop,Normal)|Facets]) :-
    N is N0-1,
    Loops = [Loop|Holes],
    (   What == divided,
        Holes == []
    ->  loop_normal(Loop, Table, Normal)
    ;   true
    ),
    divided_facets([part(N,What)|Parts], Polygons, Table, Facets).

loop_normal(Loop, Table, Normal) :-
    maplist(corner(Table), Loop, Points),
    doubled_area(Points, Area),
    unit(Area, Normal).

corner(Table, V, p(X,Y,Z)) :-
    arg(V, Table, point(X,Y,Z)).

%   bent(Polygons0, Facets, Table, Normals, K, Polygons, Surfaces)

bent([], [], _, _, _, [], []).
bent([Polygon0|Polygons0], [facet(Loop,Normal)|Facets], Table, Normals, K,
     [Polygon|Polygons], Surfaces) :-
    (   nonvar(Normal),
        Polygon0 = polygon(F,0,Loops),
        maplist(corner(Table), Loop, Corners),
        maplist(corner_normal(Normals, Normal), Loop, Ways),
        normal_forms(Corners, Ways, Normal, Forms)
    ->  Polygon = polygon(F,K,Loops),
        bent_surface(Corners, Forms, Surface),
        Surfaces = [Surface|Surfaces1],
        Next is K+1
    ;   Polygon = Polygon0,
        Surfaces = Surfaces1,
        Next = K
    ),
    bent(Polygons0, Facets, Table, Normals, Next, Polygons, Surfaces1).

corner_normal(Normals, Normal, V, Way) :-
    get_assoc(V, Normals, All),
    crease_cosine(Least),
    foldl(smooth_with(Normal, Least), All, p(0.0,0.0,0.0), Sum),
    unit(Sum, Way).

smooth_with(Normal, Least, Other, Sum0, Sum) :-
    dot_product(Normal, Other, Cosine),
    (   Cosine >= Least
    ->  vector_sum(Sum0, Other, Sum)
    ;   Sum = Sum0
    ).

%   normal_forms(Corners, Ways, Normal, Forms): the normal at P is the sum of
%   (Start + G.(P - first corner)) * Way, of form(Way, Start, G).

normal_forms([A,B,C], [WA,WB,WC], Normal,
             [form(WA,1.0,GA),form(WB,0.0,GB),form(WC,0.0,GC)]) :-
    side_form(B, C, A, Normal, GA),
    side_form(C, A, B, Normal, GB),
    side_form(A, B, C, Normal, GC).
normal_forms([A,B,C,D], [WA,WB,WC,WD], Normal, Forms) :-
    (   same_ways(WB, WC),
        same_ways(WD, WA)
    ->  side_form(B, C, A, Normal, GA),
        side_form(D, A, B, Normal, GB),
        Forms = [form(WA,1.0,GA),form(WB,0.0,GB)]
    ;   same_ways(WA, WB),
        same_ways(WC, WD)
    ->  side_form(C, D, A, Normal, GA),
        side_form(A, B, C, Normal, GC),
        Forms = [form(WA,1.0,GA),form(WC,0.0,GC)]
    ).

same_ways(U, V) :-
    dot_product(U, V, Cosine),
    same_way(Least),
    Cosine >= Least.

%   side_form(A, B, P, Normal, G): what is 0 along A-B and 1 at P grows by G.

side_form(A, B, P, Normal, G) :-
    difference(B, A, Side),
    cross_product(Normal, Side, G0),
    difference(P, A, Off),
    dot_product(G0, Off, Height),
    Height > 0.0,
    Part is 1.0/Height,
    scaled(Part, G0, G).

bent_surface([p(X,Y,Z)|_], Forms, surface(bent,Frame,0.0,0.0)) :-
    foldl(form_at(start), Forms, p(0.0,0.0,0.0), p(NX,NY,NZ)),
    maplist(grown(Forms), [1,2,3], [p(A,B,C),p(D,E,F),p(G,H,I)]),
    Frame = [X,Y,Z, NX,NY,NZ, A,B,C, D,E,F, G,H,I].

grown(Forms, I, Sum) :-
    foldl(form_at(I), Forms, p(0.0,0.0,0.0), Sum).

form_at(What, form(Way,Start,G), Sum0, Sum) :-
    (   What == start
    ->  Part = Start
    ;   arg(What, G, Part)
    ),
    scaled(Part, Way, Vector),
    vector_sum(Sum0, Vector, Sum).
