:- encoding(utf8).
:- module(sg_messages_ko,
          [ korean//1,                  % +Term
            fault_ko//1                 % +What
          ]).
:- use_module(messages,
              [loading_fault//1, syntax_words//1, shown_value/2,
               manual_page//1]).
:- use_module(csg_ko, [csg_ko//1]).
:- use_module(csg_term, [misshapen/2]).
:- use_module(explain_ko, [statement_ko//1, hidden_ko//1]).
:- use_module(openscad_ko, [openscad_ko//1]).
:- use_module(primitive, [primitive_name/2]).
:- use_module(primitive_en, [primitive_names//0]).
:- use_module(style_ko, [style_ko//1]).
:- use_module(sheet_ko, [sheet_ko//1, sheet_tiny_ko//3]).
:- use_module(pattern_ko, [pattern_ko//1, pattern_fault_ko//1]).
:- use_module(written_ko, [written_ko//1, unwritten_ko//1]).
:- use_module(development_ko,
              [ development_ko//2, development_notice_ko//2 ]).
:- use_module(operand_ko, [operand_ko//2, operand_notice_ko//2]).
:- use_module(true_ko, [true_ko//1]).
:- use_module(unfold_ko, [wish_ko//3, unfold_ko//1, trim_ko//1]).
:- use_module(primitive_ko, [primitive_ko//2]).
:- use_module(library(apply), [maplist/3]).
/** <module> Messages in Korean; messages.pl has them in English.

The heads are the same as in messages.pl, clause by clause
(tests/rules/messages.plt).
*/

:- multifile prolog:message//2.

prolog:message(ko, Term) -->
    korean(Term).
prolog:message(ko, Term) -->
    prologs_own(Term).

%   prologs_own(Term)//: errors of Prolog that people meet when they ask.

prologs_own(error(existence_error(procedure, PI), _)) -->
    [ '프레디킷 ~q 이(가) 없습니다'-[PI] ].
prologs_own(error(instantiation_error, _)) -->
    [ '변수에 값이 있어야 합니다' ].
prologs_own(error(type_error(Type, Value), _)) -->
    [ '형이 맞지 않습니다: ~w 이어야 하는데 ~p 입니다'-[Type, Value] ].

%!  korean(+Term)// is semidet.
%
%   The message for Term in Korean.

korean(error(model_error(What), Context)) -->
    { nonvar(Context),
      Context = location(File, Line, Column)
    },
    place(File, Line, Column),
    fault_ko(What).
korean(error(model_error(What), Context)) -->
    { var(Context) },
    fault_ko(What).
korean(error(geometry_error(What), Context)) -->
    (   { nonvar(Context), Context = location(File, Line, Column) }
    ->  place(File, Line, Column)
    ;   []
    ),
    fault_ko(What).
korean(error(usage_error(What), _)) -->
    usage_ko(What).
korean(error(domain_error(Domain, Value), _)) -->
    drawing_ko(domain(Domain, Value)).
korean(error(existence_error(directory, Folder), context(Writer, _))) -->
    { Writer == sg_output:writing/3 },
    usage_ko(no_folder(Folder)).
korean(error(cannot_write(File, Why), _)) -->
    usage_ko(cannot_write(File, Why)).
korean(sanggwan_interrupt(_)) -->
    notice_ko(interrupted).
korean(sanggwan(What)) -->
    notice_ko(What).

place(File, Line, _) -->
    { Line =:= 0 },
    !,
    [ '~w: '-[File] ].
place(File, Line, Column) -->
    { Column =:= 0 },
    !,
    [ '~w:~d: '-[File, Line] ].
place(File, Line, Column) -->
    [ '~w:~d:~d: '-[File, Line, Column] ].

:- discontiguous
    fault_ko//1,
    notice_ko//1.

%!  fault_ko(+What)// is semidet.
%
%   What is wrong with a model, and what to do.


                /*******************************
                *     model_text, model_file   *
                *******************************/

fault_ko(cannot_read(missing)) -->
    [ '그런 파일이 없습니다', nl,
      '  이름과 폴더를 확인하십시오.' ].
fault_ko(cannot_read(directory)) -->
    [ '파일이 아니라 폴더입니다', nl,
      '  그 안의 파일을 지정하십시오.' ].
fault_ko(cannot_read(permission)) -->
    [ '파일을 읽을 권한이 없습니다', nl,
      '  접근 권한을 확인하십시오.' ].
fault_ko(cannot_read(io)) -->
    [ '파일을 끝까지 읽을 수 없습니다', nl,
      '  디스크를 확인하거나 파일을 다시 복사하십시오.' ].
fault_ko(cannot_read(Why)) -->
    { \+ memberchk(Why, [missing, directory, permission, io]) },
    [ '파일을 읽을 수 없습니다: ~p'-[Why] ].
fault_ko(syntax(end_of_file)) -->
    [ '사실의 중간에서 파일이 끝납니다', nl,
      '  파일이 잘렸을 수 있습니다. 사실은 마침표로 끝납니다.' ].
fault_ko(syntax(end_of_file_in_quoted(_))) -->
    [ '여기서 시작한 따옴표가 닫히지 않고 파일이 끝납니다', nl,
      '  따옴표를 닫거나 온전한 파일을 구하십시오.' ].
fault_ko(syntax(too_deep)) -->
    [ '항이 너무 깊게 겹쳐 있어 읽을 수 없습니다', nl,
      '  수, 아톰, 짧은 리스트로 사실을 쓰십시오.' ].
fault_ko(syntax(Message)) -->
    { \+ memberchk(Message, [end_of_file, end_of_file_in_quoted(_),
                             too_deep]) },
    [ '프롤로그 글이 아닙니다: ' ],
    syntax_words(Message),
    [ nl,
      '  v(1, 1, 0.0, 0.0, 0.0). 과 같은 사실을 마침표와 함께 쓰십시오.' ].
fault_ko(too_long(Most)) -->
    [ '사실 하나가 ~D 글자보다 깁니다'-[Most], nl,
      '  마침표나 따옴표가 빠지지 않았습니까? 아니면 플래그 \c
       sanggwan_longest_fact 를 올리십시오.' ].
fault_ko(early_end) -->
    [ '파일 중간에 end_of_file 이 있습니다', nl,
      '  지우십시오. 뒤의 내용을 잃게 됩니다.' ].
fault_ko(directive(Goal)) -->
    [ '모델 파일에 지시문이 있습니다: :- ~p'-[Goal], nl,
      '  모델은 자료이며 실행되지 않습니다. 규칙은 --rules FILE 로 주십시오.' ].
fault_ko(rule(Head)) -->
    [ '모델 파일에 규칙이 있습니다: ~p :- ...'-[Head], nl,
      '  모델은 사실로만 된 자료입니다. 규칙은 --rules FILE 로 주십시오.' ].
fault_ko(no_fact(Term)) -->
    [ '사실이 아닙니다: ~p'-[Term], nl,
      '  v(1, 1, 0.0, 0.0, 0.0). 과 같은 사실을 쓰십시오.' ].
fault_ko(unknown_relation(Name, Arity)) -->
    [ '관계 ~q/~d 은(는) 없습니다'-[Name, Arity], nl,
      '  모델의 관계: v/5, e/5, p/3, plane/6, t/6, segment/3, \c
       leaf_v/5, leaf_e/5, leaf_p/3, leaf_t/6, origin/3, from_v/4, \c
       from_p/5, line/9, curve/2, view/3, projection/1, \c
       title_block/2.' ].
fault_ko(arity(Name, Arity, Wanted)) -->
    [ '~w 의 인수가 ~d개입니다. ~d개여야 합니다'-[Name, Arity, Wanted], nl,
      '  ~w/~d 의 설명과 비교하십시오.'-[Name, Wanted] ].
fault_ko(computed(Name)) -->
    [ '~w 은(는) 시점에서 계산되므로 파일에 둘 수 없습니다'-[Name], nl,
      '  지우십시오. draw 가 다시 만듭니다.' ].
fault_ko(value(Relation, Column, Value, Expected)) -->
    { shown_value(Value, Shown) },
    [ '~w 의 ~w 이(가) ~w 입니다. 있어야 할 것: '-
      [Relation, Column, Shown] ],
    expected_ko(Expected).
fault_ko(missing(Relation, S, Id)) -->
    { relation_word(Relation, Word) },
    [ '세그먼트 ~d 에 ~w ~d 이(가) 없습니다'-[S, Word, Id], nl,
      '  추가하거나 번호를 고치십시오.' ].
fault_ko(twice(Name, Key)) -->
    [ '~w 사실이 둘 있습니다: '-[Name] ],
    key_ko(Key),
    [ nl, '  하나를 지우거나 다른 번호를 주십시오.' ].
fault_ko(polygon(S, P, Why)) -->
    [ '세그먼트 ~d 의 다각형 ~d: '-[S, P] ],
    polygon_ko(Why).
fault_ko(chain(S, V)) -->
    [ '세그먼트 ~d 의 곡선이 꼭지점 ~d 에서 자기 자신으로 갑니다'-[S, V], nl,
      '  꼭지점을 한 번씩만 쓰십시오.' ].
fault_ko(primitive(What, Term)) -->
    primitive_ko(What, Term).
fault_ko(csg(What)) -->
    csg_ko(What).
fault_ko(development(S, What)) -->
    development_ko(S, What).
fault_ko(operand(S, Faults)) -->
    operand_ko(S, Faults).
fault_ko(unfold(S, Wish, What)) -->
    wish_ko(S, Wish, What).
fault_ko(unfold(What)) -->
    unfold_ko(What).
fault_ko(trim(What)) -->
    trim_ko(What).
fault_ko(true(What)) -->
    true_ko(What).
fault_ko(style(What)) -->
    style_ko(What).
fault_ko(kind(Term, Kind, Wanted)) -->
    { primitive_name(Term, Name) },
    [ '~w 의 종류는 ~w 이며 ~w 이(가) 아닙니다'-[Name, Wanted, Kind], nl,
      '  segment(S, ~w, ~w(...)) 로 쓰십시오.'-[Wanted, Name] ].
fault_ko(no_vertices(_, Name)) -->
    { misshapen(Name, _) },
    !,
    csg_ko(unknown(Name)).
fault_ko(no_vertices(S, Name)) -->
    [ '세그먼트 ~d 에 꼭지점이 없고 ~p 은(는) 기본 입체가 아닙니다'-[S, Name],
      nl,
      '  v/5 와 p/3, 연산(docs/model_files.md), 또는 기본 입체를 쓰십시오: ' ],
    primitive_names.
fault_ko(no_edges(S)) -->
    [ '세그먼트 ~d 에 다각형도 모서리도 없습니다'-[S], nl,
      '  p/3, e/5 또는 curve/2 를 추가하십시오.' ].
fault_ko(title_block_only(Name)) -->
    [ '표제란 파일에 ~w 사실은 쓸 수 없습니다'-[Name], nl,
      '  title_block(Item, Text) 만 쓰십시오. 보기: \c
       title_block(name, "받침대").' ].
fault_ko(empty) -->
    [ '모델이 비어 있습니다', nl,
      '  꼭지점과 다각형이 있는 세그먼트를 하나 이상 주십시오.' ].
fault_ko(refused(Row, Error)) -->
    [ '사실 ~p 은(는) 불가능합니다: ~p'-[Row, Error] ].
fault_ko(unknown_format('', Formats)) -->
    !,
    { atomic_list_concat(Formats, ' .', All) },
    [ '파일의 종류를 말하는 확장자가 없습니다', nl,
      '  모델의 확장자는 .~w 입니다. 또는 --from 과 함께 표준 입력(-)으로 \c
       주십시오.'-[All] ].
fault_ko(unknown_format(Format, Formats)) -->
    { atomic_list_concat(Formats, ' .', All) },
    [ '.~w 형식은 모릅니다'-[Format], nl,
      '  모델의 확장자는 .~w 입니다.'-[All] ].

expected_ko(id) -->
    [ '1 에서 2147483647 까지의 정수', nl,
      '  세그먼트, 꼭지점, 모서리, 다각형의 번호는 1부터입니다.' ].
expected_ko(ids) -->
    [ '양의 정수의 리스트' ].
expected_ko(steps) -->
    [ '정수의 리스트', nl,
      '  [1, 2, 3] 처럼 다각형의 꼭지점을 쓰십시오. 음수는 건너뜀입니다.' ].
expected_ko(chain) -->
    [ '하나 이상의 꼭지점 번호의 리스트' ].
expected_ko(float) -->
    [ '수', nl, '  -1.5 나 2.0e-3 처럼 숫자로 쓰십시오.' ].
expected_ko(distance) -->
    [ '0 이상의 수 (0: 필요한 만큼 멀리)' ].
expected_ko(finite) -->
    [ '유한한 수', nl,
      '  무한대와 NaN 은 자리가 아닙니다. 그것을 쓴 프로그램을 고치십시오.' ].
expected_ko(within(Most)) -->
    [ '-~w 과 ~w 사이'-[Most, Most], nl,
      '  다른 단위를 쓰십시오. 이 크기로는 계산할 수 없습니다.' ].
expected_ko(text) -->
    [ '글, 수, 또는 아톰' ].
expected_ko(ground) -->
    [ '아톰, 수, 또는 그것으로 된 복합항', nl,
      '  변수와 "문자열"은 안 됩니다. 이름은 \'이렇게\' 따옴표로 쓰십시오.' ].
expected_ko(atom) -->
    [ '아톰' ].
expected_ko(one_of(Atoms)) -->
    { atomic_list_concat(Atoms, ', ', Text) },
    [ '다음의 하나: ~w'-[Text] ].

relation_word(v, '꼭지점').
relation_word(e, '모서리').
relation_word(p, '다각형').

key_ko(Key) -->
    (   { is_list(Key) }
    ->  { atomic_list_concat(Key, ', ', Text) },
        [ '번호 ~w'-[Text] ]
    ;   [ '하나만 있을 수 있습니다' ]
    ).

polygon_ko(list) -->
    [ '리스트의 건너뜀이 갈 곳이 없습니다', nl,
      '  음수는 닫힌 고리 다음에 와서 새 고리를 시작합니다: \c
       [1,2,3,1,-4,5,6,4].' ].
polygon_ko(edges(N)) -->
    [ '모서리가 ~d개입니다. 셋 이상이어야 합니다'-[N] ].
polygon_ko(open(V)) -->
    [ '꼭지점 ~d 에서 닫히지 않습니다'-[V], nl,
      '  꼭지점마다 들어오는 모서리와 나가는 모서리의 수가 같아야 합니다. \c
       건너뛴 고리는 첫 꼭지점을 다시 써서 닫으십시오.' ].
polygon_ko(twice(V1, V2)) -->
    [ '~d 에서 ~d 로 가는 모서리가 둘 있습니다'-[V1, V2], nl,
      '  한 걸음은 한 번만 쓰십시오. 구멍은 반대로 돕니다.' ].
polygon_ko(no_edge(V)) -->
    [ '꼭지점 ~d 에서 자기 자신으로 가는 모서리가 있습니다'-[V], nl,
      '  꼭지점을 한 번만 쓰십시오.' ].


                /*******************************
                *              cli             *
                *******************************/

usage_ko(no_verb) -->
    [ '무엇을 할까요?', nl, '  sanggwan --help 를 보십시오.' ].
usage_ko(unknown_verb(Verb)) -->
    [ '~w 이라는 동사는 없습니다'-[Verb], nl,
      '  sanggwan --help 를 보십시오.' ].
usage_ko(unknown_option(Text)) -->
    [ '모르는 선택 사항 ~w'-[Text], nl,
      '  sanggwan VERB --help 를 보십시오.' ].
usage_ko(no_value(Text)) -->
    [ '~w 에는 값이 없습니다'-[Text] ].
usage_ko(needs_value(Text)) -->
    [ '~w 에 값이 필요합니다'-[Text] ].
usage_ko(option_twice(Text)) -->
    [ '~w 이(가) 두 번 주어졌습니다'-[Text] ].
usage_ko(bad_value(Text, Value, one_of(Words))) -->
    { atomic_list_concat(Words, ', ', All) },
    [ '~w: ~w 은(는) ~w 의 하나가 아닙니다'-[Text, Value, All] ].
usage_ko(bad_value(Text, Value, number(Low))) -->
    [ '~w: ~w 은(는) ~w 이상의 수가 아닙니다'-[Text, Value, Low] ].
usage_ko(bad_value(Text, Value, number(Low, High))) -->
    [ '~w: ~w 은(는) ~w 이상 ~w 이하의 수가 아닙니다'-[Text, Value, Low, High] ].
usage_ko(bad_value(Text, Value, above(Low))) -->
    [ '~w: ~w 은(는) ~w 보다 큰 수가 아닙니다'-[Text, Value, Low] ].
usage_ko(bad_value(Text, Value, whole(Low, High))) -->
    [ '~w: ~w 은(는) ~w 이상 ~w 이하의 정수가 아닙니다'-
      [Text, Value, Low, High] ].
usage_ko(no_size(Text, Value)) -->
    [ '~w: ~w 은(는) 크기가 아닙니다. 너비와 높이는 0보다 커야 합니다'-
      [Text, Value] ].
usage_ko(bad_value(Text, Value, no_normal)) -->
    !,
    [ '~w: ~w 은(는) 평면이 아닙니다'-[Text, Value], nl,
      '  A,B,C,D 는 평면 A*X + B*Y + C*Z + D = 0 이고, A, B, C 가운데 하나는 \c
       0이 아니어야 합니다.' ].
usage_ko(bad_value(Text, Value, Form)) -->
    { atom(Form) },
    [ '~w: ~w 은(는) ~w 꼴이어야 합니다'-[Text, Value, Form] ].
usage_ko(no_files(What)) -->
    [ '~w 이(가) 없습니다'-[What], nl,
      '  sanggwan VERB --help 를 보십시오.' ].
usage_ko(unfold(S, Wish, What)) -->
    wish_ko(S, Wish, What).
usage_ko(unfold(What)) -->
    unfold_ko(What).
usage_ko(one_operand(Verb)) -->
    [ '~w 에는 모델이 둘 이상 필요합니다'-[Verb], nl,
      '  다른 모델도 지정하십시오. 파일 하나가 피연산자 하나입니다.' ].
usage_ko(both_options(A, B)) -->
    [ '~w 와(과) ~w 은(는) 함께 쓸 수 없습니다'-[A, B] ].
usage_ko(needs_one_of(Options)) -->
    { atomic_list_concat(Options, ', ', Text) },
    [ '선택 사항이 빠졌습니다: ~w 가운데 하나'-[Text] ].
usage_ko(no_output) -->
    [ '결과를 어디에 둘까요? -o FILE 을 주십시오 (- 는 표준 출력)' ].
usage_ko(replaces_model(File)) -->
    [ '~w 은(는) 모델이며, 그림이 그 자리를 차지하게 됩니다'-[File], nl,
      '  그림에 다른 이름을 주십시오.' ].
usage_ko(ending(File, Endings)) -->
    { atomic_list_concat(Endings, ' .', All) },
    [ '~w: 확장자가 형식을 정합니다. 쓸 수 있는 것: .~w'-[File, All] ].
usage_ko(no_folder(Folder)) -->
    [ '결과를 둘 폴더가 없습니다: ~w'-[Folder], nl,
      '  먼저 만드십시오.' ].
usage_ko(cannot_write(File, permission)) -->
    [ '~w: 결과를 거기에 쓸 수 없습니다'-[File], nl,
      '  파일과 폴더의 권한을 확인하거나 다른 폴더를 쓰십시오.' ].
usage_ko(cannot_write(output, Why)) -->
    [ '결과를 쓸 수 없습니다: ~w'-[Why], nl,
      '  자리를 만들거나 다른 곳으로 보내십시오.' ].
usage_ko(no_segment(S, Known)) -->
    { atomic_list_concat(Known, ', ', All) },
    [ '세그먼트 ~w 은(는) 없습니다. 있는 것: ~w'-[S, All] ].
usage_ko(pattern(What)) -->
    pattern_fault_ko(What).
usage_ko(sheet(What)) -->
    sheet_ko(What).
usage_ko(exact_format(Format)) -->
    [ '--exact 는 표(csv, tsv, txt)에 쓰며 ~w에는 쓸 수 없습니다'-[Format] ].
usage_ko(bad_goal(Text, Why)) -->
    [ '목표가 아닙니다: ~w ('-[Text] ],
    syntax_words(Why),
    [ ')' ].

notice_ko(do_not_meet) -->
    [ '세그먼트들이 만나지 않아 상관선이 없습니다' ].
notice_ko(points_alone(N)) -->
    [ '세그먼트들이 점 ~D개에서만 만납니다: explain vertex(S, V)'-[N] ].
notice_ko(trim(What)) -->
    trim_ko(What).
notice_ko(unfold(What)) -->
    unfold_ko(What).
notice_ko(development(S, What)) -->
    development_notice_ko(S, What).
notice_ko(operand(What, S)) -->
    operand_notice_ko(What, S).
notice_ko(pattern(What)) -->
    pattern_ko(What).
notice_ko(one_segment) -->
    [ '세그먼트가 하나뿐이라 상관선이 없습니다' ].
notice_ko(empty_result(S, Name)) -->
    [ '세그먼트 ~d(~p) 이(가) 비었습니다. 피연산자에서 남은 것이 없습니다'-[S, Name] ].
notice_ko(wrote(File)) -->
    [ '~w 을(를) 썼습니다'-[File] ].
notice_ko(pen_travel(N, Way, Unsorted)) -->
    { Metres is Way/1.0e6, Before is Unsorted/1.0e6 },
    [ '펜이 그리는 선 ~D개, 그 사이를 ~3f m 간다 (차례를 바꾸지 않으면 ~3f m)'-
      [N, Metres, Before] ].
notice_ko(interrupted) -->
    [ '중단되었습니다' ].
notice_ko(greeting) -->
    [ '목표를 물어보십시오. 마침표로 끝나며 halt. 로 나갑니다.', nl,
      '  모델은 v/5 e/5 p/3 t/6 segment/3 입니다. penetrate. \c
       draw(\'a.svg\'). show. rules.' ].
notice_ko(segment(S, Kind, Name)) -->
    [ '세그먼트 ~d: ~w ~p'-[S, Kind, Name] ].
notice_ko(uncaught(What)) -->
    [ '목표나 규칙이 throw(~p) 로 끝났습니다'-[What], nl,
      '  거기에서 잡거나 error(Formal, Context) 를 던지십시오.' ].
notice_ko(no_answer) -->
    [ '아니오' ].
notice_ko(warnings_are_errors(N)) -->
    [ '경고 ~d개, --strict 가 주어졌습니다'-[N] ].
notice_ko(progress(Stage, Seconds)) -->
    [ '~w: ~0f초'-[Stage, Seconds] ].
notice_ko(progress(Stage, Done, Total, Rate, Left)) -->
    [ '~w: ~D / ~D, 초당 ~0f, 남은 시간 ~0f초'-
      [Stage, Done, Total, Rate, Left] ].


notice_ko(not_utf8(File, Line)) -->
    [ '~w:~d: 파일에 UTF-8이 아닌 바이트가 있습니다. 처음은 여기서 끝나는 사실입니다'-
      [File, Line], nl,
      '  파일을 UTF-8로 저장하십시오. 이름이 잘못되었을 수 있습니다.' ].


                /*******************************
                *             mesh             *
                *******************************/

fault_ko(openscad(What)) -->
    openscad_ko(What).
fault_ko(mesh(Fault)) -->
    mesh_ko(Fault).
fault_ko(mesh(Fault, Byte)) -->
    [ '~D번째 바이트: '-[Byte] ],
    mesh_ko(Fault).

mesh_ko(empty_file) -->
    [ '파일이 비어 있습니다', nl,
      '  온전한 파일을 구하십시오. 쓴 프로그램이 실패했을 수 있습니다.' ].
mesh_ko(no_faces) -->
    [ '메시에 다각형도 곡선도 없습니다', nl,
      '  면과 함께 모델을 다시 내보내십시오.' ].
mesh_ko(unknown_format) -->
    [ 'STL, OFF, OBJ, PLY 어느 메시로도 보이지 않습니다', nl,
      '  형식에 맞는 확장자를 주십시오.' ].
mesh_ko(unsupported(Text)) -->
    [ '~w 은(는) 이 형식 가운데 읽지 않는 종류입니다'-[Text], nl,
      '  보통의 텍스트 형식으로 저장하십시오.' ].
mesh_ko(expected(Wanted, '')) -->
    [ '~w 이(가) 와야 할 곳에 아무것도 없습니다'-[Wanted], nl,
      '  줄을 채우십시오. 파일이 여기서 끝나면 온전한 파일을 구하십시오.' ].
mesh_ko(expected(Wanted, Text)) -->
    { Text \== '' },
    [ '~w 이(가) 와야 할 곳에 ~w 이(가) 있습니다'-[Wanted, Text], nl,
      '  줄을 고치십시오. 확장자에 맞는 형식입니까?' ].
mesh_ko(bad_number(Text)) -->
    [ '수가 아닙니다: ~w'-[Text], nl,
      '  -12.5 나 1e-3 처럼 점을 찍어 쓰십시오.' ].
mesh_ko(not_finite(Text)) -->
    [ '좌표가 ~w 입니다. 유한한 수여야 합니다'-[Text], nl,
      '  모델을 만든 프로그램에서 고치십시오.' ].
mesh_ko(too_far(Text)) -->
    [ '좌표 ~w 이(가) 1.0e90 을 넘습니다'-[Text], nl,
      '  다른 단위를 쓰십시오. 이 크기로는 계산할 수 없습니다.' ].
mesh_ko(bad_index(Index, Lowest, Highest)) -->
    { Lowest =< Highest },
    [ '꼭지점 ~d 은(는) 없습니다. 있는 것은 ~d 부터 ~d 까지입니다'-
      [Index, Lowest, Highest], nl,
      '  번호를 고치거나 꼭지점을 추가하십시오.' ].
mesh_ko(bad_index(Index, Lowest, Highest)) -->
    { Lowest > Highest },
    [ '꼭지점 ~d 은(는) 없습니다. 아직 하나도 없습니다'-[Index], nl,
      '  꼭지점을 먼저 주십시오.' ].
mesh_ko(bad_count(What, Text)) -->
    [ '~w 의 수가 ~q 일 수 없습니다'-[What, Text], nl,
      '  0 이상의 정수를 쓰십시오.' ].
mesh_ko(truncated(What, Present, Needed)) -->
    [ '너무 짧습니다: ~w ~D개여야 하지만 많아야 ~D개 있습니다'-
      [What, Needed, Present], nl,
      '  잘린 파일입니다. 온전한 파일을 구하십시오.' ].
mesh_ko(short_face(Corners)) -->
    [ '면이나 선의 꼭지점이 모자랍니다: ~d개'-[Corners], nl,
      '  면은 셋, 선은 둘이 필요합니다. 고치거나 지우십시오.' ].
mesh_ko(too_large) -->
    [ '꼭지점이나 모서리가 2,147,483,647개보다 많습니다', nl,
      '  모델을 여러 파일로 나누십시오.' ].
mesh_ko(no_property(Property, Element)) -->
    [ '요소 ~w 에 속성 ~w 이(가) 하나 필요합니다'-[Element, Property], nl,
      '  모델을 보통의 PLY 로 다시 내보내십시오.' ].

fault_ko(mesh_write(unsupported(Text))) -->
    [ '이 형식은 ~w 을(를) 담을 수 없습니다'-[Text], nl,
      '  .obj 나 .ply 로 쓰십시오.' ].

fault_ko(written(faulty(S, Rounds, What))) -->
    [ '세그먼트 ~d을(를) 쓰지 않았다, ~D번 뒤: '-[S, Rounds] ],
    unwritten_ko(What).
fault_ko(no_triangles(S, P)) -->
    [ '세그먼트 ~d의 다각형 ~d에 삼각형이 없습니다'-[S, P], nl,
      '  잘못된 다각형일 수 있습니다: check로 살펴보거나 complete_segments를 \c
       부르십시오.' ].

notice_ko(mesh(File, degenerate(N))) -->
    [ '~w: 서로 다른 세 꼭지점이 없는 면 ~D개를 뺐습니다'-[File, N] ].
notice_ko(mesh(File, ignored(N, Line))) -->
    [ '~w: 모르는 항목 ~D개를 건너뛰었습니다. 처음은 ~D번째 줄'-
      [File, N, Line] ].
notice_ko(mesh(File, no_curves(N))) -->
    [ '~w: STL에는 곡선이 없어 ~D개를 뺐습니다'-[File, N] ].
notice_ko(written(File, What)) -->
    [ '~w: '-[File] ],
    written_ko(What).
notice_ko(mesh(File, trailing(Bytes))) -->
    [ '~w: 메시 뒤의 ~D 바이트를 건너뛰었습니다'-[File, Bytes] ].


                /*******************************
                *            drawing           *
                *******************************/

drawing_ko(domain(sheet_size, W-H)) -->
    { number(W), number(H) },
    [ '그림이 ~0f x ~0f mm 나 된다'-[W,H], nl,
      '  더 작은 --scale을 쓴다. 각 변은 0보다 크고 100000 mm까지 된다.' ].
drawing_ko(domain(sheet_size, Size)) -->
    [ '~p은(는) 종이의 크기가 아니다'-[Size], nl,
      '  너비x높이를 210x148처럼 mm로 쓴다. 100000까지 된다.' ].
drawing_ko(domain(raster_size, W-H)) -->
    [ '그림은 ~p x ~p 점이 될 수 없다'-[W, H], nl,
      '  한 변은 1에서 16384까지, 모두 6700만 점까지 된다.' ].
drawing_ko(domain(dot_pattern, Pattern)) -->
    [ '~p은(는) 점의 무늬가 아니다'-[Pattern], nl,
      '  N개 찍고 N개 비우는 N이나 목록 [찍음, 비움, ...]으로 쓴다.' ].
drawing_ko(domain(drawing_format, Ending)) -->
    [ '확장자 .~w인 그림은 없다'-[Ending], nl,
      '  그림은 .svg .pdf .eps .ps .png .dxf .hpgl .json .pl 파일이다.' ].
drawing_ko(domain(dashes, How)) -->
    [ '점선은 auto, geometry, type 가운데 하나이며 ~p 은(는) 아니다'-[How] ].
drawing_ko(domain(png, How)) -->
    [ 'PNG 는 smooth 또는 dots 이며 ~p 은(는) 아니다'-[How] ].

notice_ko(sheet_tiny(N:M, How)) -->
    sheet_tiny_ko(N, M, How).
notice_ko(nothing_drawn) -->
    [ '그릴 것이 없습니다' ].


                /*******************************
                *             view             *
                *******************************/

fault_ko(eye_in_model(D)) -->
    [ '시점이 모델 안이나 뒤에 있습니다: 가장 가까운 점이 ~4g 입니다'-[D], nl,
      '  RHO 를 더 크게 하거나 평행 투상을 쓰십시오.' ].


                /*******************************
                *           decision           *
                *******************************/

fault_ko(rules(no_decision(PI))) -->
    [ '~q 은(는) 판단의 이름이 아니고, 이 규칙 파일에서 부르지도 않습니다'-[PI],
      nl,
      '  이름을 고치거나(rules/0 이 이름을 보여 줍니다) 지우십시오.' ].
fault_ko(rules(no_decisions)) -->
    [ '이 규칙 파일은 아무 판단도 바꾸지 않습니다', nl,
      '  rules/0 이 보여 주는 판단 가운데 하나를 정의하십시오.' ].
fault_ko(rules(module_file)) -->
    [ '규칙 파일에는 모듈 머리말이 없어야 합니다', nl,
      '  지시문 :- module(...) 을 지우십시오.' ].
fault_ko(rules(Formal)) -->
    { \+ memberchk(Formal, [no_decision(_), no_decisions, module_file]) },
    [ '이 규칙 파일을 읽을 수 없습니다: ' ],
    loading_fault(Formal),
    [ nl, '  고치십시오. 규칙은 전과 같습니다.' ].

notice_ko(decision(Name/Arity, Doc, By)) -->
    [ '~q/~d: ~w'-[Name, Arity, Doc], nl,
      '    정의한 곳: ~w'-[By] ].


                /*******************************
                *         triangulation        *
                *******************************/

fault_ko(no_third_vertex(V1, V2)) -->
    [ '꼭지점 ~d 에서 ~d 로 가는 모서리에 셋째 꼭지점이 없습니다'-[V1, V2], nl,
      '  다각형이 그곳에서 스스로 엇갈리거나 겹칩니다.' ].
fault_ko(polygon_edge(S, P, V1, V2)) -->
    invalid_polygon_ko(S, P, V1, V2).

notice_ko(polygon_edge(S, P, V1, V2)) -->
    invalid_polygon_ko(S, P, V1, V2),
    [ nl, '  빼고 계속합니다.' ].
notice_ko(no_area(S, Count, P)) -->
    [ '세그먼트 ~d 의 다각형 ~D개는 넓이가 없습니다 (처음은 ~d)'-
      [S, Count, P], nl,
      '  빼고 계속합니다.' ].
fault_ko(tolerance(Tolerance, Most)) -->
    [ '허용 오차 ~4g 는 너무 큽니다: 그보다 별로 크지 않은 부분이 있습니다'-
      [Tolerance], nl,
      '  --tolerance 를 ~4g 이하로 주거나 빼십시오.'-[Most] ].
fault_ko(result_open) -->
    [ '결과가 닫히지 않습니다', nl,
      '  --tolerance 를 바꾸거나 --repair 로 피연산자를 고치십시오.' ].

notice_ko(opened(contacts)) -->
    [ '거의 닿는 곳을 그대로 두었습니다: 아니면 결과가 열립니다', nl,
      '  부스러기가 남을 수 있습니다.' ].
notice_ko(opened(faces)) -->
    [ '한 평면의 면들을 나눈 채 두었습니다: 합치면 결과가 열립니다' ].
notice_ko(contacts(Why)) -->
    contacts_ko(Why),
    [ nl, '  선은 모델 그대로에 대해 정확하지만, 가는 조각이 있을 수 있습니다.' ].
notice_ko(not_flat(S, Count, P, Off)) -->
    [ '세그먼트 ~d 의 다각형 ~D개는 평평하지 않습니다 (가장 심한 ~d: ~4g)'-
      [S, Count, P, Off], nl,
      '  삼각형으로 나누어 씁니다.' ].

invalid_polygon_ko(S, P, V1, V2) -->
    [ '세그먼트 ~d 의 다각형 ~d 은(는) 꼭지점 ~d 와 ~d 사이에서 스스로 \c
       엇갈리거나 겹칩니다'-[S, P, V1, V2] ].


                /*******************************
                *         hidden_lines         *
                *******************************/

notice_ko(lines_by_rules(Lines, Each)) -->
    [ '선 ~D 개를 커널이 아니라 규칙으로 그렸습니다: 판단이 바뀌었습니다'-[Lines], nl,
      '  선마다 ~1f 마이크로초'-[Each] ].


                /*******************************
                *             help             *
                *******************************/

notice_ko(no_help(What, Names)) -->
    [ '~p에 대한 도움말이 없습니다'-[What], nl ],
    (   { Names == [] }
    ->  [ '  help. 를 입력하면 목록을 볼 수 있습니다.' ]
    ;   { atomic_list_concat(Names, ', ', All) },
        [ '  비슷한 이름: ~w. 전체 목록은 help. 로 볼 수 있습니다.'-[All] ]
    ).
notice_ko(prolog_help(PI, Where)) -->
    [ '~q은(는) Prolog 자체의 것입니다 (~q). 설명서:'-[PI, Where], nl ],
    manual_page(PI).


                /*******************************
                *            explain           *
                *******************************/

notice_ko(because(Statement)) -->
    statement_ko(Statement).
notice_ko(nothing_to_explain(piece(S, P))) -->
    !,
    [ '~p 에는 설명할 것이 없습니다'-[piece(S, P)], nl,
      '  piece(S, P) 는 입체의 연산인 세그먼트 S 의 다각형 P 이고, \c
       piece(S, S0-P0) 는 그 피연산자 S0 의 다각형 P0 입니다.' ].
notice_ko(nothing_to_explain(Item)) -->
    { memberchk(Item, [hidden(_), hidden(_, _), why_not(_)]) },
    !,
    hidden_ko(nothing(Item)).
notice_ko(nothing_to_explain(Item)) -->
    [ '~p: 설명할 것이 없습니다'-[Item], nl,
      '  line(L), vertex(S, V), edge(S, E), pair(S1-P1, S2-P2), \c
       pair(S1, S2), piece(S, P), piece(S, S0-P0) 를 모델의 번호로 \c
       물어보십시오. 선은 penetrate 다음에 \c
       있습니다. seam(S, E), fold(S, E), pattern(S, K) 는 세그먼트 S 의 \c
       전개도에 관한 것입니다.' ].
%   허용 오차 안의 접촉을 맞추지 못한 까닭 (resolve.pl).

contacts_ko(wide(S, V)) -->
    [ '세그먼트 ~d 의 꼭짓점 ~d 이(가) 허용 오차의 세 배보다 넓게 다른 것과 '-
      [S, V], '이어져 있습니다;', nl,
      '  허용 오차 안에서 닿는 것을 그대로 두었습니다.' ].
contacts_ko(stuck(S, P)) -->
    [ '세그먼트 ~d 의 다각형 ~d 이(가) 허용 오차 안에서 닿는 것을 모두 '-
      [S, P], '받아들이지 못합니다;', nl, '  그대로 두었습니다.' ].
