:- module(sg_euler,
          [ euler/3                     % +S, ?Operation, -Change
          ]).
:- use_module(cells_edit,
              [ cells_edited/3, edge_there/3, edge_divided/4, polygon_there/3,
                polygon_gone/2, wires_gone/3, place_of/3 ]).
:- use_module(cycle, [radial_cycle/4]).
:- use_module('../near', [tolerance/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, edge_polygon/3, from_p/5, lies_in/3,
                assert_fact/1, retractall_facts/1, fresh_id/3 ]).
:- use_module('../vector',
              [cross_product/3, difference/3, dot_product/3]).
:- use_module('../vocabulary', [facet_loops/2]).
:- use_module(library(error),
              [domain_error/2, must_be/2]).
:- use_module(library(lists), [append/3, last/2, member/2, selectchk/3]).
/** <module> Euler operators: make and kill, each one step of undo.

What each does to the numbers of vertices, edges, faces, loops, parts, regions,
shells and genus is known; it is counted each time, and if anything else comes
out nothing is changed.
*/

%!  euler(+S, ?Operation, -Change) is det.
%
%   Change the cells S by Operation, and by it alone; Change is as of
%   cells_edited/3. Operation is make(What) or kill(What), and either takes the
%   other back:
%
%     - vertex(V, p(X,Y,Z))
%       a vertex V that nothing has
%     - spur(E, V, W, p(X,Y,Z))
%       a wire E from vertex V to a new vertex W
%     - wire(E, V, W)
%       a wire E between two vertices
%     - split(A, B, V, p(X,Y,Z))
%       a vertex V in the edge between A and B
%     - face(P, Loops)
%       a flat polygon P whose Loops, lists of vertices, have their edges;
%       killed, those that it alone had are wires
%     - chord(P, V, W, Q)
%       an edge from V to W, which are vertices of P, of one loop: Q is what is
%       to the right of it
%
%   V, W, E, P and Q of what is made are found.
%
%   @error domain_error(euler_operation, Operation): it is none, or what it
%          names is not so; geometry_error(glue_law(S, Faults));
%          geometry_error(part_glue(euler_change(S, Operation, Change))): it
%          was counted, and is not that of the operation

euler(S, Operation, Change) :-
    must_be(nonvar, Operation),
    cells_edited(S, sg_euler:done(S, Operation), Change0),
    (   row(Operation, Change0)
    ->  Change = Change0
    ;   Fault = euler_change(S, Operation, Change0),
        throw(error(geometry_error(part_glue(Fault)), _))
    ).

done(S, Operation) :-
    (   operate(Operation, S)
    ->  true
    ;   domain_error(euler_operation, Operation)
    ).

%   row(Operation, Change) is nondet: of what V, E, F, L, C, R, S, G there is
%   more.

row(make(What), Change) :-
    made(What, Change).
row(kill(What), change(V,E,F,L,C,R,S,G)) :-
    made(What, change(V1,E1,F1,L1,C1,R1,S1,G1)),
    V is -V1,
    E is -E1,
    F is -F1,
    L is -L1,
    C is -C1,
    R is -R1,
    S is -S1,
    G is -G1.

made(vertex(_,_),    change(1,0,0,0,1,0,1,0)).
made(spur(_,_,_,_),  change(1,1,0,0,0,0,0,0)).
made(split(_,_,_,_), change(1,1,0,0,0,0,0,0)).
made(wire(_,_,_),    change(0,1,0,0,-1,0,-1,0)).    % between two parts
made(wire(_,_,_),    change(0,1,0,0,0,0,0,1)).      % within one
made(face(_,Loops),  Change) :-
    length(Loops, L),
    face_made(L, Change).
made(chord(_,_,_,_), change(0,1,1,1,0,0,0,0)).

%   face_made(L, Change) is nondet: of L loops some join parts; the rest close
%   handles, or the face closes a region.

face_made(L, change(0,0,1,L,C,R,S,G)) :-
    between(0, L, Joined),
    C is -Joined,
    member(R, [0,1]),
    S is C+R,
    G is S-2+L.

%   operate(Operation, S) is semidet.

operate(make(vertex(V,Point)), S) :-
    vertex_made(S, Point, V).
operate(kill(vertex(V,Point)), S) :-
    alone(S, V),
    vertex_gone(S, V, Point).
operate(make(spur(E,V,W,Point)), S) :-
    once(v(S, V, _, _, _)),
    vertex_made(S, Point, W),
    wire_made(S, V, W, E).
operate(kill(spur(E,V,W,Point)), S) :-
    wire(S, E, V, W),
    \+ ( ( e(S, E1, W, _, _) ; e(S, E1, _, W, _) ), E1 \== E ),
    wires_gone(S, V, W),
    vertex_gone(S, W, Point).
operate(make(wire(E,V,W)), S) :-
    once(v(S, V, _, _, _)),
    once(v(S, W, _, _, _)),
    V \== W,
    \+ edge_there(S, V, W),
    wire_made(S, V, W, E).
operate(kill(wire(E,V,W)), S) :-
    wire(S, E, V, W),
    wires_gone(S, V, W).
operate(make(split(A,B,V,Point)), S) :-
    edge_there(S, A, B),
    vertex_made(S, Point, V),
    edge_divided(S, A, B, V).
operate(kill(split(A,B,V,Point)), S) :-
    findall(W, ( ( e(S, _, V, W, _) ; e(S, _, W, V, _) ) ), Ws0),
    sort(Ws0, Ws),
    msort([A,B], Ws),
    in_line(S, A, V, B),
    \+ lies_in(S, v(V), p(_)),
    edges_joined(S, A, V, B),
    vertex_gone(S, V, Point).
operate(make(face(P,Loops)), S) :-
    forall(( member(Loop, Loops), loop_side(Loop, A, B) ),
           edge_there(S, A, B)),
    polygon_there(S, Loops, P).
operate(kill(face(P,Loops)), S) :-
    facet_loops(S-P, Loops),
    polygon_gone(S, P),
    forall(( member(Loop, Loops), loop_side(Loop, A, B),
             \+ edge_there(S, A, B) ),
           wire_made(S, A, B, _)).
operate(make(chord(P,V,W,Q)), S) :-
    facet_loops(S-P, [Loop]),
    V \== W,
    \+ edge_there(S, V, W),
    turned_to(V, Loop, [V|Rest]),
    append(Left, [W|Right], Rest),
    sources(S, P, From),
    polygon_gone(S, P),
    append([V|Left], [W], Loop1),
    append([W|Right], [V], Loop2),
    polygon_there(S, [Loop2], P),
    polygon_there(S, [Loop1], Q),
    sources_again(S, [P,Q], From).
operate(kill(chord(P,V,W,Q)), S) :-
    facet_loops(S-P, [Loop2]),
    facet_loops(S-Q, [Loop1]),
    A is min(V, W),
    B is max(V, W),
    once(radial_cycle(S, A, B, [_,_])),
    turned_to(W, Loop2, [W|Rest2]),
    append(Right, [V], Rest2),
    turned_to(V, Loop1, [V|Rest1]),
    append(Left, [W], Rest1),
    sources(S, P, From),
    polygon_gone(S, P),
    polygon_gone(S, Q),
    append([V|Left], [W|Right], Loop),
    polygon_there(S, [Loop], P),
    sources_again(S, [P], From).

vertex_made(S, p(X0,Y0,Z0), V) :-
    X is float(X0)+0.0,
    Y is float(Y0)+0.0,
    Z is float(Z0)+0.0,
    \+ v(S, _, X, Y, Z),
    fresh_id(v, S, V),
    assert_fact(v(S, V, X, Y, Z)).

vertex_gone(S, V, p(X,Y,Z)) :-
    once(v(S, V, X0, Y0, Z0)),
    (   var(X)
    ->  p(X,Y,Z) = p(X0,Y0,Z0)
    ;   X =:= X0,
        Y =:= Y0,
        Z =:= Z0
    ),
    retractall_facts(lies_in(S, v(V), _)),
    retractall_facts(origin(S, v(V), _)),
    retractall_facts(from_v(S, V, _, _)),
    retractall_facts(v(S, V, _, _, _)).

alone(S, V) :-
    \+ e(S, _, V, _, _),
    \+ e(S, _, _, V, _),
    \+ lies_in(S, v(V), p(_)).

wire_made(S, V, W, E) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, V, W, 1)).

wire(S, E, V, W) :-
    e(S, E, V, W, _),
    \+ edge_polygon(S, E, _),
    !.

sources(S, P, From) :-
    findall(S0-P0-Sense, from_p(S, P, S0, P0, Sense), From).

sources_again(S, Ps, From) :-
    forall(( member(P, Ps), member(S0-P0-Sense, From) ),
           assert_fact(from_p(S, P, S0, P0, Sense))).

%   edges_joined(S, A, V, B): what goes from A by V to B goes on without V.

edges_joined(S, A, V, B) :-
    forall(( member(From-To, [A-B,B-A]), e(S, E, From, V, _) ),
           half_edges_joined(S, E, From, V, To)).

half_edges_joined(S, E, From, V, To) :-
    (   edge_polygon(S, E, P)
    ->  p(S, P, Es),
        member(E1, Es),
        e(S, E1, V, To, Real),
        selectchk(E1, Es, Es1),
        retractall_facts(p(S, P, _)),
        assert_fact(p(S, P, Es1)),
        retractall_facts(t(S, P, _, _, _, _)),
        retractall_facts(plane(S, P, _, _, _, _))
    ;   ( e(S, E1, V, To, Real) ; e(S, E1, To, V, Real) ),
        \+ edge_polygon(S, E1, _)
    ),
    !,
    retractall_facts(lies_in(S, e(E1), _)),
    retractall_facts(e(S, E1, _, _, _)),
    retractall_facts(e(S, E, _, _, _)),
    assert_fact(e(S, E, From, To, Real)).

loop_side(Loop, A, B) :-
    last(Loop, Last),
    append(_, [A,B|_], [Last|Loop]).

turned_to(V, Loop, Turned) :-
    append(Before, [V|After], Loop),
    !,
    append([V|After], Before, Turned).

in_line(S, A, V, B) :-
    place_of(S, A, PA),
    place_of(S, V, PV),
    place_of(S, B, PB),
    difference(PA, PV, U),
    difference(PB, PV, W),
    cross_product(U, W, N),
    dot_product(N, N, Square),
    dot_product(U, U, UU),
    dot_product(W, W, WW),
    dot_product(U, W, Along),
    Along < 0,
    tolerance(rounding, Near),
    sqrt(float(Square)) =< Near*sqrt(float(UU*WW)).
