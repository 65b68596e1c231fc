:- encoding(utf8).
:- module(test_region_name, []).
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(gluing/region_name)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   glued(Terms, Goal): Goal in a world with the solids Terms, numbered from 1,
%   and their glue 9, in a file that is read after another one with as many
%   segments as Before.

glued(Before, Terms, Facts, Goal) :-
    findall(Text,
            ( nth1(S, Terms, Term),
              format(string(Text), "segment(~d, solid, ~q).~n", [S,Term]) ),
            Texts0),
    length(Terms, N),
    numlist(1, N, Ss),
    format(string(Glue), "segment(9, cells, glue(~w)).~n", [Ss]),
    append(Texts0, [Glue|Facts], Texts),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
        ( forall(member(Text, Texts), write(Out, Text)),
          close(Out),
          findall('facts/cube.pl', between(1, Before, _), Files0),
          append(Files0, [File], Files),
          in_new_world(( load_model(Files), once(Goal) ))
        ),
        delete_file(File)).

three([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
        at([translate(-1,0,0)], box(size(2,1,1))) ]).

names(S, Names) :-
    findall(Name, ( region(S, R, _), region_name(S, R, Name) ), Names).

:- begin_tests(region_name).

test(names, Names == [region([1]),region([1,2]),region([1,3]),region([2]),
                      region([3])]) :-
    three(Terms),
    glued(0, Terms, [], names(9, Names0)),
    sort(Names0, Names).
test(there_and_back) :-
    three(Terms),
    glued(0, Terms, [],
          forall(( region(9, R, Role), Role \== outside ),
                 ( region_name(9, R, Name),
                   region_named(9, Name, Back),
                   Back == R ))).
test(numbered, Names == [region([1,2]),region([1],1),region([1],2),
                         region([2],1),region([2],2)]) :-
    glued(0, [ box(size(3,1,1)), box(size(1,3,1)) ], [], names(9, Names0)),
    sort(Names0, Names).
test(void, Name == region([])) :-
    glued(0, [difference([box(size(3,3,3)),
                          at([translate(0,0,1)], box(size(1,1,1)))])], [],
          ( region(9, R, void),
            region_name(9, R, Name) )).
test(of_several, [fail]) :-
    glued(0, [ box(size(3,1,1)), box(size(1,3,1)) ], [],
          region_named(9, region([1]), _)).
test(outside, [fail]) :-
    glued(0, [box(size(1,1,1))], [],
          ( region(9, R, outside), region_name(9, R, _) )).
test(no_name, [fail, forall(member(Name, [region(1), region([1],0), region([a]),
                                          region([1|_]), x, region([1],1,1),
                                          _]))]) :-
    is_region_name(Name).

%   The numbers in a file are its own.

test(shifted, Names == [region([2,3])]) :-
    glued(1, [ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))) ],
          ["gluing(9, dissolve(region([1]), region([1,2]))).\n",
           "gluing(9, dissolve(region([1,2]), region([2]))).\n"],
          ( segment(S, cells, _),
            names(S, Names) )).

:- end_tests(region_name).
