:- module(sg_model_file,
          [ read_model/3                % +File, +Settings, -Names
          ]).
:- use_module('../store',
              [ v/5, e/5, p/3, plane/6, t/6, leaf_v/5, leaf_e/5, leaf_p/3,
                leaf_t/6, segment/3, line/9, piece/3, joint/6, region/3,
                title_block/2, question/2, param_about/2, assert_fact/1,
                retractall_facts/1, facts_transaction/1
              ]).
:- use_module(item_where, [text_noted/2]).
:- use_module(model_text,
              [ model_text_bytes/3, next_written/3, formed_fact/4,
                place_error/2, place_error/3, place_location/3
              ]).
:- use_module(model_plain,
              [ with_plain_facts/3, plain_taken/3, plain_added/2,
                plain_segments/2
              ]).
:- use_module('../csg/csg', [complete_tree/1, written_leaves/2]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../kernel', [chain_fault/3, vertex_list_fault/3]).
:- use_module('../polygon/polygon_list',
              [vertex_list_edges/2, polygon_fault/2]).
:- use_module('../formula', [renamed_parameters/3]).
:- use_module(parameter, [file_parameters/3, parameter_value/3]).
:- use_module(parameter_about, [about_checked/5, ranges_told/1]).
:- use_module(formula_rows,
              [default_kept/2, formula_kept/2, parameters_added/3]).
:- use_module(look_file, [looks_added/2]).
:- use_module('../text_file', [with_text/4]).
:- use_module('../progress', [progress_by/1]).
:- use_module('../primitive/primitive',
              [ comma_argument/2, is_primitive/1, primitive_kind/2,
                primitive_shape/4 ]).
:- use_module('../primitive/primitive_rows',
              [commas_told/2, rows_left_out/0, shape_rows/4]).
:- use_module(shifted, [own_numbers/3, shifted/3]).
:- use_module(model_rows,
              [ ready/1, has_vertex/2, has_edges/1, has_polygon/2,
                edge_ends/3, row_added/2
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc), [empty_assoc/1, get_assoc/3, put_assoc/4]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> Model files: the paper's facts read into the world.

A file holds facts of the relations (model_text.pl), in any order, and:

  - `p(S, P, List)`. Where the file gives no e/5 of segment S, List is a
    vertex list, counter-clockwise from outside; edges are made, numbered in
    the order of the file. A negative number is a jump:
    `[1,2,3,4,1,-5,6,7,8,5]` has no edge from 1 to 5. A list without jumps
    closes itself (PL-2). Where the file gives e/5 of S, List is a list of
    edges.
  - `curve(S, [V1,V2,...])`: edges from each vertex to the next; `[V]` says
    that S is a point.
  - `segment(S, Kind, Name)`. Without it the kind follows from the rows:
    `curve` without polygons, `solid` if every edge has its opposite, else
    `surface`; the name is the file's. Where the file gives no vertices of S,
    Name is a primitive term that makes them (primitive.pl), or a node of the
    CSG tree (csg_term.pl), whose nested operands get segments of their own
    after those of the file.
  - `view(Theta, Phi, Rho)` and `projection(Kind)`, once each, and
    `title_block(Item, Text)` and `question(Name, Goal)`, once for an item or
    a name; they replace those of the world.
  - `look(S, Property)`, `light(N, Property)`: see look_file.pl.

  - `param(Name, Default)`, once for a name. Where the schema wants a number, a
    fact may have a formula over parameters (formula.pl); formula/2 keeps it.
    A parameter whose name is taken in the world by another one gets a new name.
  - `param_about(Name, Items)`, once for a parameter (parameter_about.pl).

Reading adds to the world: the segments of a file come after those that are
there, keeping their own numbers if there are none. It is all or nothing.

Errors besides those of model_text.pl:

    missing(Relation, S, Id)   a row that is referred to
    twice(Name, Key)           two rows with one key
    polygon(S, P, Why)         Why: list, edges(N), open(V), twice(V1, V2) or
                               no_edge(V)
    chain(S, V)                two equal neighbours in a curve
    primitive(What, Term)      see primitive.pl
    csg(What)                  see csg_term.pl
    kind(Term, Kind, Wanted)   a cylinder is no surface
    curve_polygon(S, P)        a curve has no polygons
    no_vertices(S, Name)   no_edges(S)   empty
    refused(Row, Error)        anything else the store does not take
    formula(What, Formula)     see formula.pl
    parameter(cycle(Names))    parameters that need each other
*/

%!  read_model(+File, +Settings, -Names) is det.
%
%   Add the model in File (`-`: standard input) to the current world. Settings
%   are pairs Name-Value for the parameters of the file that have these names
%   (others are of no use), Names are all that it has.
%
%   @error error(model_error(What), location(File, Line, Column)); the world
%   is then as before.

read_model(File, Settings, Names) :-
    with_text(facts(sg_model_text:first_fact_checked), File, Text,
              ( progress_by(model_text_bytes(Text)),
                text_read(Text, Settings, Names)
              )).

%   text_read(Text, Settings, Names): plain facts all at once; where one of them
%   is wrong all is read once more, now for the error; so it is if edges are
%   numbered by plain polygons and by others.

text_read(Text, Settings, Names) :-
    (   with_plain_facts(Text, Facts,
                         text_added_at_once(Text, Facts, Settings, Names))
    ->  true
    ;   text_added_at_once(Text, none, Settings, Names)
    ).

text_added_at_once(Text, Facts, Settings, Names) :-
    facts_transaction(
        sg_model_file:text_added(Text, Facts, Settings, Names)).

text_added(Text, Facts, Settings, Names) :-
    shifts(Shift),
    catch(text_added(Text, Facts, Shift, Settings, Names),
          error(model_error(What), Location),
          own_numbers(What, Location, Shift)).

text_added(Text, Facts, Shift, Settings, Names) :-
    arg(1, Text, Name),
    plain_taken(Facts, Text, Shift),
    streamed(Text, Facts, Shift, [], Ss0, Later0),
    plain_segments(Facts, Plain),
    later_formed(Later0, Name, Shift, Settings, Later, Names, Formulas),
    foldl(formed_segment, Formulas, Ss0, Ss1),
    append(Plain, Ss1, Ss),
    abouts_kept(Later, [], Abouts),
    catch(later_completed(Ss, Name, Facts, Later), Error,
          ( ranges_told(Abouts), throw(Error) )),
    forall(member(formula(Row, Written), Formulas),
           row_written(Row, Written)),
    (   Text = text(Path, Path, _)
    ->  text_noted(Path, Shift)
    ;   true
    ).

%   A value out of its range is told before the error that may come of it.

later_completed(Ss0, Name, Facts, Later) :-
    later_added(Facts, Later),
    sort(Ss0, Ss),
    (   Ss == []
    ->  throw(error(model_error(empty), location(Name, 0, 0)))
    ;   maplist(segment_completed(Later, Name), Ss),
        nodes_completed(Later),
        later_of(Later, look/2, Looks),
        later_of(Later, light/2, Lights),
        looks_added(Looks, Lights)
    ).

formed_segment(formula(Row, _), Ss0, Ss) :-
    with_segment(Row, Ss0, Ss).

%   shifts(Shift): Shift is shift(DS, DL), what is added to the segment and
%   line numbers of the file.

shifts(shift(DS, DL)) :-
    greatest(S, segment(S, _, _), DS),
    greatest(L, line(L, _, _, _, _, _, _, _, _), DL).

:- meta_predicate greatest(?, 0, -).

greatest(N, Goal, Greatest) :-
    (   aggregate_all(max(N), Goal, Greatest0)
    ->  Greatest = Greatest0
    ;   Greatest = 0
    ).


                /*******************************
                *           STREAMING          *
                *******************************/

%   streamed(Text, Facts, Shift, Ss0, Ss, Later): what is plain goes to Facts.
%   Rows of the others whose references are in the world already go into it as
%   they are read. Later is the list of later(Row, Place) of what is left, in
%   order; Ss has the segments of all rows that were not plain, some more than
%   once.

streamed(Text, Facts, Shift, Ss0, Ss, Later) :-
    next_written(Text, Fact, Place),
    plain_taken(Facts, Text, Shift),
    (   Fact == end_of_file
    ->  Ss = Ss0,
        Later = []
    ;   Fact = waiting(Term)
    ->  segment_commas_told(Facts, Term, Place),
        Later = [later(Fact, Place)|Later1],
        streamed(Text, Facts, Shift, Ss0, Ss, Later1)
    ;   segment_commas_told(Facts, Fact, Place),
        shifted(Shift, Fact, Row),
        few_written(Row, Place),
        with_segment(Row, Ss0, Ss1),
        (   added_now(Row, Place)
        ->  Later = Later1
        ;   Later = [later(Row, Place)|Later1]
        ),
        streamed(Text, Facts, Shift, Ss1, Ss, Later1)
    ).

%   segment_commas_told(Facts, Fact, Place): of what the file itself has, not of
%   values of formulas; nor of what is read once more.

segment_commas_told(Facts, Fact, Place) :-
    (   Facts \== none,
        Fact = segment(_, _, Term),
        once(comma_argument(Term, _))
    ->  place_location(Place, 3, Location),
        commas_told(Term, Location)
    ;   true
    ).

%   few_written(Row, Place): a tree has no more leaves written in it than there
%   may be: this is known before any of it is kept.

few_written(segment(S, _, Term), Place) :-
    is_node_term(Term),
    written_leaves(Term, Count),
    limit_value(nodes, Most),
    Count > Most,
    !,
    place_error(Place, 3, csg(too_many(S, Count))).
few_written(_, _).

%   with_segment(Row, Ss0, Ss): rows of a segment mostly follow one another;
%   one that comes back is there again.

with_segment(Row, Ss0, Ss) :-
    (   segment_of(Row, S),
        Ss0 \= [S|_]
    ->  Ss = [S|Ss0]
    ;   Ss = Ss0
    ).

segment_of(v(S, _, _, _, _), S).
segment_of(e(S, _, _, _, _), S).
segment_of(p(S, _, _), S).
segment_of(segment(S, _, _), S).
segment_of(curve(S, _), S).

added_now(p(S, P, Es), Place) :-
    !,
    has_edges(S),
    maplist(edge_ends(S), Es, Edges),
    sound_polygon(Edges, S, P, Place),
    row_added(p(S, P, Es), Place).
added_now(Row, Place) :-
    ready(Row),
    no_curve_of_polygons(Row, Place),
    row_added(Row, Place).

%   no_curve_of_polygons(Row, Place): Row calls nothing a curve that has
%   polygons already.

no_curve_of_polygons(Row, Place) :-
    (   Row = segment(S, curve, _),
        has_polygon(S, P)
    ->  place_error(Place, 2, curve_polygon(S, P))
    ;   true
    ).

                /*******************************
                *          PARAMETERS          *
                *******************************/

%   later_formed(Later0, File, Shift, Settings, Later, Names, Formulas): the
%   parameters among Later0, which are Names, are in the world, and Later has
%   the rows of what waited for them. Formulas are formula(Row, Written) of
%   these.

later_formed(Later0, File, Shift, Settings, Later, Names, Formulas) :-
    parameter_items(Later0, Items),
    file_parameters(Items, Settings, Parameters),
    findall(Name, member(parameter(Name, _, _), Parameters), Names),
    about_items(Later0, Names, Parameters),
    parameters_added(Parameters, File, Renamed),
    forall(( member(given(Name, Written, _), Items),
             memberchk(Name-_, Settings) ),
           ( own_name(Renamed, Name, Own),
             renamed_parameters(Renamed, Written, Default),
             default_kept(Own, Default) )),
    abouts_kept(Later0, Renamed, Abouts),
    catch(waiting_formed(Later0, Shift, Parameters, Renamed, Later, Formulas),
          Error,
          ( ranges_told(Abouts), throw(Error) )).

%   abouts_kept(Later, Renamed, Abouts): Name-Items of what is said of
%   parameters, under their names in the world.

abouts_kept(Later, Renamed, Abouts) :-
    findall(Own-OwnItems,
            ( member(later(param_about(Name, Items), _), Later),
              own_name(Renamed, Name, Own),
              renamed_parameters(Renamed, Items, OwnItems) ),
            Abouts).

own_name(Renamed, Name, Own) :-
    (   memberchk(Name-New, Renamed)
    ->  Own = New
    ;   Own = Name
    ).

%   about_items(Later, Names, Parameters): nothing is wrong with what is said of
%   parameters.

about_items(Later, Names, Parameters) :-
    later_of(Later, param_about/2, Abouts),
    forall(append(Before, [later(param_about(Name, Items), Place)|_], Abouts),
           (   memberchk(later(param_about(Name, _), _), Before)
           ->  place_error(Place, twice(param_about, [Name]))
           ;   about_checked(Name, Names, Items, parameter_value(Parameters),
                             Place)
           )).

parameter_items([], []).
parameter_items([later(Fact, Place)|Later], Items) :-
    (   ( Fact = param(Name, Written) ; Fact = waiting(param(Name, Written)) )
    ->  Items = [given(Name, Written, Place)|Items1]
    ;   Items = Items1
    ),
    parameter_items(Later, Items1).

waiting_formed([], _, _, _, [], []).
waiting_formed([Item|Later0], Shift, Parameters, Renamed, Later, Formulas) :-
    Item = later(Fact, Place),
    (   ( Fact = param(_, _) ; Fact = waiting(param(_, _)) )
    ->  Later = Later1,
        Formulas = Formulas1
    ;   Fact = waiting(Term)
    ->  formed_fact(Term, parameter_value(Parameters), Place, Formed),
        shifted(Shift, Formed, Row),
        renamed_parameters(Renamed, Term, Term1),
        shifted(Shift, Term1, Written),
        Later = [later(Row, Place)|Later1],
        Formulas = [formula(Row, Written)|Formulas1]
    ;   Fact = param_about(Name, Items)
    ->  own_name(Renamed, Name, Own),
        renamed_parameters(Renamed, Items, OwnItems),
        Later = [later(param_about(Own, OwnItems), Place)|Later1],
        Formulas = Formulas1
    ;   Later = [Item|Later1],
        Formulas = Formulas1
    ),
    waiting_formed(Later0, Shift, Parameters, Renamed, Later1, Formulas1).

%   row_written(Row, Written): the term of a node has the numbers of its
%   operands by now.

row_written(Row, Written) :-
    (   Row = segment(S, _, _),
        segment(S, Kind, Term)
    ->  formula_kept(segment(S, Kind, Term), Written)
    ;   formula_kept(Row, Written)
    ).


                /*******************************
                *             LATER            *
                *******************************/

%   later_added(Facts, Later): what had to wait, in the order of reference.
%   Edges made from lists are numbered after those that are given.

later_added(Facts, Later) :-
    later_rows(v/5, Facts, Later),
    later_rows(e/5, Facts, Later),
    later_of(Later, segment/3, Segments),
    maplist(later_segment, Segments),
    later_of(Later, p/3, Polygons0),
    maplist(later_form, Polygons0, Polygons),
    \+ numbered_among(Facts, Polygons),
    plain_added(Facts, p),
    empty_assoc(Numbers0),
    foldl(later_polygon, Polygons, Numbers0, Numbers),
    later_of(Later, curve/2, Curves),
    foldl(later_curve, Curves, Numbers, _),
    forall(member(Relation, [ plane/6, t/6, leaf_v/5, leaf_e/5, leaf_p/3,
                              leaf_t/6, from_v/4, from_p/5, line/9, piece/3,
                              joint/6, region/3, sides/4, from_r/4, lies_in/3,
                              gluing/2, unfolding/2 ]),
           later_rows(Relation, Facts, Later)),
    later_setting(Later, view/3),
    later_setting(Later, projection/1),
    later_named(Later, title_block/2),
    later_named(Later, question/2),
    later_abouts(Later).

%   numbered_among(Facts, Polygons) is semidet: edges of one of Polygons are
%   numbered in the order of the file, among those of plain ones of its segment.

numbered_among(Facts, Polygons) :-
    memberchk(form(vertices, _, _, _, _), Polygons),
    plain_segments(Facts, Ss),
    member(form(vertices, S, _, _, _), Polygons),
    memberchk(S, Ss),
    !.

later_of([], _, []).
later_of([Item|Later], Name/Arity, Items) :-
    Item = later(Row, _),
    (   functor(Row, Name, Arity)
    ->  Items = [Item|Items1]
    ;   Items = Items1
    ),
    later_of(Later, Name/Arity, Items1).

later_rows(Relation, Facts, Later) :-
    Relation = Name/_,
    plain_added(Facts, Name),
    later_of(Later, Relation, Items),
    forall(member(later(Row, Place), Items), row_added(Row, Place)).

later_setting(Later, Relation) :-
    later_of(Later, Relation, Items),
    (   Items = [_, later(_, Place)|_]
    ->  Relation = Name/_,
        place_error(Place, twice(Name, -))
    ;   Items = [later(Row, Place)]
    ->  functor(Row, Name, Arity),
        functor(Any, Name, Arity),
        retractall_facts(Any),
        row_added(Row, Place)
    ;   true
    ).

%   later_abouts(Later): of a parameter that two files have the first one says
%   what it is.

later_abouts(Later) :-
    later_of(Later, param_about/2, Items),
    forall(member(later(Row, Place), Items),
           ( Row = param_about(Name, _),
             (   param_about(Name, _)
             ->  true
             ;   row_added(Row, Place)
             ) )).

%   later_named(Later, Relation): what the last file says of a name holds.

later_named(Later, Relation) :-
    later_of(Later, Relation, Items),
    forall(member(later(Row, _), Items),
           ( same_name(Row, Same), retractall_facts(Same) )),
    forall(member(later(Row, Place), Items), named_added(Row, Place)).

named_added(Row, Place) :-
    same_name(Row, Same),
    (   call(Same)
    ->  Row =.. [Relation,Name|_],
        place_error(Place, twice(Relation, Name))
    ;   row_added(Row, Place)
    ).

same_name(Row, Same) :-
    Row =.. [Relation,Name,_],
    Same =.. [Relation,Name,_].

%   later_segment(Item): the row, and what its primitive makes.

later_segment(later(segment(S, Kind, Name), Place)) :-
    no_curve_of_polygons(segment(S, Kind, Name), Place),
    row_added(segment(S, Kind, Name), Place),
    (   has_vertex(S, _)
    ->  true
    ;   is_node_term(Name)
    ->  true
    ;   is_primitive(Name)
    ->  catch(term_shape(Name, Wanted, Points, Chains),
              error(model_error(What), _), place_error(Place, 3, What)),
        (   Kind == Wanted
        ->  catch(shape_rows(Wanted, S, Points, Chains),
                  error(model_error(Far), _), place_error(Place, 3, Far))
        ;   place_error(Place, 2, kind(Name, Kind, Wanted))
        )
    ;   place_error(Place, 3, no_vertices(S, Name))
    ).

%   term_shape(Term, Kind, Points, Chains): without points, if there are to be
%   no rows.

term_shape(Term, Kind, Points, Chains) :-
    (   rows_left_out
    ->  primitive_kind(Term, Kind),
        Points = [],
        Chains = []
    ;   primitive_shape(Term, Kind, Points, Chains)
    ).

%   later_form(Item, Form): whether the list of a polygon has vertices or
%   edges; decided for all before the first edges are made.

later_form(later(p(S, P, List), Place), form(Form, S, P, List, Place)) :-
    (   has_edges(S)
    ->  Form = edges
    ;   Form = vertices
    ).

later_polygon(form(vertices, S, P, List, Place), Numbers0, Numbers) :-
    list_polygon_added(S, P, List, Place, Numbers0, Numbers).
later_polygon(form(edges, S, P, Es, Place), Numbers, Numbers) :-
    (   maplist(edge_ends(S), Es, Edges)
    ->  sound_polygon(Edges, S, P, Place),
        row_added(p(S, P, Es), Place)
    ;   member(E, Es),
        \+ edge_ends(S, E, _),
        place_error(Place, 3, missing(e, S, E))
    ).

list_polygon_added(S, P, List, Place, Numbers0, Numbers) :-
    (   vertex_list_fault(S, List, Fault)
    ->  (   Fault = missing(V)
        ->  place_error(Place, 3, missing(v, S, V))
        ;   place_error(Place, 3, polygon(S, P, Fault))
        )
    ;   no_polygon_of_curve(S, P, Place)
    ),
    vertex_list_edges(List, Edges),
    edges_added(Edges, S, Place, Es, Numbers0, Numbers),
    row_added(p(S, P, Es), Place).

sound_polygon(Edges, S, P, Place) :-
    (   polygon_fault(Edges, Why)
    ->  place_error(Place, 3, polygon(S, P, Why))
    ;   no_polygon_of_curve(S, P, Place)
    ).

no_polygon_of_curve(S, P, Place) :-
    (   once(segment(S, curve, _))
    ->  place_error(Place, 1, curve_polygon(S, P))
    ;   true
    ).

later_curve(later(curve(S, Chain), Place), Numbers0, Numbers) :-
    chain_added(S, Place, Chain, Numbers0, Numbers).

chain_added(S, Place, Chain, Numbers0, Numbers) :-
    (   chain_fault(S, Chain, Fault)
    ->  (   Fault = missing(V)
        ->  place_error(Place, 2, missing(v, S, V))
        ;   Fault = chain(V),
            place_error(Place, 2, chain(S, V))
        )
    ;   chain_edges(Chain, Edges)
    ),
    edges_added(Edges, S, Place, _, Numbers0, Numbers).

chain_edges([_], []) :-
    !.
chain_edges([V, W|Vs], [V-W|Edges]) :-
    chain_edges([W|Vs], Edges).

%   edges_added(Edges, S, Place, Es, Numbers0, Numbers): rows of e/5 for the
%   edges V1-V2, numbered from the next number of S on.

edges_added(Edges, S, Place, Es, Numbers0, Numbers) :-
    (   get_assoc(S, Numbers0, E0)
    ->  true
    ;   greatest(E, e(S, E, _, _, _), Last),
        E0 is Last+1
    ),
    numbered_edges(Edges, S, Place, E0, Es, E1),
    put_assoc(S, Numbers0, E1, Numbers).

numbered_edges([], _, _, E, [], E).
numbered_edges([V1-V2|Edges], S, Place, E0, [E0|Es], E) :-
    row_added(e(S, E0, V1, V2, 1), Place),
    E1 is E0+1,
    numbered_edges(Edges, S, Place, E1, Es, E).


                /*******************************
                *         ROWS, SEGMENTS       *
                *******************************/

%   segment_completed(Later, File, S): S has a row, and edges. Fails where a
%   curve has plain polygons.

segment_completed(Later, File, S) :-
    (   once(segment(S, Kind, Term))
    ->  true
    ;   Kind = none,
        Term = none
    ),
    \+ ( Kind == curve, has_polygon(S, _) ),
    (   has_edges(S)
    ->  true
    ;   is_node_term(Term)
    ->  true
    ;   rows_left_out,
        is_primitive(Term),
        \+ has_vertex(S, _)
    ->  true
    ;   member(later(curve(S, [_]), _), Later)
    ->  true
    ;   member(later(Row, Place), Later),
        segment_of(Row, S)
    ->  place_error(Place, no_edges(S))
    ;   throw(error(model_error(no_edges(S)), location(File, 0, 0)))
    ),
    (   Kind == none
    ->  segment_kind(S, Made),
        file_name(File, Name),
        assert_fact(segment(S, Made, Name))
    ;   true
    ).

segment_kind(S, Kind) :-
    (   \+ has_polygon(S, _)
    ->  Kind = curve
    ;   forall(e(S, _, V1, V2, _), once(e(S, _, V2, V1, _)))
    ->  Kind = solid
    ;   Kind = surface
    ).

file_name(File, Name) :-
    file_base_name(File, Base),
    file_name_extension(Name, _, Base).

%   nodes_completed(Later): the CSG tree of the file. A fault is where the
%   node is, or the one that it was written in.

nodes_completed(Later) :-
    findall(N-Place,
            ( member(later(segment(N, _, Term), Place), Later),
              is_node_term(Term) ),
            Places),
    pairs_keys(Places, Nodes),
    catch(complete_tree(Nodes), error(model_error(What), nodes(Ns)),
          ( member(N, Ns),
            memberchk(N-Place, Places),
            place_error(Place, 3, What)
          )).
