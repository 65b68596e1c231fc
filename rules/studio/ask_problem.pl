:- module(sg_ask_problem,
          [ problems_listed/2,          % +Head, -Reply
            problem_posed/3             % +Head, -Reply, -Octets
          ]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../problem/problem_check',
              [problem_checked/5, problem_fields/2]).
:- use_module('../problem/problem_file', [problems_read/3]).
:- use_module('../problem/problem_pattern', [with_patterns/4]).
:- use_module('../problem/problem_variant',
              [ dealt/3, pattern_marks/3, variant_answer/4, variant_number/3,
                variant_question/2, with_variant/5 ]).
:- use_module(port, [drawing_body/3]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [member/2, nth0/3]).
/** <module> Problems for a class, as a page shows them: questions, and whether
answers are right.

The question is the sheet that the verb `problems` makes (rules/problem). What
is right is computed from the model each time; a page hears no more of it than
whether what it sent is right, until it is, or until it asks to be shown.
*/

%!  problems_listed(+Head:dict, -Reply:dict) is det.
%
%   Reply has `problems`, a list of `problem`, its name, and how many `variants`
%   there are, of the file Head.file; and `pupils`, the names that it has.
%
%   @error model_error(What), request_error(What)

problems_listed(Head, _{problems:Listed, pupils:Names}) :-
    problem_file(Head, File),
    problems_read(File, Problems, Pupils),
    findall(_{problem:Name, variants:Count},
            ( member(problem(Name,_,_,Variants,_,_), Problems),
              length(Variants, Count) ),
            Listed),
    findall(Name, ( member(Pupil, Pupils), atom_string(Pupil, Name) ), Names).

problem_file(Head, File) :-
    (   get_dict(file, Head, Name),
        string(Name),
        Name \== ""
    ->  atom_string(File, Name)
    ;   request_error(bad_key(file, file))
    ).

%!  problem_posed(+Head:dict, -Reply:dict, -Octets) is det.
%
%   Octets are the strokes of the sheet of a problem, Reply says what is asked.
%   The variant is Head.number, or that of the pupil Head.pupil, by name, or
%   else that of who has Head.turn others before him. If Head has `answers`, a
%   list of texts, Reply has `checked`, and when all are right, or Head.show is
%   true, the sheet is the answer.
%
%   @error model_error(What), request_error(What)

problem_posed(Head, Reply, Octets) :-
    problem_file(Head, File),
    problems_read(File, Problems, Pupils),
    (   get_dict(problem, Head, Name0),
        string(Name0),
        atom_string(Name, Name0),
        Problem = problem(Name,_,_,_,_,_),
        memberchk(Problem, Problems)
    ->  true
    ;   findall(Known, member(problem(Known,_,_,_,_,_), Problems), All),
        request_error(bad_key(problem, one_of(All)))
    ),
    variant_wanted(Head, Pupils, Problem, N),
    language_wanted(Head, Language),
    file_directory_name(File, Base),
    objects_heard(
        with_variant(Base, Problem, N, [language(Language)],
                     sg_ask_problem:posed(Head, Reply0, Octets)),
        Objects),
    variant_number(Problem, N, Number),
    atom_string(Number, NumberText),
    Reply = Reply0.put(_{ problem:Name0, number:N, called:NumberText,
                          messages:Objects }).

variant_wanted(Head, Pupils, Problem, N) :-
    Problem = problem(_,_,_,Variants,_,_),
    length(Variants, Count),
    (   get_dict(number, Head, N)
    ->  (   integer(N),
            N >= 1,
            N =< Count
        ->  true
        ;   request_error(bad_key(number, variant(Count)))
        )
    ;   get_dict(pupil, Head, Name),
        nth0(I, Pupils, Pupil),
        atom_string(Pupil, Name)
    ->  dealt(I, Problem, N)
    ;   get_dict(turn, Head, Turn),
        integer(Turn),
        Turn >= 0
    ->  dealt(Turn, Problem, N)
    ;   N = 1
    ).

language_wanted(Head, Language) :-
    (   get_dict(lang, Head, Text)
    ->  (   memberchk(Text, ["en","ko"])
        ->  atom_string(Language, Text)
        ;   request_error(bad_key(lang, one_of(["en","ko"])))
        )
    ;   Language = en
    ).

:- public posed/4.

posed(Head, Reply, Octets, Variant) :-
    problem_fields(Variant, Fields),
    shown_wanted(Head, Show),
    (   given_answers(Head, Fields, Show, Given)
    ->  problem_checked(Variant, Given, Show, Checked, Answers),
        More = _{fields:Fields, checked:Checked},
        (   ( Show == true ; all_right(Checked) )
        ->  answer_sheet(Variant, Answers, Drawing),
            Sheet = "answer"
        ;   variant_question(Variant, Drawing),
            Sheet = "question"
        )
    ;   More = _{fields:Fields},
        variant_question(Variant, Drawing),
        Sheet = "question"
    ),
    drawing_body(Drawing, Body, Octets),
    Reply = Body.put(More).put(shows, Sheet).

all_right([One|More]) :-
    forall(member(Checked, [One|More]), Checked.right == true).

shown_wanted(Head, Show) :-
    (   get_dict(show, Head, Show)
    ->  (   memberchk(Show, [true,false])
        ->  true
        ;   request_error(bad_key(show, boolean))
        )
    ;   Show = false
    ).

%   given_answers(Head, Fields, Show, Given) is semidet: who asks to be shown
%   need not answer.

given_answers(Head, Fields, Show, Given) :-
    length(Fields, Count),
    (   get_dict(answers, Head, Given)
    ->  (   is_list(Given),
            maplist(string, Given),
            length(Given, Count)
        ->  true
        ;   request_error(bad_key(answers, answers(Count)))
        )
    ;   Show == true,
        findall("", member(_, Fields), Given)
    ).

answer_sheet(Variant, Answers, Drawing) :-
    Variant = variant(_,_,Items,asked(_,Count,_,_),_,_),
    findall(Marks,
            ( member(ask(develop(S)), Items),
              with_patterns(S, [generators(Count)], Ds,
                            pattern_marks(S, Ds, Marks)) ),
            Marked),
    variant_answer(Variant, Marked, Answers, Drawing).
