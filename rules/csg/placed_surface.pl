:- module(sg_placed_surface,
          [ placed_face/3,              % ?S, ?P, ?What
            placed_surface/3,           % ?S, ?Part, ?Surface
            placed_term/2,              % +S, -Term
            placed_polygon/4,           % +S, ?P, ?Leaf, ?P0
            drawn_polygon/4,            % +S1, ?P1, -S, ?P
            placed_feature/4,           % ?S, ?V, ?Leaf, ?Feature
            facet_surface/3,            % +S, +P, -Surface
            kept_answer/4,              % :Find, +S, ?Key, -Answer
            asked_once/1                % :Goal
          ]).
:- use_module(csg, [is_helper/1, is_node/1]).
:- use_module(csg_record, [recorded/2]).
:- use_module('../primitive/primitive', [is_primitive/1]).
:- use_module('../primitive/primitive_face', [face_of/3, smooth_surface/3]).
:- use_module(provenance, [origin_feature/3]).
:- use_module('../store',
              [p/3, segment/3, origin/3, from_p/5, segment_stamp/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> Primitives and copies of them, where they stand.

A node of a CSG tree that places a leaf once more, and a helper that does, have
the polygons of the leaf, in another place: csg_record.pl knows by which matrix.
Here these count as primitives too, with the surfaces of the leaf moved; what is
made of them is followed back to them, and no farther. So do segments that lie
parallel to a primitive: they say themselves what they are.

Unrolling asks of each facet what it is of, often. Under asked_once/1 it is
found for a whole segment at the first question, and kept as relations.
*/

:- meta_predicate
    asked_once(0),
    kept_answer(3, +, ?, -).

:- thread_local
    keeping/0,
    filled/3,                           % Relation, S, Stamp
    face_/3,                            % as placed_face/3
    surface_/3,                         % as placed_surface/3
    polygon_/4,                         % as placed_polygon/4
    facet_/3,                           % as facet_surface/3
    drawn_/4,                           % as drawn_polygon/4
    from_/2,                            % as goes_on/1: S, true or false
    answer_/5.                          % S, Find, Hash, Key, Answer

%!  asked_once(:Goal) is semidet.
%
%   Call Goal once. Meanwhile each of the relations here is found once for a
%   segment and kept. Goal may make segments; of those that are there it changes
%   no name and no origin.

asked_once(Goal) :-
    (   keeping
    ->  once(Goal)
    ;   setup_call_cleanup(asserta(keeping), once(Goal), forgotten)
    ).

forgotten :-
    retractall(keeping),
    retractall(filled(_, _, _)),
    retractall(face_(_, _, _)),
    retractall(surface_(_, _, _)),
    retractall(polygon_(_, _, _, _)),
    retractall(facet_(_, _, _)),
    retractall(drawn_(_, _, _, _)),
    retractall(from_(_, _)),
    retractall(answer_(_, _, _, _, _)).

%   kept(Relation, S): Relation is filled for segment S. A segment that was
%   taken back has left its number to another one, with another stamp.

kept(Relation, S) :-
    integer(S),
    keeping,
    segment_stamp(S, Stamp),
    (   filled(Relation, S, Stamp)
    ->  true
    ;   retractall(filled(Relation, S, _)),
        fill(Relation, S),
        assertz(filled(Relation, S, Stamp))
    ).

fill(face, S) :-
    retractall(face_(S, _, _)),
    forall(found_face(S, P, What), assertz(face_(S, P, What))).
fill(surface, S) :-
    retractall(surface_(S, _, _)),
    forall(found_surface(S, Part, Surface),
           assertz(surface_(S, Part, Surface))).
fill(polygon, S) :-
    retractall(polygon_(S, _, _, _)),
    forall(found_polygon(S, P, Leaf, P0), assertz(polygon_(S, P, Leaf, P0))).
fill(facet, S) :-
    retractall(facet_(S, _, _)),
    forall(( p(S, P, _), once(found_facet(S, P, Surface)) ),
           assertz(facet_(S, P, Surface))).
fill(drawn, S) :-
    retractall(drawn_(S, _, _, _)),
    findall(drawn_(S, P, Drawn, P0), found_drawn(S, P, Drawn, P0), All0),
    sort(2, @=<, All0, All),
    forall(member(Fact, All), assertz(Fact)).
fill(from, S) :-
    retractall(from_(S, _)),
    (   found_goes_on(S)
    ->  assertz(from_(S, true))
    ;   assertz(from_(S, false))
    ).
fill(answer(Find), S) :-
    retractall(answer_(S, Find, _, _, _)),
    forall(call(Find, S, Key, Answer),
           ( term_hash(Key, Hash),
             assertz(answer_(S, Find, Hash, Key, Answer)) )).

%!  kept_answer(:Find, +S, ?Key, -Answer) is nondet.
%
%   As call(Find, S, Key, Answer), which yields ground terms. Under asked_once/1
%   it is called for all keys of segment S at the first question; then a key is
%   found at once, however many there are.

kept_answer(Find, S, Key, Answer) :-
    (   kept(answer(Find), S)
    ->  term_hash(Key, Hash),           % unbound if Key is not ground
        answer_(S, Find, Hash, Key, Answer)
    ;   call(Find, S, Key, Answer)
    ).

%!  placed_face(?S, ?P, ?What) is nondet.
%
%   As face_of/3, of copies too.

placed_face(S, P, What) :-
    (   kept(face, S)
    ->  face_(S, P, What)
    ;   found_face(S, P, What)
    ).

found_face(S, P, What) :-
    is_parallel(S),
    origin(S, face(P), What).
found_face(S, P, What) :-
    stands(S, Leaf, _),
    face_of(Leaf, P, What).

%!  placed_surface(?S, ?Part, ?Surface) is nondet.
%
%   As smooth_surface/3, of copies too.

placed_surface(S, Part, Surface) :-
    (   kept(surface, S)
    ->  surface_(S, Part, Surface)
    ;   found_surface(S, Part, Surface)
    ).

found_surface(S, Part, Surface) :-
    is_parallel(S),
    origin(S, part(Part), Surface).
found_surface(S, Part, Surface) :-
    stands(S, Leaf, Matrix),
    smooth_surface(Leaf, Part, Surface0),
    surface_placed(Matrix, Surface0, Surface).

%!  placed_term(+S, -Term) is semidet.
%
%   Term is the primitive that segment S is, or is a copy of, where S stands.

placed_term(S, Term) :-
    stands(S, Leaf, Matrix),
    segment(Leaf, _, Term0),
    is_primitive(Term0),
    (   Matrix == none
    ->  Term = Term0
    ;   Term = at([matrix(Matrix)], Term0)
    ).

%   is_parallel(S): S is the other side of a plate (true_parallel.pl).

is_parallel(S) :-
    segment(S, _, Term),
    nonvar(Term),
    Term = parallel(_, _).

%   stands(S, Leaf, Matrix): S is primitive Leaf (Matrix is `none`), or a copy
%   of it that Matrix placed.

stands(S, Leaf, Matrix) :-
    segment(S, _, _),
    (   copy(S, Leaf0, Matrix0)
    ->  Leaf = Leaf0,
        Matrix = Matrix0
    ;   is_node(S)
    ->  fail
    ;   Leaf = S,
        Matrix = none
    ).

copy(S, Leaf, Matrix) :-
    recorded(S, What),
    arg(1, What, placed(Leaf-_, Matrix)).

%   surface_placed(Matrix, Term0, Term): with its points and vectors moved.

surface_placed(none, Term, Term) :-
    !.
surface_placed(Matrix, point(X0,Y0,Z0), point(X,Y,Z)) :-
    !,
    maplist(row_times([X0,Y0,Z0,1.0]), Matrix, [X,Y,Z]).
surface_placed(Matrix, vector(X0,Y0,Z0), vector(X,Y,Z)) :-
    !,
    maplist(row_times([X0,Y0,Z0,0.0]), Matrix, [X,Y,Z]).
surface_placed(Matrix, Term0, Term) :-
    (   compound(Term0)
    ->  compound_name_arguments(Term0, Name, Arguments0),
        maplist(surface_placed(Matrix), Arguments0, Arguments),
        compound_name_arguments(Term, Name, Arguments)
    ;   Term = Term0
    ).

row_times([X,Y,Z,One], [A,B,C,D], Number) :-
    Number is float(A*X + B*Y + C*Z + D*One) + 0.0.

%!  placed_polygon(+S, ?P, ?Leaf, ?P0) is nondet.
%
%   As polygon_from/5, but Leaf may be a copy; a copy is its own.

placed_polygon(S, P, Leaf, P0) :-
    (   kept(polygon, S)
    ->  polygon_(S, P, Leaf, P0)
    ;   found_polygon(S, P, Leaf, P0)
    ).

found_polygon(S, P, Leaf, P0) :-
    copy(S, _, _),
    !,
    p(S, P, _),
    Leaf = S,
    P0 = P.
found_polygon(S, P, Leaf, P0) :-
    from_p(S, P, S1, P1, _),
    (   goes_on(S1)
    ->  placed_polygon(S1, P1, Leaf, P0)
    ;   Leaf = S1,
        P0 = P1
    ).

%   goes_on(S): the polygons of S come from those of other segments that are to
%   be asked.

goes_on(S) :-
    (   kept(from, S)
    ->  from_(S, true)
    ;   found_goes_on(S)
    ).

found_goes_on(S) :-
    once(from_p(S, _, _, _, _)),        % first: most have none
    \+ copy(S, _, _),
    (   is_helper(S)
    ->  true
    ;   is_node(S)
    ).

%!  facet_surface(+S, +P, -Surface) is semidet.
%
%   True when polygon P of segment S is a facet of Surface, by placed_surface/3:
%   of S itself, or of what P was cut from.

facet_surface(S, P, Surface) :-
    (   kept(facet, S)
    ->  facet_(S, P, Surface)
    ;   found_facet(S, P, Surface)
    ),
    !.

found_facet(S, P, Surface) :-
    (   from_p(S, P, _, _, _)
    ->  once(placed_polygon(S, P, Leaf, P0))
    ;   Leaf = S,
        P0 = P
    ),
    placed_face(Leaf, P0, curved(Part, _)),
    placed_surface(Leaf, Part, Surface).

%!  placed_feature(?S, ?V, ?Leaf, ?Feature) is nondet.
%
%   As vertex_on/4, but Leaf may be a copy; of what was made again of other
%   segments the polygons alone.

placed_feature(S, V, Leaf, Feature) :-
    origin(S, v(V), Origin),
    origin_feature(Origin, S1, Feature1),
    (   goes_on(S1)
    ->  Feature1 = p(P1),
        placed_polygon(S1, P1, Leaf, P),
        Feature = p(P)
    ;   Leaf = S1,
        Feature = Feature1
    ).

%!  drawn_polygon(+S1, ?P1, -S, ?P) is nondet.
%
%   Polygon P1 of segment S1, a part that was made of what is drawn to be cut
%   for a true pattern (true_parts.pl), stands for polygon P of the segment S
%   that is drawn.

drawn_polygon(S1, P1, S, P) :-
    (   kept(drawn, S1)
    ->  drawn_(S1, P1, S, P)
    ;   found_drawn(S1, P1, S, P)
    ).

found_drawn(S1, P1, S, P) :-
    origin(S1, node(S1), plate(S)),
    (   origin(S1, p(_), p(_))
    ->  origin(S1, p(P1), p(P))
    ;   P = P1,
        p(S1, P1, _)
    ).
