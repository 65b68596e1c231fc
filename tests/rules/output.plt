:- encoding(utf8).
:- module(test_output, []).
:- use_module(library(plunit)).
:- use_module(library(filesex)).
:- use_module(library(readutil)).
:- use_module(library(time)).
:- use_module(rules(output)).

% An empty folder with an old file in it.
folder(Folder, File) :-
    tmp_file(sanggwan, Folder),
    make_directory(Folder),
    directory_file_path(Folder, 'a.svg', File),
    writing(File, text, said(old)).

gone(Folder) :-
    delete_directory_and_contents(Folder).

% What the folder holds, hidden files too.
holds(Folder, Names) :-
    directory_files(Folder, All),
    subtract(All, ['.', '..'], Names0),
    msort(Names0, Names).

text(File, Text) :-
    read_file_to_string(File, Text, [encoding(utf8)]).

% Writers.
said(What, Out) :-
    write(Out, What).
said_and_failed(Out) :-
    write(Out, new),
    fail.
said_and_threw(Out) :-
    write(Out, new),
    throw(oops).
never_done(Out) :-
    write(Out, new),
    repeat,
    fail.
several(Out) :-
    member(X, [1, 2]),
    write(Out, X).
bytes(Out) :-
    maplist(put_byte(Out), [0, 255, 10, 13]).
much(Out) :-
    forall(between(1, 20000, _), write(Out, 'much of it, ')).

:- begin_tests(output).

:- meta_predicate keeps_old(+, +, 0).
keeps_old(Folder, File, Goal) :-
    call(Goal),
    text(File, "old"),
    holds(Folder, ['a.svg']).

test(text, [setup(folder(D, F)), cleanup(gone(D)),
            true(Text-Names == "상관 é"-['a.svg'])]) :-
    writing(F, text, said('상관 é')),
    text(F, Text),
    holds(D, Names).
test(binary, [setup(folder(D, F)), cleanup(gone(D)),
              true(Codes == [0, 255, 10, 13])]) :-
    writing(F, binary, bytes),
    read_file_to_codes(F, Codes, [type(binary)]).
test(once_only, [setup(folder(D, F)), cleanup(gone(D)), true(T == "1")]) :-
    writing(F, text, several),
    text(F, T).
test(fails, [setup(folder(D, F)), cleanup(gone(D))]) :-
    keeps_old(D, F, \+ writing(F, text, said_and_failed)).
test(raises, [setup(folder(D, F)), cleanup(gone(D))]) :-
    keeps_old(D, F, catch(writing(F, text, said_and_threw), oops, true)).
test(interrupted, [setup(folder(D, F)), cleanup(gone(D))]) :-
    keeps_old(D, F,
              catch(call_with_time_limit(0.05, writing(F, text, never_done)),
                    time_limit_exceeded, true)).
test(no_folder, error(existence_error(directory, '/no/such'))) :-
    writing('/no/such/a.svg', text, said(new)).
test(is_a_folder, [setup(folder(D, _)), cleanup(gone(D)),
                   error(permission_error(write, directory, D))]) :-
    writing(D, text, said(new)).
test(type, error(_)) :-
    writing(a, words, nl).
test(full, error(io_error(write, '/dev/full'))) :-
    writing('/dev/full', text, much).
test(full_at_the_end, error(io_error(write, '/dev/full'))) :-
    writing('/dev/full', text, said(little)).
test(a_device_stays) :-
    writing('/dev/null', text, much),
    \+ exists_file('/dev/null'),
    access_file('/dev/null', write).
test(link, [setup(folder(D, F)), cleanup(gone(D)), true(Text == "new")]) :-
    directory_file_path(D, link, Link),
    link_file(F, Link, symbolic),
    writing(Link, text, said(new)),
    read_link(Link, _, _),
    text(F, Text).
test(full_disk, [setup(folder(D, _)), cleanup(gone(D))]) :-
    directory_file_path(D, disk, Disk),
    make_directory(Disk),
    format(atom(Mount), 'mount -t tmpfs -o size=16k tiny ~w >/dev/null 2>&1',
           [Disk]),
    (   \+ shell(Mount, 0)
    ->  format("skipped: a full disk: cannot mount one here~n")
    ;   format(atom(Unmount), 'umount ~w', [Disk]),
        call_cleanup(full_disk(Disk), shell(Unmount))
    ).

full_disk(Disk) :-
    directory_file_path(Disk, 'a.svg', File),
    writing(File, text, said(old)),
    catch(writing(File, text, much), error(io_error(write, Blamed), _), true),
    keeps_old(Disk, File, Blamed == File).

:- end_tests(output).
