:- module(sg_session_en,
          [ session_en//1               % +What
          ]).
:- use_module(message_parts, [meant_en//1]).
/** <module> What is wrong with a frame or a request of a session, in English;
session_ko.pl has the same heads in Korean.
*/

%!  session_en(+What)// is semidet.
%
%   What is wrong, and what to do.

session_en(frame(truncated)) -->
    [ 'the input ends in the middle of a frame' ].
session_en(frame(too_large(N))) -->
    [ 'a frame of ~D octets is too large'-[N], nl,
      '  A frame has 1,048,576 at most; name a file instead.' ].
session_en(frame(short(N))) -->
    [ 'a frame of ~D octets has no room for the length of its head'-[N] ].
session_en(frame(head_too_long(H))) -->
    [ 'the head of a frame is said to have ~D octets, more than the \c
       frame'-[H] ].
session_en(frame(not_utf8)) -->
    [ 'the head of a frame is not UTF-8' ].
session_en(frame(not_json)) -->
    [ 'the head of a frame is not JSON' ].
session_en(frame(not_an_object)) -->
    [ 'the head of a frame is JSON, but no object {...}' ].
session_en(frame(too_deep(Most))) -->
    [ 'the head of a frame has more than ~D objects and lists in one \c
       another'-[Most] ].
session_en(unknown_do(Do, Near, All)) -->
    { atomic_list_concat(All, ', ', Known) },
    [ 'a session does not do "~w"'-[Do] ],
    meant_en(Near),
    [ nl, '  It does: ~w.'-[Known] ].
session_en(bad_key(Key, Wanted)) -->
    [ 'the request needs a key "~w": '-[Key] ],
    wanted_en(Wanted).
session_en(verb_refused(Verb)) -->
    [ 'a session does not do the verb ~w'-[Verb], nl,
      '  Start it as a process of its own.' ].
session_en(no_folder(Folder)) -->
    [ '"cwd" is not the name of a folder that is there: ~p'-[Folder] ].
session_en(printed(Most)) -->
    [ 'the verb printed more than ~D octets'-[Most], nl,
      '  Let it write a file: -o FILE.' ].

wanted_en(verb) -->
    [ 'a verb and its arguments, like ["draw", "tee.pl", "-o", "tee.svg"], \c
       without the character 0' ].
wanted_en(request) -->
    [ 'what is to be done, like "run"' ].
wanted_en(language) -->
    [ '"en" or "ko"' ].
wanted_en(positive) -->
    [ 'a number above 0' ].
