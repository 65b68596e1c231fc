:- module(sg_chain,
          [ chains/1,                   % -Chains
            chain/5,                    % ?C, ?S1, ?S2, ?Kind, ?Lines
            chain_vertices/3,           % +Lines, +S, -Vs
            chain_points/2,             % +Lines, -Points
            chain_length/2              % +Lines, -Length
          ]).
:- use_module('../kernel', [line_chains/1]).
:- use_module('../store', [v/5, line/9]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), [nth1/3]).

/** <module> Chains: the pieces of penetration lines in order.

The pieces line/9 of two segments form a graph on their points, each a vertex
of either segment (of two vertices in one place too). A *chain* is
a run of pieces through vertices that have exactly two: from end to end where
there are ends (a vertex with one piece, or a branch point with three or
more), or round, back to where it began: then it is closed. It is a list of
line numbers, with a minus sign where a line is walked from its end to its
start. A contact in a point alone, a piece whose start is its end, is a chain of
its own: one point.

Two closed solids in general position have closed chains only. The order is
settled by line numbers alone: chains with ends first, each from the smaller
line at one, then the others from their smallest line, in its direction.

@see [PL] section 5.2, rows PL-8 and PL-9
*/

%!  chains(-Chains:list) is det.
%
%   Chains is a list of chain(S1, S2, Kind, Lines), by S1 and S2, then in the
%   order above; Kind is `open`, `closed` or `point`. Through the fused kernel,
%   in linear time except for sorting.

chains(Chains) :-
    line_chains(Chains).

%!  chain(?C, ?S1, ?S2, ?Kind, ?Lines) is nondet.
%
%   True when chain number C, counted from 1, of segments S1 and S2 is Kind
%   and consists of Lines. Makes all chains: ask once, not in a loop.

chain(C, S1, S2, Kind, Lines) :-
    chains(Chains),
    nth1(C, Chains, chain(S1, S2, Kind, Lines)).

%!  chain_vertices(+Lines, +S, -Vs) is semidet.
%
%   Vs are the vertices of segment S along the chain; of a closed one the last
%   is the first again, of a point there is one. Fails when S is not one of the
%   chain's two segments.

chain_vertices([Step|Steps], S, [V|Vs]) :-
    step_vertices(Step, S, V, V1),
    (   Steps == [],
        is_point(Step)
    ->  Vs = []
    ;   chain_vertices_(Steps, S, V1, Vs)
    ).

is_point(Step) :-
    L is abs(Step),
    line(L, _, _, A1, A1, _, _, A2, A2).

chain_vertices_([], _, V, [V]).
chain_vertices_([Step|Steps], S, V, [V|Vs]) :-
    step_vertices(Step, S, V, V1),
    chain_vertices_(Steps, S, V1, Vs).

step_vertices(Step, S, From, To) :-
    L is abs(Step),
    line(L, S1, _, A1, B1, S2, _, A2, B2),
    (   S == S1
    ->  A = A1, B = B1
    ;   S == S2
    ->  A = A2, B = B2
    ),
    (   Step > 0
    ->  From = A, To = B
    ;   From = B, To = A
    ).

%!  chain_points(+Lines, -Points) is det.
%
%   Points are the point(X,Y,Z) along the chain, as its first segment has
%   them.
%
%   @error type_error(list(integer), Lines): the number of a chain is none;
%   Lines are the last argument of chain/5

chain_points(Lines, Points) :-
    lines_numbered(Lines, chain_points),
    points_along(Lines, Points).

points_along(Lines, Points) :-
    Lines = [Step|_],
    L is abs(Step),
    line(L, S, _, _, _, _, _, _, _),
    chain_vertices(Lines, S, Vs),
    maplist(vertex_point(S), Vs, Points).

%   lines_numbered(Lines, Name): Lines are numbers of lines; if not, Name/2 says
%   so.

lines_numbered(Lines, Name) :-
    catch(must_be(list(integer), Lines), error(Formal, _),
          throw(error(Formal, context(Name/2, _)))).

vertex_point(S, V, point(X,Y,Z)) :-
    v(S, V, X, Y, Z).

%!  chain_length(+Lines, -Length) is det.
%
%   Length is the true length of the chain in model units.
%
%   @error as chain_points/2

chain_length(Lines, Length) :-
    lines_numbered(Lines, chain_length),
    points_along(Lines, [Point|Points]),
    foldl(longer, Points, Point-0.0, _-Length).

longer(Point, Last-Length0, Point-Length) :-
    point_distance(Last, Point, Distance),
    Length is Length0+Distance.

point_distance(point(X1,Y1,Z1), point(X2,Y2,Z2), D) :-
    D is sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2).
