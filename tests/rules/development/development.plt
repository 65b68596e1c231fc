/* Developments: rules/development/development.pl and its kernels. */
:- module(test_development, []).
:- use_module(library(aggregate)).
% covers: primitive_globe
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(rules(decision), [use_rules/1]).
:- use_module(rules(csg/csg), [root_segment/1]).
:- use_module(rules(csg/csg_roots), [roots_alone/0]).
:- use_module(rules(development/development)).
:- use_module(rules(message/development_en)).
:- use_module(rules(message/development_ko)).
:- use_module(rules(development/development_record)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(model/mesh)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/view), [set_view/3]).
:- use_module(tests('rules/random_solid')).
:- use_module(rules(kernel)).
:- use_module(rules(development/polygon_name)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).
user:message_hook(sanggwan(development(_, in_triangles(_))), warning, _).

%   What was told of borders.

:- dynamic told/2.

user:message_hook(sanggwan(development(_, border(Kind, Sides))), warning, _) :-
    findall(P, member(side(_, P, _), Sides), Ps),
    assertz(test_development:told(Kind, Ps)).

%   in_model(+Terms, :Goal): in a world of its own, of these primitives.

:- meta_predicate in_model(+, 0).

in_model(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

%   folded_square(+E, +P): a square that is folded along its diagonal, polygon
%   P, with edges from E on.

folded_square(E, P) :-
    assert_fact(segment(1, surface, folded)),
    forall(nth1(V, [0.0-0.0-0.0,1.0-0.0-0.0,1.0-1.0-0.5,0.0-1.0-0.0], X-Y-Z),
           assert_fact(v(1, V, X, Y, Z))),
    findall(Edge,
            ( between(1, 4, A),
              B is A mod 4 + 1,
              Edge is E+A-1,
              assert_fact(e(1, Edge, A, B, 1))
            ),
            Edges),
    assert_fact(p(1, P, Edges)).

%   shared_edges: two triangles that have the same half-edges, which is a fault.

shared_edges :-
    assert_fact(segment(1, surface, shared)),
    forall(nth1(V, [0.0-0.0,1.0-0.0,0.0-1.0], X-Y),
           assert_fact(v(1, V, X, Y, 0.0))),
    forall(( between(1, 3, E), B is E mod 3 + 1 ),
           assert_fact(e(1, E, E, B, 1))),
    forall(between(1, 2, P), assert_fact(p(1, P, [1,2,3]))).

%   seam_of(+D, -Length): all seams, each once.

seam_of(D, Length) :-
    findall(L, ( joint(D, _, E, _, seam, _), edge_length(D, E, L) ), Ls),
    sum_list(Ls, Length).

edge_length(S, E, Length) :-
    e(S, E, A, B, _),
    distance(S, A, B, Length).

distance(S, A, B, Length) :-
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2).

pieces_of(D, Pieces) :-
    aggregate_all(max(K), piece(D, _, K), Pieces).

%   What holds of every pattern D of S.

sound(S, D) :-
    congruent(S, D),
    folds_share(D),
    partners_agree(S, D),
    faces_up(D),
    apart(D).

congruent(S, D) :-
    forall(p(D, P, Es),
           ( all_vertices(D, Es, Vs),
             forall(( member(A, Vs), member(B, Vs), A < B ),
                    ( from_v(D, A, S, A0),
                      from_v(D, B, S, B0),
                      distance(S, A0, B0, L0),
                      distance(D, A, B, L),
                      must_be_near(L0, L, P) )) )).

must_be_near(A, B, What) :-
    (   abs(A-B) < 1.0e-12*(1+abs(A))
    ->  true
    ;   throw(differ(A, B, What))
    ).

all_vertices(S, Es, Vs) :-
    findall(V, ( member(E, Es), e(S, E, A, B, _), member(V, [A,B]) ), Vs0),
    sort(Vs0, Vs).

folds_share(D) :-
    forall(( joint(D, _, E1, E2, Kind, _), Kind \== seam ),
           ( e(D, E1, A, B, _), e(D, E2, B, A, _) )).

partners_agree(S, D) :-
    forall(joint(D, _, E1, E2, _, _),
           ( e(D, E1, A1, B1, _), e(D, E2, A2, B2, _),
             from_v(D, A1, S, A), from_v(D, B2, S, A),
             from_v(D, B1, S, B), from_v(D, A2, S, B) )).

faces_up(D) :-
    forall(t(D, _, T, A, B, C),
           ( corner(D, A, X1, Y1), corner(D, B, X2, Y2), corner(D, C, X3, Y3),
             Area is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1),
             ( Area > -1.0e-12 -> true ; throw(turned_over(T)) ) )).

corner(D, V, X, Y) :-
    v(D, V, X, Y, 0.0).

%   No two triangles overlap deeper than 1e-9.

apart(D) :-
    findall(T-[X1-Y1,X2-Y2,X3-Y3],
            ( t(D, _, T, A, B, C),
              corner(D, A, X1, Y1), corner(D, B, X2, Y2), corner(D, C, X3, Y3)
            ),
            Ts),
    forall(( member(T1-C1, Ts), member(T2-C2, Ts), T1 < T2 ),
           ( parted(C1, C2) -> true
           ; parted(C2, C1) -> true
           ; throw(overlap(T1, T2)) )).

parted([A,B,C], Others) :-
    member(P-Q, [A-B,B-C,C-A]),
    P = X1-Y1, Q = X2-Y2,
    Size is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    \+ ( member(X-Y, Others),
         ((X2-X1)*(Y-Y1) - (Y2-Y1)*(X-X1)) / max(Size, 1.0e-300) > 1.0e-9 ),
    !.

:- begin_tests(development).

% However a part lies in space, its pattern lies along the sheet.
test(along_the_sheet,
     forall(( member(Term-W-H, [ rectangle(size(7,2))-7-2,
                                 rectangle(size(2,7))-7-2,
                                 box(size(7,2,1))-9-6 ]),
              member(Degrees, [0,17,40,90,133]) ))) :-
    new_world(World),
    in_world(World,
             ( add_primitive(at([rotate(axis(1,2,3),Degrees)], Term), _),
               complete_segments,
               develop(1, [], D),
               findall(X, v(D, _, X, _, _), Xs),
               findall(Y, v(D, _, _, Y, _), Ys) )),
    maplist(min_list, [Xs,Ys], [X0,Y0]),
    maplist(max_list, [Xs,Ys], [X1,Y1]),
    abs(X1-X0-W) < 1.0e-9,
    abs(Y1-Y0-H) < 1.0e-9.

%   The seam is that of the vertex minimum spanning tree, and one piece.

least(box(size(1,1,1)), 7.0).
least(box(size(1,2,3)), 11.0).

test(least, [forall(least(Term, Least)), Pieces-Near =@= 1-true]) :-
    in_model([Term], ( develop(1, D), sound(1, D), seam_of(D, Length),
                       pieces_of(D, Pieces) )),
    ( abs(Length-Least) < 1.0e-9 -> Near = true ; Near = Length ).

test(again, D1-Rows1 == D2-Rows2) :-
    in_model([box(size(1,2,3))],
             ( develop(1, D1), rows(D1, Rows1),
               develop(1, D2), rows(D2, Rows2) )).

rows(D, Rows) :-
    findall(v(V,X,Y), v(D, V, X, Y, _), Vs),
    findall(j(J,E1,E2,K,A), joint(D, J, E1, E2, K, A), Js),
    findall(P-K, piece(D, P, K), Ps),
    append([Vs,Js,Ps], Rows).

test(kernel_is_rule, forall(solid(Term))) :-
    in_model([Term], states([F]>>join_all(F, 0), Kernel)),
    in_model([Term], states(joined_by_rule(1), Rule)),
    assertion(Kernel == Rule).

%   What is joined stays so: a face would hang on nothing.

test(not_forbidden_when_joined,
     error(permission_error(forbid, joint, 1))) :-
    in_model([box(size(1,1,1))], states(joined_and_forbidden, _)).

joined_and_forbidden(Flattening) :-
    join_faces(Flattening, 1, joined),
    forbid_joint(Flattening, 1).

states(Goal, States) :-
    setup_call_cleanup(
        flattening_open(1, 1.0e-10, [], Flattening),
        ( call(Goal, Flattening),
          findall(J-State,
                  ( flattening_counts(Flattening, _, Count, _),
                    between(1, Count, J),
                    flattening_joint(Flattening, J, Joint),
                    Joint = joint(_,_,_,_,_,_,_,Kind,State),
                    Kind \== line
                  ),
                  States)
        ),
        flattening_close(Flattening)).

solid(box(size(1,1,1))).
solid(cylinder(radius(1), height(2), facets(40))).
solid(cone(radius(1), height(2), facets(24))).
solid(sphere(radius(1), facets(16))).
solid(torus(radius(2), tube(0.7), facets(12))).

test(sound, forall(solid(Term))) :-
    in_model([Term], ( develop(1, D), sound(1, D) )).

test(cut) :-
    in_model([box(size(1,1,1))],
             ( develop(1, [cut([1,2,3])], D),
               sound(1, D),
               forall(member(E, [1,2,3]),
                      ( joint(D, _, E1, E2, seam, _),
                        memberchk(E, [E1,E2]) )) )).

%   What looks at a model does not see the patterns made of it.

test(aside, forall(looked(Goal, Seen))) :-
    Terms = [box(size(1,1,1)),
             at([translate(0.5,0.4,0.3)], box(size(1,1,1)))],
    copy_term(Goal-Seen, GoalWithout-Without),
    in_model(Terms, GoalWithout),
    in_model(Terms, ( develop(1, _), develop(2, _), Goal )),
    assertion(Seen =@= Without).

looked(model_tolerance(T), T).
looked(census(Parts), Parts).
looked(self_meetings(3, M), M).
looked(( set_view(30,60,10), picture,
         findall(d(S,E,F,T,V,R), drawn(_,S,E,F,T,V,R), Ds) ), Ds).
looked(( penetrate, findall(S1-S2, line(_,S1,_,_,_,S2,_,_,_), Ls) ), Ls).
looked(( findall(S, root_segment(S), Ss) ), Ss).
looked(( roots_alone, findall(S, segment(S,_,_), Ss) ), Ss).
looked(( tmp_file(uc, File), write_mesh(File, all, [format(off)]),
         read_file_to_string(File, Text, []), delete_file(File) ), Text).

%   The paper's transform: DV-4.

test(transform, forall(( member(T, [box(size(1,2,3)), cone(radius(1),
                                    height(2), facets(7))]),
                         between(1, 3, K) ))) :-
    Degrees is 25*K,
    in_model([at([rotate(axis(1,2,3), Degrees)], T)],
             ( develop(1, D),
               forall(p(D, P, [E|Es]), transformed(1, D, P, E, Es)) )).

%   By the transform that lays edge E where it is in D, the others lie there.

transformed(S, D, P, E, Es) :-
    plane(S, P, A, B, C, _),
    e(S, E, V1, V2, _),
    e(D, E, W1, W2, _),
    v(S, V1, X, Y, Z),
    v(S, V2, X2, Y2, Z2),
    v(D, W1, Xd, Yd, _),
    v(D, W2, Xd2, Yd2, _),
    first_rotation(A, B, C, R1),
    unit2([X2-X,Y2-Y,Z2-Z], R1, Ex, Ey),
    Size is sqrt((Xd2-Xd)**2 + (Yd2-Yd)**2),
    Dx is (Xd2-Xd)/Size,
    Dy is (Yd2-Yd)/Size,
    Cos is Ex*Dx + Ey*Dy,
    Sin is Ex*Dy - Ey*Dx,
    forall(( member(E1, Es), e(S, E1, V, _, _), e(D, E1, W, _, _) ),
           ( v(S, V, Xv, Yv, Zv),
             v(D, W, Xw, Yw, _),
             times([Xv-X,Yv-Y,Zv-Z], R1, [U0,V0,Z0]),
             Xt is U0*Cos - V0*Sin + Xd,
             Yt is U0*Sin + V0*Cos + Yd,
             must_be_near(Xt, Xw, P),
             must_be_near(Yt, Yw, P),
             must_be_near(Z0, 0.0, P) )).

first_rotation(A, B, C, [[L,0,A],[M,N,B],[O,Q,C]]) :-
    L is sqrt(B*B + C*C),
    L > 1.0e-9,
    !,
    M is -A*B/L, N is C/L, O is -A*C/L, Q is -B/L.
first_rotation(A, _, _, [[0,0,S],[0,1,0],[T,0,0]]) :-
    S is A/abs(A),
    T is -S.

times([X,Y,Z], [[A,B,C],[D,E,F],[G,H,I]], [U,V,W]) :-
    U is X*A + Y*D + Z*G,
    V is X*B + Y*E + Z*H,
    W is X*C + Y*F + Z*I.

unit2(Vector, R1, X, Y) :-
    times(Vector, R1, [X0,Y0,_]),
    Size is sqrt(X0*X0 + Y0*Y0),
    X is X0/Size,
    Y is Y0/Size.

%   Solids of all kinds at once.

test(random, forall(between(1, 12, Seed))) :-
    set_random(seed(Seed)),
    random_blocks(_, Term1),
    random_primitive(Term2),
    in_model([Term1, Term2], ( develop(1, D1), sound(1, D1),
                               develop(2, D2), sound(2, D2) )).

test(cut_through, forall(between(1, 4, Seed))) :-
    set_random(seed(Seed)),
    random_blocks(_, Term1),
    random_blocks(_, Term2),
    in_model([Term1, Term2], ( penetrate,
                               develop(1, D1), sound(1, D1),
                               develop(2, D2), sound(2, D2) )).

test(order, Laid == [1,2,3]) :-
    in_model([box(size(1,1,1))],
             ( develop(1, [order([1,3,2]), root(1)], D), sound(1, D),
               findall(P, ( member(P, [1,2,3]), piece(D, P, 1) ), Laid),
               p(D, 1, Es),
               once(( member(E, Es), e(D, E, A, _, _), v(D, A, 0.0, 0.0, _) ))
             )).

test(kept, Kind == fold) :-
    in_model([box(size(1,1,1))],
             ( e(1, E, _, _, _), !,
               develop(1, [keep([E])], D),
               (   joint(D, _, E, _, Kind, _)
               ;   joint(D, _, _, E, Kind, _)
               ), ! )).

test(removed, Ps == [2,3,4,5]) :-
    in_model([box(size(1,1,1))],
             ( develop(1, [removed([1,6])], D), sound(1, D),
               findall(P, p(D, P, _), Ps0), sort(Ps0, Ps) )).

%   A pattern that was read from a file is measured anew: as it was laid.

test(measured_anew, [ forall(member(Term, [ cone(radius(3,2), height(4),
                                                 shift(2,1), facets(9)),
                                            box(size(1,2,3)) ])),
                      true(Again =@= Same) ]) :-
    in_model([Term],
             ( develop(1, D), development_measures(D, First),
               retractall_facts(origin(D, node(D), _)),
               development_measures(D, Again) )),
    put_dict(_{tests:0, refused:0}, First, Same).

test(minimize, forall(member(Objective, [seam,pieces,longest,area]))) :-
    in_model([torus(radius(2), tube(0.7), facets(12))],
             ( develop(1, D), development_measures(D, M1), sound(1, D),
               develop(1, [minimize(Objective)], D),
               development_measures(D, M2), sound(1, D) )),
    measure_of(Objective, M1, Value1),
    measure_of(Objective, M2, Value2),
    assertion(Value2 =< Value1*(1+1.0e-9)).

measure_of(seam, M, M.seam).
measure_of(pieces, M, M.pieces).
measure_of(longest, M, M.longest).
measure_of(area, M, M.sheet).

test(reasons, forall(solid(Term))) :-
    in_model([Term],
             ( develop(1, [], D),
               forall(joint(D, J, _, _, seam, _),
                      ( seam_reason(D, J, Reason), known(Reason, D) )) )).

known(overlap(P1, P2), D) :-
    p(D, P1, _),
    p(D, P2, _).
known(cycle([J|Js]), D) :-
    forall(member(K, [J|Js]), joint(D, K, _, _, fold, _)).
known(exchange(Js, J, P1, P2), D) :-
    memberchk(J, Js),
    known(cycle(Js), D),
    known(overlap(P1, P2), D).

test(reason_of_wish, Reason == cut_by_wish) :-
    in_model([box(size(1,1,1))],
             ( develop(1, [cut([1])], D),
               joint(D, J, 1, _, seam, _),
               seam_reason(D, J, Reason) )).

%   A face whose edges were all made auxiliary has no side, but corners.
test(no_real_edge, [N,Area] == [24,4.0]) :-
    in_model([box(size(2,2,2))],
             ( p(1, 1, Es),
               facts_transaction(forall(( member(E, Es), e(1, E, A, B, _) ),
                                        ( retract_fact(e(1, E, A, B, _)),
                                          assert_fact(e(1, E, A, B, 0)) ))),
               develop(1, D),
               aggregate_all(count, e(D, _, _, _, _), N),
               findall(X-Y, ( p(D, 1, Fs), member(F, Fs), e(D, F, V, _, _),
                              v(D, V, X, Y, _) ),
                       [X1-Y1,X2-Y2,X3-Y3|_]),
               Area is round(abs((X2-X1)*(Y3-Y2)-(X3-X2)*(Y2-Y1)))*1.0 )).

test(stale, error(existence_error(development, _))) :-
    in_model([box(size(1,1,1))],
             ( develop(1, D),
               v(1, 1, X, Y, Z),
               facts_transaction(( retract_fact(v(1, 1, X, Y, Z)),
                                   assert_fact(v(1, 1, X, Y, 5.0)) )),
               seam_reason(D, _, _) )).

test(curve, error(geometry_error(development(1, kind(curve))))) :-
    in_model([], ( assert_fact(segment(1, curve, c)), develop(1, _) )).
test(empty, error(geometry_error(development(1, empty)))) :-
    in_model([], ( assert_fact(segment(1, solid, s)), develop(1, _) )).
test(pattern, error(geometry_error(development(_, kind(pattern))))) :-
    in_model([box(size(1,1,1))], ( develop(1, D), develop(D, _) )).
test(no_joint, error(geometry_error(development(1, no_joint(999))))) :-
    in_model([box(size(1,1,1))], develop(1, [cut([999])], _)).
test(no_polygon, error(geometry_error(development(1, no_polygon(99))))) :-
    in_model([box(size(1,1,1))], develop(1, [root(99)], _)).
test(score_without_area, [ forall(member(Objective,
                                         [seam,pieces,longest,area])),
                           true(integer(Main)) ]) :-
    score(Objective, measures(1.0e90, 2, 1.0e90, 0.0, 1.0e180, 0, 0), Main/_).
test(shared_edges, Lists-Edges == [[1,2,3],[4,5,6]]-[1,2,3,4,5,6]) :-
    in_model([], ( shared_edges,
                   develop(1, D),
                   findall(List, p(D, _, List), Lists),
                   findall(E, e(D, E, _, _, _), Edges) )).
test(no_numbers, [ forall(member(E-P, [10-2147483647,2147483644-10])),
                   error(geometry_error(development(1, no_numbers))) ]) :-
    in_model([], ( folded_square(E, P), develop(1, _) )).
test(last_numbers, Ps-Last == [2147483646,2147483647]-2147483647) :-
    in_model([], ( folded_square(2147483642, 2147483645),
                   develop(1, D),
                   findall(P, p(D, P, _), Ps),
                   aggregate_all(max(E), e(D, E, _, _, _), Last) )).
test(kept_overlap, error(geometry_error(development(1, overlap(_,_,_))))) :-
    in_model([torus(radius(2), tube(0.7), facets(12))],
             ( findall(E, ( e(1, E, A, B, _), A < B ), Es),
               develop(1, [keep(Es)], _) )).

test(kept_overlap_named, true(Names == [P1,P2,P3,P4])) :-
    catch(in_model([torus(radius(2), tube(0.7), facets(12))],
                   ( findall(E, ( e(1, E, A, B, _), A < B ), Es),
                     develop(1, [keep(Es)], _) )),
          error(geometry_error(development(1, What)), _),
          true),
    What = overlap(edge(_, face(P1, _), face(P2, _)), face(P3, _),
                   face(P4, _)),
    What = overlap(edge(_, face(_, N1), face(_, N2)), face(_, N3),
                   face(_, N4)),
    in_model([torus(radius(2), tube(0.7), facets(12))],
             maplist(numbered(1), [N1,N2,N3,N4], Names)).

%   numbered(S, Name, P)

numbered(S, Name, P) :-
    polygons_named(S, Name, [P]).

%   Edges that have no partner, though one would think so, are told.

test(borders_told, [forall(bad_crate(Lists, Told0)), true(Told == Told0)]) :-
    borders_told_of(Lists, Told).

%   bad_crate(Faces, Told): a crate, open, or with a face too many, or turned.

bad_crate([[1,4,3,2],[1,2,6,5],[2,3,7,6],[3,4,8,7],[4,1,5,8],[5,6,7,8]], []).
bad_crate([[1,4,3,2],[1,2,6,5],[2,3,7,6],[3,4,8,7],[4,1,5,8]],
          [open-[2,3,4,5]]).
bad_crate([[1,4,3,2],[1,2,6,5],[2,3,7,6],[3,4,8,7],[4,1,5,8],[8,7,6,5]],
          [turned-[2,3,4,5,6,6,6,6]]).
bad_crate([[1,4,3,2],[1,2,6,5],[2,3,7,6],[3,4,8,7],[4,1,5,8],[5,6,7,8],
           [5,8,3]],
          [open-[7,7],crowded-[5]]).

borders_told_of(Lists, Told) :-
    retractall(test_development:told(_, _)),
    in_model([],
             ( assert_fact(segment(1, solid, crate)),
               forall(nth1(V, [ 0-0-0,2-0-0,2-2-0,0-2-0,
                                0-0-1,2-0-1,2-2-1,0-2-1 ], X0-Y0-Z0),
                      ( X is float(X0), Y is float(Y0), Z is float(Z0),
                        assert_fact(v(1, V, X, Y, Z)) )),
               findall(A-B-P,
                       ( nth1(P, Lists, Vs), next_to(Vs, A, B) ),
                       Sides),
               forall(nth1(E, Sides, A-B-_), assert_fact(e(1, E, A, B, 1))),
               forall(nth1(P, Lists, _),
                      ( findall(E, nth1(E, Sides, _-_-P), Es),
                        assert_fact(p(1, P, Es)) )),
               complete_segments,
               develop(1, _) )),
    findall(Kind-Ps, test_development:told(Kind, Ps), Told).

next_to(Vs, A, B) :-
    append(_, [A,B|_], Vs).
next_to([B|Vs], A, B) :-
    last(Vs, A).

test(border_messages,
     forall(( member(Kind, [open,turned,crowded]),
              member(Sides, [ [side(1,2,base)],
                              [ side(1,1,1), side(2,2,2), side(3,3,3),
                                side(4,4,4), side(5,5,5), side(6,6,6),
                                side(7,7,7) ] ]) ))) :-
    once(phrase(development_notice_en(1, border(Kind, Sides)), En)),
    once(phrase(development_notice_ko(1, border(Kind, Sides)), Ko)),
    assertion(En \== Ko).

test(messages, forall(( member(What, [ kind(curve), kind(pattern), kind(cells),
                                       empty, not_simple([1]), not_flat([1,2]),
                                       overlap(edge(1,face(1,base),face(3,3)),
                                               face(2,top), face(4,4)),
                                       no_joint(1),
                                       edge_length(1), no_polygon(1),
                                       no_numbers ]) ))) :-
    in_model([box(size(1,1,1))],
             ( phrase(development_en(1, What), En),
               phrase(development_ko(1, What), Ko) )),
    assertion(En \== []),
    assertion(Ko \== []),
    assertion(En \== Ko).

test(none, error(existence_error(segment, 7))) :-
    in_model([box(size(1,1,1))], develop(7, _)).

:- end_tests(development).
