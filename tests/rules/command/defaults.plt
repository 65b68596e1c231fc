/* What an option is if it is not given: as if its default had been; and another
   value makes something else. */
% covers: picture_options, picture_marks, verbs_render, shading_words, lines_out
% covers: dot_drawing, shaded_picture, shading_scan, explain_pixel
% covers: format_options
:- module(test_defaults, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(command/cli), [sanggwan/2]).

model('segment(1, solid, box(size(3,2,1))).
segment(2, solid, at([translate(0.4,0.3,0.7)], box(size(1,1,2)))).
segment(3, solid, union([1,2])).
segment(4, surface, at([rotate(x,40),translate(0,0,1)], rectangle(size(4,5)))).
look(1, colour(red)). look(2, colour(blue)).
').

%   made(Words, Octets): what a command writes to the file after its last word,
%   `-o`, or else prints.

made(Words, Octets) :-
    tmp_file(defaults, Folder),
    make_directory(Folder),
    directory_file_path(Folder, 'm.pl', Model),
    setup_call_cleanup(
        ( model(Text),
          setup_call_cleanup(open(Model, write, Out), write(Out, Text),
                             close(Out)) ),
        done(Words, Folder, Model, Octets),
        delete_directory_and_contents(Folder)).

done([Verb|Words0], Folder, Model, Octets) :-
    (   append(Words, [to(Name)], Words0)
    ->  directory_file_path(Folder, Name, File),
        append([Verb,'-q',Model|Words], ['-o',File], Arguments),
        sanggwan(Arguments, 0),
        read_file_to_codes(File, Octets, [type(binary)])
    ;   append([Verb,'-q',Model], Words0, Arguments),
        with_output_to(codes(Octets), sanggwan(Arguments, 0))
    ),
    !.

%   default(Words, Option, Value, Other)

default([render,'--size','60x42',to('a.png')], Option, Value, Other) :-
    member(Option-Value-Other,
           [ '--smooth'-'4'-'2', '--background'-white-black,
             '--shade'-lambert-flat, '--colours'-root-leaf,
             '--up'-z-y, '--projection'-parallel-central ]).
default([render,'--smooth','1',to('a.ppm')], '--size', '1260x888', '630x444').
default([explain,'pixel(30,20)','--size','60x42'], Option, Value, Other) :-
    member(Option-Value-Other,
           [ '--smooth'-'4'-'2', '--shade'-lambert-flat, '--up'-z-y ]).
default([draw,'--view','20,70',to('a.svg')], Option, Value, Other) :-
    member(Option-Value-Other,
           [ '--hidden'-dashed-removed, '--lines'-feature-penetration,
             '--dashes'-auto-geometry, '--projection'-parallel-central,
             '--up'-z-y, '--size'-'210x148'-'200x148' ]).
default([draw,'--view','20,70','--shade',lambert,to('a.svg')], '--dpi', '203.2',
        '100').
default([draw,to('a.png')], Option, Value, Other) :-
    member(Option-Value-Other,
           [ '--png'-smooth-dots, '--hidden'-dashed-removed ]).
default([draw,'--png',dots,to('a.png')], Option, Value, Other) :-
    member(Option-Value-Other, [ '--size'-'640x400'-'320x200' ]).
default([draw,to('a.hpgl')], '--dashes', auto, type).
default([draw,'--sheet','A4',to('a.svg')], Option, Value, Other) :-
    member(Option-Value-Other,
           [ '--angle'-third-first, '--unit'-mm-cm, '--language'-en-ko,
             '--views'-'front,top,right,isometric'-front, '--up'-z-y ]).
default([draw,'--angle',third,to('a.svg')], '--sheet', 'A3', 'A2').

with([Verb|Words], Option, Value, [Verb,Option,Value|Words]) :-
    Verb \== explain,
    !.
with([Verb,Item|Words], Option, Value, [Verb,Item,Option,Value|Words]).

:- begin_tests(defaults).

test(default, [ forall(default(Words, Option, Value, Other)),
                true(Which == [same,another]) ]) :-
    made(Words, Plain),
    assertion(Plain \== []),
    findall(How,
            ( member(V, [Value,Other]),
              with(Words, Option, V, Said),
              made(Said, Octets),
              ( Octets == Plain -> How = same ; How = another ) ),
            Which).

:- end_tests(defaults).
