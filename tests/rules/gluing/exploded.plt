/* Exploded cells: each is closed, as large as it was, where it should be. */
:- module(test_exploded, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(csg/known_surface)).
:- use_module(rules(gluing/exploded)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(model/model)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

cells_of(File, Factor, Volumes, Kinds, Apart) :-
    in_new_world(( load_model(File),
                   once(( segment(S, cells, _), region(S, _, _) )),
                   glue_report(S, Report),
                   cells_exploded(Factor),
                   findall(R-Volume, cell_volume(S, R, Volume), Apart0),
                   findall(Kind, segment(_, Kind, region(S, _)), Kinds0) )),
    findall(R-Volume,
            ( member(Region, Report.regions),
              Region.role == cell,
              R = Region.region,
              Volume = Region.volume ),
            Volumes),
    msort(Kinds0, Kinds),
    sort(Apart0, Apart).

cell_volume(S, R, Volume) :-
    segment(N, solid, region(S, R)),
    regions_report(N, Report),
    findall(V,
            ( member(Region, Report.regions),
              Region.role == cell,
              V = Region.volume ),
            [Volume]).                  % what is in it may be a void

close_to(R-X, R-Y) :-
    abs(X-Y) < 1.0e-9.

two_cylinders(Out) :-
    format(Out, "segment(1, solid, cylinder(radius(2), height(3), \c
                                           facets(16))).~n\c
                 segment(2, solid, at([translate(1,0,3)], \c
                          cylinder(radius(1), height(2), facets(16)))).~n\c
                 segment(3, solid, glue([1,2])).~n", []).

lowest(S, Z) :-
    findall(Z0, v(S, _, _, _, Z0), Zs),
    min_list(Zs, Z).

:- begin_tests(exploded).

test(volumes, [ forall(member(File-N, [ 'facts/figures/glue_face.pl'-2,
                                        'facts/figures/glue_vertex.pl'-3,
                                        'facts/figures/glue_crossing.pl'-5,
                                        'facts/figures/glue_materials.pl'-4
                                      ])),
                true(( length(Apart, N), maplist(close_to, Volumes, Apart) ))
              ]) :-
    cells_of(File, 0.5, Volumes, _, Apart).

%   The surfaces that facets stand for go where the facets do.

test(smooth, [true(Frames == [ [X,0.0,Z,1.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,2.0],
                               [0.0,0.0,Low,2.0,0.0,0.0,0.0,2.0,0.0,0.0,0.0,3.0]
                             ])]) :-
    in_new_world(( setup_call_cleanup(
                       tmp_file_stream(File, Out, [extension(pl)]),
                       ( two_cylinders(Out), close(Out), load_model(File) ),
                       delete_file(File)),
                   glue_report(3, _),
                   cells_exploded(0.5),
                   remembered_facets(Known),
                   lowest(4, Z),
                   lowest(5, Low),
                   findall(X0, v(4, _, X0, _, _), Xs) )),
    findall(Frame, ( member(known(_,[surface(tapered,Frame,_,_)],_), Known) ),
            Frames),
    min_list(Xs, Least),
    X is Least+1.0,
    Z-Low-X == 3.75-(-0.5)-1.5.

%   What is outside stays: the parts of the sheet that are in no cell.

test(outside, Kinds == [solid,solid,solid,solid,surface]) :-
    cells_of('facts/figures/glue_materials.pl', 0.5, _, Kinds, _).

%   Cells that a file has, and no glue made.

test(read, Kinds == [curve,solid,solid]) :-
    in_new_world(( load_model('facts/two_rooms.pl'),
                   cells_exploded(0.5),
                   findall(Kind, segment(_, Kind, _), Kinds0) )),
    msort(Kinds0, Kinds).

%   Two boxes, moved away from each other by half the way between them.

test(moved, Low-High == 0.0 - 2.25) :-
    in_new_world(( load_model('facts/figures/glue_face.pl'),
                   cells_exploded(0.5),
                   findall(Z, v(_, _, _, _, Z), Zs0) )),
    sort(Zs0, Zs),
    nth1(1, Zs, Low0),
    last(Zs, High0),
    Low is Low0+0.25,
    High is High0+0.0.

%   Each copy is its original, moved by the factor times the way from the middle
%   of the whole box to that of its own, along each axis.

test(rigid, [ forall(member(File, [ 'facts/figures/glue_vertex.pl',
                                    'facts/figures/glue_crossing.pl',
                                    'facts/figures/glue_materials.pl' ])),
              nondet ]) :-
    in_new_world(( load_model(File),
                   once(segment(S, cells, _)),
                   findall(p(X,Y,Z), v(S, _, X, Y, Z), All),
                   ( region(S, _, _) -> true ; regions_made(S, _) ),
                   segment_exploded(S, 0.75, Parts),
                   findall(N, ( member(part(N,_,_), Parts),
                                segment(N, solid, _) ), Ns),
                   forall(nth1(Axis, [x,y,z], _),
                          ( middle(Axis, All, Whole),
                            forall(member(N, Ns),
                                   moved(S, N, Axis, Whole)) )) )),
    length(Ns, Count),
    assertion(Count > 1).

moved(S, N, Axis, Whole) :-
    findall(From-To,
            ( v(N, V, X, Y, Z),
              v(S, V, X0, Y0, Z0),
              arg(Axis, p(X0,Y0,Z0), From),
              arg(Axis, p(X,Y,Z), To) ),
            Pairs),
    findall(p(F,F,F), member(F-_, Pairs), Own),
    middle(Axis, Own, Middle),
    forall(member(From-To, Pairs),
           assertion(abs(From + 0.75*(Middle-Whole) - To) < 1.0e-9)).

middle(Axis, Points, Middle) :-
    aggregate_all(max(C), ( member(P, Points), arg(Axis, P, C) ), High),
    aggregate_all(min(C), ( member(P, Points), arg(Axis, P, C) ), Low),
    Middle is (Low+High)/2.

:- end_tests(exploded).
