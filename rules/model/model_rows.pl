:- module(sg_model_rows,
          [ ready/1,                    % +Row
            has_vertex/2,               % +S, ?V
            has_edges/1,                % +S
            has_polygon/2,              % +S, ?P
            edge_ends/3,                % +S, +E, -Ends
            row_added/2                 % +Row, +Place
          ]).
:- use_module('../store',
              [ v/5, e/5, p/3, plane/6, t/6, leaf_v/5, leaf_e/5, leaf_p/3,
                leaf_t/6, segment/3, origin/3, line/9, piece/3, joint/6,
                region/3, from_v/4, from_p/5, from_r/4, sides/4, lies_in/3,
                assert_after/1, relation_column/5
              ]).
:- use_module(model_text, [place_error/2, place_error/3]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [member/2, nth1/3]).
/** <module> A row of a model file goes into the world when what it refers to is
there; or it is said why not.
*/

%!  ready(+Row) is semidet.
%
%   True when the rows that Row refers to are in the world.

ready(v(_, _, _, _, _)).
ready(e(S, _, V1, V2, _)) :-
    has_vertex(S, V1),
    has_vertex(S, V2).
ready(plane(S, P, _, _, _, _)) :-
    has_polygon(S, P).
ready(t(S, P, _, V1, V2, V3)) :-
    has_polygon(S, P),
    has_vertex(S, V1),
    has_vertex(S, V2),
    has_vertex(S, V3).
ready(leaf_v(S, V, _, _, _)) :-
    has_vertex(S, V).
ready(leaf_e(S, _, V1, V2, _)) :-
    has_vertex(S, V1),
    has_vertex(S, V2).
ready(leaf_p(S, P, Es)) :-
    has_polygon(S, P),
    maplist(has_leaf_edge(S), Es).
ready(leaf_t(S, P, T, V1, V2, V3)) :-
    ready(t(S, P, T, V1, V2, V3)).
ready(origin(_, _, _)).
ready(from_v(S, V, _, _)) :-
    has_vertex(S, V).
ready(from_p(S, P, _, _, _)) :-
    has_polygon(S, P).
ready(line(_, S1, P1, A1, B1, S2, P2, A2, B2)) :-
    has_polygon(S1, P1),
    has_vertex(S1, A1),
    has_vertex(S1, B1),
    has_polygon(S2, P2),
    has_vertex(S2, A2),
    has_vertex(S2, B2).
ready(gluing(_, _)).
ready(unfolding(_, _)).
ready(piece(S, P, _)) :-
    has_polygon(S, P).
ready(region(_, _, _)).
ready(sides(S, P, Below, Above)) :-
    has_polygon(S, P),
    has_region(S, Below),
    has_region(S, Above).
ready(from_r(S, R, _, _)) :-
    has_region(S, R).
ready(lies_in(S, Item, In)) :-
    has_item(S, Item),
    has_item(S, In).
ready(joint(S, _, E1, E2, _, _)) :-
    has_edge(S, E1),
    has_edge(S, E2).

has_region(S, R) :-
    once(region(S, R, _)).
has_item(S, v(V)) :-
    has_vertex(S, V).
has_item(S, e(E)) :-
    has_edge(S, E).
has_item(S, p(P)) :-
    has_polygon(S, P).
has_item(S, r(R)) :-
    has_region(S, R).
%!  has_vertex(+S, ?V) is semidet.
%!  has_edges(+S) is semidet.
%!  has_polygon(+S, ?P) is semidet.
%
%   True when segment S has such rows. Number 1, mostly there, needs no search.

has_vertex(S, V) :-
    (   var(V),
        v(S, 1, _, _, _)
    ->  V = 1
    ;   once(v(S, V, _, _, _))
    ).
has_edges(S) :-
    (   e(S, 1, _, _, _)
    ->  true
    ;   once(e(S, _, _, _, _))
    ).
has_polygon(S, P) :-
    once(p(S, P, _)).
has_edge(S, E) :-
    once(e(S, E, _, _, _)).
has_leaf_edge(S, E) :-
    once(leaf_e(S, E, _, _, _)).
%!  edge_ends(+S, +E, -Ends) is semidet.
%
%   Ends are V1-V2, the vertices of edge E of segment S.

edge_ends(S, E, V1-V2) :-
    once(e(S, E, V1, V2, _)).

%!  row_added(+Row, +Place) is det.
%
%   Row is in the world, or the error says where.
%
%   @error model_error(What): missing, twice, refused (model_file.pl)

row_added(lies_in(S, Item, In), Place) :-
    nth1(I, [Item,In], One),
    \+ has_item(S, One),
    !,
    item_of(One, Relation, Id),
    Argument is I+1,
    place_error(Place, Argument, missing(Relation, S, Id)).
row_added(Row, Place) :-
    catch(assert_after(Row), error(Formal, _),
          row_refused(Formal, Row, Place)).

item_of(v(V), v, V).
item_of(e(E), e, E).
item_of(p(P), p, P).
item_of(r(R), region, R).

row_refused(Formal, Row, Place) :-
    (   Formal = resource_error(_)
    ->  throw(error(Formal, _))
    ;   missing_reference(Row, Argument, Relation, S, Id)
    ->  place_error(Place, Argument, missing(Relation, S, Id))
    ;   key_taken(Row, Name, Key)
    ->  place_error(Place, twice(Name, Key))
    ;   Formal = existence_error(leaf_e, S-E)
    ->  place_error(Place, missing(leaf_e, S, E))
    ;   place_error(Place, refused(Row, Formal))
    ).

missing_reference(Row, Argument, Relation, S, Id) :-
    functor(Row, Name, _),
    member(Relation-Missing,
           [ v-has_vertex(S, Id), p-has_polygon(S, Id), e-has_edge(S, Id),
             region-has_region(S, Id) ]),
    relation_column(Name, Position, _, int, Relation),
    segment_position(Name, Position, Of),
    arg(Of, Row, S),
    Argument is Position+1,
    arg(Argument, Row, Id),
    \+ call(Missing),
    !.

%   segment_position(Name, Position, Argument): the ids in the column at
%   Position are of the segment in Argument of the row.

segment_position(Name, Position, Argument) :-
    (   relation_column(Name, Position, Column, _, _),
        sub_atom(Column, 0, _, _, 'S')
    ->  Argument is Position+1
    ;   Before is Position-1,
        segment_position(Name, Before, Argument)
    ).

key_taken(Row, Name, Key) :-
    row_key(Row, Name, Key, Same),
    call(Same),
    !.

row_key(v(S, V, _, _, _), v, [S, V], v(S, V, _, _, _)).
row_key(e(S, E, _, _, _), e, [S, E], e(S, E, _, _, _)).
row_key(p(S, P, _), p, [S, P], p(S, P, _)).
row_key(plane(S, P, _, _, _, _), plane, [S, P], plane(S, P, _, _, _, _)).
row_key(t(S, _, T, _, _, _), t, [S, T], t(S, _, T, _, _, _)).
row_key(leaf_v(S, V, _, _, _), leaf_v, [S, V], leaf_v(S, V, _, _, _)).
row_key(leaf_e(S, E, _, _, _), leaf_e, [S, E], leaf_e(S, E, _, _, _)).
row_key(leaf_p(S, P, _), leaf_p, [S, P], leaf_p(S, P, _)).
row_key(leaf_t(S, _, T, _, _, _), leaf_t, [S, T], leaf_t(S, _, T, _, _, _)).
row_key(origin(S, Item, _), origin, [S, Item], origin(S, Item, _)).
row_key(from_v(S, V, _, _), from_v, [S, V], from_v(S, V, _, _)).
row_key(from_p(S, P, T, Q, _), from_p, [S, P, T, Q], from_p(S, P, T, Q, _)).
row_key(piece(S, P, _), piece, [S, P], piece(S, P, _)).
row_key(joint(S, J, _, _, _, _), joint, [S, J], joint(S, J, _, _, _, _)).
row_key(region(S, R, _), region, [S, R], region(S, R, _)).
row_key(sides(S, P, _, _), sides, [S, P], sides(S, P, _, _)).
row_key(from_r(S, R, S0, _), from_r, [S, R, S0], from_r(S, R, S0, _)).
row_key(lies_in(S, Item, _), lies_in, [S, Item], lies_in(S, Item, _)).
row_key(segment(S, _, _), segment, [S], segment(S, _, _)).
row_key(line(L, _, _, _, _, _, _, _, _), line, [L],
        line(L, _, _, _, _, _, _, _, _)).
