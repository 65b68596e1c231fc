:- encoding(utf8).
:- module(test_openscad, []).
% covers: openscad_argument, openscad_extrusion, openscad_leaf
% covers: primitive_extrusion, primitive_turning, text_file
:- use_module(library(plunit)).
:- use_module(rules(command/check)).
:- use_module(rules(message/messages)).
:- use_module(rules(message/messages_ko)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(model/measures), []).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(model/openscad)).
:- use_module(rules(model/openscad_text)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests(rules/message_text), [message_text/3]).

% with_csg(Text, Goal, File): Goal on a file of that Text.
:- meta_predicate with_csg(+, -, 0).

with_csg(Text, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Stream, [extension(csg), encoding(utf8)]),
          write(Stream, Text),
          close(Stream) ),
        once(Goal),
        delete_file(File)).

csg(Text, Term) :-
    with_csg(Text, File, read_csg(File, Term)).

% told(Text, What, Line, Column): what is wrong, and where.
told(Text, What, Line, Column) :-
    with_csg(Text, File,
             catch(( read_csg(File, _), fail ),
                   error(model_error(What), location(File, Line, Column)),
                   true)).

volume(Term, Volume) :-
    new_world(World),
    in_world(World, ( added(Term), complete_segments, check_report(Report) )),
    report_faults(Report, 0),
    findall(V, ( member(S, Report.segments), V = S.volume ), Vs),
    sum_list(Vs, Volume).

% Islands of an extrusion are apart from each other.
added(union(Terms)) :-
    !,
    maplist(added, Terms).
added(Term) :-
    add_primitive(Term, _).

:- begin_tests(openscad_text).

test(all, Node == node([#,'%'], foo,
                       [a-1, 2-string("x\"y"), '$b'-[1.5,[-2.0e-5],[]],
                        4-true, c-undef, d-inf],
                       [node([], bar, [], [], location(File,2,3))],
                       location(File,1,4))) :-
    with_csg("# %foo(a = 1, \"x\\\"y\", $b=[1.5,[-2e-5],[],],true,c=undef,\c
              d= -inf) {\n  bar(); // no\n /* nor \n this */ };", File,
             read_openscad(File, [Node])).
test(numbers, Numbers == [1, -1, 0, 0.5, 0.5, -2.5, 1.0e10, 1.5e-7, 12]) :-
    with_csg("a([1, -1, -0, 0.5, .5, -2.5, 1e10, 1.5E-07, 12]);", File,
             read_openscad(File, [node(_, _, [1-Numbers], _, _)])).
test(empty, Nodes == []) :-
    with_csg(" // nothing\n", File, read_openscad(File, Nodes)).
test(deep, N == 512) :-
    deep(512, Text),
    with_csg(Text, File, read_openscad(File, Nodes)),
    depth(Nodes, 0, N).
test(too_deep, error(model_error(limit(blocks, 512)), _)) :-
    deep(513, Text),
    with_csg(Text, File, read_openscad(File, _)).
test(deeper_by_limit, [cleanup(set_limit(blocks, 512)), N == 2000]) :-
    set_limit(blocks, 2000),
    deep(2000, Text),
    with_csg(Text, File, read_openscad(File, Nodes)),
    depth(Nodes, 0, N).

deep(N, Text) :-
    findall("group() { ", between(1, N, _), Opening),
    findall("} ", between(1, N, _), Closing),
    append([Opening, ["cube();"], Closing], Parts),
    atomics_to_string(Parts, Text).

depth([node(_, group, _, Nodes, _)], N0, N) :-
    !,
    N1 is N0+1,
    depth(Nodes, N1, N).
depth([node(_, cube, _, [], _)], N, N).

:- end_tests(openscad_text).

% means(Text, Term)
means("cube(size = [1, 2, 3], center = true);",
      at([translate(0,0,-1.5)], box(size(1,2,3)))).
means("cube(size = 2);", at([translate(1.0,1.0,0)], box(size(2,2,2)))).
means("color([1, 0, 0, 1]) { render(convexity = 2) { cube(); } }",
      named(colour(rgb(255,0,0)),
            at([translate(0.5,0.5,0)], box(size(1,1,1))))).
means("color([0, 0.5, 1, 0.5]) { group() { color([1, 0, 0, 1]) { cube(); }
       multmatrix([[1,0,0,2],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {
       color([1, 1, 0, 1]) { cube(); } } } }",
      named(colour(rgb(0,128,255),0.5),
            union([at([translate(0.5,0.5,0)], box(size(1,1,1))),
                   at([translate(2,0,0)],
                      at([translate(0.5,0.5,0)], box(size(1,1,1))))]))).
means("color([-1, -1, -1, 1]) { cube(); }",
      at([translate(0.5,0.5,0)], box(size(1,1,1)))).
means("cylinder($fn = 6, h = 2, r1 = 1, r2 = 1, center = true);",
      at([translate(0,0,-1.0)],
         cylinder(radius(1), height(2), facets(6)))).
means("cylinder($fn = 2, h = 2, r1 = 1, r2 = 0.5);",
      cone(radius(1), top(0.5), height(2), facets(3))).
means("cylinder($fn = 7.9, h = 2, r1 = 0, r2 = 1);",
      at([mirror(z), translate(0,0,2)],
         cone(radius(1), height(2), facets(7)))).
means("cylinder($fa = 12, $fs = 2, h = 1, r1 = 1, r2 = 1);",
      cylinder(radius(1), height(1), facets(5))).
means("cylinder($fa = 12, $fs = 2, h = 1, r1 = 5, r2 = 3);",
      cone(radius(5), top(3), height(1), facets(16))).
means("cylinder($fa = 12, $fs = 2, h = 1, r1 = 50, r2 = 50);",
      cylinder(radius(50), height(1), facets(30))).
means("cylinder($fa = 12, $fs = 2, $fn = inf, h = 1, r1 = 5, r2 = 5);",
      cylinder(radius(5), height(1), facets(3))).
means("multmatrix([[1,0,0,3],[0,1,0,4],[0,0,1,5],[0,0,0,1]]) \c
       { multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) \c
         { cube(size = 2, center = true); } }",
      at([translate(0,0,-1.0), translate(3,4,5)], box(size(2,2,2)))).
means("multmatrix([[0,-1,0,3],[1,0,0,4],[0,0,1,5],[0,0,0,1]]) \c
       { union() { cube(size = 2, center = true); cylinder($fn=3); } }",
      at([matrix([[0,-1,0,3],[1,0,0,4],[0,0,1,5]])],
         union([at([translate(0,0,-1.0)], box(size(2,2,2))),
                cylinder(radius(1), height(1), facets(3))]))).
means("difference() { cylinder($fn=3); group(); cylinder($fn=4); }",
      difference([cylinder(radius(1), height(1), facets(3)),
                  cylinder(radius(1), height(1), facets(4))])).
means("intersection() { cylinder($fn=3); cylinder($fn=4); }\n\c
       cylinder($fn=5);",
      union([intersection([cylinder(radius(1), height(1), facets(3)),
                           cylinder(radius(1), height(1), facets(4))]),
             cylinder(radius(1), height(1), facets(5))])).
means("union() { group() { } cylinder($fn=3); cube(size = 0); }",
      cylinder(radius(1), height(1), facets(3))).
means("intersection() { cylinder($fn=3); cube(size = 0); } \c
       difference() { group(); cylinder($fn=9); } cylinder($fn=4);",
      cylinder(radius(1), height(1), facets(4))).
means("cylinder($fn=3); *cylinder($fn=4); %cylinder($fn=5);\c
       difference() { %cylinder($fn=6); #cylinder($fn=7); }",
      union([cylinder(radius(1), height(1), facets(3)),
             named(opacity(0.5),
                   cylinder(radius(1), height(1), facets(7)))])).
means("cylinder($fn=3); %group() { !cylinder($fn=4); } cylinder($fn=5);",
      cylinder(radius(1), height(1), facets(4))).
means("multmatrix([[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,1]]) { cube(); } \c
       cylinder($fn=3);", cylinder(radius(1), height(1), facets(3))).
means("linear_extrude(height = 0) { square(); } cylinder($fn=3); \c
       rotate_extrude(angle = 0) { square(); }",
      cylinder(radius(1), height(1), facets(3))).
means("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[0,0,0]], \c
       faces = [[0,1,2],[4,3,1,1],[1,3,2],[2,3,0],[0,0,1]]);",
      polyhedron(points([[0.0,0.0,0.0], [1.0,0.0,0.0], [0.0,1.0,0.0],
                         [0.0,0.0,1.0]]),
                 faces([[3,2,1], [2,4,1], [3,4,2], [1,4,3]]),
                 smooth(true))).
means("linear_extrude(height = 3) { multmatrix([[1,0,0,2],[0,1,0,0],\c
       [0,0,1,0],[0,0,0,1]]) { circle(r = 2, $fn = 4); } }",
      prism(outline([[2.0,-2.0], [4.0,0.0], [2.0,2.0], [0.0,0.0]]),
            height(3), smooth(true))).
means("linear_extrude(height = 3, center = true) { union() { \c
         square(size = [1, 2]); square(size = [3, 1]); } }",
      at([translate(0,0,-1.5)],
         prism(outline([[0.0,0.0], [3.0,0.0], [3.0,1.0], [1.0,1.0],
                        [1.0,2.0], [0.0,2.0]]), height(3)))).
means("linear_extrude(height = 3, scale = [0, 0]) { \c
       square(size = 2, center = true); }",
      pyramid(outline([[-1.0,-1.0], [1.0,-1.0], [1.0,1.0], [-1.0,1.0]]),
              height(3))).
means("linear_extrude(height = 3, twist = 90, slices = 4, scale = [2, 1]) { \c
       square(size = 2, center = true); }",
      prism(outline([[-1.0,-1.0], [1.0,-1.0], [1.0,1.0], [-1.0,1.0]]),
            height(3), twist(-90), scale(2,1), slices(4))).
means("rotate_extrude($fn = 7, angle = 360) \c
       { multmatrix([[1,0,0,2],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) \c
         { square(); } }",
      at([rotate(z,180)],
         turning(outline([[2.0,0.0], [3.0,0.0], [3.0,1.0], [2.0,1.0]]),
                 facets(7)))).
means("rotate_extrude($fn = 8, angle = -90) { square(); }",
      at([rotate(z,-90)],
         turning(outline([[0.0,0.0], [1.0,0.0], [1.0,1.0], [0.0,1.0]]),
                 angle(90), facets(2)))).
means("rotate_extrude($fn = 8, start = 30, angle = 90) { square(); }",
      at([rotate(z,30)],
         turning(outline([[0.0,0.0], [1.0,0.0], [1.0,1.0], [0.0,1.0]]),
                 angle(90), facets(2)))).

% faulty(Text, What, Line, Column)
faulty("cube(size = [1,2,3])", openscad(expected(body, end)), 1, 21).
faulty("\n a = 3;", openscad(expected('(', =)), 2, 4).
faulty("cube(size = );", openscad(expected(value, ')')), 1, 13).
faulty("cube(size = [1 2]);", openscad(expected(']', 2)), 1, 16).
faulty("cube(size = 1 2);", openscad(expected(')', 2)), 1, 15).
faulty("group() { cube(); ", openscad(expected('}', end)), 1, 19).
faulty("group() { cube(); }}", openscad(expected(name, '}')), 1, 20).
faulty("* * 5();", openscad(expected(name, 5)), 1, 5).
faulty("cube(a);", openscad(expected(value, a)), 1, 6).
faulty("text(\"x);", openscad(open_string), 1, 6).
faulty("cube();\n/* x", openscad(open_comment), 2, 1).
faulty("cube(); @", openscad(strange(@)), 1, 9).
faulty("group() {\n  text(text = \"A\"); }", openscad(unsupported(text, _)), 2,
       3).
faulty("hull() { cube(); }", openscad(unsupported(hull, _)), 1, 1).
faulty("minkowski() { cube(); }", openscad(unsupported(minkowski, _)), 1, 1).
faulty("import(file = \"a.stl\");", openscad(unsupported(import, _)), 1, 1).
faulty("linear_extrude(height=1) { offset(r = 1) { square(); } }",
       openscad(unsupported(offset, _)), 1, 28).
faulty("projection() { cube(); }", openscad(unsupported(projection, _)), 1, 1).
faulty("foo();", openscad(unknown(foo, _)), 1, 1).
faulty("cube(size = [1, 2]);", openscad(argument(cube, size, [1,2], size3)), 1,
       1).
faulty("cube(size = inf);", openscad(argument(cube, size, inf, size3)), 1, 1).
faulty("cube(size = [1, 1, 1e400]);", openscad(argument(cube, size, _, _)), 1,
       1).
faulty("cube(center = 1);", openscad(argument(cube, center, 1, flag)), 1, 1).
faulty("sphere(r = true);", openscad(argument(sphere, r, true, number)), 1, 1).
faulty("sphere(d = 2);", openscad(unknown_argument(sphere, d, _)), 1, 1).
faulty("cube([1,2,3]);", openscad(unknown_argument(cube, 1, _)), 1, 1).
faulty("linear_extrude(file = \"a.dxf\", height = 3) { square(); }",
       openscad(unknown_argument(linear_extrude, file, _)), 1, 1).
faulty("multmatrix() { cube(); }", openscad(missing(multmatrix, 1)), 1, 1).
faulty("multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]) { cube(); }",
       openscad(argument(multmatrix, 1, _, matrix)), 1, 1).
faulty("cube() { cube(); }", openscad(childless(cube)), 1, 10).
faulty("polygon(points = [[0,0],[1,0],[0,1]], paths = [[0,1,3]]);",
       openscad(no_point(polygon, 3)), 1, 1).
faulty("polyhedron(points = [[0,0,0]], faces = [[0,0,1]]);",
       openscad(no_point(polyhedron, 1)), 1, 1).
faulty("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], \c
        faces = [[0,1,2],[0,3,1],[1,3,2]]);",
       primitive(open_edge(_, _), _), 1, 1).
faulty("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], \c
        faces = [[2,1,0],[1,3,0],[2,3,1],[0,3,2]]);",
       primitive(inside_out, _), 1, 1).
faulty("\n square();", openscad(flat), 2, 2).
faulty("group();", openscad(nothing), 0, 0).
faulty("", openscad(nothing), 0, 0).
faulty("union() { cube(); square(); }", openscad(mixed(union)), 1, 19).
faulty("cube(); square();", openscad(mixed(group)), 1, 9).
faulty("linear_extrude(height = 1) { cube(); }",
       openscad(flat_extrusion(linear_extrude)), 1, 1).
faulty("linear_extrude(height = 1, scale = -1) { square(); }",
       openscad(argument(linear_extrude, scale, -1, factors)), 1, 1).
faulty("linear_extrude(height = 1, twist = 1e9, slices = 2) { square(); }",
       primitive(few_slices(2, _), _), 1, 1).
faulty("linear_extrude(height = 1, twist = 1e9) { square(); }",
       primitive(wrong_argument(slices(_), [count]), _), 1, 1).
faulty("linear_extrude(height = 1, slices = 9e5, twist = 3) { circle(r = 1, \c
        $fn = 50); }", primitive(too_many_vertices(_, _), _), 1, 1).
faulty("rotate_extrude() { square(size = 2, center = true); }",
       openscad(across_axis(-1.0, 1.0)), 1, 1).
faulty("rotate_extrude() { polygon(points = [[0,0],[1,0],[1,1]]); }",
       primitive(point_on_axis(0.0), _), 1, 1).

% measured(Text, Volume): what OpenSCAD 2021.01 makes of it has this volume
% (from its .off of six digits).
measured("sphere($fn=7, r=3);", 84.3479402).
measured("sphere($fn=3, r=3);", 24.801112).
measured("sphere($fn=0, $fa=12, $fs=2, r=10);", 4112.86228).
measured("linear_extrude(height=5, scale=[2,3], $fn=0, $fa=12, $fs=2) { \c
          multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,0],[0,0,0,1]]) { \c
          circle($fn=7, r=3); } }", 389.387707).
measured(Text, Volume) :-
    member(Arguments-Volume,
           [ "twist=90"-89.2479466, "twist=-400"-88.357432,
             "twist=90, scale=[2,2]"-211.44193,
             "twist=90, scale=[0.5,0.5], $fn=30"-52.96471,
             "twist=90, scale=[0.5,2]"-97.1253401,
             "twist=90, scale=[0,0], $fs=0.3"-30.7253371 ]),
    format(string(Text),
           "linear_extrude(height=10, ~w) { \c
            multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,0],[0,0,0,1]]) { \c
            square(size=3); } }", [Arguments]).
measured("linear_extrude(height=10, center=true, twist=-360, slices=200, \c
          scale=[0,0]) { square(size=[20,10], center=true); }", 675.282269).
measured("linear_extrude(height=10, scale=[1,0], $fn=0, $fa=12, $fs=2) { \c
          square(size=3); }", 45.0).
measured("linear_extrude(height=10, scale=0) { square(size=3); }", 30.0).
measured("linear_extrude(height=10, scale=[0,0.5], $fn=0, $fa=12, $fs=2) { \c
          difference() { square(size=10); \c
          multmatrix([[1,0,0,2],[0,1,0,3],[0,0,1,0],[0,0,0,1]]) { \c
          square(size=4); } } }", 350.0).
measured("linear_extrude(height=3) { polygon(points=[[0,0],[10,0],[10,10],\c
          [0,10],[2,2],[8,2],[18,8],[2,8]], paths=[[0,1,2,3],[4,5,6,7]]); }",
         217.2).
measured("linear_extrude(height=3) { polygon(points=[[0,0],[10,10],[10,0],\c
          [0,10]], paths=undef); }", 150.0).
measured("rotate_extrude(angle=-200, $fn=0, $fa=12, $fs=2) { \c
          multmatrix([[1,0,0,-3],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { \c
          square(); } }", 8.03482262).
measured("rotate_extrude(angle=77, $fn=7) { \c
          multmatrix([[1,0,0,3],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { \c
          square(); } }", 3.410295).
measured("rotate_extrude(angle=360, $fn=6) { \c
          polygon(points=[[0,0],[2,-1],[2,1]]); }", 13.8564065).
measured("rotate_extrude(angle=360, $fn=0, $fa=12, $fs=2) { intersection() { \c
          circle(r=5); \c
          multmatrix([[1,0,0,0],[0,1,0,-10],[0,0,1,0],[0,0,0,1]]) { \c
          square(size=20); } } }", 490.820884).

:- begin_tests(openscad).

test(means, [forall(means(Text, Term)), true(Read == Term)]) :-
    csg(Text, Read).
test(faulty, [ forall(faulty(Text, What, Line, Column)),
               true(Line0-Column0 == Line-Column) ]) :-
    told(Text, What, Line0, Column0).
test(volume, [ forall(measured(Text, Volume)),
               true(abs(Ours-Volume) =< 1.0e-5*Volume) ]) :-
    csg(Text, Term),
    volume(Term, Ours).
test(sphere_without_poles, Zs == [-1.5, -1.5, 1.5, 1.5]) :-
    csg("sphere($fn = 4, r = 2.1213203435596424);",
        turning(outline(Points), facets(4), smooth(true))),
    findall(Z, ( member([_, Z0], Points), Z is round(Z0*1.0e6)/1.0e6 ), Zs).
test(stdin, Term == cylinder(radius(1), height(1), facets(3))) :-
    with_csg("cylinder($fn = 3);", File,
             setup_call_cleanup(
                 ( stream_property(Old, alias(user_input)),
                   open(File, read, In) ),
                 ( set_stream(In, alias(user_input)),
                   read_csg(-, Term) ),
                 ( set_stream(Old, alias(user_input)),
                   close(In) ))).
test(missing, error(model_error(cannot_read(missing)))) :-
    read_csg('/nowhere/at/all.csg', _).
test(in_words, forall(( faulty(Text, _, _, _), member(L, [en, ko]) ))) :-
    with_csg(Text, File,
             catch(read_csg(File, _), Error, true)),
    message_text(L, Error, Message),
    once(sub_string(Message, _, _, _, "\n  ")).


%   What is seen has the colour of OpenSCAD: the outermost.
looks(Text, Looks) :-
    with_csg(Text, File,
             ( new_world(World),
               in_world(World,
                        ( load_model(File),
                          findall(Volume-Property,
                                  ( look(S, Property),
                                    sg_measures:volume(S, Volume) ),
                                  Looks0) ))
             )),
    msort(Looks0, Looks).

%   What it takes to read N squares apart, extruded or turned.

extruded_inferences(How, N, Inferences) :-
    findall(Text,
            ( between(1, N, I),
              X is 2*I,
              format(atom(Text),
                     "multmatrix([[1, 0, 0, ~w], [0, 1, 0, 0], [0, 0, 1, 0], \c
                      [0, 0, 0, 1]]) { square(size = [1, 1]); }",
                     [X]) ),
            Texts),
    atomic_list_concat([How, ' {'|Texts], All0),
    atom_concat(All0, ' }', All),
    statistics(inferences, I0),
    csg(All, _),
    statistics(inferences, I1),
    Inferences is I1-I0.

test(growth, [ forall(member(How, ['linear_extrude(height = 1)',
                                   'rotate_extrude()'])),
               true(Many < 5*Few) ]) :-
    extruded_inferences(How, 250, Few),
    extruded_inferences(How, 1000, Many).
test(colour_of_all, Looks == [1.0-colour(rgb(255,0,0))]) :-
    looks("color([1,0,0,1]) { cube(); }", Looks).
test(colours_of_parts, Looks == [ 1.0-colour(rgb(0,0,255)),
                                  8.0-colour(rgb(255,0,0)) ]) :-
    looks("union() { color([1,0,0,1]) { cube(size = 2); }
             multmatrix([[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {
             color([0,0,1,1]) { cube(); } } cube(size = 0.5); }", Looks).
test(outermost_colour, Looks == [7.0-colour(rgb(255,0,0))]) :-
    looks("color([1,0,0,1]) { difference() { cube(size = 2);
             color([0,0,1,1]) { cube(); } } }", Looks).
test(highlighted, Looks == [1.0-opacity(0.5)]) :-
    looks("difference() { cube(size = 2); #cube(); }", Looks).
test(highlighted_colour, Looks == [ 1.0-colour(rgb(0,0,255)),
                                    1.0-opacity(0.5) ]) :-
    looks("union() { #color([0,0,1,1]) { cube(); } }", Looks).
test(highlight_in_a_colour, Looks == [ 1.0-opacity(0.5),
                                       9.0-colour(rgb(0,0,255)) ]) :-
    looks("color([0,0,1,1]) { union() { cube(size = 2);
             #multmatrix([[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {
             cube(); } } }", Looks).
test(coloured_highlight, Looks == [ 1.0-colour(rgb(0,0,255)),
                                    1.0-opacity(0.5) ]) :-
    looks("color([0,0,1,1]) { #cube(); }", Looks).

:- end_tests(openscad).
