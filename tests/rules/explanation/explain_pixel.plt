:- encoding(utf8).
/* Why a dot of a shaded picture has its colour: against the definition, against
   the bytes of the picture, and against trees whose answers are known. */
:- module(test_explain_pixel, []).
% covers: explain_tree, explain_face, explain_pixel_en, explain_pixel_ko
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(occurs)).
:- use_module(library(plunit)).
:- use_module(rules(csg/csg)).
:- use_module(rules(decision)).
:- use_module(rules(explanation/explain)).
:- use_module(rules(explanation/explain_tree)).
:- use_module(rules(kernel)).
:- use_module(rules(message/explain_pixel_en)).
:- use_module(rules(message/explain_pixel_ko)).
:- use_module(rules(message/explain_words)).
:- use_module(rules(shading/seen)).
:- use_module(rules(picture/view)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(shading/shading_section)).
:- use_module(tests('rules/shading/shaded_model')).

:- meta_predicate in_text(+, 0).

in_text(Text, Goal) :-
    in_model(Text, Goal).

%   A plate with a hole, a ball in the hole, a box under the plate, one that the
%   hole took away, and one that the plate holds.
plate("segment(1, solid, named(plate, difference([2,3]))).
       segment(2, solid, box(size(6,6,2))).
       segment(3, solid, at([translate(0,0,-1)],
                            cylinder(radius(1), height(4), facets(48)))).
       segment(4, solid, at([translate(2,2,-3)], box(size(1,1,1)))).
       segment(5, solid, sphere(radius(0.7), facets(48))).
       segment(6, solid, at([translate(2,0,0.5)], box(size(1,1,1)))).
       segment(7, solid, difference([8,9])).
       segment(8, solid, union([box(size(1,1,1)),
                                at([translate(-5,0,0)], box(size(1,1,1)))])).
       segment(9, solid, union([box(size(2,2,2))])).
       look(2, colour(red)). look(5, colour(blue)).
       view(270, 0, 0).").

options([size(120-120), window(b(-6.0,-6.0,6.0,6.0))]).

%   said(Item, Options, Statement): a statement of its explanation.
said(Item, Options, Statement) :-
    explanation(Item, Options, Because),
    sub_term(Term, Because),
    nonvar(Term),
    Term = because(Statement, _).

statements(Item, Statements) :-
    options(Options),
    plate(Text),
    in_text(Text, findall(Statement, said(Item, Options, Statement),
                          Statements)).

has(Item, Statement) :-
    statements(Item, Statements),
    memberchk(Statement, Statements).

:- begin_tests(explain_pixel).

test(top, true) :-
    statements(pixel(80,40), All),
    memberchk(seen_part(100.0,top,1,2,box,1), All),
    memberchk(operand_of(1,2,difference,1,kept), All),
    memberchk(seen_place(point(X,Y,Z)), All),
    abs(X-2.05) < 0.051,
    abs(Y-1.95) < 0.051,
    abs(Z-2) < 1.0e-9,
    memberchk(look_of(2,red), All),
    memberchk(normal(0.0,0.0,1.0), All).
test(owner,
     Default-ByRule == [not_owner(top,2,2,box)]-[not_owner(top,1,1,box)]) :-
    in_text("segment(1, solid, box(size(4,4,2))).
             segment(2, solid, box(size(2,2,2))).
             segment(3, solid, union([1,2])). view(270, 0, 0).",
            ( owner_said(Default, default),
              assertion(has_here(why_not(seen(2)),
                                 owned_by_face(top,1,1,box,3,default))),
              with_rules("owner(_, Group, Owner) :- lists:last(Group, Owner)."),
              owner_said(ByRule, By),
              assertion(has_here(why_not(seen(2)), seen_after_all(2,_,_,_))),
              no_rules )),
    assertion(By \== default).

owner_said(Others, By) :-
    explanation(pixel(60,40), [size(120-80)], Because),
    sub_term(because(owner(By),Own), Because),
    !,
    findall(Other, member(because(Other,[]), Own), Others).

has_here(Item, Statement) :-
    explanation(Item, [size(120-80)], Because),
    sub_term(Sub, Because),
    subsumes_term(because(Statement,_), Sub),
    !.

test(through_the_hole, true) :-
    statements(pixel(60,60), All),
    memberchk(seen_part(100.0,curved(_),Ball,5,sphere,5), All),
    Ball > 2,
    memberchk(look_of(5,blue), All),
    memberchk(passed(enters,top,2,3,cylinder,_), All),
    memberchk(taken_away(2,difference,1,1), All).
test(hidden_behind, true) :-
    statements(pixel(80,40), All),
    memberchk(hidden_face(top,3,4,box,4,Behind), All),
    abs(Behind-4.0) < 1.0e-6.
test(background, All == [background_part(100.0,white)]) :-
    statements(pixel(1,1), [pixel(1,1,[255,255,255])|All]).
test(edge_has_two_parts, true) :-
    plate(Text),
    Window = [size(119-120), window(b(-6.0,-6.0,6.0,6.0))],
    in_text(Text, ( between(0, 118, X),
                    findall(P, ( said(pixel(X,60), Window, S),
                                 memberchk(S, [seen_part(P,_,_,_,_,_),
                                               background_part(P,_)]) ),
                            Ps),
                    Ps = [_,_|_] )),
    !,
    sum_list(Ps, Sum),
    assertion(abs(Sum-100.0) < 1.0e-9).
test(palette, true) :-
    plate(Text),
    in_text(Text, ( explanation(pixel(80,40), [size(120-120),palette(9)],
                                [because(pixel(_,_,Bytes), Because)]) )),
    memberchk(because(nearest_of_palette(9),[]), Because),
    length(Bytes, 3).
test(dot_by_rule, true) :-
    plate(Text),
    in_text(Text, ( with_rules("pixel_colour(_, _, _, rgb(1,2,3))."),
                    explanation(pixel(80,40), [size(120-120)],
                                [because(pixel(_,_,Bytes), Because)]),
                    no_more_rules )),
    Bytes == [1,2,3],
    memberchk(because(dot_by_rule(_),[]), Because).
test(no_such_dot, All == []) :-
    statements(pixel(120,3), All).
test(no_such_row, All == []) :-
    statements(pixel(3,-1), All).

%   Every dot of which one face shows all: what the picture shows is what the
%   ramp says, and what is seen is what the definition says.
test(bytes_of_the_picture, [forall(shown(Text, Rules, Shade))]) :-
    Options = [size(31-23), shade(Shade)],
    in_text(Text,
            ( with_rules(Rules),
              shaded_scene_of(Options, Scene),
              findall(dot(X,Y),
                      ( between(0, 22, Y), between(0, 30, X),
                        (X + 7*Y) mod 29 =:= 0 ),
                      Dots),
              aggregate_all(count,
                            ( member(dot(X1,Y1), Dots),
                              dot_agrees(X1, Y1, [scene(Scene)|Options],
                                         Scene) ),
                            Whole),
              no_more_rules )),
    assertion(Whole > 3).

dot_agrees(X, Y, Options, Scene) :-
    explanation(pixel(X,Y), Options, [because(pixel(X,Y,Bytes), Parts)]),
    Parts = [because(seen_part(Percent,_,Leaf,_,_,R), Because)],
    Percent =:= 100.0,
    memberchk(because(ramp(_,_,Colour),_), Because),
    maplist_near(Bytes, Colour),
    X1 is X+0.5,
    Y1 is Y+0.5,
    seen_at(Scene, X1, Y1, Seen),
    assertion(Seen = seen(R,Leaf,_)).

%   A table of tones is not as fine as the rule.
maplist_near([], []).
maplist_near([A|As], [B|Bs]) :-
    assertion(abs(A-B) =< 2),
    maplist_near(As, Bs).

shown("segment(1, solid, difference([box(size(4,4,3)),
                                     at([translate(1,1,1)],
                                        sphere(radius(1.5), facets(48)))])).
       light(2, direction(1,2,-3)). light(2, strength(0.3)).
       view(300, 50, 0).", none, Shade) :-
    member(Shade, [lambert,gooch,cel(4),flat]).
shown("segment(1, solid, cylinder(radius(2), height(3), facets(48))).
       view(300, 50, 14). projection(central).", none, lambert).
shown("segment(1, solid, torus(radius(2), tube(0.8), facets(32))).
       view(300, 50, 0).", none, lambert).
shown("segment(1, solid, box(size(4,3,2))). view(300, 50, 0).",
      "surface_look(_, _, top, [colour(green)]).\n\c
       tone(_, vector(X,_,_), T) :- T is (1+X)/2.\n\c
       ramp(L, T, C) :- T1 is 1-T, default(ramp(L, T1, C)).", lambert).
%   Tones that are no numbers, or beyond 0 and 1.
shown("segment(1, solid, box(size(4,3,2))). view(300, 50, 0).",
      "tone(_, vector(X,_,Z), T) :-\n\c
           ( Z > 0.5 -> T = dark ; abs(X) > 0.5 -> T = 3 ; T = -1 ).", lambert).

with_rules(none) :-
    !.
with_rules(Text) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out) ),
        use_rules(File),
        delete_file(File)).

no_more_rules :-
    no_rules.

test(rules_are_named, true) :-
    in_text("segment(1, solid, box(size(4,3,2))). view(300, 50, 0).",
            ( with_rules("ramp(_, _, red)."),
              findall(S, said(pixel(60,44), [size(120-88)], S), All),
              no_rules )),
    memberchk(ramp(lambert,By,[170,0,0]), All),
    By \== default,
    memberchk(tone(_,default), All).

% ---- see-through, cut open -------------------------------------------------

%   A glass box before a red one; light of a dot is the sum of its parts.
glass("segment(1, solid, at([translate(0,0,3)], box(size(4,4,1)))).
       segment(2, solid, at([translate(1,1,0)], sphere(radius(0.9),
                                                       facets(48)))).
       look(1, opacity(0.4)). look(2, colour(red)). look(2, opacity(0.7)).
       view(290, 20, 0).").

test(light_is_the_sum_of_parts, Wrong == []) :-
    glass(Text),
    Options = [size(41-37), background(black)],
    in_text(Text, findall(X-Y-Bytes-Sums,
                          ( between(2, 34, Y), Y mod 7 =:= 0,
                            between(2, 38, X), X mod 7 =:= 1,
                            explanation(pixel(X,Y), Options,
                                        [because(pixel(X,Y,Bytes),Parts)]),
                            Parts = [_,_|_],
                            \+ memberchk(because(background_part(_,_),_),
                                         Parts),
                            sums(Parts, [0,0,0], Sums),
                            \+ near_light(Bytes, Sums) ),
                          Wrong)).
test(layers_of_glass, Ps == [40.0,25.2,24.0,7.56]) :-
    glass(Text),
    Options = [size(41-37), window(b(-6.0,-6.0,6.0,6.0))],
    in_text(Text, said_parts(pixel(24,14), Options, Ps, Statements)),
    memberchk(see_through(0.4), Statements),
    memberchk(lets_through(1), Statements).

% A ball is seen through a box that may not hide it: the line of sight passes
% the box, and why.
test(seen_through_by_a_rule, Said == [seen(2),let_through(1),hidden(none)]) :-
    in_text("segment(1, solid, box(size(4,4,4))).
             segment(2, solid, at([translate(0,0,2)],
                                  sphere(radius(1),facets(24)))).
             view(270, 90, 0).",
            setup_call_cleanup(
                ( tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
                  write(Out, "may_hide(S, T) :- S \\== 1, \c
                              default(may_hide(S, T))."),
                  close(Out),
                  use_rules(File) ),
                ( explanation(pixel(20,20), [size(41-41)], Because),
                  explanation(why_not(seen(2)), [size(41-41)], WhyNot) ),
                delete_file(File))),
    findall(R, ( sub_term(T, Because), nonvar(T),
                 T = seen_part(_,_,_,_,_,R) ), [Seen|_]),
    (   sub_term(let_through(Through,_), Because)
    ->  true
    ;   Through = none
    ),
    (   sub_term(hidden_by_leaf(_,_,_,_), WhyNot)
    ->  Hidden = some
    ;   Hidden = none
    ),
    Said = [seen(Seen),let_through(Through),hidden(Hidden)].

said_parts(Item, Options, Ps, Statements) :-
    explanation(Item, Options, Because),
    findall(S, ( sub_term(T, Because), nonvar(T), T = because(S,_) ),
            Statements),
    findall(P-Z, ( member(seen_part(P0,_,L,_,_,_), Statements), Z = L,
                   P is round(P0*1000)/1000.0 ), Ps0),
    findall(P, member(P-_, Ps0), Ps).

sums([], Sums, Sums).
sums([because(seen_part(P,_,_,_,_,_),Because)|Parts], [R0,G0,B0], Sums) :-
    memberchk(because(ramp(_,_,[R1,G1,B1]),_), Because),
    maplist(srgb_light, [R1,G1,B1], [R2,G2,B2]),
    R is R0+P/100*R2, G is G0+P/100*G2, B is B0+P/100*B2,
    sums(Parts, [R,G,B], Sums).

%   The ends of edges and bent faces have a tone of their own in each piece.
near_light(Bytes, Sums) :-
    maplist(srgb_light, Bytes, Light),
    maplist(near_part, Light, Sums).

near_part(A, B) :-
    abs(A-B) =< 0.02*65535.

test(cut_open, true) :-
    in_text("segment(1, solid, difference([box(size(4,4,4)),
                                           at([translate(1,1,1)],
                                              box(size(1,1,1)))])).
             look(1, shine(0.5, 4)). view(270, 90, 0).",
            ( shaded_model([1], Model0),
              sectioned_model([plane(0,-1,0,1)], Model0, Model),
              current_view(Theta, Phi, Rho, Kind),
              shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye),
              shaded_picture(Model, Eye, [size(40-40)], Scene),
              said_parts(pixel(8,8), [scene(Scene)], Ps, All),
              said_parts(pixel(28,24), [scene(Scene)], _, Pit),
              tree_way(Scene, 1, Way) )),
    Ps == [100.0],
    memberchk(seen_part(_,section,_,0,section,1), All),
    memberchk(hatched, All),
    memberchk(shine(0.5,4,_), All),
    memberchk(cut_away(1), All),
    Way == [operand(1,2,difference,1)],
    memberchk(taken_away(2,difference,1,1), Pit).

% ---- why nothing is seen ---------------------------------------------------

test(under_the_plate, nondet) :-
    has(why_not(seen(4)), hidden_by_leaf(1,2,box,1)).
test(inside_the_plate, nondet) :-       % another root, so it is hidden by it
    has(why_not(seen(6)), hidden_by_leaf(1,2,box,1)).
test(taken_away, true) :-
    options(Options),
    in_text("segment(1, solid, difference([union([2,box(size(9,1,1))]),3])).
             segment(2, solid, box(size(2,2,2))).
             segment(3, solid, box(size(3,3,3))). view(270, 0, 0).",
            findall(S, said(why_not(seen(2)), Options, S), All)),
    memberchk(unseen(2), All),
    memberchk(taken_away(2,difference,1,1), All).
test(buried, true) :-
    options(Options),
    in_text("segment(1, solid, union([2,3])).
             segment(2, solid, box(size(4,4,4))).
             segment(3, solid, at([translate(0,0,1)], box(size(1,1,1)))).
             view(270, 0, 0).",
            findall(S, said(why_not(seen(3)), Options, S), All)),
    memberchk(buried_in(1), All).
test(seen_after_all, true) :-
    plate(Text0),
    string_concat(Text1, "view(270, 0, 0).", Text0),
    string_concat(Text1, "view(270, 40, 0).", Text),
    options(Options),
    in_text(Text, ( findall(S, said(why_not(seen(3)), Options, S), All),
                    All = [seen_after_all(3,Dots,X,Y)],
                    once(said(pixel(X,Y), Options,
                              seen_part(_,_,_,3,_,_))) )),
    Dots > 10.                          % the wall of the hole
test(out_of_the_picture, All == [unseen(4),out_of_the_picture]) :-
    plate(Text),
    in_text(Text, findall(S, said(why_not(seen(4)),
                                  [size(50-50), window(b(7.0,7.0,8.0,8.0))],
                                  S), All)).
test(surface, All = [unseen(1),unseen_where(_,_,_),
                     hidden_by_leaf(2,2,box,2)]) :-
    in_text("segment(1, surface, rectangle(size(1,1))).
             segment(2, solid, box(size(1,1,1))).",
            findall(S, said(why_not(seen(1)), [size(50-50)], S), All)).
test(curve, All == [not_in_picture(1,curve)]) :-
    in_text("segment(1, curve, line(from(0,0,0),to(1,1,1))).
             segment(2, solid, box(size(1,1,1))).",
            findall(S, said(why_not(seen(1)), [size(50-50)], S), All)).
test(no_such_segment, All == []) :-
    statements(why_not(seen(77)), All).

% ---- trees -----------------------------------------------------------------

test(way_of_placed_nodes, Ways == [
         [operand(1,2,intersection,3),placed(2),operand(2,2,difference,1)],
         [operand(1,2,difference,1)]]) :-
    in_text("segment(1, solid, difference([box(size(4,4,4)),2])).
             segment(2, solid, at([translate(0,0,1)], 3)).
             segment(3, solid, split(4, plane(0,0,1,-0.5), below)).
             segment(4, solid, sphere(radius(1), facets(24))).
             view(270, 0, 0).",
            ( shaded_scene_of([size(20-20)], Scene),
              findall(Way, ( member(Place, [2,1]),
                             tree_way(Scene, Place, Way) ), Ways) )).
test(way_of_hollow, Ways == [[operand(1,2,difference,0)],
                             [operand(2,2,difference,0)]]) :-
    in_text("segment(1, solid, hollow_cylinder(radius(2), inner(1), height(1),
                                               facets(24))).
             view(270, 0, 0).",
            ( shaded_scene_of([size(20-20)], Scene),
              findall(Way, ( member(Place, [1,2]),
                             tree_way(Scene, Place, Way) ), Ways) )).

%   A reason is `true` just where the definition sees the solid begin.
test(reason_is_the_definition, Wrong == []) :-
    plate(Text),
    options(Options),
    in_text(Text,
            ( shaded_scene_of(Options, Scene),
              findall(X-Y,
                      ( between(1, 40, I), X is 3*I-1.3,
                        between(1, 9, J), Y is 13*J-0.4,
                        \+ agrees(Scene, X, Y) ),
                      Wrong) )).

agrees(Scene, X, Y) :-
    (   seen_at(Scene, X, Y, seen(R,Leaf,_))
    ->  true
    ;   R = none
    ),
    met(Scene, X, Y, Groups),
    first(Groups, [], Scene, First),
    (   First = R-Mets
    ->  once(( member(met(Place,_,_), Mets),
               scene_place(Scene, place(Place,R,Leaf)) ))
    ;   First == none,
        R == none
    ).

first([], _, _, none).
first([group(_,Mets)|Groups], In0, Scene, First) :-
    foldl_toggled(Mets, In0, In),
    (   scene_root(Scene, root(R,_)),
        false_reason(Scene, R, In, true)
    ->  First = R-Mets
    ;   first(Groups, In, Scene, First)
    ).

foldl_toggled([], In, In).
foldl_toggled([met(Place,_,_)|Mets], In0, In) :-
    (   selectchk(Place, In0, In1)
    ->  true
    ;   In1 = [Place|In0]
    ),
    foldl_toggled(Mets, In1, In).

% ---- both languages --------------------------------------------------------

test(each_language_says_all, Unsaid == []) :-
    findall(Rule-Name,
            ( member(Module-Rule, [sg_explain_pixel_en-pixel_statement_en,
                                   sg_explain_pixel_ko-pixel_statement_ko]),
              Head =.. [Rule,Statement,_,_],
              clause(sg_explain_pixel_en:pixel_statement_en(Said,_,_), _),
              functor(Said, Name, Arity),
              statement_keys(Name, Keys),
              length(Keys, Arity),
              functor(Statement, Name, Arity),
              \+ clause(Module:Head, _) ),
            Unsaid).

:- end_tests(explain_pixel).
