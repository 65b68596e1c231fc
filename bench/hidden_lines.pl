/* The hidden-line step on mesh files.

       bench/hidden_lines [MODEL.obj...]

   Seconds, the best of three: search structures (scene), the fused kernel, the
   rules; then parts and lengths in the picture, to compare with others: the
   direction is (1.2, -2.0, 1.1), parallel, z up.
*/
:- use_module('../rules/store').
:- use_module('../rules/kernel').
:- use_module('../rules/mesh').
:- use_module('../rules/triangulation').
:- use_module('../rules/view').
:- use_module('../rules/hidden_lines').

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Files),
    format("~w~t~24|~t~w~32|~t~w~40|~t~w~50|~t~w~60|~t~w~70|~t~w~80|~t~w~90|~n",
           [model, parts, visible, scene, kernel, rules, 'len seen', hidden]),
    forall(( member(File, Files), member(Lines, [all,feature]) ),
           ( new_world(World), in_world(World, measured(File, Lines)) )).

measured(File, Lines) :-
    read_mesh(File, _),
    complete_segments,
    Theta is atan2(-2.0, 1.2)*180/pi,
    Phi is acos(1.1/sqrt(1.2**2+2.0**2+1.1**2))*180/pi,
    set_view(Theta, Phi, 9.0),
    project_world,
    best(open_scene(Scene, []), SceneTime),
    best(fill_drawn(Scene, Lines, 30, []), KernelTime),
    lengths(Visible, Hidden),
    aggregate_all(count, drawn(_,_,_,_,_,_,_), Parts),
    aggregate_all(count, drawn(_,_,_,_,_,visible,_), Seen),
    best(picture([lines(Lines),method(rule)]), RuleTime),
    file_base_name(File, Name),
    format("~w~t~24|~t~D~32|~t~D~40|~t~3f~50|~t~3f~60|~t~3f~70|~t~3f~80|\c
            ~t~3f~90|~n",
           [Name, Parts, Seen, SceneTime, KernelTime, RuleTime, Visible,
            Hidden]).

:- meta_predicate best(0, -).

best(Goal, Seconds) :-
    findall(T,
            (   between(1, 3, _),
                get_time(T0),
                once(Goal),
                get_time(T1),
                T is T1-T0
            ),
            Times),
    min_list(Times, Seconds),
    once(Goal).

lengths(Visible, Hidden) :-
    findall(Visibility-L, part_length(Visibility, L), Pairs),
    aggregate_all(sum(L), member(visible-L, Pairs), Visible),
    aggregate_all(sum(L), member(hidden-L, Pairs), Hidden).

part_length(Visibility, Length) :-
    drawn(_, S, E, From, To, Visibility, _),
    e(S, E, V1, V2, _),
    screen(S, V1, X1, Y1, _),
    screen(S, V2, X2, Y2, _),
    Length is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).
