:- encoding(utf8).
:- module(sg_model_ko,
          [ model_ko//1,                % +What
            limit_ko//1                 % +Name
          ]).
:- use_module('../csg/csg_term', [near_operands/2]).
:- use_module(look_ko,
              [look_ko//1, expected_look_ko//1, expected_light_ko//1]).
:- use_module(message_parts,
              [meant_ko//1, shown_count/2, shown_value/2]).
:- use_module(prolog_ko, [korean_syntax//1]).
:- use_module('../primitive/primitive', [primitive_name/2]).
:- use_module(primitive_en, [primitive_names//0]).
:- use_module(parameter_ko, [parameter_ko//1]).
:- use_module(primitive_ko, [misshapen_ko//1]).
:- use_module(library(apply), [maplist/3]).
/** <module> What is wrong with the text or the facts of a model, in Korean.

model_en.pl has the same heads in English.
*/

%!  model_ko(+What)// is semidet.
%
%   The message for model_error(What): what is wrong, and what to do.

model_ko(cannot_read(missing)) -->
    [ '그런 파일이 없습니다', nl,
      '  이름과 폴더를 확인하십시오.' ].
model_ko(cannot_read(directory)) -->
    [ '파일이 아니라 폴더입니다', nl,
      '  그 안의 파일을 지정하십시오.' ].
model_ko(cannot_read(permission)) -->
    [ '파일을 읽을 권한이 없습니다', nl,
      '  접근 권한을 확인하십시오.' ].
model_ko(cannot_read(io)) -->
    [ '파일을 끝까지 읽을 수 없습니다', nl,
      '  디스크를 확인하거나 파일을 다시 복사하십시오.' ].
model_ko(cannot_read(links)) -->
    [ '링크가 서로를 끝없이 가리킵니다', nl,
      '  파일을 지정하거나 링크를 바로잡으십시오(ls -l).' ].
model_ko(cannot_read(device)) -->
    [ '끝이 없는 장치입니다', nl,
      '  파일을 주십시오.' ].
model_ko(cannot_read(long_name)) -->
    [ '파일 이름이 너무 깁니다', nl,
      '  대부분의 시스템에서 255바이트, 폴더를 합해 4,095바이트까지입니다.' ].
model_ko(cannot_read(Why)) -->
    { \+ memberchk(Why, [missing, directory, permission, io, links,
                         long_name, device]) },
    [ '파일을 읽을 수 없습니다: ~p'-[Why] ].
model_ko(cityjson(Path, Why)) -->
    [ 'CityJSON의 ~w: '-[Path] ],
    cityjson_ko(Why),
    [ nl, '  파일에서 아무것도 읽지 않았습니다. 검사 프로그램으로 더 볼 수 있습니다.' ].
model_ko(syntax(end_of_file)) -->
    [ '사실의 중간에서 파일이 끝납니다', nl,
      '  파일이 잘렸을 수 있습니다. 사실은 마침표로 끝납니다.' ].
model_ko(syntax(end_of_file_in_quoted(_))) -->
    [ '여기서 시작한 따옴표가 닫히지 않고 파일이 끝납니다', nl,
      '  따옴표를 닫거나 온전한 파일을 구하십시오.' ].
model_ko(syntax(too_deep)) -->
    [ '항이 너무 깊게 겹쳐 있어 읽을 수 없습니다', nl,
      '  수, 아톰, 짧은 리스트로 사실을 쓰십시오.' ].
model_ko(syntax(Message)) -->
    { \+ memberchk(Message, [end_of_file, end_of_file_in_quoted(_),
                             too_deep]) },
    [ 'Prolog 문법에 맞지 않습니다: ' ],
    korean_syntax(Message),
    [ nl,
      '  v(1, 1, 0.0, 0.0, 0.0). 처럼 마침표로 끝나는 사실을 쓰십시오.' ].
model_ko(limit(Name, Most)) -->
    limit_ko(Name),
    [ ': ~D을(를) 넘습니다'-[Most], nl ],
    limit_way_ko(Name).
model_ko(limit(Name, Count, Most)) -->
    { shown_count(Count, Shown) },
    limit_ko(Name),
    [ ': ~w. 한도는 ~D입니다'-[Shown, Most], nl ],
    limit_way_ko(Name).
model_ko(early_end) -->
    [ '파일 중간에 end_of_file이 있습니다', nl,
      '  지우십시오. 뒤의 내용을 잃게 됩니다.' ].
model_ko(directive(Goal)) -->
    [ '모델 파일에 지시문이 있습니다: :- ~p'-[Goal], nl,
      '  모델은 자료이며 실행되지 않습니다. 규칙은 --rules FILE로 주십시오.' ].
model_ko(rule(Head)) -->
    [ '모델 파일에 규칙이 있습니다: ~p :- ...'-[Head], nl,
      '  모델은 사실로만 된 자료입니다. 규칙은 --rules FILE로 주십시오.' ].
model_ko(no_fact(Term)) -->
    [ '사실이 아닙니다: ~p'-[Term], nl,
      '  v(1, 1, 0.0, 0.0, 0.0). 같은 사실을 쓰십시오.' ].
model_ko(unknown_relation(Name, Arity)) -->
    [ '~q/~d: 그런 관계는 없습니다'-[Name, Arity], nl,
      '  모델의 관계: v/5, e/5, p/3, plane/6, t/6, segment/3, \c
       leaf_v/5, leaf_e/5, leaf_p/3, leaf_t/6, origin/3, from_v/4, \c
       from_p/5, line/9, curve/2, view/3, projection/1, \c
       title_block/2, look/2, light/2, param/2, \c
       question/2.' ].
model_ko(arity(Name, Arity, Wanted)) -->
    [ '~w의 인수가 ~d개입니다. ~d개여야 합니다'-[Name, Arity, Wanted], nl,
      '  ~w/~d의 설명과 비교하십시오.'-[Name, Wanted] ].
model_ko(computed(Name)) -->
    [ '~w: 시점에서 계산되므로 파일에 둘 수 없습니다'-[Name], nl,
      '  지우십시오. draw가 다시 만듭니다.' ].
model_ko(value(Relation, Column, Value, Expected)) -->
    { shown_value(Value, Shown) },
    [ '~w의 ~w: ~w. 있어야 할 것: '-
      [Relation, Column, Shown] ],
    expected_ko(Expected).
model_ko(missing(Relation, S, Id)) -->
    { relation_word(Relation, Word) },
    [ '세그먼트 ~d에 ~w ~d이(가) 없습니다'-[S, Word, Id], nl,
      '  추가하거나 번호를 고치십시오.' ].
model_ko(twice(Name, Key)) -->
    [ '~w 사실이 둘 있습니다: '-[Name] ],
    key_ko(Key),
    [ nl, '  하나를 지우거나 다른 번호를 주십시오.' ].
model_ko(polygon(S, P, Why)) -->
    [ '세그먼트 ~d의 다각형 ~d: '-[S, P] ],
    polygon_ko(Why).
model_ko(chain(S, V)) -->
    [ '세그먼트 ~d의 곡선이 꼭짓점 ~d에서 자기 자신으로 갑니다'-[S, V], nl,
      '  꼭짓점을 한 번씩만 쓰십시오.' ].
model_ko(formula(What, Formula)) -->
    parameter_ko(formula(What, Formula)).
model_ko(parameter(What)) -->
    parameter_ko(What).
model_ko(kind(Term, Kind, Wanted)) -->
    { primitive_name(Term, Name) },
    [ '~w: 종류가 ~w(이)어야 하는데 ~w입니다'-[Name, Wanted, Kind], nl,
      '  segment(S, ~w, ~w(...))로 쓰십시오.'-[Wanted, Name] ].
model_ko(no_vertices(_, Name)) -->
    misshapen_ko(Name),
    !,
    [ nl, '  아니면 세그먼트에 v/5와 p/3을 쓰십시오.' ].
model_ko(no_vertices(S, Name)) -->
    [ '세그먼트 ~d에 꼭짓점이 없고, 이름이 기본 입체도 아닙니다: ~p'-[S, Name] ],
    { near_operands(Name, Near) },
    meant_ko(Near),
    [ nl,
      '  v/5와 p/3, 연산(docs/model_files.md), 또는 기본 입체를 쓰십시오: ' ],
    primitive_names.
model_ko(curve_polygon(S, P)) -->
    [ '세그먼트 ~d은(는) 곡선인데 다각형 ~d이(가) 있습니다'-[S, P], nl,
      '  종류를 surface나 solid로 쓰거나 다각형을 빼십시오.' ].
model_ko(no_edges(S)) -->
    [ '세그먼트 ~d에 다각형도 모서리도 없습니다'-[S], nl,
      '  p/3, e/5 또는 curve/2를 추가하십시오.' ].
model_ko(title_block_only(Name)) -->
    [ '표제란 파일에 ~w 사실은 쓸 수 없습니다'-[Name], nl,
      '  title_block(Item, Text)만 쓰십시오. 보기: \c
       title_block(name, "받침대").' ].
model_ko(look(What)) -->
    look_ko(What).
model_ko(empty) -->
    [ '모델이 비어 있습니다', nl,
      '  꼭짓점과 다각형이 있는 세그먼트를 하나 이상 주십시오.' ].
model_ko(refused(Row, Error)) -->
    [ '불가능한 사실 ~p: ~p'-[Row, Error] ].
model_ko(unknown_format('', Formats)) -->
    !,
    { atomic_list_concat(Formats, ' .', All) },
    [ '파일의 종류를 정하는 확장자가 없습니다', nl,
      '  모델의 확장자는 .~w입니다. 또는 --from과 함께 표준 입력(-)으로 \c
       주십시오.'-[All] ].
model_ko(unknown_format(Format, Formats)) -->
    { atomic_list_concat(Formats, ' .', All) },
    [ '.~w 형식은 모릅니다'-[Format], nl,
      '  모델의 확장자는 .~w입니다.'-[All] ].

expected_ko(id) -->
    [ '1에서 2147483647까지의 정수', nl,
      '  세그먼트, 꼭짓점, 모서리, 다각형의 번호는 1부터입니다.' ].
expected_ko(ids) -->
    [ '양의 정수의 리스트' ].
expected_ko(steps) -->
    [ '정수의 리스트', nl,
      '  [1, 2, 3]처럼 다각형의 꼭짓점을 쓰십시오. 음수는 건너뜀입니다.' ].
expected_ko(chain) -->
    [ '하나 이상의 꼭짓점 번호의 리스트' ].
expected_ko(float) -->
    [ '수', nl, '  -1.5나 2.0e-3처럼 숫자로 쓰십시오.' ].
expected_ko(number) -->
    [ '수 또는 식', nl,
      '  길이는 모델의 단위, 각은 도이며 단위는 쓰지 않습니다.' ].
expected_ko(distance) -->
    [ '0 이상의 수 (0: 필요한 만큼 멀리)' ].
expected_ko(finite) -->
    [ '유한한 수', nl,
      '  무한대와 NaN은 쓸 수 없습니다. 그것을 쓴 프로그램을 고치십시오.' ].
expected_ko(within(Most)) -->
    [ '-~w과(와) ~w 사이'-[Most, Most], nl,
      '  다른 단위를 쓰십시오. 이 크기로는 계산할 수 없습니다.' ].
expected_ko(text) -->
    [ '텍스트, 수, 또는 아톰' ].
expected_ko(words) -->
    [ '비어 있지 않은 텍스트나 아톰' ].
expected_ko(look(What)) -->
    expected_look_ko(What).
expected_ko(light(What)) -->
    expected_light_ko(What).
expected_ko(ground) -->
    [ '아톰, 수, 또는 그것으로 된 복합항', nl,
      '  변수와 "문자열"은 안 됩니다. 이름은 \'이렇게\' 따옴표로 쓰십시오.' ].
expected_ko(loose) -->
    [ '꼭짓점 v(V) 또는 모서리 e(E)' ].
expected_ko(around) -->
    [ '영역 r(R) 또는 다각형 p(P)' ].
expected_ko(atom) -->
    [ '아톰' ].
expected_ko(one_of(Atoms)) -->
    { atomic_list_concat(Atoms, ', ', Text) },
    [ '다음의 하나: ~w'-[Text] ].

relation_word(v, '꼭짓점').
relation_word(e, '모서리').
relation_word(p, '다각형').
relation_word(region, '영역').
relation_word(leaf_e, leaf_e).

key_ko(Key) -->
    (   { is_list(Key) }
    ->  { maplist(term_to_atom, Key, Words),
          atomic_list_concat(Words, ', ', Text) },
        [ '번호 ~w'-[Text] ]
    ;   { Key == - }
    ->  [ '하나만 있을 수 있습니다' ]
    ;   [ '~q에는 하나만 있을 수 있습니다'-[Key] ]
    ).

polygon_ko(list) -->
    [ '리스트의 건너뜀이 갈 곳이 없습니다', nl,
      '  음수는 닫힌 루프 다음에 와서 새 루프를 시작합니다: \c
       [1,2,3,1,-4,5,6,4].' ].
polygon_ko(edges(N)) -->
    [ '모서리가 ~d개입니다. 셋 이상이어야 합니다'-[N] ].
polygon_ko(open(V)) -->
    [ '꼭짓점 ~d에서 닫히지 않습니다'-[V], nl,
      '  꼭짓점마다 들어오는 모서리와 나가는 모서리의 수가 같아야 합니다. \c
       건너뛴 루프는 첫 꼭짓점을 다시 써서 닫으십시오.' ].
polygon_ko(twice(V1, V2)) -->
    [ '~d에서 ~d(으)로 가는 모서리가 둘 있습니다'-[V1, V2], nl,
      '  한 걸음은 한 번만 쓰십시오. 구멍은 반대로 돕니다.' ].
polygon_ko(no_edge(V)) -->
    [ '꼭짓점 ~d에서 자기 자신으로 가는 모서리가 있습니다'-[V], nl,
      '  꼭짓점을 한 번만 쓰십시오.' ].


                /*******************************
                *            limits            *
                *******************************/

%!  limit_ko(+Name)// is det.
%
%   What the limit Name (limits.pl) is of.

limit_ko(depth) -->
    [ '겹쳐 있는 항, 리스트, 연산자의 깊이' ].
limit_ko(blocks) -->
    [ '.csg 파일에서 겹쳐 있는 블록' ].
limit_ko(digits) -->
    [ '수 하나의 글자 수' ].
limit_ko(name) -->
    [ '이름이나 텍스트 하나의 글자 수' ].
limit_ko(fact) -->
    [ '사실 하나의 글자 수' ].
limit_ko(file) -->
    [ '.csg나 CityJSON 파일의 바이트' ].
limit_ko(text) -->
    [ '텍스트의 바이트' ].
limit_ko(clauses) -->
    [ '규칙 파일 하나의 절' ].
limit_ko(facets) -->
    [ '기본 입체 하나의 꼭짓점' ].
limit_ko(values) -->
    [ '변수 하나의 값' ].
limit_ko(variants) -->
    [ '문제 하나의 변형' ].
limit_ko(nodes) -->
    [ '트리의 리프, 쓰이는 횟수만큼' ].

limit_way_ko(Name) -->
    [ '  더 허용하려면 --limits ~w=N, 프로그램에서는 set_limit(~w, N).'-
      [Name, Name] ].

cityjson_ko(syntax) -->
    [ 'JSON이 아닙니다' ].
cityjson_ko(no_cityjson) -->
    [ 'type이 "CityJSON"이 아닙니다' ].
cityjson_ko(version(Version)) -->
    [ '모르는 버전입니다: ~w. 1.0, 1.1, 2.0 이어야 합니다'-[Version] ].
cityjson_ko(missing(Key)) -->
    [ '"~w"이(가) 없습니다'-[Key] ].
cityjson_ko(nesting) -->
    [ '목록이나 객체의 중첩이 그 종류에 맞지 않습니다' ].
cityjson_ko(triple) -->
    [ '수 세 개가 있어야 합니다' ].
cityjson_ko(too_far) -->
    [ '좌표가 1e90보다 멉니다' ].
cityjson_ko(index(Index)) -->
    [ '꼭짓점 번호가 있어야 하는데 ~p입니다'-[Index] ].
cityjson_ko(index(Index, Count)) -->
    [ '꼭짓점 ~d번이 없습니다. 0번부터 ~D개입니다'-[Index, Count] ].
cityjson_ko(ring) -->
    [ '루프의 꼭짓점이 셋보다 적습니다' ].
cityjson_ko(geometry(Type)) -->
    [ '모르는 형상입니다: ~p'-[Type] ].
cityjson_ko(no_lod(Lod)) -->
    [ '상세 수준 ~w인 형상이 없습니다'-[Lod] ].
