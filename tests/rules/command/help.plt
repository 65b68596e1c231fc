:- encoding(utf8).
:- module(test_help, []).
:- use_module(library(plunit)).
:- use_module(rules(command/help)).
:- use_module(rules(command/usage), []).
:- use_module(rules(command/usage_print), []).
:- use_module(rules(topics), [topic_predicates/3]).
:- use_module(rules(sanggwan), []).
:- use_module(rules(message/messages), []).

% Text is what help(What) prints on standard output; Terms are its messages.
asked(What, Text, Terms) :-
    message_terms(with_output_to(string(Text), help(What)), Terms).

:- dynamic said/1.

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

message_terms(Goal, Terms) :-
    retractall(said(_)),
    setup_call_cleanup(
        asserta((user:message_hook(Term, help, _) :-
                     assertz(test_help:said(Term))), Hook),
        call_with_time_limit(30, Goal),
        erase(Hook)),
    findall(Term, said(Term), Terms).

begins(Text, Start) :-
    sub_string(Text, 0, _, _, Start),
    !.

holds(Text, Part) :-
    sub_string(Text, _, _, _, Part),
    !.

% The documentation is a file that the build made; the .so alone has none.
documentation :-
    sg_help:documented(_, _, _, _, _, _),
    !.

:- begin_tests(help).

test(relation, [ forall(member(What, [v, v/5, 'v/5', "v", "v/5",
                                      v(_, _, _, _, _)])),
                 Terms == [] ]) :-
    asked(What, Text, Terms),
    begins(Text, "v(S, V, X, Y, Z): a vertex"),
    holds(Text, "model units").
test(predicate, [ condition(documentation),
                  forall(member(What, [penetrate, penetrate/0, "penetrate"])),
                  Terms == [] ]) :-
    asked(What, Text, Terms),
    begins(Text, "penetrate is det.").
test(all_arities, condition(documentation)) :-
    asked(draw, Text, []),
    holds(Text, "draw(+File) is det."),
    holds(Text, "draw(+File, +Options) is det.").
test(one_arity) :-
    asked(v/4, "", [sanggwan(no_help(v/4, Names))]),
    memberchk(v, Names).
test(list) :-
    with_output_to(string(Text), help),
    holds(Text, "Start here:"),
    forall(topic_predicates(Topic, Title, _),
           ( holds(Text, Title), holds(Text, Topic) )),
    \+ holds(Text, "sg_").
test(unknown, Terms == [sanggwan(no_help(zzzz_foo, []))]) :-
    asked(zzzz_foo, "", Terms).
test(unknown_text, Terms == [sanggwan(no_help('no such thing', []))]) :-
    asked("no such thing", "", Terms).
test(unknown_variable_name) :-
    asked('Foo', "", [sanggwan(no_help('Foo', _))]).
test(odd, forall(member(What, [foo/bar, 1, 2.5, [], f(x)/1, a/b/c]))) :-
    asked(What, "", [sanggwan(no_help(What, _))]).
test(near, [ condition(documentation),
             forall(member(What, [penetrat, pentrate, penetrate/3])) ]) :-
    asked(What, "", [sanggwan(no_help(What, Names))]),
    memberchk(penetrate, Names).
test(library, Terms == [sanggwan(prolog_help(append/3, library(lists)))]) :-
    asked(append/3, "", Terms).
test(non_terminal, [condition(documentation), Terms == []]) :-
    asked(english//1, Text, Terms),
    begins(Text, "english(+Term)// is semidet.").
test(built_in, Terms == [sanggwan(prolog_help(atom_length/2, system))]) :-
    asked("atom_length", "", Terms).
test(several, PIs == [append/1, append/2, append/3]) :-
    asked(append, "", Terms),
    findall(PI, member(sanggwan(prolog_help(PI, _)), Terms), PIs).
test(ours_first, [condition(documentation), Terms == []]) :-
    asked(help, Text, Terms),
    holds(Text, "help(+What) is det.").
test(variable, throws(error(instantiation_error, _))) :-
    help(_).

test(message, Lines == ['~q is Prolog\'s own (~q): see'-[(=..)/2, system],
                        nl, Page-['%3D../2']]) :-
    phrase(sg_messages:english(sanggwan(prolog_help((=..)/2, system))), Lines),
    last(Lines, Page-_).

% Where verbs say different things of an option in English, they do in Korean.
test(korean_of_verbs, Alike == []) :-
    findall(Name-Ko-En,
            ( sg_usage:verb_option(Verb, option(Name,_,_,_,En)),
              sg_usage_print:help_ko(Verb, Name, Ko)
            ),
            Helps0),
    sort(Helps0, Helps),
    findall(Name,
            ( member(Name-Ko-A, Helps), member(Name-Ko-B, Helps), A @< B ),
            Alike).

:- end_tests(help).
