:- module(test_verbs, []).
:- use_module(library(plunit)).
:- use_module(library(filesex)).
:- use_module(library(readutil)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(picture/contour), [line_ends/4]).
:- use_module(rules(picture/view)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(command/verbs)).

% Goal with the name of a new folder, which goes away, in an empty world.
:- meta_predicate in_folder(1).
in_folder(Goal) :-
    tmp_file(sanggwan, Folder),
    setup_call_cleanup(
        make_directory(Folder),
        ( new_world(World),
          in_world(World, call(Goal, Folder))
        ),
        delete_directory_and_contents(Folder)).

cube(Cube) :-
    absolute_file_name(sanggwan('facts/cube.pl'), Cube).

% Given(Name, Text): Text is Name as an atom or a string.
given(atom, Name, Name).
given(string, Name, Text) :-
    atom_string(Name, Text).

% The cube converted to an OFF file is a cube again.
there_and_back(Kind, List, Folder) :-
    cube(Cube),
    directory_file_path(Folder, 'a.off', File),
    given(Kind, Cube, From0),
    given(Kind, File, To),
    (   List == list
    ->  From = [From0]
    ;   From = From0
    ),
    convert(From, To),
    \+ segment(_, _, _),
    load_model(To),
    aggregate_all(count, v(_, _, _, _, _), 8),
    aggregate_all(count, p(_, _, _), 6).

% A world with a cube in it, drawn to a file of the Kind of name.
drawn(Kind, Folder) :-
    cube(Cube),
    given(Kind, Cube, Model),
    load_model(Model),
    directory_file_path(Folder, 'a.svg', File),
    given(Kind, File, To),
    draw(To, [view(front)]),
    size_file(File, Size),
    Size > 100.

% The picture of a box that is drawn turned, and the world afterwards.
drawn_up(Axis, Box, Drawn, Folder) :-
    directory_file_path(Folder, 'a.svg', File),
    add_primitive(Box, _),
    complete_segments([1]),
    vertices(Before),
    draw(File, [view(20,70),up(Axis)]),
    vertices(After),
    assertion(Before == After),
    findall(Length, drawn_line(Length), Lengths),
    msort(Lengths, Drawn).

% The text of a cube's drawing; Goal sets the eye before.
drawn_as(Goal, Options, Text, Folder) :-
    cube(Cube),
    load_model(Cube),
    call(Goal),
    directory_file_path(Folder, 'a.json', File),
    draw(File, Options),
    read_file_to_string(File, Text, []).

vertices(Vertices) :-
    findall(V-p(X,Y,Z), v(1, V, X, Y, Z), Vertices0),
    sort(Vertices0, Vertices).

drawn_line(Visibility-Length) :-
    drawn(_, 1, E, From, To, Visibility, _),
    line_ends(1, E, X1-Y1, X2-Y2),
    Length is round((To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2)*1.0e6).

% How many lines in the plane there are of Model, cut open; the world stays so.
drawn_open(Model, Count, Folder) :-
    directory_file_path(Folder, 'a.json', File),
    load_model(Model),
    rows(Rows0),
    draw(File, [cutaway('x=0.25'),view(front),up(y)]),
    rows(Rows),
    assertion(Rows == Rows0),
    read_file_to_string(File, Text, []),
    aggregate_all(count, sub_string(Text, _, _, _, "\"section\""), Count).

% The rows of a model before it is drawn, and before a box was added to it; and
% after one facts_undo/0 and another.

drawn_and_undone(Name, Options, Before, Undone, Folder) :-
    directory_file_path(Folder, 'a.svg', File),
    absolute_file_name(sanggwan(Name), Model),
    load_model(Model),
    rows(Rows1),
    facts_transaction(add_primitive(box(size(9,1,1)), _)),
    rows(Rows2),
    draw(File, Options),
    rows(Rows3),
    assertion(Rows3 \== Rows2),
    facts_undo,
    rows(Rows4),
    facts_undo,
    rows(Rows5),
    Before = [Rows2,Rows1],
    Undone = [Rows4,Rows5].

rows(Rows) :-
    findall(Row, a_row(Row), Rows0),
    sort(Rows0, Rows).

a_row(Row) :-
    relation(Name, Arity, _),
    \+ memberchk(Name, [plane,t]),
    functor(Row, Name, Arity),
    sg_store:Row.

:- begin_tests(verbs).

test(draw_cutaway, Squares == 1) :-
    cube(Cube),
    in_folder(drawn_open(Cube, Squares)).
test(draw_up, Turned == Straight) :-
    in_folder(drawn_up(y, box(size(1,3,2)), Turned)),
    in_folder(drawn_up(z, box(size(1,2,3)), Straight)),
    \+ in_folder(drawn_up(z, box(size(1,3,2)), Straight)).

% What an option says is what set_view/1 and its like say before.
test(draw_view, [ forall(member(Options-Goal,
                                [ [view(front)]-set_view(front),
                                  [view(20,70)]-set_view(20, 70, 0),
                                  [view(20,70,15),projection(central)]
                                  -( set_view(20, 70, 15),
                                     set_projection(central) ),
                                  [view(20,70,15)]-set_view(20, 70, 15) ])),
                  true(Drawn == Set) ]) :-
    in_folder(drawn_as(true, Options, Drawn)),
    in_folder(drawn_as(Goal, [], Set)).
test(views_differ, Count == 4) :-
    findall(Text,
            ( member(Options, [ [], [view(front)],
                                [view(20,70,15),projection(central)],
                                [view(20,70,9),projection(central)] ]),
              in_folder(drawn_as(true, Options, Text)) ),
            Texts0),
    sort(Texts0, Texts),
    length(Texts, Count).
test(convert, forall(( member(Kind, [atom, string]),
                       member(List, [one, list]) ))) :-
    in_folder(there_and_back(Kind, List)).
test(convert_other_ending, throws(error(usage_error(ending(_, _)), _))) :-
    cube(Cube),
    convert(Cube, "a.doc").
test(convert_missing,
     throws(error(model_error(cannot_read(missing)), _))) :-
    convert("no/such.pl", "a.off").
test(draw, forall(member(Kind, [atom, string]))) :-
    in_folder(drawn(Kind)).
test(draw_undone,
     [ forall(( member(Model, [ 'facts/cube.pl','facts/two_cubes.pl',
                                'facts/figures/csg01.pl',
                                'facts/figures/csg03.pl' ]),
                member(Options, [[],[view(20,70),up(y)],[lines(all)]]) )),
       true(Undone == Before) ]) :-
    in_folder(drawn_and_undone(Model, Options, Before, Undone)).

:- end_tests(verbs).
