:- module(sg_test_face_soup,
          [ made_soup/2,                % +Faces, +Wires
            faces_added/1,              % +Faces
            soup_counts/3,              % +Faces, +Wires, -Counts
            report_counts/2,            % +Report, -Counts
            cube_faces/2,               % +Low, -Faces
            box_faces/2,                % +Size-Low, -Faces
            cubes_faces/2,              % +Lows, -Faces
            tetrahedron_faces/2,        % +Points, -Faces
            once_each/2,                % +Faces0, -Faces
            vertex_at/2                 % +Point, -V
          ]).
/** <module> Soups of faces for tests: segment 1 of the current world.

A face is a list of loops, a loop a list of points [X,Y,Z]; a wire is a list of
points, of one point a lone vertex. Each face has edges of its own; every third
is turned round.
*/

:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%!  made_soup(+Faces, +Wires) is det.

made_soup(Faces, Wires) :-
    assert_fact(segment(1, surface, soup)),
    append(Faces, Loops),
    append([Wires|[Loops]], Chains),
    append(Chains, Points0),
    maplist(floats, Points0, Points1),
    sort(Points1, Points),
    numbered(Points, 1, Pairs),
    list_to_assoc(Pairs, Vs),
    forall(member([X,Y,Z]-V, Pairs), assert_fact(v(1, V, X, Y, Z))),
    foldl(face_made(Vs), Faces, 1-1, _-E),
    foldl(wire_made(Vs), Wires, E, _).

floats(Point0, Point) :-
    maplist([X0,X]>>(X is float(X0)+0.0), Point0, Point).

numbered([], _, []).
numbered([Point|Points], N, [Point-N|Pairs]) :-
    N1 is N+1,
    numbered(Points, N1, Pairs).

vertex_of(Vs, Point0, V) :-
    floats(Point0, Point),
    get_assoc(Point, Vs, V).

face_made(Vs, Loops0, P-E0, P1-E) :-
    (   P mod 3 =:= 0
    ->  maplist(reverse, Loops0, Loops)
    ;   Loops = Loops0
    ),
    foldl(loop_made(Vs), Loops, E0-[], E-Es),
    assert_fact(p(1, P, Es)),
    P1 is P+1.

loop_made(Vs, Loop, E0-Es0, E-Es) :-
    maplist(vertex_of(Vs), Loop, Path),
    Path = [First|Rest],
    append(Rest, [First], Ends),
    edges_made(Path, Ends, E0, E, New),
    append(Es0, New, Es).

edges_made([], [], E, E, []).
edges_made([A|As], [B|Bs], E0, E, [E0|Es]) :-
    assert_fact(e(1, E0, A, B, 1)),
    E1 is E0+1,
    edges_made(As, Bs, E1, E, Es).

wire_made(Vs, Wire, E0, E) :-
    maplist(vertex_of(Vs), Wire, Path),
    append(Starts, [_], Path),
    !,
    Path = [_|Ends],
    edges_made(Starts, Ends, E0, E, _).

%!  faces_added(+Faces) is det.
%
%   The soup has these too, with vertices of their own.

faces_added(Faces) :-
    findall(Point, ( member(Loops, Faces), member(Loop, Loops),
                     member(Point, Loop) ), Points0),
    sort(Points0, Points),
    findall(Point-V,
            ( member(Point, Points), fresh_id(v, 1, V),
              floats(Point, [X,Y,Z]),
              assert_fact(v(1, V, X, Y, Z)) ),
            Vs),
    forall(member(Loops, Faces),
           ( maplist(loop_added(Vs), Loops, Lists),
             append(Lists, Es),
             fresh_id(p, 1, P),
             assert_fact(p(1, P, Es)) )).

loop_added(Vs, Loop, Es) :-
    Loop = [First|_],
    append(Loop, [First], Path),
    findall(E,
            ( append(_, [A,B|_], Path), memberchk(A-V, Vs), memberchk(B-W, Vs),
              fresh_id(e, 1, E), assert_fact(e(1, E, V, W, 1)) ),
            Es).

%!  soup_counts(+Faces, +Wires, -Counts) is det.
%
%   Counts is [V,E,F,L,C,R,S,G] of a world of its own with them, in which both
%   laws hold and nothing is doubtful.

soup_counts(Faces, Wires, Counts) :-
    in_new_world(( made_soup(Faces, Wires),
                   regions_made(1, Report) )),
    \+ law_fault(Report, _, _),
    report_counts(Report, Counts).

%!  report_counts(+Report, -Counts) is det.

report_counts(Report, [V,E,F,L,C,R,S,G]) :-
    _{ vertices:V, edges:E, faces:F, loops:L, parts:C, regions:R, shells:S,
       genus:G } :< Report.counts.

%!  cube_faces(+Low, -Faces) is det.

cube_faces([X,Y,Z], Faces) :-
    X1 is X+1,
    Y1 is Y+1,
    Z1 is Z+1,
    Faces = [ [[[X,Y1,Z],[X1,Y1,Z],[X1,Y,Z],[X,Y,Z]]],
              [[[X,Y,Z1],[X1,Y,Z1],[X1,Y1,Z1],[X,Y1,Z1]]],
              [[[X,Y,Z],[X1,Y,Z],[X1,Y,Z1],[X,Y,Z1]]],
              [[[X1,Y,Z],[X1,Y1,Z],[X1,Y1,Z1],[X1,Y,Z1]]],
              [[[X1,Y1,Z],[X,Y1,Z],[X,Y1,Z1],[X1,Y1,Z1]]],
              [[[X,Y1,Z],[X,Y,Z],[X,Y,Z1],[X,Y1,Z1]]] ].

%!  box_faces(+Size-Low, -Faces) is det.

box_faces(Size-Low, Faces) :-
    cube_faces([0,0,0], Faces0),
    maplist(maplist(maplist(scaled(Size, Low))), Faces0, Faces).

scaled([], [], [], []).
scaled([S|Ss], [L|Ls], [X0|Xs0], [X|Xs]) :-
    X is L+S*X0,
    scaled(Ss, Ls, Xs0, Xs).

%!  cubes_faces(+Lows, -Faces) is det.
%
%   Of unit cubes, each face once.

cubes_faces(Lows, Faces) :-
    maplist(cube_faces, Lows, Lists),
    append(Lists, Faces0),
    once_each(Faces0, Faces).

%!  tetrahedron_faces(+Points, -Faces) is det.

tetrahedron_faces([A,B,C,D], [[[A,C,B]],[[A,B,D]],[[B,C,D]],[[C,A,D]]]).

%!  once_each(+Faces0, -Faces) is det.
%
%   The first of those with the same points.

once_each(Faces0, Faces) :-
    map_list_to_pairs([Face,Points]>>( append(Face, Points0),
                                       sort(Points0, Points) ),
                      Faces0, Pairs0),
    sort(1, @<, Pairs0, Pairs),
    pairs_values(Pairs, Faces).

%!  vertex_at(+Point, -V) is det.

vertex_at(Point0, V) :-
    floats(Point0, [X,Y,Z]),
    once(v(1, V, X, Y, Z)).
