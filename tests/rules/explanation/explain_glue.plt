/* What is said of what is glued. */
:- module(test_explain_glue, []).
% covers: explain_glue_en, explain_glue_ko
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(explanation/explain)).
:- use_module(rules(message/explain_glue_en)).
:- use_module(rules(message/explain_glue_ko)).
:- use_module(rules(message/explain_words)).
:- use_module(rules(model/model)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

of(Name, Item, Because) :-
    atomic_list_concat(['facts/figures/glue_',Name,'.pl'], File),
    in_new_world(( load_model(File), explanation(Item, Because) )).

:- begin_tests(explain_glue).

test(shared, Items == [p(8)]) :-
    in_new_world(( load_model('facts/figures/glue_face.pl'),
                   findall(Item, explanation(glued(3, Item), _), Items) )).
test(polygon, Said == [was_polygon(1,2,1),was_polygon(2,1,-1),between(1,2)]) :-
    of(face, glued(3, p(8)), [because(glued_polygon(3, 8), Facts)]),
    findall(Fact, member(because(Fact, []), Facts), Said).

%   Figure 6: five pages, in the order of the paper.

test(pages, Ss == [1,2,3,4,5]) :-
    in_new_world(( load_model('facts/figures/glue_edge.pl'),
                   v(6, A, 0.0, 0.0, 1.0),
                   v(6, B, 0.0, 0.0, 3.0),
                   once(( e(6, E, A, B, _) ; e(6, E, B, A, _) )),
                   explanation(glued(6, e(E)), [because(_, Pages)]) )),
    findall(S, ( member(because(page(_,1), [because(was_polygon(S,_,_), [])]),
                        Pages) ),
            Ss0),
    once(append(Before, [1|After], Ss0)),
    append([1|After], Before, Ss1),
    (   A < B
    ->  Ss = Ss1
    ;   Ss1 = [First|Rest],
        reverse(Rest, Back),
        Ss = [First|Back]
    ).

%   Figure 4: an apex of all, with disks of pyramids and of a wire.

test(vertex, N-Sources == 4-[1,2,3]) :-
    in_new_world(( load_model('facts/figures/glue_vertex.pl'),
                   once(segment(S, cells, _)),
                   v(S, V, 0.0, 0.0, 0.0),
                   explanation(glued(S, v(V)), [because(_, Facts)]) )),
    findall(D, member(because(disk(D,_,_), []), Facts), Ds),
    length(Ds, N),
    findall(S0, member(because(was_vertex(S0,_,0.0), []), Facts), Sources).
test(region, Facts == [inside(1),beyond(2,1,1.0),beyond(3,6,15.0)]) :-
    of(face, region(3, 1), [because(region(3,1,cell,4.0), All)]),
    findall(Fact, ( member(because(Fact, []), All), Fact \= inner_point(_) ),
            Facts).
test(regions, Rs == [1,2,3]) :-
    in_new_world(( load_model('facts/figures/glue_face.pl'),
                   findall(R, explanation(region(3, R), _), Rs) )).

test(is_glued, Statement == is_glued(1,2,2,1)) :-
    of(face, why_not(glued(1-2, 2-p(1))), [because(Statement, _)]).
test(not_glued, Facts == [gap(1.0),plane_angle(0.0)]) :-
    of(face, why_not(glued(1-1, 2-1)), [because(not_glued(1,1,2,1), All)]),
    findall(Fact,
            ( member(because(Fact0, []), All), short(Fact0, Fact) ),
            Facts).
test(in_common, true) :-
    in_new_world(( load_model('facts/figures/glue_face.pl'),
                   explanation(why_not(glued(1-2, 2-3)),
                               [because(not_glued(1,2,2,3), All)]) )),
    memberchk(because(in_common([_,_]), []), All),
    memberchk(because(gap(0.0,_,_), []), All),
    memberchk(because(plane_angle(90.0), []), All).

short(gap(Gap,_,_), gap(Gap)) :-
    !.
short(Fact, Fact).

test(nothing, [ forall(member(Item, [glued(1,v(1)),glued(3,v(99)),region(1,1),
                                     region(3,9),why_not(glued(1-9,2-1)),
                                     why_not(glued(3-1,2-1))])),
                fail ]) :-
    of(face, Item, _).

%   All statements in both languages.

said(glued_vertex(3,1,point(0.0,0.0,1.0))).
said(glued_edge(3,1,2,3)).
said(glued_polygon(3,1)).
said(was_vertex(1,2,0.0)).
said(was_vertex(1,2,0.125)).
said(was_polygon(1,2,1)).
said(was_polygon(1,2,-1)).
said(cut_vertex([1,2])).
said(point_loop(4)).
said(in_region(2)).
said(disk(1,[2,3],[4])).
said(disk(1,[2],[])).
said(disk(1,[],[4])).
said(disks_lie(1,2,Relation,By)) :-
    member(Relation, [disjoint,cover,within,around,cross]),
    member(By, [default,'rules.pl']).
said(page(2,3)).
said(between(1,2)).
said(between(2,2)).
said(inner_loop([7])).
said(inner_loop([7,8])).
said(region(3,1,cell,4.0)).
said(region(3,1,outside,none)).
said(region(3,1,void,1.0)).
said(region(3,1,slit,0.0)).
said(inner_point(point(0.0,0.0,1.0))).
said(inside(2)).
said(beyond(2,3,1.5)).
said(laminar(4)).
said(wire_in(4)).
said(is_glued(1,2,2,1)).
said(not_glued(1,2,2,1)).
said(kept_apart('may_glue/3')).
said(in_common([3])).
said(in_common([3,4])).
said(gap(0.0,point(0.0,0.0,1.0),point(0.0,0.0,1.0))).
said(gap(0.5,point(0.0,0.0,1.0),point(0.0,0.0,1.5))).
said(plane_angle(0.0)).
said(plane_angle(30.0)).

test(statements, forall(said(Statement))) :-
    functor(Statement, Name, N),
    statement_keys(Name, Keys),
    length(Keys, N),
    phrase(glue_statement_en(Statement), English),
    phrase(glue_statement_ko(Statement), Korean),
    English \== Korean,
    English \== [].

%   No other statement has words.

test(all, Names == Said) :-
    findall(Name-N,
            ( member(Rule, [sg_explain_glue_en:glue_statement_en(Of,_,_),
                            sg_explain_glue_ko:glue_statement_ko(Of,_,_)]),
              clause(Rule, _),
              functor(Of, Name, N) ),
            Names0),
    sort(Names0, Names),
    findall(Name-N, ( said(Of), functor(Of, Name, N) ), Said0),
    sort(Said0, Said).

:- end_tests(explain_glue).
