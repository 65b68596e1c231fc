:- module(sg_openscad_text,
          [ read_openscad/2             % +File, -Nodes
          ]).
:- use_module(model_text, [open_model_text/3, close_model_text/1]).
:- use_module(library(lists), [append/3]).
:- use_module(library(readutil), [read_stream_to_codes/2]).
/** <module> The text of an OpenSCAD .csg file.

That is what `openscad -o FILE.csg` writes: a tree of calls with their numbers
worked out, no variables, no loops.

    difference() {
        cube(size = [2, 2, 2], center = true);
        multmatrix([[1,0,0,0], [0,1,0,0], [0,0,1,5], [0,0,0,1]]) { ... }
    }

Here it becomes nodes; openscad.pl says what they mean:

    node(Modifiers, Name, Arguments, Children, Place)

Modifiers is a list of `*`, `%`, `#`, `!`; Arguments are Name-Value, the name a
number where the file gives none; values are numbers, the atoms true, false,
undef, inf and nan, string(Text), and lists. Place is
location(File, Line, Column), both from 1.

Errors are error(model_error(openscad(What)), Place), What one of

    expected(Wanted, Found)   Wanted: name, `(`, `)`, body, value, `,`, end
    open_string   open_comment   strange(Character)

and cannot_read(Why) as for model files.
*/

%!  read_openscad(+File, -Nodes) is det.
%
%   Nodes are those at the top level of File (`-`: standard input), in order.
%
%   @error model_error(openscad(What)), see above

read_openscad(File, Nodes) :-
    open_model_text(csg, File, Text),
    setup_call_cleanup(
        true,
        ( Text = text(Name, _, Stream),
          read_stream_to_codes(Stream, Codes)
        ),
        close_model_text(Text)),
    tokens(Codes, at(Name, 1, 1), Tokens),
    top_nodes(Nodes, Tokens).

text_error(What, at(File, Line, Column)) :-
    throw(error(model_error(openscad(What)), location(File, Line, Column))).


                /*******************************
                *            TOKENS            *
                *******************************/

%   tokens(Codes, At, Tokens): Tokens are token(What, At) with What a
%   name(Atom), number(Number), string(Text), sign(Character) or `end`, At where
%   it begins.

tokens(Codes0, At0, Tokens) :-
    skipped(Codes0, At0, Codes1, At1),
    (   Codes1 == []
    ->  Tokens = [token(end, At1)]
    ;   token(What, Codes1, Codes2)
    ->  Tokens = [token(What, At1)|Tokens1],
        moved_on(Codes1, Codes2, At1, At2),
        tokens(Codes2, At2, Tokens1)
    ;   Codes1 = [0'"|_]
    ->  text_error(open_string, At1)
    ;   Codes1 = [Code|_],
        char_code(Character, Code),
        text_error(strange(Character), At1)
    ).

%   moved_on(Codes, Rest, At0, At): At is behind Codes up to Rest.

moved_on(Codes, Rest, At, At) :-
    same_term(Codes, Rest),
    !.
moved_on([Code|Codes], Rest, at(File, Line0, Column0), At) :-
    (   Code =:= 0'\n
    ->  Line is Line0+1,
        Column = 1
    ;   Line = Line0,
        Column is Column0+1
    ),
    moved_on(Codes, Rest, at(File, Line, Column), At).

%   skipped(Codes0, At0, Codes, At): behind white space and comments.

skipped(Codes0, At0, Codes, At) :-
    (   Codes0 = [Code|Codes1],
        code_type(Code, space)
    ->  moved_on(Codes0, Codes1, At0, At1),
        skipped(Codes1, At1, Codes, At)
    ;   Codes0 = [0'/, 0'/|Codes1]
    ->  line_end(Codes1, Codes2),
        moved_on(Codes0, Codes2, At0, At1),
        skipped(Codes2, At1, Codes, At)
    ;   Codes0 = [0'/, 0'*|Codes1]
    ->  (   append(_, [0'*, 0'/|Codes2], Codes1)
        ->  moved_on(Codes0, Codes2, At0, At1),
            skipped(Codes2, At1, Codes, At)
        ;   text_error(open_comment, At0)
        )
    ;   Codes = Codes0,
        At = At0
    ).

line_end(Codes0, Codes) :-
    (   Codes0 = [Code|Codes1],
        Code =\= 0'\n
    ->  line_end(Codes1, Codes)
    ;   Codes = Codes0
    ).

token(name(Name)) -->
    [First],
    { First =:= 0'$ ; code_type(First, csymf) },
    !,
    symbol_rest(Rest),
    { atom_codes(Name, [First|Rest]) }.
token(number(Number)) -->
    sign(Codes, Codes1),
    digits(Codes1, Codes2),
    { Codes1 \== Codes2 },
    fraction(Codes2, Codes3),
    exponent(Codes3, []),
    !,
    { numeral(Codes, Number) }.
token(number(Number)) -->
    sign([], _),
    `.`,
    digits(Digits, []),
    { Digits = [_|_] },
    exponent(Exponent, []),
    !,
    { append(Digits, Exponent, Rest),
      append(`0.`, Rest, Codes),
      number_codes(Number, Codes)
    }.
token(string(Text)) -->
    `"`,
    string_rest(Codes),
    !,
    { string_codes(Text, Codes) }.
token(sign(Character)) -->
    [Code],
    { memberchk(Code, `(){}[],;=*%#!-`),
      char_code(Character, Code)
    }.

symbol_rest([Code|Codes]) -->
    [Code],
    { code_type(Code, csym) },
    !,
    symbol_rest(Codes).
symbol_rest([]) -->
    [].

%   Parts of a number, as difference lists of their codes.

sign([0'-|Codes], Codes) -->
    `-`,
    !.
sign(Codes, Codes) -->
    [].

digits([Code|Codes0], Codes) -->
    [Code],
    { code_type(Code, digit) },
    !,
    digits(Codes0, Codes).
digits(Codes, Codes) -->
    [].

fraction([0'., Code|Codes0], Codes) -->
    `.`,
    [Code],
    { code_type(Code, digit) },
    !,
    digits(Codes0, Codes).
fraction(Codes, Codes) -->
    [].

exponent([0'e|Codes0], Codes) -->
    [E],
    { memberchk(E, `eE`) },
    exponent_sign(Codes0, Codes1),
    digits(Codes1, Codes),
    { Codes1 \== Codes },
    !.
exponent(Codes, Codes) -->
    [].

exponent_sign([Sign|Codes], Codes) -->
    [Sign],
    { memberchk(Sign, `+-`) },
    !.
exponent_sign(Codes, Codes) -->
    [].

%   numeral(Codes, Number): `1e5` has no point, which Prolog wants.

numeral(Codes, Number) :-
    (   append(Whole, [0'e|Exponent], Codes),
        \+ memberchk(0'., Whole)
    ->  append(`.0e`, Exponent, Rest),
        append(Whole, Rest, Codes1)
    ;   Codes1 = Codes
    ),
    catch(number_codes(Number0, Codes1), error(_, _), Number0 = inf),
    (   number(Number0),
        Number0 =:= 0
    ->  Number = 0
    ;   Number = Number0
    ).

string_rest([]) -->
    `"`,
    !.
string_rest([Code|Codes]) -->
    `\\`,
    !,
    [Code],
    string_rest(Codes).
string_rest([Code|Codes]) -->
    [Code],
    string_rest(Codes).


                /*******************************
                *             NODES            *
                *******************************/

top_nodes(Nodes, Tokens) :-
    nodes(Nodes, Tokens, Rest),
    Rest = [token(What, At)|_],
    (   What == end
    ->  true
    ;   not_expected(name, What, At)
    ).

nodes(Nodes) -->
    [token(sign(;), _)],
    !,
    nodes(Nodes).
nodes([Node|Nodes]) -->
    modifiers(Modifiers),
    named(Modifiers, Name, At),
    !,
    { At = at(File, Line, Column) },
    wanted('('),
    arguments(1, Arguments),
    body(Children),
    { Node = node(Modifiers, Name, Arguments, Children,
                  location(File, Line, Column)) },
    nodes(Nodes).
nodes([]) -->
    [].

modifiers([Modifier|Modifiers]) -->
    [token(sign(Modifier), _)],
    { memberchk(Modifier, [*, '%', #, !]) },
    !,
    modifiers(Modifiers).
modifiers([]) -->
    [].

%   named(Modifiers, Name, At)//: behind a modifier there has to be a name.

named(_, Name, At) -->
    [token(name(Name), At)],
    !.
named([_|_], _, _) -->
    refused(name).

body([]) -->
    [token(sign(;), _)],
    !.
body(Children) -->
    [token(sign('{'), _)],
    !,
    nodes(Children),
    wanted('}').
body(_) -->
    refused(body).

arguments(N, Arguments) -->
    (   [token(sign(')'), _)]
    ->  { Arguments = [] }
    ;   argument(N, Argument),
        { Arguments = [Argument|Arguments1] },
        more_arguments(N, Arguments1)
    ).

more_arguments(N, Arguments) -->
    (   [token(sign(','), _)]
    ->  { N1 is N+1 },
        arguments(N1, Arguments)
    ;   { Arguments = [] },
        wanted(')')
    ).

argument(_, Name-Value) -->
    [token(name(Name), _), token(sign(=), _)],
    !,
    value(Value).
argument(N, N-Value) -->
    value(Value).

value(Number) -->
    [token(number(Number), _)],
    !.
value(string(Text)) -->
    [token(string(Text), _)],
    !.
value(Name) -->
    [token(name(Name), _)],
    { memberchk(Name, [true, false, undef, inf, nan]) },
    !.
value(Value) -->
    [token(sign(-), _), token(name(Value), _)],
    { memberchk(Value, [inf, nan]) },
    !.
value(Values) -->
    [token(sign('['), _)],
    !,
    values(Values).
value(_) -->
    refused(value).

values(Values) -->
    (   [token(sign(']'), _)]
    ->  { Values = [] }
    ;   value(Value),
        { Values = [Value|Values1] },
        more_values(Values1)
    ).

more_values(Values) -->
    (   [token(sign(','), _)]
    ->  values(Values)
    ;   { Values = [] },
        wanted(']')
    ).

wanted(Sign) -->
    (   [token(sign(Sign), _)]
    ->  []
    ;   refused(Sign)
    ).

refused(Wanted, [token(What, At)|_], _) :-
    not_expected(Wanted, What, At).

not_expected(Wanted, What, At) :-
    (   What == end
    ->  Found = end
    ;   arg(1, What, Found)
    ),
    text_error(expected(Wanted, Found), At).
