:- module(sg_cells_edit,
          [ cells_edited/3,             % +S, :Goal, -Change
            regions_again/2,            % +S, -Report
            edge_there/3,               % +S, +A, +B
            vertices_renamed/3,         % +S, +V, +W
            edge_divided/4,             % +S, +A, +B, +V
            polygon_there/3,            % +S, +Loops, ?P
            polygon_gone/2,             % +S, +P
            wires_gone/3,               % +S, +A, +B
            place_of/3                  % +S, +V, -Point
          ]).
:- use_module('../csg/csg', [node/4]).
:- use_module('../exact', [vertex_exact/5]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(regions, [regions_found/2, regions_report/2, law_fault/3]).
:- use_module('../store',
              [ v/5, e/5, p/3, t/6, edge_polygon/3, segment/3, origin/3,
                from_r/4, from_v/4, region/3, sides/4, lies_in/3, assert_fact/1,
                retractall_facts/1, facts_transaction/1, fresh_id/3
              ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(error), [type_error/2]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
/** <module> Edits of cells: rows, then regions and laws.

One edit is one transaction. After it regions are found again, and both laws
are counted; if one does not hold, everything is as it was. What operands a
region was inside stays with its sides. */

:- meta_predicate cells_edited(+, 0, -).

%!  cells_edited(+S, :Goal, -Change) is semidet.
%
%   Goal changes the rows of segment S, of kind `cells`, that no operands make.
%   Change is change(V, E, F, L, C, R, S, G): how many more vertices, edges,
%   faces, loops, parts, regions, shells and genus there are then.
%
%   @error type_error(cells, S); geometry_error(glue_law(S, Faults))

cells_edited(S, Goal, Change) :-
    (   segment(S, cells, _),
        \+ node(S, glue, _, _)
    ->  true
    ;   type_error(cells, S)
    ),
    facts_transaction(sg_cells_edit:edited(S, Goal, Change)).

edited(S, Goal, Change) :-
    complete_segments([S]),
    regions_report(S, Before),
    contents(S, Contents),
    call(Goal),
    regions_again(S, After),
    contents_again(S, Contents),
    maplist(more(Before.counts, After.counts),
            [vertices,edges,faces,loops,parts,regions,shells,genus], More),
    Change =.. [change|More].

more(Before, After, Key, More) :-
    More is After.Key - Before.Key.

%!  regions_again(+S, -Report) is det.
%
%   Find the regions of the cells S again, in an edit; Report is as of
%   regions_found/2.
%
%   @error geometry_error(glue_law(S, Faults))

regions_again(S, Report) :-
    retractall_facts(sides(S, _, _, _)),
    retractall_facts(from_r(S, _, _, _)),
    retractall_facts(region(S, _, _)),
    retractall_facts(lies_in(S, _, r(_))),
    complete_segments([S]),
    regions_found(S, Report),
    findall(Fault-N, law_fault(Report, Fault, N), Faults),
    (   Faults == []
    ->  true
    ;   throw(error(geometry_error(glue_law(S, Faults)), _))
    ).

%   contents(S, Contents): for each side, P-below or P-above, what its region
%   was inside, and whether it was a void.

contents(S, Contents) :-
    findall((P-Side)-in(Role,Inside),
            ( side(S, P, Side, R), region(S, R, Role),
              findall(S0-R0, from_r(S, R, S0, R0), Inside) ),
            Pairs),
    list_to_assoc(Pairs, Contents).

side(S, P, below, R) :-
    sides(S, P, R, _).
side(S, P, above, R) :-
    sides(S, P, _, R).

contents_again(S, Contents) :-
    forall(region(S, R, Role),
           (   once(( side(S, P, Side, R),
                      get_assoc(P-Side, Contents, in(Role0,Inside)) ))
           ->  forall(member(S0-R0, Inside), assert_fact(from_r(S, R, S0, R0))),
               void_again(S, R, Role0, Role)
           ;   true
           )).

void_again(S, R, void, cell) :-
    !,
    retractall_facts(region(S, R, _)),
    assert_fact(region(S, R, void)).
void_again(_, _, _, _).

%!  edge_there(+S, +A, +B) is semidet.
%
%   True when there is an edge between the vertices A and B.

edge_there(S, A, B) :-
    (   e(S, _, A, B, _)
    ;   e(S, _, B, A, _)
    ),
    !.

%!  place_of(+S, +V, -Point) is det.
%
%   Point, p(X,Y,Z) of rationals, is where vertex V is.

place_of(S, V, p(X,Y,Z)) :-
    once(vertex_exact(S, V, X, Y, Z)).

%!  vertices_renamed(+S, +V, +W) is det.
%
%   Wherever vertex V was there is vertex W. Of two wires between the same
%   vertices one stays.

vertices_renamed(S, V, W) :-
    findall(E-(A-B-Real),
            ( ( e(S, E, V, B, Real), A = V ; e(S, E, A, V, Real), B = V ) ),
            Es),
    forall(member(E-(A0-B0-Real), Es),
           ( renamed(V, W, A0, A),
             renamed(V, W, B0, B),
             retractall_facts(e(S, E, _, _, _)),
             assert_fact(e(S, E, A, B, Real)) )),
    findall(P-T-t(A,B,C),
            ( t(S, P, T, A, B, C), memberchk(V, [A,B,C]) ), Ts),
    forall(member(P-T-t(A0,B0,C0), Ts),
           ( maplist(renamed(V, W), [A0,B0,C0], [A,B,C]),
             retractall_facts(t(S, P, T, _, _, _)),
             assert_fact(t(S, P, T, A, B, C)) )),
    findall(In, lies_in(S, v(V), In), Ins),
    retractall_facts(lies_in(S, v(V), _)),
    forall(member(p(P), Ins), assert_fact(lies_in(S, v(W), p(P)))),
    findall(S0-V0, from_v(S, V, S0, V0), Sources),
    retractall_facts(from_v(S, V, _, _)),
    forall(( member(S0-V0, Sources), \+ from_v(S, W, _, _) ),
           assert_fact(from_v(S, W, S0, V0))),
    retractall_facts(origin(S, v(V), _)),
    retractall_facts(v(S, V, _, _, _)),
    forall(member(E-_, Es), one_wire(S, E)).

renamed(V, W, V, W) :-
    !.
renamed(_, _, A, A).

one_wire(S, E) :-
    e(S, E, A, B, _),
    (   \+ edge_polygon(S, E, _),
        ( e(S, E1, A, B, _) ; e(S, E1, B, A, _) ),
        E1 \== E
    ->  retractall_facts(lies_in(S, e(E), _)),
        retractall_facts(e(S, E, _, _, _))
    ;   true
    ).

%!  edge_divided(+S, +A, +B, +V) is det.
%
%   The edge between the vertices A and B goes through vertex V: that of each
%   polygon, and of a wire.

edge_divided(S, A, B, V) :-
    findall(E-(From-To-Real),
            ( member(From-To, [A-B,B-A]), e(S, E, From, To, Real) ),
            Es),
    forall(member(E-(From-To-Real), Es),
           half_edge_divided(S, E, From, To, Real, V)).

half_edge_divided(S, E, From, To, Real, V) :-
    fresh_id(e, S, E1),
    findall(P-List, ( edge_polygon(S, E, P), p(S, P, List) ), Ps),
    retractall_facts(e(S, E, _, _, _)),
    assert_fact(e(S, E, From, V, Real)),
    assert_fact(e(S, E1, V, To, Real)),
    forall(( member(P-List0, Ps), append(Before, [E|After], List0) ),
           ( append(Before, [E,E1|After], List),
             retractall_facts(p(S, P, _)),
             assert_fact(p(S, P, List)),
             triangles_gone(S, P) )).

triangles_gone(S, P) :-
    retractall_facts(t(S, P, _, _, _, _)),
    retractall_facts(plane(S, P, _, _, _, _)).

%!  polygon_there(+S, +Loops, ?P) is det.
%
%   A new polygon P has the Loops, lists of vertices. Wires along them are edges
%   of it now.

polygon_there(S, Loops, P) :-
    (   var(P)
    ->  fresh_id(p, S, P)
    ;   true
    ),
    maplist(loop_there(S), Loops, Lists),
    append(Lists, Es),
    assert_fact(p(S, P, Es)).

loop_there(S, [First|Vs], Es) :-
    append([First|Vs], [First], Path),
    findall(A-B, append(_, [A,B|_], Path), Sides),
    maplist(half_edge_there(S), Sides, Es).

half_edge_there(S, A-B, E) :-
    wires_gone(S, A, B),
    fresh_id(e, S, E),
    assert_fact(e(S, E, A, B, 1)).

%!  wires_gone(+S, +A, +B) is det.
%
%   There is no wire between the vertices A and B.

wires_gone(S, A, B) :-
    findall(E, ( ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
                 \+ edge_polygon(S, E, _) ), Es),
    forall(member(E, Es),
           ( retractall_facts(lies_in(S, e(E), _)),
             retractall_facts(e(S, E, _, _, _)) )).

%!  polygon_gone(+S, +P) is det.
%
%   Polygon P and its edges are there no more.

polygon_gone(S, P) :-
    p(S, P, Es),
    !,
    triangles_gone(S, P),
    retractall_facts(sides(S, P, _, _)),
    retractall_facts(lies_in(S, _, p(P))),
    retractall_facts(from_p(S, P, _, _, _)),
    retractall_facts(p(S, P, _)),
    forall(member(E, Es), retractall_facts(e(S, E, _, _, _))).
