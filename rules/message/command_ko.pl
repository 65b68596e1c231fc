:- encoding(utf8).
:- module(sg_command_ko,
          [ command_ko//1               % +What
          ]).
:- use_module(usage_word, [form_ko/2]).
:- use_module(batch_ko, [batch_usage_ko//1]).
:- use_module(message_parts, [meant_ko//1]).
:- use_module(prolog_ko, [korean_syntax//1]).
:- use_module(model_ko, [limit_ko//1, model_ko//1]).
:- use_module(parameter_ko, [parameter_ko//1]).
:- use_module(pattern_ko, [pattern_fault_ko//1]).
:- use_module(sheet_ko, [sheet_ko//1]).
:- use_module(unfold_ko, [wish_ko//3, unfold_ko//1]).
/** <module> What is wrong with a command line, in Korean.

command_en.pl has the same heads in English.
*/

%!  command_ko(+What)// is semidet.
%
%   The message for usage_error(What).

command_ko(no_verb) -->
    [ '무엇을 할까요?', nl, '  sanggwan --help를 보십시오.' ].
command_ko(unknown_verb(Verb, Near)) -->
    [ '~w: 없는 명령입니다'-[Verb] ],
    meant_ko(Near),
    [ nl, '  sanggwan --help를 보십시오.' ].
command_ko(unknown_option(Text, Near)) -->
    [ '~w: 없는 옵션입니다'-[Text] ],
    meant_ko(Near),
    [ nl, '  sanggwan 명령 --help를 보십시오.' ].
command_ko(no_value(Text)) -->
    [ '~w 옵션은 값을 받지 않습니다'-[Text] ].
command_ko(needs_value(Text, What)) -->
    [ '~w 옵션에는 값이 필요합니다: ~w'-[Text, What], nl,
      '  쓸 수 있는 값은 sanggwan 명령 --help에 있습니다.' ].
command_ko(option_twice(Text)) -->
    [ '~w 옵션이 두 번 주어졌습니다'-[Text] ].
command_ko(bad_value(Text, Value, one_of(Words))) -->
    { atomic_list_concat(Words, ', ', All) },
    [ '~w: ~w 값은 쓸 수 없습니다. 쓸 수 있는 값: ~w'-[Text, Value, All] ].
command_ko(bad_value(Text, Value, number(Low))) -->
    [ '~w: ~w 값은 ~w 이상의 수가 아닙니다'-[Text, Value, Low] ].
command_ko(bad_value(Text, Value, number(Low, High))) -->
    [ '~w: ~w 값은 ~w 이상 ~w 이하의 수가 아닙니다'-[Text, Value, Low, High] ].
command_ko(bad_value(Text, Value, above(Low))) -->
    [ '~w: ~w 값은 ~w보다 큰 수가 아닙니다'-[Text, Value, Low] ].
command_ko(bad_value(Text, Value, whole(Low, High))) -->
    [ '~w: ~w 값은 ~w 이상 ~w 이하의 정수가 아닙니다'-
      [Text, Value, Low, High] ].
command_ko(no_clear_dots(Format)) -->
    [ '.~w 형식에는 투명한 점이 없습니다'-[Format], nl,
      '  --background에 색을 주거나 .png로 쓰십시오.' ].
command_ko(shade_in_dots(Format)) -->
    [ '.~w 형식에는 선만 있는데 이 음영은 점으로 되어 있습니다'-[Format], nl,
      '  펜으로 긋는 음영은 --shade hatch로 하십시오.' ].
command_ko(no_size(Text, Value)) -->
    [ '~w: ~w 값은 크기가 아닙니다. 너비와 높이는 0보다 커야 합니다'-
      [Text, Value] ].
command_ko(bad_value(Text, Value, no_normal)) -->
    !,
    [ '~w: ~w 값은 평면이 아닙니다'-[Text, Value], nl,
      '  A,B,C,D는 평면 A*X + B*Y + C*Z + D = 0이고, A, B, C 가운데 하나는 \c
       0이 아니어야 합니다.' ].
command_ko(bad_value(Text, Value, Form)) -->
    { atom(Form),
      form_ko(Form, Korean)
    },
    [ '~w: ~w 값은 ~w 꼴이어야 합니다'-[Text, Value, Korean] ].
command_ko(one_model(Verb, File)) -->
    [ '~w 명령은 모델 하나를 보여 줍니다. 하나 더 있는 것: ~p'-[Verb, File] ].
command_ko(port_taken(Port)) -->
    [ '다른 프로그램이 포트 ~w번을 쓰고 있습니다'-[Port], nl,
      '  --port에 다른 번호를 쓰거나 이 옵션을 빼십시오.' ].
command_ko(port_refused(Port)) -->
    [ '이 사용자는 포트 ~w번을 쓸 수 없습니다'-[Port], nl,
      '  --port에 1024 이상을 쓰십시오.' ].
command_ko(host_needs_class(Host)) -->
    [ '--host ~w은(는) 다른 사람을 들이는데, 모두가 한 모델을 바꾸게 됩니다'-
          [Host], nl,
      '  --class를 더하면 저마다 모델을 하나씩 가집니다. 아니면 --host를 빼고 \c
       터널(ssh -L)로 들어오십시오.' ].
command_ko(behind(URL)) -->
    [ '--behind ~w: 페이지의 주소가 아닙니다'-[URL], nl,
      '  사람들이 보는 대로 쓰십시오. 보기: https://h.example/sanggwan/' ].
command_ko(socket_alone(Path)) -->
    [ '--socket ~w: 프록시가 쓰는 것입니다'-[Path], nl,
      '  사람들이 페이지를 보는 주소를 --behind에 쓰고 --port와 --host를 \c
       빼십시오.' ].
command_ko(socket_taken(Path)) -->
    [ '다른 프로그램이 ~w에서 받고 있습니다'-[Path], nl,
      '  --socket에 다른 경로를 쓰거나 그 프로그램을 끝내십시오.' ].
command_ko(no_socket(Path)) -->
    [ '~w에 소켓을 만들지 못합니다'-[Path], nl,
      '  폴더가 있고 쓸 수 있어야 하며, 같은 이름의 다른 것이 없어야 하고, \c
       경로는 107바이트까지입니다.' ].
command_ko(socket_passed('')) -->
    [ '넘겨받은 것(LISTEN_FDS)이 받고 있는 유닉스 소켓 하나가 아닙니다', nl,
      '  systemd의 유닛에는 ListenStream=에 경로 하나, Accept=no를 쓰십시오.' ].
command_ko(socket_passed(Path)) -->
    [ '넘겨받은 소켓은 ~w에서 받고 있습니다'-[Path], nl,
      '  --behind와 함께 쓰십시오: --socket ~w'-[Path] ].
command_ko(embed(URL)) -->
    [ '--embed ~w: 페이지의 출처가 아닙니다'-[URL], nl,
      '  경로 없이 쓰십시오. 보기: https://h.example' ].
command_ko(no_address(Host)) -->
    [ '이 컴퓨터에는 ~p 주소가 없습니다'-[Host], nl,
      '  --host를 빼십시오. 그러면 이 컴퓨터에서만 열 수 있습니다.' ].
command_ko(no_files_taken(Verb, File)) -->
    [ '~w 명령은 파일을 받지 않습니다: ~p'-[Verb, File] ].
command_ko(no_files(What)) -->
    [ '~w: 주어지지 않았습니다'-[What], nl,
      '  sanggwan 명령 --help를 보십시오.' ].
command_ko(unfold(S, Wish, What)) -->
    wish_ko(S, Wish, What).
command_ko(unfold(What)) -->
    unfold_ko(What).
command_ko(one_operand(Verb)) -->
    [ '~w 명령에는 모델이 둘 이상 필요합니다'-[Verb], nl,
      '  다른 모델도 지정하십시오. 파일 하나가 피연산자 하나입니다.' ].
command_ko(both_options(A, B)) -->
    [ '~w 옵션과 ~w 옵션은 함께 쓸 수 없습니다'-[A, B] ].
command_ko(needs_one_of(Options)) -->
    { atomic_list_concat(Options, ', ', Text) },
    [ '옵션이 빠졌습니다: ~w 가운데 하나'-[Text] ].
command_ko(no_output) -->
    [ '결과를 어디에 둘까요? -o FILE을 주십시오 (-는 표준 출력)' ].
command_ko(replaces_model(File)) -->
    [ '~w 파일은 모델이며, 결과가 그 자리를 차지하게 됩니다'-[File], nl,
      '  결과에 다른 이름을 주십시오.' ].
command_ko(ending(File, Endings)) -->
    { atomic_list_concat(Endings, ' .', All) },
    [ '~w: 확장자가 형식을 정합니다. 쓸 수 있는 것: .~w'-[File, All] ].
command_ko(no_folder(Folder)) -->
    [ '결과를 둘 폴더가 없습니다: ~w'-[Folder], nl,
      '  먼저 만드십시오.' ].
command_ko(cannot_write(File, permission)) -->
    [ '~w: 결과를 거기에 쓸 수 없습니다'-[File], nl,
      '  파일과 폴더의 권한을 확인하거나 다른 폴더를 쓰십시오.' ].
command_ko(cannot_write(output, Why)) -->
    [ '결과를 쓸 수 없습니다: ~w'-[Why], nl,
      '  자리를 만들거나 다른 곳으로 보내십시오.' ].
command_ko(cannot_write(File, no_folder)) -->
    [ '~w: 결과를 둘 폴더가 없습니다'-[File], nl,
      '  먼저 만드십시오. 링크라면 링크가 가리키는 폴더입니다.' ].
command_ko(cannot_write(File, directory)) -->
    [ '~w: 폴더입니다. 결과는 파일에 씁니다'-[File], nl,
      '  결과에 다른 이름을 주십시오.' ].
command_ko(cannot_write(File, full)) -->
    [ '~w 파일을 쓸 수 없습니다: 디스크가 가득 찼습니다'-[File], nl,
      '  자리를 만들거나 다른 곳으로 보내십시오. 아무것도 쓰지 않았습니다.' ].
command_ko(cannot_write(File, too_large)) -->
    [ '~w 파일을 쓸 수 없습니다: 시스템이 그렇게 큰 파일을 허용하지 않습니다'-[File],
      nl,
      '  제한을 높이거나(ulimit -f) 더 적게 쓰십시오. 아무것도 쓰지 않았습니다.' ].
command_ko(cannot_write(File, long_name)) -->
    [ '~w: 파일 이름이 너무 깁니다'-[File], nl,
      '  대부분의 시스템에서 255바이트, 폴더를 합해 4,095바이트까지입니다.' ].
command_ko(cannot_write(File, links)) -->
    [ '~w: 자기 자신으로 돌아오는 링크입니다'-[File], nl,
      '  링크를 지우거나 결과에 다른 이름을 주십시오.' ].
command_ko(cannot_write(File, Why)) -->
    [ '~w 파일을 쓸 수 없습니다: ~w'-[File, Why], nl,
      '  결과를 다른 곳에 두십시오.' ].
command_ko(large_by_rule) -->
    [ 'pixel_colour/4의 규칙이 있습니다. 많아야 점 67108864개까지 묻습니다', nl,
      '  --size 값을 줄이거나 그림을 나누어(--window) 만드십시오.' ].
command_ko(no_segment(S, Known)) -->
    { atomic_list_concat(Known, ', ', All) },
    [ '세그먼트 ~w: 없습니다. 있는 것: ~w'-[S, All] ].
command_ko(parameter(setting(Text, limit(Name, Most)))) -->
    !,
    [ '--set ~w: '-[Text] ],
    model_ko(limit(Name, Most)).
command_ko(parameter(What)) -->
    parameter_ko(What).
command_ko(pattern(What)) -->
    pattern_fault_ko(What).
command_ko(batch(What)) -->
    batch_usage_ko(What).
command_ko(each(What)) -->
    each_ko(What).
command_ko(sheet(What)) -->
    sheet_ko(What).
command_ko(exact_format(Format)) -->
    [ '--exact 옵션은 표(csv, tsv, txt)에 쓰며 ~w 형식에는 쓸 수 없습니다'-[Format] ].
command_ko(bad_goal(_, limit(Name, Most))) -->
    [ '목표의 텍스트가 너무 큽니다. ' ],
    limit_ko(Name),
    [ ': ~D 까지입니다'-[Most], nl,
      '  더 허용하려면 --limits ~w=N, 프로그램에서는 set_limit(~w, N).'-
      [Name, Name] ].
command_ko(bad_goal(Text, after_full_stop)) -->
    [ '첫 마침표 뒤에 글이 더 있습니다: ~w'-[Text], nl,
      '  목표는 한 번에 하나입니다. 여러 목표는 쉼표로 이으십시오.' ].
command_ko(bad_goal(Text, Why)) -->
    { Why \= limit(_, _),
      Why \== after_full_stop
    },
    [ '목표가 아닙니다: ~w ('-[Text] ],
    korean_syntax(Why),
    [ ')' ].

%   each_ko(What)//

each_ko(standard_input) -->
    [ '--each 옵션에는 표준 입력(-)을 쓸 수 없습니다. 이름이 없기 때문입니다', nl,
      '  --each 옵션을 빼거나 파일 이름을 주십시오.' ].
each_ko(no_place(Option, Text)) -->
    [ '~w ~w: --each 옵션이 있으면 파일 이름이 들어갈 자리 %가 있어야 합니다'-
      [Option, Text], nl,
      '  보기: \'%.svg\', \'plans/%.pdf\'.' ].
each_ko(same_output(Output, File, File)) -->
    !,
    [ '~w 파일이 두 번 있어 ~w 파일에 두 번 쓰게 됩니다'-[File, Output], nl,
      '  파일마다 한 번만 쓰십시오.' ].
each_ko(same_output(Output, File1, File2)) -->
    [ '~w 파일은 ~w 파일과 ~w 파일의 결과를 함께 담을 수 없습니다'-
      [Output, File1, File2], nl,
      '  이름이 같은 파일은 명령을 나누어 하십시오.' ].
each_ko(model_output(Output)) -->
    [ '~w: 주어진 파일이며, 다른 파일의 결과가 그 자리를 차지하게 됩니다'-
      [Output], nl,
      '  결과를 다른 폴더에 두십시오: -o \'FOLDER/%.pl\'.' ].
each_ko(json_alone) -->
    [ '여기에서 --json 옵션은 --each 옵션과 함께 씁니다. 파일마다 한 줄입니다' ].
each_ko(rules_remain(File)) -->
    [ '~w 파일에서 규칙이 프로그램에 되돌릴 수 없는 일을 했습니다'-[File], nl,
      '  그 뒤의 파일은 하지 않았습니다. 파일마다 따로 명령을 내리십시오.' ].
