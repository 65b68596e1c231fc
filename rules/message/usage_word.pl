:- encoding(utf8).
:- module(sg_usage_word,
          [ form_ko/2                   % +Form, -Korean
          ]).
:- use_module(library(apply), [foldl/4]).
/** <module> What stands for a word in forms of options, in Korean.
*/

%!  form_ko(+Form, -Korean) is det.
%
%   Korean, an atom, is Form, such as `NAME=VALUE`, with Korean words for those
%   in capitals. Single letters stay.

form_ko(Form, Korean) :-
    findall(Word-Ko, word_ko(Word, Ko), Pairs),
    foldl(word_replaced, Pairs, Form, Korean).

word_replaced(Word-Korean, Form0, Form) :-
    atomic_list_concat(Parts, Word, Form0),
    atomic_list_concat(Parts, Korean, Form).

word_ko('VERB', '명령').
word_ko('OPTION', '옵션').
word_ko('MODEL', '모델').
word_ko('GOAL', '목표').
word_ko('ITEM', '항목').
word_ko('MANIFEST', '작업목록').
word_ko('ADDRESS', '주소').
word_ko('ANGLE', '투상법').
word_ko('AXIS', '축').
word_ko('BY', '기준').
word_ko('COLOUR', '색').
word_ko('DEGREES', '각도').
word_ko('FILE', '파일').
word_ko('FOLDER', '폴더').
word_ko('FORMAT', '형식').
word_ko('HOW', '방식').
word_ko('KIND', '종류').
word_ko('ORIGIN', '출처').
word_ko('PATH', '경로').
word_ko('LANGUAGE', '언어').
word_ko('LOD', '단계').
word_ko('MM', 'mm').
word_ko('NAME', '이름').
word_ko('VALUE', '값').
word_ko('PAPER', '용지').
word_ko('REPORT', '보고서').
word_ko('PLANE', '평면').
word_ko('SHADE', '음영').
word_ko('SIDE', '쪽').
word_ko('UNIT', '단위').
word_ko('URL', '주소').
word_ko('VIEWS', '투상도,...').
word_ko('VIEW', '투상도').
word_ko('WHAT', '대상').
word_ko('WHICH', '어느것').
