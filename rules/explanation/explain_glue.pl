:- module(sg_explain_glue,
          [ glued_because/3,            % ?S, ?Item, -Because
            region_because/3,           % ?S, ?R, -Because
            unglued_because/3           % +Facet1, +Facet2, -Because
          ]).
:- use_module('../csg/csg', [glue_operands/2, node/4]).
:- use_module('../gluing/cycle', [loop_cycle/4, radial_cycle/4, disk/4]).
:- use_module('../decision', [decision/4]).
:- use_module('../gluing/vertex_disk', [disk_relation/3]).
:- use_module('../gluing/region_name', [is_region_name/1, region_named/3]).
:- use_module('../gluing/region_point', [region_point/3]).
:- use_module('../kernel', [polygon_gap/4]).
:- use_module('../solid/glue', [glue_report/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, plane/6, segment/3, from_v/4, from_p/5,
                from_r/4, origin/3, gluing/2, region/3, sides/4, lies_in/3,
                edge_polygon/3 ]).
:- use_module(library(lists), [append/2, append/3, member/2, nth1/3]).
/** <module> Explain: what was glued, what a region is, and why two faces were
not glued (NG-1 to NG-7).
*/

%!  glued_because(?S, ?Item, -Because) is nondet.
%
%   True when Because says what was glued to Item, v(V), e(E) or p(P), of the
%   glue S. If Item is unbound: each polygon that several operands have.

glued_because(S, Item, [because(Statement, Because)]) :-
    segment(S, cells, _),
    node(S, glue, _, _),
    item_asked(S, Item),
    item_because(Item, S, Statement, Because).

item_asked(S, Item) :-
    var(Item),
    !,
    findall(P, ( from_p(S, P, S1, _, _), from_p(S, P, S2, _, _), S1 < S2 ),
            Ps0),
    sort(Ps0, Ps),
    member(P, Ps),
    Item = p(P).
item_asked(S, v(V)) :-
    v(S, V, _, _, _).
item_asked(S, e(E)) :-
    e(S, E, _, _, _).
item_asked(S, p(P)) :-
    p(S, P, _).

item_because(v(V), S, glued_vertex(S, V, Point), Because) :-
    Point = point(X,Y,Z),
    once(v(S, V, X, Y, Z)),
    operands_at(S, V, Operands),
    findall(because(was_vertex(S0, V0, Moved), []),
            ( vertex_source(S, V, Point, Operands, S0, V0),
              moved(S0, V0, Point, Moved) ),
            From0),
    sort(From0, From),
    findall(S0,
            ( member(S0, Operands),
              \+ memberchk(because(was_vertex(S0, _, _), []), From) ),
            Cut0),
    (   Cut0 == []
    ->  Cut = []
    ;   Cut = [because(cut_vertex(Cut0), [])]
    ),
    findall(because(point_loop(P), []), lies_in(S, v(V), p(P)), Loops),
    findall(because(in_region(R), []), lies_in(S, v(V), r(R)), Regions),
    findall(because(disk(D, Es, Ps), []),
            ( disk(S, V, D, Items),
              findall(E, member(e(E), Items), Es),
              findall(P, member(p(P), Items), Ps) ),
            Disks),
    findall(because(disks_lie(D1, D2, Relation, By), []),
            disks_lie(S, V, D1, D2, Relation, By), Lie),
    append([From, Cut, Loops, Regions, Disks, Lie], Because).
item_because(e(E), S, glued_edge(S, E, V1, V2), Because) :-
    once(e(S, E, V1, V2, _)),
    A is min(V1, V2),
    B is max(V1, V2),
    radial_cycle(S, A, B, Pages),
    findall(because(in_region(R), []),
            ( Pages == [], lies_in(S, e(E), r(R)) ),
            Wire),
    findall(because(page(P, R), Sources),
            ( member(page(P,_,R), Pages), polygon_sources(S, P, Sources) ),
            Round),
    append(Wire, Round, Because).
item_because(p(P), S, glued_polygon(S, P), Because) :-
    polygon_sources(S, P, Sources),
    findall(because(between(Below, Above), []), sides(S, P, Below, Above),
            Between),
    findall(because(inner_loop(Vs), []), inner_loop(S, P, Vs), Loops),
    append([Sources, Between, Loops], Because).

%   disks_lie(S, V, D1, D2, Relation, By) is nondet: how the disks at V lie to
%   each other, and who says so; of more than twenty this is not told.

disks_lie(S, V, D1, D2, Relation, By) :-
    findall(D, disk(S, V, D, _), Ds),
    \+ memberchk(21, Ds),
    decision(disk_relation/3, _, _, By),
    member(D1, Ds),
    member(D2, Ds),
    D1 < D2,
    once(disk_relation(disk(S,V,D1), disk(S,V,D2), Relation)).

moved(S0, V0, point(X,Y,Z), Moved) :-
    once(v(S0, V0, X0, Y0, Z0)),
    Moved is sqrt((X-X0)**2+(Y-Y0)**2+(Z-Z0)**2).

%   vertex_source(S, V, Point, Operands, S0, V0) is nondet: from_v/4 has one of
%   the vertices that became V; others are in just its place.

vertex_source(S, V, _, _, S0, V0) :-
    from_v(S, V, S0, V0).
vertex_source(_, _, point(X,Y,Z), Operands, S0, V0) :-
    member(S0, Operands),
    v(S0, V0, X, Y, Z).

%   operands_at(S, V, Ss): whose faces are round V, or have it inside.

operands_at(S, V, Ss) :-
    findall(S0,
            ( (   ( e(S, E, V, _, _) ; e(S, E, _, V, _) ),
                  edge_polygon(S, E, P)
              ;   lies_in(S, v(V), p(P))
              ),
              from_p(S, P, S0, _, _) ),
            Ss0),
    sort(Ss0, Ss).

polygon_sources(S, P, Sources) :-
    findall(because(was_polygon(S0, P0, Sense), []),
            from_p(S, P, S0, P0, Sense), Sources0),
    sort(Sources0, Sources).

%   inner_loop(S, P, Vs): a hole, a seam or a point loop.

inner_loop(S, P, Vs) :-
    loop_cycle(S, P, K, Vs),
    K > 1.

%!  region_because(?S, ?Region, -Because) is nondet.
%
%   True when Because says what Region of segment S is: a number, or a name as
%   of region_named/3.

region_because(S, Name, [because(Statement, Because)]) :-
    segment(S, _, _),
    once(region(S, _, _)),
    (   compound(Name)
    ->  is_region_name(Name),
        region_named(S, Name, R)
    ;   R = Name
    ),
    glue_report(S, Report),
    region(S, R, Role),
    nth1(R, Report.regions, Region),
    Statement = region(S, R, Role, Volume),
    (   Region.volume == null
    ->  Volume = none
    ;   Volume = Region.volume
    ),
    findall(because(inside(S0), []), from_r(S, R, S0, _), Inside),
    findall(because(inner_point(point(X,Y,Z)), []),
            ( Volume \== none, region_point(S, R, p(X,Y,Z)) ),
            Witness),
    findall(because(beyond(R1, Faces, Area), []),
            ( member(Pair, Report.neighbours),
              neighbour(Pair.regions, R, R1),
              Faces = Pair.faces,
              Area = Pair.area ),
            Beyond),
    findall(because(laminar(P), Sources),
            ( sides(S, P, R, R), polygon_sources(S, P, Sources) ),
            Laminar),
    findall(because(wire_in(E), []), lies_in(S, e(E), r(R)), Wires),
    append([Inside, Witness, Beyond, Laminar, Wires], Because).

neighbour([R,R1], R, R1).
neighbour([R1,R], R, R1).

%!  unglued_because(+Facet1, +Facet2, -Because) is nondet.
%
%   True when Because says why the polygons Facet1 and Facet2, S-P or S-p(P), of
%   two operands of a glue have no face in common; or what they have.

unglued_because(Facet1, Facet2, [because(Statement, Because)]) :-
    facet(Facet1, S1, P1),
    facet(Facet2, S2, P2),
    node(S, glue, _, _),
    glue_operands(S, Operands),
    memberchk(S1, Operands),
    memberchk(S2, Operands),
    once(p(S1, P1, _)),
    once(p(S2, P2, _)),
    !,
    findall(P,
            ( from_p(S, P, S1, P1, _), from_p(S, P, S2, P2, _) ),
            Ps0),
    sort(Ps0, Ps),
    (   Ps \== []
    ->  Statement = is_glued(S1, P1, S2, P2),
        findall(because(glued_polygon(S, P), Sources),
                ( member(P, Ps), polygon_sources(S, P, Sources) ),
                Because)
    ;   Statement = not_glued(S1, P1, S2, P2),
        findall(because(Fact, []), apart(S, S1-P1, S2-P2, Fact), Because)
    ).

facet(S-What, S, P) :-
    (   What = p(P)
    ->  true
    ;   P = What
    ),
    integer(S),
    integer(P).

%   apart(S, Facet1, Facet2, Fact) is nondet: how they lie.

apart(S, S1-P1, S2-P2, kept_apart(By)) :-
    from_p(S, P, S1, P1, _),
    from_p(S, Q, S2, P2, _),
    once(( origin(S, p(Q), slit(P)) ; origin(S, p(P), slit(Q)) )),
    !,
    (   gluing(S, Wish),
        Wish \= glued(_, _),
        Wish \= dissolve(_, _),
        Wish \= tolerance(_)
    ->  format(atom(By), '~q', [gluing(S, Wish)])
    ;   By = 'may_glue/3'
    ).

apart(S, S1-P1, S2-P2, in_common(Vs)) :-
    facet_vertices(S, S1, P1, Vs1),
    facet_vertices(S, S2, P2, Vs2),
    findall(V, ( member(V, Vs1), memberchk(V, Vs2) ), Vs),
    Vs \== [].
apart(_, Facet1, Facet2, gap(Gap, point(X1,Y1,Z1), point(X2,Y2,Z2))) :-
    polygon_gap(Facet1, Facet2, Gap, p(X1,Y1,Z1)-p(X2,Y2,Z2)).
apart(_, S1-P1, S2-P2, Fact) :-
    once(plane(S1, P1, A1, B1, C1, _)),
    once(plane(S2, P2, A2, B2, C2, _)),
    X is B1*C2-C1*B2,
    Y is C1*A2-A1*C2,
    Z is A1*B2-B1*A2,
    Sine is sqrt(X*X+Y*Y+Z*Z),
    Cosine is abs(A1*A2+B1*B2+C1*C2),
    Angle is atan2(Sine, Cosine)*180/pi,
    Fact = plane_angle(Angle).

facet_vertices(S, S0, P0, Vs) :-
    findall(V,
            ( from_p(S, P, S0, P0, _),
              loop_cycle(S, P, _, Loop),
              member(V, Loop) ),
            Vs0),
    sort(Vs0, Vs).
