/* What a row of a second file is called in the world: 10 segments and 100 lines
   are there already. */
:- module(test_shifted, []).
:- use_module(library(plunit)).
:- use_module(rules(model/shifted)).

%   shifts(Fact, Row): each relation, and each kind of reference in it.

shifts(v(1,2,3.0,4.0,5.0), v(11,2,3.0,4.0,5.0)).
shifts(e(1,2,3,4,1), e(11,2,3,4,1)).
shifts(p(1,2,[3,4]), p(11,2,[3,4])).
shifts(t(1,2,3,4,5,6), t(11,2,3,4,5,6)).
shifts(line(1,2,3,4,5,6,7,8,9), line(101,12,3,4,5,16,7,8,9)).
shifts(origin(1,v(2),v(3,4)), origin(11,v(2),v(13,4))).
shifts(origin(1,s(1),line(7)), origin(11,s(11),line(107))).
shifts(origin(1,s(2),copy), origin(11,s(2),copy)).
shifts(origin(1,v(9),lpi(1-(2,3),4-(5,6,7))),
       origin(11,v(9),lpi(11-(2,3),14-(5,6,7)))).
shifts(origin(1,v(9),ll(1-(2,3),4-(5,6))),
       origin(11,v(9),ll(11-(2,3),14-(5,6)))).
shifts(origin(1,v(9),tpi(1-(2,3,4),4-(5,6,7),plane(8))),
       origin(11,v(9),tpi(11-(2,3,4),14-(5,6,7),plane(8)))).
shifts(origin(1,v(9),on(p,[1-e(2)])), origin(11,v(9),on(p,[1-e(2)]))).
shifts(from_v(1,2,3,4), from_v(11,2,13,4)).
shifts(from_p(1,2,3,4,+), from_p(11,2,13,4,+)).
shifts(from_r(1,2,3,4), from_r(11,2,13,4)).
shifts(region(1,2,cell), region(11,2,cell)).
shifts(look(1,colour(red)), look(11,colour(red))).
shifts(gluing(1,apart(2,3)), gluing(11,apart(12,13))).
shifts(gluing(1,apart([2,4],3)), gluing(11,apart([12,14],13))).
shifts(gluing(1,apart(2-e(3))), gluing(11,apart(12-e(3)))).
shifts(gluing(1,glued(2-p(3),4-p(5))), gluing(11,glued(12-p(3),14-p(5)))).
shifts(gluing(1,dissolve(region([2]),region([2,3],1))),
       gluing(11,dissolve(region([12]),region([12,13],1)))).
shifts(gluing(1,dissolve(outside,region([2]))),
       gluing(11,dissolve(outside,region([12])))).
shifts(gluing(1,materials), gluing(11,materials)).
shifts(segment(1,solid,sphere(radius(2))), segment(11,solid,sphere(radius(2)))).
shifts(segment(3,solid,union([1,2])), segment(13,solid,union([11,12]))).
shifts(segment(3,solid,difference([1,union([2,sphere(radius(1))])])),
       segment(13,solid,difference([11,union([12,sphere(radius(1))])]))).
shifts(segment(2,pattern,development(1)), segment(12,pattern,development(11))).
shifts(segment(4,surface,trimmed(1,outside,[2,3])),
       segment(14,surface,trimmed(11,outside,[12,13]))).
shifts(view(1,2,3), view(1,2,3)).       % not of a segment
shifts(projection(1), projection(1)).
shifts(title_block(1,2), title_block(1,2)).
shifts(param(1,2), param(1,2)).
shifts(param_about(1,2), param_about(1,2)).
shifts(light(1,2), light(1,2)).
shifts(question(1,2), question(1,2)).

%   told(Fault, Own): Fault, of the world, as the file has it.

told(missing(v,11,5), missing(v,1,5)).
told(twice(e,[11,5]), twice(e,[1,5])).
told(twice(view,[front]), twice(view,[front])).
told(polygon(11,2,open), polygon(1,2,open)).
told(chain(11,2), chain(1,2)).
told(no_vertices(11,surface), no_vertices(1,surface)).
told(no_edges(11), no_edges(1)).
told(csg(missing(13)), csg(missing(3))).
told(csg(cycle([13,14])), csg(cycle([3,4]))).
told(csg(too_many(12,9)), csg(too_many(2,9))).
told(csg(empty), csg(empty)).
told(arity(v,3), arity(v,3)).

:- begin_tests(shifted).

test(row, [forall(shifts(Fact, Row)), true(Is == Row)]) :-
    shifted(shift(10, 100), Fact, Is).
test(first_file, [forall(shifts(Fact, _)), true(Is == Fact)]) :-
    shifted(shift(0, 0), Fact, Is).
test(told, [ forall(told(Fault, Own)),
             throws(error(model_error(Own), location('a.pl',3,4))) ]) :-
    own_numbers(Fault, location('a.pl',3,4), shift(10, 100)).

:- end_tests(shifted).
