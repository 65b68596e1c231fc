:- module(sg_job_words,
          [ option_pairs/2,             % +Terms, -Pairs
            json_pairs/2,               % +Dict, -Pairs
            parted_pairs/3,             % +Pairs, -Limits, -Options
            limit_fault/2,              % +Pair, -Fault
            options_over/4,             % +Own, +Defaults, +Specs, -Options
            option_words/3,             % +Options, +Folder, -Words
            output_file/3,              % +Option, -Before, -File
            input_option/2,             % ?Verb, ?Name
            text_of/2                   % +Value, -Text
          ]).
:- use_module('../limits', [limit_value/2]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/3, partition/4]).
:- use_module(library(lists), [append/3, member/2, reverse/2]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> The options of a job: terms of a manifest, words of a command line.

An option is Name-Value: Name that of the long option, Value an atom, the text
behind `=`, or `true` of a flag. Terms are

    name                 --name
    name(Value)          --name=Value
    name(A, B)           --name=A,B
    name(Key=Value)      --name=Key=Value
    set(Name, Value)     --set=Name=Value

with `_` in a name for the `-` of the option. Beside those of the verb there are
limits: time_limit(Seconds), memory(Megabytes), cpu(Seconds).
*/

%!  option_pairs(+Terms, -Pairs) is det.
%
%   @error job_error(option(Term)): a term is no option;
%   job_error(limit(name, Most)): a value is too long

option_pairs(Terms, Pairs) :-
    (   is_list(Terms)
    ->  maplist(option_pair, Terms, Pairs)
    ;   throw(job_error(options(Terms)))
    ).

option_pair(Term, Name-Value) :-
    (   atom(Term),
        Term \== []
    ->  dashed(Term, Name),
        Value = true
    ;   compound(Term),
        compound_name_arguments(Term, Name0, Arguments),
        atom(Name0),
        option_value(Name0, Arguments, Value)
    ->  dashed(Name0, Name)
    ;   throw(job_error(option(Term)))
    ).

option_value(set, [Name, Value0], Value) :-
    !,
    short(Name=Value0, 0),
    text_of(Name, Left),
    text_of(Value0, Right),
    atomic_list_concat([Left, =, Right], Value).
option_value(_, [Argument|Arguments], Value) :-
    short([Argument|Arguments], 2),
    (   Arguments == []
    ->  text_of(Argument, Value)
    ;   maplist(text_of, [Argument|Arguments], Texts),
        atomic_list_concat(Texts, ',', Value)
    ).

%   short(Value, Brackets): its text, without that many brackets, has no more
%   characters than a text in a file may.

short(Value, Brackets) :-
    limit_value(name, Most),
    Longest is Most+Brackets,
    (   write_length(Value, _, [max_length(Longest)])
    ->  true
    ;   throw(job_error(limit(name, Most)))
    ).

dashed(Name0, Name) :-
    (   sub_atom(Name0, _, _, _, '_'),
        \+ limit_name(Name0)
    ->  atomic_list_concat(Parts, '_', Name0),
        atomic_list_concat(Parts, -, Name)
    ;   Name = Name0
    ).

%!  text_of(+Value, -Text:atom) is det.
%
%   Text is what Value, a name, a number, a text, a list or a term, is on a
%   command line.

text_of(Value, Text) :-
    (   atom(Value),
        Value \== []
    ->  Text = Value
    ;   number(Value)
    ->  atomic_list_concat([Value], Text)
    ;   is_list(Value)
    ->  maplist(text_of, Value, Texts),
        atomic_list_concat(Texts, ',', Text)
    ;   compound(Value),
        Value = (Key=Of)
    ->  maplist(text_of, [Key,Of], Texts),
        atomic_list_concat(Texts, =, Text)
    ;   format(atom(Text), '~w', [Value])
    ).

%!  json_pairs(+Dict, -Pairs) is det.
%
%   The same of the object of a line of JSON: {"view":"30,60", "no-frame":true,
%   "output":["%.svg","%.pdf"], "set":{"r":3}}.
%
%   @error job_error(option(Term)): a value is no text, number, true, false,
%   list or, of `set`, object of these

json_pairs(Dict, Pairs) :-
    (   is_dict(Dict)
    ->  dict_pairs(Dict, _, Pairs0),
        foldl(json_option, Pairs0, [], Lists),
        reverse(Lists, Pairs)
    ;   throw(job_error(options(Dict)))
    ).

json_option(Name-Value, Pairs0, Pairs) :-
    (   is_list(Value)
    ->  foldl(json_value(Name), Value, Pairs0, Pairs)
    ;   is_dict(Value),
        Name == set
    ->  dict_pairs(Value, _, Sets),
        foldl(json_set, Sets, Pairs0, Pairs)
    ;   json_value(Name, Value, Pairs0, Pairs)
    ).

json_set(Name-Value, Pairs0, [set-Text|Pairs0]) :-
    json_text(set, Value, Right),
    atomic_list_concat([Name, =, Right], Text).

json_value(Name, true, Pairs, [Name-true|Pairs]) :-
    !.
json_value(Name, false, Pairs, [No-true|Pairs]) :-
    !,
    atom_concat('no-', Name, No).
json_value(Name, Value, Pairs, [Name-Text|Pairs]) :-
    json_text(Name, Value, Text).

json_text(Name, Value, Text) :-
    (   ( string(Value) ; number(Value) ),
        !,
        short(Value, 0),
        format(atom(Text), '~w', [Value])
    ;   Term =.. [Name, Value],
        throw(job_error(option(Term)))
    ).


                /*******************************
                *            LIMITS            *
                *******************************/

limit_name(time_limit).
limit_name(memory).
limit_name(cpu).

%!  parted_pairs(+Pairs, -Limits, -Options) is det.
%
%   Limits are those of Pairs that no verb knows, with numbers.

parted_pairs(Pairs, Limits, Options) :-
    partition(limit_pair, Pairs, Limits0, Options),
    maplist(limit_number, Limits0, Limits).

limit_pair(Name-_) :-
    limit_name(Name).

limit_number(Name-Text, Name-Number) :-
    (   atom(Text),
        atom_number(Text, Number0)
    ->  Number = Number0
    ;   Number = Text
    ).

%!  limit_fault(+Limit, -Fault) is semidet.
%
%   Fault is limit(Term): Limit has no number above zero; of memory, from 50 on.

limit_fault(Name-Value, limit(Term)) :-
    \+ ( number(Value),
         ( Name == memory -> Value >= 50 ; Value > 0 ) ),
    Term =.. [Name, Value].

%!  options_over(+Own, +Defaults, +Specs, -Options) is det.
%
%   Options are those of a job, in order of their names: its Own, and of the
%   Defaults those that its verb, with options Specs, has, and it does not.

options_over(Own, Defaults, Specs, Options) :-
    exclude(overridden(Own), Defaults, More0),
    (   Specs == any
    ->  More = More0
    ;   exclude(foreign_option(Specs), More0, More)
    ),
    append(More, Own, Options0),
    keysort(Options0, Options).

overridden(Own, Name-_) :-
    memberchk(Name-_, Own).

foreign_option(Specs, Name-_) :-
    \+ option_known(Specs, Name).

option_known(Specs, Name) :-
    memberchk(option(Name, _, _, _, _), Specs),
    !.
option_known(Specs, No) :-
    atom_concat('no-', Name, No),
    memberchk(option(Name, _, flag, _, _), Specs).

%!  output_file(+Option, -Before, -File) is semidet.
%
%   The verb writes File; the value of Option is File with Before in front, as
%   in depth=FILE.

output_file(Name-Value, Before, File) :-
    output_form(Name, Form),
    (   Form == file
    ->  Before = '',
        File = Value
    ;   sub_atom(Value, B, 1, _, =)
    ->  Length is B+1,
        sub_atom(Value, 0, Length, After, Before),
        sub_atom(Value, _, After, 0, File)
    ).

output_form(output, file).
output_form(table, file).
output_form(spans, file).
output_form(buffer, key_file).
output_form('scan-line', key_file).

%!  input_option(?Verb, ?Name) is nondet.
%
%   The value of the option Name of Verb is a file that it reads.

input_option(_, rules).
input_option(_, style).
input_option(_, 'title-block').
input_option(_, look).
input_option(split, by).

%!  option_words(+Options, +Folder, -Words) is det.
%
%   Words are those of the command line; files that are written go to Folder,
%   with their names as they stand in the manifest.

option_words(Options, Folder, Words) :-
    maplist(option_word(Folder), Options, Words).

option_word(Folder, Name-Value, Word) :-
    (   Value == true
    ->  atom_concat(--, Name, Word)
    ;   output_file(Name-Value, Before, File)
    ->  atomic_list_concat([--, Name, =, Before, Folder, /, File], Word)
    ;   atomic_list_concat([--, Name, =, Value], Word)
    ).
