:- module(sg_job_key,
          [ program_digest/1,           % -Digest
            job_inputs/3,               % +Job, +Folder, -Inputs
            also_read/5,                % +Files, +Inputs, +Folder, +Start,
                                        % -Read
            read_as_before/1,           % +Read
            job_key/4                   % +Job, +Inputs, +Made, -Key
          ]).
:- use_module(job_words, [input_option/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(sha), [sha_new_ctx/2, sha_hash_ctx/4, sha_hash/3]).
/** <module> The key of a job: what its result depends on.

The key is the SHA-256 of the program, the verb, the options, the language, and
of each file that the job reads its name and its bytes. So equal keys have equal
results, and what is there under a key need not be made again.

What goals and rule files of users read beside these shows only when they run.
It stands with the result, which holds as long as these files are the same.
*/

%!  program_digest(-Digest) is det.
%
%   Digest is the SHA-256 of the running program, its rules in it.

program_digest(Digest) :-
    file_digest('/proc/self/exe', Digest).

%!  job_inputs(+Job, +Folder, -Inputs) is det.
%
%   Inputs are input(Name, Digest) of the files that Job reads, with Names as in
%   the manifest, which stands in Folder; Digest is `none` of what is no file.
%
%   @error existence_error, io_error: a file is not there, or cannot be read

job_inputs(job(_, _, _, Verb, Files, Options, _, _), Folder, Inputs) :-
    findall(File,
            ( member(Name-File, Options),
              input_option(Verb, Name) ),
            Others),
    append(Files, Others, All),
    maplist(input(Folder), All, Inputs).

input(Folder, File, input(File, Digest)) :-
    (   is_absolute_file_name(File)
    ->  Path = File
    ;   atomic_list_concat([Folder, /, File], Path)
    ),
    (   known_as_it_is(Path, Digest0)
    ->  Digest = Digest0
    ;   exists_file(Path)
    ->  known_digest(Path, Digest)
    ;   Digest = none                   % the goal of a query
    ).

%   known_digest(Path, Digest): reckoned once, unless the file has changed.

:- dynamic known/4.                     % Path, Time, Size, Digest

known_digest(Path, Digest) :-
    (   known_as_it_is(Path, Digest0)
    ->  Digest = Digest0
    ;   time_file(Path, Time),
        size_file(Path, Size),
        file_digest(Path, Digest),
        retractall(known(Path, _, _, _)),
        assertz(known(Path, Time, Size, Digest))
    ).

known_as_it_is(Path, Digest) :-
    known(Path, Time, Size, Digest),
    catch(( time_file(Path, Time),
            size_file(Path, Size) ),
          error(_, _), fail).

file_digest(Path, Digest) :-
    sha_new_ctx(Context, [algorithm(sha256), encoding(octet)]),
    setup_call_cleanup(
        open(Path, read, In, [type(binary)]),
        stream_digest(In, Context, [], Bytes),
        close(In)),
    hexadecimal(Bytes, Digest).

stream_digest(In, Context, Bytes0, Bytes) :-
    read_string(In, 1_000_000, Text),
    (   Text == "",
        Bytes0 \== []
    ->  Bytes = Bytes0
    ;   sha_hash_ctx(Context, Text, Context1, Bytes1),
        stream_digest(In, Context1, Bytes1, Bytes)
    ).

%!  also_read(+Files, +Inputs, +Folder, +Start, -Read) is semidet.
%
%   Read are dicts, `file` and `sha256`, of Files, texts, that a job with these
%   Inputs read beside them. Fails if one was changed after the time Start.

also_read([], _, _, _, Read) :-
    !,
    Read = [].
also_read(Files, Inputs, Folder, Start, Read) :-
    findall(Path,
            ( member(input(File, _), Inputs),
              absolute_file_name(File, Path, [relative_to(Folder)]) ),
            Own),
    findall(File,
            ( member(Text, Files),
              atom_string(File, Text),
              \+ memberchk(File, Own) ),
            Others),
    maplist(unchanged_since(Start), Others, Read).

unchanged_since(Start, File, _{file:File, sha256:Digest}) :-
    exists_file(File),
    time_file(File, Time),
    Time < Start,
    known_digest(File, Digest).

%!  read_as_before(+Read) is semidet.
%
%   The files of Read, dicts as of also_read/5, are as they were.

read_as_before(Read) :-
    forall(member(Dict, Read),
           ( atom_string(File, Dict.file),
             exists_file(File),
             known_digest(File, Digest),
             atom_string(Digest, Dict.sha256) )).

%!  job_key(+Job, +Inputs, +Made, -Key:atom) is det.
%
%   Key is that of Job with its Inputs; Made is what else results depend on: the
%   program and the language.

job_key(job(_, _, _, Verb, _, Options, _, _), Inputs, Made, Key) :-
    term_to_atom(job(Made, Verb, Options, Inputs), Text),
    sha_hash(Text, Bytes, [algorithm(sha256), encoding(utf8)]),
    hexadecimal(Bytes, Key).

hexadecimal(Bytes, Text) :-
    octet_names(Names),
    named_octets(Bytes, Names, Parts),
    atomic_list_concat(Parts, Text).

named_octets([], _, []).
named_octets([Byte|Bytes], Names, [Name|Parts]) :-
    Place is Byte+1,
    arg(Place, Names, Name),
    named_octets(Bytes, Names, Parts).

%   octet_names(Names): `00` to `ff`, made once.

:- dynamic octet_names_/1.

octet_names(Names) :-
    (   octet_names_(Names0)
    ->  Names = Names0
    ;   findall(Name,
                ( between(0, 255, Byte),
                  format(atom(Name), '~|~`0t~16r~2+', [Byte]) ),
                List),
        Names =.. [names|List],
        assertz(octet_names_(Names))
    ).
