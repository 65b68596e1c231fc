:- module(sg_integrity,
          [ model_defect/1,             % ?Defect
            defect_weight/2,            % ?Name, ?Weight
            no_defect/2,                % +Kind, ?Name
            shell_defect/3              % ?Name, +Shells, +Shell
          ]).
:- use_module('../kernel',
              [census_defect/4, census_part/2, census_shell/4, self_meeting/4]).
:- use_module('../store', [segment/3, origin/3]).
/** <module> What can be wrong with a model.

A bad model is no error but a relation. The joins are one pass in C
(c_kernels/model/census.h); what counts as a defect is decided here.
*/

%!  model_defect(?Defect) is nondet.
%
%   True when the current world has Defect, one of
%
%     - open_edge(S, E)
%       A half-edge of a solid that has no opposite.
%     - turned_edge(S, E1, E2)
%       Two polygons use an edge in the same direction: one faces the wrong way.
%     - nonmanifold_edge(S, E, N), touching_edge(S, E, N)
%       N > 2 half-edges between the ends of E; of a touching_edge as many one
%       way as the other, as where bodies touch along it.
%     - shared_half_edge(S, E, P)
%       E is in P and in another polygon.
%     - open_polygon(S, P, N)
%       N edges of P lead nowhere: its loops do not close.
%     - duplicate_face(S, P1, P2)
%     - inside_out(S)
%       A solid whose volume is negative: its normals point inward.
%     - nested_shell(S, P, Depth)
%       Depth other shells of solid S go round the shell that has polygon P.
%     - turned_shell(S, P)
%       One of several shells of S is inside out, and no hollow: an even number
%       of others go round it.
%     - pinched_vertex(S, V, N)
%       N separate fans of polygons meet at V.
%     - degenerate_face(S, P), bent_face(S, P), short_edge(S, E)
%       No area; off its plane; no length: all within the tolerance of the
%       source.
%     - wrong_plane(S, P), wrong_triangles(S, P)
%       plane/6 or t/6 is not as the corners of P have it: another plane, the
%       other side, or triangles that do not cover P once, as it is turned.
%     - crossed_face(S, P)
%       P crosses or overlaps itself, or a hole of it is outside or runs the
%       wrong way round: no triangles fill it, and it is left out.
%     - twin_vertices(S, V1, V2), unused_vertex(S, V)
%     - self_penetration(S, P1, P2), self_overlap(S, P1, P2)
%       Two polygons of a segment (or one) go through each other, or lie in one
%       plane and share some area.
%     - self_touching(S, P1, P2)
%       A point or an edge of one is on the other, and not as neighbours meet.
%
%   In order of the segments. What no_defect/2 says is none.

model_defect(Defect) :-
    (   var(Defect)
    ->  census_defect(Kind, S, A, B),
        defect_census(Defect, Kind, S, A, B)
    ;   defect_census(Defect, Kind, S, A, B),
        census_defect(Kind, S, A, B)
    ),
    (   segment(S, Of, _)
    ->  true
    ;   Of = unknown
    ),
    \+ no_defect(Of, Kind),
    \+ is_meant(Defect).
model_defect(inside_out(S)) :-
    census_part(S, part(_, _, _, _, Volume, _, _, _)),
    Volume < 0.0,
    once(segment(S, solid, _)).
model_defect(Defect) :-
    (   var(Defect)
    ->  census_shell(S, P, Shells, Shell),
        shell_defect(Name, Shells, Shell),
        arg(10, Shell, Depth),
        defect_shell(Defect, Name, S, P, Depth)
    ;   defect_shell(Defect, Name, S, P, Depth),
        census_shell(S, P, Shells, Shell),
        arg(10, Shell, Depth),
        shell_defect(Name, Shells, Shell)
    ),
    once(segment(S, solid, _)).
model_defect(Defect) :-
    (   var(Defect)
    ->  self_meeting(Kind, S, P1, P2),
        self_defect(Defect, Kind, S, P1, P2)
    ;   self_defect(Defect, Kind, S, P1, P2),
        self_meeting(Kind, S, P1, P2)
    ),
    \+ is_meant(Defect).

%   is_meant(Defect): one of the faces was parted from the other, with a slit
%   between.

is_meant(duplicate_face(S, P1, P2)) :-
    is_slit(S, P1, P2).
is_meant(self_overlap(S, P1, P2)) :-
    is_slit(S, P1, P2).

is_slit(S, P1, P2) :-
    (   origin(S, p(P2), slit(P1))
    ->  true
    ;   origin(S, p(P1), slit(P2))
    ).

%   defect_shell(?Defect, ?Name, ?S, ?P, ?Depth).

defect_shell(nested_shell(S, P, Depth), nested_shell, S, P, Depth).
defect_shell(turned_shell(S, P),        turned_shell, S, P, _).

%!  shell_defect(?Name, +Shells, +Shell) is nondet.
%
%   True when Shell, a shell/10 of census/1, one of the Shells that a solid has,
%   has the defect called Name: nested_shell or turned_shell.

shell_defect(nested_shell, _, Shell) :-
    arg(10, Shell, Depth),
    Depth > 0.
shell_defect(turned_shell, Shells, Shell) :-
    Shells > 1,
    arg(9, Shell, Volume),
    Volume < 0.0,
    arg(10, Shell, Depth),
    Depth mod 2 =:= 0.

self_defect(self_penetration(S, P1, P2), self_penetration, S, P1, P2).
self_defect(self_overlap(S, P1, P2),     self_overlap,     S, P1, P2).
self_defect(self_touching(S, P1, P2),    self_touching,    S, P1, P2).

%   defect_census(?Defect, ?Kind, ?S, ?A, ?B): the terms of C for Defect.

defect_census(open_edge(S, E),            border_edge,      S, E, _).
defect_census(turned_edge(S, E1, E2),     turned_edge,      S, E1, E2).
defect_census(nonmanifold_edge(S, E, N),  nonmanifold_edge, S, E, N).
defect_census(touching_edge(S, E, N),     touching_edge,    S, E, N).
defect_census(shared_half_edge(S, E, P),  shared_half_edge, S, E, P).
defect_census(open_polygon(S, P, N),      open_polygon,     S, P, N).
defect_census(duplicate_face(S, P1, P2),  duplicate_face,   S, P1, P2).
defect_census(pinched_vertex(S, V, N),    pinched_vertex,   S, V, N).
defect_census(degenerate_face(S, P),      degenerate_face,  S, P, _).
defect_census(bent_face(S, P),            bent_face,        S, P, _).
defect_census(short_edge(S, E),           short_edge,       S, E, _).
defect_census(wrong_plane(S, P),          wrong_plane,      S, P, _).
defect_census(wrong_triangles(S, P),      wrong_triangles,  S, P, _).
defect_census(crossed_face(S, P),         crossed_face,     S, P, _).
defect_census(twin_vertices(S, V1, V2),   twin_vertices,    S, V1, V2).
defect_census(unused_vertex(S, V),        unused_vertex,    S, V, _).

%!  no_defect(+Kind, ?Name) is nondet.
%
%   True when a segment of this Kind may have what census/1 counts as Name: what
%   is no solid borders, `cells` any number of faces at an edge, turned any way.

no_defect(Kind, border_edge) :-
    Kind \== solid.
no_defect(cells, turned_edge).
no_defect(cells, nonmanifold_edge).
no_defect(cells, touching_edge).
no_defect(cells, pinched_vertex).

%!  defect_weight(?Name, ?Weight) is nondet.
%
%   True when a defect of this Name is a `fault`, that makes a model wrong, or a
%   `remark`.

defect_weight(open_edge,        fault).
defect_weight(turned_edge,      fault).
defect_weight(nonmanifold_edge, fault).
defect_weight(shared_half_edge, fault).
defect_weight(open_polygon,     fault).
defect_weight(duplicate_face,   fault).
defect_weight(inside_out,       fault).
defect_weight(self_penetration, fault).
defect_weight(wrong_plane,      fault).
defect_weight(wrong_triangles,  fault).
defect_weight(crossed_face,     fault).
defect_weight(self_overlap,     fault).
defect_weight(broken_law,       fault).
defect_weight(unsure_part,      fault).
defect_weight(touching_edge,    remark).
defect_weight(nested_shell,     remark).
defect_weight(turned_shell,     remark).
defect_weight(pinched_vertex,   remark).
defect_weight(degenerate_face,  remark).
defect_weight(bent_face,        remark).
defect_weight(short_edge,       remark).
defect_weight(twin_vertices,    remark).
defect_weight(unused_vertex,    remark).
defect_weight(self_touching,    remark).
