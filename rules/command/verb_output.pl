:- module(sg_verb_output,
          [ some_files/2,               % +Files, +What
            outputs/3,                  % +Options, +Formats, -Outputs
            folder_exists/1,            % +File
            some_outputs/1,             % +Outputs
            no_model_replaced/2,        % +Files, +Outputs
            output_written/2,           % :Writer, +Output
            usage_error/1               % +What
          ]).
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
%   work is done; the first of Formats is the default of standard output.
%
%   @error usage_error(ending(File, Formats)), usage_error(no_folder(Folder))

outputs(Options, Formats, Outputs) :-
    option(output(Files), Options, []),
    Formats = [First|_],
    option(format(Default), Options, First),
    maplist(output(Formats, Default), Files, Outputs).

output(_, Default, -, output(-, Default)) :-
    !.
output(Formats, _, File, output(File, Format)) :-
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format),
    (   memberchk(Format, Formats)
    ->  folder_exists(File)
    ;   usage_error(ending(File, Formats))
    ).

%!  folder_exists(+File) is det.
%
%   A missing folder is found out before the work, not after it.
%
%   @error usage_error(no_folder(Folder))

folder_exists(File) :-
    file_directory_name(File, Folder),
    (   exists_directory(Folder)
    ->  true
    ;   usage_error(no_folder(Folder))
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
%   Writer gets a file name with the ending of the format. Standard output gets
%   the bytes of a temporary file, so every writer knows files only.

output_written(Writer, output(-, Format)) :-
    !,
    setup_call_cleanup(
        tmp_file_stream(File, Temporary,
                        [encoding(binary), extension(Format)]),
        ( close(Temporary),
          call(Writer, File),
          copied_out(File)
        ),
        delete_file(File)).
output_written(Writer, output(File, _)) :-
    call(Writer, File),
    print_message(informational, sanggwan(wrote(File))).

copied_out(File) :-
    set_stream(user_output, type(binary)),
    setup_call_cleanup(
        open(File, read, In, [type(binary)]),
        copy_stream_data(In, user_output),
        close(In)),
    flush_output(user_output).
