:- module(test_sew, []).
:- use_module(library(plunit)).
:- use_module(rules(kernel)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(picture/sew)).
:- use_module(rules(polygon/triangulation)).
/* Patches of one segment become one surface where their borders are the same.
*/

:- begin_tests(sew).

%   sewn(Points, Faces, Vertices, Borders): of a sheet, how many vertices went
%   and how many border edges are left.

sewn(Points, Faces, Vertices, Borders) :-
    new_world(World),
    in_world(World,
             ( add_primitive(sheet(points(Points), faces(Faces)), _),
               complete_segments,
               borders_sewn(Vertices),
               findall(E, census_defect(border_edge, _, E, _), Es),
               length(Es, Borders),
               \+ ( p(1, P, _),
                    \+ t(1, P, _, _, _, _)
                  ) )).

test(two_patches, Vertices-Borders == 2-4) :-
    sewn([[0,0,0], [1,0,0], [0,1,0], [1,0,0], [1,1,1], [0,1,0]],
         [[1,2,3], [4,5,6]], Vertices, Borders).
test(minus_zero, Vertices-Borders == 2-4) :-
    sewn([[0,0,0], [1,0,0], [0,1,0.0], [1,-0.0,0], [1,1,1], [0,1,-0.0]],
         [[1,2,3], [4,5,6]], Vertices, Borders).
test(same_way, Vertices-Borders == 0-6) :-
    sewn([[0,0,0], [1,0,0], [0,1,0], [1,0,0], [1,1,1], [0,1,0]],
         [[1,2,3], [4,6,5]], Vertices, Borders).
test(in_a_point, Vertices-Borders == 0-6) :-
    sewn([[0,0,0], [1,0,0], [0,1,0], [1,0,0], [2,0,0], [2,1,0]],
         [[1,2,3], [4,5,6]], Vertices, Borders).
test(three_at_an_edge, Vertices-Borders == 0-9) :-
    sewn([[0,0,0], [1,0,0], [0,1,0], [1,0,0], [1,1,1], [0,1,0],
          [1,0,0], [1,1,-1], [0,1,0]],
         [[1,2,3], [4,5,6], [7,8,9]], Vertices, Borders).
test(nothing_to_sew, Vertices-Borders == 0-3) :-
    sewn([[0,0,0], [1,0,0], [0,1,0]], [[1,2,3]], Vertices, Borders).

%   Four squares round a point, each with vertices of its own, in any order.

test(four_patches, Left == 9-8) :-
    Squares = [0-0, -1-0, 0-(-1), -1-(-1)],
    findall([X,Y,0], ( member(A-B, Squares), member(I-J, [0-0,1-0,1-1,0-1]),
                       X is A+I, Y is B+J ), Points),
    sewn(Points, [[1,2,3,4], [5,6,7,8], [9,10,11,12], [13,14,15,16]],
         Vertices, Borders),
    Left0 is 16-Vertices,
    Left = Left0-Borders.
test(in_one_transaction, Count == 6) :-
    new_world(World),
    in_world(World,
             ( add_primitive(sheet(points([[0,0,0], [1,0,0], [0,1,0], [1,0,0],
                                           [1,1,1], [0,1,0]]),
                                   faces([[1,2,3], [4,5,6]])), _),
               complete_segments,
               borders_sewn(2),
               facts_undo,
               findall(V, v(1, V, _, _, _), Vs),
               length(Vs, Count) )).

:- end_tests(sew).
