:- module(sg_true_sweep,
          [ facets_swept/6,             % +S, +Part, +Sense, +Shape0, -Facets,
                                        % -Shape
            nearly_touched/3            % +Surface, +Others, -OtherSurface
          ]).
:- use_module('../csg/placed_surface',
              [placed_face/3, placed_surface/3, placed_term/2]).
:- use_module('../near', [before_angle/2, is_exactly/2, tolerance/2]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../primitive/primitive_pipe', [is_mitred/1]).
:- use_module('../store', [segment/3]).
:- use_module(true_part_loop, [facet_parted/3]).
:- use_module(true_parts, [polygon_drawn/4]).
:- use_module(true_pipe,
              [ pipe_centers/2, pipe_events/2, pipe_height/4, pipe_interval/4,
                pipe_met/4, pipe_near_touching/1
              ]).
:- use_module(true_shape, [part_facet/5]).
:- use_module(true_surface, [level_plane/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [append/2, append/3, last/2, member/2, nth0/3, nth1/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> Pipes that nearly touch each other by their sides.

Where the side of a cylinder or cone is nearly tangent to that of a cylinder,
cone or sphere, facets say nothing about how the surfaces meet: in one loop,
two, or a figure of eight. What is left of the pipe is found there without
them: a generator goes round it, and what the others take of it has a closed
form (true_pipe.pl). Between two *events*, as a tip or a rim, the same lines
bound what is left, one above another; so a facet is a row of cells, each
between two lines and two generators.

A cell is slab(T1, T2, Spans), Spans a list of Line1-Line2 upwards; a line is
rim(K), H = K, or J-Line, Line of true_pipe.pl of the Jth pipe.
*/

%!  facets_swept(+S, +Part, +Sense, +Shape0, -Facets, -Shape) is semidet.
%
%   Facets, those that are drawn, are what is left of Part of segment S, and
%   Shape has their vertices. Fails unless S is a cylinder or cone that was
%   trimmed by solid cylinders, cones, spheres and hemispheres alone, and nearly
%   touches one of them. Pieces between mitres do not end at rims: they fail.

facets_swept(S, Part, Sense, shape(Surface, Reach, _), Facets, Shape) :-
    Part = Leaf/Name,
    segment(S, _, trimmed(Leaf, Side, Others)),
    decision_is_default(stays_trimmed/4),
    memberchk(Surface, [cylinder(_, _, _, _),cone(_, _, _, _, _)]),
    solid_kind(Leaf, _),
    placed_term(Leaf, Term),
    \+ is_mitred(Term),
    maplist(other_pipe(Surface), Others, Pipes),
    once(( member(_-Pipe, Pipes), pipe_near_touching(Pipe) )),
    drawn_facets(S, Part, Name, Drawn),
    events(Pipes, Drawn, Events),
    slabs(Events, Side, Pipes, Slabs),
    nodes(Events, Slabs, Surface, Pipes, Tables, Nodes),
    Shape = shape(Surface, Reach, Nodes),
    maplist(facet_of_slabs(Sense, Slabs, Tables), Drawn, Facets0),
    maplist(parted(Shape), Facets0, Lists),
    append(Lists, Facets).

parted(Shape, Facet, Facets) :-
    (   Facet = facet(_, _, _, [])
    ->  Facets = []
    ;   facet_parted(Shape, Facet, Facets)
    ).

%   solid_kind(S, Kind): S is a solid of this Kind.

solid_kind(S, Kind) :-
    segment(S, solid, _),
    placed_term(S, Term),
    innermost(Term, Inner),
    functor(Inner, Kind, _).

innermost(Term, Inner) :-
    (   ( Term = at(_, Term1) ; Term = named(_, Term1) )
    ->  innermost(Term1, Inner)
    ;   Inner = Term
    ).

other_pipe(Surface, Other, OtherSurface-Pipe) :-
    solid_kind(Other, Kind),
    placed_surface(Other, _, OtherSurface),
    pipe_met(Kind, Surface, OtherSurface, Pipe).

%!  nearly_touched(+Surface, +Others, -OtherSurface) is nondet.
%
%   OtherSurface is Other-That, the surface of one of the segments Others, whose
%   side that of Surface nearly touches, as far as a closed form tells.

nearly_touched(Surface, Others, Other-OtherSurface) :-
    member(Other, Others),
    other_pipe(Surface, Other, OtherSurface-Pipe),
    pipe_near_touching(Pipe).

%   drawn_facets(S, Part, Name, Drawn): drawn(P, T1, T2) in order, all round:
%   the facets of what is drawn, with the first polygon of S that stands for
%   each; if none does, with a part of another one.

drawn_facets(S, Part, Name, Drawn) :-
    findall(PD-P-D,
            ( part_facet(S, Part, P, _, _),
              polygon_drawn(S, P, D, PD) ),
            Left0),
    sort(1, @<, Left0, [First|Left]),
    First = _-P0-D,
    findall(T1-drawn(P, T1, T2),
            ( placed_face(D, PD, curved(Name, [T1-T2])),
              (   memberchk(PD-P1-_, [First|Left])
              ->  P = P1
              ;   P = P0/PD
              ) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    pairs_keys_values(Pairs, _, Drawn).


                /*******************************
                *            EVENTS            *
                *******************************/

%   events(Pipes, Drawn, Events): event(T, Whats) in order, the last of which is
%   the first after a turn. Whats are border, none, and J-What of true_pipe.pl.

events(Pipes, Drawn, Events) :-
    Drawn = [drawn(_, T0, _)|_],
    tolerance(event, Near),
    findall(T-What, event(Pipes, Drawn, T, What), Pairs),
    findall(T-What,
            ( member(T1-What, Pairs),
              T2 is T1 - 360.0*floor((T1-T0)/360.0),
              (   T2 - T0 > 360.0 - Near
              ->  T = T0
              ;   T = T2
              ) ),
            Placed0),
    keysort(Placed0, Placed),
    together(Placed, Events0),
    Events0 = [event(First, Whats)|_],
    Last is First + 360.0,
    append(Events0, [event(Last, Whats)], Events).

event(_, Drawn, T, border) :-
    member(drawn(_, T, _), Drawn).
event(Pipes, _, T, J-What) :-
    nth1(J, Pipes, _-Pipe),
    pipe_events(Pipe, Events),
    member(T-What, Events).
event(Pipes, _, T, none) :-
    member(_-Pipe, Pipes),
    pipe_centers(Pipe, Centers),
    member(Center-Size, Centers),
    graded(Size, Off),
    ( T is Center-Off ; T is Center+Off ),
    pipe_interval(Pipe, T, _, _).

graded(Size, Off) :-
    Size < 3.0,
    (   Off = Size
    ;   Next is Size*1.6,
        graded(Next, Off)
    ).

%   together(Pairs, Events): one event of all that are in one place, but for
%   rounding; that is where a facet ends, or a tip is.

together([], []).
together([T-What|Pairs], [event(At, [What|Whats])|Events]) :-
    beside(Pairs, T, Same, Rest),
    pairs_keys_values(Same, _, Whats),
    (   member(Known, [border,_-tip]),
        member(At0-Known, [T-What|Same])
    ->  At = At0
    ;   At = T
    ),
    together(Rest, Events).

beside([T1-What|Pairs], T, [T1-What|Same], Rest) :-
    tolerance(event, Near),
    T1 - T < Near,
    !,
    beside(Pairs, T, Same, Rest).
beside(Pairs, _, [], Pairs).


                /*******************************
                *             SLABS            *
                *******************************/

slabs([_], _, _, []) :-
    !.
slabs([event(T1, _)|Events], Side, Pipes, [slab(T1, T2, Spans)|Slabs]) :-
    Events = [event(T2, _)|_],
    T is (T1+T2)/2.0,
    findall(Low-High,
            ( nth1(J, Pipes, _-Pipe),
              pipe_interval(Pipe, T, H1-Line1, H2-Line2),
              H1 < 1.0,
              H2 > 0.0,
              within(H1-(J-Line1), Low),
              within(H2-(J-Line2), High) ),
            Taken0),
    msort(Taken0, Taken),
    left(Side, Taken, Spans),
    slabs(Events, Side, Pipes, Slabs).

within(H-Line, Bound) :-
    (   H =< 0.0
    ->  Bound = 0.0-rim(0)
    ;   H >= 1.0
    ->  Bound = 1.0-rim(1)
    ;   Bound = H-Line
    ).

%   left(Side, Taken, Spans) is semidet: fails if what two pipes take overlaps.

left(inside, Taken, Spans) :-
    apart(Taken),
    findall(A-B, member((_-A)-(_-B), Taken), Spans).
left(outside, Taken, Spans) :-
    apart(Taken),
    left_between(Taken, 0.0-rim(0), Spans).

apart([]).
apart([_]) :-
    !.
apart([_-(H1-_),Next|Taken]) :-
    Next = (H2-_)-_,
    H1 < H2,
    apart([Next|Taken]).

left_between([], H1-Line, Spans) :-
    (   H1 < 1.0
    ->  Spans = [Line-rim(1)]
    ;   Spans = []
    ).
left_between([(H2-Line2)-Next|Taken], H1-Line1, Spans) :-
    (   H1 < H2
    ->  Spans = [Line1-Line2|Spans1]
    ;   Spans = Spans1
    ),
    left_between(Taken, Next, Spans1).


                /*******************************
                *             NODES            *
                *******************************/

%   nodes(Events, Slabs, Surface, Pipes, Table, Nodes): Table is turn(After,
%   Lines), Lines an assoc from the T of each event to the list of Line-Id, from
%   below, of the slabs on both sides; two that meet there have one Id. After is
%   the first T after a turn. Nodes as in true_shape.pl.

nodes(Events, Slabs, Surface, Pipes, Table, Nodes) :-
    last(Slabs, Last),
    append(Known, [_], Events),
    tables(Known, [Last|Slabs], 0, Pipes, Tables),
    findall(T-Lines, member(table(T, _, Lines), Tables), Pairs),
    Pairs = [First-Lines0|_],
    After is First + 360.0,
    list_to_assoc([After-Lines0|Pairs], ByAngle),
    Table = turn(After, ByAngle),
    findall(Id-node(T, H, Point, Met),
            ( member(table(T, Placed, _), Tables),
              member(placed(Id, H, Lines), Placed),
              surface_point(Surface, T, H, Point),
              findall(Other,
                      ( member(Line, Lines),
                        line_surface(Line, Pipes, Other) ),
                      Met0),
              sort(Met0, Met) ),
            Nodes0),
    list_to_assoc(Nodes0, Nodes).

line_surface(J-Line, Pipes, Surface) :-
    nth1(J, Pipes, Other-_),
    (   Line = cap(K)
    ->  H is float(K),
        level_plane(Other, H, Surface)
    ;   Surface = Other
    ).

tables([], _, _, _, []).
tables([event(T, Whats)|Events], [slab(_, _, Left),Right|Slabs], I, Pipes,
       [table(T, Placed, Known)|Tables]) :-
    Right = slab(_, _, Spans),
    findall(Line,
            ( ( member(A-B, Left) ; member(A-B, Spans) ),
              ( Line = A ; Line = B ) ),
            Lines0),
    sort(Lines0, Lines),
    findall(H-Order-Line,
            ( member(Line, Lines),
              line_height(Line, T, Whats, Pipes, H),
              line_order(Line, Order) ),
            Heights0),
    sort(0, @=<, Heights0, Heights),
    placed(Heights, Left, Spans, I, 0, Placed),
    findall(Line-Id,
            ( member(placed(Id, _, Of), Placed), member(Line, Of) ),
            Known),
    I1 is I+1,
    tables(Events, [Right|Slabs], I1, Pipes, Tables).

line_order(rim(K), K).
line_order(_-line(Sign), Sign).
line_order(_-cap(_), 0).

%   line_height(Line, T, Whats, Pipes, H): what is known to meet there is taken
%   from the plainer line.

line_height(rim(K), _, _, _, H) :-
    H is float(K).
line_height(J-Line, T, Whats, Pipes, H) :-
    (   member(J-both(Line, Plain), Whats)
    ->  (   Plain = rim(_)
        ->  line_height(Plain, T, Whats, Pipes, H)
        ;   line_height(J-Plain, T, Whats, Pipes, H)
        )
    ;   nth1(J, Pipes, _-Pipe),
        (   Line = line(_),
            memberchk(J-tip, Whats)
        ->  pipe_height(Pipe, foot, T, H)
        ;   pipe_height(Pipe, Line, T, H)
        )
    ).

%   placed(Heights, Left, Right, I, N, Placed): those of one height, but for
%   rounding, are one, unless it is where two loops touch.

placed([], _, _, _, _, []).
placed([H-_-Line|Heights], Left, Right, I, N,
       [placed(swept(I, N), H, [Line|Lines])|Placed]) :-
    same_height(Heights, H, [Line], Left, Right, Lines, Rest),
    N1 is N+1,
    placed(Rest, Left, Right, I, N1, Placed).

same_height([H1-_-Line|Heights], H, Before, Left, Right, [Line|Lines], Rest) :-
    is_exactly(H1-H, 1.0),
    \+ ( member(Line1, Before),
         parts(Line1, Line, Left),
         parts(Line1, Line, Right)
       ),
    !,
    same_height(Heights, H, [Line|Before], Left, Right, Lines, Rest).
same_height(Heights, _, _, _, _, [], Heights).

%   parts(Line1, Line2, Spans): what is left ends at the one and begins again at
%   the other.

parts(Line1, Line2, Spans) :-
    append(_, [_-Line1,Line2-_|_], Spans),
    !.


                /*******************************
                *            FACETS            *
                *******************************/

%   facet_of_slabs(Sense, Slabs, Table, Drawn, Facet)

facet_of_slabs(Sense, Slabs, Table, drawn(P, T1, T2),
               facet(P, T1, T2, Halves)) :-
    findall(slab(A, B, Spans),
            ( member(slab(A, B, Spans), Slabs),
              A >= T1,
              \+ before_angle(T2, B) ),
            Own),
    runs(Own, Runs),
    append([[run([], none)],Runs,[run([], none)]], Around),
    findall(Half,
            (   member(run(Ts, Spans), Runs),
                member(Low-High, Spans),
                (   along(Low, Ts, Table, A, B)
                ;   along(High, Ts, Table, B, A)
                ),
                sided(Sense, A, B, Half)
            ;   append(_, [run(Ts1, Spans1),run(Ts2, Spans2)|_], Around),
                up(Ts1, Spans1, Ts2, Spans2, Table, A, B),
                sided(Sense, A, B, Half)
            ),
            Halves0),
    sort(Halves0, Halves).

sided(1, A, B, half(A, B, tip)) :-
    A \== B.
sided(-1, A, B, half(B, A, tip)) :-
    A \== B.

%   runs(Slabs, Runs): run(Ts, Spans), of all slabs with the same spans that lie
%   side by side.

runs([], []).
runs([slab(A, B, Spans)|Slabs], [run([A,B|Ts], Spans)|Runs]) :-
    run_on(Slabs, Spans, Ts, Rest),
    runs(Rest, Runs).

run_on([slab(_, B, Spans)|Slabs], Spans, [B|Ts], Rest) :-
    !,
    run_on(Slabs, Spans, Ts, Rest).
run_on(Slabs, _, [], Slabs).

%   along(Line, Ts, Table, A, B) is nondet: to the right along Line, A and B
%   keys; a rim is one edge.

along(Line, Ts0, Table, A, B) :-
    (   Line = rim(_)
    ->  Ts0 = [First|_],
        last(Ts0, Last),
        Ts = [First,Last]
    ;   Ts = Ts0
    ),
    append(_, [T1,T2|_], Ts),
    line_key(Table, T1, Line, A),
    line_key(Table, T2, Line, B).

line_key(turn(After, Table), T, Line, k(Id, Turn)) :-
    get_assoc(T, Table, Lines),
    memberchk(Line-Id, Lines),
    (   T >= After
    ->  Turn = 1
    ;   Turn = 0
    ).

%   up(Ts1, Spans1, Ts2, Spans2, Table, A, B) is nondet: between two runs, from
%   key A to B there is something left on one side only; up on the right of
%   what is left.

up(Ts1, Spans1, Ts2, Spans2, Table, A, B) :-
    (   Ts2 = [T|_]
    ->  true
    ;   last(Ts1, T)
    ),
    Table = turn(_, ByAngle),
    get_assoc(T, ByAngle, Lines),
    append(_, [Low-Id1,High-Id2|_], Lines),
    Id1 \== Id2,
    (   between_lines(Spans1, Lines, Low, High)
    ->  \+ between_lines(Spans2, Lines, Low, High),
        maplist(line_key(Table, T), [Low,High], [A,B])
    ;   between_lines(Spans2, Lines, Low, High),
        maplist(line_key(Table, T), [High,Low], [A,B])
    ).

%   between_lines(Spans, Lines, Low, High): one of Spans covers what is from Low
%   to High, which are neighbours in Lines.

between_lines(Spans, Lines, Low, High) :-
    Spans \== none,
    member(From-To, Spans),
    nth0(I1, Lines, From-_),
    nth0(I2, Lines, To-_),
    nth0(J1, Lines, Low-_),
    nth0(J2, Lines, High-_),
    I1 =< J1,
    J2 =< I2,
    !.
