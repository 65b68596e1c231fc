:- encoding(utf8).
/* True developments: rules/unrolling/true_development.pl and what it is made
of. */ 
% covers: primitive_round, true_layout, true_pattern, true_transition
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(primitive/primitive_face)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(unrolling/true_development)).
:- use_module(rules(unrolling/true_plate)).
:- use_module(rules(unrolling/true_rim)).
:- use_module(rules(development/development)).
:- use_module(rules(unrolling/true_words), [column_word/3]).
:- use_module(rules(unrolling/true_table)).

:- begin_tests(true_development).

%   in_scene(Terms, Goal): Goal in a world whose segments are the primitives.

:- meta_predicate in_scene(+, 0).

in_scene(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

%   developed(Term, Options, D, Goal): Goal with D the development of Term.

:- meta_predicate developed(+, +, -, 0).

developed(Term, Options, D, Goal) :-
    in_scene([Term], ( true_development(1, _, Options, D), Goal )).

size(D, Width, Height) :-
    findall(X, v(D, _, X, _, _), Xs),
    findall(Y, v(D, _, _, Y, _), Ys),
    max_list(Xs, X1),
    min_list(Xs, X0),
    max_list(Ys, Y1),
    min_list(Ys, Y0),
    Width is X1-X0,
    Height is Y1-Y0.

width(Term, Options, Width) :-
    developed(Term, Options, D, size(D, Width, _)).

seam_lefts(Term, Seam, Xs) :-
    developed(Term, [seam(Seam)], D, findall(X, v(D, _, X, _, _), Xs)).

near(X, Y) :-
    abs(X-Y) =< 1.0e-9*(1+abs(Y)).

area(D, Area) :-
    aggregate_all(sum(Part), triangle_area(D, Part), Area).

triangle_area(D, Area) :-
    t(D, _, _, A, B, C),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

%   outline_area(D, Area): the same by the edges of polygons.

outline_area(D, Area) :-
    aggregate_all(sum(Part),
                  ( p(D, _, Es), member(E, Es), e(D, E, A, B, _),
                    v(D, A, X1, Y1, _), v(D, B, X2, Y2, _),
                    Part is (X1*Y2 - X2*Y1)/2 ),
                  Area).

%   sound(D): polygons are divided wholly; each edge is in one polygon; folds
%   share their ends; every half of a joint is there.

sound(D) :-
    area(D, Area),
    outline_area(D, Outline),
    Area > 0,
    abs(Area-Outline) < 1.0e-9*Area,
    forall(( joint(D, _, E1, E2, Kind, _), memberchk(Kind, [fold,line]) ),
           ( e(D, E1, A, B, 1), e(D, E2, B, A, 1) )),
    forall(joint(D, _, E1, E2, seam, _),
           ( edge_length(D, E1, L1), edge_length(D, E2, L2), near(L1, L2) )),
    forall(p(D, P, _), piece(D, P, _)).

edge_length(D, E, Length) :-
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2).


% --- whole primitives

test(as_wide_as_pi_times_the_diameter, true(near(Width, 100*pi))) :-
    width(cylinder(radius(50), height(80), facets(24)), [], Width).
test(whatever_the_facets, true(near(Width, 100*pi))) :-
    width(cylinder(radius(50), height(80), facets(5)), [], Width).
test(whatever_the_placing, true(near(Width, 200*pi))) :-
    width(at([rotate(x,33),scale(2),translate(5,-6,700)],
             cylinder(radius(50), height(80), facets(7))), [], Width).
test(mirrored, true((near(Width, 100*pi), Signs == [1]))) :-
    developed(at([mirror(x)], cylinder(radius(50), height(80), facets(24))), [],
              D,
              ( size(D, Width, _),
                findall(Sign, ( triangle_area(D, A), Sign is integer(sign(A)) ),
                        Signs0),
                sort(Signs0, Signs) )).
test(rolled_of_plate, true(near(Width, pi*(100 + 2*0.5*4)))) :-
    width(cylinder(radius(50), height(80), facets(24)),
          [thickness(4),size(inside)], Width).
test(rolled_with_k_factor, true(near(Width, pi*(100 + 2*0.4*4)))) :-
    width(cylinder(radius(50), height(80), facets(24)),
          [thickness(4),size(inside),k_factor(0.4)], Width).
test(seam_turns, true(Xs1-Xs2 == Xs-Xs)) :-
    Pipe = cylinder(radius(50), height(80), facets(24)),
    maplist(seam_lefts(Pipe), [10, 3610, -350], [Xs,Xs1,Xs2]).
test(seam_far, true(near(Width, 100*pi))) :-
    width(cylinder(radius(50), height(80), facets(24)), [seam(1.0e300)],
          Width).
test(rolled_outside, true(near(Width, pi*(100 - 4)))) :-
    width(cylinder(radius(50), height(80), facets(24)),
          [thickness(4),size(outside)], Width).
test(rolled_middle, true(near(Width, pi*100))) :-
    width(cylinder(radius(50), height(80), facets(24)), [thickness(4)], Width).
test(inner_surface, true((near(Width, 40*pi), Area > 0))) :-
    in_scene([hollow_cylinder(radius(30), inner(20), height(40), facets(9))],
             ( true_development(1, inner, [], D),
               size(D, Width, _),
               area(D, Area) )).
test(sector_of_a_cone, true((near(R, 50), near(Angle, 216)))) :-
    developed(cone(radius(30), height(40), facets(12)), [], D,
              ( true_length_rows(D, Rows),
                last(Rows, row(1, _, Angle, R, 0.0, _, _, _, _)) )).
test(area_of_a_cone, true(abs(Area - pi*30*50) < 0.2)) :-
    developed(cone(radius(30), height(40), facets(12)), [chord(0.001)], D,
              area(D, Area)).
test(frustum, true((near(R1, 75), near(R2, 25)))) :-
    developed(cone(radius(45), top(15), height(40), facets(12)), [], D,
              ( true_length_rows(D, [row(1, _, _, R1, R2, L, _, _, _)|_]),
                near(L, 50) )).
%   The layer 1 outside a right cone of 3:4:5 unrolls to a ring: its generators
%   begin 4/3 from the middle.
test(plate_of_a_cone, true(abs(Area - Ring) < 0.05)) :-
    Ring is 0.6*pi*((50+4/3)**2 - (4/3)**2),
    developed(cone(radius(30), height(40), top(0.000001), facets(60)),
              [thickness(2),size(inside),chord(0.0001)], D,
              area(D, Area)).

whole(cylinder(radius(50), height(80), facets(24))).
whole(cylinder(radius(50,20), height(80), facets(24))).
whole(cylinder(radius(50), height(80), shift(30,20), facets(11))).
whole(cone(radius(30), height(40), facets(12))).
whole(cone(radius(30,20), height(40), facets(12))).
whole(cone(radius(30), height(40), shift(50,0), facets(12))).
whole(cone(radius(30), height(40), top(10), facets(12))).
whole(cone(radius(10), height(40), top(30), facets(12))).
whole(cone(radius(30), height(40), top(20,5), facets(12))).
whole(at([rotate(y,71)], cone(radius(30), height(40), top(20,5), facets(12)))).
whole(at([mirror(z)], cone(radius(30), height(40), top(20), shift(5,6)))).
whole(hollow_cylinder(radius(3), inner(2), height(4))).
whole(turning(outline([[1,0],[3,0],[2,4],[1,4]]), angle(200))).

test(sound, [forall(whole(Term))]) :-
    developed(Term, [], D, sound(D)).
test(seam_in_a_facet, [forall(( whole(Term), \+ transition(Term),
                                Term \= turning(_, _) ))]) :-
    developed(Term, [seam(40.7)], D,
              ( sound(D),
                once(from_p(D, _, 1, _, 1)) )).

transition(cone(_, _, top(_,_), _)).
transition(at(_, Term)) :-
    transition(Term).

%   Facets come to the true development when they get finer.
test(facets_come_near, [forall(member(Term-Facets,
          [ cylinder(radius(5,2), height(8), shift(3,2))-40,
            cone(radius(5,2), height(8), shift(3,2))-40 ]))]) :-
    solid_area(Term, Facets, A1),
    F2 is 2*Facets,
    solid_area(Term, F2, A2),
    Term =.. [Name|Arguments],
    True =.. [Name,facets(40)|Arguments],
    developed(True, [chord(1.0e-6)], D, area(D, Area)),
    Ratio is (Area-A1)/(Area-A2),
    abs(Ratio-4) < 0.1.

solid_area(Term0, N, Area) :-
    Term0 =.. [Name|Arguments],
    Term =.. [Name,facets(N)|Arguments],
    in_scene([Term],
             aggregate_all(sum(A),
                           ( face_of(1, P, curved(_, _)),
                             space_triangle(1, P, A) ),
                           Area)).

space_triangle(S, P, Area) :-
    t(S, P, _, A, B, C),
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    v(S, C, X3, Y3, Z3),
    X is (Y2-Y1)*(Z3-Z1) - (Z2-Z1)*(Y3-Y1),
    Y is (Z2-Z1)*(X3-X1) - (X2-X1)*(Z3-Z1),
    Z is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1),
    Area is sqrt(X*X + Y*Y + Z*Z)/2.

test(chords_within_the_tolerance, [forall(member(Chord, [1, 0.1, 0.01]))]) :-
    developed(cone(radius(30), height(40), facets(6)), [chord(Chord)], D,
              ( aggregate_all(max(Off), arc_chord_off(D, 50, Off), Most),
                Most =< Chord*1.3 )).

%   How far the middle of a border edge at distance R from the apex is off it.
arc_chord_off(D, R, Off) :-
    apex(D, X0, Y0),
    e(D, E, A, B, 1),
    \+ joint(D, _, E, _, _, _),
    \+ joint(D, _, _, E, _, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    X is (X1+X2)/2 - X0,
    Y is (Y1+Y2)/2 - Y0,
    Off is abs(R - sqrt(X*X + Y*Y)).

apex(D, X, Y) :-
    from_v(D, W, 1, 7),
    v(D, W, X, Y, _),
    !.

test(ids, true(Ps-Es == Ps0-Es0)) :-
    in_scene([cylinder(radius(5), height(8), facets(6))],
             ( true_development(1, side, [generators(5)], D),
               findall(P, p(D, P, _), Ps),
               findall(P, between(3, 8, P), Ps0),
               findall(E, e(D, E, _, _, 1), Es1),
               msort(Es1, Es),
               findall(E, ( p(1, P, List), P > 2, member(E, List) ), Es2),
               msort(Es2, Es0) )).
test(replaced, true(D1-Count == D2-1)) :-
    in_scene([cylinder(radius(5), height(8), facets(6))],
             ( true_development(1, side, [], D1),
               true_development(1, side, [seam(30)], D2),
               aggregate_all(count, segment(_, pattern, _), Count) )).
test(one_transaction, true(Count == 0)) :-
    in_scene([cylinder(radius(5), height(8), facets(6))],
             ( true_development(1, side, [], _),
               facts_undo,
               aggregate_all(count, segment(_, pattern, _), Count) )).

% --- seam, halves, generators

test(seam_at_the_shortest, true(near(Degrees, 180))) :-
    developed(cone(radius(30), height(40), shift(-20,0), facets(12)), [], D,
              true_length_rows(D, [row(1, Degrees, _, _, _, _, _, _, _)|_])).
test(seam_where_wanted, true(near(Degrees, 77.5))) :-
    developed(cone(radius(30), height(40), shift(-20,0), facets(12)),
              [seam(77.5)], D,
              true_length_rows(D, [row(1, Degrees, _, _, _, _, _, _, _)|_])).
test(half, true((near(Width, 50*pi), Numbers == [1,2,3,4,5,6,7]))) :-
    developed(cylinder(radius(50), height(80), facets(25)),
              [half(true),generators(12)], D,
              ( sound(D),
                size(D, Width, _),
                findall(N, generator_mark(D, N, _, _), Numbers) )).
test(half_of_an_oblique_cone) :-
    developed(cone(radius(30), height(40), shift(-20,0), facets(12)),
              [half(true)], D, sound(D)).
test(no_half, error(geometry_error(true(not_symmetric(1, side))), _)) :-
    developed(cone(radius(30), height(40), shift(-20,0), facets(12)),
              [half(true),seam(30)], _, true).
test(numbers, true(Numbers == [1,2,3,4,5,6,7,8,1])) :-
    developed(cylinder(radius(50), height(80), facets(24)), [generators(8)], D,
              findall(N, generator_mark(D, N, _, _), Numbers)).
test(generators_are_true, true) :-
    developed(cylinder(radius(50,20), height(80), shift(9,4), facets(24)),
              [generators(7)], D,
              forall(( true_length_rows(D, Rows),
                       member(row(_, _, _, From, To, Length, _, _, _), Rows) ),
                     ( near(Length, sqrt(80*80 + 9*9 + 4*4)),
                       near(To-From, Length) ))).

% --- transitions

test(transition_true_lengths) :-
    Term = cone(radius(30), height(40), top(20,5), facets(12)),
    developed(Term, [], D,
              forall(( e(D, E, _, _, 1), e(1, E, _, _, _) ),
                     ( edge_length(D, E, L), space_length(1, E, L0),
                       near(L, L0) ))).
test(transition_rows, true(Count == 13)) :-
    developed(cone(radius(30), height(40), top(20,5), facets(12)), [], D,
              ( true_length_rows(D, Rows), length(Rows, Count) )).
test(transition_generators,
     error(geometry_error(true(flat_part(1, side, generators))), _)) :-
    developed(cone(radius(30), height(40), top(20,5)), [generators(8)], _,
              true).
test(transition_seam,
     error(geometry_error(true(flat_part(1, side, seam))), _)) :-
    developed(cone(radius(30), height(40), top(20,5), facets(12)), [seam(31)],
              _, true).

space_length(S, E, Length) :-
    e(S, E, A, B, _),
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

% --- saddles

%   A branch of radius B at Angle to the header (radius H, along z), its axis
%   Offset from that of the header: the closed form of where its generator at T
%   meets the header, along its axis from the plane through its base.

saddle_scene(H, B, Angle, Offset, N1, N2,
             [ cylinder(radius(H), height(600), facets(N1)),
               at([rotate(x,Angle),translate(Offset,0,300)],
                  cylinder(radius(B), height(300), facets(N2)))
             ]).

%   A point of the branch: x = Offset + B*cos(T), and along (0,-sin,cos) of
%   Angle and (0,cos,sin): x^2 + y^2 = H^2, y = B*sin(T)*cos(A) - L*sin(A).

saddle(H, B, Angle, Offset, Degrees, L) :-
    A is Angle*pi/180,
    T is Degrees*pi/180,
    X is Offset + B*cos(T),
    L is (B*sin(T)*cos(A) + sqrt(H*H - X*X))/sin(A).

test(saddle, [forall(member(saddle(H, B, Angle, Offset, N1, N2),
        [ saddle(50, 30, 90, 0, 48, 32), saddle(50, 30, 60, 0, 24, 16),
          saddle(50, 30, 60, 10, 48, 32), saddle(50, 10, 35, 25, 36, 20),
          saddle(50, 49, 90, 0, 60, 40),
          saddle(50, 20, 120, -12, 30, 20) ]))]) :-
    saddle_scene(H, B, Angle, Offset, N1, N2, Terms),
    in_scene(Terms,
             ( trimmed(2, [1], outside, T),
               true_development(T, 2/side, [], D),
               sound(D),
               true_length_rows(D, Rows),
               forall(member(Row, Rows),
                      saddle_row(H, B, Angle, Offset, Row)) )).

saddle_row(H, B, Angle, Offset,
           row(_, Degrees, _, _, _, Length, _, _, _)) :-
    saddle(H, B, Angle, Offset, Degrees, L),
    abs(Length - (300-L)) < 1.0e-9*300.

test(saddle_between_facets) :-
    saddle_scene(50, 30, 60, 10, 48, 32, Terms),
    in_scene(Terms,
             ( trimmed(2, [1], outside, T),
               true_development(T, _, [generators(25),seam(3)], D),
               sound(D),
               true_length_rows(D, Rows),
               forall(member(Row, Rows),
                      saddle_row(50, 30, 60, 10, Row)) )).
test(hole, true(abs(Low-High) > 1)) :-
    saddle_scene(50, 30, 60, 0, 48, 32, Terms),
    in_scene(Terms,
             ( trimmed(1, [2], outside, T),
               true_development(T, 1/side, [seam(90),generators(16)], D),
               sound(D),
               findall(L, ( true_length_rows(D, Rows),
                            member(row(_, _, _, _, _, L, _, _, _), Rows) ), Ls),
               min_list(Ls, Low),
               max_list(Ls, High) )).

%   Every vertex of the hole's border lies on the branch.
test(hole_is_on_the_branch) :-
    saddle_scene(50, 30, 60, 10, 48, 32, Terms),
    in_scene(Terms,
             ( trimmed(1, [2], outside, T),
               true_development(T, 1/side, [seam(90),chord(0.01)], D),
               size(D, Width, _),
               forall(( border_point(D, X, Y), Y > 1, Y < 599 ),
                      on_branch(Width, X, Y)) )).

border_point(D, X, Y) :-
    e(D, E, A, _, 1),
    \+ joint(D, _, E, _, _, _),
    \+ joint(D, _, _, E, _, _),
    v(D, A, X, Y, _).

on_branch(Width, X, Y) :-
    T is 2*pi*X/Width + pi/2,
    PX is 50*cos(T) - 10,
    PY is 50*sin(T),
    PZ is Y - 300,
    % across the axis (0, -sin 60, cos 60)
    Across is PY*0.5 + PZ*sqrt(3)/2,
    abs(sqrt(PX*PX + Across*Across) - 30) < 1.0e-8.

%   Few facets: the line goes past generators that their line missed.
test(tips, [forall(member(saddle(H, B, Angle, Offset, N1, N2),
        [ saddle(50, 35.76, 77.3, -11.44, 10, 37),
          saddle(50, 26, 77, -18.6, 8, 61), saddle(50, 36.3, 60, -9, 177, 10),
          saddle(50, 20, 51, -5, 200, 7), saddle(50, 44, 80, 0, 13, 13) ]))]) :-
    saddle_scene(H, B, Angle, Offset, N1, N2, Terms),
    in_scene(Terms,
             forall(member(S-Others, [1-[2],2-[1]]),
                    ( trimmed(S, Others, outside, T),
                      true_development(T, S/side, [], D),
                      sound(D) ))).

%   Within the polygons, not trimmed: the line is there twice, once each way.
test(lines_within) :-
    saddle_scene(50, 30, 60, 0, 24, 16, Terms),
    in_scene(Terms,
             ( penetrate,
               true_development(2, side, [], D),
               sound(D),
               once(joint(D, _, _, _, line, _)) )).

% --- plates that meet

test(set_on, true((near(Width, 56*pi)))) :-
    saddle_scene(50, 30, 60, 10, 48, 32, Terms),
    in_scene(Terms,
             ( plate_parts(2, [1], [thickness(4),size(outside)], Options,
                           S-Others),
               complete_segments,
               trimmed(S, Others, outside, T),
               true_development(T, _, Options, D),
               sound(D),
               size(D, Width, _),
               true_length_rows(D, Rows),
               forall(member(Row, Rows), saddle_row(50, 26, 60, 10, Row)) )).
test(set_in, true((near(Width, 56*pi)))) :-
    saddle_scene(50, 30, 60, 10, 48, 32, Terms),
    in_scene(Terms,
             ( plate_parts(2, [1],
                           [thickness(4),size(outside),set_in(true),
                            other_thickness(6)],
                           Options, S-Others),
               complete_segments,
               trimmed(S, Others, outside, T),
               true_development(T, _, Options, D),
               size(D, Width, _),
               true_length_rows(D, Rows),
               forall(member(Row, Rows), saddle_row(44, 30, 60, 10, Row)) )).
test(no_offset, error(geometry_error(true(no_offset(1))), _)) :-
    in_scene([ cone(radius(50), top(40,20), height(600), facets(24)),
               cylinder(radius(5), height(600), facets(24)) ],
             plate_parts(2, [1], [thickness(4),size(inside)], _, _)).
test(no_offset_of_a_copy, error(geometry_error(true(no_offset(3))), _)) :-
    in_scene([ at([scale(2,1,1)], torus(radius(30), tube(4))),
               cylinder(radius(5), height(60), facets(24)) ],
             ( assert_fact(segment(3, solid, at([rotate(x, 90)], 1))),
               evaluate,
               plate_parts(2, [3], [thickness(1),size(inside)], _, _) )).

% --- the table

test(csv, true(Lines == ["number,parameter (degrees),arc (mm),from (mm),\c
                          to (mm),length (mm),step from (mm),step to (mm),\c
                          diagonal (mm)",
                         "1,0.00,0.00,0.00,8.00,8.00,15.71,15.71,17.63",
                         "2,180.00,15.71,0.00,8.00,8.00,15.71,15.71,17.63",
                         "1,0.00,31.42,0.00,8.00,8.00,,,"])) :-
    tmp_file_stream(text, File, Stream),
    close(Stream),
    call_cleanup(
        ( developed(cylinder(radius(5), height(8), facets(6)), [generators(2)],
                    D, write_true_lengths(D, File, [decimals(2)])),
          read_file_to_string(File, Text, []),
          split_string(Text, "\n", "", Lines0),
          once(append(Lines, [""], Lines0)) ),
        delete_file(File)).
% A file is data: its columns do not follow the language.
test(csv_is_data, true(Columns == ["number","parameter (degrees)","arc (mm)",
                                  "from (mm)","to (mm)","length (mm)",
                                  "step from (mm)","step to (mm)",
                                  "diagonal (mm)"])) :-
    current_prolog_flag(message_language, Before),
    tmp_file_stream(text, File, Stream),
    close(Stream),
    setup_call_cleanup(
        set_prolog_flag(message_language, ko),
        developed(cylinder(radius(5), height(8), facets(6)), [generators(2)],
                  D, write_true_lengths(D, File)),
        set_prolog_flag(message_language, Before)),
    read_file_to_string(File, Text, [encoding(utf8)]),
    delete_file(File),
    split_string(Text, "\n", "", [First|_]),
    split_string(First, ",", "", Columns).
% Every column of every kind of surface has a name in both languages.
test(columns_in_both_languages, true(Ones == Others)) :-
    findall(Column, column_word(Column, en, _), Ones),
    findall(Column, column_word(Column, ko, _), Others).
test(table_on_a_sheet, true(Texts == 33)) :-
    developed(cylinder(radius(5), height(8), facets(6)), [generators(2)], D,
              ( true_length_marks(D, [height(3)], Marks, Width-Height),
                Height =:= 4*6.0,
                forall(member(text(X, Y, 3, _), Marks),
                       ( X > 0, X < Width, Y > 0, Y < Height )),
                aggregate_all(count, member(text(_, _, _, _), Marks), Texts) )).

% --- rims of flat ends

test(rims, true((abs(Area - 2*pi*25) < 0.01, near(Most, 5)))) :-
    in_scene([cylinder(radius(5), height(8), facets(6))],
             ( numlist(3, 8, Sides),
               develop(1, [removed(Sides)], D),
               rims_rounded(D, 1, [chord(0.0001)]),
               sound_areas(D),
               area(D, Area),
               findall(R, rim_radius(D, R), Rs),
               max_list(Rs, Most),
               min_list(Rs, Least),
               near(Least, 5) )).

%   Which end of a part is the lower one, and which way its axes are turned,
%   makes no difference.

test(rims_of_turned, [ forall(turned_pair(Term1, Term2)),
                       true(near(Area1, Area2)) ]) :-
    ends_area(Term1, Area1),
    ends_area(Term2, Area2).

turned_pair(cone(radius(A), top(B), height(H), facets(7)),
            cone(radius(B), top(A), height(H), facets(7))) :-
    random_sizes([A,B,H]).
turned_pair(cone(radius(A,B), top(C,D), height(H), facets(9)),
            cone(radius(C,D), top(A,B), height(H), facets(9))) :-
    random_sizes([A,B,C,D,H]).
turned_pair(at([scale(1,K,1)],
               cone(radius(A), top(B), height(H), facets(12))),
            at([scale(K,1,1)],
               cone(radius(A), top(B), height(H), facets(12)))) :-
    random_sizes([A,B,H,K]).
turned_pair(at([scale(1,K,1)], cylinder(radius(A), height(H), facets(12))),
            at([scale(K,1,1)], cylinder(radius(A), height(H), facets(12)))) :-
    random_sizes([A,H,K]).

random_sizes(Sizes) :-
    set_random(seed(51)),
    between(1, 8, _),
    maplist(random_size, Sizes).

random_size(Size) :-
    random(X),
    Size is 0.5+5*X.

ends_area(Term, Area) :-
    in_scene([Term],
             ( findall(P, ( p(1, P, Es), length(Es, 4) ), Sides),
               develop(1, [removed(Sides)], D),
               rims_rounded(D, 1, []),
               sound_areas(D),
               area(D, Area) )).

sound_areas(D) :-
    area(D, Area),
    outline_area(D, Outline),
    abs(Area-Outline) < 1.0e-9*Area.

%   From the middle of a hexagon's opposite corners.
rim_radius(D, R) :-
    p(D, P, Es),
    findall(X-Y, ( from_v(D, W, 1, _), e(D, E, W, _, _), memberchk(E, Es),
                   v(D, W, X, Y, _) ), Corners),
    findall(X, member(X-_, Corners), Xs),
    findall(Y, member(_-Y, Corners), Ys),
    sum_list(Xs, SX),
    sum_list(Ys, SY),
    CX is SX/6,
    CY is SY/6,
    p(D, P, Es1),
    member(E1, Es1),
    e(D, E1, W1, _, _),
    v(D, W1, X1, Y1, _),
    R is sqrt((X1-CX)**2 + (Y1-CY)**2).

% --- what cannot be

test(no_segment, error(existence_error(segment, 3), _)) :-
    in_scene([box(size(1,1,1))], true_development(3, _, [], _)).
test(no_part, error(geometry_error(true(no_part(1, _))), _)) :-
    in_scene([box(size(1,1,1))], true_development(1, _, [], _)).
test(no_chord, error(domain_error(chord, 0), _)) :-
    developed(cylinder(radius(1), height(1)), [chord(0)], _, true).
test(no_such_part, error(geometry_error(true(no_part(1, lid))), _)) :-
    in_scene([cylinder(radius(1), height(1))],
             true_development(1, lid, [], _)).

:- end_tests(true_development).
