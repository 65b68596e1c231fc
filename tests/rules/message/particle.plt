:- encoding(utf8).
:- module(test_particle, []).
:- use_module(library(plunit)).
:- use_module(rules(message/particle)).

/* Particles after numbers, names, files and remarks, as they are read. */

spoken("꼭짓점", '은(는)', "은").
spoken("모서리", '은(는)', "는").
spoken("칼", '(으)로', "로").
spoken("상관선", '(으)로', "으로").
spoken("0", '은(는)', "은").
spoken("1", '이(가)', "이").
spoken("1", '(으)로', "로").
spoken("2", '이(가)', "가").
spoken("3", '과(와)', "과").
spoken("4", '과(와)', "와").
spoken("5", '을(를)', "를").
spoken("6", '(으)로', "으로").
spoken("7", '(으)로', "로").
spoken("8", '은(는)', "은").
spoken("9", '은(는)', "는").
spoken("10", '(으)로', "으로").
spoken("100", '은(는)', "은").
spoken("1,066", '은(는)', "은").
spoken("1,000", '(으)로', "으로").
spoken("1000000000000", '은(는)', "는").
spoken("10000000000000000", '은(는)', "은").
spoken("0.35", '은(는)', "는").
spoken("1.0", '은(는)', "은").
spoken("2.5e-9", '은(는)', "는").
spoken("1:3", '(으)로', "으로").
spoken("20:1", '은(는)', "은").
spoken("-7", '이(가)', "이").
spoken("1-2", '이(가)', "가").
spoken("1/50", '(이)라', "이라").
spoken("1:2", '(이)라', "라").
spoken("세그먼트 1 (box)", '과(와)', "과").
spoken("세그먼트 2 (box)", '과(와)', "와").
spoken("다각형 4 (삼각형 2-3-7 안)", '을(를)', "를").
spoken("실장(실제 길이)", '을(를)', "을").
spoken("0.35 mm", '은(는)', "는").
spoken("3 cm", '은(는)', "는").
spoken("100mm", '은(는)', "는").
spoken("90°", '은(는)', "는").
spoken("12 %", '은(는)', "는").
spoken("A4", '이(가)', "가").
spoken("A3", '이(가)', "이").
spoken("u.svg", '을(를)', "를").
spoken("x.stl", '을(를)', "을").
spoken("b.pl", '(으)로', "로").
spoken("c.json", '을(를)', "을").
spoken("a.off", '은(는)', "는").
spoken("STL", '은(는)', "은").
spoken("PDF", '은(는)', "는").
spoken("N", '은(는)', "은").
spoken("X", '은(는)', "는").
spoken("Prolog", '은(는)', "는").
spoken("받침대", '은(는)', "는").
spoken("\"몸통\"", '이(가)', "이").
spoken("'뚜껑'", '은(는)', "은").
spoken("foo/1", '이(가)', "이").
spoken("v/5", '은(는)', "는").
spoken("--scale", '은(는)', "은").
spoken("--scale", '(으)로', "로").
spoken("box", '이(가)', "가").
spoken("torus(radius(2),tube(3))", '은(는)', "은").
spoken("v(2)", '을(를)', "를").
spoken("R", '은(는)', "은").
spoken("A_R", '은(는)', "은").
spoken("base-", '은(는)', "는").
spoken("line(_)", '은(는)', "은").
spoken("curved(side)", '을(를)', "를").
spoken("cone", '은(는)', "은").
spoken("plane", '(으)로', "으로").
spoken("frame", '을(를)', "을").
spoken("handle", '(으)로', "로").
spoken("curve", '(이)라', "라").
spoken("bend", '이(가)', "가").
spoken("flange", '이(가)', "가").
spoken("cylinder", '은(는)', "는").
spoken("panel", '과(와)', "과").
spoken("ring", '을(를)', "을").
spoken("leg", '을(를)', "를").
spoken("block", '이(가)', "이").
spoken("tank", '이(가)', "가").
spoken("lip", '이(가)', "이").
spoken("loop", '이(가)', "가").
spoken("slot", '은(는)', "은").
spoken("sheet", '은(는)', "는").
spoken("part", '은(는)', "는").
spoken("stem", '은(는)', "은").
spoken("elbow", '은(는)', "는").
spoken("Top", '은(는)', "은").
spoken("foo_bar", '은(는)', "는").
spoken("leg2", '은(는)', "는").
% Where nothing can be read both forms stay.
spoken("}", '은(는)', "은(는)").
spoken("", '은(는)', "은(는)").

:- begin_tests(particle).

test(form, [ forall(spoken(Word, Both, Form)), Found == Form ]) :-
    particle(Word, Both, Found).
test(text, T == "세그먼트 2는 곡선이라 box가 3과 만납니다") :-
    particles_joined("세그먼트 2 은(는) 곡선(이)라 box 이(가) 3와(과) 만납니다",
                     T).
test(remark, T == "다각형 4 (옆면)를 자르고 1 (보기)로 갑니다") :-
    particles_joined("다각형 4 (옆면) 을(를) 자르고 1 (보기) (으)로 갑니다", T).
test(nothing_before, T == "은(는) 앞에 없습니다") :-
    particles_joined("은(는) 앞에 없습니다", T).
test(none, T == "f(은) 그대로") :-
    particles_joined("f(은) 그대로", T).
test(lines, Lines == ['~w'-["모서리 3을 자르고"], nl, '~w'-["  2로 갑니다"]]) :-
    lines_joined(['모서리 ~d'-[3], ' 을(를) ', '자르고', nl, '  ~w'-[2],
                  '(으)로 갑니다'], Lines).
test(variables, Lines-V == ['~w'-["line(_)은 없습니다"]]-unbound) :-
    lines_joined(['~p은(는) 없습니다'-[line(X)]], Lines),
    ( var(X) -> V = unbound ; V = bound ).
test(lines_kept, Lines == [nl, ansi(bold, "~w", [a]), '~w'-["x"]]) :-
    lines_joined([nl, ansi(bold, "~w", [a]), 'x'], Lines).

:- end_tests(particle).
