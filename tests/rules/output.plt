:- encoding(utf8).
:- module(test_output, []).
:- use_module(library(plunit)).
:- use_module(library(filesex)).
:- use_module(library(readutil)).
:- use_module(library(time)).
:- use_module(library(yall)).
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

shown(Folder, Names) :-
    holds(Folder, All),
    exclude([Name]>>sub_atom(Name, 0, _, _, '.'), All, Names).

:- dynamic seen_text/2.

seen_text(File) :-
    text(File, Text),
    assertz(seen_text(File, Text)).

scratched(File) :-
    writing(File, binary, bytes).

wait_for(File) :-
    between(1, 200, _),
    (   access_file(File, exist)
    ->  !
    ;   sleep(0.01),
        fail
    ).
wait_for_bytes(File, N) :-
    between(1, 200, _),
    (   size_file(File, N)
    ->  !
    ;   sleep(0.01),
        fail
    ).

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
                   error(cannot_write(D, directory))]) :-
    writing(D, text, said(new)).
test(type, error(_)) :-
    writing(a, words, nl).
test(full, error(cannot_write('/dev/full', full))) :-
    writing('/dev/full', text, much).
test(full_at_the_end, error(cannot_write('/dev/full', full))) :-
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
test(together, [setup(folder(D, F)), cleanup(gone(D)),
                true(Seen-Texts-Names
                     == ['a.svg']-["1", "2"]-['a.svg', 'b.svg'])]) :-
    directory_file_path(D, 'b.svg', G),
    files_together(( writing(F, text, said(1)),
                     writing(G, text, said(2)),
                     text(F, "old"),
                     shown(D, Seen) )),
    maplist(text, [F,G], Texts),
    holds(D, Names).
test(none, [setup(folder(D, F)), cleanup(gone(D))]) :-
    directory_file_path(D, 'b.svg', G),
    forall(member(End, [fail, throw(oops), writing('/no/such/c', text, nl)]),
           keeps_old(D, F,
                     \+ catch(files_together(( writing(F, text, said(1)),
                                               writing(G, text, said(2)),
                                               End )),
                              _, fail))).
test(third_refused, [setup(folder(D, F)), cleanup(gone(D)),
                     true(E-Text-Names == cannot_write(H, directory)-"old"
                                          -['a.svg','c.svg'])]) :-
    directory_file_path(D, 'b.svg', G),
    directory_file_path(D, 'c.svg', H),
    catch(files_together(( writing(F, text, said(1)),
                           writing(G, text, said(2)),
                           writing(H, text, said(3)),
                           make_directory(H) )),
          error(E, _), true),
    text(F, Text),
    holds(D, Names).
test(interrupted_together, [setup(folder(D, F)), cleanup(gone(D))]) :-
    keeps_old(D, F,
              catch(call_with_time_limit(0.05,
                        files_together(( writing(F, text, said(1)),
                                         repeat, fail ))),
                    time_limit_exceeded, true)).
test(nested, [setup(folder(D, F)), cleanup(gone(D))]) :-
    keeps_old(D, F,
              \+ files_together(( files_together(writing(F, text, said(1))),
                                  fail ))).
test(caught_inside, [setup(folder(D, F)), cleanup(gone(D)), true(T == "2")]) :-
    files_together(( catch(writing(F, text, said_and_threw), oops, true),
                     writing(F, text, said(2)) )),
    text(F, T).
test(said_afterwards, [setup(folder(D, F)), cleanup(gone(D)),
                       true(Ts == ["old","new","new"])]) :-
    when_written(seen_text(F)),
    files_together(( writing(F, text, said(new)),
                     when_written(seen_text(F)),
                     when_written(seen_text(F)) )),
    findall(T, retract(test_output:seen_text(F, T)), Ts).
test(copied, [setup(folder(D, F)), cleanup(gone(D)),
              true(Codes == [0, 255, 10, 13])]) :-
    directory_file_path(D, pipe, Pipe),
    format(atom(Make), 'mkfifo ~w && cat ~w >~w &', [Pipe, Pipe, F]),
    shell(Make, 0),
    wait_for(Pipe),
    copied_to(Pipe, bin, scratched),
    wait_for_bytes(F, 4),
    read_file_to_codes(F, Codes, [type(binary)]).
test(copied_not, [setup(folder(D, F)), cleanup(gone(D)),
                  true(E == cannot_write('/dev/full', full))]) :-
    keeps_old(D, F,
              catch(files_together(( writing(F, text, said(1)),
                                     copied_to('/dev/full', bin, scratched) )),
                    error(E, _), true)).
test(long_name, [setup(folder(D, _)), cleanup(gone(D)),
                 true(T-E == "new"-cannot_write(Longer, long_name))]) :-
    length(Codes0, 84),
    maplist(=(0'가), Codes0),
    atom_codes(Korean, Codes0),
    atom_concat(Korean, abc, Name),             % 255 bytes
    atom_concat(Name, d, NameLonger),
    directory_file_path(D, Name, File),
    directory_file_path(D, NameLonger, Longer),
    writing(File, text, said(new)),
    text(File, T),
    catch(writing(Longer, text, said(new)), error(E, _), true).
test(circle, [setup(folder(D, _)), cleanup(gone(D)),
              error(cannot_write(Link, links))]) :-
    directory_file_path(D, link, Link),
    link_file(link, Link, symbolic),
    writing(Link, text, said(new)).
test(link_to_nothing, [setup(folder(D, _)), cleanup(gone(D)),
                       true(T == "new")]) :-
    directory_file_path(D, link, Link),
    directory_file_path(D, 'b.svg', File),
    link_file('b.svg', Link, symbolic),
    writing(Link, text, said(new)),
    text(File, T).
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
    catch(writing(File, text, much), error(cannot_write(Blamed, full), _),
          true),
    keeps_old(Disk, File, Blamed == File).

:- end_tests(output).
