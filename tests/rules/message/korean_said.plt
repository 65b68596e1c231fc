:- encoding(utf8).
:- module(test_korean_said, []).
:- use_module(library(plunit)).
:- use_module(library(filesex)).
:- use_module(rules(command/cli)).
:- use_module(rules(message/messages)).
:- use_module(rules(message/messages_ko)).
:- use_module(tests(rules/message_text), [message_text/3]).

/* Sentences that a Korean reader found wrong once, as a command says them now,
   word for word. Where the sentence is not the one that was asked for, it is
   said why. */

file('cube.pl', "segment(1, solid, box(size(1,1,1))).\n").
file('cubes.pl', "segment(1, solid, box(size(1,1,2))).
segment(2, solid, at([translate(0.1,-0.3,0.6)], box(size(2,2,1)))).\n").
file('curve.pl', "v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,1,1,0).
e(1,1,1,2,1). e(1,2,2,3,1). segment(1, curve, wire).\n").
file('far.pl', "segment(1, solid, box(size(1,1,1))).
segment(2, solid, at([translate(9,0,0)], box(size(1,1,1)))).\n").
file('large.pl', "segment(1, solid, box(size(400,400,900))).\n").
file('cone.pl', "segment(1, solid, cone(radius(1), height(2), facets(12))).\n").
file('syntax.pl', "segment(1 solid).\n").
file('turned.off', "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\c
3 0 1 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n").

% sentence(Name, Arguments, Sentence): Sentence is in what the command says.

sentence(value, [check,@('cube.pl'),'--json=3'],
         "--json 옵션은 값을 받지 않습니다").
sentence(help_of_explain, [explain,'--help'],
         "--trim과 함께: 이 세그먼트만 다른 것을 잘라 낸다").
sentence(polygon, [unfold,@('cube.pl'),'--thickness','3'],
         "다각형 1이 굽힘과 접합선으로 줄어드는 길이 3.0000보다 좁습니다").
% It is told what cannot be done with a curve; the number is that of the model.
sentence(curve, [unfold,@('curve.pl'),'--only','1'],
         "세그먼트 1은 곡선이라 전개할 면이 없습니다").
% With the largest scale that does, and the paper that would.
sentence(scale, [draw,@('large.pl'),'--sheet','A4','--scale','1:3','-o',
                 @('x.svg')],
         "척도 1:3으로는 투상도가 A4 용지에 다 들어가지 않습니다").
sentence(scale_help, [draw,@('large.pl'),'--sheet','A4','--scale','1:3','-o',
                      @('x.svg')],
         "--scale 1:10이면 들어갑니다").
sentence(no, [query,@('cube.pl'),'v(9,_,_,_,_)'], "답이 없습니다").
sentence(yes, [query,@('cube.pl'),'v(1,1,_,_,_)'], "예").
% The remark stands behind its word, as in all statements.
sentence(pierces, [explain,@('cubes.pl'),'line(1)'],
         "모서리 1-5가 세그먼트 2의 다각형 1 (그 삼각형 2-1-4 안)을 뚫는다").
sentence(place, [explain,@('cubes.pl'),'vertex(1, 9)'],
         "꼭짓점 9 (-0.5, -0.5, 0.6)는 세그먼트 1의 모서리 1-5에 있다").
% With the name of the wish, and of the polygons: numbers alone say little.
sentence(cut_and_keep, [unfold,@('cube.pl'),'--cut','1','--keep','1'],
         "세그먼트 1: keep(1) 지정대로 전개할 수 없습니다: 다각형 1 (base)과 \c
          다각형 5 (side(3)) 사이의 모서리 1을 자르라고도(--cut) 이으라고도(--keep) 했습니다").
% In the column of the report, with how the bound was found.
sentence(seam, [unfold,@('cube.pl')],
         "  접합선       7 (하한 7), 가장 긴 용접선 2").
sentence(verb, [drw], "drw: 없는 명령입니다\n  비슷한 것: draw").
% With where it was asked.
sentence(evaluable, [query,@('cube.pl'),'X is foo'],
         "is/2: foo/0은 계산할 수 있는 식이 아닙니다").
sentence(boxes, [explain,@('far.pl'),'pair(1, 2)'],
         "상관선 없음: 둘러싼 상자가 서로 떨어져 있다").
sentence(sides, [unfold,@('turned.off')],
         "다각형 1의 모서리 1, 다각형 1의 모서리 2, 다각형 1의 모서리 3, \c
          다각형 2의 모서리 4").
sentence(too_large, [draw,@('cube.pl'),'--scale','300000:1','-o',@('x.svg')],
         "mm입니다\n  --scale 값을 줄이십시오").
sentence(hidden, [draw,'--help'], "숨은선: dashed(파선, 기본값)").
sentence(side, [explain,@('cone.pl'),'--true','seam(_)'],
         "옆면(side)은 둥근 면 그대로 펼친다. 한 바퀴를 돌면 면소 하나를 따라 \c
          자른다. 정하지 않으면(--seam, --cut) 가장 짧은 면소이다").
sentence(syntax, [check,@('syntax.pl')],
         "Prolog 문법에 맞지 않습니다: 연산자가 올 자리입니다").
sentence(repair, [union,'--help'], "두 번 있거나 넓이가 없는 면").

:- dynamic said/1, keeping/0.
:- multifile user:message_hook/3.
:- asserta((user:message_hook(Term, Kind, _) :-
                test_korean_said:kept(Term, Kind))).

kept(Term, Kind) :-
    keeping,
    memberchk(Kind, [error,warning,informational,help]),
    assertz(said(Term)),
    fail.

%   korean(Arguments, Text): what a command prints, and its messages.

korean(Arguments0, Text) :-
    folder(Folder),
    maplist(argument(Folder), Arguments0, Arguments),
    append(Arguments, ['--lang',ko], All),
    current_prolog_flag(message_language, Old),
    retractall(said(_)),
    setup_call_cleanup(
        assertz(keeping),
        with_output_to(string(Printed), sanggwan(All, _)),
        ( retractall(keeping),
          set_prolog_flag(message_language, Old) )),
    findall(Own, ( said(Term), message_text(ko, Term, Own) ), Texts),
    atomics_to_string([Printed|Texts], Text).

argument(Folder, @(Name), Path) :-
    !,
    directory_file_path(Folder, Name, Path).
argument(_, Word, Word).

:- dynamic folder/1.

made_files :-
    tmp_file(korean, Folder),
    make_directory(Folder),
    assertz(folder(Folder)),
    forall(file(Name, Text),
           ( directory_file_path(Folder, Name, Path),
             setup_call_cleanup(open(Path, write, Out), write(Out, Text),
                                close(Out)) )).

removed_files :-
    retract(folder(Folder)),
    delete_directory_and_contents(Folder).

:- begin_tests(korean_said, [setup(made_files), cleanup(removed_files)]).

test(sentence, [ forall(sentence(Name, Arguments, Sentence)) ]) :-
    korean(Arguments, Text),
    (   sub_string(Text, _, _, _, Sentence)
    ->  true
    ;   format(user_error, '~w: ~w~nnot in: ~w~n', [Name,Sentence,Text]),
        fail
    ).
% What no command says any more: the kernel fills such polygons.
test(crosses, Text == "꼭짓점 1에서 2로 가는 모서리에 셋째 꼭짓점이 없습니다\n\c
                       \x20 다각형이 그곳에서 자기 자신과 교차하거나 겹칩니다.") :-
    message_text(ko, error(geometry_error(no_third_vertex(1, 2)), _), Text).

:- end_tests(korean_said).
