/* The book of a class: what its lines say of each pupil, and what is no line.
*/
:- module(test_visitor_answer, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(studio/visitor_answer)).

%   with_book(Lines, Goal, Left): with a class whose book has Lines; Left are
%   those that it has then.

:- meta_predicate with_book(+, 0, -).

with_book(Lines, Goal, Left) :-
    tmp_file(state, State),
    ( getenv('XDG_STATE_HOME', Before) -> true ; Before = none ),
    setup_call_cleanup(
        ( make_directory(State), setenv('XDG_STATE_HOME', State) ),
        ( class_begun('/problems.pl', none),
          directory_member(State, Book,
                           [extensions([answers]),recursive(true)]),
          setup_call_cleanup(open(Book, write, Out, [encoding(utf8)]),
                             maplist(write(Out), Lines),
                             close(Out)),
          quietly(class_begun('/problems.pl', none)),
          read_file_to_string(Book, Text, [encoding(utf8)]),
          split_string(Text, "\n", "", Left),
          call(Goal) ),
        ( class_begun(none, none),
          ( Before == none -> unsetenv('XDG_STATE_HOME')
          ; setenv('XDG_STATE_HOME', Before) ),
          delete_directory_and_contents(State) )),
    !.

:- dynamic quiet/0.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(studio(book_damaged(_, _, _))), warning, _) :-
    test_visitor_answer:quiet.

:- meta_predicate quietly(0).

quietly(Goal) :-
    setup_call_cleanup(asserta(quiet, Ref), Goal, erase(Ref)).

pupils(Pupils) :-
    class_request(owner, "class", _{}, Reply),
    get_dict(pupils, Reply, Dicts),
    maplist(pupil, Dicts, Pupils).

pupil(Dict, Name-Dones) :-
    get_dict(name, Dict, Name),
    get_dict(done, Dict, Dones0),
    maplist(done, Dones0, Dones).

done(Dict, done(Number,Tries,Answers,Right,Shown)) :-
    _{number:Number, tries:Tries, answers:Answers, right:Right,
      shown:Shown} :< Dict.

kim("{\"pupil\":\"d1\", \"name\":\"Kim\", \"turn\":1}\n").
lee("{\"pupil\":\"d2\", \"name\":\" Lee  B \", \"turn\":0}\n").

%   answer(Digest, Answer, Right, Shown, Line)

answer(Digest, Answer, Right, Shown, Line) :-
    format(string(Line),
           "{\"pupil\":\"~w\", \"problem\":\"p\", \"number\":3, \c
            \"answers\":[\"~w\"], \"right\":[~w], \"shown\":~w}~n",
           [Digest,Answer,Right,Shown]).

%   damaged(Line): a part of one is missing or of another kind.

damaged(Line) :-
    kim(Whole),
    member(Part-Other, [ "\"d1\""-"1", "\"Kim\""-"7", "\"Kim\""-"\"  \"",
                         "\"Kim\""-"\"K\\u0007m\"", "\"turn\":1"-"\"turn\":1.5",
                         ", \"turn\":1"-"", "{"-"", "\n"-"" ]),
    exchanged(Whole, Part, Other, Line).
damaged(Line) :-
    kim(Whole),
    format(string(Long), "~`kt~61|", []),
    exchanged(Whole, "Kim", Long, Line).
damaged(Line) :-
    answer(d1, 5, true, false, Whole),
    member(Part-Other, [ "\"p\""-"[1]", "\"p\""-"{}", "3"-"3.5",
                         "[\"5\"]"-"\"5\"", "[true]"-"true", "[true]"-"[1]",
                         "false"-"0", ", \"right\":[true]"-"" ]),
    exchanged(Whole, Part, Other, Line).

exchanged(Whole, Part, Other, Line) :-
    atomic_list_concat([Before,After], Part, Whole),
    atomic_list_concat([Before,Other,After], Line).

:- begin_tests(visitor_answer).

test(in_their_turn, [true(Pupils-Left == ["Lee B"-[],"Kim"-[]]-Lines)]) :-
    kim(Kim),
    lee(Lee),
    with_book([Kim,Lee], pupils(Pupils), Left),
    string_concat(Kim, Lee, Text),
    split_string(Text, "\n", "", Lines).
test(called_anew, [true(Pupils == ["Lee B"-[],"Kim B"-[]])]) :-
    kim(Kim),
    lee(Lee),
    with_book([ Kim, Lee,
                "{\"pupil\":\"d1\", \"name\":\"Kim B\", \"turn\":9}\n" ],
              pupils(Pupils), _).
test(tries, [ forall(member(Answers-Done,
                      [ [5-false-false]-done(3,1,["5"],[false],false),
                        [5-false-false,6-true-false]-
                        done(3,2,["6"],[true],false),
                        [6-true-false,7-false-true]-
                        done(3,1,["6"],[true],false),
                        [5-false-true,6-true-false]-
                        done(3,2,["6"],[true],true) ])),
              true(Pupils == ["Kim"-[Done]]) ]) :-
    kim(Kim),
    findall(Line, ( member(Answer-Right-Shown, Answers),
                    answer(d1, Answer, Right, Shown, Line) ), Lines),
    with_book([Kim|Lines], pupils(Pupils), _).
test(damaged, [ forall(damaged(Damaged)),
                true(Pupils-Left == ["Lee B"-[]]-Lines) ]) :-
    lee(Lee),
    split_string(Lee, "\n", "", Lines),
    with_book([Lee,Damaged], pupils(Pupils), Left).
test(owner_alone, [ throws(error(request_error(owner_alone(class)), _)) ]) :-
    with_book([], class_request(pupil, "class", _{}, _), _).
test(no_class, [ forall(member(Do, ["class","join"])),
                 throws(error(request_error(no_class), _)) ]) :-
    class_begun(none, none),
    class_request(owner, Do, _{name:"Kim"}, _).
test(joins, [true(Pupils-Name-Turn ==
                  ["Lee B"-[],"Park"-[]]-"Park"-1)]) :-
    lee(Lee),
    with_book([Lee],
              ( class_request(who, "join", _{name:" Park"}, Reply),
                get_dict(name, Reply, Name),
                class_pupil(who, Pupil),
                get_dict(turn, Pupil, Turn),
                pupils(Pupils) ),
              _).
test(no_name, [ forall(member(Head, [_{}, _{name:""}, _{name:7}])),
                throws(error(request_error(bad_key(name,pupil)), _)) ]) :-
    with_book([], class_request(who, "join", Head, _), _).

:- end_tests(visitor_answer).
