:- module(dashes_fit,
          [ dashes_fit/4                % +Stroke, +Runs, +Fitted, +Offset
          ]).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
/* How dashes fit a line, said a second time, for tests. */

%!  dashes_fit(+Stroke, +Runs, +Fitted, +Offset) is semidet.
%
%   True when Fitted are Runs, all longer or shorter alike, and the line begins
%   and ends with a whole dash, or with a gap where it is cut; the number of
%   periods is the one that changes them least. Of a line that others cross
%   (crossing.plt) Fitted may be all of its dashes and gaps instead, as long as
%   the line, perhaps with a gap more.

dashes_fit(stroke(_,_,_,_,Points,Start,End), Runs, Fitted, Offset) :-
    Offset =:= 0,
    \+ same_length(Runs, Fitted),
    Runs = [_,Gap],
    !,
    way(Points, Length),
    length(Fitted, N),
    N mod 2 =:= 0,
    sum_list(Fitted, Sum),
    Fitted = [First|_],
    (   Start == joint
    ->  First > 0
    ;   Start == cut
    ->  First =:= 0
    ;   true
    ),
    (   End == cut
    ->  near(Sum, Length, N)
    ;   near(Sum, Length, Gap+N)
    ).
dashes_fit(stroke(_,_,_,_,Points,Start,End), Runs, Fitted, Offset) :-
    same_length(Runs, Fitted),
    way(Points, Length),
    sum_list(Runs, Period0),
    sum_list(Fitted, Period),
    Fitted = [Dash|_],
    last(Fitted, LastGap),
    Fitted = [_,Gap|_],
    (   Start == cut
    ->  Offset =:= Period-LastGap,
        Before = LastGap
    ;   Offset =:= 0,
        Before = 0
    ),
    (   Start == ring
    ->  Ends = 0
    ;   End == cut
    ->  Ends is Before+Dash+Gap
    ;   Ends is Before+Dash
    ),
    N is (Length-Ends)/Period,
    Whole is round(N),
    length(Runs, Count),
    Off is (Whole+2)*Count,             % each is rounded by a half at most
    near(Whole*Period+Ends, Length, Off),
    (   Start == ring
    ->  Least = 1
    ;   Least = 0
    ),
    Whole >= Least,
    Stretch is Period/Period0,
    forall(( nth1(I, Runs, Run), nth1(I, Fitted, Fit) ),
           near(Fit, Run*Stretch, 1.0+0.51*Count*Run/Period0)),
    Wanted is (Length-Ends*Period0/Period)/Period0,
    (   Whole =:= Least
    ->  Wanted =< Least+0.5+Count/Period0+1.0e-6
    ;   abs(Whole-Wanted) =< 0.5+Count/Period0+1.0e-6
    )
    ->  true
    ;   format(user_error, 'fit: ~q~n', [fit(Points,Start,End,Runs,Fitted,
                                             Offset)]),
        fail.

way([_], 0) :-
    !.
way([X0-Y0,X1-Y1|Points], Length) :-
    way([X1-Y1|Points], Length0),
    Length is Length0+sqrt((X1-X0)**2+(Y1-Y0)**2).
