:- encoding(utf8).
:- module(test_korean, []).
% covers: usage_ko
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(command/usage)).
:- use_module(rules(command/usage_print)).
:- use_module(rules(message/particle)).

/* The Korean of messages and of --help, as it stands in the source: particles
after what is filled in have both forms, and join their word; one word for one
thing; errors and notices speak politely, what explain.pl says and --help do
not; and nothing is in English alone. */

korean_file(File) :-
    absolute_file_name(rules(message), Folder, [file_type(directory)]),
    directory_files(Folder, Names),
    member(Name, Names),
    atom_concat(_, '_ko.pl', Name),
    atomic_list_concat([Folder,/,Name], File).
korean_file(File) :-
    member(Name, [command/usage, command/usage_ko, command/usage_print,
                  command/usage_unfold, command/usage_render,
                  command/report, command/unfold_report,
                  pattern/plate_words]),
    absolute_file_name(rules(Name), File, [extensions([pl]), access(read)]).

%   korean_text(File, Text) is nondet: Text is an atom or a string of File with
%   Korean in it.

korean_text(File, Text) :-
    korean_file(File),
    text_of(File, Text).

text_of(File, Text) :-
    read_file_to_terms(File, Terms, [encoding(utf8), module(test_korean)]),
    member(Term, Terms),
    sub_term_text(Term, Text).

sub_term_text(Term, Text) :-
    (   ( atom(Term) ; string(Term) )
    ->  atom_string(Term, Text),
        string_codes(Text, Codes),
        once(( member(Code, Codes), hangul(Code) ))
    ;   compound(Term),
        arg(_, Term, Argument),
        sub_term_text(Argument, Text)
    ).

hangul(Code) :-
    Code >= 0xac00,
    Code =< 0xd7a3.

polite_file(File) :-
    file_base_name(File, Name),
    \+ sub_atom(Name, 0, _, _, usage),
    \+ sub_atom(Name, 0, _, _, explain),
    \+ memberchk(Name, ['about_ko.pl','session_ko.pl']).

%   Particles with one form alone after what is filled in, and those that stand
%   apart from it.

one_form(Particle) :-
    member(Particle, ["은","는","이","가","을","를","과","와","로","으로",
                      "로도","으로도","로는","으로는","라는","이라는","라고",
                      "이라고","이라","이며","이나","이면","이어야","여야"]).

hard_wired(Text) :-
    sub_string(Text, At, 1, _, "~"),
    directive_end(Text, At, End),
    sub_string(Text, End, _, 0, Rest0),
    brackets_off(Rest0, Rest),
    one_form(Particle),
    string_concat(Particle, After, Rest),
    ends_here(After).

directive_end(Text, At, End) :-
    From is At+1,
    between(From, 99999, I),
    sub_string(Text, I, 1, _, Char),
    \+ memberchk(Char, ["0","1","2","3","4","5","6","7","8","9","*"]),
    !,
    memberchk(Char, ["d","w","p","q","D","g","f","s","a"]),
    End is I+1.

brackets_off(Text0, Text) :-
    (   member(Bracket, [")","]","\""]),
        string_concat(Bracket, Text1, Text0)
    ->  brackets_off(Text1, Text)
    ;   Text = Text0
    ).

ends_here(After) :-
    (   After == ""
    ->  true
    ;   sub_string(After, 0, 1, _, Char),
        memberchk(Char, [" ",".",",",":",";","?","\n"])
    ).

apart(Text) :-
    member(Both, ["은(는)","이(가)","을(를)","과(와)","와(과)","(으)로"]),
    string_concat(" ", Both, Apart),
    sub_string(Text, _, _, _, Apart).
apart(Text) :-
    sub_string(Text, At, 1, _, "~"),
    directive_end(Text, At, End),
    sub_string(Text, End, _, 0, Rest0),
    brackets_off(Rest0, Rest),
    member(Particle, ["은","는","을","를","과","와","로","으로","로도","로는",
                      "의","에","에서","에는","에게","도","까지","부터",
                      "입니다"]),
    string_concat(" ", Particle, Apart),
    string_concat(Apart, After, Rest),
    ends_here(After).

% old(Word, Instead): words that were used for two things, or for one besides
% another.

old("꼭지점", "꼭짓점").            old(" 은선", "숨은선").
old("점선", "파선").                old("솔기", "접합선").
old("이음매", "접합선").            old("풀칠 날개", "풀칠면").
old("풀칠 자리", "풀칠면").         old("변이관", "변환관").
old("프리미티브", "기본 입체").     old("모형", "모델").
old("판단", "결정").                old("구실", "역할").
old("프레디킷", "술어").            old("프롤로그", "Prolog").
old("배정도", "배정밀도").          old("선택 사항", "옵션").
old("모선", "면소").                old("종이", "용지").
old("엇갈", "교차").                old("동사", "명령").
old("혹시", "비슷한 것").           old("연귀", "마이터 이음").

%   A sentence ends so in the plain form.

plainly(Text) :-
    sentence_end(Text, End),
    member(Plain, ["다"]),
    string_concat(_, Plain, End),
    \+ string_concat(_, "니다", End),
    \+ ( member(Noun, ["보다","마다","이다"]), string_concat(_, Noun, End) ).

politely(Text) :-
    sentence_end(Text, End),
    ( string_concat(_, "니다", End) ; string_concat(_, "십시오", End) ),
    \+ string_concat(_, "아니다", End).

%   sentence_end(Text, End) is nondet: where a sentence ends, of its words.

sentence_end(Text, End) :-
    split_string(Text, ".\n", " .\n", Sentences),
    member(Sentence, Sentences),
    (   sub_string(Sentence, At, _, _, " (")
    ->  sub_string(Sentence, 0, At, _, End)
    ;   End = Sentence
    ).

:- begin_tests(korean).

test(read, true(N > 900)) :-
    aggregate_all(count, korean_text(_, _), N).
test(particles, Bad == []) :-
    findall(Text, ( korean_text(_, Text), once(hard_wired(Text)) ), Bad).
test(particles_join, Bad == []) :-
    findall(Text, ( korean_text(_, Text), once(apart(Text)) ), Bad).
test(checked, Found == [true,false,true,false,true,false,true,
                               false]) :-
    maplist([Goal,Truth]>>( call(Goal) -> Truth = true ; Truth = false ),
            [ hard_wired("세그먼트 ~d는 없습니다"),
              hard_wired("세그먼트 ~d은(는) 없습니다"),
              apart("세그먼트 ~d 은(는) 없습니다"),
              apart("세그먼트 ~d은(는) 없습니다"),
              apart("척도 ~w:~w 로도 작습니다"),
              apart("척도 ~w:~w로도 작습니다"),
              plainly("파일이 없다. 고치십시오"),
              plainly("파일이 없습니다. 고치십시오") ], Found).
test(words, Bad == []) :-
    findall(Word-Text, ( korean_text(_, Text), old(Word, _),
                         sub_string(Text, At, _, _, Word),
                         \+ sub_string(Text, At, _, _, "종이접기") ),
            Bad).
test(polite, Bad == []) :-
    findall(Text, ( korean_file(File), polite_file(File), text_of(File, Text),
                    once(plainly(Text)) ),
            Bad).
test(plain, Bad == []) :-
    findall(Text,
            ( korean_file(File), \+ polite_file(File),
              file_base_name(File, Name), Name \== 'session_ko.pl',
              text_of(File, Text), once(politely(Text)),
              \+ to_the_reader(Text) ),
            Bad).
test(no_english, Bad == []) :-
    findall(Verb-Line,
            ( verb(Verb, _, _, _),
              with_output_to(string(Help), print_usage(Verb, ko)),
              split_string(Help, "\n", "", Lines),
              member(Line, Lines),
              sub_string(Line, _, _, _, "--"),
              \+ sub_string(Line, _, _, _, "sanggwan "),
              \+ ( string_codes(Line, Codes), member(Code, Codes),
                   hangul(Code) ) ),
            Bad).

%   Errors in the files of explanations.
to_the_reader(Text) :-
    sub_string(Text, _, _, _, "설명할 것이 없습니다").
to_the_reader(Text) :-
    member(Part, ["그림을 만드십시오", "점 X입니다", "  glued(S, v(V))"]),
    sub_string(Text, _, _, _, Part).

:- end_tests(korean).
