:- module(sg_inside,
          [ inside/2,                   % ?S, +Point
            winding/3                   % +S, +Point, -Winding
          ]).
:- use_module('../kernel', [windings/3]).
:- use_module('../polygon/triangulation',
              [complete_segments/1, untriangulated/1]).
:- use_module('../store', [segment/3, facts_snapshot/1]).

/** <module> What is inside what: winding numbers, exactly.

How often a closed segment goes round a point says whether the point is inside
it, also where its shells lie in each other or go through each other: a ray
from the point leaves through some triangles and enters through others, and the
difference counts. The ray runs in direction +x and is shifted by less than
anything towards +y, and by still less towards +z, so it meets no edge.

The kernel windings/3 answers for many points at once. tests/oracle/winding.pl
is the rule, and a test compares the two.

@see c_kernels/join/winding.h
*/

%!  inside(?S, +Point) is nondet.
%
%   True when point(X, Y, Z), in any numbers, lies inside solid S: not on its
%   surface.

inside(S, Point) :-
    segment(S, solid, _),
    winding(S, Point, Winding),
    integer(Winding),
    Winding > 0.

%!  winding(+S, +Point, -Winding) is det.
%
%   Winding is how often the triangles of segment S go round point(X, Y, Z),
%   counter-clockwise from outside, or `on` if it lies on one. Exact. Of an open
%   surface the number means nothing.

winding(S, Point, Winding) :-
    (   integer(S),
        untriangulated(S)
    ->  facts_snapshot(( complete_segments([S]),
                         windings(S, [Point], [Winding]) ))
    ;   windings(S, [Point], [Winding])
    ).
