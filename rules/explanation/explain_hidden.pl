:- module(sg_explain_hidden,
          [ hidden_because/4            % ?What, +Wanted, +Options, -Because
          ]).
:- use_module('../penetration/contact', [edge_part/4]).
:- use_module('../picture/contour', [contour_ends/4, dividing_piece/3]).
:- use_module('../csg/csg_roots', [aside_segments/1]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module(explain_pair, [decided_by/2]).
:- use_module('../picture/hidden_lines',
              [ least_drawn/1, open_scene/2, may_hide/2, may_hide/4, lies_on/4,
                line_facing/7, line_parts/5, substitute_outline/2
              ]).
:- use_module('../interval',
              [intervals_union/3, intervals_subtract/3]).
:- use_module('../kernel',
              [scene_edge/5, occluder/7, overlap/9, line_covers/4]).
:- use_module('../picture/role',
              [ backs_seen/2, edge_role/5, look_part/3, role_drawn/2,
                usual_crease/1 ]).
:- use_module('../store',
              [ e/5, t/6, line/9, contour/13, screen/5, drawn/7, leaf_e/5,
                edge_polygon/3
              ]).
:- use_module('../picture/view', [screen_depth/1, screen_distance/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(dcg/basics), [integer//1]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).

/** <module> Explain: why a part of a line is hidden, or is not (PL-13).

The joins of hidden_lines.pl run again for the one line, in the picture that
screen/5 holds. What they say of triangles is said of polygons: the parts that
the triangles of one polygon hide are put together.

    line(Scene, S, E, Least, Size)
        the line; parts up to Least are not drawn; Size is the picture's unit
    cover(S2-P2, From, To, Behind1, Behind2)
        a triangle of polygon P2 of S2 lies on the line in the picture, from
        From to To; the line is so far behind it there, as line_covers/4 has it
    face(S2-P2, By, From, To)
        polygon P2 of S2 would hide the line from From to To; By: `hides`, or
        glass(Decision, File) where that lets it through
*/

%!  hidden_because(?What, +Wanted, +Options, -Because) is nondet.
%
%   True when Because is the list of because(Statement, Because) that says which
%   parts of the line What are hidden and which are not, and why. What is S-E,
%   an edge of a segment, or what a drawing calls it: `s1e7`, the second part of
%   it in a drawing `s1e7-2`. An edge that was divided gives an answer for each
%   part. Wanted is `all`, or `visible`: those parts alone. Options are those of
%   picture/1 that the picture was made with. Fails without a picture.

hidden_because(What, Wanted, Options0, [because(Line, Because)]) :-
    line_asked(What, S0, E0),
    \+ \+ screen(_, _, _, _, _),
    scene_options(Options0, Options),
    open_scene(Scene, Options),
    scene_line(Scene, S0, E0, S, E),
    line_statement(S, E, Line),
    line_because(Scene, S, E, Wanted, Options, Because0),
    copy_because(S0, E0, S, E, Copy),
    append(Copy, Because0, Because).

line_statement(S, E, Line) :-
    (   E > 0
    ->  once(e(S, E, V1, V2, _)),
        Line = hidden_line(S, E, V1, V2)
    ;   K is -E,
        contour(S, K, T, _, _, _, _, _, _, _, _, _, _),
        once(t(S, P, T, _, _, _)),
        Line = outline_piece(S, E, P, T)
    ).

copy_because(S, E, S, E, []) :-
    !.
copy_because(S, E0, S, E, [because(part_of(S, E0, V1, V2), [])]) :-
    edge_part(S, E, E0, V1-V2),
    !.
copy_because(S0, E0, S, E, [because(same_line(S0, E0, S, E), [])]).

scene_options(Options, Scene) :-
    (   \+ option(segments(_), Options),
        aside_segments([_|_])
    ->  findall(S, root_segment(S), Roots),
        Scene = [segments(Roots)|Options]
    ;   Scene = Options
    ).

line_asked(What, S, E) :-
    var(What),
    !,
    What = S-E.
line_asked(S-E, S, E) :-
    ( var(S) ; integer(S) ),
    !.
line_asked(Name, S, E) :-
    format(codes(Codes), '~w', [Name]),
    phrase(line_name(S, E), Codes, Rest),
    memberchk(Rest, [[], [0'-|_]]).

line_name(S, E) -->
    "s", integer(S), "e", integer(E).

%   scene_line(Scene, S0, E0, S, E): the edge that is drawn for E0: itself, its
%   twin, its copy in the other segment of a penetration line, or its parts.

scene_line(Scene, S0, E0, S, E) :-
    ( var(S0) ; var(E0) ),
    !,
    scene_edge(Scene, S0, E0, _, _),
    S = S0,
    E = E0.
scene_line(Scene, S, E, S, E) :-
    E < 0,
    !,
    once(scene_edge(Scene, S, E, _, _)).
scene_line(Scene, S, E0, S, E) :-
    \+ e(S, E0, _, _, _),
    !,
    leaf_e(S, E0, _, _, _),
    e(S, E, _, _, _),
    edge_part(S, E, E0, _),
    once(scene_edge(Scene, S, E, _, _)).
scene_line(Scene, S0, E0, S, E) :-
    once(( line_copy(S0, E0, S, E),
           scene_edge(Scene, S, E, _, _) )).

line_copy(S, E, S, E).
line_copy(S, E0, S, E) :-
    edge_ends(S, E0, V1, V2),
    edge_ends(S, E, V1, V2).
line_copy(S0, E0, S, E) :-
    edge_ends(S0, E0, V1, V2),
    (   line(_, S, _, W1, W2, S0, _, V1, V2)
    ;   line(_, S0, _, V1, V2, S, _, W1, W2)
    ),
    edge_ends(S, E, W1, W2).

edge_ends(S, E, V1, V2) :-
    e(S, E, V1, V2, _).
edge_ends(S, E, V1, V2) :-
    e(S, E, V2, V1, _).

/* - - - the whole line - - - */

line_because(Scene, S, E, Wanted, Options, Because) :-
    scene_edge(Scene, S, E, Length, Look),
    !,
    role_because(S, E, Look, Options, Role),
    least_drawn(Least0),
    (   Length =< Least0
    ->  Parts = [because(end_on, [])]
    ;   Least is Least0/Length,
        picture_length(S, E, PictureLength),
        Size is PictureLength/Length,
        Line = line(Scene, S, E, Least, Size),
        line_parts(Scene, S, E, Visible, Hidden),
        covers(Line, Covers),
        faces(Line, Faces),
        own_surface(S, E, Look, Back),
        findall(From-Part,
                part_because(Wanted, Line, Covers, Faces, Back,
                             Visible, Hidden, From-Part),
                Parts0),
        keysort(Parts0, Parts1),
        pairs_values(Parts1, Parts2),
        some_parts(Wanted, Visible, Parts2, Parts)
    ),
    findall(because(substitute_outline, []), substitute_outline(S, E), Alone),
    append([Role,Alone,Parts], Because).

%   some_parts(Wanted, Visible, Parts0, Parts): who asks why it is visible is
%   told where it is not.

some_parts(visible, [], [], Parts) =>
    Parts = [because(nowhere_visible, [])].
some_parts(_, _, Parts0, Parts) =>
    Parts = Parts0.

part_because(all, Line, Covers, Faces, Back, _, Hidden,
             From-because(hidden_part(From, To), Because)) :-
    member(From-To, Hidden),
    hiding_faces(Line, Covers, Faces, From-To, Hiding),
    append(Back, Hiding, Because).
part_because(_, Line, Covers, Faces, _, Visible, _,
             From-because(visible_part(From, To), Because)) :-
    member(From-To, Visible),
    faces_over(Line, Covers, Faces, From-To, Because).
part_because(all, Line, _, _, _, Visible, Hidden, Part) :-
    drawn_instead(Line, Visible, Hidden, Part).

%   role_because(S, E, Look, Options, Because): as what it is drawn.

role_because(S, E, _, _, [because(line_role(Role), [])]) :-
    drawn(_, S, E, _, _, _, Role),
    !.
role_because(S, E, Look, Options, [because(line_role(Role), Not)]) :-
    usual_crease(Usual),
    option(crease(Crease), Options, Usual),
    option(lines(Which), Options, feature),
    edge_role(S, E, Look, Crease, Role),
    (   role_drawn(Which, Role)
    ->  Not = []
    ;   findall(because(faces_bend(Bend), []),
                ( Role == mesh, look_part(bend, Look, Bend), Bend > 0.0 ),
                Bends),
        Not = [because(not_drawn(Role, Which), Bends)]
    ).

%   own_surface(S, E, Look, Because): step 2, its faces look away and their
%   solid is closed; a smooth surface that it lies on is turned away there; or
%   an outline inside triangles goes on behind its own fold.

own_surface(S, E, _, Because) :-
    E < 0,
    !,
    K is -E,
    findall(because(behind_fold(0.0), []),
            ( contour(S, K, _, _, _, _, _, hidden, _, _, _, _, _),
              may_hide(S, S) ),
            Because).
own_surface(S, E, Look, Because) :-
    findall(From-because(turned_away(S2, P, From, To), []),
            ( line_facing(S, E, S2, T, From, To, _), From < To, may_hide(S2, S),
              once(t(S2, P, T, _, _, _)) ),
            Keyed0),
    sort(Keyed0, Keyed),
    pairs_values(Keyed, Turned),
    (   backs_seen(Look, Away),
        may_hide(S, S)
    ->  Because = [because(backs(S, Away), [])|Turned]
    ;   Because = Turned
    ).

/* - - - what the joins say, by polygon - - - */

covers(line(Scene, S, E, _, _), Covers) :-
    line_covers(Scene, S, E, Covers0),
    maplist(cover, Covers0, Covers).

cover(covers(S, T, From, To, B1, B2), cover(S-P, From, To, B1, B2)) :-
    once(t(S, P, T, _, _, _)).

%   covered_parts(Line, Covers, Polygon, Parts): where Polygon lies on the line.

covered_parts(line(_, _, _, Least, _), Covers, Polygon, Parts) :-
    findall(From-To, member(cover(Polygon, From, To, _, _), Covers), Parts0),
    sort(Parts0, Parts1),
    intervals_union(Least, Parts1, Parts).

%   faces(Line, Faces): of those behind which the line is, the parts that each
%   would hide.

faces(line(Scene, S, E, Least, _), Faces) :-
    findall((Polygon-By)-(From-To),
            ( occluder(Scene, S, E, S2, T, From, To),
              once(t(S2, P2, T, _, _, _)),
              Polygon = S2-P2,
              verdict(S, E, S2, T, By) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(face(Polygon, By, From, To),
            ( member((Polygon-By)-Intervals, Groups),
              intervals_union(Least, Intervals, Union),
              member(From-To, Union) ),
            Faces).

verdict(S, E, S2, T, By) :-
    (   may_hide(S2, T, S, E)
    ->  By = hides
    ;   may_hide(S2, S)
    ->  decided_by(may_hide/4, File),
        By = glass(may_hide/4, File)
    ;   decided_by(may_hide/2, File),
        By = glass(may_hide/2, File)
    ).

%   hiding_faces(Line, Covers, Faces, Part, Because): nearest first.

hiding_faces(Line, Covers, Faces, Part, Because) :-
    findall(Depth-Statement,
            ( member(face(S-P, hides, From, To), Faces),
              common_part(Line, From-To, Part, _),
              face_depth(Line, Covers, S-P, From-To, Depth, Behind),
              face_hides(Line, Covers, S-P, From-To, Behind, Statement) ),
            Keyed0),
    keysort(Keyed0, Keyed),
    pairs_values(Keyed, Because).

%   face_hides(Line, Covers, Polygon, Part, Behind, Because): a substitute
%   outline is not drawn either where the polygon is near behind it.

face_hides(Line, Covers, S-P, From-To, Behind, Because) :-
    (   Behind < 0.0
    ->  Because = because(surface_goes_on(S, P, From, To), [])
    ;   face_ends(Line, Covers, S-P, From-To, Ends),
        Because = because(hiding_face(S, P, From, To, Behind), Ends)
    ).

%   face_depth(Line, Covers, Polygon, Part, Depth, Behind): in the middle of
%   Part the polygon is at Depth, and the line Behind it, in model units.

face_depth(Line, Covers, Polygon, From-To, Depth, Behind) :-
    Middle is (From+To)/2,
    member(cover(Polygon, From1, To1, B1, B2), Covers),
    From1 =< Middle,
    Middle =< To1,
    !,
    picture_point(Line, Middle, _, _, Z),
    B is B1 + (B2-B1)*(Middle-From1)/(To1-From1),
    screen_depth(Unit),
    FaceZ is Z - B/Unit,
    screen_distance(FaceZ, Depth),
    screen_distance(Z, LineDepth),
    Behind is LineDepth-Depth.

/* - - - what ends the part that a polygon hides - - - */

face_ends(Line, Covers, Polygon, From-To,
          [because(Begins, []), because(Ends, [])]) :-
    face_end(from, From, 0.0, Line, Covers, Polygon, Begins),
    face_end(to, To, 1.0, Line, Covers, Polygon, Ends).

%   face_end(Which, At, Limit, Line, Covers, Polygon, Statement): the line
%   itself ends there, or an edge of the polygon crosses it in the picture, or
%   else the line goes through the polygon.

face_end(Which, At, Limit, _, _, _, ends_with_line(Which, At)) :-
    At =:= Limit,
    !.
face_end(Which, At, _, Line, Covers, S-P, Statement) :-
    covered_parts(Line, Covers, S-P, Parts),
    member(From-To, Parts),
    cover_end(Which, From, To, End),
    Line = line(_, _, _, Least, _),
    abs(End-At) =< Least,
    !,
    picture_point(Line, At, X, Y, _),
    aggregate_all(min(Off, Crossed), crossed(S, P, X-Y, Off, Crossed),
                  min(_, Nearest)),
    (   Nearest = edge(E,V1,V2)
    ->  Statement = ends_at_edge(Which, At, S, E, V1, V2)
    ;   Nearest = outline(E)
    ->  Statement = ends_at_outline(Which, At, S, E)
    ).
face_end(Which, At, _, _, _, S-P, ends_in_face(Which, At, S, P)).

cover_end(from, From, _, From).
cover_end(to, _, To, To).

%   crossed(S, P, Place, Off, Crossed): an edge of P, straight or as the surface
%   runs, or a piece of an outline that divides a triangle of it, is Off from
%   Place in the picture.

crossed(S, P, Place, Off, edge(E,A,B)) :-
    edge_polygon(S, E, P),
    e(S, E, A, B, 1),
    screen(S, A, XA, YA, _),
    screen(S, B, XB, YB, _),
    stretch_distance(XA-YA, XB-YB, Place, Off).
crossed(S, P, Place, Off, edge(E,A,B)) :-
    risen_side(S, P, A, B, Start, End),
    edge_polygon(S, E, P),
    once(( e(S, E, A, B, 1) ; e(S, E, B, A, 1) )),
    stretch_distance(Start, End, Place, Off).
crossed(S, P, Place, Off, outline(E)) :-
    t(S, P, T, _, _, _),
    dividing_piece(S, T, K),
    E is -K,
    contour_ends(S, K, Start, End),
    stretch_distance(Start, End, Place, Off).

%   risen_side(S, P, A, B, Start, End): a half of the side A-B of a triangle of
%   P that an outline divides runs in the picture from Start to End, on the
%   surface.

risen_side(S, P, A, B, X-Y, End) :-
    t(S, P, T, V1, V2, V3),
    dividing_piece(S, T, K),
    contour(S, K, T, I1, _, I2, _, _, _, _, _, _, _),
    contour_ends(S, K, End1, End2),
    member(I-End, [I1-End1,I2-End2]),
    arg(I, t(V1,V2,V3), A),
    J is I mod 3 + 1,
    arg(J, t(V1,V2,V3), B),
    member(V, [A,B]),
    screen(S, V, X, Y, _).

stretch_distance(XA-YA, XB-YB, X-Y, Off) :-
    DX is XB-XA,
    DY is YB-YA,
    Square is DX*DX + DY*DY,
    Square > 0.0,
    At is max(0.0, min(1.0, ((X-XA)*DX + (Y-YA)*DY)/Square)),
    Off is sqrt((XA+At*DX-X)**2 + (YA+At*DY-Y)**2).

/* - - - what lies over a visible part - - - */

faces_over(Line, Covers, Faces, Part, Because) :-
    findall(Polygon, member(cover(Polygon, _, _, _, _), Covers), Polygons0),
    sort(Polygons0, Polygons),
    findall(Depth-because(Statement, []),
            ( member(Polygon, Polygons),
              polygon_over(Line, Covers, Faces, Polygon, Part, Depth,
                           Statement) ),
            Keyed0),
    sort(Keyed0, Keyed),
    pairs_values(Keyed, Over),
    (   member(because(Statement, _), Over),
        Statement \= line_in_face(_, _)
    ->  Because = Over
    ;   append(Over, [because(nothing_over, [])], Because)
    ).

polygon_over(Line, Covers, Faces, S-P, Part, Depth, Statement) :-
    covered_parts(Line, Covers, S-P, Parts),
    member(Whole, Parts),
    common_part(Line, Whole, Part, From-To),
    face_depth(Line, Covers, S-P, From-To, Depth, Behind),
    (   is_known_on(Line, S, P)
    ->  Statement = line_in_face(S, P)
    ;   member(face(S-P, glass(Decision,By), From1, To1), Faces),
        common_part(Line, From1-To1, From-To, _)
    ->  Statement = let_through(S, P, From, To, Decision, By)
    ;   Line = line(_, _, _, _, Size),
        least_drawn(Least0),
        Behind < -Least0*Size
    ->  Before is -Behind,
        Statement = face_behind(S, P, From, To, Before)
    ;   Statement = line_in_face(S, P)
    ).

%   is_known_on(Line, S, P): the line lies on P as the model says, or beside it
%   on a smooth surface; or it is an outline inside triangles that runs in P or
%   beside it.

is_known_on(line(_, S, E, _, _), S2, P) :-
    E > 0,
    lies_on(S, E, S2, P),
    !.
is_known_on(line(_, S, E, _, _), S2, P) :-
    E > 0,
    line_facing(S, E, S2, _, _, _, Ts),
    member(T, Ts),
    t(S2, P, T, _, _, _),
    !.
is_known_on(line(_, S, E, _, _), S, P) :-
    E < 0,
    K is -E,
    contour(S, K, T0, _, _, _, _, _, Ts, _, _, _, _),
    member(T, [T0|Ts]),
    t(S, P, T, _, _, _),
    !.

/* - - - what is drawn where the line is not - - - */

drawn_instead(line(Scene, S, E, Least, _), Visible, Hidden,
              From-because(drawn_instead(From, To, Visibility2, S2, E2, Role2),
                           [])) :-
    drawn(_, _, _, _, _, _, _),
    !,
    Line = line(Scene, S, E, Least, _),
    member(Visibility-Set, [visible-Visible,hidden-Hidden]),
    findall(A-B, drawn(_, S, E, A, B, Visibility, _), Drawn),
    foldl(subtracted, Drawn, Set, Rest),
    overlap(Scene, S, E, S2, E2, At, To0, At2, To2),
    drawn(_, S2, E2, A2, B2, Visibility2, Role2),
    mapped(A2, At2, To2, At, To0, A1),
    mapped(B2, At2, To2, At, To0, B1),
    msort([A1,B1], [Low,High]),
    member(Part, Rest),
    common_part(Line, Low-High, Part, From-To).

subtracted(Interval, Set0, Set) :-
    intervals_subtract(Set0, Interval, Set).

mapped(X, From2, To2, From, To, Y) :-
    Y is From + (X-From2)*(To-From)/(To2-From2).

/* - - - places on the line - - - */

%   common_part(Line, A, B, Common): longer than what is not drawn.

common_part(line(_, _, _, Least, _), A-B, C-D, From-To) :-
    From is max(A, C),
    To is min(B, D),
    To-From > Least.

%   picture_point(Line, At, X, Y, Z): where the line's point At is in the
%   picture.

picture_point(line(_, S, E, _, _), At, X, Y, Z) :-
    picture_ends(S, E, p(X1,Y1,Z1), p(X2,Y2,Z2)),
    X is X1 + At*(X2-X1),
    Y is Y1 + At*(Y2-Y1),
    Z is Z1 + At*(Z2-Z1).

picture_length(S, E, Length) :-
    picture_ends(S, E, p(X1,Y1,_), p(X2,Y2,_)),
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2).

picture_ends(S, E, p(X1,Y1,Z1), p(X2,Y2,Z2)) :-
    E < 0,
    !,
    K is -E,
    contour(S, K, T, I1, F1, I2, F2, _, _, _, _, _, _),
    once(contour_ends(S, K, X1-Y1, X2-Y2)),
    once(t(S, _, T, A, B, C)),
    side_depth(S, t(A,B,C,A), I1, F1, Z1),
    side_depth(S, t(A,B,C,A), I2, F2, Z2).
picture_ends(S, E, p(X1,Y1,Z1), p(X2,Y2,Z2)) :-
    once(e(S, E, V1, V2, _)),
    once(screen(S, V1, X1, Y1, Z1)),
    once(screen(S, V2, X2, Y2, Z2)).

%   side_depth(S, Corners, I, F, Z): as in contour/13, on the I-th side, F of
%   the way from its smaller vertex to the larger.

side_depth(S, Corners, I, F, Z) :-
    J is I+1,
    arg(I, Corners, V),
    arg(J, Corners, W),
    msort([V,W], [Low,High]),
    once(screen(S, Low, _, _, Z1)),
    once(screen(S, High, _, _, Z2)),
    Z is Z1 + F*(Z2-Z1).
