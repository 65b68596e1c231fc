/* Rings of points: what is kept of them is what they are. */
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(angle)).
:- use_module(rules(primitive/shape)).

:- begin_tests(shape).

%   Each ring twice, more of them than are kept, one too large to be kept.
test(rings, [forall(( member(_, [first,again]),
                      member(N, [3,4,5,6,7,8,9,10,11,12,40,41,96,511,513]) )),
             true(Wrong == [])]) :-
    ring_points(3.0-2.0, point(1.0, 5.0, 7.0), N, Points),
    ring_ranges(N, Ranges),
    length(Points, N),
    length(Ranges, N),
    findall(I,
            ( nth1(I, Points, P),
              nth1(I, Ranges, Range),
              Angle is (I-1)*360 rdiv N,
              exact_sin_cos(Angle, Sin, Cos),
              X is 3.0*Cos + 1.0,
              Y is 2.0*Sin + 5.0,
              T1 is float(Angle),
              T2 is float(I*360 rdiv N),
              P-Range \== point(X, Y, 7.0)-(T1-T2) ),
            Wrong).

%   A process that makes many rings keeps a few of them.
test(few_kept, true(Count =< 16)) :-
    forall(between(3, 40, N),
           ( ring_points(1.0-1.0, point(0.0, 0.0, 0.0), N, _),
             ring_ranges(N, _) )),
    predicate_property(sg_shape:ring_kept(_, _, _), number_of_clauses(Count)).

:- end_tests(shape).
