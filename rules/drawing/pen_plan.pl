:- module(sg_pen_plan,
          [ pen_plans/3,                % +Inked, +Order, -Plans
            fold_plan/4,                % :Goal, +Plan, +State0, -State
            drawing_pens/3              % +Drawing, +Options, -Pens
          ]).
:- use_module(ink,
              [ inked/3, inked_inks/2, inked_lines/3, ink_colour/3,
                ink_lines/4, ink_pen/2 ]).
:- use_module('../sheet/stroke', [stroke_key/4]).
:- use_module(travel, [fold_travel/4, travel/4]).
:- use_module(library(apply), [convlist/3, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [list_to_set/2, member/2]).
/** <module> What each pen of a plotter draws, and in which order.
*/

%!  pen_plans(+Inked, +Order, -Plans) is det.
%
%   Plans say what each pen draws of Inked, pen by pen in painting order:
%   plan(Pen, Inks, Travel), see fold_plan/4 and travel/4. Order is `short` or
%   `kept`.

pen_plans(Inked, Order, Plans) :-
    Inked = inked(sheet(_,H,_), _, _),
    inked_lines(drawn, Inked, Lines),
    inked_inks(Inked, Inks),
    maplist(ink_pen, Inks, Pens0),
    list_to_set(Pens0, Pens),
    maplist(pen_plan(Lines, Order, 0-H), Pens, Plans).

%   The pen begins in the plotter's origin.

pen_plan(Lines, Order, Start, Pen, plan(Pen,Inks,Travel)) :-
    findall(Key-Ink,
            ( member(line(Ink,Strokes), Lines),
              ink_pen(Ink, Pen),
              line_key(Strokes, Key)
            ),
            Keys0),
    sort(1, @<, Keys0, Keys),
    list_to_assoc(Keys, Inks),
    convlist(pen_strokes(Pen), Lines, Strokess),
    travel(Start, Order, Strokess, Travel).

pen_strokes(Pen, line(Ink,Strokes), Strokes) :-
    ink_pen(Ink, Pen).

%   A line's ink is the same as that of all lines with its key.

line_key(Strokes, key(Visibility,Role,S)) :-
    stroke_key(Strokes, Visibility, Role, S).

%!  fold_plan(:Goal, +Plan, +State0, -State) is det.
%
%   As foldl/4, of the line(Ink, Stroke) of Plan as they are drawn.

:- meta_predicate fold_plan(3, +, +, -).

fold_plan(Goal, plan(_,Inks,Travel), State0, State) :-
    fold_travel(fold_stroke(Goal, Inks), Travel, State0, State).

fold_stroke(Goal, Inks, Stroke, State0, State) :-
    line_key(Stroke, Key),
    get_assoc(Key, Inks, Ink),
    call(Goal, line(Ink,Stroke), State0, State).

%!  drawing_pens(+Drawing, +Options, -Pens) is det.
%
%   Pens are pen(Pen, RGB, Strokes), as a plotter draws Drawing (sheet.pl), dash
%   by dash. Options as for inked/3.

drawing_pens(Drawing, Options, Pens) :-
    inked(Drawing, Options, Inked),
    pen_plans(Inked, short, Plans),
    findall(pen(Pen,RGB,Strokes),
            ( member(Plan, Plans),
              Plan = plan(Pen, _, _),
              fold_plan(added_line, Plan, Lines, []),
              Lines = [line(First,_)|_],
              ink_colour(print, First, RGB),
              findall(Stroke, ( member(Line, Lines),
                                drawn_stroke(Line, Stroke) ),
                      Strokes) ),
            Pens).

added_line(Line, [Line|Lines], Lines).

drawn_stroke(line(Ink,Stroke0), stroke(Visibility,Role,S,[],Points,joint,
                                       joint)) :-
    Stroke0 = stroke(Visibility, Role, S, _, _, _, _),
    ink_lines(geometry, Ink, Stroke0, Lines),
    member(Points, Lines).
