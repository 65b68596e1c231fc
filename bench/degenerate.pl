:- module(bench_degenerate,
          [ degenerate_result/4,        % ?Case, ?Operation, -Volume, -Area
            agrees/3                    % +Value, +Wanted, +Relative
          ]).
/** <module> What the seven degenerate pairs of peers/boolean come to.

From closed forms: cubes, and cylinders on a polygon of 40 corners that cross
at right angles. Of the same sphere twice the measures are sums over its 1,280
triangles.
*/

%!  degenerate_result(?Case:string, ?Operation:string, -Volume, -Area).

degenerate_result(Case, Operation, Volume, Area) :-
    case_kind(Case, Kind),
    kind_result(Kind, Operation, Volume, Area).

case_kind("cyl2", cylinders).
case_kind("cyl2r", cylinders).
case_kind("cube2", beside).
case_kind("cube2r", beside).
case_kind("cubeov", overlapping).
case_kind("cubeovr", overlapping).
case_kind("same", same).

kind_result(beside, "union", 2, 11).
kind_result(beside, "inter", 0, 0).
kind_result(beside, "diff", 1, 6).
kind_result(overlapping, "union", 1.625, 8.75).
kind_result(overlapping, "inter", 0.375, 3.25).
kind_result(overlapping, "diff", 0.625, 5.25).
kind_result(same, "union", 4.152740817093058, 12.50649273396993).
kind_result(same, "inter", 4.152740817093058, 12.50649273396993).
kind_result(same, "diff", 0, 0).
kind_result(cylinders, Operation, Volume, Area) :-
    N = 40,
    Side is 2*sin(pi/N),
    Base is N/2*sin(2*pi/N),
    Volume1 is 4*Base,
    Area1 is 2*Base+4*N*Side,
    crossing(N, Side, Volume2, Area2),
    (   Operation = "union",
        Volume is 2*Volume1-Volume2,
        Area is 2*Area1-Area2
    ;   Operation = "inter",
        Volume = Volume2,
        Area = Area2
    ;   Operation = "diff",
        Volume is Volume1-Volume2,
        Area = Area1
    ).

%   crossing(N, Side, Volume, Area): what both have: at each height a square,
%   whose side is linear between corners.

crossing(N, Side, Volume, Area) :-
    Last is N//4-1,
    findall(V-A,
            ( between(0, Last, I),
              J is I+1,
              W0 is 2*cos(2*pi*I/N), W is 2*cos(2*pi*J/N),
              V is (sin(2*pi*J/N)-sin(2*pi*I/N))*(W0*W0+W0*W+W*W)/3,
              A is 4*Side*(W0+W)/2 ),
            Layers),
    sums(Layers, 0, 0, HalfVolume, HalfArea),
    Volume is 2*HalfVolume,
    Area is 2*HalfArea.

sums([], V, A, V, A).
sums([V1-A1|Layers], V0, A0, V, A) :-
    V2 is V0+V1,
    A2 is A0+A1,
    sums(Layers, V2, A2, V, A).

%!  agrees(+Value, +Wanted, +Relative) is semidet.

agrees(Value, Wanted, Relative) :-
    abs(Value-Wanted) =< Relative*max(abs(Wanted), Relative).
