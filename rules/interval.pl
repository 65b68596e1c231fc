:- module(sg_interval,
          [ intervals_union/3,          % +Least, +Intervals, -Union
            intervals_gaps/2,           % +Intervals, -Gaps
            intervals_subtract/3,       % +Intervals, +Interval, -Rest
            intervals_within/4          % +Intervals, +Low, +High, -Within
          ]).
/** <module> Sets of intervals From-To between 0 and 1.

A set is a list of disjoint intervals in order. These are the parts of a line:
0.0 is its start, 1.0 its end.
*/

%!  intervals_union(+Least, +Intervals, -Union) is det.
%
%   True when Union is the set that covers what Intervals, in standard order,
%   cover; gaps that are not longer than Least are closed (those at 0 and 1
%   too), then what is not longer than Least is dropped.

intervals_union(Least, Intervals, Union) :-
    union_(Intervals, Least, Union).

union_([], _, []).
union_([From0-To0|Rest0], Least, Union) :-
    (   From0 =< Least
    ->  From = 0.0
    ;   From = From0
    ),
    absorbed(Rest0, Least, To0, To1, Rest),
    (   1.0-To1 =< Least
    ->  To = 1.0
    ;   To = To1
    ),
    (   To-From > Least
    ->  Union = [From-To|Union1]
    ;   Union = Union1
    ),
    union_(Rest, Least, Union1).

absorbed([From-To1|Rest0], Least, To0, To, Rest) :-
    From-To0 =< Least,
    !,
    To2 is max(To0, To1),
    absorbed(Rest0, Least, To2, To, Rest).
absorbed(Rest, _, To, To, Rest).

%!  intervals_gaps(+Intervals, -Gaps) is det.
%
%   True when Gaps is what the set Intervals leaves of 0.0-1.0.

intervals_gaps(Intervals, Gaps) :-
    gaps_(Intervals, 0.0, Gaps).

gaps_([], At, Gaps) :-
    (   At < 1.0
    ->  Gaps = [At-1.0]
    ;   Gaps = []
    ).
gaps_([From-To|Rest], At, Gaps) :-
    (   From > At
    ->  Gaps = [At-From|Gaps1]
    ;   Gaps = Gaps1
    ),
    gaps_(Rest, To, Gaps1).

%!  intervals_subtract(+Intervals, +Interval, -Rest) is det.
%
%   True when Rest is the set Intervals without Interval.

intervals_subtract([], _, []).
intervals_subtract([X-Y|More], From-To, Rest) :-
    (   ( Y =< From ; X >= To )
    ->  Rest = [X-Y|Rest1]
    ;   before_(X, From, Rest, Rest0),
        before_(To, Y, Rest0, Rest1)
    ),
    intervals_subtract(More, From-To, Rest1).

before_(From, To, Rest0, Rest) :-
    (   From < To
    ->  Rest0 = [From-To|Rest]
    ;   Rest0 = Rest
    ).

%!  intervals_within(+Intervals, +Low, +High, -Within) is det.
%
%   True when Within is the part of the set Intervals between Low and High.

intervals_within([], _, _, []).
intervals_within([X0-Y0|More], Low, High, Within) :-
    X is max(X0, Low),
    Y is min(Y0, High),
    before_(X, Y, Within, Within1),
    intervals_within(More, Low, High, Within1).
