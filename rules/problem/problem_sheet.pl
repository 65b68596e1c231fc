:- module(sg_problem_sheet,
          [ problem_sheets/3            % +File, +Folder, +Options
          ]).
:- use_module('../drawing/drawing', [write_drawing/2]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../language', [with_result_language/2]).
:- use_module('../output', [when_written/1, writing/3]).
:- use_module('../pattern/pattern_file', [write_pattern/4]).
:- use_module(problem_file, [problems_read/3]).
:- use_module(problem_key, [pattern_key/2, problem_key/8]).
:- use_module(problem_pattern, [with_patterns/4]).
:- use_module(problem_variant,
              [ dealt/3, pattern_marks/3, variant_answer/4,
                variant_answered/3, variant_number/3, variant_question/2,
                with_variant/5 ]).
:- use_module(library(filesex), [directory_file_path/3, make_directory_path/1]).
:- use_module(library(lists), [append/3, member/2, nth0/3, nth1/3]).
:- use_module(library(option), [option/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).
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
              with_variant(Base, Problem, N, Options,
                           sg_problem_sheet:variant_made(Folder, Options)),
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
                                dealt(I, Problem, N),
                                variant_number(Problem, N, Number) ),
                      Numbers),
              atomic_list_concat([Field|Numbers], ',', Line) ),
            Lines).

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

:- public variant_made/3.

variant_made(Folder, Options, Variant) :-
    Variant = variant(Number,Settings,Items,asked(_,Count,_,_),
                      found(Points,Planes,Chains),_),
    option(format(Format), Options, svg),
    variant_question(Variant, Question),
    drawn(Question, Folder, Number, question, Format),
    findall(Pattern-Marks,
            ( member(ask(develop(S)), Items),
              developed(S, Count, Options, Folder, Number, Pattern, Marks) ),
            Developed),
    pairs_keys_values(Developed, Patterns, Marked),
    variant_answered(Variant, Measures, Answers),
    variant_answer(Variant, Marked, Answers, Answer),
    drawn(Answer, Folder, Number, answer, Format),
    problem_key(Number, Settings, Items, Chains, Points-Planes, Measures,
                Patterns, Key),
    file_of(Folder, Number, key, json, KeyFile),
    writing(KeyFile, text, sg_problem_sheet:key_written(Key)).

key_written(Key, Stream) :-
    json_laid_out(Stream, Key, 78),
    nl(Stream).

file_of(Folder, Number, What, Format, File) :-
    format(atom(Local), '~w-~w.~w', [Number,What,Format]),
    directory_file_path(Folder, Local, File).

drawn(Drawing, Folder, Number, What, Format) :-
    file_of(Folder, Number, What, Format, File),
    write_drawing(File, [drawing(Drawing),title(Number)]).


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
                    pattern_marks(S, Ds, Marks) )).
