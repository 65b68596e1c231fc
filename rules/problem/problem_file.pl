:- module(sg_problem_file,
          [ problems_read/3             % +File, -Problems, -Pupils
          ]).
:- use_module('../generator', [generated/2, generator_fault/3]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../model/model_text', [next_term/5, place_error/2]).
:- use_module('../sheet/sheet_paper', [paper/3]).
:- use_module('../text_file', [with_text/4]).
:- use_module(problem_item, [item_fault/3, items_fault/2, title_items/2]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2, nth1/3]).
:- use_module(library(pairs), [pairs_values/2]).
:- use_module(library(sha), [sha_hash/3]).
:- use_module(library(solution_sequences), [limit/2]).
/** <module> Files of problems for a class.

A file of problems is data, as a model file. It has

    problem(Name, Model, Items)         Model: a file, beside this one
    variant(Name, Parameter, Values)    of its model (`param(Parameter, _)`)
    variant(Name, Parameter in Values, seed(N))
                                        in an order that N alone determines
    sheet(Paper, Names, Items)          on what paper these problems stand
    pupils(Names)                       who gets the sheets

with Values a list of numbers, Low..High or between(Low, High, Step),

with the Items of a problem

    given([front, top, ...])    the views
    blank(View)                 one of which the question has the frame alone
    hide(penetration)           the question is without the lines in which the
    show(penetration)           bodies meet, as is usual; or it has them
    branch(S)                   whose generators are drawn; without it the last
                                segment
    generators(N)               how many: 12
    planes(Axis)                auxiliary planes through the points, square to
                                x, y or z; planes(straight): that cut in
                                generators
    planes(Axis, N)             N of them, whose points are to be found
    edges(all)                  those of facets too, of what is a polyhedron
    ask(draw(penetration))      what is asked: the lines, in all views, or in
    ask(draw(penetration, Views))   these; how many loops there are; the pattern
    ask(count(loops))           of segment S
    ask(develop(S))
    ask(measure(What, Unit, Tolerance))    see problem_measure.pl
    part(S, Language, Text)     what segment S is called
    text(Language, Text)        the question, instead of our words

and those of a sheet angle(first), or angle(third), title_block(Item, Text), and
title_block(Words), fields for a pupil to fill in. One item need not be a list.
*/

%   The module that terms are read in: with the operators of variants.

:- set_module(sg_problem_syntax:base(system)).
:- set_prolog_flag(sg_problem_syntax:double_quotes, string).
:- op(700, xfx, sg_problem_syntax:in).
:- op(450, xfx, sg_problem_syntax:(..)).

%!  problems_read(+File, -Problems:list, -Pupils:list) is det.
%
%   Problems are problem(Name, Model, Items, Variants, Sheet, Place) in the
%   order of File: Variants is a list of lists Parameter=Value, one of each
%   variant; Sheet is sheet(Paper, Items); Place is for place_error/2. Pupils
%   are atoms.
%
%   @error model_error(problem(What)): fact(Name, Arity), item(Item), model(M),
%   paper(Paper), values(Values), seed(Seed), pupils(Names), twice(Name),
%   no_problem(Name), no_sheet(Name), variable, measure(M),
%   unit(M, Unit, Units), tolerance(M, T), all_blank, no_view(M, Names),
%   not_given(Name, Names), shown_and_asked; and those of model_text.pl

problems_read(File, Problems, Pupils) :-
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
              variants(Name, Rows, Place, Variants),
              sheet_of(Name, Rows, Place, Sheet) ),
            Problems),
    findall(Names, member(pupils(Names)-_, Rows), Lists),
    append(Lists, Pupils).

rows_read(Text, Rows) :-
    next_term(Text, sg_problem_syntax, Term, Names, Place),
    (   Term == end_of_file
    ->  Rows = []
    ;   row_of(Term, Names, Place, Row),
        (   ground(Row)
        ->  true
        ;   place_error(Place, problem(variable))
        ),
        Rows = [Row-Place|Rows1],
        rows_read(Text, Rows1)
    ).

%   row_of(Term, Names, Place, Row): variants are drawn(Name, Parameter, Values,
%   Seed), with Seed `none` where Values stay in their order. `R in ...` is of
%   the parameter r.

row_of(variant(Name, in(Parameter0, Source), Seed), Names, Place, Row) :-
    !,
    (   var(Parameter0),
        member(Written=V, Names),
        V == Parameter0
    ->  downcase_atom(Written, Parameter)
    ;   Parameter = Parameter0
    ),
    values(Source, Place, Values),
    (   nonvar(Seed),
        Seed = seed(N),
        integer(N)
    ->  Row = drawn(Name, Parameter, Values, N)
    ;   place_error(Place, problem(seed(Seed)))
    ).
row_of(variant(Name, Parameter, Source), _, Place, Row) :-
    !,
    values(Source, Place, Values),
    Row = drawn(Name, Parameter, Values, none).
row_of(problem(Name, Model, Items0), _, _, Row) :-
    is_list(Items0),
    !,
    maplist(item_of, Items0, Items),
    Row = problem(Name, Model, Items).
row_of(sheet(Paper, Names, Items0), _, _, Row) :-
    callable(Items0),
    !,
    (   is_list(Items0)
    ->  Items1 = Items0
    ;   Items1 = [Items0]
    ),
    maplist(title_items, Items1, Lists),
    append(Lists, Items),
    Row = sheet(Paper, Names, Items).
row_of(Row, _, _, Row).

%   item_of(Item0, Item): a text may be written as a string.

item_of(Item0, Item) :-
    (   compound(Item0),
        Item0 = text(Language, Text0),
        string(Text0)
    ->  atom_string(Text, Text0),
        Item = text(Language, Text)
    ;   compound(Item0),
        Item0 = part(S, Language, Text0),
        string(Text0)
    ->  atom_string(Text, Text0),
        Item = part(S, Language, Text)
    ;   Item = Item0
    ).

%   values(Source, Place, Values)

values(Source, Place, Values) :-
    (   \+ ground(Source)
    ->  place_error(Place, problem(variable))
    ;   \+ generator_fault([in(V, Source)], V, _),
        limit_value(variants, Most),
        Enough is Most+1,
        catch(findall(V, limit(Enough, generated([in(V, Source)], '.')),
                      Values0),
              generator_error(Why), not_too_many(Why, Place)),
        Values0 = [_|_],
        few_enough([Values0], Place),
        maplist(number, Values0)
    ->  Values = Values0
    ;   place_error(Place, problem(values(Source)))
    ).

%   not_too_many(Why, Place) fails: what else is wrong is told by the values.

not_too_many(Why, Place) :-
    Why = limit(_, _, _),
    place_error(Place, Why).

%   few_enough(Lists, Place): one of each of Lists makes no more variants than a
%   problem may have.

few_enough(Lists, Place) :-
    limit_value(variants, Most),
    foldl(times_length, Lists, 1, N),
    (   N =< Most
    ->  true
    ;   place_error(Place, limit(variants, Most))
    ).

times_length(List, N0, N) :-
    length(List, Length),
    N is N0*Length.

names_problem(drawn(Name, _, _, _), Name).
names_problem(sheet(_, Names, _), Name) :-
    member(Name, Names).

%   variants(Name, Rows, Place, Variants): each value of one parameter with each
%   of the
%   others; one without settings if nothing varies. If there is a seed, their
%   order is as drawn.

variants(Name, Rows, Place, Variants) :-
    findall(Parameter-Values,
            member(drawn(Name,Parameter,Values,_)-_, Rows),
            Ranges),
    pairs_values(Ranges, Lists),
    few_enough(Lists, Place),
    findall(Settings, chosen(Ranges, Settings), Variants0),
    findall(Seed,
            ( member(drawn(Name,_,_,Seed)-_, Rows), Seed \== none ),
            Seeds),
    (   Seeds == []
    ->  Variants = Variants0
    ;   drawn_order(Seeds, Name, Variants0, Variants)
    ).

chosen([], []).
chosen([Parameter-Values|Ranges], [Parameter=Value|Settings]) :-
    member(Value, Values),
    chosen(Ranges, Settings).

%   drawn_order(Seeds, Name, Variants0, Variants): by digests, so it is the same
%   on every machine.

drawn_order(Seeds, Name, Variants0, Variants) :-
    findall(Digest-Settings,
            ( nth1(I, Variants0, Settings),
              format(string(Text), '~q', [drawn(Seeds,Name,I)]),
              sha_hash(Text, Digest, [algorithm(sha256),encoding(utf8)]) ),
            Keyed0),
    keysort(Keyed0, Keyed),
    pairs_values(Keyed, Variants).

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
checked_row(drawn(_, Parameter, _, _), Place) :-
    !,
    (   atom(Parameter)
    ->  true
    ;   place_error(Place, problem(values(Parameter)))
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
checked_row(pupils(Names), Place) :-
    !,
    (   is_list(Names),
        Names = [_|_],
        maplist(atom, Names),
        sort(Names, Each),
        length(Names, N),
        length(Each, N)
    ->  true
    ;   place_error(Place, problem(pupils(Names)))
    ).
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
