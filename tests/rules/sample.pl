:- module(sg_test_sample,
          [ all_wanted/0,
            sampled/2,                  % +Classes, :Goal
            shared/3,                   % +I, +Tests, :Goal
            few/3,                      % +Few, +All, -N
            numbered/3,                 % +Few, +All, -I
            one_in/2                    % +N, :Goal
          ]).
/** <module> A sample by default, all of it on demand.

Tests that take long do a sample of their cases, always the same one, which
has every class in it. With TEST_ALL=1 in the environment (`make test-all`) they
do all; counts of more, such as TRUE_CUT_RANDOM=50, are of that.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).

:- meta_predicate sampled(+, 0), shared(+, +, 0), one_in(+, 0).

%!  all_wanted is semidet.

all_wanted :-
    getenv('TEST_ALL', Text),
    \+ memberchk(Text, ['',0,'0']).

%!  few(+Few, +All, -N) is det.
%
%   N is Few, or All if that is wanted.

few(Few, All, N) :-
    (   all_wanted
    ->  N = All
    ;   N = Few
    ).

%!  numbered(+Few, +All, -I) is nondet.
%
%   I is 1, 2 ... Few, or All if that is wanted: seeds of random cases.

numbered(Few, All, I) :-
    few(Few, All, N),
    between(1, N, I).

%!  sampled(+Classes, :Goal) is nondet.
%
%   Some solutions of Goal, in its order: every value that a variable of the
%   list Classes has in any is in one of them. They are looked for in leaps, so
%   that the values are mixed. Without classes it is one solution.

sampled(_, Goal) :-
    all_wanted,
    !,
    call(Goal).
sampled(Classes, Goal) :-
    term_variables(Goal, Variables),
    findall(Classes-Variables, Goal, Cases),
    length(Cases, N),
    leaps(N, Order),
    foldl(taken(Cases), Order, []-[], _-Taken0),
    sort(Taken0, Taken),
    member(I, Taken),
    nth0(I, Cases, Classes-Variables).

%!  shared(+I, +Tests, :Goal) is nondet.
%
%   The I-th share, from 1, of the solutions of Goal, if each of so many Tests
%   is to have another one; all of them, if all are wanted.

shared(_, _, Goal) :-
    all_wanted,
    !,
    call(Goal).
shared(I, Tests, Goal) :-
    call_nth(Goal, Nth),
    Nth mod Tests =:= I mod Tests.

%!  one_in(+N, :Goal) is nondet.
%
%   Every N-th solution of Goal, from the first on; all of them, if all are
%   wanted.

one_in(N, Goal) :-
    (   all_wanted
    ->  call(Goal)
    ;   call_nth(Goal, Nth),
        Nth mod N =:= 1 mod N
    ).

%   leaps(N, Order): 0 .. N-1, each far from the one before.

leaps(N, Order) :-
    Golden is max(1, round(N*0.618)),
    once(( between(Golden, inf, Leap),
           gcd(Leap, N) =:= 1 )),
    findall(Place, ( between(1, N, I), Place is (I-1)*Leap mod N ), Order).

taken(Cases, I, Seen0-Taken, Seen-[I|Taken]) :-
    nth0(I, Cases, Classes-_),
    findall(K-Value, nth0(K, Classes, Value), Values),
    (   Taken == []
    ;   member(Value, Values),
        \+ memberchk(Value, Seen0)
    ),
    !,
    append(Values, Seen0, Seen).
taken(_, _, State, State).
