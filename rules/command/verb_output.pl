:- module(sg_verb_output,
          [ some_files/2,               % +Files, +What
            outputs/3,                  % +Options, +Formats, -Outputs
            may_be_written/1,           % +File
            no_file/1,                  % +File
            some_outputs/1,             % +Outputs
            no_model_replaced/2,        % +Files, +Outputs
            output_written/2,           % :Writer, +Output
            reported/2,                 % +Outputs, :Goal
            summary_sent_told/2,        % +Outputs, +Endings
            usage_error/1               % +What
          ]).
:- use_module('../kernel', [device_file/1]).
:- use_module('../output', [copied_to/3, when_written/1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/3]).
/** <module> What verbs are given, and where their results go.
*/

%!  some_files(+Files, +What) is det.
%
%   @error usage_error(no_files(What)): there are none

some_files([], What) :-
    !,
    usage_error(no_files(What)).
some_files(_, _).

%!  usage_error(+What) is failure.

usage_error(What) :-
    throw(error(usage_error(What), _)).

%!  outputs(+Options, +Formats, -Outputs) is det.
%
%   Outputs is output(File, Format) of every -o, the ending checked before any
%   work is done; the first of Formats is the default of what has no ending.
%
%   @error usage_error(ending(File, Formats)), usage_error(no_folder(Folder))

outputs(Options, Formats, Outputs) :-
    option(output(Files), Options, []),
    Formats = [First|_],
    option(format(Default), Options, First),
    maplist(output(Formats, Default), Files, Outputs).

output(Formats, Default, File0, output(File, Format)) :-
    output_name(File0, File),
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format0),
    (   memberchk(Format0, Formats),
        File \== (-)
    ->  Format = Format0,
        may_be_written(File)
    ;   no_file(File)
    ->  Format = Default
    ;   usage_error(ending(File, Formats))
    ).

%   output_name(File0, File): standard output has many names. Written by one of
%   these, a file that it was sent to would lose what is in it.

output_name(File0, File) :-
    (   memberchk(File0, ['/dev/stdout','/dev/fd/1','/proc/self/fd/1'])
    ->  File = (-)
    ;   File = File0
    ).

%!  no_file(+File) is semidet.
%
%   True of what is written as a stream: standard output (`-`), a device, a
%   pipe.

no_file(-) :-
    !.
no_file(File) :-
    device_file(File).

%!  may_be_written(+File) is det.
%
%   What is in the way of File is found out before the work, not after it.
%
%   @error usage_error(no_folder(Folder)), cannot_write(File, Why)

may_be_written(File) :-
    file_directory_name(File, Folder),
    (   \+ exists_directory(Folder)
    ->  usage_error(no_folder(Folder))
    ;   exists_directory(File)
    ->  throw(error(cannot_write(File, directory), _))
    ;   access_file(File, write)
    ->  true
    ;   throw(error(cannot_write(File, permission), _))
    ).

%!  some_outputs(+Outputs) is det.
%
%   @error usage_error(no_output): there are none

some_outputs([]) :-
    !,
    usage_error(no_output).
some_outputs(_).

%!  no_model_replaced(+Files, +Outputs) is det.
%
%   A picture as facts ends in .pl as its model does.
%
%   @error usage_error(replaces_model(File)): an output is one of Files

no_model_replaced(Files, Outputs) :-
    (   member(output(Output, _), Outputs),
        member(File, Files),
        Output \== (-),
        exists_file(Output),
        exists_file(File),
        same_file(Output, File)
    ->  usage_error(replaces_model(Output))
    ;   true
    ).

:- meta_predicate output_written(1, +).

%!  output_written(:Writer, +Output) is det.
%
%   Writer gets a file name with the ending of the format. What is no file gets
%   the bytes of a temporary one, so every writer knows files only.

output_written(Writer, output(File, Format)) :-
    no_file(File),
    !,
    copied_to(File, Format, Writer).
output_written(Writer, output(File, _)) :-
    call(Writer, File),
    when_written(print_message(informational, sanggwan(wrote(File)))).

%!  reported(+Outputs, :Goal) is det.
%
%   Call Goal, which prints a report, when the files are there: who reads the
%   beginning of a report only, as `head` does, has his files. If standard
%   output is one of Outputs the report goes to standard error, at once.

:- meta_predicate reported(+, 0).

reported([], Goal) :-
    !,
    once(Goal).
reported(Outputs, Goal) :-
    (   memberchk(output(-, _), Outputs)
    ->  current_output(Out),
        setup_call_cleanup(set_output(user_error), Goal, set_output(Out))
    ;   when_written(Goal)
    ).

%!  summary_sent_told(+Outputs, +Endings) is det.
%
%   A warning where nothing is written and standard output, which has a summary,
%   is a file with one of Endings: who wrote `> part.stl` wanted the solid.

summary_sent_told([], Endings) :-
    catch(read_link('/proc/self/fd/1', File, _), error(_, _), fail),
    file_name_extension(_, Ending0, File),
    downcase_atom(Ending0, Ending),
    memberchk(Ending, Endings),
    !,
    file_base_name(File, Base),
    print_message(warning, sanggwan(summary_sent(Base))).
summary_sent_told(_, _).
