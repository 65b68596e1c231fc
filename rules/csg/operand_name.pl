:- encoding(utf8).
:- module(sg_operand_name,
          [ note_unnumbered/3,          % +S, +N, +I
            operand_name/2,             % +S, -Name
            fault_named/2,              % +Fault0, -Fault
            name_root/2,                % +Name, -S
            operand_name_en//1,         % +Name
            operand_name_ko//1          % +Name
          ]).
:- use_module(csg_record, [recorded/2]).
:- use_module(csg_term, [plain_name/2, is_node_term/1]).
:- use_module('../store', [segment/3, origin/3, assert_fact/1]).
:- use_module(library(apply), [maplist/3]).
/** <module> What an operand is called that its user gave no number.

    segment(5, solid, difference([1, union([2, rectangle(size(2, 2))])])).

The union gets a segment of its own, and so does the rectangle; but nobody who
reads that the surface is segment 7 would know which. So in errors such a
segment is operand(I, Kind, Parent): the I-th operand of Parent, a segment or
such a name again; and what was placed by evaluation is what it was placed from.

    origin(S, node(N), operand(I))      S is the I-th operand of node N
*/

%!  note_unnumbered(+S, +N, +I) is det.
%
%   Remember that segment S was made for the I-th operand of node N.

note_unnumbered(S, N, I) :-
    assert_fact(origin(S, node(N), operand(I))).

%!  operand_name(+S, -Name) is det.
%
%   Name is S, or operand(I, Kind, Parent).

operand_name(S, Name) :-
    (   origin(S, node(N), operand(I))
    ->  segment(S, _, Term),
        kind(Term, Kind),
        Name = operand(I, Kind, Parent),
        operand_name(N, Parent)
    ;   recorded(S, helper(placed(Leaf-_, _)))
    ->  operand_name(Leaf, Name)
    ;   Name = S
    ).

kind(Term, Kind) :-
    (   is_node_term(Term)
    ->  plain_name(Term, Kind)
    ;   inner(Term, Inner),
        functor(Inner, Kind, _)
    ).

inner(at(_, Term0), Term) :-
    !,
    inner(Term0, Term).
inner(named(Name, _), Name) :-
    !.
inner(Term, Term).

%!  fault_named(+Fault0, -Fault) is det.
%
%   Fault is Fault0, as of csg_term.pl or geometry_error(_), its segments by
%   their names.

fault_named(Fault0, Fault) :-
    (   Fault0 = csg(What0),
        fault_segments(What0, What, Ss, Names)
    ->  Fault = csg(What),
        maplist(operand_name, Ss, Names)
    ;   Fault0 = operand(S, Faults)
    ->  operand_name(S, Name),
        Fault = operand(Name, Faults)
    ;   Fault = Fault0
    ).

fault_segments(missing(S, C), missing(N, C), [S], [N]).
fault_segments(curve(S, C), curve(N, M), [S,C], [N,M]).
fault_segments(surface(S, C, Op), surface(N, M, Op), [S,C], [N,M]).
fault_segments(too_many(S, Count), too_many(N, Count), [S], [N]).
fault_segments(no_front(S), no_front(N), [S], [N]).
fault_segments(not_through(S), not_through(N), [S], [N]).

%!  name_root(+Name, -S) is det.
%
%   S is the segment that the user wrote and that Name is in.

name_root(operand(_, _, Parent), S) :-
    !,
    name_root(Parent, S).
name_root(S, S).

%!  operand_name_en(+Name)// is det.
%!  operand_name_ko(+Name)// is det.
%
%   Name in words.

operand_name_en(operand(I, Kind, Parent)) -->
    !,
    { ordinal(I, Text) },
    [ 'the ~w operand (~w) of '-[Text, Kind] ],
    operand_name_en(Parent).
operand_name_en(S) -->
    [ 'segment ~d'-[S] ].

ordinal(I, Text) :-
    (   I mod 100 =\= 11, I mod 10 =:= 1
    ->  End = st
    ;   I mod 100 =\= 12, I mod 10 =:= 2
    ->  End = nd
    ;   I mod 100 =\= 13, I mod 10 =:= 3
    ->  End = rd
    ;   End = th
    ),
    atom_concat(I, End, Text).

operand_name_ko(operand(I, Kind, Parent)) -->
    !,
    operand_name_ko(Parent),
    [ '의 ~d번째 피연산자 (~w)'-[I, Kind] ].
operand_name_ko(S) -->
    [ '세그먼트 ~d'-[S] ].
