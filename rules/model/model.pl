:- module(sg_model,
          [ load_model/1,               % +Files
            load_model/2,               % +Files, +Options
            model_format/2,             % +File, -Format
            model_there/1,              % +File
            save_model/1,               % +File
            save_model/2                % +File, +Options
          ]).
:- use_module('../csg/csg', [complete_tree/1]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../solid/csg_evaluate', [evaluate/2]).
:- use_module(cityjson, [read_cityjson/2]).
:- use_module(mesh, [read_mesh/3, write_mesh/3, mesh_ending/2]).
:- use_module(model_file, [read_model/3]).
:- use_module(model_writer, [write_model/1]).
:- use_module(openscad, [read_csg/2, term_looks/2]).
:- use_module(parameter, [settings_of/2, settings_met/2]).
:- use_module(parameter_about, [ranges_told/0, settings_used/1]).
:- use_module('../primitive/primitive_rows', [add_primitive/2, without_rows/1]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ look/2, segment/3, assert_fact/1, facts_transaction/1,
                fresh_id/3 ]).
:- use_module('../polygon/triangulation', [complete_segments/0]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2, member/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> Models: load and save.

What rules call the things of a model is in vocabulary.pl.
*/

%!  load_model(+Files) is det.
%!  load_model(+Files, +Options) is det.
%
%   Add the models in Files, one name or a list of names, to the current
%   world: their segments side by side, each polygon with its plane and
%   triangles, the roots of CSG trees with their boundaries. The ending says
%   what a file is: `.pl` facts, `.csg` a tree of OpenSCAD (openscad.pl), or a
%   mesh (`.stl`, `.off`, `.obj`, `.ply`), or CityJSON (`.json`, cityjson.pl).
%   `-` is standard input. All of them, or none.
%   Options:
%
%     - from(Format): what standard input is (default `pl`)
%     - triangles(false): do without planes and triangles
%     - tolerance(T): see evaluate/2
%     - evaluate(false): do without the boundaries of nodes (csg.pl)
%     - rows(false): primitives are segments without vertices; then `evaluate`
%       is to be false too
%     - parameters(List): values for parameters of the models, Name=Value
%     - set(Texts): the same, as after `--set`: NAME=VALUE
%     - lod(Text): of CityJSON, which level of detail
%     - close(true): of CityJSON, open solids get flat floors
%     - others_set(true): some of these may be of other models, not in Files
%
%   @error error(model_error(What), location(File, Line, Column));
%   usage_error(parameter(What)), as settings_of/2 and settings_met/2

load_model(Files) :-
    load_model(Files, []).

load_model(Files0, Options) :-
    (   is_list(Files0)
    ->  maplist(file_name, Files0, Files)
    ;   file_name(Files0, File),
        Files = [File]
    ),
    settings_of(Options, Settings),
    facts_transaction(
        ( stage(load, sg_model:files_read(Files, Settings, Options)),
          (   option(triangles(false), Options)
          ->  true
          ;   complete_segments
          ),
          (   option(evaluate(false), Options)
          ->  true
          ;   evaluate(all, Options)
          ) )).

files_read(Files, Settings, Options) :-
    (   option(rows(false), Options)
    ->  without_rows(sg_model:files_loaded(Files, Settings, Options))
    ;   files_loaded(Files, Settings, Options)
    ).

%   file_name(Text, File): names may be given as "text".

file_name(Text, File) :-
    (   string(Text)
    ->  atom_string(File, Text)
    ;   must_be(atom, Text),
        File = Text
    ).

files_loaded(Files, Settings, Options) :-
    maplist(file_loaded(Settings, Options), Files, Names0),
    ranges_told,
    (   option(others_set(true), Options)
    ->  true
    ;   append(Names0, Names),
        settings_met(Settings, Names),
        settings_used(Settings)
    ).

file_loaded(Settings, Options, File, Names) :-
    option(from(From), Options, pl),
    file_format(File, From, Format),
    (   Format == pl
    ->  read_model(File, Settings, Names)
    ;   Names = [],
        file_added(Format, File, Options)
    ).

file_added(Format, File, Options) :-
    (   Format == csg
    ->  csg_added(File)
    ;   Format == json
    ->  model_there(File),
        read_cityjson(File, Options)
    ;   mesh_ending(Format, Mesh)
    ->  read_mesh(File, _, [format(Mesh)])
    ;   model_there(File)
    ).

%   csg_added(File): the tree in a file of OpenSCAD, under the file's name. A
%   fault of a node has no place in the file.

csg_added(File) :-
    read_csg(File, Term),
    file_base_name(File, Base),
    file_name_extension(Name, _, Base),
    (   is_node_term(Term)
    ->  fresh_id(segment, 0, S),
        assert_fact(segment(S, solid, named(Name, Term))),
        Made = [S],
        Goal = complete_tree(Made)
    ;   Goal = add_primitive(named(Name, Term), S)
    ),
    segments(Before),
    catch(Goal, error(model_error(What), _),
          throw(error(model_error(What), location(File, 0, 0)))),
    segments(Now),
    ord_subtract(Now, Before, New),
    forall(( member(N, [S|New]),
             segment(N, _, Own),
             term_looks(Own, Looks),
             \+ look(N, _),
             member(Look, Looks) ),
           assert_fact(look(N, Look))).

segments(Ss) :-
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss).

%!  model_format(+File, -Format) is semidet.
%
%   The ending of File says that it is a model of Format.

model_format(File, Format) :-
    file_format(File, pl, Format),
    known_format(Format),
    !.

%!  model_there(+File) is det.
%
%   File may be a model: it is there, and has an ending of one.
%
%   @error model_error(cannot_read(directory)),
%   model_error(cannot_read(missing)), model_error(unknown_format(Format,
%   Formats))

model_there(File) :-
    (   File \== (-),
        no_model(File, Why),
        \+ ( Why = unknown_format(_,_), model_format(File, _) )
    ->  throw(error(model_error(Why), location(File, 0, 0)))
    ;   true
    ).

%   no_model(File, Why): Why File is none, if its format is not known.

no_model(File, cannot_read(directory)) :-
    exists_directory(File),
    !.
no_model(File, cannot_read(missing)) :-
    \+ access_file(File, exist),
    !.
no_model(File, unknown_format(Format, Formats)) :-
    file_format(File, pl, Format),
    findall(F, known_format(F), Formats).

known_format(pl).
known_format(csg).
known_format(json).
known_format(Format) :-
    mesh_ending(Format, _).

file_format(-, From, From) :-
    !.
file_format(File, _, Format) :-
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format).

%!  save_model(+File) is det.
%!  save_model(+File, +Options) is det.
%
%   Write the current world to File, in the format of its ending; `-` is
%   standard output. Options:
%
%     - format(Format): what standard output gets (default `pl`)

save_model(File) :-
    save_model(File, []).

save_model(File, Options) :-
    option(format(To), Options, pl),
    file_format(File, To, Format),
    (   Format == pl
    ->  stage(write, write_model(File))
    ;   mesh_ending(Format, _)
    ->  stage(write, write_mesh(File, all, [format(Format)]))
    ;   findall(F, known_format(F), Formats),
        throw(error(usage_error(ending(File, Formats)), _))
    ).
