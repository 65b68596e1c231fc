:- encoding(utf8).
:- module(sg_problem_text,
          [ task_lines/5,               % +Tasks, +Items, +Language, +Width,
                                        % -Lines
            task_sentence/4,            % +Task, +Items, +Language, -Sentence
            sheet_called/3              % +Kind, +Language, -Text
          ]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../near', [is_rounding/2]).
:- use_module('../primitive/primitive', [is_primitive/1, primitive_name/2]).
:- use_module('../sheet/lettering', [lettering_width/3]).
:- use_module('../store', [segment/3]).
:- use_module(problem_item, [measure_unit/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2, nth1/3]).
:- use_module(library(option), [option/3]).
/** <module> What is asked, in words.

Each task of a problem is a sentence in English or Korean, with room for the
answer; the answer has it there. A task is

    task(Ask, Letters, Rank, Answer)

Ask is ask(What) or blank(View) of problem_file.pl; Letters, a text, are those
of the points that it speaks of; Rank is Number-Count of measure_rank/4, or
`none`; Answer is a text, or `none` in a question.
*/

%!  task_lines(+Tasks, +Items, +Language, +Width, -Lines) is det.
%
%   Lines are strings: the text of the problem with these Items, if it has one,
%   and the tasks, numbered if they are several, broken after Width mm.

task_lines(Tasks, Items, Language, Width, Lines) :-
    (   ( memberchk(text(Language, Text), Items)
        ; memberchk(text(_, Text), Items)
        )
    ->  where_added(Tasks, Language, Text, Said0),
        Lead = [Said0-(""-"")],
        findall(Task,
                ( member(Task, Tasks), \+ is_drawn(Task) ),
                Said)
    ;   Lead = [],
        Said = Tasks
    ),
    maplist(task_line(Language, Items), Said, Sentences0),
    numbered(Sentences0, Sentences),
    append(Lead, Sentences, Whole),
    maplist(broken(Width), Whole, Lists),
    append(Lists, Lines).

%   where_added(Tasks, Language, Text, Said): to one's own Text, in which views
%   to draw, if Tasks name them.

where_added(Tasks, Language, Text, Said) :-
    (   member(task(ask(draw(penetration, Names)), _, _, _), Tasks)
    ->  view_words(Language, Names, Views),
        in_views(Language, Views, Where),
        format(string(Said), '~w (~s)', [Text,Where])
    ;   Said = Text
    ).

in_views(en, Views, Where) :-
    format(string(Where), 'In ~s.', [Views]).
in_views(ko, Views, Where) :-
    format(string(Where), '~s에 그린다.', [Views]).

is_drawn(task(ask(What), _, _, _)) :-
    ( What = draw(_) ; What = draw(_, _) ),
    !.

numbered([Sentence], [Sentence]) :-
    !.
numbered(Sentences0, Sentences) :-
    findall(Sentence-Room,
            ( nth1(I, Sentences0, Sentence0-Room),
              format(string(Sentence), '(~d) ~s', [I,Sentence0]) ),
            Sentences).

%   broken(Width, Sentence, Lines): at spaces. Room-Shown after a sentence is as
%   wide as Room: an answer stands where there was room for it.

broken(Width, Sentence-(Room-Shown), Lines) :-
    split_string(Sentence, " ", "", Words0),
    findall(Word-Word, member(Word, Words0), Words1),
    (   Room == ""
    ->  Words = Words1
    ;   append(Words1, [Room-Shown], Words)
    ),
    Words = [First|Rest],
    broken_words(Rest, First, Width, Lines).

broken_words([], _-Line, _, [Line]).
broken_words([Word-Shown|Words], Line0-Out0, Width, Lines) :-
    atomics_joined([Line0,Word], Line),
    lettering_width(Line, 3.5, Wide),
    (   Wide > Width
    ->  Lines = [Out0|Lines1],
        broken_words(Words, Word-Shown, Width, Lines1)
    ;   atomics_joined([Out0,Shown], Out),
        broken_words(Words, Line-Out, Width, Lines)
    ).

atomics_joined(Texts, String) :-
    atomic_list_concat(Texts, ' ', Atom),
    atom_string(Atom, String).

%!  task_sentence(+Task, +Items, +Language, -Sentence:string) is det.
%
%   Sentence asks what Task is about, without room for the answer.

task_sentence(task(Ask,Letters,Rank,_), Items, Language, Sentence) :-
    said(Ask, Language, Items, Letters, Rank, Sentence).

task_line(Language, Items, task(Ask, Letters, Rank, Answer),
          Sentence-(Room-Shown)) :-
    said(Ask, Language, Items, Letters, Rank, Sentence),
    room(Ask, Language, none, Room),
    room(Ask, Language, Answer, Shown).

%   room(Ask, Language, Answer, Room): where the answer is written.

room(ask(count(_)), Language, Answer, Room) :-
    !,
    (   Answer == none
    ->  Text = "______"
    ;   Text = Answer
    ),
    (   Language == ko
    ->  format(string(Room), '~w개', [Text])
    ;   format(string(Room), '~w', [Text])
    ).
room(ask(measure(_, Unit, Tolerance)), _, Answer, Room) :-
    !,
    (   Answer == none
    ->  measure_unit(Unit, _, _, Word),
        format(string(Text), '________ ~s', [Word])
    ;   Text = Answer
    ),
    format(string(Room), '~w (±~w)', [Text,Tolerance]).
room(_, _, _, "").

%   said(Ask, Language, Items, Letters, Rank, Sentence)

said(blank(Name), en, _, _, _, Sentence) =>
    view_word(Name, en, View),
    format(string(Sentence), 'Draw ~s in its frame.', [View]).
said(blank(Name), ko, _, _, _, Sentence) =>
    view_word(Name, ko, View),
    format(string(Sentence), '빈칸에 ~s를 그려라.', [View]).
said(ask(draw(penetration)), Language, Items, _, _, Sentence) =>
    line_said(Language, Items, "", Sentence).
said(ask(draw(penetration, Names)), Language, Items, _, _, Sentence) =>
    views_said(Language, Names, Where),
    line_said(Language, Items, Where, Sentence).
said(ask(count(loops)), en, _, _, _, Sentence) =>
    Sentence = "How many closed lines does the penetration line consist of?".
said(ask(count(loops)), ko, _, _, _, Sentence) =>
    Sentence = "상관선은 몇 개의 닫힌 선으로 이루어지는가?".
said(ask(develop(S)), Language, Items, _, _, Sentence) =>
    part_word(Items, Language, S, Word),
    (   is_trimmed(S)
    ->  trimmed_said(Language, Word, Sentence)
    ;   pattern_said(Language, Word, Sentence)
    ).
said(ask(measure(Measure, _, _)), Language, Items, Letters, Rank, Sentence) =>
    measure_said(Measure, Language, Items, Letters, Rank, Sentence).

%   line_said(Language, Items, Where, Sentence): draw the line, Where.

line_said(Language, Items, Where, Sentence) :-
    findall(S, ( segment(S, Kind, _), Kind \== curve ), Ss0),
    findall(S, segment(S, curve, _), Curves0),
    sort(Ss0, Ss),
    sort(Curves0, Curves),
    maplist(part_word(Items, Language), Ss, Words),
    maplist(part_word(Items, Language), Curves, Lines),
    draw_said(Language, Lines, Words, Where, Sentence).

draw_said(en, [], Words, Where, Sentence) =>
    listed_en(Words, Text),
    format(string(Sentence), 'Draw the penetration line of ~s~s.',
           [Text,Where]).
draw_said(en, Lines, Words, Where, Sentence) =>
    listed_en(Lines, Line),
    listed_en(Words, Text),
    format(string(Sentence), 'Find the points where ~s goes through ~s~s.',
           [Line,Text,Where]).
draw_said(ko, [], Words, Where, Sentence) =>
    listed_ko(Words, Text),
    format(string(Sentence), '~s~s의 상관선을 그려라.', [Where,Text]).
draw_said(ko, Lines, Words, Where, Sentence) =>
    append(Lines, Words, All),
    listed_ko(All, Text),
    format(string(Sentence), '~s~s의 교점을 구하여라.', [Where,Text]).

%   views_said(Language, Names, Where): in which views.

views_said(en, Names, Where) :-
    view_words(en, Names, Text),
    string_concat(" in ", Text, Where).
views_said(ko, Names, Where) :-
    view_words(ko, Names, Text),
    string_concat(Text, "에 ", Where).

view_words(Language, Names, Text) :-
    findall(Word, ( member(Name, Names), view_word(Name, Language, Word) ),
            Words),
    (   Language == en
    ->  listed_en(Words, Text)
    ;   listed_ko(Words, Text)
    ).

trimmed_said(en, Word, Sentence) :-
    format(string(Sentence),
           'Draw the pattern of ~s, cut along the penetration line.',
           [Word]).
trimmed_said(ko, Word, Sentence) :-
    format(string(Sentence), '상관선을 따라 잘라 낸 ~s의 전개도를 그려라.', [Word]).

pattern_said(en, Word, Sentence) :-
    format(string(Sentence), 'Draw the pattern of ~s.', [Word]).
pattern_said(ko, Word, Sentence) :-
    format(string(Sentence), '~s의 전개도를 그려라.', [Word]).

is_trimmed(S) :-
    segment(Other, Kind, _),
    Other \== S,
    Kind \== curve,
    !.

listed_en(Words, Text) :-
    (   append(First, [Last], Words),
        First \== []
    ->  atomic_list_concat(First, ', ', Before),
        format(string(Text), '~w and ~s', [Before,Last])
    ;   Words = [Text]
    ).

%   listed_ko(Words, Text): `와` after a vowel, `과` after a consonant.

listed_ko([Word], Text) :-
    !,
    Text = Word.
listed_ko([Word|Words], Text) :-
    listed_ko(Words, Rest),
    (   Words = [_]
    ->  and_ko(Word, And)
    ;   And = ", "
    ),
    atomic_list_concat([Word,And,Rest], Text0),
    atom_string(Text0, Text).

and_ko(Word, And) :-
    string_codes(Word, Codes),
    last(Codes, Code),
    (   Code >= 0xAC00,
        Code =< 0xD7A3
    ->  (   (Code-0xAC00) mod 28 =:= 0
        ->  And = "와 "
        ;   And = "과 "
        )
    ;   And = " 및 "
    ).

%   measure_said(Measure, Language, Items, Letters, Rank, Sentence)

measure_said(edge(_,_,_), Language, _, Letters, _, Sentence) =>
    one_said(Language, 'What is the true length of ~w?', '~w의 실장(실제 길이)은?',
             Letters, Sentence).
measure_said(angle(_,_,_,_), Language, _, Letters, _, Sentence) =>
    one_said(Language, 'What is the true angle ~w?', '각 ~w의 실제 크기는?',
             Letters, Sentence).
measure_said(generator(S,_), Language, _, Letters, _, Sentence) =>
    (   is_trimmed(S)
    ->  one_said(Language,
                 'How long is the generator from ~w to the penetration line?',
                 '~w에서 상관선까지 면소의 실장(실제 길이)은?', Letters, Sentence)
    ;   one_said(Language, 'How long is the generator that begins in ~w?',
                 '~w에서 시작하는 면소의 실장(실제 길이)은?', Letters, Sentence)
    ).
measure_said(shortest_generator(S), Language, Items, _, _, Sentence) =>
    option(generators(N), Items, 12),
    part_word(Items, Language, S, Word),
    most_said(Language, N, Word, shortest, '짧은', Sentence).
measure_said(longest_generator(S), Language, Items, _, _, Sentence) =>
    option(generators(N), Items, 12),
    part_word(Items, Language, S, Word),
    most_said(Language, N, Word, longest, '긴', Sentence).
measure_said(coordinate(_, Axis), Language, _, Letters, Rank, Sentence) =>
    coordinate_said(Language, Axis, Letters, Sentence0),
    rank_said(Rank, Language, Axis, Which),
    string_concat(Sentence0, Which, Sentence).
measure_said(Measure, Language, Items, _, _, Sentence) =>
    Measure =.. [Name,S],
    part_word(Items, Language, S, Word),
    whole_said(Name, Language, S, Word, Sentence).

one_said(en, Format, _, Letters, Sentence) :-
    format(string(Sentence), Format, [Letters]).
one_said(ko, _, Format, Letters, Sentence) :-
    format(string(Sentence), Format, [Letters]).

most_said(en, N, Word, Most, _, Sentence) :-
    format(string(Sentence),
           'Of the ~d generators in the pattern of ~s, how long is the ~w?',
           [N,Word,Most]).
most_said(ko, N, Word, _, Most, Sentence) :-
    format(string(Sentence),
           '~s의 전개도에서 면소 ~d개 중 가장 ~w 것의 실장(실제 길이)은?',
           [Word,N,Most]).

whole_said(area, en, _, Word, Sentence) =>
    format(string(Sentence), 'What is the area of the pattern of ~s?', [Word]).
whole_said(area, ko, _, Word, Sentence) =>
    format(string(Sentence), '~s 전개도의 넓이는?', [Word]).
whole_said(perimeter, en, _, Word, Sentence) =>
    format(string(Sentence),
           'How long is the outline of the pattern of ~s?', [Word]).
whole_said(perimeter, ko, _, Word, Sentence) =>
    format(string(Sentence), '~s 전개도의 둘레는?', [Word]).
whole_said(sector, en, _, Word, Sentence) =>
    format(string(Sentence),
           'What is the angle of the sector that ~s unrolls to?', [Word]).
whole_said(sector, ko, _, Word, Sentence) =>
    format(string(Sentence), '~s 전개도의 부채꼴 중심각은?', [Word]).
whole_said(volume, en, S, Word, Sentence) =>
    (   is_trimmed(S)
    ->  format(string(Sentence), 'What is the volume of ~s before it is cut?',
               [Word])
    ;   format(string(Sentence), 'What is the volume of ~s?', [Word])
    ).
whole_said(volume, ko, S, Word, Sentence) =>
    (   is_trimmed(S)
    ->  format(string(Sentence), '자르기 전 ~s의 부피는?', [Word])
    ;   format(string(Sentence), '~s의 부피는?', [Word])
    ).

coordinate_said(en, Axis, Letters, Sentence) :-
    axis_en(Axis, Way, Most),
    format(string(Sentence),
           '~w lies on the penetration line. How far is it ~w the ~w point \c
            of the solids?',
           [Letters,Way,Most]).
coordinate_said(ko, Axis, Letters, Sentence) :-
    axis_ko(Axis, Most, Way),
    format(string(Sentence),
           '점 ~w는 상관선 위에 있다. 입체의 ~w 점에서 ~w 얼마나 떨어져 있는가?',
           [Letters,Most,Way]).

axis_en(x, 'to the right of', leftmost).
axis_en(y, behind,            foremost).
axis_en(z, above,             lowest).

axis_ko(x, '가장 왼쪽', '오른쪽으로').
axis_ko(y, '가장 앞쪽', '뒤쪽으로').
axis_ko(z, '가장 아래쪽', '위쪽으로').

rank_said(none, _, _, "") :-
    !.
rank_said(Rank-Count, en, Axis, Text) :-
    side_en(Axis, Side),
    format(string(Text), ' (Of the ~d points seen there, number ~d from ~w.)',
           [Count,Rank,Side]).
rank_said(Rank-Count, ko, Axis, Text) :-
    side_ko(Axis, Side),
    format(string(Text), ' (겹쳐 보이는 ~d점 중 ~w에서 ~d번째)',
           [Count,Side,Rank]).

side_en(x, 'the left').
side_en(y, 'the front').
side_en(z, 'below').

side_ko(x, '왼쪽').
side_ko(y, '앞쪽').
side_ko(z, '아래쪽').


                /*******************************
                *             NAMES            *
                *******************************/

%!  sheet_called(+Kind, +Language, -Text) is det.
%
%   Text stands after the number of a sheet of that Kind, `question` or
%   `answer`.

sheet_called(question, _, "").
sheet_called(answer, en, ", answer").
sheet_called(answer, ko, " 정답").

%   view_word(Name, Language, Word): what one of the six sides is called.

view_word(front,  en, "the front view").
view_word(front,  ko, "정면도").
view_word(top,    en, "the top view").
view_word(top,    ko, "평면도").
view_word(right,  en, "the right-side view").
view_word(right,  ko, "우측면도").
view_word(left,   en, "the left-side view").
view_word(left,   ko, "좌측면도").
view_word(back,   en, "the rear view").
view_word(back,   ko, "배면도").
view_word(bottom, en, "the bottom view").
view_word(bottom, ko, "저면도").

%   part_word(Items, Language, S, Word): what segment S is called: as Items say,
%   or what kind of primitive it is; if another one is called the same, how its
%   axis stands, or its number. In English with its article, if it has one.

part_word(Items, Language, S, Word) :-
    (   ( memberchk(part(S, Language, Text), Items)
        ; own_word(Language, S, Text)
        )
    ->  with_article(Language, Text, Word)
    ;   ( primitive_word(Language, S, Text)
        ; segment(S, Kind, _),
          kind_word(Kind, Language, Text)
        )
    ->  format(string(Word), '~s ~d', [Text,S])
    ).

with_article(en, Text, Word) :-
    string_concat("the ", Text, Word).
with_article(ko, Text, Word) :-
    atom_string(Text, Word).

%   own_word(Language, S, Word): no other segment is called so.

own_word(Language, S, Word) :-
    primitive_word(Language, S, Kind),
    findall(Other,
            ( segment(Other, _, _),
              Other \== S,
              primitive_word(Language, Other, Kind) ),
            Others),
    (   Others == []
    ->  Word = Kind
    ;   standing_word(Language, S, Standing),
        \+ ( member(Other, Others),
             standing_word(Language, Other, Standing) ),
        format(string(Word), '~s ~s', [Standing,Kind])
    ).

primitive_word(Language, S, Word) :-
    segment(S, _, Term),
    is_primitive(Term),
    primitive_name(Term, Name),
    kind_word(Name, Language, Word).

kind_word(line,            en, "straight line").
kind_word(line,            ko, "직선").
kind_word(rectangle,       en, "rectangle").
kind_word(rectangle,       ko, "직사각형").
kind_word(circle,          en, "disc").
kind_word(circle,          ko, "원판").
kind_word(ellipse,         en, "ellipse").
kind_word(ellipse,         ko, "타원판").
kind_word(box,             en, "box").
kind_word(box,             ko, "직육면체").
kind_word(cylinder,        en, "cylinder").
kind_word(cylinder,        ko, "원기둥").
kind_word(hollow_cylinder, en, "hollow cylinder").
kind_word(hollow_cylinder, ko, "속이 빈 원기둥").
kind_word(cone,            en, "cone").
kind_word(cone,            ko, "원뿔").
kind_word(sphere,          en, "sphere").
kind_word(sphere,          ko, "구").
kind_word(hemisphere,      en, "hemisphere").
kind_word(hemisphere,      ko, "반구").
kind_word(torus,           en, "torus").
kind_word(torus,           ko, "원환체").
kind_word(prism,           en, "prism").
kind_word(prism,           ko, "각기둥").
kind_word(pyramid,         en, "pyramid").
kind_word(pyramid,         ko, "각뿔").
kind_word(polyhedron,      en, "polyhedron").
kind_word(polyhedron,      ko, "다면체").
kind_word(curve,           en, "curve").
kind_word(curve,           ko, "곡선").
kind_word(surface,         en, "surface").
kind_word(surface,         ko, "곡면").
kind_word(solid,           en, "solid").
kind_word(solid,           ko, "입체").

%   standing_word(Language, S, Word): how the axis of segment S stands.

standing_word(Language, S, Word) :-
    placed_surface(S, _, Surface),
    Surface =.. [Kind,_,_,_,vector(X,Y,Z)|_],
    memberchk(Kind, [cylinder,cone]),
    Length is sqrt(X*X + Y*Y + Z*Z),
    (   is_rounding(abs(X)+abs(Y), Length)
    ->  Way = upright
    ;   is_rounding(Z, Length)
    ->  Way = lying
    ;   Way = leaning
    ),
    way_word(Way, Language, Word),
    !.

way_word(upright, en, "upright").
way_word(upright, ko, "수직").
way_word(lying,   en, "lying").
way_word(lying,   ko, "수평").
way_word(leaning, en, "leaning").
way_word(leaning, ko, "기울어진").
