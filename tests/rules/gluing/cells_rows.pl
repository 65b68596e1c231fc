:- module(sg_test_cells_rows,
          [ cells_rows/2,               % +S, -Rows
            cells_shape/2               % +S, -Shape
          ]).
/** <module> The rows of a segment of cells, for tests that compare them.
*/
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(vocabulary)).

%!  cells_rows(+S, -Rows) is det.

cells_rows(S, Rows) :-
    findall(Row,
            ( member(Name/Arity, [v/5,e/5,p/3,t/6,from_p/5,from_r/4,region/3,
                                  sides/4,lies_in/3]),
              functor(Row, Name, Arity),
              arg(1, Row, S),
              call(Row) ),
            Rows0),
    sort(Rows0, Rows).

%!  cells_shape(+S, -Shape) is det.
%
%   Shape has the vertices, the loops of faces, each from its lowest vertex, and
%   wires, whatever their numbers.

cells_shape(S, shape(Vs,Faces,Wires)) :-
    findall(V-p(X,Y,Z), v(S, V, X, Y, Z), Vs0),
    sort(Vs0, Vs),
    findall(Loops,
            ( p(S, P, _), facet_loops(S-P, Loops0),
              maplist(turned, Loops0, Loops) ),
            Faces0),
    msort(Faces0, Faces),
    findall(A-B,
            ( e(S, E, V, W, _), \+ edge_polygon(S, E, _),
              A is min(V, W), B is max(V, W) ),
            Wires0),
    sort(Wires0, Wires).

turned(Loop, [Least|Turned]) :-
    min_list(Loop, Least),
    append(Before, [Least|After], Loop),
    !,
    append(After, Before, Turned).
