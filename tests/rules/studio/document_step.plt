:- encoding(utf8).
:- module(test_document_step, []).
:- use_module(library(apply)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(studio/document_content)).
:- use_module(rules(studio/document_step)).
:- use_module(rules(studio/text_edit)).

/* What a journal keeps of many steps is where they led, with all that can be
   taken back and done again.
*/

% walked(N, State0, State, Steps): N changes at random, as a journal has them.

walked(0, State, State, []) :-
    !.
walked(N, State0, State, Steps) :-
    random_between(0, 9, Kind),
    (   wanted(Kind, State0, Step),
        catch(stepped(Step, State0, State1), error(request_error(_), _),
              fail)
    ->  State1 = state(Key, _, _),
        kept_step(Step, Key, Kept),
        Steps = [Kept|Steps1]
    ;   State1 = State0,
        Steps = Steps1
    ),
    N1 is N-1,
    walked(N1, State1, State, Steps1).

wanted(0, _, _{do:"undo"}) :-
    !.
wanted(1, _, _{do:"undo"}) :-
    !.
wanted(2, _, _{do:"redo"}) :-
    !.
wanted(3, _, _{do:"rules", rules:Rules}) :-
    !,
    random_member(Rules, ["", "may_cut(1, 2).", "상관(1)."]).
wanted(4, _, _{do:"text", text:Text}) :-
    !,
    random_member(Text, ["", "a(1).", "a(1).\nb(2).\n", "상(1). 관(2)."]).
wanted(_, state(Now, _, _), _{do:"edit", from:From, to:To, with:With}) :-
    content(Now, Text, _),
    string_length(Text, Length),
    random_between(0, Length, From),
    random_between(From, Length, To),
    random_member(With, [7, -2.5, "", "상관", "f(x). "]).

begun(state(Key, [], [])) :-
    content_key("box(size(1, 2, 3)).\n", "", Key).

% written(Step, Read): as it comes back from the journal.
written(Step, Read) :-
    with_output_to(string(Line), json_write_dict(current_output, Step,
                                                 [width(0)])),
    open_string(Line, In),
    json_read_dict(In, Read),
    close(In).

:- begin_tests(document_step, [setup(set_random(seed(21)))]).

test(checkpoint, [forall(between(1, 60, I))]) :-
    begun(Begin),
    N is I*I//4,
    walked(N, Begin, State, Steps),
    steps_changes(Steps, Changes),
    length(Steps, Changes),
    checkpoint(State, Changes, Step0),
    written(Step0, Step),
    steps_changes([Step, _{do:"undo"}], More),
    More =:= Changes+1,
    stepped(Step, Begin, State).

test(more_than_is_kept, true(State == Again)) :-
    begun(Begin),
    length(Steps, 1500),
    foldl([_{do:"edit", from:9, to:10, with:W}, N0, N]>>
              ( N is N0+1, W is N0 mod 10 ), Steps, 0, _),
    replayed(Steps, Begin, State, Steps),
    State = state(_, Past, []),
    length(Past, 1000),
    checkpoint(State, 1500, Step),
    stepped(Step, Begin, Again).

test(its_rules, true(All == ["", "a.", "b."])) :-
    begun(Begin),
    foldl([R, S0, S]>>stepped(_{do:"rules", rules:R}, S0, S), ["a.", "b."],
          Begin, State),
    checkpoint(State, 2, Step),
    findall(R, step_rules(Step, R), All).

test(text_change, [forall(member(Text-New-Change,
                       [ ""-""-change(0,0,""), "a"-"a"-change(1,1,""),
                         ""-"상"-change(0,0,"상"), "관"-""-change(0,1,""),
                         "aaa"-"aa"-change(2,3,""), "aa"-"aaa"-change(2,2,"a"),
                         "r(12)."-"r(13)."-change(3,4,"3"),
                         "x상y"-"x관y"-change(1,2,"관") ])),
                   true(change(From, To, With) == Change)]) :-
    text_change(Text, New, From, To, With).

:- end_tests(document_step).
