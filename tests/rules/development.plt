/* Developments: rules/development.pl and its kernels. */
:- use_module(library(aggregate)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(rules(decision), [use_rules/1]).
:- use_module(rules(csg), [root_segment/1]).
:- use_module(rules(csg_roots), [roots_alone/0]).
:- use_module(rules(development)).
:- use_module(rules(hidden_lines)).
:- use_module(rules(mesh)).
:- use_module(rules(penetration)).
:- use_module(rules(view), [set_view/3]).
:- use_module(rules(kernel)).
:- use_module(rules(model_file)).
:- use_module(rules(store)).
:- use_module(rules(triangulation)).

%   in_model(+Terms, :Goal): in a world of its own, of these primitives.

:- meta_predicate in_model(+, 0).

in_model(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

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

test(none, error(existence_error(segment, 7))) :-
    in_model([box(size(1,1,1))], develop(7, _)).

:- end_tests(development).
