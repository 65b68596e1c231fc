:- encoding(utf8).
:- module(sg_problem_explanation,
          [ answer_why/5                % +Variant, +Ask, +Answer, +Language,
                                        % -Text
          ]).
:- use_module(problem_item, [measure_unit/4]).
:- use_module(problem_measure, [measure_working/4]).
:- use_module('../vector', [angle_between/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists),
              [ list_to_set/2, max_list/2, member/2, min_list/2 ]).
/** <module> Why an answer is right: what it comes from, in words and numbers.
*/

%!  answer_why(+Variant, +Ask, +Answer, +Language, -Text:string) is det.
%
%   Text, in Language, says how the Answer to Ask, count(loops) or a measure of
%   Variant, comes about; "" where the drawing says all of it. The world is that
%   of Variant (problem_variant.pl).

answer_why(variant(_,_,_,_,found(Points,_,_),_), ask(count(loops)), _,
           Language, Text) :-
    !,
    findall(Loop, ( member(point(_,Loop,_,_), Points), Loop > 0 ), Loops0),
    list_to_set(Loops0, Loops),
    findall(Range,
            ( member(Loop, Loops),
              loop_range(Points, Loop, Range) ),
            Ranges),
    loops_said(Language, Ranges, Text).
answer_why(variant(_,_,_,asked(_,N,_,_),found(Points,_,_),_),
           ask(measure(Measure,Unit,Tolerance)), Answer, Language, Text) :-
    measure_unit(Unit, _, Size, Word),
    (   measure_working(Measure, N, Points, Working),
        Decimals is max(0, ceiling(-log10(Tolerance) - 0.01)) + 1,
        worked(Working, Measure, as(Size,Word,Decimals), Answer, Language,
               Text0)
    ->  Text = Text0
    ;   Text = ""
    ).

%   loop_range(Points, Loop, Range): the numbers of its points.

loop_range(Points, Loop, Range) :-
    findall(I, member(point(I,Loop,_,_), Points), Is),
    min_list(Is, First),
    max_list(Is, Last),
    (   First =:= Last
    ->  format(string(Range), "~d", [First])
    ;   format(string(Range), "~d–~d", [First,Last])
    ).

loops_said(_, [], "") :-
    !.
loops_said(en, Ranges, Text) :-
    atomics_to_text(Ranges, "; ", List),
    format(string(Text),
           "Followed from point to point, each line comes back to where it \c
            began: points ~s.", [List]).
loops_said(ko, Ranges, Text) :-
    atomics_to_text(Ranges, "; ", List),
    format(string(Text),
           "점을 차례로 따라가면 선마다 처음 점으로 돌아온다: 점 ~s.", [List]).

atomics_to_text(Parts, Between, Text) :-
    atomic_list_concat(Parts, Between, Atom),
    atom_string(Atom, Text).

%   worked(Working, Measure, As, Answer, Language, Text): lengths are shown as
%   As, as(Size, Word, Decimals), says.

worked(legs(Legs), _, As, Answer, Language, Text) :-
    shown_point(Legs, As, [X,Y,Z]),
    legs_said(Language, [X,Y,Z,X,Y,Z,Answer], Text).
worked(arms(P, Q), _, as(_,_,Decimals), Answer, Language, Text) :-
    As = as(1.0,"",Decimals),
    shown_point(P, As, [A,B,C]),
    shown_point(Q, As, [D,E,F]),
    angle_between(P, Q, Radians),
    Cosine is cos(Radians),
    format(string(Cos), "~4f", [Cosine]),
    arms_said(Language, [A,B,C,D,E,F,Cos,Answer], Text).
worked(lengths(Pieces), Measure, As, Answer, Language, Text) :-
    findall(Length-I-Piece,
            ( member(Piece, Pieces), member(I-Length, Piece) ),
            All),
    (   Measure = shortest_generator(_)
    ->  Most = shortest,
        aggregate_all(min(L, J-P), member(L-J-P, All), min(_, I-Piece))
    ;   Most = longest,
        aggregate_all(max(L, J-P), member(L-J-P, All), max(_, I-Piece))
    ),
    findall(Shown,
            ( member(J-L, Piece),
              shown_length(As, L, Figure),
              format(string(Shown), "~d: ~s", [J,Figure]) ),
            Shown0),
    list_to_set(Shown0, Each),
    atomics_to_text(Each, ", ", List),
    lengths_said(Language, Most, [List,I,Answer], Text).
worked(cone(R, L), _, as(_,_,Decimals), Answer, Language, Text) :-
    maplist(shown_length(as(1.0,"",Decimals)), [R,L], [Radius,Length]),
    cone_said(Language, [Radius,Length,Radius,Length,Answer], Text).
worked(pieces(Areas), _, as(Size,_,Decimals), Answer, Language, Text) :-
    Areas = [_,_|_],
    maplist(shown_length(as(Size,"",Decimals)), Areas, Shown),
    atomics_to_text(Shown, " + ", Sum),
    pieces_said(Language, [Sum,Answer], Text).
worked(from(Lowest, At), coordinate(_, Axis), As, Answer, Language, Text) :-
    maplist(shown_length(As), [At,Lowest], [There,Begin]),
    from_said(Language, Axis, [There,Begin,Answer], Text).

shown_length(as(Size,_,Decimals), Length, Text) :-
    In is Length/Size,
    format(string(Text0), "~*f", [Decimals,In]),
    (   catch(number_string(Zero, Text0), error(_, _), fail),
        Zero =:= 0
    ->  format(string(Text), "~*f", [Decimals,0])
    ;   Text = Text0
    ).

shown_point(p(X,Y,Z), As, Texts) :-
    maplist(shown_length(As), [X,Y,Z], Texts).

legs_said(en, Given, Text) :-
    format(string(Text),
           "Along x, y and z it is ~s, ~s and ~s: \c
            √((~s)² + (~s)² + (~s)²) = ~w.", Given).
legs_said(ko, Given, Text) :-
    format(string(Text),
           "x, y, z 방향의 길이가 ~s, ~s, ~s이다. \c
            √((~s)² + (~s)² + (~s)²) = ~w.", Given).

arms_said(en, Given, Text) :-
    format(string(Text),
           "The sides run (~s, ~s, ~s) and (~s, ~s, ~s) from their corner. \c
            The cosine of their angle is ~s, so it is ~w.", Given).
arms_said(ko, Given, Text) :-
    format(string(Text),
           "꼭짓점에서 두 변의 방향은 (~s, ~s, ~s), (~s, ~s, ~s)이다. 코사인이 \c
            ~s이므로 각은 ~w.", Given).

lengths_said(en, Most, [List,I,Answer], Text) :-
    format(string(Text),
           "The true lengths of the generators are (~s): \c
            number ~d is the ~w, ~w.", [List,I,Most,Answer]).
lengths_said(ko, Most, [List,I,Answer], Text) :-
    memberchk(Most-Word, [shortest-"짧은",longest-"긴"]),
    format(string(Text),
           "면소의 실장(실제 길이)은 (~s)이다. 가장 ~s 것은 ~d번이고 ~w.",
           [List,Word,I,Answer]).

cone_said(en, Given, Text) :-
    format(string(Text),
           "The base has the radius ~s, and generators are ~s long: \c
            360° · ~s / ~s = ~w.", Given).
cone_said(ko, Given, Text) :-
    format(string(Text),
           "밑면의 반지름은 ~s, 면소의 길이는 ~s이다. 360° · ~s / ~s = ~w.",
           Given).

pieces_said(en, Given, Text) :-
    format(string(Text), "Its pieces together: ~s, so about ~w.", Given).
pieces_said(ko, Given, Text) :-
    format(string(Text), "조각을 모두 더하면 ~s, 약 ~w.", Given).

from_said(en, Axis, Given, Text) :-
    format(string(Text),
           "The point is at ~w = ~s, and the solids begin at ~s: the \c
            difference is ~w.", [Axis|Given]).
from_said(ko, Axis, Given, Text) :-
    format(string(Text),
           "점의 ~w는 ~s이고 입체는 ~s에서 시작한다. 차는 ~w.", [Axis|Given]).
