:- encoding(utf8).
:- module(sg_messages,
          [ english//1                  % +Term
          ]).
:- use_module('../language', [interrupted_word/2]).
:- use_module(batch_en, [manifest_en//1, batch_en//1]).
:- use_module(command_en, [command_en//1]).
:- use_module(csg_en, [csg_en//1]).
:- use_module(explain_en, [statement_en//1, hidden_en//1]).
:- use_module(explain_glue_en, [glue_nothing_en//1]).
:- use_module(explain_pixel_en, [pixel_nothing_en//1]).
:- use_module(openscad_en, [openscad_en//1]).
:- use_module(development_en,
              [ development_en//2, development_notice_en//2 ]).
:- use_module(mesh_en, [mesh_en//1, simplify_en//1]).
:- use_module(part_glue_en, [part_glue_en//1]).
:- use_module(message_parts,
              [ counted//3, dots_that_fit/5, loading_fault//2, located//1,
                manual_page//1, shown_names/2, shown_number/3
              ]).
:- use_module(session_en, [session_en//1]).
:- use_module(prolog_en, [prolog_en//2]).
:- use_module(model_en, [model_en//1]).
:- use_module(operand_en, [operand_en//2, operand_notice_en//2]).
:- use_module(true_en, [true_en//1]).
:- use_module(unfold_en, [wish_en//3, unfold_en//1, trim_en//1]).
:- use_module(primitive_en, [comma_en//1, primitive_en//2]).
:- use_module(problem_en, [problem_en//1]).
:- use_module(style_en, [style_en//1]).
:- use_module(sheet_en, [sheet_tiny_en//3]).
:- use_module(parameter_en, [parameter_en//1]).
:- use_module(pattern_en, [pattern_en//1]).
:- use_module(written_en, [written_en//1, unwritten_en//1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> Messages in English; messages_ko.pl has them in Korean.

Every term that Sanggwan prints or raises has a clause of english//1 or, when
it is error(model_error(What), location(File, Line, Column)) or
error(geometry_error(What), _), of fault_en//1; and one in Korean with the
same head (tests/rules/message/messages.plt). A fault says what is wrong, then
on a new line what to do. Those of one topic are in files of their own,
TOPIC_en.pl and TOPIC_ko.pl; what is left here is in a block for each file of
rules.
*/

:- multifile prolog:message//1.

prolog:message(Term) -->
    english(Term).

%!  english(+Term)// is semidet.
%
%   The message for Term in English.

english(error(model_error(What), Context)) -->
    located(Context),
    wrong_en(What).
english(error(geometry_error(What), Context)) -->
    located(Context),
    wrong_en(What).
english(error(frame_error(What), _)) -->
    session_en(frame(What)).
english(error(request_error(What), _)) -->
    session_en(What).
english(error(usage_error(What), _)) -->
    command_en(What).
english(error(domain_error(Domain, Value), _)) -->
    drawing_en(domain(Domain, Value)).
english(error(existence_error(directory, Folder), context(Writer, _))) -->
    { Writer == sg_output:writing/3 },
    command_en(no_folder(Folder)).
english(error(representation_error(What), _)) -->
    { What == float32 },
    mesh_en(no_float32).
english(error(representation_error(What), _)) -->
    { What == max_path_length },
    model_en(cannot_read(long_name)).
english(error(resource_error(What), _)) -->
    { What == memory },
    notice_en(no_memory).
english(error(cannot_write(File, Why), _)) -->
    command_en(cannot_write(File, Why)).
english(sanggwan_interrupt(_)) -->
    notice_en(interrupted).
english(sanggwan(What)) -->
    notice_en(What).

:- discontiguous
    fault_en//1,
    notice_en//1.

notice_en(request(Do)) -->
    session_en(does(Do)).
notice_en(studio(What)) -->
    session_en(What).

%   wrong_en(What)//: what is wrong with a model, and what to do.

wrong_en(What) -->
    (   fault_en(What)
    ->  []
    ;   model_en(What)
    ).

fault_en(primitive(What, Term)) -->
    primitive_en(What, Term).
fault_en(manifest(What)) -->
    (   { What = usage(Wrong) }
    ->  command_en(Wrong)
    ;   manifest_en(What)
    ).
fault_en(csg(What)) -->
    csg_en(What).
fault_en(development(S, What)) -->
    development_en(S, What).
fault_en(operand(S, Faults)) -->
    operand_en(S, Faults).
fault_en(unfold(S, Wish, What)) -->
    wish_en(S, Wish, What).
fault_en(unfold(What)) -->
    unfold_en(What).
fault_en(trim(What)) -->
    trim_en(What).
fault_en(true(What)) -->
    true_en(What).
fault_en(problem(What)) -->
    (   { What = of(Number, Formal) }
    ->  [ '~w: '-[Number] ],
        english(error(Formal, _))
    ;   problem_en(What)
    ).
fault_en(style(What)) -->
    style_en(What).
fault_en(not_whole(Row, Missing)) -->
    [ '~p refers to ~p, which is not there'-[Row, Missing], nl,
      '  Retract it in the same facts_transaction/1, or assert ~p again; \c
       the option cascade(true) retracts what refers to it.'-[Missing] ].
fault_en(referred(Fact, Row)) -->
    [ '~p is not retracted: ~p refers to it'-[Fact, Row], nl,
      '  Change both in one facts_transaction/1, or retract both: \c
       retract_fact(Fact, [cascade(true)]).' ].


                /*******************************
                *            verbs             *
                *******************************/

notice_en(do_not_meet) -->
    [ 'the segments do not meet: there are no penetration lines' ].
notice_en(points_alone(N)) -->
    [ 'the segments meet in points alone (~D): see explain vertex(S, V)'-
      [N] ].
notice_en(batch(What)) -->
    batch_en(What).
notice_en(trim(What)) -->
    trim_en(What).
notice_en(unfold(What)) -->
    unfold_en(What).
notice_en(development(S, What)) -->
    development_notice_en(S, What).
notice_en(operand(What, S)) -->
    operand_notice_en(What, S).
notice_en(comma(Argument, Location)) -->
    located(Location),
    comma_en(Argument).
notice_en(parameter(What)) -->
    parameter_en(What).
notice_en(pattern(What)) -->
    pattern_en(What).
notice_en(one_segment) -->
    [ 'one segment alone has no penetration lines' ].
notice_en(empty_result(S, Name)) -->
    [ 'segment ~d (~p) is empty: nothing is left of its operands'-[S, Name] ].
notice_en(summary_sent(File)) -->
    [ '~w has this summary, not the result'-[File], nl,
      '  Write it with -o ~w instead of > ~w.'-[File, File] ].
notice_en(wrote(File)) -->
    [ 'wrote ~w'-[File] ].
notice_en(pen_travel(N, Way, Unsorted)) -->
    { Metres0 is Way/1.0e6,
      Before0 is Unsorted/1.0e6,
      maplist(shown_number(3), [Metres0,Before0], [Metres,Before])
    },
    [ '~D lines for the pen; between them it goes ~w m (~w m unsorted)'-
      [N, Metres, Before] ].
notice_en(each_failed(Bad, Count, Files)) -->
    { shown_names(Files, Text) },
    [ '~D of ~D files failed: ~w'-[Bad, Count, Text] ].
notice_en(interrupted) -->
    { interrupted_word(en, Word) },
    [ Word ].
notice_en(greeting) -->
    [ 'Ask away: goals end with a full stop, halt. ends.', nl,
      '  v/5 e/5 p/3 t/6 segment/3 are the model; penetrate. \c
       draw(\'a.svg\'). show. rules.' ].
notice_en(segment(S, Kind, Name)) -->
    [ 'segment ~d: ~w ~p'-[S, Kind, Name] ].
notice_en(uncaught(What)) -->
    [ 'a goal or a rule ended with throw(~p)'-[What], nl,
      '  Catch it there, or throw error(Formal, Context).' ].
notice_en(no_answer) -->
    [ 'no' ].
notice_en(more_warnings(N)) -->
    [ '~D more, not shown'-[N] ].
notice_en(warnings_are_errors(N)) -->
    counted(N, warning, warnings),
    [ ', and --strict was given' ].
notice_en(nothing_written(N)) -->
    counted(N, warning, warnings),
    [ ', and --strict was given, so nothing is written', nl,
      '  Mend what is warned of, or leave --strict out.' ].
notice_en(no_memory) -->
    [ 'there is not enough memory for this', nl,
      '  Nothing was changed. Smaller parts, or fewer facets, need less.' ].
notice_en(no_end) -->
    [ 'the work came to no end and to no result: a fault of the program', nl,
      '  Please send the model and the command to those who made it.' ].
notice_en(progress(Stage, Seconds)) -->
    [ '~w: ~0f s'-[Stage, Seconds] ].
notice_en(progress(Stage, Done, Total, Rate, Left)) -->
    [ '~w: ~D of ~D, ~0f a second, ~0f s left'-
      [Stage, Done, Total, Rate, Left] ].


notice_en(not_utf8(File, Line)) -->
    [ '~w:~d: the file holds bytes that are not UTF-8, first in the fact \c
       that ends here'-[File, Line], nl,
      '  Save the file as UTF-8; names in it may be wrong.' ].


                /*******************************
                *             mesh             *
                *******************************/

fault_en(openscad(What)) -->
    openscad_en(What).
fault_en(mesh(Fault)) -->
    mesh_en(Fault).
fault_en(mesh(Fault, Byte)) -->
    [ 'at byte ~D: '-[Byte] ],
    mesh_en(Fault).

fault_en(mesh_write(unsupported(Text))) -->
    [ 'this format cannot hold ~w'-[Text], nl,
      '  Write .obj or .ply instead.' ].

fault_en(written(faulty(S, Rounds, What))) -->
    [ 'segment ~d is not written, after ~D rounds: '-[S, Rounds] ],
    unwritten_en(What).
fault_en(no_triangles(S, P)) -->
    [ 'polygon ~d of segment ~d has no triangles'-[P, S], nl,
      '  It may be invalid: see what check says; else call \c
       complete_segments.' ].

notice_en(mesh(File, degenerate(N))) -->
    [ '~w: '-[File] ],
    counted(N, face, faces),
    [ ' left out: without three different corners' ].
notice_en(mesh(File, ignored(N, Line))) -->
    [ '~w: '-[File] ],
    counted(N, item, items),
    [ ' of unknown kind passed over, the first in line ~D'-[Line] ].
notice_en(mesh(File, no_curves(N))) -->
    [ '~w: STL holds no curves: ~D left out'-[File, N] ].
notice_en(mesh(File, other_names(N))) -->
    [ '~w: '-[File] ],
    counted(N, name, names),
    [ ' with invisible characters, which are written as \u241B or as blanks' ].
notice_en(simplify(What)) -->
    simplify_en(What).
notice_en(written(File, What)) -->
    [ '~w: '-[File] ],
    written_en(What).
notice_en(mesh(File, trailing(Bytes))) -->
    [ '~w: '-[File] ],
    counted(Bytes, byte, bytes),
    [ ' behind the mesh passed over' ].


                /*******************************
                *            drawing           *
                *******************************/

%   drawing_en(domain(Domain, Value))//: options of a drawing.

drawing_en(domain(sheet_size, W0-H0)) -->
    { number(W0),
      number(H0),
      maplist(shown_number(0), [W0,H0], [W,H])
    },
    [ 'the picture would be ~w x ~w mm large'-[W,H], nl,
      '  Take a smaller --scale; a side can be above 0 and up to 100000 mm.' ].
drawing_en(domain(sheet_size, Size)) -->
    [ 'no sheet has the size ~p'-[Size], nl,
      '  Give width x height in mm, like 210x148, up to 100000.' ].
drawing_en(domain(raster_size, W-H)) -->
    [ 'a picture cannot have ~p x ~p dots'-[W, H], nl,
      '  Each side has 1 to 16384, all together 67 million at most.' ],
    (   { dots_that_fit(W, H, Wide, High, By) }
    ->  [ nl,
          '  In these proportions ~d x ~d fit: take --dpi (with --png dots, \c
           --size) ~w times smaller.'-[Wide, High, By] ]
    ;   []
    ).
drawing_en(domain(dot_pattern, Pattern)) -->
    [ 'no pattern of dots is written ~p'-[Pattern], nl,
      '  Give N, for N on and N off, or a list [On, Off, ...].' ].
drawing_en(domain(drawing_format, Ending)) -->
    [ 'no drawing has the ending .~w'-[Ending], nl,
      '  Drawings are .svg .pdf .eps .ps .png .dxf .hpgl .json .pl files.' ].
drawing_en(domain(dashes, How)) -->
    [ 'dashes are auto, geometry or type, not ~p'-[How] ].
drawing_en(domain(png, How)) -->
    [ 'a PNG is smooth or dots, not ~p'-[How] ].

notice_en(sheet_tiny(N:M, How)) -->
    sheet_tiny_en(N, M, How).
notice_en(nothing_drawn) -->
    [ 'there is nothing to draw' ].
notice_en(look_in_vain(Name, Names)) -->
    [ 'the looks name ~p, and no segment of the model is called that'-[Name],
      nl ],
    (   { Names == [] }
    ->  [ '  None has a name: write its number.' ]
    ;   { atomic_list_concat(Names, ', ', All) },
        [ '  These are names in it: ~w. Others are asked for by number.'-[All] ]
    ).
notice_en(pixel_colour_asked(Dots)) -->
    [ 'pixel_colour/4 is a rule: it is asked of each of ~D dots'-[Dots] ].
notice_en(pixel_colour_in_vain) -->
    [ 'pixel_colour/4 is a rule, and is not asked of a picture with clear \c
       dots', nl,
      '  Give --background a colour.' ].
notice_en(shadows_in_vain) -->
    [ 'a rule decides tone/3, which knows no shadows: --shadows changes \c
       nothing' ].
notice_en(facets_off(Dots0)) -->
    { shown_number(1, Dots0, Dots) },
    [ 'what is round is shown round; the facets of files are up to ~w dots \c
       from that (--surface facets shows them)'-[Dots] ].
notice_en(format_option(Option, Format)) -->
    [ '~w changes nothing: it is about .~w, and no file here is one'-
      [Option, Format] ].
notice_en(points_in_vain) -->
    [ 'there is no penetration line, so no point has a number' ].
notice_en(nothing_seen) -->
    [ 'nothing is seen: the picture is its background alone', nl,
      '  The model has no solid, or what it takes away is all of it.' ].
notice_en(thinner_than_lines) -->
    [ 'what is seen is so thin that it is between two lines of the picture, \c
       which is its background alone', nl,
      '  Give a larger --size, --smooth 16, or a --window that is nearer.' ].
notice_en(nothing_in_window) -->
    [ 'nothing is seen in the window: the picture is its background alone', nl,
      '  Give another --window; without it what is seen fills the picture.' ].
notice_en(not_shaded(S, cells)) -->
    !,
    [ 'segment ~p is not in the picture: it is cells without their operands'-
          [S], nl,
      '  Shade the model whose glue still names them; draw shows cells as \c
       well.' ].
notice_en(not_shaded(S, glued(Kind))) -->
    !,
    [ 'segment ~p is not in the picture: it is a ~w, and of a glue only \c
       solids are shaded'-[S, Kind], nl,
      '  draw shows it.' ].
notice_en(not_shaded(S, Kind)) -->
    [ 'segment ~p is not in the picture: it is a ~w, and only solids and \c
       surfaces are shaded'-[S, Kind], nl,
      '  draw shows it.' ].
notice_en(surface_uncut(S)) -->
    [ 'segment ~p is not in the picture: it is a surface, and a section cuts \c
       solids alone'-[S], nl,
      '  draw --section cuts surfaces too.' ].
notice_en(surface_see_through(S)) -->
    [ 'segment ~p has an open surface: behind what is see-through of it \c
       nothing else of it is seen'-[S], nl,
      '  Make the surface a segment of its own, not united with the others.' ].
notice_en(style_in_vain(Segment)) -->
    [ 'the style has lines of segment ~p, but the model has no such segment'-
          [Segment] ].
notice_en(penetration_in_vain(Segment)) -->
    [ 'the style has penetration lines of segment ~p, but none is drawn as \c
       one of it'-[Segment], nl,
      '  Such a line is one of the segment with the smaller number of the \c
         two, unless line_segment/3 says otherwise (docs/rules.md).' ].


                /*******************************
                *             view             *
                *******************************/

fault_en(eye_in_model(D)) -->
    [ 'the eye is in or behind the model: its nearest point is at ~4g'-[D],
      nl,
      '  Go further away (--eye, or a larger RHO), or use the parallel \c
       projection.' ].
fault_en(leaf_behind_eye(N)) -->
    [ 'leaf ~D of the trees is not in front of the eye'-[N], nl,
      '  Go further away (--eye, or a larger RHO), or use the parallel \c
       projection.' ].


                /*******************************
                *            regions           *
                *******************************/

fault_en(open_polygon(S, P)) -->
    [ 'polygon ~d of segment ~d is no face: its edges do not close'-[P, S], nl,
      '  Correct its list in p/3.' ].
fault_en(wrong_triangles(S, P)) -->
    [ 'polygon ~d of segment ~d is no face: its triangles in t/6 do not end \c
       where it does'-[P, S], nl,
      '  Leave them out, so that they are made again.' ].

notice_en(cells_apart(S, N, P1, P2)) -->
    [ 'segment ~d: places where polygons meet and share no edge or vertex: ~D \c
       (the first two are ~d and ~d)'-[S, N, P1, P2], nl,
      '  Regions may run together. Divide the polygons where they meet.' ].


                /*******************************
                *         triangulation        *
                *******************************/

fault_en(no_third_vertex(V1, V2)) -->
    [ 'the edge from vertex ~d to ~d has no third vertex'-[V1, V2], nl,
      '  The polygon crosses or overlaps itself there.' ].
fault_en(polygon_edge(S, P, V1, V2)) -->
    invalid_polygon_en(S, P, V1, V2).

notice_en(polygon_edge(S, P, V1, V2)) -->
    invalid_polygon_en(S, P, V1, V2),
    [ nl, '  It is left out.' ].
notice_en(polygon_edges(S, Count, P, V1, V2)) -->
    [ 'polygons of segment ~d are invalid: ~D; no triangle fits the edge of \c
       the first, ~d, from vertex ~d to ~d'-[S, Count, P, V1, V2], nl,
      '  They cross or overlap themselves, or a hole is outside or runs the \c
       wrong way round.', nl,
      '  They are left out.' ].
notice_en(tangled(S, Count, P, Most)) -->
    [ 'polygons of segment ~d that touch or cross themselves too often: ~D \c
       (the first is ~d)'-[S, Count, P], nl,
      '  To divide them would take more than ~D looks at their edges.'-
      [Most], nl, '  They are left out.', nl,
      '  Divide them into polygons that do not touch themselves, or give \c
       --limits contacts=N.' ].
notice_en(no_area(S, Count, P)) -->
    [ 'polygons without area in segment ~d: ~D (the first is ~d)'-
      [S, Count, P], nl,
      '  They are lines, or cross themselves so that their parts cancel.', nl,
      '  Left out.' ].
fault_en(tolerance(Tolerance, Most)) -->
    [ 'a tolerance of ~4g is too large: a part is hardly larger'-[Tolerance],
      nl,
      '  Give --tolerance ~4g or less, or none.'-[Most] ].
fault_en(tight(S1, S2, At, Move, Feature, N)) -->
    tight_en(S1, S2, At, Move, Feature, N).
fault_en(unasked(Moved, Reach)) -->
    notice_en(Moved),
    { Enough is 1.01*Reach },
    [ nl,
      '  That may be the rounding of the sources, or meant: --tolerance ~3g \c
       allows it, --tolerance 0 moves nothing.'-[Enough] ].
fault_en(flattened(S, At, Move, Beside, N)) -->
    flattened_en(tight, S, At, Move, Beside, N).
fault_en(result_open) -->
    [ 'the result would not be closed', nl,
      '  Give a larger or smaller --tolerance, or --repair the operands.' ].

fault_en(glue_law(S, Faults0)) -->
    { pairs_keys(Faults0, Faults),
      atomic_list_concat(Faults, ', ', Text) },
    [ 'segment ~d: what was glued breaks a law (~w), so nothing was glued'-
      [S, Text], nl,
      '  Give another --tolerance, --repair the operands, or mend the \c
       --rules.' ].
fault_en(undivided(S, P, X, Y, Z, Tolerance)) -->
    [ 'segment ~d: polygon ~d cannot be divided at ~6g ~6g ~6g: what is there \c
       is about as small as the tolerance, ~3g'-[S, P, X, Y, Z, Tolerance], nl,
      '  Give a smaller one; --tolerance 0 moves nothing.' ].
fault_en(thin_operand(S, Thick, Reach, X, Y, Z)) -->
    [ 'segment ~d is about ~3g thick at ~6g ~6g ~6g, and what is nearer than \c
       ~3g is made one place, so nothing was glued'-[S, Thick, X, Y, Z, Reach],
      nl,
      '  Leave it out or make it thicker, or give --tolerance 0, which moves \c
       nothing.' ].
fault_en(part_glue(What)) -->
    part_glue_en(What).
fault_en(glue_meets(S, P1, P2, X, Y, Z)) -->
    [ 'segment ~d: polygons ~d and ~d would meet at ~6g ~6g ~6g and share \c
       nothing, so nothing was glued'-[S, P1, P2, X, Y, Z], nl,
      '  Give a larger or smaller --tolerance, or --repair the operands.' ].

notice_en(glue_overlap(S, S1, S2, R, Volume)) -->
    [ 'segment ~d: operands ~d and ~d overlap: region ~d, of volume ~6g, is \c
       inside both'-[S, S1, S2, R, Volume] ].
notice_en(glue_apart(S)) -->
    [ 'segment ~d: the operands touch nowhere'-[S] ].
notice_en(glue_overlaps(S, N)) -->
    [ 'segment ~d: regions inside several operands: ~D more'-[S, N] ].
notice_en(glue_surface(S, R, S0)) -->
    [ 'segment ~d: operand ~d is a surface that encloses region ~d, so that \c
       is a void'-[S, S0, R], nl,
      '  If it is meant to be a solid, give --repair.' ].
notice_en(glue_surfaces(S, N)) -->
    [ 'segment ~d: regions that a surface encloses: ~D more'-[S, N] ].
notice_en(glue_thin(S, N, Most)) -->
    [ 'segment ~d: of the regions in which operands overlap ~D are thin, \c
       ~6g at most'-[S, N, Most], nl,
      '  If faces are meant to touch there, give a --tolerance of several \c
       times that.' ].
notice_en(glue_gap(S, S1, S2, Gap, p(X,Y,Z))) -->
    [ 'segment ~d: operands ~d and ~d are ~6g apart at ~6g ~6g ~6g, and were \c
       not glued'-[S, S1, S2, Gap, X, Y, Z] ].
notice_en(glue_gaps(S, N)) -->
    [ 'segment ~d: ~D more pairs of operands come as near and were not glued'-
      [S, N], nl,
      '  A --tolerance above the gap makes them touch.' ].
notice_en(cityjson_open(File, N)) -->
    (   { N =:= 1 }
    ->  [ '~w: a solid is open: it is read as a surface'-[File] ]
    ;   [ '~w: ~D solids are open: they are read as surfaces'-[File, N] ]
    ).
notice_en(cityjson_floors(File, N)) -->
    (   { N =:= 1 }
    ->  [ '~w: an open solid was closed by flat faces'-[File] ]
    ;   [ '~w: ~D open solids were closed by flat faces'-[File, N] ]
    ).
notice_en(cityjson_left_out(File, N)) -->
    [ '~w: templates are not read: left out ~D'-[File, N] ].
notice_en(cityjson_no_area(File, N)) -->
    (   { N =:= 1 }
    ->  [ '~w: a surface has no area: left out'-[File] ]
    ;   [ '~w: ~D surfaces have no area: left out'-[File, N] ]
    ).
notice_en(cells_parted(S, N)) -->
    [ 'segment ~d has no operands: each of its ~d cells is a solid now'-
      [S, N] ].
notice_en(nothing_glued) -->
    [ 'nothing is glued in this model' ].
notice_en(opened) -->
    [ 'what nearly touches was left as it is: else the result were open', nl,
      '  There may be splinters.' ].
notice_en(contacts(Why)) -->
    contacts_en(Why),
    [ nl,
      '  The lines are right for the model as it is; there may be splinters.' ].
notice_en(moved(S1, S2, At, Move, N)) -->
    [ 'made to touch: ~D places, moved by ~4g at most, near '-[N, Move] ],
    place_en(At, S1, S2).
notice_en(tight(S1, S2, At, Move, Feature, N)) -->
    tight_en(S1, S2, At, Move, Feature, N).
notice_en(flattened(S, At, Move, Beside, N)) -->
    flattened_en(tight, S, At, Move, Beside, N).
notice_en(as_rounded(flattened(S, At, Move, Beside, N))) -->
    flattened_en(moved, S, At, Move, Beside, N).
notice_en(not_flat(S, Count, P, Off)) -->
    [ 'polygons that are not flat in segment ~d: ~D (the worst is ~d, by ~4g)'-
      [S, Count, P, Off], nl,
      '  Used as their triangles.' ].

tight_en(S1, S2, At, Move, Feature, N) -->
    (   { Move =:= Feature }
    ->  [ 'made to touch: a gap of ~4g, which rounding does not explain, \c
           near '-[Move] ]
    ;   [ 'made to touch: moved by ~4g where a feature is only ~4g large, \c
           near '-[Move, Feature] ]
    ),
    place_en(At, S1, S2),
    other_places_en(tight, N).

flattened_en(How, S, At, Move, Beside, N) -->
    [ 'made one face: ~4g off it, where '-[Move] ],
    beside_en(Beside),
    [ ', near ' ],
    place_en(At, S, 0),
    other_places_en(How, N).

beside_en(edge(Length)) -->
    [ 'an edge is only ~4g long'-[Length] ].
beside_en(wall(Thickness)) -->
    [ 'a wall or a gap is only ~4g wide'-[Thickness] ].

other_places_en(How, N) -->
    (   { N > 1 }
    ->  [ '; there are ~D such places'-[N] ]
    ;   []
    ),
    (   { How == tight }
    ->  [ nl,
          '  That may be more than rounding: look there, or give \c
           --tolerance 0, which moves nothing.'
        ]
    ;   []
    ).

place_en([X, Y, Z], S1, S2) -->
    [ '~8g ~8g ~8g'-[X, Y, Z] ],
    (   { S2 =:= 0 }
    ->  [ ' (segment ~d)'-[S1] ]
    ;   [ ' (segments ~d and ~d)'-[S1, S2] ]
    ).

invalid_polygon_en(S, P, V1, V2) -->
    [ 'polygon ~d of segment ~d is invalid: no triangle fits its edge from \c
       vertex ~d to ~d'-[P, S, V1, V2], nl,
      '  It crosses or overlaps itself, or a hole is outside or runs the \c
       wrong way round.' ].


                /*******************************
                *           decision           *
                *******************************/

fault_en(rules(no_decision(PI))) -->
    [ '~q is no decision, and nothing in this rule file calls it'-[PI], nl,
      '  Correct its name (rules/0 lists the decisions), or remove it.' ].
fault_en(rules(no_decisions)) -->
    [ 'this rule file replaces no decision', nl,
      '  Define one of those that rules/0 lists.' ].
fault_en(rules(module_file)) -->
    [ 'a rule file has no module header', nl,
      '  Remove the directive :- module(...).' ].
fault_en(rules(defined_elsewhere(M:PI))) -->
    [ '~q is defined elsewhere, and the program needs it as it is'-[M:PI], nl,
      '  Define a predicate of your own, without ~w:'-[M] ].
fault_en(rules(ends_program)) -->
    [ 'a rule file does not end the program', nl,
      '  Remove the directive :- halt.' ].
fault_en(rules(Formal)) -->
    { \+ memberchk(Formal, [ no_decision(_), no_decisions, module_file,
                             defined_elsewhere(_), ends_program
                           ]) },
    [ 'this rule file cannot be loaded: ' ],
    loading_fault(prolog_en, Formal),
    [ nl, '  Correct it; the rules are as they were before.' ].

notice_en(decision(Name/Arity, Doc, By)) -->
    [ '~q/~d: ~w'-[Name, Arity, Doc], nl,
      '    defined by: ~w'-[By] ].




                /*******************************
                *         hidden_lines         *
                *******************************/

notice_en(lines_by_rules(Lines, Each)) -->
    counted(Lines, line, lines),
    [ ' drawn by the rules, not by the kernel: a decision is replaced', nl,
      '  ~1f microseconds a line'-[Each] ].


                /*******************************
                *             help             *
                *******************************/

notice_en(no_help(What, Names)) -->
    [ 'there is no help on ~p'-[What], nl ],
    (   { Names == [] }
    ->  [ '  help. lists what there is.' ]
    ;   { atomic_list_concat(Names, ', ', All) },
        [ '  Like it are: ~w; help. lists all.'-[All] ]
    ).
notice_en(prolog_help(PI, Where)) -->
    [ '~q is Prolog\'s own (~q): see'-[PI, Where], nl ],
    manual_page(PI).




                /*******************************
                *            explain           *
                *******************************/

notice_en(because(Statement)) -->
    statement_en(Statement).
notice_en(nothing_to_explain(piece(S, P))) -->
    !,
    [ 'there is nothing to explain in ~p'-[piece(S, P)], nl,
      '  piece(S, P) is polygon P of S, a segment that is an operation on \c
       solids; piece(S, S0-P0) is polygon P0 of its operand S0.' ].
notice_en(nothing_to_explain(Item)) -->
    { memberchk(Item, [pixel(_), pixel(_, _), why_not(seen(_))]) },
    !,
    pixel_nothing_en(Item).
notice_en(nothing_to_explain(Item)) -->
    { memberchk(Item, [glued(_), glued(_, _), region(_), region(_, _),
                       why_not(glued(_))]) },
    !,
    glue_nothing_en(Item).
notice_en(nothing_to_explain(Item)) -->
    { memberchk(Item, [hidden(_), hidden(_, _), why_not(_)]) },
    !,
    hidden_en(nothing(Item)).
notice_en(nothing_to_explain(Item)) -->
    [ 'there is nothing to explain in ~p'-[Item], nl,
      '  Ask for line(L), vertex(S, V), edge(S, E), \c
       pair(S1-P1, S2-P2), pair(S1, S2), piece(S, P) or piece(S, S0-P0), with \c
       numbers of the model; segment(S), param(Name); \c
       lines are there after penetrate. hidden(S, E) and \c
       why_not(hidden(S, E)) are of the picture, pixel(X, Y) of a shaded one; \c
       seam(S, E), fold(S, E) and pattern(S, K) of the flat pattern of \c
       segment S; glued(S, p(P)) and region(S, R) of a glue.' ].
%   Why contacts within the tolerance were not made to touch (resolve.pl).

contacts_en(wide(S, V)) -->
    [ 'vertex ~d of segment ~d is connected with others over more than '-
      [V, S], 'three tolerances;', nl,
      '  what touches within the tolerance was left as it is.' ].
contacts_en(stuck(S, P)) -->
    [ 'polygon ~d of segment ~d cannot take in all that touches it '-[P, S],
      'within the tolerance;', nl, '  it was left as it is.' ].
