:- module(sg_ask_hidden,
          [ hides/2,                    % ?S1, ?S2
            hidden_edge/3,              % ?S1, ?S2, -E
            asks_of_picture/1           % +Goal
          ]).
:- use_module('../picture/hidden_lines', [hidden_interval/6, open_scene/2]).
:- use_module('../store', [drawn/7]).
:- use_module(library(lists), [member/2]).
:- use_module(library(occurs), [sub_term/2]).
/** <module> Questions about the picture: which segment hides which.

The decision may_hide/2 of rule files (docs/rules.md) says what may hide,
hides/2 what does.
*/

:- multifile sandbox:safe_primitive/1.

sandbox:safe_primitive(sg_ask_hidden:hides(_, _)).

%!  hides(?S1, ?S2) is nondet.
%
%   True when segment S1 hides a line of segment S2, or a part of it, in the
%   picture that drawn/7 holds. A segment hides its own lines that are behind
%   it.

hides(S1, S2) :-
    findall(A-B, hidden_edge(A, B, _), Pairs0),
    sort(Pairs0, Pairs),
    member(S1-S2, Pairs).

%!  hidden_edge(?S1, ?S2, -E) is nondet.
%
%   True when S1 hides a part of edge E of S2 that is drawn hidden. May come
%   more than once.

hidden_edge(S1, S2, E) :-
    open_scene(Scene, []),
    drawn(_, S2, E, From, To, hidden, _),
    hidden_interval(Scene, S2, E, S1, From1, To1),
    From1 < To,
    To1 > From.

%!  asks_of_picture(+Goal) is semidet.
%
%   Goal calls what there is of a picture alone.

asks_of_picture(Goal) :-
    sub_term(Part, Goal),
    callable(Part),
    functor(Part, Name, Arity),
    of_picture(Name, Arity),
    !.

of_picture(hides, 2).
of_picture(drawn, 7).
of_picture(screen, 5).
of_picture(contour, 13).
of_picture(surface_facing, 6).
of_picture(hidden_by, 6).
of_picture(hidden_by_polygon, 6).
