/* What each pen draws, and from where it begins. */
:- module(test_pen_plan, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(drawing/ink)).
:- use_module(rules(drawing/pen_plan)).

%   plans(Strokes, Order, Plans): Pen-Edges, in the order of the drawing,
%   on a sheet of 60 x 40 mm.

plans(Strokes, Order, Found) :-
    inked(drawing(sheet(60000,40000,1.0), [view('',Strokes,[])]), [], Inked),
    pen_plans(Inked, Order, Plans),
    findall(Pen-Edges,
            ( member(Plan, Plans),
              Plan = plan(Pen,_,_),
              fold_plan(drawn, Plan, [], Edges0),
              reverse(Edges0, Edges) ),
            Found).

drawn(line(_,stroke(_,_,_,Es,_,_,_)), Edges, [E|Edges]) :-
    Es = [E|_].

line(Visibility, Role, E, A, B,
     stroke(Visibility,Role,1,[E],[A,B],joint,joint)).

:- begin_tests(pen_plan).

test(nothing, Plans == []) :-
    plans([], short, Plans).
%   Hidden lines have pen 2, penetration lines 3, and are painted in that order.
test(pens, Plans == [2-[1],1-[2],3-[3]]) :-
    line(hidden, crease, 1, 0-0, 9-0, A),
    line(visible, crease, 2, 0-5, 9-5, B),
    line(visible, penetration, 3, 0-7, 9-7, C),
    plans([A,B,C], short, Plans).
test(short, Plans == [1-[3,2,1]]) :-
    line(visible, crease, 1, 50000-39000, 51000-39000, A),
    line(visible, crease, 2, 20000-39000, 25000-39000, B),
    line(visible, crease, 3, 1000-39000, 9000-39000, C),
    plans([A,B,C], short, Plans).
test(kept, Plans == [1-[1,2,3]]) :-
    line(visible, crease, 1, 50000-39000, 51000-39000, A),
    line(visible, crease, 2, 20000-39000, 25000-39000, B),
    line(visible, crease, 3, 1000-39000, 9000-39000, C),
    plans([A,B,C], kept, Plans).
%   The lower left corner is the origin: what is a thousandth nearer to it than
%   another line is first.
test(begins_in_the_corner, [ forall(member(By-First, [1-2,-1-1])),
                             true(Found == First) ]) :-
    X is 5000+By,
    Y is 40000-5000,
    line(visible, crease, 1, X-40000, 9000-40000, A),
    line(visible, crease, 2, 0-Y, 0-31000, B),
    plans([A,B], short, [1-[Found|_]]).

:- end_tests(pen_plan).
