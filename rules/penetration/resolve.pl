:- module(sg_resolve,
          [ resolve_contacts/2,         % +Set, +Tolerance
            refusing_moves/1,           % :Goal
            moved_said/2,               % +Moved, +Tolerance
            tight_said/1,               % +Tight
            holding_said/2,             % :Goal, -Held
            held_said/1,                % +Held
            tolerance_reach/2,          % +Tolerance, -Reach
            resolved_seams/0
          ]).
:- use_module('../kernel', [cut_own_tolerances/1, cut_touch/4]).
:- use_module('../store',
              [ e/5, p/3, origin/3, line/9, edge_polygon/3, assert_fact/1,
                retract_fact/1, retractall_facts/1
              ]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [selectchk/3]).

/** <module> Resolving contacts: what was meant to touch is made to touch.

Solids that share a part of a face share it exactly only as long as nobody has
turned them: coordinates are rounded, and afterwards one face lies a hair's
breadth above the other, in places. Exact arithmetic would draw each hair. So
before the exact arrangement, what is nearer than the tolerance is made to
touch, with the same doubles on both sides:

    vertex and vertex   one moves to the other
    vertex and edge     the edge is divided there
    edge and edge       both are divided where they pass each other
    vertex and polygon  the polygon gets a corner of a triangle there

A piece of an edge between two such points in a polygon enters it as a pair of
auxiliary edges (a seam), and where two polygons lie on each other both get the
same triangles. Nothing else changes: what is exact already is left alone, and
what comes after decides exactly on what stands in v/5 and t/6.

A vertex that moved or was made here has the origin `near(Origin)`, Origin as
in penetration.pl; it is not exact. What was there before is kept
(leaf.pl).

@see c_kernels/penetration/resolve.h
*/

%!  resolve_contacts(+Set, +Tolerance) is semidet.
%
%   True if something was made to touch in the segments of cut set Set: then
%   the world has changed, and Set no longer shows it. Tolerance is as for
%   tolerance_reach/2, positive. Contacts that are connected over more than
%   three tolerances, or that a polygon cannot take in, are tried again with
%   less; in the end nothing is changed, with a warning: the lines are right
%   for the model as it is, but may have splinters. Where anything moves
%   farther than doubles are rounded a message says so; where that is more
%   than a hundredth of the smallest feature near it, it is a warning.
%
%   @error geometry_error(What): under refusing_moves/1, which see

resolve_contacts(Set, Tolerance) :-
    set_reach(Set, Tolerance, Reach),
    Reach > 0,
    parts(Parts),
    closed_contacts(Parts, Set, Reach, Moves),
    moves_said(Moves, Tolerance).

set_reach(Set, Tolerance, Reach) :-
    tolerance_reach(Tolerance, Reach),
    (   Tolerance = own(_)
    ->  cut_own_tolerances(Set)
    ;   true
    ).

%!  tolerance_reach(+Tolerance, -Reach) is det.
%
%   Nothing is made to touch that is farther apart than Reach. Tolerance is
%   that number, or own(Reach): then it is also no farther apart than the source
%   of the coarser of two segments says (cut_own_tolerances/1).

tolerance_reach(own(Reach0), Reach) :-
    !,
    Reach = Reach0.
tolerance_reach(Reach, Reach).

closed_contacts([Part|Parts], Set, Tolerance, Moves) :-
    Reach is Part*Tolerance,
    cut_touch(Set, Reach, What, Moves0),
    (   atom(What)
    ->  What == changed,
        Moves = Moves0
    ;   Parts == []
    ->  said(print_message(warning, sanggwan(contacts(What)))),
        fail
    ;   closed_contacts(Parts, Set, Tolerance, Moves)
    ).

parts([1, 2 ** -8, 2 ** -16]).

%   moves_said(Moves, Tolerance): what cut_touch/4 says of them.

moves_said(little, _).
moves_said(move(moved, S1-S2, p(X,Y,Z), Move, _, N), Tolerance) :-
    moved_said(moved(S1, S2, [X,Y,Z], Move, N), Tolerance).
moves_said(move(tight, S1-S2, p(X,Y,Z), Move, Feature, N), _) :-
    tight_said(tight(S1, S2, [X,Y,Z], Move, Feature, N)).

%!  moved_said(+Moved, +Tolerance) is det.
%
%   Moved is what is moved no farther than the sources explain: a message, or
%   under refusing_moves/1, where nobody gave Tolerance, an error.
%
%   @error geometry_error(unasked(Moved, Reach)): Reach is the tolerance that
%          allows it

moved_said(Moved, Tolerance) :-
    said(told_moved(Moved, Tolerance)).

told_moved(Moved, own(Reach)) :-
    refused,
    !,
    throw(error(geometry_error(unasked(Moved, Reach)), _)).
told_moved(Moved, _) :-
    print_message(informational, sanggwan(Moved)).

%!  tight_said(+Tight) is det.
%
%   Tight is what would be moved by more than a hundredth of the smallest
%   feature near it, and no source explains: a warning, or under
%   refusing_moves/1 an error.
%
%   @error geometry_error(Tight): tight(S1, S2, Place, Move, Feature, N) or
%          flattened(S, Place, Move, Beside, N)

tight_said(Tight) :-
    said(told_tight(Tight)).

told_tight(Tight) :-
    (   refused
    ->  throw(error(geometry_error(Tight), _))
    ;   print_message(warning, sanggwan(Tight))
    ).

:- thread_local refused/0, holding/0, held/1.

said(Goal) :-
    (   holding
    ->  assertz(held(Goal))
    ;   call(Goal)
    ).

:- meta_predicate holding_said(0, -).

%!  holding_said(:Goal, -Held:list) is semidet.
%
%   once/1 of Goal, an attempt. What would be said of what it moves, or refused,
%   is Held, for held_said/1 when it is known that the attempt counts.

holding_said(Goal, Held) :-
    setup_call_cleanup(
        asserta(holding, Ref),
        ( once(Goal),
          findall(Said, retract(held(Said)), Held)
        ),
        ( erase(Ref),
          retractall(held(_))
        )).

%!  held_said(+Held:list) is det.
%
%   @error as moved_said/2, tight_said/1

held_said(Held) :-
    maplist(call, Held).

:- meta_predicate refusing_moves(0).

%!  refusing_moves(:Goal) is semidet.
%
%   once/1 of Goal, in which nothing is moved that a message would tell: nothing
%   by more than a hundredth of the smallest feature near it, neither to touch
%   nor to be flat, and where no tolerance is given nothing farther than doubles
%   are rounded.
%
%   @error geometry_error(What): see moved_said/2 and tight_said/1; What is of
%          cut_touch/4 or solid_merge/4

refusing_moves(Goal) :-
    setup_call_cleanup(
        asserta(refused, Ref),
        once(Goal),
        erase(Ref)).

retract_one(Fact) :-
    retract_fact(Fact),
    !.

%!  resolved_seams is det.
%
%   When the lines are found: the seams that resolve_contacts/2 entered, until
%   then auxiliary edges, become edges of the lines that run along them. Those
%   without a line (of segments that do not cut each other) go.

resolved_seams :-
    findall(S-E, origin(S, e(E), near), Seams),
    maplist(name_seam, Seams).

name_seam(S-Seam) :-
    retract_one(origin(S, e(Seam), near)),
    findall(E-A-B, ( part(S, Seam, E), e(S, E, A, B, _) ), Parts),
    maplist(name_part(S), Parts).

%   part(+S, +E, -Part): what was divided while lines were entered.

part(_, E, E).
part(S, E, Part) :-
    origin(S, e(E1), e(E)),
    part(S, E1, Part).

name_part(S, E-A-B) :-
    line_along(S, A, B, L),
    !,
    retractall_facts(e(S, E, _, _, _)),
    assert_fact(e(S, E, A, B, 1)),
    retractall_facts(origin(S, e(E), _)),
    assert_fact(origin(S, e(E), line(L))).
name_part(S, E-_-_) :-
    edge_polygon(S, E, P),
    p(S, P, Es0),
    !,
    selectchk(E, Es0, Es),
    retract_one(p(S, P, Es0)),
    assert_fact(p(S, P, Es)),
    retractall_facts(e(S, E, _, _, _)),
    retractall_facts(origin(S, e(E), _)).

line_along(S, A, B, L) :-
    line(L, S, _, A, B, _, _, _, _).
line_along(S, A, B, L) :-
    line(L, S, _, B, A, _, _, _, _).
line_along(S, A, B, L) :-
    line(L, _, _, _, _, S, _, A, B).
line_along(S, A, B, L) :-
    line(L, _, _, _, _, S, _, B, A).
