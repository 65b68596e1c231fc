/* A model file of many joins of parts, loaded and penetrated:

       swipl -p foreign=build bench/joined_parts.pl

   Each join is of two bars that go through each other, and meets its neighbours
   in a row. Processor time of each half and together, and how it grows: with
   n^1 twice as many take twice as long. LARGEST joins at most, 3,200 unless
   told.
*/
:- use_module('../rules/model/model').
:- use_module('../rules/penetration/penetration').
:- use_module('../rules/store').
:- use_module(library(aggregate)).

:- initialization(main, main).

main :-
    (   getenv('LARGEST', Text)
    ->  atom_number(Text, Largest)
    ;   Largest = 3200
    ),
    measured(50, _),                    % what is loaded at the first use
    format("  joins   load s  cut s  growth    lines~n"),
    sizes(100, Largest, none).

sizes(N, Largest, _) :-
    N > Largest,
    !.
sizes(N, Largest, Before) :-
    measured(N, took(Load, Cut, Lines)),
    Sum is Load+Cut,
    (   Before == none
    ->  Growth = ''
    ;   Power is log(Sum/Before)/log(2),
        format(atom(Growth), "n^~2f", [Power])
    ),
    format("~t~D~7| ~t~3f~16| ~t~3f~23| ~t~w~31| ~t~D~40|~n",
           [N,Load,Cut,Growth,Lines]),
    N2 is 2*N,
    sizes(N2, Largest, Sum).

measured(N, Took) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    forall(between(1, N, I), joined(Stream, I)),
    close(Stream),
    new_world(World),
    call_cleanup(in_world(World, cut(File, Took)), delete_file(File)).

joined(Stream, I) :-
    X is I mod 20*0.8,
    Y is I//20 mod 20*0.8,
    Z is I//400*0.8,
    X1 is X+0.3,
    format(Stream,
           "segment(~d, solid, join([at([translate(~w,~w,~w)], \c
            box(size(0.5,0.5,0.5))), at([translate(~w,~w,~w)], \c
            box(size(0.6,0.2,0.2)))])).~n",
           [I,X,Y,Z,X1,Y,Z]).

cut(File, took(Load, Cut, Lines)) :-
    seconds(load_model(File), Load),
    seconds(penetrate, Cut),
    aggregate_all(count, line(_, _, _, _, _, _, _, _, _), Lines).

seconds(Goal, Seconds) :-
    statistics(process_cputime, T0),
    call(Goal),
    statistics(process_cputime, T),
    Seconds is T-T0.
