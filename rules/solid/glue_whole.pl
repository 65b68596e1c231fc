:- module(sg_glue_whole,
          [ whole_pieces/4,             % +Operands, +Solids, +Reach, -Solid
            is_elsewhere/1              % +S
          ]).
:- use_module('../csg/csg_rows', [was_cut/1]).
:- use_module('../kernel',
              [ solid_close/1, solid_coincident_faces/3, solid_is_whole/3,
                solid_take/2 ]).
:- use_module('../stage', [stage/2]).
:- use_module('../store', [leaf_v/5, origin/3]).
:- use_module(library(lists), [member/2]).
/** <module> Whole contacts: what is glued without a cut (NG-4).

Where all contacts of operands are between equal features, vertices, edges and
faces, there is nothing to cut: they are found by hashing. A join of boxes
proves that nothing else meets, or comes within the tolerance. The result is
that of the arrangement, but for ids.
*/

%!  whole_pieces(+Operands:list, +Solids:set(id), +Reach, -Solid) is semidet.
%
%   Solid is a handle of all faces of the segments Operands, those that lie on
%   each other once; Solids, ascending, are the solids among them. Fails if they
%   meet in any other way, or if where a vertex is exactly is not what v/5 says.

whole_pieces(Operands, Solids, Reach, Solid) :-
    \+ ( member(S, Operands), is_elsewhere(S) ),
    stage(join, solid_take(Operands, Solid)),
    (   catch(stage(join, are_whole(Solid, Solids, Reach)), Error,
              ( solid_close(Solid), throw(Error) ))
    ->  true
    ;   solid_close(Solid),
        fail
    ).

are_whole(Solid, Solids, Reach) :-
    solid_coincident_faces(Solid, Reach, _),
    solid_is_whole(Solid, Solids, Reach).

%!  is_elsewhere(+S) is semidet.
%
%   True when a cut, or a Boolean, made vertices of segment S: where they are
%   exactly v/5 does not say.

is_elsewhere(S) :-
    (   leaf_v(S, _, _, _, _)
    ;   origin(S, v(_), _)
    ;   was_cut(S)
    ),
    !.
