:- module(sg_role,
          [ edge_role/5,                % +S, +E, +Look, +Crease, -Role
            look_part/3,                % ?Part, +Look, -Value
            backs_seen/2,               % +Look, -Away
            role_rank/2,                % ?Role, ?Rank
            role_drawn/2,               % ?Which, ?Role
            usual_crease/1              % -Degrees
          ]).
:- use_module('../near', [before_angle/2]).
:- use_module('../csg/known_surface', [flat_bend/1]).
:- use_module('../decision', [decision/2]).
/** <module> The role of a line in the picture.

Of all the directed edges between two vertices one is drawn, a real one if
there is one (PL-13 step 3). How its faces lie to the eye, as the join
scene_edge/5 reports it, decides its role:

    Look = look(Faces, Towards, Away, Left, Right, Bend, Edge, Solid, Cut,
                Inside, Speck)

  - Faces: how often polygons use the edge
  - Towards, Away: how many of these face the eye, or face away from it; one
    seen edge-on is neither (step 1); one of a solid that stands for a smooth
    surface faces the eye if that shows some of the edge (line_facing/7)
  - Left, Right: how many lie on the left and right of the line in the picture
  - Bend: degrees by which they are not flat, the largest of all pairs; facets
    of known surfaces (known_surface.pl) bend as these do, those of one by one
    degree at most
  - Edge: `true` if different surfaces, or faces that the terms name, meet there
    and are not tangent (known_surface.pl), or if a crease of a mesh goes on
    there though it bends less (c_kernels/picture/crease.h)
  - Solid: `true` if the segment is a solid whose shells are closed, are not
    inside out and do not go through themselves: its backs cannot be seen
  - Cut: `true` if it is part of a penetration line; not of one along which
    operands of a tree are tangent
  - Inside: `true` if it lies inside a smooth surface whose outline runs through
    its triangles (contour.pl), not along their edges

@see [PL] section 6.3, steps 1 to 3: PL-13.
*/

:- decision(edge_role/5, "The role of a line in the picture (PL-13)").

%!  edge_role(+S, +E, +Look, +Crease, -Role) is det.
%
%   True when Role is the role of edge E, one of
%
%     - penetration: part of a penetration line
%     - curve: in no polygon
%     - border: in one polygon only
%     - outline: all its faces lie on one side of it in the picture, and it is
%       not inside a smooth surface
%     - crease: it is an edge by the terms or where a crease goes on, or its
%       faces bend by more than Crease degrees, and it is no speck
%     - smooth: they bend, but less
%     - mesh: they lie flat side by side
%
%   A decision.

edge_role(_, _, Look, Crease, Role) :-
    look_part(faces, Look, Faces),
    look_part(bend, Look, Bend),
    (   look_part(cut, Look, true)
    ->  Role = penetration
    ;   Faces =:= 0
    ->  Role = curve
    ;   Faces =:= 1
    ->  Role = border
    ;   look_part(inside, Look, false),
        look_part(left, Look, Left),
        look_part(right, Look, Right),
        on_one_side(Left, Right)
    ->  Role = outline
    ;   look_part(edge, Look, true)
    ->  Role = crease
    ;   before_angle(Crease, Bend),     % all facets of a mesh alike
        look_part(speck, Look, false)
    ->  Role = crease
    ;   flat_bend(Flat),
        Bend > Flat
    ->  Role = smooth
    ;   Role = mesh
    ).

%!  look_part(?Part, +Look, -Value) is nondet.
%
%   Value is what Look says of Part: one of `faces`, `towards`, `away`, `left`,
%   `right`, `bend`, `edge`, `solid`, `cut`, `inside` and `speck`.

look_part(faces,   look(Faces,_,_,_,_,_,_,_,_,_,_), Faces).
look_part(towards, look(_,Towards,_,_,_,_,_,_,_,_,_), Towards).
look_part(away,    look(_,_,Away,_,_,_,_,_,_,_,_), Away).
look_part(left,    look(_,_,_,Left,_,_,_,_,_,_,_), Left).
look_part(right,   look(_,_,_,_,Right,_,_,_,_,_,_), Right).
look_part(bend,    look(_,_,_,_,_,Bend,_,_,_,_,_), Bend).
look_part(edge,    look(_,_,_,_,_,_,Edge,_,_,_,_), Edge).
look_part(solid,   look(_,_,_,_,_,_,_,Solid,_,_,_), Solid).
look_part(cut,     look(_,_,_,_,_,_,_,_,Cut,_,_), Cut).
look_part(inside,  look(_,_,_,_,_,_,_,_,_,Inside,_), Inside).
look_part(speck,   look(_,_,_,_,_,_,_,_,_,_,Speck), Speck).

on_one_side(Left, 0) :- Left > 0, !.
on_one_side(0, Right) :- Right > 0.

%!  backs_seen(+Look, -Away) is semidet.
%
%   True when only backs of a solid lie at the edge, Away of them.

backs_seen(Look, Away) :-
    look_part(towards, Look, 0),
    look_part(solid, Look, true),
    look_part(away, Look, Away),
    Away > 0.

%!  usual_crease(-Degrees) is det.
%
%   The crease angle where none is given: what bends by more is an edge, in a
%   mesh of which nothing is known.

usual_crease(30).

%!  role_rank(?Role, ?Rank) is nondet.
%
%   Of lines that lie on one another in the picture the one whose role has the
%   smallest rank is drawn.

role_rank(penetration, 0).
role_rank(outline,     1).
role_rank(crease,      2).
role_rank(border,      3).
role_rank(curve,       4).
role_rank(section,     5).
role_rank(smooth,      6).
role_rank(mesh,        7).

%!  role_drawn(?Which, ?Role) is nondet.
%
%   True when a picture with lines(Which) shows lines of this Role: `all` real
%   edges, `feature` lines, or only the `penetration` lines.

role_drawn(all, Role) :-
    role_rank(Role, _).
role_drawn(feature, Role) :-
    role_rank(Role, Rank),
    Rank < 6.
role_drawn(penetration, penetration).
