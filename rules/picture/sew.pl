:- module(sg_sew,
          [ borders_sewn/1              % -Vertices
          ]).
:- use_module('../kernel', [census_defect/4]).
:- use_module('../solid/repair', [welded_vertex/2]).
:- use_module('../store', [v/5, e/5, facts_transaction/1]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc), [assoc_to_list/2, empty_assoc/1, get_assoc/3,
                               put_assoc/4]).
:- use_module(library(lists), [member/2, sum_list/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Borders that lie on each other, edge by edge, are sewn together.

Many programs write a surface patch by patch, each with vertices of its own. To
the eye it is one surface: where a border edge of a segment lies exactly on
another one of it, which runs the other way, and on no third, the two are one
edge, and their ends one vertex each. Nothing moves.
*/

%!  borders_sewn(-Vertices:integer) is det.
%
%   Sew every segment of the current world. Vertices is how many became another
%   one, in the same place, which has the smaller number. One transaction.

borders_sewn(Vertices) :-
    findall(S-E, census_defect(border_edge, S, E, _), Borders0),
    (   Borders0 == []
    ->  Vertices = 0
    ;   sort(Borders0, Borders),
        group_pairs_by_key(Borders, Segments),
        facts_transaction(maplist(sg_sew:segment_sewn, Segments, Counts)),
        sum_list(Counts, Vertices)
    ).

segment_sewn(S-Edges, Count) :-
    findall(Place-End, ( member(E, Edges), border_at(S, E, Place, End) ),
            Placed0),
    keysort(Placed0, Placed),
    group_pairs_by_key(Placed, Seams),
    empty_assoc(None),
    foldl(seam_joined, Seams, None, First),
    findall(V-V0, ( assoc_to_list(First, Pairs), member(V-_, Pairs),
                    first_of(V, First, V0), V0 \== V ),
            Twins),
    length(Twins, Count),
    (   Twins == []
    ->  true
    ;   maplist(welded_vertex(S), Twins),
        complete_segments([S])
    ).

%   border_at(S, E, Place, End): Place is that of the edge, whichever way it
%   runs; End is there(A, B) or back(A, B), A at the lesser end.

border_at(S, E, Place, End) :-
    e(S, E, V1, V2, _),
    point(S, V1, P1),
    point(S, V2, P2),
    (   P1 @< P2
    ->  Place = P1-P2,
        End = there(V1, V2)
    ;   Place = P2-P1,
        End = back(V2, V1)
    ).

point(S, V, at(X, Y, Z)) :-
    v(S, V, X, Y, Z).

%   seam_joined(Seam, First0, First): First has of each vertex one that it is
%   joined with and that has a smaller number, or itself.

seam_joined(_-Ends, First0, First) :-
    (   msort(Ends, [back(A1, B1),there(A2, B2)])
    ->  joined(A1, A2, First0, First1),
        joined(B1, B2, First1, First)
    ;   First = First0
    ).

joined(V, W, First0, First) :-
    first_of(V, First0, V0),
    first_of(W, First0, W0),
    Low is min(V0, W0),
    High is max(V0, W0),
    put_assoc(Low, First0, Low, First1),
    put_assoc(High, First1, Low, First).

first_of(V, First, V0) :-
    (   get_assoc(V, First, V1),
        V1 \== V
    ->  first_of(V1, First, V0)
    ;   V0 = V
    ).
