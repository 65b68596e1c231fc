:- module(sg_verbs_batch,
          [ batch_run_verb/3            % +Files, +Options, -Status
          ]).
:- use_module('../environment', [environment/2]).
:- use_module(arguments, [parsed_arguments/4]).
:- use_module('../batch/batch_merge', [reports_merged/2]).
:- use_module('../batch/runner', [batch_run/4]).
:- use_module('../model/parameter', [settings_of/2]).
:- use_module('../problem/problem_sheet', [problem_sheets/3]).
:- use_module('../version', [version/1]).
:- use_module(sheet_options, [view_told/2]).
:- use_module(usage, [job_options/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(library(apply), [convlist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The verb batch: its options, checked, for rules/batch/.
*/

%!  batch_run_verb(+Files, +Options, -Status) is det.
%
%   Files is one manifest; with --merge it is reports.

batch_run_verb(Files, Options, Status) :-
    option(output(Outs), Options, []),
    (   option(sheets(true), Options)
    ->  no_option('--sheets', Options,
                  [merge,shard,only,list,resume,'keep-going',report,copy]),
        one_file(Files, File),
        out_folder(Options, Outs, [out(Folder)]),
        problem_sheets(File, Folder, Options),
        Status = 0
    ;   member(Option, [format(_),angle(_),language(_)]),
        option(Option, Options)
    ->  usage_error(needs_one_of(['--sheets']))
    ;   option(merge(true), Options)
    ->  no_option('--merge', Options,
                  [jobs,shard,only,list,resume,'keep-going',report,copy]),
        (   Files == []
        ->  usage_error(no_files('REPORT'))
        ;   Outs == []
        ->  usage_error(no_output)
        ;   reports_merged(Files, Outs),
            Status = 0
        )
    ;   one_file(Files, File),
        out_folder(Options, Outs, Own0),
        convlist(batch_option(Options), [jobs,shard,only,list,resume,
                                         'keep-going',report,copy,quiet],
                 Own1),
        append(Own0, Own1, Own),
        version(Version),
        findall(Word, given_word(Options, Word), Words),
        batch_run(File, [version(Version)|Own],
                  tools(sg_usage:job_options, sg_verbs_batch:job_arguments,
                        Words),
                  Status)
    ).

%   job_arguments(Specs, Words, Files, Options): as parsed_arguments/4; what can
%   be told of views and of values of parameters without a model is right.

:- public job_arguments/4.

job_arguments(Specs, Words, Files, Options) :-
    parsed_arguments(Specs, Words, Files, Options),
    (   memberchk(option(direction, _, _, _, _), Specs),
        option(view(Text), Options)
    ->  view_told(Text, _)
    ;   true
    ),
    (   option(set(Texts), Options)
    ->  settings_of([set(Texts)], _)
    ;   true
    ).

one_file([], _) :-
    !,
    usage_error(no_files('MANIFEST')).
one_file([File], File) :-
    !.
one_file([_,File|_], _) :-
    usage_error(batch(one_manifest(File))).

no_option(Given, Options, Names) :-
    (   member(Name, Names),
        Option =.. [Name, _],
        option(Option, Options)
    ->  atom_concat(--, Name, Text),
        usage_error(both_options(Given, Text))
    ;   true
    ).

out_folder(Options, Outs, Own) :-
    (   Outs = [Out]
    ->  (   Out == (-)
        ->  usage_error(batch(no_folder(Out)))
        ;   Own = [out(Out)]
        )
    ;   Outs = [_,_|_]
    ->  usage_error(option_twice('--output'))
    ;   option(list(true), Options)
    ->  Own = []
    ;   usage_error(batch(no_out))
    ).

%   batch_option(Options, Name, Option): Option for the runner.

batch_option(Options, jobs, workers(N)) :-
    (   option(jobs(N0), Options)
    ->  N = N0
    ;   current_prolog_flag(cpu_count, N)
    ).
batch_option(Options, shard, shard(I, N)) :-
    option(shard(Text), Options),
    shard_of(Text, I, N).
batch_option(Options, only, only(Names)) :-
    option(only(Names), Options).
batch_option(Options, list, list(true)) :-
    option(list(true), Options).
batch_option(Options, resume, resume(true)) :-
    option(resume(true), Options).
batch_option(Options, 'keep-going', keep_going(true)) :-
    option('keep-going'(true), Options).
batch_option(Options, report, report(File)) :-
    option(report(File), Options).
batch_option(Options, copy, copy(true)) :-
    option(copy(true), Options).
batch_option(Options, quiet, quiet(true)) :-
    option(quiet(true), Options).

%   given_word(Options, Pair): what every job gets.

given_word(Options, Name-Value) :-
    member(Name, [limits,set,rules,strict]),
    Option =.. [Name, Value0],
    option(Option, Options),
    (   is_list(Value0)
    ->  member(Value1, Value0)
    ;   Value1 = Value0
    ),
    Value1 \== false,
    (   Name == rules,                  % a job runs in the manifest's folder
        atom(Value1)
    ->  absolute_file_name(Value1, Value)
    ;   Value = Value1
    ).

%   shard_of(Text, I, N): I/N, or what Slurm says of a job array.

shard_of(slurm, I, N) :-
    !,
    (   slurm(id, Id),
        slurm(min, Min),
        slurm(max, Max),
        slurm(step, Step),
        slurm(count, N)
    ->  (   Max =:= Min + (N-1)*Step
        ->  I is (Id-Min)//Step + 1
        ;   usage_error(batch(slurm_list))
        )
    ;   usage_error(batch(no_slurm))
    ).
shard_of(Text, I, N) :-
    (   atomic_list_concat([IText, NText], /, Text),
        catch(( atom_number(IText, I), atom_number(NText, N) ), error(_, _),
              fail),
        integer(I),
        integer(N),
        I >= 1,
        I =< N
    ->  true
    ;   usage_error(bad_value('--shard', Text, 'I/N'))
    ).

%   slurm(What, N): of a task of a job array; the step is 1 if nothing says it.

slurm(What, N) :-
    slurm_variable(What, Variable, Default),
    (   environment(Variable, Text)
    ->  atom_number(Text, N)
    ;   N = Default
    ),
    integer(N).

slurm_variable(id, 'SLURM_ARRAY_TASK_ID', none).
slurm_variable(min, 'SLURM_ARRAY_TASK_MIN', none).
slurm_variable(max, 'SLURM_ARRAY_TASK_MAX', none).
slurm_variable(step, 'SLURM_ARRAY_TASK_STEP', 1).
slurm_variable(count, 'SLURM_ARRAY_TASK_COUNT', none).
