:- module(sg_model_writer,
          [ write_model/1,              % +File
            write_model_to/1            % +Stream
          ]).
:- use_module('../csg/csg', [is_node/1, is_helper/1]).
:- use_module('../output', [write_fact/2, writing/3]).
:- use_module('../polygon/polygon_list', [edges_vertex_list/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, plane/6, t/6, leaf_v/5, leaf_e/5, leaf_p/3,
                leaf_t/6, segment/3, origin/3, from_v/4, from_p/5, line/9,
                gluing/2, unfolding/2, piece/3, joint/6, region/3, sides/4,
                from_r/4, lies_in/3, view/3, projection/1,
                title_block/2, look/2, light/2, param/2, param_about/2,
                formula/2, question/2
              ]).
:- use_module(formula_rows,
              [made_by_formula/1, placed_by_formula/1, written_fact/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists), [member/2]).
/** <module> Model files written: canonical, one fact a line.

Segments in the order of their numbers; in each segment/3, v/5, e/5, p/3,
plane/6, t/6, leaf_v/5, leaf_e/5, leaf_p/3, leaf_t/6, origin/3, from_v/4,
from_p/5, piece/3, joint/6, region/3, sides/4, from_r/4, lies_in/3, every
relation in the order of its key, and unfolding/2, look/2; before them param/2
and param_about/2, after them line/9, view/3, projection/1, title_block/2,
light/2 and question/2. Floats have the fewest digits that read back to the same
float. So equal worlds give equal bytes, a small change gives a small
difference, and read_model/3 brings back the same relations.

Where the edges of a segment are just what read_model/3 makes from vertex
lists, as after reading vertex lists or a mesh, its polygons are written as
vertex lists and e/5 is left out. Vertices of a segment that has no edges
are written as curves of one point. Of a node of the CSG tree only segment/3 is
written, as its boundary follows from it. The picture (screen/5, drawn/7) is
computed and never written.

What is made from parameters is written with its formulas (formula_rows.pl), so
a file may be set again: of a primitive with formulas, as long as nothing was
done to it, only segment/3 is written; of a segment whose vertices have formulas
neither plane/6 nor t/6.
*/

%!  write_model(+File) is det.
%
%   Write the current world to File (`-`: standard output).

write_model(-) :-
    !,
    write_model_to(current_output).
write_model(File) :-
    writing(File, text, sg_model_writer:write_model_to).

%!  write_model_to(+Stream) is det.
%
%   Write the current world to Stream, which should be UTF-8.

write_model_to(Stream) :-
    write_line(Stream, '% Sanggwan model. One fact a line, in order.'),
    write_rows(Stream, Name, param(Name, _)),
    write_rows(Stream, About, param_about(About, _)),
    all_segments(Ss),
    forall(member(S, Ss), write_segment(Stream, S)),
    write_lines(Stream),
    write_rows(Stream, 1, view(_, _, _)),
    write_rows(Stream, 1, projection(_)),
    write_rows(Stream, Item, title_block(Item, _)),
    write_rows(Stream, N-Property, light(N, Property)),
    write_rows(Stream, Question, question(Question, _)).

all_segments(Ss) :-
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss).

write_segment(_, S) :-
    is_helper(S),
    !.
write_segment(Stream, S) :-
    is_node(S),
    !,
    nl(Stream),
    write_rows(Stream, 1, segment(S, _, _)),
    write_rows(Stream, 1, gluing(S, _)),
    write_rows(Stream, 1, unfolding(S, _)),
    write_rows(Stream, Look, look(S, Look)).
write_segment(Stream, S) :-
    made_by_formula(S),
    !,
    nl(Stream),
    write_rows(Stream, 1, segment(S, _, _)),
    write_rows(Stream, 1, gluing(S, _)),
    write_rows(Stream, 1, unfolding(S, _)),
    write_rows(Stream, Look, look(S, Look)).
write_segment(Stream, S) :-
    nl(Stream),
    write_rows(Stream, 1, segment(S, _, _)),
    write_rows(Stream, V, v(S, V, _, _, _)),
    (   are_listed(S)
    ->  in_order(P0, p(S, P0, Es), write_listed(Stream, S, P0, Es))
    ;   write_rows(Stream, E, e(S, E, _, _, _)),
        write_rows(Stream, P, p(S, P, _)),
        write_points(Stream, S)
    ),
    (   placed_by_formula(S)
    ->  true
    ;   write_rows(Stream, P2, plane(S, P2, _, _, _, _)),
        write_rows(Stream, T, t(S, _, T, _, _, _))
    ),
    write_rows(Stream, V3, leaf_v(S, V3, _, _, _)),
    write_rows(Stream, E3, leaf_e(S, E3, _, _, _)),
    write_rows(Stream, P3, leaf_p(S, P3, _)),
    write_rows(Stream, T3, leaf_t(S, _, T3, _, _, _)),
    write_origins(Stream, S),
    write_rows(Stream, V4, from_v(S, V4, _, _)),
    write_rows(Stream, P4-S0-P0, from_p(S, P4, S0, P0, _)),
    write_rows(Stream, P5, piece(S, P5, _)),
    write_rows(Stream, J, joint(S, J, _, _, _, _)),
    write_rows(Stream, R, region(S, R, _)),
    write_rows(Stream, P6, sides(S, P6, _, _)),
    write_rows(Stream, R1-S1, from_r(S, R1, S1, _)),
    write_rows(Stream, Item, lies_in(S, Item, _)),
    write_rows(Stream, 1, gluing(S, _)),
    write_rows(Stream, 1, unfolding(S, _)),
    write_rows(Stream, Look, look(S, Look)).

%   write_lines(Stream): except those of nodes, whose polygons are not written.

write_lines(Stream) :-
    findall(S, ( segment(S, _, _), is_node(S) ), Nodes),
    Line = line(L, S1, _, _, _, S2, _, _, _),
    in_order(L,
             ( Line,
               \+ memberchk(S1, Nodes),
               \+ memberchk(S2, Nodes) ),
             write_fact(Stream, Line)).

%   write_origins(Stream, S): except what is remembered of this world alone
%   (csg_record.pl).

write_origins(Stream, S) :-
    findall(Item-origin(S, Item, Origin),
            ( origin(S, Item, Origin), Item \= node(_) ),
            Rows0),
    keysort(Rows0, Rows),
    forall(member(_-Fact, Rows), write_fact(Stream, Fact)).

:- meta_predicate write_rows(+, ?, 0), in_order(?, 0, 0).

%   write_rows(Stream, Key, Goal): every row Goal as a fact, by ascending Key.

write_rows(Stream, Key, Module:Row) :-
    (   formula(_, _)
    ->  in_order(Key, Module:Row, write_written(Stream, Row))
    ;   in_order(Key, Module:Row, write_fact(Stream, Row))
    ).

write_written(Stream, Row) :-
    written_fact(Row, Written),
    write_fact(Stream, Written).

%   in_order(Key, Row, Goal): call Goal for every Row, by ascending Key. Keys
%   that are numbers without many gaps are counted up: nothing is kept, so an
%   interrupt is heard at each row, however many there are.

in_order(Key, Row, Goal) :-
    var(Key),
    Keys = keys(0, 0),
    \+ ( Row,
         \+ counted(Key, Keys) ),
    Keys = keys(Count, Last),
    Last =< 2*Count,
    !,
    forall(between(1, Last, Key),
           forall(Row, Goal)).
in_order(Key, Row, Goal) :-
    findall(Key-Row, Row, Rows0),
    keysort(Rows0, Rows),
    forall(member(Key-Row, Rows), Goal).

counted(Key, Keys) :-
    integer(Key),
    Key > 0,
    Keys = keys(Count0, Last0),
    Count is Count0+1,
    nb_setarg(1, Keys, Count),
    (   Key > Last0
    ->  nb_setarg(2, Keys, Key)
    ;   true
    ).

write_line(Stream, Text) :-
    format(Stream, '~w~n', [Text]).

%   write_points(Stream, S): a segment without edges is points.

write_points(Stream, S) :-
    (   e(S, _, _, _, _)
    ->  true
    ;   forall(v(S, V, _, _, _), write_fact(Stream, curve(S, [V])))
    ).

%   are_listed(S): vertex lists say all about the edges of S: they are real,
%   numbered 1, 2, ... in their order.

are_listed(S) :-
    once(p(S, _, _)),
    Edges = next(1),
    in_order(P, p(S, P, Es), follow(Es, S, Edges)),
    aggregate_all(count, e(S, _, _, _, _), Count),
    Edges = next(Next),
    Next =:= Count+1.

%   follow(Es, S, Edges): Es are real edges of S from the one that is next, and
%   a list of vertices says them all.

follow(Es, S, Edges) :-
    arg(1, Edges, Next0),
    consecutive(Es, Next0, Next),
    real_edges(Es, S, Pairs),
    edges_vertex_list(Pairs, _),
    nb_setarg(1, Edges, Next).

write_listed(Stream, S, P, Es) :-
    real_edges(Es, S, Edges),
    edges_vertex_list(Edges, List),
    write_fact(Stream, p(S, P, List)).

consecutive([], E, E).
consecutive([E|Es], E, Next) :-
    E1 is E+1,
    consecutive(Es, E1, Next).

real_edges([], _, []).
real_edges([E|Es], S, [V1-V2|Edges]) :-
    once(e(S, E, V1, V2, Et)),
    Et =:= 1,
    real_edges(Es, S, Edges).
