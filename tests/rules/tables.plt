:- module(test_tables, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(development/bend), [bend_deduction/3]).
:- use_module(rules(drawing/style), [line_style/4, sheet_role/1]).
:- use_module(rules(limits), [limit_value/2]).
:- use_module(rules(near), [tolerance/2]).
:- use_module(rules(sheet/sheet_paper)).
:- use_module(rules(store), [relation_column/5]).

/* Constants that nothing can be computed from stand here a second time. */

:- begin_tests(tables).

test(units, Units == [cm-10.0, inch-25.4, m-1000.0, mm-1.0]) :-
    findall(Unit-Mm, unit_millimetres(Unit, Mm), Units0),
    msort(Units0, Units).

%   ISO 216: the next one is half of it, whole millimetres.

test(papers, Papers == ['A0'-1189-841, 'A1'-841-594, 'A2'-594-420,
                        'A3'-420-297, 'A4'-297-210]) :-
    findall(Name-Long-Short, paper_size(Name, Long, Short), Papers0),
    msort(Papers0, Papers).

%   ISO 128-20: widths are steps of the square root of 2; what is hidden is half
%   as wide as what is seen, and a line of the sheet is thin, but for its frame.

test(widths, Widths == [ arrow-0.5, centre_line-0.25, construction-0.13,
                         cutting-0.25, cutting_end-0.7, field-0.25, frame-0.7,
                         hatching-0.25, shading-0.25, symbol-0.35, text-0.7
                       ]) :-
    findall(Role-Width,
            ( sheet_role(Role),
              Role \== axis,
              drawn_width(visible, Role, Width) ),
            Widths0),
    msort(Widths0, Widths).
test(axis, Width == 0.25) :-
    drawn_width(visible, axis, Width).
test(widths_of_models,
     [ forall(member(Role-Seen-Hidden,
                     [ penetration-0.7-0.35, crease-0.5-0.25, outline-0.5-0.25,
                       border-0.5-0.25, smooth-0.25-0.18, mesh-0.25-0.18 ])),
       true(Widths == [Seen,Hidden]) ]) :-
    findall(Width, ( member(Visibility, [visible,hidden]),
                     drawn_width(Visibility, Role, Width) ),
            Widths).

%   The neutral layer of a plate, without --true, is 0.44 of it from the inside
%   of a bend, whose radius is the plate. Outer lengths.

test(bend_default, [forall(member(Degrees, [30,90,120])),
                    true(abs(Deduction-Wanted) < 1.0e-12)]) :-
    T = 2.0,
    bend_deduction(Degrees, [thickness(T),size(outside)], Deduction),
    Turn is Degrees*pi/180,
    Wanted is 2*(T+T)*tan(Turn/2) - Turn*(T+0.44*T).
test(bend, [forall(( member(K, [0.0,0.33,0.5,1.0]), member(R, [0.5,3.0]) )),
            true(abs(Deduction-Wanted) < 1.0e-12)]) :-
    bend_deduction(90, [thickness(1.0),size(outside),k_factor(K),
                        bend_radius(R)], Deduction),
    Wanted is 2*(R+1.0) - pi/2*(R+K*1.0).

test(limits, Limits == [ blocks-512, clauses-100000, contacts-20000000,
                         depth-128, digits-2000, facets-1000000,
                         fact-16000000, file-16000000, name-65536,
                         nodes-100000, text-500000000, values-10000000,
                         variants-10000 ]) :-
    findall(Name-Most, limit_value(Name, Most), Limits0),
    msort(Limits0, Limits).

%   Each with its reason in rules/near.pl.

test(tolerances, Nears == [ angle-1.0e-6, event-5.0e-8, exact-2.0e-13,
                            fold-0.01, gap-0.001, paper-1.0e-6, place-1.0e-7,
                            rounding-1.0e-9, surface-1.0e-6 ]) :-
    findall(Of-Near, tolerance(Of, Near), Nears0),
    msort(Nears0, Nears).

%   What a model has, as every file and every rule of a user writes it.

test(columns, [ forall(member(Relation-Types,
                              [ v-[int,int,float,float,float],
                                e-[int,int,int,int,int],
                                p-[int,int,list],
                                plane-[int,int,float,float,float,float],
                                t-[int,int,int,int,int,int],
                                segment-[int,atom,term],
                                origin-[int,term,term],
                                line-[int,int,int,int,int,int,int,int,int],
                                view-[float,float,float] ])),
                true(Columns == Types) ]) :-
    findall(Type, relation_column(Relation, _, _, Type, _), Columns).

drawn_width(Visibility, Role, Width) :-
    line_style(Visibility, Role, 1, Style),
    arg(1, Style, Width).

:- end_tests(tables).
