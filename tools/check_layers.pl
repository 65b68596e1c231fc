/* Proves that calls go down only (ARCHITECTURE.md, 1), without loading
   anything: from the imports of the rules and the #include lines of the C.

       swipl -f none tools/check_layers.pl
*/
:- module(sg_check_layers, []).
:- use_module(library(readutil)).
:- use_module(library(ugraphs)).
:- use_module(folders).

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
    member(Pattern, ['rules/*.pl', 'rules/*/*.pl']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    absolute_file_name(File, Path),
    rule_name(Path, Name),
    rule_fault(Name, Path, What).
fault(File-What) :-
    member(Top-Tops, ['rules'-[rules], 'tests/oracle'-[rules,'tests/oracle']]),
    member(Pattern, ['/*.pl', '/*/*.pl']),
    atom_concat(Top, Pattern, Those),
    expand_file_name(Those, Files),
    member(File, Files),
    absolute_file_name(File, Path),
    imports(Path, From),
    of_the_tree(From, Other),
    \+ ( member(Folder, Tops), in_folder(Other, Folder) ),
    format(atom(What), 'may not import ~w', [Other]).
fault(File-What) :-
    member(Pattern, ['engine/*.{c,h,def}', 'c_kernels/*.{c,h}',
                     'c_kernels/*/*.{c,h}']),
    expand_file_name(Pattern, Files),
    member(File, Files),
    include_line(File, Included),
    \+ may_include(File, Included),
    format(atom(What), 'may not include ~w', [Included]).

fault(File-What) :-
    findall(F-To,
            ( member(Pattern, ['rules/*.pl', 'rules/*/*.pl',
                               'tests/oracle/*.pl']),
              expand_file_name(Pattern, Files),
              member(F, Files),
              absolute_file_name(F, Path),
              imports(Path, From),
              of_the_tree(From, To)
            ),
            Imports),
    circle(Imports, Circle),
    Circle = [File|_],
    atomic_list_concat(Circle, ' -> ', Way),
    format(atom(What), 'imports go round: ~w', [Way]).

%   imports(Path, From): the file Path loads the file From, by a directive that
%   begins a line, as all of ours do.

imports(Path, From) :-
    member(Name, [use_module,reexport,ensure_loaded,load_files,include,consult,
                  autoload]),
    directive(Path, Name, Text),
    one_file(Text, One),
    named_file(One, Spec),
    file_directory_name(Path, Folder),
    absolute_file_name(Spec, From,
                       [ relative_to(Folder), extensions(['.pl','']),
                         access(exist), file_errors(fail) ]).

%   one_file(Text, One): Text begins with a file, One, or with a list of them.

one_file(Text, One) :-
    (   string_concat("[", List, Text)
    ->  split_string(List, "]", "", [Files|_]),
        split_string(Files, "\n", "", Lines),
        member(Line, Lines),
        split_string(Line, "%", "", [Code|_]),
        split_string(Code, ",", " ", Ones),
        member(One, Ones)
    ;   One = Text
    ).

%   named_file(Text, Spec): Text begins with the name of a file, not with one
%   such as library(lists).

named_file(Text0, Spec) :-
    (   string_concat("user:", Text, Text0)
    ->  true
    ;   Text = Text0
    ),
    (   string_concat("'", Quoted, Text)
    ->  split_string(Quoted, "'", "", [Name|_])
    ;   split_string(Text, ",)", " \n", [Name|_]),
        \+ sub_string(Name, _, _, _, "(")
    ),
    atom_string(Spec, Name).

%   directive(Path, Name, Text): in Path a line begins with the directive Name,
%   Text stands behind its bracket.

:- dynamic directive_of/3, directives_read/1.

directive(Path, Name, Text) :-
    (   directives_read(Path)
    ->  true
    ;   forall(directive_line(Path, N, T),
               assertz(directive_of(Path, N, T))),
        assertz(directives_read(Path))
    ),
    directive_of(Path, Name, Text).

directive_line(Path, Name, Text) :-
    read_file_to_string(Path, All, [encoding(utf8)]),
    string_concat("\n", All, Lines),
    sub_string(Lines, Start, 4, _, "\n:- "),
    From is Start+4,
    sub_string(Lines, From, _, 0, Rest),
    once(sub_string(Rest, Before, 1, _, "(")),
    sub_atom(Rest, 0, Before, _, Name),
    After is Before+1,
    sub_string(Rest, After, _, 0, Behind),
    once(( sub_string(Behind, Length, _, _, ").\n")
         ; string_length(Behind, Length) )),
    sub_string(Behind, 0, Length, _, Text).

%   circle(Imports, Files) is semidet: Files, from one back to itself, each
%   import the next.

circle(Imports, Files) :-
    vertices_edges_to_ugraph([], Imports, Graph),
    \+ top_sort(Graph, _),
    member(File-Nexts, Graph),
    del_vertices(Graph, [File], Others),
    member(Next, Nexts),
    (   Next == File
    ->  Files = [File,File]
    ;   reachable(Next, Others, Reached),
        member(Last, Reached),
        neighbours(Last, Graph, After),
        memberchk(File, After)
    ->  Files = [File,Next,'...',Last,File]
    ),
    !.

%   of_the_tree(Path, Name): Name is the path from the root to one of our files.

of_the_tree(Path, Name) :-
    absolute_file_name('.', Root0),
    atom_concat(Root0, /, Root),
    atom_concat(Root, Name, Path).

in_folder(Name, Folder) :-
    atom_concat(Folder, /, Start),
    sub_atom(Name, 0, _, _, Start).

%   floor(Path, Floor): the number of the folder of Path, 0 beside the folders.

floor(Path, Floor) :-
    atomic_list_concat([Top|Rest], /, Path),
    folders(Top, Folders),
    (   Rest = [_]
    ->  Floor = 0
    ;   Rest = [Folder,_],
        nth1(Floor, Folders, Folder)
    ).

goes_up(Path, Other) :-
    floor(Path, Floor),
    floor(Other, Above),
    Above > Floor.


                /*******************************
                *             RULES            *
                *******************************/

%   The doors import no rule, but kernel.pl its topics, and nobody else does
%   that. The facades import from all floors, and nobody else imports them;
%   cli.pl loads them into user, for the goals of users.

rule_fault(Name, Path, What) :-
    imported_file(Path, Other),
    (   topic_of_kernel(Other)
    ->  Name \== 'kernel.pl'
    ;   door(Name)
    ->  true
    ;   facade(Other)
    ->  Name \== 'command/cli.pl',
        \+ facade(Name)
    ;   \+ facade(Name),
        atom_concat('rules/', Name, Rule),
        atom_concat('rules/', Other, OtherRule),
        goes_up(Rule, OtherRule)
    ),
    format(atom(What), 'may not import ~w', [Other]).
rule_fault(Name, Path, 'only store.pl and kernel.pl load foreign code') :-
    \+ door(Name),
    directive(Path, use_foreign_library, _).
rule_fault(Name, _, 'is in a folder that no order is known of') :-
    \+ topic_of_kernel(Name),
    atom_concat('rules/', Name, Rule),
    \+ floor(Rule, _).

imported_file(Path, Other) :-
    imports(Path, From),
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

facade('sanggwan.pl').
facade('rows.pl').
facade('topology.pl').
facade('spans.pl').


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
        included_path(Folder, Name, Included)
    ;   atom_string(Included, Rest)
    ).

%   A name is looked up beside the file, from c_kernels/, and from the root.

included_path(Folder, Name, Path) :-
    member(From, [Folder, c_kernels]),
    atomic_list_concat([From, Name], /, Path),
    exists_file(Path),
    !.
included_path(_, Name, Path) :-
    atom_string(Path, Name).

may_include(File, Included) :-
    layer(File, Layer),
    (   sub_atom(Included, 0, _, _, <)
    ->  (   sub_atom(Included, 0, _, _, '<SWI-')
        ->  prolog_side(Layer)
        ;   true
        )
    ;   layer(Included, Other),
        below(Layer, Other),
        \+ goes_up(File, Included)
    ),
    !.

%   layer(Path, Layer): what kind of file this is. A header belongs where its C
%   file does. In c_kernels/ doors are made (doors.def): what one of them
%   converts by hand is named here.

layer(Path, Layer) :-
    atomic_list_concat([Top|_], /, Path),
    file_base_name(Path, Base),
    file_name_extension(Name, _, Base),
    (   layer(Top, Base, Name, Layer0)
    ->  Layer = Layer0
    ;   sub_atom(Name, _, _, 0, '4pl'),
        by_hand(Top, Name)
    ->  Layer = glue(Top)
    ;   Layer = pure(Top)
    ).

by_hand(engine, _).
by_hand(c_kernels, arrangement_kept4pl). % a term that lasts, as Prolog has it

layer(engine,    'glue.def', _,    registry).
layer(engine,    _, install,       registry).
layer(engine,    _, sanggwan,      public).
layer(engine,    'start.h', _,     public).
layer(engine,    'atomic_file.h', _, shared).
layer(engine,    'edit4pl.h', _,   edits).
layer(engine,    _, Name,          host) :-
    memberchk(Name, [start, host, engine, question, main, signals, boot]).
layer(c_kernels, _, door_types,    arguments).
layer(c_kernels, _, door,          arguments).
layer(c_kernels, _, call,          rows).
layer(c_kernels, _, Name,          rows) :-
    sub_atom(Name, _, _, 0, '_rows').
layer(doors,     _, _,             rows).
layer(engine,    _, cancel,        shared).
layer(engine,    _, column,        shared).
layer(engine,    _, list,          shared).
layer(engine,    _, search,        shared).
layer(engine,    _, sheet,         shared).

%   prolog_side(Layer): it may know SWI-Prolog. Kernels and the store do not,
%   nor what hosts include.

prolog_side(glue(_)).
prolog_side(arguments).
prolog_side(registry).
prolog_side(host).

%   below(Layer, Other): a file of Layer may include one of Other. Doors of
%   kernels see whole worlds only, not those being edited. Glue by hand in
%   c_kernels includes neither kernels nor rows, so it computes nothing.
%   Kernels know no store and the store no geometry; what a kernel asks of its
%   caller (cancel.h), the view of a column (column.h) and rows being written
%   (sheet.h) are the engine's, for both. The host side knows neither: it goes
%   through the predicates.

below(Layer, Layer).
below(pure(_), shared).
below(rows, shared).
below(rows, pure(_)).
below(arguments, shared).
below(arguments, rows).
below(arguments, pure(c_kernels)).
below(arguments, glue(engine)).
below(glue(_), shared).
below(glue(engine), pure(engine)).
below(glue(engine), edits).
below(edits, glue(engine)).
below(glue(c_kernels), arguments).
below(glue(_), registry).
below(glue(c_kernels), glue(engine)).
below(host, registry).
below(host, public).
below(host, shared).
