:- module(sg_each,
          [ each_file/5                 % :Run, +Verb, +Files, +Options, -Status
          ]).
:- use_module('../batch/batch_report', [json_text/2]).
:- use_module('../message/message_object', [error_object/3, objects_heard/2]).
:- use_module('../output', [files_recorded/2, files_waiting/1]).
:- use_module('../plain', [plain_text/2]).
:- use_module('../studio/job', [worlds_collected/0]).
:- use_module('../studio/process_state', [with_process_kept/3]).
:- use_module(verb_output, [some_files/2, usage_error/1]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/3]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [member/2, reverse/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> Lists of files: the option --each, one result for each file.

Each file is done as by a command of its own: in an empty world, with its own
messages and files, which are there or not whatever becomes of the others. What
can be wrong with the list itself is found before anything is done.
*/

:- meta_predicate each_file(3, +, +, +, -).

%!  each_file(:Run, +Verb, +Files, +Options, -Status) is det.
%
%   For each of Files call(Run, File, Own, FileStatus), which says what is
%   wrong; Own are Options with the outputs of File, and places(Look), a goal to
%   be called before files take their places. Status is 0, or 5 if a FileStatus
%   was another, 2 if all are 2: what is wrong with an option is so for every
%   file. A FileStatus of 128 or more ends all, and is Status.
%
%   With json(true) what is printed is a line of JSON for each file.
%
%   @error usage_error(each(What)): standard_input, no_place(Option, Text),
%   same_output(Output, File1, File2), model_output(Output),
%   rules_remain(File); usage_error(no_files(_))

each_file(Run, Verb, Files, Options0, Status) :-
    some_files(Files, 'MODEL'),
    (   memberchk(-, Files)
    ->  usage_error(each(standard_input))
    ;   true
    ),
    exclude(of_the_list(Verb), Options0, Options),
    places_marked(Options),
    maplist(file_job(Options), Files, Jobs),
    outputs_apart(Jobs, Models, Taken),
    option(json(Json), Options0, false),
    jobs_done(Jobs, how(Run, Json, Models), Taken, [], Failed, Ended),
    (   nonvar(Ended)
    ->  Status = Ended
    ;   Failed == []
    ->  Status = 0
    ;   length(Files, Count),
        pairs_keys_values(Failed, Names, Statuses),
        length(Names, Bad),
        print_message(error, sanggwan(each_failed(Bad, Count, Names))),
        (   Bad =:= Count,
            sort(Statuses, [2])
        ->  Status = 2
        ;   Status = 5
        )
    ).

%   of_the_list(Verb, Option): it is not about a single file.

of_the_list(_, each(_)).
of_the_list(Verb, json(_)) :-
    memberchk(Verb, [draw,convert]).


                /*******************************
                *           OUTPUTS            *
                *******************************/

%   output_option(Option, Name, Texts): Option says where results go.

output_option(output(Texts), '--output', Texts).
output_option(table(Text), '--table', [Text]).

%   places_marked(Options): every output has the place of the file's name.

places_marked(Options) :-
    forall(( member(Option, Options),
             output_option(Option, Name, Texts),
             member(Text, Texts) ),
           (   sub_atom(Text, _, _, _, '%')
           ->  true
           ;   usage_error(each(no_place(Name, Text)))
           )).

%   file_job(Options, File, Job): Job is job(File, Own, Outputs).

file_job(Options0, File, job(File, Options, Outputs)) :-
    file_base_name(File, Base),
    file_name_extension(Name, _, Base),
    maplist(named_option(Name), Options0, Options),
    findall(Output,
            ( member(Option, Options),
              output_option(Option, _, Texts),
              member(Output, Texts) ),
            Outputs).

named_option(Name, output(Texts0), output(Texts)) :-
    !,
    maplist(named(Name), Texts0, Texts).
named_option(Name, table(Text0), table(Text)) :-
    !,
    named(Name, Text0, Text).
named_option(_, Option, Option).

named(Name, Text0, Text) :-
    atomic_list_concat(Parts, '%', Text0),
    atomic_list_concat(Parts, Name, Text).

%   outputs_apart(Jobs, Models, Taken): no result takes the place of another
%   one, or of a model that another result is made from. Models and Taken are
%   assocs of places with the File that is there or writes there.

outputs_apart(Jobs, Models, Taken) :-
    findall(Place-File, ( member(job(File, _, _), Jobs), place(File, Place) ),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Models),
    empty_assoc(None),
    foldl(job_apart(Models), Jobs, None, Taken).

job_apart(Models, job(File, _, Outputs), Taken0, Taken) :-
    foldl(output_apart(Models, File), Outputs, Taken0, Taken).

output_apart(Models, File, Output, Taken0, Taken) :-
    place(Output, Place),
    (   get_assoc(Place, Taken0, Other)
    ->  usage_error(each(same_output(Output, Other, File)))
    ;   not_of_another(Models, File, Output, Place),
        put_assoc(Place, Taken0, File, Taken)
    ).

not_of_another(Models, File, Output, Place) :-
    (   get_assoc(Place, Models, _),
        \+ place(File, Place)
    ->  usage_error(each(model_output(Output)))
    ;   true
    ).

place(File, Place) :-
    absolute_file_name(File, Place).

%   places_free(File, Models, Taken): the files that wait for their places, now
%   that their names are known: those of several solids and pages have numbers.

:- public places_free/3.

places_free(File, Models, Taken) :-
    files_waiting(Waiting),
    forall(member(Output, Waiting),
           ( place(Output, Place),
             (   get_assoc(Place, Taken, Other),
                 Other \== File
             ->  usage_error(each(same_output(Output, Other, File)))
             ;   not_of_another(Models, File, Output, Place)
             ) )).

taken_by(File, Output, Taken0, Taken) :-
    place(Output, Place),
    put_assoc(Place, Taken0, File, Taken).


                /*******************************
                *            FILES             *
                *******************************/

jobs_done([], _, _, Failed0, Failed, _) :-
    reverse(Failed0, Failed).
jobs_done([Job|Jobs], How, Taken0, Failed0, Failed, Ended) :-
    Job = job(File, _, _),
    job_done(Job, How, Taken0, Status, Written, Kept),
    (   Status >= 128
    ->  Ended = Status
    ;   ( Status =:= 0 -> Failed1 = Failed0 ; Failed1 = [File-Status|Failed0] ),
        (   Kept == false,
            Jobs \== []
        ->  usage_error(each(rules_remain(File)))
        ;   true
        ),
        foldl(taken_by(File), Written, Taken0, Taken),
        jobs_done(Jobs, How, Taken, Failed1, Failed, Ended)
    ).

job_done(job(File, Options, _), how(Run, Json, Models), Taken, Status,
         Written, Kept) :-
    rule_words(Options, Words),
    Look = sg_each:places_free(File, Models, Taken),
    with_process_kept(
        Words,
        files_recorded(
            objects_heard(
                with_output_to(string(Text),
                               call(Run, File, [places(Look)|Options],
                                    Status)),
                Objects),
            Written),
        Kept),
    worlds_collected,
    (   Status >= 128
    ->  true
    ;   Json == true
    ->  json_line(File, Status, Written, Objects, Text)
    ;   Text == ""
    ->  true
    ;   plain_text(File, Name),
        format("~s:~n~s", [Name, Text])
    ),
    flush_output.

rule_words(Options, Words) :-
    (   option(rules([_|_]), Options)
    ->  Words = ['--rules']
    ;   Words = []
    ).

%   json_line(File, Status, Written, Objects, Text): Text, what the verb
%   printed, is one value of JSON or nothing; its lines become one, as no text
%   in it goes over the end of a line.

json_line(File, Status, Written, Objects, Text) :-
    error_object(Status, Objects, Error),
    maplist(atom_string, [File|Written], [Name|Names]),
    maplist(json_text, [Name,Error], [FileText,ErrorText]),
    maplist(json_text, [Names,Objects], [FilesText,MessagesText]),
    split_string(Text, "\n", " \t", Lines),
    atomic_list_concat(Lines, Report0),
    (   Report0 == ''
    ->  Report = null
    ;   Report = Report0
    ),
    format('{"file":~w, "status":~d, "error":~w, "files":~w, \c
            "messages":~w, "report":~w}~n',
           [FileText, Status, ErrorText, FilesText, MessagesText, Report]).
