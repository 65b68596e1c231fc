:- module(sg_visitor_path,
          [ paths_untold/5              % +Folders, +Head0, +Body0, -Head, -Body
          ]).
:- use_module(protocol, [text_octets/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
/** <module> What is told to visitors names no folder of this machine.
*/

%!  paths_untold(+Folders:list(atom), +Head0:dict, +Body0, -Head:dict,
%!               -Body) is det.
%
%   Head and Body are what a session replied, Head0 and Body0, where what begins
%   with one of Folders is called by what comes after it: in errors, messages,
%   the name of a file and an explanation.

paths_untold(Folders, Head0, Body0, Head, Body) :-
    foldl(key_untold(Folders), [error,messages,file], Head0, Head),
    (   get_dict(do, Head0, "explain")
    ->  maplist(text_octets, Folders, Octets),
        untold(Octets, Body0, Body)
    ;   Body = Body0
    ).

key_untold(Folders, Key, Head0, Head) :-
    (   get_dict(Key, Head0, Value0)
    ->  untold(Folders, Value0, Value),
        Head = Head0.put(Key, Value)
    ;   Head = Head0
    ).

untold(Folders, Dict0, Dict) :-
    is_dict(Dict0),
    !,
    dict_pairs(Dict0, Tag, Pairs0),
    maplist(value_untold(Folders), Pairs0, Pairs),
    dict_pairs(Dict, Tag, Pairs).
untold(Folders, List0, List) :-
    is_list(List0),
    !,
    maplist(untold(Folders), List0, List).
untold(Folders, Text0, Text) :-
    string(Text0),
    !,
    foldl(folder_untold, Folders, Text0, Text).
untold(_, Value, Value).

value_untold(Folders, Key-Value0, Key-Value) :-
    untold(Folders, Value0, Value).

folder_untold(Folder, Text0, Text) :-
    atom_concat(Folder, /, Prefix),
    (   Prefix == (//)
    ->  Text = Text0
    ;   atomic_list_concat(Parts, Prefix, Text0),
        atomics_to_string(Parts, Text)
    ).
