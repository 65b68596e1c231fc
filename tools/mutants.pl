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
:- use_module(library(csv)).
:- use_module(library(dcg/basics)).
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

% --- rules -------------------------------------------------------------------

rule_site(File, Start, End, New) :-
    setup_call_cleanup(
        open(File, read, In, [encoding(utf8)]),
        findall(F-T-N,
                ( clause_of(In, Term, Position),
                  clause_site(Term, Position, F, T, N)
                ),
                Sites),
        close(In)),
    member(Start-End-New, Sites).

clause_of(In, Term, Position) :-
    repeat,
    read_term(In, Term, [subterm_positions(Position), module(sg_mutants)]),
    (   Term == end_of_file
    ->  !,
        fail
    ;   Term = (:- Directive)
    ->  operators(Directive),
        fail
    ;   true
    ).

operators(op(P,T,N)) :-
    !,
    op(P, T, N).
operators(module(_,Exports)) :-
    forall(member(op(P,T,N), Exports), op(P, T, N)).

clause_site((Head :- Body), term_position(_,_,_,_,[P,Q]), F, T, New) :-
    !,
    (   constant_site(Head, P, F, T, New)
    ;   goal_site(Body, Q, F, T, New)
    ).
clause_site((Head --> Body), term_position(_,_,_,_,[P,Q]), F, T, New) :-
    !,
    (   constant_site(Head, P, F, T, New)
    ;   dcg_site(Body, Q, F, T, New)
    ).
clause_site(Head, _, _, _, _) :-
    compound(Head),
    arg(_, Head, Language),
    nonvar(Language),
    memberchk(Language, [en,ko]),
    !,
    fail.
clause_site(Head, P, F, T, New) :-
    constant_site(Head, P, F, T, New).
clause_site(_, P, F, T, ":- true") :-
    arg(1, P, F),
    arg(2, P, T).

dcg_site(Body, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    dcg_site(Body, P, F, T, New).
dcg_site({Goal}, brace_term_position(_,_,P), F, T, New) :-
    !,
    goal_site(Goal, P, F, T, New).
dcg_site(Body, term_position(_,_,_,_,Ps), F, T, New) :-
    control(Body, Goals, Kinds),
    !,
    nth1(I, Goals, Goal),
    nth1(I, Ps, P),
    nth1(I, Kinds, _),
    dcg_site(Goal, P, F, T, New).
dcg_site(!, F-T, F, T, "[]") :-
    !.
dcg_site(Body, P, F, T, New) :-
    constant_site(Body, P, F, T, New).
dcg_site(Body, P, F, T, "[]") :-
    callable(Body),
    \+ is_list(Body),
    arg(1, P, F),
    arg(2, P, T).

%   goal_site(+Goal, +Position, -Start, -End, -New) is nondet.

goal_site(Goal, _, _, _, _) :-
    var(Goal),
    !,
    fail.
goal_site(Goal, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    goal_site(Goal, P, F, T, New).
goal_site(Goal, term_position(_,_,_,_,Ps), F, T, New) :-
    control(Goal, Goals, Kinds),
    !,
    nth1(I, Goals, Inner),
    nth1(I, Ps, P),
    nth1(I, Kinds, Kind),
    (   goal_site(Inner, P, F, T, New)
    ;   Kind == condition,
        \+ control(Inner, _, _),
        arg(1, P, F),
        arg(2, P, T),
        New = negated
    ).
goal_site(\+ _, term_position(_,_,F,T,[_]), F, T, " ").
goal_site(\+ Goal, term_position(_,_,_,_,[P]), F, T, New) :-
    !,
    goal_site(Goal, P, F, T, New).
goal_site(!, F-T, F, T, "true") :-
    !.
goal_site(true, _, _, _, _) :-
    !,
    fail.
goal_site(fail, _, _, _, _) :-
    !,
    fail.
goal_site(_, P, F, T, "true") :-
    arg(1, P, F),
    arg(2, P, T).
goal_site(Goal, term_position(_,_,_,_,Ps), F, T, New) :-
    meta(Goal, Places),
    member(I, Places),
    nth1(I, Ps, P),
    arg(I, Goal, Inner),
    goal_site(Inner, P, F, T, New).
goal_site(Goal, term_position(_,_,F,T,[_,_]), F, T, New) :-
    functor(Goal, Name, 2),
    neighbours(Name, News),
    member(New, News).
goal_site(Goal, term_position(_,_,_,_,Ps), F, T, New) :-
    arithmetic(Goal),
    member(I, [1,2]),
    arg(I, Goal, Expression),
    nth1(I, Ps, P),
    expression_site(Expression, P, F, T, New).
goal_site(Goal, P, F, T, New) :-
    \+ meta(Goal, _),
    constant_site(Goal, P, F, T, New).

control((A,B), [A,B], [goal,goal]).
control((A;B), [A,B], [branch,branch]).
control((A->B), [A,B], [condition,goal]).
control((A*->B), [A,B], [condition,goal]).

meta(findall(_,_,_), [2]).
meta(findall(_,_,_,_), [2]).
meta(aggregate_all(_,_,_), [2]).
meta(forall(_,_), [1,2]).
meta(once(_), [1]).
meta(ignore(_), [1]).
meta(catch(_,_,_), [1,3]).
meta(setup_call_cleanup(_,_,_), [1,2,3]).
meta(call_cleanup(_,_), [1,2]).
meta(facts_transaction(_), [1]).

neighbours(<, ["=<", ">"]).
neighbours(=<, ["<", ">="]).
neighbours(>, [">=", "<"]).
neighbours(>=, [">", "=<"]).
neighbours(=:=, ["=\\="]).
neighbours(=\=, ["=:="]).
neighbours(==, ["\\=="]).
neighbours(\==, ["=="]).
neighbours(\=, ["="]).
neighbours(@<, ["@=<", "@>"]).
neighbours(@>, ["@>=", "@<"]).
neighbours(@=<, ["@<", "@>="]).
neighbours(@>=, ["@>", "@=<"]).

arithmetic(Goal) :-
    functor(Goal, Name, 2),
    memberchk(Name, [is,<,=<,>,>=,=:=,=\=]).

%   expression_site(+Expression, +Position, -Start, -End, -New) is nondet.

expression_site(E, _, _, _, _) :-
    var(E),
    !,
    fail.
expression_site(E, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    expression_site(E, P, F, T, New).
expression_site(E, term_position(_,_,F,T,_), F, T, New) :-
    functor(E, Name, Arity),
    operator(Name, Arity, New).
expression_site(E, term_position(_,_,_,_,Ps), F, T, New) :-
    nth1(I, Ps, P),
    arg(I, E, Inner),
    expression_site(Inner, P, F, T, New).

operator(+, 2, "-").
operator(-, 2, "+").
operator(*, 2, "/").
operator(/, 2, "*").
operator(//, 2, "*").
operator(min, 2, "max").
operator(max, 2, "min").
operator(-, 1, "+").
operator(abs, 1, "+").
operator(floor, 1, "ceiling").
operator(ceiling, 1, "floor").
operator(sin, 1, "cos").
operator(cos, 1, "sin").

%   constant_site(+Term, +Position, -Start, -End, -New) is nondet.

constant_site(Term, _, _, _, _) :-
    var(Term),
    !,
    fail.
constant_site(Number, F-T, F, T, New) :-
    number(Number),
    !,
    other_number(Number, New).
constant_site(Term, parentheses_term_position(_,_,P), F, T, New) :-
    !,
    constant_site(Term, P, F, T, New).
constant_site(Term, term_position(_,_,_,_,Ps), F, T, New) :-
    nth1(I, Ps, P),
    arg(I, Term, Inner),
    constant_site(Inner, P, F, T, New).
constant_site({Term}, brace_term_position(_,_,P), F, T, New) :-
    constant_site(Term, P, F, T, New).
constant_site(List, list_position(_,_,Ps,_), F, T, New) :-
    nth1(I, Ps, P),
    item(I, List, Item),
    constant_site(Item, P, F, T, New).

item(1, [X|_], X) :-
    !.
item(I, [_|Xs], X) :-
    I1 is I - 1,
    item(I1, Xs, X).

other_number(N, New) :-
    integer(N),
    !,
    (   N =:= 0
    ->  Others = [1]
    ;   Up is N + 1,
        Down is N - 1,
        Others = [Up,Down]
    ),
    member(New, Others).
other_number(N, New) :-
    float(N),
    (   N =:= 0.0
    ->  Others = [1.0]
    ;   Double is N*2,
        Others = [0.0,Double]
    ),
    member(New, Others).

% --- C -----------------------------------------------------------------------

c_site(Text, Start, End, New) :-
    string_codes(Text, Codes),
    phrase(tokens(0, Tokens0), Codes),
    depths(Tokens0, 0, Tokens),
    token_site(Tokens, Start, End, New).

%   A token is Kind(Start,End,Atom); space and comments are between them, the
%   ends of lines are tokens.

tokens(At, Tokens) -->
    [C],
    { code_type(C, space),
      C \== 0'\n },
    !,
    { At1 is At + 1 },
    tokens(At1, Tokens).
tokens(At, Tokens) -->
    "/*",
    !,
    string(Inside),
    "*/",
    !,
    { length(Inside, N),
      At1 is At + N + 4 },
    tokens(At1, Tokens).
tokens(At, Tokens) -->
    "//",
    !,
    line_rest(N),
    { At1 is At + 2 + N },
    tokens(At1, Tokens).
tokens(At, Tokens) -->
    "#",
    !,
    directive(0, N),
    { At1 is At + 1 + N },
    tokens(At1, Tokens).
tokens(At, [Token|Tokens]) -->
    token(Kind, Codes),
    !,
    { length(Codes, N),
      End is At + N,
      atom_codes(Atom, Codes),
      Token = token(Kind,At,End,Atom) },
    tokens(End, Tokens).
tokens(_, []) -->
    [].

line_rest(N) -->
    [C],
    { C \== 0'\n },
    !,
    line_rest(N0),
    { N is N0 + 1 }.
line_rest(0) -->
    [].

directive(N0, N) -->
    "\\\n",
    !,
    { N1 is N0 + 2 },
    directive(N1, N).
directive(N0, N) -->
    [C],
    { C \== 0'\n },
    !,
    { N1 is N0 + 1 },
    directive(N1, N).
directive(N, N) -->
    [].

token(line, [0'\n]) -->
    "\n".
token(text, Codes) -->
    [Quote],
    { memberchk(Quote, `"'`) },
    !,
    quoted(Quote, Rest),
    { Codes = [Quote|Rest] }.
token(name, [C|Cs]) -->
    [C],
    { code_type(C, csymf) },
    !,
    run(csym, Cs).
token(number, [C|Cs]) -->
    [C],
    { code_type(C, digit) },
    !,
    number_rest(Cs).
token(mark, Codes) -->
    { member(Mark, ["<<=",">>=","->","++","--","<<",">>","<=",">=","==","!=",
                    "&&","||","+=","-=","*=","/=","|=","&=","^=","%="]),
      string_codes(Mark, Codes) },
    Codes,
    !.
token(mark, [C]) -->
    [C].

quoted(Quote, [0'\\,C|Cs]) -->
    "\\",
    !,
    [C],
    quoted(Quote, Cs).
quoted(Quote, [Quote]) -->
    [Quote],
    !.
quoted(Quote, [C|Cs]) -->
    [C],
    quoted(Quote, Cs).

run(Type, [C|Cs]) -->
    [C],
    { code_type(C, Type) },
    !,
    run(Type, Cs).
run(_, []) -->
    [].

number_rest([E,S|Cs]) -->
    [E,S],
    { memberchk(E, `eEpP`),
      memberchk(S, `+-`) },
    !,
    number_rest(Cs).
number_rest([C|Cs]) -->
    [C],
    { ( code_type(C, csym) ; C == 0'. ) },
    !,
    number_rest(Cs).
number_rest([]) -->
    [].

%   depths(+Tokens0, +Depth, -Tokens): each with the braces around it.

depths([], _, []).
depths([token(Kind,F,T,Atom)|Tokens0], D0, [token(Kind,F,T,Atom,D0)|Tokens]) :-
    (   Atom == '{'
    ->  D is D0 + 1
    ;   Atom == '}'
    ->  D is D0 - 1
    ;   D = D0
    ),
    depths(Tokens0, D, Tokens).

%   here(+Tokens, -Back, -Token, -After) is nondet.
%
%   Token stands between Back, from right to left, and After.

here(Tokens, Back, Token, After) :-
    here(Tokens, [], Back, Token, After).

here([Token|After], Back, Back, Token, After).
here([Token0|Tokens], Back0, Back, Token, After) :-
    here(Tokens, [Token0|Back0], Back, Token, After).

token_site(Tokens, Start, End, New) :-
    here(Tokens, Back, token(Kind,F,T,Atom,D), After),
    token_site(Kind, Atom, F, T, D, Back, After, Start, End, New).

token_site(mark, Mark, F, T, D, Back, _, F, T, New) :-
    D > 0,
    binary(Back),
    c_neighbours(Mark, News),
    member(New, News).
token_site(mark, '++', F, T, D, _, _, F, T, "--") :-
    D > 0.
token_site(mark, '--', F, T, D, _, _, F, T, "++") :-
    D > 0.
token_site(mark, !, F, T, _, _, [token(Kind,_,_,_,_)|_], F, T, " ") :-
    Kind \== line.
token_site(name, Name, F, T, D, _, _, F, T, New) :-
    D > 0,
    memberchk(Name-New, [true-"false", false-"true", continue-"", break-"",
                         fmin-"fmax", fmax-"fmin"]).
token_site(number, Atom, F, T, _, Back, After, F, T, New) :-
    \+ declared_size(Back, After),
    c_number(Atom, New).
token_site(name, if, _, _, _, _, [token(_,Start,_,'(',_)|After], Start, End,
           negated) :-
    closing(After, 1, End).
token_site(mark, Mark, _, T, _, Back, _, Start, T, "") :- % A && dropped
    memberchk(Mark, [&&,'||']),
    operand_before(Back, 0, none, Start),
    Start \== none.
token_site(mark, Mark, F, T, _, _, After, F, End, "") :-  % && B dropped
    memberchk(Mark, [&&,'||']),
    operand_after(After, 0, T, End),
    End > T.
token_site(mark, Left, _, _, _, _, After, Start, End, "") :- % a statement
    memberchk(Left, [;,'{','}']),
    skip_lines(After, [token(name,Start,_,Name,D),token(mark,_,_,Next,_)
                       |Rest]),
    D > 0,
    \+ memberchk(Name, [if,for,while,return,switch,else,do,case,sizeof]),
    memberchk(Next, ['(',=,->,'.','[',++,--,+=,-=,'|=',&=,*=]),
    memberchk(token(mark,_,End,;,_), Rest).

skip_lines([token(line,_,_,_,_)|Tokens0], Tokens) :-
    !,
    skip_lines(Tokens0, Tokens).
skip_lines(Tokens, Tokens).

%   A sign has two operands if one stands before it.

binary([token(Kind,_,_,Last,_)|Back]) :-
    (   memberchk(Kind, [name,number])
    ->  \+ memberchk(Last, [return,case,sizeof])
    ;   memberchk(Last, [')',']'])
    ->  true
    ;   Kind == line,
        binary(Back)
    ).

c_neighbours(<, ["<=", ">"]).
c_neighbours(<=, ["<", ">="]).
c_neighbours(>, [">=", "<"]).
c_neighbours(>=, [">", "<="]).
c_neighbours(==, ["!="]).
c_neighbours('!=', ["=="]).
c_neighbours(&&, ["||"]).
c_neighbours('||', ["&&"]).
c_neighbours(+, ["-"]).
c_neighbours(-, ["+"]).
c_neighbours(/, ["*"]).
c_neighbours('%', ["/"]).
c_neighbours('+=', ["-=", "="]).
c_neighbours('-=', ["+=", "="]).
c_neighbours('|=', ["=", "&="]).
c_neighbours('&=', ["=", "|="]).
c_neighbours('<<', [">>"]).
c_neighbours('>>', ["<<"]).

declared_size([token(_,_,_,'[',_)|Back], [token(_,_,_,']',_)|_]) :-
    first_of_line(Back, First),
    memberchk(First, [double,int,char,const,static,size_t,bool,unsigned,
                      uint8_t,uint16_t,uint32_t,uint64_t,int64_t,mpz_t]).

first_of_line([token(_,_,_,First,_),token(line,_,_,_,_)|_], First) :-
    !.
first_of_line([_|Back], First) :-
    first_of_line(Back, First).

c_number(Atom, New) :-
    catch(atom_number(Atom, N), _, fail),
    other_number(N, New).
c_number(Atom, New) :-
    atom_concat(Digits, u, Atom),
    atom_number(Digits, N),
    other_number(N, New0),
    atom_concat(New0, u, New).

%   closing(+Tokens, +Open, -End): where the parenthesis closes, on this line.

closing([token(Kind,_,T,Atom,_)|Tokens], Open0, End) :-
    Kind \== line,
    deeper(Atom, Open0, Open),
    (   Open =:= 0
    ->  End = T
    ;   closing(Tokens, Open, End)
    ).

deeper(Atom, Depth0, Depth) :-
    (   memberchk(Atom, ['(','['])
    ->  Depth is Depth0 + 1
    ;   memberchk(Atom, [')',']'])
    ->  Depth is Depth0 - 1
    ;   Depth = Depth0
    ).

%   What stands before a && as far as the parenthesis or && before it, and
%   what stands after one: on its line.

operand_before([token(Kind,F,_,Atom,_)|Back], Depth0, Start0, Start) :-
    deeper(Atom, Depth0, Depth),
    (   Kind == line
    ->  Depth =:= 0,
        Start = Start0
    ;   Depth0 =:= 0,
        memberchk(Atom, ['(','['])
    ->  Start = Start0
    ;   Depth =:= 0,
        memberchk(Atom, [&&,'||',?,:,=,return,;,',','{','}'])
    ->  Start = Start0
    ;   operand_before(Back, Depth, F, Start)
    ).

operand_after([token(Kind,_,T,Atom,_)|After], Depth0, End0, End) :-
    deeper(Atom, Depth0, Depth),
    (   Kind == line
    ->  Depth0 =:= 0,
        End = End0
    ;   Depth < 0
    ->  End = End0
    ;   Depth =:= 0,
        memberchk(Atom, [&&,'||',?,:,;,',','{','}'])
    ->  End = End0
    ;   operand_after(After, Depth, T, End)
    ).
