:- module(sg_verb_session,
          [ serve_run/3                 % :Run, :Explain, -Status
          ]).
:- use_module(arguments, [parsed_arguments/4]).
:- use_module(help, [help/1, callable_summary/3]).
:- use_module(usage, [verb_options/2]).
:- use_module('../studio/session', [session/4]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(verbs_unfold, [world_patterns/3]).
:- use_module(library(apply), [maplist/3]).
/** <module> The verb serve: what a session has from the command line.
*/

:- meta_predicate serve_run(2, 2, -).

%!  serve_run(:Run, :Explain, -Status) is det.
%
%   Serve standard input and output; call(Run, Arguments, S) does a verb, and
%   call(Explain, Arguments, S) explains an item of the current world.

serve_run(Run, Explain, Status) :-
    session(Run, sg_verb_session:patterns,
            help(sg_verb_session:helped, sg_verb_session:callable_word,
                 Explain),
            Status).

:- public patterns/3, helped/1, callable_word/3.

%   patterns(Words, Ds, Options): of the current world, as `unfold` with Words.

patterns(Words, Ds, DrawingOptions) :-
    maplist(word_atom, Words, Arguments),
    verb_options(unfold, Specs),
    parsed_arguments(Specs, Arguments, Files, Options),
    (   Files = [File|_]
    ->  usage_error(no_files_taken(unfold, File))
    ;   world_patterns(Options, Ds, DrawingOptions)
    ).

word_atom(Word, Atom) :-
    (   string(Word),
        \+ sub_string(Word, _, _, _, "\u0000")
    ->  atom_string(Atom, Word)
    ;   throw(error(request_error(bad_key(options, options)), _))
    ).

helped(Word) :-
    help(Word).

%   callable_word(Kind, Word, Doc): of each predicate that users may call.

callable_word("predicate", Word, Doc) :-
    callable_summary(Name, Arity, Doc0),
    format(string(Word), "~w/~w", [Name,Arity]),
    format(string(Doc), "~w", [Doc0]).
