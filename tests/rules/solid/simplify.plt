:- module(test_simplify, []).
% covers: polygon_whole
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(kernel), [census/1, segments_meeting_themselves/2]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(solid/simplify)).
:- use_module(rules(store)).

/* Fewer triangles: closed stays closed, flat stays flat; what cannot be so few,
   or would go through itself, is said. */

:- multifile user:message_hook/3.

user:message_hook(sanggwan(no_area(_, _, _)), warning, _).
user:message_hook(sanggwan(polygon_edge(_, _, _, _)), warning, _).

file(ball, "segment(1, solid, sphere(radius(10), facets(48))).
segment(2, solid, at([translate(40,0,0)], named(can,
    cylinder(radius(5), height(20), facets(96))))).\n").
file(tree, "segment(1, solid, difference([2,3])).
segment(2, solid, box(size(20,20,20))).
segment(3, solid, cylinder(radius(6), height(40), facets(96))).\n").
file(hollow, "segment(1, solid, difference([2,3])).
segment(2, solid, sphere(radius(10), facets(24))).
segment(3, solid, sphere(radius(9.5), facets(24))).\n").
file(tube, "segment(1, solid, torus(radius(20), tube(5), facets(48))).\n").

file(bow_tie, "segment(1, surface, two).
v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,-0.3,1.4,0). v(1,4,1,1,0). v(1,5,0,0,1).
p(1,1,[1,2,3,4]). p(1,2,[1,5,2]). p(1,3,[2,5,4]). p(1,4,[4,5,3]).\n").
file(even_bow_tie, "segment(1, surface, two).
v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). v(1,4,1,1,0). v(1,5,0,0,1).
p(1,1,[1,2,3,4]). p(1,2,[1,5,2]). p(1,3,[2,5,4]). p(1,4,[4,5,3]).\n").

in(Name, Goal) :-
    file(Name, Text),
    new_world(World),
    setup_call_cleanup(
        tmp_file_stream(File, Stream, [extension(pl)]),
        ( write(Stream, Text), close(Stream) ),
        in_world(World, ( load_model([File]), Goal ))),
    delete_file(File).

:- meta_predicate in(+, 0).

triangles(N) :-
    aggregate_all(count, p(_, _, _), N).

volume(S, Volume) :-
    census(Parts),
    memberchk(part(S, _, _, _, Volume, _, _, _), Parts).

borders(N) :-
    findall(S-(A-B), e(S, _, A, B, _), Edges),
    aggregate_all(count,
                  ( member(S-(A-B), Edges), \+ memberchk(S-(B-A), Edges) ),
                  N).

%   messages(Goal, Terms): what Goal prints of simplify(Term).

:- dynamic heard/1.

messages(Goal, Terms) :-
    retractall(heard(_)),
    setup_call_cleanup(
        asserta((user:message_hook(sanggwan(simplify(Term)), _, _) :-
                     assertz(test_simplify:heard(Term))), Ref),
        Goal,
        erase(Ref)),
    findall(Term, heard(Term), Terms).

:- meta_predicate messages(0, -).

vertices(Vs) :-
    findall(v(S,V,X,Y,Z), v(S, V, X, Y, Z), Vs).

:- begin_tests(simplify).

test(closed, [N, Borders] == [200, 0]) :-
    in(ball, ( simplified_roots(200), triangles(N), borders(Borders) )).
test(near, true(abs(Volume/4188.79 - 1) < 0.06)) :-
    in(ball, ( simplified_roots(400), volume(1, Volume) )).
test(names, Names == [sphere, can]) :-
    in(ball, ( simplified_roots(200),
               findall(Name, segment(_, solid, Name), Names) )).
test(enough, Before == N) :-
    in(ball, ( triangles(Before), messages(simplified_roots(100000), []),
               triangles(N) )).
test(said, Terms == [made(300, Before)]) :-
    in(ball, ( aggregate_all(count, t(_, _, _, _, _, _), Before),
               messages(simplified_roots(300), Terms) )).

% A cube with a hole: its outer faces keep their planes and corners exactly.
test(flat, Corners == 8) :-
    in(tree, ( simplified_roots(60),
               aggregate_all(count,
                             ( v(1, _, X, Y, Z), abs(X) =:= 10.0,
                               abs(Y) =:= 10.0,
                               ( Z =:= 0.0 ; Z =:= 20.0 ) ),
                             Corners) )).
test(root_alone, Ss == [1]) :-
    in(tree, ( simplified_roots(60), findall(S, segment(S, _, _), Ss) )).

% A torus has seven vertices and fourteen triangles at least.
test(not_fewer, [Terms, Borders] = [[made(Left, _), not_fewer(4, Left)], 0]) :-
    in(tube, ( messages(simplified_roots(4), Terms), borders(Borders) )),
    Terms = [made(Left, _)|_],
    Left >= 14.

% The hollow within is nearer than so few triangles can follow.
test(meets, true(memberchk(meets_itself(1, difference), Terms))) :-
    in(hollow, messages(simplified_roots(40), Terms)).
test(meets_no_more, Which-Terms == [] - [made(700, 1056)]) :-
    in(hollow, ( messages(simplified_roots(700), Terms),
                 segments_meeting_themselves([1], Which) )).
test(same, V1 == V2) :-
    in(ball, ( simplified_roots(150), vertices(V1) )),
    in(ball, ( simplified_roots(150), vertices(V2) )).

% A face without triangles is not left out.
test(crosses, [ forall(member(Name, [bow_tie,even_bow_tie])),
                error(geometry_error(mesh(crosses_itself(1, 1)))) ]) :-
    in(Name, messages(simplified_roots(2), _)).

:- end_tests(simplify).
