:- encoding(utf8).
:- module(sg_query,
          [ query/2,                    % :Goal, +Options
            read_goal/3,                % +Text, -Goal, -Bindings
            answer_json/2,              % +Value, -Json
            print_table/2               % +Names, +Rows
          ]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../language', [language/1]).
:- use_module('../limits', [term_of_text/3, within_depth/1]).
:- use_module('../part', [whole_program_for/1]).
:- use_module('../plain', [plain_json/2, plain_text/2, shown_text/2]).
:- use_module(library(apply),
              [foldl/4, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/3]).
:- use_module(library(pairs), [pairs_keys_values/3, pairs_values/2]).
:- use_module(library(solution_sequences), [limit/2]).
/** <module> All answers of a goal, as a table, CSV, JSON or Prolog.
*/

:- meta_predicate query(:, +).

%!  read_goal(+Text, -Goal, -Bindings) is det.
%
%   Goal is the term that Text holds, Bindings has Name-Variable for each
%   variable that does not begin with an underscore, in the order of Text, less
%   those that no answer binds: what findall/3 and its like collect with, and
%   `V` of `V^Goal`, unless they also stand elsewhere.
%
%   @error usage_error(bad_goal(Text, Why))

read_goal(Text, Goal, Bindings) :-
    catch(term_of_text(Text, Goal, [variable_names(Names)]),
          error(syntax_error(Why), _), bad_goal(Text, Why)),
    (   callable(Goal)
    ->  true
    ;   bad_goal(Text, not_callable)
    ),
    whole_program_for(Goal),
    findall_named(Names, Named),
    answered(Goal, Answered, []),
    pairs_values(Named, Variables),
    places_in(Answered, Variables, Places),
    chosen(Places, in, Named, Bindings).

%   answered(Goal)//: the parts of Goal whose variables an answer may bind.

answered(Goal) -->
    (   { var(Goal) }
    ->  [ Goal ]
    ;   { connected(Goal, Goals) }
    ->  answered_all(Goals)
    ;   { collecting(Goal, Free) }
    ->  [ Free ]
    ;   [ Goal ]
    ).

answered_all([]) -->
    [].
answered_all([Goal|Goals]) -->
    answered(Goal),
    answered_all(Goals).

connected((A,B), [A,B]).
connected((A;B), [A,B]).
connected((A->B), [A,B]).
connected((A*->B), [A,B]).
connected(_^A, [A]).
connected(_:A, [A]).

%   collecting(Goal, Free): Goal calls a goal by itself, and binds no variables
%   but those of Free.

collecting(\+ _, []).
collecting(forall(_, _), []).
collecting(findall(_, _, All), All).
collecting(findall(_, _, All, Rest), All-Rest).
collecting(aggregate_all(_, _, All), All).
collecting(aggregate_all(_, _, _, All), All).
collecting(setof(Template, Goal, All), Free) :-
    free_in(Template, Goal, All, Free).
collecting(bagof(Template, Goal, All), Free) :-
    free_in(Template, Goal, All, Free).

%   free_in(Template, Goal, All, Free): All, and what of Goal is neither of
%   Template nor before a ^.

free_in(Template, Goal0, All, All-Free) :-
    before_hats(Goal0, Template, Bound, Goal),
    term_variables(Goal, Variables),
    places_in(Bound, Variables, Places),
    chosen(Places, out, Variables, Free).

before_hats(Goal, Bound, Bound, Goal) :-
    var(Goal),
    !.
before_hats(V^Goal0, Bound0, Bound, Goal) :-
    !,
    before_hats(Goal0, Bound0-V, Bound, Goal).
before_hats(Goal, Bound, Bound, Goal).

%   places_in(Term, Variables, Places): `in` for each of Variables that Term
%   has, `out` for the others.

places_in(Term, Variables, Places) :-
    term_variables(Term, Within),
    findall(Places0,
            ( maplist(=(in), Within),
              maplist(place, Variables, Places0) ),
            [Places]).

place(Variable, Place) :-
    (   var(Variable)
    ->  Place = out
    ;   Place = in
    ).

%   chosen(Places, Place, Items, Chosen): those of Items at that Place.

chosen([], _, [], []).
chosen([Place1|Places], Place, [Item|Items], Chosen) :-
    (   Place1 == Place
    ->  Chosen = [Item|Chosen1]
    ;   Chosen = Chosen1
    ),
    chosen(Places, Place, Items, Chosen1).

bad_goal(Text, Why) :-
    throw(error(usage_error(bad_goal(Text, Why)), _)).

findall_named([], []).
findall_named([Name=Variable|Names], Bindings) :-
    (   sub_atom(Name, 0, _, _, '_')
    ->  Bindings = Bindings1
    ;   Bindings = [Name-Variable|Bindings1]
    ),
    findall_named(Names, Bindings1).

%!  query(:Goal, +Options) is semidet.
%
%   Print every answer of Goal on the current output, in the order they are
%   found. True if there is one. Options:
%
%     - bindings(List): Name-Variable of what is printed, as read_goal/3 gives
%     - format(F): `table` (default), `csv`, `json` (a list of objects) or
%       `prolog` (the goal with its answers, one a line, that read back)
%     - limit(N): the first N answers

query(Module:Goal, Options) :-
    option(bindings(Bindings), Options, []),
    option(format(Format), Options, table),
    option(limit(Limit), Options, infinite),
    pairs_keys_values(Bindings, Names, Values),
    answers(Format, Names, Values, Goal, limited(Limit, Module:Goal), Count),
    Count > 0.

limited(infinite, Goal) :-
    !,
    asked(Goal).
limited(N, Goal) :-
    limit(N, asked(Goal)).

%   asked(Goal): as call/1, but no error names the predicates of this file.

asked(Goal) :-
    catch(Goal, error(Formal, context(Caller, Message)),
          ( blamed(Caller, Blamed),
            throw(error(Formal, context(Blamed, Message))) )).

blamed(Caller, _) :-
    nonvar(Caller),
    memberchk(Caller, [ sg_query:_, system:catch/3,
                        system:'<meta-call>'/1 ]),
    !.
blamed(Caller, Caller).

%   answers(Format, Names, Values, Goal, Answer, Count): call Answer for every
%   answer and print it; Count of them there were.

answers(table, Names, Values, _, Answer, Count) :-
    State = table(0, none),
    forall(findnsols(1000, Values, Answer, Rows),
           block_printed(State, Names, Rows)),
    arg(1, State, Count).
answers(csv, Names, Values, _, Answer, Count) :-
    (   Names == []
    ->  true
    ;   csv_line(Names)
    ),
    counted(Answer, csv_line(Values), Count).
answers(json, Names, Values, _, Answer, Count) :-
    format("["),
    State = count(0),
    forall(Answer,
           ( arg(1, State, N0),
             N is N0+1,
             nb_setarg(1, State, N),
             (   N0 =:= 0
             ->  format("~n  ")
             ;   format(",~n  ")
             ),
             json_object(Names, Values) )),
    arg(1, State, Count),
    format("~n]~n").
answers(prolog, _, _, Goal, Answer, Count) :-
    counted(Answer, prolog_line(Goal), Count).

:- meta_predicate counted(0, 0, -).

counted(Answer, Print, Count) :-
    State = count(0),
    forall(Answer,
           ( call(Print),
             arg(1, State, N0),
             N is N0+1,
             nb_setarg(1, State, N) )),
    arg(1, State, Count).

%   lettered(Term0, Term): unbound variables of an answer are A, B, ..., so
%   that the same answer always gives the same text. It is not too deep.

lettered(Term0, Term) :-
    within_depth(Term0),
    copy_term(Term0, Term, _),
    numbervars(Term, 0, _).

csv_line([]) :-
    !.
csv_line(Values0) :-
    lettered(Values0, Values),
    maplist(csv_cell, Values, Cells),
    atomic_list_concat(Cells, ',', Line0),
    shown_text(Line0, Line),
    format("~w~n", [Line]).

%   csv_cell(Value, Cell): in double quotes where RFC 4180 asks for them;
%   lines end with a newline alone.

csv_cell(Value, Cell) :-
    (   ( atom(Value) ; string(Value) )
    ->  format(string(Text), "~w", [Value])
    ;   format(string(Text), "~q", [Value])
    ),
    (   \+ ( member(Special, ['"', ',', '\r', '\n']),
             sub_string(Text, _, _, _, Special) )
    ->  Cell = Text
    ;   atomic_list_concat(Parts, '"', Text),
        atomic_list_concat(Parts, '""', Inner),
        format(string(Cell), "\"~w\"", [Inner])
    ).

rational_only(Value) :-
    rational(Value),
    \+ integer(Value).

json_object(Names, Values0) :-
    lettered(Values0, Values),
    maplist(json_value, Values, Jsons),
    pairs_keys_values(Pairs, Names, Jsons),
    dict_pairs(Dict, _, Pairs),
    put_char(' '),
    plain_json(current_output,
               json_laid_out(current_output, Dict, inf)).

%!  answer_json(+Value, -Json) is det.
%
%   Json is a Value of an answer as library(http/json) writes it: numbers, atoms
%   and strings, lists of them; else the text of the term.

answer_json(Value0, Json) :-
    lettered(Value0, Value),
    json_value(Value, Json).

json_value(Value, Value) :-
    number(Value),
    \+ rational_only(Value),
    (   float(Value)
    ->  float_class(Value, Class),
        Class \== nan,
        Class \== infinite
    ;   true
    ),
    !.
json_value(Value, Value) :-
    ( atom(Value) ; string(Value) ),
    !.
json_value(Values, Jsons) :-
    is_list(Values),
    !,
    maplist(json_value, Values, Jsons).
json_value(Value, Json) :-
    format(string(Json), '~q', [Value]).

prolog_line(Goal0) :-
    lettered(Goal0, Goal),
    sig_atomic(write_term(Goal, [ quoted(true), spacing(next_argument),
                                  numbervars(true), fullstop(true),
                                  nl(true) ])). % see write_fact/2

%   block_printed(State, Names, Rows): answers are not kept. The columns are as
%   wide as those of the first thousand rows need; a later cell that is wider
%   puts its own row out of line.

block_printed(_, _, []) :-
    !.
block_printed(State, Names, Rows) :-
    State = table(Count0, Widths0),
    length(Rows, More),
    Count is Count0+More,
    nb_setarg(1, State, Count),
    (   Names == []
    ->  (   Count0 =:= 0
        ->  affirmed
        ;   true
        )
    ;   Widths0 == none
    ->  table_printed(Names, Rows, Widths),
        nb_setarg(2, State, Widths)
    ;   maplist(row_texts, Rows, TextRows),
        forall(member(Row, TextRows), print_row(Row, Widths0))
    ).

affirmed :-
    language(Language),
    (   Language == ko
    ->  format("예~n")
    ;   format("yes~n")
    ).

%!  print_table(+Names, +Rows) is det.
%
%   Print the lists of values Rows under Names on the current output: columns
%   as wide as their widest cell, numbers to the right. A value '$text'(Text) is
%   printed as it is, without quotes.

print_table([], Rows) :-
    !,
    (   Rows == []
    ->  true
    ;   affirmed
    ).
print_table(_, []) :-
    !.
print_table(Names, Rows) :-
    table_printed(Names, Rows, _).

table_printed(Names, Rows, Widths) :-
    maplist(row_texts, Rows, TextRows),
    TextRows = [First|_],
    maplist(head_cell, Names, First, Heads),
    foldl(row_widths, [Heads|TextRows], [], Widths),
    print_row(Heads, Widths),
    forall(member(Row, TextRows), print_row(Row, Widths)).

row_texts(Values0, Cells) :-
    lettered(Values0, Values),
    maplist(value_cell, Values, Cells).

value_cell('$text'(Text0), cell(left, Text)) :-
    !,
    plain_text(Text0, Text).
value_cell(Value, cell(Side, Text)) :-
    (   number(Value)
    ->  Side = right
    ;   Side = left
    ),
    format(string(Text0), '~p', [Value]),
    plain_text(Text0, Text).

%   The head stands over its column: to the right over numbers.

head_cell(Name, cell(Side, _), cell(Side, Name)).

row_widths(Cells, [], Widths) :-
    !,
    maplist(cell_width, Cells, Widths).
row_widths(Cells, Widths0, Widths) :-
    maplist(wider, Cells, Widths0, Widths).

cell_width(cell(_, Text), Width) :-
    string_length(Text, Width).

wider(Cell, Width0, Width) :-
    cell_width(Cell, Width1),
    Width is max(Width0, Width1).

print_row(Cells, Widths) :-
    row_parts(Cells, Widths, Texts),
    atomics_to_string(Texts, Line),
    format("~s~n", [Line]).

%   row_parts(Cells, Widths, Texts): nothing follows the last text.

row_parts([cell(left, Text)], _, [Text]) :-
    !.
row_parts([Cell|Cells], [Width|Widths], [Padded|Texts]) :-
    padded(Cell, Width, Padded),
    (   Cells == []
    ->  Texts = []
    ;   Texts = ["  "|Texts1],
        row_parts(Cells, Widths, Texts1)
    ).

padded(cell(Side, Text), Width, Padded) :-
    string_length(Text, Length),
    Pad is max(0, Width-Length),
    format(string(Spaces), "~` t~*|", [Pad]),
    (   Side == right
    ->  string_concat(Spaces, Text, Padded)
    ;   string_concat(Text, Spaces, Padded)
    ).
