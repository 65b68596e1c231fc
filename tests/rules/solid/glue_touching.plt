:- encoding(utf8).
:- module(test_glue_touching, []).
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(gluing/regions), [regions_report/2]).
:- use_module(rules(solid/csg_evaluate), [evaluate/1]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

/* Surfaces that are made to touch somewhere, and walls elsewhere that lie on
   each other, with other diagonals: both get seams there, and each part of a
   wall is there once.

   triangle(S, A, B, C): fifteen triangles of buildings and roads of Delft
   (3D BAG by tudelft3d, CC BY 4.0; as in the tests of cjio).
*/

triangle(1, [84855.595,447549.715,2.89], [84852.994,447553.338,-0.01],
         [84852.994,447553.338,0.0]).
triangle(1, [84855.595,447549.715,2.89], [84852.994,447553.338,0.0],
         [84852.994,447553.338,2.87]).
triangle(1, [84855.595,447549.715,2.89], [84852.994,447553.338,2.87],
         [84852.994,447553.338,2.89]).
triangle(2, [84842.616,447540.411,3.05], [84842.594,447540.377,-0.01],
         [84842.594,447540.377,3.05]).
triangle(2, [84852.994,447553.338,0.0], [84855.595,447549.715,-0.01],
         [84852.994,447553.338,2.87]).
triangle(2, [84852.994,447553.338,2.87], [84855.595,447549.715,-0.01],
         [84852.994,447553.338,2.89]).
triangle(2, [84852.994,447553.338,2.89], [84855.595,447549.715,-0.01],
         [84855.595,447549.715,2.89]).
triangle(3, [84846.758,447536.73,0.14], [84842.594,447540.377,-0.01],
         [84842.092,447539.702,0.03]).
triangle(3, [84846.643,447536.555,0.02], [84846.758,447536.73,0.14],
         [84842.092,447539.702,0.03]).
triangle(4, [84889.716,447508.758,0.05], [84889.31,447503.282,-0.08],
         [84892.262,447507.7,0.11]).
triangle(4, [84845.536,447533.606,-0.03], [84851.684,447533.268,0.04],
         [84846.643,447536.555,0.02]).
triangle(5, [84906.709,447498.083,-0.01], [84906.694,447498.089,-0.01],
         [84906.704,447498.085,-0.01]).
triangle(5, [84894.935,447506.142,0.1], [84894.977,447505.942,0.1],
         [84894.966,447506.123,0.1]).
triangle(6, [84906.699,447498.087,-0.01], [84906.694,447498.089,-0.01],
         [84906.617,447497.938,-0.01]).
triangle(7, [84894.908,447506.332,0.1], [84892.262,447507.7,0.11],
         [84894.935,447506.142,0.1]).

triangles_glued(Counts) :-
    in_new_world(( facts_transaction(test_glue_touching:surfaces_made),
                   evaluate(8),
                   regions_report(8, Report) )),
    Counts = Report.counts.

surfaces_made :-
    forall(between(1, 7, S), surface_made(S)),
    assert_fact(segment(8, cells, glue([1,2,3,4,5,6,7]))),
    complete_segments.

surface_made(S) :-
    assert_fact(segment(S, surface, part)),
    findall([A,B,C], triangle(S, A, B, C), Triangles),
    append(Triangles, Corners0),
    sort(Corners0, Corners),
    forall(nth1(V, Corners, [X,Y,Z]), assert_fact(v(S, V, X, Y, Z))),
    forall(nth1(P, Triangles, Triangle),
           triangle_made(S, P, Triangle, Corners)).

triangle_made(S, P, Triangle, Corners) :-
    findall(V, ( member(Corner, Triangle), nth1(V, Corners, Corner) ),
            [A,B,C]),
    findall(Id, ( between(1, 3, I), Id is 3*P+I ), Es),
    forall(( nth1(I, [A-B,B-C,C-A], V1-V2), nth1(I, Es, E) ),
           assert_fact(e(S, E, V1, V2, 1))),
    assert_fact(p(S, P, Es)).

:- begin_tests(glue_touching).

test(each_once, Counts == [26,34,12,4,1]) :-
    triangles_glued(All),
    findall(N, ( member(Key, [vertices,edges,faces,parts,regions]),
                 get_dict(Key, All, N) ),
            Counts).

:- end_tests(glue_touching).
