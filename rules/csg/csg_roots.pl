:- module(sg_csg_roots,
          [ aside_segments/1,           % -Ss
            roots_alone/0,
            operand_lines/1,            % -Lines
            operand_lines_added/1,      % +Lines
            with_operand_lines/2        % +Lines, :Goal
          ]).
:- use_module(csg, [root_segment/1, is_node/1]).
:- use_module(csg_record, [drop_record/1, joined_segment/1, record_joined/1]).
:- use_module(csg_rows, [drop_boundary/1]).
:- use_module(csg_term, [plain_name/2]).
:- use_module('../kernel', [operand_borders/2, segment_grain/2]).
:- use_module(source, [source_noted/2]).
:- use_module(known_surface, [facets_of/2, remember_facets/1]).
:- use_module('../store',
              [ e/5, segment/3, origin/3, from_p/5, assert_fact/1,
                retractall_facts/1, facts_transaction/1, fresh_id/3
              ]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
/** <module> Looking at roots only: operands put aside.

Drawing, checking, cutting and meshes look at the roots of the CSG tree. What is
put aside are their operands, the helpers, and patterns (development.pl).
*/

:- meta_predicate with_operand_lines(+, 0).

%!  aside_segments(-Ss) is det.
%
%   Ss are the segments that are no roots, ascending.

aside_segments(Ss) :-
    findall(S, segment(S, _, _), All0),
    sort(All0, All),
    (   member(S, All),
        ( is_node(S) ; segment(S, pattern, _) )
    ->  findall(Root, root_segment(Root), Roots),
        ord_subtract(All, Roots, Ss)
    ;   Ss = []
    ).

%!  roots_alone is det.
%
%   Take all that is no root out of the current world. Roots that are nodes
%   become plain segments: their name is that of named/2, or of the operation,
%   and what names segments that are gone (origin/3, from_v/4, from_p/5) goes
%   too; what lies apart on each other stays known, that it was a join
%   (joined_segment/1), and which smooth surfaces their polygons stand for
%   (known_surface.pl). One transaction.

roots_alone :-
    aside_segments(Aside),
    facts_transaction(sg_csg_roots:left_alone(Aside)).

%!  operand_lines(-Lines) is det.
%!  operand_lines_added(+Lines) is det.
%!  with_operand_lines(+Lines, :Goal) is semidet.
%
%   Lines are border(S, P, V1, V2, Q), where the boundaries of root nodes turn
%   from one operand to another (operand_borders/2). From when they are added,
%   or while Goal runs, once, they are line/9 of these segments with
%   themselves, as far as their edges are there: so they are drawn as
%   penetration lines, however little they bend, but where they are tangent.

operand_lines(Lines) :-
    root_nodes(Nodes),
    (   Nodes == []
    ->  Lines = []
    ;   operand_borders(Nodes, Lines)
    ).

root_nodes(Nodes) :-
    findall(S, ( root_segment(S), is_node(S) ), Nodes).

operand_lines_added(Lines) :-
    forall(member(Line, Lines), ignore(line_added(Line, _))).

with_operand_lines(Lines, Goal) :-
    findall(L, ( member(Line, Lines), line_added(Line, L) ), Ls),
    once(Goal),
    forall(member(L, Ls), retractall_facts(line(L, _, _, _, _, _, _, _, _))).

line_added(border(S, P, V1, V2, Q), L) :-
    once(e(S, _, V1, V2, _)),
    fresh_id(line, 0, L),
    assert_fact(line(L, S, P, V1, V2, S, Q, V1, V2)).

left_alone(Aside) :-
    root_nodes(Nodes),
    facets_of(Nodes, Facets),
    maplist(segment_dropped, Aside),
    maplist(made_plain, Nodes),
    remember_facets(Facets).

segment_dropped(S) :-
    drop_record(S),
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).

made_plain(S) :-
    segment(S, Kind, Term),
    plain_name(Term, Name),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, Kind, Name)),
    retractall_facts(from_v(S, _, _, _)),
    retractall_facts(from_p(S, _, _, _, _)),
    retractall_facts(from_r(S, _, _, _)),
    segment_grain(S, Grain),
    findall(Q-P, origin(S, p(Q), slit(P)), Slits),
    (   joined_segment(S)
    ->  retractall_facts(origin(S, _, _)),
        record_joined(S)
    ;   retractall_facts(origin(S, _, _))
    ),
    forall(member(Q-P, Slits), assert_fact(origin(S, p(Q), slit(P)))),
    source_noted(S, Grain).
