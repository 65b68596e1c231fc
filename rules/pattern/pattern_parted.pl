:- module(sg_pattern_parted,
          [ parted_segments/2           % +Segments, -Partss
          ]).
:- use_module('../near', [points_left/2]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2, nth1/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Where lines lie on each other in part, they are parted.

The sides of a slit that has closed lie on each other, but need not be as long
as each other: a long edge may lie on two short ones. Parted at each other's
ends, what lies on each other is the same line, from the same point to the same
point, and can be drawn once.
*/

:- set_prolog_flag(optimise, true).

% How near lines are that lie on each other, and how long the shortest part is,
% in millimetres.
near(1.0e-5).
shortest(1.0e-3).

% The lattices in which such lines are found, of the angle of a line and of its
% distance from the origin: far coarser than what rounding does to them.
angle_step(1.0e-5).
distance_step(1.0e-2).

%!  parted_segments(+Segments, -Partss) is det.
%
%   Segments is a list of A-B, points X-Y in millimetres. For each of them there
%   is a list of A-B in Partss, one after the other from its start to its end:
%   it is parted where another one begins or ends that lies on a part of it.

parted_segments(Segments, Partss) :-
    findall(Key-Span,
            ( nth1(I, Segments, Segment), carried(Segment, I, Key, Span) ),
            Keyed0),
    keysort(Keyed0, Keyed),
    group_pairs_by_key(Keyed, Carriers),
    findall(I-cut(T,P),
            ( member(_-Spans, Carriers), meeting_cut(Spans, I, T, P) ),
            Cuts0),
    sort(Cuts0, Cuts),
    group_pairs_by_key(Cuts, Groups),
    list_to_assoc(Groups, ById),
    foldl(segment_parts(ById), Segments, 1-Partss, _-[]).

segment_parts(Cuts, A-B, I-[Parts|Partss], I1-Partss) :-
    I1 is I+1,
    (   get_assoc(I, Cuts, Own)
    ->  findall(P, member(cut(_,P), Own), Points),
        chain_parts(Points, A, B, Parts)
    ;   Parts = [A-B]
    ).

%   What nearly is the point before it, or the last, parts nothing.

chain_parts([], A, B, [A-B]).
chain_parts([P|Points], A, B, Parts) :-
    (   ( apart(A, P), apart(P, B) )
    ->  Parts = [A-P|Parts1],
        chain_parts(Points, P, B, Parts1)
    ;   chain_parts(Points, A, B, Parts)
    ).

apart(XA-YA, XB-YB) :-
    shortest(Least),
    max(abs(XB-XA), abs(YB-YA)) > Least.

%   carried(Segment, I, Key, Span) is nondet: Segment, the I-th, lies on a line
%   with Key; lines that are the same up to rounding share a Key, since in one
%   of two lattices that are half a step apart both are well inside of a square.
%   Span is span(From,To,I,Segment): where along the line it is.

carried(A-B, I, Key, span(From,To,I,A-B)) :-
    apart(A, B),
    A = XA-YA,
    B = XB-YB,
    DX is XB-XA,
    DY is YB-YA,
    way(DX, DY, U, V),
    Angle is atan2(V, U),
    Distance is U*YA - V*XA,
    angle_step(AngleStep),
    distance_step(DistanceStep),
    S is U*XA + V*YA,
    T is U*XB + V*YB,
    From is min(S, T),
    To is max(S, T),
    member(G, [0.0,0.5]),
    member(H, [0.0,0.5]),
    K is floor(Angle/AngleStep + G),
    L is floor(Distance/DistanceStep + H),
    Key = key(G, H, K, L).

%   The direction of a line, whichever way it is drawn.

way(X, Y, U, V) :-
    Length is sqrt(X*X+Y*Y),
    (   points_left(X, Y)
    ->  U is -X/Length,
        V is -Y/Length
    ;   U is X/Length,
        V is Y/Length
    ).

%   meeting_cut(Spans, I, T, P) is nondet: the end P of one of Spans is on the
%   I-th segment, T from its start. Only spans that overlap are compared.

meeting_cut(Spans0, I, T, P) :-
    Spans0 = [_,_|_],
    sort(1, @=<, Spans0, Spans),
    overlapping(Spans, Cluster),
    member(span(_,_,I,A-B), Cluster),
    member(span(_,_,J,C-D), Cluster),
    J =\= I,
    on_line(A, B, C),
    on_line(A, B, D),
    member(P, [C,D]),
    along(A, B, P, T).

%   overlapping(Spans, Cluster) is nondet: Cluster are two or more of Spans, in
%   their order, each of which begins before all those before it have ended.

overlapping([Span|Spans], Cluster) :-
    Span = span(_, To, _, _),
    reached(Spans, To, Rest, After),
    (   Rest = [_|_],
        Cluster = [Span|Rest]
    ;   overlapping(After, Cluster)
    ).

reached([Span|Spans], To0, [Span|Rest], After) :-
    Span = span(From, To1, _, _),
    shortest(Least),
    From < To0-Least,
    !,
    To is max(To0, To1),
    reached(Spans, To, Rest, After).
reached(After, _, [], After).

on_line(XA-YA, XB-YB, X-Y) :-
    near(Near),
    DX is XB-XA,
    DY is YB-YA,
    abs(DX*(Y-YA) - DY*(X-XA)) =< Near*sqrt(DX*DX+DY*DY).

%   T is how far along A to B the point is, if it is between them.

along(XA-YA, XB-YB, X-Y, T) :-
    DX is XB-XA,
    DY is YB-YA,
    Length is sqrt(DX*DX+DY*DY),
    T is (DX*(X-XA) + DY*(Y-YA))/Length,
    shortest(Least),
    T > Least,
    T < Length-Least.
