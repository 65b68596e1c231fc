:- module(test_pattern_want, []).
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(unfolding/unfold), [wanted_of/3]).
:- use_module(rules(unfolding/unfold_true), [true_patterns/4]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).

/* What is written on pieces, and how much of it finds room. */

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

:- end_tests(pattern_want).
