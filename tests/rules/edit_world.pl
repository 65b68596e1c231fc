:- module(sg_test_edit_world,
          [ made/1                      % +Soup
          ]).
/** <module> Random worlds to be edited: primitives, soups, meshes, model files,
trees, glued rooms, one that was written by hand.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(sanggwan)).
:- use_module(rules(topology)).
:- use_module(tests('rules/edit_value')).
:- use_module(tests('rules/soup')).

%!  made(+Soup) is det.
%
%   Adds something to the current world, and asks about it.

made(Soup) :-
    one_of([ soup, primitives, primitives, primitives, tree, tree, mesh, file,
             curve, by_hand, rooms ], Kind),
    catch(ignore(made(Kind, Soup)), _, true),
    one_of([ true, true, penetrate, complete_segments, picture, evaluate,
             develop(1, _), unfold(1, _), set_view(front), regions_made(1, _),
             regions_made(22, _) ],
           Goal),
    catch(ignore(once(Goal)), _, true).

made(soup, Soup) :-
    soup_facts(Soup, Facts),
    maplist([F]>>catch(assert_fact(F), _, true), Facts).
made(primitives, _) :-
    random_between(1, 3, N),
    findall(S, ( between(1, N, _), solid(T), add_primitive(T, S) ), _).
made(curve, _) :-
    add_primitive(line(from(-3, 0.25, 0.5), to(3, 0.25, 0.75)), _).
made(tree, _) :-
    random_between(2, 3, N),
    findall(S, ( between(1, N, _), solid(T), add_primitive(T, S) ), Ss),
    random_permutation(Ss, [A,B|_]),
    one_of([union, intersection, difference, split, join, glue, glue], Name),
    Node =.. [Name,[A,B]],
    N1 is N+20,
    facts_transaction(assert_fact(segment(N1, solid, Node))),
    evaluate.
%   Boxes beside each other and through each other, glued: walls that two rooms
%   have in common, and their regions.
made(rooms, _) :-
    random_between(2, 4, N),
    findall(S,
            ( between(1, N, I),
              one_of([0, 0.5, 1, 2], Y),
              X is I*2,
              one_of([box(size(2,2,2)), box(size(2.5,1,2))], Box),
              add_primitive(at([translate(X,Y,0)], Box), S) ),
            Ss),
    one_of([solid, cells], Kind),
    facts_transaction(assert_fact(segment(22, Kind, glue(Ss)))),
    evaluate,
    regions_made(22, _).
made(mesh, Soup) :-
    soup_obj(Soup, Text),
    with_text(obj, Text, File, read_mesh(File, _)).
made(file, _) :-
    one_of([ "segment(1,solid,box(size(2,2,2))).\n\c
              segment(2,solid,at([translate(1,1,1)],cylinder(radius(1),\c
              height(2),facets(8)))).\nsegment(3,solid,difference([1,2])).\n",
             "v(1,1,0,0,0).\nv(1,2,1,0,0).\nv(1,3,0,1,0).\np(1,1,[1,2,3]).\n",
             "segment(1,surface,x).\nv(1,1,0,0,0).\nv(1,2,4,0,0).\n\c
              v(1,3,4,4,0).\nv(1,4,0,4,0).\np(1,1,[1,2,3,4]).\n\c
              view(30,60,9).\nunfolding(1,root(1)).\n",
             "param(w,2).\nparam(h,1.5*param(w)).\n\c
              segment(1,solid,box(size(param(w),param(h),2))).\n\c
              segment(2,solid,at([translate(1,0,1)],cylinder(radius(1),\c
              height(param(h)),facets(8)))).\n\c
              projection(parallel).\nlight(1,strength(2)).\n\c
              look(1,colour(rgb(9,99,199))).\ntitle_block(name,'x').\n",
             "segment(1,solid,box(size(2,2,2))).\n\c
              segment(2,solid,at([translate(2,0,0)],box(size(2,1,2)))).\n\c
              segment(22,cells,glue([1,2])).\ngluing(22,only(faces)).\n" ],
           Text),
    with_text(pl, Text, File, load_model(File)).
made(by_hand, _) :-
    forall(member(V-X-Y-Z, [1-0-0-0, 2-2-0-0, 3-0-2-0, 4-0-0-2]),
           assert_fact(v(7, V, X, Y, Z))),
    forall(nth1(E, [1-3,3-2,2-1, 1-2,2-4,4-1, 2-3,3-4,4-2, 3-1,1-4,4-3], A-B),
           assert_fact(e(7, E, A, B, 1))),
    forall(between(1, 4, P),
           ( A is 3*P-2, B is A+1, C is A+2,
             assert_fact(p(7, P, [A,B,C])) )),
    assert_fact(segment(7, solid, by_hand)).

:- meta_predicate with_text(+, +, -, 0).

with_text(Extension, Text, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8),extension(Extension)]),
          write(Out, Text),
          close(Out) ),
        call(Goal),
        catch(delete_file(File), _, true)).
