:- encoding(utf8).
:- module(test_provoked, []).
:- use_module(library(plunit)).
:- use_module(library(filesex)).
:- use_module(library(http/json)).
:- use_module(rules(command/cli)).
:- use_module(rules(message/messages)).
:- use_module(rules(model/mesh)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(message/messages_ko)).
:- use_module(tests(rules/message_text), [message_text/3]).

/* Every notice and every warning is provoked by a command, and no other
   warning comes with it. A notice that no command here provokes is in
   elsewhere/2, with the reason. */

% --- models ------------------------------------------------------------------

tried(1, 0).
tried(Part, 1) :- Part is 2.0** -8.
tried(Part, 2) :- Part is 2.0** -16.

around(Y0, Turn0, More, Y-Z) :-
    Turn is Turn0+More,
    Y is Y0+cos(Turn),
    Z is sin(Turn).

times(Factor, X, Y) :-
    Y is Factor*X.

sheet_line(S, Points, Face, Line) :-
    format(string(Line), "segment(~w, surface, \c
                          sheet(points(~w), faces([~w]))).~n",
           [S,Points,Face]).

file('tee.pl', "segment(1, solid, at([rotate(y,90), translate(-30,0,0)],
                     cylinder(radius(10), height(60)))).
segment(2, solid, cylinder(radius(10), height(40))).
unfolding(1, removed([base, top])). unfolding(2, removed([base, top])).\n").
file('cube.pl', "segment(1, solid, box(size(1,1,1))).\n").
file('crossing.pl', "v(1,1,-1,-1,0). v(1,2,1,-1,0). v(1,3,1,1,0).
v(1,4,-1,1,0). v(1,5,-1,0,-1). v(1,6,1,0,-1). v(1,7,1,0,1). v(1,8,-1,0,1).
p(1,1,[1,2,3,4]). p(1,2,[5,6,7,8]).\n").
file('far.pl', "segment(1, solid, box(size(1,1,1))).
segment(2, solid, at([translate(9,0,0)], box(size(1,1,1)))).\n").
file('near.pl', Text) :-
    findall(Line,
            ( between(1, 6, S),
              X is 1.0001*S,
              format(string(Line),
                     "segment(~d, solid, at([translate(~w,0,0)], \c
                      box(size(1,1,1)))).~n", [S,X]) ),
            Lines),
    atomics_to_string(Lines, Text).
% Touching leaves the result open: the second goes through two places of the
% first that are nearer to each other than the tolerance.
file('splinter.pl', "segment(1, solid,
    prism(outline([[0,0],[4,0],[4,4],[2,0.08],[0,4]]), height(2))).
segment(2, solid, at([translate(1.6,0,0.25)],
    prism(outline([[0,0],[4,0],[4,0.06],[2,0.03],[0,0.06]]), height(2)))).\n").
% Rows of corners that hang together over more than three tolerances, and
% polygons that go through themselves when they touch; again as near as the
% parts of the tolerance that are tried.
file('chained.pl', Text) :-
    findall(Line,
            ( tried(Part, At), between(0, 5, I),
              S is 6*At+I+1,
              X is 0.009*I*Part,
              Y is 10.0*At,
              Turn is 55*I*pi/180,
              maplist(around(Y, Turn), [0,0.17], [Y1-Z1,Y2-Z2]),
              sheet_line(S, [[X,Y,0],[X,Y1,Z1],[X,Y2,Z2]], [1,2,3], Line) ),
            Lines),
    atomics_to_string(Lines, Text).
file('stuck.pl', Text) :-
    findall(Line,
            ( tried(Part, At),
              Z is 10.0*At,
              maplist(times(0.01*Part), [0.35,1.11,1.08,1.085,-0.09],
                      [A,B,C,D,E]),
              S1 is 2*At+1,
              S2 is S1+1,
              Z1 is Z+2*E,
              Z2 is Z+E,
              (   sheet_line(S1, [[0,0,Z],[3,0,Z],[3,1,Z],[0.77,A,Z],[0,1,Z]],
                             [1,2,3,4,5], Line)
              ;   sheet_line(S2, [[1.5,B,Z1],[0.5,C,Z1],[-1.5,D,Z2]], [1,2,3],
                             Line)
              ) ),
            Lines),
    atomics_to_string(Lines, Text).
file('open.json',
     "{\"type\":\"CityJSON\",\"version\":\"2.0\",\c
       \"vertices\":[[0,0,0],[1,0,0],[0,1,0]],\c
       \"CityObjects\":{\"o\":{\"geometry\":[\c
         {\"type\":\"Solid\",\"lod\":\"1\",\c
          \"boundaries\":[[[[0,1,2]]]]},\c
         {\"type\":\"MultiSurface\",\"lod\":\"1\",\c
          \"boundaries\":[[[0,1,0]]]},\c
         {\"type\":\"GeometryInstance\",\"lod\":\"1\",\c
          \"boundaries\":[0]}]}}}").
file('latin1.txt', "no model\n").
file('cross.pl', "segment(1, solid, box(size(2,2,2))).
segment(2, solid, at([translate(1,1,1)], box(size(2,2,2)))).\n").
file('within.pl', "segment(1, solid, box(size(4,4,4))).
segment(2, solid, at([translate(0,0,1)], box(size(1,1,1)))).\n").
file('tip.pl', "segment(1, solid, box(size(2,2,2))).
segment(2, solid, at([translate(0,0,4),rotate(x,180)],
                     cone(radius(1), height(2), facets(8)))).\n").
file('unseen.obj', "o a\u202Eb\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n\c
                    f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n").
file('sheet.pl', "segment(1, surface, rectangle(size(1,1))).
segment(2, solid, at([translate(0,0,-2)], box(size(1,1,2)))).\n").
file('row.pl', "segment(1, solid, box(size(1,1,1))).
segment(2, solid, at([translate(0.9999,0,0)], box(size(1,1,1)))).
segment(3, solid, at([translate(1.9998,0,0)], box(size(1,1,1)))).
segment(4, solid, at([translate(2.9997,0,0)], box(size(1,1,1)))).
segment(5, solid, at([translate(3.9996,0,0)], box(size(1,1,1)))).\n").
file('united.pl', "segment(1, surface, rectangle(size(4,4))).
segment(2, solid, box(size(1,1,1))).
segment(3, surface, union([1,2])).\n").
file('curve.pl', "v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,1,1,0).
e(1,1,1,2,1). e(1,2,2,3,1). segment(1, curve, wire).
segment(2, solid, box(size(1,1,1))).\n").
file('ranges.pl', "param(a, 2). param(idle, 1).
param_about(a, [min(1), max(9)]).
segment(1, solid, box(size(param(a), 1, 1))).\n").
file('latin.pl', "segment(1, solid, named('a\u00FFb', box(size(1,1,1)))).\n").
file('style.pl', "line(any, any, glas, [width(1)]).\n").
file('style_lines.pl', "line(any, penetration, 1, [width(1)]).\n").
file('thin.pl', "segment(1, solid, box(size(4,4,0.001))).\n").
file('looks.pl', "look(glas, colour(red)).\n").
file('nowhere.pl', "line(any, any, any, [none]).\n").
file('degenerate.off', "OFF\n4 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\c
3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 1 1 2\n").
file('ignored.obj', "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nflub 1 2\n\c
f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n").
file('inside_out.off', "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\c
3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n").
file('turned.off', "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\c
3 0 1 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n").
file('twice.off', "OFF\n4 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\c
3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 2 1\n").
file('tangled.off', "OFF\n25 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n\c
5 0 0\n6 0 0\n7 0 0\n8 0 0\n9 0 0\n10 0 0\n11 0 0\n12 0 0\n13 0 0\n\c
14 0 0\n15 0 0\n16 0 0\n17 0 0\n18 0 0\n19 0 0\n20 0 0\n21 0 0\n\c
22 0 0\n23 0 0\n0 5 0\n\c
25 0 23 1 22 2 21 3 20 4 19 5 18 6 17 7 16 8 15 9 14 10 13 11 12 24\n").
file('thin.off', "OFF\n5 6 0\n0 0 0\n2 0 0\n0 1 0\n0 0 1\n1 0 0\n\c
3 0 2 1\n3 0 4 3\n3 4 1 3\n3 1 2 3\n3 2 0 3\n3 0 1 4\n").
file('open.off', "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\c
3 0 1 3\n3 1 2 3\n3 2 0 3\n").
file('welded.off', "OFF\n12 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n\c
1 0 0\n0 1 0\n0 0 1\n0 1 0\n0 0 0\n0 0 1\n\c
3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n").
file('empty.pl', "segment(1, solid, box(size(1,1,1))).
segment(2, solid, at([translate(9,0,0)], box(size(1,1,1)))).
segment(3, solid, intersection([1,2])).\n").
file('throws.pl', "edge_role(_, _, _, _, _) :- throw(oops).\n").
file('box.pl', "segment(1, solid, box(size(9,9,1.5))).\n").
file('wide.pl',
     "param(w, 9). segment(1, solid, box(size(param(w),1,1))).\n").
file('narrow.pl',
     "param(w, 1). segment(1, solid, box(size(param(w),1,1))).\n").
file('comma.pl',
     "segment(1, solid, cylinder(radius(57,15), height(9))).\n").
file('apart.pl', Text) :-
    findall("a(1). b(1).\n", between(1, 60, _), Lines),
    atomics_to_string(Lines, Text).
file('ball.pl', "segment(1, solid, sphere(radius(1),facets(12))).\n").
file('wire.pl', "v(1,1,0,0,0). v(1,2,1,0,0). e(1,1,1,2,1).
segment(1, curve, wire).\n").
file('tiny.pl', "segment(1, solid, box(size(1.0e-11,1.0e-11,1.0e-11))).\n").
file('pin.pl', "segment(1, solid, box(size(2,2,2))).
v(2,1,0,0,-1). v(2,2,0.1,0.2,5). e(2,1,1,2,1). segment(2, curve, pin).\n").
file('bent.pl', "v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,1,1,0.3). v(1,4,0,1,0).
e(1,1,1,2,1). e(1,2,2,3,1). e(1,3,3,4,1). e(1,4,4,1,1).
p(1,1,[1,2,3,4]). segment(1, surface, bent).\n").
file('plug.pl', "segment(1, solid, box(size(4,4,2))).
segment(2, solid, at([translate(0,0,1)], box(size(1,1,4)))).\n").
file('two_welds.pl', "v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). v(1,4,0,0,1).
v(1,5,0,0,0). v(1,6,1,0,0). v(1,7,0,1,0).
e(1,1,1,3,1). e(1,2,3,2,1). e(1,3,2,1,1). p(1,1,[1,2,3]).
e(1,4,5,6,1). e(1,5,6,4,1). e(1,6,4,5,1). p(1,2,[4,5,6]).
e(1,7,6,7,1). e(1,8,7,4,1). e(1,9,4,6,1). p(1,3,[7,8,9]).
e(1,10,7,5,1). e(1,11,5,4,1). e(1,12,4,7,1). p(1,4,[10,11,12]).
segment(1, solid, split).\n").
file('grain.pl', "segment(1, solid, at([translate(1.0e9,0,0)],
                     box(size(1,1,1)))).\n").
file('bows.pl', "segment(1, surface, sheet(points([[0,0,0],[4,0,0],[0,1,0],
    [1,1,0],[0,3,0],[4,3,0],[0,4,0],[1,4,0]]), faces([[1,2,3,4],[5,6,7,8]]))).
").
file('bow.pl', "v(1,1,0,0,0). v(1,2,4,0,0). v(1,3,0,1,0). v(1,4,1,1,0).
e(1,1,1,2,1). e(1,2,2,3,1). e(1,3,3,4,1). e(1,4,4,1,1).
p(1,1,[1,2,3,4]). segment(1, surface, bow).\n").
file('saw.pl', "segment(1, solid, cone(radius(40), height(200), facets(40))).
\n").
file('double.off', "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n\c
3 0 1 2\n3 0 1 3\n3 0 1 4\n").
file('ring.pl', "segment(1, solid, torus(radius(28), tube(9), facets(12))).\n").
file('touching.pl', "segment(1, solid, torus(radius(60), tube(20))).
segment(2, solid, at([rotate(y,90), translate(40,0,10)],
                     cylinder(radius(10), height(80)))).\n").
file('house.pl', "segment(1, solid, named(case, box(size(200,300,40)))).\n").
file('pipes.pl', "segment(1, solid,
        cylinder(radius(2), height(8), facets(24))).
segment(2, solid, at([translate(0,0,4),rotate(y,90)],
                     cylinder(radius(1), height(6), facets(24)))).\n").
file('skin.pl', Text) :-
    skins(1, Text).
file('skins.pl', Text) :-
    skins(4, Text).
file('round.pl', "segment(1, solid, sphere(radius(2), facets(24))).\n").
file('hollow.pl', "segment(1, solid, difference([2,3])).
segment(2, solid, sphere(radius(10), facets(24))).
segment(3, solid, sphere(radius(9.9), facets(24))).\n").
file('dot.pl', "pixel_colour(_, _, _, red).\n").
file('tone.pl', "tone(_, _, 0.5).\n").
file('ball.pl', "segment(1, solid, sphere(radius(2), facets(24))).\n").
file('role.pl', "edge_role(_, _, _, _, crease).\n").

%   skins(N, Text): tetrahedra, surfaces, each with two vertices in one place.

skins(N, Text) :-
    findall(Facts,
            ( between(1, N, S), X is 3*S, X1 is X+1,
              format(string(Facts), "segment(~d, surface, skin).
v(~d,1,~d,0,0). v(~d,2,~d,0,0). v(~d,3,~d,1,0).
v(~d,4,~d,0,1). v(~d,5,~d,0,0).
e(~d,1,1,3,1). e(~d,2,3,2,1). e(~d,3,2,1,1). p(~d,1,[1,2,3]).
e(~d,4,1,2,1). e(~d,5,2,4,1). e(~d,6,4,1,1). p(~d,2,[4,5,6]).
e(~d,7,2,3,1). e(~d,8,3,4,1). e(~d,9,4,2,1). p(~d,3,[7,8,9]).
e(~d,10,3,5,1). e(~d,11,5,4,1). e(~d,12,4,3,1). p(~d,4,[10,11,12]).\n",
                     [ S,S,X,S,X1,S,X,S,X,S,X,S,S,S,S,S,S,S,S,S,S,S,S,S,S,
                       S,S ]) ),
            Texts),
    atomic_list_concat(Texts, Text).

% command(Notice, Arguments): the command prints Notice; @(Name) is a file.
command(do_not_meet, [penetrate, @('far.pl')]).
command(cells_apart(_,_,_,_), [cells, @('crossing.pl')]).
command(glue_overlap(_,_,_,_,_), [glue, @('cross.pl')]).
command(glue_overlaps(_,1), [glue, @('row.pl')]).
command(glue_thin(_,4,_), [glue, @('row.pl')]).
command(glue_surface(_,_,_), [glue, @('skin.pl')]).
command(glue_surfaces(_,1), [glue, @('skins.pl')]).
command(glue_apart(_), [glue, @('far.pl')]).
command(cityjson_open(_,_), [check, @('open.json')]).
command(cityjson_left_out(_,_), [check, @('open.json')]).
command(cityjson_no_area(_,_), [check, @('open.json')]).
command(cityjson_floors(_,_), [check, '--close', @('open.json')]).
command(glue_gap(_,_,_,_,_), [glue, @('near.pl')]).
command(glue_gaps(_,_), [glue, @('near.pl')]).
command(cells_parted(_,_), [unglue, 'facts/two_rooms.pl', '-o', @('a.pl')]).
command(nothing_glued, [unglue, @('cube.pl'), '-o', @('a.pl')]).
command(one_segment, [penetrate, @('cube.pl')]).
command(points_alone(_), [penetrate, @('pin.pl')]).
command(opened, [union, @('splinter.pl'), '--tolerance', '0.06', '-o',
                 @('a.pl')]).
command(contacts(wide(_,_)), [penetrate, @('chained.pl'), '--tolerance', '0.01',
                              '-o', @('a.pl')]).
command(contacts(stuck(_,_)), [penetrate, @('stuck.pl'), '--tolerance', '0.01',
                               '-o', @('a.pl')]).
command(tangled(_,1,_,_),
        [check, '--limits', 'contacts=1', @('tangled.off')]).
command(no_area(_,1,_), [check, @('thin.off')]).
command(not_flat(_,1,_,_), [check, @('bent.pl')]).
command(polygon_edge(_,_,_,_), [check, @('bow.pl')]).
command(polygon_edges(_,2,_,_,_), [check, @('bows.pl')]).
command(parameter(renamed(_,_,_)), [check, @('wide.pl'), @('narrow.pl')]).
command(comma(_,_), [check, @('comma.pl')]).
command(comma(_,none), [query, @('cube.pl'), 
                         'X = cylinder(radius(57,15), height(2))']).
command(parameter(unused(_)), [check, @('ranges.pl'), '--set', 'idle=3']).
command(parameter(range(_,_,_,_)), [check, @('ranges.pl'), '--set', 'a=30']).
command(wrote(_), [draw, @('cube.pl'), '-o', @('a.svg')]).
command(pen_travel(_,_,_), [draw, @('cube.pl'), '-o', @('a.hpgl')]).
command(nothing_drawn, [draw, @('wire.pl'), '--lines', penetration,
                        '--sheet', 'A4', '-o', @('a.svg')]).
command(nothing_seen, [render, @('empty.pl'), '--size', '9x9',
                       '-o', @('a.png')]).
command(nothing_in_window, [render, @('cube.pl'), '--size', '9x9',
                            '--window=50,50,60,60', '-o', @('a.png')]).
command(not_shaded(_,_), [render, @('curve.pl'), '--size', '9x9',
                          '-o', @('a.png')]).
command(points_in_vain, [draw, @('cube.pl'), '--points', '4',
                         '-o', @('a.svg')]).
command(format_option('--dpi',png), [draw, @('cube.pl'), '--dpi', '30',
                                     '-o', @('a.svg')]).
command(surface_uncut(_), [render, @('sheet.pl'), '--size', '9x9',
                           '--section', 'z=-1', '-o', @('a.png')]).
command(surface_see_through(_), [render, @('united.pl'), '--size', '9x9',
                                 '--see-through', '2', '-o', @('a.png')]).
command(pixel_colour_asked(_), [render, @('cube.pl'), '--rules', @('dot.pl'),
                                '--size', '9x9', '-o', @('a.png')]).
command(pixel_colour_in_vain, [render, @('cube.pl'), '--rules', @('dot.pl'),
                               '--size', '9x9', '--background', none,
                               '-o', @('a.png')]).
command(facets_off(_), [render, @('ball.pl'), '-o', @('a.png')]).
command(shadows_in_vain, [render, @('cube.pl'), '--rules', @('tone.pl'),
                          '--shadows', '--size', '9x9', '-o', @('a.png')]).
command(thinner_than_lines, [render, @('thin.pl'), '--view', front,
                             '--size', '90x90', '-o', @('a.png')]).
command(look_in_vain(_,_), [render, @('cube.pl'), '--look', @('looks.pl'),
                          '--size', '9x9', '-o', @('a.png')]).
command(style_in_vain(_), [draw, @('cube.pl'), '--style', @('style.pl'),
                           '-o', @('a.svg')]).
command(penetration_in_vain(_), [draw, @('cube.pl'), '--style',
                                 @('style_lines.pl'), '-o', @('a.svg')]).
command(empty_result(_,_), [eval, @('empty.pl')]).
command(more_warnings(18), [check, @('cube.pl'), '--rules', @('apart.pl')]).
command(warnings_are_errors(1), [eval, @('empty.pl'), '--strict']).
command(nothing_written(1), [eval, @('empty.pl'), '--strict',
                             '-o', @('a.stl')]).
command(not_utf8(_,_), [check, @('latin1.pl')]).
command(mesh(_,degenerate(1)), [check, @('degenerate.off')]).
command(mesh(_,ignored(1,_)), [check, @('ignored.obj')]).
command(mesh(_,trailing(_)), [check, @('trailing.stl')]).
command(mesh(_,other_names(1)), [convert, @('unseen.obj'), '-o', @('a.stl')]).
command(mesh(_,no_curves(1)), [convert, @('curve.pl'), '-o', @('a.stl')]).
command(operand(inside_out,_), [union, @('inside_out.off'), @('far.pl'),
                                '-o', @('a.off')]).
command(operand(repaired(turned,_),_),
        [union, '--repair', @('inside_out.off'), @('far.pl'),
         '-o', @('a.off')]).
command(operand(repaired(duplicate,_),_),
        [union, '--repair', @('twice.off'), @('far.pl'), '-o', @('a.off')]).
command(operand(repaired(welded,_),_),
        [union, '--repair', @('two_welds.pl'), @('far.pl'),
         '-o', @('a.off')]).
command(operand(surface(_),_), [union, @('turned.off'), @('far.pl'),
                                '-o', @('a.off')]).
command(nothing_to_explain(_), [explain, @('cube.pl'), 'line(7)']).
command(nothing_to_explain(pixel(_,_)),
        [explain, @('cube.pl'), 'pixel(-1, 7)']).
command(nothing_to_explain(piece(_,_)), [explain, @('empty.pl'),
                                         'piece(3,99)']).
command(sheet_tiny(_,fit), [draw, @('tiny.pl'), '--sheet', 'A4', '--scale',
                            standard, '-o', @('a.svg')]).
command(sheet_tiny(_,as_asked), [draw, @('cube.pl'), '--sheet', 'A4',
                                 '--scale', '1:99', '-o', @('a.svg')]).
command(uncaught(oops), [draw, @('cube.pl'), '--rules', @('throws.pl'),
                         '-o', @('a.svg')]).
command(trim(nothing_left(_,outside)),
        [unfold, @('within.pl'), '--trim', outside]).
command(trim(nothing_left(_,inside)),
        [unfold, @('far.pl'), '--trim', inside]).
command(unfold(alone(_)), [unfold, @('far.pl'), '--trim', outside]).
command(pattern(divided(_,_)), [unfold, @('house.pl'), '--page', 'A4',
                                '-o', @('a.svg')]).
command(pattern(opened(_,_)), [unfold, @('saw.pl'), '--tabs', '5',
                               '--open-slits', '-o', @('a.svg')]).
command(pattern(no_room(number,_)), [unfold, @('cube.pl'), '-o',
                                     @('a.svg')]).
command(simplify(made(_,_)), [convert, @('round.pl'), '--faces', '100',
                              '-o', @('a.off')]).
command(simplify(not_fewer(_,_)), [convert, @('ring.pl'), '--faces', '4',
                                   '-o', @('a.off')]).
command(simplify(meets_itself(_,_)),
        [convert, @('hollow.pl'), '--faces', '40', '-o', @('a.off')]).
command(pattern(yield(_,_)), [unfold, @('cube.pl'), '--page', 'A4',
                              '-o', @('a.svg')]).
command(pattern(scale(_)), [unfold, @('cube.pl'), '--height', '100',
        '-o', @('x.svg')]).
command(pattern(without_tab(_,_,_,_,_,_)),
        [unfold, @('saw.pl'), '--tabs', '5', '--no-open-slits',
         '-o', @('a.svg')]).
command(unfold(outline_crosses(_,_)),
        [unfold, @('ring.pl'), '--thickness', '3', '--size', outside,
         '-o', @('a.svg')]).
command(unfold(root_gone(_,_)), [unfold, @('plug.pl'), '--trim', outside,
                                 '--only', 2, '--root', base]).
command(unfold(all_trimmed_away), [unfold, @('far.pl'), '--trim', inside]).
command(unfold(nothing_to_unfold), [unfold, @('wire.pl')]).
command(unfold(several_sheets(_)), [unfold, @('house.pl'), '--page', 'A4',
                                    '-o', -, '--format', svg]).
command(unfold(attached(_,_,_)), [unfold, @('two_welds.pl')]).
command(unfold(not_developable(_,_,_)), [unfold, @('ring.pl'), '--true']).
command(unfold(nearly_touching(_,_)),
        [unfold, @('touching.pl'), '--true', '--trim', outside, '--only', 2,
         '--no-lines']).
command(unfold(no_sphere(_)), [unfold, @('pipes.pl'), '--true', '--gores', '8',
                               '--no-lines']).
command(unfold(no_bend(_)),
        [unfold, @('pipes.pl'), '--true', '--thickness', '0.1', '--relief',
         round, '--no-lines']).
command(unfold(mitre_not_set_in(_)),
        [unfold, @('tee.pl'), '--true', '--trim', outside, '--thickness', '2',
         '--set-in', '--only', '2']).
command(unfold(mitre_by_middles(_)),
        [unfold, @('tee.pl'), '--true', '--trim', outside, '--thickness', '2',
         '--other-thickness', '3']).
command(unfold(nothing_unrolled), [unfold, @('cube.pl'), '--true']).
command(unfold(kept_apart(_,_)), [unfold, @('pipes.pl'), '--true', '--only', 1,
                                  '--no-lines', '--keep', 'side-top']).
command(unfold(no_segment(_,_)), [unfold, @('cube.pl'), '--only', 7]).
command(unfold(kind(_,_)), [unfold, @('curve.pl'), '--only', 1]).
command(unfold(which_segment(_,_)), [unfold, @('far.pl'), '--root', top]).
command(unfold(needs(_,_)), [unfold, @('cube.pl'), '--half']).
command(unfold(no_term(_,_)), [unfold, @('cube.pl'), '--root', 'a(']).
command(unfold(no_names(_,_)), [unfold, @('cube.pl'), '--only', 'a(']).
command(lines_by_rules(_,_), [draw, @('cube.pl'), '--rules', @('role.pl'),
                              '-o', @('a.svg')]).
command(written(_,empty), [eval, @('empty.pl'), '-o', @('a.off')]).
command(written(_,collapsed), [eval, @('grain.pl'), '-o', @('a.stl')]).
command(development(_,in_triangles(_)), [unfold, @('bent.pl')]).
command(development(_,border(_,_)), [unfold, @('double.off')]).
command(unfold(no_table(_)), [unfold, @('cube.pl'), '--true', '--table',
                              @('a.csv'), '-o', @('a.svg')]).

% elsewhere(Notice, Why): no command here provokes it.
elsewhere(interrupted, test('tests/cli/bad_output.sh')).
elsewhere(studio(_), test('tests/studio/front_test.py')).
elsewhere(progress(_,_), test('tests/cli/bad_output.sh')).
elsewhere(progress(_,_,_,_,_), test('tests/cli/bad_output.sh')).
elsewhere(summary_sent(_), test('tests/transcripts/solids.txt')).
elsewhere(no_memory, test('tests/cli/memory.sh')).
elsewhere(no_help(_,_), test('tests/rules/command/help.plt')).
elsewhere(prolog_help(_,_), test('tests/rules/command/help.plt')).
elsewhere(no_answer, test('tests/rules/studio/query.plt')).
elsewhere(because(_), test('tests/rules/explanation/explain.plt')).
elsewhere(each_failed(_, _, _), test('tests/transcripts/each.txt')).
elsewhere(batch(_), test('tests/transcripts/batch.txt')).
elsewhere(request(_), test('tests/transcripts/sessions.txt')).
elsewhere(operand(repaired(no_area,_),_), test('tests/rules/solid/repair.plt')).
elsewhere(written(_,rounds(_)), test('tests/rules/model/solid_file.plt')).
elsewhere(written(_,rounds(1)), test('tests/rules/model/solid_file.plt')).
elsewhere(pattern(opened_by_itself(_,_)),
          test('tests/rules/pattern/pattern_shapes.plt')).
elsewhere(unfold(crosses_itself(_,_)), test('tests/transcripts/patterns.txt')).
elsewhere(unfold(outline_unrolled(_,_)),
          test('tests/transcripts/messages.txt')).
elsewhere(unfold(not_kept(_,_,_,_,_)), test('tests/cli/unfold.sh')).
elsewhere(trim(open(_,_,_)), test('tests/rules/solid/trimmed.plt')).
elsewhere(trim(kind(_,_)), test('tests/rules/solid/trimmed.plt')).
elsewhere(pattern(too_large(_)), "pieces are divided first").
elsewhere(tight(_,_,_,_,_,_), test('tests/rules/solid/precision.plt')).
elsewhere(moved(_,_,_,_,_), test('tests/rules/solid/precision.plt')).
elsewhere(flattened(_,_,_,_,_), test('tests/rules/solid/precision.plt')).
elsewhere(as_rounded(_), test('tests/transcripts/solids.txt')).
elsewhere(greeting, "of the top level alone").
elsewhere(segment(_,_,_), "of the top level alone").
elsewhere(decision(_/_,_,_), "of the top level alone").
elsewhere(no_end, "a fault of the program").
:- dynamic said/2.

:- multifile user:message_hook/3.
:- asserta((user:message_hook(Term, Kind, _) :-
                test_provoked:kept(Term, Kind))).

:- dynamic keeping/0.

kept(Term, Kind) :-
    keeping,
    memberchk(Kind, [error,warning,informational,help]),
    assertz(said(Kind, Term)),
    fail.

notices(Folder, Arguments0, Terms, Status) :-
    maplist(argument(Folder), Arguments0, Arguments),
    retractall(said(_, _)),
    setup_call_cleanup(
        assertz(keeping),
        with_output_to(string(_), sanggwan(Arguments, Status)),
        retractall(keeping)),
    findall(Kind-Term, said(Kind, Term), Terms).

what(sanggwan(What), What).
what(error(model_error(What), _), What).
what(error(geometry_error(What), _), What).
what(error(usage_error(What), _), What).

argument(Folder, @(Name), Path) :-
    !,
    directory_file_path(Folder, Name, Path).
argument(_, Word, Word).

:- dynamic folder/1.

made_files :-
    tmp_file(provoked, Folder),
    make_directory(Folder),
    assertz(folder(Folder)),
    forall(file(Name, Text), written(Folder, Name, utf8, Text)),
    file('latin.pl', Latin),
    written(Folder, 'latin1.pl', iso_latin_1, Latin),
    directory_file_path(Folder, 'trailing.stl', STL),
    new_world(World),
    in_world(World, ( add_primitive(box(size(1,1,1)), _),
                      complete_segments,
                      write_mesh(STL, all, [binary(true)]) )),
    setup_call_cleanup(open(STL, append, Out, [type(binary)]),
                       format(Out, 'behind it', []), close(Out)).

written(Folder, Name, Encoding, Text) :-
    directory_file_path(Folder, Name, Path),
    setup_call_cleanup(open(Path, write, Out, [encoding(Encoding)]),
                       write(Out, Text), close(Out)).

removed_files :-
    retract(folder(Folder)),
    delete_directory_and_contents(Folder).

%   good_korean(Term): in Korean the message has no particle in both forms, and
%   each of its sentences is polite. One that names the stream it was read from
%   is said while that is open only.

good_korean(Term) :-
    catch(message_text(ko, Term, Text),
          error(existence_error(stream,_), _),
          Text = ""),
    (   Text \== "",
        ( both_forms(Text) ; plain_end(Text) )
    ->  format(user_error, '~q: ~s~n', [Term,Text]),
        fail
    ;   true
    ).

both_forms(Text) :-
    member(Both, ["은(는)","이(가)","을(를)","과(와)","와(과)","(으)로","(이)"]),
    sub_string(Text, _, _, _, Both).

plain_end(Text) :-
    split_string(Text, "\n", " ", Lines),
    member(Line, Lines),
    split_string(Line, "", ".", [Bare]),
    string_concat(_, "다", Bare),
    \+ string_concat(_, "니다", Bare).

:- begin_tests(provoked, [setup(made_files), cleanup(removed_files)]).

test(command, forall(command(Notice, Arguments))) :-
    folder(Folder),
    notices(Folder, Arguments, Terms, Status),
    (   member(_-Term, Terms),
        what(Term, Said),
        subsumes_term(Notice, Said),
        forall(member(_-Own, Terms), good_korean(Own))
    ->  true
    ;   format(user_error, '~q: ~q~n  status ~w: ~q~n',
               [Notice,Arguments,Status,Terms]),
        fail
    ).

% What a command ends with: 0 done, 1 the answer is no, 2 usage, 3 the input is
% wrong, 4 the geometry could not be done.
ends(0, [check, @('cube.pl')]).
ends(1, [check, @('two_welds.pl')]).
ends(0, [explain, @('cross.pl'), 'line(1)']).
ends(1, [explain, @('cube.pl'), 'line(7)']).
ends(0, [explain, '--json', @('cross.pl'), 'line(1)']).
ends(1, [explain, '--json', @('cube.pl'), 'line(7)']).
ends(0, [query, @('cube.pl'), 'v(1,1,_,_,_)']).
ends(1, [query, @('cube.pl'), 'v(9,1,_,_,_)']).
ends(1, [query, '--format', json, @('cube.pl'), 'v(9,1,_,_,_)']).
ends(2, [query, @('cube.pl'), 'v(']).
ends(2, [nothing]).
ends(2, [draw, '--nothing']).
ends(2, [draw]).
ends(3, [check, @('no_such.pl')]).
ends(3, [check, @('latin1.txt')]).
ends(4, [unfold, @('wire.pl')]).
ends(4, [unfold, @('far.pl'), '--trim', inside]).
ends(0, [help]).
ends(0, [draw, '--help']).

test(status, [ forall(ends(Status, Arguments)), true(Found == Status) ]) :-
    folder(Folder),
    notices(Folder, Arguments, _, Found).

% With --json the output is JSON, and only then.
reports(check, [@('cross.pl')]).
reports(penetrate, [@('cross.pl')]).
reports(eval, [@('cross.pl')]).
reports(explain, [@('cross.pl'), 'line(1)']).
reports(unfold, [@('cube.pl')]).

printed(Arguments0, Text) :-
    folder(Folder),
    maplist(argument(Folder), Arguments0, Arguments),
    with_output_to(string(Text), sanggwan(Arguments, 0)).

is_json(Text) :-
    catch(atom_json_dict(Text, Term, []), _, fail),
    ( is_dict(Term) ; is_list(Term) ),
    !.

test(json, forall(reports(Verb, Arguments))) :-
    printed([Verb,'--json'|Arguments], With),
    printed([Verb|Arguments], Without),
    is_json(With),
    \+ is_json(Without).

% Every head of the tables of notices is in command/2 or in elsewhere/2.
notice(Notice) :-
    table_heads(sg_messages, notice_en/3, Heads),
    member([Notice0], Heads),
    (   inner(Notice0, Module:Table/Arity, Terms, Notice)
    ->  table_heads(Module, Table/Arity, Inner),
        member(Terms, Inner)
    ;   Notice = Notice0
    ).

inner(trim(_), sg_unfold_en:trim_en/3, [W], trim(W)).
inner(unfold(_), sg_unfold_en:unfold_en/3, [W], unfold(W)).
inner(development(_,_), sg_development_en:development_notice_en/4, [S,W],
      development(S,W)).
inner(operand(_,_), sg_operand_en:operand_notice_en/4, [W,S], operand(W,S)).
inner(pattern(_), sg_pattern_en:pattern_en/3, [W], pattern(W)).
inner(written(F,_), sg_written_en:written_en/3, [W], written(F,W)).
inner(contacts(_), sg_messages:contacts_en/3, [W], contacts(W)).
inner(sheet_tiny(_:_,_), sg_sheet_en:sheet_tiny_en/5, [N,M,H],
      sheet_tiny(N:M,H)).

table_heads(Module, Name/Arity, Heads) :-
    functor(Head, Name, Arity),
    findall(Terms,
            ( catch(clause(Module:Head, _), error(_, _), fail),
              Head =.. [_|Arguments],
              append(Terms, [_,_], Arguments) ),
            Heads).

test(all, forall(notice(Notice))) :-
    (   command(Known, _),
        \+ Known \= Notice
    ->  true
    ;   elsewhere(Known, Where),
        \+ Known \= Notice
    ->  (   Where = test(File)
        ->  absolute_file_name(sanggwan(File), Path),
            exists_file(Path)
        ;   true
        )
    ;   format(user_error,
               'nothing provokes ~p: it needs a command/2, or elsewhere/2~n',
               [Notice]),
        fail
    ).

:- end_tests(provoked).
