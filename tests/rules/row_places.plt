/* What is computed from rows is the same wherever they stand on the pages of
   their relations.

   Before a model comes, rows of every relation are asserted and retracted, so
   that its rows stand behind them, on two pages, as in a session that has
   worked for long. */
:- module(test_row_places, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(sanggwan)).
:- use_module(rules(store)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

page_rows(4096).

% case(Name, Terms, Goal): a model, and what is done with it.
case(penetrate, [ box(size(4,4,4)),
                  at([translate(1,1,1), rotate(z,20)],
                     cylinder(radius(1), height(6), facets(12))) ],
     penetrate).
case(picture, [ cylinder(radius(2), height(6), facets(16)),
                at([translate(0,0,3), rotate(y,90)],
                   cylinder(radius(1), height(6), facets(16))),
                sphere(radius(2.5), facets(12), bands(6)) ],
     ( penetrate, picture )).
case(contacts, [ at([rotate(z,33), rotate(x,17)], box(size(2,2,2))),
                 at([translate(1,0.3,2), rotate(z,33), rotate(x,17)],
                    box(size(2,2,2))) ],
     penetrate).
case(union, [ box(size(2,2,2)),
              at([translate(1,1,1)], box(size(2,2,2))),
              at([translate(1,0,0)], box(size(2,2,2))) ],
     ( assert_fact(segment(9, solid, union([1,2,3]))), evaluate )).
case(difference, [ box(size(4,4,4)),
                   at([translate(0,0,2)],
                      torus(radius(1.5), tube(0.7), facets(12), sides(8))) ],
     ( assert_fact(segment(9, solid, difference([1,2]))), evaluate )).
case(develop, [ cone(radius(2), top(1), height(3), facets(12)) ],
     develop(1, _)).
case(trim, [ cylinder(radius(2), height(6), facets(16)),
             at([rotate(y,90)],
                cylinder(radius(1), height(6), facets(16))) ],
     ( trimmed(2, [1], outside, T), develop(T, _) )).

%   worked(+Places, +Before, +Case, -Rows): Rows are what the world holds after
%   Case. When its model came, the places of Before rows of each relation were
%   taken, or (`one`) that of the last of them alone: ids go on from it.

worked(Places, Before, Name, Told-Rows) :-
    case(Name, Terms, Goal),
    in_new_world(( forall(member(Term, Terms), add_primitive(Term, _)),
                   complete_segments,
                   all_rows(Model) )),
    in_new_world(( places_taken(Places, Before),
                   facts_transaction(forall(( member(_-Own, Model),
                                              member(Row, Own) ),
                                            assert_fact(Row))),
                   once(test_row_places:Goal),
                   told(Told),
                   all_rows(Rows) )).

told(Defects-Volumes) :-
    findall(D, model_defect(D), Defects),
    findall(S-V,
            ( segment(S, solid, _), catch(volume(S, V), _, fail) ),
            Volumes).

all_rows(Rows) :-
    findall(Name-Own,
            ( relation(Name, Arity, _),
              functor(Row, Name, Arity),
              findall(Row, ( call(Row), \+ stamped(Row) ), Own0),
              msort(Own0, Own)
            ),
            Rows).

%   What is kept of a node has stamps in it, which count changes.

stamped(origin(_, node(_), _)).

%   Rows are asserted, and retracted in a transaction of its own, so that undo
%   remembers them and no other takes their places.

places_taken(Places, N) :-
    (   Places == all
    ->  From = 1
    ;   From = N
    ),
    findall(Row, taken(From, N, Row), Rows),
    facts_transaction(maplist(assert_fact, Rows)),
    facts_transaction(forall(( relation(Name, Arity, _),
                               functor(Row, Name, Arity) ),
                             retractall_facts(Row))).

%   What others refer to has the number N, which is always taken.

taken(From, N, Row) :-
    between(From, N, I),
    segment_taken(S),
    taken_row(S, N, I, Row).

segment_taken(200000).

taken_row(S, _, I, segment(S1, solid, taken)) :- S1 is S+I.
taken_row(S, _, I, v(S,I,0,0,I)).
taken_row(S, N, I, e(S,I,N,N,1)).
taken_row(S, N, I, p(S,I,[N])).
taken_row(S, _, I, plane(S,I,0,0,1,0)).
taken_row(S, N, I, t(S,N,I,N,N,N)).
taken_row(S, _, I, leaf_v(S,I,0,0,0)).
taken_row(S, N, I, leaf_e(S,I,N,N,1)).
taken_row(S, N, I, leaf_p(S,I,[N])).
taken_row(S, N, I, leaf_t(S,N,I,N,N,N)).
taken_row(S, _, I, origin(S,v(I),v(S,I))).
taken_row(S, _, I, from_v(S,I,S,I)).
taken_row(S, _, I, from_p(S,I,S,I,1)).
taken_row(S, N, I, line(I,S,N,N,N,S,N,N,N)).
taken_row(S, _, I, piece(S,I,1)).
taken_row(S, N, I, joint(S,I,N,N,fold,0)).
taken_row(S, _, I, screen(S,I,0,0,0)).
taken_row(S, N, I, contour(S,I,N,1,0,2,0,visible,[N],0,0,0,0)).
taken_row(S, _, I, surface_facing(S,I,1,0,0,[I])).
taken_row(S, N, I, drawn(I,S,N,0,1,visible,crease)).
taken_row(_, _, I, view(1,1,I)).
taken_row(S, _, I, unfolding(S,root(I))).

same(Name, Before) :-
    worked(one, Before, Name, Told1-Rows1),
    worked(all, Before, Name, Told2-Rows2),
    (   Told1 == Told2
    ->  true
    ;   format(user_error, '~q after ~d rows: ~q, else ~q~n',
               [Name,Before,Told2,Told1]),
        fail
    ),
    forall(( member(Relation-Own1, Rows1),
             memberchk(Relation-Own2, Rows2),
             Own1 \== Own2 ),
           ( subtract(Own1, Own2, Gone),
             subtract(Own2, Own1, New),
             length(Gone, G),
             length(New, N),
             format(user_error,
                    '~q after ~d rows: ~w: ~d otherwise (~d)~n  ~p~n  ~p~n',
                    [Name,Before,Relation,G,N,Gone,New]) )),
    Rows1 == Rows2.

:- begin_tests(row_places).

test(before, Same == true) :-
    in_new_world(( places_taken(all, 100), findall(R, ( relation(R, A, _),
                                                   functor(Row, R, A), Row ),
                                              Left) )),
    ( Left == [] -> Same = true ; Same = Left ).

% The first row of a model is the last of a page, the first, or one of the
% last few: then a part of it stands on the next.
test(same, forall(( case(Name, _, _),
                    page_rows(Page),
                    member(Off, [-1,0,-9]) ))) :-
    Before is Page+Off,
    same(Name, Before).

:- end_tests(row_places).
