/* The hiding step on mesh files, from the direction (1.2, -2.0, 1.1), parallel,
   z up.

       bench/hidden_lines.pl draw MODEL all|feature
       bench/hidden_lines.pl views MODEL all|feature
       bench/hidden_lines.pl scene MODEL MODEL

   draw: triangles, parts, length of the visible ones, then seconds: of the
   processor for the first picture of a world, for the next one (what no eye
   changes is kept), and of the clock for the first. Outlines are edges of
   triangles here, as those of others are.
   views: pictures a second, all of picture/1, by the processor and the clock.
   scene: the steps of a drawing of penetrating models.
*/
:- use_module('../rules/store').
:- use_module('../rules/kernel').
:- use_module('../rules/model/mesh').
:- use_module('../rules/polygon/triangulation').
:- use_module('../rules/penetration/penetration').
:- use_module('../rules/picture/view').
:- use_module('../rules/picture/hidden_lines').

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Mode|Arguments]),
    new_world(World),
    in_world(World, measured(Mode, Arguments)).

measured(draw, [File,Lines]) :-
    loaded([File]),
    seen_from(0),
    project_world,
    seconds(hidden(Lines), First, Wall),
    seconds(hidden(Lines), Again, _),
    aggregate_all(count, t(_,_,_,_,_,_), Triangles),
    aggregate_all(count, drawn(_,_,_,_,_,_,_), Parts),
    aggregate_all(sum(L), visible_length(L), Length),
    format("~d ~d ~3f ~4f ~4f ~4f~n",
           [Triangles, Parts, Length, First, Again, Wall]).
measured(views, [File,Lines]) :-
    loaded([File]),
    picture([lines(Lines)]),
    seconds(forall(between(1, 1000, I),
                   ( seen_from(0.7*I), picture([lines(Lines)]) )),
            Processor, Wall),
    aggregate_all(count, t(_,_,_,_,_,_), Triangles),
    A is 1000/Processor,
    B is 1000/Wall,
    file_base_name(File, Name),
    format("~w~t~16|~w~t~8+~t~D~8+~t~0f~8+~t~0f~8+~n",
           [Name, Lines, Triangles, A, B]).
measured(scene, Files) :-
    step(load, loaded(Files)),
    seen_from(0),
    step(penetrate, penetrate),
    forall(member(Lines, [feature,penetration]),
           ( step(Lines, picture([lines(Lines)])),
             seen_from(10),
             step(again, picture([lines(Lines)])),
             seen_from(0) )).

loaded(Files) :-
    forall(member(File, Files), read_mesh(File, _)),
    complete_segments.

hidden(Lines) :-
    open_scene(drawn(Lines, 30), Scene, [lines(all)]),
    fill_drawn(Scene, Lines, 30, []).

seen_from(Turned) :-
    Theta is atan2(-2.0, 1.2)*180/pi + Turned,
    Phi is acos(1.1/sqrt(1.2**2+2.0**2+1.1**2))*180/pi,
    set_view(Theta, Phi, 9.0).

:- meta_predicate seconds(0, -, -), step(+, 0).

%   Of the processor, of all threads; and of the clock.
seconds(Goal, Processor, Wall) :-
    get_time(T0),
    statistics(process_cputime, C0),
    once(Goal),
    statistics(process_cputime, C1),
    get_time(T1),
    Processor is C1-C0,
    Wall is T1-T0.

step(Name, Goal) :-
    seconds(Goal, Processor, Wall),
    format("~w~t~16|~t~2f~8+~t~2f~8+~n", [Name, Processor, Wall]).

visible_length(Length) :-
    drawn(_, S, E, From, To, visible, _),
    e(S, E, V1, V2, _),
    screen(S, V1, X1, Y1, _),
    screen(S, V2, X2, Y2, _),
    Length is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).
