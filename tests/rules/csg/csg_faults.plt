:- encoding(utf8).
/* What is wrong with CSG trees, said in both languages. */
:- module(test_csg_faults, []).
:- use_module(library(plunit)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(csg/csg_term), [operation_form/2]).
:- use_module(rules(message/messages)).
:- use_module(rules(message/messages_ko)).
:- use_module(rules(model/model)).
:- use_module(rules(primitive/primitive), [primitive/1]).
:- use_module(rules(store)).
:- use_module(tests(rules/message_text), [message_text/3]).

%   wrong(Term, What): segment 2 is Term; 1 is a box, 8 a sheet, 9 a curve.

wrong(union(1), no_list(union, 1)).
wrong(intersection([]), no_operands(intersection)).
wrong(union([1, box]), unknown(box)).
wrong(union([1, -1]), unknown(-1)).
wrong(union([1, 2.5]), unknown(2.5)).
wrong(at([scale(2)], union([named(x, foo(1))])), unknown(foo(1))).
wrong(split(1, plane(0, 0, 0.0, 1), below), plane(_)).
wrong(split(1, plane(0, 0, a, 1), below), plane(_)).
wrong(split(1, plane(0, 0, 1, 1), inside), side(inside, [below,above])).
wrong(split(1, 1, below), side(below, [inside,outside])).
wrong(split(1, 8, inside), surface(2, 8, split)).
wrong(split(8, 1, inside), surface(2, 8, split)).
wrong(split(1, 9, inside), curve(2, 9)).
wrong(union([1, 3]), missing(2, 3)).
wrong(at([scale(2)], 3), missing(2, 3)).
wrong(difference([1, union([1, 2])]), cycle([2,_,2])).
wrong(at([scale(2)], 2), cycle([2,2])).
wrong(union([9]), curve(2, 9)).
wrong(difference([8, 1]), surface(2, 8, difference)).
wrong(difference([1, union([1, 8])]), surface(2, _, difference)).

tree_read(Term) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    format(Stream, "~q.~n~q.~n~q.~n~q.~n",
           [ segment(1, solid, box(size(1,1,1))),
             segment(8, surface, rectangle(size(1,1))),
             segment(9, curve, line(from(0,0,0), to(1,1,1))),
             segment(2, solid, Term) ]),
    close(Stream),
    call_cleanup(load_model(File), delete_file(File)).

%   fault(Goal, What, Where): that Goal raises in a new world.

fault(Goal, What, Where) :-
    new_world(World),
    in_world(World,
             ( catch(( Goal, fail ), error(model_error(csg(What)), Where),
                     true),
               \+ segment(2, _, _) )).

:- begin_tests(csg_faults).

test(refused, [forall(wrong(Term, What)), true(Found = What)]) :-
    fault(tree_read(Term), Found, location(_, 4, 17)).
test(in_the_second_file,
     [forall(wrong(Term, What)), true(Found = What)]) :-
    new_world(World),
    in_world(World,
             ( tree_read(union([1])),
               catch(tree_read(Term), error(model_error(csg(Found)), _),
                     true) )).
test(told, forall(( wrong(Term, _), member(Language, [en,ko]) ))) :-
    fault(tree_read(Term), What, Where),
    message_text(Language, error(model_error(csg(What)), Where), Text),
    sub_string(Text, Before, _, After, "\n  "),
    Before > 5,
    After > 5,
    !.
test(asserted, forall(wrong(Term, _))) :-
    new_world(World),
    in_world(World,
             ( tree_read(union([1])),
               retractall_facts(segment(2, _, _)),
               assert_fact(segment(2, solid, Term)),
               catch(( evaluate(2), fail ),
                     error(model_error(csg(_)), Where), true),
               var(Where),
               segment(2, solid, Term),
               once(v(2, _, _, _, _)) )).

%   Operands without a number of the user's are called by where they stand, when
%   the tree is read and when it is made.

unnumbered(difference([8, union([sphere(radius(1)), rectangle(size(2,2))])]),
           surface(2, 8, difference)).
unnumbered(difference([1, union([1, at([], rectangle(size(2,2)))])]),
           surface(2, operand(2, union, 2), difference)).
unnumbered(union([1, named(wire, line(from(0,0,0), to(1,1,1)))]),
           curve(2, operand(2, wire, 2))).
unnumbered(difference([1, split(box(size(2,2,2)), rectangle(size(0.1,0.1)),
                                below)]),
           not_through(operand(2, rectangle, operand(2, split, 2)))).

test(unnumbered, [forall(unnumbered(Term, What)), true(Found == What)]) :-
    new_world(World),
    in_world(World,
             catch(( tree_read(Term), evaluate(2) ),
                   error(model_error(csg(Found)), _), true)).
test(unnumbered_told, [forall(( unnumbered(_, What),
                                member(Language, [en,ko]) ))]) :-
    message_text(Language, error(model_error(csg(What)), _), Text),
    \+ sub_string(Text, _, _, _, "operand("),
    ( sub_string(Text, _, _, _, "2") -> true ).

%   A mere name is told its arguments, not that it may be meant for itself.

mere_name(Name) :-
    primitive(Name).
mere_name(Name) :-
    operation_form(Name, _).

test(mere_name, [forall(( mere_name(Name), member(Language, [en,ko]),
                          member(What, [ csg(unknown(Name)),
                                         primitive(unknown, Name),
                                         no_vertices(1, Name) ]) ))]) :-
    message_text(Language, error(model_error(What), _), Text),
    sub_string(Text, Before, _, _, Name),
    sub_string(Text, Between, _, _, "("),
    Between > Before,
    \+ sub_string(Text, _, _, _, "Did you mean"),
    \+ sub_string(Text, _, _, _, "비슷한 것"),
    !.

:- end_tests(csg_faults).
