:- module(sg_messages,
          [ english//1,                 % +Term
            fault_en//1,                % +What
            shown_value/2,              % +Value, -Shown
            loading_fault//1,           % +Formal
            syntax_words//1,            % +What
            manual_page//1              % +PI
          ]).
:- use_module(csg_en, [csg_en//1]).
:- use_module(csg_term, [misshapen/2]).
:- use_module(explain_en, [statement_en//1, hidden_en//1]).
:- use_module(openscad_en, [openscad_en//1]).
:- use_module(primitive, [primitive_name/2]).
:- use_module(development_en,
              [ development_en//2, development_notice_en//2 ]).
:- use_module(operand_en, [operand_en//2, operand_notice_en//2]).
:- use_module(true_en, [true_en//1]).
:- use_module(unfold_en, [wish_en//3, unfold_en//1, trim_en//1]).
:- use_module(primitive_en, [primitive_en//2, primitive_names//0]).
:- use_module(style_en, [style_en//1]).
:- use_module(sheet_en, [sheet_en//1, sheet_tiny_en//3]).
:- use_module(pattern_en, [pattern_en//1, pattern_fault_en//1]).
:- use_module(written_en, [written_en//1, unwritten_en//1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
:- use_module(library(uri), [uri_encoded/3]).
/** <module> Messages in English; messages_ko.pl has them in Korean.

Every term that Sanggwan prints or raises has a clause of english//1 or, when
it is error(model_error(What), location(File, Line, Column)) or
error(geometry_error(What), _), of fault_en//1; and one in Korean with the
same head (tests/rules/messages.plt). A fault says what is wrong, then on a new
line what to do. Add yours to the block of your file.
*/

:- multifile prolog:message//1.

prolog:message(Term) -->
    english(Term).

%!  english(+Term)// is semidet.
%
%   The message for Term in English.

english(error(model_error(What), Context)) -->
    { nonvar(Context),
      Context = location(File, Line, Column)
    },
    place(File, Line, Column),
    fault_en(What).
english(error(model_error(What), Context)) -->
    { var(Context) },
    fault_en(What).
english(error(geometry_error(What), Context)) -->
    (   { nonvar(Context), Context = location(File, Line, Column) }
    ->  place(File, Line, Column)
    ;   []
    ),
    fault_en(What).
english(error(usage_error(What), _)) -->
    usage_en(What).
english(error(domain_error(Domain, Value), _)) -->
    drawing_en(domain(Domain, Value)).
english(error(existence_error(directory, Folder), context(Writer, _))) -->
    { Writer == sg_output:writing/3 },
    usage_en(no_folder(Folder)).
english(error(cannot_write(File, Why), _)) -->
    usage_en(cannot_write(File, Why)).
english(sanggwan_interrupt(_)) -->
    notice_en(interrupted).
english(sanggwan(What)) -->
    notice_en(What).

%   place(File, Line, Column)//: as compilers write it, so that editors jump.

place(File, Line, _) -->
    { Line =:= 0 },
    !,
    [ '~w: '-[File] ].
place(File, Line, Column) -->
    { Column =:= 0 },
    !,
    [ '~w:~d: '-[File, Line] ].
place(File, Line, Column) -->
    [ '~w:~d:~d: '-[File, Line, Column] ].

%   counted(N, One, Many)//: 1 edge, 2 edges.

counted(N, One, Many) -->
    { N =:= 1 -> Word = One ; Word = Many },
    [ '~D ~w'-[N, Word] ].

:- discontiguous
    fault_en//1,
    notice_en//1.

%!  fault_en(+What)// is semidet.
%
%   What is wrong with a model, and what to do.


                /*******************************
                *     model_text, model_file   *
                *******************************/

fault_en(cannot_read(missing)) -->
    [ 'there is no such file', nl,
      '  Check the name and the folder.' ].
fault_en(cannot_read(directory)) -->
    [ 'is a folder, not a file', nl,
      '  Name a file in it.' ].
fault_en(cannot_read(permission)) -->
    [ 'the file may not be read', nl,
      '  Check its permissions.' ].
fault_en(cannot_read(io)) -->
    [ 'the file cannot be read to its end', nl,
      '  Check the disk or copy the file again.' ].
fault_en(cannot_read(Why)) -->
    { \+ memberchk(Why, [missing, directory, permission, io]) },
    [ 'the file cannot be read: ~p'-[Why] ].
fault_en(syntax(end_of_file)) -->
    [ 'the file ends in the middle of a fact', nl,
      '  It may be cut off; a fact ends with a full stop.' ].
fault_en(syntax(end_of_file_in_quoted(_))) -->
    [ 'the file ends in quoted text that begins here', nl,
      '  Close the quote, or get the whole file.' ].
fault_en(syntax(too_deep)) -->
    [ 'a term is nested too deeply to be read', nl,
      '  Write facts of numbers, atoms and short lists.' ].
fault_en(syntax(Message)) -->
    { \+ memberchk(Message, [end_of_file, end_of_file_in_quoted(_),
                             too_deep]) },
    [ 'this is no Prolog text: ' ],
    syntax_words(Message),
    [ nl,
      '  Write facts such as v(1, 1, 0.0, 0.0, 0.0). with a full stop.' ].
fault_en(too_long(Most)) -->
    [ 'a fact is longer than ~D characters'-[Most], nl,
      '  Is a full stop or a quote missing? Else raise the flag \c
       sanggwan_longest_fact.' ].
fault_en(early_end) -->
    [ 'end_of_file stands in the middle of the file', nl,
      '  Remove it: what follows would be lost.' ].
fault_en(directive(Goal)) -->
    [ 'a directive in a model file: :- ~p'-[Goal], nl,
      '  A model is data and is never run. Give rules with --rules FILE.' ].
fault_en(rule(Head)) -->
    [ 'a rule in a model file: ~p :- ...'-[Head], nl,
      '  A model is data: facts only. Give rules with --rules FILE.' ].
fault_en(no_fact(Term)) -->
    [ 'this is no fact: ~p'-[Term], nl,
      '  Write facts such as v(1, 1, 0.0, 0.0, 0.0).' ].
fault_en(unknown_relation(Name, Arity)) -->
    [ 'there is no relation ~q/~d'-[Name, Arity], nl,
      '  A model has v/5, e/5, p/3, plane/6, t/6, segment/3, \c
       leaf_v/5, leaf_e/5, leaf_p/3, leaf_t/6, origin/3, from_v/4, \c
       from_p/5, line/9, curve/2, view/3, projection/1 and \c
       title_block/2.' ].
fault_en(arity(Name, Arity, Wanted)) -->
    [ '~w has '-[Name] ],
    counted(Arity, argument, arguments),
    [ ' here, it needs ~d'-[Wanted], nl,
      '  Compare with the description of ~w/~d.'-[Name, Wanted] ].
fault_en(computed(Name)) -->
    [ '~w is computed from the view and may not stand in a file'-[Name], nl,
      '  Remove it; draw makes it again.' ].
fault_en(value(Relation, Column, Value, Expected)) -->
    { shown_value(Value, Shown) },
    [ '~w of ~w is ~w, it should be '-[Column, Relation, Shown] ],
    expected_en(Expected).
fault_en(missing(Relation, S, Id)) -->
    { relation_word(Relation, Word) },
    [ 'segment ~d has no ~w ~d'-[S, Word, Id], nl,
      '  Add it, or correct the number.' ].
fault_en(twice(Name, Key)) -->
    [ 'there are two facts ~w '-[Name] ],
    key_en(Key),
    [ nl, '  Remove one, or give it another number.' ].
fault_en(polygon(S, P, Why)) -->
    [ 'polygon ~d of segment ~d '-[P, S] ],
    polygon_en(Why).
fault_en(chain(S, V)) -->
    [ 'the curve of segment ~d goes from vertex ~d to itself'-[S, V], nl,
      '  Write every vertex of a chain once.' ].
fault_en(primitive(What, Term)) -->
    primitive_en(What, Term).
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
fault_en(style(What)) -->
    style_en(What).
fault_en(kind(Term, Kind, Wanted)) -->
    { primitive_name(Term, Name) },
    [ 'a ~w is a ~w, not a ~w'-[Name, Wanted, Kind], nl,
      '  Write segment(S, ~w, ~w(...)).'-[Wanted, Name] ].
fault_en(no_vertices(_, Name)) -->
    { misshapen(Name, _) },
    !,
    csg_en(unknown(Name)).
fault_en(no_vertices(S, Name)) -->
    [ 'segment ~d has no vertices, and ~p is no primitive'-[S, Name], nl,
      '  Give facts v/5 and p/3, an operation (docs/model_files.md), or a \c
       primitive: ' ],
    primitive_names.
fault_en(no_edges(S)) -->
    [ 'segment ~d has neither polygons nor edges'-[S], nl,
      '  Add p/3, e/5 or curve/2.' ].
fault_en(title_block_only(Name)) -->
    [ 'a file for the title block has no ~w facts'-[Name], nl,
      '  Write title_block(Item, Text), such as \c
       title_block(name, "Bracket").' ].
fault_en(empty) -->
    [ 'the model is empty', nl,
      '  Give at least one segment with vertices and polygons.' ].
fault_en(refused(Row, Error)) -->
    [ 'the fact ~p is not possible: ~p'-[Row, Error] ].
fault_en(unknown_format('', Formats)) -->
    !,
    { atomic_list_concat(Formats, ' .', All) },
    [ 'the name has no ending that says what the file is', nl,
      '  The ending of a model is .~w; or give it as standard input (-) \c
       with --from.'-[All] ].
fault_en(unknown_format(Format, Formats)) -->
    { atomic_list_concat(Formats, ' .', All) },
    [ 'models of the format .~w are not known'-[Format], nl,
      '  The ending of a model is .~w.'-[All] ].

%!  shown_value(+Value, -Shown) is det.
%
%   Shown is what a message prints of Value: a variable, which has no name that
%   anybody gave it, as _; what is nested deep as dots.

shown_value(Value, Shown) :-
    (   var(Value)
    ->  Shown = '_'
    ;   format(atom(Shown), "~W",
               [Value,[quoted(true),numbervars(true),max_depth(12)]])
    ).

expected_en(id) -->
    [ 'a whole number from 1 to 2147483647', nl,
      '  Numbers of segments, vertices, edges and polygons begin with 1.' ].
expected_en(ids) -->
    [ 'a list of positive whole numbers' ].
expected_en(steps) -->
    [ 'a list of whole numbers', nl,
      '  Write the vertices of the polygon, as in [1, 2, 3]; a negative \c
       number is a jump.' ].
expected_en(chain) -->
    [ 'a list of one or more vertex numbers' ].
expected_en(float) -->
    [ 'a number', nl, '  Write it in digits, such as -1.5 or 2.0e-3.' ].
expected_en(distance) -->
    [ 'a number from 0 on (0: as far as needed)' ].
expected_en(finite) -->
    [ 'a finite number', nl,
      '  Infinity and NaN are no places; repair what wrote them.' ].
expected_en(within(Most)) -->
    [ 'between -~w and ~w'-[Most, Most], nl,
      '  Choose other units: nothing can be computed at this size.' ].
expected_en(text) -->
    [ 'text, a number or an atom' ].
expected_en(ground) -->
    [ 'an atom, a number or a compound of them', nl,
      '  Neither variables nor "text"; quote names like \'this one\'.' ].
expected_en(atom) -->
    [ 'an atom' ].
expected_en(one_of(Atoms)) -->
    { atomic_list_concat(Atoms, ', ', Text) },
    [ 'one of ~w'-[Text] ].

relation_word(v, vertex).
relation_word(e, edge).
relation_word(p, polygon).

key_en(Key) -->
    (   { is_list(Key) }
    ->  { atomic_list_concat(Key, ', ', Text) },
        [ 'with the numbers ~w'-[Text] ]
    ;   [ 'where one may stand' ]
    ).

polygon_en(list) -->
    [ 'has a list in which a jump leads nowhere', nl,
      '  A negative number follows a closed loop and begins the next one: \c
       [1,2,3,1,-4,5,6,4].' ].
polygon_en(edges(N)) -->
    [ 'has ' ],
    counted(N, edge, edges),
    [ ', it needs three or more' ].
polygon_en(open(V)) -->
    [ 'does not close at vertex ~d'-[V], nl,
      '  As many edges must end at a vertex as start there; after a jump \c
       write the first vertex of the loop again.' ].
polygon_en(twice(V1, V2)) -->
    [ 'has the edge from ~d to ~d twice'-[V1, V2], nl,
      '  Write every step once; a hole runs the other way round.' ].
polygon_en(no_edge(V)) -->
    [ 'has an edge from vertex ~d to itself'-[V], nl,
      '  Write the vertex once.' ].


                /*******************************
                *              cli             *
                *******************************/

usage_en(no_verb) -->
    [ 'what should be done?', nl, '  Try sanggwan --help.' ].
usage_en(unknown_verb(Verb)) -->
    [ 'there is no verb ~w'-[Verb], nl, '  Try sanggwan --help.' ].
usage_en(unknown_option(Text)) -->
    [ 'unknown option ~w'-[Text], nl,
      '  sanggwan VERB --help lists those of a verb.' ].
usage_en(no_value(Text)) -->
    [ 'option ~w takes no value'-[Text] ].
usage_en(needs_value(Text)) -->
    [ 'option ~w needs a value'-[Text] ].
usage_en(option_twice(Text)) -->
    [ 'option ~w is given twice'-[Text] ].
usage_en(bad_value(Text, Value, one_of(Words))) -->
    { atomic_list_concat(Words, ', ', All) },
    [ 'option ~w: ~w is none of ~w'-[Text, Value, All] ].
usage_en(bad_value(Text, Value, number(Low))) -->
    [ 'option ~w: ~w is no number from ~w on'-[Text, Value, Low] ].
usage_en(bad_value(Text, Value, number(Low, High))) -->
    [ 'option ~w: ~w is no number from ~w to ~w'-[Text, Value, Low, High] ].
usage_en(bad_value(Text, Value, above(Low))) -->
    [ 'option ~w: ~w is no number above ~w'-[Text, Value, Low] ].
usage_en(bad_value(Text, Value, whole(Low, High))) -->
    [ 'option ~w: ~w is no whole number from ~w to ~w'-
      [Text, Value, Low, High] ].
usage_en(no_size(Text, Value)) -->
    [ 'option ~w: ~w is no size: width and height must be above 0'-
      [Text, Value] ].
usage_en(bad_value(Text, Value, no_normal)) -->
    !,
    [ 'option ~w: ~w is no plane'-[Text, Value], nl,
      '  A,B,C,D is the plane A*X + B*Y + C*Z + D = 0, with A, B or C other \c
       than 0.' ].
usage_en(bad_value(Text, Value, Form)) -->
    { atom(Form) },
    [ 'option ~w: ~w should look like ~w'-[Text, Value, Form] ].
usage_en(no_files(What)) -->
    [ '~w is missing'-[What], nl,
      '  sanggwan VERB --help says what belongs there.' ].
usage_en(unfold(S, Wish, What)) -->
    wish_en(S, Wish, What).
usage_en(unfold(What)) -->
    unfold_en(What).
usage_en(one_operand(Verb)) -->
    [ '~w needs two models or more'-[Verb], nl,
      '  Name the other ones too; each file is one operand.' ].
usage_en(both_options(A, B)) -->
    [ 'options ~w and ~w do not go together'-[A, B] ].
usage_en(needs_one_of(Options)) -->
    { atomic_list_concat(Options, ' or ', Text) },
    [ 'option ~w is missing'-[Text] ].
usage_en(no_output) -->
    [ 'where should the result go? Give -o FILE (- is standard output)' ].
usage_en(replaces_model(File)) -->
    [ '~w is the model; its picture would take its place'-[File], nl,
      '  Give the picture another name.' ].
usage_en(ending(File, Endings)) -->
    { atomic_list_concat(Endings, ' .', All) },
    [ '~w: the ending decides the format; it can be .~w'-[File, All] ].
usage_en(no_folder(Folder)) -->
    [ 'there is no folder ~w for the result'-[Folder], nl,
      '  Make it first.' ].
usage_en(cannot_write(File, permission)) -->
    [ '~w: the result may not be written there'-[File], nl,
      '  Check the permissions of the file and its folder, or name another.' ].
usage_en(cannot_write(output, Why)) -->
    [ 'the result cannot be written: ~w'-[Why], nl,
      '  Make room, or send it elsewhere.' ].
usage_en(no_segment(S, Known)) -->
    { atomic_list_concat(Known, ', ', All) },
    [ 'there is no segment ~w, only ~w'-[S, All] ].
usage_en(pattern(What)) -->
    pattern_fault_en(What).
usage_en(sheet(What)) -->
    sheet_en(What).
usage_en(exact_format(Format)) -->
    [ '--exact is for tables (csv, tsv, txt), not for ~w'-[Format] ].
usage_en(bad_goal(Text, Why)) -->
    [ 'this is no goal: ~w ('-[Text] ],
    syntax_words(Why),
    [ ')' ].

notice_en(do_not_meet) -->
    [ 'the segments do not meet: there are no penetration lines' ].
notice_en(points_alone(N)) -->
    [ 'the segments meet in points alone (~D): see explain vertex(S, V)'-
      [N] ].
notice_en(trim(What)) -->
    trim_en(What).
notice_en(unfold(What)) -->
    unfold_en(What).
notice_en(development(S, What)) -->
    development_notice_en(S, What).
notice_en(operand(What, S)) -->
    operand_notice_en(What, S).
notice_en(pattern(What)) -->
    pattern_en(What).
notice_en(one_segment) -->
    [ 'one segment alone has no penetration lines' ].
notice_en(empty_result(S, Name)) -->
    [ 'segment ~d (~p) is empty: nothing is left of its operands'-[S, Name] ].
notice_en(wrote(File)) -->
    [ 'wrote ~w'-[File] ].
notice_en(pen_travel(N, Way, Unsorted)) -->
    { Metres is Way/1.0e6, Before is Unsorted/1.0e6 },
    [ '~D lines for the pen; between them it goes ~3f m (~3f m unsorted)'-
      [N, Metres, Before] ].
notice_en(interrupted) -->
    [ 'interrupted' ].
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
notice_en(warnings_are_errors(N)) -->
    counted(N, warning, warnings),
    [ ', and --strict was given' ].
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

mesh_en(empty_file) -->
    [ 'the file is empty', nl,
      '  Get the whole file; perhaps the program that wrote it failed.' ].
mesh_en(no_faces) -->
    [ 'the mesh has neither a polygon nor a curve', nl,
      '  Export the model again, with its faces.' ].
mesh_en(unknown_format) -->
    [ 'this looks like no mesh: neither STL, OFF, OBJ nor PLY', nl,
      '  Give the file the ending of its format.' ].
mesh_en(unsupported(Text)) -->
    [ '~w is a kind of this format that is not read'-[Text], nl,
      '  Save it in plain text form.' ].
mesh_en(expected(Wanted, '')) -->
    [ 'nothing stands where ~w should come'-[Wanted], nl,
      '  Complete the line; if the file ends here, get the whole file.' ].
mesh_en(expected(Wanted, Text)) -->
    { Text \== '' },
    [ 'here stands ~w, where ~w should come'-[Text, Wanted], nl,
      '  Correct the line; is the file in the format of its ending?' ].
mesh_en(bad_number(Text)) -->
    [ 'this is no number: ~w'-[Text], nl,
      '  Write coordinates such as -12.5 or 1e-3, with a point.' ].
mesh_en(not_finite(Text)) -->
    [ 'a coordinate is ~w; it must be a finite number'-[Text], nl,
      '  Repair the model in the program that made it.' ].
mesh_en(too_far(Text)) -->
    [ 'the coordinate ~w is beyond 1.0e90'-[Text], nl,
      '  Choose other units: nothing can be computed at this size.' ].
mesh_en(bad_index(Index, Lowest, Highest)) -->
    { Lowest =< Highest },
    [ 'there is no vertex ~d; there are ~d to ~d'-[Index, Lowest, Highest],
      nl,
      '  Correct the number, or add the vertex.' ].
mesh_en(bad_index(Index, Lowest, Highest)) -->
    { Lowest > Highest },
    [ 'there is no vertex ~d; there are none so far'-[Index], nl,
      '  Give the vertices first.' ].
mesh_en(bad_count(What, Text)) -->
    [ 'the number of ~w cannot be ~q'-[What, Text], nl,
      '  Write a whole number, 0 or more.' ].
mesh_en(truncated(What, Present, Needed)) -->
    [ 'too short: ~D ~w are promised, at most ~D are there'-
      [Needed, What, Present], nl,
      '  The file is cut off: get the whole file.' ].
mesh_en(short_face(Corners)) -->
    [ 'a face or line with too few corners: ~d'-[Corners], nl,
      '  A face needs three corners, a line two: correct or remove it.' ].
mesh_en(too_large) -->
    [ 'more than 2,147,483,647 vertices or edges', nl,
      '  Part the model into several files.' ].
mesh_en(no_property(Property, Element)) -->
    [ 'element ~w needs one property ~w'-[Element, Property], nl,
      '  Export the model again as plain PLY.' ].

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

drawing_en(domain(sheet_size, W-H)) -->
    { number(W), number(H) },
    [ 'the picture would be ~0f x ~0f mm large'-[W,H], nl,
      '  Take a smaller --scale; a side can be above 0 and up to 100000 mm.' ].
drawing_en(domain(sheet_size, Size)) -->
    [ 'no sheet has the size ~p'-[Size], nl,
      '  Give width x height in mm, like 210x148, up to 100000.' ].
drawing_en(domain(raster_size, W-H)) -->
    [ 'a picture cannot have ~p x ~p dots'-[W, H], nl,
      '  Each side has 1 to 16384, all together 67 million at most.' ].
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


                /*******************************
                *             view             *
                *******************************/

fault_en(eye_in_model(D)) -->
    [ 'the eye is in or behind the model: its nearest point is at ~4g'-[D],
      nl,
      '  Give a larger RHO, or use the parallel projection.' ].


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
notice_en(no_area(S, Count, P)) -->
    [ 'polygons without area in segment ~d: ~D (the first is ~d)'-
      [S, Count, P], nl, '  Left out.' ].
fault_en(tolerance(Tolerance, Most)) -->
    [ 'a tolerance of ~4g is too large: a part is hardly larger'-[Tolerance],
      nl,
      '  Give --tolerance ~4g or less, or none.'-[Most] ].
fault_en(result_open) -->
    [ 'the result would not be closed', nl,
      '  Give a larger or smaller --tolerance, or --repair the operands.' ].

notice_en(opened(contacts)) -->
    [ 'what nearly touches was left as it is: else the result were open', nl,
      '  There may be splinters.' ].
notice_en(opened(faces)) -->
    [ 'coplanar faces were left apart: as one, the result were open' ].
notice_en(contacts(Why)) -->
    contacts_en(Why),
    [ nl,
      '  The lines are right for the model as it is; there may be splinters.' ].
notice_en(not_flat(S, Count, P, Off)) -->
    [ 'polygons that are not flat in segment ~d: ~D (the worst is ~d, by ~4g)'-
      [S, Count, P, Off], nl,
      '  Used as their triangles.' ].

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
fault_en(rules(Formal)) -->
    { \+ memberchk(Formal, [no_decision(_), no_decisions, module_file]) },
    [ 'this rule file cannot be loaded: ' ],
    loading_fault(Formal),
    [ nl, '  Correct it; the rules are as they were before.' ].

notice_en(decision(Name/Arity, Doc, By)) -->
    [ '~q/~d: ~w'-[Name, Arity, Doc], nl,
      '    defined by: ~w'-[By] ].

%!  syntax_words(+What)// is det.
%
%   What is wrong with a text that Prolog cannot read, in Prolog's words.

syntax_words(float_overflow) -->
    !,
    [ 'the number is too large' ].
syntax_words(What) -->
    '$messages':syntax_error(What),
    !.
syntax_words(What) -->
    [ '~w'-[What] ].

%!  loading_fault(+Formal)// is det.
%
%   What Prolog says of an error in a rule file.

loading_fault(syntax_error(What)) -->
    !,
    syntax_words(What).
loading_fault(Formal) -->
    '$messages':translate_message(error(Formal, _)).


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

%!  manual_page(+PI)// is det.
%
%   Where Prolog's manual has PI.

manual_page(Name/Arity) -->
    { format(atom(Text), '~w/~d', [Name, Arity]),
      uri_encoded(query_value, Text, Encoded)
    },
    [ '  https://www.swi-prolog.org/pldoc/man?predicate=~w'-[Encoded] ].


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
    { memberchk(Item, [hidden(_), hidden(_, _), why_not(_)]) },
    !,
    hidden_en(nothing(Item)).
notice_en(nothing_to_explain(Item)) -->
    [ 'there is nothing to explain in ~p'-[Item], nl,
      '  Ask for line(L), vertex(S, V), edge(S, E), \c
       pair(S1-P1, S2-P2), pair(S1, S2), piece(S, P) or piece(S, S0-P0), with \c
       numbers of the model; \c
       lines are there after penetrate. hidden(S, E) and \c
       why_not(hidden(S, E)) are of the picture; seam(S, E), fold(S, E) and \c
       pattern(S, K) of the flat pattern of segment S.' ].
%   Why contacts within the tolerance were not made to touch (resolve.pl).

contacts_en(wide(S, V)) -->
    [ 'vertex ~d of segment ~d hangs together with others over more than '-
      [V, S], 'three tolerances;', nl,
      '  what touches within the tolerance was left as it is.' ].
contacts_en(stuck(S, P)) -->
    [ 'polygon ~d of segment ~d cannot take in all that touches it '-[P, S],
      'within the tolerance;', nl, '  it was left as it is.' ].
