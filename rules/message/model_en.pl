:- module(sg_model_en,
          [ model_en//1,                % +What
            limit_en//1                 % +Name
          ]).
:- use_module('../csg/csg_term', [near_operands/2]).
:- use_module(look_en,
              [look_en//1, expected_look_en//1, expected_light_en//1]).
:- use_module(message_parts,
              [ counted//3, meant_en//1, shown_count/2, shown_value/2,
                syntax_words//1
              ]).
:- use_module('../primitive/primitive', [primitive_name/2]).
:- use_module(parameter_en, [parameter_en//1]).
:- use_module(primitive_en, [misshapen_en//1, primitive_names//0]).
:- use_module(library(apply), [maplist/3]).
/** <module> What is wrong with the text or the facts of a model, in English.

model_ko.pl has the same heads in Korean.
*/

%!  model_en(+What)// is semidet.
%
%   The message for model_error(What): what is wrong, and what to do.

model_en(cannot_read(missing)) -->
    [ 'there is no such file', nl,
      '  Check the name and the folder.' ].
model_en(cannot_read(directory)) -->
    [ 'is a folder, not a file', nl,
      '  Name a file in it.' ].
model_en(cannot_read(permission)) -->
    [ 'the file may not be read', nl,
      '  Check its permissions.' ].
model_en(cannot_read(io)) -->
    [ 'the file cannot be read to its end', nl,
      '  Check the disk or copy the file again.' ].
model_en(cannot_read(links)) -->
    [ 'links lead from one to the next without end', nl,
      '  Name a file, or correct the links (ls -l).' ].
model_en(cannot_read(device)) -->
    [ 'it is a device, whose octets have no end', nl,
      '  Name a file.' ].
model_en(cannot_read(long_name)) -->
    [ 'the name is too long for a file', nl,
      '  Most systems take 255 bytes, and 4,095 with the folders.' ].
model_en(cannot_read(Why)) -->
    { \+ memberchk(Why, [missing, directory, permission, io, links,
                         long_name, device]) },
    [ 'the file cannot be read: ~p'-[Why] ].
model_en(cityjson(Path, Why)) -->
    [ 'CityJSON, at ~w: '-[Path] ],
    cityjson_en(Why),
    [ nl, '  Nothing of the file was read; a validator says more.' ].
model_en(syntax(end_of_file)) -->
    [ 'the file ends in the middle of a fact', nl,
      '  It may be cut off; a fact ends with a full stop.' ].
model_en(syntax(end_of_file_in_quoted(_))) -->
    [ 'the file ends in quoted text that begins here', nl,
      '  Close the quote, or get the whole file.' ].
model_en(syntax(too_deep)) -->
    [ 'a term is nested too deeply to be read', nl,
      '  Write facts of numbers, atoms and short lists.' ].
model_en(syntax(Message)) -->
    { \+ memberchk(Message, [end_of_file, end_of_file_in_quoted(_),
                             too_deep]) },
    [ 'this is no Prolog text: ' ],
    syntax_words(Message),
    [ nl,
      '  Write facts such as v(1, 1, 0.0, 0.0, 0.0). with a full stop.' ].
model_en(limit(Name, Most)) -->
    [ 'more than ~D '-[Most] ],
    limit_en(Name),
    [ nl ],
    limit_way_en(Name).
model_en(limit(Name, Count, Most)) -->
    { shown_count(Count, Shown) },
    [ '~w '-[Shown] ],
    limit_en(Name),
    [ '; ~D are allowed'-[Most], nl ],
    limit_way_en(Name).
model_en(early_end) -->
    [ 'end_of_file stands in the middle of the file', nl,
      '  Remove it: what follows would be lost.' ].
model_en(directive(Goal)) -->
    [ 'a directive in a model file: :- ~p'-[Goal], nl,
      '  A model is data and is never run. Give rules with --rules FILE.' ].
model_en(rule(Head)) -->
    [ 'a rule in a model file: ~p :- ...'-[Head], nl,
      '  A model is data: facts only. Give rules with --rules FILE.' ].
model_en(no_fact(Term)) -->
    [ 'this is no fact: ~p'-[Term], nl,
      '  Write facts such as v(1, 1, 0.0, 0.0, 0.0).' ].
model_en(unknown_relation(Name, Arity)) -->
    [ 'there is no relation ~q/~d'-[Name, Arity], nl,
      '  A model has v/5, e/5, p/3, plane/6, t/6, segment/3, \c
       leaf_v/5, leaf_e/5, leaf_p/3, leaf_t/6, origin/3, from_v/4, \c
       from_p/5, line/9, curve/2, view/3, projection/1, \c
       title_block/2, look/2, light/2, param/2 and \c
       question/2.' ].
model_en(arity(Name, Arity, Wanted)) -->
    [ '~w has '-[Name] ],
    counted(Arity, argument, arguments),
    [ ' here, it needs ~d'-[Wanted], nl,
      '  Compare with the description of ~w/~d.'-[Name, Wanted] ].
model_en(computed(Name)) -->
    [ '~w is computed from the view and may not stand in a file'-[Name], nl,
      '  Remove it; draw makes it again.' ].
model_en(value(Relation, Column, Value, Expected)) -->
    { shown_value(Value, Shown) },
    [ '~w of ~w is ~w, it should be '-[Column, Relation, Shown] ],
    expected_en(Expected).
model_en(missing(Relation, S, Id)) -->
    { relation_word(Relation, Word) },
    [ 'segment ~d has no ~w ~d'-[S, Word, Id], nl,
      '  Add it, or correct the number.' ].
model_en(twice(Name, Key)) -->
    [ 'there are two facts ~w '-[Name] ],
    key_en(Key),
    [ nl, '  Remove one, or give it another number.' ].
model_en(polygon(S, P, Why)) -->
    [ 'polygon ~d of segment ~d '-[P, S] ],
    polygon_en(Why).
model_en(chain(S, V)) -->
    [ 'the curve of segment ~d goes from vertex ~d to itself'-[S, V], nl,
      '  Write every vertex of a chain once.' ].
model_en(formula(What, Formula)) -->
    parameter_en(formula(What, Formula)).
model_en(parameter(What)) -->
    parameter_en(What).
model_en(kind(Term, Kind, Wanted)) -->
    { primitive_name(Term, Name) },
    [ 'a ~w is a ~w, not a ~w'-[Name, Wanted, Kind], nl,
      '  Write segment(S, ~w, ~w(...)).'-[Wanted, Name] ].
model_en(no_vertices(_, Name)) -->
    misshapen_en(Name),
    !,
    [ nl, '  Or give the segment facts v/5 and p/3.' ].
model_en(no_vertices(S, Name)) -->
    [ 'segment ~d has no vertices, and ~p is no primitive'-[S, Name] ],
    { near_operands(Name, Near) },
    meant_en(Near),
    [ nl,
      '  Give facts v/5 and p/3, an operation (docs/model_files.md), or a \c
       primitive: ' ],
    primitive_names.
model_en(curve_polygon(S, P)) -->
    [ 'segment ~d is a curve, and has polygon ~d'-[S, P], nl,
      '  Call it surface or solid, or leave its polygons out.' ].
model_en(no_edges(S)) -->
    [ 'segment ~d has neither polygons nor edges'-[S], nl,
      '  Add p/3, e/5 or curve/2.' ].
model_en(title_block_only(Name)) -->
    [ 'a file for the title block has no ~w facts'-[Name], nl,
      '  Write title_block(Item, Text), such as \c
       title_block(name, "Bracket").' ].
model_en(look(What)) -->
    look_en(What).
model_en(empty) -->
    [ 'the model is empty', nl,
      '  Give at least one segment with vertices and polygons.' ].
model_en(refused(Row, Error)) -->
    [ 'the fact ~p is not possible: ~p'-[Row, Error] ].
model_en(unknown_format('', Formats)) -->
    !,
    { atomic_list_concat(Formats, ' .', All) },
    [ 'the name has no ending that says what the file is', nl,
      '  The ending of a model is .~w; or give it as standard input (-) \c
       with --from.'-[All] ].
model_en(unknown_format(Format, Formats)) -->
    { atomic_list_concat(Formats, ' .', All) },
    [ 'models of the format .~w are not known'-[Format], nl,
      '  The ending of a model is .~w.'-[All] ].


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
expected_en(number) -->
    [ 'a number, or a formula', nl,
      '  Lengths are in units of the model, angles in degrees; neither has \c
       a unit.' ].
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
expected_en(words) -->
    [ 'text or an atom, not an empty one' ].
expected_en(look(What)) -->
    expected_look_en(What).
expected_en(light(What)) -->
    expected_light_en(What).
expected_en(ground) -->
    [ 'an atom, a number or a compound of them', nl,
      '  Neither variables nor "text"; quote names like \'this one\'.' ].
expected_en(loose) -->
    [ 'v(V), a vertex, or e(E), an edge' ].
expected_en(around) -->
    [ 'r(R), a region, or p(P), a polygon' ].
expected_en(atom) -->
    [ 'an atom' ].
expected_en(one_of(Atoms)) -->
    { atomic_list_concat(Atoms, ', ', Text) },
    [ 'one of ~w'-[Text] ].

relation_word(v, vertex).
relation_word(e, edge).
relation_word(p, polygon).
relation_word(region, region).
relation_word(leaf_e, leaf_e).

key_en(Key) -->
    (   { is_list(Key) }
    ->  { maplist(term_to_atom, Key, Words),
          atomic_list_concat(Words, ', ', Text) },
        [ 'with the numbers ~w'-[Text] ]
    ;   { Key == - }
    ->  [ 'where one may stand' ]
    ;   [ 'of ~q, where one may stand'-[Key] ]
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
                *            limits            *
                *******************************/

%!  limit_en(+Name)// is det.
%
%   What the limit Name (limits.pl) is of.

limit_en(depth) -->
    [ 'levels of terms, lists and operators in one another' ].
limit_en(blocks) -->
    [ 'levels of blocks in one another in a .csg file' ].
limit_en(digits) -->
    [ 'characters of a number' ].
limit_en(name) -->
    [ 'characters of a name or a text' ].
limit_en(fact) -->
    [ 'characters of a fact' ].
limit_en(file) -->
    [ 'octets of a .csg or CityJSON file' ].
limit_en(text) -->
    [ 'octets of a text' ].
limit_en(clauses) -->
    [ 'clauses of a rule file' ].
limit_en(facets) -->
    [ 'corners of a primitive' ].
limit_en(values) -->
    [ 'values of a variable' ].
limit_en(variants) -->
    [ 'variants of a problem' ].
limit_en(nodes) -->
    [ 'leaves of a tree, each as often as it is used' ].

limit_way_en(Name) -->
    [ '  To allow more: --limits ~w=N, in a program set_limit(~w, N).'-
      [Name, Name] ].

cityjson_en(syntax) -->
    [ 'this is no JSON' ].
cityjson_en(no_cityjson) -->
    [ 'the type is not "CityJSON"' ].
cityjson_en(version(Version)) -->
    [ 'version ~w is not known: it can be 1.0, 1.1 or 2.0'-[Version] ].
cityjson_en(missing(Key)) -->
    [ '"~w" is missing'-[Key] ].
cityjson_en(nesting) -->
    [ 'lists or objects are not nested as the type wants it' ].
cityjson_en(triple) -->
    [ 'three numbers are wanted' ].
cityjson_en(too_far) -->
    [ 'a coordinate is farther out than 1e90' ].
cityjson_en(index(Index)) -->
    [ 'an index of a vertex is wanted, not ~p'-[Index] ].
cityjson_en(index(Index, Count)) -->
    [ 'there is no vertex ~d, of ~D from 0 on'-[Index, Count] ].
cityjson_en(ring) -->
    [ 'a ring has fewer than three vertices' ].
cityjson_en(geometry(Type)) -->
    [ 'the geometry ~p is not known'-[Type] ].
cityjson_en(no_lod(Lod)) -->
    [ 'no geometry has the level of detail ~w'-[Lod] ].
