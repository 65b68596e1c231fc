:- module(sg_operand_edge,
          [ operand_items/2             % +S, -Items
          ]).
:- use_module('../csg/csg',
              [is_node/1, node/4, operand_segment/2, root_segment/1]).
:- use_module('../csg/provenance', [polygon_from/5]).
:- use_module('../store', [e/5, p/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(ordsets), [ord_memberchk/2, ord_subtract/3, ord_union/3]).
/** <module> Which faces and edges of a model an operand has made.
*/

%!  operand_items(+S, -Items:list) is semidet.
%
%   Segment S is an operand. Items are edge(Root, E), both halves of the edges
%   round the faces, of all roots of the tree, that have a part of a face of S,
%   or of what S is made of; then polygon(Root, P), these faces; both ascending.
%   As in operand_face/3, what several operands use is of all of them. The
%   current world still has its tree.

operand_items(S, Items) :-
    once(operand_segment(S, _)),
    leaves_below([S], [S], Leaves),
    findall(polygon(Root,P),
            ( root_segment(Root),
              is_node(Root),
              face_of(Root, Leaves, P) ),
            Polygons0),
    sort(Polygons0, Polygons),
    findall(edge(Root,E),
            ( member(polygon(Root,P), Polygons),
              edge_around(Root, P, E) ),
            Edges0),
    sort(Edges0, Edges),
    append(Edges, Polygons, Items).

%   leaves_below(Open, Seen, Leaves): of the tree below the segments Open, all
%   in Seen, each looked at once; Seen and Leaves are ordered sets.

leaves_below([], _, []).
leaves_below([S|Open0], Seen0, Leaves) :-
    node(S, _, Children0, _),
    (   Children0 == []
    ->  leaves_below(Open0, Seen0, Leaves0),
        ord_union([S], Leaves0, Leaves)
    ;   sort(Children0, Children),
        ord_subtract(Children, Seen0, New),
        ord_union(Seen0, New, Seen),
        append(New, Open0, Open),
        leaves_below(Open, Seen, Leaves)
    ).

face_of(Root, Leaves, P) :-
    p(Root, P, _),
    once(( polygon_from(Root, P, Leaf, _, _),
           ord_memberchk(Leaf, Leaves) )).

edge_around(Root, P, E) :-
    p(Root, P, Es),
    member(E0, Es),
    E0 =\= 0,
    Half is abs(E0),
    (   E = Half
    ;   e(Root, Half, V1, V2, _),
        e(Root, E, V2, V1, _)
    ).
