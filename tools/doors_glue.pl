/* doors.c: readers and writers of types, what calls each function, and their
   registration. See doors.pl.
*/
:- module(sg_doors_glue,
          [ glue/1                    % +Topics
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(doors_declared).

glue(Topics) :-
    format("/* Made by tools/doors.pl from rules/kernel/ and doors.def. */~n"),
    format("#include \"door.h\"~n#include \"engine/install.h\"~n~n"),
    forall(member(topic(Topic,_), Topics),
           format("#include \"doors/~w.h\"~n", [Topic])),
    findall(Door, ( member(topic(_,Doors), Topics), member(Door, Doors) ), All),
    used(All, [+,-,?], Types),
    used(All, [+,?], In),
    used(All, [-,?], Out),
    forall(member(Type, Types), names(Type)),
    forall(( member(Type, In), is_handle(Type), is_nested(In, Type) ),
           handle_reader(Type)),
    forall(member(Type, In), reader(Type)),
    forall(member(Type, Out), writer(Type)),
    forall(member(Door, All), wrapper(Door)),
    install(Topics, Types).

%   names(Type): its atoms, functors or kind of handle.

names(Type) :-
    type(Type, What),
    !,
    names(What, Type).
names(_).

names(handle(Struct,Free,_), Type) :-
    format("~nstatic void~nfree_~w(void *object)~n{~n", [Type]),
    format("  ~w((~w *)object);~n}~n", [Free,Struct]),
    format("extern sg_handle_type sg_handle_type_~w;~n", [Type]),
    format("sg_handle_type sg_handle_type_~w =~n", [Type]),
    format("  SG_HANDLE_TYPE(\"~w\", free_~w);~n", [Type,Type]).
names(words(_,_,Words), Type) :-
    length(Words, N),
    format("~nstatic atom_t word_~w[~d];~n", [Type,N]).
names(record(_,_,_,_), Type) :-
    format("~nstatic functor_t functor_~w;~n", [Type]).
names(dict(_,Fields), Type) :-
    length(Fields, N),
    format("~nstatic atom_t word_~w[~d];~n", [Type,N]).
names(either(_,Alternatives), Type) :-
    length(Alternatives, N),
    format("~nstatic atom_t word_~w[~d];~n", [Type,N]),
    (   member(Alternative, Alternatives),
        compound(Alternative),
        \+ Alternative = _:_
    ->  format("static functor_t functor_~w[~d];~n", [Type,N])
    ;   true
    ).

%   handle_reader(Type): get_TYPE(), of a handle inside of something else, which
%   is in use until the call is closed.

handle_reader(Type) :-
    c_type(Type, CType),
    format("~nstatic int~nget_~w(sg_call *call, term_t t, ~w*out)~n{~n",
           [Type,CType]),
    format("  void *object;~n~n"),
    format("  if (!sg_handle_hold(call, t, &sg_handle_type_~w, &object)) {~n",
           [Type]),
    format("    return FALSE;~n  }~n  *out = object;~n  return TRUE;~n}~n").

%   reader(Type): get_TYPE(), of what is no simple type.

reader(list(Type)) :-
    !,
    type_name(Type, Name),
    c_list(Type, List),
    format("~nSG_DOOR_GET_LIST(~w, ~w, get_~w)~n", [Name,List,Name]).
reader(Type) :-
    type(Type, What),
    \+ What = handle(_,_,_),
    !,
    c_type(Type, CType),
    format("~nstatic int~nget_~w(sg_call *call, term_t t, ~w *out)~n{~n",
           [Type,CType]),
    reader(What, Type),
    format("}~n").
reader(_).

reader(words(_,_,Words), Type) :-
    length(Words, N),
    c_type(Type, CType),
    format("  int k = sg_door_word(t, word_~w, ~d, \"~w\");~n~n",
           [Type,N,Type]),
    format("  (void)call;~n"),
    format("  *out = (~w)(k < 0 ? 0 : k);~n  return k >= 0;~n", [CType]).
reader(record(_,_,Name0,Fields), Type) :-
    (   Name0 == (-)
    ->  Name = pair
    ;   Name = Name0
    ),
    format("  term_t a = PL_new_term_ref();~n~n"),
    format("  return sg_door_functor(t, functor_~w, \"~w\")", [Type,Name]),
    foldl(read_field(out), Fields, 1, _),
    format(";~n").
reader(either(_,Alternatives), Type) :-
    format("  atom_t name;~n  size_t arity;~n"),
    format("  term_t a = PL_new_term_ref();~n~n"),
    format("  (void)call;~n  (void)a;~n  if (PL_is_variable(t)) {~n"),
    format("    return PL_instantiation_error(t);~n  }~n"),
    format("  if (PL_get_name_arity(t, &name, &arity)) {~n"),
    foldl(read_alternative(Type), Alternatives, 0, _),
    format("  }~n"),
    (   memberchk(Member:Of, Alternatives)
    ->  enumerator_name(Type, Member, Enumerator),
        type_name(Of, Name),
        format("  out->is = ~w;~n", [Enumerator]),
        format("  return get_~w(call, t, &out->~w);~n", [Name,Member])
    ;   format("  return PL_type_error(\"~w\", t);~n", [Type])
    ).

read_field(_, _:any, I0, I) :-
    !,
    I is I0+1.
read_field(Struct, Member:Type, I0, I) :-
    type_name(Type, Name),
    format(" &&~n         PL_get_arg(~d, t, a) && get_~w(call, a, &~w->~w)",
           [I0,Name,Struct,Member]),
    I is I0+1.

read_alternative(_, _:_, K, K) :-
    !.
read_alternative(Type, Alternative, K0, K) :-
    K is K0+1,
    Alternative =.. [Name|Fields],
    length(Fields, Arity),
    enumerator_name(Type, Name, Enumerator),
    format("    if (name == word_~w[~d] && arity == ~d) {~n", [Type,K0,Arity]),
    format("      out->is = ~w;~n      return TRUE", [Enumerator]),
    format(atom(Member), "out->~w.", [Name]),
    foldl(read_alternative_field(Member), Fields, 1, _),
    format(";~n    }~n").

read_alternative_field(Member, Field:Type, I0, I) :-
    type_name(Type, Name),
    format(" &&~n             PL_get_arg(~d, t, a) && get_~w(call, a, &~w~w)",
           [I0,Name,Member,Field]),
    I is I0+1.

%   writer(Type): put_TYPE(); words are passed by value, others by address.

writer(list(Type)) :-
    is_handle(Type),
    !,
    c_list(Type, List),
    format("~nSG_DOOR_PUT_HANDLES(~w, ~w)~n", [Type,List]).
writer(list(Type)) :-
    !,
    type_name(Type, Name),
    c_list(Type, List),
    element(Type, Put),
    format("~nSG_DOOR_PUT_LIST(~w, ~w, ~w)~n", [Name,List,Put]).
writer(Type) :-
    type(Type, What),
    \+ What = handle(_,_,_),
    !,
    c_type(Type, CType),
    (   by_value(Type)
    ->  format("~nstatic int~nput_~w(term_t t, ~w x)~n{~n", [Type,CType])
    ;   format("~nstatic int~nput_~w(term_t t, const ~w *x)~n{~n", [Type,CType])
    ),
    writer(What, Type),
    format("}~n").
writer(_).

writer(words(_,_,_), Type) :-
    format("  return PL_put_atom(t, word_~w[x]);~n", [Type]).
writer(record(_,_,_,Fields), Type) :-
    write_fields(Fields, "x->", "  "),
    format("PL_cons_functor_v(t, functor_~w, a);~n", [Type]).
writer(dict(_,Fields), Type) :-
    length(Fields, N),
    write_fields(Fields, "x->", "  "),
    format("PL_put_dict(t, 0, ~d, word_~w, a);~n", [N,Type]).
writer(either(_,Alternatives), Type) :-
    format("  switch (x->is) {~n"),
    foldl(write_alternative(Type), Alternatives, 0, _),
    format("  }~n  return FALSE;~n").

element(Type, Put) :-
    type_name(Type, Name),
    (   by_value(Type)
    ->  format(atom(Put), "put_~w", [Name])
    ;   format(atom(Put), "put_~w_of", [Name]),
        format("#define ~w(t, x) put_~w(t, &(x))~n", [Put,Name])
    ).

write_fields(Fields, Struct, Indent) :-
    length(Fields, N),
    format("~wterm_t a = PL_new_term_refs(~d);~n~n~wreturn ",
           [Indent,N,Indent]),
    foldl(write_field(Struct), Fields, 0, _).

write_field(Struct, Member:Type, I0, I) :-
    I is I0+1,
    format(string(Term), "a + ~d", [I0]),
    put_call(Type, Term, Struct, Member).

put_call(Type, Term, Struct, Member) :-
    type_name(Type, Name),
    (   by_value(Type)
    ->  format("put_~w(~w, ~w~w) && ", [Name,Term,Struct,Member])
    ;   format("put_~w(~w, &~w~w) && ", [Name,Term,Struct,Member])
    ).

write_alternative(Type, Member:Of, K, K) :-
    !,
    enumerator_name(Type, Member, Enumerator),
    format("  case ~w:~n    return ", [Enumerator]),
    put_call(Of, t, "x->", Member),
    format("TRUE;~n").
write_alternative(Type, Alternative, K0, K) :-
    K is K0+1,
    Alternative =.. [Name|Fields],
    enumerator_name(Type, Name, Enumerator),
    (   Fields == []
    ->  format("  case ~w:~n    return PL_put_atom(t, word_~w[~d]);~n",
               [Enumerator,Type,K0])
    ;   format("  case ~w: {~n", [Enumerator]),
        format(string(Struct), "x->~w.", [Name]),
        write_fields(Fields, Struct, "    "),
        format("PL_cons_functor_v(t, functor_~w[~d], a);~n  }~n", [Type,K0])
    ).


                /*******************************
                *           WRAPPERS           *
                *******************************/

wrapper(door(Name,Arguments,nondet)) :-
    !,
    answerer(Name, Arguments),
    asker(Name, Arguments),
    prolog_function(Name, Arguments),
    findall(Bit, ( nth0(I, Arguments, arg(Mode,_,_)), Mode \== (+),
                   Bit is 1<<I ), Bits),
    sum_list(Bits, Outputs),
    format("  return sg_door_answer(t0, ~d, control, ", [Outputs]),
    format("ask_~w, answer_~w);~n}~n", [Name,Name]).
wrapper(door(Name,Arguments,_)) :-
    prolog_function(Name, Arguments),
    format("  (void)control;~n"),
    (   closes(Name, Arguments, Type)
    ->  format("  return (foreign_t)sg_handle_close(t0, &sg_handle_type_~w);~n",
               [Type])
    ;   wrapped(Name, Arguments)
    ),
    format("}~n").

prolog_function(Name, Arguments) :-
    length(Arguments, Arity),
    format("~nstatic foreign_t~n~w_~d(term_t t0, int arity, ", [Name,Arity]),
    format("control_t control)~n{~n  (void)arity;~n").

%   Of a nondeterministic door: ask_NAME() finds all answers, answer_NAME() is
%   one of them.

asker(Name, Arguments) :-
    format("~nstatic int~nask_~w(sg_call *call, term_t t0, void *rows, ",
           [Name]),
    format("size_t *n)~n{~n"),
    inputs(Arguments),
    format("  int done = "),
    conjunction(Arguments, input),
    format("sg_door_~w(call", [Name]),
    forall(( nth0(I, Arguments, arg(Mode,_,Type)), Mode \== (-) ),
           passed(Mode, Type, I)),
    format(", rows);~n~n"),
    finish(Arguments),
    format("  (void)t0;~n  *n = ((const sg_~w_rows *)rows)->n;~n", [Name]),
    format("  return done;~n}~n").

answerer(Name, Arguments) :-
    format("~nstatic int~nanswer_~w(term_t t0, const void *rows, ", [Name]),
    format("size_t i)~n{~n  const sg_~w_rows *all = rows;~n", [Name]),
    format("  const sg_~w_row *x = &all->at[i];~n", [Name]),
    term_to_put(Arguments),
    format("~n  return "),
    forall(( nth0(I, Arguments, arg(Mode,Member,Type)), Mode \== (+) ),
           ( atom_concat('x->', Member, Value),
             unified(Type, I, Value),
             format("         ") )),
    format("TRUE;~n}~n").

%   unified(Type, I, Value): the I-th argument is Value, a C expression.

unified(Type, I, Value) :-
    is_integral(Type),
    !,
    format("PL_unify_int64(t0 + ~d, (int64_t)(~w)) &&~n", [I,Value]).
unified(Type, I, Value) :-
    type_name(Type, Name),
    (   by_value(Type)
    ->  Address = ''
    ;   Address = '&'
    ),
    format("put_~w(r, ~w~w) && PL_unify(t0 + ~d, r) &&~n",
           [Name,Address,Value,I]).

is_integral(Type) :-
    memberchk(Type, [id,int,count,integer]).

%   term_to_put(Arguments): `r`, if one is made to be unified.

term_to_put(Arguments) :-
    (   member(arg(Mode,_,Type), Arguments),
        Mode \== (+),
        \+ is_handle(Type),
        \+ is_integral(Type)
    ->  format("  term_t r = PL_new_term_ref();~n")
    ;   true
    ).

inputs(Arguments) :-
    forall(( nth0(I, Arguments, arg(Mode,_,Type)), Mode \== (-) ),
           variable(Mode, Type, I)).

wrapped(Name, Arguments) :-
    format("  sg_call here, *call = &here;~n"),
    term_to_put(Arguments),
    forall(nth0(I, Arguments, arg(Mode,_,Type)), variable(Mode, Type, I)),
    format("~n  sg_door_open(call);~n"),
    format("  int done = "),
    conjunction(Arguments, input),
    format("sg_door_~w(call", [Name]),
    forall(nth0(I, Arguments, arg(Mode,_,Type)), passed(Mode, Type, I)),
    format(") && "),
    conjunction(Arguments, output),
    format("TRUE;~n~n"),
    finish(Arguments),
    format("  return sg_door_close(call, t0, done);~n").

variable(+, Type, I) :-
    type(Type, handle(_,_,_)),
    !,
    format("  sg_handle *x~d = NULL;~n", [I]).
variable(Mode, Type, I) :-
    c_type(Type, CType),
    format("  ~w x~d = {0};~n", [CType,I]),
    (   Mode == (?)
    ->  format("  const ~w *given~d = NULL;~n", [CType,I])
    ;   true
    ).

%   Handles are unified first: they are owned then.

conjunction(Arguments, What) :-
    forall(( nth0(I, Arguments, arg(Mode,_,Type)), has_handles(Type) ),
           conjunct(What, Mode, Type, I)),
    forall(( nth0(I, Arguments, arg(Mode,_,Type)), \+ has_handles(Type) ),
           conjunct(What, Mode, Type, I)).

has_handles(list(Type)) :-
    !,
    is_handle(Type).
has_handles(Type) :-
    is_handle(Type).

conjunct(input, +, Type, I) :-
    !,
    type_name(Type, Name),
    (   is_handle(Type)
    ->  format("sg_handle_get(t0 + ~d, &sg_handle_type_~w, &x~d) &&~n    ",
               [I,Type,I])
    ;   format("get_~w(call, t0 + ~d, &x~d) &&~n    ", [Name,I,I])
    ).
conjunct(input, ?, Type, I) :-
    !,
    type_name(Type, Name),
    format("(PL_is_variable(t0 + ~d) ||~n     ", [I]),
    format("(get_~w(call, t0 + ~d, &x~d) && (given~d = &x~d))) &&~n    ",
           [Name,I,I,I,I]).
conjunct(output, -, Type, I) :-
    !,
    (   is_handle(Type)
    ->  format("sg_handle_unify(t0 + ~d, &sg_handle_type_~w, x~d) &&~n",
               [I,Type,I])
    ;   atom_concat(x, I, Value),
        unified(Type, I, Value)
    ),
    format("    ").
conjunct(_, _, _, _).

passed(+, Type, I) :-
    by_value(Type),
    !,
    (   is_handle(Type)
    ->  format(", x~d->object", [I])
    ;   format(", x~d", [I])
    ).
passed(?, _, I) :-
    !,
    format(", given~d", [I]).
passed(_, _, I) :-
    format(", &x~d", [I]).

finish(Arguments) :-
    forall(( nth0(I, Arguments, arg(+,_,Type)), is_handle(Type) ),
           format("  sg_handle_done(x~d);~n", [I])).


                /*******************************
                *         REGISTRATION         *
                *******************************/

install(Topics, Types) :-
    format("~nvoid~nsg_install_doors(void)~n{~n"),
    forall(( member(Type, Types), type(Type, What) ),
           install_type(What, Type)),
    forall(( member(topic(Topic,Doors), Topics), Doors \== [] ),
           install_topic(Topic, Doors)),
    format("}~n").

install_type(handle(_,_,_), _).
install_type(words(_,_,Words), Type) :-
    foldl(install_word(Type), Words, 0, _).
install_type(record(_,_,Name,Fields), Type) :-
    length(Fields, Arity),
    format("  functor_~w = PL_new_functor(PL_new_atom(\"~w\"), ~d);~n",
           [Type,Name,Arity]).
install_type(dict(_,Fields), Type) :-
    findall(Key, member(Key:_, Fields), Keys),
    foldl(install_word(Type), Keys, 0, _).
install_type(either(_,Alternatives), Type) :-
    foldl(install_alternative(Type), Alternatives, 0, _).

install_word(Type, Word, K0, K) :-
    format("  word_~w[~d] = PL_new_atom(\"~w\");~n", [Type,K0,Word]),
    K is K0+1.

install_alternative(_, _:_, K, K) :-
    !.
install_alternative(Type, Alternative, K0, K) :-
    functor(Alternative, Name, Arity),
    install_word(Type, Name, K0, K),
    (   Arity > 0
    ->  format("  functor_~w[~d] = PL_new_functor(word_~w[~d], ~d);~n",
               [Type,K0,Type,K0,Arity])
    ;   true
    ).

install_topic(Topic, Doors) :-
    format("~n  static const PL_extension ~w[] = {~n", [Topic]),
    forall(member(door(Name,Arguments,Determinism), Doors),
           ( length(Arguments, Arity),
             flags(Determinism, Flags),
             format("    {\"~w\", ~d, (pl_function_t)~w_~d, ~w},~n",
                    [Name,Arity,Name,Arity,Flags])
           )),
    format("    {NULL, 0, NULL, 0}};~n"),
    format("  PL_register_extensions_in_module(\"sg_kernel_~w\", ~w);~n",
           [Topic,Topic]).

flags(nondet, 'PL_FA_VARARGS | PL_FA_NONDETERMINISTIC') :- !.
flags(_,      'PL_FA_VARARGS').
