/* The name of a job, and the files that are named after it. */
:- module(test_job_name, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(yall)).
:- use_module(rules(batch/job_name)).

text(Name, Text) :-
    ( name_text(Name, Text0) -> Text = Text0 ; Text = none ).

stem(Text, Stem) :-
    ( file_stem(Text, Stem0) -> Stem = Stem0 ; Stem = none ).

letters(N, Text) :-
    letters(N, 0'a, Text).

letters(N, Code, Text) :-
    length(Codes, N),
    maplist(=(Code), Codes),
    atom_codes(Text, Codes).

:- begin_tests(job_name).

test(text, [ forall(member(Name-Text,
     [ plate-plate, hole(7)-'hole(7)', 3-'3', 2.5-'2.5', 'A b'-'\'A b\'',
       f(g(1),'X y')-'f(g(1),\'X y\')', ""-none, "x"-none, []-none, f()-none,
       _-none, f(_)-none, f([])-none, f([a])-none, 1r3-none ])),
             true(Found == Text) ]) :-
    text(Name, Found).
test(longest, Found == [yes,none]) :-
    findall(What, ( member(N, [1000,1001]), letters(N, Name),
                    text(Name, Text), ( Text == none -> What = none
                                      ; What = yes ) ), Found).
test(stem, [ forall(member(Text-Stem,
     [ 'hole(7)'-'hole-7', 'f(a,b)'-'f-a-b', 'a/b:c=d'-'a-b-c-d',
       '\'A b\''-'Ab', 'x.y_z-1'-'x.y_z-1', '.a'-'_.a', '-a'-'_-a',
       '(a)'-'_-a', 'a!?*%~'-a, '...'-none, '()'-none, '!'-none,
       '\uad00'-'\uad00', 'Z9'-'Z9', az09-az09 ])),
             true(Found == Stem) ]) :-
    stem(Text, Found).
%   As long as a name of a file may be with an ending, in octets.
test(longest_stem, Found == [yes,none,yes,none,yes,none]) :-
    findall(What,
            ( member(N-Code, [180-0'a,181-0'a,60-0xad00,61-0xad00,
                              90-0xe9,91-0xe9]),
              letters(N, Code, Text),
              stem(Text, Stem),
              ( Stem == none -> What = none ; Stem == Text, What = yes ) ),
            Found).
test(path, Paths == ['d/x.svg','d.svg',x,axb]) :-
    maplist([Pattern,Path]>>stem_path(Pattern, x, Path),
            ['d/%.svg','d.svg','%','a%b'], Paths).
test(output, [ forall(member(Pattern-Truth,
     [ '%.svg'-yes, 'd/%.svg'-yes, 'a%b.pdf'-yes, 'd/e/%'-yes,
       'x.svg'-no, '%/%.svg'-no, '%%.svg'-no, '%/x.svg'-no, '../%.svg'-no,
       './%.svg'-no, '/%.svg'-no, 'd//%.svg'-no, 'store/%.svg'-no,
       'd/store/%.svg'-yes, '.%.svg'-no, 'd/.%'-no, 'storex/%'-yes ])),
               true(Found == Truth) ]) :-
    (   output_fault(Pattern, Fault)
    ->  assertion(Fault == output(Pattern)),
        Found = no
    ;   Found = yes
    ).
%   Each name is in one shard, and the shards are of about one size.
test(shards, [ forall(member(N, [1,2,7])), true(Wrong == []) ]) :-
    numlist(1, N, Is),
    findall(Name-Count,
            ( between(1, 500, K),
              atom_concat(job, K, Name),
              aggregate_all(count, ( member(I, Is), in_shard(Name, I, N) ),
                            Count),
              Count =\= 1 ),
            Wrong),
    forall(member(I, Is),
           ( aggregate_all(count, ( between(1, 500, K), atom_concat(job, K, J),
                                    in_shard(J, I, N) ), Own),
             assertion(abs(Own*N/500-1) < 0.35) )).
%   By the first four octets of the SHA-256 of its text, 995541842.
test(shard_of_a_name, Is == [3,843]) :-
    findall(I, ( member(N, [5,1000]), between(1, N, I),
                 in_shard(plate, I, N) ), Is).

:- end_tests(job_name).
