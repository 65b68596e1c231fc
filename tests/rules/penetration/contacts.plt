:- module(test_contacts, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(random)).
:- use_module(library(solution_sequences)).
:- use_module(rules(exact)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/grid_model')).
:- use_module(tests('rules/penetration/oracle')).
:- use_module(tests('rules/sample')).

/* Contacts in a point alone, against the oracle: those points that two
triangles of two segments have in common alone, and that are on no line of
these segments.
Random solids and sheets on a coarse grid, two or three together. */

contact_fault(I, Fault) :-
    set_random(seed(I)),
    random_member(N, [2,2,3]),
    length(Shapes, N),
    maplist(random_shape, Shapes),
    new_world(World),
    in_world(World,
             ( forall(nth1(S, Shapes, Shape), add_shape(S, Shape)),
               complete_segments,
               findall(S1-S2-Points, oracle_contacts(S1, S2, Points), Wanted),
               penetrate,
               findall(S1-S2-Points,
                       ( member(S1-S2-_, Wanted),
                         engine_contacts(S1, S2, Points) ),
                       Found)
             )),
    note_contacts(Wanted),
    Found \== Wanted,
    Fault = I-wanted(Wanted)-found(Found).

oracle_contacts(S1, S2, Points) :-
    segment(S1, _, _),
    segment(S2, _, _),
    S1 < S2,
    leaves(S1, Leaves1),
    leaves(S2, Leaves2),
    common_points(Leaves1, Leaves2, Points0),
    common_lines(Leaves1, Leaves2, Lines),
    pairs_values(Lines, Pieces),
    runs(Pieces, Runs),
    exclude(is_on_a_line(Runs), Points0, Points).

is_on_a_line(Runs, Point) :-
    run_point(Runs, Point, _),
    !.

engine_contacts(S1, S2, Points) :-
    findall(p(X,Y,Z),
            ( line(_, S1, _, A, A, S2, _, _, _),
              vertex_exact(S1, A, X, Y, Z) ),
            Points0),
    sort(Points0, Points).

:- dynamic contacts/1.

note_contacts(Wanted) :-
    pairs_values(Wanted, Lists),
    append(Lists, Points),
    length(Points, N),
    assertz(contacts(N)).

:- begin_tests(contacts).

test(random_models, Bad == []) :-
    findall(Fault,
            limit(3, ( numbered(250, 400, I), contact_fault(I, Fault) )),
            Bad).
test(there_were_some, true(Sum >= 50)) :-
    findall(N, contacts(N), Ns),
    sum_list(Ns, Sum).

:- end_tests(contacts).
