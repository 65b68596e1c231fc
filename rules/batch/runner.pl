:- module(sg_runner,
          [ batch_run/4                 % +File, +Options, +Tools, -Status
          ]).
:- use_module(batch_report, [json_text/2, outcome/1, report_line/2]).
:- use_module(batch_store, [with_store/3]).
:- use_module(job_key, [program_digest/1, job_inputs/3, job_key/4]).
:- use_module(job_name, [in_shard/3]).
:- use_module(job_names, [jobs_checked/3]).
:- use_module(job_result,
              [ cached_job/4, failure_kept/3, failed_again/4,
                failed_by_error/5 ]).
:- use_module(job_workers,
              [ workers_reset/0, worker_found/3, worker_with_room/4,
                job_given/6, results_kept/2, drained/2, workers_gone/0 ]).
:- use_module(manifest, [with_manifest/4, manifest_folder/2, manifest_job/3]).
:- use_module(run_state,
              [ run_state_reset/0, interrupts_noted/1, is_interrupted/0,
                stops/0, count_of/2, run_status/1 ]).
:- use_module('../language', [language/1]).
:- use_module('../plain', [plain_text/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> A batch: the jobs of a manifest, in processes of their own.

Jobs are taken in order and given to workers; what is in the store is not made
again. Each is a line of the report.
*/

%!  batch_run(+File, +Options, +Tools, -Status) is det.
%
%   Do the jobs of the manifest File; Tools as of with_manifest/4. Status is 0,
%   5 if a job failed, 130 if there was an interrupt. Options:
%
%     - out(Folder): where results go
%     - workers(N)
%     - shard(I, N): only those jobs
%     - only(Names): only these, a list of texts
%     - list(true): print the names of the jobs, do none
%     - resume(true): what failed with the same key is not tried again
%     - keep_going(true): a failure does not end the batch
%     - report(File): where the lines go, else to standard output
%     - copy(true): results are copies, not links into the store
%     - quiet(true): no terminal shows how far the check of the manifest is
%     - version(Text): of the program
%
%   @error as with_manifest/4 and jobs_checked/3; usage_error(no_job(Name))

batch_run(File, Options, Tools, Status) :-
    with_manifest(File, Tools, Manifest,
                  sg_runner:manifest_run(Manifest, Options, Status)).

:- public manifest_run/3.

manifest_run(Manifest, Options, Status) :-
    (   option(list(true), Options)
    ->  jobs_listed(Manifest, Options),
        Status = 0
    ;   checked_run(Manifest, Options, Status)
    ).

checked_run(Manifest, Options, Status) :-
    (   option(quiet(true), Options)
    ->  Show = false
    ;   Show = true
    ),
    jobs_checked(Manifest, Show, Count),
    only_known(Manifest, Options),
    option(out(Out), Options),
    with_store(Out, Store,
               interrupts_noted(stored_run(Manifest, Options, Store, Count,
                                           Status))).

%   wanted(Job, Options): of the shard, and of those that are named.

wanted(job(_, Name, _, _, _, _, _, _), Options) :-
    (   option(shard(I, N), Options)
    ->  in_shard(Name, I, N)
    ;   true
    ),
    (   option(only(Names), Options)
    ->  once(called(Name, Names, _))
    ;   true
    ).

%   called(Name, Names, One): One of Names is Name, or as it is printed.

called(Name, Names, One) :-
    (   memberchk(Name, Names)
    ->  One = Name
    ;   plain_text(Name, Plain),
        member(One, Names),
        atom_string(One, Plain)
    ).

jobs_listed(Manifest, Options) :-
    only_known(Manifest, Options),
    forall(( manifest_job(Manifest, true, Job),
             wanted(Job, Options),
             Job = job(_, Name, _, _, _, _, _, _) ),
           ( plain_text(Name, Plain),
             format("~w~n", [Plain]) )).

only_known(Manifest, Options) :-
    (   option(only(Names), Options),
        findall(One,
                ( manifest_job(Manifest, false, job(_, Name, _, _, _, _, _, _)),
                  called(Name, Names, One) ),
                Known),
        member(Name, Names),
        \+ memberchk(Name, Known)
    ->  throw(error(usage_error(batch(no_job(Name))), _))
    ;   true
    ).


                /*******************************
                *             RUN              *
                *******************************/

stored_run(Manifest, Options, Store, Count, Status) :-
    setup_call_cleanup(
        ( run_state_reset,
          workers_reset ),
        ( run_of(Manifest, Options, Store, Run),
          report_opened(Options, Out),
          call_cleanup(reported_run(Run, Manifest, Options, Count, Out, Status),
                       report_closed(Options, Out)) ),
        workers_gone).

%   run_of(Manifest, Options, Store, Run): run(Store, Folder, Made, Options).

run_of(Manifest, Options, Store, run(Store, Folder, Made, Options)) :-
    manifest_folder(Manifest, Folder0),
    absolute_file_name(Folder0, Folder),
    option(version(Version), Options, ''),
    program_digest(Digest),
    language(Language),
    Made = made(Version, Digest, Language).

report_opened(Options, Out) :-
    (   option(report(File), Options)
    ->  file_directory_name(File, Folder),
        (   exists_directory(Folder)
        ->  true
        ;   throw(error(usage_error(no_folder(Folder)), _))
        ),
        catch(open(File, write, Out, [encoding(utf8)]), error(Formal, _),
              report_refused(File, Formal))
    ;   Out = user_output
    ).

report_refused(File, Formal) :-
    (   exists_directory(File)
    ->  Why = directory
    ;   Formal = permission_error(_, _, _)
    ->  Why = permission
    ;   Why = error
    ),
    throw(error(cannot_write(File, Why), _)).

report_closed(Options, Out) :-
    (   option(report(_), Options)
    ->  close(Out, [force(true)])
    ;   true
    ).

reported_run(Run, Manifest, Options, Count, Out, Status) :-
    get_time(Start),
    Run = run(store(Folder, _), _, made(Version, _, _), _),
    arg(1, Manifest, Name),
    (   option(shard(I, N), Options)
    ->  format(string(Shard), '~d/~d', [I, N])
    ;   Shard = "1/1"
    ),
    json_text(_{batch:Name, folder:Folder, shard:Shard, manifest_jobs:Count,
                version:Version}, First),
    report_line(Out, First),
    (   manifest_job(Manifest, false, Job),
        wanted(Job, Options),
        job_taken(Job, Run, Out),
        stops
    ->  true
    ;   true
    ),
    drained(Run, Out),
    get_time(End),
    Seconds is End-Start,
    summary(Out, Seconds),
    run_status(Status).

summary(Out, Seconds) :-
    findall(Outcome-N, ( outcome(Outcome), count_of(Outcome, N) ), Pairs),
    dict_pairs(Counts, _, Pairs),
    (   is_interrupted
    ->  Interrupted = true
    ;   Interrupted = false
    ),
    Tenths is round(Seconds*1000)/1000.0,
    json_text(_{summary:Counts, seconds:Tenths, interrupted:Interrupted},
              Text),
    report_line(Out, Text),
    print_message(informational, sanggwan(batch(summary(Pairs)))).


                /*******************************
                *            A JOB             *
                *******************************/

%   job_taken(Job, Run, Out): Job is in the store, or a worker has it.

job_taken(Job, Run, Out) :-
    Run = run(_, Folder, Made, Options),
    catch(( job_inputs(Job, Folder, Inputs),
            job_key(Job, Inputs, Made, Key),
            (   cached_job(Job, Key, Run, Out)
            ->  Cached = true
            ;   Cached = false
            ) ),
          error(Formal, Context), true),
    (   nonvar(Formal)
    ->  ( var(Key) -> Key = '' ; true ),
        failed_by_error(Job, Key, error(Formal, Context), Run, Out)
    ;   Cached == true
    ->  true
    ;   option(resume(true), Options),
        failure_kept(Run, Key, Text)
    ->  failed_again(Job, Key, Text, Out)
    ;   worker_found(Run, Out, Worker),
        \+ stops
    ->  worker_with_room(Job, Worker, Run, Roomy),
        job_given(Job, Key, Inputs, Roomy, Run, Out)
    ;   true
    ),
    results_kept(Run, Out).
