:- module(sg_problem_sheet,
          [ problem_sheets/3            % +File, +Folder, +Options
          ]).
:- use_module('../about', [said_about/2]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../drawing/drawing', [write_drawing/2]).
:- use_module('../language', [with_result_language/2]).
:- use_module('../model/model', [load_model/2]).
:- use_module('../model/model_text', [place_error/2]).
:- use_module('../output', [when_written/1, writing/3]).
:- use_module('../pattern/pattern_file', [write_pattern/4]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../sheet/sheet_paper', [paper/3]).
:- use_module('../sheet/sheet_view', [view_named/2]).
:- use_module('../sheet/sheet_words', [pupil_word/3]).
:- use_module('../store',
              [segment/3, facts_snapshot/1, in_world/2, new_world/1]).
:- use_module('../unrolling/true_table', [true_length_rows/2]).
:- use_module(problem_drawing, [answer_drawing/6, question_drawing/3]).
:- use_module(problem_file, [problems_read/3]).
:- use_module(problem_item, [drawn_views/2, item_views/3, pupil_fields/1]).
:- use_module(problem_key, [loop_count/2, pattern_key/2, problem_key/8]).
:- use_module(problem_loop, [whole_chains/1]).
:- use_module(problem_measure,
              [ measure_marks/5, measure_rank/4, measure_shown/4,
                measure_there/1, measured/5
              ]).
:- use_module(problem_pattern, [with_patterns/4]).
:- use_module(problem_plane,
              [auxiliary_planes/3, planes_points/3, straight_lines/3]).
:- use_module(problem_point,
              [branch_generators/3, generator/4, numbered_points/3]).
:- use_module(problem_text, [sheet_called/3, task_lines/5]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(filesex), [directory_file_path/3, make_directory_path/1]).
:- use_module(library(http/json), [json_write_dict/3]).
:- use_module(library(lists),
              [append/2, append/3, last/2, list_to_set/2, member/2, nth0/3,
               nth1/3, select/3, subtract/3]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(yall), [(>>)/4]).
/** <module> Problem sheets for a class: questions, answers, and a key.

Of each problem of a file (problem_file.pl) and each of its variants are made

    NAME-N-question.svg         the given views, without the penetration line
    NAME-N-answer.svg           with it, the numbered points, the construction
    NAME-N-development-S.svg    the pattern of segment S, if it is asked for
    NAME-N-key.json             what was asked, computed from the model
    list.csv                    which variant has which sizes
    pupils.csv                  who has which variant, if there are pupils

The key is asked of the model as the answers are: nothing in it is typed. So the
question can be given to anybody: nothing of it was made from the line.
*/

%!  problem_sheets(+File, +Folder, +Options:list) is det.
%
%   Make the sheets of the problems of File in Folder. Options: format(Format)
%   (`svg`), angle(Angle) (`first` or `third`; else as the file says, or
%   `third`), language(Language) of the texts (`en`).
%
%   @error model_error(What): those of problems_read/3 and of models

problem_sheets(File, Folder, Options) :-
    problems_read(File, Problems, Pupils),
    make_directory_path(Folder),
    file_directory_name(File, Base),
    findall(Line,
            ( member(Problem, Problems),
              Problem = problem(Name, _, _, Variants, _, _),
              nth1(N, Variants, Settings),
              variant_made(Base, Folder, Problem, N, Settings, Options),
              list_line(Name, N, Settings, Line) ),
            Lines),
    list_written(Folder, 'list.csv',
                 ['number,problem,variant,parameters'|Lines]),
    (   Pupils == []
    ->  true
    ;   pupil_lines(Pupils, Problems, Dealt),
        list_written(Folder, 'pupils.csv', Dealt)
    ).

list_written(Folder, Local, Lines) :-
    directory_file_path(Folder, Local, File),
    writing(File, text, sg_problem_sheet:lines_written(Lines)),
    when_written(print_message(informational, sanggwan(wrote(File)))).

lines_written(Lines, Stream) :-
    forall(member(Line, Lines), format(Stream, '~w~n', [Line])).

%   pupil_lines(Pupils, Problems, Lines): each pupil has a variant of each
%   problem, the next one another.

pupil_lines(Pupils, Problems, [Head|Lines]) :-
    findall(Name, member(problem(Name,_,_,_,_,_), Problems), Names),
    atomic_list_concat([pupil|Names], ',', Head),
    findall(Line,
            ( nth0(I, Pupils, Pupil),
              csv_field(Pupil, Field),
              findall(Number, ( member(Problem, Problems),
                                dealt(I, Problem, Number) ),
                      Numbers),
              atomic_list_concat([Field|Numbers], ',', Line) ),
            Lines).

dealt(I, problem(Name,_,_,Variants,_,_), Number) :-
    length(Variants, Count),
    N is I mod Count + 1,
    format(atom(Number), '~w-~w', [Name,N]).

csv_field(Text, Field) :-
    (   sub_atom(Text, _, 1, _, Char),
        memberchk(Char, [',','"','\n'])
    ->  atomic_list_concat(Parts, '"', Text),
        atomic_list_concat(Parts, '""', Doubled),
        format(atom(Field), '"~w"', [Doubled])
    ;   Field = Text
    ).

list_line(Name, N, Settings, Line) :-
    findall(Text,
            ( member(Parameter=Value, Settings),
              format(atom(Text), '~w=~w', [Parameter,Value]) ),
            Texts),
    atomic_list_concat(Texts, ' ', All),
    format(atom(Line), '~w-~w,~w,~w,~w', [Name,N,Name,N,All]).

variant_made(Base, Folder, problem(Name,Model,Items,_,Sheet,Place), N,
             Settings, Options) :-
    directory_file_path(Base, Model, Path),
    format(atom(Number), '~w-~w', [Name,N]),
    new_world(World),
    catch(said_about(Number,
                     in_world(World,
                              sg_problem_sheet:variant_in_world(
                                  Path, Settings, Number, Items, Sheet,
                                  Folder, Options))),
          error(Formal, Context),
          variant_error(Formal, Context, Number, Place)),
    !.
variant_made(_, _, problem(Name,_,_,_,_,_), N, _, _) :-
    throw(error(system_error(problem(Name, N)), _)).

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

variant_in_world(Path, Settings, Number, Items, Sheet, Folder, Options) :-
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
    option(format(Format), Options, svg),
    questioned(Tasks, Questions),
    task_request(question, Number, Questions, Items, Request,
                 QuestionRequest),
    item_views(Items, Names, Blank),
    (   memberchk(show(penetration), Items)
    ->  Met = Names
    ;   Met = []
    ),
    question_drawing([blank(Blank),met(Met)|QuestionRequest], Letters,
                     Question),
    drawn(Question, Folder, Number, question, Format),
    findall(Pattern-Marks,
            ( member(ask(develop(S)), Items),
              developed(S, Count, Options, Folder, Number, Pattern, Marks) ),
            Developed),
    findall(Pattern, member(Pattern-_, Developed), Patterns),
    light_lines(Items, Branch, Count, Points, Developed, Letters, Generators,
                Marked),
    answered(Tasks, Count, Points, Chains, Measures, Answers),
    task_request(answer, Number, Answers, Items, Request, AnswerRequest),
    drawn_views(Items, Drawn),
    answer_drawing([met(Drawn)|AnswerRequest], Generators, Planes, Points,
                   Marked, Answer),
    drawn(Answer, Folder, Number, answer, Format),
    problem_key(Number, Settings, Items, Chains, Points-Planes, Measures,
                Patterns, Key),
    file_of(Folder, Number, key, json, KeyFile),
    writing(KeyFile, text, sg_problem_sheet:key_written(Key)).

key_written(Key, Stream) :-
    json_write_dict(Stream, Key, [width(78)]),
    nl(Stream).

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

file_of(Folder, Number, What, Format, File) :-
    format(atom(Local), '~w-~w.~w', [Number,What,Format]),
    directory_file_path(Folder, Local, File).

drawn(Drawing, Folder, Number, What, Format) :-
    file_of(Folder, Number, What, Format, File),
    write_drawing(File, [drawing(Drawing),title(Number)]).

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

%   developed(S, N, Options, Folder, Number, Pattern, Marks): the pattern of
%   segment S, trimmed by the others, with N generators, on a sheet and as part
%   of the key; Marks are rolled(S, Part, Number, Degrees) of its generators.

developed(S, N, Options, Folder, Number, _{segment:S, parts:Parts}, Marks) :-
    option(format(Format), Options, svg),
    option(language(Language), Options, en),
    format(atom(What), 'development-~w', [S]),
    file_of(Folder, Number, What, Format, File),
    with_patterns(S, [generators(N)], Ds,
                  ( with_result_language(Language,
                                         write_pattern(File, Ds, [], _)),
                    findall(Part, ( member(D, Ds), pattern_key(D, Part) ),
                            Parts),
                    findall(Mark, ( member(D, Ds), rolled(S, D, Mark) ),
                            Marks) )).

rolled(S, D, rolled(S, Part, Number, Degrees)) :-
    segment(D, _, true_development(_, Part)),
    true_length_rows(D, Rows),
    member(row(Number,Degrees,_,_,_,_,_,_,_), Rows).

%   light_lines(Items, Branch, N, Points, Developed, Letters, Generators,
%   Marked): the generators of Branch that Points lie on, unless planes cut it
%   in them; if there are no points, those of the patterns, with their numbers
%   at their lower ends among Marked.

light_lines(_, _, _, [], Developed, Letters, Generators, Marked) :-
    !,
    findall(generator(Number, Degrees, From, To),
            ( member(_-Marks, Developed),
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
