:- module(sg_oracle_triangulation,
          [ polygon_triangles/3,        % +S, +P, -Triangles
            work_triangles_by_rule/2    % +Work, -Triangles
          ]).
:- use_module('../../rules/kernel',
              [ model_tolerance/1, work_open/3, work_close/1, work_resolve/2,
                work_gap/2, work_edge/6, work_oldest/4, work_candidate/5,
                work_add/6, work_delete/2, work_thicken/4
              ]).
/** <module> The rule of polygons into triangles.

Triangulation by backtracking (PL-6), for concave, hollow, several times
hollow and internally cut polygons alike; section 4 of the paper, step by
step. The numbers are the paper's.

    1. The edges Es of polygon P are put into a buffer   work_open/3
    2. Choose an edge V1-V2 of Es                        work_oldest/4
    3. Choose V3: the end of an edge leaving V2, the     work_candidate/5
       start of one entering V1, or any other vertex
    4. (I) V1-V2-V3 turns as P does                      work_candidate/5
       (II) no other edge meets it                       work_candidate/5
       (3) delete and add edges (3-1 ... 3-5)            take_off/5
    5. V1-V2-V3 is a triangle
    6. Until Es is empty                                 the recursion

One thing is sharper than in the paper. (II) is closed: nothing may even touch
the triangle but in its corners and along its sides. Then a triangle that can
be taken off leaves a polygon that can be finished, so step 2 needs no
alternatives: backtracking goes over the third vertices of ONE edge, and an
edge without any proves that the polygon is invalid (it crosses or overlaps
itself, or a hole is outside or turned the wrong way).

Edges are taken oldest first, and added edges are the youngest. So the polygon
is worn off evenly all round, and no long fans arise.

Where a vertex was meant to lie on a line between two others, and does except
rounding, a triangle may be thinner than rounding and look either way. Then
chords are turned (work_thicken/4).

fill_triangles/3 gives the same triangles in the same order.

@see [PL] section 4, row PL-6 of the requirements
*/

%!  polygon_triangles(+S, +P, -Triangles) is det.
%
%   Triangles are the triangles of polygon P as t(V1, V2, V3), by the rule.
%   Changes nothing in the world.
%
%   @error model_error(polygon(S, P, open(V))): it does not close at V
%   @error geometry_error(polygon_edge(S, P, V1, V2)): it is invalid, for its
%          edge V1-V2 has no third vertex

polygon_triangles(S, P, Triangles) :-
    catch(reached_triangles(S, P, 0.0, Triangles),
          error(geometry_error(no_third_vertex(V1, V2)), _),
          second_triangles(S, P, V1-V2, Triangles)).

%   Rounding may have opened contacts (a hole that touches the border,
%   turned). So try once more, with what is within the model's tolerance made
%   to touch.

second_triangles(S, P, V1-V2, Triangles) :-
    model_tolerance(Reach),
    catch(reached_triangles(S, P, Reach, Triangles),
          error(geometry_error(no_third_vertex(_, _)), _),
          throw(error(geometry_error(polygon_edge(S, P, V1, V2)), _))).

reached_triangles(S, P, Reach, Triangles) :-
    setup_call_cleanup(
        work_open(S, P, Work),                                  % step 1
        resolved_triangles(Work, S, P, Reach, Triangles),
        work_close(Work)).

resolved_triangles(Work, S, P, _, _) :-
    work_gap(Work, V),
    !,
    throw(error(model_error(polygon(S, P, open(V))), _)).
resolved_triangles(Work, _, _, Reach, Triangles) :-
    work_resolve(Work, Reach),
    work_triangles_by_rule(Work, Triangles).

%!  work_triangles_by_rule(+Work, -Triangles) is det.
%
%   Triangles are the triangles t(V1, V2, V3) of the polygon in Work, whose
%   edges are used up.
%
%   @error geometry_error(no_third_vertex(V1, V2)): see polygon_triangles/3

work_triangles_by_rule(Work, Triangles) :-
    findall(V1-V2, work_edge(Work, _, V1, V2, _, _), Edges),
    taken_off(Work, Triangles0),
    work_thicken(Work, Edges, Triangles0, Triangles).

taken_off(Work, Triangles) :-
    (   work_oldest(Work, E, V1, V2)                            % step 2
    ->  third_vertex(Work, E, V1, V2, V3),                      % steps 3, 4
        Triangles = [t(V1, V2, V3)|Triangles1],                 % step 5
        taken_off(Work, Triangles1)                             % step 6-1
    ;   Triangles = []                                          % step 6-2
    ).

third_vertex(Work, E, V1, V2, V3) :-
    candidate(Work, V1, V2, 0, V3),                             % 3, (I), (II)
    take_off(Work, E, V1, V2, V3),                              % (3)
    !.
third_vertex(_, _, V1, V2, _) :-
    throw(error(geometry_error(no_third_vertex(V1, V2)), _)).

%   take_off(+Work, +E, +V1, +V2, +V3): step 4 (3). Fails with nothing changed
%   (3-5) if a side that is missing is there the other way round.

take_off(Work, E, V1, V2, V3) :-
    side(Work, V2, V3, Side2),
    side(Work, V3, V1, Side3),
    work_delete(Work, E),
    replace_side(Side2, Work, V2, V3),
    replace_side(Side3, Work, V3, V1).

%   side(+Work, +A, +B, -Side): Side is edge(E) if A-B is an edge, `new` if
%   neither it nor its opposite is.

side(Work, A, B, edge(E)) :-
    work_edge(Work, E, A, B, _, _),
    !.
side(Work, A, B, new) :-
    \+ work_edge(Work, _, B, A, _, _).

%   Of the sides V2-V3 and V3-V1: both are edges (3-1), one is (3-2, 3-3), or
%   none (3-4). An edge is deleted; for another side its opposite is added, as
%   an auxiliary edge of what is left.

replace_side(edge(E), Work, _, _) :-
    work_delete(Work, E).
replace_side(new, Work, A, B) :-
    work_add(Work, B, A, 0, 0, _).

candidate(Work, V1, V2, N, V3) :-
    work_candidate(Work, V1, V2, N, X),
    (   V3 = X
    ;   N1 is N+1,
        candidate(Work, V1, V2, N1, V3)
    ).
