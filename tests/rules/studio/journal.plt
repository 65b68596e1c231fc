/* The journal of a document: what it says after each damage of its file. */
:- module(test_journal, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(studio/journal)).

% Goal with the name of a new file in a folder that goes away.
:- meta_predicate with_path(1).
with_path(Goal) :-
    tmp_file(journal, Folder),
    setup_call_cleanup(
        make_directory(Folder),
        ( directory_file_path(Folder, 'deep/a.journal', Path),
          call(Goal, Path) ),
        delete_directory_and_contents(Folder)).

step(N, _{do:"add", text:Text, n:N}) :-
    format(string(Text), "f(~d, 'x y').", [N]).

% A journal of Steps that is closed again; its octets.
written(Path, Begun, Steps, Octets) :-
    journal_begun(Path, 'a.pl', "d0", "f(0).", Begun, Journal),
    forall(member(Step, Steps), journal_line(Journal, Step)),
    journal_closed(Journal),
    octets(Path, Octets).

octets(Path, Octets) :-
    read_file_to_codes(Path, Octets, [type(binary)]).

put(Path, Octets) :-
    setup_call_cleanup(open(Path, write, Out, [type(binary)]),
                       forall(member(Octet, Octets), put_byte(Out, Octet)),
                       close(Out)).

end_gone(Path) :-
    atom_concat(Path, '.end', End),
    delete_file(End).

found(Path, Digest, Found) :-
    (   journal_steps(Path, Digest, Steps)
    ->  (   Steps == other
        ->  Found = other
        ;   maplist(short, Steps, Found)
        )
    ;   Found = none
    ).

short(Step, Short) :-
    (   get_dict(n, Step, N)
    ->  Short = N
    ;   get_dict(do, Step, Do),
        atom_string(Short, Do)
    ).

numbered(Ns, Steps) :-
    maplist(step, Ns, Steps).

kept(Found-Whole, Path) :-
    numbered([1,2], Begun),
    numbered([3,4,5], Steps),
    written(Path, Begun, Steps, _),
    journal_steps(Path, "d0", Found),
    journal_whole(Path, Text, All),
    Whole = Text-All.

% Cut off after each of its octets, with and without what stands beside it.
cut_off(Path) :-
    numbered([1,2], Steps),
    written(Path, [], Steps, Octets),
    length(Octets, All),
    atom_concat(Path, '.end', End),
    octets(End, Remembered),
    findall(Before,
            ( nth0(At, Octets, 0'\n), Before is At+1 ), [Head,First,Second]),
    assertion(Second == All),
    forall(between(0, All, Length),
           ( length(Some, Length),
             append(Some, _, Octets),
             put(Path, Some),
             (   Length < Head
             ->  Wanted = none
             ;   Length < First
             ->  Wanted = []
             ;   Length < Second
             ->  Wanted = [1]
             ;   Wanted = [1,2]
             ),
             catch(end_gone(Path), error(_, _), true),
             found(Path, "d0", Without),
             assertion(Length-Without == Length-Wanted),
             put(End, Remembered),
             found(Path, "d0", With),
             (   Wanted == none
             ->  assertion(With == none)
             ;   Length < All
             ->  append(Wanted, [damaged], Wanted1),
                 assertion(Length-With == Length-Wanted1)
             ;   assertion(With == Wanted)
             ) )).

% Each octet another one: the line is damaged, all others hold.
changed(By, Path) :-
    numbered([1,2,3], Steps),
    written(Path, [], Steps, Octets),
    end_gone(Path),
    forall(nth0(At, Octets, Octet),
           ( findall(x, ( nth0(Other, Octets, 0'\n), Other < At ), Lines),
             length(Lines, Line),
             Changed is Octet xor By,
             length(Before, At),
             append(Before, [Octet|Behind], Octets),
             append(Before, [Changed|Behind], New),
             put(Path, New),
             found(Path, "d0", Found),
             (   Line =:= 0
             ->  assertion(At-Found == At-none)
             ;   Found == none
             ->  assertion(At-Found == At-[])
             ;   assertion(memberchk(damaged, Found)),
                 assertion(\+ memberchk(Line, Found)),
                 assertion(forall(between(1, 3, N),
                                  ( N =:= Line ; Octet == 0'\n
                                  ; memberchk(N, Found) )))
             ) )).

% Lines in another order, or one left out.
moved(Order, Found, Path) :-
    numbered([1,2,3], Steps),
    written(Path, [], Steps, Octets),
    end_gone(Path),
    string_codes(Text, Octets),
    split_string(Text, "\n", "", Lines),
    findall(Line, ( member(I, Order), nth0(I, Lines, Line) ), Some),
    atomic_list_concat(Some, '\n', New0),
    format(codes(New), '~w~n', [New0]),
    put(Path, New),
    found(Path, "d0", Found).

saved(Digest, Found, Path) :-
    numbered([1,2,3,4], [S1,S2,S3,S4]),
    written(Path, [], [ S1, _{do:"save", digest:"d1"}, S2,
                        _{do:"save", digest:"d2", rules:"r."}, S3,
                        _{do:"save", digest:"d1"}, S4,
                        _{do:"save"} ], _),
    found(Path, Digest, Found).

empty(Digest, Found, Path) :-
    written(Path, [], [], _),
    found(Path, Digest, Found).

% Without sums, as an older version wrote it.
older(Found-All, Path) :-
    file_directory_name(Path, Folder),
    make_directory_path(Folder),
    setup_call_cleanup(
        open(Path, write, Out, [encoding(utf8)]),
        format(Out, '{"journal":1, "digest":"d0", "text":"f(0)."}~n\c
                     {"do":"add", "n":1}~n{"do":"add", "n":2~n\c
                     {"do":"add", "n":3}~n{"do":"ad', []),
        close(Out)),
    found(Path, "d0", Found),
    journal_whole(Path, "f(0).", Steps),
    maplist(short, Steps, All).

gone(Left, Path) :-
    written(Path, [], [], _),
    assertion(exists_file(Path)),
    journal_gone(Path),
    file_directory_name(Path, Folder),
    directory_files(Folder, Left0),
    subtract(Left0, ['.','..'], Left),
    journal_gone(Path).

no_step(Path) :-
    file_directory_name(Path, Folder),
    make_directory_path(Folder),
    put(Path, `{"journal":2}\n`),
    \+ journal_steps(Path, "d0", _),
    \+ journal_whole(Path, _, _).

:- begin_tests(journal).

test(kept, Found-Text == [1,2,3,4,5]-"f(0).") :-
    with_path(kept(Steps-(Text-All))),
    assertion(Steps =@= All),
    assertion(forall(( member(Step, Steps), get_dict(n, Step, N),
                       step(N, Wanted) ),
                     Wanted :< Step)),
    maplist(short, Steps, Found).
test(none) :-
    \+ journal_steps('/no/such/journal', "d0", _),
    \+ journal_whole('/no/such/journal', _, _).
test(no_journal) :-
    with_path(no_step).
test(cut_off) :-
    with_path(cut_off).
test(changed, forall(member(By, [1,4,32]))) :-
    with_path(changed(By)).
test(order, [ forall(member(Order-Found, [ [0,1,2,3]-[1,2,3],
                                           [0,2,1,3]-[damaged,damaged,3],
                                           [0,2,3]-[damaged,damaged],
                                           [0,1,1,2]-[1,damaged,damaged],
                                           [1,2,3]-none, [0]-[] ])),
              true(Read == Found) ]) :-
    with_path(moved(Order, Read)).
%   What was changed since the text was saved that the file holds.
test(saved, [ forall(member(Digest-Found, [ "d0"-[1,2,3,4,save],
                                            "d1"-[4,save],
                                            "d2"-[rules,3,4,save],
                                            "d9"-other ])),
              true(Read == Found) ]) :-
    with_path(saved(Digest, Read)).
test(of_another_text, Found == []) :-
    with_path(empty("d9", Found)).
test(older, Found == [1,damaged,3]-[1,damaged,3]) :-
    with_path(older(Found)).
test(gone, Left == []) :-
    with_path(gone(Left)).
test(no_journal_to_write) :-
    journal_line(none, _{do:"add"}),
    journal_closed(none).
test(failed_before, error(disk_full)) :-
    journal_line(failed(none, error(disk_full, _)), _{do:"add"}).
test(half_a_newline, Ends == [true,true,false,false]) :-
    step(1, Step),
    summed_line(7, Step, Line),
    findall(Truth,
            ( member(At-Behind, [7-"\u008a",7-"\u00c2\u008a",7-"",8-"x"]),
              string_concat(Line, Behind, Text),
              ( other_end(At, Text) -> Truth = true ; Truth = false ) ),
            Ends).
test(half_a_character, Found == [true,false,false]) :-
    findall(Truth,
            ( member(Line, [ "{\"a\":\"\\u0041\"}", "{\"a\":\"\\ud800\"}",
                             "[1]" ]),
              ( line_step(1, 0, Line, _) -> Truth = true ; Truth = false ) ),
            Found).

:- end_tests(journal).
