:- module(sg_operand_line,
          [ crossing_lines/2            % +Lines0, -Lines
          ]).
:- use_module('../csg/csg_roots', [with_operand_lines/2]).
:- use_module('../kernel', [scene_edge/5]).
:- use_module('../store', [e/5]).
:- use_module(hidden_lines, [open_scene/2]).
:- use_module(role, [look_part/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_memberchk/2]).
/** <module> Where operands of a tree cross.

The boundary of a tree's result turns from one operand to another along lines.
Where the surfaces of these are tangent they go on in each other, and a drawing
has no line (scene_lines.c).
*/

%!  crossing_lines(+Lines0, -Lines) is det.
%
%   Lines are those of Lines0, border(S, P, V1, V2, Q) as of operand_lines/1,
%   where the surfaces are not tangent. There is a picture.

crossing_lines([], []) :-
    !.
crossing_lines(Lines0, Lines) :-
    with_operand_lines(Lines0, sg_operand_line:cut_edges(Cuts)),
    findall(Line,
            ( member(Line, Lines0),
              Line = border(S, _, V1, V2, _),
              msort([V1,V2], Vs),
              ord_memberchk(S-Vs, Cuts) ),
            Lines).

:- public cut_edges/1.

cut_edges(Cuts) :-
    open_scene(Scene, []),
    findall(S-Vs,
            ( scene_edge(Scene, S, E, _, Look),
              look_part(cut, Look, true),
              e(S, E, V1, V2, _),
              msort([V1,V2], Vs) ),
            Cuts0),
    sort(Cuts0, Cuts).
