/* Loads the rules for tests, and says where they, tests and the root are.

Compiled rules are read in a quarter of the time of their sources. They stand in
rules.qlf beside the library (`make check-rules` makes it), and are used if they
are of this tree and no source is newer. A change of a rule is thus always seen.
*/
:- module(sg_load_rules, []).
:- use_module(library(apply)).
:- use_module(library(lists)).

:- multifile user:file_search_path/2.
:- dynamic user:file_search_path/2.

:- prolog_load_context(directory, Tests),
   file_directory_name(Tests, Root),
   asserta(user:file_search_path(sanggwan, Root)),
   asserta(user:file_search_path(rules, sanggwan(rules))),
   asserta(user:file_search_path(tests, sanggwan(tests))).

%   compiled(File): the compiled rules, if they are those of the sources.

compiled(File) :-
    found(foreign('rules.qlf'), File),
    found(foreign('rules.pl'), From),
    found(rules('sanggwan.pl'), Facade),
    setup_call_cleanup(open(From, read, In, [encoding(utf8)]),
                       ( read(In, _), read(In, Load) ),
                       close(In)),
    Load = (:- use_module(Facade, _)),
    time_file(File, Time),
    findall(Source, source(Source), Sources),
    maplist(not_newer(Time), [From|Sources]).

found(Name, File) :-
    absolute_file_name(Name, File, [access(read), file_errors(fail)]).

source(Source) :-
    absolute_file_name(rules('.'), Rules, [file_type(directory)]),
    member(Pattern, ['*.pl', '*/*.pl']),
    directory_file_path(Rules, Pattern, Wild),
    expand_file_name(Wild, Files),
    member(Source, Files).

not_newer(Time, Source) :-
    time_file(Source, At),
    At =< Time.

directory_file_path(Directory, Name, Path) :-
    atomic_list_concat([Directory,Name], /, Path).

:- initialization(( compiled(File) -> load_files(user:File, []) ; true ), now).
:- if(found(rules('sanggwan.pl'), _)).
:- use_module(user:rules(sanggwan)).
:- use_module(user:rules(rows)).
:- use_module(user:rules(topology)).
:- use_module(user:rules(spans)).
:- endif.
