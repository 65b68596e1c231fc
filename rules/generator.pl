:- module(sg_generator,
          [ conjuncts/2,                % @Conjunction, -Generators
            generator_fault/3,          % @Generators, @Term, -Fault
            generated/2                 % +Generators, +Folder
          ]).
:- use_module(decimal, [decimal_number/2]).
:- use_module(limits, [limit_value/2]).
:- use_module(library(csv), [csv_options/2, csv_read_row/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2, nth1/3]).
:- use_module(library(readutil), [read_line_to_string/2]).
/** <module> What variables of a template are: of a manifest, of variants.

A template is a term with variables; its generators bind them, each in turn:

    V in Low..High            whole numbers
    V in between(Low, High)   the same
    V in between(Low, High, Step)
                              numbers in steps: decimals, exactly
    V in [Value, ...]         numbers and names
    V in glob(Pattern)        the files of that pattern, in order of their names
    [V, ...] in rows(File, [Column, ...])
                              the rows of a table (.csv, .tsv), whose first line
                              names its columns; table_form/4

A later generator may use the variables of those before it. Nothing is made
before it is asked for, so a million jobs need no memory.
*/

%!  conjuncts(@Conjunction, -Generators) is det.
%
%   Generators is the list of what stands between the commas of Conjunction.

conjuncts(Goal, [Goal]) :-
    var(Goal),
    !.
conjuncts((A, B), Goals) :-
    !,
    conjuncts(A, As),
    conjuncts(B, Bs),
    append(As, Bs, Goals).
conjuncts(Goal, [Goal]).

%!  generator_fault(@Generators, @Term, -Fault) is semidet.
%
%   Fault is what is wrong with Generators, those of Term: generator(G), it is
%   none; bound_twice(V), two bind V; unbound(V), no generator binds V before it
%   is used.

generator_fault(Generators, Term, Fault) :-
    fault(Generators, [], Term, Fault),
    !.

fault([], Bound, Term, unbound(V)) :-
    free_variable(Term, Bound, V).
fault([Generator|Generators], Bound, Term, Fault) :-
    (   \+ is_generator(Generator)
    ->  Fault = generator(Generator)
    ;   arg(1, Generator, Pattern),
        arg(2, Generator, Source),
        term_variables(Pattern, Vs),
        (   free_variable(Source, Bound, V)
        ->  Fault = unbound(V)
        ;   member(V, Vs),
            is_bound(V, Bound)
        ->  Fault = bound_twice(V)
        ;   append(Vs, Bound, Bound1),
            fault(Generators, Bound1, Term, Fault)
        )
    ).

free_variable(Term, Bound, V) :-
    term_variables(Term, Vs),
    member(V, Vs),
    \+ is_bound(V, Bound),
    !.

is_bound(V, Bound) :-
    member(B, Bound),
    B == V,
    !.

is_generator(Generator) :-
    nonvar(Generator),
    Generator = in(Pattern, Source),
    nonvar(Source),
    source_of(Pattern, Source).

source_of(Pattern, Source) :-
    var(Pattern),
    simple_source(Source).
source_of(Pattern, rows(File, Columns)) :-
    is_list(Pattern),
    term_variables(Pattern, Vs),
    Vs == Pattern,
    file_text(File),
    is_list(Columns),
    length(Pattern, N),
    length(Columns, N),
    forall(member(Column, Columns), ( atom(Column) ; string(Column) )).

simple_source(..(Low, High)) :-
    number_or_variable(Low),
    number_or_variable(High).
simple_source(between(Low, High)) :-
    number_or_variable(Low),
    number_or_variable(High).
simple_source(between(Low, High, Step)) :-
    number_or_variable(Low),
    number_or_variable(High),
    number_or_variable(Step).
simple_source(glob(Pattern)) :-
    file_text(Pattern).
simple_source([Value|Values]) :-
    is_list(Values),
    forall(member(V, [Value|Values]),
           ( number_or_variable(V) ; atom(V) ; string(V) )).

number_or_variable(Term) :-
    (   var(Term)
    ;   integer(Term)
    ;   float(Term)
    ),
    !.

file_text(Text) :-
    (   atom(Text)
    ;   string(Text)
    ),
    !.

%!  generated(+Generators, +Folder) is nondet.
%
%   True for all values of the variables of Generators, in their order. Names
%   of files are those in Folder.
%
%   @error generator_error(What): range(Source), its ends are no numbers;
%   limit(values, Count, Most);
%   steps(Step); glob(Pattern), there is no such file; rows(File, Line, Why)
%   with Why missing, no_table, not_utf8, no_column(Name, Known), or
%   width(N, Wanted)

generated([], _).
generated([in(Pattern, Source)|Generators], Folder) :-
    value(Source, Folder, Pattern),
    generated(Generators, Folder).

value(..(Low, High), _, V) :-
    whole_range(..(Low, High), Low, High, V).
value(between(Low, High), _, V) :-
    whole_range(between(Low, High), Low, High, V).
value(between(Low, High, Step), _, V) :-
    (   number(Low),
        number(High)
    ->  true
    ;   generator_error(range(between(Low, High, Step)))
    ),
    (   number(Step),
        Step > 0
    ->  true
    ;   generator_error(steps(Step))
    ),
    First is rationalize(Low),
    By is rationalize(Step),
    N is floor((rationalize(High)-First)/By),
    few_values(N+1),
    between(0, N, I),
    Exact is First + I*By,
    (   integer(Exact)
    ->  V = Exact
    ;   V is float(Exact)
    ).
value([Value|Values], _, V) :-
    member(V, [Value|Values]).
value(glob(Pattern), Folder, File) :-
    globbed(Pattern, Folder, Files),
    member(File, Files).
value(rows(File, Columns), Folder, Values) :-
    row(File, Folder, Columns, Values).

whole_range(Source, Low, High, V) :-
    (   integer(Low),
        integer(High)
    ->  few_values(High-Low+1),
        between(Low, High, V)
    ;   generator_error(range(Source))
    ).

few_values(Number) :-
    Count is Number,
    limit_value(values, Most),
    (   Count =< Most
    ->  true
    ;   generator_error(limit(values, Count, Most))
    ).

generator_error(What) :-
    throw(generator_error(What)).

%   globbed(Pattern, Folder, Files): their names as seen from Folder.

globbed(Pattern, Folder, Files) :-
    working_directory(Here, Folder),
    call_cleanup(expand_file_name(Pattern, Found),
                 working_directory(_, Here)),
    (   in_folder(Folder, Found, Files0),
        Files0 \== []
    ->  sort(Files0, Files)
    ;   generator_error(glob(Pattern))
    ).

%   expand_file_name/2 gives back what is no pattern, there or not.

in_folder(Folder, Found, Files) :-
    findall(File,
            ( member(File, Found),
              file_in(Folder, File, Path),
              exists_file(Path) ),
            Files).

file_in(Folder, File, Path) :-
    (   is_absolute_file_name(File)
    ->  Path = File
    ;   path_in(Folder, File, Path)
    ).

path_in(Folder, File, Path) :-
    atomic_list_concat([Folder, /, File], Path).


                /*******************************
                *             ROWS             *
                *******************************/

%   row(File, Folder, Columns, Values) is nondet: one line after the other.

row(File0, Folder, Columns, Values) :-
    atom_string(File, File0),
    file_in(Folder, File, Path),
    (   exists_file(Path),
        access_file(Path, read)
    ->  true
    ;   generator_error(rows(File, 0, missing))
    ),
    file_name_extension(_, Ending, File),
    table_form(Ending, Path, Separator, Point),
    csv_options(Csv, [ separator(Separator), strip(true), functor(row),
                       match_arity(false) ]),
    setup_call_cleanup(
        open(Path, read, In, [encoding(utf8), bom(true)]),
        ( next_row(File, In, Csv, Header),
          column_places(Columns, Header, File, Places),
          rows_after(File, In, Csv, Header, Row),
          maplist(of_row(Row, Point), Places, Values) ),
        close(In)).

%   table_form(Ending, Path, Separator, Point): what stands between the fields
%   of a table, and its decimal point. Where that is a comma, spreadsheets put
%   semicolons between the fields: so if the first line has one, and no comma.

table_form(tsv, _, 0'\t, point) :-
    !.
table_form(_, Path, Separator, Point) :-
    setup_call_cleanup(
        open(Path, read, In, [encoding(octet)]),
        read_line_to_string(In, Line),
        close(In)),
    (   string(Line),
        sub_string(Line, _, _, _, ";"),
        \+ sub_string(Line, _, _, _, ",")
    ->  Separator = 0';,
        Point = comma
    ;   Separator = 0',,
        Point = point
    ).

rows_after(File, In, Csv, Header, Row) :-
    repeat,
    line_count(In, Line),
    next_row(File, In, Csv, Row0),
    (   Row0 == end_of_file
    ->  !,
        fail
    ;   empty_row(Row0)
    ->  fail
    ;   compound_name_arity(Row0, _, N),
        compound_name_arity(Header, _, Wanted),
        (   N =:= Wanted
        ->  Row = Row0
        ;   generator_error(rows(File, Line, width(N, Wanted)))
        )
    ).

%   next_row(File, In, Csv, Row): csv_read_row/3 takes a quote without its end
%   for the end of the file.

next_row(File, In, Csv, Row) :-
    line_count(In, Line),
    retractall(undecoded),
    (   at_end_of_stream(In)
    ->  Row = end_of_file
    ;   setup_call_cleanup(
            asserta(decoding(In)),
            catch(csv_read_row(In, Row0, Csv), error(_, _), fail),
            retractall(decoding(_))),
        Row0 \== end_of_file
    ->  (   undecoded
        ->  generator_error(rows(File, Line, not_utf8))
        ;   Row = Row0
        )
    ;   generator_error(rows(File, Line, no_table))
    ).

%   Prolog warns of octets that are no UTF-8, and reads something else.

:- dynamic decoding/1, undecoded/0.
:- multifile user:message_hook/3.

user:message_hook(io_warning(In, _), warning, _) :-
    sg_generator:wrong_octets(In).

:- public wrong_octets/1.

wrong_octets(In) :-
    decoding(In),
    assertz(undecoded).

empty_row(row('')).

column_places(_, end_of_file, File, _) :-
    !,
    generator_error(rows(File, 1, no_table)).
column_places(Columns, Header, File, Places) :-
    compound_name_arguments(Header, _, Names0),
    maplist(text_atom, Names0, Names),
    maplist(column_place(Names, File), Columns, Places).

column_place(Names, File, Column0, Place) :-
    text_atom(Column0, Column),
    (   nth1(Place0, Names, Column)
    ->  Place = Place0
    ;   generator_error(rows(File, 1, no_column(Column, Names)))
    ).

text_atom(Text, Atom) :-
    format(atom(Atom), '~w', [Text]).

of_row(Row, Point, Place, Value) :-
    arg(Place, Row, Value0),
    (   Point == comma,
        atom(Value0),
        atomic_list_concat([Whole,Part], ',', Value0),
        atomic_list_concat([Whole,Part], '.', Text),
        decimal_number(Text, Number)
    ->  Value = Number
    ;   Value = Value0
    ).
