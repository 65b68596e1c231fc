:- encoding(utf8).
:- module(sg_session_ko,
          [ session_ko//1               % +What
          ]).
:- use_module(message_parts, [meant_ko//1]).
/** <module> What is wrong with a frame or a request of a session, in Korean;
session_en.pl has the same heads.
*/

%!  session_ko(+What)// is semidet.
%
%   What is wrong, and what to do.

session_ko(frame(truncated)) -->
    [ '입력이 프레임 도중에 끝납니다' ].
session_ko(frame(too_large(N))) -->
    [ '~D바이트의 프레임은 너무 큽니다'-[N], nl,
      '  프레임은 1,048,576바이트까지입니다. 대신 파일 이름을 쓰십시오.' ].
session_ko(frame(short(N))) -->
    [ '~D바이트의 프레임에는 머리의 길이가 들어갈 자리가 없습니다'-[N] ].
session_ko(frame(head_too_long(H))) -->
    [ '프레임의 머리가 ~D바이트라고 하나 프레임보다 깁니다'-[H] ].
session_ko(frame(not_utf8)) -->
    [ '프레임의 머리가 UTF-8이 아닙니다' ].
session_ko(frame(not_json)) -->
    [ '프레임의 머리가 JSON이 아닙니다' ].
session_ko(frame(not_an_object)) -->
    [ '프레임의 머리가 JSON이지만 객체 {...}가 아닙니다' ].
session_ko(frame(too_deep(Most))) -->
    [ '프레임의 머리에 객체와 목록이 ~D겹 넘게 겹쳐 있습니다'-[Most] ].
session_ko(unknown_do(Do, Near, All)) -->
    { atomic_list_concat(All, ', ', Known) },
    [ '세션은 "~w" 요청을 하지 않습니다'-[Do] ],
    meant_ko(Near),
    [ nl, '  하는 것: ~w.'-[Known] ].
session_ko(bad_key(Key, Wanted)) -->
    [ '요청에는 "~w" 키가 있어야 합니다: '-[Key] ],
    wanted_ko(Wanted).
session_ko(verb_refused(Verb)) -->
    [ '세션은 ~w 명령을 하지 않습니다'-[Verb], nl,
      '  따로 프로세스를 시작하십시오.' ].
session_ko(no_folder(Folder)) -->
    [ '"cwd"가 있는 폴더의 이름이 아닙니다: ~p'-[Folder] ].
session_ko(printed(Most)) -->
    [ '명령이 ~D바이트 넘게 출력했습니다'-[Most], nl,
      '  파일에 쓰게 하십시오: -o FILE.' ].

wanted_ko(verb) -->
    [ '["draw", "tee.pl", "-o", "tee.svg"]처럼 명령과 그 인자. 문자 0은 없이' ].
wanted_ko(request) -->
    [ '할 일. "run"처럼' ].
wanted_ko(language) -->
    [ '"en" 또는 "ko"' ].
wanted_ko(positive) -->
    [ '0보다 큰 수' ].
