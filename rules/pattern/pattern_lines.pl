:- module(sg_pattern_lines,
          [ piece_outline/3,            % +Piece, +Tabs, -Outline
            outline_loops/2,            % +Outline, -Loops
            piece_line/4,               % +Piece, +Tabs, +How, -Line
            outline_strokes/3           % +Loops, +D, -Strokes
          ]).
:- use_module(pattern_outline,
              [cut_loops/2, loops_ranked/2, walked_sides/2]).
:- use_module(library(apply),
              [exclude/3, foldl/4, maplist/3, partition/4]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
:- use_module(library(rbtrees),
              [rb_insert/4, rb_insert_new/4, rb_lookup/3, rb_new/1]).
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
way_round(allowance(Points,_), _, _, Points) :-
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
    ;   allowance_fold(Side, D, Tabs, Line)
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
    (   ( Own = strip(_) ; Own = allowance(_, _) )
    ->  First = A,
        Last = B
    ;   member([First|Tab], Own),
        last(Tab, Last)
    ),
    (   fold_role(Angle, Threshold, Role0)
    ->  Role = Role0
    ;   Role = mark
    ).

%   Where the edge of a lock seam is folded over.

allowance_fold(side(E,_,WA-_,WB-_,_), D, Tabs, line(Role,E,P,Q)) :-
    get_assoc(tab(D,E,WA,WB), Tabs, allowance(_, Folds)),
    member(fold(Role,P,Q), Folds).

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
%   line is cut twice: where the two sides of a slit lie on each other, it is a
%   stroke of its own, open, before all others; what is left of its loops are
%   rings, those round holes before the others. Each other loop is one ring.

outline_strokes(Loops0, D, Strokes) :-
    maplist(exclude(without_length), Loops0, Loops1),
    exclude(==([]), Loops1, Loops),
    edges_there(Loops, There),
    partition(has_slit(There), Loops, Slit, Whole),
    (   Slit == []
    ->  Rings = Loops,
        Slits = []
    ;   append(Slit, Edges),
        slit_chains(Edges, There, Slits),
        exclude(edge_in_slit(There), Edges, Sides),
        edge_rings(Sides, Rings0),
        append(Rings0, Whole, Rings1),
        rings_ranked(Rings1, Rings)
    ),
    append(Slits, Rings, Chains),
    foldl(chain_stroke(D), Chains, Strokes, []).

without_length(edge(_,A,A)).

%   edges_there(Loops, There): the keys of There are A-B, each edge of Loops.

edges_there(Loops, There) :-
    rb_new(There0),
    foldl(foldl(edge_there), Loops, There0, There).

edge_there(edge(_,A,B), There0, There) :-
    rb_insert(There0, A-B, true, There).

edge_in_slit(There, edge(_,A,B)) :-
    rb_lookup(B-A, true, There).

has_slit(There, Loop) :-
    once(( member(Edge, Loop), edge_in_slit(There, Edge) )).

%   slit_chains(Edges, There, Chains): those of Edges that lie on another one,
%   each once, end to end as far as they follow each other.

slit_chains(Edges, There, Chains) :-
    rb_new(Seen),
    foldl(slit_edge(There), Edges, Seen-Marked, _-[]),
    marked_chains(Marked, Chains).

slit_edge(There, Edge, Seen0-Marked0, Seen-Marked) :-
    Edge = edge(_, A, B),
    (   edge_in_slit(There, Edge),
        \+ rb_lookup(B-A, true, Seen0),
        rb_insert_new(Seen0, A-B, true, Seen)
    ->  Marked0 = [Edge|Marked]
    ;   Seen = Seen0,
        Marked0 = [gap|Marked]
    ).

marked_chains([], []).
marked_chains([gap|Marked], Chains) :-
    !,
    marked_chains(Marked, Chains).
marked_chains([Edge|Marked], [[Edge|Chain]|Chains]) :-
    chain_goes_on(Marked, Edge, Chain, Rest),
    marked_chains(Rest, Chains).

chain_goes_on([Edge|Marked], edge(_,_,A), [Edge|Chain], Rest) :-
    Edge = edge(_, A, _),
    !,
    chain_goes_on(Marked, Edge, Chain, Rest).
chain_goes_on(Rest, _, [], Rest).

%   edge_rings(Edges, Rings): as many begin as end at each point; on the sheet y
%   is down, so they are walked with y turned round.

edge_rings(Edges, Rings) :-
    maplist(edge_side, Edges, Sides),
    walked_sides(Sides, Loops),
    maplist(maplist(side_edge), Loops, Rings).

edge_side(edge(E,A,B), side(E,none,A-A1,B-B1,border)) :-
    upright(A, A1),
    upright(B, B1).

upright(X-Y0, X-Y) :-
    Y is -Y0.

side_edge(side(E,_,A-_,B-_,_), edge(E,A,B)).

%   rings_ranked(Rings0, Rings): those round holes first, then the larger ones
%   last.

rings_ranked(Rings0, Rings) :-
    maplist(maplist(edge_side), Rings0, Loops0),
    loops_ranked(Loops0, Loops),
    maplist(maplist(side_edge), Loops, Rings).

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
