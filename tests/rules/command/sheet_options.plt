/* What options ask for of a sheet, as facts of a request; and what is none. */
:- module(test_sheet_options, []).
:- use_module(library(lists)).
:- use_module(library(option)).
:- use_module(library(plunit)).
:- use_module(rules(command/sheet_options)).
:- use_module(rules(store)).

request(Options, Name, Values) :-
    sheet_request(Options, [], Request),
    member(Term, Request),
    Term =.. [Name|Values],
    !.

names(Options, Names) :-
    request(Options, views, [Views]),
    findall(Name, member(view(Name,_,_,_), Views), Names).

:- meta_predicate refused(0, -).

refused(Goal, What) :-
    catch(( Goal, What = none ), error(usage_error(What), _), true).

facts(Options, Files, Model, Facts) :-
    new_world(World),
    in_world(World,
             ( forall(member(Fact, Model), assert_fact(Fact)),
               request_facts(Options, Files, [], [facts(Facts)]) )).

:- begin_tests(sheet_options).

test(wanted, [ forall(member(Options-Truth,
       [ []-no, [sheet(a4)]-yes, [views(front)]-yes, [section([x])]-yes,
         ['title-block'(f)]-yes, [angle(first)]-yes, ['no-frame'(true)]-yes,
         [scale('1:2')]-no, [view(front),size(a)]-no ])),
               true(Found == Truth) ]) :-
    ( sheet_wanted(Options) -> Found = yes ; Found = no ).
test(usual, Request == [ paper(420,297), angle(third), scale(standard),
                         unit(1.0), frame(true), hidden(usual), sections([]),
                         picture([p]) ]) :-
    sheet_request([], [p], Request0),
    findall(Term, ( member(Term, [ paper(_,_), angle(_), scale(_), unit(_),
                                   frame(_), hidden(_), sections(_),
                                   picture(_) ]),
                    memberchk(Term, Request0) ), Request).
test(said, Request == [ paper(210,297), angle(first), scale(1:2), unit(10.0),
                        frame(false), hidden(removed), sections([x]),
                        points(4) ]) :-
    sheet_request([ sheet('A4'), angle(first), scale('1:2'), unit(cm),
                    'no-frame'(true), hidden(removed), section([x]),
                    points('4') ], [], Request0),
    findall(Term, ( member(Term, [ paper(_,_), angle(_), scale(_), unit(_),
                                   frame(_), hidden(_), sections(_),
                                   points(_) ]),
                    memberchk(Term, Request0) ), Request).
test(together, [ forall(member(Option-What,
       [ size('1x2')-both_options('--size','--sheet'),
         projection(central)-both_options('--projection central','--sheet'),
         projection(parallel)-none ])),
                 true(Found == What) ]) :-
    refused(sheet_request([Option], [], _), Found).

test(views, [ forall(member(Options-Names,
       [ []-[front,top,right,isometric], [views(front)]-[front],
         [views('top, FRONT')]-[top,front], [view(left)]-[left],
         [view('30,40')]-[view], [direction('1,2,3')]-[view] ])),
              true(Found == Names) ]) :-
    names(Options, Found).
test(no_views, [ forall(member(Options-What,
       [ [views(frnt)]-sheet(view("frnt",_)),
         [views('front,front')]-sheet(view_twice(front)),
         [views('iso,isometric')]-sheet(view_twice(_)),
         [views(front),view(top)]-both_options('--views','--view'),
         [views(front),eye('1,2,3')]-both_options('--views','--eye'),
         [view(top),direction('1,2,3')]-both_options('--view','--direction'),
         [target('1,2,3')]-needs_one_of(['--eye']),
         [view(top),target('1,2,3')]-needs_one_of(['--eye']),
         [direction('0,0,0')]-sheet(no_direction('--direction','0,0,0')),
         [direction('1,2')]-bad_value('--direction','1,2','X,Y,Z'),
         [direction('1,2,x')]-bad_value('--direction','1,2,x','X,Y,Z'),
         [eye('1,2')]-bad_value('--eye','1,2','X,Y,Z'),
         [eye('1,2,3'),target('1')]-bad_value('--target','1','X,Y,Z'),
         [view(tpo)]-sheet(no_view(tpo,[top],_)),
         [view('1')]-sheet(no_view('1',_,_)),
         [view('1,2,-1')]-sheet(no_view('1,2,-1',_,_)),
         [view('1,2,3,4')]-sheet(no_view('1,2,3,4',_,_)) ])),
                 true(subsumes_term(What, Found)) ]) :-
    refused(sheet_request(Options, [], _), Found).
test(told, Views == [view(view,30,40,pictorial),view(view,30.5,-4,pictorial),
                     view(view,1,2,pictorial)]) :-
    findall(View, ( member(Text, ['30,40','30.5, -4','1,2,0']),
                    view_told(Text, View) ), Views).
test(looking, Views == [eye([1,2,3],middle),eye([1,2,3],[4,5,6])]) :-
    findall(View,
            ( member(Options, [ [eye('1,2,3')],
                                [eye('1,2,3'),target('4,5,6')] ]),
              looking(Options, View) ),
            Views).
test(not_looking, fail) :-
    looking([scale('1:2')], _).

test(sections, [ forall(member(Text-Truth,
       [ x-yes, 'Y'-yes, 'z=1'-yes, 'x=-1.5'-yes, 'x = 2'-yes, 'x='-no,
         'w=1'-no, 'x=1=2'-no, '1,0,0,5'-yes, '0,0,1,-2.5'-yes,
         '0,0,0,1'-no, '1,2,3'-no, '1,2,3,4,5'-no, '1,2,3,a'-no, ''-no ])),
                 true(Found == Truth) ]) :-
    refused(sheet_request([section([Text])], [], _), What),
    (   What == none
    ->  Found = yes
    ;   assertion(What == sheet(section(Text))),
        Found = no
    ).
test(scales, [ forall(member(Text-Scale,
       [ '1:2'-(1:2), '2.5:1'-(2.5:1), ' 1 : 2 '-(1:2), fit-fit,
         standard-standard, '0:1'-no, '1:0'-no, '-1:2'-no, '1'-no, '1:2:3'-no,
         'a:1'-no, '1e151:1'-no, '1:1e151'-no, '1e149:1'-(1.0e149:1),
         '1:1e149'-(1:1.0e149) ])),
               true(Found == Scale) ]) :-
    refused(request([scale(Text)], scale, [Scale0]), What),
    (   What == none
    ->  Found = Scale0
    ;   assertion(What == sheet(scale(Text))),
        Found = no
    ).
test(scale_of_a_picture, Found == [0.5,5.0,none,none]) :-
    findall(Mm,
            ( member(Options, [ [scale('1:2')], [scale('1:2'),unit(cm)],
                                [scale(fit)], [] ]),
              ( scale_option(Options, Mm0) -> Mm = Mm0 ; Mm = none ) ),
            Found).
test(points, [ forall(member(Text-Most, [ all-all, '8'-8, 8-8, '1'-1, '0'-no,
                                          '-1'-no, '1.5'-no, x-no ])),
               true(Found == Most) ]) :-
    refused(points_wanted([points(Text)], Most0), What),
    ( What == none -> Found = Most0 ; Found = no ).
test(no_paper, What == ['A4','A3','A2','A1','A0']) :-
    refused(sheet_request([sheet(a7)], [], _), sheet(paper(a7, What))).

test(cutaway, [ forall(member(Text-Truth,
                              [x-yes,'z=1'-yes,'1,1,0,2'-yes,q-no])),
                true(Found == Truth) ]) :-
    refused(cutaway_wanted([cutaway(Text),view(front)], Text), What),
    ( What == none -> Found = yes ; What = bad_value('--cutaway',Text,_),
      Found = no ).
test(cutaway_apart, [ forall(member(Option-Name,
       [ sheet(a4)-'--sheet', views(top)-'--views', section([x])-'--section',
         'title-block'(f)-'--title-block', angle(first)-'--angle',
         'no-frame'(true)-'--no-frame', explode(1)-'--explode',
         shade(flat)-'--shade', points(all)-'--points',
         'centre-lines'(true)-'--centre-lines',
         projection(central)-'--projection central' ])),
                      true(What == both_options('--cutaway', Name)) ]) :-
    refused(cutaway_wanted([cutaway(x),Option], _), What).
test(no_cutaway, fail) :-
    cutaway_wanted([view(front)], _).

test(facts, Facts == [language-en,name-"a.b"]) :-
    facts([], ['d/a.b.pl','c.pl'], [], Facts).
test(language, Found == [ko,ko,en]) :-
    findall(Language,
            ( member(Options, [[lang(ko)],[language(ko)],
                               [lang(ko),language(en)]]),
              facts(Options, [], [], [language-Language|_]) ),
            Found).
test(stdin_has_no_name, Facts == [language-en,name-""]) :-
    facts([], [-], [], Facts).
test(model_before_file, Name-Date == "Plate x"-"1 2") :-
    facts([], ['a.pl'],
          [title_block(name,'Plate\nx'),title_block(date,"1\t2")], Facts),
    memberchk(name-Name, Facts),
    memberchk(date-Date, Facts),
    request_title([facts(Facts)], Name).
test(file_before_model, Name == "Lid") :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [extension(pl)]),
          write(Out, "title_block(name, \"Lid\").\n"),
          close(Out) ),
        facts(['title-block'(File)], ['a.pl'], [title_block(name,plate)],
              Facts),
        delete_file(File)),
    memberchk(name-Name, Facts).

:- end_tests(sheet_options).
