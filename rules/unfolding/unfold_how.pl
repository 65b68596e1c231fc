:- module(sg_unfold_how,
          [ how_form/2,                 % ?Name, -Form
            how_given/3,                % +Name, +Wish, -Option
            how_wished/3,               % +S, +Options0, -Options
            how_wished_of_any/2         % ?Name, ?Option
          ]).
:- use_module('../store', [unfolding/2]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> How a part is to be unfolded, as the model says it.

Beside what is wanted of its polygons and edges (unfold_wish.pl) a fact
unfolding(S, Wish) may say of what plate segment S is made, whether it is
trimmed and that it is unrolled: so the model has it, and not the command.
Wish is one of

    true_lengths             what is round is unrolled (option true(true))
    trim(Side), set_in(Bool), other_thickness(T)
    thickness(T), size(Which), k_factor(K), bend_radius(R), relief(Which)
    seam(Degrees), generators(N), half(Bool), gores(N), zones(N)

with the meaning of the options of true_patterns/4 and unfold/3. An option that
is given itself counts before the fact.
*/

%   how_row(Name, Type, Needs, Form): Needs is what has to be said as well.

how_row(true_lengths, none, none, 'true_lengths').
how_row(trim, oneof([inside,outside]), none, 'trim(outside) or trim(inside)').
how_row(thickness, size, none, 'thickness(T), T from 0').
how_row(size, oneof([inside,middle,outside]), thickness,
        'size(inside), size(middle) or size(outside)').
how_row(k_factor, part, thickness, 'k_factor(K), K from 0 to 1').
how_row(bend_radius, size, thickness, 'bend_radius(R), R from 0').
how_row(relief, oneof([square,round,none]), thickness,
        'relief(square), relief(round) or relief(none)').
how_row(set_in, oneof([true,false]), trim, 'set_in(true)').
how_row(other_thickness, size, trim, 'other_thickness(T), T from 0').
how_row(seam, number, true_lengths, 'seam(Degrees)').
how_row(generators, count, true_lengths, 'generators(N), N from 2 to 3600').
how_row(gores, pieces, true_lengths, 'gores(N), N from 2 to 360').
how_row(zones, pieces, true_lengths, 'zones(N), N from 2 to 360').
how_row(half, oneof([true,false]), true_lengths, 'half(true)').

%!  how_form(?Name, -Form) is nondet.
%
%   Form is an atom that says how the wish Name is written.

how_form(Name, Form) :-
    how_row(Name, _, _, Form).

%!  how_given(+Name, +Wish, -Option) is semidet.
%
%   Wish, called Name, is well formed; Option says the same to unfold/3.

how_given(true_lengths, true_lengths, true(true)) :-
    !.
how_given(Name, Wish, Wish) :-
    how_row(Name, Type, _, _),
    compound(Wish),
    Wish =.. [Name,Value],
    of_type(Type, Value).

of_type(oneof(Values), Value) :-
    memberchk(Value, Values).
of_type(number, Value) :-
    number(Value).
of_type(size, Value) :-
    number(Value),
    Value >= 0.
of_type(part, Value) :-
    number(Value),
    Value >= 0,
    Value =< 1.
of_type(count, Value) :-
    integer(Value),
    between(2, 3600, Value).
of_type(pieces, Value) :-
    integer(Value),
    between(2, 360, Value).

%!  how_wished(+S, +Options0:list, -Options:list) is det.
%
%   Options are Options0, of unfold/3 or true_patterns/4, with what the facts
%   say of segment S besides.
%
%   @error model_error(unfold(S, Wish, needs(Form))): Wish says nothing without
%          one like Form

how_wished(S, Options0, Options) :-
    findall(Name-Wish,
            ( unfolding(S, Wish), how_name(Wish, Name) ),
            Wishes),
    findall(Option,
            ( member(Name-Wish, Wishes), how_given(Name, Wish, Option) ),
            More),
    append(Options0, More, Options),
    forall(member(Name-Wish, Wishes), all_said(S, Name, Wish, Options)).

how_name(Wish, Name) :-
    functor(Wish, Name, _),
    how_row(Name, _, _, _).

all_said(S, Name, Wish, Options) :-
    how_row(Name, _, Needs, _),
    (   Needs == none
    ->  true
    ;   said(Needs, Options)
    ->  true
    ;   needed_form(Needs, Form),
        throw(error(model_error(unfold(S, Wish, needs(Form))), _))
    ).

%   needed_form(Name, Form): without the range of its value.

needed_form(Name, Form) :-
    how_form(Name, Full),
    atomic_list_concat([Form|_], ', ', Full).

said(true_lengths, Options) :-
    !,
    memberchk(true(true), Options).
said(Name, Options) :-
    functor(Option, Name, 1),
    memberchk(Option, Options).

%!  how_wished_of_any(?Name, ?Option) is nondet.
%
%   The model says Option, called Name, of some segment.

how_wished_of_any(Name, Option) :-
    unfolding(_, Wish),
    how_name(Wish, Name),
    how_given(Name, Wish, Option).
