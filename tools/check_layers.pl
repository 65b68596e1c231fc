/* Proves that calls go down only (ARCHITECTURE.md, 1), without loading
   anything: from the imports of the rules and the #include lines of the C.

       swipl -f none tools/check_layers.pl
*/
:- module(sg_check_layers, []).
:- use_module(library(prolog_xref)).
:- use_module(library(readutil)).

:- initialization(main, main).

main :-
    findall(Fault, fault(Fault), Faults0),
    sort(Faults0, Faults),
    forall(member(File-What, Faults),
           format(user_error, "~w: ~w~n", [File, What])),
    (   Faults == []
    ->  true
    ;   halt(1)
    ).

fault(File-What) :-
    expand_file_name('rules/*.pl', Files),
    member(File, Files),
    absolute_file_name(File, Path),
    xref_source(Path, [silent(true)]),
    file_base_name(File, Name),
    rule_fault(Name, Path, What).
fault(File-What) :-
    expand_file_name('{engine,c_kernels}/*.{c,h}', Files),
    member(File, Files),
    file_directory_name(File, Layer),
    include_line(File, Included),
    include_fault(Layer, File, Included),
    format(atom(What), 'may not include ~w', [Included]).

%   The doors import no rule; only the top imports what stands above rules.

rule_fault(Name, Path, What) :-
    imported_file(Path, Other),
    (   door(Name)
    ;   top(Other),
        \+ top(Name)
    ),
    format(atom(What), 'may not import ~w', [Other]).
rule_fault(Name, Path, 'only store.pl and kernel.pl load foreign code') :-
    \+ door(Name),
    xref_called(Path, use_foreign_library(_), _).

imported_file(Path, Other) :-
    absolute_file_name(rules, Rules),
    xref_defined(Path, _, imported(From)),
    file_directory_name(From, Rules),
    file_base_name(From, Other).

door('store.pl').
door('kernel.pl').

top('cli.pl').
top('embedding.pl').
top('verbs.pl').
top('repl.pl').
top('sanggwan.pl').

include_line(File, Included) :-
    read_file_to_string(File, Text, []),
    split_string(Text, "\n", "\r", Lines),
    member(Line, Lines),
    string_concat("#include ", Rest, Line),
    split_string(Rest, "\"<>", "", [_,Included0|_]),
    atom_string(Included, Included0).

%   Kernels know neither store nor Prolog; the store knows no geometry. What
%   a kernel asks of its caller (poll.h) and the view of a column (column.h)
%   are for both.

include_fault(_, File, Included) :-
    sub_atom(Included, 0, _, _, 'SWI-'),
    \+ prolog_side(File).
include_fault(c_kernels, File, Included) :-
    sub_atom(Included, 0, _, _, '../engine/'),
    \+ prolog_side(File).
include_fault(engine, File, Included) :-
    sub_atom(Included, 0, _, After, '../c_kernels/'),
    sub_atom(Included, _, After, 0, Header),
    \+ memberchk(Header, ['poll.h', 'column.h']),
    \+ prolog_side(File).

prolog_side(File) :-
    file_base_name(File, Base),
    file_name_extension(Name, _, Base),
    (   sub_atom(Name, _, _, 0, '4pl')
    ;   memberchk(Name, [glue, install, boot, start, engine, host, main])
    ),
    !.
