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
    member(Pattern, ['rules/*.pl', 'rules/kernel/*.pl']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    absolute_file_name(File, Path),
    xref_source(Path, [silent(true)]),
    rule_name(Path, Name),
    rule_fault(Name, Path, What).
fault(File-What) :-
    expand_file_name('{engine,c_kernels}/*.{c,h,def}', Files),
    member(File, Files),
    include_line(File, Included),
    \+ may_include(File, Included),
    format(atom(What), 'may not include ~w', [Included]).

%   The doors import no rule, but kernel.pl its topics, and nobody else does
%   that; only the top imports what stands above rules.

rule_fault(Name, Path, What) :-
    imported_file(Path, Other),
    (   topic_of_kernel(Other)
    ->  Name \== 'kernel.pl'
    ;   door(Name)
    ->  true
    ;   top(Other),
        \+ top(Name)
    ),
    format(atom(What), 'may not import ~w', [Other]).
rule_fault(Name, Path, 'only store.pl and kernel.pl load foreign code') :-
    \+ door(Name),
    xref_called(Path, use_foreign_library(_), _).

imported_file(Path, Other) :-
    xref_defined(Path, _, imported(From)),
    rule_name(From, Other).

%   rule_name(Path, Name): Name is the path from rules/ to one of our files.

rule_name(Path, Name) :-
    absolute_file_name('rules/', Rules),
    atom_concat(Rules, Name, Path).

door('store.pl').
door('kernel.pl').
door(Name) :-
    topic_of_kernel(Name).

%   topic_of_kernel(Name): a part of kernel.pl.

topic_of_kernel(Name) :-
    sub_atom(Name, 0, _, _, 'kernel/').

top('cli.pl').
top('embedding.pl').
top('verbs.pl').
top('repl.pl').
top('sanggwan.pl').


                /*******************************
                *               C              *
                *******************************/

%   include_line(File, Included): Included is <Name>, or the path of one of our
%   files, from the root.

include_line(File, Included) :-
    read_file_to_string(File, Text, []),
    split_string(Text, "\n", "\r", Lines),
    member(Line, Lines),
    string_concat("#include ", Rest, Line),
    split_string(Rest, "\"", "", Parts),
    (   Parts = [_,Name|_]
    ->  file_directory_name(File, Folder),
        below_root(Folder, Name, Included)
    ;   atom_string(Included, Rest)
    ).

below_root(_, Name, Path) :-
    string_concat("../", Path0, Name),
    !,
    atom_string(Path, Path0).
below_root(Folder, Name, Path) :-
    atomic_list_concat([Folder, Name], /, Path).

may_include(File, Included) :-
    layer(File, Layer),
    (   sub_atom(Included, 0, _, _, <)
    ->  (   sub_atom(Included, 0, _, _, '<SWI-')
        ->  prolog_side(Layer)
        ;   true
        )
    ;   layer(Included, Other),
        below(Layer, Other)
    ),
    !.

%   layer(Path, Layer): what kind of file this is. A header belongs where its C
%   file does.

layer(Path, Layer) :-
    file_directory_name(Path, Folder),
    file_base_name(Path, Base),
    file_name_extension(Name, _, Base),
    (   layer(Folder, Base, Name, Layer0)
    ->  Layer = Layer0
    ;   sub_atom(Name, _, _, 0, '4pl')
    ->  Layer = glue(Folder)
    ;   Layer = pure(Folder)
    ).

layer(engine,    'glue.def', _,    registry).
layer(engine,    _, install,       registry).
layer(engine,    _, sanggwan,      public).
layer(engine,    'start.h', _,     public).
layer(engine,    _, Name,          host) :-
    memberchk(Name, [start, host, engine, question, main, boot]).
layer(c_kernels, _, glue,          arguments).
layer(c_kernels, _, poll,          shared).
layer(c_kernels, _, column,        shared).
layer(c_kernels, _, sheet,         shared).

%   prolog_side(Layer): it may know SWI-Prolog. Kernels and the store do not,
%   nor what hosts include.

prolog_side(glue(_)).
prolog_side(arguments).
prolog_side(registry).
prolog_side(host).

%   below(Layer, Other): a file of Layer may include one of Other. Kernels know
%   no store and the store no geometry; what a kernel asks of its caller
%   (poll.h), the view of a column (column.h) and rows being written (sheet.h)
%   are for both. The host side
%   knows neither: it goes through the predicates.

below(Layer, Layer).
below(pure(_), shared).
below(glue(_), shared).
below(glue(Folder), pure(Folder)).
below(glue(_), arguments).
below(glue(_), registry).
below(glue(c_kernels), glue(engine)).
below(glue(c_kernels), pure(engine)).
below(host, registry).
below(host, public).
