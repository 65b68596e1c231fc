:- module(sg_pen_plan,
          [ pen_plans/3,                % +Inked, +Order, -Plans
            drawing_pens/3              % +Drawing, +Options, -Pens
          ]).
:- use_module(ink,
              [ inked/3, inked_inks/2, inked_lines/3, ink_colour/3,
                ink_lines/4, ink_pen/2 ]).
:- use_module(travel, [short_travel/3, travel_length/3]).
:- use_module(library(apply), [convlist/3, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [list_to_set/2, member/2]).
/** <module> What each pen of a plotter draws, and in which order.
*/

%!  pen_plans(+Inked, +Order, -Plans) is det.
%
%   Plans say what each pen draws of Inked, pen by pen in painting order:
%   plan(Pen, Lines, Way, Unsorted), Lines being line(Ink, Stroke) as they are
%   drawn, Way how far the lifted pen goes between them, and Unsorted how far it
%   would have gone. Order is `short` or `kept`.

pen_plans(Inked, Order, Plans) :-
    Inked = inked(sheet(_,H,_), _, _),
    inked_lines(drawn, Inked, Lines),
    inked_inks(Inked, Inks),
    maplist(ink_pen, Inks, Pens0),
    list_to_set(Pens0, Pens),
    maplist(pen_plan(Lines, Order, 0-H), Pens, Plans).

pen_plan(Lines, Order, Start, Pen, plan(Pen,Drawn,Way,Unsorted)) :-
    findall(Key-Ink,
            ( member(line(Ink,Stroke), Lines),
              ink_pen(Ink, Pen),
              stroke_key(Stroke, Key)
            ),
            Keys0),
    sort(1, @<, Keys0, Keys),
    list_to_assoc(Keys, Inks),
    convlist(pen_stroke(Pen), Lines, Strokes),
    ordered(Order, Start, Strokes, Ordered),
    travel_length(Start, Ordered, Way),
    travel_length(Start, Strokes, Unsorted),
    maplist(stroke_line(Inks), Ordered, Drawn).

stroke_line(Inks, Stroke, line(Ink,Stroke)) :-
    stroke_key(Stroke, Key),
    get_assoc(Key, Inks, Ink).

%   The pen begins in the plotter's origin.

ordered(kept, _, Strokes, Strokes) :-
    !.
ordered(short, Start, Strokes, Ordered) :-
    short_travel(Start, Strokes, Ordered).

pen_stroke(Pen, line(Ink,Stroke), Stroke) :-
    ink_pen(Ink, Pen).

%   A line's ink is the same as that of all lines with its key.

stroke_key(stroke(Visibility,Role,S,_,_,_,_), key(Visibility,Role,S)).

%!  drawing_pens(+Drawing, +Options, -Pens) is det.
%
%   Pens are pen(Pen, RGB, Strokes), as a plotter draws Drawing (sheet.pl), dash
%   by dash. Options as for inked/3.

drawing_pens(Drawing, Options, Pens) :-
    inked(Drawing, Options, Inked),
    pen_plans(Inked, short, Plans),
    findall(pen(Pen,RGB,Strokes),
            ( member(plan(Pen,Lines,_,_), Plans),
              Lines = [line(First,_)|_],
              ink_colour(print, First, RGB),
              findall(Stroke, ( member(Line, Lines),
                                drawn_stroke(Line, Stroke) ),
                      Strokes) ),
            Pens).

drawn_stroke(line(Ink,Stroke0), stroke(Visibility,Role,S,[],Points,joint,
                                       joint)) :-
    Stroke0 = stroke(Visibility, Role, S, _, _, _, _),
    ink_lines(geometry, Ink, Stroke0, Lines),
    member(Points, Lines).
