/* Reports as JUnit has them: what was answered no is a failure, what was not
   done for another reason an error, and the head counts both. */
:- module(test_batch_junit, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(sgml)).
:- use_module(rules('batch/batch_junit')).

result(1, "done", 0).
result(2, "cached", 0).
result(3, "failed", 1).
result(4, "failed", 1).
result(5, "failed", 3).
result(6, "timeout", -1).
result(7, "killed", -1).

case(Dict, head('a<b.pl', '.')) :-
    result(N, Outcome, Status),
    format(string(Job), "hole(~d)", [N]),
    Dict = _{ job:Job, outcome:Outcome, status:Status, seconds:0.5,
              error:null }.

document(Suite) :-
    findall(O, result(_, O, _), Os),
    findall(K-N, ( member(K, [done,cached,failed,timeout,killed]),
                   atom_string(K, T),
                   findall(1, member(T, Os), Ones),
                   length(Ones, N) ),
            Counts),
    with_output_to(string(Text),
                   ( current_output(Out),
                     junit_written(test_batch_junit:case, Counts, Out) )),
    setup_call_cleanup(open_string(Text, In),
                       load_structure(stream(In), Document, [dialect(xml)]),
                       close(In)),
    memberchk(element(testsuites, _, Below), Document),
    memberchk(element(testsuite, Head, Cases), Below),
    Suite = suite(Head, Cases).

%   faults(Tag, Suite, Names): the jobs that have such an element.

faults(Tag, suite(_, Cases), Names) :-
    findall(Name, ( member(element(testcase, As, In), Cases),
                    memberchk(element(Tag, _, _), In),
                    memberchk(name=Name, As) ),
            Names).

:- begin_tests(batch_junit).

test(failures, Names == ['hole(3)','hole(4)']) :-
    document(Suite),
    faults(failure, Suite, Names).
test(errors, Names == ['hole(5)','hole(6)','hole(7)']) :-
    document(Suite),
    faults(error, Suite, Names).
test(counts, [Tests, Failures, Errors] == ['7', '2', '3']) :-
    document(suite(Head, Cases)),
    memberchk(tests=Tests, Head),
    memberchk(failures=Failures, Head),
    memberchk(errors=Errors, Head),
    findall(C, ( member(C, Cases), C = element(testcase, _, _) ), Found),
    length(Found, 7).
test(class_name_escaped, Class == 'a<b.pl') :-
    document(suite(_, Cases)),
    memberchk(element(testcase, As, _), Cases),
    memberchk(classname=Class, As).

:- end_tests(batch_junit).
