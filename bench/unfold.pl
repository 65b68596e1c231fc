/* Developments, for bench/unfold.

       bench/unfold.pl models FOLDER [MODEL...]
       bench/unfold.pl kernel MODEL.obj
       bench/unfold.pl rule MODEL.obj

   models: writes the models as triangles into FOLDER and prints their names.
   kernel, rule: reads MODEL and unfolds it, by the fused kernel, or with a rule
   file that replaces a decision and says what the default says. Prints
   triangles, microseconds a triangle of the processor, percent of the clock in
   Prolog (not in calls of kernels), all with no fold exchanged; then, of the
   pattern as it is by default, pieces, length of the seam, the bound of it, 0
   where none is proven, and microseconds a triangle.
*/
:- use_module('../rules/sanggwan').
:- use_module('../rules/solid/boolean').
:- use_module('../rules/development/development').
:- use_module('../rules/development/development_record').
:- use_module('../rules/kernel').
:- use_module('../rules/model/mesh').
:- use_module('../rules/primitive/primitive_rows').
:- use_module('../rules/stage').
:- use_module('../rules/store').
:- use_module('../rules/polygon/triangulation').

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Mode,Argument|Wanted]),
    new_world(World),
    in_world(World, done(Mode, Argument, Wanted)).

done(models, Folder, Wanted) :-
    forall(( model(Name, Terms),
             ( Wanted == [] -> true ; memberchk(Name, Wanted) ),
             is_there(Terms) ),
           ( model_written(Folder, Name, Terms),
             format("~w~n", [Name]) )).
done(kernel, File, _) :-
    measured(File).
done(rule, File, _) :-
    tmp_file_stream(Rules, Out, [extension(pl)]),
    format(Out, "may_join(S, E) :- default(may_join(S, E)).~n", []),
    close(Out),
    use_rules(Rules),
    measured(File).

%   model(Name, Terms): a primitive, or two that are united, or a mesh of
%   ../shared/data.

model(sphere_1k,    [sphere(radius(1), facets(32), bands(18))]).
model(sphere_5k,    [sphere(radius(1), facets(72), bands(36))]).
model(sphere_20k,   [sphere(radius(1), facets(142), bands(72))]).
model(sphere_300k,  [sphere(radius(1), facets(550), bands(274))]).
model(torus_1k,     [torus(radius(1), tube(0.4), facets(24), sides(24))]).
model(torus_20k,    [torus(radius(1), tube(0.4), facets(100), sides(100))]).
model(torus_300k,   [torus(radius(1), tube(0.4), facets(400), sides(375))]).
model(cylinders,    [ cylinder(radius(1), height(4), facets(40)),
                      at([translate(0,0,-2),rotate(y,90),translate(0,0,2)],
                         cylinder(radius(0.8), height(4), facets(40))) ]).
model(suzanne,      mesh(suzanne)).
model(cow,          mesh(cow)).
model(teapot,       mesh(teapot)).
model(beetle,       mesh(beetle)).
model(union_5k,     Terms) :- two_spheres(36, Terms).
model(union_20k,    Terms) :- two_spheres(72, Terms).
model(union_100k,   Terms) :- two_spheres(172, Terms).
model(union_300k,   Terms) :- two_spheres(300, Terms).
model(cone_5k,      [cone(radius(1), height(2), facets(2500))]).
model(cone_20k,     [cone(radius(1), height(2), facets(10000))]).

two_spheres(N, [ sphere(radius(1), facets(N), bands(N)),
                 at([translate(0.9,0.5,0.3)],
                    sphere(radius(0.8), facets(N), bands(N))) ]).

model_written(Folder, Name, Terms) :-
    format(atom(File), '~w/~w.obj', [Folder,Name]),
    (   exists_file(File)
    ->  true
    ;   new_world(World),
        in_world(World, ( made(Terms, S), triangles_written(S, File) ))
    ).

is_there(Terms) :-
    (   Terms = mesh(Name)
    ->  mesh_file(Name, File),
        exists_file(File)
    ;   true
    ).

mesh_file(Name, File) :-
    format(atom(File), '../shared/data/meshes/~w.obj', [Name]).

made(mesh(Name), S) :-
    !,
    mesh_file(Name, File),
    read_mesh(File, [S|_]),
    complete_segments.
made(Terms, S) :-
    forall(member(Term, Terms), add_primitive(Term, _)),
    complete_segments,
    (   Terms = [_]
    ->  S = 1
    ;   S = 3,
        boolean(union([1,2]), S),
        complete_segments
    ).

triangles_written(S, File) :-
    findall(V, v(S, V, _, _, _), Vs),
    length(Vs, N),
    numlist(1, N, Is),
    pairs_keys_values(Pairs, Vs, Is),
    list_to_assoc(Pairs, Number),
    setup_call_cleanup(
        open(File, write, Out),
        ( forall(member(V, Vs),
                 ( v(S, V, X, Y, Z), format(Out, "v ~w ~w ~w~n", [X,Y,Z]) )),
          forall(t(S, _, _, A, B, C),
                 ( maplist(numbered(Number), [A,B,C], Corners),
                   format(Out, "f ~d ~d ~d~n", Corners) )) ),
        close(Out)).

numbered(Number, V, I) :-
    get_assoc(V, Number, I).

measured(File) :-
    warmed,
    read_mesh(File, [S|_]),
    complete_segments,
    aggregate_all(count, t(S, _, _, _, _, _), N),
    garbage_collect,
    stages_reset,
    statistics(process_cputime, C0),
    get_time(T0),
    develop(S, [effort(0)], _),
    get_time(T1),
    statistics(process_cputime, C1),
    Each is (C1-C0)*1.0e6/N,
    kernel_seconds(Kernel),
    Share is 100*(1-min(1, Kernel/(T1-T0))),
    statistics(process_cputime, C2),
    develop(S, [], D),
    statistics(process_cputime, C3),
    Searched is (C3-C2)*1.0e6/N,
    development_measures(D, Measures),
    _{pieces:Pieces, seam:Seam, bound:Bound0} :< Measures,
    (   Bound0 == null
    ->  Bound = 0
    ;   Bound = Bound0
    ),
    format("~d ~3f ~2f ~d ~2f ~2f ~3f~n",
           [N,Each,Share,Pieces,Seam,Bound,Searched]).

%   warmed: what is loaded when it is first called is loaded.

warmed :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(1,1,1)), S),
               complete_segments,
               develop(S, [], _) )).

%   kernel_seconds(Seconds): of the clock, in calls of kernels.

kernel_seconds(Seconds) :-
    aggregate_all(sum(S),
                  ( member(Stage, [join,write,tree]),
                    stage_seconds(Stage, S) ),
                  Seconds).
