:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(tests('rules/picture_checked')).
:- use_module(tests('rules/picture_scene')).

/* Pictures of random scenes against the independent checker: what is visible
and what is hidden, and that nothing is drawn twice.

    PICTURE_CASES=N         N times as many scenes
    PICTURE_FOUND=FOLDER    keeps the scenes that fail, for the checker
*/

:- begin_tests(picture_exact).

test(right, [forall(scene_class(Class, N0)), true(Faults == [])]) :-
    times(Times),
    N is N0*Times,
    class_faults(Class, N, Faults).

scene_class(grid_boxes,   40).
scene_class(grid_solids,  40).
scene_class(grid_sheets,  40).
scene_class(grid_mixed,   40).
scene_class(grid_shells,  40).
scene_class(grid_united,  30).
scene_class(solids,       15).
scene_class(united,       15).
scene_class(mixed,        15).
scene_class(shells,       20).

times(Times) :-
    (   getenv('PICTURE_CASES', Text),
        atom_number(Text, Times)
    ->  true
    ;   Times = 1
    ).

class_faults(Class, N, Faults) :-
    open_pictures(Pictures),
    findall(failed(Name),
            ( between(1, N, Seed),
              atomic_list_concat([Class,Seed], '_', Name),
              \+ add_scene(Pictures, Class, Seed, Name) ),
            Failed),
    check_pictures(Pictures, Results),
    findall(Name-Fault,
            ( member(Result, Results),
              bad_picture(Result, Fault),
              Name = Result.name ),
            Bad),
    append(Failed, Bad, Faults).

add_scene(Pictures, Class, Seed, Name) :-
    set_random(seed(Seed)),
    random_view(Class, View),
    catch(add_picture(Pictures, Name, View, random_scene(Class)), E,
          ( print_message(error, E), fail )).

:- end_tests(picture_exact).
