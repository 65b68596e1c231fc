:- module(sg_hpgl,
          [ write_hpgl/3                % +Out, +Inked, +Options
          ]).
:- use_module(ink,
              [dashes_option/3, ink_runs/2, ink_type/2, ink_lines/4]).
:- use_module(pen_plan, [fold_plan/4, pen_plans/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [last/2, list_to_set/2, sum_list/2]).
:- use_module(library(option), [option/3]).
/** <module> HPGL: strokes for pen plotters.

The style (style.pl) says which pen draws what; each pen is taken once. Dashes
are drawn as such, for many plotters and all cutters know no line types; with
dashes(type) they are the plotter's own, `LT`. Texts are drawn letter by letter
(lettering.pl). A unit is 0.025 mm, the origin the lower left corner of the
sheet; `PS` says how large that is.
*/

%!  write_hpgl(+Out, +Inked, +Options) is det.
%
%   Write Inked (ink.pl) to stream Out, pen by pen in painting order, the
%   pen's travel between lines short (travel.pl). Options: dashes(How),
%   `geometry` as is usual, or `type`; order(kept): lines stay in their order,
%   as a cutter needs it that cuts holes before what is round them.

write_hpgl(Out, Inked, Options) :-
    Inked = inked(sheet(W,H,_), _, _),
    dashes_option(Options, geometry, How),
    option(order(Order), Options, short),
    pen_plans(Inked, Order, Plans),
    units(H, W-0, Wide, High),
    format(Out, 'IN;~nPS~d,~d;~n', [Wide, High]),
    scaling_points(How, Out, W, H),
    maplist(plot_pen(Out, plot(How,W,H)), Plans),
    format(Out, 'PU;SP0;~n', []),
    foldl(travelled, Plans, travel(0,0,0), travel(N,Way,WayUnsorted)),
    print_message(informational,
                  sanggwan(pen_travel(N, Way, WayUnsorted))).

%   Line types are as long as the diagonal of P1 and P2 says: the sheet's.

scaling_points(type, Out, W, H) :-
    !,
    units(H, W-0, X, Y),
    format(Out, 'IP0,0,~d,~d;~n', [X,Y]).
scaling_points(_, _, _, _).

%   travel(N,Way,WayUnsorted): so many lines up to here, and how far the pen
%   went between them, or would have gone.

travelled(plan(_,_,travel(_,N1,_,_,Way1,Unsorted1)), travel(N0,Way0,Unsorted0),
          travel(N,Way,Unsorted)) :-
    N is N0+N1,
    Way is Way0+Way1,
    Unsorted is Unsorted0+Unsorted1.

plot_pen(Out, How, Plan) :-
    Plan = plan(Pen, _, _),
    format(Out, 'PU;SP~d;~n', [Pen]),
    fold_plan(plot(Out, How), Plan, pen(solid,none), pen(Type,_)),
    line_type(Out, How, Type, solid).

%   pen(Type,At): the line type, and where the pen is down, X-Y in units.

plot(Out, How, line(Ink,Stroke), pen(Type0,At0), pen(Type,At)) :-
    comment(Out, Stroke),
    pen_type(How, Ink, Type),
    line_type(Out, How, Type0, Type),
    How = plot(Dashes, _, H),
    ink_lines(Dashes, Ink, Stroke, Lines),
    (   Type == Type0
    ->  At1 = At0
    ;   At1 = none
    ),
    foldl(plot_line(Out, H), Lines, At1, At).

comment(_, stroke(_,text,_,_,_,_,_)) :-
    !.
comment(Out, stroke(Visibility,Role,S,[E|_],_,_,_)) :-
    !,
    format(Out, 'CO "s~de~d ~w ~w";~n', [S, E, Visibility, Role]).
comment(Out, stroke(Visibility,Role,_,_,_,_,_)) :-
    format(Out, 'CO "~w ~w";~n', [Visibility, Role]).

pen_type(plot(type,_,_), Ink, Type) :-
    ink_runs(Ink, Runs),
    Runs = [_|_],
    !,
    ink_type(Ink, Name),
    type_number(Name, Runs, N),
    sum_list(Runs, Length),
    Type = dashes(N, Length).
pen_type(_, _, solid).

%   The line type of HPGL that looks most like it: 1 dots, 2 half and half, 3
%   seven tenths, 4 dash and dot, 6 dash and two dots.

type_number(dotted, _, N) =>
    N = 1.
type_number(dashed_spaced, _, N) =>
    N = 2.
type_number(_, [_,_], N) =>
    N = 3.
type_number(_, [_,_,_,_], N) =>
    N = 4.
type_number(_, _, N) =>
    N = 6.

line_type(_, _, Type, Type) :-
    !.
line_type(Out, _, _, solid) :-
    format(Out, 'LT;~n', []).
line_type(Out, plot(_,W,H), _, dashes(N,Length)) :-
    Percent is 100*Length/sqrt(W*W+H*H),
    format(Out, 'LT~d,~3f;~n', [N,Percent]).

%   Where a line begins at the point where the last one ended the pen stays
%   down. What is shorter than a unit is nothing that a pen could draw; a point
%   that is meant as one, such as a full stop, is put.

plot_line(Out, H, Points0, At0, At) :-
    maplist(unit_point(H), Points0, [First|Points1]),
    moved_points(Points1, First, Points),
    (   Points \== []
    ->  drawn_line(Out, First, Points, At0, At)
    ;   list_to_set(Points0, [_])
    ->  drawn_line(Out, First, [First], At0, At)
    ;   At = At0
    ).

unit_point(H, Point, X-Y) :-
    units(H, Point, X, Y).

%   moved_points(Points0, At, Points): without those at which the pen is.

moved_points([], _, []).
moved_points([Point|Points0], At, Points) :-
    (   Point == At
    ->  Points = Points1
    ;   Points = [Point|Points1]
    ),
    moved_points(Points0, Point, Points1).

drawn_line(Out, First, Points, At0, At) :-
    (   At0 == First
    ->  true
    ;   First = X-Y,
        format(Out, 'PU~d,~d;', [X, Y])
    ),
    format(Out, 'PD', []),
    foldl(plot_to(Out), Points, '', _),
    format(Out, ';~n', []),
    last(Points, At).

plot_to(Out, X-Y, Before, ',') :-
    format(Out, '~w~d,~d', [Before, X, Y]).

%   Letters may reach beyond the sheet: below zero, units are as long as above.

units(H, X0-Y0, X, Y) :-
    X is (2*X0+25) div 50,
    Y is (2*(H-Y0)+25) div 50.
