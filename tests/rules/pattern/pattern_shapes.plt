/* Patterns of many shapes on paper: no tab lies on a face or on another tab, no
   piece on another, nothing is cut twice. */
:- module(test_pattern_shapes, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(store)).
:- use_module(rules(csg/csg_roots), [roots_alone/0]).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(pattern/pattern_drawing),
              [ pattern_drawing/3, pattern_layout/3 ]).
:- use_module(tests('rules/pattern/cut_checked')).
:- use_module(tests('rules/sample')).

shape(cube, box(size(40,40,40))).
shape(cone, cone(radius(20),height(50),facets(24))).
shape(oblique_cone, cone(radius(20),height(50),facets(24),shift(20,5))).
shape(cylinder, cylinder(radius(20),height(60),facets(24))).
shape(hollow, hollow_cylinder(radius(30),inner(20),height(50),facets(24))).
shape(uv_sphere, sphere(radius(50),facets(24),bands(12))).
shape(small_sphere, sphere(radius(20),facets(32),bands(16))).
shape(torus, torus(radius(40),tube(15),facets(24),sides(12))).

curve(fine_cylinder, cylinder(radius(20),height(30),facets(96))).
curve(fine_cone, cone(radius(20),height(50),facets(120))).
curve(fine_sphere, sphere(radius(20),facets(48),bands(24))).
curve(fine_hollow,
      hollow_cylinder(radius(30),inner(20),height(50),facets(72))).

:- meta_predicate quietly(0).

quietly(Goal) :-
    setup_call_cleanup(
        asserta((user:message_hook(_, Kind, _) :-
                     memberchk(Kind, [warning,informational,silent])), Ref),
        Goal,
        erase(Ref)).

of_term(Term, Options, Drawings) :-
    new_world(World),
    in_world(World,
             ( loaded(Term),
               develop(1, D),
               quietly(pattern_drawing([D], Options, Drawings)) )).

loaded(Term) :-
    tmp_file_stream(File, Out, [extension(pl)]),
    format(Out, 'segment(1, solid, ~q).~n', [Term]),
    close(Out),
    load_model(File).

no_fault(Name, Drawings) :-
    forall(( nth1(I, Drawings, Drawing), once(cut_fault(Drawing, Fault)) ),
           ( print_message(error, format("~w, sheet ~w: ~q", [Name,I,Fault])),
             fail )).

%   The scale with which a model is about 150 mm large.
model_scale(Scale) :-
    findall(C, ( v(_, _, X, Y, Z), member(C, [X,Y,Z]) ), Cs),
    max_list(Cs, High),
    min_list(Cs, Low),
    Scale is 150/(High-Low).

model_file(File) :-
    member(Folder, ['facts/figures','facts/gallery','facts/patterns']),
    absolute_file_name(sanggwan(Folder), Path, [file_type(directory)]),
    atom_concat(Path, '/*.pl', Pattern),
    expand_file_name(Pattern, Files),
    member(File, Files).

of_file(File, Drawings) :-
    new_world(World),
    in_world(World,
             quietly(( load_model(File),
                       roots_alone,
                       findall(S, ( segment(S, Kind, _),
                                    memberchk(Kind, [solid,surface]),
                                    \+ many_faces(S) ), Ss),
                       Ss \== [],
                       model_scale(Scale),
                       findall(D, ( member(S, Ss), develop(S, D) ), Ds),
                       pattern_drawing(Ds, [page('A3'),tabs(5),scale(Scale)],
                                       Drawings) ))).

many_faces(S) :-
    few(150, 1500, Many),
    findall(x, limit(Many, p(S,_,_)), Xs),
    length(Xs, Many).

%   seams(Lengths, Pieces): one piece with a seam of each of Lengths.

seams(Lengths, [piece(name(1,1,0),[],Sides)]) :-
    findall(side(0,1,a-(0.0-0.0),b-(Length-0.0),seam(J,90.0,1)),
            nth1(J, Lengths, Length),
            Sides).

%   band_side(Faces, Side): of a band of faces 10 mm wide; every other fold is
%   flat, and shorter.

band_side(Faces, side(0,P,a-(X0-Y),b-(X0-0.0),fold(P0,Angle,2))) :-
    member(P-(X0-_), Faces),
    P > 1,
    P0 is P-1,
    band_fold(P0, Angle, Y).
band_side(Faces, side(0,P,a-(X1-0.0),b-(X1-Y),fold(P,Angle,1))) :-
    member(P-(_-X1), Faces),
    P < 8,
    band_fold(P, Angle, Y).
band_side(_, side(0,1,a-(0.0-5.0),b-(0.0-0.0),seam(99,10.0,1))).
band_side(_, side(0,8,a-(80.0-0.0),b-(80.0-5.0),seam(99,10.0,2))).

band_fold(J, Angle, Length) :-
    (   J mod 2 =:= 1
    ->  Angle = 0.0,
        Length = 5.0
    ;   Angle = 20.0,
        Length is 6.0 + abs(J-4)
    ).

% How many sides have tabs, and how many seams have none.
tab_counts(Term, Options, Tabs, Butt) :-
    tabs_told(Term, Options, Tabs, Butt, _).

:- dynamic told_before/5.

%   tabs_told(Term, Options, Tabs, Butt, Noticed): laid out once, however many
%   tests ask.

tabs_told(Term, Options, Tabs, Butt, Noticed) :-
    told_before(Term, Options, Tabs, Butt, Noticed),
    !.
tabs_told(Term, Options, Tabs, Butt, Noticed) :-
    retractall(noticed(_)),
    quietly(setup_call_cleanup(
        asserta((user:message_hook(sanggwan(pattern(What)), _, _) :-
                     assertz(test_pattern_shapes:noticed(What))), Ref),
        tabs_laid(Term, Options, Tabs, Butt),
        erase(Ref))),
    findall(What, noticed(What), Noticed),
    assertz(told_before(Term, Options, Tabs, Butt, Noticed)).

tabs_laid(Term, Options, Tabs, Butt) :-
    new_world(World),
    in_world(World,
             ( loaded(Term),
               develop(1, D),
               pattern_layout([D], Options, layout(_,_,_,_,Tabs0,Butt0)) )),
    assoc_to_keys(Tabs0, TabKeys),
    assoc_to_keys(Butt0, ButtKeys),
    length(TabKeys, Tabs),
    length(ButtKeys, Butt).

opened(Name, Term) :-
    member(Term, [ sphere(radius(50),facets(24),bands(12)),
                   cone(radius(40),height(80),facets(48)),
                   sphere(radius(200),facets(48),bands(24)),
                   torus(radius(60),tube(20),facets(36),sides(18)) ]),
    functor(Term, Name, _).

%   told(Term, Options, Told): the notices about tabs; of seams without one how
%   many there are, their share in hundredths of a per cent, what would help and
%   how many edges are named.

:- dynamic noticed/1.

told(Term, Options, Told) :-
    tabs_told(Term, Options, _, _, Noticed),
    findall(Notice, ( member(What, Noticed), notice(What, Notice) ), Told).

notice(opened_by_itself(N0,N), opened_by_itself(N0,N)).
notice(opened(N0,N), opened(N0,N)).
notice(without_tab(_,N,Share,Whys,Help,Es),
       without_tab(N,Parts,Whys,Help,Count)) :-
    Parts is round(100*Share),
    length(Es, Count).

:- begin_tests(pattern_shapes).

test(on_pages, [ forall(shared(1, 4, shape(Name,Term))) ]) :-
    of_term(Term, [page('A4'),tabs(6)], Drawings),
    assertion(no_fault(Name, Drawings)).
test(wide_tabs, [ forall(shared(2, 4, shape(Name,Term))) ]) :-
    of_term(Term, [tabs(25)], Drawings),
    assertion(no_fault(Name, Drawings)).
test(inside, [ forall(shared(3, 4, shape(Name,Term))) ]) :-
    of_term(Term, [tabs(6),inside(true),gap(1)], Drawings),
    assertion(no_fault(Name, Drawings)).
test(open_slits, [ forall(shared(4, 4, shape(Name,Term))) ]) :-
    of_term(Term, [page('A3'),tabs(6),open_slits(true)], Drawings),
    assertion(no_fault(Name, Drawings)).
test(curves, [ forall(sampled([Name,Width],
                              ( curve(Name,Term),
                                member(Width, [2,6,15]) ))) ]) :-
    of_term(Term, [tabs(Width)], Drawings),
    assertion(no_fault(Name, Drawings)).

% Where slits are too narrow, near the equator, joints are butt.
test(most_seams_have_tabs, [ true(2*Butt < Tabs) ]) :-
    tab_counts(sphere(radius(50),facets(24),bands(12)),
               [tabs(6),open_slits(false)], Tabs, Butt).
% As is usual: a quarter of the seam of one sphere would be without tabs, so it
% is parted; a twentieth of the other's, which stays whole. Seams too short for
% tabs have none among parts either.
test(slits_open_by_themselves,
     [ forall(sampled([Name,Same],
                      ( member(Term-Width-Same,
                               [ sphere(radius(50),facets(24),bands(12))-6-true,
                                 box(size(40,30,20))-5-false,
                                 sphere(radius(100),facets(24),bands(12))-6-
                                     false,
                                 sphere(radius(6),facets(48),bands(24))-6-false
                               ]),
                        functor(Term, Name, _) ))),
       true(Auto == Other) ]) :-
    tab_counts(Term, [tabs(Width)], T1, B1),
    Auto = T1-B1,
    tab_counts(Term, [tabs(Width),open_slits(Same)], T2, B2),
    Other = T2-B2.
% Six slits, each opened by one fold: the longest are opened first, those of 3
% mm whatever else, others until enough of the seam has tabs, but never those of
% less than 1 mm.
test(worth_cutting, [ Cuts == [[1-9,1-8,1-7],[1-9,1-8,1-7,1-6],
                               [1-9,1-8,1-7,1-6,1-5],
                               [1-9,1-8,1-7,1-6,1-5]] ]) :-
    findall(Less-cut(1,J), ( member(J-Gain, [9-5000,8-4000,7-3000,6-2000,
                                             5-1000,4-999]),
                             Less is -Gain ), Ranked),
    findall(Some,
            ( member(Need, [12000,12001,14001,99999]),
              sg_pattern_slit:worth_cutting(Ranked, worth(3000,1000,Need), Some)
            ),
            Cuts).
% A band of four squares, each of them two triangles, with a slit between the
% first and the last: it is parted between squares, not across them.
test(flat_faces_stay_whole, [ Parts == [[1,2,3,4],[5,6,7,8]] ]) :-
    findall(P-(X0-X1),
            ( between(1, 8, P), X0 is (P-1)*10.0, X1 is P*10.0 ),
            Faces0),
    findall(Side, band_side(Faces0, Side), Sides),
    findall(face(P,[]), member(P-_, Faces0), Faces),
    list_to_assoc([(1-99)-x], Butt),
    sg_pattern_slit:opened_slits(worth(1,1,0), 0.5,
                                 [piece(name(1,1,0),Faces,Sides)], Butt,
                                 Opened),
    findall(Ps, ( member(piece(_,Own,_), Opened),
                  findall(P, member(face(P,_), Own), Ps) ), Parts).
% Seams that parting adds make the share of those without tabs smaller, and are
% no gain.
test(worth_it, [ Worth == [auto(10-9),auto(10-10),auto(30-15),true(10-9),
                           true(11-10.5),true(30-15),true(30-16)] ]) :-
    list_to_assoc([(1-2)-x], Butt),
    findall(Found,
            ( member(Open, [auto,true]),
              member(Before-After, [10-9,10-10,11-10.5,30-15,30-16]),
              With is 100-Before,
              seams([With,Before], Pieces0),
              seams([150,After], Pieces),
              sg_pattern_fit:is_worth_it(Open, Pieces0-tabs(t,Butt),
                                         Pieces-tabs(t,Butt)),
              Found =.. [Open,Before-After] ),
            Worth).
% Each pattern by itself.
test(one_of_two_is_parted, [ Counts == [23,1] ]) :-
    new_world(World),
    in_world(World,
             ( maplist(add_primitive,
                       [ sphere(radius(50),facets(48),bands(24)),
                         sphere(radius(400),facets(24),bands(12)) ],
                       Ss),
               complete_segments,
               maplist(develop, Ss, Ds),
               quietly(pattern_layout(Ds, [tabs(5)], layout(_,_,Sheets,_,_,_)))
             )),
    findall(N, ( member(D, Ds),
                 aggregate_all(count,
                               ( member(Laid, Sheets),
                                 member(laid(piece(name(D,_,_),_,_),_,_), Laid)
                               ),
                               N) ),
            Counts).
% More than a tenth of the seam in slits, less after it is parted; not more is
% parted than that takes.
test(told_how_many_have_none, [ Told == [opened_by_itself(1,23),
                                         without_tab(47,620,[slit-47],
                                                     open_slits,47)] ]) :-
    told(sphere(radius(50),facets(48),bands(24)), [tabs(5)], Told).
test(told_what_helps, [ Told == [without_tab(472,3199,[short-233,slit-239],
                                             open_slits,472)] ]) :-
    told(sphere(radius(50),facets(48),bands(24)),
         [tabs(5),open_slits(false)], Told).
% A ball of 12 mm: by 51 parts more half of its seams still had none, for they
% are too short, so it stays whole.
test(told_too_short, [ Told == [without_tab(1016,8912,[short-1016],none,
                                            1016)] ]) :-
    told(sphere(radius(6),facets(48),bands(24)), [tabs(6)], Told).
test(told_nothing, [ Told == [] ]) :-
    told(box(size(40,30,20)), [tabs(5)], Told).
test(open_slits_have_tabs, [ true(Butt == 0),
                             forall(sampled([Name],
                                            opened(Name, Term))) ]) :-
    tab_counts(Term, [tabs(6),open_slits(true)], _, Butt).
% A cube of 1 mm, and a U whose seams without a tab are too short for one, in
% slits or not: what gains no tab is not parted.
test(no_parts_without_tabs,
     [ forall(member(Term, [ box(size(1,1,1)),
                             prism(outline([[0,0],[9,0],[9,9],[8,9],[8,1],[1,1],
                                            [1,9],[0,9]]), height(2)) ])),
       true(Told == Whole) ]) :-
    told(Term, [tabs(5),open_slits(true)], Told),
    told(Term, [tabs(5),open_slits(false)], Whole).
% 1.3 mm each: no tabs of their own.
test(facets_share_tabs, [ true(4*Butt < Tabs) ]) :-
    tab_counts(cylinder(radius(20),height(30),facets(96)), [tabs(6)], Tabs,
               Butt).
test(facets_share_tabs_in_parts, [ true(Butt == 0) ]) :-
    tab_counts(cylinder(radius(20),height(30),facets(96)),
               [tabs(6),open_slits(true)], _, Butt).

% The checker does find what is wrong.
test(checker, [ Found == [crossing(b,a),inside(b,a),off(b),twice(0-0,9-0)] ]) :-
    Square = [0-0,9000-0,9000-9000,0-9000,0-0],
    Inner = [1000-1000,2000-1000,2000-2000,1000-1000],
    Over = [8000-8000,20000-8000,20000-20000,8000-8000],
    faults([a-Square,b-Over], 30000, F1),
    faults([a-Square,b-Inner], 30000, F2),
    faults([a-Square,b-Over], 15000, F3),
    faults([a-[0-0,9-0,9-9,0-0],b-[9-0,0-0,0-(-9),9-0]], 30000, F4),
    first([F1,F2,F3,F4], [crossing(_,_),inside(_,_),off(_),twice(_,_)],
          Found).

test(gallery, [ forall(model_file(File)) ]) :-
    (   of_file(File, Drawings)
    ->  assertion(no_fault(File, Drawings))
    ;   format("skipped: ~w~n", [File])
    ).

faults(Pieces, Side, Faults) :-
    findall(view(Name,[stroke(visible,cut,1,[],Points,ring,ring)],[]),
            member(Name-Points, Pieces), Views),
    findall(Fault, cut_fault(drawing(sheet(Side,Side,1),Views), Fault),
            Faults).

first(Faultss, Kinds, Found) :-
    maplist([Faults,Kind,Kind]>>memberchk(Kind, Faults), Faultss, Kinds,
            Found).

:- end_tests(pattern_shapes).
