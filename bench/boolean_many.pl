/* Many operands:

       swipl -p foreign=build bench/boolean_many.pl -- many|apart|tree|instance

   many: SPHERES (700) on a jittered grid, each meeting some others, in one
   call; apart: farther from each other, so that none meets another. If OPERANDS
   names a folder each is written there, N.off, for peers.
   tree: 1,000 primitives, each meeting at most 10 others, in one expression;
   the first evaluation, then each leaf moved in turn and the tree evaluated
   again. MOVES of the leaves (all unless told) are moved. By the clock, and in
   processor time of all threads, which a busy machine changes less; and how
   much memory all of it took, undo steps included.
   instance: a sphere of 300,000 triangles once more, turned.
*/
:- use_module('../rules/solid/boolean').
:- use_module('../rules/solid/csg_evaluate').
:- use_module('../rules/primitive/primitive_rows').
:- use_module('../rules/stage').
:- use_module('../rules/store').
:- use_module('../rules/polygon/triangulation').
:- use_module(rows_off).
:- use_module('../tests/rules/checked').
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(random)).
:- use_module(library(readutil)).

:- initialization(main, main).

main :-
    set_random(seed(1)),
    current_prolog_flag(argv, [Part]),
    new_world(World),
    in_world(World, call(Part)).

timed(Goal, Seconds) :-
    timed(Goal, Seconds, _).

timed(Goal, Seconds, Processor) :-
    get_time(T0),
    statistics(process_cputime, C0),
    call(Goal),
    statistics(process_cputime, C),
    get_time(T),
    Seconds is T-T0,
    Processor is C-C0.

/* - - - spheres - - - */

many :-
    spheres(meeting, 1.0).

apart :-
    spheres(apart, 1.5).

spheres(How, Pitch) :-
    (   getenv('SPHERES', Many)
    ->  atom_number(Many, N)
    ;   N = 700
    ),
    forall(( between(1, N, S), I is S-1 ), add_sphere(I, Pitch)),
    complete_segments,
    aggregate_all(count, t(_, _, _, _, _, _), Triangles),
    numlist(1, N, Leaves),
    Union is N+1,
    operands_written(Leaves),
    stages_reset,
    timed(boolean(union(Leaves), Union), _, Seconds),
    said(Union, Text),
    format("~d spheres ~w, ~d triangles, in ~3f s of the processor: ~w~n",
           [N,How,Triangles,Seconds,Text]),
    forall(stage_seconds(Name, Part),
           format("  ~w ~3f s~n", [Name,Part])).

operands_written(Leaves) :-
    (   getenv('OPERANDS', Folder)
    ->  forall(member(S, Leaves),
               ( format(atom(File), '~w/~d.off', [Folder,S]),
                 write_rows_off(S, File) ))
    ;   true
    ).

%   10 x 10 x 7 places, Pitch apart; radius 0.6, so that neighbours meet at 1.

add_sphere(I, Pitch) :-
    X0 is I mod 10, Y0 is I//10 mod 10, Z0 is I//100,
    maplist(jittered(Pitch), [X0,Y0,Z0], [X,Y,Z]),
    random(R),
    Degrees is 90*R,
    add_primitive(at([rotate(axis(1,2,3),Degrees),translate(X,Y,Z)],
                     sphere(radius(0.6), facets(24), bands(12))), _).

jittered(Pitch, X0, X) :-
    random(R),
    X is Pitch*X0+0.1*R.

said(S, Text) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Stream, [extension(off)]), close(Stream) ),
        ( write_rows_off(S, File), checked([File], [R]) ),
        delete_file(File)),
    format(atom(Text), "~d triangles, good=~w, volume ~6f",
           [R.triangles,R.good,R.volume]).

/* - - - an instance - - - */

instance :-
    add_primitive(sphere(radius(1), facets(550), bands(276)), _),
    complete_segments,
    Steps = [rotate(axis(1,2,3),40),translate(3,0,0)],
    assert_fact(segment(2, solid, at(Steps, 1))),
    timed(evaluate(2), Seconds),
    aggregate_all(count, t(2, _, _, _, _, _), Triangles),
    format("an instance of ~D triangles: ~3f s~n", [Triangles,Seconds]).

/* - - - a tree of 1,000 - - - */

%   Solids of some kinds at 10 x 10 x 10 places 1 apart, no wider than 1.4:
%   each meets at most its 6 neighbours and some on the diagonal. Every third is
%   taken away from the union of the others.

tree :-
    forall(between(0, 999, I), ( leaf(I, 0, Leaf), add_primitive(Leaf, _) )),
    findall(S, ( between(1, 1000, S), S mod 3 =\= 0 ), Added),
    findall(S, ( between(1, 1000, S), S mod 3 =:= 0 ), Removed),
    assert_fact(segment(1001, solid, difference([union(Added)|Removed]))),
    complete_segments,
    timed(evaluate(1001), First, FirstProcessor),
    said(1001, Text),
    format("1,000 primitives: first evaluation ~3f s: ~w~n", [First,Text]),
    stages_reset,
    moves(Leaves),
    resident(Before),
    maplist(moved_seconds, Leaves, Seconds, Processor),
    say_parts("by the clock", Leaves, Seconds, First),
    say_parts("in processor time", Leaves, Processor, FirstProcessor),
    length(Leaves, N),
    resident(After),
    Evaluations is 2*N,
    format("memory ~0f MB before, ~0f MB after ~d evaluations~n",
           [Before,After,Evaluations]),
    forall(stage_seconds(Name, Part),
           ( Ms is Part/N/2*1000, format("  ~w ~1f ms~n", [Name,Ms]) )).

%   resident(Megabytes): what the process takes of the machine's memory.

resident(Megabytes) :-
    setup_call_cleanup(open('/proc/self/statm', read, Stream),
                       read_line_to_string(Stream, Line),
                       close(Stream)),
    split_string(Line, " ", "", [_,Pages|_]),
    number_string(N, Pages),
    Megabytes is N*4096/1.0e6.

say_parts(How, Leaves, Seconds, First) :-
    sum_list(Seconds, Sum),
    length(Seconds, N),
    pairs_keys_values(Pairs, Seconds, Leaves),
    max_member(Worst-WorstLeaf, Pairs),
    Mean is Sum/N/First*100,
    WorstPart is Worst/First*100,
    format("one leaf moved, ~w, mean of ~d: ~2f % of the first; \c
            the worst ~2f % (leaf ~d)~n",
           [How,N,Mean,WorstPart,WorstLeaf]).

moves(Leaves) :-
    (   getenv('MOVES', Text)
    ->  atom_number(Text, N)
    ;   N = 1000
    ),
    Step is max(1, 1000//N),
    findall(S, ( between(1, 1000, S), S mod Step =:= 0 ), Leaves).

%   leaf(I, By, Leaf): the term of leaf I, moved along x.

leaf(I, By, at([rotate(axis(1,2,3),I),translate(X,Y,Z)], Primitive)) :-
    X is I mod 10+By, Y is I//10 mod 10, Z is I//100,
    Kind is I mod 4,
    nth0(Kind,
         [ box(size(0.75,0.75,0.75)),
           cylinder(radius(0.4), height(0.9), facets(16)),
           sphere(radius(0.6), facets(12), bands(6)),
           cone(radius(0.5), height(1), facets(12)) ],
         Primitive).

%   moved_seconds(S, Seconds, Processor): leaf S moved a little, and the tree
%   evaluated.

moved_seconds(S, Seconds, Processor) :-
    I is S-1,
    leaf(I, 0, Old),
    leaf(I, 0.03125, New),
    replaced(S, Old, New),
    timed(evaluate(1001), Seconds, Processor),
    replaced(S, New, Old),
    evaluate(1001).

replaced(S, Old, New) :-
    retract_fact(segment(S, solid, Old)),
    !,
    assert_fact(segment(S, solid, New)).
