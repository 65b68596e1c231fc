/* Rules under which a penetration line is drawn as an edge of the later of its
   two segments, and looks as that one does. See docs/rules.md.

       sanggwan draw facts/figures/fig13.pl --rules docs/line_rules.pl
*/

line_segment(_, S2, S2).
