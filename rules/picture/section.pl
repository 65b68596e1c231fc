:- module(sg_section,
          [ section_plane/3,            % +Text, -Plane, -Axis
            section_plane/4,            % +Text, :Box, -Plane, -Axis
            cut_away/2,                 % +Plane, -Section
            section_lines/3,            % +Section, +OperandLines, -Lines
            section_edges/3,            % +Section, ?N, -Edges
            section_region/5,           % +Section, ?S, ?Cell, ?N, -Edges
            model_box/1                 % -Box
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module('../solid/boolean', [boolean/3]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../solid/csg_half_space', [half_space/3]).
:- use_module('../csg/csg_record', [drop_record/1]).
:- use_module('../csg/known_surface', [facets_of/2, remember_facets/1]).
:- use_module('../csg/csg_rows', [drop_boundary/1, segment_box/2]).
:- use_module('../gluing/exploded', [segment_exploded/3]).
:- use_module('../gluing/regions', [regions_made/2, region_neighbour/4]).
:- use_module('../kernel', [segments_tolerance/3]).
:- use_module('../primitive/primitive_rows', [add_primitive/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, from_p/5, region/3, edge_polygon/3,
                assert_fact/1, retractall_facts/1, fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(apply),
              [foldl/4, maplist/2, maplist/3, maplist/4]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [append/2, max_list/2, member/2, min_list/2]).
:- use_module(library(ordsets), [ord_memberchk/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- meta_predicate section_plane(+, 1, -, -).
/** <module> Sections: the model cut open by a plane.

What is above the plane, where the eye stands, is taken away, exactly: a solid
is split by it as rows DV-3 and CB-1 say, and the faces that come to lie in
the plane are its *caps*. Of an open surface, which has no inside, the part
below stays, and where it ends is a line; of a curve the pieces below.

    section(Plane, Pieces)
    piece(S, N, Kind, Caps)     what is left of segment S is segment N; its
                                caps are polygons

Of a model of cells each cell is a piece: Kind is cell(K), and K is not that of
a neighbour.
*/

%!  section_plane(+Text, -Plane, -Axis) is semidet.
%!  section_plane(+Text, :Box, -Plane, -Axis) is semidet.
%
%   Text says where to cut: `x=5`, `x` (through the middle of the model), or
%   `A,B,C,D`. Plane is plane(A,B,C,D), the eye being where A*X + B*Y + C*Z +
%   D > 0: for x on the right, for y in front (at -y), for z above. Axis is x,
%   y, z, or none. The model is the current world, or what call(Box, B) says,
%   as model_box/1.

section_plane(Text, Plane, Axis) :-
    section_plane(Text, sg_section:model_box, Plane, Axis).

section_plane(Text, Box, Plane, Axis) :-
    split_string(Text, "=", " ", [AxisText|Value]),
    atom_string(Axis0, AxisText),
    downcase_atom(Axis0, Axis),
    memberchk(Axis, [x,y,z]),
    !,
    axis_value(Value, Box, Axis, At),
    axis_plane(Axis, At, Plane).
section_plane(Text, _, plane(A,B,C,D), none) :-
    split_string(Text, ",", " ", Parts),
    maplist(decimal_number, Parts, [A,B,C,D]),
    once(( member(N, [A,B,C]), N =\= 0 )).

axis_value([], Box, Axis, At) :-
    call(Box, box(X1,Y1,Z1,X2,Y2,Z2)),
    memberchk(Axis-Low-High, [x-X1-X2, y-Y1-Y2, z-Z1-Z2]),
    At is (Low+High)/2.
axis_value([Text], _, _, At) :-
    decimal_number(Text, At).

axis_plane(x, At, plane(1,0,0,D)) :-
    D is 0-At.
axis_plane(y, At, plane(0,-1,0,At)).
axis_plane(z, At, plane(0,0,1,D)) :-
    D is 0-At.

%!  model_box(-Box) is semidet.
%
%   Box is box(X1,Y1,Z1,X2,Y2,Z2) round all vertices of the current world.

model_box(Box) :-
    findall(Box0, ( segment(S, _, _), segment_box(S, Box0) ), [First|Boxes]),
    foldl(box_union, Boxes, First, Box).

box_union(box(A1,B1,C1,D1,E1,F1), box(A2,B2,C2,D2,E2,F2),
          box(A,B,C,D,E,F)) :-
    maplist(lower, [A1,B1,C1], [A2,B2,C2], [A,B,C]),
    maplist(higher, [D1,E1,F1], [D2,E2,F2], [D,E,F]).

lower(X, Y, Z) :-
    Z is min(X, Y).

higher(X, Y, Z) :-
    Z is max(X, Y).

%!  cut_away(+Plane, -Section) is semidet.
%
%   The current world, whose segments are all roots and not yet cut by each
%   other, loses what is above Plane. Section says what is left; the segments
%   may then cut each other. Fails, the world being as it was, if Plane goes
%   past all segments. Of `cells` each cell is cut as a solid.
%
%   @error geometry_error(operand(S, Faults)): solid S has no inside

cut_away(Plane, section(Exact, Pieces)) :-
    Plane = plane(A,B,C,D),
    maplist(exactly, [A,B,C,D], Rationals),
    Exact =.. [plane|Rationals],
    findall(S, segment(S, _, _), Ss),
    sort(Ss, Sorted),
    maplist(segment_side(Exact), Sorted, Sides),
    once(member(_-cut, Sides)),
    maplist(segment_cut(Exact), Sides, Pieces0),
    append(Pieces0, Pieces),
    remember_surfaces(Pieces),
    forall(( member(S, Sorted), \+ member(piece(_,S,_,_), Pieces) ),
           dropped(S)).

%   remember_surfaces(Pieces): of what is left of a segment, as long as it is
%   there.

remember_surfaces(Pieces) :-
    findall(N, ( member(piece(S,N,_,_), Pieces), N \== S ), Ns0),
    sort(Ns0, Ns),
    facets_of(Ns, Facets),
    remember_facets(Facets).

exactly(N, R) :-
    R is rational(N).

%   segment_side(Plane, S, S-Side): on which side of the plane it is, `below`,
%   `above` or `cut`. What only touches it is not cut.

segment_side(Plane, S, S-Side) :-
    (   segment_box(S, Box)
    ->  half_space(Plane, Box, Half),
        half_side(Half, Plane, S, Side)
    ;   Side = above
    ).

half_side(all, _, _, below) :-
    !.
half_side(none, _, _, above) :-
    !.
half_side(_, Plane, S, Side) :-
    (   \+ ( vertex_height(Plane, S, _, H), H > 0 )
    ->  Side = below
    ;   \+ ( vertex_height(Plane, S, _, H), H < 0 )
    ->  Side = above
    ;   Side = cut
    ).

segment_cut(_, S-below, [piece(S,S,below,[])]).
segment_cut(_, _-above, []).
segment_cut(Plane, S-cut, Pieces) :-
    segment(S, cells, _),
    !,
    cells_cut(Plane, S, Pieces).
segment_cut(Plane, S-cut, [piece(S,N,Kind,Caps)]) :-
    segment(S, Kind, Name),
    kind_cut(Kind, Plane, S, Name, N, Caps).

dropped(S) :-
    drop_record(S),
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).

%   kind_cut(Kind, Plane, S, Name, N, Caps)

kind_cut(curve, Plane, S, _, S, []) :-
    !,
    findall(edge(E,V1,V2,Et), e(S, E, V1, V2, Et), Edges),
    maplist(curve_edge_cut(Plane, S), Edges).
kind_cut(surface, Plane, S, Name, N, []) :-
    !,
    surface_cut(Plane, S, Name, N).
kind_cut(_, Plane, S, Name, N, Caps) :-
    segment_box(S, Box),
    half_space(Plane, Box, Half),
    half_boolean(Half, S, intersection, solid, Name, K, N),
    findall(P, ( from_p(N, P, K, _, _), \+ from_p(N, P, S, _, _) ), Caps0),
    sort(Caps0, Caps),
    dropped(K).

%   half_boolean(Half, S, Operation, Kind, Name, K, N): segment N, of Kind and
%   Name, is Operation of S and K, the solid Half. Faces of the one do not
%   become one with faces of the other, so a face of S that lies in the plane
%   is none of the caps.

half_boolean(Half, S, Operation, Kind, Name, K, N) :-
    add_primitive(Half, K),
    complete_segments([K]),
    segments_tolerance([S], Reach, _),
    fresh_id(segment, 0, N),
    assert_fact(segment(N, Kind, Name)),
    Expression =.. [Operation,[S,K]],
    boolean(Expression, N, [tolerance(own(Reach)),origins(separate)]).


                /*******************************
                *             CELLS            *
                *******************************/

%   cells_cut(Plane, S, Pieces): of each cell, sheet and wire of S.

cells_cut(Plane, S, Pieces) :-
    (   region(S, _, _)
    ->  true
    ;   regions_made(S, _)
    ),
    segment_exploded(S, 0, Parts),
    colours(Plane, S, Colours),
    maplist(part_cut(Plane, S, Colours), Parts, Lists),
    append(Lists, Pieces).

part_cut(Plane, S, Colours, part(N0,Kind0,R), Pieces) :-
    segment_side(Plane, N0, Side),
    segment_cut(Plane, Side, Cut),
    (   Kind0 == solid
    ->  get_assoc(R, Colours, K),
        Kind = cell(K)
    ;   Kind = Kind0
    ),
    findall(piece(S,N,Kind,Caps), member(piece(_,N,_,Caps), Cut), Pieces),
    maplist(sources_named(S, N0), Pieces),
    (   member(piece(_,N0,_,_), Pieces)
    ->  true
    ;   dropped(N0)
    ).

%   sources_named(S, N0, Piece): its polygons come from those of S.

sources_named(S, N0, piece(_,N,_,_)) :-
    (   N == N0
    ->  true
    ;   findall(from(P,P0,Sense), from_p(N, P, N0, P0, Sense), Froms),
        retractall_facts(from_p(N, _, N0, _, _)),
        forall(( member(from(P,P0,Sense0), Froms),
                 from_p(N0, P0, S, P1, Sense1) ),
               ( Sense is Sense0*Sense1,
                 assert_fact(from_p(N, P, S, P1, Sense)) ))
    ).

%   colours(Plane, S, Colours): the least number from 1 on that no region has
%   beyond a face that Plane cuts, in the order of regions.

colours(Plane, S, Colours) :-
    findall(R1-R2,
            ( region_neighbour(S, R1, R2, P), polygon_cut(Plane, S, P) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Neighbours),
    findall(R, region(S, R, _), Rs0),
    sort(Rs0, Rs),
    empty_assoc(Colours0),
    foldl(coloured(Neighbours), Rs, Colours0, Colours).

coloured(Neighbours, R, Colours0, Colours) :-
    findall(K,
            ( get_assoc(R, Neighbours, Others),
              member(Other, Others),
              get_assoc(Other, Colours0, K) ),
            Taken),
    between(1, inf, Colour),
    \+ memberchk(Colour, Taken),
    !,
    put_assoc(R, Colours0, Colour, Colours).

polygon_cut(Plane, S, P) :-
    p(S, P, Es),
    findall(H,
            ( member(E, Es), e(S, E, V, _, _), vertex_height(Plane, S, V, H) ),
            Hs),
    min_list(Hs, Least),
    max_list(Hs, Most),
    Least < 0,
    Most > 0.


                /*******************************
                *           SURFACES           *
                *******************************/

%   surface_cut(Plane, S, Name, N): S united with what is above the plane is
%   what is left of S, and the boundary of that, which goes.

surface_cut(plane(A,B,C,D), S, Name, N) :-
    segment_box(S, Box),
    maplist(turned, [A,B,C,D], Turned),
    Above =.. [plane|Turned],
    half_space(Above, Box, Half),
    half_boolean(Half, S, union, surface, Name, K, N),
    findall(P, from_p(N, P, K, _, _), Ps0),
    sort(Ps0, Ps),
    maplist(polygon_dropped(N), Ps),
    dropped(K).

turned(A, B) :-
    B is -A.

polygon_dropped(N, P) :-
    p(N, P, Es),
    retractall_facts(t(N, P, _, _, _, _)),
    retractall_facts(plane(N, P, _, _, _, _)),
    retractall_facts(from_p(N, P, _, _, _)),
    retractall_facts(p(N, P, _)),
    forall(member(E, Es), retractall_facts(e(N, E, _, _, _))).


                /*******************************
                *            CURVES            *
                *******************************/

%   curve_edge_cut(Plane, S, Edge): its part below the plane stays.

curve_edge_cut(Plane, S, edge(E,V1,V2,Et)) :-
    vertex_height(Plane, S, V1, H1),
    vertex_height(Plane, S, V2, H2),
    (   max(H1,H2) =< 0
    ->  true
    ;   retractall_facts(e(S, E, V1, V2, Et)),
        (   min(H1,H2) >= 0
        ->  true
        ;   crossing_vertex(S, V1-H1, V2-H2, V),
            (   H1 < 0
            ->  assert_fact(e(S, E, V1, V, Et))
            ;   assert_fact(e(S, E, V, V2, Et))
            )
        )
    ).

vertex_height(plane(A,B,C,D), S, V, H) :-
    v(S, V, X, Y, Z),
    H is A*rational(X) + B*rational(Y) + C*rational(Z) + D.

crossing_vertex(S, V1-H1, V2-H2, V) :-
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    At is H1/(H1-H2),
    maplist(on_the_way(At), [X1,Y1,Z1], [X2,Y2,Z2], [X,Y,Z]),
    fresh_id(v, S, V),
    assert_fact(v(S, V, X, Y, Z)).

on_the_way(At, A, B, X) :-
    X is float(rational(A) + At*(rational(B)-rational(A))) + 0.0.


                /*******************************
                *        WHAT IS SEEN          *
                *******************************/

%!  section_lines(+Section, +OperandLines, -Lines) is det.
%
%   Lines for with_operand_lines/2: those in the plane, which are drawn
%   however little the surface bends there, and what is left of OperandLines.

section_lines(section(Plane, Pieces), OperandLines, Lines) :-
    findall(Line, piece_line(Pieces, Plane, OperandLines, Line), Lines).

piece_line(Pieces, Plane, _, border(N, P, V1, V2, Q)) :-
    member(Piece, Pieces),
    Piece = piece(_, N, _, _),
    in_plane(Piece, Plane, E, V1, V2),
    edge_polygon(N, E, P),
    (   e(N, Twin, V2, V1, _),
        edge_polygon(N, Twin, Q0)
    ->  Q = Q0
    ;   Q = P
    ).
piece_line(Pieces, _, Lines, Line) :-
    member(Line, Lines),
    arg(1, Line, S),
    memberchk(piece(S, S, _, _), Pieces).
piece_line(Pieces, _, Lines, border(N, P, V1, V2, Q)) :-
    findall(S-(P0-Q0), member(border(S, P0, _, _, Q0), Lines), Pairs0),
    sort(Pairs0, Pairs),
    member(S-(P0-Q0), Pairs),
    member(piece(S, N, _, _), Pieces),
    N \== S,
    from_p(N, P, S, P0, _),
    from_p(N, Q, S, Q0, _),
    p(N, P, Es),
    member(E, Es),
    e(N, E, V1, V2, _),
    e(N, Twin, V2, V1, _),
    edge_polygon(N, Twin, Q).

%   in_plane(Piece, Plane, E, V1, V2): an edge in the plane: round the caps of
%   a solid, or where a surface ends.

in_plane(piece(_, N, Kind, Caps), _, E, V1, V2) :-
    ( Kind == solid ; Kind = cell(_) ),
    !,
    cap_border(N, Caps, E, V1, V2).
in_plane(piece(_, N, surface, _), Plane, E, V1, V2) :-
    segment_box(N, box(A,B,C,D,F,G)),
    tolerance(rounding, Of),
    Near is (D-A + F-B + G-C)*Of,
    findall(V, ( v(N, V, _, _, _),
                 vertex_height(Plane, N, V, H),
                 abs(H) < Near ),
            Vs0),
    sort(Vs0, Vs),
    member(V1, Vs),
    e(N, E, V1, V2, _),
    ord_memberchk(V2, Vs),
    \+ e(N, _, V2, V1, _).

%   cap_border(N, Caps, E, V1, V2): an edge of a cap, no cap being beyond it.

cap_border(N, Caps, E, V1, V2) :-
    member(P, Caps),
    p(N, P, Es),
    member(E, Es),
    e(N, E, V1, V2, _),
    \+ ( e(N, Twin, V2, V1, _),
         edge_polygon(N, Twin, Q),
         ord_memberchk(Q, Caps)
       ).

%!  section_edges(+Section, ?N, -Edges) is nondet.
%
%   Edges, ascending, of what is left, segment N, lie in the plane; of two
%   opposite ones both. Lines between caps of several segments, where they are
%   in each other, are among them.

section_edges(section(Plane, Pieces), N, Edges) :-
    member(Piece, Pieces),
    Piece = piece(_, N, _, _),
    findall(E, edge_in_plane(Piece, Plane, E), Edges0),
    sort(Edges0, Edges).

edge_in_plane(Piece, Plane, E) :-
    Piece = piece(_, N, _, _),
    in_plane(Piece, Plane, E0, V1, V2),
    (   E = E0
    ;   e(N, E, V2, V1, _)
    ).
edge_in_plane(piece(_, N, _, Caps), _, E) :-
    member(P, Caps),
    p(N, P, Es),
    member(E, Es).

%!  section_region(+Section, ?S, ?Cell, ?N, -Edges) is nondet.
%
%   Edges, V1-V2, go round the caps of what is left of solid S, which is
%   segment N, holes too. Cell is K of a cell(K), 0 of other solids.

section_region(section(_, Pieces), S, Cell, N, Edges) :-
    member(piece(S, N, Kind, Caps), Pieces),
    Caps \== [],
    (   Kind = cell(Cell0)
    ->  Cell = Cell0
    ;   Cell = 0
    ),
    findall(V1-V2, cap_border(N, Caps, _, V1, V2), Edges0),
    sort(Edges0, Edges).
