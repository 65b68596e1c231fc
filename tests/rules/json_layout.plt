:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(json_layout)).

/* JSON in lines: the same octets with every SWI-Prolog. */

laid(Value, Width, Text) :-
    with_output_to(string(Text), json_laid_out(current_output, Value, Width)).

%   key(File): keys of problems as they were written.

key(File) :-
    module_property(sg_json_layout, file(Rules)),
    file_directory_name(Rules, Folder),
    atom_concat(Folder, '/../docs/gallery/problems/*-key.json', Pattern),
    expand_file_name(Pattern, Files),
    member(File, Files).

:- begin_tests(json_layout).

test(in_line, Text == "{\"a\":1, \"b\": [1, \"x\\\"\",  [] ], \"c\":null}") :-
    laid(_{a:1, b:[1,"x\"",[]], c:null}, 78, Text).
test(in_lines,
     Text == "{\n  \"a\":1,\n  \"b\": [\n    {\"c\":2.5, \"d\":3},\n    \c
              true\n  ]\n}") :-
    laid(_{a:1, b:[_{c:2.5, d:3},true]}, 24, Text).
test(tabs,
     Text == "{\n  \"a\": {\n    \"b\": {\n      \"c\": {\n\t\"d\":\"long\"\n\c
              \x20\     }\n    }\n  }\n}") :-
    laid(_{a:_{b:_{c:_{d:"long"}}}}, 15, Text).
test(one_line, Text == "{\"a\": [1, 2, 3 ]}") :-
    laid(_{a:[1,2,3]}, inf, Text).
test(alone, Text == "\"\u4e2d\"") :-
    laid('\u4e2d', 78, Text).
test(empty, [A,B] == ["{}","[]"]) :-
    laid(_{}, 1, A0),
    laid([], 78, B),
    laid(_{}, 78, A),
    A0 == "{\n}".
%   What is as long as Width, without what stands apart before brackets, is on
%   one line; a name of a pair and what it needs count.
test(widths, [ forall(member(Value-Width, [ [1,22,333]-12, [[],[7]]-9,
                                             _{a:1}-8, _{ab:"c",d:true}-22,
                                             [null,"x"]-11, _{a:_{b:2}}-15 ])),
               true(Lines == [one,more]) ]) :-
    Less is Width-1,
    findall(How,
            ( member(W, [Width,Less]),
              laid(Value, W, Text),
              ( sub_string(Text, _, _, _, "\n") -> How = more ; How = one ) ),
            Lines).
test(keys, [ forall(key(File)), true(Text == Was) ]) :-
    setup_call_cleanup(open(File, read, In, [encoding(utf8)]),
                       json_read_dict(In, Key),
                       close(In)),
    read_file_to_string(File, Was0, [encoding(utf8)]),
    string_concat(Was, "\n", Was0),
    laid(Key, 78, Text).

:- end_tests(json_layout).
