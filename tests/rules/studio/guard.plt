:- module(test_guard, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(studio/guard), [new_secret/1, same_secret/2]).

% covers: guard

:- begin_tests(guard).

secrets(Secrets) :-
    findall(Secret, ( between(1, 64, _), new_secret(Secret) ), Secrets).

test(secret, Lengths == [32]) :-
    secrets(Secrets),
    findall(Length, ( member(Secret, Secrets), string_length(Secret, Length) ),
            Lengths0),
    sort(Lengths0, Lengths).

test(digits, Others == []) :-
    secrets(Secrets),
    findall(C, ( member(Secret, Secrets), string_chars(Secret, Cs),
                 member(C, Cs), \+ char_type(C, xdigit(_)) ), Others).

test(differ) :-
    secrets(Secrets),
    sort(Secrets, Unique),
    length(Unique, 64).

test(same) :-
    new_secret(Secret),
    same_secret(Secret, Secret).

test(prefix, fail) :-
    new_secret(Secret),
    sub_string(Secret, 0, 31, _, Part),
    same_secret(Part, Secret).

test(last, fail) :-
    same_secret("00000000000000000000000000000001",
                "00000000000000000000000000000000").

test(atom, fail) :-
    new_secret(Secret),
    atom_string(Atom, Secret),
    same_secret(Atom, Secret).

test(not_same, fail) :-
    new_secret(One),
    new_secret(Other),
    same_secret(One, Other).

:- end_tests(guard).
