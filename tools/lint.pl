/* Finds exports of the rules without documentation, predicates of the rules
   that only tests reach, tolerances without a name, undefined or useless code,
   tabs, lines that are too wide, and programs that are not ASCII and do not say
   so (where the locale is C they would be read otherwise). Warnings of the
   compiler count:

       swipl -f none -p foreign=build --on-warning=status --on-error=status \
             tools/lint.pl
*/
:- module(sg_lint, []).
:- use_module(library(pldoc)).
:- doc_collect(true).
:- use_module(library(pldoc/doc_process), [doc_comment/4]).
:- use_module(library(check)).
:- use_module(library(occurs)).
:- use_module(library(pcre), [re_match/2]).
:- use_module(library(readutil)).
:- use_module(tested, [untested/2]).
:- use_module(unreached, [load_oracles/0, unreached/1]).

:- prolog_load_context(directory, Tools),
   atom_concat(Tools, '/../rules/sanggwan.pl', Facade),
   load_files(user:Facade, [silent(true)]),
   atom_concat(Tools, '/../rules/command/cli.pl', Cli),
   load_files(sg_lint_cli:Cli, [silent(true), imports([])]),
   load_oracles.

:- initialization(main, main).

main :-
    list_undefined([module_class([user])]),
    list_void_declarations,
    findall(What, finding(What), Findings0),
    sort(Findings0, Findings),
    forall(member(What, Findings), format(user_error, "~w~n", [What])),
    (   Findings == []
    ->  halt
    ;   halt(1)
    ).

finding(What) :-
    module_property(Module, exports(Exports)),
    sub_atom(Module, 0, _, _, sg_),
    module_property(Module, file(File)),
    member(Folder, ['/rules/','/tests/oracle/']),
    sub_atom(File, _, _, _, Folder),
    Module \== sg_sanggwan,
    member(Name/Arity, Exports),
    functor(Head, Name, Arity),
    \+ predicate_property(Module:Head, imported_from(_)),
    \+ documented(Module, Name, Arity),
    format(atom(What), '~w: ~w/~w is exported without documentation',
           [File, Name, Arity]).
finding(What) :-
    current_module(Module),
    sub_atom(Module, 0, _, _, sg_),
    module_property(Module, file(File)),
    sub_atom(File, _, _, _, '/rules/'),
    current_predicate(_, Module:Head),
    \+ predicate_property(Module:Head, imported_from(_)),
    predicate_property(Module:Head, number_of_clauses(_)),
    \+ predicate_property(Module:Head, dynamic),
    clause(Module:Head, Body),
    Body \== true,
    sub_term(Number, Head-Body),
    float(Number),
    between_tolerances(abs(Number)),
    functor(Head, Name, Arity),
    format(atom(What), '~q: ~w: a tolerance has a name (rules/near.pl)',
           [Module:Name/Arity, Number]).
finding(What) :-
    untested(File, Fault),
    format(atom(What), '~w: ~w', [File, Fault]).
finding(What) :-
    unreached(PI),
    format(atom(What), '~q: nothing that a user can do runs it', [PI]).
finding(What) :-
    member(Pattern, ['rules/*.pl', 'rules/*/*.pl',
                     'facts/*.pl', 'facts/*/*.pl',
                     'tests/*.pl', 'tests/oracle/*.pl',
                     'tests/rules/*.pl*', 'tests/rules/*/*.pl*',
                     'tools/*.pl', 'bench/*.pl', 'docs/*/*.pl']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    read_file_to_string(File, Text, [encoding(utf8)]),
    split_string(Text, "\n", "", Lines),
    nth1(N, Lines, Line),
    line_fault(Line, Fault),
    format(atom(What), '~w:~d: ~w', [File, N, Fault]).

finding(What) :-
    member(Pattern, ['rules/*.pl', 'rules/*/*.pl',
                     'tests/*.pl', 'tests/oracle/*.pl',
                     'tests/rules/*.pl*', 'tests/rules/*/*.pl*',
                     'tools/*.pl', 'bench/*.pl']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    read_file_to_string(File, Text, [encoding(utf8)]),
    \+ sub_string(Text, _, _, _, ":- encoding(utf8)."),
    string_codes(Text, Codes),
    max_list(Codes, Most),
    Most > 127,
    format(atom(What), '~w: not ASCII, and without :- encoding(utf8)', [File]).

%   What C has once: the growing array, the binary search, the table of open
%   addressing, and the order of numbers.

finding(What) :-
    member(Pattern, ['engine/*.[ch]', 'c_kernels/*.[ch]',
                     'c_kernels/*/*.[ch]']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    read_file_to_string(File, Text, [encoding(utf8)]),
    split_string(Text, "\n", "", Lines),
    nth1(N, Lines, Line),
    once_in(Regex, Homes, Use),
    \+ memberchk(File, Homes),
    re_match(Regex, Line),
    format(atom(What), '~w:~d: ~w', [File, N, Use]).

%   The names of files are made of words of the glossary and of plain ones, in
%   the singular or the plural.

finding(What) :-
    known_words(Known),
    member(Pattern, ['rules/*.pl', 'rules/*/*.pl', 'engine/*.[ch]',
                     'c_kernels/*.[ch]', 'c_kernels/*/*.[ch]']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    file_base_name(File, Base),
    file_name_extension(Name, _, Base),
    split_string(Name, "_", "0123456789", Words),
    member(Word, Words),
    \+ known_word(Word, Known),
    format(atom(What), '~w: ~w is neither in GLOSSARY.md nor in \c
                        tools/plain_words.txt', [File, Word]).

known_word(Word, Known) :-
    memberchk(Word, Known),
    !.
known_word(Word, Known) :-
    string_concat(One, "s", Word),
    memberchk(One, Known).

known_words(Known) :-
    read_file_to_string('tools/plain_words.txt', Text, []),
    split_string(Text, "\n", " ", Plain),
    read_file_to_string('GLOSSARY.md', Glossary, [encoding(utf8)]),
    split_string(Glossary, "\n", "", Lines),
    findall(Word,
            ( member(Line, Lines),
              split_string(Line, "|", " ", [_,Term|_]),
              split_string(Term, " ,-", " ,-", Words),
              member(Word, Words)
            ),
            Terms),
    append(Plain, Terms, Known).

%   once_in(Regex, Files, What): what a line of C shows that does again what
%   stands in one place; these files may.

once_in("\\brealloc\\(",
        [ 'engine/list.c',
          'engine/version.c',   % a directory: its length is no room to grow
          'c_kernels/call.c'    % what a call frees at its end
        ],
        'arrays grow by engine/list.h').
once_in("^ *(size_t|u?int32_t|unsigned|int) \\w+ = [^;]* / 2;",
        [],
        'searched by SG_SEARCH (engine/search.h)').
once_in("\\+ 1\\) & ",
        [ 'c_kernels/rows/key_table.c',
          'c_kernels/solid/solid_border.c'  % half-edges, that leave again
        ],
        'tables are rows/key_table.h').
once_in("u?int(32|64)_t x = \\*\\(const u?int(32|64)_t \\*\\)a, y",
        ['engine/search.c'],
        'numbers are compared by engine/search.h').

%   What is less is rounding of one operation, what is more a size.

between_tolerances(Number) :-
    Number > 1.0e-14,
    Number < 2.0e-5.

documented(Module, Name, Arity) :-
    doc_comment(Objects, _, _, _),
    documents(Objects, Module:Described),
    (   Described = Name/Arity
    ;   Described = Name//Arity0,
        Arity =:= Arity0 + 2
    ),
    !.

documents(Objects, Object) :-
    is_list(Objects),
    !,
    member(Object, Objects).
documents(Object, Object).

line_fault(Line, 'a tab') :-
    sub_string(Line, _, _, _, "\t").
line_fault(Line, 'wider than 80 columns') :-
    string_length(Line, Length),
    Length > 80.
