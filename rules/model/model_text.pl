:- module(sg_model_text,
          [ model_text_bytes/3,         % +Text, -Done, -Total
            next_fact/3,                % +Text, -Fact, -Place
            next_written/3,             % +Text, -Written, -Place
            first_fact_checked/1,       % +Text
            formed_fact/4,              % +Term, :Known, +Place, -Fact
            world_parameter/2,          % ?Name, -Value
            next_term/3,                % +Text, -Term, -Place
            next_term/5,                % +Text, +Syntax, -Term, -Names, -Place
            checked_fact/3,             % +Term, +Place, -Fact
            no_fact/2,                  % +Term, -What
            place_error/2,              % +Place, +What
            place_error/3,              % +Place, +Argument, +What
            place_location/3,           % +Place, +Argument, -Location
            model_float/2               % +Value, -Float
          ]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../decimal', [decimal_comma/4]).
:- use_module('../kernel', [id_list/2, plain_value/2]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../plain', [cut_term/2]).
:- use_module('../text_file', [with_text_again/3]).
:- use_module('../formula', [formed/3, formula_parameter/2, has_formula/1]).
:- use_module('../store',
              [param/2, relation/3, relation_column/5, column_domain/3]).
:- use_module(formula_term, [formed_term/3, formed_wish/3]).
:- use_module(look_term, [is_look/1, is_light/1, look_expected/2]).
:- use_module(library(lists), [member/2]).
/** <module> The text of a model file: facts, each checked against the schema.

A model file is DATA. Its terms are read, never run: a directive or a rule is
an error, as is everything that is no fact of a relation of the schema. Terms
are read in a module that has only the operators of Prolog itself, so nothing
that is loaded can change what a file means.

Besides the relations of the schema there is one fact that only files use:
`curve(S, [V1, V2, ...])`, a chain of edges (PL-4). The relations of the
picture (screen/5, contour/13, surface_facing/6, drawn/7, span/7) are computed
and may not stand in a file.

Every error is error(model_error(What), location(File, Line, Column)), lines
and columns counted from 1. What is one of

    cannot_read(Why)  syntax(Message)  limit(Name, Most)  early_end
    directive(Goal)  rule(Head)  no_fact(Term)
    unknown_relation(Name, Arity)  arity(Name, Given, Wanted)  computed(Name)
    value(Relation, Column, Value, Expected)
    formula(What, Formula)  parameter(decimal_comma(Call, Name, Point))

with Expected one of id, ids, steps, chain, float, finite, within(Most),
distance, number, atom, text, ground, one_of(Values), look(What) and
light(What); model_file.pl adds its
own.
*/

%   The module that terms are read in: `system` is its only import.

:- set_module(sg_model_syntax:base(system)).
:- set_prolog_flag(sg_model_syntax:double_quotes, string).

%!  model_text_bytes(+Text, -Done, -Total) is det.
%
%   Of the Total bytes of Text, Done are read.

model_text_bytes(text(_, Path, Stream), Done, Total) :-
    byte_count(Stream, Done),
    size_file(Path, Total).

%!  next_fact(+Text, -Fact, -Place) is det.
%
%   Fact is the next fact of Text, with floats where the schema wants floats,
%   or `end_of_file`. Place is where it stands, for place_error/2,3. Formulas
%   are over the parameters of the current world.

next_fact(Text, Fact, Place) :-
    next_written(Text, Written, Place),
    (   Written = waiting(Term)
    ->  formed_fact(Term, world_parameter, Place, Fact)
    ;   Fact = Written
    ).

%!  next_written(+Text, -Written, -Place) is det.
%
%   The same, but of a fact with formulas Written is waiting(Term), for
%   formed_fact/4.

next_written(Text, Written, Place) :-
    next_term(Text, Term, Place),
    (   Term == end_of_file
    ->  Written = end_of_file
    ;   checked_fact(Term, Place, Written)
    ).

%!  first_fact_checked(+Text) is det.
%
%   Nothing is wrong with the first fact of Text, which may end in it.
%
%   @error as next_fact/3

first_fact_checked(Text) :-
    Text = text(_, _, Stream),
    catch(next_written(Text, _, _), Error,
          (   at_end_of_stream(Stream)
          ->  true
          ;   throw(Error)
          )).

%!  world_parameter(?Name, -Value) is nondet.
%
%   The parameter Name of the current world.

world_parameter(Name, Value) :-
    param(Name, Value).

:- meta_predicate formed_fact(+, 2, +, -).

%!  formed_fact(+Term, :Known, +Place, -Fact) is det.
%
%   Fact is the fact Term at Place with the values of its formulas, checked.
%   Known as in formula_value/3.
%
%   @error model_error(What), at Place

formed_fact(Term, Known, Place, Fact) :-
    compound_name_arguments(Term, Name, Values0),
    length(Values0, Arity),
    relation_types(Name, Arity, Types),
    formed_arguments(Types, Values0, 1, Known, Place, Values1),
    checked_arguments(Types, Values1, 1, Name, Place, Values),
    compound_name_arguments(Fact, Name, Values).

formed_arguments([], [], _, _, _, []).
formed_arguments([column(Column, Type)|Types], [Value0|Values0], N, Known,
                 Place, [Value|Values]) :-
    (   waits(Type, Column, Value0)
    ->  catch(argument_formed(Column, Value0, Known, Value),
              error(model_error(What), _), place_error(Place, N, What))
    ;   Value = Value0
    ),
    N1 is N+1,
    formed_arguments(Types, Values0, N1, Known, Place, Values).

argument_formed(Column, Value0, Known, Value) :-
    (   Column == 'Name'
    ->  formed_term(Value0, Known, Value)
    ;   Column == 'Wish'
    ->  formed_wish(Value0, Known, Value)
    ;   formed(Value0, Known, Value)
    ).

%!  next_term(+Text, -Term, -Place) is det.
%
%   The same, whatever Term is.

next_term(Text, Term, Place) :-
    next_term(Text, sg_model_syntax, Term, _, Place).

%!  next_term(+Text, +Syntax, -Term, -Names, -Place) is det.
%
%   The same, read with the operators of the module Syntax; Names are
%   Name=Variable of its variables.

next_term(Text, Syntax, Term, Names, Place) :-
    Text = text(Name, Path, Stream),
    catch(read_term(Stream, Term,
                    [ module(Syntax), term_position(Position),
                      variable_names(Names), cycles(false), dotlists(false),
                      var_prefix(false), syntax_errors(error)
                    ]),
          Error, syntax_failure(Error, Name, Stream)),
    (   is_long(Stream, Position)
    ->  Place = place(Name, none, Position)
    ;   Place = place(Name, Path, Position)
    ),
    (   Term == end_of_file
    ->  at_real_end(Stream, Place)
    ;   true
    ).

%   is_long(Stream, Position): the fact from Position on, which was read, is so
%   long that it is not read a second time for the place of an argument.

is_long(Stream, Position) :-
    long_fact(Most),
    character_count(Stream, End),
    stream_position_data(char_count, Position, Start),
    End-Start > Most.

long_fact(1_000_000).

syntax_failure(error(syntax_error(Message), Where), Name, Stream) :-
    !,
    stream_location(Where, Stream, Line, Column),
    throw(error(model_error(syntax(Message)),
                location(Name, Line, Column))).
syntax_failure(error(resource_error(_), _), Name, Stream) :-
    !,
    line_count(Stream, Line),
    throw(error(model_error(syntax(too_deep)), location(Name, Line, 0))).
syntax_failure(error(io_error(read, _), _), Name, _) :-
    !,
    (   exists_directory(Name)
    ->  Why = directory
    ;   Why = io
    ),
    throw(error(model_error(cannot_read(Why)), location(Name, 0, 0))).
syntax_failure(Error, _, _) :-
    throw(Error).

%   Of a comment without an end Prolog says no line: it is the file's last one.

stream_location(Where, _, Line, Column) :-
    (   Where = stream(_, Line, Column0, _)
    ;   Where = file(_, Line, Column0, _)
    ),
    Line > 0,
    !,
    Column is Column0+1.
stream_location(_, Stream, Line, 0) :-
    line_count(Stream, Line).

%   A fact `end_of_file.` in the middle would hide the rest of the file.

at_real_end(Stream, Place) :-
    (   peek_char(Stream, end_of_file)
    ->  true
    ;   place_error(Place, early_end)
    ).


                /*******************************
                *             PLACES           *
                *******************************/

%!  place_error(+Place, +What).
%!  place_error(+Place, +Argument, +What).
%
%   Raise model_error(What) at the start of the fact, or at its Argument,
%   counted from 1. A Place `none` is no place. What quotes the text, which may
%   be long: cut_term/2 leaves the beginning of its lists.

place_error(Place, What0) :-
    cut_term(What0, What),
    Place = place(Name, _, Position),
    stream_position_data(line_count, Position, Line),
    stream_position_data(line_position, Position, Column0),
    Column is Column0+1,
    throw(error(model_error(What), location(Name, Line, Column))).

place_error(none, _, What0) :-
    !,
    cut_term(What0, What),
    throw(error(model_error(What), _)).
place_error(Place, Argument, What0) :-
    cut_term(What0, What),
    place_location(Place, Argument, Location),
    throw(error(model_error(What), Location)).

%!  place_location(+Place, +Argument, -Location) is det.
%
%   Location, location(File, Line, Column), is where that Argument begins, or
%   else the fact.

place_location(Place, Argument, location(Name, Line, Column)) :-
    Place = place(Name, _, Position),
    (   catch(argument_location(Place, Argument, Line0, Column0),
              error(_, _), fail)
    ->  Line = Line0,
        Column = Column0
    ;   stream_position_data(line_count, Position, Line),
        stream_position_data(line_position, Position, Before),
        Column is Before+1
    ).

%   The fact, if it is not long, is read once more, now with the positions of
%   its arguments; the characters up to the argument give line and column.

argument_location(place(_, Path, Position), Argument, Line, Column) :-
    Path \== none,
    with_text_again(
        Path, Stream,
        ( set_stream_position(Stream, Position),
          read_term(Stream, _, [ module(sg_model_syntax),
                                 subterm_positions(term_position(
                                     _, _, _, _, Places)) ]),
          nth_place(Argument, Places, From),
          set_stream_position(Stream, Position),
          stream_position_data(char_count, Position, Start),
          Skip is From-Start,
          forall(between(1, Skip, _), get_char(Stream, _)),
          line_count(Stream, Line),
          line_position(Stream, Column0),
          Column is Column0+1
        )).

nth_place(1, [Place|_], From) :-
    !,
    arg(1, Place, From).
nth_place(N, [_|Places], From) :-
    N1 is N-1,
    nth_place(N1, Places, From).


                /*******************************
                *            SCHEMA            *
                *******************************/

%!  checked_fact(+Term, +Place, -Fact) is det.
%
%   Fact is Term, a fact of the schema, with floats where it wants floats; or
%   waiting(Term), if there are formulas in it.
%
%   @error model_error(What), at Place

checked_fact(Term, Place, Fact) :-
    compound(Term),
    compound_name_arity(Term, Name, Arity),
    relation_types(Name, Arity, Types),
    !,
    compound_name_arguments(Term, Name, Arguments),
    (   any_waits(Types, Arguments)
    ->  Fact = waiting(Term)
    ;   checked_arguments(Types, Arguments, 1, Name, Place, Values),
        compound_name_arguments(Fact, Name, Values)
    ).
checked_fact(Term, Place, _) :-
    no_fact(Term, What),
    place_error(Place, What).

%!  no_fact(+Term, -What) is det.
%
%   Term is no fact of the schema; What says why not.

no_fact(Term, no_fact(Term)) :-
    \+ callable(Term),
    !.
no_fact((:- Goal), directive(Goal)) :-
    !.
no_fact((?- Goal), directive(Goal)) :-
    !.
no_fact((Head :- _), rule(Head)) :-
    !.
no_fact((Head --> _), rule(Head)) :-
    !.
no_fact((Head => _), rule(Head)) :-
    !.
no_fact(param(Name, Whole, Part), What) :-
    decimal_comma(Name, Whole, Part, Point),
    !,
    What = parameter(decimal_comma(param, Name, Point)).
no_fact(Term, What) :-
    name_arity(Term, Name, Arity),
    (   computed(Name)
    ->  What = computed(Name)
    ;   file_relation(Name, Wanted)
    ->  What = arity(Name, Arity, Wanted)
    ;   What = unknown_relation(Name, Arity)
    ).

%   As functor/3, also for a compound without arguments, `projection()`.

name_arity(Term, Name, Arity) :-
    compound(Term),
    !,
    compound_name_arity(Term, Name, Arity).
name_arity(Name, Name, 0).

computed(screen).
computed(contour).
computed(surface_facing).
computed(drawn).
computed(span).

file_relation(curve, 2).
file_relation(Name, Arity) :-
    relation(Name, Arity, _),
    Name \== formula,
    \+ computed(Name).

%   relation_types(Name, Arity, Types): column(Name, Type) of each argument of
%   the facts that may stand in a file.

:- dynamic relation_types_/3.

relation_types(Name, Arity, Types) :-
    (   relation_types_(Name, Arity, Types)
    ->  true
    ;   file_relation(Name, Arity),
        column_types(Name, Types),
        assertz(relation_types_(Name, Arity, Types))
    ).

column_types(curve, [column('S', id), column('Vs', chain)]) :-
    !.
column_types(Name, Types) :-
    findall(Position-column(Column, Type),
            ( relation_column(Name, Position, Column, Kind, _),
              file_type(Kind, Name, Position, Type) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    findall(Type, member(_-Type, Pairs), Types).

file_type(_, Name, Position, one_of(Values)) :-
    column_domain(Name, Position, Values),
    !.
file_type(int, _, _, id).
file_type(float, v, _, coordinate) :- !.
file_type(float, view, 2, distance) :- !.
file_type(float, _, _, float).
file_type(list, p, _, steps) :- !.
file_type(list, _, _, ids).
file_type(atom, question, _, words) :- !.
file_type(atom, _, _, atom).
file_type(term, title_block, _, text) :- !.
file_type(term, param, _, number) :- !.
file_type(term, lies_in, 1, loose) :- !.
file_type(term, lies_in, 2, around) :- !.
file_type(term, look, _, look) :- !.
file_type(term, light, _, light) :- !.
file_type(term, _, _, ground).

checked_arguments([], [], _, _, _, []).
checked_arguments([column(Column, Type)|Types], [Value0|Values0], N, Name,
                  Place, [Value|Values]) :-
    (   typed(Type, Value0, Value)
    ->  names_short(Column, Value, Place, N)
    ;   expected(Type, Value0, Expected),
        place_error(Place, N, value(Name, Column, Value0, Expected))
    ),
    N1 is N+1,
    checked_arguments(Types, Values0, N1, Name, Place, Values).

%   names_short(Column, Value, Place, N): no name in a Value of segments is
%   longer than a text may be, of however many words it is.

names_short('Name', Value, Place, N) :-
    compound(Value),
    limit_value(name, Most),
    long_name(Value, Most),
    !,
    place_error(Place, N, limit(name, Most)).
names_short(_, _, _, _).

long_name(named(Name, Inner), Most) :-
    !,
    (   compound(Name),
        \+ write_length(Name, _, [max_length(Most)])
    ->  true
    ;   long_name(Inner, Most)
    ).
long_name(at(_, Inner), Most) :-
    !,
    long_name(Inner, Most).
long_name(Term, Most) :-
    is_node_term(Term),
    arg(1, Term, Operands),
    is_list(Operands),
    member(Operand, Operands),
    long_name(Operand, Most),
    !.

%   any_waits(Types, Values): one of Values has a formula where Types takes one.

any_waits([column(Column, Type)|Types], [Value|Values]) :-
    (   compound(Value),
        waits(Type, Column, Value)
    ->  true
    ;   Value == pi,
        waits(Type, Column, Value)
    ->  true
    ;   any_waits(Types, Values)
    ).

waits(coordinate, _, Value) :-
    has_formula(Value).
waits(float, _, Value) :-
    has_formula(Value).
waits(distance, _, Value) :-
    has_formula(Value).
waits(number, _, Value) :-
    has_formula(Value).
waits(text, _, Value) :-
    compound(Value),
    has_formula(Value).
waits(ground, Column, Value) :-
    compound(Value),
    ground(Value),
    (   Column == 'Name'
    ->  has_formula(Value)
    ;   Column == 'Wish'
    ->  once(formula_parameter(Value, _))
    ).

%   typed(Type, Value0, Value): Value0 of the file becomes Value of the row.

typed(id, Id, Id) :-
    is_id(Id).
typed(coordinate, Value, Float) :-
    model_float(Value, Float),
    abs(Float) =< 1.0e90.
typed(float, Value, Float) :-
    model_float(Value, Float).
typed(distance, Value, Float) :-
    model_float(Value, Float),
    Float >= 0.0.
typed(number, Value, Value) :-
    model_float(Value, _).
typed(steps, Steps, Steps) :-
    id_list(Steps, -0x7fffffff).
typed(chain, Chain, Chain) :-
    Chain = [_|_],
    id_list(Chain, 1).
typed(ids, Ids, Ids) :-
    id_list(Ids, 1).
typed(one_of(Values), Value, Value) :-
    atomic(Value),
    memberchk(Value, Values).
typed(atom, Atom, Atom) :-
    atom(Atom).
typed(words, Text, Atom) :-
    ( atom(Text) ; string(Text) ),
    Text \== '',
    Text \== "",
    atom_string(Atom, Text).
typed(text, Text, Atom) :-
    string(Text),
    !,
    atom_string(Atom, Text).
typed(text, Text, Text) :-
    atomic(Text),
    plain_value(Text, 0),
    Text \== [].
typed(loose, Item, Item) :-
    is_item(Item, [v,e]).
typed(around, Item, Item) :-
    is_item(Item, [r,p]).
typed(look, Property, Property) :-
    is_look(Property).
typed(light, Property, Property) :-
    is_light(Property).
typed(ground, Term, Term) :-
    limit_value(depth, Depth),
    plain_value(Term, Depth).

is_item(Item, Names) :-
    compound(Item),
    compound_name_arguments(Item, Name, [Id]),
    memberchk(Name, Names),
    is_id(Id).

is_id(Id) :-
    integer(Id),
    Id > 0,
    Id =< 0x7fffffff.

%!  model_float(+Value, -Float) is semidet.
%
%   Float is the number Value, an integer or a finite float, as a float that
%   is not -0.0. Rationals, infinity and NaN fail.

model_float(Value, Float) :-
    float(Value),
    !,
    float_class(Value, Class),
    Class \== infinite,
    Class \== nan,
    Float is Value + 0.0.
model_float(Value, Float) :-
    integer(Value),
    catch(Float is float(Value), error(evaluation_error(_), _), fail).

%   expected(Type, Value, Expected): what the message says. NaN and infinity
%   are named for what they are.

expected(Type, Value, finite) :-
    float_type(Type),
    float(Value),
    \+ model_float(Value, _),
    !.
expected(coordinate, Value, within(1.0e90)) :-
    model_float(Value, _),
    !.
expected(coordinate, _, float) :-
    !.
expected(Type, Property, Expected) :-
    memberchk(Type, [look,light]),
    !,
    Expected =.. [Type,What],
    look_expected(Property, What).
expected(Type, _, Type).

float_type(coordinate).
float_type(float).
float_type(distance).
