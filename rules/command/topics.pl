:- module(sg_topics,
          [ topic/2,                    % +Topic, +Title
            topic_predicates/3          % ?Topic, -Title, -Predicates
          ]).
:- use_module(library(lists), [append/3, subtract/3]).

/** <module> Topics: what users may call, in order.

sanggwan.pl is the one list of it: each `:- topic(Topic, Title)` there begins a
topic, to which all belongs that is exported after it.
*/

% begun(Topic, Title, Before): Before were the exports when Topic began.
:- dynamic begun/3.

%!  topic(+Topic, +Title) is det.
%
%   Directive of sanggwan.pl: what it exports from here on is of Topic.

% A directive runs it, no rule does.
:- public topic/2.

topic(Topic, Title) :-
    exported(Before),
    retractall(begun(Topic, _, _)),
    assertz(begun(Topic, Title, Before)).

exported(PIs) :-
    (   catch(module_property(sanggwan, exports(PIs0)), _, fail)
    ->  sort(PIs0, PIs)
    ;   PIs = []
    ).

%!  topic_predicates(?Topic, -Title, -Predicates) is nondet.
%
%   Predicates, a sorted list of Name/Arity, are what users may call of Topic.

topic_predicates(Topic, Title, Predicates) :-
    findall(T-W-B, begun(T, W, B), Begun),
    exported(All),
    append(_, [Topic-Title-Before|Later], Begun),
    (   Later = [_-_-After|_]
    ->  true
    ;   After = All
    ),
    subtract(After, Before, Predicates).
