:- module(sg_development_record,
          [ record_development/5,       % +D, +S, +Options, +Order, +Measures
            recorded_development/4,     % +D, -S, -Options, -Order
            development_measures/2,     % +D, -Measures
            drop_pattern/1,             % +D
            record_divided/2,           % +D, +S
            record_drawn/4,             % +D, +Seam, +Longest, +Area
            divided_development/3,      % +D, -S, -Options
            score/3,                    % +Objective, +Measures, -Score
            cannot_develop/2            % +S, +What
          ]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module(development_given, [given_development/3, given_measures/3]).
:- use_module('../store',
              [ segment/3, origin/3, segment_stamp/2, assert_fact/1,
                retractall_facts/1
              ]).
:- use_module(library(apply), [include/3]).
:- use_module(library(error), [existence_error/2]).
/** <module> What a development was made from, and how good it is.

    origin(D, node(D), laid(Options, Order, Stamp, Measures))

remembers it beside the rows of the pattern D, as csg_record.pl does for nodes:
Stamp is that of the segment; or divided(Stamp), where edges of the segment had
to be divided first, in a snapshot, which it does not show. Records are not
written to files.
*/

%!  record_development(+D, +S, +Options:list, +Order, +Measures) is det.
%
%   Remember that pattern D was made from segment S, as it is now, with Options,
%   and has Measures, those of flattening_measures/2 and flattening_bound/2 as a
%   pair. Order is that of its joints
%   (joint_order/3), or exchanged(Order), if folds were exchanged after that.

record_development(D, S, Options0, Order, Measures) :-
    include(is_wish, Options0, Options),
    segment_stamp(S, Stamp),
    retractall_facts(origin(D, node(D), _)),
    assert_fact(origin(D, node(D), laid(Options, Order, Stamp, Measures))).

is_wish(Option) :-
    functor(Option, Name, 1),
    ground(Option),
    memberchk(Name, [removed,root,cut,keep,order,minimize,tries,effort]).

%!  drop_pattern(+D) is det.
%
%   Take away all rows of segment D, a pattern, and what remembers it.

drop_pattern(D) :-
    drop_boundary(D),
    retractall_facts(origin(D, _, _)),
    retractall_facts(segment(D, _, _)).

%!  recorded_development(+D, -S, -Options:list, -Order) is det.
%
%   Pattern D was made from segment S, which has not changed since. Order is
%   that of its joints, exchanged(Order), or `given`: nothing is remembered of
%   it, as it was read from a file, and Options are what can be told from its
%   rows (given_development/3).
%
%   @error existence_error(development, D)

recorded_development(D, S, Options, Order) :-
    (   segment(D, pattern, development(S)),
        origin(D, node(D), laid(Options0, Order0, Stamp, _))
    ->  segment_stamp(S, Now),
        Stamp == Now,
        Options = Options0,
        Order = Order0
    ;   given_development(D, S, Options0)
    ->  Options = Options0,
        Order = given
    ),
    !.
recorded_development(D, _, _, _) :-
    existence_error(development, D).

%!  record_divided(+D, +S) is det.
%
%   Remember that pattern D, of which there is a record, was made from segment
%   S, as it is now, after something of S was divided in a snapshot.

record_divided(D, S) :-
    segment_stamp(S, Stamp),
    origin(D, node(D), laid(Options, Order, _, Measures)),
    !,
    retractall_facts(origin(D, node(D), _)),
    assert_fact(origin(D, node(D),
                       laid(Options, Order, divided(Stamp), Measures))).

%!  record_drawn(+D, +Seam, +Longest, +Area) is det.
%
%   Remember that pattern D, if there is a record of it, was changed so that
%   these are its measures. What was proven of its seam is of the facets, and
%   forgotten.

record_drawn(D, Seam, Longest, Area) :-
    (   origin(D, node(D), laid(Options, Order, Stamp, Laid-Least))
    ->  Laid = measures(_, Pieces, _, _, Sheet, Tests, Refused),
        Least = bound(_, _, Tree),
        retractall_facts(origin(D, node(D), _)),
        assert_fact(origin(D, node(D),
                           laid(Options, Order, Stamp,
                                measures(Seam, Pieces, Longest, Area, Sheet,
                                         Tests, Refused)
                                - bound(null, null, Tree))))
    ;   true
    ).

%!  divided_development(+D, -S, -Options:list) is semidet.
%
%   Pattern D was made so from segment S, which has not changed since, with
%   Options in the numbers of the divided one.

divided_development(D, S, Options) :-
    segment(D, pattern, development(S)),
    origin(D, node(D), laid(Options, _, divided(Stamp), _)),
    segment_stamp(S, Now),
    Stamp == Now,
    !.

%!  development_measures(+D, -Measures:dict) is det.
%
%   How good pattern D is:
%
%     - seam       length of all seams, each once; model units
%     - pieces     how many
%     - longest    the longest weld: seams end to end, as far as no others meet
%                  them
%     - area       of the pieces
%     - sheet      of the sheet that the pieces lie on, side by side
%     - tree       the minimum spanning tree of the vertices over the edges
%     - bound      what the seam cannot be less than
%       (c_kernels/development/seam_bound.h)
%     - bound_by   how that is proven: `tree`, `forest`, or `moats`
%     - tests      of two triangles for overlap
%     - refused    joints that would have made an overlap
%
%   Of a pattern that was read from a file, tests and refused are 0.
%
%   @error existence_error(development, D): no pattern, or its segment is not
%          there as it was

development_measures(D, Measures) :-
    (   origin(D, node(D), laid(_, _, _, Laid-Least))
    ->  true
    ;   given_measures(D, Laid, Least)
    ->  true
    ;   existence_error(development, D)
    ),
    Laid = measures(Seam, Pieces, Longest, Area, Sheet, Tests, Refused),
    Least = bound(Bound, By, Tree),
    Measures = _{seam:Seam, pieces:Pieces, longest:Longest, area:Area,
                 sheet:Sheet, tree:Tree, bound:Bound, bound_by:By, tests:Tests,
                 refused:Refused}.

%!  score(+Objective, +Measures, -Score) is det.
%
%   Of two developments that with the lesser Score, in the standard order, is
%   better; Measures as of flattening_measures/2. Lengths that are equal up to
%   rounding are equal: the faces are the measure of them, if they have area.
%
%   @error domain_error(objective, Objective)

score(Objective, Measures, Main/Rest) :-
    Measures = measures(Seam0, Pieces, Longest0, Area, Sheet0, _, _),
    Size is max(max(Area, 1.0e-300), 1.0e-30*max(Sheet0, Seam0*Seam0)),
    Seam is round(Seam0/sqrt(Size)*1.0e9),
    Longest is round(Longest0/sqrt(Size)*1.0e9),
    Sheet is round(Sheet0/Size*1.0e9),
    Rest = [Seam,Pieces,Longest,Sheet],
    (   nth_objective(Objective, Seam, Pieces, Longest, Sheet, Main0)
    ->  Main = Main0
    ;   throw(error(domain_error(objective, Objective), _))
    ).

nth_objective(seam, Seam, _, _, _, Seam).
nth_objective(pieces, _, Pieces, _, _, Pieces).
nth_objective(longest, _, _, Longest, _, Longest).
nth_objective(area, _, _, _, Sheet, Sheet).

%!  cannot_develop(+S, +What)
%
%   @error geometry_error(development(S, What))

cannot_develop(S, What) :-
    throw(error(geometry_error(development(S, What)), _)).
