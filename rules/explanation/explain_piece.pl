:- module(sg_explain_piece,
          [ piece_asked/2,              % ?S, ?Piece
            piece_because/3             % +S, +Piece, -Because
          ]).
:- use_module('../solid/boolean', [stays/3]).
:- use_module('../csg/csg', [is_node/1]).
:- use_module('../solid/csg_evaluate', [evaluate/1]).
:- use_module('../solid/csg_flat', [flat_leaves/2]).
:- use_module('../csg/csg_record', [recorded/2]).
:- use_module('../exact', [vertex_exact/5]).
:- use_module(explain_pair, [decided_by/2]).
:- use_module('../kernel', [model_tolerance/1, windings/3]).
:- use_module('../penetration/penetration', [penetrate/1]).
:- use_module('../store',
              [p/3, t/6, plane/6, from_p/5, segment/3, facts_snapshot/1]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, member/2, nth1/3, subtract/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(yall), [(>>)/4]).

/** <module> Explain: why a piece of a solid was kept or dropped (CB-3, CB-4).

A *piece* of a node's boundary is a part of one polygon of one operand. It stays
if just one of its two sides is inside. So two witness points, just below and
just above the middle of one of its triangles, are asked of every operand: how
often it goes round them. Then the decision, stays/3, is asked again.

Of pieces in one place that of the first operand stands for all. The witnesses
are four tolerances off the piece: what is nearer than that to
another surface may be told otherwise than it was decided.
*/

%!  piece_asked(?S, ?Piece) is nondet.
%
%   True when there is something to say of Piece in the boundary of node S: a
%   polygon P of it, or S0-P0, a polygon of an operand.

piece_asked(S, Piece) :-
    is_asked_node(S),
    (   nonvar(Piece),
        Piece = S0-P0
    ->  operand_of(S, S0),
        p(S0, P0, _)
    ;   Piece = P,
        p(S, P, _)
    ).

is_asked_node(S) :-
    segment(S, _, _),
    is_node(S),
    \+ \+ recorded(S, evaluated(of(_, _, _))).

%   operand_of(S, S0): once, however often S0 is placed.

operand_of(S, S0) :-
    expression(S, Expression),
    flat_leaves(Expression, Leaves),
    findall(Operand, ( member(K, Leaves), leaf_operand(K, Operand) ),
            Operands0),
    sort(Operands0, Operands),
    member(S0, Operands).

leaf_operand(K, K).
leaf_operand(K, S0) :-
    recorded(K, What),
    arg(1, What, placed(S0-_, _)).

expression(S, Expression) :-
    recorded(S, evaluated(of(Expression, _, _))).

%!  piece_because(+S, +Piece, -Because) is det.
%
%   Because is the list of because(Statement, Because) for Piece, as of
%   piece_asked/2.

piece_because(S, S0-P0, [because(polygon_in(S0, P0, S), Because)]) :-
    !,
    evaluate(S),
    expression(S, Expression),
    findall(because(became(S, P, Sense), []),
            ( instance_of(S, S0, K), from_p(S, P, K, P0, Sense) ),
            Became),
    findall(Facts, ( instance_of(S, S0, K),
                     polygon_parts(Expression, K, P0, Parts),
                     part_facts(Parts, Facts) ),
            Lists),
    foldl(appended, Lists, Became, Because).
piece_because(S, P, [because(piece(S, P), Because)]) :-
    expression(S, Expression),
    findall(because(piece_of(K, P0, Sense), Facts),
            ( from_p(S, P, K, P0, Sense),
              (   piece_witness(S, P, Sense, Middle, Normal)
              ->  witness_facts(Expression, K-P0, Middle, Normal, Facts, _)
              ;   Facts = []
              ) ),
            Because).

appended(List, Front, All) :-
    append(Front, List, All).

%   instance_of(S, S0, K): leaf K of the expression of S is S0, or S0 placed.

instance_of(S, S0, K) :-
    expression(S, Expression),
    flat_leaves(Expression, Leaves),
    member(K, Leaves),
    (   K == S0
    ->  true
    ;   recorded(K, What),
        arg(1, What, placed(S0-_, _))
    ).

%   piece_witness(S, P, Sense, Middle, Normal): of the largest triangle of P.
%   Normal is outward for the operand.

piece_witness(S, P, Sense, Middle, n(X,Y,Z)) :-
    findall(Size-Corners,
            ( t(S, P, _, A, B, C),
              maplist(corner(S), [A,B,C], Corners),
              twice_area(Corners, Size) ),
            Triangles),
    largest(Triangles, Corners),
    middle(Corners, Middle),
    plane(S, P, X0, Y0, Z0, _),
    X is X0*Sense,
    Y is Y0*Sense,
    Z is Z0*Sense.

largest(Triangles, Corners) :-
    sort(1, @>=, Triangles, [_-Corners|_]).

corner(S, V, p(X,Y,Z)) :-
    once(vertex_exact(S, V, X, Y, Z)).

%   twice_area(Corners, Size): rounded; it only chooses.

twice_area([p(X1,Y1,Z1), p(X2,Y2,Z2), p(X3,Y3,Z3)], Size) :-
    A1 is X2-X1, B1 is Y2-Y1, C1 is Z2-Z1,
    A2 is X3-X1, B2 is Y3-Y1, C2 is Z3-Z1,
    Size is float((B1*C2-C1*B2)**2 + (C1*A2-A1*C2)**2 + (A1*B2-B1*A2)**2).

middle([p(X1,Y1,Z1), p(X2,Y2,Z2), p(X3,Y3,Z3)], p(X,Y,Z)) :-
    X is (X1+X2+X3) rdiv 3,
    Y is (Y1+Y2+Y3) rdiv 3,
    Z is (Z1+Z2+Z3) rdiv 3.

%   witness_facts(Expression, K-P0, Middle, Normal, Facts, Verdict): Facts say
%   where the witness is, what is round it, and what follows.

witness_facts(Expression, K-P0, Middle, Normal, Facts, Verdict) :-
    Middle = p(X,Y,Z),
    maplist([N,F]>>(F is float(N)), [X,Y,Z], [Xf,Yf,Zf]),
    side_point(Middle, Normal, -1, Below),
    side_point(Middle, Normal, 1, Above),
    flat_leaves(Expression, Leaves),
    findall(side(L, B, A),
            ( member(L, Leaves),
              \+ segment(L, surface, _),
              windings(L, [Below,Above], [B0,A0]),
              maplist(counted, [B0,A0], [B,A]) ),
            Sides),
    Component = component(0, K, P0, point(Xf,Yf,Zf), Sides, only),
    (   member(side(L1, B1, A1), Sides),
        L1 < K,
        B1 =\= A1
    ->  Verdict = covered(L1)
    ;   stays(Expression, Component, Sense)
    ->  Verdict = kept(Sense)
    ;   Verdict = dropped
    ),
    decided_by(stays/3, By),
    findall(because(round(L, B, A), []), member(side(L, B, A), Sides), Rounds),
    append([because(witness(point(Xf,Yf,Zf)), [])|Rounds],
           [because(verdict(Verdict, By), [])], Facts).

counted(on, 0) :-
    !.
counted(N, N).

side_point(p(X0,Y0,Z0), n(A,B,C), Sign, point(X,Y,Z)) :-
    model_tolerance(Tolerance),
    H is Sign*4*rational(Tolerance),
    X is X0 + H*rational(A),
    Y is Y0 + H*rational(B),
    Z is Z0 + H*rational(C).

%   polygon_parts(Expression, K, P, Parts): Parts are Verdict-Facts of the
%   triangles of P after it was cut by the other leaves; the cut is forgotten.

polygon_parts(Expression, K, P, Parts) :-
    flat_leaves(Expression, Leaves),
    subtract(Leaves, [K], Others),
    findall(Pair, ( member(L, Others), ordered(K, L, Pair) ), Pairs),
    plane(K, P, A, B, C, _),
    facts_snapshot(sg_explain_piece:cut_middles(Pairs, K, P, Middles)),
    findall(Verdict-Facts,
            ( member(Middle, Middles),
              witness_facts(Expression, K-P, Middle, n(A,B,C), Facts,
                            Verdict) ),
            Parts).

ordered(K, L, Pair) :-
    (   K < L
    ->  Pair = K-L
    ;   Pair = L-K
    ).

cut_middles(Pairs, K, P, Middles) :-
    penetrate(Pairs),
    findall(Size-Middle,
            ( t(K, P, _, A, B, C),
              maplist(corner(K), [A,B,C], Corners),
              twice_area(Corners, Size0),
              Size is -Size0,
              middle(Corners, Middle) ),
            Sized0),
    keysort(Sized0, Sized),
    findall(Middle, member(_-Middle, Sized), Middles).

%   part_facts(Parts, Facts): for each verdict how many triangles it takes, with
%   the largest as example.

part_facts(Parts0, Facts) :-
    keysort(Parts0, Parts),
    group_pairs_by_key(Parts, Groups),
    findall(because(triangles_of(N, Verdict), Example),
            ( member(Verdict-Examples, Groups),
              length(Examples, N),
              nth1(1, Examples, Example) ),
            Facts).
