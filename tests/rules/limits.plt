/* How much a text may ask for: on both sides of each edge. */
:- module(test_limits, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(limits)).

%   nested(How, Levels, Term): a constant in so many terms or lists.

nested(_, 0, a) :-
    !.
nested(How, N, Term) :-
    N1 is N-1,
    nested(How, N1, Inner),
    level(How, N, Inner, Term).

level(terms, _, Inner, f(x,Inner)).
level(lists, _, Inner, [x,Inner]).
level(tails, _, Inner, [x|f(Inner)]) :-
    Inner \= [_|_].
level(both, N, Inner, Term) :-
    (   N mod 2 =:= 0
    ->  Term = f(Inner)
    ;   Term = [Inner,x,y]
    ).

refused(Goal, What) :-
    catch(( Goal, What = none ), error(What, _), true).

:- meta_predicate refused(0, -).

:- begin_tests(limits).

test(deepest, [ forall(member(How, [terms,lists,both])),
                true(Whats == [none,model_error(limit(depth, 2000))]) ]) :-
    findall(What,
            ( member(Levels, [2000,2001]),
              nested(How, Levels, Term),
              refused(within_depth(Term), What) ),
            Whats).
test(deeper_than_usual, [ cleanup(set_limit(depth, 128)),
                          true(Whats == [none,model_error(limit(depth,
                                                                2500))]) ]) :-
    set_limit(depth, 2500),
    findall(What,
            ( member(Levels, [2500,2501]),
              nested(terms, Levels, Term),
              refused(within_depth(Term), What) ),
            Whats).
test(long_is_not_deep, What == none) :-
    numlist(1, 100 000, List),
    refused(within_depth(f(List)), What).
test(tail_counts, What == model_error(limit(depth, 2000))) :-
    nested(terms, 2000, Term),
    refused(within_depth([1,2|Term]), What).
test(open_list, What == none) :-
    refused(within_depth([1,f(2)|_]), What).
test(in_itself, [ forall(member(Kind, [term,list])),
                  true(What == model_error(limit(depth, 2000))) ]) :-
    (   Kind == term
    ->  Term = f(Term)
    ;   Term = [1,2|Term]
    ),
    refused(within_depth(Term), What).
test(as_many_as_may_be,
     Whats == [none,none,model_error(limit(blocks, 513, 512))]) :-
    findall(What,
            ( member(Count, [0,512,513]),
              refused(within_limit(blocks, Count, here), What) ),
            Whats).
test(usual_within, Inside-After == [512,512,7]-[7,7]) :-
    set_limit(blocks, 7),
    set_limit(depth, 200),
    with_usual_limits(( limit_value(blocks, Usual),
                        set_limit(blocks, 9), set_limit(blocks, 512),
                        limit_value(blocks, Set) )),
    limit_value(blocks, After1),
    catch(with_usual_limits(( set_limit(blocks, 3), throw(out) )), out, true),
    limit_value(blocks, After2),
    limit_value(depth, Depth),
    assertion(Depth == 200),
    set_limit(blocks, 512),
    set_limit(depth, 128),
    Inside = [Usual,Set,After1],
    After = [After1,After2].
test(one_term, Term == f(x)) :-
    term_of_text("f(x)", Term, []).
test(full_stop, Term == f(x)) :-
    term_of_text('f(x). % and words', Term, []).
test(two_terms, error(syntax_error(after_full_stop), _)) :-
    term_of_text("f(x). g(y).", _, []).
test(goal_too_deep, error(syntax_error(limit(depth, 128)), _)) :-
    nested(terms, 200, Term),
    format(string(Text), "~q", [Term]),
    term_of_text(Text, _, []).

:- end_tests(limits).
