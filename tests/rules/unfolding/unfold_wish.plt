:- module(test_unfold_wish, []).
:- use_module(library(plunit)).
:- use_module(rules(sanggwan)).
:- use_module(rules(development/leaf_face)).
:- use_module(rules(pattern/pattern_want)).
:- use_module(rules(development/polygon_name)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(unfolding/unfold_wish)).
:- use_module(tests('rules/message_text'), [message_text/3]).

% What people want of a development, by numbers and by names, and what
% contradicts itself.

with_primitive(Term, Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(Term, _),
               complete_segments,
               call(Goal) )).

hexagonal(prism(outline([[2,0],[1,2],[-1,2],[-2,0],[-1,-2],[1,-2]]),
                height(5))).

wanted_of(Term, Wishes, Wanted) :-
    findall(wish(Wish, fact), member(Wish, Wishes), Facts),
    with_primitive(Term, wanted(1, Facts, Wanted)).

box(box(size(2, 3, 4))).

% A square in quarters, its middle at height Z.
quarters(Z, sheet(points([[0,0,0],[2,0,0],[2,2,0],[0,2,0],[1,1,Z]]),
                  faces([[1,2,5],[2,3,5],[3,4,5],[4,1,5]]))).

% The faults of a box: What is the term behind the wish.
fault(Wishes, What) :-
    box(Box),
    catch(wanted_of(Box, Wishes, _),
          error(model_error(unfold(1, Wish, What0)), _),
          true),
    nonvar(What0),
    forall(member(Language, [en,ko]),
           ( message_text(Language,
                          error(model_error(unfold(1, Wish, What0)), _), Text),
             \+ sub_string(Text, _, _, _, "Unknown") )),
    plain(What0, What).

% Faults name polygons with what they are; here the numbers do.
plain(Fault0, Fault) :-
    Fault0 = face(P, _),
    !,
    Fault = P.
plain(Fault0, Fault) :-
    compound(Fault0),
    !,
    Fault0 =.. [Name|Parts0],
    maplist(plain, Parts0, Parts),
    Fault =.. [Name|Parts].
plain(Fault, Fault).

%   A tree: a named cylinder, a named box in it, and a box of no name.

with_tree(Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term,
                             [ named(can, cylinder(radius(2), height(5),
                                                   facets(8))),
                               at([translate(0,0,1)],
                                  named(bar, box(size(4,1,1)))),
                               at([translate(-2,-1,1)], box(size(2,5,1))) ]),
                      add_primitive(Term, _)),
               assert_fact(segment(4, solid, difference([1,3]))),
               assert_fact(segment(5, solid, union([4,2]))),
               evaluate,
               complete_segments,
               call(Goal) )).

same_name(Name, Ps) :-
    polygons_named(5, Name, Ps).

shared_edge(P, Q, E) :-
    once(joined_by(1, P, Q, E)).

:- begin_tests(polygon_name).

test(by_what, Ps == [3]) :-
    hexagonal(Prism),
    with_primitive(Prism, polygons_named(1, side(1), Ps)).
test(of_a_leaf, [true(Ps == [P])]) :-
    with_tree(( polygons_named(5, can/top, Ps),
                Ps = [P],
                polygon_name(5, P, can/top) )).
test(of_a_leaf_by_number, [true(Ps == Same)]) :-
    with_tree(maplist(same_name, [can/top,1/top], [Ps,Same])).
test(of_a_leaf_without_a_name) :-
    with_tree(( polygons_named(5, 3/side, Ps),
                Ps = [_|_],
                forall(member(P, Ps), polygon_name(5, P, 3/_)) )), !.
test(of_any_leaf, [true(Ps == All)]) :-
    with_tree(( polygons_named(5, top, Ps),
                findall(P, ( member(Leaf, [can,bar,3]),
                             polygons_named(5, Leaf/top, Ps1),
                             member(P, Ps1) ),
                        All0),
                sort(All0, All) )).
test(of_no_leaf, [true(Ps == [])]) :-
    with_tree(polygons_named(5, lid/top, Ps)).
test(written_on_the_pattern, all(Text == ["can/base","can/top"])) :-
    with_tree(( develop(5, [], D),
                findall(T, ( p(D, P, _),
                             Placed = placed(name(D,1,0),[face(P,[])],[],[],
                                             []),
                             wanted_texts([names(words),numbers(false)], t,
                                          Placed, Wanted),
                             member(want(face_name,_,T,_,_), Wanted) ),
                        Texts0),
                sort(Texts0, Texts) )),
    member(Text, Texts),
    string(Text),
    sub_string(Text, 0, _, _, "can/").
test(leaves_gone_are_remembered, [true(Ps-Name == Before-(can/top))]) :-
    with_tree(( polygons_named(5, can/top, Before),
                roots_alone_named,
                \+ segment(1, _, _),
                polygons_named(5, can/top, Ps),
                Ps = [P|_],
                polygon_name(5, P, Name) )).
test(edges_between_leaves) :-
    with_tree(( edges_named(5, can/side-bar/top, Es),
                Es = [_|_] )).
test(known_ones, [true(Missing == [])]) :-
    with_tree(known_polygons(5, _, Names)),
    subtract([can/base,can/top,can/curved(side)], Names, Missing).
test(several, [true(Names == [can/top])]) :-
    with_tree(catch(wanted(5, [wish(root(top), flag)], _),
                    error(usage_error(unfold(5, _, several(top, Faces))), _),
                    true)),
    findall(Name, ( member(face(_, Name), Faces), Name = can/_ ), Names).

test(by_first_word, N == 6) :-
    hexagonal(Prism),
    with_primitive(Prism, polygons_named(1, side, Ps)),
    length(Ps, N).
test(several, Ps == [1,2]) :-
    hexagonal(Prism),
    with_primitive(Prism, polygons_named(1, [top,base,top], Ps)).
test(facet, Ps == [3]) :-               % whole numbers stand for floats
    with_primitive(cylinder(radius(1), height(2), facets(8)),
                   polygons_named(1, curved(side, [0-45]), Ps)).
test(part, N-M == 8-8) :-
    with_primitive(cylinder(radius(1), height(2), facets(8)),
                   ( polygons_named(1, curved(side), Ps),
                     polygons_named(1, side, Qs) )),
    length(Ps, N),
    length(Qs, M).
test(none, Ps == []) :-
    box(Box),
    with_primitive(Box, polygons_named(1, lid, Ps)).
test(edge_of_two, Es == [E]) :-
    hexagonal(Prism),
    with_primitive(Prism, ( edges_named(1, base-side(1), Es),
                            shared_edge(1, 3, E) )).
test(either_way, Es == Fs) :-
    hexagonal(Prism),
    with_primitive(Prism, ( edges_named(1, base-side(1), Es),
                            edges_named(1, side(1)-base, Fs) )).
test(all_round, N == 6) :-
    hexagonal(Prism),
    with_primitive(Prism, edges_named(1, top-side, Es)),
    length(Es, N).
test(by_ends, Es == Fs) :-
    hexagonal(Prism),
    with_primitive(Prism, ( edges_named(1, v(1)-v(2), Es),
                            edges_named(1, v(2)-v(1), Fs) )),
    Es = [_].
test(partner, Es == [E]) :-             % the smaller number of the two
    box(Box),
    with_primitive(Box, ( shared_edge(1, 3, E), e(1, E, A, B, _),
                          e(1, F, B, A, _), edges_named(1, F, Es) )).
test(no_edge_name, fail) :-
    box(Box),
    with_primitive(Box, edges_named(1, f(1), _)).
test(name, Name == base) :-
    box(Box),
    with_primitive(Box, polygon_name(1, 1, Name)).
test(kinds, Names == [base,top,'side(1..6)']) :-
    hexagonal(Prism),
    with_primitive(Prism, known_polygons(1, _, Names)).
test(segment_named, Ss == [1]) :-
    with_primitive(named(lid, rectangle(size(1, 1))),
                   segments_named(lid, Ss)).
test(of_what_was_trimmed, Name == top) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(4, 4, 4)), A),
               add_primitive(at([translate(1, 1, 1)], box(size(4, 4, 4))), B),
               complete_segments,
               trimmed(A, [B], outside, T),
               polygons_named(T, top, [P]),
               polygon_name(T, P, Name) )).

:- end_tests(polygon_name).

:- begin_tests(unfold_wish).

test(nothing, Wanted == wanted(none, [], [], [])) :-
    box(Box),
    wanted_of(Box, [], Wanted).
test(root, Root == 2) :-
    box(Box),
    wanted_of(Box, [root(top)], wanted(Root, _, _, _)).
test(cut, Ps == [1-3]) :-
    box(Box),
    wanted_of(Box, [cut(1-3)], wanted(_, [edge(_, P, Q)], _, _)),
    sort([P,Q], [A,B]),
    Ps = [A-B].
test(cut_once, N == 4) :-
    box(Box),
    wanted_of(Box, [cut(base-3), cut(base-side), cut(side-base)],
              wanted(_, Cut, _, _)),
    length(Cut, N).
test(keep, N == 1) :-
    box(Box),
    wanted_of(Box, [keep(v(1)-v(2))], wanted(_, _, Keep, _)),
    length(Keep, N).
test(removed, Removed == [1,2]) :-
    box(Box),
    wanted_of(Box, [removed([top,base])], wanted(_, _, _, Removed)).
test(removed_twice, Removed == [1,2]) :-
    box(Box),
    wanted_of(Box, [removed(top), removed(base), removed(2)],
              wanted(_, _, _, Removed)).

% An order is a root and edges that are kept: each polygon to one before it.
test(order, Root-Pairs == 3-[[3,4],[4,5]]) :-
    hexagonal(Prism),
    wanted_of(Prism, [order([3,4,5])], wanted(Root, _, Keep, _)),
    findall(Ps, ( member(edge(_, P, Q), Keep), sort([P,Q], Ps) ), Pairs).
test(order_longest, Pairs == [[1,3],[3,4]]) :- % sides are longer than the base
    hexagonal(Prism),
    wanted_of(Prism, [order([1,3,4])], wanted(_, _, Keep, _)),
    findall(Ps, ( member(edge(_, P, Q), Keep), sort([P,Q], Ps) ), Pairs).
test(order_not_where_cut, Pairs == [[1,3],[1,4]]) :-
    hexagonal(Prism),
    wanted_of(Prism, [order([1,3,4]), cut(3-4)], wanted(_, _, Keep, _)),
    findall(Ps, ( member(edge(_, P, Q), Keep), sort([P,Q], Ps) ), Pairs).
test(order_where_kept, N == 2) :-       % 3 and 4 are connected already
    hexagonal(Prism),
    wanted_of(Prism, [keep(3-4), order([1,3,4])], wanted(_, _, Keep, _)),
    length(Keep, N).
test(order_root, Root == 3) :-
    hexagonal(Prism),
    wanted_of(Prism, [root(3), order([3,4])], wanted(Root, _, _, _)).

% What cannot be.
test(cut_and_keep, What = cut_and_keep(_, 1, 3)) :-
    fault([cut(1-3), keep(base-3)], What).
test(no_polygon, Names == [base,top,'side(1..4)']) :-
    fault([root(lid)], no_polygon(lid, _, Names)).
test(no_number, Ps == [1,2,3,4,5,6]) :-
    fault([removed(9)], no_polygon(9, Ps, _)).
test(no_side_of_edge, Name == 9) :-
    fault([cut(9-3)], no_polygon(Name, _, _)).
test(several_roots, Ps == [3,4,5,6]) :-
    fault([root(side)], several(side, Ps)).
test(two_roots, What == two_roots(1, 2)) :-
    fault([root(1), root(top)], What).
test(removed_root, What == removed_root(1)) :-
    fault([root(1), removed(base)], What).
test(removed_all, What == removed_all) :-
    fault([removed([base,top,side])], What).
test(removed_keep, What = removed_keep(_, 1)) :-
    fault([removed(1), keep(1-3)], What).
test(apart, P-Qs == 1-[3,4,5,6]) :-
    fault([cut(base-top)], apart(base, top, P, Qs)).
test(no_edge, What == no_edge(99)) :-
    fault([keep(99)], What).
test(no_ends, What == no_edge(v(1)-v(99))) :-
    fault([keep(v(1)-v(99))], What).
test(border, What = border(_, face(1, front))) :-
    catch(wanted_of(rectangle(size(1, 1)), [cut(1)], _),
          error(model_error(unfold(1, _, What)), _), true).
test(order_apart, What == order_apart(2, [1])) :-
    fault([order([1,2])], What).
test(order_cut, What = order_cut(3, [1])) :-
    fault([order([1,3]), cut(1-3)], What).
test(order_removed, What == order_removed(1)) :-
    fault([order([3,1]), removed(1)], What).
test(order_twice, What == order_twice(3)) :-
    fault([order([3,1,side])], What).
test(order_root, What == order_root(1, 3)) :-
    fault([root(1), order([3,1])], What).
test(ring, What = ring(_, _, _)) :-
    fault([keep(1-3), keep(3-4), keep(1-4)], What).
test(unknown, What == unknown_wish) :-
    fault([fold(3)], What).
test(form, What = form(_),
     forall(member(Wish, [cut(top), keep(v(1)-2), order([]), order(3),
                          root([1]), removed([]), root(1-2)]))) :-
    fault([Wish], What).
test(flag, error(usage_error(unfold(1, cut(1-2), apart(_, _, _, _))))) :-
    box(Box),
    with_primitive(Box, wanted(1, [wish(cut(1-2), flag)], _)).
test(flag_against_fact, error(usage_error(unfold(1, cut(1-3), _)))) :-
    box(Box),
    with_primitive(Box, wanted(1, [wish(keep(1-3), fact),
                                   wish(cut(1-3), flag)], _)).

% What was trimmed: the same names mean its pieces.
test(trimmed, Names-Roots == [base,top]-1) :-
    new_world(World),
    in_world(World,
             ( add_primitive(cylinder(radius(3), height(12), facets(20)), A),
               add_primitive(at([translate(0, 0, -4)],
                                cylinder(radius(2), height(20),
                                         facets(12))), B),
               complete_segments,
               wanted(B, [wish(removed([base,top]), fact),
                          wish(root(3), fact)],
                      Wanted),
               trimmed(B, [A], outside, T),
               wanted_in(T, B, Wanted, Options),
               memberchk(removed(Ps), Options),
               findall(Name, ( member(P, Ps), polygon_name(T, P, Name) ),
                       Names),
               aggregate_all(count, member(root(_), Options), Roots) )).
test(trimmed_edges, true(N >= 12)) :-
    new_world(World),
    in_world(World,
             ( add_primitive(cylinder(radius(3), height(12), facets(20)), A),
               add_primitive(at([rotate(x, 90), translate(0, 5, 6)],
                                cylinder(radius(2), height(10),
                                         facets(12))), B),
               complete_segments,
               wanted(B, [wish(cut(base-side), fact),
                          wish(cut(top-side), fact)], Wanted),
               trimmed(B, [A], outside, T),
               wanted_in(T, B, Wanted, Options),
               memberchk(cut(Es), Options),
               forall(member(E, Es), once(edge_polygon(T, E, _))),
               length(Es, N) )).
test(penetrated_edges, N == 6) :-       % four edges, two of them divided
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(4, 4, 4)), A),
               add_primitive(at([translate(2, 2, 2)], box(size(4, 4, 4))), _),
               complete_segments,
               wanted(A, [wish(cut(top-side), fact)], Wanted),
               penetrate,
               wanted_in(A, A, Wanted, Options),
               memberchk(cut(Es), Options),
               forall(member(E, Es), once(e(A, E, _, _, 1))),
               length(Es, N) )).

%   A ring that lies flat may be kept, another one may not.

test(flat_ring, Count == 4) :-
    quarters(0, Term),
    wanted_of(Term, [keep(1-2),keep(2-3),keep(3-4),keep(4-1)],
              wanted(_, _, Keep, _)),
    length(Keep, Count).
test(bent_ring, true(What = ring(_, 1, 4))) :-
    quarters(1, Term),
    catch(wanted_of(Term, [keep(1-2),keep(2-3),keep(3-4),keep(4-1)], _),
          error(model_error(unfold(1, keep(4-1), What0)), _),
          true),
    plain(What0, What).

%   What is cut at a polygon that is removed, is.

test(cut_at_removed, Cut == [10]) :-
    box(Box),
    wanted_of(Box, [removed(1),cut(1),cut(3-4)], wanted(_, Cut0, _, _)),
    findall(E, member(edge(E, _, _), Cut0), Cut).

:- end_tests(unfold_wish).
