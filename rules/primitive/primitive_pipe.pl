:- module(sg_primitive_pipe,
          [ elbow_shape/2,              % +Given, -Shape
            mitred_pipe_shape/2,        % +Given, -Shape
            wye_shape/2,                % +Given, -Shape
            is_mitred/1                 % +Term
          ]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module('../near', [longer/2]).
:- use_module(primitive_argument,
              [given/3, given_facets/4, primitive_error/2, vertices_within/2]).
:- use_module(shape, [round_angle/4]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, scaled/3, unit/2,
                vector_sum/3
              ]).
:- use_module(library(apply), [foldl/5, maplist/3]).
:- use_module(library(lists),
              [ append/2, append/3, max_list/2, member/2, nth1/3, numlist/3,
                reverse/2
              ]).
/** <module> Pipes of several pieces that meet in mitres: elbows, offsets, wyes.

Each piece is a part of one cylinder, curved(piece(I), [T1-T2]), and has its own
pattern (rules/unrolling/); the ends are `base` and `top`, of a wye `base` and
cap(1), cap(2). The diameter is that of what is drawn, as of other primitives.

The axis of a mitred pipe goes through points; where it turns, both pieces are
cut by the plane that halves the angle. An elbow stands on z = 0, rises along +z
and bends to +x: its axis goes through its first joint at half a gore from the
start, R/cos(half a gore) from the centre of the bend, and so on. A wye has its
stem below the origin, where the axes of its legs meet; each of the three keeps
what is nearer to its own direction than to the others.

Generators go on from piece to piece, as mirrored in the mitre. On the first, 0
degrees is the side to +x (to +z, if the axis goes along x): where an elbow is
shortest. On the pieces of a wye it is the side to +y, on its second leg that to
-y: so 90 degrees is where the two legs meet.

The plane of a mitre is not written down: true_mitre.pl has it.
*/

%!  is_mitred(+Term) is semidet.
%
%   Term is one of these primitives, perhaps placed.

is_mitred(at(_, Term)) :-
    !,
    is_mitred(Term).
is_mitred(named(_, Term)) :-
    !,
    is_mitred(Term).
is_mitred(Term) :-
    compound(Term),
    functor(Term, Name, _),
    memberchk(Name, [elbow,mitred_pipe,wye]).

%!  elbow_shape(+Given, -Shape) is det.
%
%   @error few(pieces, N, 2), sharp_turn(I), short_piece(I, Length, Least)

elbow_shape(Given, Shape) :-
    elbow_points(Given, Points),
    mitred_shape(Points, Given, Shape).

elbow_points(Given, [p(0.0,0.0,0.0)|Points]) :-
    given(Given, radius, [R]),
    given(Given, pieces, [N]),
    given(Given, angle, [A]),
    given(Given, ends, [L]),
    Given = given(Term, _, _),
    (   N >= 2
    ->  true
    ;   primitive_error(few(pieces, N, 2), Term)
    ),
    Half is A/(2.0*(N-1)),
    (   Half < 85.0
    ->  true
    ;   primitive_error(sharp_turn(2), Term)
    ),
    exact_sin_cos(Half, _, Cos),
    Far is R/Cos,
    Joints is N-2,
    findall(Point,
            ( between(0, Joints, I),
              At is Half*(2*I + 1),
              bend_point(R, Far, L, At, Point) ),
            Points0),
    exact_sin_cos(A, SinA, CosA),
    X is R - R*CosA + L*SinA,
    Z is L + R*SinA + L*CosA,
    append(Points0, [p(X,0.0,Z)], Points).

bend_point(R, Far, L, Degrees, p(X,0.0,Z)) :-
    exact_sin_cos(Degrees, Sin, Cos),
    X is R - Far*Cos,
    Z is L + Far*Sin.

%!  mitred_pipe_shape(+Given, -Shape) is det.
%
%   @error few(through, N, 2), same_point(I), sharp_turn(I), short_piece(I,
%          Length, Least)

mitred_pipe_shape(Given, Shape) :-
    given(Given, through, [Points0]),
    findall(p(X,Y,Z), member(point(X,Y,Z), Points0), Points),
    (   Points = [_,_|_]
    ->  true
    ;   Given = given(Term, _, _),
        length(Points, N),
        primitive_error(few(through, N, 2), Term)
    ),
    mitred_shape(Points, Given, Shape).


                /*******************************
                *         MITRED PIPES         *
                *******************************/

%   mitred_shape(Points, Given, Shape): a piece between each point and the next.

mitred_shape(Points, Given, shape(Vertices, Faces, Surfaces)) :-
    given(Given, diameter, [D]),
    R is D/2.0,
    given_facets(Given, R, 360, N),
    length(Points, Rings),
    Count is Rings*N,
    vertices_within(Count, Given),
    Given = given(Term, _, _),
    spans(Points, 1, Term, Spans),
    turns(Spans, 2, Term, Turns),
    first_frame(Spans, Frame),
    Begin = joint(p(0.0,0.0,0.0), none),
    pieces(Spans, Turns, Begin, Frame, 1, R-Term, Pieces),
    Pieces = [piece(_, First, _, _, _)|_],
    base_ring(First, R, N, Base),
    foldl(next_ring(R, N), Pieces, Others, Base, _),
    append([Base|Others], Vertices0),
    maplist(as_point, Vertices0, Vertices),
    pieces_faces(Pieces, N, Faces0),
    pipe_ends(N, Rings, Ends),
    append(Ends, Faces0, Faces),
    findall(piece(I)-Surface, member(piece(I, _, _, Surface, _), Pieces),
            Surfaces).

as_point(p(X,Y,Z), point(X,Y,Z)).

%   spans(Points, I, Term, Spans): span(Point, Way, Length), Way a unit vector.

spans([_], _, _, []) :-
    !.
spans([P,Q|Points], I, Term, [span(P, Way, Length)|Spans]) :-
    difference(Q, P, PQ),
    vector_length(PQ, Length),
    (   Length > 0.0
    ->  true
    ;   primitive_error(same_point(I), Term)
    ),
    unit(PQ, Way),
    I1 is I+1,
    spans([Q|Points], I1, Term, Spans).

%   turns(Spans, I, Term, Turns): turn(Point, Normal, Before, After) where two
%   spans meet: the plane of the mitre, and to which side and by how much the
%   piece before it, and the one after it, is shorter than its axis, for a
%   radius of 1.

turns([_], _, _, []) :-
    !.
turns([span(_, Way1, _)|Spans], I, Term,
      [turn(Point, Normal, Before, After)|Turns]) :-
    Spans = [span(Point, Way2, _)|_],
    vector_sum(Way1, Way2, Normal),
    dot_product(Way1, Way2, Cos),
    (   Cos > -0.98                     % 168 degrees
    ->  true
    ;   primitive_error(sharp_turn(I), Term)
    ),
    F is 1.0/(1.0+Cos),
    G is Cos/(1.0+Cos),
    combined(F, Way2, -G, Way1, Before),
    combined(G, Way2, -F, Way1, After),
    I1 is I+1,
    turns(Spans, I1, Term, Turns).

combined(F0, U, G0, V, W) :-
    F is F0,
    G is G0,
    scaled(F, U, U1),
    scaled(G, V, V1),
    vector_sum(U1, V1, W).

%   first_frame(Spans, Frame): its first generator is the one to +x, or to +z if
%   the axis goes along x.

first_frame([span(_, Way, _)|_], Frame) :-
    Way = p(X, _, _),
    (   abs(X) < 0.9
    ->  Towards = p(1.0,0.0,0.0)
    ;   Towards = p(0.0,0.0,1.0)
    ),
    pipe_frame(Way, Towards, Frame).

%   pipe_frame(Way, Towards, Frame): frame(U, V, Way), unit vectors at right
%   angles, U to the side of Towards.

pipe_frame(Way, Towards, frame(U, V, Way)) :-
    cross_product(Way, Towards, V0),
    unit(V0, V),
    cross_product(V, Way, U).

%   pieces(Spans, Turns, Begin, Frame, I, R-Term, Pieces): piece(I, P-Frame,
%   End, Surface, Length); End is end(Point, Normal), where its generators end.

pieces([span(P, Way, Length)], [], Begin, Frame, I, R-Term, [Piece]) :-
    !,
    End = joint(p(0.0,0.0,0.0), none),
    combined(1.0, P, Length, Way, Last),
    piece(P, Length, Begin, End, Frame, I, R-Term, end(Last, Way), Piece).
pieces([span(P, _, Length)|Spans], [Turn|Turns], Begin, Frame, I, R-Term,
       [Piece|Pieces]) :-
    Turn = turn(Point, Normal, Before, After),
    piece(P, Length, Begin, joint(Before, mitre), Frame, I, R-Term,
          end(Point, Normal), Piece),
    Spans = [span(_, Way, _)|_],
    mirrored_frame(Normal, Frame, Way, Frame1),
    I1 is I+1,
    pieces(Spans, Turns, joint(After, mitre), Frame1, I1, R-Term, Pieces).

%   mirrored_frame(Normal, Frame0, Way, Frame): along Way, as the mirror with
%   that Normal has Frame0.

mirrored_frame(Normal, frame(U0, _, _), Way, Frame) :-
    dot_product(Normal, Normal, Square),
    dot_product(U0, Normal, Along),
    combined(1.0, U0, -2.0*Along/Square, Normal, U),
    pipe_frame(Way, U, Frame).

%   piece(P, Length, Begin, End, Frame, I, R-Term, Ends, Piece): P is where its
%   axis begins. Its mitres may not meet in the pipe. The cylinder that it is a
%   part of is longer, so that no part of a mitre lies at one of its ends.

piece(P, Length, joint(Short1, Kind1), joint(Short2, Kind2), Frame, I, R-Term,
      Ends, piece(I, P-Frame, Ends, Surface, Length)) :-
    vector_sum(Short1, Short2, Short),
    vector_length(Short, Most),
    Least is R*Most,
    (   longer(Length, Least)
    ->  true
    ;   primitive_error(short_piece(I, Length, Least), Term)
    ),
    longer_by(Kind1, Short1, R, Back),
    longer_by(Kind2, Short2, R, On),
    Frame = frame(_, _, Way),
    combined(1.0, P, -Back, Way, Foot),
    Whole is Length+Back+On,
    cylinder_surface(Foot, R, Frame, Whole, Surface).

longer_by(none, _, _, 0.0) :-
    !.
longer_by(mitre, Short, R, By) :-
    vector_length(Short, Most),
    By is R*(1.25*Most + 0.05).

vector_length(Vector, Length) :-
    dot_product(Vector, Vector, Square),
    Length is sqrt(Square).

cylinder_surface(Foot, R, frame(U0,V0,Way), Length, cylinder(C, U, V, W)) :-
    as_point(Foot, C),
    as_vector(R, U0, U),
    as_vector(R, V0, V),
    as_vector(Length, Way, W).

as_vector(F, U, vector(X,Y,Z)) :-
    scaled(F, U, p(X,Y,Z)).


                /*******************************
                *       RINGS AND FACES        *
                *******************************/

base_ring(P-frame(U,V,_), R, N, Ring) :-
    numlist(1, N, Is),
    maplist(round_point(P, U, V, R, N), Is, Ring).

round_point(P, U, V, R, N, I, Point) :-
    round_angle(N, 360, I, Angle),
    exact_sin_cos(Angle, Sin, Cos),
    combined(R*Cos, U, R*Sin, V, Off),
    vector_sum(P, Off, Point).

%   next_ring(R, N, Piece, Ring, Ring0, Ring): where the generators of Piece
%   end.

next_ring(R, N, piece(_, First, end(Point, Normal), _, _), Ring, _, Ring) :-
    First = _-frame(_, _, Way),
    base_ring(First, R, N, Starts),
    maplist(ends_at(Way, Point, Normal), Starts, Ring).

ends_at(Way, Point, Normal, Start, End) :-
    difference(Point, Start, To),
    dot_product(To, Normal, Far),
    dot_product(Way, Normal, Slant),
    combined(1.0, Start, Far/Slant, Way, End).

pieces_faces(Pieces, N, Faces) :-
    findall(face(curved(piece(I), [T1-T2]), [[A,B,C,D]]),
            ( member(piece(I, _, _, _, _), Pieces),
              between(1, N, J),
              J1 is J mod N + 1,
              A is (I-1)*N + J,
              B is (I-1)*N + J1,
              C is B+N,
              D is A+N,
              facet_angles(N, J, T1, T2) ),
            Faces).

facet_angles(N, J, T1, T2) :-
    J1 is J+1,
    round_angle(N, 360, J, Angle1),
    round_angle(N, 360, J1, Angle2),
    T1 is float(Angle1),
    T2 is float(Angle2).

pipe_ends(N, Rings, [face(base, [Base]), face(top, [Top])]) :-
    numlist(1, N, Ring),
    reverse(Ring, Base),
    First is (Rings-1)*N + 1,
    Last is Rings*N,
    numlist(First, Last, Top).


                /*******************************
                *             WYE              *
                *******************************/

%!  wye_shape(+Given, -Shape) is det.
%
%   Piece 1 is the stem, 2 the leg to +x, 3 the other. Vertices 1 and 2 are
%   where the three meet; then come the mitres of the stem and leg 2, of the
%   stem and leg 3, of the two legs, each from +y to -y; then the ends.
%
%   @error odd_facets(N), sharp_turn(1), short_piece(I, Length, Least)

wye_shape(Given, shape(Points, Faces, Surfaces)) :-
    wye_pieces(Given, R, N, Pieces),
    Half is N//2,
    Pieces = [Stem,Leg2,Leg3],
    mitre_points(Stem, Leg2, R, N, Arc1),
    maplist(other_side, Arc1, Arc2),
    mitre_points(Leg2, Leg3, R, N, Arc3),
    Back is -R,
    findall(Ring, ( member(Piece, Pieces), end_ring(Piece, R, N, Ring) ),
            Rings),
    append([[p(0.0,R,0.0),p(0.0,Back,0.0)],Arc1,Arc2,Arc3|Rings], Points0),
    maplist(as_point, Points0, Points),
    findall(Face, wye_facet(N, Half, Face), Facets),
    findall(face(What, [Loop]), wye_end(N, Half, What, Loop), Ends),
    append(Ends, Facets, Faces),
    findall(piece(I)-Surface,
            ( member(Piece, Pieces), leg_surface(Piece, R, I, Surface) ),
            Surfaces).

other_side(p(X0,Y,Z), p(X,Y,Z)) :-
    X is -X0.

%   wye_pieces(Given, R, N, Pieces): leg(I, Frame, Length, Deep), Deep how far
%   its mitres go along it.

wye_pieces(Given, R, N, Pieces) :-
    Given = given(Term, _, _),
    given(Given, diameter, [D]),
    given(Given, angle, [A]),
    given(Given, stem, [StemLength]),
    given(Given, legs, [LegLength]),
    R is D/2.0,
    even_facets(Given, R, N),
    Count is 5*N,
    vertices_within(Count, Given),
    (   A < 170.0
    ->  true
    ;   primitive_error(sharp_turn(1), Term)
    ),
    Half is A/2.0,
    exact_sin_cos(Half, X, Z),
    X2 is -X,
    Legs = [1-p(0.0,0.0,-1.0)-StemLength-1.0, 2-p(X,0.0,Z)-LegLength-1.0,
            3-p(X2,0.0,Z)-LegLength-(-1.0)],
    findall(leg(I, Frame, Length, Deep),
            ( member(I-Way-Length-Y, Legs),
              pipe_frame(Way, p(0.0,Y,0.0), Frame),
              findall(Deep0,
                      ( member(J-Other-_-_, Legs),
                        J =\= I,
                        mitre_depth(Way, Other, R, Deep0) ),
                      Deeps),
              max_list(Deeps, Deep) ),
            Pieces),
    forall(member(leg(I, _, Length, Deep), Pieces),
           (   longer(Length, Deep)
           ->  true
           ;   primitive_error(short_piece(I, Length, Deep), Term)
           )).

%   even_facets(Given, R, N): two generators of a piece go to where all meet.

even_facets(Given, R, N) :-
    given_facets(Given, R, 360, N0),
    Given = given(Term, _, _),
    (   N0 mod 2 =:= 0
    ->  N = N0
    ;   given(Given, facets, none)
    ->  N is N0+1
    ;   primitive_error(odd_facets(N0), Term)
    ).

%   mitre_depth(Way, Other, R, Deep): R times the cotangent of half the angle.

mitre_depth(Way, Other, R, Deep) :-
    dot_product(Way, Other, Cos),
    cross_product(Way, Other, Across),
    vector_length(Across, Sin),
    Deep is R*Sin/(1.0-Cos).

%   mitre_points(Leg, Other, R, N, Points): where the generators of Leg between
%   0 and 180 degrees begin, in the plane between it and Other.

mitre_points(leg(_, Frame, _, _), leg(_, frame(_,_,Other), _, _), R, N,
             Points) :-
    Frame = frame(U, V, Way),
    Last is N//2,
    numlist(2, Last, Is),
    maplist(round_point(p(0.0,0.0,0.0), U, V, R, N), Is, Ring),
    difference(Way, Other, Normal),
    maplist(ends_at(Way, p(0.0,0.0,0.0), Normal), Ring, Points).

end_ring(leg(_, frame(U,V,Way), Length, _), R, N, Ring) :-
    scaled(Length, Way, End),
    base_ring(End-frame(U,V,Way), R, N, Ring).

leg_surface(leg(I, Frame, Length, Deep), R, I, Surface) :-
    By is 1.25*Deep + 0.05*R,
    Frame = frame(_, _, Way),
    combined(-By, Way, 0.0, Way, Foot),
    Whole is Length+By,
    cylinder_surface(Foot, R, Frame, Whole, Surface).

%   wye_vertex(I, J, N, Half, V): where generator J of piece I, from 0, begins.

wye_vertex(I, J, N, Half, V) :-
    wye_mitre(I, J, N, Half, Arc, K),
    (   K =:= 0
    ->  V = 1
    ;   K =:= Half
    ->  V = 2
    ;   V is 2 + (Arc-1)*(Half-1) + K
    ).

%   wye_mitre(I, J, N, Half, Arc, K): the K-th point of a mitre, from +y.

wye_mitre(1, J, N, Half, Arc, K) :-
    (   J =< Half
    ->  Arc = 1,
        K = J
    ;   Arc = 2,
        K is N-J
    ).
wye_mitre(2, J, N, Half, Arc, K) :-
    (   J =< Half
    ->  Arc = 3,
        K = J
    ;   Arc = 1,
        K is N-J
    ).
wye_mitre(3, J, _, Half, Arc, K) :-
    (   J =< Half
    ->  Arc = 3,
        K is Half-J
    ;   Arc = 2,
        K is J-Half
    ).

wye_end_vertex(I, J, N, Half, V) :-
    V is 2 + 3*(Half-1) + (I-1)*N + J + 1.

wye_facet(N, Half, face(curved(piece(I), [T1-T2]), [[A,B,C,D]])) :-
    between(1, 3, I),
    between(1, N, K),
    J is K-1,
    J1 is K mod N,
    wye_vertex(I, J, N, Half, A),
    wye_vertex(I, J1, N, Half, B),
    wye_end_vertex(I, J1, N, Half, C),
    wye_end_vertex(I, J, N, Half, D),
    facet_angles(N, K, T1, T2).

wye_end(N, Half, What, Loop) :-
    nth1(I, [base,cap(1),cap(2)], What),
    Last is N-1,
    findall(V, ( between(0, Last, J), wye_end_vertex(I, J, N, Half, V) ),
            Loop).
