:- encoding(utf8).
:- module(test_fold_file, []).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(pattern/fold_file)).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

/* Texts in a FOLD file: whatever a title has in it, another reader of JSON has
   the same, and what can be read in the file is not spelled. */

%   spoken(Code): it can stand in a title.

spoken(Code) :-
    (   between(0, 0x2ff, Code)
    ;   member(Code, [0x20ac,0x2028,0x2029,0xac00,0xd55c,0xfeff,0xffff,
                      0x10000,0x1f600,0x10ffff])
    ).

titled(Title, Text) :-
    tmp_file(titled, Base),
    atom_concat(Base, '.fold', File),
    setup_call_cleanup(
        in_new_world(write_fold(File, [], [title(Title)])),
        read_file_to_string(File, Text, [encoding(utf8)]),
        delete_file(File)).

read_title(Text, Title) :-
    setup_call_cleanup(open_string(Text, In),
                       json_read_dict(In, Dict),
                       close(In)),
    string(Dict.file_title),
    string_codes(Dict.file_title, Title).

%   raw_control(Text): it has one that is not at the end of a line; the reader
%   here lets them pass.

raw_control(Text) :-
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    string_codes(Line, Codes),
    member(Code, Codes),
    Code < 32.

:- begin_tests(fold_file).

test(title, Read == Codes) :-
    findall(Code, spoken(Code), Codes),
    string_codes(Title, Codes),
    titled(Title, Text),
    \+ raw_control(Text),
    read_title(Text, Read).
test(not_spelled, true(sub_string(Text, _, _, _, "\"박공 roof~ /2\""))) :-
    titled("박공 roof~ /2", Text).
test(no_title, true(\+ sub_string(Text, _, _, _, "file_title"))) :-
    titled("", Text).
test(units, [forall(member(Unit-Name, [mm-"mm",cm-"cm",m-"m",inch-"in",
                                       none-"unit"])),
             Found == Name]) :-
    tmp_file(unit, Base),
    atom_concat(Base, '.fold', File),
    setup_call_cleanup(
        in_new_world(write_fold(File, [], [unit(Unit)])),
        setup_call_cleanup(open(File, read, In, [encoding(utf8)]),
                           json_read_dict(In, Dict),
                           close(In)),
        delete_file(File)),
    Found = Dict.frame_unit.

:- end_tests(fold_file).
