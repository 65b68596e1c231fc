:- module(sg_json_value,
          [ json_value/2                % +Text, -Value
          ]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(http/json), [json_read_dict/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> A value of JSON that comes from elsewhere.
*/

%!  json_value(+Text, -Value) is semidet.
%
%   Text holds one value of JSON, and Value is it: dicts, lists, strings,
%   numbers, `true`, `false` and `null`. What JSON writes as two escapes,
%   `\ud83d\ude00`, is one character, which library(http/json) leaves in
%   halves; half of one alone is no text, so Text is no JSON.

json_value(Text, Value) :-
    catch(setup_call_cleanup(
              open_string(Text, In),
              ( json_read_dict(In, Value0),
                read_string(In, _, Rest)
              ),
              close(In)),
          error(_, _), fail),
    split_string(Rest, "", " \t\r\n", [""]),
    whole_texts(Value0, Value).

whole_texts(Value0, Value) :-
    (   string(Value0)
    ->  string_codes(Value0, Codes),
        whole_text(Codes, Value0, string_codes, Value)
    ;   Value0 = [_|_]
    ->  maplist(whole_texts, Value0, Value)
    ;   is_dict(Value0)
    ->  dict_pairs(Value0, Tag, Pairs0),
        pairs_keys_values(Pairs0, Keys0, Values0),
        maplist(whole_key, Keys0, Keys),
        maplist(whole_texts, Values0, Values),
        pairs_keys_values(Pairs, Keys, Values),
        dict_pairs(Value, Tag, Pairs)
    ;   Value = Value0
    ).

whole_key(Key0, Key) :-
    (   atom(Key0)
    ->  atom_codes(Key0, Codes),
        whole_text(Codes, Key0, atom_codes, Key)
    ;   Key = Key0
    ).

:- meta_predicate whole_text(+, +, 2, -).

%   whole_text(Codes, Text0, Made, Text): call(Made, Text, Whole), if that is
%   anything else than Codes, those of Text0.

whole_text(Codes, Text0, Made, Text) :-
    (   \+ ( member(Code, Codes), half(_, Code) )
    ->  Text = Text0
    ;   whole_codes(Codes, Whole),
        call(Made, Text, Whole)
    ).

whole_codes([], []).
whole_codes([Code0|Codes0], [Code|Codes]) :-
    (   \+ half(_, Code0)
    ->  Code = Code0,
        whole_codes(Codes0, Codes)
    ;   Codes0 = [Code1|Codes1],
        half(first, Code0),
        half(second, Code1),
        Code is 0x10000 + ((Code0-0xd800)<<10) + (Code1-0xdc00),
        whole_codes(Codes1, Codes)
    ).

half(first, Code) :-
    Code >= 0xd800,
    Code =< 0xdbff.
half(second, Code) :-
    Code >= 0xdc00,
    Code =< 0xdfff.
