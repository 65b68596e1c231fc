:- module(sg_output,
          [ writing/3,                  % +File, +Type, :Goal
            copied_to/3,                % +Target, +Ending, :Goal
            asked_for/2,                % +File, -Target
            files_together/1,           % :Goal
            when_written/1,             % :Goal
            files_waiting/1,            % -Files
            output_waiting/0,
            files_recorded/2,           % :Goal, -Files
            write_fact/2                % +Stream, +Fact
          ]).
:- use_module(kernel,
              [ atomic_open/3, atomic_scratch/3, atomic_sync/1,
                atomic_commit/2, atomic_drop/1, device_file/1
              ]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists),
              [append/3, member/2, nth0/3, reverse/2, selectchk/3]).
/** <module> Output files: whole, or not there at all.

A file is written under another name beside it, which nobody can guess, and
takes its place when it is complete, so nobody ever sees half of one: not after
a failure, an error, a signal, nor on a full disk. Files that are written
together take their places together. engine/atomic_file.h has the rest.
*/

:- meta_predicate
    writing(+, +, 1),
    copied_to(+, +, 1),
    files_together(0),
    files_recorded(0, -),
    when_written(0).

%!  writing(+File, +Type, :Goal) is semidet.
%
%   Call Goal with one more argument, a stream, once; what it writes is File
%   afterwards. Type is `text` (UTF-8) or `binary`. If Goal fails or raises,
%   so does this, and File is as it was. A link is followed; what is no
%   regular file (a device, a pipe) is written in place.
%
%   @error existence_error(directory, Folder), cannot_write(File, Why): see
%   atomic_open/3

writing(File, Type, Goal) :-
    must_be(oneof([text,binary]), Type),
    folder_there(File),
    (   written_in_place(File)
    ->  Where = in_place
    ;   Where = apart
    ),
    setup_call_catcher_cleanup(
        opened(Where, File, Id, Out),
        ( catch(filled(Where, Out, Type, Goal), Error, blame(File, Error)),
          complete(Id, File)
        ),
        How,
        left(How, Id, Out)).

folder_there(File) :-
    file_directory_name(File, Folder),
    (   exists_directory(Folder)
    ->  true
    ;   throw(error(existence_error(directory, Folder),
                    context(sg_output:writing/3, _)))
    ).

%   Devices and pipes, and the scratch files of copied_to/3.

written_in_place(File) :-
    asked_for(File, Target),
    Target \== File,
    !.
written_in_place(File) :-
    device_file(File).

opened(in_place, File, none, Out) :-
    catch(open(File, write, Out, [type(binary)]), Error, blame(File, Error)).
opened(apart, File, Id, Out) :-
    atomic_open(File, Id, Out).

%   A full disk shows at the latest when the stream is closed, so it is closed
%   before the file counts as written.

filled(Where, Out, Type, Goal) :-
    stream_type(Type, Out),
    once(call(Goal, Out)),
    (   Where == apart
    ->  atomic_sync(Out)
    ;   true
    ),
    close(Out).

stream_type(binary, _).
stream_type(text, Out) :-
    set_stream(Out, type(text)),
    set_stream(Out, encoding(utf8)),
    set_stream(Out, newline(posix)).

complete(none, _) :-
    !.
complete(Id, File) :-
    pending(Items),
    (   Items == none
    ->  placed([file(Id, File)])
    ;   pended(file(Id, File))
    ).

left(exit, _, _) :-
    !.
left(_, Id, Out) :-
    (   is_stream(Out)
    ->  close(Out, [force(true)])
    ;   true
    ),
    (   Id == none
    ->  true
    ;   forgotten(Id)
    ).

forgotten(Id) :-
    atomic_drop(Id),
    pending(Items),
    (   Items \== none,
        selectchk(file(Id, _), Items, Rest)
    ->  nb_setval(sg_output_pending, Rest)
    ;   true
    ).


                /*******************************
                *           TOGETHER           *
                *******************************/

%!  files_together(:Goal) is semidet.
%
%   Call Goal once. The files that it writes by writing/3 and copied_to/3
%   appear when it has succeeded, all of them; if it fails or raises, or one of
%   them cannot be put in its place, all files are as they were. Inside of
%   another one it is just once/1.

files_together(Goal) :-
    pending(Items),
    Items \== none,
    !,
    once(Goal).
files_together(Goal) :-
    setup_call_cleanup(
        nb_setval(sg_output_pending, []),
        ( once(Goal),
          all_placed
        ),
        all_dropped).

%!  when_written(:Goal) is semidet.
%
%   Call Goal, once, when the files of files_together/1 are there; at once
%   outside of it.

when_written(Goal) :-
    pending(Items),
    (   Items == none
    ->  once(Goal)
    ;   pended(said(Goal))
    ).

%!  files_waiting(-Files:list) is det.
%
%   Files are the names of the files, as writing/3 was given them, which will
%   take their places at the end of files_together/1.

files_waiting(Files) :-
    pending(Items),
    (   Items == none
    ->  Files = []
    ;   findall(File, member(file(_, File), Items), Files)
    ).

%!  output_waiting is semidet.
%
%   The end of files_together/1 will put a file in its place, or send one to
%   standard output, a device or a pipe.

output_waiting :-
    pending(Items),
    Items \== none,
    member(Item, Items),
    Item \= said(_),
    !.

%!  copied_to(+Target, +Ending, :Goal) is semidet.
%
%   Call Goal with one more argument, the name of a file with this Ending, once.
%   What it wrote there is copied, when all is complete, to Target: a device, a
%   pipe, or `-`, standard output.

copied_to(Target, Ending, Goal) :-
    files_together(sg_output:scratch_written(Target, Ending, Goal)).

scratch_written(Target, Ending, Goal) :-
    atom_concat('.', Ending, Dotted),
    atomic_scratch(Dotted, Id, File),
    pended(scratch(Id, File, Target)),
    call(Goal, File).

%!  asked_for(+File, -Target) is det.
%
%   Target is what the user called File: of a file of copied_to/3 where it goes.

asked_for(File, Target) :-
    pending(Items),
    (   Items \== none,
        memberchk(scratch(_, File, Target0), Items)
    ->  Target = Target0
    ;   Target = File
    ).

%!  write_fact(+Stream, +Fact) is det.
%
%   Write Fact as a line of a file of facts. Of an interrupt that comes while it
%   writes, write_term/3 of SWI-Prolog 9.0.4 says in a message that there was
%   one, and goes on; so it waits for the end of the line.

write_fact(Stream, Fact) :-
    sig_atomic(write_term(Stream, Fact,
                          [ quoted(true), spacing(next_argument),
                            numbervars(false), module(sg_model_syntax),
                            float_format(''), fullstop(true), nl(true)
                          ])).

%   pending(Items): what waits for its place in this thread, the last first;
%   `none` outside of files_together/1.

pending(Items) :-
    (   nb_current(sg_output_pending, Items0)
    ->  Items = Items0
    ;   Items = none
    ).

pended(Item) :-
    nb_getval(sg_output_pending, Items),
    nb_setval(sg_output_pending, [Item|Items]).

%   Pipes and devices go first: they may refuse, and nothing takes back what
%   they took.

all_placed :-
    pending(Items0),
    reverse(Items0, Items),
    forall(member(scratch(_, File, Target), Items), copied(File, Target)),
    findall(file(Id, File), member(file(Id, File), Items), Files),
    placed(Files),
    forall(member(said(Goal), Items), Goal).

placed(Files) :-
    findall(Id, member(file(Id, _), Files), Ids),
    atomic_commit(Ids, Result),
    (   Result = failed(I, Why)
    ->  nth0(I, Files, file(_, File)),
        throw(error(cannot_write(File, Why), _))
    ;   findall(File, member(file(_, File), Files), Names),
        recorded(Names)
    ).

%!  files_recorded(:Goal, -Files:list) is semidet.
%
%   Call Goal once; Files are the names of the files that took their places
%   meanwhile, in their order, as writing/3 was given them. One that goes on
%   outside of this one has them too.

files_recorded(Goal, Files) :-
    (   nb_current(sg_output_recorded, Before0)
    ->  Before = Before0
    ;   Before = none
    ),
    setup_call_cleanup(
        nb_setval(sg_output_recorded, []),
        ( once(Goal),
          nb_getval(sg_output_recorded, Files)
        ),
        ( nb_getval(sg_output_recorded, Names),
          nb_setval(sg_output_recorded, Before),
          recorded(Names)
        )).

recorded(Names) :-
    (   nb_current(sg_output_recorded, Before),
        Before \== none
    ->  append(Before, Names, All),
        nb_setval(sg_output_recorded, All)
    ;   true
    ).

all_dropped :-
    pending(Items),
    nb_setval(sg_output_pending, none),
    maplist(dropped, Items).

dropped(file(Id, _)) :-
    atomic_drop(Id).
dropped(scratch(Id, _, _)) :-
    atomic_drop(Id).
dropped(said(_)).

copied(File, -) :-
    !,
    set_stream(user_output, type(binary)),
    copied_bytes(File, user_output),
    flush_output(user_output).
copied(File, Target) :-
    catch(setup_call_cleanup(
              open(Target, write, Out, [type(binary)]),
              ( copied_bytes(File, Out),
                close(Out)
              ),
              left(copy, none, Out)),
          Error, blame(Target, Error)).

copied_bytes(File, Out) :-
    setup_call_cleanup(
        open(File, read, In, [type(binary)]),
        copy_stream_data(In, Out),
        close(In)).

%   Raise Error again, about the file that was asked for.

blame(File, error(Formal, Context)) :-
    nonvar(Formal),
    blamed(Formal, File, Context, Why),
    !,
    throw(error(cannot_write(File, Why), _)).
blame(_, Error) :-
    throw(Error).

blamed(io_error(write, _), _, Context, Why) :-
    (   nonvar(Context),
        Context = context(_, Text),
        nonvar(Text)
    ->  (   full(Text, Why0)
        ->  Why = Why0
        ;   Why = Text
        )
    ;   Why = error
    ).
blamed(permission_error(open, source_sink, File), File, _, permission).

full('No space left on device', full).
full('Disk quota exceeded', full).
full('File too large', too_large).
