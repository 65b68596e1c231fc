/* Texts that are opened: bytes that are no UTF-8, what cannot be read, copies
   of what can be read once only. */
:- use_module(library(plunit)).
:- use_module(library(filesex)).
:- use_module(library(process)).
:- use_module(library(readutil)).
:- use_module(rules(text_file)).

:- dynamic warned/2.                    % File, Line
:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_utf8(File, Line)), warning, _) :-
    assertz(warned(File, Line)).

%   with_file(Octets, File, Goal): while Goal runs, File has the Octets.

:- meta_predicate with_file(+, -, 0).

with_file(Octets, File, Goal) :-
    setup_call_cleanup(
        tmp_file(text, File),
        ( setup_call_cleanup(open(File, write, Out, [type(binary)]),
                             format(Out, '~s', [Octets]),
                             close(Out)),
          once(Goal)
        ),
        delete_file(File)).

terms(Stream, Terms) :-
    read_term(Stream, Term, []),
    (   Term == end_of_file
    ->  Terms = []
    ;   Terms = [Term|Rest],
        terms(Stream, Rest)
    ).

%   warnings(Octets, Warned): what is told of a text of these Octets in which
%   all facts are read: Named-Line.

warnings(Octets, Warned) :-
    retractall(warned(_, _)),
    with_file(Octets, File,
              with_text(facts, File, text(_, _, Stream),
                        terms(Stream, _))),
    findall(Named-Line,
            ( warned(File0, Line),
              (   File0 == File
              ->  Named = file
              ;   Named = File0
              ) ),
            Warned).

:- begin_tests(text_file).

test(utf8, Warned == []) :-
    warnings(`a('\xc3\\xa9\').\n`, Warned).   % two octets, each a code
test(once, Warned == [file-2]) :-
    warnings(`a(1).\nb('\xe9\').\nc('\xe9\').\nd('\xe9\\xe9\').\n`, Warned).
test(each_file, Warned == [file-1]) :-
    warnings(`b('\xe9\').\n`, _),
    warnings(`c('\xe9\').\n`, Warned).
test(again, Seen == []) :-
    retractall(warned(_, _)),
    with_file(`a('\xe9\').\n`, File,
              with_text_again(File, Stream, terms(Stream, [a(_)]))),
    findall(W, warned(W, _), Seen).

test(missing, error(model_error(cannot_read(missing)), location(File, 0, 0))) :-
    tmp_file(text, File),
    with_text(facts, File, _, true).
test(folder,
     error(model_error(cannot_read(directory)), location(Folder, 0, 0))) :-
    tmp_file(text, Folder),
    setup_call_cleanup(
        make_directory(Folder),
        with_text(facts, Folder, _, true),
        delete_directory(Folder)).
test(long_name,
     error(model_error(cannot_read(long_name)), location(File, 0, 0))) :-
    length(Codes, 5000),
    maplist(=(0'a), Codes),
    atom_codes(File, Codes),
    with_text(facts, File, _, true).

test(links, error(model_error(cannot_read(links)), location(File, 0, 0))) :-
    tmp_file(text, File),
    setup_call_cleanup(
        link_file(File, File, symbolic),
        with_text(facts, File, _, true),
        delete_file(File)).

%   A pipe is copied to a file of its own, which vanishes.

test(pipe, true([Name,Terms,Exists] == [Pipe,[a(1),b(2)],false])) :-
    tmp_file(text, Pipe),
    process_create(path(mkfifo), [Pipe], []),
    process_create(path(sh), ['-c','printf "a(1).\nb(2).\n" > "$0"',Pipe],
                   [process(Pid)]),
    with_text(facts, Pipe, text(Name, Path, Stream),
              ( terms(Stream, Terms), exists_file(Path) )),
    process_wait(Pid, exit(0)),
    delete_file(Pipe),
    (   exists_file(Path)
    ->  Exists = true
    ;   Exists = false
    ).

:- end_tests(text_file).
