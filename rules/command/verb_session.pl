:- module(sg_verb_session,
          [ serve_run/3                 % :Run, :Explain, -Status
          ]).
:- use_module(arguments, [parsed_arguments/4]).
:- use_module('../drawing/pen_plan', [drawing_pens/3]).
:- use_module(help, [help/1, callable_summary/3]).
:- use_module('../kernel', [image_png/3]).
:- use_module('../shading/shaded_picture', [picture_image/3]).
:- use_module('../studio/job', [printed_octets/3]).
:- use_module('../studio/session', [session/4]).
:- use_module(usage, [verb_options/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(verbs, [sheet_drawing_there/3]).
:- use_module(verbs_render, [wanted_scene/4]).
:- use_module(verbs_unfold, [world_patterns/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(option), [option/2]).
/** <module> The verb serve: what a session has from the command line.
*/

:- meta_predicate serve_run(2, 2, -).

%!  serve_run(:Run, :Explain, -Status) is det.
%
%   Serve standard input and output; call(Run, Arguments, S) does a verb, and
%   call(Explain, Arguments, S) explains an item of the current world.

serve_run(Run, Explain, Status) :-
    session(Run,
            makers(sg_verb_session:patterns, sg_verb_session:sheet,
                   sg_verb_session:shaded),
            help(sg_verb_session:helped, sg_verb_session:callable_word,
                 Explain),
            Status).

:- public patterns/3, sheet/4, shaded/2, helped/1, callable_word/3.

%   patterns(Words, Ds, Options): of the current world, as `unfold` with Words.

patterns(Words, Ds, DrawingOptions) :-
    words_options(unfold, Words, Options),
    world_patterns(Options, Ds, DrawingOptions).

%   sheet(Words, File, Drawing, Pens): of the current world, as `draw --sheet`
%   with Words; File is the name of the model. Pens as of drawing_pens/3.

sheet(Words, File, Drawing, Pens) :-
    words_options(draw, Words, Options),
    sheet_drawing_there(Options, File, Drawn),
    option(drawing(Drawing), Drawn),
    drawing_pens(Drawing, [], Pens).

%   shaded(Words, Octets): a picture of the current world in PNG, as `render`
%   with Words.

shaded(Words, Octets) :-
    words_options(render, Words, Options),
    wanted_scene(Options, true, Scene, Wanted),
    picture_image(Scene, Wanted, Image),
    printed_octets(binary, sg_verb_session:image_out(Image), Octets).

:- public image_out/2.

image_out(Image, Out) :-
    image_png(Image, 0, Out).

%   words_options(Verb, Words, Options): Words are options of Verb alone.

words_options(Verb, Words, Options) :-
    maplist(word_atom, Words, Arguments),
    verb_options(Verb, Specs),
    parsed_arguments(Specs, Arguments, Files, Options),
    (   Files = [File|_]
    ->  usage_error(no_files_taken(Verb, File))
    ;   true
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
