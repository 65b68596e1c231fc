:- module(sg_batch_en,
          [ manifest_en//1,             % +What
            batch_en//1,                % +What
            batch_usage_en//1           % +What
          ]).
:- use_module(message_parts, [counted//3, meant_en//1]).
:- use_module(library(lists), [member/2]).
/** <module> Batches: what is wrong with a manifest, what became of jobs, in
English.

batch_ko.pl has the same heads in Korean.
*/

%!  manifest_en(+What)// is det.
%
%   The message for model_error(manifest(What)).

manifest_en(fact(Term)) -->
    [ 'this is no fact of a manifest: ~p'-[Term], nl,
      '  Write defaults([Option, ...]) or \c
       job(Name, Verb, [File, ...], [Option, ...]).' ].
manifest_en(verb(Verb, Near, All)) -->
    { atomic_list_concat(All, ', ', Text) },
    [ 'no job can have the verb ~p'-[Verb] ],
    meant_en(Near),
    [ nl, '  A job is one of ~w.'-[Text] ].
manifest_en(name(Name)) -->
    [ '~p cannot be the name of a job'-[Name], nl,
      '  A name is a word, a number or a term such as hole(7), with a letter \c
       or a digit, and short enough for a file.' ].
manifest_en(files(Files)) -->
    [ 'these are no files of a job: ~p'-[Files], nl,
      '  Write a list such as [\'tee.pl\'], or glob(\'*.obj\'); standard \c
       input (-) is none.' ].
manifest_en(missing(File)) -->
    [ 'there is no file ~w'-[File], nl,
      '  Names are those in the folder of the manifest.' ].
manifest_en(option(Term)) -->
    [ '~p is no option of a job'-[Term], nl,
      '  Write the long options of the verb as terms: view(30, 60) for \c
       --view 30,60, no_frame for --no-frame, output(\'%.svg\'), set(r, 7).' ].
manifest_en(options(Term)) -->
    [ 'these are no options: ~p'-[Term], nl,
      '  Write a list, such as [view(isometric), output(\'%.svg\')].' ].
manifest_en(no_default(Name)) -->
    [ 'no verb has an option --~w'-[Name], nl,
      '  Defaults are options of verbs, time_limit(Seconds), \c
       memory(Megabytes) and cpu(Seconds).' ].
manifest_en(output(Pattern)) -->
    [ '~w is no name for the files of a job'-[Pattern], nl,
      '  Write % once, in the last part, where the name of the job is to be: \c
       output(\'%.svg\'), output(\'plans/%.pdf\').' ].
manifest_en(no_output(Verb)) -->
    [ 'a job of ~w writes files, and this one says none'-[Verb], nl,
      '  Give it output(\'%.ENDING\'), or all jobs by defaults([...]).' ].
manifest_en(ending(Pattern, Formats)) -->
    { atomic_list_concat(Formats, ' .', Text) },
    [ '~w: the verb writes no such files'-[Pattern], nl,
      '  The ending is one of .~w.'-[Text] ].
manifest_en(folder_too(Name, Path)) -->
    [ 'the job ~w would make the file ~w, and others a folder of that name'-
      [Name, Path], nl,
      '  Give the folder another name in output(\'FOLDER/%.ENDING\').' ].
manifest_en(limit(Term)) -->
    [ '~p is no limit of a job'-[Term], nl,
      '  Seconds are above 0, megabytes of memory 50 or more.' ].
manifest_en(unbound(Name)) -->
    [ 'nothing says what ~w is'-[Name], nl,
      '  Write job(...) @ ~w in 1..100, or another generator; it stands \c
       before what uses it.'-[Name] ].
manifest_en(bound_twice(Name)) -->
    [ 'two generators say what ~w is'-[Name], nl,
      '  Give the second one another variable.' ].
manifest_en(generator(Text)) -->
    [ 'this is no generator: ~w'-[Text], nl,
      '  Write R in 1..100, R in between(1, 2, 0.5), R in [a, b], \c
       F in glob(\'*.obj\') or [R, H] in rows(\'sizes.csv\', [r, h]).' ].
manifest_en(range(Source)) -->
    [ 'the ends of ~w are no whole numbers'-[Source], nl,
      '  For others write between(1, 2, 0.5).' ].
manifest_en(steps(Step)) -->
    [ 'a step of ~p leads nowhere'-[Step], nl,
      '  Write a number above 0.' ].
manifest_en(glob(Pattern)) -->
    [ 'no file is like ~w'-[Pattern], nl,
      '  Names are those in the folder of the manifest.' ].
manifest_en(rows(File, _, missing)) -->
    [ 'there is no table ~w'-[File], nl,
      '  Names are those in the folder of the manifest.' ].
manifest_en(rows(File, Line, no_table)) -->
    [ '~w:~d: this is no row of a table'-[File, Line], nl,
      '  The first line has the names of the columns, with commas between \c
       them.' ].
manifest_en(rows(File, Line, not_utf8)) -->
    [ '~w:~d: there are bytes that are not UTF-8'-[File, Line], nl,
      '  Save the table as UTF-8.' ].
manifest_en(rows(File, Line, width(N, Wanted))) -->
    [ '~w:~d: the row has '-[File, Line] ],
    counted(N, value, values),
    [ ', the first line ~d'-[Wanted], nl,
      '  A value with a comma in it stands in quotes.' ].
manifest_en(rows(File, _, no_column(Column, Known))) -->
    { atomic_list_concat(Known, ', ', All) },
    [ '~w has no column ~w'-[File, Column], nl,
      '  Its first line has ~w.'-[All] ].
manifest_en(json(_)) -->
    [ 'this is no object of JSON', nl,
      '  Write one on each line: \c
       {"job":"tee", "verb":"draw", "files":["tee.pl"], \c
       "options":{"output":"%.svg"}}.' ].
manifest_en(no_key(Key)) -->
    [ 'the object has no "~w"'-[Key], nl,
      '  A job has "job", "verb", "files" and "options".' ].
manifest_en(key(Key, Keys)) -->
    { atomic_list_concat(Keys, ', ', All) },
    [ '"~w" means nothing here'-[Key], nl,
      '  An object of a manifest has ~w.'-[All] ].
manifest_en(twice(Name, Name, _)) -->
    !,
    [ 'two jobs have the name ~w'-[Name], nl,
      '  Give each another one; that of a template should have all of its \c
       variables.' ].
manifest_en(twice(Name, Older, Path)) -->
    [ 'the jobs ~w and ~w would both make ~w'-[Older, Name, Path], nl,
      '  Of names files keep letters, digits, dots, - and _ alone; give one \c
       another name.' ].
manifest_en(no_jobs) -->
    [ 'there is no job in the manifest', nl,
      '  Write job(Name, Verb, [File, ...], [Option, ...]).' ].
manifest_en(no_report) -->
    [ 'this is no line of a report of a batch', nl,
      '  Name files that batch --report has written.' ].

%!  batch_en(+What)// is det.
%
%   The message for sanggwan(batch(What)).

batch_en(summary(Pairs)) -->
    { findall(Text,
              ( member(Outcome-N, Pairs),
                N > 0,
                outcome_en(Outcome, Word),
                format(atom(Text), '~D ~w', [N, Word]) ),
              Texts),
      ( Texts == [] -> All = 'no job' ; atomic_list_concat(Texts, ', ', All) )
    },
    [ '~w'-[All] ].
batch_en(failed(Name, Why)) -->
    [ 'job ~w: ~w'-[Name, Why] ].
batch_en(no) -->
    [ 'the answer is no' ].
batch_en(cut_line(File, Line)) -->
    [ '~w:~d: the line is cut off and not counted'-[File, Line] ].
batch_en(looked_at(Count)) -->
    [ '~D jobs looked at'-[Count] ].
batch_en(sorted(Count)) -->
    [ '~D jobs looked at; now: does any name stand there twice?'-[Count] ].
batch_en(timeout(Seconds)) -->
    [ 'not done in ~w seconds'-[Seconds], nl,
      '  Give it more with time_limit(Seconds) in the manifest.' ].
batch_en(ended(killed(Signal))) -->
    [ 'the process that did it was ended by signal ~w'-[Signal], nl,
      '  9 may come of a machine without memory, 24 of cpu(Seconds) in the \c
       manifest.' ].
batch_en(ended(exit(Status))) -->
    [ 'the process that did it ended with status ~w'-[Status], nl,
      '  Run the job alone, with its command, to see why.' ].
batch_en(changed) -->
    [ 'a file that it reads was changed meanwhile', nl,
      '  Run the batch again.' ].

outcome_en(done, done).
outcome_en(cached, cached).
outcome_en(failed, failed).
outcome_en(timeout, 'out of time').
outcome_en(killed, 'ended by force').

%!  batch_usage_en(+What)// is det.
%
%   The message for usage_error(batch(What)).

batch_usage_en(no_job(Name)) -->
    [ 'there is no job ~w'-[Name], nl,
      '  sanggwan batch MANIFEST --list prints the names.' ].
batch_usage_en(one_manifest(File)) -->
    [ 'a batch has one manifest; ~w is a second one'-[File] ].
batch_usage_en(no_folder(File)) -->
    [ 'results of a batch cannot go to ~w'-[File], nl,
      '  Give -o FOLDER.' ].
batch_usage_en(no_out) -->
    [ 'where should the results go? Give -o FOLDER' ].
batch_usage_en(no_slurm) -->
    [ '--shard slurm is for tasks of a job array of Slurm', nl,
      '  Its script has #SBATCH --array=1-64; else write --shard I/N.' ].
batch_usage_en(slurm_list) -->
    [ 'the array of Slurm is a list with gaps', nl,
      '  Write a range: #SBATCH --array=1-64; to do one part again, \c
       --shard I/N.' ].
