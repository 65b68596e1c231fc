:- module(sg_batch_store,
          [ with_store/3,               % +Out, -Store, :Goal
            job_folder/3,               % +Store, +Id, -Folder
            folder_files/2,             % +Folder, -Files
            sizes_text/3,               % +Folder, +Files, -Text
            published/4,                % +Store, +Folder, +Key, -Place
            result_place/3,             % +Store, +Key, -Place
            spoiled/1,                  % +Place
            failure_written/3,          % +Store, +Key, +Text
            failure_stored/3,           % +Store, +Key, -Text
            failure_removed/2,          % +Store, +Key
            linked/5                    % +Store, +Way, +Place, +File, +Path
          ]).
:- use_module(batch_report, [json_text/2]).
:- use_module('../output', [writing/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(filesex),
              [ delete_directory_and_contents/1, directory_file_path/3,
                link_file/3, make_directory_path/1
              ]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> The store of results: folders named by what they are made from.

    OUT/store/ab/cdef...         the files of the job with the key abcdef...
    OUT/store/ab/cdef....failed  that it failed, and why
    OUT/store/.tmp/NAME/         what a batch that runs is making
    OUT/NAME.svg                 a link to a file in the store

A folder gets its name when all in it is there: to rename it is the lock, so
several batches may write to one store, on one machine or on many. A batch holds
its folder in `.tmp` by a lock on a file that ends with its process; folders
that nobody holds are those of batches that were killed, and go.
*/

:- meta_predicate with_store(+, -, 0).

%!  with_store(+Out, -Store, :Goal) is semidet.
%
%   Call Goal once with Store, that in the folder Out, which is made if it is
%   not there.
%
%   @error cannot_write(Out, Why), usage_error(batch(no_folder(Out)))

with_store(Out0, store(Out, Own), Goal) :-
    made_folder(Out0),
    absolute_file_name(Out0, Out),
    atomic_list_concat([Out, '/store/.tmp'], Tmp),
    setup_call_cleanup(
        own_folder(Tmp, Own, Lock),
        ( dead_removed(Tmp, Own),
          once(Goal) ),
        released(Tmp, Own, Lock)).

made_folder(Folder) :-
    catch(make_directory_path(Folder), error(Formal, _), true),
    (   exists_directory(Folder),
        access_file(Folder, write)
    ->  true
    ;   exists_file(Folder)
    ->  throw(error(usage_error(batch(no_folder(Folder))), _))
    ;   nonvar(Formal),
        Formal = permission_error(_, _, _)
    ->  throw(error(cannot_write(Folder, permission), _))
    ;   exists_directory(Folder)
    ->  throw(error(cannot_write(Folder, permission), _))
    ;   throw(error(cannot_write(Folder, no_folder), _))
    ).

%   own_folder(Tmp, Own, Lock): nobody else can have locked it and still see it,
%   for who finds a folder without a holder holds it until it is gone.

own_folder(Tmp, Own, Lock) :-
    between(1, 100, _),
    made_folder(Tmp),
    get_time(Now),
    Time is floor(Now*1000000),
    current_prolog_flag(pid, Pid),
    Random is random(1<<40),
    format(atom(Own), '~w/~d-~d-~36r', [Tmp, Time, Pid, Random]),
    catch(make_directory(Own), error(existence_error(_, _), _), fail),
    atom_concat(Own, '/lock', File),
    lock_held(File, Lock),
    (   exists_file(File)
    ->  true
    ;   close(Lock),
        fail
    ),
    !.
own_folder(Tmp, _, _) :-
    throw(error(cannot_write(Tmp, error), _)).

%   lock_held(File, Lock): some file systems have no locks; there nobody can
%   have that of another, so nothing of ours is removed.

lock_held(File, Lock) :-
    catch(open(File, write, Lock0, [lock(exclusive)]), error(_, _), fail),
    !,
    Lock = Lock0.
lock_held(File, Lock) :-
    catch(open(File, write, Lock, []), error(_, _), fail).

released(Tmp, Own, Lock) :-
    folder_removed(Own),
    close(Lock),
    catch(delete_directory(Tmp), error(_, _), true).

folder_removed(Folder) :-
    catch(delete_directory_and_contents(Folder), error(_, _), true).

%   dead_removed(Tmp, Own): a lock that can be had is nobody's. Where there are
%   no locks nothing is removed.

dead_removed(Tmp, Own) :-
    directory_files(Tmp, Names),
    forall(( member(Name, Names),
             \+ memberchk(Name, ['.', '..']),
             directory_file_path(Tmp, Name, Folder),
             Folder \== Own,
             exists_directory(Folder) ),
           removed_if_dead(Folder)).

removed_if_dead(Folder) :-
    atom_concat(Folder, '/lock', File),
    (   catch(open(File, update, Lock, [lock(exclusive), wait(false)]),
              error(_, _), fail)
    ->  folder_removed(Folder),
        close(Lock)
    ;   true
    ).

%!  job_folder(+Store, +Id, -Folder) is det.
%
%   Folder is a new one, empty, where the job Id makes its files.

job_folder(store(_, Own), Id, Folder) :-
    atomic_list_concat([Own, /, Id], Folder),
    (   exists_directory(Folder)
    ->  delete_directory_and_contents(Folder)
    ;   true
    ),
    make_directory(Folder).

%!  folder_files(+Folder, -Files) is det.
%
%   Files are the names of the files in Folder and in folders in it, in order,
%   but job.json.

folder_files(Folder, Files) :-
    findall(File, file_in(Folder, '', File), Files0),
    sort(Files0, Files).

file_in(Folder, Prefix, File) :-
    directory_files(Folder, Names),
    member(Name, Names),
    \+ memberchk(Name, ['.', '..', 'job.json']),
    atomic_list_concat([Folder, /, Name], Path),
    atom_concat(Prefix, Name, Own),
    (   exists_directory(Path)
    ->  atom_concat(Own, /, Prefix1),
        file_in(Path, Prefix1, File)
    ;   File = Own
    ).

%!  sizes_text(+Folder, +Files, -Text) is det.
%
%   Text is JSON with the name and the octets of each of Files in Folder.

sizes_text(Folder, Files, Text) :-
    maplist(size_text(Folder), Files, Texts),
    atomic_list_concat(Texts, ',', Inner),
    atomic_list_concat(['[', Inner, ']'], Text).

size_text(Folder, File, Text) :-
    atomic_list_concat([Folder, /, File], Path),
    size_file(Path, Size),
    json_text(File, Name),
    atomic_list_concat(['{"name":', Name, ',"bytes":', Size, '}'], Text).

%!  spoiled(+Place) is det.
%
%   What is in Place of the store is not what was put there, as after a loss of
%   power: it goes.

spoiled(Place) :-
    folder_removed(Place).

%   key_place(Store, Key, Parent, Name): Parent/Name is the folder of Key.

key_place(store(Out, _), Key, Parent, Name) :-
    sub_atom(Key, 0, 2, _, Two),
    sub_atom(Key, 2, _, 0, Name),
    atomic_list_concat([Out, '/store/', Two], Parent).

%!  published(+Store, +Folder, +Key, -Place) is det.
%
%   Folder becomes the result of Key, in Place; if there is one it goes.
%
%   @error permission_error, io_error

published(Store, Folder, Key, Place) :-
    result_place(Store, Key, Place),
    (   renamed(Folder, Place)
    ->  true
    ;   exists_directory(Place)         % another batch was faster
    ->  folder_removed(Folder)
    ;   file_directory_name(Place, Parent),
        made_folder(Parent),
        (   renamed(Folder, Place)
        ->  true
        ;   exists_directory(Place)
        ->  folder_removed(Folder)
        ;   rename_file(Folder, Place)  % says why not
        )
    ).

renamed(From, To) :-
    catch(rename_file(From, To), error(_, _), fail).

%!  result_place(+Store, +Key, -Place) is det.
%
%   Place is the folder of the result of Key, if there is one.

result_place(Store, Key, Place) :-
    key_place(Store, Key, Parent, Name),
    atomic_list_concat([Parent, /, Name], Place).

%!  failure_written(+Store, +Key, +Text) is det.
%!  failure_stored(+Store, +Key, -Text) is semidet.
%!  failure_removed(+Store, +Key) is det.
%
%   Text is the line that says why the job of Key failed.

failure_written(Store, Key, Text) :-
    key_place(Store, Key, Parent, Name),
    made_folder(Parent),
    atomic_list_concat([Parent, /, Name, '.failed'], File),
    writing(File, text, sg_batch_store:line_written(Text)).

:- public line_written/2.

line_written(Text, Out) :-
    format(Out, '~w~n', [Text]).

failure_stored(Store, Key, Text) :-
    failure_file(Store, Key, File),
    exists_file(File),
    setup_call_cleanup(
        open(File, read, In, [encoding(utf8)]),
        read_string(In, "\n", "", _, Text),
        close(In)).

failure_removed(Store, Key) :-
    failure_file(Store, Key, File),
    (   exists_file(File)
    ->  catch(delete_file(File), error(existence_error(_, _), _), true)
    ;   true
    ).

failure_file(Store, Key, File) :-
    key_place(Store, Key, Parent, Name),
    atomic_list_concat([Parent, /, Name, '.failed'], File).


                /*******************************
                *             LINKS            *
                *******************************/

%!  linked(+Store, +Way, +Place, +File, +Path) is det.
%
%   Path, in the folder of results, is the File in Place of the store: a link,
%   or a copy if Way is `copy`.
%
%   @error cannot_write(Path, Why)

linked(store(Out, Own), Way, Place, File, Path) :-
    atomic_list_concat([Out, /, Path], To),
    atomic_list_concat([Place, /, File], From),
    (   Way == link
    ->  relative_link(Out, Path, From, Target),
        link_there(Own, Target, To)
    ;   copy_there(Own, From, To)
    ).

%   relative_link(Out, Path, From, Target): from the folder of Out/Path to From,
%   so that the folder of results may be moved.

relative_link(Out, Path, From, Target) :-
    atom_concat(Out, /, Prefix),
    atom_concat(Prefix, Rest, From),
    atomic_list_concat(Parts, /, Path),
    append(Folders, [_], Parts),
    maplist(up, Folders, Ups),
    append(Ups, [Rest], Words),
    atomic_list_concat(Words, /, Target).

up(_, '..').

link_there(_, Target, To) :-
    read_link(To, Target, _),
    !.
link_there(_, Target, To) :-
    catch(link_file(Target, To, symbolic), error(_, _), fail),
    !.
link_there(Own, Target, To) :-          % there is another one, or no folder
    atom_concat(Own, '/link', New),
    placed(To, New, link_file(Target, New, symbolic)).

copy_there(_, From, To) :-
    exists_file(To),
    \+ read_link(To, _, _),
    same_bytes(From, To),
    !.
copy_there(Own, From, To) :-
    atom_concat(Own, '/copy', New),
    placed(To, New, bytes_copied(From, New)).

:- meta_predicate placed(+, +, 0).

%   placed(To, New, Goal): Goal makes New, which gets the name To at once.

placed(To, New, Goal) :-
    (   exists_directory(To)
    ->  throw(error(cannot_write(To, directory), _))
    ;   true
    ),
    catch(delete_file(New), error(_, _), true),
    catch(Goal, error(Formal, Context), not_placed(To, Formal, Context)),
    catch(rename_file(New, To), error(_, _),
          ( file_directory_name(To, Folder),
            made_folder(Folder),
            catch(rename_file(New, To), error(Formal1, Context1),
                  not_placed(To, Formal1, Context1)) )).

not_placed(To, Formal, Context) :-
    (   Formal = permission_error(_, _, _)
    ->  Why = permission
    ;   nonvar(Context),
        Context = context(_, Text),
        nonvar(Text)
    ->  (   sub_atom(Text, _, _, _, 'No space left')
        ->  Why = full
        ;   Why = Text
        )
    ;   Why = Formal
    ),
    throw(error(cannot_write(To, Why), _)).

bytes_copied(From, To) :-
    setup_call_cleanup(
        open(From, read, In, [type(binary)]),
        setup_call_cleanup(
            open(To, write, Out, [type(binary)]),
            copy_stream_data(In, Out),
            close(Out)),
        close(In)).

same_bytes(A, B) :-
    size_file(A, Size),
    size_file(B, Size),
    setup_call_cleanup(
        open(A, read, InA, [type(binary)]),
        setup_call_cleanup(
            open(B, read, InB, [type(binary)]),
            same_stream(InA, InB),
            close(InB)),
        close(InA)).

same_stream(A, B) :-
    read_string(A, 1_000_000, Text),
    read_string(B, 1_000_000, Text),
    (   Text == ""
    ->  true
    ;   same_stream(A, B)
    ).
