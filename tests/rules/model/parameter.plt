:- encoding(utf8).
/* Parameters and formulas in model files: what is read, set, kept and written.
   The values of formulas are compared by tests/cli/formula_fuzz.sh. */
% covers: formula, formula_rows, formula_term, parameter_about
:- module(test_parameter, []).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(csg/csg), [is_helper/1]).
:- use_module(rules(model/model), [load_model/2, save_model/1]).
:- use_module(rules(model/parameter)).
:- use_module(rules(model/parameter_about), [range_of/4]).
:- use_module(rules(model/parameter_change), [set_parameter/2]).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   with_model(Text, Options, Goal): in a new world that has loaded Text.

with_model(Text, Options, Goal) :-
    with_file(Text, File, in_new_world(( load_model(File, Options), Goal ))).

with_file(Text, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out) ),
        once(Goal),
        delete_file(File)).

%   fault(Text, Options, What, Place): what loading raises, and the world stays
%   empty.

fault(Text, Options, What, Place) :-
    with_file(Text, File,
              in_new_world(( catch(load_model(File, Options), Error, true),
                             \+ segment(_, _, _),
                             \+ param(_, _),
                             \+ formula(_, _) ))),
    (   Error = error(model_error(What), location(_, Line, Column))
    ->  Place = Line:Column
    ;   Error = error(usage_error(What), _),
        Place = none
    ).

box(Size, Text) :-
    format(string(Text), " segment(1, solid, box(size(~w))).", [Size]).

%   boxed(Parameters, Size, Options, Term)

boxed(Parameters, Size, Options, Term) :-
    box(Size, Box),
    string_concat(Parameters, Box, Text),
    with_model(Text, Options, segment(1, solid, Term)).

%   saved(Text): of the current world.

saved(Text) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          close(Out) ),
        ( save_model(File),
          read_file_to_string(File, Text, [encoding(utf8)]) ),
        delete_file(File)).

rows(Rows) :-
    findall(Row,
            ( Row = v(_, _, _, _, _) ; Row = e(_, _, _, _, _)
            ; Row = p(_, _, _) ; Row = t(_, _, _, _, _, _)
            ; Row = plane(_, _, _, _, _, _) ; Row = segment(_, _, _)
            ; Row = unfolding(_, _) ; Row = view(_, _, _)
            ; Row = title_block(_, _) ),
            Each),
    findall(Row, ( member(Row, Each), call(Row) ), Rows0),
    msort(Rows0, Rows).

%   two(TextA, TextB, Options, Goal): a world that has loaded both.

two(TextA, TextB, Options, Goal) :-
    with_file(TextA, A,
        with_file(TextB, B,
            in_new_world(( load_model([A,B], Options), Goal )))).

%   Each has the parameter a, and is made from it.

made_from("segment(1, solid, box(size(param(a), 2, 3))).").
made_from("segment(1, surface, circle(radius(param(a)))).").
made_from("segment(1, curve, line(from(0,0,0), to(param(a),1,1))).").
made_from("segment(1, solid, prism(outline([[0,0],[9,0],[0,9]]),
           holes([[[1,1],[1,param(a)],[param(a),1]]]), height(2))).").
made_from("segment(1, solid, at([rotate(z, param(a)*10)],
           named(x-1, box(size(1,2,3))))).").
made_from("segment(1, solid, union([at([translate(param(a)/2,0,0)],
           box(size(1,2,3))), box(size(param(a),1,1))])).").
made_from("segment(1, solid, named(n, at([scale(param(a))], difference([
           box(size(5,5,5)), at([rotate(x, 90)], union([cylinder(
           radius(param(a)/4), height(9), facets(6)), 2]))])))).
           segment(2, solid, sphere(radius(1), facets(6), bands(4))).").
made_from("v(1,1,0,0,0). v(1,2,param(a),0,0). v(1,3,0,1,0).
           p(1,1,[1,2,3]). segment(1, surface, flat).
           view(param(a), 0, 0).").
made_from("segment(1, solid, box(size(1,2,3))). title_block(number, param(a)).
           unfolding(1, root(param(a))).").

lines(Lines) :-
    findall([A,B,S,T],
            ( line(_, S, _, A1, B1, T, _, _, _),
              v(S, A1, X1, Y1, Z1), v(S, B1, X2, Y2, Z2),
              msort([[X1,Y1,Z1], [X2,Y2,Z2]], [A,B]) ),
            Lines0),
    msort(Lines0, Lines).

%   shapes(Shapes): what there is, whatever the numbers of what was made anew.

shapes(Shapes) :-
    findall(S, ( segment(S, _, _), \+ is_helper(S) ), Ss),
    findall(Row,
            ( member(Row, [ segment(S, _, _), unfolding(S, _) ]),
              member(S, Ss),
              call(Row)
            ; member(Row, [ view(_, _, _), title_block(_, _), param(_, _) ]),
              call(Row) ),
            Rows),
    findall(p(S, Ends),
            ( member(S, Ss),
              p(S, _, Es),
              findall(A-B, ( member(E, Es), ends(S, E, A, B) ), Ends0),
              msort(Ends0, Ends) ),
            Polygons),
    findall(e(S, A, B),
            ( member(S, Ss), e(S, E, _, _, _), ends(S, E, A, B) ), Edges),
    findall(t(S, N), ( member(S, Ss),
                       aggregate_all(count, t(S, _, _, _, _, _), N) ), Ts),
    findall(plane(S, N), ( member(S, Ss), plane(S, _, N, _, _, _) ), Planes),
    append([Rows,Polygons,Edges,Ts,Planes], Shapes0),
    msort(Shapes0, Shapes).

ends(S, E, [X1,Y1,Z1], [X2,Y2,Z2]) :-
    e(S, E, V1, V2, _),
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2).

:- begin_tests(parameter).

test(value, Term == box(size(57.15, 2, 3))) :-
    boxed("param(d, 114.3).", "param(d)/2, 2, 3", [], Term).
test(after_its_use, Term == box(size(4, 2, 3))) :-
    with_model("segment(1, solid, box(size(param(d), 2, 3))). param(d, 4).",
               [], segment(1, solid, Term)).
test(of_others, Term == box(size(1, 2, 8))) :-
    boxed("param(c, param(b)*2). param(b, param(a)+3). param(a, 1).",
          "param(a), 2, param(c)", [], Term).
test(set, Term == box(size(10, 2, 26))) :-
    boxed("param(c, param(b)*2). param(b, param(a)+3). param(a, 1).",
          "param(a), 2, param(c)", [parameters([a=10])], Term).
test(set_in_the_middle, Term == box(size(1, 2, 14.5))) :-
    boxed("param(c, param(b)*2). param(b, param(a)+3). param(a, 1).",
          "param(a), 2, param(c)", [set(['b=7.25'])], Term).
test(set_breaks_a_circle, Term == box(size(1, 2, 5))) :-
    boxed("param(a, param(b)+1). param(b, param(a)-1).", "1, 2, param(a)",
          [parameters([b=4])], Term).
test(set_with_spaces, Term == box(size(1, 2, 5))) :-
    boxed("param(a, 1).", "1, 2, param(a)", [set([' a = 5 '])], Term).
test(set_formula, forall(member(Text-Value,
                                [ '6.5*25.4'-165.1, '-(2+4)/4'-(-1.5),
                                  ' 2**3 '-8, 'sqrt(4)+.5'-none,
                                  'max(2,3)*sin(30)'-1.5 ]))) :-
    atom_concat('a=', Text, Setting),
    (   Value == none
    ->  catch(boxed("param(a, 1).", "1, 2, 3", [set([Setting])], _),
              error(usage_error(parameter(setting(_, number))), _), true)
    ;   with_model("param(a, 1). v(1,1,param(a),0,0). curve(1,[1]).",
                   [set([Setting])], param(a, Value))
    ).
test(quoted_name, Term == box(size(1, 2, 5))) :-
    boxed("param('a b', 1).", "1, 2, param('a b')", [set(['a b=5'])], Term).
test(whole_numbers_count, N == 32) :-
    with_model("param(n, 8.0). segment(1, solid, cylinder(radius(1),
                height(1), facets(param(n)*2))).", [],
               findall(V, v(1, V, _, _, _), Vs)),
    length(Vs, N).

%   Names are no formulas.
test(plain_name, Name == bolt-8) :-
    with_model("v(1,1,0,0,0). curve(1,[1]). segment(1, curve, bolt-8).", [],
               ( segment(1, curve, Name), \+ formula(_, _) )).
test(named, Term == named(a-1, box(size(1, 2, 3)))) :-
    with_model("segment(1, solid, named(a-1, box(size(1, 2, 1+2)))).", [],
               segment(1, solid, Term)).
test(wish, Wish == cut(base-side(2))) :-
    with_model("segment(1, solid, box(size(1,2,3))). param(i, 1).
                unfolding(1, cut(base-side(param(i)+1))).", [],
               unfolding(1, Wish)).
test(wish_without, Wish == cut(1-2)) :-
    with_model("segment(1, solid, box(size(1,2,3))). unfolding(1, cut(1-2)).",
               [], ( unfolding(1, Wish), \+ formula(_, _) )).

test(every_column, [Row-Values == [4.0,0.0,0.0,90.0]-title(2)]) :-
    Row = [X,Y,Z,Theta],
    with_model("param(a, 4). v(1,1,param(a),0,0). curve(1,[1]).
                view(90*(param(a)-3), 0, param(a)). title_block(number,
                param(a)/2).", [],
               ( v(1, 1, X, Y, Z), view(Theta, _, _), title_block(number, T) )),
    Values = title(T).

test(split, Term == split(box(size(4, 4, 4)), plane(0, 0, 1, -2), below)) :-
    with_model("param(h, 4). segment(1, solid, split(box(size(param(h),
                param(h), param(h))), plane(0, 0, 1, -(param(h))/2), below)).",
               [evaluate(false)],
               ( formula(segment(1), segment(_, _, Written)),
                 Written = split(S, plane(_, _, _, -(_)/2), below),
                 segment(1, _, split(S, Plane, Side)),
                 segment(S, _, Inner) )),
    Term = split(Inner, Plane, Side).

:- end_tests(parameter).


:- begin_tests(parameter_faults).

fault_of("param(a, 1). param(a, 2).", [], twice(param, [a]), 1:14).
fault_of("param(a, param(a)).", [], parameter(cycle([a,a])), 1:10).
fault_of("param(a, param(c)*2). param(b, param(a)).\nparam(c, 1+param(b)).",
         [], parameter(cycle([a,c,b,a])), 1:10).
fault_of("param(wall, 2). param(b, param(wal)+1).", [],
         formula(unknown(wal, [wall]), param(wal)+1), 1:26).
fault_of("param(a, 1/0).", [], formula(division_by_zero, 1/0), 1:10).
fault_of("param(a, 2*sqrt(1-2)).", [], formula(not_real, sqrt(1-2)), 1:10).
fault_of("param(a, f(2)).", [], value(param, 'Value', f(2), number), 1:10).
fault_of("param(a, \"2\").", [], value(param, 'Value', "2", number), 1:10).
fault_of("param(a, 1.0Inf).", [], _, 1:10).
fault_of("param(a, X).", [], value(param, 'Value', _, number), 1:10).
fault_of("param(2, 2).", [], value(param, 'Name', 2, atom), 1:7).
fault_of("param(a, 57,15).", [],
         parameter(decimal_comma(param, a, '57.15')), 1:1).
fault_of("param(a, 57,[]).", [], arity(param, 3, 2), 1:1).
fault_of("formula(v(1,1), v(1,1,0,0,0)).", [], unknown_relation(formula, 2),
         1:1).
fault_of("param(a, 1).", [parameters([b=1])],
         parameter(unset(b, [], [a])), none).
fault_of("param(depth, 1).", [set(['dept=1'])],
         parameter(unset(dept, [depth], [depth])), none).
fault_of("", [set(['a=57,15'])],
         parameter(setting('a=57,15', comma('57.15'))), none).
fault_of("", [set(['a=-57 mm'])], parameter(setting('a=-57 mm', unit(mm))),
         none).
fault_of("", [set(['=3'])], parameter(setting('=3', form)), none).
fault_of("", [set(['a='])], parameter(setting('a=', number)), none).
fault_of("", [set(['a=1,2,3'])], parameter(setting('a=1,2,3', number)), none).
fault_of("", [set(['a=0x10'])], parameter(setting('a=0x10', _)), none).
fault_of("", [set(['a=0\'a'])], parameter(setting(_, _)), none).
fault_of("", [set(['a=2*0x10'])], parameter(setting(_, number)), none).
fault_of("", [set(['a=2*1r3'])], parameter(setting(_, number)), none).
fault_of("", [set(['a=1_000*2'])], parameter(setting(_, number)), none).
fault_of("", [set(['a=(1+2'])], parameter(setting(_, number)), none).
fault_of("", [set(['a=2*shell(1)'])],
         parameter(setting(_, formula(no_function(shell, 1, _), _))), none).
fault_of("", [set(['a=1/(2-2)'])],
         parameter(setting(_, formula(division_by_zero, _))), none).
fault_of("param(b, 2).", [set(['a=param(b)'])],
         parameter(setting(_, formula(unknown(b, _), _))), none).
fault_of("param(a, 1). param_about(a, 3).", [], parameter(about(list(3))),
         1:29).
fault_of("param_about(wal, []). param(wall, 1).", [],
         parameter(about(no_parameter(wal, [wall]))), 1:13).
fault_of("param(a, 1). param_about(a, [min(1), min(2)]).", [],
         parameter(about(item_twice(min(2)))), 1:29).
fault_of("param(a, 1).
param_about(a, [text(en, x), text(ko, y), text(en, z)]).", [],
         parameter(about(item_twice(text(en, z)))), 2:16).
fault_of("param(a, 1). param_about(a, [max(1), min(1)]).", [],
         parameter(about(order(1, 1))), 1:29).
fault_of("param(a, 1). param_about(a, [step(0)]).", [],
         parameter(about(item(step(0)))), 1:29).
fault_of("param(a, 1). param_about(a, [min(param(b))]).", [],
         formula(unknown(b, _), param(b)), 1:29).
fault_of("param(a, 1). param_about(a, [min(f(2))]).", [],
         parameter(about(item(min(f(2))))), 1:29).
fault_of("param(a, 1). param_about(a, [text(de, x)]).", [],
         parameter(about(item(text(de, x)))), 1:29).
fault_of("param(a, 1). param_about(a, []). param_about(a, []).", [],
         twice(param_about, [a]), 1:34).
fault_of("", [set(['a=1','a=1'])], parameter(set_twice(a)), none).

test(place, forall(fault_of(Text, Options, What, Place))) :-
    string_concat(Text, " segment(1, solid, box(size(1, 2, 3))).", Model),
    fault(Model, Options, What, Place).
test(in_a_term, What-Place == formula(unknown(b, []), param(b)+1)-(1:20)) :-
    box("param(b)+1, 2, 3", Box),
    fault(Box, [], What, Place).
test(checked_after, true) :-
    fault("param(a, 2). segment(1, solid, box(size(param(a)-2, 2, 3))).", [],
          primitive(wrong_argument(size(0, 2, 3), _), _), 1:32).
test(after_the_view, true) :-
    fault("view(0, 0, 1-2). segment(1, solid, box(size(1, 2, 3))).", [],
          value(view, 'Rho', -1, distance), 1:12).
test(no_list, error(type_error(list, _))) :-
    load_model([], [parameters(a=1)]).
test(no_number, error(type_error(float, two))) :-
    load_model([], [parameters([a=two])]).
test(no_pair, error(type_error(setting, a))) :-
    load_model([], [parameters([a])]).

:- end_tests(parameter_faults).


:- begin_tests(parameter_files).

%   What is saved, and set again, is what the file gives that is set so.
test(set_again, forall(made_from(Text0))) :-
    string_concat("param(a, 2). param(b, param(a)*2). ", Text0, Text),
    with_model(Text, [], saved(Saved)),
    with_model(Saved, [], saved(Saved1)),
    assertion(Saved1 == Saved),
    Set = [parameters([a=3])],
    with_model(Text, Set, ( saved(Direct), rows(Rows) )),
    with_model(Saved, Set, ( saved(Again), rows(Rows1) )),
    assertion(Direct == Again),
    assertion(Rows == Rows1),
    assertion(sub_string(Direct, _, _, _, "param(a, 3).")),
    assertion(sub_string(Direct, _, _, _, "param(b, param(a)*2).")),
    with_model(Saved, [], rows(Rows2)),
    assertion(Rows2 \== Rows).

%   What was done to a segment is kept, its formulas are not.
test(cut_is_kept, true) :-
    with_model("param(a, 2). segment(1, solid, box(size(param(a), 2, 2))).
                segment(2, solid, box(size(1, 4, param(a)/2))).", [],
               ( penetrate, findall(L, line(L,_,_,_,_,_,_,_,_), Ls),
                 saved(Saved) )),
    Ls \== [],
    \+ sub_string(Saved, _, _, _, "size(param"),
    with_model(Saved, [parameters([a=5])], v(1, 1, -1.0, _, _)).
test(moved_is_kept, X == 9.0) :-
    with_model("param(a, 2). v(1,1,param(a),0,0). v(1,2,0,0,0).
                curve(1,[1,2]).", [],
               ( facts_transaction(( retractall_facts(v(1, 1, _, _, _)),
                                     assert_fact(v(1, 1, 9.0, 0.0, 0.0)) )),
                 saved(Saved) )),
    with_model(Saved, [], v(1, 1, X, _, _)).

%   What is said of parameters is kept, under their names here.
test(about_is_kept, Abouts == [a-[min(1),text(ko, '길이')], a_2-[max(9)]]) :-
    two("param(a, 2). param_about(a, [min(1), text(ko, '길이')]).
         segment(1, solid, box(size(param(a), 2, 2))).",
        "param_about(a, [max(9)]). param(a, 7).
         segment(1, solid, box(size(2*param(a), 2, 2))).", [], saved(Saved)),
    with_model(Saved, [], findall(N-A, param_about(N, A), Abouts)).
test(range_is_kept,
     About-Least-Most == [min(param(a_2)/2),max(2*param(a_2))]-3.5-14) :-
    two("param(a, 2). segment(1, solid, box(size(param(a), 2, 2))).",
        "param_about(b, [min(param(a)/2), max(2*param(a))]). param(a, 7).
         param(b, 4).
         segment(1, solid, box(size(param(a), param(b), 2))).", [],
        saved(Saved)),
    with_model(Saved, [],
               ( param_about(b, About), range_of(b, Least, Most, _) )).
test(default_is_known, Defaults == [a-2,b-(param(a)*2)]) :-
    with_model("param(a, 2). param(b, param(a)*2).
                segment(1, solid, box(size(param(b), param(a), 2))).",
               [parameters([b=5])],
               ( set_parameter(a, 3), set_parameter(a, 4),
                 findall(N-D, formula(set(N), param(N, D)), Defaults0) )),
    msort(Defaults0, Defaults).
test(default_of_renamed, Defaults == [a_2-(param(b_2)+1)]) :-
    with_file("param(a, 2). param(b, 1).
               segment(1, solid, box(size(param(a), param(b), 2))).", File1,
        with_file("param(b, 3). param(a, param(b)+1).
                   segment(1, solid, box(size(param(b), param(a), 2))).", File2,
            in_new_world(( load_model(File1),
                           load_model(File2, [parameters([a=8])]),
                           findall(N-D, formula(set(N), param(N, D)),
                                   Defaults) )))).

test(same_is_one, Ps == [a-2]) :-
    Text = "param(a, 2). segment(1, solid, box(size(param(a), 2, 2))).",
    two(Text, Text, [], findall(N-V, param(N, V), Ps)).
test(other_is_renamed, Ps-X == [a-2,b-4,a_3-7,b_2-14]-7.0) :-
    two("param(a, 2). param(b, param(a)*2).
         segment(1, solid, box(size(param(a), 2, 2))).",
        "param(a, 7). param(b, param(a)*2). param(a_2, 7).
         segment(1, solid, box(size(2*param(a), 2, param(b)))).", [],
        ( findall(N-V, ( param(N, V), N \== a_2 ), Ps), v(2, 1, X0, _, _),
          saved(Saved) )),
    X is abs(X0),
    with_model(Saved, [parameters([a_3=1])],
               segment(2, _, box(size(2, 2, 2)))).
test(both_are_set, Ps == [a-5]) :-
    two("param(a, 2). segment(1, solid, box(size(param(a), 2, 2))).",
        "param(a, 3). segment(1, solid, box(size(param(a), 2, 2))).",
        [parameters([a=5])], findall(N-V, param(N, V), Ps)).
test(one_is_set, Ps == [a-2,b-5]) :-
    two("param(a, 2). segment(1, solid, box(size(param(a), 2, 2))).",
        "param(b, 3). segment(1, solid, box(size(param(b), 2, 2))).",
        [parameters([b=5])], findall(N-V, param(N, V), Ps)).

:- end_tests(parameter_files).


:- begin_tests(set_parameter).

%   In a world that has it, a parameter that is set makes what the file makes
%   that is set so; undo and redo go back and forth.
test(as_set, forall(made_from(Text0))) :-
    string_concat("param(a, 2). param(b, param(a)*2). ", Text0, Text),
    with_model(Text, [parameters([a=3])], ( shapes(Rows3), saved(Saved3) )),
    with_model(Text, [],
               ( shapes(Rows2), set_parameter(a, 3), shapes(Now), saved(Saved),
                 facts_undo, shapes(Before), facts_redo, shapes(Again),
                 set_parameter(a, 2), shapes(Back) )),
    assertion(Now == Rows3),
    assertion(Saved == Saved3),
    assertion(Before == Rows2),
    assertion(Again == Rows3),
    assertion(Back == Rows2),
    assertion(Rows2 \== Rows3).

%   What was cut is cut again.
test(cut_again, Now == Wanted) :-
    Text = "param(a, 2). segment(1, solid, box(size(param(a), 2, 2))).
            segment(2, solid, at([translate(param(a)/2, 0, 1)],
            box(size(1, 1, 9)))). segment(3, solid, box(size(20, 1, 1))).",
    with_model(Text, [parameters([a=5])], ( penetrate, lines(Wanted) )),
    with_model(Text, [], ( penetrate, lines(Before), set_parameter(a, 5),
                           lines(Now), facts_undo, lines(Undone) )),
    assertion(Undone == Before),
    assertion(Before \== Now),
    length(Now, N),
    assertion(N > 0).

test(of_formula, B-C == 7-[b-7,a-2]) :-
    with_model("param(a, 2). param(b, param(a)*3). segment(1, solid,
                box(size(param(b), 1, 1))).", [],
               ( set_parameter(b, 7), segment(1, _, box(size(B, 1, 1))),
                 \+ formula(param(b), _), set_parameter(a, 2),
                 findall(N-V, param(N, V), C0), sort(0, @>=, C0, C) )).
test(by_hand, X == 9.0) :-
    with_model("param(a, 2). v(1,1,param(a),0,0). v(1,2,0,0,0).
                curve(1,[1,2]).", [],
               ( facts_transaction(( retractall_facts(v(1, 1, _, _, _)),
                                     assert_fact(v(1, 1, 9.0, 0.0, 0.0)) )),
                 set_parameter(a, 5), v(1, 1, X, _, _) )).

%   What is not possible changes nothing.
refused(0, model_error(primitive(wrong_argument(size(0, 1, 1), _), _))).
refused(-4, model_error(formula(not_real, sqrt(param(a)-2)))).
refused(1.0e300, model_error(formula(too_large, param(a)**2))).

test(refused, forall(refused(Value, Fault))) :-
    with_model("param(a, 2). param(r, sqrt(param(a)-2)). param(q, param(a)**2).
                segment(1, solid, box(size(param(a), 1, 1))).", [],
               ( ( Value == 0 -> set_parameter(r, 1) ; true ),
                 rows(Before),
                 catch(set_parameter(a, Value), error(Fault0, _), true),
                 rows(After) )),
    assertion(subsumes_term(Fault, Fault0)),
    assertion(Before == After).
test(unknown, error(existence_error(parameter, c))) :-
    with_model("param(a, 2). segment(1, solid, box(size(param(a), 1, 1))).",
               [], set_parameter(c, 1)).
test(no_number, error(type_error(float, "2"))) :-
    with_model("param(a, 2). segment(1, solid, box(size(param(a), 1, 1))).",
               [], set_parameter(a, "2")).

:- end_tests(set_parameter).


%   warned(Text, Options, Warnings): of parameters, while Text is loaded;
%   warned(Text, Options, Goal, Warnings): and Goal is called.

:- dynamic heard/1.
:- multifile user:message_hook/3.
user:message_hook(sanggwan(parameter(What)), warning, _) :-
    assertz(test_parameter:heard(What)).

warned(Text, Options, Warnings) :-
    warned(Text, Options, true, Warnings).

warned(Text, Options, Goal, Warnings) :-
    retractall(heard(_)),
    with_model(Text, Options, Goal),
    findall(What, heard(What), Warnings).

warned_of_fault(Text, Warnings) :-
    catch(warned(Text, [], _), error(model_error(primitive(_, _)), _), true),
    findall(What, heard(What), Warnings).

:- begin_tests(parameter_warnings).

idle("param(a, 2). param(b, param(a)*2). param(c, param(b)+1). param(n, 1).
      segment(1, solid, box(size(param(c), 2, 2))). title_block(number,
      param(n)). ").

test(unused, Warnings == [unused(d)]) :-
    idle(Text),
    string_concat(Text, "param(d, param(a)).", Idle),
    warned(Idle, [parameters([a=3,n=2,d=4])], Warnings).
test(replaced, Warnings == [unused(a),unused(b)]) :-
    idle(Text),             % c is no longer made from them
    warned(Text, [parameters([a=3,b=7,c=4])], Warnings).
test(range, Warnings == [range(a, 11, 1, 10)]) :-
    idle(Text0),
    string_concat("param_about(a, [min(1), max(10)]). ", Text0, Text),
    warned(Text, [parameters([a=10])], []),
    warned(Text, [parameters([a=1])], []),
    warned(Text, [parameters([a=11])], Warnings).
test(range_of_formula, Warnings == [range(c, 5, none, 4.5)]) :-
    idle(Text0),
    string_concat("param_about(c, [max(4.5)]). ", Text0, Text),
    warned(Text, [], Warnings).
test(range_by_formula, Warnings == [range(b, 5, none, 4)]) :-
    idle(Text0),
    string_concat("param_about(b, [min(1/(param(a)-2)), max(2*param(a))]). ",
                  Text0, Text),
    warned(Text, [parameters([b=4])], []),      % divides by zero: no least
    warned(Text, [parameters([b=5])], Warnings).
test(range_by_formula_later, Warnings == [range(b, 4, none, 2)]) :-
    idle(Text0),
    string_concat("param_about(b, [max(2*param(a))]). ", Text0, Text),
    warned(Text, [parameters([b=4])], set_parameter(a, 1), Warnings).
%   A value that nothing can be made of is told with the error.
test(range_before_error, Warnings == [range(a, 0, 1, none)]) :-
    warned_of_fault("param(a, 0). param_about(a, [min(1)]).
                     segment(1, solid, box(size(param(a), 2, 2))).", Warnings).
%   Here the fault is found later than there.
test(range_before_later_error, Warnings == [range(a, 0, 1, none)]) :-
    warned_of_fault("param(a, 0). param_about(a, [min(1)]).
                     segment(1, solid, named(x, box(size(param(a), 2, 2)))).",
                    Warnings).
test(set_later, Warnings == [range(a, 0, 1, none)]) :-
    idle(Text0),
    string_concat("param_about(a, [min(1)]). ", Text0, Text),
    warned(Text, [], set_parameter(a, 0), Warnings).

:- end_tests(parameter_warnings).

% How the work grows with the number of parameters is counted, not timed: each
% one is plain, or is of the one before it, or of the one after it.
:- begin_tests(parameter_growth).

test(growth, [ forall(member(Kind, [plain,before,after])), true(N < 5.5) ]) :-
    steps_for(Kind, 500, N1),
    steps_for(Kind, 2000, N2),
    N is N2/N1.

steps_for(Kind, Count, N) :-
    findall(given(Name, Written, none),
            ( between(1, Count, I),
              atom_concat(p, I, Name),
              written(Kind, I, Count, Written) ),
            Items),
    statistics(inferences, N0),
    file_parameters(Items, [], Parameters),
    statistics(inferences, N1),
    N is N1-N0,
    length(Parameters, Count),
    last_value(Kind, Count, Name, Value),
    parameter_value(Parameters, Name, Value).

written(plain, I, _, I).
written(before, I, _, Written) :-
    I0 is I-1,
    (   I =:= 1
    ->  Written = 1
    ;   atom_concat(p, I0, Name),
        Written = param(Name)+1
    ).
written(after, I, Count, Written) :-
    Backwards is Count+1-I,
    Next is I+1,
    (   Backwards =:= 1
    ->  Written = 1
    ;   atom_concat(p, Next, Name),
        Written = param(Name)+1
    ).

last_value(after, Count, p1, Count) :-
    !.
last_value(_, Count, Name, Count) :-
    atom_concat(p, Count, Name).

:- end_tests(parameter_growth).
