/* What a session may not say of its limits. */
:- module(test_process_limit, []).
:- use_module(library(plunit)).
:- use_module(rules(studio/process_limit)).
:- use_module(rules(studio/request)).
:- use_module(library(rlimit)).

:- begin_tests(process_limit).

test(memory, [ forall(member(Mb, [99,0,-5,100.5,"200",null])),
               error(request_error(bad_key(memory_mb, least(100))), _) ]) :-
    memory_limited(_{memory_mb:Mb}).
test(cpu, [ forall(member(S, [0,-1,1.5,"2",null])),
            error(request_error(bad_key(cpu_s, positive)), _) ]) :-
    cpu_wanted(_{cpu_s:S}).
test(nothing) :-
    limits_forgotten,
    memory_limited(_{}),
    cpu_wanted(_{}),
    rlimit(cpu, Before, Before),
    cpu_limited,
    rlimit(cpu, After, After),
    Before == After.
test(least) :-
    cpu_wanted(_{cpu_s:1}),
    limits_forgotten.
test(options, Options == [["-q"],[]]) :-
    request_options(_{options:["-q"]}, A),
    request_options(_{}, B),
    Options = [A,B].
test(bad_options, error(request_error(bad_key(options, options)), _)) :-
    request_options(_{options:"-q"}, _).
test(owner) :-
    of_owner(_{owner:true}, save).
test(not_owner, [ forall(member(Head, [_{},_{owner:false},_{owner:"true"}])),
                  error(request_error(owner_alone(save)), _) ]) :-
    of_owner(Head, save).

:- end_tests(process_limit).
