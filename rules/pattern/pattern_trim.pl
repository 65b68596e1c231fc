:- module(sg_pattern_trim,
          [ trimmed_tab/4               % +Within, +Least, :Free, -Tab
          ]).
:- use_module('../near', [less_part/2, longer/2]).
:- use_module(library(lists), [member/2]).
/** <module> A tab trimmed to the room beside its seam.

A slit hardly opens: there a tab is no trapezoid but what is left of one between
the two sides of the slit. How deep the room is is asked column by column; under
these the largest tab is taken whose top is straight, level or slanting.

Places are Along-Deep: along the seam, and away from it.
*/

:- set_prolog_flag(optimise, true).

% So many columns are asked, each so often.
columns(10).
halvings(4).

% Of the room that was found a tab takes so much: a knife has to go beside it.
taken(0.93).

% How the top of a tab may slant, along the seam.
slant(S) :-
    member(S, [0.0,0.06,-0.06,0.14,-0.14,0.3,-0.3,0.6,-0.6]).

:- meta_predicate trimmed_tab(+, +, 1, -).

%!  trimmed_tab(+Within, +Least, :Free, -Tab) is semidet.
%
%   Tab, a list of Along-Deep, is the largest that there is room for within
%   Within, within(From,To,Slope1,Slope2,Deep): from From to To along the seam,
%   at most Deep, its ends leaning in by Slope1 and Slope2 of their depth. It is
%   at least Least deep in the middle of its top, and twice Least along the
%   seam. call(Free, Tab) is true if nothing else is where Tab would be, also
%   for any part of that Tab.

trimmed_tab(Within, Least, Free, Tab) :-
    Within = within(From, To, _, _, _),
    columns(N),
    Step is (To-From)/N,
    findall(column(X1,X2,D),
            ( between(1, N, I),
              X1 is From+(I-1)*Step,
              X2 is From+I*Step,
              column_room(X1, X2, Within, Least, Free, D)
            ),
            Columns),
    findall(Less-Tab0,
            ( stretch(Columns, Least, Stretch),
              slant(Slant),
              tab_under(Stretch, Slant, Within, Least, Tab0, Area),
              Less is -Area
            ),
            Tabs0),
    keysort(Tabs0, Tabs),
    member(_-Tab, Tabs),
    call(Free, Tab),
    !.

%   column_room(X1, X2, Within, Least, Free, Room): how deep the column from X1
%   to X2 is free; 0 if less than about half of Least.

column_room(X1, X2, within(_,_,_,_,Deep), Least, Free, Room) :-
    (   column_free(X1, X2, Deep, Free)
    ->  Room = Deep
    ;   Low is Least/2,
        column_free(X1, X2, Low, Free)
    ->  halvings(N),
        halved_room(N, X1, X2, Low, Deep, Free, Room0),
        taken(Share),
        Room is Share*Room0
    ;   Room = 0.0
    ).

column_free(X1, X2, Deep, Free) :-
    call(Free, [X1-0.0,X1-Deep,X2-Deep,X2-0.0]).

halved_room(0, _, _, Low, _, _, Low) :-
    !.
halved_room(N, X1, X2, Low, High, Free, Room) :-
    Middle is sqrt(Low*High),
    N1 is N-1,
    (   column_free(X1, X2, Middle, Free)
    ->  halved_room(N1, X1, X2, Middle, High, Free, Room)
    ;   halved_room(N1, X1, X2, Low, Middle, Free, Room)
    ).

%   stretch(Columns, Least, Stretch): Columns that follow each other, all of
%   them with some room, long enough for a tab.

stretch(Columns, Least, Stretch) :-
    roomy_tail(Columns, [First|Tail]),
    First = column(X1, _, _),
    roomy_head([First|Tail], Stretch, X2),
    X2-X1 >= 2*Least.

roomy_tail(Columns, Columns).
roomy_tail([_|Columns], Tail) :-
    roomy_tail(Columns, Tail).

roomy_head([Column|_], [Column], X2) :-
    Column = column(_, X2, D),
    D > 0.
roomy_head([Column|Columns], [Column|Head], X2) :-
    Column = column(_, _, D),
    D > 0,
    roomy_head(Columns, Head, X2).

%   tab_under(Stretch, Slant, Within, Least, Tab, Area): its top is the highest
%   line of that slant below the room of all columns.

tab_under(Stretch, Slant, within(_,_,Slope1,Slope2,Deep), Least, Tab, Area) :-
    Stretch = [column(X1,_,_)|_],
    line_under(Stretch, Slant, X1, Deep, At1, X1, X2),
    At2 is At1 + Slant*(X2-X1),
    Lean1 is 1-Slant*Slope1,
    Lean2 is 1+Slant*Slope2,
    Lean1 > 0.05,
    Lean2 > 0.05,
    D1 is At1/Lean1,
    D2 is At2/Lean2,
    \+ less_part(min(D1, D2), 0.0),
    \+ longer(max(D1, D2), Deep),
    (D1+D2)/2 >= Least,
    Top1 is X1+Slope1*D1,
    Top2 is X2-Slope2*D2,
    Top2-Top1 >= 0.1*(X2-X1),
    Area is (D1*(Top2-X1) + D2*(X2-Top1))/2,
    tab_corners(X1, Top1, D1, Top2, D2, X2, Tab).

%   line_under(Columns, Slant, X1, At0, At, End0, End): At, at most At0, is the
%   height at X1 of the line; End is where the last of Columns ends.

line_under([], _, _, At, At, End, End).
line_under([column(A,B,D)|Columns], Slant, X1, At0, At, _, End) :-
    At1 is min(At0, D - max(Slant*(A-X1), Slant*(B-X1))),
    line_under(Columns, Slant, X1, At1, At, B, End).

tab_corners(X1, Top1, D1, Top2, D2, X2, Tab) :-
    (   D1 < 0.1
    ->  Tab = [X1-0.0,Top2-D2,X2-0.0]
    ;   D2 < 0.1
    ->  Tab = [X1-0.0,Top1-D1,X2-0.0]
    ;   Tab = [X1-0.0,Top1-D1,Top2-D2,X2-0.0]
    ).
