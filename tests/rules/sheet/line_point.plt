/* Numbered points of penetration lines: so many of each, evenly; in all views
   the same, above one another and beside one another. */
% covers: picture_marks
:- module(test_line_point, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(sheet/line_point)).
:- use_module(rules(sheet/sheet_view)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

%   in_branches(Goal): a branch goes through a thicker header: two closed lines.

in_branches(Goal) :-
    in_new_world((
        add_primitive(cylinder(radius(2), height(8), facets(48)), 1),
        add_primitive(at([rotate(x,90), translate(0.3,5,4)],
                         cylinder(radius(1), height(10), facets(48))), 2),
        penetrate,
        call(Goal)
    )).

points(Most, Points, Lengths) :-
    in_branches(( line_points(Most, Points),
                  findall(L, ( chain(_,_,_,_,Steps),
                               chain_length(Steps, L) ), Lengths) )).

:- begin_tests(line_point).

test(evenly, forall(member(Most, [1,2,5,8]))) :-
    points(Most, Points, [Length1,Length2]),
    findall(P, member(point(_,_,_,P), Points), Ps),
    length(Ps, N),
    N =:= 2*Most,
    findall(I, member(point(I,_,_,_), Points), Is),
    numlist(1, N, Is),
    length(First, Most),
    append(First, Second, Ps),
    steps_even(First, Length1),
    steps_even(Second, Length2).
test(all, N =:= Corners) :-
    in_branches(( line_points(all, Points),
                  aggregate_all(count, line(_,_,_,_,_,_,_,_,_), Corners) )),
    length(Points, N).
test(views_agree) :-
    points(6, Points, _),
    maplist(dots_of(Points), [front,top,right], [Front,Top,Right]),
    forall(member(I-(X-Y), Front),
           ( memberchk(I-(X1-_), Top),
             abs(X-X1) < 1.0e-9,
             memberchk(I-(_-Y1), Right),
             abs(Y-Y1) < 1.0e-9 )),
    length(Front, 12).
test(none_in_sections, Dots == []) :-
    points(6, Points, _),
    section_view('A', plane(0,1,0,0), y, "y=0", View),
    points_seen(dashed, Points, seen(View,[],[],[]), Dots).
test(only_where_drawn, Is == [2]) :-
    points(6, Points, _),
    view_named(front, View),
    points_seen(shown, Points, seen(View,[],[],[]), Dots),
    memberchk(dot(front,At,2), Dots),
    points_seen(removed, Points,
                seen(View,[part(visible,penetration,1,7,0.0,1.0,At,9-9),
                           part(visible,crease,1,8,0.0,1.0,9-9,8-8)],[],[]),
                Left),
    findall(I, member(dot(front,_,I), Left), Is).
test(corner_of_two_chains_once) :-
    in_new_world((
        add_primitive(cylinder(radius(1), height(6), facets(24)), 1),
        add_primitive(at([rotate(x,90), translate(0,3,3)],
                         cylinder(radius(1), height(6), facets(24))), 2),
        penetrate,
        line_points(all, Points)
    )),
    findall(P, member(point(_,_,_,P), Points), Ps),
    sort(Ps, Once),
    length(Ps, N),
    length(Once, N).

dots_of(Points, Name, Dots) :-
    view_named(Name, View),
    points_seen(dashed, Points, seen(View,[],[],[]), Items),
    findall(I-P, member(dot(Name,P,I), Items), Dots).

%   steps_even(Ps, Length): from point to point, straight, no longer than such a
%   part of the line, give or take one of its pieces.

steps_even(Ps, Length) :-
    length(Ps, N),
    Most is Length/N + Length/20,
    forall(nextto(p(X1,Y1,Z1), p(X2,Y2,Z2), Ps),
           sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2) =< Most).

:- end_tests(line_point).
