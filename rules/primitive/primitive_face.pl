:- module(sg_primitive_face,
          [ face_of/3,                  % ?S, ?P, ?What
            smooth_surface/3,           % ?S, ?Part, ?Surface
            surface_point/4             % +Surface, +T, +H, -Point
          ]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module(parallel_surface, [parallel_point/5]).
:- use_module(primitive, [is_primitive/1, primitive/1, primitive_faces/3]).
:- use_module('../store', [p/3, segment/3]).
:- use_module(library(lists), [member/2, nth1/3]).
/** <module> What the polygons of a primitive are.

A segment that was made by a primitive has the term as its name, and a polygon
keeps its number when it is cut; so what a polygon is, and the smooth surface
it stands for, follow from the name. Nothing is stored.

What of face_of/3 is

    base   top   front   side(I)   cap(I)   ring(I)   face(I)    flat
    curved(Part, [T1-T2])               a facet between two generators
    curved(Part, [T1-T2, S1-S2])        a facet of what is curved both ways

T and S are parameters of smooth_surface(S, Part, Surface), in degrees (of a
patch: u and v, 0 to 1). Surface is, in coordinates of the model, with C =
point(X, Y, Z), and U, V, W = vector(X, Y, Z):

    cylinder(C, U, V, W)      C + cos(t)*U + sin(t)*V + h*W
    cone(C, U, V, W, K)       C + (1-h+h*K)*(cos(t)*U + sin(t)*V) + h*W
    ruled(C, U, V, W, U2, V2) C + (1-h)*(cos(t)*U + sin(t)*V)
                                + h*(W + cos(t)*U2 + sin(t)*V2)
    sphere(C, U, V, W)        C + cos(s)*(cos(t)*U + sin(t)*V) + sin(s)*W
    torus(C, U, V, W, K)      C + (1+K*cos(s))*(cos(t)*U + sin(t)*V)
                                + K*sin(s)*W
    bezier(Points)            the 16 control points
    fan(C, U, V, K)           C + (1-h+h*K)*t*U + h*V, t in radians: flat, what
                                lies between two edges of a transition
    transition(pieces(Pieces))    primitive_transition.pl

with h from 0 (base) to 1 (top). So the axis goes from C along W; a cone with K
= 0 has its apex at C + W; U and V are radii of the base (conjugate ones, if a
placing is no similarity). Of what is turned (`turning`), h = 0 is the larger
circle.

    ?- face_of(1, P, curved(Part, [T, _])).
*/

:- thread_local
    last_term/2,                        % N, Term
    last_surface/3,                     % N, Part, Surface
    last_face/3.                        % N, P, What

%!  face_of(?S, ?P, ?What) is nondet.
%
%   True when polygon P of segment S is What of the primitive that made S. In
%   the order of the polygons.

face_of(S, P, What) :-
    segment(S, _, Term),
    names_primitive(Term),
    remembered(Term, N),
    last_face(N, P, What),
    once(p(S, P, _)).

%!  smooth_surface(?S, ?Part, ?Surface) is nondet.
%
%   True when the curved faces Part of segment S stand for Surface.

smooth_surface(S, Part, Surface) :-
    segment(S, _, Term),
    names_primitive(Term),
    remembered(Term, N),
    last_surface(N, Part, Surface).

%   names_primitive(Term): and no node of a CSG tree, however it is placed.

names_primitive(Term) :-
    is_primitive(Term),
    innermost(Term, Inner),
    callable(Inner),
    functor(Inner, Name, _),
    once(primitive(Name)).

innermost(Term, Inner) :-
    (   ( Term = at(_, Term1) ; Term = named(_, Term1) )
    ->  innermost(Term1, Inner)
    ;   Inner = Term
    ).

%   remembered(Term, N): the faces and surfaces of the last terms are
%   remembered under their numbers, each by itself: a list of them all would be
%   copied whenever one is asked for. A verb asks by turns of several segments.

remembered(Term, N) :-
    last_term(N, Last),
    Last == Term,
    !.
remembered(Term, N) :-
    primitive_faces(Term, Whats, Surfaces),
    forgotten_oldest,
    flag(sg_last_term, N, N+1),
    forall(nth1(P, Whats, What), assertz(last_face(N, P, What))),
    forall(member(Part-Surface, Surfaces),
           assertz(last_surface(N, Part, Surface))),
    assertz(last_term(N, Term)).

most_remembered(8).

forgotten_oldest :-
    most_remembered(Most),
    predicate_property(last_term(_, _), number_of_clauses(Count)),
    Count >= Most,
    once(last_term(N, _)),
    !,
    retractall(last_term(N, _)),
    retractall(last_surface(N, _, _)),
    retractall(last_face(N, _, _)).
forgotten_oldest.

%!  surface_point(+Surface, +T, +H, -Point) is det.
%
%   Point is the point of Surface with the parameters T and H (of sphere and
%   torus T and S; of bezier U and V). Rounded.

surface_point(cylinder(C, U, V, W), T, H, Point) :-
    exact_sin_cos(T, Sin, Cos),
    combined(C, [Cos-U, Sin-V, H-W], Point).
surface_point(cone(C, U, V, W, K), T, H, Point) :-
    exact_sin_cos(T, Sin, Cos),
    F is 1.0 - H + H*K,
    A is F*Cos,
    B is F*Sin,
    combined(C, [A-U, B-V, H-W], Point).
surface_point(ruled(C, U, V, W, U2, V2), T, H, Point) :-
    exact_sin_cos(T, Sin, Cos),
    A is (1.0-H)*Cos,
    B is (1.0-H)*Sin,
    A2 is H*Cos,
    B2 is H*Sin,
    combined(C, [A-U, B-V, H-W, A2-U2, B2-V2], Point).
surface_point(sphere(C, U, V, W), T, S, Point) :-
    exact_sin_cos(T, SinT, CosT),
    exact_sin_cos(S, SinS, CosS),
    A is CosS*CosT,
    B is CosS*SinT,
    combined(C, [A-U, B-V, SinS-W], Point).
surface_point(torus(C, U, V, W, K), T, S, Point) :-
    exact_sin_cos(T, SinT, CosT),
    exact_sin_cos(S, SinS, CosS),
    A is (1.0 + K*CosS)*CosT,
    B is (1.0 + K*CosS)*SinT,
    D is K*SinS,
    combined(C, [A-U, B-V, D-W], Point).
surface_point(parallel(Surface, Distance), T, H, Point) :-
    parallel_point(Surface, Distance, T, H, Point).
surface_point(fan(C, U, V, K), T, H, Point) :-
    A is (1.0-H+H*K)*T*pi/180.0,
    combined(C, [A-U, H-V], Point).
surface_point(bezier(Points), U, V, Point) :-
    bernstein(U, Us),
    bernstein(V, Vs),
    findall(W-P,
            ( nth1(I, Vs, F), nth1(J, Us, G),
              W is F*G,
              K is 4*(I-1) + J,
              nth1(K, Points, point(X, Y, Z)),
              P = vector(X, Y, Z) ),
            Terms),
    combined(point(0.0, 0.0, 0.0), Terms, Point).

bernstein(U, [A, B, C, D]) :-
    M is 1.0 - U,
    A is M*M*M,
    B is 3.0*M*M*U,
    C is 3.0*M*U*U,
    D is U*U*U.

combined(point(X0, Y0, Z0), Terms, point(X, Y, Z)) :-
    added(Terms, X0, Y0, Z0, X, Y, Z).

added([], X, Y, Z, X, Y, Z).
added([F-vector(A, B, C)|Terms], X0, Y0, Z0, X, Y, Z) :-
    X1 is X0 + F*A,
    Y1 is Y0 + F*B,
    Z1 is Z0 + F*C,
    added(Terms, X1, Y1, Z1, X, Y, Z).
