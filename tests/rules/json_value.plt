/* Values of JSON that come from elsewhere. */
:- module(test_json_value, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(json_value)).

:- begin_tests(json_value).

test(value, Codes == [0x1f600,0'x,0x1f600]) :-
    json_value("{\"a\": \"\\ud83d\\ude00x\U0001F600\"} ", Dict),
    get_dict(a, Dict, Text),
    string_codes(Text, Codes).
test(key, Pairs == ['\U0001F600'-[1,null]]) :-
    json_value("{\"\\ud83d\\ude00\": [1, null]}", Dict),
    dict_pairs(Dict, _, Pairs).
test(backslash, Length == 12) :-
    json_value("[\"\\\\ud83d\\\\ude00\"]", [Text]),
    string_length(Text, Length).
test(none, [ forall(member(Text, [ "", "1 2", "[", "{\"a\":1}}",
                                   "[\"\\ud83d\"]", "{\"\\udc00\":1}",
                                   "[\"\\ude00\\ud83d\"]" ])),
             fail ]) :-
    json_value(Text, _).

:- end_tests(json_value).
