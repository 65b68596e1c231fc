:- encoding(utf8).
:- module(test_model_plain, []).
% covers: plain_facts_rows, plain_polygons_rows, plain_read_rows
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(text_file), [with_text/4]).
:- use_module(rules(model/model_file)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

/* Plain facts that the kernel reads at once, against model_text.pl, which reads
   them one by one: the same rows, or the same error. Of models also in the same
   order; a row that is not plain may come before those that are.
*/

%   read_slowly(File): no fact is taken as plain.

read_slowly(File) :-
    with_text(facts, File, Text,
              sg_model_file:text_added_at_once(Text, none, [], _)).

read_quickly(File) :-
    read_model(File, [], _).

%   what_is_read(Read, File, Outcome): File is read twice, so that numbers are
%   shifted.

what_is_read(Read, File, Outcome) :-
    in_new_world(( catch(( call(Read, File), call(Read, File) ), Error,
                         Outcome = Error),
                   (   var(Outcome)
                   ->  all_rows(Outcome)
                   ;   true
                   ) )).

all_rows(Rows) :-
    findall(Name-Some,
            ( relation(Name, Arity, _),
              \+ memberchk(Name, [screen,contour,surface_facing,drawn,span]),
              functor(Row, Name, Arity),
              findall(Row, store_row(Row), Some) ),
            Rows).

store_row(Row) :-
    catch(sg_store:Row, error(_, _), fail).

same(Order, File) :-
    what_is_read(read_slowly, File, Slowly0),
    what_is_read(read_quickly, File, Quickly0),
    in_order(Order, Slowly0, Slowly),
    in_order(Order, Quickly0, Quickly),
    (   Slowly = error(What, Where)
    ->  Quickly = error(What, Where0),
        Where0 == Where
    ;   Quickly == Slowly
    ).

in_order(own, Rows, Rows).
in_order(any, Rows0, Rows) :-
    (   is_list(Rows0)
    ->  findall(Name-Some, ( member(Name-Some0, Rows0), msort(Some0, Some) ),
                Rows)
    ;   Rows = Rows0
    ).

same_text(Text) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
        ( write(Out, Text),
          close(Out),
          once(same(any, File))
        ),
        delete_file(File)).

model(File) :-
    member(Pattern, ['facts/*.pl','facts/*/*.pl']),
    expand_file_name(Pattern, Files),
    member(File, Files).

%   plain_rest(Text, Rest): Rest is Term-Line:Column, what comes after the plain
%   facts at the beginning of Text.

plain_rest(Text, Rest) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
        ( write(Out, Text),
          close(Out),
          with_text(facts, File, Opened,
                    in_new_world(rest(Opened, Rest)))
        ),
        delete_file(File)).

rest(Text, Rest) :-
    Text = text(_, _, Stream),
    sg_model_plain:with_plain_facts(
        Text, Facts,
        ( sg_model_plain:plain_taken(Facts, Text, shift(0,0)),
          read_term(Stream, Rest0, [term_position(Position)]),
          stream_position_data(line_count, Position, Line),
          stream_position_data(line_position, Position, Column),
          Rest = Rest0-Line:Column
        )).

square("v(1,1,0,0,0). v(1,2,1,0,0).\nv(1,3,1,1,0).\nv(1,4,0,1,0).\n").

with_square(More, Text) :-
    square(Square),
    string_concat(Square, More, Text).

%   text(Text): what may be written in more than one way, or is wrong.

text("p(1,1,[1,2,3,4]).\n").
text("p(1, 1,\n  [ 1, 2, % there\n    3, 4 ]).\nsegment(1,surface,a).\n").
text("p(1,1,[1,2,3,4,1,-2,3,1,2]).\n").
text("p(1,1,[1,2,3,4,-1,2]).\n").
text("p(1,1,[1,-2]).\n").
text("p(1,1,[]).\n").
text("p(1,1,[-1,2,3]).\n").
text("p(1,1,[1,2]).\n").
text("p(1,1,[1,2,2,3]).\n").
text("p(1,1,[1,2,3,1,2]).\n").
text("p(1,1,[1,2,5]).\n").
text("p(1,1,[1,2,3]). p(1,1,[3,4,1]).\n").
text("p(1,2,[1,2,3]). p(1,1,[3,4,1]). plane(1,1,0,0,1,0).\n").
text("p(1,1,[1,2,3]). t(1,1,1,1,2,3). t(1,1,1,1,2,3).\n").
text("p(1,1,[1,2,3]). plane(1,2,0,0,1,0).\n").
text("p(1,1,[1,2,3]). sides(1,1,1,2). region(1,1,outside).\n\c
      region(1,2,cell).\n").
text("p(1,1,[1,2,3]). sides(1,1,1,3). region(1,1,outside).\n").
text("p(1,1,[1,2,3]). from_p(1,1,7,3,-1). from_v(1,1,7,2).\n").
text("p(1,1,[1,2,3]). from_p(1,1,7,3,2).\n").
text("p(1,1,[1,2,3]). region(1,1,nowhere).\n").
text("e(1,1,1,2,1). e(1,2,2,3,1). e(1,3,3,1,0). p(1,1,[1,2,3]).\n").
text("p(1,1,[1,2,3]). e(1,1,1,2,1). e(1,2,2,3,1). e(1,3,3,1,0).\n").
text("e(1,1,1,2,1). e(1,2,2,3,1). e(1,3,3,1,2). p(1,1,[1,2,3]).\n").
text("e(1,1,1,2,1). e(1,2,2,3,1). p(1,1,[1,2,3]).\n").
text("e(1,1,1,2,1). e(1,2,2,3,1). e(1,3,1,3,1). p(1,1,[1,2,3]).\n").
text("e(1,1,1,2,1). e(1,1,2,3,1).\n").
text("e(1,1,1,9,1).\n").
text("v(1,1,0,0,0). p(1,1,[1,2,3]).\n").
text("v(2,1,0,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,1.0e91,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,1.0e999,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,1.0e-320,-0.0,-0). p(1,1,[1,2,5]).\n").
text("v(1,5,0x10,0'a,1_000). p(1,1,[1,2,5]).\n").
text("v(1,5,1.5e3,2.5E-1,- 1). p(1,1,[1,2,5]).\n").
text("v(1,5,1r3,1.0Inf,1). p(1,1,[1,2,5]).\n").
text("v(1,5,0.1,0.30000000000000004,12345678901234567890). p(1,1,[1,2,5]).\n").
text("v(1,5,2*3,pi,1). p(1,1,[1,2,5]).\n").
text("param(a, 2).\nv(1,5,a,1,a). p(1,1,[1,2,5]). p(1,2,[1,5,3]).\n").
text("v(1,0,0,0,0). p(1,1,[1,2,3]).\n").
text("v(0,1,0,0,0). p(1,1,[1,2,3]).\n").
text("v(2147483647,1,0,0,0). p(1,1,[1,2,3]).\n").
text("v(1,4294967297,0,0,0). p(1,1,[1,2,3]).\n").
text("v(1,99999999999999999999,0,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,0,0,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,0,0,0) p(1,1,[1,2,3]).\n").
text("v(1,5,0,0,0).p(1,1,[1,2,3]).\n").
text("v (1,5,0,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,X,0,0). p(1,1,[1,2,3]).\n").
text("v(1,5,0,0,0) :- true. p(1,1,[1,2,3]).\n").
text("'v'(1,5,0,0,0). p(1,1,[1,2,5]).\n").
text("/* here */ v(1,5,0,0,0). p(1,1,[1,2,5]).\n").
text("\tv(1,5,0,0,0).\r\n% 이것\n\tp(1,1,[1,2,5]). wrong.\n").
text("p(1,1,[1,2,3]). curve(1,[3,4]). p(1,2,[1,3,4]).\n").
text("p(1,1,[1,2,3]). curve(1,[4]).\n").
text("curve(1,[1,2,3]).\n").
text("segment(1,cells,a). segment(2,solid,box(size(1,1,1))).\n\c
      p(1,1,[1,2,3]).\n").
text("p(1,1,[1,2,3]). leaf_v(1,1,0,0,0). leaf_e(1,1,1,2,1).\n").
text("p(1,1,[1,2,3]). piece(1,1,1). joint(1,1,1,2,fold,90.0).\n").
text("p(1,1,[1,2/* two */,3]). p(1,2,[1,3,4]).\n").
text("p(1,1,[1,2,3]). p(1,2,[1,0x3,4]). p(1,3,[4,2,1]).\n").
text("p(1,1,[1,2,3])").
text("p(1,1,[1,2,3]).").
text("").
text("end_of_file.\np(1,1,[1,2,3]).\n").

:- begin_tests(model_plain).

test(models, [forall(model(File))]) :-
    same(own, File).
test(texts, [forall(text(More))]) :-
    with_square(More, Text),
    same_text(Text).
test(nothing_left, Rest == end_of_file-8) :-
    with_square("p(1, 1,\n  [1,2, % 둘\n\t3,4]).\n% the end\n", Text),
    plain_rest(Text, Term-Line:_),
    Rest = Term-Line.
test(a_place, Rest == foo-6:10) :-
    with_square("% 셋 \t\n% 넷\n\t  foo.\n", Text),
    plain_rest(Text, Rest).
test(not_plain, [forall(member(Fact, [ "v(1,5,2*3,0,0)", "v(1,5,1e5,0,0)",
                                       "light(1,strength(1))",
                                       "view(1,2,3)", "v(1,5,0x1,0,0)" ])),
                 Line == 4]) :-
    with_square(Fact, Text0),
    string_concat(Text0, ".\n", Text),
    plain_rest(Text, _-Line:_).

:- end_tests(model_plain).
