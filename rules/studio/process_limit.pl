:- module(sg_process_limit,
          [ limits_forgotten/0,
            few_collections/0,
            memory_limited/1,           % +Head
            cpu_wanted/1,               % +Head
            cpu_limited/0
          ]).
:- use_module(request, [request_error/1]).
:- use_module(library(rlimit), [rlimit/3]).
/** <module> What a session may use, as its `hello` says. */

% cpu_each(Seconds): of the processor, that a request may take.
:- dynamic cpu_each/1.

%!  limits_forgotten is det.
%
%   Requests take as long as they take.

limits_forgotten :-
    retractall(cpu_each(_)).

%!  few_collections is det.
%
%   Most requests are over before they have left so many octets on a stack; what
%   is left then costs nothing to give back.

few_collections :-
    set_prolog_stack(global, low(2 000 000)),
    set_prolog_stack(trail, low(500 000)).

%!  memory_limited(+Head:dict) is det.
%
%   From now on the process has so much memory, if Head says so.
%
%   @error request_error(bad_key(memory_mb, least(100)))

memory_limited(Head) :-
    (   get_dict(memory_mb, Head, Megabytes)
    ->  (   integer(Megabytes),
            Megabytes >= 100
        ->  Octets is Megabytes*1 000 000,
            rlimit(data, _, Octets)
        ;   request_error(bad_key(memory_mb, least(100)))
        )
    ;   true
    ).

%!  cpu_wanted(+Head:dict) is det.
%
%   Each request from now on has so many seconds, if Head says so.
%
%   @error request_error(bad_key(cpu_s, positive))

cpu_wanted(Head) :-
    (   get_dict(cpu_s, Head, Seconds)
    ->  (   integer(Seconds),
            Seconds >= 1
        ->  retractall(cpu_each(_)),
            assertz(cpu_each(Seconds))
        ;   request_error(bad_key(cpu_s, positive))
        )
    ;   true
    ).

%!  cpu_limited is det.
%
%   The system ends the process when the request that begins takes more.

cpu_limited :-
    (   cpu_each(Seconds)
    ->  statistics(process_cputime, Used),
        Most is ceiling(Used)+Seconds,
        rlimit(cpu, _, Most)
    ;   true
    ).
