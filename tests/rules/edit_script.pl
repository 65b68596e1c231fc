:- module(sg_test_edit_script,
          [ script/3                    % +Threads, +Seed, -Wrong
          ]).
/** <module> Random edits of random worlds, and random questions about them.

A script makes a world (edit_world.pl), edits it (edit_change.pl) and asks about
it (edit_question.pl). It is run for what must not happen: the end of the
process, work without end, an error of the rules themselves, a world that is not
whole.

edit_fuzz.plt runs scripts in processes of their own.
*/

:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(thread)).
:- use_module(rules(sanggwan)).
:- use_module(tests('rules/edit_change')).
:- use_module(tests('rules/edit_question')).
:- use_module(tests('rules/edit_world')).
:- use_module(tests('rules/soup')).
:- use_module(tests('rules/whole_world')).

%!  script(+Threads:integer, +Seed:integer, -Wrong:list) is det.
%
%   Wrong is the list of what was wrong in the script of this Seed. Each of two
%   Threads or more runs a script in the same world, at the same time.

script(1, Seed, Wrong) :-
    !,
    soup(Seed, Soup), % seeds the random numbers
    new_world(World),
    in_world(World, scene(Soup, Wrong)).
script(Threads, Seed, Wrong) :-
    soup(Seed, Soup),
    new_world(World),
    findall(sg_test_edit_script:quiet_scene(World, Soup, Own, _),
            ( between(1, Threads, I),
              Own is 1000*Seed+I ),
            Goals),
    concurrent(Threads, Goals, []),
    findall(W,
            ( member(_:quiet_scene(_, _, _, Ws), Goals),
              member(W, Ws),
              W \= dangles(_, _) ),
            Wrong1),
    in_world(World, findall(dangles(Row, Missing), dangling(Row, Missing),
                            Wrong2)),
    append(Wrong1, Wrong2, Wrong).

%   quiet_scene(World, Soup, Seed, Wrong): what a thread does. Random numbers
%   are a thread's own, so it has a seed of its own, and the same script each
%   time; what the others do meanwhile may differ.

quiet_scene(World, Soup, Seed, Wrong) :-
    set_random(seed(Seed)),
    setup_call_cleanup(
        ( open_null_stream(Null),
          set_output(Null) ),
        in_world(World, scene(Soup, Wrong)),
        close(Null)).

scene(Soup, Wrong) :-
    forget_answers,
    random_between(1, 3, N),
    findall(x, ( between(1, N, _), made(Soup) ), _),
    random_between(1, 4, M),
    findall(W,
            ( between(1, M, _),
              round(Ws),
              member(W, Ws) ),
            Wrong).

%   round(Wrong): some edits, then some questions.

round(Wrong) :-
    random_between(1, 3, N),
    findall(W, ( between(1, N, _), change(Ws), member(W, Ws) ), Wrong1),
    random_between(0, 3, M),
    findall(W, ( between(1, M, _), question(Ws), member(W, Ws) ), Wrong2),
    findall(dangles(Row, Missing), dangling(Row, Missing), Wrong3),
    append([Wrong1, Wrong2, Wrong3], Wrong).
