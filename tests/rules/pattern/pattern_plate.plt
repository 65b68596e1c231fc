:- module(test_pattern_plate, []).
% covers: plate_words
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(rules(language), [with_result_language/2]).
:- use_module(rules(store)).
:- use_module(rules(pattern/pattern_plate)).
:- use_module(rules(development/seam_measure), [pattern_area/2]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(unfolding/unfold), [unfold/3]).

% Measures of the faces of a box of 100 x 60 x 20 that are not Removed.
measured(Removed, Options, Measures) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(100,60,20)), S),
               findall(removed(P), member(P, Removed), Wishes),
               append(Wishes, Options, All),
               unfold(S, All, D),
               pattern_area(D, Area),
               plate_measures(D, Area, All, Measures) )).

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

:- begin_tests(pattern_plate).

% One face: 0.1 m x 0.06 m x 0.002 m x 7850 kg/m3; in inches 25.4^3 as much.
test(weight, [forall(member(Unit-Times, [mm-1,cm-1000,inch-16387.064]))]) :-
    measured([top,side(1),side(2),side(3),side(4)],
             [thickness(2),material(steel),unit(Unit)], M),
    assertion(M.bends == []),
    assertion(abs(M.weight/Times - 0.0942) < 1.0e-9).
% A kilogram or so for each decimetre cubed of what workshops have.
test(materials, Weights == [ steel-7850,stainless-7900,aluminium-2700,
                             copper-8960,brass-8500,zinc-7140,titanium-4510
                           ]) :-
    findall(Name-Weight,
            ( material(Name, _),
              measured([top,side(1),side(2),side(3),side(4)],
                       [thickness(1),material(Name),unit(mm)], M),
              Weight is round(M.weight/6.0e-6) ),
            Weights).
test(no_material) :-
    measured([top,side(1),side(2),side(3),side(4)], [thickness(2)], M),
    assertion(\+ get_dict(weight, M, _)).
% A tray has a bend of 90 degrees at each side, all one way; two are longer.
test(tray) :-
    measured([top], [thickness(1),bend_radius(1.5),relief(none)], M),
    findall(bend(Angle,Way,R),
            ( member(B, M.bends),
              _{angle:Angle, direction:Way, radius:R} :< B ),
            Bends0),
    length(Bends0, N),
    sort(Bends0, Bends),
    assertion(N-Bends == 4-[bend(90.0,down,1.5)]),
    findall(L, ( member(B, M.bends), get_dict(length, B, L) ), Ls0),
    msort(Ls0, [L1,_,L3,_]),
    assertion(abs((L3-L1)-40) < 1.0e-9).
test(radius_is_the_thickness) :-
    measured([top,side(2),side(3),side(4)], [thickness(2.5)], M),
    M.bends = [Bend],
    assertion(Bend.radius == 2.5).
% What hangs on the largest face is bent last: of faces in a row, 60, 30 and 10
% wide, wherever the row begins.
test(largest_face_stays, [ forall(member(Faces,
                                         [ [[1,2,4,3],[3,4,6,5],[5,6,8,7]],
                                           [[5,6,8,7],[3,4,6,5],[1,2,4,3]] ])),
                           true(Sequence == [Narrow-1,Wide-2]) ]) :-
    new_world(World),
    in_world(World,
             ( add_primitive(sheet(points([ [0,0,0],[0,100,0],[60,0,0],
                                            [60,100,0],[60,0,30],[60,100,30],
                                            [50,0,30],[50,100,30] ]),
                                   faces(Faces)), S),
               unfold(S, [thickness(1)], D),
               pattern_area(D, Area),
               plate_measures(D, Area, [thickness(1)], M) )),
    once(nth1(Wide, Faces, [1|_])),
    Narrow is 4-Wide,
    findall(Ends-N,
            ( member(B, M.bends),
              N = B.sequence,
              subtract(B.polygons, [2], [Ends]) ),
            Sequence0),
    sort(2, @<, Sequence0, Sequence).
% From the outside in: of a closed box the lid goes before the wall it hangs on.
test(sequence) :-
    measured([], [thickness(1),relief(none)], M),
    findall(N-Ps, ( member(B, M.bends), N = B.sequence, Ps = B.polygons ),
            Numbered0),
    keysort(Numbered0, Numbered),
    pairs_keys_values(Numbered, Ns, [First|Others]),
    assertion(Ns == [1,2,3,4,5]),
    findall(P, ( member(P, First), \+ ( member(O, Others), memberchk(P, O) ) ),
            Lids),
    assertion(Lids = [_]),
    member(P, First),
    \+ memberchk(P, Lids),
    once(( member(Wall, Others), memberchk(P, Wall) )).
test(table, Texts == [ 'B1','90.0\u00B0',down,'2.00','54.00' ]) :-
    Plate = _{bends:[_{fold:7, angle:90.0, direction:down, radius:1.0,
                       length:27.0, sequence:1}], thickness:1, millimetres:2},
    with_result_language(en, bend_table(Plate, [], Marks, W-H)),
    assertion(( W > 0, H > 0 )),
    findall(Y, member(text(_,Y,_,_), Marks), Ys),
    min_list(Ys, Lowest),
    findall(Text, member(text(_,Lowest,_,Text), Marks), Texts).

%   Folds of a torus run round in rings: each has a place in the sequence. That
%   its faces lie on each other is told.

test(sequence_of_rings, [ setup(asserta(( user:message_hook(_, warning, _) :-
                                              true ), Ref)),
                          cleanup(erase(Ref)),
                          Sequence == Numbers ]) :-
    new_world(World),
    in_world(World,
             ( add_primitive(torus(radius(30), tube(9), facets(12), sides(8)),
                             S),
               unfold(S, [thickness(2)], D),
               pattern_area(D, Area),
               plate_measures(D, Area, [thickness(2)], M) )),
    findall(N, ( member(B, M.bends), N = B.sequence ), Sequence0),
    msort(Sequence0, Sequence),
    length(Sequence, Count),
    numlist(1, Count, Numbers).
test(weight_alone, Texts == ['1.50','0.25',steel]) :-
    Plate = _{bends:[], thickness:1.5, material:steel, weight:0.25},
    with_result_language(en, bend_table(Plate, [], Marks, _)),
    findall(Y, member(text(_,Y,_,_), Marks), Ys),
    min_list(Ys, Lowest),
    findall(Text, member(text(_,Lowest,_,Text), Marks), Texts).
test(no_table, fail) :-
    bend_table(_{bends:[], thickness:1}, [], _, _).

:- end_tests(pattern_plate).
