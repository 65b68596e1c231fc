:- module(sg_job_key,
          [ program_digest/1,           % -Digest
            job_inputs/3,               % +Job, +Folder, -Inputs
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
    (   exists_file(Path)
    ->  known_digest(Path, Digest)
    ;   Digest = none                   % the goal of a query
    ).

%   known_digest(Path, Digest): reckoned once, unless the file has changed.

:- dynamic known/4.                     % Path, Time, Size, Digest

known_digest(Path, Digest) :-
    time_file(Path, Time),
    size_file(Path, Size),
    (   known(Path, Time, Size, Digest0)
    ->  Digest = Digest0
    ;   file_digest(Path, Digest),
        retractall(known(Path, _, _, _)),
        assertz(known(Path, Time, Size, Digest))
    ).

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

%!  job_key(+Job, +Inputs, +Made, -Key:atom) is det.
%
%   Key is that of Job with its Inputs; Made is what else results depend on: the
%   program and the language.

job_key(job(_, _, _, Verb, _, Options, _, _), Inputs, Made, Key) :-
    format(string(Text), '~q', [job(Made, Verb, Options, Inputs)]),
    sha_hash(Text, Bytes, [algorithm(sha256), encoding(utf8)]),
    hexadecimal(Bytes, Key).

hexadecimal(Bytes, Text) :-
    hexadecimal_codes(Bytes, Codes),
    atom_codes(Text, Codes).

hexadecimal_codes([], []).
hexadecimal_codes([Byte|Bytes], [C1,C2|Codes]) :-
    High is Byte >> 4,
    Low is Byte /\ 15,
    digit(High, C1),
    digit(Low, C2),
    hexadecimal_codes(Bytes, Codes).

digit(N, C) :-
    (   N < 10
    ->  C is 0'0+N
    ;   C is 0'a+N-10
    ).
