/* Rules under which one plane through a vertex says how two disks there lie
   to each other: the way of S.-H. Park, A Study on Geometrical Glue Operation
   between Non-manifold Models, 1996, section 3.1 and Fig. 5, with its
   misprints mended. See docs/rules.md, which says where this way is wrong.

       sanggwan glue facts/figures/glue_vertex.pl --rules docs/plane_rules.pl
*/

:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
:- use_module(library(pairs), [pairs_values/2]).

% Disk1 begins at A0 and ends at A1, Disk2 at A2 and A3, counter-clockwise about
% N. Of what a plane does not cut into two, a wire into one, it says nothing.

disk_relation(Disk1, Disk2, Relation) :-
    (   common_plane(Disk1, Disk2, N),
        ends(Disk1, N, A0, A1),
        ends(Disk2, N, A2, A3)
    ->  angle(N, A0, A1, Theta1),
        angle(N, A0, A2, Theta2),
        angle(N, A0, A3, Theta3),
        figure5(Theta1, Theta2, Theta3, Relation)
    ;   default(disk_relation(Disk1, Disk2, Relation))
    ).

% A direction equal to A0 reads as 0 or as a full turn, 4: whichever does not
% cross. The paper has < everywhere, and no order for what is equal.

figure5(Theta1, Theta2, Theta3, Relation) :-
    reading(Theta2, T2),
    reading(Theta3, T3),
    order(Theta1, T2, T3, Relation),
    !.
figure5(_, _, _, cross).                % (e), (f)

reading(Theta, Theta).
reading(0, 4).

order(T1, T2, T3, disjoint) :-          % (a)
    T1 =< T2, T2 =< T3.
order(T1, T2, T3, within) :-            % (c)
    T1 =< T3, T3 =< T2.
order(T1, T2, T3, around) :-            % (d)
    T2 =< T3, T3 =< T1.
order(T1, T2, T3, cover) :-             % (b)
    T3 =< T2, T2 =< T1.

% The plane has the middles of both disks; if these are in line, something else.

common_plane(Disk1, Disk2, N) :-
    middle(Disk1, M1),
    middle(Disk2, M2),
    (   Other = M2
    ;   disk_direction(Disk1, Other)
    ;   disk_direction(Disk2, Other)
    ),
    cross(M1, Other, N),
    N \== p(0,0,0),
    !.

middle(Disk, Middle) :-
    findall(P, disk_direction(Disk, P), Ps),
    sum(Ps, p(0,0,0), Middle).

sum([], Sum, Sum).
sum([p(X,Y,Z)|Ps], p(X0,Y0,Z0), Sum) :-
    X1 is X0+X,
    Y1 is Y0+Y,
    Z1 is Z0+Z,
    sum(Ps, p(X1,Y1,Z1), Sum).

% From A0 the plane is inside the disk, up to A1: T points between A0 or A1 and
% the next direction in which the plane meets the disk, and (A0 x T) . N > 0,
% (A1 x T) . N < 0. The paper has A0 x T for both. A0 and A1 of a wire are one.

ends(Disk, N, A0, A1) :-
    disk_arcs(Disk, Arcs),
    findall(A, met(Disk, Arcs, N, A), As),
    around(N, As, Round),
    (   Arcs == []
    ->  Round = [A0],
        A1 = A0
    ;   Round = [First|_],
        append(Round, [First], Closed),
        findall(A-Zone-B,
                ( append(_, [A,B|_], Closed),
                  half_way(N, A, B, T),
                  zone_at(Disk, T, Zone) ),
                Parts),
        same_length(Round, Parts),
        findall(A-B, ( member(A-Zone-B, Parts), Zone > 0 ), Inside),
        one_run(Inside, A0, A1)
    ).

met(Disk, [], N, A) :-
    disk_direction(Disk, A),
    dot(A, N, 0).
met(_, Arcs, N, X) :-
    member(arc(A,B,_,_), Arcs),
    dot(A, N, DA),
    dot(B, N, DB),
    (   DA =:= 0
    ->  X = A
    ;   DA*DB < 0
    ->  A = p(XA,YA,ZA),
        B = p(XB,YB,ZB),
        X1 is XA*abs(DB)+XB*abs(DA),
        Y1 is YA*abs(DB)+YB*abs(DA),
        Z1 is ZA*abs(DB)+ZB*abs(DA),
        X = p(X1,Y1,Z1)
    ;   DB =:= 0,
        X = B
    ).

% Each direction once, by its angle to the first.

around(N, [First|As], Round) :-
    findall(Angle-A,
            ( member(A, [First|As]), angle(N, First, A, Angle) ),
            Pairs),
    sort(1, @<, Pairs, Sorted),
    pairs_values(Sorted, Round).

half_way(N, A, B, T) :-
    cross(A, B, C),
    dot(C, N, Turn),
    (   Turn > 0
    ->  unit_sum(A, B, T)
    ;   Turn < 0
    ->  unit_sum(A, B, p(X,Y,Z)),
        X1 is -X,
        Y1 is -Y,
        Z1 is -Z,
        T = p(X1,Y1,Z1)
    ;   dot(A, B, Along),
        Along < 0
    ->  cross(N, A, T)
    ;   A = p(X,Y,Z),                   % all the way round
        X1 is -X,
        Y1 is -Y,
        Z1 is -Z,
        T = p(X1,Y1,Z1)
    ).

unit_sum(A, B, T) :-
    sum([A,B], p(0,0,0), T).

% The parts inside follow each other: one run of them, which may go over the
% first direction.

one_run(Inside, A0, A1) :-
    findall(A, ( member(A-_, Inside), \+ member(_-A, Inside) ), [A0]),
    findall(B, ( member(_-B, Inside), \+ member(B-_, Inside) ), [A1]).

% In place of atan2((A x B) . N, A . B), from 0 to a full turn, what grows
% with it and is exact: 0, 1, 2, 3 for the quarters. The paper has atan2(|A x
% B|, A . B), which does not tell left from right.

angle(N, A, B, Angle) :-
    cross(A, B, C),
    dot(C, N, Y),
    dot(A, B, X),
    (   Y >= 0, X > 0
    ->  Angle is Y rdiv (X+Y)
    ;   Y > 0
    ->  Angle is 1 - X rdiv (Y-X)
    ;   X < 0
    ->  Angle is 2 + Y rdiv (X+Y)
    ;   Angle is 3 + X rdiv (X-Y)
    ).

cross(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    X is Y1*Z2-Z1*Y2,
    Y is Z1*X2-X1*Z2,
    Z is X1*Y2-Y1*X2.

dot(p(X1,Y1,Z1), p(X2,Y2,Z2), Product) :-
    Product is X1*X2+Y1*Y2+Z1*Z2.
