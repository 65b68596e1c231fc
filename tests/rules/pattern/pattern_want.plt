:- module(test_pattern_want, []).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(command/cli)).
:- use_module(rules(store)).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(unfolding/unfold), [wanted_of/3]).
:- use_module(rules(unfolding/unfold_true), [true_patterns/4]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).

/* What is written on pieces, and how much of it finds room.
   covers: true_elbow */

:- dynamic left_out/2.

%   left_out(Term, Options, N): so many partner numbers have no room.

left_out(Term, Options, N) :-
    new_world(World),
    retractall(left_out(_, _)),
    setup_call_cleanup(
        asserta((user:message_hook(sanggwan(pattern(What)), _, _) :-
                     (   What = no_room(Role, Count)
                     ->  assertz(test_pattern_want:left_out(Role, Count))
                     ;   true
                     )), Ref),
        in_world(World, ( add_primitive(Term, S), develop(S, D),
                          pattern_drawing([D], Options, _) )),
        erase(Ref)),
    (   left_out(number, N)
    ->  true
    ;   N = 0
    ).

:- begin_tests(pattern_want).

% Short seams choose first, and letters may be 1.3 mm; it were 60 before.
test(ball, true(N =< 30)) :-
    left_out(sphere(radius(30), facets(24)), [tabs(5),page('A4')], N).
test(large, N == 0) :-
    left_out(sphere(radius(60), facets(12)), [tabs(5),page('A3')], N).
test(tiny, true(N >= 20)) :-
    left_out(sphere(radius(5), facets(12)), [], N).
% At 1:1 each piece of an elbow says where it is: at quarter turns, the throat
% and the heel.
test(quarters, Texts == Wanted) :-
    new_world(World),
    in_world(World,
             ( add_primitive(named(bend, elbow(diameter(114.3), radius(171),
                                               pieces(2), facets(24))), S),
               complete_segments,
               wanted_of(S, [wish(removed([base,top]), fact)], W),
               true_patterns(S, W, [generators(8)], Ds),
               pattern_drawing(Ds, [table(false)], Drawings) )),
    findall(Text,
            ( member(drawing(_,Views), Drawings),
              member(view(_,_,Words), Views),
              member(word(generator_number,_,_,text(_,_,_,_,Text),_), Words),
              sub_string(Text, _, 1, _, "\u00B0") ),
            Texts0),
    msort(Texts0, Texts),
    Wanted = ["0\u00B0 throat","0\u00B0 throat","180\u00B0 heel",
              "180\u00B0 heel","270\u00B0","270\u00B0","90\u00B0",
              "90\u00B0"].

% So do pipes that planes split, whatever generator it is: with and without
% trimming, in plate, 9 degrees from a quarter. A pipe that is cut alone, pipes
% that end on a saddle, and a pipe between two parallel planes have neither.
test(throat_and_heel, [ forall(elbow(Name, Model, Arguments, Wanted)),
                        true(Name-Said == Name-Wanted) ]) :-
    tmp_file_stream(File, Out, [extension(pl)]),
    write(Out, Model),
    close(Out),
    tmp_file(drawing, Base),
    atom_concat(Base, '.dxf', Dxf),
    append([unfold,File,'--true','--no-lengths','-q','-o',Dxf], Arguments,
           All),
    with_output_to(string(_), sanggwan(All, 0)),
    read_file_to_string(Dxf, Text, []),
    split_string(Text, "\n", "\r", Lines),
    findall(Line,
            ( member(Line, Lines),
              ( sub_string(Line, _, _, 0, "throat")
              ; sub_string(Line, _, _, 0, "heel") ) ),
            Said0),
    msort(Said0, Said).

:- end_tests(pattern_want).

pipes("segment(1, solid, split(at([translate(0,0,-200)],
                         cylinder(radius(50), height(400), facets(40))),
                         plane(-1,0,1,0), below)).
segment(2, solid, split(at([rotate(y,90), translate(-200,0,0)],
                         cylinder(radius(50), height(400), facets(40))),
                         plane(-1,0,1,0), above)).\n").

elbow(trimmed, Pipes, ['--trim',outside], Wanted) :-
    pipes(Pipes),
    two_pieces(Wanted).
elbow(plate, Pipes, ['--trim',outside,'--thickness','4'], Wanted) :-
    pipes(Pipes),
    two_pieces(Wanted).
elbow(united, Model, [], Wanted) :-
    pipes(Pipes),
    string_concat(Pipes, "segment(3, solid, union([1,2])).\n", Model),
    two_pieces(Wanted).
elbow(turned,
      "segment(1, solid, split(at([translate(0,0,-200), rotate(z,9)],
                         cylinder(radius(50), height(400), facets(40))),
                         plane(-1,0,1,0), below)).
segment(2, solid, split(at([rotate(y,90), translate(-200,0,0)],
                         cylinder(radius(50), height(400), facets(40))),
                         plane(-1,0,1,0), above)).\n",
      ['--trim',outside],
      ["0\\U+00B0 throat","180\\U+00B0 heel","heel","throat"]).
elbow(alone,
      "segment(1, solid, split(at([translate(0,0,-200)],
                         cylinder(radius(50), height(400), facets(40))),
                         plane(-1,0,1,0), below)).\n", [], []).
elbow(tee,
      "segment(1, solid, at([rotate(y,90), translate(-200,0,0)],
                         cylinder(radius(50), height(400), facets(40)))).
segment(2, solid, cylinder(radius(50), height(200), facets(40))).\n",
      ['--trim',outside], []).
elbow(offset,
      "segment(1, solid, mitred_pipe(diameter(60), facets(24),
                         through([[0,0,0],[0,0,100],[100,0,200],
                                  [100,0,300]]))).\n",
      ['--remove','base,top'],
      Wanted) :-
    Wanted = ["0\\U+00B0 heel","0\\U+00B0 throat","180\\U+00B0 heel",
              "180\\U+00B0 throat"].

two_pieces(["0\\U+00B0 heel","0\\U+00B0 throat","180\\U+00B0 heel",
            "180\\U+00B0 throat"]).
