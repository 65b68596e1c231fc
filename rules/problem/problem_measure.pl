:- module(sg_problem_measure,
          [ measure_there/1,            % +Measure
            measured/5,                 % +Measure, +Tolerance, +N, +Points,
                                        % -Value
            measure_marks/5,            % +Measure, +N, +Points, +Names, -Marks
            measure_working/4,          % +Measure, +N, +Points, -Working
            measure_rank/4,             % +Measure, +Points, -Rank, -Count
            measure_shown/4             % +Value, +Unit, +Tolerance, -Text
          ]).
:- use_module('../csg/placed_surface',
              [facet_surface/3, placed_surface/3, placed_term/2]).
:- use_module('../development/seam_measure', [pattern_area/2]).
:- use_module('../model/measures', [bounding_box/3, volume/2]).
:- use_module('../near', [is_on_surface/2, is_rounding/2, tolerance/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../primitive/primitive', [primitive_name/2]).
:- use_module('../solid/inside', [winding/3]).
:- use_module('../store', 
              [e/5, edge_polygon/3, facts_snapshot/1, p/3, segment/3, v/5]).
:- use_module('../unrolling/true_table', [true_length_rows/2]).
:- use_module('../vector',
              [ angle_between/3, cross_product/3, difference/3,
                dot_product/3
              ]).
:- use_module(problem_item, [along_views/2, measure_unit/4]).
:- use_module(problem_pattern, [with_patterns/4]).
:- use_module(problem_point,
              [branch_generators/3, numbered_points/3, round_side/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists),
              [max_list/2, member/2, min_list/2, nth1/3, sum_list/2]).
/** <module> Measures that a pupil takes, computed.

    shortest_generator(S)   of the N generators in the pattern of segment S,
    longest_generator(S)    which is trimmed by the others
    generator(S, I)         of generator I of S (branch_generators/3) what is
                            outside of the others, from its free end on
    edge(S, V1, V2)         from vertex to vertex of S
    angle(S, V1, V2, V3)    at V2
    area(S), perimeter(S)   of the pattern of S, all its pieces
    sector(S)               the angle of the pattern of a right circular cone
    volume(S)               of S alone
    coordinate(I, Axis)     of numbered point I, from where the model begins

in units of the model (mm) and degrees. They are those of the smooth surfaces
that facets stand for.
*/

%!  measured(+Measure, +Tolerance, +N, +Points, -Value) is det.
%
%   Value is that of Measure, far nearer to the truth than Tolerance. The
%   segments have not been cut; Points are those of numbered_points/3, when they
%   were.
%
%   @error model_error(problem(What)): no_measure(Measure), too_fine(Measure,
%   Tolerance)

measured(Measure, Tolerance, N, Points, Value) :-
    (   \+ of_curve(Measure),
        value(Measure, Tolerance, N, Points, Value0)
    ->  Value is Value0 + 0.0
    ;   problem_error(no_measure(Measure))
    ).

of_curve(Measure) :-
    Measure \= coordinate(_, _),
    Measure \= edge(_, _, _),
    Measure \= angle(_, _, _, _),
    arg(1, Measure, S),
    segment(S, curve, _).

problem_error(What) :-
    throw(error(model_error(problem(What)), _)).

%!  measure_there(+Measure) is det.
%
%   What Measure names is in the model.
%
%   @error model_error(problem(What)): no_segment(S), no_vertex(S, V)

measure_there(coordinate(_, _)) :-
    !.
measure_there(Measure) :-
    arg(1, Measure, S),
    (   segment(S, _, _)
    ->  true
    ;   problem_error(no_segment(S))
    ),
    (   Measure =.. [Name,_|Vs],
        memberchk(Name, [edge,angle]),
        member(V, Vs),
        \+ v(S, V, _, _, _)
    ->  problem_error(no_vertex(S, V))
    ;   true
    ).

value(shortest_generator(S), _, N, _, Value) :-
    generator_lengths(S, N, Lengths),
    min_list(Lengths, Value).
value(longest_generator(S), _, N, _, Value) :-
    generator_lengths(S, N, Lengths),
    max_list(Lengths, Value).
value(generator(S, I), _, N, _, Value) :-
    free_end(S, I, N, P),
    cut_points(S, N, Points),
    branch_generators(S, N, Generators),
    memberchk(generator(I, T, From, To), Generators),
    (   P == From
    ->  Far = To
    ;   Far = From
    ),
    findall(Length,
            ( ( Q = Far ; member(point(_, _, T, Q), Points) ),
              distance(P, Q, Length) ),
            Lengths),
    min_list(Lengths, Value).
value(edge(S, V, W), _, _, _, Value) :-
    corner(S, V, P),
    corner(S, W, Q),
    distance(P, Q, Value).
value(angle(S, U, V, W), _, _, _, Value) :-
    corner(S, U, A),
    corner(S, V, B),
    corner(S, W, C),
    difference(A, B, BA),
    difference(C, B, BC),
    angle_between(BA, BC, Radians),
    Value is Radians*180/pi.
value(perimeter(S), Tolerance, _, _, Value) :-
    fine_enough(perimeter(S), Tolerance, Tolerance/200.0, Chord),
    pattern_perimeter(S, [chord(Chord)], Value).
value(area(S), Tolerance, _, _, Value) :-
    pattern_perimeter(S, [], Perimeter),
    fine_enough(area(S), Tolerance, Tolerance/(4.0*Perimeter), Chord),
    with_patterns(S, [chord(Chord)], Ds,
                  ( findall(Area, ( member(D, Ds), pattern_area(D, Area) ),
                            Areas),
                    sum_list(Areas, Value) )).
value(volume(S), _, _, _, Value) :-
    segment(S, solid, _),
    (   smooth_volume(S, Value0)
    ->  Value = Value0
    ;   \+ ( p(S, P, _), facet_surface(S, P, _) ),
        volume(S, Value)
    ).
value(sector(S), _, _, _, Value) :-
    right_cone(S, R, Length),
    Value is 360.0*R/Length.
value(coordinate(I, Axis), _, _, Points, Value) :-
    point_along(I, Axis, Points, At, Lowest),
    Value is At-Lowest.

%!  measure_working(+Measure, +N, +Points, -Working) is semidet.
%
%   Working says how the value of Measure comes about, in units of the model;
%   arguments as of measured/5. It is one of
%
%     - legs(p(DX,DY,DZ))      how far it is from one end to the other
%     - arms(P, Q)             from the vertex along both sides
%     - lengths(Pieces)        of each piece I-Length of its generators
%     - cone(Radius, Length)   of a right circular cone, of its generators
%     - pieces(Areas)          of the pieces of a pattern
%     - from(Lowest, At)       where the model begins, where the point is

measure_working(edge(S, V, W), _, _, legs(p(DX,DY,DZ))) :-
    corner(S, V, P),
    corner(S, W, Q),
    difference(P, Q, p(X,Y,Z)),
    DX is abs(X),
    DY is abs(Y),
    DZ is abs(Z).
measure_working(angle(S, U, V, W), _, _, arms(BA, BC)) :-
    corner(S, U, A),
    corner(S, V, B),
    corner(S, W, C),
    difference(A, B, BA),
    difference(C, B, BC).
measure_working(Measure, N, _, lengths(Pieces)) :-
    ( Measure = shortest_generator(S) ; Measure = longest_generator(S) ),
    with_patterns(S, [generators(N)], Ds,
                  findall(Piece,
                          ( member(D, Ds), piece_lengths(D, N, Piece) ),
                          Pieces)).
measure_working(sector(S), _, _, cone(Radius, Length)) :-
    right_cone(S, Radius, Length).
measure_working(area(S), _, _, pieces(Areas)) :-
    with_patterns(S, [], Ds,
                  findall(Area, ( member(D, Ds), pattern_area(D, Area) ),
                          Areas)).
measure_working(coordinate(I, Axis), _, Points, from(Lowest, At)) :-
    point_along(I, Axis, Points, At, Lowest).

%   piece_lengths(D, N, Piece): the first generator closes the piece, too.

piece_lengths(D, N, Piece) :-
    segment(D, _, true_development(_, _)),
    true_length_rows(D, Rows),
    findall(I-Length,
            ( member(row(I,_,_,_,_,Length,_,_,_), Rows), I =< N ),
            Piece).

%   right_cone(S, Radius, Length): of its base, and of its generators.

right_cone(S, R, Length) :-
    placed_surface(S, side, cone(_, U0, V0, W0, K)),
    as_vector(U0, U),
    as_vector(V0, V),
    as_vector(W0, W),
    lengths([U,V,W], [R,R1,H]),
    is_rounding(R-R1, R),
    right_angles([U-V,U-W,V-W]),
    Apex is H/(1.0-K),
    Length is sqrt(R*R + Apex*Apex).

point_along(I, Axis, Points, At, Lowest) :-
    memberchk(point(I, _, _, Place), Points),
    axis_coordinate(Axis, Place, At),
    findall(Low, ( bounding_box(_, point(X,Y,Z), _),
                   axis_coordinate(Axis, p(X,Y,Z), Low) ),
            Lows),
    min_list(Lows, Lowest).

axis_coordinate(x, p(X,_,_), X).
axis_coordinate(y, p(_,Y,_), Y).
axis_coordinate(z, p(_,_,Z), Z).

corner(S, V, p(X,Y,Z)) :-
    v(S, V, X, Y, Z),
    !.

distance(P, Q, Length) :-
    difference(P, Q, PQ),
    dot_product(PQ, PQ, Square),
    Length is sqrt(Square).

generator_lengths(S, N, Lengths) :-
    with_patterns(S, [generators(N)], Ds,
                  findall(Length,
                          ( member(D, Ds),
                            segment(D, _, true_development(_, _)),
                            true_length_rows(D, Rows),
                            member(row(_,_,_,_,_,Length,_,_,_), Rows) ),
                          Lengths)),
    Lengths = [_|_].

%   cut_points(S, N, Points): where the generators of S meet others.

cut_points(S, N, Points) :-
    facts_snapshot(( penetrate(all, []), numbered_points(S, N, Points) )).

%   free_end(S, I, N, P): the end of generator I of S that lies outside of the
%   others: the lower one, or else the upper one.

free_end(S, I, N, P) :-
    branch_generators(S, N, Generators),
    member(generator(I, _, From, To), Generators),
    member(P, [From,To]),
    P = p(X,Y,Z),
    \+ ( segment(Other, solid, _),
         Other \== S,
         winding(Other, point(X,Y,Z), Winding),
         Winding \== 0 ),
    !.

%   fine_enough(Measure, Tolerance, Chord0, Chord): patterns are not finer than
%   a part of their size.

fine_enough(Measure, Tolerance, Chord0, Chord) :-
    Chord is Chord0,
    (   aggregate_all(max(abs(X) + abs(Y) + abs(Z)), v(_, _, X, Y, Z), Size),
        tolerance(place, Near),
        Chord < 2*Near*Size
    ->  problem_error(too_fine(Measure, Tolerance))
    ;   true
    ).

pattern_perimeter(S, Options, Perimeter) :-
    with_patterns(S, Options, Ds,
                  ( findall(Length,
                            ( member(D, Ds), border_length(D, Length) ),
                            Lengths),
                    sum_list(Lengths, Perimeter) )).

%   border_length(D, Length): of an edge of pattern D that borders one polygon.

border_length(D, Length) :-
    e(D, E, A, B, _),
    once(edge_polygon(D, E, _)),
    \+ ( e(D, F, B, A, _), edge_polygon(D, F, _) ),
    corner(D, A, P),
    corner(D, B, Q),
    distance(P, Q, Length).

%   smooth_volume(S, Volume): of primitives whose surfaces are known.

smooth_volume(S, Volume) :-
    placed_term(S, Term),
    primitive_name(Term, Name),
    findall(Part, surface_volume(S, Part), Parts),
    smooth_sum(Name, Parts, Volume).

smooth_sum(cylinder,        [Volume], Volume).
smooth_sum(cone,            [Volume], Volume).
smooth_sum(sphere,          [Volume], Volume).
smooth_sum(torus,           [Volume], Volume).
smooth_sum(hemisphere,      [Whole], Volume) :-
    Volume is Whole/2.
smooth_sum(hollow_cylinder, [A,B], Volume) :-
    Volume is abs(A-B).

surface_volume(S, Volume) :-
    placed_surface(S, _, Surface),
    surface_volume_(Surface, Volume).

surface_volume_(cylinder(_, U, V, W), Volume) :-
    determinant(U, V, W, D),
    Volume is pi*D.
surface_volume_(cone(_, U, V, W, K), Volume) :-
    determinant(U, V, W, D),
    Volume is pi*D*(1 + K + K*K)/3.
surface_volume_(sphere(_, U, V, W), Volume) :-
    determinant(U, V, W, D),
    Volume is 4*pi*D/3.
surface_volume_(torus(_, U, V, W, K), Volume) :-
    determinant(U, V, W, D),
    Volume is 2*pi*pi*K*K*D.

determinant(U0, V0, W0, D) :-
    as_vector(U0, U),
    as_vector(V0, V),
    as_vector(W0, W),
    cross_product(U, V, UV),
    dot_product(UV, W, D0),
    D is abs(D0).

as_vector(vector(X,Y,Z), p(X,Y,Z)).

lengths([], []).
lengths([U|Us], [Length|Lengths]) :-
    dot_product(U, U, Square),
    Length is sqrt(Square),
    lengths(Us, Lengths).

right_angles(Pairs) :-
    forall(member(U-V, Pairs),
           ( dot_product(U, V, Dot),
             dot_product(U, U, UU),
             dot_product(V, V, VV),
             is_rounding(Dot, sqrt(UU*VV)) )).


                /*******************************
                *         ON THE SHEET         *
                *******************************/

%!  measure_marks(+Measure, +N, +Points, +Names, -Marks) is det.
%
%   Marks are the points that Measure speaks of, each place(P, Views): P is to
%   be marked with a letter in Views. Of a point that is to be found the
%   question shows one view only, of those that have Names: where it is seen
%   along what is asked.

measure_marks(edge(S, V, W), _, _, Names, Marks) :-
    !,
    corner_marks(S, [V,W], Names, Marks).
measure_marks(angle(S, U, V, W), _, _, Names, Marks) :-
    !,
    corner_marks(S, [U,V,W], Names, Marks).
measure_marks(generator(S, I), N, _, Names, [place(P,Names)]) :-
    free_end(S, I, N, P),
    !.
measure_marks(coordinate(I, Axis), _, Points, Names, [place(P,[Name])]) :-
    memberchk(point(I, _, _, P), Points),
    along_views(Axis, Along),
    member(Name, Along),
    memberchk(Name, Names),
    !.
measure_marks(_, _, _, _, []).

corner_marks(S, Vs, Names, Marks) :-
    findall(place(P,Names), ( member(V, Vs), corner(S, V, P) ), Marks).

%!  measure_rank(+Measure, +Points, -Rank, -Count) is semidet.
%
%   In the view that measure_marks/5 marks it in, the point of Measure is one of
%   Count, more than one, of Points that are seen in one place: number Rank from
%   the left, from the front or from below.

measure_rank(coordinate(I, Axis), Points, Rank, Count) :-
    memberchk(point(I, _, _, P), Points),
    findall(At,
            ( member(point(_, _, _, Q), Points),
              \+ apart(Axis, P, Q),
              axis_coordinate(Axis, Q, At) ),
            Ats0),
    sort(Ats0, Ats),
    length(Ats, Count),
    Count > 1,
    axis_coordinate(Axis, P, Own),
    nth1(Rank, Ats, Own),
    !.

apart(Axis, P, Q) :-
    axis_coordinate(Other, P, A),
    Other \== Axis,
    axis_coordinate(Other, Q, B),
    \+ is_on_surface(A-B, 1.0+abs(A)).

%!  measure_shown(+Value, +Unit, +Tolerance, -Text) is det.
%
%   Text, a string, is Value, of the model, in Unit, as exactly as Tolerance
%   asks for.

measure_shown(Value, Unit, Tolerance, Text) :-
    measure_unit(Unit, _, Size, Word),
    tolerance(rounding, Near),
    Decimals is max(0, ceiling(-log10(Tolerance) - Near)),
    In is Value/Size,
    (   Unit == deg
    ->  format(string(Text), '~*f~s', [Decimals,In,Word])
    ;   format(string(Text), '~*f ~s', [Decimals,In,Word])
    ).
