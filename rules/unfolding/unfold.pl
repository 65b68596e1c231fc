:- module(sg_unfold,
          [ unfold/2,                   % +S, -D
            unfold/3,                   % +S, +Options, -D
            unfoldable/1,               % ?S
            pattern_of/2,               % +D, -T
            wanted_of/3,                % +S, +Wishes, -Wanted
            pattern_row/2,              % +D, -Row
            unfolded_part/4,            % +S, +Wanted, +Options, -D
            trimmed_part/3,             % +S, +Options, -T
            other_parts/3,              % +S, +Options, -Others
            part_developed/4,           % +T, +Manual, +Options, -D
            part_laid/4,                % +S, +Wanted, +Options, -D
            part_laid_again/2,          % +D0, -D
            wishes/3                    % +S, +Options, -Wishes
          ]).
:- use_module('../development/bend', [pattern_bent/2]).
:- use_module('../csg/csg_roots', [aside_segments/1]).
:- use_module('../development/development', [develop/3]).
:- use_module('../development/development_record',
              [drop_pattern/1, record_divided/2, divided_development/3]).
:- use_module('../kernel', [model_tolerance/1]).
:- use_module('../development/part_edges', [parts_attached/3]).
:- use_module('../development/polygon_name', [polygon_name/3]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, plane/6, t/6, segment/3, origin/3, from_v/4,
                from_p/5, unfolding/2, piece/3, joint/6, edge_polygon/3,
                assert_fact/1, facts_snapshot/1, facts_transaction/1
              ]).
:- use_module('../solid/trimmed', [trimmed/5, part_named/2]).
:- use_module(unfold_how, [how_wished/3]).
:- use_module(unfold_wish, [wanted/3, wanted_in/4]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(error), [domain_error/2, existence_error/2, must_be/2]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
/** <module> Unfolding: from a part of a model to its pattern, in one go.

What has to be done before a part can be laid flat (development.pl), and what
the user wants of it: the part is trimmed by the others if that is asked for;
where only a part of an edge attaches to its neighbour's, edges are divided
(DV-5); the wishes (unfolding/2 and options, DV-7) are looked up and held
against each other.

    ?- load_model('pipes.pl'), unfold(2, [trim(outside), removed(top)], D).
*/

%!  unfold(+S, -D) is det.
%!  unfold(+S, +Options:list, -D) is det.
%
%   D is a new segment, the pattern of segment S, a solid or a surface: see
%   develop/3. The facts unfolding(S, Wish) say what is wanted of it, and so do
%   the Options
%
%     - root(P), cut(E), keep(E), order(Ps), removed(P)
%     as unfold_wish.pl says; each may be repeated.
%     - trim(Side)
%     First S is trimmed to what is `outside` or `inside` of other segments
%     (trimmed/5); D is then the pattern of that, itself a new segment.
%     - by(Ss)
%     The segments it is trimmed by. Default: all others that are no operands
%     of a CSG tree and no curves.
%     - tolerance(T)
%     What is nearer than T is in one place. Default: model_tolerance/1.
%
%     - thickness(T), size(Which), bend_radius(R), k_factor(K), relief(Which)
%     Of the plate that is folded: see pattern_bent/2.
%
%   The facts may say these too (unfold_how.pl), of S. Others go to develop/3,
%   as minimize(Objective). S stays as it is; if the
%   segments were cut (penetrate/0) before, D has the penetration lines. One
%   transaction.
%
%   @error existence_error(segment, S)
%   @error geometry_error(unfold(kind(S, Kind))): S has no faces
%   @error model_error(unfold(S, Wish, What)), usage_error(unfold(S, Wish,
%          What)): a wish that cannot be, see unfold_wish.pl
%   @error geometry_error(trim(What)): see trimmed/5

unfold(S, D) :-
    unfold(S, [], D).

unfold(S, Options0, D) :-
    has_faces(S),
    must_be(list, Options0),
    must_be(ground, Options0),
    how_wished(S, Options0, Options),
    wishes(S, Options, Wishes),
    wanted_of(S, Wishes, Wanted),
    unfolded_part(S, Wanted, Options, D).

has_faces(S) :-
    must_be(nonvar, S),
    (   segment(S, Kind, _)
    ->  (   memberchk(Kind, [solid,surface])
        ->  true
        ;   throw(error(geometry_error(unfold(kind(S, Kind))), _))
        )
    ;   existence_error(segment, S)
    ).

%!  unfoldable(?S) is nondet.
%
%   True when segment S can be unfolded: a solid or a surface that is no operand
%   of a CSG tree. Ascending.

unfoldable(S) :-
    aside_segments(Aside),
    findall(S1, ( segment(S1, Kind, _), memberchk(Kind, [solid,surface]),
                  \+ ord_memberchk(S1, Aside) ),
            Ss0),
    sort(Ss0, Ss),
    member(S, Ss).

%!  pattern_of(+D, -T) is semidet.
%
%   True when D is a pattern of segment T.

pattern_of(D, T) :-
    segment(D, pattern, Term),
    (   Term = development(T0)
    ;   Term = true_development(T0, _)
    ),
    !,
    T = T0.

%!  wishes(+S, +Options:list, -Wishes:list) is det.
%
%   Wishes are wish(Wish, From) of segment S: those of the model, then those
%   among Options.

wishes(S, Options, Wishes) :-
    findall(wish(Wish, fact), unfolding(S, Wish), Facts),
    findall(wish(Wish, flag),
            ( member(Wish, Options), compound(Wish), functor(Wish, Name, 1),
              memberchk(Name, [root,cut,keep,order,removed]) ),
            Flags),
    append(Facts, Flags, Wishes).

%!  wanted_of(+S, +Wishes, -Wanted) is det.
%
%   As wanted/3, of segment S with the edges that attach in parts divided; to be
%   called before lines or trimming change S.

wanted_of(_, [], wanted(none, [], [], [])) :-
    !.
wanted_of(S, Wishes, Wanted) :-
    model_tolerance(Tolerance),
    facts_snapshot(( parts_attached(S, Tolerance, _),
                     wanted(S, Wishes, Wanted)
                   )).

%!  unfolded_part(+S, +Wanted, +Options:list, -D) is det.
%
%   As unfold/3, with what is Wanted of S known already. One transaction.

unfolded_part(S, Wanted, Options, D) :-
    facts_transaction(sg_unfold:part_unfolded(S, Wanted, Options, D)).

part_unfolded(S, Wanted, Options, D) :-
    trimmed_part(S, Options, T),
    root_stays(T, S, Wanted),
    tolerance(Options, Tolerance),
    facts_snapshot(
        sg_unfold:attached_unfolded(T, S, Wanted, Options, Tolerance, Result)),
    (   Result = rows(D, Rows)
    ->  drop_pattern(D),
        maplist(assert_fact, Rows),
        record_divided(D, T)
    ;   wanted_in(T, S, Wanted, Manual),
        part_developed(T, Manual, Options, D)
    ).

%!  trimmed_part(+S, +Options:list, -T) is det.
%
%   T is segment S, or what is trimmed of it if Options have trim(Side).

trimmed_part(S, Options, T) :-
    (   option(trim(Side), Options)
    ->  other_parts(S, Options, Others),
        stage(pieces, trimmed(S, Others, Side, Options, T)),
        (   T == S
        ->  part_named(S, Named),
            print_message(informational, sanggwan(unfold(alone(Named))))
        ;   true
        )
    ;   T = S
    ).

%!  other_parts(+S, +Options:list, -Others:list) is det.
%
%   Others are the segments that S is trimmed by: as option by(Others) says, or
%   all others that can be unfolded.

other_parts(S, Options, Others) :-
    (   option(by(Others0), Options)
    ->  Others = Others0
    ;   findall(Other, ( unfoldable(Other), Other \== S,
                         \+ made_here(Other) ),
                Others)
    ).

made_here(S) :-
    segment(S, _, trimmed(_, _, _)).
made_here(S) :-
    origin(S, node(S), plate(_)).

root_stays(T, S, wanted(Root, _, _, _)) :-
    (   Root == none
    ->  true
    ;   T == S
    ->  true
    ;   from_p(T, _, S, Root, _)
    ->  true
    ;   polygon_name(S, Root, Name),
        print_message(warning,
                      sanggwan(unfold(root_gone(S, face(Root, Name)))))
    ).

tolerance(Options, Tolerance) :-
    (   option(tolerance(Tolerance), Options)
    ->  must_be(number, Tolerance),
        (   Tolerance >= 0
        ->  true
        ;   domain_error(tolerance, Tolerance)
        )
    ;   model_tolerance(Tolerance)
    ).

%   attached_unfolded(T, S, Wanted, Options, Tolerance, Result): the rows of the
%   pattern, rows(D, Rows), if something of T had to be changed for it, in a
%   snapshot; else `none`.

attached_unfolded(T, S, Wanted, Options, Tolerance, Result) :-
    parts_attached(T, Tolerance, changes(Welded, Divided)),
    (   Welded-Divided == []-[]
    ->  Result = none
    ;   length(Welded, W),
        length(Divided, N),
        print_message(informational, sanggwan(unfold(attached(T, W, N)))),
        wanted_in(T, S, Wanted, Manual),
        part_developed(T, Manual, Options, D),
        parts_named(D, Divided),
        findall(Row, pattern_row(D, Row), Rows),
        Result = rows(D, Rows)
    ).

parts_named(D, Divided) :-
    forall(( member(E0-Es, Divided), member(E, Es) ), part_named(D, E, E0)).

part_named(D, E, E0) :-
    (   e(D, E, _, _, _),
        \+ origin(D, e(E), _)
    ->  assert_fact(origin(D, e(E), e(E0)))
    ;   true
    ).

%!  pattern_row(+D, -Row) is nondet.
%
%   Row is a fact of pattern D, in an order in which they can be asserted.

pattern_row(D, segment(D, Kind, Term)) :-
    segment(D, Kind, Term).
pattern_row(D, v(D, V, X, Y, Z)) :-
    v(D, V, X, Y, Z).
pattern_row(D, e(D, E, A, B, Et)) :-
    e(D, E, A, B, Et).
pattern_row(D, p(D, P, Es)) :-
    p(D, P, Es).
pattern_row(D, plane(D, P, Nx, Ny, Nz, C)) :-
    plane(D, P, Nx, Ny, Nz, C).
pattern_row(D, t(D, P, T, A, B, C)) :-
    t(D, P, T, A, B, C).
pattern_row(D, origin(D, Item, Origin)) :-
    origin(D, Item, Origin).
pattern_row(D, from_v(D, V, S, W)) :-
    from_v(D, V, S, W).
pattern_row(D, from_p(D, P, S, Q, Sense)) :-
    from_p(D, P, S, Q, Sense).
pattern_row(D, piece(D, P, K)) :-
    piece(D, P, K).
pattern_row(D, joint(D, J, E1, E2, Kind, Angle)) :-
    joint(D, J, E1, E2, Kind, Angle).

%!  part_developed(+T, +Manual:list, +Options:list, -D) is det.
%
%   D is the pattern of segment T, with Manual, options of develop/3 for what is
%   wanted, and with Options, as of unfold/3. A warning for each edge that
%   should have been kept and was not.

part_developed(T, Manual, Options, D) :-
    findall(Option,
            ( member(Option, Options), functor(Option, Name, _),
              \+ memberchk(Name, [root,cut,keep,order,removed,trim,by]) ),
            Others),
    append(Manual, Others, All),
    stage(develop, develop(T, All, D)),
    option(keep(Keep), Manual, []),
    forall(member(E, Keep), kept_or_told(D, T, E)),
    pattern_bent(D, Options).

%!  part_laid(+S, +Wanted, +Options:list, -D) is det.
%
%   As unfolded_part/4 without trimming, but what of segment S had to be divided
%   stays so: in a snapshot, where D and S can be asked about together.

part_laid(S, Wanted, Options, D) :-
    tolerance(Options, Tolerance),
    parts_attached(S, Tolerance, changes(_, Divided)),
    wanted_in(S, S, Wanted, Manual),
    part_developed(S, Manual, Options, D),
    parts_named(D, Divided).

%!  part_laid_again(+D0, -D) is semidet.
%
%   Likewise, as pattern D0 was made, if it was made after its segment was
%   divided (divided_development/3).

part_laid_again(D0, D) :-
    divided_development(D0, S, Manual),
    model_tolerance(Tolerance),
    parts_attached(S, Tolerance, changes(_, Divided)),
    part_developed(S, Manual, [], D),
    parts_named(D, Divided).

kept_or_told(D, T, E) :-
    (   once(e(D, E, _, _, _)),
        ( joint(D, _, E, _, fold, _) ; joint(D, _, _, E, fold, _) )
    ->  true
    ;   ( joint(D, _, E, F, seam, _) ; joint(D, _, F, E, seam, _) ),
        edge_polygon(D, E, P),
        edge_polygon(D, F, Q)
    ->  piece(D, P, K1),
        piece(D, Q, K2),
        (   K1 == K2
        ->  Why = same_piece
        ;   Why = overlap
        ),
        polygon_name(T, P, Name1),
        polygon_name(T, Q, Name2),
        print_message(warning,
                      sanggwan(unfold(not_kept(T, E, face(P, Name1),
                                               face(Q, Name2), Why))))
    ;   true
    ).
