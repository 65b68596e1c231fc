:- module(sg_speck,
          [ without_specks/3            % +Least, +Views0, -Views
          ]).
:- use_module(stroke, [all_strokes/2]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/3]).
:- use_module(library(lists), [last/2]).
:- use_module(library(rbtrees), [rb_empty/1, rb_insert/4, rb_lookup/3,
                                 rb_update/4]).
/** <module> Specks: short lines that hang on no other one.

A scanned surface is rough, and where it bends for a moment there is a crease
that leads nowhere. Such lines are left out if somebody asks for that; a short
line that goes on as another one stays.
*/

%!  without_specks(+Least, +Views0, -Views) is det.
%
%   Views are Views0 without the strokes of segments that are shorter than Least
%   millimetres, do not close, and end where no other stroke of their view ends.

without_specks(Least, Views, Views) :-
    Least =:= 0,
    !.
without_specks(Least, Views0, Views) :-
    maplist(view_without(Least), Views0, Views).

view_without(Least, view(Name,Strokess,Texts), view(Name,Strokes,Texts)) :-
    all_strokes(Strokess, Strokes0),
    rb_empty(None),
    foldl(ends_counted, Strokes0, None, Ends),
    Most is Least*1000,
    exclude(is_speck(Most, Ends), Strokes0, Strokes).

ends_counted(Stroke, Ends0, Ends) :-
    stroke_ends(Stroke, First, Last),
    end_counted(First, Ends0, Ends1),
    end_counted(Last, Ends1, Ends).

end_counted(End, Ends0, Ends) :-
    (   rb_lookup(End, N0, Ends0)
    ->  N is N0+1,
        rb_update(Ends0, End, N, Ends)
    ;   rb_insert(Ends0, End, 1, Ends)
    ).

stroke_ends(stroke(_,_,_,_,Points,_,_), First, Last) :-
    Points = [First|_],
    last(Points, Last).

%   is_speck(Most, Ends, Stroke): shorter than Most, thousandths, and alone.

is_speck(Most, Ends, Stroke) :-
    stroke_ends(Stroke, First, Last),
    First \== Last,
    rb_lookup(First, 1, Ends),
    rb_lookup(Last, 1, Ends),
    Stroke = stroke(_,_,S,_,[Start|Points],_,_),
    S > 0,                              % not of the sheet
    foldl(longer, Points, Start-0, _-Length),
    Length < Most.

longer(X-Y, (X0-Y0)-Length0, (X-Y)-Length) :-
    Length is Length0 + sqrt((X-X0)**2 + (Y-Y0)**2).
