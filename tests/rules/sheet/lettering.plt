:- encoding(utf8).
:- module(test_lettering, []).
:- use_module(library(plunit)).
:- use_module(rules(sheet/lettering)).
:- use_module(rules(sheet/letter)).
:- use_module(rules(sheet/hangul)).

% All points of the letters of a text 6 high, in tenths: y is up from the base.
points(Anchor, String, Points) :-
    lettering(text(0,0,6000,Anchor,String), Lines),
    findall(X-Up, ( member(Line, Lines), member(X-Y, Line), Up is -Y ),
            Points).

box(Anchor, String, box(X0,Y0,X1,Y1)) :-
    points(Anchor, String, Points),
    findall(X, member(X-_, Points), Xs),
    findall(Y, member(_-Y, Points), Ys),
    min_list(Xs, X0),
    max_list(Xs, X1),
    min_list(Ys, Y0),
    max_list(Ys, Y1).

unknown(Lines) :-
    lettering(text(0,0,6000,start,"\u4E2D"), Lines).

code(String, Code) :-
    string_codes(String, [Code]).

:- begin_tests(lettering).

test(capital, true(Lines == [ [0-0,0-(-6000),4000-0,4000-(-6000)] ])) :-
    lettering(text(0,0,6000,start,"N"), Lines).
test(place_and_height, true(Lines == [[100-200,100-(-3300)]])) :-
    lettering(text(100,200,3500,start,"I"), Lines).
test(all_of_ascii, forall(between(32, 126, Code))) :-
    once(letter(Code, Width, Strokes)),
    Width >= 0,
    ( Code =:= 32 -> Strokes == [] ; Strokes = [_|_] ).
test(once_each, forall(letter(Code, _, _))) :-
    findall(W, letter(Code, W, _), [_]).
test(letters_keep_to_their_width, forall(( letter(Code, Width, [_|_]),
                                           Code =\= 32 ))) :-
    string_codes(String, [Code]),
    box(start, String, box(X0,Y0,X1,Y1)),
    X0 >= 0,
    X1 =< Width*1000+1,
    Y0 >= -2000,
    Y1 =< 6900.
test(capitals_are_as_high, [forall(between(0'A, 0'Z, Code)),
                            true(Y1 == 6000)]) :-
    string_codes(String, [Code]),
    box(start, String, box(_,_,_,Y1)).
test(middle, true(X0 =:= -X1)) :-
    box(middle, "HOH", box(X0,_,X1,_)).
test(end, true(X1 == 0)) :-
    box(end, "HOH", box(_,_,X1,_)).
test(width, true(abs(Width-X1) =< 1)) :-
    box(start, "HOHOH", box(_,_,X1,_)),
    lettering_width("HOHOH", 6000, Width).
test(empty, true(Lines-Width == []-0)) :-
    lettering(text(0,0,6000,start,""), Lines),
    lettering_width("", 6000, Width0),
    Width is integer(Width0).
test(unknown_is_a_box, true(Lines == [[0-0,0-(-6000),4000-(-6000),4000-0,
                                       0-0]])) :-
    unknown(Lines).

% Every syllable of Unicode is drawn, in its square, and no two are alike.
test(all_syllables, true(Out == [])) :-
    findall(Code,
            ( between(0xAC00, 0xD7A3, Code),
              \+ ( syllable(Code, 6, Strokes),
                   Strokes = [_|_],
                   forall(( member(Stroke, Strokes), member(P, Stroke) ),
                          within(P)) )
            ),
            Out).
test(syllables_differ, true(N == 11172)) :-
    findall(Strokes, ( between(0xAC00, 0xD7A3, Code),
                       syllable(Code, _, Strokes) ), All),
    sort(All, Different),
    length(Different, N).
test(no_syllable, [forall(member(Code, [0xABFF, 0xD7A4, 0x41, 0x4E2D])),
                   fail]) :-
    syllable(Code, _, _).
% As many strokes as their letters have.
test(strokes, [forall(member(String-Count, [ "\uAC00"-3, "\uACE0"-3,
                                             "\uB73B"-5, "\uC0C1"-5 ])),
               true(N == Count)]) :-
    code(String, Code),
    syllable(Code, _, Strokes),
    length(Strokes, N).

within(P) :-
    ( P = X-Y ; P = c(X,Y) ),
    !,
    X >= 0,
    X =< 6,
    Y >= -0.7,
    Y =< 6.7.

:- end_tests(lettering).
