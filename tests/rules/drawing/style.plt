:- encoding(utf8).
:- module(test_style, []).
:- use_module(library(plunit)).
:- use_module(rules(decision)).
:- use_module(rules(store)).
:- use_module(rules(drawing/dxf_colour)).
:- use_module(rules(drawing/ink)).
:- use_module(rules(picture/role)).
:- use_module(rules(drawing/style)).
:- use_module(rules(drawing/style_file)).

:- meta_predicate with_file(+, -, 0).

% Goal, with Text in File.
with_file(Text, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out)
        ),
        Goal,
        delete_file(File)).

rows(Text, Rows) :-
    with_file(Text, File, style_rows(File, Rows)).

style(Text, Visibility, Role, S, Style) :-
    rows(Text, Rows),
    line_style(Visibility, Role, S, Style0),
    restyled(Rows, Visibility, Role, S, Style0, Style).

% Where and what is wrong.
fault(Text, What, Line:Column) :-
    catch(rows(Text, _),
          error(model_error(What), location(_, Line, Column)), true).

% One line of this visibility, role and segment, inked.
ink(Options, Visibility, Role, S, Ink) :-
    Stroke = stroke(Visibility, Role, S, [1], [0-0,9000-0], joint, joint),
    inked(drawing(sheet(1000,1000,1.0), [view('', [Stroke], [])]), Options,
          inked(_, _, [view('', Lines, [])])),
    ( Lines = [line(Ink,Stroke)] -> true ; Ink = none ).

role(Role) :-
    ( role_rank(Role, _) ; sheet_role(Role) ).

:- begin_tests(style).

test(every_line_has_one, [forall(( member(Visibility, [visible,hidden]),
                                   role(Role) )),
                          true(Ink \== none)]) :-
    ink([], Visibility, Role, 1, Ink).
test(default, true(Style == style(0.25, black, hidden, 2,
                                  'HIDDEN_CREASE'))) :-
    line_style(hidden, crease, 1, Style).
test(layer_of_the_sheet, true(Layer == 'FRAME')) :-
    line_style(visible, frame, 0, style(_,_,_,_,Layer)).
test(hidden_has_its_dashes, true(Runs == [3000,900])) :-
    ink([], hidden, crease, 1, Ink),
    ink_runs(Ink, Runs).
test(shown_is_solid, true(Runs == [])) :-
    ink([hidden(shown)], hidden, crease, 1, Ink),
    ink_runs(Ink, Runs).
test(line_types_go_with_the_width, true(Runs == [12.0,1.5,0.25,1.5])) :-
    line_type(chain, 0.5, Runs).

test(later_facts_win, true(W-C == 0.2-red)) :-
    style("line(any, any, any, [width(0.1), colour(red)]).
           line(visible, crease, any, [width(0.2)]).
           line(visible, outline, any, [colour(blue)]).",
          visible, crease, 1, style(W,C,_,_,_)).
test(one_segment, [forall(member(S-Pen, [1-1, 2-7])), true(Found == Pen)]) :-
    style("line(any, any, 2, [pen(7)]).", visible, crease, S,
          style(_,_,_,Found,_)).
test(segment_by_name, [forall(member(Name, [glass, cylinder])),
                       true(Pens == [7,1])]) :-
    format(string(Text), "line(any, any, ~w, [pen(7)]).", [Name]),
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, named(glass, cylinder(1.0,2.0)))),
               assert_fact(segment(2, solid, box(1.0,1.0,1.0))),
               findall(Pen, ( member(S, [1,2]),
                              style(Text, visible, crease, S,
                                    style(_,_,_,Pen,_)) ),
                       Pens)
             )).
test(segments_in_vain, true(Vain == [glas,3,cone])) :-
    rows("line(any, any, glass, []). line(any, any, glas, []).
          line(any, any, cylinder, []). line(any, any, any, []).
          line(any, any, 1, []). line(any, any, 3, []).
          line(any, any, cone, []). line(any, text, 0, []). paper(white).",
         Rows),
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, named(glass, cylinder(1.0,2.0)))),
               findall(Segment, segment_in_vain(Rows, Segment), Vain) )).
test(none, true(Style == none)) :-
    style("line(any, any, any, [none]).", visible, crease, 1, Style).
test(none_then_shown, true(Width == 0.5)) :-
    style("line(any, any, any, [none]).
           line(visible, any, any, [shown]).", visible, crease, 1,
          style(Width,_,_,_,_)).
test(nothing_is_drawn, true(Ink == none)) :-
    rows("line(any, any, any, [none]).", Rows),
    ink([style(Rows)], visible, crease, 1, Ink).
test(paper, true(Paper == rgb(1,2,3))) :-
    rows("paper(white). paper(rgb(1,2,3)).", Rows),
    inked(drawing(sheet(1,1,1.0), []), [style(Rows)], inked(_,Paper,[])).

test(shipped, [forall(member(Name, [blueprint, single_pen, eight_pens, ghost])),
               true(Rows = [_|_])]) :-
    format(atom(Path), 'facts/styles/~w.pl', [Name]),
    absolute_file_name(sanggwan(Path), File),
    style_rows(File, Rows).

test(faults, [forall(member(Text-Fault,
        [ "line(visible, crease, any, [width(0)])."-
              style(property(width(0)))/(1:28),
          "line(seen, crease, any, [])."-style(visibility(seen))/(1:6),
          "line(_, crease, any, [])."-style(visibility(_))/(1:6),
          "\nline(any,\n edge, any, [])."-style(role(edge))/(3:2),
          "line(any, any, f(_), [])."-style(segment(f(_)))/(1:16),
          "line(any, any, 1, pen(1))."-style(properties(pen(1)))/(1:19),
          "line(any, any, 1, [pen(P)])."-style(properties([pen(_)]))/(1:19),
          "line(any, any, 1, [dashes([1])])."-
              style(property(dashes([1])))/(1:19),
          "line(any, any, 1, [layer('a b')])."-
              style(property(layer('a b')))/(1:19),
          "line(any, any, 1, [colour(pink)])."-style(colour(pink))/(1:19),
          "line(any, any, 1, [colour(red,rgb(0,0,256))])."-
              style(colour(rgb(0,0,256)))/(1:19),
          "line(any, any, 1, [colour])."-style(property(colour))/(1:19),
          "paper(mauve)."-style(colour(mauve))/(1:7),
          "paper(rgb(0,0,256))."-style(colour(rgb(0,0,256)))/(1:7),
          "paper(white).\nv(1,1,0,0,0)."-style(fact(v,5))/(2:1),
          ":- halt."-directive(halt)/(1:1),
          "line(A,B,C,D) :- true."-rule(line(_,_,_,_))/(1:1),
          "17."-no_fact(17)/(1:1)
        ])),
               true(Found-Place =@= What-Where)]) :-
    Fault = What/Where,
    fault(Text, Found, Place).
%   On both sides of each limit.
test(properties, [ forall(member(Property-Truth,
        [ width(0.001)-yes, width(100)-yes, width(100.1)-no, width(a)-no,
          width(-1)-no, pen(1)-yes, pen(255)-yes, pen(0)-no, pen(256)-no,
          pen(1.0)-no, dashes(solid)-yes, dashes(chain)-yes, dashes(hidden)-yes,
          dashes(wavy)-no, dashes([])-no, dashes([1,2])-yes,
          dashes([1,2,3])-no, dashes([1000,0.1])-yes, dashes([1000.1,1])-no,
          dashes([0,1])-no, dashes([1,a])-no, colour(red)-yes,
          colour(rgb(255,0,0))-yes, colour(red,rgb(0,0,1))-yes,
          colour(red,blue,red)-no, colour(f(x))-no, layer('A1_-$')-yes,
          layer('')-no, layer('\u00e9')-no, layer(7)-no,
          layer(abcdefghijklmnopqrstuvwxyz12345)-yes,
          layer(abcdefghijklmnopqrstuvwxyz123456)-no, none-yes, shown-yes,
          hidden-no ])),
                   true(Found == Truth) ]) :-
    format(string(Text), "line(any, any, 1, [~q]).", [Property]),
    catch(( rows(Text, [line(any,any,1,[Property])]), Found = yes ),
          error(model_error(style(_)), _), Found = no).
test(layer_changes, Style == style(0.5,black,solid,1,'A')) :-
    style("line(any, any, any, [layer('A')]).", visible, crease, 1, Style).
test(two_colours, C-D == colour(red,blue)-[1,2]) :-
    style("line(any, any, any, [colour(red,blue),dashes([1,2])]).", visible,
          crease, 1, style(_,C,D,_,_)).
test(still_none, Style == none) :-
    style("line(any, any, any, [none,pen(3)]).", visible, crease, 1, Style).
test(called, [ forall(member(Name-Pen, [lid-7,glass-7,cone-7,box-1,at-1])),
               true(Found == Pen) ]) :-
    format(string(Text), "line(any, any, ~w, [pen(7)]).", [Name]),
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid,
                                   named(lid, at([], named(glass,
                                                           cone(1.0)))))),
               style(Text, visible, crease, 1, style(_,_,_,Found,_)) )).
test(penetration_in_vain, Vain == [2,cone]) :-
    rows("line(any, penetration, 1, []). line(any, penetration, 2, []).
          line(any, penetration, cone, []). line(any, penetration, any, []).
          line(any, penetration, 9, []). line(any, crease, 2, []).
          line(any, penetration, box, []).", Rows),
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, box(1.0))),
               assert_fact(segment(2, solid, cone(1.0))),
               findall(S, penetration_in_vain(Rows, [1], S), Vain) )).
test(rules, true(Looks == [none, 9, 1])) :-
    new_world(World),
    with_file("line_style(_, _, 3, none).
line_style(V, R, 2, style(W, C, D, 9, L)) :-
    default(line_style(V, R, 2, style(W, C, D, _, L))).", File,
        in_world(World,
                 ( use_rules(File),
                   findall(Look, ( member(S, [3,2,1]),
                                   ink([], visible, crease, S, Ink),
                                   ( Ink == none -> Look = none
                                   ; ink_pen(Ink, Look) ) ),
                           Looks)
                 ))).
test(rules_then_facts, true(Pen == 4)) :-
    rows("line(any, any, any, [pen(4)]).", Rows),
    new_world(World),
    with_file("line_style(_, _, _, style(1, red, solid, 9, a)).", File,
        in_world(World, ( use_rules(File),
                          ink([style(Rows)], visible, crease, 1, Ink),
                          ink_pen(Ink, Pen) ))).
test(bad_style_of_rules, [forall(member(Bad,
        [ style(0, red, solid, 1, a), style(1, pink, solid, 1, a),
          style(1, red, [1], 1, a), style(1, red, solid, 0, a),
          style(1, red, wavy, 1, a), style(1, red, solid, 1, 2),
          style(1, red, solid, 1, 'a(b'), 7 ])),
                          error(model_error(style(_)),
                                location(_, 3, 0))]) :-
    format(string(Text), "\nline_style(hidden, crease, 1, none).\n\c
                          line_style(_, _, _, ~q).", [Bad]),
    new_world(World),
    with_file(Text, File,
        in_world(World, ( use_rules(File),
                          ink([], visible, crease, 1, _) ))).

test(colours_of_dxf, [forall(member(RGB-N,
        [ rgb(0,0,0)-7, rgb(255,255,255)-7, rgb(255,0,0)-1, rgb(255,255,0)-2,
          rgb(0,0,255)-5, rgb(128,128,128)-8, rgb(255,127,0)-30,
          rgb(165,0,0)-12, rgb(165,82,82)-13, rgb(254,1,0)-1,
          rgb(0,255,0)-3, rgb(0,255,255)-4, rgb(255,0,255)-6,
          rgb(192,192,192)-9, rgb(0,127,0)-94, rgb(0,76,0)-96, rgb(0,38,0)-98,
          rgb(38,0,9)-248, rgb(51,51,51)-251, rgb(204,204,204)-254 ])),
                      true(Found == N)]) :-
    dxf_colour(RGB, Found).

:- end_tests(style).
