:- module(sg_dash,
          [ stroke_runs/4,              % +Stroke, +Runs, -Fitted, -Offset
            stroke_dashes/3,            % +Stroke, +Runs, -Dashes
            plain_end/2                 % +End0, -End
          ]).
:- use_module(stroke, [stroke_length/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, last/2, reverse/2, sum_list/2]).
/** <module> Dashes that fit the line.

A dashed line begins and ends with a dash, so that corners are closed; where
it goes on as a visible line it begins with a gap, so that one sees where it
is hidden (ISO 128). So its runs are stretched or shrunk a little for each
stroke. Where others cross it (crossing.pl) it has the middle of a dash; its
runs are then those of its whole way, one by one.

Runs are lengths of a dash, a gap, a dash, a gap, ... in the unit of the
points of a stroke, positive, an even number of them: [3000,900] is a dashed
line, [6000,750,125,750] a chain of long dashes and dots. It begins with the
first dash and ends with it, so a chain has a long dash at both ends.
*/

:- set_prolog_flag(optimise, true).

%!  stroke_runs(+Stroke, +Runs, -Fitted, -Offset) is det.
%
%   Fitted are Runs fitted to Stroke, integers; it begins Offset after the
%   start of the first dash.

stroke_runs(Stroke, Runs, Fitted, Offset) :-
    fitted_runs(Stroke, Runs, Exact),
    maplist(whole_run, Exact, Fitted),
    first_run(Stroke, Fitted, _, Offset).

whole_run(Run, Whole) :-
    (   Run =:= 0                       % of crossed_runs/6, the first
    ->  Whole = 0
    ;   Whole is max(1, round(Run))
    ).

%!  plain_end(+End0, -End) is det.
%
%   End is the End0 of a stroke without what crossing.pl has added.

plain_end(crossed(End,_,_), End) :-
    !.
plain_end(End, End).

%   A number of periods and the first dash once more, and a gap at each cut
%   end; in a ring a number of periods.

fitted_runs(stroke(_,_,_,_,_,Start,crossed(End,Marks,Length)), [Dash,Gap],
            Fitted) :-
    !,
    crossed_runs(Start, End, Marks, Length, Dash-Gap, Fitted).
fitted_runs(Stroke, Runs, Fitted) :-
    Stroke = stroke(_, _, _, _, _, Start, End0),
    plain_end(End0, End),
    stroke_length(Stroke, Length),
    sum_list(Runs, Period),
    ends_length(Start, End, Runs, Ends, Least),
    N is max(Least, round((Length-Ends)/Period)),
    Stretch is Length/(N*Period+Ends),
    maplist(stretched(Stretch), Runs, Fitted).

ends_length(ring, _, _, 0, 1) :-
    !.
ends_length(Start, End, Runs, Length, 0) :-
    Runs = [Dash,Gap|_],
    last(Runs, LastGap),
    cut_gap(Start, LastGap, Before),
    cut_gap(End, Gap, After),
    Length is Before+Dash+After.

cut_gap(cut, Gap, Gap).
cut_gap(joint, _, 0).

stretched(Stretch, Run0, Run) :-
    Run is Run0*Stretch.

%   first_run(Stroke, Runs, Index, Offset): the stroke begins with the run of
%   that Index, from 0, which begins Offset after the first dash.

first_run(stroke(_,_,_,_,_,_,crossed(_,_,_)), [First|_], Index, 0) :-
    !,
    (   First =:= 0
    ->  Index = 1
    ;   Index = 0
    ).
first_run(stroke(_,_,_,_,_,cut,_), Runs, Index, Offset) :-
    !,
    length(Runs, N),
    Index is N-1,
    last(Runs, Gap),
    sum_list(Runs, Period),
    Offset is Period-Gap.
first_run(_, _, 0, 0).

%   crossed_runs(Start, End, Marks, Length, Dash-Gap, Runs): Runs are those of a
%   stroke of that Length which is crossed at Marks, a dash first, which may be
%   0, and a gap last. Between two marks, or a mark and an end, is a span.

crossed_runs(ring, _, [First|Marks], Length, Run, Runs) :-
    !,
    Round is First+Length,
    append(Marks, [Round], Ends),
    foldl(span_added(Run), Ends, at(mark,First,Items,mark),
          at(_,_,[],_)),
    Before is Length-First,
    items_split(Items, Before, Head, Tail),
    append(Tail, Head, Around),
    items_runs(Around, Run, Runs).
crossed_runs(Start, End, Marks0, Length, Run, Runs) :-
    Run = Dash-_,
    Least is Dash/2,
    Most is Length-Least,
    inner_marks(Marks0, Least, Most, Marks),
    foldl(span_added(Run), Marks, at(Start,0.0,Items,mark),
          at(Last,From,Items1,_)),
    span_added(Run, Length, at(Last,From,Items1,End), at(_,_,[],_)),
    items_runs(Items, Run, Runs).

inner_marks([], _, _, []).
inner_marks([Mark|Marks0], Least, Most, Marks) :-
    (   Mark > Least,
        Mark < Most
    ->  Marks = [Mark|Marks1]
    ;   Marks = Marks1
    ),
    inner_marks(Marks0, Least, Most, Marks1).

%   span_added(Run, To, At0, At): At is at(Left, From, Items, Right): a span
%   from From, where there is Left, a `mark` or as in a stroke, to To, where
%   there is Right. Items, dash(Length) and gap(Length), follow.

span_added(Run, To, at(Left,From,Items0,Right), at(mark,To,Items,Right)) :-
    Length is To-From,
    span_items(Left, Right, Length, Run, Own),
    append(Own, Items, Items0).

%   From the middle of a dash to the middle of one is a number of periods.

span_items(Left, Right, Length, Dash-Gap, Items) :-
    before_middle(Left, Dash, Gap, DashA, GapA),
    before_middle(Right, Dash, Gap, DashB, GapB),
    Fixed is DashA+GapA+DashB+GapB,
    N is max(0, round((Length-Fixed)/(Dash+Gap))),
    Total is Fixed + N*(Dash+Gap),
    (   (   Total =:= 0
        ;   Length < Total/2
        )
    ->  Items = [dash(Length)]
    ;   S is Length/Total,
        SA is S*GapA,
        SB is S*GapB,
        dash_items(N, S, DashA, DashB, Dash, Gap, Dashes),
        append([gap(SA)|Dashes], [gap(SB)], Items)
    ).

before_middle(mark, _, _, 0, 0).
before_middle(joint, Dash, _, Half, 0) :-
    Half is Dash/2.
before_middle(cut, Dash, Gap, Half, Gap) :-
    Half is Dash/2.

dash_items(0, S, DashA, DashB, _, _, [dash(D)]) :-
    !,
    D is S*(DashA+DashB).
dash_items(N, S, DashA, DashB, Dash, Gap, [dash(D),gap(G)|Items]) :-
    D is S*(DashA+Dash/2),
    G is S*Gap,
    N1 is N-1,
    HalfDash is Dash/2,
    dash_items(N1, S, HalfDash, DashB, Dash, Gap, Items).

%   items_split(Items, Length, Head, Tail): Head is so long.

items_split([Item|Items], Left, Head, Tail) :-
    Item =.. [Kind,Length],
    (   Length =< Left
    ->  Head = [Item|Head1],
        Left1 is Left-Length,
        items_split(Items, Left1, Head1, Tail)
    ;   Rest is Length-Left,
        First =.. [Kind,Left],
        Second =.. [Kind,Rest],
        Head = [First],
        Tail = [Second|Items]
    ).
items_split([], _, [], []).

%   items_runs(Items, Run, Runs): neighbours of a kind are one; a dash is first,
%   a gap last.

items_runs(Items0, _-Gap, Runs) :-
    items_joined(Items0, dash, 0, Runs0),
    length(Runs0, N),
    (   N mod 2 =:= 0
    ->  Runs = Runs0
    ;   append(Runs0, [Gap], Runs)
    ).

items_joined([], _, Length, [Length]).
items_joined([Item|Items], Kind, Length0, Runs) :-
    Item =.. [Kind1,Length1],
    (   Length1 =:= 0
    ->  items_joined(Items, Kind, Length0, Runs)
    ;   Kind1 == Kind
    ->  Length is Length0+Length1,
        items_joined(Items, Kind, Length, Runs)
    ;   Runs = [Length0|Runs1],
        items_joined(Items, Kind1, Length1, Runs1)
    ).

%!  stroke_dashes(+Stroke, +Runs, -Dashes) is det.
%
%   Dashes are the dashes of Stroke as lines: lists of two or more points,
%   each X-Y, integers. Runs are fitted to it.

stroke_dashes(Stroke, Runs, Dashes) :-
    Stroke = stroke(_, _, _, _, [Point|Points], _, _),
    fitted_runs(Stroke, Runs, Fitted),
    compound_name_arguments(Pattern, runs, Fitted),
    first_run(Stroke, Fitted, Index, _),
    run(Pattern, Index, Left),
    dashes(Points, Point, Pattern, Index, Left, [Point], Dashes).

run(Pattern, Index, Length) :-
    Argument is Index+1,
    arg(Argument, Pattern, Length).

%   dashes(Points, At, Pattern, Index, Left, Line, Dashes): the pen is at At,
%   in the run of that Index, a dash if it is even, of which Left is left; Line
%   is what was drawn since the run began, last point first.

dashes([], _, _, Index, _, Line, Dashes) :-
    dash_ended(Index, Line, Dashes, []).
dashes([Point|Points], At, Pattern, Index, Left, Line, Dashes) :-
    At = X0-Y0,
    Point = X-Y,
    Way is sqrt((X-X0)**2 + (Y-Y0)**2),
    (   Way =< Left+0.5
    ->  Left1 is Left-Way,
        dashes(Points, Point, Pattern, Index, Left1, [Point|Line], Dashes)
    ;   X1 is X0 + (X-X0)*Left/Way,
        Y1 is Y0 + (Y-Y0)*Left/Way,
        rounded(X1-Y1, Change),
        dash_ended(Index, [Change|Line], Dashes, Dashes1),
        next_run(Pattern, Index, Index1),
        run(Pattern, Index1, Left1),
        dashes([Point|Points], X1-Y1, Pattern, Index1, Left1, [Change],
               Dashes1)
    ).

next_run(Pattern, Index0, Index) :-
    compound_name_arity(Pattern, _, N),
    Index is (Index0+1) mod N.

rounded(X0-Y0, X-Y) :-
    X is round(X0),
    Y is round(Y0).

dash_ended(Index, [Point,Before|Line], [Dash|Dashes], Dashes) :-
    Index mod 2 =:= 0,
    !,
    reverse([Point,Before|Line], Dash).
dash_ended(_, _, Dashes, Dashes).
