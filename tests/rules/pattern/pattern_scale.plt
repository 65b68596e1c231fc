:- module(test_pattern_scale, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(pattern/pattern_scale)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).

:- meta_predicate quietly(0).

quietly(Goal) :-
    setup_call_cleanup(
        asserta((user:message_hook(_, Kind, _) :-
                     memberchk(Kind, [warning,informational])), Ref),
        Goal,
        erase(Ref)).

% The scale and the number of sheets of a box laid flat.
scaled_box(Size, Options, Scale, Sheets) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(Size), S),
               develop(S, D),
               quietly(pattern_drawing([D], Options, Drawings)) )),
    Drawings = [drawing(sheet(_,_,Scale),_)|_],
    length(Drawings, Sheets).

:- begin_tests(pattern_scale).

test(height, Scale =:= 50.0) :-
    scaled_box(size(3,2,4), [height(200)], Scale, _).
test(height_along_another_axis, Scales == [40.0,100.0]) :-
    findall(Scale,
            ( member(Axis, [x,y]),
              scaled_box(size(5,2,4), [height(200),up(Axis)], Scale, _) ),
            Scales).
test(height_says_more_than_scale, Scale =:= 50.0) :-
    scaled_box(size(3,2,4), [scale(1:7),unit(m),height(200)], Scale, _).
test(flat_has_none, error(usage_error(pattern(no_height)))) :-
    new_world(World),
    in_world(World, height_scale([], z, 100, _)).
% A cross of four by three on A4 with 190 x 268 mm for it: 190/3.
test(fit, Sheets == 1) :-
    scaled_box(size(1,1,1), [fit(true)], Scale, Sheets),
    assertion(( Scale > 0.99*190/3, Scale =< 190/3 )).
% What joins it may stand at each end of the shorter side: nothing is divided.
test(fit_with_joints, [ forall(member(Joint-Deep,
                                      [tabs(5)-5,lap(5)-5,lock(4)-6])),
                        Sheets == 1 ]) :-
    scaled_box(size(1,1,1), [fit(true),Joint], Scale, Sheets),
    Best is (190-2*Deep)/3,
    assertion(( Scale > 0.99*Best, Scale =< Best )).
% With more pages it is larger, and a tenth larger still takes more of them.
test(pages, [forall(member(N, [1,2,5])), true(Sheets =< N)]) :-
    scaled_box(size(1,1,1), [pages(N)], Scale, Sheets),
    Larger is Scale*1.25,
    scaled_box(size(1,1,1), [scale(Larger),page('A4')], _, More),
    assertion(More > N).
test(pages_with_a_lap, true(Sheets =< 2)) :-
    scaled_box(size(1,1,1), [pages(2),lap(20)], _, Sheets).
test(no_room_for_joints,
     [ forall(member(Joint-Option-Most, [ tabs(100)-'--tabs'-47,
                                          lap(95)-'--lap'-47,
                                          lock(64)-'--lock-seam'-31 ])),
       error(usage_error(pattern(wide(Option,_,Most,190.0-268.0)))) ]) :-
    scaled_box(size(1,1,1), [fit(true),Joint], _, _).
test(texts, Texts == ["1:2","70:1","1:2.5"]) :-
    findall(Text, ( member(Scale, [1:2,70,0.4]), scale_text(Scale, Text) ),
            Texts).

:- end_tests(pattern_scale).
