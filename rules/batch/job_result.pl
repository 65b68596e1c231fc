:- module(sg_job_result,
          [ cached_job/4,               % +Job, +Key, +Run, +Out
            failure_kept/3,             % +Run, +Key, -Text
            failed_again/4,             % +Job, +Key, +Text, +Out
            job_ended/9,                % +Job, +Key, +Inputs, +Folder, +Start,
                                        % +Head, +Body, +Run, +Out
            ended_badly/9,              % +Job, +Key, +Folder, +Outcome,
                                        % +Status, +What, +Usage, +Run, +Out
            failed_by_error/5,          % +Job, +Key, +Error, +Run, +Out
            folder_gone/1               % +Folder
          ]).
:- use_module(batch_report, [line_text/3, report_line/2, json_text/2]).
:- use_module(batch_store,
              [ folder_files/2, published/4, result_place/3, spoiled/1,
                sizes_text/3, failure_written/3, failure_stored/3,
                failure_removed/2, linked/5
              ]).
:- use_module(job_key, [job_inputs/3, also_read/5, read_as_before/1]).
:- use_module(job_name, [stem_path/3]).
:- use_module(job_words, [option_words/3, output_file/3]).
:- use_module(run_state, [counted/1, stop_begun/0]).
:- use_module('../language', [language/1]).
:- use_module('../message/message_object',
              [error_object/3, message_object/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(filesex), [delete_directory_and_contents/1]).
:- use_module(library(http/json), [atom_json_dict/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2]).
/** <module> What a job came to: its result, and its line in the report.

Run is run(Store, Folder, Made, Options): Folder that of the manifest, Made
made(Version, Digest, Language), Options those of batch_run/4 (runner.pl). Out
is where the report goes. A usage is usage(Seconds, Cpu, Kilobytes).
*/

%!  cached_job(+Job, +Key, +Run, +Out) is semidet.
%
%   The result of Key is there, with files of the sizes that it had: Job gets
%   its links and its line. An answer that is no is a failure each time.
%
%   @error cannot_write(Path, Why)

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
    error_said(Status, Said, Object, Error),
    line_said(Job, result(Outcome, Status, Key, usage(0, 0, 0), Paths, Said,
                          Error), Out),
    (   Outcome == failed
    ->  language(Language),
        failure_told(Job, Object, Language)
    ;   true
    ).

%   error_said(Status, Said, Object, Text): why the answer is no, if Said does
%   say so (--strict), and as JSON; else null.

error_said(0, _, null, null) :-
    !.
error_said(Status, Said, Object, Text) :-
    atom_json_dict(Said, Objects, []),
    error_object(Status, Objects, Object),
    json_text(Object, Text).

%   named_files(Job, Files): those that most jobs make, so that the folder need
%   not be searched.

named_files(job(_, _, _, _, _, Options, _, _), Files) :-
    findall(File, ( member(Option, Options), output_file(Option, _, File) ),
            Files0),
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

%!  failure_kept(+Run, +Key, -Text) is semidet.
%!  failed_again(+Job, +Key, +Text, +Out) is det.
%
%   Text says why the job of Key failed, and what that read is as it was; Job,
%   which was not tried again, gets its line.

failure_kept(run(Store, _, _, _), Key, Text) :-
    failure_stored(Store, Key, Text),
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
    report_line(Out, Text),
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
                *            RESULTS           *
                *******************************/

%!  job_ended(+Job, +Key, +Inputs, +Folder, +Start, +Head:dict, +Body, +Run,
%!            +Out) is det.
%
%   A worker has answered Head and Body (docs/protocol.md) of Job, begun at the
%   time Start, with its files in Folder: these are its result, or it failed.
%
%   @error cannot_write(Path, Why), permission_error, io_error

job_ended(Job, Key, Inputs, Folder, Start, Head, Body, Run, Out) :-
    Run = run(Store, Base, _, _),
    (   get_dict(status, Head, Status)
    ->  Usage = usage(Head.seconds, Head.cpu, Head.rss_kb),
        Messages = Head.messages
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
    ->  ( Read0 == [] -> Read = '[]' ; json_text(Read0, Read) )
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
        error_said(Status, Said, Object, Error),
        line_said(Job, result(Outcome, Status, Key, Usage, Paths, Said, Error),
                  Out),
        (   Outcome == failed
        ->  failure_said(Job, Object, Run)
        ;   true
        )
    ).

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

%!  folder_gone(+Folder) is det.
%
%   Folder is removed if that can be done.

folder_gone(Folder) :-
    catch(delete_directory_and_contents(Folder), error(_, _), true).

%!  ended_badly(+Job, +Key, +Folder, +Outcome, +Status, +What, +Usage, +Run,
%!              +Out) is det.
%
%   Job failed, and sanggwan(batch(What)) says why; Folder goes.

ended_badly(Job, Key, Folder, Outcome, Status, What, Usage, Run, Out) :-
    message_object(error, sanggwan(batch(What)), Object),
    failed_job(Job, Key, Folder, '[]',
               result(Outcome, Status, Key, Usage, [], '[]', Object), Run,
               Out).

%!  failed_by_error(+Job, +Key, +Error, +Run, +Out) is det.
%
%   Job failed by an Error of the batch itself, as of a full disk.

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
    (   option(keep_going(true), Options)
    ->  true
    ;   stop_begun
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
