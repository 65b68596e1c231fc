:- module(sg_test_edit_value,
          [ one_of/2,                   % +List, -Member
            typed/2,                    % +Type, -Value
            solid/1                     % -Primitive
          ]).
/** <module> Random values of edits and questions: plausible ones, and some that
no user would give.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(yall)).

%!  one_of(+List, -Member) is semidet.

one_of(List, Member) :-
    length(List, N),
    N > 0,
    I is random(N),
    nth0(I, List, Member).

%!  typed(+Type, -Value) is det.
%
%   Value could stand in a column of this Type (relations.def).

typed(int, Value) :-
    one_of([1,1,1,2,2,3,4,5,6,7,8,9,12,20,21,24,40,1000,0,-1,-2,2147483647,
            -2147483647,-2147483648,4294967297],
           Value).
typed(float, Value) :-
    one_of([0.0, 0.0, 1.0, 1.0, -1.0, 0.5, 2, 3.25, 1.0e-300, 1.0e-9, 1.0e89,
            -1.0e9, 0.1, 45, 30],
           Value).
typed(list, Value) :-
    random_between(0, 5, N),
    findall(I, ( between(1, N, _), typed(int, I) ), Value).
typed(atom, Value) :-
    one_of([solid, surface, curve, visible, x], Value).
typed(term, Value) :-
    one_of([ x, v(1), e(1), e(2), p(1), v(9), node(1), surfaces, 1.5, "text",
             union([1,2]), difference([1,2]), box(size(1,1,1)), lpi(1,2,3),
             lpi(e(1),s(2),t(3)), ll(e(1),e(2)), tpi(p(1),p(2),p(3)), root(1),
             cut(1), cut([1,2]), keep(2), order([2,1]), removed(1), f(f(f(x))),
             at([translate(1,0,0)], 1), [1,2,3] ],
           Value).

%!  solid(-Primitive) is det.
%
%   Primitive is a placed one, so that those of a world meet often.

solid(at(Steps, Solid)) :-
    steps(Steps),
    one_of([ box(size(2,2,2)), box(size(1,2,3)), box(size(1,1,1)),
             cylinder(radius(1), height(2), facets(6)),
             cone(radius(1), height(2), facets(5)),
             sphere(radius(1), facets(6)),
             pyramid(radius(1), height(2), sides(4)),
             hollow_cylinder(radius(1), thickness(0.25), height(2), facets(5)),
             torus(radius(2), tube(0.5), facets(4)) ],
           Solid).

steps([translate(X,Y,Z)|Turn]) :-
    maplist([C]>>( random_between(-4, 4, I), C is I/4.0 ), [X,Y,Z]),
    one_of([ [], [], [rotate(z,30)], [rotate(x,45)], [scale(0.5)] ], Turn).
