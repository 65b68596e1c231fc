:- encoding(utf8).
:- module(test_text_edit, []).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(model/model_text), []).
:- use_module(rules(studio/text_edit)).

/* Where a number stands in a text, and what the text is with another one.
*/

text("% 상관: segment(1, solid, cube(size(9))).
segment(1, solid, box(size(1, -2.5, 3e2))). /* 7 */ param(d, 80).
segment(
  2, solid,  named('a(1, 2)', union([ 1,
     at([translate(0x10, 0'a, -  4)], (5)) ]))).
segment(3,solid,f(-1,-(2),2-3,[1,2|[3]],\"4\")).
param(e, -7).
").

place(Which, Characters) :-
    text(Text),
    number_place(Text, Which, From, To, _),
    Length is To-From,
    sub_string(Text, From, Length, _, Characters).

:- begin_tests(text_edit).

test(places, [forall(member(Which-Characters,
                 [ segment(1, [1,1])-"1", segment(1, [1,2])-"-2.5",
                   segment(1, [1,3])-"3e2", param(d)-"80", param(e)-"-7",
                   segment(2, [2,1,1])-"1",
                   segment(2, [2,1,2,1,1,1])-"0x10",
                   segment(2, [2,1,2,1,1,2])-"0'a",
                   segment(2, [2,1,2,2])-"5",
                   segment(3, [1])-"-1", segment(3, [2,1])-"2",
                   segment(3, [3,1])-"2", segment(3, [3,2])-"3",
                   segment(3, [4,2])-"2"
                 ])),
              true(Got == Characters)]) :-
    place(Which, Got).
test(no_places, [forall(member(Which-Why,
                 [ segment(9, [1])-no_fact(segment(9, [1])),
                   param(f)-no_fact(param(f)),
                   segment(1, [7])-no_path([7]),
                   segment(1, [1,4])-no_path([1,4]),
                   segment(1, [1,1,1])-no_path([1,1,1]),
                   segment(1, [])-no_number([]),
                   segment(1, [1])-no_number([1]),
                   segment(2, [1])-no_number([1]),
                   segment(3, [5])-no_number([5])
                 ])),
                 throws(error(request_error(edit(Why)), _))]) :-
    place(Which, _).
test(replaced, New == "f(12.5, b)") :-
    text_replaced("f(1, b)", 2, 3, 12.5, New).
test(sign_behind_a_symbol, New == "f(2- -3)") :-
    text_replaced("f(2-1)", 4, 5, -3, New).
test(sign, New == "f(-3)") :-
    text_replaced("f(1)", 2, 3, -3, New).

% Whatever is put there is read again at the same place, and the rest of the
% text is as it was.
test(random, [forall(between(1, 200, Seed)), true(Got =:= Value)]) :-
    set_random(seed(Seed)),
    text(Text),
    random_member(Which, [ segment(1, [1,2]), param(d), segment(3, [3,1]),
                           segment(3, [3,2]), segment(2, [2,1,2,2]),
                           segment(3, [4,2]), param(e) ]),
    random_member(Kind, [integer, float]),
    random_between(-1000, 1000, N),
    (   Kind == integer
    ->  Value = N
    ;   Value is N/7.0
    ),
    number_place(Text, Which, From, To, _),
    text_replaced(Text, From, To, Value, New),
    number_place(New, Which, From1, To1, Got),
    sub_string(Text, To, _, 0, After),
    sub_string(New, To1, _, 0, After),
    sub_string(New, 0, From, _, Before),
    sub_string(Text, 0, From, _, Before),
    From1 >= From.


% wished(Text, Wish, New): what fact_place/6 makes of Text.
wished(Text, Wish, New, Fact) :-
    fact_place(Text, Wish, From, To, With, Fact),
    text_replaced(Text, From, To, With, New).

test(wishes, [forall(member(Text-Wish-Wanted,
                 [ ""-wish(1, cut, 7)-"unfolding(1, cut(7)).\n",
                   "a."-wish(1, keep, "base-side(3)")-
                       "a.\nunfolding(1, keep(base-side(3))).\n",
                   "a.\n"-wish(2, cut, "v(3)-v(8)")-
                       "a.\nunfolding(2, cut(v(3)-v(8))).\n",
                   "unfolding(1,keep(7)). % so\nb."-wish(1, cut, 7)-
                       "unfolding(1, cut(7)). % so\nb.",
                   "unfolding(1, cut(7)).\nb."-wish(1, none, 7)-"b.",
                   "a. unfolding(1,cut(top/'x y'-2)) . b.\n"-
                       wish(1, none, "top/'x y'-2")-"a.  b.\n",
                   "unfolding(1, cut(8))."-wish(1, none, 8)-"",
                   "unfolding(1, cut(8)).\n"-wish(1, cut, 7)-
                       "unfolding(1, cut(8)).\nunfolding(1, cut(7)).\n"
                 ])),
              true(New == Wanted)]) :-
    wished(Text, Wish, New, _).
test(no_wish, throws(error(request_error(edit(no_wish(1, 7))), _))) :-
    wished("unfolding(2, cut(7)).", wish(1, none, 7), _, _).
test(questions, [forall(member(Text-Question-Wanted,
                    [ ""-question("all", "line(L)")-
                          "question(all, 'line(L)').\n",
                      "a."-question("몇 줄", "v(1,V,_,_,_),V\\==2")-
                          "a.\nquestion('몇 줄', 'v(1,V,_,_,_),V\\\\==2').\n",
                      "question(\"all\", \"a\"). % so\nb."-question("all", "c")-
                          "question(all, c). % so\nb.",
                      "question(a, x).\nquestion(b, y).\n"-
                          question("a", none)-"question(b, y).\n",
                      "question(7, x).\n"-question("7", "y")-
                          "question(7, x).\nquestion('7', y).\n"
                    ])),
                 true(New == Wanted)]) :-
    wished(Text, Question, New, _).
test(no_question, throws(error(request_error(edit(no_question(a))), _))) :-
    wished("question(b, c).", question("a", none), _, _).
test(no_edge, [forall(member(Edge, ["X", "(", "f(X)"])),
               throws(error(request_error(edit(no_edge(Edge))), _))]) :-
    wished("", wish(1, cut, Edge), _, _).

:- end_tests(text_edit).
