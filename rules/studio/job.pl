:- module(sg_job,
          [ captured/2,                 % :Goal, -Octets
            printed_octets/3,           % +Type, :Goal, -Octets
            verb_job/5,                 % :Run, +Head, +Body, -Reply, -Out
            with_input/2,               % +Text, :Goal
            worlds_collected/0
          ]).
:- use_module('../environment', [environment/2]).
:- use_module('../limits', [with_usual_limits/1]).
:- use_module('../message/message_object',
              [ error_object/3, message_object/3, objects_heard/2,
                files_untold/1
              ]).
:- use_module('../output', [files_recorded/2]).
:- use_module(files_read, [files_read/2]).
:- use_module(process_state, [runs_users_code/1, with_process_kept/3]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(memfile),
              [ new_memory_file/1, free_memory_file/1, open_memory_file/4,
                memory_file_to_string/3, size_memory_file/3
              ]).
:- use_module(library(readutil), [read_file_to_string/3]).
:- use_module(library(rlimit), [rlimit/3]).
/** <module> A verb as a job of a session: as if a process of its own did it.

What the verb reads as standard input is the body of the request; what it
prints goes into the reply. It begins in an empty world, in the folder and the
language that the request names; when it is over the process is as before.
*/

:- meta_predicate
    captured(0, -),
    printed_octets(+, 1, -),
    verb_job(2, +, +, -, -),
    with_input(+, 0).

%!  verb_job(:Run, +Head:dict, +Body, -Reply:dict, -Out) is det.
%
%   Do what Head.argv says: call(Run, Arguments, Status). Body is the standard
%   input. Reply has the keys that docs/protocol.md lists for `run`, except id
%   and rev; Out is the text of octets of standard output, then of standard
%   error.
%
%   @error request_error(What)

verb_job(Run, Head, Body, Reply, Out) :-
    job_arguments(Head, Arguments),
    job_folder(Head, Folder),
    job_language(Head, Language),
    job_limits(Head, Limits),
    job_told(Head, Told),
    peak_reset,
    get_time(T0),
    statistics(process_cputime, C0),
    setup_call_cleanup(
        new_memory_file(OutFile),
        setup_call_cleanup(
            new_memory_file(ErrorFile),
            ( job_ran(job(Run, Arguments, Folder, Language, Limits, Told, Body),
                      OutFile, ErrorFile,
                      result(Status0, Files, Objects0, Read), Kept),
              printed(OutFile, ErrorFile, Status0, Objects0, Printed)
            ),
            free_memory_file(ErrorFile)),
        free_memory_file(OutFile)),
    Printed = printed(Status, Objects, StdOut, StdErr),
    get_time(T1),
    statistics(process_cputime, C1),
    Seconds is T1-T0,
    Cpu is C1-C0,
    peak_memory(Rss),
    worlds_collected,
    error_object(Status, Objects, Error),
    string_length(StdOut, OutLength),
    string_length(StdErr, ErrorLength),
    string_concat(StdOut, StdErr, Out),
    Reply0 = _{ status:Status, files:Files, messages:Objects, error:Error,
                seconds:Seconds, cpu:Cpu, rss_kb:Rss,
                stdout:OutLength, stderr:ErrorLength },
    (   Read == []
    ->  Reply1 = Reply0
    ;   Reply1 = Reply0.put(read, Read)
    ),
    (   Kept == true
    ->  Reply = Reply1
    ;   Reply = Reply1.put(last, true)
    ).


                /*******************************
                *           REQUEST            *
                *******************************/

job_arguments(Head, Arguments) :-
    (   get_dict(argv, Head, Texts),
        is_list(Texts),
        forall(member(Text, Texts), string(Text))
    ->  maplist(argument, Texts, Arguments)
    ;   request_error(bad_key(argv, verb))
    ).

argument(Text, Atom) :-
    (   sub_string(Text, _, _, _, "\u0000")
    ->  request_error(bad_key(argv, verb))
    ;   atom_string(Atom, Text)
    ).

job_folder(Head, Folder) :-
    (   get_dict(cwd, Head, Folder0)
    ->  (   string(Folder0),
            exists_directory(Folder0)
        ->  Folder = Folder0
        ;   request_error(no_folder(Folder0))
        )
    ;   Folder = '.'
    ).

job_language(Head, Language) :-
    (   get_dict(lang, Head, Text)
    ->  (   memberchk(Text, ["en","ko"])
        ->  Language = Text
        ;   request_error(bad_key(lang, language))
        )
    ;   Language = none
    ).

%   job_limits(Head, Limits): limits(Octets, Seconds), `unlimited` where the
%   request does not say.

job_limits(Head, limits(Octets, Seconds)) :-
    positive(Head, memory_mb, Megabytes),
    positive(Head, cpu_s, Seconds),
    (   Megabytes == unlimited
    ->  Octets = unlimited
    ;   Octets is ceiling(Megabytes*1 000 000),
        room_checked(Octets)
    ).

%   job_told(Head, Told): whether messages say which files were written.

job_told(Head, Told) :-
    (   get_dict(wrote, Head, Told0)
    ->  (   memberchk(Told0, [true,false])
        ->  Told = Told0
        ;   request_error(bad_key(wrote, boolean))
        )
    ;   Told = true
    ).

%   room_checked(Octets): the process does not have more already. Below that
%   nothing could be done, not even a reply be written.

room_checked(Octets) :-
    (   status_kilobytes("VmData:", Kilobytes),
        Least is Kilobytes*1024 + 2 000 000,
        Octets < Least
    ->  Megabytes is ceiling(Least/1 000 000),
        request_error(bad_key(memory_mb, least(Megabytes)))
    ;   true
    ).

positive(Head, Key, Value) :-
    (   get_dict(Key, Head, Value0)
    ->  (   number(Value0),
            Value0 > 0,
            Value0 < 1 000 000 000
        ->  Value = Value0
        ;   request_error(bad_key(Key, positive))
        )
    ;   Value = unlimited
    ).


                /*******************************
                *             RUN              *
                *******************************/

job_ran(Job, OutFile, ErrorFile, Result, Kept) :-
    Job = job(_, Arguments, Folder, Language, Limits, _, Body),
    with_process_kept(
        Arguments,
        in_folder(Folder,
            in_language(Language,
                with_streams(Body, OutFile, ErrorFile,
                    with_usual_limits(
                        within_limits(Limits,
                            sg_job:heard(Job, Result)))))),
        Kept).

heard(job(Run, Arguments, _, _, _, Told, _),
      result(Status, Files, Objects, Read)) :-
    files_recorded(objects_heard(told(Told, verb_done(Arguments, Run, Status,
                                                      Read)),
                                 Objects),
                   Files).

:- meta_predicate told(+, 0).

told(true, Goal) :-
    call(Goal).
told(false, Goal) :-
    files_untold(Goal).

:- meta_predicate verb_done(+, 2, -, -).

verb_done(Arguments, Run, Status, Read) :-
    (   runs_users_code(Arguments)
    ->  files_read(call(Run, Arguments, Status), Read)
    ;   call(Run, Arguments, Status),
        Read = []
    ).

:- meta_predicate
    in_folder(+, 0),
    in_language(+, 0),
    with_streams(+, +, +, 0),
    within_limits(+, 0).

in_folder(Folder, Goal) :-
    setup_call_cleanup(
        working_directory(Old, Folder),
        once(Goal),
        working_directory(_, Old)).

in_language(Language, Goal) :-
    current_prolog_flag(message_language, Flag),
    setup_call_cleanup(
        spoken_in(Language, Old),
        once(Goal),
        ( put_back(Old),
          set_prolog_flag(message_language, Flag)
        )).

spoken_in(none, none) :-
    !.
spoken_in(Language, Old) :-
    (   environment('LC_ALL', Value)
    ->  Old = set(Value)
    ;   Old = unset
    ),
    setenv('LC_ALL', Language).

put_back(none).
put_back(unset) :-
    unsetenv('LC_ALL').
put_back(set(Value)) :-
    setenv('LC_ALL', Value).

%   with_streams(Body, OutFile, ErrorFile, Goal): Goal reads Body and prints
%   into memory.

with_streams(Body, OutFile, ErrorFile, Goal) :-
    stream_property(OldIn, alias(user_input)),
    stream_property(OldOut, alias(user_output)),
    stream_property(OldError, alias(user_error)),
    setup_call_cleanup(
        new_memory_file(InFile),
        setup_call_cleanup(
            ( open_read(Body, InFile, In),
              open_printed(OutFile, Out),
              open_printed(ErrorFile, Error),
              standard_streams(In, Out, Error)
            ),
            once(Goal),
            ( standard_streams(OldIn, OldOut, OldError),
              maplist(closed, [In,Out,Error])
            )),
        free_memory_file(InFile)).

%!  captured(:Goal, -Octets) is semidet.
%
%   Call Goal once; what it prints on standard output are Octets, and what it
%   prints on standard error is lost.

captured(Goal, Octets) :-
    setup_call_cleanup(
        new_memory_file(OutFile),
        setup_call_cleanup(
            new_memory_file(ErrorFile),
            with_streams("", OutFile, ErrorFile, Goal),
            free_memory_file(ErrorFile)),
        ( memory_file_to_string(OutFile, Octets, octet),
          free_memory_file(OutFile)
        )).

%!  printed_octets(+Type, :Goal, -Octets) is semidet.
%
%   Octets are what call(Goal, Out) writes. Type is `text`, in UTF-8, or
%   `binary`.

printed_octets(Type, Goal, Octets) :-
    setup_call_cleanup(
        new_memory_file(File),
        ( setup_call_cleanup(
              open_memory_file(File, write, Out, [encoding(octet)]),
              ( (   Type == text
                ->  set_stream(Out, encoding(utf8)),
                    set_stream(Out, newline(posix))
                ;   true
                ),
                once(call(Goal, Out))
              ),
              close(Out)),
          memory_file_to_string(File, Octets, octet)
        ),
        free_memory_file(File)).

%!  with_input(+Text, :Goal) is semidet.
%
%   Call Goal once; Text, in UTF-8, is its standard input.

with_input(Text, Goal) :-
    stream_property(OldIn, alias(user_input)),
    setup_call_cleanup(
        new_memory_file(InFile),
        setup_call_cleanup(
            ( open_text(Text, InFile, In),
              set_stream(In, alias(user_input)),
              set_input(In)
            ),
            once(Goal),
            ( set_stream(OldIn, alias(user_input)),
              set_input(OldIn),
              closed(In)
            )),
        free_memory_file(InFile)).

open_text(Text, File, Stream) :-
    setup_call_cleanup(
        open_memory_file(File, write, Out, [encoding(utf8)]),
        format(Out, "~s", [Text]),
        close(Out)),
    open_memory_file(File, read, Stream, [encoding(octet)]),
    set_stream(Stream, encoding(utf8)).

standard_streams(In, Out, Error) :-
    set_stream(In, alias(user_input)),
    set_stream(Out, alias(user_output)),
    set_stream(Error, alias(user_error)),
    set_input(In),
    set_output(Out).

open_read(Octets, File, Stream) :-
    setup_call_cleanup(
        open_memory_file(File, write, Out, [encoding(octet)]),
        format(Out, "~s", [Octets]),
        close(Out)),
    open_memory_file(File, read, Stream, [encoding(octet)]),
    set_stream(Stream, encoding(utf8)).

open_printed(File, Stream) :-
    open_memory_file(File, write, Stream, [encoding(octet)]),
    set_stream(Stream, encoding(utf8)),
    set_stream(Stream, newline(posix)).

closed(Stream) :-
    (   is_stream(Stream)
    ->  close(Stream, [force(true)])
    ;   true
    ).

%   within_limits(Limits, Goal): of the process, while Goal runs; seconds are
%   those of the processor from now on.

within_limits(limits(Octets, Seconds), Goal) :-
    (   Seconds == unlimited
    ->  Cpu = unlimited
    ;   statistics(process_cputime, Used),
        Cpu is ceiling(Used+Seconds)
    ),
    setup_call_cleanup(
        ( limited(data, Octets, OldOctets),
          limited(cpu, Cpu, OldCpu)
        ),
        once(Goal),
        ( limit_put_back(data, OldOctets),
          limit_put_back(cpu, OldCpu)
        )).

%   limited(What, New, Old): Old is `same` if the limit stays as it is, or else
%   what it was, which may be `unlimited`.

limited(_, unlimited, same) :-
    !.
limited(What, New, Old) :-
    rlimit(What, Old, New).

limit_put_back(_, same) :-
    !.
limit_put_back(What, Old) :-
    rlimit(What, _, Old).


                /*******************************
                *            RESULT            *
                *******************************/

%   most_printed(Octets): more on one of the two streams is refused.

most_printed(16 000 000).

printed(OutFile, ErrorFile, Status0, Objects0, Printed) :-
    most_printed(Most),
    size_memory_file(OutFile, OutSize, octet),
    size_memory_file(ErrorFile, ErrorSize, octet),
    (   max(OutSize, ErrorSize) =< Most
    ->  memory_file_to_string(OutFile, Out, octet),
        memory_file_to_string(ErrorFile, Error, octet),
        Printed = printed(Status0, Objects0, Out, Error)
    ;   message_object(error, error(request_error(printed(Most)), _), Object),
        append(Objects0, [Object], Objects),
        Printed = printed(4, Objects, "", "")
    ).

%!  worlds_collected is det.
%
%   A world goes with its handle, an atom, and nobody collects these as often as
%   worlds of jobs need it; so who begins many calls this after each.

worlds_collected :-
    flag(sg_jobs, Jobs, Jobs+1),
    (   Jobs mod 16 =:= 15
    ->  garbage_collect_clauses,
        garbage_collect_atoms
    ;   true
    ).

%   peak_reset, peak_memory(Kilobytes): the most memory that the process had at
%   once since the reset; Linux counts that.

peak_reset :-
    catch(setup_call_cleanup(
              open('/proc/self/clear_refs', write, Out),
              write(Out, '5'),
              close(Out)),
          error(_, _), true).

peak_memory(Kilobytes) :-
    (   status_kilobytes("VmHWM:", Kilobytes0)
    ->  Kilobytes = Kilobytes0
    ;   Kilobytes = null
    ).

%   status_kilobytes(Name, Kilobytes) is semidet: as Linux counts them.

status_kilobytes(Name, Kilobytes) :-
    catch(read_file_to_string('/proc/self/status', Text, []),
          error(_, _), fail),
    sub_string(Text, _, _, After, Name),
    sub_string(Text, _, After, 0, Rest),
    split_string(Rest, "\n", " \tkB", [Number|_]),
    number_string(Kilobytes, Number).
