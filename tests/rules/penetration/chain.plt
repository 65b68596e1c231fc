:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(rules(store)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(command/lines_out)).
:- use_module(rules(model/model_file)).
:- use_module(rules(model/model_writer)).
:- use_module(tests('oracle/chain')).

/* Chains of lines, written by hand: only line/9 and v/5 matter here. */

:- meta_predicate with_lines(+, 0).

%   with_lines(+Ends, :Goal): lines 1, 2, ... between the vertices A-B, vertex
%   V standing at (V, V*V, 0) in segment 1 and, as V+100, in segment 2.

with_lines(Ends, Goal) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, surface, one)),
               assert_fact(segment(2, surface, two)),
               assert_fact(p(1, 1, [])),
               assert_fact(p(2, 1, [])),
               forall(between(1, 9, V), vertex(V)),
               forall(nth1(L, Ends, A-B), line_piece(L, A, B)),
               Goal
             )).

vertex(V) :-
    X is float(V),
    Y is float(V*V),
    W is V+100,
    assert_fact(v(1, V, X, Y, 0.0)),
    assert_fact(v(2, W, X, Y, 0.0)).

line_piece(L, A, B) :-
    A2 is A+100,
    B2 is B+100,
    assert_fact(line(L, 1, 1, A, B, 2, 1, A2, B2)).

chains_of(Ends, Chains) :-
    with_lines(Ends,
               ( chains(Cs),
                 findall(Kind-Lines, member(chain(1, 2, Kind, Lines), Cs),
                         Chains) )).

written(Ends, Format, Text) :-
    with_lines(Ends,
               with_output_to(string(Text),
                              write_lines_to(current_output, Format, []))).

%   Up to 15 lines between up to 9 vertices, some from a vertex to itself.

random_ends(Ends) :-
    random_between(0, 15, N),
    random_between(2, 9, Most),
    findall(A-B,
            ( between(1, N, _),
              random_between(1, Most, A),
              random_between(1, Most, B) ),
            Ends).

%   Every other line again, backwards and between segments 1 and 3, with
%   numbers that descend.

third_segment(Ends) :-
    assert_fact(segment(3, surface, three)),
    assert_fact(p(3, 1, [])),
    forall(between(1, 9, V),
           ( X is float(V), assert_fact(v(3, V, X, 0.0, 0.0)) )),
    forall(( nth1(N, Ends, A-B), N mod 2 =:= 0 ),
           ( L is 100-N,
             assert_fact(line(L, 1, 1, B, A, 3, 1, B, A)) )).

:- begin_tests(chain).

test(none, Cs == []) :-
    chains_of([], Cs).
test(one, Cs == [open-[1]]) :-
    chains_of([1-2], Cs).
test(loop, Cs == [closed-[1,2,3]]) :-
    chains_of([1-2,2-3,3-1], Cs).
test(two_vertices_in_one_place_are_two_points, Cs-Text == [[-1,2]]-true) :-
    with_lines([5-1],
               ( assert_fact(v(2, 111, 1.0, 1.0, 0.0)),
                 assert_fact(line(2, 1, 1, 5, 1, 2, 1, 105, 111)),
                 findall(Ls, chain(_, 1, 2, open, Ls), Cs),
                 with_output_to(string(_),
                                write_lines_to(current_output, csv, [])),
                 Text = true )).
test(loop_of_turned_pieces, Cs == [closed-[1,-3,2]]) :-
    chains_of([1-2,3-1,3-2], Cs).
test(open_from_the_smaller_end, Cs == [open-[-1,-3,2]]) :-
    chains_of([1-2,3-4,3-1], Cs).
test(branch, Cs == [open-[1],open-[2],open-[3]]) :-
    chains_of([1-2,2-3,2-4], Cs).
test(eight, Cs == [closed-[1,2,3],closed-[4,5,6]]) :-
    chains_of([1-2,2-3,3-1,1-4,4-5,5-1], Cs).
test(open_before_closed, Cs == [open-[4],closed-[1,2,3]]) :-
    chains_of([1-2,2-3,3-1,4-5], Cs).
test(numbers_only, Kinds == [1-closed]) :-
    with_lines([1-2,2-3,3-1],
               findall(C-Kind, chain(C, 1, 2, Kind, _), Kinds)).
test(vertices, V1s-V2s == [2,1,3]-[102,101,103]) :-
    with_lines([1-2,1-3],
               ( chain(_, _, _, open, Lines),
                 chain_vertices(Lines, 1, V1s),
                 chain_vertices(Lines, 2, V2s) )).
test(other_segment, fail) :-
    with_lines([1-2], chain_vertices([1], 3, _)).
test(length, L =:= sqrt(10)+sqrt(26)) :-
    with_lines([1-2,2-3], chain_length([1,2], L)).

test(table, Rows == ["chain,kind,s1,s2,point,v1,v2,x,y,z,length,p1,p2,\c
                      contact,place1,place2",
                     "1,open,1,2,1,1,101,1.0,1.0,0.0,0.0,1,1,\c
                      vertex-vertex,vertex 1,vertex 101",
                     "1,open,1,2,2,2,102,2.0,4.0,0.0,3.1622776601683795,1,1,\c
                      vertex-vertex,vertex 2,vertex 102"]) :-
    written([1-2], csv, Text),
    split_string(Text, "\n", "", Rows0),
    exclude(==(""), Rows0, Rows).
test(obj_closed, true) :-
    written([1-2,2-3,3-1], obj, Text),
    sub_string(Text, _, _, _, "\nl 1 2 3 1\n").
test(obj_numbers_on, true) :-
    written([1-2,3-4], obj, Text),
    sub_string(Text, _, _, _, "\nl 3 4\n").
test(svg, nondet) :-
    written([1-2,2-3,3-1], svg, Text),
    sub_string(Text, _, _, _, "class=\"visible penetration\""),
    sub_string(Text, _, _, _, "Z\"/>").
test(facts_read_back,
     Points == [p(1.0,1.0,0.0),p(2.0,4.0,0.0),p(3.0,9.0,0.0)]) :-
    written([1-2,2-3,3-1], pl, Text),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
        write(Out, Text), close(Out)),
    new_world(World),
    in_world(World,
             ( read_model(File, [], _),
               segment(1, curve, penetration(1, 2, closed)),
               findall(E, e(1, E, _, _, _), [_,_,_]),
               findall(p(X,Y,Z), v(1, _, X, Y, Z), Points) )),
    delete_file(File).
test(table_backward, Points-Lengths =@= ["4.0","1.0","9.0"]-["0.0",_,_]) :-
    written([2-1,1-3], tsv, Text),
    split_string(Text, "\n", "\n", [_|Rows]),
    maplist([Row,Y,Length]>>( split_string(Row, "\t", "", Cells),
                              nth1(9, Cells, Y), nth1(11, Cells, Length0),
                              ( Length0 == "0.0" -> Length = Length0 ; true )
                            ), Rows, Points, Lengths).
test(table_of_ring, N =:= 5) :-
    written([1-2,2-3,3-1], csv, Text),
    split_string(Text, "\n", "\n", Rows),
    length(Rows, N).
test(dxf_layers, Layers == ["PENETRATION_BRANCH","PENETRATION_CLOSED",
                            "PENETRATION_OPEN"]) :-
    written([1-2,2-3,2-4, 5-6, 7-8,8-9,9-7], dxf, Text),
    split_string(Text, "\n", " ", Lines),
    findall(Layer, append(_, ["POLYLINE","8",Layer|_], Lines), Layers0),
    sort(Layers0, Layers).
% The kernel gives what the rule gives, on random graphs of two pairs.
test(by_rule, Bad == []) :-
    set_random(seed(11)),
    findall(Ends,
            ( between(1, 400, _),
              random_ends(Ends),
              with_lines(Ends, ( third_segment(Ends),
                                 chains(Kernel),
                                 chains_by_rule(Rule) )),
              Kernel \== Rule ),
            Bad).
test(empty_files, forall(line_format(Format))) :-
    written([], Format, _).

% A contact in a point: a piece from a vertex to itself.
test(point, Cs == [point-[2],closed-[1,3,4]]) :-
    chains_of([1-2,5-5,2-3,3-1], Cs).
test(point_vertices, V1s-V2s-L == [5]-[105]-0.0) :-
    with_lines([5-5],
               ( chain_vertices([1], 1, V1s),
                 chain_vertices([1], 2, V2s),
                 chain_length([1], L) )).
test(point_table, true) :-
    written([5-5], csv, Text),
    split_string(Text, "\n", "\n", [_|Rows]),
    Rows = [Row],
    string_concat("1,point,1,2,1,5,105,5.0,25.0,0.0,0.0,", _, Row).
test(point_obj, true) :-
    written([1-2,5-5], obj, Text),
    sub_string(Text, _, _, 0, "\np 3\n").
test(point_svg, nondet) :-
    written([5-5], svg, Text),
    sub_string(Text, _, _, _, "\"M50.000 50.000L50.000 50.000\"").
test(point_reads_back, Points-Text1 == [p(5.0,25.0,0.0)]-Text2) :-
    written([5-5], pl, Text),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
        write(Out, Text), close(Out)),
    new_world(World1),
    in_world(World1,
             ( read_model(File, [], _),
               findall(p(X,Y,Z), v(1, _, X, Y, Z), Points),
               write_model(File) )),
    read_file_to_string(File, Text1, []),
    new_world(World2),
    in_world(World2, ( read_model(File, [], _), write_model(File) )),
    read_file_to_string(File, Text2, []),
    delete_file(File).
test(no_chain, [ forall(member(Lines, [1, chain, [a]])),
                 error(type_error(_, _), context(chain_length/2, _)) ]) :-
    chain_length(Lines, _).
test(no_points, error(type_error(list(integer), 1),
                      context(chain_points/2, _))) :-
    chain_points(1, _).
test(unknown_format, error(domain_error(line_format, doc))) :-
    with_lines([], write_lines('x.doc', [])).

:- end_tests(chain).
