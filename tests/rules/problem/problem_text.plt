:- encoding(utf8).
/* What a pupil reads: each question and each reason, word for word, in both
   languages. */
:- module(test_problem_text, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(problem/problem_explanation)).
:- use_module(rules(problem/problem_text)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(sheet/lettering)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   world(Name, Terms): segments 1, 2, ...

world(tee, [ at([rotate(y,90),translate(-10,0,0)],
                cylinder(radius(4), height(20))),
             cylinder(radius(2), height(10)) ]).
world(three, [ cylinder(radius(4), height(20)),
               at([rotate(x,30)], cylinder(radius(2), height(10))),
               at([rotate(x,90)], cone(radius(2), height(10))) ]).
world(alike, [ sphere(radius(3)), sphere(radius(2)),
               at([rotate(y,90)], cone(radius(2), height(10))),
               at([rotate(x,90)], cone(radius(1), height(10))) ]).
world(pierced, [line(from(0,0,0), to(9,9,9)), box(size(4,4,4))]).
world(cone, [cone(radius(3), height(4))]).
world(box, [box(size(2,3,6))]).
world(one(Term), [Term]).

:- meta_predicate modelled(+, 0).

modelled(Name, Goal) :-
    world(Name, Terms),
    in_new_world(( forall(member(Term, Terms), added(Term)),
                   complete_segments,
                   call(Goal) )).

added(Term) :-
    (   Term = difference(_, _)
    ->  assert_fact(segment(1, solid, Term))
    ;   add_primitive(Term, _)
    ).

sentence(World, Task, Items, Language, Sentence) :-
    modelled(World, task_sentence(Task, Items, Language, Sentence)).


%   task(World, Ask, Items, Letters, Rank, En, Ko)

task(tee, blank(right), [], "", none,
     "Draw the right-side view in its frame.",
     "빈칸에 우측면도를 그려라.").
task(tee, ask(draw(penetration)), [], "", none,
     "Draw the penetration line of the lying cylinder and the upright \c
      cylinder.",
     "수평 원기둥과 수직 원기둥의 상관선을 그려라.").
task(tee, ask(draw(penetration, [front,top])), [], "", none,
     "Draw the penetration line of the lying cylinder and the upright \c
      cylinder in the front view and the top view.",
     "정면도와 평면도에 수평 원기둥과 수직 원기둥의 상관선을 그려라.").
task(tee, ask(draw(penetration, [left,back,bottom])),
     [part(2, en, stub), part(2, ko, '관')], "", none,
     "Draw the penetration line of the lying cylinder and the stub in the \c
      left-side view, the rear view and the bottom view.",
     "좌측면도, 배면도와 저면도에 수평 원기둥과 관의 상관선을 그려라.").
task(three, ask(draw(penetration)), [], "", none,
     "Draw the penetration line of the upright cylinder, the leaning cylinder \c
      and the cone.",
     "수직 원기둥, 기울어진 원기둥과 원뿔의 상관선을 그려라.").
task(alike, ask(draw(penetration)), [], "", none,
     "Draw the penetration line of sphere 1, sphere 2, cone 3 and cone 4.",
     "구 1, 구 2, 원뿔 3 및 원뿔 4의 상관선을 그려라.").
task(pierced, ask(draw(penetration, [right])), [], "", none,
     "Find the points where the straight line goes through the box in the \c
      right-side view.",
     "우측면도에 직선과 직육면체의 교점을 구하여라.").
task(pierced, ask(draw(penetration)), [part(1, ko, 'L')], "", none,
     "Find the points where the straight line goes through the box.",
     "L 및 직육면체의 교점을 구하여라.").
task(tee, ask(count(loops)), [], "", none,
     "How many closed lines does the penetration line consist of?",
     "상관선은 몇 개의 닫힌 선으로 이루어지는가?").
task(tee, ask(develop(2)), [], "", none,
     "Draw the pattern of the upright cylinder, cut along the penetration \c
      line.",
     "상관선을 따라 잘라 낸 수직 원기둥의 전개도를 그려라.").
task(cone, ask(develop(1)), [], "", none,
     "Draw the pattern of the cone.", "원뿔의 전개도를 그려라.").
task(pierced, ask(develop(2)), [], "", none, % no body trims it
     "Draw the pattern of the box.", "직육면체의 전개도를 그려라.").
task(World, ask(measure(Measure, mm, 0.1)), Items, Letters, Rank, En, Ko) :-
    measure(Measure, World, Items, Letters, Rank, En, Ko).

measure(edge(1,1,2), tee, [], "AB", none,
        "What is the true length of AB?", "AB의 실장(실제 길이)은?").
measure(angle(1,1,2,3), tee, [], "ABC", none,
        "What is the true angle ABC?", "각 ABC의 실제 크기는?").
measure(generator(2,1), tee, [], "A", none,
        "How long is the generator from A to the penetration line?",
        "A에서 상관선까지 면소의 실장(실제 길이)은?").
measure(generator(1,1), cone, [], "A", none,
        "How long is the generator that begins in A?",
        "A에서 시작하는 면소의 실장(실제 길이)은?").
measure(shortest_generator(2), tee, [], "", none,
        "Of the 12 generators in the pattern of the upright cylinder, how \c
         long is the shortest?",
        "수직 원기둥의 전개도에서 면소 12개 중 가장 짧은 것의 실장(실제 길이)은?").
measure(longest_generator(2), tee, [generators(8)], "", none,
        "Of the 8 generators in the pattern of the upright cylinder, how long \c
         is the longest?",
        "수직 원기둥의 전개도에서 면소 8개 중 가장 긴 것의 실장(실제 길이)은?").
measure(coordinate(1,x), tee, [], "A", none,
        "A lies on the penetration line. How far is it to the right of the \c
         leftmost point of the solids?",
        "점 A는 상관선 위에 있다. 입체의 가장 왼쪽 점에서 오른쪽으로 얼마나 \c
         떨어져 있는가?").
measure(coordinate(1,x), tee, [], "A", 1-2,
        "A lies on the penetration line. How far is it to the right of the \c
         leftmost point of the solids? (Of the 2 points seen there, number 1 \c
         from the left.)",
        "점 A는 상관선 위에 있다. 입체의 가장 왼쪽 점에서 오른쪽으로 얼마나 \c
         떨어져 있는가? (겹쳐 보이는 2점 중 왼쪽에서 1번째)").
measure(coordinate(1,y), tee, [], "A", 2-3,
        "A lies on the penetration line. How far is it behind the foremost \c
         point of the solids? (Of the 3 points seen there, number 2 from the \c
         front.)",
        "점 A는 상관선 위에 있다. 입체의 가장 앞쪽 점에서 뒤쪽으로 얼마나 \c
         떨어져 있는가? (겹쳐 보이는 3점 중 앞쪽에서 2번째)").
measure(coordinate(1,z), tee, [], "A", 1-2,
        "A lies on the penetration line. How far is it above the lowest point \c
         of the solids? (Of the 2 points seen there, number 1 from below.)",
        "점 A는 상관선 위에 있다. 입체의 가장 아래쪽 점에서 위쪽으로 얼마나 \c
         떨어져 있는가? (겹쳐 보이는 2점 중 아래쪽에서 1번째)").
measure(area(2), tee, [], "", none,
        "What is the area of the pattern of the upright cylinder?",
        "수직 원기둥 전개도의 넓이는?").
measure(perimeter(2), tee, [], "", none,
        "How long is the outline of the pattern of the upright cylinder?",
        "수직 원기둥 전개도의 둘레는?").
measure(sector(1), cone, [], "", none,
        "What is the angle of the sector that the cone unrolls to?",
        "원뿔 전개도의 부채꼴 중심각은?").
measure(volume(2), tee, [], "", none,
        "What is the volume of the upright cylinder before it is cut?",
        "자르기 전 수직 원기둥의 부피는?").
measure(volume(1), cone, [], "", none,
        "What is the volume of the cone?", "원뿔의 부피는?").

%   called(Term, En, Ko): what a segment alone is called.

called(line(from(0,0,0), to(1,0,0)), "the straight line", "직선").
called(circle(radius(2)), "the disc", "원판").
called(rectangle(size(2,3)), "the rectangle", "직사각형").
called(ellipse(radius(2,3)), "the ellipse", "타원판").
called(box(size(1,2,3)), "the box", "직육면체").
called(hollow_cylinder(radius(2), inner(1), height(3)), "the hollow cylinder",
       "속이 빈 원기둥").
called(hemisphere(radius(2)), "the hemisphere", "반구").
called(torus(radius(4), tube(1)), "the torus", "원환체").
called(prism(outline([[0,0],[1,0],[0,1]]), height(2)), "the prism", "각기둥").
called(pyramid(base(2,3), height(2)), "the pyramid", "각뿔").
called(difference(box(size(2,2,2)), sphere(radius(1))), "solid 1", "입체 1").

%   lines(Tasks, Items, Language, Width, Lines)

lines([line,loops(none),edge(none)], [], en, 100,
      [ "(1) Draw the penetration line of the lying",
        "cylinder and the upright cylinder in the", "front view.",
        "(2) How many closed lines does the",
        "penetration line consist of? ______",
        "(3) What is the true length of AB?", "________ cm (±0.5)" ]).
lines([line,loops("2"),edge("12.5 cm")], [], en, 100,
      [ "(1) Draw the penetration line of the lying",
        "cylinder and the upright cylinder in the", "front view.",
        "(2) How many closed lines does the",
        "penetration line consist of? 2",
        "(3) What is the true length of AB?", "12.5 cm (±0.5)" ]).
lines([line,loops(none),edge(none)], [], ko, 100,
      [ "(1) 정면도에 수평 원기둥과 수직 원기둥의", "상관선을 그려라.",
        "(2) 상관선은 몇 개의 닫힌 선으로", "이루어지는가? ______개",
        "(3) AB의 실장(실제 길이)은?", "________ cm (±0.5)" ]).
lines([loops("2")], [], ko, 300,
      ["상관선은 몇 개의 닫힌 선으로 이루어지는가? 2개"]).
lines([line,loops(none)], [text(en,'Own words')], en, 300,
      [ "Own words (In the front view.)",
        "How many closed lines does the penetration line consist of? ______" ]).
lines([line,loops(none)], [text(ko,'제목')], ko, 300,
      [ "제목 (정면도에 그린다.)",
        "상관선은 몇 개의 닫힌 선으로 이루어지는가? ______개" ]).
lines([everywhere,loops(none)], [text(en,'Own words')], en, 300,
      [ "Own words",
        "How many closed lines does the penetration line consist of? ______" ]).
lines([loops(none)], [text(en,'Only English')], ko, 300,
      ["Only English", "상관선은 몇 개의 닫힌 선으로 이루어지는가? ______개"]).

task_named(line, task(ask(draw(penetration, [front])), "", none, none)).
task_named(everywhere, task(ask(draw(penetration)), "", none, none)).
task_named(loops(Answer), task(ask(count(loops)), "", none, Answer)).
task_named(edge(Answer), task(ask(measure(edge(1,1,2), cm, 0.5)), "AB", none,
                              Answer)).

%   why(World, Points, N, Ask, En, Ko): what the answer, "7", comes from.

why(tee, [1-1,2-1,3-1,4-2,5-0], 12, ask(count(loops)),
    "Followed from point to point, each line comes back to where it began: \c
     points 1–3; 4.",
    "점을 차례로 따라가면 선마다 처음 점으로 돌아온다: 점 1–3; 4.").
why(tee, [5-0], 12, ask(count(loops)), "", ""). % none closes
why(tee, [], 4, ask(measure(volume(2), mm3, 0.1)), "", "").
why(box, [], 4, ask(measure(edge(1,1,7), cm, 0.05)),
    "Along x, y and z it is 0.200, 0.300 and 0.600: √((0.200)² + (0.300)² + \c
     (0.600)²) = 7.",
    "x, y, z 방향의 길이가 0.200, 0.300, 0.600이다. √((0.200)² + (0.300)² + \c
     (0.600)²) = 7.").
why(box, [], 4, ask(measure(angle(1,2,1,7), deg, 0.1)),
    "The sides run (2.00, 0.00, 0.00) and (2.00, 3.00, 6.00) from their \c
     corner. The cosine of their angle is 0.2857, so it is 7.",
    "꼭짓점에서 두 변의 방향은 (2.00, 0.00, 0.00), (2.00, 3.00, 6.00)이다. \c
     코사인이 0.2857이므로 각은 7.").
why(tee, [], 4, ask(measure(shortest_generator(2), mm, 0.1)),
    "The true lengths of the generators are (1: 6.00, 2: 6.54, 3: 6.00, \c
     4: 6.54): number 1 is the shortest, 7.",
    "면소의 실장(실제 길이)은 (1: 6.00, 2: 6.54, 3: 6.00, 4: 6.54)이다. 가장 \c
     짧은 것은 1번이고 7.").
why(tee, [], 4, ask(measure(longest_generator(2), cm, 1)),
    "The true lengths of the generators are (1: 0.6, 2: 0.7, 3: 0.6, 4: 0.7): \c
     number 2 is the longest, 7.",
    "면소의 실장(실제 길이)은 (1: 0.6, 2: 0.7, 3: 0.6, 4: 0.7)이다. 가장 긴 \c
     것은 2번이고 7.").
why(cone, [], 4, ask(measure(sector(1), deg, 1)),
    "The base has the radius 3.0, and generators are 5.0 long: 360° · 3.0 / \c
     5.0 = 7.",
    "밑면의 반지름은 3.0, 면소의 길이는 5.0이다. 360° · 3.0 / 5.0 = 7.").
why(cone, [], 4, ask(measure(area(1), mm2, 0.1)),
    "Its pieces together: 47.12 + 28.27, so about 7.",
    "조각을 모두 더하면 47.12 + 28.27, 약 7.").
why(tee, [1-1], 4, ask(measure(coordinate(1,z), mm, 0.1)),
    "The point is at z = 3.50, and the solids begin at -4.00: the difference \c
     is 7.",
    "점의 z는 3.50이고 입체는 -4.00에서 시작한다. 차는 7.").

:- begin_tests(problem_text).

test(asked, [forall(task(World, Ask, Items, Letters, Rank, En, Ko)),
             true(Is == [En,Ko])]) :-
    findall(Sentence,
            ( member(Language, [en,ko]),
              sentence(World, task(Ask,Letters,Rank,none), Items, Language,
                       Sentence) ),
            Is).
test(called, [forall(called(Term, En, Ko)), true(Is == [English,Korean])]) :-
    format(string(English), "Draw the pattern of ~s.", [En]),
    format(string(Korean), "~s의 전개도를 그려라.", [Ko]),
    findall(Sentence,
            ( member(Language, [en,ko]),
              sentence(one(Term), task(ask(develop(1)),"",none,none), [],
                       Language, Sentence) ),
            Is).
test(lines, [ forall(lines(Names, Items, Language, Width, Wanted)),
              true(Lines == Wanted) ]) :-
    maplist(task_named, Names, Tasks),
    modelled(tee, task_lines(Tasks, Items, Language, Width, Lines)).
test(as_wide_as_the_line, [true(Counts == [1,2])]) :-
    task_named(loops(none), Task),
    modelled(tee, task_lines([Task], [], en, 1000, [Line])),
    lettering_width(Line, 3.5, Wide),
    Less is Wide - 1.0e-6,
    findall(Count,
            ( member(Width, [Wide,Less]),
              modelled(tee, task_lines([Task], [], en, Width, Lines)),
              length(Lines, Count) ),
            Counts).
test(why, [ forall(why(World, Places, N, Ask, En, Ko)),
            true(Texts == [En,Ko]) ]) :-
    findall(point(I,Loop,none,p(1.0,2.0,3.5)), member(I-Loop, Places), Points),
    findall(Text,
            ( member(Language, [en,ko]),
              modelled(World,
                       answer_why(variant(none,none,none,
                                          asked(none,N,none,none),
                                          found(Points,none,none),none),
                                  Ask, "7", Language, Text)) ),
            Texts).

:- end_tests(problem_text).
