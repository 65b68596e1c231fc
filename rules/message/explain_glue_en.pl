:- module(sg_explain_glue_en,
          [ glue_statement_en//1,       % +Statement
            glue_nothing_en//1          % +Item
          ]).
:- use_module(explain_words, [segment_word/2, point_text/2]).
/** <module> Explanations of what is glued in English; explain_glue_ko.pl has
them in Korean.
*/

%!  glue_statement_en(+Statement)// is semidet.
%
%   A statement of explain_glue.pl in English.

glue_statement_en(glued_vertex(S, V, Point)) -->
    { segment_word(S, Word), point_text(Point, Text) },
    [ 'vertex ~d of segment ~d~w is at ~w'-[V, S, Word, Text] ].
glue_statement_en(glued_edge(S, E, V1, V2)) -->
    { segment_word(S, Word) },
    [ 'edge ~d of segment ~d~w runs from vertex ~d to ~d'-
      [E, S, Word, V1, V2] ].
glue_statement_en(glued_polygon(S, P)) -->
    { segment_word(S, Word) },
    [ 'polygon ~d of segment ~d~w'-[P, S, Word] ].
glue_statement_en(was_vertex(S, V, Moved)) -->
    { segment_word(S, Word) },
    [ 'it was vertex ~d of segment ~d~w, '-[V, S, Word] ],
    moved_en(Moved).
glue_statement_en(was_polygon(S, P, Sense)) -->
    { segment_word(S, Word) },
    [ 'it is a part of polygon ~d of segment ~d~w'-[P, S, Word] ],
    (   { Sense =:= 1 }
    ->  []
    ;   [ ', turned over' ]
    ).
glue_statement_en(cut_vertex(Ss)) -->
    { atomic_list_concat(Ss, ', ', List) },
    [ 'faces, or parts of them, of these segments meet there: ~w'-
      [List] ].
glue_statement_en(point_loop(P)) -->
    [ 'it lies inside polygon ~d, as a loop of its own'-[P] ].
glue_statement_en(in_region(R)) -->
    [ 'it lies in region ~d'-[R] ].
glue_statement_en(disks_lie(D1, D2, Relation, By)) -->
    disks_lie_en(Relation, D1, D2),
    (   { By == default }
    ->  []
    ;   [ ', by the rules of ~w (disk_relation/3)'-[By] ]
    ).
glue_statement_en(disk(D, Es, Ps)) -->
    { atomic_list_concat(Es, ', ', Edges),
      atomic_list_concat(Ps, ', ', Polygons) },
    [ 'disk ~d: '-[D] ],
    (   { Es == [] }
    ->  [ 'polygon ~w, which goes on all round'-[Polygons] ]
    ;   { Ps == [] }
    ->  [ 'the wire ~w'-[Edges] ]
    ;   [ 'edges ~w, polygons ~w'-[Edges, Polygons] ]
    ).
glue_statement_en(page(P, R)) -->
    [ 'by the right hand: polygon ~d, then region ~w'-[P, R] ].
glue_statement_en(between(R, R)) -->
    !,
    [ 'region ~d is on both sides'-[R] ].
glue_statement_en(between(Below, Above)) -->
    [ 'region ~d is behind it, region ~d before it'-[Below, Above] ].
glue_statement_en(inner_loop([V])) -->
    !,
    [ 'vertex ~d lies inside it'-[V] ].
glue_statement_en(inner_loop(Vs)) -->
    { atomic_list_concat(Vs, ', ', List) },
    [ 'inside it there is the loop ~w'-[List] ].
glue_statement_en(region(S, R, Role, Volume)) -->
    { segment_word(S, Word) },
    [ 'region ~d of segment ~d~w: '-[R, S, Word] ],
    role_en(Role),
    (   { Volume == none }
    ->  []
    ;   [ ', volume ~6g'-[Volume] ]
    ).
glue_statement_en(inner_point(Point)) -->
    { point_text(Point, Text) },
    [ '~w is inside'-[Text] ].
glue_statement_en(inside(S)) -->
    { segment_word(S, Word) },
    [ 'it is inside segment ~d~w'-[S, Word] ].
glue_statement_en(beyond(R, Faces, Area)) -->
    [ 'beyond ~D of its faces, of area ~6g, is region ~d'-[Faces, Area, R] ].
glue_statement_en(laminar(P)) -->
    [ 'polygon ~d lies in it, with the region on both sides'-[P] ].
glue_statement_en(wire_in(E)) -->
    [ 'the wire ~d lies in it'-[E] ].
glue_statement_en(is_glued(S1, P1, S2, P2)) -->
    pair_en(S1, P1, S2, P2),
    [ ' are glued' ].
glue_statement_en(not_glued(S1, P1, S2, P2)) -->
    pair_en(S1, P1, S2, P2),
    [ ' have no face in common' ].
glue_statement_en(kept_apart(By)) -->
    [ 'they lie on each other, and are kept apart by ~w'-[By] ].
glue_statement_en(in_common(Vs)) -->
    { atomic_list_concat(Vs, ', ', List), length(Vs, N) },
    (   { N =:= 1 }
    ->  [ 'they have vertex ~w of the glue in common'-[List] ]
    ;   [ 'they have the vertices ~w of the glue in common'-[List] ]
    ).
glue_statement_en(gap(Gap, Point1, Point2)) -->
    { point_text(Point1, Text1), point_text(Point2, Text2) },
    (   { Gap =:= 0 }
    ->  [ 'they touch at ~w'-[Text1] ]
    ;   [ 'they are ~6g apart, from ~w to ~w'-[Gap, Text1, Text2] ]
    ).
glue_statement_en(plane_angle(Angle)) -->
    (   { Angle =:= 0 }
    ->  [ 'their planes are parallel' ]
    ;   [ 'their planes make an angle of ~6g degrees'-[Angle] ]
    ).

moved_en(Moved) -->
    (   { Moved =:= 0 }
    ->  [ 'exactly there' ]
    ;   [ 'and was moved by ~6g'-[Moved] ]
    ).

role_en(outside) -->
    [ 'the outside' ].
role_en(cell) -->
    [ 'a cell' ].
role_en(void) -->
    [ 'a void, bounded, but inside no operand' ].
role_en(slit) -->
    [ 'a slit, between faces that lie on each other' ].

pair_en(S1, P1, S2, P2) -->
    { segment_word(S1, W1), segment_word(S2, W2) },
    [ 'polygon ~d of segment ~d~w and polygon ~d of segment ~d~w'-
      [P1, S1, W1, P2, S2, W2] ].

%!  glue_nothing_en(+Item)// is det.
%
%   That there is nothing to explain in Item: what can be asked.

glue_nothing_en(Item) -->
    [ 'there is nothing to explain in ~p'-[Item], nl,
      '  glued(S, v(V)), glued(S, e(E)) and glued(S, p(P)) are of a glue S; \c
       region(S, R) of a segment with regions; \c
       why_not(glued(S1-P1, S2-P2)) of polygons of its operands.' ].

disks_lie_en(disjoint, D1, D2) -->
    [ 'disks ~d and ~d are outside each other'-[D1, D2] ].
disks_lie_en(cover, D1, D2) -->
    [ 'disks ~d and ~d together have all of space in them'-[D1, D2] ].
disks_lie_en(within, D1, D2) -->
    [ 'disk ~d is in disk ~d'-[D1, D2] ].
disks_lie_en(around, D1, D2) -->
    [ 'disk ~d is in disk ~d'-[D2, D1] ].
disks_lie_en(cross, D1, D2) -->
    [ 'disks ~d and ~d go through each other'-[D1, D2] ].
