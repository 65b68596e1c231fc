:- module(sg_topics,
          [ topic/2,                    % +Topic, +Title
            topic_predicates/3,         % ?Topic, -Title, -Predicates
            offered/2                   % ?PI, -Facade
          ]).
:- use_module(library(lists), [append/3, member/2, subtract/3]).

/** <module> Topics: what users may call, in order.

The facades are the one list of it: sanggwan.pl, then rows.pl, topology.pl and
spans.pl. Each `:- topic(Topic, Title)` there begins a topic, to which all
belongs that is exported after it.
*/

% begun(Facade, Topic, Title, Before): Before were the exports when Topic began.
:- dynamic begun/4.

facade(sanggwan).
facade(sanggwan_rows).
facade(sanggwan_topology).
facade(sanggwan_spans).

%!  topic(+Topic, +Title) is det.
%
%   Directive of a facade: what it exports from here on is of Topic.

% A directive runs it, no rule does.
:- public topic/2.

topic(Topic, Title) :-
    prolog_load_context(module, Facade),
    exported(Facade, Before),
    retractall(begun(Facade, Topic, _, _)),
    assertz(begun(Facade, Topic, Title, Before)).

exported(Facade, PIs) :-
    (   catch(module_property(Facade, exports(PIs0)), _, fail)
    ->  sort(PIs0, PIs)
    ;   PIs = []
    ).

%!  topic_predicates(?Topic, -Title, -Predicates) is nondet.
%
%   Predicates, a sorted list of Name/Arity, are what users may call of Topic.

topic_predicates(Topic, Title, Predicates) :-
    facade(Facade),
    findall(T-W-B, begun(Facade, T, W, B), Begun),
    exported(Facade, All),
    append(_, [Topic-Title-Before|Later], Begun),
    (   Later = [_-_-After|_]
    ->  true
    ;   After = All
    ),
    subtract(After, Before, Predicates).

%!  offered(?PI, -Facade) is nondet.
%
%   Users may call PI, Name/Arity; Facade exports it.

offered(PI, Facade) :-
    facade(Facade),
    exported(Facade, PIs),
    member(PI, PIs).
