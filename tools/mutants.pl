/* Draws mutants: copies of a source file with one small change in one line.

       swipl -f none tools/mutants.pl -- SEED N FOLDER [PART...]
       swipl -f none tools/mutants.pl -- TABLE.csv FOLDER

   Writes N changed files as FOLDER/1, FOLDER/2, ... and a row for each on
   standard output, separated by tabs: number, file, line, what stood there,
   what stands there now. The files are those of rules/, c_kernels/ and engine/
   (every other one a rule, the longer ones oftener), or those whose path has
   one of PART in it. In every third mutant something is gone; in the others
   something is different. Same seed, same sources: same mutants. Of a table of
   results (tools/mutants) those are written that survived.

   What a change may be: a comparison, an operator of arithmetic or a constant
   becomes its neighbour; a condition is negated or dropped; a goal, a
   statement or a fact goes. Comments, texts and the tables of messages stay
   as they are.
*/
:- module(sg_mutants, []).
:- use_module(mutants_c, [c_site/4]).
:- use_module(mutants_rules, [rule_site/4]).
:- use_module(library(csv)).
:- use_module(library(readutil)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Table,Folder]),
    !,
    make_directory_path(Folder),
    csv_read_file(Table, [Head|Rows], [convert(false)]),
    Head =.. [_|Columns],
    findall(Values, ( member(Row, Rows), survivor(Columns, Row, Values) ),
            Survivors),
    forall(nth1(I, Survivors, Values), written_again(Folder, I, Values)).
main :-
    current_prolog_flag(argv, [Seed0,N0,Folder|Parts]),
    atom_number(Seed0, Seed),
    atom_number(N0, N),
    set_random(seed(Seed)),
    make_directory_path(Folder),
    maplist(source_files(Parts), [rules,c], Sources),
    draw_all(1, N, Folder, Sources, []).

survivor(Columns, Row, [File,Line,Was,Became]) :-
    Row =.. [_|Cells],
    maplist(cell(Columns, Cells), [file,line,was,became,result],
            [File,Line,Was,Became,Result]),
    downcase_atom(Result, survived).

cell(Columns, Cells, Name, Cell) :-
    nth1(I, Columns, Name),
    nth1(I, Cells, Cell),
    !.

%   What stood in the line may have moved: in the nearest line that has it.

written_again(Folder, I, [File,Line1,Was,Became]) :-
    atom_number(Line1, Line0),
    read_file_to_string(File, Text, [encoding(utf8)]),
    split_string(Text, "\n", "", Lines),
    findall(Off-(Line-At),
            ( nth1(Line, Lines, Own),
              sub_string(Own, At, _, _, Was),
              Off is abs(Line-Line0)
            ),
            Places),
    (   keysort(Places, [_-(Line-At)|_])
    ->  true
    ;   format(user_error, '~w:~w: ~w is there no more~n', [File,Line0,Was]),
        fail
    ),
    findall(L, ( nth1(K, Lines, Own), K < Line, string_length(Own, L0),
                 L is L0+1 ), Ls),
    sum_list(Ls, Before0),
    Start is Before0+At,
    atom_length(Was, Length),
    sub_string(Text, 0, Start, _, Before),
    From is Start+Length,
    sub_string(Text, From, _, 0, Behind),
    atomic_list_concat([Folder,/,I], Copy),
    setup_call_cleanup(open(Copy, write, Out, [encoding(utf8)]),
                       format(Out, '~w~w~w', [Before,Became,Behind]),
                       close(Out)),
    atomic_list_concat([I,File,Line,Was,Became], '\t', Row),
    writeln(Row),
    !.
written_again(_, _, _).

draw_all(I, N, _, _, _) :-
    I > N,
    !.
draw_all(I, N, Folder, Sources, Drawn) :-
    draw(I, Sources, Drawn, mutant(File, Line, Start, End, Text), New0),
    Length is End - Start,
    sub_string(Text, Start, Length, After, Was),
    sub_string(Text, _, After, 0, Behind),
    sub_string(Text, 0, Start, _, Before),
    became(New0, File, Was, New),
    atomic_list_concat([Folder,/,I], Copy),
    setup_call_cleanup(open(Copy, write, Out, [encoding(utf8)]),
                       format(Out, '~w~w~w', [Before,New,Behind]),
                       close(Out)),
    maplist(one_line, [Was,New], Shown),
    atomic_list_concat([I,File,Line|Shown], '\t', Row),
    writeln(Row),
    I1 is I + 1,
    draw_all(I1, N, Folder, Sources, [File:Line|Drawn]).

became(negated, File, Was, New) :-
    !,
    (   file_name_extension(_, c, File)
    ->  format(string(New), '(!~w)', [Was])
    ;   format(string(New), '\\+ ( ~w )', [Was])
    ).
became(New0, _, _, New) :-
    format(string(New), '~w', [New0]).

one_line(Text, Line) :-
    split_string(Text, "\t\n ", "\t\n ", Words0),
    exclude(==(""), Words0, Words),
    atomic_list_concat(Words, ' ', Line).

%   No line is drawn twice.

draw(I, Sources, Drawn, mutant(File, Line, Start, End, Text), New) :-
    repeat,
    Kind is I mod 2,
    nth0(Kind, Sources, Own),
    (   Own == []
    ->  member(Files, Sources),
        Files \== []
    ;   Files = Own
    ),
    weighted(Files, File),
    read_file_to_string(File, Text, [encoding(utf8)]),
    findall(Line0-site(From,To,Became), site(File, Text, Line0, From, To,
                                             Became), Sites0),
    Sites0 \== [],
    Third is I // 2 mod 3,
    include(of_kind(Third), Sites0, Sites1),
    Sites1 \== [],
    keysort(Sites1, Sites),
    group_pairs_by_key(Sites, Lines),
    random_member(Line-Own1, Lines),
    \+ memberchk(File:Line, Drawn),
    random_member(site(Start,End,New), Own1),
    !.

of_kind(Third, _-site(_,_,New)) :-
    (   memberchk(New, ["true","","[]",":- true"])
    ->  Third =:= 0
    ;   Third =\= 0
    ).

weighted(Files, File) :-
    last(Files, Total-_),
    At is random(Total),
    once(( member(Sum-File, Files),
           Sum > At )).

%!  source_files(+Parts, +Kind, -Files) is det.
%
%   Files are Sum-File, Sum the bytes of File and of those before it.

source_files(Parts, Kind, Files) :-
    findall(File,
            ( pattern(Kind, Pattern),
              expand_file_name(Pattern, Found),
              member(File, Found),
              \+ wording(File),
              (   Parts == []
              ->  true
              ;   member(Part, Parts),
                  sub_atom(File, _, _, _, Part)
              ->  true
              )
            ),
            Names),
    foldl([Name,Sum-Name,Sum0,Sum]>>( size_file(Name, Size),
                                      Sum is Sum0 + Size ),
          Names, Files, 0, _).

pattern(rules, 'rules/*.pl').
pattern(rules, 'rules/*/*.pl').
pattern(c, 'engine/*.c').
pattern(c, 'c_kernels/*.c').
pattern(c, 'c_kernels/*/*.c').

wording(File) :-
    member(Part, ['rules/message/', 'command/usage', 'engine/boot.c']),
    sub_atom(File, _, _, _, Part).

%!  site(+File, +Text, -Line, -Start, -End, -New) is nondet.
%
%   In Line of Text, that of File, New may stand in the place of the characters
%   from Start to End.

site(File, Text, Line, Start, End, New) :-
    findall(F-site(T,N), file_site(File, Text, F, T, N), Sites0),
    sort(Sites0, Sites),
    findall(P, sub_string(Text, P, 1, _, "\n"), Ends),
    numbered(Sites, Ends, 1, Numbered),
    member(numbered(Line,Start,End,New), Numbered).

file_site(File, Text, Start, End, New) :-
    (   file_name_extension(_, c, File)
    ->  c_site(Text, Start, End, New)
    ;   rule_site(File, Start, End, New)
    ).

%   numbered(+Sites, +Ends, +Line, -Numbered): those that are within a line.

numbered([], _, _, []).
numbered([F-site(T,N)|Sites], [End|Ends], Line, Numbered) :-
    (   F > End
    ->  Line1 is Line + 1,
        numbered([F-site(T,N)|Sites], Ends, Line1, Numbered)
    ;   T =< End
    ->  Numbered = [numbered(Line,F,T,N)|Rest],
        numbered(Sites, [End|Ends], Line, Rest)
    ;   numbered(Sites, [End|Ends], Line, Numbered)
    ).
