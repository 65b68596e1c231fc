:- module(sg_explain_pair,
          [ pair_because/3,             % +Place1, +Place2, -Because
            segments_because/3,         % +S1, +S2, -Because
            line_pieces/2,              % +L, -Because
            decided_by/2,               % +Decision, -By
            leaf_corners/3              % +S, +P, -Triangle
          ]).
:- use_module('../decision', [decision/4]).
:- use_module(explain_parameter, [pair_sizes/3]).
:- use_module('../exact', [origin_exact/4, vertex_exact/5, vertex_side/4]).
:- use_module('../kernel',
              [ cut_set_open/2, cut_set_close/1, cut_candidate/3, cut_side/4,
                cut_triangle/5, cut_ends/4 ]).
:- use_module('../penetration/penetration', [may_cut/2]).
:- use_module('../store', 
              [ v/5, e/5, p/3, t/6, leaf_e/5, leaf_p/3, leaf_t/6, segment/3,
                origin/3, line/9, assert_fact/1, in_passing_world/1 ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(filesex), [relative_file_name/3]).
:- use_module(library(lists), [append/3, max_list/2, member/2,
                               min_list/2, nth1/3]).

/** <module> Explain: why two polygons give a line, or none.

The join of penetration.pl again, for one pair of polygons: their leaf
triangles, whose boxes overlap or not; on which side of the other's plane each
lies; what they have in common. All by the exact tests that decided.
*/

%!  segments_because(+S1, +S2, -Because) is det.
%
%   Why segments S1 and S2, S1 =< S2, have lines or none.

segments_because(S1, S2, [because(segments(S1,S2), Because)]) :-
    findall(L, line(L, S1, _, _, _, S2, _, _, _), Ls),
    length(Ls, N),
    (   N > 0
    ->  Why = lines_between(N)
    ;   not_cut(S1, S2, Why)
    ->  true
    ;   boxes_apart(S1-_, S2-_, Why)
    ->  true
    ;   Why = no_common_piece
    ),
    pair_sizes(S1, S2, Sizes),
    Because = [because(Why, [])|Sizes].

%   not_cut(+S1, +S2, -Why) is semidet: they were not to cut each other.

not_cut(S, S, same_segment) :-
    !.
not_cut(S1, S2, refused(S1, S2, By)) :-
    \+ may_cut(S1, S2),
    decided_by(may_cut/2, By),
    !.

%!  decided_by(+Decision, -By) is det.
%
%   By is `default`, or the rule file that decides, named from the current
%   folder if it is in it.

decided_by(Decision, By) :-
    decision(Decision, _, _, File),
    !,
    (   File == default
    ->  By = File
    ;   working_directory(Here, Here),
        relative_file_name(File, Here, By0),
        (   sub_atom(By0, 0, _, _, '../')
        ->  By = File
        ;   By = By0
        )
    ).

%!  pair_because(+Place1, +Place2, -Because) is det.
%
%   Why polygons Place1 = S1-P1 and Place2 = S2-P2, S1 =< S2, give a line or
%   none.

pair_because(S1-P1, S2-P2, [because(pair(S1,P1,S2,P2), Because)]) :-
    findall(L, line(L, S1, P1, _, _, S2, P2, _, _), Ls),
    (   Ls \== []
    ->  findall(because(of_line(L), Pieces),
                ( member(L, Ls), line_pieces(L, Pieces) ),
                Each),
        Why = [because(pair_lines(Ls), Each)]
    ;   \+ line(_, S1, _, _, _, S2, _, _, _),
        not_cut(S1, S2, Refused)
    ->  Why = [because(Refused, [])]
    ;   boxes_apart(S1-P1, S2-P2, Apart)
    ->  Why = [because(Apart, [])]
    ;   triangles_because(S1-P1, S2-P2, Reasons),
        elsewhere(S1-P1, S2-P2, Reasons, First),
        append(First, Reasons, Why)
    ),
    pair_sizes(S1, S2, Sizes),
    append(Why, Sizes, Because).

%   elsewhere(+Place1, +Place2, +Reasons, -First): what is said first of two
%   polygons without a line. A piece along an edge is a line of one of the
%   polygons there only, and a contact in a point one of two polygons there.

elsewhere(Place1, Place2, Reasons, First) :-
    (   member(because(triangles(Group,_), _), Reasons),
        memberchk(Group, [common_piece, coplanar_inside, point_alone]),
        findall(because(elsewhere(L,S1,P1,S2,P2), []),
                line_there(Place1, Place2, line(L,S1,P1,S2,P2)),
                First),
        First \== []
    ->  true
    ;   member(because(triangles(coplanar_inside,_), _), Reasons)
    ->  First = [because(no_line, []), because(inside_faces, [])]
    ;   First = [because(no_line, [])]
    ).

%   Polygons in one plane that have no line there are inside the faces that they
%   are parts of: only borders of these are lines.

%   line_there(+Place1, +Place2, -Line) is nondet: a line of the two segments
%   that lies where the two polygons meet.

line_there(S1-P1, S2-P2, line(L,S1,P3,S2,P4)) :-
    with_candidates(S1-P1, S2-P2, Candidates),
    place_box(S1-P1, Box1),
    place_box(S2-P2, Box2),
    line(L, S1, P3, A, B, S2, P4, _, _),
    \+ ( member(V, [A,B]),
         member(Box, [Box1,Box2]),
         \+ in_box(S1, V, Box) ),
    vertex_point(S1, A, Pa),
    vertex_point(S1, B, Pb),
    once(piece_on(straight, Candidates, Pa, Pb, _)).

place_box(Place, [X1-X2,Y1-Y2,Z1-Z2]) :-
    place_corners(Place, Points),
    range(1, Points, X1, X2),
    range(2, Points, Y1, Y2),
    range(3, Points, Z1, Z2).

in_box(S, V, Box) :-
    once(v(S, V, X, Y, Z)),
    maplist(in_range, [X,Y,Z], Box).

in_range(X, Low-High) :-
    X >= Low,
    X =< High.

/* - - - boxes - - - */

%   boxes_apart(+Place1, +Place2, -Statement) is semidet: the first axis along
%   which polygons S-P, or all polygons of S when P is unbound, are apart.

boxes_apart(Place1, Place2, boxes_apart(Axis, High, Low, Which)) :-
    place_corners(Place1, Points1),
    place_corners(Place2, Points2),
    nth1(I, [x,y,z], Axis),
    range(I, Points1, Low1, High1),
    range(I, Points2, Low2, High2),
    (   High1 < Low2
    ->  Which = first,
        High = High1,
        Low = Low2
    ;   High2 < Low1
    ->  Which = second,
        High = High2,
        Low = Low1
    ),
    !.

place_corners(S-P, Points) :-
    var(P),
    !,
    findall(p(X,Y,Z), v(S, _, X, Y, Z), Points),
    Points \== [].
place_corners(Place, Points) :-
    findall(p(X,Y,Z), place_fact(Place, v(_,_,X,Y,Z)), Points).

range(I, Points, Low, High) :-
    findall(X, ( member(Point, Points), arg(I, Point, X) ), Xs),
    min_list(Xs, Low),
    max_list(Xs, High).

/* - - - triangles - - - */

%   triangles_because(+Place1, +Place2, -Because): what each pair of leaf
%   triangles has in common, those with the same reason together.

triangles_because(Place1, Place2, Because) :-
    triangle_count(Place1, N1),
    triangle_count(Place2, N2),
    findall(Reason, candidate_reason(Place1, Place2, Reason), Reasons),
    length(Reasons, Near),
    Far is N1*N2 - Near,
    (   Far > 0
    ->  First = [because(triangles_apart(Far), [])]
    ;   First = []
    ),
    grouped(Reasons, Groups),
    append(First, Groups, Because).

triangle_count(Place, N) :-
    aggregate_all(count, place_fact(Place, t(_,_,_,_,_,_)), N).

%   The first of each group stands for it.

grouped(Reasons, Because) :-
    findall(Group, member(reason(Group,_,_,_), Reasons), Groups0),
    sort(Groups0, Groups),
    maplist(group_because(Reasons), Groups, Because).

group_because(Reasons, Group,
              because(triangles(Group,N), [because(example(T1,T2), Facts)])) :-
    aggregate_all(count, member(reason(Group,_,_,_), Reasons), N),
    memberchk(reason(Group,T1,T2,Facts), Reasons).

candidate_reason(S1-P1, S2-P2, reason(Group, T1, T2, Facts)) :-
    with_candidates(S1-P1, S2-P2, Candidates),
    member(candidate(T1, T2, Sides, Cuts), Candidates),
    triangle_reason(Sides, Cuts, T1, T2, Group, Facts).

%   with_candidates(+Place1, +Place2, -Candidates): candidate(T1, T2,
%   Side1-Side2, Cuts) of each pair of leaf triangles whose boxes overlap; T is
%   S-(A,B,C). The join runs in a world that has the two polygons only, as they
%   were before any cut.

with_candidates(Place1, Place2, Candidates) :-
    findall(Fact, ( member(Place, [Place1,Place2]),
                    place_fact(Place, Fact) ), Facts),
    in_passing_world(( maplist(assert_fact, Facts),
                       candidates(Place1, Place2, Candidates) )).

%   place_fact(+S-P, -Fact) is nondet: what polygon P of S is made of, in an
%   order in which it can be asserted.

place_fact(S-_, segment(S, Kind, Name)) :-
    segment(S, Kind, Name).
place_fact(S-P, v(S, V, X, Y, Z)) :-
    leaf_edges(S-P, Edges),
    findall(V, member(e(_,_,V,_,_), Edges), Vs0),
    sort(Vs0, Vs),
    member(V, Vs),
    v(S, V, X, Y, Z).
place_fact(Place, Edge) :-
    leaf_edges(Place, Edges),
    member(Edge, Edges).
place_fact(S-P, p(S, P, Es)) :-
    leaf_list(S, P, Es).
place_fact(S-P, t(S, P, T, A, B, C)) :-
    (   leaf_p(S, P, _)
    ->  leaf_t(S, P, T, A, B, C)
    ;   t(S, P, T, A, B, C)
    ).

%!  leaf_corners(+S, +P, -Triangle) is nondet.
%
%   Triangle = S-(A,B,C) is one of those that polygon P of S had before any cut.

leaf_corners(S, P, S-(A,B,C)) :-
    place_fact(S-P, t(_, _, _, A, B, C)).

leaf_list(S, P, Es) :-
    (   leaf_p(S, P, Es0)
    ->  Es = Es0
    ;   once(p(S, P, Es))
    ).

leaf_edges(S-P, Edges) :-
    leaf_list(S, P, Es),
    findall(e(S,E,V1,V2,Et),
            ( member(E, Es), once(leaf_edge(S, E, V1, V2, Et)) ),
            Edges).

leaf_edge(S, E, V1, V2, Et) :-
    leaf_e(S, E, V1, V2, Et).
leaf_edge(S, E, V1, V2, Et) :-
    e(S, E, V1, V2, Et).

candidates(S1-P1, S2-P2, Candidates) :-
    cut_set_open([S1-S2], Set), % long: no signals in a setup
    setup_call_cleanup(
        true,
        findall(Candidate, candidate(Set, S1-P1, S2-P2, Candidate),
                Candidates0),
        cut_set_close(Set)),
    sort(Candidates0, Candidates).

candidate(Set, S1-P1, S2-P2, candidate(T1, T2, Side1-Side2, Cuts)) :-
    cut_candidate(Set, I, J),
    cut_triangle(Set, I, S1, P1, Id1),
    cut_triangle(Set, J, S2, P2, Id2),
    cut_side(Set, I, J, Side1),
    cut_side(Set, J, I, Side2),
    corners(S1, Id1, T1),
    corners(S2, Id2, T2),
    (   Side1 =:= 0,
        Side2 =:= 0
    ->  cut_ends(Set, I, J, Cuts)
    ;   Cuts = []
    ).

corners(S, T, S-(A,B,C)) :-
    once(t(S, _, T, A, B, C)).

triangle_reason(Side-_, _, T1, T2, Group, Facts) :-
    Side =\= 0,
    !,
    Group = one_side(first),
    side_facts(T1, T2, Facts).
triangle_reason(_-Side, _, T1, T2, Group, Facts) :-
    Side =\= 0,
    !,
    Group = one_side(second),
    side_facts(T2, T1, Facts).
triangle_reason(_, [], T1, T2, Group, Facts) :-
    !,
    side_facts(T1, T2, Facts1),
    (   member(because(side(_,_,_,Side,_), []), Facts1),
        Side \== on
    ->  Group = intervals_apart,
        side_facts(T2, T1, Facts2),
        append(Facts1, Facts2, Facts)
    ;   Group = coplanar_apart,
        Facts = []
    ).
triangle_reason(_, Cuts, _, _, Group, Facts) :-
    Cuts = [cut(Kind, A, B)|_],
    (   Kind == crossing,
        A == B
    ->  Group = point_alone
    ;   Kind == crossing
    ->  Group = common_piece
    ;   Group = coplanar_inside
    ),
    findall(because(common(K, End1, End2), []),
            member(cut(K, End1, End2), Cuts), Facts).

side_facts(S-(A,B,C), T2, Facts) :-
    findall(because(side(S,V,point(X,Y,Z),Side,T2), []),
            ( member(V, [A,B,C]),
              vertex_side(S, V, T2, Side),
              v(S, V, X, Y, Z) ),
            Facts).

/* - - - the pieces of a line - - - */

%!  line_pieces(+L, -Because) is det.
%
%   The cuts of leaf triangles that line L was made of. None where these do not
%   meet as they are, because the polygons had to be made to touch first.

line_pieces(L, Because) :-
    line(L, S1, P1, A, B, S2, P2, _, _),
    with_candidates(S1-P1, S2-P2, Candidates),
    vertex_point(S1, A, Pa),
    vertex_point(S1, B, Pb),
    (   member(How, [straight,near]),
        findall(Piece, piece_on(How, Candidates, Pa, Pb, Piece), Pieces0),
        Pieces0 \== []
    ->  true
    ;   Pieces0 = []
    ),
    sort(Pieces0, Pieces),
    length(Pieces, N),
    (   N =:= 0
    ->  findall(because(made_to_touch, []),
                once(( member(S, [S1,S2]), origin(S, v(_), near(_)) )),
                Because)
    ;   findall(because(piece(I,T1,T2), []),
                nth1(I, Pieces, _-piece(T1,T2)), Each),
        (   A == B
        ->  Because = [because(touching(N), Each)]
        ;   decided_by(merge_line/2, By),
            Because = [because(pieces(N, By), Each)]
        )
    ).

vertex_point(S, V, p(X,Y,Z)) :-
    once(vertex_exact(S, V, X, Y, Z)).

%   piece_on(+How, +Candidates, +A, +B, -Piece) is nondet: Piece is
%   From-piece(T1, T2), a cut that covers a part of A-B from From (0 at A, 1 at
%   B) on: `straight` on its line exactly, or `near` it, as in polygons that
%   are flat only within the tolerance.

piece_on(How, Candidates, A, B, From-piece(T1,T2)) :-
    member(candidate(T1, T2, _, Cuts), Candidates),
    member(cut(Kind, End1, End2), Cuts),
    (   How == near
    ->  Kind == crossing
    ;   true
    ),
    end_point(T1-T2, End1, C),
    end_point(T1-T2, End2, D),
    along(How, A, B, C, T3),
    along(How, A, B, D, T4),
    From is min(T3, T4),
    From < 1,
    max(T3, T4) > 0.

%   along(+How, +A, +B, +Point, -T) is semidet: Point is at T on the line A-B; a
%   line that is a point has it in its middle.

along(_, A, A, Point, T) :-
    !,
    Point == A,
    T = 1r2.
along(How, p(X0,Y0,Z0), p(X1,Y1,Z1), p(X,Y,Z), T) :-
    Dx is X1-X0, Dy is Y1-Y0, Dz is Z1-Z0,
    Ux is X-X0, Uy is Y-Y0, Uz is Z-Z0,
    (   How == near
    ->  true
    ;   Dx*Uy =:= Dy*Ux,
        Dy*Uz =:= Dz*Uy,
        Dz*Ux =:= Dx*Uz
    ),
    T is (Dx*Ux + Dy*Uy + Dz*Uz) rdiv (Dx*Dx + Dy*Dy + Dz*Dz).

%   end_point(+Triangles, +End, -Point): where two features meet, exactly.

end_point((S1-_)-_, vertex(V)-_, Point) :-
    !,
    vertex_point(S1, V, Point).
end_point(_-(S2-_), _-vertex(V), Point) :-
    !,
    vertex_point(S2, V, Point).
end_point((S1-_)-T2, edge(A,B)-face(_), p(X,Y,Z)) :-
    !,
    origin_exact(lpi(S1-(A,B), T2), X, Y, Z).
end_point(T1-(S2-_), face(_)-edge(A,B), p(X,Y,Z)) :-
    !,
    origin_exact(lpi(S2-(A,B), T1), X, Y, Z).
end_point((S1-_)-(S2-_), edge(A,B)-edge(C,D), p(X,Y,Z)) :-
    origin_exact(ll(S1-(A,B), S2-(C,D)), X, Y, Z).
