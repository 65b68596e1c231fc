:- module(sg_seam_measure,
          [ seam_drawn/3,               % +D, -Seam, -Longest
            pattern_area/2              % +D, -Area
          ]).
:- use_module('../disjoint_sets', [set_root/3, sets_joined/4]).
:- use_module(part_edges, [edge_length/3]).
:- use_module('../store', [e/5, from_v/4, joint/6, t/6, v/5]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [empty_assoc/1]).
:- use_module(library(lists), [max_list/2, member/2, nth1/3, sum_list/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> How long the seams of a pattern are, as it is drawn.

Of a thick plate bends take off something of the seams too, and a true
development has lengths of its own; so both are measured in the pattern.
*/

%!  seam_drawn(+D, -Seam, -Longest) is det.
%
%   Seam is the length of all seams of pattern D, each once (its longer side, if
%   they differ); Longest that of the longest weld: seams end to end, as far as
%   no others meet. Model units; 0.0 if there are none.

seam_drawn(D, Seam, Longest) :-
    findall(seam(A, B, Length), seam_edge(D, A, B, Length), Seams),
    maplist(seam_length, Seams, Lengths),
    sum_list([0.0|Lengths], Seam),
    findall(V-I,
            ( nth1(I, Seams, seam(A, B, _)), ( V = A ; V = B ) ),
            Ends0),
    msort(Ends0, Ends),
    group_pairs_by_key(Ends, Groups),
    findall(I-J, ( member(_-[I,J], Groups), I =\= J ), Links),
    empty_assoc(Sets0),
    foldl(linked, Links, Sets0, Sets),
    findall(Root-Length,
            ( nth1(I, Seams, seam(_, _, Length)),
              set_root(Sets, I, Root) ),
            Parts0),
    keysort(Parts0, Parts),
    group_pairs_by_key(Parts, Welds),
    findall(Weld, ( member(_-Ls, Welds), sum_list(Ls, Weld) ), All),
    max_list([0.0|All], Longest).

linked(I-J, Sets0, Sets) :-
    sets_joined(I, J, Sets0, Sets).

seam_length(seam(_, _, Length), Length).

%   seam_edge(D, A, B, Length) is nondet: its ends are named by the vertices of
%   the model, or by the smaller of the two copies.

seam_edge(D, A, B, Length) :-
    joint(D, _, E1, E2, seam, _),
    once(e(D, E1, A1, B1, _)),
    once(e(D, E2, B2, A2, _)),
    end_name(D, A1, A2, A),
    end_name(D, B1, B2, B),
    edge_length(D, E1, Length1),
    edge_length(D, E2, Length2),
    Length is max(Length1, Length2).

end_name(D, W1, W2, Name) :-
    (   from_v(D, W1, S, V)
    ->  Name = v(S, V)
    ;   W is min(W1, W2),
        Name = copy(W)
    ).

%!  pattern_area(+D, -Area) is det.
%
%   Area is that of the triangles of pattern D.

pattern_area(D, Area) :-
    aggregate_all(sum(Part), triangle_area(D, Part), Area).

triangle_area(D, Area) :-
    t(D, _, _, A, B, C),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.
