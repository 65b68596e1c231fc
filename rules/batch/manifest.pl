:- module(sg_manifest,
          [ with_manifest/4,            % +File, +Tools, -Manifest, :Goal
            manifest_folder/2,          % +Manifest, -Folder
            manifest_job/3,             % +Manifest, +Checked, -Job
            batch_verb/1                % ?Verb
          ]).
:- use_module('../generator', [conjuncts/2, generator_fault/3, generated/2]).
:- use_module(job_name, [name_text/2, file_stem/2, output_fault/2]).
:- use_module(job_words,
              [ option_pairs/2, json_pairs/2, parted_pairs/3, limit_fault/2,
                options_over/4, option_words/3, output_file/3, input_option/2,
                text_of/2
              ]).
:- use_module('../model/model_text',
              [next_term/5, no_fact/2, place_error/2, place_error/3]).
:- use_module('../json_value', [json_value/2]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../text_file', [with_text/4]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(readutil), [read_line_to_string/2]).
/** <module> Manifests: what a batch is to do, read as data, never run.

A manifest is a file of facts, or of JSON, one object a line (`.jsonl`,
`.ndjson`; standard input if it begins with `{`):

    defaults([time_limit(60), output('%.svg')]).
    job(tee, draw, ['tee.pl'], [view(isometric)]).
    job(hole(R), draw, ['plate.pl'], [set(r, R)]) @ R in 1..100.
    job(all, union, glob('ball*.obj'), [output('%.stl')]).

    {"defaults":{"time_limit":60}}
    {"job":"tee","verb":"draw","files":["tee.pl"],"options":{"view":"iso"}}

Defaults are those of the jobs after them. Names of files are those in the
folder of the manifest. job_words.pl has the options, generator.pl what may
stand behind `@`.

A job is job(Number, Name, Stem, Verb, Files, Options, Limits, Place): Number
counts from 1, Name is its name as text, Stem what its files are called, Options
are Name-Value, Limits as well.

Every error is model_error(manifest(What)) with its place; What is fact(Term),
verb(Verb, Near, All), name(Name), files(Files), missing(File),
option(Term), options(Term), usage(What), no_default(Name), output(Pattern),
no_output(Verb), ending(Pattern, Formats), limit(Term), unbound(Name),
bound_twice(Name), generator(Text), range(Source), steps(Step), glob(Pattern),
rows(File, Line, Why), json(Text), no_key(Key) or key(Key, Keys).
*/

:- meta_predicate with_manifest(+, +, -, 0).

%   The operators of manifests, in a module of their own.

:- set_module(sg_manifest_syntax:base(system)).
:- set_prolog_flag(sg_manifest_syntax:double_quotes, string).
:- op(1150, xfx, sg_manifest_syntax:(@)).
:- op(700, xfx, sg_manifest_syntax:in).
:- op(450, xfx, sg_manifest_syntax:(..)).

%!  batch_verb(?Verb) is nondet.
%
%   Verb may be that of a job.

batch_verb(Verb) :-
    member(Verb, [ check, cells, glue, unglue, convert, penetrate, draw, render,
                   union, intersection, difference, split, eval, unfold, query,
                   explain ]).

%!  with_manifest(+File, +Tools, -Manifest, :Goal) is semidet.
%
%   Call Goal once with Manifest, that in File; `-` is standard input. Tools is
%   tools(Specs, Parse, Words): call(Specs, Verb, Options) gives the options of
%   a verb, call(Parse, Options, Words, Files, _) reads words as they are on a
%   command line, Words are options, Name-Value, of every job.
%
%   @error model_error(cannot_read(Why)), model_error(limit(Name, Most))

with_manifest(File, Tools, Manifest, Goal) :-
    manifest_form(File, Form, Kind),
    (   File == (-)
    ->  Folder = '.'
    ;   file_directory_name(File, Folder)
    ),
    with_text(Kind, File, Text,
              sg_manifest:with_text_manifest(Text, Form, Folder, Tools,
                                             Manifest, Goal)).

:- public with_text_manifest/6.

with_text_manifest(text(Name, Path, _), Form, Folder, Tools, Manifest, Goal) :-
    Manifest = manifest(Name, Path, Form, Folder, Tools),
    once(Goal).

manifest_form(-, Form, Kind) :-
    !,
    (   peek_char(user_input, '{')
    ->  Form = json,
        Kind = lines
    ;   Form = facts,
        Kind = facts
    ).
manifest_form(File, Form, Kind) :-
    file_name_extension(_, Ending, File),
    (   memberchk(Ending, [jsonl,ndjson,json])
    ->  Form = json,
        Kind = lines
    ;   Form = facts,
        Kind = facts
    ).

%!  manifest_folder(+Manifest, -Folder) is det.
%
%   The names of files in Manifest are those in Folder.

manifest_folder(manifest(_, _, _, Folder, _), Folder).

%!  manifest_job(+Manifest, +Checked, -Job) is nondet.
%
%   Job is a job of Manifest, in its order; none is made before it is asked for.
%   If Checked is `true`, options of jobs are looked up in the tables of their
%   verbs, and that their files are there.
%
%   @error model_error(manifest(What)) with location(File, Line, Column)

manifest_job(Manifest, Checked, Job) :-
    Manifest = manifest(_, Path, _, _, tools(_, _, Given)),
    first_defaults(Given, Defaults),
    State = state(0, Defaults, none),
    setup_call_cleanup(
        open(Path, read, In, [encoding(utf8)]),
        ( manifest_entry(Manifest, In, Entry, Place),
          entry_job(Entry, Place, Manifest, Checked, State, Job) ),
        close(In)).

%   A State is state(Number, Defaults, Before): the Number of the last job, the
%   defaults from here on, and checked(Verb, Files, Options) of the job checked
%   last.

%   manifest_entry(Manifest, In, Entry, Place) is nondet: Entry is
%   entry(Term, Names).

manifest_entry(manifest(Name, Path, Form, _, _), In, Entry, Place) :-
    repeat,
    next_entry(Form, text(Name, Path, In), Entry0, Place),
    (   Entry0 == end_of_file
    ->  !,
        fail
    ;   Entry = Entry0
    ).

next_entry(facts, Text, Entry, Place) :-
    next_term(Text, sg_manifest_syntax, Term, Names, Place),
    (   Term == end_of_file
    ->  Entry = end_of_file
    ;   Entry = entry(Term, Names)
    ).
next_entry(json, Text, Entry, Place) :-
    next_object(Text, Entry, Place).

%   next_object(Text, Entry, Place): a line of JSON; empty ones say nothing.

next_object(Text, Entry, Place) :-
    Text = text(Name, _, In),
    line_count(In, Line),
    read_line_to_string(In, String),
    (   String \== end_of_file,
        split_string(String, "", " \t\r\uFEFF", [""])
    ->  next_object(Text, Entry, Place)
    ;   Place = line(Name, Line),
        object_of_line(String, Place, Entry)
    ).

object_of_line(String, Place, Entry) :-
    (   String == end_of_file
    ->  Entry = end_of_file
    ;   json_value(String, Dict),
        is_dict(Dict)
    ->  Entry = json(Dict)
    ;   entry_error(Place, json(String))
    ).

%   entry_error(Place, What), or of its Argument.

entry_error(Place, What) :-
    entry_error(Place, 0, What).

entry_error(Place, Argument, What) :-
    (   What = limit(_, _)
    ->  Fault = What
    ;   Fault = manifest(What)
    ),
    fault_at(Place, Argument, Fault).

fault_at(line(Name, Line), _, Fault) :-
    !,
    throw(error(model_error(Fault), location(Name, Line, 1))).
fault_at(Place, 0, Fault) :-
    !,
    place_error(Place, Fault).
fault_at(Place, Argument, Fault) :-
    place_error(Place, Argument, Fault).


                /*******************************
                *            FACTS             *
                *******************************/

%   entry_job(Entry, Place, Manifest, Checked, State, Job) is nondet.

entry_job(json(Dict), Place, Manifest, Checked, State, Job) :-
    object_job(Dict, Place, Manifest, Checked, State, Job).
entry_job(entry(Term, Names), Place, Manifest, Checked, State, Job) :-
    (   compound(Term),
        Term = defaults(Terms)
    ->  located(Place, 1, option_pairs(Terms, Pairs)),
        defaults_set(Pairs, Place, Manifest, State),
        fail
    ;   compound(Term),
        Term = @(Head, Conjunction)
    ->  template_job(Head, Conjunction, Names, Place, Manifest, Checked, State,
                     Job)
    ;   term_variables(Term, [V|_]),
        compound_head(Term)
    ->  variable_name(V, Names, Name),
        entry_error(Place, unbound(Name))
    ;   fact_job(Term, Place, Manifest, Checked, State, Job)
    ).

compound_head(Term) :-
    compound(Term),
    Term = job(_, _, _, _).

variable_name(V, Names, Name) :-
    (   member(Name0=V0, Names),
        V0 == V
    ->  Name = Name0
    ;   Name = '_'
    ).

template_job(Head, Conjunction, Names, Place, Manifest, Checked, State, Job) :-
    conjuncts(Conjunction, Generators),
    (   generator_fault(Generators, Head, Fault)
    ->  template_error(Fault, Names, Place)
    ;   true
    ),
    manifest_folder(Manifest, Folder),
    catch_generator(generated(Generators, Folder), Place),
    fact_job(Head, Place, Manifest, Checked, State, Job).

template_error(unbound(V), Names, Place) :-
    variable_name(V, Names, Name),
    entry_error(Place, unbound(Name)).
template_error(bound_twice(V), Names, Place) :-
    variable_name(V, Names, Name),
    entry_error(Place, bound_twice(Name)).
template_error(generator(G), Names, Place) :-
    maplist(variable_named, Names),
    numbervars(G, 0, _, [singletons(true)]),
    source_text(G, Text),
    entry_error(Place, generator(Text)).

variable_named(Name=V) :-
    (   var(V)
    ->  V = '$VAR'(Name)
    ;   true
    ).

source_text(Source, Text) :-
    format(atom(Text), '~@',
           [ write_term(Source, [ module(sg_manifest_syntax), quoted(true),
                                  numbervars(true), spacing(next_argument) ])
           ]).

%   catch_generator(Goal, Place) is nondet.

catch_generator(Goal, Place) :-
    catch(Goal, generator_error(What), generator_failed(What, Place)).

generator_failed(What, Place) :-
    (   What = range(Source)
    ->  source_text(Source, Text),
        entry_error(Place, range(Text))
    ;   What = limit(_, _, _)
    ->  place_error(Place, What)
    ;   entry_error(Place, What)
    ).

%   Goal, or the error of its Argument.

:- meta_predicate located(+, +, 0), catch_generator(0, +).

located(Place, Argument, Goal) :-
    catch(Goal, job_error(What), entry_error(Place, Argument, What)),
    !.

fact_job(Term, Place, Manifest, Checked, State, Job) :-
    (   compound(Term),
        Term = job(Name, Verb, Files, Terms)
    ->  located(Place, 4, option_pairs(Terms, Pairs)),
        made_job(Name, Verb, Files, Pairs, Place, Manifest, Checked, State, Job)
    ;   no_fact(Term, What),
        memberchk(What, [no_fact(_),directive(_),rule(_)])
    ->  place_error(Place, What)
    ;   entry_error(Place, fact(Term))
    ).

%   made_job(Name, Verb, Files, Pairs, Place, Manifest, Checked, State, Job)

made_job(Name, Verb, Files0, Pairs, Place, Manifest, Checked, State, Job) :-
    Manifest = manifest(_, _, _, Folder, Tools),
    (   (   string(Name)
        ->  atom_string(Text, Name)
        ;   name_text(Name, Text)
        ),
        file_stem(Text, Stem)
    ->  true
    ;   entry_error(Place, 1, name(Name))
    ),
    verb_specs(Verb, Tools, Place, Specs),
    job_files(Files0, Folder, Place, Files),
    parted_pairs(Pairs, OwnLimits, Own),
    maplist(limit_checked(Place, 4), OwnLimits),
    arg(2, State, defaults(Limits0, Defaults)),
    options_over(OwnLimits, Limits0, any, Limits),
    options_over(Own, Defaults, Specs, Options),
    job_checked(Checked, Verb, Files, Options, Specs, Manifest, State, Place),
    arg(1, State, Last),
    Number is Last+1,
    nb_setarg(1, State, Number),
    Job = job(Number, Text, Stem, Verb, Files, Options, Limits, Place).

:- dynamic specs/2.                     % Verb, Specs

verb_specs(Verb, tools(Options, _, _), Place, Specs) :-
    (   specs(Verb, Specs0)
    ->  Specs = Specs0
    ;   atom(Verb),
        batch_verb(Verb)
    ->  call(Options, Verb, Specs),
        assertz(specs(Verb, Specs))
    ;   findall(Known, batch_verb(Known), All),
        (   atom(Verb)
        ->  near_words(Verb, All, Near)
        ;   Near = []
        ),
        entry_error(Place, 2, verb(Verb, Near, All))
    ).

limit_checked(Place, Argument, Limit) :-
    (   limit_fault(Limit, Fault)
    ->  entry_error(Place, Argument, Fault)
    ;   true
    ).

%   job_files(Files0, Folder, Place, Files): names as on a command line.

job_files(glob(Pattern), Folder, Place, Files) :-
    !,
    findall(File,
            catch_generator(generated([in(File, glob(Pattern))], Folder),
                            Place),
            Files).
job_files(Files0, _, Place, Files) :-
    (   is_list(Files0),
        maplist(file_name, Files0, Files)
    ->  true
    ;   entry_error(Place, 3, files(Files0))
    ).

file_name(Text, File) :-
    (   string(Text)
    ->  atom_string(File, Text)
    ;   atom(Text),
        Text \== [],
        File = Text
    ),
    \+ memberchk(File, ['', -]),
    \+ sub_atom(File, 0, 1, _, -).


                /*******************************
                *           DEFAULTS           *
                *******************************/

first_defaults(Words, defaults(Limits, Options)) :-
    parted_pairs(Words, Limits, Options).

%   defaults_set(Pairs, Place, Manifest, State): each replaces an older one of
%   its name.

defaults_set(Pairs, Place, manifest(_, _, _, _, Tools), State) :-
    parted_pairs(Pairs, Limits, Options),
    maplist(limit_checked(Place, 1), Limits),
    forall(member(Option, Options), default_checked(Option, Tools, Place)),
    arg(2, State, defaults(Limits0, Options0)),
    options_over(Limits, Limits0, any, Limits1),
    options_over(Options, Options0, any, Options1),
    nb_setarg(2, State, defaults(Limits1, Options1)).

%   default_checked(Option, Tools, Place): some verb has it, and so it is right
%   there.

default_checked(Option, Tools, Place) :-
    Tools = tools(_, Parse, _),
    option_checked(Option, Place, 1),
    (   batch_verb(Verb),
        verb_specs(Verb, Tools, Place, Specs),
        options_over([], [Option], Specs, [_])
    ->  words_parsed([Option], Specs, Parse, Place, 1)
    ;   Option = Name-_,
        entry_error(Place, 1, no_default(Name))
    ).


                /*******************************
                *             JSON             *
                *******************************/

object_job(Dict, Place, Manifest, Checked, State, Job) :-
    dict_keys_known(Dict, Place),
    (   get_dict(defaults, Dict, Defaults)
    ->  located(Place, 1, json_pairs(Defaults, Pairs)),
        defaults_set(Pairs, Place, Manifest, State),
        fail
    ;   dict_value(job, Dict, Place, Name0),
        dict_value(verb, Dict, Place, Verb0),
        dict_value(files, Dict, Place, Files),
        (   get_dict(options, Dict, Options)
        ->  located(Place, 4, json_pairs(Options, Pairs))
        ;   Pairs = []
        ),
        (   string(Name0)
        ->  Name = Name0
        ;   number(Name0)
        ->  format(string(Name), '~w', [Name0])
        ;   Name = Name0
        ),
        (   string(Verb0)
        ->  atom_string(Verb, Verb0)
        ;   Verb = Verb0
        ),
        made_job(Name, Verb, Files, Pairs, Place, Manifest, Checked, State,
                 Job)
    ).

dict_keys_known(Dict, Place) :-
    Keys = [job, verb, files, options, defaults],
    (   get_dict(Key, Dict, _),
        \+ memberchk(Key, Keys)
    ->  entry_error(Place, key(Key, Keys))
    ;   true
    ).

dict_value(Key, Dict, Place, Value) :-
    (   get_dict(Key, Dict, Value0)
    ->  Value = Value0
    ;   entry_error(Place, no_key(Key))
    ).


                /*******************************
                *            CHECKS            *
                *******************************/

%   job_checked(Checked, Verb, Files, Options, Specs, Manifest, State, Place):
%   what is as in the job before is right.

job_checked(false, _, _, _, _, _, _, _).
job_checked(true, Verb, Files, Options, Specs, Manifest, State, Place) :-
    Manifest = manifest(_, _, _, Folder, tools(_, Parse, _)),
    arg(3, State, Before),
    (   Before = checked(Verb, Files, _)
    ->  true
    ;   model_files(Verb, Files, Models),
        forall(member(File, Models), file_checked(File, Folder, Place))
    ),
    (   Before = checked(Verb, _, Old),
        maplist(same_name, Old, Options)
    ->  changed(Old, Options, Changed)
    ;   Changed = Options
    ),
    (   Changed == []
    ->  true
    ;   forall(member(Option, Changed),
               ( option_checked(Option, Place, 4),
                 option_file_checked(Verb, Option, Folder, Place),
                 ending_checked(Option, Specs, Place) )),
        words_parsed(Changed, Specs, Parse, Place, 4)
    ),
    nb_setarg(3, State, checked(Verb, Files, Options)),
    output_there(Verb, Options, Place).

same_name(Name-_, Name-_).

changed([], [], []).
changed([Old|Olds], [New|News], Changed) :-
    (   Old == New
    ->  Changed = Changed1
    ;   Changed = [New|Changed1]
    ),
    changed(Olds, News, Changed1).

%   model_files(Verb, Files, Models): the last word of query and explain is a
%   text.

model_files(Verb, Files, Models) :-
    (   memberchk(Verb, [query,explain]),
        append(Models0, [_], Files)
    ->  Models = Models0
    ;   Models = Files
    ).

file_checked(File, Folder, Place) :-
    (   is_absolute_file_name(File)
    ->  Path = File
    ;   atomic_list_concat([Folder, /, File], Path)
    ),
    (   exists_file(Path)
    ->  true
    ;   entry_error(Place, 3, missing(File))
    ).

option_file_checked(Verb, Name-File, Folder, Place) :-
    (   input_option(Verb, Name)
    ->  file_checked(File, Folder, Place)
    ;   true
    ).

%   output_there(Verb, Options, Place): a verb that only writes has where to.

output_there(Verb, Options, Place) :-
    (   memberchk(Verb, [draw,convert,render,unglue]),
        \+ memberchk(output-_, Options)
    ->  entry_error(Place, 4, no_output(Verb))
    ;   true
    ).

%   ending_checked(Option, Specs, Place): the verb with Specs writes files with
%   such an ending, as --format has them; tables are CSV.

ending_checked(Name-Pattern, Specs, Place) :-
    (   ending_formats(Name, Specs, Formats),
        file_name_extension(_, Ending, Pattern),
        downcase_atom(Ending, Format),
        \+ memberchk(Format, Formats)
    ->  entry_error(Place, 4, ending(Pattern, Formats))
    ;   true
    ).

ending_formats(output, Specs, Formats) :-
    memberchk(option(format, _, one_of(Formats), _, _), Specs).
ending_formats(table, _, [csv]).
ending_formats(spans, _, [csv]).

%   option_checked(Option, Place, Argument): what a job may not have, and where
%   its files go.

option_checked(Name-Value, Place, Argument) :-
    (   memberchk(Name, [help,from])
    ->  entry_error(Place, Argument, option(Name))
    ;   output_file(Name-Value, _, Pattern),
        output_fault(Pattern, Fault)
    ->  entry_error(Place, Argument, Fault)
    ;   true
    ).

%   words_parsed(Options, Specs, Parse, Place, Argument): they are options of a
%   verb with those Specs.

words_parsed(Options, Specs, Parse, Place, Argument) :-
    option_words(Options, '.', Words),
    catch(call(Parse, Specs, Words, _, _), error(usage_error(What), _),
          entry_error(Place, Argument, usage(What))).
