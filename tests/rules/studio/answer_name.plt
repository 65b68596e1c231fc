/* What an answer is about, by names of lines and parts. */
:- module(test_answer_name, []).
:- use_module(library(plunit)).
:- use_module(rules(studio/answer_name)).

:- begin_tests(answer_name).

test(names, [ forall(member(Goal-Names,
    [ e(1,7,2,3,1)-["s1e7"], v(2,5,0.0,0.0,0.0)-["s2v5"], p(3,4,[1])-["s3p4"],
      segment(2,solid,x)-["s2"], line(4,1,2,3,4,5,6,7,8)-["l4"],
      joint(1,3,7,8,fold,90.0)-["s1j3"],
      screen(2,6,0.0,0.0,1.0)-["s2v6"],
      param(w,3)-[], foo(1,2)-[], x-[],
      e(1,_,2,3,1)-["s1"], e(_,7,2,3,1)-[], line(_,1,2,3,4,5,6,7,8)-[],
      hidden_by(1,7,2,3,0.0,1.0)-["s1e7"],
      hidden_by_polygon(1,7,2,3,0.0,1.0)-["s1e7","s2p3"],
      hidden_by_polygon(1,_,2,3,0.0,1.0)-["s2p3"],
      touches(1,2)-["s1","s2"], touches(1,_)-["s1"],
      volume(3,1.0)-["s3"], area(3,1.0)-["s3"], bounding_box(3,_,_)-["s3"],
      volume(_,1.0)-[] ])),
              true(Found == Names) ]) :-
    shown_names(Goal, Found).
test(inside, [ forall(member(Goal-Names,
    [ (e(1,7,2,3,1),v(1,2,_,_,_))-["s1e7","s1v2"],
      (e(1,7,2,3,1);v(1,2,_,_,_))-["s1e7","s1v2"],
      (e(1,7,2,3,1)->v(1,2,_,_,_))-["s1e7","s1v2"],
      (e(1,7,2,3,1)*->v(1,2,_,_,_))-["s1e7","s1v2"],
      once((segment(2,_,_),segment(1,_,_)))-["s1","s2"],
      (m:segment(2,_,_))-["s2"],
      (segment(2,_,_),segment(2,_,_))-["s2"],
      (_,segment(2,_,_))-["s2"],
      \+segment(2,_,_)-[], findall(x,segment(2,_,_),_)-[] ])),
               true(Found == Names) ]) :-
    shown_names(Goal, Found).

:- end_tests(answer_name).
