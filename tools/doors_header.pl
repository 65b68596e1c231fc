/* doors/TOPIC.h: the types and prototypes of a topic. See doors.pl. */
:- module(sg_doors_header,
          [ header/2                  % +Topic, +Doors
          ]).
:- use_module(library(lists)).
:- use_module(doors_declared).

header(Topic, Doors) :-
    upcase_atom(Topic, Upper),
    format("/* Made by tools/doors.pl from rules/kernel/~w.pl. */~n", [Topic]),
    format("#ifndef SG_DOORS_~w_H~n#define SG_DOORS_~w_H~n~n", [Upper,Upper]),
    format("#include \"call.h\"~n~n"),
    used(Doors, [+,-,?], Types),
    forall(member(Type, Types), header_type(Type)),
    forall(member(Door, Doors), prototype(Door)),
    format("#endif~n").

header_type(Type) :-
    (   declared(Type)
    ->  type_name(Type, Name),
        format("#ifndef SG_DOOR_TYPE_~w~n#define SG_DOOR_TYPE_~w~n",
               [Name,Name]),
        declaration(Type),
        format("#endif~n~n")
    ;   true
    ).

declared(list(Type)) :-
    !,
    c_list(Type, List),
    \+ memberchk(List, [ sg_int_list, sg_count_list, sg_number_list,
                         sg_integer_list
                       ]).
declared(Type) :-
    type(Type, _).

declaration(list(Type)) :-
    !,
    c_type(Type, CType),
    c_list(Type, List),
    format("SG_CALL_LIST(~w, ~w);~n", [List,CType]).
declaration(Type) :-
    type(Type, What),
    declaration(What, Type).

declaration(handle(Struct,Free,_), _) :-
    format("typedef struct ~w ~w;~nvoid ~w(~w *object);~n",
           [Struct,Struct,Free,Struct]).
declaration(words(-,_,Words), Type) :-
    format("enum {~n"),
    forall(member(Word, Words), enumerator(Type, Word)),
    format("};~n").
declaration(words(Enum,Header,_), _) :-
    Enum \== (-),
    format("#include \"~w\"~n", [Header]).
declaration(dict(Struct,Fields), Type) :-
    declaration(record(Struct,-,_,Fields), Type).
declaration(record(Struct,-,_,Fields), _) :-
    !,
    format("typedef struct ~w {~n", [Struct]),
    forall(member(Field, Fields), field(Field)),
    format("} ~w;~n", [Struct]).
declaration(record(_,Header,_,_), _) :-
    format("#include \"~w\"~n", [Header]).
declaration(either(Struct,Alternatives), Type) :-
    format("typedef struct ~w {~n  enum {~n", [Struct]),
    forall(member(Alternative, Alternatives),
           ( alternative_name(Alternative, Name),
             enumerator(Type, Name) )),
    format("  } is;~n  union {~n"),
    forall(( member(Alternative, Alternatives), compound(Alternative) ),
           alternative(Alternative)),
    format("  };~n} ~w;~n", [Struct]).

enumerator(Type, Word) :-
    enumerator_name(Type, Word, Name),
    format("  ~w,~n", [Name]).

alternative_name(Name:_, Name) :-
    !.
alternative_name(Alternative, Name) :-
    functor(Alternative, Name, _).

alternative(Field) :-
    Field = _:_,
    !,
    write("  "),
    field(Field).
alternative(Alternative) :-
    Alternative =.. [Name|Fields],
    format("    struct {~n"),
    forall(member(Field, Fields), field(Field)),
    format("    } ~w;~n", [Name]).

field(_:any) :-
    !.
field(Name:Type) :-
    c_type(Type, CType),
    format("  ~w ~w;~n", [CType,Name]).

prototype(door(Name,Arguments,_)) :-
    closes(Name, Arguments, _),
    !.
prototype(door(Name,Arguments,nondet)) :-
    !,
    row_columns(Arguments, Columns),
    format("typedef struct sg_~w_row {~n", [Name]),
    forall(member(Column, Columns), field(Column)),
    format("} sg_~w_row;~n~nSG_CALL_LIST(sg_~w_rows, sg_~w_row);~n~n",
           [Name,Name,Name]),
    format("bool sg_door_~w(sg_call *call", [Name]),
    forall(( member(Argument, Arguments), \+ Argument = arg(-,_,_) ),
           ( parameter(Argument, Parameter),
             format(", ~w", [Parameter]) )),
    format(", sg_~w_rows *rows);~n~n", [Name]).
prototype(door(Name,Arguments,_)) :-
    format("bool sg_door_~w(sg_call *call", [Name]),
    forall(member(Argument, Arguments),
           ( parameter(Argument, Parameter),
             format(", ~w", [Parameter]) )),
    format(");~n~n").

parameter(arg(-,Name,Type), Parameter) :-
    c_type(Type, CType),
    format(atom(Parameter), "~w *~w", [CType,Name]).
parameter(arg(?,Name,Type), Parameter) :-
    c_type(Type, CType),
    format(atom(Parameter), "const ~w *~w", [CType,Name]).
parameter(arg(+,Name,Type), Parameter) :-
    c_type(Type, CType),
    (   by_value(Type)
    ->  format(atom(Parameter), "~w ~w", [CType,Name])
    ;   format(atom(Parameter), "const ~w *~w", [CType,Name])
    ).
