:- module(sg_operand,
          [ operand_faults/2,           % +S, -Faults
            checked_operand/1,          % +S
            segment_thickness/2         % +S, -Thick
          ]).
:- use_module('../kernel',
              [ census/1, segment_edges/4, segment_operand/2
              ]).
:- use_module('../polygon/triangulation',
              [new_segments_complete/0, untriangulated/1]).
:- use_module('../stage', [stage/2]).
:- use_module('../store', [t/6, v/5, segment/3, facts_snapshot/1]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(error), [existence_error/2]).
:- use_module(library(lists), [member/2]).
/** <module> What makes a segment unfit for a Boolean.

Inside is where a segment goes round a point more than no times at all
(inside.pl). For that number to mean something its boundary must be balanced:
between any two vertices as many faces on one side as on the other. Everything
else is decided by the number: shells in each other or through each other,
touching or lying on each other, hollows, edges of four faces. So these are no
faults.

@see row CB-4 of the requirements
*/

%   How many wrong edges are named.

most_named(5).

%!  operand_faults(+S, -Faults:list) is det.
%
%   Faults are the reasons for which segment S cannot be an operand, [] if it
%   can:
%
%     - no_faces
%     - open_edges(N, Edges)
%       N edges have a face on one side only.
%     - unbalanced_edges(N, Edges)
%       N edges have more faces, and not as many on one side as on the other.
%     - zero_volume
%       No volume that could be told from rounding, and no shell that has one.
%
%   Edges are the first few, edge(V1, V2, [X1,Y1,Z1], [X2,Y2,Z2], Faces). A
%   volume below zero is no fault. What S has is known afterwards, until it
%   changes.
%
%   @error existence_error(segment, S)

operand_faults(S, Faults) :-
    (   segment(S, _, _)
    ->  true
    ;   existence_error(segment, S)
    ),
    stage(operands,
          (   untriangulated(S)
          ->  facts_snapshot(( new_segments_complete, faults_of(S, Faults) ))
          ;   faults_of(S, Faults)
          )).

faults_of(S, Faults) :-
    segment_operand(S, Operand),
    findall(Fault, operand_fault(S, Operand, Fault), Faults).

operand_fault(_, operand(0, _, _, _, _, _), no_faces) :-
    !.
operand_fault(S, operand(_, _, false, _, _, _), Fault) :-
    most_named(Most),
    segment_edges(S, Most, edges(Open, Unbalanced, _), Edges0),
    findall(F-Edge, ( member(E, Edges0), named_edge(S, E, F, Edge) ), Edges),
    edge_fault(Open, Unbalanced, Edges, Fault).
operand_fault(S, operand(_, _, true, Volume, Error, _), zero_volume) :-
    abs(Volume) =< Error,
    \+ has_volume(S, Error).

edge_fault(Open, _, Edges, open_edges(Open, Named)) :-
    Open > 0,
    findall(Edge, member(open-Edge, Edges), Named).
edge_fault(_, Unbalanced, Edges, unbalanced_edges(Unbalanced, Named)) :-
    Unbalanced > 0,
    findall(Edge, member(unbalanced-Edge, Edges), Named).

named_edge(S, edge(V1, V2, Forward, Backward), Sort,
           edge(V1, V2, [X1,Y1,Z1], [X2,Y2,Z2], N)) :-
    N is Forward+Backward,
    (   N =:= 1
    ->  Sort = open
    ;   Sort = unbalanced
    ),
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    !.

%   Shells whose volumes cancel each other.

has_volume(S, Error) :-
    census(Parts),
    memberchk(part(S, _, _, _, _, _, Shells, _), Parts),
    member(Shell, Shells),
    arg(9, Shell, Volume),
    abs(Volume) > Error,
    !.

%!  checked_operand(+S) is det.
%
%   Segment S can be an operand. A warning is printed if it is inside out.
%
%   @error geometry_error(operand(S, Faults)): as operand_faults/2 says

checked_operand(S) :-
    operand_faults(S, Faults),
    (   Faults \== []
    ->  throw(error(geometry_error(operand(S, Faults)), _))
    ;   segment_operand(S, operand(_, _, _, Volume, Error, _)),
        Volume < -Error
    ->  print_message(warning, sanggwan(operand(inside_out, S)))
    ;   true
    ).

%!  segment_thickness(+S, -Thick) is semidet.
%
%   The closed segment S is about Thick thick: twice its volume by its area.

segment_thickness(S, Thick) :-
    segment_operand(S, operand(_, _, true, Volume, _, _)),
    aggregate_all(sum(A), triangle_area(S, A), Area),
    Area > 0,
    Thick is 2*abs(Volume)/Area.

triangle_area(S, Area) :-
    t(S, _, _, V1, V2, V3),
    maplist(place(S), [V1,V2,V3], [[X1,Y1,Z1],[X2,Y2,Z2],[X3,Y3,Z3]]),
    A1 is X2-X1, A2 is Y2-Y1, A3 is Z2-Z1,
    B1 is X3-X1, B2 is Y3-Y1, B3 is Z3-Z1,
    Area is sqrt((A2*B3-A3*B2)**2+(A3*B1-A1*B3)**2+(A1*B2-A2*B1)**2)/2.

place(S, V, [X,Y,Z]) :-
    v(S, V, X, Y, Z).
