:- module(sg_problem_file,
          [ problems_read/2             % +File, -Problems
          ]).
:- use_module('../model/model_text', [next_term/3, place_error/2]).
:- use_module('../sheet/sheet_paper', [paper/3]).
:- use_module('../text_file', [with_text/4]).
:- use_module(problem_item, [item_fault/3, items_fault/2]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> Files of problems for a class.

A file of problems is data, as a model file. It has

    problem(Name, Model, Items)         Model: a file, beside this one
    variant(Name, Parameter, Values)    of its model (`param(Parameter, _)`)
    sheet(Paper, Names, Items)          on what paper these problems stand

with the Items of a problem

    given([front, top, ...])    the views
    blank(View)                 one of which the question has the frame alone
    branch(S)                   whose generators are drawn; without it the last
                                segment
    generators(N)               how many: 12
    planes(Axis)                auxiliary planes through the points, square to
                                x, y or z; planes(straight): that cut in
                                generators
    planes(Axis, N)             N of them, whose points are to be found
    edges(all)                  those of facets too, of what is a polyhedron
    ask(draw(penetration))      what is asked: the lines, how many loops there
    ask(count(loops))           are, the pattern of segment S
    ask(develop(S))
    ask(measure(What, Unit, Tolerance))    see problem_measure.pl
    part(S, Language, Text)     what segment S is called
    text(Language, Text)        the question, instead of our words

and those of a sheet angle(first), or angle(third), and title_block(Item, Text).
*/

%!  problems_read(+File, -Problems:list) is det.
%
%   Problems are problem(Name, Model, Items, Variants, Sheet, Place) in the
%   order of File: Variants is a list of lists Parameter=Value, one of each
%   variant; Sheet is sheet(Paper, Items); Place is for place_error/2.
%
%   @error model_error(problem(What)): fact(Name, Arity), item(Item), model(M),
%   paper(Paper), values(Values), twice(Name), no_problem(Name), no_sheet(Name),
%   variable, measure(M), unit(M, Unit, Units), tolerance(M, T), all_blank,
%   no_view(M, Names); and those of model_text.pl

problems_read(File, Problems) :-
    with_text(facts, File, Text, rows_read(Text, Rows)),
    forall(member(Row-Place, Rows), checked_row(Row, Place)),
    forall(append(Before, [problem(Name,_,_)-Place|_], Rows),
           (   memberchk(problem(Name,_,_)-_, Before)
           ->  place_error(Place, problem(twice(Name)))
           ;   true
           )),
    forall(( member(Row-Place, Rows), names_problem(Row, Name) ),
           (   memberchk(problem(Name,_,_)-_, Rows)
           ->  true
           ;   place_error(Place, problem(no_problem(Name)))
           )),
    findall(problem(Name, Model, Items, Variants, Sheet, Place),
            ( member(problem(Name,Model,Items)-Place, Rows),
              variants(Name, Rows, Variants),
              sheet_of(Name, Rows, Place, Sheet) ),
            Problems).

rows_read(Text, Rows) :-
    next_term(Text, Fact, Place),
    (   Fact == end_of_file
    ->  Rows = []
    ;   \+ ground(Fact)
    ->  place_error(Place, problem(variable))
    ;   Rows = [Fact-Place|Rows1],
        rows_read(Text, Rows1)
    ).

names_problem(variant(Name, _, _), Name).
names_problem(sheet(_, Names, _), Name) :-
    member(Name, Names).

%   variants(Name, Rows, Variants): each value of one parameter with each of the
%   others; one without settings if nothing varies.

variants(Name, Rows, Variants) :-
    findall(Parameter-Values,
            member(variant(Name,Parameter,Values)-_, Rows),
            Ranges),
    findall(Settings, chosen(Ranges, Settings), Variants).

chosen([], []).
chosen([Parameter-Values|Ranges], [Parameter=Value|Settings]) :-
    member(Value, Values),
    chosen(Ranges, Settings).

sheet_of(Name, Rows, Place, Sheet) :-
    (   member(sheet(Paper,Names,Items)-_, Rows),
        memberchk(Name, Names)
    ->  Sheet = sheet(Paper, Items)
    ;   place_error(Place, problem(no_sheet(Name)))
    ).

checked_row(problem(Name, Model, Items), Place) :-
    !,
    (   atom(Name),
        atom(Model)
    ->  true
    ;   place_error(Place, problem(model(Model)))
    ),
    items_checked(Items, problem, Place).
checked_row(variant(_, Parameter, Values), Place) :-
    !,
    (   atom(Parameter),
        is_list(Values),
        Values = [_|_],
        maplist(number, Values)
    ->  true
    ;   place_error(Place, problem(values(Values)))
    ).
checked_row(sheet(Paper, Names, Items), Place) :-
    !,
    (   atom(Paper),
        paper(Paper, _, _)
    ->  true
    ;   place_error(Place, problem(paper(Paper)))
    ),
    (   is_list(Names)
    ->  true
    ;   place_error(Place, problem(no_problem(Names)))
    ),
    items_checked(Items, sheet, Place).
checked_row(Row, Place) :-
    functor(Row, Name, Arity),
    place_error(Place, problem(fact(Name, Arity))).

items_checked(Items, Kind, Place) :-
    (   is_list(Items)
    ->  forall(( member(Item, Items), item_fault(Kind, Item, What) ),
               place_error(Place, problem(What)))
    ;   place_error(Place, problem(item(Items)))
    ),
    (   Kind == problem,
        items_fault(Items, What1)
    ->  place_error(Place, problem(What1))
    ;   true
    ).
