:- module(sg_csg_record,
          [ record/2,                   % +S, +What
            recorded/2,                 % ?S, ?What
            up_to_date/2,               % +S, +From
            made_and_kept/2,            % +S, +What
            not_kept/2,                 % +Ss, -Others
            segments_of_kind/3,         % +Kind, +Ss, -Those
            drop_record/1,              % +S
            record_pieces/2,            % +S, +Pieces
            recorded_pieces/2,          % +S, -Pieces
            joined_segment/1,           % ?S
            record_joined/1               % +S
          ]).
:- use_module('../kernel', [kept_leaves/2, newer_segments/3]).
:- use_module('../store',
              [ segment/3, origin/3, segment_stamp/2, assert_fact/1,
                retractall_facts/1
              ]).
:- use_module(library(apply), [foldl/5]).
/** <module> What rows were made from, remembered beside them.

    origin(S, node(S), evaluated(made(From, Stamp)))     a node
    origin(S, node(S), helper(made(From, Stamp)))        a helper (csg.pl)
    origin(S, node(S), leaf(made(primitive(Term), Stamp)))
    origin(S, node(S), join)                             was a join (below)
    origin(S, node(pieces), pieces(Pieces))             beside evaluated(_)

From is a ground term with the stamps of what the rows were made from; Stamp
is that of the rows themselves. A glue may have many operands and needs no
stamps of theirs: all are older than Stamp. Rows and record are of one version,
so undo takes both back. Stamps mean nothing in another world: records are not
written to files.
*/

%!  record(+S, +What) is det.
%
%   Remember that the rows of segment S, as they are now, were made from From:
%   What is evaluated(From), helper(From) or leaf(From).

record(S, What0) :-
    What0 =.. [Name, From],
    segment_stamp(S, Stamp),
    What =.. [Name, made(From, Stamp)],
    drop_record(S),
    assert_fact(origin(S, node(S), What)).

%!  recorded(?S, ?What) is nondet.
%
%   True when it is remembered of segment S that What; its rows, or what they
%   were made from, may have changed since.

recorded(S, What) :-
    segment(S, _, _),
    origin(S, node(S), What0),
    What0 =.. [Name, made(From, _)],
    What =.. [Name, From].

%!  up_to_date(+S, +From) is semidet.
%
%   True when the rows of segment S were made from From, and nothing changed
%   them since.

up_to_date(S, From) :-
    origin(S, node(S), What),
    arg(1, What, made(From0, Stamp0)),
    From0 == From,
    segment_stamp(S, Stamp0),
    (   From = glue(Operands, _, _)
    ->  newer_segments(Operands, Stamp0, [])
    ;   true
    ).

%!  made_and_kept(+S, +What) is semidet.
%
%   True when it is remembered of segment S that What, and nothing changed its
%   rows since: recorded/2 and up_to_date/2 at once.

made_and_kept(S, What0) :-
    What0 =.. [Name, From],
    What =.. [Name, made(From, Stamp)],
    origin(S, node(S), What),
    segment_stamp(S, Stamp),
    !.

%!  not_kept(+Ss:list, -Others:list) is det.
%
%   Others are those of the segments Ss that are no primitives, or have other
%   rows than were made from them (kept_leaves/2), in order. Mostly few: what
%   need not be asked of the others need not take long.

not_kept(Ss, Others) :-
    kept_leaves(Ss, Kinds),
    foldl(other, Ss, Kinds, Others, []).

other(S, Kind, Others0, Others) :-
    (   Kind == other
    ->  Others0 = [S|Others]
    ;   Others0 = Others
    ).

%!  segments_of_kind(+Kind, +Ss:list, -Those:list) is det.
%
%   Those are the ones of the segments Ss that are of Kind, `solid`, `surface`
%   or `curve`, in order. Asked as not_kept/2 is.

segments_of_kind(Kind, Ss, Those) :-
    kept_leaves(Ss, Kinds),
    foldl(of_kind(Kind), Ss, Kinds, Those, []).

of_kind(Kind, S, Kept, Those0, Those) :-
    (   (   Kept == Kind
        ->  true
        ;   Kept == other,
            once(segment(S, Kind, _))
        )
    ->  Those0 = [S|Those]
    ;   Those0 = Those
    ).

%!  drop_record(+S) is det.

drop_record(S) :-
    retractall_facts(origin(S, node(S), _)),
    retractall_facts(origin(S, node(pieces), _)).

%!  record_pieces(+S, +Pieces) is det.
%
%   Remember of segment S, whose record is there, that its rows were made from
%   these Pieces: option pieces(Pieces) of boolean/3.

record_pieces(S, Pieces) :-
    assert_fact(origin(S, node(pieces), pieces(Pieces))).

%!  recorded_pieces(+S, -Pieces) is semidet.

recorded_pieces(S, Pieces) :-
    origin(S, node(pieces), pieces(Pieces)),
    !.

%!  joined_segment(?S) is nondet.
%
%   True when the rows of segment S are solids and surfaces side by side: it is
%   a node with the operation `join`, or was one (record_joined/1).

joined_segment(S) :-
    origin(S, node(S), What),
    is_join(What),
    (   nonvar(S)
    ->  !
    ;   true
    ).

is_join(join).
is_join(evaluated(made(join(_, _), _))).

%!  record_joined(+S) is det.
%
%   Remember of segment S, which is no node any more, that it was a join.

record_joined(S) :-
    assert_fact(origin(S, node(S), join)).
