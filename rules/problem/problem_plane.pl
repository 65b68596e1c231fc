:- module(sg_problem_plane,
          [ auxiliary_planes/3,         % +Way, +Points, -Planes
            planes_points/3,            % +Axis, +N, -Points
            straight_lines/3,           % +Branch, +Points, -Lines
            axis_place/3                % ?Axis, +P, -At
          ]).
:- use_module('../kernel', [surface_place/4, surface_value/4, surfaces_meet/4]).
:- use_module('../near', [is_on_surface/2]).
:- use_module('../store', [line/9, segment/3, t/6, v/5]).
:- use_module('../unrolling/true_surface', [polygon_surface/3]).
:- use_module('../vector', [difference/3, dot_product/3]).
:- use_module(problem_loop, [step_ends/5, whole_chains/1]).
:- use_module(problem_point, [generator/4, round_side/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc),
              [del_assoc/4, get_assoc/3, list_to_assoc/2, min_assoc/3]).
:- use_module(library(lists),
              [append/3, max_list/2, member/2, min_list/2, nth1/3, reverse/2]).
/** <module> Auxiliary cutting planes, as the textbook has them.

A plane cuts both bodies in lines that are easily drawn; where these meet are
points of the penetration line. Two ways:

  - planes square to an axis: they cut an upright cone in circles, and what lies
    along them in straight lines
  - planes through a generator of the branch that cut the other body in straight
    lines too, being parallel to its axis or through its apex
*/

%!  auxiliary_planes(+Axis, +Points, -Planes:list) is det.
%
%   Planes are plane(Axis, At, Sections), square to Axis (`x`, `y` or `z`)
%   through each of Points; Sections are the lines in which it cuts the
%   segments, which have not been cut by each other: lists of p(X,Y,Z), the
%   first again at the end if it closes. Their corners are on the true surfaces
%   of cylinders and cones.

auxiliary_planes(Axis, Points, Planes) :-
    findall(At,
            ( member(point(_, _, _, P), Points), axis_place(Axis, P, At) ),
            Ats0),
    msort(Ats0, Ats1),
    foldl(apart, Ats1, [], Ats2),
    reverse(Ats2, Ats),
    findall(plane(Axis, At, Sections),
            ( member(At, Ats),
              findall(Section,
                      ( segment(S, _, _),
                        sections(S, Axis, At, Own),
                        member(Section, Own) ),
                      Sections) ),
            Planes).

apart(At, Ats0, Ats) :-
    (   Ats0 = [Last|_],
        is_on_surface(At-Last, 1.0+abs(At))
    ->  Ats = Ats0
    ;   Ats = [At|Ats0]
    ).

%!  axis_place(?Axis, +P, -At) is nondet.
%
%   At is the coordinate of P along Axis.

axis_place(x, p(X,_,_), X).
axis_place(y, p(_,Y,_), Y).
axis_place(z, p(_,_,Z), Z).

%   sections(S, Axis, At, Lines): each triangle that has corners on both sides
%   is entered through one edge and left through another; what is on the plane
%   counts as above. So lines are followed by edges, not by places.

sections(S, Axis, At, Lines) :-
    findall(From-to(To, Start, P),
            ( t(S, _, _, A, B, C),
              maplist(sided(S, Axis, At), [A,B,C], Corners),
              crossed(Corners, From, Start, To, P) ),
            Steps0),
    sort(1, @<, Steps0, Steps),
    list_to_assoc(Steps, Next),
    findall(To, member(_-to(To,_,_), Steps), Tos0),
    sort(Tos0, Tos),
    findall(From,
            ( member(From-_, Steps), \+ memberchk(From, Tos) ),
            Starts),
    followed(Starts, Next, Open, Rest),
    round(Rest, Closed),
    append(Open, Closed, Lines).

sided(S, Axis, At, V, corner(V, Off, P)) :-
    v(S, V, X, Y, Z),
    P = p(X,Y,Z),
    axis_place(Axis, P, Here),
    !,
    Off is Here-At.

%   crossed(Corners, From, Start, To, P): the plane leaves the triangle through
%   edge To, at P, and enters it through From, at Start.

crossed([A,B,C], From, Start, To, P) :-
    member(U-V-W, [A-B-C,B-C-A,C-A-B]),
    is_below(U),
    \+ is_below(V),
    !,
    edge_key(U, V, To),
    (   is_below(W)
    ->  edge_key(V, W, From),
        edge_point(V, W, Start)
    ;   edge_key(W, U, From),
        edge_point(W, U, Start)
    ),
    edge_point(U, V, P).

is_below(corner(_, Off, _)) :-
    Off < 0.0.

edge_key(corner(V,_,_), corner(W,_,_), Key) :-
    Low is min(V, W),
    High is max(V, W),
    Key = Low/High.

edge_point(corner(_,F,P), corner(_,G,Q), p(X,Y,Z)) :-
    Part is F/(F-G),
    P = p(X1,Y1,Z1),
    Q = p(X2,Y2,Z2),
    X is X1 + Part*(X2-X1),
    Y is Y1 + Part*(Y2-Y1),
    Z is Z1 + Part*(Z2-Z1).

%   followed(Starts, Next0, Lines, Next): Lines begin at Starts.

followed([], Next, [], Next).
followed([Start|Starts], Next0, [[P|Line]|Lines], Next) :-
    get_assoc(Start, Next0, to(_,P,_)),
    run(Start, Next0, Line, Next1),
    followed(Starts, Next1, Lines, Next).

run(From, Next0, Line, Next) :-
    (   del_assoc(From, Next0, to(To,_,P), Next1)
    ->  Line = [P|Line1],
        run(To, Next1, Line1, Next)
    ;   Line = [],
        Next = Next0
    ).

round(Next0, Lines) :-
    (   min_assoc(Next0, From, _)
    ->  run(From, Next0, Line, Next),
        Line = [First|_],
        append(Line, [First], Ring),
        Lines = [Ring|Lines1],
        round(Next, Lines1)
    ;   Lines = []
    ).

%!  planes_points(+Axis, +N, -Points:list) is det.
%
%   Points, as those of numbered_points/3, are where N planes square to Axis, in
%   equal steps between the ends of the penetration lines, meet these. The
%   segments have been cut.

planes_points(Axis, N, Points) :-
    whole_chains(Chains),
    findall(At,
            ( member(chain(S, _, _, Steps), Chains),
              member(Step, Steps),
              step_ends(S, Step, P, _, _),
              axis_place(Axis, P, At) ),
            Ats),
    (   Ats == []
    ->  Points = []
    ;   min_list(Ats, Low),
        max_list(Ats, High),
        Unit is (High-Low)/(N+1),
        findall(Loop-P,
                ( nth1(Loop, Chains, chain(S, _, _, Steps)),
                  member(Step, Steps),
                  step_point(S, Step, Axis, levels(Low,Unit,N), P) ),
                Found),
        findall(point(I, Loop, none, P), nth1(I, Found, Loop-P), Points)
    ).

%   step_point(S, Step, Axis, Levels, P) is nondet: in the order of the step.

step_point(S, Step, Axis, levels(Low,Unit,N), P) :-
    step_ends(S, Step, From, To, _),
    axis_place(Axis, From, A),
    axis_place(Axis, To, B),
    A =\= B,
    findall(Part-At,
            ( between(1, N, K),
              At is Low + K*Unit,
              ( A < At, At =< B ; B =< At, At < A ),
              Part is (At-A)/(B-A) ),
            Ats0),
    keysort(Ats0, Ats),
    member(Part-At, Ats),
    edge_point(corner(_,-Part,From), corner(_,1.0-Part,To), Near),
    true_point(Step, Axis, At, From, To, Near, P).

true_point(Step, Axis, At, From, To, p(X,Y,Z), P) :-
    L is abs(Step),
    line(L, S1, P1, _, _, S2, P2, _, _),
    polygon_surface(S1, P1, Surface1),
    polygon_surface(S2, P2, Surface2),
    axis_plane(Axis, At, Plane),
    difference(From, To, Way),
    dot_product(Way, Way, Square),
    Reach is 4.0*sqrt(Square),
    surfaces_meet([Surface1,Surface2,Plane], Reach, point(X,Y,Z),
                  point(X1,Y1,Z1)),
    !,
    P = p(X1,Y1,Z1).
true_point(_, _, _, _, _, P, P).

axis_plane(x, At, plane(1.0,0.0,0.0,D)) :-
    D is -At.
axis_plane(y, At, plane(0.0,1.0,0.0,D)) :-
    D is -At.
axis_plane(z, At, plane(0.0,0.0,1.0,D)) :-
    D is -At.

%!  straight_lines(+Branch, +Points, -Lines:list) is det.
%
%   Lines are From-To, each once: the generators of other segments than Branch
%   that go through Points. The plane through one of them and the axis, or apex,
%   of the branch cuts both in straight lines.

straight_lines(Branch, Points, Lines) :-
    findall(From-To,
            ( member(point(_, _, _, p(X,Y,Z)), Points),
              segment(S, _, _),
              S \== Branch,
              round_side(S, Surface),
              surface_value(Surface, point(X,Y,Z), Off, _),
              is_on_surface(Off, 1.0 + abs(X) + abs(Y) + abs(Z)),
              surface_place(Surface, point(X,Y,Z), T, H),
              H >= 0.0,
              H =< 1.0,
              Degrees is round(T*1.0e6)/1.0e6,
              generator(Surface, Degrees, From, To) ),
            Lines0),
    sort(Lines0, Lines).
