:- module(sg_problem_sheet,
          [ problem_sheets/3            % +File, +Folder, +Options
          ]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../development/seam_measure', [pattern_area/2]).
:- use_module('../drawing/drawing', [write_drawing/2]).
:- use_module('../model/model', [load_model/2]).
:- use_module('../output', [when_written/1, writing/3]).
:- use_module('../pattern/pattern_file', [write_pattern/4]).
:- use_module('../penetration/chain', [chains/1]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../sheet/sheet_paper', [paper/3]).
:- use_module('../sheet/sheet_view', [view_named/2]).
:- use_module('../store',
              [segment/3, facts_snapshot/1, in_world/2, new_world/1]).
:- use_module('../unfolding/unfold',
              [other_parts/3, wanted_of/3, wishes/3]).
:- use_module('../unfolding/unfold_how', [how_wished/3]).
:- use_module('../unfolding/unfold_true', [true_patterns/4]).
:- use_module('../unrolling/true_table', [true_length_rows/2]).
:- use_module(problem_drawing, [answer_drawing/4, question_drawing/2]).
:- use_module(problem_file, [problems_read/2]).
:- use_module(problem_point, [branch_generators/3, numbered_points/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(filesex), [directory_file_path/3, make_directory_path/1]).
:- use_module(library(http/json), [json_write_dict/3]).
:- use_module(library(lists), [last/2, member/2, nth1/3]).
:- use_module(library(option), [option/3]).
/** <module> Problem sheets for a class: questions, answers, and a key.

Of each problem of a file (problem_file.pl) and each of its variants are made

    NAME-N-question.svg         the given views, without the penetration line
    NAME-N-answer.svg           with it, the numbered points, the construction
    NAME-N-development-S.svg    the pattern of segment S, if it is asked for
    NAME-N-key.json             what was asked, computed from the model
    list.csv                    which variant has which sizes

The key is asked of the model as the answers are: nothing in it is typed. So the
question can be given to anybody: nothing of it was made from the line.
*/

%!  problem_sheets(+File, +Folder, +Options:list) is det.
%
%   Make the sheets of the problems of File in Folder. Options: format(Format)
%   (`svg`), angle(Angle) (`first` or `third`; else as the file says, or
%   `third`), language(Language) of the texts (`en`).
%
%   @error model_error(What): those of problems_read/2 and of models

problem_sheets(File, Folder, Options) :-
    problems_read(File, Problems),
    make_directory_path(Folder),
    file_directory_name(File, Base),
    findall(Line,
            ( member(Problem, Problems),
              Problem = problem(Name, _, _, Variants, _),
              nth1(N, Variants, Settings),
              variant_made(Base, Folder, Problem, N, Settings, Options),
              list_line(Name, N, Settings, Line) ),
            Lines),
    directory_file_path(Folder, 'list.csv', List),
    writing(List, text, sg_problem_sheet:lines_written(Lines)),
    when_written(print_message(informational, sanggwan(wrote(List)))).

lines_written(Lines, Stream) :-
    format(Stream, 'number,problem,variant,parameters~n', []),
    forall(member(Line, Lines), format(Stream, '~w~n', [Line])).

list_line(Name, N, Settings, Line) :-
    findall(Text,
            ( member(Parameter=Value, Settings),
              format(atom(Text), '~w=~w', [Parameter,Value]) ),
            Texts),
    atomic_list_concat(Texts, ' ', All),
    format(atom(Line), '~w-~w,~w,~w,~w', [Name,N,Name,N,All]).

variant_made(Base, Folder, problem(Name,Model,Items,_,Sheet), N, Settings,
             Options) :-
    directory_file_path(Base, Model, Path),
    format(atom(Number), '~w-~w', [Name,N]),
    new_world(World),
    in_world(World,
             sg_problem_sheet:variant_in_world(Path, Settings, Number, Items,
                                               Sheet, Folder, Options)).

variant_in_world(Path, Settings, Number, Items, Sheet, Folder, Options) :-
    load_model(Path, [parameters(Settings)]),
    roots_alone,
    request(Number, Items, Sheet, Options, Request),
    option(format(Format), Options, svg),
    question_drawing(Request, Question),
    drawn(Question, Folder, Number, question, Format),
    branch(Items, Branch),
    option(generators(Count), Items, 12),
    branch_generators(Branch, Count, Generators),
    facts_snapshot(( penetrate(all, []),
                     numbered_points(Branch, Count, Points),
                     chains(Chains) )),
    answer_drawing(Request, Generators, Points, Answer),
    drawn(Answer, Folder, Number, answer, Format),
    findall(Pattern,
            ( member(ask(develop(S)), Items),
              developed(S, Count, Folder, Number, Format, Pattern) ),
            Patterns),
    key(Number, Settings, Items, Chains, Points, Patterns, Key),
    file_of(Folder, Number, key, json, KeyFile),
    writing(KeyFile, text, sg_problem_sheet:key_written(Key)).

key_written(Key, Stream) :-
    json_write_dict(Stream, Key, [width(78)]),
    nl(Stream).

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

%   request(Number, Items, Sheet, Options, Request): as sheet_plan.pl has it.

request(Number, Items, sheet(Paper,SheetItems), Options,
        [ paper(Width,Height), views(Views), sections([]), angle(Angle),
          scale(standard), unit(1.0), frame(true), hidden(usual), picture([]),
          question(Lines), facts(Facts)
        ]) :-
    paper(Paper, Width, Height),
    option(given(Names), Items, [front,top]),
    maplist(view_named, Names, Views),
    option(angle(Usual), SheetItems, third),
    option(angle(Angle), Options, Usual),
    option(language(Language), Options, en),
    (   memberchk(text(Language, Text), Items)
    ->  Lines = [Text]
    ;   memberchk(text(_, Text), Items)
    ->  Lines = [Text]
    ;   Lines = []
    ),
    findall(Item-String,
            ( member(title_block(Item, Said), SheetItems),
              atom_string(Said, String) ),
            Own),
    atom_string(Number, NumberText),
    Facts = [language-Language,number-NumberText,name-NumberText|Own].


                /*******************************
                *          THE KEY             *
                *******************************/

%   developed(S, N, Folder, Number, Format, Pattern): the pattern of segment S,
%   trimmed by the others, with N generators, on a sheet and as part of the key.

developed(S, N, Folder, Number, Format, Pattern) :-
    facts_snapshot(sg_problem_sheet:developed_(S, N, Folder, Number, Format,
                                               Pattern)).

developed_(S, N, Folder, Number, Format, _{segment:S, parts:Parts}) :-
    other_parts(S, [], Others),
    (   Others == []
    ->  Trim = []
    ;   Trim = [trim(outside),by(Others)]
    ),
    how_wished(S, [generators(N)|Trim], Options),
    wishes(S, Options, Wishes),
    wanted_of(S, Wishes, Wanted),
    true_patterns(S, Wanted, Options, Ds),
    format(atom(What), 'development-~w', [S]),
    file_of(Folder, Number, What, Format, File),
    write_pattern(File, Ds, [], _),
    findall(Part, ( member(D, Ds), pattern_key(D, Part) ), Parts).

pattern_key(D, _{area:Area, generators:Generators}) :-
    pattern_area(D, Area0),
    rounded(Area0, Area),
    (   segment(D, _, true_development(_, _)),
        true_length_rows(D, Rows)
    ->  findall(_{number:I, degrees:Degrees, length:Length},
                ( member(row(I,Degrees0,_,_,_,Length0,_,_,_), Rows),
                  maplist(rounded, [Degrees0,Length0], [Degrees,Length]) ),
                Generators)
    ;   Generators = []
    ).

%   key(Number, Settings, Items, Chains, Points, Patterns, Key): a dict.

key(Number, Settings, Items, Chains, Points, Patterns,
    _{number:Number, parameters:Parameters, asked:Asked, loops:Loops,
      open_lines:Open, points:PointsOut, developments:Patterns}) :-
    findall(Name-Value, member(Name=Value, Settings), Pairs),
    dict_pairs(Parameters, _, Pairs),
    findall(Text,
            ( member(ask(What), Items), format(atom(Text), '~w', [What]) ),
            Asked),
    findall(C, ( member(C, Chains), C = chain(_, _, closed, _) ), Closed),
    length(Closed, Loops),
    findall(C, ( member(C, Chains), C = chain(_, _, open, _) ), Opens),
    length(Opens, Open),
    findall(_{number:I, loop:Loop, degrees:Degrees, x:X, y:Y, z:Z},
            ( member(point(I,Loop,T,p(X0,Y0,Z0)), Points),
              (   T == none
              ->  Degrees = null
              ;   Degrees = T
              ),
              maplist(rounded, [X0,Y0,Z0], [X,Y,Z]) ),
            PointsOut).

%   rounded(Number, Rounded): to a millionth.

rounded(Number, Rounded) :-
    Rounded is round(Number*1.0e6)/1.0e6 + 0.0.
