:- encoding(utf8).
:- module(test_item_where, []).
:- use_module(library(plunit)).
:- use_module(rules(csg/csg), []).
:- use_module(rules(model/item_where)).
:- use_module(rules(model/model), [load_model/2]).
:- use_module(rules(solid/csg_evaluate), [evaluate/1]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   placed(Text, Goal, Location): where what Goal raises stands, of a file with
%   Text that is read after another one.

placed(Text, Goal, Line:Column) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
        ( write(Out, Text),
          close(Out),
          in_new_world(( load_model(['facts/cube.pl',File],
                                    [evaluate(false)]),
                         catch(Goal, Error0, true),
                         error_placed(Error0, Error) )),
          Error = error(_, location(File, Line, Column))
        ),
        delete_file(File)).

boxes("segment(1, solid, box(size(1,1,1))).\n\c
       segment(2, solid, box(size(1,1,1))).\n\c
       segment(3, cells, glue([1,2])).\n").

text(Facts, Text) :-
    boxes(Boxes),
    string_concat(Boxes, Facts, Text).

:- begin_tests(item_where).

test(of_a_glue, Place == 6:11) :-
    text("v(4,1,0,0,0).\ncurve(4,[1]).\ngluing(3, apart(1-p(tkp))).\n",
         Text),
    placed(Text, evaluate(4), Place).
test(of_a_look, Place == 5:9) :-
    text("look(1, face(top, colour(red))).\nlook(1, face(tkp, shine(1,2))).\n",
         Text),
    placed(Text,
           throw(error(model_error(look(no_face(2, tkp, []))), _)),
           Place).
test(of_an_unfolding, Place == 4:14) :-
    text("unfolding(1, root(tkp)).\n", Text),
    placed(Text,
           throw(error(model_error(unfold(2, root(tkp), no_polygon)), _)),
           Place).
test(others_stay, [ forall(member(Error,
                                  [ error(model_error(empty), here),
                                    error(model_error(unfold(9,root(1),x)), _),
                                    error(model_error(unfold(9,root(1),x)),
                                          location(a,1,1)),
                                    other, _ ])),
                    true(Placed == Error) ]) :-
    error_placed(Error, Placed).

:- end_tests(item_where).
