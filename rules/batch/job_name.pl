:- module(sg_job_name,
          [ name_text/2,                % +Name, -Text
            file_stem/2,                % +Text, -Stem
            stem_path/3,                % +Pattern, +Stem, -Path
            output_fault/2,             % +Pattern, -Fault
            in_shard/3                  % +Text, +I, +N
          ]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(sha), [sha_hash/3]).
/** <module> The name of a job, and the files that are named after it.
*/

%!  name_text(+Name, -Text:atom) is semidet.
%
%   Text is the term Name, an atom, a number or a compound of these, in one
%   way: two names are equal if their texts are. Fails also for what is too
%   long for a name.

name_text(Name, Text) :-
    longest_name(Most),
    write_length(Name, _, [quoted(true), max_length(Most)]),
    ground(Name),
    Name \== [],
    plain(Name),
    format(atom(Text), '~q', [Name]).

%   longest_name(Most): characters; a file keeps 180 octets of them at most.

longest_name(1000).

plain(Name) :-
    (   atom(Name)
    ;   integer(Name)
    ;   float(Name)
    ),
    !.
plain(Name) :-
    compound(Name),
    \+ is_dict(Name),
    compound_name_arguments(Name, _, Arguments),
    Arguments \== [],
    forall(member(Argument, Arguments), plain(Argument)).

%!  file_stem(+Text, -Stem) is semidet.
%
%   Stem is what the file of the job with the name Text is called, without an
%   ending: letters, digits, `.`, `_` and `-`; hole(7) is hole-7. Fails if there
%   is no letter or digit in Text, or Stem is too long for a file.

file_stem(Text, Stem) :-
    atom_codes(Text, Codes0),
    safe_codes(Codes0, Codes1),
    first_safe(Codes1, Codes),
    (   member(C, Codes),
        code_type(C, alnum)
    ->  true
    ),
    atom_codes(Stem, Codes),
    (   length(Codes, Length),
        Length =< 45
    ->  true
    ;   octets(Stem, N),
        N =< 180
    ).

octets(Text, N) :-
    setup_call_cleanup(
        open_null_stream(Out),
        ( set_stream(Out, encoding(utf8)),
          write(Out, Text),
          byte_count(Out, N) ),
        close(Out)).

safe_codes([], []).
safe_codes([C|Cs0], Cs) :-
    (   kept(C)
    ->  Cs = [C|Cs1]
    ;   parting(C)
    ->  Cs = [0'-|Cs1]
    ;   Cs = Cs1
    ),
    safe_codes(Cs0, Cs1).

kept(C) :-
    (   C >= 0'a, C =< 0'z
    ;   C >= 0'0, C =< 0'9
    ;   C >= 0'A, C =< 0'Z
    ;   C =:= 0'_
    ;   C =:= 0'-
    ;   C =:= 0'.
    ;   C > 127, code_type(C, alnum)
    ),
    !.

parting(0'().
parting(0',).
parting(0'/).
parting(0':).
parting(0'=).

%   No file is hidden, none looks like an option.

first_safe([C|Cs], Codes) :-
    (   memberchk(C, `.-`)
    ->  Codes = [0'_,C|Cs]
    ;   Codes = [C|Cs]
    ).

%!  stem_path(+Pattern, +Stem, -Path) is det.
%
%   Path is Pattern with Stem for its `%`; what has none is as it is.

stem_path(Pattern, Stem, Path) :-
    (   sub_atom(Pattern, Before, 1, After, '%')
    ->  sub_atom(Pattern, 0, Before, _, Left),
        sub_atom(Pattern, _, After, 0, Right),
        atomic_list_concat([Left, Stem, Right], Path)
    ;   Path = Pattern
    ).

%!  output_fault(+Pattern, -Fault) is semidet.
%
%   Fault is output(Pattern): not one `%` in its last part, or it leads out of
%   the folder of results, or into the store.

output_fault(Pattern, output(Pattern)) :-
    \+ ( atomic_list_concat(Parts, /, Pattern),
         append(Folders, [File], Parts),
         atomic_list_concat([_, _], '%', File),
         forall(member(Folder, Folders),
                ( \+ sub_atom(Folder, _, _, _, '%'),
                  \+ memberchk(Folder, ['', '.', '..']) )),
         \+ Parts = [store|_],
         \+ sub_atom(File, 0, _, _, '.') ).

%!  in_shard(+Text, +I, +N) is semidet.
%
%   True if the job with the name Text belongs to the shard I of N: a matter of
%   its name alone.

in_shard(_, 1, 1) :-
    !.
in_shard(Text, I, N) :-
    sha_hash(Text, [A, B, C, D|_], [algorithm(sha256), encoding(utf8)]),
    I =:= (A<<24 + B<<16 + C<<8 + D) mod N + 1.
