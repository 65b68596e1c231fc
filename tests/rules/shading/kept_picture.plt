/* The picture of a world that is edited has the bytes of one made afresh. */
% covers: edited_model, picture_file, shading_light
:- module(test_kept_picture, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(rules(decision)).
:- use_module(rules(kernel)).
:- use_module(rules(shading/edited_model)).
:- use_module(rules(shading/kept_picture)).
:- use_module(rules(shading/picture_file)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).
:- use_module(shaded_model).

options([size(120-100), window(b(-6.0,-5.0,6.0,5.0)), smooth(2)]).

leaf(Term) :-
    random_member(Shape, [ box(size(2,2,2)), box(size(1,3,1)),
                           cylinder(radius(1),height(2),facets(24)),
                           sphere(radius(1.2),facets(24)),
                           cone(radius(1),height(2),facets(24)),
                           torus(radius(1.5),tube(0.4),facets(24)),
                           hollow_cylinder(radius(1),inner(0.5),height(2),
                                           facets(24)) ]),
    findall(X, ( between(1, 3, _), random_between(-6, 6, N), X is N/2 ),
            [X,Y,Z]),
    Term = at([translate(X,Y,Z)], Shape).

%   Leaves 1 to 12; roots 21 to 23 over them.
world :-
    forall(between(1, 12, S),
           ( leaf(Term), assert_fact(segment(S, solid, Term)) )),
    assert_fact(segment(21, solid, difference([union([1,2,3]),4,5]))),
    assert_fact(segment(22, solid, union([6,7,intersection([8,9])]))),
    assert_fact(segment(23, solid, union([10,difference([11,12])]))),
    assert_fact(view(300.0,60.0,0.0)).

replaced(S, Term) :-
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, solid, Term)).

edit(move) :-
    random_between(1, 12, S),
    leaf(Term),
    replaced(S, Term).
edit(two) :-
    edit(move),
    edit(move).
edit(add) :-
    random_member(R, [21,22,23]),
    segment(R, _, Term0),
    Term0 =.. [Operation,Operands],
    leaf(Leaf),
    random_between(1, 3, At),
    (   length(First, At),
        append(First, Rest, Operands)
    ->  true
    ;   First = Operands,
        Rest = []
    ),
    append(First, [Leaf|Rest], More),
    Term =.. [Operation,More],
    replaced(R, Term).
edit(remove) :-
    random_member(R, [21,22,23]),
    segment(R, _, Term0),
    Term0 =.. [Operation,Operands],
    length(Operands, N),
    N > 2,
    last(Operands, Last),
    \+ integer(Last),
    append(Fewer, [Last], Operands),
    Term =.. [Operation,Fewer],
    replaced(R, Term).
edit(look) :-
    random_between(1, 12, S),
    random_member(C, [red,blue,rgb(9,99,199)]),
    retractall_facts(look(S, colour(_))),
    assert_fact(look(S, colour(C))).
edit(glass) :-
    random_between(21, 23, S),
    random_member(A, [0.4,1]),
    retractall_facts(look(S, opacity(_))),
    assert_fact(look(S, opacity(A))).
edit(operation) :-
    segment(22, _, Term0),
    Term0 =.. [Operation,Operands],
    (   Operation == union
    ->  Term = intersection(Operands)
    ;   Term = union(Operands)
    ),
    replaced(22, Term).
edit(nothing).

% wrong(Options, Edits, Wrong): which of random edits gives other bytes.
wrong(Options, Count, Wrong) :-
    in_new_world(
        ( world,
          world_picture(Options, _),
          findall(I-What,
                  ( between(1, Count, I),
                    random_member(What, [move,move,move,two,add,remove,look,
                                         glass,operation,nothing]),
                    ignore(edit(What)),
                    world_picture(Options, Image),
                    image_dots(Image, Bytes),
                    shaded_bytes(Options, Fresh),
                    Bytes \== Fresh ),
                  Wrong) )).

:- begin_tests(kept_picture).

test(edits, Wrong == []) :-
    set_random(seed(7)),
    options(Options),
    findall(W, ( between(1, 4, _), wrong(Options, 25, Wrong0),
                 member(W, Wrong0) ),
            Wrong).
test(edits_with_edges, Wrong == []) :-
    set_random(seed(8)),
    options(Options),
    wrong([edges(true)|Options], 25, Wrong).
test(edits_with_shadows, Wrong == []) :-
    set_random(seed(9)),
    options(Options),
    wrong([shadows(true)|Options], 12, Wrong).

%   A rule comes, an edit, the rule goes: each picture is the one made afresh.
test(edits_by_rule, Wrong == []) :-
    set_random(seed(12)),
    options(Options),
    in_new_world(
        ( world,
          assert_fact(segment(24, solid, union([13,14,15]))),
          forall(member(S-Size, [13-size(4,4,3),14-size(2,2,3),15-size(1,4,3)]),
                 assert_fact(segment(S, solid, box(Size)))),
          findall(look(S,colour(C)),
                  member(S-C, [13-red,14-green,15-blue]), Looks),
          forall(member(Look, Looks), assert_fact(Look)),
          kept_bytes(Options, Plain),
          use_last,
          kept_bytes(Options, ByRule),
          assertion(Plain \== ByRule),
          findall(I,
                  ( between(1, 10, I),
                    ignore(edit(move)),
                    (   I =:= 6
                    ->  no_rules
                    ;   true
                    ),
                    kept_bytes(Options, Bytes),
                    shaded_bytes(Options, Fresh),
                    Bytes \== Fresh ),
                  Wrong) )).

kept_bytes(Options, Bytes) :-
    world_picture(Options, Image),
    image_dots(Image, Bytes).

use_last :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, "owner(_, Group, Owner) :- lists:last(Group, Owner)."),
          close(Out) ),
        use_rules(File),
        delete_file(File)).

%   What is made again of a leaf that moved: the rows and columns where it was,
%   and is. The kept picture is painted over, so others are black.
test(some_bands, Black-Beside == 272-320) :-
    in_new_world(
        ( world2,
          world_picture([size(200-320)], _),
          painted_over,
          replaced(2, at([translate(0,0,21)], box(size(1,1,1)))),
          world_picture([size(200-320)], Image),
          black_rows(Image, 112, Black),
          black_rows(Image, 0, Beside) )).
%   A model of which a leaf is edited is what would be made afresh.
test(edited_model, Wrong == []) :-
    set_random(seed(11)),
    findall(I,
            in_new_world(
                ( world,
                  shaded_state(State0),
                  shaded_model([21,22,23], Model0),
                  nb_setval(edited, State0-Model0),
                  between(1, 12, I),
                  edit(move),
                  nb_getval(edited, State1-Model1),
                  shaded_state(State),
                  (   edited_model(State1, State, Model1, Model2, _)
                  ->  Edited = Model2
                  ;   Edited = none
                  ),
                  shaded_model([21,22,23], Model),
                  nb_setval(edited, State-Model),
                  \+ ( Edited == none, other_shape(Model1, Model) ),
                  Edited \== Model )),
            Wrong).
test(new_looks, Black == 0) :-
    in_new_world(
        ( world2,
          world_picture([size(20-32)], _),
          painted_over,
          assert_fact(look(1, colour(red))),
          world_picture([size(20-32)], Image),
          nb_getval(sg_kept_picture, Kept),
          arg(5, Kept, scan(_,_)),      % from the same spans
          findall(Y, ( between(0, 31, Y), image_dot(Image, 0, Y, [0,0,0]) ),
                  Ys),
          length(Ys, Black) )).

black_rows(Image, X, Black) :-
    aggregate_all(count, ( between(0, 319, Y),
                           image_dot(Image, X, Y, [0,0,0]) ), Black).

%   A leaf is another primitive than before.
other_shape(model(Leaves0,_,_), model(Leaves,_,_)) :-
    nth1(I, Leaves0, leaf(_,_,_,_,Faces0)),
    nth1(I, Leaves, leaf(_,_,_,_,Faces)),
    Faces0 \== Faces,
    !.

painted_over :-
    nb_getval(sg_kept_picture, Kept0),
    Kept0 = kept(Key,Frame,Made,Looked,Scan,Image0),
    image_size(Image0, Width, Height),
    image_blank(Width, Height, rgb(0,0,0), Image),
    nb_setval(sg_kept_picture, kept(Key,Frame,Made,Looked,Scan,Image)).
test(frame_stays) :-
    in_new_world(
        ( world2,
          world_picture([size(100-160)], Image1),
          replaced(2, at([translate(0,0,1)], box(size(1,1,1)))),
          world_picture([size(100-160)], Image2),
          replaced(2, at([translate(0,0,20)], box(size(1,1,1)))),
          world_picture([size(100-160)], Image3),
          image_dots(Image1, Bytes1),
          image_dots(Image2, Bytes2),
          image_dots(Image3, Bytes3) )),
    Bytes1 == Bytes3,
    Bytes1 \== Bytes2.
test(undone, Bytes == Bytes1) :-
    options(Options),
    in_new_world(
        ( world,
          world_picture(Options, Image1),
          image_dots(Image1, Bytes1),
          catch(facts_transaction(( edit(two), world_picture(Options, _),
                                    throw(back) )), back, true),
          world_picture(Options, Image),
          image_dots(Image, Bytes) )).

%   A column of 24 units, a small cube beside it.
world2 :-
    assert_fact(segment(1, solid, box(size(1,1,24)))),
    assert_fact(segment(2, solid, at([translate(0,0,20)], box(size(1,1,1))))),
    assert_fact(segment(3, solid, union([1,at([translate(2,0,0)], 2)]))),
    assert_fact(view(270.0,90.0,0.0)).

test(file, Head == "P6\n40 30\n255") :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [extension(ppm)]), close(Out) ),
        ( in_new_world(( world, render(File, [size(40-30)]) )),
          read_file_to_codes(File, Codes, [type(binary)]),
          append(Prefix, _, Codes),
          length(Prefix, 12),
          string_codes(Head, Prefix) ),
        delete_file(File)),
    !.
test(ending, error(domain_error(picture_file,_))) :-
    in_new_world(render('x.svg', [])).
test(empty_world) :-
    in_new_world(( assert_fact(view(300.0,60.0,0.0)),
                   world_picture([size(9-9)], Image),
                   image_dots(Image, Bytes) )),
    forall(sub_string(Bytes, _, 1, _, C), C == "\xff\").

:- end_tests(kept_picture).
