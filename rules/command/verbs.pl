:- module(sg_verbs,
          [ verb_run/4,                 % +Verb, +Files, +Options, -Status
            item_explained_there/3,     % +Items, +Options, -Status
            sheet_drawing_there/3,      % +Options, +File, -Drawn
            draw/1,                     % +File
            draw/2,                     % +File, +Options
            convert/2                   % +Files, +File
          ]).
:- use_module(check, [check_report/1, report_faults/2]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../solid/csg_evaluate', [evaluate/0]).
:- use_module('../solid/simplify', [simplified_roots/1]).
:- use_module('../csg/csg_roots',
              [ aside_segments/1, roots_alone/0, operand_lines/1,
                with_operand_lines/2 ]).
:- use_module('../drawing/drawing', [write_drawing/2, drawing_format/2]).
:- use_module(verbs_shading,
              [ shade_asked/3, shade_taken/3, eye_away/2, picture_shaded/5,
                sheet_shaded/6 ]).
:- use_module('../explanation/explain',
              [explain/2, explanation/3, print_explanations/1]).
:- use_module('../picture/hidden_lines', [picture/1]).
:- use_module('../picture/picture_cut',
              [penetrated/1, pieces_cut/1, segments_cut/1]).
:- use_module(lines_out, [write_lines/2, line_format/1]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../output', [when_written/1]).
:- use_module('../penetration/chain', [chain/5, chain_length/2]).
:- use_module('../model/model',
              [load_model/1, load_model/2, save_model/1, save_model/2]).
:- use_module('../model/parameter', [settings_met/2, settings_of/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../picture/sew', [borders_sewn/1]).
:- use_module('../primitive/primitive_rows', [goal_commas_told/1]).
:- use_module('../problem/problem_sheet', [problem_sheets/3]).
:- use_module('../studio/query', [query/2, read_goal/3]).
:- use_module(repl, [repl/1]).
:- use_module(picture_marks, [picture_marked/5]).
:- use_module(report, [print_report/2]).
:- use_module(sheet_options,
              [ sheet_wanted/1, cutaway_wanted/2, sheet_request/3,
                request_facts/4, request_title/2 ]).
:- use_module('../sheet/cutaway', [cutaway_drawing/5]).
:- use_module('../sheet/sheet_plan', [views_drawing/5]).
:- use_module(solid_verbs,
              [ solid_verb/1, solid_verb_run/4, solids_written/3,
                empty_roots_warned/0 ]).
:- use_module('../space_limit', [with_stack_for/3]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ drawn/7, segment/3, line/9, origin/3, facts_snapshot/1,
                facts_transaction/1, in_passing_world/1 ]).
:- use_module('../drawing/style_file',
              [penetration_in_vain/3, segment_in_vain/2]).
:- use_module('../sheet/stroke', [stroke_key/4]).
:- use_module(verb_output,
              [ some_files/2, outputs/3, some_outputs/1, no_model_replaced/2,
                output_written/2, reported/2, usage_error/1 ]).
:- use_module(verbs_batch, [batch_run_verb/3]).
:- use_module('../gluing/exploded', [cells_exploded/1]).
:- use_module(verbs_cells, [cells_run/3]).
:- use_module(verbs_glue, [glue_run/3, unglue_run/3, glue_misses_told/0]).
:- use_module(verbs_render, [render_run/2, wanted_scene/4]).
:- use_module(verbs_unfold,
              [ unfold_run/3, roots_apart/1, patterns_given/1,
                pattern_wanted/3 ]).
:- use_module('../picture/view',
              [set_view/1, set_view/3, set_projection/1, turn_up/1, with_up/2]).
:- use_module(picture_options,
              [picture_options/2, known_segments/1, drawing_options/2, eye/2]).
:- use_module(library(apply), [maplist/2, maplist/3, partition/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(solution_sequences), [distinct/2]).
:- use_module(library(yall), [(>>)/3]).
/** <module> What each verb of the command line does.

A verb loads its models into the current world, which is empty, and goes the
way of the data as far as it needs to. Its result is an exit status: 0, or 1
when the answer is no.
*/

%!  verb_run(+Verb, +Files, +Options, -Status) is det.
%
%   Do what Verb says with Files and Options, as arguments.pl gives them.

verb_run(check, Files, Options, Status) :-
    some_files(Files, 'MODEL'),
    load_model(Files, Options),
    empty_roots_warned,
    glue_misses_told,
    roots_alone,
    check_report(Report),
    (   option(json(true), Options)
    ->  print_report(json, Report)
    ;   print_report(text, Report)
    ),
    (   report_faults(Report, 0),
        \+ ( option(strict(true), Options),
             member(Segment, Report.segments),
             Segment.border_edges > 0 )
    ->  Status = 0
    ;   Status = 1
    ).
verb_run(cells, Files, Options, Status) :-
    cells_run(Files, Options, Status).
verb_run(glue, Files, Options, Status) :-
    glue_run(Files, Options, Status).
verb_run(unglue, Files, Options, Status) :-
    unglue_run(Files, Options, Status).
verb_run(convert, Files, Options, 0) :-
    some_files(Files, 'MODEL'),
    outputs(Options, [pl, stl, off, obj, ply], Outputs),
    some_outputs(Outputs),
    (   member(output(_, Format), Outputs),
        Format \== pl
    ->  Triangles = true
    ;   Triangles = false
    ),
    load_model(Files, [triangles(Triangles),evaluate(false)|Options]),
    convert_simplified(Options),
    partition([output(_, pl)]>>true, Outputs, Trees, Meshes),
    maplist(output_written(model_output), Trees),
    (   Meshes == []
    ->  true
    ;   aside_segments([_|_])
    ->  evaluate,
        findall(S, root_segment(S), Roots),
        solids_written(Roots, Meshes, [])
    ;   maplist(output_written(model_output), Meshes)
    ).
verb_run(penetrate, Files, Options, 0) :-
    some_files(Files, 'MODEL'),
    findall(Ending, line_format(Ending), Endings),
    outputs(Options, Endings, Outputs0),
    exact_outputs(Options, Outputs0),
    load_model(Files, Options),
    roots_alone,
    penetrated(Options),
    points_alone,
    (   option(json(true), Options)
    ->  reported(Outputs0, sg_verbs:print_chains),
        Outputs = Outputs0
    ;   Outputs0 == [],
        line(_, _, _, _, _, _, _, _, _)
    ->  option(format(Format), Options, pl),
        Outputs = [output(-, Format)],
        exact_outputs(Options, Outputs)
    ;   Outputs = Outputs0
    ),
    maplist(output_written(lines_output(Options)), Outputs).
verb_run(draw, Files, Options, 0) :-
    some_files(Files, 'MODEL'),
    findall(Format, drawing_format(Format, _), Formats),
    outputs(Options, Formats, Outputs),
    some_outputs(Outputs),
    no_model_replaced(Files, Outputs),
    shade_asked(Options, Outputs, Shade),
    picture_options(Options, PictureOptions),
    drawing_options(Options, DrawingOptions),
    (   cutaway_wanted(Options, Plane)
    ->  eye(Options, Eye),
        load_model(Files, Options),
        roots_ready(Options, PictureOptions, Lines),
        findall(Option,
                ( member(Option, PictureOptions)
                ; member(Option, DrawingOptions)
                ; Option = tolerance(_), member(Option, Options)
                ),
                Cutting),
        facts_snapshot(cutaway_drawing(Plane, Eye, Cutting, Lines, Drawing)),
        WriteOptions = [drawing(Drawing)|DrawingOptions]
    ;   sheet_wanted(Options)
    ->  sheet_drawn(Options, Files, load_model(Files, Options), Shade, Drawn),
        append(Drawn, DrawingOptions, WriteOptions)
    ;   eye(Options, Eye),
        load_model(Files, Options),
        shade_taken(Shade, Options, Shading),
        roots_ready(Options, PictureOptions, Lines),
        eye_away(Options, Away),
        facts_transaction(
            sg_verbs:pictured(Lines, Options, Eye, PictureOptions)),
        said_if_nothing_drawn,
        picture_shaded(Shade, Shading, Away, DrawingOptions, Options1),
        picture_marked(Options, seen(z,PictureOptions), Lines, Options1,
                       WriteOptions)
    ),
    said_of_style(DrawingOptions, WriteOptions),
    maplist(output_written(drawing_output(WriteOptions)), Outputs).
verb_run(render, Files, Options, 0) :-
    render_run(Files, Options).
verb_run(query, Arguments, Options, Status) :-
    (   append(Files, [Text], Arguments)
    ->  true
    ;   usage_error(no_files('GOAL'))
    ),
    (   Files == [],
        exists_file(Text)
    ->  usage_error(no_files('GOAL'))
    ;   some_files(Files, 'MODEL')
    ),
    read_goal(Text, Goal, Bindings),
    goal_commas_told(Goal),
    query_format(Options, Format),
    load_model(Files, Options),
    option(limit(Limit), Options, infinite),
    (   query(user:Goal, [bindings(Bindings), format(Format), limit(Limit)])
    ->  Status = 0
    ;   Status = 1,
        print_message(informational, sanggwan(no_answer))
    ).
verb_run(explain, Arguments, Options, Status) :-
    (   append(Files, [Text], Arguments)
    ->  true
    ;   usage_error(no_files('ITEM'))
    ),
    (   Files == [],
        exists_file(Text)
    ->  usage_error(no_files('ITEM'))
    ;   some_files(Files, 'MODEL')
    ),
    read_goal(Text, Item, _),
    (   of_shading(Item)                % no boundary is evaluated
    ->  Loading = [evaluate(false),rows(false)|Options]
    ;   Loading = Options
    ),
    item_explained(Item, load_model(Files, Loading), Options, Status).
verb_run(Verb, Files, Options, Status) :-
    solid_verb(Verb),
    solid_verb_run(Verb, Files, Options, Status).
verb_run(unfold, Files, Options, Status) :-
    unfold_run(Files, Options, Status).
verb_run(batch, Files, Options, Status) :-
    batch_run_verb(Files, Options, Status).
verb_run(problems, Files, Options, 0) :-
    (   Files = [File]
    ->  true
    ;   usage_error(no_files('FILE'))
    ),
    (   option(output(Folder), Options)
    ->  true
    ;   usage_error(no_output)
    ),
    problem_sheets(File, Folder, Options).
verb_run(repl, Files, Options, Status) :-
    (   Files == []
    ->  settings_of(Options, Settings),
        settings_met(Settings, [])
    ;   load_model(Files, Options)
    ),
    repl(Status).

%!  sheet_drawing_there(+Options, +File, -Drawn) is det.
%
%   Drawn is the sheet that the verb draw would make with Options of the model
%   in the current world, as options of write_drawing/2: drawing(Drawing),
%   title(Title), perhaps shading(Shadeds). File is the name of the model.
%
%   @error usage_error(What)

sheet_drawing_there(Options, File, Drawn) :-
    shade_asked(Options, [], Shade),
    sheet_drawn(Options, [File], true, Shade, Drawn).

%   sheet_drawn(Options, Files, Load, Shade, Drawn): Load brings the model into
%   the world.

:- meta_predicate sheet_drawn(+, +, 0, +, -).

sheet_drawn(Options, Files, Load, Shade, Drawn) :-
    picture_options(Options, PictureOptions),
    sheet_request(Options, PictureOptions, Request),
    call(Load),
    shade_taken(Shade, Options, Shading),
    request_facts(Options, Files, Request, Full),
    roots_ready(Options, PictureOptions, Lines),
    sheet_made(Options, Full, Lines, Drawing0, Placed),
    sheet_shaded(Shade, Shading, Placed, Drawing0, Drawing, Shaded),
    request_title(Full, Title),
    Drawn = [drawing(Drawing),title(Title)|Shaded].

%   picture_made(Options, Eye, PictureOptions, Lines): the picture of what was
%   loaded, roots alone; Lines as of operand_lines/1.

picture_made(Options, Eye, PictureOptions, Lines) :-
    roots_ready(Options, PictureOptions, Lines),
    facts_transaction(
        sg_verbs:pictured(Lines, Options, Eye, PictureOptions)).

roots_ready(Options, PictureOptions, Lines) :-
    empty_roots_warned,
    operand_lines(Lines),
    roots_alone,
    (   option(explode(Factor), Options)
    ->  cells_exploded(Factor)
    ;   true
    ),
    known_segments(PictureOptions),
    option(up(Axis), Options, z),
    turn_up(Axis).

%   sheet_made(Options, Request, Lines, Drawing, Placed): see views_drawing/5.
%   Patches
%   are sewn before a section cuts them.

sheet_made(Options, Request, Lines, Drawing, Placed) :-
    Cuts = cuts(segments_cut(Options), pieces_cut(Options)),
    facts_snapshot(( borders_sewn(_),
                     views_drawing(Request, Lines, sg_verbs:Cuts, Drawing,
                                   Placed) )).

%   pictured(Lines, Options, Eye, PictureOptions): the picture of the current
%   world, with the Lines of operands.

pictured(Lines, Options, Eye, PictureOptions) :-
    (   option(explode(_), Options)     % what was glued is cut already
    ->  true
    ;   segments_cut(Options)
    ),
    maplist(call, Eye),
    (   aside_segments([_|_]),
        \+ option(segments(_), PictureOptions)
    ->  findall(S, root_segment(S), Roots),
        Picture = [segments(Roots)|PictureOptions]
    ;   Picture = PictureOptions
    ),
    with_operand_lines(Lines, picture(Picture)).

said_if_nothing_drawn :-
    (   drawn(_, _, _, _, _, _, _)
    ->  true
    ;   print_message(informational, sanggwan(nothing_drawn))
    ).

%   said_of_style(Options, WriteOptions): what the style names in vain.

said_of_style(Options, WriteOptions) :-
    option(style(Rows), Options, []),
    forall(distinct(Segment, segment_in_vain(Rows, Segment)),
           print_message(informational, sanggwan(style_in_vain(Segment)))),
    (   memberchk(line(_,penetration,_,_), Rows)
    ->  findall(S, penetrated(WriteOptions, S), Ss0),
        sort(Ss0, Ss),
        forall(distinct(Segment, penetration_in_vain(Rows, Ss, Segment)),
               print_message(informational,
                             sanggwan(penetration_in_vain(Segment))))
    ;   true
    ).

%   penetrated(WriteOptions, S) is nondet: a penetration line is drawn as one of
%   segment S.

penetrated(WriteOptions, S) :-
    (   option(drawing(drawing(_,Views)), WriteOptions)
    ->  member(view(_,Strokes,_), Views),
        member(Stroke, Strokes),
        stroke_key(Stroke, _, penetration, S)
    ;   drawn(_, S, _, _, _, _, penetration)
    ).

%!  draw(+File) is det.
%!  draw(+File, +Options) is det.
%
%   Draw the current world to File, as the verb draw does; the ending is the
%   format. The segments cut each other first: one facts_undo/0 takes back the
%   cut and the picture; if nothing was to be cut, what was done before.
%   Options:
%
%     - view(Name), or view(Theta, Phi), view(Theta, Phi, Rho)
%     - up(Axis): the axis of the model that points up in the picture, `x`,
%       `y` or `z` (default), see turn_up/1
%     - projection(Kind): `parallel` or `central`
%     - lines(Which), crease(Degrees), segments(List): see picture/1
%     - hidden(How), size(Size), ...: see write_drawing/2
%     - cutaway(Plane): cut open by that plane, an atom as after the option of
%       that name
%     - points(Most): numbered points on penetration lines, see line_points/2
%     - 'centre-lines'(true): the axes of what is round, as on a sheet
%     - sheet(Paper), views(Names), section(Planes), angle(Angle), scale(Scale),
%       unit(Unit), 'title-block'(File), language(Language), 'no-frame'(Bool):
%       a sheet, as the verb draw makes it; the values are atoms as after the
%       options of that name, Planes a list of such. The world stays as it is.

draw(File) :-
    draw(File, []).

draw(File, Options) :-
    sheet_wanted(Options),
    !,
    sheet_request(Options, Options, Request),
    request_facts(Options, [], Request, Full),
    option(up(Axis), Options, z),
    facts_snapshot(( operand_lines(Lines),
                     roots_alone,
                     turn_up(Axis),
                     sheet_made(Options, Full, Lines, Drawing, _) )),
    drawing_output([drawing(Drawing)|Options], File),
    when_written(print_message(informational, sanggwan(wrote(File)))).
draw(File, Options) :-
    cutaway_wanted(Options, Plane),
    !,
    findall(sg_verbs:Goal, ( member(Option, Options), view_goal(Option, Goal) ),
            Eye),
    option(up(Axis), Options, z),
    facts_snapshot(( operand_lines(Lines),
                     roots_alone,
                     turn_up(Axis),
                     cutaway_drawing(Plane, Eye, Options, Lines, Drawing) )),
    drawing_output([drawing(Drawing)|Options], File),
    when_written(print_message(informational, sanggwan(wrote(File)))).
draw(File, Options) :-
    findall(Goal, ( member(Option, Options), view_goal(Option, Goal) ), Eye),
    operand_lines(Lines),
    option(up(Axis), Options, z),
    with_up(Axis, sg_verbs:pictured(Lines, Options, Eye, Options)),
    said_if_nothing_drawn,
    picture_marked(Options, seen(Axis,Options), Lines, Options, WriteOptions),
    drawing_output(WriteOptions, File),
    when_written(print_message(informational, sanggwan(wrote(File)))).

view_goal(view(Name), set_view(Name)).
view_goal(view(Theta, Phi), set_view(Theta, Phi, 0)).
view_goal(view(Theta, Phi, Rho), set_view(Theta, Phi, Rho)).
view_goal(projection(Kind), set_projection(Kind)).

%   convert_simplified(Options): with --faces what the trees make is simplified,
%   and written instead of them.

convert_simplified(Options) :-
    (   option(faces(Faces), Options)
    ->  evaluate,
        simplified_roots(Faces)
    ;   true
    ).

%!  convert(+Files, +File) is det.
%
%   Write the models in Files, one name or a list, to File; the endings are
%   the formats. The current world is not touched.

convert(Files, File) :-
    in_passing_world(( load_model(Files), save_model(File) )).

%   points_alone: a notice if curves go through, which leaves points, no lines.

points_alone :-
    (   line(_, _, _, _, _, _, _, _, _)
    ->  true
    ;   aggregate_all(count, distinct(Origin, origin(_, v(_), Origin)), N),
        N > 0
    ->  print_message(informational, sanggwan(points_alone(N)))
    ;   true
    ).

                /*******************************
                *            WRITERS           *
                *******************************/

model_output(File) :-
    save_model(File).

%!  item_explained_there(+Items, +Options, -Status) is det.
%
%   As the verb explain, of the model in the current world. Items, a list of one
%   text, say what is explained.

item_explained_there(Items, Options, Status) :-
    (   Items = [Text]
    ->  read_goal(Text, Item, _),
        item_explained(Item, true, Options, Status)
    ;   usage_error(no_files('ITEM'))
    ).

%   item_explained(Item, Load, Options, Status): of a line of the picture, in
%   the picture that draw would make. Load makes the model be there.

:- meta_predicate item_explained(+, 0, +, -).

item_explained(Item, Load, Options, Status) :-
    (   of_picture(Item)
    ->  picture_options(Options, PictureOptions),
        eye(Options, Eye),
        call(Load),
        picture_made(Options, Eye, PictureOptions, Lines),
        with_operand_lines(Lines,
                           explained(Options, Item, PictureOptions, Status))
    ;   of_shading(Item)
    ->  wanted_scene(Options, Load, Scene, Wanted),
        explained(Options, Item, [scene(Scene)|Wanted], Status)
    ;   call(Load),
        (   of_pattern(Item)
        ->  pattern_asked(Item, Options, Wanted)
        ;   of_model(Item)
        ->  Wanted = []
        ;   Wanted = [],
            penetrate(all, Options)
        ),
        explained(Options, Item, Wanted, Status)
    ).

%   pattern_asked(Item, Options, Wanted): what is wanted of patterns that are to
%   be made for the question; [] if they are there.

pattern_asked(_, Options, []) :-
    patterns_given(Options),
    !.
pattern_asked(Item, Options, Wanted) :-
    empty_roots_warned,
    roots_apart(Options),
    pattern_wanted(Item, Options, Wanted),
    (   option(trim(_), Options)
    ->  true
    ;   penetrate(all, Options)
    ).

%   of_pattern(Item): of what `unfold` makes, of the roots alone.

of_pattern(Item) :-
    nonvar(Item),
    functor(Item, Name, _),
    memberchk(Name, [seam,fold,pattern]).

%   of_model(Item): of what its file says, or was glued, which needs no cut.

of_model(Item) :-
    nonvar(Item),
    functor(Item, Name, N),
    memberchk(Name/N, [segment/1,param/1,glued/2,region/2]).
of_model(Item) :-
    nonvar(Item),
    Item = why_not(Inner),
    nonvar(Inner),
    Inner = glued(_, _).

of_picture(Item) :-
    nonvar(Item),
    \+ of_shading(Item),
    \+ of_model(Item),
    functor(Item, Name, _),
    memberchk(Name, [hidden,why_not]).

%   of_shading(Item): of a picture that render makes.

of_shading(Item) :-
    subsumes_term(pixel(_,_), Item).
of_shading(Item) :-
    subsumes_term(why_not(seen(_)), Item).

%   explained(Options, Item, PictureOptions, Status): 1 if there is nothing to
%   explain.

explained(Options, Item, PictureOptions, Status) :-
    (   option(json(true), Options)
    ->  findall(Item-Because, explanation(Item, PictureOptions, Because), All),
        print_explanations(All)
    ;   explain(Item, PictureOptions)
    ->  All = [Item]
    ;   All = []
    ),
    (   All == []
    ->  Status = 1
    ;   Status = 0
    ).

%   print_chains: a summary of the penetration lines, as JSON.

print_chains :-
    findall(_{segments:[S1,S2], kind:Kind, pieces:N, length:Length},
            ( chain(_, S1, S2, Kind, Lines),
              length(Lines, N),
              chain_length(Lines, Length) ),
            Chains),
    aggregate_all(count, line(_, _, _, _, _, _, _, _, _), Pieces),
    json_laid_out(current_output, _{pieces:Pieces, chains:Chains}, 72),
    nl.

lines_output(Options, File) :-
    (   option(exact(true), Options)
    ->  LineOptions = [exact(true)]
    ;   LineOptions = []
    ),
    stage(write, write_lines(File, LineOptions)).

%   exact_outputs(Options, Outputs): --exact is for tables.

exact_outputs(Options, Outputs) :-
    (   option(exact(true), Options),
        member(output(_, Format), Outputs),
        \+ memberchk(Format, [csv, tsv, txt])
    ->  usage_error(exact_format(Format))
    ;   true
    ).

%   drawing_output(Options, File): as much of the stacks as the parts of the
%   picture take.

drawing_output(Options, File) :-
    aggregate_all(count, drawn(_,_,_,_,_,_,_), Parts),
    part_octets(Octets),
    with_stack_for(Parts, Octets, stage(write, write_drawing(File, Options))).

part_octets(1000).

query_format(Options, Format) :-
    (   option(json(true), Options)
    ->  Format = json
    ;   option(format(Format), Options, table)
    ).
