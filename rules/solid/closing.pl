:- module(sg_closing,
          [ closed_by_caps/1,           % +S
            border_loops/2              % +S, -Loops
          ]).
:- use_module('../kernel', [census_defect/4, model_tolerance/1]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, assert_fact/1, retractall_facts/1,
                facts_transaction/1, fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(apply),
              [foldl/4, foldl/5, foldl/6, maplist/2, maplist/3]).
:- use_module(library(lists), [member/2, selectchk/3]).
/** <module> Open surfaces closed by flat faces: a pipe gets its ends.

For the time of a question, in a snapshot: what is inside a surface can only be
said of one that is closed.
*/

%!  closed_by_caps(+S) is det.
%
%   Every border of segment S becomes the border of a polygon that closes it,
%   and S a solid; a solid stays as it is. The polygons come after those that S
%   has. One transaction.
%
%   @error geometry_error(trim(open(S, V1, V2))): the border that runs from
%          vertex V1 to V2 is not flat within the tolerance, or it does not
%          close

closed_by_caps(S) :-
    (   segment(S, surface, Name)
    ->  facts_transaction(sg_closing:closed(S, Name))
    ;   true
    ).

closed(S, Name) :-
    border_loops(S, Loops),
    maplist(flat_loop(S), Loops),
    forall(member(Loop, Loops), cap_added(S, Loop)),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, solid, Name)),
    (   Loops == []
    ->  true
    ;   complete_segments([S])
    ).

cap_added(S, Loop) :-
    fresh_id(e, S, E0),
    foldl(cap_edge(S), Loop, Es, E0, _),
    fresh_id(p, S, P),
    assert_fact(p(S, P, Es)).

cap_edge(S, V1-V2, E, E, E1) :-
    assert_fact(e(S, E, V1, V2, 1)),
    E1 is E+1.

%!  border_loops(+S, -Loops:list) is det.
%
%   Loops are the borders of segment S, each a list of V1-V2, end to end, that
%   run against the edges that have no partner. In the order of these.
%
%   @error geometry_error(trim(open(S, V1, V2))): a border that does not close

border_loops(S, Loops) :-
    findall(E-(V2-V1),
            ( census_defect(border_edge, S, E, _), e(S, E, V1, V2, _) ),
            Pairs0),
    sort(Pairs0, Pairs),
    findall(Step, member(_-Step, Pairs), Steps),
    loops(Steps, S, Loops).

loops([], _, []).
loops([V1-V2|Steps0], S, [[V1-V2|Loop]|Loops]) :-
    (   loop(V2, V1, Steps0, Steps, Loop)
    ->  loops(Steps, S, Loops)
    ;   throw(error(geometry_error(trim(open(S, V2, V1))), _))
    ).

loop(V, V, Steps, Steps, []) :-
    !.
loop(V, First, Steps0, Steps, [V-Next|Loop]) :-
    selectchk(V-Next, Steps0, Steps1),
    loop(Next, First, Steps1, Steps, Loop).

%   flat_loop(S, Loop): its vertices are within the tolerance of a plane, that
%   of its vector area through its middle.

flat_loop(S, Loop) :-
    Loop = [V1-V2|_],
    findall(at(X, Y, Z), ( member(V-_, Loop), v(S, V, X, Y, Z) ), Points),
    middle(Points, at(X0, Y0, Z0)),
    maplist(shifted(X0, Y0, Z0), Points, Round),
    vector_area(Round, Nx, Ny, Nz),
    Length is sqrt(Nx*Nx + Ny*Ny + Nz*Nz),
    model_tolerance(Tolerance),
    (   Length > 0.0,
        \+ ( member(at(X, Y, Z), Round),
             abs(X*Nx + Y*Ny + Z*Nz) > Tolerance*Length
           )
    ->  true
    ;   throw(error(geometry_error(trim(open(S, V2, V1))), _))
    ).

middle(Points, at(X, Y, Z)) :-
    foldl(added, Points, sum(0.0, 0.0, 0.0, 0), sum(Xs, Ys, Zs, N)),
    X is Xs/N,
    Y is Ys/N,
    Z is Zs/N.

added(at(X, Y, Z), sum(X0, Y0, Z0, N0), sum(X1, Y1, Z1, N)) :-
    X1 is X0+X,
    Y1 is Y0+Y,
    Z1 is Z0+Z,
    N is N0+1.

shifted(X0, Y0, Z0, at(X, Y, Z), at(X1, Y1, Z1)) :-
    X1 is X-X0,
    Y1 is Y-Y0,
    Z1 is Z-Z0.

vector_area(Points, X, Y, Z) :-
    Points = [First|_],
    turned(Points, First, 0.0-0.0-0.0, X-Y-Z).

turned([at(X1, Y1, Z1)|Points], First, X0-Y0-Z0, Area) :-
    (   Points = [Next|_]
    ->  true
    ;   Next = First
    ),
    Next = at(X2, Y2, Z2),
    X is X0 + Y1*Z2 - Z1*Y2,
    Y is Y0 + Z1*X2 - X1*Z2,
    Z is Z0 + X1*Y2 - Y1*X2,
    (   Points == []
    ->  Area = X-Y-Z
    ;   turned(Points, First, X-Y-Z, Area)
    ).
