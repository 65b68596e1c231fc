:- module(sg_prolog_en,
          [ prolog_en//2                % +Formal, +Context
          ]).
:- use_module(message_parts,
              [ endless_goal/2, near_predicates/3, number_fault/3,
                meant_en//1 ]).
/** <module> Errors of Prolog that people meet, in English.

prolog_ko.pl has the same heads in Korean. Only what the program itself and a
host see is said in these words; where Sanggwan is a library, Prolog's own are.
A Formal warning(What) is a warning while rules load, loading_warnings/2.
*/

%!  prolog_en(+Formal, +Context)// is semidet.
%
%   The message for error(Formal, Context).

prolog_en(resource_error(nesting_of_terms), _) -->
    [ 'a term is nested too deeply to be kept in a world' ].
prolog_en(resource_error(What), Context) -->
    { What \== nesting_of_terms,
      endless_goal(Context, Goal)
    },
    !,
    [ '~p calls itself without end: Prolog\'s stacks are full'-[Goal] ].
prolog_en(resource_error(What), _) -->
    { What \== nesting_of_terms },
    [ 'there is not enough memory for this: Prolog\'s stacks are full', nl,
      '  Ask for less at once: a smaller model, a goal that does not collect \c
       all its answers.' ].
prolog_en(io_error(Action, _), context(_, Why)) -->
    [ 'a file or a stream failed: ~w (~w)'-[Action, Why], nl,
      '  Check the disk, and who reads what is written.' ].
prolog_en(existence_error(procedure, PI), _) -->
    { near_predicates(PI, Plain, Near) },
    [ 'there is no predicate ~q'-[Plain] ],
    meant_en(Near),
    [ nl, '  The goal help. lists what there is.' ].
prolog_en(existence_error(Kind, What), _) -->
    { Kind \== procedure },
    [ 'there is no ~w ~p'-[Kind, What] ].
prolog_en(instantiation_error, _) -->
    [ 'something must have a value before this is called' ].
prolog_en(type_error(evaluable, What), _) -->
    [ 'in arithmetic there is no ~p'-[What] ].
prolog_en(type_error(Type, What), _) -->
    { Type \== evaluable },
    [ 'this should be of type ~w: ~p'-[Type, What] ].
prolog_en(domain_error(Domain, What), _) -->
    [ 'this is no ~w: ~p'-[Domain, What] ].
prolog_en(representation_error(What), _) -->
    [ 'this cannot be held: ~w'-[What] ].
prolog_en(evaluation_error(What), _) -->
    { number_fault(What, Words, _) },
    !,
    [ 'this cannot be computed: ~w'-[Words] ].
prolog_en(evaluation_error(What), _) -->
    [ 'this cannot be computed: ~w'-[What] ].
prolog_en(permission_error(Action, Kind, What), _) -->
    [ 'there is no permission to ~w the ~w ~p'-[Action, Kind, What] ].
prolog_en(syntax_error(What), _) -->
    [ 'this is no Prolog text: ~w'-[What] ].
prolog_en(timeout_error(Action, _), _) -->
    [ 'it took too long: ~w'-[Action] ].
prolog_en(thrown(Ball), _) -->
    [ '~p was thrown'-[Ball] ].
prolog_en(warning(once(Names)), _) -->
    [ 'a variable stands once only: ~w'-[Names], nl,
      '  Write _ where its value does not matter.' ].
prolog_en(warning(often(Names)), _) -->
    [ 'a variable stands more than once, though its name begins with _: ~w'-
      [Names] ].
prolog_en(warning(branch(Name)), _) -->
    [ 'a variable is used in one branch only: ~w'-[Name] ].
prolog_en(warning(always_same(Compared)), _) -->
    [ 'a test has always the same result: ~p'-[Compared] ].
prolog_en(warning(apart(PI)), _) -->
    [ 'the clauses of ~p are not together'-[PI], nl,
      '  Move them, or write :- discontiguous ~p.'-[PI] ].
prolog_en(warning(failed(Goal)), _) -->
    [ 'this directive failed: ~p'-[Goal] ].
