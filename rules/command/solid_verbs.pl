:- encoding(utf8).
:- module(sg_solid_verbs,
          [ solid_verb/1,               % ?Verb
            operands_loaded/4,          % +Verb, +Files, +Options, -Sources
            operands_evaluated/2,       % +Sources, +Options
            solids_written/3,           % +Ss, +Outputs, +Options
            empty_roots_warned/0,
            solid_verb_run/4            % +Verb, +Files, +Options, -Status
          ]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../csg/csg',
              [root_segment/1, root_segments_after/2, is_node/1]).
:- use_module('../solid/csg_evaluate', [evaluate/2]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../csg/csg_term', [is_node_term/1, plain_name/2]).
:- use_module('../kernel', [census/1]).
:- use_module('../language', [language/1]).
:- use_module('../model/model', [load_model/2, save_model/1]).
:- use_module('../model/parameter', [settings_met/2, settings_of/2]).
:- use_module('../model/parameter_about', [settings_used/1]).
:- use_module('../solid/arrangement', [pieces_dropped/0]).
:- use_module('../solid/operand', [operand_faults/2]).
:- use_module('../csg/operand_name', [name_root/2]).
:- use_module('../plain', [plain_json/2, plain_text/2]).
:- use_module('../primitive/primitive', [is_primitive/1]).
:- use_module('../solid/repair', [repair_operand/1]).
:- use_module(report, [counted/4]).
:- use_module('../model/solid_file', [write_solids/3]).
:- use_module('../store',
              [ p/3, segment/3, param/2, assert_fact/1, retractall_facts/1,
                fresh_id/3 ]).
:- use_module('../polygon/triangulation', [complete_segments/0]).
:- use_module(verb_output,
              [ some_files/2, outputs/3, output_written/2, reported/2,
                summary_sent_told/2, usage_error/1
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4, partition/4]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(yall), [(>>)/3]).
/** <module> The verbs of solids: union, intersection, difference, split, eval.

Each makes a CSG tree of its files, evaluates it, and writes what the roots are.
A file is one operand: if it has several roots, they are joined.
*/

%!  solid_verb(?Verb) is nondet.

solid_verb(union).
solid_verb(intersection).
solid_verb(difference).
solid_verb(split).
solid_verb(eval).

%!  solid_verb_run(+Verb, +Files, +Options, -Status) is det.
%
%   Do what Verb says with Files and Options, as verb_run/4.

solid_verb_run(Verb, Files, Options, 0) :-
    enough_files(Verb, Files),
    outputs(Options, [pl, stl, off, obj, ply], Outputs),
    json_apart(Options, Outputs),
    operands_loaded(Verb, Files, Options, Sources),
    operands_evaluated(Sources, Options),
    (   member(output(_, Format), Outputs),
        Format \== pl
    ->  true                            % who writes it will say so
    ;   empty_roots_warned
    ),
    findall(S, root_segment(S), Ss),
    (   Outputs == []
    ->  summary_measures(Ss, Dicts),
        summary(Options, Dicts),
        summary_sent_told(Outputs, [pl,stl,off,obj,ply])
    ;   (   option(json(true), Options)
        ->  summary_measures(Ss, Dicts),
            reported(Outputs, sg_solid_verbs:summary(Options, Dicts))
        ;   true
        ),
        partition(takes_one(Verb, Ss), Outputs, Apart, Together),
        forall(( member(Output, Apart), member(S, Ss) ),
               part_written(Options, S, Output)),
        solids_written(Ss, Together, Options)
    ).

%!  operands_loaded(+Verb, +Files, +Options, -Sources) is det.
%!  operands_evaluated(+Sources, +Options) is det.
%
%   The world has what Files have, mended if that is asked for, and on top the
%   nodes that Verb makes of it; then these are evaluated. Sources are pairs
%   File-Last, for errors.

operands_loaded(Verb, Files, Options, Sources) :-
    asked_nodes(Verb, Files, Options, Sources),
    all_set(Options),
    (   option(repair(true), Options)
    ->  complete_segments,
        repaired_leaves
    ;   true
    ).

operands_evaluated(Sources, Options) :-
    complete_segments,
    catch(evaluate(all, Options), error(Fault, Context),
          throw_with_file(Fault, Context, Sources)).

%   all_set(Options): every parameter that Options set is in one of the models.

all_set(Options) :-
    settings_of(Options, Settings),
    findall(Name, param(Name, _), Names),
    settings_met(Settings, Names),
    settings_used(Settings).

%   takes_one(Verb, Ss, Output): the format does not tell the parts Ss of split
%   apart, so each gets a file.

takes_one(split, [_,_|_], output(File, Format)) :-
    File \== (-),
    memberchk(Format, [stl, off, ply]).

%   part_written(Options, S, Output): S goes to the file with its name before
%   the ending.

part_written(Options, S, output(File0, Format)) :-
    segment(S, _, Term),
    result_name(Term, Name),
    file_name_extension(Base, Ending, File0),
    format(atom(Base1), '~w-~w', [Base,Name]),
    file_name_extension(Base1, Ending, File),
    solids_written([S], [output(File, Format)], Options).

%!  solids_written(+Ss, +Outputs, +Options) is det.
%
%   Write the roots Ss to Outputs; to meshes as solid_file.pl does. With
%   repair(true) no two triangles of what is written go through each other, not
%   even such as an operand has brought and no tolerance could tell. The rest of
%   the world may be gone afterwards.

solids_written(Ss, Outputs, Options) :-
    partition([output(_, pl)]>>true, Outputs, Models, Meshes),
    findall(S-Name,
            ( member(S, Ss), segment(S, _, Term), result_name(Term, Name) ),
            Pairs),
    (   option(repair(true), Options)
    ->  Check = all
    ;   Check = changed
    ),
    (   Meshes == []
    ->  true
    ;   pieces_dropped                  % as large as what is written
    ),
    maplist(output_written(sg_solid_verbs:solids_output(Pairs, Check)), Meshes),
    (   Models == []
    ->  true
    ;   roots_alone,
        maplist(output_written(save_model), Models)
    ).

solids_output(Pairs, Check, File) :-
    write_solids(File, Pairs, [check(Check)]).

%   result_name(Term, Name): what a segment with this Term is called in a file.

result_name(Term, Name) :-
    (   is_node_term(Term)
    ->  plain_name(Term, Name)
    ;   Name = Term
    ).

enough_files(Verb, Files) :-
    some_files(Files, 'MODEL'),
    (   memberchk(Verb, [intersection, difference]),
        Files = [_]
    ->  usage_error(one_operand(Verb))
    ;   true
    ).

%   repaired_leaves: with --repair, before anything is made of them.

repaired_leaves :-
    forall(( segment(S, solid, _), \+ is_node(S) ), repair_operand(S)).

%   throw_with_file(Fault, Context, Sources): an operand is named with its file.

throw_with_file(Fault, Context0, Sources) :-
    (   fault_operand(Fault, Name),
        var(Context0),
        name_root(Name, S),
        member(File-Last, Sources),
        S =< Last
    ->  Context = location(File, 0, 0)
    ;   Context = Context0
    ),
    throw(error(Fault, Context)).

fault_operand(geometry_error(operand(Name, _)), Name).
fault_operand(model_error(csg(no_front(Name))), Name).
fault_operand(model_error(csg(not_through(Name))), Name).

%   asked_nodes(Verb, Files, Options, Sources): the world has what the files
%   have, and on top the nodes that Verb makes of it. Sources are pairs
%   File-Last, Last the greatest segment of File, in the order of the files.

asked_nodes(eval, Files, Options, Sources) :-
    !,
    (   Files = [File]
    ->  Sources = [File-inf]
    ;   Sources = []
    ),
    load_model(Files, [evaluate(false)|Options]).
asked_nodes(split, Files, Options, Sources) :-
    !,
    split_by(Options, By0),
    file_operands(Files, split, Options, Operands, Sources1),
    joined(Operands, Operand),
    by_operand(By0, Options, By, Known, Sources2),
    append(Sources1, Sources2, Sources),
    split_sides(Options, Known, Sides),
    forall(member(Side, Sides),
           new_node(named(Side, split(Operand, By, Side)), _)).
asked_nodes(glue, Files, Options, Sources) :-
    !,
    maplist(file_roots(glue, Options), Files, Roots, Sources),
    append(Roots, Operands),
    fresh_id(segment, 0, S),
    assert_fact(segment(S, cells, glue(Operands))).
asked_nodes(Verb, Files, Options, Sources) :-
    file_operands(Files, Verb, Options, Operands, Sources),
    Term =.. [Verb, Operands],
    new_node(Term, _).

%   file_operands(Files, Verb, Options, Operands, Sources): a segment for each
%   file.

file_operands(Files, Verb, Options, Operands, Sources) :-
    maplist(file_operand(Verb, Options), Files, Operands, Sources).

file_operand(Verb, Options, File, Operand, Source) :-
    file_roots(Verb, Options, File, Roots, Source),
    joined(Roots, Operand).

file_roots(Verb, Options, File, Roots, File-Last) :-
    last_segment(Before),
    load_model([File],
               [evaluate(false),triangles(false),others_set(true)|Options]),
    root_segments_after(Before, Roots),
    last_segment(Last),
    catch(maplist(open_checked(Verb, Options), Roots), error(Fault, Context),
          throw_with_file(Fault, Context, [File-Last])).

last_segment(Last) :-
    aggregate_all(max(S), ( S = 0 ; segment(S, _, _) ), Last).

%   open_checked(Verb, Options, S): what is open is mended if that was asked
%   for and can be. If it is still open, Verb has to be one that takes surfaces;
%   of a mesh, which is seldom meant to be one, there is a warning.

open_checked(Verb, Options, S) :-
    (   segment(S, surface, Name),
        \+ is_node(S)
    ->  (   option(repair(true), Options)
        ->  repair_operand(S)
        ;   complete_segments
        ),
        operand_faults(S, Faults),
        open_taken(Faults, Verb, S, Name)
    ;   true
    ).

open_taken([], _, S, Name) :-
    !,
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, solid, Name)).
open_taken(Faults, Verb, S, Name) :-
    (   memberchk(Verb, [intersection,difference,split])
    ->  throw(error(geometry_error(operand(S, Faults)), _))
    ;   Verb == union,
        \+ is_primitive(Name)
    ->  print_message(warning, sanggwan(operand(surface(Faults), S)))
    ;   true
    ).

joined([Operand], Operand) :-
    !.
joined(Operands, Operand) :-
    new_node(join(Operands), Operand).

new_node(Term, S) :-
    fresh_id(segment, 0, S),
    assert_fact(segment(S, solid, Term)).

%   split_by(Options, By): By is plane(A, B, C, D) or file(File).

split_by(Options, By) :-
    (   option(plane(Text), Options)
    ->  (   option(by(_), Options)
        ->  usage_error(both_options('--plane', '--by'))
        ;   true
        ),
        plane_option(Text, By)
    ;   option(by(File), Options)
    ->  By = file(File)
    ;   usage_error(needs_one_of(['--plane', '--by']))
    ).

%   split_sides(Options, Known, Sides): both that are Known, or the one that is
%   asked for.

split_sides(Options, Known, Sides) :-
    (   option(side(Side), Options)
    ->  (   memberchk(Side, Known)
        ->  Sides = [Side]
        ;   usage_error(bad_value('--side', Side, one_of(Known)))
        )
    ;   Sides = Known
    ).

plane_option(Text, plane(A, B, C, D)) :-
    (   split_string(Text, ",", " ", Parts),
        maplist(decimal_number, Parts, [A, B, C, D])
    ->  (   member(N, [A, B, C]),
            N =\= 0
        ->  true
        ;   usage_error(bad_value('--plane', Text, no_normal))
        )
    ;   usage_error(bad_value('--plane', Text, 'A,B,C,D'))
    ).

%   by_operand(By0, Options, By, Sides, Sources): By is an operand with these
%   Sides.

by_operand(plane(A, B, C, D), _, plane(A, B, C, D), [below, above], []).
by_operand(file(File), Options, By, Sides, [Source]) :-
    file_operand(by, Options, File, By, Source),
    (   segment(By, surface, _)
    ->  Sides = [below, above]
    ;   Sides = [inside, outside]
    ).

%!  empty_roots_warned is det.
%
%   A warning for every root that is a node of which nothing is left.

empty_roots_warned :-
    forall(root_segment(S), empty_warned(S)).

empty_warned(S) :-
    (   is_node(S),
        \+ p(S, _, _)
    ->  segment(S, _, Term),
        plain_name(Term, Name),
        print_message(warning, sanggwan(empty_result(S, Name)))
    ;   true
    ).


                /*******************************
                *            SUMMARY           *
                *******************************/

%   json_apart(Options, Outputs): the summary and a solid do not both go to
%   standard output.

json_apart(Options, Outputs) :-
    (   option(json(true), Options),
        memberchk(output(-, _), Outputs)
    ->  usage_error(both_options('--json', '-o -'))
    ;   true
    ).

summary_measures(Ss, Dicts) :-
    census(Parts),
    maplist(measured(Parts), Ss, Dicts).

%   summary(Options, Dicts): one line on standard output for each segment.

summary(Options, Dicts) :-
    (   option(json(true), Options)
    ->  plain_json(current_output,
                   json_laid_out(current_output, Dicts, inf)),
        nl
    ;   language(Language),
        forall(member(Dict, Dicts), print_summary(Language, Dict))
    ).

measured(Parts, S, Dict) :-
    segment(S, _, Term),
    result_name(Term, Name0),
    format(string(Name), '~w', [Name0]),
    (   memberchk(part(S, counts(Vs, _, Es, Ps, Ts, _), _, Area, Volume, _,
                       Shells, _), Parts)
    ->  length(Shells, N)
    ;   maplist(=(0), [Vs, Es, Ps, Ts, N]),
        maplist(=(0.0), [Area, Volume])
    ),
    Dict = _{segment:S, name:Name, faces:Ps, vertices:Vs, edges:Es,
             triangles:Ts, shells:N, area:Area, volume:Volume}.

print_summary(Language, D) :-
    findall(Text,
            ( member(Key-What,
                     [ faces-polygon, vertices-vertex, edges-edge,
                       triangles-triangle, shells-shell ]),
              counted(Language, What, D.Key, Text) ),
            Texts),
    atomic_list_concat(Texts, ', ', Counts),
    measure_words(Language, Area, Volume),
    plain_text(D.name, Name),
    format("~w: ~w, ~w ~6g, ~w ~6g~n",
           [Name, Counts, Area, D.area, Volume, D.volume]).

measure_words(ko, '넓이', '부피') :-
    !.
measure_words(_, area, volume).
