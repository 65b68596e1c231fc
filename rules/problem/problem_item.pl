:- encoding(utf8).
:- module(sg_problem_item,
          [ item_fault/3,               % +Kind, +Item, -What
            items_fault/2,              % +Items, -What
            title_items/2,              % +Item0, -Items
            pupil_fields/1,             % -Fields
            item_views/3,               % +Items, -Names, -Blank
            drawn_views/2,              % +Items, -Names
            measure/2,                  % ?Measure, -Dimension
            measure_unit/4,             % ?Unit, ?Dimension, -Size, -Word
            along_views/2               % ?Axis, -Names
          ]).
:- use_module('../sheet/sheet_view', [view_named/2]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists),
              [append/3, list_to_set/2, member/2, subtract/3]).
:- use_module(library(option), [option/3]).
/** <module> What may stand in a problem and in a sheet, and what is wrong.

The items of a problem and of a sheet are those of problem_file.pl.
*/

%!  item_fault(+Kind, +Item, -What) is semidet.
%
%   What is wrong with Item of a `problem` or a `sheet`; it is ground.

item_fault(problem, ask(measure(Measure,Unit,Tolerance)), What) :-
    !,
    measure_fault(Measure, Unit, Tolerance, What).
item_fault(problem, Item, item(Item)) :-
    \+ problem_item(Item).
item_fault(sheet, Item, item(Item)) :-
    \+ sheet_item(Item).

problem_item(given(Views)) :-
    views(Views).
problem_item(blank(View)) :-
    atom(View),
    view_named(View, view(_, _, _, side)).
problem_item(hide(penetration)).
problem_item(show(penetration)).
problem_item(branch(S)) :-
    segment_number(S).
problem_item(generators(N)) :-
    integer(N),
    between(2, 360, N).
problem_item(edges(all)).
problem_item(planes(Way)) :-
    memberchk(Way, [x,y,z,straight]).
problem_item(planes(Axis, N)) :-
    memberchk(Axis, [x,y,z]),
    integer(N),
    between(1, 60, N).
problem_item(ask(draw(penetration))).
problem_item(ask(draw(penetration, Views))) :-
    views(Views).
problem_item(ask(count(loops))).
problem_item(ask(develop(S))) :-
    segment_number(S).
problem_item(part(S, Language, Text)) :-
    segment_number(S),
    in_language(Language, Text).
problem_item(text(Language, Text)) :-
    in_language(Language, Text).

views(Views) :-
    is_list(Views),
    Views = [_|_],
    forall(member(View, Views), view_named(View, view(_, _, _, side))).

sheet_item(fields(Words)) :-
    pupil_fields(Fields),
    is_list(Words),
    Words = [_|_],
    maplist(atom, Words),
    length(Words, N),
    length(Fields, Most),
    N =< Most.
sheet_item(angle(Angle)) :-
    memberchk(Angle, [first,third]).
sheet_item(title_block(Item, Text)) :-
    atom(Item),
    atom(Text).

in_language(Language, Text) :-
    memberchk(Language, [en,ko]),
    atom(Text).

segment_number(S) :-
    integer(S),
    S > 0.

%!  title_items(+Item0, -Items) is det.
%
%   Items of a sheet are what Item0 is as it is written: title_block(Words) is
%   fields(Words).

title_items(Item0, Items) :-
    (   nonvar(Item0),
        Item0 = title_block(Words)
    ->  Items = [fields(Words)]
    ;   Items = [Item0]
    ).

%!  pupil_fields(-Fields) is det.
%
%   Fields of the title block that a pupil fills in, in their order.

pupil_fields([drawn_by,date,checked_by,material]).

%!  items_fault(+Items, -What) is semidet.
%
%   What is wrong with Items of a problem, each of which is as it should be:
%   all_blank; no_view(Measure, Names), one of which has to be given;
%   not_given(Name, Names), a view to draw in is none of Names, those of the
%   problem; shown_and_asked, the lines are in the question.

items_fault(Items, What) :-
    item_views(Items, Names, Blank),
    subtract(Names, Blank, Shown),
    (   Shown == []
    ->  What = all_blank
    ;   member(ask(measure(Measure,_,_)), Items),
        Measure = coordinate(_, Axis),
        along_views(Axis, Along),
        \+ ( member(Name, Along), memberchk(Name, Shown) )
    ->  What = no_view(Measure, Along)
    ;   member(ask(draw(penetration, Drawn)), Items),
        member(Name, Drawn),
        \+ memberchk(Name, Names)
    ->  What = not_given(Name, Names)
    ;   memberchk(show(penetration), Items),
        (   memberchk(hide(penetration), Items)
        ;   memberchk(ask(draw(penetration)), Items)
        ;   memberchk(ask(draw(penetration, _)), Items)
        )
    ->  What = shown_and_asked
    ).

%!  item_views(+Items, -Names, -Blank) is det.
%
%   Names are those of the views of a problem, Blank of those that are not
%   drawn.

item_views(Items, Names, Blank) :-
    findall(View, member(blank(View), Items), Blank),
    option(given(Given), Items, [front,top]),
    append(Given, Blank, Names0),
    list_to_set(Names0, Names).

%!  drawn_views(+Items, -Names) is det.
%
%   The answer has the lines in which bodies meet in the views Names: in all
%   those of the problem, unless it says in which they are to be drawn.

drawn_views(Items, Names) :-
    (   memberchk(ask(draw(penetration, Drawn)), Items)
    ->  Names = Drawn
    ;   item_views(Items, Names, _)
    ).

%!  along_views(?Axis, -Names) is nondet.
%
%   Names are those of the views in which Axis is seen as a point.

along_views(x, [right,left]).
along_views(y, [front,back]).
along_views(z, [top,bottom]).


                /*******************************
                *           MEASURES           *
                *******************************/

%!  measure(?Measure, -Dimension) is nondet.
%
%   Measure can be asked for; see problem_measure.pl. Dimension is `length`,
%   `area`, `volume` or `angle`.

measure(shortest_generator(_), length).
measure(longest_generator(_),  length).
measure(generator(_, _),       length).
measure(edge(_, _, _),         length).
measure(perimeter(_),          length).
measure(coordinate(_, _),      length).
measure(area(_),               area).
measure(volume(_),             volume).
measure(angle(_, _, _, _),     angle).
measure(sector(_),             angle).

%!  measure_unit(?Unit, ?Dimension, -Size, -Word) is nondet.
%
%   Unit, Size units of the model (mm, degrees) large, is written as Word.

measure_unit(mm,  length, 1.0,   "mm").
measure_unit(cm,  length, 10.0,  "cm").
measure_unit(m,   length, 1.0e3, "m").
measure_unit(mm2, area,   1.0,   "mm²").
measure_unit(cm2, area,   1.0e2, "cm²").
measure_unit(m2,  area,   1.0e6, "m²").
measure_unit(mm3, volume, 1.0,   "mm³").
measure_unit(cm3, volume, 1.0e3, "cm³").
measure_unit(m3,  volume, 1.0e9, "m³").
measure_unit(deg, angle,  1.0,   "°").

measure_fault(Measure, _, _, measure(Measure)) :-
    \+ formed_measure(Measure),
    !.
measure_fault(Measure, Unit, _, unit(Measure, Unit, Units)) :-
    measure(Measure, Dimension),
    \+ measure_unit(Unit, Dimension, _, _),
    !,
    findall(Other, measure_unit(Other, Dimension, _, _), Units).
measure_fault(Measure, _, Tolerance, tolerance(Measure, Tolerance)) :-
    \+ ( number(Tolerance), Tolerance > 0 ).

formed_measure(Measure) :-
    callable(Measure),
    measure(Measure, _),
    !,
    Measure =.. [_|Arguments],
    (   Measure = coordinate(I, Axis)
    ->  segment_number(I),
        along_views(Axis, _)
    ;   maplist(segment_number, Arguments)
    ).
