:- encoding(utf8).
:- use_module('../../../rules/problem/problem_check',
              [problem_checked/5, problem_fields/2]).
:- use_module('../../../rules/problem/problem_file', [problems_read/3]).
:- use_module('../../../rules/problem/problem_variant',
              [dealt/3, with_variant/5]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).

% covers: problem_explanation, problem_variant

collection('facts/problems/collection.pl', 'facts/problems').

problem_named(Name, Base, Problem) :-
    collection(File, Base),
    problems_read(File, Problems, _),
    Problem = problem(Name,_,_,_,_,_),
    memberchk(Problem, Problems).

%   checked(Name, N, Given, Show, Checked): of the collection.

checked(Name, N, Given, Show, Checked) :-
    problem_named(Name, Base, Problem),
    with_variant(Base, Problem, N, [],
                 user:checked_there(Given, Show, Checked)).

checked_there(Given, Show, Checked, Variant) :-
    problem_checked(Variant, Given, Show, Checked, _).

said(Name, Given, Said) :-
    checked(Name, 1, Given, false, Checked),
    findall(S, ( member(One, Checked), S = One.said ), Said).

:- begin_tests(problem_check).

test(fields, Units == [null,"mm"]) :-
    problem_named(fig12, Base, Problem),
    with_variant(Base, Problem, 1, [], user:fields_there(Fields)),
    findall(Unit, ( member(Field, Fields), Unit = Field.unit ), Units),
    forall(member(Field, Fields),
           ( Field.words.en \== "", Field.words.ko \== Field.words.en )).

% What the key says is right, in problems of each kind.

test(true, Wrong == []) :-
    collection(File, Base),
    problems_read(File, Problems, _),
    findall(Name-Checked,
            ( member(Problem, Problems),
              Problem = problem(Name,_,_,_,_,_),
              memberchk(Name, [fig10,fig11,fig12,fig14,dev12]),
              with_variant(Base, Problem, 2, [], user:shown_there(Texts)),
              with_variant(Base, Problem, 2, [],
                           user:checked_there(Texts, false, Checked)),
              \+ forall(member(One, Checked), One.said == "right") ),
            Wrong).

test(more_or_less, Saids == [["less","less"],["more","more"],
                             ["none","no_number"],["no_number","less"]]) :-
    maplist(said(fig12),
            [["0","1"], ["99","99999"], [" ","three"], ["1.2.3","-4"]],
            Saids).

test(as_written, Numbers == [right,right,right,right,wrong,wrong,wrong]) :-
    checked(fig12, 1, ["",""], true, [Loops,_]),
    string_concat(Loops.value, "", Count),
    findall(Is,
            ( member(Form, ["~s"," ~s ","~s,0","~s.00 lines","~s 1","0x~s",
                            "1e~s"]),
              format(string(Given), Form, [Count]),
              checked(fig12, 1, [Given,""], false, [One,_]),
              ( One.right == true -> Is = right ; Is = wrong ) ),
            Numbers).

test(nothing_given_away, [Value-Why == null-null]) :-
    checked(fig12, 1, ["77","1"], false, [One,_]),
    Value = One.value,
    Why = One.why.

test(not_as_many, throws(error(system_error(problem(fig12,1)),_))) :-
    checked(fig12, 1, ["1"], false, _).

% An explanation has the numbers it speaks of: of an edge, the root of the sum
% of squares is the answer.

test(edge, true(abs(Root-Answer) < 0.05)) :-
    checked(fig10, 1, ["",""], true, [_,One]),
    number_in(One.value, Answer),
    split_string(One.why.en, "√()²+= ", "√()²+= ", Words),
    findall(N, ( member(Word, Words), Word \== "",
                 catch(number_string(N, Word), _, fail) ),
            Numbers),
    last_three(Numbers, A, B, C),
    Root is sqrt(A*A + B*B + C*C).

test(dealt, Ns == [1,2,3,4,1]) :-
    problem_named(fig12, _, Problem),
    findall(N, ( member(I, [0,1,2,3,4]), dealt(I, Problem, N) ), Ns).

:- end_tests(problem_check).

fields_there(Fields, Variant) :-
    problem_fields(Variant, Fields).

shown_there(Texts, Variant) :-
    problem_fields(Variant, Fields),
    findall("", member(_, Fields), Empty),
    problem_checked(Variant, Empty, true, Checked, _),
    findall(Text,
            ( member(One, Checked),
              Text = One.value,
              One.why.en \== One.value ),
            Texts).

number_in(Text, Number) :-
    split_string(Text, " ", " °", [First|_]),
    number_string(Number, First).

last_three(Numbers, A, B, C) :-
    once(append(_, [A,B,C,_], Numbers)).
