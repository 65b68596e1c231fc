/* pattern_files.pl -- patterns in all formats, for pattern.sh:

       swipl -p foreign=build tests/cli/pattern_files.pl -- FOLDER
*/
:- prolog_load_context(directory, Here),
   file_directory_name(Here, Tests),
   file_directory_name(Tests, Root),
   asserta(user:file_search_path(rules, Root)).
:- use_module(rules('rules/store')).
:- use_module(rules('rules/development/development'), [develop/2]).
:- use_module(rules('rules/message/messages')).
:- use_module(rules('rules/model/model'), [load_model/1]).
:- use_module(rules('rules/pattern/pattern_file'), [write_pattern/4]).
:- use_module(rules('rules/unrolling/true_development'), [true_development/4]).

:- initialization(main, main).

main([Folder]) :-
    in_new(written(Folder)).

in_new(Goal) :-
    new_world(World),
    in_world(World, Goal).

written(Folder) :-
    atom_concat(Folder, '/model.pl', Model),
    load_model(Model),
    develop(1, Sphere),
    develop(2, Box),
    true_development(3, _, [generators(12)], Pipe),
    forall(member(Ending, [svg,pdf,eps,ps,png,json,dxf,hpgl,pl,fold]),
           ( pattern_file(Folder, box, Ending, File),
             write_pattern(File, [Box],
                           [page('A4'),tabs(6),names(words),angles(true),
                            title("box")], _) )),
    forall(member(Ending, [pdf,svg,fold]),
           ( pattern_file(Folder, sphere, Ending, File),
             write_pattern(File, [Sphere], [page('A4'),tabs(6)], Files),
             forall(member(One, Files), writeln(One)) )),
    pattern_file(Folder, tiled, pdf, Tiled),
    write_pattern(Tiled, [Sphere], [page('A4'),tile(true),grid(10)], _),
    pattern_file(Folder, cutter, dxf, Cutter),
    write_pattern(Cutter, [Box], [tabs(6),dashes(geometry)], _),
    pattern_file(Folder, pipe, svg, PipeFile),
    write_pattern(PipeFile, [Pipe], [page('A4'),table(true)], _),
    pattern_file(Folder, all, pdf, All),
    write_pattern(All, [Sphere,Box,Pipe], [page('A3'),tabs(5)], _).

pattern_file(Folder, Name, Ending, File) :-
    format(atom(File), '~w/~w.~w', [Folder,Name,Ending]).
