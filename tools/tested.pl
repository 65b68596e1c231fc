/* Which rules and kernels no test has the name of, nor names. A test names a
   file if it imports or includes it, or writes its name with its ending; or in
   a comment `covers: NAME, NAME` at its head if what it tests runs through that
   file. What a file X_private.h has, X has.
*/
:- module(sg_tested,
          [ untested/2                  % -File, -What
          ]).
:- use_module(library(lists)).
:- use_module(library(readutil)).

%!  untested(-File, -What) is nondet.
%
%   True when File is of rules/ or a header of c_kernels/ and no test names it,
%   or a test that says that it covers what is not there.

untested(File, 'no test has its name or names it (covers: NAME)') :-
    findall(Name, named(Name), Names0),
    sort(Names0, Names),
    subject(File, Name),
    \+ memberchk(Name, Names).
untested(File, What) :-
    findall(Name, subject(_, Name), Names0),
    sort(Names0, Names),
    test_text(File, Text),
    covered(Text, Name),
    \+ memberchk(Name, Names),
    \+ source(Name),
    format(atom(What), 'covers: ~w: there is no such file', [Name]).

subject(File, Name) :-
    member(Pattern, ['rules/*.pl', 'rules/*/*.pl', 'c_kernels/*.h',
                     'c_kernels/*/*.h']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    base_name(File, Name).

source(Name) :-
    member(Pattern, ['c_kernels/*/~w.c', 'engine/~w.c']),
    format(atom(Wild), Pattern, [Name]),
    expand_file_name(Wild, [File|_]),
    exists_file(File).

%   base_name(File, Name): without folder and ending; that of X for X_private.

base_name(File, Name) :-
    file_base_name(File, Base),
    file_name_extension(Name0, _, Base),
    (   atom_concat(Name, '_private', Name0)
    ->  true
    ;   Name = Name0
    ).

named(Name) :-
    test_file(File),
    base_name(File, Base),
    (   atom_concat(Name, '_test', Base)
    ->  true
    ;   Name = Base
    ).
named(Name) :-
    test_text(File, Text),
    (   covered(Text, Name)
    ;   \+ file_name_extension(_, txt, File),   % transcripts name models
        mentioned(Text, Name)
    ).

test_file(File) :-
    member(Pattern, ['tests/*', 'tests/*/*', 'tests/*/*/*']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    file_name_extension(_, Ending, File),
    memberchk(Ending, [plt,pl,sh,c,h,py,txt]),
    \+ sub_atom(File, _, _, _, 'tests/oracle/').

test_text(File, Text) :-
    test_file(File),
    read_file_to_string(File, Text, [encoding(utf8)]).

%   covered(Text, Name): after `covers:`, up to the end of the line.

covered(Text, Name) :-
    sub_string(Text, Before, _, _, "covers: "),
    Start is Before+8,
    sub_string(Text, Start, _, 0, Rest),
    once(sub_string(Rest, End, 1, _, "\n")),
    sub_string(Rest, 0, End, _, Line),
    split_string(Line, ",", " */", Names),
    member(String, Names),
    String \== "",
    atom_string(Name, String).

%   mentioned(Text, Name): as rules(Name), folder/Name, Name.pl, Name.h or
%   Name.c.

mentioned(Text, Name) :-
    sub_string(Text, Before, _, _, "rules("),
    Start is Before+6,
    sub_string(Text, Start, 40, _, Rest),
    once(sub_string(Rest, End, 1, _, ")")),
    sub_atom(Rest, 0, End, _, Name).

mentioned(Text, Name) :-
    split_string(Text, " \t\n,;:()[]{}'\"<>`|=*%", "./", Words),
    sort(Words, Set),
    member(Word, Set),
    (   sub_string(Word, _, _, _, "/")
    ;   member(Ending, [".pl",".h",".c"]),
        string_concat(_, Ending, Word)
    ),
    atom_string(File, Word),
    base_name(File, Name).
