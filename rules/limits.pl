:- module(sg_limits,
          [ limit_value/2,              % ?Name, -Most
            set_limit/2,                % +Name, +Most
            with_usual_limits/1,        % :Goal
            within_limit/3,             % +Name, +Count, +Error
            within_depth/1,             % @Term
            text_beyond/5,              % +Kind, +Source, -What, -Line, -Column
            text_limits/1,              % -Limits
            term_of_text/3              % +Text, -Term, +Options
          ]).
:- use_module(kernel, [text_fault/4]).
:- use_module(library(apply), [include/3, maplist/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(error), [must_be/2, domain_error/2]).
:- meta_predicate with_usual_limits(0).

/** <module> How much a text may ask for: the one table of limits.

What comes from elsewhere, files and goals, is not built before it is known how
large it will be. Texts are looked through as characters
(c_kernels/model/text_limits.h), sizes are reckoned from numbers. Each limit can
be raised, for the process: set_limit/2, on the command line `--limits`.
*/

%   limit_default(Name, Most)
%
%     - depth    terms, lists and operators in one another
%     - blocks   blocks of a .csg file in one another
%     - digits   characters of a number
%     - name     characters of a name or a text
%     - fact     characters of a fact
%     - file     octets of a .csg or CityJSON file, read as a whole
%     - text     octets of another text: plain facts are 30 MB a second
%     - clauses  clauses of a rule file
%     - facets   corners of a primitive, for every facet has some
%     - contacts looks at edges where polygons touch or cross themselves
%     - values   values of a variable in a manifest or of a variant
%     - variants variants of a problem
%     - nodes    leaves of a tree, each as often as it is used

limit_default(depth, 128).
limit_default(blocks, 512).
limit_default(digits, 2000).
limit_default(name, 65_536).
limit_default(fact, 16_000_000).
limit_default(file, 16_000_000).
limit_default(text, 500_000_000).
limit_default(clauses, 100_000).
limit_default(facets, 1_000_000).
limit_default(contacts, 20_000_000).
limit_default(values, 10_000_000).
limit_default(variants, 10_000).
limit_default(nodes, 100_000).

%!  limit_value(?Name, -Most:integer) is nondet.
%
%   Most is how much there may be of what Name names.

limit_value(Name, Most) :-
    limit_default(Name, Default),
    limit_flag(Name, Flag),
    flag(Flag, Set, Set),
    (   Set =:= 0
    ->  Most = Default
    ;   Most = Set
    ).

limit_flag(Name, Flag) :-
    atom_concat(sg_limit_, Name, Flag).

%!  set_limit(+Name, +Most:integer) is det.
%
%   Until the process ends there may be Most of what Name names. What is deeper
%   than the default needs more of the C stack of its thread: half a kB each.
%
%   @error domain_error(limit, Name); type_error(positive_integer, Most)

set_limit(Name, Most) :-
    must_be(atom, Name),
    must_be(positive_integer, Most),
    (   limit_default(Name, _)
    ->  limit_flag(Name, Flag),
        flag(Flag, _, Most)
    ;   domain_error(limit, Name)
    ).

%!  with_usual_limits(:Goal) is semidet.
%
%   Call Goal once. All limits are the usual ones when it begins, and afterwards
%   what they were before.

with_usual_limits(Goal) :-
    findall(Flag-Set,
            ( limit_default(Name, _), limit_flag(Name, Flag),
              flag(Flag, Set, 0) ),
            Sets),
    call_cleanup(once(Goal),
                 forall(member(Flag-Set, Sets), flag(Flag, _, Set))).

%!  within_limit(+Name, +Count, +Location) is det.
%
%   Count, how many there would be of what Name names, is not above its limit.
%
%   @error error(model_error(limit(Name, Count, Most)), Location)

within_limit(Name, Count, Location) :-
    limit_value(Name, Most),
    (   Count =< Most
    ->  true
    ;   throw(error(model_error(limit(Name, Count, Most)), Location))
    ).

%!  within_depth(@Term) is det.
%
%   Term is no deeper than what writes it can go down its stack: 2,000 levels,
%   or the limit `depth` if that is more. A list is as deep as its deepest
%   member and one; what is in itself is too deep.
%
%   @error model_error(limit(depth, Most))

within_depth(Term) :-
    limit_value(depth, Limit),
    Most is max(2000, Limit),
    (   deeper(Term, Most)
    ->  throw(error(model_error(limit(depth, Most)), _))
    ;   true
    ).

deeper(Term, Most) :-
    compound(Term),
    Most1 is Most-1,
    (   Most1 < 0
    ->  true
    ;   Term = [_|_]
    ->  '$skip_list'(_, Term, End),
        (   nonvar(End),
            End = [_|_]                 % a list that ends in itself
        ;   member_of(Term, Member),
            deeper(Member, Most1)
        ;   deeper(End, Most1)
        )
    ;   arg(_, Term, Argument),
        deeper(Argument, Most1)
    ),
    !.

member_of(List, Member) :-
    nonvar(List),
    List = [First|Rest],
    (   Member = First
    ;   member_of(Rest, Member)
    ).

%!  text_beyond(+Kind, +Source, -What, -Line, -Column) is semidet.
%
%   True when Source, a string or the stream of a file, breaks a limit: What is
%   limit(Name, Most), at the place Line and Column. Kind as in text_fault/4.

text_beyond(Kind, Source, limit(Name, Most), Line, Column) :-
    text_limits(Limits),
    text_fault(Kind, Source, Limits, fault(Name, Line, Column)),
    limit_value(Name, Most).

%!  text_limits(-Limits) is det.
%
%   Limits are those of texts, as text_fault/4 and csg_nodes/4 want them.

text_limits(Limits) :-
    maplist(limit_value, [depth, blocks, digits, name, fact, file], Mosts),
    Limits =.. [limits|Mosts].

%!  term_of_text(+Text, -Term, +Options) is det.
%
%   As term_string/3, of a Text that is no larger than a goal may be, and has
%   nothing after the full stop of the term.
%
%   @error syntax_error(Why), with Why also limit(Name, Most) and
%          after_full_stop

term_of_text(Text0, Term, Options) :-
    format(string(Text), "~w", [Text0]),
    (   text_beyond(program, Text, What, _, _)
    ->  throw(error(syntax_error(What), _))
    ;   term_string(Term, Text, Options),
        nothing_after(Text, Options)
    ).

%   nothing_after(Text, Options): the text of one term has no other one behind
%   it. Without a full stop, there is none.

nothing_after(Text, Options) :-
    include(is_syntax, Options, Syntax),
    setup_call_cleanup(
        open_string(Text, Stream),
        (   catch(read_term(Stream, _, Syntax), error(syntax_error(_), _), fail)
        ->  catch(read_term(Stream, Next, Syntax), error(_, _), true)
        ;   Next = end_of_file
        ),
        close(Stream)),
    (   Next == end_of_file
    ->  true
    ;   throw(error(syntax_error(after_full_stop), _))
    ).

is_syntax(module(_)).
is_syntax(dotlists(_)).
