:- module(test_golden, []).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(tests('golden/goldens')).

bytes(File, Codes) :-
    read_file_to_codes(File, Codes, [type(binary)]).

% The first line that differs, for the report.
differs(A, B, Line-(Was,Is)) :-
    split_string(A, "\n", "", As),
    split_string(B, "\n", "", Bs),
    nth1(Line, As, Was),
    nth1(Line, Bs, Is),
    Was \== Is,
    !.
differs(_, _, length).

same_drawing(Golden, New) :-
    bytes(Golden, A),
    bytes(New, B),
    (   A == B
    ->  true
    ;   string_codes(TextA, A),
        string_codes(TextB, B),
        differs(TextA, TextB, Where),
        format(user_error, "~w: ~p~n  `make bless`, if it should~n",
               [Golden, Where]),
        fail
    ).

:- begin_tests(golden).

test(drawing, [ forall(golden(Name, _)),
                setup(tmp_file_stream(New, Out, [extension(svg)])),
                cleanup(delete_file(New))
              ]) :-
    close(Out),
    golden_drawn(Name, New),
    golden_file(Name, Golden),
    exists_file(Golden),
    same_drawing(Golden, New).
test(none_left_over, Files == []) :-
    findall(File, left_over(File), Files).

:- end_tests(golden).
