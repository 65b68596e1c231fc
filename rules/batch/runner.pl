:- module(sg_runner,
          [ batch_run/4                 % +File, +Options, +Tools, -Status
          ]).
:- use_module(batch_report, [line_text/3, json_text/2, outcome/1]).
:- use_module(batch_store,
              [ with_store/3, job_folder/3, folder_files/2, published/4,
                result_place/3, spoiled/1, sizes_text/3, failure_written/3,
                failure_stored/3, failure_removed/2, linked/5
              ]).
:- use_module(job_key,
              [ program_digest/1, job_inputs/3, also_read/5, read_as_before/1,
                job_key/4 ]).
:- use_module(job_name, [stem_path/3, in_shard/3]).
:- use_module(job_names, [jobs_checked/3]).
:- use_module(job_words, [option_words/3, output_option/1]).
:- use_module(manifest, [with_manifest/4, manifest_folder/2, manifest_job/3]).
:- use_module(worker,
              [ worker_started/2, worker_asked/2, workers_ready/3,
                worker_answer/3, worker_ended/2, worker_kilobytes/2,
                worker_killed/1
              ]).
:- use_module('../language', [language/1]).
:- use_module('../message/message_object', [message_object/3]).
:- use_module(library(apply), [exclude/3, maplist/3]).
:- use_module(library(filesex),
              [delete_directory_and_contents/1, make_directory_path/1]).
:- use_module(library(http/json), [atom_json_dict/3]).
:- use_module(library(lists), [append/3, member/2, min_list/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> A batch: the jobs of a manifest, in processes of their own.

Jobs are taken in order and given to workers; what is in the store is not made
again. A job that loops, that wants too much memory or that crashes takes one
worker with it, and is one line of the report.
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
               sg_runner:interrupts_noted(
                             sg_runner:stored_run(Manifest, Options, Store,
                                                  Count, Status))).

%   wanted(Job, Options): of the shard, and of those that are named.

wanted(job(_, Name, _, _, _, _, _, _), Options) :-
    (   option(shard(I, N), Options)
    ->  in_shard(Name, I, N)
    ;   true
    ),
    (   option(only(Names), Options)
    ->  memberchk(Name, Names)
    ;   true
    ).

jobs_listed(Manifest, Options) :-
    only_known(Manifest, Options),
    forall(( manifest_job(Manifest, true, Job),
             wanted(Job, Options),
             Job = job(_, Name, _, _, _, _, _, _) ),
           format("~w~n", [Name])).

only_known(Manifest, Options) :-
    (   option(only(Names), Options),
        findall(Name,
                ( manifest_job(Manifest, false, job(_, Name, _, _, _, _, _, _)),
                  memberchk(Name, Names) ),
                Known),
        member(Name, Names),
        \+ memberchk(Name, Known)
    ->  throw(error(usage_error(batch(no_job(Name))), _))
    ;   true
    ).


                /*******************************
                *          INTERRUPTS          *
                *******************************/

%   While jobs run, the first Ctrl-C lets these end; the second one ends them.

:- meta_predicate interrupts_noted(0).

interrupts_noted(Goal) :-
    flag(sg_batch_interrupts, _, 0),
    setup_call_cleanup(
        on_signal(int, Old, sg_runner:interrupted),
        once(Goal),
        on_signal(int, _, Old)).

:- public interrupted/1.

interrupted(Signal) :-
    flag(sg_batch_interrupts, N, N+1),
    (   N =:= 0
    ->  true
    ;   throw(sanggwan_interrupt(Signal))
    ).

is_interrupted :-
    flag(sg_batch_interrupts, N, N),
    N > 0.


                /*******************************
                *             RUN              *
                *******************************/

%   worker(Worker, State): State is idle(Grace), or busy(Job, Key, Inputs,
%   Folder, Start, Deadline).

:- dynamic worker/2, stopping/0.

stored_run(Manifest, Options, Store, Count, Status) :-
    setup_call_cleanup(
        run_begun,
        ( run_of(Manifest, Options, Store, Run),
          report_opened(Options, Out),
          call_cleanup(reported_run(Run, Manifest, Options, Count, Out, Status),
                       report_closed(Options, Out)) ),
        workers_gone).

run_begun :-
    retractall(worker(_, _)),
    retractall(stopping),
    flag(sg_batch_id, _, 0),
    forall(outcome(Outcome),
           ( counter(Outcome, Counter),
             flag(Counter, _, 0) )).

workers_gone :-
    forall(retract(worker(Worker, _)), worker_killed(Worker)).

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

said_line(Out, Text) :-
    write(Out, Text),
    nl(Out),
    flush_output(Out).

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
    said_line(Out, First),
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

stops :-
    (   stopping
    ;   is_interrupted
    ),
    !.

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
    said_line(Out, Text),
    print_message(informational, sanggwan(batch(summary(Pairs)))).

count_of(Outcome, N) :-
    counter(Outcome, Counter),
    flag(Counter, N, N).

counted(Outcome) :-
    counter(Outcome, Counter),
    flag(Counter, N, N+1).

counter(Outcome, Counter) :-
    atom_concat(sg_batch_, Outcome, Counter).

run_status(Status) :-
    (   is_interrupted
    ->  Status = 130
    ;   outcome(Outcome),
        \+ memberchk(Outcome, [done,cached]),
        count_of(Outcome, N),
        N > 0
    ->  Status = 5
    ;   Status = 0
    ).


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
        Run = run(Store, _, _, _),
        failure_stored(Store, Key, Text),
        failure_holds(Text)
    ->  failed_again(Job, Key, Text, Out)
    ;   worker_found(Run, Out, Worker),
        \+ stops
    ->  worker_with_room(Job, Worker, Run, Roomy),
        job_given(Job, Key, Inputs, Roomy, Run, Out)
    ;   true
    ).

%   cached_job(Job, Key, Run, Out): the result of Key is there, with files of
%   the sizes that it had. An answer that is no is a failure each time.

cached_job(Job, Key, Run, Out) :-
    Run = run(Store, _, _, _),
    result_place(Store, Key, Place),
    (   named_files(Job, Files),
        cached_files(Place, Files, Status, Said)
    ->  true
    ;   exists_directory(Place),
        folder_files(Place, Files),
        cached_files(Place, Files, Status, Said)
    ->  true
    ;   exists_directory(Place)
    ->  spoiled(Place),
        fail
    ),
    files_linked(Job, Files, Place, Run, Paths),
    (   Status =:= 0
    ->  Outcome = cached
    ;   Outcome = failed
    ),
    line_said(Job, result(Outcome, Status, Key, usage(0, 0, 0), Paths, Said,
                          null), Out),
    (   Outcome == failed
    ->  language(Language),
        failure_told(Job, null, Language)
    ;   true
    ).

%   named_files(Job, Files): those that most jobs make, so that the folder need
%   not be searched.

named_files(job(_, _, _, _, _, Options, _, _), Files) :-
    findall(File, ( member(Name-File, Options), output_option(Name) ), Files0),
    sort(Files0, Files).

%   cached_files(Place, Files, Status, Said): Files are what was put in Place.

cached_files(Place, Files, Status, Said) :-
    catch(( sizes_text(Place, Files, Sizes),
            cached_result(Place, Sizes, Status, Said) ),
          error(_, _), fail).

%   cached_result(Place, Sizes, Status, Said): most results need no reader of
%   JSON.

cached_result(Place, Sizes, Status, Said) :-
    atom_concat(Place, '/job.json', File),
    setup_call_cleanup(
        open(File, read, In, [encoding(utf8)]),
        read_string(In, _, Text),
        close(In)),
    sub_string(Text, _, 2, 0, "}\n"),
    result_head(Sizes, 0, '[]', '[]', Head),
    (   sub_string(Text, 0, _, _, Head)
    ->  Status = 0,
        Said = '[]'
    ;   atom_json_dict(Text, Dict, []),
        Status = Dict.status,
        json_text(Dict.said, Said),
        json_text(Dict.read, Read),
        result_head(Sizes, Status, Said, Read, Head1),
        sub_string(Text, 0, _, _, Head1),
        read_as_before(Dict.read)
    ).

%   result_head(Sizes, Status, Said, Read, Head): how job.json begins.

result_head(Sizes, Status, Said, Read, Head) :-
    atomic_list_concat(
        [ '{"files":', Sizes, ',"status":', Status, ',"said":', Said,
          ',"read":', Read, ',' ],
        Head).

%   failure_holds(Text): what it read is as it was.

failure_holds(Text) :-
    atom_json_dict(Text, Dict, []),
    read_as_before(Dict.read).

failed_again(Job, Key, Text, Out) :-
    atom_json_dict(Text, Dict, []),
    atom_string(Outcome, Dict.outcome),
    json_text(Dict.error, Error),
    json_text(Dict.said, Said),
    line_said(Job, result(Outcome, Dict.status, Key, usage(0, 0, 0), [], Said,
                          Error), Out),
    language(Language),
    failure_told(Job, Dict.error, Language).

line_said(Job, Result, Out) :-
    Result = result(Outcome, _, _, _, _, _, _),
    line_text(Job, Result, Text),
    said_line(Out, Text),
    counted(Outcome).

%   files_linked(Job, Files, Place, Run, Paths): Files in the Place of the store
%   have the names that Job gives them.

files_linked(job(_, _, Stem, _, _, _, _, _), Files, Place, Run, Paths) :-
    Run = run(Store, _, _, Options),
    (   option(copy(true), Options)
    ->  Way = copy
    ;   Way = link
    ),
    maplist(file_linked(Store, Way, Place, Stem), Files, Paths).

file_linked(Store, Way, Place, Stem, File, Path) :-
    stem_path(File, Stem, Path),
    linked(Store, Way, Place, File, Path).


                /*******************************
                *           WORKERS            *
                *******************************/

%   worker_found(Run, Out, Worker): one that is idle; when all are busy, as
%   soon as one has answered.

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

%   worker_with_room(Job, Worker0, Run, Worker): Worker is another one if what
%   jobs before left in Worker0 would count for the limit of memory of this Job.

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
    forall(( member(Name-Pattern, Options),
             output_option(Name),
             file_directory_name(Pattern, Inner),
             Inner \== '.' ),
           ( atomic_list_concat([Folder, /, Inner], Path),
             make_directory_path(Path) )).

request(Id, Argv, Limits, Head) :-
    Head0 = _{id:Id, do:run, argv:Argv},
    (   memberchk(memory-Megabytes, Limits)
    ->  Head1 = Head0.put(memory_mb, Megabytes)
    ;   Head1 = Head0
    ),
    (   memberchk(cpu-Seconds, Limits)
    ->  Head = Head1.put(cpu_s, Seconds)
    ;   Head = Head1
    ).

drained(Run, Out) :-
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
        catch(( job_ended(Job, Key, Inputs, Folder, Start, Head, Body, Run, Out)
              ->  Fault = none
              ;   Fault = sanggwan(no_end)
              ),
              error(Formal, Context), Fault = error(Formal, Context)),
        (   Fault == none
        ->  true
        ;   folder_gone(Folder),
            failed_by_error(Job, Key, Fault, Run, Out)
        )
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


                /*******************************
                *            RESULTS           *
                *******************************/

%   job_ended(Job, Key, Inputs, Folder, Start, Head, Body, Run, Out): a worker
%   has answered.

job_ended(Job, Key, Inputs, Folder, Start, Head, Body, Run, Out) :-
    Run = run(Store, Base, _, _),
    (   get_dict(status, Head, Status)
    ->  Usage = usage(Head.seconds, Head.cpu, Head.rss_kb),
        exclude(of_no_interest, Head.messages, Messages)
    ;   Status = 2,
        Usage = usage(0, 0, 0),
        Messages = []
    ),
    without_folder(Folder, Messages, Said),
    (   get_dict(read, Head, Files)
    ->  true
    ;   Files = []
    ),
    (   \+ job_inputs(Job, Base, Inputs)
    ->  Unchanged = false
    ;   also_read(Files, Inputs, Base, Start, Read0)
    ->  json_text(Read0, Read)
    ;   Unchanged = false
    ),
    (   Status > 1
    ->  ( Unchanged == false -> Read = '[]' ; true ),
        failed_job(Job, Key, Folder, Read,
                   result(failed, Status, Key, Usage, [], Said, Head.error),
                   Run, Out)
    ;   Unchanged == false
    ->  ended_badly(Job, Key, Folder, failed, 3, changed, Usage, Run, Out)
    ;   text_kept(Job, Head, Body, Folder),
        folder_files(Folder, Made),
        job_written(Job, Key, Inputs, result(Status, Said, Read), Folder, Made,
                    Run),
        published(Store, Folder, Key, Place),
        failure_removed(Store, Key),
        files_linked(Job, Made, Place, Run, Paths),
        (   Status =:= 0
        ->  Outcome = done
        ;   Outcome = failed
        ),
        line_said(Job, result(Outcome, Status, Key, Usage, Paths, Said, null),
                  Out),
        (   Outcome == failed
        ->  failure_said(Job, null, Run)
        ;   true
        )
    ).

%   That a file was written is no news.

of_no_interest(Message) :-
    get_dict(code, Message, Code),
    memberchk(Code, ["wrote", wrote]).

%   without_folder(Folder, Value, Text): Value as JSON, files without the folder
%   that they were made in.

without_folder(Folder, Value, Text) :-
    (   Value == []
    ->  Text = '[]'
    ;   Value == null
    ->  Text = null
    ;   json_text(Value, Text0),
        atom_concat(Folder, /, Prefix),
        atomic_list_concat(Parts, Prefix, Text0),
        atomic_list_concat(Parts, Text)
    ).

%   text_kept(Job, Head, Body, Folder): what the verb printed is a file, too.

text_kept(job(_, _, _, _, _, Options, _, _), Head, Body, Folder) :-
    (   get_dict(stdout, Head, N),
        N > 0
    ->  sub_string(Body, 0, N, _, Octets),
        (   ( memberchk(json-true, Options) ; memberchk(format-json, Options) )
        ->  Ending = json
        ;   memberchk(format-Ending0, Options)
        ->  Ending = Ending0
        ;   Ending = txt
        ),
        atomic_list_concat([Folder, '/%.stdout.', Ending], File),
        octets_written(File, octet, Octets)
    ;   true
    ).

octets_written(File, Encoding, Text) :-
    setup_call_cleanup(
        open(File, write, Out, [encoding(Encoding), newline(posix)]),
        write(Out, Text),
        close(Out)).

%   job_written(Job, Key, Inputs, Result, Folder, Files, Run): what the result
%   is made of; nothing of it is otherwise another time.

job_written(job(_, _, _, Verb, Files, Options, _, _), Key, Inputs,
            result(Status, Said, Read), Folder, Made,
            run(_, _, made(Version, Digest, Language), _)) :-
    option_words(Options, '.', Words0),
    maplist(without_dot, Words0, Words),
    append([Verb|Files], Words, Argv),
    list_text(json_text, Argv, ArgvText),
    list_text(input_text, Inputs, InputsText),
    maplist(json_text, [Key,Language,Digest,Version], Texts),
    sizes_text(Folder, Made, Sizes),
    result_head(Sizes, Status, Said, Read, Head),
    format(string(Text),
           '~w"argv":~w,"inputs":~w,"key":~w,"language":~w,"program":~w,\c
            "version":~w}~n',
           [Head, ArgvText, InputsText|Texts]),
    atom_concat(Folder, '/job.json', File),
    octets_written(File, utf8, Text).

without_dot(Word0, Word) :-
    (   atomic_list_concat([Name, Value], '=./', Word0)
    ->  atomic_list_concat([Name, =, Value], Word)
    ;   Word = Word0
    ).

input_text(input(File, Digest), Text) :-
    json_text(File, FileText),
    atomic_list_concat(['{"file":', FileText, ',"sha256":"', Digest, '"}'],
                       Text).

:- meta_predicate list_text(2, +, -).

%   list_text(Goal, Items, Text): JSON of what call(Goal, Item, T) gives.

list_text(Goal, Items, Text) :-
    maplist(Goal, Items, Texts),
    atomic_list_concat(Texts, ',', Inner),
    atomic_list_concat(['[', Inner, ']'], Text).

%   failed_job(Job, Key, Folder, Read, Result, Run, Out): Result with its Error
%   as an object.

failed_job(Job, Key, Folder, Read, Result0, Run, Out) :-
    Run = run(Store, _, _, _),
    Result0 = result(Outcome, Status, Key, Usage, Files, Said, Object),
    without_folder(Folder, Object, Error),
    Result = result(Outcome, Status, Key, Usage, Files, Said, Error),
    folder_gone(Folder),
    format(string(Text),
           '{"outcome":"~w","status":~w,"said":~w,"read":~w,"error":~w}',
           [Outcome, Status, Said, Read, Error]),
    catch(failure_written(Store, Key, Text), error(_, _), true),
    line_said(Job, Result, Out),
    failure_said(Job, Object, Run).

folder_gone(Folder) :-
    catch(delete_directory_and_contents(Folder), error(_, _), true).

%   ended_badly(Job, Key, Folder, Outcome, Status, What, Usage, Run, Out)

ended_badly(Job, Key, Folder, Outcome, Status, What, Usage, Run, Out) :-
    message_object(error, sanggwan(batch(What)), Object),
    failed_job(Job, Key, Folder, '[]',
               result(Outcome, Status, Key, Usage, [], '[]', Object), Run,
               Out).

%   failed_by_error(Job, Key, Error, Run, Out): an error of the batch itself, as
%   of a full disk.

failed_by_error(Job, Key, Error, Run, Out) :-
    message_object(error, Error, Object),
    json_text(Object, Text),
    line_said(Job, result(failed, 2, Key, usage(0, 0, 0), [], '[]', Text),
              Out),
    failure_said(Job, Object, Run).

%   failure_said(Job, Error, Run): the first line of why it failed, to people.
%   Without --keep-going it is the last one.

failure_said(Job, Error, run(_, _, Made, Options)) :-
    Made = made(_, _, Language),
    failure_told(Job, Error, Language),
    (   ( option(keep_going(true), Options) ; stopping )
    ->  true
    ;   assertz(stopping)
    ).

%   failure_told(Job, Error, Language): `null` is an answer that is no.

failure_told(job(_, Name, _, _, _, _, _, _), Error0, Language) :-
    (   Error0 == null
    ->  message_object(error, sanggwan(batch(no)), Error)
    ;   Error = Error0
    ),
    Words = Error.words.get(Language),
    split_string(Words, "\n", "", [Why|_]),
    print_message(informational, sanggwan(batch(failed(Name, Why)))).
