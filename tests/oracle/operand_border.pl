:- module(sg_oracle_operand_border,
          [ operands_meet/2             % +S, -Border
          ]).
:- use_module('../../rules/store', [e/5, from_p/5, edge_polygon/3]).
/** <module> The rule of operand_borders/2: where the boundary of a node turns
from one operand to another.
*/

%!  operands_meet(+S, -Border) is nondet.
%
%   True when Border is border(S, P, V1, V2, Q): polygon P of S has the edge
%   from V1 to V2, V1 < V2, and Q its opposite, and they are parts of operands,
%   of no common one.

operands_meet(S, border(S, P, V1, V2, Q)) :-
    e(S, E, V1, V2, _),
    V1 < V2,
    e(S, Twin, V2, V1, _),
    edge_polygon(S, E, P),
    edge_polygon(S, Twin, Q),
    is_part(S, P),
    is_part(S, Q),
    \+ ( from_p(S, P, K, _, _),
         from_p(S, Q, K, _, _) ).

is_part(S, P) :-
    from_p(S, P, _, _, _),
    !.
