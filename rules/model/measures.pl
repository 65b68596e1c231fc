:- module(sg_measures,
          [ volume/2,                   % ?S, -Volume
            area/2,                     % ?S, -Area
            bounding_box/3              % ?S, -Low, -High
          ]).
:- use_module('../csg/csg', [node/4]).
:- use_module('../csg/csg_roots', [aside_segments/1]).
:- use_module('../kernel', [census/1]).
:- use_module('../solid/csg_evaluate', [evaluate/2]).
:- use_module('../store', [segment/3, facts_snapshot/1]).
:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_memberchk/2]).

/** <module> Measures: how large segments are.

Numbers of the census, rounded. A node of a CSG tree is measured by its
boundary, which is made for the question if it is not there; the world stays as
it is.
*/

%!  volume(?S, -Volume) is nondet.
%
%   Volume is what solid S encloses, in model units. A shell that is inside out
%   counts as less than nothing. With S unbound: of every root, ascending.
%
%   @error those of evaluate/1

volume(S, Volume) :-
    measured(S, part(_,_,_,_,Volume,_,_,_)),
    segment(S, solid, _).

%!  area(?S, -Area) is nondet.
%
%   Area is that of all polygons of segment S, in model units.
%
%   @error those of evaluate/1

area(S, Area) :-
    measured(S, part(_,_,_,Area,_,_,_,_)).

%!  bounding_box(?S, -Low, -High) is nondet.
%
%   The vertices of segment S lie from Low to High, both point(X,Y,Z).
%
%   @error those of evaluate/1

bounding_box(S, point(X1,Y1,Z1), point(X2,Y2,Z2)) :-
    measured(S, part(_,_,box(X1,Y1,Z1,X2,Y2,Z2),_,_,_,_,_)).

%   measured(?S, -Part) is nondet: Part is what census/1 says of S, det for a
%   given S. Unbound, S is a root.

measured(S, Part) :-
    (   var(S)
    ->  aside_segments(Aside),
        parts(all, Parts),
        member(Part, Parts),
        arg(1, Part, S),
        \+ ord_memberchk(S, Aside)
    ;   parts(S, Parts),
        memberchk_segment(S, Parts, Part)
    ).

memberchk_segment(S, Parts, Part) :-
    Part = part(S,_,_,_,_,_,_,_),
    memberchk(Part, Parts).

parts(Which, Parts) :-
    (   node(N, Operation, _, _),
        Operation \== leaf,
        ( Which == all ; Which == N )
    ->  facts_snapshot(sg_measures:parts_evaluated(Which, Parts))
    ;   census(Parts)
    ).

parts_evaluated(Which, Parts) :-
    evaluate(Which, []),
    census(Parts).
