/* Whose line a penetration line is: by default that of the first segment; by a
   rule that of the other, in the same places. */
:- module(test_line_segment, []).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(decision)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

%   pictured(Options, File, Parts): Visibility-Places-S of what is drawn of
%   penetration lines, Places from point to point whichever way.

pictured(Options, File, Parts) :-
    in_new_world((
        add_primitive(cylinder(radius(1), height(4), facets(12)), 1),
        add_primitive(at([rotate(x,90), translate(0,2,2)],
                            cylinder(radius(0.8), height(4), facets(12))), 2),
        (   File == none
        ->  true
        ;   use_rules(File)
        ),
        penetrate,
        set_view(300, 60, 0),
        picture(Options),
        findall(Visibility-Ends-S,
                ( drawn(_, S, E, From, To, Visibility, penetration),
                  e(S, E, A, B, _),
                  screen(S, A, X1, Y1, _),
                  screen(S, B, X2, Y2, _),
                  at(From, X1, Y1, X2, Y2, P),
                  at(To, X1, Y1, X2, Y2, Q),
                  msort([P,Q], Ends) ),
                Parts0)
    )),
    msort(Parts0, Parts).

at(T, X1, Y1, X2, Y2, X-Y) :-
    X is round(1.0e9*(X1 + T*(X2-X1))),
    Y is round(1.0e9*(Y1 + T*(Y2-Y1))).

:- begin_tests(line_segment).

test(first_by_default, Ss == [1]) :-
    pictured([], none, Parts),
    findall(S, member(_-_-S, Parts), Ss0),
    sort(Ss0, Ss).
test(second_by_rule) :-
    pictured([], none, Parts1),
    pictured([], 'docs/line_rules.pl', Parts2),
    findall(V-P, member(V-P-1, Parts1), Places1),
    findall(V-P, member(V-P-2, Parts2), Places2),
    length(Places1, N),
    N > 20,
    Places1 == Places2,
    length(Parts2, N).
test(not_one_that_is_left_out, Ss == [1]) :-
    pictured([segments([1])], 'docs/line_rules.pl', Parts),
    findall(S, member(_-_-S, Parts), Ss0),
    sort(Ss0, Ss).

:- end_tests(line_segment).
