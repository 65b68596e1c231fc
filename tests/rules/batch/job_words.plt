/* What the options of a job are on a command line, from a manifest of facts and
   from lines of JSON. */
:- module(test_job_words, []).
:- use_module(library(plunit)).
:- use_module(rules(batch/job_words)).
:- use_module(rules(limits)).

option(true_length, 'true-length'-true).
option(time_limit(2.5), time_limit-'2.5').
option(view(30, 60), view-'30,60').
option(view(top), view-top).
option(output(['%.svg',"%.pdf"]), output-'%.svg,%.pdf').
option(page_size(a=4), 'page-size'-'a=4').
option(set(r, 3), set-'r=3').
option(set(r, [1,2]), set-'r=1,2').
option(shade(f(x)), shade-'f(x)').
option(given([]), given-'').

no_option(7).
no_option("text").
no_option([]).
no_option(_{a:1}).

json(view, "30,60", [view-'30,60']).
json(scale, 0.5, [scale-'0.5']).
json(frame, true, [frame-true]).
json(frame, false, ['no-frame'-true]).
json(output, ["a.svg",7], [output-'a.svg',output-'7']).
json(set, _{r:3}, [set-'r=3']).

no_json(view, null).
no_json(view, [[]]).
no_json(view, _{a:1}).
no_json(set, _{a:[1]}).

%   fault(Limit): it is none.

fault(time_limit-0).
fault(time_limit-x).
fault(cpu-(-1)).
fault(memory-49.9).

written(output-'a.svg', '', 'a.svg').
written((table)-'a.csv', '', 'a.csv').
written(spans-a, '', a).
written(buffer-'depth=a=b.bin', 'depth=', 'a=b.bin').
written('scan-line'-'7=a', '7=', a).

:- begin_tests(job_words).

test(option, [forall(option(Term, Pair)), true(Pairs == [Pair])]) :-
    option_pairs([Term], Pairs).
test(no_option, [forall(no_option(Term)), throws(job_error(option(Term)))]) :-
    option_pairs([view(1),Term], _).
test(no_options, [throws(job_error(options(view)))]) :-
    option_pairs(view, _).
test(long, [ forall(member(How, [term,set,json])),
             true(Error == job_error(limit(name, Most))) ]) :-
    limit_value(name, Most),
    More is Most+1,
    length(Codes, More),
    maplist(=(0'a), Codes),
    string_codes(Long, Codes),
    sub_string(Long, 1, _, 0, Fits0),
    string_length(Fits0, Most),
    (   How == json
    ->  json_pairs(_{title:Fits0}, [title-_]),
        catch(json_pairs(_{title:Long}, _), Error, true)
    ;   How == term
    ->  option_pairs([title(Fits0)], [title-_]),
        catch(option_pairs([title(Long)], _), Error, true)
    ;   sub_string(Fits0, 2, _, 0, Fits),
        option_pairs([set(r, Fits)], [set-_]),
        catch(option_pairs([set(r, Fits0)], _), Error, true)
    ).
test(json, [forall(json(Name, Value, Wanted)), true(Pairs == Wanted)]) :-
    dict_pairs(Dict, _, [Name-Value]),
    json_pairs(Dict, Pairs).
test(no_json, [ forall(no_json(Name, Value)),
                throws(job_error(option(_))) ]) :-
    dict_pairs(Dict, _, [Name-Value]),
    json_pairs(Dict, _).
test(no_object, [throws(job_error(options([])))]) :-
    json_pairs([], _).
test(parted, [true(Limits-Options == [time_limit-2.5,memory-x]-[view-top])]) :-
    parted_pairs([time_limit-'2.5',view-top,memory-x], Limits, Options).
test(limit, [ forall(member(Limit, [time_limit-0.001,memory-50,cpu-1])),
              fail ]) :-
    limit_fault(Limit, _).
test(no_limit, [forall(fault(Name-Value)), true(Fault == limit(Term))]) :-
    limit_fault(Name-Value, Fault),
    Term =.. [Name,Value].
test(own_first, [true(Options == [hidden-x,'no-frame'-true,output-b,output-a,
                                  view-top])]) :-
    Specs = [ option(view, a, value, b, c), option(frame, a, flag, b, c),
              option(output, a, value, b, c), option(hidden, a, value, b, c) ],
    options_over([view-top,output-b,output-a],
                 [ hidden-x, view-left, 'no-frame'-true, 'no-hidden'-true,
                   'true-length'-true ],
                 Specs, Options).
test(any, [true(Options == ['true-length'-true,view-top])]) :-
    options_over([view-top], ['true-length'-true], any, Options).
test(written, [ forall(written(Option, Before0, File0)),
                true(Before-File == Before0-File0) ]) :-
    output_file(Option, Before, File).
test(not_written, [ forall(member(Option, [view-top,buffer-a,rules-r])),
                    fail ]) :-
    output_file(Option, _, _).
test(words, [true(Words == ['--frame','--output=d/a.svg',
                            '--buffer=depth=d/x','--view=top'])]) :-
    option_words([frame-true,output-'a.svg',buffer-'depth=x',view-top], d,
                 Words).
test(read, [true(Names == [rules,style,'title-block',look,by])]) :-
    findall(Name, input_option(split, Name), Names).

:- end_tests(job_words).
