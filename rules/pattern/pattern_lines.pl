:- module(sg_pattern_lines,
          [ piece_outline/3,            % +Piece, +Tabs, -Outline
            outline_loops/2,            % +Outline, -Loops
            piece_line/4,               % +Piece, +Tabs, +How, -Line
            outline_strokes/3           % +Loops, +D, -Strokes
          ]).
:- use_module(pattern_outline, [cut_loops/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
:- use_module(library(rbtrees), [rb_insert_new/4, rb_new/1]).
/** <module> What is drawn of a piece: its outline with tabs, folds, marks.

An outline is a list of loops, those of holes first; a loop is a list of
way(E,Points), how the outline goes along side E: straight, or round its tabs.
Tabs is an assoc of tab(D,E,A,B) to the outlines of its tabs (pattern_tab.pl).
*/

:- set_prolog_flag(optimise, true).

%!  piece_outline(+Piece, +Tabs, -Outline) is det.
%
%   Outline is that of Piece (pattern_piece.pl), round those of Tabs that are at
%   its sides.

piece_outline(piece(name(D,_,_),_,Sides), Tabs, Outline) :-
    cut_loops(Sides, Loops),
    maplist(loop_ways(D, Tabs), Loops, Outline).

loop_ways(D, Tabs, Loop, Ways) :-
    maplist(side_way(D, Tabs), Loop, Ways).

side_way(D, Tabs, side(E,_,WA-A,WB-B,_), way(E,Points)) :-
    (   get_assoc(tab(D,E,WA,WB), Tabs, Own)
    ->  way_round(Own, A, B, Points)
    ;   Points = [A,B]
    ).

way_round(strip(Points), _, _, Points) :-
    !.
way_round(Outlines, A, B, Points) :-
    append(Outlines, Points0),
    append([A|Points0], [B], Points1),
    once_each(Points1, Points).

%   Where tabs begin or end at a corner, or at each other, that is one point.

once_each([P,P|Points0], Points) :-
    !,
    once_each([P|Points0], Points).
once_each([P|Points0], [P|Points]) :-
    !,
    once_each(Points0, Points).
once_each([], []).

%!  outline_loops(+Outline, -Loops) is det.
%
%   Loops are lists of points, without the first one again at the end.

outline_loops(Outline, Loops) :-
    maplist(ways_points, Outline, Loops).

ways_points([], []).
ways_points([way(_,Points)|Ways], All) :-
    append(Some, [_], Points),
    !,
    append(Some, All1, All),
    ways_points(Ways, All1).

%!  piece_line(+Piece, +Tabs, +How, -Line) is nondet.
%
%   Line is line(Role,E,A,B), what is drawn inside of Piece; How is
%   how(Threshold,Butt): folds of at most Threshold degrees are not drawn; Butt
%   an assoc of the seams D-J that are marked for having no tab.

piece_line(piece(name(D,_,_),_,Sides), Tabs, how(Threshold,Butt), Line) :-
    member(Side, Sides),
    (   fold_line(Side, Threshold, Line)
    ;   tab_line(Side, D, Tabs, Threshold, Line)
    ;   side_mark(Side, D, Butt, Line)
    ).

fold_line(side(E,_,_-A,_-B,fold(_,Angle,1)), Threshold, line(Role,E,A,B)) :-
    fold_role(Angle, Threshold, Role).
fold_line(side(E,_,_-A,_-B,line(_,1)), _, line(penetration_line,E,A,B)).
fold_line(side(E,_,_-A,_-B,generator(_)), _, line(generator,E,A,B)).

fold_role(Angle, Threshold, Role) :-
    (   Angle > Threshold
    ->  Role = fold_down
    ;   Angle < -Threshold
    ->  Role = fold_up
    ).

%   Where a tab begins it is folded too.

tab_line(side(E,_,WA-A,WB-B,seam(_,Angle,_)), D, Tabs, Threshold,
         line(Role,E,First,Last)) :-
    get_assoc(tab(D,E,WA,WB), Tabs, Own),
    (   Own = strip(_)
    ->  First = A,
        Last = B
    ;   member([First|Tab], Own),
        last(Tab, Last)
    ),
    (   fold_role(Angle, Threshold, Role0)
    ->  Role = Role0
    ;   Role = mark
    ).

side_mark(side(E,_,_-A,_-B,seam(J,_,_)), D, Butt, line(mark,E,P,Q)) :-
    (   J = split(_,_)
    ->  member(T, [0.25,0.75]),
        Deep = 4.0
    ;   get_assoc(D-J, Butt, _),
        T = 0.5,
        Deep = 2.0
    ),
    tick(A, B, T, Deep, P, Q).

%   A tick into the face from T of the way from A to B.

tick(XA-YA, XB-YB, T, Deep0, X-Y, X2-Y2) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Length > 0.5,
    Deep is min(Deep0, Length/4),
    X is XA + T*(XB-XA),
    Y is YA + T*(YB-YA),
    X2 is X - Deep*(YB-YA)/Length,
    Y2 is Y + Deep*(XB-XA)/Length.

%!  outline_strokes(+Loops, +D, -Strokes) is det.
%
%   Strokes (stroke.pl) cut along Loops, lists of edge(E,A,B) on the sheet. No
%   line is cut twice: where a slit closes without a gap its second side is left
%   out, and the loop is open there.

outline_strokes(Loops, D, Strokes) :-
    rb_new(Seen),
    foldl(loop_strokes(D), Loops, Seen-Strokes, _-[]).

loop_strokes(D, Loop, Seen0-Strokes0, Seen-Strokes) :-
    new_edges(Loop, Seen0, Seen, Marked),
    loop_chains(Marked, Chains),
    foldl(chain_stroke(D), Chains, Strokes0, Strokes).

%   new_edges(Edges, Seen0, Seen, Marked): Edges that were drawn before become
%   `gap`; those without length vanish.

new_edges([], Seen, Seen, []).
new_edges([edge(_,P,P)|Edges], Seen0, Seen, Marked) :-
    !,
    new_edges(Edges, Seen0, Seen, Marked).
new_edges([Edge|Edges], Seen0, Seen, [Mark|Marked]) :-
    Edge = edge(_, A, B),
    msort([A,B], Key),
    (   rb_insert_new(Seen0, Key, true, Seen1)
    ->  Mark = Edge
    ;   Seen1 = Seen0,
        Mark = gap
    ),
    new_edges(Edges, Seen1, Seen, Marked).

%   Without gaps a ring; else what is between gaps, also across the start.

loop_chains(Marked, Chains) :-
    (   append(Before, [gap|After], Marked)
    ->  append(After, Before, Turned),
        gap_chains(Turned, Chains)
    ;   Marked == []
    ->  Chains = []
    ;   Chains = [Marked]
    ).

gap_chains(Marked, Chains) :-
    (   append(Chain, [gap|Rest], Marked)
    ->  true
    ;   Chain = Marked,
        Rest = []
    ),
    (   Chain == []
    ->  Chains = Chains1
    ;   Chains = [Chain|Chains1]
    ),
    (   Rest == []
    ->  Chains1 = []
    ;   gap_chains(Rest, Chains1)
    ).

chain_stroke(D, Edges, [stroke(visible,cut,D,Es,[A|Points],End,End)|Strokes],
             Strokes) :-
    Edges = [edge(_,A,_)|_],
    findall(E, member(edge(E,_,_), Edges), Es),
    findall(B, member(edge(_,_,B), Edges), Points),
    last(Points, Last),
    (   Last == A
    ->  End = ring
    ;   End = joint
    ).
