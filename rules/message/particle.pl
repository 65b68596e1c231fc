:- encoding(utf8).
:- module(sg_particle,
          [ particles_joined/2,         % +Text, -Joined
            lines_joined/2,             % +Lines, -Joined
            particle/3                  % +Text, +Pair, -Particle
          ]).
:- use_module(library(apply), [foldl/4, maplist/2]).
:- use_module(library(lists), [member/2, reverse/2]).
/** <module> Korean particles that fit the word before them.

A particle has two forms, for a word that ends in a vowel and for one that ends
in a consonant, and joins the word. What stands before it in a message is often
a number, a name or a file, so sentences are written with both forms, `은(는)`,
and the one that is read is chosen when the sentence is complete. A name in
Latin letters is read as English words are in Korean: `box` 박스, `cone` 콘,
`handle` 핸들. Both forms stay only where nothing can be read.
*/

% pair(Both, Consonant, L, Vowel): after a consonant, after ㄹ, after a vowel.

pair('은(는)', '은', '은', '는').
pair('는(은)', '은', '은', '는').
pair('이(가)', '이', '이', '가').
pair('가(이)', '이', '이', '가').
pair('을(를)', '을', '을', '를').
pair('를(을)', '을', '을', '를').
pair('과(와)', '과', '과', '와').
pair('와(과)', '과', '과', '와').
pair('(으)로', '으로', '로', '로').
pair('(이)라', '이라', '이라', '라').
pair('(이)며', '이며', '이며', '며').
pair('(이)면', '이면', '이면', '면').
pair('(이)나', '이나', '이나', '나').
pair('(이)어야', '이어야', '이어야', '여야').

%!  particles_joined(+Text, -Joined:string) is det.
%
%   Joined is Text in which each pair of particles is the one that is read, and
%   joins its word.

particles_joined(Text, Joined) :-
    atom_string(Text, Text1),
    (   sub_string(Text1, _, _, _, ")"),
        pair_in(Text1, Before, Both, After)
    ->  stripped_end(Before, Word),
        (   Word == ""
        ->  format(string(Start), "~w~w", [Before, Both])
        ;   particle(Word, Both, Particle),
            string_concat(Word, Particle, Start)
        ),
        particles_joined(After, Rest),
        string_concat(Start, Rest, Joined)
    ;   Joined = Text1
    ).

%   pair_in(Text, Before, Both, After): the first pair in Text.

pair_in(Text, Before, Both, After) :-
    findall(At-Both0,
            ( pair(Both0, _, _, _),
              once(sub_string(Text, At, _, _, Both0)) ),
            Found0),
    keysort(Found0, [At-Both|_]),
    sub_string(Text, 0, At, _, Before),
    atom_length(Both, Length),
    From is At+Length,
    sub_string(Text, From, _, 0, After).

stripped_end(Text, Stripped) :-
    (   string_concat(Shorter, " ", Text)
    ->  stripped_end(Shorter, Stripped)
    ;   Stripped = Text
    ).

%!  lines_joined(+Lines, -Joined) is det.
%
%   As particles_joined/2 of the lines of a message, what print_message_lines/3
%   prints: a word and its particle may stand in two elements of a line.
%   Variables are written as `_`.

lines_joined(Lines0, Lines) :-
    foldl(line_joined, Lines0, none-[], Last-Reversed0),
    kept(Last, Reversed0, Reversed),
    reverse(Reversed, Lines).

%   line_joined(Element, Text0-Out0, Text-Out): Text is what of the line is not
%   put out yet, or `none`; Out what is, from the last element back.

line_joined(Element, Text0-Out0, Text-Out) :-
    (   element_text(Element, Own)
    ->  (   Text0 == none
        ->  Text = Own
        ;   string_concat(Text0, Own, Text)
        ),
        Out = Out0
    ;   kept(Text0, Out0, Out1),
        Text = none,
        Out = [Element|Out1]
    ).

kept(none, Out, Out) :-
    !.
kept(Text, Out, ['~w'-[Joined]|Out]) :-
    particles_joined(Text, Joined).

element_text(Format-Arguments0, Text) :-
    !,
    copy_term(Arguments0, Arguments),
    term_variables(Arguments, Variables),
    maplist(=('$VAR'('_')), Variables),
    format(string(Text), Format, Arguments).
element_text(Element, Text) :-
    atomic(Element),
    \+ memberchk(Element, [nl,flush,at_same_line]),
    format(string(Text), Element, []).

%!  particle(+Text, +Both, -Particle:string) is det.
%
%   Particle is the form of Both, such as '은(는)', that joins Text as it is read;
%   Both itself if that is not known.

particle(Text, Both, Particle) :-
    pair(Both, Consonant, L, Vowel),
    !,
    string_codes(Text, Codes),
    spoken(Codes, Reversed),
    ending(Reversed, End),
    form(End, Both, Consonant, L, Vowel, Form),
    atom_string(Form, Particle).

form(consonant, _, Form, _, _, Form).
form(l, _, _, Form, _, Form).
form(vowel, _, _, _, Form, Form).
form(unknown, Both, _, _, _, Both).

%   spoken(Codes, Reversed): what is read, backwards: without a last remark in
%   brackets (the word before counts) and closing quotes.

spoken(Codes, Reversed) :-
    reverse(Codes, Reversed0),
    (   Reversed0 = [0')|Inner],
        remark_off(Inner, 1, Before),
        Before = [Code|_],
        ( Code =:= 0'\s ; Code >= 0xac00, Code =< 0xd7a3 )
    ->  quotes_off(Before, Reversed)
    ;   quotes_off(Reversed0, Reversed)
    ).

%   remark_off(Codes, Depth, Before): what stands before the bracket that opens
%   the remark.

remark_off([Code|Codes], Depth0, Before) :-
    (   Code =:= 0'(
    ->  Depth is Depth0-1
    ;   Code =:= 0')
    ->  Depth is Depth0+1
    ;   Depth = Depth0
    ),
    (   Depth =:= 0
    ->  Before = Codes
    ;   remark_off(Codes, Depth, Before)
    ).

quotes_off([Code|Codes], Reversed) :-
    member(Code, `"'\s\`]}>’”»`),
    !,
    quotes_off(Codes, Reversed).
quotes_off(Codes, Codes).

%   ending(Reversed, End): how what is read ends: in a `vowel`, in ㄹ (`l`), in
%   another `consonant`; or `unknown`.

ending([Code|_], End) :-
    Code >= 0xac00,
    Code =< 0xd7a3,
    !,
    Final is (Code-0xac00) mod 28,
    (   Final =:= 0
    ->  End = vowel
    ;   Final =:= 8
    ->  End = l
    ;   End = consonant
    ).
ending([0'%|_], vowel) :-               % 퍼센트
    !.
ending([0'°|_], vowel) :-               % 도
    !.
ending([0'm|Codes], vowel) :-           % 밀리미터
    unit_before(Codes),
    !.
ending([0'0|Codes], End) :-
    !,
    zeros([0'0|Codes], 0, N, Rest),
    (   N >= 12,                        % 조
        N < 16,
        Rest = [Digit|_],
        code_type(Digit, digit)
    ->  End = vowel
    ;   End = consonant                 % 영, 십, 백, 천, 만, 억
    ).
ending([Code|_], End) :-
    code_type(Code, digit),
    !,
    digit_ending(Code, End).
ending(Reversed, End) :-
    letters(Reversed, Letters0, Rest),
    Letters0 = [_|_],
    !,
    reverse(Letters0, Letters),
    atom_codes(Word, Letters),
    downcase_atom(Word, Low),
    (   latin_ending(Letters, Low, Rest, End)
    ->  true
    ;   atom_codes(Low, Codes),
        reverse(Codes, Backwards),
        word_ending(Backwards, End)
    ).
ending([_,Code|Reversed], End) :-       % brackets, dashes: what is before them
    \+ code_type(Code, space),
    !,
    ending([Code|Reversed], End).
ending(_, unknown).

%   일, 칠, 팔; 삼, 육; 이, 사, 오, 구.

digit_ending(Code, End) :-
    (   memberchk(Code, `178`)
    ->  End = l
    ;   memberchk(Code, `36`)
    ->  End = consonant
    ;   End = vowel
    ).

unit_before([Code|Codes]) :-
    (   code_type(Code, digit)
    ->  true
    ;   Code =:= 0'\s
    ->  Codes = [Digit|_],
        code_type(Digit, digit)
    ;   memberchk(Code, `cmk`),
        unit_before(Codes)
    ).

zeros([0'0|Codes], N0, N, Rest) :-
    !,
    N1 is N0+1,
    zeros(Codes, N1, N, Rest).
zeros([0',|Codes], N0, N, Rest) :-
    !,
    zeros(Codes, N0, N, Rest).
zeros(Codes, N, N, Codes).

letters([Code|Codes], [Code|Letters], Rest) :-
    Code < 128,
    code_type(Code, alpha),
    Code =\= 0'_,
    !,
    letters(Codes, Letters, Rest).
letters(Codes, [], Codes).

%   latin_ending(Letters, Low, Rest, End): a word that everybody says; else
%   capitals, a single letter and the ending of a file are spelt. Rest is what
%   stands before, backwards.

latin_ending(_, Low, _, End) :-
    said(Low, End),
    !.
latin_ending(Letters, Low, Rest, End) :-
    spelt(Letters, Rest),
    sub_atom(Low, _, 1, 0, Last),
    letter_ending(Last, End).

said(prolog, vowel).                    % 프롤로그
said(json, consonant).
said(html, l).
said(openscad, vowel).
said(slurm, consonant).

spelt(Letters, [0'.,Before|_]) :-
    \+ code_type(Before, space),
    length(Letters, N),
    N =< 4,
    !.
spelt([_], Rest) :-
    (   Rest = [Before|_],
        Before =\= 0'_
    ->  \+ code_type(Before, csym)
    ;   true
    ),
    !.
spelt(Letters, Rest) :-
    \+ ( member(Letter, Letters),
         \+ code_type(Letter, upper) ),
    (   Rest = [Before|_]
    ->  \+ code_type(Before, csym)
    ;   true
    ).

%   word_ending(Backwards, End): a word of small letters, backwards. 핸들, 홀;
%   콘, 플레인, 프레임; 모델; 링; 블록, 톱, 슬롯 but 탱크, 루프, 시트, 파트;
%   else a vowel: 박스, 커브, 헤더, 파이프.

word_ending([0'e,Letter|_], End) :-
    memberchk(Letter-End, [0'l-l,0'n-consonant,0'm-consonant]),
    !.
word_ending([0'l|_], l) :-
    !.
word_ending([Letter|_], consonant) :-
    memberchk(Letter, `mn`),
    !.
word_ending([0'g,0'n|_], consonant) :-
    !.
word_ending([0'k,0'c|_], consonant) :-
    !.
word_ending([Stop,Vowel,Before|_], consonant) :-
    memberchk(Stop, `cpkt`),
    is_vowel(Vowel),
    \+ is_vowel(Before),
    !.
word_ending(_, vowel).

is_vowel(Letter) :-
    memberchk(Letter, `aeiou`).

%   엘; 엠, 엔; 알; else a vowel: 에이, 비, 에스, 에프, 엑스 ...

letter_ending(l, l) :-
    !.
letter_ending(Letter, consonant) :-
    memberchk(Letter, [m,n]),
    !.
letter_ending(r, l) :-
    !.
letter_ending(_, vowel).
