:- encoding(utf8).
/* What may stand in a problem and in a sheet, to the last value of each range;
   and what is wrong with the rest. */
:- module(test_problem_item, []).
:- use_module(library(plunit)).
:- use_module(rules(problem/problem_item)).

item(problem, given([front,top,right,left,back,bottom])).
item(problem, blank(left)).
item(problem, hide(penetration)).
item(problem, show(penetration)).
item(problem, branch(1)).
item(problem, generators(2)).
item(problem, generators(360)).
item(problem, edges(all)).
item(problem, planes(x)).
item(problem, planes(straight)).
item(problem, planes(z, 1)).
item(problem, planes(z, 60)).
item(problem, ask(draw(penetration))).
item(problem, ask(draw(penetration, [top]))).
item(problem, ask(count(loops))).
item(problem, ask(develop(1))).
item(problem, part(1, ko, '관')).
item(problem, text(en, 'Draw.')).
item(problem, ask(measure(shortest_generator(1), m, 0.001))).
item(problem, ask(measure(coordinate(1, z), cm, 1))).
item(problem, ask(measure(angle(1,2,3,4), deg, 1))).
item(sheet, fields([a,b,c,d])).
item(sheet, angle(first)).
item(sheet, angle(third)).
item(sheet, title_block(date, today)).

%   no_item(Kind, Item): Item is wrong as a whole.

no_item(problem, given([])).
no_item(problem, given(front)).
no_item(problem, given([front,inside])).
no_item(problem, given([isometric])).
no_item(problem, blank(isometric)).
no_item(problem, blank([front])).
no_item(problem, hide(lines)).
no_item(problem, branch(0)).
no_item(problem, branch(1.0)).
no_item(problem, generators(1)).
no_item(problem, generators(361)).
no_item(problem, generators(12.0)).
no_item(problem, edges(some)).
no_item(problem, planes(w)).
no_item(problem, planes(straight, 3)).
no_item(problem, planes(z, 0)).
no_item(problem, planes(z, 61)).
no_item(problem, planes(z, 2.0)).
no_item(problem, ask(draw(penetration, []))).
no_item(problem, ask(count(points))).
no_item(problem, ask(develop(-1))).
no_item(problem, part(1, de, 'Rohr')).
no_item(problem, part(0, en, pipe)).
no_item(problem, text(en, "text")).
no_item(problem, angle(first)).
no_item(sheet, fields([])).
no_item(sheet, fields([a,b,c,d,e])).
no_item(sheet, fields([1])).
no_item(sheet, angle(second)).
no_item(sheet, title_block(date, "today")).
no_item(sheet, given([front])).

%   measured(Measure, Unit, Tolerance, What): what is wrong with asking that.

measured(weight(1), mm, 1, measure(weight(1))).
measured(area(0), mm2, 1, measure(area(0))).
measured(edge(1,2), mm, 1, measure(edge(1,2))).
measured(coordinate(1,w), mm, 1, measure(coordinate(1,w))).
measured(coordinate(x,z), mm, 1, measure(coordinate(x,z))).
measured(7, mm, 1, measure(7)).
measured(area(1), mm, 1, unit(area(1), mm, [mm2,cm2,m2])).
measured(volume(1), mm2, 1, unit(volume(1), mm2, [mm3,cm3,m3])).
measured(perimeter(1), deg, 1, unit(perimeter(1), deg, [mm,cm,m])).
measured(sector(1), mm, 1, unit(sector(1), mm, [deg])).
measured(area(1), mm2, 0, tolerance(area(1), 0)).
measured(area(1), mm2, none, tolerance(area(1), none)).

%   together(Items, What): what is wrong with Items that are right each.

together([given([top]),blank(top)], all_blank).
together([blank(front),blank(top)], all_blank).
together([given([front]),ask(measure(coordinate(1,x),mm,1))],
         no_view(coordinate(1,x), [right,left])).
together([given([top]),ask(measure(coordinate(1,y),mm,1))],
         no_view(coordinate(1,y), [front,back])).
together([given([front]),ask(measure(coordinate(1,z),mm,1))],
         no_view(coordinate(1,z), [top,bottom])).
together([blank(top),ask(measure(coordinate(1,z),mm,1))],
         no_view(coordinate(1,z), [top,bottom])).
together([ask(draw(penetration,[front,right]))], not_given(right, [front,top])).
together([show(penetration),hide(penetration)], shown_and_asked).
together([show(penetration),ask(draw(penetration))], shown_and_asked).
together([show(penetration),ask(draw(penetration,[top]))], shown_and_asked).

%   whole(Items, Names, Blank, Drawn): right ones, and their views.

whole([], [front,top], [], [front,top]).
whole([given([top,left,top]),blank(back)], [top,left,back], [back],
      [top,left,back]).
whole([blank(top)], [front,top], [top], [front,top]).
whole([ask(draw(penetration,[top]))], [front,top], [], [top]).
whole([show(penetration),ask(count(loops))], [front,top], [], [front,top]).
whole([given([bottom]),ask(measure(coordinate(1,z),mm,1))], [bottom], [],
      [bottom]).

unit(mm,  length, 1,     "mm").
unit(cm,  length, 10,    "cm").
unit(m,   length, 1000,  "m").
unit(mm2, area,   1,     "mm²").
unit(cm2, area,   10**2, "cm²").
unit(m2,  area,   10**6, "m²").
unit(mm3, volume, 1,     "mm³").
unit(cm3, volume, 10**3, "cm³").
unit(m3,  volume, 10**9, "m³").
unit(deg, angle,  1,     "°").

:- begin_tests(problem_item).

test(item, [forall(item(Kind, Item)), fail]) :-
    item_fault(Kind, Item, _).
test(no_item, [forall(no_item(Kind, Item)), true(What == item(Item))]) :-
    item_fault(Kind, Item, What).
test(measured, [ forall(measured(Measure, Unit, Tolerance, Wrong)),
                 true(What == Wrong) ]) :-
    item_fault(problem, ask(measure(Measure,Unit,Tolerance)), What).
test(together, [forall(together(Items, Wrong)), true(What == Wrong)]) :-
    items_fault(Items, What).
test(nothing_wrong, [forall(whole(Items, _, _, _)), fail]) :-
    items_fault(Items, _).
test(views, [ forall(whole(Items, Names, Blank, Drawn)),
              true([Names1,Blank1,Drawn1] == [Names,Blank,Drawn]) ]) :-
    item_views(Items, Names1, Blank1),
    drawn_views(Items, Drawn1).
test(unit, [ forall(unit(Unit, Dimension, Of, Word)),
             true(Dimension1-Word1 == Dimension-Word) ]) :-
    measure_unit(Unit, Dimension1, Size, Word1),
    Size =:= Of.
test(units, [true(Us == [mm,cm,m,mm2,cm2,m2,mm3,cm3,m3,deg])]) :-
    findall(U, measure_unit(U, _, _, _), Us).
test(title, [true(Items-Same == [fields([name,class])]-[angle(first)])]) :-
    title_items(title_block([name,class]), Items),
    title_items(angle(first), Same).

:- end_tests(problem_item).
