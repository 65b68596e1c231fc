/* look/2 and light/2 of models and of files of their own: what is read, what is
   refused and where, what is written. */
% covers: look_term, look_en, look_ko
:- module(test_look_file, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(colour)).
:- use_module(rules(message/look_en)).
:- use_module(rules(message/look_ko)).
:- use_module(rules(model/look_file)).
:- use_module(rules(model/model), [load_model/1, save_model/1]).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

with_file(Text, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out) ),
        once(Goal),
        delete_file(File)).

:- meta_predicate with_file(+, -, 0), with_model(+, 0).

box(1, "segment(1, solid, box(size(1,1,1))).\n").
box(named, "segment(1, solid, named(lid, box(size(1,1,1)))).\n").
box(node, "segment(4, solid, difference([named(lid, box(size(1,1,1))),\n\c
           sphere(radius(0.5))])).\n").

with_model(Text, Goal) :-
    with_file(Text, File, in_new_world(( load_model(File), Goal ))).

rows(Rows) :-
    findall(look(S, P), look(S, P), Looks),
    findall(light(N, P), light(N, P), Lights),
    append(Looks, Lights, Rows0),
    msort(Rows0, Rows).

model_rows(Box, Text, Rows) :-
    box(Box, Start),
    string_concat(Start, Text, All),
    with_model(All, rows(Rows)).

%   Where and what is wrong, the box being line 1; the world stays empty.
model_fault(Text, What, Line:Column) :-
    box(1, Start),
    string_concat(Start, Text, All),
    with_file(All, File,
              in_new_world(( catch(load_model(File), Error, true),
                             \+ segment(_, _, _),
                             \+ look(_, _),
                             \+ light(_, _) ))),
    Error = error(model_error(What), location(File, Line, Column)).

%   A model and a file of looks.
file_rows(Box, Text, Rows, InVain) :-
    box(Box, Start),
    with_model(Start,
               with_file(Text, File,
                         ( look_file_added(File, InVain), rows(Rows) ))).

file_fault(Text, What, Line:Column) :-
    box(1, Start),
    with_model(Start,
               with_file(Text, File,
                         ( catch(look_file_added(File, _), Error, true),
                           rows([]) ))),
    Error = error(model_error(What), location(File, Line, Column)).

:- begin_tests(look_file).

test(read, Rows == [ light(0, strength(0.5)), light(2, direction(0,0,-1)),
                     look(1, colour(red)) ]) :-
    model_rows(1, "look(1, colour(red)). light(0, strength(0.5)).\n\c
                   light(2, direction(0,0,-1)).", Rows).
test(rgb, Rows == [look(1, colour(rgb(200,60,0)))]) :-
    model_rows(1, "look(1, colour(rgb(200,60,0))).", Rows).
test(before_its_segment, Rows == [look(1, colour(blue))]) :-
    box(1, Box),
    string_concat("look(1, colour(blue)).\n", Box, Text),
    with_model(Text, rows(Rows)).
test(operand, Rows == [look(5, colour(blue))]) :-
    model_rows(node, "look(5, colour(blue)).", Rows).

test(no_segment, What-Place == look(no_segment(2))-(2:6)) :-
    model_fault("look(2, colour(red)).", What, Place).
test(no_colour, [true(W-X == colour-(2:9))]) :-
    model_fault("look(1, colour(rde)).",
                value(look, 'Property', colour(rde), look(W)), X).
test(no_byte, [ forall(member(C, ["rgb(256,0,0)", "rgb(0,-1,0)", "rgb(1,2)",
                                  "rgb(0.5,0,0)", "X", "\"red\"", "f(x)"])),
                true(Place == 2:9) ]) :-
    format(string(Text), "look(1, colour(~s)).", [C]),
    model_fault(Text, value(look, _, _, look(colour)), Place).
test(no_property, Place == 2:9) :-
    model_fault("look(1, smell(3)).", value(look, _, _, look(any)), Place).
test(twice, What-Place == look(twice(1, colour))-(3:1)) :-
    model_fault("look(1, colour(red)).\nlook(1, colour(blue)).", What, Place).
test(arity, Place == 2:1) :-
    model_fault("look(1, colour, red).", arity(look, 3, 2), Place).

test(no_light, Place == 2:7) :-
    model_fault("light(9, strength(1)).", value(light, 'N', 9, one_of(_)),
                Place).
test(no_length, Place == 2:10) :-
    model_fault("light(1, direction(0,0.0,0)).", value(light, _, _, light(way)),
                Place).
test(not_finite, [ forall(member(X, ["inf", "nan", "1.0e300", "a", "_"])),
                   true(Place == 2:10) ]) :-
    format(string(Text), "light(1, picture(~s,1,1)).", [X]),
    model_fault(Text, value(light, _, _, light(way)), Place).
test(strength, [ forall(member(X, ["-0.1", "11", "nan", "f(1)"])),
                 true(Place == 2:10) ]) :-
    format(string(Text), "light(1, strength(~s)).", [X]),
    model_fault(Text, value(light, _, _, light(strength)), Place).
test(everywhere, What-Place == look(everywhere)-(2:10)) :-
    model_fault("light(0, picture(1,1,1)).", What, Place).
test(light_twice, What-Place == look(light_twice(2, direction))-(3:1)) :-
    model_fault("light(2, picture(1,1,1)).\nlight(2, direction(0,0,1)).",
                What, Place).
test(no_way, What-Place == look(no_way(3))-(2:1)) :-
    model_fault("light(3, strength(1)).", What, Place).

%   The second model comes behind the first: its segment, its look; its lights
%   are all there are.
test(two_models, Rows == [ light(2, direction(0,0,1)), look(1, colour(red)),
                           look(2, colour(blue)) ]) :-
    box(1, Box),
    string_concat(Box, "look(1, colour(red)). light(1, strength(1)).", A),
    string_concat(Box, "look(1, colour(blue)). light(2, direction(0,0,1)).",
                  B),
    with_file(A, FileA,
              with_file(B, FileB,
                        in_new_world(( load_model([FileA,FileB]),
                                       rows(Rows) )))).

%   What is saved is read again; the second time the same bytes.
test(saved, Again-Text == Rows-Second) :-
    box(node, Box),
    string_concat(Box, "look(4, colour(red)). look(6, colour(rgb(1,2,3))).\n\c
                        light(2, picture(1,-2,3.5)). light(2, strength(0.5)).",
                  Model),
    with_model(Model, ( rows(Rows), saved(Text) )),
    Rows = [_,_,_,_],
    with_model(Text, ( rows(Again), saved(Second) )).

saved(Text) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          close(Out) ),
        ( save_model(File),
          read_file_to_string(File, Text, [encoding(utf8)]) ),
        delete_file(File)).

% ---- a file of their own -----------------------------------------------------

test(file, Rows-InVain == [light(1, strength(1)), look(1, colour(red))]-[]) :-
    file_rows(1, "look(1, colour(red)). light(1, strength(1)).", Rows, InVain).
test(by_name, Rows-InVain == [look(1, colour(red))]-[lit]) :-
    file_rows(named, "look(lid, colour(red)). look(lit, colour(blue)).", Rows,
              InVain).
test(by_primitive, Rows-InVain == [look(1, colour(red))]-[]) :-
    file_rows(1, "look(box, colour(red)).", Rows, InVain).
test(by_name_in_a_tree, Rows == [look(5, colour(red))]) :-
    file_rows(node, "look(lid, colour(red)).", Rows, []).
test(replaces, Rows == [light(1, strength(2)), look(1, colour(blue))]) :-
    box(1, Box),
    string_concat(Box, "look(1, colour(red)). light(0, strength(1)).", Model),
    with_model(Model,
               with_file("look(1, colour(blue)). light(1, strength(2)).", File,
                         ( look_file_added(File, []), rows(Rows) ))).
test(file_no_segment, What-Place == look(no_segment(7))-(1:6)) :-
    file_fault("look(7, colour(red)).", What, Place).
test(file_twice, What-Place == look(twice(1, colour))-(2:1)) :-
    file_fault("look(1, colour(red)).\nlook(box, colour(red)).", What, Place).
test(file_named_colour, Place == 1:11) :-
    file_fault("look(box, colour(rde)).",
               value(look, 'Property', _, look(colour)), Place).
test(file_other, What-Place == look(only(segment, 3))-(1:1)) :-
    file_fault("segment(1, solid, box(size(1,1,1))).", What, Place).
test(file_directive, What == directive(halt)) :-
    file_fault(":- halt.", What, _).

% ---- words -------------------------------------------------------------------

test(same_heads, En == Ko) :-
    heads(sg_look_en, en, En),
    heads(sg_look_ko, ko, Ko).

heads(Module, Language, Heads) :-
    findall(Name-What,
            ( member(Name, [look,expected_look,expected_light]),
              atomic_list_concat([Name,Language], '_', Rule),
              functor(Head, Rule, 3),
              clause(Module:Head, _),
              arg(1, Head, What0),
              copy_term(What0, What),
              numbervars(What, 0, _) ),
            Heads).

test(lists_colours, [ forall(colour_name(Name, _)), nondet ]) :-
    phrase(expected_look_en(colour), Parts),
    member(_-[Text], Parts),
    sub_atom(Text, _, _, _, Name).

:- end_tests(look_file).
