:- encoding(utf8).
:- module(test_check, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(rules(command/check)).
:- use_module(rules(model/integrity)).
:- use_module(rules(model/mesh)).
:- use_module(rules(command/report)).
:- use_module(rules(store)).
:- use_module(rules(kernel), [fill_triangles/3]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).

% Goal in a world that holds the OBJ or OFF text.
:- meta_predicate with(+, +, 0).
with(Ending, Text, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Stream, [extension(Ending)]),
          write(Stream, Text),
          close(Stream)
        ),
        ( new_world(World),
          in_world(World, ( read_mesh(File, _), Goal ))
        ),
        delete_file(File)).

atomics_string(Parts, Text) :-
    atomic_list_concat(Parts, Text).

% A cube of side 2, without the faces left out of the list.
cube(Without, Text) :-
    Faces = ["1 4 3 2", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"],
    findall(L, ( nth1(N, Faces, F), \+ memberchk(N, Without),
                 format(string(L), "f ~s\n", [F]) ), Ls),
    atomics_string(["v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n",
                       "v 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"|Ls], Text).

% The values of Keys in the report on the one segment.
report(Text, Keys, Values) :-
    report(Text, Segment),
    values(Keys, Segment, Values).

report(Text, Segment) :-
    with(obj, Text, check_report(Report)),
    get_dict(segments, Report, [Segment]).

values([], _, []).
values([Key|Keys], Dict, [Value|Values]) :-
    get_dict(Key, Dict, Value),
    values(Keys, Dict, Values).

defects(Text, Defects) :-
    with(obj, Text, findall(D, model_defect(D), Defects)).

% The lines of the report as text, but for the first (the name of the file) and
% the box.
printed(Language, Text, Lines) :-
    current_prolog_flag(message_language, Old),
    setup_call_cleanup(
        set_prolog_flag(message_language, Language),
        with(obj, Text,
             ( check_report(R),
               with_output_to(string(Printed), print_report(text, R)) )),
        set_prolog_flag(message_language, Old)),
    split_string(Printed, "\n", "", [_, Counts, _Box|Lines0]),
    once(append(Lines1, [""], Lines0)),
    Lines = [Counts|Lines1].

% N pairs of triangles on one edge that lie on each other in part: every defect
% of them is asked for alone (one pass over the world for each takes minutes).
overlapping_pairs(N, Text) :-
    findall(L, ( between(1, N, I), X is 2*I, X1 is X+1,
                 A is 4*I-3, B is A+1, C is B+1, D is C+1,
                 format(string(L), "v ~d 0 0\nv ~d 0 0\nv ~d 1 0\n\c
                                    v ~d 1 0\nf ~d ~d ~d\nf ~d ~d ~d\n",
                        [X,X1,X,X1,A,B,C,A,B,D]) ),
            Ls),
    atomics_string(Ls, Text).

:- begin_tests(check).

test(cube, Vs == [solid, 8, 12, 6, 24]) :-
    cube([], T),
    report(T, [kind,vertices,edges,polygons,half_edges], Vs).
test(box, Vs == [[[0.0,0.0,0.0], [2.0,2.0,2.0]]]) :-
    cube([], T), report(T, [box], Vs).
test(measures, Vs == [24.0, 8.0]) :-
    cube([], T), report(T, [area,volume], Vs).
test(measures_of_triangles, Vs == [24.0, 8.0]) :-
    cube([], T),
    with(obj, T, ( complete_segments, check_report(R) )),
    get_dict(segments, R, [S]),
    values([area,volume], S, Vs).
test(genus, Vs == [2, 0, true]) :-
    cube([], T), report(T, [shells], [[Shell]]),
    values([euler,genus,closed], Shell, Vs).
test(no_defects, Ds == []) :-
    cube([], T), defects(T, Ds).
test(open, Vs == [surface, 4, null]) :-
    cube([2], T), report(T, [kind,border_edges,volume], Vs).
test(a_border_of_a_surface_is_no_defect, Ds == []) :-
    cube([2], T), defects(T, Ds).
test(open_solid, N == 4) :-
    cube([2], T),
    with(obj, T, ( retract_fact(segment(1, _, N0)),
                   assert_fact(segment(1, solid, N0)),
                   aggregate_all(count, model_defect(open_edge(1, _)), N) )).
test(two_shells, L == 2) :-
    cube([3,4,5,6], T), report(T, [shells], [Shells]), length(Shells, L).
test(turned, N == 4) :-
    cube([1], T0), string_concat(T0, "f 1 2 3 4\n", T),
    defects(T, Ds),
    aggregate_all(count, member(turned_edge(1, _, _), Ds), N).
test(inside_out, Ds == [inside_out(1)]) :-
    T = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\n\c
         f 2 4 3\n",
    defects(T, Ds).
test(nonmanifold, N == 3) :-
    T = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\n\c
         f 1 2 5\n",
    defects(T, Ds),
    memberchk(nonmanifold_edge(1, _, N), Ds).
test(degenerate) :-
    defects("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", Ds),
    memberchk(degenerate_face(1, 1), Ds).
% Bow ties: one half is as large as the other, or not.
test(crossed) :-
    defects("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4\n", Ds),
    memberchk(crossed_face(1, 1), Ds),
    \+ memberchk(degenerate_face(1, 1), Ds).
test(crossed_unevenly) :-
    with(obj, "v 0 0 0\nv 1 0 0\nv -0.3 1.4 0\nv 1 1 0\nf 1 2 3 4\n",
         ( fill_triangles(all, 1000, _), model_defect(crossed_face(1, 1)) )).
test(crossed_is_fault, Weight == fault) :-
    defect_weight(crossed_face, Weight).
test(bent) :-
    defects("v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n", Ds),
    memberchk(bent_face(1, 1), Ds).
test(duplicate) :-
    defects("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n", Ds),
    memberchk(duplicate_face(1, 1, 2), Ds).
test(unused, Ds == [unused_vertex(1, 4)]) :-
    defects("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 7 7 7\nf 1 2 3\n", Ds).
test(twins, Ds == [twin_vertices(1, 1, 4)]) :-
    defects("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 1 1\nv 2 2 0\n\c
             f 1 2 3\nf 4 5 6\nf 4 6 5\n", Ds0),
    include([twin_vertices(_, _, _)]>>true, Ds0, Ds).
test(pinched) :-
    defects("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\n\c
             f 1 4 5\n", Ds),
    memberchk(pinched_vertex(1, 1, 2), Ds).
test(one_by_one,
     [ true(Wrong-N-Kinds ==
            []-12000-[pinched_vertex,self_overlap,turned_edge]) ]) :-
    overlapping_pairs(3000, T),
    with(obj, T,
         ( complete_segments,
           findall(D, model_defect(D), Ds),
           findall(D, ( member(D, Ds),
                        \+ findall(x, model_defect(D), [x]) ),
                   Wrong) )),
    length(Ds, N),
    findall(K, ( member(D, Ds), functor(D, K, _) ), Ks),
    sort(Ks, Kinds).
test(open_polygon, Ds == [open_polygon(1, 1, 1)]) :-
    new_world(World),
    in_world(World,
             ( forall(member(v(V,X,Y), [v(1,0.0,0.0), v(2,1.0,0.0),
                                        v(3,0.0,1.0)]),
                      assert_fact(v(1, V, X, Y, 0.0))),
               assert_fact(e(1, 1, 1, 2, 1)),
               assert_fact(e(1, 2, 2, 3, 1)),
               assert_fact(p(1, 1, [1,2])),
               assert_fact(segment(1, surface, x)),
               findall(open_polygon(S, P, N),
                       model_defect(open_polygon(S, P, N)), Ds) )).
test(json, N == 0) :-
    cube([], T),
    with(obj, T, ( check_report(R),
                   with_output_to(string(Text), print_report(json, R)) )),
    atom_json_dict(Text, J, []),
    get_dict(faults, J, N).
test(text, Lines == [ "  8 vertices, 12 edges, 6 polygons, 0 triangles",
                      "  area         24", "  volume       8",
                      "  shell of 6 polygons: closed, \c
                       Euler characteristic 2, genus 0",
                      "no faults" ]) :-
    cube([], T),
    printed(en, T, Lines).
test(text_of_one) :-
    printed(en, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", Lines),
    memberchk("  3 vertices, 3 edges, 1 polygon, 0 triangles", Lines),
    memberchk("  3 border edges", Lines).
test(korean, Lines == [ "  꼭짓점 8개, 모서리 12개, 다각형 6개, 삼각형 0개",
                        "  넓이           24", "  부피           8",
                        "  껍질(다각형 6개): 닫힘, 오일러 지표 2, 종수 0",
                        "잘못이 없습니다" ]) :-
    cube([], T),
    printed(ko, T, Lines).
test(same_lines_in_korean) :-
    cube([2], T0), string_concat(T0, "l 1 7\n", T),
    printed(en, T, Lines),
    printed(ko, T, LinesKo),
    length(Lines, N),
    length(LinesKo, N),
    N > 5.

%   change(Wanted, Olds, Rows): rows of the one polygon that are not as its
%   corners have them, in the place of Olds.

change([wrong_plane], [Old], [plane(1, 1, Nx, Ny, Nz, D)]) :-
    Old = plane(1, 1, Nx0, Ny0, Nz0, D0),
    call(Old),
    member(Nx0-Nx, [0.0-0.0,0.0-1.0e-3]),
    member(Ny0-Ny, [0.0-0.0,0.0-0.002]),
    member(Nz, [Nz0,-1.0,2.0]),
    member(D, [D0,1.0e-3,-2.0]),
    [Nx,Ny,Nz,D] \== [Nx0,Ny0,Nz0,D0].
change([wrong_triangles], [Old], Rows) :-
    Old = t(1, 1, T, A, B, C),
    call(Old),
    (   Rows = []                       % missing, turned, another corner
    ;   Rows = [t(1, 1, T, B, A, C)]
    ;   v(1, V, _, _, _),
        \+ memberchk(V, [A,B,C]),
        Rows = [t(1, 1, T, A, B, V)]
    ).
change([wrong_triangles], [], [t(1, 1, 99, A, B, C)]) :-
    t(1, 1, _, A, B, C).

derived(Defects) :-
    findall(Name,
            ( member(Name, [wrong_plane,wrong_triangles]),
              functor(Defect, Name, 2),
              once(model_defect(Defect)) ),
            Defects).

changed(Olds, Rows, Found) :-
    facts_snapshot(( maplist(retract_fact, Olds),
                     maplist(assert_fact, Rows),
                     derived(Found) )).

an_l("v 0 0 0\nv 4 0 0\nv 4 1 0\nv 2 1 0\nv 2 3 0\nv 0 3 0\nf 1 2 3 4 5 6\n").

test(derived_as_made, Defects == []) :-
    an_l(Text),
    with(obj, Text, ( complete_segments, derived(Defects) )).
test(derived_otherwise, Wrong == []) :-
    an_l(Text),
    with(obj, Text,
         ( complete_segments,
           findall(change(Wanted, Olds, Rows), change(Wanted, Olds, Rows),
                   Changes),
           findall(Rows-Found,
                   ( member(change(Wanted, Olds, Rows), Changes),
                     changed(Olds, Rows, Found),
                     Found \== Wanted ),
                   Wrong) )),
    length(Changes, N),
    assertion(N > 50).

test(empty) :-
    new_world(World),
    in_world(World, check_report(R)),
    report_faults(R, 0).

:- end_tests(check).
