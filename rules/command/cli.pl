:- encoding(utf8).
:- module(sg_cli,
          [ main/1,                     % -Status
            interrupted_words/2,        % -Text, -Verb
            sanggwan/2                  % +Arguments, -Status
          ]).
:- use_module(arguments, [parsed_arguments/4]).
:- use_module(each, [each_file/5]).
:- use_module('../solid/csg_evaluate',
              [csg_statistics/1, csg_statistics_reset/0]).
:- use_module('../decision', [no_rules/0, use_rules/1]).
:- use_module('../kernel',
              [exact_fallbacks/1, exact_statistics/1, tree_statistics/1]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../language',
              [interrupted_word/2, language/1, language_of_environment/0]).
:- use_module('../limits', [limit_value/2, set_limit/2]).
:- use_module('../message/message_object', [message_said/2]).
:- use_module('../message/messages', []).
:- use_module('../message/messages_ko', []).
:- use_module('../model/item_where', [error_placed/2]).
:- use_module('../output', [files_together/1, output_waiting/0]).
:- use_module('../message/spoken',
              [loading_place/2, silent_warning/2, spoken_lines/4]).
:- use_module('../part', [loaded_rule/2, whole_program/0]).
:- use_module('../progress', [with_progress/1]).
:- use_module('../model/solid_file', [output_statistics/1]).
:- use_module('../penetration/resolve', [refusing_moves/1]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../stage', [stages_reset/0, stage_name/1, stage_seconds/2]).
:- use_module('../status', [error_status/2]).
:- use_module('../store', [in_passing_world/1, facts_statistics/2]).
:- use_module(format_options, [format_options_told/3]).
:- use_module(usage, [verb/4, verb_options/2]).
:- use_module(usage_print, [print_usage/1, print_usage/2]).
:- use_module(user:'../sanggwan').
:- use_module(user:'../rows').
:- use_module(user:'../topology').
:- use_module(user:'../spans').
:- use_module(user:help, [help/0, help/1]).
:- use_module('../studio/front', [front/3]).
:- use_module(verb_session, [serve_run/3]).
:- use_module(verbs, [verb_run/4, item_explained_there/3]).
:- use_module('../version', [version/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(http/json), [json_write_dict/3]).
:- use_module(library(lists), [append/3, clumped/2, member/2, sum_list/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> The command line: verbs, exit status, messages, timings.

Data goes to standard output, everything else to standard error. The exit
status is

    0    done                           2    wrong usage, or a program error
    1    the answer is no; or warnings  3    input unreadable or invalid
         with --strict                  4    the geometry is not possible
    5    some of many have failed       128+N  ended by signal N (130: Ctrl-C)

With --strict a verb that has warned writes no file.

An interrupt is an exception here: transactions roll back, files being written
vanish, then the program ends.
*/

%!  main(-Status) is det.
%
%   Run the program's own arguments; engine/main.c ends with Status.

main(Status) :-
    current_prolog_flag(os_argv, Words),
    own_arguments(Words, Arguments),
    set_stream(user_output, encoding(utf8)),
    set_stream(user_error, encoding(utf8)),
    roomy_stack,
    sanggwan(Arguments, Status0),
    flushed(Status0, Status).

%   The global stack becomes large at once when it grows, and rubbish is looked
%   for later: a few megabytes are cheaper than copying them often. So does the
%   trail. The local stack lies in one block with the global one, and is copied
%   with it, used or not: it grows first, as long as that is small. All are
%   numbers of cells.

roomy_stack :-
    set_prolog_stack(local, min_free(3000)),
    deeply(250),
    set_prolog_stack(trail, min_free(500000)),
    set_prolog_stack(global, min_free(1000000)),
    set_prolog_stack(global, low(4000000)).

%   deeply(N): calls itself N deep, no call the last one of its clause.

deeply(0) :-
    !.
deeply(N) :-
    N1 is N-1,
    deeply(N1),
    N1 >= 0.

%   Those after the first `--`: engine/main.c puts it after Prolog's own.

own_arguments(Words, Arguments) :-
    (   append(_, ['--'|Arguments0], Words)
    ->  Arguments = Arguments0
    ;   Arguments = []
    ).

%!  interrupted_words(-Text, -Verb) is det.
%
%   Text is the line that is said of an interrupt, in the language that the
%   program's own arguments and the environment ask for; engine/signals.c says
%   it where the work has to be ended at once. Verb is theirs, or none. From now
%   on an interrupt is an exception; other signals than SIGINT come as `term`.

interrupted_words(Text, Verb) :-
    on_signal(int, _, sg_cli:interrupt),
    on_signal(term, _, sg_cli:interrupt),
    current_prolog_flag(os_argv, Words),
    own_arguments(Words, Arguments),
    set_language(Arguments),
    language(Language),
    interrupted_word(Language, Word),
    format(string(Text), "sanggwan: ~w~n", [Word]),
    (   verb_of(Arguments, Verb0)
    ->  Verb = Verb0
    ;   Verb = none
    ).

%   verb_of(Arguments, Verb): only options stand before it.

verb_of([First|Rest], Verb) :-
    (   verb(First, _, _, _)
    ->  Verb = First
    ;   sub_atom(First, 0, 1, _, -),
        member(Verb, Rest),
        verb(Verb, _, _, _)
    ->  true
    ).

:- public interrupt/1.

interrupt(Signal) :-
    throw(sanggwan_interrupt(Signal)).

%   What is still in the buffers may not fit on the disk.

flushed(Status, Status) :-
    output_lost,
    !.
flushed(Status0, Status) :-
    catch(( flush_output(user_output),
            Status = Status0
          ),
          Error, failed_status(Error, Status)).

%!  sanggwan(+Arguments, -Status) is det.
%
%   Do what the list of atoms Arguments says, in a new world; Status is the
%   exit status. Never fails, never raises.

sanggwan(Arguments, Status) :-
    retractall(output_lost),
    set_language(Arguments),
    (   memberchk('--strict', Arguments)
    ->  Strict = true
    ;   Strict = false
    ),
    setup_call_cleanup(
        asserta(running, Running),
        ended(Strict, command(Arguments), Status),
        ( erase(Running),
          nothing_told
        )).

:- public explained_there/2.

%   explained_there(Arguments, Status): as sanggwan/2 does `explain`, of the
%   model in the current world.

explained_there(Arguments, Status) :-
    set_language([]),
    setup_call_cleanup(
        asserta(running, Running),
        ended(false, there(Arguments), Status),
        ( erase(Running),
          nothing_told
        )).

there(Arguments, Status) :-
    assertz(told_once),
    verb_options(explain, Specs),
    parsed_arguments(Specs, Arguments, Items, Options),
    item_explained_there(Items, Options, Status).

%   ended(Strict, Work, Status): call(Work, Status), as of a command that has
%   said nothing yet; what it raises is said.

ended(Strict, Work, Status) :-
    nothing_told,
    flag(sg_cli_warnings, _, 0),
    catch(strictly_ended(Strict, Work, Status0), Error,
          failed_status(Error, Status0)),
    more_warnings_said,
    strict_status(Strict, Status0, Status).

more_warnings_said :-
    flag(sg_cli_warnings, Count, 0),
    most_warnings(Most),
    (   Count > Most
    ->  More is Count-Most,
        print_message(warning, sanggwan(more_warnings(More)))
    ;   true
    ),
    flag(sg_cli_warnings, _, Count).

%   nothing_told: no verb has said anything yet.

nothing_told :-
    retractall(quiet),
    retractall(told_once),
    retractall(told(_)).

strictly_ended(true, Work, Status) :-
    refusing_moves(sg_cli:work_ended(Work, Status)).
strictly_ended(false, Work, Status) :-
    work_ended(Work, Status).

%   work_ended(Work, Status): a verb that fails is a fault of ours.

work_ended(Work, Status) :-
    (   call(Work, Status0)
    ->  Status = Status0
    ;   print_message(error, sanggwan(no_end)),
        Status = 4
    ).

%   set_language(Arguments): --lang, or what the environment says.

set_language(Arguments) :-
    (   append(_, ['--lang', Language|_], Arguments)
    ->  set_prolog_flag(message_language, Language)
    ;   member(Argument, Arguments),
        atom_concat('--lang=', Language, Argument)
    ->  set_prolog_flag(message_language, Language)
    ;   language_of_environment
    ).

command([], _) :-
    usage_error(no_verb).
command([First|Rest], Status) :-
    (   memberchk(First, ['--help', '-h', help])
    ->  help(Rest),
        Status = 0
    ;   First == '--version'
    ->  print_version,
        Status = 0
    ;   verb(First, _, _, _)
    ->  verb_command(First, Rest, Status)
    ;   sub_atom(First, 0, 1, _, -)
    ->  global_first([First|Rest], Status)
    ;   unknown_verb(First)
    ).

%   `sanggwan --lang ko --help`: common options may stand before the verb.

global_first(Arguments, Status) :-
    verb_options(none, Specs),
    (   append(Before, [Verb|After], Arguments),
        ( verb(Verb, _, _, _) ; memberchk(Verb, ['--help', '--version']) )
    ->  parsed_arguments(Specs, Before, Files, _),
        (   Files == []
        ->  append(After, Before, Rest),
            command([Verb|Rest], Status)
        ;   Files = [File|_],
            unknown_verb(File)
        )
    ;   parsed_arguments(Specs, Arguments, Files, _),
        (   Files = [File|_]
        ->  unknown_verb(File)
        ;   usage_error(no_verb)
        )
    ).

unknown_verb(Word) :-
    findall(Verb, verb(Verb, _, _, _), Verbs),
    near_words(Word, Verbs, Near),
    usage_error(unknown_verb(Word, Near)).

usage_error(What) :-
    throw(error(usage_error(What), _)).

help(Words) :-
    language(Language),
    (   member(Word, Words),
        verb(Word, _, _, _)
    ->  print_usage(Word, Language)
    ;   print_usage(Language)
    ).

print_version :-
    version(Version),
    current_prolog_flag(version, V),
    Major is V//10000,
    Minor is V//100 mod 100,
    Patch is V mod 100,
    format("sanggwan ~w (SWI-Prolog ~d.~d.~d)~n",
           [Version, Major, Minor, Patch]).


                /*******************************
                *             RUNS             *
                *******************************/

verb_command(Verb, Arguments, Status) :-
    (   memberchk(Verb, [repl,serve,batch])
    ->  whole_program
    ;   true
    ),
    verb_options(Verb, Specs),
    parsed_arguments(Specs, Arguments, Files, Options),
    (   option(help(true), Options)
    ->  language(Language),
        print_usage(Verb, Language),
        Status = 0
    ;   verb_in_world(Verb, Files, Options, Status)
    ).

verb_in_world(Verb, _, _, _) :-
    memberchk(Verb, [repl,serve,batch]),
    in_session,
    throw(error(request_error(verb_refused(Verb)), _)).
verb_in_world(serve, Files, Options, Status) :-
    !,
    (   option(stdio(true), Options)
    ->  (   Files = [File|_]
        ->  usage_error(no_files_taken('serve --stdio', File))
        ;   serve_run(sg_cli:sanggwan, sg_cli:explained_there, Status)
        )
    ;   Files = [_,File|_]
    ->  usage_error(one_model(serve, File))
    ;   ( Files = [Model] ; Model = none )
    ->  front(Model, Options, Status)
    ).
verb_in_world(Verb, Files, Options, Status) :-
    option(each(true), Options),
    !,
    option(strict(Strict), Options, false),
    each_file(sg_cli:file_ended(Verb, Strict), Verb, Files, Options, Status).
verb_in_world(Verb, _, Options, _) :-
    memberchk(Verb, [draw,convert]),
    option(json(true), Options),
    !,
    usage_error(each(json_alone)).
verb_in_world(Verb, Files, Options, Status) :-
    option(limits(Limits), Options, ''),
    limits_given(Limits),
    (   option(quiet(true), Options)
    ->  assertz(quiet)
    ;   true
    ),
    (   Verb == repl
    ->  true
    ;   assertz(told_once)
    ),
    stages_reset,
    csg_statistics_reset,
    get_time(Start),
    in_passing_world(
        call_cleanup(
            verb_watched(Verb, Files, Options, Status),
            ( measured(Options, Start),
              no_rules
            ))).

%   file_ended(Verb, Strict, File, Options, Status): as by a command of its own.

:- public file_ended/5.

file_ended(Verb, Strict, File, Options, Status) :-
    ended(Strict, verb_in_world(Verb, [File], Options), Status).

%   in_session: the verb is a job of a session, which is a verb itself.

in_session :-
    findall(yes, running, [_,_|_]).

%   limits_given(Text): NAME=N, with commas between them.

limits_given('') :-
    !.
limits_given(Text) :-
    split_string(Text, ",", " ", Parts),
    maplist(limit_given(Text), Parts).

limit_given(Text, Part) :-
    (   split_string(Part, "=", " ", [NameText, MostText]),
        atom_string(Name, NameText),
        decimal_number(MostText, Most),
        integer(Most),
        Most > 0
    ->  (   limit_value(Name, _)
        ->  set_limit(Name, Most)
        ;   findall(Known, limit_value(Known, _), All),
            usage_error(bad_value('--limits', Name, one_of(All)))
        )
    ;   usage_error(bad_value('--limits', Text, 'depth=200,nodes=1000000'))
    ).

verb_watched(Verb, Files, Options, Status) :-
    option(rules(Rules), Options, []),
    maplist(use_rules, Rules),
    (   memberchk(Verb, [repl,batch])
    ->  true
    ;   format_options_told(Verb, Files, Options)
    ),
    (   ( memberchk(Verb, [repl,batch]) ; option(quiet(true), Options) )
    ->  verb_whole(Verb, Files, Options, Status)
    ;   with_progress(verb_whole(Verb, Files, Options, Status))
    ).

%   verb_whole(Verb, Files, Options, Status): the files of a verb appear
%   together, those of goals one by one.

verb_whole(Verb, Files, Options, Status) :-
    (   memberchk(Verb, [repl,query,batch])
    ->  verb_run(Verb, Files, Options, Status)
    ;   files_together(( verb_run(Verb, Files, Options, Status),
                         places_looked_at(Options),
                         files_allowed(Options) ))
    ).

%   files_allowed(Options): after a warning --strict lets no file take its
%   place, and nothing go to standard output that -o sends there.

files_allowed(Options) :-
    (   option(strict(true), Options),
        output_waiting,
        flag(sg_cli_warnings, N, N),
        N > 0
    ->  throw(sanggwan_strict(N))
    ;   true
    ).

%   places_looked_at(Options): with --each, before files take their places.

places_looked_at(Options) :-
    (   option(places(Look), Options)
    ->  call(Look)
    ;   true
    ).

%   measured(Options, Start): what --timings and --stats ask for, also after
%   an error.

measured(Options, Start) :-
    (   option(timings(true), Options)
    ->  get_time(End),
        Total is End-Start,
        findall(Name-Seconds, timing(Name, Seconds), Pairs0),
        pairs_values(Pairs0, Parts),
        sum_list(Parts, Sum),
        Other is max(0.0, Total-Sum),
        append(Pairs0, [other-Other, total-Total], Pairs),
        json_line(Pairs)
    ;   true
    ),
    (   option(stats(true), Options)
    ->  exact_fallbacks(Fallbacks),
        exact_statistics(Exact),
        tree_statistics(Trees),
        csg_statistics(Csg),
        output_statistics(Output),
        rules_statistics(Rules),
        findall(Relation-Dict, facts_statistics(Relation, Dict), Pairs1),
        json_line([exact_fallbacks-Fallbacks,exact-Exact,
                   trees-Trees,csg-Csg,output-Output,rules-Rules|Pairs1])
    ;   true
    ).

%   rules_statistics(Rules): so many files of each folder of rules are loaded.

rules_statistics(Rules) :-
    findall(Folder, loaded_rule(_, Folder), Folders0),
    msort(Folders0, Folders),
    clumped(Folders, Counts),
    dict_pairs(Rules, _, Counts).

timing(Name, Seconds) :-
    stage_name(Name),
    (   stage_seconds(Name, Seconds0)
    ->  Seconds = Seconds0
    ;   Seconds = 0.0
    ).

json_line(Pairs) :-
    format(user_error, "{", []),
    json_members(Pairs),
    format(user_error, "}~n", []).

json_members([]).
json_members([Name-Value|Pairs]) :-
    format(user_error, "\"~w\":", [Name]),
    (   is_dict(Value)
    ->  json_write_dict(user_error, Value, [width(0)])
    ;   integer(Value)
    ->  format(user_error, "~d", [Value])
    ;   format(user_error, "~6f", [Value])
    ),
    (   Pairs == []
    ->  true
    ;   format(user_error, ", ", []),
        json_members(Pairs)
    ).


                /*******************************
                *         EXIT STATUS          *
                *******************************/

%   failed_status(Error, Status): Error is printed and gives the exit status.

failed_status(Error, Status) :-
    (   Error = sanggwan_interrupt(Signal)
    ->  print_message(error, sanggwan(interrupted)),
        signal_status(Signal, Status)
    ;   Error = sanggwan_strict(N)
    ->  print_message(error, sanggwan(nothing_written(N))),
        Status = 1
    ;   broken_pipe(Error)
    ->  Status = 141
    ;   error_status(Error, Status),
        said(Error, Message),
        print_message(error, Message)
    ).

%   said(Error, Message): what is printed of it.

said(error(io_error(write, Stream), context(_, Why)), Message) :-
    is_stream(Stream),
    stream_property(Stream, alias(user_output)),
    !,
    assertz(output_lost),
    Message = error(cannot_write(output, Why), _).
said(Error, Message) :-
    (   subsumes_term(error(_, _), Error)
    ->  error_placed(Error, Message)
    ;   Message = sanggwan(uncaught(Error))
    ).

signal_status(int, 130).
signal_status(term, 143).

%   The reader of a pipe has seen enough, as in `sanggwan query ... | head`.

broken_pipe(error(io_error(write, _), context(_, Message))) :-
    sub_atom(Message, _, _, _, 'roken pipe').

strict_status(Strict, Status0, Status) :-
    flag(sg_cli_warnings, N, N),
    (   N > 0,
        Status0 == 0,
        Strict == true
    ->  print_message(error, sanggwan(warnings_are_errors(N))),
        Status = 1
    ;   Status = Status0
    ).


                /*******************************
                *           MESSAGES           *
                *******************************/

%   Messages of the program look like those of others: a line that begins with
%   `sanggwan: `, or with the place in a file so that editors jump there.

%   When the output is lost, Prolog fails to flush it again as it ends.

%   Each pass over a model may find the same; a command says it once.

:- dynamic quiet/0, running/0, output_lost/0, told_once/0, told/1.

:- multifile user:message_hook/3.

user:message_hook(error(io_error(write, _), _), error, _) :-
    sg_cli:output_lost.
user:message_hook(Term, Kind, Lines) :-
    sg_cli:running,
    sg_cli:spoken(Kind, Term, Lines).

:- public spoken/3.

spoken(warning, Term, Lines) :-
    flag(sg_cli_warnings, N, N),
    most_warnings(Most),
    N >= Most,
    !,
    (   silent_warning(Term, Lines)
    ->  true
    ;   flag(sg_cli_warnings, _, N+1)
    ).
spoken(Kind, Term, Lines0) :-
    spoken_lines(Kind, Term, Lines0, Lines),
    shown(Kind, Term, Lines).

%   Prolog has no words for some of its warnings.

shown(_, _, []) :-
    !.
shown(error, Term, Lines) :-
    message_said(error, Term),
    print_prefixed(user_error, '', Term, Lines).
shown(warning, Term, Lines) :-
    language(Language),
    warning_word(Language, Word),
    with_output_to(atom(Text),
                   print_prefixed(current_output, Word, Term, Lines)),
    (   told_once,
        told(Text)
    ->  true
    ;   assertz(told(Text)),
        flag(sg_cli_warnings, N, N+1),
        message_said(warning, Term),
        print_prefixed(user_error, Word, Term, Lines)
    ).
shown(informational, Term, Lines) :-
    (   quiet
    ->  true
    ;   message_said(informational, Term),
        print_prefixed(user_error, '', Term, Lines)
    ).

%   most_warnings(Most): what a command warns of more often is counted.

most_warnings(100).

warning_word(en, 'warning: ').
warning_word(ko, '경고: ').

%   names_place(Term): its message begins with a place itself.

names_place(error(Fault, Where)) :-
    subsumes_term(location(_, _, _), Where),
    nonvar(Fault),
    memberchk(Fault, [model_error(_),geometry_error(_)]).
names_place(sanggwan(not_utf8(_, _))).
names_place(sanggwan(comma(_, location(_, _, _)))).

print_prefixed(Out, Word, Term, Lines) :-
    (   names_place(Term)
    ->  format(atom(Prefix), '~~N~w', [Word])
    ;   loading_place(File, Line)
    ->  format(atom(Prefix), '~~N~w:~d: ~w', [File, Line, Word])
    ;   format(atom(Prefix), '~~Nsanggwan: ~w', [Word])
    ),
    print_message_lines(Out, '', [Prefix-[]|Lines]).
