:- module(sg_batch_junit,
          [ junit_written/3,            % :Results, +Counts, +Out
            error_words/2,              % +Dict, -Words
            marked_up/2                 % +Text, -Escaped
          ]).
:- use_module('../language', [language/1]).
:- use_module('../plain', [plain_text/2]).
:- use_module(library(lists), [append/3, member/2, sum_list/2]).
:- meta_predicate junit_written(2, +, +).
/** <module> A merged report as JUnit has it, for programs that show builds.
*/

%!  junit_written(:Results, +Counts, +Out) is det.
%
%   Write what call(Results, Dict, Head) gives, all of it, to the stream Out.
%   An answer that is no is a failure, all else that was not done an error.

junit_written(Results, Counts, Out) :-
    findall(N, member(_-N, Counts), Ns),
    sum_list(Ns, All),
    findall(1, ( call(Results, Dict, _), junit_failure(Dict, _) ), Ones),
    length(Ones, Failures),
    memberchk(done-Done, Counts),
    memberchk(cached-Cached, Counts),
    Errors is All-Done-Cached-Failures,
    format(Out, '<?xml version="1.0" encoding="UTF-8"?>~n', []),
    format(Out, '<testsuites tests="~d" failures="~d" errors="~d">~n',
           [All, Failures, Errors]),
    format(Out, '<testsuite name="sanggwan batch" tests="~d" failures="~d" \c
                 errors="~d">~n', [All, Failures, Errors]),
    forall(call(Results, Dict, Head), case_written(Out, Dict, Head)),
    format(Out, '</testsuite>~n</testsuites>~n', []).

junit_failure(Dict, 1) :-
    Dict.outcome == "failed",
    Dict.status == 1.

case_written(Out, Dict, head(Manifest, _)) :-
    marked_up(Dict.job, Name),
    marked_up(Manifest, Suite),
    format(Out, '<testcase classname="~w" name="~w" time="~3f">',
           [Suite, Name, Dict.seconds]),
    (   memberchk(Dict.outcome, ["done", "cached"])
    ->  true
    ;   (   junit_failure(Dict, _)
        ->  Tag = failure
        ;   Tag = error
        ),
        error_words(Dict, Words0),
        marked_up(Words0, Words),
        format(Out, '<~w type="~w" message="~w"/>', [Tag, Dict.outcome, Words])
    ),
    format(Out, '</testcase>~n', []).

%!  error_words(+Dict, -Words) is det.
%
%   Words say why the job failed whose line is Dict, in the user's language.

error_words(Dict, Words) :-
    language(Language),
    (   is_dict(Dict.error),
        get_dict(words, Dict.error, Both),
        get_dict(Language, Both, Words0)
    ->  Words = Words0
    ;   format(string(Words), '~w ~w', [Dict.outcome, Dict.status])
    ).

%!  marked_up(+Text, -Escaped) is det.
%
%   Escaped is Text as it stands in XML and HTML, with pictures of what is not
%   seen.

marked_up(Text0, Escaped) :-
    split_string(Text0, "\n", "", Lines),
    atomic_list_concat(Lines, ' ', Text1),
    plain_text(Text1, Text),
    string_codes(Text, Codes),
    escaped(Codes, Codes1),
    string_codes(Escaped, Codes1).

escaped([], []).
escaped([C|Cs], Escaped) :-
    (   entity(C, Entity)
    ->  string_codes(Entity, Codes),
        append(Codes, Rest, Escaped)
    ;   Escaped = [C|Rest]
    ),
    escaped(Cs, Rest).

entity(0'&, "&amp;").
entity(0'<, "&lt;").
entity(0'>, "&gt;").
entity(0'", "&quot;").
entity(0'', "&#39;").
