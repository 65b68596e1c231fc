/* Which looks and lights there are, to the last value of each range. */
:- module(test_look_term, []).
:- use_module(library(plunit)).
:- use_module(rules(model/look_term)).

look(colour(red)).
look(colour(rgb(0,255,7))).
look(opacity(0)).
look(opacity(0.5)).
look(opacity(1)).
look(opacity(1.0)).
look(shine(0,1)).
look(shine(1,1000)).
look(face(top,opacity(1))).
look(face(curved(side),colour(blue))).

no_look(colour(reddish)).
no_look(colour(rgb(0,256,7))).
no_look(colour(7)).
no_look(colour(_)).
no_look(opacity(-0.001)).
no_look(opacity(1.001)).
no_look(opacity(half)).
no_look(shine(0.5,0)).
no_look(shine(0.5,1001)).
no_look(shine(0.5,4.0)).
no_look(shine(-0.001,4)).
no_look(shine(1.001,4)).
no_look(face(7,opacity(1))).
no_look(face(top,face(top,opacity(1)))).
no_look(face(top,opacity(2))).
no_look(glow(1)).

light(strength(0)).
light(strength(10)).
light(picture(0,0,-0.5)).
light(direction(1,0,0)).
light(direction(0,1.0e90,-1.0e90)).

no_light(strength(-0.001)).
no_light(strength(10.001)).
no_light(strength(much)).
no_light(picture(0,0.0,0)).
no_light(picture(0,0,up)).
no_light(direction(0,1.1e90,0)).
no_light(direction(0,0,-1.1e90)).
no_light(direction(1,2)).
no_light(colour(red)).

expected(colour(7), colour).
expected(opacity(x), opacity).
expected(shine(1,2), shine).
expected(face(top,shine(1,0)), shine).
expected(face(top,glow(1)), any).
expected(face(top,_), any).
expected(_, any).
expected(glow(1), any).
expected(strength(x), strength).
expected(picture(0,0,0), way).
expected(direction(0,0,0), way).

slot(colour(red), colour).
slot(shine(1,2), shine).
slot(face(top,opacity(1)), face(top,opacity)).
slot(strength(1), strength).
slot(picture(1,2,3), direction).
slot(direction(1,2,3), direction).

:- begin_tests(look_term).

test(look, [forall(look(Property))]) :-
    is_look(Property).
test(no_look, [forall(no_look(Property)), fail]) :-
    is_look(Property).
test(light, [forall(light(Property))]) :-
    is_light(Property).
test(no_light, [forall(no_light(Property)), fail]) :-
    is_light(Property).
test(not_a_number, [fail]) :-
    Nan is nan,
    is_light(direction(1,Nan,0)).
test(expected, [forall(expected(Property, Expected)), true(Is == Expected)]) :-
    look_expected(Property, Is).
test(slot, [forall(slot(Property, Slot)), true(Is == Slot)]) :-
    property_slot(Property, Is).

:- end_tests(look_term).
