:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(kernel), [scene_edge/5, occluder/7]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(store)).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/picture/picture_checked')).
:- use_module(tests('rules/picture/picture_scene')).
:- use_module(tests('rules/sample')).

/* Pictures of random scenes against the independent checker: what is visible
and what is hidden, and that nothing is drawn twice.

    PICTURE_CASES=N         N times as many scenes
    PICTURE_MESHES=all      all meshes of ../shared/data/meshes, not a few
*/

% Polygons of suzanne are not flat, and scenes in single digits are made to
% touch by a tolerance that rounding does not explain: silent here.
:- multifile user:message_hook/3.
user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).
user:message_hook(sanggwan(tight(_, _, _, _, _, _)), warning, _).

:- begin_tests(picture_exact).

test(right, [forall(scene_class(Class, N0)), true(Faults == [])]) :-
    times(Times),
    few(N0//3, N0, N1),
    N is N1*Times,
    class_faults(Class, N, Faults).

scene_class(grid_boxes,   25).
scene_class(grid_solids,  25).
scene_class(grid_sheets,  25).
scene_class(grid_triangles, 25).
scene_class(grid_mixed,   25).
scene_class(grid_shells,  25).
scene_class(grid_bad,     40).
scene_class(grid_united,  20).
scene_class(solids,       10).
scene_class(united,       10).
scene_class(mixed,        10).
scene_class(shells,       12).

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

% Nothing is hidden by what it lies on, wherever rounding puts it: also where
% scenes are turned. All kinds of scenes have lines in faces of others.

test(lies_on, true(Hidden == [])) :-
    findall(Class-Seed-Bad,
            ( member(Class, [grid_solids,grid_triangles,grid_united,solids]),
              between(1, 12, Seed),
              hidden_by_own(Class, Seed, Bad) ),
            Hidden).

hidden_by_own(Class, Seed, Bad) :-
    set_random(seed(Seed)),
    random_turn(Turn),
    new_world(World),
    in_world(World,
             ( turned(Turn, all, random_scene(Class)),
               cut_all([]),
               random_view(solids, View),
               looked_from(View),
               project_world,
               open_scene(Scene, []),
               findall(S-E-S2-P,
                       ( scene_edge(Scene, S, E, _, _),
                         occluder(Scene, S, E, S2, T, _, _),
                         t(S2, P, T, _, _, _),
                         once(lies_on(S, E, S2, P)) ),
                       Bad) )),
    Bad \== [].

% Nothing is drawn twice, whatever lines are asked for: edges, and outlines
% inside triangles.

test(once, true(Twice == [])) :-
    times(Times),
    few(3, 8, N1),
    N is N1*Times,
    open_pictures(Pictures),
    forall(( member(Class, [grid_solids,grid_shells,grid_mixed,solids,round]),
             between(1, N, Seed) ),
           ( set_random(seed(Seed)),
             random_view(Class, View),
             atomic_list_concat([Class,Seed], '_', Name),
             new_world(World),
             in_world(World,
                      ( random_scene(Class),
                        cut_all([]),
                        looked_from(View),
                        picture,
                        add_drawing(Pictures, Name) )) )),
    check_pictures(Pictures, Results),
    findall(Name-Length,
            ( member(Result, Results),
              Name = Result.name,
              Length = Result.twice,
              Length > 1.0e-5*Result.size ),
            Twice).

% Meshes of others, some of which go through themselves.

test(meshes, true(Faults == [])) :-
    findall(File, mesh_file(File), Files),
    (   Files == []
    ->  format("skipped: no meshes in ../shared/data/meshes~n")
    ;   true
    ),
    open_pictures(Pictures),
    forall(( member(File, Files), mesh_view(View) ),
           ( file_base_name(File, Name),
             add_picture(Pictures, Name, View, load_model([File])) )),
    check_pictures(Pictures, Results),
    findall(Name-Fault,
            ( member(Result, Results),
              bad_picture(Result, Fault),
              Name = Result.name ),
            Faults).

mesh_view(angles(301.0,64.0)).
mesh_view(angles(40.0,110.0)).

mesh_file(File) :-
    expand_file_name('../shared/data/meshes/*', Files),
    member(File, Files),
    file_base_name(File, Name),
    (   getenv('PICTURE_MESHES', all)
    ->  true
    ;   memberchk(Name, ['openscad-nonmanifold.stl','thingi10k-65004.stl',
                          'suzanne.obj'])
    ).

% The same scenes turned by any rotation, and the view with them: what is drawn
% is as long as the checker says of the scene that was not turned. Curves have
% no tolerance, and nothing is made to touch inside a segment, so neither is
% among these.

test(turned, [forall(turned_class(Class, Digits, N0)), true(Faults == [])]) :-
    times(Times),
    few(N0//3, N0, N1),
    N is N1*Times,
    open_pictures(Pictures),
    findall(Name-Lengths,
            ( between(1, N, Seed),
              atomic_list_concat([Class,Digits,Seed], '_', Name),
              turned_lengths(Pictures, Class, Seed, Digits, Name, Lengths) ),
            Drawn),
    check_pictures(Pictures, Results),
    findall(Name-(Visible/Hidden)-Lengths,
            ( member(Result, Results),
              Name = Result.name,
              memberchk(Name-Lengths, Drawn),
              Visible = Result.visible,
              Hidden = Result.hidden,
              \+ as_long(Visible, Hidden, Lengths) ),
            Faults).

turned_class(grid_boxes,  all,    12).
turned_class(grid_solids, all,    12).
turned_class(grid_triangles, all, 12).
turned_class(grid_united, all,    8).
turned_class(grid_boxes,  single, 12).
turned_class(grid_solids, single, 12).

turned_lengths(Pictures, Class, Seed, Digits, Name, Lengths) :-
    set_random(seed(Seed)),
    random_turn(Turn),
    direction(Direction),
    Direction = p(X,Y,Z),
    add_picture(Pictures, Name, direction(X,Y,Z), seeded_scene(Class, Seed)),
    new_world(World),
    in_world(World,
             ( turned(Turn, Digits, seeded_scene(Class, Seed)),
               touching(Digits, Tolerance),
               cut_all([tolerance(Tolerance)]),
               turned_point(Turn, Direction, p(X1,Y1,Z1)),
               set_direction(X1, Y1, Z1),
               picture([lines(all)]),
               drawn_lengths(Visible, Hidden) )),
    Lengths = Visible/Hidden.

seeded_scene(Class, Seed) :-
    set_random(seed(Seed)),
    random_scene(Class).

direction(p(X,Y,Z)) :-
    repeat,
    maplist(random_between(-2, 2), [X,Y,Z]),
    [X,Y,Z] \== [0,0,0],
    !.

%   What is made to touch in scenes of a size of 3.

touching(all, 1.0e-9).
touching(single, 1.0e-6).

as_long(Visible, Hidden, Visible1/Hidden1) :-
    abs(Visible-Visible1) < 1.0e-4,
    abs(Hidden-Hidden1) < 1.0e-4.

:- end_tests(picture_exact).
