:- encoding(utf8).
:- module(sg_solid_verbs,
          [ solid_verb/1,               % ?Verb
            solids_written/2,           % +Ss, +Outputs
            solid_verb_run/4            % +Verb, +Files, +Options, -Status
          ]).
:- use_module(csg, [root_segment/1, is_node/1]).
:- use_module(csg_evaluate, [evaluate/2]).
:- use_module(csg_roots, [roots_alone/0]).
:- use_module(csg_term, [csg_error/1, is_node_term/1, plain_name/2]).
:- use_module(kernel, [census/1]).
:- use_module(language, [language/1]).
:- use_module(model, [load_model/2, save_model/1]).
:- use_module(repair, [repair_operand/1]).
:- use_module(report, [counted/4]).
:- use_module(solid_file, [write_solids/3]).
:- use_module(store, [p/3, segment/3, assert_fact/1, fresh_id/3]).
:- use_module(verb_output,
              [some_files/2, outputs/3, output_written/2, usage_error/1]).
:- autoload(library(apply), [maplist/2, maplist/3, partition/4]).
:- autoload(library(http/json), [json_write_dict/3]).
:- autoload(library(lists), [append/2, member/2, subtract/3]).
:- autoload(library(option), [option/2, option/3]).
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
    asked_nodes(Verb, Files, Options),
    repaired_leaves(Options),
    evaluate(all, Options),
    findall(S, root_segment(S), Ss),
    (   member(output(_, Format), Outputs),
        Format \== pl
    ->  true                            % who writes it will say so
    ;   maplist(empty_warned, Ss)
    ),
    (   Outputs == []
    ->  summary(Options, Ss)
    ;   solids_written(Ss, Outputs)
    ).

%!  solids_written(+Ss, +Outputs) is det.
%
%   Write the roots Ss to Outputs; to meshes as solid_file.pl does. The rest of
%   the world may be gone afterwards.

solids_written(Ss, Outputs) :-
    partition([output(_, pl)]>>true, Outputs, Models, Meshes),
    findall(S-Name,
            ( member(S, Ss), segment(S, _, Term), result_name(Term, Name) ),
            Pairs),
    maplist(output_written(sg_solid_verbs:solids_output(Pairs)), Meshes),
    (   Models == []
    ->  true
    ;   roots_alone,
        maplist(output_written(save_model), Models)
    ).

solids_output(Pairs, File) :-
    write_solids(File, Pairs, []).

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

%   repaired_leaves(Options): with --repair, before anything is made of them.

repaired_leaves(Options) :-
    (   option(repair(true), Options)
    ->  forall(( segment(S, solid, _), \+ is_node(S) ), repair_operand(S))
    ;   true
    ).

%   asked_nodes(Verb, Files, Options): the world has what the files have, and on
%   top the nodes that Verb makes of it.

asked_nodes(eval, Files, Options) :-
    !,
    load_model(Files, [evaluate(false)|Options]).
asked_nodes(split, Files, Options) :-
    !,
    split_by(Options, By0),
    file_operands(Files, Options, Operands),
    joined(Operands, Operand),
    by_operand(By0, Options, By, Known),
    split_sides(Options, Known, Sides),
    forall(member(Side, Sides), new_node(split(Operand, By, Side), _)).
asked_nodes(Verb, Files, Options) :-
    file_operands(Files, Options, Operands),
    Term =.. [Verb, Operands],
    new_node(Term, _).

%   file_operands(Files, Options, Operands): a segment for each file.

file_operands(Files, Options, Operands) :-
    maplist(file_operand(Options), Files, Operands).

file_operand(Options, File, Operand) :-
    findall(S, root_segment(S), Before),
    load_model([File], [evaluate(false)|Options]),
    findall(S, root_segment(S), After),
    subtract(After, Before, Roots),
    joined(Roots, Operand).

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
        maplist(number_of, Parts, [A, B, C, D])
    ->  (   member(N, [A, B, C]),
            N =\= 0
        ->  true
        ;   csg_error(plane(plane(A, B, C, D)))
        )
    ;   usage_error(bad_value('--plane', Text, 'A,B,C,D'))
    ).

number_of(Text, Number) :-
    catch(number_string(Number, Text), error(_, _), fail).

%   by_operand(By0, Options, By, Sides): By is an operand with these Sides.

by_operand(plane(A, B, C, D), _, plane(A, B, C, D), [below, above]).
by_operand(file(File), Options, By, Sides) :-
    file_operand(Options, File, By),
    (   segment(By, surface, _)
    ->  Sides = [below, above]
    ;   Sides = [inside, outside]
    ).

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

%   summary(Options, Ss): one line on standard output for each segment.

summary(Options, Ss) :-
    census(Parts),
    maplist(measured(Parts), Ss, Dicts),
    (   option(json(true), Options)
    ->  json_write_dict(current_output, Dicts, [width(0)]),
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
    format("~w: ~w, ~w ~6g, ~w ~6g~n",
           [D.name, Counts, Area, D.area, Volume, D.volume]).

measure_words(ko, '넓이', '부피') :-
    !.
measure_words(_, area, volume).
