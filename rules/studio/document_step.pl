:- module(sg_document_step,
          [ change_step/6,              % +Request, +Head, +Body, +Text, -Step,
                                        % -More
            stepped/3,                  % +Step, +State0, -State
            kept_step/3,                % +Step, +Key, -Kept
            replayed/4,                 % +Steps, +State0, -State, -Done
            known_step/2,               % +Step0, -Step
            checkpoint/3,               % +State, +Changes, -Step
            steps_changes/2,            % +Steps, -Changes
            step_rules/2                % +Step, -Rules
          ]).
:- use_module(document_content, [content/3, content_key/3, contents_swept/1]).
:- use_module(protocol, [octets_text/2]).
:- use_module(journal, [damaged_step/1]).
:- use_module(query, [read_goal/3]).
:- use_module(request, [request_error/1]).
:- use_module(text_edit,
              [fact_place/6, number_place/5, text_change/5, text_replaced/5]).
:- use_module(library(apply), [foldl/4, foldl/5]).
:- use_module(library(lists), [append/3, member/2, reverse/2]).
/** <module> Steps: how a document becomes another one, and back.

A step is a dict, a line of the journal. A state of a document is state(Now,
Past, Future), keys of contents (document_content.pl), the nearest first; each
step leads from one to another, and needs nothing but what it says itself.
*/

%   most_steps(N): kept to go back to.

most_steps(1000).

%!  change_step(+Request, +Head:dict, +Body, +Text, -Step:dict,
%!              -More:dict) is det.
%
%   Step is what the Request `undo`, `redo`, `text`, `edit`, `cut` or `question`
%   asks of a document with this Text; More is what its reply has besides.
%
%   @error request_error(What)

change_step(undo, _, _, _, _{do:"undo"}, _{}).
change_step(redo, _, _, _, _{do:"redo"}, _{}).
change_step(text, _, Body, _, _{do:"text", text:Text}, _{}) :-
    octets_text(Body, Text).
change_step(edit, Head, _, Text, _{do:"edit", from:From, to:To, with:Value},
            _{was:Number}) :-
    (   get_dict(set, Head, Set),
        is_dict(Set),
        get_dict(value, Set, Value),
        number(Value),
        edited(Set, Which)
    ->  number_place(Text, Which, From, To, Number)
    ;   request_error(bad_key(set, set))
    ).
change_step(cut, Head, _, Text, _{do:"edit", from:From, to:To, with:Fact},
            _{wish:Wish}) :-
    (   get_dict(segment, Head, S),
        integer(S),
        get_dict(edge, Head, Edge),
        ( integer(Edge) ; string(Edge) ),
        wished(Head, Name)
    ->  fact_place(Text, wish(S, Name, Edge), From, To, Fact, Wish)
    ;   request_error(bad_key(edge, edge))
    ).
change_step(question, Head, _, Text, _{do:"edit", from:From, to:To, with:Fact},
            _{question:Question}) :-
    question_wanted(Head, Name, Goal),
    fact_place(Text, question(Name, Goal), From, To, Fact, Question).

question_wanted(Head, Name, Goal) :-
    (   get_dict(name, Head, Name0),
        string(Name0),
        normalize_space(string(Name), Name0),
        Name \== ""
    ->  true
    ;   request_error(bad_key(name, question))
    ),
    (   get_dict(goal, Head, Goal0),
        ( string(Goal0) ; Goal0 == null )
    ->  true
    ;   request_error(bad_key(goal, question_goal))
    ),
    (   Goal0 == null
    ->  Goal = none
    ;   Goal = Goal0,
        read_goal(Goal, _, _)
    ).

wished(Head, Name) :-
    (   get_dict(keep, Head, Keep)
    ->  (   Keep == true
        ->  Name = keep
        ;   Keep == false
        ->  Name = cut
        ;   Keep == null,
            Name = none
        )
    ;   Name = cut
    ).

edited(Set, param(Name)) :-
    get_dict(param, Set, Text),
    !,
    string(Text),
    atom_string(Name, Text).
edited(Set, segment(S, Path)) :-
    get_dict(segment, Set, S),
    integer(S),
    get_dict(path, Set, Path),
    is_list(Path),
    forall(member(I, Path), ( integer(I), I > 0 )).

%!  stepped(+Step:dict, +State0, -State) is det.
%
%   @error request_error(nothing_to(Request)): nothing can be taken back, or be
%   done again

stepped(Step, State0, State) :-
    atom_string(Do, Step.do),
    stepped(Do, Step, State0, State).

stepped(undo, Step, state(Now, Past, Future), State) :-
    (   Past = [Before|Rest]
    ->  State = state(Before, Rest, [Now|Future])
    ;   step_content(Step, Before)
    ->  State = state(Before, [], [Now|Future])
    ;   request_error(nothing_to(undo))
    ).
stepped(redo, Step, state(Now, Past, Future), State) :-
    (   Future = [After|Rest]
    ->  State = state(After, [Now|Past], Rest)
    ;   step_content(Step, After)
    ->  State = state(After, [Now|Past], [])
    ;   request_error(nothing_to(redo))
    ).
stepped(text, Step, State0, State) :-
    State0 = state(Now, _, _),
    content(Now, _, Rules),
    content_key(Step.text, Rules, Key),
    gone_on(Key, State0, State).
stepped(edit, Step, State0, State) :-
    State0 = state(Now, _, _),
    content(Now, Text, Rules),
    text_replaced(Text, Step.from, Step.to, Step.with, New),
    content_key(New, Rules, Key),
    gone_on(Key, State0, State).
stepped(checkpoint, Step, _, state(Now, Past, Future)) :-
    content_key(Step.text, Step.rules, First),
    foldl(next_content, Step.steps, Keys, First, _),
    length(Old, Step.past),
    append(Old, [Now|Future], [First|Keys]),
    reverse(Old, Past).
stepped(rules, Step, State0, State) :-
    State0 = state(Now, _, _),
    content(Now, Text, _),
    content_key(Text, Step.rules, Key),
    gone_on(Key, State0, State).

gone_on(Key, state(Now, Past, _), state(Key, Steps, [])) :-
    most_steps(Most),
    (   length(Start, Most),
        append(Start, [_|_], [Now|Past])
    ->  Steps = Start
    ;   Steps = [Now|Past]
    ).

%   step_content(Step, Key) is semidet: Step says what it led to.

step_content(Step, Key) :-
    get_dict(text, Step, Text),
    (   get_dict(rules, Step, Rules)
    ->  true
    ;   Rules = ""
    ),
    content_key(Text, Rules, Key).

%!  kept_step(+Step:dict, +Key, -Kept:dict) is det.
%
%   Kept is the Step that led to Key as the journal keeps it. A journal begins
%   when the file is saved; what can be taken back may be older.

kept_step(Step, Key, Kept) :-
    (   memberchk(Step.do, ["undo","redo"])
    ->  content(Key, Text, Rules),
        (   Rules == ""
        ->  Kept = Step.put(text, Text)
        ;   Kept = Step.put(_{text:Text, rules:Rules})
        )
    ;   Kept = Step
    ).

%!  known_step(+Step0:dict, -Step:dict) is det.
%
%   Step is Step0, a line of a journal, or damaged_step/1 if that says no
%   change: the file may be anybody's.

known_step(Step0, Step) :-
    (   get_dict(do, Step0, Do),
        step_form(Do, Step0)
    ->  Step = Step0
    ;   damaged_step(Step)
    ).

step_form("undo", Step) :-
    texts_or_none([text,rules], Step).
step_form("redo", Step) :-
    texts_or_none([text,rules], Step).
step_form("text", Step) :-
    texts([text], Step).
step_form("rules", Step) :-
    texts([rules], Step).
step_form("edit", Step) :-
    change_form(Step).
step_form("checkpoint", Step) :-
    texts([text,rules], Step),
    counts([changes,past], Step),
    get_dict(steps, Step, Steps),
    is_list(Steps),
    forall(member(Change, Steps),
           ( is_dict(Change),
             change_form(Change),
             texts_or_none([rules], Change) )),
    length(Steps, Most),
    Step.past =< Most.

change_form(Change) :-
    counts([from,to], Change),
    Change.from =< Change.to,
    get_dict(with, Change, With),
    ( string(With) ; number(With) ),
    !.

counts(Keys, Dict) :-
    forall(member(Key, Keys),
           ( get_dict(Key, Dict, N), integer(N), N >= 0 )).

texts(Keys, Dict) :-
    forall(member(Key, Keys),
           ( get_dict(Key, Dict, Text), string(Text) )).

texts_or_none(Keys, Dict) :-
    forall(( member(Key, Keys), get_dict(Key, Dict, Text) ),
           string(Text)).

%!  replayed(+Steps:list(dict), +State0, -State, -Done:list(dict)) is det.
%
%   State is where Done leads, the Steps before the first one that cannot be
%   done.

replayed([Step|Steps], State0, State, Done) :-
    catch(stepped(Step, State0, State1), error(request_error(_), _), fail),
    !,
    contents_swept(State1),
    Done = [Step|Done1],
    replayed(Steps, State1, State, Done1).
replayed(_, State, State, []).

%!  checkpoint(+State, +Changes, -Step:dict) is det.
%
%   Step leads to State from any other one, and stands for so many Changes. The
%   contents are told one after the other, the oldest first, each by what is
%   another one in it.

checkpoint(state(Now, Past, Future), Changes,
           _{ do:"checkpoint", changes:Changes, text:Text, rules:Rules,
              past:Back, steps:Steps }) :-
    length(Past, Back),
    reverse(Past, Old),
    append(Old, [Now|Future], [First|Keys]),
    content(First, Text, Rules),
    foldl(content_change, Keys, Steps, First, _).

content_change(Key, Change, Key0, Key) :-
    content(Key0, Text0, Rules0),
    content(Key, Text, Rules),
    text_change(Text0, Text, From, To, With),
    Change0 = _{from:From, to:To, with:With},
    (   Rules == Rules0
    ->  Change = Change0
    ;   Change = Change0.put(rules, Rules)
    ).

next_content(Change, Key, Key0, Key) :-
    content(Key0, Text0, Rules0),
    text_replaced(Text0, Change.from, Change.to, Change.with, Text),
    (   get_dict(rules, Change, Rules)
    ->  true
    ;   Rules = Rules0
    ),
    content_key(Text, Rules, Key).

%!  steps_changes(+Steps:list(dict), -Changes) is det.
%
%   So many changes are told by Steps.

steps_changes(Steps, Changes) :-
    foldl(step_counted, Steps, 0, Changes).

step_counted(Step, N0, N) :-
    (   get_dict(do, Step, "checkpoint")
    ->  get_dict(changes, Step, Changes)
    ;   Changes = 1
    ),
    N is N0+Changes.

%!  step_rules(+Step:dict, -Rules) is nondet.
%
%   Rules is a text of rules that a document has by Step.

step_rules(Step, Rules) :-
    get_dict(rules, Step, Rules).
step_rules(Step, Rules) :-
    get_dict(steps, Step, Steps),
    member(Within, Steps),
    get_dict(rules, Within, Rules).
