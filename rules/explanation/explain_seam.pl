:- module(sg_explain_seam,
          [ joint_explained/5,          % ?S, ?E, +Kind, +Options, -Because
            pattern_explained/4         % ?S, ?K, +Options, -Because
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module('../development/development',
              [ develop/3, development/2, join_order/3, may_join/2,
                seam_reason/3 ]).
:- use_module('../development/development_instead', [seam_instead/4]).
:- use_module('../development/development_record',
              [recorded_development/4, development_measures/2]).
:- use_module(explain_pair, [decided_by/2]).
:- use_module(explain_parameter, [sizes_because/2]).
:- use_module('../kernel', [model_tolerance/1]).
:- use_module('../development/part_edges', [edge_length/3, parts_attached/3]).
:- use_module('../store',
              [ e/5, p/3, piece/3, joint/6, segment/3, origin/3, edge_polygon/3,
                facts_snapshot/1
              ]).
:- use_module('../solid/trimmed', [part_named/2]).
:- use_module('../unfolding/unfold',
              [ unfoldable/1, pattern_of/2, wishes/3, wanted_of/3,
                trimmed_part/3, part_developed/4, part_laid/4,
                part_laid_again/2 ]).
:- use_module('../unfolding/unfold_how', [how_wished/3]).
:- use_module('../unfolding/unfold_true', [true_patterns/4]).
:- use_module('../unfolding/unfold_wish', [wanted_in/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists),
              [append/2, append/3, max_list/2, member/2, nth1/3, select/3]).
:- use_module(library(option), [option/2]).
:- use_module(library(pairs), [pairs_keys/2, pairs_values/2]).

/** <module> Explain: why an edge is a seam or a fold, and a piece alone.

The pattern is laid once more, up to the joint that is asked for
(seam_reason/3): so one sees which edges were joined before it, or what would
have come to lie on what. What another choice costs is found by making it: the
segment is laid flat with the edge kept, or cut, and both are measured.

Where the current world has no pattern of the segment, one is made for the
question, as unfold/3 makes it, with what Options want of it:

    root(P), cut(E), keep(E), order(Ps), removed(P), minimize(Objective),
    effort(N), trim(Side), by(Ss)
    as unfold/3 has them
    true(true), seam(Degrees), half(true)
    as true_patterns/4 has them
    wanted(Pairs)
    S-Wanted, what is wanted of segment S, where it was looked up before
    (wanted_of/3)

Where edges of the segment had to be divided for its pattern (DV-5), they are
divided again for the question, so that parts have the numbers they have in the
pattern; an edge that was divided stands for all its parts.

A pattern that was read from a file, with its segment, is explained as it is
(development_given.pl). What is round and was unrolled has seams where it is cut
open, and folds where it is round.

@see rows DV-6 and DV-7
*/

%!  joint_explained(?S, ?E, +Kind, +Options:list, -Because) is nondet.
%
%   Because is the list of because(Statement, Because) for edge E in the pattern
%   of segment S. With E unbound, for each joint of Kind (`seam`, `fold`), by
%   the smaller of its edges. S may be the number of the pattern too.

joint_explained(S, E, Kind, Options, Because) :-
    in_pattern(S, Options, D,
               sg_explain_seam:joints_because(D, E, Kind, Found), Found),
    member(E-Because, Found).

%!  pattern_explained(?S, ?K, +Options:list, -Because) is nondet.
%
%   Because is the list of because(Statement, Because) for piece K of the
%   pattern of segment S: what it is, and why it is joined to no other.

pattern_explained(S, K, Options, Because) :-
    in_pattern(S, Options, D,
               sg_explain_seam:pieces_because(D, K, Found), Found),
    member(K-Because, Found).

%   in_pattern(?S, +Options, -D, :Goal, -Found): Goal, which finds Found, holds
%   where D is the pattern of S.

:- meta_predicate in_pattern(?, +, -, 0, -).

in_pattern(S, Options, D, Goal, Found) :-
    asked_segment(S, Options, S0),
    (   \+ some_wish(Options),
        patterns_there(S0, Ds)
    ->  found_in(Ds, D, Goal, Found, Founds)
    ;   facts_snapshot(( patterns_laid(S0, Options, Ds),
                         found_in(Ds, D, Goal, Found, Founds) ))
    ),
    append(Founds, Found),
    Found = [_|_].

found_in(Ds, D, Goal, Found, Founds) :-
    findall(Found, ( member(D, Ds), call(Goal) ), Founds).

some_wish(Options) :-
    member(Option, Options),
    functor(Option, Name, 1),
    memberchk(Name, [ root,cut,keep,order,removed,minimize,effort,wanted,trim,
                      true ]),
    !.

%   patterns_there(S, Ds): Ds are patterns of S, and what can be asked about
%   them is known or can be found again.

patterns_there(S, Ds) :-
    findall(D,
            ( segment(D, pattern, _),
              pattern_of(D, S),
              ( is_true(D, _) -> true ; is_fresh(D) ) ),
            Ds),
    Ds = [_|_].

%   patterns_laid(S, Options, Ds): in a snapshot.

patterns_laid(S, Options, [D]) :-
    \+ some_wish(Options),
    development(S, D0),
    (   part_laid_again(D0, D)
    ->  true
    ;   model_tolerance(Tolerance),
        parts_attached(S, Tolerance, changes(_, [_|_])),
        is_fresh(D0),
        D = D0
    ),
    !.
patterns_laid(S, Options, Ds) :-
    (   option(wanted(Pairs), Options),
        memberchk(S-Wanted, Pairs)
    ->  true
    ;   wishes(S, Options, Wishes),
        wanted_of(S, Wishes, Wanted)
    ),
    findall(Option, ( member(Option0, Options),
                      says_how(Option0, S, Option) ),
            How0),
    how_wished(S, How0, How),
    (   option(true(true), How)
    ->  true_patterns(S, Wanted, How, Ds)
    ;   trimmed_part(S, How, T),
        part_of_wanted(T, S, Wanted, How, D),
        Ds = [D]
    ).

part_of_wanted(S, S, Wanted, How, D) :-
    !,
    part_laid(S, Wanted, How, D).
part_of_wanted(T, S, Wanted, How, D) :-
    wanted_in(T, S, Wanted, Manual),
    part_developed(T, Manual, How, D).

says_how(by(Ss), S, by(Others)) :-
    findall(Other, ( member(Other, Ss), Other \== S ), Others).
says_how(Option, _, Option) :-
    functor(Option, Name, 1),
    memberchk(Name, [minimize,effort,trim,true,seam,half]).

asked_segment(S, Options, S0) :-
    (   nonvar(S),
        pattern_of(S, S1)
    ->  S0 = S1
    ;   unfoldable(S),
        S0 = S
    ),
    (   option(wanted(Pairs), Options)
    ->  memberchk(S0-_, Pairs)
    ;   true
    ).

is_fresh(D) :-
    catch(recorded_development(D, _, _, _), error(existence_error(_, _), _),
          fail).

%   is_true(D, Part): D is what is round unrolled: Part of a segment.

is_true(D, Part) :-
    segment(D, pattern, true_development(_, Part0)),
    (   Part0 = Leaf/Name,
        part_named(Leaf, S)
    ->  Part = S/Name
    ;   Part = Part0
    ).

%   with_sizes(D, Because0, Because): if one thing alone is asked about, also
%   the sizes of its segment that come from parameters.

with_sizes(D, [because(Statement, Because0)], [because(Statement, Because)]) :-
    of_segment(D, S),
    sizes_because(S, Sizes),
    append(Because0, Sizes, Because).

/* - - - an edge - - - */

%   What another choice costs is found by laying the whole pattern again: of one
%   edge always, of all joints for as many as tries_allowed/2 says.

joints_because(D, E, _, Found) :-
    nonvar(E),
    !,
    findall(E-Because,
            ( edge_because(D, E, Because0),
              with_sizes(D, Because0, Because) ),
            Found).
joints_because(D, _, Kind, Found) :-
    tries_allowed(D, Most),
    findall(joint(J, E, E2, Angle), joint(D, J, E, E2, Kind, Angle), Joints),
    findall(E-Because,
            ( nth1(I, Joints, joint(J, E, E2, Angle)),
              ( I =< Most -> Try = true ; Try = false ),
              joint_because(Kind, D, J, E, E2, Angle, Try, Because) ),
            Found).

%   tries_allowed(D, Most): a few seconds' work, reckoned as polygons laid.

tries_allowed(D, Most) :-
    aggregate_all(count, p(D, _, _), Polygons),
    Most is max(4, 20_000//max(1, Polygons)).

edge_because(D, E, Because) :-
    \+ e(D, E, _, _, _),
    !,
    origin(D, e(Part), e(E)),
    edge_because(D, Part, Because).
edge_because(D, E, Because) :-
    once(e(D, E, _, _, 1)),
    (   ( joint(D, J, E, E2, Is, Angle) ; joint(D, J, E2, E, Is, Angle) )
    ->  joint_because(Is, D, J, E, E2, Angle, true, Because)
    ;   once(edge_polygon(D, E, P)),
        of_segment(D, S),
        Because = [because(border_edge(S, E, P), [])]
    ).
joint_because(seam, D, J, E, E2, _, Try,
              [because(seam_edge(S, E, E2, P1, P2, Length), Why)]) :-
    joint_facts(D, E, E2, S, P1, P2, Length),
    seam_because(D, S, J, E, Try, Why).
joint_because(fold, D, _, E, E2, Angle, Try,
              [because(fold_edge(S, E, E2, P1, P2, Length, Angle), Why)]) :-
    joint_facts(D, E, E2, S, P1, P2, Length),
    fold_because(D, E, Try, Why).
joint_because(line, D, _, E, E2, _, _,
              [because(line_in_polygon(S, E, E2, P), [])]) :-
    of_segment(D, S),
    once(edge_polygon(D, E, P)).

joint_facts(D, E, E2, S, P1, P2, Length) :-
    of_segment(D, S),
    once(edge_polygon(D, E, P1)),
    once(edge_polygon(D, E2, P2)),
    edge_length(D, E, Length).

of_segment(D, S) :-
    pattern_of(D, S).

/* - - - a seam - - - */

seam_because(D, S, J, E, Try, Because) :-
    (   is_true(D, Part)
    ->  Because = [because(cut_open(Part), [])]
    ;   is_fresh(D)
    ->  once(seam_reason(D, J, Reason)),
        reason_because(Reason, D, S, J, E, Try, Because)
    ;   Because = [because(changed_since, [])]
    ).

reason_because(cycle(Js), D, S, J, E, Try, [Joined|Because]) :-
    joined_on_way(Js, D, Joined, Shortest),
    order_because(D, Order),
    instead_because(Try, D, S, J, Shortest, Instead),
    kept_because(Try, D, E, Kept),
    append([Order,Instead,Kept], Because).
reason_because(exchange(Js, J2, P1, P2), D, S, _, E, Try,
               [ Joined,
                 because(would_overlap_instead(S, E2, P1, P2), [])
               | Kept ]) :-
    joined_on_way(Js, D, Joined, _),
    on_the_way(D, J2, _-fold(E2, _, _, _)),
    kept_because(Try, D, E, Kept).
reason_because(chosen(Js), D, S, J, E, Try, [Joined|Because]) :-
    joined_on_way(Js, D, Joined, Shortest),
    instead_because(Try, D, S, J, Shortest, Instead),
    kept_because(Try, D, E, Kept),
    append([Instead,[because(could_be_joined, [])],Kept], Because).
reason_because(overlap(P1, P2), D, S, _, E, Try,
               [because(would_overlap(S, P1, P2), [])|Kept]) :-
    kept_because(Try, D, E, Kept).
reason_because(cut_by_wish, _, _, _, _, _, [because(cut_by_wish, [])]).
reason_because(forbidden, _, S, _, E, _,
               [because(may_not_join(S, E, By), [])]) :-
    decided_by(may_join/2, By).
reason_because(short, _, _, _, _, _, [because(too_short, [])]).
reason_because(free, _, _, _, _, _, [because(could_be_joined, [])]).

order_because(D, [because(joined_in_order(By), [])|Exchanged]) :-
    decided_by(join_order/3, By),
    recorded_development(D, _, _, Order),
    (   Order = exchanged(_)
    ->  Exchanged = [because(folds_exchanged, [])]
    ;   Exchanged = []
    ).

%   joined_on_way(Js, D, Joined, Shortest): Joined says that joints Js of D hold
%   polygons together; Shortest is the shortest of them, J-E of its edge E.

joined_on_way(Js, D, because(joined_already(Count, E, Least), Shown), J-E) :-
    maplist(on_the_way(D), Js, Folds),
    shortest_first(Folds, [Least-fold(E, _, _, J)|_]),
    length(Folds, Count),
    shown_folds(Folds, Shown).

%   on_the_way(D, J, Fold): Fold is Length-fold(E, P1, P2, J).

on_the_way(D, J, Length-fold(E, P1, P2, J)) :-
    once(joint(D, J, E, E2, _, _)),
    joint_facts(D, E, E2, _, P1, P2, Length).

%   instead_because(Try, D, S, J, Fold, Because): seam J joined, the Fold cut.

instead_because(false, _, _, _, _, []).
instead_because(true, D, S, J, Fold-E, Because) :-
    seam_instead(D, J, Fold, Result),
    (   Result = seam(Seam)
    ->  development_measures(D, Before),
        Difference is Seam-Before.seam,
        Because = [because(cut_instead(E, Difference), [])]
    ;   Result = overlap(P1, P2)
    ->  Because = [because(would_overlap_instead(S, E, P1, P2), [])]
    ;   Because = []
    ).

%   shortest_first(Folds0, Folds): those that are equally long up to rounding
%   stay in order.

shortest_first(Folds0, Folds) :-
    pairs_keys(Folds0, Lengths),
    max_list(Lengths, Longest),
    tolerance(rounding, Of),
    Step is max(Longest, 1.0e-300)*Of,
    findall(Rounded-Fold,
            ( member(Fold, Folds0), Fold = Length-_,
              Rounded is round(Length/Step) ),
            Keyed),
    keysort(Keyed, Sorted),
    pairs_values(Sorted, Folds).

%   shown_folds(Folds, Shown): all, in order, or the shortest if they are many.

shown_folds(Folds0, Shown) :-
    length(Folds0, Count),
    (   Count =< 8
    ->  Folds = Folds0
    ;   shortest_first(Folds0, Sorted),
        length(Folds, 8),
        append(Folds, _, Sorted)
    ),
    findall(because(fold_on_the_way(E, P1, P2, Length), []),
            member(Length-fold(E, P1, P2, _), Folds),
            Shown).

/* - - - what it would cost - - - */

%   kept_because(Try, D, E, Because): the pattern with edge E joined before all
%   others, if that is to be tried.

kept_because(false, _, _, [because(not_tried, [])]).
kept_because(true, D, E, [because(Statement, [])]) :-
    recorded_development(D, S, Options0, _),
    with_edge(keep, E, Options0, Options),
    development_measures(D, Before),
    catch(facts_snapshot(( develop(S, Options, D2),
                           kept_measures(D2, E, After) )),
          error(geometry_error(development(_, overlap(_, face(P1, _),
                                               face(P2, _)))), _),
          After = overlap(P1, P2)),
    (   After = overlap(P1, P2)
    ->  Statement = cannot_be_kept(S, P1, P2)
    ;   After == seam
    ->  Statement = held_by_kept
    ;   Difference is After.seam-Before.seam,
        Statement = kept_instead(Difference, After.pieces, Before.pieces)
    ).

%   kept_measures(D, E, Measures): `seam` if edge E is one in pattern D all the
%   same, since other edges that are kept hold its polygons together.

kept_measures(D, E, Measures) :-
    (   ( joint(D, _, E, _, seam, _) ; joint(D, _, _, E, seam, _) )
    ->  Measures = seam
    ;   development_measures(D, Measures)
    ).

%   cut_because(Try, D, E, Because): the pattern with edge E cut.

cut_because(false, _, _, [because(not_tried, [])]).
cut_because(true, D, E,
            [because(cut_here(Difference, Pieces, PiecesBefore), [])]) :-
    recorded_development(D, S, Options0, _),
    with_edge(cut, E, Options0, Options),
    development_measures(D, Before),
    facts_snapshot(( develop(S, Options, D2),
                     development_measures(D2, After) )),
    Difference is After.seam-Before.seam,
    Pieces = After.pieces,
    PiecesBefore = Before.pieces.

with_edge(Name, E, Options0, [Option|Options]) :-
    Old =.. [Name,Es],
    (   select(Old, Options0, Options)
    ->  true
    ;   Es = [],
        Options = Options0
    ),
    append(Es, [E], All),
    Option =.. [Name,All].

/* - - - a fold - - - */

fold_because(D, E, Try, Because) :-
    (   is_true(D, Part)
    ->  Because = [because(unrolled(Part), [])]
    ;   is_fresh(D)
    ->  recorded_development(D, _, Options, _),
        (   member(keep(Es), Options),
            memberchk(E, Es)
        ->  Because = [because(kept_by_wish, [])]
        ;   order_because(D, Order),
            cut_because(Try, D, E, Cut),
            append(Order, Cut, Because)
        )
    ;   Because = [because(changed_since, [])]
    ).

/* - - - a piece - - - */

pieces_because(D, K, Found) :-
    (   nonvar(K)
    ->  One = true
    ;   One = false
    ),
    findall(K-Because,
            ( piece_because(D, K, S, Count, Pieces, Why),
              Because0 = [because(pattern_piece(S, K, Count, Pieces), Why)],
              (   One == true
              ->  with_sizes(D, Because0, Because)
              ;   Because = Because0
              ) ),
            Found).

piece_because(D, K, S, Count, Pieces, Why) :-
    of_segment(D, S),
    aggregate_all(max(K0), piece(D, _, K0), Pieces),
    between(1, Pieces, K),
    aggregate_all(count, piece(D, _, K), Count),
    seams_out(D, K, Seams),
    (   Seams == []
    ->  Why = [because(no_seam_out, [])]
    ;   length(Seams, Out),
        longest_reasons(D, S, Seams, Reasons),
        Why = [because(seams_out(Out), Reasons)]
    ).

%   seams_out(D, K, Seams): Length-J of the seams of piece K to others.

seams_out(D, K, Seams) :-
    findall(Less-J,
            ( joint(D, J, E1, E2, seam, _),
              edge_piece(D, E1, K1),
              edge_piece(D, E2, K2),
              K1 =\= K2,
              ( K =:= K1 -> true ; K =:= K2 ),
              edge_length(D, E1, Length),
              Less is -Length ),
            Seams).

edge_piece(D, E, K) :-
    once(edge_polygon(D, E, P)),
    once(piece(D, P, K)).

%   longest_reasons(D, S, Seams, Reasons): of the three longest, why they were
%   not joined.

longest_reasons(D, S, Seams, Reasons) :-
    keysort(Seams, Sorted),
    pairs_values(Sorted, Js0),
    (   length(Js, 3),
        append(Js, _, Js0)
    ->  true
    ;   Js = Js0
    ),
    findall(because(seam_edge(S, E, E2, P1, P2, Length), Why),
            ( member(J, Js),
              joint(D, J, E, E2, _, _),
              joint_facts(D, E, E2, S, P1, P2, Length),
              refusal(D, S, J, E, Why) ),
            Reasons).

refusal(D, S, J, E, [Why]) :-
    \+ is_true(D, _),
    is_fresh(D),
    once(seam_reason(D, J, Reason)),
    (   Reason = overlap(P1, P2)
    ->  Why = because(would_overlap(S, P1, P2), [])
    ;   memberchk(Reason, [cycle(_),chosen(_),exchange(_,_,_,_)])
    ->  Why = because(no_length, [])
    ;   reason_because(Reason, D, S, J, E, false, [Why])
    ).
