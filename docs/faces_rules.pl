/* Rules under which faces of different segments never become one: the line
   where two parts meet is seen. See docs/rules.md.

       sanggwan draw docs/l_of_two_boxes.pl --rules docs/faces_rules.pl
*/

merge_faces(part(S, _, _), part(S, _, _)).
