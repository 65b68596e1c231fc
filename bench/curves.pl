/* The table of bench/curves: swipl bench/curves.pl -- RESULTS STAGES...

   RESULTS has a JSON object a line, as peers/boolean/bench.py writes them:
   medians of seconds, `op` with everything, `warm` again in the same process;
   `build`, before, is trueform's trees, and what CGAL makes of a mesh, which is
   not counted, as reading a model into relations is not.
   Each of STAGES is what our driver printed for one case.
*/
:- use_module(library(apply)).
:- use_module(library(http/json)).
:- use_module(library(lists)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [File|StageFiles]),
    setup_call_cleanup(open(File, read, In), records(In, Records0),
                       close(In)),
    maplist(with_trees, Records0, Records),
    format("~w~t~10|~w~t~22|~t~w~32|~t~w~42|~t~w~52|~t~w~62|~t~w~72|~t~w~80|~n",
           [case,peer,'ms','ms warm','ratio','its warm',pieces,chains]),
    maplist(print_record(Records), Records),
    forall(growth(Records, Peer, Key, Exponent),
           format("~w: growth of ~w from sph20k to sph1300k: n^~2f~n",
                  [Peer,Key,Exponent])),
    (   ours(Records, "cyl2r", Turned),
        ours(Records, "cyl2", Straight)
    ->  Ratio is Turned.op/Straight.op,
        format("sanggwan: cyl2 turned to straight: ~2f~n", [Ratio])
    ;   true
    ),
    format("~nour stages with trees built, and the share of the rules~n"),
    maplist(print_stages, StageFiles).

print_stages(File) :-
    setup_call_cleanup(open(File, read, In), json_read_dict(In, Run),
                       close(In)),
    file_name_extension(_, Case, File),
    [Whole|_] = Run.op,
    Stages = Run.stages,
    dict_pairs(Stages, _, Pairs),
    format("~w~t~10|", [Case]),
    forall(member(Stage-Seconds, Pairs),
           ( Ms is Seconds*1000,
             format("~w ~1f  ", [Stage,Ms]) )),
    Share is Stages.rules/Whole*100,
    format("rules ~2f %~n", [Share]).

records(In, Records) :-
    (   at_end_of_stream(In)
    ->  Records = []
    ;   json_read_dict(In, Record, [end_of_file(end)]),
        (   Record == end
        ->  Records = []
        ;   Records = [Record|Records1],
            records(In, Records1)
        )
    ).

with_trees(R0, R) :-
    (   R0.peer == "trueform",
        number(R0.op)
    ->  Op is R0.op+R0.build,
        R = R0.put(op, Op)
    ;   R = R0
    ).

ours(Records, Case, Record) :-
    member(Record, Records),
    Record.case == Case,
    Record.peer == "sanggwan",
    number(Record.op),
    !.

%   The ratio is ours to the peer's: in `ratio` with trees built, in `its warm`
%   ours with trees kept to what the peer takes in the same process.

print_record(Records, R) :-
    (   number(R.op)
    ->  ms(R.op, Op),
        ms(R.warm, Warm),
        ratio(Records, R, op, Ratio),
        ratio(Records, R, warm, WarmRatio),
        format("~w~t~10|~w~t~22|~t~w~32|~t~w~42|~t~w~52|~t~w~62|~t~w~72|\c
                ~t~w~80|~n",
               [R.case,R.peer,Op,Warm,Ratio,WarmRatio,R.segs,R.lines])
    ;   format("~w~t~10|~w~t~22|~w~n", [R.case,R.peer,R.fail])
    ).

ms(Seconds, Text) :-
    (   number(Seconds)
    ->  Ms is Seconds*1000,
        format(atom(Text), "~1f", [Ms])
    ;   Text = '-'
    ).

ratio(Records, R, Key, Text) :-
    (   R.peer \== "sanggwan",
        ours(Records, R.case, Ours),
        number(R.get(Key)),
        number(Ours.get(Key))
    ->  Ratio is Ours.get(Key)/R.get(Key),
        format(atom(Text), "~3f", [Ratio])
    ;   Text = ''
    ).

%   Triangles grow by 64 from sph20k to sph1300k.

growth(Records, Peer, Key, Exponent) :-
    member(Small, Records),
    Small.case == "sph20k",
    Peer = Small.peer,
    member(Large, Records),
    Large.case == "sph1300k",
    Large.peer == Peer,
    member(Key, [op, warm]),
    number(Small.get(Key)),
    number(Large.get(Key)),
    Exponent is log(Large.get(Key)/Small.get(Key))/log(64).
