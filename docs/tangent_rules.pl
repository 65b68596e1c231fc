/* Rules under which there is a thin line where operands of a union are tangent.
   See docs/rules.md.

       sanggwan draw docs/capsule.pl --rules docs/tangent_rules.pl
*/

edge_role(S, E, Look, Crease, Role) :-
    default(edge_role(S, E, Look, Crease, Role0)),
    (   memberchk(Role0, [smooth,mesh]),
        e(S, E, A, B, _),
        of_operands(S, A, B)
    ->  Role = curve
    ;   Role = Role0
    ).

of_operands(S, A, B) :-
    (   line(_, S, _, A, B, S, _, _, _)
    ;   line(_, S, _, B, A, S, _, _, _)
    ),
    !.
