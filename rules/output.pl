:- module(sg_output,
          [ writing/3                   % +File, +Type, :Goal
          ]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(filesex), [directory_file_path/3]).
/** <module> Output files: whole, or not there at all.

A file is written under another name beside it and renamed when it is
complete, so nobody ever sees half of one: not after a failure, an error, an
interrupt, nor on a full disk. The old file stays until the new one takes its
place.
*/

:- meta_predicate writing(+, +, 1).

%!  writing(+File, +Type, :Goal) is semidet.
%
%   Call Goal with one more argument, a stream, once; what it writes is File
%   afterwards. Type is `text` (UTF-8) or `binary`. If Goal fails or raises,
%   so does this, and File is as it was. A link is followed; what is no
%   regular file (a device, a pipe) is written in place.
%
%   @error existence_error(directory, Folder), permission_error(_, _, Folder),
%   cannot_write(File, permission), io_error(write, File): the disk is full.

writing(File, Type, Goal) :-
    must_be(oneof([text,binary]), Type),
    file_target(File, Path),
    (   written_in_place(Path)
    ->  catch(written(Path, Type, Goal), Error, blame(Path, Path, Error))
    ;   beside(Path, Temporary),
        setup_call_cleanup(
            true,
            catch(( written(Temporary, Type, Goal),
                    rename_file(Temporary, Path)
                  ),
                  Error, blame(Temporary, Path, Error)),
            removed(Temporary))
    ).

%   The path that File names, links followed, in a folder that exists.

file_target(File, Path) :-
    absolute_file_name(File, Absolute, [expand(false)]),
    (   read_link(Absolute, _, Target)
    ->  Path = Target
    ;   Path = Absolute
    ),
    file_directory_name(Path, Folder),
    (   exists_directory(Folder)
    ->  true
    ;   throw(error(existence_error(directory, Folder),
                    context(sg_output:writing/3, _)))
    ),
    (   exists_directory(Path)
    ->  throw(error(permission_error(write, directory, Path),
                    context(sg_output:writing/3, _)))
    ;   exists_file(Path),
        \+ access_file(Path, write)
    ->  throw(error(cannot_write(Path, permission), _))
    ;   true
    ).

written_in_place(Path) :-
    access_file(Path, exist),
    \+ exists_file(Path).

%   A name in the same folder that no other run, thread or call has: renaming
%   does not cross file systems.

beside(Path, Temporary) :-
    file_directory_name(Path, Folder),
    file_base_name(Path, Base),
    current_prolog_flag(pid, Pid),
    flag(sg_output_file, N, N+1),
    format(atom(Name), '.~w.~d-~d', [Base, Pid, N]),
    directory_file_path(Folder, Name, Temporary).

%   A full disk shows at the latest when the stream is closed, so it is closed
%   before the file counts as written.

written(Path, Type, Goal) :-
    stream_options(Type, Options),
    setup_call_cleanup(
        open(Path, write, Out, Options),
        ( once(call(Goal, Out)),
          close(Out)
        ),
        closed(Out)).

stream_options(text, [encoding(utf8), newline(posix)]).
stream_options(binary, [type(binary)]).

closed(Out) :-
    (   is_stream(Out)
    ->  close(Out, [force(true)])
    ;   true
    ).

removed(Temporary) :-
    (   exists_file(Temporary)
    ->  delete_file(Temporary)
    ;   true
    ).

%   Raise Error again, about the file that was asked for.

blame(Temporary, Path, error(Formal0, Context)) :-
    nonvar(Formal0),
    blamed(Formal0, Temporary, Path, Formal),
    !,
    throw(error(Formal, Context)).
blame(_, _, Error) :-
    throw(Error).

blamed(io_error(write, _), _, Path, io_error(write, Path)).
blamed(permission_error(_, _, Temporary), Temporary, Path,
       cannot_write(Path, permission)).
blamed(existence_error(_, Temporary), Temporary, Path,
       cannot_write(Path, permission)).
