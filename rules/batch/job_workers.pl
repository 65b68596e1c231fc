:- module(sg_job_workers,
          [ workers_reset/0,
            worker_found/3,             % +Run, +Out, -Worker
            worker_with_room/4,         % +Job, +Worker0, +Run, -Worker
            job_given/6,                % +Job, +Key, +Inputs, +Worker, +Run,
                                        % +Out
            results_kept/2,             % +Run, +Out
            drained/2,                  % +Run, +Out
            workers_gone/0
          ]).
:- use_module(batch_store, [job_folder/3]).
:- use_module(job_result,
              [job_ended/9, ended_badly/9, failed_by_error/5, folder_gone/1]).
:- use_module(job_words, [option_words/3, output_file/3]).
:- use_module(worker,
              [ worker_started/2, worker_asked/2, workers_ready/3,
                worker_answer/3, worker_ended/2, worker_kilobytes/2,
                worker_killed/1
              ]).
:- use_module(library(filesex),
              [delete_directory_and_contents/1, make_directory_path/1]).
:- use_module(library(lists), [append/3, member/2, min_list/2]).
:- use_module(library(option), [option/3]).
/** <module> Who does which job: the workers of a batch, idle and busy.

A job that loops, that wants too much memory or that crashes takes one worker
with it. Run and Out are those of job_result.pl.

A worker that has answered gets its next job before its answer is kept, so it
does not wait for that. What failed is kept at once, since it may be the last.
*/

%   worker(Worker, State): State is idle(Grace), or busy(Job, Key, Inputs,
%   Folder, Start, Deadline).

:- dynamic worker/2.

%   answered(Job, Key, Inputs, Folder, Start, Head, Body): not yet kept.

:- dynamic answered/7.

%!  workers_reset is det.
%!  workers_gone is det.
%
%   There is no worker yet; none is left, whatever it was doing.

workers_reset :-
    retractall(worker(_, _)),
    retractall(answered(_, _, _, _, _, _, _)),
    flag(sg_batch_id, _, 0).

workers_gone :-
    forall(retract(worker(Worker, _)), worker_killed(Worker)).

%!  worker_found(+Run, +Out, -Worker) is det.
%
%   Worker is idle; when all are busy, as soon as one has answered.

worker_found(Run, Out, Worker) :-
    (   worker(Worker0, idle(_))
    ->  Worker = Worker0
    ;   Run = run(_, Folder, _, Options),
        option(workers(Most), Options, 1),
        workers_now(N),
        N < Most
    ->  worker_started(Folder, Worker),
        starting_seconds(Grace),
        assertz(worker(Worker, idle(Grace)))
    ;   answers_heard(Run, Out),
        worker_found(Run, Out, Worker)
    ).

%!  worker_with_room(+Job, +Worker0, +Run, -Worker) is det.
%
%   Worker is another one than Worker0 if what jobs before left there would
%   count for the limit of memory of this Job.

worker_with_room(job(_, _, _, _, _, _, Limits, _), Worker0, Run, Worker) :-
    (   memberchk(memory-Megabytes, Limits),
        worker(Worker0, idle(0)),
        worker_kilobytes(Worker0, Kilobytes),
        Kilobytes*2 > Megabytes*1000
    ->  retract(worker(Worker0, idle(0))),
        worker_killed(Worker0),
        Run = run(_, Folder, _, _),
        worker_started(Folder, Worker),
        starting_seconds(Grace),
        assertz(worker(Worker, idle(Grace)))
    ;   Worker = Worker0
    ).

%   starting_seconds(Grace): what a new worker may take before its first job.

starting_seconds(5).

workers_now(N) :-
    findall(W, worker(W, _), Workers),
    length(Workers, N).

%!  job_given(+Job, +Key, +Inputs, +Worker, +Run, +Out) is det.
%
%   Worker, which is idle, begins Job.

job_given(Job, Key, Inputs, Worker, Run, Out) :-
    Run = run(Store, _, made(_, _, Language), _),
    Job = job(_, _, _, Verb, Files, Options, Limits, _),
    flag(sg_batch_id, Id0, Id0+1),
    Id is Id0+1,
    catch(( job_folder(Store, Id, Folder),
            folders_made(Options, Folder) ),
          error(Formal, Context), true),
    (   nonvar(Formal)
    ->  failed_by_error(Job, Key, error(Formal, Context), Run, Out)
    ;   option_words(Options, Folder, Words0),
        (   memberchk(lang-_, Options)
        ->  Words = Words0
        ;   atom_concat('--lang=', Language, Word),
            Words = [Word|Words0]
        ),
        append([Verb|Files], Words, Argv),
        request(Id, Argv, Limits, Head),
        get_time(Start),
        retract(worker(Worker, idle(Grace))),
        (   memberchk(time_limit-Seconds, Limits)
        ->  Deadline is Start+Seconds+Grace
        ;   Deadline = none
        ),
        (   worker_asked(Worker, Head)
        ->  assertz(worker(Worker, busy(Job, Key, Inputs, Folder, Start,
                                        Deadline)))
        ;   worker_killed(Worker),      % it had ended; the job has not begun
            delete_directory_and_contents(Folder),
            worker_found(Run, Out, Other),
            job_given(Job, Key, Inputs, Other, Run, Out)
        )
    ).

%   folders_made(Options, Folder): those in the names of outputs.

folders_made(Options, Folder) :-
    forall(( member(Option, Options),
             output_file(Option, _, Pattern),
             file_directory_name(Pattern, Inner),
             Inner \== '.' ),
           ( atomic_list_concat([Folder, /, Inner], Path),
             make_directory_path(Path) )).

request(Id, Argv, Limits, Head) :-
    Head0 = _{id:Id, do:run, argv:Argv, wrote:false},
    (   memberchk(memory-Megabytes, Limits)
    ->  Head1 = Head0.put(memory_mb, Megabytes)
    ;   Head1 = Head0
    ),
    (   memberchk(cpu-Seconds, Limits)
    ->  Head = Head1.put(cpu_s, Seconds)
    ;   Head = Head1
    ).

%!  drained(+Run, +Out) is det.
%
%   All workers have answered.

drained(Run, Out) :-
    results_kept(Run, Out),
    (   worker(_, busy(_, _, _, _, _, _))
    ->  answers_heard(Run, Out),
        drained(Run, Out)
    ;   true
    ).

%   answers_heard(Run, Out): wait for a while; what has answered is idle again,
%   what is over its time is killed. The job of a worker that ended failed.

answers_heard(Run, Out) :-
    findall(Worker, worker(Worker, busy(_, _, _, _, _, _)), Workers),
    seconds_left(Seconds),
    workers_ready(Workers, Seconds, Ready),
    forall(member(Worker, Ready), answer_taken(Worker, Run, Out)),
    get_time(Now),
    forall(( worker(Worker, busy(_, _, _, _, _, Deadline)),
             number(Deadline),
             Now > Deadline ),
           out_of_time(Worker, Run, Out)).

%   seconds_left(Seconds): to the next deadline, but not so long that nobody
%   hears Ctrl-C.

seconds_left(Seconds) :-
    get_time(Now),
    findall(Left,
            ( worker(_, busy(_, _, _, _, _, Deadline)),
              number(Deadline),
              Left is Deadline-Now ),
            Lefts),
    min_list([0.2|Lefts], Seconds0),
    Seconds is max(0.001, Seconds0).

out_of_time(Worker, Run, Out) :-
    retract(worker(Worker, busy(Job, Key, _, Folder, Start, _))),
    worker_killed(Worker),
    Job = job(_, _, _, _, _, _, Limits, _),
    memberchk(time_limit-Limit, Limits),
    since(Start, Seconds),
    ended_badly(Job, Key, Folder, timeout, null, timeout(Limit),
                usage(Seconds, 0, 0), Run, Out).

since(Start, Seconds) :-
    get_time(Now),
    Seconds is Now-Start.

answer_taken(Worker, Run, Out) :-
    retract(worker(Worker, busy(Job, Key, Inputs, Folder, Start, _))),
    worker_answer(Worker, Head, Body),
    (   Head == end_of_file
    ->  worker_ended(Worker, How),
        since(Start, Seconds),
        ended_badly(Job, Key, Folder, killed, null, ended(How),
                    usage(Seconds, 0, 0), Run, Out)
    ;   (   worn_out(Head)
        ->  worker_ended(Worker, _)
        ;   assertz(worker(Worker, idle(0)))
        ),
        assertz(answered(Job, Key, Inputs, Folder, Start, Head, Body)),
        (   get_dict(status, Head, 0)
        ->  true
        ;   results_kept(Run, Out)
        )
    ).

%!  results_kept(+Run, +Out) is det.
%
%   What workers have answered is in the store, and in the report.

results_kept(Run, Out) :-
    forall(retract(answered(Job, Key, Inputs, Folder, Start, Head, Body)),
           result_kept(Job, Key, Inputs, Folder, Start, Head, Body, Run, Out)).

result_kept(Job, Key, Inputs, Folder, Start, Head, Body, Run, Out) :-
    catch(( job_ended(Job, Key, Inputs, Folder, Start, Head, Body, Run, Out)
          ->  Fault = none
          ;   Fault = sanggwan(no_end)
          ),
          error(Formal, Context), Fault = error(Formal, Context)),
    (   Fault == none
    ->  true
    ;   folder_gone(Folder),
        failed_by_error(Job, Key, Fault, Run, Out)
    ).

%   worn_out(Head): the worker ends, or has more memory than it should keep.

worn_out(Head) :-
    get_dict(last, Head, true),
    !.
worn_out(Head) :-
    get_dict(rss_kb, Head, Kilobytes),
    most_kept(Most),
    Kilobytes > Most.

most_kept(1_000_000).
