:- module(sg_document_journal,
          [ model_text/5,               % +File, -Text, -Steps, -Journal, +Head
            wanted_path/3,              % +Head, +File, -Path
            journal_opened/5,           % +Where, +File, +Digest, +Steps,
                                        % -Journal
            damaged_path/2,             % +Path, -Kept
            journal_path/2,             % +Journal, -Path
            path_saved/4,               % +File0, +File, +Path0, -Path
            first_steps/2,              % +Rules, -Steps
            save_step/3                 % +Rules, +Digest, -Step
          ]).
:- use_module('../environment', [state_folder/1]).
:- use_module('../model/model', [load_model/1]).
:- use_module(document_content, [content/3, text_digest/2]).
:- use_module(document_step, [known_step/2, step_rules/2]).
:- use_module(journal,
              [journal_begun/6, journal_steps/3, journal_whole/3]).
:- use_module(request, [of_owner/2, request_error/1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(filesex), [copy_file/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(readutil), [read_file_to_string/3]).
/** <module> Where the journal of a document is, and what stands in it.
*/

%!  model_text(+File, -Text, -Steps, -Journal, +Head:dict) is det.
%
%   Text is what File holds, or what it held when its journal began, if Head
%   wants that, or if there is no such file any more, but were changes; Steps
%   are the changes since that the journal has. Journal is file(Path) or `none`,
%   as Head says. Steps of no form that is known are damaged_step/1.
%
%   @error request_error(What), model_error(What)

model_text(File, Text, Steps, Journal, Head) :-
    wanted_path(Head, File, Path),
    (   Path \== none,
        journal_counts(Head, File, Path, Text, Steps0)
    ->  Journal = file(Path),
        maplist(known_step, Steps0, Steps),
        rules_allowed(Steps, Head)
    ;   catch(read_file_to_string(File, Text, [encoding(utf8)]), error(_, _),
              load_model(File)),        % says what is wrong
        text_steps(Path, Text, Head, Steps, Journal)
    ).

%   journal_counts(Head, File, Path, Text, Steps) is semidet: what the journal
%   Path has counts, whatever File holds.

journal_counts(Head, File, Path, Text, Steps) :-
    (   get_dict(replay, Head, Replay)
    ->  Replay == "journal",
        journal_whole(Path, Text, Steps)
    ;   \+ exists_file(File),
        journal_whole(Path, Text, Steps),
        Steps = [_|_]
    ).

%   text_steps(Path, Text, Head, Steps, Journal): the steps from Text on that
%   the journal Path has.

text_steps(Path, Text, Head, Steps, Journal) :-
    text_digest(Text, Digest0),
    atom_string(Digest0, Digest),
    (   Path == none
    ->  Steps = [],
        Journal = none
    ;   Journal = file(Path),
        (   \+ exists_file(Path)
        ->  Steps = []
        ;   journal_steps(Path, Digest, Steps0)
        ->  (   get_dict(replay, Head, false)
            ->  Steps = []
            ;   Steps0 == other
            ->  request_error(journal_of_another(Path))
            ;   maplist(known_step, Steps0, Steps),
                rules_allowed(Steps, Head)
            )
        ;   request_error(no_journal(Path))
        )
    ).

%   rules_allowed(Steps, Head): rules run code, those of a journal too.

rules_allowed(Steps, Head) :-
    (   member(Step, Steps),
        step_rules(Step, Rules),
        Rules \== ""
    ->  of_owner(Head, journal)
    ;   true
    ).

%!  wanted_path(+Head:dict, +File, -Path) is det.
%
%   Path is the journal of File that Head wants, or `none`.
%
%   @error request_error(bad_key(journal, journal))

wanted_path(Head, File, Path) :-
    (   get_dict(journal, Head, Wanted)
    ->  (   Wanted == true
        ->  usual_path(File, Path)
        ;   string(Wanted),
            Wanted \== ""
        ->  atom_string(Path, Wanted)
        ;   request_error(bad_key(journal, journal))
        )
    ;   Path = none
    ).

%   usual_path(File, Path): one for each file.

usual_path(File, Path) :-
    state_folder(State),
    absolute_file_name(File, Absolute),
    text_digest(Absolute, Digest),
    sub_atom(Digest, 0, 16, _, Short),
    file_base_name(File, Base),
    format(atom(Path), "~w/sanggwan/~w-~w.journal", [State, Base, Short]).

%!  journal_opened(+Where, +File, +Digest, +Steps, -Journal) is det.
%
%   Journal is that of File, whose text has this Digest, written anew with these
%   Steps. Where is file(Path), damaged(Path, Kept), whose old journal is kept,
%   or `none`, which has no journal.

journal_opened(none, _, _, _, none).
journal_opened(damaged(Path, Kept), File, Digest, Steps, Journal) :-
    copy_file(Path, Kept),
    journal_opened(file(Path), File, Digest, Steps, Journal).
journal_opened(file(Path), File, Digest, Steps, Journal) :-
    content(Digest, Text, ""),
    journal_begun(Path, File, Digest, Text, Steps, Journal).

%!  damaged_path(+Path, -Kept) is det.
%
%   Kept is where the damaged journal in Path is kept: where nothing is yet.

damaged_path(Path, Kept) :-
    between(1, inf, N),
    format(atom(Kept), "~w.damaged-~d", [Path, N]),
    \+ access_file(Kept, exist),
    !.

%!  path_saved(+File0, +File, +Path0, -Path) is det.
%
%   Path is where the journal in Path0 goes when File0 is saved as File: one in
%   the usual place goes with the name of the file.

path_saved(File0, File, Path0, Path) :-
    usual_path(File0, Usual),
    (   Usual == Path0
    ->  usual_path(File, Path)
    ;   Path = Path0
    ).

%!  first_steps(+Rules, -Steps:list(dict)) is det.
%
%   Steps begin a journal: a file of a model has no rules, its journal has.

first_steps("", []) :-
    !.
first_steps(Rules, [_{do:"rules", rules:Rules}]).

%!  save_step(+Rules, +Digest, -Step:dict) is det.
%
%   Step says that the file is about to hold the text with this Digest.

save_step(Rules, Digest, Step) :-
    Step0 = _{do:"save", digest:Digest},
    (   Rules == ""
    ->  Step = Step0
    ;   Step = Step0.put(rules, Rules)
    ).

%!  journal_path(+Journal, -Path) is det.

journal_path(Journal, Path) :-
    stream_property(Journal, file_name(New)),
    (   atom_concat(Path0, '.new', New)
    ->  Path = Path0
    ;   Path = New
    ).
