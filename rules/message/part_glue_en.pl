:- module(sg_part_glue_en,
          [ part_glue_en//1            % +What
          ]).
/** <module> English for what is glued, or unglued, in part.

Faults geometry_error(part_glue(What)) of rules/gluing.
*/

%!  part_glue_en(+What)// is semidet.

part_glue_en(disks_cross(S, V, D1, D2)) -->
    [ 'segment ~d: disks ~d and ~d at vertex ~d go through each other, by \c
       disk_relation/3'-[S, D1, D2, V], nl,
      '  Cut them first, or use other --rules.' ].
part_glue_en(unglued(S, Item)) -->
    unglued_en(Item, S).
part_glue_en(one_cells(N)) -->
    [ 'of the models to unglue ~D are cells'-[N], nl,
      '  --region, --face and --between are of one: give its file alone.' ].
part_glue_en(not_glued(S, Item1, Item2, Why)) -->
    [ 'segment ~d: ~p and ~p were not glued: '-[S, Item1, Item2] ],
    not_glued_en(Why).
part_glue_en(euler_change(S, Operation, Change)) -->
    [ 'segment ~d: ~p would be ~p, which is no change of it, so nothing was \c
       changed'-[S, Operation, Change], nl,
      '  What it makes meets something else: glue that first.' ].

part_glue_en(wish(S, Wish)) -->
    [ 'gluing(~d, ~p) names nothing of the glue ~d'-[S, Wish, S], nl,
      '  Write only(vertices), only(edges), only(faces), apart(S1, S2), \c
       apart(S1-Item), glued(S1-Item1, S2-Item2), dissolve(R1, R2) or \c
       tolerance(T): Item is v(V), e(A,B) or p(P) of an operand, R1 and R2 \c
       are bounded regions side by side, numbers or region(Operands), T is 0 \c
       or more.' ].
part_glue_en(no_side(S)) -->
    [ 'segment ~d: what stays apart lies on faces, and on which side of them \c
       cannot be told'-[S], nl,
      '  Let it be glued to them somewhere.' ].

unglued_en(p(P), S) -->
    [ 'polygon ~d of segment ~d does not lie between two cells, so it cannot \c
       be unglued'-[P, S], nl,
      '  cells --neighbours shows which regions have faces in common.' ].
unglued_en(r(R), S) -->
    [ 'region ~d of segment ~d is no cell, so it cannot be unglued'-[R, S], nl,
      '  cells shows the cells.' ].
unglued_en(R1-R2, S) -->
    [ 'no polygon of segment ~d lies between the regions ~d and ~d'-
      [S, R1, R2], nl,
      '  cells --neighbours shows which have faces in common.' ].

not_glued_en(apart) -->
    [ 'they are not in one place' ].
not_glued_en(beside) -->
    [ 'the first does not lie inside the second' ].
not_glued_en(crossing) -->
    [ 'what is there goes through each other (disk_relation/3)', nl,
      '  Cut it first.' ].
not_glued_en(touching) -->
    [ 'edges of both run in one direction', nl,
      '  Glue these edges, or the faces.' ].
