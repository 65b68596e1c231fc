/* The tables of bench/booleans:

       swipl bench/booleans.pl -- speed|degenerate RESULTS

   RESULTS has a JSON object a line, as peers/boolean/bench.py writes them.
*/
:- use_module(degenerate, [degenerate_result/4, agrees/3]).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(http/json)).
:- use_module(library(lists)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Part,File]),
    setup_call_cleanup(open(File, read, In), records(In, Records), close(In)),
    call(Part, Records).

records(In, Records) :-
    json_read_dict(In, Record, [end_of_file(end)]),
    (   Record == end
    ->  Records = []
    ;   Records = [Record|Records1],
        records(In, Records1)
    ).

/* - - - speed - - - */

%   `ms` is from loaded relations (peers: from arrays of vertices and triangles)
%   to the result, with all structures built; the ratio is ours to the peer's.
%   `op` is that without what a peer builds of each mesh before; `warm` is again
%   in the same process, with what is kept: our pieces, a peer's trees.

speed(Records) :-
    format("~w~t~10|~w~t~24|~t~w~34|~t~w~42|~t~w~51|~t~w~60|~t~w~68|\c
            ~t~w~78|~t~w~85|~n",
           [case,peer,ms,ratio,op,warm,'its r.',triangles,ratio]),
    maplist(print_speed(Records), Records),
    forall(growth(Records, Peer, Exponent),
           format("~w: growth from sph20k to sph1300k: n^~3f~n",
                  [Peer,Exponent])).

print_speed(Records, R) :-
    number(R.op),
    ours(Records, R, Ours),
    !,
    seconds(R, Seconds),
    seconds(Ours, OurSeconds),
    Ms is Seconds*1000,
    Op is R.op*1000,
    Ratio is OurSeconds/Seconds,
    Size is Ours.nt/max(1, R.nt),
    warm(Ours, R, Warm, WarmRatio),
    format("~w~t~10|~w~t~24|~t~1f~34|~t~3f~42|~t~1f~51|~t~w~60|~t~w~68|\c
            ~t~d~78|~t~3f~85|~n",
           [R.case,R.peer,Ms,Ratio,Op,Warm,WarmRatio,R.nt,Size]).
print_speed(_, R) :-
    format("~w~t~10|~w~t~24|~w~n", [R.case,R.peer,R.fail]).

%   warm(Ours, R, Ms, Ratio): texts; of what takes long it is not asked.

warm(Ours, R, Ms, Ratio) :-
    number(R.warm),
    number(Ours.warm),
    !,
    Milliseconds is R.warm*1000,
    format(atom(Ms), "~1f", [Milliseconds]),
    Quotient is Ours.warm/R.warm,
    format(atom(Ratio), "~3f", [Quotient]).
warm(_, _, -, -).

seconds(R, Seconds) :-
    Seconds is R.op + R.build.

ours(Records, R, Ours) :-
    member(Ours, Records),
    Ours.peer == "sanggwan",
    Ours.case == R.case,
    Ours.mode == R.mode,
    number(Ours.op),
    !.

growth(Records, Peer, Exponent) :-
    member(Small, Records),
    Small.case == "sph20k",
    Peer = Small.peer,
    member(Large, Records),
    Large.case == "sph1300k",
    Large.peer == Peer,
    number(Small.op),
    number(Large.op),
    seconds(Small, SmallSeconds),
    seconds(Large, LargeSeconds),
    Exponent is log(LargeSeconds/SmallSeconds)/log(64).

/* - - - degenerate pairs - - - */

%   Right: volume and area to 1e-5 (some peers round to single precision),
%   closed, no triangle without area; `clean` also counts no intersecting
%   triangles, as CGAL counts them (it takes a vertex that two bodies share for
%   two, which meet).

degenerate(Records) :-
    format("~w~t~16|~w~t~26|~w~t~36|~w~n",
           [peer,right,clean,'not right, or intersecting']),
    findall(Peer, ( member(R, Records), Peer = R.peer ), Peers0),
    sort(Peers0, Peers),
    maplist(print_degenerate(Records), Peers).

print_degenerate(Records, Peer) :-
    findall(State, ( member(R, Records), R.peer == Peer, state(R, State) ),
            States),
    length(States, N),
    aggregate_all(count, member(state(_, [], _), States), Right),
    aggregate_all(count, member(state(_, [], 0), States), Clean),
    findall(Name-Faults-Pairs,
            ( member(state(Name, Faults, Pairs), States),
              Faults-Pairs \== []-0 ),
            Bad),
    format("~w~t~16|~d of ~d~t~26|~d of ~d~t~36|~w~n",
           [Peer,Right,N,Clean,N,Bad]).

state(R, state(Name,Faults,R.selfint)) :-
    atomic_list_concat([R.case,R.mode], ' ', Name),
    findall(Fault, record_fault(R, Fault), Faults).

record_fault(R, failed) :-
    \+ number(R.op),
    !.
record_fault(R, Fault) :-
    check_text(R, Text),
    split_string(Text, " ", "", [_|Words]),
    findall(Key-Value,
            ( member(Word, Words), split_string(Word, "=", "", [Key,Value]) ),
            Pairs),
    degenerate_result(R.case, R.mode, Volume, Area),
    (   memberchk("closed"-"NO", Pairs),
        Fault = open
    ;   memberchk("degen"-Text1, Pairs),
        Text1 \== "0",
        Fault = zero_area(Text1)
    ;   member(Key-Wanted, ["vol"-Volume,"area"-Area]),
        memberchk(Key-Text2, Pairs),
        number_string(Value, Text2),
        \+ agrees(Value, Wanted, 1.0e-5),
        Fault = differs(Key, Value)
    ).

check_text(R, Text) :-
    (   string(R.merged),
        R.merged \== ""
    ->  Text = R.merged
    ;   Text = R.check
    ).
