:- module(sg_line_segment,
          [ line_segment/3,             % +S1, +S2, -S
            lines_given/1               % +Segments
          ]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module('../store',
              [ drawn/7, e/5, line/9, assert_fact/1, retractall_facts/1 ]).
:- use_module(library(lists), [member/2, memberchk/2]).
/** <module> Whose line a penetration line is in a picture.

A penetration line is an edge of both of its segments, and is drawn once. Which
of the two it is drawn as decides how it looks, where segments have styles of
their own, and in which group, layer or segment of a file it is.

@see row PL-13
*/

:- decision(line_segment/3,
            "Which of its two segments a penetration line is drawn as").

%!  line_segment(+S1, +S2, -S) is semidet.
%
%   The penetration lines of the segments S1 and S2, S1 < S2, are drawn as edges
%   of S, one of the two: S1. A decision.

line_segment(S1, _, S1).

%!  lines_given(+Segments) is det.
%
%   Each penetration line in drawn/7 becomes an edge of the segment that
%   line_segment/3 says, if that is in the picture: Segments is a list or `all`.
%   Nothing is done as long as the decision is the default one.

lines_given(_) :-
    decision_is_default(line_segment/3),
    !.
lines_given(Segments) :-
    findall(Row-Other,
            ( Row = drawn(_,_,_,_,_,_,penetration),
              call(Row),
              other_drawn(Segments, Row, Other) ),
            Changes),
    forall(member(Row-Other, Changes),
           ( retractall_facts(Row),
             assert_fact(Other) )).

%   other_drawn(Segments, Row, Other): Row of drawn/7 is to be Other, as an edge
%   of the other segment of its line.

other_drawn(Segments, drawn(N,S,E,From0,To0,Visibility,Role),
            drawn(N,S2,E2,From,To,Visibility,Role)) :-
    e(S, E, A, B, _),
    once(line_copy(S, A, B, S2, A2, B2)),
    S1 is min(S, S2),
    S3 is max(S, S2),
    line_segment(S1, S3, Wanted),
    Wanted == S2,
    (   Segments == all
    ->  true
    ;   memberchk(S2, Segments)
    ),
    (   e(S2, E2, A2, B2, _)
    ->  From = From0,
        To = To0
    ;   e(S2, E2, B2, A2, _),
        From is 1.0-To0,
        To is 1.0-From0
    ),
    !.

%   line_copy(S, A, B, S2, A2, B2): the edge from A to B of S is that from A2 to
%   B2 of S2.

line_copy(S, A, B, S2, A2, B2) :-
    (   line(_, S, _, A, B, S2, _, A2, B2)
    ;   line(_, S, _, B, A, S2, _, B2, A2)
    ;   line(_, S2, _, A2, B2, S, _, A, B)
    ;   line(_, S2, _, B2, A2, S, _, B, A)
    ),
    S2 =\= S.
