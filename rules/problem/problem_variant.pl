:- module(sg_problem_variant,
          [ with_variant/5,             % +Base, +Problem, +N, +Options, :Goal
            variant_number/3,           % +Problem, +N, -Number
            dealt/3,                    % +I, +Problem, -N
            variant_question/2,         % +Variant, -Drawing
            variant_answered/3,         % +Variant, -Measures, -Answers
            variant_answer/4,           % +Variant, +Marks, +Answers, -Drawing
            pattern_marks/3             % +S, +Ds, -Marks
          ]).
:- use_module('../about', [said_about/2]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../model/model', [load_model/2]).
:- use_module('../model/model_text', [place_error/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../sheet/sheet_paper', [paper/3]).
:- use_module('../sheet/sheet_view', [view_named/2]).
:- use_module('../sheet/sheet_words', [pupil_word/3]).
:- use_module('../store',
              [segment/3, facts_snapshot/1, in_world/2, new_world/1]).
:- use_module('../unrolling/true_table', [true_length_rows/2]).
:- use_module(problem_drawing, [answer_drawing/6, question_drawing/3]).
:- use_module(problem_item, [drawn_views/2, item_views/3, pupil_fields/1]).
:- use_module(problem_key, [loop_count/2]).
:- use_module(problem_loop, [whole_chains/1]).
:- use_module(problem_measure,
              [ measure_marks/5, measure_rank/4, measure_shown/4,
                measure_there/1, measured/5
              ]).
:- use_module(problem_plane,
              [auxiliary_planes/3, planes_points/3, straight_lines/3]).
:- use_module(problem_point,
              [branch_generators/3, generator/4, numbered_points/3]).
:- use_module(problem_text, [sheet_called/3, task_lines/5]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(filesex), [directory_file_path/3]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, list_to_set/2, member/2, nth0/3,
                nth1/3, select/3, subtract/3 ]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(yall), [(>>)/4]).
/** <module> One variant of a problem: what is asked of it, and what is true.

A variant is

    variant(Number, Settings, Items, Asked, Found, Request)

with Asked = asked(Branch, Count, Tasks, Letters): Tasks are
task(Ask, Letters, Rank) as in problem_text.pl; Found = found(Points, Planes,
Chains), of the model as it meets itself, which no question shows.
*/

:- meta_predicate with_variant(+, +, +, +, 1).

%!  with_variant(+Base, +Problem, +N, +Options:list, :Goal) is det.
%
%   Call call(Goal, Variant) once, of variant N of Problem (problem_file.pl), in
%   a world of its own. Its model is in the folder Base. What is said meanwhile
%   is about its number. Options as of problem_sheets/3.
%
%   @error model_error(problem(of(Number, Formal))): what cannot be made of it

with_variant(Base, Problem, N, Options, Goal) :-
    Problem = problem(Name,_,_,_,_,Place),
    variant_number(Problem, N, Number),
    new_world(World),
    (   catch(said_about(Number,
                         in_world(World,
                                  sg_problem_variant:variant_used(
                                      Base, Problem, N, Options, Goal))),
              error(Formal, Context),
              variant_error(Formal, Context, Number, Place))
    ->  true
    ;   throw(error(system_error(problem(Name, N)), _))
    ).

%   variant_error(Formal, Context, Number, Place): what cannot be made of the
%   model is wrong with the problem at Place.

variant_error(Formal, Context, Number, Place) :-
    (   var(Context),
        nonvar(Formal),
        of_problem(Formal)
    ->  place_error(Place, problem(of(Number, Formal)))
    ;   throw(error(Formal, Context))
    ).

of_problem(model_error(_)).
of_problem(geometry_error(_)).
of_problem(usage_error(sheet(_))).
of_problem(usage_error(parameter(_))).

%!  variant_number(+Problem, +N, -Number:atom) is det.
%
%   Number is what variant N of Problem is called on its sheets.

variant_number(problem(Name,_,_,_,_,_), N, Number) :-
    format(atom(Number), '~w-~w', [Name,N]).

%!  dealt(+I, +Problem, -N) is det.
%
%   The pupil with I others before him has variant N of Problem: the next one
%   has another.

dealt(I, problem(_,_,_,Variants,_,_), N) :-
    length(Variants, Count),
    N is I mod Count + 1.

:- public variant_used/5.

variant_used(Base, problem(Name,Model,Items,Variants,Sheet,_), N, Options,
             Goal) :-
    directory_file_path(Base, Model, Path),
    nth1(N, Variants, Settings),
    variant_number(problem(Name,_,_,_,_,_), N, Number),
    Variant = variant(Number,Settings,Items,asked(Branch,Count,Tasks,Letters),
                      found(Points,Planes,Chains),Request),
    load_model(Path, [parameters(Settings)]),
    roots_alone,
    parts_there(Items),
    branch(Items, Branch),
    option(generators(Count), Items, 12),
    facts_snapshot(( penetrate(all, []),
                     points(Items, Branch, Count, Points),
                     whole_chains(Chains) )),
    planes(Items, Points, Planes),
    findall(Task, task(Items, Count, Points, Task), Tasks0),
    lettered(Tasks0, Tasks, Letters),
    request(Items, Sheet, Options, Request),
    call(Goal, Variant).

%!  variant_question(+Variant, -Drawing) is det.
%
%   Drawing is what a pupil gets, in the world of Variant.

variant_question(variant(Number,_,Items,asked(_,_,Tasks,Letters),_,Request),
                 Drawing) :-
    questioned(Tasks, Questions),
    task_request(question, Number, Questions, Items, Request,
                 QuestionRequest),
    item_views(Items, Names, Blank),
    (   memberchk(show(penetration), Items)
    ->  Met = Names
    ;   Met = []
    ),
    question_drawing([blank(Blank),met(Met)|QuestionRequest], Letters,
                     Drawing).

%!  variant_answered(+Variant, -Measures, -Answers) is det.
%
%   Answers are the tasks with their answers (problem_text.pl); Measures is a
%   list of Measure-Value, in units of the model.

variant_answered(variant(_,_,_,asked(_,Count,Tasks,_),
                         found(Points,_,Chains),_),
                 Measures, Answers) :-
    answered(Tasks, Count, Points, Chains, Measures, Answers).

%!  variant_answer(+Variant, +Marks, +Answers, -Drawing) is det.
%
%   Drawing has the answers, with their construction. Marks are those of
%   pattern_marks/3, a list of them for each pattern that is asked for.

variant_answer(variant(Number,_,Items,asked(Branch,Count,_,Letters),
                       found(Points,Planes,_),Request),
               Marks, Answers, Drawing) :-
    light_lines(Items, Branch, Count, Points, Marks, Letters, Generators,
                Marked),
    task_request(answer, Number, Answers, Items, Request, AnswerRequest),
    drawn_views(Items, Drawn),
    answer_drawing([met(Drawn)|AnswerRequest], Generators, Planes, Points,
                   Marked, Drawing).

%   points(Items, Branch, Count, Points): of the planes that have points of
%   their own, or else of the branch.

points(Items, Branch, Count, Points) :-
    (   memberchk(planes(Axis, N), Items)
    ->  planes_points(Axis, N, Points)
    ;   numbered_points(Branch, Count, Points)
    ).

planes(Items, Points, Planes) :-
    (   ( memberchk(planes(Axis, _), Items)
        ; memberchk(planes(Axis), Items)
        ),
        Axis \== straight
    ->  auxiliary_planes(Axis, Points, Planes)
    ;   Planes = []
    ).

%   parts_there(Items): what Items name is in the model.

parts_there(Items) :-
    forall(( member(Item, Items),
             ( Item = branch(S) ; Item = part(S,_,_) ; Item = ask(develop(S)) ),
             \+ segment(S, _, _) ),
           throw(error(model_error(problem(no_segment(S))), _))),
    forall(( member(ask(develop(S)), Items), segment(S, curve, _) ),
           throw(error(model_error(problem(no_pattern(S))), _))),
    forall(member(ask(measure(Measure,_,_)), Items),
           measure_there(Measure)).

branch(Items, Branch) :-
    (   memberchk(branch(S), Items)
    ->  Branch = S
    ;   findall(S, segment(S, _, _), Ss0),
        sort(Ss0, Ss),
        last(Ss, Branch)
    ).

%   request(Items, Sheet, Options, Request): for seen_drawing/3.

request(Items, sheet(Paper,SheetItems), Options,
        [ paper(Width,Height), views(Views), sections([]), angle(Angle),
          scale(standard), unit(1.0), frame(true), hidden(usual),
          picture(Picture), language(Language), facts(Facts)
        ]) :-
    paper(Paper, Width, Height),
    item_views(Items, Names, _),
    maplist(view_named, Names, Views),
    option(angle(Usual), SheetItems, third),
    option(angle(Angle), Options, Usual),
    option(language(Language), Options, en),
    (   memberchk(edges(all), Items)
    ->  Picture = [lines(all)]
    ;   Picture = []
    ),
    findall(Item-String,
            ( member(title_block(Item, Said), SheetItems),
              atom_string(Said, String) ),
            Own),
    pupil_fields(Fields),
    findall(label(Field)-Label,
            ( member(fields(Words), SheetItems),
              nth1(I, Words, Word),
              nth1(I, Fields, Field),
              pupil_word(Word, Language, Label) ),
            Labels),
    append([language-Language|Labels], Own, Facts).


                /*******************************
                *            TASKS             *
                *******************************/

%   task(Items, Count, Points, Task) is nondet: Task is task(Ask, Places, Rank)
%   with the places of measure_marks/5.

task(Items, Count, Points, task(Ask, Places, Rank)) :-
    item_views(Items, Names, Blank),
    subtract(Names, Blank, Shown),
    member(Ask, Items),
    ( Ask = ask(_) ; Ask = blank(_) ),
    (   Ask = ask(measure(Measure,_,_))
    ->  measure_marks(Measure, Count, Points, Shown, Places),
        (   measure_rank(Measure, Points, Number, Of)
        ->  Rank = Number-Of
        ;   Rank = none
        )
    ;   Places = [],
        Rank = none
    ).

%   lettered(Tasks0, Tasks, Letters): each place, with the views it is marked
%   in, has one letter.

lettered(Tasks0, Tasks, Letters) :-
    findall(Place, ( member(task(_,Places,_), Tasks0), member(Place, Places) ),
            All0),
    list_to_set(All0, All),
    findall(letter(Text,P,Names),
            ( nth0(I, All, place(P,Names)), letter_text(I, Text) ),
            Letters),
    maplist(task_letters(Letters), Tasks0, Tasks).

letter_text(I, Text) :-
    Letter is 0'A + I mod 26,
    Row is I // 26,
    (   Row =:= 0
    ->  format(atom(Text), '~c', [Letter])
    ;   format(atom(Text), '~c~d', [Letter,Row])
    ).

task_letters(Letters, task(Ask,Places,Rank), task(Ask,Text,Rank)) :-
    findall(Letter,
            ( member(place(P,Names), Places),
              memberchk(letter(Letter,P,Names), Letters) ),
            Own),
    atomic_list_concat(Own, Text).

questioned(Tasks, Questions) :-
    maplist([task(Ask,Text,Rank),task(Ask,Text,Rank,none)]>>true, Tasks,
            Questions).

%   answered(Tasks, Count, Points, Chains, Measures, Answers): Measures is a
%   list of Measure-Value.

answered(Tasks, Count, Points, Chains, Measures, Answers) :-
    findall(Measure-Value,
            ( member(task(ask(measure(Measure,_,Tolerance)),_,_), Tasks),
              measured(Measure, Tolerance, Count, Points, Value) ),
            Measures),
    maplist(task_answered(Measures, Chains), Tasks, Answers).

task_answered(Measures, Chains, task(Ask,Text,Rank),
              task(Ask,Text,Rank,Answer)) :-
    (   Ask = ask(measure(Measure,Unit,Tolerance))
    ->  memberchk(Measure-Value, Measures),
        measure_shown(Value, Unit, Tolerance, Answer)
    ;   Ask == ask(count(loops))
    ->  loop_count(Chains, Answer)
    ;   Answer = none
    ).

%   task_request(Kind, Number, Tasks, Items, Request0, Request): with the words
%   of Tasks, left of the title block if they fit there, and what the sheet is
%   called in that.

task_request(Kind, Number, Tasks, Items, Request0,
             [question(Lines),facts(Facts)|Request]) :-
    select(facts(Facts0), Request0, Request),
    option(paper(Paper,_), Request),
    option(language(Language), Request),
    Width is min(Paper-50, max(150, Paper-226)),
    task_lines(Tasks, Items, Language, Width, Lines),
    atom_string(Number, NumberText),
    sheet_called(Kind, Language, Called),
    string_concat(NumberText, Called, Name),
    append(Facts0, [number-NumberText,name-Name], Facts).


                /*******************************
                *           PATTERNS           *
                *******************************/

%!  pattern_marks(+S, +Ds, -Marks) is det.
%
%   Marks are rolled(S, Part, Number, Degrees) of the generators of the patterns
%   Ds of segment S.

pattern_marks(S, Ds, Marks) :-
    findall(Mark, ( member(D, Ds), rolled(S, D, Mark) ), Marks).

rolled(S, D, rolled(S, Part, Number, Degrees)) :-
    segment(D, _, true_development(_, Part)),
    true_length_rows(D, Rows),
    member(row(Number,Degrees,_,_,_,_,_,_,_), Rows).

%   light_lines(Items, Branch, N, Points, Developed, Letters, Generators,
%   Marked): Developed are the marks of patterns. The generators of Branch that
%   Points lie on, unless planes cut it
%   in them; if there are no points, those of the patterns, with their numbers
%   at their lower ends among Marked.

light_lines(_, _, _, [], Developed, Letters, Generators, Marked) :-
    !,
    findall(generator(Number, Degrees, From, To),
            ( member(Marks, Developed),
              list_to_set(Marks, Each),
              member(rolled(S, Part, Number, Degrees), Each),
              placed_surface(S, Part, Surface),
              generator(Surface, Degrees, From, To) ),
            Generators),
    findall(letter(Number, From, all),
            member(generator(Number,_,From,_), Generators),
            Numbers),
    append([Letters,Numbers], Marked).
light_lines(Items, _, _, _, _, Letters, [], Letters) :-
    ( Item = planes(Axis) ; Item = planes(Axis, _) ),
    memberchk(Item, Items),
    Axis \== straight,
    !.
light_lines(Items, Branch, N, Points, _, Letters, Generators, Letters) :-
    branch_generators(Branch, N, All),
    findall(generator(I, T, From, To),
            ( member(generator(I, T, From, To), All),
              memberchk(point(_, _, T, _), Points) ),
            Own),
    (   memberchk(planes(straight), Items)
    ->  straight_lines(Branch, Points, Lines),
        findall(generator(0, none, From, To), member(From-To, Lines), Others),
        append(Own, Others, Generators)
    ;   Generators = Own
    ).
