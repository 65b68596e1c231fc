/* The seven degenerate pairs of peers/boolean, three operations, at scales from
   1e-8 to 1e5:

       swipl -p foreign=build bench/boolean_scales.pl -- FOLDER [CASE,...]

   FOLDER is that of bench/peers.bash. Every input is multiplied, which rounds
   it. Right is: volume and area to 1e-7 (10 tolerances and more), closed, no
   triangle without area, none that penetrate each other, by the independent
   checker; for each also what `check` of the peers says.
*/
:- use_module('../rules/solid/boolean').
:- use_module('../rules/model/mesh').
:- use_module('../rules/store').
:- use_module('../rules/polygon/triangulation').
:- use_module('../tests/rules/checked').
:- use_module(degenerate).
:- use_module(rows_off).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(process)).
:- use_module(library(readutil)).


:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Folder|Wanted]),
    findall(Case,
            ( degenerate_result(Case, "diff", _, _), wanted(Wanted, Case) ),
            Cases),
    forall(( between(-8, 5, Exponent), Scale is 10.0**Exponent ),
           print_scale(Folder, Cases, Exponent, Scale)).

wanted([], _).
wanted([Wanted], Case) :-
    split_string(Wanted, ",", "", Cases),
    memberchk(Case, Cases).

print_scale(Folder, Cases, Exponent, Scale) :-
    findall(Case-Operation-Faults,
            ( member(Case, Cases),
              scaled_pair(Folder, Case, Scale, A, B),
              member(Operation, ["union","inter","diff"]),
              findall(F, result_fault(Folder, Case, Operation, Scale, A, B, F),
                      Faults)
            ),
            Results),
    length(Results, N),
    aggregate_all(count, member(_-[], Results), Right),
    exclude(is_right, Results, Bad),
    format("1e~d: ~d of ~d ~w~n", [Exponent,Right,N,Bad]).

is_right(_-[]).

scaled_pair(Folder, Case, Scale, A, B) :-
    maplist(scaled(Folder, Case, Scale), ["a","b"], [A,B]).

%   scaled(Folder, Case, Scale, Which, File): File has the mesh, multiplied.

scaled(Folder, Case, Scale, Which, File) :-
    format(atom(From), "~w/in/~w_~w.off", [Folder,Case,Which]),
    format(atom(File), "~w/scaled_~w.off", [Folder,Which]),
    read_file_to_string(From, Text, []),
    split_string(Text, "\n", "", [Head,Counts|Lines]),
    split_string(Counts, " ", "", [NText|_]),
    number_string(N, NText),
    length(Points, N),
    append(Points, Faces, Lines),
    setup_call_cleanup(
        open(File, write, Out),
        ( format(Out, "~w~n~w~n", [Head,Counts]),
          maplist(scaled_point(Out, Scale), Points),
          forall(member(Face, Faces), format(Out, "~w~n", [Face]))
        ),
        close(Out)).

scaled_point(Out, Scale, Line) :-
    split_string(Line, " ", "", Texts),
    forall(member(Text, Texts),
           ( number_string(X0, Text), X is X0*Scale, format(Out, "~w ", [X]) )),
    nl(Out).

expression("union", union([1,2])).
expression("inter", intersection([1,2])).
expression("diff", difference([1,2])).

result_fault(Folder, Case, Operation, Scale, A, B, Fault) :-
    atom_concat(Folder, '/scaled_result.off', File),
    catch(make(Operation, A, B, File), Error, true),
    (   nonvar(Error)
    ->  message_to_codes(Error, Fault)
    ;   checked([File], [R]),
        fault(R, Case, Operation, Scale, Fault)
    ;   peers_check(Folder, File, Fault)
    ).

message_to_codes(Error, raised(Kind)) :-
    (   Error = error(Kind, _)
    ->  true
    ;   Kind = Error
    ).

make(Operation, A, B, File) :-
    expression(Operation, Expression),
    new_world(World),
    in_world(World,
             ( read_mesh(A, _),
               read_mesh(B, _),
               complete_segments,
               boolean(Expression, 3),
               write_rows_off(3, File) )).

fault(R, _, _, _, Fault) :-
    member(Key, [open,unbalanced,zero_area,crossing,overlap,in_line,misturned]),
    get_dict(Key, R, N),
    N > 0,
    Fault = Key-N.
fault(R, Case, Operation, Scale, Fault) :-
    degenerate_result(Case, Operation, Volume, Area),
    (   Value is R.volume/Scale**3,
        \+ near(Value, Volume),
        Fault = volume(Value)
    ;   Value is R.area/Scale**2,
        \+ near(Value, Area),
        Fault = area(Value)
    ).

near(Value, Wanted) :-
    abs(Value-Wanted) =< 1.0e-7*max(1, abs(Wanted)).

peers_check(Folder, File, check(Text)) :-
    atom_concat(Folder, '/bin/check', Program),
    process_create(Program, [File], [stdout(pipe(Out))]),
    read_string(Out, _, Text),
    close(Out),
    (   sub_string(Text, _, _, _, "closed=NO")
    ->  true
    ;   \+ sub_string(Text, _, _, _, "degen=0")
    ).
