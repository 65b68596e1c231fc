:- module(sg_closing,
          [ closed_by_caps/1,           % +S
            border_loops/2              % +S, -Loops
          ]).
:- use_module('../kernel', [model_tolerance/1, segment_borders/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, assert_fact/1, retractall_facts/1,
                facts_transaction/1, fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../vector',
              [ difference/3, dot_product/3, doubled_area/2, scaled/3,
                vector_sum/3
              ]).
:- use_module(library(apply), [foldl/4, foldl/5, maplist/2]).
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
    segment_borders(S, Es),
    findall(V2-V1, ( member(E, Es), e(S, E, V1, V2, _) ), Steps),
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
    findall(p(X, Y, Z), ( member(V-_, Loop), v(S, V, X, Y, Z) ), Points),
    middle(Points, Middle),
    findall(Vector, ( member(P, Points), difference(P, Middle, Vector) ),
            Round),
    doubled_area(Round, Normal),
    dot_product(Normal, Normal, Square),
    Length is sqrt(Square),
    model_tolerance(Tolerance),
    (   Length > 0.0,
        \+ ( member(Vector, Round),
             dot_product(Vector, Normal, Height),
             abs(Height) > Tolerance*Length
           )
    ->  true
    ;   throw(error(geometry_error(trim(open(S, V2, V1))), _))
    ).

middle(Points, Middle) :-
    foldl(vector_sum, Points, p(0.0, 0.0, 0.0), Sum),
    length(Points, N),
    Share is 1.0/N,
    scaled(Share, Sum, Middle).
