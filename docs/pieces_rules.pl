/* Rules under which penetration lines stay in pieces: every point in which a
   line passes from one triangle to the next is kept. See docs/rules.md.

       sanggwan penetrate facts/two_cubes.pl --rules docs/pieces_rules.pl
*/

merge_line(_, _) :-
    fail.
