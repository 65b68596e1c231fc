:- encoding(utf8).
:- module(test_model_file, []).
% covers: bezier, model_rows, model_text, shifted
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(store)).
:- use_module(rules(model/model_file)).
:- use_module(rules(model/model_writer)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

% Goal in a new world that has read Text.
with_model(Text, Goal) :-
    with_file(Text, File,
              in_new_world(( read_model(File, [], _), Goal ))).

with_file(Text, File, Goal) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
        ( write(Out, Text),
          close(Out),
          once(Goal)
        ),
        delete_file(File)).

%   joins_inferences(N, Load, Cut): what it takes to load a file of N joins of
%   two boxes each, apart from one another, and to cut them: a count, so the
%   same on any machine.

joins_inferences(N, Load, Cut) :-
    findall(Line, ( between(1, N, I), join_line(I, Line) ), Lines),
    atomic_list_concat(Lines, Text),
    with_file(Text, File,
              in_new_world(( inferences(load_model(File), Load),
                             inferences(penetrate, Cut) ))).

join_line(I, Line) :-
    X is 3*I,
    format(atom(Line),
           "segment(~d, solid, join([at([translate(~w,0,0)], \c
            box(size(1,1,1))), at([translate(~w,0.5,0)], \c
            box(size(1,1,1)))])).~n",
           [I,X,X]).

truth(Goal, Truth) :-
    (   Goal
    ->  Truth = true
    ;   Truth = false
    ).

inferences(Goal, N) :-
    statistics(inferences, N0),
    call(Goal),
    statistics(inferences, N1),
    N is N1-N0.

% What reading Text raises, where; and the world stays as it was.
fault(Text, What, Line:Column) :-
    with_file(Text, File,
        in_new_world(( assert_fact(v(9, 1, 0, 0, 0)),
                       catch(read_model(File, [], _), Error, true),
                       Error = error(model_error(What0),
                                     location(File, Line0, Column0)),
                       findall(S, v(S, _, _, _, _), Ss),
                       Ss == [9],
                       \+ segment(_, _, _) ))),
    What-Line-Column = What0-Line0-Column0.

triangle("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). p(1,1,[1,2,3]).\n").

after_triangle(More, Text) :-
    triangle(Start),
    string_concat(Start, More, Text).

% Every row of the world, in canonical text.
world_text(Text) :-
    with_output_to(string(Text), write_model_to(current_output)).

% But for the picture, and what csg_record.pl remembers of this world alone.
rows(Rows) :-
    findall(Row,
            ( relation(Name, Arity, _),
              \+ memberchk(Name, [screen, drawn]),
              functor(Row, Name, Arity),
              call(sg_store:Row),
              Row \= origin(_, node(_), _) ),
            Rows0),
    msort(Rows0, Rows).

same_after_writing :-
    world_text(Text),
    rows(Rows),
    with_file(Text, File,
              in_new_world(( read_model(File, [], _),
                             rows(Rows1),
                             world_text(Text1) ))),
    Rows == Rows1,
    Text == Text1.

facts_file(File) :-
    absolute_file_name(sanggwan(facts), Folder, [file_type(directory)]),
    member(Pattern, ['*.pl', 'figures/*.pl']),
    directory_file_path(Folder, Pattern, Path),
    expand_file_name(Path, Files),
    member(File, Files),
    \+ file_base_name(File, 'batch.pl').        % a manifest, no model

:- begin_tests(model_file).

test(vertex_list, Es == [e(1,1,1,2,1), e(1,2,2,3,1), e(1,3,3,1,1)]) :-
    triangle(Text),
    with_model(Text, findall(e(S,E,A,B,T), e(S,E,A,B,T), Es)).
test(integers_become_floats, X-Y == 1.0 - 0.0) :-
    with_model("v(1,1,1,-0.0,0). v(1,2,1,0,0). v(1,3,0,1,0). p(1,1,[1,2,3]).",
               v(1, 1, X, Y, _)).
test(hollow, N == 8) :-
    with_model("v(1,1,0,0,0). v(1,2,9,0,0). v(1,3,9,9,0). v(1,4,0,9,0).
                v(1,5,1,1,0). v(1,6,1,2,0). v(1,7,2,2,0). v(1,8,2,1,0).
                p(1, 1, [1,2,3,4,1,-5,6,7,8,5]).",
               aggregate_all(count, e(1, _, _, _, _), N)).
test(any_order, P == [1,2,3]) :-
    with_model("p(1,1,[1,2,3]). v(1,3,0,1,0). v(1,2,1,0,0). v(1,1,0,0,0).",
               p(1, 1, P)).
test(edge_lists, Es == [7,5,6]) :-
    with_model("p(1,1,[7,5,6]). e(1,5,1,2,1). e(1,6,2,3,1). e(1,7,3,1,1).
                v(1,3,0,1,0). v(1,2,1,0,0). v(1,1,0,0,0).",
               p(1, 1, Es)).
test(kinds, Kinds == [surface, curve, solid]) :-
    with_model("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). p(1,1,[1,2,3]).
                v(2,1,0,0,0). v(2,2,1,0,0). curve(2,[1,2]).
                v(3,1,0,0,0). v(3,2,1,0,0). v(3,3,0,1,0). v(3,4,0,0,1).
                p(3,1,[1,3,2]). p(3,2,[1,2,4]). p(3,3,[2,3,4]).
                p(3,4,[3,1,4]).",
               findall(K, segment(_, K, _), Kinds)).
test(curve, Es == [1-2, 2-3, 3-1]) :-
    with_model("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). curve(1,[1,2,3,1]).",
               findall(A-B, e(1, _, A, B, _), Es)).
test(primitive, Name == box(size(1,2,3))) :-
    with_model("segment(1, solid, box(size(1,2,3))).", segment(1, _, Name)).
test(primitive_not_twice, Z == 5.0) :-
    with_model("segment(1,surface,box(size(1,2,3))). v(1,1,0,0,5).
                v(1,2,1,0,5). v(1,3,0,1,5). p(1,1,[1,2,3]).",
               v(1, 1, _, _, Z)).
test(view, view(300.0, 60.0, 2.0) == V) :-
    after_triangle("view(300,60,2). projection(central).", Text),
    with_model(Text, ( view(A, B, C), V = view(A, B, C) )).
test(own_edges_of_each_file, Ss-Ls == [1,2,3]-[]) :-
    with_file("segment(1,solid,box(size(1,1,1))).
               segment(2,solid,box(size(1,1,1))).", A,
      with_file("segment(1,solid,box(size(1,1,1))).", B,
        in_new_world(( read_model(A, [], _), read_model(B, [], _),
                       findall(S, segment(S, _, _), Ss),
                       findall(L, line(L,_,_,_,_,_,_,_,_), Ls) )))).
test(origins_follow, O == lpi(2-(1,2), 3-1)) :-
    triangle(Text),
    string_concat(Text, "origin(1, v(1), lpi(1-(1,2), 2-1)).", Text1),
    with_file(Text, A,
      with_file(Text1, B,
        in_new_world(( read_model(A, [], _), read_model(B, [], _),
                       origin(2, v(1), O) )))).
test(sources_follow, Sources == [2-3, 3-1, 2-1]) :-
    triangle(Text),
    string_concat(Text, "segment(2,surface,x). v(2,1,0,0,0). v(2,2,1,0,0).
                         v(2,3,0,1,0). p(2,1,[1,2,3]).
                         from_p(2,1,1,1,-1). from_p(2,1,2,1,1).
                         from_v(2,3,1,2).", Text1),
    with_file(Text, A,
      with_file(Text1, B,
        in_new_world(( read_model(A, [], _), read_model(B, [], _),
                       from_v(3, 3, S1, 2),
                       findall(S-1, from_p(3, 1, S, _, _), Ss),
                       Sources = [S1-3|Ss1], reverse(Ss, Ss1) )))).
test(korean_name, Name == '상관') :-
    after_triangle("segment(1, surface, '상관').", Text),
    with_model(Text, segment(1, _, Name)).

test(written_and_read, forall(facts_file(File))) :-
    in_new_world(( read_model(File, [], _), same_after_writing )).
test(penetrated_too,
     forall(member(N, [fig08, fig09, fig11, fig13]))) :-
    atomic_list_concat([facts, figures, N], /, Name),
    absolute_file_name(sanggwan(Name), File, [extensions([pl])]),
    in_new_world(( load_model(File), penetrate, same_after_writing )).
test(written_rows) :-
    with_model("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). p(1,1,[1,2,3]).
        segment(2, surface, f('A b', [1,2.5], -3)).
        v(2,3,0.1,1.0e-7,1.0e22). v(2,1,0,0,0). v(2,2,3,0,0).
        e(2,9,1,2,1). e(2,7,2,3,1). e(2,8,3,1,0).
        p(2,4,[9,7,8]). plane(2,4,0,0,1,0). t(2,4,11,1,2,3).
        origin(2, v(3), lpi(1-(1,2), 2-1)). origin(2, p(4), p(1)).
        from_v(2,3,1,1). from_v(2,1,1,7). from_p(2,4,1,2,1).
        from_p(2,4,1,1,-1).
        line(3,1,1,1,2,2,4,1,2). view(1,2,3). projection(central).",
        same_after_writing).
test(canonical_line, Line == "v(1, 1, 0.1, -2.0e-7, 3.0)") :-
    with_model("v(1,1,1.0e-1,-0.0000002,3). v(1,2,1,0,0). v(1,3,0,1,0).
                p(1,1,[1,2,3]).",
               ( world_text(Text),
                 split_string(Text, "\n", ".", Lines),
                 nth1(4, Lines, Line) )).

%   Twice as many joins take twice as long, but for a twentieth.

test(many_joins, [true([LoadTwice,CutTwice] == [true,true])]) :-
    joins_inferences(20, _, _),         % what is loaded at the first use
    joins_inferences(100, Load1, Cut1),
    joins_inferences(200, Load2, Cut2),
    truth(Load2 < 2.1*Load1, LoadTwice),
    truth(Cut2 < 2.1*Cut1, CutTwice).

:- end_tests(model_file).

:- begin_tests(model_file_faults).

test(directive, W-P == directive(halt)-(2:1)) :-
    after_triangle(":- halt.", Text), fault(Text, W, P).
test(query, W-P == directive(halt)-(2:1)) :-
    after_triangle("?- halt.", Text), fault(Text, W, P).
test(rule, W-P =@= rule(v(1,4,_,0,0))-(2:3)) :-
    after_triangle("  v(1,4,X,0,0) :- X is 1.", Text), fault(Text, W, P).
test(grammar_rule, W == rule(a)) :-
    after_triangle("a --> b.", Text), fault(Text, W, _).
test(unknown_relation, W-P == unknown_relation(vertex,2)-(3:1)) :-
    after_triangle("% comment\nvertex(1,2).", Text), fault(Text, W, P).
test(no_arguments, W-P == arity(v,0,5)-(2:1)) :-
    after_triangle("v().\n", Text),
    fault(Text, W, P).
test(arity, W-P == arity(v,4,5)-(2:1)) :-
    after_triangle("v(1,4,0,0).", Text), fault(Text, W, P).
test(computed, W == computed(screen)) :-
    after_triangle("screen(1,1,0.0,0.0,0.0).", Text), fault(Text, W, _).
test(number, W == no_fact(5)) :-
    after_triangle("5.", Text), fault(Text, W, _).
test(variable, W =@= no_fact(_)) :-
    after_triangle("X.", Text), fault(Text, W, _).

test(wrong_type, W-P == value(v,'Y',foo,float)-(2:11)) :-
    after_triangle("v(1, 4, 0,foo, 0).", Text), fault(Text, W, P).
test(argument_on_next_line, W-P == value(v,'Z',foo,float)-(3:4)) :-
    after_triangle("v(1, 4, 0, 0,\n   foo).", Text), fault(Text, W, P).
test(id_zero, W == value(v,'V',0,id)) :-
    after_triangle("v(1,0,0,0,0).", Text), fault(Text, W, _).
test(id_too_big, W == value(v,'V',2147483648,id)) :-
    after_triangle("v(1,2147483648,0,0,0).", Text), fault(Text, W, _).
test(edge_type, W == value(e,'Et',2,one_of([0,1]))) :-
    after_triangle("e(1,1,1,2,2).", Text), fault(Text, W, _).
test(sense, W == value(from_p,'Sense',0,one_of([1,-1]))) :-
    after_triangle("from_p(1,1,1,1,0).", Text), fault(Text, W, _).
test(source_twice, W == twice(from_p,[1,1,2,1])) :-
    after_triangle("from_p(1,1,2,1,1). from_p(1,1,2,1,-1).", Text),
    fault(Text, W, _).
test(source_without_polygon, W == missing(p,1,9)) :-
    after_triangle("from_p(1,9,2,1,1).", Text), fault(Text, W, _).
test(kind, W == value(segment,'Kind',blob,
                      one_of([solid,surface,curve,cells,pattern]))) :-
    after_triangle("segment(1,blob,x).", Text), fault(Text, W, _).
test(nan_word, W == value(v,'Y',nan,float)) :-
    after_triangle("v(1,4,0,nan,0).", Text), fault(Text, W, _).
test(nan, W = value(v,'Y',_,finite)) :-
    after_triangle("v(1,4,0,1.5NaN,0).", Text), fault(Text, W, _).
test(infinite, W = value(v,'X',_,finite)) :-
    after_triangle("v(1,4,-1.0Inf,0,0).", Text), fault(Text, W, _).
test(too_far, W-P == value(v,'Z',1.0e300,within(1.0e90))-(2:11)) :-
    after_triangle("v(1,4,0,0,1.0e300).", Text), fault(Text, W, P).
test(rational, W == value(v,'X',1r3,float)) :-
    after_triangle("v(1,4,1r3,0,0).", Text), fault(Text, W, _).
test(huge_integer, W = value(v,'X',_,float)) :-
    numlist(1, 400, Ns),
    maplist([_,0'9]>>true, Ns, Codes),
    format(string(More), "v(1,4,~s,0,0).", [Codes]),
    after_triangle(More, Text), fault(Text, W, _).
test(string, W == value(segment,'Name',"x",ground)) :-
    after_triangle("segment(1,surface,\"x\").", Text), fault(Text, W, _).
test(name_variable, W =@= value(segment,'Name',f(_),ground)) :-
    after_triangle("segment(1,surface,f(X)).", Text), fault(Text, W, _).
test(rho, W == value(view,'Rho',-1,distance)) :-
    after_triangle("view(1,2,-1).", Text), fault(Text, W, _).
test(no_list, W = value(p,'Es',_,steps)) :-
    after_triangle("p(1,2,[1,2|3]).", Text), fault(Text, W, _).

test(missing_vertex, W-P == missing(v,1,9)-(2:7)) :-
    after_triangle("p(1,2,[1,2,9]).", Text), fault(Text, W, P).
test(edge_to_nothing, W-P == missing(v,1,9)-(2:9)) :-
    after_triangle("e(1,1,1,9,1).", Text), fault(Text, W, P).
test(missing_edge, W-P == missing(e,1,9)-(2:21)) :-
    fault("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0).\n\c
e(1,1,1,2,1). p(1,1,[1,9,9]).", W, P).
test(missing_polygon, W-P == missing(p,1,9)-(2:9)) :-
    after_triangle("plane(1,9,0,0,1,0).", Text), fault(Text, W, P).
test(duplicate, W-P == twice(v,[1,3])-(2:1)) :-
    after_triangle("v(1,3,0,0,0).", Text), fault(Text, W, P).
test(duplicate_polygon, W == twice(p,[1,1])) :-
    after_triangle("p(1,1,[3,2,1]).", Text), fault(Text, W, _).
test(two_views, W-P == twice(view,-)-(2:14)) :-
    after_triangle("view(1,2,3). view(1,2,4).", Text), fault(Text, W, P).
test(two_questions, W-P == twice(question,a)-(2:16)) :-
    after_triangle("question(a,b). question(\"a\",c).", Text),
    fault(Text, W, P).
test(question_without_name, W == value(question,'Name',"",words)) :-
    after_triangle("question(\"\", b).", Text), fault(Text, W, _).
test(open_polygon, W-P == polygon(1,2,open(2))-(2:21)) :-
    after_triangle("v(1,4,5,5,5). p(1,2,[1,2,3,1,-2,4,3]).", Text),
    fault(Text, W, P).
test(open_edges, W == polygon(1,1,open(1))) :-
    fault("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). e(1,1,1,2,1).
           e(1,2,2,3,1). e(1,3,1,3,1). p(1,1,[1,2,3]).", W, _).
test(bad_jump, W == polygon(1,2,list)) :-
    after_triangle("p(1,2,[1,2,3,1,-4]).", Text), fault(Text, W, _).
test(two_edges, W == polygon(1,2,edges(2))) :-
    after_triangle("p(1,2,[1,2]).", Text), fault(Text, W, _).
test(point_curve, W == chain(1,2)) :-
    after_triangle("curve(1,[1,2,2]).", Text), fault(Text, W, _).

test(curve_of_polygons, [forall(curve_of_polygons(Text, Place)),
                         true(W-P == curve_polygon(1,1)-Place)]) :-
    fault(Text, W, P).

curve_of_polygons("segment(1,curve,x). v(1,1,0,0,0). v(1,2,1,0,0).
                   v(1,3,0,1,0). p(1,1,[1,2,3]).", 2:36).
curve_of_polygons("segment(1,curve,x). v(1,1,0,0,0). v(1,2,1,0,0).
                   v(1,3,0,1,0). e(1,1,1,2,1). e(1,2,2,3,1).
                   e(1,3,3,1,1). p(1,1,[1,2,3]).", 3:36).
curve_of_polygons("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0).
                   p(1,1,[1,2,3]). segment(1,curve,x).", 2:22).

test(bad_primitive, W-P = primitive(wrong_argument(radius(-1),_),_)-(1:18)) :-
    fault("segment(1, solid,cone(radius(-1), height(1))).", W, P).
test(wrong_kind, W-P == kind(rectangle(size(1,1)),solid,surface)-(1:12)) :-
    fault("segment(1, solid, rectangle(size(1,1))).", W, P).
test(no_vertices, W == no_vertices(1,house)) :-
    fault("segment(1, solid, house).", W, _).
test(numbers_of_the_file, W == missing(v,1,9)) :-
    triangle(A),
    after_triangle("p(1,2,[1,2,9]).", B),
    with_file(A, FileA,
      with_file(B, FileB,
        in_new_world(( read_model(FileA, [], _),
                       catch(read_model(FileB, [], _),
                             error(model_error(W), _), true) )))).

test(empty, W-P == empty-(0:0)) :-
    fault("% nothing\n", W, P).
test(view_only, W == empty) :-
    fault("view(1,2,3).", W, _).
test(vertices_only, W == no_edges(1)) :-
    fault("v(1,1,0,0,0).", W, _).
test(cut_off, W-L == syntax(end_of_file)-2) :-
    after_triangle("v(1,4,0,", Text), fault(Text, W, L:_).
test(open_quote, W = syntax(end_of_file_in_quoted(_))) :-
    after_triangle("segment(1,solid,'abc).\n", Text), fault(Text, W, _).
test(no_prolog, W = syntax(_)) :-
    fault("solid OpenSCAD_Model\n  facet normal 0 0 1\n", W, _).
test(hidden_rest, W-P == early_end-(2:1)) :-
    after_triangle("end_of_file.\nv(1,4,0,0,0).", Text), fault(Text, W, P).
test(too_deep, W == limit(depth, 128)) :-
    length(L, 200000),
    maplist(=(0'[), L),
    length(R, 200000),
    maplist(=(0']), R),
    format(string(Text), "segment(1,solid,~s~s).", [L, R]),
    fault(Text, W, _).
test(missing_file, E == error(model_error(cannot_read(missing)),
                              location('/no/such.pl', 0, 0))) :-
    in_new_world(catch(read_model('/no/such.pl', [], _), E, true)).
test(folder, W == cannot_read(directory)) :-
    in_new_world(catch(read_model('/tmp', [], _), error(model_error(W), _),
                       true)).
test(operators_of_rule_files, W == syntax(operator_expected)) :-
    setup_call_cleanup(
        op(700, xfx, user:(===>)),
        fault("v(1,1,0,0,0) ===> x.", W, _),
        op(0, xfx, user:(===>))).

:- end_tests(model_file_faults).
